//! Host file: how a shot says that files of images are read.

use super::Format;
use crate::colour::encoding::Transfer;
use crate::colour::primaries::{Primaries, REC_709};
use crate::error::{Error, Result};
use crate::shot::{self, Shot};
use std::path::Path;

/// How files of images are read, where their headers are not to decide.
#[derive(Clone, Debug, PartialEq)]
pub struct Reading {
    /// The table of the shot that the keys below stand in, for messages; empty for what no shot names.
    pub table: &'static str,
    /// The layer, part or view to read; empty for the one that is a picture.
    pub layer: String,
    /// The primaries of its colours; those that the header names, if not given.
    pub primaries: Option<Primaries>,
    /// The curve of its numbers; that of its format and header, if not given.
    pub transfer: Option<Transfer>,
    /// The most texels that are taken.
    pub max_texels: u64,
    /// The primaries that light is converted to.
    pub working: Primaries,
}

impl Default for Reading {
    fn default() -> Self {
        Self {
            table: "",
            layer: String::new(),
            primaries: None,
            transfer: None,
            max_texels: shot::MAX_TEXELS,
            working: REC_709,
        }
    }
}

impl Reading {
    /// How a shot's light is read.
    #[must_use]
    pub fn of_probe(shot: &Shot) -> Self {
        Self {
            table: "probe",
            layer: shot.probe.layer.clone(),
            primaries: shot.probe.primaries.map(shot::NamedPrimaries::primaries),
            ..Self::of_images(shot)
        }
    }

    /// How a shot's backplate is read.
    #[must_use]
    pub fn of_plate(shot: &Shot) -> Self {
        let keys = shot.backplate.clone().unwrap_or_default();
        Self {
            table: "backplate",
            layer: keys.layer,
            primaries: keys.primaries.map(shot::NamedPrimaries::primaries),
            transfer: keys.transfer.map(shot::NamedTransfer::transfer),
            ..Self::of_images(shot)
        }
    }

    fn of_images(shot: &Shot) -> Self {
        Self {
            max_texels: shot.image.max_texels,
            working: shot.image.primaries.primaries(),
            ..Self::default()
        }
    }

    /// The format, if it has what is to be read of it.
    pub(super) fn fits(&self, file: &Path, format: Format) -> Result<Format> {
        if self.layer.is_empty() || format == Format::Exr {
            return Ok(format);
        }
        let key = self.key("layer");
        let what = format!("it has no layers, and {key} is `{}`", self.layer);
        Err(Error::input(file, what).fix("leave that key out: OpenEXR alone has layers"))
    }

    /// The key of this name, or how to say it where no shot gives it.
    pub(super) fn key(&self, name: &str) -> String {
        match self.table {
            "" => format!("probe.{name} or backplate.{name}"),
            table => format!("{table}.{name}"),
        }
    }

    /// Primaries and where they are known from, for those who look at a file.
    pub(super) fn told_primaries(&self, of_file: Primaries, source: &str) -> String {
        match self.primaries {
            Some(given) => format!("{given} ({})", self.key("primaries")),
            None => format!("{of_file} ({source})"),
        }
    }
}
