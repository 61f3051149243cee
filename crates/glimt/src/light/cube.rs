//! Host file: cube maps: how their six faces lie in an image, and a cube resampled into a lat-long map.

use glam::{UVec2, Vec2, Vec3, Vec4};
use rayon::prelude::*;
use std::f32::consts::PI;

/// Taps along each side of a lat-long texel.
const TAPS: u32 = 4;

/// The same where neighbours differ by more than [`CONTRAST`]: a lamp of one texel must not gain or lose light by where taps fall.
const FINE_TAPS: u32 = 32;

/// The ratio of luminance beyond which taps are fine.
const CONTRAST: f32 = 4.0;

/// How the faces lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Layout {
    /// Six in a row: +X −X +Y −Y +Z −Z.
    Row,
    /// The same from top to bottom.
    Column,
    /// A cross that lies: −X +Z +X −Z, +Y above +Z and −Y below it.
    Lying,
    /// A cross that stands: +Y, then −X +Z +X, then −Y, then −Z, which is turned by half a turn.
    Standing,
}

/// Faces in the order +X −X +Y −Y +Z −Z.
const FACES: usize = 6;

impl Layout {
    /// The layout of an image of this size, and the side of a face; `None` for other proportions.
    pub(super) fn of(size: UVec2) -> Option<(Self, u32)> {
        let [w, h] = [size.x, size.y].map(u64::from);
        if h == 0 || w == 0 {
            return None;
        }
        match (w, h) {
            _ if w == 6 * h => Some((Self::Row, size.y)),
            _ if h == 6 * w => Some((Self::Column, size.x)),
            _ if 3 * w == 4 * h => Some((Self::Lying, size.x / 4)),
            _ if 4 * w == 3 * h => Some((Self::Standing, size.x / 3)),
            _ => None,
        }
    }

    /// Whether proportions alone make it a cube map: a photograph is not six times as wide as high.
    pub(super) fn is_strip(self) -> bool {
        matches!(self, Self::Row | Self::Column)
    }

    /// Where each face lies, in faces.
    fn places(self) -> [UVec2; FACES] {
        let at = |x, y| UVec2::new(x, y);
        match self {
            Self::Row => std::array::from_fn(|i| at(i as u32, 0)),
            Self::Column => std::array::from_fn(|i| at(0, i as u32)),
            Self::Lying => [at(2, 1), at(0, 1), at(1, 0), at(1, 2), at(1, 1), at(3, 1)],
            Self::Standing => [at(2, 1), at(0, 1), at(1, 0), at(1, 2), at(1, 1), at(1, 3)],
        }
    }

    /// Width and height in faces.
    fn extent(self) -> UVec2 {
        match self {
            Self::Row => UVec2::new(6, 1),
            Self::Column => UVec2::new(1, 6),
            Self::Lying => UVec2::new(4, 3),
            Self::Standing => UVec2::new(3, 4),
        }
    }
}

/// Whether the squares of a cross that hold no face are of one colour each, as in a cross they are and in a photograph not.
pub(super) fn has_blank_corners(size: UVec2, texels: &[Vec4]) -> bool {
    let Some((layout, side)) = Layout::of(size) else {
        return false;
    };
    let extent = layout.extent();
    let places = layout.places();
    let squares = (0..extent.y).flat_map(|y| (0..extent.x).map(move |x| UVec2::new(x, y)));
    squares
        .filter(|square| !places.contains(square))
        .all(|square| {
            let first = texels[index(size, square * side)];
            let rows = 0..side;
            rows.into_iter().all(|row| {
                let from = index(size, square * side + UVec2::new(0, row));
                texels[from..from + side as usize]
                    .iter()
                    .all(|t| *t == first)
            })
        })
}

fn index(size: UVec2, at: UVec2) -> usize {
    at.y as usize * size.x as usize + at.x as usize
}

/// Resamples a cube map into a lat-long map, whose equator has as many texels as four faces. A texel is the mean of what it covers.
pub(super) fn cube_to_latlong(
    size: UVec2,
    layout: Layout,
    side: u32,
    texels: &[Vec4],
) -> (UVec2, Vec<Vec4>) {
    let out = UVec2::new(4 * side, 2 * side);
    let places = layout.places().map(|place| place * side);
    let lookup = |direction: Vec3| -> Vec4 {
        let (face, uv) = place(direction);
        let uv = match (layout, face) {
            (Layout::Standing, 5) => Vec2::ONE - uv,
            _ => uv,
        };
        let inside = (uv * side as f32).as_uvec2().min(UVec2::splat(side - 1));
        texels[index(size, places[face] + inside)]
    };
    let texel = |i: usize| -> Vec4 {
        let at = UVec2::new(i as u32 % out.x, i as u32 / out.x);
        let (coarse, contrast) = mean(at, out, TAPS, &lookup);
        match contrast > CONTRAST {
            true => mean(at, out, FINE_TAPS, &lookup).0,
            false => coarse,
        }
    };
    let count = out.x as usize * out.y as usize;
    (out, (0..count).into_par_iter().map(texel).collect())
}

/// The mean of a lat-long texel by taps that share its solid angle, and the ratio of its brightest to its darkest tap.
fn mean(at: UVec2, out: UVec2, taps: u32, lookup: &impl Fn(Vec3) -> Vec4) -> (Vec4, f32) {
    let edge = |row: u32| (PI * row as f32 / out.y as f32).cos();
    let (top, bottom) = (edge(at.y), edge(at.y + 1));
    let mut sum = Vec4::ZERO;
    let (mut low, mut high) = (f32::MAX, 0.0_f32);
    for tap in 0..taps * taps {
        let inside = (UVec2::new(tap % taps, tap / taps).as_vec2() + 0.5) / taps as f32;
        let u = (at.x as f32 + inside.x) / out.x as f32;
        let z = top + (bottom - top) * inside.y;
        let phi = PI - 2.0 * PI * u;
        let radius = (1.0 - z * z).max(0.0).sqrt();
        let value = lookup(Vec3::new(radius * phi.cos(), radius * phi.sin(), z));
        let size = value.truncate().max_element();
        (low, high) = (low.min(size), high.max(size));
        sum += value;
    }
    let mean = sum / (taps * taps) as f32;
    (
        mean.truncate().extend(1.0),
        high / low.max(f32::MIN_POSITIVE),
    )
}

/// The face that shows a direction of the world, and where: (0, 0) is its upper left corner.
///
/// The faces are those of OpenGL with y up, seen from inside: +Z is in front, +X on its right, +Y above. As three.js shows them, in
/// a world of y up that becomes this one as meshes do, +Z looks along −y and +X along −x.
fn place(direction: Vec3) -> (usize, Vec2) {
    let file = Vec3::new(-direction.x, direction.z, -direction.y);
    let size = file.abs();
    // The table of OpenGL 4.6, § 8.13.
    let (face, s, t, major) = if size.x >= size.y && size.x >= size.z {
        match file.x > 0.0 {
            true => (0, -file.z, -file.y, size.x),
            false => (1, file.z, -file.y, size.x),
        }
    } else if size.y >= size.z {
        match file.y > 0.0 {
            true => (2, file.x, file.z, size.y),
            false => (3, file.x, -file.z, size.y),
        }
    } else {
        match file.z > 0.0 {
            true => (4, file.x, -file.y, size.z),
            false => (5, -file.x, -file.y, size.z),
        }
    };
    let uv = (Vec2::new(s, t) / major + 1.0) * 0.5;
    (face, uv.clamp(Vec2::ZERO, Vec2::ONE))
}

#[cfg(test)]
mod tests {
    use super::*;
    use glimt_probe::latlong;

    /// The direction of the middle of a face's texel: what [`place`] inverts.
    fn direction(face: usize, at: UVec2, side: u32) -> Vec3 {
        let Vec2 { x: s, y: t } = (at.as_vec2() + 0.5) / side as f32 * 2.0 - 1.0;
        let file = [
            Vec3::new(1.0, -t, -s),
            Vec3::new(-1.0, -t, s),
            Vec3::new(s, 1.0, t),
            Vec3::new(s, -1.0, -t),
            Vec3::new(s, -t, 1.0),
            Vec3::new(-s, -t, -1.0),
        ][face];
        Vec3::new(-file.x, -file.z, file.y).normalize()
    }

    /// Solid angle of a face's texel.
    fn solid_angle(at: UVec2, side: u32) -> f64 {
        let corner = |p: UVec2| {
            let x = 2.0 * f64::from(p.x) / f64::from(side) - 1.0;
            let y = 2.0 * f64::from(p.y) / f64::from(side) - 1.0;
            (x * y).atan2((x * x + y * y + 1.0).sqrt())
        };
        corner(at) + corner(at + 1) - corner(at + UVec2::new(1, 0)) - corner(at + UVec2::new(0, 1))
    }

    fn image(layout: Layout, side: u32, light: impl Fn(usize, UVec2) -> f32) -> (UVec2, Vec<Vec4>) {
        let size = layout.extent() * side;
        let mut texels = vec![Vec4::W; size.element_product() as usize];
        for (face, place) in layout.places().into_iter().enumerate() {
            for i in 0..side * side {
                let at = UVec2::new(i % side, i / side);
                let turned = layout == Layout::Standing && face == 5;
                let inside = if turned {
                    UVec2::splat(side - 1) - at
                } else {
                    at
                };
                texels[index(size, place * side + inside)] =
                    Vec3::splat(light(face, at)).extend(1.0);
            }
        }
        (size, texels)
    }

    const LAYOUTS: [Layout; 4] = [Layout::Row, Layout::Column, Layout::Lying, Layout::Standing];

    /// Light in all directions, more from one side, and a lamp: power and first moments over the sphere, by both maps.
    #[test]
    fn power_and_direction_are_kept() {
        let side = 16;
        let lamp = |face: usize, at: UVec2| {
            let d = direction(face, at, side);
            let lamp = face == 0 && at == UVec2::new(3, 5);
            1.0 + 0.5 * d.z - 0.3 * d.x + if lamp { 1000.0 } else { 0.0 }
        };
        let mut expected = [0.0_f64; 4];
        for face in 0..FACES {
            for i in 0..side * side {
                let at = UVec2::new(i % side, i / side);
                let d = direction(face, at, side).as_dvec3();
                let energy = f64::from(lamp(face, at)) * solid_angle(at, side);
                let moments = [1.0, d.x, d.y, d.z].map(|m| m * energy);
                expected = std::array::from_fn(|m| expected[m] + moments[m]);
            }
        }
        for layout in LAYOUTS {
            let (size, texels) = image(layout, side, lamp);
            let (out, map) = cube_to_latlong(size, layout, side, &texels);
            let mut sums = [0.0_f64; 4];
            for (i, texel) in map.iter().enumerate() {
                let at = UVec2::new(i as u32 % out.x, i as u32 / out.x);
                let d = latlong::texel_direction(at, out).as_dvec3();
                let energy =
                    f64::from(texel.x) * f64::from(latlong::texel_solid_angle_sr(at.y, out));
                let moments = [1.0, d.x, d.y, d.z].map(|m| m * energy);
                sums = std::array::from_fn(|m| sums[m] + moments[m]);
            }
            for m in 0..4 {
                let error = (sums[m] - expected[m]).abs() / expected[0];
                assert!(error < 5e-3, "{layout:?} {m}: {sums:?} {expected:?}");
            }
        }
    }

    #[test]
    fn one_light_everywhere_stays_exact() {
        for layout in LAYOUTS {
            let (size, texels) = image(layout, 8, |_, _| 0.7);
            assert_eq!(Layout::of(size), Some((layout, 8)));
            let (_, map) = cube_to_latlong(size, layout, 8, &texels);
            let all = map.iter().all(|t| (t.x - 0.7).abs() < 1e-6);
            assert!(all, "{layout:?}");
        }
    }

    #[test]
    fn faces_are_seen_from_inside() {
        // In front is −y, on the right −x, above +z; the left of the front face meets the right of −X.
        let middle = Vec2::splat(0.5);
        assert_eq!(place(Vec3::NEG_Y), (4, middle));
        assert_eq!(place(Vec3::NEG_X), (0, middle));
        assert_eq!(place(Vec3::Z), (2, middle));
        assert_eq!(place(Vec3::X), (1, middle));
        let (face, uv) = place(Vec3::new(-0.5, -1.0, 0.25));
        // Toward the right and up.
        assert!(face == 4 && uv.x > 0.5 && uv.y < 0.5, "{face} {uv}");
        for face in 0..FACES {
            for i in 0..16 {
                let at = UVec2::new(i % 4, i / 4);
                let (found, uv) = place(direction(face, at, 4));
                assert_eq!((found, (uv * 4.0).as_uvec2()), (face, at));
            }
        }
    }

    #[test]
    fn crosses_have_blank_corners_and_photographs_none() {
        for layout in [Layout::Lying, Layout::Standing] {
            let (size, mut texels) = image(layout, 4, |face, at| (face * 16) as f32 + at.x as f32);
            assert!(has_blank_corners(size, &texels));
            texels[1] = Vec4::ONE;
            assert!(!has_blank_corners(size, &texels));
        }
    }
}
