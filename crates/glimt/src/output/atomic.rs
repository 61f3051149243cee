//! Host file: files that appear under their name when they are whole.

use crate::error::{Error, Result};
use std::ffi::OsString;
use std::fs::{self, File};
use std::io::{self, BufWriter, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

/// A file that is being written beside its final name. Dropped before [`Pending::commit`], it is removed; killed, it
/// leaves a hidden `.part` file that the next run clears away.
#[derive(Debug)]
pub struct Pending {
    target: PathBuf,
    part: PathBuf,
    writer: Option<BufWriter<File>>,
}

impl Pending {
    /// Begins to write `target`.
    ///
    /// # Errors
    /// The folder cannot be written to.
    pub fn create(target: &Path) -> Result<Self> {
        remove_stale(target);
        let part = part_name(target, std::process::id());
        let file = File::create(&part).map_err(|e| Error::writing(target, &e))?;
        Ok(Self {
            target: target.to_owned(),
            part,
            writer: Some(BufWriter::with_capacity(1 << 18, file)),
        })
    }

    /// The final name.
    pub fn target(&self) -> &Path {
        &self.target
    }

    /// The name while it is being written, for programs that write it themselves.
    pub fn part(&self) -> &Path {
        &self.part
    }

    /// Turns an error of writing into ours.
    pub fn error(&self, error: &io::Error) -> Error {
        Error::writing(&self.target, error)
    }

    /// Gives the file its name.
    ///
    /// # Errors
    /// The last bytes cannot be written (a full disk), or the name cannot be taken.
    pub fn commit(&mut self) -> Result<()> {
        let finish = |writer: Option<BufWriter<File>>| -> io::Result<()> {
            if let Some(writer) = writer {
                let file = writer
                    .into_inner()
                    .map_err(io::IntoInnerError::into_error)?;
                file.sync_all()?;
            }
            fs::rename(&self.part, &self.target)
        };
        finish(self.writer.take()).map_err(|e| Error::writing(&self.target, &e))
    }
}

impl Drop for Pending {
    fn drop(&mut self) {
        // After a commit the name is gone, and this finds nothing.
        drop(self.writer.take());
        let _ = fs::remove_file(&self.part);
    }
}

impl Write for Pending {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.inner()?.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.inner()?.flush()
    }
}

impl Seek for Pending {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        self.inner()?.seek(to)
    }
}

impl Pending {
    fn inner(&mut self) -> io::Result<&mut BufWriter<File>> {
        self.writer
            .as_mut()
            .ok_or_else(|| io::Error::other("the file is finished"))
    }
}

/// `.name.PID.part` in the same folder, so that it can be renamed and two programs do not share it.
fn part_name(target: &Path, process: u32) -> PathBuf {
    let mut name = OsString::from(".");
    name.push(target.file_name().unwrap_or_default());
    name.push(format!(".{process}.part"));
    target.with_file_name(name)
}

/// Removes what killed runs left of this file. Where it cannot be told whether the other run is alive, all stay.
fn remove_stale(target: &Path) {
    let Some(folder) = target.parent() else {
        return;
    };
    let start = format!(
        ".{}.",
        target.file_name().unwrap_or_default().to_string_lossy()
    );
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let name = entry.file_name();
        let process = name
            .to_str()
            .and_then(|n| n.strip_prefix(&start)?.strip_suffix(".part"))
            .and_then(|n| n.parse::<u32>().ok());
        if process.is_some_and(is_gone) {
            let _ = fs::remove_file(entry.path());
        }
    }
}

fn is_gone(process: u32) -> bool {
    let processes = Path::new("/proc");
    processes.join("self").exists() && !processes.join(process.to_string()).exists()
}

/// Whether two paths lead to one file that is there.
#[must_use]
pub fn is_same_file(a: &Path, b: &Path) -> bool {
    b.canonicalize()
        .is_ok_and(|b| a.canonicalize().is_ok_and(|a| a == b))
}

/// Makes a folder, and sees that it can be written to.
///
/// # Errors
/// It cannot be made or written to.
pub fn prepare_folder(folder: &Path) -> Result<()> {
    fs::create_dir_all(folder).map_err(|e| Error::writing(folder, &e))?;
    let probe = part_name(&folder.join("glimt"), std::process::id());
    File::create(&probe).map_err(|e| Error::writing(folder, &e))?;
    let _ = fs::remove_file(probe);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_name_is_taken_at_the_end_only() {
        let folder = std::env::temp_dir().join(format!("glimt-atomic-{}", std::process::id()));
        prepare_folder(&folder).unwrap();
        let target = folder.join("a.bin");
        let stale = part_name(&target, u32::MAX);
        fs::write(&stale, b"old").unwrap();

        let mut pending = Pending::create(&target).unwrap();
        pending.write_all(b"new").unwrap();
        assert!(!target.exists() && !stale.exists());
        drop(pending);
        assert_eq!(fs::read_dir(&folder).unwrap().count(), 0);

        let mut pending = Pending::create(&target).unwrap();
        pending.write_all(b"new").unwrap();
        pending.commit().unwrap();
        assert_eq!(fs::read(&target).unwrap(), b"new");
        assert_eq!(fs::read_dir(&folder).unwrap().count(), 1);
        fs::remove_dir_all(&folder).unwrap();
    }
}
