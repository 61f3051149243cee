//! Host file: a scratch folder, small procedural inputs, and the program run on them.
#![allow(
    dead_code,
    unreachable_pub,
    reason = "each test program uses a part of it"
)]

use exr::prelude::{
    AnyChannel, AnyChannels, Blocks, Compression, Encoding, FlatSamples, Image, Layer,
    LayerAttributes, LineOrder, WritableImage,
};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// A folder of one's own, removed at the end.
pub struct Scratch {
    pub path: PathBuf,
}

/// What the program said and returned.
#[derive(Debug)]
pub struct Ran {
    pub status: i32,
    pub out: String,
    pub err: String,
}

impl Scratch {
    pub fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("glimt-test-{name}-{}", std::process::id()));
        let _ = fs::remove_dir_all(&path);
        fs::create_dir_all(&path).expect("a scratch folder");
        Self { path }
    }

    pub fn file(&self, name: &str) -> PathBuf {
        self.path.join(name)
    }

    /// Writes a file.
    pub fn put(&self, name: &str, content: impl AsRef<[u8]>) -> PathBuf {
        let path = self.file(name);
        fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
        fs::write(&path, content).expect("a file");
        path
    }

    /// A shot of a sphere with the given light, 16 × 12 pixels, to which `more` is added.
    pub fn shot(&self, frames: &str, more: &str) -> PathBuf {
        let text = format!(
            "[image]\nsize = [16, 12]\nrays_per_pixel = 1\n[probe]\nframes = \"{frames}\"\n\
             [[object]]\nmesh = \"sphere\"\n{more}"
        );
        self.put("shot.toml", text)
    }

    /// Writes `light.0001.exr` to `light.nnnn.exr`, 8 × 4, each of another brightness.
    pub fn lights(&self, count: u32) {
        for frame in 1..=count {
            let value = frame as f32;
            self.exr(&format!("light.{frame:04}.exr"), 8, 4, |x, _, c| {
                value + if c == 0 { x as f32 } else { 0.0 }
            });
        }
    }

    /// Writes a float RGB EXR.
    pub fn exr(&self, name: &str, w: usize, h: usize, f: impl Fn(usize, usize, usize) -> f32) {
        let plane = |c: usize| -> Vec<f32> { (0..w * h).map(|i| f(i % w, i / w, c)).collect() };
        self.exr_channels(
            name,
            w,
            h,
            Compression::ZIP16,
            &[
                ("R", FlatSamples::F32(plane(0))),
                ("G", FlatSamples::F32(plane(1))),
                ("B", FlatSamples::F32(plane(2))),
            ],
        );
    }

    /// Writes an EXR of any channels.
    pub fn exr_channels(
        &self,
        name: &str,
        w: usize,
        h: usize,
        compression: Compression,
        channels: &[(&str, FlatSamples)],
    ) {
        let list = channels
            .iter()
            .map(|(name, samples)| AnyChannel::new(*name, samples.clone()))
            .collect();
        let encoding = Encoding {
            compression,
            blocks: Blocks::ScanLines,
            line_order: LineOrder::Increasing,
        };
        let attributes = LayerAttributes::default();
        let layer = Layer::new((w, h), attributes, encoding, AnyChannels::sort(list));
        let path = self.file(name);
        Image::from_layer(layer)
            .write()
            .to_file(path)
            .expect("an EXR");
    }

    /// Runs the program in this folder, on the CPU where it renders.
    pub fn run(&self, args: &[&str]) -> Ran {
        let output = self.command(args).output().expect("the program starts");
        let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("UTF-8");
        Ran {
            status: output.status.code().unwrap_or(-1),
            out: text(output.stdout),
            err: text(output.stderr),
        }
    }

    pub fn command(&self, args: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_glimt"));
        command
            .current_dir(&self.path)
            .args(args)
            .stdin(Stdio::null());
        if args.first() == Some(&"render") && !args.contains(&"--device") {
            command.args(["--device", "cpu"]);
        }
        command
    }

    /// Names of the files in a folder below, sorted.
    pub fn list(&self, folder: &str) -> Vec<String> {
        let mut names: Vec<String> = fs::read_dir(self.file(folder))
            .into_iter()
            .flatten()
            .flatten()
            .map(|entry| entry.file_name().to_string_lossy().into_owned())
            .collect();
        names.sort();
        names
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.path);
    }
}

impl Ran {
    /// Ended well.
    pub fn ok(self) -> Self {
        assert_eq!(self.status, 0, "{self:?}");
        self
    }

    /// Ended with this status and one line of error that holds all of `words`.
    pub fn fails(self, status: i32, words: &[&str]) -> Self {
        assert_eq!(self.status, status, "{self:?}");
        let lines: Vec<&str> = self
            .err
            .lines()
            .filter(|l| l.starts_with("error:"))
            .collect();
        assert_eq!(lines.len(), 1, "{self:?}");
        assert!(!self.err.contains("panicked"), "{self:?}");
        for word in words {
            assert!(lines[0].contains(word), "`{word}` is not in: {}", lines[0]);
        }
        self
    }

    /// Said a note or a warning that holds all of `words`.
    pub fn says(self, words: &[&str]) -> Self {
        let said = |line: &str| words.iter().all(|word| line.contains(word));
        assert!(
            self.err.lines().any(said),
            "{words:?} are not in: {}",
            self.err
        );
        self
    }
}

/// The first pixels of an EXR, all channels in the order of their names.
pub fn read_exr(path: &Path) -> Vec<Vec<f32>> {
    let image = exr::prelude::read_first_flat_layer_from_file(path).expect("an EXR");
    let channels = image.layer_data.channel_data.list;
    channels
        .iter()
        .map(|c| c.sample_data.values_as_f32().collect())
        .collect()
}

/// A GLB of one JSON and one binary chunk.
pub fn glb(json: &str, binary: &[u8]) -> Vec<u8> {
    let pad = |bytes: &[u8], with: u8| {
        let mut bytes = bytes.to_vec();
        bytes.resize(bytes.len().next_multiple_of(4), with);
        bytes
    };
    let (json, binary) = (pad(json.as_bytes(), b' '), pad(binary, 0));
    let mut file = Vec::new();
    let word = |file: &mut Vec<u8>, n: usize| file.extend((n as u32).to_le_bytes());
    file.extend(b"glTF");
    word(&mut file, 2);
    word(&mut file, 12 + 8 + json.len() + 8 + binary.len());
    word(&mut file, json.len());
    file.extend(b"JSON");
    file.extend(&json);
    word(&mut file, binary.len());
    file.extend(b"BIN\0");
    file.extend(&binary);
    file
}

/// A GLB with one triangle mesh; `indices` are 16 bits wide.
pub fn glb_mesh(positions: &[[f32; 3]], indices: &[u16]) -> Vec<u8> {
    let mut binary: Vec<u8> = positions
        .as_flattened()
        .iter()
        .flat_map(|f| f.to_le_bytes())
        .collect();
    let split = binary.len();
    binary.extend(indices.iter().flat_map(|i| i.to_le_bytes()));
    let json = format!(
        r#"{{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],
        "nodes":[{{"mesh":0,"name":"thing"}},{{"camera":0,"name":"view"}}],
        "cameras":[{{"type":"perspective","perspective":{{"yfov":0.6,"znear":0.1}}}}],
        "meshes":[{{"name":"tri","primitives":[{{"attributes":{{"POSITION":0}},"indices":1}}]}}],
        "buffers":[{{"byteLength":{total}}}],
        "bufferViews":[{{"buffer":0,"byteOffset":0,"byteLength":{split}}},
                       {{"buffer":0,"byteOffset":{split},"byteLength":{rest}}}],
        "accessors":[{{"bufferView":0,"componentType":5126,"count":{n},"type":"VEC3","min":[0,0,0],"max":[1,1,1]}},
                     {{"bufferView":1,"componentType":5123,"count":{m},"type":"SCALAR"}}]}}"#,
        total = binary.len(),
        rest = binary.len() - split,
        n = positions.len(),
        m = indices.len(),
    );
    glb(&json, &binary)
}

/// The shared data, if it is there; says so if it is not.
pub fn shared_data() -> Option<PathBuf> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/data");
    if path.is_dir() {
        return Some(path);
    }
    println!("skipped: {} is not there", path.display());
    None
}
