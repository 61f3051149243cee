//! Shared file: what each tile of the image shows, found by one ray of each of its pixels before a frame is rendered.

use glam::UVec2;
use glimt_sampling::math::luminance;

use super::cell_state::{ENTRIES, TILE_HEIGHT, TILE_WIDTH, TileEntry, slot_of};
use super::frame::FrameParams;
use super::scene::Scene;
use super::seen::{SLOT_SHIFT, SeenPoint, see_by};

/// How a frame's light is estimated by cells. 32 bytes.
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::NoUninit)]
#[repr(C)]
pub struct CellParams {
    /// Shadow rays of a pixel, on average over the image.
    pub rays: f32,
    /// Pilot rays where little is known, as a share of those.
    pub pilot: f32,
    /// Those where the frame before tells enough.
    pub upkeep: f32,
    /// Tiles across the image.
    pub tiles_across: u32,
    /// Tiles of the image.
    pub tiles: u32,
    /// 1 where groups get rays by what those are worth, else 0.
    pub is_adaptive: u32,
    /// 1 where there is a frame before, else 0.
    pub has_past: u32,
    /// By how many columns of cells the light has turned since.
    pub turned: u32,
}

impl CellParams {
    /// The upper left pixel of a tile.
    #[inline]
    #[must_use]
    pub fn corner(&self, tile: u32) -> UVec2 {
        UVec2::new(
            tile % self.tiles_across * TILE_WIDTH,
            tile / self.tiles_across * TILE_HEIGHT,
        )
    }

    /// The tile of a pixel of the image.
    #[inline]
    #[must_use]
    pub fn tile_of(&self, pixel: u32, frame: &FrameParams) -> u32 {
        let (x, y) = (pixel % frame.width, pixel / frame.width);
        y / TILE_HEIGHT * self.tiles_across + x / TILE_WIDTH
    }
}

/// The corner behind a tile's last pixel.
#[inline]
#[must_use]
pub fn tile_end(corner: UVec2, frame: &FrameParams) -> UVec2 {
    UVec2::new(
        (corner.x + TILE_WIDTH).min(frame.width),
        (corner.y + TILE_HEIGHT).min(frame.height),
    )
}

/// Finds the objects of tile `tile` of the image, which begins at pixel 0.
pub fn scout(
    tile: u32,
    frame: &FrameParams,
    cells: &CellParams,
    scene: Scene<'_>,
    entries: &mut [TileEntry],
) {
    for i in 0..ENTRIES as usize {
        entries[i] = TileEntry::NONE;
    }
    let corner = cells.corner(tile);
    let end = tile_end(corner, frame);
    for y in corner.y..end.y {
        for x in corner.x..end.x {
            let point = see_by(&frame.pattern_at(y * frame.width + x, 0), frame, scene);
            if point.is_hit() {
                let across = x as f32 + 0.5 - 0.5 * (corner.x + end.x) as f32;
                let down = y as f32 + 0.5 - 0.5 * (corner.y + end.y) as f32;
                enter(&point, across * across + down * down, entries);
            }
        }
    }
}

/// Puts a hit among the entries of its tile.
#[inline]
fn enter(point: &SeenPoint, off_centre: f32, entries: &mut [TileEntry]) {
    let mut at = ENTRIES - 1;
    let mut is_found = false;
    for i in 0..ENTRIES {
        let own = entries[i as usize].surface;
        if !is_found && (own == point.surface || own == 0) {
            at = i;
            is_found = true;
        }
    }
    let old = entries[at as usize];
    let hits = old.hits + 1;
    if old.surface == 0 || (old.surface == point.surface && off_centre < old.off_centre) {
        entries[at as usize] = TileEntry {
            position: point.origin,
            surface: point.surface,
            normal: point.normal,
            exponent: point.exponent,
            diffuse: luminance(point.diffuse),
            specular: luminance(point.specular),
            hits,
            off_centre,
            from: 0,
            pilots: 0,
            catcher: if point.is_catcher() { 1 } else { 0 },
            unused: 0,
        };
    } else {
        entries[at as usize].hits = hits;
    }
}

/// What the tile's ray `ray` hits, with the slot of its object among the entries of the image's tiles.
#[must_use]
pub fn see_in_tile(
    ray: u32,
    frame: &FrameParams,
    cells: &CellParams,
    scene: Scene<'_>,
    entries: &[TileEntry],
) -> SeenPoint {
    let pattern = frame.pattern_of(ray);
    let mut point = see_by(&pattern, frame, scene);
    if point.is_hit() {
        let first = cells.tile_of(pattern.pixel, frame) * ENTRIES;
        point.flags |= slot_of(point.surface, entries, first) << SLOT_SHIFT;
    }
    point
}
