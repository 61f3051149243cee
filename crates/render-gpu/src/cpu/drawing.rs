//! Host file: frames by precomputed transfer on the CPU (Hajisharif 2012): rays find what is seen, and light is interpolated from the
//! vertices.

use glimt_executor::{Chunks, Cpu, Device, Executor, Host, Rayon};

use super::tiles::{self, Image, Job};
use crate::film::Samples;
use crate::generated::passes::VertexLight;
use crate::kernels::prt::{self, shade_prt};
use crate::methods::MethodMemory;
use crate::prepare::env::PreparedEnv;
use crate::prepare::light_sh::LightSh;
use crate::prepare::plate::Plate;
use crate::prepare::render::{FrameImage, RenderError, RenderSettings, Renderer, SettingsError};
use crate::prepare::scene_build::SceneBuffers;

/// Draws scenes that have a transfer, on all of rayon's threads.
#[derive(Clone, Debug, Default)]
pub struct CpuDrawing {
    light: LightSh,
}

impl CpuDrawing {
    /// Light at the vertices of a scene.
    fn vertex_lights(
        &mut self,
        scene: &SceneBuffers,
        env: &PreparedEnv,
        settings: &RenderSettings,
    ) -> Result<Vec<prt::VertexLight>, RenderError> {
        let known = scene.transfer().ok_or(SettingsError::NoTransfer)?;
        let transfer = known.transfer();
        let light = self.light.project(env, transfer.bands, &settings.prt)?;
        let vertices = known.vertices();
        let mut lights = Cpu
            .zeroed("light at vertices", vertices as usize)
            .map_err(RenderError::device)?;
        let pass = VertexLight::<Host> {
            coefficients: transfer.coefficients() as u32,
            shadows: u32::from(settings.prt.shadows),
            light: &light,
            lit: &transfer.lit,
            blocked: &transfer.blocked,
            out: Chunks::new(&mut lights, 1),
        };
        let run = Rayon::default().run(pass, 0..vertices);
        run.map_err(RenderError::device)?;
        Ok(lights)
    }
}

impl Renderer for CpuDrawing {
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
        let known = scene.transfer().ok_or(SettingsError::NoTransfer)?;
        let lights = self.vertex_lights(scene, env, settings)?;
        let surface = known.surface(&lights);
        let job = Job::new(whole, env.view(), scene, plate, settings);
        let mut image = Image::new(settings).map_err(RenderError::device)?;
        let (map, view) = (env.view().map(), scene.view());
        // A GPU draws triangles instead, so this is not a pass.
        let done = job.render(
            tiles::PIXELS,
            None,
            &mut image,
            progress,
            &|tile, samples| {
                let frame = &tile.frame;
                match samples {
                    Samples::Flat(samples) => {
                        for (ray, sample) in (0..tile.rays).zip(samples) {
                            *sample = shade_prt(ray, frame, map, view, surface);
                        }
                    }
                    Samples::Layered(samples) => {
                        for (ray, sample) in (0..tile.rays).zip(samples) {
                            *sample = shade_prt(ray, frame, map, view, surface);
                        }
                    }
                }
                Ok(())
            },
        );
        done.map_err(RenderError::device)?;
        Ok(image.finish(settings, None))
    }

    fn memory(&mut self) -> Result<Option<MethodMemory>, RenderError> {
        Ok(None)
    }

    fn set_memory(&mut self, _memory: MethodMemory) -> Result<(), RenderError> {
        Err(SettingsError::Memory.into())
    }

    fn forget(&mut self) {
        self.light = LightSh::default();
    }
}
