//! Host file: frames by precomputed radiance transfer on the GPU (Hajisharif 2012, § 3.4 to 3.7), from the light map to the
//! composite without a wait.
//!
//! All passes of a frame go into one command encoder: light map → pyramid → projection → its reduction → filter over time →
//! light at the vertices → triangles drawn → layers → composite. Reading the image is the only wait.

use std::f32::consts::PI;
use std::time::{Duration, Instant};

use glam::{UVec2, Vec4};
use glimt_executor::gpu::{
    Gpu, GpuBuffer, GpuContext, GpuError, GpuVec, ParamsPool, Recording, Stopwatch,
};
use glimt_executor::{Executor, Memory};
use rayon::prelude::*;

use super::light::GpuLight;
use super::raster::{LAYERS, PIXEL, Rasteriser, Targets, pitch};
use super::renderer::device;
use super::upload::GpuScene;
use crate::film::Pixels;
use crate::generated::entries::{UNPACK_LAYERS, VERTEX_LIGHT};
use crate::generated::passes::{UnpackLayers, VertexLight};
use crate::kernels::composite::PlatePixel;
use crate::kernels::frame::FrameParams;
use crate::kernels::layers::PixelLayers;
use crate::kernels::prt;
use crate::kernels::raster::{DrawnLayout, HALF_MAX, RasterParams};
use crate::prepare::env::PreparedEnv;
use crate::prepare::plate::Plate;
use crate::prepare::render::{Filter, FrameImage, RenderError, RenderSettings, SettingsError};
use crate::prepare::scene_build::SceneBuffers;
use crate::prepare::transfer::{SceneTransfer, Transfer};

/// Samples of a pixel where there are several: what every adapter has.
const SAMPLES: u32 = 4;
/// Nothing is drawn nearer to the eye's plane than this share of the farthest point's distance. Depths are floats that grow towards the
/// eye, so how small it is takes nothing from their precision.
const NEAR: f32 = 1e-7;
/// Bytes of the layers of a band of rows; all bands are recorded one after the other, and share them.
const BAND_BYTES: u64 = 64 << 20;
/// Parts of buffers begin at multiples of 256 bytes on any adapter, so bands at multiples of so many pixels: a display value has
/// four bytes.
const BAND_GRANULE: u32 = 64;
/// Marks on the GPU's clock: before the light, after it, and after the composite.
const MARKS: usize = 3;

/// Where a drawn frame's time went. The GPU's times are by its own clock; a software adapter's may tell light from drawing badly.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct DrawTimes {
    /// Handing over light map and plate, and recording, as the host saw it.
    pub upload: Duration,
    /// From the light map to light at the vertices, on the GPU; 0 where it offers no timestamps.
    pub light: Duration,
    /// From there to the composite, on the GPU; 0 where it offers no timestamps.
    pub draw: Duration,
    /// Copies back to the host, and the wait for the GPU as far as it is not known what that did.
    pub read_back: Duration,
}

/// Draws scenes that have a transfer.
pub struct GpuPrt {
    light: GpuLight,
    transfer: Option<GpuTransfer>,
    /// For one sample, and for several; the same for scenes with surfaces that let light pass.
    rasterisers: [Option<Rasteriser>; 4],
    canvas: Option<Canvas>,
    pool: ParamsPool,
    marks: Option<Stopwatch>,
    drawn: Option<wgpu::SubmissionIndex>,
    times: DrawTimes,
}

impl GpuPrt {
    /// Compiles what every frame needs.
    ///
    /// # Errors
    /// As [`GpuContext::prepare`].
    pub fn new(context: &GpuContext) -> Result<Self, GpuError> {
        for entry in [&VERTEX_LIGHT, &UNPACK_LAYERS] {
            context.prepare(entry)?;
        }
        let marks = match context.has_timestamps() {
            true => Some(Stopwatch::new(context, MARKS)?),
            false => None,
        };
        Ok(Self {
            light: GpuLight::new(context, UVec2::ONE)?,
            transfer: None,
            rasterisers: [const { None }; 4],
            canvas: None,
            pool: ParamsPool::default(),
            marks,
            drawn: None,
            times: DrawTimes::default(),
        })
    }

    /// The filter over time restarts.
    pub fn forget(&mut self) {
        self.light.forget();
    }

    /// Where the time of the frame went that was drawn last, and read back.
    #[must_use]
    pub fn times(&self) -> &DrawTimes {
        &self.times
    }

    /// Draws a frame, over a plate of the same size or the background of the settings, and waits for nothing. `uploaded` is the
    /// scene.
    ///
    /// Frames that nobody waits for pile up: a caller that draws many must call [`GpuContext::finish`] now and then.
    ///
    /// With one ray a pixel, or all of them through its centre, pixels have one sample, at their centre; else four. What is behind
    /// objects is one value a pixel. Layers have 16 bits: of light that is mirrored, what is brighter than 10⁷ times the light's mean is
    /// darkened, and in its presence shadows below 10⁻⁴ of the mean lose bits. Faces nearer to the eye's plane than 10⁻⁷ of the farthest point's distance are cut off.
    ///
    /// # Errors
    /// [`SettingsError::NoTransfer`], and what is wrong with the settings; [`GpuError::Limit`] where the light map, a buffer of the
    /// scene or the image is larger than the adapter allows; [`GpuError::OutOfMemory`], [`GpuError::Lost`].
    pub fn draw(
        &mut self,
        context: &GpuContext,
        scene: &SceneBuffers,
        uploaded: &GpuScene,
        env: &PreparedEnv,
        plate: Option<&Plate>,
        settings: &RenderSettings,
    ) -> Result<(), RenderError> {
        let frame = settings.frame_params_over(plate)?;
        let known = scene.transfer().ok_or(SettingsError::NoTransfer)?;
        self.drawn = None;
        self.keep_transfer(context, known).map_err(device)?;
        self.keep_canvas(context, settings, plate, scene.is_see_through())
            .map_err(device)?;
        let started = Instant::now();
        self.light.upload(context, env).map_err(device)?;
        if let (Some(plate), Some(canvas)) = (plate, &self.canvas) {
            context
                .write(&canvas.plate, plate.pixels())
                .map_err(device)?;
        }
        let work = Work {
            frame,
            near: near(scene, &frame),
            bands: known.transfer().bands,
            has_plate: plate.is_some(),
        };
        let mut pool = std::mem::take(&mut self.pool);
        let done = self.record(context, &mut pool, uploaded, &work, settings);
        self.pool = pool;
        if done.is_err() {
            self.forget();
        }
        self.drawn = Some(done.map_err(device)?);
        self.times = DrawTimes {
            upload: started.elapsed(),
            ..DrawTimes::default()
        };
        Ok(())
    }

    /// The frame that was drawn last, with its layers where the settings asked for them. Waits for it.
    ///
    /// # Errors
    /// [`GpuError::Argument`] where none was; as [`GpuContext::read`].
    pub fn read(&mut self, context: &GpuContext) -> Result<FrameImage, GpuError> {
        let (Some(canvas), Some(submission)) = (&self.canvas, self.drawn.clone()) else {
            return Err(GpuError::Argument {
                entry: "a drawn frame".to_owned(),
                problem: "none was drawn".to_owned(),
            });
        };
        let started = Instant::now();
        if let Some(marks) = &self.marks {
            let passed = marks.read(context, submission)?;
            (self.times.light, self.times.draw) = (passed[0], passed[1]);
        }
        let pixels = canvas.size.element_product() as usize;
        let image = FrameImage {
            size: canvas.size,
            linear: context.read::<Vec4>(&canvas.pixels.linear, pixels)?,
            display: context.read::<[u8; 4]>(&canvas.pixels.display, pixels)?,
            layers: match canvas.keeps_layers {
                true => Some(context.read::<PixelLayers>(&canvas.pixels.layers, pixels)?),
                false => None,
            },
            diagnostics: None,
        };
        let on_gpu = self.times.light + self.times.draw;
        self.times.read_back = started.elapsed().saturating_sub(on_gpu);
        Ok(image)
    }

    fn keep_transfer(
        &mut self,
        context: &GpuContext,
        known: &SceneTransfer,
    ) -> Result<(), GpuError> {
        if self
            .transfer
            .as_ref()
            .is_none_or(|own| own.id != known.id())
        {
            // There may not be room for two.
            self.transfer = None;
            self.transfer = Some(GpuTransfer::new(context, known)?);
        }
        Ok(())
    }

    fn keep_canvas(
        &mut self,
        context: &GpuContext,
        settings: &RenderSettings,
        plate: Option<&Plate>,
        is_see_through: bool,
    ) -> Result<(), GpuError> {
        let samples = match settings.rays_per_pixel == 1 || settings.filter == Filter::Centre {
            true => 1,
            false => SAMPLES,
        };
        let rasteriser = &mut self.rasterisers[rasteriser_index(samples, is_see_through)];
        if rasteriser.is_none() {
            *rasteriser = Some(Rasteriser::new(context, samples, is_see_through)?);
        }
        let fits = |canvas: &Canvas| {
            canvas.size == settings.size
                && canvas.samples == samples
                && canvas.keeps_layers == settings.layers
                && (canvas.has_plate || plate.is_none())
        };
        if !self.canvas.as_ref().is_some_and(fits) {
            self.canvas = None;
            self.canvas = Some(Canvas::new(context, settings, samples, plate.is_some())?);
        }
        Ok(())
    }

    /// Records and hands over a frame whose light and plate are there.
    fn record(
        &mut self,
        context: &GpuContext,
        pool: &mut ParamsPool,
        scene: &GpuScene,
        work: &Work,
        settings: &RenderSettings,
    ) -> Result<wgpu::SubmissionIndex, GpuError> {
        let (Some(transfer), Some(canvas)) = (&self.transfer, &mut self.canvas) else {
            unreachable!("both are kept before");
        };
        let index = rasteriser_index(canvas.samples, scene.is_see_through());
        let Some(rasteriser) = &self.rasterisers[index] else {
            unreachable!("it is kept with the canvas");
        };
        let mut recording = Recording::new(context, pool);
        recording.mark(self.marks.as_ref(), 0);
        self.light
            .record(&mut recording, work.bands, &settings.prt)?;
        transfer.record(&mut recording, &self.light, settings.prt.shadows)?;
        recording.mark(self.marks.as_ref(), 1);

        let scale = layer_scale(work.frame.exposure, &self.light, transfer);
        let params = RasterParams {
            frame: work.frame,
            map_size: self.light.size,
            map_rotation: self.light.rotation,
            near: work.near,
            scale,
            samples: canvas.samples,
            unused: 0,
        };
        let buffers: [&GpuBuffer; 7] = [
            &scene.triangles,
            &scene.corners,
            &scene.surface,
            &transfer.corner_vertices,
            &transfer.reflections,
            &transfer.lights,
            &self.light.map,
        ];
        let count = scene.triangles();
        rasteriser.record(&mut recording, &canvas.targets, &params, buffers, count)?;
        canvas.composite(&mut recording, &self.light, work, scale)?;
        recording.mark(self.marks.as_ref(), 2);
        if let Some(marks) = &self.marks {
            marks.resolve(recording.encoder());
        }
        recording.submit()
    }
}

/// Where the rasteriser for so many samples a pixel stands among them.
fn rasteriser_index(samples: u32, is_see_through: bool) -> usize {
    2 * usize::from(is_see_through) + usize::from(samples > 1)
}

/// The factor on radiance in the drawn layers, which have 16 bits: the exposure, or the power of two below it, within what the light
/// calls for. It is at least so large that white under the light's mean is stored as 1/2 or more, since the linear image is not
/// exposed, and shadows are in it; 2⁻¹² of that still have all 11 bits. It is so small that nothing drawn outgrows 65 504.
///
/// A mirrored sun takes from the shadows, up to 2⁻⁸ of that. What is brighter than 10⁷ times the mean is darkened.
fn layer_scale(exposure: f32, light: &GpuLight, transfer: &GpuTransfer) -> f32 {
    let mirrored = transfer.largest_reflection * light.brightness.largest;
    scale_for(exposure, light.mean, transfer.largest_gain, mirrored)
}

/// As [`layer_scale`], for diffuse radiance of up to `gain` times the mean, and mirrored light.
fn scale_for(exposure: f32, mean: f32, gain: f32, mirrored: f32) -> f32 {
    let all = f64::from(mean) * f64::from(gain) + f64::from(mirrored);
    let mean = f64::from(mean);
    let scale = f64::from(exposure)
        .max(1.0 / mean)
        .min(f64::from(HALF_MAX) / all)
        .max(1.0 / (256.0 * mean));
    scale.log2().floor().clamp(-120.0, 120.0).exp2() as f32
}

/// What a frame's passes know beside the buffers.
struct Work {
    frame: FrameParams,
    near: f32,
    bands: u32,
    has_plate: bool,
}

/// Where drawing begins, for a scene seen from the frame's eye.
fn near(scene: &SceneBuffers, frame: &FrameParams) -> f32 {
    let (min, max) = scene.bounds();
    let far = (min - frame.eye)
        .abs()
        .max((max - frame.eye).abs())
        .length();
    (NEAR * far).max(1e-30)
}

/// A scene's transfer, and the light at its vertices.
#[derive(Debug)]
struct GpuTransfer {
    id: u64,
    vertices: u32,
    coefficients: u32,
    /// Diffuse radiance under light of mean 1 is at most this.
    largest_gain: f32,
    /// The largest c_k.
    largest_reflection: f32,
    lit: GpuVec<f32>,
    blocked: GpuVec<f32>,
    corner_vertices: GpuVec<u32>,
    reflections: GpuVec<f32>,
    lights: GpuVec<prt::VertexLight>,
}

impl GpuTransfer {
    fn new(context: &GpuContext, known: &SceneTransfer) -> Result<Self, GpuError> {
        let (transfer, surface) = (known.transfer(), known.surface(&[]));
        let vertices = known.vertices();
        Ok(Self {
            id: known.id(),
            vertices,
            coefficients: transfer.coefficients() as u32,
            largest_gain: largest_gain(transfer),
            largest_reflection: surface.reflections.iter().copied().fold(0.0, f32::max),
            lit: context.binding_of("the transfer", &transfer.lit)?,
            blocked: context.binding_of("the blocked transfer", &transfer.blocked)?,
            corner_vertices: context
                .binding_of("the corners' vertices", surface.corner_vertices)?,
            reflections: context.binding_of("the objects' reflections", surface.reflections)?,
            lights: context.zeroed("light at vertices", vertices.into())?,
        })
    }

    fn record(
        &self,
        recording: &mut Recording<'_>,
        light: &GpuLight,
        shadows: bool,
    ) -> Result<(), GpuError> {
        let pass = VertexLight {
            coefficients: self.coefficients,
            shadows: u32::from(shadows),
            light: light.coefficients().all(),
            lit: self.lit.all(),
            blocked: self.blocked.all(),
            out: self.lights.out(),
        };
        recording.run(pass, 0..self.vertices)
    }
}

/// The most that a white vertex with this transfer reflects of any light, with its objects or without them, by the light's mean.
///
/// Irradiance is `∫ L T`, T the band-limited transfer, of which no value exceeds the norm of its n² coefficients times n/√4π.
fn largest_gain(transfer: &Transfer) -> f32 {
    let n = transfer.coefficients();
    let squares = |(lit, blocked): (&[f32], &[f32])| {
        let pairs = lit.iter().zip(blocked);
        let (own, all) = pairs.fold((0.0f32, 0.0f32), |(own, all), (lit, blocked)| {
            (own + lit * lit, all + (lit + blocked) * (lit + blocked))
        });
        own.max(all)
    };
    let lists = transfer
        .lit
        .par_chunks(n)
        .zip(transfer.blocked.par_chunks(n));
    let largest = lists.map(squares).reduce(|| 0.0, f32::max);
    // 4π of the mean's integral, 1/π of the reflection.
    4.0 * largest.sqrt() * transfer.bands as f32 / (4.0 * PI).sqrt()
}

/// What an image of one size is drawn and composited in.
struct Canvas {
    size: UVec2,
    samples: u32,
    /// Whether the layers is the whole image's and not a band's.
    keeps_layers: bool,
    has_plate: bool,
    targets: Targets,
    /// Rows of the image that are composited at a time.
    band: u32,
    /// A band's drawn layers.
    drawn: [GpuVec<UVec2>; LAYERS],
    /// The whole image's, without the layers where those are not kept.
    pixels: Pixels<Gpu>,
    /// Of one pixel where there is none.
    plate: GpuVec<PlatePixel>,
}

impl Canvas {
    fn new(
        context: &GpuContext,
        settings: &RenderSettings,
        samples: u32,
        has_plate: bool,
    ) -> Result<Self, GpuError> {
        let size = settings.size;
        let band = band_rows(size, context.max_binding_bytes().min(BAND_BYTES));
        let pixels = size.element_product() as usize;
        let in_band = size.x as usize * band as usize;
        let of_band = || {
            let values = u64::from(pitch(size.x)) * u64::from(band);
            context.zeroed("drawn layers", values)
        };
        let with_layers = if settings.layers { pixels } else { in_band };
        let with_plate = if has_plate { pixels } else { 1 };
        Ok(Self {
            size,
            samples,
            keeps_layers: settings.layers,
            has_plate,
            targets: Targets::new(context, size, samples)?,
            band,
            drawn: [of_band()?, of_band()?, of_band()?],
            pixels: Pixels::new(context, pixels, with_layers)?,
            plate: context.zeroed("plate", with_plate as u64)?,
        })
    }

    /// From what was drawn to the image, a band of rows after the other.
    fn composite(
        &mut self,
        recording: &mut Recording<'_>,
        light: &GpuLight,
        work: &Work,
        scale: f32,
    ) -> Result<(), GpuError> {
        let layout = DrawnLayout {
            map_size: light.size,
            pitch: self.targets.pitch(),
            scale,
        };
        let mut row = 0;
        while row < self.size.y {
            let rows = self.band.min(self.size.y - row);
            self.targets.copy_rows(recording, row, rows, &self.drawn);
            let (first, count) = (row * self.size.x, rows * self.size.x);
            let frame = FrameParams {
                first_pixel: first,
                ..work.frame
            };
            let part = first as usize..(first + count) as usize;
            let layers = match self.keeps_layers {
                true => part.clone(),
                false => 0..count as usize,
            };
            let [object, lit, blocked] = &self.drawn;
            let pass = UnpackLayers {
                frame: &frame,
                layout: &layout,
                map_rotation: light.rotation,
                map_texels: light.map.all(),
                object: object.all(),
                lit: lit.all(),
                blocked: blocked.all(),
                out: Gpu::chunks(&mut self.pixels.layers, layers.clone(), 1),
            };
            recording.run(pass, 0..count)?;
            let plate = &self.plate;
            let plate = work.has_plate.then(|| Gpu::slice(plate, part.clone()));
            self.pixels
                .composite(recording, &frame, plate, layers, part)?;
            row += rows;
        }
        Ok(())
    }
}

/// Rows of which the layers fit into `bytes`, so many that the next band's parts of buffers begin aligned. Where not even those
/// fit, the dispatch says so.
fn band_rows(size: UVec2, bytes: u64) -> u32 {
    let row = u64::from(size.x) * (size_of::<PixelLayers>() as u64).max(4 * PIXEL);
    let granule = BAND_GRANULE / (1 << size.x.trailing_zeros().min(BAND_GRANULE.trailing_zeros()));
    let fitting = (bytes / row).min(u64::from(size.y)) as u32;
    if fitting == size.y {
        return size.y;
    }
    (fitting / granule * granule).max(granule).min(size.y)
}

#[cfg(test)]
mod tests {
    use glam::Vec3;

    use super::*;

    #[test]
    fn layers_hold_what_is_drawn() {
        for exposure in [0.0, 1e-30, 1e-9, 0.3, 1.0, 700.0, 1e30, f32::MAX] {
            for mean in [1e-20, 1e-3, 1.0, 55.0, 1e9] {
                for gain in [1.0, 8.0] {
                    for sun in [0.0, 1.0, 1e3, 1e6] {
                        let scale = scale_for(exposure, mean, gain, sun * mean);
                        let largest = scale * mean * (gain + sun);
                        assert!(
                            largest <= HALF_MAX,
                            "{exposure} {mean} {gain} {sun}: {scale}"
                        );
                        // The smallest number of all 11 bits is 2⁻¹⁴.
                        assert!(
                            scale * mean >= 1.0 / 512.0,
                            "{exposure} {mean} {gain} {sun}"
                        );
                    }
                }
            }
        }
        // Where the exposure suits the light it is what decides.
        assert_eq!(scale_for(8.0, 0.5, 8.0, 0.0), 8.0);
        assert_eq!(scale_for(11.0, 0.5, 8.0, 100.0), 8.0);
        for (mean, mirrored) in [(0.0, 0.0), (1e-40, 1e20), (1e20, 1e20)] {
            let scale = scale_for(1.0, mean, 8.0, mirrored);
            assert!(
                scale > 0.0 && scale.is_finite(),
                "{mean} {mirrored}: {scale}"
            );
        }
    }

    #[test]
    fn no_direction_of_light_gains_more() {
        for bands in 1..=6 {
            let normal = Vec3::new(0.48, 0.6, -0.64);
            let y = glimt_sh::basis(normal);
            let lobe = |k: usize| glimt_sh::cosine_lobe(k.isqrt() as u32) * y[k];
            let lit: Vec<f32> = (0..(bands * bands) as usize).map(lobe).collect();
            // All light from where the normal shows, which is where the band-limited lobe is highest.
            let highest: f32 = lit.iter().zip(y).map(|(t, y)| t * y).sum();
            for share in [1.0, 0.25] {
                let transfer = Transfer {
                    bands,
                    lit: lit.iter().map(|t| share * t).collect(),
                    blocked: lit.iter().map(|t| (1.0 - share) * t).collect(),
                };
                let gain = largest_gain(&transfer);
                assert!(
                    gain >= 4.0 * highest * 0.999_99 && gain < 12.0 * highest,
                    "{bands}"
                );
            }
        }
    }

    #[test]
    fn bands_begin_aligned_and_fit() {
        for size in [[2400, 1700], [97, 61], [64, 9], [4096, 3000], [1, 1]] {
            let size = UVec2::from(size);
            for bytes in [1 << 14, 1 << 20, 64 << 20, 1 << 30] {
                let rows = band_rows(size, bytes);
                assert!(rows > 0 && rows <= size.y);
                assert!(rows == size.y || (rows * size.x).is_multiple_of(BAND_GRANULE));
                let needed = u64::from(rows * size.x) * 64;
                assert!(needed <= bytes || rows <= BAND_GRANULE, "{size} {bytes}");
            }
        }
    }
}
