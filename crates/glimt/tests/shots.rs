//! Host file: shot files, overrides, resuming, and what a run leaves behind.

mod common;

use common::Scratch;
use std::fs;
use std::time::{Duration, SystemTime};

fn modified(t: &Scratch, name: &str) -> SystemTime {
    fs::metadata(t.file(name)).unwrap().modified().unwrap()
}

#[test]
fn keys_are_suggested_and_placed() {
    let t = Scratch::new("keys");
    t.lights(1);
    t.shot("light.0001.exr", "[render]\nseeed = 3\n");
    t.run(&["render", "shot.toml"]).fails(
        2,
        &["shot.toml:9:1: unknown key `seeed`; did you mean `seed`?"],
    );
    t.shot("light.0001.exr", "[render]\nmethod = \"miss\"\n");
    t.run(&["render", "shot.toml"])
        .fails(2, &["shot.toml:9:10", "did you mean `mis`?"]);
    t.shot("light.0001.exr", "");
    let set = |item: &str, words: &[&str]| {
        t.run(&["render", "shot.toml", "--set", item])
            .fails(2, words);
    };
    set(
        "image.rays=4",
        &["--set image.rays=4", "did you mean `rays_per_pixel`?"],
    );
    set(
        "image.size=[0,4]",
        &["--set image.size=[0,4]", "image.size", "as [1280, 720]"],
    );
    set(
        "object.0.material.diffuse=[1,1,2]",
        &["object.0.material.diffuse", "between 0 and 1"],
    );
    set("render.frames=9-3", &["render.frames", "3-9"]);
    t.run(&["render", "shot.toml", "--frames", "x"])
        .fails(2, &["--frames", "1-96"]);
    t.run(&["render", "gone.toml"])
        .fails(3, &["gone.toml", "no such file"]);
    t.put("broken.toml", "[image\n");
    t.run(&["render", "broken.toml"])
        .fails(2, &["broken.toml:1:"]);
}

#[test]
fn what_is_not_there_yet_is_refused() {
    let t = Scratch::new("later");
    t.lights(1);
    let refused = |more: &str, words: &[&str]| {
        t.shot("light.0001.exr", more);
        t.run(&["render", "shot.toml"]).fails(2, words);
    };
    refused("[output]\naovs = [\"depth\"]\n", &["depth"]);
    t.shot("light.0001.exr", "");
    t.run(&["render", "shot.toml", "--set", "probe.mapping=dome"])
        .fails(2, &["dome", "cube", "lat-long", "angular", "mirror-ball"]);
}

#[test]
fn materials_conserve_energy() {
    let t = Scratch::new("energy");
    t.lights(1);
    let material = "material = { diffuse = [0.8, 0.2, 0.2], specular = [0.3, 0.3, 0.3] }\n";
    t.shot("light.0001.exr", material);
    t.run(&["render", "shot.toml"])
        .fails(2, &["shot.toml:8:14", "diffuse + specular is 1.100"]);
    // A file's own material is scaled down instead.
    t.put(
        "a.mtl",
        "newmtl shiny\nKd 0.8 0.8 0.8\nKs 0.8 0.8 0.8\nNs 100\n",
    );
    t.put(
        "a.obj",
        "mtllib a.mtl\nusemtl shiny\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
    );
    t.run(&["info", "a.obj"])
        .ok()
        .says(&["note:", "`shiny` reflects 1.60", "scaled down"]);
}

#[test]
fn frames_are_skipped_if_nothing_changed() {
    let t = Scratch::new("resume");
    t.lights(3);
    t.shot("light.####.exr", "[output]\nvideo = \"\"\n");
    let render = |more: &[&str]| {
        let mut args = vec!["render", "shot.toml", "--json"];
        args.extend(more);
        let ran = t.run(&args).ok();
        let last = ran.out.lines().last().unwrap().to_owned();
        let summary: serde_json::Value = serde_json::from_str(&last).unwrap();
        assert_eq!(summary["event"], "summary");
        (
            summary["rendered"].as_u64().unwrap(),
            summary["skipped"].as_u64().unwrap(),
        )
    };
    assert_eq!(render(&[]), (3, 0));
    let first = modified(&t, "out/frame.0001.exr");
    assert_eq!(render(&[]), (0, 3));
    assert_eq!(modified(&t, "out/frame.0001.exr"), first);

    // A lost output, another light, another seed, another key.
    fs::remove_file(t.file("out/frame.0002.png")).unwrap();
    assert_eq!(render(&[]), (1, 2));
    t.exr("light.0003.exr", 8, 4, |_, _, _| 9.0);
    assert_eq!(render(&[]), (1, 2));
    assert_eq!(render(&["--seed", "2"]), (3, 0));
    assert_eq!(render(&["--seed", "2", "--frames", "2-3"]), (0, 2));
    assert_eq!(
        render(&["--seed", "2", "--set", "image.exposure_ev=1"]),
        (3, 0)
    );
    // Where it is written, and from which path it is read, change nothing.
    fs::rename(t.file("light.0001.exr"), t.file("moved.0001.exr")).unwrap();
    let moved = [
        "--seed",
        "2",
        "--set",
        "image.exposure_ev=1",
        "--frames",
        "1-1",
        "--set",
        "probe.frames=moved.####.exr",
    ];
    assert_eq!(render(&moved), (0, 1));
}

#[test]
fn a_mesh_is_part_of_a_frame() {
    let t = Scratch::new("mesh");
    t.lights(1);
    t.put("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    t.shot("light.0001.exr", "[[object]]\nmesh = \"a.obj\"\n");
    t.run(&["render", "shot.toml"])
        .ok()
        .says(&["1 frame rendered"]);
    t.run(&["render", "shot.toml"])
        .ok()
        .says(&["0 frames rendered"]);
    t.put("a.obj", "v 0 0 0\nv 1 0 0\nv 0 2 0\nf 1 2 3\n");
    t.run(&["render", "shot.toml"])
        .ok()
        .says(&["1 frame rendered"]);
}

#[test]
fn a_killed_run_is_continued() {
    let t = Scratch::new("killed");
    t.lights(12);
    t.shot("light.####.exr", "");
    let slow = [
        "--set",
        "image.size=[320,180]",
        "--set",
        "image.rays_per_pixel=4",
    ];
    let args: Vec<&str> = ["render", "shot.toml"].into_iter().chain(slow).collect();
    let mut child = t
        .command(&args)
        .stdout(std::process::Stdio::null())
        .stderr(std::process::Stdio::null())
        .spawn()
        .unwrap();
    let began = SystemTime::now();
    while !t.file("out/frame.0003.png").exists() {
        assert!(began.elapsed().unwrap() < Duration::from_secs(120));
        std::thread::sleep(Duration::from_millis(2));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    assert!(
        !t.file("out/shot.mp4").exists(),
        "a video of some frames only"
    );
    let whole: Vec<String> = t
        .list("out")
        .into_iter()
        .filter(|n| !n.starts_with('.'))
        .collect();
    assert!(whole.len() < 24, "it was not killed in time");
    for name in whole.iter().filter(|n| n.ends_with(".exr")) {
        assert_eq!(
            common::read_exr(&t.file("out").join(name))[0].len(),
            320 * 180
        );
    }
    for name in whole.iter().filter(|n| n.ends_with(".png")) {
        image::open(t.file("out").join(name)).unwrap();
    }

    let ran = t.run(&args).ok();
    assert!(!ran.err.contains(" 0 there already"), "{}", ran.err);
    let names = t.list("out");
    assert_eq!(names.len(), 25, "{names:?}");
    assert!(names.contains(&"shot.mp4".to_owned()));
}

#[test]
fn the_video_is_of_the_whole_shot() {
    let t = Scratch::new("video");
    t.lights(3);
    t.shot("light.####.exr", "[output]\ncodec = \"av1\"\n");
    let video = |more: &[&str]| {
        let mut args = vec!["render", "shot.toml"];
        args.extend(more);
        t.run(&args).ok()
    };
    // The image is too small for a video.
    t.run(&["render", "shot.toml"])
        .fails(4, &["shot.mp4", "16 × 16"]);
    let size = ["--set", "image.size=[33,17]"];
    video(&[size[0], size[1], "--frames", "1-2"]).says(&["video", "all frames"]);
    assert!(!t.file("out/shot.mp4").exists());
    video(&size).says(&["1 frame rendered, 2 there already", "shot.mp4"]);
    let bytes = fs::read(t.file("out/shot.mp4")).unwrap();
    assert_eq!(&bytes[4..8], b"ftyp");
    let made = modified(&t, "out/shot.mp4");
    video(&size).says(&["0 frames rendered, 3 there already"]);
    assert_eq!(modified(&t, "out/shot.mp4"), made);
    fs::remove_file(t.file("out/shot.mp4")).unwrap();
    video(&size).says(&["0 frames rendered, 3 there already", "shot.mp4"]);
    assert_eq!(fs::read(t.file("out/shot.mp4")).unwrap().len(), bytes.len());
}

/// Frames that were there already come into the video the same from their PNG and from their EXR.
#[test]
fn the_video_takes_frames_from_either_file() {
    let t = Scratch::new("either");
    t.lights(3);
    t.shot("light.####.exr", "[output]\ncodec = \"av1\"\n");
    let video = |out: &str, more: &[&str]| {
        let mut args = vec![
            "render",
            "shot.toml",
            "--out",
            out,
            "--set",
            "image.size=[32,32]",
        ];
        args.extend(more);
        t.run(&args).ok();
        fs::remove_file(t.file(out).join("shot.mp4")).unwrap();
        t.run(&args)
            .ok()
            .says(&["0 frames rendered, 3 there already"]);
        fs::read(t.file(out).join("shot.mp4")).unwrap()
    };
    let from_png = video("a", &[]);
    let from_exr = video("b", &["--set", "output.png=false"]);
    assert!(!t.file("b/frame.0001.png").exists());
    assert_eq!(from_png, from_exr);
}

/// A program of that name on the path takes the frames by its standard input.
#[cfg(unix)]
#[test]
fn ffmpeg_is_used_where_it_is_found() {
    use std::os::unix::fs::PermissionsExt;
    let t = Scratch::new("ffmpeg");
    t.lights(3);
    t.shot("light.####.exr", "");
    fs::create_dir_all(t.file("bin")).unwrap();
    let install = |script: &str| {
        let script = t.put("script", script);
        fs::set_permissions(&script, fs::Permissions::from_mode(0o755)).unwrap();
        // Copied by another process: a program that is open for writing here, or in a child of another test, does not
        // start.
        let copy = std::process::Command::new("cp")
            .arg(script)
            .arg(t.file("bin/ffmpeg"))
            .status();
        assert!(copy.unwrap().success());
    };
    let path = format!("{}:/usr/bin:/bin", t.file("bin").display());
    let run = |more: &[&str]| {
        let mut args = vec!["render", "shot.toml", "--set", "image.size=[20,18]"];
        args.extend(more);
        let output = t.command(&args).env("PATH", &path).output().unwrap();
        common::Ran {
            status: output.status.code().unwrap_or(-1),
            out: String::new(),
            err: String::from_utf8_lossy(&output.stderr).into_owned(),
        }
    };
    // Keeps the title and what else it is given; its last argument is the file to write.
    install(
        "#!/bin/sh\n[ \"$1\" = -version ] && exit 0\nprintf '\\0\\0\\0\\030ftypisom' > start\n\
         for last; do case \"$last\" in title=*) printf '%s' \"$last\" >> start;; esac; done\ncat start - > \"$last\"\n",
    );
    run(&[]).ok();
    let bytes = fs::read(t.file("out/shot.mp4")).unwrap();
    let start = fs::read(t.file("start")).unwrap();
    assert_eq!(bytes.len(), start.len() + 3 * 20 * 18 * 3);

    install("#!/bin/sh\n[ \"$1\" = -version ] && exit 0\necho 'Unknown encoder' >&2\nexit 1\n");
    run(&["--seed", "2"]).fails(
        4,
        &[
            "shot.mp4",
            "ffmpeg failed: Unknown encoder",
            "output.codec=av1",
        ],
    );
    assert_eq!(
        fs::read(t.file("out/shot.mp4")).unwrap(),
        bytes,
        "the earlier video stays"
    );
    run(&["--seed", "2", "--set", "output.codec=av1"]).ok();
    fs::remove_file(t.file("bin/ffmpeg")).unwrap();
    run(&["--seed", "3", "--set", "output.codec=h264"]).fails(4, &["ffmpeg cannot be started"]);
}

#[test]
fn events_are_json_lines() {
    let t = Scratch::new("json");
    t.lights(2);
    t.shot("light.####.exr", "[output]\nvideo = \"\"\n");
    let ran = t.run(&["render", "shot.toml", "--json"]).ok();
    let events: Vec<serde_json::Value> = ran
        .out
        .lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect();
    let names: Vec<&str> = events
        .iter()
        .map(|e| e["event"].as_str().unwrap())
        .collect();
    assert_eq!(names, ["start", "frame", "frame", "summary"]);
    assert_eq!(ran.err, "");
    let ran = t.run(&["render", "gone.toml", "--json"]);
    let event: serde_json::Value = serde_json::from_str(ran.out.trim()).unwrap();
    assert_eq!(
        (&event["event"], &event["exit"]),
        (&"error".into(), &3.into())
    );
    assert_eq!(event["file"], "gone.toml");
    let ran = t
        .run(&["render", "shot.toml", "--quiet", "--seed", "5"])
        .ok();
    assert_eq!((ran.out.as_str(), ran.err.as_str()), ("", ""));
}

#[test]
fn info_of_everything() {
    let t = Scratch::new("info");
    t.exr("light.exr", 8, 4, |x, y, _| {
        if (x, y) == (2, 1) { 100.0 } else { 1.0 }
    });
    t.shot("light.exr", "");
    let ran = t.run(&["info", "light.exr"]).ok();
    for word in [
        "8 × 4 (2:1)",
        "B f32, G f32, R f32",
        "max 100",
        "texel (2, 1)",
        "none",
    ] {
        assert!(ran.out.contains(word), "{word}: {}", ran.out);
    }
    let ran = t.run(&["info", "shot.toml", "--set", "render.seed=7"]).ok();
    for word in [
        "rays_per_pixel = 1",
        "env_samples = 1",
        "compensation = true",
        "seed = 7",
        "fps = 25.0",
        "mesh = \"sphere\"",
    ] {
        assert!(ran.out.contains(word), "{word}: {}", ran.out);
    }
    let set = ["info", "shot.toml", "--set", "render.preset=kronander"];
    assert!(t.run(&set).ok().out.contains("compensation = false"));
    // What it prints is a shot again.
    t.put("again.toml", &ran.out);
    assert_eq!(t.run(&["info", "again.toml"]).ok().out, ran.out);
    let ran = t.run(&["info", "--json"]).ok();
    let value: serde_json::Value = serde_json::from_str(&ran.out).unwrap();
    assert_eq!(value["version"], env!("CARGO_PKG_VERSION"));
}
