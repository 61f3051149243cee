//! Host file: what a renderer keeps between frames, by the method that keeps it.

use glam::UVec2;
use glimt_executor::{Device, Memory};

use super::{Method, cells, smc};
use crate::prepare::cells_state::CellsState;
use crate::prepare::env::PreparedEnv;
use crate::prepare::render::{RenderError, RenderSettings, SettingsError};
use crate::prepare::scene_build::SceneBuffers;
use crate::prepare::smc_state::SmcState;

/// What a renderer keeps between frames: saved, restored, forgotten as one.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum MethodMemory {
    /// Of [`Method::Cells`].
    Cells(CellsState),
    /// Of [`Method::Smc`].
    Smc(SmcState),
}

/// How much of that there is of one frame. Renderers have room for two: for the frame before, and for the one that renders.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct KeptBytes {
    /// Of the largest buffer, which a GPU must be able to bind.
    pub largest: u64,
    /// In all.
    pub all: u64,
}

impl Method {
    /// What it keeps of a frame of this size; 0 where it keeps nothing.
    #[must_use]
    pub fn kept_bytes(&self, size: UVec2, rays_per_pixel: u32) -> KeptBytes {
        match self {
            Self::Cells(own) if own.memory => cells::kept_bytes(size),
            Self::Smc(own) => {
                let rays = u64::from(size.x) * u64::from(size.y) * u64::from(rays_per_pixel);
                own.kept_bytes(rays)
            }
            _ => KeptBytes::default(),
        }
    }
}

/// The same in the memory of an executor, with the room for the next frame's.
#[derive(Debug)]
pub(crate) enum Kept<M: Memory> {
    /// Nothing.
    Nothing,
    /// By [`Method::Cells`].
    Cells(cells::Counting<M>),
    /// By [`Method::Smc`].
    Smc(smc::Following<M>),
}

impl<M: Memory> Kept<M> {
    /// What there is to keep for the frame that is to come: it continues from this where it can. The light is for [`Method::Smc`] alone.
    pub(crate) fn begin<D: Device<Memory = M>>(
        self,
        device: &D,
        scene: &SceneBuffers,
        env: Option<&PreparedEnv>,
        settings: &RenderSettings,
    ) -> Result<Self, RenderError> {
        match &settings.method {
            Method::Cells(own) => {
                let known = match self {
                    Self::Cells(known) => Some(known),
                    _ => None,
                };
                let begun = cells::Counting::begin(known, device, scene, settings, own)?;
                Ok(Self::Cells(begun))
            }
            Method::Smc(own) => {
                let env = env.ok_or(SettingsError::Memory)?;
                let known = match self {
                    Self::Smc(known) => Some(known),
                    _ => None,
                };
                let begun = smc::Following::begin(known, device, scene, env, settings, own)?;
                Ok(Self::Smc(begun))
            }
            _ => Ok(Self::Nothing),
        }
    }

    /// Whether the frame that is to come continues from another.
    pub(crate) fn has_past(&self) -> bool {
        match self {
            Self::Nothing => false,
            Self::Cells(own) => own.has_past(),
            Self::Smc(own) => own.has_past(),
        }
    }

    /// What a frame left, copied; `None` before the first.
    pub(crate) fn read<D: Device<Memory = M>>(
        &self,
        device: &D,
    ) -> Result<Option<MethodMemory>, D::Error> {
        Ok(match self {
            Self::Nothing => None,
            Self::Cells(own) => own.read(device)?.map(MethodMemory::Cells),
            Self::Smc(own) => own.read(device)?.map(MethodMemory::Smc),
        })
    }

    /// What a frame left, from the host.
    pub(crate) fn resume<D: Device<Memory = M>>(
        device: &D,
        memory: MethodMemory,
    ) -> Result<Self, D::Error> {
        Ok(match memory {
            MethodMemory::Cells(state) => Self::Cells(cells::Counting::resume(device, state)?),
            MethodMemory::Smc(state) => Self::Smc(smc::Following::resume(device, state)?),
        })
    }
}
