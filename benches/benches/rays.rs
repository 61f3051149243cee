//! Host file: the claim that the traversal that runs on both processors traces at least 1.3 times as many rays per second as
//! obvhs's own traversal of a binary tree. Primary and shadow rays on a scanned statue, one thread, the same rays, the
//! same triangle test. Where `RAYS_DIR` names a folder, triangles, shadow rays and answers are written there, for
//! `benches/peers/against_embree.py`.

use glam::{Mat4, Vec2, Vec3, vec2, vec3};
use glimt_benches::inputs::{TriangleMesh, statue};
use glimt_benches::{Contest, claim};
use glimt_render_gpu::kernels::bvh::{any_hit, closest_hit};
use glimt_render_gpu::kernels::ray::Ray;
use glimt_render_gpu::kernels::triangle::{Triangle, intersect};
use glimt_render_gpu::prepare::scene::{Material, Mesh, Object, Reflection, SceneDescription};
use glimt_render_gpu::prepare::scene_build::SceneBuffers;
use glimt_sampling::uniform::{UniformSource, unit_vec2};
use glimt_sampling::warp::sample_cosine_hemisphere;
use glimt_sampling::{ShadingFrame, Xoshiro128PlusPlus};
use obvhs::BvhBuildParams;
use obvhs::bvh2::builder::build_bvh2_from_tris;
use obvhs::cwbvh::builder::build_cwbvh_from_tris;
use obvhs::ray::{Ray as ObvhsRay, RayHit};
use std::path::Path;
use std::time::Duration;
use std::{fs, io};

const SIDE: u32 = 512;
const ROUNDS: usize = 15;

fn main() {
    let mesh = statue();
    println!("{}: {} triangles", mesh.name, mesh.triangles.len());
    let scene = SceneBuffers::build(&describe(&mesh)).expect("a scene");
    let view = scene.view();
    let (nodes, triangles) = (view.nodes, view.triangles);

    // The same triangles in the same builder, as obvhs itself would be used; its leaves' triangles in its own order.
    let boxed: Vec<_> = triangles.iter().map(to_obvhs).collect();
    let params = || BvhBuildParams {
        pre_split: false,
        ..BvhBuildParams::slow_build()
    };
    let mut build_time = Duration::ZERO;
    let bvh2 = build_bvh2_from_tris(&boxed, params(), &mut build_time);
    let in_bvh2_order = reorder(triangles, &bvh2.primitive_indices);
    let cwbvh = build_cwbvh_from_tris(&boxed, params(), &mut build_time);
    let in_cwbvh_order = reorder(triangles, &cwbvh.primitive_indices);

    let primary = primary_rays(scene.bounds());
    let closest_2 = |ray: &Ray| {
        let mut hit = RayHit::none();
        bvh2.ray_traverse(unbounded(ray), &mut hit, |bounds, i| {
            intersect(&in_bvh2_order[i], ray, bounds.tmax)
        });
        hit.t
    };
    let closest_cw = |ray: &Ray| {
        let mut hit = RayHit::none();
        cwbvh.ray_traverse(unbounded(ray), &mut hit, |bounds, i| {
            intersect(&in_cwbvh_order[i], ray, bounds.tmax)
        });
        hit.t
    };
    let closest =
        |ray: &Ray| closest_hit(nodes, triangles, &[], ray, f32::MAX).map_or(f32::MAX, |h| h.t);
    for ray in &primary {
        let ours = closest(ray);
        for other in [closest_2(ray), closest_cw(ray)] {
            // A miss is f32::MAX here and infinity there.
            assert!(
                ours == other.min(f32::MAX),
                "one ray, two hits: {ours} and {other}"
            );
        }
    }
    let scores = Contest::new(
        "Primary rays, closest hit, one thread",
        "ray",
        primary.len() as f64,
    )
    .entry("obvhs Bvh2", || total(&primary, closest_2))
    .entry("obvhs CWBVH", || total(&primary, closest_cw))
    .entry("shared traversal", || total(&primary, closest))
    .run(ROUNDS);
    judge(scores[2].ratio);

    let shadow = shadow_rays(&primary, nodes, triangles);
    let blocked_2 = |ray: &Ray| {
        let hit = |bounds: &ObvhsRay, i: usize| intersect(&in_bvh2_order[i], ray, bounds.tmax);
        f32::from(!bvh2.ray_traverse_miss(unbounded(ray), hit))
    };
    let blocked_cw = |ray: &Ray| {
        let hit = |bounds: &ObvhsRay, i: usize| intersect(&in_cwbvh_order[i], ray, bounds.tmax);
        f32::from(!cwbvh.ray_traverse_miss(unbounded(ray), hit))
    };
    let blocked = |ray: &Ray| f32::from(any_hit(nodes, triangles, &[], ray, f32::MAX));
    for ray in &shadow {
        assert!(
            [blocked_2(ray), blocked_cw(ray)] == [blocked(ray); 2],
            "one ray, two shadows"
        );
    }
    if let Some(folder) = std::env::var_os("RAYS_DIR") {
        hand_over(folder.as_ref(), triangles, &shadow, blocked).expect("the folder takes files");
    }
    let share = total(&shadow, blocked) / shadow.len() as f32;
    println!(
        "\n{} shadow rays, {:.0} % of them blocked",
        shadow.len(),
        100.0 * share
    );
    let scores = Contest::new(
        "Shadow rays, any hit, one thread",
        "ray",
        shadow.len() as f64,
    )
    .entry("obvhs Bvh2", || total(&shadow, blocked_2))
    .entry("obvhs CWBVH", || total(&shadow, blocked_cw))
    .entry("shared traversal", || total(&shadow, blocked))
    .run(ROUNDS);
    judge(scores[2].ratio);
}

/// Writes `triangles.f32` (nine numbers each), `rays.f32` (origin and direction), and `blocked.u8`.
fn hand_over(
    folder: &Path,
    triangles: &[Triangle],
    rays: &[Ray],
    blocked: impl Fn(&Ray) -> f32,
) -> io::Result<()> {
    let corners = triangles.iter().flat_map(|t| [t.a(), t.b(), t.c()]);
    let corners: Vec<[f32; 3]> = corners.map(|corner| corner.to_array()).collect();
    let ends = rays.iter().flat_map(|ray| [ray.origin, ray.direction]);
    let ends: Vec<[f32; 3]> = ends.map(|end| end.to_array()).collect();
    let answers: Vec<u8> = rays.iter().map(|ray| blocked(ray) as u8).collect();
    fs::create_dir_all(folder)?;
    fs::write(folder.join("triangles.f32"), bytemuck::cast_slice(&corners))?;
    fs::write(folder.join("rays.f32"), bytemuck::cast_slice(&ends))?;
    fs::write(folder.join("blocked.u8"), answers)
}

fn judge(time_ratio: f64) {
    let rate = 1.0 / time_ratio;
    claim(
        &format!("{rate:.2} of the rays per second of obvhs's Bvh2, at least 1.3"),
        rate >= 1.3,
    );
}

fn total(rays: &[Ray], mut trace: impl FnMut(&Ray) -> f32) -> f32 {
    rays.iter().map(|ray| trace(ray).min(1e6)).sum()
}

fn describe(mesh: &TriangleMesh) -> SceneDescription {
    SceneDescription {
        meshes: vec![Mesh {
            name: mesh.name.clone(),
            positions: mesh.positions.clone(),
            indices: mesh.triangles.clone(),
            materials: vec![0],
            ..Mesh::default()
        }],
        materials: vec![Material::from(Reflection::BlinnPhong {
            diffuse: Vec3::splat(0.5),
            specular: Vec3::ZERO,
            exponent: 0.0,
        })],
        textures: Vec::new(),
        objects: vec![Object {
            mesh: 0,
            transform: Mat4::IDENTITY,
            material: None,
            catcher: false,
        }],
    }
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

/// Rays of a camera that sees all of the box, pixel by pixel along rows.
fn primary_rays((low, high): (Vec3, Vec3)) -> Vec<Ray> {
    let centre = 0.5 * (low + high);
    let radius = 0.5 * (high - low).length();
    let eye = centre + radius * vec3(0.6, 0.4, 2.0);
    let forward = (centre - eye).normalize();
    let right = forward.cross(Vec3::Y).normalize();
    let up = right.cross(forward);
    let pixel = |i: u32| {
        let place: Vec2 =
            (vec2((i % SIDE) as f32, (i / SIDE) as f32) + 0.5) / SIDE as f32 * 2.0 - 1.0;
        let direction = forward + 0.45 * (place.x * right - place.y * up);
        Ray::new(eye, direction.normalize())
    };
    (0..SIDE * SIDE).map(pixel).collect()
}

/// From each primary hit four rays, spread by the cosine.
fn shadow_rays(
    primary: &[Ray],
    nodes: &[glimt_render_gpu::kernels::bvh::BvhNode],
    triangles: &[Triangle],
) -> Vec<Ray> {
    let mut source = Xoshiro128PlusPlus::stream(1, 2, 3);
    let mut rays = Vec::new();
    for ray in primary {
        let Some(hit) = closest_hit(nodes, triangles, &[], ray, f32::MAX) else {
            continue;
        };
        let triangle = &triangles[hit.triangle as usize];
        let face = triangle.area_normal().normalize();
        let normal = if face.dot(ray.direction) > 0.0 {
            -face
        } else {
            face
        };
        let origin = ray.origin + hit.t * ray.direction + 4.0 * triangle.ray_offset() * normal;
        let frame = ShadingFrame::from_normal(normal);
        for _ in 0..4 {
            let sample = sample_cosine_hemisphere(unit_vec2(source.next_uvec2()));
            rays.push(Ray::new(origin, frame.to_world(sample.direction)));
        }
    }
    rays
}
