//! Host file: kills at random moments.

use crate::Outcome;
use crate::bench::{Bench, Files};
use glimt_tests::random::Random;
use std::fs;
use std::process::{Child, Command, ExitStatus};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// A command, the folder that it writes to, and whether its files hold times, which differ from run to run.
struct Job {
    name: &'static str,
    args: &'static [&'static str],
    out: &'static str,
    has_times: bool,
}

const RENDER: [&str; 3] = [
    "image.size=[48,27]",
    "image.rays_per_pixel=8",
    "output.codec=\"av1\"",
];

const JOBS: [Job; 9] = [
    Job {
        name: "render",
        args: &[
            "render",
            "film/shot.toml",
            "--device",
            "cpu",
            "--out",
            "out",
            "--set",
            RENDER[0],
            "--set",
            RENDER[1],
            "--set",
            RENDER[2],
        ],
        out: "out",
        has_times: false,
    },
    Job {
        name: "render smc",
        args: &[
            "render",
            "film/shot.toml",
            "--device",
            "cpu",
            "--out",
            "smc",
            "--method",
            "smc",
            "--state-out",
            "smc/end.state",
            "--set",
            RENDER[0],
            "--set",
            "output.video=",
            "--set",
            "output.aovs=[\"ess\",\"age\"]",
        ],
        out: "smc",
        has_times: false,
    },
    Job {
        name: "render --follow",
        args: &[
            "render",
            "film/shot.toml",
            "--device",
            "cpu",
            "--out",
            "live",
            "--follow",
            "--frames",
            "1-3",
            "--wait",
            "0.5",
            "--max-lag",
            "1000",
            "--set",
            RENDER[0],
            "--set",
            RENDER[2],
        ],
        out: "live",
        has_times: false,
    },
    Job {
        name: "synth",
        args: &["synth", "synth.toml", "--out", "again", "--device", "cpu"],
        out: "again",
        has_times: false,
    },
    Job {
        name: "unwarp",
        args: &[
            "unwarp",
            "film/capture/ball.####.exr",
            "--out",
            "maps",
            "--device",
            "cpu",
            "--size",
            "64x32",
        ],
        out: "maps",
        has_times: false,
    },
    Job {
        name: "bake",
        args: &[
            "bake",
            "film/shot.toml",
            "--device",
            "cpu",
            "--directions",
            "40",
            "--set",
            "object.1.subdivide=5",
            "-o",
            "baked/a.glb",
        ],
        out: "baked",
        has_times: false,
    },
    Job {
        name: "sh",
        args: &[
            "sh",
            "film/truth/latlong.####.exr",
            "-o",
            "sh/light.json",
            "--format",
            "json",
        ],
        out: "sh",
        has_times: false,
    },
    Job {
        name: "compare",
        args: &[
            "compare",
            "film/shot.toml",
            "--device",
            "cpu",
            "--out",
            "compared",
            "--equal-samples",
            "--seeds",
            "2",
            "--rounds",
            "1",
            "--measure",
            "2",
            "--reference-time",
            "0.2",
            "--keep",
            "--set",
            RENDER[0],
            "--preset",
            "stratified",
            "--preset",
            "owen-sobol",
        ],
        out: "compared",
        has_times: true,
    },
    Job {
        name: "demo",
        args: &[
            "demo",
            "--device",
            "cpu",
            "--out",
            "demo",
            "--frames",
            "1",
            "--set",
            "image.size=[64,36]",
            "--set",
            "image.rays_per_pixel=1",
        ],
        out: "demo",
        has_times: false,
    },
];

/// How a run is ended.
#[derive(Clone, Copy)]
enum End {
    Kill,
    Signal(&'static str, i32),
}

impl End {
    fn send(self, child: &mut Child) -> Outcome<ExitStatus> {
        let failed = |e: std::io::Error| e.to_string();
        match self {
            Self::Kill => child.kill().map_err(failed)?,
            Self::Signal(name, _) => {
                let pid = child.id().to_string();
                Command::new("kill")
                    .args(["-s", name, &pid])
                    .status()
                    .map_err(failed)?;
            }
        }
        child.wait().map_err(failed)
    }
}

/// What is known of a job from a run that nobody disturbed.
struct Whole {
    seconds: f64,
    files: Files,
}

/// Kills until the time is over; prints how often.
pub(crate) fn run(minutes: f64, seed: u64) -> Outcome {
    let bench = Bench::new("kill")?;
    bench.film(3)?;
    for folder in ["baked", "sh"] {
        fs::create_dir_all(bench.path.join(folder)).map_err(|e| e.to_string())?;
    }
    let mut random = Random(seed);
    let mut counts = [[0u32; 2]; JOBS.len()];
    let mut wholes = Vec::new();
    for job in &JOBS {
        let began = Instant::now();
        bench.run(job.args)?;
        let seconds = began.elapsed().as_secs_f64();
        wholes.push(Whole {
            seconds,
            files: bench.files(job.out)?,
        });
        println!(
            "{}: {seconds:.2} s, {} files",
            job.name,
            wholes[wholes.len() - 1].files.len()
        );
    }
    let began = Instant::now();
    let mut round = 0;
    while began.elapsed().as_secs_f64() < minutes * 60.0 {
        let index = round % JOBS.len();
        round += 1;
        let kills = once(&bench, &JOBS[index], &wholes[index], &mut random)?;
        counts[index][0] += kills;
        counts[index][1] += 1;
    }
    for (job, [kills, reruns]) in JOBS.iter().zip(counts) {
        println!(
            "{}: {kills} kills, {reruns} times complete after them",
            job.name
        );
    }
    let kills: u32 = counts.iter().map(|[kills, _]| kills).sum();
    println!("{kills} kills in {minutes} minutes, no fault");
    Ok(())
}

/// Kills one command once or more, and runs it to its end.
fn once(bench: &Bench, job: &Job, whole: &Whole, random: &mut Random) -> Outcome<u32> {
    let folder = bench.path.join(job.out);
    let _ = fs::remove_dir_all(&folder);
    if matches!(job.name, "bake" | "sh") {
        fs::create_dir_all(&folder).map_err(|e| e.to_string())?;
    }
    let kills = 1 + random.bits() % 2;
    let mut was_signalled = false;
    for _ in 0..kills {
        let end = match random.bits() % 4 {
            0 => End::Signal("INT", 130),
            1 => End::Signal("TERM", 143),
            _ => End::Kill,
        };
        let mut child = bench
            .command(job.args)?
            .spawn()
            .map_err(|e| e.to_string())?;
        sleep(Duration::from_secs_f64(
            1.05 * whole.seconds * random.unit(),
        ));
        let status = end.send(&mut child)?;
        let files = bench.files(job.out)?;
        if let End::Signal(name, code) = end {
            // It may have been at its end, or not yet have begun to listen.
            let expected = [Some(code), Some(0), None];
            if !expected.contains(&status.code()) {
                return Err(format!("{}: ended by SIG{name} with {status}", job.name));
            }
            let hidden = files.keys().find(|name| is_hidden(name));
            if let (Some(hidden), Some(_)) = (hidden, status.code()) {
                return Err(format!("{}: after SIG{name} {hidden} is left", job.name));
            }
        }
        let mut files = files;
        was_signalled |= matches!(end, End::Signal(..));
        if was_signalled && job.args.contains(&"--follow") {
            // A video of the frames that came is whole, but it is another one. It stays until a run has made the whole one.
            files.remove("shot.mp4");
        }
        check_whole(job, whole, &files)?;
    }
    bench.run(job.args)?;
    let files = bench.files(job.out)?;
    check_whole(job, whole, &files)?;
    let (left, known): (Vec<_>, Vec<_>) = (files.keys().collect(), whole.files.keys().collect());
    if left != known {
        return Err(format!(
            "{}: there are {left:?} in place of {known:?}",
            job.name
        ));
    }
    Ok(kills as u32)
}

fn is_hidden(name: &str) -> bool {
    name.rsplit('/')
        .next()
        .is_some_and(|name| name.starts_with('.'))
}

/// Every file that has its name is as it is after a run that nobody disturbed.
fn check_whole(job: &Job, whole: &Whole, files: &Files) -> Outcome {
    for (name, hash) in files.iter().filter(|(name, _)| !is_hidden(name)) {
        match whole.files.get(name) {
            None => return Err(format!("{}: {name} should not be there", job.name)),
            Some(known) if known != hash && !job.has_times => {
                return Err(format!("{}: {name} is not whole", job.name));
            }
            Some(_) => {}
        }
    }
    Ok(())
}
