//! Host file: what renders contestants: one device, one scene, the light of every frame.

use super::contestants::Contestant;
use super::lineage::Lineage;
use super::shadow_rays::ShadowRays;
use crate::bake;
use crate::cli::Device;
use crate::device::{self, Renderers};
use crate::error::{Error, Kind, Result};
use crate::job::Job;
use crate::notes::Notes;
use crate::report::Reporter;
use crate::setup::Setup;
use crate::shot::digest::Hash;
use crate::shot::{self, Shot};
use glam::{UVec2, Vec3, Vec4};
use glimt_render_gpu::kernels::film::tonemap;
use glimt_render_gpu::prepare::env::PreparedEnv;
use glimt_render_gpu::prepare::render::RenderSettings;
use glimt_render_gpu::prepare::scene_build::SceneBuffers;
use std::collections::HashMap;
use std::sync::Arc;
use std::time::Instant;

/// Lights are kept while they take no more than this.
const LIGHT_BYTES: usize = 2 << 30;

/// A frame that was rendered.
#[derive(Clone, Debug)]
pub struct Rendered {
    /// Its number.
    pub frame: i32,
    /// The seed that it was rendered with.
    pub seed: u32,
    /// Radiance of what reflects light, objects and catchers both; alpha is how much of the pixel they cover.
    pub pixels: Vec<Vec4>,
    /// Seconds that the renderer took.
    pub seconds: f64,
    /// Where they went, where the renderer knows.
    pub phases: Vec<(&'static str, f64)>,
    /// How its rays fare, where they continue from frame to frame.
    pub lineage: Option<Lineage>,
    /// Its shadow rays, where the method chose their number.
    pub rays: Option<ShadowRays>,
}

/// Renders frames of contestants: the device, the scene, and the lights.
pub struct TrialRenderer<'a> {
    /// The shot.
    pub job: Job,
    renderers: Renderers,
    scene: SceneBuffers,
    /// File and bands of the transfer that the scene has.
    transfer: Option<(String, u32)>,
    lights: LightCache,
    reporter: &'a Reporter,
}

impl<'a> TrialRenderer<'a> {
    /// Opens a device for a job.
    ///
    /// # Errors
    /// The scene is refused, or the device is not there.
    pub fn open(
        mut job: Job,
        device: Device,
        notes: Notes,
        reporter: &'a Reporter,
    ) -> Result<Self> {
        // Whatever the shot's own method, contestants have others.
        job.setup.all_tables = true;
        let scene = job.setup.build_scene()?;
        Ok(Self {
            renderers: device::open(device)?,
            scene,
            transfer: None,
            lights: LightCache {
                notes,
                hashes: job.light_hashes()?,
                kept: Vec::new(),
                bytes: 0,
            },
            reporter,
            job,
        })
    }

    /// The device's name.
    #[must_use]
    pub fn device(&self) -> String {
        self.renderers.name()
    }

    /// Width and height of the image.
    #[must_use]
    pub fn size(&self) -> UVec2 {
        self.job.setup.size()
    }

    /// Settings of a frame, by the keys of another shot of the same scene.
    ///
    /// # Errors
    /// The camera sees nothing then.
    pub fn settings(&self, shot: &Shot, frame: i32, seed: u32) -> Result<RenderSettings> {
        let camera = self.job.setup.camera(frame)?;
        let settings = Setup::settings_of(shot, frame, camera);
        Ok(RenderSettings {
            seed,
            // What falls on catchers is a layer.
            layers: self.scene.has_catcher(),
            diagnostics: settings.method.has_diagnostics(),
            ..settings
        })
    }

    /// Whether the renderer accepts a contestant.
    ///
    /// # Errors
    /// It does not.
    pub fn check(&mut self, contestant: &Contestant) -> Result<()> {
        let settings = self.settings(&contestant.shot, self.job.frames[0], 1)?;
        self.load_transfer(&contestant.shot)?;
        settings
            .frame_params()
            .map(drop)
            .map_err(|e| contestant.refused(e))
    }

    /// Loads the transfer of a contestant into the scene, where it is rendered by one that the scene does not have yet.
    fn load_transfer(&mut self, shot: &Shot) -> Result<()> {
        let wanted = (shot.render.prt.bake.clone(), shot.render.prt.bands);
        if shot.render.method != shot::Method::Prt || self.transfer.as_ref() == Some(&wanted) {
            return Ok(());
        }
        bake::refuse_motion(&self.job.setup)?;
        bake::set_transfer(&self.job.setup, shot, &mut self.scene)?;
        self.transfer = Some(wanted);
        Ok(())
    }

    /// Renders a frame. Reading the light and moving the scene are not part of its time.
    ///
    /// # Errors
    /// The light cannot be read, or the device fails.
    pub fn render(&mut self, shot: &Shot, frame: i32, seed: u32) -> Result<Rendered> {
        let light = self.lights.of(&self.job, frame)?;
        self.reporter.notes(self.lights.notes.take());
        let settings = self.settings(shot, frame, seed)?;
        self.load_transfer(shot)?;
        let setup = &self.job.setup;
        let refused = |e| setup.refused_scene(frame, &e);
        let pose = setup.pose(frame)?;
        self.scene
            .pose_shaped(&pose.transforms, &pose.shapes)
            .map_err(refused)?;
        let renderer = self.renderers.of(shot)?;
        let began = Instant::now();
        let image = renderer
            .render_frame(&self.scene, &light, &settings, &|_| ())
            .map_err(device::failure)?;
        let seconds = began.elapsed().as_secs_f64();
        let diagnostics = image.diagnostics.as_ref();
        let lineage = diagnostics.and_then(|all| Lineage::of(all, settings.rays_per_pixel));
        let rays = diagnostics.and_then(ShadowRays::of);
        let mut pixels = image.linear;
        if let Some(layers) = image.layers {
            for (pixel, layer) in pixels.iter_mut().zip(&layers) {
                let radiance = layer.object.truncate() + layer.lit;
                *pixel = radiance.extend((layer.object.w + layer.catcher).min(1.0));
            }
        }
        let bad = |p: &Vec4| !p.is_finite();
        if let Some(at) = pixels.iter().position(bad) {
            let (x, y) = (at as u32 % image.size.x, at as u32 / image.size.x);
            return Err(Error::new(
                Kind::Internal,
                format!("pixel ({x}, {y}) of frame {frame} is not a number"),
            )
            .fix("please report it, with the shot"));
        }
        let phases = renderer.phases();
        Ok(Rendered {
            frame,
            seed,
            pixels,
            seconds,
            lineage,
            rays,
            phases: phases
                .into_iter()
                .map(|(name, time)| (name, time.as_secs_f64()))
                .collect(),
        })
    }

    /// Forgets the last frame: a contestant that continues from frame to frame begins again in the next.
    pub fn forget_past(&mut self) {
        self.renderers.forget();
    }

    /// What is displayed of radiance, over black.
    ///
    /// # Errors
    /// The shot's settings are refused.
    pub fn display(&self, shot: &Shot, pixels: &[Vec4]) -> Result<Vec<u8>> {
        let frame = self.job.frames[0];
        let settings = self.settings(shot, frame, 1)?.frame_params();
        let params = settings.map_err(|e| Error::new(Kind::Usage, e))?;
        let codes: Vec<[u8; 4]> = (0..pixels.len() as u32)
            .map(|i| tonemap(i, &params, pixels).to_le_bytes())
            .collect();
        Ok(crate::output::rgb_over_black(&codes))
    }
}

/// Lights with their tables, those of the first frames that fit.
struct LightCache {
    notes: Notes,
    /// Of each frame's light, as the identities of what is kept count them.
    hashes: HashMap<i32, Hash>,
    kept: Vec<(i32, Arc<PreparedEnv>)>,
    bytes: usize,
}

impl LightCache {
    fn of(&mut self, job: &Job, frame: i32) -> Result<Arc<PreparedEnv>> {
        let key = if job.is_still() { 0 } else { frame };
        if let Some((_, light)) = self.kept.iter().find(|(f, _)| *f == key) {
            return Ok(Arc::clone(light));
        }
        let (light, hash) = job.light(frame, &mut self.notes)?;
        if self.hashes.get(&frame).is_some_and(|known| *known != hash) {
            let what = format!("the light of frame {frame} changed while it was compared");
            return Err(Error::new(Kind::Input, what).fix("run it again"));
        }
        let light = Arc::new(light);
        // Frames are gone through in order, again and again: to drop the oldest for the newest would keep none.
        let size = light.view().size;
        let texels = size.x as usize * size.y as usize;
        let bytes = texels * (size_of::<Vec4>() + 2 * size_of::<u32>());
        if self.kept.is_empty() || self.bytes + bytes <= LIGHT_BYTES {
            self.bytes += bytes;
            self.kept.push((key, Arc::clone(&light)));
        }
        Ok(light)
    }
}

/// The luminance of a pixel.
#[must_use]
pub fn luminance_of(pixel: Vec4) -> f64 {
    let colour: Vec3 = pixel.truncate();
    f64::from(glimt_sampling::luminance(colour))
}
