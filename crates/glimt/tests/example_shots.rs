//! Host file: the shots in `examples/shots` render, from data that their own files make.

mod common;

use common::{Scratch, read_exr};
use std::path::Path;

/// A scratch folder with all files of the examples.
fn examples(name: &str) -> Scratch {
    let t = Scratch::new(name);
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/shots");
    for inner in ["", "helicopter/"] {
        for entry in std::fs::read_dir(folder.join(inner)).unwrap() {
            let path = entry.unwrap().path();
            if path.is_file() {
                let name = path.file_name().unwrap().to_string_lossy();
                t.put(&format!("{inner}{name}"), std::fs::read(&path).unwrap());
            }
        }
    }
    t
}

/// The mean of an image's green.
fn mean(t: &Scratch, file: &str) -> f32 {
    let channels = read_exr(&t.file(file));
    let green = &channels[channels.len() - 2];
    green.iter().sum::<f32>() / green.len() as f32
}

#[test]
fn the_small_shots_render() {
    let t = examples("example-shots");
    // The same ball and plate in fewer pixels.
    let film = "synth synth.toml --frames 1 --device cpu --set capture.size=[240,170] --set capture.pixel_um=50 \
                --set plate.size=[64,36] --set truth.size=[128,64]";
    t.run(&film.split_whitespace().collect::<Vec<_>>()).ok();
    let bake = "bake prt.toml --directions 16 --device cpu";
    t.run(&bake.split(' ').collect::<Vec<_>>()).ok();
    for shot in ["still", "mirror-ball", "catcher", "prt"] {
        let file = format!("{shot}.toml");
        let small = "--set image.size=[32,18] --set image.rays_per_pixel=4 --frames 1";
        let args: Vec<&str> = ["render", &file]
            .into_iter()
            .chain(small.split(' '))
            .collect();
        t.run(&args).ok();
        let image = format!("out/{shot}/frame.0001.exr");
        assert!(mean(&t, &image) > 0.0, "{shot}");
    }
    // Every shot here is told of, and tried above.
    let told = std::fs::read_to_string(t.file("README.md")).unwrap();
    for name in t.list(".").iter().filter(|name| name.ends_with(".toml")) {
        assert!(told.contains(name.as_str()), "{name}");
        assert!(
            [
                "synth.toml",
                "still.toml",
                "mirror-ball.toml",
                "prt.toml",
                "catcher.toml"
            ]
            .contains(&name.as_str())
        );
    }
}

#[test]
fn the_helicopter_flies() {
    let t = examples("example-helicopter");
    let film = "synth helicopter/synth.toml --device cpu --set truth.size=[128,64] --frames";
    let args: Vec<&str> = film.split(' ').collect();
    for frame in ["1", "48"] {
        t.run(&[&args[..], &[frame]].concat()).ok();
        let small = "--set image.size=[48,27] --set image.rays_per_pixel=4 --set render.frames=1-96 --frames";
        let render = ["render", "helicopter/shot.toml"];
        let args: Vec<&str> = render
            .into_iter()
            .chain(small.split(' '))
            .chain([frame])
            .collect();
        t.run(&args).ok();
    }
    assert!(!t.file("helicopter/light/capture").exists());
    let [first, later] = ["0001", "0048"].map(|n| format!("helicopter/out/frame.{n}.exr"));
    let differ = |file: &str| mean(&t, file);
    assert!(differ(&first) > 0.0 && differ(&first) != differ(&later));
}
