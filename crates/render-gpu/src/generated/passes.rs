//! Host file: the kernels with their arguments, for executors.
//!
//! Made from Rust by naga-front-rust; do not edit. This command writes it: cargo run --release -p glimt-generate

use glimt_executor::{Binder, Entry, Host, HostMemory, Memory, Pass};

use super::entries;

/// [`crate::kernels::environment::Environment`] in some memory.
#[derive(Clone, Copy)]
pub struct EnvironmentArg<'a, M: Memory> {
    /// Its `texels`.
    pub texels: M::Slice<'a, glam::Vec4>,
    /// Its `tables`.
    pub tables: M::Slice<'a, u32>,
    /// Its `size`.
    pub size: glam::UVec2,
    /// Its `rotation`.
    pub rotation: glam::Vec2,
}

impl<'a, M: Memory> EnvironmentArg<'a, M> {
    /// The same for a shorter time: [`Memory::shorten`].
    #[must_use]
    pub fn shorten<'b>(self) -> EnvironmentArg<'b, M>
    where
        'a: 'b,
    {
        EnvironmentArg {
            texels: M::shorten(self.texels),
            tables: M::shorten(self.tables),
            size: self.size,
            rotation: self.rotation,
        }
    }
}

impl<'a, M: HostMemory> EnvironmentArg<'a, M> {
    /// What the kernel takes.
    #[inline]
    pub fn view(self) -> crate::kernels::environment::Environment<'a> {
        crate::kernels::environment::Environment {
            texels: M::values(self.texels),
            tables: M::values(self.tables),
            size: self.size,
            rotation: self.rotation,
        }
    }
}

impl<'a> From<crate::kernels::environment::Environment<'a>> for EnvironmentArg<'a, Host> {
    fn from(view: crate::kernels::environment::Environment<'a>) -> Self {
        Self {
            texels: view.texels,
            tables: view.tables,
            size: view.size,
            rotation: view.rotation,
        }
    }
}

/// [`crate::kernels::scene::Scene`] in some memory.
#[derive(Clone, Copy)]
pub struct SceneArg<'a, M: Memory> {
    /// Its `nodes`.
    pub nodes: M::Slice<'a, crate::kernels::bvh::BvhNode>,
    /// Its `triangles`.
    pub triangles: M::Slice<'a, crate::kernels::triangle::Triangle>,
    /// Its `corners`.
    pub corners: M::Slice<'a, crate::kernels::scene::Corner>,
    /// Its `surface`.
    pub surface: M::Slice<'a, u32>,
}

impl<'a, M: Memory> SceneArg<'a, M> {
    /// The same for a shorter time: [`Memory::shorten`].
    #[must_use]
    pub fn shorten<'b>(self) -> SceneArg<'b, M>
    where
        'a: 'b,
    {
        SceneArg {
            nodes: M::shorten(self.nodes),
            triangles: M::shorten(self.triangles),
            corners: M::shorten(self.corners),
            surface: M::shorten(self.surface),
        }
    }
}

impl<'a, M: HostMemory> SceneArg<'a, M> {
    /// What the kernel takes.
    #[inline]
    pub fn view(self) -> crate::kernels::scene::Scene<'a> {
        crate::kernels::scene::Scene {
            nodes: M::values(self.nodes),
            triangles: M::values(self.triangles),
            corners: M::values(self.corners),
            surface: M::values(self.surface),
        }
    }
}

impl<'a> From<crate::kernels::scene::Scene<'a>> for SceneArg<'a, Host> {
    fn from(view: crate::kernels::scene::Scene<'a>) -> Self {
        Self {
            nodes: view.nodes,
            triangles: view.triangles,
            corners: view.corners,
            surface: view.surface,
        }
    }
}

/// [`crate::kernels::past::Past`] in some memory.
#[derive(Clone, Copy)]
pub struct PastArg<'a, M: Memory> {
    /// Its `motions`.
    pub motions: M::Slice<'a, glam::Mat4>,
    /// Its `states`.
    pub states: M::Slice<'a, crate::kernels::past::RayState>,
}

impl<'a, M: Memory> PastArg<'a, M> {
    /// The same for a shorter time: [`Memory::shorten`].
    #[must_use]
    pub fn shorten<'b>(self) -> PastArg<'b, M>
    where
        'a: 'b,
    {
        PastArg {
            motions: M::shorten(self.motions),
            states: M::shorten(self.states),
        }
    }
}

impl<'a, M: HostMemory> PastArg<'a, M> {
    /// What the kernel takes.
    #[inline]
    pub fn view(self) -> crate::kernels::past::Past<'a> {
        crate::kernels::past::Past {
            motions: M::values(self.motions),
            states: M::values(self.states),
        }
    }
}

impl<'a> From<crate::kernels::past::Past<'a>> for PastArg<'a, Host> {
    fn from(view: crate::kernels::past::Past<'a>) -> Self {
        Self {
            motions: view.motions,
            states: view.states,
        }
    }
}

/// [`crate::kernels::environment::RadianceMap`] in some memory.
#[derive(Clone, Copy)]
pub struct RadianceMapArg<'a, M: Memory> {
    /// Its `texels`.
    pub texels: M::Slice<'a, glam::Vec4>,
    /// Its `size`.
    pub size: glam::UVec2,
    /// Its `rotation`.
    pub rotation: glam::Vec2,
}

impl<'a, M: Memory> RadianceMapArg<'a, M> {
    /// The same for a shorter time: [`Memory::shorten`].
    #[must_use]
    pub fn shorten<'b>(self) -> RadianceMapArg<'b, M>
    where
        'a: 'b,
    {
        RadianceMapArg {
            texels: M::shorten(self.texels),
            size: self.size,
            rotation: self.rotation,
        }
    }
}

impl<'a, M: HostMemory> RadianceMapArg<'a, M> {
    /// What the kernel takes.
    #[inline]
    pub fn view(self) -> crate::kernels::environment::RadianceMap<'a> {
        crate::kernels::environment::RadianceMap {
            texels: M::values(self.texels),
            size: self.size,
            rotation: self.rotation,
        }
    }
}

impl<'a> From<crate::kernels::environment::RadianceMap<'a>> for RadianceMapArg<'a, Host> {
    fn from(view: crate::kernels::environment::RadianceMap<'a>) -> Self {
        Self {
            texels: view.texels,
            size: view.size,
            rotation: view.rotation,
        }
    }
}

/// [`glimt_probe::gather::GatherMap`] in some memory.
#[derive(Clone, Copy)]
pub struct GatherMapArg<'a, M: Memory> {
    /// Its `texels`.
    pub texels: M::Slice<'a, glimt_probe::gather::TexelTaps>,
    /// Its `taps`.
    pub taps: M::Slice<'a, u32>,
}

impl<'a, M: Memory> GatherMapArg<'a, M> {
    /// The same for a shorter time: [`Memory::shorten`].
    #[must_use]
    pub fn shorten<'b>(self) -> GatherMapArg<'b, M>
    where
        'a: 'b,
    {
        GatherMapArg {
            texels: M::shorten(self.texels),
            taps: M::shorten(self.taps),
        }
    }
}

impl<'a, M: HostMemory> GatherMapArg<'a, M> {
    /// What the kernel takes.
    #[inline]
    pub fn view(self) -> glimt_probe::gather::GatherMap<'a> {
        glimt_probe::gather::GatherMap {
            texels: M::values(self.texels),
            taps: M::values(self.taps),
        }
    }
}

impl<'a> From<glimt_probe::gather::GatherMap<'a>> for GatherMapArg<'a, Host> {
    fn from(view: glimt_probe::gather::GatherMap<'a>) -> Self {
        Self {
            texels: view.texels,
            taps: view.taps,
        }
    }
}

/// [`crate::kernels::stage::Stage`] in some memory.
#[derive(Clone, Copy)]
pub struct StageArg<'a, M: Memory> {
    /// Its `texels`.
    pub texels: M::Slice<'a, glam::Vec4>,
    /// Its `params`.
    pub params: crate::kernels::stage::StageParams,
}

impl<'a, M: Memory> StageArg<'a, M> {
    /// The same for a shorter time: [`Memory::shorten`].
    #[must_use]
    pub fn shorten<'b>(self) -> StageArg<'b, M>
    where
        'a: 'b,
    {
        StageArg {
            texels: M::shorten(self.texels),
            params: self.params,
        }
    }
}

impl<'a, M: HostMemory> StageArg<'a, M> {
    /// What the kernel takes.
    #[inline]
    pub fn view(self) -> crate::kernels::stage::Stage<'a> {
        crate::kernels::stage::Stage {
            texels: M::values(self.texels),
            params: self.params,
        }
    }
}

impl<'a> From<crate::kernels::stage::Stage<'a>> for StageArg<'a, Host> {
    fn from(view: crate::kernels::stage::Stage<'a>) -> Self {
        Self {
            texels: view.texels,
            params: view.params,
        }
    }
}

/// `shade::shade::<crate::kernels::mis::Mis, glam::Vec4>` with its arguments.
pub struct ShadeMis<'a, M: Memory> {
    /// The kernel's `frame`.
    pub frame: &'a crate::kernels::frame::FrameParams,
    /// The kernel's `estimator`.
    pub estimator: &'a crate::kernels::mis::Mis,
    /// The kernel's `env`.
    pub env: EnvironmentArg<'a, M>,
    /// The kernel's `scene`.
    pub scene: SceneArg<'a, M>,
    /// What the kernel returns.
    pub out: M::Chunks<'a, glam::Vec4>,
}

impl<'a, M: Memory> Pass for ShadeMis<'a, M> {
    type Memory = M;

    fn entry() -> &'static Entry {
        &entries::SHADE_MIS
    }

    fn bind(&self, binder: &mut impl Binder<M>) {
        binder.value(2, self.frame);
        binder.value(3, self.estimator);
        binder.value(4, &self.env.size);
        binder.value(5, &self.env.rotation);
        binder.slice(0, self.env.texels);
        binder.slice(1, self.env.tables);
        binder.slice(2, self.scene.nodes);
        binder.slice(3, self.scene.triangles);
        binder.slice(4, self.scene.corners);
        binder.slice(5, self.scene.surface);
        binder.out(6, &self.out);
    }

    fn elements(&self) -> usize
    where
        M: HostMemory,
    {
        M::count(&self.out)
    }

    fn split_at(self, at: usize) -> (Self, Self)
    where
        M: HostMemory,
    {
        let (out, rest_of_out) = M::split_at(self.out, at);
        (
            Self { frame: self.frame, estimator: self.estimator, env: self.env, scene: self.scene, out },
            Self { frame: self.frame, estimator: self.estimator, env: self.env, scene: self.scene, out: rest_of_out },
        )
    }

    fn compute(self, first: u32)
    where
        M: HostMemory,
    {
        let env = self.env.view();
        let scene = self.scene.view();
        for (id, out) in (first..).zip(M::each(self.out)) {
            out[0] = crate::kernels::shade::shade::<crate::kernels::mis::Mis, glam::Vec4>(id, self.frame, self.estimator, env, scene);
        }
    }
}

/// `shade::shade::<crate::kernels::mis::Mis, crate::kernels::layers::LayerSample>` with its arguments.
pub struct ShadeMisLayers<'a, M: Memory> {
    /// The kernel's `frame`.
    pub frame: &'a crate::kernels::frame::FrameParams,
    /// The kernel's `estimator`.
    pub estimator: &'a crate::kernels::mis::Mis,
    /// The kernel's `env`.
    pub env: EnvironmentArg<'a, M>,
    /// The kernel's `scene`.
    pub scene: SceneArg<'a, M>,
    /// What the kernel returns.
    pub out: M::Chunks<'a, crate::kernels::layers::LayerSample>,
}

impl<'a, M: Memory> Pass for ShadeMisLayers<'a, M> {
    type Memory = M;

    fn entry() -> &'static Entry {
        &entries::SHADE_MIS_LAYERS
    }

    fn bind(&self, binder: &mut impl Binder<M>) {
        binder.value(2, self.frame);
        binder.value(3, self.estimator);
        binder.value(4, &self.env.size);
        binder.value(5, &self.env.rotation);
        binder.slice(0, self.env.texels);
        binder.slice(1, self.env.tables);
        binder.slice(2, self.scene.nodes);
        binder.slice(3, self.scene.triangles);
        binder.slice(4, self.scene.corners);
        binder.slice(5, self.scene.surface);
        binder.out(6, &self.out);
    }

    fn elements(&self) -> usize
    where
        M: HostMemory,
    {
        M::count(&self.out)
    }

    fn split_at(self, at: usize) -> (Self, Self)
    where
        M: HostMemory,
    {
        let (out, rest_of_out) = M::split_at(self.out, at);
        (
            Self { frame: self.frame, estimator: self.estimator, env: self.env, scene: self.scene, out },
            Self { frame: self.frame, estimator: self.estimator, env: self.env, scene: self.scene, out: rest_of_out },
        )
    }

    fn compute(self, first: u32)
    where
        M: HostMemory,
    {
        let env = self.env.view();
        let scene = self.scene.view();
        for (id, out) in (first..).zip(M::each(self.out)) {
            out[0] = crate::kernels::shade::shade::<crate::kernels::mis::Mis, crate::kernels::layers::LayerSample>(id, self.frame, self.estimator, env, scene);
        }
    }
}

/// `shade::shade::<crate::kernels::bis::Bis, glam::Vec4>` with its arguments.
pub struct ShadeBis<'a, M: Memory> {
    /// The kernel's `frame`.
    pub frame: &'a crate::kernels::frame::FrameParams,
    /// The kernel's `estimator`.
    pub estimator: &'a crate::kernels::bis::Bis,
    /// The kernel's `env`.
    pub env: EnvironmentArg<'a, M>,
    /// The kernel's `scene`.
    pub scene: SceneArg<'a, M>,
    /// What the kernel returns.
    pub out: M::Chunks<'a, glam::Vec4>,
}

impl<'a, M: Memory> Pass for ShadeBis<'a, M> {
    type Memory = M;

    fn entry() -> &'static Entry {
        &entries::SHADE_BIS
    }

    fn bind(&self, binder: &mut impl Binder<M>) {
        binder.value(2, self.frame);
        binder.value(3, self.estimator);
        binder.value(4, &self.env.size);
        binder.value(5, &self.env.rotation);
        binder.slice(0, self.env.texels);
        binder.slice(1, self.env.tables);
        binder.slice(2, self.scene.nodes);
        binder.slice(3, self.scene.triangles);
        binder.slice(4, self.scene.corners);
        binder.slice(5, self.scene.surface);
        binder.out(6, &self.out);
    }

    fn elements(&self) -> usize
    where
        M: HostMemory,
    {
        M::count(&self.out)
    }

    fn split_at(self, at: usize) -> (Self, Self)
    where
        M: HostMemory,
    {
        let (out, rest_of_out) = M::split_at(self.out, at);
        (
            Self { frame: self.frame, estimator: self.estimator, env: self.env, scene: self.scene, out },
            Self { frame: self.frame, estimator: self.estimator, env: self.env, scene: self.scene, out: rest_of_out },
        )
    }

    fn compute(self, first: u32)
    where
        M: HostMemory,
    {
        let env = self.env.view();
        let scene = self.scene.view();
        for (id, out) in (first..).zip(M::each(self.out)) {
            out[0] = crate::kernels::shade::shade::<crate::kernels::bis::Bis, glam::Vec4>(id, self.frame, self.estimator, env, scene);
        }
    }
}

/// `shade::shade::<crate::kernels::bis::Bis, crate::kernels::layers::LayerSample>` with its arguments.
pub struct ShadeBisLayers<'a, M: Memory> {
    /// The kernel's `frame`.
    pub frame: &'a crate::kernels::frame::FrameParams,
    /// The kernel's `estimator`.
    pub estimator: &'a crate::kernels::bis::Bis,
    /// The kernel's `env`.
    pub env: EnvironmentArg<'a, M>,
    /// The kernel's `scene`.
    pub scene: SceneArg<'a, M>,
    /// What the kernel returns.
    pub out: M::Chunks<'a, crate::kernels::layers::LayerSample>,
}

impl<'a, M: Memory> Pass for ShadeBisLayers<'a, M> {
    type Memory = M;

    fn entry() -> &'static Entry {
        &entries::SHADE_BIS_LAYERS
    }

    fn bind(&self, binder: &mut impl Binder<M>) {
        binder.value(2, self.frame);
        binder.value(3, self.estimator);
        binder.value(4, &self.env.size);
        binder.value(5, &self.env.rotation);
        binder.slice(0, self.env.texels);
        binder.slice(1, self.env.tables);
        binder.slice(2, self.scene.nodes);
        binder.slice(3, self.scene.triangles);
        binder.slice(4, self.scene.corners);
        binder.slice(5, self.scene.surface);
        binder.out(6, &self.out);
    }

    fn elements(&self) -> usize
    where
        M: HostMemory,
    {
        M::count(&self.out)
    }

    fn split_at(self, at: usize) -> (Self, Self)
    where
        M: HostMemory,
    {
        let (out, rest_of_out) = M::split_at(self.out, at);
        (
            Self { frame: self.frame, estimator: self.estimator, env: self.env, scene: self.scene, out },
            Self { frame: self.frame, estimator: self.estimator, env: self.env, scene: self.scene, out: rest_of_out },
        )
    }

    fn compute(self, first: u32)
    where
        M: HostMemory,
    {
        let env = self.env.view();
        let scene = self.scene.view();
        for (id, out) in (first..).zip(M::each(self.out)) {
            out[0] = crate::kernels::shade::shade::<crate::kernels::bis::Bis, crate::kernels::layers::LayerSample>(id, self.frame, self.estimator, env, scene);
        }
    }
}

/// `product::shade_product::<glam::Vec4>` with its arguments.
pub struct ShadeProduct<'a, M: Memory> {
    /// The kernel's `frame`.
    pub frame: &'a crate::kernels::frame::FrameParams,
    /// The kernel's `product`.
    pub product: &'a crate::kernels::product::Product,
    /// The kernel's `env`.
    pub env: EnvironmentArg<'a, M>,
    /// The kernel's `scene`.
    pub scene: SceneArg<'a, M>,
    /// The kernel's own `points`.
    pub points: M::Chunks<'a, crate::kernels::seen::SeenPoint>,
    /// The kernel's own `samples`.
    pub samples: M::Chunks<'a, glam::Vec4>,
}

impl<'a, M: Memory> Pass for ShadeProduct<'a, M> {
    type Memory = M;

    fn entry() -> &'static Entry {
        &entries::SHADE_PRODUCT
    }

    fn bind(&self, binder: &mut impl Binder<M>) {
        binder.value(4, self.frame);
        binder.value(5, self.product);
        binder.value(6, &self.env.size);
        binder.value(7, &self.env.rotation);
        binder.slice(0, self.env.texels);
        binder.slice(1, self.env.tables);
        binder.slice(2, self.scene.nodes);
        binder.slice(3, self.scene.triangles);
        binder.slice(4, self.scene.surface);
        binder.chunks(5, 2, &self.points);
        binder.chunks(6, 3, &self.samples);
    }

    fn elements(&self) -> usize
    where
        M: HostMemory,
    {
        M::count(&self.points).min(M::count(&self.samples))
    }

    fn split_at(self, at: usize) -> (Self, Self)
    where
        M: HostMemory,
    {
        let (points, rest_of_points) = M::split_at(self.points, at);
        let (samples, rest_of_samples) = M::split_at(self.samples, at);
        (
            Self { frame: self.frame, product: self.product, env: self.env, scene: self.scene, points, samples },
            Self { frame: self.frame, product: self.product, env: self.env, scene: self.scene, points: rest_of_points, samples: rest_of_samples },
        )
    }

    fn compute(self, first: u32)
    where
        M: HostMemory,
    {
        let env = self.env.view();
        let scene = self.scene.view();
        for ((id, points), samples) in (first..).zip(M::each(self.points)).zip(M::each(self.samples)) {
            crate::kernels::product::shade_product::<glam::Vec4>(id, self.frame, self.product, env, scene, points, samples);
        }
    }
}

/// `product::shade_product::<crate::kernels::layers::LayerSample>` with its arguments.
pub struct ShadeProductLayers<'a, M: Memory> {
    /// The kernel's `frame`.
    pub frame: &'a crate::kernels::frame::FrameParams,
    /// The kernel's `product`.
    pub product: &'a crate::kernels::product::Product,
    /// The kernel's `env`.
    pub env: EnvironmentArg<'a, M>,
    /// The kernel's `scene`.
    pub scene: SceneArg<'a, M>,
    /// The kernel's own `points`.
    pub points: M::Chunks<'a, crate::kernels::seen::SeenPoint>,
    /// The kernel's own `samples`.
    pub samples: M::Chunks<'a, crate::kernels::layers::LayerSample>,
}

impl<'a, M: Memory> Pass for ShadeProductLayers<'a, M> {
    type Memory = M;

    fn entry() -> &'static Entry {
        &entries::SHADE_PRODUCT_LAYERS
    }

    fn bind(&self, binder: &mut impl Binder<M>) {
        binder.value(4, self.frame);
        binder.value(5, self.product);
        binder.value(6, &self.env.size);
        binder.value(7, &self.env.rotation);
        binder.slice(0, self.env.texels);
        binder.slice(1, self.env.tables);
        binder.slice(2, self.scene.nodes);
        binder.slice(3, self.scene.triangles);
        binder.slice(4, self.scene.surface);
        binder.chunks(5, 2, &self.points);
        binder.chunks(6, 3, &self.samples);
    }

    fn elements(&self) -> usize
    where
        M: HostMemory,
    {
        M::count(&self.points).min(M::count(&self.samples))
    }

    fn split_at(self, at: usize) -> (Self, Self)
    where
        M: HostMemory,
    {
        let (points, rest_of_points) = M::split_at(self.points, at);
        let (samples, rest_of_samples) = M::split_at(self.samples, at);
        (
            Self { frame: self.frame, product: self.product, env: self.env, scene: self.scene, points, samples },
            Self { frame: self.frame, product: self.product, env: self.env, scene: self.scene, points: rest_of_points, samples: rest_of_samples },
        )
    }

    fn compute(self, first: u32)
    where
        M: HostMemory,
    {
        let env = self.env.view();
        let scene = self.scene.view();
        for ((id, points), samples) in (first..).zip(M::each(self.points)).zip(M::each(self.samples)) {
            crate::kernels::product::shade_product::<crate::kernels::layers::LayerSample>(id, self.frame, self.product, env, scene, points, samples);
        }
    }
}

/// `seen::see` with its arguments.
pub struct See<'a, M: Memory> {
    /// The kernel's `frame`.
    pub frame: &'a crate::kernels::frame::FrameParams,
    /// The kernel's `scene`.
    pub scene: SceneArg<'a, M>,
    /// What the kernel returns.
    pub out: M::Chunks<'a, crate::kernels::seen::SeenPoint>,
}

impl<'a, M: Memory> Pass for See<'a, M> {
    type Memory = M;

    fn entry() -> &'static Entry {
        &entries::SEE
    }

    fn bind(&self, binder: &mut impl Binder<M>) {
        binder.value(2, self.frame);
        binder.slice(0, self.scene.nodes);
        binder.slice(1, self.scene.triangles);
        binder.slice(2, self.scene.corners);
        binder.slice(3, self.scene.surface);
        binder.out(4, &self.out);
    }

    fn elements(&self) -> usize
    where
        M: HostMemory,
    {
        M::count(&self.out)
    }

    fn split_at(self, at: usize) -> (Self, Self)
    where
        M: HostMemory,
    {
        let (out, rest_of_out) = M::split_at(self.out, at);
        (
            Self { frame: self.frame, scene: self.scene, out },
            Self { frame: self.frame, scene: self.scene, out: rest_of_out },
        )
    }

    fn compute(self, first: u32)
    where
        M: HostMemory,
    {
        let scene = self.scene.view();
        for (id, out) in (first..).zip(M::each(self.out)) {
            out[0] = crate::kernels::seen::see(id, self.frame, scene);
        }
    }
}

/// `scout::scout` with its arguments.
pub struct Scout<'a, M: Memory> {
    /// The kernel's `frame`.
    pub frame: &'a crate::kernels::frame::FrameParams,
    /// The kernel's `cells`.
    pub cells: &'a crate::kernels::scout::CellParams,
    /// The kernel's `scene`.
    pub scene: SceneArg<'a, M>,
    /// The kernel's own `entries`.
    pub entries: M::Chunks<'a, crate::kernels::cell_state::TileEntry>,
}

impl<'a, M: Memory> Pass for Scout<'a, M> {
    type Memory = M;

    fn entry() -> &'static Entry {
        &entries::SCOUT
    }

    fn bind(&self, binder: &mut impl Binder<M>) {
        binder.value(3, self.frame);
        binder.value(4, self.cells);
        binder.slice(0, self.scene.nodes);
        binder.slice(1, self.scene.triangles);
        binder.slice(2, self.scene.corners);
        binder.slice(3, self.scene.surface);
        binder.chunks(4, 2, &self.entries);
    }

    fn elements(&self) -> usize
    where
        M: HostMemory,
    {
        M::count(&self.entries)
    }

    fn split_at(self, at: usize) -> (Self, Self)
    where
        M: HostMemory,
    {
        let (entries, rest_of_entries) = M::split_at(self.entries, at);
        (
            Self { frame: self.frame, cells: self.cells, scene: self.scene, entries },
            Self { frame: self.frame, cells: self.cells, scene: self.scene, entries: rest_of_entries },
        )
    }

    fn compute(self, first: u32)
    where
        M: HostMemory,
    {
        let scene = self.scene.view();
        for (id, entries) in (first..).zip(M::each(self.entries)) {
            crate::kernels::scout::scout(id, self.frame, self.cells, scene, entries);
        }
    }
}

/// `scout::see_in_tile` with its arguments.
pub struct SeeInTile<'a, M: Memory> {
    /// The kernel's `frame`.
    pub frame: &'a crate::kernels::frame::FrameParams,
    /// The kernel's `cells`.
    pub cells: &'a crate::kernels::scout::CellParams,
    /// The kernel's `scene`.
    pub scene: SceneArg<'a, M>,
    /// The kernel's `entries`.
    pub entries: M::Slice<'a, crate::kernels::cell_state::TileEntry>,
    /// What the kernel returns.
    pub out: M::Chunks<'a, crate::kernels::seen::SeenPoint>,
}

impl<'a, M: Memory> Pass for SeeInTile<'a, M> {
    type Memory = M;

    fn entry() -> &'static Entry {
        &entries::SEE_IN_TILE
    }

    fn bind(&self, binder: &mut impl Binder<M>) {
        binder.value(2, self.frame);
        binder.value(3, self.cells);
        binder.slice(0, self.scene.nodes);
        binder.slice(1, self.scene.triangles);
        binder.slice(2, self.scene.corners);
        binder.slice(3, self.scene.surface);
        binder.slice(4, self.entries);
        binder.out(5, &self.out);
    }

    fn elements(&self) -> usize
    where
        M: HostMemory,
    {
        M::count(&self.out)
    }

    fn split_at(self, at: usize) -> (Self, Self)
    where
        M: HostMemory,
    {
        let (out, rest_of_out) = M::split_at(self.out, at);
        (
            Self { frame: self.frame, cells: self.cells, scene: self.scene, entries: self.entries, out },
            Self { frame: self.frame, cells: self.cells, scene: self.scene, entries: self.entries, out: rest_of_out },
        )
    }

    fn compute(self, first: u32)
    where
        M: HostMemory,
    {
        let scene = self.scene.view();
        let entries = M::values(self.entries);
        for (id, out) in (first..).zip(M::each(self.out)) {
            out[0] = crate::kernels::scout::see_in_tile(id, self.frame, self.cells, scene, entries);
        }
    }
}

/// `carry::carry` with its arguments.
pub struct Carry<'a, M: Memory> {
    /// The kernel's `frame`.
    pub frame: &'a crate::kernels::frame::FrameParams,
    /// The kernel's `cells`.
    pub cells: &'a crate::kernels::scout::CellParams,
    /// The kernel's `view`.
    pub view: &'a crate::kernels::past::PastView,
    /// The kernel's `env`.
    pub env: EnvironmentArg<'a, M>,
    /// The kernel's `motions`.
    pub motions: M::Slice<'a, glam::Mat4>,
    /// The kernel's `past_entries`.
    pub past_entries: M::Slice<'a, crate::kernels::cell_state::TileEntry>,
    /// The kernel's `past_counts`.
    pub past_counts: M::Slice<'a, u32>,
    /// The kernel's own `entries`.
    pub entries: M::Chunks<'a, crate::kernels::cell_state::TileEntry>,
}

impl<'a, M: Memory> Pass for Carry<'a, M> {
    type Memory = M;

    fn entry() -> &'static Entry {
        &entries::CARRY
    }

    fn bind(&self, binder: &mut impl Binder<M>) {
        binder.value(3, self.frame);
        binder.value(4, self.cells);
        binder.value(5, self.view);
        binder.value(6, &self.env.size);
        binder.value(7, &self.env.rotation);
        binder.slice(0, self.env.tables);
        binder.slice(1, self.motions);
        binder.slice(2, self.past_entries);
        binder.slice(3, self.past_counts);
        binder.chunks(4, 2, &self.entries);
    }

    fn elements(&self) -> usize
    where
        M: HostMemory,
    {
        M::count(&self.entries)
    }

    fn split_at(self, at: usize) -> (Self, Self)
    where
        M: HostMemory,
    {
        let (entries, rest_of_entries) = M::split_at(self.entries, at);
        (
            Self { frame: self.frame, cells: self.cells, view: self.view, env: self.env, motions: self.motions, past_entries: self.past_entries, past_counts: self.past_counts, entries },
            Self { frame: self.frame, cells: self.cells, view: self.view, env: self.env, motions: self.motions, past_entries: self.past_entries, past_counts: self.past_counts, entries: rest_of_entries },
        )
    }

    fn compute(self, first: u32)
    where
        M: HostMemory,
    {
        let env = self.env.view();
        let motions = M::values(self.motions);
        let past_entries = M::values(self.past_entries);
        let past_counts = M::values(self.past_counts);
        for (id, entries) in (first..).zip(M::each(self.entries)) {
            crate::kernels::carry::carry(id, self.frame, self.cells, self.view, env, motions, past_entries, past_counts, entries);
        }
    }
}

/// `pilot::pilot` with its arguments.
pub struct Pilot<'a, M: Memory> {
    /// The kernel's `frame`.
    pub frame: &'a crate::kernels::frame::FrameParams,
    /// The kernel's `cells`.
    pub cells: &'a crate::kernels::scout::CellParams,
    /// The kernel's `env`.
    pub env: EnvironmentArg<'a, M>,
    /// The kernel's `scene`.
    pub scene: SceneArg<'a, M>,
    /// The kernel's `entries`.
    pub entries: M::Slice<'a, crate::kernels::cell_state::TileEntry>,
    /// The kernel's `past_counts`.
    pub past_counts: M::Slice<'a, u32>,
    /// The kernel's own `counts`.
    pub counts: M::Chunks<'a, u32>,
}

impl<'a, M: Memory> Pass for Pilot<'a, M> {
    type Memory = M;

    fn entry() -> &'static Entry {
        &entries::PILOT
    }

    fn bind(&self, binder: &mut impl Binder<M>) {
        binder.value(3, self.frame);
        binder.value(4, self.cells);
        binder.value(5, &self.env.size);
        binder.value(6, &self.env.rotation);
        binder.slice(0, self.env.tables);
        binder.slice(1, self.scene.nodes);
        binder.slice(2, self.scene.triangles);
        binder.slice(3, self.scene.corners);
        binder.slice(4, self.scene.surface);
        binder.slice(5, self.entries);
        binder.slice(6, self.past_counts);
        binder.chunks(7, 2, &self.counts);
    }

    fn elements(&self) -> usize
    where
        M: HostMemory,
    {
        M::count(&self.counts)
    }

    fn split_at(self, at: usize) -> (Self, Self)
    where
        M: HostMemory,
    {
        let (counts, rest_of_counts) = M::split_at(self.counts, at);
        (
            Self { frame: self.frame, cells: self.cells, env: self.env, scene: self.scene, entries: self.entries, past_counts: self.past_counts, counts },
            Self { frame: self.frame, cells: self.cells, env: self.env, scene: self.scene, entries: self.entries, past_counts: self.past_counts, counts: rest_of_counts },
        )
    }

    fn compute(self, first: u32)
    where
        M: HostMemory,
    {
        let env = self.env.view();
        let scene = self.scene.view();
        let entries = M::values(self.entries);
        let past_counts = M::values(self.past_counts);
        for (id, counts) in (first..).zip(M::each(self.counts)) {
            crate::kernels::pilot::pilot(id, self.frame, self.cells, env, scene, entries, past_counts, counts);
        }
    }
}

/// `expect::expect` with its arguments.
pub struct Expect<'a, M: Memory> {
    /// The kernel's `cells`.
    pub cells: &'a crate::kernels::scout::CellParams,
    /// The kernel's `entries`.
    pub entries: M::Slice<'a, crate::kernels::cell_state::TileEntry>,
    /// The kernel's `counts`.
    pub counts: M::Slice<'a, u32>,
    /// The kernel's own `visibility`.
    pub visibility: M::Chunks<'a, u32>,
}

impl<'a, M: Memory> Pass for Expect<'a, M> {
    type Memory = M;

    fn entry() -> &'static Entry {
        &entries::EXPECT
    }

    fn bind(&self, binder: &mut impl Binder<M>) {
        binder.value(3, self.cells);
        binder.slice(0, self.entries);
        binder.slice(1, self.counts);
        binder.chunks(2, 2, &self.visibility);
    }

    fn elements(&self) -> usize
    where
        M: HostMemory,
    {
        M::count(&self.visibility)
    }

    fn split_at(self, at: usize) -> (Self, Self)
    where
        M: HostMemory,
    {
        let (visibility, rest_of_visibility) = M::split_at(self.visibility, at);
        (
            Self { cells: self.cells, entries: self.entries, counts: self.counts, visibility },
            Self { cells: self.cells, entries: self.entries, counts: self.counts, visibility: rest_of_visibility },
        )
    }

    fn compute(self, first: u32)
    where
        M: HostMemory,
    {
        let entries = M::values(self.entries);
        let counts = M::values(self.counts);
        for (id, visibility) in (first..).zip(M::each(self.visibility)) {
            crate::kernels::expect::expect(id, self.cells, entries, counts, visibility);
        }
    }
}

/// `expect::worth` with its arguments.
pub struct Worth<'a, M: Memory> {
    /// The kernel's `frame`.
    pub frame: &'a crate::kernels::frame::FrameParams,
    /// The kernel's `env`.
    pub env: EnvironmentArg<'a, M>,
    /// The kernel's `entries`.
    pub entries: M::Slice<'a, crate::kernels::cell_state::TileEntry>,
    /// The kernel's `visibility`.
    pub visibility: M::Slice<'a, u32>,
    /// What the kernel returns.
    pub out: M::Chunks<'a, f32>,
}

impl<'a, M: Memory> Pass for Worth<'a, M> {
    type Memory = M;

    fn entry() -> &'static Entry {
        &entries::WORTH
    }

    fn bind(&self, binder: &mut impl Binder<M>) {
        binder.value(2, self.frame);
        binder.value(3, &self.env.size);
        binder.value(4, &self.env.rotation);
        binder.slice(0, self.env.tables);
        binder.slice(1, self.entries);
        binder.slice(2, self.visibility);
        binder.out(3, &self.out);
    }

    fn elements(&self) -> usize
    where
        M: HostMemory,
    {
        M::count(&self.out)
    }

    fn split_at(self, at: usize) -> (Self, Self)
    where
        M: HostMemory,
    {
        let (out, rest_of_out) = M::split_at(self.out, at);
        (
            Self { frame: self.frame, env: self.env, entries: self.entries, visibility: self.visibility, out },
            Self { frame: self.frame, env: self.env, entries: self.entries, visibility: self.visibility, out: rest_of_out },
        )
    }

    fn compute(self, first: u32)
    where
        M: HostMemory,
    {
        let env = self.env.view();
        let entries = M::values(self.entries);
        let visibility = M::values(self.visibility);
        for (id, out) in (first..).zip(M::each(self.out)) {
            out[0] = crate::kernels::expect::worth(id, self.frame, env, entries, visibility);
        }
    }
}

/// `expect::add_worths` with its arguments.
pub struct AddWorths<'a, M: Memory> {
    /// The kernel's `cells`.
    pub cells: &'a crate::kernels::scout::CellParams,
    /// The kernel's `parts`.
    pub parts: u32,
    /// The kernel's `worths`.
    pub worths: M::Slice<'a, f32>,
    /// What the kernel returns.
    pub out: M::Chunks<'a, u32>,
}

impl<'a, M: Memory> Pass for AddWorths<'a, M> {
    type Memory = M;

    fn entry() -> &'static Entry {
        &entries::ADD_WORTHS
    }

    fn bind(&self, binder: &mut impl Binder<M>) {
        binder.value(2, self.cells);
        binder.value(3, &self.parts);
        binder.slice(0, self.worths);
        binder.out(1, &self.out);
    }

    fn elements(&self) -> usize
    where
        M: HostMemory,
    {
        M::count(&self.out)
    }

    fn split_at(self, at: usize) -> (Self, Self)
    where
        M: HostMemory,
    {
        let (out, rest_of_out) = M::split_at(self.out, at);
        (
            Self { cells: self.cells, parts: self.parts, worths: self.worths, out },
            Self { cells: self.cells, parts: self.parts, worths: self.worths, out: rest_of_out },
        )
    }

    fn compute(self, first: u32)
    where
        M: HostMemory,
    {
        let worths = M::values(self.worths);
        for (id, out) in (first..).zip(M::each(self.out)) {
            out[0] = crate::kernels::expect::add_worths(id, self.cells, self.parts, worths);
        }
    }
}

/// `cells::shade_cells::<glam::Vec4>` with its arguments.
pub struct ShadeCells<'a, M: Memory> {
    /// The kernel's `frame`.
    pub frame: &'a crate::kernels::frame::FrameParams,
    /// The kernel's `cells`.
    pub cells: &'a crate::kernels::scout::CellParams,
    /// The kernel's `env`.
    pub env: EnvironmentArg<'a, M>,
    /// The kernel's `scene`.
    pub scene: SceneArg<'a, M>,
    /// The kernel's `visibility`.
    pub visibility: M::Slice<'a, u32>,
    /// The kernel's own `points`.
    pub points: M::Chunks<'a, crate::kernels::seen::SeenPoint>,
    /// The kernel's own `samples`.
    pub samples: M::Chunks<'a, glam::Vec4>,
}

impl<'a, M: Memory> Pass for ShadeCells<'a, M> {
    type Memory = M;

    fn entry() -> &'static Entry {
        &entries::SHADE_CELLS
    }

    fn bind(&self, binder: &mut impl Binder<M>) {
        binder.value(4, self.frame);
        binder.value(5, self.cells);
        binder.value(6, &self.env.size);
        binder.value(7, &self.env.rotation);
        binder.slice(0, self.env.texels);
        binder.slice(1, self.env.tables);
        binder.slice(2, self.scene.nodes);
        binder.slice(3, self.scene.triangles);
        binder.slice(4, self.scene.surface);
        binder.slice(5, self.visibility);
        binder.chunks(6, 2, &self.points);
        binder.chunks(7, 3, &self.samples);
    }

    fn elements(&self) -> usize
    where
        M: HostMemory,
    {
        M::count(&self.points).min(M::count(&self.samples))
    }

    fn split_at(self, at: usize) -> (Self, Self)
    where
        M: HostMemory,
    {
        let (points, rest_of_points) = M::split_at(self.points, at);
        let (samples, rest_of_samples) = M::split_at(self.samples, at);
        (
            Self { frame: self.frame, cells: self.cells, env: self.env, scene: self.scene, visibility: self.visibility, points, samples },
            Self { frame: self.frame, cells: self.cells, env: self.env, scene: self.scene, visibility: self.visibility, points: rest_of_points, samples: rest_of_samples },
        )
    }

    fn compute(self, first: u32)
    where
        M: HostMemory,
    {
        let env = self.env.view();
        let scene = self.scene.view();
        let visibility = M::values(self.visibility);
        for ((id, points), samples) in (first..).zip(M::each(self.points)).zip(M::each(self.samples)) {
            crate::kernels::cells::shade_cells::<glam::Vec4>(id, self.frame, self.cells, env, scene, visibility, points, samples);
        }
    }
}

/// `cells::shade_cells::<crate::kernels::layers::LayerSample>` with its arguments.
pub struct ShadeCellsLayers<'a, M: Memory> {
    /// The kernel's `frame`.
    pub frame: &'a crate::kernels::frame::FrameParams,
    /// The kernel's `cells`.
    pub cells: &'a crate::kernels::scout::CellParams,
    /// The kernel's `env`.
    pub env: EnvironmentArg<'a, M>,
    /// The kernel's `scene`.
    pub scene: SceneArg<'a, M>,
    /// The kernel's `visibility`.
    pub visibility: M::Slice<'a, u32>,
    /// The kernel's own `points`.
    pub points: M::Chunks<'a, crate::kernels::seen::SeenPoint>,
    /// The kernel's own `samples`.
    pub samples: M::Chunks<'a, crate::kernels::layers::LayerSample>,
}

impl<'a, M: Memory> Pass for ShadeCellsLayers<'a, M> {
    type Memory = M;

    fn entry() -> &'static Entry {
        &entries::SHADE_CELLS_LAYERS
    }

    fn bind(&self, binder: &mut impl Binder<M>) {
        binder.value(4, self.frame);
        binder.value(5, self.cells);
        binder.value(6, &self.env.size);
        binder.value(7, &self.env.rotation);
        binder.slice(0, self.env.texels);
        binder.slice(1, self.env.tables);
        binder.slice(2, self.scene.nodes);
        binder.slice(3, self.scene.triangles);
        binder.slice(4, self.scene.surface);
        binder.slice(5, self.visibility);
        binder.chunks(6, 2, &self.points);
        binder.chunks(7, 3, &self.samples);
    }

    fn elements(&self) -> usize
    where
        M: HostMemory,
    {
        M::count(&self.points).min(M::count(&self.samples))
    }

    fn split_at(self, at: usize) -> (Self, Self)
    where
        M: HostMemory,
    {
        let (points, rest_of_points) = M::split_at(self.points, at);
        let (samples, rest_of_samples) = M::split_at(self.samples, at);
        (
            Self { frame: self.frame, cells: self.cells, env: self.env, scene: self.scene, visibility: self.visibility, points, samples },
            Self { frame: self.frame, cells: self.cells, env: self.env, scene: self.scene, visibility: self.visibility, points: rest_of_points, samples: rest_of_samples },
        )
    }

    fn compute(self, first: u32)
    where
        M: HostMemory,
    {
        let env = self.env.view();
        let scene = self.scene.view();
        let visibility = M::values(self.visibility);
        for ((id, points), samples) in (first..).zip(M::each(self.points)).zip(M::each(self.samples)) {
            crate::kernels::cells::shade_cells::<crate::kernels::layers::LayerSample>(id, self.frame, self.cells, env, scene, visibility, points, samples);
        }
    }
}

/// `group_health::diagnose_groups` with its arguments.
pub struct DiagnoseGroups<'a, M: Memory> {
    /// The kernel's `frame`.
    pub frame: &'a crate::kernels::frame::FrameParams,
    /// The kernel's `points`.
    pub points: M::Slice<'a, crate::kernels::seen::SeenPoint>,
    /// What the kernel returns.
    pub out: M::Chunks<'a, crate::kernels::group_health::GroupHealth>,
}

impl<'a, M: Memory> Pass for DiagnoseGroups<'a, M> {
    type Memory = M;

    fn entry() -> &'static Entry {
        &entries::DIAGNOSE_GROUPS
    }

    fn bind(&self, binder: &mut impl Binder<M>) {
        binder.value(2, self.frame);
        binder.slice(0, self.points);
        binder.out(1, &self.out);
    }

    fn elements(&self) -> usize
    where
        M: HostMemory,
    {
        M::count(&self.out)
    }

    fn split_at(self, at: usize) -> (Self, Self)
    where
        M: HostMemory,
    {
        let (out, rest_of_out) = M::split_at(self.out, at);
        (
            Self { frame: self.frame, points: self.points, out },
            Self { frame: self.frame, points: self.points, out: rest_of_out },
        )
    }

    fn compute(self, first: u32)
    where
        M: HostMemory,
    {
        let points = M::values(self.points);
        for (id, out) in (first..).zip(M::each(self.out)) {
            out[0] = crate::kernels::group_health::diagnose_groups(id, self.frame, points);
        }
    }
}

/// `smc_point::find_smc` with its arguments.
pub struct FindSmc<'a, M: Memory> {
    /// The kernel's `frame`.
    pub frame: &'a crate::kernels::frame::FrameParams,
    /// The kernel's `view`.
    pub view: &'a crate::kernels::past::PastView,
    /// The kernel's `scene`.
    pub scene: SceneArg<'a, M>,
    /// The kernel's `past`.
    pub past: PastArg<'a, M>,
    /// What the kernel returns.
    pub out: M::Chunks<'a, crate::kernels::smc_point::SmcPoint>,
}

impl<'a, M: Memory> Pass for FindSmc<'a, M> {
    type Memory = M;

    fn entry() -> &'static Entry {
        &entries::FIND_SMC
    }

    fn bind(&self, binder: &mut impl Binder<M>) {
        binder.value(2, self.frame);
        binder.value(3, self.view);
        binder.slice(0, self.scene.nodes);
        binder.slice(1, self.scene.triangles);
        binder.slice(2, self.scene.corners);
        binder.slice(3, self.scene.surface);
        binder.slice(4, self.past.motions);
        binder.slice(5, self.past.states);
        binder.out(6, &self.out);
    }

    fn elements(&self) -> usize
    where
        M: HostMemory,
    {
        M::count(&self.out)
    }

    fn split_at(self, at: usize) -> (Self, Self)
    where
        M: HostMemory,
    {
        let (out, rest_of_out) = M::split_at(self.out, at);
        (
            Self { frame: self.frame, view: self.view, scene: self.scene, past: self.past, out },
            Self { frame: self.frame, view: self.view, scene: self.scene, past: self.past, out: rest_of_out },
        )
    }

    fn compute(self, first: u32)
    where
        M: HostMemory,
    {
        let scene = self.scene.view();
        let past = self.past.view();
        for (id, out) in (first..).zip(M::each(self.out)) {
            out[0] = crate::kernels::smc_point::find_smc(id, self.frame, self.view, scene, past);
        }
    }
}

/// `smc::advance_smc` with its arguments.
pub struct AdvanceSmc<'a, M: Memory> {
    /// The kernel's `frame`.
    pub frame: &'a crate::kernels::frame::FrameParams,
    /// The kernel's `smc`.
    pub smc: &'a crate::kernels::smc::SmcParams,
    /// The kernel's `env`.
    pub env: EnvironmentArg<'a, M>,
    /// The kernel's `before`.
    pub before: RadianceMapArg<'a, M>,
    /// The kernel's `points`.
    pub points: M::Slice<'a, crate::kernels::smc_point::SmcPoint>,
    /// The kernel's `past_particles`.
    pub past_particles: M::Slice<'a, glimt_smc::particle::Particle>,
    /// The kernel's own `state`.
    pub state: M::Chunks<'a, crate::kernels::past::RayState>,
    /// The kernel's own `particles`.
    pub particles: M::Chunks<'a, glimt_smc::particle::Particle>,
}

impl<'a, M: Memory> Pass for AdvanceSmc<'a, M> {
    type Memory = M;

    fn entry() -> &'static Entry {
        &entries::ADVANCE_SMC
    }

    fn bind(&self, binder: &mut impl Binder<M>) {
        binder.value(4, self.frame);
        binder.value(5, self.smc);
        binder.value(6, &self.env.size);
        binder.value(7, &self.env.rotation);
        binder.value(8, &self.before.size);
        binder.value(9, &self.before.rotation);
        binder.slice(0, self.env.texels);
        binder.slice(1, self.env.tables);
        binder.slice(2, self.before.texels);
        binder.slice(3, self.points);
        binder.slice(4, self.past_particles);
        binder.chunks(5, 2, &self.state);
        binder.chunks(6, 3, &self.particles);
    }

    fn elements(&self) -> usize
    where
        M: HostMemory,
    {
        M::count(&self.state).min(M::count(&self.particles))
    }

    fn split_at(self, at: usize) -> (Self, Self)
    where
        M: HostMemory,
    {
        let (state, rest_of_state) = M::split_at(self.state, at);
        let (particles, rest_of_particles) = M::split_at(self.particles, at);
        (
            Self { frame: self.frame, smc: self.smc, env: self.env, before: self.before, points: self.points, past_particles: self.past_particles, state, particles },
            Self { frame: self.frame, smc: self.smc, env: self.env, before: self.before, points: self.points, past_particles: self.past_particles, state: rest_of_state, particles: rest_of_particles },
        )
    }

    fn compute(self, first: u32)
    where
        M: HostMemory,
    {
        let env = self.env.view();
        let before = self.before.view();
        let points = M::values(self.points);
        let past_particles = M::values(self.past_particles);
        for ((id, state), particles) in (first..).zip(M::each(self.state)).zip(M::each(self.particles)) {
            crate::kernels::smc::advance_smc(id, self.frame, self.smc, env, before, points, past_particles, state, particles);
        }
    }
}

/// `smc_gather::gather_smc::<glam::Vec4>` with its arguments.
pub struct GatherSmc<'a, M: Memory> {
    /// The kernel's `frame`.
    pub frame: &'a crate::kernels::frame::FrameParams,
    /// The kernel's `floor`.
    pub floor: f32,
    /// The kernel's `particles_per_ray`.
    pub particles_per_ray: u32,
    /// The kernel's `env`.
    pub env: EnvironmentArg<'a, M>,
    /// The kernel's `scene`.
    pub scene: SceneArg<'a, M>,
    /// The kernel's `points`.
    pub points: M::Slice<'a, crate::kernels::smc_point::SmcPoint>,
    /// The kernel's `states`.
    pub states: M::Slice<'a, crate::kernels::past::RayState>,
    /// The kernel's `particles`.
    pub particles: M::Slice<'a, glimt_smc::particle::Particle>,
    /// What the kernel returns.
    pub out: M::Chunks<'a, glam::Vec4>,
}

impl<'a, M: Memory> Pass for GatherSmc<'a, M> {
    type Memory = M;

    fn entry() -> &'static Entry {
        &entries::GATHER_SMC
    }

    fn bind(&self, binder: &mut impl Binder<M>) {
        binder.value(2, self.frame);
        binder.value(3, &self.floor);
        binder.value(4, &self.particles_per_ray);
        binder.value(5, &self.env.size);
        binder.value(6, &self.env.rotation);
        binder.slice(0, self.env.texels);
        binder.slice(1, self.scene.nodes);
        binder.slice(2, self.scene.triangles);
        binder.slice(3, self.scene.surface);
        binder.slice(4, self.points);
        binder.slice(5, self.states);
        binder.slice(6, self.particles);
        binder.out(7, &self.out);
    }

    fn elements(&self) -> usize
    where
        M: HostMemory,
    {
        M::count(&self.out)
    }

    fn split_at(self, at: usize) -> (Self, Self)
    where
        M: HostMemory,
    {
        let (out, rest_of_out) = M::split_at(self.out, at);
        (
            Self { frame: self.frame, floor: self.floor, particles_per_ray: self.particles_per_ray, env: self.env, scene: self.scene, points: self.points, states: self.states, particles: self.particles, out },
            Self { frame: self.frame, floor: self.floor, particles_per_ray: self.particles_per_ray, env: self.env, scene: self.scene, points: self.points, states: self.states, particles: self.particles, out: rest_of_out },
        )
    }

    fn compute(self, first: u32)
    where
        M: HostMemory,
    {
        let env = self.env.view();
        let scene = self.scene.view();
        let points = M::values(self.points);
        let states = M::values(self.states);
        let particles = M::values(self.particles);
        for (id, out) in (first..).zip(M::each(self.out)) {
            out[0] = crate::kernels::smc_gather::gather_smc::<glam::Vec4>(id, self.frame, self.floor, self.particles_per_ray, env, scene, points, states, particles);
        }
    }
}

/// `smc_gather::gather_smc::<crate::kernels::layers::LayerSample>` with its arguments.
pub struct GatherSmcLayers<'a, M: Memory> {
    /// The kernel's `frame`.
    pub frame: &'a crate::kernels::frame::FrameParams,
    /// The kernel's `floor`.
    pub floor: f32,
    /// The kernel's `particles_per_ray`.
    pub particles_per_ray: u32,
    /// The kernel's `env`.
    pub env: EnvironmentArg<'a, M>,
    /// The kernel's `scene`.
    pub scene: SceneArg<'a, M>,
    /// The kernel's `points`.
    pub points: M::Slice<'a, crate::kernels::smc_point::SmcPoint>,
    /// The kernel's `states`.
    pub states: M::Slice<'a, crate::kernels::past::RayState>,
    /// The kernel's `particles`.
    pub particles: M::Slice<'a, glimt_smc::particle::Particle>,
    /// What the kernel returns.
    pub out: M::Chunks<'a, crate::kernels::layers::LayerSample>,
}

impl<'a, M: Memory> Pass for GatherSmcLayers<'a, M> {
    type Memory = M;

    fn entry() -> &'static Entry {
        &entries::GATHER_SMC_LAYERS
    }

    fn bind(&self, binder: &mut impl Binder<M>) {
        binder.value(2, self.frame);
        binder.value(3, &self.floor);
        binder.value(4, &self.particles_per_ray);
        binder.value(5, &self.env.size);
        binder.value(6, &self.env.rotation);
        binder.slice(0, self.env.texels);
        binder.slice(1, self.scene.nodes);
        binder.slice(2, self.scene.triangles);
        binder.slice(3, self.scene.surface);
        binder.slice(4, self.points);
        binder.slice(5, self.states);
        binder.slice(6, self.particles);
        binder.out(7, &self.out);
    }

    fn elements(&self) -> usize
    where
        M: HostMemory,
    {
        M::count(&self.out)
    }

    fn split_at(self, at: usize) -> (Self, Self)
    where
        M: HostMemory,
    {
        let (out, rest_of_out) = M::split_at(self.out, at);
        (
            Self { frame: self.frame, floor: self.floor, particles_per_ray: self.particles_per_ray, env: self.env, scene: self.scene, points: self.points, states: self.states, particles: self.particles, out },
            Self { frame: self.frame, floor: self.floor, particles_per_ray: self.particles_per_ray, env: self.env, scene: self.scene, points: self.points, states: self.states, particles: self.particles, out: rest_of_out },
        )
    }

    fn compute(self, first: u32)
    where
        M: HostMemory,
    {
        let env = self.env.view();
        let scene = self.scene.view();
        let points = M::values(self.points);
        let states = M::values(self.states);
        let particles = M::values(self.particles);
        for (id, out) in (first..).zip(M::each(self.out)) {
            out[0] = crate::kernels::smc_gather::gather_smc::<crate::kernels::layers::LayerSample>(id, self.frame, self.floor, self.particles_per_ray, env, scene, points, states, particles);
        }
    }
}

/// `smc::diagnose_smc` with its arguments.
pub struct DiagnoseSmc<'a, M: Memory> {
    /// The kernel's `frame`.
    pub frame: &'a crate::kernels::frame::FrameParams,
    /// The kernel's `states`.
    pub states: M::Slice<'a, crate::kernels::past::RayState>,
    /// The kernel's `particles_per_ray`.
    pub particles_per_ray: u32,
    /// What the kernel returns.
    pub out: M::Chunks<'a, crate::kernels::smc::SmcHealth>,
}

impl<'a, M: Memory> Pass for DiagnoseSmc<'a, M> {
    type Memory = M;

    fn entry() -> &'static Entry {
        &entries::DIAGNOSE_SMC
    }

    fn bind(&self, binder: &mut impl Binder<M>) {
        binder.value(2, self.frame);
        binder.value(3, &self.particles_per_ray);
        binder.slice(0, self.states);
        binder.out(1, &self.out);
    }

    fn elements(&self) -> usize
    where
        M: HostMemory,
    {
        M::count(&self.out)
    }

    fn split_at(self, at: usize) -> (Self, Self)
    where
        M: HostMemory,
    {
        let (out, rest_of_out) = M::split_at(self.out, at);
        (
            Self { frame: self.frame, states: self.states, particles_per_ray: self.particles_per_ray, out },
            Self { frame: self.frame, states: self.states, particles_per_ray: self.particles_per_ray, out: rest_of_out },
        )
    }

    fn compute(self, first: u32)
    where
        M: HostMemory,
    {
        let states = M::values(self.states);
        for (id, out) in (first..).zip(M::each(self.out)) {
            out[0] = crate::kernels::smc::diagnose_smc(id, self.frame, states, self.particles_per_ray);
        }
    }
}

/// `film::reconstruct` with its arguments.
pub struct Reconstruct<'a, M: Memory> {
    /// The kernel's `frame`.
    pub frame: &'a crate::kernels::frame::FrameParams,
    /// The kernel's `samples`.
    pub samples: M::Slice<'a, glam::Vec4>,
    /// What the kernel returns.
    pub out: M::Chunks<'a, glam::Vec4>,
}

impl<'a, M: Memory> Pass for Reconstruct<'a, M> {
    type Memory = M;

    fn entry() -> &'static Entry {
        &entries::RECONSTRUCT
    }

    fn bind(&self, binder: &mut impl Binder<M>) {
        binder.value(2, self.frame);
        binder.slice(0, self.samples);
        binder.out(1, &self.out);
    }

    fn elements(&self) -> usize
    where
        M: HostMemory,
    {
        M::count(&self.out)
    }

    fn split_at(self, at: usize) -> (Self, Self)
    where
        M: HostMemory,
    {
        let (out, rest_of_out) = M::split_at(self.out, at);
        (
            Self { frame: self.frame, samples: self.samples, out },
            Self { frame: self.frame, samples: self.samples, out: rest_of_out },
        )
    }

    fn compute(self, first: u32)
    where
        M: HostMemory,
    {
        let samples = M::values(self.samples);
        for (id, out) in (first..).zip(M::each(self.out)) {
            out[0] = crate::kernels::film::reconstruct(id, self.frame, samples);
        }
    }
}

/// `film::tonemap` with its arguments.
pub struct Tonemap<'a, M: Memory> {
    /// The kernel's `frame`.
    pub frame: &'a crate::kernels::frame::FrameParams,
    /// The kernel's `linear`.
    pub linear: M::Slice<'a, glam::Vec4>,
    /// What the kernel returns.
    pub out: M::Chunks<'a, u32>,
}

impl<'a, M: Memory> Pass for Tonemap<'a, M> {
    type Memory = M;

    fn entry() -> &'static Entry {
        &entries::TONEMAP
    }

    fn bind(&self, binder: &mut impl Binder<M>) {
        binder.value(2, self.frame);
        binder.slice(0, self.linear);
        binder.out(1, &self.out);
    }

    fn elements(&self) -> usize
    where
        M: HostMemory,
    {
        M::count(&self.out)
    }

    fn split_at(self, at: usize) -> (Self, Self)
    where
        M: HostMemory,
    {
        let (out, rest_of_out) = M::split_at(self.out, at);
        (
            Self { frame: self.frame, linear: self.linear, out },
            Self { frame: self.frame, linear: self.linear, out: rest_of_out },
        )
    }

    fn compute(self, first: u32)
    where
        M: HostMemory,
    {
        let linear = M::values(self.linear);
        for (id, out) in (first..).zip(M::each(self.out)) {
            out[0] = crate::kernels::film::tonemap(id, self.frame, linear);
        }
    }
}

/// `unwarp::unwarp` with its arguments.
pub struct Unwarp<'a, M: Memory> {
    /// The kernel's `map`.
    pub map: GatherMapArg<'a, M>,
    /// The kernel's `colour`.
    pub colour: &'a glimt_probe::gather::ColourMatrix,
    /// The kernel's `reflectance`.
    pub reflectance: glam::Vec4,
    /// The kernel's `pixels`.
    pub pixels: M::Slice<'a, glam::Vec4>,
    /// What the kernel returns.
    pub out: M::Chunks<'a, glam::Vec4>,
}

impl<'a, M: Memory> Pass for Unwarp<'a, M> {
    type Memory = M;

    fn entry() -> &'static Entry {
        &entries::UNWARP
    }

    fn bind(&self, binder: &mut impl Binder<M>) {
        binder.value(2, self.colour);
        binder.value(3, &self.reflectance);
        binder.slice(0, self.map.texels);
        binder.slice(1, self.map.taps);
        binder.slice(2, self.pixels);
        binder.out(3, &self.out);
    }

    fn elements(&self) -> usize
    where
        M: HostMemory,
    {
        M::count(&self.out)
    }

    fn split_at(self, at: usize) -> (Self, Self)
    where
        M: HostMemory,
    {
        let (out, rest_of_out) = M::split_at(self.out, at);
        (
            Self { map: self.map, colour: self.colour, reflectance: self.reflectance, pixels: self.pixels, out },
            Self { map: self.map, colour: self.colour, reflectance: self.reflectance, pixels: self.pixels, out: rest_of_out },
        )
    }

    fn compute(self, first: u32)
    where
        M: HostMemory,
    {
        let map = self.map.view();
        let pixels = M::values(self.pixels);
        for (id, out) in (first..).zip(M::each(self.out)) {
            out[0] = crate::kernels::unwarp::unwarp(id, map, self.colour, self.reflectance, pixels);
        }
    }
}

/// `layers::reconstruct_layers` with its arguments.
pub struct ReconstructLayers<'a, M: Memory> {
    /// The kernel's `frame`.
    pub frame: &'a crate::kernels::frame::FrameParams,
    /// The kernel's `env`.
    pub env: EnvironmentArg<'a, M>,
    /// The kernel's `samples`.
    pub samples: M::Slice<'a, crate::kernels::layers::LayerSample>,
    /// What the kernel returns.
    pub out: M::Chunks<'a, crate::kernels::layers::PixelLayers>,
}

impl<'a, M: Memory> Pass for ReconstructLayers<'a, M> {
    type Memory = M;

    fn entry() -> &'static Entry {
        &entries::RECONSTRUCT_LAYERS
    }

    fn bind(&self, binder: &mut impl Binder<M>) {
        binder.value(2, self.frame);
        binder.value(3, &self.env.size);
        binder.value(4, &self.env.rotation);
        binder.slice(0, self.env.texels);
        binder.slice(1, self.samples);
        binder.out(2, &self.out);
    }

    fn elements(&self) -> usize
    where
        M: HostMemory,
    {
        M::count(&self.out)
    }

    fn split_at(self, at: usize) -> (Self, Self)
    where
        M: HostMemory,
    {
        let (out, rest_of_out) = M::split_at(self.out, at);
        (
            Self { frame: self.frame, env: self.env, samples: self.samples, out },
            Self { frame: self.frame, env: self.env, samples: self.samples, out: rest_of_out },
        )
    }

    fn compute(self, first: u32)
    where
        M: HostMemory,
    {
        let env = self.env.view();
        let samples = M::values(self.samples);
        for (id, out) in (first..).zip(M::each(self.out)) {
            out[0] = crate::kernels::layers::reconstruct_layers(id, self.frame, env, samples);
        }
    }
}

/// `composite::composite_over_plate` with its arguments.
pub struct CompositeOverPlate<'a, M: Memory> {
    /// The kernel's `frame`.
    pub frame: &'a crate::kernels::frame::FrameParams,
    /// The kernel's `layers`.
    pub layers: M::Slice<'a, crate::kernels::layers::PixelLayers>,
    /// The kernel's `plate`.
    pub plate: M::Slice<'a, crate::kernels::composite::PlatePixel>,
    /// What the kernel returns.
    pub out: M::Chunks<'a, glam::Vec4>,
}

impl<'a, M: Memory> Pass for CompositeOverPlate<'a, M> {
    type Memory = M;

    fn entry() -> &'static Entry {
        &entries::COMPOSITE_OVER_PLATE
    }

    fn bind(&self, binder: &mut impl Binder<M>) {
        binder.value(2, self.frame);
        binder.slice(0, self.layers);
        binder.slice(1, self.plate);
        binder.out(2, &self.out);
    }

    fn elements(&self) -> usize
    where
        M: HostMemory,
    {
        M::count(&self.out)
    }

    fn split_at(self, at: usize) -> (Self, Self)
    where
        M: HostMemory,
    {
        let (out, rest_of_out) = M::split_at(self.out, at);
        (
            Self { frame: self.frame, layers: self.layers, plate: self.plate, out },
            Self { frame: self.frame, layers: self.layers, plate: self.plate, out: rest_of_out },
        )
    }

    fn compute(self, first: u32)
    where
        M: HostMemory,
    {
        let layers = M::values(self.layers);
        let plate = M::values(self.plate);
        for (id, out) in (first..).zip(M::each(self.out)) {
            out[0] = crate::kernels::composite::composite_over_plate(id, self.frame, layers, plate);
        }
    }
}

/// `composite::display_over_plate` with its arguments.
pub struct DisplayOverPlate<'a, M: Memory> {
    /// The kernel's `frame`.
    pub frame: &'a crate::kernels::frame::FrameParams,
    /// The kernel's `layers`.
    pub layers: M::Slice<'a, crate::kernels::layers::PixelLayers>,
    /// The kernel's `plate`.
    pub plate: M::Slice<'a, crate::kernels::composite::PlatePixel>,
    /// What the kernel returns.
    pub out: M::Chunks<'a, u32>,
}

impl<'a, M: Memory> Pass for DisplayOverPlate<'a, M> {
    type Memory = M;

    fn entry() -> &'static Entry {
        &entries::DISPLAY_OVER_PLATE
    }

    fn bind(&self, binder: &mut impl Binder<M>) {
        binder.value(2, self.frame);
        binder.slice(0, self.layers);
        binder.slice(1, self.plate);
        binder.out(2, &self.out);
    }

    fn elements(&self) -> usize
    where
        M: HostMemory,
    {
        M::count(&self.out)
    }

    fn split_at(self, at: usize) -> (Self, Self)
    where
        M: HostMemory,
    {
        let (out, rest_of_out) = M::split_at(self.out, at);
        (
            Self { frame: self.frame, layers: self.layers, plate: self.plate, out },
            Self { frame: self.frame, layers: self.layers, plate: self.plate, out: rest_of_out },
        )
    }

    fn compute(self, first: u32)
    where
        M: HostMemory,
    {
        let layers = M::values(self.layers);
        let plate = M::values(self.plate);
        for (id, out) in (first..).zip(M::each(self.out)) {
            out[0] = crate::kernels::composite::display_over_plate(id, self.frame, layers, plate);
        }
    }
}

/// `composite::composite_alone` with its arguments.
pub struct CompositeAlone<'a, M: Memory> {
    /// The kernel's `frame`.
    pub frame: &'a crate::kernels::frame::FrameParams,
    /// The kernel's `layers`.
    pub layers: M::Slice<'a, crate::kernels::layers::PixelLayers>,
    /// What the kernel returns.
    pub out: M::Chunks<'a, glam::Vec4>,
}

impl<'a, M: Memory> Pass for CompositeAlone<'a, M> {
    type Memory = M;

    fn entry() -> &'static Entry {
        &entries::COMPOSITE_ALONE
    }

    fn bind(&self, binder: &mut impl Binder<M>) {
        binder.value(2, self.frame);
        binder.slice(0, self.layers);
        binder.out(1, &self.out);
    }

    fn elements(&self) -> usize
    where
        M: HostMemory,
    {
        M::count(&self.out)
    }

    fn split_at(self, at: usize) -> (Self, Self)
    where
        M: HostMemory,
    {
        let (out, rest_of_out) = M::split_at(self.out, at);
        (
            Self { frame: self.frame, layers: self.layers, out },
            Self { frame: self.frame, layers: self.layers, out: rest_of_out },
        )
    }

    fn compute(self, first: u32)
    where
        M: HostMemory,
    {
        let layers = M::values(self.layers);
        for (id, out) in (first..).zip(M::each(self.out)) {
            out[0] = crate::kernels::composite::composite_alone(id, self.frame, layers);
        }
    }
}

/// `pyramid::taps` with its arguments.
pub struct Taps<'a, M: Memory> {
    /// The kernel's `size`.
    pub size: glam::UVec2,
    /// What the kernel returns.
    pub out: M::Chunks<'a, crate::kernels::pyramid::Taps>,
}

impl<'a, M: Memory> Pass for Taps<'a, M> {
    type Memory = M;

    fn entry() -> &'static Entry {
        &entries::TAPS
    }

    fn bind(&self, binder: &mut impl Binder<M>) {
        binder.value(2, &self.size);
        binder.out(0, &self.out);
    }

    fn elements(&self) -> usize
    where
        M: HostMemory,
    {
        M::count(&self.out)
    }

    fn split_at(self, at: usize) -> (Self, Self)
    where
        M: HostMemory,
    {
        let (out, rest_of_out) = M::split_at(self.out, at);
        (
            Self { size: self.size, out },
            Self { size: self.size, out: rest_of_out },
        )
    }

    fn compute(self, first: u32)
    where
        M: HostMemory,
    {
        for (id, out) in (first..).zip(M::each(self.out)) {
            out[0] = crate::kernels::pyramid::taps(id, self.size);
        }
    }
}

/// `pyramid::halve` with its arguments.
pub struct Halve<'a, M: Memory> {
    /// The kernel's `size`.
    pub size: glam::UVec2,
    /// The kernel's `taps`.
    pub taps: M::Slice<'a, crate::kernels::pyramid::Taps>,
    /// The kernel's `texels`.
    pub texels: M::Slice<'a, glam::Vec4>,
    /// What the kernel returns.
    pub out: M::Chunks<'a, glam::Vec4>,
}

impl<'a, M: Memory> Pass for Halve<'a, M> {
    type Memory = M;

    fn entry() -> &'static Entry {
        &entries::HALVE
    }

    fn bind(&self, binder: &mut impl Binder<M>) {
        binder.value(2, &self.size);
        binder.slice(0, self.taps);
        binder.slice(1, self.texels);
        binder.out(2, &self.out);
    }

    fn elements(&self) -> usize
    where
        M: HostMemory,
    {
        M::count(&self.out)
    }

    fn split_at(self, at: usize) -> (Self, Self)
    where
        M: HostMemory,
    {
        let (out, rest_of_out) = M::split_at(self.out, at);
        (
            Self { size: self.size, taps: self.taps, texels: self.texels, out },
            Self { size: self.size, taps: self.taps, texels: self.texels, out: rest_of_out },
        )
    }

    fn compute(self, first: u32)
    where
        M: HostMemory,
    {
        let taps = M::values(self.taps);
        let texels = M::values(self.texels);
        for (id, out) in (first..).zip(M::each(self.out)) {
            out[0] = crate::kernels::pyramid::halve(id, self.size, taps, texels);
        }
    }
}

/// `light_sh::light_coefficient` with its arguments.
pub struct LightCoefficient<'a, M: Memory> {
    /// The kernel's `light`.
    pub light: &'a crate::kernels::light_sh::LightParams,
    /// The kernel's `sums`.
    pub sums: M::Slice<'a, glam::Vec4>,
    /// The kernel's `previous`.
    pub previous: M::Slice<'a, glam::Vec4>,
    /// What the kernel returns.
    pub out: M::Chunks<'a, glam::Vec4>,
}

impl<'a, M: Memory> Pass for LightCoefficient<'a, M> {
    type Memory = M;

    fn entry() -> &'static Entry {
        &entries::LIGHT_COEFFICIENT
    }

    fn bind(&self, binder: &mut impl Binder<M>) {
        binder.value(2, self.light);
        binder.slice(0, self.sums);
        binder.slice(1, self.previous);
        binder.out(2, &self.out);
    }

    fn elements(&self) -> usize
    where
        M: HostMemory,
    {
        M::count(&self.out)
    }

    fn split_at(self, at: usize) -> (Self, Self)
    where
        M: HostMemory,
    {
        let (out, rest_of_out) = M::split_at(self.out, at);
        (
            Self { light: self.light, sums: self.sums, previous: self.previous, out },
            Self { light: self.light, sums: self.sums, previous: self.previous, out: rest_of_out },
        )
    }

    fn compute(self, first: u32)
    where
        M: HostMemory,
    {
        let sums = M::values(self.sums);
        let previous = M::values(self.previous);
        for (id, out) in (first..).zip(M::each(self.out)) {
            out[0] = crate::kernels::light_sh::light_coefficient(id, self.light, sums, previous);
        }
    }
}

/// `prt::vertex_light` with its arguments.
pub struct VertexLight<'a, M: Memory> {
    /// The kernel's `coefficients`.
    pub coefficients: u32,
    /// The kernel's `shadows`.
    pub shadows: u32,
    /// The kernel's `light`.
    pub light: M::Slice<'a, glam::Vec4>,
    /// The kernel's `lit`.
    pub lit: M::Slice<'a, f32>,
    /// The kernel's `blocked`.
    pub blocked: M::Slice<'a, f32>,
    /// What the kernel returns.
    pub out: M::Chunks<'a, crate::kernels::prt::VertexLight>,
}

impl<'a, M: Memory> Pass for VertexLight<'a, M> {
    type Memory = M;

    fn entry() -> &'static Entry {
        &entries::VERTEX_LIGHT
    }

    fn bind(&self, binder: &mut impl Binder<M>) {
        binder.value(2, &self.coefficients);
        binder.value(3, &self.shadows);
        binder.slice(0, self.light);
        binder.slice(1, self.lit);
        binder.slice(2, self.blocked);
        binder.out(3, &self.out);
    }

    fn elements(&self) -> usize
    where
        M: HostMemory,
    {
        M::count(&self.out)
    }

    fn split_at(self, at: usize) -> (Self, Self)
    where
        M: HostMemory,
    {
        let (out, rest_of_out) = M::split_at(self.out, at);
        (
            Self { coefficients: self.coefficients, shadows: self.shadows, light: self.light, lit: self.lit, blocked: self.blocked, out },
            Self { coefficients: self.coefficients, shadows: self.shadows, light: self.light, lit: self.lit, blocked: self.blocked, out: rest_of_out },
        )
    }

    fn compute(self, first: u32)
    where
        M: HostMemory,
    {
        let light = M::values(self.light);
        let lit = M::values(self.lit);
        let blocked = M::values(self.blocked);
        for (id, out) in (first..).zip(M::each(self.out)) {
            out[0] = crate::kernels::prt::vertex_light(id, self.coefficients, self.shadows, light, lit, blocked);
        }
    }
}

/// `raster::unpack_layers` with its arguments.
pub struct UnpackLayers<'a, M: Memory> {
    /// The kernel's `frame`.
    pub frame: &'a crate::kernels::frame::FrameParams,
    /// The kernel's `layout`.
    pub layout: &'a crate::kernels::raster::DrawnLayout,
    /// The kernel's `map_rotation`.
    pub map_rotation: glam::Vec2,
    /// The kernel's `map_texels`.
    pub map_texels: M::Slice<'a, glam::Vec4>,
    /// The kernel's `object`.
    pub object: M::Slice<'a, glam::UVec2>,
    /// The kernel's `lit`.
    pub lit: M::Slice<'a, glam::UVec2>,
    /// The kernel's `blocked`.
    pub blocked: M::Slice<'a, glam::UVec2>,
    /// What the kernel returns.
    pub out: M::Chunks<'a, crate::kernels::layers::PixelLayers>,
}

impl<'a, M: Memory> Pass for UnpackLayers<'a, M> {
    type Memory = M;

    fn entry() -> &'static Entry {
        &entries::UNPACK_LAYERS
    }

    fn bind(&self, binder: &mut impl Binder<M>) {
        binder.value(2, self.frame);
        binder.value(3, self.layout);
        binder.value(4, &self.map_rotation);
        binder.slice(0, self.map_texels);
        binder.slice(1, self.object);
        binder.slice(2, self.lit);
        binder.slice(3, self.blocked);
        binder.out(4, &self.out);
    }

    fn elements(&self) -> usize
    where
        M: HostMemory,
    {
        M::count(&self.out)
    }

    fn split_at(self, at: usize) -> (Self, Self)
    where
        M: HostMemory,
    {
        let (out, rest_of_out) = M::split_at(self.out, at);
        (
            Self { frame: self.frame, layout: self.layout, map_rotation: self.map_rotation, map_texels: self.map_texels, object: self.object, lit: self.lit, blocked: self.blocked, out },
            Self { frame: self.frame, layout: self.layout, map_rotation: self.map_rotation, map_texels: self.map_texels, object: self.object, lit: self.lit, blocked: self.blocked, out: rest_of_out },
        )
    }

    fn compute(self, first: u32)
    where
        M: HostMemory,
    {
        let map_texels = M::values(self.map_texels);
        let object = M::values(self.object);
        let lit = M::values(self.lit);
        let blocked = M::values(self.blocked);
        for (id, out) in (first..).zip(M::each(self.out)) {
            out[0] = crate::kernels::raster::unpack_layers(id, self.frame, self.layout, self.map_rotation, map_texels, object, lit, blocked);
        }
    }
}

/// `transfer::transfer` with its arguments.
pub struct Transfer<'a, M: Memory> {
    /// The kernel's `params`.
    pub params: &'a crate::kernels::transfer::TransferParams,
    /// The kernel's `nodes`.
    pub nodes: M::Slice<'a, crate::kernels::bvh::BvhNode>,
    /// The kernel's `triangles`.
    pub triangles: M::Slice<'a, crate::kernels::triangle::Triangle>,
    /// The kernel's `surface`.
    pub surface: M::Slice<'a, u32>,
    /// The kernel's `vertices`.
    pub vertices: M::Slice<'a, crate::kernels::transfer::TransferVertex>,
    /// The kernel's own `state`.
    pub state: M::Chunks<'a, u32>,
    /// The kernel's own `lit`.
    pub lit: M::Chunks<'a, f32>,
    /// The kernel's own `blocked`.
    pub blocked: M::Chunks<'a, f32>,
    /// What the kernel returns.
    pub out: M::Chunks<'a, u32>,
}

impl<'a, M: Memory> Pass for Transfer<'a, M> {
    type Memory = M;

    fn entry() -> &'static Entry {
        &entries::TRANSFER
    }

    fn bind(&self, binder: &mut impl Binder<M>) {
        binder.value(5, self.params);
        binder.slice(0, self.nodes);
        binder.slice(1, self.triangles);
        binder.slice(2, self.surface);
        binder.slice(3, self.vertices);
        binder.chunks(4, 2, &self.state);
        binder.chunks(5, 3, &self.lit);
        binder.chunks(6, 4, &self.blocked);
        binder.out(7, &self.out);
    }

    fn elements(&self) -> usize
    where
        M: HostMemory,
    {
        M::count(&self.state).min(M::count(&self.lit)).min(M::count(&self.blocked)).min(M::count(&self.out))
    }

    fn split_at(self, at: usize) -> (Self, Self)
    where
        M: HostMemory,
    {
        let (state, rest_of_state) = M::split_at(self.state, at);
        let (lit, rest_of_lit) = M::split_at(self.lit, at);
        let (blocked, rest_of_blocked) = M::split_at(self.blocked, at);
        let (out, rest_of_out) = M::split_at(self.out, at);
        (
            Self { params: self.params, nodes: self.nodes, triangles: self.triangles, surface: self.surface, vertices: self.vertices, state, lit, blocked, out },
            Self { params: self.params, nodes: self.nodes, triangles: self.triangles, surface: self.surface, vertices: self.vertices, state: rest_of_state, lit: rest_of_lit, blocked: rest_of_blocked, out: rest_of_out },
        )
    }

    fn compute(self, first: u32)
    where
        M: HostMemory,
    {
        let nodes = M::values(self.nodes);
        let triangles = M::values(self.triangles);
        let surface = M::values(self.surface);
        let vertices = M::values(self.vertices);
        for ((((id, state), lit), blocked), out) in (first..).zip(M::each(self.state)).zip(M::each(self.lit)).zip(M::each(self.blocked)).zip(M::each(self.out)) {
            out[0] = crate::kernels::transfer::transfer(id, self.params, nodes, triangles, surface, vertices, state, lit, blocked);
        }
    }
}

/// `capture::film_ball` with its arguments.
pub struct FilmBall<'a, M: Memory> {
    /// The kernel's `capture`.
    pub capture: &'a crate::kernels::capture::CaptureParams,
    /// The kernel's `stage`.
    pub stage: StageArg<'a, M>,
    /// What the kernel returns.
    pub out: M::Chunks<'a, glam::Vec4>,
}

impl<'a, M: Memory> Pass for FilmBall<'a, M> {
    type Memory = M;

    fn entry() -> &'static Entry {
        &entries::FILM_BALL
    }

    fn bind(&self, binder: &mut impl Binder<M>) {
        binder.value(2, self.capture);
        binder.value(3, &self.stage.params);
        binder.slice(0, self.stage.texels);
        binder.out(1, &self.out);
    }

    fn elements(&self) -> usize
    where
        M: HostMemory,
    {
        M::count(&self.out)
    }

    fn split_at(self, at: usize) -> (Self, Self)
    where
        M: HostMemory,
    {
        let (out, rest_of_out) = M::split_at(self.out, at);
        (
            Self { capture: self.capture, stage: self.stage, out },
            Self { capture: self.capture, stage: self.stage, out: rest_of_out },
        )
    }

    fn compute(self, first: u32)
    where
        M: HostMemory,
    {
        let stage = self.stage.view();
        for (id, out) in (first..).zip(M::each(self.out)) {
            out[0] = crate::kernels::capture::film_ball(id, self.capture, stage);
        }
    }
}

/// `capture::film_plate` with its arguments.
pub struct FilmPlate<'a, M: Memory> {
    /// The kernel's `frame`.
    pub frame: &'a crate::kernels::frame::FrameParams,
    /// The kernel's `stage`.
    pub stage: StageArg<'a, M>,
    /// What the kernel returns.
    pub out: M::Chunks<'a, glam::Vec4>,
}

impl<'a, M: Memory> Pass for FilmPlate<'a, M> {
    type Memory = M;

    fn entry() -> &'static Entry {
        &entries::FILM_PLATE
    }

    fn bind(&self, binder: &mut impl Binder<M>) {
        binder.value(2, self.frame);
        binder.value(3, &self.stage.params);
        binder.slice(0, self.stage.texels);
        binder.out(1, &self.out);
    }

    fn elements(&self) -> usize
    where
        M: HostMemory,
    {
        M::count(&self.out)
    }

    fn split_at(self, at: usize) -> (Self, Self)
    where
        M: HostMemory,
    {
        let (out, rest_of_out) = M::split_at(self.out, at);
        (
            Self { frame: self.frame, stage: self.stage, out },
            Self { frame: self.frame, stage: self.stage, out: rest_of_out },
        )
    }

    fn compute(self, first: u32)
    where
        M: HostMemory,
    {
        let stage = self.stage.view();
        for (id, out) in (first..).zip(M::each(self.out)) {
            out[0] = crate::kernels::capture::film_plate(id, self.frame, stage);
        }
    }
}

/// `capture::film_latlong` with its arguments.
pub struct FilmLatlong<'a, M: Memory> {
    /// The kernel's `latlong`.
    pub latlong: &'a crate::kernels::capture::LatLongParams,
    /// The kernel's `stage`.
    pub stage: StageArg<'a, M>,
    /// What the kernel returns.
    pub out: M::Chunks<'a, glam::Vec4>,
}

impl<'a, M: Memory> Pass for FilmLatlong<'a, M> {
    type Memory = M;

    fn entry() -> &'static Entry {
        &entries::FILM_LATLONG
    }

    fn bind(&self, binder: &mut impl Binder<M>) {
        binder.value(2, self.latlong);
        binder.value(3, &self.stage.params);
        binder.slice(0, self.stage.texels);
        binder.out(1, &self.out);
    }

    fn elements(&self) -> usize
    where
        M: HostMemory,
    {
        M::count(&self.out)
    }

    fn split_at(self, at: usize) -> (Self, Self)
    where
        M: HostMemory,
    {
        let (out, rest_of_out) = M::split_at(self.out, at);
        (
            Self { latlong: self.latlong, stage: self.stage, out },
            Self { latlong: self.latlong, stage: self.stage, out: rest_of_out },
        )
    }

    fn compute(self, first: u32)
    where
        M: HostMemory,
    {
        let stage = self.stage.view();
        for (id, out) in (first..).zip(M::each(self.out)) {
            out[0] = crate::kernels::capture::film_latlong(id, self.latlong, stage);
        }
    }
}

/// `sensor::expose` with its arguments.
pub struct Expose<'a, M: Memory> {
    /// The kernel's `sensor`.
    pub sensor: &'a crate::kernels::sensor::SensorParams,
    /// The kernel's `radiance`.
    pub radiance: M::Slice<'a, glam::Vec4>,
    /// What the kernel returns.
    pub out: M::Chunks<'a, glam::Vec4>,
}

impl<'a, M: Memory> Pass for Expose<'a, M> {
    type Memory = M;

    fn entry() -> &'static Entry {
        &entries::EXPOSE
    }

    fn bind(&self, binder: &mut impl Binder<M>) {
        binder.value(2, self.sensor);
        binder.slice(0, self.radiance);
        binder.out(1, &self.out);
    }

    fn elements(&self) -> usize
    where
        M: HostMemory,
    {
        M::count(&self.out)
    }

    fn split_at(self, at: usize) -> (Self, Self)
    where
        M: HostMemory,
    {
        let (out, rest_of_out) = M::split_at(self.out, at);
        (
            Self { sensor: self.sensor, radiance: self.radiance, out },
            Self { sensor: self.sensor, radiance: self.radiance, out: rest_of_out },
        )
    }

    fn compute(self, first: u32)
    where
        M: HostMemory,
    {
        let radiance = M::values(self.radiance);
        for (id, out) in (first..).zip(M::each(self.out)) {
            out[0] = crate::kernels::sensor::expose(id, self.sensor, radiance);
        }
    }
}

/// `diagnose::uniforms` with its arguments.
pub struct DiagnoseUniforms<'a, M: Memory> {
    /// The kernel's `frame`.
    pub frame: &'a crate::kernels::frame::FrameParams,
    /// The kernel's `mis`.
    pub mis: &'a crate::kernels::mis::Mis,
    /// What the kernel returns.
    pub out: M::Chunks<'a, glam::UVec4>,
}

impl<'a, M: Memory> Pass for DiagnoseUniforms<'a, M> {
    type Memory = M;

    fn entry() -> &'static Entry {
        &entries::DIAGNOSE_UNIFORMS
    }

    fn bind(&self, binder: &mut impl Binder<M>) {
        binder.value(2, self.frame);
        binder.value(3, self.mis);
        binder.out(0, &self.out);
    }

    fn elements(&self) -> usize
    where
        M: HostMemory,
    {
        M::count(&self.out)
    }

    fn split_at(self, at: usize) -> (Self, Self)
    where
        M: HostMemory,
    {
        let (out, rest_of_out) = M::split_at(self.out, at);
        (
            Self { frame: self.frame, mis: self.mis, out },
            Self { frame: self.frame, mis: self.mis, out: rest_of_out },
        )
    }

    fn compute(self, first: u32)
    where
        M: HostMemory,
    {
        for (id, out) in (first..).zip(M::each(self.out)) {
            out[0] = crate::kernels::diagnose::uniforms(id, self.frame, self.mis);
        }
    }
}

/// `diagnose::env_sample` with its arguments.
pub struct DiagnoseEnvSample<'a, M: Memory> {
    /// The kernel's `frame`.
    pub frame: &'a crate::kernels::frame::FrameParams,
    /// The kernel's `mis`.
    pub mis: &'a crate::kernels::mis::Mis,
    /// The kernel's `env`.
    pub env: EnvironmentArg<'a, M>,
    /// What the kernel returns.
    pub out: M::Chunks<'a, crate::kernels::diagnose::EnvRecord>,
}

impl<'a, M: Memory> Pass for DiagnoseEnvSample<'a, M> {
    type Memory = M;

    fn entry() -> &'static Entry {
        &entries::DIAGNOSE_ENV_SAMPLE
    }

    fn bind(&self, binder: &mut impl Binder<M>) {
        binder.value(2, self.frame);
        binder.value(3, self.mis);
        binder.value(4, &self.env.size);
        binder.value(5, &self.env.rotation);
        binder.slice(0, self.env.tables);
        binder.out(1, &self.out);
    }

    fn elements(&self) -> usize
    where
        M: HostMemory,
    {
        M::count(&self.out)
    }

    fn split_at(self, at: usize) -> (Self, Self)
    where
        M: HostMemory,
    {
        let (out, rest_of_out) = M::split_at(self.out, at);
        (
            Self { frame: self.frame, mis: self.mis, env: self.env, out },
            Self { frame: self.frame, mis: self.mis, env: self.env, out: rest_of_out },
        )
    }

    fn compute(self, first: u32)
    where
        M: HostMemory,
    {
        let env = self.env.view();
        for (id, out) in (first..).zip(M::each(self.out)) {
            out[0] = crate::kernels::diagnose::env_sample(id, self.frame, self.mis, env);
        }
    }
}

/// `diagnose::primary_hit` with its arguments.
pub struct DiagnosePrimaryHit<'a, M: Memory> {
    /// The kernel's `frame`.
    pub frame: &'a crate::kernels::frame::FrameParams,
    /// The kernel's `scene`.
    pub scene: SceneArg<'a, M>,
    /// What the kernel returns.
    pub out: M::Chunks<'a, crate::kernels::diagnose::HitRecord>,
}

impl<'a, M: Memory> Pass for DiagnosePrimaryHit<'a, M> {
    type Memory = M;

    fn entry() -> &'static Entry {
        &entries::DIAGNOSE_PRIMARY_HIT
    }

    fn bind(&self, binder: &mut impl Binder<M>) {
        binder.value(2, self.frame);
        binder.slice(0, self.scene.nodes);
        binder.slice(1, self.scene.triangles);
        binder.slice(2, self.scene.surface);
        binder.out(3, &self.out);
    }

    fn elements(&self) -> usize
    where
        M: HostMemory,
    {
        M::count(&self.out)
    }

    fn split_at(self, at: usize) -> (Self, Self)
    where
        M: HostMemory,
    {
        let (out, rest_of_out) = M::split_at(self.out, at);
        (
            Self { frame: self.frame, scene: self.scene, out },
            Self { frame: self.frame, scene: self.scene, out: rest_of_out },
        )
    }

    fn compute(self, first: u32)
    where
        M: HostMemory,
    {
        let scene = self.scene.view();
        for (id, out) in (first..).zip(M::each(self.out)) {
            out[0] = crate::kernels::diagnose::primary_hit(id, self.frame, scene);
        }
    }
}

/// `diagnose::surface` with its arguments.
pub struct DiagnoseSurface<'a, M: Memory> {
    /// The kernel's `frame`.
    pub frame: &'a crate::kernels::frame::FrameParams,
    /// The kernel's `scene`.
    pub scene: SceneArg<'a, M>,
    /// What the kernel returns.
    pub out: M::Chunks<'a, crate::kernels::diagnose::SurfaceRecord>,
}

impl<'a, M: Memory> Pass for DiagnoseSurface<'a, M> {
    type Memory = M;

    fn entry() -> &'static Entry {
        &entries::DIAGNOSE_SURFACE
    }

    fn bind(&self, binder: &mut impl Binder<M>) {
        binder.value(2, self.frame);
        binder.slice(0, self.scene.nodes);
        binder.slice(1, self.scene.triangles);
        binder.slice(2, self.scene.corners);
        binder.slice(3, self.scene.surface);
        binder.out(4, &self.out);
    }

    fn elements(&self) -> usize
    where
        M: HostMemory,
    {
        M::count(&self.out)
    }

    fn split_at(self, at: usize) -> (Self, Self)
    where
        M: HostMemory,
    {
        let (out, rest_of_out) = M::split_at(self.out, at);
        (
            Self { frame: self.frame, scene: self.scene, out },
            Self { frame: self.frame, scene: self.scene, out: rest_of_out },
        )
    }

    fn compute(self, first: u32)
    where
        M: HostMemory,
    {
        let scene = self.scene.view();
        for (id, out) in (first..).zip(M::each(self.out)) {
            out[0] = crate::kernels::diagnose::surface(id, self.frame, scene);
        }
    }
}

/// `diagnose::brdf_sample` with its arguments.
pub struct DiagnoseBrdfSample<'a, M: Memory> {
    /// The kernel's `frame`.
    pub frame: &'a crate::kernels::frame::FrameParams,
    /// The kernel's `mis`.
    pub mis: &'a crate::kernels::mis::Mis,
    /// The kernel's `scene`.
    pub scene: SceneArg<'a, M>,
    /// What the kernel returns.
    pub out: M::Chunks<'a, glam::Vec4>,
}

impl<'a, M: Memory> Pass for DiagnoseBrdfSample<'a, M> {
    type Memory = M;

    fn entry() -> &'static Entry {
        &entries::DIAGNOSE_BRDF_SAMPLE
    }

    fn bind(&self, binder: &mut impl Binder<M>) {
        binder.value(2, self.frame);
        binder.value(3, self.mis);
        binder.slice(0, self.scene.nodes);
        binder.slice(1, self.scene.triangles);
        binder.slice(2, self.scene.corners);
        binder.slice(3, self.scene.surface);
        binder.out(4, &self.out);
    }

    fn elements(&self) -> usize
    where
        M: HostMemory,
    {
        M::count(&self.out)
    }

    fn split_at(self, at: usize) -> (Self, Self)
    where
        M: HostMemory,
    {
        let (out, rest_of_out) = M::split_at(self.out, at);
        (
            Self { frame: self.frame, mis: self.mis, scene: self.scene, out },
            Self { frame: self.frame, mis: self.mis, scene: self.scene, out: rest_of_out },
        )
    }

    fn compute(self, first: u32)
    where
        M: HostMemory,
    {
        let scene = self.scene.view();
        for (id, out) in (first..).zip(M::each(self.out)) {
            out[0] = crate::kernels::diagnose::brdf_sample(id, self.frame, self.mis, scene);
        }
    }
}
