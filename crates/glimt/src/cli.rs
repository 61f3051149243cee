//! Host file: the command line.

use clap::{Args, Parser, Subcommand, ValueEnum};
use glam::UVec2;
use std::path::PathBuf;
use std::time::Duration;

/// Renders virtual objects into filmed footage, lit by a filmed HDR light probe.
#[derive(Debug, Parser)]
#[command(version, propagate_version = true, after_help = EXIT_STATUS)]
pub struct Cli {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
    /// What to print.
    #[command(flatten)]
    pub print: PrintFlags,
}

/// Flags that every command has: what it prints.
#[derive(Clone, Copy, Debug, Args)]
pub struct PrintFlags {
    /// Print nothing but warnings and errors
    #[arg(long, short, global = true)]
    pub quiet: bool,
    /// Print events, and a summary at the end, as JSON lines on standard output
    #[arg(long, global = true)]
    pub json: bool,
    /// Say more on standard error: -v what is done, -vv in detail
    #[arg(long, short, global = true, action = clap::ArgAction::Count)]
    pub verbose: u8,
}

/// The commands.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Render the built-in shot: everything on procedural data, nothing to download
    #[command(after_help = DEMO_EXAMPLES)]
    Demo {
        /// Common flags.
        #[command(flatten)]
        flags: RenderFlags,
    },
    /// Render a shot file: EXR and PNG frames, and an mp4 of them
    ///
    /// A frame whose outputs exist already, made by this version from the same shot, inputs and seed, is skipped.
    #[command(after_help = RENDER_EXAMPLES)]
    Render {
        /// The shot file (TOML); paths in it are relative to it
        #[arg(value_name = "SHOT.toml")]
        shot: PathBuf,
        /// Common flags.
        #[command(flatten)]
        flags: RenderFlags,
        /// What frames continue from.
        #[command(flatten)]
        past: PastFlags,
        /// Whether frames are still to come.
        #[command(flatten)]
        follow: FollowFlags,
    },
    /// Put estimators side by side on one shot, at equal time or equal samples: error, bias, flicker, time, efficiency, pictures
    ///
    /// Contestants are sets of keys of the shot; all share scene, light, camera and image.filter ("centre" unless the shot or --set
    /// gives it: light is compared, not how well edges are covered). Nothing is behind the objects: no background, no backplate;
    /// catchers count as they are lit. Each is rendered with --seeds independent scramblings and held against a long reference run.
    ///
    /// Writes compare.html (one file, with pictures, curves and definitions), compare.json and compare.csv. What is rendered is kept
    /// in cache/ below: another run continues from there, and a longer --reference-time refines what is there.
    #[command(after_help = COMPARE_EXAMPLES)]
    Compare {
        /// The shot file (TOML)
        #[arg(value_name = "SHOT.toml")]
        shot: PathBuf,
        /// Common flags.
        #[command(flatten)]
        flags: RenderFlags,
        /// Who is compared, and how.
        #[command(flatten)]
        compare: CompareFlags,
    },
    /// Precompute how much light reaches every vertex from where: what a shot needs for render.method = "prt"
    ///
    /// Writes one binary glTF file, SHOT.prt.glb unless the shot's render.prt.bake or -o says otherwise, which other programs can
    /// open: geometry in the world, with the coefficients as attributes _SH_0 … and _SH_BLOCKED_0 …. One that is there already, of
    /// the same geometry and settings, is left as it is. Nothing may move but the camera and the light.
    #[command(after_help = BAKE_EXAMPLES)]
    Bake {
        /// The shot file (TOML)
        #[arg(value_name = "SHOT.toml")]
        shot: PathBuf,
        /// Flags.
        #[command(flatten)]
        flags: BakeFlags,
    },
    /// Film a simulated mirror ball, with a backplate and the truth: its light, centre, radius and sun in every frame
    ///
    /// Writes capture/, plate/, truth/ and a shot that fits. A frame that is there already, made by this version from the same
    /// settings, light and seed, is skipped.
    #[command(after_help = SYNTH_EXAMPLES)]
    Synth {
        /// Settings (TOML), or a lat-long light map (EXR, HDR); without it, the built-in sky
        #[arg(value_name = "SYNTH.toml|LIGHT")]
        input: Option<PathBuf>,
        /// Common flags.
        #[command(flatten)]
        flags: SynthFlags,
    },
    /// Turn film of a mirror ball into lat-long maps: the ball is found, steadied and unwarped
    ///
    /// Writes latlong.####.exr, mask.####.png (0 seen, 1 hidden behind the ball, 2 rig, 3 the mixed ring at the rim) where
    /// it changes, and track.json: where the ball was in each frame. A frame that is there already is skipped.
    #[command(after_help = UNWARP_EXAMPLES)]
    Unwarp {
        /// The frames, with #### for their numbers (EXR, HDR; or PNG, JPEG, whose lamps clip); one file is a still
        #[arg(value_name = "FRAMES")]
        input: PathBuf,
        /// Flags.
        #[command(flatten)]
        flags: UnwarpFlags,
    },
    /// Project light maps onto spherical harmonics: the coefficients of each frame, for engines and programs of one's own
    ///
    /// FRAMES is a sequence with #### for the frames' numbers, one or several lat-long maps (EXR, HDR), or a shot, whose
    /// light is taken as its keys under probe say (mirror balls too; scale, turn, colours). Those under render.prt are not looked
    /// at: bands, window and temporal are flags here, and no map is halved. The world has z up: row 0 is +z, the image's centre +x,
    /// its left half +y.
    #[command(after_help = SH_EXAMPLES)]
    Sh {
        /// A sequence, light maps, or a shot
        #[arg(value_name = "FRAMES", required = true)]
        inputs: Vec<PathBuf>,
        /// Flags.
        #[command(flatten)]
        flags: ShFlags,
    },
    /// Say what a file holds (EXR, HDR, glTF, OBJ, PLY, STL, shot), or which devices there are
    #[command(after_help = INFO_EXAMPLES)]
    Info {
        /// An image, a mesh or a shot; without it, devices and versions are listed
        file: Option<PathBuf>,
        /// Set a key of the shot before showing it
        #[arg(long = "set", value_name = "KEY=VALUE")]
        set: Vec<String>,
    },
}

/// Flags of the commands that write into a folder: what they may do there.
#[derive(Clone, Copy, Debug, Default, Args)]
pub struct WriteFlags {
    /// Replace outputs of the same name that glimt did not write; files that are read are never written over
    #[arg(long)]
    pub overwrite: bool,
    /// Let other runs write to the same folder, if all are given this flag; their frames must be different
    #[arg(long)]
    pub share: bool,
}

/// Flags of the commands that render.
#[derive(Clone, Debug, Default, Args)]
pub struct RenderFlags {
    /// Render these frames alone, as 1-24, 7, 1-96x2 (every second) or 1,3,7-9; negative as -5--1
    #[arg(long, value_name = "FRAMES", allow_hyphen_values = true)]
    pub frames: Option<String>,
    /// Where to render
    #[arg(long, value_enum, default_value_t)]
    pub device: Device,
    /// How to estimate reflected light, instead of the shot's render.method
    #[arg(long, value_name = crate::shot::METHODS)]
    pub method: Option<String>,
    /// Set any key of the shot, as image.rays_per_pixel=64 or object.0.scale=2
    #[arg(long = "set", value_name = "KEY=VALUE")]
    pub set: Vec<String>,
    /// Folder for the outputs, instead of the shot's output.dir
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Seed of the random streams, instead of the shot's render.seed
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = seed)]
    pub seed: Option<u32>,
    /// Refuse inputs with defects (texels that are not light, degenerate triangles) rather than work around them
    #[arg(long)]
    pub strict: bool,
    /// What may be written.
    #[command(flatten)]
    pub write: WriteFlags,
    /// What the first frame continues from: flags of `glimt render` alone.
    #[arg(skip)]
    pub past: PastFlags,
}

/// Flags of methods whose frames continue from one another.
#[derive(Clone, Debug, Default, Args)]
pub struct PastFlags {
    /// With the methods cells and smc, or prt with `render.prt.temporal`: render W frames before the first, without writing them
    #[arg(
        long,
        value_name = "W",
        default_value = "0",
        conflicts_with = "state_in"
    )]
    pub preroll: u32,
    /// With the methods cells and smc: continue from a state that --state-out saved
    #[arg(long, value_name = "FILE", conflicts_with = "follow")]
    pub state_in: Option<PathBuf>,
    /// With the methods cells and smc: save what the next frame would continue from
    #[arg(long, value_name = "FILE", conflicts_with = "follow")]
    pub state_out: Option<PathBuf>,
}

/// Flags of frames that are still to come.
#[derive(Clone, Copy, Debug, Args)]
pub struct FollowFlags {
    /// Render frames as they appear in the folder of probe.frames, dropping some when more than --max-lag behind
    ///
    /// The first frame is the newest that is there, or the first of --frames or render.frames. Lag and drops are reported.
    #[arg(long)]
    pub follow: bool,
    /// With --follow: end when no frame has come for so long; a backplate is waited for half as long
    #[arg(long, value_name = "SECONDS", default_value = "10", requires = "follow", value_parser = seconds)]
    pub wait: Duration,
    /// With --follow: a frame that has waited longer is dropped, and those up to the newest with it
    #[arg(long, value_name = "SECONDS", default_value = "0.5", requires = "follow", value_parser = lag)]
    pub max_lag: Duration,
}

/// Flags of `glimt compare`.
#[derive(Clone, Debug, Default, Args)]
pub struct CompareFlags {
    /// A built-in contestant: kronander (all three of the paper), kronander-mis, kronander-bis, kronander-smc (biased), stratified,
    /// owen-sobol, product, cells, shot (its own settings); repeat for more. Default: kronander, stratified and shot
    #[arg(long, value_name = "NAME")]
    pub preset: Vec<String>,
    /// A contestant of one's own: a name, and the keys of the shot that make it (render.* and image.rays_per_pixel); repeat for
    /// more
    #[arg(long, value_name = "NAME: KEY=VALUE …")]
    pub contestant: Vec<String>,
    /// Compare with the counts of samples as they are given
    #[arg(long, conflicts_with = "equal_time")]
    pub equal_samples: bool,
    /// Fit the counts until every contestant's frame takes this long, to 5 %; the first contestant's time if not given
    ///
    /// It fits image.rays_per_pixel, or, for a contestant with one ray, its samples: MIS n + n, BIS N with M / N kept, SMC its
    /// particles.
    #[arg(long, value_name = "MS", value_parser = milliseconds)]
    pub equal_time: Option<f64>,
    /// Measure errors in these frames, as 5,90; spread over the shot, at most 8, if not given
    #[arg(
        long,
        value_name = "FRAMES",
        value_delimiter = ',',
        allow_hyphen_values = true,
        conflicts_with = "stride"
    )]
    pub measure: Vec<i32>,
    /// Measure errors in every N-th frame
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub stride: Option<u32>,
    /// Independent scramblings of each contestant; a standard error needs at least 16
    #[arg(long, value_name = "K", default_value_t = 16, value_parser = clap::value_parser!(u32).range(1..=4096))]
    pub seeds: u32,
    /// Compare with DIR/frame.####.exr, rendered with image.background = "transparent" and the same filter, instead of a
    /// reference of the command's own; compare --keep writes such a folder
    #[arg(long, value_name = "DIR")]
    pub reference: Option<PathBuf>,
    /// Render no longer than this for the reference; without it, until its noise is below a tenth of the smallest error
    #[arg(long, value_name = "SECONDS", value_parser = reference_seconds, conflicts_with = "reference")]
    pub reference_time: Option<f64>,
    /// Rounds in which times are measured
    #[arg(long, value_name = "N", default_value_t = 9, value_parser = clap::value_parser!(u32).range(1..=1000))]
    pub rounds: u32,
    /// Write the mean image of each contestant and the reference as EXR, too
    #[arg(long)]
    pub keep: bool,
}

/// Flags of `glimt bake`.
#[derive(Clone, Debug, Default, Args)]
pub struct BakeFlags {
    /// Where to compute
    #[arg(long, value_enum, default_value_t)]
    pub device: Device,
    /// Set any key of the shot, as object.1.subdivide=6
    #[arg(long = "set", value_name = "KEY=VALUE")]
    pub set: Vec<String>,
    /// Directions at each vertex, instead of the shot's render.prt.directions
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    pub directions: Option<String>,
    /// Bands of spherical harmonics, 1 to 6, instead of the shot's render.prt.bands
    #[arg(long, value_name = "n", allow_hyphen_values = true)]
    pub bands: Option<String>,
    /// Where to write it, instead of the shot's render.prt.bake
    #[arg(long, short, alias = "output", value_name = "FILE")]
    pub out: Option<PathBuf>,
    /// Refuse meshes with defects rather than work around them
    #[arg(long)]
    pub strict: bool,
    /// Replace a file of the same name that glimt did not write; files that are read are never written over
    #[arg(long)]
    pub overwrite: bool,
}

/// Flags of `glimt synth`.
#[derive(Clone, Debug, Args)]
pub struct SynthFlags {
    /// Film these frames alone, as 1-24, 7, 1-96x2 (every second) or 1,3,7-9; negative as -5--1
    #[arg(long, value_name = "FRAMES", allow_hyphen_values = true)]
    pub frames: Option<String>,
    /// Where to compute
    #[arg(long, value_enum, default_value_t)]
    pub device: Device,
    /// Set any key, as capture.radius_mm=40 or lamp.0.flicker=0.5
    #[arg(long = "set", value_name = "KEY=VALUE")]
    pub set: Vec<String>,
    /// Folder for the outputs, instead of output.dir
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Seed of shake, noise and clouds, instead of the key seed
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = seed)]
    pub seed: Option<u32>,
    /// Refuse a light map with texels that are not light, rather than take them as 0
    #[arg(long)]
    pub strict: bool,
    /// What may be written.
    #[command(flatten)]
    pub write: WriteFlags,
}

/// Flags of `glimt unwarp`.
#[derive(Clone, Debug, Args)]
pub struct UnwarpFlags {
    /// Unwarp these frames alone, as 1-24, 7, 1-96x2 (every second) or 1,3,7-9; negative as -5--1
    #[arg(long, value_name = "FRAMES", allow_hyphen_values = true)]
    pub frames: Option<String>,
    /// Where to compute
    #[arg(long, value_enum, default_value_t)]
    pub device: Device,
    /// Folder for the outputs
    #[arg(long, value_name = "DIR", default_value = "unwarped")]
    pub out: PathBuf,
    /// Size of the maps, as 1628x814; twice the ball's radius by once, if not given
    #[arg(long, value_name = "WxH", value_parser = map_size)]
    pub size: Option<UVec2>,
    /// From the camera to the ball's centre in millimetres; inf for an orthographic camera [default: 1250]
    #[arg(long, value_name = "MM")]
    pub distance_mm: Option<f32>,
    /// Radius of the ball in millimetres [default: 50]
    #[arg(long, value_name = "MM")]
    pub radius_mm: Option<f32>,
    /// Set any key of the shot's [probe.ball], as rig_deg=8, rim_px=2 or steady=false
    #[arg(long = "set", value_name = "KEY=VALUE")]
    pub set: Vec<String>,
    /// Refuse frames with pixels that are not light, rather than take them as 0
    #[arg(long)]
    pub strict: bool,
    /// What may be written.
    #[command(flatten)]
    pub write: WriteFlags,
}

/// Flags of `glimt sh`.
#[derive(Clone, Debug, Args)]
pub struct ShFlags {
    /// Project these frames of a sequence alone, as 1-24, 7, 1-96x2 (every second) or 1,3,7-9; negative as -5--1
    #[arg(long, value_name = "FRAMES", allow_hyphen_values = true)]
    pub frames: Option<String>,
    /// Bands, l = 0 to N - 1: N² coefficients
    #[arg(long, value_name = "N", default_value_t = 5, value_parser = clap::value_parser!(u32).range(1..=6))]
    pub bands: u32,
    /// Multiply band l by the Hann window (1 + cos(πl/W))/2 against ringing; W = N is usual, off leaves it out
    #[arg(long, value_name = "W|off", default_value = "off", value_parser = window)]
    pub window: f32,
    /// Filter over the frames: (c + α·c_before)/(1 + α)
    #[arg(long, value_name = "α", default_value = "0", value_parser = alpha)]
    pub temporal: f32,
    /// How they are written
    #[arg(long, value_enum, default_value_t)]
    pub format: ShFormat,
    /// Signs, order and scale in csv and json
    #[arg(long, value_enum, default_value_t)]
    pub convention: ShConvention,
    /// The axis that points up in what is written: y turns (x, y, z) into (x, z, -y)
    #[arg(long, value_enum, default_value_t)]
    pub up: Up,
    /// Turn the lights about the vertical, counter-clockwise seen from above; in a shot, further than probe.rotate_z_deg
    #[arg(long, value_name = "DEG", default_value = "0", allow_hyphen_values = true, value_parser = degrees)]
    pub rotate_z_deg: f32,
    /// File for the coefficients; standard output if not given
    #[arg(long, short, value_name = "FILE")]
    pub out: Option<PathBuf>,
    /// Refuse maps with texels that are not light, rather than take them as 0
    #[arg(long)]
    pub strict: bool,
    /// Replace a file of the same name that glimt did not write; files that are read are never written over
    #[arg(long)]
    pub overwrite: bool,
}

/// How coefficients are written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum ShFormat {
    /// A line a coefficient: frame, l, m, r, g, b
    #[default]
    Csv,
    /// One object with a list of frames
    Json,
    /// JSON of the nine coefficients of irradiance over π that engines' shaders take; with --up y --rotate-z-deg -90 the light
    /// lies as Filament's cmgen lays the same map
    Engine,
}

/// Whose signs, order and scale.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum ShConvention {
    /// Orthonormal, without the Condon-Shortley sign: band 1 is 0.4886 (y, z, x)
    #[default]
    Glimt,
    /// With it: (-1)^m
    CondonShortley,
    /// As DirectXMath's spherical harmonics; the axes stay right-handed
    Directx,
    /// Nine coefficients of irradiance over π, the constants folded in: three bands, whatever --bands says above that
    Filament,
}

/// The axis that points up.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Up {
    /// As light maps are read
    #[default]
    Z,
    /// As glTF's worlds stand
    Y,
}

/// Reads the width of a window; 0 is none.
fn window(text: &str) -> Result<f32, String> {
    if text == "off" {
        return Ok(0.0);
    }
    let width: Option<f32> = text.parse().ok();
    let width = width.filter(|width| (0.1..=1e6).contains(width));
    width.ok_or_else(|| "a window is between 0.1 and 1000000 bands wide, or off".to_owned())
}

/// Reads the weight of the frame before.
fn alpha(text: &str) -> Result<f32, String> {
    let alpha: Option<f32> = text.parse().ok();
    alpha
        .filter(|alpha| (0.0..=1e6).contains(alpha))
        .ok_or_else(|| "a weight is between 0 and 1000000".to_owned())
}

/// Reads an angle.
fn degrees(text: &str) -> Result<f32, String> {
    let angle: Option<f32> = text.parse().ok();
    angle
        .filter(|angle| angle.is_finite())
        .ok_or_else(|| "an angle is a number of degrees, as -90".to_owned())
}

/// Reads a size.
fn map_size(text: &str) -> Result<UVec2, String> {
    let sides = text.split_once(['x', '×', ',']).and_then(|(w, h)| {
        let side = |word: &str| word.trim().parse().ok();
        Some(UVec2::new(side(w)?, side(h)?))
    });
    sides.ok_or_else(|| "a size is a width and a height, as 1024x512".to_owned())
}

/// Reads a time that is not zero.
fn seconds(text: &str) -> Result<Duration, String> {
    let seconds: Option<f64> = text.parse().ok();
    seconds
        .filter(|seconds| (0.2..=1e6).contains(seconds))
        .map(Duration::from_secs_f64)
        .ok_or_else(|| "a wait is between 0.2 and 1000000 seconds".to_owned())
}

/// Reads how far the picture may be behind.
fn lag(text: &str) -> Result<Duration, String> {
    let seconds: Option<f64> = text.parse().ok();
    seconds
        .filter(|seconds| (0.0..=1e6).contains(seconds))
        .map(Duration::from_secs_f64)
        .ok_or_else(|| "a lag is between 0 and 1000000 seconds".to_owned())
}

/// Reads a time of a frame.
fn milliseconds(text: &str) -> Result<f64, String> {
    let value: Option<f64> = text.parse().ok();
    value
        .filter(|ms| (0.01..=1e7).contains(ms))
        .ok_or_else(|| "a frame's time is between 0.01 and 10000000 milliseconds".to_owned())
}

/// Reads a time for the reference.
fn reference_seconds(text: &str) -> Result<f64, String> {
    let value: Option<f64> = text.parse().ok();
    value
        .filter(|s| (0.0..=1e8).contains(s))
        .ok_or_else(|| "a time is between 0 and 100000000 seconds".to_owned())
}

/// Reads a seed.
fn seed(text: &str) -> Result<u32, String> {
    text.parse()
        .map_err(|_| format!("a seed is a whole number from 0 to {}", u32::MAX))
}

/// Where to render.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Device {
    /// The GPU where a real one is found, else the CPU
    #[default]
    Auto,
    /// The CPU
    Cpu,
    /// The GPU, or an error
    Gpu,
}

const EXIT_STATUS: &str = "\
Exit status:
  0  everything that was asked for is written
  1  a fault of the program
  2  the command line or the shot is wrong
  3  an input file is missing or broken
  4  an output cannot be written
  5  the device cannot render this
  130, 143  SIGINT or SIGTERM ended it; all files are whole, and the same command continues

Start with `glimt demo`; `glimt help render` shows examples.";

const RENDER_EXAMPLES: &str = "\
Examples:
  glimt render shot.toml
  glimt render shot.toml --frames 1-24 --out /tmp/draft --set image.rays_per_pixel=4
  glimt render shot.toml --frames 1-96x8                # every eighth frame; -5--1 are the frames before 0
  glimt render shot.toml --device gpu --seed 7 --json
  glimt render shot.toml --follow --wait 30             # frames as they are filmed, until none comes for 30 s
  glimt render shot.toml --method cells --frames 1-48 --state-out half.state
  glimt render shot.toml --method cells --frames 49-96 --state-in half.state     # as if in one run
  glimt render shot.toml --method cells --frames 60-72 --preroll 10
  glimt render shot.toml --method prt --set render.prt.temporal=0.5            # after glimt bake shot.toml
  glimt render shot.toml --set object.0.material.diffuse=[0.8,0.2,0.1] --set render.preset=kronander

A shot needs a light and an object; every other key has a default:
  [probe]
  frames = \"capture/light.####.exr\"   # also light.%04d.exr, light.$F4.exr, light.@@@@.exr; one file is a still
  [[object]]
  mesh = \"model.glb\"                  # .glb .gltf .obj .ply .stl, or \"sphere\", \"plane\", \"helicopter\"
  ground = true
  [[object.spin]]                       # what moves: spinning nodes, glTF animations (which play by themselves), keyframes
  node = \"rotor\"
  deg_per_frame = 37
  [[camera.key]]
  frame = 1
  eye = [6, -4, 2]
  target = [0, 0, 1]

Over footage, with what it shows already as a shadow catcher:
  [backplate]
  frames = \"plate/plate.####.png\"     # .png .jpg .exr; one file is a still
  [[object]]
  mesh = \"plane\"
  scale = 20
  catcher = true";

const COMPARE_EXAMPLES: &str = "\
Examples:
  glimt compare shot.toml                                at the time that 15 + 15 samples take, into compare/
  glimt compare shot.toml --equal-time 40 --measure 5,90 --seeds 32
  glimt compare shot.toml --equal-samples --preset stratified --preset owen-sobol
  glimt compare shot.toml --preset kronander --contestant 'ours: render.pattern=owen-sobol image.rays_per_pixel=8'
  glimt compare shot.toml --frames 1-90 --stride 10 --reference-time 600 --keep --json
  glimt compare shot.toml --reference compare/reference  # what --keep wrote

Each contestant needs --seeds frames for every measured frame and the one before it; SMC, which continues from frame to frame,
all frames of --frames up to the last that is measured.";

const BAKE_EXAMPLES: &str = "\
Examples:
  glimt bake shot.toml                                   into shot.prt.glb, which render.method = \"prt\" looks for
  glimt bake shot.toml --directions 100 -o draft.prt.glb
  glimt bake shot.toml --bands 3 --set object.1.subdivide=7 --device gpu --json

Transfer is known at vertices alone, and a built-in plane has four. This cuts it into 8192 triangles:
  [[object]]
  mesh = \"plane\"
  subdivide = 6
  [render.prt]
  bands = 5
  directions = 2500";

const DEMO_EXAMPLES: &str = "\
Examples:
  glimt demo
  glimt demo --frames 1-4 --out /tmp/demo --set image.rays_per_pixel=64";

const SYNTH_EXAMPLES: &str = "\
Examples:
  glimt synth                                the built-in sky, 24 frames of 2400 x 1700
  glimt synth light.hdr --out capture --frames 1-4
  glimt synth light.hdr --set capture.size=[640,450] --set capture.pixel_um=18.75
  glimt synth synth.toml --device gpu --seed 7

Every key has a default; a file names those that differ:
  frames = 48
  [light]
  map = \"light.hdr\"
  [capture]
  radius_mm = 40                           # on = false films no ball: the maps of an ideal probe are the light
  jitter_px = 5
  [stage]                                  # at a finite distance, moving shows another parallax
  shape = \"box\"
  size_m = [12, 8, 6]
  to_m = [1, 0, 0]
  [sun]                                    # the map's own sun, moved
  from_deg = [80, 10]
  to_deg = [20, 50]
  [[lamp]]
  azimuth_deg = 200
  to_azimuth_deg = 560                     # once round until the last frame
  flicker = 0.5
  [clouds]
  cover = 0.4
  [occluder]
  radius_m = 0.3";

const UNWARP_EXAMPLES: &str = "\
Examples:
  glimt unwarp 'capture/ball.####.exr' --out light
  glimt unwarp 'capture/ball.####.exr' --size 1628x814 --distance-mm 1250 --radius-mm 40 --set rig_deg=6
  glimt unwarp ball.jpg --distance-mm 400 --radius-mm 50
  glimt unwarp ball.exr --set centre_px=[1200,850] --set radius_px=800

Film can light a shot without this: [probe] mapping = \"mirror-ball\" does the same on the way.";

const INFO_EXAMPLES: &str = "\
Examples:
  glimt info                  devices and versions
  glimt info light.0001.exr   size, channels, stops, brightest direction, bad texels
  glimt info model.glb        triangles, bounds, materials, nodes, animations, cameras
  glimt info shot.toml        the shot with all its defaults";

const SH_EXAMPLES: &str = "\
Examples:
  glimt sh light.hdr                                             25 coefficients of each colour, as CSV
  glimt sh 'capture/light.####.exr' --frames 1-96 -o light.csv
  glimt sh 'capture/light.####.exr' --bands 4 --window 4 --temporal 0.5 --format json -o light.json
  glimt sh shot.toml --format engine --up y -o diffuse.json      for an engine: nine coefficients, y up
  glimt sh light.hdr --format engine --up y --rotate-z-deg -90   the same, turned as Filament's cmgen turns the map
  glimt sh day.exr dusk.exr night.exr --convention directx

In what is written, the first lines of csv and the key `meaning` of JSON say what the numbers are, and where the map lies in their
axes. These are right-handed in all conventions.";
