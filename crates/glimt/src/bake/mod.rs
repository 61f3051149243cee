//! Host file: `glimt bake`: transfer at the vertices of a shot (Hajisharif 2012), kept in a file that rendering reads.

pub mod file;
pub mod glb;
pub mod identity;
pub mod memory;
pub mod stored;

use crate::cli::{BakeFlags, RenderFlags, WriteFlags};
use crate::device::{self, Processor};
use crate::error::{Error, Kind, Result};
use crate::memory::in_words;
use crate::notes::Notes;
use crate::output::atomic;
use crate::output::target::is_ours;
use crate::printable::path_in_line;
use crate::report::{Reporter, count, shown};
use crate::setup::Setup;
use crate::shot::digest;
use crate::shot::parse::Source;
use crate::shot::{Method, Shot, check, parse, range};
use file::FilePlan;
use glimt_render_gpu::gpu;
use glimt_render_gpu::prepare::bake::{self, BakeError, BakeSettings, Baked};
use glimt_render_gpu::prepare::scene_build::SceneBuffers;
use glimt_render_gpu::prepare::transfer::{Transfer, TransferError};
use identity::Header;
use memory::Need;
use serde_json::json;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};
use stored::Stored;

/// The file of a shot's transfer: as `render.prt.bake` says, else beside the shot, `SHOT.prt.glb`.
#[must_use]
pub fn file_of(shot: &Shot, source: &Source) -> PathBuf {
    match shot.render.prt.bake.as_str() {
        "" => source.file.with_extension("prt.glb"),
        name => source.folder().join(name),
    }
}

/// How a shot wants its transfer computed.
#[must_use]
pub fn settings_of(shot: &Shot) -> BakeSettings {
    BakeSettings {
        bands: shot.render.prt.bands,
        directions: shot.render.prt.directions,
        seed: shot.render.seed,
    }
}

/// The transfer of `scene`, which was built of the shot's, from a file that `glimt bake` wrote. It must be of this geometry, where
/// it stands, and of as many bands as the shot says; how many directions it was computed from is left to the file.
///
/// # Errors
/// The file is not there, not whole, of something else, of other bands, or holds what is not a number. Each error names it, and
/// the command that makes it again.
pub fn load(setup: &Setup, shot: &Shot, scene: &SceneBuffers, file: &Path) -> Result<Transfer> {
    let command = bake_command(setup, shot);
    let stored = Stored::open(file).map_err(|e| {
        // What is something else is not written over.
        match is_ours(file) {
            Ok(true) | Err(_) => e.fix(&command),
            Ok(false) => e.fix(format!(
                "remove it, or name another file by render.prt.bake; then {command}"
            )),
        }
    })?;
    let settings = settings_of(shot);
    let now = Header::new(scene, &settings);
    if let Some(difference) = now.differs(stored.header()) {
        let error = Error::input(file, format!("it is stale: {}", difference.what)).fix(&command);
        return Err(match difference.object {
            Some(object) => error.at(named(setup, &now, object)),
            None => error,
        });
    }
    let (found, wanted) = (stored.header().bands, settings.bands);
    if found != wanted {
        let what = format!("it has {found} bands, and render.prt.bands is {wanted}");
        return Err(
            Error::input(file, what).fix(format!("{command}, or set render.prt.bands={found}"))
        );
    }
    let transfer = stored.transfer().map_err(|e| match e.kind {
        Kind::Input => e.fix(&command),
        _ => e,
    })?;
    match transfer.check(scene.vertex_counts().iter().sum()) {
        Ok(()) => Ok(transfer),
        Err(TransferError::NotFinite(vertex)) => {
            let (object, vertex) = place_of(&now, vertex);
            let what = format!("a coefficient of vertex {vertex} is not a finite number");
            let whose = named(setup, &now, object);
            Err(Error::input(file, what).at(whose).fix(command))
        }
        Err(e) => Err(Error::input(file, e).fix(command)),
    }
}

/// Where a shot is rendered by precomputed transfer: sees that nothing moves, and makes the transfer's file a part of the identity
/// of its frames.
///
/// # Errors
/// Something moves, or the file is not there.
pub fn expect(setup: &mut Setup) -> Result<()> {
    if setup.shot.render.method != Method::Prt {
        return Ok(());
    }
    refuse_motion(setup)?;
    let hash = hash_of(&setup.shot, &setup.source)?;
    let file = file_of(&setup.shot, &setup.source);
    setup.guard.reads("the shot's transfer", &file);
    setup.digest = digest::join([&setup.digest, &hash]);
    setup.transfer = Some(hash);
    Ok(())
}

/// The hash of a shot's transfer: no other key says what it is.
///
/// # Errors
/// The file is not there.
pub fn hash_of(shot: &Shot, source: &Source) -> Result<digest::Hash> {
    digest::of_file(&file_of(shot, source))
        .map_err(|e| e.fix(command_with_keys(source, Vec::new())))
}

/// Sets the transfer of a scene, which was built of the setup's, where `shot` is rendered by it. The keys of `shot` may differ from
/// the setup's under `render`.
///
/// # Errors
/// As [`load`].
pub fn set_transfer(setup: &Setup, shot: &Shot, scene: &mut SceneBuffers) -> Result<()> {
    if shot.render.method != Method::Prt {
        return Ok(());
    }
    let file = file_of(shot, &setup.source);
    let transfer = Arc::new(load(setup, shot, scene, &file)?);
    if setup
        .transfer
        .is_some_and(|known| hash_of(shot, &setup.source).ok() != Some(known))
    {
        let what = "it was replaced since the run began";
        return Err(Error::input(&file, what).fix("run it again"));
    }
    let objects = &shot.objects;
    let owners = setup.owners.iter();
    let reflections: Vec<f32> = owners.map(|&of_shot| objects[of_shot].reflection).collect();
    scene
        .set_transfer(transfer, &reflections)
        .map_err(|e| Error::input(&file, e).fix(bake_command(setup, shot)))
}

/// The command that makes a transfer that can be used, with what was set on the command line and changes its result.
fn bake_command(setup: &Setup, shot: &Shot) -> String {
    let mut more = Vec::new();
    // A comparison's contestants have keys of their own.
    let (own, common) = (&shot.render.prt, &setup.shot.render.prt);
    if own.bands != common.bands {
        more.push(format!("render.prt.bands={}", own.bands));
    }
    if own.bake != common.bake {
        more.push(format!("render.prt.bake={}", own.bake));
    }
    command_with_keys(&setup.source, more)
}

/// The command that makes a shot's transfer, with `more` keys beside those that were set.
fn command_with_keys(source: &Source, more: Vec<String>) -> String {
    let set = source.overrides_of(&["object", "render.prt"]);
    let set = set.map(str::to_owned).chain(more);
    let set: String = set
        .map(|item| format!(" --set {}", quoted(&item)))
        .collect();
    let file = quoted(&source.file.display().to_string());
    format!("run `glimt bake {file}{set}`")
}

/// A word as a shell takes it.
fn quoted(word: &str) -> String {
    let is_plain = |c: char| c.is_alphanumeric() || "._-/=,:+@%".contains(c);
    match !word.is_empty() && word.chars().all(is_plain) {
        true => word.to_owned(),
        false => format!("'{}'", word.replace('\'', "'\\''")),
    }
}

/// The object that a vertex of the scene belongs to, and its number there.
fn place_of(header: &Header, mut vertex: usize) -> (usize, usize) {
    for (object, identity) in header.objects.iter().enumerate() {
        let count = identity.vertices as usize;
        if vertex < count {
            return (object, vertex);
        }
        vertex -= count;
    }
    (0, vertex)
}

/// An object of the scene, as the shot's user knows it.
fn named(setup: &Setup, header: &Header, object: usize) -> String {
    let of_shot = setup.owners.get(object).copied().unwrap_or(object);
    match header.objects[object].name.as_str() {
        "" => format!("object.{of_shot}"),
        name => format!("object.{of_shot} (`{name}`)"),
    }
}

/// Computes the transfer of a shot and writes it, unless it is there already.
///
/// # Errors
/// The shot is wrong, something in it moves, there is not enough memory, or the file cannot be written.
pub fn run(shot: &Path, flags: &BakeFlags, reporter: &Reporter) -> Result<()> {
    let mut notes = Notes::new(flags.strict);
    reporter.busy("reading the shot's meshes");
    let setup = read_shot(shot, flags, &mut notes);
    reporter.notes(notes.take());
    let setup = setup?;
    refuse_motion(&setup)?;
    let out = flags.out.clone();
    let out = out.unwrap_or_else(|| file_of(&setup.shot, &setup.source));
    let target = setup.guard.target(&out)?;
    let settings = settings_of(&setup.shot);
    let need = Need::of(&setup.scene, settings.bands);
    let (vertices, triangles, memory) = (need.vertices, need.triangles, need.bytes);
    let size = file::size(vertices, triangles, settings.bands);
    reporter.step(&format!(
        "{vertices} vertices of {triangles} triangles: {} of memory, a file of {}",
        in_words(memory),
        in_words(size),
    ));
    if size > u64::from(u32::MAX) {
        return Err(file::too_long(&out, size));
    }
    need.check()?;
    reporter.busy("building the tree of the triangles");
    let scene = setup.build_scene()?;
    let header = Header::new(&scene, &settings);
    if is_there(&out, &header) {
        let summary = json!({
            "skipped": true, "vertices": vertices, "triangles": triangles, "file": shown(&out),
        });
        let text = format!(
            "there already, of this geometry and these settings: {}",
            path_in_line(&out)
        );
        reporter.finish(summary, &text);
        return Ok(());
    }
    let plan = FilePlan::new(&out, &scene, &header)?;
    let processor = device::open_processor(flags.device)?;
    // What cannot be written is not computed.
    atomic::prepare_folder_of(&target)?;
    let pending = plan.begin(&target)?;
    reporter.step(&format!(
        "{} in {}, on {}",
        count(settings.directions as usize, "direction"),
        count(settings.bands as usize, "band"),
        processor.name(),
    ));
    reporter.start_bar();
    let began = Instant::now();
    let baked = compute(&processor, &scene, &settings, reporter)?;
    let seconds = began.elapsed().as_secs_f64();
    let Baked {
        transfer,
        vertices: at,
        rays,
    } = baked;
    plan.write(pending, &scene, &at, &transfer)?;
    let size = plan.size();
    let rate = rays as f64 / seconds.max(1e-9);
    let summary = json!({
        "skipped": false, "vertices": vertices, "triangles": triangles, "rays": rays, "seconds": seconds,
        "rays_per_second": rate, "memory": memory, "bytes": size, "file": shown(&out),
    });
    let text = format!(
        "{vertices} vertices, {rays} rays in {seconds:.1} s, {:.2} million a second; {}: {}",
        rate / 1e6,
        in_words(size),
        path_in_line(&out)
    );
    reporter.finish(summary, &text);
    Ok(())
}

/// Whether a file holds the transfer that a header describes, whole and in finite numbers.
fn is_there(file: &Path, header: &Header) -> bool {
    let vertices: u64 = header.objects.iter().map(|o| o.vertices).sum();
    Stored::open(file)
        .ok()
        .filter(|stored| stored.header() == header)
        .and_then(|stored| stored.transfer().ok())
        .is_some_and(|transfer| transfer.check(vertices as usize).is_ok())
}

/// The shot with its meshes; neither light nor footage is looked at.
fn read_shot(file: &Path, flags: &BakeFlags, notes: &mut Notes) -> Result<Setup> {
    let keys = [("bands", &flags.bands), ("directions", &flags.directions)];
    let own = keys.into_iter().filter_map(|(key, value)| {
        let value = value.as_ref()?;
        Some(format!("render.prt.{key}={value}"))
    });
    let set: Vec<String> = flags.set.iter().cloned().chain(own).collect();
    let (shot, source) = parse::read::<Shot>(file, &set)?;
    check::check(&shot, &source)?;
    let first = match shot.render.frames.as_str() {
        "" => 1,
        text => range::parse(text)?[0],
    };
    let write = WriteFlags {
        overwrite: flags.overwrite,
        ..WriteFlags::default()
    };
    let flags = RenderFlags {
        write,
        ..RenderFlags::default()
    };
    Setup::load(shot, source, first, &flags, notes)
}

/// Transfer is of objects that stand still; cameras may move, those of mesh files among them.
///
/// # Errors
/// One moves; the error names the key by which it does.
pub fn refuse_motion(setup: &Setup) -> Result<()> {
    let Some((object, key, what)) = setup.moving_object() else {
        return Ok(());
    };
    let fix = match key {
        "animation" => "set it to \"off\"",
        _ => "remove it",
    };
    let what =
        format!("the object moves ({what}), and precomputed transfer is of what stands still");
    Err(setup
        .source
        .error(&format!("object.{object}.{key}"), what)
        .fix(format!("{fix}, or render by another method")))
}

fn compute(
    processor: &Processor,
    scene: &SceneBuffers,
    settings: &BakeSettings,
    reporter: &Reporter,
) -> Result<Baked> {
    let clock = Mutex::new(Clock::new());
    let report = |share: f32| {
        let mut clock = clock
            .lock()
            .unwrap_or_else(std::sync::PoisonError::into_inner);
        clock.report(reporter, f64::from(share));
    };
    let baked = match processor {
        Processor::Cpu => bake::bake(scene, settings, &report),
        Processor::Gpu(context) => gpu::bake(context, scene, settings, &report),
    };
    baked.map_err(|e| match &e {
        BakeError::Memory { .. } => {
            Error::device(e).fix("lower render.prt.bands or object.N.subdivide")
        }
        BakeError::Gpu(gpu) => device::gpu_failure(gpu),
        _ => Error::usage(e),
    })
}

/// Reports progress, not too often.
struct Clock {
    began: Instant,
    reported: Instant,
    share: f64,
}

impl Clock {
    fn new() -> Self {
        let now = Instant::now();
        Self {
            began: now,
            reported: now,
            share: 0.0,
        }
    }

    fn report(&mut self, reporter: &Reporter, share: f64) {
        let every = match reporter.draws() {
            true => Duration::from_millis(100),
            false => Duration::from_secs(5),
        };
        // Threads may come in another order than they counted.
        if share <= self.share || self.reported.elapsed() < every {
            return;
        }
        self.reported = Instant::now();
        self.share = share;
        let left = self.began.elapsed().as_secs_f64() * (1.0 - share) / share;
        reporter.progress("transfer", share, Some(left));
    }
}
