//! Host file: a frame's light as spherical harmonics, on the CPU (Hajisharif 2012, Eqs. 9 to 13).

use glam::{UVec2, Vec2, Vec4};
use rayon::prelude::*;

use super::env::PreparedEnv;
use super::methods::PrtSettings;
use super::render::SettingsError;
use crate::kernels::environment::RadianceMap;
use crate::kernels::light_sh::{
    LightParams, column_ring, light_coefficient, row_area, row_meridian,
};
use crate::kernels::pyramid::{half_size, halve};

/// Rows whose sums are added before they go to the others': the same ones, whatever the threads.
const BLOCK_ROWS: u32 = 16;

/// Light maps made into coefficients, frame after frame.
#[derive(Clone, Debug, Default)]
pub struct LightSh {
    /// The maps halved, the largest first; kept for their room.
    levels: Vec<Vec<Vec4>>,
    /// The factors of φ of so many columns.
    rings: Vec<[f32; 11]>,
    history: History,
}

/// What the filter over time goes on from.
#[derive(Clone, Debug, Default)]
pub(crate) struct History {
    /// Bands of the frame before, and its filtered coefficients.
    previous: Option<(u32, [Vec4; 36])>,
}

/// How the sums of a frame become its coefficients; without the frame before if that had another number of bands, given in
/// `before`.
pub(crate) fn light_params(
    settings: &PrtSettings,
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
    /// map, and filtered over time with the frame before, if that had as many bands. Those beyond `bands²` are 0; more than six
    /// bands are six.
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
        let bands = bands.min(glimt_sh::MAX_BANDS);
        let map = env.view().map();
        let sums = self.sums(&map, bands, settings.level);
        let before = self.history.previous.as_ref().map(|(bands, _)| *bands);
        let light = light_params(settings, map.rotation, bands, before);
        let previous = self
            .history
            .previous
            .map_or([Vec4::ZERO; 36], |(_, coefficients)| coefficients);
        let now = std::array::from_fn(|k| light_coefficient(k as u32, &light, &sums, &previous));
        self.history.previous = Some((bands, now));
        Ok(now)
    }

    /// The map halved `level` times, with its size.
    pub fn level<'a>(&'a mut self, map: &RadianceMap<'a>, level: u32) -> (UVec2, &'a [Vec4]) {
        let sizes = level_sizes(map.size, level);
        self.levels.resize(sizes.len() - 1, Vec::new());
        for (i, pair) in sizes.windows(2).enumerate() {
            let (done, rest) = self.levels.split_at_mut(i);
            let from = done.last().map_or(map.texels, Vec::as_slice);
            let (size, half) = (pair[0], pair[1]);
            let texels = 0..half.x * half.y;
            texels
                .into_par_iter()
                .with_min_len(1024)
                .map(|texel| halve(texel, size, from))
                .collect_into_vec(&mut rest[0]);
        }
        let texels = self.levels.last().map_or(map.texels, Vec::as_slice);
        (sizes[sizes.len() - 1], texels)
    }

    /// `Σ L y_k ΔΩ` over the map halved, in its own coordinates.
    fn sums(&mut self, map: &RadianceMap<'_>, bands: u32, level: u32) -> [Vec4; 36] {
        let mut rings = std::mem::take(&mut self.rings);
        let (size, texels) = self.level(map, level);
        if rings.len() != size.x as usize {
            rings = (0..size.x).map(|i| column_ring(i, size.x)).collect();
        }
        let blocks = texels.par_chunks((size.x * BLOCK_ROWS) as usize);
        let of_block = |(block, texels): (usize, &[Vec4])| {
            let first = block as u32 * BLOCK_ROWS;
            match bands {
                0 => [Vec4::ZERO; 36],
                1 => block_sums::<1>(bands, first, size, texels, &rings),
                2 => block_sums::<3>(bands, first, size, texels, &rings),
                3 => block_sums::<5>(bands, first, size, texels, &rings),
                4 => block_sums::<7>(bands, first, size, texels, &rings),
                5 => block_sums::<9>(bands, first, size, texels, &rings),
                _ => block_sums::<11>(bands, first, size, texels, &rings),
            }
        };
        let partial: Vec<[Vec4; 36]> = blocks.enumerate().map(of_block).collect();
        let mut sums = [Vec4::ZERO; 36];
        for block in partial {
            for (sum, part) in sums.iter_mut().zip(block) {
                *sum += part;
            }
        }
        self.rings = rings;
        sums
    }
}

/// The sums over some rows, the first of them `first`, by way of M = 2n − 1 sums over φ in each.
fn block_sums<const M: usize>(
    bands: u32,
    first: u32,
    size: UVec2,
    texels: &[Vec4],
    rings: &[[f32; 11]],
) -> [Vec4; 36] {
    let mut sums = [Vec4::ZERO; 36];
    for (row, texels) in (first..).zip(texels.chunks(rings.len())) {
        let mut over_phi = [Vec4::ZERO; M];
        for (texel, ring) in texels.iter().zip(rings) {
            for (sum, factor) in over_phi.iter_mut().zip(ring) {
                *sum += *texel * *factor;
            }
        }
        let area = row_area(row, size);
        let of_theta = row_meridian(row, size).map(|factor| factor * area);
        for l in 0..bands as usize {
            let (centre, theta) = (l * (l + 1), &of_theta[l * (l + 1) / 2..]);
            sums[centre] += over_phi[0] * theta[0];
            for m in 1..=l {
                sums[centre + m] += over_phi[2 * m - 1] * theta[m];
                sums[centre - m] += over_phi[2 * m] * theta[m];
            }
        }
    }
    sums
}
