//! Host file: the slices of a pass on a GPU: parts of buffers, with the type of their values.

use std::marker::PhantomData;
use std::ops::Range;

use super::buffer::{GpuBuffer, GpuVec};
use crate::memory::{Element, Memory};

/// A GPU's memory: lists are [`GpuVec`], slices are [`GpuSlice`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Gpu {}

/// Values in a buffer that a pass reads.
#[derive(Debug)]
pub struct GpuSlice<'a, T> {
    pub(super) buffer: &'a GpuBuffer,
    /// In values.
    pub(super) first: u64,
    pub(super) count: u64,
    values: PhantomData<fn() -> T>,
}

impl<T> Clone for GpuSlice<'_, T> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T> Copy for GpuSlice<'_, T> {}

/// Values in a buffer that a pass writes, so many for each element.
#[derive(Debug)]
pub struct GpuChunks<'a, T> {
    pub(super) values: GpuSlice<'a, T>,
    pub(super) per_element: u32,
}

impl<T: Element> GpuVec<T> {
    /// All of its values, to be read.
    #[must_use]
    pub fn all(&self) -> GpuSlice<'_, T> {
        self.part(0, self.count())
    }

    /// `count` values from `first` on, to be read. A launch refuses a part that lies beyond the end.
    #[must_use]
    pub fn part(&self, first: u64, count: u64) -> GpuSlice<'_, T> {
        GpuSlice {
            buffer: self,
            first,
            count,
            values: PhantomData,
        }
    }

    /// What elements return: one value each, from the buffer's start on.
    #[must_use]
    pub fn out(&self) -> GpuChunks<'_, T> {
        self.all().written(1)
    }
}

impl<'a, T: Element> GpuSlice<'a, T> {
    /// The same part, to be written, `per_element` values for each element.
    #[must_use]
    pub fn written(self, per_element: u32) -> GpuChunks<'a, T> {
        GpuChunks {
            values: self,
            per_element,
        }
    }
}

impl Memory for Gpu {
    type Buffer<T: Element> = GpuVec<T>;
    type Slice<'a, T: Element> = GpuSlice<'a, T>;
    type Chunks<'a, T: Element> = GpuChunks<'a, T>;

    fn shorten<'b, 'a: 'b, T: Element>(slice: Self::Slice<'a, T>) -> Self::Slice<'b, T> {
        slice
    }

    fn shorten_chunks<'b, 'a: 'b, T: Element>(chunks: Self::Chunks<'a, T>) -> Self::Chunks<'b, T> {
        chunks
    }

    fn reborrow<'b, 'a: 'b, T: Element>(chunks: &'b mut GpuChunks<'a, T>) -> GpuChunks<'b, T> {
        chunks.values.written(chunks.per_element)
    }

    fn in_chunks_of<'b, 'a: 'b, T: Element>(
        chunks: GpuChunks<'a, T>,
        per_element: usize,
    ) -> GpuChunks<'b, T> {
        chunks.values.written(per_element as u32)
    }

    fn filled<'b, 'a: 'b, T: Element>(chunks: &'b GpuChunks<'a, T>) -> GpuSlice<'b, T> {
        chunks.values
    }

    fn slice<T: Element>(buffer: &GpuVec<T>, range: Range<usize>) -> GpuSlice<'_, T> {
        assert!(range.end as u64 <= buffer.count(), "a part beyond the end");
        buffer.part(range.start as u64, range.len() as u64)
    }

    fn chunks<T: Element>(
        buffer: &mut GpuVec<T>,
        range: Range<usize>,
        per_element: u32,
    ) -> GpuChunks<'_, T> {
        Self::slice(buffer, range).written(per_element)
    }
}
