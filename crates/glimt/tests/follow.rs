//! Host file: frames rendered while they are filmed: a thread writes them into the folder that the program follows.

mod common;

use common::{Ran, Scratch};
use serde_json::Value;
use std::fs;
use std::process::{Child, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// A run of the program that is under way.
struct Live {
    child: Child,
}

impl Live {
    fn start(t: &Scratch, args: &[&str]) -> Self {
        let mut all = vec!["render", "shot.toml", "--follow"];
        all.extend(args);
        let mut command = t.command(&all);
        command.stdout(Stdio::piped()).stderr(Stdio::piped());
        let child = command.spawn().expect("the program starts");
        Self { child }
    }

    fn end(self) -> Ran {
        let output = self.child.wait_with_output().expect("it ends");
        let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("UTF-8");
        Ran {
            status: output.status.code().unwrap_or(-1),
            out: text(output.stdout),
            err: text(output.stderr),
        }
    }
}

fn pause(milliseconds: u64) {
    sleep(Duration::from_millis(milliseconds));
}

/// Waits until a file is there.
fn until_there(t: &Scratch, name: &str) {
    let began = Instant::now();
    while !t.file(name).exists() {
        assert!(began.elapsed().as_secs() < 20, "{name} does not come");
        pause(10);
    }
}

/// Makes `all/light.nnnn.exr`, and an empty folder for them to appear in.
fn filmed(name: &str, count: u32) -> Scratch {
    let t = Scratch::new(name);
    t.put("all/none", "");
    t.put("live/none", "");
    for frame in 1..=count {
        t.exr(&format!("all/light.{frame:04}.exr"), 8, 4, |x, _, c| {
            frame as f32 + if c == 0 { x as f32 } else { 0.0 }
        });
    }
    shot(&t, "");
    t
}

fn shot(t: &Scratch, more: &str) {
    let more = format!("[output]\nvideo = \"\"\n{more}");
    t.shot("live/light.####.exr", &more);
}

/// A frame appears.
fn appear(t: &Scratch, name: &str) {
    fs::copy(
        t.file(&format!("all/{name}")),
        t.file(&format!("live/.{name}.tmp")),
    )
    .unwrap();
    fs::rename(
        t.file(&format!("live/.{name}.tmp")),
        t.file(&format!("live/{name}")),
    )
    .unwrap();
}

fn light(frame: u32) -> String {
    format!("light.{frame:04}.exr")
}

fn out(frame: u32) -> String {
    format!("out/frame.{frame:04}.exr")
}

/// Numbers of the frames that were rendered.
fn rendered(t: &Scratch) -> Vec<u32> {
    let number = |name: String| {
        name.strip_suffix(".exr")?
            .strip_prefix("frame.")?
            .parse()
            .ok()
    };
    t.list("out").into_iter().filter_map(number).collect()
}

#[test]
fn frames_are_rendered_as_they_come() {
    let t = filmed("follow", 5);
    shot(&t, "codec = \"av1\"\n");
    let args = ["--wait", "8", "--json", "--frames", "1-5"];
    let size = ["--set", "image.size=[32,16]", "--set", "output.video=a.mp4"];
    let live = Live::start(&t, &[&args[..], &size[..]].concat());
    for frame in 1..=5 {
        appear(&t, &light(frame));
        until_there(&t, &out(frame));
    }
    let ran = live.end().ok();
    assert_eq!(rendered(&t), [1, 2, 3, 4, 5]);
    let events: Vec<Value> = ran
        .out
        .lines()
        .map(|line| serde_json::from_str(line).expect("JSON"))
        .collect();
    let frames: Vec<&Value> = events.iter().filter(|e| e["event"] == "frame").collect();
    assert_eq!(frames.len(), 5);
    for frame in frames {
        let lag = frame["lag"].as_f64().unwrap();
        // A frame is not older than the run.
        assert!((0.0..8.0).contains(&lag), "{frame}");
        assert_eq!(frame["dropped"], 0);
    }
    let summary = events.last().unwrap();
    assert_eq!(summary["event"], "summary");
    assert_eq!(summary["rendered"], 5);
    assert_eq!(summary["dropped"], serde_json::json!([]));
    assert!(summary["fps"].as_f64().unwrap() > 0.0);
    assert!(summary["lag_largest"].as_f64() >= summary["lag_median"].as_f64());
    assert!(fs::metadata(t.file("out/a.mp4")).unwrap().len() > 100);

    // The batch knows the same frames by the same identity.
    let batch = ["render", "shot.toml", "--set", "image.size=[32,16]"];
    t.run(&batch)
        .ok()
        .says(&["0 frames rendered, 5 there already"]);
    // And what is there is not rendered again when it is followed.
    Live::start(&t, &["--wait", "0.3", "--set", "image.size=[32,16]"])
        .end()
        .ok()
        .says(&["0 frames rendered, 1 there already, none dropped"]);
}

#[test]
fn the_newest_is_rendered_when_many_come_at_once() {
    let t = filmed("follow-behind", 9);
    // The first keeps the renderer busy while the others come.
    let slow = ["--set", "image.rays_per_pixel=4096"];
    let args = ["--wait", "3", "--frames", "1-9"];
    let live = Live::start(&t, &[&args[..], &slow[..]].concat());
    for frame in 1..=9 {
        appear(&t, &light(frame));
    }
    let ran = live.end().ok();
    let frames = rendered(&t);
    assert!(frames.contains(&9) && frames.len() < 9, "{frames:?}");
    let dropped = 9 - frames.len();
    ran.says(&["later frames are there already"])
        .says(&[&format!("{dropped} dropped (")]);
}

#[test]
fn a_file_is_taken_when_it_is_whole() {
    let t = filmed("follow-halves", 2);
    let live = Live::start(&t, &["--wait", "4", "--max-lag", "3", "--frames", "1-2"]);
    let whole = fs::read(t.file("all/light.0001.exr")).unwrap();
    t.put("live/light.0001.exr", &whole[..whole.len() / 2]);
    // A later one is held up.
    appear(&t, &light(2));
    pause(900);
    assert!(rendered(&t).is_empty());
    t.put("live/light.0001.exr", &whole);
    let ran = live.end().ok();
    assert_eq!(rendered(&t), [1, 2]);
    ran.says(&["2 frames rendered, none dropped"]);
}

#[test]
fn a_broken_file_is_dropped() {
    let t = filmed("follow-broken", 4);
    let live = Live::start(&t, &["--wait", "2", "--frames", "1-4"]);
    appear(&t, &light(1));
    until_there(&t, &out(1));
    let whole = fs::read(t.file("all/light.0002.exr")).unwrap();
    t.put("live/light.0002.exr", &whole[..whole.len() - 9]);
    appear(&t, &light(4));
    let ran = live.end().ok();
    assert_eq!(rendered(&t), [1, 4]);
    ran.says(&["warning: frame 2 is dropped", "light.0002.exr"])
        .says(&["frame 3 is missing"])
        .says(&["2 frames rendered, 1 dropped (2)"]);
    // The same is an error where it is all there is.
    let t = filmed("follow-all-broken", 0);
    t.put("live/light.0001.exr", "no image");
    Live::start(&t, &["--wait", "0.3"])
        .end()
        .fails(3, &["none of the frames that came (1)", "neither OpenEXR"]);
}

#[test]
fn frames_that_do_not_fit_are_dropped() {
    let t = filmed("follow-sizes", 1);
    t.exr("all/light.0002.exr", 16, 8, |_, _, _| 1.0);
    let live = Live::start(&t, &["--wait", "2", "--frames", "1-2"]);
    appear(&t, &light(1));
    until_there(&t, &out(1));
    appear(&t, &light(2));
    live.end()
        .ok()
        .says(&["warning: frame 2 is dropped", "it is 16 × 8"]);
    // Defects that are worked around are none for --strict, which is not an error of a file that is not whole.
    let nan = |_: usize, _: usize, c: usize| if c == 0 { f32::NAN } else { 1.0 };
    t.exr("live/light.0003.exr", 8, 4, nan);
    Live::start(&t, &["--wait", "1", "--strict"])
        .end()
        .fails(3, &["light.0003.exr", "texels are not light", "--strict"]);
}

#[test]
fn no_frame_ever() {
    let t = filmed("follow-none", 1);
    let began = Instant::now();
    Live::start(&t, &["--wait", "0.5"]).end().fails(
        3,
        &["no frame named light.####.exr came in 0.5 s", "--wait"],
    );
    assert!((0.5..5.0).contains(&began.elapsed().as_secs_f64()));
    fs::remove_dir_all(t.file("live")).unwrap();
    Live::start(&t, &["--wait", "0.3"])
        .end()
        .fails(3, &["live", "no such folder"]);
    t.shot("all/light.0001.exr", "");
    Live::start(&t, &["--wait", "0.3"])
        .end()
        .fails(2, &["probe.frames", "nothing to follow"]);
    let ran = t.run(&["render", "shot.toml", "--wait", "3"]);
    assert_eq!(ran.status, 2, "{ran:?}");
}

#[test]
fn what_was_there_before_is_left_out_but_for_the_newest() {
    let t = filmed("follow-newest", 4);
    for frame in [1, 2, 3] {
        appear(&t, &light(frame));
    }
    let live = Live::start(&t, &["--wait", "2"]);
    until_there(&t, &out(3));
    appear(&t, &light(4));
    live.end().ok().says(&["2 frames rendered, none dropped"]);
    assert_eq!(rendered(&t), [3, 4]);
}

#[test]
fn a_backplate_that_comes_late() {
    let t = filmed("follow-plates", 4);
    shot(&t, "[backplate]\nframes = \"live/plate.####.png\"\n");
    let grey = |frame: u32, level: u8| {
        let plate = image::RgbImage::from_pixel(16, 12, image::Rgb([level; 3]));
        plate
            .save(t.file(&format!("all/plate.{frame:04}.png")))
            .unwrap();
        appear(&t, &format!("plate.{frame:04}.png"));
    };
    let corner = |frame: u32| {
        let png = image::open(t.file(&format!("out/frame.{frame:04}.png"))).unwrap();
        png.into_rgb8().get_pixel(0, 0).0
    };
    let args = ["--set", "image.size=[16,12]", "--frames", "1-4"];
    let live = Live::start(&t, &[&["--wait", "2"], &args[..]].concat());
    // No plate in a second, and none before: dropped.
    appear(&t, &light(1));
    pause(1500);
    // A plate that comes in time.
    grey(2, 20);
    appear(&t, &light(2));
    until_there(&t, &out(2));
    appear(&t, &light(3));
    pause(400);
    assert_eq!(rendered(&t), [2]);
    grey(3, 30);
    until_there(&t, &out(3));
    // None comes for the fourth.
    appear(&t, &light(4));
    let ran = live.end().ok();
    assert_eq!(rendered(&t), [2, 3, 4]);
    assert_eq!(
        [corner(2), corner(3), corner(4)],
        [[20; 3], [30; 3], [30; 3]]
    );
    ran.says(&["frame 1 is dropped", "no backplate yet"])
        .says(&[
            "plate.0004.png",
            "did not come in 1 s",
            "frame 4 is laid over backplate 3",
        ]);
    // The image has the first plate's size where none is given: without a plate there is nothing to begin with.
    t.put(
        "shot.toml",
        "[probe]\nframes = \"live/light.####.exr\"\n[[object]]\nmesh = \"sphere\"\n\
         [backplate]\nframes = \"none/plate.####.png\"\n",
    );
    Live::start(&t, &["--wait", "0.3"])
        .end()
        .fails(3, &["no backplate named plate.####.png came", "image.size"]);
}

#[test]
fn a_mirror_ball_that_is_lost() {
    let t = filmed("follow-ball", 0);
    t.exr("sky.exr", 64, 32, |x, y, c| {
        0.2 + 0.02 * (x + c) as f32 + 0.3 * ((x / 8 + y / 4) % 2) as f32
    });
    let size = [
        "--set",
        "capture.size=[200,150]",
        "--set",
        "capture.pixel_um=60",
    ];
    let film = [
        "synth", "sky.exr", "--out", "film", "--frames", "1-4", "--device", "cpu",
    ];
    let still = [
        "--set",
        "capture.jitter_px=0.5",
        "--set",
        "truth.size=[16,8]",
    ];
    t.run(&[&film[..], &size[..], &still[..]].concat()).ok();
    for frame in 1..=4 {
        let from = t.file(&format!("film/capture/ball.{frame:04}.exr"));
        fs::rename(from, t.file(&format!("all/{}", light(frame)))).unwrap();
    }
    t.exr("all/light.0003.exr", 200, 150, |_, _, _| 0.5);
    let live = Live::start(
        &t,
        &[
            "--wait",
            "4",
            "--frames",
            "1-4",
            "--set",
            "probe.mapping=mirror-ball",
            "--set",
            "image.background=transparent",
        ],
    );
    for frame in 1..=4 {
        appear(&t, &light(frame));
        until_there(&t, &out(frame));
    }
    let ran = live.end().ok();
    ran.says(&["warning:", "light.0003.exr", "the ball is lost", "held"])
        .says(&["4 frames rendered, none dropped"]);
    let image = |frame| common::read_exr(&t.file(&out(frame)));
    let mean = |frame| {
        let channels = image(frame);
        let all: Vec<f32> = channels[1..].concat();
        all.iter().sum::<f32>() / all.len() as f32
    };
    assert!(mean(1) > 0.01);
    assert!(
        (mean(2) / mean(1) - 1.0).abs() < 0.2,
        "{} {}",
        mean(1),
        mean(2)
    );

    // A ball that has not been seen yet has no place to hold.
    let t = filmed("follow-no-ball", 0);
    t.exr("live/light.0001.exr", 200, 150, |_, _, _| 0.5);
    Live::start(&t, &["--wait", "0.5", "--set", "probe.mapping=mirror-ball"])
        .end()
        .fails(3, &["none of the frames that came (1)"]);
}
