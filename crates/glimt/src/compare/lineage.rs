//! Host file: how the rays of a contestant fare that continue from frame to frame.

use glimt_render_gpu::kernels::smc::SmcHealth;
use glimt_render_gpu::prepare::render::Diagnostics;
use serde::{Deserialize, Serialize};

/// The most that may re-initialise in a frame, of a sampler that is worth its memory.
pub const MOST_STARTED: f64 = 0.2;

/// What sd(Z)/Z should stay below: beyond it few rays carry all of the light.
pub const MOST_SPREAD: f64 = 1.0;

/// Rays that continue from the frame before, and those that do not.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Lineage {
    /// The share of rays that re-initialise in a frame.
    pub started: f64,
    /// The median age over pixels, in frames.
    pub age: f64,
    /// sd(Z)/Z, the relative spread of the normalisers of a pixel's rays: the median over pixels. `None` with one ray a pixel.
    #[serde(default)]
    pub spread: Option<f64>,
}

impl Lineage {
    /// Of a frame's diagnostics, with so many rays a pixel; `None` of a method without particles, and where nothing is seen.
    #[must_use]
    pub fn of(diagnostics: &Diagnostics, rays_per_pixel: u32) -> Option<Self> {
        match diagnostics {
            Diagnostics::Particles(pixels) => Self::of_particles(pixels, rays_per_pixel),
            Diagnostics::Groups { .. } => None,
        }
    }

    fn of_particles(diagnostics: &[SmcHealth], rays_per_pixel: u32) -> Option<Self> {
        // A dead set has no effective samples, but a pixel that shows something has ages or starts.
        let shows = |d: &&SmcHealth| d.ess > 0.0 || d.age > 0.0 || d.started > 0.0;
        let seen: Vec<&SmcHealth> = diagnostics.iter().filter(shows).collect();
        let median = |value: fn(&SmcHealth) -> f32| {
            let mut values: Vec<f64> = seen.iter().map(|d| f64::from(value(d))).collect();
            values.sort_by(f64::total_cmp);
            values.get(values.len() / 2).copied()
        };
        Some(Self {
            age: median(|d| d.age)?,
            started: seen.iter().map(|d| f64::from(d.started)).sum::<f64>() / seen.len() as f64,
            spread: median(|d| d.spread).filter(|_| rays_per_pixel > 1),
        })
    }

    /// Of several frames: the mean share that starts, and the age and spread in the last frame, which have had the time to grow.
    #[must_use]
    pub fn together(frames: &[Vec<Self>]) -> Option<Self> {
        let all: Vec<&Self> = frames.iter().flatten().collect();
        let last = frames.last().filter(|last| !last.is_empty())?;
        Some(Self {
            started: all.iter().map(|l| l.started).sum::<f64>() / all.len() as f64,
            age: last.iter().map(|l| l.age).sum::<f64>() / last.len() as f64,
            spread: (last.iter().map(|l| l.spread).sum::<Option<f64>>())
                .map(|sum| sum / last.len() as f64),
        })
    }

    /// What there is to say of it.
    #[must_use]
    pub fn sentence(&self, name: &str) -> String {
        let started = 100.0 * self.started;
        let holds = self.started < MOST_STARTED && self.spread.is_none_or(|s| s < MOST_SPREAD);
        let (of, most) = ("of the rays of", 100.0 * MOST_STARTED);
        let spread = self.spread.map(|spread| format!(" (sd(Z)/Z {spread:.2})"));
        let text = format!(
            "{of} \u{201c}{name}\u{201d} {started:.1} % re-initialise in a frame and their median age is {:.1} frames{}",
            self.age,
            spread.unwrap_or_default()
        );
        match holds {
            true => text,
            false => format!(
                "{}, WHERE LESS THAN {most} % AND sd(Z)/Z BELOW {MOST_SPREAD} ARE WANTED",
                text
            ),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pixels_that_show_nothing_do_not_count() {
        let pixel = |ess: f32, age: f32, started: f32, spread: f32| SmcHealth {
            ess,
            log_ratio: 0.0,
            age,
            started,
            spread,
        };
        let frame = [
            pixel(0.0, 0.0, 0.0, 0.0),
            pixel(0.5, 20.0, 0.0, 0.25),
            pixel(1.0, 0.0, 1.0, 0.125),
            pixel(0.7, 12.0, 0.0, 0.5),
            // All of its sets are dead.
            pixel(0.0, 13.0, 0.0, 0.0),
        ];
        let lineage = Lineage::of_particles(&frame, 4).unwrap();
        assert_eq!((lineage.started, lineage.age), (0.25, 13.0));
        assert_eq!(lineage.spread, Some(0.25));
        assert!(lineage.sentence("a").contains("sd(Z)/Z 0.25"));
        assert_eq!(Lineage::of_particles(&frame, 1).unwrap().spread, None);
        assert_eq!(Lineage::of_particles(&frame[..1], 4), None);
        assert!(lineage.sentence("a").contains("WANTED"));
        let young = Lineage {
            started: 0.05,
            age: 3.0,
            spread: None,
        };
        assert!(!young.sentence("a").contains("WANTED"));
        let wide = Lineage {
            spread: Some(1.5),
            ..young
        };
        assert!(wide.sentence("a").contains("WANTED"));
        let both = Lineage::together(&[vec![young], vec![lineage]]).unwrap();
        assert!((both.started - 0.15).abs() < 1e-12 && both.age == 13.0);
        assert_eq!(both.spread, Some(0.25));
        assert!(!both.sentence("a").contains("WANTED"));
        assert_eq!(Lineage::together(&[]), None);
    }
}
