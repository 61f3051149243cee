//! Host file: light maps to coefficients of spherical harmonics, by rayon.

use glam::{UVec2, Vec4};
use glimt_sh::{
    LightCoefficients, Projection, RingTable, ShError, build_ring_table_into, ring_table_len,
};
use rayon::prelude::*;

/// Rows that one thread takes at a time. The sum depends on this number and on nothing else, so threads change no bit.
const ROWS: usize = 16;

/// What projects the maps of a sequence: the table for their width, made once.
#[derive(Clone, Debug)]
pub struct Projector {
    size: UVec2,
    bands: u32,
    channels: u32,
    table: Vec<f32>,
}

impl Projector {
    /// For maps of `size` texels of 3 or 4 floats each.
    ///
    /// # Errors
    /// Bands, size or channels that there are not.
    pub fn new(size: UVec2, bands: u32, channels: u32) -> Result<Self, ShError> {
        let mut table = vec![0.0; ring_table_len(size.x, bands, channels)?];
        build_ring_table_into(size.x, bands, channels, &mut table)?;
        Projection::new(bands, size)?;
        Ok(Self {
            size,
            bands,
            channels,
            table,
        })
    }

    /// Size of its maps.
    #[must_use]
    pub fn size(&self) -> UVec2 {
        self.size
    }

    /// Number of its bands.
    #[must_use]
    pub fn bands(&self) -> u32 {
        self.bands
    }

    /// The coefficients of a map of three channels, rows from +z down. See [`RingTable::row_sums`] for texels that are no
    /// light.
    ///
    /// # Errors
    /// [`ShError::Length`]: the map has another size, or the projector was made for four channels.
    pub fn project(&self, map: &[[f32; 3]]) -> Result<LightCoefficients, ShError> {
        self.project_floats(map.as_flattened())
    }

    /// The coefficients of a map whose texels have a fourth channel, which is left out.
    ///
    /// # Errors
    /// [`ShError::Length`]: the map has another size, or the projector was made for three channels.
    pub fn project_vec4(&self, map: &[Vec4]) -> Result<LightCoefficients, ShError> {
        self.project_floats(bytemuck::cast_slice(map))
    }

    fn project_floats(&self, map: &[f32]) -> Result<LightCoefficients, ShError> {
        let table = RingTable::new(self.size.x, self.bands, self.channels, &self.table)?;
        let expected = table.row_len() * self.size.y as usize;
        let found = map.len();
        if found != expected {
            return Err(ShError::Length { expected, found });
        }
        let black = Projection::new(self.bands, self.size)?;
        let parts = map.par_chunks(ROWS * table.row_len()).enumerate();
        let parts: Vec<Projection> = parts
            .map(|(part, rows)| {
                let mut projection = black;
                projection.add_rows(&table, (part * ROWS) as u32, rows)?;
                Ok(projection)
            })
            .collect::<Result<_, ShError>>()?;
        let mut all = black;
        parts.iter().try_for_each(|part| all.merge(part))?;
        Ok(all.coefficients())
    }
}
