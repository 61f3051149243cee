//! Host file: vertex colours of files that do not say how they are encoded.

use crate::notes::Notes;
use glam::Vec4;
use glimt_render_gpu::prepare::plate::srgb_decode;
use glimt_render_gpu::prepare::scene::{Alpha, Opacity};
use rayon::prelude::*;
use std::path::Path;

/// Makes linear colours in [0, 1] of colours as scanners and MeshLab write them: encoded as sRGB, alpha linear. Some programs
/// write 0 to 255 where 1 is white; these are divided. Returns what alpha makes of the surface.
pub fn decode(colors: &mut [Vec4], file: &Path, notes: &mut Notes) -> Opacity {
    let largest = colors.iter().copied().fold(Vec4::ZERO, Vec4::max);
    if largest.truncate().max_element() > 1.0 {
        let alpha = if largest.w > 1.0 { 255.0 } else { 1.0 };
        let white = Vec4::new(255.0, 255.0, 255.0, alpha);
        colors.par_iter_mut().for_each(|color| *color /= white);
        notes.warn(file, "its vertex colours are above 1; taken as 0 to 255");
    }
    notes.note(file, "its vertex colours are taken as sRGB");
    // Not a number counts as 0.
    let clip = |c: f32| if c > 0.0 { c.min(1.0) } else { 0.0 };
    colors.par_iter_mut().for_each(|color| {
        let [r, g, b, alpha] = color.to_array().map(clip);
        let linear = [r, g, b].map(|c| srgb_decode(f64::from(c)) as f32);
        *color = Vec4::new(linear[0], linear[1], linear[2], alpha);
    });
    if colors.iter().all(|color| color.w == 1.0) {
        return Opacity::Opaque;
    }
    if colors.iter().all(|color| color.w == 0.0) {
        let what = "the alpha of all its vertex colours is 0; taken as opaque";
        notes.warn(file, what);
        colors.iter_mut().for_each(|color| color.w = 1.0);
        return Opacity::Opaque;
    }
    Opacity::Blend {
        alpha: Alpha {
            factor: 1.0,
            texture: None,
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn decoded(mut colors: Vec<Vec4>) -> (Vec<Vec4>, Opacity, usize) {
        let mut notes = Notes::default();
        let opacity = decode(&mut colors, Path::new("a"), &mut notes);
        (colors, opacity, notes.take().len())
    }

    #[test]
    fn colours_are_srgb_and_alpha_is_linear() {
        let (colors, opacity, said) = decoded(vec![Vec4::new(1.0, 0.5, 0.0, 0.5), Vec4::ONE]);
        // ((0.5 + 0.055)/1.055)^2.4
        assert!(
            colors[0].abs_diff_eq(Vec4::new(1.0, 0.214_041, 0.0, 0.5), 1e-6),
            "{}",
            colors[0]
        );
        assert!(matches!(opacity, Opacity::Blend { .. }));
        assert_eq!(said, 1);
    }

    #[test]
    fn colours_up_to_255_are_divided() {
        let (colors, opacity, said) = decoded(vec![Vec4::new(255.0, 127.5, 0.0, 1.0)]);
        assert!(
            colors[0].abs_diff_eq(Vec4::new(1.0, 0.214_041, 0.0, 1.0), 1e-6),
            "{}",
            colors[0]
        );
        assert_eq!((opacity, said), (Opacity::Opaque, 2));
    }

    #[test]
    fn colours_that_are_no_colours() {
        let (colors, opacity, said) = decoded(vec![Vec4::new(f32::NAN, -1.0, 1.0, 0.0)]);
        assert_eq!(colors[0], Vec4::new(0.0, 0.0, 1.0, 1.0));
        assert_eq!((opacity, said), (Opacity::Opaque, 2));
    }
}
