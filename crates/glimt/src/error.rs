//! Host file: errors that name a file, a place and a fix, and the exit status that each kind gives.

use crate::printable::path_in_line;
use std::fmt;
use std::path::{Path, PathBuf};

/// What kind of thing went wrong. Its number is the program's exit status.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Kind {
    /// A fault of the program itself.
    Internal = 1,
    /// The command line or a shot file.
    Usage = 2,
    /// A file that is read: missing, broken, or not of a kind that is understood.
    Input = 3,
    /// A file that is written: folder, disk, permissions.
    Output = 4,
    /// The device that renders.
    Device = 5,
    /// SIGINT.
    Interrupted = 130,
    /// SIGTERM.
    Terminated = 143,
}

impl Kind {
    /// The program's exit status.
    #[must_use]
    pub fn status(self) -> i32 {
        i32::from(self as u8)
    }
}

/// Where in a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Place {
    /// Line and column, both from 1.
    LineColumn(usize, usize),
    /// In words: a row, a key, a triangle.
    Named(String),
}

/// An error of the program: one line that says in which file, where in it, what is wrong, and what to do.
#[derive(Clone, Debug, thiserror::Error)]
#[error("{}", Line(self))]
pub struct Error {
    /// What kind of thing went wrong.
    pub kind: Kind,
    /// The file it concerns.
    pub file: Option<PathBuf>,
    /// Where in that file.
    pub place: Option<Place>,
    /// What is wrong.
    pub what: String,
    /// What to do about it.
    pub fix: Option<String>,
}

/// The result of everything here that can fail.
pub type Result<T> = std::result::Result<T, Error>;

impl Error {
    /// An error of the given kind that concerns no file.
    pub fn new(kind: Kind, what: impl fmt::Display) -> Self {
        Self {
            kind,
            file: None,
            place: None,
            what: one_line(&what.to_string()),
            fix: None,
        }
    }

    /// An error of the command line or of a shot.
    pub fn usage(what: impl fmt::Display) -> Self {
        Self::new(Kind::Usage, what)
    }

    /// A file that cannot be read as what it should be.
    pub fn input(file: &Path, what: impl fmt::Display) -> Self {
        Self::new(Kind::Input, what).file(file)
    }

    /// A file that cannot be written.
    pub fn output(file: &Path, what: impl fmt::Display) -> Self {
        Self::new(Kind::Output, what).file(file)
    }

    /// A device that cannot render.
    pub fn device(what: impl fmt::Display) -> Self {
        Self::new(Kind::Device, what)
    }

    /// Reading `file` failed with an error of the operating system.
    pub fn reading(file: &Path, error: &std::io::Error) -> Self {
        use std::io::ErrorKind as E;
        match error.kind() {
            E::NotFound => Self::input(file, "there is no such file").fix("check the path"),
            E::PermissionDenied => {
                Self::input(file, "it may not be read").fix("change its permissions")
            }
            E::OutOfMemory => Self::device("there is not enough memory to read it")
                .file(file)
                .fix("free some, or raise its limit"),
            E::UnexpectedEof => Self::input(file, "the file ends too early")
                .fix("it is probably truncated: copy or export it again"),
            _ => Self::input(file, format!("it cannot be read: {error}")),
        }
    }

    /// Writing `file` failed with an error of the operating system.
    pub fn writing(file: &Path, error: &std::io::Error) -> Self {
        use std::io::ErrorKind as E;
        match error.kind() {
            E::StorageFull | E::QuotaExceeded => Self::output(file, "the disk is full")
                .fix("free some space, or choose another folder with --out"),
            E::PermissionDenied | E::ReadOnlyFilesystem => {
                Self::output(file, "writing is not permitted")
                    .fix("change the folder's permissions, or choose another with --out")
            }
            E::NotADirectory | E::AlreadyExists => {
                Self::output(file, "a part of this path is a file, not a folder")
                    .fix("remove it, or choose another folder with --out")
            }
            _ => Self::output(file, format!("it cannot be written: {error}"))
                .fix("check the folder, or choose another with --out"),
        }
    }

    /// Names the file that the error concerns.
    pub fn file(mut self, file: &Path) -> Self {
        self.file = Some(file.to_owned());
        self
    }

    /// Names a place in the file in words.
    pub fn at(mut self, place: impl fmt::Display) -> Self {
        self.place = Some(Place::Named(place.to_string()));
        self
    }

    /// Names a place in the file by line and column.
    pub fn at_line(mut self, line: usize, column: usize) -> Self {
        self.place = Some(Place::LineColumn(line, column));
        self
    }

    /// Says which names there are in place of one that is unknown, and which of them was probably meant.
    pub fn fix_name(self, unknown: &str, known: &[&str]) -> Self {
        let all = match known {
            [] => return self.fix("it has none"),
            _ => known.join(", "),
        };
        match nearest(unknown, known.iter().copied()) {
            Some(near) => self.fix(format!("did you mean `{near}`? There are: {all}")),
            None => self.fix(format!("there are: {all}")),
        }
    }

    /// Says what to do.
    pub fn fix(mut self, fix: impl fmt::Display) -> Self {
        self.fix = Some(one_line(&fix.to_string()));
        self
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::LineColumn(line, column) => write!(f, "{line}:{column}"),
            Self::Named(name) => f.write_str(name),
        }
    }
}

/// Prints an error on one line: `FILE:LINE:COLUMN: what; fix`.
struct Line<'a>(&'a Error);

impl fmt::Display for Line<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let error = self.0;
        if let Some(file) = &error.file {
            write!(f, "{}:", path_in_line(file))?;
            if !matches!(error.place, Some(Place::LineColumn(..))) {
                f.write_str(" ")?;
            }
        }
        if let Some(place) = &error.place {
            write!(f, "{place}: ")?;
        }
        f.write_str(&error.what)?;
        match &error.fix {
            Some(fix) => write!(f, "; {fix}"),
            None => Ok(()),
        }
    }
}

/// Messages of libraries may span lines; ours do not.
fn one_line(text: &str) -> String {
    let words: Vec<&str> = text.split_whitespace().collect();
    words.join(" ").trim_end_matches('.').to_owned()
}

/// The known word nearest to `word`, if it is near enough to be what was meant.
pub fn nearest<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    known
        .into_iter()
        .map(|candidate| (strsim::jaro_winkler(word, candidate), candidate))
        .filter(|(likeness, _)| *likeness >= 0.7)
        .max_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, candidate)| candidate)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_error_is_one_line() {
        let error = Error::input(Path::new("a.exr"), "broken\n  badly.")
            .at("row 3")
            .fix("mend it");
        assert_eq!(error.to_string(), "a.exr: row 3: broken badly; mend it");
        let error = Error::usage("no").file(Path::new("s.toml")).at_line(3, 5);
        assert_eq!(error.to_string(), "s.toml:3:5: no");
    }

    #[test]
    fn nearest_word() {
        let keys = ["size", "rays_per_pixel", "filter"];
        assert_eq!(nearest("rays_per_pixels", keys), Some("rays_per_pixel"));
        assert_eq!(nearest("siez", keys), Some("size"));
        assert_eq!(nearest("qqq", keys), None);
    }
}
