//! Shared file: triangles that are drawn instead of traced, and what is drawn made into layers (Hajisharif 2012, § 3.6).
//!
//! A drawn triangle hands on where in it a pixel lies and nothing else: light, texture and normal are interpolated by the same
//! functions as where a ray hits. Interpolation is linear, so light that was multiplied out at the vertices (Eq. 14) is what
//! interpolated coefficients would give.

use glam::{UVec2, Vec2, Vec3, Vec4};

use super::environment::RadianceMap;
use super::frame::{Background, FrameParams};
use super::layers::{LayerSample, PixelLayers};
use super::opacity::{alpha_at, passes};
use super::pattern::{PixelPattern, SEEN_THROUGH};
use super::prt::{Surface, at_hit};
use super::ray::{Hit, Ray};
use super::scene::Scene;

/// The largest number of 16 bits.
pub const HALF_MAX: f32 = 65_504.0;

/// What the stages of drawing know of a frame. 240 bytes.
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::NoUninit)]
#[repr(C)]
pub struct RasterParams {
    /// The frame.
    pub frame: FrameParams,
    /// Columns and rows of the light map.
    pub map_size: UVec2,
    /// [`RadianceMap::rotation`] of the light map.
    pub map_rotation: Vec2,
    /// Distance along the line of sight below which nothing is drawn.
    pub near: f32,
    /// Factor on radiance in the drawn layers, which have 16 bits.
    pub scale: f32,
    /// Samples of a pixel.
    pub samples: u32,
    /// Fills 16 bytes.
    pub unused: u32,
}

/// How much further than it is a catcher is drawn, as a share of its distance, so that what lies on it is seen before it.
const SETBACK: f32 = 1.0 / 65_536.0;

/// What is drawn at a point: values of the layers, at most [`HALF_MAX`]. What would be more is darkened in all channels alike, and a
/// catcher's two layers together, so that its share of light stays what it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drawn {
    /// An object's radiance, and 1; else 0.
    pub object: Vec4,
    /// A catcher's radiance, and 1; else 0.
    pub lit: Vec4,
    /// What a catcher lacks because of the objects; w is 0.
    pub blocked: Vec4,
}

/// Place of corner `corner % 3` of triangle `corner / 3`.
#[inline]
#[must_use]
pub fn corner_position(corner: u32, scene: Scene<'_>) -> Vec3 {
    let triangle = &scene.triangles[(corner / 3) as usize];
    match corner % 3 {
        0 => triangle.a(),
        1 => triangle.b(),
        _ => triangle.c(),
    }
}

/// Barycentric weights of a triangle's second and third corner at its corner `corner % 3`.
#[inline]
#[must_use]
pub fn corner_weights(corner: u32) -> Vec2 {
    match corner % 3 {
        0 => Vec2::ZERO,
        1 => Vec2::X,
        _ => Vec2::Y,
    }
}

/// What [`clip_position`] takes as `near` for corner `corner % 3` of triangle `corner / 3`.
#[inline]
#[must_use]
pub fn corner_near(corner: u32, near: f32, scene: Scene<'_>) -> f32 {
    if scene.triangles[(corner / 3) as usize].is_catcher() {
        return near * (1.0 - SETBACK);
    }
    near
}

/// 1 where triangle `triangle` keeps sample `sample` of a pixel, which it does where the sample does not [pass](passes) it, else 0. Its second and third
/// corner have these weights there; the pixel has the coordinates `pixel` in the image.
#[must_use]
pub fn keeps_sample(
    triangle: u32,
    weights: Vec2,
    pixel: UVec2,
    sample: u32,
    raster: &RasterParams,
    scene: Scene<'_>,
) -> u32 {
    let at = &scene.triangles[triangle as usize];
    if !at.is_see_through() {
        return 1;
    }
    let u = weights.x.clamp(0.0, 1.0);
    let v = weights.y.clamp(0.0, 1.0 - u);
    let pattern = PixelPattern {
        kind: raster.frame.pattern,
        seed: raster.frame.seed,
        frame: raster.frame.film_frame,
        pixel: pixel.y * raster.frame.width + pixel.x,
        ray: sample,
        rays: raster.samples,
    };
    let alpha = alpha_at(at, scene.surface, u, v);
    if passes(pattern.ray_key(SEEN_THROUGH), triangle, alpha) {
        0
    } else {
        1
    }
}

/// Homogeneous clip coordinates of the world point `p`: x and y in [−w, w] inside the image, y up, w the distance along the
/// line of sight, and depth near/w, which grows towards the eye and keeps its relative precision however far `p` is.
///
/// ```
/// use glam::{UVec2, Vec3};
/// use glimt_render_gpu::prepare::render::RenderSettings;
/// use glimt_render_gpu::prepare::scene::Camera;
/// use glimt_render_gpu::kernels::raster::clip_position;
/// let camera = Camera { eye: Vec3::ZERO, target: Vec3::X, up: Vec3::Z, fov_x: 1.570_796_3 };
/// let frame = RenderSettings::new(UVec2::new(200, 100), camera).frame_params()?;
/// // The upper right corner of the image, which is twice as wide as high.
/// let p = clip_position(&frame, 0.5, Vec3::new(10.0, -10.0, 5.0));
/// assert!((p / p.w - glam::Vec4::new(1.0, 1.0, 0.05, 1.0)).length() < 1e-6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[inline]
#[must_use]
pub fn clip_position(frame: &FrameParams, near: f32, p: Vec3) -> Vec4 {
    let d = p - frame.eye;
    Vec4::new(
        d.dot(frame.right) / frame.right.length_squared(),
        d.dot(frame.up) / frame.up.length_squared(),
        near,
        d.dot(frame.forward),
    )
}

/// What the point of triangle `triangle` shows where its second and third corner have these weights. Weights that lie outside,
/// as those of a pixel that the triangle only touches may, are brought inside.
#[must_use]
pub fn draw(
    triangle: u32,
    weights: Vec2,
    raster: &RasterParams,
    texels: &[Vec4],
    scene: Scene<'_>,
    surface: Surface<'_>,
) -> Drawn {
    let u = weights.x.clamp(0.0, 1.0);
    let v = weights.y.clamp(0.0, 1.0 - u);
    let at = &scene.triangles[triangle as usize];
    let p = at.a() + (at.b() - at.a()) * u + (at.c() - at.a()) * v;
    let to_point = p - raster.frame.eye;
    let ray = Ray::new(raster.frame.eye, to_point.normalize());
    let hit = Hit {
        triangle,
        t: to_point.length(),
        barycentrics: Vec2::new(u, v),
    };
    let map = RadianceMap {
        texels,
        size: raster.map_size,
        rotation: raster.map_rotation,
    };
    let light = at_hit(&ray, &hit, map, scene, surface);
    let sample = LayerSample::of(&light, at.is_catcher());
    let scale = fitting_scale(sample.radiance.max(sample.blocked), raster.scale);
    let radiance = sample.radiance * scale;
    Drawn {
        object: (radiance * sample.alpha).extend(sample.alpha),
        lit: (radiance * sample.catcher).extend(sample.catcher),
        blocked: (sample.blocked * scale).extend(0.0),
    }
}

/// `scale`, or as much less that 16 bits can hold what it makes of `radiance`.
#[inline]
fn fitting_scale(radiance: Vec3, scale: f32) -> f32 {
    let largest = radiance.max_element() * scale;
    if largest > HALF_MAX {
        return scale * (HALF_MAX / largest);
    }
    scale
}

/// How drawn layers lie in a buffer. 16 bytes.
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct DrawnLayout {
    /// Columns and rows of the light map.
    pub map_size: UVec2,
    /// Values from one row to the next, at least the image's width.
    pub pitch: u32,
    /// [`RasterParams::scale`].
    pub scale: f32,
}

/// The layers of the tile's pixel `pixel`, from values of 16 bits in four channels: whole rows of the image, the tile's first pixel
/// at the left edge. What is behind them is the light map in the direction of the pixel's centre.
#[must_use]
pub fn unpack_layers(
    pixel: u32,
    frame: &FrameParams,
    layout: &DrawnLayout,
    map_rotation: Vec2,
    map_texels: &[Vec4],
    object: &[UVec2],
    lit: &[UVec2],
    blocked: &[UVec2],
) -> PixelLayers {
    let at = (pixel / frame.width * layout.pitch + pixel % frame.width) as usize;
    let object = unpack(object[at], layout.scale);
    let lit = unpack(lit[at], layout.scale);
    let blocked = unpack(blocked[at], layout.scale);
    let mut behind = Vec3::ZERO;
    if frame.background == Background::Environment && object.w < 1.0 {
        let map = RadianceMap {
            texels: map_texels,
            size: layout.map_size,
            rotation: map_rotation,
        };
        let centre = frame.direction(frame.first_pixel + pixel, Vec2::splat(0.5));
        behind = map.background(centre);
    }
    PixelLayers {
        object,
        lit: lit.truncate(),
        catcher: lit.w,
        blocked: blocked.truncate(),
        unused_a: 0,
        behind,
        unused_b: 0,
    }
}

/// Radiance of three numbers of 16 bits that were multiplied by `scale`, and the fourth as it is.
#[inline]
fn unpack(words: UVec2, scale: f32) -> Vec4 {
    let radiance = Vec3::new(half(words.x), half(words.x >> 16), half(words.y));
    (radiance / scale).extend(half(words.y >> 16))
}

/// A number of 16 bits (IEEE 754 binary16), in the lower half of a word. Infinities count as 65 536, NaNs as more.
///
/// ```
/// use glimt_render_gpu::kernels::raster::half;
/// assert_eq!([half(0x3c00), half(0xc000), half(0x7bff)], [1.0, -2.0, 65_504.0]);
/// // The smallest.
/// assert_eq!(half(1), 1.0 / 16_777_216.0);
/// ```
#[inline]
#[must_use]
pub fn half(word: u32) -> f32 {
    let bits = word & 0x7fff;
    let mut value = bits as f32 * (1.0 / 16_777_216.0);
    if bits >= 0x400 {
        // The exponent's bias is 127 in place of 15.
        value = f32::from_bits((bits << 13) + (112 << 23));
    }
    if word & 0x8000 != 0 { -value } else { value }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn layout_is_that_of_wgsl() {
        assert_eq!(core::mem::size_of::<RasterParams>(), 240);
        assert_eq!(core::mem::offset_of!(RasterParams, map_size), 208);
        assert_eq!(core::mem::offset_of!(RasterParams, near), 224);
        assert_eq!(core::mem::size_of::<DrawnLayout>(), 16);
        assert_eq!(core::mem::offset_of!(DrawnLayout, pitch), 8);
    }

    #[test]
    fn what_is_too_bright_keeps_its_colour() {
        let radiance = Vec3::new(3.0, 1.0, 2.0);
        assert_eq!(fitting_scale(radiance, 8.0), 8.0);
        let stored = radiance * fitting_scale(radiance, 1e6);
        assert!(
            stored.x <= HALF_MAX && stored.x > 0.999 * HALF_MAX,
            "{stored}"
        );
        assert!(
            (stored / stored.x - radiance / 3.0).length() < 1e-6,
            "{stored}"
        );
    }

    #[test]
    fn halves_grow_with_their_bits() {
        for word in 0..0x7bff {
            assert!(half(word) < half(word + 1), "{word:x}");
            assert_eq!(half(word | 0x8000), -half(word));
        }
    }
}
