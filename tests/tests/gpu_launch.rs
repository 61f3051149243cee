//! Host file: the launcher, with hand-written shaders that follow the contract of generated entries.

use std::time::Duration;

use glimt_render_gpu::entry::{Entry, ParamsSpace};
use glimt_render_gpu::gpu::{AdapterPreference, Arg, GpuContext, GpuError, GpuOptions};
use glimt_tests::gpu::{OwnedEntry, adapter_or_skip, adapter_or_skip_with};

/// `out[local] = input[(first + local) % 8] * factor + id`, and a chunk of `parts` that holds `id * 100 + k`.
const WGSL: &str = "
struct Params { first: u32, count: u32, factor: u32, parts_len: u32 }
@group(0) @binding(0) var<storage, read> params: Params;
@group(0) @binding(1) var<storage, read> input: array<u32>;
@group(0) @binding(2) var<storage, read_write> parts: array<u32>;
@group(0) @binding(3) var<storage, read_write> out: array<u32>;
@compute @workgroup_size(64)
fn work(@builtin(global_invocation_id) gid: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let local = gid.y * (groups.x * 64u) + gid.x;
    if local >= params.count { return; }
    let id = params.first + local;
    for (var k = 0u; k < params.parts_len; k += 1u) {
        parts[local * params.parts_len + k] = id * 100u + k;
    }
    out[local] = input[id % arrayLength(&input)] * params.factor + id;
}";

fn entry() -> Entry {
    let slot = |path: &str, binding, writable| (path.to_owned(), binding, 4, writable);
    let field = |path: &str, offset| (path.to_owned(), offset, 4);
    OwnedEntry {
        name: "work".into(),
        wgsl: WGSL.into(),
        workgroup_size: 64,
        params_size: 16,
        params_in: ParamsSpace::Storage,
        params: vec![
            field("first", 0),
            field("count", 4),
            field("factor", 8),
            field("parts_len", 12),
        ],
        buffers: vec![
            slot("input", 1, false),
            slot("parts", 2, true),
            slot("out", 3, true),
        ],
    }
    .leak()
}

const INPUT: [u32; 8] = [3, 1, 4, 1, 5, 9, 2, 6];

/// Runs the shader over `count` elements and checks all that it wrote. Returns the dispatches it took.
fn run(context: &GpuContext, first: u32, count: u32, parts_len: u32) -> u32 {
    let input = context.buffer_of("input", &INPUT).unwrap();
    let parts = context
        .buffer("parts", u64::from(count * parts_len) * 4)
        .unwrap();
    let out = context.buffer("out", u64::from(count) * 4).unwrap();
    let args = [
        ("factor", Arg::Value(bytemuck::bytes_of(&7u32))),
        ("input", Arg::Buffer(&input)),
        ("parts", Arg::Chunk(&parts, parts_len)),
        ("out", Arg::Buffer(&out)),
    ];
    let report = context.launch(&entry(), &args, first, count).unwrap();
    let ids = first..first + count;
    let expected: Vec<u32> = ids
        .clone()
        .map(|id| INPUT[(id % 8) as usize] * 7 + id)
        .collect();
    let chunks: Vec<u32> = ids
        .flat_map(|id| (0..parts_len).map(move |k| id * 100 + k))
        .collect();
    assert!(context.read::<u32>(&out, count as usize).unwrap() == expected);
    assert!(context.read::<u32>(&parts, chunks.len()).unwrap() == chunks);
    report.dispatches
}

#[test]
fn every_element_is_computed_once_whatever_the_tiles() {
    let forced = [
        GpuOptions::default(),
        GpuOptions {
            max_elements: 1000,
            ..Default::default()
        },
        GpuOptions {
            max_elements: 64,
            ..Default::default()
        },
        GpuOptions {
            max_binding_bytes: 8192,
            ..Default::default()
        },
        GpuOptions {
            dispatch_target: Duration::ZERO,
            ..Default::default()
        },
        GpuOptions {
            timestamps: false,
            ..Default::default()
        },
    ];
    for options in forced {
        let Some(context) =
            adapter_or_skip_with("every_element_is_computed_once_whatever_the_tiles", options)
        else {
            return;
        };
        for (first, count, parts_len) in [
            (0, 1, 1),
            (5, 63, 3),
            (0, 64, 2),
            (1000, 65, 3),
            (7, 10_007, 3),
        ] {
            let dispatches = run(&context, first, count, parts_len);
            let bytes = count * parts_len * 4;
            assert!(dispatches >= count.div_ceil(options.max_elements));
            assert!(u64::from(dispatches) >= u64::from(bytes).div_ceil(options.max_binding_bytes));
        }
    }
}

#[test]
fn a_launch_beyond_one_row_of_workgroups_is_whole() {
    // 65,535 groups of 64 are 4.2 million elements: a dispatch of all of these needs a second row.
    let options = GpuOptions {
        dispatch_target: Duration::from_secs(3600),
        ..Default::default()
    };
    let Some(context) =
        adapter_or_skip_with("a_launch_beyond_one_row_of_workgroups_is_whole", options)
    else {
        return;
    };
    // The first launch teaches the kernel's pace; the second may then begin large.
    run(&context, 3, 6_000_001, 1);
    let dispatches = run(&context, 3, 6_000_001, 1);
    assert!(
        dispatches == 1,
        "{dispatches} dispatches: none was of two rows"
    );
}

#[test]
fn wrong_arguments_are_named() {
    let Some(context) = adapter_or_skip("wrong_arguments_are_named") else {
        return;
    };
    let input = context.buffer_of("input", &INPUT).unwrap();
    let long = context.buffer("long", 400).unwrap();
    let factor = bytemuck::bytes_of(&7u32);
    let good = [
        ("factor", Arg::Value(factor)),
        ("input", Arg::Buffer(&input)),
        ("parts", Arg::Chunk(&long, 1)),
        ("out", Arg::Buffer(&long)),
    ];
    let fails_with = |args: &[(&str, Arg<'_>)], count: u32, words: &str| {
        let error = context.launch(&entry(), args, 0, count).unwrap_err();
        assert!(matches!(error, GpuError::Argument { .. }), "{error:?}");
        assert!(
            error.to_string().contains(words),
            "'{error}' lacks '{words}'"
        );
    };
    context
        .launch(&entry(), &good, 0, 100)
        .unwrap_or_else(|error| {
            // One buffer may not be written through two bindings; that is wgpu's to say, not the check's.
            assert!(matches!(error, GpuError::Refused { .. }), "{error:?}");
            Default::default()
        });
    for (index, words) in [
        "'factor' is missing",
        "'input' is missing",
        "'parts",
        "'out' is missing",
    ]
    .iter()
    .enumerate()
    {
        let rest: Vec<_> = good
            .iter()
            .enumerate()
            .filter(|(i, _)| *i != index)
            .map(|(_, arg)| *arg)
            .collect();
        fails_with(&rest, 100, words);
    }
    let with = |name: &'static str, arg| {
        let mut args: Vec<_> = good
            .iter()
            .filter(|(path, _)| *path != name)
            .copied()
            .collect();
        args.push((name, arg));
        args
    };
    fails_with(
        &with("factor", Arg::Value(&[0; 8])),
        100,
        "'factor' is 8 bytes, not 4",
    );
    fails_with(
        &with("factor", Arg::Buffer(&input)),
        100,
        "'factor' is a plain value",
    );
    fails_with(
        &with("input", Arg::Value(factor)),
        100,
        "'input' must be a buffer",
    );
    fails_with(&with("parts", Arg::Buffer(&long)), 100, "'parts");
    fails_with(&with("outt", Arg::Buffer(&long)), 100, "no argument 'outt'");
    fails_with(
        &with("first", Arg::Value(factor)),
        100,
        "no argument 'first'",
    );
    fails_with(&good, 101, "'parts' has 400 bytes and needs 404");
    // A part of a buffer is all that is written, however long the buffer is.
    fails_with(
        &with("out", Arg::Window(&long, 0, 10)),
        100,
        "'out' has 40 bytes and needs 400",
    );
    fails_with(
        &with("out", Arg::Window(&long, 90, 20)),
        20,
        "'out' has 40 bytes and needs 80",
    );
    fails_with(
        &with("input", Arg::Window(&input, 4, 5)),
        10,
        "'input' has 16 bytes and needs 20",
    );
    let error = context.launch(&entry(), &good, u32::MAX, 2).unwrap_err();
    assert!(error.to_string().contains("beyond u32"), "{error}");
}

#[test]
fn what_the_adapter_cannot_do_names_it_and_the_limit() {
    let Some(context) = adapter_or_skip("what_the_adapter_cannot_do_names_it_and_the_limit") else {
        return;
    };
    let adapter = context.adapter().to_string();
    let says = |error: GpuError, words: &str| {
        let text = error.to_string();
        assert!(
            text.contains(&adapter) && text.contains(words),
            "'{text}' lacks '{words}' or '{adapter}'"
        );
    };
    says(
        context.buffer("huge", 1 << 60).unwrap_err(),
        "max_buffer_size",
    );
    assert!(matches!(
        context.buffer("empty", 0),
        Err(GpuError::Argument { .. })
    ));

    let wide = Entry {
        workgroup_size: 1 << 20,
        ..entry()
    };
    says(
        context.prepare(&wide).unwrap_err(),
        "max_compute_workgroup_size_x",
    );
    let broken = Entry {
        name: "broken",
        wgsl: "fn broken() { nonsense }",
        ..entry()
    };
    says(
        context.prepare(&broken).unwrap_err(),
        "refused shader broken",
    );
    let nameless = Entry {
        name: "absent",
        ..entry()
    };
    says(context.prepare(&nameless).unwrap_err(), "absent");

    let small = GpuOptions {
        max_binding_bytes: 16,
        ..Default::default()
    };
    let context = adapter_or_skip_with("small bindings", small).unwrap();
    let input = context.buffer_of("input", &INPUT).unwrap();
    let args = [
        ("factor", Arg::Value(bytemuck::bytes_of(&7u32))),
        ("input", Arg::Buffer(&input)),
        ("parts", Arg::Chunk(&input, 1)),
        ("out", Arg::Buffer(&input)),
    ];
    says(
        context.launch(&entry(), &args, 0, 1).unwrap_err(),
        "max_storage_buffer_binding_size",
    );

    let error = GpuContext::new(AdapterPreference::Named("no such thing")).unwrap_err();
    assert!(error.to_string().contains("no such thing"), "{error}");
}

#[test]
fn a_dispatch_that_takes_too_long_is_an_error() {
    let options = GpuOptions {
        time_out: Duration::from_millis(1),
        ..Default::default()
    };
    let Some(context) = adapter_or_skip_with("a_dispatch_that_takes_too_long_is_an_error", options)
    else {
        return;
    };
    let count = 100_000;
    let slow = OwnedEntry {
        name: "slow".into(),
        wgsl: "
@group(0) @binding(0) var<storage, read> params: vec4<u32>;
@group(0) @binding(1) var<storage, read_write> out: array<u32>;
@compute @workgroup_size(64)
fn slow(@builtin(global_invocation_id) gid: vec3<u32>) {
    var x = gid.x;
    for (var i = 0u; i < 20000u; i += 1u) { x = x * 1664525u + 1013904223u; }
    if gid.x < params.y { out[gid.x] = x; }
}"
        .into(),
        workgroup_size: 64,
        params_size: 16,
        params_in: ParamsSpace::Storage,
        params: vec![("first".into(), 0, 4), ("count".into(), 4, 4)],
        buffers: vec![("out".into(), 1, 4, true)],
    }
    .leak();
    let out = context.buffer("out", count * 4).unwrap();
    match context.launch(&slow, &[("out", Arg::Buffer(&out))], 0, count as u32) {
        Err(error) => {
            assert!(matches!(error, GpuError::TimedOut { .. }), "{error:?}");
            assert!(error.to_string().contains("slow"), "{error}");
        }
        // Some software adapters wait as long as it takes, whatever the time-out.
        Ok(report) => assert!(context.adapter().is_software(), "{report:?}"),
    }
}

#[test]
fn a_destroyed_device_is_an_error_not_a_panic() {
    let Some(context) = adapter_or_skip("a_destroyed_device_is_an_error_not_a_panic") else {
        return;
    };
    let buffer = context.buffer_of("input", &INPUT).unwrap();
    context.destroy();
    let error = context.read::<u32>(&buffer, 8).unwrap_err();
    assert!(
        matches!(error, GpuError::Lost { .. } | GpuError::Refused { .. }),
        "{error:?}"
    );
    let error = context.buffer("more", 16).unwrap_err();
    assert!(matches!(error, GpuError::Lost { .. }), "{error:?}");
}
