//! Host file: how the rays of a contestant fare that continue from frame to frame.

use glam::Vec4;
use serde::{Deserialize, Serialize};

/// The most that may re-initialise in a frame, of a sampler that is worth its memory.
pub const MOST_STARTED: f64 = 0.2;

/// The median age in frames that it should exceed.
pub const LEAST_AGE: f64 = 10.0;

/// Rays that continue from the frame before, and those that do not.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Lineage {
    /// The share of rays that re-initialise in a frame.
    pub started: f64,
    /// The median age over pixels, in frames.
    pub age: f64,
}

impl Lineage {
    /// Of a frame's [diagnostics](glimt_render_gpu::prepare::render::FrameImage::diagnostics); `None` where nothing is seen.
    #[must_use]
    pub fn of(diagnostics: &[Vec4]) -> Option<Self> {
        let seen: Vec<&Vec4> = diagnostics.iter().filter(|d| d.x > 0.0).collect();
        let mut ages: Vec<f64> = seen.iter().map(|d| f64::from(d.z)).collect();
        ages.sort_by(f64::total_cmp);
        Some(Self {
            age: *ages.get(ages.len() / 2)?,
            started: seen.iter().map(|d| f64::from(d.w)).sum::<f64>() / seen.len() as f64,
        })
    }

    /// Of several frames: the mean share that starts, and the age in the last frame, which has had the time to grow.
    #[must_use]
    pub fn together(frames: &[Vec<Self>]) -> Option<Self> {
        let all: Vec<&Self> = frames.iter().flatten().collect();
        let last = frames.last().filter(|last| !last.is_empty())?;
        Some(Self {
            started: all.iter().map(|l| l.started).sum::<f64>() / all.len() as f64,
            age: last.iter().map(|l| l.age).sum::<f64>() / last.len() as f64,
        })
    }

    /// What there is to say of it.
    #[must_use]
    pub fn sentence(&self, name: &str) -> String {
        let started = 100.0 * self.started;
        let holds = self.started < MOST_STARTED && self.age > LEAST_AGE;
        let (of, most) = ("of the rays of", 100.0 * MOST_STARTED);
        let text = format!(
            "{of} \u{201c}{name}\u{201d} {started:.1} % re-initialise in a frame and their median age is {:.1} frames",
            self.age
        );
        match holds {
            true => text,
            false => format!(
                "{}, WHERE LESS THAN {most} % AND MORE THAN {LEAST_AGE} ARE WANTED",
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
        let pixel = |ess: f32, age: f32, started: f32| Vec4::new(ess, 0.0, age, started);
        let frame = [
            pixel(0.0, 0.0, 0.0),
            pixel(0.5, 20.0, 0.0),
            pixel(1.0, 0.0, 1.0),
            pixel(0.7, 12.0, 0.0),
            pixel(0.7, 13.0, 0.0),
        ];
        let lineage = Lineage::of(&frame).unwrap();
        assert_eq!((lineage.started, lineage.age), (0.25, 13.0));
        assert_eq!(Lineage::of(&frame[..1]), None);
        assert!(lineage.sentence("a").contains("WANTED"));
        let young = Lineage {
            started: 0.05,
            age: 3.0,
        };
        let both = Lineage::together(&[vec![young], vec![lineage]]).unwrap();
        assert!((both.started - 0.15).abs() < 1e-12 && both.age == 13.0);
        assert!(!both.sentence("a").contains("WANTED"));
        assert_eq!(Lineage::together(&[]), None);
    }
}
