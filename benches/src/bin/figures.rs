//! Host file: makes Figures 4 to 8 of Hajisharif 2012 again, and measures how far precomputed transfer is from path tracing.
//!
//! `cargo run --release --bin figures -- --out figures` renders by the program's own commands. Without names it makes all; with
//! some (`4 5 6 7 8 window agreement convergence`) those. The dragon and the light maps come from the folder that `GLIMT_BENCH_DATA` names;
//! where they are missing, the built-in helicopter under a procedural sky stands in.

use glam::{UVec2, Vec3, Vec4};
use glimt::cli::Cli;
use glimt::command;
use glimt::notes::Notes;
use glimt::output::exr;
use glimt::output::target::Guard;
use glimt::report::Reporter;
use glimt_benches::convergence::{halved, transfer_error};
use glimt_benches::inputs::data_dir;
use glimt_render_gpu::kernels::environment::bilinear;
use glimt_render_gpu::methods::Prt;
use glimt_render_gpu::prepare::env::{EnvMap, PreparedEnv};
use glimt_render_gpu::prepare::light_sh::LightSh;
use glimt_sampling::luminance;
use image::RgbImage;
use std::error::Error;
use std::path::{Path, PathBuf};

type Outcome<T> = Result<T, Box<dyn Error>>;

/// What is between two pictures of a sheet, in pixels.
const GAP: u32 = 4;

fn main() -> Outcome<()> {
    let mut out = PathBuf::from("figures");
    let mut names = Vec::new();
    let mut args = std::env::args().skip(1);
    while let Some(arg) = args.next() {
        match arg.as_str() {
            "--out" => out = args.next().ok_or("--out wants a folder")?.into(),
            "--bench" => {}
            name => names.push(name.to_owned()),
        }
    }
    if names.is_empty() {
        names = [
            "4",
            "5",
            "6",
            "7",
            "8",
            "window",
            "agreement",
            "convergence",
        ]
        .map(str::to_owned)
        .to_vec();
    }
    let studio = Studio::open(&out)?;
    for name in &names {
        match name.as_str() {
            "4" => studio.probe_resolutions()?,
            "5" => studio.visibility()?,
            "6" => studio.reflection()?,
            "7" => studio.environments()?,
            "8" => studio.directions()?,
            "window" => studio.window()?,
            "agreement" => studio.agreement()?,
            "convergence" => studio.convergence()?,
            other => return Err(format!("there is no figure {other:?}").into()),
        }
    }
    Ok(())
}

/// Where pictures are taken.
struct Studio {
    out: PathBuf,
    /// Path of the model, or the name of a built-in one.
    model: String,
    /// Light maps of 1628 × 814 texels.
    lights: Vec<PathBuf>,
    /// The exposure that suits them.
    exposure_ev: f32,
}

/// A key of the shot and its value, as after `--set`.
type Set = String;

impl Studio {
    fn open(out: &Path) -> Outcome<Self> {
        std::fs::create_dir_all(out)?;
        let out = out.canonicalize()?;
        let dragon = data_dir().join("models/dragon_vrip_res3.ply.gz");
        let model = match dragon.is_file() {
            true => dragon.canonicalize()?.display().to_string(),
            false => {
                println!(
                    "{} is not there: the built-in helicopter stands in",
                    dragon.display()
                );
                "helicopter".to_owned()
            }
        };
        let mut lights = Vec::new();
        for name in [
            "spruit_sunrise_1k",
            "studio_small_03_1k",
            "st_fagans_interior_1k",
        ] {
            let file = data_dir().join("hdri").join(name).with_extension("hdr");
            if file.is_file() {
                let picture = image::open(&file)?.into_rgba32f();
                let size = UVec2::new(picture.width(), picture.height());
                let texels = picture.pixels().map(|p| Vec4::from_array(p.0)).collect();
                lights.push(enlarged(
                    &out.join(name).with_extension("hdr"),
                    size,
                    texels,
                )?);
            }
        }
        let exposure_ev = if lights.is_empty() { -5.0 } else { -1.6 };
        if lights.is_empty() {
            println!(
                "{} has no light maps: a procedural one stands in",
                data_dir().display()
            );
            let size = UVec2::new(1024, 512);
            let map = glimt_benches::inputs::procedural_map(size);
            let texels = map
                .iter()
                .map(|p| Vec3::from_array(*p).extend(1.0))
                .collect();
            lights.push(enlarged(&out.join("procedural.hdr"), size, texels)?);
        }
        Ok(Self {
            out,
            model,
            lights,
            exposure_ev,
        })
    }

    /// The shot of all figures: the model on a plane that takes its shadow.
    fn shot(&self) -> Outcome<PathBuf> {
        let file = self.out.join("shot.toml");
        let text = format!(
            "[image]\nsize = [480, 360]\nrays_per_pixel = 16\nexposure_ev = {exposure_ev}\n\
             [camera]\neye = [3.4, -2.2, 1.9]\ntarget = [0.0, 0.0, 0.62]\nfov_x_deg = 36\n\
             [probe]\nframes = {light:?}\nrotate_z_deg = 270\n\
             [[object]]\nmesh = {model:?}\nscale = {scale}\nground = true\n\
             material = {{ diffuse = [0.55, 0.5, 0.45] }}\n\
             [[object]]\nmesh = \"plane\"\nscale = 3.0\nsubdivide = 7\nmaterial = {{ diffuse = [0.5, 0.5, 0.5] }}\n\
             [render]\nmethod = \"prt\"\n\
             [output]\nvideo = \"\"\n",
            light = self.lights[0].display().to_string(),
            exposure_ev = self.exposure_ev,
            model = self.model,
            scale = if self.model == "helicopter" { 0.4 } else { 9.0 },
        );
        if std::fs::read_to_string(&file).ok().as_ref() != Some(&text) {
            std::fs::write(&file, text)?;
        }
        Ok(file)
    }

    /// Renders the shot with keys set, after a bake where there is none for them. Returns the folder of frame 1.
    fn render(&self, name: &str, sets: &[Set]) -> Outcome<PathBuf> {
        let shot = self.shot()?.display().to_string();
        let out = self.out.join(name);
        let given = |key: &str, default: &str| {
            let value = sets
                .iter()
                .find_map(|set| set.strip_prefix(key)?.strip_prefix('='));
            value.unwrap_or(default).to_owned()
        };
        let (n, bands) = (
            given("render.prt.directions", "2500"),
            given("render.prt.bands", "5"),
        );
        let bake = self.out.join(format!("transfer-{n}-{bands}.glb"));
        let mut sets = sets.to_vec();
        sets.push(format!("render.prt.bake={}", bake.display()));
        let sets: Vec<&str> = sets.iter().flat_map(|set| ["--set", set]).collect();
        if given("render.method", "prt") == "prt" {
            run(&[&["bake", &shot], &sets[..]].concat())?;
        }
        let folder = out.display().to_string();
        run(&[&["render", &shot, "--out", &folder], &sets[..]].concat())?;
        Ok(out)
    }

    /// Renders pictures and lays them side by side.
    fn sheet(&self, figure: &str, pictures: &[(&str, Vec<Set>)]) -> Outcome<()> {
        let mut images = Vec::new();
        for (name, sets) in pictures {
            let folder = self.render(&format!("{figure}/{name}"), sets)?;
            images.push(image::open(first(&folder, "png")?)?.into_rgb8());
        }
        let file = self.out.join(format!("{figure}.png"));
        side_by_side(&images).save(&file)?;
        let names: Vec<&str> = pictures.iter().map(|(name, _)| *name).collect();
        println!("{}: {}", file.display(), names.join(", "));
        Ok(())
    }

    /// Figure 4: the light map halved 0, 1, 3 and 5 times.
    fn probe_resolutions(&self) -> Outcome<()> {
        let level = |l: u32| vec![format!("render.prt.level={l}")];
        self.sheet(
            "figure-4",
            &[
                ("1628x814", level(0)),
                ("814x407", level(1)),
                ("203x101", level(3)),
                ("50x25", level(5)),
            ],
        )
    }

    /// Figure 5: without and with shadows.
    fn visibility(&self) -> Outcome<()> {
        let shadows = |on: bool| vec![format!("render.prt.shadows={on}")];
        self.sheet(
            "figure-5",
            &[("without", shadows(false)), ("with", shadows(true))],
        )
    }

    /// Figure 6: the light map mirrored.
    fn reflection(&self) -> Outcome<()> {
        let weight = |w: &str| vec![format!("object.0.reflection={w}")];
        let pictures = [
            ("0.0", weight("0")),
            ("0.2", weight("0.2")),
            ("0.6", weight("0.6")),
        ];
        self.sheet("figure-6", &pictures)
    }

    /// Figure 7: other environments.
    fn environments(&self) -> Outcome<()> {
        let names: Vec<String> = self.lights.iter().map(|light| stem(light)).collect();
        let of = |light: &PathBuf| vec![format!("probe.frames={}", light.display())];
        let pictures: Vec<(&str, Vec<Set>)> = names
            .iter()
            .map(String::as_str)
            .zip(self.lights.iter().map(of))
            .collect();
        self.sheet("figure-7", &pictures)
    }

    /// Figure 8: 100, 900 and 2500 directions a vertex.
    fn directions(&self) -> Outcome<()> {
        let n = |n: u32| vec![format!("render.prt.directions={n}")];
        self.sheet(
            "figure-8",
            &[("100", n(100)), ("900", n(900)), ("2500", n(2500))],
        )
    }

    /// What a window does to ringing: none, and Hann's with w = n.
    fn window(&self) -> Outcome<()> {
        let keys = |window: &str| {
            let light = self.lights[1 % self.lights.len()].display();
            vec![
                format!("probe.frames={light}"),
                format!("render.prt.window={window}"),
                "image.exposure_ev=-2.4".to_owned(),
            ]
        };
        self.sheet("window", &[("none", keys("0")), ("hann-5", keys("5"))])
    }

    /// How far precomputed transfer is from a long run of multiple importance sampling.
    fn agreement(&self) -> Outcome<()> {
        let still = ["image.background=transparent", "output.png=false"].map(str::to_owned);
        let long = ["render.method=mis", "image.rays_per_pixel=256"].map(str::to_owned);
        println!("light | light is | bands | window | relative RMSE | mean | median");
        for light in &self.lights {
            let name = stem(light);
            let of = |light: &Path| format!("probe.frames={}", light.display());
            let base = [&still[..], &[of(light)]].concat();
            let truth = self.render(
                &format!("agreement/{name}-mis"),
                &[&base[..], &long].concat(),
            )?;
            let truth = exr::read_pixels(&first(&truth, "exr")?)?;
            for bands in [3, 4, 5, 6] {
                for window in [0, 2 * bands, bands] {
                    let keys = [
                        format!("render.prt.bands={bands}"),
                        format!("render.prt.window={window}"),
                    ];
                    let name = format!("agreement/{name}-prt-{bands}-{window}");
                    let image = self.render(&name, &[&base[..], &keys].concat())?;
                    let image = exr::read_pixels(&first(&image, "exr")?)?;
                    println!(
                        "{} | filmed | {bands} | {window} | {}",
                        stem(light),
                        Distance::of(&image, &truth)
                    );
                }
            }
            // Light that five bands hold whole: what is left is the vertices, their directions, and the noise of both.
            let smooth = self.band_limited(light)?;
            let base = [&still[..], &[of(&smooth)]].concat();
            let truth = self.render(
                &format!("agreement/{name}-smooth-mis"),
                &[&base[..], &long].concat(),
            )?;
            let truth = exr::read_pixels(&first(&truth, "exr")?)?;
            let keys = ["render.prt.bands=5", "render.prt.window=0"].map(str::to_owned);
            let image = self.render(
                &format!("agreement/{name}-smooth-prt"),
                &[&base[..], &keys].concat(),
            )?;
            let image = exr::read_pixels(&first(&image, "exr")?)?;
            println!(
                "{} | of five bands | 5 | 0 | {}",
                stem(light),
                Distance::of(&image, &truth)
            );
        }
        Ok(())
    }

    /// How far coefficients are from those of the whole map, and of all directions.
    fn convergence(&self) -> Outcome<()> {
        println!("light | map halved | largest change of a coefficient, of the largest");
        for light in &self.lights {
            let env = env(light)?;
            for level in [1, 3, 5] {
                println!("{} | {level} | {:.1e}", stem(light), halved(&env, level)?);
            }
        }
        println!("directions | error of a coefficient without shadows, root mean square");
        for directions in [100, 900, 2500] {
            println!("{directions} | {:.5}", transfer_error(directions)?);
        }
        Ok(())
    }

    /// The light's first five bands as a map, with as much even light as keeps it above zero.
    fn band_limited(&self, light: &Path) -> Outcome<PathBuf> {
        let env = env(light)?;
        let c = LightSh::default().project(&env, 5, &Prt::default())?;
        let size = UVec2::new(512, 256);
        let value = |i: u32| {
            let texel = UVec2::new(i % size.x, i / size.x);
            let y = glimt_sh::basis(glimt_probe::latlong::texel_direction(texel, size));
            (0..25).map(|k| c[k].truncate() * y[k]).sum::<Vec3>()
        };
        let values: Vec<Vec3> = (0..size.element_product()).map(value).collect();
        let lowest = values.iter().fold(Vec3::ZERO, |low, v| low.min(*v));
        let texels: Vec<Vec4> = values
            .iter()
            .map(|v| (*v - lowest).max(Vec3::ZERO).extend(1.0))
            .collect();
        let file = self.out.join(format!("{}-smooth.exr", stem(light)));
        let stamp = glimt::output::Stamp {
            hash: String::new(),
            frame: 0,
        };
        let target = Guard::new(true).target(&file).map_err(told)?;
        exr::write_rgb(&target, size, &texels, &stamp, exr::Storage::Float).map_err(told)?;
        Ok(file)
    }
}

/// How far two pictures are apart where both show objects.
struct Distance {
    rmse: f64,
    mean: f64,
    median: f64,
}

impl Distance {
    fn of(image: &[Vec4], truth: &[Vec4]) -> Self {
        let full = |p: &Vec4| p.w > 0.999;
        let pairs: Vec<(f64, f64)> = image
            .iter()
            .zip(truth)
            .filter(|(a, b)| full(a) && full(b))
            .map(|(a, b)| [a, b].map(|p| f64::from(luminance(p.truncate()))).into())
            .collect();
        let n = pairs.len().max(1) as f64;
        let mean = pairs.iter().map(|(_, b)| b).sum::<f64>() / n;
        let square = pairs.iter().map(|(a, b)| (a - b) * (a - b)).sum::<f64>() / n;
        let mut relative: Vec<f64> = pairs
            .iter()
            .map(|(a, b)| (a - b).abs() / b.max(1e-3 * mean))
            .collect();
        relative.sort_by(f64::total_cmp);
        Self {
            rmse: square.sqrt() / mean,
            mean: pairs.iter().map(|(a, _)| a).sum::<f64>() / n / mean - 1.0,
            median: relative
                .get(relative.len() / 2)
                .copied()
                .unwrap_or(f64::NAN),
        }
    }
}

impl std::fmt::Display for Distance {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { rmse, mean, median } = self;
        let percent = [rmse, mean, median].map(|x| 100.0 * x);
        write!(
            f,
            "{:.1} % | {:+.1} % | {:.1} %",
            percent[0], percent[1], percent[2]
        )
    }
}

/// Writes a map at the largest size of the paper.
fn enlarged(file: &Path, size: UVec2, mut texels: Vec<Vec4>) -> Outcome<PathBuf> {
    EnvMap::repair(&mut texels);
    let (width, height) = (1628, 814);
    let of = |x: u32, y: u32| {
        let d = glimt_probe::latlong::texel_direction(UVec2::new(x, y), UVec2::new(width, height));
        image::Rgb(bilinear(&texels, size, d).to_array())
    };
    if !file.is_file() {
        image::Rgb32FImage::from_fn(width, height, of).save(file)?;
    }
    Ok(file.to_owned())
}

/// Runs a command of the program, as its command line does.
fn run(args: &[&str]) -> Outcome<()> {
    use clap::Parser;
    let cli = Cli::try_parse_from([&["glimt", "--quiet"], args].concat())?;
    command::run(cli.command, &Reporter::new(cli.print)).map_err(told)
}

/// An error of the program with its fix.
fn told(error: glimt::error::Error) -> Box<dyn Error> {
    let reporter = Reporter::new(glimt::cli::PrintFlags {
        quiet: false,
        json: false,
        verbose: 0,
    });
    reporter.error(&error);
    "the command failed".into()
}

/// The only frame of a folder.
fn first(folder: &Path, extension: &str) -> Outcome<PathBuf> {
    let mut files: Vec<PathBuf> = std::fs::read_dir(folder)?
        .filter_map(|entry| Some(entry.ok()?.path()))
        .filter(|path| path.extension().is_some_and(|e| e == extension))
        .collect();
    files.sort();
    files
        .pop()
        .ok_or_else(|| format!("{} holds no frame", folder.display()).into())
}

/// A light map, without tables.
fn env(light: &Path) -> Outcome<PreparedEnv> {
    let read = glimt::input::read_image(light, &mut Notes::new(false)).map_err(told)?;
    let mut texels = read.texels;
    EnvMap::repair(&mut texels);
    Ok(EnvMap::new(read.header.size, texels)?.without_tables(0.0)?)
}

fn stem(file: &Path) -> String {
    file.file_stem()
        .map_or(String::new(), |s| s.to_string_lossy().into_owned())
}

/// Pictures in a row, or in two where there are more than three.
fn side_by_side(images: &[RgbImage]) -> RgbImage {
    let columns = if images.len() > 3 {
        2
    } else {
        images.len().max(1)
    } as u32;
    let rows = (images.len() as u32).div_ceil(columns);
    let (width, height) = images
        .first()
        .map_or((1, 1), image::GenericImageView::dimensions);
    let size = |n: u32, side: u32| n * (side + GAP) - GAP;
    let mut sheet = RgbImage::from_pixel(
        size(columns, width),
        size(rows, height),
        image::Rgb([255; 3]),
    );
    for (i, picture) in (0..).zip(images) {
        let (x, y) = (i % columns * (width + GAP), i / columns * (height + GAP));
        image::imageops::replace(&mut sheet, picture, x.into(), y.into());
    }
    sheet
}
