//! Host file: lists of frames: `7`, `1-96`, `1-100x2`, `1,3,7-9`. Both ends of a range are included, and numbers may be negative.

use crate::error::{Error, Result};

/// The most frames in one list; more would not fit what is made of them.
const MAX_FRAMES: usize = 1_000_000;

/// Reads a list of frames: numbers `A`, ranges `A-B` and every N-th frame of a range `A-BxN`, with commas between them. The numbers
/// come back in order, each once; there is at least one.
///
/// # Errors
/// What is wrong with the text, and how to write a list.
///
/// ```
/// use glimt::shot::range::parse;
/// assert_eq!(parse("3-5").unwrap(), [3, 4, 5]);
/// assert_eq!(parse("7").unwrap(), [7]);
/// assert_eq!(parse("1-8x3").unwrap(), [1, 4, 7]);
/// assert_eq!(parse("7-9, 1, 3, 8").unwrap(), [1, 3, 7, 8, 9]);
/// assert_eq!(parse("-3--1").unwrap(), [-3, -2, -1]);
/// assert!(parse("5-3").is_err());
/// assert!(parse("1-2000000000").is_err());
/// ```
pub fn parse(text: &str) -> Result<Vec<i32>> {
    let mut frames = Vec::new();
    for part in text.split(',') {
        let (first, last, step) = range_of(part.trim()).ok_or_else(|| {
            Error::usage(format!("`{text}` is not a list of frames"))
                .fix("write it as 1-96, as 7 for one frame, as 1-96x2 for every second one, or as 1,3,7-9")
        })?;
        if first > last {
            return Err(
                Error::usage(format!("`{}` is an empty range of frames", part.trim()))
                    .fix(format!("put the smaller number first, as {last}-{first}")),
            );
        }
        let count = last.abs_diff(first) / step + 1;
        if frames.len() as u64 + count > MAX_FRAMES as u64 {
            return Err(
                Error::usage(format!("`{text}` is more than {MAX_FRAMES} frames"))
                    .fix("render them in several runs, or check the numbers"),
            );
        }
        let (Ok(first), Ok(last)) = (i32::try_from(first), i32::try_from(last)) else {
            let ends = format!("frames have numbers from {} to {}", i32::MIN, i32::MAX);
            return Err(
                Error::usage(format!("`{text}` has numbers beyond those of frames")).fix(ends),
            );
        };
        // There are at most MAX_FRAMES steps, so a longer step is never taken.
        frames.extend((first..=last).step_by(usize::try_from(step).unwrap_or(usize::MAX)));
    }
    frames.sort_unstable();
    frames.dedup();
    Ok(frames)
}

/// First, last and step of `A`, `A-B` or `A-BxN`.
fn range_of(part: &str) -> Option<(i64, i64, u64)> {
    let (first, rest) = number(part)?;
    if rest.is_empty() {
        return Some((first, first, 1));
    }
    let (last, rest) = number(rest.strip_prefix('-')?.trim_start())?;
    let step = match rest {
        "" => 1,
        _ => rest.strip_prefix('x')?.trim_start().parse().ok()?,
    };
    (step > 0).then_some((first, last, step))
}

/// A number at the beginning of a text, and what comes after it.
fn number(text: &str) -> Option<(i64, &str)> {
    let sign = usize::from(text.starts_with('-'));
    let digits = text[sign..].bytes().take_while(u8::is_ascii_digit).count();
    let (number, rest) = text.split_at(sign + digits);
    Some((number.parse().ok()?, rest.trim_start()))
}

/// The frames from the first to the last.
///
/// # Errors
/// There are more of them than a list holds.
pub fn between(first: i32, last: i32) -> Result<Vec<i32>> {
    parse(&format!("{first}-{last}"))
}

/// Whether no number between the first and the last is missing. The numbers are in order, each once.
#[must_use]
pub fn is_whole(frames: &[i32]) -> bool {
    frames
        .windows(2)
        .all(|pair| pair[0].checked_add(1) == Some(pair[1]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn negative_numbers_and_steps() {
        assert_eq!(parse("-5").unwrap(), [-5]);
        assert_eq!(parse("-2-1").unwrap(), [-2, -1, 0, 1]);
        assert_eq!(parse(" -4 - -2 , 9 ").unwrap(), [-4, -3, -2, 9]);
        assert_eq!(parse("-3-3x3").unwrap(), [-3, 0, 3]);
        assert_eq!(parse("1-100x2").unwrap().len(), 50);
        let ends = parse("-2147483648,2147483647").unwrap();
        assert_eq!(ends, [i32::MIN, i32::MAX]);
        assert!(is_whole(&[-1, 0, 1]) && is_whole(&[4]));
        assert!(!is_whole(&[1, 3]) && !is_whole(&ends));
    }

    #[test]
    fn what_is_no_list_says_how_to_write_one() {
        for wrong in [
            "", "-", "1-", "a", "1-2-3", "1-5x", "1-5x0", "1x2", "1,", "1..4", "1-5x-1", "--3", "ä",
        ] {
            let error = parse(wrong).unwrap_err().to_string();
            assert!(
                error.contains("1-96x2") && error.contains("1,3,7-9"),
                "{wrong}: {error}"
            );
        }
        let error = parse("1,-1--5").unwrap_err().to_string();
        assert!(error.contains("as -5--1"), "{error}");
        let error = parse("-2147483648-2147483647").unwrap_err().to_string();
        assert!(error.contains("1000000 frames"), "{error}");
    }
}
