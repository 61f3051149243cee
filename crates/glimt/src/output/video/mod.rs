//! Host file: display frames as an mp4: H.264 by `ffmpeg` where it is found, else AV1 encoded here.

mod av1;
mod ffmpeg;

use super::atomic::{Pending, prepare_folder};
use super::target::Target;
use crate::error::{Error, Result};
use crate::shot::Codec;
use glam::UVec2;
use std::path::Path;

/// What encodes a video.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Encoder {
    /// AV1, here.
    Av1,
    /// H.264, by `ffmpeg`.
    H264,
}

/// Finds what can be known before the first frame is rendered: that the frames make a video, that its encoder is there,
/// and that its file can be written. Makes its folder.
///
/// # Errors
/// The frames are too small, the file cannot be written, or `ffmpeg` is asked for and not found.
pub fn prepare(file: &Target, size: UVec2, codec: Codec) -> Result<Encoder> {
    if size.min_element() < 16 {
        return Err(
            Error::output(file.path(), "a video cannot be smaller than 16 × 16 pixels")
                .fix("render larger frames, or leave the video out: --set output.video="),
        );
    }
    let encoder = match codec {
        Codec::Av1 => Encoder::Av1,
        Codec::Auto | Codec::H264 if ffmpeg::is_found() => Encoder::H264,
        Codec::Auto => Encoder::Av1,
        Codec::H264 => {
            return Err(Error::output(file.path(), "ffmpeg cannot be started")
                .fix("install it, or use the built-in encoder: --set output.codec=av1"));
        }
    };
    if let Some(folder) = file.path().parent() {
        prepare_folder(folder)?;
    }
    Ok(encoder)
}

/// A video that is being written. Nothing stands under its name before [`Video::finish`].
pub enum Video {
    /// AV1, encoded here.
    Av1(Box<av1::Av1>),
    /// H.264, encoded by `ffmpeg`.
    H264(ffmpeg::Ffmpeg),
}

impl Video {
    /// Begins a video of frames of this size, by what [`prepare`] found. `hash` is stored in its title.
    ///
    /// # Errors
    /// The file cannot be written, or the encoder does not start.
    pub fn create(
        file: &Target,
        size: UVec2,
        fps: f32,
        encoder: Encoder,
        hash: &str,
    ) -> Result<Self> {
        let pending = Pending::create(file)?;
        let title = format!("{} {hash}", super::SOFTWARE);
        match encoder {
            Encoder::H264 => ffmpeg::Ffmpeg::start(pending, size, fps, &title).map(Self::H264),
            Encoder::Av1 => {
                av1::Av1::start(pending, size, fps, &title).map(|v| Self::Av1(Box::new(v)))
            }
        }
    }

    /// Adds a frame: RGB bytes, sRGB-encoded, rows from the top.
    ///
    /// # Errors
    /// It cannot be encoded or written.
    pub fn push(&mut self, rgb: &[u8]) -> Result<()> {
        match self {
            Self::Av1(video) => video.push(rgb),
            Self::H264(video) => video.push(rgb),
        }
    }

    /// Completes the video and gives it its name.
    ///
    /// # Errors
    /// It cannot be encoded or written.
    pub fn finish(self) -> Result<()> {
        match self {
            Self::Av1(video) => video.finish(),
            Self::H264(video) => video.finish(),
        }
    }
}

/// Whether a video is there, whole, and was made of the frames with this hash.
pub fn is_current(file: &Path, hash: &str) -> bool {
    let Ok(bytes) = std::fs::read(file) else {
        return false;
    };
    let named = || {
        let mut windows = bytes.windows(hash.len());
        windows.any(|window| window == hash.as_bytes())
    };
    is_whole(&bytes) && named()
}

/// Whether the boxes of an mp4, each of which begins with its length, end where the file does (ISO/IEC 14496-12, § 4.2).
fn is_whole(mut bytes: &[u8]) -> bool {
    while let Some((head, rest)) = bytes.split_first_chunk::<8>() {
        let [a, b, c, d, ..] = *head;
        let length = match (u32::from_be_bytes([a, b, c, d]), rest.first_chunk::<8>()) {
            // To the end of the file: its length is not known.
            (0, _) => return true,
            (1, Some(long)) => usize::try_from(u64::from_be_bytes(*long)).unwrap_or(usize::MAX),
            (short, _) => short as usize,
        };
        if length < head.len() || length > bytes.len() {
            return false;
        }
        bytes = &bytes[length..];
    }
    bytes.is_empty()
}
