//! Host file: names with a place for a frame's number, in the notations of several programs, and such names for what is in a folder.

use crate::error::{Error, Result};
use std::collections::BTreeMap;
use std::ffi::OsStr;
use std::path::Path;

/// The most digits that a number is padded to.
const MAX_DIGITS: usize = 20;

/// Extensions of images. They separate frames from other files of a folder.
const IMAGES: [&str; 9] = [
    "exr", "hdr", "png", "jpg", "jpeg", "tif", "tiff", "pfm", "dpx",
];

/// A name with a place for a number.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pattern {
    /// What comes before the number.
    pub prefix: String,
    /// Digits of the number, filled up with zeros.
    pub digits: usize,
    /// What comes after it.
    pub suffix: String,
    /// Whether `#` stands for the digits. A file of another notation's name may exist; then that file is meant.
    pub is_hash: bool,
}

/// Finds the place of a number at the beginning of a text: its digits, and the bytes that stand for it.
type Notation = fn(&str) -> Option<(usize, usize)>;

/// The notations: `####`, `%04d`, `$F4`, `@@@@`. In a name that has one of them, those behind it are plain text.
const NOTATIONS: [Notation; 4] = [hashes, printf, houdini, ats];

fn hashes(text: &str) -> Option<(usize, usize)> {
    let count = text.bytes().take_while(|b| *b == b'#').count();
    (count > 0).then_some((count, count))
}

fn ats(text: &str) -> Option<(usize, usize)> {
    let count = text.bytes().take_while(|b| *b == b'@').count();
    (count > 0).then_some((count, count))
}

/// `%d` and `%04d`. `%4d` fills up with blanks, which no frames are named by.
fn printf(text: &str) -> Option<(usize, usize)> {
    let rest = text.strip_prefix('%')?;
    let (width, _) = rest.split_once('d')?;
    let digits = match width {
        "" => 1,
        _ => width.strip_prefix('0')?.parse().ok()?,
    };
    Some((digits, width.len() + 2))
}

/// `$F`, `$F4` and `${F4}`.
fn houdini(text: &str) -> Option<(usize, usize)> {
    let (width, length) = match text.strip_prefix("${F") {
        Some(rest) => {
            let (width, _) = rest.split_once('}')?;
            (width, width.len() + 4)
        }
        None => {
            let rest = text.strip_prefix("$F")?;
            let width = &rest[..rest.bytes().take_while(u8::is_ascii_digit).count()];
            let is_longer = |c: char| c.is_alphanumeric() || c == '_';
            if rest[width.len()..].starts_with(is_longer) {
                return None;
            }
            (width, width.len() + 2)
        }
    };
    let digits = match width {
        "" => 1,
        _ => width.parse().ok()?,
    };
    Some((digits, length))
}

impl Pattern {
    /// Reads a file's name. `None` where it has no place for a number. `[#]` is the character `#`.
    ///
    /// # Errors
    /// The name has places for two numbers, or for one of more than 20 digits.
    pub fn parse(name: &str) -> Result<Option<Self>> {
        for (i, notation) in NOTATIONS.into_iter().enumerate() {
            let places = places(name, notation);
            let Some(&(at, digits, length)) = places.first() else {
                continue;
            };
            if places.len() > 1 {
                return Err(
                    Error::usage(format!("`{name}` has a place for two numbers"))
                        .fix("keep one run of #, as light.####.exr; [#] is the character # itself"),
                );
            }
            if !(1..=MAX_DIGITS).contains(&digits) {
                return Err(
                    Error::usage(format!("`{name}` asks for a number of {digits} digits"))
                        .fix("write #### for the frame's number, as light.####.exr"),
                );
            }
            return Ok(Some(Self {
                prefix: unescape(&name[..at]),
                digits,
                suffix: unescape(&name[at + length..]),
                is_hash: i == 0,
            }));
        }
        Ok(None)
    }
}

/// Where numbers stand in a name: the byte, their digits, and how many bytes stand for them.
fn places(name: &str, notation: Notation) -> Vec<(usize, usize, usize)> {
    let mut places = Vec::new();
    let mut at = 0;
    while let Some(c) = name[at..].chars().next() {
        let text = &name[at..];
        if text.starts_with(ESCAPED) {
            at += ESCAPED.len();
        } else if let Some((digits, length)) = notation(text) {
            places.push((at, digits, length));
            at += length;
        } else {
            at += c.len_utf8();
        }
    }
    places
}

/// The character `#`, as it is written in a name.
const ESCAPED: &str = "[#]";

/// A name whose `[#]` are the character `#`.
pub fn unescape(name: &str) -> String {
    name.replace(ESCAPED, "#")
}

/// A name as it is written, with `[#]` for each `#`.
pub fn escape(name: &str) -> String {
    name.replace('#', ESCAPED)
}

/// Whether a name looks like one of many files, in a notation that is not understood: `*`, `<frame>`, `{:04d}`, `[1-9]`.
pub fn is_foreign(name: &str) -> bool {
    let has_range = || {
        let (_, rest) = name.split_once('[')?;
        Some(rest.starts_with(|c: char| c.is_ascii_digit()) && rest.contains(']'))
    };
    name.contains(['*', '?', '<', '>', '{', '}', '%', '$']) || has_range() == Some(true)
}

/// The most frames in a folder that are named alike.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Example {
    /// Their name, with `#` for the digits of the number; an image's name where none has a number.
    pub name: String,
    /// How many there are.
    pub count: usize,
}

/// How the frames are named that are in a folder: of the images there, or of the files with this extension, those that are most.
/// `None` where there are none, or the folder cannot be read.
pub fn example(folder: &Path, extension: Option<&OsStr>) -> Option<Example> {
    // By what stands around the number: how many there are, and the fewest digits.
    let mut groups: BTreeMap<(String, Option<String>), (usize, usize)> = BTreeMap::new();
    for entry in std::fs::read_dir(folder).ok()?.flatten() {
        let name = entry.file_name();
        let own = Path::new(&name).extension().unwrap_or_default();
        let is_meant = match extension {
            Some(extension) => own.eq_ignore_ascii_case(extension),
            None => IMAGES.iter().any(|image| own.eq_ignore_ascii_case(image)),
        };
        let Some(name) = name
            .to_str()
            .filter(|name| is_meant && !name.starts_with('.'))
        else {
            continue;
        };
        let stem = &name[..name.len() - own.len() - 1];
        let is_digit = |c: char| c.is_ascii_digit();
        let (key, digits) = match stem.rfind(is_digit) {
            None => ((escape(name), None), 0),
            Some(last) => {
                let first = stem[..=last].trim_end_matches(is_digit).len();
                let suffix = escape(&name[last + 1..]);
                ((escape(&name[..first]), Some(suffix)), last + 1 - first)
            }
        };
        let (count, fewest) = groups.entry(key).or_insert((0, digits));
        *count += 1;
        *fewest = digits.min(*fewest);
    }
    let most = groups
        .into_iter()
        .max_by_key(|(key, (count, _))| (key.1.is_some(), *count))?;
    let ((prefix, suffix), (count, digits)) = most;
    let name = prefix + &"#".repeat(digits) + &suffix.unwrap_or_default();
    Some(Example { name, count })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn notations_of_several_programs() {
        let parts = |name: &str| {
            let pattern = Pattern::parse(name).unwrap()?;
            Some((pattern.prefix, pattern.digits, pattern.suffix))
        };
        let is = |name: &str, prefix: &str, digits: usize, suffix: &str| {
            assert_eq!(
                parts(name),
                Some((prefix.to_owned(), digits, suffix.to_owned())),
                "{name}"
            );
        };
        is("l.####.exr", "l.", 4, ".exr");
        is("l.%04d.exr", "l.", 4, ".exr");
        is("l.%012d.exr", "l.", 12, ".exr");
        is("l%d.exr", "l", 1, ".exr");
        is("l.$F4.exr", "l.", 4, ".exr");
        is("l.$F.exr", "l.", 1, ".exr");
        is("l.${F3}_b.exr", "l.", 3, "_b.exr");
        is("l.@@@@.exr", "l.", 4, ".exr");
        // Where there is a #, all else is plain text; [#] is none.
        is("a@2x.%04d.##.exr", "a@2x.%04d.", 2, ".exr");
        is("take[#]2.####.exr", "take#2.", 4, ".exr");
        is("take[#]2.%04d.exr", "take#2.", 4, ".exr");
        for plain in [
            "l.exr",
            "l.%4d.exr",
            "l.$FF.exr",
            "l.$F4x.exr",
            "50%.exr",
            "take[#]2.exr",
            "ä%.exr",
        ] {
            assert_eq!(parts(plain), None, "{plain}");
        }
        for wrong in [
            "a##b##.exr",
            "%d.%d.exr",
            "$F4$F4.exr",
            "%0999999999d.exr",
            "l.%00d.exr",
        ] {
            assert!(Pattern::parse(wrong).is_err(), "{wrong}");
        }
        assert!(Pattern::parse(&"#".repeat(100_000)).is_err());
    }

    #[test]
    fn foreign_notations_are_known() {
        for foreign in [
            "l.*.exr",
            "l.????.exr",
            "l.<UDIM>.exr",
            "l.{:04d}.exr",
            "l.[0001-0100].exr",
            "l.%4d.exr",
            "l.$FF.exr",
        ] {
            assert!(is_foreign(foreign), "{foreign}");
        }
        assert!(!is_foreign("light [graded].exr") && !is_foreign("l.exr"));
    }
}
