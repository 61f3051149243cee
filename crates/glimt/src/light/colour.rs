//! Host file: colours of the probe brought to those of the backplate: a matrix, gains, or what patches say that both show.

use super::Probe;
use crate::error::{Error, Result};
use crate::input::footage::Footage;
use crate::input::{Reading, is_display, light_image, plate};
use crate::notes::Notes;
use crate::shot::parse::Source;
use crate::shot::{Box4, Shot};
use glam::{DMat3, DVec3, Mat3, UVec2, Vec4};
use glimt_probe::gather::ColourMatrix;
use glimt_sampling::luminance;
use std::path::Path;

/// Below this determinant of the patches' correlation they are too alike to tell three channels apart.
const TOO_ALIKE: f64 = 1e-4;

/// The colours of one patch, linear.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pair {
    /// As the probe shows it.
    pub probe: DVec3,
    /// As it should be.
    pub plate: DVec3,
}

/// How a correction was found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fit {
    /// Applied to the probe's colours.
    pub matrix: DMat3,
    /// Whether it is a full matrix, not a gain for each channel.
    pub full: bool,
    /// Relative RMS distance of the corrected patches from the plate's.
    pub residual: f64,
}

/// The matrix that brings the probe's patches nearest to the plate's, each weighed by one over its luminance; a gain for each
/// channel where there are fewer than three patches, or all of nearly one colour. `None` where a channel is black in all.
///
/// ```
/// use glam::{DMat3, DVec3};
/// use glimt::light::colour::{Pair, fit};
/// let truth = DMat3::from_diagonal(DVec3::new(1.2, 1.0, 0.7));
/// let pair = |probe: DVec3| Pair { probe, plate: truth * probe };
/// let pairs = [pair(DVec3::X), pair(DVec3::ONE), pair(DVec3::new(0.1, 0.9, 0.2))];
/// let found = fit(&pairs).unwrap();
/// assert!(found.full && found.matrix.abs_diff_eq(truth, 1e-9));
/// ```
pub fn fit(pairs: &[Pair]) -> Option<Fit> {
    let weight = |pair: &Pair| {
        let level = luminance(pair.plate.as_vec3()).max(1e-6);
        1.0 / f64::from(level).powi(2)
    };
    // The columns of Σ w p pᵀ and Σ w q pᵀ.
    let mut own = DMat3::ZERO;
    let mut cross = DMat3::ZERO;
    for pair in pairs {
        let (w, p, q) = (weight(pair), pair.probe, pair.plate);
        own += DMat3::from_cols(p * (p.x * w), p * (p.y * w), p * (p.z * w));
        cross += DMat3::from_cols(q * (p.x * w), q * (p.y * w), q * (p.z * w));
    }
    let diagonal = DVec3::new(own.x_axis.x, own.y_axis.y, own.z_axis.z);
    if !(diagonal.min_element() > 0.0 && diagonal.is_finite()) {
        return None;
    }
    let scale = DMat3::from_diagonal(
        DVec3::ONE / DVec3::new(diagonal.x.sqrt(), diagonal.y.sqrt(), diagonal.z.sqrt()),
    );
    let correlation = scale * own * scale;
    let full = pairs.len() >= 3 && correlation.determinant() > TOO_ALIKE;
    let matrix = if full {
        cross * own.inverse()
    } else {
        DMat3::from_diagonal(DVec3::new(cross.x_axis.x, cross.y_axis.y, cross.z_axis.z) / diagonal)
    };
    let squares: f64 = pairs
        .iter()
        .map(|pair| weight(pair) * (matrix * pair.probe - pair.plate).length_squared() / 3.0)
        .sum();
    Some(Fit {
        matrix,
        full,
        residual: (squares / pairs.len() as f64).sqrt(),
    })
}

/// Gains that make a grey patch grey and keep its luminance. `None` where a channel is black.
///
/// ```
/// use glam::DVec3;
/// use glimt::light::colour::grey_gains;
/// let warm = DVec3::new(0.8, 0.5, 0.3);
/// let balanced = grey_gains(warm).unwrap() * warm;
/// assert!((balanced - DVec3::splat(balanced.x)).length() < 1e-12);
/// assert_eq!(grey_gains(DVec3::X), None);
/// ```
pub fn grey_gains(patch: DVec3) -> Option<DVec3> {
    let level = DVec3::new(0.2126, 0.7152, 0.0722).dot(patch);
    (patch.min_element() > 0.0).then(|| DVec3::splat(level) / patch)
}

/// Changes the colours of a shot's probe as its `[probe.colour]` asks, if it does. They are matched in the frame `first`, unless
/// the shot names another.
///
/// # Errors
/// Those of [`correction`]; the frame that the shot names is not there.
pub fn correct(
    probe: &mut Probe,
    shot: &Shot,
    source: &Source,
    footage: Option<&Footage>,
    first: i32,
    notes: &mut Notes,
) -> Result<()> {
    let Some(keys) = &shot.probe.colour else {
        return Ok(());
    };
    let frame = keys.frame.unwrap_or(first);
    let plate = footage.map(|footage| footage.file(frame));
    let photo = probe.file(frame);
    let missing = [Some(&photo), plate.as_ref()]
        .into_iter()
        .flatten()
        .find(|file| keys.frame.is_some() && !file.is_file());
    if let Some(file) = missing {
        let what = format!("{} is not there", file.display());
        return Err(source
            .error("probe.colour.frame", what)
            .fix("choose a frame that probe and backplate have, or leave it out for the first"));
    }
    probe.set_colour(correction(shot, source, &photo, plate.as_deref(), notes)?);
    Ok(())
}

/// The correction that the keys of `[probe.colour]` ask for. Patches are read in `photo`, the probe's own frame, and in
/// `plate`, the backplate's.
///
/// # Errors
/// A patch lies outside its image or is black, or there is no backplate to take one from.
pub fn correction(
    shot: &Shot,
    source: &Source,
    photo: &Path,
    plate: Option<&Path>,
    notes: &mut Notes,
) -> Result<ColourMatrix> {
    let keys = shot.probe.colour.clone().unwrap_or_default();
    let mut matrix = DMat3::IDENTITY;
    if let Some([r, g, b]) = keys.matrix {
        matrix = DMat3::from_cols(
            DVec3::from(r.map(f64::from)),
            DVec3::from(g.map(f64::from)),
            DVec3::from(b.map(f64::from)),
        )
        .transpose();
    }
    if let Some(gains) = keys.gains {
        matrix = DMat3::from_diagonal(DVec3::from(gains.map(f64::from))) * matrix;
    }
    if keys.grey.is_some() || !keys.patches.is_empty() {
        let photo = Image::photo(photo, &Reading::of_probe(shot))?;
        if let Some(area) = keys.grey {
            let patch = matrix * photo.mean("probe.colour.grey", area, source, notes)?;
            let gains = grey_gains(patch).ok_or_else(|| {
                source
                    .error("probe.colour.grey", "a channel of the patch is black")
                    .fix("choose a patch that light falls on")
            })?;
            matrix = DMat3::from_diagonal(gains) * matrix;
        } else {
            let file = plate.ok_or_else(|| {
                source
                    .error("probe.colour.patches", "there is no backplate to match")
                    .fix("add [backplate], or use probe.colour.grey")
            })?;
            let plate = Image::plate(file, &Reading::of_plate(shot))?;
            let mut pairs = Vec::new();
            for (i, patch) in keys.patches.iter().enumerate() {
                let mut lit = |image: &Image<'_>, which: &str, area: Box4| {
                    let key = format!("probe.colour.patches.{i}.{which}");
                    let mean = image.mean(&key, area, source, notes)?;
                    if mean.max_element() > 0.0 {
                        return Ok(mean);
                    }
                    Err(source
                        .error(&key, "the patch is black")
                        .fix("choose a patch that light falls on"))
                };
                let probe = matrix * lit(&photo, "probe", patch.probe)?;
                let plate = lit(&plate, "plate", patch.plate)?;
                pairs.push(Pair { probe, plate });
            }
            let found = fit(&pairs).ok_or_else(|| {
                source
                    .error(
                        "probe.colour.patches",
                        "a channel is black in all patches of the probe",
                    )
                    .fix("choose patches that light falls on")
            })?;
            notes.note(photo.file, in_words(&found, pairs.len()));
            matrix = found.matrix * matrix;
        }
    }
    Ok(ColourMatrix::from_mat3(Mat3::from_cols(
        matrix.x_axis.as_vec3(),
        matrix.y_axis.as_vec3(),
        matrix.z_axis.as_vec3(),
    )))
}

/// An image that patches are read in.
struct Image<'a> {
    file: &'a Path,
    size: UVec2,
    pixels: Vec<Vec4>,
    /// Whether it holds nothing brighter than white.
    display: bool,
}

impl<'a> Image<'a> {
    fn photo(file: &'a Path, reading: &Reading) -> Result<Self> {
        let image = light_image::read_photo(file, reading, &mut Notes::default())?;
        Ok(Self {
            file,
            size: image.size,
            pixels: image.pixels,
            display: is_display(file)?,
        })
    }

    /// The plate with the primaries of light, which its patches are compared with.
    fn plate(file: &'a Path, reading: &Reading) -> Result<Self> {
        let image = plate::read(file, reading, &mut Notes::default())?;
        let matrix = image.primaries.matrix_to(&reading.working);
        let mut linear = image.colours.into_linear();
        if let Some(matrix) = matrix {
            for colour in &mut linear {
                *colour = (matrix * colour.as_dvec3()).as_vec3();
            }
        }
        Ok(Self {
            file,
            size: image.size,
            pixels: linear.iter().map(|c| c.extend(1.0)).collect(),
            display: is_display(file)?,
        })
    }

    /// Mean colour of a box.
    fn mean(&self, key: &str, area: Box4, source: &Source, notes: &mut Notes) -> Result<DVec3> {
        let mean = mean_of(area, self.size, &self.pixels)
            .ok_or_else(|| outside(source, key, area, self.size, self.file))?;
        if self.display && mean.max_element() >= 0.999 {
            notes.warn(
                self.file,
                format!("{key}: the patch is clipped, and says little of its colour"),
            );
        }
        Ok(mean)
    }
}

fn in_words(found: &Fit, count: usize) -> String {
    let m = found.matrix.transpose();
    let row = |v: DVec3| format!("[{:.4}, {:.4}, {:.4}]", v.x, v.y, v.z);
    let residual = 100.0 * found.residual;
    if found.full {
        format!(
            "colours matched by {count} patches to {residual:.1} %: matrix = [{}, {}, {}]",
            row(m.x_axis),
            row(m.y_axis),
            row(m.z_axis)
        )
    } else {
        let gains = DVec3::new(m.x_axis.x, m.y_axis.y, m.z_axis.z);
        format!(
            "colours matched to {residual:.1} % by gains = {}: {count} patches of so few colours say no more",
            row(gains)
        )
    }
}

fn outside(source: &Source, key: &str, [x, y, w, h]: Box4, size: UVec2, file: &Path) -> Error {
    let what = format!(
        "the box [{x}, {y}, {w}, {h}] does not lie in {}, which is {} × {}",
        file.display(),
        size.x,
        size.y
    );
    source
        .error(key, what)
        .fix("a box is [left, top, width, height] in pixels, and holds one at least")
}

/// Mean of the pixels of a box; `None` where it is empty or reaches beyond the image.
fn mean_of([x, y, w, h]: Box4, size: UVec2, pixels: &[Vec4]) -> Option<DVec3> {
    let right = x.checked_add(w)?;
    let bottom = y.checked_add(h)?;
    if w == 0 || h == 0 || right > size.x || bottom > size.y {
        return None;
    }
    let mut sum = DVec3::ZERO;
    for row in y..bottom {
        let first = row as usize * size.x as usize;
        let row = &pixels[first + x as usize..first + right as usize];
        sum += row.iter().map(|p| p.truncate().as_dvec3()).sum::<DVec3>();
    }
    Some(sum / (f64::from(w) * f64::from(h)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pairs(truth: DMat3, noise: f64) -> Vec<Pair> {
        let patch = |i: u32| {
            let t = f64::from(i);
            let probe = DVec3::new(
                0.2 + 0.5 * (t * 1.3).sin().abs(),
                0.3 + 0.3 * (t * 2.1).cos().abs(),
                0.1 + 0.1 * t,
            );
            let wrong = DVec3::new((t * 7.0).sin(), (t * 5.0).sin(), (t * 3.0).sin()) * noise;
            Pair {
                probe,
                plate: truth * probe * (DVec3::ONE + wrong),
            }
        };
        (0..8).map(patch).collect()
    }

    #[test]
    fn a_matrix_is_found_again() {
        let truth = DMat3::from_cols_array(&[1.1, 0.05, -0.02, 0.1, 0.9, 0.03, 0.0, 0.1, 1.3]);
        let exact = fit(&pairs(truth, 0.0)).unwrap();
        assert!(exact.full && exact.matrix.abs_diff_eq(truth, 1e-9) && exact.residual < 1e-9);
        let noisy = fit(&pairs(truth, 0.01)).unwrap();
        assert!(noisy.matrix.abs_diff_eq(truth, 0.2) && noisy.residual > 1e-4);
        assert!(!noisy.matrix.abs_diff_eq(DMat3::IDENTITY, 0.05));
    }

    #[test]
    fn grey_patches_give_gains_alone() {
        let gains = DVec3::new(1.5, 1.0, 0.6);
        let grey = |level: f64| Pair {
            probe: DVec3::splat(level),
            plate: gains * level,
        };
        let found = fit(&[grey(0.1), grey(0.2), grey(0.5), grey(0.9)]).unwrap();
        assert!(!found.full);
        assert!(found.matrix.abs_diff_eq(DMat3::from_diagonal(gains), 1e-9));
        assert!(
            fit(&[Pair {
                probe: DVec3::X,
                plate: DVec3::ONE
            }])
            .is_none()
        );
        assert!(fit(&[]).is_none());
    }

    #[test]
    fn boxes_stay_in_the_image() {
        let pixels: Vec<Vec4> = (0..12).map(|i| Vec4::splat(i as f32)).collect();
        let size = UVec2::new(4, 3);
        assert_eq!(
            mean_of([1, 1, 2, 2], size, &pixels),
            Some(DVec3::splat(7.5))
        );
        assert_eq!(mean_of([3, 0, 2, 1], size, &pixels), None);
        assert_eq!(mean_of([0, 0, 0, 1], size, &pixels), None);
        assert_eq!(mean_of([u32::MAX, 0, 2, 1], size, &pixels), None);
    }
}
