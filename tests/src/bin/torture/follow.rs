//! Host file: frames that come fast.

use crate::Outcome;
use crate::bench::Bench;
use serde_json::Value;
use std::fs;
use std::io::{BufRead, BufReader};
use std::process::Stdio;
use std::thread::sleep;
use std::time::{Duration, Instant};

/// Writes `frames` frames at a rate into a folder that is followed, and sees that none is dropped.
pub(crate) fn run(fps: f64, frames: u32) -> Outcome {
    let failed = |e: std::io::Error| e.to_string();
    let bench = Bench::new("follow")?;
    bench.film(1)?;
    fs::create_dir_all(bench.path.join("live")).map_err(failed)?;
    bench.put(
        "live.toml",
        "[image]\nsize = [32, 18]\nrays_per_pixel = 1\n[probe]\nframes = \"live/l.#####.exr\"\n[[object]]\nmesh = \"sphere\"\n\
         [output]\nvideo = \"\"\n",
    )?;
    let light = fs::read(bench.path.join("film/truth/latlong.0001.exr")).map_err(failed)?;
    let range = format!("1-{frames}");
    let args = [
        "render",
        "live.toml",
        "--device",
        "cpu",
        "--follow",
        "--json",
        "--wait",
        "5",
        "--frames",
        &range,
        "--out",
        "out",
    ];
    let mut command = bench.command(&args)?;
    let mut child = command.stdout(Stdio::piped()).spawn().map_err(failed)?;
    let mut lines = BufReader::new(child.stdout.take().expect("it is piped")).lines();
    // It is ready when it says so.
    let _ = lines.next();
    let folder = bench.path.join("live");
    let write = std::thread::spawn(move || -> std::io::Result<()> {
        let began = Instant::now();
        for frame in 1..=frames {
            let due = Duration::from_secs_f64(f64::from(frame) / fps);
            sleep(due.saturating_sub(began.elapsed()));
            let part = folder.join("part");
            fs::write(&part, &light)?;
            fs::rename(part, folder.join(format!("l.{frame:05}.exr")))?;
        }
        Ok(())
    });
    let last = lines.map_while(Result::ok).last().unwrap_or_default();
    write.join().expect("the writer ends").map_err(failed)?;
    child.wait().map_err(failed)?;
    let summary: Value = serde_json::from_str(&last).map_err(|e| format!("{last}: {e}"))?;
    let dropped = summary["dropped"].as_array().map_or(0, Vec::len);
    println!(
        "{fps} frames a second: {} of {frames} rendered, {dropped} dropped; lag {} s, at most {} s",
        summary["rendered"], summary["lag_median"], summary["lag_largest"]
    );
    match summary["rendered"] == frames && dropped == 0 {
        true => Ok(()),
        false => Err(format!("{dropped} frames were dropped")),
    }
}
