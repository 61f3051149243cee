//! Host file: the claim that precomputing transfer traces at least 0.8 of the rays per second that obvhs's own traversals of the same
//! rays trace, all else that it does included; and Table 1 of Hajisharif 2012: how long transfer takes for a sphere, a bunny, a
//! buddha and a dragon on a plane, with and without visibility.

use glam::{Mat4, UVec2, Vec3, vec3};
use glimt::mesh;
use glimt::notes::Notes;
use glimt::shot::CREASE_DEG;
use glimt_benches::inputs::{TriangleMesh, data_dir, knot};
use glimt_benches::{Contest, claim};
use glimt_render_gpu::kernels::bvh::any_hit;
use glimt_render_gpu::kernels::ray::Ray;
use glimt_render_gpu::kernels::transfer::{
    STATE, TransferParams, TransferVertex, direction_in_row, strata_of_row, transfer,
};
use glimt_render_gpu::kernels::triangle::{Triangle, intersect};
use glimt_render_gpu::prepare::bake::{BakeSettings, bake, for_kernels};
use glimt_render_gpu::prepare::scene::{Material, Mesh, Object, Reflection, SceneDescription};
use glimt_render_gpu::prepare::scene_build::SceneBuffers;
use glimt_sampling::uniform::{UniformSource, unit_vec2};
use glimt_sampling::xoshiro::Xoshiro128PlusPlus;
use obvhs::BvhBuildParams;
use obvhs::bvh2::builder::build_bvh2_from_tris;
use obvhs::cwbvh::builder::build_cwbvh_from_tris;
use obvhs::ray::Ray as ObvhsRay;
use rayon::prelude::*;
use std::collections::{HashMap, HashSet};
use std::time::{Duration, Instant};

const ROUNDS: usize = 9;

fn main() {
    let settings = BakeSettings::default();
    // The paper's vertices and faces, with the plane.
    let scenes = [
        ("sphere", 6384, 32),
        ("bunny", 7455, 32),
        ("buddha", 54_938, 70),
        ("dragon", 54_952, 70),
    ];
    println!(
        "Transfer, {} bands, {} directions, {} threads (Hajisharif 2012, Table 1)",
        settings.bands,
        settings.directions,
        rayon::current_num_threads()
    );
    println!(
        "  {:<8} {:>9} {:>9} {:>10} {:>14} {:>12} {:>14} {:>12} {:>9}",
        "scene",
        "vertices",
        "faces",
        "build",
        "no visibility",
        "closed form",
        "with shadows",
        "rays",
        "Mrays/s"
    );
    for (name, vertices, grid) in scenes {
        let on_plane = (grid + 1) * (grid + 1);
        let object = object(name, vertices - on_plane as usize);
        let began = Instant::now();
        let scene = SceneBuffers::build(&describe(&object, grid)).expect("a scene");
        let build = began.elapsed();
        let known = for_kernels(&scene.vertices().expect("vertices"), 0);
        let unshadowed = timed(|| without_visibility(&known, &settings.params()));
        let closed = timed(|| closed_form(&known, settings.bands));
        let began = Instant::now();
        let baked = bake(&scene, &settings, &|_| ()).expect("a transfer");
        let shadowed = began.elapsed();
        println!(
            "  {name:<8} {:>9} {:>9} {:>8.0} ms {:>12.2} s {:>9.1} ms {:>12.2} s {:>12} {:>9.2}",
            known.len(),
            scene.view().triangles.len(),
            1e3 * build.as_secs_f64(),
            unshadowed.as_secs_f64(),
            1e3 * closed.as_secs_f64(),
            shadowed.as_secs_f64(),
            baked.rays,
            1e-6 * baked.rays as f64 / shadowed.as_secs_f64(),
        );
        if name == "bunny" || name == "dragon" {
            against_obvhs(name, &scene, &known, &settings.params());
        }
    }
}

fn timed<T>(run: impl FnOnce() -> T) -> Duration {
    let began = Instant::now();
    std::hint::black_box(run());
    began.elapsed()
}

/// The same sums with nothing in the way.
fn without_visibility(known: &[TransferVertex], params: &TransferParams) -> f32 {
    let vertices = (0..known.len() as u32).into_par_iter();
    let sums = vertices.with_min_len(16).map(|vertex| {
        let (mut lit, mut blocked) = ([0.0; 36], [0.0; 36]);
        let _ = transfer(
            vertex,
            params,
            &[],
            &[],
            &[],
            known,
            &mut [0; STATE],
            &mut lit,
            &mut blocked,
        );
        lit[0]
    });
    sums.sum()
}

/// `A_l y_lm(n)`, what those sums go to.
fn closed_form(known: &[TransferVertex], bands: u32) -> f32 {
    let vertices = known.par_iter().with_min_len(256);
    let sums = vertices.map(|vertex| {
        let y = glimt_sh::basis(vertex.normal);
        let mut sum = 0.0;
        for l in 0..bands {
            for k in l * l..(l + 1) * (l + 1) {
                sum += glimt_sh::cosine_lobe(l) * y[k as usize];
            }
        }
        sum
    });
    sums.sum()
}

/// One thread, the same rays, the same triangle test: obvhs's two trees, our tree, and all of the kernel.
fn against_obvhs(
    name: &str,
    scene: &SceneBuffers,
    known: &[TransferVertex],
    params: &TransferParams,
) {
    let view = scene.view();
    let (nodes, triangles) = (view.nodes, view.triangles);
    let boxed: Vec<_> = triangles.iter().map(to_obvhs).collect();
    let built = || BvhBuildParams {
        pre_split: false,
        ..BvhBuildParams::slow_build()
    };
    let mut build_time = Duration::ZERO;
    let bvh2 = build_bvh2_from_tris(&boxed, built(), &mut build_time);
    let in_bvh2_order = reorder(triangles, &bvh2.primitive_indices);
    let cwbvh = build_cwbvh_from_tris(&boxed, built(), &mut build_time);
    let in_cwbvh_order = reorder(triangles, &cwbvh.primitive_indices);

    // Runs of neighbours, as a thread gets them.
    let some: Vec<TransferVertex> = known
        .chunks(16)
        .step_by(known.len() / 800)
        .flatten()
        .copied()
        .collect();
    let rays: Vec<Ray> = some
        .iter()
        .flat_map(|vertex| rays_of(vertex, params))
        .collect();
    let blocked_2 = |ray: &Ray| {
        let hit = |bounds: &ObvhsRay, i: usize| intersect(&in_bvh2_order[i], ray, bounds.tmax);
        !bvh2.ray_traverse_miss(unbounded(ray), hit)
    };
    let blocked_cw = |ray: &Ray| {
        let hit = |bounds: &ObvhsRay, i: usize| intersect(&in_cwbvh_order[i], ray, bounds.tmax);
        !cwbvh.ray_traverse_miss(unbounded(ray), hit)
    };
    let blocked = |ray: &Ray| any_hit(nodes, triangles, &[], ray, f32::MAX);
    for ray in &rays {
        assert!(
            [blocked_2(ray), blocked_cw(ray)] == [blocked(ray); 2],
            "one ray, two shadows"
        );
    }
    let count = |test: &dyn Fn(&Ray) -> bool| rays.iter().filter(|ray| test(ray)).count();
    let whole = || {
        let vertices = 0..some.len() as u32;
        let traced = vertices.map(|vertex| {
            let (mut lit, mut blocked) = ([0.0; 36], [0.0; 36]);
            u64::from(transfer(
                vertex,
                params,
                nodes,
                triangles,
                &[],
                &some,
                &mut [0; STATE],
                &mut lit,
                &mut blocked,
            ))
        });
        traced.sum::<u64>()
    };
    assert_eq!(whole(), rays.len() as u64, "other rays");
    println!(
        "\n{} rays of {} vertices, {:.0} % of them blocked",
        rays.len(),
        some.len(),
        100.0 * count(&blocked) as f64 / rays.len() as f64
    );
    let title = format!("Visibility of the {name}'s vertices, one thread");
    let scores = Contest::new(&title, "ray", rays.len() as f64)
        .entry("obvhs Bvh2", || count(&blocked_2))
        .entry("obvhs CWBVH", || count(&blocked_cw))
        .entry("shared traversal", || count(&blocked))
        .entry("all of the transfer", whole)
        .run(ROUNDS);
    let (ours, cwbvh) = (scores[3].ratio, scores[1].ratio);
    claim(
        &format!(
            "{:.2} of the rays per second of obvhs's Bvh2 alone, at least 0.8",
            1.0 / ours
        ),
        ours <= 1.0 / 0.8,
    );
    claim(
        &format!("{:.2} of those of its CWBVH, at least 0.8", cwbvh / ours),
        ours <= cwbvh / 0.8,
    );
    println!();
}

/// The rays that the kernel traces of a vertex.
fn rays_of(vertex: &TransferVertex, params: &TransferParams) -> Vec<Ray> {
    let mut source = Xoshiro128PlusPlus::stream(params.seed, 0x7472_616e, vertex.number);
    let mut rays = Vec::new();
    for row in 0..params.rows {
        let UVec2 {
            x: first,
            y: columns,
        } = strata_of_row(params, row);
        for column in 0..columns {
            let u = unit_vec2(source.next_uvec2());
            let direction = direction_in_row(params.directions, first, columns, column, u);
            if vertex.normal.dot(direction) > 0.0 {
                rays.push(Ray::new(vertex.origin, direction));
            }
        }
    }
    rays
}

fn to_obvhs(triangle: &Triangle) -> obvhs::triangle::Triangle {
    obvhs::triangle::Triangle {
        v0: triangle.a().into(),
        v1: triangle.b().into(),
        v2: triangle.c().into(),
    }
}

fn reorder(triangles: &[Triangle], order: &[u32]) -> Vec<Triangle> {
    order.iter().map(|&i| triangles[i as usize]).collect()
}

fn unbounded(ray: &Ray) -> ObvhsRay {
    ObvhsRay::new(ray.origin.into(), ray.direction.into(), 0.0, f32::MAX)
}

/// The mesh of that name with about so many vertices; a knot where its file is not available.
fn object(name: &str, vertices: usize) -> TriangleMesh {
    let file = match name {
        "sphere" => return ball(vertices),
        "bunny" => "stanford-bunny.obj",
        "buddha" => "happy_buddha_100k.obj",
        _ => "dragon_vrip_res3.ply.gz",
    };
    let mut mesh = match mesh::load(
        &data_dir().join("models"),
        file,
        CREASE_DEG,
        &mut Notes::default(),
    ) {
        Ok(model) => of_model(file, &model),
        Err(error) => {
            println!("{error}; a knot stands in");
            return knot((vertices / 100) as u32, 100);
        }
    };
    // A scan of about as many is taken as it is; a coarser one is cut finer first.
    if mesh.positions.len() * 11 / 10 < vertices {
        mesh = cut_in_four(&mesh);
    }
    if mesh.positions.len() > vertices * 11 / 10 {
        mesh = clustered(&mesh, vertices);
    }
    mesh
}

fn of_model(name: &str, model: &mesh::model::Model) -> TriangleMesh {
    let own = &model.meshes[0];
    // Vertices that no face uses would count, and cost nothing.
    let mut numbers = HashMap::new();
    let mut mesh = TriangleMesh {
        name: name.to_owned(),
        positions: Vec::new(),
        triangles: Vec::new(),
    };
    for face in &own.indices {
        let face = face.map(|i| {
            *numbers.entry(i).or_insert_with(|| {
                mesh.positions.push(own.positions[i as usize]);
                mesh.positions.len() as u32 - 1
            })
        });
        mesh.triangles.push(face);
    }
    mesh
}

/// A sphere of about so many vertices, in rings of latitude.
fn ball(vertices: usize) -> TriangleMesh {
    let rings = ((vertices as f32 / 2.0).sqrt() as u32).max(4);
    let sectors = ((vertices - 2) as f32 / (rings - 1) as f32).round() as u32;
    let mut mesh = TriangleMesh {
        name: "sphere".to_owned(),
        positions: vec![Vec3::Y],
        triangles: Vec::new(),
    };
    for ring in 1..rings {
        let (sin, cos) = (std::f32::consts::PI * ring as f32 / rings as f32).sin_cos();
        for sector in 0..sectors {
            let (y, x) = (std::f32::consts::TAU * sector as f32 / sectors as f32).sin_cos();
            mesh.positions.push(vec3(sin * x, cos, -sin * y));
        }
    }
    mesh.positions.push(Vec3::NEG_Y);
    let south = mesh.positions.len() as u32 - 1;
    let at = |ring: u32, sector: u32| 1 + (ring - 1) * sectors + sector % sectors;
    for s in 0..sectors {
        mesh.triangles.push([0, at(1, s), at(1, s + 1)]);
        for ring in 1..rings - 1 {
            let [a, b] = [at(ring, s), at(ring, s + 1)];
            let [c, d] = [at(ring + 1, s), at(ring + 1, s + 1)];
            mesh.triangles.extend([[a, c, b], [b, c, d]]);
        }
        mesh.triangles
            .push([south, at(rings - 1, s + 1), at(rings - 1, s)]);
    }
    mesh
}

fn cut_in_four(mesh: &TriangleMesh) -> TriangleMesh {
    let mut cut = mesh.clone();
    cut.triangles.clear();
    let mut middles = HashMap::new();
    for &[a, b, c] in &mesh.triangles {
        let [ab, bc, ca] = [(a, b), (b, c), (c, a)].map(|(a, b)| {
            *middles.entry((a.min(b), a.max(b))).or_insert_with(|| {
                let middle = 0.5 * (mesh.positions[a as usize] + mesh.positions[b as usize]);
                cut.positions.push(middle);
                cut.positions.len() as u32 - 1
            })
        });
        let parts = [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]];
        cut.triangles.extend(parts);
    }
    cut
}

/// All vertices in a cell of a grid made one (Rossignac and Borrel 1993), with cells so large that about so many are left.
fn clustered(mesh: &TriangleMesh, vertices: usize) -> TriangleMesh {
    let low = mesh
        .positions
        .iter()
        .copied()
        .reduce(Vec3::min)
        .expect("a point");
    let high = mesh
        .positions
        .iter()
        .copied()
        .reduce(Vec3::max)
        .expect("a point");
    let extent = (high - low).max_element();
    let (mut coarse, mut fine) = (8.0, 4096.0);
    let mut best = mesh.clone();
    for _ in 0..24 {
        let cells = 0.5 * (coarse + fine);
        best = on_grid(mesh, low, extent / cells);
        match best.positions.len() > vertices {
            true => fine = cells,
            false => coarse = cells,
        }
    }
    best
}

fn on_grid(mesh: &TriangleMesh, low: Vec3, cell: f32) -> TriangleMesh {
    let mut numbers: HashMap<[i32; 3], u32> = HashMap::new();
    let mut sums: Vec<(Vec3, f32)> = Vec::new();
    let merged: Vec<u32> = mesh
        .positions
        .iter()
        .map(|p| {
            let key = ((*p - low) / cell).floor().as_ivec3().to_array();
            let number = *numbers.entry(key).or_insert_with(|| {
                sums.push((Vec3::ZERO, 0.0));
                sums.len() as u32 - 1
            });
            let sum = &mut sums[number as usize];
            *sum = (sum.0 + *p, sum.1 + 1.0);
            number
        })
        .collect();
    let mut seen = HashSet::new();
    let faces = mesh
        .triangles
        .iter()
        .map(|face| face.map(|i| merged[i as usize]));
    let triangles = faces.filter(|face| {
        let [a, b, c] = *face;
        let mut sorted = *face;
        sorted.sort_unstable();
        a != b && b != c && c != a && seen.insert(sorted)
    });
    TriangleMesh {
        name: mesh.name.clone(),
        triangles: triangles.collect(),
        positions: sums.iter().map(|(sum, n)| *sum / *n).collect(),
    }
}

/// The mesh, y up, 1.5 high, standing on a plane of `grid` × `grid` squares.
fn describe(mesh: &TriangleMesh, grid: u32) -> SceneDescription {
    let low = mesh
        .positions
        .iter()
        .copied()
        .reduce(Vec3::min)
        .expect("a point");
    let high = mesh
        .positions
        .iter()
        .copied()
        .reduce(Vec3::max)
        .expect("a point");
    let middle = 0.5 * (low + high);
    let stand = Mat4::from_scale(Vec3::splat(1.5 / (high.y - low.y)))
        * Mat4::from_rotation_x(std::f32::consts::FRAC_PI_2)
        * Mat4::from_translation(vec3(-middle.x, -low.y, -middle.z));
    let at = |i: u32| 4.0 * i as f32 / grid as f32 - 2.0;
    let side = grid + 1;
    let places = (0..side * side).map(|i| vec3(at(i % side), at(i / side), 0.0));
    let squares = (0..grid * grid).map(|i| i / grid * side + i % grid);
    let plane = Mesh {
        name: "plane".to_owned(),
        positions: places.collect(),
        indices: squares
            .flat_map(|a| [[a, a + 1, a + side + 1], [a, a + side + 1, a + side]])
            .collect(),
        materials: vec![0],
        ..Mesh::default()
    };
    let object = |mesh, transform| Object {
        mesh,
        transform,
        material: None,
        catcher: false,
    };
    SceneDescription {
        meshes: vec![
            Mesh {
                name: mesh.name.clone(),
                positions: mesh.positions.clone(),
                indices: mesh.triangles.clone(),
                materials: vec![0],
                ..Mesh::default()
            },
            plane,
        ],
        materials: vec![Material::from(Reflection::BlinnPhong {
            diffuse: Vec3::splat(0.5),
            specular: Vec3::ZERO,
            exponent: 0.0,
        })],
        textures: Vec::new(),
        objects: vec![object(0, stand), object(1, Mat4::IDENTITY)],
    }
}
