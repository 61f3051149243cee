//! Host file: each feature of the language, run on both processors over the same random inputs.

use std::sync::OnceLock;

use glam::{UVec2, Vec4};
use glimt_executor::Entry;
use glimt_render_gpu::gpu::{Arg, GpuContext};
use glimt_tests::differential::{Case, Inputs, SHADER_SOURCE, Word, compare, words_of};
use glimt_tests::gpu::adapter_or_skip;
use glimt_tests::kernels;
use naga_front_rust::{CrateSource, EntryDesc, Program};

/// Not a multiple of a workgroup.
const COUNT: u32 = 12_347;

/// Exact: integers, and floats that only move or compare.
const EXACT: f32 = 0.0;
/// Sums and products, which a GPU may fuse.
const ARITHMETIC: f32 = 2e-6;
/// Transcendental functions as drivers give them.
const FUNCTIONS: f32 = 2e-5;
/// The tangent, inverses near ±1, and hyperbolic functions.
const COARSE: f32 = 5e-4;
/// `powf` on software adapters.
const POWER: f32 = 3e-3;

fn context() -> Option<&'static GpuContext> {
    static CONTEXT: OnceLock<Option<GpuContext>> = OnceLock::new();
    CONTEXT
        .get_or_init(|| adapter_or_skip("differential"))
        .as_ref()
}

thread_local! {
    // Syntax trees stay on their thread.
    static PROGRAM: Program = {
        let (name, files) = SHADER_SOURCE;
        Program::parse(&[CrateSource { name, files }]).unwrap_or_else(|error| panic!("{error}"))
    };
}

fn entry(kernel: &str) -> Result<Entry, String> {
    let path = format!("glimt_tests::kernels::{kernel}");
    let desc = EntryDesc {
        name: "entry",
        kernel: &path,
        workgroup_size: 64,
    };
    let shader = PROGRAM.with(|program| program.entry(&desc).map_err(|error| error.to_string()))?;
    Ok(Entry::from(&shader))
}

fn check(cases: &[Case]) {
    let inputs = Inputs::new(COUNT, 1);
    let mut failures = Vec::new();
    for case in cases {
        let result = entry(case.kernel).and_then(|entry| {
            let Some(context) = context() else {
                return Ok(0.0);
            };
            let gpu = case.run_gpu(context, &entry, &inputs)?;
            case.compare(&case.run_cpu(&inputs), &gpu, &inputs)
        });
        match result {
            Ok(largest) => println!("{}: {largest:e}", case.kernel),
            Err(error) => failures.push(error),
        }
    }
    assert!(
        failures.is_empty(),
        "{} of {} failed\n\n{}",
        failures.len(),
        cases.len(),
        failures.join("\n\n")
    );
}

macro_rules! cases {
    ($($module:ident::$kernel:ident: $tolerance:expr,)*) => {
        &[$(Case::new(
            concat!(stringify!($module), "::", stringify!($kernel)),
            $tolerance,
            kernels::$module::$kernel,
        )),*]
    };
}

#[test]
fn ints() {
    check(cases![
        ints::unsigned: EXACT,
        ints::signed: EXACT,
        ints::bits: EXACT,
        ints::any_shift: EXACT,
        ints::counts: EXACT,
        ints::saturating: EXACT,
        ints::signed_order: EXACT,
        ints::comparisons: EXACT,
        ints::casts: EXACT,
        ints::to_float: EXACT,
        ints::compound: EXACT,
        ints::literals: EXACT,
        ints::sizes: EXACT,
    ]);
}

#[test]
fn floats() {
    check(cases![
        floats::arithmetic: ARITHMETIC,
        floats::remainder: ARITHMETIC,
        floats::methods: ARITHMETIC,
        floats::bit_patterns: EXACT,
        floats::comparisons: EXACT,
        floats::whole: EXACT,
        floats::trigonometry: COARSE,
        floats::exponentials: FUNCTIONS,
        floats::powers: POWER,
        floats::constants: ARITHMETIC,
    ]);
}

#[test]
fn vectors() {
    check(cases![
        vectors::operators: ARITHMETIC,
        vectors::scalar_sides: ARITHMETIC,
        vectors::geometry: FUNCTIONS,
        vectors::componentwise: ARITHMETIC,
        vectors::swizzles: ARITHMETIC,
        vectors::small_swizzles: ARITHMETIC,
        vectors::constants: ARITHMETIC,
        vectors::components: ARITHMETIC,
        vectors::unsigned: EXACT,
        vectors::small_unsigned: EXACT,
        vectors::signed: EXACT,
        vectors::conversions: ARITHMETIC,
        vectors::integer_products: EXACT,
    ]);
}

#[test]
fn matrices() {
    check(cases![
        matrices::products: ARITHMETIC,
        matrices::sizes: ARITHMETIC,
        matrices::columns: ARITHMETIC,
        matrices::result: ARITHMETIC,
    ]);
}

#[test]
fn structs_and_enums() {
    check(cases![
        structs::result: EXACT,
        structs::nested: ARITHMETIC,
        structs::local: EXACT,
        structs::tuples: EXACT,
        structs::arrays: EXACT,
        options::forms: EXACT,
        options::assigned: EXACT,
        enums::modes: EXACT,
        matches::integers: EXACT,
        matches::patterns: EXACT,
    ]);
}

#[test]
fn generics_and_traits() {
    check(cases![
        generics::types: EXACT,
        generics::numbers: EXACT,
        generics::bounds: ARITHMETIC,
        traits::dispatch: ARITHMETIC,
        traits::sources: EXACT,
        operators::complex: ARITHMETIC,
        operators::bits: EXACT,
    ]);
}

#[test]
fn slices_and_references() {
    check(cases![
        slices::ranges: EXACT,
        slices::views: EXACT,
        muts::places: EXACT,
        muts::index_once: EXACT,
        muts::vectors: ARITHMETIC,
        muts::parameters: EXACT,
    ]);
}

#[test]
fn control_and_order() {
    check(cases![
        control::returns: EXACT,
        control::ranges: EXACT,
        control::values: EXACT,
        control::conditions: EXACT,
        order::operands: EXACT,
        order::branches: EXACT,
        order::short_circuits: EXACT,
        order::reads: EXACT,
        order::chains: EXACT,
    ]);
}

#[test]
fn consts_and_modules() {
    check(cases![
        consts::integers: EXACT,
        consts::floats: ARITHMETIC,
        modules::paths: EXACT,
        hidden::parameters: EXACT,
        hidden::signatures: EXACT,
        hidden::globs: EXACT,
        hidden::bounds: EXACT,
    ]);
}

#[test]
fn corners() {
    check(cases![
        corners::reads_between: EXACT,
        corners::assignments: EXACT,
        corners::fresh_in_loops: EXACT,
        corners::leaving: EXACT,
        corners::names: EXACT,
        corners::type_names: EXACT,
        corners::hidden_methods: ARITHMETIC,
        corners::folded: EXACT,
        corners::exact_literals: EXACT,
        corners::deep_places: ARITHMETIC,
        corners::copies: ARITHMETIC,
        corners::guards: EXACT,
    ]);
}

#[test]
fn one_function_over_several_buffers() {
    let (a, b) = (Inputs::new(10, 4).ints, Inputs::new(3, 5).ints);
    let cpu: Vec<u32> = (0..COUNT)
        .flat_map(|id| kernels::corners::two_buffers(id, &a, &b))
        .collect();
    entry("corners::two_buffers").unwrap_or_else(|error| panic!("{error}"));
    let Some(context) = context() else { return };
    let buffers = [&a, &b].map(|values| context.buffer_of("slice", values).unwrap());
    let out = context.buffer("out", u64::from(COUNT) * 16).unwrap();
    let args = [
        ("a", Arg::Buffer(&buffers[0])),
        ("b", Arg::Buffer(&buffers[1])),
        ("out", Arg::Buffer(&out)),
    ];
    launch("corners::two_buffers", &args, COUNT);
    assert!(context.read::<u32>(&out, cpu.len()).unwrap() == cpu);
}

/// A kernel with arguments of its own on both processors.
fn launch(kernel: &str, args: &[(&str, Arg<'_>)], count: u32) -> Option<()> {
    let entry = entry(kernel).unwrap_or_else(|error| panic!("{error}"));
    let context = context()?;
    context
        .launch(&entry, args, 0, count)
        .unwrap_or_else(|error| panic!("{error}\n{}", entry.wgsl));
    Some(())
}

#[test]
fn views_and_plain_arguments() {
    let inputs = Inputs::new(1000, 2);
    let size = UVec2::new(13, 17);
    let settings = kernels::slices::Settings {
        offset: UVec2::new(5, 4_000_000),
        factor: 77,
        bias: -9,
    };
    let salt = 0xABCD_1234u32;
    let image = kernels::slices::Image {
        size,
        pixels: &inputs.ints,
    };
    let cpu: Vec<u32> = (0..COUNT)
        .map(|id| kernels::slices::arguments(id, image, &settings, salt))
        .collect();
    entry("slices::arguments").unwrap_or_else(|error| panic!("{error}"));
    let Some(context) = context() else { return };
    let pixels = context.buffer_of("pixels", &inputs.ints).unwrap();
    let out = context.buffer("out", u64::from(COUNT) * 4).unwrap();
    let args = [
        ("image.size", Arg::Value(bytemuck::bytes_of(&size))),
        ("image.pixels", Arg::Buffer(&pixels)),
        ("settings", Arg::Value(bytemuck::bytes_of(&settings))),
        ("salt", Arg::Value(bytemuck::bytes_of(&salt))),
        ("out", Arg::Buffer(&out)),
    ];
    launch("slices::arguments", &args, COUNT);
    assert!(context.read::<u32>(&out, COUNT as usize).unwrap() == cpu);
}

#[test]
fn enums_in_buffers() {
    use kernels::enums::{Operation, Recipe, Step, buffered};
    let all = [
        Operation::Keep,
        Operation::Add,
        Operation::Invert,
        Operation::Replace,
    ];
    let steps: Vec<Step> = (0..40u32)
        .map(|i| Step {
            operation: all[(i % 3) as usize],
            amount: i * 0x0101_0101,
            then: all[(i / 3 % 4) as usize],
        })
        .collect();
    for (i, first) in all.into_iter().enumerate() {
        let (own, step) = (all[3 - i], steps[13 + i]);
        let recipe = Recipe {
            first,
            steps: &steps,
        };
        let cpu: Vec<[u32; 4]> = (0..COUNT)
            .map(|id| buffered(id, own, &step, recipe, &all))
            .collect();
        entry("enums::buffered").unwrap_or_else(|error| panic!("{error}"));
        let Some(context) = context() else { return };
        let gpu_steps = context.buffer_of("steps", &steps).unwrap();
        let operations = context.buffer_of("operations", &all).unwrap();
        let out = context.buffer("out", u64::from(COUNT) * 16).unwrap();
        let args = [
            ("own", Arg::Value(bytemuck::bytes_of(&own))),
            ("step", Arg::Value(bytemuck::bytes_of(&step))),
            ("recipe.first", Arg::Value(bytemuck::bytes_of(&first))),
            ("recipe.steps", Arg::Buffer(&gpu_steps)),
            ("operations", Arg::Buffer(&operations)),
            ("out", Arg::Buffer(&out)),
        ];
        launch("enums::buffered", &args, COUNT);
        let gpu = context.read::<[u32; 4]>(&out, COUNT as usize).unwrap();
        assert!(gpu == cpu, "{first:?}");
    }
}

#[test]
fn chunks() {
    let inputs = Inputs::new(COUNT, 3);
    let (ints, floats) = (&inputs.ints[..], &inputs.floats[..]);
    let n = COUNT as usize;

    let mut filled = vec![0u32; n * 5];
    for (id, chunk) in filled.chunks_mut(5).enumerate() {
        kernels::chunks::fill(id as u32, ints, floats, chunk);
    }
    let before: Vec<Vec4> = floats
        .iter()
        .map(|&f| Vec4::new(f, 1.0, -f, 0.0))
        .take(n * 3)
        .collect();
    let mut particles = before.clone();
    let moved: Vec<u32> = particles
        .chunks_mut(3)
        .enumerate()
        .map(|(id, chunk)| kernels::chunks::update(id as u32, ints, floats, chunk))
        .collect();
    let small_before = ints[..n * 2].to_vec();
    let (mut small, mut large) = (small_before.clone(), vec![7i32; n * 7]);
    let returned: Vec<f32> = small
        .chunks_mut(2)
        .zip(large.chunks_mut(7))
        .enumerate()
        .map(|(id, (small, large))| kernels::chunks::two(id as u32, ints, floats, small, large))
        .collect();

    let kernels = ["chunks::fill", "chunks::update", "chunks::two"];
    let [fill, update, two] =
        kernels.map(|kernel| entry(kernel).unwrap_or_else(|error| panic!("{error}")));
    let Some(context) = context() else { return };
    let gpu_ints = context.buffer_of("ints", ints).unwrap();
    let gpu_floats = context.buffer_of("floats", floats).unwrap();
    let run = |entry: &Entry, own: &[(&str, Arg<'_>)]| {
        let buffer = |path: &str| match path.trim_start_matches('_') {
            "ints" => Arg::Buffer(&gpu_ints),
            "floats" => Arg::Buffer(&gpu_floats),
            path => own.iter().find(|(name, _)| *name == path).unwrap().1,
        };
        let slots = entry.buffers.iter();
        let args: Vec<_> = slots
            .map(|slot| (&*slot.path, buffer(&slot.path)))
            .collect();
        context
            .launch(entry, &args, 0, COUNT)
            .unwrap_or_else(|error| panic!("{error}\n{}", entry.wgsl));
    };

    let chunk = context.buffer("chunk", n as u64 * 20).unwrap();
    run(&fill, &[("chunk", Arg::Chunk(&chunk, 5))]);
    assert!(context.read::<u32>(&chunk, n * 5).unwrap() == filled);

    let gpu_particles = context.buffer_of("particles", &before).unwrap();
    let out = context.buffer("out", n as u64 * 4).unwrap();
    run(
        &update,
        &[
            ("particles", Arg::Chunk(&gpu_particles, 3)),
            ("out", Arg::Buffer(&out)),
        ],
    );
    assert!(context.read::<u32>(&out, n).unwrap() == moved);
    let on_gpu = context.read::<Vec4>(&gpu_particles, n * 3).unwrap();
    let words = |list: &[Vec4]| list.iter().flat_map(words_of).collect::<Vec<u32>>();
    compare(
        &[Word::Float],
        ARITHMETIC,
        &words(&particles),
        &words(&on_gpu),
    )
    .unwrap_or_else(|wrong| panic!("{wrong:?}"));

    let gpu_small = context.buffer_of("small", &small_before).unwrap();
    let gpu_large = context.buffer_of("large", &vec![7i32; n * 7]).unwrap();
    run(
        &two,
        &[
            ("small", Arg::Chunk(&gpu_small, 2)),
            ("large", Arg::Chunk(&gpu_large, 7)),
            ("out", Arg::Buffer(&out)),
        ],
    );
    assert!(context.read::<u32>(&gpu_small, n * 2).unwrap() == small);
    assert!(context.read::<i32>(&gpu_large, n * 7).unwrap() == large);
    assert!(context.read::<f32>(&out, n).unwrap() == returned);
}

#[test]
fn a_wrong_function_is_found_out() {
    let Some(context) = context() else { return };
    let inputs = Inputs::new(COUNT, 1);
    let differs = |kernel: &'static str, case: Case| {
        let gpu = case
            .run_gpu(context, &entry(kernel).unwrap(), &inputs)
            .unwrap();
        let error = case
            .compare(&case.run_cpu(&inputs), &gpu, &inputs)
            .unwrap_err();
        assert!(error.contains("differ"), "{error}");
    };
    let unsigned = Case::new("ints::unsigned", EXACT, |id, ints, floats| {
        let mut right = kernels::ints::unsigned(id, ints, floats);
        right[3] ^= u32::from(id == COUNT - 1);
        right
    });
    differs("ints::unsigned", unsigned);
    let arithmetic = Case::new("floats::arithmetic", ARITHMETIC, |id, ints, floats| {
        let mut right = kernels::floats::arithmetic(id, ints, floats);
        right[7] *= 1.0 + 1e-5;
        right
    });
    differs("floats::arithmetic", arithmetic);
    let missing = Case::new("floats::whole", EXACT, |id, ints, floats| {
        let mut right = kernels::floats::whole(id, ints, floats);
        right[0] = if id == 7 { f32::NAN } else { right[0] };
        right
    });
    differs("floats::whole", missing);

    let one = 1f32.to_bits();
    assert!(compare(&[Word::Float], 1.0, &[one], &[f32::NAN.to_bits()]).is_err());
    assert!(compare(&[Word::Float], 1.0, &[one, one], &[one]).is_err());
    assert!(compare(&[Word::Int], 1.0, &[1], &[2]).is_err());
}
