//! Host file: where the slices of a pass lie.

use std::ops::Range;
use std::slice::ChunksExactMut;

/// A value that may lie in a buffer: plain bytes without padding.
pub trait Element: bytemuck::NoUninit + Send + Sync {}

impl<T: bytemuck::NoUninit + Send + Sync> Element for T {}

/// Where the slices of a pass lie: in the program's own memory, or on a GPU.
pub trait Memory: Copy + Sized + 'static {
    /// A list that owns its values.
    type Buffer<T: Element>;
    /// Values that all elements of a pass read.
    type Slice<'a, T: Element>: Copy + Send + Sync;
    /// Values that a pass writes: the same number for each of its elements, one after the other.
    type Chunks<'a, T: Element>: Send;

    /// The same values for a shorter time. Where the memory is known the compiler does so by itself; in code for all memories
    /// it cannot.
    fn shorten<'b, 'a: 'b, T: Element>(slice: Self::Slice<'a, T>) -> Self::Slice<'b, T>;

    /// As [`Memory::shorten`], of what is written.
    fn shorten_chunks<'b, 'a: 'b, T: Element>(chunks: Self::Chunks<'a, T>) -> Self::Chunks<'b, T>;

    /// The same chunks while they are borrowed: a pass writes them, and they can be used again after it.
    fn reborrow<'b, 'a: 'b, T: Element>(chunks: &'b mut Self::Chunks<'a, T>)
    -> Self::Chunks<'b, T>;

    /// The same values, as chunks of another number for each element.
    fn in_chunks_of<'b, 'a: 'b, T: Element>(
        chunks: Self::Chunks<'a, T>,
        per_element: usize,
    ) -> Self::Chunks<'b, T>;

    /// All values of the chunks, to be read by a pass that comes after the one that fills them.
    fn filled<'b, 'a: 'b, T: Element>(chunks: &'b Self::Chunks<'a, T>) -> Self::Slice<'b, T>;

    /// Values `range` of a buffer, to be read.
    ///
    /// # Panics
    /// The buffer is shorter.
    fn slice<T: Element>(buffer: &Self::Buffer<T>, range: Range<usize>) -> Self::Slice<'_, T>;

    /// Values `range` of a buffer, to be written, `per_element` for each element.
    ///
    /// # Panics
    /// The buffer is shorter.
    fn chunks<T: Element>(
        buffer: &mut Self::Buffer<T>,
        range: Range<usize>,
        per_element: u32,
    ) -> Self::Chunks<'_, T>;
}

/// The memory that the program itself reads: what executors on the CPU need. [`Host`] is the only one.
pub trait HostMemory: Memory {
    /// The values.
    fn values<'a, T: Element>(slice: Self::Slice<'a, T>) -> &'a [T];
    /// For how many elements there are chunks.
    fn count<T: Element>(chunks: &Self::Chunks<'_, T>) -> usize;
    /// The chunks of the first `at` elements, and the others.
    fn split_at<'a, T: Element>(
        chunks: Self::Chunks<'a, T>,
        at: usize,
    ) -> (Self::Chunks<'a, T>, Self::Chunks<'a, T>);
    /// One chunk after the other.
    fn each<'a, T: Element>(chunks: Self::Chunks<'a, T>) -> ChunksExactMut<'a, T>;
}

/// What makes buffers, fills them and reads them.
pub trait Device {
    /// Where its buffers lie.
    type Memory: Memory;
    /// What can go wrong.
    type Error: std::error::Error + Send + Sync + 'static;

    /// Room for `count` values, at least one, all bytes zero. Errors name the buffer by its label.
    ///
    /// # Errors
    /// There is not enough memory.
    fn zeroed<T: Element + bytemuck::Zeroable>(
        &self,
        label: &str,
        count: usize,
    ) -> Result<<Self::Memory as Memory>::Buffer<T>, Self::Error>;

    /// A buffer that holds `values`.
    ///
    /// # Errors
    /// There is not enough memory.
    fn holding<T: Element>(
        &self,
        label: &str,
        values: &[T],
    ) -> Result<<Self::Memory as Memory>::Buffer<T>, Self::Error>;

    /// Puts `values` at the start of a buffer.
    ///
    /// # Errors
    /// The buffer is shorter.
    fn put<T: Element>(
        &self,
        buffer: &mut <Self::Memory as Memory>::Buffer<T>,
        values: &[T],
    ) -> Result<(), Self::Error>;

    /// The first `count` values of a buffer, once all that writes it is done.
    ///
    /// # Errors
    /// The buffer is shorter; failures of the device.
    fn get<T: Element + bytemuck::AnyBitPattern>(
        &self,
        buffer: &<Self::Memory as Memory>::Buffer<T>,
        count: usize,
    ) -> Result<Vec<T>, Self::Error>;
}

/// The program's own memory: lists are `Vec`, slices are slices.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Host {}

/// Values that are written, so many for each element.
#[derive(Debug)]
pub struct Chunks<'a, T> {
    values: &'a mut [T],
    per_element: usize,
}

impl<'a, T> Chunks<'a, T> {
    /// `values` in chunks of `per_element`, of which 0 counts as 1. What is left beyond whole chunks is not used.
    #[must_use]
    pub fn new(values: &'a mut [T], per_element: usize) -> Self {
        let per_element = per_element.max(1);
        Self {
            values,
            per_element,
        }
    }
}

impl Memory for Host {
    type Buffer<T: Element> = Vec<T>;
    type Slice<'a, T: Element> = &'a [T];
    type Chunks<'a, T: Element> = Chunks<'a, T>;

    #[inline]
    fn shorten<'b, 'a: 'b, T: Element>(slice: Self::Slice<'a, T>) -> Self::Slice<'b, T> {
        slice
    }

    #[inline]
    fn shorten_chunks<'b, 'a: 'b, T: Element>(chunks: Self::Chunks<'a, T>) -> Self::Chunks<'b, T> {
        chunks
    }

    fn reborrow<'b, 'a: 'b, T: Element>(chunks: &'b mut Chunks<'a, T>) -> Chunks<'b, T> {
        Chunks::new(chunks.values, chunks.per_element)
    }

    fn in_chunks_of<'b, 'a: 'b, T: Element>(
        chunks: Chunks<'a, T>,
        per_element: usize,
    ) -> Chunks<'b, T> {
        Chunks::new(chunks.values, per_element)
    }

    fn filled<'b, 'a: 'b, T: Element>(chunks: &'b Chunks<'a, T>) -> &'b [T] {
        chunks.values
    }

    fn slice<T: Element>(buffer: &Vec<T>, range: Range<usize>) -> &[T] {
        &buffer[range]
    }

    fn chunks<T: Element>(
        buffer: &mut Vec<T>,
        range: Range<usize>,
        per_element: u32,
    ) -> Chunks<'_, T> {
        Chunks::new(&mut buffer[range], per_element as usize)
    }
}

impl HostMemory for Host {
    #[inline]
    fn values<'a, T: Element>(slice: Self::Slice<'a, T>) -> &'a [T] {
        slice
    }

    fn count<T: Element>(chunks: &Chunks<'_, T>) -> usize {
        chunks.values.len() / chunks.per_element
    }

    fn split_at<'a, T: Element>(
        chunks: Self::Chunks<'a, T>,
        at: usize,
    ) -> (Self::Chunks<'a, T>, Self::Chunks<'a, T>) {
        let Chunks {
            values,
            per_element,
        } = chunks;
        let middle = at.saturating_mul(per_element).min(values.len());
        let (first, rest) = values.split_at_mut(middle);
        (
            Chunks::new(first, per_element),
            Chunks::new(rest, per_element),
        )
    }

    #[inline]
    fn each<'a, T: Element>(chunks: Self::Chunks<'a, T>) -> ChunksExactMut<'a, T> {
        chunks.values.chunks_exact_mut(chunks.per_element)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chunks_of(chunks: Chunks<'_, u32>) -> Vec<Vec<u32>> {
        Host::each(chunks).map(|chunk| chunk.to_vec()).collect()
    }

    #[test]
    fn a_buffer_is_cut_by_ranges_of_values() {
        let mut buffer: Vec<u32> = (0..10).collect();
        assert_eq!(Host::slice(&buffer, 2..5), [2, 3, 4]);
        assert!(Host::slice(&buffer, 10..10).is_empty());
        let chunks = Host::chunks(&mut buffer, 3..9, 2);
        assert_eq!(Host::count(&chunks), 3);
        assert_eq!(chunks_of(chunks), [[3, 4], [5, 6], [7, 8]]);
        let chunks = Host::in_chunks_of(Host::chunks(&mut buffer, 3..9, 2), 3);
        assert_eq!(chunks_of(chunks), [[3, 4, 5], [6, 7, 8]]);
    }

    #[test]
    fn whole_chunks_alone_are_used() {
        let mut values = [1, 2, 3, 4, 5];
        let chunks = Chunks::new(&mut values, 2);
        assert_eq!(Host::count(&chunks), 2);
        assert_eq!(chunks_of(chunks), [[1, 2], [3, 4]]);
        let chunks = Chunks::new(&mut values, 6);
        assert_eq!(Host::count(&chunks), 0);
        // Chunks of none would be without end.
        let chunks = Chunks::new(&mut values, 0);
        assert_eq!(Host::count(&chunks), 5);
        assert_eq!(chunks_of(chunks), [[1], [2], [3], [4], [5]]);
    }

    #[test]
    fn chunks_are_split_between_elements() {
        for at in [0, 1, 2, 3, 4, usize::MAX] {
            let mut values: Vec<u32> = (0..9).collect();
            let (first, rest) = Host::split_at(Chunks::new(&mut values, 3), at);
            let expected: Vec<Vec<u32>> = vec![vec![0, 1, 2], vec![3, 4, 5], vec![6, 7, 8]];
            let (before, behind) = expected.split_at(at.min(3));
            assert_eq!(Host::count(&first), before.len());
            assert_eq!(Host::count(&rest), behind.len());
            assert_eq!(chunks_of(first), before);
            assert_eq!(chunks_of(rest), behind);
        }
    }
}
