//! Host file: how many storage buffers each pass binds. WebGPU promises eight to a stage, whatever the machine.

use glimt_tests::shaders;
use naga::AddressSpace;
use naga::valid::{Capabilities, ValidationFlags, Validator};

/// What every implementation of WebGPU has.
const PROMISED: usize = 8;

/// Each entry point of a shader with the number of storage buffers that it reaches.
fn reached(wgsl: &str) -> Vec<(String, usize)> {
    let module = shaders::module(wgsl).unwrap_or_else(|e| panic!("{e}"));
    let info = Validator::new(ValidationFlags::all(), Capabilities::default())
        .validate(&module)
        .unwrap_or_else(|e| panic!("{}", e.emit_to_string(wgsl)));
    let points = module.entry_points.iter().enumerate();
    let count = |(i, point): (usize, &naga::EntryPoint)| {
        let uses = info.get_entry_point(i);
        let buffers = module.global_variables.iter().filter(|(handle, global)| {
            matches!(global.space, AddressSpace::Storage { .. }) && !uses[*handle].is_empty()
        });
        (point.name.clone(), buffers.count())
    };
    points.map(count).collect()
}

/// Each entry point with the number of storage buffers that are bound for it: of a generated shader all that it declares, of
/// one that is written by hand those that the stage reaches.
fn table() -> Vec<(String, usize)> {
    let all = shaders::all().expect("the shaders");
    let rows = all.iter().flat_map(|shader| {
        let mut rows = reached(&shader.wgsl);
        if !shader.is_written_by_hand() {
            for (name, count) in &mut rows {
                let declared = shader.wgsl.matches("var<storage").count();
                assert!(*count <= declared, "{name}");
                *count = declared;
            }
        }
        rows
    });
    let mut rows: Vec<_> = rows.collect();
    rows.sort_by(|a, b| (b.1, &a.0).cmp(&(a.1, &b.0)));
    rows
}

/// The entry points that bind more than is promised.
fn too_many(table: &[(String, usize)]) -> Vec<&str> {
    let rows = table.iter().filter(|(_, count)| *count > PROMISED);
    rows.map(|(name, _)| name.as_str()).collect()
}

#[test]
fn eight_storage_buffers_are_enough() {
    let table = table();
    for (name, count) in &table {
        println!("{count:3} {name}");
    }
    for name in ["tonemap", "shade_layers"] {
        assert!(table.iter().any(|(other, _)| other == name), "{name}");
    }
    let found = too_many(&table);
    assert!(
        found.is_empty(),
        "bind less, or divide the kernel: {found:?}"
    );
}

#[test]
fn nine_storage_buffers_are_too_many() {
    let table = [
        ("small".to_owned(), PROMISED),
        ("large".to_owned(), PROMISED + 1),
    ];
    assert_eq!(too_many(&table), ["large"]);
}

#[test]
fn what_a_stage_does_not_reach_is_not_counted() {
    let wgsl = "
        @group(0) @binding(0) var<storage> a: array<u32>;
        @group(0) @binding(1) var<storage> b: array<u32>;
        @group(0) @binding(2) var<storage, read_write> out: array<u32>;
        @group(0) @binding(3) var<uniform> params: vec4<u32>;
        fn read(i: u32) -> u32 { return a[i]; }
        @compute @workgroup_size(1) fn one() { out[0] = read(params.x); }
        @compute @workgroup_size(1) fn two() { out[0] = read(params.x) + b[0]; }";
    let expected = [("one".to_owned(), 2), ("two".to_owned(), 3)];
    assert_eq!(reached(wgsl), expected);
}
