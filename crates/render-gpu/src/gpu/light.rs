//! Host file: a frame's light as spherical harmonics on the GPU (Hajisharif 2012, Eqs. 9 to 13): upload, halving, projection,
//! filter over time.

use glam::{UVec2, Vec2, Vec4};
use glimt_sh::{MAX_COEFFICIENTS, ShError, temporal_filter};

use super::buffer::GpuBuffer;
use super::device::GpuContext;
use super::error::GpuError;
use super::launch::Arg;
use super::record::{ParamsPool, Recording};
use crate::entry::{BufferSlot, Entry, ParamField, ParamsSpace};
use crate::generated::{HALVE, LIGHT_COEFFICIENT, TAPS};
use crate::host::env::{Brightness, PreparedEnv};
use crate::host::light_sh::{level_sizes, light_params};
use crate::host::render::{PrtSettings, SettingsError};
use crate::kernels::pyramid::Taps;

/// Rows and columns of texels that a workgroup of `projection.wgsl` projects.
const GROUP: UVec2 = UVec2::new(256, 16);
/// Coefficients of the most bands, and values that a workgroup leaves.
const COEFFICIENTS: u32 = MAX_COEFFICIENTS as u32;

const VALUE: u64 = size_of::<Vec4>() as u64;

const fn field(path: &'static str, offset: u32, size: u32) -> ParamField {
    ParamField { path, offset, size }
}

const fn slot(path: &'static str, binding: u32, writable: bool) -> BufferSlot {
    BufferSlot {
        path,
        binding,
        stride: 16,
        writable,
    }
}

/// Both stages of `projection.wgsl` have the same arguments.
pub(super) const PARAMS: &[ParamField] = &[
    field("size", 0, 8),
    field("bands", 8, 4),
    field("parts", 12, 4),
];
const BUFFERS: &[BufferSlot] = &[slot("values", 1, false), slot("out", 2, true)];

pub(super) const WGSL: &str = concat!(
    include_str!("../generated/projection_functions.wgsl"),
    include_str!("projection.wgsl")
);

const fn by_hand(name: &'static str) -> Entry {
    Entry {
        name,
        kernel: "",
        wgsl: WGSL,
        workgroup_size: 256,
        params_size: 16,
        params_in: ParamsSpace::Storage,
        params: PARAMS,
        buffers: BUFFERS,
    }
}

const PROJECT: Entry = by_hand("project");
const SUM_PARTS: Entry = by_hand("sum_parts");

/// A light map on the GPU without tables, and the coefficients that are made of it, frame after frame: what
/// [`LightSh`](crate::host::light_sh::LightSh) is on the CPU.
#[derive(Debug)]
pub struct GpuLight {
    pub(super) map: GpuBuffer,
    pub(super) size: UVec2,
    pub(super) rotation: Vec2,
    pub(super) brightness: Brightness,
    /// [`Brightness::mean`] of what the coefficients that were made last are of: filtered over time, as they are.
    pub(super) mean: f32,
    /// The maps halved, the largest first.
    levels: Vec<Level>,
    parts: GpuBuffer,
    sums: GpuBuffer,
    /// Of the frame before and of this one.
    coefficients: [GpuBuffer; 2],
    /// Bands of the frame before.
    before: Option<u32>,
    pool: ParamsPool,
}

/// A map halved.
#[derive(Debug)]
struct Level {
    /// Of the map that it is half of.
    taps: GpuBuffer,
    texels: GpuBuffer,
    /// Whether there are taps: they are made with the first map.
    has_taps: bool,
}

impl GpuLight {
    /// Room for light maps of size `size`. It grows where a later one is of another size.
    ///
    /// # Errors
    /// [`GpuError::Limit`] where such a map is larger than a binding may be; what the kernels' compilation finds.
    pub fn new(context: &GpuContext, size: UVec2) -> Result<Self, GpuError> {
        for entry in [&TAPS, &HALVE, &PROJECT, &SUM_PARTS, &LIGHT_COEFFICIENT] {
            context.prepare(entry)?;
        }
        let all = u64::from(COEFFICIENTS) * VALUE;
        Ok(Self {
            map: map_buffer(context, size)?,
            size,
            rotation: Vec2::X,
            brightness: Brightness::default(),
            mean: 0.0,
            levels: Vec::new(),
            parts: context.buffer("partial sums", all)?,
            sums: context.buffer("sums", all)?,
            coefficients: [
                context.buffer("previous", all)?,
                context.buffer("coefficients", all)?,
            ],
            before: None,
            pool: ParamsPool::default(),
        })
    }

    /// Puts a frame's light map in the place of the last one.
    ///
    /// # Errors
    /// As [`GpuLight::new`].
    pub fn upload(&mut self, context: &GpuContext, env: &PreparedEnv) -> Result<(), GpuError> {
        let map = env.view().map();
        if map.size != self.size {
            self.map = map_buffer(context, map.size)?;
            self.levels.clear();
            self.size = map.size;
        }
        context.write(&self.map, map.texels)?;
        self.rotation = map.rotation;
        self.brightness = env.brightness();
        Ok(())
    }

    /// The next frame starts anew, and goes by nothing that was recorded and perhaps never handed over.
    pub fn forget(&mut self) {
        self.before = None;
        for level in &mut self.levels {
            level.has_taps = false;
        }
    }

    /// Makes the coefficients of the map that was uploaded last, without waiting for them: [`GpuLight::read`].
    ///
    /// # Errors
    /// [`GpuError::Argument`] where `bands` is not 1 to 6, or the settings are refused; those of [`GpuContext::launch`].
    pub fn project(
        &mut self,
        context: &GpuContext,
        bands: u32,
        settings: &PrtSettings,
    ) -> Result<(), GpuError> {
        let mut pool = std::mem::take(&mut self.pool);
        let mut recording = Recording::new(context, &mut pool);
        let recorded = self.record(&mut recording, bands, settings);
        let done = recorded.and_then(|()| recording.submit());
        self.pool = pool;
        if done.is_err() {
            self.forget();
        }
        done.map(drop)
    }

    /// The coefficients that were made last, copied back: 36, of which those beyond `bands²` are 0.
    ///
    /// # Errors
    /// As [`GpuContext::read`].
    pub fn read(&self, context: &GpuContext) -> Result<Vec<Vec4>, GpuError> {
        context.read(self.coefficients(), COEFFICIENTS as usize)
    }

    /// The coefficients that were made last.
    pub(super) fn coefficients(&self) -> &GpuBuffer {
        &self.coefficients[1]
    }

    pub(super) fn record(
        &mut self,
        recording: &mut Recording<'_>,
        bands: u32,
        settings: &PrtSettings,
    ) -> Result<(), GpuError> {
        let refused = |error: SettingsError| GpuError::Argument {
            entry: PROJECT.name.to_owned(),
            problem: error.to_string(),
        };
        settings.check().map_err(refused)?;
        if !(1..=glimt_sh::MAX_BANDS).contains(&bands) {
            return Err(refused(SettingsError::Harmonics(ShError::Bands(bands))));
        }
        let sizes = self.keep_levels(recording.context, settings.level)?;
        for (i, pair) in sizes.windows(2).enumerate() {
            let (done, rest) = self.levels.split_at_mut(i);
            let from = done.last().map_or(&self.map, |level| &level.texels);
            let (level, half) = (&mut rest[0], pair[1]);
            let size = ("size", Arg::Value(bytemuck::bytes_of(&pair[0])));
            if !level.has_taps {
                let args = [size, ("out", Arg::Buffer(&level.taps))];
                recording.dispatch(&TAPS, &args, half.element_sum())?;
                level.has_taps = true;
            }
            let args = [
                size,
                ("taps", Arg::Buffer(&level.taps)),
                ("texels", Arg::Buffer(from)),
                ("out", Arg::Buffer(&level.texels)),
            ];
            recording.dispatch(&HALVE, &args, half.element_product())?;
        }
        let (size, texels) = match sizes.len() {
            1 => (&self.size, &self.map),
            levels => (&sizes[levels - 1], &self.levels[levels - 2].texels),
        };
        let groups = groups(*size);
        let parts = groups.element_product();
        let params = |values, out| {
            [
                ("size", Arg::Value(bytemuck::bytes_of(size))),
                ("bands", Arg::Value(bytemuck::bytes_of(&bands))),
                ("parts", Arg::Value(bytemuck::bytes_of(&parts))),
                ("values", Arg::Buffer(values)),
                ("out", Arg::Buffer(out)),
            ]
        };
        let count = parts * COEFFICIENTS;
        let args = params(texels, &self.parts);
        recording.dispatch_grid(&PROJECT, &args, count, groups.to_array())?;
        let args = params(&self.parts, &self.sums);
        let grid = [bands * bands, 1];
        recording.dispatch_grid(&SUM_PARTS, &args, COEFFICIENTS, grid)?;

        self.coefficients.swap(0, 1);
        let light = light_params(settings, self.rotation, bands, self.before);
        let args = [
            ("light", Arg::Value(bytemuck::bytes_of(&light))),
            ("sums", Arg::Buffer(&self.sums)),
            ("previous", Arg::Buffer(&self.coefficients[0])),
            ("out", Arg::Buffer(&self.coefficients[1])),
        ];
        recording.dispatch(&LIGHT_COEFFICIENT, &args, COEFFICIENTS)?;
        self.mean = temporal_filter(self.brightness.mean, self.mean, light.temporal);
        self.before = Some(bands);
        Ok(())
    }

    /// Room for the map halved `level` times. Gives the sizes, with the map's own.
    fn keep_levels(&mut self, context: &GpuContext, level: u32) -> Result<Vec<UVec2>, GpuError> {
        let sizes = level_sizes(self.size, level);
        for size in &sizes[(self.levels.len() + 1).min(sizes.len())..] {
            let taps = u64::from(size.element_sum()) * size_of::<Taps>() as u64;
            self.levels.push(Level {
                taps: context.buffer("taps", taps)?,
                texels: map_buffer(context, *size)?,
                has_taps: false,
            });
        }
        let parts = groups(sizes[sizes.len() - 1]).element_product();
        let bytes = u64::from(parts * COEFFICIENTS) * VALUE;
        if self.parts.len() < bytes {
            self.parts = context.buffer("partial sums", bytes)?;
        }
        Ok(sizes)
    }
}

/// Workgroups of a projection.
fn groups(size: UVec2) -> UVec2 {
    UVec2::new(size.x.div_ceil(GROUP.x), size.y.div_ceil(GROUP.y))
}

fn map_buffer(context: &GpuContext, size: UVec2) -> Result<GpuBuffer, GpuError> {
    let bytes = u64::from(size.x) * u64::from(size.y) * VALUE;
    let allowed = context.max_binding_bytes();
    if bytes > allowed {
        let limit = "max_storage_buffer_binding_size";
        return Err(context.limit_error("the light map".to_owned(), bytes, limit, allowed));
    }
    context.buffer("the light map", bytes)
}
