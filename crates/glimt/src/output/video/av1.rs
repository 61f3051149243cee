//! Host file: AV1 by rav1e, in an mp4 by muxide.

use super::super::atomic::Pending;
use crate::error::{Error, Result};
use glam::UVec2;
use muxide::api::{Metadata, Muxer, MuxerBuilder, MuxerError, VideoCodec};
use rav1e::prelude::*;
use std::io::Write;

/// Encoder speed, 0 to 10: fast enough not to hold up the renderer.
const SPEED: u8 = 9;
/// Quantiser, 0 to 255: visually close to the frames.
const QUANTIZER: usize = 70;

/// A video that is being encoded.
pub struct Av1 {
    size: UVec2,
    fps: f64,
    encoder: Context<u8>,
    muxer: Muxer<Pending>,
    file: std::path::PathBuf,
}

impl Av1 {
    pub(super) fn start(pending: Pending, size: UVec2, fps: f32, title: &str) -> Result<Self> {
        let file = pending.target().to_owned();
        let internal = |e: &dyn std::fmt::Display| Error::output(&file, e);
        let encoding = EncoderConfig {
            width: size.x as usize,
            height: size.y as usize,
            time_base: Rational {
                num: 1000,
                den: (f64::from(fps) * 1000.0).round() as u64,
            },
            color_description: Some(ColorDescription {
                color_primaries: ColorPrimaries::BT709,
                transfer_characteristics: TransferCharacteristics::SRGB,
                matrix_coefficients: MatrixCoefficients::BT709,
            }),
            pixel_range: PixelRange::Limited,
            quantizer: QUANTIZER,
            max_key_frame_interval: 120,
            // Frames leave in the order in which they came.
            low_latency: true,
            ..EncoderConfig::with_speed_preset(SPEED)
        };
        let encoder = Config::new()
            .with_encoder_config(encoding)
            .new_context()
            .map_err(|e| internal(&e))?;
        let muxer = MuxerBuilder::new(pending)
            .video(VideoCodec::Av1, size.x, size.y, f64::from(fps))
            .with_metadata(Metadata::new().with_title(title))
            .build()
            .map_err(|e| internal(&e))?;
        Ok(Self {
            size,
            fps: f64::from(fps),
            encoder,
            muxer,
            file,
        })
    }

    pub(super) fn push(&mut self, rgb: &[u8]) -> Result<()> {
        let mut frame = self.encoder.new_frame();
        let [luma, blue, red] = to_yuv_420(self.size, rgb);
        let chroma_width = self.size.x.div_ceil(2) as usize;
        frame.planes[0].copy_from_raw_u8(&luma, self.size.x as usize, 1);
        frame.planes[1].copy_from_raw_u8(&blue, chroma_width, 1);
        frame.planes[2].copy_from_raw_u8(&red, chroma_width, 1);
        self.encoder
            .send_frame(frame)
            .map_err(|e| Error::output(&self.file, e))?;
        self.drain()
    }

    pub(super) fn finish(mut self) -> Result<()> {
        self.encoder.flush();
        self.drain()?;
        self.muxer
            .finish_in_place()
            .map_err(|e| failed(&self.file, e))?;
        let mut pending = self.muxer.into_writer();
        pending
            .flush()
            .map_err(|e| Error::writing(&self.file, &e))?;
        pending.commit()
    }

    fn drain(&mut self) -> Result<()> {
        loop {
            match self.encoder.receive_packet() {
                Ok(packet) => {
                    let time = packet.input_frameno as f64 / self.fps;
                    let key = packet.frame_type == FrameType::KEY;
                    self.muxer
                        .write_video(time, without_delimiter(&packet.data), key)
                        .map_err(|e| failed(&self.file, e))?;
                }
                Err(EncoderStatus::Encoded) => {}
                Err(EncoderStatus::NeedMoreData | EncoderStatus::LimitReached) => return Ok(()),
                Err(e) => return Err(Error::output(&self.file, e)),
            }
        }
    }
}

fn failed(file: &std::path::Path, error: MuxerError) -> Error {
    match error {
        MuxerError::Io(e) => Error::writing(file, &e),
        e => Error::output(file, e),
    }
}

/// A temporal delimiter (an empty OBU) starts each packet, and has no place in an mp4.
fn without_delimiter(packet: &[u8]) -> &[u8] {
    packet.strip_prefix(&[0x12, 0x00]).unwrap_or(packet)
}

/// Limited-range Y'CbCr of Rec. 709; chroma is the mean of 2 × 2 pixels.
fn to_yuv_420(size: UVec2, rgb: &[u8]) -> [Vec<u8>; 3] {
    let (width, height) = (size.x as usize, size.y as usize);
    let pixel = |x: usize, y: usize| {
        let i = 3 * (y.min(height - 1) * width + x.min(width - 1));
        [rgb[i], rgb[i + 1], rgb[i + 2]].map(f32::from)
    };
    let byte = |value: f32| (value + 0.5) as u8;
    let luma = |[r, g, b]: [f32; 3]| 0.2126 * r + 0.7152 * g + 0.0722 * b;
    let mut planes = [Vec::with_capacity(width * height), Vec::new(), Vec::new()];
    for y in 0..height {
        for x in 0..width {
            planes[0].push(byte(16.0 + luma(pixel(x, y)) * (219.0 / 255.0)));
        }
    }
    for y in (0..height).step_by(2) {
        for x in (0..width).step_by(2) {
            let four = [(0, 0), (1, 0), (0, 1), (1, 1)].map(|(i, j)| pixel(x + i, y + j));
            let mean = [0, 1, 2].map(|c| four.iter().map(|p| p[c]).sum::<f32>() * 0.25);
            let grey = luma(mean);
            let chroma = 224.0 / 255.0;
            planes[1].push(byte(
                128.0 + chroma * (mean[2] - grey) / (2.0 * (1.0 - 0.0722)),
            ));
            planes[2].push(byte(
                128.0 + chroma * (mean[0] - grey) / (2.0 * (1.0 - 0.2126)),
            ));
        }
    }
    planes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_in_limited_range() {
        let size = UVec2::new(3, 1);
        let [y, u, v] = to_yuv_420(size, &[255, 255, 255, 255, 255, 255, 0, 0, 0]);
        assert_eq!(y, [235, 235, 16]);
        assert_eq!((u, v), (vec![128, 128], vec![128, 128]));
        let [y, u, v] = to_yuv_420(UVec2::ONE, &[255, 0, 0]);
        assert_eq!((y[0], u[0], v[0]), (63, 102, 240));
    }
}
