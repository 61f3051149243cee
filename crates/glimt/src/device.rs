//! Host file: the devices that render: the CPU by rayon, the GPU by wgpu.

use crate::cli::Device;
use crate::error::{Error, Kind, Result};
use crate::memory;
use crate::shot::Shot;
use glimt_executor::HostError;
use glimt_render_gpu::cpu::{CpuDrawing, CpuRenderer};
use glimt_render_gpu::gpu::{
    self, AdapterPreference, GpuContext, GpuDrawing, GpuError, GpuRenderer,
};
use glimt_render_gpu::methods::Method;
use glimt_render_gpu::prepare::render::{RenderError, Renderer};
use std::sync::Arc;

/// What runs the kernels.
#[derive(Debug)]
pub enum Processor {
    /// All of rayon's threads.
    Cpu,
    /// A GPU.
    Gpu(Arc<GpuContext>),
}

impl Processor {
    /// What it is, for messages.
    pub fn name(&self) -> String {
        match self {
            Self::Cpu => format!("CPU, {} threads", rayon::current_num_threads()),
            Self::Gpu(gpu) => format!("GPU, {}", gpu.adapter()),
        }
    }
}

/// What renders on a device: one renderer traces rays, another draws with precomputed transfer. Each is made when it is first
/// needed.
pub struct Renderers {
    processor: Processor,
    tracing: Option<Box<dyn Renderer>>,
    drawing: Option<Box<dyn Renderer>>,
}

impl Renderers {
    /// The one that renders a shot.
    ///
    /// # Errors
    /// The device fails.
    pub fn of(&mut self, shot: &Shot) -> Result<&mut dyn Renderer> {
        let traces = shot.render.estimator().is_some();
        let slot = match traces {
            true => &mut self.tracing,
            false => &mut self.drawing,
        };
        let renderer = match slot.take() {
            Some(known) => known,
            None => make(&self.processor, traces).map_err(|e| gpu_failure(&e))?,
        };
        Ok(&mut **slot.insert(renderer))
    }

    /// What renders, for messages.
    pub fn name(&self) -> String {
        self.processor.name()
    }

    /// Sees that what a shot's method keeps from frame to frame has room.
    ///
    /// # Errors
    /// It has not; the error says what would.
    pub fn require_memory(&self, shot: &Shot) -> Result<()> {
        let Some(method) = shot.render.estimator() else {
            return Ok(());
        };
        let rays_per_pixel = shot.image.rays_per_pixel;
        let kept = |rays| method.kept_bytes(shot.image.size.into(), rays);
        let (whose, fits): (_, Box<dyn Fn(u32) -> bool>) = match &self.processor {
            Processor::Cpu => {
                let there = memory::available().unwrap_or(u64::MAX);
                let fits = move |rays| 2 * kept(rays).all <= there;
                ("of memory", Box::new(fits))
            }
            Processor::Gpu(gpu) => {
                let most = gpu.limits().max_buffer_size;
                let fits = move |rays| kept(rays).largest <= most;
                ("on this GPU", Box::new(fits))
            }
        };
        if fits(rays_per_pixel) {
            return Ok(());
        }
        let needed = memory::in_words(2 * kept(rays_per_pixel).all);
        let word = method.word();
        let text = format!(
            "what the method \"{word}\" keeps from frame to frame takes {needed} {whose}, and that has no room"
        );
        let fewer = (1..rays_per_pixel).rev().find(|rays| fits(*rays));
        Err(Error::device(text).fix(match (fewer, method) {
            (Some(fewer), _) => format!("--set image.rays_per_pixel={fewer} fits"),
            (None, Method::Cells(_)) => "--set render.cells.memory=false keeps nothing".to_owned(),
            (None, _) => "lower image.size, or render.smc.particles".to_owned(),
        }))
    }

    /// Forgets the last frames of all.
    pub fn forget(&mut self) {
        for renderer in [&mut self.tracing, &mut self.drawing].into_iter().flatten() {
            renderer.forget();
        }
    }
}

fn make(processor: &Processor, traces: bool) -> std::result::Result<Box<dyn Renderer>, GpuError> {
    Ok(match (processor, traces) {
        (Processor::Cpu, true) => Box::new(CpuRenderer::default()),
        (Processor::Cpu, false) => Box::new(CpuDrawing::default()),
        (Processor::Gpu(context), true) => Box::new(GpuRenderer::on(Arc::clone(context))?),
        (Processor::Gpu(context), false) => Box::new(GpuDrawing::on(Arc::clone(context))?),
    })
}

/// Opens a device. `auto` takes a GPU where a real one is found that works: a software one is slower than the CPU
/// renderer.
///
/// # Errors
/// A GPU is asked for, and there is none that can be used.
pub fn open(device: Device) -> Result<Renderers> {
    let renderers = |processor, tracing| Renderers {
        processor,
        tracing,
        drawing: None,
    };
    choose(
        device,
        || renderers(Processor::Cpu, None),
        |context| {
            // Made at once, so that `auto` learns whether it can be.
            let processor = Processor::Gpu(Arc::new(context));
            let tracing = make(&processor, true)?;
            Ok(renderers(processor, Some(tracing)))
        },
    )
}

/// Opens a device for kernels of one's own, as [`open()`] does.
///
/// # Errors
/// A GPU is asked for, and there is none that can be used.
pub fn open_processor(device: Device) -> Result<Processor> {
    choose(
        device,
        || Processor::Cpu,
        |context| Ok(Processor::Gpu(Arc::new(context))),
    )
}

fn choose<T>(
    device: Device,
    cpu: impl FnOnce() -> T,
    on_gpu: impl FnOnce(GpuContext) -> std::result::Result<T, GpuError>,
) -> Result<T> {
    let open = || GpuContext::new(AdapterPreference::Fastest);
    match device {
        Device::Cpu => Ok(cpu()),
        Device::Gpu => {
            let context = open().map_err(|e| gpu_failure(&e))?;
            let adapter = context.adapter();
            if adapter.is_software() {
                tracing::warn!(
                    "{} is not a GPU but a program: slower than --device cpu, and where a ray has hundreds of samples it may \
                     leave some out",
                    adapter.name
                );
            }
            on_gpu(context).map_err(|e| gpu_failure(&e))
        }
        Device::Auto => {
            // Adapters come the fastest first.
            let real = gpu::enumerate().first().is_some_and(|a| !a.is_software());
            match real.then(|| open().and_then(on_gpu)) {
                Some(Ok(gpu)) => return Ok(gpu),
                Some(Err(e)) => tracing::warn!("the GPU is not used: {e}"),
                None => {}
            }
            Ok(cpu())
        }
    }
}

/// What a renderer says, as an error of the program.
pub fn failure(error: RenderError) -> Error {
    match error {
        RenderError::Settings(e) => Error::new(Kind::Usage, e),
        RenderError::Device(e) => match e.downcast_ref::<GpuError>() {
            Some(e) => gpu_failure(e),
            None if matches!(e.downcast_ref(), Some(HostError::Memory { .. })) => {
                Error::device(format!("{e} of the image"))
                    .fix("render a smaller one, as --set image.size=[1280,720]")
            }
            None => Error::device(e),
        },
    }
}

/// What a GPU says, as an error of the program.
pub fn gpu_failure(error: &GpuError) -> Error {
    let (what, fix) = match error {
        GpuError::NoAdapter => (
            "there is no GPU that runs compute shaders".to_owned(),
            "install its Vulkan, Metal or Direct3D 12 driver, or use --device cpu",
        ),
        GpuError::Limit { .. } | GpuError::OutOfMemory { .. } => (
            error.to_string(),
            "use a smaller scene or light, or --device cpu",
        ),
        GpuError::Lost { .. } | GpuError::TimedOut { .. } => (
            error.to_string(),
            "run it again: frames that are done are kept; or use --device cpu",
        ),
        _ => (error.to_string(), "use --device cpu"),
    };
    Error::device(what).fix(fix)
}
