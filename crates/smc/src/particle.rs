//! Shared file: a weighted particle.

use glam::Vec3;

/// The logarithm of a weight of 0, finite as WGSL has no infinity: e to this power is 0. Whatever is at or below half of it
/// counts as 0.
pub const LOG_ZERO: f32 = -1e30;

/// A state with its weight. 16 bytes, the same in Rust and WGSL.
///
/// The state is three numbers: a direction, or any three parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Particle {
    /// The state ω.
    pub state: Vec3,
    /// ln W; [`LOG_ZERO`] for W = 0.
    pub log_weight: f32,
}

impl Particle {
    /// The weight W.
    #[inline]
    #[must_use]
    pub fn weight(&self) -> f32 {
        libm::expf(self.log_weight)
    }
}

/// Whether the logarithm of a weight stands for 0.
#[inline]
#[must_use]
pub fn is_log_zero(log_weight: f32) -> bool {
    !(log_weight > 0.5 * LOG_ZERO)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn layout_is_that_of_wgsl() {
        assert_eq!(core::mem::size_of::<Particle>(), 16);
        assert_eq!(core::mem::offset_of!(Particle, log_weight), 12);
    }

    #[test]
    fn the_logarithm_of_zero_is_zero_again() {
        let nothing = Particle {
            state: Vec3::ZERO,
            log_weight: LOG_ZERO,
        };
        assert_eq!(nothing.weight(), 0.0);
        assert!(is_log_zero(LOG_ZERO + 1e6) && is_log_zero(f32::NAN) && !is_log_zero(-1e4));
    }
}
