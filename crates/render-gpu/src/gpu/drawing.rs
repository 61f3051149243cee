//! Host file: the renderer that draws by precomputed transfer on a GPU.

use std::sync::Arc;
use std::time::{Duration, Instant};

use glimt_executor::gpu::{GpuContext, GpuError};

use super::prt::{DrawTimes, GpuPrt};
use super::renderer::device;
use super::upload::KeptScene;
use crate::methods::MethodMemory;
use crate::prepare::env::PreparedEnv;
use crate::prepare::plate::Plate;
use crate::prepare::render::{FrameImage, RenderError, RenderSettings, Renderer, SettingsError};
use crate::prepare::scene_build::SceneBuffers;

/// Draws scenes that have a transfer on a GPU.
pub struct GpuDrawing {
    context: Arc<GpuContext>,
    scene: KeptScene,
    prt: GpuPrt,
    /// Handing over the scene, where it was new.
    upload: Duration,
}

impl GpuDrawing {
    /// On a GPU that is open.
    ///
    /// # Errors
    ///
    /// [`GpuError::Refused`] where wgpu finds fault with a shader, and other failures of the device.
    pub fn on(context: impl Into<Arc<GpuContext>>) -> Result<Self, GpuError> {
        let context = context.into();
        Ok(Self {
            prt: GpuPrt::new(&context)?,
            context,
            scene: KeptScene::default(),
            upload: Duration::ZERO,
        })
    }

    /// The GPU.
    #[must_use]
    pub fn context(&self) -> &Arc<GpuContext> {
        &self.context
    }

    /// Where the time of the frame went that was drawn last, and read back.
    #[must_use]
    pub fn times(&self) -> &DrawTimes {
        self.prt.times()
    }

    /// Draws a frame as [`Renderer::render_over`] does, but leaves it on the GPU and waits for nothing: for frames that are shown
    /// there, or measured. [`GpuContext::finish`] waits for all of them.
    ///
    /// # Errors
    ///
    /// As [`GpuPrt::draw`].
    pub fn draw_over(
        &mut self,
        scene: &SceneBuffers,
        env: &PreparedEnv,
        plate: Option<&Plate>,
        settings: &RenderSettings,
    ) -> Result<(), RenderError> {
        let started = Instant::now();
        self.scene.keep(&self.context, scene).map_err(device)?;
        self.upload = started.elapsed();
        let Some(uploaded) = self.scene.get() else {
            unreachable!("it was just kept");
        };
        self.prt
            .draw(&self.context, scene, uploaded, env, plate, settings)
    }
}

impl Renderer for GpuDrawing {
    fn name(&self) -> String {
        format!("GPU, {}", self.context.adapter())
    }

    fn render_over(
        &mut self,
        scene: &SceneBuffers,
        env: &PreparedEnv,
        plate: Option<&Plate>,
        settings: &RenderSettings,
        progress: &(dyn Fn(f32) + Sync),
    ) -> Result<FrameImage, RenderError> {
        self.draw_over(scene, env, plate, settings)?;
        let image = self.prt.read(&self.context).map_err(device)?;
        progress(1.0);
        Ok(image)
    }

    fn phases(&self) -> Vec<(&'static str, Duration)> {
        let drawn = self.times();
        vec![
            ("upload", self.upload + drawn.upload),
            ("light", drawn.light),
            ("draw", drawn.draw),
            ("read back", drawn.read_back),
        ]
    }

    fn memory(&mut self) -> Result<Option<MethodMemory>, RenderError> {
        Ok(None)
    }

    fn set_memory(&mut self, _memory: MethodMemory) -> Result<(), RenderError> {
        Err(SettingsError::Memory.into())
    }

    fn forget(&mut self) {
        self.prt.forget();
    }
}
