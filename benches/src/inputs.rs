//! Host file: maps and meshes that the benchmarks run on.
//!
//! Real files are read from the folder that `GLIMT_BENCH_DATA` names, `../shared/data` by default; where one is missing a
//! procedural stand-in takes its place, and the benchmark says so.

use glam::{UVec2, Vec3, Vec4, vec3};
use glimt::notes::Notes;
use glimt_render_gpu::prepare::env::EnvMap;
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

/// The scanned statue `happy_buddha_100k.obj` where it is available, else a knotted tube of as many triangles.
pub fn statue() -> TriangleMesh {
    load("happy_buddha_100k.obj").unwrap_or_else(|| knot(500, 100))
}

/// The scanned rabbit `stanford-bunny.obj` where it is available, else a knotted tube.
pub fn bunny() -> TriangleMesh {
    load("stanford-bunny.obj").unwrap_or_else(|| knot(350, 100))
}

fn load(name: &str) -> Option<TriangleMesh> {
    let folder = data_dir().join("models");
    let model = match glimt::mesh::load(&folder, name, 180.0, &mut Notes::default()) {
        Ok(model) => model,
        Err(error) => {
            println!("{error}; a procedural mesh stands in");
            return None;
        }
    };
    let mesh = model.meshes.into_iter().next()?;
    Some(TriangleMesh {
        name: name.to_owned(),
        positions: mesh.positions,
        triangles: mesh.indices,
    })
}

/// Three photographed light maps where they are available, else the procedural one.
pub fn light_maps() -> Vec<(String, EnvMap)> {
    let names = [
        "studio_small_03_1k",
        "spruit_sunrise_1k",
        "st_fagans_interior_1k",
    ];
    let mut maps = Vec::new();
    for name in names {
        let path = data_dir().join("hdri").join(name).with_extension("hdr");
        match image::open(&path) {
            Ok(picture) => {
                let picture = picture.into_rgba32f();
                let size = UVec2::new(picture.width(), picture.height());
                let mut texels: Vec<Vec4> =
                    picture.pixels().map(|p| Vec4::from_array(p.0)).collect();
                EnvMap::repair(&mut texels);
                maps.push((
                    name.to_owned(),
                    EnvMap::new(size, texels).expect("repaired texels"),
                ));
            }
            Err(error) => println!("{}: {error}", path.display()),
        }
    }
    if maps.is_empty() {
        let size = UVec2::new(1024, 512);
        let map = procedural_map(size);
        let texels = map
            .iter()
            .map(|p| Vec3::from_array(*p).extend(1.0))
            .collect();
        let map = EnvMap::new(size, texels).expect("procedural texels");
        maps.push(("a procedural map".to_owned(), map));
    }
    maps
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
