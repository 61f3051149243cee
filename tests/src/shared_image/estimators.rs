//! Host file: frames by picked candidates, and by particles that are led from another light.

use glam::{Mat4, Vec4};
use glimt_render_gpu::cpu::CpuRenderer;
use glimt_render_gpu::gpu::Arg;
use glimt_render_gpu::kernels::past::{Past, RayState};
use glimt_render_gpu::kernels::smc_point::{self, SmcPoint};
use glimt_render_gpu::kernels::{bis, shade, smc, smc_gather};
use glimt_render_gpu::methods::{CandidateSource, MethodMemory, Smc};
use glimt_render_gpu::prepare::render::{Pattern, RenderSettings, Renderer, Tonemap};

use super::frame::{RAYS, SIZE, Stage, environment, settings};
use super::{Output, Pair, words};

pub(super) fn value<T: bytemuck::NoUninit>(value: &T) -> Arg<'_> {
    Arg::Value(bytemuck::bytes_of(value))
}

impl Stage<'_> {
    pub(super) fn picked(&self) -> Pair {
        let settings = RenderSettings {
            ..settings(Pattern::OwenSobol, Tonemap::Srgb)
        };
        let bis = bis::Bis {
            candidates: 9,
            samples: 3,
            source: CandidateSource::Mixture,
        };
        let frame = settings.frame_params().expect("settings");
        let rays = SIZE.x * SIZE.y * RAYS;
        let cpu: Vec<Vec4> = (0..rays)
            .map(|ray| shade::shade(ray, &frame, &bis, self.env.view(), self.scene.view()))
            .collect();
        let out = Output::new::<Vec4>(self.context, rays);
        let more = [("estimator", value(&bis))];
        self.shade_with(
            "shade::shade::<glimt_render_gpu::kernels::bis::Bis, glam::Vec4>",
            &frame,
            &more,
            &out,
            rays,
        );
        Pair {
            name: "picked".to_owned(),
            cpu: words(&cpu),
            gpu: out.read(self.context),
        }
    }

    /// From a frame of the CPU's, seen from a little beside, to the next one.
    pub(super) fn followed(&self) -> Pair {
        let of_smc = Smc {
            reinitialise: 1.5,
            max_age: 8,
            ..Smc::default()
        };
        let settings = RenderSettings {
            method: of_smc.into(),
            ..settings(Pattern::OwenSobol, Tonemap::Srgb)
        };
        let mut before = settings;
        before.camera.eye.x += 0.04;
        before.camera.target.x += 0.04;
        let mut renderer = CpuRenderer::default();
        let light = environment(24.0);
        renderer
            .render_frame(&self.scene, &light, &before, &|_| ())
            .expect("a frame");
        let memory = renderer.memory().expect("a state").expect("a state");
        let MethodMemory::Smc(state) = memory else {
            unreachable!("no other method keeps anything");
        };

        let frame = settings.frame_params().expect("settings");
        let (mean, previous) = (self.env.mean_luminance(), light.mean_luminance());
        let params = of_smc.params(mean, previous, 0.0);
        let view = of_smc.past_view(&state.past.view, 0, SIZE.x * SIZE.y);
        let motions = vec![Mat4::IDENTITY; self.scene.transforms().len()];
        let n = of_smc.particles as usize;
        let rays = SIZE.x * SIZE.y * RAYS;
        let (mut states, mut sets) = (state.rays.clone(), state.particles.clone());
        let past = Past {
            motions: &motions,
            states: &state.rays,
        };
        let (env, scene) = (self.env.view(), self.scene.view());
        let points: Vec<SmcPoint> = (0..rays)
            .map(|ray| smc_point::find_smc(ray, &frame, &view, scene, past))
            .collect();
        let chunks = states.chunks_mut(1).zip(sets.chunks_mut(n));
        for (ray, (own, set)) in (0..rays).zip(chunks) {
            let (before, particles) = (state.light(), &state.particles);
            smc::advance_smc(
                ray, &frame, &params, env, before, &points, particles, own, set,
            );
        }
        let floor = params.floor;
        let cpu: Vec<Vec4> = (0..rays)
            .map(|ray| {
                let (n, states, sets) = (n as u32, &states, &sets);
                smc_gather::gather_smc(ray, &frame, floor, n, env, scene, &points, states, sets)
            })
            .collect();

        let upload = |name, bytes: &[u8]| {
            let words: &[u32] = bytemuck::cast_slice(bytes);
            self.context.buffer_of(name, words).expect("a small buffer")
        };
        let texels = upload("before", bytemuck::cast_slice(&state.light));
        let motions = upload("motions", bytemuck::cast_slice(&motions));
        let old_states = upload("states", bytemuck::cast_slice(&state.rays));
        let old_sets = upload("sets", bytemuck::cast_slice(&state.particles));
        let new_states = Output::new::<RayState>(self.context, rays);
        let new_sets = upload("new sets", bytemuck::cast_slice(&state.particles));
        let found = Output::new::<SmcPoint>(self.context, rays);
        let out = Output::new::<Vec4>(self.context, rays);
        let light = state.light();
        let given = [
            ("smc", value(&params)),
            ("view", value(&view)),
            ("floor", value(&floor)),
            ("particles_per_ray", value(&of_smc.particles)),
            ("before.size", value(&light.size)),
            ("before.rotation", value(&light.rotation)),
            ("before.texels", Arg::Buffer(&texels)),
            ("past.motions", Arg::Buffer(&motions)),
            ("past.states", Arg::Buffer(&old_states)),
            ("past_particles", Arg::Buffer(&old_sets)),
            ("points", Arg::Buffer(&found.buffer)),
        ];
        let written = [
            ("state", Arg::Chunk(&new_states.buffer, 1)),
            ("particles", Arg::Chunk(&new_sets, n as u32)),
        ];
        let read = [
            ("states", Arg::Buffer(&new_states.buffer)),
            ("particles", Arg::Buffer(&new_sets)),
        ];
        self.shade_with("smc_point::find_smc", &frame, &given, &found, rays);
        let more = [&given[..], &written].concat();
        self.shade_with("smc::advance_smc", &frame, &more, &out, rays);
        let more = [&given[..], &read].concat();
        self.shade_with(
            "smc_gather::gather_smc::<glam::Vec4>",
            &frame,
            &more,
            &out,
            rays,
        );
        Pair {
            name: "followed".to_owned(),
            cpu: [words(&cpu), words(&states)].concat(),
            gpu: [out.read(self.context), new_states.read(self.context)].concat(),
        }
    }
}
