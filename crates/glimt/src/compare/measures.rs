//! Host file: what an image is measured by, and the definitions that a report prints.
//!
//! All are taken over the pixels P in which the reference r covers something, with Ȳ the mean luminance of r over P. Ratios to Ȳ, not
//! to each pixel's own value, so that no dark pixel rules.

use super::moments::Moments;
use super::reference::Reference;
use super::shadow_rays::ShadowRays;
use super::statistics::{Estimate, normal_two_sided, sidak, student_two_sided};
use super::trial_renderer::luminance_of;
use glam::{Vec3, Vec4};
use serde::{Deserialize, Serialize};

/// The measures, in the words of a report: name and definition.
pub const DEFINITIONS: [(&str, &str); 11] = [
    (
        "image",
        "Linear radiance of the shot's objects and catchers before nothing: no background, no backplate, no exposure. P is the set of \
         pixels in which the reference covers anything, Ȳ the mean luminance (0.2126 R + 0.7152 G + 0.0722 B) of the reference r over P.",
    ),
    (
        "relative RMSE",
        "E = √( mean over P and the three channels of (x − r)² ) / Ȳ for the image x of one seed. Told is the root of the mean of E² \
         over the seeds, ± the standard error of that mean over the seeds (delta method). Over frames, E² is averaged.",
    ),
    (
        "bias",
        "B = mean over P of Y(x̄ − r) / Ȳ, x̄ the mean over the seeds. Its standard error is that over the seeds' own means, and the \
         reference's, added in squares. p: two-sided, Student's t with Welch and Satterthwaite's degrees of freedom.",
    ),
    (
        "local bias",
        "For each tile of 8 × 8 pixels, z = Σ Y(x̄ − r) / √( Σ var Y(x̄) + Σ var Y(r) ), sums over the tile's pixels in P: their \
         streams are independent, and the sum of their variances is surer than any of them. Told are the share of tiles with |z| > 2.576, \
         which noise alone gives 1 % of, and the largest |z| with its p-value, corrected for the number of tiles (Šidák 1967). Strongly skewed \
         noise (rare, bright samples) also raises both.",
    ),
    (
        "flicker",
        "F_t = √( mean over P and the channels of ((x_t − x_{t−1}) − (r_t − r_{t−1}))² ) / Ȳ_t, both frames of one seed: what changes \
         from frame to frame and should not. Independent noise of relative RMSE E has F ≈ √2 E.",
    ),
    (
        "FLIP",
        "Mean over the image of LDR-ꟻLIP (Andersson et al. 2020) between the display images of x and r, at 67 pixels a degree, averaged over \
         the seeds, ± its standard error.",
    ),
    (
        "time",
        "Wall time of one frame in the renderer, from scene and light to pixels; no files. Median over rounds in each of which every \
         contestant renders one frame, with the quartiles.",
    ),
    (
        "rays, pilots",
        "Shadow rays of a pixel, over all pixels of the image, of methods that choose their number themselves; the share of those that \
         were pilots, which count visibilities before the frame is shaded.",
    ),
    (
        "efficiency",
        "1 / (E² T), T the median time, as a ratio to that of the contestant named as the baseline. Its error is of first order, from the \
         errors of both E and both T (a median's from its quartiles).",
    ),
    (
        "reference's noise",
        "√( mean over P and the channels of var r ) / Ȳ; var r is the variance over independent scramblings over their number. It is \
         contained in E; where it is below a tenth of E, that is less than 0.5 %.",
    ),
    (
        "standard error",
        "Over independent scramblings (seeds), never over the points of one. It needs at least 16 of them.",
    ),
];

/// Side of a tile in pixels.
const TILE: u32 = 8;

/// 32-bit images cannot be distinguished below this share of their brightness.
const ROUNDING: f64 = 1e-6;

/// Mean square of the difference over P and the channels, over Ȳ²: E² of one image.
#[must_use]
pub fn square_error(image: &[Vec4], reference: &Reference) -> f64 {
    let r = &reference.moments.mean;
    let sum: f64 = reference
        .pixels
        .iter()
        .map(|&p| square((image[p as usize] - r[p as usize]).truncate()))
        .sum();
    sum / (3.0 * reference.pixels.len() as f64) / reference.mean_luminance.powi(2)
}

/// F² of an image and the one before it.
#[must_use]
pub fn square_flicker(now: &[Vec4], before: &[Vec4], r: &Reference, r_before: &Reference) -> f64 {
    let (rn, rb) = (&r.moments.mean, &r_before.moments.mean);
    let off = |p: usize| (now[p] - before[p]) - (rn[p] - rb[p]);
    let sum: f64 = r
        .pixels
        .iter()
        .map(|&p| square(off(p as usize).truncate()))
        .sum();
    sum / (3.0 * r.pixels.len() as f64) / r.mean_luminance.powi(2)
}

/// Mean of `Y(x − r)` over P, over Ȳ: the bias as one image shows it.
#[must_use]
pub fn mean_offset(image: &[Vec4], reference: &Reference) -> f64 {
    let r = &reference.moments.mean;
    let off = |p: usize| luminance_of(image[p] - r[p]);
    let sum: f64 = reference.pixels.iter().map(|&p| off(p as usize)).sum();
    sum / reference.pixels.len() as f64 / reference.mean_luminance
}

fn square(v: Vec3) -> f64 {
    v.to_array().iter().map(|c| f64::from(*c).powi(2)).sum()
}

/// Mean squares of a pixel's difference from the reference, over the seeds and the channels: a map of the error.
#[must_use]
pub fn error_map(moments: &Moments, reference: &Reference) -> Vec<f64> {
    let r = &reference.moments.mean;
    let n = f64::from(moments.n);
    let at = |p: usize| {
        let mean = square((moments.mean[p] - r[p]).truncate());
        let spread = moments.squares[p].truncate().element_sum();
        ((mean + f64::from(spread) / n) / 3.0).sqrt() / reference.mean_luminance
    };
    (0..moments.mean.len()).map(at).collect()
}

/// A bias, and whether noise explains it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Bias {
    /// B, with its standard error.
    pub of_image: Estimate,
    /// Two-sided p-value; none of fewer than 2 seeds.
    pub p: Option<f64>,
}

impl Bias {
    /// Of the seeds' own values and the standard error of the reference's mean.
    #[must_use]
    pub fn of(offsets: &[f64], reference_error: f64) -> Self {
        let mean = Estimate::mean(offsets);
        let Some(own) = mean.error else {
            return Self {
                of_image: mean,
                p: None,
            };
        };
        let own = own.max(ROUNDING);
        let variance = own.powi(2) + reference_error.powi(2);
        // The reference's variance comes of all its pixels: it is as good as known.
        let freedom = variance.powi(2) / (own.powi(4) / (offsets.len() as f64 - 1.0));
        let error = variance.sqrt();
        Self {
            of_image: Estimate {
                value: mean.value,
                error: Some(error),
            },
            p: Some(student_two_sided(mean.value / error, freedom)),
        }
    }
}

/// How the mean image differs from the reference, tile by tile.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct LocalBias {
    /// Tiles that were tested.
    pub tiles: usize,
    /// Those with |z| > 2.576.
    pub beyond: usize,
    /// The largest |z|.
    pub largest: f64,
    /// Its p-value, corrected for the number of tiles.
    pub p: f64,
}

impl LocalBias {
    /// Tests the mean of independent images; none of fewer than 2.
    #[must_use]
    pub fn of(moments: &Moments, reference: &Reference) -> Option<Self> {
        if moments.n < 2 {
            return None;
        }
        let r = &reference.moments;
        let width = moments.size.x;
        let across = width.div_ceil(TILE);
        let tiles = across * moments.size.y.div_ceil(TILE);
        // Difference, its variance, brightness.
        let mut sums = vec![[0.0f64; 3]; tiles as usize];
        for &pixel in &reference.pixels {
            let (x, y) = (pixel % width, pixel / width);
            let p = pixel as usize;
            let sum = &mut sums[(y / TILE * across + x / TILE) as usize];
            sum[0] += luminance_of(moments.mean[p] - r.mean[p]);
            sum[1] += f64::from(moments.mean_variance(p).w + r.mean_variance(p).w);
            sum[2] += luminance_of(r.mean[p]).abs();
        }
        let z = |[off, variance, bright]: &[f64; 3]| {
            let floor = ROUNDING * bright + f64::from(f32::MIN_POSITIVE);
            off.abs() / (variance + floor * floor).sqrt()
        };
        let tested = sums.iter().filter(|s| s[2] > 0.0 || s[1] > 0.0);
        let zs: Vec<f64> = tested.map(z).collect();
        let largest = zs.iter().copied().fold(0.0, f64::max);
        Some(Self {
            tiles: zs.len(),
            beyond: zs
                .iter()
                .filter(|z| !(**z <= super::statistics::ONE_PERCENT))
                .count(),
            largest,
            p: sidak(normal_two_sided(largest), zs.len()),
        })
    }
}

/// A contestant's figures, of a frame or of all.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Score {
    /// Relative RMSE.
    pub error: Estimate,
    /// Bias.
    pub bias: Bias,
    /// Bias of the tiles.
    pub local: Option<LocalBias>,
    /// Flicker, where there is a frame before.
    pub flicker: Option<Estimate>,
    /// FLIP, where the program was built with it.
    pub flip: Option<Estimate>,
    /// Shadow rays, where the method chose their number.
    pub rays: Option<ShadowRays>,
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::UVec2;
    use glimt_sampling::uniform::UniformSource;
    use glimt_sampling::xoshiro::Xoshiro128PlusPlus;

    const SIZE: UVec2 = UVec2::new(48, 40);

    /// An image of a ramp; its left quarter shows nothing.
    fn ramp() -> Vec<Vec4> {
        let pixel = |p: u32| match p % SIZE.x < SIZE.x / 4 {
            true => Vec4::ZERO,
            false => {
                let y = 0.5 + (p / SIZE.x) as f32 / SIZE.y as f32;
                Vec4::new(y, 0.8 * y, 1.2 * y, 1.0)
            }
        };
        (0..SIZE.x * SIZE.y).map(pixel).collect()
    }

    fn exact(image: Vec<Vec4>) -> Reference {
        Reference::given(3, SIZE, image).unwrap()
    }

    /// Noise of mean 1, variance 1: of the form that rare bright samples give.
    fn noise(random: &mut Xoshiro128PlusPlus) -> f32 {
        let u = (random.next_u32() as f32 + 0.5) / 4_294_967_296.0;
        -u.ln()
    }

    /// Images of the ramp with noise of mean `factor`.
    fn noisy(factor: f32, seeds: u32) -> (Moments, Vec<f64>, Vec<f64>) {
        let reference = exact(ramp());
        let mut moments = Moments::new(SIZE);
        let (mut offsets, mut errors) = (Vec::new(), Vec::new());
        for seed in 0..seeds {
            let mut random = Xoshiro128PlusPlus::stream(seed, 7, 11);
            let image: Vec<Vec4> = ramp()
                .into_iter()
                .map(|p| {
                    // 30 samples a pixel.
                    let n = (0..30).map(|_| noise(&mut random)).sum::<f32>() / 30.0;
                    (p.truncate() * n * factor).extend(p.w)
                })
                .collect();
            moments.push(&image);
            offsets.push(mean_offset(&image, &reference));
            errors.push(square_error(&image, &reference));
        }
        (moments, offsets, errors)
    }

    #[test]
    fn known_differences_have_known_measures() {
        let r = exact(ramp());
        // Brighter by a tenth: E² = mean r² / 100 / Ȳ², B = 0.1.
        let brighter: Vec<Vec4> = ramp().iter().map(|p| *p * 1.1).collect();
        assert!((mean_offset(&brighter, &r) - 0.1).abs() < 1e-6);
        let squares: f64 = r
            .pixels
            .iter()
            .map(|&p| square(ramp()[p as usize].truncate()))
            .sum();
        let expected = squares / 3.0 / r.pixels.len() as f64 / r.mean_luminance.powi(2) * 0.01;
        assert!((square_error(&brighter, &r) / expected - 1.0).abs() < 1e-5);
        assert_eq!(square_error(&ramp(), &r), 0.0);
        // What is not covered does not count.
        assert_eq!(r.pixels.len(), (SIZE.x * SIZE.y * 3 / 4) as usize);
        let mut outside = ramp();
        outside[0] = Vec4::splat(100.0);
        assert_eq!(square_error(&outside, &r), 0.0);
        // A constant step in all channels: E = step / Ȳ.
        let step: Vec<Vec4> = ramp()
            .iter()
            .map(|p| *p + Vec4::new(0.2, 0.2, 0.2, 0.0))
            .collect();
        let expected = 0.2 / r.mean_luminance;
        assert!((square_error(&step, &r).sqrt() / expected - 1.0).abs() < 1e-5);
        // The same error in both frames does not flicker; one that comes does.
        assert!(square_flicker(&step, &step, &r, &r) < 1e-12);
        let flicker = square_flicker(&step, &ramp(), &r, &r).sqrt();
        assert!((flicker / expected - 1.0).abs() < 1e-5);
        // NaN does not pass for small.
        let mut bad = ramp();
        bad[(SIZE.x - 1) as usize].x = f32::NAN;
        assert!(!(square_error(&bad, &r) <= 1e9));
    }

    #[test]
    fn unbiased_noise_passes() {
        let (moments, offsets, errors) = noisy(1.0, 16);
        let r = exact(ramp());
        let bias = Bias::of(&offsets, 0.0);
        assert!(bias.p.unwrap() > 0.01, "{bias:?}");
        let local = LocalBias::of(&moments, &r).unwrap();
        assert!(local.p > 0.01, "{local:?}");
        assert!(local.beyond <= 2, "{local:?}");
        // E is the noise's: 1/√30 of each pixel, of which the mean square is known.
        let error = Estimate::root_mean(&errors);
        let squares: f64 = r
            .pixels
            .iter()
            .map(|&p| square(ramp()[p as usize].truncate()))
            .sum();
        let expected = (squares / 3.0 / r.pixels.len() as f64 / 30.0).sqrt() / r.mean_luminance;
        assert!(
            (error.value - expected).abs() < 4.0 * error.error.unwrap(),
            "{error:?} {expected}"
        );
        assert!(error.relative() < 0.01);
        // The map's mean square is the same number.
        let map = error_map(&moments, &r);
        let mean = r
            .pixels
            .iter()
            .map(|&p| map[p as usize].powi(2))
            .sum::<f64>()
            / r.pixels.len() as f64;
        assert!((mean.sqrt() / error.value - 1.0).abs() < 1e-4);
    }

    /// An error of 2 % is seen, in both tests, and its size told.
    #[test]
    fn a_bias_of_two_percent_is_caught() {
        for factor in [0.98, 1.02] {
            let (moments, offsets, _) = noisy(factor, 16);
            let bias = Bias::of(&offsets, 0.001);
            let off = f64::from(factor) - 1.0;
            assert!(bias.p.unwrap() < 1e-6, "{bias:?}");
            assert!((bias.of_image.value - off).abs() < 4.0 * bias.of_image.error.unwrap());
            let local = LocalBias::of(&moments, &exact(ramp())).unwrap();
            assert!(local.p < 1e-3, "{local:?}");
            assert!(local.beyond * 4 > local.tiles, "{local:?}");
        }
    }

    /// The power: how often a bias of so many standard errors is called one at 1 %. By the noncentral t distribution with 15 degrees of
    /// freedom that is 1 % at 0, 0.82 at 4, and all but always at 8.
    #[test]
    fn the_power_is_that_of_the_t_test() {
        let experiments = 400;
        let mut random = Xoshiro128PlusPlus::stream(3, 1, 4);
        let mut share = |shift: f64| {
            let calls = (0..experiments).filter(|_| {
                let values: Vec<f64> = (0..16)
                    .map(|_| {
                        // Twelve uniforms make a variable that is nearly normal.
                        let sum: f64 = (0..12)
                            .map(|_| f64::from(random.next_u32()) / 4_294_967_296.0)
                            .sum();
                        sum - 6.0 + shift / 4.0
                    })
                    .collect();
                Bias::of(&values, 0.0).p.unwrap() < 0.01
            });
            calls.count() as f64 / f64::from(experiments)
        };
        let none = share(0.0);
        assert!(none <= 0.025, "{none}");
        let four = share(4.0);
        assert!((four - 0.82).abs() < 0.08, "{four}");
        assert!(share(8.0) > 0.99);
    }
}
