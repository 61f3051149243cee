//! Host file: what is the user's stays: inputs, files of other programs, edited files, what another run is writing.

mod common;

use common::{Scratch, read_exr};
use serde_json::Value;
use std::fs;
use std::path::Path;
use std::process::Stdio;
use std::thread::sleep;
use std::time::{Duration, Instant};

/// All files below a folder with their bytes.
fn content(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let mut all = Vec::new();
    for entry in fs::read_dir(folder).unwrap().flatten() {
        match entry.file_type().unwrap().is_dir() {
            true => all.extend(content(&entry.path())),
            false => {
                let name = entry.path().display().to_string();
                all.push((name, fs::read(entry.path()).unwrap()));
            }
        }
    }
    all.sort();
    all
}

/// Runs the program, which refuses with these words and changes nothing in the folder.
fn refused(t: &Scratch, args: &[&str], words: &[&str]) {
    let before = content(&t.path);
    t.run(args).fails(2, words);
    assert!(content(&t.path) == before, "{args:?} wrote something");
}

fn no_video(more: &str) -> String {
    format!("[output]\nvideo = \"\"\n{more}")
}

#[test]
fn frames_are_not_written_over_light_or_plate() {
    let t = Scratch::new("over-inputs");
    t.lights(3);
    for frame in 1..=3 {
        let light = t.file(&format!("light.{frame:04}.exr"));
        fs::copy(light, t.file(&format!("frame.{frame:04}.exr"))).unwrap();
    }
    t.shot("frame.####.exr", &no_video("dir = \".\"\n"));
    let words = ["frame.0001.exr", "the shot's light", "--out"];
    refused(&t, &["render", "shot.toml"], &words);
    refused(&t, &["render", "shot.toml", "--overwrite"], &words);
    refused(
        &t,
        &["render", "shot.toml", "--follow", "--wait", "1"],
        &words,
    );
    t.run(&["render", "shot.toml", "--out", "out"]).ok();

    for frame in 1..=3 {
        let plate = image::RgbImage::from_fn(16, 12, |x, y| image::Rgb([x as u8, y as u8, 9]));
        plate
            .save(t.file(&format!("frame.{frame:04}.png")))
            .unwrap();
    }
    t.shot(
        "light.####.exr",
        &no_video("dir = \".\"\nexr = false\n[backplate]\nframes = \"frame.####.png\"\n"),
    );
    let words = ["frame.0001.png", "the shot's backplate"];
    refused(&t, &["render", "shot.toml", "--overwrite"], &words);
}

#[cfg(unix)]
#[test]
fn links_are_followed_to_inputs() {
    let t = Scratch::new("over-links");
    t.lights(1);
    t.shot("light.0001.exr", &no_video(""));
    t.put("out/none", "");
    std::os::unix::fs::symlink("../light.0001.exr", t.file("out/frame.0001.exr")).unwrap();
    refused(
        &t,
        &["render", "shot.toml", "--overwrite"],
        &["the shot's light"],
    );
}

#[test]
fn files_of_other_programs_are_replaced_only_if_asked() {
    let t = Scratch::new("over-others");
    t.lights(1);
    t.shot("light.0001.exr", &no_video(""));
    // A render of another program, and a text.
    t.put("out/none", "");
    t.exr("out/frame.0001.exr", 4, 4, |x, _, _| x as f32);
    let words = [
        "out/frame.0001.exr",
        "glimt did not write it",
        "--overwrite",
    ];
    refused(&t, &["render", "shot.toml"], &words);
    // Following would come to it.
    t.shot("light.####.exr", &no_video(""));
    let follow = [
        "render",
        "shot.toml",
        "--follow",
        "--frames",
        "2-9",
        "--wait",
        "0.3",
    ];
    refused(&t, &follow, &words);
    t.shot("light.0001.exr", &no_video(""));
    t.run(&["render", "shot.toml", "--overwrite"]).ok();
    // What the program wrote itself it replaces, as before.
    t.run(&["render", "shot.toml", "--seed", "9"])
        .ok()
        .says(&["1 frame rendered"]);

    t.shot(
        "light.####.exr",
        "[output]\ncodec = \"av1\"\n[render]\nframes = \"1-1\"\n",
    );
    t.put("poem.csv", "roses,red\n");
    let words = ["poem.csv", "glimt did not write it"];
    refused(&t, &["sh", "light.0001.exr", "-o", "poem.csv"], &words);
    t.run(&["sh", "light.0001.exr", "-o", "poem.csv", "--overwrite"])
        .ok();
    for format in ["csv", "json", "engine"] {
        t.run(&["sh", "light.0001.exr", "-o", "poem.csv", "--format", format])
            .ok();
    }
    refused(
        &t,
        &[
            "sh",
            "light.0001.exr",
            "-o",
            "light.0001.exr",
            "--overwrite",
        ],
        &["one of the lights"],
    );
}

#[test]
fn videos_of_other_programs_are_not_replaced() {
    let t = Scratch::new("over-video");
    t.lights(2);
    t.shot("light.####.exr", "[output]\ncodec = \"av1\"\nexr = false\n");
    let args = ["render", "shot.toml", "--set", "image.size=[32,16]"];
    t.put("out/shot.mp4", b"\0\0\0\x18ftypisom a film of the user's");
    refused(&t, &args, &["shot.mp4", "glimt did not write it"]);
    t.run(&[&args[..], &["--overwrite"]].concat()).ok();
    let again = [&args[..], &["--seed", "4"]].concat();
    t.run(&again).ok().says(&["2 frames rendered"]);
}

#[test]
fn states_replace_states_alone() {
    let t = Scratch::new("over-state");
    t.lights(2);
    t.shot("light.####.exr", &no_video("[render]\nmethod = \"smc\"\n"));
    let save = |file: &'static str, more: &[&'static str]| {
        let args = [
            "render",
            "shot.toml",
            "--state-out",
            file,
            "--frames",
            "1-2",
        ];
        [&args[..], more].concat()
    };
    for (file, word) in [
        ("shot.toml", "not a state"),
        ("light.0001.exr", "not a state"),
    ] {
        refused(&t, &save(file, &[]), &[file, word]);
        refused(&t, &save(file, &["--overwrite"]), &[file, word]);
    }
    t.run(&save("a.state", &[])).ok();
    t.run(&save("a.state", &["--seed", "3"]))
        .ok()
        .says(&["2 frames rendered"]);
    let before = fs::read(t.file("a.state")).unwrap();
    let from = ["render", "shot.toml", "--frames", "2", "--seed", "3"];
    let onto_itself = ["--state-in", "a.state", "--state-out", "a.state"];
    t.run(&[&from[..], &onto_itself].concat())
        .fails(2, &["--state-in"]);
    assert!(fs::read(t.file("a.state")).unwrap() == before);
    // What cannot be saved is said before anything is rendered.
    let ran = t.run(&save("nowhere/a.state", &["--seed", "5"]));
    ran.fails(4, &["nowhere/a.state"]);
    let (first, _) = (t.list("out"), ());
    assert_eq!(
        first,
        [
            "frame.0001.exr",
            "frame.0001.png",
            "frame.0002.exr",
            "frame.0002.png"
        ]
    );
}

/// A state that is there already stays the state of the last frame, also when an earlier frame is made again.
#[test]
fn a_lost_frame_does_not_change_the_state() {
    let t = Scratch::new("state-stays");
    t.lights(3);
    t.shot("light.####.exr", &no_video("[render]\nmethod = \"smc\"\n"));
    let save = ["render", "shot.toml", "--state-out", "a.state"];
    t.run(&save).ok();
    let before = fs::read(t.file("a.state")).unwrap();
    fs::remove_file(t.file("out/frame.0001.exr")).unwrap();
    t.run(&save)
        .ok()
        .says(&["1 frame rendered, 2 there already"]);
    assert!(fs::read(t.file("a.state")).unwrap() == before);
}

#[test]
fn edited_shots_are_left_alone() {
    let t = Scratch::new("edited");
    let small = [
        "--set",
        "capture.size=[96,68]",
        "--set",
        "capture.pixel_um=125",
        "--set",
        "truth.size=[16,8]",
    ];
    let synth = [
        &[
            "synth",
            "--out",
            "film",
            "--frames",
            "1",
            "--device",
            "cpu",
            "--set",
            "plate.size=[32,18]",
        ],
        &small[..],
    ]
    .concat();
    t.run(&synth).ok();
    let shot = t.file("film/shot.toml");
    let text = fs::read_to_string(&shot).unwrap();
    fs::write(&shot, format!("{text}# mine\n")).unwrap();
    t.run(&synth).ok().says(&["film/shot.toml", "was edited"]);
    assert!(fs::read_to_string(&shot).unwrap().ends_with("# mine\n"));
    t.run(&[&synth[..], &["--overwrite"]].concat()).ok();
    assert_eq!(fs::read_to_string(&shot).unwrap(), text);

    // Film is not unwarped onto itself, and not written over its light.
    let film = t.file("film/capture/ball.0001.exr");
    fs::rename(&film, t.file("film/capture/latlong.0001.exr")).unwrap();
    refused(
        &t,
        &[
            "unwarp",
            "film/capture/latlong.####.exr",
            "--out",
            "film/capture",
            "--overwrite",
        ],
        &["latlong.0001.exr", "the film"],
    );
    let light = "film/truth/latlong.0001.exr";
    refused(
        &t,
        &[
            "synth",
            light,
            "--out",
            "film",
            "--frames",
            "1",
            "--seed",
            "8",
            "--device",
            "cpu",
            "--overwrite",
        ],
        &["latlong.0001.exr", "the light map"],
    );
}

/// The stamp of a frame is of the light that it shows, also where that was replaced while the run was under way.
#[test]
fn a_light_that_is_replaced_during_a_run_gives_no_false_stamp() {
    let t = Scratch::new("replaced");
    for frame in 1..=3 {
        t.exr(&format!("light.{frame:04}.exr"), 8, 4, |_, _, _| 1.0);
    }
    t.exr("bright.exr", 8, 4, |_, _, _| 8.0);
    t.shot("light.####.exr", &no_video("png = false\n"));
    // The first frame takes long enough for the third light to be replaced meanwhile; it is read after the second is rendered.
    let args = [
        "render",
        "shot.toml",
        "--set",
        "image.size=[200,200]",
        "--set",
        "image.rays_per_pixel=16",
        "--method",
        "mis",
    ];
    let mut command = t.command(&args);
    command.stdout(Stdio::null()).stderr(Stdio::piped());
    let child = command.spawn().unwrap();
    let began = Instant::now();
    while !t.file("out/frame.0001.exr").exists() {
        assert!(began.elapsed().as_secs() < 60);
        sleep(Duration::from_millis(1));
    }
    fs::rename(t.file("bright.exr"), t.file("light.0003.exr")).unwrap();
    let output = child.wait_with_output().unwrap();
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success(), "{said}");
    let middle = |frame: u32| {
        let channels = read_exr(&t.file(&format!("out/frame.{frame:04}.exr")));
        channels[3][100 * 200 + 100]
    };
    let ratio = middle(3) / middle(2);
    if ratio > 2.0 {
        assert!(said.contains("changed since the run began"), "{said}");
        // The frame is current: it is what its light makes.
        t.run(&args)
            .ok()
            .says(&["0 frames rendered, 3 there already"]);
    } else {
        // The light had been read before; the frame is stale then.
        t.run(&args)
            .ok()
            .says(&["1 frame rendered, 2 there already"]);
    }
    assert!((middle(3) / middle(2) - 8.0).abs() < 0.5);
}

#[test]
fn one_run_writes_to_a_folder_or_all_share_it() {
    let t = Scratch::new("locked");
    t.lights(4);
    t.shot("light.####.exr", &no_video(""));
    let slow = [
        "--set",
        "image.size=[160,120]",
        "--set",
        "image.rays_per_pixel=16",
    ];
    let first = |more: &[&str]| {
        let args = [&["render", "shot.toml", "--frames", "1-2"], &slow[..], more].concat();
        let mut command = t.command(&args);
        command.stdout(Stdio::null()).stderr(Stdio::null());
        let child = command.spawn().unwrap();
        let began = Instant::now();
        while !t.file("out/.glimt.lock").exists() {
            assert!(began.elapsed().as_secs() < 20);
            sleep(Duration::from_millis(1));
        }
        child
    };
    let second =
        |more: &[&str]| t.run(&[&["render", "shot.toml", "--frames", "3-4"], more].concat());
    let mut alone = first(&[]);
    second(&[]).fails(4, &["another run of glimt", "--share"]);
    alone.kill().unwrap();
    alone.wait().unwrap();
    // What it left does not hinder, and is cleared away.
    second(&[]).ok();
    let mut sharing = first(&["--share"]);
    second(&["--share", "--seed", "2"]).ok();
    assert!(sharing.wait().unwrap().success());
    let names = t.list("out");
    assert_eq!(names.len(), 8, "{names:?}");
}

#[cfg(unix)]
#[test]
fn a_signal_ends_after_the_frame_and_leaves_nothing_half_written() {
    let t = Scratch::new("signal");
    t.lights(40);
    t.shot("light.####.exr", &no_video(""));
    for (signal, status) in [("INT", 130), ("TERM", 143)] {
        let args = [
            "render",
            "shot.toml",
            "--json",
            "--set",
            "image.size=[64,48]",
            "--set",
            "image.rays_per_pixel=64",
        ];
        let mut command = t.command(&args);
        command.stdout(Stdio::piped()).stderr(Stdio::piped());
        let child = command.spawn().unwrap();
        let began = Instant::now();
        while t.list("out").iter().all(|name| !name.ends_with("0002.png")) {
            assert!(began.elapsed().as_secs() < 60);
            sleep(Duration::from_millis(1));
        }
        let pid = child.id().to_string();
        let kill = std::process::Command::new("kill")
            .args(["-s", signal, &pid])
            .status();
        assert!(kill.unwrap().success());
        let output = child.wait_with_output().unwrap();
        assert_eq!(output.status.code(), Some(status));
        let out = String::from_utf8(output.stdout).unwrap();
        let last: Value = serde_json::from_str(out.lines().last().unwrap()).unwrap();
        assert_eq!(
            (&last["event"], &last["exit"]),
            (&"error".into(), &status.into())
        );
        let message = last["message"].as_str().unwrap();
        assert!(message.contains("of 40 frames are there"), "{message}");
        let names = t.list("out");
        assert!(
            names.iter().all(|name| name.starts_with("frame.")),
            "{names:?}"
        );
        assert!(names.len() < 80);
        fs::remove_dir_all(t.file("out")).unwrap();
    }
}

#[test]
fn what_programs_and_terminals_read_is_clean() {
    let t = Scratch::new("clean");
    let ran = t.run(&["render", "--json", "--no-such-flag"]);
    assert_eq!(ran.status, 2);
    let event: Value = serde_json::from_str(ran.out.trim()).unwrap();
    assert_eq!(event["event"], "error");
    assert!(
        event["message"]
            .as_str()
            .unwrap()
            .contains("--no-such-flag")
    );

    #[cfg(unix)]
    {
        let evil = "a\u{1b}[2J\nb.toml";
        let ran = t.run(&["render", evil]);
        assert_eq!(ran.status, 3, "{ran:?}");
        assert!(
            !ran.err.contains('\u{1b}') && ran.err.lines().count() == 1,
            "{:?}",
            ran.err
        );
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_standard_output_is_an_error() {
    let t = Scratch::new("full-output");
    t.lights(1);
    t.shot("light.0001.exr", &no_video(""));
    for args in [
        &["info", "light.0001.exr"][..],
        &["render", "shot.toml", "--json"],
        &["sh", "light.0001.exr"],
    ] {
        let full = fs::File::options().write(true).open("/dev/full").unwrap();
        let output = t
            .command(args)
            .stdout(full)
            .stderr(Stdio::piped())
            .output()
            .unwrap();
        let said = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(4), "{args:?}: {said}");
        assert!(said.contains("standard output"), "{said}");
    }
}
