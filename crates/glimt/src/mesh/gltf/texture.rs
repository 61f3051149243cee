//! Host file: the textures of a glTF file: their images, and where materials look them up.

use super::Reader;
use crate::error::{Error, Result};
use crate::memory;
use ::gltf::texture::{Info, WrappingMode};
use glam::{Affine2, UVec2, Vec2};
use glimt_render_gpu::prepare::scene::{Texture, TextureRef, Wrap};
use image::{ImageError, ImageReader, Limits};
use serde_json::Value;
use std::io::Cursor;
use std::path::{Path, PathBuf};

/// Most texels of a texture along each axis.
const MOST_TEXELS: u32 = 16384;

/// A material's use of a texture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Use {
    /// Index of the texture.
    texture: usize,
    /// The set of texture coordinates.
    pub(super) set: u32,
    transform: Affine2,
}

impl Use {
    pub(super) fn of(info: &Info<'_>) -> Self {
        let extension = info.extension_value("KHR_texture_transform");
        Self::new(info.texture().index(), info.tex_coord(), extension)
    }

    pub(super) fn of_normals(info: &::gltf::material::NormalTexture<'_>) -> Self {
        let extension = info.extension_value("KHR_texture_transform");
        Self::new(info.texture().index(), info.tex_coord(), extension)
    }

    fn new(texture: usize, set: u32, extension: Option<&Value>) -> Self {
        let other = extension.and_then(|e| e["texCoord"].as_u64());
        Self {
            texture,
            set: other.and_then(|set| set.try_into().ok()).unwrap_or(set),
            transform: extension.map_or(Affine2::IDENTITY, transform),
        }
    }
}

/// `KHR_texture_transform`: scaled, turned, moved. It turns counter-clockwise in the image, whose v grows downwards.
fn transform(extension: &Value) -> Affine2 {
    let number = |value: &Value| value.as_f64().map(|number| number as f32);
    let pair = |key: &str, default: f32| {
        let axis = |i: usize| number(&extension[key][i]).unwrap_or(default);
        Vec2::new(axis(0), axis(1))
    };
    let angle = -number(&extension["rotation"]).unwrap_or(0.0);
    Affine2::from_scale_angle_translation(pair("scale", 1.0), angle, pair("offset", 0.0))
}

impl Reader<'_> {
    /// The texture of a use, read when it is first used; `None` where the file gives it no image that can be read.
    pub(super) fn texture_ref(
        &mut self,
        of: Option<Use>,
        srgb: bool,
    ) -> Result<Option<TextureRef>> {
        let Some(of) = of else { return Ok(None) };
        let read = match self.textures.get(&(of.texture, srgb)) {
            Some(known) => *known,
            None => {
                let read = self.read_texture(of.texture, srgb)?;
                self.textures.insert((of.texture, srgb), read);
                read
            }
        };
        Ok(read.map(|texture| TextureRef {
            texture,
            transform: of.transform,
        }))
    }

    fn read_texture(&mut self, index: usize, srgb: bool) -> Result<Option<u32>> {
        let Some(texture) = self.document.textures().nth(index) else {
            return Err(self
                .error("it does not exist")
                .at(format!("texture {index}")));
        };
        let webp = texture.extension_value("EXT_texture_webp");
        let webp = webp.and_then(|e| e["source"].as_u64());
        let plain = texture.source().map(|image| image.index());
        let Some(image) = webp.map(|i| i as usize).or(plain) else {
            let what = format!("texture {index} has no image that can be read");
            self.notes.defect(self.file, &what, "it is left out")?;
            return Ok(None);
        };
        let name = format!("image {image}");
        let (file, bytes) = self.image_bytes(image).map_err(|e| e.at(&name))?;
        let (size, texels) = decode(&file, &bytes).map_err(|e| e.at(&name))?;
        let sampler = texture.sampler();
        self.model.textures.push(Texture {
            size,
            texels,
            srgb,
            wrap: [wrap(sampler.wrap_s()), wrap(sampler.wrap_t())],
        });
        Ok(Some(self.model.textures.len() as u32 - 1))
    }

    /// The bytes of an image, and the file that they are in.
    fn image_bytes(&mut self, index: usize) -> Result<(PathBuf, Vec<u8>)> {
        let document = self.document;
        let Some(image) = document.as_json().images.get(index) else {
            return Err(self.error("it does not exist"));
        };
        if let Some(uri) = &image.uri {
            return self.fetch(uri);
        }
        let view = image.buffer_view.map(|view| view.value());
        let view = view.and_then(|view| document.views().nth(view));
        let Some(view) = view else {
            return Err(self.error("it has neither a file nor a buffer view"));
        };
        let bytes = self.view(&view);
        let bytes = bytes.ok_or_else(|| self.error("it reaches beyond its buffer"))?;
        Ok((self.file.to_owned(), bytes.to_vec()))
    }
}

/// An image as 8-bit RGBA; grey fills all three channels.
fn decode(file: &Path, bytes: &[u8]) -> Result<(UVec2, Vec<[u8; 4]>)> {
    let not_decoded = |e: ImageError| {
        Error::input(file, format!("it cannot be decoded: {e}"))
            .fix("glTF images are PNG, JPEG or WebP: export it again")
    };
    let reader = || {
        let guessed = ImageReader::new(Cursor::new(bytes)).with_guessed_format();
        guessed.map_err(ImageError::IoError)
    };
    let (width, height) = reader()
        .and_then(ImageReader::into_dimensions)
        .map_err(not_decoded)?;
    if width > MOST_TEXELS || height > MOST_TEXELS {
        let what = format!("it has {width} × {height} texels, more than {MOST_TEXELS} a side");
        return Err(Error::input(file, what).fix("scale it down"));
    }
    // As it is decoded, and as RGBA.
    let size = 12 * u64::from(width) * u64::from(height);
    let room = memory::require("this texture", size);
    room.map_err(|e| e.file(file).fix(memory::FIX))?;
    let mut reader = reader().map_err(not_decoded)?;
    reader.limits(Limits::no_limits());
    let image = reader.decode().map_err(not_decoded)?;
    let texels = image.into_rgba8().into_raw();
    Ok((UVec2::new(width, height), texels.as_chunks().0.to_vec()))
}

fn wrap(mode: WrappingMode) -> Wrap {
    match mode {
        WrappingMode::ClampToEdge => Wrap::Clamp,
        WrappingMode::MirroredRepeat => Wrap::Mirror,
        WrappingMode::Repeat => Wrap::Repeat,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    /// The specification's example: the lower left quarter of the image, whose first row is v = 0.
    #[test]
    fn texture_coordinates_turn_as_the_specification_says() {
        let extension =
            json!({"offset": [0, 1], "rotation": std::f64::consts::FRAC_PI_2, "scale": [0.5, 0.5]});
        let map = transform(&extension);
        let corners = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)];
        let expected = [(0.0, 1.0), (0.0, 0.5), (0.5, 1.0), (0.5, 0.5)];
        for ((u, v), (x, y)) in corners.into_iter().zip(expected) {
            let found = map.transform_point2(Vec2::new(u, v));
            assert!(found.abs_diff_eq(Vec2::new(x, y), 1e-6), "{u} {v}: {found}");
        }
        assert_eq!(transform(&json!({})), Affine2::IDENTITY);
    }
}
