//! Host file: a kernel with its arguments, and what runs it.

use std::ops::Range;

use crate::entry::Entry;
use crate::memory::{Element, HostMemory, Memory};

/// A kernel with all of its arguments but the element's index. Generated code implements it.
pub trait Pass: Send + Sized {
    /// Where its slices lie.
    type Memory: Memory;

    /// The shader that was made of the kernel.
    fn entry() -> &'static Entry;

    /// Hands the arguments that the shader reads to a GPU's binder.
    fn bind(&self, binder: &mut impl Binder<Self::Memory>);

    /// For how many elements there is room in what it writes.
    fn elements(&self) -> usize
    where
        Self::Memory: HostMemory;

    /// The pass over the first `at` elements, and over the others. Both read the same.
    fn split_at(self, at: usize) -> (Self, Self)
    where
        Self::Memory: HostMemory;

    /// Calls the kernel for elements `first`, `first + 1`, … as far as there is room, on this thread.
    fn compute(self, first: u32)
    where
        Self::Memory: HostMemory;
}

/// What takes the arguments of a pass. Fields and slots are numbered as in [`Entry::params`] and [`Entry::buffers`].
pub trait Binder<M: Memory> {
    /// A plain value.
    fn value<T: bytemuck::NoUninit>(&mut self, field: usize, value: &T);
    /// A slice that all elements read.
    fn slice<T: Element>(&mut self, slot: usize, slice: M::Slice<'_, T>);
    /// What the elements return.
    fn out<T: Element>(&mut self, slot: usize, chunks: &M::Chunks<'_, T>);
    /// A chunk argument; `field` holds its length.
    fn chunks<T: Element>(&mut self, slot: usize, field: usize, chunks: &M::Chunks<'_, T>);
}

/// Something that runs passes.
pub trait Executor {
    /// Where it looks for slices.
    type Memory: Memory;
    /// What can go wrong.
    type Error: std::error::Error + Send + Sync + 'static;

    /// Runs a pass for elements `range.start .. range.end`: element `range.start + i` fills the i-th chunk of what it writes.
    ///
    /// # Errors
    /// What the pass writes is shorter than the range; failures of the device.
    fn run<P: Pass<Memory = Self::Memory>>(
        &mut self,
        pass: P,
        range: Range<u32>,
    ) -> Result<(), Self::Error>;
}
