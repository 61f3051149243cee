//! Host file: Monte Carlo rendering of objects lit by video environment maps.
//!
//! [`kernels`] (shared files) compute one ray or one pixel each. Two executors run them over an image, [`cpu`] by rayon
//! and [`gpu`] by wgpu, the latter from the WGSL that the front end makes of the same files. [`prepare`] prepares what they
//! read: buffers of a scene, tables of a light map, numbers of a frame.
//!
//! ```
//! use glam::{Mat4, UVec2, Vec3, Vec4};
//! use glimt_render_gpu::cpu::CpuRenderer;
//! use glimt_render_gpu::prepare::env::EnvMap;
//! use glimt_render_gpu::prepare::render::{RenderSettings, Renderer};
//! use glimt_render_gpu::prepare::scene::{Camera, Material, Mesh, Object, Reflection, SceneDescription};
//! use glimt_render_gpu::prepare::scene_build::SceneBuffers;
//!
//! // A grey triangle under a white sky reflects its albedo.
//! let scene = SceneBuffers::build(&SceneDescription {
//!     meshes: vec![Mesh {
//!         positions: vec![Vec3::ZERO, Vec3::X, Vec3::Y],
//!         indices: vec![[0, 1, 2]],
//!         materials: vec![0],
//!         ..Mesh::default()
//!     }],
//!     materials: vec![Material::from(Reflection::BlinnPhong { diffuse: Vec3::splat(0.5), specular: Vec3::ZERO, exponent: 0.0 })],
//!     objects: vec![Object { mesh: 0, transform: Mat4::IDENTITY, material: None, catcher: false }],
//!     ..SceneDescription::default()
//! })?;
//! let sky = EnvMap::new(UVec2::new(2, 1), vec![Vec4::ONE; 2])?.prepare(0.0)?;
//! let camera = Camera { eye: Vec3::new(0.2, 0.2, 9.0), target: Vec3::new(0.2, 0.2, 0.0), up: Vec3::Y, fov_x: 0.01 };
//! let settings = RenderSettings { rays_per_pixel: 64, ..RenderSettings::new(UVec2::ONE, camera) };
//! let image = CpuRenderer::default().render_frame(&scene, &sky, &settings, &|_| ())?;
//! assert!((image.linear[0].x - 0.5).abs() < 0.02);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Where objects stand still, light that arrives at their vertices may be computed once for any light, and frames by it alone
//! (precomputed radiance transfer): [`prepare::bake`], then [`CpuDrawing`](cpu::CpuDrawing). The triangle of above again:
//!
//! ```
//! # use glam::{Mat4, UVec2, Vec3, Vec4};
//! # use glimt_render_gpu::cpu::CpuDrawing;
//! # use glimt_render_gpu::prepare::env::EnvMap;
//! # use glimt_render_gpu::prepare::render::{RenderSettings, Renderer};
//! # use glimt_render_gpu::prepare::scene::{Camera, Material, Mesh, Object, Reflection, SceneDescription};
//! # use glimt_render_gpu::prepare::scene_build::SceneBuffers;
//! use glimt_render_gpu::prepare::bake::{BakeSettings, bake};
//! # let mut scene = SceneBuffers::build(&SceneDescription {
//! #     meshes: vec![Mesh {
//! #         positions: vec![Vec3::ZERO, Vec3::X, Vec3::Y],
//! #         indices: vec![[0, 1, 2]],
//! #         materials: vec![0],
//! #         ..Mesh::default()
//! #     }],
//! #     materials: vec![Material::from(Reflection::BlinnPhong { diffuse: Vec3::splat(0.5), specular: Vec3::ZERO, exponent: 0.0 })],
//! #     objects: vec![Object { mesh: 0, transform: Mat4::IDENTITY, material: None, catcher: false }],
//! #     ..SceneDescription::default()
//! # })?;
//! # let camera = Camera { eye: Vec3::new(0.2, 0.2, 9.0), target: Vec3::new(0.2, 0.2, 0.0), up: Vec3::Y, fov_x: 0.01 };
//! let baked = bake(&scene, &BakeSettings::default(), &|_| ())?;
//! scene.set_transfer(baked.transfer.into(), &[])?;
//! let settings = RenderSettings::new(UVec2::ONE, camera);
//! // No tables: such a frame draws no directions from its light.
//! let sky = EnvMap::new(UVec2::new(8, 4), vec![Vec4::ONE; 32])?.without_tables(0.0)?;
//! let image = CpuDrawing::default().render_frame(&scene, &sky, &settings, &|_| ())?;
//! assert!((image.linear[0].x - 0.5).abs() < 0.02);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Passes
//!
//! Each kernel that is launched has a *pass* in [`generated::passes`]: a struct of the kernel's own arguments. Any executor of
//! `glimt-executor` runs it, on the CPU or on a GPU. Here the display image of a white pixel and of a black one:
//!
//! ```
//! use glam::{UVec2, Vec3, Vec4};
//! use glimt_executor::{Chunks, Executor, Host, Serial};
//! use glimt_render_gpu::generated::passes::Tonemap;
//! use glimt_render_gpu::prepare::render::RenderSettings;
//! use glimt_render_gpu::prepare::scene::Camera;
//!
//! let camera = Camera { eye: Vec3::X, target: Vec3::ZERO, up: Vec3::Z, fov_x: 1.0 };
//! let frame = RenderSettings::new(UVec2::new(2, 1), camera).frame_params()?;
//! let linear = [Vec4::ONE, Vec4::W];
//! let mut codes = [0; 2];
//! let pass = Tonemap::<Host> {
//!     frame: &frame,
//!     linear: &linear,
//!     out: Chunks::new(&mut codes, 1),
//! };
//! Serial.run(pass, 0..2)?;
//! assert_eq!(codes, [0xffff_ffff, 0xff00_0000]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! An argument that is missing does not compile:
//!
//! ```compile_fail,E0063
//! # use glam::{UVec2, Vec3, Vec4};
//! # use glimt_executor::{Chunks, Executor, Host, Serial};
//! # use glimt_render_gpu::generated::passes::Tonemap;
//! # use glimt_render_gpu::prepare::render::RenderSettings;
//! # use glimt_render_gpu::prepare::scene::Camera;
//! # let camera = Camera { eye: Vec3::X, target: Vec3::ZERO, up: Vec3::Z, fov_x: 1.0 };
//! # let frame = RenderSettings::new(UVec2::new(2, 1), camera).frame_params()?;
//! let linear = [Vec4::ONE, Vec4::W];
//! let mut codes = [0; 2];
//! let pass = Tonemap::<Host> {
//!     frame: &frame,
//!     out: Chunks::new(&mut codes, 1),
//! };
//! # Serial.run(pass, 0..2)?;
//! # assert_eq!(codes, [0xffff_ffff, 0xff00_0000]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Nor does an argument of another type, here pixels without alpha:
//!
//! ```compile_fail,E0308
//! # use glam::{UVec2, Vec3, Vec4};
//! # use glimt_executor::{Chunks, Executor, Host, Serial};
//! # use glimt_render_gpu::generated::passes::Tonemap;
//! # use glimt_render_gpu::prepare::render::RenderSettings;
//! # use glimt_render_gpu::prepare::scene::Camera;
//! # let camera = Camera { eye: Vec3::X, target: Vec3::ZERO, up: Vec3::Z, fov_x: 1.0 };
//! # let frame = RenderSettings::new(UVec2::new(2, 1), camera).frame_params()?;
//! let linear = [Vec3::ONE, Vec3::ZERO];
//! let mut codes = [0; 2];
//! let pass = Tonemap::<Host> {
//!     frame: &frame,
//!     linear: &linear,
//!     out: Chunks::new(&mut codes, 1),
//! };
//! # Serial.run(pass, 0..2)?;
//! # assert_eq!(codes, [0xffff_ffff, 0xff00_0000]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Bibliography
//!
//! - J. Kronander, J. Dahlin, D. Jönsson, M. Kok, T. B. Schön, J. Unger: *Real-time video based lighting using GPU
//!   raytracing*, EUSIPCO 2014 (Eqs. 1 and 2; the two passes of § 7).
//! - S. Hajisharif, J. Kronander, E. Miandji, J. Unger: *Real-time image based lighting with streaming HDR-light probe sequences*,
//!   SIGRAD 2012 (Eqs. 2, 3 and 8 to 15).
//! - E. Veach, L. Guibas: *Optimally combining sampling techniques for Monte Carlo rendering*, SIGGRAPH 1995.
//! - S. Woop, C. Benthin, I. Wald: *Watertight ray/triangle intersection*, JCGT 2(1), 2013.
//! - T. Ize: *Robust BVH ray traversal*, JCGT 2(2), 2013.
//! - P. Debevec: *Rendering synthetic objects into real scenes*, SIGGRAPH 1998 (differential rendering, § 5.2).
//! - A. Kensler: *Correlated multi-jittered sampling*, Pixar technical memo 13-01, 2013.

#[macro_use]
pub mod entries;

pub mod cpu;
mod film;
// As the front end writes it.
#[rustfmt::skip]
pub mod generated;
pub mod gpu;
pub mod kernels;
pub mod methods;
pub mod prepare;
pub mod sequence;
pub mod settings;
pub mod words;

/// The crate's name and its shared files, `(path below src/, text)`, for a front end that lowers them to WGSL.
#[cfg(feature = "shader-source")]
pub const SHADER_SOURCE: (&str, &[(&str, &str)]) = ("glimt_render_gpu", generated::sources::FILES);
