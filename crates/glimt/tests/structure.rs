//! Host file: arrows go down only: no cycle among the program's modules, and none among the crates.
//!
//! A module is a file or a folder in `src`; an arrow is a path that begins with `crate::`, or with as many `super::` as lead there.
//! Tests inside a file are not counted.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// What each part depends on.
type Graph = BTreeMap<String, BTreeSet<String>>;

/// A cycle, beginning and ending with the same part, if there is one.
fn cycle(graph: &Graph) -> Option<Vec<String>> {
    let mut done = BTreeSet::new();
    graph
        .keys()
        .find_map(|part| follow(graph, part, &mut Vec::new(), &mut done))
}

fn follow(
    graph: &Graph,
    part: &str,
    path: &mut Vec<String>,
    done: &mut BTreeSet<String>,
) -> Option<Vec<String>> {
    if let Some(first) = path.iter().position(|p| p == part) {
        let mut cycle = path[first..].to_vec();
        cycle.push(part.to_owned());
        return Some(cycle);
    }
    if !done.insert(part.to_owned()) {
        return None;
    }
    path.push(part.to_owned());
    let found = graph
        .get(part)
        .into_iter()
        .flatten()
        .find_map(|next| follow(graph, next, path, done));
    path.pop();
    found
}

/// The modules of a crate whose source is in `src`.
fn modules(src: &Path) -> Graph {
    let mut graph = Graph::new();
    for file in files(src) {
        let inside = file.strip_prefix(src).expect("a file of src");
        let mut names: Vec<String> = inside
            .with_extension("")
            .iter()
            .map(|name| name.to_string_lossy().into_owned())
            .collect();
        names.retain(|name| name != "mod");
        let module = names[0].clone();
        if module == "lib" || module == "main" {
            continue;
        }
        let text = fs::read_to_string(&file).expect("a source file");
        let used = names_in_root(&without_comments_and_tests(&text), names.len());
        let arrows = graph.entry(module.clone()).or_default();
        arrows.extend(used.into_iter().filter(|name| *name != module));
    }
    graph
}

fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("a folder");
    let mut all = Vec::new();
    for path in entries.map(|entry| entry.expect("an entry").path()) {
        if path.is_dir() {
            all.extend(files(&path));
        } else if path.extension().is_some_and(|e| e == "rs") {
            all.push(path);
        }
    }
    all
}

fn without_comments_and_tests(text: &str) -> String {
    let code = text.split("#[cfg(test)]\nmod ").next().unwrap_or_default();
    let lines = code.lines().map(|line| line.split("//").next());
    lines.flatten().collect::<Vec<_>>().join("\n")
}

/// The names in the crate's root that a file takes, `depth` modules below the root.
fn names_in_root(code: &str, depth: usize) -> BTreeSet<String> {
    let up = "super::".repeat(depth);
    let mut names = BTreeSet::new();
    for root in ["crate::", up.as_str()] {
        for (at, _) in code.match_indices(root) {
            let before = code[..at].chars().next_back();
            let is_whole = !before.is_some_and(|c| c.is_alphanumeric() || c == '_' || c == ':');
            if is_whole {
                names.extend(first_names(&code[at + root.len()..]));
            }
        }
    }
    names.remove("super");
    names
}

/// `a` of `a::b`; `a` and `c` of `{a::b, c::{d, e}}`.
fn first_names(path: &str) -> Vec<String> {
    let Some(group) = path.strip_prefix('{') else {
        return vec![word(path)];
    };
    let mut depth = 0;
    let mut names = vec![word(group)];
    for (at, c) in group.char_indices() {
        match c {
            '{' => depth += 1,
            '}' if depth == 0 => break,
            '}' => depth -= 1,
            ',' if depth == 0 => names.push(word(&group[at + 1..])),
            _ => {}
        }
    }
    names.retain(|name| !name.is_empty());
    names
}

fn word(text: &str) -> String {
    let is_part = |c: &char| c.is_alphanumeric() || *c == '_';
    text.trim_start().chars().take_while(is_part).collect()
}

/// The packages in `crates`, with what they and their tests depend on.
fn packages(crates: &Path) -> Graph {
    let mut graph = Graph::new();
    for entry in fs::read_dir(crates).expect("a folder") {
        let file = entry.expect("an entry").path().join("Cargo.toml");
        let text = fs::read_to_string(&file).expect("a manifest");
        let (mut section, mut name, mut arrows) = ("", String::new(), BTreeSet::new());
        for line in text.lines() {
            if let Some(head) = line.strip_prefix('[') {
                section = head.trim_end_matches(']');
            } else if section == "package"
                && let Some(value) = line.strip_prefix("name = ")
            {
                name = value.trim_matches('"').to_owned();
            } else if section.ends_with("dependencies")
                && let Some((key, _)) = line.split_once([' ', '.', '='])
            {
                arrows.insert(key.to_owned());
            }
        }
        // The tests of a crate may turn on its features by an arrow to itself.
        arrows.remove(&name);
        graph.insert(name, arrows);
    }
    let own: BTreeSet<String> = graph.keys().cloned().collect();
    for arrows in graph.values_mut() {
        arrows.retain(|name| own.contains(name));
    }
    graph
}

fn glimt() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

#[test]
fn modules_have_no_cycle() {
    let graph = modules(&glimt().join("src"));
    assert!(graph["command"].contains("render"), "{graph:?}");
    assert_eq!(cycle(&graph), None);
}

#[test]
fn crates_have_no_cycle() {
    let graph = packages(&glimt().join(".."));
    assert!(graph["glimt"].contains("glimt-ball"), "{graph:?}");
    assert_eq!(cycle(&graph), None);
}

/// A folder of files, removed at the end.
struct Planted(PathBuf);

impl Planted {
    fn new(name: &str, files: &[(&str, &str)]) -> Self {
        let folder = format!("glimt-structure-{name}-{}", std::process::id());
        let folder = std::env::temp_dir().join(folder);
        let _ = fs::remove_dir_all(&folder);
        for (file, text) in files {
            let file = folder.join(file);
            fs::create_dir_all(file.parent().expect("a folder")).expect("a folder");
            fs::write(file, text).expect("a file");
        }
        Self(folder)
    }
}

impl Drop for Planted {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

#[test]
fn a_planted_cycle_of_modules_is_found() {
    let downwards = [
        ("lib.rs", "pub mod a;\npub mod b;\npub mod c;\n"),
        ("a.rs", "use crate::{b::{self, X}, c};\n"),
        ("b/mod.rs", "mod inner;\n// use crate::a;\n"),
        ("b/inner.rs", "use super::super::c::Y;\n"),
        ("c.rs", "#[cfg(test)]\nmod tests {\n    use crate::a;\n}\n"),
    ];
    let planted = Planted::new("downwards", &downwards);
    let graph = modules(&planted.0);
    assert_eq!(graph["a"], ["b", "c"].map(str::to_owned).into());
    assert_eq!(graph["b"], ["c".to_owned()].into());
    assert_eq!(cycle(&graph), None);
    for up in [
        "fn f() -> crate::a::Z { crate::a::z() }\n",
        "use crate::{\n    d,\n    a::Z,\n};\n",
        "use super::a::Z;\n",
    ] {
        let mut files = downwards;
        files[4].1 = up;
        let planted = Planted::new("upwards", &files);
        let found = cycle(&modules(&planted.0)).expect("a cycle");
        assert_eq!(found.first(), found.last());
        assert!(found.contains(&"a".to_owned()) && found.contains(&"c".to_owned()));
    }
}

#[test]
fn a_planted_cycle_of_crates_is_found() {
    let low = "[package]\nname = \"low\"\n\n[dev-dependencies]\nhigh = { path = \"../high\" }\n";
    let high =
        "[package]\nname = \"high\"\n\n[dependencies]\nlow.workspace = true\nserde = \"1\"\n";
    let planted = Planted::new(
        "crates",
        &[("low/Cargo.toml", low), ("high/Cargo.toml", high)],
    );
    let found = cycle(&packages(&planted.0)).expect("a cycle");
    assert_eq!(found, ["high", "low", "high"]);
}
