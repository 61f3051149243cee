//! Shared file: the targets between two frames: `γ_0 = γ_{t−1}, γ_1, …, γ_{K+1} = γ_t` (Kronander 2014, § 6).

use crate::target::Endpoints;

/// How the targets between two frames are mixed of both. In a buffer it is its number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum Path {
    /// `γ_k = (1 − β_k) γ_{t−1} + β_k γ_t`.
    Linear = 0,
    /// `γ_k = γ_{t−1}^(1 − β_k) γ_t^β_k`: zero wherever one of the two is.
    Geometric = 1,
}

/// K targets between two frames, at `β_k = k/(K + 1)`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bridge {
    /// How they are mixed.
    pub path: Path,
    /// K ≥ 0.
    pub intermediate: u32,
}

impl Bridge {
    /// K linear mixtures: the paper's choice.
    #[inline]
    #[must_use]
    pub fn linear(intermediate: u32) -> Bridge {
        Bridge {
            path: Path::Linear,
            intermediate,
        }
    }

    /// K geometric mixtures.
    #[inline]
    #[must_use]
    pub fn geometric(intermediate: u32) -> Bridge {
        Bridge {
            path: Path::Geometric,
            intermediate,
        }
    }

    /// Steps from one frame to the next: K + 1.
    #[inline]
    #[must_use]
    pub fn steps(&self) -> u32 {
        self.intermediate + 1
    }

    /// γ_k, k from 0 to K + 1, of which the first and the last are the endpoints to the last bit.
    ///
    /// ```
    /// use glimt_smc::{Bridge, Endpoints};
    /// let ends = Endpoints { previous: 1.0, current: 4.0 };
    /// let linear = Bridge::linear(1);
    /// assert_eq!(linear.density(1, ends), 2.5);
    /// let geometric = Bridge::geometric(1);
    /// assert!((geometric.density(1, ends) - 2.0).abs() < 1e-6);
    /// assert_eq!((geometric.density(0, ends), geometric.density(2, ends)), (1.0, 4.0));
    /// ```
    #[inline]
    #[must_use]
    pub fn density(&self, k: u32, ends: Endpoints) -> f32 {
        if k == 0 {
            return ends.previous;
        }
        if k >= self.steps() {
            return ends.current;
        }
        let beta = k as f32 / self.steps() as f32;
        if self.path == Path::Linear {
            return (1.0 - beta) * ends.previous + beta * ends.current;
        }
        if !(ends.previous > 0.0) || !(ends.current > 0.0) {
            return 0.0;
        }
        libm::powf(ends.previous, 1.0 - beta) * libm::powf(ends.current, beta)
    }
}
