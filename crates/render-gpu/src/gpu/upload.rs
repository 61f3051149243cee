//! Host file: scenes and lights on the GPU, bound by the paths that kernels know them by.

use glam::{UVec2, Vec2, Vec4};
use glimt_executor::Element;
use glimt_executor::gpu::{Arg, Gpu, GpuContext, GpuError, GpuVec};

use crate::generated::passes::{EnvironmentArg, SceneArg};
use crate::kernels::bvh::BvhNode;
use crate::kernels::scene::Corner;
use crate::kernels::triangle::Triangle;
use crate::methods::Method;
use crate::prepare::env::PreparedEnv;
use crate::prepare::light_tables::BuiltTables;
use crate::prepare::render::RenderError;
use crate::prepare::scene_build::SceneBuffers;

/// A scene's buffers.
#[derive(Debug)]
pub struct GpuScene {
    id: u64,
    surface_id: u64,
    is_see_through: bool,
    nodes: GpuVec<BvhNode>,
    pub(super) triangles: GpuVec<Triangle>,
    pub(super) corners: GpuVec<Corner>,
    pub(super) surface: GpuVec<u32>,
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
            is_see_through: scene.is_see_through(),
            nodes: context.binding_of("scene.nodes", view.nodes)?,
            triangles: context.binding_of("scene.triangles", view.triangles)?,
            corners: context.binding_of("scene.corners", view.corners)?,
            surface: context.binding_of("scene.surface", view.surface)?,
        })
    }

    /// Makes it another scene. Of the same scene in another pose, materials and textures stay; so do buffers whose size
    /// does. Where that fails, it does not hold a scene: make a new one.
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

    /// Whether some surface lets light pass.
    pub(super) fn is_see_through(&self) -> bool {
        self.is_see_through
    }

    /// How many triangles there are.
    pub(super) fn triangles(&self) -> u32 {
        self.triangles.count() as u32
    }

    /// What a pass takes as `scene`.
    #[must_use]
    pub fn arg(&self) -> SceneArg<'_, Gpu> {
        SceneArg {
            nodes: self.nodes.all(),
            triangles: self.triangles.all(),
            corners: self.corners.all(),
            surface: self.surface.all(),
        }
    }

    /// The arguments of a kernel that takes `scene`.
    #[must_use]
    pub fn args(&self) -> [(&'static str, Arg<'_>); 4] {
        [
            ("scene.nodes", Arg::Buffer(&self.nodes)),
            ("scene.triangles", Arg::Buffer(&self.triangles)),
            ("scene.corners", Arg::Buffer(&self.corners)),
            ("scene.surface", Arg::Buffer(&self.surface)),
        ]
    }

    /// The arguments of a kernel that finds what blocks rays, as `nodes`, `triangles` and `surface`.
    #[must_use]
    pub fn tree_args(&self) -> [(&'static str, Arg<'_>); 3] {
        [
            ("nodes", Arg::Buffer(&self.nodes)),
            ("triangles", Arg::Buffer(&self.triangles)),
            ("surface", Arg::Buffer(&self.surface)),
        ]
    }
}

/// The scene of the frame before, which is that of the next one more often than not.
#[derive(Debug, Default)]
pub(super) struct KeptScene(Option<GpuScene>);

impl KeptScene {
    /// Makes it `scene`: nothing is uploaded where it is that one already.
    pub(super) fn keep(
        &mut self,
        context: &GpuContext,
        scene: &SceneBuffers,
    ) -> Result<(), GpuError> {
        // Another scene goes first: there may not be room for two. One that cannot be updated is dropped.
        let known = self.0.take();
        let same = known.filter(|known| known.surface_id() == scene.surface_id());
        self.0 = Some(match same {
            Some(mut posed) => {
                posed.update(context, scene)?;
                posed
            }
            None => GpuScene::new(context, scene)?,
        });
        Ok(())
    }

    /// The scene that was kept last.
    pub(super) fn get(&self) -> Option<&GpuScene> {
        self.0.as_ref()
    }
}

/// A light map with the tables that a method reads.
///
/// While one lights the frame that renders, the next frame's may be made or updated on another thread.
#[derive(Debug)]
pub struct GpuEnv {
    size: UVec2,
    rotation: Vec2,
    texels: GpuVec<Vec4>,
    tables: GpuVec<u32>,
    built: BuiltTables,
}

impl GpuEnv {
    /// Uploads a light map for a method.
    ///
    /// # Errors
    ///
    /// [`SettingsError::Tables`](crate::prepare::render::SettingsError::Tables) where it was prepared for another one; [`GpuError::Limit`] where it is larger than a binding may be,
    /// and [`GpuError::OutOfMemory`].
    pub fn new(
        context: &GpuContext,
        env: &PreparedEnv,
        method: &Method,
    ) -> Result<Self, RenderError> {
        let view = env.view_for(method)?;
        let texels = context.binding_of("env.texels", view.texels);
        let tables = context.binding_of("env.tables", view.tables);
        Ok(Self {
            size: view.size,
            rotation: view.rotation,
            texels: texels.map_err(RenderError::device)?,
            tables: tables.map_err(RenderError::device)?,
            built: env.tables_for(method)?.clone(),
        })
    }

    /// Puts another light map in its place, into the same buffers where their sizes are the same.
    ///
    /// # Errors
    ///
    /// As [`Self::new`].
    pub fn update(
        &mut self,
        context: &GpuContext,
        env: &PreparedEnv,
        method: &Method,
    ) -> Result<(), RenderError> {
        let view = env.view_for(method)?;
        rewrite(context, &mut self.texels, view.texels).map_err(RenderError::device)?;
        rewrite(context, &mut self.tables, view.tables).map_err(RenderError::device)?;
        self.size = view.size;
        self.rotation = view.rotation;
        self.built = env.tables_for(method)?.clone();
        Ok(())
    }

    /// Whether it has the tables that a method reads.
    pub(super) fn serves(&self, method: &Method) -> bool {
        self.built.serve(method)
    }

    /// Its texels.
    pub(super) fn texels(&self) -> &GpuVec<Vec4> {
        &self.texels
    }

    /// What a pass takes as `env`.
    #[must_use]
    pub fn arg(&self) -> EnvironmentArg<'_, Gpu> {
        EnvironmentArg {
            texels: self.texels.all(),
            tables: self.tables.all(),
            size: self.size,
            rotation: self.rotation,
        }
    }

    /// The arguments of a kernel that takes `env`.
    #[must_use]
    pub fn args(&self) -> [(&'static str, Arg<'_>); 4] {
        [
            ("env.size", Arg::Value(bytemuck::bytes_of(&self.size))),
            (
                "env.rotation",
                Arg::Value(bytemuck::bytes_of(&self.rotation)),
            ),
            ("env.texels", Arg::Buffer(&self.texels)),
            ("env.tables", Arg::Buffer(&self.tables)),
        ]
    }
}

/// Puts other values in a buffer, or in one that replaces it where their number differs.
fn rewrite<T: Element>(
    context: &GpuContext,
    buffer: &mut GpuVec<T>,
    values: &[T],
) -> Result<(), GpuError> {
    if buffer.count() == values.len() as u64 {
        return context.write(buffer, values);
    }
    let label = buffer.label().to_owned();
    *buffer = context.binding_of(&label, values)?;
    Ok(())
}
