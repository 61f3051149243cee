//! Host file: a frame's light as spherical harmonics, on the CPU (Hajisharif 2012, Eqs. 9 to 13).

use glam::{UVec2, Vec2, Vec4};
use glimt_sh::{MAX_COEFFICIENTS, ShError};
use rayon::prelude::*;

use super::env::PreparedEnv;
use super::projection::Projector;
use super::render::SettingsError;
use crate::kernels::environment::RadianceMap;
use crate::kernels::light_sh::{LightParams, light_coefficient};
use crate::kernels::pyramid::{Taps, half_size, halve, taps};
use crate::methods::Prt;

/// Floats in a texel.
const CHANNELS: u32 = 4;

/// Light maps made into coefficients, frame after frame.
#[derive(Clone, Debug, Default)]
pub struct LightSh {
    /// The maps halved, the largest first, with the size of what each is half of and its taps; kept for their room.
    levels: Vec<(UVec2, Vec<Taps>, Vec<Vec4>)>,
    /// Of maps of the size and bands of the frame before.
    projector: Option<Projector>,
    /// Bands of the frame before, and its filtered coefficients.
    previous: Option<(u32, [Vec4; MAX_COEFFICIENTS])>,
}

/// How the sums of a frame become its coefficients; without the frame before if that had another number of bands, given in
/// `before`.
pub(crate) fn light_params(
    settings: &Prt,
    rotation: Vec2,
    bands: u32,
    before: Option<u32>,
) -> LightParams {
    LightParams {
        rotation,
        window: settings.window,
        temporal: if before == Some(bands) {
            settings.temporal
        } else {
            0.0
        },
        bands,
        unused_a: 0,
        unused_b: 0,
        unused_c: 0,
    }
}

/// Sizes of a map and of `level` maps after it, each half of the one before; they end at 1 × 1.
pub(crate) fn level_sizes(size: UVec2, level: u32) -> Vec<UVec2> {
    let mut sizes = vec![size];
    for _ in 0..level {
        let last = sizes[sizes.len() - 1];
        if last == UVec2::ONE {
            break;
        }
        sizes.push(half_size(last));
    }
    sizes
}

impl LightSh {
    /// Coefficients of a frame's light in world coordinates, RGB (w is 0): the map halved, projected, windowed, turned with the
    /// map, and filtered over time with the frame before, if that had as many bands. Those beyond `bands²` are 0.
    ///
    /// # Errors
    /// [`SettingsError::Setting`]; [`SettingsError::Harmonics`] where `bands` is not 1 to 6, or the map is wider or higher than 2²⁰.
    pub fn project(
        &mut self,
        env: &PreparedEnv,
        bands: u32,
        settings: &Prt,
    ) -> Result<[Vec4; MAX_COEFFICIENTS], SettingsError> {
        settings.check()?;
        let map = env.view().map();
        let sums = self
            .sums(&map, bands, settings.level)
            .map_err(SettingsError::Harmonics)?;
        let (before, previous) = match self.previous {
            Some((bands, coefficients)) => (Some(bands), coefficients),
            None => (None, [Vec4::ZERO; MAX_COEFFICIENTS]),
        };
        let light = light_params(settings, map.rotation, bands, before);
        let now = std::array::from_fn(|k| light_coefficient(k as u32, &light, &sums, &previous));
        self.previous = Some((bands, now));
        Ok(now)
    }

    /// The map halved `level` times, with its size.
    pub fn level<'a>(&'a mut self, map: &RadianceMap<'a>, level: u32) -> (UVec2, &'a [Vec4]) {
        let sizes = level_sizes(map.size, level);
        self.levels.resize_with(sizes.len() - 1, Default::default);
        for (i, pair) in sizes.windows(2).enumerate() {
            let (done, rest) = self.levels.split_at_mut(i);
            let from = done.last().map_or(map.texels, |level| &level.2);
            let (size, half) = (pair[0], pair[1]);
            let (known, own, texels) = &mut rest[0];
            if *known != size {
                *own = (0..half.x + half.y).map(|i| taps(i, size)).collect();
                *known = size;
            }
            (0..half.x * half.y)
                .into_par_iter()
                .with_min_len(1024)
                .map(|texel| halve(texel, size, own, from))
                .collect_into_vec(texels);
        }
        let texels = self.levels.last().map_or(map.texels, |level| &level.2);
        (sizes[sizes.len() - 1], texels)
    }

    /// `Σ L y_k ΔΩ` over the map halved, in its own coordinates.
    fn sums(
        &mut self,
        map: &RadianceMap<'_>,
        bands: u32,
        level: u32,
    ) -> Result<[Vec4; MAX_COEFFICIENTS], ShError> {
        let known = self.projector.take();
        let (size, texels) = self.level(map, level);
        let known = known.filter(|known| (known.size(), known.bands()) == (size, bands));
        let projector = match known {
            Some(known) => known,
            None => Projector::new(size, bands, CHANNELS)?,
        };
        let sums = projector.project_vec4(texels)?;
        self.projector = Some(projector);
        Ok(sums.map(|c| c.extend(0.0)))
    }
}
