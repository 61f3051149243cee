//! Host file: a frame's light as spherical harmonics, on the CPU (Hajisharif 2012, Eqs. 9 to 13).

use glam::Vec4;

use super::env::PreparedEnv;
use super::methods::PrtSettings;
use super::render::SettingsError;

/// Light maps made into coefficients, frame after frame.
#[derive(Clone, Debug, Default)]
pub struct LightSh {
    /// Filtered coefficients of the frame before.
    previous: Option<(u32, [Vec4; 36])>,
}

impl LightSh {
    /// Coefficients of a frame's light in world coordinates, RGB (w is 0): the map halved, projected, windowed, turned with the
    /// map, and filtered over time with the frame before, if that had as many bands. Those beyond `bands²` are 0.
    ///
    /// # Errors
    /// [`SettingsError::Prt`].
    pub fn project(
        &mut self,
        env: &PreparedEnv,
        bands: u32,
        settings: &PrtSettings,
    ) -> Result<[Vec4; 36], SettingsError> {
        settings.check()?;
        let map = env.view().map();
        let mut now = [Vec4::ZERO; 36];
        for row in 0..map.size.y {
            let area = glimt_probe::latlong::texel_solid_angle_sr(row, map.size);
            for column in 0..map.size.x {
                let texel = glam::UVec2::new(column, row);
                let d = glimt_probe::latlong::texel_direction(texel, map.size);
                let d = glimt_probe::rotate::rotate_z(d, map.rotation);
                let texel = map.texels[(row * map.size.x + column) as usize];
                let y = glimt_sh::basis(d);
                for k in 0..(bands * bands) as usize {
                    let l = (k as f32).sqrt() as u32;
                    let scale = y[k] * area * glimt_sh::hann(l, settings.window);
                    now[k] += texel.truncate().extend(0.0) * scale;
                }
            }
        }
        if let Some((n, before)) = &self.previous
            && *n == bands
        {
            for (c, b) in now.iter_mut().zip(before) {
                *c = (*c + *b * settings.temporal) / (1.0 + settings.temporal);
            }
        }
        self.previous = Some((bands, now));
        Ok(now)
    }
}
