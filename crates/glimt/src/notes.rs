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
