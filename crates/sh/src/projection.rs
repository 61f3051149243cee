//! Host file: projections: of a light map row by row, and of any function by samples.

use glam::{UVec2, Vec3};
use glimt_probe::latlong::texel_solid_angle_sr;

use crate::error::{ShError, check_bands, check_len, check_size};
use crate::ring_table::{RingSums, RingTable};
use crate::separable::{meridian_index, ring_index, row_meridian};
use crate::{LightCoefficients, MAX_COEFFICIENTS, basis, coefficient_index};

/// The coefficients of a lat-long map, row by row: `c_lm = Σ L y_lm ΔΩ` over its texels (Hajisharif 2012, Eq. 11), with
/// `y_lm` at the texel's centre and the texel's exact area `Δφ (cos θ₀ − cos θ₁)`, where Eq. 12 prints `2π² sin θ/(w h)`.
///
/// Sums are in f64, so that rows may come in any order and in parts; one that is left out is black.
///
/// ```
/// use glam::UVec2;
/// use glimt_sh::{Projection, RingTable, ShError, build_ring_table_into, ring_table_len};
/// // A grey map of 101 × 50 texels: y_00 alone, times 2 · 4π · y_00 = 2 √4π.
/// let size = UVec2::new(101, 50);
/// let mut table = vec![0.0; ring_table_len(size.x, 4, 3)?];
/// build_ring_table_into(size.x, 4, 3, &mut table)?;
/// let table = RingTable::new(size.x, 4, 3, &table)?;
/// let mut projection = Projection::new(4, size)?;
/// let row = vec![[2.0f32; 3]; 101];
/// for y in 0..size.y {
///     projection.add_row(y, &table.row_sums(row.as_flattened())?)?;
/// }
/// let c = projection.coefficients();
/// assert!((c[0].x - 2.0 * (4.0 * core::f32::consts::PI).sqrt()).abs() < 1e-5);
/// assert!(c[1..6].iter().all(|c| c.length() < 1e-5));
/// # Ok::<(), ShError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Projection {
    bands: u32,
    size: UVec2,
    sums: [[f64; 3]; MAX_COEFFICIENTS],
}

impl Projection {
    /// Of a map of `size` (width, height) texels onto so many bands; black until rows are added.
    ///
    /// # Errors
    /// [`ShError::Bands`], [`ShError::Size`].
    pub fn new(bands: u32, size: UVec2) -> Result<Self, ShError> {
        check_bands(bands)?;
        check_size(size)?;
        Ok(Self {
            bands,
            size,
            sums: [[0.0; 3]; MAX_COEFFICIENTS],
        })
    }

    /// Adds a row from what [`RingTable::row_sums`] makes of it, `row` counted from +z. Sums of more bands serve too.
    ///
    /// # Errors
    /// [`ShError::Row`]; [`ShError::FewBands`] where the sums are of fewer bands than this projects onto.
    pub fn add_row(&mut self, row: u32, ring: &RingSums) -> Result<(), ShError> {
        let (expected, found) = (self.bands, ring.bands);
        if found < expected {
            return Err(ShError::FewBands { expected, found });
        }
        if row >= self.size.y {
            let height = self.size.y;
            return Err(ShError::Row { row, height });
        }
        let meridian = row_meridian(row, self.size);
        let area = f64::from(texel_solid_angle_sr(row, self.size));
        match self.bands {
            1 => add_bands::<1>(&meridian, area, ring, &mut self.sums),
            2 => add_bands::<2>(&meridian, area, ring, &mut self.sums),
            3 => add_bands::<3>(&meridian, area, ring, &mut self.sums),
            4 => add_bands::<4>(&meridian, area, ring, &mut self.sums),
            5 => add_bands::<5>(&meridian, area, ring, &mut self.sums),
            _ => add_bands::<6>(&meridian, area, ring, &mut self.sums),
        }
        Ok(())
    }

    /// Adds the rows from `first` on that `texels` holds, as floats: see [`RingTable::row_sums`].
    ///
    /// # Errors
    /// Those of [`Projection::add_row`], and [`ShError::Length`] where the table is another width's or a row is not whole.
    /// Rows before that are added.
    pub fn add_rows(
        &mut self,
        table: &RingTable<'_>,
        first: u32,
        texels: &[f32],
    ) -> Result<(), ShError> {
        check_len(table.width() as usize, self.size.x as usize)?;
        for (i, texels) in texels.chunks(table.row_len()).enumerate() {
            // No map has a row of the largest number.
            let row = first.saturating_add(u32::try_from(i).unwrap_or(u32::MAX));
            self.add_row(row, &table.row_sums(texels)?)?;
        }
        Ok(())
    }

    /// Adds what another projection of the same map has summed: of other rows, for instance.
    ///
    /// # Errors
    /// [`ShError::Another`] where that has another size or another number of bands; nothing is added then.
    pub fn merge(&mut self, other: &Self) -> Result<(), ShError> {
        if (self.size, self.bands) != (other.size, other.bands) {
            return Err(ShError::Another);
        }
        for (own, other) in self.sums.iter_mut().zip(&other.sums) {
            for (own, other) in own.iter_mut().zip(other) {
                *own += other;
            }
        }
        Ok(())
    }

    /// The coefficients, at [`coefficient_index`]; 0 beyond the bands.
    #[must_use]
    pub fn coefficients(&self) -> LightCoefficients {
        self.sums
            .map(|[r, g, b]| Vec3::new(r as f32, g as f32, b as f32))
    }
}

/// Adds a row's products; the number of bands is a constant, so that no index has to be computed.
fn add_bands<const N: u32>(
    meridian: &[f32; 21],
    area: f64,
    ring: &RingSums,
    sums: &mut [[f64; 3]; MAX_COEFFICIENTS],
) {
    let mut add = |k: u32, factor: f64, ring: &[f64; 3]| {
        let own = &mut sums[k as usize];
        for c in 0..3 {
            own[c] += factor * ring[c];
        }
    };
    for l in 0..N {
        for m in 0..=l {
            let factor = area * f64::from(meridian[meridian_index(l, m) as usize]);
            let m = m as i32;
            add(
                coefficient_index(l, m),
                factor,
                &ring.sums[ring_index(m) as usize],
            );
            if m > 0 {
                add(
                    coefficient_index(l, -m),
                    factor,
                    &ring.sums[ring_index(-m) as usize],
                );
            }
        }
    }
}

/// The coefficients of a function of which samples are known: `c_lm = (4π/N) Σ f(ω_i) y_lm(ω_i)` over N directions that
/// are uniform on the whole sphere (Hajisharif 2012, Eq. 8), such as those of
/// [`stratified_direction`](crate::stratified_direction).
///
/// ```
/// use glam::{UVec2, Vec2, Vec3};
/// use glimt_sh::{SampledProjection, stratified_direction};
/// // A clamped cosine about z, from the centres of 50 × 50 strata.
/// let mut projection = SampledProjection::new();
/// for i in 0..2500 {
///     let d = stratified_direction(i, UVec2::splat(50), Vec2::splat(0.5));
///     projection.add(d, d.z.max(0.0));
/// }
/// let c = projection.coefficients();
/// // π y_00, and 2π/3 y_10 of +z.
/// assert!((c[0] - 0.8862).abs() < 1e-3 && (c[2] - 1.0233).abs() < 1e-3);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SampledProjection {
    sums: [f64; MAX_COEFFICIENTS],
    count: u64,
}

impl Default for SampledProjection {
    fn default() -> Self {
        Self::new()
    }
}

impl SampledProjection {
    /// Without samples.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            sums: [0.0; MAX_COEFFICIENTS],
            count: 0,
        }
    }

    /// Adds the function's value at the unit vector `d`. A value of 0 counts as a sample.
    pub fn add(&mut self, d: Vec3, value: f32) {
        self.count += 1;
        if value != 0.0 {
            for (sum, y) in self.sums.iter_mut().zip(basis(d)) {
                *sum += f64::from(value) * f64::from(y);
            }
        }
    }

    /// Adds the samples of another.
    pub fn merge(&mut self, other: &Self) {
        self.count += other.count;
        for (sum, other) in self.sums.iter_mut().zip(&other.sums) {
            *sum += other;
        }
    }

    /// The number of samples.
    #[must_use]
    pub fn count(&self) -> u64 {
        self.count
    }

    /// The coefficients of all six bands; 0 without samples.
    #[must_use]
    pub fn coefficients(&self) -> [f32; MAX_COEFFICIENTS] {
        let weight = 4.0 * core::f64::consts::PI / self.count.max(1) as f64;
        self.sums.map(|sum| (weight * sum) as f32)
    }
}
