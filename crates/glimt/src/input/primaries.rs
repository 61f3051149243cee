//! Host file: colours from any primaries to those of Rec. 709.

use crate::notes::Notes;
use ::exr::meta::attribute::Chromaticities;
use glam::{DMat3, DVec3, Vec3, Vec4};
use std::path::Path;

/// The CIE xy coordinates of Rec. 709: red, green, blue, white (D65).
pub const REC_709: [[f32; 2]; 4] = [[0.64, 0.33], [0.3, 0.6], [0.15, 0.06], [0.3127, 0.329]];

fn points(c: Chromaticities) -> [[f32; 2]; 4] {
    [c.red, c.green, c.blue, c.white].map(|v| [v.x(), v.y()])
}

pub(super) fn is_rec_709(c: Chromaticities) -> bool {
    let near = |a: f32, b: f32| (a - b).abs() <= 1e-3;
    points(c)
        .iter()
        .zip(REC_709)
        .all(|(p, q)| near(p[0], q[0]) && near(p[1], q[1]))
}

/// RGB of the given primaries to CIE XYZ, white at Y = 1 (SMPTE RP 177-1993).
fn rgb_to_xyz(points: [[f32; 2]; 4]) -> DMat3 {
    let column = |p: [f32; 2]| {
        let (x, y) = (f64::from(p[0]), f64::from(p[1]));
        DVec3::new(x / y, 1.0, (1.0 - x - y) / y)
    };
    let primaries = DMat3::from_cols(column(points[0]), column(points[1]), column(points[2]));
    primaries * DMat3::from_diagonal(primaries.inverse() * column(points[3]))
}

/// The matrix to Rec. 709, whites adapted by the Bradford transform; `None` for impossible primaries.
fn matrix_to_rec_709(c: Chromaticities) -> Option<DMat3> {
    // From X, Y, Z (a column each) to the responses of long, medium and short cones.
    let bradford = DMat3::from_cols(
        DVec3::new(0.8951, -0.7502, 0.0389),
        DVec3::new(0.2664, 1.7135, -0.0685),
        DVec3::new(-0.1614, 0.0367, 1.0296),
    );
    let source = rgb_to_xyz(points(c));
    let target = rgb_to_xyz(REC_709);
    let gain = (bradford * (target * DVec3::ONE)) / (bradford * (source * DVec3::ONE));
    let adapt = bradford.inverse() * DMat3::from_diagonal(gain) * bradford;
    let matrix = target.inverse() * adapt * source;
    matrix.is_finite().then_some(matrix)
}

pub(super) fn luminance_weights(c: Option<Chromaticities>) -> Vec3 {
    let weights = rgb_to_xyz(c.map_or(REC_709, points)).row(1).as_vec3();
    if weights.is_finite() && weights.y > 0.0 {
        return weights;
    }
    Vec3::new(0.2126, 0.7152, 0.0722)
}

pub(super) fn to_rec_709(file: &Path, texels: &mut [Vec4], c: Chromaticities, notes: &mut Notes) {
    if is_rec_709(c) {
        return;
    }
    let Some(matrix) = matrix_to_rec_709(c) else {
        notes.warn(
            file,
            "its chromaticities are impossible; Rec. 709 is assumed",
        );
        return;
    };
    let mut outside = 0_usize;
    for texel in texels.iter_mut() {
        let colour = texel.truncate().as_dvec3();
        // A texel that is not light stays as it is, to be counted as such.
        if !(colour.min_element() >= 0.0 && colour.is_finite()) {
            continue;
        }
        let converted = matrix * colour;
        outside += usize::from(converted.min_element() < 0.0);
        *texel = converted.max(DVec3::ZERO).as_vec3().extend(1.0);
    }
    notes.note(file, "its primaries are converted to Rec. 709");
    if outside > 0 {
        notes.note(
            file,
            format!(
                "{outside} texels have colours outside Rec. 709; their negative channels are 0"
            ),
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use ::exr::math::Vec2;

    #[test]
    fn white_stays_white_and_rec_709_stays() {
        // ACES AP0, white near D60.
        let aces = Chromaticities {
            red: Vec2(0.7347, 0.2653),
            green: Vec2(0.0, 1.0),
            blue: Vec2(0.0001, -0.077),
            white: Vec2(0.32168, 0.33767),
        };
        let white = matrix_to_rec_709(aces).unwrap() * DVec3::ONE;
        assert!((white - DVec3::ONE).length() < 1e-4, "{white}");
        let [red, green, blue, white] = REC_709.map(|p| Vec2(p[0], p[1]));
        let own = Chromaticities {
            red,
            green,
            blue,
            white,
        };
        let matrix = matrix_to_rec_709(own).unwrap();
        assert!(matrix.abs_diff_eq(DMat3::IDENTITY, 1e-6));
        let weights = luminance_weights(None);
        assert!((weights - Vec3::new(0.2126, 0.7152, 0.0722)).length() < 1e-3);
    }
}
