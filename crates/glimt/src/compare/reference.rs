//! Host file: what images are compared with: a long MIS run of independent scramblings, which knows its own noise, or images that
//! are given.

use super::moments::{Kept, Moments};
use super::trial_renderer::{TrialRenderer, luminance_of};
use super::trials::TrialPlan;
use crate::error::{Error, Result};
use crate::output::exr;
use crate::output::target::Guard;
use crate::shot::{Shot, digest};
use glam::{UVec2, Vec4};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// Rays through a pixel in one scrambling.
pub const RAYS: u32 = 64;

/// Scramblings of the shortest reference: a standard error needs as many.
pub const LEAST: u32 = 16;

/// Largest share of the smallest error that the reference's noise may have.
pub const CRITERION: f64 = 0.1;

/// Relative noise below which 32-bit images cannot get.
const FLOOR: f64 = 3e-6;

/// How long an unsaved scrambling may be.
const SAVE_EVERY: Duration = Duration::from_secs(5);

/// The reference of a frame.
#[derive(Clone, Debug)]
pub struct Reference {
    /// Number of the frame.
    pub frame: i32,
    /// Its scramblings.
    pub moments: Moments,
    /// Pixels in which it covers anything.
    pub pixels: Vec<u32>,
    /// Mean luminance of those, above 0.
    pub mean_luminance: f64,
    /// Root mean square of their standard errors, relative to that; `None` where it is not known.
    pub noise: Option<f64>,
    /// Standard error of their mean luminance, relative to that.
    pub mean_error: f64,
}

impl Reference {
    /// Of scramblings.
    ///
    /// # Errors
    /// It shows nothing, or all that it shows is black.
    pub fn of(frame: i32, moments: Moments) -> Result<Self> {
        let covered = |p: &u32| moments.mean[*p as usize].w > 0.0;
        let pixels: Vec<u32> = (0..moments.mean.len() as u32).filter(covered).collect();
        let count = pixels.len() as f64;
        let sum = |f: &dyn Fn(usize) -> f64| pixels.iter().map(|&p| f(p as usize)).sum::<f64>();
        let mean_luminance = sum(&|p| luminance_of(moments.mean[p])) / count;
        if !(mean_luminance > 0.0) {
            let what = match pixels.is_empty() {
                true => format!("no object is seen in frame {frame}: there is nothing to compare"),
                false => {
                    format!("all objects are black in frame {frame}: there is nothing to compare")
                }
            };
            return Err(Error::usage(what)
                .fix("check the camera and the light, or measure other frames with --measure"));
        }
        let colour = |p: usize| f64::from(moments.mean_variance(p).truncate().element_sum());
        let bright = |p: usize| f64::from(moments.mean_variance(p).w);
        let noise = (sum(&colour) / (3.0 * count)).sqrt() / mean_luminance;
        let mean_error = sum(&bright).sqrt() / count / mean_luminance;
        Ok(Self {
            frame,
            noise: (moments.n > 1).then_some(noise),
            mean_error,
            pixels,
            mean_luminance,
            moments,
        })
    }

    /// Of an image whose noise is not known.
    ///
    /// # Errors
    /// As [`Reference::of`].
    pub fn given(frame: i32, size: UVec2, image: Vec<Vec4>) -> Result<Self> {
        Self::of(frame, Moments::exact(size, image))
    }
}

/// The keys by which a shot makes a reference: MIS, Owen-scrambled Sobol points, all else as it is.
#[must_use]
pub fn keys() -> Vec<String> {
    let keys = [
        "render.method=mis".to_owned(),
        "render.pattern=owen-sobol".to_owned(),
        "render.brdf_samples=1".to_owned(),
        "render.env_samples=1".to_owned(),
        // Contestants that compensate are judged by light that was not.
        "render.compensation=false".to_owned(),
        format!("image.rays_per_pixel={RAYS}"),
    ];
    keys.to_vec()
}

/// The seed of a scrambling. Those of contestants count up from the shot's, half of all seeds away.
fn seed(shot: &Shot, scrambling: u32) -> u32 {
    shot.render
        .seed
        .wrapping_add(1 << 31)
        .wrapping_add(scrambling)
}

/// References that grow.
pub struct Growing {
    shot: Shot,
    folder: PathBuf,
    guard: Guard,
    frames: Vec<Frame>,
    /// Seconds of rendering so far, in this run.
    pub seconds: f64,
    /// Seconds of one scrambling, at the last look.
    pub pace: f64,
}

struct Frame {
    number: i32,
    identity: String,
    moments: Moments,
    saved: u32,
}

impl Growing {
    /// Those that are in the plan's folder already, of these frames of a shot with [`keys`], and their identities.
    #[must_use]
    pub fn open(shot: &Shot, plan: &TrialPlan, frames: &[(i32, String)], size: UVec2) -> Self {
        let open = |(number, identity): &(i32, String)| {
            let text = format!(
                "reference 1 {identity} {}",
                digest::hex(&digest::of_shot(shot))
            );
            let identity = digest::hex(&digest::of_text(&text));
            let kept = Kept::<()>::read(&file(&plan.folder, *number), &identity, size);
            let moments = kept.map_or_else(|| Moments::new(size), |k| k.moments);
            Frame {
                number: *number,
                identity,
                saved: moments.n,
                moments,
            }
        };
        Self {
            frames: frames.iter().map(open).collect(),
            folder: plan.folder.clone(),
            guard: plan.guard.clone(),
            shot: shot.clone(),
            seconds: 0.0,
            pace: 0.0,
        }
    }

    /// Renders until every frame's relative noise is below its target, or `limit` seconds of rendering are over; each frame has
    /// at least two scramblings then. `progress` is called with the seconds of each image, and how many are probably left.
    ///
    /// # Errors
    /// A frame cannot be rendered or written.
    pub fn grow(
        &mut self,
        renderer: &mut TrialRenderer<'_>,
        targets: &[f64],
        limit: Option<f64>,
        progress: &mut dyn FnMut(f64, f64),
    ) -> Result<Vec<Reference>> {
        let mut saved = Instant::now();
        let mut open: Vec<usize> = (0..self.frames.len()).collect();
        loop {
            let mut left = 0.0;
            let mut still = Vec::new();
            for &i in &open {
                let frame = &self.frames[i];
                let more = match frame.moments.n < LEAST {
                    true => f64::from(LEAST - frame.moments.n),
                    false => {
                        let reference = Reference::of(frame.number, frame.moments.clone())?;
                        let noise = reference.noise.unwrap_or(f64::INFINITY);
                        let target = targets[i].max(FLOOR);
                        if noise <= target {
                            continue;
                        }
                        // Scramblings are independent: the noise falls with the root of their number.
                        f64::from(frame.moments.n) * ((noise / target).powi(2) - 1.0)
                    }
                };
                left += more.max(1.0);
                still.push((i, more));
            }
            if still.is_empty() {
                break;
            }
            for (i, more) in &still {
                // Few at a time, so that all frames are alike when the time is over.
                let batch = (*more * 0.5).ceil().clamp(1.0, 16.0) as u32;
                for _ in 0..batch {
                    let over = limit.is_some_and(|limit| self.seconds >= limit);
                    if over && self.frames[*i].moments.n >= 2 {
                        break;
                    }
                    let frame = &mut self.frames[*i];
                    let seed = seed(&self.shot, frame.moments.n);
                    let image = renderer.render(&self.shot, frame.number, seed)?;
                    frame.moments.push(&image.pixels);
                    self.seconds += image.seconds;
                    self.pace = image.seconds;
                    left = (left - 1.0).max(0.0);
                    let by_limit = limit.map_or(f64::INFINITY, |limit| limit - self.seconds);
                    progress(image.seconds, (left * image.seconds).min(by_limit.max(0.0)));
                    if saved.elapsed() > SAVE_EVERY {
                        self.save()?;
                        saved = Instant::now();
                    }
                }
            }
            let enough = self.frames.iter().all(|f| f.moments.n >= 2);
            if enough && limit.is_some_and(|limit| self.seconds >= limit) {
                break;
            }
            open = still.into_iter().map(|(i, _)| i).collect();
        }
        self.save()?;
        self.frames
            .iter()
            .map(|f| Reference::of(f.number, f.moments.clone()))
            .collect()
    }

    fn save(&mut self) -> Result<()> {
        for frame in self.frames.iter_mut().filter(|f| f.moments.n > f.saved) {
            let kept = Kept {
                moments: frame.moments.clone(),
                sample: None,
                about: (),
            };
            let target = self.guard.target(&file(&self.folder, frame.number))?;
            kept.write(&target, &frame.identity)?;
            frame.saved = frame.moments.n;
        }
        Ok(())
    }
}

fn file(folder: &Path, frame: i32) -> PathBuf {
    folder.join(format!("reference.{frame:04}.moments"))
}

/// Reads the images `frame.####.exr` of a folder.
///
/// # Errors
/// One cannot be read, or does not fit.
pub fn read(folder: &Path, frames: &[i32], size: UVec2) -> Result<Vec<Reference>> {
    let read = |&frame: &i32| {
        let file = folder.join(format!("frame.{frame:04}.exr"));
        if !file.is_file() {
            return Err(Error::input(&file, "there is no such file").at("--reference").fix(
                "the reference needs frame.####.exr of every measured frame and of the one before each",
            ));
        }
        let pixels = exr::read_pixels(&file)?;
        if pixels.len() as u64 != u64::from(size.x) * u64::from(size.y) {
            return Err(Error::input(
                &file,
                format!("it does not have {} × {} pixels", size.x, size.y),
            )
            .fix("render it in the image.size of the shot"));
        }
        if pixels.iter().any(|p| !p.is_finite()) {
            return Err(Error::input(&file, "a pixel is not a number").fix("render it again"));
        }
        Reference::given(frame, size, pixels)
    };
    frames.iter().map(read).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn noise_is_that_of_the_mean() {
        // Scramblings that are 1 ± 0.1 in each of 4 pixels: 0.1 · √(n/(n−1)) / √n is the standard error.
        let size = UVec2::new(2, 2);
        let mut moments = Moments::new(size);
        for i in 0..16 {
            let v = if i % 2 == 0 { 1.1 } else { 0.9 };
            moments.push(&[Vec4::new(v, v, v, 1.0); 4]);
        }
        let reference = Reference::of(1, moments).unwrap();
        let expected = 0.1 / 15.0f64.sqrt();
        assert!((reference.noise.unwrap() / expected - 1.0).abs() < 1e-5);
        // Pixels are independent streams; their mean is surer by the root of their number.
        assert!((reference.mean_error / (expected / 2.0) - 1.0).abs() < 1e-5);
        assert!((reference.mean_luminance - 1.0).abs() < 1e-6);
    }

    #[test]
    fn nothing_to_compare_is_said() {
        let size = UVec2::new(2, 1);
        let error = Reference::given(4, size, vec![Vec4::ZERO; 2]).unwrap_err();
        assert!(error.to_string().contains("no object is seen in frame 4"));
        let error = Reference::given(4, size, vec![Vec4::W; 2]).unwrap_err();
        assert!(error.to_string().contains("black in frame 4"));
    }
}
