//! Host file: polygons cut into triangles.

use earcut::Earcut;
use glam::{DVec2, DVec3};

/// Polygons of more corners than this are taken as fans: the library counts in 32 bits.
const MOST_CORNERS: usize = 1 << 24;

/// Cuts polygons into triangles, and keeps its lists from one to the next.
pub struct Triangulator {
    ears: Earcut<f64>,
    plane: Vec<DVec2>,
    points: Vec<[f64; 2]>,
    cut: Vec<u32>,
    /// Polygons so far that cross themselves. Their triangles do not have the outline's area.
    pub crossing: usize,
}

impl Default for Triangulator {
    fn default() -> Self {
        Self {
            ears: Earcut::new(),
            plane: Vec::new(),
            points: Vec::new(),
            cut: Vec::new(),
            crossing: 0,
        }
    }
}

impl Triangulator {
    /// Triangles of a polygon, each three places in `corners`, in the polygon's sense. Those of a convex polygon are a fan about
    /// the first corner; a concave one is cut along ears, seen along its mean normal. Fewer than three corners have none. A
    /// polygon without an area, or with coordinates that are not finite, gives a fan.
    pub fn polygon(&mut self, corners: &[DVec3], mut push: impl FnMut([u32; 3])) {
        let count = corners.len() as u32;
        let fan = |first: u32| {
            (1..count.max(2) - 1).map(move |i| [0, i, i + 1].map(|c| (c + first) % count))
        };
        if count <= 3 {
            return fan(0).for_each(push);
        }
        let normal = newell(corners);
        let total = normal.length();
        let reach = corners.iter().map(|p| p.distance_squared(corners[0]));
        let least = 1e-12 * reach.fold(0.0, f64::max);
        if !(total > least && total.is_finite()) || corners.len() > MOST_CORNERS {
            return fan(0).for_each(push);
        }
        let (right, up) = (normal / total).any_orthonormal_pair();
        // So that the outline runs counter-clockwise.
        let flip = right.cross(up).dot(normal).signum();
        self.plane.clear();
        let flat =
            |p: &DVec3| DVec2::new(right.dot(*p - corners[0]), flip * up.dot(*p - corners[0]));
        self.plane.extend(corners.iter().map(flat));
        let plane = &self.plane;
        let area = |[a, b, c]: [u32; 3]| {
            let [a, b, c] = [a, b, c].map(|i| plane[i as usize]);
            (b - a).perp_dot(c - a)
        };
        let tries = if count == 4 { 2 } else { 1 };
        if let Some(first) = (0..tries).find(|&first| fan(first).all(|t| area(t) > 1e-12 * total)) {
            return fan(first).for_each(push);
        }
        self.points.clear();
        self.points.extend(plane.iter().map(|p| p.to_array()));
        self.ears.earcut_slice(&self.points, &[], &mut self.cut);
        let mut covered = 0.0;
        let (triangles, _) = self.cut.as_chunks::<3>();
        for &[a, b, c] in triangles {
            let twice = area([a, b, c]);
            covered += twice.abs();
            match twice < 0.0 {
                true => push([a, c, b]),
                false => push([a, b, c]),
            }
        }
        if !((covered - total).abs() <= 1e-3 * total) {
            self.crossing += 1;
        }
        if triangles.is_empty() {
            fan(0).for_each(push);
        }
    }
}

/// Newell's normal of a polygon: of the length of twice its area, and the mean one where it is not flat.
pub fn newell(corners: &[DVec3]) -> DVec3 {
    let Some((&first, rest)) = corners.split_first() else {
        return DVec3::ZERO;
    };
    let sides = rest.windows(2);
    sides.map(|s| (s[0] - first).cross(s[1] - first)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    fn triangles(corners: &[DVec3]) -> (Vec<[u32; 3]>, usize) {
        let mut cutter = Triangulator::default();
        let mut list = Vec::new();
        cutter.polygon(corners, |t| list.push(t));
        (list, cutter.crossing)
    }

    /// On a plane that is not one of the axes'.
    fn tilted(points: &[[f64; 2]]) -> Vec<DVec3> {
        let (right, up) = (
            DVec3::new(1.0, 2.0, 2.0) / 3.0,
            DVec3::new(2.0, 1.0, -2.0) / 3.0,
        );
        let at = |p: &[f64; 2]| DVec3::new(7.0, -3.0, 5.0) + p[0] * right + p[1] * up;
        points.iter().map(at).collect()
    }

    /// The areas of all triangles point as the polygon's does, and have its sum.
    fn covers(points: &[[f64; 2]], area: f64) {
        for reversed in [false, true] {
            let mut corners = tilted(points);
            if reversed {
                corners.reverse();
            }
            let normal = newell(&corners);
            assert!((0.5 * normal.length() - area).abs() < 1e-9);
            let (list, crossing) = triangles(&corners);
            let mut sum = 0.0;
            for t in &list {
                let [a, b, c] = t.map(|i| corners[i as usize]);
                let along = 0.5 * (b - a).cross(c - a).dot(normal.normalize());
                assert!(along > 0.0, "{t:?}");
                sum += along;
            }
            assert!((sum - area).abs() < 1e-9, "{sum} {area}");
            assert_eq!(crossing, 0);
        }
    }

    #[test]
    fn concave_polygons_keep_their_area() {
        // A C of three bars, and an arrow whose second or third corner is the reflex one.
        covers(
            &[
                [0.0, 0.0],
                [3.0, 0.0],
                [3.0, 1.0],
                [1.0, 1.0],
                [1.0, 2.0],
                [3.0, 2.0],
                [3.0, 3.0],
                [0.0, 3.0],
            ],
            7.0,
        );
        covers(
            &[[0.0, 0.0], [2.0, -1.0], [0.5, 0.0], [2.0, 1.0]],
            0.5 * 0.5 * 2.0,
        );
        covers(&[[2.0, 1.0], [0.0, 0.0], [2.0, -1.0], [0.5, 0.0]], 0.5);
        // A star of five points: ten triangles from its centre.
        let radius = |i: usize| if i.is_multiple_of(2) { 1.0 } else { 0.4 };
        let at = |i: usize| {
            let angle = i as f64 / 10.0 * TAU;
            [radius(i) * angle.cos(), radius(i) * angle.sin()]
        };
        covers(
            &(0..10).map(at).collect::<Vec<_>>(),
            10.0 * 0.5 * 0.4 * (TAU / 10.0).sin(),
        );
        // A hole, which the outline reaches by a bridge and leaves by it.
        let square = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [0.0, 0.0]];
        let hole = [[1.0, 1.0], [1.0, 3.0], [3.0, 3.0], [3.0, 1.0], [1.0, 1.0]];
        covers(&[square, hole].concat(), 12.0);
    }

    #[test]
    fn convex_polygons_are_fans() {
        let square = tilted(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
        assert_eq!(triangles(&square).0, [[0, 1, 2], [0, 2, 3]]);
        let regular = |n: usize| {
            let at = |i: usize| {
                [
                    (i as f64 / n as f64 * TAU).cos(),
                    (i as f64 / n as f64 * TAU).sin(),
                ]
            };
            tilted(&(0..n).map(at).collect::<Vec<_>>())
        };
        assert_eq!(triangles(&regular(5)).0, [[0, 1, 2], [0, 2, 3], [0, 3, 4]]);
    }

    #[test]
    fn a_middle_of_a_side_is_a_corner_of_no_empty_triangle() {
        covers(
            &[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]],
            4.0,
        );
    }

    #[test]
    fn odd_polygons() {
        assert!(triangles(&tilted(&[[0.0, 0.0], [1.0, 0.0]])).0.is_empty());
        assert!(triangles(&[]).0.is_empty());
        // All corners in one line.
        let line = tilted(&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [3.0, 0.0]]);
        assert_eq!(triangles(&line).0.len(), 2);
        let nan = [DVec3::NAN; 5];
        assert_eq!(triangles(&nan).0.len(), 3);
        // Two loops of different size, wound against each other.
        let bow = tilted(&[[0.0, 0.0], [3.0, 3.0], [3.0, 0.0], [0.0, 1.0]]);
        assert_eq!(triangles(&bow).1, 1);
    }
}
