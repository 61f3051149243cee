//! Host file: prints the WGSL of kernels: `cargo run --example lower -- my_crate=path/to/src my_crate::kernel …`
//!
//! Each `name=folder` gives a crate with every `.rs` file below that folder; each other argument is a kernel's path.

use std::path::Path;

use naga_front_rust::{CrateSource, EntryDesc, Program};

fn collect(folder: &Path, root: &Path, out: &mut Vec<(String, String)>) -> std::io::Result<()> {
    for entry in std::fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            collect(&path, root, out)?;
        } else if path.extension().is_some_and(|e| e == "rs") {
            let below = path
                .strip_prefix(root)
                .unwrap_or(&path)
                .to_string_lossy()
                .replace('\\', "/");
            out.push((below, std::fs::read_to_string(&path)?));
        }
    }
    Ok(())
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut crates: Vec<(String, Vec<(String, String)>)> = Vec::new();
    let mut kernels = Vec::new();
    for arg in std::env::args().skip(1) {
        match arg.split_once('=') {
            Some((name, folder)) => {
                let mut files = Vec::new();
                collect(Path::new(folder), Path::new(folder), &mut files)?;
                crates.push((name.to_string(), files));
            }
            None => kernels.push(arg),
        }
    }
    let views: Vec<Vec<(&str, &str)>> = crates
        .iter()
        .map(|(_, files)| {
            files
                .iter()
                .map(|(p, t)| (p.as_str(), t.as_str()))
                .collect()
        })
        .collect();
    let sources: Vec<CrateSource<'_>> = crates
        .iter()
        .zip(&views)
        .map(|((name, _), files)| CrateSource { name, files })
        .collect();
    let program = Program::parse(&sources).map_err(|e| e.to_string());
    for kernel in kernels {
        let lowered = program.as_ref().map_err(Clone::clone).and_then(|p| {
            p.entry(&EntryDesc {
                name: "main",
                kernel: &kernel,
                workgroup_size: 64,
            })
            .map_err(|e| e.to_string())
        });
        match lowered {
            Ok(shader) => println!("{}", shader.wgsl),
            Err(e) => {
                eprintln!("{e}");
                std::process::exit(1);
            }
        }
    }
    Ok(())
}
