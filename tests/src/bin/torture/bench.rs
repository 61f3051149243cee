//! Host file: a folder with small inputs, the program run in it, and what is there afterwards.

use crate::Outcome;
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// A folder of one's own, removed at the end.
pub(crate) struct Bench {
    pub(crate) path: PathBuf,
}

impl Drop for Bench {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.path);
    }
}

/// Hash of each file below a folder, by its path there.
pub(crate) type Files = BTreeMap<String, u64>;

impl Bench {
    pub(crate) fn new(name: &str) -> Outcome<Self> {
        let path =
            std::env::temp_dir().join(format!("glimt-torture-{name}-{}", std::process::id()));
        let _ = fs::remove_dir_all(&path);
        fs::create_dir_all(&path).map_err(|e| format!("{}: {e}", path.display()))?;
        Ok(Self { path })
    }

    pub(crate) fn put(&self, name: &str, text: &str) -> Outcome {
        let file = self.path.join(name);
        fs::write(&file, text).map_err(|e| format!("{}: {e}", file.display()))
    }

    /// The program with these arguments, in this folder; it says nothing.
    pub(crate) fn command(&self, args: &[&str]) -> Outcome<Command> {
        let mut command = Command::new(program()?);
        command
            .current_dir(&self.path)
            .args(args)
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(Stdio::null());
        Ok(command)
    }

    /// Runs the program to its end, which is to be a good one.
    pub(crate) fn run(&self, args: &[&str]) -> Outcome {
        let output = self.command(args)?.stderr(Stdio::piped()).output();
        let output = output.map_err(|e| e.to_string())?;
        match output.status.success() {
            true => Ok(()),
            false => Err(format!(
                "glimt {}: {}",
                args.join(" "),
                String::from_utf8_lossy(&output.stderr)
            )),
        }
    }

    /// Makes the light `film/truth/latlong.####.exr`, film of a ball and a plate, and the shot `film/shot.toml`.
    pub(crate) fn film(&self, frames: u32) -> Outcome {
        let text = format!(
            "frames = {frames}\n[capture]\nsize = [120, 85]\npixel_um = 100\n[plate]\nsize = [48, 27]\n[truth]\nsize = [32, 16]\n"
        );
        self.put("synth.toml", &text)?;
        self.run(&["synth", "synth.toml", "--out", "film", "--device", "cpu"])
    }

    /// The files below a folder of it.
    pub(crate) fn files(&self, folder: &str) -> Outcome<Files> {
        let mut files = Files::new();
        let root = self.path.join(folder);
        if root.is_dir() {
            add(&root, &root, &mut files)?;
        }
        Ok(files)
    }
}

fn add(root: &Path, folder: &Path, files: &mut Files) -> Outcome {
    let failed = |e: std::io::Error| format!("{}: {e}", folder.display());
    for entry in fs::read_dir(folder).map_err(failed)? {
        let path = entry.map_err(failed)?.path();
        if path.is_dir() {
            add(root, &path, files)?;
            continue;
        }
        let bytes = fs::read(&path).map_err(failed)?;
        let name = path.strip_prefix(root).unwrap_or(&path);
        files.insert(name.display().to_string(), hash(&bytes));
    }
    Ok(())
}

/// FNV-1a.
fn hash(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ u64::from(*byte)).wrapping_mul(0x100_0000_01b3)
    })
}

/// The program, which was built beside this one.
fn program() -> Outcome<PathBuf> {
    let own = std::env::current_exe().map_err(|e| e.to_string())?;
    let program = own.with_file_name(format!("glimt{}", std::env::consts::EXE_SUFFIX));
    match program.is_file() {
        true => Ok(program),
        false => Err("build the program first: cargo build --release -p glimt".to_owned()),
    }
}
