//! Host file: shots of precomputed transfer, from the bake to the frame.

mod common;

use common::{Scratch, read_exr};

const STAGE: &str = "[render]\nmethod = \"prt\"\n\
     [render.prt]\ndirections = 200\nbands = 4\n\
     [output]\nvideo = \"\"\n\
     [[object]]\nmesh = \"plane\"\nscale = 3.0\ntranslate = [0.0, 0.0, -1.0]\nsubdivide = 4\n";

/// Frame 1 as linear values, channel by channel.
fn pixels(t: &Scratch, out: &str, frame: u32) -> Vec<Vec<f32>> {
    read_exr(&t.file(&format!("{out}/frame.{frame:04}.exr")))
}

fn sum(channels: &[Vec<f32>]) -> f32 {
    channels.iter().flatten().sum()
}

#[test]
fn a_bake_lights_frames() {
    let t = Scratch::new("prt");
    t.lights(3);
    t.shot("light.####.exr", STAGE);
    t.run(&["render", "shot.toml"])
        .fails(3, &["shot.prt.glb", "glimt bake"]);
    t.run(&["bake", "shot.toml"]).ok();
    t.run(&["render", "shot.toml"]).ok();
    assert!(sum(&pixels(&t, "out", 1)) > 0.0);
    // The same transfer serves all of these.
    let render = |out: &str, sets: &[&str]| {
        let sets = sets.iter().flat_map(|set| ["--set", *set]);
        let args = ["render", "shot.toml", "--frames", "1", "--out", out];
        t.run(&args.into_iter().chain(sets).collect::<Vec<_>>())
            .ok();
        sum(&pixels(&t, out, 1))
    };
    let with = render("with", &[]);
    assert_eq!(pixels(&t, "with", 1), pixels(&t, "out", 1));
    assert!(render("without", &["render.prt.shadows=false"]) > with);
    assert_ne!(render("mirror", &["object.0.reflection=0.5"]), with);
    assert_ne!(
        render("halved", &["render.prt.level=1", "render.prt.window=0"]),
        with
    );
    // Nothing is rendered twice; another bake is another light.
    t.run(&["render", "shot.toml"])
        .ok()
        .says(&["0 frames rendered, 3 there already"]);
    t.run(&["bake", "shot.toml", "--directions", "50"]).ok();
    t.run(&["render", "shot.toml"])
        .ok()
        .says(&["3 frames rendered"]);
    t.run(&["render", "shot.toml"])
        .ok()
        .says(&["0 frames rendered, 3 there already"]);
}

#[test]
fn light_goes_on_from_frame_to_frame() {
    let t = Scratch::new("prt-temporal");
    t.lights(4);
    t.shot("light.####.exr", STAGE);
    t.run(&["bake", "shot.toml"]).ok();
    let filter = ["--set", "render.prt.temporal=2"];
    let render = |args: &[&str]| t.run(&[&["render", "shot.toml"], &filter[..], args].concat());
    render(&["--out", "all"]).ok();
    render(&["--out", "part", "--frames", "4", "--preroll", "3"]).ok();
    assert_eq!(pixels(&t, "all", 4), pixels(&t, "part", 4));
    render(&["--out", "alone", "--frames", "4"]).ok();
    assert!(sum(&pixels(&t, "alone", 4)) > sum(&pixels(&t, "all", 4)));
    // A lost frame comes back as it was.
    let lost = pixels(&t, "all", 3);
    std::fs::remove_file(t.file("all/frame.0003.exr")).unwrap();
    render(&["--out", "all"]).ok();
    assert_eq!(pixels(&t, "all", 3), lost);
    render(&["--state-out", "state"]).fails(2, &["--state-out", "--preroll"]);
    t.run(&["render", "shot.toml", "--preroll", "2"])
        .fails(2, &["--preroll", "stands alone"]);
}

#[test]
fn values_out_of_range_are_refused() {
    let t = Scratch::new("prt-range");
    t.lights(1);
    t.shot("light.0001.exr", STAGE);
    for (set, words) in [
        ("render.prt.bands=0", ["render.prt.bands", "1 and 6"]),
        ("render.prt.bands=7", ["render.prt.bands", "1 and 6"]),
        ("render.prt.directions=0", ["render.prt.directions", "2500"]),
        ("render.prt.level=16", ["render.prt.level", "15"]),
        ("render.prt.window=-1", ["render.prt.window", "no window"]),
        (
            "render.prt.temporal=-0.5",
            ["render.prt.temporal", "between 0"],
        ),
        (
            "object.0.reflection=1.5",
            ["object.0.reflection", "between 0 and 1"],
        ),
        ("object.1.subdivide=11", ["object.1.subdivide", "10"]),
        ("render.prt.bandz=4", ["bandz", "bands"]),
    ] {
        t.run(&["render", "shot.toml", "--set", set])
            .fails(2, &words);
    }
    t.run(&[
        "render",
        "shot.toml",
        "--set",
        "object.1.catcher=true",
        "--set",
        "object.1.reflection=0.5",
    ])
    .fails(2, &["object.1.reflection", "catcher"]);
    let spin = "[[object.spin]]\nnode = \"plane\"\ndeg_per_frame = 1.0\n";
    t.shot("light.0001.exr", &format!("{STAGE}{spin}"));
    for command in ["render", "bake"] {
        t.run(&[command, "shot.toml"])
            .fails(2, &["object.1", "moves"]);
    }
}
