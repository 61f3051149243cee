//! Host file: transfer of the vertices of a box that stands on a grid, on both processors.

use glam::{Mat4, Vec3};
use glimt_render_gpu::gpu::{Arg, GpuContext, GpuScene};
use glimt_render_gpu::kernels::transfer::{STATE, transfer};
use glimt_render_gpu::prepare::bake::{BakeSettings, for_kernels};
use glimt_render_gpu::prepare::scene::{Material, Mesh, Object, Reflection, SceneDescription};
use glimt_render_gpu::prepare::scene_build::SceneBuffers;
use naga_front_rust::Program;

use super::{Output, Pair, launch, words};

/// A tent on a floor of which it covers a vertex.
fn scene() -> SceneBuffers {
    let side = 5;
    let floor = Mesh {
        positions: (0..side * side)
            .map(|i| Vec3::new((i % side) as f32 - 2.0, (i / side) as f32 - 2.0, 0.0))
            .collect(),
        indices: (0..side * (side - 1))
            .filter(|i| i % side + 1 < side)
            .flat_map(|a| [[a, a + 1, a + side + 1], [a, a + side + 1, a + side]])
            .collect(),
        materials: vec![0],
        ..Mesh::default()
    };
    let tent = Mesh {
        positions: vec![
            Vec3::new(-0.5, -0.5, 0.0),
            Vec3::new(0.6, -0.4, 0.0),
            Vec3::new(0.0, 0.7, 0.0),
            Vec3::new(0.1, 0.0, 1.0),
        ],
        indices: vec![[0, 1, 3], [1, 2, 3], [2, 0, 3], [0, 2, 1]],
        materials: vec![0],
        ..Mesh::default()
    };
    let object = |mesh| Object {
        mesh,
        transform: Mat4::IDENTITY,
        material: None,
        catcher: false,
    };
    SceneBuffers::build(&SceneDescription {
        meshes: vec![floor, tent],
        materials: vec![Material::from(Reflection::BlinnPhong {
            diffuse: Vec3::splat(0.5),
            specular: Vec3::ZERO,
            exponent: 0.0,
        })],
        textures: Vec::new(),
        objects: vec![object(0), object(1)],
    })
    .expect("a scene")
}

/// Both lists of coefficients, and how many rays there were.
///
/// # Panics
/// Where the GPU or the front end fails.
#[must_use]
pub fn transfer_pair(program: &Program, context: &GpuContext) -> Pair {
    let scene = scene();
    let settings = BakeSettings {
        bands: 6,
        directions: 52,
        seed: 3,
    };
    let params = settings.params();
    let known = for_kernels(&scene.vertices().expect("vertices"), 0);
    let (count, n) = (known.len() as u32, 36);
    let mut states = vec![0u32; known.len() * STATE];
    let mut lists = [vec![0.0f32; known.len() * n], vec![0.0f32; known.len() * n]];
    let [lit, blocked] = &mut lists;
    let view = scene.view();
    let chunks = lit.chunks_mut(n).zip(blocked.chunks_mut(n));
    let chunks = chunks.zip(states.chunks_mut(STATE));
    let rays: Vec<u32> = (0..)
        .zip(chunks)
        .map(|(v, ((lit, blocked), state))| {
            let (nodes, triangles, surface) = (view.nodes, view.triangles, view.surface);
            transfer(
                v, &params, nodes, triangles, surface, &known, state, lit, blocked,
            )
        })
        .collect();
    let cpu = [
        words(&states),
        words(&lists[0]),
        words(&lists[1]),
        words(&rays),
    ]
    .concat();

    let uploaded = GpuScene::new(context, &scene).expect("a small scene");
    let vertices = context
        .buffer_of("vertices", &known)
        .expect("a small buffer");
    let [lit, blocked] = [0; 2].map(|_| Output::new::<f32>(context, count * n as u32));
    let state = Output::new::<u32>(context, count * STATE as u32);
    let mut args = vec![
        ("params", Arg::Value(bytemuck::bytes_of(&params))),
        ("vertices", Arg::Buffer(&vertices)),
        ("state", Arg::Chunk(&state.buffer, STATE as u32)),
        ("lit", Arg::Chunk(&lit.buffer, n as u32)),
        ("blocked", Arg::Chunk(&blocked.buffer, n as u32)),
    ];
    args.extend(uploaded.tree_args());
    let out = Output::new::<u32>(context, count);
    let kernel = "glimt_render_gpu::kernels::transfer::transfer";
    launch(context, program, kernel, &args, &out.buffer, count);
    let gpu = [
        state.read(context),
        lit.read(context),
        blocked.read(context),
        out.read(context),
    ]
    .concat();
    Pair {
        name: "transfer".to_owned(),
        cpu,
        gpu,
    }
}
