//! Host file: the outline of a ball.

use glam::DVec2;

/// The outline of a ball.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Circle {
    /// Centre in pixels.
    pub centre: DVec2,
    /// Radius in pixels.
    pub radius: f64,
}

impl Circle {
    /// The same circle in an image whose pixels are `1 / factor` times as large.
    #[must_use]
    pub fn scaled(self, factor: f64) -> Self {
        Self {
            centre: self.centre * factor,
            radius: self.radius * factor,
        }
    }
}

impl std::fmt::Display for Circle {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { centre, radius } = self;
        write!(f, "({:.1}, {:.1}) r {radius:.1} px", centre.x, centre.y)
    }
}
