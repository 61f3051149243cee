//! Host file: what light cells take over from frame to frame: the mean of whole sequences, what is carried where, and the same bits in
//! parts.

use glam::{DVec3, Mat4, UVec2, Vec3};
use glimt_render_gpu::cpu::CpuRenderer;
use glimt_render_gpu::kernels::cell_state::TileEntry;
use glimt_render_gpu::methods::{Cells, Method, MethodMemory};
use glimt_render_gpu::prepare::cells_state::CellsState;
use glimt_render_gpu::prepare::env::{EnvMap, PreparedEnv};
use glimt_render_gpu::prepare::render::{FrameImage, Pattern, RenderSettings, Renderer};
use glimt_render_gpu::prepare::scene::Camera;
use glimt_render_gpu::prepare::scene_build::SceneBuffers;
use glimt_tests::analytic::AnalyticMap;
use glimt_tests::quadrature::Integral;
use glimt_tests::stats::{Mean, z_test};
use glimt_tests::unbiased::{camera, channel, disagreements, map, reference, scene, settings};

const SEEDS: u32 = 160;
/// Frames of a sequence. The last is judged.
const FRAMES: u32 = 4;
const RAYS: u32 = 4;
const ALPHA: f64 = 1e-4;

fn prepare(map: &AnalyticMap, turned_deg: f32) -> PreparedEnv {
    let texels = map.texels.iter().map(|t| t.as_vec3().extend(1.0)).collect();
    EnvMap::new(UVec2::from_array(map.size), texels)
        .unwrap()
        .prepare(turned_deg)
        .unwrap()
}

fn cells(own: Cells) -> Method {
    own.into()
}

/// One frame of a sequence.
struct Frame {
    scene: SceneBuffers,
    env: PreparedEnv,
    camera: Camera,
}

/// Frames that lead up to the one that is judged, in which all stands where quadrature has it: `moved` says where objects stand before,
/// as a share of a step for each frame to go; `turned` how light stands, in degrees.
fn frames(
    material: &glimt_tests::analytic::AnalyticScene,
    moved: Vec3,
    turned: f32,
    light: impl Fn(u32) -> AnalyticMap,
) -> Vec<Frame> {
    let frame = |number: u32| {
        let to_go = (FRAMES - 1 - number) as f32;
        let mut description = material.describe(200);
        for object in &mut description.objects[1..] {
            object.transform = Mat4::from_translation(to_go * moved);
        }
        let at = camera();
        Frame {
            scene: SceneBuffers::build(&description).unwrap(),
            env: prepare(&light(number), to_go * turned),
            camera: Camera {
                eye: at.eye + to_go * 2.0 * moved,
                ..at
            },
        }
    };
    (0..FRAMES).map(frame).collect()
}

/// The frames of a sequence.
fn render(frames: &[Frame], settings: &RenderSettings, tile: usize) -> (FrameImage, CellsState) {
    let mut renderer = CpuRenderer::with_tiles(tile);
    let mut last = None;
    for (number, frame) in (0..).zip(frames) {
        let settings = RenderSettings {
            frame: number,
            camera: frame.camera,
            ..*settings
        };
        let image = renderer.render_frame(&frame.scene, &frame.env, &settings, &|_| ());
        last = Some(image.unwrap());
    }
    let Some(MethodMemory::Cells(state)) = renderer.memory().unwrap() else {
        unreachable!("the method keeps a state");
    };
    (last.expect("a frame"), state)
}

/// The means over seeds of the last frame's pixels.
fn means(frames: &[Frame], settings: &RenderSettings) -> Vec<Mean> {
    let image = |seed| {
        let settings = RenderSettings { seed, ..*settings };
        render(frames, &settings, usize::MAX).0
    };
    let images: Vec<FrameImage> = (0..SEEDS).map(image).collect();
    let pixels = images[0].linear.len() as u32;
    let of = |pixel: u32| {
        let value = |image: &FrameImage| f64::from(image.linear[pixel as usize][channel(pixel)]);
        Mean::of(images.iter().map(value))
    };
    (0..pixels).map(of).collect()
}

/// The sum of all pixels that have a reference, which are independent of one another.
fn whole(pixels: &[Mean], truth: &[Option<Integral>]) -> Mean {
    let seen = || {
        let pairs = pixels.iter().zip(truth);
        pairs.filter_map(|(mean, truth)| Some((mean, (*truth)?)))
    };
    let variance: f64 = seen().map(|(m, _)| m.standard_error.powi(2)).sum();
    let unsure: f64 = seen().map(|(_, truth)| truth.error).sum();
    Mean {
        mean: seen().map(|(m, _)| m.mean).sum(),
        standard_error: variance.sqrt().hypot(unsure),
        ..pixels[0]
    }
}

#[test]
fn the_mean_of_whole_sequences_is_the_integral() {
    let other = || {
        // The light before a cut: bright where the later one is not.
        let mut light = map(50.0);
        light.texels.reverse();
        light
    };
    let flicker = |number: u32| {
        let mut light = map(50.0);
        let factor = if number.is_multiple_of(2) { 0.3 } else { 1.0 };
        let sun = (4 * light.size[0] + 22) as usize;
        light.texels[sun] *= factor;
        light
    };
    let few = Cells {
        rays: 4,
        pilot: 0.1,
        upkeep: 0.4,
        ..Cells::default()
    };
    for (diffuse, specular, exponent) in [(0.8, 0.0, 1.0), (0.2, 0.7, 120.0)] {
        let material = scene(diffuse, specular, exponent);
        let truth = reference(&material, &map(50.0));
        let total: f64 = truth.iter().flatten().map(|t| t.value).sum();
        let cut = |number| {
            if number + 1 < FRAMES {
                other()
            } else {
                map(50.0)
            }
        };
        let still = Vec3::ZERO;
        let shift = Vec3::new(0.05, 0.12, 0.0);
        for (name, frames, own) in [
            ("still", frames(&material, still, 0.0, flicker), few),
            ("motion", frames(&material, shift, 25.0, flicker), few),
            (
                "motion, no pilots",
                frames(&material, shift, 3.0, flicker),
                Cells {
                    pilot: 0.3,
                    upkeep: 0.0,
                    ..few
                },
            ),
            ("a cut", frames(&material, still, 0.0, cut), few),
        ] {
            let settings = RenderSettings {
                method: cells(own),
                ..settings(RAYS, Pattern::OwenSobol)
            };
            let found = means(&frames, &settings);
            let bad = disagreements(&found, &truth, ALPHA);
            assert!(bad.is_empty(), "{name}: {}", bad[0].1);
            let image = whole(&found, &truth);
            println!(
                "{name}: bias {:+.2} ± {:.2} %",
                100.0 * (image.mean - total) / total,
                100.0 * image.standard_error / total
            );
            z_test(image, total, ALPHA).unwrap_or_else(|e| panic!("{name}: {e}"));
        }
        // Another light is noticed.
        let frames = frames(&material, still, 0.0, |_| {
            let mut light = map(50.0);
            light.texels.iter_mut().for_each(|t| *t *= 0.97);
            light
        });
        let settings = RenderSettings {
            method: cells(few),
            ..settings(RAYS, Pattern::OwenSobol)
        };
        let found = whole(&means(&frames, &settings), &truth);
        assert!(z_test(found, total, ALPHA).is_err());
    }
}

/// A larger image of the same, of several tiles.
fn several_tiles(own: Cells) -> RenderSettings {
    RenderSettings {
        method: cells(own),
        rays_per_pixel: RAYS,
        ..RenderSettings::new(UVec2::new(72, 45), camera())
    }
}

/// Of all entries of a frame, the shares that took counts over, and that sent out as few pilots as they then may.
fn shares(entries: &[TileEntry]) -> (f64, f64) {
    let there: Vec<&TileEntry> = entries.iter().filter(|e| e.surface != 0).collect();
    let own = Cells::default();
    // Every fourth pixel sends them out.
    let most = (4.0 * own.pilot * own.rays as f32) as u32;
    assert!(there.iter().all(|e| e.pilots <= most));
    let of = |count: usize| count as f64 / there.len() as f64;
    let carried = there.iter().filter(|e| e.from != 0).count();
    let few = there.iter().filter(|e| e.pilots < most * 3 / 4).count();
    (of(carried), of(few))
}

#[test]
fn counts_follow_what_moves_and_pilots_go_where_they_are_of_no_use() {
    let material = scene(0.8, 0.0, 1.0);
    let settings = several_tiles(Cells::default());
    let sun = |_| map(50.0);
    let state = |frames: &[Frame]| render(frames, &settings, usize::MAX).1;
    let still = frames(&material, Vec3::ZERO, 0.0, sun);
    let (carried, few) = shares(&state(&still[..1]).entries);
    assert_eq!((carried, few), (0.0, 0.0), "a first frame");
    let (carried, few) = shares(&state(&still).entries);
    println!("still: {carried:.2} carried, {few:.2} with few pilots");
    // A far corner of the ground has too few rays to ever know enough.
    assert!(carried == 1.0 && few > 0.8, "{carried} {few}");
    let moving = frames(&material, Vec3::new(0.03, 0.1, 0.0), 5.0, sun);
    let (carried, few) = shares(&state(&moving).entries);
    println!("in motion: {carried:.2} carried, {few:.2} with few pilots");
    assert!(carried > 0.85 && few > 0.6, "{carried} {few}");
    // Another light shines from where nobody has looked.
    let lit_from = |row: u32| {
        move |number: u32| {
            let mut light = map(0.0);
            light
                .texels
                .iter_mut()
                .for_each(|t| *t = DVec3::splat(1e-3));
            let (row, column) = if number + 1 < FRAMES {
                (row, 6)
            } else {
                (3, 24)
            };
            light.texels[(row * light.size[0] + column) as usize] = DVec3::splat(500.0);
            light
        }
    };
    let cut = frames(&material, Vec3::ZERO, 0.0, lit_from(5));
    let (carried, few) = shares(&state(&cut).entries);
    println!("a cut of the light: {carried:.2} carried, {few:.2} with few pilots");
    assert!(carried == 1.0 && few < 0.3, "{carried} {few}");
    // Seen from behind, nothing is where it was.
    let mut turned = frames(&material, Vec3::ZERO, 0.0, sun);
    turned[FRAMES as usize - 2].camera.eye.x *= -1.0;
    let (carried, _) = shares(&state(&turned).entries);
    println!("a cut of the camera: {carried:.2} carried");
    assert!(carried < 0.9, "{carried}");
}

#[test]
fn what_is_remembered_makes_a_still_sequence_less_noisy() {
    let material = scene(0.8, 0.0, 1.0);
    let frames = frames(&material, Vec3::ZERO, 0.0, |_| map(50.0));
    let truth = |seed| {
        let own = Cells {
            rays: 1024,
            memory: false,
            ..Cells::default()
        };
        let settings = RenderSettings {
            seed,
            frame: FRAMES - 1,
            rays_per_pixel: 64,
            ..several_tiles(own)
        };
        let mut renderer = CpuRenderer::default();
        let last = frames.last().expect("frames");
        renderer
            .render_frame(&last.scene, &last.env, &settings, &|_| ())
            .unwrap()
            .linear
    };
    let truth = truth(1);
    // The inside of surfaces: at edges the pattern of the camera's rays is all that is to be seen.
    let error = |image: &FrameImage| {
        let mut squares: Vec<f32> = image
            .linear
            .iter()
            .zip(&truth)
            .map(|(a, b)| (*a - *b).truncate().length_squared())
            .collect();
        squares.sort_by(f32::total_cmp);
        f64::from(squares[..squares.len() * 4 / 5].iter().sum::<f32>())
    };
    let mut sums = [0.0; 2];
    for seed in 0..4 {
        for (sum, memory) in sums.iter_mut().zip([false, true]) {
            let own = Cells {
                memory,
                ..Cells::default()
            };
            let settings = RenderSettings {
                seed,
                ..several_tiles(own)
            };
            let mut renderer = CpuRenderer::default();
            let mut last = None;
            for (number, frame) in (0..).zip(&frames) {
                let settings = RenderSettings {
                    frame: number,
                    ..settings
                };
                let image = renderer.render_frame(&frame.scene, &frame.env, &settings, &|_| ());
                last = Some(image.unwrap());
            }
            *sum += error(&last.expect("a frame"));
        }
    }
    println!(
        "squared error with a memory, of that without: {:.2}",
        sums[1] / sums[0]
    );
    assert!(sums[1] < 0.9 * sums[0], "{sums:?}");
}

#[test]
fn sequences_are_the_same_in_parts_and_in_tiles() {
    let material = scene(0.3, 0.6, 50.0);
    let frames = frames(&material, Vec3::new(0.03, 0.1, 0.0), 5.0, |_| map(50.0));
    let settings = several_tiles(Cells {
        rays: 6,
        ..Cells::default()
    });
    let (whole, state) = render(&frames, &settings, usize::MAX);
    for tile in [1, 100] {
        let (image, own) = render(&frames, &settings, tile);
        assert!(image.linear == whole.linear && own.counts == state.counts);
    }
    // From a state that was saved, and after frames of another kind.
    let (_, half) = render(&frames[..2], &settings, usize::MAX);
    let mut renderer = CpuRenderer::default();
    let mut image = None;
    renderer.set_memory(MethodMemory::Cells(half)).unwrap();
    for number in 2..FRAMES {
        let frame = &frames[number as usize];
        let settings = RenderSettings {
            frame: number,
            camera: frame.camera,
            ..settings
        };
        let made = renderer.render_frame(&frame.scene, &frame.env, &settings, &|_| ());
        image = Some(made.unwrap());
    }
    assert!(image.expect("a frame").linear == whole.linear);
    // Without a memory a frame does not depend on another.
    let alone = several_tiles(Cells {
        memory: false,
        ..Cells::default()
    });
    let with = |renderer: &mut CpuRenderer| {
        let frame = &frames[1];
        let settings = RenderSettings { frame: 1, ..alone };
        renderer
            .render_frame(&frame.scene, &frame.env, &settings, &|_| ())
            .unwrap()
            .linear
    };
    assert!(with(&mut renderer) == with(&mut CpuRenderer::default()));
    assert!(renderer.memory().unwrap().is_none());
}
