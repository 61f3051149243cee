//! Host file: precomputed radiance transfer as it is drawn: light at vertices and pixels against integrals in f64.

use std::f64::consts::PI;
use std::sync::Arc;

use glam::{DVec3, Mat4, UVec2, Vec3, Vec4};
use glimt_render_gpu::cpu::CpuDrawing;
use glimt_render_gpu::kernels::prt::vertex_light;
use glimt_render_gpu::methods::Prt;
use glimt_render_gpu::prepare::env::{EnvMap, PreparedEnv};
use glimt_render_gpu::prepare::light_sh::LightSh;
use glimt_render_gpu::prepare::plate::Plate;
use glimt_render_gpu::prepare::render::{
    Background, Filter, FrameImage, RenderError, RenderSettings, Renderer, SettingsError,
};
use glimt_render_gpu::prepare::scene::{
    Camera, Material, Mesh, Object, Reflection, SceneDescription,
};
use glimt_render_gpu::prepare::scene_build::SceneBuffers;
use glimt_render_gpu::prepare::transfer::{SurfaceVertex, Transfer, TransferError};
use glimt_sh::{ShError, basis, cosine_lobe};
use glimt_tests::quadrature::integrate_sphere;
use glimt_tests::worst::largest_share;

const ALBEDO: Vec3 = Vec3::new(0.7, 0.5, 0.3);

/// A sphere of radius 1 in rings of quads, with the normals of a true one.
fn sphere(rings: u32) -> Mesh {
    let at = |ring: u32, segment: u32| {
        let theta = PI * f64::from(ring) / f64::from(rings);
        let phi = PI * f64::from(segment) / f64::from(rings);
        DVec3::new(
            theta.sin() * phi.cos(),
            theta.sin() * phi.sin(),
            theta.cos(),
        )
        .as_vec3()
    };
    let segments = 2 * rings;
    let positions: Vec<Vec3> = (0..=rings)
        .flat_map(|r| (0..segments).map(move |s| at(r, s)))
        .collect();
    let mut indices = Vec::new();
    for ring in 0..rings {
        for segment in 0..segments {
            let [a, b] = [ring * segments, (ring + 1) * segments];
            let next = (segment + 1) % segments;
            indices.push([a + segment, b + segment, b + next]);
            indices.push([a + segment, b + next, a + next]);
        }
    }
    Mesh {
        normals: positions.clone(),
        positions,
        indices,
        materials: vec![0],
        ..Mesh::default()
    }
}

fn plane(half: f32) -> Mesh {
    Mesh {
        positions: [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]
            .map(|[x, y]: [f32; 2]| Vec3::new(x * half, y * half, -1.0))
            .to_vec(),
        indices: vec![[0, 1, 2], [0, 2, 3]],
        materials: vec![0],
        ..Mesh::default()
    }
}

fn scene(meshes: Vec<(Mesh, bool)>) -> SceneBuffers {
    let objects = meshes.iter().enumerate().map(|(i, (_, catcher))| Object {
        mesh: i as u32,
        transform: Mat4::IDENTITY,
        material: None,
        catcher: *catcher,
    });
    SceneBuffers::build(&SceneDescription {
        objects: objects.collect(),
        meshes: meshes.into_iter().map(|(mesh, _)| mesh).collect(),
        materials: vec![Material::from(Reflection::BlinnPhong {
            diffuse: ALBEDO,
            specular: Vec3::ZERO,
            exponent: 1.0,
        })],
        ..SceneDescription::default()
    })
    .unwrap()
}

/// Transfer without shadows, by its closed form; `blocked` says which share of each vertex's is kept away.
fn unshadowed(
    scene: &SceneBuffers,
    bands: u32,
    blocked: impl Fn(&SurfaceVertex) -> f32,
) -> Transfer {
    let mut transfer = Transfer {
        bands,
        ..Transfer::default()
    };
    for vertex in scene.vertices().unwrap() {
        let (y, share) = (basis(vertex.normal), blocked(&vertex));
        for l in 0..bands {
            for k in l * l..(l + 1) * (l + 1) {
                let c = cosine_lobe(l) * y[k as usize];
                transfer.lit.push(c * (1.0 - share));
                transfer.blocked.push(c * share);
            }
        }
    }
    transfer
}

/// Light with a sun, in colours, of a size that is a multiple of nothing.
fn light(rotate_z_deg: f32) -> PreparedEnv {
    let size = UVec2::new(61, 29);
    let texel = |i: u32| {
        let (x, y) = ((i % size.x) as f32, (i / size.x) as f32);
        let sky = Vec3::new(1.0 + (0.3 * x).sin(), 1.2 + (0.5 * y).cos(), 0.8 + 0.01 * x);
        let sun = if i == 7 * size.x + 40 { 300.0 } else { 0.0 };
        (sky + Vec3::new(1.0, 0.9, 0.7) * sun).extend(1.0)
    };
    let texels = (0..size.element_product()).map(texel).collect();
    EnvMap::new(size, texels)
        .unwrap()
        .prepare(rotate_z_deg)
        .unwrap()
}

fn project(env: &PreparedEnv, bands: u32) -> [Vec4; 36] {
    LightSh::default()
        .project(env, bands, &Prt::default())
        .unwrap()
}

/// Radiance of a convex surface of this normal under the light's first bands, by integration.
fn integrated(coefficients: &[Vec4; 36], bands: u32, normal: Vec3) -> DVec3 {
    let n = normal.as_dvec3();
    let channel = |c: usize| {
        let f = |d: [f64; 3]| {
            let y = basis(DVec3::from(d).as_vec3());
            let light: f64 = (0..(bands * bands) as usize)
                .map(|k| f64::from(coefficients[k][c]) * f64::from(y[k]))
                .sum();
            light * n.dot(DVec3::from(d)).max(0.0)
        };
        integrate_sphere(f, 1e-5).value * f64::from(ALBEDO[c]) / PI
    };
    DVec3::new(channel(0), channel(1), channel(2))
}

fn settings(size: UVec2) -> RenderSettings {
    let camera = Camera {
        eye: Vec3::new(4.0, 1.0, 1.5),
        target: Vec3::ZERO,
        up: Vec3::Z,
        fov_x: 0.6,
    };
    RenderSettings {
        filter: Filter::Centre,
        rays_per_pixel: 1,
        background: Background::Transparent,
        ..RenderSettings::new(size, camera)
    }
}

fn render(
    scene: &SceneBuffers,
    env: &PreparedEnv,
    plate: Option<&Plate>,
    settings: &RenderSettings,
) -> FrameImage {
    CpuDrawing::default()
        .render_over(scene, env, plate, settings, &|_| ())
        .unwrap()
}

/// Largest difference as a share of the largest value; without end where one is no number.
fn distance(pairs: &[(DVec3, DVec3)]) -> f64 {
    largest_share(pairs.iter().map(|(a, b)| (a.extend(0.0), b.extend(0.0))))
}

#[test]
fn a_convex_object_reflects_the_integral_of_band_limited_light() {
    let scene = scene(vec![(sphere(8), false)]);
    let env = light(0.0);
    for bands in [1, 3, 5, 6] {
        let transfer = unshadowed(&scene, bands, |_| 0.0);
        let c = project(&env, bands);
        let n = transfer.coefficients() as u32;
        let normals = [Vec3::Z, Vec3::NEG_Z, Vec3::X, Vec3::new(0.6, -0.64, 0.48)];
        let pairs: Vec<(DVec3, DVec3)> = normals
            .iter()
            .map(|normal| {
                let y = basis(*normal);
                let lit: Vec<f32> = (0..n as usize)
                    .map(|k| cosine_lobe((k as f32).sqrt() as u32) * y[k])
                    .collect();
                let at = vertex_light(0, n, 1, &c, &lit, &vec![0.0; n as usize]);
                let radiance = at.lit * ALBEDO * std::f32::consts::FRAC_1_PI;
                (radiance.as_dvec3(), integrated(&c, bands, *normal))
            })
            .collect();
        let apart = distance(&pairs);
        assert!(apart < 2e-5, "{bands} bands: {apart:e} apart");
        // Without 1/π, as Eq. 14 is printed, it would not pass.
        let wrong: Vec<_> = pairs.iter().map(|(a, b)| (*a * PI, *b)).collect();
        assert!(!(distance(&wrong) < 2e-5));
    }
}

#[test]
fn pixels_show_the_light_of_their_normals() {
    let scene_at = |rings| {
        let mut scene = scene(vec![(sphere(rings), false)]);
        let transfer = unshadowed(&scene, 5, |_| 0.0);
        scene.set_transfer(Arc::new(transfer), &[]).unwrap();
        scene
    };
    let env = light(25.0);
    let c = project(&env, 5);
    let settings = settings(UVec2::new(40, 30));
    let worst = |rings| {
        let image = render(&scene_at(rings), &env, None, &settings);
        let view = settings.camera.view(settings.size).unwrap();
        let mut pairs = Vec::new();
        for (i, pixel) in (0u32..).zip(&image.linear) {
            let p = UVec2::new(i % 40, i / 40).as_vec2() + 0.5;
            let d = view.direction(p, settings.size);
            let b = view.eye.dot(d);
            let root = b * b - view.eye.length_squared() + 1.0;
            // Where the ray grazes, the polygon and the sphere are not hit alike.
            if root < 0.1 {
                continue;
            }
            let normal = view.eye + d * (-b - root.sqrt());
            let y = basis(normal.normalize());
            let lit: Vec3 = (0..25)
                .map(|k| c[k].truncate() * y[k] * cosine_lobe((k as f32).sqrt() as u32))
                .sum();
            let expected = lit.max(Vec3::ZERO) * ALBEDO * std::f32::consts::FRAC_1_PI;
            assert_eq!(pixel.w, 1.0);
            pairs.push((pixel.truncate().as_dvec3(), expected.as_dvec3()));
        }
        assert!(pairs.len() > 300);
        distance(&pairs)
    };
    // Linear across a triangle: four times nearer with twice the rings.
    let (coarse, fine) = (worst(40), worst(80));
    assert!(
        fine < 2e-3 && fine < 0.4 * coarse,
        "{coarse:e}, then {fine:e}"
    );
}

#[test]
fn interpolated_coefficients_give_interpolated_light() {
    let c = project(&light(0.0), 4);
    let corner = |d: Vec3| -> Vec<f32> { basis(d.normalize())[..16].to_vec() };
    let corners = [Vec3::X, Vec3::new(0.8, 0.5, 0.1), Vec3::new(0.5, 0.1, 0.9)].map(corner);
    let weights = [0.2, 0.5, 0.3f32];
    let zero = vec![0.0; 16];
    let light = |lit: &[f32]| vertex_light(0, 16, 1, &c, lit, &zero).lit;
    let mixed: Vec<f32> = (0..16)
        .map(|k| (0..3).map(|i| weights[i] * corners[i][k]).sum())
        .collect();
    let of_mixed = light(&mixed);
    let mix: Vec3 = (0..3).map(|i| light(&corners[i]) * weights[i]).sum();
    assert!(
        (of_mixed - mix).length() < 1e-6 * mix.length(),
        "{of_mixed}, {mix}"
    );
}

#[test]
fn a_mirror_shows_the_map() {
    let mut scene = scene(vec![(sphere(200), false)]);
    let transfer = Arc::new(unshadowed(&scene, 3, |_| 0.0));
    let env = light(70.0);
    let settings = settings(UVec2::new(24, 18));
    scene.set_transfer(Arc::clone(&transfer), &[]).unwrap();
    let matt = render(&scene, &env, None, &settings);
    scene.set_transfer(transfer, &[0.4]).unwrap();
    let mirror = render(&scene, &env, None, &settings);
    let view = settings.camera.view(settings.size).unwrap();
    let mut seen = 0;
    for (i, (with, without)) in (0u32..).zip(mirror.linear.iter().zip(&matt.linear)) {
        let p = UVec2::new(i % 24, i / 24).as_vec2() + 0.5;
        let d = view.direction(p, settings.size);
        let b = view.eye.dot(d);
        let root = b * b - view.eye.length_squared() + 1.0;
        if root < 0.3 {
            continue;
        }
        let n = (view.eye + d * (-b - root.sqrt())).normalize();
        let mirrored = d - n * (2.0 * d.dot(n));
        let expected = env.view().background(mirrored) * 0.4;
        let got = (*with - *without).truncate();
        let near = |e: Vec3| (got - e).length() < 0.02 * expected.length().max(1.0);
        // Beside the sun the map is steep.
        if expected.max_element() < 1.5 {
            assert!(near(expected), "pixel {i}: {got}, not {expected}");
            assert!(!near(expected * 1.2));
            seen += 1;
        }
    }
    assert!(seen > 60, "{seen}");
}

#[test]
fn a_plate_takes_baked_shadows_and_is_else_untouched() {
    let mut scene = scene(vec![(sphere(30), false), (plane(4.0), true)]);
    let half_dark = |v: &SurfaceVertex| {
        if v.position.x > 0.0 && v.position.z == -1.0 {
            0.5
        } else {
            0.0
        }
    };
    let transfer = unshadowed(&scene, 4, half_dark);
    scene.set_transfer(Arc::new(transfer), &[]).unwrap();
    let size = UVec2::new(48, 36);
    let codes: Vec<[u8; 3]> = (0..size.element_product())
        .map(|i| [i * 37, i * 101 + 5, i * 59 + 9].map(|code| (code % 256) as u8))
        .collect();
    let plate = Plate::from_srgb8(size, &codes).unwrap();
    let settings = RenderSettings {
        layers: true,
        ..settings(size)
    };
    let image = render(&scene, &light(0.0), Some(&plate), &settings);
    let layers = image.layers.as_ref().unwrap();
    let (mut dark, mut clear) = (0, 0);
    for (i, layer) in layers.iter().enumerate() {
        if layer.object.w > 0.0 {
            continue;
        }
        if layer.is_plate() {
            assert_eq!(image.linear[i].truncate(), plate.pixels()[i].linear);
            assert_eq!(image.display[i][..3], codes[i]);
            clear += 1;
        } else {
            let t = layer.transmission();
            assert!(
                t.min_element() >= 0.5 - 1e-5 && t.max_element() <= 1.0,
                "{t}"
            );
            dark += 1;
        }
    }
    assert!(dark > 20 && clear > 20, "{dark} {clear}");
    // Without shadows nothing is taken from the plate.
    let prt = Prt {
        shadows: false,
        ..Prt::default()
    };
    let image = render(
        &scene,
        &light(0.0),
        Some(&plate),
        &RenderSettings { prt, ..settings },
    );
    let shaded =
        |l: &&glimt_render_gpu::kernels::layers::PixelLayers| l.object.w == 0.0 && !l.is_plate();
    assert_eq!(image.layers.unwrap().iter().filter(shaded).count(), 0);
}

#[test]
fn light_of_earlier_frames_fades() {
    let mut scene = scene(vec![(sphere(8), false)]);
    let transfer = unshadowed(&scene, 2, |_| 0.0);
    scene.set_transfer(Arc::new(transfer), &[]).unwrap();
    let grey = |level: f32| {
        let map = EnvMap::new(UVec2::new(4, 2), vec![Vec4::splat(level); 8]);
        map.unwrap().prepare(0.0).unwrap()
    };
    let prt = Prt {
        temporal: 3.0,
        ..Prt::default()
    };
    let settings = RenderSettings {
        prt,
        ..settings(UVec2::new(9, 9))
    };
    let mut renderer = CpuDrawing::default();
    let mut middle = |level: f32| {
        let image = renderer
            .render_frame(&scene, &grey(level), &settings, &|_| ())
            .unwrap();
        image.linear[40].x / ALBEDO.x
    };
    assert!((middle(1.0) - 1.0).abs() < 1e-3);
    // A step to 5 is gone along by a quarter of what is left in each frame.
    for (frame, expected) in [(1, 2.0), (2, 2.75), (3, 3.3125)] {
        let got = middle(5.0);
        assert!((got - expected).abs() < 4e-3, "frame {frame}: {got}");
    }
    renderer.forget();
    let again = renderer
        .render_frame(&scene, &grey(5.0), &settings, &|_| ())
        .unwrap();
    assert!((again.linear[40].x / ALBEDO.x - 5.0).abs() < 4e-3);
}

#[test]
fn what_does_not_fit_is_refused() {
    let mut scene = scene(vec![(sphere(6), false)]);
    let mut renderer = CpuDrawing::default();
    let env = light(0.0);
    let settings = settings(UVec2::new(4, 4));
    let refused = |e: RenderError| match e {
        RenderError::Settings(e) => e,
        other => panic!("{other}"),
    };
    let none = renderer.render_frame(&scene, &env, &settings, &|_| ());
    assert_eq!(refused(none.unwrap_err()), SettingsError::NoTransfer);

    let good = unshadowed(&scene, 3, |_| 0.0);
    let vertices = scene.vertices().unwrap().len();
    let with = |change: &dyn Fn(&mut Transfer)| {
        let mut bad = good.clone();
        change(&mut bad);
        bad.check(vertices)
    };
    assert_eq!(with(&|_| ()), Ok(()));
    for bands in [0, 7] {
        assert_eq!(with(&|t| t.bands = bands), Err(TransferError::Bands(bands)));
    }
    let expected = 9 * vertices;
    let short = TransferError::Length {
        found: expected - 1,
        expected,
    };
    assert_eq!(with(&|t| t.blocked.truncate(expected - 1)), Err(short));
    assert_eq!(
        with(&|t| t.lit[10] = f32::NAN),
        Err(TransferError::NotFinite(1))
    );

    scene.set_transfer(Arc::new(good), &[]).unwrap();
    assert!(
        renderer
            .render_frame(&scene, &env, &settings, &|_| ())
            .is_ok()
    );
    for prt in [
        Prt {
            level: 32,
            ..Prt::default()
        },
        Prt {
            window: f32::NAN,
            ..Prt::default()
        },
        Prt {
            temporal: -1.0,
            ..Prt::default()
        },
        Prt {
            temporal: 1.1e6,
            ..Prt::default()
        },
    ] {
        let bad = RenderSettings { prt, ..settings };
        let error = renderer
            .render_frame(&scene, &env, &bad, &|_| ())
            .unwrap_err();
        assert!(matches!(refused(error), SettingsError::Setting(_)));
    }
    let light = LightSh::default().project(&env, 7, &Prt::default());
    let bands = SettingsError::Harmonics(ShError::Bands(7));
    assert_eq!(light.unwrap_err(), bands);
    assert!(bands.to_string().contains("7 bands"), "{bands}");
    // Kernels count in 32 bits.
    let huge = Transfer {
        bands: 6,
        ..Transfer::default()
    };
    let count = (1 << 32) / 36 + 1;
    assert_eq!(huge.check(count), Err(TransferError::TooMany(36 * count)));
    // An object that has moved has lost its transfer.
    scene.pose(&[Mat4::from_translation(Vec3::X)]).unwrap();
    let moved = renderer.render_frame(&scene, &env, &settings, &|_| ());
    assert_eq!(refused(moved.unwrap_err()), SettingsError::NoTransfer);
}
