//! Host file: the files of one frame: their names, whether they are there, and writing and reading them back.

use crate::colour::primaries::Primaries;
use crate::error::{Error, Kind, Result};
use crate::input::frames::FrameFiles;
use crate::output::{Stamp, aov, exr, png};
use crate::setup::Setup;
use crate::shot::digest;
use glam::Vec4;
use glimt_render_gpu::kernels::film::tonemap;
use glimt_render_gpu::prepare::render::FrameImage;
use rayon::prelude::*;
use sha2::{Digest, Sha256};
use std::borrow::Cow;
use std::collections::BTreeSet;
use std::path::PathBuf;

/// Premultiplied colours with other primaries, whatever their sign.
fn converted(pixels: &[Vec4], from: Primaries, to: Primaries) -> Cow<'_, [Vec4]> {
    let Some(matrix) = from.matrix_to(&to) else {
        return Cow::Borrowed(pixels);
    };
    let convert = |p: &Vec4| {
        let colour = matrix * p.truncate().as_dvec3();
        colour.as_vec3().extend(p.w)
    };
    Cow::Owned(pixels.par_iter().map(convert).collect())
}

/// The files of the frames of a shot.
#[derive(Clone, Copy)]
pub struct Frames<'a> {
    setup: &'a Setup,
}

impl<'a> Frames<'a> {
    /// Those of this shot.
    pub fn of(setup: &'a Setup) -> Self {
        Self { setup }
    }

    /// Whether all files of a frame are there, with this identity.
    pub fn are_there(self, stamp: &Stamp) -> bool {
        let output = &self.setup.shot.output;
        let mut channels: Vec<String> =
            output.aovs.iter().map(|a| aov::first_channel(*a)).collect();
        channels.extend(self.keeps_display().then(aov::first_display_channel));
        let hash = Some(&stamp.hash);
        let exr_there = || exr::read_hash(&self.file(stamp.frame, "exr"), &channels);
        let png_there = || png::read_hash(&self.file(stamp.frame, "png"));
        (output.exr || output.png)
            && (!output.exr || exr_there().as_ref() == hash)
            && (!output.png || png_there().as_ref() == hash)
    }

    /// Sees that the files of a frame may be written.
    ///
    /// # Errors
    /// One is an input, or something else's.
    pub fn may_write(self, frame: i32) -> Result<()> {
        let output = &self.setup.shot.output;
        for (extension, on) in [("exr", output.exr), ("png", output.png)] {
            if on {
                self.setup.guard.target(&self.file(frame, extension))?;
            }
        }
        Ok(())
    }

    /// Numbers of the frames of which there is a file.
    pub fn listed(self) -> BTreeSet<i32> {
        let listed = ["exr", "png"].map(|extension| {
            let files = FrameFiles::new(&self.setup.out, &format!("frame.####.{extension}"));
            files
                .ok()
                .and_then(|files| files.listed().ok())
                .unwrap_or_default()
        });
        listed.into_iter().flatten().collect()
    }

    /// Writes the files of a frame, whose linear image has these primaries.
    ///
    /// # Errors
    /// One cannot be written.
    pub fn write(self, image: &FrameImage, own: Primaries, stamp: &Stamp) -> Result<()> {
        let output = &self.setup.shot.output;
        let target = |extension| self.setup.guard.target(&self.file(stamp.frame, extension));
        if output.exr {
            let file = target("exr")?;
            let layers = self.layers(image, own, stamp.frame)?;
            let linear = converted(&image.linear, own, layers.picture.primaries);
            exr::write(&file, image.size, &linear, layers, stamp)?;
        }
        if output.png {
            let aspect = self.setup.shot.image.pixel_aspect;
            png::write(&target("png")?, image, aspect, stamp)?;
        }
        Ok(())
    }

    /// The identity of a video of these frames.
    pub fn video_identity(self, stamps: &[Stamp]) -> String {
        let mut hasher = Sha256::new();
        for stamp in stamps {
            hasher.update(stamp.hash.as_bytes());
        }
        hasher.update(self.setup.shot.probe.fps.to_le_bytes());
        hasher.update(format!("{:?}", self.setup.shot.output.codec));
        digest::hex(&hasher.finalize().into())
    }

    fn file(self, frame: i32, extension: &str) -> PathBuf {
        self.setup.out.join(format!("frame.{frame:04}.{extension}"))
    }

    /// Whether what is displayed goes into the EXR: a video may have to be made of frames that are there, and what the plate and
    /// the tonemapped objects gave cannot be had from their sum, nor what is displayed from other primaries.
    fn keeps_display(self) -> bool {
        let shot = &self.setup.shot;
        let output = &shot.output;
        let working = shot.image.primaries.primaries();
        let is_converted = output.primaries.primaries().is_some_and(|p| p != working);
        (self.setup.has_plate() || is_converted)
            && output.exr
            && !output.png
            && !output.video.is_empty()
    }

    /// The layers that go into a frame's EXR beside the image.
    fn layers(self, image: &FrameImage, own: Primaries, frame: i32) -> Result<exr::Layers> {
        let settings = self.setup.settings(frame, self.setup.camera(frame)?);
        let aovs = &self.setup.shot.output.aovs;
        // Over a plate everything has the primaries that the plate was brought to.
        let over_plate = self.setup.has_plate();
        let shot = &self.setup.shot;
        let written = match shot.output.primaries.primaries() {
            Some(chosen) if !over_plate => chosen,
            _ => own,
        };
        let to_written = shot.image.primaries.primaries().colour_matrix_to(&written);
        let mut channels = aov::channels(image, aovs, &settings, over_plate, &to_written);
        if self.keeps_display() {
            channels.extend(aov::display(image));
        }
        let shadow = self.setup.shot.backplate.as_ref().map(|plate| plate.shadow);
        let formula = aov::any_layer(aovs).then(|| aov::formula(shadow.unwrap_or_default()));
        let picture = exr::Picture {
            primaries: written,
            pixel_aspect: shot.image.pixel_aspect,
        };
        Ok(exr::Layers {
            channels,
            formula,
            picture,
        })
    }

    /// The display image of a frame that is there already: its PNG, or else its EXR, by its layer of that name over a plate, once
    /// more exposed and tonemapped without one.
    ///
    /// # Errors
    /// The file cannot be read.
    pub fn display(self, frame: i32) -> Result<Vec<[u8; 4]>> {
        if self.setup.shot.output.png {
            return png::read_pixels(&self.file(frame, "png"));
        }
        if self.keeps_display() {
            return exr::read_display(&self.file(frame, "exr"));
        }
        let linear = exr::read_pixels(&self.file(frame, "exr"))?;
        let settings = self.setup.settings(frame, self.setup.camera(frame)?);
        let settings = settings.frame_params();
        let params = settings.map_err(|e| Error::new(Kind::Usage, e))?;
        let pixels = 0..linear.len() as u32;
        Ok(pixels
            .map(|i| tonemap(i, &params, &linear).to_le_bytes())
            .collect())
    }
}
