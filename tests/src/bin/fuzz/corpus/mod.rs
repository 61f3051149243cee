//! Host file: small whole files of every format, which are made here, and what the program is to do with each.

mod documents;
mod exr;
mod gltf;
mod images;
mod meshes;

pub(crate) use meshes::gzip;

use crate::trial::put;
use std::fs;
use std::path::{Path, PathBuf};

/// A folder with files, some of which may be mutated, and the commands that read them.
pub(crate) struct Seed {
    pub(crate) format: &'static str,
    pub(crate) folder: PathBuf,
    /// Names and bytes of those that may be mutated; at least one.
    pub(crate) mutable: Vec<(String, Vec<u8>)>,
    /// What a child does, one command after the other.
    commands: Vec<String>,
    /// Whether the program refuses even the whole file.
    pub(crate) is_refused: bool,
}

impl Seed {
    /// What a child is told, one command after the other.
    pub(crate) fn lines(&self) -> impl Iterator<Item = String> {
        let commands = self.commands.iter();
        commands.map(|text| serde_json::json!(words(&self.folder, text)).to_string())
    }
}

/// The words of a command; those that name a file stand for one in a folder.
fn words(folder: &Path, command: &str) -> Vec<String> {
    let is_file = |word: &str| word == "out" || word.contains('.') && !word.contains('=');
    let full = |word: &str| match is_file(word) {
        true => folder.join(word).display().to_string(),
        false => word.to_owned(),
    };
    command.split(' ').map(full).collect()
}

/// Makes folders of seeds.
struct Maker<'a> {
    work: &'a Path,
    seeds: Vec<Seed>,
}

impl Maker<'_> {
    /// Adds a seed. `mutable` and `fixed` are files with their names; a word of a command that has a
    /// point is a file's name.
    fn add(
        &mut self,
        format: &'static str,
        mutable: Vec<(String, Vec<u8>)>,
        fixed: &[(&str, &[u8])],
        commands: &[&str],
    ) -> Result<&mut Seed, String> {
        let folder = self.work.join(format!("{format}-{}", self.seeds.len()));
        let own = mutable
            .iter()
            .map(|(name, bytes)| (name.as_str(), &bytes[..]));
        for (name, bytes) in own.chain(fixed.iter().copied()) {
            let path = folder.join(name);
            let parent = path.parent().unwrap_or(&folder);
            fs::create_dir_all(parent).map_err(|e| format!("{}: {e}", path.display()))?;
            put(&path, bytes)?;
        }
        self.seeds.push(Seed {
            format,
            folder,
            mutable,
            commands: commands.iter().map(|&text| text.to_owned()).collect(),
            is_refused: false,
        });
        let last = self.seeds.len() - 1;
        Ok(&mut self.seeds[last])
    }
}

/// Makes all seeds, those of a format beside each other, in folders below `work`.
pub(crate) fn make(work: &Path) -> Result<Vec<Seed>, String> {
    let mut maker = Maker {
        work,
        seeds: Vec::new(),
    };
    images::add(&mut maker)?;
    meshes::add(&mut maker)?;
    documents::add(&mut maker)?;
    Ok(maker.seeds)
}
