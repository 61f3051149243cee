//! Host file: frames on the CPU: tiles are shared out among rayon's threads, and each thread runs the passes of its tile.

mod drawing;
mod tiles;

use glimt_executor::{Chunks, Cpu, Host, Rayon, Serial};

use crate::kernels::smc::SmcHealth;
use crate::methods::smc::{Following, Own};
use crate::methods::{Before, Inputs, Method, MethodMemory, Points, Work};
use crate::prepare::env::PreparedEnv;
use crate::prepare::plate::Plate;
use crate::prepare::render::{FrameImage, RenderError, RenderSettings, Renderer};
use crate::prepare::scene_build::SceneBuffers;
use crate::prepare::smc_state::PastFrame;

pub use drawing::CpuDrawing;
use tiles::{Image, Job};

/// Renders on all of rayon's threads by tracing rays.
#[derive(Debug)]
pub struct CpuRenderer {
    /// Pixels in a tile, a run of the image's pixels. It changes no bit of the image, only how work is shared out.
    pub tile_pixels: usize,
    /// What the sequential sampler continues from.
    following: Option<Following<Host>>,
}

impl Default for CpuRenderer {
    fn default() -> Self {
        Self::with_tiles(tiles::PIXELS)
    }
}

impl CpuRenderer {
    /// A renderer with tiles of so many pixels.
    #[must_use]
    pub fn with_tiles(tile_pixels: usize) -> Self {
        Self {
            tile_pixels,
            following: None,
        }
    }

    /// The rays of the frame that is to come, by a method that keeps them.
    fn begin(
        &mut self,
        scene: &SceneBuffers,
        env: &PreparedEnv,
        settings: &RenderSettings,
    ) -> Result<Option<Following<Host>>, RenderError> {
        let Method::Smc(smc) = &settings.method else {
            return Ok(None);
        };
        let known = self.following.take();
        let mut begun = Following::begin(known, &Cpu, scene, env, settings, smc)?;
        begun.clear(&Cpu).map_err(RenderError::device)?;
        Ok(Some(begun))
    }
}

impl Renderer for CpuRenderer {
    fn name(&self) -> String {
        tiles::name()
    }

    fn render_over(
        &mut self,
        scene: &SceneBuffers,
        env: &PreparedEnv,
        plate: Option<&Plate>,
        settings: &RenderSettings,
        progress: &(dyn Fn(f32) + Sync),
    ) -> Result<FrameImage, RenderError> {
        let whole = settings.frame_params_over(plate)?;
        let light = env.view_for(&settings.method)?;
        let mut following = self.begin(scene, env, settings)?;
        let view = following.as_ref().map(|f| f.window(u64::MAX, 0, 0));
        let job = Job::new(whole, light, scene, plate, settings);
        let inputs = Inputs {
            frame: &whole,
            env: job.env.shorten(),
            scene: job.scene.shorten(),
        };
        let before = Before::find(&Cpu, &mut Rayon::default(), inputs, settings);
        let before = before.map_err(RenderError::device)?;
        let mut image = Image::new(settings).map_err(RenderError::device)?;
        let (own, reading) = match &mut following {
            Some(following) => {
                let particles = following.particles() as usize;
                let (now, reading) = following.parts();
                let own = Own::<Host> {
                    states: Chunks::new(&mut now.states, 1),
                    particles: Chunks::new(&mut now.particles, particles),
                };
                (Some(own), Some(reading))
            }
            None => (None, None),
        };
        let done = job.render(
            self.tile_pixels,
            own,
            &mut image,
            progress,
            &|tile, samples| {
                let (frame, rays) = (&tile.frame, tile.rays);
                let work = match (&reading, &view, tile.own, tile.points) {
                    (Some(reading), Some(view), Some(own), Points::Smc(points)) => {
                        let points = Chunks::new(points, 1);
                        Work::Smc(reading.tile(view, tile.pixels, points, own.shorten()))
                    }
                    (_, _, _, points) => points.work(&before, rays),
                };
                let (env, scene) = (job.env.shorten(), job.scene.shorten());
                let inputs = Inputs { frame, env, scene };
                let out = samples.out(rays);
                settings.method.shade(work, &mut Serial, inputs, rays, out)
            },
        );
        done.map_err(RenderError::device)?;
        let mut diagnostics = None;
        if let (Some(mut following), Method::Smc(smc)) = (following, &settings.method) {
            if settings.diagnostics {
                let pixels = whole.width * whole.height;
                let rays = pixels as usize * whole.rays_per_pixel as usize;
                let mut list = vec![SmcHealth::default(); pixels as usize];
                let out = Chunks::new(&mut list, 1);
                following
                    .diagnose(&mut Rayon::default(), &whole, 0..rays, out, pixels)
                    .map_err(RenderError::device)?;
                diagnostics = Some(list);
            }
            *following.light_mut() = env.view().texels.to_vec();
            let past = PastFrame::new(settings, smc, scene, env)?;
            following.end(past, env.view().map());
            self.following = Some(following);
        }
        Ok(image.finish(settings, diagnostics))
    }

    fn memory(&mut self) -> Result<Option<MethodMemory>, RenderError> {
        let Some(following) = &self.following else {
            return Ok(None);
        };
        let state = following.read(&Cpu).map_err(RenderError::device)?;
        Ok(state.map(MethodMemory::Smc))
    }

    fn set_memory(&mut self, memory: MethodMemory) -> Result<(), RenderError> {
        let MethodMemory::Smc(state) = memory;
        let following = Following::resume(&Cpu, state);
        self.following = Some(following.map_err(RenderError::device)?);
        Ok(())
    }

    fn forget(&mut self) {
        self.following = None;
    }
}
