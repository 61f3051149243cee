//! Host file: what counts as rendered, and what is said and refused when a shot is rendered again.

mod common;

use common::Scratch;
use std::fs;

/// Frames and videos that lost their end are made again.
#[test]
fn truncated_outputs_are_made_again() {
    let t = Scratch::new("cut");
    t.lights(2);
    t.shot("light.####.exr", "[output]\ncodec = \"av1\"\n");
    let render = || {
        t.run(&["render", "shot.toml", "--set", "image.size=[40,30]"])
            .ok()
    };
    render();
    render().says(&["0 frames rendered, 2 there already"]);
    for name in ["frame.0001.exr", "frame.0002.png"] {
        let file = t.file("out").join(name);
        let whole = fs::read(&file).unwrap();
        for cut in [1, 12, whole.len() / 3] {
            fs::write(&file, &whole[..whole.len() - cut]).unwrap();
            render().says(&["1 frame rendered, 1 there already"]);
            // The attributes of an EXR come in any order.
            assert_eq!(fs::read(&file).unwrap().len(), whole.len(), "{name}");
        }
    }
    let video = t.file("out/shot.mp4");
    let whole = fs::read(&video).unwrap();
    fs::write(&video, &whole[..whole.len() - 1]).unwrap();
    render().says(&["0 frames rendered, 2 there already", "shot.mp4"]);
    assert_eq!(fs::read(&video).unwrap().len(), whole.len());
}

/// Frames that were rendered with defects worked around are none for `--strict`.
#[test]
fn strict_looks_at_frames_that_are_there() {
    let t = Scratch::new("strict");
    t.lights(2);
    t.exr(
        "light.0003.exr",
        8,
        4,
        |x, _, _| if x == 3 { -1.0 } else { 1.0 },
    );
    t.shot("light.####.exr", "[output]\nvideo = \"\"\n");
    let strict = || t.run(&["render", "shot.toml", "--strict"]);
    let words = ["light.0003.exr", "4 of 32 texels are not light", "--strict"];
    t.run(&["render", "shot.toml"]).ok();
    strict().fails(3, &words);
    strict().fails(3, &words);
    t.run(&["render", "shot.toml", "--strict", "--frames", "1-2"])
        .ok()
        .says(&["0 frames rendered, 2 there already"]);
    t.shot(
        "light.0003.exr",
        "[render]\nframes = \"1-3\"\n[output]\nvideo = \"\"\n",
    );
    t.run(&["render", "shot.toml"]).ok();
    strict().fails(3, &words);
}

/// A still is read once, and what there is to say about it is said once.
#[test]
fn a_still_is_read_once() {
    let t = Scratch::new("still");
    t.exr("light.exr", 8, 4, |x, _, _| if x == 3 { -1.0 } else { 1.0 });
    t.shot(
        "light.exr",
        "[render]\nframes = \"1-5\"\n[output]\nvideo = \"\"\n",
    );
    let ran = t.run(&["render", "shot.toml", "-v"]).ok();
    let times = |text: &str| ran.err.lines().filter(|line| line.contains(text)).count();
    assert_eq!(times("texels are not light"), 1, "{}", ran.err);
    assert_eq!(times("light of frame"), 1, "{}", ran.err);
    ran.says(&["5 frames rendered"]);
}
