//! Host file: the sequential sampler's mean over whole sequences, against quadrature in f64: under a light that turns, flickers and
//! cuts, with the rules that start sets without looking at them, and with the one that looks.

use glam::DVec3;
use glimt_render_gpu::cpu::CpuRenderer;
use glimt_render_gpu::kernels::past::{
    RayState, STARTED_BY_AGE, STARTED_BY_CHANGE, STARTED_NOT, STARTED_WITHOUT_PAST,
};
use glimt_render_gpu::methods::{MethodMemory, Smc};
use glimt_render_gpu::prepare::env::PreparedEnv;
use glimt_render_gpu::prepare::render::{Pattern, RenderSettings, Renderer};
use glimt_render_gpu::prepare::scene_build::SceneBuffers;
use glimt_smc::is_log_zero;
use glimt_tests::analytic::AnalyticMap;
use glimt_tests::quadrature::Integral;
use glimt_tests::stats::{Evidence, Mean, sidak, z_test};
use glimt_tests::unbiased::{channel, disagreements, prepare, reference, scene, settings};

const SEEDS: u32 = 64;
const RAYS: u32 = 8;

/// The frame in which the light is another one at once.
const CUT: u32 = 9;
/// Frames whose means are judged: the first and the last of those that turn, one that flickers, the cut, and one after it.
const JUDGED: [u32; 5] = [1, 4, 7, CUT, 11];
const LAST: u32 = 11;

/// The probability that a mean without bias lies 4 standard errors off: of the worst of all that are judged.
const ALPHA: f64 = 6.334e-5;

/// Two lamps under a dim sky. They go around for four frames; for four more one of them flickers too; then everything is elsewhere.
fn light(frame: u32) -> AnalyticMap {
    let size = [32, 16];
    let cut = frame >= CUT;
    let turned = 0.09 * f64::from(frame) + if cut { 2.5 } else { 0.0 };
    let flicker = match frame {
        5 | 7 => 0.6,
        6 | 8 => 1.5,
        _ => 1.0,
    };
    let lamp = |azimuth: f64, height: f64| {
        let across = (1.0 - height * height).sqrt();
        DVec3::new(azimuth.cos() * across, azimuth.sin() * across, height)
    };
    let lamps = [
        (lamp(2.4 + turned, 0.6), 12.0 * flicker),
        (lamp(-2.2 - turned, 0.4), 8.0),
    ];
    let texels = (0..size[1]).flat_map(|row| {
        (0..size[0]).map(move |column| {
            let theta = std::f64::consts::PI * (f64::from(row) + 0.5) / f64::from(size[1]);
            let phi = std::f64::consts::PI
                - std::f64::consts::TAU * (f64::from(column) + 0.5) / f64::from(size[0]);
            let d = DVec3::new(
                theta.sin() * phi.cos(),
                theta.sin() * phi.sin(),
                theta.cos(),
            );
            let bright = lamps.map(|(at, power)| power * (20.0 * (d.dot(at) - 1.0)).exp());
            let sky = if (row < 10) != cut { 0.3 } else { 0.1 };
            (DVec3::new(0.9, 1.0, 1.2) * sky + DVec3::new(1.2, 1.0, 0.8) * (bright[0] + bright[1]))
                .as_vec3()
                .as_dvec3()
        })
    });
    AnalyticMap {
        size,
        texels: texels.collect(),
    }
}

/// The rays after a frame.
fn rays(renderer: &mut CpuRenderer) -> Vec<RayState> {
    let Some(MethodMemory::Smc(state)) = renderer.memory().unwrap() else {
        unreachable!("the sampler keeps a state");
    };
    state.rays
}

/// What was measured of a judged frame.
struct Found {
    /// The mean of each pixel over the seeds, with the noise of one image in it.
    pixels: Vec<Mean>,
    /// The mean of the whole image over the seeds.
    image: Mean,
    /// The median over rays of sd(Z)/Z.
    spread: f64,
    /// Rays that were started, of those that hit something.
    started: f64,
}

/// The judged frames over all seeds.
fn sequence(
    buffers: &SceneBuffers,
    envs: &[PreparedEnv],
    truths: &[Vec<Option<Integral>>],
    smc: Smc,
) -> Vec<Found> {
    let base = RenderSettings {
        method: smc.into(),
        ..settings(RAYS, Pattern::Independent)
    };
    let mut values: Vec<Vec<Vec<f64>>> = vec![Vec::new(); JUDGED.len()];
    let mut normalisers: Vec<Vec<Vec<f64>>> = vec![Vec::new(); JUDGED.len()];
    let mut started = vec![0.0; JUDGED.len()];
    for seed in 1000..1000 + SEEDS {
        let mut renderer = CpuRenderer::default();
        for (frame, env) in (0..).zip(envs) {
            let settings = RenderSettings {
                seed,
                frame,
                ..base
            };
            let image = renderer
                .render_frame(buffers, env, &settings, &|_| ())
                .unwrap();
            let Some(judged) = JUDGED.iter().position(|f| *f == frame) else {
                continue;
            };
            let of_pixel = |(pixel, v): (usize, &glam::Vec4)| f64::from(v[channel(pixel as u32)]);
            values[judged].push(image.linear.iter().enumerate().map(of_pixel).collect());
            let rays = rays(&mut renderer);
            let hits = rays.iter().filter(|ray| ray.depth > 0.0);
            let begun = hits.clone().filter(|ray| ray.started != STARTED_NOT);
            started[judged] += begun.count() as f64 / hits.count() as f64 / f64::from(SEEDS);
            normalisers[judged].push(
                rays.iter()
                    .map(|ray| f64::from(ray.log_normaliser).exp())
                    .collect(),
            );
        }
    }
    (0..JUDGED.len())
        .map(|judged| {
            let values = &values[judged];
            let truth = &truths[judged];
            let seen = |image: &Vec<f64>| -> f64 {
                let both = image.iter().zip(truth);
                both.filter(|(_, truth)| truth.is_some())
                    .map(|(value, _)| *value)
                    .sum()
            };
            let mut spreads: Vec<f64> = (0..normalisers[judged][0].len())
                .map(|ray| Mean::of(normalisers[judged].iter().map(|all| all[ray])))
                .filter(|z| z.mean > 0.0)
                .map(|z| z.standard_error * f64::from(SEEDS).sqrt() / z.mean)
                .collect();
            spreads.sort_by(f64::total_cmp);
            Found {
                pixels: (0..truth.len())
                    .map(|pixel| Mean::of(values.iter().map(|image| image[pixel])))
                    .collect(),
                image: Mean::of(values.iter().map(seen)),
                spread: spreads[spreads.len() / 2],
                started: started[judged],
            }
        })
        .collect()
}

/// Each pixel and each whole image of the judged frames against quadrature: the pixels that disagree, and the largest |z| of an image.
/// Prints bias and error.
fn judge(name: &str, found: &[Found], truths: &[Vec<Option<Integral>>]) -> (usize, Evidence) {
    let (mut bad, mut worst) = (0, None::<Evidence>);
    for ((found, truth), frame) in found.iter().zip(truths).zip(JUDGED) {
        let known = truth.iter().flatten();
        let total: f64 = known.clone().map(|t| t.value).sum();
        let unsure: f64 = known.map(|t| t.error).sum();
        let image = Mean {
            standard_error: found.image.standard_error.hypot(unsure),
            ..found.image
        };
        let evidence = match z_test(image, total, sidak(ALPHA, JUDGED.len())) {
            Ok(evidence) | Err(evidence) => evidence,
        };
        let judged = found.pixels.iter().zip(truth);
        let squares = judged.filter_map(|(mean, truth)| {
            let off = mean.mean - (*truth)?.value;
            Some(mean.standard_error.powi(2) * f64::from(SEEDS) + off * off)
        });
        let squares: Vec<f64> = squares.collect();
        println!(
            "{name}, frame {frame}: bias {:+.2} ± {:.2} % (|z| {:.1}), error {:.3}, sd(Z)/Z {:.2}, {:.0} % start",
            100.0 * (image.mean - total) / total,
            100.0 * image.standard_error / total,
            evidence.statistic,
            (squares.iter().sum::<f64>() * squares.len() as f64).sqrt() / total,
            found.spread,
            100.0 * found.started,
        );
        bad += disagreements(&found.pixels, truth, ALPHA / JUDGED.len() as f64).len();
        if !worst
            .as_ref()
            .is_some_and(|w| w.statistic >= evidence.statistic)
        {
            worst = Some(evidence);
        }
    }
    (bad, worst.expect("a frame that is judged"))
}

#[test]
fn sets_that_are_started_unseen_have_the_integral_as_their_mean_and_others_have_not() {
    let lights: Vec<AnalyticMap> = (0..=LAST).map(light).collect();
    let envs: Vec<PreparedEnv> = lights.iter().map(prepare).collect();
    let analytic = scene(0.3, 0.6, 50.0);
    let buffers = SceneBuffers::build(&analytic.describe(200)).unwrap();
    let truths = JUDGED.map(|frame| reference(&analytic, &lights[frame as usize]));
    // Few particles, whose normalisers vary much.
    let few = Smc {
        particles: 4,
        candidates: 32,
        ..Smc::default()
    };
    let unbiased = [
        ("by age and change", few),
        (
            "by age alone",
            Smc {
                max_change: 1.0,
                max_age: 4,
                ..few
            },
        ),
    ];
    for (name, smc) in unbiased {
        let found = sequence(&buffers, &envs, &truths, smc);
        let (bad, image) = judge(name, &found, &truths);
        assert_eq!(bad, 0, "{name}");
        assert!(image.statistic <= image.limit, "{name}: {image}");
        let errors = found.iter().map(|f| f.image.standard_error / f.image.mean);
        assert!(
            errors.fold(0.0, f64::max) < 0.02,
            "{name}: the test has no power"
        );
    }
    // The rule that looks at the sets fails the same test by far.
    let by_ratio = Smc {
        max_age: 0,
        max_change: 1.0,
        reinitialise: 1.25,
        ..few
    };
    let found = sequence(&buffers, &envs, &truths, by_ratio);
    let (bad, image) = judge("by the ratio", &found, &truths);
    assert!(bad > 0 && image.statistic > 2.0 * image.limit, "{image}");
}

#[test]
fn a_cut_starts_all_rays_and_age_a_share_of_them_in_each_frame() {
    let buffers = SceneBuffers::build(&scene(0.3, 0.6, 50.0).describe(20)).unwrap();
    let mut renderer = CpuRenderer::default();
    let smc = Smc {
        max_age: 5,
        ..Smc::default()
    };
    for frame in 0..30 {
        let settings = RenderSettings {
            method: smc.into(),
            frame,
            ..settings(RAYS, Pattern::OwenSobol)
        };
        // It stands still but for the cut, which all of a map at another brightness is not.
        let mut map = light(if frame < 15 { 0 } else { CUT });
        if frame == 6 {
            map.texels.iter_mut().for_each(|t| *t *= 4.0);
        }
        renderer
            .render_frame(&buffers, &prepare(&map), &settings, &|_| ())
            .unwrap();
        let rays = rays(&mut renderer);
        let hits: Vec<_> = rays.iter().filter(|ray| ray.depth > 0.0).collect();
        let of = |reason| hits.iter().filter(|ray| ray.started == reason).count();
        assert!(hits.iter().all(|ray| ray.age < 5));
        match frame {
            0 => assert_eq!(of(STARTED_WITHOUT_PAST), hits.len()),
            15 => assert_eq!(of(STARTED_BY_CHANGE), hits.len()),
            _ => {
                let share = of(STARTED_BY_AGE) as f64 / hits.len() as f64;
                assert_eq!(of(STARTED_BY_AGE) + of(STARTED_NOT), hits.len());
                assert!((share - 0.2).abs() < 0.08, "frame {frame}: {share}");
            }
        }
    }
}

#[test]
fn a_set_without_weights_stays_dark_until_its_age_ends_it() {
    let buffers = SceneBuffers::build(&scene(0.8, 0.0, 1.0).describe(20)).unwrap();
    // One half of the sky, then the other: without a floor and steps between, no particle has any weight left.
    let half = |other: bool| AnalyticMap {
        size: [4, 2],
        texels: (0..8)
            .map(|i| DVec3::splat(f64::from(u8::from((i % 4 < 2) == other))))
            .collect(),
    };
    let smc = |reinitialise| Smc {
        intermediate: 0,
        floor: 0.0,
        max_age: 4,
        max_change: 1.0,
        reinitialise,
        ..Smc::default()
    };
    let mut dark = Vec::new();
    for reinitialise in [0.0, 1.25] {
        let mut renderer = CpuRenderer::default();
        let mut counts = Vec::new();
        for frame in 0..5 {
            let settings = RenderSettings {
                method: smc(reinitialise).into(),
                frame,
                ..settings(RAYS, Pattern::Independent)
            };
            let env = prepare(&half(frame > 0));
            renderer
                .render_frame(&buffers, &env, &settings, &|_| ())
                .unwrap();
            let rays = rays(&mut renderer);
            let hits: Vec<_> = rays.iter().filter(|ray| ray.depth > 0.0).collect();
            let is_dark = |ray: &&&RayState| is_log_zero(ray.log_normaliser);
            if reinitialise == 0.0 && frame > 0 {
                // All sets died in frame 1; what shines was started by age since.
                let lit = hits.iter().filter(|ray| !is_dark(ray));
                assert!(lit.clone().all(|ray| ray.age < frame));
                assert!(
                    hits.iter()
                        .filter(is_dark)
                        .all(|ray| ray.age >= frame || ray.age == 0)
                );
            }
            counts.push(hits.iter().filter(is_dark).count() as f64 / hits.len() as f64);
        }
        dark.push(counts);
    }
    println!(
        "dark in frames 0 to 4: {:.2?}, by the ratio {:.2?}",
        dark[0], dark[1]
    );
    // In each frame it is the turn of a quarter of the rays.
    for (frame, share) in [(1, 0.75), (2, 0.5), (3, 0.25), (4, 0.0)] {
        assert!((dark[0][frame] - share).abs() < 0.1, "{:?}", dark[0]);
    }
    assert!(dark[1][1] < 0.05);
}
