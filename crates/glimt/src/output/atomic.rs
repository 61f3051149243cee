//! Host file: files that appear under their name when they are whole.

use super::target::Target;
use crate::error::{Error, Result};
use std::collections::BTreeSet;
use std::ffi::{OsStr, OsString};
use std::fs::{self, File};
use std::hash::{BuildHasher, RandomState};
use std::io::{self, BufWriter, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Duration;

/// A file that is being written beside its final name. Dropped before [`Pending::commit`], it is removed; killed, it
/// leaves a hidden `.part` file that the next run into this folder clears away.
#[derive(Debug)]
pub struct Pending {
    target: PathBuf,
    part: PathBuf,
    writer: Option<BufWriter<File>>,
    /// Whether it may be longer than what is written.
    reserved: bool,
}

impl Pending {
    /// Begins to write `target`.
    ///
    /// # Errors
    /// The folder cannot be written to.
    pub fn create(target: &Target) -> Result<Self> {
        let target = target.path();
        // Under this lock no end of the program comes between the file and its entry.
        let mut unfinished = unfinished();
        let (part, file) = create_part(target).map_err(|e| Error::writing(target, &e))?;
        unfinished.insert(part.clone());
        Ok(Self {
            target: target.to_owned(),
            part,
            writer: Some(BufWriter::with_capacity(1 << 18, file)),
            reserved: false,
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

    /// Takes room for `bytes` bytes on the disk, from the file's beginning. Zeros are written: a length alone takes none. What is not
    /// written in the end is cut off.
    ///
    /// # Errors
    /// The disk is full.
    pub fn reserve(&mut self, bytes: u64) -> Result<()> {
        self.reserved = true;
        let mut take = || {
            io::copy(&mut io::repeat(0).take(bytes), self)?;
            self.flush()?;
            self.rewind()
        };
        take().map_err(|e| self.error(&e))
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
                let mut file = writer
                    .into_inner()
                    .map_err(io::IntoInnerError::into_error)?;
                if self.reserved {
                    let length = file.stream_position()?;
                    file.set_len(length)?;
                }
                file.sync_all()?;
            }
            // Under this lock it is not removed for an end in between.
            let _unfinished = unfinished();
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
        unfinished().remove(&self.part);
    }
}

/// What is removed if the program ends early: parts, and the files by which folders are locked.
static UNFINISHED: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

fn unfinished() -> MutexGuard<'static, BTreeSet<PathBuf>> {
    UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Removes all that is not finished, for the program's end. Nothing can be begun or finished after that: who tries waits for ever.
pub fn remove_unfinished() {
    let unfinished = unfinished();
    for file in unfinished.iter() {
        let _ = fs::remove_file(file);
    }
    std::mem::forget(unfinished);
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

/// A new file beside `target`, `.name.RANDOM.part`, so that it can be renamed and no two programs share it. Nothing that has the
/// name already is opened, neither a link nor a pipe. It is locked while it is open, which tells others that it is in use.
fn create_part(target: &Path) -> io::Result<(PathBuf, File)> {
    loop {
        let random = RandomState::new().hash_one(0);
        let mut name = OsString::from(".");
        name.push(target.file_name().unwrap_or_default());
        name.push(format!(".{random:016x}.part"));
        let part = target.with_file_name(name);
        match File::options().write(true).create_new(true).open(&part) {
            Ok(file) => match file.try_lock() {
                Ok(()) if is_at(&file, &part) => return Ok((part, file)),
                // Another run took it for one that is left, before it was locked.
                Ok(()) | Err(fs::TryLockError::WouldBlock) => {}
                // The file system has no locks.
                Err(fs::TryLockError::Error(_)) => return Ok((part, file)),
            },
            Err(e) if e.kind() == io::ErrorKind::AlreadyExists => {}
            Err(e) => return Err(e),
        }
    }
}

/// Whether a file's name is one of [`create_part`].
fn is_part(name: &OsStr) -> bool {
    let middle = |name: &str| {
        let name = name.strip_prefix('.')?.strip_suffix(".part")?;
        let (_, random) = name.rsplit_once('.')?;
        Some(random.len() == 16 && random.bytes().all(|b| b.is_ascii_hexdigit()))
    };
    middle(&name.to_string_lossy()) == Some(true)
}

/// A part of this age is not in use any more, where the file system has no locks to tell.
const OLD: Duration = Duration::from_secs(24 * 3600);

/// Removes what killed runs left in a folder: parts that no program holds.
fn remove_parts(folder: &Path) {
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        if is_part(&entry.file_name()) {
            // What cannot be removed is in nobody's way.
            let _ = remove_left(&entry);
        }
    }
}

/// Removes a part, if no program holds it.
fn remove_left(part: &fs::DirEntry) -> io::Result<()> {
    let data = part.metadata()?;
    // A link or a pipe is not opened.
    if !data.is_file() {
        return Ok(());
    }
    let file = File::options().write(true).open(part.path())?;
    let is_left = match file.try_lock() {
        Ok(()) => true,
        Err(fs::TryLockError::WouldBlock) => false,
        Err(fs::TryLockError::Error(_)) => {
            let age = data.modified()?.elapsed();
            age.is_ok_and(|age| age >= OLD)
        }
    };
    // It stays locked meanwhile, as far as there are locks: see who makes it.
    match is_left {
        true => fs::remove_file(part.path()),
        false => Ok(()),
    }
}

/// Makes a folder, sees that it can be written to, and clears away what killed runs left in it.
///
/// # Errors
/// It cannot be made or written to.
pub fn prepare_folder(folder: &Path) -> Result<()> {
    let failed = |e| Error::writing(folder, &e);
    fs::create_dir_all(folder).map_err(failed)?;
    let unfinished = unfinished();
    let (probe, _) = create_part(&folder.join("glimt")).map_err(failed)?;
    let _ = fs::remove_file(probe);
    drop(unfinished);
    remove_parts(folder);
    Ok(())
}

/// Prepares the folder of a file that is written alone, where there is one: such a folder is not made.
///
/// # Errors
/// It cannot be written to.
pub fn prepare_folder_of(target: &Target) -> Result<()> {
    match target.path().parent() {
        Some(folder) if folder.is_dir() => prepare_folder(folder),
        _ => Ok(()),
    }
}

/// Name of the file that is locked while a run writes to a folder.
const LOCK: &str = ".glimt.lock";

/// A folder that a run writes to, locked against other runs until this is dropped. Runs that share it, each with frames of its own,
/// lock it together.
#[derive(Debug)]
pub struct Folder {
    path: PathBuf,
    /// Nothing where the file system has no locks.
    lock: Option<File>,
    shared: bool,
}

impl Folder {
    /// Makes the folder and locks it.
    ///
    /// # Errors
    /// It cannot be made or written to, or another run writes to it.
    pub fn claim(path: &Path, shared: bool) -> Result<Self> {
        prepare_folder(path)?;
        Ok(Self {
            path: path.to_owned(),
            lock: lock(path, shared)?,
            shared,
        })
    }

    /// Makes a folder within this one.
    ///
    /// # Errors
    /// It cannot be made or written to.
    pub fn within(&self, name: &str) -> Result<PathBuf> {
        let path = self.path.join(name);
        prepare_folder(&path)?;
        Ok(path)
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        if let Some(file) = self.lock.take() {
            // The last of those that share it puts the file away.
            if !self.shared || file.try_lock().is_ok() {
                let path = self.path.join(LOCK);
                let _ = fs::remove_file(&path);
                unfinished().remove(&path);
            }
        }
    }
}

/// Locks a folder by the file in it; `None` where the file system has no locks.
fn lock(folder: &Path, shared: bool) -> Result<Option<File>> {
    let path = folder.join(LOCK);
    let mut unfinished = unfinished();
    loop {
        let file = open_lock(&path).map_err(|e| Error::writing(&path, &e))?;
        let locked = match shared {
            true => file.try_lock_shared(),
            false => file.try_lock(),
        };
        match locked {
            Ok(()) if is_at(&file, &path) => {
                // Others hold a lock that is shared: they put the file away.
                if !shared {
                    unfinished.insert(path);
                }
                return Ok(Some(file));
            }
            // Another run put it away between the two: there is a new one, or none.
            Ok(()) => {}
            Err(fs::TryLockError::WouldBlock) => return Err(in_use(folder)),
            Err(fs::TryLockError::Error(e)) => {
                tracing::warn!("{} is not locked: {e}", folder.display());
                return Ok(None);
            }
        }
    }
}

fn in_use(folder: &Path) -> Error {
    Error::output(folder, "another run of glimt writes to this folder").fix(
        "wait for it, or choose another folder with --out; runs whose frames are different can share one: give --share to all of them",
    )
}

/// Opens the file that is locked. It is a plain file or not there: a link or a pipe of its name is not opened.
fn open_lock(path: &Path) -> io::Result<File> {
    // Some file systems want both for both kinds of lock.
    let both = || File::options().read(true).write(true).clone();
    match both().create_new(true).open(path) {
        Err(e) if e.kind() == io::ErrorKind::AlreadyExists => {}
        created => return created,
    }
    match fs::symlink_metadata(path) {
        Ok(data) if !data.is_file() => Err(io::Error::other("it is not a file; remove it")),
        Err(e) if e.kind() == io::ErrorKind::NotFound => open_lock(path),
        Err(e) => Err(e),
        Ok(_) => match both().open(path) {
            Err(e) if e.kind() == io::ErrorKind::NotFound => open_lock(path),
            opened => opened,
        },
    }
}

/// Whether an open file is the one at a path.
#[cfg(unix)]
fn is_at(file: &File, path: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    let identity = |data: fs::Metadata| (data.dev(), data.ino());
    let at = fs::metadata(path).map(identity);
    file.metadata().map(identity).ok() == at.ok()
}

/// Elsewhere a file that is open is not removed.
#[cfg(not(unix))]
fn is_at(_file: &File, _path: &Path) -> bool {
    true
}

#[cfg(test)]
mod tests {
    use super::super::target::Guard;
    use super::*;

    fn folder(test: &str) -> PathBuf {
        let name = format!("glimt-atomic-{test}-{}", std::process::id());
        std::env::temp_dir().join(name)
    }

    fn names(folder: &Path) -> Vec<OsString> {
        let entries = fs::read_dir(folder).unwrap();
        entries.map(|entry| entry.unwrap().file_name()).collect()
    }

    #[test]
    fn the_name_is_taken_at_the_end_only() {
        let folder = folder("name");
        prepare_folder(&folder).unwrap();
        let file = folder.join("a.bin");
        let target = Guard::new(true).target(&file).unwrap();

        let mut pending = Pending::create(&target).unwrap();
        pending.write_all(b"new").unwrap();
        assert!(!file.exists());
        drop(pending);
        assert!(names(&folder).is_empty());

        let mut pending = Pending::create(&target).unwrap();
        pending.write_all(b"new").unwrap();
        pending.commit().unwrap();
        assert_eq!(fs::read(&file).unwrap(), b"new");
        assert_eq!(names(&folder), ["a.bin"]);
        fs::remove_dir_all(&folder).unwrap();
    }

    #[test]
    fn parts_that_killed_runs_left_are_removed_and_others_are_not() {
        let folder = folder("parts");
        prepare_folder(&folder).unwrap();
        let target = Guard::new(true).target(&folder.join("a.bin")).unwrap();
        let mut living = Pending::create(&target).unwrap();
        let left = folder.join(".b.bin.0123456789abcdef.part");
        fs::write(&left, b"old").unwrap();
        fs::write(folder.join(".c.part"), b"another program's").unwrap();
        drop(Folder::claim(&folder, true).unwrap());
        assert!(!left.exists() && living.part().exists());
        living.write_all(b"new").unwrap();
        living.commit().unwrap();

        fs::write(&left, b"again").unwrap();
        drop(Folder::claim(&folder, false).unwrap());
        let mut names = names(&folder);
        names.sort();
        assert_eq!(names, [".c.part", "a.bin"]);
        fs::remove_dir_all(&folder).unwrap();
    }

    #[test]
    fn one_run_has_a_folder_or_several_share_it() {
        let folder = folder("lock");
        let first = Folder::claim(&folder, false).unwrap();
        let refused = |shared| Folder::claim(&folder, shared).unwrap_err().to_string();
        assert!(refused(false).contains("another run of glimt"));
        assert!(refused(true).contains("another run of glimt"));
        drop(first);
        let both = [(); 2].map(|()| Folder::claim(&folder, true).unwrap());
        assert!(refused(false).contains("--share"));
        drop(both);
        drop(Folder::claim(&folder, false).unwrap());
        assert!(names(&folder).is_empty());
        fs::remove_dir_all(&folder).unwrap();
    }

    #[cfg(unix)]
    #[test]
    fn a_planted_link_is_not_followed() {
        let folder = folder("link");
        fs::create_dir_all(&folder).unwrap();
        let precious = folder.join("precious");
        fs::write(&precious, b"kept").unwrap();
        std::os::unix::fs::symlink(&precious, folder.join(LOCK)).unwrap();
        let refused = Folder::claim(&folder, false).unwrap_err().to_string();
        assert!(refused.contains("it is not a file"), "{refused}");
        assert_eq!(fs::read(&precious).unwrap(), b"kept");
        fs::remove_dir_all(&folder).unwrap();
    }
}
