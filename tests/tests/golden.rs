//! Host file: the WGSL that is checked in is what the front end makes of the kernels as they are.

use std::path::{Path, PathBuf};

use glimt_generate::sources;
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
    let files = glimt_generate::files().unwrap_or_else(|e| panic!("{e}"));
    assert!(files.len() > golden::SOURCES.len());
    let stale = glimt_generate::stale(&files).unwrap_or_else(|e| panic!("{e}"));
    assert!(
        stale.is_empty(),
        "nothing makes {stale:?}; shaders among them are removed by\ncargo run --release -p glimt-generate"
    );
    for (path, want) in files {
        let have = std::fs::read_to_string(glimt_generate::root().join(&path)).unwrap_or_default();
        if let Some(why) = difference(&want, &have) {
            panic!(
                "{} is out of date: {why}\nrun: cargo run --release -p glimt-generate",
                path.display()
            );
        }
    }
}

/// A file beside the generated ones that nothing makes is found out: here each of them, when it is not expected.
#[test]
fn a_stale_file_is_found_out() {
    let files = glimt_generate::files().unwrap_or_else(|e| panic!("{e}"));
    for i in 0..files.len() {
        // `kernels/mod.rs` stands among files that are written by hand.
        if files[i].0.ends_with("kernels/mod.rs") {
            continue;
        }
        let mut others = files.clone();
        let (path, _) = others.remove(i);
        let stale = glimt_generate::stale(&others).unwrap_or_else(|e| panic!("{e}"));
        assert_eq!(stale, [path]);
    }
}

/// Every `.rs` file below `folder`, as its path below it, with its text.
fn rust_files(folder: &Path) -> Vec<(String, String)> {
    let mut out = Vec::new();
    let mut folders = vec![PathBuf::new()];
    while let Some(below) = folders.pop() {
        for entry in std::fs::read_dir(folder.join(&below)).expect("a source folder") {
            let path = below.join(entry.expect("an entry").file_name());
            let full = folder.join(&path);
            if full.is_dir() {
                folders.push(path);
            } else if full.extension().is_some_and(|e| e == "rs") {
                let text = std::fs::read_to_string(&full).expect("text");
                out.push((path.to_string_lossy().replace('\\', "/"), text));
            }
        }
    }
    out
}

/// What is wrong with a crate's list of shared files, given all files of its `src`.
fn wrong_list(listed: &[(&str, &str)], files: &[(String, String)]) -> Vec<String> {
    let is_shared = |text: &str| text.starts_with("//! Shared file:");
    let is_listed = |path: &str| listed.iter().any(|(l, _)| *l == path);
    let mut wrong = Vec::new();
    for (path, text) in listed {
        // The root is listed for the modules that it names; its own items may be for the CPU.
        if *path != "lib.rs" && !is_shared(text) {
            wrong.push(format!("{path} is listed, but is no shared file"));
        }
        if !files.iter().any(|(p, t)| p == path && t == text) {
            wrong.push(format!("{path} is listed with another file's text"));
        }
    }
    for (path, text) in files {
        if !is_listed(path) && (is_shared(text) || (path == "lib.rs" && !listed.is_empty())) {
            wrong.push(format!("{path} is a shared file, but is not listed"));
        }
    }
    wrong
}

/// `SHADER_SOURCE` of each crate lists its root and its shared files, and no other.
#[test]
fn shared_files_are_those_listed() {
    let mut listed_crates = 0;
    for entry in std::fs::read_dir(glimt_generate::root().join("crates")).expect("crates/") {
        let folder = entry.expect("an entry").path();
        let manifest = std::fs::read_to_string(folder.join("Cargo.toml")).expect("a manifest");
        let name = manifest.lines().find_map(|l| l.strip_prefix("name = \""));
        let name = name
            .expect("a name")
            .trim_end_matches('"')
            .replace('-', "_");
        let source = golden::SOURCES.iter().find(|(n, _)| *n == name);
        listed_crates += usize::from(source.is_some());
        let listed = source.map_or(&[][..], |(_, files)| files);
        let wrong = wrong_list(listed, &rust_files(&folder.join("src")));
        assert!(wrong.is_empty(), "{name}: {wrong:#?}");
    }
    assert_eq!(listed_crates, golden::SOURCES.len());
}

#[test]
fn a_wrong_list_is_found_out() {
    let (root, shared, host) = ("//! Host file: r", "//! Shared file: s", "//! Host file: h");
    let files = [("lib.rs", root), ("s.rs", shared), ("h.rs", host)]
        .map(|(path, text)| (path.to_owned(), text.to_owned()));
    let right = [("lib.rs", root), ("s.rs", shared)];
    assert_eq!(wrong_list(&right, &files), [""; 0]);
    for wrong in [
        &right[..1],
        &right[1..],
        &[],
        &[right[0], right[1], ("h.rs", host)],
        &[right[0], ("s.rs", "//! Shared file: another")],
    ] {
        assert_eq!(wrong_list(wrong, &files).len(), 1, "{wrong:?}");
    }
}

/// A kernel that changes without its WGSL is found out.
#[test]
fn a_changed_kernel_is_found_out() {
    let mut crates = sources::read().expect("the sources");
    let changed = crates
        .iter_mut()
        .flat_map(|own| own.files.iter_mut())
        .find(|(path, text)| path == "kernels/film.rs" && text.contains("1.055"))
        .expect("the sRGB curve is in film.rs");
    changed.1 = changed.1.replacen("1.055", "1.056", 1);
    let program = sources::parse(&crates).unwrap_or_else(|e| panic!("{e}"));
    let entries = glimt_generate::entries::all();
    let spec = entries
        .iter()
        .find(|e| e.name == "tonemap")
        .expect("an entry");
    let shader = glimt_generate::lower(&program, spec).unwrap_or_else(|e| panic!("{e}"));
    let path = "crates/render-gpu/src/generated/tonemap.wgsl";
    let have = std::fs::read_to_string(glimt_generate::root().join(path)).expect(path);
    let have = have.split_once("\n\n").expect("a head line").1;
    assert!(difference(&shader.wgsl, have).is_some());
}

/// The module is good for naga's other back ends: SPIR-V, whose rules on pointers are the strictest. 1.3 is what Vulkan 1.1 takes.
#[test]
fn modules_become_spirv() {
    let program = sources::parse(&sources::read().expect("the sources"));
    let program = program.unwrap_or_else(|e| panic!("{e}"));
    for spec in glimt_generate::entries::all() {
        let shader = glimt_generate::lower(&program, &spec).unwrap_or_else(|e| panic!("{e}"));
        let options = naga::back::spv::Options {
            lang_version: (1, 3),
            ..naga::back::spv::Options::default()
        };
        let words = naga::back::spv::write_vec(&shader.module, &shader.info, &options, None)
            .unwrap_or_else(|e| panic!("{}: {e}", spec.name));
        assert_eq!(
            words[0], 0x0723_0203,
            "{}: SPIR-V's magic number",
            spec.name
        );
    }
}
