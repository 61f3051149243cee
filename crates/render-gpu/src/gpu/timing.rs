//! Host file: GPU time of one dispatch, by timestamps.

use std::time::Duration;

use super::device::GpuContext;
use super::error::GpuError;

/// Two timestamps around a compute pass, and the way back for them.
#[derive(Debug)]
pub(super) struct Stopwatch {
    queries: wgpu::QuerySet,
    resolved: wgpu::Buffer,
    staging: wgpu::Buffer,
}

/// Two `u64` ticks.
const BYTES: u64 = 16;

impl Stopwatch {
    pub(super) fn new(context: &GpuContext) -> Result<Self, GpuError> {
        let buffer = |usage| {
            let descriptor = wgpu::BufferDescriptor {
                label: Some("timestamps"),
                size: BYTES,
                usage,
                mapped_at_creation: false,
            };
            context.device.create_buffer(&descriptor)
        };
        context.guarded(
            || "making a timestamp query".to_owned(),
            || Self {
                queries: context.device.create_query_set(&wgpu::QuerySetDescriptor {
                    label: Some("timestamps"),
                    ty: wgpu::QueryType::Timestamp,
                    count: 2,
                }),
                resolved: buffer(wgpu::BufferUsages::QUERY_RESOLVE | wgpu::BufferUsages::COPY_SRC),
                staging: buffer(wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ),
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

    pub(super) fn resolve(&self, encoder: &mut wgpu::CommandEncoder) {
        encoder.resolve_query_set(&self.queries, 0..2, &self.resolved, 0);
        encoder.copy_buffer_to_buffer(&self.resolved, 0, &self.staging, 0, BYTES);
    }

    /// The time between the two, once `submission` is done.
    pub(super) fn read(
        &self,
        context: &GpuContext,
        submission: wgpu::SubmissionIndex,
    ) -> Result<Duration, GpuError> {
        let mut ticks = [0u64; 2];
        let target = bytemuck::cast_slice_mut(&mut ticks);
        context.read_mapped(&self.staging, target, submission, || {
            "reading timestamps".to_owned()
        })?;
        let elapsed = ticks[1].saturating_sub(ticks[0]) as f64
            * f64::from(context.queue.get_timestamp_period());
        Ok(Duration::from_nanos(elapsed as u64))
    }
}
