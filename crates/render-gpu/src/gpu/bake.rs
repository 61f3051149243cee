//! Host file: transfer at all vertices of a scene by wgpu.

use glimt_executor::Executor;
use glimt_executor::gpu::{Direct, GpuContext, GpuError};

use super::upload::GpuScene;
use crate::generated::entries::TRANSFER;
use crate::generated::passes::Transfer;
use crate::kernels::transfer::{STATE, TransferVertex};
use crate::prepare::bake::{BLOCK, BakeError, BakeSettings, Baked, for_kernels, room};
use crate::prepare::scene_build::SceneBuffers;

/// Vertices in the first dispatch: each has hundreds of rays, and a GPU's pace is not known before.
const FIRST: usize = 64;
/// Directions of a vertex in a dispatch, so that none takes long however many there are.
const PART: u32 = 1024;
/// The same on an adapter that is the CPU: llvmpipe ends the loops of an invocation after 2¹⁶ turns in all, and says nothing. A
/// ray takes hundreds.
const SOFTWARE_PART: u32 = 32;

/// As [`bake`](crate::prepare::bake::bake), on the GPU: a block of vertices at a time, so that buffers stay small, and a part of their
/// directions, so that dispatches stay short.
///
/// # Errors
/// A [`BakeError`].
pub fn bake(
    context: &GpuContext,
    scene: &SceneBuffers,
    settings: &BakeSettings,
    progress: &dyn Fn(f32),
) -> Result<Baked, BakeError> {
    settings.check()?;
    let total: usize = scene.vertex_counts().iter().sum();
    let mut made = room(total, settings.bands)?;
    let vertices = scene.vertices()?;
    let count = made.coefficients();
    let block = BLOCK.min(total.max(1));
    let uploaded = GpuScene::new(context, scene)?;
    let known = context.zeroed::<TransferVertex>("vertices", block as u64)?;
    let lit = context.zeroed::<f32>("lit", (block * count) as u64)?;
    let blocked = context.zeroed::<f32>("blocked", (block * count) as u64)?;
    let state = context.zeroed::<u32>("generators", (block * STATE) as u64)?;
    let traced = context.zeroed::<u32>("rays", block as u64)?;
    context.forget_pace(&TRANSFER)?;

    let mut rays = 0;
    let mut first = 0;
    while first < total {
        let length = if first == 0 { FIRST } else { block };
        let own = &vertices[first..(first + length).min(total)];
        context.write(&known, &for_kernels(own, first))?;
        let scene = uploaded.arg();
        let part = match context.adapter().is_software() {
            true => SOFTWARE_PART,
            false => PART,
        };
        for params in settings.parts(part) {
            let tell = |done: u64| {
                let rows = own.len() as f32 * params.first_row as f32
                    + done as f32 * (params.end_row - params.first_row) as f32;
                progress((first as f32 + rows / params.rows as f32) / total as f32);
            };
            let pass = Transfer {
                params: &params,
                nodes: scene.nodes,
                triangles: scene.triangles,
                surface: scene.surface,
                vertices: known.all(),
                state: state.all().written(STATE as u32),
                lit: lit.all().written(count as u32),
                blocked: blocked.all().written(count as u32),
                out: traced.out(),
            };
            Direct::with_progress(context, &tell).run(pass, 0..own.len() as u32)?;
            let own_rays: Vec<u32> = context.read(&traced, own.len())?;
            rays += own_rays.into_iter().map(u64::from).sum::<u64>();
        }
        let states: Vec<u32> = context.read(&state, own.len() * STATE)?;
        let gone = |state: &[u32]| state[STATE - 1] == settings.directions;
        if !states.chunks(STATE).all(gone) {
            return Err(BakeError::Gpu(GpuError::Unfinished {
                adapter: context.adapter().name.clone(),
                what: format!("{} directions a vertex", settings.directions),
            }));
        }
        let part = first * count..(first + own.len()) * count;
        made.lit[part.clone()].copy_from_slice(&context.read::<f32>(&lit, part.len())?);
        made.blocked[part.clone()].copy_from_slice(&context.read::<f32>(&blocked, part.len())?);
        first += own.len();
    }
    Ok(Baked {
        transfer: made,
        vertices,
        rays,
    })
}
