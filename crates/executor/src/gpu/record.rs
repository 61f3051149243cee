//! Host file: passes recorded one after the other, and handed over together: nothing is waited for in between.

use std::ops::Range;

use super::arguments::{Arg, Arguments, Bound};
use super::device::GpuContext;
use super::error::GpuError;
use super::memory::Gpu;
use super::timing::Stopwatch;
use crate::entry::{Entry, ParamsSpace};
use crate::pass::{Executor, Pass};

/// The params buffers of a frame's dispatches, one each, kept for the next frame, which records the same ones.
#[derive(Debug, Default)]
pub struct ParamsPool {
    buffers: Vec<(ParamsSpace, wgpu::Buffer)>,
}

/// Runs passes later: they are recorded one after the other, and handed over together by [`Recording::submit`].
#[derive(Debug)]
pub struct Recording<'a> {
    context: &'a GpuContext,
    encoder: wgpu::CommandEncoder,
    pool: &'a mut ParamsPool,
    used: usize,
}

impl Executor for Recording<'_> {
    type Memory = Gpu;
    type Error = GpuError;

    /// Records a pass as one dispatch.
    ///
    /// # Errors
    /// [`GpuError::Argument`] where the pass writes beyond a buffer, [`GpuError::Limit`] where a slice is larger than a binding
    /// may be, and those of [`GpuContext::prepare`].
    fn run<P: Pass<Memory = Gpu>>(&mut self, pass: P, range: Range<u32>) -> Result<(), GpuError> {
        let (entry, count) = (P::entry(), range.len() as u32);
        let arguments = Arguments::of_pass(&pass, count)?;
        let grid = self.context.grid(entry, count);
        self.record(entry, arguments, range, grid)
    }
}

impl<'a> Recording<'a> {
    /// An empty recording.
    #[must_use]
    pub fn new(context: &'a GpuContext, pool: &'a mut ParamsPool) -> Self {
        let encoder = context
            .device()
            .create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        Self {
            context,
            encoder,
            pool,
            used: 0,
        }
    }

    /// The GPU.
    #[must_use]
    pub fn context(&self) -> &'a GpuContext {
        self.context
    }

    /// Where commands go, for passes of one's own.
    pub fn encoder(&mut self) -> &mut wgpu::CommandEncoder {
        &mut self.encoder
    }

    /// Elements `0 .. count` of an entry that is written by hand, on a grid of so many columns and rows of workgroups.
    ///
    /// # Errors
    /// As [`Recording::run`]; [`GpuError::Argument`] where the arguments are not the entry's.
    pub fn dispatch_grid(
        &mut self,
        entry: &Entry,
        args: &[(&str, Arg<'_>)],
        count: u32,
        grid: [u32; 2],
    ) -> Result<(), GpuError> {
        let arguments = Arguments::by_path(entry, args, count)?;
        self.record(entry, arguments, 0..count, grid)
    }

    fn record(
        &mut self,
        entry: &Entry,
        mut arguments: Arguments,
        range: Range<u32>,
        [columns, rows]: [u32; 2],
    ) -> Result<(), GpuError> {
        let (context, count) = (self.context, range.len() as u32);
        let kernel = context.kernel(entry)?;
        let most = context.limits().max_compute_workgroups_per_dimension;
        if columns.max(rows) > most {
            let limit = "max_compute_workgroups_per_dimension";
            let what = format!("a dispatch of {}", entry.name);
            return Err(context.limit_error(what, columns.max(rows).into(), limit, most.into()));
        }
        for bound in &arguments.bound {
            check_bound(context, entry, bound, count)?;
        }
        self.put_params(entry, arguments.params_for(range.start, count))?;
        let params = &self.pool.buffers[self.used - 1].1;
        let bind_group = context.guarded(
            || format!("the arguments of {}", entry.name),
            || context.bind_group(&kernel.layout, params, &arguments.bound, 0, count),
        )?;
        let mut pass = self
            .encoder
            .begin_compute_pass(&wgpu::ComputePassDescriptor {
                label: Some(&entry.name),
                timestamp_writes: None,
            });
        pass.set_pipeline(&kernel.pipeline);
        pass.set_bind_group(0, &bind_group, &[]);
        pass.dispatch_workgroups(columns, rows, 1);
        Ok(())
    }

    /// Notes the GPU's time when it comes to this point.
    pub fn mark(&mut self, stopwatch: Option<&Stopwatch>, index: u32) {
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
        let fits = |(space, buffer): &(ParamsSpace, wgpu::Buffer)| {
            *space == entry.params_space && buffer.size() == size
        };
        if !known.is_some_and(fits) {
            let made = self.context.params_buffer(entry)?;
            self.pool.buffers.truncate(self.used);
            self.pool.buffers.push((entry.params_space, made));
        }
        let buffer = &self.pool.buffers[self.used].1;
        self.context.write_params(entry, buffer, bytes)?;
        self.used += 1;
        Ok(())
    }

    /// Hands everything over.
    ///
    /// # Errors
    /// [`GpuError::Refused`] where wgpu finds fault with what was recorded, [`GpuError::OutOfMemory`], [`GpuError::Lost`].
    pub fn submit(self) -> Result<wgpu::SubmissionIndex, GpuError> {
        let (context, encoder) = (self.context, self.encoder);
        context.guarded(
            || "a frame's passes".to_owned(),
            || context.queue().submit([encoder.finish()]),
        )
    }
}

fn check_bound(
    context: &GpuContext,
    entry: &Entry,
    bound: &Bound,
    count: u32,
) -> Result<(), GpuError> {
    let path = &entry.buffers[bound.slot].path;
    let (bytes, most) = (bound.bytes(count), context.max_binding_bytes());
    if bytes > most {
        let what = format!("argument '{path}' of {}", entry.name);
        return Err(context.limit_error(what, bytes, "max_storage_buffer_binding_size", most));
    }
    let alignment = context.limits().min_storage_buffer_offset_alignment;
    bound.check_alignment(entry, alignment.into())
}
