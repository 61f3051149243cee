//! Host file: how many shadow rays an image took, by methods that choose their number themselves.

use glimt_render_gpu::prepare::render::Diagnostics;
use serde::{Deserialize, Serialize};

/// Shadow rays of a pixel, on average over the image.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct ShadowRays {
    /// All of them.
    pub all: f64,
    /// Those among them that were pilots: they counted visibilities before the image was shaded.
    pub pilots: f64,
}

impl ShadowRays {
    /// Of a frame's diagnostics; `None` of a method whose rays are as many as its settings say.
    #[must_use]
    pub fn of(diagnostics: &Diagnostics) -> Option<Self> {
        let Diagnostics::Groups { pixels, pilot_rays } = diagnostics else {
            return None;
        };
        let rays: f64 = pixels.iter().map(|pixel| f64::from(pixel.rays)).sum();
        Some(Self {
            all: rays / pixels.len().max(1) as f64 + pilot_rays,
            pilots: *pilot_rays,
        })
    }

    /// The mean; `None` of nothing.
    #[must_use]
    pub fn mean(all: &[Self]) -> Option<Self> {
        let mean = |value: fn(&Self) -> f64| all.iter().map(value).sum::<f64>() / all.len() as f64;
        (!all.is_empty()).then(|| Self {
            all: mean(|rays| rays.all),
            pilots: mean(|rays| rays.pilots),
        })
    }

    /// The share of pilots.
    #[must_use]
    pub fn pilot_share(&self) -> f64 {
        match self.all > 0.0 {
            true => self.pilots / self.all,
            false => 0.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glimt_render_gpu::kernels::group_health::GroupHealth;

    #[test]
    fn pilots_are_rays() {
        let pixel = |rays| GroupHealth {
            rays,
            residual: 0.0,
        };
        let diagnostics = Diagnostics::Groups {
            pixels: vec![pixel(0.0), pixel(12.0)],
            pilot_rays: 2.0,
        };
        let rays = ShadowRays::of(&diagnostics).unwrap();
        assert_eq!((rays.all, rays.pilot_share()), (8.0, 0.25));
        let none = ShadowRays {
            all: 0.0,
            pilots: 0.0,
        };
        assert_eq!(none.pilot_share(), 0.0);
        assert_eq!(ShadowRays::mean(&[rays, none]).unwrap().all, 4.0);
        assert_eq!(ShadowRays::mean(&[]), None);
        assert_eq!(ShadowRays::of(&Diagnostics::Particles(Vec::new())), None);
    }
}
