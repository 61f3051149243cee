//! Host file: what a caller can get wrong.

use core::fmt;

use glam::UVec2;

use crate::MAX_BANDS;

/// Why something is not done.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ShError {
    /// The number of bands is not in 1..=[`MAX_BANDS`].
    Bands(u32),
    /// A map without texels, or one wider or higher than 2²⁰.
    Size(UVec2),
    /// A texel of another number of channels than 3 or 4.
    Channels(u32),
    /// A slice has the wrong length.
    Length {
        /// The length that it must have.
        expected: usize,
        /// The length that it has.
        found: usize,
    },
    /// The map has no such row.
    Row {
        /// The row.
        row: u32,
        /// The map's height.
        height: u32,
    },
    /// Sums of fewer bands than the projection has.
    FewBands {
        /// The bands of the projection.
        expected: u32,
        /// The bands that there are sums of.
        found: u32,
    },
    /// The other projection is of a map of another size, or onto another number of bands.
    Another,
}

impl fmt::Display for ShError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Bands(bands) => write!(f, "{bands} bands: there are 1 to {MAX_BANDS}"),
            Self::Size(size) => write!(
                f,
                "a map of {} x {} texels: both must lie in 1..={MAX_SIDE}",
                size.x, size.y
            ),
            Self::Channels(channels) => write!(f, "texels of {channels} channels: 3 or 4"),
            Self::Length { expected, found } => write!(f, "length {found}, expected {expected}"),
            Self::Row { row, height } => write!(f, "row {row} of a map of {height} rows"),
            Self::FewBands { expected, found } => {
                write!(
                    f,
                    "sums of {found} bands, where {expected} are projected onto"
                )
            }
            Self::Another => f.write_str("a projection of another size, or onto other bands"),
        }
    }
}

impl core::error::Error for ShError {}

/// The longest side of a map.
pub(crate) const MAX_SIDE: u32 = 1 << 20;

/// Whether there are so many bands.
pub(crate) fn check_bands(bands: u32) -> Result<(), ShError> {
    if (1..=MAX_BANDS).contains(&bands) {
        Ok(())
    } else {
        Err(ShError::Bands(bands))
    }
}

/// Whether a map can have the size.
pub(crate) fn check_size(size: UVec2) -> Result<(), ShError> {
    let side = 1..=MAX_SIDE;
    if side.contains(&size.x) && side.contains(&size.y) {
        Ok(())
    } else {
        Err(ShError::Size(size))
    }
}

/// Whether a slice has the length.
pub(crate) fn check_len(found: usize, expected: usize) -> Result<(), ShError> {
    if found == expected {
        Ok(())
    } else {
        Err(ShError::Length { expected, found })
    }
}
