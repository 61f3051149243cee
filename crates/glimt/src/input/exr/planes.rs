//! Host file: the channels of one part of an OpenEXR file, of which the largest level is read and nothing else is decoded.

use super::broken;
use crate::error::{Error, Result};
use crate::memory;
use ::exr::block::UncompressedBlock;
use ::exr::block::chunk::{Chunk, CompressedBlock};
use ::exr::meta::MetaData;
use ::exr::meta::attribute::SampleType;
use ::exr::meta::header::Header as Part;
use ::exr::prelude::{Compression, f16};
use rayon::prelude::*;
use std::io::Cursor;
use std::path::Path;

/// Chunks that are decoded before their samples are put in place.
const BATCH: usize = 64;

/// A row of samples: its channel among those that are wanted, where it begins, and its values.
type Row = (usize, usize, Vec<f32>);

/// The samples of these channels of a part, rows of its data window from the top.
///
/// # Errors
/// The part is broken or truncated, or stores a channel for every nth texel alone.
pub(super) fn read(
    file: &Path,
    bytes: &[u8],
    part: usize,
    wanted: &[usize],
) -> Result<Vec<Vec<f32>>> {
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
    let mut planes: Vec<Vec<f32>> = wanted.iter().map(|_| vec![0.0; width * height]).collect();
    let mut samples = 0;
    let mut chunks = chunks.into_iter();
    loop {
        let batch: Vec<Chunk> = chunks.by_ref().take(BATCH).collect();
        if batch.is_empty() {
            break;
        }
        let rows = batch.into_par_iter().map(|chunk| {
            let block = UncompressedBlock::decompress_chunk(chunk, &meta, false)?;
            rows_of(&block, &header, wanted)
        });
        let rows: Vec<Vec<Row>> = rows.collect::<::exr::error::Result<_>>().map_err(fail)?;
        for (plane, at, values) in rows.into_iter().flatten() {
            let target = planes[plane].get_mut(at..at + values.len());
            let target = target.ok_or_else(|| missing(file))?;
            target.copy_from_slice(&values);
            samples += values.len();
        }
    }
    match samples == wanted.len() * width * height {
        true => Ok(planes),
        false => Err(missing(file)),
    }
}

fn missing(file: &Path) -> Error {
    Error::input(file, "it is broken: some of its blocks are missing")
        .fix("copy or export it again")
}

/// The rows of a block that belong to channels that are wanted.
fn rows_of(
    block: &UncompressedBlock,
    header: &Part,
    wanted: &[usize],
) -> ::exr::error::Result<Vec<Row>> {
    let mut rows = Vec::new();
    for line in block.lines(&header.channels) {
        let index = line.location;
        let at = index.position.y() * header.layer_size.x() + index.position.x();
        for (plane, _) in wanted
            .iter()
            .enumerate()
            .filter(|(_, w)| **w == index.channel)
        {
            let values = match header.channels.list[index.channel].sample_type {
                SampleType::F16 => line
                    .read_samples::<f16>()
                    .map(|s| Ok(s?.to_f32()))
                    .collect::<::exr::error::Result<_>>()?,
                SampleType::F32 => line
                    .read_samples::<f32>()
                    .collect::<::exr::error::Result<_>>()?,
                SampleType::U32 => line
                    .read_samples::<u32>()
                    .map(|s| Ok(s? as f32))
                    .collect::<::exr::error::Result<_>>()?,
            };
            rows.push((plane, at, values));
        }
    }
    Ok(rows)
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
