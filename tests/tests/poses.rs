//! Host file: a posed scene is the one that is built there, whatever poses came before, on both processors.

use glam::{Mat4, UVec2, Vec2, Vec3, Vec4};
use glimt_render_gpu::cpu::CpuRenderer;
use glimt_render_gpu::gpu::{AdapterPreference, GpuRenderer};
use glimt_render_gpu::kernels::triangle::Triangle;
use glimt_render_gpu::prepare::env::{EnvMap, PreparedEnv};
use glimt_render_gpu::prepare::render::{FrameImage, RenderSettings, Renderer};
use glimt_render_gpu::prepare::scene::{
    Camera, Material, Mesh, Object, Reflection, SceneDescription, Shape, Texture, Wrap,
};
use glimt_render_gpu::prepare::scene_build::SceneBuffers;
use glimt_render_gpu::prepare::scene_error::SceneError;
use glimt_tests::gpu::adapter_or_skip;

/// A torus about z, of `2 · 48 · 24` triangles, without normals or tangents.
fn torus() -> Mesh {
    let (around, section) = (48, 24);
    let mut mesh = Mesh {
        name: "torus".into(),
        materials: vec![0],
        ..Mesh::default()
    };
    for i in 0..around {
        for j in 0..section {
            let (sin, cos) = (i as f32 / around as f32 * std::f32::consts::TAU).sin_cos();
            let (up, out) = (j as f32 / section as f32 * std::f32::consts::TAU).sin_cos();
            let radius = 1.0 + 0.35 * out;
            let p = Vec3::new(radius * cos, radius * sin, 0.35 * up);
            mesh.positions.push(p);
            mesh.uvs.push(Vec2::new(i as f32 / 6.0, j as f32 / 6.0));
            let at = |i: u32, j: u32| (i % around) * section + j % section;
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            mesh.indices.extend([[a, b, c], [a, c, d]]);
        }
    }
    mesh
}

/// A thin blade, one of whose faces is a sliver: some turns round its area away.
fn blade() -> Mesh {
    Mesh {
        name: "blade".into(),
        positions: vec![
            Vec3::new(-2.0, -0.1, 0.0),
            Vec3::new(2.0, -0.1, 0.0),
            Vec3::new(2.0, 0.1, 0.0),
            Vec3::new(-2.0, 0.1, 0.0),
            Vec3::new(0.0, 0.100_000_2, 0.0),
        ],
        indices: vec![[0, 1, 2], [0, 2, 3], [2, 4, 3]],
        materials: vec![1],
        ..Mesh::default()
    }
}

fn floor() -> Mesh {
    let corners = [(-9.0, -9.0), (9.0, -9.0), (9.0, 9.0), (-9.0, 9.0)];
    Mesh {
        name: "floor".into(),
        positions: corners.map(|(x, y)| Vec3::new(x, y, -1.5)).into(),
        indices: vec![[0, 1, 2], [0, 2, 3]],
        materials: vec![1],
        ..Mesh::default()
    }
}

fn describe(transforms: &[Mat4]) -> SceneDescription {
    let meshes = [0, 0, 1, 1, 2];
    let objects = meshes
        .iter()
        .zip(transforms)
        .map(|(&mesh, &transform)| Object {
            mesh,
            transform,
            material: None,
            catcher: false,
        });
    SceneDescription {
        meshes: vec![torus(), blade(), floor()],
        materials: vec![
            Material::from(Reflection::MetallicRoughness {
                base_color: Vec3::ONE,
                metallic: 0.5,
                roughness: 0.4,
                base_color_texture: Some(0.into()),
                metallic_roughness_texture: None,
                normal_texture: Some(1.into()),
                normal_scale: 1.0,
            }),
            Material::from(Reflection::BlinnPhong {
                diffuse: Vec3::new(0.4, 0.5, 0.6),
                specular: Vec3::splat(0.2),
                exponent: 80.0,
            }),
        ],
        textures: vec![
            Texture {
                size: UVec2::splat(2),
                texels: vec![
                    [220, 90, 60, 255],
                    [60, 80, 200, 255],
                    [40, 200, 90, 255],
                    [200; 4],
                ],
                srgb: true,
                wrap: [Wrap::Repeat; 2],
            },
            Texture {
                size: UVec2::new(2, 1),
                texels: vec![[160, 128, 240, 255], [96, 140, 240, 255]],
                srgb: false,
                wrap: [Wrap::Mirror; 2],
            },
        ],
        objects: objects.collect(),
    }
}

/// Tori that tumble (one of them mirrored) and blades that turn; the floor stands.
fn pose(t: f32) -> [Mat4; 5] {
    [
        Mat4::from_translation(Vec3::new(t.sin(), 0.0, 0.2)) * Mat4::from_rotation_x(t),
        Mat4::from_translation(Vec3::new(0.0, 2.0, 0.4))
            * Mat4::from_rotation_y(0.7 * t)
            * Mat4::from_scale(Vec3::new(-0.6, 0.7, 0.8)),
        Mat4::from_translation(Vec3::Z) * Mat4::from_rotation_z(11.0 * t),
        Mat4::from_translation(Vec3::new(0.0, 0.0, 1.1)) * Mat4::from_rotation_z(-9.0 * t),
        Mat4::IDENTITY,
    ]
}

/// As [`pose`], with everything so far from its neighbours that the tree of the first pose is of no use.
fn scattered() -> [Mat4; 5] {
    let mut list = pose(0.3);
    list.swap(0, 1);
    list[2] = Mat4::from_translation(Vec3::new(4.0, -5.0, 1.0)) * Mat4::from_rotation_x(1.5);
    list[0] = Mat4::from_translation(Vec3::new(-6.0, 4.0, 0.0)) * list[0];
    list
}

/// All triangles with their corners as bytes, sorted.
fn content(scene: &SceneBuffers) -> Vec<Vec<u8>> {
    let view = scene.view();
    let (corners, _) = view.corners.as_chunks::<3>();
    let mut list: Vec<Vec<u8>> = view
        .triangles
        .iter()
        .zip(corners)
        .map(|(t, c)| {
            // Trees may part triangles in other leaves.
            let alone = Triangle { run: 1, ..*t };
            [bytemuck::bytes_of(&alone), bytemuck::cast_slice(c)].concat()
        })
        .collect();
    list.sort();
    list
}

fn sky() -> PreparedEnv {
    let size = UVec2::new(32, 16);
    let texel = |i: u32| {
        let sun = if i == 3 * 32 + 9 { 300.0 } else { 0.0 };
        Vec4::new(0.3, 0.4, 0.6, 1.0) * (1.0 + (i % 7) as f32) + Vec4::splat(sun)
    };
    let texels = (0..size.x * size.y).map(texel).collect();
    EnvMap::new(size, texels).unwrap().prepare(20.0).unwrap()
}

fn settings() -> RenderSettings {
    let camera = Camera {
        eye: Vec3::new(5.0, -4.0, 4.0),
        target: Vec3::ZERO,
        up: Vec3::Z,
        fov_x: 0.9,
    };
    RenderSettings {
        rays_per_pixel: 4,
        ..RenderSettings::new(UVec2::new(96, 64), camera)
    }
}

/// Pixels that differ in a bit.
fn different(a: &FrameImage, b: &FrameImage) -> usize {
    let pairs = a.linear.iter().zip(&b.linear);
    pairs.filter(|(a, b)| a != b).count()
}

#[test]
fn a_pose_is_what_is_built_there() {
    let (env, settings) = (sky(), settings());
    let mut renderer = CpuRenderer::default();
    let mut render = |scene: &SceneBuffers| {
        renderer
            .render_frame(scene, &env, &settings, &|_| ())
            .unwrap()
    };
    let mut scene = SceneBuffers::build(&describe(&pose(0.0))).unwrap();
    let reference = render(&scene);
    for transforms in [pose(0.05), pose(0.8), scattered(), pose(4.0), pose(0.0)] {
        scene.pose(&transforms).unwrap();
        let fresh = SceneBuffers::build(&describe(&transforms)).unwrap();
        assert_eq!(scene.transforms(), transforms);
        assert!(content(&scene) == content(&fresh));
        assert_eq!(scene.bounds(), fresh.bounds());
        assert_eq!(scene.dropped_triangles(), fresh.dropped_triangles());
        // A ray through an edge that two triangles share may meet them in another order.
        let (posed, fresh) = (render(&scene), render(&fresh));
        let odd = different(&posed, &fresh);
        assert!(odd <= 3, "{odd} pixels differ");
    }
    assert_eq!(different(&render(&scene), &reference), 0);
    scene.pose(&pose(0.8)).unwrap();
    assert!(different(&render(&scene), &reference) > 500);
}

#[test]
fn poses_between_leave_no_trace() {
    let build = || SceneBuffers::build(&describe(&pose(0.0))).unwrap();
    let mut wanderer = build();
    let poses = [
        pose(0.2),
        scattered(),
        pose(0.2),
        pose(3.0),
        pose(0.0),
        scattered(),
    ];
    for transforms in poses {
        wanderer.pose(&transforms).unwrap();
        let mut direct = build();
        direct.pose(&transforms).unwrap();
        let (a, b) = (wanderer.view(), direct.view());
        assert_eq!(a.nodes, b.nodes);
        assert_eq!(a.triangles, b.triangles);
        assert_eq!(a.corners, b.corners);
    }
    // The reference pose is the one that was built.
    wanderer.pose(&pose(0.0)).unwrap();
    assert_eq!(wanderer.view().nodes, build().view().nodes);
    assert_eq!(wanderer.view().corners, build().view().corners);
    // Both ways of getting a tree were taken.
    let tree = |scene: &SceneBuffers| {
        let children = scene.view().nodes.iter().map(|n| n.children);
        children.collect::<Vec<_>>()
    };
    let reference = tree(&build());
    wanderer.pose(&pose(0.05)).unwrap();
    assert_eq!(tree(&wanderer), reference);
    wanderer.pose(&scattered()).unwrap();
    assert_ne!(tree(&wanderer), reference);
}

/// The first torus bent by `t`, with normals of its faces, and the second blade longer.
fn shapes(t: f32) -> [Shape; 2] {
    let shape = |object, mesh: Mesh, moved: &dyn Fn(Vec3) -> Vec3| Shape {
        object,
        positions: mesh.positions.iter().map(|p| moved(*p)).collect(),
        normals: Vec::new(),
        tangents: Vec::new(),
    };
    let bend = |p: Vec3| p + Vec3::new(0.0, t * p.x * p.x, t * p.z);
    [
        shape(0, torus(), &bend),
        shape(3, blade(), &|p| p * Vec3::new(1.0 + t, 1.0, 1.0)),
    ]
}

/// The scene with these shapes, as one that is built so.
fn describe_shaped(transforms: &[Mat4], shapes: &[Shape]) -> SceneDescription {
    let mut scene = describe(transforms);
    for shape in shapes {
        let object = &mut scene.objects[shape.object];
        let mesh = scene.meshes[object.mesh as usize].clone();
        object.mesh = scene.meshes.len() as u32;
        scene.meshes.push(Mesh {
            positions: shape.positions.clone(),
            ..mesh
        });
    }
    scene
}

#[test]
fn a_deformed_scene_is_what_is_built_so() {
    let mut scene = SceneBuffers::build(&describe(&pose(0.0))).unwrap();
    let reference = content(&scene);
    for t in [0.02, 1.5, 0.02, 0.7] {
        let shapes = shapes(t);
        for transforms in [pose(0.0), pose(t), scattered()] {
            scene.pose_shaped(&transforms, &shapes).unwrap();
            let fresh = SceneBuffers::build(&describe_shaped(&transforms, &shapes)).unwrap();
            assert!(content(&scene) == content(&fresh), "{t}");
            assert_eq!(scene.bounds(), fresh.bounds());
            assert_eq!(scene.mesh(0).positions, shapes[0].positions);
            assert_eq!(
                scene.vertices().unwrap().len(),
                fresh.vertices().unwrap().len()
            );
            // Poses between leave no trace.
            let mut direct = SceneBuffers::build(&describe(&pose(0.0))).unwrap();
            direct.pose_shaped(&transforms, &shapes).unwrap();
            assert_eq!(scene.view().nodes, direct.view().nodes);
            assert_eq!(scene.view().triangles, direct.view().triangles);
            assert_eq!(scene.view().corners, direct.view().corners);
        }
    }
    // The same shapes again cost nothing; without shapes the reference comes back.
    let id = scene.id();
    scene.pose_shaped(&scattered(), &shapes(0.7)).unwrap();
    assert_eq!(scene.id(), id);
    scene.pose(&pose(0.0)).unwrap();
    assert!(content(&scene) == reference);
    // What does not fit is refused, and changes nothing.
    let mut bad = shapes(1.0);
    bad[1].positions.pop();
    let error = scene.pose_shaped(&pose(1.0), &bad).unwrap_err();
    assert!(matches!(error, SceneError::Length { .. }), "{error}");
    bad[1].object = 99;
    let error = scene.pose_shaped(&pose(1.0), &bad).unwrap_err();
    assert!(
        matches!(error, SceneError::Missing { object: 99, .. }),
        "{error}"
    );
    assert!(content(&scene) == reference);
}

#[test]
fn what_stands_still_costs_nothing() {
    let mut scene = SceneBuffers::build(&describe(&pose(0.0))).unwrap();
    let (id, surface) = (scene.id(), scene.surface_id());
    scene.pose(&pose(0.0)).unwrap();
    assert_eq!(scene.id(), id);
    scene.pose(&pose(1.0)).unwrap();
    let posed = scene.id();
    assert_ne!(posed, id);
    scene.pose(&pose(1.0)).unwrap();
    assert_eq!((scene.id(), scene.surface_id()), (posed, surface));
}

#[test]
fn bad_poses_are_refused_and_change_nothing() {
    let mut scene = SceneBuffers::build(&describe(&pose(0.0))).unwrap();
    scene.pose(&pose(1.0)).unwrap();
    let before = (scene.id(), content(&scene));
    let mut refused = |object: usize, transform: Mat4| {
        let mut transforms = pose(2.0);
        transforms[object] = transform;
        let error = scene.pose(&transforms).unwrap_err();
        assert!((scene.id(), content(&scene)) == before);
        error
    };
    let flat = Mat4::from_scale(Vec3::new(1.0, 1.0, 0.0));
    assert_eq!(refused(3, flat), SceneError::Transform { object: 3 });
    let nan = Mat4::from_translation(Vec3::NAN);
    assert!(matches!(
        refused(1, nan),
        SceneError::Position { object: 1, .. }
    ));
    let far = Mat4::from_translation(Vec3::splat(1e12));
    assert!(matches!(
        refused(0, far),
        SceneError::Position { object: 0, .. }
    ));
    let error = scene.pose(&pose(2.0)[..4]).unwrap_err();
    let (found, expected) = (4, 5);
    assert_eq!(error, SceneError::Pose { found, expected });
}

#[test]
fn what_shrinks_to_nothing_is_dropped_and_comes_back() {
    let mut scene = SceneBuffers::build(&describe(&pose(0.0))).unwrap();
    let all = scene.view().triangles.len();
    let mut small = pose(0.0);
    small[0] = Mat4::from_scale(Vec3::splat(1e-20));
    scene.pose(&small).unwrap();
    assert_eq!(scene.view().triangles.len(), all - 2 * 48 * 24);
    let fresh = SceneBuffers::build(&describe(&small)).unwrap();
    assert!(content(&scene) == content(&fresh));
    let nothing = [Mat4::from_scale(Vec3::splat(1e-20)); 5];
    let error = scene.pose(&nothing).unwrap_err();
    assert!(matches!(error, SceneError::NoTriangles { .. }));
    assert!(content(&scene) == content(&fresh));
    scene.pose(&pose(0.0)).unwrap();
    assert_eq!(scene.view().triangles.len(), all);
}

#[test]
fn the_gpu_renders_the_pose_that_it_is_given() {
    if adapter_or_skip("the_gpu_renders_the_pose_that_it_is_given").is_none() {
        return;
    }
    let mut renderer = GpuRenderer::new(AdapterPreference::Fastest).unwrap();
    let (env, settings) = (sky(), settings());
    let mut scene = SceneBuffers::build(&describe(&pose(0.0))).unwrap();
    let mut render = |scene: &SceneBuffers| {
        renderer
            .render_frame(scene, &env, &settings, &|_| ())
            .unwrap()
    };
    let first = render(&scene);
    for transforms in [pose(0.8), scattered(), pose(0.0)] {
        scene.pose(&transforms).unwrap();
        let posed = render(&scene);
        // Another scene between, of other sizes.
        let fresh = render(&SceneBuffers::build(&describe(&transforms)).unwrap());
        let odd = different(&posed, &fresh);
        assert!(odd <= 3, "{odd} pixels differ");
    }
    assert_eq!(different(&render(&scene), &first), 0);
    scene.pose(&pose(0.8)).unwrap();
    assert!(different(&render(&scene), &first) > 500);
}
