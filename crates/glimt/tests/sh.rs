//! Host file: `glimt sh`: coefficients of lights, as numbers in files.

mod common;

use common::Scratch;
use serde_json::Value;
use std::f64::consts::PI;
use std::fs;

/// The lines of a CSV behind its head: frame, l, m, and three colours.
fn rows(text: &str) -> Vec<([i64; 3], [f64; 3])> {
    let lines = text.lines().filter(|line| !line.starts_with('#'));
    let rows = lines.skip(1).map(|line| {
        let cells: Vec<f64> = line.split(',').map(|cell| cell.parse().unwrap()).collect();
        (
            [cells[0] as i64, cells[1] as i64, cells[2] as i64],
            [cells[3], cells[4], cells[5]],
        )
    });
    rows.collect()
}

fn parsed(text: &str) -> Value {
    serde_json::from_str(text).expect("JSON")
}

fn list(value: &Value) -> Vec<[f64; 3]> {
    serde_json::from_value(value.clone()).expect("a list of colours")
}

/// A map that is red in direction +x, green in +y, blue in +z, all as cosines.
fn lobes(t: &Scratch, name: &str, brightness: f32) {
    let (w, h) = (64, 32);
    t.exr(name, w, h, |x, y, c| {
        let theta = std::f32::consts::PI * (y as f32 + 0.5) / h as f32;
        let phi = std::f32::consts::PI * (1.0 - 2.0 * (x as f32 + 0.5) / w as f32);
        let d = [
            theta.sin() * phi.cos(),
            theta.sin() * phi.sin(),
            theta.cos(),
        ];
        brightness * (1.0 + d[c])
    });
}

#[test]
fn a_map_of_first_order_light() {
    let t = Scratch::new("sh-map");
    lobes(&t, "light.exr", 1.0);
    let out = t.run(&["sh", "light.exr", "--bands", "2"]).ok().out;
    assert!(out.contains("without the Condon-Shortley sign"), "{out}");
    let rows = rows(&out);
    let order: Vec<[i64; 3]> = rows.iter().map(|row| row.0).collect();
    assert_eq!(order, [[1, 0, 0], [1, 1, -1], [1, 1, 0], [1, 1, 1]]);
    let (mean, slope) = ((4.0 * PI).sqrt(), (4.0 * PI / 3.0).sqrt());
    let exact = [
        [mean; 3],
        [0.0, slope, 0.0],
        [0.0, 0.0, slope],
        [slope, 0.0, 0.0],
    ];
    for (row, exact) in rows.iter().zip(exact) {
        for (found, exact) in row.1.iter().zip(exact) {
            assert!((found - exact).abs() < 2e-3, "{row:?} {exact:?}");
        }
    }
}

#[test]
fn conventions_and_up() {
    let t = Scratch::new("sh-conventions");
    lobes(&t, "light.exr", 1.0);
    let run = |more: &[&str]| {
        let args = [
            &["sh", "light.exr", "--format", "json", "--bands", "3"],
            more,
        ]
        .concat();
        let value = parsed(&t.run(&args).ok().out);
        list(&value["frames"][0]["coefficients"])
    };
    let ours = run(&[]);
    for convention in ["condon-shortley", "directx"] {
        let theirs = run(&["--convention", convention]);
        let signs: Vec<f64> = (0..4)
            .map(|k| (theirs[k][0] + theirs[k][1] + theirs[k][2]) / (ours[k].iter().sum::<f64>()))
            .collect();
        assert_eq!(signs, [1.0, -1.0, 1.0, -1.0], "{convention}");
    }
    // Blue was above; with y up it is along y.
    let up = run(&["--up", "y"]);
    assert!(
        (up[1][2] - ours[2][2]).abs() < 1e-5 && up[2][2].abs() < 1e-3,
        "{up:?}"
    );
    // What was along y, green, is now along −z.
    assert!((up[2][1] + ours[1][1]).abs() < 1e-5, "{up:?}");
    let args = [
        "sh",
        "light.exr",
        "--format",
        "json",
        "--convention",
        "filament",
    ];
    let five = parsed(&t.run(&args).ok().out);
    assert_eq!(five["bands"], 3);
    for flags in [["--format", "engine"], ["--convention", "filament"]] {
        let args = [&["sh", "light.exr", "--bands", "2"], &flags[..]].concat();
        t.run(&args).fails(2, &["nine coefficients", "--bands"]);
    }
    let engine = run(&["--convention", "filament"]);
    assert_eq!(engine.len(), 9);
    let exact = ours[3][0] * 0.325_735;
    assert!((engine[3][0] - exact).abs() < 1e-5);
    let filtered = run(&["--window", "3"]);
    assert!((filtered[1][1] / ours[1][1] - 0.75).abs() < 1e-5);
}

/// The nine coefficients against irradiance that is known: of `1 + d` it is `π + 2π/3 n`.
#[test]
fn what_engines_take() {
    let t = Scratch::new("sh-engine");
    lobes(&t, "light.exr", 2.0);
    t.run(&["sh", "light.exr", "--format", "engine", "-o", "light.json"])
        .ok();
    let value = parsed(&fs::read_to_string(t.file("light.json")).unwrap());
    assert_eq!(value["order"][6], "3zz-1");
    assert!(value["meaning"].as_str().unwrap().contains("albedo"));
    let e = list(&value["frames"][0]["sh"]);
    let [x, y, z] = [0.48, -0.6, 0.64];
    let polynomials = [
        1.0,
        y,
        z,
        x,
        x * y,
        y * z,
        3.0 * z * z - 1.0,
        z * x,
        x * x - y * y,
    ];
    for (c, n) in [x, y, z].into_iter().enumerate() {
        let found: f64 = e.iter().zip(polynomials).map(|(e, p)| e[c] * p).sum();
        assert!(
            (found - 2.0 * (1.0 + 2.0 / 3.0 * n)).abs() < 3e-3,
            "{c}: {found}"
        );
    }
    assert_eq!(
        t.list(".")
            .iter()
            .filter(|name| name.ends_with(".part"))
            .count(),
        0
    );
}

/// Turned as the help says, the light lies as Filament's cmgen lays the same map: column `atan2(x, z)`, row `asin y`, and the
/// whole mirrored in x. What is written says where the map's centre and left are.
#[test]
fn light_lies_as_engines_lay_it() {
    let t = Scratch::new("sh-axes");
    lobes(&t, "light.exr", 1.0);
    let run = |more: &[&str]| {
        let args = [&["sh", "light.exr", "--format", "engine"], more].concat();
        parsed(&t.run(&args).ok().out)
    };
    let (n, s) = ([0.48, -0.6, 0.64f64], [0.28, 0.0, -0.96]);
    let far = |value: &Value| {
        let e = list(&value["frames"][0]["sh"]);
        let error = |[x, y, z]: [f64; 3]| {
            let phi = -(-x).atan2(z);
            let d = [phi.cos(), phi.sin()].map(|c| (1.0 - y * y).sqrt() * c);
            let exact = [d[0], d[1], y].map(|d| 1.0 + 2.0 / 3.0 * d);
            let found = |c: usize| e[0][c] + e[1][c] * y + e[2][c] * z + e[3][c] * x;
            (0..3).fold(0.0, |sum, c| sum + (found(c) - exact[c]).abs())
        };
        error(n) + error(s)
    };
    let meaning = |value: &Value| value["meaning"].as_str().unwrap().to_owned();
    let turned = run(&["--up", "y", "--rotate-z-deg", "-90"]);
    assert!(far(&turned) < 1e-2, "{}", far(&turned));
    let said = "centre lies along (0, 0, 1), its left along (1, 0, 0), its top along (0, 1, 0)";
    assert!(meaning(&turned).contains(said), "{}", meaning(&turned));
    let plain = run(&["--up", "y"]);
    assert!(!(far(&plain) < 0.5), "another turn passes");
    let said = "right-handed axes, in which a light map's centre lies along (1, 0, 0), its left along (0, 0, -1)";
    assert!(meaning(&plain).contains(said), "{}", meaning(&plain));
    let csv = [
        "sh",
        "light.exr",
        "--convention",
        "directx",
        "--rotate-z-deg=60",
    ];
    let csv = t.run(&csv).ok().out;
    let said = "right-handed axes, in which a light map's centre lies along (0.5, 0.866, 0)";
    assert!(csv.contains(said), "{csv}");
    t.run(&["sh", "light.exr", "--rotate-z-deg", "inf"])
        .fails(2, &["-90"]);
}

#[test]
fn a_sequence_is_filtered_over_time() {
    let t = Scratch::new("sh-sequence");
    lobes(&t, "light.0001.exr", 1.0);
    lobes(&t, "light.0002.exr", 3.0);
    lobes(&t, "light.0003.exr", 3.0);
    let out = t
        .run(&["sh", "light.####.exr", "--bands", "1", "--temporal", "1"])
        .ok()
        .out;
    let values: Vec<f64> = rows(&out)
        .iter()
        .map(|row| row.1[0] / (4.0 * PI).sqrt())
        .collect();
    for (found, exact) in values.iter().zip([1.0, 2.0, 2.5]) {
        assert!((found - exact).abs() < 1e-5, "{values:?}");
    }
    let out = t
        .run(&["sh", "light.####.exr", "--bands", "1", "--frames", "2-3"])
        .ok()
        .out;
    assert_eq!(
        rows(&out).iter().map(|row| row.0[0]).collect::<Vec<_>>(),
        [2, 3]
    );
    let out = t
        .run(&["sh", "light.0003.exr", "light.0001.exr", "--bands", "1"])
        .ok()
        .out;
    let values: Vec<f64> = rows(&out).iter().map(|row| row.1[0]).collect();
    assert!((values[0] / values[1] - 3.0).abs() < 1e-5, "{values:?}");
    // Which is which.
    assert!(
        out.contains("\n# frame 1: light.0003.exr\n# frame 2: light.0001.exr\n"),
        "{out}"
    );
    let sequence = t.run(&["sh", "light.####.exr"]).ok().out;
    assert!(!sequence.contains("# frame"), "{sequence}");

    fs::remove_file(t.file("light.0002.exr")).unwrap();
    t.run(&["sh", "light.####.exr"])
        .ok()
        .says(&["frame 2 is missing"]);
    t.run(&["sh", "light.####.exr", "--frames", "1-3"])
        .fails(3, &["light.0002.exr", "frame 2 of 1-3 is missing"]);
}

/// The shot's keys say how its light is scaled and turned.
#[test]
fn the_light_of_a_shot() {
    let t = Scratch::new("sh-shot");
    lobes(&t, "light.exr", 1.0);
    t.shot("light.exr", "");
    let shot = fs::read_to_string(t.file("shot.toml")).unwrap();
    let turned = shot.replace("[probe]\n", "[probe]\nscale = 2.0\nrotate_z_deg = 90.0\n");
    t.put("shot.toml", turned);
    let own = rows(&t.run(&["sh", "light.exr", "--bands", "2"]).ok().out);
    let of_shot = rows(&t.run(&["sh", "shot.toml", "--bands", "2"]).ok().out);
    // Red, along x, is turned to y.
    assert!(
        (of_shot[1].1[0] - 2.0 * own[3].1[0]).abs() < 1e-4,
        "{of_shot:?}"
    );
    assert!(of_shot[3].1[0].abs() < 1e-3);
    // The flag turns further: here back.
    let back = ["sh", "shot.toml", "--bands", "2", "--rotate-z-deg", "-90"];
    let back = rows(&t.run(&back).ok().out);
    for ((_, back), (_, own)) in back.iter().zip(&own) {
        for (back, own) in back.iter().zip(own) {
            assert!((back - 2.0 * own).abs() < 1e-4, "{back} {own}");
        }
    }
    // Its colours, as they light objects: red twice as bright; and matched to a backplate's, by the mean of two patches.
    t.exr("plate.exr", 2, 2, |_, _, c| [8.0, 2.0, 1.0][c]);
    let shot = "[probe]\nframes = \"light.exr\"\n[[object]]\nmesh = \"sphere\"\n[probe.colour]\n";
    t.put("gains.toml", format!("{shot}gains = [2, 1, 1]\n"));
    let patch = "{ probe = [0, 0, 64, 32], plate = [0, 0, 2, 2] }";
    let plate = "[backplate]\nframes = \"plate.exr\"\n";
    t.put("match.toml", format!("{shot}patches = [{patch}]\n{plate}"));
    let mean = |name: &str| rows(&t.run(&["sh", name, "--bands", "1"]).ok().out)[0].1;
    let (plain, gains, matched) = (mean("light.exr"), mean("gains.toml"), mean("match.toml"));
    assert!(
        (gains[0] / plain[0] - 2.0).abs() < 1e-5 && gains[1] == plain[1],
        "{gains:?}"
    );
    assert!((matched[0] / matched[1] - 4.0).abs() < 0.1, "{matched:?}");
    // No image is made, so no backplate is looked for to give it its size.
    let plate = "[backplate]\nframes = \"gone.####.png\"\n[probe]\nframes = \"light.exr\"\n\
                 [[object]]\nmesh = \"sphere\"\n";
    t.put("plate.toml", plate);
    let out = t.run(&["sh", "plate.toml", "--bands", "2"]).ok().out;
    assert_eq!(rows(&out), own);
}

/// Not the shot, not a frame that --frames leaves out, not by another path.
fn nothing_is_written_over(t: &Scratch) {
    t.lights(3);
    t.shot("light.####.exr", "");
    let before = |name: &str| fs::read(t.file(name)).unwrap();
    let (shot, third) = (before("shot.toml"), before("light.0003.exr"));
    t.run(&["sh", "shot.toml", "-o", "shot.toml"])
        .fails(2, &["shot.toml", "this is the shot"]);
    let sequence = ["sh", "light.####.exr", "--frames", "1-2", "-o"];
    for out in ["light.0003.exr", "./light.0003.exr"] {
        t.run(&[&sequence[..], &[out]].concat())
            .fails(2, &[out, "one of the lights"]);
        t.run(&["sh", "shot.toml", "--frames", "1", "-o", out])
            .fails(2, &[out, "one of the lights"]);
    }
    assert!(before("shot.toml") == shot && before("light.0003.exr") == third);
}

#[test]
fn what_cannot_be_is_said() {
    let t = Scratch::new("sh-errors");
    lobes(&t, "light.exr", 1.0);
    t.run(&["sh", "light.exr", "gone.exr"])
        .fails(3, &["gone.exr", "no such file"]);
    // Where a name is to be corrected: on the command line, or in the shot.
    t.put(
        "none.toml",
        "[probe]\nframes = \"nope.####.exr\"\n[[object]]\nmesh = \"sphere\"\n",
    );
    for frames in [&[][..], &["--frames", "1-2"]] {
        let run = |input| t.run(&[&["sh", input], frames].concat());
        let words = ["no file is named nope.####.exr", "check the path: each #"];
        run("nope.####.exr").fails(3, &words);
        let words = [
            "no file is named nope.####.exr",
            "check probe.frames: each #",
        ];
        run("none.toml").fails(3, &words);
    }
    t.run(&["sh", "light.exr", "light.####.exr"])
        .fails(2, &["is a sequence", "one sequence"]);
    t.run(&["sh", "light.exr", "--frames", "1-2"])
        .fails(2, &["--frames", "light.####.exr"]);
    t.run(&["sh", "light.exr", "-o", "light.exr"])
        .fails(2, &["light.exr", "one of the lights"]);
    nothing_is_written_over(&t);
    t.run(&["sh", "light.exr", "-o", "no/folder/c.csv"])
        .fails(4, &["no/folder/c.csv"]);
    t.run(&["sh", "light.exr", "-o", "."])
        .fails(4, &["this is a folder", "--out"]);
    // Before the work: a file whose texels are missing is not even come to.
    let whole = fs::read(t.file("light.exr")).unwrap();
    t.put("cut.exr", &whole[..whole.len() / 2]);
    t.run(&["sh", "cut.exr"]).fails(3, &["cut.exr"]);
    let ran = t
        .run(&["sh", "cut.exr", "-o", "no/folder/c.csv"])
        .fails(4, &["no/folder/c.csv"]);
    assert!(!ran.err.contains("cut.exr"), "{}", ran.err);
    assert_eq!(t.run(&["--json", "sh", "light.exr"]).status, 2);
    for bad in [
        ["--bands", "0"],
        ["--bands", "7"],
        ["--window", "-1"],
        ["--temporal", "-1"],
        ["--temporal", "nan"],
    ] {
        assert_eq!(
            t.run(&[&["sh", "light.exr"], &bad[..]].concat()).status,
            2,
            "{bad:?}"
        );
    }
    t.put("shot.toml", "[probe]\nframes = \"light.exr\"\nscael = 2\n");
    t.run(&["sh", "shot.toml"])
        .fails(2, &["shot.toml", "scael"]);
}

/// Folders, lights and outputs may have names of any bytes; what is said of them is readable all the same.
#[cfg(target_os = "linux")]
#[test]
fn names_need_not_be_text() {
    use std::ffi::{OsStr, OsString};
    use std::os::unix::ffi::OsStrExt;
    let t = Scratch::new("sh-bytes");
    lobes(&t, "light.exr", 1.0);
    let name = |bytes: &[u8]| OsStr::from_bytes(bytes).to_owned();
    let (light, out, folder) = (name(b"l\xff.exr"), name(b"o\xff.json"), name(b"f\xff"));
    let bytes = fs::read(t.file("light.exr")).unwrap();
    fs::write(t.path.join(&light), &bytes).unwrap();
    fs::create_dir(t.path.join(&folder)).unwrap();
    fs::write(t.path.join(&folder).join("light.0007.exr"), &bytes).unwrap();
    let run = |args: &[&OsStr]| {
        let output = t.command(&["sh"]).args(args).output().unwrap();
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        (output.status.code(), said)
    };
    let json = [
        OsStr::new("--format"),
        OsStr::new("json"),
        OsStr::new("-o"),
        &out,
    ];
    let mut sequence: OsString = folder.clone();
    sequence.push("/light.####.exr");
    for (input, frame) in [(&light, 1), (&sequence, 7)] {
        for more in [&[][..], &[OsStr::new("--json")]] {
            let (status, said) = run(&[&[input.as_os_str()], &json[..], more].concat());
            assert_eq!(status, Some(0), "{said}");
            let value = parsed(&fs::read_to_string(t.path.join(&out)).unwrap());
            assert_eq!(value["frames"][0]["frame"], frame);
            assert!(
                value["frames"][0]["file"]
                    .as_str()
                    .unwrap()
                    .contains('\u{fffd}')
            );
        }
    }
    for more in ["--quiet", "--json"] {
        let (status, said) = run(&[
            &name(b"none\xff.exr"),
            OsStr::new(more),
            OsStr::new("-o"),
            &out,
        ]);
        assert_eq!(status, Some(3), "{said}");
        assert!(said.contains("there is no such file"), "{said}");
    }
}

#[test]
fn texels_that_are_no_light_are_counted() {
    let t = Scratch::new("sh-bad");
    let bad = |x, y, _| if (x, y) == (3, 1) { f32::NAN } else { 1.0 };
    t.exr("light.exr", 8, 4, bad);
    let ran = t
        .run(&["sh", "light.exr"])
        .ok()
        .says(&["1 of 32", "not light: 1 NaN"]);
    assert!(
        rows(&ran.out)
            .iter()
            .all(|row| row.1.iter().all(|c| c.is_finite()))
    );
    t.run(&["sh", "light.exr", "--strict"])
        .fails(3, &["light.exr", "--strict"]);
    // Down to two texels, and of odd numbers of them.
    t.exr("two.exr", 2, 1, |_, _, _| 1.0);
    t.exr("odd.exr", 101, 51, |_, _, _| 1.0);
    for name in ["two.exr", "odd.exr"] {
        let out = t.run(&["sh", name, "--bands", "6"]).ok().out;
        let mean = rows(&out)[0].1[1];
        assert!((mean - (4.0 * PI).sqrt()).abs() < 1e-5, "{name}: {mean}");
    }
}

#[test]
fn events_and_coefficients_do_not_mix() {
    let t = Scratch::new("sh-json");
    lobes(&t, "light.exr", 1.0);
    let out = t
        .run(&["--json", "sh", "light.exr", "-o", "c.csv"])
        .ok()
        .out;
    let events: Vec<Value> = out.lines().map(parsed).collect();
    let last = &events[events.len() - 1];
    assert_eq!(
        (&last["event"], &last["projected"]),
        (&"summary".into(), &1.into())
    );
    assert_eq!(
        rows(&fs::read_to_string(t.file("c.csv")).unwrap()).len(),
        25
    );
}
