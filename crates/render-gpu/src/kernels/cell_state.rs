//! Shared file: what is known of the visibility of a light's cells: counts of rays, for each tile of the image and object in it.

use glam::{Vec3, Vec4};
use glimt_light_cells::{CELLS, COLUMNS};

use super::proposal::Expectation;

/// Pixels of a tile, across and down.
pub const TILE_WIDTH: u32 = 16;
/// See above.
pub const TILE_HEIGHT: u32 = 10;
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

/// The most rays that a cell's counts bring from the frame before.
const MOST_REMEMBERED: u32 = 64;

/// κ of a pilot, which looks at no neighbours: how many rays [`NOTHING_KNOWN`] is worth.
const PRIOR: f32 = 4.0;

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
    /// kd in luminance.
    pub diffuse: f32,
    /// ks in luminance.
    pub specular: f32,
    /// How many of the pixels' first rays hit the object.
    pub hits: u32,
    /// Square of its distance from the tile's centre, in pixels.
    pub off_centre: f32,
    /// One more than the index of the entry of the frame before whose counts it takes over; 0 for none.
    pub from: u32,
    /// Pilot rays of each pixel that sends some out.
    pub pilots: u32,
    /// 1 for a catcher.
    pub catcher: u32,
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
        diffuse: 0.0,
        specular: 0.0,
        hits: 0,
        off_centre: 0.0,
        from: 0,
        pilots: 0,
        catcher: 0,
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

/// Counts of four cells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct QuadCounts {
    /// N: the rays that went to each.
    pub rays: Vec4,
    /// S: those that arrived.
    pub arrived: Vec4,
}

/// The counts in two words: of the first two of the four cells, then of the others.
#[inline]
#[must_use]
pub fn quad_counts(first: u32, second: u32) -> QuadCounts {
    let (low, high) = (bytes_of(first), bytes_of(second));
    QuadCounts {
        rays: Vec4::new(low.x, low.z, high.x, high.z),
        arrived: Vec4::new(low.y, low.w, high.y, high.w),
    }
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

/// N and S of one cell, scaled down to [`MOST_REMEMBERED`] rays.
#[inline]
fn remembered(n: u32, s: u32) -> u32 {
    if n <= MOST_REMEMBERED {
        return n | s << 8;
    }
    MOST_REMEMBERED | ((2 * s * MOST_REMEMBERED + n) / (2 * n)) << 8
}

/// The counts that a frame left, as the next one takes them over.
#[derive(Clone, Copy, Debug)]
pub struct Remembered<'a> {
    /// Words of all entries of the frame before, [`COUNT_WORDS`] each.
    pub words: &'a [u32],
    /// [`TileEntry::from`].
    pub from: u32,
    /// By how many columns of cells the light has turned since.
    pub turned: u32,
}

impl Remembered<'_> {
    /// N and S of a cell of this frame's light, as half a word.
    #[inline]
    fn cell(&self, cell: u32) -> u32 {
        let column = (cell % COLUMNS + COLUMNS - self.turned) % COLUMNS;
        let was = cell / COLUMNS * COLUMNS + column;
        let word = self.words[((self.from - 1) * COUNT_WORDS + was / 2) as usize];
        let own = word >> (16 * (was & 1)) & 0xffff;
        remembered(own & 0xff, own >> 8)
    }

    /// Word `word` of an entry's counts; 0 where nothing is remembered.
    #[inline]
    #[must_use]
    pub fn word(&self, word: u32) -> u32 {
        if self.from == 0 {
            return 0;
        }
        self.cell(2 * word) | self.cell(2 * word + 1) << 16
    }

    /// The counts of cells `4 · quad` on.
    #[inline]
    #[must_use]
    pub fn counts(&self, quad: u32) -> QuadCounts {
        quad_counts(self.word(2 * quad), self.word(2 * quad + 1))
    }
}

impl TileEntry {
    /// What the counts of the frame before, all its `words`, tell of it.
    #[inline]
    #[must_use]
    pub fn remembered<'a>(&self, words: &'a [u32], turned: u32) -> Remembered<'a> {
        Remembered {
            words,
            from: self.from,
            turned,
        }
    }
}

/// What a pilot expects: it knows what the frame before counted, and looks at no neighbour.
impl Expectation for Remembered<'_> {
    const CONTROL: bool = true;

    #[inline]
    fn at_slot(&self, _slot: u32) -> Self {
        *self
    }

    #[inline]
    fn quad(&self, quad: u32) -> Vec4 {
        let counts = self.counts(quad);
        (counts.arrived + Vec4::splat(PRIOR * NOTHING_KNOWN)) / (counts.rays + Vec4::splat(PRIOR))
    }
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn layout_is_that_of_wgsl() {
        assert_eq!(core::mem::size_of::<TileEntry>(), 64);
        assert_eq!(core::mem::offset_of!(TileEntry, normal), 16);
        assert_eq!(core::mem::offset_of!(TileEntry, diffuse), 32);
        assert_eq!(core::mem::offset_of!(TileEntry, from), 48);
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
        let mut words = [0; COUNT_WORDS as usize];
        words[3] = word;
        let next = Remembered {
            words: &words,
            from: 1,
            turned: 0,
        };
        let kept = bytes_of(next.word(3));
        assert_eq!((kept.x, kept.z, kept.w), (64.0, 64.0, 0.0));
        assert!((kept.y / kept.x - all.y / all.x).abs() < 0.01);
        assert_eq!(next.counts(1).rays, Vec4::new(0.0, 0.0, 64.0, 64.0));
        let expected = next.quad(1);
        assert_eq!(expected.x, NOTHING_KNOWN);
        assert!((expected.w - 3.0 / 68.0).abs() < 1e-6);
        let empty = Remembered { from: 0, ..next };
        assert_eq!((empty.word(3), empty.quad(1)), (0, Vec4::splat(0.75)));
    }

    #[test]
    fn counts_turn_with_the_light() {
        let mut words = [0; COUNT_WORDS as usize];
        // The last cell of the second row.
        words[COLUMNS as usize - 1] = 5 << 16 | 2 << 24;
        let turned = |turned| Remembered {
            words: &words,
            from: 1,
            turned,
        };
        assert_eq!(turned(0).word(COLUMNS - 1), 5 << 16 | 2 << 24);
        assert_eq!(turned(1).word(COLUMNS / 2), 5 | 2 << 8);
        assert_eq!(turned(3).word(COLUMNS / 2 + 1), 5 | 2 << 8);
        assert_eq!(turned(31).word(COLUMNS - 1), 5 | 2 << 8);
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
