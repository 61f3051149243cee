//! Host file: primaries of colours, their names, and the matrices from one set to another.

use glam::{DMat3, DVec3, Vec3};
use glimt_probe::gather::ColourMatrix;
use std::fmt;

/// CIE xy coordinates of red, green, blue and white.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Primaries(pub [[f32; 2]; 4]);

/// Rec. 709, also those of sRGB.
pub const REC_709: Primaries = Primaries([[0.64, 0.33], [0.3, 0.6], [0.15, 0.06], [0.3127, 0.329]]);
/// AP1, those of ACEScg.
pub const AP1: Primaries = Primaries([
    [0.713, 0.293],
    [0.165, 0.83],
    [0.128, 0.044],
    [0.32168, 0.33767],
]);
/// AP0, those of ACES2065-1.
pub const AP0: Primaries = Primaries([
    [0.7347, 0.2653],
    [0.0, 1.0],
    [0.0001, -0.077],
    [0.32168, 0.33767],
]);
/// Rec. 2020.
pub const REC_2020: Primaries = Primaries([
    [0.708, 0.292],
    [0.17, 0.797],
    [0.131, 0.046],
    [0.3127, 0.329],
]);
/// P3 with the white D65.
pub const P3_D65: Primaries =
    Primaries([[0.68, 0.32], [0.265, 0.69], [0.15, 0.06], [0.3127, 0.329]]);
/// Adobe RGB (1998).
pub const ADOBE_RGB: Primaries =
    Primaries([[0.64, 0.33], [0.21, 0.71], [0.15, 0.06], [0.3127, 0.329]]);

/// Those that have names.
const NAMED: [(&str, Primaries); 6] = [
    ("Rec. 709", REC_709),
    ("ACEScg (AP1)", AP1),
    ("ACES2065-1 (AP0)", AP0),
    ("Rec. 2020", REC_2020),
    ("P3-D65", P3_D65),
    ("Adobe RGB", ADOBE_RGB),
];

impl Primaries {
    /// Whether both are the same, as far as files that round their coordinates tell.
    #[must_use]
    pub fn is(&self, other: &Self) -> bool {
        let near = |a: f32, b: f32| (a - b).abs() <= 1e-3;
        let pairs = self.0.iter().zip(&other.0);
        pairs
            .into_iter()
            .all(|(p, q)| near(p[0], q[0]) && near(p[1], q[1]))
    }

    /// Whether a matrix to XYZ exists.
    #[must_use]
    pub fn are_possible(&self) -> bool {
        let matrix = self.to_xyz();
        // The luminance of white is 1, and each primary adds to it, or hardly takes from it (AP0's blue).
        let luminance = matrix.row(1);
        matrix.is_finite() && matrix.determinant().abs() > 1e-6 && luminance.min_element() > -0.5
    }

    /// RGB to CIE XYZ, white at Y = 1 (SMPTE RP 177-1993).
    fn to_xyz(self) -> DMat3 {
        let column = |p: [f32; 2]| {
            let (x, y) = (f64::from(p[0]), f64::from(p[1]));
            DVec3::new(x / y, 1.0, (1.0 - x - y) / y)
        };
        let [red, green, blue, white] = self.0;
        let primaries = DMat3::from_cols(column(red), column(green), column(blue));
        primaries * DMat3::from_diagonal(primaries.inverse() * column(white))
    }

    /// The matrix to other primaries, whites adapted by the Bradford transform; `None` where both are the same.
    #[must_use]
    pub fn matrix_to(&self, target: &Self) -> Option<DMat3> {
        if self.is(target) {
            return None;
        }
        // From X, Y, Z (a column each) to the responses of long, medium and short cones.
        let bradford = DMat3::from_cols(
            DVec3::new(0.8951, -0.7502, 0.0389),
            DVec3::new(0.2664, 1.7135, -0.0685),
            DVec3::new(-0.1614, 0.0367, 1.0296),
        );
        let (source, target) = (self.to_xyz(), target.to_xyz());
        let gain = (bradford * (target * DVec3::ONE)) / (bradford * (source * DVec3::ONE));
        let adapt = bradford.inverse() * DMat3::from_diagonal(gain) * bradford;
        let matrix = target.inverse() * adapt * source;
        matrix.is_finite().then_some(matrix)
    }

    /// As [`Primaries::matrix_to`], as kernels read it; the identity where both are the same.
    #[must_use]
    pub fn colour_matrix_to(&self, target: &Self) -> ColourMatrix {
        let matrix = self.matrix_to(target);
        matrix.map_or(ColourMatrix::IDENTITY, |m| {
            ColourMatrix::from_mat3(m.as_mat3())
        })
    }

    /// Luminance of red, green and blue; those of Rec. 709 for impossible primaries.
    #[must_use]
    pub fn luminance_weights(&self) -> Vec3 {
        let weights = self.to_xyz().row(1).as_vec3();
        if weights.is_finite() && weights.y > 0.0 {
            return weights;
        }
        Vec3::new(0.2126, 0.7152, 0.0722)
    }
}

impl fmt::Display for Primaries {
    /// Their name, or the coordinates of those that have none.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some((name, _)) = NAMED.iter().find(|(_, known)| self.is(known)) {
            return f.write_str(name);
        }
        let [r, g, b, w] = self.0.map(|[x, y]| format!("({x:.4}, {y:.4})"));
        write!(f, "R {r} G {g} B {b} W {w}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn matrices_are_the_published_ones() {
        // White stays white, whatever its chromaticity is.
        for (name, primaries) in NAMED {
            let Some(matrix) = primaries.matrix_to(&REC_709) else {
                continue;
            };
            let white = matrix * DVec3::ONE;
            assert!((white - DVec3::ONE).length() < 1e-4, "{name}: {white}");
        }
        assert_eq!(REC_709.matrix_to(&REC_709), None);
        // ITU-R BT.2087-0, Rec. 709 to Rec. 2020.
        let wide = REC_709.matrix_to(&REC_2020).unwrap().transpose();
        let published = DMat3::from_cols(
            DVec3::new(0.6274, 0.3293, 0.0433),
            DVec3::new(0.0691, 0.9195, 0.0114),
            DVec3::new(0.0164, 0.0880, 0.8956),
        );
        assert!(wide.abs_diff_eq(published, 1e-4), "{wide}");
        // TB-2014-004, AP0 to AP1: the whites are equal.
        let acescg = AP0.matrix_to(&AP1).unwrap() * DVec3::X;
        let published = DVec3::new(1.451_439_316_1, -0.076_553_773_4, 0.008_316_148_4);
        assert!(acescg.abs_diff_eq(published, 1e-5), "{acescg}");
        let weights = REC_709.luminance_weights();
        assert!((weights - Vec3::new(0.2126, 0.7152, 0.0722)).length() < 1e-3);
    }

    #[test]
    fn impossible_primaries_are_known() {
        assert!(NAMED.iter().all(|(_, p)| p.are_possible()));
        let line = Primaries([[0.6, 0.3], [0.4, 0.3], [0.2, 0.3], [0.3, 0.3]]);
        let zero = Primaries([[0.0; 2]; 4]);
        let nan = Primaries([[f32::NAN; 2]; 4]);
        assert!([line, zero, nan].iter().all(|p| !p.are_possible()));
    }
}
