//! Host file: the wgpu executor.
