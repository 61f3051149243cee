//! Host file: the largest of many errors, where a NaN is larger than all.
//!
//! `f32::max`, `f64::max` and glam's `max_element` pass a NaN over, and `if one <= worst` loses it to the next number. So a
//! comparator takes the largest of its errors by these alone, channel by channel: a NaN once seen stays, and no bound holds it.

use glam::DVec4;

/// The larger of the largest error so far and one more.
#[must_use]
pub fn larger(worst: f64, one: f64) -> f64 {
    if worst.is_nan() || one <= worst {
        worst
    } else {
        one
    }
}

/// The largest of errors that are not negative; 0 of none, NaN where one is.
pub fn worst<E: Into<f64>>(errors: impl IntoIterator<Item = E>) -> f64 {
    errors.into_iter().map(Into::into).fold(0.0, larger)
}

/// The largest difference of pairs, channel by channel, as a share of the largest value of the second ones; without end where one is
/// no number.
pub fn largest_share(pairs: impl Iterator<Item = (DVec4, DVec4)>) -> f64 {
    let (mut off, mut largest) = (0.0, 0.0);
    for (a, b) in pairs {
        if !(a.is_finite() && b.is_finite()) {
            return f64::INFINITY;
        }
        off = larger(off, (a - b).abs().max_element());
        largest = larger(largest, b.abs().max_element());
    }
    off / largest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_nan_is_kept_wherever_it_stands() {
        assert_eq!(worst([0.5, 3.0, 1.0]), 3.0);
        assert_eq!(worst::<f64>([]), 0.0);
        let pair = (
            DVec4::new(1.0, 2.0, 3.0, -4.0),
            DVec4::new(1.0, 2.0, 5.0, -8.0),
        );
        assert_eq!(largest_share([pair].into_iter()), 0.5);
        assert_eq!(worst([1.0f32, f32::INFINITY, 2.0]), f64::INFINITY);
        for place in 0..4 {
            let mut errors = [0.5f32, 3.0, 1.0, 7.0];
            errors[place] = f32::NAN;
            assert!(worst(errors).is_nan(), "{place}");
            let pairs = errors.map(|e| (DVec4::ONE, DVec4::new(1.0, 0.5, f64::from(e), 2.0)));
            assert_eq!(largest_share(pairs.into_iter()), f64::INFINITY, "{place}");
            // Where a number would win.
            assert!(!errors.into_iter().fold(0.0, f32::max).is_nan());
        }
    }
}
