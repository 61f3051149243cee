//! Host file: disks that are too small.

use crate::Outcome;
use crate::bench::Bench;
use std::fs;
use std::process::{Command, Stdio};

/// Sizes of the disk in KiB.
const SIZES: [u32; 14] = [4, 8, 16, 24, 32, 48, 64, 96, 128, 160, 192, 224, 256, 320];

struct Mount<'a>(&'a Bench);

impl Mount<'_> {
    fn options(&self, options: &str) -> bool {
        let disk = self.0.path.join("disk");
        let mut mount = Command::new("mount");
        mount.args(["-t", "tmpfs", "-o", options, "none"]).arg(disk);
        mount
            .stderr(Stdio::null())
            .status()
            .is_ok_and(|s| s.success())
    }
}

impl Drop for Mount<'_> {
    fn drop(&mut self) {
        let _ = Command::new("umount")
            .arg(self.0.path.join("disk"))
            .status();
    }
}

/// Renders onto each disk: an error and no half-written file; then, with room, all of it.
pub(crate) fn run() -> Outcome {
    let bench = Bench::new("disk")?;
    bench.film(3)?;
    fs::create_dir_all(bench.path.join("disk")).map_err(|e| e.to_string())?;
    let args = [
        "render",
        "film/shot.toml",
        "--device",
        "cpu",
        "--set",
        "image.size=[96,54]",
        "--set",
        "output.codec=\"av1\"",
        "--out",
    ];
    let into = |folder: &'static str| [&args[..], &[folder]].concat();
    bench.run(&into("whole"))?;
    let whole = bench.files("whole")?;
    let mut full = 0;
    for size in SIZES {
        let mount = Mount(&bench);
        if !mount.options(&format!("size={size}k")) {
            println!("skipped: a disk cannot be mounted here");
            std::mem::forget(mount);
            return Ok(());
        }
        let output = bench
            .command(&into("disk"))?
            .stderr(Stdio::piped())
            .output();
        let output = output.map_err(|e| e.to_string())?;
        let said = String::from_utf8_lossy(&output.stderr);
        match output.status.code() {
            Some(0) => {}
            Some(4) if said.contains("disk is full") => full += 1,
            _ => return Err(format!("{size} KiB: {}: {said}", output.status)),
        }
        for (name, hash) in bench.files("disk")? {
            if whole.get(&name) != Some(&hash) {
                return Err(format!("{size} KiB: {name} is not whole"));
            }
        }
        mount.options("remount,size=64m");
        bench.run(&into("disk"))?;
        if bench.files("disk")? != whole {
            return Err(format!("{size} KiB: with room it is not completed"));
        }
    }
    println!("{} disks, {full} of them full: no fault", SIZES.len());
    Ok(())
}
