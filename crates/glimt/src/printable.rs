//! Host file: text and paths that a terminal can show.

use std::path::Path;

/// Text without what moves a terminal's cursor or changes its colours: names of files and of what is in them may hold anything.
/// Line breaks stay.
#[must_use]
pub fn printable(text: &str) -> String {
    let keep = |c: &char| !c.is_control() || *c == '\n';
    if text.chars().all(|c| keep(&c)) {
        return text.to_owned();
    }
    let mut plain = String::with_capacity(text.len());
    for c in text.chars() {
        match keep(&c) {
            true => plain.push(c),
            false => plain.extend(c.escape_debug()),
        }
    }
    plain
}

/// The same on one line.
#[must_use]
pub fn in_line(text: &str) -> String {
    printable(text).replace('\n', "\\n")
}

/// A path for people.
#[must_use]
pub fn path_in_line(path: &Path) -> String {
    in_line(&path.display().to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn control_characters_are_spelled_out() {
        assert_eq!(printable("plain, grün\n"), "plain, grün\n");
        assert_eq!(printable("\u{1b}[2J\r\u{9b}"), "\\u{1b}[2J\\r\\u{9b}");
        assert_eq!(path_in_line(Path::new("a\nb\tc")), "a\\nb\\tc");
    }
}
