//! Runs kernels on the CPU and on a GPU.
//!
//! A *kernel* is a Rust function that computes one element from its index and read-only inputs. An [`Entry`] describes the
//! compute shader that `naga-front-rust` makes of it. A [`Pass`] is a kernel with its arguments; an [`Executor`] runs passes:
//! [`Serial`] and [`Rayon`] call the function itself, [`gpu::Direct`] and [`gpu::Recording`] launch the shader. Each argument
//! of a pass has the type of the kernel's own argument, in the [`Memory`] of the executor. So an argument that is missing or
//! has another type does not compile, and code that runs passes is written once for all executors.
//!
//! ```
//! use glimt_executor::{Chunks, Element, Executor, HostMemory, Memory, Pass, Rayon};
//!
//! /// The kernel: one element.
//! fn double(id: u32, values: &[u32]) -> u32 {
//!     2 * values[id as usize]
//! }
//!
//! /// Its pass. Generated code looks like this, with an entry for the GPU.
//! struct Double<'a, M: Memory> {
//!     values: M::Slice<'a, u32>,
//!     out: M::Chunks<'a, u32>,
//! }
//!
//! impl<'a, M: Memory> Pass for Double<'a, M> {
//!     type Memory = M;
//!     fn entry() -> &'static glimt_executor::Entry {
//!         unimplemented!("no shader in this example")
//!     }
//!     fn bind(&self, _: &mut impl glimt_executor::Binder<M>) {}
//!     fn elements(&self) -> usize where M: HostMemory {
//!         M::count(&self.out)
//!     }
//!     fn split_at(self, at: usize) -> (Self, Self) where M: HostMemory {
//!         let (out, rest) = M::split_at(self.out, at);
//!         (Self { values: self.values, out }, Self { values: self.values, out: rest })
//!     }
//!     fn compute(self, first: u32) where M: HostMemory {
//!         for (id, out) in (first..).zip(M::each(self.out)) {
//!             out[0] = double(id, M::values(self.values));
//!         }
//!     }
//! }
//!
//! let values = [1, 2, 3];
//! let mut out = [0; 3];
//! let pass = Double { values: &values[..], out: Chunks::new(&mut out, 1) };
//! Rayon::default().run(pass, 0..3)?;
//! assert_eq!(out, [2, 4, 6]);
//! # Ok::<(), glimt_executor::HostError>(())
//! ```

mod entry;
pub mod gpu;
mod host;
mod memory;
mod pass;

pub use entry::{BufferSlot, Entry, ParamField, ParamsSpace};
pub use host::{Cpu, HostError, Rayon, Serial};
pub use memory::{Chunks, Device, Element, Host, HostMemory, Memory};
pub use pass::{Binder, Executor, Pass};
