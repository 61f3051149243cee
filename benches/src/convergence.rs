//! Host file: how coefficients converge: those of light with the size of its map, those of transfer with the number of directions.

use crate::inputs::bunny;
use crate::scene::on_a_plane;
use glimt_render_gpu::methods::Prt;
use glimt_render_gpu::prepare::bake::{BakeError, BakeSettings, bake};
use glimt_render_gpu::prepare::env::PreparedEnv;
use glimt_render_gpu::prepare::light_sh::LightSh;
use glimt_render_gpu::prepare::render::SettingsError;
use glimt_render_gpu::prepare::scene_build::SceneBuffers;

/// Bands of both.
pub const BANDS: u32 = 5;

/// By how much of the largest a coefficient of a light changes at most when its map is halved so often.
///
/// # Errors
/// A map too large to be projected.
pub fn halved(env: &PreparedEnv, level: u32) -> Result<f32, SettingsError> {
    let of = |level| {
        let settings = Prt {
            level,
            ..Prt::default()
        };
        LightSh::default().project(env, BANDS, &settings)
    };
    let (whole, halved) = (of(0)?, of(level)?);
    let change = whole.iter().zip(&halved).map(|(a, b)| (*a - *b).length());
    Ok(change.fold(0.0, f32::max) / whole.iter().map(|c| c.length()).fold(0.0, f32::max))
}

/// The root mean square error of a coefficient of transfer without shadows, by so many directions: over the first [`BANDS`] of all
/// vertices of the rabbit on a plane, against the closed form `A_l y_lm(n)`.
///
/// # Errors
/// As [`bake`]'s.
pub fn transfer_error(directions: u32) -> Result<f64, BakeError> {
    let scene = SceneBuffers::build(&on_a_plane(&bunny()))?;
    let settings = BakeSettings {
        bands: BANDS,
        directions,
        seed: 1,
    };
    let baked = bake(&scene, &settings, &|_| ())?;
    let count = (BANDS * BANDS) as usize;
    let parts = baked.transfer.lit.chunks(count);
    let parts = parts.zip(baked.transfer.blocked.chunks(count));
    let (mut sum, mut n) = (0.0, 0);
    for (vertex, (lit, blocked)) in baked.vertices.iter().zip(parts) {
        // A vertex without faces has no transfer.
        if vertex.normal.length_squared() > 0.0 {
            let y = glimt_sh::basis(vertex.normal);
            for k in 0..count {
                let whole = glimt_sh::cosine_lobe(glimt_sh::coefficient_band(k as u32)) * y[k];
                sum += f64::from(lit[k] + blocked[k] - whole).powi(2);
                n += 1;
            }
        }
    }
    Ok((sum / f64::from(n)).sqrt())
}
