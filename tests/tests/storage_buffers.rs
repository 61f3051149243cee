//! Host file: how many storage buffers each pass binds. WebGPU promises eight to a stage, whatever the machine.

use glimt_tests::shaders;
use naga::AddressSpace;
use naga::valid::{Capabilities, ValidationFlags, Validator};

/// What every implementation of WebGPU has.
const PROMISED: usize = 8;

/// Entry points that bind more: none.
const EXCEPTIONS: [&str; 0] = [];

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

/// What is wrong with a table, given the entry points that may bind more than is promised.
fn complaints(table: &[(String, usize)], exceptions: &[&str]) -> Vec<String> {
    let mut out = Vec::new();
    for (name, count) in table {
        match (*count > PROMISED, exceptions.contains(&name.as_str())) {
            (true, false) => out.push(format!(
                "{name} binds {count} storage buffers: bind less, or divide the kernel"
            )),
            (false, true) => out.push(format!("{name} is not an exception: take it from the list")),
            _ => {}
        }
    }
    for name in exceptions {
        if table.iter().all(|(other, _)| other != name) {
            out.push(format!("there is no {name}: take it from the list"));
        }
    }
    out
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
    let complaints = complaints(&table, &EXCEPTIONS);
    assert!(complaints.is_empty(), "{complaints:#?}");
}

#[test]
fn a_wrong_list_of_exceptions_is_found_out() {
    let table = [
        ("small".to_owned(), PROMISED),
        ("large".to_owned(), PROMISED + 1),
    ];
    assert_eq!(complaints(&table, &["large"]).len(), 0);
    assert_eq!(complaints(&table, &[]).len(), 1);
    assert_eq!(complaints(&table, &["large", "small"]).len(), 1);
    assert_eq!(complaints(&table, &["large", "gone"]).len(), 1);
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
