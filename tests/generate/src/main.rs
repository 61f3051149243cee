//! Host file: writes the generated WGSL and its description, and removes WGSL that nothing makes any more:
//! `cargo run --release -p glimt-generate`.

use std::path::PathBuf;
use std::process::ExitCode;

fn main() -> ExitCode {
    let files = match glimt_generate::files() {
        Ok(files) => files,
        Err(error) => {
            eprintln!("{error}");
            return ExitCode::FAILURE;
        }
    };
    for (path, text) in &files {
        let full = glimt_generate::root().join(path);
        if std::fs::read_to_string(&full).is_ok_and(|old| old == *text) {
            continue;
        }
        let folder = full.parent().expect("a file has a folder");
        let written = std::fs::create_dir_all(folder).and_then(|()| std::fs::write(&full, text));
        if let Err(error) = written {
            eprintln!("error: {}: {error}", path.display());
            return ExitCode::FAILURE;
        }
        println!("wrote {}", path.display());
    }
    match remove_stale(&files) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

/// Removes stale shaders. Another file is left to whoever put it there; the test `golden` names it.
fn remove_stale(files: &[(PathBuf, String)]) -> std::io::Result<()> {
    for path in glimt_generate::stale(files)? {
        if path
            .extension()
            .is_some_and(|extension| extension == "wgsl")
        {
            std::fs::remove_file(glimt_generate::root().join(&path))?;
            println!("removed {}", path.display());
        }
    }
    Ok(())
}
