//! Host file: a frame's light as spherical harmonics on the GPU (Hajisharif 2012, Eqs. 9 to 13): upload, halving, projection,
//! filter over time.

use glam::{UVec2, Vec2, Vec4};
use glimt_sh::{MAX_COEFFICIENTS, ShError, temporal_filter};

use std::borrow::Cow::Borrowed;

use glimt_executor::gpu::{Arg, GpuContext, GpuError, GpuVec, ParamsPool, Recording};
use glimt_executor::{BufferSlot, Entry, Executor, ParamField, ParamsSpace};

use crate::generated::entries::{HALVE, LIGHT_COEFFICIENT, TAPS};
use crate::generated::passes::{Halve, LightCoefficient, Taps};
use crate::kernels::pyramid;
use crate::methods::Prt;
use crate::prepare::env::{Brightness, PreparedEnv};
use crate::prepare::light_sh::{level_sizes, light_params};
use crate::prepare::render::SettingsError;

/// Rows and columns of texels that a workgroup of `projection.wgsl` projects.
const GROUP: UVec2 = UVec2::new(256, 16);
/// Coefficients of the most bands, and values that a workgroup leaves.
const COEFFICIENTS: u32 = MAX_COEFFICIENTS as u32;

/// Both stages of `projection.wgsl` have the same arguments.
pub(super) const PARAMS: &[ParamField] = &[
    ParamField::new("size", 0, 8),
    ParamField::new("bands", 8, 4),
    ParamField::new("parts", 12, 4),
];
const BUFFERS: &[BufferSlot] = &[
    BufferSlot::new("values", 1, 16, false),
    BufferSlot::new("out", 2, 16, true),
];

pub(super) const WGSL: &str = concat!(
    include_str!("../generated/projection_functions.wgsl"),
    include_str!("projection.wgsl")
);

const fn by_hand(name: &'static str) -> Entry {
    Entry {
        name: Borrowed(name),
        kernel: Borrowed(""),
        wgsl: Borrowed(WGSL),
        workgroup_size: 256,
        params_size: 16,
        params_space: ParamsSpace::Storage,
        params: Borrowed(PARAMS),
        buffers: Borrowed(BUFFERS),
    }
}

static PROJECT: Entry = by_hand("project");
static SUM_PARTS: Entry = by_hand("sum_parts");

/// A light map on the GPU without tables, and the coefficients that are made of it, frame after frame: what
/// [`LightSh`](crate::prepare::light_sh::LightSh) is on the CPU.
#[derive(Debug)]
pub struct GpuLight {
    pub(super) map: GpuVec<Vec4>,
    pub(super) size: UVec2,
    pub(super) rotation: Vec2,
    pub(super) brightness: Brightness,
    /// [`Brightness::mean`] of what the coefficients that were made last are of: filtered over time, as they are.
    pub(super) mean: f32,
    /// The maps halved, the largest first.
    levels: Vec<Level>,
    parts: GpuVec<Vec4>,
    sums: GpuVec<Vec4>,
    /// Of the frame before and of this one.
    coefficients: [GpuVec<Vec4>; 2],
    /// Bands of the frame before.
    before: Option<u32>,
    pool: ParamsPool,
}

/// A map halved.
#[derive(Debug)]
struct Level {
    /// Of the map that it is half of.
    taps: GpuVec<pyramid::Taps>,
    texels: GpuVec<Vec4>,
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
        let all = u64::from(COEFFICIENTS);
        Ok(Self {
            map: map_buffer(context, size)?,
            size,
            rotation: Vec2::X,
            brightness: Brightness::default(),
            mean: 0.0,
            levels: Vec::new(),
            parts: context.zeroed("partial sums", all)?,
            sums: context.zeroed("sums", all)?,
            coefficients: [
                context.zeroed("previous", all)?,
                context.zeroed("coefficients", all)?,
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

    /// The filter over time restarts with the next frame, which uses nothing that was recorded and perhaps never submitted.
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
        settings: &Prt,
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
    pub(super) fn coefficients(&self) -> &GpuVec<Vec4> {
        &self.coefficients[1]
    }

    pub(super) fn record(
        &mut self,
        recording: &mut Recording<'_>,
        bands: u32,
        settings: &Prt,
    ) -> Result<(), GpuError> {
        let refused = |error: SettingsError| GpuError::Argument {
            entry: PROJECT.name.clone().into_owned(),
            problem: error.to_string(),
        };
        settings.check().map_err(|error| refused(error.into()))?;
        if !(1..=glimt_sh::MAX_BANDS).contains(&bands) {
            return Err(refused(SettingsError::Harmonics(ShError::Bands(bands))));
        }
        let sizes = self.keep_levels(recording.context(), settings.level)?;
        for (i, pair) in sizes.windows(2).enumerate() {
            let (done, rest) = self.levels.split_at_mut(i);
            let from = done.last().map_or(&self.map, |level| &level.texels);
            let (level, half) = (&mut rest[0], pair[1]);
            let size = pair[0];
            if !level.has_taps {
                let out = level.taps.out();
                recording.run(Taps { size, out }, 0..half.element_sum())?;
                level.has_taps = true;
            }
            let pass = Halve {
                size,
                taps: level.taps.all(),
                texels: from.all(),
                out: level.texels.out(),
            };
            recording.run(pass, 0..half.element_product())?;
        }
        let (size, texels) = match sizes.len() {
            1 => (&self.size, &self.map),
            levels => (&sizes[levels - 1], &self.levels[levels - 2].texels),
        };
        let groups = groups(*size);
        let parts = groups.element_product();
        let params = [
            ("size", Arg::Value(bytemuck::bytes_of(size))),
            ("bands", Arg::Value(bytemuck::bytes_of(&bands))),
            ("parts", Arg::Value(bytemuck::bytes_of(&parts))),
        ];
        let count = parts * COEFFICIENTS;
        let slices = [
            ("values", Arg::Buffer(texels)),
            ("out", Arg::Buffer(&self.parts)),
        ];
        let args = [&params[..], &slices].concat();
        recording.dispatch_grid(&PROJECT, &args, count, groups.to_array())?;
        let slices = [
            ("values", Arg::Buffer(&self.parts)),
            ("out", Arg::Buffer(&self.sums)),
        ];
        let args = [&params[..], &slices].concat();
        let grid = [bands * bands, 1];
        recording.dispatch_grid(&SUM_PARTS, &args, COEFFICIENTS, grid)?;

        self.coefficients.swap(0, 1);
        let light = light_params(settings, self.rotation, bands, self.before);
        let pass = LightCoefficient {
            light: &light,
            sums: self.sums.all(),
            previous: self.coefficients[0].all(),
            out: self.coefficients[1].out(),
        };
        recording.run(pass, 0..COEFFICIENTS)?;
        self.mean = temporal_filter(self.brightness.mean, self.mean, light.temporal);
        self.before = Some(bands);
        Ok(())
    }

    /// Room for the map halved `level` times. Gives the sizes, with the map's own.
    fn keep_levels(&mut self, context: &GpuContext, level: u32) -> Result<Vec<UVec2>, GpuError> {
        let sizes = level_sizes(self.size, level);
        for size in &sizes[(self.levels.len() + 1).min(sizes.len())..] {
            self.levels.push(Level {
                taps: context.zeroed("taps", size.element_sum().into())?,
                texels: map_buffer(context, *size)?,
                has_taps: false,
            });
        }
        let parts = groups(sizes[sizes.len() - 1]).element_product();
        let values = u64::from(parts * COEFFICIENTS);
        if self.parts.count() < values {
            self.parts = context.zeroed("partial sums", values)?;
        }
        Ok(sizes)
    }
}

/// Workgroups of a projection.
fn groups(size: UVec2) -> UVec2 {
    UVec2::new(size.x.div_ceil(GROUP.x), size.y.div_ceil(GROUP.y))
}

fn map_buffer(context: &GpuContext, size: UVec2) -> Result<GpuVec<Vec4>, GpuError> {
    context.zeroed_binding("the light map", u64::from(size.x) * u64::from(size.y))
}
