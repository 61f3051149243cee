//! Host file: small frames of a scene that has every kind of material and texture, and the stages of their making.

use bytemuck::NoUninit;
use glam::{Affine2, Mat4, UVec2, Vec2, Vec3, Vec4, vec2, vec3, vec4};
use glimt_render_gpu::gpu::{Arg, GpuContext, GpuEnv, GpuScene};
use glimt_render_gpu::kernels::environment::Environment;
use glimt_render_gpu::kernels::frame::{Background, FrameParams, Shadow};
use glimt_render_gpu::kernels::mis::Mis;
use glimt_render_gpu::kernels::scene::Scene;
use glimt_render_gpu::kernels::{diagnose, film, shade};
use glimt_render_gpu::methods::{Bis, Method};
use glimt_render_gpu::prepare::env::{EnvMap, PreparedEnv};
use glimt_render_gpu::prepare::render::{Pattern, RenderSettings, Tonemap};
use glimt_render_gpu::prepare::scene::{
    Alpha, Camera, Material, Mesh, Object, Opacity, Reflection, SceneDescription, Texture,
    TextureRef, Wrap,
};
use glimt_render_gpu::prepare::scene_build::SceneBuffers;
use naga_front_rust::Program;

use super::{Output, Pair, launch, words};

pub(super) const SIZE: UVec2 = UVec2::new(40, 30);
pub(super) const RAYS: u32 = 4;
/// One sample of each strategy on a ray.
pub(super) const MIS: Mis = Mis {
    brdf_samples: 1,
    env_samples: 1,
};
/// The kernel of multiple importance sampling, below `kernels`.
const MIS_ON_RAYS: &str = "shade::shade::<glimt_render_gpu::kernels::mis::Mis, glam::Vec4>";
/// The same in layers.
pub(super) const MIS_IN_LAYERS: &str = "shade::shade::<glimt_render_gpu::kernels::mis::Mis, \
     glimt_render_gpu::kernels::layers::LayerSample>";

/// Shows each frame: one by each sample pattern, then the stages of the first, then frames whose floor is a catcher, then those by other
/// methods, which take the longest.
///
/// # Panics
/// Where the GPU or the front end fails.
pub fn frame_pairs(program: &Program, context: &GpuContext, show: &dyn Fn(Pair)) {
    let of_scene = |with_catcher| Stage {
        program,
        context,
        scene: scene(with_catcher),
        env: environment(30.0),
    };
    let stage = of_scene(false);
    show(stage.frame("Owen-Sobol", Pattern::OwenSobol, Tonemap::Srgb));
    show(stage.frame("independent", Pattern::Independent, Tonemap::Reinhard));
    show(stage.frame("stratified", Pattern::Stratified, Tonemap::Srgb));
    show(stage.diagnose("uniforms", |ray, frame, _, _| {
        diagnose::uniforms(ray, frame, &MIS)
    }));
    show(stage.diagnose("env_sample", |ray, frame, env, _| {
        diagnose::env_sample(ray, frame, &MIS, env)
    }));
    show(stage.diagnose("primary_hit", |ray, frame, _, scene| {
        diagnose::primary_hit(ray, frame, scene)
    }));
    show(stage.diagnose("surface", |ray, frame, _, scene| {
        diagnose::surface(ray, frame, scene)
    }));
    show(stage.diagnose("brdf_sample", |ray, frame, _, scene| {
        diagnose::brdf_sample(ray, frame, &MIS, scene)
    }));
    let base = params(Pattern::OwenSobol, Tonemap::Srgb);
    let transparent = FrameParams {
        background: Background::Transparent,
        shadow: Shadow::Add,
        ..base
    };
    let over_catcher = of_scene(true);
    show(over_catcher.layered("multiplied-shadow", &base));
    show(over_catcher.layered("added-shadow", &transparent));
    show(stage.picked());
    show(stage.of_the_product());
    show(stage.by_cells());
    show(stage.followed());
}

pub(super) struct Stage<'a> {
    pub(super) program: &'a Program,
    pub(super) context: &'a GpuContext,
    pub(super) scene: SceneBuffers,
    pub(super) env: PreparedEnv,
}

impl Stage<'_> {
    /// Linear and display values.
    fn frame(&self, name: &str, pattern: Pattern, tonemap: Tonemap) -> Pair {
        let frame = params(pattern, tonemap);
        let (pixels, rays) = (SIZE.x * SIZE.y, SIZE.x * SIZE.y * RAYS);
        let (env, scene) = (self.env.view(), self.scene.view());
        let samples: Vec<Vec4> = (0..rays)
            .map(|ray| shade::shade(ray, &frame, &MIS, env, scene))
            .collect();
        let linear: Vec<Vec4> = (0..pixels)
            .map(|pixel| film::reconstruct(pixel, &frame, &samples))
            .collect();
        let display: Vec<u32> = (0..pixels)
            .map(|pixel| film::tonemap(pixel, &frame, &linear))
            .collect();

        let out = [
            Output::new::<Vec4>(self.context, rays),
            Output::new::<Vec4>(self.context, pixels),
            Output::new::<u32>(self.context, pixels),
        ];
        let film_args = [
            ("frame", Arg::Value(bytemuck::bytes_of(&frame))),
            ("samples", Arg::Buffer(&out[0].buffer)),
            ("linear", Arg::Buffer(&out[1].buffer)),
        ];
        self.shade(MIS_ON_RAYS, &frame, &out[0], rays);
        for (kernel, out) in [("reconstruct", &out[1]), ("tonemap", &out[2])] {
            let kernel = format!("glimt_render_gpu::kernels::film::{kernel}");
            launch(
                self.context,
                self.program,
                &kernel,
                &film_args,
                &out.buffer,
                pixels,
            );
        }
        Pair {
            name: name.to_owned(),
            cpu: [words(&linear), display].concat(),
            gpu: [out[1].read(self.context), out[2].read(self.context)].concat(),
        }
    }

    /// What a kernel of [`diagnose`] says of each ray.
    fn diagnose<T: NoUninit>(
        &self,
        kernel: &str,
        cpu: impl Fn(u32, &FrameParams, Environment<'_>, Scene<'_>) -> T,
    ) -> Pair {
        let frame = params(Pattern::OwenSobol, Tonemap::Srgb);
        let rays = SIZE.x * SIZE.y * RAYS;
        let values: Vec<T> = (0..rays)
            .map(|ray| cpu(ray, &frame, self.env.view(), self.scene.view()))
            .collect();
        let out = Output::new::<T>(self.context, rays);
        self.shade(&format!("diagnose::{kernel}"), &frame, &out, rays);
        Pair {
            name: kernel.to_owned(),
            cpu: words(&values),
            gpu: out.read(self.context),
        }
    }

    pub(super) fn shade(&self, kernel: &str, frame: &FrameParams, out: &Output, rays: u32) {
        self.shade_with(kernel, frame, &[], out, rays);
    }

    /// The same with arguments that other kernels do not have.
    pub(super) fn shade_with(
        &self,
        kernel: &str,
        frame: &FrameParams,
        more: &[(&str, Arg<'_>)],
        out: &Output,
        rays: u32,
    ) {
        self.shade_by(&all_of_luminance(), kernel, frame, more, out, rays);
    }

    /// The same with the tables of a method.
    pub(super) fn shade_by(
        &self,
        method: &Method,
        kernel: &str,
        frame: &FrameParams,
        more: &[(&str, Arg<'_>)],
        out: &Output,
        rays: u32,
    ) {
        let scene = GpuScene::new(self.context, &self.scene).expect("a small scene");
        let env = GpuEnv::new(self.context, &self.env, method).expect("a small map");
        let mut args = vec![("frame", Arg::Value(bytemuck::bytes_of(frame)))];
        args.extend(scene.args());
        args.extend(env.args());
        args.push(("mis", Arg::Value(bytemuck::bytes_of(&MIS))));
        let known = |path: &str| more.iter().any(|(name, _)| *name == path);
        if !known("estimator") {
            args.push(("estimator", Arg::Value(bytemuck::bytes_of(&MIS))));
        }
        args.extend(more);
        let kernel = format!("glimt_render_gpu::kernels::{kernel}");
        launch(
            self.context,
            self.program,
            &kernel,
            &args,
            &out.buffer,
            rays,
        );
    }
}

/// A method that reads the tables of luminance as it is.
pub(super) fn all_of_luminance() -> Method {
    Bis::default().into()
}

pub(super) fn params(pattern: Pattern, tonemap: Tonemap) -> FrameParams {
    settings(pattern, tonemap)
        .frame_params()
        .expect("settings that are right")
}

pub(super) fn settings(pattern: Pattern, tonemap: Tonemap) -> RenderSettings {
    let camera = Camera {
        eye: vec3(0.3, -4.0, 1.6),
        target: vec3(0.0, 0.0, 0.6),
        up: Vec3::Z,
        fov_x: 0.9,
    };
    RenderSettings {
        rays_per_pixel: RAYS,
        pattern,
        tonemap,
        exposure_ev: -1.0,
        ..RenderSettings::new(SIZE, camera)
    }
}

/// A sky that grows brighter to one side, with a small sun; turned, so that the rotation counts.
pub(super) fn environment(rotate_z_deg: f32) -> PreparedEnv {
    let size = UVec2::new(32, 16);
    let texel = |i: u32| {
        let (x, y) = (i % size.x, i / size.x);
        if (x, y) == (10, 4) {
            return vec3(300.0, 280.0, 240.0).extend(1.0);
        }
        let level = if y < 8 { 0.4 + x as f32 / 32.0 } else { 0.1 };
        (level * vec3(0.7, 0.8, 1.0)).extend(1.0)
    };
    let map = EnvMap::new(size, (0..size.x * size.y).map(texel).collect());
    map.expect("a map").prepare(rotate_z_deg).expect("tables")
}

/// A glossy tetrahedron and a metal one before a textured, bumpy wall, on a matte floor, behind a thin veil that glows.
pub(super) fn scene(catcher: bool) -> SceneBuffers {
    let tetrahedron = Mesh {
        name: "tetrahedron".to_owned(),
        positions: vec![
            vec3(-0.7, -0.5, 0.0),
            vec3(0.7, -0.5, 0.0),
            vec3(0.0, 0.7, 0.0),
            vec3(0.0, 0.0, 1.2),
        ],
        indices: vec![[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]],
        materials: vec![1],
        ..Mesh::default()
    };
    let mut veil = rectangle("veil", vec3(1.2, 0.0, 0.0), vec3(0.0, 0.0, 1.0), 4);
    veil.colors = [0.2, 0.9, 0.6, 0.4]
        .map(|c| vec4(c, 1.0 - c, 0.5, 0.5 + 0.5 * c))
        .to_vec();
    let object = |mesh, place: Vec3, material| Object {
        mesh,
        transform: Mat4::from_translation(place),
        material,
        catcher: false,
    };
    let description = SceneDescription {
        meshes: vec![
            rectangle("floor", vec3(12.0, 0.0, 0.0), vec3(0.0, 12.0, 0.0), 0),
            tetrahedron,
            rectangle("wall", vec3(4.0, 0.0, 0.0), vec3(0.0, 0.0, 2.5), 3),
            veil,
        ],
        materials: materials(),
        textures: vec![
            texture(true, [Wrap::Repeat, Wrap::Mirror]),
            texture(false, [Wrap::Mirror, Wrap::Clamp]),
            texture(false, [Wrap::Repeat, Wrap::Repeat]),
        ],
        objects: vec![
            Object {
                catcher,
                ..object(0, Vec3::ZERO, None)
            },
            object(1, vec3(-0.8, 0.0, 0.0), None),
            object(1, vec3(0.9, 0.2, 0.0), Some(2)),
            object(2, vec3(0.0, 1.5, 1.2), None),
            object(3, vec3(0.2, -0.9, 0.7), None),
        ],
    };
    SceneBuffers::build(&description).expect("a scene")
}

fn materials() -> Vec<Material> {
    vec![
        Material::from(Reflection::BlinnPhong {
            diffuse: Vec3::splat(0.5),
            specular: Vec3::ZERO,
            exponent: 0.0,
        }),
        Material::from(Reflection::BlinnPhong {
            diffuse: vec3(0.4, 0.2, 0.1),
            specular: Vec3::splat(0.4),
            exponent: 60.0,
        }),
        Material::from(Reflection::MetallicRoughness {
            base_color: vec3(0.9, 0.7, 0.4),
            metallic: 0.8,
            roughness: 0.4,
            base_color_texture: None,
            metallic_roughness_texture: None,
            normal_texture: None,
            normal_scale: 1.0,
        }),
        Material::from(Reflection::MetallicRoughness {
            base_color: Vec3::ONE,
            metallic: 0.5,
            roughness: 0.9,
            base_color_texture: Some(0.into()),
            metallic_roughness_texture: Some(1.into()),
            normal_texture: Some(2.into()),
            normal_scale: 0.5,
        }),
        Material {
            emission: vec3(0.02, 0.05, 0.1),
            emission_texture: Some(TextureRef {
                texture: 0,
                transform: Affine2::from_scale(vec2(0.5, 2.0)),
            }),
            opacity: Opacity::Blend {
                alpha: Alpha {
                    factor: 0.7,
                    texture: None,
                },
            },
            ..Material::from(Reflection::BlinnPhong {
                diffuse: Vec3::splat(0.7),
                specular: Vec3::ZERO,
                exponent: 0.0,
            })
        },
    ]
}

/// A rectangle about the origin, its texture three times across.
fn rectangle(name: &str, across: Vec3, up: Vec3, material: u32) -> Mesh {
    let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
    let uv = |(x, y): (f32, f32)| -> Vec2 { vec2(1.5 * x, -1.5 * y) };
    Mesh {
        name: name.to_owned(),
        positions: corners.map(|(x, y)| 0.5 * (x * across + y * up)).to_vec(),
        uvs: corners.map(uv).to_vec(),
        indices: vec![[0, 1, 2], [0, 2, 3]],
        materials: vec![material],
        ..Mesh::default()
    }
}

/// Four by four texels, no two alike.
fn texture(srgb: bool, wrap: [Wrap; 2]) -> Texture {
    let texel = |i: u8| [90 + 10 * i, 230 - 9 * i, 128 + 7 * i, 255];
    Texture {
        size: UVec2::splat(4),
        texels: (0..16).map(texel).collect(),
        srgb,
        wrap,
    }
}
