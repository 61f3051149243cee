//! Host file: checked views of tables.

use core::fmt;

use glam::UVec2;

use crate::build::required_len;
use crate::compensated::CompensatedCdf;
use crate::edges::UNITS;
use crate::env_cdf::EnvCdf;

/// Why slices are not the tables of a map.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TableError {
    /// Width or height is 0 or above [`MAX_SIZE`](crate::MAX_SIZE).
    Size(UVec2),
    /// A table does not have the length of [`required_len`](crate::required_len).
    Len,
    /// The edges of the rows do not begin with 0 and end with 2³¹, or with 0 in a black map.
    Ends,
}

impl fmt::Display for TableError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Size(size) => write!(f, "no tables for a map of {} x {} texels", size.x, size.y),
            Self::Len => f.write_str("a table's length does not fit the map's size"),
            Self::Ends => f.write_str("the rows' edges do not span 0 to 2^31"),
        }
    }
}

impl core::error::Error for TableError {}

impl<'a> EnvCdf<'a> {
    /// A view of the tables of a map, with their lengths and the rows' first and last edge checked. Each slice is exactly one
    /// table: take what is longer apart before.
    ///
    /// # Errors
    /// [`TableError`], which names what does not fit.
    ///
    /// ```
    /// use glam::UVec2;
    /// use glimt_envmap_cdf::{EnvCdf, TableError, UNITS};
    /// let env = EnvCdf::new(UVec2::ONE, &[0, UNITS], &[0, UNITS]).unwrap();
    /// assert!(!env.is_black());
    /// assert_eq!(EnvCdf::new(UVec2::ONE, &[0, 7], &[0, 0]).unwrap_err(), TableError::Ends);
    /// ```
    pub fn new(
        size: UVec2,
        marginal: &'a [u32],
        conditional: &'a [u32],
    ) -> Result<Self, TableError> {
        let len = required_len(size.x, size.y).map_err(|_| TableError::Size(size))?;
        if marginal.len() != len.marginal || conditional.len() != len.conditional {
            return Err(TableError::Len);
        }
        let last = marginal[len.marginal - 1];
        if marginal[0] != 0 || (last != UNITS && last != 0) {
            return Err(TableError::Ends);
        }
        Ok(Self {
            size,
            marginal,
            conditional,
        })
    }
}

impl<'a> CompensatedCdf<'a> {
    /// A view of the tables that [`build_compensated_into`](crate::build_compensated_into) fills.
    ///
    /// # Errors
    /// [`TableError`], which names what does not fit.
    pub fn new(
        size: UVec2,
        marginal: &'a [u32],
        conditional: &'a [u32],
    ) -> Result<Self, TableError> {
        EnvCdf::new(size, marginal, conditional).map(|env| Self { env })
    }
}
