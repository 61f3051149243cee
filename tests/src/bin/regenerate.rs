//! Host file: writes the generated WGSL and its description: `cargo run --release -p glimt-tests --bin regenerate`.

use std::process::ExitCode;

fn main() -> ExitCode {
    let files = match glimt_tests::golden::files() {
        Ok(files) => files,
        Err(error) => {
            eprintln!("{error}");
            return ExitCode::FAILURE;
        }
    };
    for (path, text) in files {
        let full = glimt_tests::golden::root().join(&path);
        if std::fs::read_to_string(&full).is_ok_and(|old| old == text) {
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
    ExitCode::SUCCESS
}
