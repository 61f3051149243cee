//! Host file: `glimt compare` from end to end: what it finds, what it writes, and how it goes on.

mod common;

use common::{Ran, Scratch, read_exr};
use serde_json::Value;
use std::fs;
use std::time::Duration;

/// A diffuse plane that fills the image, under light that no one blocks.
fn plane(t: &Scratch, more: &str) {
    t.exr("light.0001.exr", 8, 4, light);
    t.exr("light.0002.exr", 8, 4, |x, y, c| 1.5 * light(x, y, c));
    let text = format!(
        "[image]\nsize = [16, 12]\nrays_per_pixel = 2\n[camera]\neye = [0, 0, 1]\ntarget = [0, 0, 0]\nup = [1, 0, 0]\nfov_x_deg = 60\n\
         [probe]\nframes = \"light.####.exr\"\n[[object]]\nmesh = \"plane\"\nmaterial = {{ diffuse = [0.5, 0.5, 0.5] }}\n{more}"
    );
    t.put("shot.toml", text);
}

fn light(x: usize, y: usize, c: usize) -> f32 {
    let row = [1.0, 8.0, 3.0, 3.0][y];
    row * [0.2, 1.8, 0.5, 1.5, 1.0, 1.0, 0.1, 1.9][x] * [1.0, 0.8, 0.5][c]
}

/// Its radiance: the upper two rows send `π (sin² θ₁ − sin² θ₀)` each, a half, of their mean.
fn truth(frame: u32) -> [f64; 3] {
    let row = |y: usize, c: usize| (0..8).map(|x| f64::from(light(x, y, c))).sum::<f64>() / 8.0;
    let brighter = if frame == 2 { 1.5 } else { 1.0 };
    std::array::from_fn(|c| brighter * 0.5 * 0.5 * (row(0, c) + row(1, c)))
}

fn compare(t: &Scratch, more: &[&str]) -> Ran {
    let mut args = vec![
        "compare",
        "shot.toml",
        "--device",
        "cpu",
        "--equal-samples",
        "--rounds",
        "1",
    ];
    args.extend(["--preset", "stratified", "--preset", "owen-sobol"]);
    args.extend([
        "--contestant",
        "o'urs & <theirs>: render.pattern=independent image.rays_per_pixel=3",
    ]);
    args.extend(more);
    t.run(&args)
}

fn json(t: &Scratch, folder: &str) -> Value {
    let text = fs::read_to_string(t.file(folder).join("compare.json")).unwrap();
    serde_json::from_str(&text).unwrap()
}

/// The columns of the table that no clock decides.
fn untimed(t: &Scratch, folder: &str) -> Vec<Vec<String>> {
    let text = fs::read_to_string(t.file(folder).join("compare.csv")).unwrap();
    let head: Vec<&str> = text.lines().next().unwrap().split(',').collect();
    let timed = |i: usize| head[i].starts_with("time") || head[i].starts_with("efficiency");
    let cells = |line: &str| -> Vec<String> {
        let cells = line.split(',').take(head.len() - 1).enumerate();
        cells
            .filter(|(i, _)| !timed(*i))
            .map(|(_, c)| c.to_owned())
            .collect()
    };
    text.lines().map(cells).collect()
}

#[test]
fn a_comparison_from_end_to_end() {
    let t = Scratch::new("compare");
    plane(&t, "");
    let ran = compare(&t, &["--keep"]).ok();
    assert!(
        ran.err.contains("The reference criterion is met"),
        "{}",
        ran.err
    );
    let found = json(&t, "compare");
    assert_eq!(found["reference_criterion"], true);
    assert_eq!(found["time_criterion"], Value::Null);
    assert_eq!(found["mode"], "equal-samples");
    assert_eq!(found["about"]["seeds"].as_array().unwrap().len(), 16);
    assert_eq!(found["about"]["filter"], "centre");
    let contestants = found["contestants"].as_array().unwrap();
    assert_eq!(contestants.len(), 3);

    for c in contestants {
        // Unbiased estimators, held against a reference of their own kind.
        let p = c["overall"]["bias"]["p"].as_f64().unwrap();
        assert!(p > 0.001, "{}: {p}", c["name"]);
        // A frame's error is that of its images; frames and their records come in pairs.
        let records = c["records"].as_array().unwrap();
        assert_eq!(records.len(), 2);
        for (score, records) in c["frames"].as_array().unwrap().iter().zip(records) {
            let records = records.as_array().unwrap();
            let squares = records.iter().map(|r| r["square_error"].as_f64().unwrap());
            let error = (squares.sum::<f64>() / 16.0).sqrt();
            assert!((score["error"]["value"].as_f64().unwrap() / error - 1.0).abs() < 1e-9);
        }
        // The first frame has none before it; independent frames flicker with the errors of both.
        let [first, second] = [0, 1].map(|i| &c["frames"][i]);
        assert!(first["flicker"].is_null());
        let flicker = second["flicker"]["value"].as_f64().unwrap();
        let e = [first, second].map(|f| f["error"]["value"].as_f64().unwrap());
        let both = ((e[0] / 1.5).powi(2) + e[1].powi(2)).sqrt();
        assert!((flicker / both - 1.0).abs() < 0.15, "{flicker} {both}");
        assert_eq!(c["is_baseline"], c["name"] == "stratified MIS");
    }
    // Strata help.
    let error = |i: usize| {
        contestants[i]["overall"]["error"]["value"]
            .as_f64()
            .unwrap()
    };
    assert!(error(0) < error(2), "{} {}", error(0), error(2));

    // The reference's own noise is how far it is from the truth.
    for (i, frame) in [1u32, 2].into_iter().enumerate() {
        let figures = &found["references"][i];
        let noise = figures["noise"].as_f64().unwrap();
        let image = read_exr(&t.file(&format!("compare/reference/frame.{frame:04}.exr")));
        let truth = truth(frame);
        // Channels in the order of their names: A, B, G, R.
        let bright = 0.2126 * truth[0] + 0.7152 * truth[1] + 0.0722 * truth[2];
        let squares = (0..3).flat_map(|c| {
            image[3 - c]
                .iter()
                .map(move |v| (f64::from(*v) - truth[c]).powi(2))
        });
        let off = (squares.sum::<f64>() / (3.0 * 192.0)).sqrt() / bright;
        assert!(
            (noise / off - 1.0).abs() < 0.2,
            "frame {frame}: says {noise}, is {off}"
        );
        let mean = figures["mean_luminance"].as_f64().unwrap();
        assert!(
            (mean / bright - 1.0).abs() < 4.0 * noise / 192f64.sqrt(),
            "{mean} {bright}"
        );
    }

    // Means are there, and their names are files'.
    let means = t.list("compare/mean");
    assert_eq!(means.len(), 3, "{means:?}");
    assert_eq!(
        t.list(&format!("compare/mean/{}", means[0])),
        ["frame.0001.exr", "frame.0002.exr"]
    );

    // A row for each contestant and frame, and one for all frames.
    assert_eq!(untimed(&t, "compare").len(), 1 + 3 * 3);
    page(&t);
}

/// Methods that choose the number of their rays say how many there were in each frame.
#[test]
fn rays_and_pilots_are_counted() {
    let t = Scratch::new("compare-rays");
    plane(&t, "");
    let cells = "cells: render.method=cells render.cells.rays=6";
    let more = ["--seeds", "2", "--contestant", cells];
    compare(&t, &more).ok();
    let found = json(&t, "compare");
    let contestants = found["contestants"].as_array().unwrap();
    let of = |name: &str| contestants.iter().find(|c| c["name"] == name).unwrap();
    let frames = of("cells")["frames"].as_array().unwrap();
    for frame in frames {
        let rays = frame["rays"]["all"].as_f64().unwrap();
        let pilots = frame["rays"]["pilots"].as_f64().unwrap();
        assert!((5.0..10.0).contains(&rays), "{rays}");
        assert!(pilots > 0.1 && pilots < 0.4 * rays, "{pilots} of {rays}");
    }
    assert!(of("stratified MIS")["overall"]["rays"].is_null());
    let table = untimed(&t, "compare");
    let column = table[0].iter().position(|name| name == "pilot_share");
    let row = table.iter().find(|row| row[0] == "cells").unwrap();
    let share: f64 = row[column.unwrap()].parse().unwrap();
    let all = &of("cells")["overall"]["rays"];
    let expected = all["pilots"].as_f64().unwrap() / all["all"].as_f64().unwrap();
    assert!((share - expected).abs() < 1e-6);
    let page = fs::read_to_string(t.file("compare/compare.html")).unwrap();
    assert!(page.contains("Figures of each frame") && page.contains("<th>pilots</th>"));
}

/// The page says the verdict first, names all contestants, shows pictures, and needs nothing but itself.
fn page(t: &Scratch) {
    let html = fs::read_to_string(t.file("compare/compare.html")).unwrap();
    let body = html.split("<body>").nth(1).unwrap();
    assert!(
        body.trim_start().starts_with("<p class=\"verdict"),
        "{}",
        &body[..200]
    );
    for name in [
        "stratified MIS",
        "Owen-Sobol MIS",
        "o&#39;urs &amp; &lt;theirs&gt;",
    ] {
        assert!(body.matches(name).count() >= 5, "{name}");
    }
    assert!(!body.contains("<theirs>"));
    for outside in ["http:", "https:", "<script", "<link", "@import", "url("] {
        assert!(!html.contains(outside), "{outside}");
    }
    let pictures = body.matches("src=\"").count();
    assert_eq!(
        pictures,
        body.matches("src=\"data:image/png;base64,").count()
    );
    assert_eq!(pictures, 2 * (1 + 2 * 3));
    assert!(body.matches("<svg").count() >= 2);
    for word in [
        "relative RMSE",
        "Šidák",
        "To do it again",
        "glimt compare shot.toml",
        "Time of a frame",
    ] {
        assert!(body.contains(word), "{word}");
    }
    let open = html.matches("<figure>").count();
    assert_eq!(open, html.matches("</figure>").count());
}

/// What is rendered is not rendered again, and what is found stays the same.
#[test]
fn another_run_goes_on() {
    let t = Scratch::new("compare-again");
    plane(&t, "");
    let rendered = |ran: &Ran| {
        ran.out
            .lines()
            .filter(|l| l.contains("\"event\":\"progress\""))
            .count()
    };
    let first = compare(&t, &["--json", "--seeds", "4"]).ok();
    assert!(rendered(&first) > 0);
    let few = json(&t, "compare");
    assert!(
        few["verdict"]
            .as_str()
            .unwrap()
            .contains("4 SEEDS ARE TOO FEW"),
        "{}",
        few["verdict"]
    );
    let table = fs::read(t.file("compare/compare.csv")).unwrap();
    let again = compare(&t, &["--json", "--seeds", "4"]).ok();
    assert_eq!(rendered(&again), 0, "{}", again.out);
    assert_eq!(fs::read(t.file("compare/compare.csv")).unwrap(), table);

    // More seeds are more of the same; another light is another comparison.
    let more = compare(&t, &["--json"]).ok();
    assert!(rendered(&more) > 0);
    let whole = compare(&t, &["--json", "--out", "whole"]).ok();
    assert!(rendered(&whole) > 0);
    assert_eq!(untimed(&t, "compare"), untimed(&t, "whole"));
    t.exr("light.0002.exr", 8, 4, |x, y, c| 2.0 * light(x, y, c));
    let other = compare(&t, &["--json", "--out", "whole"]).ok();
    assert!(rendered(&other) > 0);
    assert_ne!(untimed(&t, "compare"), untimed(&t, "whole"));
}

/// A run that is killed is continued, to the same end.
#[test]
fn a_killed_comparison_is_continued() {
    let t = Scratch::new("compare-killed");
    plane(&t, "");
    let args = ["--set", "image.size=[64,48]"];
    let mut all = vec![
        "compare",
        "shot.toml",
        "--device",
        "cpu",
        "--equal-samples",
        "--rounds",
        "1",
    ];
    all.extend(["--preset", "stratified", "--preset", "owen-sobol"]);
    all.extend([
        "--contestant",
        "o'urs & <theirs>: render.pattern=independent image.rays_per_pixel=3",
    ]);
    all.extend(args);
    let mut child = t
        .command(&all)
        .stderr(std::process::Stdio::null())
        .spawn()
        .unwrap();
    let is_there = |name: &str| t.list("compare/cache").iter().any(|f| f.starts_with(name));
    for _ in 0..6000 {
        if is_there("stratified-MIS") && is_there("reference.0002") {
            break;
        }
        std::thread::sleep(Duration::from_millis(10));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    assert!(is_there("stratified-MIS"));
    compare(&t, &args).ok();
    compare(&t, &[&args[..], &["--out", "whole"]].concat()).ok();
    assert_eq!(untimed(&t, "compare"), untimed(&t, "whole"));
    let parts = |name: &String| name.ends_with(".part");
    assert!(!t.list("compare/cache").iter().any(parts));
}

/// What one draws without noise is compared by its bias, and a new bake is another contestant.
#[test]
fn one_without_noise_is_compared_by_its_bias() {
    let t = Scratch::new("compare-prt");
    plane(&t, "");
    t.run(&["bake", "shot.toml", "--device", "cpu"]).ok();
    let prt = [
        "--contestant",
        "prt: render.method=prt image.rays_per_pixel=1",
    ];
    compare(&t, &[&prt[..], &["--frames", "1"]].concat()).ok();
    let table = untimed(&t, "compare");
    let cell = |name: &str, column: &str| -> f64 {
        let column = table[0].iter().position(|head| head == column).unwrap();
        let row = table
            .iter()
            .find(|row| row[0] == name && row[1] == "1")
            .unwrap();
        row[column].parse().unwrap()
    };
    // Five bands leave little out of what a plane reflects; all of it is the same for every seed.
    let error = cell("prt", "relative_rmse");
    assert!(error > 0.0 && error < 0.05, "{error}");
    assert!((error - cell("prt", "bias").abs()).abs() < 0.01);
    // The mean of equal numbers may differ from them in the last bit.
    assert!(cell("prt", "relative_rmse_se") < 1e-12 * error);

    // Of few directions, beside the first and in its place: it is told apart, and nothing of before stands for it.
    let bake = ["bake", "shot.toml", "--device", "cpu", "--directions", "9"];
    t.run(&[&bake[..], &["--output", "draft.glb"]].concat())
        .ok();
    let draft = "draft: render.method=prt image.rays_per_pixel=1 render.prt.bake=draft.glb";
    let both = [&prt[..], &["--contestant", draft, "--frames", "1"]].concat();
    compare(&t, &[&both[..], &["--out", "both"]].concat()).ok();
    let errors = |folder: &str| -> Vec<(String, String)> {
        let table = untimed(&t, folder);
        let column = table[0].iter().position(|head| head == "relative_rmse");
        let cells = table
            .iter()
            .map(|row| (row[0].clone(), row[column.unwrap()].clone()));
        cells
            .filter(|(name, _)| name == "prt" || name == "draft")
            .collect()
    };
    let told = errors("both");
    assert!(told.iter().any(|(name, _)| name == "draft"), "{told:?}");
    t.run(&bake).ok();
    compare(&t, &[&prt[..], &["--frames", "1"]].concat()).ok();
    let draft = told.iter().find(|(name, _)| name == "draft").unwrap();
    assert_eq!(errors("compare")[0].1, draft.1);
}

/// A limit ends the reference, the first line says so, and a later run goes on.
#[test]
fn a_short_reference_is_said() {
    let t = Scratch::new("compare-short");
    plane(&t, "");
    compare(&t, &["--reference-time", "0"])
        .ok()
        .says(&["THE REFERENCE CRITERION IS NOT MET"]);
    let short = json(&t, "compare");
    assert_eq!(short["reference_criterion"], false);
    let scramblings = |found: &Value| found["references"][0]["scramblings"].as_u64().unwrap();
    assert_eq!(scramblings(&short), 2);
    compare(&t, &[])
        .ok()
        .says(&["The reference criterion is met"]);
    assert!(scramblings(&json(&t, "compare")) >= 16);
}

/// Against a reference that is 2 % too bright all are biased; against the command's own none is.
#[test]
fn a_given_reference_that_is_off_shows_bias() {
    let t = Scratch::new("compare-bias");
    plane(&t, "");
    compare(&t, &["--keep", "--measure", "2"]).ok();
    let given = |name: &str, factor: f32| {
        for frame in ["0001", "0002"] {
            let planes = read_exr(&t.file(&format!("compare/reference/frame.{frame}.exr")));
            // A, B, G, R.
            let plane = |c: usize| {
                let factor = if c == 0 { 1.0 } else { factor };
                exr::prelude::FlatSamples::F32(planes[c].iter().map(|v| v * factor).collect())
            };
            let channels = [
                ("A", plane(0)),
                ("B", plane(1)),
                ("G", plane(2)),
                ("R", plane(3)),
            ];
            let file = format!("{name}/frame.{frame}.exr");
            fs::create_dir_all(t.file(name)).unwrap();
            t.exr_channels(&file, 16, 12, exr::prelude::Compression::ZIP16, &channels);
        }
        compare(
            &t,
            &[
                "--measure",
                "2",
                "--reference",
                name,
                "--out",
                &format!("{name}-out"),
            ],
        )
        .ok()
        .says(&["THE REFERENCE CRITERION CANNOT BE CHECKED"]);
        json(&t, &format!("{name}-out"))
    };
    let verdict = |found: &Value| found["verdict"].as_str().unwrap().to_owned();
    let same = verdict(&given("same", 1.0));
    assert!(!same.contains("BIASED"), "{same}");
    let off = given("off", 1.02);
    let off = verdict(&off);
    assert_eq!(off.matches("IS BIASED by (-").count(), 3, "{off}");

    compare(&t, &["--reference", "gone"]).fails(3, &["gone", "frame.0001.exr", "--reference"]);
    // One with the light behind it covers other pixels than the contestants.
    t.put(
        "small.toml",
        fs::read_to_string(t.file("shot.toml"))
            .unwrap()
            .replace("fov_x_deg = 60", "fov_x_deg = 120"),
    );
    t.run(&[
        "render",
        "small.toml",
        "--out",
        "lit",
        "--set",
        "output.video=",
    ])
    .ok();
    t.run(&[
        "compare",
        "small.toml",
        "--device",
        "cpu",
        "--preset",
        "shot",
        "--equal-samples",
        "--reference",
        "lit",
    ])
    .fails(
        2,
        &[
            "--reference",
            "covers other pixels",
            "image.background=transparent",
        ],
    );
}

/// Counts are fitted to times; what a machine does with it is said, not tested.
#[test]
fn equal_time_says_what_it_reached() {
    let t = Scratch::new("compare-time");
    plane(&t, "");
    let args = [
        "compare",
        "shot.toml",
        "--device",
        "cpu",
        "--equal-time",
        "5",
        "--rounds",
        "3",
        "--seeds",
        "2",
        "--measure",
        "1",
    ];
    t.run(
        &[
            &args[..],
            &["--preset", "stratified", "--preset", "owen-sobol"],
        ]
        .concat(),
    )
    .ok();
    let found = json(&t, "compare");
    assert_eq!(found["budget"], 0.005);
    let mut held = true;
    for c in found["contestants"].as_array().unwrap() {
        let ratio = c["time"]["median"].as_f64().unwrap() / 0.005;
        let within = (ratio - 1.0).abs() <= 0.05;
        assert_eq!(c["hold"] == "held", within, "{} {ratio}", c["hold"]);
        assert_eq!(c["times"].as_array().unwrap().len(), 3);
        held &= within;
    }
    assert_eq!(found["time_criterion"], held);
    let said = found["verdict"]
        .as_str()
        .unwrap()
        .contains("THE EQUAL-TIME CRITERION IS NOT MET");
    assert_eq!(said, !held);
}

#[test]
fn what_is_wrong_is_said() {
    let t = Scratch::new("compare-wrong");
    plane(&t, "");
    let refused = |more: &[&str], words: &[&str]| {
        t.run(&[&["compare", "shot.toml", "--device", "cpu"], more].concat())
            .fails(2, words);
    };
    refused(
        &["--preset", "stratifid"],
        &["--preset", "did you mean `stratified`?"],
    );
    refused(
        &["--contestant", "x"],
        &["--contestant", "no name", "render.pattern=owen-sobol"],
    );
    refused(
        &["--contestant", "x: render.patern=owen-sobol"],
        &["contestant `x`", "did you mean `pattern`?"],
    );
    refused(
        &["--contestant", "x: image.size=[4,4]"],
        &["the same for all contestants", "--set image.size=[4,4]"],
    );
    refused(
        &["--contestant", "x: render.seed=3"],
        &["`render.seed` is the same for all"],
    );
    refused(
        &[
            "--contestant",
            "x: render.brdf_samples=3",
            "--contestant",
            "x: render.brdf_samples=4",
        ],
        &["two contestants are named `x`"],
    );
    refused(
        &["--measure", "7", "--preset", "shot"],
        &["--measure", "frame 7 is not among 1-2"],
    );
    refused(
        &[
            "--set",
            "camera.eye=[0,0,-1]",
            "--set",
            "camera.target=[0,0,-2]",
            "--preset",
            "shot",
            "--equal-samples",
        ],
        &["no object is seen in frame 1"],
    );
    // Those that were not named may be missing, and are said to be.
    t.run(&["compare", "gone.toml"]).fails(3, &["gone.toml"]);
    let conflict = t.run(&[
        "compare",
        "shot.toml",
        "--equal-samples",
        "--equal-time",
        "5",
    ]);
    assert_eq!(conflict.status, 2);
}
