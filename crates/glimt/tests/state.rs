//! Host file: frames of the sequential sampler in one run and in several.

mod common;

use common::{Scratch, read_exr};

/// A lamp that goes around a glossy ball on a ground.
fn shot(t: &Scratch) {
    for frame in 1..=12u16 {
        let azimuth = 10.0 + f32::from(frame);
        t.exr(&format!("light.{frame:04}.exr"), 32, 16, |x, y, _| {
            let (dx, dy) = (x as f32 - azimuth, y as f32 - 5.0);
            0.3 + 6.0 * (-0.15 * (dx * dx + dy * dy)).exp()
        });
    }
    t.put(
        "shot.toml",
        "[image]\nsize = [40, 24]\nrays_per_pixel = 2\n\
         [probe]\nframes = \"light.####.exr\"\n\
         [[object]]\nmesh = \"sphere\"\nground = true\n\
         material = { diffuse = [0.3, 0.3, 0.3], specular = [0.5, 0.5, 0.5], exponent = 40 }\n\
         [[object]]\nmesh = \"plane\"\nscale = 3\n\
         [render]\nmethod = \"smc\"\nsmc = { max_age = 6, max_change = 0.9 }\n\
         [output]\npng = false\nvideo = \"\"\naovs = [\"ess\", \"age\", \"z-ratio\", \"started\", \"z-spread\"]\n",
    );
}

fn render(t: &Scratch, out: &str, flags: &[&str]) {
    let all = [
        &["render", "shot.toml", "--device", "cpu", "--out", out],
        flags,
    ]
    .concat();
    t.run(&all).ok();
}

fn same(t: &Scratch, a: &str, b: &str, frame: u32) -> bool {
    let file = |folder: &str| {
        std::fs::read(t.file(&format!("{folder}/frame.{frame:04}.exr"))).expect("a frame")
    };
    file(a) == file(b)
}

#[test]
fn a_saved_state_goes_on_bit_for_bit_and_is_known_again() {
    let t = Scratch::new("state");
    shot(&t);
    render(&t, "whole", &["--frames", "1-8"]);
    render(
        &t,
        "parts",
        &["--frames", "1-3", "--state-out", "three.state"],
    );
    render(
        &t,
        "parts",
        &["--frames", "4-8", "--state-in", "three.state"],
    );
    for frame in 1..=8 {
        assert!(same(&t, "whole", "parts", frame), "frame {frame}");
    }
    // All of it is there, whichever way it came about; and a state that is there is not made again.
    t.run(&["render", "shot.toml", "--frames", "1-8", "--out", "parts"])
        .ok()
        .says(&["0 frames rendered", "8 there already"]);
    t.run(&[
        "render",
        "shot.toml",
        "--frames",
        "1-3",
        "--out",
        "parts",
        "--state-out",
        "three.state",
    ])
    .ok()
    .says(&["0 frames rendered"]);
    // A frame that is lost comes back as it was, led up to by those before it.
    std::fs::remove_file(t.file("whole/frame.0006.exr")).expect("a frame");
    t.run(&[
        "render",
        "shot.toml",
        "--device",
        "cpu",
        "--frames",
        "1-8",
        "--out",
        "whole",
    ])
    .ok()
    .says(&["1 frame rendered", "7 there already"]);
    assert!(same(&t, "whole", "parts", 6));
    // Another start is another frame.
    render(&t, "other", &["--frames", "5-8"]);
    assert!(!same(&t, "whole", "other", 6));
}

#[test]
fn the_seam_of_a_preroll_closes() {
    let t = Scratch::new("preroll");
    shot(&t);
    render(&t, "whole", &["--frames", "1-12"]);
    // The diagnostics come first in the alphabet; the image's green is all that is looked at.
    let green = |folder: &str| {
        let file = t.file(&format!("{folder}/frame.0012.exr"));
        read_exr(&file)[2].clone()
    };
    let whole = green("whole");
    let mut seams = Vec::new();
    for preroll in [0, 2, 4, 8, 11] {
        let (out, w) = (format!("w{preroll}"), preroll.to_string());
        render(&t, &out, &["--frames", "12-12", "--preroll", &w]);
        assert_eq!(t.list(&out), ["frame.0012.exr"]);
        let pairs = green(&out).into_iter().zip(&whole);
        let squares: f32 = pairs.map(|(a, b)| (a - b) * (a - b)).sum();
        let all: f32 = whole.iter().map(|b| b * b).sum();
        seams.push((preroll, (squares / all).sqrt()));
    }
    println!("relative difference from the frame of the whole run, by preroll: {seams:?}");
    let at = |i: usize| seams[i].1;
    assert!(
        at(0) > 0.01 && at(2) > 0.0 && at(2) < 0.8 * at(0),
        "{seams:?}"
    );
    // Six frames are enough for each ray to have had its turn.
    assert!(at(3) == 0.0 && at(4) == 0.0, "{seams:?}");
}

#[test]
fn states_that_do_not_fit_are_refused() {
    let t = Scratch::new("state-bad");
    shot(&t);
    render(&t, "out", &["--frames", "1-2", "--state-out", "two.state"]);
    let refused = |flags: &[&str], status: i32, words: &[&str]| {
        let all = [&["render", "shot.toml", "--out", "other"], flags].concat();
        t.run(&all).fails(status, words);
    };
    let state = ["--frames", "3-4", "--state-in", "two.state"];
    refused(
        &[&state[..], &["--seed", "5"]].concat(),
        3,
        &["two.state", "another shot", "--state-out"],
    );
    refused(
        &[&state[..], &["--method", "bis", "--set", "output.aovs=[]"]].concat(),
        2,
        &["--state-in", "smc"],
    );
    refused(
        &["--frames", "3-4", "--state-in", "none.state"],
        3,
        &["none.state"],
    );
    let bytes = std::fs::read(t.file("two.state")).expect("a state");
    t.put("cut.state", &bytes[..bytes.len() / 2]);
    refused(
        &["--frames", "3-4", "--state-in", "cut.state"],
        3,
        &["cut.state", "damaged"],
    );
    t.put("text.state", "frame 2");
    refused(
        &["--frames", "3-4", "--state-in", "text.state"],
        3,
        &["text.state", "not a state"],
    );
    let flags = ["--preroll", "2", "--state-in", "two.state"];
    t.run(&[&["render", "shot.toml"], &flags[..]].concat())
        .fails(2, &["--preroll"]);
}

#[test]
fn frames_that_stand_alone_are_the_same_in_parts() {
    let t = Scratch::new("parts");
    shot(&t);
    for method in ["mis", "bis"] {
        let flags = ["--method", method, "--set", "output.aovs=[]"];
        let (whole, parts) = (format!("{method}-whole"), format!("{method}-parts"));
        render(&t, &whole, &[&flags[..], &["--frames", "1-4"]].concat());
        render(&t, &parts, &[&flags[..], &["--frames", "3-4"]].concat());
        render(&t, &parts, &[&flags[..], &["--frames", "1-2"]].concat());
        for frame in 1..=4 {
            assert!(same(&t, &whole, &parts, frame), "{method}, frame {frame}");
        }
    }
}
