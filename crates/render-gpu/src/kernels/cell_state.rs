//! Shared file: what is known of the visibility of a light's cells: counts of rays, for each tile of the image and object in it.

use glam::{Vec3, Vec4};
use glimt_light_cells::CELLS;

use super::proposal::Expectation;

/// Pixels of a tile, across and down.
pub const TILE_WIDTH: u32 = 16;
/// See above.
pub const TILE_HEIGHT: u32 = 8;
/// Entries of a tile: objects that it tells apart. Those beyond share the last.
pub const ENTRIES: u32 = 3;

/// Words of an entry's counts: two cells a word, of each the rays N and those that arrived S in 8 bits each.
pub const COUNT_WORDS: u32 = CELLS / 2;
/// Words of an entry's expected visibilities: four cells a word, in 255ths.
pub const VISIBILITY_WORDS: u32 = CELLS / 4;
/// Values behind those of all entries: parts of the sum of what rays are worth, f32.
pub const WORTHS: u32 = 64;

/// The share that is taken to arrive where no ray has been.
pub const NOTHING_KNOWN: f32 = 0.75;

/// An object that a tile shows: its point nearest to the tile's centre, of those that the pixels' first rays hit. 64 bytes; all 0 for
/// none.
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct TileEntry {
    /// The point.
    pub position: Vec3,
    /// One more than the index of the object; 0 for none.
    pub surface: u32,
    /// Unit normal.
    pub normal: Vec3,
    /// Exponent of its lobe.
    pub exponent: f32,
    /// Unit direction towards the eye.
    pub wo: Vec3,
    /// How many of the pixels' first rays hit the object.
    pub hits: u32,
    /// kd in luminance.
    pub diffuse: f32,
    /// ks in luminance.
    pub specular: f32,
    /// Square of its distance from the tile's centre, in pixels.
    pub off_centre: f32,
    /// Fills 16 bytes.
    pub unused: u32,
}

impl TileEntry {
    /// No object.
    pub const NONE: TileEntry = TileEntry {
        position: Vec3::ZERO,
        surface: 0,
        normal: Vec3::ZERO,
        exponent: 0.0,
        wo: Vec3::ZERO,
        hits: 0,
        diffuse: 0.0,
        specular: 0.0,
        off_centre: 0.0,
        unused: 0,
    };
}

/// The slot of a surface among the [`ENTRIES`] of a tile from `first` on: counted from 1, 0 for nowhere.
#[inline]
#[must_use]
pub fn slot_of(surface: u32, entries: &[TileEntry], first: u32) -> u32 {
    let mut slot = 0;
    for i in 0..ENTRIES {
        let own = entries[(first + i) as usize].surface;
        // Where all entries are taken the last is everyone's.
        if slot == 0 && (own == surface || (i == ENTRIES - 1 && own != 0)) {
            slot = i + 1;
        }
    }
    slot
}

/// The bytes of a word: of counts N and S of the first cell, then of the second.
#[inline]
#[must_use]
pub fn bytes_of(word: u32) -> Vec4 {
    Vec4::new(
        (word & 0xff) as f32,
        (word >> 8 & 0xff) as f32,
        (word >> 16 & 0xff) as f32,
        (word >> 24) as f32,
    )
}

/// N and S of one cell, with one ray more.
#[inline]
fn counted(n: u32, s: u32, arrives: u32) -> u32 {
    let is_full = n >= 255;
    // A full count forgets half of its rays.
    let n = if is_full { n / 2 } else { n } + 1;
    let s = if is_full { s / 2 } else { s } + arrives;
    n | s << 8
}

/// A word of counts after a ray in cell `cell`, which it holds.
#[inline]
#[must_use]
pub fn count(word: u32, cell: u32, arrives: bool) -> u32 {
    let shift = 16 * (cell & 1);
    let own = word >> shift & 0xffff;
    let more = counted(own & 0xff, own >> 8, if arrives { 1 } else { 0 });
    word & !(0xffff << shift) | more << shift
}

/// Visibilities of four cells as a word.
#[inline]
#[must_use]
pub fn pack(visibility: Vec4) -> u32 {
    let codes = (visibility.clamp(Vec4::ZERO, Vec4::ONE) * 255.0 + Vec4::splat(0.5)).as_uvec4();
    codes.x | codes.y << 8 | codes.z << 16 | codes.w << 24
}

/// What is expected of the visibility around one pixel.
#[derive(Clone, Copy, Debug)]
pub struct Expected<'a> {
    /// Words of all entries, [`VISIBILITY_WORDS`] each.
    pub words: &'a [u32],
    /// Index of the first entry of the pixel's tile.
    pub first: u32,
    /// The slot; 0 where nothing is known.
    pub slot: u32,
}

impl Expectation for Expected<'_> {
    const CONTROL: bool = true;

    #[inline]
    fn at_slot(&self, slot: u32) -> Self {
        Expected { slot, ..*self }
    }

    #[inline]
    fn quad(&self, quad: u32) -> Vec4 {
        if self.slot == 0 {
            return Vec4::splat(NOTHING_KNOWN);
        }
        let entry = self.first + self.slot - 1;
        let word = self.words[(entry * VISIBILITY_WORDS + quad) as usize];
        bytes_of(word) * (1.0 / 255.0)
    }
}

/// The same is expected of all cells: a pilot's.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Even;

impl Expectation for Even {
    const CONTROL: bool = true;

    #[inline]
    fn at_slot(&self, _slot: u32) -> Even {
        Even
    }

    #[inline]
    fn quad(&self, _quad: u32) -> Vec4 {
        Vec4::splat(NOTHING_KNOWN)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn layout_is_that_of_wgsl() {
        assert_eq!(core::mem::size_of::<TileEntry>(), 64);
        assert_eq!(core::mem::offset_of!(TileEntry, normal), 16);
        assert_eq!(core::mem::offset_of!(TileEntry, wo), 32);
        assert_eq!(core::mem::offset_of!(TileEntry, diffuse), 48);
    }

    #[test]
    fn counts_count_and_forget() {
        let mut word = 0;
        for i in 0..1000 {
            word = count(word, 6, i % 4 != 0);
            word = count(word, 7, false);
        }
        let all = bytes_of(word);
        assert!(all.x <= 255.0 && (all.y / all.x - 0.75).abs() < 0.03 && all.w == 0.0);
    }

    #[test]
    fn surfaces_beyond_the_entries_share_the_last() {
        let with = |surface| TileEntry {
            surface,
            ..TileEntry::NONE
        };
        let full = [with(7), with(9), with(2)];
        assert_eq!([7, 9, 2, 5].map(|s| slot_of(s, &full, 0)), [1, 2, 3, 3]);
        let some = [with(7), TileEntry::NONE, TileEntry::NONE];
        assert_eq!([7, 9].map(|s| slot_of(s, &some, 0)), [1, 0]);
    }
}
