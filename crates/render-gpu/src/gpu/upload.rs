//! Host file: scenes and lights on the GPU, bound by the paths that kernels know them by.

use bytemuck::NoUninit;
use glam::{UVec2, Vec2};

use super::buffer::GpuBuffer;
use super::device::GpuContext;
use super::error::GpuError;
use super::launch::Arg;
use crate::host::env::PreparedEnv;
use crate::host::scene_build::SceneBuffers;
use crate::kernels::triangle::Triangle;

/// A scene's buffers.
#[derive(Debug)]
pub struct GpuScene {
    id: u64,
    surface_id: u64,
    nodes: GpuBuffer,
    triangles: GpuBuffer,
    corners: GpuBuffer,
    materials: GpuBuffer,
    texels: GpuBuffer,
}

impl GpuScene {
    /// Uploads a scene.
    ///
    /// # Errors
    ///
    /// [`GpuError::Limit`] where a buffer is larger than a binding may be, and [`GpuError::OutOfMemory`].
    pub fn new(context: &GpuContext, scene: &SceneBuffers) -> Result<Self, GpuError> {
        let view = scene.view();
        Ok(Self {
            id: scene.id(),
            surface_id: scene.surface_id(),
            nodes: bindable(context, "scene.nodes", view.nodes)?,
            triangles: bindable(context, "scene.triangles", view.triangles)?,
            corners: bindable(context, "scene.corners", view.corners)?,
            materials: bindable(context, "scene.materials", view.materials)?,
            texels: bindable(context, "scene.texels", view.texels)?,
        })
    }

    /// Makes it another scene. Of the same scene in another pose, materials and textures stay; so do buffers whose size
    /// does. Where that fails, what it holds is no scene: make a new one.
    ///
    /// # Errors
    ///
    /// As [`Self::new`].
    pub fn update(&mut self, context: &GpuContext, scene: &SceneBuffers) -> Result<(), GpuError> {
        if scene.id() == self.id {
            return Ok(());
        }
        if scene.surface_id() != self.surface_id {
            *self = Self::new(context, scene)?;
            return Ok(());
        }
        let view = scene.view();
        rewrite(context, &mut self.nodes, view.nodes)?;
        rewrite(context, &mut self.triangles, view.triangles)?;
        rewrite(context, &mut self.corners, view.corners)?;
        self.id = scene.id();
        Ok(())
    }

    /// Which scene it is: [`SceneBuffers::id`].
    #[must_use]
    pub fn id(&self) -> u64 {
        self.id
    }

    /// Whose materials and textures it has: [`SceneBuffers::surface_id`].
    #[must_use]
    pub fn surface_id(&self) -> u64 {
        self.surface_id
    }

    /// What drawing reads: triangles, corners, materials, texels.
    pub(super) fn surface(&self) -> [&GpuBuffer; 4] {
        [
            &self.triangles,
            &self.corners,
            &self.materials,
            &self.texels,
        ]
    }

    /// How many triangles there are.
    pub(super) fn triangles(&self) -> u32 {
        (self.triangles.len() / size_of::<Triangle>() as u64) as u32
    }

    /// The arguments of a kernel that takes `scene`.
    #[must_use]
    pub fn args(&self) -> [(&'static str, Arg<'_>); 5] {
        [
            ("scene.nodes", Arg::Buffer(&self.nodes)),
            ("scene.triangles", Arg::Buffer(&self.triangles)),
            ("scene.corners", Arg::Buffer(&self.corners)),
            ("scene.materials", Arg::Buffer(&self.materials)),
            ("scene.texels", Arg::Buffer(&self.texels)),
        ]
    }

    /// The arguments of a kernel that takes the tree alone, as `nodes` and `triangles`.
    #[must_use]
    pub fn tree_args(&self) -> [(&'static str, Arg<'_>); 2] {
        [
            ("nodes", Arg::Buffer(&self.nodes)),
            ("triangles", Arg::Buffer(&self.triangles)),
        ]
    }
}

/// A light map with its tables.
///
/// While one lights the frame that renders, the next frame's may be made or updated on another thread.
#[derive(Debug)]
pub struct GpuEnv {
    size: UVec2,
    rotation: Vec2,
    texels: GpuBuffer,
    marginal: GpuBuffer,
    conditional: GpuBuffer,
}

impl GpuEnv {
    /// Uploads a light map.
    ///
    /// # Errors
    ///
    /// [`GpuError::Limit`] where it is larger than a binding may be, and [`GpuError::OutOfMemory`].
    pub fn new(context: &GpuContext, env: &PreparedEnv) -> Result<Self, GpuError> {
        let view = env.view();
        Ok(Self {
            size: view.cdf.size,
            rotation: view.rotation,
            texels: bindable(context, "env.texels", view.texels)?,
            marginal: bindable(context, "env.cdf.marginal", view.cdf.marginal)?,
            conditional: bindable(context, "env.cdf.conditional", view.cdf.conditional)?,
        })
    }

    /// Puts another light map in its place, into the same buffers where the size is the same.
    ///
    /// # Errors
    ///
    /// As [`Self::new`].
    pub fn update(&mut self, context: &GpuContext, env: &PreparedEnv) -> Result<(), GpuError> {
        let view = env.view();
        if view.cdf.size != self.size {
            *self = Self::new(context, env)?;
            return Ok(());
        }
        context.write(&self.texels, view.texels)?;
        context.write(&self.marginal, view.cdf.marginal)?;
        context.write(&self.conditional, view.cdf.conditional)?;
        self.rotation = view.rotation;
        Ok(())
    }

    /// Its texels.
    pub(super) fn texels(&self) -> &GpuBuffer {
        &self.texels
    }

    /// The arguments of a kernel that takes `env`.
    #[must_use]
    pub fn args(&self) -> [(&'static str, Arg<'_>); 5] {
        [
            ("env.cdf.size", Arg::Value(bytemuck::bytes_of(&self.size))),
            (
                "env.rotation",
                Arg::Value(bytemuck::bytes_of(&self.rotation)),
            ),
            ("env.texels", Arg::Buffer(&self.texels)),
            ("env.cdf.marginal", Arg::Buffer(&self.marginal)),
            ("env.cdf.conditional", Arg::Buffer(&self.conditional)),
        ]
    }
}

/// Puts other values in a buffer, or in one that replaces it where their number differs.
fn rewrite<T: NoUninit>(
    context: &GpuContext,
    buffer: &mut GpuBuffer,
    values: &[T],
) -> Result<(), GpuError> {
    if buffer.len() == size_of_val(values) as u64 {
        return context.write(buffer, values);
    }
    let label = buffer.label().to_owned();
    *buffer = bindable(context, &label, values)?;
    Ok(())
}

/// A buffer that is checked now to fit a binding, before the frames that would find out.
pub(super) fn bindable<T: NoUninit>(
    context: &GpuContext,
    path: &str,
    values: &[T],
) -> Result<GpuBuffer, GpuError> {
    let (needed, allowed) = (size_of_val(values) as u64, context.max_binding_bytes());
    if needed > allowed {
        let limit = "max_storage_buffer_binding_size";
        return Err(context.limit_error(path.to_owned(), needed, limit, allowed));
    }
    context.buffer_of(path, values)
}
