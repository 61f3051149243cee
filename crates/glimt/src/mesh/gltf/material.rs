//! Host file: glTF materials and their textures.

use super::Reader;
use crate::error::{Error, Result};
use ::gltf::image::{Data, Format, Source};
use ::gltf::material::AlphaMode;
use ::gltf::texture::WrappingMode;
use glam::{UVec2, Vec3};
use glimt_render_gpu::prepare::scene::{Material, Reflection, Texture, TextureRef, Wrap};

/// The set of texture coordinates that a material's base colour is looked up by, or else its other textures.
pub(super) fn texture_set(material: &::gltf::Material<'_>) -> u32 {
    sets(material).first().copied().unwrap_or(0)
}

fn sets(material: &::gltf::Material<'_>) -> Vec<u32> {
    let pbr = material.pbr_metallic_roughness();
    let textures = [
        pbr.base_color_texture().map(|t| t.tex_coord()),
        pbr.metallic_roughness_texture().map(|t| t.tex_coord()),
        material.normal_texture().map(|t| t.tex_coord()),
    ];
    textures.into_iter().flatten().collect()
}

impl Reader<'_> {
    /// The index of a material, which is read when it is first used.
    pub(super) fn material(&mut self, material: &::gltf::Material<'_>) -> Result<u32> {
        if let Some(&index) = self.materials.get(&material.index()) {
            return Ok(index);
        }
        let name = match (material.name(), material.index()) {
            (Some(name), _) => name.to_owned(),
            (None, Some(index)) => format!("material {index}"),
            (None, None) => "default".to_owned(),
        };
        self.remark_on(material, &name);
        let pbr = material.pbr_metallic_roughness();
        let base_color = pbr.base_color_texture().map(|t| t.texture());
        let metallic_roughness = pbr.metallic_roughness_texture().map(|t| t.texture());
        let normal = material.normal_texture();
        let [r, g, b, _] = pbr.base_color_factor();
        let read = Material::from(Reflection::MetallicRoughness {
            base_color: Vec3::new(r, g, b),
            metallic: pbr.metallic_factor(),
            roughness: pbr.roughness_factor(),
            base_color_texture: self.optional(base_color, true)?,
            metallic_roughness_texture: self.optional(metallic_roughness, false)?,
            normal_scale: normal
                .as_ref()
                .map_or(1.0, ::gltf::material::NormalTexture::scale),
            normal_texture: self.optional(normal.map(|t| t.texture()), false)?,
        });
        let index = self.model.materials.len() as u32;
        self.model.materials.push(read);
        self.model.material_names.push(name);
        self.materials.insert(material.index(), index);
        Ok(index)
    }

    fn remark_on(&mut self, material: &::gltf::Material<'_>, name: &str) {
        let mut note = |what: &str| {
            self.notes
                .note(self.file, format!("material `{name}` {what}"));
        };
        if material.alpha_mode() != AlphaMode::Opaque {
            note("is see-through; taken as opaque");
        }
        if material.emissive_texture().is_some() || material.emissive_factor() != [0.0; 3] {
            note("glows; the light comes from the probe alone");
        }
        if sets(material).windows(2).any(|pair| pair[0] != pair[1]) {
            note("uses several sets of texture coordinates; the base colour's is taken for all");
        }
    }

    fn optional(
        &mut self,
        texture: Option<::gltf::Texture<'_>>,
        srgb: bool,
    ) -> Result<Option<TextureRef>> {
        let read = texture.map(|t| self.texture(&t, srgb)).transpose()?;
        Ok(read.map(TextureRef::from))
    }

    fn texture(&mut self, texture: &::gltf::Texture<'_>, srgb: bool) -> Result<u32> {
        let key = (texture.index(), srgb);
        if let Some(&index) = self.textures.get(&key) {
            return Ok(index);
        }
        let image = texture.source();
        let name = format!("image {}", image.index());
        let file = match image.source() {
            Source::Uri { uri, .. } => self.external(uri).unwrap_or_else(|| self.file.to_owned()),
            Source::View { view, .. } => {
                let end = view.offset().checked_add(view.length());
                if end.is_none_or(|end| end > self.buffers[view.buffer().index()].len()) {
                    return Err(self.error("it reaches beyond its buffer").at(name));
                }
                self.file.to_owned()
            }
        };
        let data =
            Data::from_source(image.source(), Some(self.folder), &self.buffers).map_err(|e| {
                match e {
                    ::gltf::Error::Io(e) => Error::reading(&file, &e),
                    e => Error::input(&file, format!("it cannot be decoded: {e}"))
                        .fix("glTF images are PNG or JPEG: export it again"),
                }
                .at(&name)
            })?;
        let texels = rgba(&data).ok_or_else(|| {
            Error::input(&file, "it has float texels")
                .at(&name)
                .fix("glTF images are PNG or JPEG: export it again")
        })?;
        let sampler = texture.sampler();
        self.model.textures.push(Texture {
            size: UVec2::new(data.width, data.height),
            texels,
            srgb,
            wrap: [wrap(sampler.wrap_s()), wrap(sampler.wrap_t())],
        });
        let index = self.model.textures.len() as u32 - 1;
        self.textures.insert(key, index);
        Ok(index)
    }
}

fn wrap(mode: WrappingMode) -> Wrap {
    match mode {
        WrappingMode::ClampToEdge => Wrap::Clamp,
        WrappingMode::MirroredRepeat => Wrap::Mirror,
        WrappingMode::Repeat => Wrap::Repeat,
    }
}

/// 8-bit RGBA of any whole-number format; grey fills all three channels.
fn rgba(data: &Data) -> Option<Vec<[u8; 4]>> {
    // Channels, bytes in each; of 16-bit values the high byte counts, which is the second.
    let (channels, bytes) = match data.format {
        Format::R8 => (1, 1),
        Format::R8G8 => (2, 1),
        Format::R8G8B8 => (3, 1),
        Format::R8G8B8A8 => (4, 1),
        Format::R16 => (1, 2),
        Format::R16G16 => (2, 2),
        Format::R16G16B16 => (3, 2),
        Format::R16G16B16A16 => (4, 2),
        Format::R32G32B32FLOAT | Format::R32G32B32A32FLOAT => return None,
    };
    let high = if cfg!(target_endian = "little") {
        bytes - 1
    } else {
        0
    };
    let texel = |t: &[u8]| {
        let c = |i: usize| t[i * bytes + high];
        match channels {
            1 => [c(0), c(0), c(0), 255],
            2 => [c(0), c(0), c(0), c(1)],
            3 => [c(0), c(1), c(2), 255],
            _ => [c(0), c(1), c(2), c(3)],
        }
    };
    Some(
        data.pixels
            .chunks_exact(channels * bytes)
            .map(texel)
            .collect(),
    )
}
