//! Host file: one trial: the files of a seed, one of them mutated.

use crate::corpus::Seed;
use crate::mutate::{self, Kind};
use glimt_tests::random::Random;
use std::fs;
use std::path::Path;

pub(crate) struct Trial<'a> {
    pub(crate) seed: &'a Seed,
    /// Name of the file that is mutated, and its bytes before and after.
    pub(crate) name: &'a str,
    before: &'a [u8],
    after: Vec<u8>,
}

impl<'a> Trial<'a> {
    /// A trial of one of these seeds, of which each has a file to mutate.
    pub(crate) fn new(seeds: &[&'a Seed], random: &mut Random) -> Self {
        let seed = *random.pick(seeds);
        let (name, before) = random.pick(&seed.mutable);
        // What may be spliced in: the same file of another seed of this format.
        let kind = Kind::of(name);
        let other = random.pick(seeds);
        let other = other.mutable.iter().find(|(n, _)| Kind::of(n) == kind);
        let other = other.map_or(&before[..], |(_, bytes)| bytes);
        Self {
            seed,
            name,
            before,
            after: mutate::mutate(kind, before, other, random),
        }
    }

    /// Writes the mutated file in its place.
    pub(crate) fn write(&self) -> Result<(), String> {
        put(&self.seed.folder.join(self.name), &self.after)
    }

    /// Writes the file as it was.
    pub(crate) fn restore(&self) -> Result<(), String> {
        put(&self.seed.folder.join(self.name), self.before)
    }
}

/// Writes a file.
pub(crate) fn put(path: &Path, bytes: &[u8]) -> Result<(), String> {
    fs::write(path, bytes).map_err(|e| format!("{}: {e}", path.display()))
}
