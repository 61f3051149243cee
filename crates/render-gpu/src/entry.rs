//! Host file: what the host must know of a generated entry point to launch it.
//!
//! The constants of these types are written by the front end beside the WGSL (`generated/`) and checked in, so that a
//! user of the GPU path needs no Rust parser at build time.

/// A kernel that the front end has turned into a WGSL compute entry point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Entry {
    /// Name of the entry point in [`Entry::wgsl`].
    pub name: &'static str,
    /// Path of the Rust kernel it was made from.
    pub kernel: &'static str,
    /// The shader, whole.
    pub wgsl: &'static str,
    /// Invocations in a workgroup (one-dimensional).
    pub workgroup_size: u32,
    /// Bytes of the `params` buffer (group 0, binding 0).
    pub params_size: u32,
    /// Whether `params` is a uniform or a storage buffer.
    pub params_in: ParamsSpace,
    /// Where each plain argument lies in the `params` buffer. The first two are always `first` (added to the
    /// invocation's index to make the kernel's `id`) and `count` (how many elements this launch computes), then one
    /// `<name>_len` for each chunk argument.
    pub params: &'static [ParamField],
    /// The slices that the kernel reads and writes; all in group 0.
    pub buffers: &'static [BufferSlot],
}

/// The kind of buffer that `params` is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ParamsSpace {
    /// A uniform buffer.
    Uniform,
    /// A read-only storage buffer: where a member is of a type that no uniform buffer may hold.
    #[default]
    Storage,
}

/// One plain argument in the `params` buffer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ParamField {
    /// Path from the kernel's argument, as `frame` or `env.size`.
    pub path: &'static str,
    /// Bytes from the start of the buffer.
    pub offset: u32,
    /// Bytes of the value.
    pub size: u32,
}

/// One slice of a kernel's arguments, or `out` for the elements that it returns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BufferSlot {
    /// Path from the kernel's argument, as `env.cdf.marginal`; `out` for returned elements.
    pub path: &'static str,
    /// Binding in group 0.
    pub binding: u32,
    /// Bytes from one element to the next.
    pub stride: u32,
    /// Whether the kernel writes it.
    pub writable: bool,
}
