//! Host file: frames on a GPU.
//!
//! [`GpuRenderer`] renders frames by the passes that the CPU runs, too; [`GpuDrawing`] draws triangles instead, by a rasteriser. What
//! opens the GPU and launches passes is [`glimt_executor::gpu`]; its names stand here, too.

mod bake;
mod drawing;
mod light;
mod prt;
mod raster;
mod renderer;
mod unwarp;
mod upload;

/// The shaders that are written by hand, around functions made from Rust.
pub const HAND_WRITTEN: [&str; 2] = [light::WGSL, raster::WGSL];

pub use bake::bake;
pub use drawing::GpuDrawing;
pub use glimt_executor::gpu::{
    AdapterPreference, AdapterSummary, Arg, GpuBuffer, GpuContext, GpuError, GpuOptions, GpuVec,
    LaunchReport, enumerate,
};
pub use light::GpuLight;
pub use prt::{DrawTimes, GpuPrt};
pub use renderer::{FrameTimes, GpuRenderer};
pub use unwarp::GpuUnwarp;
pub use upload::{GpuEnv, GpuScene};

#[cfg(test)]
mod tests {
    use core::mem::offset_of;

    use super::*;
    use crate::kernels::raster::RasterParams;

    /// Members of a struct of a shader with their offsets, and its size.
    fn layout(wgsl: &str, name: &str) -> (Vec<(String, u32)>, u32) {
        let module = wgpu::naga::front::wgsl::parse_str(wgsl).expect("a shader");
        let mut types = module.types.iter().map(|(_, own)| own);
        let found = types.find(|own| own.name.as_deref() == Some(name));
        match &found.expect("the struct").inner {
            wgpu::naga::TypeInner::Struct { members, span } => {
                let member =
                    |m: &wgpu::naga::StructMember| (m.name.clone().unwrap_or_default(), m.offset);
                (members.iter().map(member).collect(), *span)
            }
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn params_of_hand_written_shaders_lie_as_in_rust() {
        let own = |list: &[(&str, usize)]| -> Vec<(String, u32)> {
            let each = list.iter();
            each.map(|(name, offset)| ((*name).to_owned(), *offset as u32))
                .collect()
        };
        let raster = own(&[
            ("frame", offset_of!(RasterParams, frame)),
            ("map_size", offset_of!(RasterParams, map_size)),
            ("map_rotation", offset_of!(RasterParams, map_rotation)),
            ("near", offset_of!(RasterParams, near)),
            ("scale", offset_of!(RasterParams, scale)),
            ("samples", offset_of!(RasterParams, samples)),
            ("unused", offset_of!(RasterParams, unused)),
        ]);
        let size = size_of::<RasterParams>() as u32;
        assert_eq!(layout(raster::WGSL, "RasterParams"), (raster, size));
        let fields: Vec<_> = light::PARAMS
            .iter()
            .map(|field| (&*field.path, field.offset as usize))
            .collect();
        assert_eq!(layout(light::WGSL, "Projection"), (own(&fields), 16));
    }
}
