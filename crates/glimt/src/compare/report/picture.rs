//! Host file: pictures inside a page: crops, false colour, PNG as a data URL.

use glam::UVec2;

/// Largest crop.
const CROP: UVec2 = UVec2::new(360, 270);

/// Viridis, in even steps from dark to bright; between them colours are mixed. Its brightness rises evenly, and
/// it is clear without red or green.
const VIRIDIS: [[u8; 3]; 9] = [
    [0x44, 0x01, 0x54],
    [0x47, 0x2d, 0x7b],
    [0x3b, 0x52, 0x8b],
    [0x2c, 0x72, 0x8e],
    [0x21, 0x91, 0x8c],
    [0x28, 0xae, 0x80],
    [0x5e, 0xc9, 0x62],
    [0xad, 0xdc, 0x30],
    [0xfd, 0xe7, 0x25],
];

/// A colour for each share from 0 to 1.
#[must_use]
pub fn viridis(share: f64) -> [u8; 3] {
    let last = VIRIDIS.len() - 1;
    let place = share.clamp(0.0, 1.0) * last as f64;
    // A NaN is a bug that should be seen: it becomes the first colour's index, and no panic.
    let below = (place as usize).min(last - 1);
    let part = place - below as f64;
    std::array::from_fn(|c| {
        let [a, b] = [VIRIDIS[below][c], VIRIDIS[below + 1][c]].map(f64::from);
        (a + (b - a) * part).round() as u8
    })
}

/// A logarithmic scale of colours.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    /// The value of the darkest.
    pub low: f64,
    /// The value of the brightest.
    pub high: f64,
}

impl Scale {
    /// Two decades, of which the brightest colour is passed by one pixel in 200.
    #[must_use]
    pub fn of(maps: &[Vec<f64>], pixels: &[u32]) -> Self {
        let mut values: Vec<f64> = maps
            .iter()
            .flat_map(|map| pixels.iter().map(|&p| map[p as usize]))
            .collect();
        values.sort_by(f64::total_cmp);
        let high = values.get(values.len() * 199 / 200).copied().unwrap_or(1.0);
        let high = if high > 0.0 && high.is_finite() {
            high
        } else {
            1.0
        };
        Self {
            low: high / 100.0,
            high,
        }
    }

    /// The colour of a value.
    #[must_use]
    pub fn colour(self, value: f64) -> [u8; 3] {
        viridis((value.max(self.low) / self.low).ln() / (self.high / self.low).ln())
    }
}

/// A part of an image.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Crop {
    at: UVec2,
    size: UVec2,
    width: u32,
}

impl Crop {
    /// The whole of a small image; of a larger one, where most error is in all contestants together.
    #[must_use]
    pub fn of(size: UVec2, maps: &[Vec<f64>]) -> Self {
        let part = size.min(CROP);
        let step = 16;
        let mut best = (-1.0, UVec2::ZERO);
        let error = |at: UVec2| -> f64 {
            let rows = (at.y..at.y + part.y).step_by(4);
            let pixels = rows.flat_map(|y| {
                (at.x..at.x + part.x)
                    .step_by(4)
                    .map(move |x| y * size.x + x)
            });
            // The square root keeps a few bright pixels from ruling.
            pixels
                .map(|p| maps.iter().map(|m| m[p as usize].sqrt()).sum::<f64>())
                .sum()
        };
        for y in (0..=size.y - part.y).step_by(step) {
            for x in (0..=size.x - part.x).step_by(step) {
                let at = UVec2::new(x, y);
                let here = error(at);
                if here > best.0 {
                    best = (here, at);
                }
            }
        }
        Self {
            at: best.1,
            size: part,
            width: size.x,
        }
    }

    /// Its width and height.
    #[must_use]
    pub fn size(self) -> UVec2 {
        self.size
    }

    /// Cuts it from an image of three bytes a pixel.
    #[must_use]
    pub fn cut(self, image: &[u8]) -> Vec<u8> {
        let rows = self.at.y..self.at.y + self.size.y;
        rows.flat_map(|y| {
            let first = 3 * (y * self.width + self.at.x) as usize;
            image[first..first + 3 * self.size.x as usize]
                .iter()
                .copied()
        })
        .collect()
    }

    /// What part it is, in words.
    #[must_use]
    pub fn describe(self, whole: UVec2) -> String {
        match self.size == whole {
            true => format!("the whole image, {} × {} pixels", whole.x, whole.y),
            false => format!(
                "{} × {} of {} × {} pixels from ({}, {}), where most error is",
                self.size.x, self.size.y, whole.x, whole.y, self.at.x, self.at.y
            ),
        }
    }
}

/// A PNG of three sRGB bytes a pixel as a URL that holds it.
#[must_use]
pub fn data_url(size: UVec2, codes: &[u8]) -> String {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, size.x, size.y);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    let written = encoder.write_header().and_then(|mut writer| {
        writer.write_image_data(codes)?;
        writer.finish()
    });
    match written {
        Ok(()) => format!("data:image/png;base64,{}", base64(&bytes)),
        // Writing to memory does not fail.
        Err(_) => String::new(),
    }
}

/// Base 64 (RFC 4648).
#[must_use]
pub fn base64(bytes: &[u8]) -> String {
    const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for chunk in bytes.chunks(3) {
        let word = |i: usize| u32::from(chunk.get(i).copied().unwrap_or(0));
        let bits = word(0) << 16 | word(1) << 8 | word(2);
        for i in 0..4 {
            let letter = LETTERS[(bits >> (18 - 6 * i)) as usize & 63];
            text.push(if i <= chunk.len() {
                char::from(letter)
            } else {
                '='
            });
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn base64_is_that_of_the_standard() {
        let pairs = [
            ("", ""),
            ("f", "Zg=="),
            ("fo", "Zm8="),
            ("foo", "Zm9v"),
            ("foobar", "Zm9vYmFy"),
        ];
        for (plain, coded) in pairs {
            assert_eq!(base64(plain.as_bytes()), coded);
        }
    }

    #[test]
    fn colours_grow_brighter() {
        let bright = |c: [u8; 3]| {
            0.2126 * f64::from(c[0]) + 0.7152 * f64::from(c[1]) + 0.0722 * f64::from(c[2])
        };
        let steps: Vec<f64> = (0..=50)
            .map(|i| bright(viridis(f64::from(i) / 50.0)))
            .collect();
        assert!(steps.windows(2).all(|w| w[1] > w[0]), "{steps:?}");
        let scale = Scale {
            low: 0.01,
            high: 1.0,
        };
        assert_eq!(scale.colour(0.0), VIRIDIS[0]);
        assert_eq!(scale.colour(0.1), VIRIDIS[4]);
        assert_eq!(scale.colour(7.0), VIRIDIS[8]);
    }

    #[test]
    fn crops_are_where_the_error_is() {
        let size = UVec2::new(800, 600);
        let map: Vec<f64> = (0..size.x * size.y)
            .map(|p| f64::from(u8::from(p % size.x > 600 && p / size.x > 400)))
            .collect();
        let crop = Crop::of(size, &[map]);
        assert!(crop.at.x >= 432 && crop.at.y >= 320, "{crop:?}");
        let whole = UVec2::new(4, 2);
        let crop = Crop::of(whole, &[vec![0.0; 8]]);
        let image: Vec<u8> = (0..24).collect();
        assert_eq!(crop.cut(&image), image);
        assert!(data_url(whole, &image).starts_with("data:image/png;base64,iVBORw0KGgo"));
    }
}
