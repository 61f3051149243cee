//! Host file: the claim that a pose whose tree is refitted, until rays would cost a tenth more, and rebuilt beyond, is no
//! slower in total (pose and frame) than either alone. Statues that turn and
//! fall, and a block of small knots that change places, both threads.

use glam::{Mat4, UVec2, Vec3, vec3};
use glimt_benches::inputs::{TriangleMesh, knot, light_maps, statue};
use glimt_benches::scene::{camera, on_a_plane};
use glimt_benches::{Contest, claim};
use glimt_render_gpu::cpu::CpuRenderer;
use glimt_render_gpu::prepare::env::PreparedEnv;
use glimt_render_gpu::prepare::render::{RenderSettings, Renderer};
use glimt_render_gpu::prepare::scene::{Object, SceneDescription};
use glimt_render_gpu::prepare::scene_build::{SceneBuffers, Tree};
use std::cell::RefCell;

const ROUNDS: usize = 5;

fn main() {
    let mesh = statue();
    println!("{}: {} triangles", mesh.name, mesh.triangles.len());
    let map = light_maps().swap_remove(0).1;
    let env = map.prepare(0.0).expect("tables");
    let statues = SceneBuffers::build(&crowd(&mesh)).expect("a scene");
    contest(&statues, &env, poses(statues.transforms()));
    let pebbles = SceneBuffers::build(&pebbles()).expect("a scene");
    contest(&pebbles, &env, exchanges(pebbles.transforms()));
}

fn contest(reference: &SceneBuffers, env: &PreparedEnv, poses: Vec<(String, Vec<Mat4>)>) {
    let start: Vec<Mat4> = reference.transforms().to_vec();
    let objects = start.len();
    println!(
        "\n{} triangles of {objects} objects",
        reference.view().triangles.len()
    );
    for (name, transforms) in poses {
        println!("\n== {name}");
        let posed = |tree| {
            let mut scene = reference.clone();
            scene.pose_by(&transforms, tree).expect("a pose");
            scene
        };
        let [refitted, rebuilt] = [posed(Tree::Refitted), posed(Tree::Rebuilt)];
        let cost = SceneBuffers::expected_ray_cost;
        println!(
            "expected cost of a ray: {:.2} of the reference pose's, {:.2} of the rebuilt tree's",
            cost(&refitted) / cost(reference),
            cost(&refitted) / cost(&rebuilt),
        );
        // Each round begins from the reference pose, as it stands in memory.
        let pose = |tree| {
            let scene = RefCell::new(reference.clone());
            let (start, transforms) = (start.clone(), transforms.clone());
            move || {
                let mut scene = scene.borrow_mut();
                scene.pose_by(&transforms, tree).expect("a pose");
                scene.pose_by(&start, Tree::Refitted).expect("a pose");
            }
        };
        Contest::new("There and back (the way back refitted)", "pose", 1.0)
            .entry("refitted", pose(Tree::Refitted))
            .entry("rebuilt", pose(Tree::Rebuilt))
            .run(ROUNDS);
        for (size, rays) in [(UVec2::new(320, 180), 4), (UVec2::new(480, 270), 8)] {
            let settings = RenderSettings {
                rays_per_pixel: rays,
                ..RenderSettings::new(size, camera())
            };
            let frame = |tree| {
                let scene = RefCell::new(reference.clone());
                let (start, transforms) = (start.clone(), transforms.clone());
                move || {
                    let mut scene = scene.borrow_mut();
                    scene.pose_by(&transforms, tree).expect("a pose");
                    let image = CpuRenderer::default()
                        .render_frame(&scene, env, &settings, &|_| ())
                        .expect("a frame");
                    scene.pose_by(&start, Tree::Refitted).expect("a pose");
                    image
                }
            };
            let title = format!(
                "Pose and frame of {}x{}, {rays} rays a pixel",
                size.x, size.y
            );
            let scores = Contest::new(&title, "frame", 1.0)
                .entry("refitted", frame(Tree::Refitted))
                .entry("rebuilt", frame(Tree::Rebuilt))
                .entry("best", frame(Tree::Best))
                .run(ROUNDS);
            let least = scores[0].ratio.min(scores[1].ratio);
            claim(
                &format!(
                    "best takes {:.2} of the faster one, at most 1.1",
                    scores[2].ratio / least
                ),
                scores[2].ratio <= 1.1 * least,
            );
        }
    }
}

/// Three statues in a row on a plane.
fn crowd(mesh: &TriangleMesh) -> SceneDescription {
    let mut scene = on_a_plane(mesh);
    let stand = scene.objects[0].transform;
    scene.objects.remove(0);
    scene.objects.extend((0..3).map(|i| Object {
        mesh: 0,
        transform: Mat4::from_translation(vec3(0.75 * (i as f32 - 1.0), 0.0, 0.0))
            * Mat4::from_scale(Vec3::splat(0.9))
            * stand,
        material: None,
        catcher: false,
    }));
    scene
}

/// Poses by how far they are from the first.
fn poses(start: &[Mat4]) -> Vec<(String, Vec<Mat4>)> {
    let moved = |change: &dyn Fn(usize, Vec3) -> Mat4| -> Vec<Mat4> {
        let each = |(i, m): (usize, &Mat4)| match i {
            0 => *m,
            _ => {
                let place = m.transform_point3(Vec3::ZERO) * vec3(1.0, 1.0, 0.0);
                change(i, place) * *m
            }
        };
        start.iter().enumerate().map(each).collect()
    };
    let about = |place: Vec3, turn: Mat4| {
        Mat4::from_translation(place) * turn * Mat4::from_translation(-place)
    };
    vec![
        (
            "each turns by 45 degrees".to_owned(),
            moved(&|_, place| about(place, Mat4::from_rotation_z(0.785))),
        ),
        (
            "they fall over into one heap".to_owned(),
            moved(&|i, place| {
                Mat4::from_translation(vec3(0.0, 0.0, 0.5) - place)
                    * about(place, Mat4::from_rotation_x(1.2 + 0.9 * i as f32))
            }),
        ),
    ]
}

/// A thousand knots in a block on a plane.
fn pebbles() -> SceneDescription {
    let mut scene = on_a_plane(&knot(20, 6));
    let stand = scene.objects[0].transform;
    scene.objects.remove(0);
    scene.objects.extend((0..1000).map(|i| Object {
        mesh: 0,
        transform: Mat4::from_translation(
            0.16 * vec3(
                (i % 10) as f32 - 4.5,
                (i / 10 % 10) as f32 - 4.5,
                (i / 100) as f32,
            ),
        ) * Mat4::from_scale(Vec3::splat(0.1))
            * stand,
        material: None,
        catcher: false,
    }));
    scene
}

/// Shares of the objects change places with others far away.
fn exchanges(start: &[Mat4]) -> Vec<(String, Vec<Mat4>)> {
    let exchanged = |percent: usize| {
        let mut list = start.to_vec();
        for i in 1..list.len() {
            let other = 1 + i * 617 % (list.len() - 1);
            if i * 37 % 100 < percent {
                list.swap(i, other);
            }
        }
        list
    };
    let shares = [1, 10];
    let pairs = shares.map(|percent| {
        (
            format!("{percent} of 100 exchange places"),
            exchanged(percent),
        )
    });
    pairs.into()
}
