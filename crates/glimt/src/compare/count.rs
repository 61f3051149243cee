//! Host file: the count of a contestant that its time is fitted by.

use crate::report;
use crate::shot::{Method, Shot};

/// The most of any count: what a shot may have.
pub const MOST: u32 = 65_536;

/// What a contestant has more of when it is given more time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Knob {
    /// Rays through each pixel.
    Rays(u32),
    /// MIS on one ray: samples of the BRDF and of the environment, in the proportion that they were given in.
    Samples {
        /// Of the BRDF.
        brdf: u32,
        /// Of the environment.
        env: u32,
    },
    /// BIS on one ray: picks N, with M / N candidates for each.
    Picks {
        /// M.
        candidates: u32,
        /// N.
        samples: u32,
    },
    /// SMC on one ray: particles N.
    Particles(u32),
    /// Precomputed transfer: it draws nothing at random.
    Fixed,
}

impl Knob {
    /// Of a shot: nothing where its method draws no samples; its rays where it has more than one; else what its method counts on
    /// a ray.
    #[must_use]
    pub fn of(shot: &Shot) -> Self {
        let render = &shot.render;
        match render.method {
            Method::Prt => Self::Fixed,
            _ if shot.image.rays_per_pixel > 1 => Self::Rays(shot.image.rays_per_pixel),
            Method::Bis => Self::Picks {
                candidates: render.bis.candidates,
                samples: render.bis.samples,
            },
            Method::Smc => Self::Particles(render.smc.particles),
            Method::Mis => Self::Samples {
                brdf: render.brdf_samples,
                env: render.env_samples,
            },
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
            Self::Rays(n) | Self::Particles(n) => n,
            Self::Samples { brdf, env } => brdf.max(env),
            Self::Picks { samples, .. } => samples,
            Self::Fixed => 1,
        }
        .max(1)
    }

    /// The keys that give another count.
    #[must_use]
    pub fn keys(self, count: u32) -> Vec<String> {
        let scaled = |other: u32| {
            let n = f64::from(count) * f64::from(other) / f64::from(self.count());
            // A kind of sample that there was stays.
            (n.round() as u32).clamp(other.min(1), MOST)
        };
        match self {
            Self::Rays(_) => vec![format!("image.rays_per_pixel={count}")],
            Self::Samples { brdf, env } => vec![
                format!("render.brdf_samples={}", scaled(brdf)),
                format!("render.env_samples={}", scaled(env)),
            ],
            Self::Picks { candidates, .. } => vec![
                format!("render.bis.candidates={}", scaled(candidates)),
                format!("render.bis.samples={count}"),
            ],
            Self::Particles(_) => vec![format!("render.smc.particles={count}")],
            Self::Fixed => Vec::new(),
        }
    }

    /// Samples of a pixel, in words.
    #[must_use]
    pub fn describe(self, shot: &Shot) -> String {
        let now = Self::of(shot);
        match now {
            Self::Rays(n) => match shot.render.method {
                Method::Mis => format!(
                    "{n} rays × ({} + {})",
                    shot.render.brdf_samples, shot.render.env_samples
                ),
                _ => report::count(n as usize, "ray"),
            },
            Self::Samples { brdf, env } => format!("{brdf} + {env} on 1 ray"),
            Self::Picks {
                candidates,
                samples,
            } => format!("M = {candidates}, N = {samples} on 1 ray"),
            Self::Particles(n) => format!("N = {n} on 1 ray"),
            Self::Fixed => format!("{} bands", shot.render.prt.bands),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_keep_their_proportions() {
        let mut shot = Shot::default();
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
