//! Host file: what a method continues from, saved between runs: `--state-out` and `--state-in`.
//!
//! A line of text that names the format, the length of a header, the header in JSON, then arrays as they lie in memory (little-endian),
//! and the SHA-256 of all of it. The arrays of `cells` are entries and counts; those of `smc` light map, rays and particles.

use super::atomic::{Pending, prepare_folder_of};
use super::target::{Guard, Target};
use crate::error::{Error, Result};
use crate::shot::digest::Hash;
use glam::{Mat4, UVec2, Vec2, Vec3, Vec4};
use glimt_render_gpu::kernels::camera::CameraView;
use glimt_render_gpu::kernels::cell_state::{COUNT_WORDS, TileEntry};
use glimt_render_gpu::kernels::past::RayState;
use glimt_render_gpu::methods::{Method, MethodMemory};
use glimt_render_gpu::prepare::cells_state::{CellsKey, CellsState};
use glimt_render_gpu::prepare::past_frame::PastFrame;
use glimt_render_gpu::prepare::smc_state::{SmcKey, SmcState};
use glimt_smc::Particle;
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};
use std::fs::File;
use std::io::{Read, Write};
use std::path::Path;

const MAGIC: &[u8] = b"glimt state of a method 2\n";

/// Where a state may be written: where nothing is, or another state.
///
/// # Errors
/// Something else is there, or a state that is read.
pub fn target(guard: &Guard, file: &Path) -> Result<Target> {
    let is_there = std::fs::metadata(file).is_ok_and(|data| data.is_file() && data.len() > 0);
    let is_state = || {
        let mut start = [0; MAGIC.len()];
        let mut reader = File::open(file).ok()?;
        reader.read_exact(&mut start).ok()?;
        Some(start == MAGIC)
    };
    if is_there && is_state() != Some(true) {
        let what = "it is there already, and it is not a state of this version";
        return Err(Error::usage(what)
            .file(file)
            .fix("name another with --state-out"));
    }
    let target = guard.target(file)?;
    prepare_folder_of(&target)?;
    Ok(target)
}

/// The most bytes of a state by a method: of a light of `texels` texels, of an image of a size with `rays_per_pixel` rays a pixel, and of
/// `objects` objects.
#[must_use]
pub fn bytes(method: &Method, texels: u64, size: UVec2, rays_per_pixel: u32, objects: u64) -> u64 {
    let header = 4096 + 32 * 16 * objects;
    let light = match method {
        Method::Smc(_) => texels * size_of::<Vec4>() as u64,
        _ => 0,
    };
    header + light + method.kept_bytes(size, rays_per_pixel).all
}

/// A saved state.
#[derive(Clone, Debug)]
pub struct Saved {
    /// The state.
    pub memory: MethodMemory,
    /// Hash of everything that it came from: shot, lights, frames.
    pub chain: Hash,
    /// Hash of the shot and its meshes.
    pub setup: Hash,
}

impl Saved {
    /// The number of the frame that it is of.
    #[must_use]
    pub fn frame(&self) -> i32 {
        past_of(&self.memory).map_or(0, |past| past.frame.cast_signed())
    }
}

/// What stands before the arrays.
#[derive(Clone, Debug, Deserialize, Serialize)]
struct Header {
    chain: Hash,
    setup: Hash,
    key: Key,
    frame: i32,
    /// Eye, forward, right, up.
    view: [[f32; 3]; 4],
    transforms: Vec<[f32; 16]>,
    light_size: [u32; 2],
    light_rotation: [f32; 2],
    light_mean: f32,
}

/// The method, and what frames must have in common.
#[derive(Clone, Copy, Debug, Deserialize, Serialize)]
#[serde(tag = "method", rename_all = "lowercase")]
enum Key {
    Cells {
        size: [u32; 2],
        seed: u32,
    },
    Smc {
        size: [u32; 2],
        rays_per_pixel: u32,
        particles: u32,
        seed: u32,
    },
}

impl Key {
    fn of(memory: &MethodMemory) -> Option<Self> {
        match memory {
            MethodMemory::Cells(state) => Some(Self::Cells {
                size: state.key.size.to_array(),
                seed: state.key.seed,
            }),
            MethodMemory::Smc(state) => Some(Self::Smc {
                size: state.key.size.to_array(),
                rays_per_pixel: state.key.rays_per_pixel,
                particles: state.key.particles,
                seed: state.key.seed,
            }),
            _ => None,
        }
    }
}

fn past_of(memory: &MethodMemory) -> Option<&PastFrame> {
    match memory {
        MethodMemory::Cells(state) => Some(&state.past),
        MethodMemory::Smc(state) => Some(&state.past),
        _ => None,
    }
}

fn arrays_of(memory: &MethodMemory) -> Vec<&[u8]> {
    match memory {
        MethodMemory::Cells(state) => vec![
            bytemuck::cast_slice(&state.entries),
            bytemuck::cast_slice(&state.counts),
        ],
        MethodMemory::Smc(state) => vec![
            bytemuck::cast_slice(&state.light),
            bytemuck::cast_slice(&state.rays),
            bytemuck::cast_slice(&state.particles),
        ],
        _ => Vec::new(),
    }
}

/// Writes a state, and gives its file the name.
///
/// # Errors
/// The file cannot be written.
pub fn write(pending: &mut Pending, saved: &Saved) -> Result<()> {
    let pair = Key::of(&saved.memory).zip(past_of(&saved.memory));
    let (key, past) = pair.ok_or_else(|| {
        Error::usage("this version has no file for what the method keeps").file(pending.target())
    })?;
    let view = &past.view;
    let header = Header {
        chain: saved.chain,
        setup: saved.setup,
        key,
        frame: past.frame.cast_signed(),
        view: [view.eye, view.forward, view.right, view.up].map(|v| v.to_array()),
        transforms: past.transforms.iter().map(Mat4::to_cols_array).collect(),
        light_size: past.light_size.to_array(),
        light_rotation: past.light_rotation.to_array(),
        light_mean: past.light_mean,
    };
    let header = serde_json::to_vec(&header).expect("a header is plain data");
    let length = (header.len() as u32).to_le_bytes();
    let before: [&[u8]; 3] = [MAGIC, &length, &header];
    let mut hasher = Sha256::new();
    for part in before.into_iter().chain(arrays_of(&saved.memory)) {
        hasher.update(part);
        pending.write_all(part).map_err(|e| pending.error(&e))?;
    }
    let hash: Hash = hasher.finalize().into();
    pending.write_all(&hash).map_err(|e| pending.error(&e))?;
    pending.commit()
}

/// The hashes of everything that a state came from and of its shot, of a file that need not be there; its arrays are not looked at.
#[must_use]
pub fn read_hashes(file: &Path) -> Option<[Hash; 2]> {
    let mut reader = File::open(file).ok()?;
    let mut bytes = vec![0; MAGIC.len() + 4];
    reader.read_exact(&mut bytes).ok()?;
    if !bytes.starts_with(MAGIC) {
        return None;
    }
    let length = *bytes.last_chunk::<4>()?;
    let most = u64::from(u32::from_le_bytes(length));
    reader.take(most).read_to_end(&mut bytes).ok()?;
    let (header, _) = header(&bytes)?;
    Some([header.chain, header.setup])
}

/// The header, and what follows it.
fn header(bytes: &[u8]) -> Option<(Header, &[u8])> {
    let rest = bytes.strip_prefix(MAGIC)?;
    let (length, rest) = rest.split_first_chunk::<4>()?;
    let (header, rest) = rest.split_at_checked(u32::from_le_bytes(*length) as usize)?;
    Some((serde_json::from_slice(header).ok()?, rest))
}

/// Reads a state.
///
/// # Errors
/// The file cannot be read, is none of ours, or is not whole.
pub fn read(file: &Path) -> Result<Saved> {
    let bytes = std::fs::read(file).map_err(|e| Error::reading(file, &e))?;
    let none_of_ours = || {
        Error::input(file, "it is not a state that this version knows")
            .fix("write it again with --state-out")
    };
    let broken = || {
        Error::input(file, "the state is damaged or cut short")
            .fix("write it again with --state-out")
    };
    if !bytes.starts_with(MAGIC) {
        return Err(none_of_ours());
    }
    let (whole, hash) = bytes.split_last_chunk::<32>().ok_or_else(broken)?;
    if Sha256::digest(whole).as_slice() != hash {
        return Err(broken());
    }
    let (header, arrays) = header(whole).ok_or_else(none_of_ours)?;
    let [eye, forward, right, up] = header.view.map(Vec3::from);
    let transforms = header.transforms.iter().map(Mat4::from_cols_array);
    let past = PastFrame {
        frame: header.frame.cast_unsigned(),
        view: CameraView {
            eye,
            forward,
            right,
            up,
        },
        transforms: transforms.collect(),
        light_size: UVec2::from(header.light_size),
        light_rotation: Vec2::from(header.light_rotation),
        light_mean: header.light_mean,
    };
    Ok(Saved {
        chain: header.chain,
        setup: header.setup,
        memory: memory(header.key, past, arrays).ok_or_else(broken)?,
    })
}

/// What the arrays hold; `None` where they are of another length.
fn memory(key: Key, past: PastFrame, arrays: &[u8]) -> Option<MethodMemory> {
    let objects = past.transforms.len() as u32;
    let (memory, rest) = match key {
        Key::Cells { size, seed } => {
            let key = CellsKey {
                size: UVec2::from(size),
                seed,
                objects,
            };
            let count = key.entries();
            let (entries, arrays) = take::<TileEntry>(arrays, count)?;
            let (counts, rest) = take::<u32>(arrays, count * COUNT_WORDS as usize)?;
            let state = CellsState {
                key,
                past,
                entries,
                counts,
            };
            (MethodMemory::Cells(state), rest)
        }
        Key::Smc {
            size,
            rays_per_pixel,
            particles,
            seed,
        } => {
            let pixels = size.iter().map(|n| *n as usize).product::<usize>();
            let count = pixels * rays_per_pixel as usize;
            let texels = past.light_size.x as usize * past.light_size.y as usize;
            let (light, arrays) = take::<Vec4>(arrays, texels)?;
            let (rays, arrays) = take::<RayState>(arrays, count)?;
            let (sets, rest) = take::<Particle>(arrays, count * particles as usize)?;
            let state = SmcState {
                key: SmcKey {
                    size: UVec2::from(size),
                    rays_per_pixel,
                    particles,
                    seed,
                    objects,
                },
                past,
                light,
                rays,
                particles: sets,
            };
            (MethodMemory::Smc(state), rest)
        }
    };
    rest.is_empty().then_some(memory)
}

/// The first `count` values of some bytes, and the bytes after them.
fn take<T: bytemuck::AnyBitPattern + bytemuck::NoUninit>(
    bytes: &[u8],
    count: usize,
) -> Option<(Vec<T>, &[u8])> {
    let (these, rest) = bytes.split_at_checked(count.checked_mul(size_of::<T>())?)?;
    let mut values = vec![T::zeroed(); count];
    bytemuck::cast_slice_mut::<T, u8>(&mut values).copy_from_slice(these);
    Some((values, rest))
}
