//! Host file: where transfer is written to: over an older one, or where nothing is, and nowhere else.

use super::stored::is_transfer;
use crate::error::{Error, Result};
use crate::output::atomic::is_same_file;
use crate::shot::Shot;
use crate::shot::parse::Source;
use std::fs;
use std::path::Path;

/// Sees that what stands at `out` may be replaced: nothing, an empty file, or transfer, even half of it; but not what the shot
/// is read from.
///
/// # Errors
/// It is a folder, another kind of file, or one of the shot's.
pub(super) fn refuse_other(out: &Path, shot: &Shot, source: &Source) -> Result<()> {
    let Ok(there) = fs::metadata(out) else {
        return Ok(());
    };
    let refused = |what: &str| {
        let error = Error::usage(what).file(out);
        Err(error.fix("name another file with --out or render.prt.bake"))
    };
    if there.is_dir() {
        return refused("this is a folder, and transfer is one file");
    }
    if !there.is_file() {
        return refused("this is not a file that can be replaced");
    }
    let base = source.folder();
    if is_same_file(&source.file, out) {
        return refused("this is the shot itself");
    }
    let mut objects = shot.objects.iter().enumerate();
    if let Some((i, _)) = objects.find(|(_, object)| is_same_file(&base.join(&object.mesh), out)) {
        return refused(&format!("this is the mesh of object.{i}"));
    }
    match there.len() == 0 || is_transfer(out)? {
        true => Ok(()),
        false => {
            let error = Error::usage("this is there already, and it is not a file of transfer");
            Err(error
                .file(out)
                .fix("remove it, or name another file with --out or render.prt.bake"))
        }
    }
}
