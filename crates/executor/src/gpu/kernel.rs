//! Host file: compiled entries.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};

use super::device::GpuContext;
use super::error::GpuError;
use super::launch::Pace;
use crate::entry::{Entry, ParamsSpace};

/// Pipelines by name, then by text: several shaders may have an entry of one name.
pub(super) type KernelCache = Mutex<HashMap<String, Vec<Arc<Kernel>>>>;

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
        if let Some(kernel) = kernels
            .get(&*entry.name)
            .and_then(|same_name| same_name.iter().find(|kernel| kernel.entry.is(entry)))
        {
            return Ok(Arc::clone(kernel));
        }
        let kernel = Arc::new(self.compile(entry)?);
        let same_name = kernels.entry(entry.name.clone().into_owned()).or_default();
        same_name.push(Arc::clone(&kernel));
        Ok(kernel)
    }

    fn compile(&self, entry: &Entry) -> Result<Kernel, GpuError> {
        self.check_limits(entry)?;
        let slot_layout = |binding, ty| wgpu::BindGroupLayoutEntry {
            binding,
            visibility: wgpu::ShaderStages::COMPUTE,
            ty: wgpu::BindingType::Buffer {
                ty,
                has_dynamic_offset: false,
                min_binding_size: None,
            },
            count: None,
        };
        let storage = |read_only| wgpu::BufferBindingType::Storage { read_only };
        let params = match entry.params_space {
            ParamsSpace::Uniform => wgpu::BufferBindingType::Uniform,
            ParamsSpace::Storage => storage(true),
        };
        let mut slots = vec![slot_layout(0, params)];
        let bound = entry.buffers.iter();
        slots.extend(bound.map(|slot| slot_layout(slot.binding, storage(!slot.writable))));
        let what = || format!("shader {}", entry.name);
        let (layout, pipeline) = self.guarded(what, || {
            let module = self
                .device()
                .create_shader_module(wgpu::ShaderModuleDescriptor {
                    label: Some(&entry.name),
                    source: wgpu::ShaderSource::Wgsl(entry.wgsl.clone()),
                });
            let layout = self
                .device()
                .create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
                    label: Some(&entry.name),
                    entries: &slots,
                });
            let pipeline_layout =
                self.device()
                    .create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
                        label: Some(&entry.name),
                        bind_group_layouts: &[Some(&layout)],
                        immediate_size: 0,
                    });
            let pipeline =
                self.device()
                    .create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
                        label: Some(&entry.name),
                        layout: Some(&pipeline_layout),
                        module: &module,
                        entry_point: Some(&entry.name),
                        compilation_options: wgpu::PipelineCompilationOptions::default(),
                        cache: None,
                    });
            (layout, pipeline)
        })?;
        Ok(Kernel {
            entry: entry.clone(),
            pipeline,
            layout,
            pace: Mutex::new(None),
        })
    }

    fn check_limits(&self, entry: &Entry) -> Result<(), GpuError> {
        let limits = self.limits();
        let buffers = entry.buffers.len() as u64 + 1;
        let storage = u64::from(entry.storage_buffers());
        let group = u64::from(entry.workgroup_size);
        let checks = [
            (
                "max_storage_buffers_per_shader_stage",
                limits.max_storage_buffers_per_shader_stage,
                storage,
            ),
            (
                "max_bindings_per_bind_group",
                limits.max_bindings_per_bind_group,
                buffers,
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

impl GpuContext {
    /// Columns and rows of workgroups for so many elements: as square as the limit needs, not as wide as it allows, or a second
    /// row might be almost empty.
    pub(super) fn grid(&self, entry: &Entry, elements: u32) -> [u32; 2] {
        let groups = elements.div_ceil(entry.workgroup_size).max(1);
        let rows = groups.div_ceil(self.limits().max_compute_workgroups_per_dimension);
        [groups.div_ceil(rows), rows]
    }
}
