//! Host file: coordinates far from the origin, as those of surveys, which 32 bits do not hold.

use crate::notes::Notes;
use glam::{DVec3, Vec3};
use std::path::Path;

/// A mesh keeps its own origin where it lies further away than so many times its size: 32 bits would leave less than 18 bits
/// for the mesh itself.
const FAR: f64 = 64.0;

/// The point to which positions are best taken relative: their middle where they lie far away, otherwise the file's own origin.
/// Those that are not finite do not count.
pub fn of(positions: &[DVec3]) -> DVec3 {
    let mut low = DVec3::INFINITY;
    let mut high = DVec3::NEG_INFINITY;
    for p in positions.iter().filter(|p| p.is_finite()) {
        low = low.min(*p);
        high = high.max(*p);
    }
    let reach = low.abs().max(high.abs()).max_element();
    let size = (high - low).max_element();
    match size > 0.0 && reach > FAR * size && reach.is_finite() {
        true => 0.5 * low + 0.5 * high,
        false => DVec3::ZERO,
    }
}

/// Positions relative to an origin, in 32 bits; says so where it is not the file's.
pub fn relative(positions: &[DVec3], origin: DVec3, file: &Path, notes: &mut Notes) -> Vec<Vec3> {
    if origin != DVec3::ZERO {
        let DVec3 { x, y, z } = origin;
        let what = format!(
            "its coordinates lie far from the origin, around ({x:.0}, {y:.0}, {z:.0}), and are taken from there in 32 bits; \
             `translate` may move it back without loss"
        );
        notes.note(file, what);
        say_if_rounded(positions, origin, file, notes);
    }
    positions.iter().map(|p| (*p - origin).as_vec3()).collect()
}

/// Warns where a file itself has only 32 bits for coordinates far away, so that its details are lost already.
fn say_if_rounded(positions: &[DVec3], origin: DVec3, file: &Path, notes: &mut Notes) {
    if positions.iter().any(|p| p.as_vec3().as_dvec3() != *p) {
        return;
    }
    let step = origin.abs().max_element() * f64::from(f32::EPSILON);
    let size = positions.iter().map(|p| (*p - origin).abs().max_element());
    if step * 4096.0 > size.fold(0.0, f64::max) {
        let what = format!(
            "its coordinates are 32-bit numbers, which are {step} apart so far from the origin; details are lost: export it with \
             64 bits, or nearer to the origin"
        );
        notes.warn(file, what);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_near_keeps_the_files_origin() {
        let near = [DVec3::ZERO, DVec3::splat(1.0)];
        assert_eq!(of(&near), DVec3::ZERO);
        let beside = near.map(|p| p + DVec3::X * 50.0);
        assert_eq!(of(&beside), DVec3::ZERO);
        assert_eq!(of(&[]), DVec3::ZERO);
        assert_eq!(of(&[DVec3::splat(1e6)]), DVec3::ZERO);
        assert_eq!(of(&[DVec3::NAN, DVec3::INFINITY]), DVec3::ZERO);
    }

    #[test]
    fn what_is_far_keeps_its_millimetres() {
        let middle = DVec3::new(4_500_000.5, 600_000.25, 100.0);
        let far = [-1.0, 0.001, 1.0].map(|x| middle + DVec3::X * x);
        let origin = of(&far);
        assert_eq!(origin, middle);
        let mut notes = Notes::default();
        let kept = relative(&far, origin, Path::new("a"), &mut notes);
        assert!((kept[1].x - 0.001).abs() < 1e-8, "{}", kept[1]);
        assert_eq!(notes.take().len(), 1);
    }
}
