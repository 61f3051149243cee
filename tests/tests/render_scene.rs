//! Host file: scenes as the kernels see them: the tree's hits, attributes, materials, and what is refused.

use std::time::Duration;

use glam::{Mat4, UVec2, Vec2, Vec3, Vec3A, Vec4};
use glimt_render_gpu::cpu::CpuRenderer;
use glimt_render_gpu::kernels::bvh::{any_hit, closest_hit};
use glimt_render_gpu::kernels::diagnose::surface;
use glimt_render_gpu::kernels::ray::Ray;
use glimt_render_gpu::kernels::triangle::{Triangle, intersect};
use glimt_render_gpu::methods::Mis;
use glimt_render_gpu::prepare::env::{EnvError, EnvMap};
use glimt_render_gpu::prepare::render::{Filter, RenderSettings, Renderer, SettingsError};
use glimt_render_gpu::prepare::scene::{
    Camera, Material, Mesh, Object, Reflection, SceneDescription, Texture, Wrap,
};
use glimt_render_gpu::prepare::scene_build::SceneBuffers;
use glimt_render_gpu::prepare::scene_error::SceneError;
use glimt_sampling::warp::sample_uniform_sphere;
use glimt_sampling::{UniformSource, Xoshiro128PlusPlus, unit_f32, unit_vec2};
use obvhs::ray::RayHit;

fn grey() -> Material {
    Material::from(Reflection::BlinnPhong {
        diffuse: Vec3::splat(0.5),
        specular: Vec3::ZERO,
        exponent: 1.0,
    })
}

fn object(mesh: u32, transform: Mat4) -> Object {
    Object {
        mesh,
        transform,
        material: None,
        catcher: false,
    }
}

/// A torus with bumps: folds that hide one another, and long thin faces.
fn bumpy_torus(columns: u32, rows: u32) -> Mesh {
    let mut mesh = Mesh {
        name: "torus".into(),
        materials: vec![0],
        ..Mesh::default()
    };
    let turn = std::f32::consts::TAU;
    for column in 0..columns {
        for row in 0..rows {
            let (a, b) = (
                turn * column as f32 / columns as f32,
                turn * row as f32 / rows as f32,
            );
            let tube = 0.4 + 0.08 * (9.0 * a).sin() * (7.0 * b).cos();
            let across = 1.0 + tube * b.cos();
            mesh.positions.push(Vec3::new(
                across * a.cos(),
                across * a.sin(),
                tube * b.sin(),
            ));
            let at = |c: u32, r: u32| (c % columns) * rows + r % rows;
            let corners = [
                at(column, row),
                at(column + 1, row),
                at(column + 1, row + 1),
                at(column, row + 1),
            ];
            mesh.indices.push([corners[0], corners[1], corners[2]]);
            mesh.indices.push([corners[0], corners[2], corners[3]]);
        }
    }
    mesh
}

fn one_mesh(mesh: Mesh, material: Material) -> SceneDescription {
    SceneDescription {
        meshes: vec![mesh],
        materials: vec![material],
        textures: vec![],
        objects: vec![object(0, Mat4::IDENTITY)],
    }
}

fn random_rays(count: u32) -> Vec<Ray> {
    let mut source = Xoshiro128PlusPlus::stream(11, 0, 0);
    (0..count)
        .map(|i| {
            let from = sample_uniform_sphere(unit_vec2(source.next_uvec2())).direction * 3.0;
            let inside = Vec3::new(1.0, 1.0, 0.4) * unit_f32(source.next_u32());
            let to = sample_uniform_sphere(unit_vec2(source.next_uvec2())).direction * inside;
            match i % 8 {
                // Along an axis, where two components of the direction are zero of either sign.
                0 => Ray::new(Vec3::new(to.x, to.y, 3.0), Vec3::new(0.0, -0.0, -1.0)),
                1 => Ray::new(Vec3::new(-3.0, to.y, to.z), Vec3::X),
                // From inside the box of everything.
                2 => Ray::new(to, from.normalize()),
                _ => Ray::new(from, (to - from).normalize()),
            }
        })
        .collect()
}

fn brute_force(triangles: &[Triangle], ray: &Ray) -> f32 {
    triangles
        .iter()
        .map(|t| intersect(t, ray, f32::MAX))
        .fold(f32::MAX, f32::min)
}

#[test]
fn hits_are_those_of_every_triangle_and_of_obvhs() {
    let scene = SceneBuffers::build(&one_mesh(bumpy_torus(160, 70), grey())).unwrap();
    let scene = scene.view();
    let boxed: Vec<_> = scene
        .triangles
        .iter()
        .map(|t| obvhs::triangle::Triangle {
            v0: t.a().into(),
            v1: t.b().into(),
            v2: t.c().into(),
        })
        .collect();
    let params = obvhs::BvhBuildParams::medium_build();
    let tree = obvhs::bvh2::builder::build_bvh2_from_tris(&boxed, params, &mut Duration::default());
    let (mut hits, mut against_all, mut differ) = (0, 0, 0);
    for (i, ray) in random_rays(100_000).iter().enumerate() {
        let ours = closest_hit(scene.nodes, scene.triangles, scene.surface, ray, f32::MAX);
        let t = ours.map_or(f32::MAX, |hit| hit.t);
        hits += u32::from(ours.is_some());
        assert_eq!(
            any_hit(scene.nodes, scene.triangles, scene.surface, ray, f32::MAX),
            ours.is_some()
        );
        if let Some(hit) = ours {
            let triangle = &scene.triangles[hit.triangle as usize];
            assert_eq!(intersect(triangle, ray, f32::MAX), hit.t);
            let b = hit.barycentrics;
            let there = triangle.a() * (1.0 - b.x - b.y) + triangle.b() * b.x + triangle.c() * b.y;
            // In a face seen at a grazing angle, rounding moves the point along the ray.
            let cos = triangle.area_normal().normalize().dot(ray.direction).abs();
            assert!(there.distance(ray.origin + ray.direction * hit.t) * cos < 1e-5);
            assert!(!any_hit(
                scene.nodes,
                scene.triangles,
                scene.surface,
                ray,
                hit.t
            ));
            assert!(any_hit(
                scene.nodes,
                scene.triangles,
                scene.surface,
                ray,
                hit.t * 1.001
            ));
        }
        let origin = Vec3A::from(ray.origin);
        let mut theirs = RayHit::none();
        tree.ray_traverse(
            obvhs::ray::Ray::new_inf(origin, ray.direction.into()),
            &mut theirs,
            |their_ray, primitive| {
                let triangle = &scene.triangles[tree.primitive_indices[primitive] as usize];
                let t = intersect(triangle, ray, their_ray.tmax);
                if t < f32::MAX { t } else { f32::INFINITY }
            },
        );
        let same = if t < f32::MAX {
            theirs.t == t
        } else {
            theirs.t == f32::INFINITY
        };
        differ += u32::from(!same);
        // Where the two disagree, and for a share of all rays, every triangle is asked.
        if !same || i % 100 == 0 {
            against_all += 1;
            assert_eq!(t, brute_force(scene.triangles, ray), "ray {i}: {ray:?}");
        }
    }
    println!("{hits} hits, {differ} unlike obvhs's, {against_all} rays against every triangle");
    assert!(hits > 30_000 && hits < 90_000);
    // obvhs's boxes are not padded against rounding, so it may lose a hit in a flat one; we may not.
    assert!(differ <= 10, "{differ} hits unlike obvhs's");
}

#[test]
fn real_meshes_have_no_holes() {
    let name = "models/stanford-bunny.obj";
    let Some(path) = glimt_tests::data::data_or_skip("render_scene", name) else {
        return;
    };
    let text = std::fs::read_to_string(path).unwrap();
    let mut mesh = Mesh {
        name: "bunny".into(),
        materials: vec![0],
        ..Mesh::default()
    };
    for line in text.lines() {
        let mut words = line.split_whitespace();
        let kind = words.next();
        let words: Vec<&str> = words.collect();
        if kind == Some("v") {
            mesh.positions.push(Vec3::from_array(
                [0, 1, 2].map(|i| words[i].parse().unwrap()),
            ));
        } else if kind == Some("f") {
            let corner = |w: &str| w.split('/').next().unwrap().parse::<u32>().unwrap() - 1;
            mesh.indices.push([0, 1, 2].map(|i| corner(words[i])));
        }
    }
    let scene = SceneBuffers::build(&one_mesh(mesh, grey())).unwrap();
    let (low, high) = scene.bounds();
    let (centre, size) = (0.5 * (low + high), (high - low).length());
    let view = scene.view();
    let mut source = Xoshiro128PlusPlus::stream(5, 0, 0);
    for _ in 0..2_000 {
        let from = centre + sample_uniform_sphere(unit_vec2(source.next_uvec2())).direction * size;
        let ray = Ray::new(from, (centre - from).normalize());
        let t = closest_hit(view.nodes, view.triangles, view.surface, &ray, f32::MAX)
            .map_or(f32::MAX, |h| h.t);
        assert_eq!(t, brute_force(view.triangles, &ray));
    }
}

/// A square around the origin in the plane z = 0, seen from above, with u along +x and v, downwards, along −y.
fn square() -> Mesh {
    Mesh {
        name: "square".into(),
        positions: [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]
            .map(|(x, y)| Vec3::new(x, y, 0.0))
            .to_vec(),
        uvs: [(0.0, 1.0), (1.0, 1.0), (1.0, 0.0), (0.0, 0.0)]
            .map(|(u, v)| Vec2::new(u, v))
            .to_vec(),
        indices: vec![[0, 1, 2], [0, 2, 3]],
        materials: vec![0],
        ..Mesh::default()
    }
}

fn from_above(size: u32) -> RenderSettings {
    let camera = Camera {
        eye: Vec3::new(0.0, 0.0, 100.0),
        target: Vec3::ZERO,
        up: Vec3::Y,
        fov_x: 2.0 * (0.01f32).atan(),
    };
    RenderSettings {
        filter: Filter::Centre,
        rays_per_pixel: 256,
        ..RenderSettings::new(UVec2::splat(size), camera)
    }
}

fn textured(texture: Texture) -> SceneDescription {
    SceneDescription {
        textures: vec![texture],
        ..one_mesh(
            square(),
            Material::from(Reflection::MetallicRoughness {
                base_color: Vec3::new(1.0, 0.5, 1.0),
                metallic: 0.0,
                roughness: 1.0,
                base_color_texture: Some(0.into()),
                metallic_roughness_texture: None,
                normal_texture: None,
                normal_scale: 1.0,
            }),
        )
    }
}

#[test]
fn textures_lie_as_images_do() {
    let codes = [
        [255, 0, 0, 255],
        [0, 255, 0, 255],
        [0, 0, 255, 255],
        [128, 128, 128, 255],
    ];
    let texture = Texture {
        size: UVec2::splat(2),
        texels: codes.to_vec(),
        srgb: true,
        wrap: [Wrap::Clamp; 2],
    };
    let scene = SceneBuffers::build(&textured(texture)).unwrap();
    let env = EnvMap::new(UVec2::new(4, 2), vec![Vec4::ONE; 8])
        .unwrap()
        .prepare(0.0)
        .unwrap();
    let image = CpuRenderer::default()
        .render_frame(&scene, &env, &from_above(2), &|_| ())
        .unwrap();
    // Full roughness has the exponent 0, whose lobe is flat: 0.96 of the base colour and 0.04 of white.
    let half = 0.215_860_5;
    let colors = [Vec3::X, Vec3::Y, Vec3::Z, Vec3::splat(half)];
    for (seen, color) in image.linear.iter().zip(colors) {
        let expected = color * Vec3::new(1.0, 0.5, 1.0) * 0.96 + Vec3::splat(0.04);
        assert!(
            (seen.truncate() - expected).abs().max_element() < 0.01,
            "{seen} {expected}"
        );
    }
}

/// The shading normal that one pixel above the middle of the first triangle sees.
fn bumped_normal(mesh: Mesh, transform: Mat4, normal_texel: [u8; 4]) -> Vec3 {
    let mut scene = textured(Texture {
        size: UVec2::ONE,
        texels: vec![normal_texel],
        srgb: false,
        wrap: [Wrap::Repeat; 2],
    });
    let Reflection::MetallicRoughness {
        base_color_texture,
        normal_texture,
        ..
    } = &mut scene.materials[0].reflection
    else {
        unreachable!()
    };
    std::mem::swap(base_color_texture, normal_texture);
    scene.meshes[0] = mesh;
    scene.objects[0].transform = transform;
    let scene = SceneBuffers::build(&scene).unwrap();
    let frame = from_above(1).frame_params().unwrap();
    let record = surface(0, &frame, scene.view());
    assert_eq!(record.hit, 1.0);
    record.normal
}

#[test]
fn normal_maps_lean_as_the_image_shows() {
    // A map that leans to the image's right (red) or top (green) by 45°.
    let (right, top) = ([218, 128, 218, 255], [128, 218, 218, 255]);
    let towards = |n: Vec3, d: Vec3| (n - (d + Vec3::Z).normalize()).length() < 0.01;
    let supplied = Mesh {
        tangents: vec![Vec3::X.extend(1.0); 4],
        ..square()
    };
    for mesh in [square(), supplied] {
        assert!(towards(
            bumped_normal(mesh.clone(), Mat4::IDENTITY, right),
            Vec3::X
        ));
        assert!(towards(
            bumped_normal(mesh.clone(), Mat4::IDENTITY, top),
            Vec3::Y
        ));
        // A mirror moves the image's right to the world's left and leaves its top.
        let mirror = Mat4::from_scale(Vec3::new(-1.0, 1.0, 1.0));
        assert!(towards(
            bumped_normal(mesh.clone(), mirror, right),
            Vec3::NEG_X
        ));
        assert!(towards(bumped_normal(mesh.clone(), mirror, top), Vec3::Y));
        let turned = Mat4::from_rotation_z(std::f32::consts::FRAC_PI_2);
        assert!(towards(bumped_normal(mesh.clone(), turned, right), Vec3::Y));
    }
    // An image laid on mirrored.
    let mut mirrored = square();
    mirrored.uvs.iter_mut().for_each(|uv| uv.x = 1.0 - uv.x);
    assert!(towards(
        bumped_normal(mirrored.clone(), Mat4::IDENTITY, right),
        Vec3::NEG_X
    ));
    assert!(towards(
        bumped_normal(mirrored, Mat4::IDENTITY, top),
        Vec3::Y
    ));
}

#[test]
fn normals_follow_a_squeezed_object() {
    let mut mesh = square();
    mesh.positions.iter_mut().for_each(|p| p.z = p.x);
    let squeeze = Mat4::from_scale(Vec3::new(0.5, 1.0, 2.0));
    let description = SceneDescription {
        objects: vec![object(0, squeeze)],
        ..one_mesh(mesh, grey())
    };
    let scene = SceneBuffers::build(&description).unwrap();
    let expected = Vec3::new(-4.0, 0.0, 1.0).normalize();
    for corner in scene.view().corners {
        assert!(corner.normal.distance(expected) < 1e-6);
    }
}

#[test]
fn degenerate_triangles_are_dropped_and_counted() {
    let mut mesh = square();
    mesh.positions.push(Vec3::new(0.0, -1.0, 0.0));
    mesh.uvs.clear();
    mesh.indices.extend([[0, 0, 1], [2, 2, 2], [0, 4, 1]]);
    let scene = SceneBuffers::build(&one_mesh(mesh.clone(), grey())).unwrap();
    assert_eq!(
        (scene.dropped_triangles(), scene.view().triangles.len()),
        (3, 2)
    );
    mesh.indices.drain(..2);
    let refused = SceneBuffers::build(&one_mesh(mesh, grey())).unwrap_err();
    assert_eq!(refused, SceneError::NoTriangles { dropped: 3 });
}

fn refusal(change: impl FnOnce(&mut SceneDescription)) -> String {
    let mut description = one_mesh(square(), grey());
    change(&mut description);
    SceneBuffers::build(&description).unwrap_err().to_string()
}

#[test]
fn bad_scenes_are_refused_with_the_place() {
    let refusals = [
        (refusal(|s| s.objects.clear()), "the scene has no triangles"),
        (
            refusal(|s| s.meshes[0].indices[1][2] = 9),
            "mesh 'square', triangle 1: vertex 9 of 4",
        ),
        (
            refusal(|s| s.meshes[0].materials = vec![0, 3]),
            "mesh 'square', triangle 1: material 3 of 1",
        ),
        (
            refusal(|s| s.meshes[0].materials = vec![0; 3]),
            "mesh 'square': 3 materials, expected 2",
        ),
        (
            refusal(|s| s.meshes[0].uvs.truncate(1)),
            "mesh 'square': 1 texture coordinates, expected 4",
        ),
        (
            refusal(|s| s.meshes[0].uvs[2].x = f32::NAN),
            "mesh 'square', vertex 2: its texture coordinate",
        ),
        (
            refusal(|s| s.meshes[0].positions[3].y = f32::INFINITY),
            "object 0, mesh 'square': vertex 3",
        ),
        (
            refusal(|s| s.objects[0].transform = Mat4::from_scale(Vec3::splat(1e12))),
            "object 0, mesh 'square': vertex 0",
        ),
        (
            refusal(|s| s.objects[0].transform = Mat4::ZERO),
            "object 0: its transform",
        ),
        (
            refusal(|s| s.objects[0].mesh = 1),
            "object 0: there is no mesh 1",
        ),
        (
            refusal(|s| s.objects[0].material = Some(4)),
            "object 0: there is no material 4",
        ),
        (
            refusal(|s| {
                s.materials[0] = Material::from(Reflection::BlinnPhong {
                    diffuse: Vec3::ONE,
                    specular: Vec3::ONE,
                    exponent: 1.0,
                });
            }),
            "material 0: ",
        ),
        (
            refusal(|s| {
                s.textures.push(Texture {
                    size: UVec2::new(2, 2),
                    texels: vec![[0; 4]; 3],
                    srgb: false,
                    wrap: [Wrap::Repeat; 2],
                });
            }),
            "texture 0: 3 texels do not make 2 × 2",
        ),
    ];
    for (found, expected) in refusals {
        assert!(
            found.starts_with(expected),
            "'{found}' does not begin with '{expected}'"
        );
    }
    let unused_vertex = {
        let mut mesh = square();
        mesh.positions.push(Vec3::NAN);
        mesh.uvs.push(Vec2::ZERO);
        mesh
    };
    assert!(SceneBuffers::build(&one_mesh(unused_vertex, grey())).is_ok());
}

#[test]
fn bad_maps_and_settings_are_refused() {
    let size = UVec2::new(2, 1);
    let map = |texels: Vec<Vec4>| EnvMap::new(size, texels).map(|_| ());
    assert_eq!(map(vec![Vec4::ONE; 2]), Ok(()));
    assert_eq!(
        map(vec![Vec4::ONE; 3]),
        Err(EnvError::Size {
            width: 2,
            height: 1,
            len: 3
        })
    );
    let mut texels = vec![Vec4::ONE, Vec4::new(1.0, f32::NAN, -1.0, 0.0)];
    assert_eq!(
        map(texels.clone()),
        Err(EnvError::Texel { column: 1, row: 0 })
    );
    assert_eq!(EnvMap::repair(&mut texels), 1);
    assert_eq!((texels[1], map(texels.clone())), (Vec4::X, Ok(())));

    let good = from_above(4);
    let refused = |change: fn(&mut RenderSettings)| {
        let mut settings = good;
        change(&mut settings);
        settings.frame_params().unwrap_err()
    };
    assert!(good.frame_params().is_ok());
    assert_eq!(refused(|s| s.size.x = 0), SettingsError::Empty);
    assert_eq!(refused(|s| s.rays_per_pixel = 0), SettingsError::Empty);
    assert_eq!(
        refused(|s| {
            let none = Mis {
                brdf_samples: 0,
                env_samples: 0,
                ..Mis::default()
            };
            s.method = none.into();
        })
        .to_string(),
        "brdf_samples: it is 0, and render.env_samples too; one of them must be at least 1"
    );
    // More rays than 32 bits count, but no tile has as many.
    let mut large = good;
    large.size = UVec2::splat(1 << 15);
    assert!(large.frame_params().is_ok());
    assert_eq!(
        refused(|s| s.size = UVec2::splat(1 << 16)),
        SettingsError::TooMany
    );
    assert_eq!(
        refused(|s| s.camera.target = s.camera.eye),
        SettingsError::Camera
    );
    assert_eq!(refused(|s| s.camera.up = Vec3::Z), SettingsError::Camera);
    assert_eq!(
        refused(|s| s.camera.fov_x = 4.0),
        SettingsError::FieldOfView
    );
    assert_eq!(refused(|s| s.exposure_ev = 1e9), SettingsError::Exposure);
}

#[test]
fn one_triangle_and_many_equal_ones_make_a_tree() {
    let mut mesh = square();
    mesh.indices.truncate(1);
    let one = SceneBuffers::build(&one_mesh(mesh.clone(), grey())).unwrap();
    let ray = Ray::new(Vec3::new(0.5, -0.5, 1.0), Vec3::NEG_Z);
    let hit = |scene: &SceneBuffers| {
        closest_hit(
            scene.view().nodes,
            scene.view().triangles,
            scene.view().surface,
            &ray,
            f32::MAX,
        )
    };
    assert_eq!(hit(&one).unwrap().t, 1.0);
    // The same place for every centroid: no split can part them.
    mesh.indices = vec![mesh.indices[0]; 5_000];
    let many = SceneBuffers::build(&one_mesh(mesh, grey())).unwrap();
    assert_eq!(hit(&many).unwrap().t, 1.0);
}
