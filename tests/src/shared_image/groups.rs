//! Host file: frames by groups of a pixel's hits: samples of the product, and a control variate over cells.

use glam::{Mat4, Vec3, Vec4};
use glimt_executor::gpu::GpuBuffer;
use glimt_render_gpu::gpu::Arg;
use glimt_render_gpu::kernels::cell_state::{
    COUNT_WORDS, ENTRIES, TileEntry, VISIBILITY_WORDS, WORTHS,
};
use glimt_render_gpu::kernels::group_health::{GroupHealth, diagnose_groups};
use glimt_render_gpu::kernels::past::PastView;
use glimt_render_gpu::kernels::scout::CellParams;
use glimt_render_gpu::kernels::seen::{self, SeenPoint};
use glimt_render_gpu::kernels::{carry, cells, expect, pilot, product, scout};
use glimt_render_gpu::methods::{Cells, Product};
use glimt_render_gpu::prepare::render::{Pattern, Tonemap};

use super::estimators::value;
use super::frame::{RAYS, SIZE, Stage, settings};
use super::{Output, Pair, words};

const PIXELS: u32 = SIZE.x * SIZE.y;

impl Stage<'_> {
    /// Samples of the product of light and reflection.
    pub(super) fn of_the_product(&self) -> Pair {
        let frame = settings(Pattern::OwenSobol, Tonemap::Srgb).frame_params();
        let frame = frame.expect("settings");
        let own = product::Product {
            rays: 5.0,
            unused_a: 0,
            unused_b: 0,
            unused_c: 0,
        };
        let method = Product::default().into();
        let env = self.env.view_for(&method).expect("all tables");
        let (scene, rays) = (self.scene.view(), PIXELS * RAYS);
        let mut points: Vec<SeenPoint> =
            (0..rays).map(|ray| seen::see(ray, &frame, scene)).collect();
        let mut cpu = vec![Vec4::ZERO; rays as usize];
        let chunks = points.chunks_mut(RAYS as usize);
        for (pixel, (points, samples)) in (0..).zip(chunks.zip(cpu.chunks_mut(RAYS as usize))) {
            product::shade_product(pixel, &frame, &own, env, scene, points, samples);
        }
        let found = Output::new::<SeenPoint>(self.context, rays);
        let out = Output::new::<Vec4>(self.context, rays);
        self.shade_by(&method, "seen::see", &frame, &[], &found, rays);
        let more = [
            ("product", value(&own)),
            ("points", Arg::Chunk(&found.buffer, RAYS)),
            ("samples", Arg::Chunk(&out.buffer, RAYS)),
        ];
        let kernel = "product::shade_product::<glam::Vec4>";
        self.shade_by(&method, kernel, &frame, &more, &out, PIXELS);
        let fared = Output::new::<GroupHealth>(self.context, PIXELS);
        let more = [("points", Arg::Buffer(&found.buffer))];
        let kernel = "group_health::diagnose_groups";
        self.shade_by(&method, kernel, &frame, &more, &fared, PIXELS);
        let health: Vec<GroupHealth> = (0..PIXELS)
            .map(|pixel| diagnose_groups(pixel, &frame, &points))
            .collect();
        let of_gpu: Vec<u32> = fared.read(self.context);
        Pair {
            name: "product".to_owned(),
            cpu: [words(&cpu), words(&health)].concat(),
            gpu: [out.read(self.context), of_gpu].concat(),
        }
    }

    /// A control variate over cells, from the scouts on.
    pub(super) fn by_cells(&self) -> Pair {
        let frame = settings(Pattern::OwenSobol, Tonemap::Srgb).frame_params();
        let frame = frame.expect("settings");
        let of_cells = Cells {
            rays: 5,
            pilot: 0.5,
            ..Cells::default()
        };
        let first = of_cells.params(SIZE);
        let method = of_cells.into();
        let env = self.env.view_for(&method).expect("all tables");
        let (scene, rays) = (self.scene.view(), PIXELS * RAYS);
        let tiles = first.tiles;
        let all = (tiles * ENTRIES) as usize;
        let words_of_all = all * VISIBILITY_WORDS as usize;
        let mut visibility = vec![0_u32; words_of_all + WORTHS as usize];
        let per_tile = |words: u32| (ENTRIES * words) as usize;
        // A frame before, which was seen from another place.
        let camera = settings(Pattern::OwenSobol, Tonemap::Srgb).view();
        let mut view = PastView::of(&camera.expect("a camera"));
        view.eye += 0.05 * view.right;
        let motions = vec![Mat4::from_translation(0.03 * Vec3::X); self.scene.transforms().len()];
        let count = |own: &CellParams, past_entries: &[TileEntry], past_counts: &[u32]| {
            let mut entries = vec![TileEntry::NONE; all];
            let mut counts = vec![0_u32; all * COUNT_WORDS as usize];
            for (tile, entries) in (0..).zip(entries.chunks_mut(per_tile(1))) {
                scout::scout(tile, &frame, own, scene, entries);
                carry::carry(
                    tile,
                    &frame,
                    own,
                    &view,
                    env,
                    &motions,
                    past_entries,
                    past_counts,
                    entries,
                );
            }
            for (tile, counts) in (0..).zip(counts.chunks_mut(per_tile(COUNT_WORDS))) {
                pilot::pilot(tile, &frame, own, env, scene, &entries, past_counts, counts);
            }
            (entries, counts)
        };
        let (past_entries, past_counts) = count(&first, &[], &[]);
        let own = CellParams {
            has_past: 1,
            turned: 1,
            ..first
        };
        let (entries, counts) = count(&own, &past_entries, &past_counts);
        let own_words = visibility[..words_of_all].chunks_mut(per_tile(VISIBILITY_WORDS));
        for (tile, words) in (0..).zip(own_words) {
            expect::expect(tile, &own, &entries, &counts, words);
        }
        let worths: Vec<f32> = (0..tiles)
            .map(|tile| expect::worth(tile, &frame, env, &entries, &visibility))
            .collect();
        for part in 0..WORTHS {
            visibility[words_of_all + part as usize] =
                expect::add_worths(part, &own, WORTHS, &worths);
        }
        let mut points: Vec<SeenPoint> = (0..rays)
            .map(|ray| scout::see_in_tile(ray, &frame, &own, scene, &entries))
            .collect();
        let mut cpu = vec![Vec4::ZERO; rays as usize];
        let chunks = points.chunks_mut(RAYS as usize);
        for (pixel, (points, samples)) in (0..).zip(chunks.zip(cpu.chunks_mut(RAYS as usize))) {
            cells::shade_cells(
                pixel,
                &frame,
                &own,
                env,
                scene,
                &visibility,
                points,
                samples,
            );
        }

        let zeros = |name, count: usize| -> GpuBuffer {
            let buffer = self.context.buffer_of(name, &vec![0_u32; count]);
            buffer.expect("a small buffer")
        };
        let gpu_entries = zeros("entries", all * size_of::<TileEntry>() / 4);
        let gpu_counts = zeros("counts", counts.len());
        let gpu_visibility = zeros("visibility", visibility.len());
        let gpu_worths = Output::new::<f32>(self.context, tiles);
        let found = Output::new::<SeenPoint>(self.context, rays);
        let out = Output::new::<Vec4>(self.context, rays);
        let parts = WORTHS;
        let params = [("cells", value(&own)), ("parts", value(&parts))];
        let held = |words: &[u32]| -> GpuBuffer {
            let buffer = self.context.buffer_of("past", words);
            buffer.expect("a small buffer")
        };
        let gpu_past_entries = held(bytemuck::cast_slice(&past_entries));
        let gpu_past_counts = held(&past_counts);
        let gpu_motions = held(bytemuck::cast_slice(&motions));
        let past = [
            ("view", value(&view)),
            ("motions", Arg::Buffer(&gpu_motions)),
            ("past_entries", Arg::Buffer(&gpu_past_entries)),
            ("past_counts", Arg::Buffer(&gpu_past_counts)),
        ];
        let entries = [("entries", Arg::Buffer(&gpu_entries))];
        let run = |kernel: &str, more: &[(&str, Arg<'_>)], out: &Output, count: u32| {
            let more = [&params[..], more].concat();
            self.shade_by(&method, kernel, &frame, &more, out, count);
        };
        let written = [("entries", Arg::Chunk(&gpu_entries, ENTRIES))];
        run("scout::scout", &written, &out, tiles);
        run("carry::carry", &[&past[..], &written].concat(), &out, tiles);
        let written = [("counts", Arg::Chunk(&gpu_counts, ENTRIES * COUNT_WORDS))];
        run(
            "pilot::pilot",
            &[&entries[..], &past[3..], &written].concat(),
            &out,
            tiles,
        );
        let read = [("counts", Arg::Buffer(&gpu_counts))];
        let chunk = Arg::Chunk(&gpu_visibility, ENTRIES * VISIBILITY_WORDS);
        let own_words = [("visibility", chunk)];
        run(
            "expect::expect",
            &[&entries[..], &read, &own_words].concat(),
            &out,
            tiles,
        );
        let read = [("visibility", Arg::Buffer(&gpu_visibility))];
        run(
            "expect::worth",
            &[&entries[..], &read].concat(),
            &gpu_worths,
            tiles,
        );
        // The parts of the sum lie behind the visibilities; here they come from a buffer of their own.
        let sums = Output::new::<u32>(self.context, WORTHS);
        let worths = [("worths", Arg::Buffer(&gpu_worths.buffer))];
        run("expect::add_worths", &worths, &sums, WORTHS);
        let mut words_there: Vec<u32> = self
            .context
            .read(&gpu_visibility, words_of_all)
            .expect("a small buffer");
        words_there.extend(sums.read(self.context));
        let whole = self.context.buffer_of("visibility", &words_there);
        let whole = whole.expect("a small buffer");
        run("scout::see_in_tile", &entries, &found, rays);
        let more = [
            ("visibility", Arg::Buffer(&whole)),
            ("points", Arg::Chunk(&found.buffer, RAYS)),
            ("samples", Arg::Chunk(&out.buffer, RAYS)),
        ];
        run("cells::shade_cells::<glam::Vec4>", &more, &out, PIXELS);
        let kept: Vec<u32> = self
            .context
            .read(&gpu_counts, counts.len())
            .expect("a small buffer");
        Pair {
            name: "by-cells".to_owned(),
            cpu: [words(&cpu), counts].concat(),
            gpu: [out.read(self.context), kept].concat(),
        }
    }
}
