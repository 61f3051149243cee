//! Host file: photographs of a mirror ball to light maps by wgpu.

use glam::Vec4;
use glimt_executor::Executor;
use glimt_executor::gpu::{Direct, GpuContext, GpuError, GpuVec, LaunchReport};
use glimt_probe::gather::TexelTaps;

use crate::generated::passes::{GatherMapArg, Unwarp};
use crate::prepare::unwarp::{Look, UnwarpMap};

/// An [`UnwarpMap`] on the GPU, with room for one photograph and its light map.
#[derive(Debug)]
pub struct GpuUnwarp {
    texels: GpuVec<TexelTaps>,
    taps: GpuVec<u32>,
    photo: GpuVec<Vec4>,
    out: GpuVec<Vec4>,
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
        Ok(Self {
            texels: context.binding_of("the texels of an unwarped map", view.texels)?,
            taps: context.binding_of("the table of an unwarped map", view.taps)?,
            photo: context.zeroed_binding("the photograph", photo)?,
            out: context.zeroed("light map", count.into())?,
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
        let pass = Unwarp {
            colour: &look.colour,
            reflectance: look.reflectance.extend(1.0),
            map: GatherMapArg {
                texels: self.texels.all(),
                taps: self.taps.all(),
            },
            pixels: self.photo.all(),
            out: self.out.out(),
        };
        let mut executor = Direct::new(context);
        executor.run(pass, 0..self.count)?;
        Ok(executor.take_report())
    }

    /// The light map that was made last.
    #[must_use]
    pub fn light(&self) -> &GpuVec<Vec4> {
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
