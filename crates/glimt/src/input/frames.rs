//! Host file: the files of a sequence, `light.####.exr`, or of a still.

use crate::error::{Error, Result};
use crate::notes::Notes;
use glam::UVec2;
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
    /// Reads a path in whose file name `#`s stand for the digits of the frame's number. A relative path is relative to
    /// `base`.
    ///
    /// # Errors
    /// The name holds two numbers.
    pub fn new(base: &Path, pattern: &str) -> Result<Self> {
        let path = base.join(pattern);
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let Some(first) = name.find('#') else {
            return Ok(Self::Still(path));
        };
        let digits = name[first..].chars().take_while(|c| *c == '#').count();
        let suffix = name[first + digits..].to_owned();
        if suffix.contains('#') {
            return Err(
                Error::usage(format!("`{pattern}` has a place for two numbers"))
                    .fix("keep one run of #, as light.####.exr"),
            );
        }
        Ok(Self::Sequence {
            dir: path.parent().map(Path::to_owned).unwrap_or_default(),
            prefix: name[..first].to_owned(),
            digits,
            suffix,
        })
    }

    /// The file of a frame.
    pub fn path(&self, frame: u32) -> PathBuf {
        match self {
            Self::Still(path) => path.clone(),
            Self::Sequence {
                dir,
                prefix,
                digits,
                suffix,
            } => dir.join(format!("{prefix}{frame:0digits$}{suffix}")),
        }
    }

    /// Whether every frame is the same file.
    pub fn is_still(&self) -> bool {
        matches!(self, Self::Still(_))
    }

    /// The numbers of the frames that are there, in order; frame 1 of a still.
    ///
    /// # Errors
    /// The folder cannot be read, or holds no frame.
    pub fn existing(&self) -> Result<Vec<u32>> {
        let frames = self
            .listed()
            .map_err(|e| Error::reading(self.folder(), &e))?;
        if frames.is_empty() {
            let what = format!("no file is named {}", self.pattern());
            return Err(Error::input(self.folder(), what)
                .fix("check probe.frames: each # stands for a digit of the frame's number"));
        }
        Ok(frames)
    }

    /// The numbers of the frames that are there, in order, maybe none; frame 1 of a still.
    ///
    /// # Errors
    /// The folder cannot be read.
    pub fn listed(&self) -> std::io::Result<Vec<u32>> {
        if self.is_still() {
            return Ok(vec![1]);
        }
        let mut frames: Vec<u32> = std::fs::read_dir(self.folder())?
            .flatten()
            .filter_map(|entry| self.number(&entry.file_name().to_string_lossy()))
            .collect();
        frames.sort_unstable();
        Ok(frames)
    }

    /// The number in the name of a frame of a sequence.
    fn number(&self, name: &str) -> Option<u32> {
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
        let plain = text.bytes().all(|b| b.is_ascii_digit());
        let padded = text.len() == *digits || (text.len() > *digits && !text.starts_with('0'));
        (plain && padded).then(|| text.parse().ok())?
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
            } => format!("{prefix}{}{suffix}", "#".repeat(*digits)),
        }
    }

    /// The frames from `first` to `last`, all of which must exist.
    ///
    /// # Errors
    /// The first one that does not.
    pub fn require(&self, first: u32, last: u32) -> Result<Vec<u32>> {
        for frame in first..=last {
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
            return Err(self.missing(frame, first, last));
        }
        Ok((first..=last).collect())
    }

    fn missing(&self, frame: u32, first: u32, last: u32) -> Error {
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
    pub fn note_gaps(&self, numbers: &[u32], consequence: &str, notes: &mut Notes) {
        for pair in numbers.windows(2) {
            let which = match pair[1] - pair[0] {
                0 | 1 => continue,
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
