//! Host file: ꟻLIP, how different two pictures look when one flips between them (Andersson et al. 2020), by NVIDIA's own code
//! behind the feature `flip`.

use glam::UVec2;

/// Mean LDR-ꟻLIP, 0 to 1, of two sRGB pictures of three bytes a pixel, at 67 pixels a degree; `None` where the program was built
/// without the feature `flip`.
#[cfg(feature = "flip")]
#[must_use]
pub fn mean(size: UVec2, reference: &[u8], picture: &[u8]) -> Option<f64> {
    let image = |bytes: &[u8]| nv_flip::FlipImageRgb8::with_data(size.x, size.y, bytes);
    let map = nv_flip::flip(
        image(reference),
        image(picture),
        nv_flip::DEFAULT_PIXELS_PER_DEGREE,
    );
    Some(f64::from(nv_flip::FlipPool::from_image(&map).mean()))
}

/// Mean LDR-ꟻLIP: `None`, since the program was built without the feature `flip`.
#[cfg(not(feature = "flip"))]
#[must_use]
pub fn mean(_size: UVec2, _reference: &[u8], _picture: &[u8]) -> Option<f64> {
    None
}

/// Whether the program was built with it.
pub const IS_THERE: bool = cfg!(feature = "flip");

#[cfg(all(test, feature = "flip"))]
mod tests {
    use super::*;

    #[test]
    fn pictures_differ_as_they_look() {
        let size = UVec2::new(32, 24);
        let grey = |code: u8| vec![code; (size.x * size.y * 3) as usize];
        let flip = |a: &[u8], b: &[u8]| mean(size, a, b).unwrap();
        assert_eq!(flip(&grey(128), &grey(128)), 0.0);
        // Black against white is as different as can be.
        assert!(flip(&grey(0), &grey(255)) > 0.95);
        let (near, far) = (flip(&grey(128), &grey(132)), flip(&grey(128), &grey(160)));
        assert!(0.0 < near && near < far && far < 1.0, "{near} {far}");
        // A checkerboard of single pixels is hardly seen; one of 8 is.
        let checks = |side: u32| -> Vec<u8> {
            let code = |p: u32| {
                if (p % size.x / side + p / size.x / side) % 2 == 0 {
                    118
                } else {
                    138
                }
            };
            (0..size.x * size.y).flat_map(|p| [code(p); 3]).collect()
        };
        assert!(flip(&grey(128), &checks(1)) < 0.7 * flip(&grey(128), &checks(8)));
    }
}
