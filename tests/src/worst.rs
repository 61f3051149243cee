//! Host file: the largest of many errors, where a NaN is larger than all.
//!
//! `f32::max`, `f64::max` and glam's `max_element` pass a NaN over, and `if one <= worst` loses it to the next number. So a
//! comparator takes the largest of its errors by these alone, channel by channel: a NaN once seen stays, and no bound holds it.

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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_nan_is_kept_wherever_it_stands() {
        assert_eq!(worst([0.5, 3.0, 1.0]), 3.0);
        assert_eq!(worst::<f64>([]), 0.0);
        assert_eq!(worst([1.0f32, f32::INFINITY, 2.0]), f64::INFINITY);
        for place in 0..4 {
            let mut errors = [0.5f32, 3.0, 1.0, 7.0];
            errors[place] = f32::NAN;
            assert!(worst(errors).is_nan(), "{place}");
            // Where a number would win.
            assert!(!errors.into_iter().fold(0.0, f32::max).is_nan());
        }
    }
}
