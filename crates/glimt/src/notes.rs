//! Host file: what is worth saying about inputs that are accepted all the same.

use crate::error::{Error, Result};
use std::path::{Path, PathBuf};

/// How much a note matters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Severity {
    /// Something was done in the user's place; the result is as it should be.
    Note,
    /// Something is wrong with the input and was worked around.
    Warning,
}

/// One remark about one file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Note {
    /// How much it matters.
    pub severity: Severity,
    /// The file it concerns.
    pub file: PathBuf,
    /// The remark, in one line.
    pub text: String,
}

/// Collects remarks while files are read, and decides whether a defect is one or an error.
#[derive(Clone, Debug, Default)]
pub struct Notes {
    /// Whether defects are refused (`--strict`).
    pub strict: bool,
    list: Vec<Note>,
    taken: Vec<Note>,
}

impl Notes {
    /// No remarks yet; with `strict`, defects are errors.
    pub fn new(strict: bool) -> Self {
        Self {
            strict,
            ..Self::default()
        }
    }

    /// Remarks on something that is as good as what was meant.
    pub fn note(&mut self, file: &Path, text: impl Into<String>) {
        self.push(Severity::Note, file, text.into());
    }

    /// Remarks on something that the result will lack.
    pub fn warn(&mut self, file: &Path, text: impl Into<String>) {
        self.push(Severity::Warning, file, text.into());
    }

    /// A defect of an input: a warning that says how it is worked around, or with `strict` an error.
    ///
    /// # Errors
    /// The defect, when `strict` is set.
    pub fn defect(&mut self, file: &Path, defect: &str, workaround: &str) -> Result<()> {
        if self.strict {
            return Err(Error::input(file, defect)
                .fix("mend the file, or leave out --strict to work around it"));
        }
        self.warn(file, format!("{defect}; {workaround}"));
        Ok(())
    }

    /// Something that was guessed, where another guess would look otherwise: a warning that says how to settle it, or with `strict`
    /// an error.
    ///
    /// # Errors
    /// The guess, when `strict` is set.
    pub fn guess(&mut self, file: &Path, guess: &str, fix: &str) -> Result<()> {
        if self.strict {
            return Err(Error::input(file, guess).fix(fix));
        }
        self.warn(file, format!("{guess}; {fix}"));
        Ok(())
    }

    /// How many remarks wait to be taken.
    pub fn waiting(&self) -> usize {
        self.list.len()
    }

    /// With `strict`, makes the first warning after so many remarks that wait an error.
    ///
    /// # Errors
    /// That warning.
    pub fn refuse_after(&self, count: usize) -> Result<()> {
        let mut new = self.list.iter().skip(count);
        match new.find(|note| note.severity == Severity::Warning) {
            Some(note) if self.strict => Err(Error::input(&note.file, &note.text)
                .fix("mend the file, or leave out --strict to take it so")),
            _ => Ok(()),
        }
    }

    /// Takes the remarks made since the last time. One that was taken before does not come again.
    pub fn take(&mut self) -> Vec<Note> {
        self.taken.extend_from_slice(&self.list);
        std::mem::take(&mut self.list)
    }

    fn push(&mut self, severity: Severity, file: &Path, text: String) {
        let note = Note {
            severity,
            file: file.to_owned(),
            text,
        };
        if !self.list.contains(&note) && !self.taken.contains(&note) {
            self.list.push(note);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn warnings_are_refused_where_they_are_asked_for() {
        for strict in [false, true] {
            let mut notes = Notes::new(strict);
            notes.warn(Path::new("light.exr"), "it is black");
            let before = notes.waiting();
            notes.note(Path::new("m.obj"), "its normals are made");
            assert!(notes.refuse_after(before).is_ok());
            notes.warn(Path::new("m.obj"), "its picture is missing");
            assert_eq!(notes.refuse_after(before).is_err(), strict);
        }
    }
}
