//! Host file: maps and meshes that the benchmarks run on.
//!
//! Real files are read from the folder that `GLIMT_BENCH_DATA` names, `../shared/data` by default; where one is missing a
//! procedural stand-in takes its place, and the benchmark says so.

use glam::{UVec2, Vec3, vec3};
use std::path::PathBuf;

/// Where the real inputs are looked for.
pub fn data_dir() -> PathBuf {
    std::env::var_os("GLIMT_BENCH_DATA").map_or_else(
        || PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../shared/data"),
        PathBuf::from,
    )
}

/// An RGB map: a smooth sky with clouds of many scales, dark ground, and a sun 10⁵ times as bright as the sky.
pub fn procedural_map(size: UVec2) -> Vec<[f32; 3]> {
    let mut map = Vec::with_capacity((size.x * size.y) as usize);
    for y in 0..size.y {
        for x in 0..size.x {
            let (u, v) = (x as f32 / size.x as f32, y as f32 / size.y as f32);
            let clouds: f32 = (0..6)
                .map(|octave| {
                    let f = (1 << octave) as f32 * 6.0;
                    (f * (u + 0.3 * v) + 1.7 * octave as f32).sin() * (f * v).cos()
                        / (octave + 1) as f32
                })
                .sum();
            let sky = if v < 0.5 { 1.0 + 0.4 * clouds } else { 0.05 };
            let sun = (vec3(u, v, 0.0) - vec3(0.3, 0.2, 0.0)).length() < 0.004;
            let level = if sun { 1e5 } else { sky.max(0.0) };
            map.push([level, 0.9 * level, 0.7 * level]);
        }
    }
    map
}

/// Positions and triangles of a mesh.
#[derive(Clone, Debug)]
pub struct TriangleMesh {
    /// What it is, for the printed title.
    pub name: String,
    /// Corners.
    pub positions: Vec<Vec3>,
    /// Indices of the corners of each triangle.
    pub triangles: Vec<[u32; 3]>,
}

/// The scanned statue `happy_buddha_100k.obj` where it is at hand, else a knotted tube of as many triangles.
pub fn statue() -> TriangleMesh {
    let path = data_dir().join("models/happy_buddha_100k.obj");
    let options = tobj::LoadOptions {
        triangulate: true,
        single_index: true,
        ..tobj::LoadOptions::default()
    };
    match tobj::load_obj(&path, &options) {
        Ok((models, _)) => {
            let mut mesh = TriangleMesh {
                name: "happy_buddha_100k.obj".to_owned(),
                positions: Vec::new(),
                triangles: Vec::new(),
            };
            for model in models {
                let first = mesh.positions.len() as u32;
                let points = model.mesh.positions.chunks_exact(3);
                mesh.positions
                    .extend(points.map(|p| vec3(p[0], p[1], p[2])));
                let corners = model.mesh.indices.chunks_exact(3);
                mesh.triangles
                    .extend(corners.map(|t| [t[0], t[1], t[2]].map(|i| first + i)));
            }
            mesh
        }
        Err(error) => {
            println!("{}: {error}; a procedural mesh stands in", path.display());
            knot(500, 100)
        }
    }
}

/// A tube along a trefoil knot, of `2 · along · around` triangles.
pub fn knot(along: u32, around: u32) -> TriangleMesh {
    let centre = |t: f32| {
        vec3(
            t.sin() + 2.0 * (2.0 * t).sin(),
            t.cos() - 2.0 * (2.0 * t).cos(),
            -(3.0 * t).sin(),
        )
    };
    let mut positions = Vec::new();
    let mut triangles = Vec::new();
    for i in 0..along {
        let t = std::f32::consts::TAU * i as f32 / along as f32;
        let tangent = (centre(t + 1e-3) - centre(t - 1e-3)).normalize();
        let side = tangent.cross(Vec3::Z).normalize();
        let up = side.cross(tangent);
        for j in 0..around {
            let (sin, cos) = (std::f32::consts::TAU * j as f32 / around as f32).sin_cos();
            let radius = 0.5 + 0.03 * (6.0 * t + 10.0 * sin).sin();
            positions.push(centre(t) + radius * (cos * side + sin * up));
            let [a, b] = [i * around, (i + 1) % along * around];
            let next = (j + 1) % around;
            triangles.push([a + j, b + j, b + next]);
            triangles.push([a + j, b + next, a + next]);
        }
    }
    TriangleMesh {
        name: "knot".to_owned(),
        positions,
        triangles,
    }
}
