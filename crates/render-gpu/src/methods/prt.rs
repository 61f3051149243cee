//! Host file: settings of frames that are drawn by precomputed radiance transfer (Hajisharif 2012). What draws them is a renderer of
//! its own: [`CpuDrawing`](crate::cpu::CpuDrawing), [`GpuDrawing`](crate::gpu::GpuDrawing).

use crate::settings::{any, at_most, between, settings};

settings! {
    /// Precomputed radiance transfer: light and transfer as spherical harmonics. The scene must have a
    /// [`Transfer`](crate::prepare::transfer::Transfer).
    Prt in "prt" {
        /// How often the light map is halved before it is projected.
        level: u32 = 0, at_most(15), "0 projects the light map as it is, 1 after halving it once";
        /// Width w of the Hann window on the light's coefficients, against ringing: as wide as there are bands is usual; 0 for none.
        window: f32 = 0.0, between(0.0, 1e6), "as many as there are bands is usual; 0 for no window";
        /// Share α of the frame before in the filter over time (Eq. 13): `(now + α · before)/(1 + α)`; 0 for none.
        temporal: f32 = 0.0, between(0.0, 1e6),
            "0 takes each frame's light as it is, 1 as much of the frame before";
        /// Whether objects cast shadows.
        shadows: bool = true, any, "";
    }
}
