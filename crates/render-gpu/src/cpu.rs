//! Host file: frames on the CPU: tiles are shared out among rayon's threads, and each thread runs the passes of its tile.

mod drawing;
mod tiles;

use glimt_executor::{Chunks, Cpu, Host, Rayon, Serial};

use crate::kernels::smc::SmcHealth;
use crate::methods::cells::Reading;
use crate::methods::smc::Own;
use crate::methods::{Inputs, Kept, MethodMemory, Points, Work};
use crate::prepare::env::PreparedEnv;
use crate::prepare::past_frame::PastFrame;
use crate::prepare::plate::Plate;
use crate::prepare::render::{Diagnostics, FrameImage, RenderError, RenderSettings, Renderer};
use crate::prepare::scene_build::SceneBuffers;

pub use drawing::CpuDrawing;
use tiles::{Image, Job};

/// Renders on all of rayon's threads by tracing rays.
#[derive(Debug)]
pub struct CpuRenderer {
    /// Pixels in a tile, a run of the image's pixels. It changes no bit of the image, only how work is shared out.
    pub tile_pixels: usize,
    /// What the next frame continues from.
    kept: Kept<Host>,
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
            kept: Kept::Nothing,
        }
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
        let known = std::mem::replace(&mut self.kept, Kept::Nothing);
        let mut kept = known.begin(&Cpu, scene, Some(env), settings)?;
        let job = Job::new(whole, light, scene, plate, settings);
        let inputs = Inputs {
            frame: &whole,
            env: job.env.shorten(),
            scene: job.scene.shorten(),
        };
        let mut image = Image::new(settings).map_err(RenderError::device)?;
        let (mut own, mut view, mut reading, mut counted) = (None, None, None, None);
        match &mut kept {
            Kept::Nothing => {}
            Kept::Cells(counting) => {
                let found = counting.find(&mut Rayon::default(), inputs);
                found.map_err(RenderError::device)?;
                counted = Some(counting.reading());
            }
            Kept::Smc(following) => {
                following.clear(&Cpu).map_err(RenderError::device)?;
                view = Some(following.window(u64::MAX, 0, 0));
                let particles = following.particles() as usize;
                let (now, past) = following.parts();
                own = Some(Own::<Host> {
                    states: Chunks::new(&mut now.states, 1),
                    particles: Chunks::new(&mut now.particles, particles),
                });
                reading = Some(past);
            }
        }
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
                    (_, _, _, points) => points.work(counted.map(Reading::shorten), rays),
                };
                let (env, scene) = (job.env.shorten(), job.scene.shorten());
                let inputs = Inputs { frame, env, scene };
                let out = samples.out(rays);
                settings.method.shade(work, &mut Serial, inputs, rays, out)
            },
        );
        done.map_err(RenderError::device)?;
        let mut diagnostics = None;
        if !image.health.is_empty() {
            let pilot_rays = match &kept {
                Kept::Cells(counting) => counting.pilot_rays(&Cpu).map_err(RenderError::device)?,
                Kept::Nothing | Kept::Smc(_) => 0.0,
            };
            diagnostics = Some(Diagnostics::Groups {
                pixels: std::mem::take(&mut image.health),
                pilot_rays,
            });
        }
        let past = || PastFrame::new(settings, scene, env);
        match &mut kept {
            Kept::Cells(counting) if settings.method.has_memory() => {
                counting.end(&Cpu, past()?).map_err(RenderError::device)?;
            }
            Kept::Nothing | Kept::Cells(_) => {}
            Kept::Smc(following) => {
                if settings.diagnostics {
                    let pixels = whole.width * whole.height;
                    let rays = pixels as usize * whole.rays_per_pixel as usize;
                    let mut list = vec![SmcHealth::default(); pixels as usize];
                    let out = Chunks::new(&mut list, 1);
                    following
                        .diagnose(&mut Rayon::default(), &whole, 0..rays, out, pixels)
                        .map_err(RenderError::device)?;
                    diagnostics = Some(Diagnostics::Particles(list));
                }
                *following.light_mut() = env.view().texels.to_vec();
                following.end(past()?, env.view().map());
            }
        }
        self.kept = kept;
        Ok(image.finish(settings, diagnostics))
    }

    fn memory(&mut self) -> Result<Option<MethodMemory>, RenderError> {
        self.kept.read(&Cpu).map_err(RenderError::device)
    }

    fn set_memory(&mut self, memory: MethodMemory) -> Result<(), RenderError> {
        self.kept = Kept::resume(&Cpu, memory).map_err(RenderError::device)?;
        Ok(())
    }

    fn forget(&mut self) {
        self.kept = Kept::Nothing;
    }
}
