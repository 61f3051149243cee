//! Host file: which file is which frame: numbers and their notations, lists of frames, and which plate belongs to which light.

mod common;

use common::{Scratch, read_exr};
use std::fs;

/// The number of a plate's code: frames are told apart by their grey.
const STEP: u8 = 20;

/// Grey plates, `plate.nnnn.png`: the first of them has the code 20, the next 40, and so on.
fn plates(t: &Scratch, frames: std::ops::RangeInclusive<i32>) {
    for (i, frame) in (1..).zip(frames) {
        let image = image::RgbImage::from_pixel(16, 16, image::Rgb([i * STEP; 3]));
        image
            .save(t.file(&format!("plate.{frame:04}.png")))
            .unwrap();
    }
}

/// Lights, `light.nnnn.exr`, all alike.
fn lights(t: &Scratch, frames: std::ops::RangeInclusive<i32>) {
    for frame in frames {
        t.exr(&format!("light.{frame:04}.exr"), 8, 4, |x, _, _| x as f32);
    }
}

/// A shot of a sphere whose frames a video can hold.
fn shot(t: &Scratch, frames: &str, more: &str) {
    let file = t.shot(frames, more);
    let text = fs::read_to_string(&file).unwrap();
    fs::write(file, text.replace("[16, 12]", "[16, 16]")).unwrap();
}

/// A shot whose sphere is out of sight, over plates.
fn over_plates(t: &Scratch, probe: &str, backplate: &str) {
    let away = "translate = [0, 0, 500]\n[camera]\neye = [-5, 0, 0]\ntarget = [0, 0, 0]\n";
    let rest = format!(
        "[backplate]\nframes = \"plate.####.png\"\n{backplate}\n[output]\ncodec = \"av1\"\n"
    );
    shot(t, probe, &format!("{away}{rest}"));
}

/// Which of the plates each of these frames shows, counted from 1.
fn shown<const N: usize>(t: &Scratch, frames: [i32; N]) -> [u8; N] {
    let first_code = |frame: i32| {
        let file = t.file(&format!("out/frame.{frame:04}.png"));
        image::open(file).unwrap().to_rgb8().into_raw()[0]
    };
    frames.map(|frame| first_code(frame) / STEP)
}

/// Seconds that a video lasts, by its movie header.
fn seconds(t: &Scratch) -> f64 {
    let bytes = fs::read(t.file("out/shot.mp4")).unwrap();
    let at = bytes.windows(4).position(|four| four == b"mvhd").unwrap();
    assert_eq!(bytes[at + 4], 0, "a header of version 0");
    let word = |i: usize| u32::from_be_bytes(bytes[at + i..at + i + 4].try_into().unwrap());
    f64::from(word(20)) / f64::from(word(16))
}

#[test]
fn sequences_of_equal_length_belong_together_from_their_first_frames_on() {
    let t = Scratch::new("pair");
    lights(&t, 1..=3);
    plates(&t, 1001..=1003);
    over_plates(&t, "light.####.exr", "");
    t.run(&["render", "shot.toml", "--strict"]).ok().says(&[
        "note:",
        "frame 1001 of the backplate belongs to frame 1;",
        "backplate.offset",
    ]);
    assert_eq!(shown(&t, [1, 2, 3]), [1, 2, 3]);
    // A part is laid over the same plates as the whole.
    t.run(&[
        "render",
        "shot.toml",
        "--frames",
        "3",
        "--overwrite",
        "--set",
        "image.exposure_ev=1",
    ])
    .ok();
    assert_eq!(shown(&t, [3]), [3]);
    // The shot knows better.
    t.run(&["render", "shot.toml", "--set", "backplate.offset=1001"])
        .ok()
        .says(&["frame 3 of the probe is left out"])
        .says(&["2 frames rendered"]);
    assert_eq!(shown(&t, [1, 2]), [2, 3]);

    // Both have frames 2 and 3, so another guess is as good.
    let t = Scratch::new("pair-overlap");
    lights(&t, 1..=3);
    plates(&t, 2..=4);
    over_plates(&t, "light.####.exr", "");
    t.run(&["render", "shot.toml"]).ok().says(&[
        "warning:",
        "frame 2 of the backplate belongs to frame 1",
        "backplate.offset = 1 says so, and 0 matches",
    ]);
    assert_eq!(shown(&t, [1, 2, 3]), [1, 2, 3]);
    t.run(&["render", "shot.toml", "--strict"]).fails(
        3,
        &[
            "plate.0002.png",
            "frame 2 of the backplate belongs to frame 1",
        ],
    );
    let exact = t.run(&[
        "render",
        "shot.toml",
        "--strict",
        "--set",
        "backplate.offset=0",
    ]);
    exact.ok().says(&["2 frames rendered"]);
    assert_eq!(shown(&t, [2, 3]), [1, 2]);
}

#[test]
fn the_advice_for_numbers_that_never_meet_works() {
    let t = Scratch::new("pair-advice");
    lights(&t, 1..=3);
    plates(&t, 1001..=1005);
    over_plates(&t, "light.####.exr", "");
    let refused = t.run(&["render", "shot.toml"]);
    let text = refused.err.clone();
    refused.fails(
        3,
        &[
            "frames 1001 to 1005",
            "the probe 1 to 3",
            "none belong together",
        ],
    );
    let advice = text.split("backplate.offset = ").nth(1).unwrap();
    let offset: i32 = advice.split(' ').next().unwrap().parse().unwrap();
    assert_eq!(offset, 1000);
    let set = format!("backplate.offset={offset}");
    t.run(&["render", "shot.toml", "--set", &set])
        .ok()
        .says(&[
            "warning:",
            "frames 1004 to 1005 of the backplate are left out",
        ])
        .says(&["3 frames rendered"]);
    assert_eq!(shown(&t, [1, 2, 3]), [1, 2, 3]);
    // Frames that the shot names: the same key is advised.
    t.run(&["render", "shot.toml", "--set", "render.frames=1-3"])
        .fails(3, &["plate.0001.png", "backplate.offset"]);
}

#[test]
fn a_still_light_has_no_rate() {
    let t = Scratch::new("still-rate");
    t.exr("light.exr", 8, 4, |x, _, _| x as f32);
    plates(&t, 1001..=1006);
    over_plates(&t, "light.exr", "fps = 12");
    t.run(&["render", "shot.toml"])
        .ok()
        .says(&["note:", "12 frames a second", "a still light has no rate"])
        .says(&["6 frames rendered"]);
    let frames = [1001, 1002, 1003, 1004, 1005, 1006];
    assert_eq!(shown(&t, frames), [1, 2, 3, 4, 5, 6]);
    assert!((seconds(&t) - 0.5).abs() < 1e-3, "{}", seconds(&t));
    assert!(
        t.run(&["info", "shot.toml"])
            .ok()
            .out
            .contains("fps = 12.0")
    );
    // A rate that the shot says stays: at twice the rate each plate is shown twice.
    t.run(&[
        "render",
        "shot.toml",
        "--set",
        "probe.fps=24",
        "--overwrite",
    ])
    .ok()
    .says(&["matched by time"]);
    assert_eq!(shown(&t, [1001, 1002, 1003, 1004]), [1, 2, 2, 3]);
    // The offset numbers the frames of the shot.
    let set = ["--set", "backplate.offset=1000", "--out", "from-1"];
    t.run(&[&["render", "shot.toml"], &set[..]].concat()).ok();
    assert_eq!(t.list("from-1")[0], "frame.0001.exr");
    assert_eq!(t.list("from-1").len(), 13);

    // So it is with a light as long as the backplate, whose rate is not said; another length leaves a guess.
    let t = Scratch::new("same-rate");
    lights(&t, 1..=6);
    plates(&t, 1..=6);
    over_plates(&t, "light.####.exr", "fps = 12");
    t.run(&["render", "shot.toml"]).ok().says(&[
        "note:",
        "12 frames a second",
        "probe.fps is not given",
    ]);
    assert_eq!(shown(&t, [1, 2, 3, 4, 5, 6]), [1, 2, 3, 4, 5, 6]);
    assert!((seconds(&t) - 0.5).abs() < 1e-3, "{}", seconds(&t));
    fs::remove_file(t.file("light.0006.exr")).unwrap();
    t.run(&["render", "shot.toml"]).ok().says(&[
        "warning:",
        "probe.fps is not given",
        "backplate.fps is 12",
        "25",
    ]);
    t.run(&["render", "shot.toml", "--strict"])
        .fails(3, &["probe.fps is not given"]);
}

#[test]
fn patterns_of_other_programs_are_read() {
    let t = Scratch::new("patterns");
    lights(&t, 9..=11);
    for pattern in [
        "light.%04d.exr",
        "light.$F4.exr",
        "light.${F4}.exr",
        "light.@@@@.exr",
        "light.####.exr",
    ] {
        shot(&t, pattern, "");
        let out = format!("out-{}", pattern.len());
        t.run(&["render", "shot.toml", "--out", &out]).ok();
        assert_eq!(t.list(&out).len(), 7, "{pattern}");
        assert!(
            t.file(&format!("{out}/frame.0010.exr")).is_file(),
            "{pattern}"
        );
        let lines = t.run(&["sh", pattern, "--bands", "1"]).ok().out;
        let rows = lines.lines().filter(|line| line.starts_with("10,")).count();
        assert_eq!(rows, 1, "{pattern}: {lines}");
    }
    // Numbers without zeros in front of them.
    for frame in 9..=11 {
        let from = t.file(&format!("light.{frame:04}.exr"));
        fs::copy(from, t.file(&format!("plain.{frame}.exr"))).unwrap();
    }
    for pattern in ["plain.%d.exr", "plain.$F.exr", "plain.@.exr", "plain.#.exr"] {
        shot(&t, pattern, "");
        let out = format!("plain-{}", pattern.len());
        t.run(&["render", "shot.toml", "--out", &out]).ok();
        assert_eq!(t.list(&out).len(), 7, "{pattern}");
    }
}

#[test]
fn names_may_hold_what_stands_for_numbers() {
    let t = Scratch::new("literal");
    for name in ["take#2.exr", "sky@2x.exr", "50%d.exr", "take#2.0001.exr"] {
        t.exr(name, 8, 4, |x, _, _| x as f32);
    }
    for pattern in [
        "take[#]2.exr",
        "sky@2x.exr",
        "50%d.exr",
        "take[#]2.####.exr",
    ] {
        shot(&t, pattern, "");
        t.run(&["render", "shot.toml"]).ok().says(&["1 frame"]);
    }
    // Without the escape it is a place for a number, and the error says the name to write.
    shot(&t, "take#2.exr", "");
    t.run(&["render", "shot.toml"])
        .fails(3, &["no file is named take#2.exr", "take[#]2.####.exr"]);
}

#[test]
fn what_is_no_pattern_names_one() {
    let t = Scratch::new("no-pattern");
    fs::create_dir_all(t.file("film")).unwrap();
    for frame in 98..=101 {
        t.exr(&format!("film/l_{frame}.exr"), 8, 4, |x, _, _| x as f32);
    }
    t.exr("film/other.0001.exr", 8, 4, |x, _, _| x as f32);
    t.put("film/notes.1.txt", "none");
    for pattern in [
        "film/*.exr",
        "film",
        "film/",
        "film/l_<frame>.exr",
        "film/l_[98-101].exr",
        "film/l_???.exr",
    ] {
        shot(&t, pattern, "");
        t.run(&["render", "shot.toml"])
            .fails(2, &["probe.frames", pattern, "####", "film/l_##.exr"]);
    }
    // The example works.
    shot(&t, "film/l_##.exr", "");
    t.run(&["render", "shot.toml"])
        .ok()
        .says(&["4 frames rendered"]);
    // Too many digits: what is there is told.
    shot(&t, "film/l_####.exr", "");
    t.run(&["render", "shot.toml"])
        .fails(3, &["no file is named l_####.exr", "4 there: l_##.exr"]);
    shot(&t, "light.%040d.exr", "");
    t.run(&["render", "shot.toml"]).fails(2, &["40 digits"]);
}

#[test]
fn numbers_may_be_negative() {
    let t = Scratch::new("negative");
    lights(&t, -1..=1);
    shot(&t, "light.####.exr", "");
    assert!(t.file("light.-001.exr").is_file());
    t.run(&["render", "shot.toml"])
        .ok()
        .says(&["3 frames rendered"]);
    let names = ["frame.-001", "frame.0000", "frame.0001"];
    let files = names.map(|name| [format!("{name}.exr"), format!("{name}.png")]);
    let mut files = files.concat();
    files.push("shot.mp4".to_owned());
    assert_eq!(t.list("out"), files);
    t.run(&["render", "shot.toml"])
        .ok()
        .says(&["0 frames rendered, 3 there already"]);
    // A frame's random numbers are its own: it is the same alone, and not that of the frame with the other sign.
    t.run(&["render", "shot.toml", "--frames=-1", "--out", "alone"])
        .ok();
    let picture = |file: &str| read_exr(&t.file(file));
    assert_eq!(
        picture("alone/frame.-001.exr"),
        picture("out/frame.-001.exr")
    );
    assert_ne!(picture("out/frame.0001.exr"), picture("out/frame.-001.exr"));
    // Motion counts from the first frame: half a turn a frame, at 0 after half of it.
    let key = |frame: i32, y: f32| {
        format!("[[camera.key]]\nframe = {frame}\neye = [-5, {y}, 0]\ntarget = [0, 0, 0]\n")
    };
    shot(
        &t,
        "light.####.exr",
        &format!("{}{}", key(-1, 1.0), key(1, 3.0)),
    );
    let said = t
        .run(&["info", "shot.toml", "--set", "camera.interpolation=linear"])
        .ok()
        .out;
    assert!(
        said.contains("camera in frame -1: eye [-5, 1, 0]"),
        "{said}"
    );

    // The sign beside all digits, as some programs write it.
    fs::rename(t.file("light.-001.exr"), t.file("light.-0001.exr")).unwrap();
    shot(&t, "light.####.exr", "");
    t.run(&["render", "shot.toml", "--out", "beside"])
        .ok()
        .says(&["3 frames rendered"]);
    assert_eq!(
        picture("beside/frame.-001.exr"),
        picture("out/frame.-001.exr")
    );
    // Where no frame is above, the sign may be a hyphen.
    for frame in 1..=2 {
        t.exr(&format!("sky-{frame:04}.exr"), 8, 4, |x, _, _| x as f32);
    }
    shot(&t, "sky####.exr", "");
    t.run(&["render", "shot.toml", "--out", "sky"]).ok().says(&[
        "warning:",
        "-2 to -1",
        "sky-####.exr",
    ]);
    t.run(&["render", "shot.toml", "--out", "sky", "--strict"])
        .fails(3, &["sky-####.exr", "render.frames = \"-2--1\""]);
    let named = ["--strict", "--set", "render.frames=-2--1"];
    t.run(&[&["render", "shot.toml", "--out", "sky"], &named[..]].concat())
        .ok();
}

#[test]
fn lists_of_frames() {
    let t = Scratch::new("lists");
    t.lights(9);
    shot(&t, "light.####.exr", "[output]\npng = false\n");
    let written = |out: &str, args: &[&str]| {
        t.run(&[&["render", "shot.toml", "--out", out], args].concat())
            .ok();
        let numbers = t
            .list(out)
            .into_iter()
            .filter(|name| name.ends_with(".exr"));
        numbers
            .map(|name| name[6..10].parse().unwrap())
            .collect::<Vec<i32>>()
    };
    assert_eq!(written("step", &["--frames", "1-9x2"]), [1, 3, 5, 7, 9]);
    assert_eq!(written("list", &["--frames", "7-9,1,3"]), [1, 3, 7, 8, 9]);
    assert_eq!(
        written("shot", &["--set", "render.frames=2-8x3"]),
        [2, 5, 8]
    );
    // They are all frames of that shot.
    assert!(t.file("shot/shot.mp4").is_file() && !t.file("step/shot.mp4").exists());
    // A missing frame between them does not matter.
    fs::remove_file(t.file("light.0004.exr")).unwrap();
    assert_eq!(written("gap", &["--frames", "3-5x2"]), [3, 5]);
    let list = |text: &str| t.run(&["render", "shot.toml", "--frames", text]);
    list("3-5").fails(3, &["light.0004.exr", "frame 4 of 3-5"]);
    list("5-3").fails(2, &["--frames", "as 3-5"]);
    list("1-9x0").fails(2, &["--frames", "1-96x2"]);
    t.run(&["render", "shot.toml", "--set", "render.frames=1-"])
        .fails(2, &["render.frames", "1,3,7-9"]);
    t.run(&["render", "shot.toml", "--follow", "--frames", "1-9x2"])
        .fails(2, &["--frames", "--follow", "1-96"]);
    t.run(&["compare", "shot.toml", "--frames", "1,3"])
        .fails(2, &["--frames", "--stride"]);
}

/// Frames that continue from one another are the same whichever of them are written, and count through 0.
#[test]
fn a_chain_goes_through_frames_that_are_not_written() {
    let t = Scratch::new("chain");
    lights(&t, -2..=3);
    let smc = "[render]\nmethod = \"smc\"\n[render.smc]\nparticles = 2\n[output]\npng = false\nvideo = \"\"\n";
    shot(&t, "light.####.exr", smc);
    let render = |out: &str, args: &[&str]| {
        t.run(&[&["render", "shot.toml", "--out", out], args].concat())
            .ok()
    };
    let picture = |out: &str, frame: i32| read_exr(&t.file(&format!("{out}/frame.{frame:04}.exr")));
    render("whole", &[]);
    render("step", &["--frames=-2-2x2"])
        .says(&["note:", "--frames", "2 between", "not written"])
        .says(&["3 frames rendered"]);
    assert_eq!(
        t.list("step"),
        ["frame.-002.exr", "frame.0000.exr", "frame.0002.exr"]
    );
    for frame in [-2, 0, 2] {
        assert_eq!(picture("step", frame), picture("whole", frame), "{frame}");
    }
    // What is there is of the same identity.
    render("step", &[]).says(&["3 frames rendered, 3 there already"]);
    // A state passes from negative numbers on.
    render("parts", &["--frames=-2--1", "--state-out", "s.state"]);
    let second = render("parts", &["--frames", "0-3", "--state-in", "s.state"]);
    assert!(!second.err.contains("the state is of"), "{}", second.err);
    render("preroll", &["--frames", "2", "--preroll", "4"]).says(&["1 frame rendered"]);
    for (out, frame) in [("parts", -1), ("parts", 3), ("preroll", 2)] {
        assert_eq!(
            picture(out, frame),
            picture("whole", frame),
            "{out} {frame}"
        );
    }
    fs::remove_file(t.file("light.-001.exr")).unwrap();
    t.run(&["render", "shot.toml", "--out", "gap", "--frames=-2-2x2"])
        .fails(3, &["frame -1 of -2-2 is missing"]);
}
