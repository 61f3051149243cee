//! Host file: the channels of one part of an OpenEXR file, of which the largest level is read and nothing else is decoded. Each block
//! goes straight into the image, on all cores: to gather channels first would be a second pass over more memory.

use super::broken;
use crate::error::{Error, Result};
use crate::memory;
use ::exr::block::UncompressedBlock;
use ::exr::block::chunk::{Chunk, CompressedBlock};
use ::exr::meta::attribute::SampleType;
use ::exr::meta::header::Header as Part;
use ::exr::meta::{BlockDescription, MetaData};
use ::exr::prelude::{Compression, f16};
use glam::Vec4;
use rayon::prelude::*;
use std::io::Cursor;
use std::path::Path;
use std::sync::{Mutex, PoisonError};

/// The samples of these channels of a part, at most three: the first as x, the second as y, the third as z, and w is 1. Rows of its
/// data window from the top.
///
/// # Errors
/// The part is broken or truncated, or stores a channel for every nth texel alone.
pub(super) fn read(file: &Path, bytes: &[u8], part: usize, wanted: &[usize]) -> Result<Vec<Vec4>> {
    let fail = |e: ::exr::error::Error| broken(file, &e);
    let reader = ::exr::block::read(Cursor::new(bytes), false).map_err(fail)?;
    let header = reader.headers()[part].clone();
    for &channel in wanted {
        let channel = &header.channels.list[channel];
        if (channel.sampling.x(), channel.sampling.y()) != (1, 1) {
            let what = format!("channel {} is subsampled", channel.name);
            return Err(Error::input(file, what).fix("export it with plain R, G, B channels"));
        }
    }
    // Each thread decodes a block at a time, and decoders may ask for several times its size.
    let block = header.max_block_byte_size() as u64;
    let threads = rayon::current_num_threads() as u64;
    memory::require("a block of the image", block.saturating_mul(threads)).map_err(|e| {
        e.file(file)
            .fix("free some, raise its limit, or export it in small tiles")
    })?;

    let meta = MetaData {
        requirements: reader.meta_data().requirements,
        headers: reader.headers().into(),
    };
    let chunks = reader
        .filter_chunks(false, |_, tile, block| {
            block.layer == part && tile.is_largest_resolution_level()
        })
        .map_err(fail)?;
    let chunks: Vec<Chunk> = chunks.collect::<::exr::error::Result<_>>().map_err(fail)?;
    for chunk in &chunks {
        check_sections(file, &header, chunk)?;
    }
    let (width, height) = (header.layer_size.x(), header.layer_size.y());
    let rows = match header.blocks {
        BlockDescription::ScanLines => header.compression.scan_lines_per_block(),
        BlockDescription::Tiles(tiles) => tiles.tile_size.y(),
    };
    // The thread that first writes to a page of zeros makes it.
    let mut texels: Vec<Vec4> = bytemuck::zeroed_vec(width * height);
    // What blocks that lie side by side have in common.
    let bands: Vec<Mutex<&mut [Vec4]>> = texels
        .chunks_mut((width * rows).max(1))
        .map(Mutex::new)
        .collect();
    let place = |chunk: Chunk| {
        let block = UncompressedBlock::decompress_chunk(chunk, &meta, false).map_err(fail)?;
        let band = bands.get(block.index.pixel_position.y() / rows);
        let band = band.ok_or_else(|| missing(file))?;
        let mut band = band.lock().unwrap_or_else(PoisonError::into_inner);
        put(&block, &header, wanted, &mut band, rows).ok_or_else(|| missing(file))
    };
    let samples = chunks.into_par_iter().map(place);
    let samples = samples.try_reduce(|| 0, |a, b| Ok(a + b))?;
    drop(bands);
    match samples == wanted.len() * width * height {
        true => Ok(texels),
        false => Err(missing(file)),
    }
}

fn missing(file: &Path) -> Error {
    Error::input(file, "it is broken: some of its blocks are missing")
        .fix("copy or export it again")
}

/// Puts the samples of the channels that are wanted into a band of `rows` rows that holds the block; says how many there were. `None`
/// where the block does not fit it.
fn put(
    block: &UncompressedBlock,
    header: &Part,
    wanted: &[usize],
    band: &mut [Vec4],
    rows: usize,
) -> Option<usize> {
    let width = header.layer_size.x();
    let mut count = 0;
    for line in block.lines(&header.channels) {
        let index = line.location;
        let at = index.position.y() % rows * width + index.position.x();
        let sample = header.channels.list[index.channel].sample_type;
        let components = wanted.iter().enumerate();
        for (component, _) in components.filter(|(_, w)| **w == index.channel) {
            let row = band.get_mut(at..at + index.sample_count)?;
            match sample {
                SampleType::F16 => set(row, component, line.value, |b| {
                    f16::from_ne_bytes(b).to_f32()
                }),
                SampleType::F32 => set(row, component, line.value, f32::from_ne_bytes),
                SampleType::U32 => {
                    set(row, component, line.value, |b| u32::from_ne_bytes(b) as f32)
                }
            }
            count += row.len();
        }
    }
    Some(count)
}

/// Sets one component of each texel, and w.
fn set<const N: usize>(
    row: &mut [Vec4],
    component: usize,
    samples: &[u8],
    value: impl Fn([u8; N]) -> f32,
) {
    let (samples, _) = samples.as_chunks::<N>();
    for (texel, sample) in row.iter_mut().zip(samples) {
        texel[component] = value(*sample);
        texel.w = 1.0;
    }
}

/// Counters at the beginning of a chunk by DWA.
const DWA_COUNTERS: usize = 11;

/// Sees that a chunk by DWA does not say that its sections hold much more than a block does: the decoder takes memory for what they
/// say.
fn check_sections(file: &Path, header: &Part, chunk: &Chunk) -> Result<()> {
    if !matches!(
        header.compression,
        Compression::DWAA(_) | Compression::DWAB(_)
    ) {
        return Ok(());
    }
    let data = match &chunk.compressed_block {
        CompressedBlock::ScanLine(block) => &block.compressed_pixels_le,
        CompressedBlock::Tile(block) => &block.compressed_pixels_le,
        _ => return Ok(()),
    };
    let counters = data.as_chunks::<8>().0.iter().take(DWA_COUNTERS);
    // A block of one texel is coded as 8 × 8 of them.
    let most = 4 * header.max_block_byte_size() as u64 + (1 << 16);
    if counters.map(|c| u64::from_le_bytes(*c)).any(|c| c > most) {
        return Err(Error::input(
            file,
            "it is broken: a block says that it holds more than its texels take",
        )
        .fix("copy or export it again"));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use ::exr::prelude::{
        AnyChannel, AnyChannels, Blocks, Encoding, FlatSamples, Image, Layer, LayerAttributes,
        LineOrder, Vec2, WritableImage,
    };

    const SIZE: [usize; 2] = [37, 29];

    /// An image with a channel of each type, all of whose texels differ.
    fn image(encoding: Encoding) -> Vec<u8> {
        let each = |f: fn(usize, usize) -> f32| -> Vec<f32> {
            let places = (0..SIZE[0] * SIZE[1]).map(|i| (i % SIZE[0], i / SIZE[0]));
            places.map(|(x, y)| f(x, y)).collect()
        };
        let halves = each(|x, y| (x + 64 * y) as f32).into_iter();
        let counts = each(|x, y| (1000 * x + y) as f32).into_iter();
        let list = [
            ("A", FlatSamples::F16(halves.map(f16::from_f32).collect())),
            (
                "G",
                FlatSamples::F32(each(|x, y| x as f32 / 4.0 - y as f32)),
            ),
            ("Z", FlatSamples::U32(counts.map(|c| c as u32).collect())),
        ];
        let list = list
            .into_iter()
            .map(|(name, samples)| AnyChannel::new(name, samples));
        let channels = AnyChannels::sort(list.collect());
        let layer = Layer::new(
            (SIZE[0], SIZE[1]),
            LayerAttributes::default(),
            encoding,
            channels,
        );
        let mut bytes = Cursor::new(Vec::new());
        Image::from_layer(layer)
            .write()
            .to_buffered(&mut bytes)
            .unwrap();
        bytes.into_inner()
    }

    #[test]
    fn blocks_of_any_kind_are_put_in_their_places() {
        let tiles = |x, y| Blocks::Tiles(Vec2(x, y));
        for blocks in [Blocks::ScanLines, tiles(16, 8), tiles(5, 29), tiles(64, 64)] {
            for compression in [
                Compression::Uncompressed,
                Compression::ZIP1,
                Compression::ZIP16,
                Compression::PIZ,
            ] {
                for line_order in [LineOrder::Increasing, LineOrder::Decreasing] {
                    let bytes = image(Encoding {
                        compression,
                        blocks,
                        line_order,
                    });
                    let texels = read(Path::new("a.exr"), &bytes, 0, &[2, 1, 0]).unwrap();
                    assert_eq!(texels.len(), SIZE[0] * SIZE[1]);
                    for (i, texel) in texels.iter().enumerate() {
                        let [x, y] = [i % SIZE[0], i / SIZE[0]].map(|n| n as f32);
                        let right = Vec4::new(1000.0 * x + y, x / 4.0 - y, x + 64.0 * y, 1.0);
                        assert_eq!(
                            *texel, right,
                            "{blocks:?} {compression} {line_order:?} at {x}, {y}"
                        );
                    }
                    let cut = &bytes[..bytes.len() - 10];
                    assert!(read(Path::new("a.exr"), cut, 0, &[2]).is_err());
                }
            }
        }
    }
}
