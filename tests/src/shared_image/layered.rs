//! Host file: a small frame with catchers, over a plate and alone: the kernels of compositing.

use glam::Vec4;
use glimt_render_gpu::gpu::{Arg, GpuEnv};
use glimt_render_gpu::kernels::composite;
use glimt_render_gpu::kernels::frame::FrameParams;
use glimt_render_gpu::kernels::layers::{LayerSample, PixelLayers, reconstruct_layers};
use glimt_render_gpu::kernels::shade;
use glimt_render_gpu::prepare::plate::Plate;

use super::frame::{MIS, MIS_IN_LAYERS, RAYS, SIZE, Stage, all_of_luminance};
use super::{Output, Pair, launch, words};

impl Stage<'_> {
    /// Composites and display values over a plate, then composites without one.
    pub(super) fn layered(&self, name: &str, frame: &FrameParams) -> Pair {
        let (pixels, rays) = (SIZE.x * SIZE.y, SIZE.x * SIZE.y * RAYS);
        let (env, scene) = (self.env.view(), self.scene.view());
        let plate = plate();
        let samples: Vec<LayerSample> = (0..rays)
            .map(|ray| shade::shade(ray, frame, &MIS, env, scene))
            .collect();
        let layers: Vec<PixelLayers> = (0..pixels)
            .map(|pixel| reconstruct_layers(pixel, frame, env, &samples))
            .collect();
        let over = |pixel| composite::composite_over_plate(pixel, frame, &layers, plate.pixels());
        let over: Vec<Vec4> = (0..pixels).map(over).collect();
        let display = |pixel| composite::display_over_plate(pixel, frame, &layers, plate.pixels());
        let display: Vec<u32> = (0..pixels).map(display).collect();
        let alone = |pixel| composite::composite_alone(pixel, frame, &layers);
        let alone: Vec<Vec4> = (0..pixels).map(alone).collect();

        let context = self.context;
        let out_samples = Output::new::<LayerSample>(context, rays);
        self.shade(MIS_IN_LAYERS, frame, &out_samples, rays);
        let out_layers = Output::new::<PixelLayers>(context, pixels);
        let plate = context.buffer_of("plate", plate.pixels());
        let plate = plate.expect("a small buffer");
        let gpu_env = GpuEnv::new(context, &self.env, &all_of_luminance()).expect("a small map");
        let mut args = vec![
            ("frame", Arg::Value(bytemuck::bytes_of(frame))),
            ("samples", Arg::Buffer(&out_samples.buffer)),
            ("plate", Arg::Buffer(&plate)),
            ("layers", Arg::Buffer(&out_layers.buffer)),
        ];
        args.extend(gpu_env.args());
        let run = |kernel: &str, out: &Output| {
            let kernel = format!("glimt_render_gpu::kernels::{kernel}");
            launch(context, self.program, &kernel, &args, &out.buffer, pixels);
        };
        run("layers::reconstruct_layers", &out_layers);
        let out = [
            ("composite_over_plate", Output::new::<Vec4>(context, pixels)),
            ("display_over_plate", Output::new::<u32>(context, pixels)),
            ("composite_alone", Output::new::<Vec4>(context, pixels)),
        ];
        for (kernel, out) in &out {
            run(&format!("composite::{kernel}"), out);
        }
        Pair {
            name: name.to_owned(),
            cpu: [words(&over), display, words(&alone)].concat(),
            gpu: out.map(|(_, out)| out.read(context)).concat(),
        }
    }
}

/// No two pixels alike.
fn plate() -> Plate {
    let codes: Vec<[u8; 3]> = (0..SIZE.x * SIZE.y)
        .map(|i| [i * 7, i * 11, i * 13].map(|code| (code % 256) as u8))
        .collect();
    Plate::from_srgb8(SIZE, &codes).expect("a plate")
}
