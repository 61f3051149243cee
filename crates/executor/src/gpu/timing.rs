//! Host file: GPU time of dispatches, by timestamps.

use std::time::Duration;

use super::device::GpuContext;
use super::error::GpuError;

/// Timestamps around a compute pass, or at marks between passes, and the way back for them.
#[derive(Debug)]
pub struct Stopwatch {
    queries: wgpu::QuerySet,
    resolved: wgpu::Buffer,
    staging: wgpu::Buffer,
    count: usize,
}

/// Bytes of a timestamp: ticks, a `u64`.
const BYTES: u64 = 8;

impl Stopwatch {
    /// With so many timestamps, at least two.
    ///
    /// # Errors
    /// [`GpuError::OutOfMemory`], [`GpuError::Refused`] where the adapter offers no timestamps.
    pub fn new(context: &GpuContext, count: usize) -> Result<Self, GpuError> {
        let buffer = |usage| {
            let descriptor = wgpu::BufferDescriptor {
                label: Some("timestamps"),
                size: BYTES * count as u64,
                usage,
                mapped_at_creation: false,
            };
            context.device().create_buffer(&descriptor)
        };
        context.guarded(
            || "making a timestamp query".to_owned(),
            || Self {
                queries: context
                    .device()
                    .create_query_set(&wgpu::QuerySetDescriptor {
                        label: Some("timestamps"),
                        ty: wgpu::QueryType::Timestamp,
                        count: count as u32,
                    }),
                resolved: buffer(wgpu::BufferUsages::QUERY_RESOLVE | wgpu::BufferUsages::COPY_SRC),
                staging: buffer(wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ),
                count,
            },
        )
    }

    pub(super) fn writes(&self) -> wgpu::ComputePassTimestampWrites<'_> {
        wgpu::ComputePassTimestampWrites {
            query_set: &self.queries,
            beginning_of_pass_write_index: Some(0),
            end_of_pass_write_index: Some(1),
        }
    }

    /// A mark is the beginning of a pass.
    pub(super) fn mark(&self, index: u32) -> wgpu::ComputePassTimestampWrites<'_> {
        wgpu::ComputePassTimestampWrites {
            query_set: &self.queries,
            beginning_of_pass_write_index: Some(index),
            end_of_pass_write_index: None,
        }
    }

    /// Records that the timestamps go to where [`Stopwatch::read`] finds them.
    pub fn resolve(&self, encoder: &mut wgpu::CommandEncoder) {
        let bytes = BYTES * self.count as u64;
        encoder.resolve_query_set(&self.queries, 0..self.count as u32, &self.resolved, 0);
        encoder.copy_buffer_to_buffer(&self.resolved, 0, &self.staging, 0, bytes);
    }

    /// The times between each of them and the next, once `submission` is done.
    ///
    /// # Errors
    /// As [`GpuContext::read`].
    pub fn read(
        &self,
        context: &GpuContext,
        submission: wgpu::SubmissionIndex,
    ) -> Result<Vec<Duration>, GpuError> {
        let mut ticks = vec![0u64; self.count];
        let target = bytemuck::cast_slice_mut(&mut ticks);
        context.read_mapped(&self.staging, target, submission, || {
            "reading timestamps".to_owned()
        })?;
        let period = f64::from(context.queue().get_timestamp_period());
        let passed = ticks.windows(2).map(|pair| {
            let elapsed = pair[1].saturating_sub(pair[0]) as f64 * period;
            Duration::from_nanos(elapsed as u64)
        });
        Ok(passed.collect())
    }
}
