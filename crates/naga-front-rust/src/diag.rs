//! Errors that look like rustc's: file, line, column, the source line, a caret, and a fix.

use std::fmt;

/// A place in one of the program's files. Lines count from 1, columns from 0.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Span {
    pub(crate) file: usize,
    pub(crate) line: usize,
    pub(crate) column: usize,
    /// Length of the underlined part, within the first line.
    pub(crate) width: usize,
}

impl Span {
    pub(crate) fn of(file: usize, tokens: &impl syn::spanned::Spanned) -> Span {
        let span = tokens.span();
        let (start, end) = (span.start(), span.end());
        let width = if end.line == start.line {
            end.column.saturating_sub(start.column)
        } else {
            usize::MAX
        };
        Span {
            file,
            line: start.line,
            column: start.column,
            width: width.max(1),
        }
    }
}

/// An error inside the front end, before the files' texts are available.
#[derive(Debug)]
pub(crate) struct Error {
    pub(crate) message: String,
    pub(crate) span: Option<Span>,
    pub(crate) help: Option<String>,
    pub(crate) notes: Vec<String>,
}

pub(crate) type R<T> = Result<T, Box<Error>>;

/// An error at `span` with the fix in `help`.
pub(crate) fn err(span: Span, message: impl Into<String>, help: impl Into<String>) -> Box<Error> {
    Box::new(Error {
        message: message.into(),
        span: Some(span),
        help: Some(help.into()),
        notes: Vec::new(),
    })
}

/// Why a program could not be lowered. Its `Display` is laid out like rustc's.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// What is wrong, in one line.
    pub message: String,
    /// Where, if the error has a place in a source file.
    pub location: Option<Box<Location>>,
    /// What to do about it.
    pub help: Option<String>,
    /// Further facts, such as the offsets of a struct's fields.
    pub notes: Vec<String>,
}

/// A place in a source file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Location {
    /// `crate_name/src/path.rs`.
    pub file: String,
    /// Line, from 1.
    pub line: usize,
    /// Column, from 1.
    pub column: usize,
    /// The whole source line.
    pub source_line: String,
    /// How many characters to underline.
    pub width: usize,
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "error: {}", self.message)?;
        let mut indent = String::new();
        if let Some(at) = &self.location {
            indent = " ".repeat(at.line.to_string().len());
            writeln!(f)?;
            writeln!(f, "{indent}--> {}:{}:{}", at.file, at.line, at.column)?;
            writeln!(f, "{indent} |")?;
            writeln!(f, "{} | {}", at.line, at.source_line)?;
            let pad = " ".repeat(at.column - 1);
            write!(f, "{indent} | {pad}{}", "^".repeat(at.width))?;
        }
        for note in &self.notes {
            write!(f, "\n{indent} = note: {note}")?;
        }
        if let Some(help) = &self.help {
            write!(f, "\n{indent} = help: {help}")?;
        }
        Ok(())
    }
}

impl std::error::Error for Diagnostic {}
