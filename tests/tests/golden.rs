//! The WGSL that is checked in is what the front end makes of the kernels as they are.

use glimt_tests::golden;

/// Where two texts first differ, as a line for people.
fn difference(want: &str, have: &str) -> Option<String> {
    if want == have {
        return None;
    }
    let lines = want
        .lines()
        .zip(have.lines())
        .enumerate()
        .find(|(_, (w, h))| w != h);
    Some(match lines {
        Some((i, (w, h))) => format!("line {}: the kernels give `{w}`, the file has `{h}`", i + 1),
        None => "one is longer than the other".into(),
    })
}

#[test]
fn generated_files_are_up_to_date() {
    let files = golden::files().unwrap_or_else(|e| panic!("{e}"));
    assert!(files.len() > golden::SOURCES.len());
    for (path, want) in files {
        let have = std::fs::read_to_string(golden::root().join(&path)).unwrap_or_default();
        if let Some(why) = difference(&want, &have) {
            panic!(
                "{} is out of date: {why}\nrun: cargo run --release -p glimt-tests --bin regenerate",
                path.display()
            );
        }
    }
}

/// A kernel that changes without its WGSL is found out.
#[test]
fn a_changed_kernel_is_found_out() {
    let mut sources = golden::SOURCES.map(|(name, files)| (name, files.to_vec()));
    let changed = sources
        .iter_mut()
        .flat_map(|(_, files)| files.iter_mut())
        .find(|(path, text)| *path == "kernels/film.rs" && text.contains("1.055"))
        .expect("the sRGB curve is in film.rs");
    let text = changed.1.replacen("1.055", "1.056", 1);
    changed.1 = &text;
    let views: Vec<(&str, &[(&str, &str)])> =
        sources.iter().map(|(n, f)| (*n, f.as_slice())).collect();
    let program = golden::program(&views).unwrap_or_else(|e| panic!("{e}"));
    let spec = glimt_render_gpu::entries::ENTRIES
        .iter()
        .find(|e| e.name == "tonemap")
        .expect("an entry");
    let shader = golden::lower(&program, spec).unwrap_or_else(|e| panic!("{e}"));
    let path = "crates/render-gpu/src/generated/tonemap.wgsl";
    let have = std::fs::read_to_string(golden::root().join(path)).expect(path);
    let have = have.split_once("\n\n").expect("a head line").1;
    assert!(difference(&shader.wgsl, have).is_some());
}

/// The module is good for naga's other back ends: SPIR-V, whose rules on pointers are the strictest.
#[test]
fn modules_become_spirv() {
    let program = golden::program(&golden::SOURCES).unwrap_or_else(|e| panic!("{e}"));
    for spec in glimt_render_gpu::entries::ENTRIES {
        let shader = golden::lower(&program, spec).unwrap_or_else(|e| panic!("{e}"));
        let options = naga::back::spv::Options::default();
        let words = naga::back::spv::write_vec(&shader.module, &shader.info, &options, None)
            .unwrap_or_else(|e| panic!("{}: {e}", spec.name));
        assert_eq!(
            words[0], 0x0723_0203,
            "{}: SPIR-V's magic number",
            spec.name
        );
    }
}
