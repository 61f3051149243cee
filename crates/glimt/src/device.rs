//! Host file: the devices that render: the CPU by rayon, the GPU by wgpu.

use crate::cli::Device;
use crate::error::{Error, Kind, Result};
use glimt_executor::HostError;
use glimt_render_gpu::cpu::CpuRenderer;
use glimt_render_gpu::gpu::{self, AdapterPreference, GpuContext, GpuError, GpuRenderer};
use glimt_render_gpu::host::render::{RenderError, Renderer};

/// What runs the kernels.
#[derive(Debug)]
pub enum Processor {
    /// All of rayon's threads.
    Cpu,
    /// A GPU.
    Gpu(Box<GpuContext>),
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

/// Opens a device. `auto` takes a GPU where a real one is found that works: a software one is slower than the CPU
/// renderer.
///
/// # Errors
/// A GPU is asked for, and there is none that can be used.
pub fn open(device: Device) -> Result<Box<dyn Renderer>> {
    choose(
        device,
        || Box::new(CpuRenderer::default()) as Box<dyn Renderer>,
        |context| Ok(Box::new(GpuRenderer::on(context)?)),
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
        |context| Ok(Processor::Gpu(Box::new(context))),
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
