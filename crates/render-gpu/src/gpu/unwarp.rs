//! Host file: photographs of a mirror ball to light maps by wgpu.

use glam::Vec4;

use super::buffer::GpuBuffer;
use super::device::GpuContext;
use super::error::GpuError;
use super::launch::{Arg, LaunchReport};
use crate::generated::UNWARP;
use crate::host::unwarp::{Look, UnwarpMap};

/// An [`UnwarpMap`] on the GPU, with room for one photograph and its light map.
#[derive(Debug)]
pub struct GpuUnwarp {
    texels: GpuBuffer,
    taps: GpuBuffer,
    photo: GpuBuffer,
    out: GpuBuffer,
    count: u32,
}

impl GpuUnwarp {
    /// Uploads a table.
    ///
    /// # Errors
    /// [`GpuError::Limit`] where the table or a photograph is larger than a binding may be, and
    /// [`GpuError::OutOfMemory`].
    pub fn new(context: &GpuContext, map: &UnwarpMap) -> Result<Self, GpuError> {
        let view = map.view();
        let count = map.size().x * map.size().y;
        let photo = u64::from(map.photo().x) * u64::from(map.photo().y);
        let vec4 = size_of::<Vec4>() as u64;
        for (what, bytes) in [
            ("the photograph", photo * vec4),
            (
                "the table of an unwarped map",
                size_of_val(view.taps) as u64,
            ),
        ] {
            let allowed = context.max_binding_bytes();
            if bytes > allowed {
                let limit = "max_storage_buffer_binding_size";
                return Err(context.limit_error(what.to_owned(), bytes, limit, allowed));
            }
        }
        Ok(Self {
            texels: context.buffer_of("map.texels", view.texels)?,
            taps: context.buffer_of("map.taps", view.taps)?,
            photo: context.buffer("pixels", photo * vec4)?,
            out: context.buffer("light map", u64::from(count) * vec4)?,
            count,
        })
    }

    /// The light map of one photograph, left on the GPU: [`GpuUnwarp::light`].
    ///
    /// # Errors
    /// [`GpuError::Argument`] where the photograph is larger than the table's; as [`GpuContext::launch`].
    pub fn run(
        &self,
        context: &GpuContext,
        pixels: &[Vec4],
        look: &Look,
    ) -> Result<LaunchReport, GpuError> {
        context.write(&self.photo, pixels)?;
        let reflectance = look.reflectance.extend(1.0);
        let args = [
            ("colour", Arg::Value(bytemuck::bytes_of(&look.colour))),
            ("reflectance", Arg::Value(bytemuck::bytes_of(&reflectance))),
            ("map.texels", Arg::Buffer(&self.texels)),
            ("map.taps", Arg::Buffer(&self.taps)),
            ("pixels", Arg::Buffer(&self.photo)),
            ("out", Arg::Buffer(&self.out)),
        ];
        context.launch(&UNWARP, &args, 0, self.count)
    }

    /// The light map that was made last.
    #[must_use]
    pub fn light(&self) -> &GpuBuffer {
        &self.out
    }

    /// The light map that was made last, copied back.
    ///
    /// # Errors
    /// As [`GpuContext::read`].
    pub fn read(&self, context: &GpuContext) -> Result<Vec<Vec4>, GpuError> {
        context.read(&self.out, self.count as usize)
    }
}
