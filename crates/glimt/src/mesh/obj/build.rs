//! Host file: one mesh of the lists of an OBJ file: polygons cut, missing normals made, equal corners joined.

use super::parse::{Corner, NONE, Parsed, Smoothing};
use crate::mesh::joiner::{Joiner, pick};
use crate::mesh::model::NormalCounts;
use crate::mesh::normals::{self, Side};
use crate::mesh::triangulate::{Triangulator, newell};
use glam::{DVec3, Vec2, Vec3};
use glimt_render_gpu::prepare::scene::Mesh;

/// A mesh, and what there is to say about it.
#[derive(Debug, Default)]
pub(super) struct Built {
    /// With positions, normals, and what else the file has. Its materials are indices into the file's names, [`NONE`] for none.
    pub(super) mesh: Mesh,
    /// Where the normals of its triangles come from.
    pub(super) normals: NormalCounts,
    /// Polygons that cross themselves.
    pub(super) crossing: usize,
    /// Triangles of each name of a material, and of none, that lack texture coordinates.
    pub(super) without_uv: Vec<usize>,
}

/// Makes a mesh of a file's lists, with `positions` in 32 bits. Corners without a normal get one: flat where smoothing is off,
/// smooth within a smoothing group, and by the crease angle where the file says neither. Corners that differ in nothing are one
/// vertex.
pub(super) fn build(parsed: &mut Parsed, positions: &[Vec3], crease_deg: f32) -> Built {
    let mut built = Built {
        without_uv: vec![0; parsed.materials.len() + 1],
        ..Built::default()
    };
    let lacks = |corner: &Corner| corner.normal == NONE;
    let lacking = parsed.corners.iter().any(lacks);
    if lacking {
        count(parsed, &mut built.normals);
        make_normals(parsed, positions, crease_deg);
    }
    let triangles = triangulate(parsed, &mut built);
    let corners = &parsed.corners;
    let mut joiner = Joiner::new(positions.len());
    let mesh = &mut built.mesh;
    mesh.indices = triangles
        .iter()
        .map(|t| {
            t.map(|corner| {
                let corner = corners[corner as usize];
                joiner.vertex(corner.position, [corner.uv, corner.normal])
            })
        })
        .collect();
    mesh.positions = pick(positions, &joiner.points);
    mesh.colors = pick(&parsed.colors, &joiner.points);
    let of = |[_, normal]: &[u32; 2]| parsed.normals[*normal as usize];
    mesh.normals = joiner.kinds.iter().map(of).collect();
    if joiner.kinds.iter().any(|[uv, _]| *uv != NONE) {
        let of = |[uv, _]: &[u32; 2]| match *uv {
            NONE => Vec2::ZERO,
            // OBJ counts v from the bottom of the image.
            uv => Vec2::new(0.0, 1.0) + parsed.uvs[uv as usize] * Vec2::new(1.0, -1.0),
        };
        mesh.uvs = joiner.kinds.iter().map(of).collect();
    }
    built
}

/// Counts the triangles whose normals are made, by how.
fn count(parsed: &Parsed, counts: &mut NormalCounts) {
    for (range, state) in parsed.polygons() {
        let triangles = range.len() - 2;
        let corners = &parsed.corners[range.start as usize..range.end as usize];
        if corners.iter().all(|corner| corner.normal != NONE) {
            continue;
        }
        match state.smoothing {
            Smoothing::Unsaid => counts.creased += triangles,
            Smoothing::Off => counts.flat += triangles,
            Smoothing::Group(_) => counts.grouped += triangles,
        }
    }
}

fn make_normals(parsed: &mut Parsed, positions: &[Vec3], crease_deg: f32) {
    let first = normals::points(positions);
    let points: Vec<u32> = parsed
        .corners
        .iter()
        .map(|corner| first[corner.position as usize])
        .collect();
    let mut starts = Vec::with_capacity(parsed.faces.len());
    let mut face_of = Vec::with_capacity(points.len());
    let mut areas = Vec::with_capacity(parsed.faces.len());
    let mut polygon = Vec::new();
    for ((range, _), face) in parsed.polygons().zip(0..) {
        starts.push(range.start);
        face_of.extend(range.clone().map(|_| face));
        outline(parsed, positions, range, &mut polygon);
        areas.push(newell(&polygon));
    }
    let faces = &parsed.faces;
    let corner = |index: u32| {
        let face = face_of[index as usize];
        let (start, end) = (starts[face as usize], faces[face as usize].end);
        normals::Corner {
            face,
            before: if index == start { end - 1 } else { index - 1 },
            after: if index + 1 == end { start } else { index + 1 },
        }
    };
    let states = &parsed.states;
    let smoothing = |side: Side| states[faces[side.0 as usize].state as usize].smoothing;
    let least = normals::cosine(crease_deg);
    let joined = |a: Side, b: Side| match (smoothing(a), smoothing(b)) {
        (Smoothing::Off, _) | (_, Smoothing::Off) => false,
        (Smoothing::Group(a), Smoothing::Group(b)) => a == b,
        _ => normals::is_smooth(a.1, b.1, least),
    };
    let area = |face: u32| areas[face as usize];
    let made = normals::make(&points, positions.len(), corner, area, joined);
    let given = parsed.normals.len() as u32;
    for (corner, normal) in parsed.corners.iter_mut().zip(&made.of_corner) {
        if corner.normal == NONE {
            corner.normal = given + normal;
        }
    }
    parsed.normals.extend(made.normals);
}

/// The positions of a polygon's corners.
fn outline(
    parsed: &Parsed,
    positions: &[Vec3],
    range: std::ops::Range<u32>,
    into: &mut Vec<DVec3>,
) {
    let corners = &parsed.corners[range.start as usize..range.end as usize];
    let place = |corner: &Corner| positions[corner.position as usize].as_dvec3();
    into.clear();
    into.extend(corners.iter().map(place));
}

/// Triangles as indices of corners; adds their materials to the mesh.
fn triangulate(parsed: &Parsed, built: &mut Built) -> Vec<[u32; 3]> {
    let mut triangles = Vec::with_capacity(parsed.faces.len());
    let mut cutter = Triangulator::default();
    let mut polygon = Vec::new();
    for (range, state) in parsed.polygons() {
        let before = triangles.len();
        let start = range.start;
        if range.len() == 3 {
            triangles.push([start, start + 1, start + 2]);
        } else {
            let corners = &parsed.corners[start as usize..range.end as usize];
            let place = |corner: &Corner| parsed.positions[corner.position as usize];
            polygon.clear();
            polygon.extend(corners.iter().map(place));
            cutter.polygon(&polygon, |t| triangles.push(t.map(|place| start + place)));
        }
        let material = state.material;
        built.mesh.materials.resize(triangles.len(), material);
        for triangle in &triangles[before..] {
            if triangle
                .iter()
                .any(|c| parsed.corners[*c as usize].uv == NONE)
            {
                let last = built.without_uv.len() - 1;
                built.without_uv[(material as usize).min(last)] += 1;
            }
        }
    }
    built.crossing = cutter.crossing;
    triangles
}
