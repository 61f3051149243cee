//! Host file: buffers, and the ways in and out of them.

use std::marker::PhantomData;
use std::ops::Deref;
use std::sync::mpsc;
use std::time::{Duration, Instant};

use super::device::GpuContext;
use super::error::GpuError;
use super::memory::Gpu;
use crate::memory::{Device, Element};

/// The most bytes of a copy back to the host at a time, so that staging stays small.
const STAGING_BYTES: u64 = 64 << 20;

/// A storage buffer on the GPU.
#[derive(Debug)]
pub struct GpuBuffer {
    raw: wgpu::Buffer,
    label: String,
}

/// A storage buffer that holds values of one type: what a `Vec` is on the CPU, but for its length, which is fixed.
#[derive(Debug)]
pub struct GpuVec<T> {
    buffer: GpuBuffer,
    values: PhantomData<fn() -> T>,
}

impl<T> Deref for GpuVec<T> {
    type Target = GpuBuffer;

    fn deref(&self) -> &GpuBuffer {
        &self.buffer
    }
}

impl<T: Element> GpuVec<T> {
    /// How many values there are.
    #[must_use]
    pub fn count(&self) -> u64 {
        self.buffer.len() / size_of::<T>().max(1) as u64
    }
}

impl GpuBuffer {
    /// Its size in bytes.
    #[must_use]
    pub fn len(&self) -> u64 {
        self.raw.size()
    }

    /// Always false: WGSL knows no empty buffer.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.raw.size() == 0
    }

    /// The name it was made with.
    #[must_use]
    pub fn label(&self) -> &str {
        &self.label
    }

    /// What wgpu knows it by, for passes of one's own.
    #[must_use]
    pub fn raw(&self) -> &wgpu::Buffer {
        &self.raw
    }
}

impl GpuContext {
    /// A buffer of `bytes` bytes, all zero. Its name appears in errors.
    ///
    /// # Errors
    ///
    /// [`GpuError::Limit`] when it is larger than the adapter allows, [`GpuError::OutOfMemory`], and
    /// [`GpuError::Argument`] when its size is zero or not a multiple of 4.
    pub fn buffer(&self, label: &str, bytes: u64) -> Result<GpuBuffer, GpuError> {
        if bytes == 0 || !bytes.is_multiple_of(4) {
            let problem =
                format!("a buffer of {bytes} bytes; it must be a multiple of 4 and not empty");
            return Err(GpuError::Argument {
                entry: label.to_owned(),
                problem,
            });
        }
        if bytes > self.limits().max_buffer_size {
            let what = format!("buffer '{label}'");
            return Err(self.limit_error(
                what,
                bytes,
                "max_buffer_size",
                self.limits().max_buffer_size,
            ));
        }
        let usage = wgpu::BufferUsages::STORAGE
            | wgpu::BufferUsages::COPY_DST
            | wgpu::BufferUsages::COPY_SRC;
        let descriptor = wgpu::BufferDescriptor {
            label: Some(label),
            size: bytes,
            usage,
            mapped_at_creation: false,
        };
        let raw = self.guarded(
            || format!("making buffer '{label}' of {bytes} bytes"),
            || self.device().create_buffer(&descriptor),
        )?;
        Ok(GpuBuffer {
            raw,
            label: label.to_owned(),
        })
    }

    /// Room for `count` values, all bytes zero.
    ///
    /// # Errors
    ///
    /// As [`Self::buffer`].
    pub fn zeroed<T: Element>(&self, label: &str, count: u64) -> Result<GpuVec<T>, GpuError> {
        let bytes = count.saturating_mul(size_of::<T>() as u64);
        Ok(GpuVec {
            buffer: self.buffer(label, bytes)?,
            values: PhantomData,
        })
    }

    /// As [`Self::zeroed`], for what a shader binds whole: refused now where it does not fit a binding.
    ///
    /// # Errors
    ///
    /// As [`Self::buffer`], and [`GpuError::Limit`] where it is larger than a binding may be.
    pub fn zeroed_binding<T: Element>(
        &self,
        label: &str,
        count: u64,
    ) -> Result<GpuVec<T>, GpuError> {
        let bytes = count.saturating_mul(size_of::<T>() as u64);
        let allowed = self.max_binding_bytes();
        if bytes > allowed {
            let limit = "max_storage_buffer_binding_size";
            return Err(self.limit_error(label.to_owned(), bytes, limit, allowed));
        }
        self.zeroed(label, count)
    }

    /// The values of a list, for what a shader binds whole.
    ///
    /// # Errors
    ///
    /// As [`Self::zeroed_binding`].
    pub fn binding_of<T: Element>(&self, label: &str, values: &[T]) -> Result<GpuVec<T>, GpuError> {
        let made = self.zeroed_binding(label, values.len() as u64)?;
        self.write(&made, values)?;
        Ok(made)
    }

    /// A buffer that holds `values`.
    ///
    /// # Errors
    ///
    /// As [`Self::buffer`].
    pub fn buffer_of<T: bytemuck::NoUninit>(
        &self,
        label: &str,
        values: &[T],
    ) -> Result<GpuBuffer, GpuError> {
        let buffer = self.buffer(label, size_of_val(values) as u64)?;
        self.write(&buffer, values)?;
        Ok(buffer)
    }

    /// Puts `values` at the start of `buffer`, before any launch that comes later and after any that came before.
    ///
    /// # Errors
    ///
    /// [`GpuError::Argument`] when they do not fit.
    pub fn write<T: bytemuck::NoUninit>(
        &self,
        buffer: &GpuBuffer,
        values: &[T],
    ) -> Result<(), GpuError> {
        self.write_at(buffer, 0, values)
    }

    /// As [`Self::write`], from byte `offset` of the buffer on.
    ///
    /// # Errors
    ///
    /// [`GpuError::Argument`] when they do not fit, or the offset is not a multiple of 4.
    pub fn write_at<T: bytemuck::NoUninit>(
        &self,
        buffer: &GpuBuffer,
        offset: u64,
        values: &[T],
    ) -> Result<(), GpuError> {
        let bytes: &[u8] = bytemuck::cast_slice(values);
        let end = offset.saturating_add(bytes.len() as u64);
        if end > buffer.len() || !bytes.len().is_multiple_of(4) || !offset.is_multiple_of(4) {
            let problem = format!(
                "{} bytes written to byte {offset} of a buffer of {}",
                bytes.len(),
                buffer.len()
            );
            return Err(GpuError::Argument {
                entry: buffer.label.clone(),
                problem,
            });
        }
        self.guarded(
            || format!("writing {} bytes to '{}'", bytes.len(), buffer.label),
            || self.queue().write_buffer(&buffer.raw, offset, bytes),
        )
    }

    /// Copies the first `bytes` bytes of one buffer to the start of another, after all launches so far.
    ///
    /// # Errors
    ///
    /// [`GpuError::Argument`] where one is shorter.
    pub fn copy(&self, from: &GpuBuffer, to: &GpuBuffer, bytes: u64) -> Result<(), GpuError> {
        if bytes > from.len().min(to.len()) || !bytes.is_multiple_of(4) {
            let problem = format!(
                "{bytes} bytes copied from a buffer of {} to '{}' of {}",
                from.len(),
                to.label,
                to.len()
            );
            return Err(GpuError::Argument {
                entry: from.label.clone(),
                problem,
            });
        }
        self.guarded(
            || format!("copying {bytes} bytes from '{}'", from.label),
            || {
                let mut encoder = self
                    .device()
                    .create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
                encoder.copy_buffer_to_buffer(&from.raw, 0, &to.raw, 0, bytes);
                self.queue().submit([encoder.finish()]);
            },
        )
    }

    /// The first `count` values of `buffer`, after all launches so far.
    ///
    /// # Errors
    ///
    /// [`GpuError::Argument`] when it is shorter, [`GpuError::TimedOut`], [`GpuError::Lost`].
    pub fn read<T: bytemuck::AnyBitPattern + bytemuck::NoUninit>(
        &self,
        buffer: &GpuBuffer,
        count: usize,
    ) -> Result<Vec<T>, GpuError> {
        let bytes = (count * size_of::<T>()) as u64;
        if bytes > buffer.len() || !bytes.is_multiple_of(4) {
            let problem = format!("{bytes} bytes read from a buffer of {}", buffer.len());
            return Err(GpuError::Argument {
                entry: buffer.label.clone(),
                problem,
            });
        }
        let mut values = vec![T::zeroed(); count];
        let target: &mut [u8] = bytemuck::cast_slice_mut(&mut values);
        if bytes == 0 {
            return Ok(values);
        }
        let what = || format!("reading {bytes} bytes from '{}'", buffer.label);
        let usage = wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST;
        let size = bytes.min(STAGING_BYTES);
        let descriptor = wgpu::BufferDescriptor {
            label: Some("read back"),
            size,
            usage,
            mapped_at_creation: false,
        };
        let staging = self.guarded(what, || self.device().create_buffer(&descriptor))?;
        for (index, piece) in target.chunks_mut(STAGING_BYTES as usize).enumerate() {
            let size = piece.len() as u64;
            let submission = self.guarded(what, || {
                let mut encoder = self
                    .device()
                    .create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
                encoder.copy_buffer_to_buffer(
                    &buffer.raw,
                    index as u64 * STAGING_BYTES,
                    &staging,
                    0,
                    size,
                );
                self.queue().submit([encoder.finish()])
            })?;
            self.read_mapped(&staging, piece, submission, what)?;
        }
        Ok(values)
    }

    /// Copies the start of a staging buffer to `target` once `submission`, which fills it, is done. Whatever comes of it, the buffer
    /// may be filled and read again.
    pub(super) fn read_mapped(
        &self,
        staging: &wgpu::Buffer,
        target: &mut [u8],
        submission: wgpu::SubmissionIndex,
        what: impl Fn() -> String,
    ) -> Result<(), GpuError> {
        let done = self.copy_mapped(staging, target, submission, &what);
        if done.is_err() {
            // It may be mapped, or about to be, or neither.
            let _ = self.guarded(&what, || staging.unmap());
        }
        done
    }

    fn copy_mapped(
        &self,
        staging: &wgpu::Buffer,
        target: &mut [u8],
        submission: wgpu::SubmissionIndex,
        what: impl Fn() -> String,
    ) -> Result<(), GpuError> {
        let (sender, receiver) = mpsc::channel();
        let range = 0..target.len() as u64;
        self.guarded(&what, || {
            staging.map_async(wgpu::MapMode::Read, range.clone(), move |result| {
                // The receiver lives until the end of this function; a late answer has no one to hear it.
                sender.send(result).unwrap_or_default();
            });
        })?;
        self.wait(submission, &what)?;
        let refused = |reason: String| GpuError::Refused {
            adapter: self.adapter().to_string(),
            what: what(),
            reason,
        };
        // The copy is done, but another thread's poll may have taken the news of it, and be about to tell.
        let deadline = Instant::now() + self.options.time_out;
        loop {
            match receiver.recv_timeout(Duration::from_millis(1)) {
                Ok(Ok(())) => break,
                Ok(Err(error)) => return Err(refused(error.to_string())),
                Err(_) if Instant::now() < deadline => self.poll(&what)?,
                Err(_) => return Err(self.timed_out(&what)),
            }
        }
        {
            let view = staging
                .get_mapped_range(range)
                .map_err(|error| refused(error.to_string()))?;
            target.copy_from_slice(&view);
        }
        staging.unmap();
        Ok(())
    }
}

impl Device for GpuContext {
    type Memory = Gpu;
    type Error = GpuError;

    fn zeroed<T: Element + bytemuck::Zeroable>(
        &self,
        label: &str,
        count: usize,
    ) -> Result<GpuVec<T>, GpuError> {
        Self::zeroed(self, label, count.max(1) as u64)
    }

    fn holding<T: Element>(&self, label: &str, values: &[T]) -> Result<GpuVec<T>, GpuError> {
        let made = Self::zeroed(self, label, values.len() as u64)?;
        self.write(&made, values)?;
        Ok(made)
    }

    fn put<T: Element>(&self, buffer: &mut GpuVec<T>, values: &[T]) -> Result<(), GpuError> {
        self.write(buffer, values)
    }

    fn get<T: Element + bytemuck::AnyBitPattern>(
        &self,
        buffer: &GpuVec<T>,
        count: usize,
    ) -> Result<Vec<T>, GpuError> {
        self.read(buffer, count)
    }
}
