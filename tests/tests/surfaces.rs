//! Host file: what surfaces emit, let pass and show of both their sides, against closed forms, on both processors.

use std::sync::Arc;

use glam::{Affine2, Mat4, UVec2, Vec2, Vec3, Vec4};
use glimt_render_gpu::cpu::{CpuDrawing, CpuRenderer};
use glimt_render_gpu::gpu::{GpuDrawing, GpuRenderer};
use glimt_render_gpu::kernels::scene::bent_towards;
use glimt_render_gpu::methods::{Bis, Cells, Method, Mis, Product, Smc};
use glimt_render_gpu::prepare::bake::{BakeSettings, bake};
use glimt_render_gpu::prepare::env::{EnvMap, PreparedEnv};
use glimt_render_gpu::prepare::render::{Background, Filter, FrameImage, RenderSettings, Renderer};
use glimt_render_gpu::prepare::scene::{
    Alpha, Camera, Material, Mesh, Object, Opacity, Reflection, SceneDescription, Texture,
    TextureRef, Wrap,
};
use glimt_render_gpu::prepare::scene_build::SceneBuffers;
use glimt_render_gpu::prepare::transfer::Transfer;
use glimt_tests::gpu::adapter_or_skip;

/// Radiance 1 from everywhere.
fn white() -> PreparedEnv {
    let size = UVec2::new(16, 8);
    let texels = vec![Vec4::ONE; 128];
    EnvMap::new(size, texels).unwrap().prepare(0.0).unwrap()
}

fn matt(albedo: f32) -> Material {
    Material::from(Reflection::BlinnPhong {
        diffuse: Vec3::splat(albedo),
        specular: Vec3::ZERO,
        exponent: 0.0,
    })
}

fn unlit(color: Vec3) -> Material {
    Material::from(Reflection::Unlit {
        color,
        color_texture: None,
    })
}

/// A square about (0, 0, z), of this half side, that faces up, with texture coordinates from (0, 0) at its corner (−, −).
fn square(z: f32, half: f32, material: u32) -> Mesh {
    let corners = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(|(u, v)| Vec2::new(u, v));
    Mesh {
        name: "square".into(),
        positions: corners
            .map(|uv| ((uv * 2.0 - 1.0) * half).extend(z))
            .to_vec(),
        uvs: corners.to_vec(),
        indices: vec![[0, 1, 2], [0, 2, 3]],
        materials: vec![material],
        ..Mesh::default()
    }
}

/// Its faces have corners of their own.
fn cube(half: f32, material: u32) -> Mesh {
    let mut mesh = Mesh {
        name: "cube".into(),
        materials: vec![material],
        ..Mesh::default()
    };
    for axis in 0..3 {
        for sign in [-1.0, 1.0] {
            let n = Vec3::AXES[axis] * sign;
            let (u, v) = (
                Vec3::AXES[(axis + 1) % 3],
                Vec3::AXES[(axis + 2) % 3] * sign,
            );
            let first = mesh.positions.len() as u32;
            let corners = [-u - v, u - v, u + v, v - u];
            mesh.positions.extend(corners.map(|c| (n + c) * half));
            mesh.normals.extend([n; 4]);
            let faces = [[0, 1, 2], [0, 2, 3]];
            mesh.indices.extend(faces.map(|f| f.map(|i| first + i)));
        }
    }
    mesh
}

/// A ball of few faces with smooth normals; its seams and poles are joined.
fn coarse_ball(columns: u32, rows: u32) -> Mesh {
    let mut mesh = Mesh {
        name: "ball".into(),
        materials: vec![0],
        ..Mesh::default()
    };
    for j in 0..=rows {
        for i in 0..columns {
            let theta = std::f32::consts::PI * j as f32 / rows as f32;
            let phi = std::f32::consts::TAU * i as f32 / columns as f32;
            let (sin, cos) = theta.sin_cos();
            let n = Vec3::new(sin * phi.cos(), sin * phi.sin(), cos);
            mesh.positions.push(n);
            mesh.normals.push(n);
        }
    }
    for j in 0..rows {
        for i in 0..columns {
            let next = (i + 1) % columns;
            let (a, b) = (j * columns, (j + 1) * columns);
            mesh.indices.push([a + i, b + i, b + next]);
            mesh.indices.push([a + i, b + next, a + next]);
        }
    }
    mesh
}

fn describe(meshes: Vec<Mesh>, materials: Vec<Material>, catcher: Option<u32>) -> SceneDescription {
    let object = |mesh: u32| Object {
        mesh,
        transform: Mat4::IDENTITY,
        material: None,
        catcher: catcher == Some(mesh),
    };
    SceneDescription {
        objects: (0..meshes.len() as u32).map(object).collect(),
        meshes,
        materials,
        textures: Vec::new(),
    }
}

fn build(meshes: Vec<Mesh>, materials: Vec<Material>) -> SceneBuffers {
    SceneBuffers::build(&describe(meshes, materials, None)).unwrap()
}

/// Looks straight down.
fn from_above(eye_z: f32, fov_x: f32) -> Camera {
    Camera {
        eye: Vec3::Z * eye_z,
        target: Vec3::ZERO,
        up: Vec3::Y,
        fov_x,
    }
}

fn settings(size: UVec2, camera: Camera, rays_per_pixel: u32) -> RenderSettings {
    RenderSettings {
        rays_per_pixel,
        background: Background::Transparent,
        ..RenderSettings::new(size, camera)
    }
}

/// The renderers that trace.
fn tracers(test: &str) -> Vec<Box<dyn Renderer>> {
    let mut all: Vec<Box<dyn Renderer>> = vec![Box::new(CpuRenderer::default())];
    if let Some(context) = adapter_or_skip(test) {
        all.push(Box::new(GpuRenderer::on(context).unwrap()));
    }
    all
}

fn methods() -> [Method; 5] {
    [
        Mis::default().into(),
        Bis {
            candidates: 4,
            samples: 2,
            ..Bis::default()
        }
        .into(),
        Product::default().into(),
        Cells::default().into(),
        Smc::default().into(),
    ]
}

fn render(
    renderer: &mut dyn Renderer,
    scene: &SceneBuffers,
    settings: &RenderSettings,
) -> FrameImage {
    renderer
        .render_frame(scene, &white(), settings, &|_| ())
        .unwrap()
}

fn mean(image: &FrameImage) -> Vec4 {
    image.linear.iter().copied().sum::<Vec4>() / image.linear.len() as f32
}

/// The mean over a uniform image is this, to five standard errors of `rays` rays, each of which shows values within `range`.
fn assert_mean(what: &str, found: Vec3, expected: Vec3, range: f32, rays: usize) {
    // A value within a range has at most half of it as its standard deviation.
    let allowed = 5.0 * 0.5 * range / (rays as f32).sqrt() + 1e-5;
    let off = (found - expected).abs().max_element();
    assert!(off < allowed, "{what}: {found}, not {expected} ± {allowed}");
}

#[test]
fn a_furnace_shows_no_more_and_no_less_than_its_light() {
    let (size, rays) = (UVec2::new(48, 48), 256);
    let camera = Camera {
        eye: Vec3::new(-4.0, -2.2, 1.8),
        target: Vec3::ZERO,
        up: Vec3::Z,
        fov_x: 0.55,
    };
    let settings = RenderSettings {
        filter: Filter::Centre,
        method: Mis {
            brdf_samples: 1,
            env_samples: 0,
            ..Mis::default()
        }
        .into(),
        ..settings(size, camera, rays)
    };
    let (mut leaning, mut seen) = (0, 0);
    for mesh in [coarse_ball(8, 6), cube(0.8, 0)] {
        let is_flat = mesh.name == "cube";
        let scene = build(vec![mesh], vec![matt(1.0)]);
        let view = scene.view();
        let frame = settings.frame_params().unwrap();
        let expected: Vec<Option<f32>> = (0..size.x * size.y)
            .map(|pixel| {
                let ray = frame.camera_ray(&frame.pattern_of(pixel * rays));
                let hit = view.closest_hit(&ray)?;
                let point = view.shading_point(&ray, &hit);
                // Cosines of a lobe about n of which what lies behind the face is cut off.
                let share = 0.5 * (1.0 + point.frame.n.dot(point.geometric_normal));
                let corners = &view.corners[3 * hit.triangle as usize..][..3];
                let (u, v) = (hit.barycentrics.x, hit.barycentrics.y);
                let given = corners[0].normal * (1.0 - u - v)
                    + corners[1].normal * u
                    + corners[2].normal * v;
                let given = given.normalize();
                let least = 0.5 * (1.0 + given.dot(point.geometric_normal));
                assert!(share > least - 1e-5, "bent away: {share} < {least}");
                assert!(point.wo.z > 0.0);
                leaning += usize::from(given.dot(-ray.direction) <= 0.0);
                Some(share)
            })
            .collect();
        for renderer in &mut tracers("furnace") {
            let image = render(&mut **renderer, &scene, &settings);
            for (value, expected) in image.linear.iter().zip(&expected) {
                let Some(share) = *expected else {
                    assert_eq!(*value, Vec4::ZERO);
                    continue;
                };
                seen += 1;
                let sigma = (share * (1.0 - share) / rays as f32).sqrt();
                let off = (value.x - share).abs();
                assert!(off < 6.0 * sigma + 2e-3, "{} of {share}", value.x);
                assert!(value.x <= 1.0 + 1e-5);
                if is_flat {
                    assert!((value.x - 1.0).abs() < 1e-5, "{}", value.x);
                }
            }
        }
    }
    assert!(leaning >= 5, "no normal leans away from the eye: {leaning}");
    assert!(seen > 1000);
}

#[test]
fn normals_bend_no_further_than_needed() {
    let geometric = Vec3::Z;
    let to_eye = Vec3::new(0.6, 0.0, 0.8);
    let leaning = Vec3::new(-0.9, 0.0, (1.0f32 - 0.81).sqrt());
    assert!(leaning.dot(to_eye) < 0.0);
    let bent = bent_towards(leaning, to_eye, geometric);
    assert!((bent.length() - 1.0).abs() < 1e-6);
    let cosine = bent.dot(to_eye);
    assert!(cosine > 0.009 && cosine < 0.012, "{cosine}");
    // What the eye may see stays, also where the face itself is seen flatly.
    assert_eq!(bent_towards(geometric, to_eye, geometric), geometric);
    let flat = Vec3::new(1.0, 0.0, 1e-4).normalize();
    assert_eq!(bent_towards(geometric, flat, geometric), geometric);
    // Opposite to the eye there is no way to bend it.
    let opposite = bent_towards(-to_eye, to_eye, geometric);
    assert!(opposite.dot(to_eye) > 0.0 && opposite.is_finite());
}

#[test]
fn what_is_behind_a_thin_surface_shows_by_its_alpha() {
    let (size, rays) = (UVec2::new(16, 16), 16);
    let colours = [Vec3::X, Vec3::Y, Vec3::Z].map(|c| c * 2.0);
    let blend = |color, factor| Material {
        opacity: Opacity::Blend {
            alpha: Alpha {
                factor,
                texture: None,
            },
        },
        ..unlit(color)
    };
    // The middle one has its alpha from its vertices.
    let mut middle = square(1.0, 4.0, 1);
    middle.colors = vec![Vec4::new(1.0, 1.0, 1.0, 0.5); 4];
    let scene = build(
        vec![square(2.0, 4.0, 0), middle, square(0.0, 4.0, 2)],
        vec![
            blend(colours[0], 0.3),
            blend(colours[1], 0.8),
            unlit(colours[2]),
        ],
    );
    let expected = colours[0] * 0.3 + (colours[1] * 0.4 + colours[2] * 0.6) * 0.7;
    for renderer in &mut tracers("alpha") {
        for method in methods() {
            for filter in [Filter::Box, Filter::Centre] {
                let settings = RenderSettings {
                    method,
                    filter,
                    ..settings(size, from_above(6.0, 0.8), rays)
                };
                let image = render(&mut **renderer, &scene, &settings);
                let what = format!("{}, {method:?}, {filter:?}", renderer.name());
                let all = rays as usize * image.linear.len();
                assert_mean(&what, mean(&image).truncate(), expected, 2.0, all);
                assert_eq!(mean(&image).w, 1.0);
            }
        }
    }
}

/// A texture of two columns, opaque on the left and thin on the right.
fn half_thin(alpha: u8) -> Texture {
    Texture {
        size: UVec2::new(2, 1),
        texels: vec![[255, 0, 0, 255], [255, 0, 0, alpha]],
        srgb: true,
        wrap: [Wrap::Clamp; 2],
    }
}

#[test]
fn a_mask_is_cut_out_exactly() {
    // Alpha falls from 1 to 0.2 between u = 1/4 and u = 3/4: it passes 0.6 in the middle.
    let opacity = Opacity::Mask {
        cutoff: 0.6,
        alpha: Alpha {
            factor: 1.0,
            texture: Some(0.into()),
        },
    };
    let material = Material {
        opacity,
        ..unlit(Vec3::ONE)
    };
    let mut description = describe(vec![square(0.0, 1.0, 0)], vec![material], None);
    description.textures = vec![half_thin(51)];
    let scene = SceneBuffers::build(&description).unwrap();
    let size = UVec2::new(20, 20);
    let camera = from_above(2.0, 2.0 * 0.5f32.atan());
    for renderer in &mut tracers("mask") {
        let image = render(&mut **renderer, &scene, &settings(size, camera, 4));
        for (i, value) in image.linear.iter().enumerate() {
            let expected = if i % 20 < 10 { Vec4::ONE } else { Vec4::ZERO };
            assert_eq!(*value, expected, "pixel {i}");
        }
    }
}

#[test]
fn a_thin_box_lets_as_much_light_in_as_its_alpha_leaves() {
    let thin = Material {
        opacity: Opacity::Blend {
            alpha: Alpha {
                factor: 0.25,
                texture: None,
            },
        },
        ..matt(0.0)
    };
    let floor = square(-0.5, 0.4, 1);
    let scene = build(vec![cube(1.0, 0), floor], vec![thin, matt(0.8)]);
    let size = UVec2::new(12, 12);
    let camera = from_above(0.5, 0.5);
    for renderer in &mut tracers("thin box") {
        for method in methods() {
            let settings = RenderSettings {
                method,
                ..settings(size, camera, 64)
            };
            let image = render(&mut **renderer, &scene, &settings);
            let what = format!("{}, {method:?}", renderer.name());
            let all = 64 * image.linear.len();
            let found = mean(&image).truncate();
            // A sample of several may count more than the mean.
            assert_mean(&what, found, Vec3::splat(0.8 * 0.75), 2.0, all);
        }
    }
}

#[test]
fn transfer_passes_thin_surfaces() {
    let thin = |factor| Material {
        opacity: Opacity::Blend {
            alpha: Alpha {
                factor,
                texture: None,
            },
        },
        ..matt(0.0)
    };
    let settings = BakeSettings {
        bands: 1,
        directions: 10_000,
        seed: 1,
    };
    for alpha in [0.0, 0.25, 1.0] {
        let floor = square(-0.5, 0.4, 1);
        let scene = build(vec![cube(1.0, 0), floor], vec![thin(alpha), matt(0.8)]);
        let baked = bake(&scene, &settings, &|_| ()).unwrap();
        let found = &baked.transfer;
        // ∫ ⟨n·ω⟩ y₀ dω = π y₀; floor's vertices come after the cube's.
        let whole = std::f32::consts::PI.sqrt() * 0.5;
        for vertex in 24..28 {
            let (lit, blocked) = (found.lit[vertex] / whole, found.blocked[vertex] / whole);
            assert!((lit - (1.0 - alpha)).abs() < 0.03, "{alpha}: {lit}");
            assert!(
                (lit + blocked - 1.0).abs() < 0.01,
                "{alpha}: {lit} {blocked}"
            );
        }
    }
}

#[test]
fn emission_adds_to_what_is_reflected() {
    let emission = Vec3::new(2.0, 0.25, 7.0);
    let mut description = describe(
        vec![square(0.0, 4.0, 0)],
        vec![Material {
            emission,
            emission_texture: Some(0.into()),
            ..matt(0.5)
        }],
        None,
    );
    description.textures = vec![Texture {
        size: UVec2::ONE,
        texels: vec![[255, 51, 102, 255]],
        srgb: false,
        wrap: [Wrap::Repeat; 2],
    }];
    let scene = SceneBuffers::build(&description).unwrap();
    let expected = Vec3::splat(0.5) + emission * Vec3::new(1.0, 0.2, 0.4);
    for renderer in &mut tracers("emission") {
        for method in methods() {
            let settings = RenderSettings {
                method,
                ..settings(UVec2::splat(12), from_above(3.0, 0.5), 64)
            };
            let image = render(&mut **renderer, &scene, &settings);
            let what = format!("{}, {method:?}", renderer.name());
            let all = 64 * image.linear.len();
            assert_mean(&what, mean(&image).truncate(), expected, 2.0, all);
        }
    }
}

#[test]
fn vertex_colours_multiply_albedo() {
    let mut mesh = square(0.0, 1.0, 0);
    mesh.colors = [0.0, 1.0, 1.0, 0.0]
        .map(|red| Vec4::new(red, 0.5, 0.25, 1.0))
        .to_vec();
    let both = [
        matt(0.8),
        Material::from(Reflection::MetallicRoughness {
            base_color: Vec3::splat(0.8),
            metallic: 0.0,
            roughness: 1.0,
            base_color_texture: None,
            metallic_roughness_texture: None,
            normal_texture: None,
            normal_scale: 1.0,
        }),
        unlit(Vec3::splat(0.8)),
    ];
    let size = UVec2::new(20, 1);
    let camera = from_above(2.0, 2.0 * 0.5f32.atan());
    for (index, material) in both.into_iter().enumerate() {
        let scene = build(vec![mesh.clone()], vec![material.clone()]);
        let view = scene.view();
        let settings = RenderSettings {
            filter: Filter::Centre,
            ..settings(size, camera, 1)
        };
        let frame = settings.frame_params().unwrap();
        for pixel in 0..size.x {
            let ray = frame.camera_ray(&frame.pattern_of(pixel));
            let hit = view.closest_hit(&ray).unwrap();
            let point = view.shading_point(&ray, &hit);
            let red = (pixel as f32 + 0.5) / 20.0;
            let base = Vec3::new(red, 0.5, 0.25) * 0.8;
            let (expected, found) = match index {
                0 => (base, point.brdf.diffuse),
                1 => (base * 0.96, point.brdf.diffuse),
                _ => (base, point.emission),
            };
            let off = (expected - found).abs().max_element();
            assert!(off < 1e-4, "{index}: {found}, not {expected}");
        }
    }
    // A material of an object's own stands for the whole surface.
    let mut description = describe(vec![mesh], vec![matt(0.8)], None);
    description.objects[0].material = Some(0);
    let scene = SceneBuffers::build(&description).unwrap();
    assert!(scene.view().triangles.iter().all(|t| t.attributes == 0));
}

#[test]
fn textures_are_looked_up_where_their_transform_says() {
    // Turned by a quarter, scaled by two and moved, as glTF's offset, rotation and scale do.
    let transform = Affine2::from_scale_angle_translation(
        Vec2::new(2.0, 1.0),
        -std::f32::consts::FRAC_PI_2,
        Vec2::new(0.25, 0.5),
    );
    let texture = TextureRef {
        texture: 0,
        transform,
    };
    let material = Material::from(Reflection::Unlit {
        color: Vec3::ONE,
        color_texture: Some(texture),
    });
    let mut description = describe(vec![square(0.0, 1.0, 0)], vec![material], None);
    let side = 64u32;
    let texel = |i: u32| [(4 * (i % side)) as u8, (4 * (i / side)) as u8, 0, 255];
    description.textures = vec![Texture {
        size: UVec2::splat(side),
        texels: (0..side * side).map(texel).collect(),
        srgb: false,
        wrap: [Wrap::Repeat; 2],
    }];
    let scene = SceneBuffers::build(&description).unwrap();
    let settings = RenderSettings {
        filter: Filter::Centre,
        ..settings(UVec2::new(10, 10), from_above(2.0, 2.0 * 0.5f32.atan()), 1)
    };
    for renderer in &mut tracers("transform") {
        let image = render(&mut **renderer, &scene, &settings);
        for (i, value) in image.linear.iter().enumerate() {
            let uv = Vec2::new((i % 10) as f32 + 0.5, 9.5 - (i / 10) as f32) / 10.0;
            let place = transform.transform_point2(uv).map(|x| x - x.floor());
            // Where it is not filtered across the edge.
            if place.min_element() > 0.02 && place.max_element() < 0.98 {
                let expected = (place * 64.0 - 0.5) * (4.0 / 255.0);
                let off = (value.truncate().truncate() - expected).abs();
                assert!(off.max_element() < 2e-3, "{i}: {value} {expected}");
            }
        }
    }
}

/// A catcher, and in its plane a square.
fn coplanar() -> SceneBuffers {
    let meshes = vec![square(0.0, 20.0, 1), square(0.0, 1.0, 0)];
    let materials = vec![unlit(Vec3::ONE), matt(0.5)];
    let mut description = describe(meshes, materials, Some(0));
    for object in &mut description.objects {
        // A plane whose distances are rounded.
        object.transform = Mat4::from_rotation_y(0.37) * Mat4::from_rotation_x(0.21);
    }
    SceneBuffers::build(&description).unwrap()
}

/// A view of it at a flat angle.
fn flat_view() -> RenderSettings {
    let turned = Mat4::from_rotation_y(0.37) * Mat4::from_rotation_x(0.21);
    let camera = Camera {
        eye: turned.transform_point3(Vec3::new(9.1, 3.3, 1.1)),
        target: Vec3::ZERO,
        up: turned.transform_vector3(Vec3::Z),
        fov_x: 0.04,
    };
    settings(UVec2::new(64, 32), camera, 1)
}

#[test]
fn what_lies_on_a_catcher_is_seen() {
    let scene = coplanar();
    for renderer in &mut tracers("coplanar") {
        let image = render(&mut **renderer, &scene, &flat_view());
        let seen = image.linear.iter().filter(|v| v.w == 1.0).count();
        // All of the view is inside the square.
        assert_eq!(seen, image.linear.len());
    }
}

/// As if every vertex were in the open.
fn open_transfer(scene: &SceneBuffers) -> Transfer {
    let vertices = scene.vertices().unwrap();
    let whole = std::f32::consts::PI.sqrt() * 0.5;
    Transfer {
        bands: 1,
        lit: vec![whole; vertices.len()],
        blocked: vec![0.0; vertices.len()],
    }
}

fn drawers(test: &str) -> Vec<Box<dyn Renderer>> {
    let mut all: Vec<Box<dyn Renderer>> = vec![Box::new(CpuDrawing::default())];
    if let Some(context) = adapter_or_skip(test) {
        all.push(Box::new(GpuDrawing::on(context).unwrap()));
    }
    all
}

#[test]
fn drawn_surfaces_are_those_that_rays_see() {
    let (top, below) = (Vec3::new(1.0, 0.0, 0.0), Vec3::new(0.0, 1.0, 0.5));
    let thin = Material {
        opacity: Opacity::Blend {
            alpha: Alpha {
                factor: 0.3,
                texture: None,
            },
        },
        ..unlit(top)
    };
    let mut stack = build(
        vec![square(1.0, 4.0, 0), square(0.0, 4.0, 1)],
        vec![thin, unlit(below)],
    );
    let transfer = open_transfer(&stack);
    stack.set_transfer(Arc::new(transfer), &[]).unwrap();
    let mut plane = coplanar();
    let transfer = open_transfer(&plane);
    plane.set_transfer(Arc::new(transfer), &[]).unwrap();
    for renderer in &mut drawers("drawn") {
        let view = settings(UVec2::splat(64), from_above(6.0, 0.8), 4);
        let image = render(&mut **renderer, &stack, &view);
        let expected = top * 0.3 + below * 0.7;
        let all = 4 * image.linear.len();
        assert_mean(
            &renderer.name(),
            mean(&image).truncate(),
            expected,
            1.0,
            all,
        );

        let image = render(&mut **renderer, &plane, &flat_view());
        let seen = image.linear.iter().filter(|v| v.w == 1.0).count();
        assert_eq!(seen, image.linear.len(), "{}", renderer.name());
    }
}

#[test]
fn opaque_pictures_cost_nothing() {
    let blend = |texture| Material {
        opacity: Opacity::Blend {
            alpha: Alpha {
                factor: 1.0,
                texture: Some(TextureRef::from(texture)),
            },
        },
        ..unlit(Vec3::ONE)
    };
    for (alpha, expected) in [(255, false), (254, true)] {
        let mut description = describe(vec![square(0.0, 1.0, 0)], vec![blend(0)], None);
        description.textures = vec![half_thin(alpha)];
        let scene = SceneBuffers::build(&description).unwrap();
        assert_eq!(scene.is_see_through(), expected);
    }
}
