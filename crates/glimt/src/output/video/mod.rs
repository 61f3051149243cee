//! Host file: display frames as an mp4: H.264 by `ffmpeg` where it is found, else AV1 encoded here.

mod av1;
mod ffmpeg;

use super::atomic::Pending;
use crate::error::{Error, Result};
use crate::shot::Codec;
use glam::UVec2;
use std::path::Path;

/// A video that is being written. Nothing stands under its name before [`Video::finish`].
pub enum Video {
    /// AV1, encoded here.
    Av1(Box<av1::Av1>),
    /// H.264, encoded by `ffmpeg`.
    H264(ffmpeg::Ffmpeg),
}

impl Video {
    /// Begins a video of frames of this size. `hash` is stored in its title.
    ///
    /// # Errors
    /// The frames are too small, the file cannot be written, or `ffmpeg` is asked for and not found.
    pub fn create(file: &Path, size: UVec2, fps: f32, codec: Codec, hash: &str) -> Result<Self> {
        if size.min_element() < 16 {
            return Err(
                Error::output(file, "a video cannot be smaller than 16 × 16 pixels")
                    .fix("render larger frames, or leave the video out: --set output.video="),
            );
        }
        let pending = Pending::create(file)?;
        let title = format!("{} {hash}", super::SOFTWARE);
        let h264 = match codec {
            Codec::Auto => ffmpeg::is_found(),
            Codec::H264 => true,
            Codec::Av1 => false,
        };
        if h264 {
            return ffmpeg::Ffmpeg::start(pending, size, fps, &title).map(Self::H264);
        }
        av1::Av1::start(pending, size, fps, &title).map(|v| Self::Av1(Box::new(v)))
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

/// Whether a video is there and was made of the frames with this hash.
pub fn is_current(file: &Path, hash: &str) -> bool {
    let Ok(bytes) = std::fs::read(file) else {
        return false;
    };
    bytes
        .windows(hash.len())
        .any(|window| window == hash.as_bytes())
}
