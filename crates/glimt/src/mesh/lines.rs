//! Host file: the lines of OBJ, MTL and STL files: any line ending, continued lines, any encoding of one byte a character.

use crate::error::{Error, Result};
use memchr::{memchr, memchr2};
use std::borrow::Cow;
use std::path::Path;

/// Yields lines that say something, with the number of their first: trimmed, continuations joined, without comments.
pub struct Lines<'a> {
    rest: &'a [u8],
    end: u8,
    number: usize,
}

impl<'a> Lines<'a> {
    /// The lines of a file's bytes. A byte order mark is skipped.
    ///
    /// # Errors
    /// The file is UTF-16.
    pub fn new(file: &Path, bytes: &'a [u8]) -> Result<Self> {
        if bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]) {
            return Err(Error::input(file, "it is written in UTF-16").fix("save it as UTF-8"));
        }
        let rest = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        // Old files of one system end lines with CR alone.
        let end = match memchr2(b'\n', b'\r', rest).map(|i| &rest[i..]) {
            Some([b'\r', second, ..]) if *second != b'\n' => b'\r',
            _ => b'\n',
        };
        let number = 0;
        Ok(Self { rest, end, number })
    }

    fn line(&mut self) -> Option<&'a [u8]> {
        if self.rest.is_empty() {
            return None;
        }
        self.number += 1;
        let (line, rest) = match memchr(self.end, self.rest) {
            Some(at) => (&self.rest[..at], &self.rest[at + 1..]),
            None => (self.rest, &[][..]),
        };
        self.rest = rest;
        Some(line.trim_ascii())
    }
}

impl<'a> Iterator for Lines<'a> {
    type Item = (usize, Cow<'a, [u8]>);

    fn next(&mut self) -> Option<Self::Item> {
        loop {
            let line = self.line()?;
            if line.is_empty() || line[0] == b'#' {
                continue;
            }
            let number = self.number;
            let Some(first) = line.strip_suffix(b"\\") else {
                return Some((number, Cow::Borrowed(line)));
            };
            let mut joined = first.to_vec();
            while let Some(more) = self.line() {
                joined.push(b' ');
                match more.strip_suffix(b"\\") {
                    Some(more) => joined.extend_from_slice(more),
                    None => {
                        joined.extend_from_slice(more);
                        break;
                    }
                }
            }
            return Some((number, Cow::Owned(joined)));
        }
    }
}

/// The first word of a line, and what follows it.
pub fn split_word(line: &[u8]) -> (&[u8], &[u8]) {
    let line = line.trim_ascii_start();
    let end = line.iter().position(u8::is_ascii_whitespace);
    let (word, rest) = line.split_at(end.unwrap_or(line.len()));
    (word, rest.trim_ascii())
}

/// A line's words. A word that begins with `#` begins a comment.
pub fn words(mut line: &[u8]) -> impl Iterator<Item = &[u8]> {
    std::iter::from_fn(move || {
        let (word, rest) = split_word(line);
        line = rest;
        (!word.is_empty() && word[0] != b'#').then_some(word)
    })
}

/// Bytes as text: UTF-8, or else Latin-1.
pub fn text(bytes: &[u8]) -> String {
    match std::str::from_utf8(bytes) {
        Ok(text) => text.to_owned(),
        Err(_) => bytes.iter().map(|b| char::from(*b)).collect(),
    }
}

/// A number in a word.
pub fn number(word: &[u8]) -> Option<f64> {
    std::str::from_utf8(word).ok()?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn all(bytes: &[u8]) -> Vec<(usize, String)> {
        let lines = Lines::new(Path::new("a.obj"), bytes).unwrap();
        lines.map(|(number, line)| (number, text(&line))).collect()
    }

    #[test]
    fn line_endings_comments_and_continuations() {
        let expected = [
            (1, "v 1".to_owned()),
            (3, "f 1 2  3".to_owned()),
            (6, "g".to_owned()),
        ];
        let unix = "\u{feff}v 1\n# f 9\nf 1 \\\n 2 \\\n 3\n  g";
        for end in ["\n", "\r\n", "\r"] {
            let found = all(unix.replace('\n', end).as_bytes());
            let spaced: Vec<_> = found
                .iter()
                .map(|(n, l)| (*n, l.replace("  ", " ")))
                .collect();
            assert_eq!(
                spaced,
                expected.clone().map(|(n, l)| (n, l.replace("  ", " "))),
                "{end:?}"
            );
        }
        assert!(Lines::new(Path::new("a"), b"\xff\xfev\0").is_err());
        assert!(all(b"").is_empty());
        assert_eq!(all(b"f 1 \\"), [(1, "f 1 ".to_owned())]);
    }

    #[test]
    fn words_and_numbers() {
        let list: Vec<&[u8]> = words(b" a\tbc  d # e").collect();
        assert_eq!(list, [&b"a"[..], b"bc", b"d"]);
        assert_eq!(text(b"\xfcber"), "über");
        assert_eq!(text("über".as_bytes()), "über");
        assert_eq!(number(b"-1.5e3"), Some(-1500.0));
        assert_eq!(number(b"zero"), None);
    }
}
