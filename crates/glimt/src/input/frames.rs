//! Host file: the files of a sequence, `light.####.exr`, or of a still.

use super::pattern::{Example, Pattern, escape, example, is_foreign, unescape};
use crate::error::{Error, Result};
use crate::notes::Notes;
use glam::UVec2;
use std::ffi::OsStr;
use std::path::{Path, PathBuf};

/// Where the frames of a sequence are.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FrameFiles {
    /// One file for every frame.
    Still(PathBuf),
    /// A file for each frame: its number, with at least `digits` digits, between `prefix` and `suffix`.
    Sequence {
        /// Folder.
        dir: PathBuf,
        /// What comes before the number.
        prefix: String,
        /// Digits of the number, filled up with zeros.
        digits: usize,
        /// What comes after it.
        suffix: String,
    },
}

impl FrameFiles {
    /// Reads a path whose file name has a place for the frame's number: `####`, or `%04d`, `$F4` and `@@@@` of other programs. `[#]`
    /// is the character `#`. A relative path is relative to `base`. A name without such a place is a still's, and so is one of
    /// another program's notation if a file has just this name.
    ///
    /// # Errors
    /// The name holds two numbers, is a folder, or is one for many files in a notation that is not understood.
    pub fn new(base: &Path, pattern: &str) -> Result<Self> {
        let path = base.join(pattern);
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let parsed = Pattern::parse(&name)?;
        if !parsed.as_ref().is_some_and(|parsed| parsed.is_hash) && path.is_file() {
            return Ok(Self::Still(path));
        }
        let dir = path.parent().map(Path::to_owned).unwrap_or_default();
        let Some(parsed) = parsed else {
            let plain = match name.is_empty() {
                true => path.clone(),
                false => path.with_file_name(unescape(&name)),
            };
            if plain.is_dir() {
                return Err(
                    Error::usage(format!("`{pattern}` is a folder")).fix(folder_fix(
                        &plain,
                        Path::new(pattern),
                        None,
                    )),
                );
            }
            if is_foreign(&name) && !plain.exists() {
                let what = format!(
                    "`{pattern}` is the name of no file, nor is its notation for frames known"
                );
                let folder = Path::new(pattern).parent().unwrap_or(Path::new(""));
                return Err(Error::usage(what).fix(folder_fix(
                    &dir,
                    folder,
                    Path::new(&*name).extension(),
                )));
            }
            return Ok(Self::Still(plain));
        };
        Ok(Self::Sequence {
            dir,
            prefix: parsed.prefix,
            digits: parsed.digits,
            suffix: parsed.suffix,
        })
    }

    /// The file of a frame. The sign of a negative number counts as one of its digits, as in `printf`, unless there is a file in
    /// whose name it does not.
    pub fn path(&self, frame: i32) -> PathBuf {
        let (dir, prefix, digits, suffix) = match self {
            Self::Still(path) => return path.clone(),
            Self::Sequence {
                dir,
                prefix,
                digits,
                suffix,
            } => (dir, prefix, *digits, suffix),
        };
        let path = dir.join(format!("{prefix}{frame:0digits$}{suffix}"));
        if frame < 0 && !path.exists() {
            let number = frame.unsigned_abs();
            let longer = dir.join(format!("{prefix}-{number:0digits$}{suffix}"));
            if longer.exists() {
                return longer;
            }
        }
        path
    }

    /// Whether every frame is the same file.
    pub fn is_still(&self) -> bool {
        matches!(self, Self::Still(_))
    }

    /// The numbers of the frames that are there, in order; frame 1 of a still.
    ///
    /// # Errors
    /// The folder cannot be read, or holds no frame.
    pub fn existing(&self) -> Result<Vec<i32>> {
        let frames = self
            .listed()
            .map_err(|e| Error::reading(self.folder(), &e))?;
        if frames.is_empty() {
            let pattern = self.pattern();
            let others = example(self.folder(), Path::new(&pattern).extension());
            let what = match others {
                None => format!("no file is named {pattern}"),
                Some(others) if others.name == pattern => {
                    format!(
                        "the numbers of {pattern} are none from {} to {}",
                        i32::MIN,
                        i32::MAX
                    )
                }
                Some(Example { name, count }) => {
                    format!("no file is named {pattern} ({count} there: {name})")
                }
            };
            return Err(Error::input(self.folder(), what)
                .fix("check probe.frames: each # stands for a digit of the frame's number"));
        }
        Ok(frames)
    }

    /// The numbers of the frames that are there, in order, maybe none; frame 1 of a still.
    ///
    /// # Errors
    /// The folder cannot be read.
    pub fn listed(&self) -> std::io::Result<Vec<i32>> {
        if self.is_still() {
            return Ok(vec![1]);
        }
        let mut frames: Vec<i32> = std::fs::read_dir(self.folder())?
            .flatten()
            .filter_map(|entry| self.number(&entry.file_name().to_string_lossy()))
            .collect();
        frames.sort_unstable();
        frames.dedup();
        Ok(frames)
    }

    /// The number in the name of a frame of a sequence. The sign of a negative one may count as one of its digits or not.
    fn number(&self, name: &str) -> Option<i32> {
        let Self::Sequence {
            prefix,
            digits,
            suffix,
            ..
        } = self
        else {
            return None;
        };
        let text = name
            .strip_prefix(prefix.as_str())?
            .strip_suffix(suffix.as_str())?;
        let size = text.strip_prefix('-').unwrap_or(text);
        let is_negative = size.len() < text.len();
        let plain = size.bytes().all(|b| b.is_ascii_digit());
        let padded = size.len() == *digits
            || (is_negative && text.len() == *digits)
            || (size.len() > *digits && !size.starts_with('0'));
        let number = (plain && padded).then(|| text.parse().ok())?;
        number.filter(|number| *number != 0 || !is_negative)
    }

    /// Warns where the numbers of all frames that are there are negative: the sign may be meant as a part of the name.
    ///
    /// # Errors
    /// They are, and `notes` is strict.
    pub fn check_signs(&self, numbers: &[i32], notes: &mut Notes) -> Result<()> {
        match (self, numbers) {
            (
                Self::Sequence {
                    prefix,
                    digits,
                    suffix,
                    ..
                },
                [first, .., last],
            ) if *last < 0 => {
                let guess = format!("all of its frames are negative, {first} to {last}");
                let name = format!(
                    "{}-{}{}",
                    escape(prefix),
                    "#".repeat(*digits),
                    escape(suffix)
                );
                let fix = format!(
                    "where the - belongs to the name, write {name}; else name the frames, as render.frames = \"{first}-{last}\""
                );
                notes.guess(&self.path(*first), &guess, &fix)
            }
            _ => Ok(()),
        }
    }

    /// Whether a file is one of them, or would be if it were there.
    pub fn holds(&self, file: &Path) -> bool {
        let Self::Sequence { .. } = self else {
            return false;
        };
        let name = file.file_name().unwrap_or_default().to_string_lossy();
        let folder = match file.parent() {
            Some(folder) if !folder.as_os_str().is_empty() => folder,
            _ => Path::new("."),
        };
        let is_here = || Some(folder.canonicalize().ok()? == self.folder().canonicalize().ok()?);
        self.number(&name).is_some() && is_here() == Some(true)
    }

    /// The folder that they are in.
    pub fn folder(&self) -> &Path {
        let dir = match self {
            Self::Still(file) => file.parent().unwrap_or(Path::new("")),
            Self::Sequence { dir, .. } => dir,
        };
        if dir.as_os_str().is_empty() {
            Path::new(".")
        } else {
            dir
        }
    }

    /// Their name, with `#` for the digits of the number.
    pub fn pattern(&self) -> String {
        match self {
            Self::Still(file) => file.display().to_string(),
            Self::Sequence {
                prefix,
                digits,
                suffix,
                ..
            } => format!(
                "{}{}{}",
                escape(prefix),
                "#".repeat(*digits),
                escape(suffix)
            ),
        }
    }

    /// Sees that all of these frames exist; there is at least one.
    ///
    /// # Errors
    /// The first one that does not.
    pub fn require(&self, frames: &[i32]) -> Result<()> {
        for &frame in frames {
            let path = self.path(frame);
            if path.is_file() {
                if self.is_still() {
                    break;
                }
                continue;
            }
            if self.is_still() {
                return Err(Error::reading(&path, &std::io::ErrorKind::NotFound.into()));
            }
            return Err(self.missing(frame, frames));
        }
        Ok(())
    }

    fn missing(&self, frame: i32, frames: &[i32]) -> Error {
        let (first, last) = (frames[0], frames[frames.len() - 1]);
        let error = Error::input(
            &self.path(frame),
            format!("frame {frame} of {first}-{last} is missing"),
        );
        match self.existing() {
            Err(none) => none,
            Ok(there) => {
                let (a, b) = (there[0], there[there.len() - 1]);
                error.fix(format!(
                    "supply it, or choose other frames with --frames (found are {} between {a} and {b})",
                    there.len()
                ))
            }
        }
    }

    /// Says which frames are missing between those of `numbers`, and what comes of it.
    pub fn note_gaps(&self, numbers: &[i32], consequence: &str, notes: &mut Notes) {
        for pair in numbers.windows(2) {
            let which = match i64::from(pair[1]) - i64::from(pair[0]) {
                ..2 => continue,
                2 => format!("frame {} is", pair[0] + 1),
                _ => format!("frames {} to {} are", pair[0] + 1, pair[1] - 1),
            };
            notes.warn(
                &self.path(pair[0] + 1),
                format!("{which} missing: {consequence}"),
            );
        }
    }
}

/// How to name the frames that are in `folder`, which the user calls `called`.
fn folder_fix(folder: &Path, called: &Path, extension: Option<&OsStr>) -> String {
    let folder = match folder.as_os_str().is_empty() {
        true => Path::new("."),
        false => folder,
    };
    let there = example(folder, extension).map_or("light.####.exr".to_owned(), |e| e.name);
    let name = called.join(there);
    format!(
        "write #### for the digits of the frame's number, as {}",
        name.display()
    )
}

/// Checks that a frame has the size of the first.
///
/// # Errors
/// It has another size.
pub fn check_size(file: &Path, size: UVec2, wanted: UVec2, first: &Path) -> Result<()> {
    if size == wanted {
        return Ok(());
    }
    let what = format!(
        "it is {} × {}, but {} is {} × {}",
        size.x,
        size.y,
        first.display(),
        wanted.x,
        wanted.y
    );
    Err(Error::input(file, what).fix("all frames of a sequence must have one size: resize it"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_padded() {
        let files = FrameFiles::new(Path::new("shots"), "in/l.####.exr").unwrap();
        assert_eq!(files.path(7), Path::new("shots/in/l.0007.exr"));
        assert_eq!(files.path(12345), Path::new("shots/in/l.12345.exr"));
        assert!(FrameFiles::new(Path::new(""), "a##b##.exr").is_err());
        let still = FrameFiles::new(Path::new("s"), "l.exr").unwrap();
        assert_eq!(still.path(9), Path::new("s/l.exr"));
    }
}
