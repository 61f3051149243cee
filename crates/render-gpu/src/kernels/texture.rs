//! Shared file: 8-bit textures in the surface buffer, filtered bilinearly.
//!
//! The buffer's first [`SRGB_TABLE_LEN`] words are the bits of the sRGB decoding of each 8-bit code, so that both
//! processors decode to the same numbers. A texel is a word, red in the lowest byte.

use glam::{Vec2, Vec4};

/// Words of the table that decodes sRGB.
pub const SRGB_TABLE_LEN: u32 = 256;

/// [`TextureView::flags`]: red, green and blue are sRGB-encoded.
pub const FLAG_SRGB: u32 = 1;
/// Place of the wrap mode along u in [`TextureView::flags`]; that along v follows two bits above.
pub const WRAP_SHIFT: u32 = 1;
/// Wrap mode: the image again.
pub const WRAP_REPEAT: u32 = 0;
/// Wrap mode: the image mirrored at every second repetition.
pub const WRAP_MIRROR: u32 = 1;
/// Wrap mode: the edge's texel.
pub const WRAP_CLAMP: u32 = 2;

/// Where a texture lies in the buffer.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct TextureView {
    /// Word of its first texel.
    pub first: u32,
    /// Width in texels; 0 says that there is no texture.
    pub width: u32,
    /// Height in texels.
    pub height: u32,
    /// [`FLAG_SRGB`] and the wrap modes.
    pub flags: u32,
}

impl TextureView {
    /// Whether there is a texture at all.
    #[inline]
    #[must_use]
    pub fn exists(&self) -> bool {
        self.width > 0
    }

    /// Its value at `uv`, v = 0 at the first row: linear red, green, blue and alpha in [0, 1], filtered bilinearly.
    ///
    /// `surface` is the whole buffer. A `uv` that is not finite gives some texel.
    #[inline]
    #[must_use]
    pub fn sample(&self, surface: &[u32], uv: Vec2) -> Vec4 {
        let wrap_u = (self.flags >> WRAP_SHIFT) & 3;
        let wrap_v = (self.flags >> (WRAP_SHIFT + 2)) & 3;
        let x = wrap(uv.x, wrap_u) * self.width as f32 - 0.5;
        let y = wrap(uv.y, wrap_v) * self.height as f32 - 0.5;
        let (left, top) = (libm::floorf(x), libm::floorf(y));
        let x0 = neighbour(left as i32, self.width, wrap_u);
        let x1 = neighbour(left as i32 + 1, self.width, wrap_u);
        let row0 = neighbour(top as i32, self.height, wrap_v) * self.width;
        let row1 = neighbour(top as i32 + 1, self.height, wrap_v) * self.width;
        let upper = self
            .texel(surface, row0 + x0)
            .lerp(self.texel(surface, row0 + x1), x - left);
        let lower = self
            .texel(surface, row1 + x0)
            .lerp(self.texel(surface, row1 + x1), x - left);
        upper.lerp(lower, y - top)
    }

    #[inline]
    fn texel(&self, surface: &[u32], index: u32) -> Vec4 {
        let word = surface[(self.first + index) as usize];
        let r = word & 0xff;
        let g = (word >> 8) & 0xff;
        let b = (word >> 16) & 0xff;
        let alpha = (word >> 24) as f32 / 255.0;
        if self.flags & FLAG_SRGB != 0 {
            Vec4::new(
                f32::from_bits(surface[r as usize]),
                f32::from_bits(surface[g as usize]),
                f32::from_bits(surface[b as usize]),
                alpha,
            )
        } else {
            Vec4::new(r as f32 / 255.0, g as f32 / 255.0, b as f32 / 255.0, alpha)
        }
    }
}

/// A texture coordinate brought into [0, 1].
#[inline]
fn wrap(x: f32, mode: u32) -> f32 {
    if mode == WRAP_CLAMP {
        return x.clamp(0.0, 1.0);
    }
    if mode == WRAP_MIRROR {
        let folded = x - 2.0 * libm::floorf(0.5 * x);
        return folded.min(2.0 - folded).clamp(0.0, 1.0);
    }
    (x - libm::floorf(x)).clamp(0.0, 1.0)
}

/// A texel index from −1 to `size`, brought inside.
#[inline]
fn neighbour(index: i32, size: u32, mode: u32) -> u32 {
    let last = size as i32 - 1;
    if mode == WRAP_REPEAT {
        if index < 0 {
            return last as u32;
        }
        if index > last {
            return 0;
        }
    }
    index.clamp(0, last) as u32
}

#[cfg(test)]
mod tests {
    use super::*;

    fn view(width: u32, height: u32, wrap: u32) -> TextureView {
        TextureView {
            first: SRGB_TABLE_LEN,
            width,
            height,
            flags: (wrap << WRAP_SHIFT) | (wrap << (WRAP_SHIFT + 2)),
        }
    }

    #[test]
    fn centres_edges_and_repetitions() {
        let mut texels = [0; SRGB_TABLE_LEN as usize + 4];
        texels[SRGB_TABLE_LEN as usize..].copy_from_slice(&[0, 255, 51, 102]);
        let red = |wrap, u, v| view(2, 2, wrap).sample(&texels, Vec2::new(u, v)).x;
        for wrap in [WRAP_REPEAT, WRAP_MIRROR, WRAP_CLAMP] {
            assert_eq!(red(wrap, 0.25, 0.25), 0.0);
            assert_eq!(red(wrap, 0.75, 0.25), 1.0);
            assert_eq!(red(wrap, 0.25, 0.75), 0.2);
            assert_eq!(red(wrap, 0.5, 0.25), 0.5);
        }
        assert_eq!(red(WRAP_REPEAT, 1.0, 0.25), 0.5);
        assert_eq!(red(WRAP_REPEAT, -0.25, 0.25), 1.0);
        assert_eq!(red(WRAP_MIRROR, 1.0, 0.25), 1.0);
        assert_eq!(red(WRAP_MIRROR, -0.25, 0.25), 0.0);
        assert_eq!(red(WRAP_MIRROR, 1.75, 0.25), 0.0);
        assert_eq!(red(WRAP_CLAMP, 9.0, 0.25), 1.0);
        assert_eq!(red(WRAP_CLAMP, -9.0, 0.25), 0.0);
    }
}
