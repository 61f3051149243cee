//! Host file: ranges of frames, `A-B`, both ends included.

use crate::error::{Error, Result};
use std::ops::RangeInclusive;

/// The most frames in one range; more would not fit the lists that are made of them.
const MAX_FRAMES: u32 = 1_000_000;

/// Reads `A-B` or `A`.
///
/// # Errors
/// What is wrong with the text, and how to write a range.
///
/// ```
/// assert_eq!(glimt::shot::range::parse("3-5").unwrap(), 3..=5);
/// assert_eq!(glimt::shot::range::parse("7").unwrap(), 7..=7);
/// assert!(glimt::shot::range::parse("5-3").is_err());
/// assert!(glimt::shot::range::parse("1-4000000000").is_err());
/// ```
pub fn parse(text: &str) -> Result<RangeInclusive<u32>> {
    let (first, last) = text.split_once('-').unwrap_or((text, text));
    let number = |word: &str| {
        word.trim().parse::<u32>().map_err(|_| {
            Error::usage(format!("`{text}` is not a range of frames"))
                .fix("write it as 1-96, or as 7 for one frame")
        })
    };
    let (first, last) = (number(first)?, number(last)?);
    if first > last {
        return Err(
            Error::usage(format!("`{text}` is an empty range of frames"))
                .fix(format!("put the smaller number first, as {last}-{first}")),
        );
    }
    if last - first >= MAX_FRAMES {
        return Err(
            Error::usage(format!("`{text}` is more than {MAX_FRAMES} frames"))
                .fix("render them in several runs, or check the numbers"),
        );
    }
    Ok(first..=last)
}
