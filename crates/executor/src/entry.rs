//! Host file: what an executor must know of a compute shader to launch it.
//!
//! Checked-in entries are constants that borrow their texts; those that are made at run time own them.

use std::borrow::Cow;

/// A kernel that the front end has turned into a WGSL compute entry point.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Entry {
    /// Name of the entry point in [`Entry::wgsl`].
    pub name: Cow<'static, str>,
    /// Path of the Rust kernel it was made from; empty where there is none.
    pub kernel: Cow<'static, str>,
    /// The shader, whole.
    pub wgsl: Cow<'static, str>,
    /// Invocations in a workgroup (one-dimensional).
    pub workgroup_size: u32,
    /// Bytes of the `params` buffer (group 0, binding 0).
    pub params_size: u32,
    /// The address space of `params`.
    pub params_space: ParamsSpace,
    /// Where each plain argument lies in the `params` buffer. The first two are always `first` (added to the
    /// invocation's index to make the kernel's `id`) and `count` (how many elements this launch computes), then one
    /// `<name>_len` for each chunk argument.
    pub params: Cow<'static, [ParamField]>,
    /// The slices that the kernel reads and writes; all in group 0.
    pub buffers: Cow<'static, [BufferSlot]>,
}

/// Where a shader reads its plain arguments.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ParamsSpace {
    /// `var<uniform>`.
    #[default]
    Uniform,
    /// `var<storage, read>`, for arguments that the rules of uniforms do not allow. It counts as a storage buffer.
    Storage,
}

/// One plain argument in the `params` buffer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ParamField {
    /// Path from the kernel's argument, as `frame` or `env.size`.
    pub path: Cow<'static, str>,
    /// Bytes from the start of the buffer.
    pub offset: u32,
    /// Bytes of the value.
    pub size: u32,
}

/// One slice of a kernel's arguments, or `out` for the elements that it returns.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BufferSlot {
    /// Path from the kernel's argument, as `env.tables`; `out` for returned elements.
    pub path: Cow<'static, str>,
    /// Binding in group 0.
    pub binding: u32,
    /// Bytes from one element to the next.
    pub stride: u32,
    /// Whether the kernel writes it.
    pub writable: bool,
}

impl ParamField {
    /// A field whose path is known at compile time.
    #[must_use]
    pub const fn new(path: &'static str, offset: u32, size: u32) -> Self {
        Self {
            path: Cow::Borrowed(path),
            offset,
            size,
        }
    }
}

impl BufferSlot {
    /// A slot whose path is known at compile time.
    #[must_use]
    pub const fn new(path: &'static str, binding: u32, stride: u32, writable: bool) -> Self {
        Self {
            path: Cow::Borrowed(path),
            binding,
            stride,
            writable,
        }
    }
}

impl Entry {
    /// Storage buffers that it binds.
    #[must_use]
    pub fn storage_buffers(&self) -> u32 {
        self.buffers.len() as u32 + u32::from(self.params_space == ParamsSpace::Storage)
    }

    /// Whether it is the same as another, its text included. Borrowed texts are compared by place first.
    pub(crate) fn is(&self, other: &Self) -> bool {
        std::ptr::eq(self, other) || self == other
    }
}

#[cfg(feature = "naga-front-rust")]
impl From<&naga_front_rust::Shader> for Entry {
    /// A shader that the front end has just made.
    fn from(shader: &naga_front_rust::Shader) -> Self {
        let params = shader.params.iter().map(|param| ParamField {
            path: param.path.clone().into(),
            offset: param.offset,
            size: param.size,
        });
        let buffers = shader.buffers.iter().map(|buffer| BufferSlot {
            path: buffer.path.clone().into(),
            binding: buffer.binding,
            stride: buffer.stride,
            writable: buffer.writable,
        });
        Self {
            name: shader.entry_point.clone().into(),
            kernel: Cow::Borrowed(""),
            wgsl: shader.wgsl.clone().into(),
            workgroup_size: shader.workgroup_size,
            params_size: shader.params_size,
            params_space: match shader.params_in {
                naga_front_rust::ParamsSpace::Uniform => ParamsSpace::Uniform,
                naga_front_rust::ParamsSpace::Storage => ParamsSpace::Storage,
            },
            params: params.collect(),
            buffers: buffers.collect(),
        }
    }
}
