//! Host file: what the sequential sampler continues from, saved between runs: `--state-out` and `--state-in`.
//!
//! A line of text that names the format, the length of a header, the header in JSON, then light map, rays and particles as they
//! lie in memory (little-endian), and the SHA-256 of all of it.

use super::atomic::{Pending, prepare_folder_of};
use super::target::{Guard, Target};
use crate::error::{Error, Result};
use crate::shot::digest::Hash;
use glam::{Mat4, UVec2, Vec2, Vec3, Vec4};
use glimt_render_gpu::kernels::camera::CameraView;
use glimt_render_gpu::kernels::past::RayState;
use glimt_render_gpu::prepare::smc_state::{PastFrame, SmcKey, SmcState};
use glimt_smc::Particle;
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};
use std::fs::File;
use std::io::{Read, Write};
use std::path::Path;

const MAGIC: &[u8] = b"glimt sequential sampler 1\n";

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
        let what = "it is there already, and it is not a state of the sequential sampler";
        return Err(Error::usage(what)
            .file(file)
            .fix("name another with --state-out"));
    }
    let target = guard.target(file)?;
    prepare_folder_of(&target)?;
    Ok(target)
}

/// The most bytes of a state: of a light of `texels` texels, of `rays` rays with `particles` particles each, and of `objects` objects.
#[must_use]
pub fn bytes(texels: u64, rays: u64, particles: u64, objects: u64) -> u64 {
    let header = 4096 + 32 * 16 * objects;
    let set = size_of::<RayState>() as u64 + particles * size_of::<Particle>() as u64;
    header + texels * size_of::<Vec4>() as u64 + rays * set
}

/// A saved state.
#[derive(Clone, Debug)]
pub struct Saved {
    /// The state.
    pub state: SmcState,
    /// Hash of everything that it came from: shot, lights, frames.
    pub chain: Hash,
    /// Hash of the shot and its meshes.
    pub setup: Hash,
}

/// What stands before the arrays.
#[derive(Clone, Debug, Deserialize, Serialize)]
struct Header {
    chain: Hash,
    setup: Hash,
    frame: i32,
    size: [u32; 2],
    rays_per_pixel: u32,
    particles: u32,
    seed: u32,
    /// Eye, forward, right, up.
    view: [[f32; 3]; 4],
    transforms: Vec<[f32; 16]>,
    light_size: [u32; 2],
    light_rotation: [f32; 2],
    light_mean: f32,
}

/// Writes a state, and gives its file the name.
///
/// # Errors
/// The file cannot be written.
pub fn write(pending: &mut Pending, saved: &Saved) -> Result<()> {
    let past = &saved.state.past;
    let header = Header {
        chain: saved.chain,
        setup: saved.setup,
        frame: past.frame.cast_signed(),
        size: past.key.size.to_array(),
        rays_per_pixel: past.key.rays_per_pixel,
        particles: past.key.particles,
        seed: past.key.seed,
        view: [
            past.view.eye,
            past.view.forward,
            past.view.right,
            past.view.up,
        ]
        .map(|v| v.to_array()),
        transforms: past.transforms.iter().map(Mat4::to_cols_array).collect(),
        light_size: past.light_size.to_array(),
        light_rotation: past.light_rotation.to_array(),
        light_mean: past.light_mean,
    };
    let header = serde_json::to_vec(&header).expect("a header is plain data");
    let length = (header.len() as u32).to_le_bytes();
    let parts: [&[u8]; 6] = [
        MAGIC,
        &length,
        &header,
        bytemuck::cast_slice(&saved.state.light),
        bytemuck::cast_slice(&saved.state.rays),
        bytemuck::cast_slice(&saved.state.particles),
    ];
    let mut hasher = Sha256::new();
    for part in parts {
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
        Error::input(
            file,
            "it is not a state of the sequential sampler that this version knows",
        )
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
    let pixels = header.size.iter().map(|n| *n as usize).product::<usize>();
    let rays = pixels * header.rays_per_pixel as usize;
    let texels = header.light_size.iter().map(|n| *n as usize).product();
    let (light, arrays) = take::<Vec4>(arrays, texels).ok_or_else(broken)?;
    let (states, arrays) = take::<RayState>(arrays, rays).ok_or_else(broken)?;
    let sets = rays * header.particles as usize;
    let (particles, arrays) = take::<Particle>(arrays, sets).ok_or_else(broken)?;
    if !arrays.is_empty() {
        return Err(broken());
    }
    let [eye, forward, right, up] = header.view.map(Vec3::from);
    Ok(Saved {
        chain: header.chain,
        setup: header.setup,
        state: SmcState {
            past: PastFrame {
                key: SmcKey {
                    size: UVec2::from(header.size),
                    rays_per_pixel: header.rays_per_pixel,
                    particles: header.particles,
                    seed: header.seed,
                    objects: header.transforms.len() as u32,
                },
                frame: header.frame.cast_unsigned(),
                view: CameraView {
                    eye,
                    forward,
                    right,
                    up,
                },
                transforms: header
                    .transforms
                    .iter()
                    .map(Mat4::from_cols_array)
                    .collect(),
                light_size: UVec2::from(header.light_size),
                light_rotation: Vec2::from(header.light_rotation),
                light_mean: header.light_mean,
            },
            light,
            rays: states,
            particles,
        },
    })
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
