//! Host file: a square angular map resampled into a lat-long map.

use glam::{UVec2, Vec2, Vec4};
use glimt_probe::{angular, latlong};
use rayon::prelude::*;

/// Taps along each side of a lat-long texel. Near the disc's rim many pixels fall into one texel; a lamp must not fall
/// between the taps.
const TAPS: u32 = 4;

/// Resamples a square angular map into a lat-long map of twice its width and of its height.
pub(super) fn angular_to_latlong(size: UVec2, texels: &[Vec4]) -> (UVec2, Vec<Vec4>) {
    let out = UVec2::new(2 * size.x, size.x);
    let weight = 1.0 / (TAPS * TAPS) as f32;
    let texel = |index: u32| -> Vec4 {
        let corner = UVec2::new(index % out.x, index / out.x).as_vec2();
        let mut sum = Vec4::ZERO;
        for tap in 0..TAPS * TAPS {
            let inside = (UVec2::new(tap % TAPS, tap / TAPS).as_vec2() + 0.5) / TAPS as f32;
            let direction = latlong::uv_to_direction((corner + inside) / out.as_vec2());
            sum += bilinear_in_disc(size, texels, angular::direction_to_uv(direction));
        }
        (sum * weight).truncate().extend(1.0)
    };
    let map = (0..out.x * out.y).into_par_iter().map(texel).collect();
    (out, map)
}

/// Bilinear look-up that takes no part of the corners outside the disc, which show nothing.
fn bilinear_in_disc(size: UVec2, texels: &[Vec4], uv: Vec2) -> Vec4 {
    let p = uv * size.as_vec2() - 0.5;
    let low = p.floor();
    let f = p - low;
    let (mut sum, mut total) = (Vec4::ZERO, 0.0);
    for (dx, dy, w) in [
        (0.0, 0.0, (1.0 - f.x) * (1.0 - f.y)),
        (1.0, 0.0, f.x * (1.0 - f.y)),
        (0.0, 1.0, (1.0 - f.x) * f.y),
        (1.0, 1.0, f.x * f.y),
    ] {
        let q = (low + Vec2::new(dx, dy)).clamp(Vec2::ZERO, size.as_vec2() - 1.0);
        let centre = (q + 0.5) / size.as_vec2();
        if angular::uv_to_direction(centre).is_some() {
            let index = q.y as usize * size.x as usize + q.x as usize;
            sum += texels[index] * w;
            total += w;
        }
    }
    if total > 0.0 {
        sum / total
    } else {
        nearest(size, texels, uv)
    }
}

/// At the rim all four neighbours may lie outside: the pixel under the point itself is then as near as any.
fn nearest(size: UVec2, texels: &[Vec4], uv: Vec2) -> Vec4 {
    let q = (uv * size.as_vec2()).as_uvec2().min(size - 1);
    texels[(q.y * size.x + q.x) as usize]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Red ahead (+x), green behind; up is brighter than down.
    #[test]
    fn an_angular_map_keeps_its_directions() {
        let size = UVec2::splat(64);
        let texels: Vec<Vec4> = (0..64 * 64)
            .map(|i| {
                let uv = (UVec2::new(i % 64, i / 64).as_vec2() + 0.5) / 64.0;
                match angular::uv_to_direction(uv) {
                    Some(d) => Vec4::new(d.x.max(0.0), (-d.x).max(0.0), 0.5 + 0.5 * d.z, 1.0),
                    None => Vec4::splat(1e9),
                }
            })
            .collect();
        let (out, map) = angular_to_latlong(size, &texels);
        assert_eq!(out, UVec2::new(128, 64));
        for (i, texel) in map.iter().enumerate() {
            let at = UVec2::new(i as u32 % out.x, i as u32 / out.x);
            let d = latlong::texel_direction(at, out);
            let expected = Vec4::new(d.x.max(0.0), (-d.x).max(0.0), 0.5 + 0.5 * d.z, 1.0);
            let difference = (*texel - expected).abs().max_element();
            assert!(difference < 0.06, "{at}: {texel} is not {expected}");
        }
    }
}
