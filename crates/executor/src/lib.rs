//! Host file: runs kernels on the CPU and on a GPU.
//!
//! A *kernel* is a Rust function that computes one element from its index and from inputs that it only reads. These types
//! surround it:
//!
//! - [`Entry`] describes the compute shader that `naga-front-rust` makes of the kernel: the text, and where its arguments lie.
//! - [`Pass`] is the kernel with its arguments. Each argument has the type of the kernel's own argument.
//! - [`Memory`] says where the arguments lie: in the program's own memory ([`Host`]) or on a GPU ([`gpu::Gpu`]).
//! - [`Device`] makes lists in such a memory: [`Cpu`] and [`gpu::GpuContext`].
//! - [`Executor`] runs passes over a range of elements. [`Serial`] and [`Rayon`] call the function; [`gpu::Direct`] launches the
//!   shader and waits for it; [`gpu::Recording`] collects launches and submits them together.
//!
//! An argument that is missing or has another type does not compile. Code over a [`Device`] and an [`Executor`] is written once
//! and runs on all of them:
//!
//! ```
//! use std::borrow::Cow::Borrowed;
//! use std::error::Error;
//!
//! use glimt_executor::gpu::{AdapterPreference, Direct, GpuContext, GpuError};
//! use glimt_executor::{
//!     Binder, BufferSlot, Cpu, Device, Entry, Executor, HostMemory, Memory, ParamField, ParamsSpace, Pass, Rayon,
//! };
//!
//! /// The kernel: one element.
//! fn double(id: u32, values: &[u32]) -> u32 {
//!     2 * values[id as usize]
//! }
//!
//! /// The same as a shader. The front end writes such text, and what is known of it.
//! static DOUBLE: Entry = Entry {
//!     name: Borrowed("double"),
//!     kernel: Borrowed("example::double"),
//!     wgsl: Borrowed(
//!         "struct Params { first: u32, count: u32 }
//!         @group(0) @binding(0) var<uniform> params: Params;
//!         @group(0) @binding(1) var<storage, read> values: array<u32>;
//!         @group(0) @binding(2) var<storage, read_write> out: array<u32>;
//!         @compute @workgroup_size(64)
//!         fn double(
//!             @builtin(global_invocation_id) id: vec3<u32>,
//!             @builtin(num_workgroups) groups: vec3<u32>,
//!         ) {
//!             let local = id.y * groups.x * 64u + id.x;
//!             if local < params.count { out[local] = 2u * values[params.first + local]; }
//!         }",
//!     ),
//!     workgroup_size: 64,
//!     params_size: 8,
//!     params_space: ParamsSpace::Uniform,
//!     params: Borrowed(&[ParamField::new("first", 0, 4), ParamField::new("count", 4, 4)]),
//!     buffers: Borrowed(&[BufferSlot::new("values", 1, 4, false), BufferSlot::new("out", 2, 4, true)]),
//! };
//!
//! /// The pass. Generated code looks like this.
//! struct Double<'a, M: Memory> {
//!     values: M::Slice<'a, u32>,
//!     out: M::Chunks<'a, u32>,
//! }
//!
//! impl<'a, M: Memory> Pass for Double<'a, M> {
//!     type Memory = M;
//!
//!     fn entry() -> &'static Entry {
//!         &DOUBLE
//!     }
//!
//!     fn bind(&self, binder: &mut impl Binder<M>) {
//!         binder.slice(0, self.values);
//!         binder.out(1, &self.out);
//!     }
//!
//!     fn elements(&self) -> usize where M: HostMemory {
//!         M::count(&self.out)
//!     }
//!
//!     fn split_at(self, at: usize) -> (Self, Self) where M: HostMemory {
//!         let (out, rest) = M::split_at(self.out, at);
//!         (Self { values: self.values, out }, Self { values: self.values, out: rest })
//!     }
//!
//!     fn compute(self, first: u32) where M: HostMemory {
//!         let values = M::values(self.values);
//!         for (id, out) in (first..).zip(M::each(self.out)) {
//!             out[0] = double(id, values);
//!         }
//!     }
//! }
//!
//! /// Twice each value, wherever that is computed.
//! fn doubled<D: Device, E: Executor<Memory = D::Memory>>(
//!     device: &D,
//!     mut executor: E,
//!     values: &[u32],
//! ) -> Result<Vec<u32>, Box<dyn Error>> {
//!     let count = values.len();
//!     let values = device.holding("values", values)?;
//!     let mut out = device.zeroed("out", count)?;
//!     let pass = Double::<D::Memory> {
//!         values: D::Memory::slice(&values, 0..count),
//!         out: D::Memory::chunks(&mut out, 0..count, 1),
//!     };
//!     executor.run(pass, 0..count as u32)?;
//!     Ok(device.get(&out, count)?)
//! }
//!
//! assert_eq!(doubled(&Cpu, Rayon::default(), &[1, 2, 3])?, [2, 4, 6]);
//! match GpuContext::new(AdapterPreference::Fastest) {
//!     Ok(gpu) => assert_eq!(doubled(&gpu, Direct::new(&gpu), &[1, 2, 3])?, [2, 4, 6]),
//!     Err(GpuError::NoAdapter) => println!("There is no GPU."),
//!     Err(error) => return Err(error.into()),
//! }
//! # Ok::<(), Box<dyn Error>>(())
//! ```
//!
//! A shader that a program makes while it runs has no such pass. With the feature `naga-front-rust`, `Entry::from(&shader)` describes
//! it, and [`gpu::GpuContext::launch`] takes its arguments by their paths. They are checked at the launch.

#![deny(unsafe_code)]

mod entry;
pub mod gpu;
mod host;
mod memory;
mod pass;

pub use entry::{BufferSlot, Entry, ParamField, ParamsSpace};
pub use host::{Cpu, HostError, Rayon, Serial};
pub use memory::{Chunks, Device, Element, Host, HostMemory, Memory};
pub use pass::{Binder, Executor, Pass};
