//! Host file: which files a run may write: none that it reads, and none that something else made.

use super::SOFTWARE;
use crate::error::{Error, Result};
use crate::input::frames::FrameFiles;
use std::collections::HashMap;
use std::fs::{self, File, Metadata};
use std::io::{self, Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};

/// What a run reads, and whether it may replace files that this program did not write.
#[derive(Clone, Debug, Default)]
pub struct Guard {
    inputs: HashMap<Identity, String>,
    sequences: Vec<(&'static str, FrameFiles)>,
    overwrite: bool,
}

/// A file that may be written; [`Guard::target`] gives it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Target(PathBuf);

impl Target {
    /// Its path.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.0
    }
}

/// What makes a file the same under another name: device and number on Unix, elsewhere the path without links.
#[cfg(unix)]
type Identity = (u64, u64);
#[cfg(not(unix))]
type Identity = PathBuf;

#[cfg(unix)]
fn identity(_file: &Path, data: &Metadata) -> Option<Identity> {
    use std::os::unix::fs::MetadataExt;
    Some((data.dev(), data.ino()))
}

#[cfg(not(unix))]
fn identity(file: &Path, _data: &Metadata) -> Option<Identity> {
    file.canonicalize().ok()
}

impl Guard {
    /// Nothing is read yet. With `overwrite`, files that this program did not write may be replaced; inputs never are.
    #[must_use]
    pub fn new(overwrite: bool) -> Self {
        Self {
            overwrite,
            ..Self::default()
        }
    }

    /// Whether files that this program did not write may be replaced.
    #[must_use]
    pub fn overwrites(&self) -> bool {
        self.overwrite
    }

    /// The run reads a file; `what` says what it is to it. A file that does not exist needs no guard.
    pub fn reads(&mut self, what: &str, file: &Path) {
        if let Ok(data) = fs::metadata(file)
            && let Some(identity) = identity(file, &data)
        {
            let what = || what.to_owned();
            self.inputs.entry(identity).or_insert_with(what);
        }
    }

    /// The run reads a sequence, of which more may come: no output may have a name of one of its frames.
    pub fn reads_sequence(&mut self, what: &'static str, files: &FrameFiles) {
        let there = files.listed().unwrap_or_default();
        self.reads_all(what, there.into_iter().map(|frame| files.path(frame)));
        self.sequences.push((what, files.clone()));
    }

    /// The run reads files.
    pub fn reads_all(&mut self, what: &str, files: impl IntoIterator<Item = PathBuf>) {
        for file in files {
            self.reads(what, &file);
        }
    }

    /// Sees that a file may be written: that nothing is there, or something that this program wrote and this run does not read.
    /// Links are followed.
    ///
    /// # Errors
    /// It is a folder or a device, an input, or something else's file and the guard does not overwrite.
    pub fn target(&self, file: &Path) -> Result<Target> {
        if let Some((what, _)) = self.sequences.iter().find(|(_, files)| files.holds(file)) {
            return Err(is_read(what, file));
        }
        match fs::symlink_metadata(file) {
            Ok(_) => self.replaced(file)?,
            Err(e) if e.kind() == io::ErrorKind::NotFound => {}
            Err(e) => return Err(Error::writing(file, &e)),
        }
        Ok(Target(file.to_owned()))
    }

    fn replaced(&self, file: &Path) -> Result<()> {
        let refused = |what: &str| {
            let fix = format!("remove it, {ELSEWHERE}, or replace it with --overwrite");
            Err(Error::usage(what).file(file).fix(fix))
        };
        let impossible = |what: &str| Err(Error::output(file, what).fix(ELSEWHERE));
        let data = match fs::metadata(file) {
            Ok(data) => data,
            Err(_) if self.overwrite => return Ok(()),
            Err(_) => return refused("a link of this name leads to nothing"),
        };
        if data.is_dir() {
            return impossible("this is a folder, and a file is to be written");
        }
        if !data.is_file() {
            return impossible("this is not a file that can be replaced");
        }
        let known = identity(file, &data).and_then(|identity| self.inputs.get(&identity));
        if let Some(what) = known {
            return Err(is_read(what, file));
        }
        if self.overwrite || is_ours(file).map_err(|e| Error::reading(file, &e))? {
            return Ok(());
        }
        refused("it is there already, and glimt did not write it")
    }
}

const ELSEWHERE: &str = "name another with --out";

fn is_read(what: &str, file: &Path) -> Error {
    let text = format!("this is {what}, which this run reads: it is not written over");
    Error::usage(text).file(file).fix(ELSEWHERE)
}

/// What each text file of this program begins with, if its format has comments.
pub const COMMENT: &str = "# Written by glimt";

/// Bytes at both ends of a file in which its stamp is looked for.
const ENDS: u64 = 1 << 16;

/// Whether this program wrote a file, by the stamp that each of its formats has. An empty file is nobody's: nothing is lost with it.
///
/// # Errors
/// It cannot be read.
pub fn is_ours(file: &Path) -> io::Result<bool> {
    let mut reader = File::open(file)?;
    let length = reader.metadata()?.len();
    let mut bytes = Vec::new();
    (&mut reader).take(ENDS).read_to_end(&mut bytes)?;
    // The stamp of a glTF file is anywhere in the text that it begins with, that of a video behind its tables.
    let more = match (&bytes[..], bytes.get(12..16)) {
        ([b'g', b'l', b'T', b'F', ..], Some(&[a, b, c, d])) => {
            u64::from(u32::from_le_bytes([a, b, c, d])).min(MOST_TEXT)
        }
        ([_, _, _, _, b'f', b't', b'y', b'p', ..], _) => MOST_TABLES,
        _ => 0,
    };
    (&mut reader).take(more).read_to_end(&mut bytes)?;
    let start = bytes.len();
    reader.seek(SeekFrom::Start(
        length.saturating_sub(ENDS).max(start as u64),
    ))?;
    (&mut reader).take(ENDS).read_to_end(&mut bytes)?;
    Ok(length == 0 || has_stamp(&bytes))
}

/// The longest text of a glTF file that is looked at.
const MOST_TEXT: u64 = 1 << 28;
/// The longest tables of a video that are looked at.
const MOST_TABLES: u64 = 1 << 24;

/// Whether the ends of a file have the stamp of their format.
fn has_stamp(bytes: &[u8]) -> bool {
    let has = |stamp: &[u8]| bytes.windows(stamp.len()).any(|window| window == stamp);
    let name = SOFTWARE.split_inclusive(' ').next().unwrap_or(SOFTWARE);
    let named = |before: &str| has(format!("{before}{name}").as_bytes());
    match bytes {
        [0x76, 0x2f, 0x31, 0x01, ..] => has(b"glimtHash\0"),
        [0x89, b'P', b'N', b'G', ..] => named("tEXtSoftware\0"),
        [b'g', b'l', b'T', b'F', ..] => has(b"\"glimt_bake\""),
        [_, _, _, _, b'f', b't', b'y', b'p', ..] => named(""),
        [b'<', ..] => named("<meta name=\"generator\" content=\""),
        [b'{', ..] => named("\"software\":\"") || named("\"software\": \""),
        _ => [
            COMMENT,
            "# glimt ",
            "glimt state of a method ",
            "glimt sequential sampler ",
            "glimtMO",
            "[\"glimt ",
            CSV,
        ]
        .iter()
        .any(|start| bytes.starts_with(start.as_bytes())),
    }
}

/// How the table of a comparison begins, whose format has no comments.
const CSV: &str = "contestant,frame,samples,";

#[cfg(test)]
mod tests {
    use super::*;

    struct Folder(PathBuf);

    impl Folder {
        fn new(test: &str) -> Self {
            let name = format!("glimt-target-{test}-{}", std::process::id());
            let folder = std::env::temp_dir().join(name);
            fs::create_dir_all(&folder).unwrap();
            Self(folder)
        }

        fn file(&self, name: &str, text: &str) -> PathBuf {
            let file = self.0.join(name);
            fs::write(&file, text).unwrap();
            file
        }
    }

    impl Drop for Folder {
        fn drop(&mut self) {
            let _ = fs::remove_dir_all(&self.0);
        }
    }

    fn refusal(guard: &Guard, file: &Path) -> String {
        guard
            .target(file)
            .map_or_else(|e| e.to_string(), |_| String::new())
    }

    #[test]
    fn what_is_there_stays_unless_it_is_ours() {
        let folder = Folder::new("ours");
        let (careful, bold) = (Guard::new(false), Guard::new(true));
        let nothing = folder.0.join("new.exr");
        assert_eq!(careful.target(&nothing).unwrap().path(), nothing);
        let foreign = folder.file("foreign.json", "{\"software\": \"other 1\"}");
        assert!(refusal(&careful, &foreign).contains("glimt did not write it"));
        assert_eq!(refusal(&bold, &foreign), "");
        for (name, text) in [
            ("empty.exr", ""),
            ("own.json", "{\"a\":1,\"software\":\"glimt 0.0.1\"}"),
            ("own.toml", "# Written by glimt 0.0.1"),
        ] {
            assert_eq!(refusal(&careful, &folder.file(name, text)), "", "{name}");
        }
        // A shot of a person's own, who writes of this program.
        let shot = folder.file("shot.toml", "# glimt: written by hand\n[image]\n");
        assert!(!refusal(&careful, &shot).is_empty());
        assert!(refusal(&bold, &folder.0).contains("this is a folder"));
    }

    #[test]
    fn inputs_are_never_written_over() {
        let folder = Folder::new("inputs");
        let light = folder.file("light.json", "{\"software\":\"glimt 0.0.1\"}");
        let mut guard = Guard::new(true);
        guard.reads("the light", &light);
        guard.reads("a mesh", &folder.0.join("not there"));
        assert!(refusal(&guard, &light).contains("this is the light"));
        let frames = FrameFiles::new(&folder.0, "light.####.exr").unwrap();
        guard.reads_sequence("film", &frames);
        let next = folder.0.join("light.0007.exr");
        assert!(refusal(&guard, &next).contains("this is film"));
        assert_eq!(refusal(&guard, &folder.0.join("light.exr")), "");
        // By any road to it.
        let crooked = folder.0.join(".").join("light.json");
        assert!(refusal(&guard, &crooked).contains("this is the light"));
        let hard = folder.0.join("hard.json");
        fs::hard_link(&light, &hard).unwrap();
        #[cfg(unix)]
        {
            assert!(refusal(&guard, &hard).contains("this is the light"));
            let link = folder.0.join("link.json");
            std::os::unix::fs::symlink(&light, &link).unwrap();
            assert!(refusal(&guard, &link).contains("this is the light"));
        }
    }
}
