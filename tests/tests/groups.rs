//! Host file: methods that estimate a pixel's light from the hits of all its rays: their means against quadrature, against long runs of
//! another method where normals vary within a pixel, and what they must leave alone.

use glam::{UVec2, Vec3, Vec4};
use glimt_render_gpu::gpu::GpuRenderer;
use glimt_render_gpu::kernels::group_health::GroupHealth;
use glimt_render_gpu::methods::{Cells, Method, Mis, Product};
use glimt_render_gpu::prepare::env::{EnvMap, PreparedEnv};
use glimt_render_gpu::prepare::render::{
    Background, Diagnostics, Filter, FrameImage, Pattern, RenderSettings, Renderer,
};
use glimt_render_gpu::prepare::scene::Camera;
use glimt_render_gpu::prepare::scene_build::SceneBuffers;
use glimt_statistics::stats::{Mean, sidak, z_test};
use glimt_tests::gpu::adapter_or_skip;
use glimt_tests::unbiased::{Case, assert_unbiased, camera, map, prepare, render, scene, settings};

fn product(rays: u32) -> Method {
    Product { rays }.into()
}

fn cells(rays: u32) -> Method {
    Cells {
        rays,
        ..Cells::default()
    }
    .into()
}

fn even_cells(rays: u32) -> Method {
    Cells {
        rays,
        adaptive: false,
        ..Cells::default()
    }
    .into()
}

#[test]
fn means_are_the_integral() {
    let case = |name, rays, method: Method, pattern| Case {
        name,
        settings: RenderSettings {
            method,
            ..settings(rays, pattern)
        },
    };
    for (material, sun) in [
        (scene(0.8, 0.0, 1.0), 50.0),
        (scene(0.3, 0.6, 50.0), 50.0),
        (scene(0.1, 0.9, 500.0), 50.0),
        // A smooth map: the lobe is sharper than the light.
        (scene(0.2, 0.8, 500.0), 1.0),
        (scene(0.05, 0.9, 200.0), 50.0),
    ] {
        assert_unbiased(
            &material,
            sun,
            &[
                case("product, 1 camera ray", 1, product(8), Pattern::OwenSobol),
                case("product, independent", 4, product(3), Pattern::Independent),
                case("cells, 4 camera rays", 4, cells(8), Pattern::OwenSobol),
                case("cells, stratified", 2, cells(5), Pattern::Stratified),
                case("cells, evenly", 1, even_cells(6), Pattern::OwenSobol),
            ],
        );
    }
}

/// A ground with a box and a small sphere, whose normals vary within a pixel, under a lamp and an uneven sky.
fn small_things(catcher: bool, diffuse: f64, specular: f64) -> SceneBuffers {
    let mut description = scene(diffuse, specular, 80.0).describe(24);
    description.objects[0].catcher = catcher;
    SceneBuffers::build(&description).unwrap()
}

/// A light map of these texels, by column and row, turned by so many degrees.
fn light(size: UVec2, rotate_z_deg: f32, texel: impl Fn(u32, u32) -> Vec4) -> PreparedEnv {
    let texels = (0..size.x * size.y).map(|i| texel(i % size.x, i / size.x));
    let map = EnvMap::new(size, texels.collect()).unwrap();
    map.prepare(rotate_z_deg).unwrap()
}

fn lamp_and_sky() -> PreparedEnv {
    light(UVec2::new(64, 32), 20.0, |x, y| {
        let wave = 1.0 + 0.6 * libm::sinf(0.4 * x as f32) * libm::cosf(0.3 * y as f32);
        let lamp = if (20..23).contains(&x) && (6..8).contains(&y) {
            60.0
        } else {
            0.0
        };
        Vec4::new(
            0.8 * wave + lamp,
            wave + 0.9 * lamp,
            1.2 * wave + 0.5 * lamp,
            1.0,
        )
    })
}

/// A sun, which a cell holds whole with the sky around it.
fn sun_in_a_cell() -> PreparedEnv {
    light(UVec2::new(256, 128), 20.0, |x, y| {
        let is_sun = (84..86).contains(&x) && (36..38).contains(&y);
        Vec4::splat(if is_sun { 400.0 } else { 1.0 })
    })
}

/// Coarse pixels: each of them sees much of the sphere.
fn coarse(method: Method, rays: u32, layers: bool) -> RenderSettings {
    let far = Camera {
        eye: 2.0 * camera().eye,
        ..camera()
    };
    RenderSettings {
        method,
        rays_per_pixel: rays,
        layers,
        background: Background::Transparent,
        ..RenderSettings::new(UVec2::new(18, 11), far)
    }
}

/// The numbers of an image that are compared: means over blocks of pixels, of the colours, or where there are layers of the objects' and
/// of the catchers' light, with and without objects. Of one pixel they would be too far from normally distributed: few rays are blocked.
fn numbers(image: &FrameImage) -> Vec<f64> {
    const BLOCK: UVec2 = UVec2::new(3, 4);
    let grid = UVec2::new(
        image.size.x.div_ceil(BLOCK.x),
        image.size.y.div_ceil(BLOCK.y),
    );
    let mut sums = vec![[0.0; 3]; grid.element_product() as usize];
    let grey = |colour: Vec3| f64::from(colour.element_sum()) / 3.0;
    for i in 0..image.linear.len() as u32 {
        let at = UVec2::new(i % image.size.x, i / image.size.x) / BLOCK;
        let own = match &image.layers {
            None => [grey(image.linear[i as usize].truncate()), 0.0, 0.0],
            Some(layers) => {
                let layer = &layers[i as usize];
                [layer.object.truncate(), layer.lit, layer.blocked].map(grey)
            }
        };
        for (sum, own) in sums[(at.y * grid.x + at.x) as usize].iter_mut().zip(own) {
            *sum += own;
        }
    }
    sums.concat()
}

/// Means over seeds of each number of the image.
fn means(
    scene: &SceneBuffers,
    env: &PreparedEnv,
    settings: RenderSettings,
    seeds: u32,
) -> Vec<Mean> {
    let images: Vec<Vec<f64>> = (0..seeds)
        .map(|seed| numbers(&render(scene, env, &RenderSettings { seed, ..settings })))
        .collect();
    (0..images[0].len())
        .map(|i| Mean::of(images.iter().map(|image| image[i])))
        .collect()
}

/// How many lists a test compares, at most: their numbers share one risk of a false alarm.
const LISTS: usize = 20;

/// Whether two lists of means are of the same numbers, each by itself and all together.
fn differ(a: &[Mean], b: &[Mean]) -> Result<(), String> {
    let alpha = sidak(0.01, LISTS * a.len());
    let (mut sum, mut variance) = (0.0, 0.0);
    for (i, (a, b)) in a.iter().zip(b).enumerate() {
        let apart = Mean {
            mean: a.mean - b.mean,
            standard_error: a.standard_error.hypot(b.standard_error),
            n: a.n.min(b.n),
        };
        z_test(apart, 0.0, alpha).map_err(|evidence| format!("number {i}: {evidence}"))?;
        sum += apart.mean;
        variance += apart.standard_error.powi(2);
    }
    match sum.abs() <= 4.0 * variance.sqrt() {
        true => Ok(()),
        false => Err(format!("in all {sum:e} ± {:e}", variance.sqrt())),
    }
}

#[test]
fn means_are_those_of_another_method_where_normals_vary() {
    let env = lamp_and_sky();
    let mis: Method = Mis {
        brdf_samples: 8,
        env_samples: 8,
        ..Mis::default()
    }
    .into();
    for (diffuse, specular) in [(0.8, 0.0), (0.3, 0.6)] {
        for layers in [false, true] {
            let scene = small_things(layers, diffuse, specular);
            let truth = means(&scene, &env, coarse(mis, 16, layers), 192);
            let mut named = vec![
                ("product", coarse(product(16), 9, layers)),
                ("cells", coarse(cells(16), 9, layers)),
                ("cells, few rays", coarse(cells(2), 5, layers)),
                // Less than a ray for a group of few.
                ("cells, evenly", coarse(even_cells(4), 16, layers)),
            ];
            let independent = RenderSettings {
                pattern: Pattern::Independent,
                ..coarse(cells(8), 4, layers)
            };
            named.push(("cells, independent", independent));
            for (name, settings) in named {
                let own = means(&scene, &env, settings, 192);
                differ(&own, &truth).unwrap_or_else(|why| panic!("{name}, layers {layers}: {why}"));
            }
            // Another surface is noticed.
            let other = small_things(layers, diffuse * 0.97, specular * 0.97);
            let wrong = means(&other, &env, coarse(cells(16), 9, layers), 192);
            assert!(differ(&wrong, &truth).is_err(), "layers {layers}");
        }
    }
}

/// A lamp that stands low in a dark sky.
fn low_lamp() -> PreparedEnv {
    light(UVec2::new(64, 32), 0.0, |x, y| {
        let lamp = if (30..33).contains(&x) && (12..15).contains(&y) {
            40.0
        } else {
            0.02
        };
        Vec4::new(lamp, 0.9 * lamp, 0.6 * lamp, 1.0)
    })
}

/// Surfaces that are seen flatly, and others that a lamp just reaches: lobes reflect below the horizon, and a group's members see what their
/// mean does not.
#[test]
fn means_are_those_of_another_method_at_rims() {
    let mis: Method = Mis {
        brdf_samples: 16,
        env_samples: 16,
        ..Mis::default()
    }
    .into();
    let low = |method, rays| {
        let settings = coarse(method, rays, false);
        let eye = Vec3::new(-9.0, 1.4, 0.9);
        RenderSettings {
            camera: Camera {
                eye,
                ..settings.camera
            },
            ..settings
        }
    };
    let (lamp, behind) = (lamp_and_sky(), low_lamp());
    for (specular, exponent, env) in [
        (0.9, 20.0, &lamp),
        (0.9, 200.0, &lamp),
        (0.0, 1.0, &behind),
        (0.9, 20.0, &behind),
    ] {
        let diffuse = if specular > 0.0 { 0.0 } else { 0.8 };
        let scene = SceneBuffers::build(&scene(diffuse, specular, exponent).describe(24)).unwrap();
        let truth = means(&scene, env, low(mis, 16), 192);
        for (name, method) in [("product", product(16)), ("cells", cells(16))] {
            let own = means(&scene, env, low(method, 16), 192);
            differ(&own, &truth)
                .unwrap_or_else(|why| panic!("{name}, e = {exponent}, ks = {specular}: {why}"));
        }
    }
}

/// Where no ray is blocked a catcher keeps its light to the bit, so that the plate is not touched.
#[test]
fn catchers_that_nothing_shades_stay_as_they_are() {
    let mut description = scene(0.7, 0.0, 1.0).describe(8);
    description.objects.truncate(1);
    description.objects[0].catcher = true;
    let scene = SceneBuffers::build(&description).unwrap();
    let env = lamp_and_sky();
    for method in [product(8), cells(8)] {
        let image = render(&scene, &env, &coarse(method, 4, true));
        let layers = image.layers.expect("they were asked for");
        assert!(layers.iter().any(|l| l.catcher > 0.5));
        for layer in &layers {
            assert_eq!(layer.blocked, Vec3::ZERO, "{method:?}");
            assert_eq!(layer.transmission(), Vec3::ONE, "{method:?}");
        }
    }
}

/// How each pixel fared.
fn health(image: &FrameImage) -> (&[GroupHealth], f64) {
    match &image.diagnostics {
        Some(Diagnostics::Groups { pixels, pilot_rays }) => (pixels, *pilot_rays),
        other => panic!("{other:?}"),
    }
}

/// Rays are counted where there is something to look at, and as many as the settings say; to count them changes nothing.
#[test]
fn diagnostics_count_shadow_rays() {
    let env = lamp_and_sky();
    let scenes = [false, true].map(|catcher| small_things(catcher, 0.7, 0.0));
    let mut gpu = adapter_or_skip("groups").map(|context| GpuRenderer::on(context).unwrap());
    for (method, pilots, layers) in [
        (product(8), 0.0..0.0, false),
        (even_cells(8), 0.5..2.0, false),
        (cells(8), 0.5..2.0, false),
        (cells(8), 0.5..2.0, true),
    ] {
        let scene = &scenes[usize::from(layers)];
        let plain = coarse(method, 4, layers);
        let asked = RenderSettings {
            diagnostics: true,
            ..plain
        };
        let image = render(scene, &env, &asked);
        let without = render(scene, &env, &plain);
        assert_eq!(image.linear, without.linear);
        assert_eq!(without.diagnostics, None);
        let (pixels, pilot_rays) = health(&image);
        let range = pilots.start..=pilots.end;
        assert!(range.contains(&pilot_rays), "{pilot_rays} pilots");
        let (mut rays, mut covered) = (0.0, 0.0);
        for (i, pixel) in pixels.iter().enumerate() {
            let own = match &image.layers {
                Some(layers) => layers[i].object.w + layers[i].catcher,
                None => image.linear[i].w,
            };
            assert_eq!(pixel.residual > 0.0, own > 0.0, "{pixel:?} {own}");
            assert!(own > 0.0 || pixel.rays == 0.0);
            rays += pixel.rays;
            covered += own;
        }
        let wanted = match method {
            // Where rays go to what they are worth, as many as all pixels have.
            Method::Cells(Cells { adaptive: true, .. }) => 8.0 * pixels.len() as f32,
            _ => 8.0 * covered,
        };
        assert!((rays / wanted - 1.0).abs() < 0.2, "{rays} rays of {wanted}");
        if let Some(gpu) = &mut gpu {
            gpu.forget();
            let other = gpu.render_frame(scene, &env, &asked, &|_| ()).unwrap();
            let (others, other_pilots) = health(&other);
            assert_eq!(pilot_rays, other_pilots);
            let near = |a: f32, b: f32| (a - b).abs() <= 1e-3 * a.abs().max(b.abs());
            let alike = |(a, b): &(&GroupHealth, &GroupHealth)| {
                a.rays == b.rays && near(a.residual, b.residual)
            };
            let odd = pixels
                .iter()
                .zip(others)
                .filter(|pair| !alike(pair))
                .count();
            assert!(odd * 50 <= pixels.len(), "{odd} pixels fared otherwise");
        }
    }
}

/// Frames do not depend on how the image is cut into tiles.
#[test]
fn tiles_change_no_bit() {
    let (scene, env) = (small_things(true, 0.4, 0.5), lamp_and_sky());
    for method in [product(8), cells(8)] {
        let settings = coarse(method, 4, true);
        let with = |tile| {
            use glimt_render_gpu::cpu::CpuRenderer;
            let mut renderer = CpuRenderer::with_tiles(tile);
            renderer
                .render_frame(&scene, &env, &settings, &|_| ())
                .unwrap()
        };
        let whole = with(usize::MAX);
        for tile in [1, 7, 40] {
            let parts = with(tile);
            assert_eq!(parts.linear, whole.linear, "{method:?}, tiles of {tile}");
            assert_eq!(parts.layers, whole.layers, "{method:?}, tiles of {tile}");
        }
    }
}

/// The noise of an image: the root of the mean variance of its pixels over seeds, as a share of their mean.
fn noise(scene: &SceneBuffers, env: &PreparedEnv, settings: RenderSettings) -> f64 {
    let images: Vec<FrameImage> = (0..24)
        .map(|seed| render(scene, env, &RenderSettings { seed, ..settings }))
        .collect();
    let (mut variance, mut mean) = (0.0, 0.0);
    for pixel in 0..images[0].linear.len() {
        let value = |image: &FrameImage| f64::from(image.linear[pixel].y);
        let own = Mean::of(images.iter().map(value));
        variance += own.standard_error.powi(2) * images.len() as f64;
        mean += own.mean;
    }
    (variance * images[0].linear.len() as f64).sqrt() / mean
}

/// Faults that leave the mean as it is show in the noise alone: of directions and members that are not spread, of a technique that takes
/// another's points, of a proposal that is of no use. The bounds are a twelfth above what was measured with these seeds.
#[test]
fn noise_is_as_low_as_it_was() {
    let (lamp, even, sun) = (lamp_and_sky(), prepare(&map(1.0)), sun_in_a_cell());
    let small = |diffuse, specular| small_things(false, diffuse, specular);
    let ball = |diffuse, specular, exponent, rings| {
        let mut alone = scene(diffuse, specular, exponent).describe(rings);
        alone.objects.remove(1);
        alone.objects.remove(0);
        SceneBuffers::build(&alone).unwrap()
    };
    let alone = ball(0.1, 0.8, 60.0, 24);
    let mirror = ball(0.0, 0.9, 2000.0, 60);
    let sharp = SceneBuffers::build(&scene(0.1, 0.8, 600.0).describe(60)).unwrap();
    let within = |method, rays| RenderSettings {
        filter: Filter::Centre,
        ..coarse(method, rays, false)
    };
    for (name, scene, env, settings, bound) in [
        (
            "product, matt",
            small(0.8, 0.0),
            &lamp,
            coarse(product(24), 16, false),
            0.048,
        ),
        (
            "cells, matt",
            small(0.8, 0.0),
            &lamp,
            coarse(cells(24), 16, false),
            0.0512,
        ),
        (
            "cells, glossy",
            small(0.2, 0.7),
            &lamp,
            coarse(cells(24), 16, false),
            0.0759,
        ),
        (
            "cells, matt, centres",
            small(0.8, 0.0),
            &lamp,
            within(cells(24), 4),
            0.0451,
        ),
        (
            "cells, a glossy ball alone",
            alone,
            &lamp,
            coarse(cells(24), 16, false),
            0.162,
        ),
        (
            "cells, a sharp lobe under an even sky",
            sharp,
            &even,
            within(cells(24), 4),
            0.07,
        ),
        (
            "cells, a near mirror under a sun",
            mirror,
            &sun,
            within(cells(24), 4),
            0.0079,
        ),
    ] {
        let found = noise(&scene, env, settings);
        println!("{name}: {found:.5}, bound {bound}");
        assert!(found < bound, "{name}: {found}");
    }
}
