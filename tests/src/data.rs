//! Host file: photographs and models that are not part of the project: used where they are, and skipped visibly elsewhere.

use std::io::Write;
use std::path::PathBuf;

/// Where a file of the data beside the workspace would be.
#[must_use]
pub fn data(path: &str) -> PathBuf {
    glimt_generate::root().join("../shared/data").join(path)
}

/// The file, or `None` after a line on standard error where it is not.
#[must_use]
pub fn data_or_skip(test: &str, path: &str) -> Option<PathBuf> {
    let full = data(path);
    if full.exists() {
        return Some(full);
    }
    skipped(test, &format!("no {}", full.display()));
    None
}

/// Says that a test is skipped, to the handle, since the test runner swallows what `eprintln!` writes.
pub fn skipped(test: &str, why: &str) {
    writeln!(std::io::stderr(), "SKIPPED {test}: {why}").expect("standard error");
}
