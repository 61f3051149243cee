//! Host file: compiled entries, and the check of a launch's arguments against them.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};

use super::buffer::GpuBuffer;
use super::device::GpuContext;
use super::error::GpuError;
use super::launch::{Arg, Pace};
use crate::entry::{BufferSlot, Entry, ParamsSpace};

/// Pipelines by name, then by text: several shaders may have an entry of one name.
pub(super) type KernelCache = Mutex<HashMap<&'static str, Vec<Arc<Kernel>>>>;

/// A compiled entry.
#[derive(Debug)]
pub(super) struct Kernel {
    pub(super) entry: Entry,
    pub(super) pipeline: wgpu::ComputePipeline,
    pub(super) layout: wgpu::BindGroupLayout,
    pub(super) pace: Mutex<Option<Pace>>,
}

impl GpuContext {
    /// Compiles `entry` now, so that its first launch does not wait for the driver.
    ///
    /// # Errors
    ///
    /// [`GpuError::Limit`] when it uses more buffers or a larger group than the adapter allows;
    /// [`GpuError::Refused`] with the compiler's message.
    pub fn prepare(&self, entry: &Entry) -> Result<(), GpuError> {
        self.kernel(entry).map(drop)
    }

    pub(super) fn kernel(&self, entry: &Entry) -> Result<Arc<Kernel>, GpuError> {
        let mut kernels = self.kernels.lock().unwrap_or_else(PoisonError::into_inner);
        let same_name = kernels.entry(entry.name).or_default();
        if let Some(kernel) = same_name.iter().find(|kernel| kernel.entry == *entry) {
            return Ok(Arc::clone(kernel));
        }
        let kernel = Arc::new(self.compile(entry)?);
        same_name.push(Arc::clone(&kernel));
        Ok(kernel)
    }

    fn compile(&self, entry: &Entry) -> Result<Kernel, GpuError> {
        self.check_limits(entry)?;
        let slot_layout = |binding: u32, ty: wgpu::BufferBindingType| wgpu::BindGroupLayoutEntry {
            binding,
            visibility: wgpu::ShaderStages::COMPUTE,
            ty: wgpu::BindingType::Buffer {
                ty,
                has_dynamic_offset: false,
                min_binding_size: None,
            },
            count: None,
        };
        let storage = |writable: bool| wgpu::BufferBindingType::Storage {
            read_only: !writable,
        };
        let params = match entry.params_in {
            ParamsSpace::Uniform => wgpu::BufferBindingType::Uniform,
            ParamsSpace::Storage => storage(false),
        };
        let slots: Vec<_> = std::iter::once(slot_layout(0, params))
            .chain(
                entry
                    .buffers
                    .iter()
                    .map(|slot| slot_layout(slot.binding, storage(slot.writable))),
            )
            .collect();
        let what = || format!("shader {}", entry.name);
        let (layout, pipeline) = self.guarded(what, || {
            let module = self
                .device
                .create_shader_module(wgpu::ShaderModuleDescriptor {
                    label: Some(entry.name),
                    source: wgpu::ShaderSource::Wgsl(entry.wgsl.into()),
                });
            let layout = self
                .device
                .create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
                    label: Some(entry.name),
                    entries: &slots,
                });
            let pipeline_layout =
                self.device
                    .create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
                        label: Some(entry.name),
                        bind_group_layouts: &[Some(&layout)],
                        immediate_size: 0,
                    });
            let pipeline = self
                .device
                .create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
                    label: Some(entry.name),
                    layout: Some(&pipeline_layout),
                    module: &module,
                    entry_point: Some(entry.name),
                    compilation_options: wgpu::PipelineCompilationOptions::default(),
                    cache: None,
                });
            (layout, pipeline)
        })?;
        Ok(Kernel {
            entry: *entry,
            pipeline,
            layout,
            pace: Mutex::new(None),
        })
    }

    fn check_limits(&self, entry: &Entry) -> Result<(), GpuError> {
        let limits = &self.limits;
        let slices = entry.buffers.len() as u64;
        let in_storage = u64::from(entry.params_in == ParamsSpace::Storage);
        let group = u64::from(entry.workgroup_size);
        let checks = [
            (
                "max_storage_buffers_per_shader_stage",
                limits.max_storage_buffers_per_shader_stage,
                slices + in_storage,
            ),
            (
                "max_bindings_per_bind_group",
                limits.max_bindings_per_bind_group,
                slices + 1,
            ),
            (
                "max_compute_workgroup_size_x",
                limits.max_compute_workgroup_size_x,
                group,
            ),
            (
                "max_compute_invocations_per_workgroup",
                limits.max_compute_invocations_per_workgroup,
                group,
            ),
        ];
        for (limit, allowed, needed) in checks {
            if needed > u64::from(allowed) {
                return Err(self.limit_error(
                    format!("kernel {}", entry.name),
                    needed,
                    limit,
                    allowed.into(),
                ));
            }
        }
        Ok(())
    }
}

/// A slice argument, bound: how many of its bytes belong to one element of the launch (none where all elements read
/// it whole).
#[derive(Clone, Copy, Debug)]
pub(super) struct Bound<'a> {
    pub(super) slot: &'a BufferSlot,
    pub(super) buffer: &'a GpuBuffer,
    /// Where it begins in the buffer, in bytes.
    pub(super) offset: u64,
    /// How many bytes there are from there on.
    pub(super) len: u64,
    pub(super) bytes_per_element: Option<u64>,
}

impl Bound<'_> {
    /// What a dispatch of elements `done .. done + elements` binds: their part, or all of what every element reads.
    fn binding(&self, done: u32, elements: u32) -> wgpu::BindGroupEntry<'_> {
        let (from, size) = match self.bytes_per_element {
            Some(bytes) => (u64::from(done) * bytes, u64::from(elements) * bytes),
            None => (0, self.len),
        };
        wgpu::BindGroupEntry {
            binding: self.slot.binding,
            resource: wgpu::BindingResource::Buffer(wgpu::BufferBinding {
                buffer: &self.buffer.raw,
                offset: self.offset + from,
                size: wgpu::BufferSize::new(size),
            }),
        }
    }

    /// Sees that it begins where a binding may.
    pub(super) fn check_alignment(&self, entry: &Entry, alignment: u64) -> Result<(), GpuError> {
        if self.offset.is_multiple_of(alignment) {
            return Ok(());
        }
        let (path, offset) = (self.slot.path, self.offset);
        Err(GpuError::Argument {
            entry: entry.name.to_owned(),
            problem: format!(
                "'{path}' begins at byte {offset}, which is no multiple of {alignment}"
            ),
        })
    }
}

impl GpuContext {
    /// The arguments of a dispatch of elements `done .. done + elements`. Errors go to the scope around it.
    pub(super) fn bind_group(
        &self,
        kernel: &Kernel,
        params: &GpuBuffer,
        bound: &[Bound<'_>],
        done: u32,
        elements: u32,
    ) -> wgpu::BindGroup {
        let mut entries = vec![wgpu::BindGroupEntry {
            binding: 0,
            resource: params.raw.as_entire_binding(),
        }];
        entries.extend(bound.iter().map(|bound| bound.binding(done, elements)));
        self.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some(kernel.entry.name),
            layout: &kernel.layout,
            entries: &entries,
        })
    }

    /// Columns and rows of workgroups for so many elements: as square as the limit needs, not as wide as it allows, or a second
    /// row might be almost empty.
    pub(super) fn grid(&self, entry: &Entry, elements: u32) -> [u32; 2] {
        let groups = elements.div_ceil(entry.workgroup_size).max(1);
        let rows = groups.div_ceil(self.limits.max_compute_workgroups_per_dimension);
        [groups.div_ceil(rows), rows]
    }
}

/// The arguments of a launch, checked to be all of the entry's and no others.
#[derive(Debug)]
pub(super) struct Arguments<'a> {
    pub(super) params: Vec<u8>,
    pub(super) bound: Vec<Bound<'a>>,
}

/// What the launcher itself puts into the params buffer.
const FIRST: &str = "first";
const COUNT: &str = "count";
/// The slot of returned elements.
const OUT: &str = "out";

impl<'a> Arguments<'a> {
    pub(super) fn new(
        entry: &'a Entry,
        args: &[(&str, Arg<'a>)],
        count: u32,
    ) -> Result<Self, GpuError> {
        let fail = |problem: String| GpuError::Argument {
            entry: entry.name.to_owned(),
            problem,
        };
        let find = |path: &str| {
            args.iter()
                .find(|(name, _)| *name == path)
                .map(|(_, arg)| *arg)
        };

        let mut params = vec![0; entry.params_size as usize];
        for field in entry
            .params
            .iter()
            .filter(|field| field.path != FIRST && field.path != COUNT)
        {
            let path = field.path;
            let bytes = match (find(path), path.strip_suffix("_len").and_then(find)) {
                (Some(Arg::Value(bytes)), _) => bytes.to_vec(),
                (Some(_), _) => {
                    return Err(fail(format!(
                        "argument '{path}' is a plain value, not a buffer"
                    )));
                }
                (None, Some(Arg::Chunk(_, len) | Arg::ChunkFrom(_, len, _))) => {
                    len.to_ne_bytes().to_vec()
                }
                (None, _) => return Err(fail(format!("argument '{path}' is missing"))),
            };
            let (from, to) = (field.offset as usize, (field.offset + field.size) as usize);
            if bytes.len() != field.size as usize {
                return Err(fail(format!(
                    "argument '{path}' is {} bytes, not {}",
                    bytes.len(),
                    field.size
                )));
            }
            params
                .get_mut(from..to)
                .ok_or_else(|| fail(format!("parameter '{path}' lies outside the params buffer")))?
                .copy_from_slice(&bytes);
        }

        let mut bound = Vec::new();
        for slot in entry.buffers {
            let (path, stride) = (slot.path, u64::from(slot.stride));
            let is_chunk = slot.writable && path != OUT;
            let (buffer, offset, window, bytes_per_element) = match find(path) {
                Some(Arg::Buffer(buffer)) if !is_chunk => {
                    (buffer, 0, None, slot.writable.then_some(stride))
                }
                Some(Arg::Window(buffer, first, len)) if !is_chunk => {
                    let (first, len) = (u64::from(first), u64::from(len));
                    let per_element = slot.writable.then_some(stride);
                    (buffer, first * stride, Some(len * stride), per_element)
                }
                Some(Arg::Chunk(buffer, len)) if is_chunk && len > 0 => {
                    (buffer, 0, None, Some(stride * u64::from(len)))
                }
                Some(Arg::ChunkFrom(buffer, len, first)) if is_chunk && len > 0 => {
                    let bytes = stride * u64::from(len);
                    (buffer, u64::from(first) * bytes, None, Some(bytes))
                }
                Some(_) if is_chunk => {
                    return Err(fail(format!(
                        "argument '{path}' must be a chunk of 1 or more"
                    )));
                }
                Some(_) => return Err(fail(format!("argument '{path}' must be a buffer"))),
                None => return Err(fail(format!("argument '{path}' is missing"))),
            };
            let in_buffer = buffer.len().saturating_sub(offset);
            let len = window.unwrap_or(in_buffer);
            let there = match slot.writable {
                true => in_buffer.min(len),
                false => in_buffer,
            };
            let needed =
                bytes_per_element.map_or(stride.max(len), |bytes| bytes * u64::from(count));
            if there < needed {
                return Err(fail(format!(
                    "argument '{path}' has {there} bytes and needs {needed}"
                )));
            }
            bound.push(Bound {
                slot,
                buffer,
                offset,
                len,
                bytes_per_element,
            });
        }

        let known = |path: &str| {
            entry
                .params
                .iter()
                .any(|field| field.path == path && path != FIRST && path != COUNT)
                || entry.buffers.iter().any(|slot| slot.path == path)
        };
        // A view has slices that the kernel does not reach: they are left out of the entry.
        let is_in_view = |path: &str| path.contains('.');
        let mut unknown = args.iter().filter(|(path, _)| !known(path));
        if let Some((path, _)) = unknown.find(|(path, _)| !is_in_view(path)) {
            return Err(fail(format!("there is no argument '{path}'")));
        }
        Ok(Self { params, bound })
    }

    /// The params buffer of a dispatch that computes elements `first .. first + count`.
    pub(super) fn params_for(&mut self, entry: &Entry, first: u32, count: u32) -> &[u8] {
        for (path, value) in [(FIRST, first), (COUNT, count)] {
            if let Some(field) = entry.params.iter().find(|field| field.path == path) {
                let from = field.offset as usize;
                self.params[from..from + 4].copy_from_slice(&value.to_ne_bytes());
            }
        }
        &self.params
    }
}
