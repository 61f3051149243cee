//! Host file: GPU tests: an adapter or a visible skip, and entries that are made at run time.

use glimt_render_gpu::entry::{BufferSlot, Entry, ParamField, ParamsSpace};
use glimt_render_gpu::gpu::{AdapterPreference, GpuContext, GpuError, GpuOptions};
use naga_front_rust::Shader;

/// The machine's fastest adapter, or `None` after a line on standard error where there is none.
///
/// # Panics
///
/// Where there is none and the environment has `REQUIRE_GPU=1`; and where there is one that does not open.
#[must_use]
pub fn adapter_or_skip(test: &str) -> Option<GpuContext> {
    adapter_or_skip_with(test, GpuOptions::default())
}

/// As [`adapter_or_skip`], with options.
///
/// # Panics
///
/// As [`adapter_or_skip`].
#[must_use]
pub fn adapter_or_skip_with(test: &str, options: GpuOptions) -> Option<GpuContext> {
    match GpuContext::with_options(AdapterPreference::Fastest, options) {
        Ok(context) => Some(context),
        Err(GpuError::NoAdapter) => {
            let required = std::env::var("REQUIRE_GPU").is_ok_and(|value| value == "1");
            assert!(!required, "{test}: REQUIRE_GPU=1, but there is no adapter");
            crate::data::skipped(test, "no GPU adapter");
            None
        }
        Err(error) => panic!("{test}: {error}"),
    }
}

/// An entry whose texts are made at run time.
#[derive(Clone, Debug, Default)]
pub struct OwnedEntry {
    /// Name of the entry point.
    pub name: String,
    /// The shader.
    pub wgsl: String,
    /// Invocations in a workgroup.
    pub workgroup_size: u32,
    /// Bytes of the params buffer.
    pub params_size: u32,
    /// The kind of buffer that `params` is.
    pub params_in: ParamsSpace,
    /// Path, offset and size of each plain argument.
    pub params: Vec<(String, u32, u32)>,
    /// Path, binding, stride and whether it is written, of each slice.
    pub buffers: Vec<(String, u32, u32, bool)>,
}

impl OwnedEntry {
    /// As an [`Entry`], which lives as long as the test program.
    #[must_use]
    pub fn leak(self) -> Entry {
        let text = |text: String| -> &'static str { text.leak() };
        let field = |(path, offset, size)| ParamField {
            path: text(path),
            offset,
            size,
        };
        let slot = |(path, binding, stride, writable)| BufferSlot {
            path: text(path),
            binding,
            stride,
            writable,
        };
        Entry {
            name: text(self.name),
            kernel: "",
            wgsl: text(self.wgsl),
            workgroup_size: self.workgroup_size,
            params_size: self.params_size,
            params_in: self.params_in,
            params: self
                .params
                .into_iter()
                .map(field)
                .collect::<Vec<_>>()
                .leak(),
            buffers: self
                .buffers
                .into_iter()
                .map(slot)
                .collect::<Vec<_>>()
                .leak(),
        }
    }
}

/// A shader that the front end has just made, as an [`Entry`].
#[must_use]
pub fn entry_of(shader: &Shader) -> Entry {
    let params = shader
        .params
        .iter()
        .map(|param| (param.path.clone(), param.offset, param.size));
    let buffers = shader.buffers.iter().map(|buffer| {
        (
            buffer.path.clone(),
            buffer.binding,
            buffer.stride,
            buffer.writable,
        )
    });
    OwnedEntry {
        name: shader.entry_point.clone(),
        wgsl: shader.wgsl.clone(),
        workgroup_size: shader.workgroup_size,
        params_size: shader.params_size,
        params_in: match shader.params_in {
            naga_front_rust::ParamsSpace::Uniform => ParamsSpace::Uniform,
            naga_front_rust::ParamsSpace::Storage => ParamsSpace::Storage,
        },
        params: params.collect(),
        buffers: buffers.collect(),
    }
    .leak()
}
