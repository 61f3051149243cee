//! Host file: the count of a contestant that its time is fitted by.

use crate::report;
use crate::shot::Shot;
use glimt_render_gpu::methods::Method as Estimator;

/// The most of any count: what a shot may have.
pub const MOST: u32 = 65_536;

/// What a contestant has more of when it is given more time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Knob {
    /// Rays through each pixel.
    Rays(u32),
    /// What its estimator counts on the one ray that there is.
    OnARay(Estimator),
    /// Precomputed transfer: it draws nothing at random.
    Fixed,
}

impl Knob {
    /// Of a shot: nothing where its method draws no samples; its rays where it has more than one; else what its method counts on
    /// a ray.
    #[must_use]
    pub fn of(shot: &Shot) -> Self {
        match (shot.render.estimator(), shot.image.rays_per_pixel) {
            (None, _) => Self::Fixed,
            (Some(estimator), 1) => Self::OnARay(estimator),
            (Some(_), rays) => Self::Rays(rays),
        }
    }

    /// Whether there is a count to change.
    #[must_use]
    pub fn is_fixed(self) -> bool {
        self == Self::Fixed
    }

    /// The count as the shot has it, at least 1.
    #[must_use]
    pub fn count(self) -> u32 {
        match self {
            Self::Rays(n) => n,
            Self::OnARay(estimator) => estimator.count(),
            Self::Fixed => 1,
        }
        .max(1)
    }

    /// The keys that give another count.
    #[must_use]
    pub fn keys(self, count: u32) -> Vec<String> {
        match self {
            Self::Rays(_) => vec![format!("image.rays_per_pixel={count}")],
            Self::OnARay(estimator) => {
                let keys = estimator.with_count(count).into_iter();
                keys.map(|(key, n)| format!("render.{key}={n}")).collect()
            }
            Self::Fixed => Vec::new(),
        }
    }

    /// Samples of a pixel, in words.
    #[must_use]
    pub fn describe(self, shot: &Shot) -> String {
        let now = Self::of(shot);
        match now {
            Self::Rays(n) => match shot.render.estimator() {
                Some(mis @ Estimator::Mis(_)) => format!("{n} rays × ({})", mis.describe()),
                _ => report::count(n as usize, "ray"),
            },
            Self::OnARay(estimator) => format!("{} on 1 ray", estimator.describe()),
            Self::Fixed => format!("{} bands", shot.render.prt.bands),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shot::Method;

    #[test]
    fn counts_keep_their_proportions() {
        let mut shot = Shot::default();
        shot.render.method = Method::Mis;
        assert_eq!(Knob::of(&shot), Knob::Rays(16));
        assert_eq!(Knob::of(&shot).keys(5), ["image.rays_per_pixel=5"]);
        shot.image.rays_per_pixel = 1;
        (shot.render.brdf_samples, shot.render.env_samples) = (15, 15);
        let keys = ["render.brdf_samples=7", "render.env_samples=7"];
        assert_eq!(Knob::of(&shot).keys(7), keys);
        (shot.render.brdf_samples, shot.render.env_samples) = (0, 8);
        let keys = ["render.brdf_samples=0", "render.env_samples=3"];
        assert_eq!(Knob::of(&shot).keys(3), keys);
        (shot.render.brdf_samples, shot.render.env_samples) = (1, 8);
        let keys = ["render.brdf_samples=1", "render.env_samples=2"];
        assert_eq!(Knob::of(&shot).keys(2), keys);
        shot.render.method = Method::Bis;
        (shot.render.bis.candidates, shot.render.bis.samples) = (400, 20);
        let keys = ["render.bis.candidates=200", "render.bis.samples=10"];
        assert_eq!(Knob::of(&shot).keys(10), keys);
        shot.render.method = Method::Prt;
        assert_eq!(Knob::of(&shot), Knob::Fixed);
        shot.image.rays_per_pixel = 4;
        assert_eq!(Knob::of(&shot), Knob::Fixed);
        assert!(Knob::of(&shot).keys(7).is_empty());
        shot.image.rays_per_pixel = 1;
        shot.render.method = Method::Smc;
        assert_eq!(Knob::of(&shot).keys(12), ["render.smc.particles=12"]);
    }
}
