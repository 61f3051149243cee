//! Host file: passes recorded one after the other, and handed over together: nothing is waited for in between.

use super::buffer::GpuBuffer;
use super::device::GpuContext;
use super::error::GpuError;
use super::kernel::{Arguments, Bound};
use super::launch::Arg;
use super::timing::Stopwatch;
use crate::entry::Entry;

/// The params buffers of a frame's dispatches, one each, kept for the next frame, which records the same ones.
#[derive(Debug, Default)]
pub(super) struct ParamsPool {
    buffers: Vec<GpuBuffer>,
}

/// A command encoder that dispatches are recorded into.
pub(super) struct Recording<'a> {
    pub(super) context: &'a GpuContext,
    pub(super) encoder: wgpu::CommandEncoder,
    pool: &'a mut ParamsPool,
    used: usize,
}

impl<'a> Recording<'a> {
    pub(super) fn new(context: &'a GpuContext, pool: &'a mut ParamsPool) -> Self {
        let encoder = context
            .device
            .create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        Self {
            context,
            encoder,
            pool,
            used: 0,
        }
    }

    /// Elements `0 .. count` of `entry`, in one dispatch: element i fills the i-th value of `out` and of each chunked argument.
    ///
    /// # Errors
    /// [`GpuError::Argument`] where the arguments are not the entry's, [`GpuError::Limit`] where one is larger than a binding
    /// may be, and those of [`GpuContext::prepare`].
    pub(super) fn dispatch(
        &mut self,
        entry: &Entry,
        args: &[(&str, Arg<'_>)],
        count: u32,
    ) -> Result<(), GpuError> {
        let grid = self.context.grid(entry, count);
        self.dispatch_grid(entry, args, count, grid)
    }

    /// As [`Recording::dispatch`], with a grid of so many columns and rows of workgroups, for entries written by hand.
    pub(super) fn dispatch_grid(
        &mut self,
        entry: &Entry,
        args: &[(&str, Arg<'_>)],
        count: u32,
        [columns, rows]: [u32; 2],
    ) -> Result<(), GpuError> {
        let context = self.context;
        let kernel = context.kernel(entry)?;
        let mut arguments = Arguments::new(entry, args, count)?;
        let most = context.limits.max_compute_workgroups_per_dimension;
        if columns.max(rows) > most {
            let limit = "max_compute_workgroups_per_dimension";
            let what = format!("a dispatch of {}", entry.name);
            return Err(context.limit_error(what, columns.max(rows).into(), limit, most.into()));
        }
        for bound in &arguments.bound {
            check_bound(context, entry, bound, count)?;
        }
        self.put_params(entry, arguments.params_for(entry, 0, count))?;
        let params = &self.pool.buffers[self.used - 1];
        let bind_group = context.guarded(
            || format!("the arguments of {}", entry.name),
            || context.bind_group(&kernel, params, &arguments.bound, 0, count),
        )?;
        let mut pass = self
            .encoder
            .begin_compute_pass(&wgpu::ComputePassDescriptor {
                label: Some(entry.name),
                timestamp_writes: None,
            });
        pass.set_pipeline(&kernel.pipeline);
        pass.set_bind_group(0, &bind_group, &[]);
        pass.dispatch_workgroups(columns, rows, 1);
        Ok(())
    }

    /// Notes the GPU's time when it comes to this point.
    pub(super) fn mark(&mut self, stopwatch: Option<&Stopwatch>, index: u32) {
        if let Some(stopwatch) = stopwatch {
            self.encoder
                .begin_compute_pass(&wgpu::ComputePassDescriptor {
                    label: Some("mark"),
                    timestamp_writes: Some(stopwatch.mark(index)),
                });
        }
    }

    /// Writes the params of the next dispatch into a buffer of its own.
    fn put_params(&mut self, entry: &Entry, bytes: &[u8]) -> Result<(), GpuError> {
        let size = u64::from(entry.params_size.max(4)).next_multiple_of(16);
        let known = self.pool.buffers.get(self.used);
        if known.is_none_or(|buffer| buffer.len() != size) {
            let made = self.context.buffer(entry.name, size)?;
            self.pool.buffers.truncate(self.used);
            self.pool.buffers.push(made);
        }
        self.context.write(&self.pool.buffers[self.used], bytes)?;
        self.used += 1;
        Ok(())
    }

    /// Hands everything over.
    ///
    /// # Errors
    /// [`GpuError::Refused`] where wgpu finds fault with what was recorded, [`GpuError::OutOfMemory`], [`GpuError::Lost`].
    pub(super) fn submit(self) -> Result<wgpu::SubmissionIndex, GpuError> {
        let (context, encoder) = (self.context, self.encoder);
        context.guarded(
            || "a frame's passes".to_owned(),
            || context.queue.submit([encoder.finish()]),
        )
    }
}

/// Bytes of a slice that a dispatch of `count` elements binds.
fn bound_bytes(bound: &Bound<'_>, count: u32) -> u64 {
    bound
        .bytes_per_element
        .map_or(bound.len, |bytes| bytes * u64::from(count))
}

fn check_bound(
    context: &GpuContext,
    entry: &Entry,
    bound: &Bound<'_>,
    count: u32,
) -> Result<(), GpuError> {
    let path = bound.slot.path;
    let (bytes, most) = (bound_bytes(bound, count), context.max_binding_bytes());
    if bytes > most {
        let what = format!("argument '{path}' of {}", entry.name);
        return Err(context.limit_error(what, bytes, "max_storage_buffer_binding_size", most));
    }
    let alignment = context.limits.min_storage_buffer_offset_alignment;
    bound.check_alignment(entry, alignment.into())
}
