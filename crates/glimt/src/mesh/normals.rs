//! Host file: shading normals of meshes whose files have none.
//!
//! Faces that share an edge are smooth across it or not: by the angle between them, by the smoothing groups of a file, or never.
//! Around each point of a mesh, faces that smooth edges connect share one normal, the mean of theirs by area. So the work grows
//! with the number of corners, however many faces meet in a point.

use super::joiner::{Joiner, pick};
use glam::{DVec3, Vec3};
use glimt_render_gpu::prepare::scene::Mesh;
use rayon::prelude::*;
use std::ops::Range;

/// Where more faces than this share one edge, each is compared with the next alone.
const CROWDED: usize = 16;

/// Points that one thread takes at a time.
const CHUNK: usize = 1 << 14;

/// A corner of a face: its face, and the face's corners before and after it.
#[derive(Clone, Copy, Debug)]
pub struct Corner {
    /// Index of the face.
    pub face: u32,
    /// Index of the corner before it.
    pub before: u32,
    /// Index of the corner after it.
    pub after: u32,
}

/// A face at an edge: its index, and its normal with the length of its area.
pub type Side = (u32, DVec3);

/// Normals that were made.
#[derive(Debug, Default)]
pub struct Made {
    /// The normal of each corner, as an index into `normals`.
    pub of_corner: Vec<u32>,
    /// Unit vectors; +z where the faces have no area.
    pub normals: Vec<Vec3>,
}

/// Gives each face of a mesh its own normal. Vertices are split where faces differ; texture coordinates and colours follow, and
/// tangents are dropped, since they belong to other normals. Vertices that no triangle uses are dropped. Returns for each vertex which
/// one it was before. A mesh with an index out of range is left as it is.
pub fn flat(mesh: &mut Mesh) -> Vec<u32> {
    remake(mesh, |_, _| false)
}

/// As [`flat`], but faces share normals across edges at which they are turned by less than `crease_deg` degrees against each other.
/// Vertices in the same place count as one point, so a seam of texture coordinates is not a crease.
pub fn creased(mesh: &mut Mesh, crease_deg: f32) -> Vec<u32> {
    let least = cosine(crease_deg);
    remake(mesh, |a, b| is_smooth(a.1, b.1, least))
}

/// The cosine that [`is_smooth`] takes of an angle in degrees. At 180 all edges are smooth, at 0 none but those in a plane.
pub fn cosine(crease_deg: f32) -> f64 {
    match crease_deg {
        // Rounding leaves faces of one plane some 1e-7 apart.
        small if small < 0.1 => 1.0 - 1e-6,
        large if large >= 180.0 => f64::NEG_INFINITY,
        angle => f64::from(angle).to_radians().cos(),
    }
}

/// Whether two faces are turned against each other by less than an angle of that cosine. Faces without area are smooth to all.
pub fn is_smooth(a: DVec3, b: DVec3, least_cosine: f64) -> bool {
    let lengths = (a.length_squared() * b.length_squared()).sqrt();
    !(a.dot(b) < least_cosine * lengths)
}

/// For each position the first that equals it: vertices of one point have one name.
pub fn points(positions: &[Vec3]) -> Vec<u32> {
    // Adding 0 makes +0 of −0.
    let bits = |p: &Vec3| (*p + Vec3::ZERO).to_array().map(f32::to_bits);
    let mut sorted: Vec<([u32; 3], u32)> = positions.iter().map(bits).zip(0..).collect();
    sorted.par_sort_unstable();
    let mut first = vec![0; positions.len()];
    for same in sorted.chunk_by(|a, b| a.0 == b.0) {
        for (_, index) in same {
            first[*index as usize] = same[0].1;
        }
    }
    first
}

/// Makes normals: `points` is the point of each corner, below `count`; `corner` says how corners lie in faces, `area` is the normal
/// of a face with the length of its area, and `joined` says whether two faces that share an edge are smooth across it.
pub fn make(
    points: &[u32],
    count: usize,
    corner: impl Fn(u32) -> Corner + Sync,
    area: impl Fn(u32) -> DVec3 + Sync,
    joined: impl Fn(Side, Side) -> bool + Sync,
) -> Made {
    let (starts, corners) = by_point(points, count);
    let around = Around {
        points,
        corner,
        area,
        joined,
    };
    let work = |points: Range<usize>| {
        let mut groups = Vec::new();
        let mut normals = Vec::new();
        let mut fan = Fan::default();
        for point in points {
            let list = &corners[starts[point] as usize..starts[point + 1] as usize];
            fan.group(list, &around);
            groups.extend(fan.groups.iter().map(|group| group + normals.len() as u32));
            let unit = |sum: &DVec3| sum.try_normalize().map_or(Vec3::Z, |n| n.as_vec3());
            normals.extend(fan.sums.iter().map(unit));
        }
        (groups, normals)
    };
    let chunks: Vec<_> = (0..count.div_ceil(CHUNK))
        .into_par_iter()
        .map(|chunk| work(chunk * CHUNK..((chunk + 1) * CHUNK).min(count)))
        .collect();
    let mut made = Made {
        of_corner: vec![0; points.len()],
        normals: Vec::with_capacity(chunks.iter().map(|chunk| chunk.1.len()).sum()),
    };
    let mut next = corners.iter();
    for (groups, normals) in chunks {
        let before = made.normals.len() as u32;
        for (group, corner) in groups.iter().zip(&mut next) {
            made.of_corner[*corner as usize] = before + group;
        }
        made.normals.extend(normals);
    }
    made
}

/// The corners at each point: those of point p are the second list's from the first list's p to its p + 1.
fn by_point(points: &[u32], count: usize) -> (Vec<u32>, Vec<u32>) {
    let mut starts = vec![0; count + 1];
    for &point in points {
        starts[point as usize] += 1;
    }
    let mut total = 0;
    for start in &mut starts {
        total += *start;
        *start = total;
    }
    let mut corners = vec![0; points.len()];
    for (corner, &point) in points.iter().enumerate().rev() {
        let start = &mut starts[point as usize];
        *start -= 1;
        corners[*start as usize] = corner as u32;
    }
    (starts, corners)
}

/// What surrounds points.
struct Around<'a, C, A, J> {
    points: &'a [u32],
    corner: C,
    area: A,
    joined: J,
}

/// The faces around one point.
#[derive(Default)]
struct Fan {
    sides: Vec<Side>,
    /// The points at the other ends of its edges, with the index of a side.
    edges: Vec<(u32, u32)>,
    /// For each side one that it is joined to, in the end the group's least.
    leader: Vec<u32>,
    /// The group of each corner.
    groups: Vec<u32>,
    /// The areas of each group.
    sums: Vec<DVec3>,
}

impl Fan {
    fn group<C, A, J>(&mut self, list: &[u32], around: &Around<'_, C, A, J>)
    where
        C: Fn(u32) -> Corner,
        A: Fn(u32) -> DVec3,
        J: Fn(Side, Side) -> bool,
    {
        self.sides.clear();
        self.edges.clear();
        self.leader.clear();
        for (side, &index) in (0..).zip(list) {
            let corner = (around.corner)(index);
            self.sides.push((corner.face, (around.area)(corner.face)));
            self.leader.push(side);
            for end in [corner.before, corner.after] {
                self.edges.push((around.points[end as usize], side));
            }
        }
        self.edges.sort_unstable();
        let mut from = 0;
        while from < self.edges.len() {
            let end = self.edges[from].0;
            let same = self.edges[from..].iter().take_while(|e| e.0 == end);
            let to = from + same.count();
            for a in from..to {
                let last = if to - from > CROWDED { a + 2 } else { to };
                for b in a + 1..last.min(to) {
                    self.join(self.edges[a].1, self.edges[b].1, &around.joined);
                }
            }
            from = to;
        }
        self.groups.clear();
        self.sums.clear();
        for side in 0..self.sides.len() {
            let leader = self.find(side as u32) as usize;
            let group = match leader == side {
                true => {
                    self.sums.push(DVec3::ZERO);
                    self.sums.len() as u32 - 1
                }
                false => self.groups[leader],
            };
            self.groups.push(group);
            self.sums[group as usize] += self.sides[side].1;
        }
    }

    fn join(&mut self, a: u32, b: u32, joined: impl Fn(Side, Side) -> bool) {
        let (first, second) = (self.find(a), self.find(b));
        if first != second && joined(self.sides[a as usize], self.sides[b as usize]) {
            self.leader[first.max(second) as usize] = first.min(second);
        }
    }

    fn find(&mut self, mut side: u32) -> u32 {
        while self.leader[side as usize] != side {
            let above = self.leader[self.leader[side as usize] as usize];
            self.leader[side as usize] = above;
            side = above;
        }
        side
    }
}

/// The area of a triangle as a vector along its normal, in f64 so that small triangles keep theirs.
fn area(positions: &[Vec3], triangle: [u32; 3]) -> DVec3 {
    let [a, b, c] = triangle.map(|i| positions[i as usize].as_dvec3());
    0.5 * (b - a).cross(c - a)
}

fn remake(mesh: &mut Mesh, joined: impl Fn(Side, Side) -> bool + Sync) -> Vec<u32> {
    let count = mesh.positions.len();
    let corners = mesh.indices.as_flattened();
    if corners.iter().any(|i| *i as usize >= count) {
        return (0..count as u32).collect();
    }
    let first = points(&mesh.positions);
    let points: Vec<u32> = corners.iter().map(|i| first[*i as usize]).collect();
    let corner = |index: u32| {
        let (face, place) = (index / 3, index % 3);
        Corner {
            face,
            before: 3 * face + (place + 2) % 3,
            after: 3 * face + (place + 1) % 3,
        }
    };
    let area = |face: u32| area(&mesh.positions, mesh.indices[face as usize]);
    let made = make(&points, count, corner, area, joined);
    split(mesh, &made)
}

/// Gives each corner of a mesh its normal. A vertex whose corners have several becomes as many.
fn split(mesh: &mut Mesh, made: &Made) -> Vec<u32> {
    let mut joiner = Joiner::new(mesh.positions.len());
    let corners = mesh.indices.as_flattened_mut();
    for (corner, normal) in corners.iter_mut().zip(&made.of_corner) {
        *corner = joiner.vertex(*corner, made.normals[*normal as usize]);
    }
    mesh.positions = pick(&mesh.positions, &joiner.points);
    mesh.uvs = pick(&mesh.uvs, &joiner.points);
    mesh.colors = pick(&mesh.colors, &joiner.points);
    mesh.tangents.clear();
    mesh.normals = joiner.kinds;
    joiner.points
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::{Vec2, Vec4};
    use std::f32::consts::TAU;

    /// A prism over a regular polygon, without lids: its sides are turned by 360°/n.
    fn prism(n: u32) -> Mesh {
        let ring = |z: f32| (0..n).map(move |i| (i as f32 / n as f32 * TAU, z));
        let place = |(angle, z): (f32, f32)| Vec3::new(angle.cos(), angle.sin(), z);
        let quad = |i: u32| {
            let j = (i + 1) % n;
            [[i, j, n + j], [i, n + j, n + i]]
        };
        Mesh {
            positions: ring(0.0).chain(ring(1.0)).map(place).collect(),
            indices: (0..n).flat_map(quad).collect(),
            ..Mesh::default()
        }
    }

    fn normals_of(mesh: &Mesh, point: Vec3) -> Vec<Vec3> {
        let pairs = mesh.positions.iter().zip(&mesh.normals);
        pairs.filter(|(p, _)| **p == point).map(|p| *p.1).collect()
    }

    #[test]
    fn an_edge_is_smooth_below_the_angle_and_sharp_above() {
        // Sides of 12 are turned by 30° against each other.
        for (crease, sharp) in [(0.0, true), (29.0, true), (31.0, false), (180.0, false)] {
            let mut mesh = prism(12);
            creased(&mut mesh, crease);
            let at = normals_of(&mesh, Vec3::X);
            if sharp {
                assert_eq!(at.len(), 2, "{crease}");
                let between = at[0].dot(at[1]).acos().to_degrees();
                assert!((between - 30.0).abs() < 0.01, "{between}");
            } else {
                // Two triangles on one side and one on the other: the mean is 10° from +x towards the former, by area.
                assert_eq!(at.len(), 1, "{crease}");
                let off = at[0].x.acos().to_degrees();
                let exact = (15f32.to_radians().tan() / 3.0).atan().to_degrees();
                assert!((off - exact).abs() < 0.01, "{off} {exact}");
            }
        }
    }

    #[test]
    fn flat_faces_have_their_own_normals_and_all_else_follows() {
        let mut mesh = prism(4);
        mesh.uvs = (0..8).map(|i| Vec2::splat(i as f32)).collect();
        mesh.colors = (0..8).map(|i| Vec4::splat(i as f32)).collect();
        mesh.tangents = vec![Vec4::X; 8];
        let before = mesh.clone();
        let sources = flat(&mut mesh);
        // Two triangles of a side have equal normals, so each corner of the prism has two.
        assert_eq!(mesh.positions.len(), 16);
        assert!(mesh.tangents.is_empty());
        for (vertex, &source) in sources.iter().enumerate() {
            let source = source as usize;
            assert_eq!(mesh.positions[vertex], before.positions[source]);
            assert_eq!(mesh.uvs[vertex], before.uvs[source]);
            assert_eq!(mesh.colors[vertex], before.colors[source]);
        }
        for (triangle, old) in mesh.indices.iter().zip(&before.indices) {
            let along = super::area(&before.positions, *old).normalize().as_vec3();
            for (vertex, old) in triangle.iter().zip(old) {
                assert_eq!(sources[*vertex as usize], *old);
                assert!(mesh.normals[*vertex as usize].abs_diff_eq(along, 1e-6));
            }
        }
    }

    #[test]
    fn a_seam_is_not_a_crease() {
        // The two sides that meet at +x have vertices of their own there.
        let mut mesh = prism(24);
        let copy = mesh.positions.len() as u32;
        mesh.positions.push(mesh.positions[0]);
        mesh.positions.push(mesh.positions[24]);
        for corner in mesh.indices[46..].as_flattened_mut() {
            match *corner {
                0 => *corner = copy,
                24 => *corner = copy + 1,
                _ => {}
            }
        }
        creased(&mut mesh, 40.0);
        let at = normals_of(&mesh, Vec3::X);
        assert_eq!(at.len(), 2);
        assert_eq!(at[0], at[1]);
    }

    /// Two triangles in one plane and a third that stands on their edge.
    #[test]
    fn where_three_faces_meet_those_in_a_plane_are_smooth() {
        let mut mesh = Mesh {
            positions: vec![Vec3::ZERO, Vec3::Y, Vec3::X, Vec3::Z, Vec3::NEG_X],
            indices: vec![[0, 2, 1], [0, 3, 1], [0, 1, 4]],
            ..Mesh::default()
        };
        creased(&mut mesh, 40.0);
        assert_eq!(normals_of(&mesh, Vec3::ZERO).len(), 2);
        assert_eq!(mesh.normals[mesh.indices[0][0] as usize], Vec3::Z);
        assert_eq!(mesh.normals[mesh.indices[2][0] as usize], Vec3::Z);
    }

    #[test]
    fn thousands_of_equal_triangles_and_a_wide_fan_take_no_time() {
        let mut same = Mesh {
            positions: vec![Vec3::ZERO, Vec3::X, Vec3::Y],
            indices: vec![[0, 1, 2]; 300_000],
            ..Mesh::default()
        };
        let n = 300_000;
        let rim = |i: u32| (i as f32 / n as f32 * TAU).sin_cos();
        let mut cone = Mesh {
            positions: (0..n).map(rim).map(|(y, x)| Vec3::new(x, y, 0.0)).collect(),
            indices: (0..n).map(|i| [i, (i + 1) % n, n]).collect(),
            ..Mesh::default()
        };
        cone.positions.push(Vec3::Z);
        let began = std::time::Instant::now();
        creased(&mut same, 40.0);
        creased(&mut cone, 40.0);
        // Work that grows with the square of their number takes minutes.
        assert!(began.elapsed().as_secs_f32() < 60.0);
        assert_eq!(same.positions.len(), 3);
        let top = normals_of(&cone, Vec3::Z);
        assert!(top.len() == 1 && top[0].abs_diff_eq(Vec3::Z, 1e-4));
    }

    #[test]
    fn broken_indices_and_empty_meshes_are_left_alone() {
        let mut mesh = Mesh {
            positions: vec![Vec3::ZERO; 2],
            indices: vec![[0, 1, 7]],
            ..Mesh::default()
        };
        assert_eq!(flat(&mut mesh), [0, 1]);
        assert!(mesh.normals.is_empty());
        assert!(creased(&mut Mesh::default(), 40.0).is_empty());
    }
}
