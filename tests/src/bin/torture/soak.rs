//! Host file: long runs.

use crate::Outcome;
use crate::bench::Bench;
use std::fs;
use std::thread::sleep;
use std::time::Duration;

/// How much memory may grow between the middle and the end of a run, in KiB: allocators keep a little.
const GROWTH: u64 = 8 << 10;

/// How much the median number of open files may grow: a frame opens and closes a few, so a sample depends on its moment. A leak
/// of one file in a hundred frames is fifteen files here.
const MORE_FILES: usize = 2;

/// Renders `frames` frames, and watches memory and open files.
pub(crate) fn run(frames: u32) -> Outcome {
    let bench = Bench::new("soak")?;
    bench.film(1)?;
    bench.put(
        "still.toml",
        "[image]\nsize = [32, 18]\nrays_per_pixel = 1\n[probe]\nframes = \"film/truth/latlong.0001.exr\"\n\
         [[object]]\nmesh = \"sphere\"\n[output]\nvideo = \"\"\n",
    )?;
    let range = format!("1-{frames}");
    let args = [
        "render",
        "still.toml",
        "--device",
        "cpu",
        "--out",
        "out",
        "--frames",
        &range,
    ];
    let mut child = bench.command(&args)?.spawn().map_err(|e| e.to_string())?;
    let process = format!("/proc/{}", child.id());
    let mut samples = Vec::new();
    let status = loop {
        if let Some(status) = child.try_wait().map_err(|e| e.to_string())? {
            break status;
        }
        samples.extend(sample(&process));
        sleep(Duration::from_millis(20));
    };
    if !status.success() {
        return Err(format!("it ended with {status}"));
    }
    let half = samples.len() / 2;
    if half < 10 {
        return Err("it ended too soon to be watched".to_owned());
    }
    let (middle, end) = (summary(&samples[..half]), summary(&samples[half..]));
    println!(
        "{frames} frames: at most {} KiB and in the median {} open files in the first half, {} KiB and {} in the second",
        middle.0, middle.1, end.0, end.1
    );
    match end.0 > middle.0 + GROWTH || end.1 > middle.1 + MORE_FILES {
        true => Err("it grows".to_owned()),
        false => Ok(()),
    }
}

/// The most memory, and the median number of open files.
fn summary(samples: &[(u64, usize)]) -> (u64, usize) {
    let memory = samples.iter().map(|sample| sample.0).max();
    let mut files: Vec<usize> = samples.iter().map(|sample| sample.1).collect();
    files.sort_unstable();
    (
        memory.unwrap_or(0),
        files.get(files.len() / 2).copied().unwrap_or(0),
    )
}

/// Memory in KiB and open files of a process.
fn sample(process: &str) -> Option<(u64, usize)> {
    let status = fs::read_to_string(format!("{process}/status")).ok()?;
    let line = status
        .lines()
        .find_map(|line| line.strip_prefix("VmRSS:"))?;
    let memory = line.split_whitespace().next()?.parse().ok()?;
    let files = fs::read_dir(format!("{process}/fd")).ok()?.count();
    Some((memory, files))
}
