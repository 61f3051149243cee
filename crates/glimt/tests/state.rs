//! Host file: frames that continue from one another, in one run and in several: of the sequential sampler and of light cells.

mod common;

use common::{Scratch, read_exr};

const SMC: &str = "method = \"smc\"\nsmc = { max_age = 6, max_change = 0.9 }\n";
const CELLS: &str = "method = \"cells\"\ncells.rays = 8\n";

/// A lamp that goes around a glossy ball on a ground.
fn shot(t: &Scratch, method: &str) {
    for frame in 1..=12u16 {
        let azimuth = 10.0 + f32::from(frame);
        t.exr(&format!("light.{frame:04}.exr"), 32, 16, |x, y, _| {
            let (dx, dy) = (x as f32 - azimuth, y as f32 - 5.0);
            0.3 + 6.0 * (-0.15 * (dx * dx + dy * dy)).exp()
        });
    }
    let aovs = match method == SMC {
        true => "\"ess\", \"age\", \"z-ratio\", \"started\", \"z-spread\"",
        false => "",
    };
    let text = format!(
        "[image]\nsize = [40, 24]\nrays_per_pixel = 2\n\
         [probe]\nframes = \"light.####.exr\"\n\
         [[object]]\nmesh = \"sphere\"\nground = true\n\
         material = {{ diffuse = [0.3, 0.3, 0.3], specular = [0.5, 0.5, 0.5], exponent = 40 }}\n\
         [[object]]\nmesh = \"plane\"\nscale = 3\n\
         [render]\n{method}\
         [output]\npng = false\nvideo = \"\"\naovs = [{aovs}]\n"
    );
    t.put("shot.toml", &text);
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
fn a_saved_state_continues_bit_for_bit_and_is_known_again() {
    for (name, method) in [("smc", SMC), ("cells", CELLS)] {
        let t = Scratch::new(&format!("state-{name}"));
        shot(&t, method);
        a_saved_state_continues(&t);
    }
}

fn a_saved_state_continues(t: &Scratch) {
    render(t, "whole", &["--frames", "1-8"]);
    render(
        t,
        "parts",
        &["--frames", "1-3", "--state-out", "three.state"],
    );
    render(
        t,
        "parts",
        &["--frames", "4-8", "--state-in", "three.state"],
    );
    for frame in 1..=8 {
        assert!(same(t, "whole", "parts", frame), "frame {frame}");
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
    assert!(same(t, "whole", "parts", 6));
    // Another start is another frame.
    render(t, "other", &["--frames", "5-8"]);
    assert!(!same(t, "whole", "other", 6));
}

/// A run that ends early continues from the state that it saved on its way.
#[test]
fn a_run_that_was_stopped_continues_from_its_own_state() {
    for (name, method) in [("smc", SMC), ("cells", CELLS)] {
        let t = Scratch::new(&format!("stopped-{name}"));
        shot(&t, method);
        for frame in 13..=40 {
            let light = format!("light.{:04}.exr", (frame - 1) % 12 + 1);
            std::fs::copy(t.file(&light), t.file(&format!("light.{frame:04}.exr")))
                .expect("a light");
        }
        render(&t, "whole", &["--frames", "1-40"]);
        let broken = t.file("light.0036.exr");
        let good = std::fs::read(&broken).expect("a light");
        std::fs::write(&broken, &good[..good.len() / 2]).expect("a light");
        let run = ["render", "shot.toml", "--device", "cpu", "--out", "out"];
        t.run(&[&run[..], &["--frames", "1-40"]].concat())
            .fails(3, &["light.0036.exr"]);
        let state = t.file("out/.glimt.state");
        let saved = std::fs::read(&state).expect("a state");
        std::fs::write(&broken, &good).expect("a light");
        // Of other settings, and of a light that has changed since, it is not taken.
        t.run(&[&run[..], &["--frames", "1-3", "--seed", "9"]].concat())
            .ok()
            .says(&["3 frames rendered"]);
        assert!(!state.exists());
        std::fs::write(&state, &saved).expect("a state");
        for frame in 1..=3 {
            let file = format!("frame.{frame:04}.exr");
            std::fs::copy(
                t.file(&format!("whole/{file}")),
                t.file(&format!("out/{file}")),
            )
            .expect("a frame");
        }
        t.run(&[&run[..], &["--frames", "1-40"]].concat())
            .ok()
            .says(&["continues from the state", "after frame 32"])
            .says(&["5 frames rendered"]);
        for frame in 1..=40 {
            assert!(same(&t, "whole", "out", frame), "{name}, frame {frame}");
        }
        assert!(!state.exists());
        // A damaged state counts as missing.
        std::fs::remove_file(t.file("out/frame.0034.exr")).expect("a frame");
        std::fs::write(&state, &saved[..saved.len() / 2]).expect("a state");
        t.run(&[&run[..], &["--frames", "1-40"]].concat())
            .ok()
            .says(&["1 frame rendered"]);
        assert!(same(&t, "whole", "out", 34));
    }
}

#[test]
fn layers_say_how_cells_fare() {
    let t = Scratch::new("cells-layers");
    shot(&t, CELLS);
    let layers = ["--set", "output.aovs=[\"rays\",\"visibility-error\"]"];
    render(&t, "out", &[&["--frames", "1"][..], &layers].concat());
    let image = exr::prelude::read_first_flat_layer_from_file(t.file("out/frame.0001.exr"));
    let image = image.expect("an EXR");
    let names: Vec<String> = (image.layer_data.channel_data.list.iter())
        .map(|channel| channel.name.to_string())
        .collect();
    let own = ["cells.rays", "cells.visibility_error"];
    assert_eq!(names, [&["A", "B", "G", "R"], &own[..]].concat());
    let channels = read_exr(&t.file("out/frame.0001.exr"));
    let mean = channels[4].iter().sum::<f32>() / channels[4].len() as f32;
    assert!(mean > 4.0 && mean < 16.0, "{mean} rays");
    // They are of no other method.
    let flags = ["render", "shot.toml", "--method", "mis", "--out", "mis"];
    t.run(&[&flags[..], &layers].concat())
        .fails(2, &["output.aovs", "rays"]);
}

#[test]
fn the_seam_of_a_preroll_closes() {
    let t = Scratch::new("preroll");
    shot(&t, SMC);
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
    shot(&t, SMC);
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
        &["--state-in", "--method cells"],
    );
    refused(
        &["--frames", "3-4", "--state-in", "none.state"],
        3,
        &["none.state"],
    );
    refused(
        &[
            &state[..],
            &["--method", "cells", "--set", "output.aovs=[]"],
        ]
        .concat(),
        3,
        &["two.state", "another shot"],
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
    shot(&t, SMC);
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
