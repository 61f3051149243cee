//! Host file: executors that call the kernels themselves.

use std::ops::Range;

use rayon::prelude::*;

use crate::memory::{Device, Element, Host};
use crate::pass::{Executor, Pass};

/// What can go wrong on the CPU.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum HostError {
    /// What a pass writes has room for fewer elements than were asked for.
    #[error("{entry} has room for {found} elements, not for {expected}")]
    Short {
        /// The pass.
        entry: String,
        /// Elements for which there is room.
        found: usize,
        /// Elements that were asked for.
        expected: usize,
    },
    /// A list is shorter than what is put into it or read from it.
    #[error("a list of {found} values is to hold {expected}")]
    Length {
        /// Its values.
        found: usize,
        /// Values that were asked for.
        expected: usize,
    },
    /// There is not enough memory.
    #[error("there is not enough memory for '{label}' of {bytes} bytes")]
    Memory {
        /// What it was for.
        label: String,
        /// How much.
        bytes: usize,
    },
}

/// Makes lists in the program's own memory.
#[derive(Clone, Copy, Debug, Default)]
pub struct Cpu;

impl Cpu {
    fn room<T>(label: &str, count: usize) -> Result<Vec<T>, HostError> {
        let mut list = Vec::new();
        let refused = |_| HostError::Memory {
            label: label.to_owned(),
            bytes: count.saturating_mul(size_of::<T>()),
        };
        list.try_reserve_exact(count).map_err(refused)?;
        Ok(list)
    }
}

impl Device for Cpu {
    type Memory = Host;
    type Error = HostError;

    fn zeroed<T: Element + bytemuck::Zeroable>(
        &self,
        label: &str,
        count: usize,
    ) -> Result<Vec<T>, HostError> {
        let mut list = Self::room(label, count.max(1))?;
        list.resize(count.max(1), T::zeroed());
        Ok(list)
    }

    fn holding<T: Element>(&self, label: &str, values: &[T]) -> Result<Vec<T>, HostError> {
        let mut list = Self::room(label, values.len())?;
        list.extend_from_slice(values);
        Ok(list)
    }

    fn put<T: Element>(&self, buffer: &mut Vec<T>, values: &[T]) -> Result<(), HostError> {
        let (found, expected) = (buffer.len(), values.len());
        let place = buffer.get_mut(..expected);
        place
            .ok_or(HostError::Length { found, expected })?
            .copy_from_slice(values);
        Ok(())
    }

    fn get<T: Element + bytemuck::AnyBitPattern>(
        &self,
        buffer: &Vec<T>,
        count: usize,
    ) -> Result<Vec<T>, HostError> {
        let (found, expected) = (buffer.len(), count);
        let values = buffer.get(..count);
        Ok(values
            .ok_or(HostError::Length { found, expected })?
            .to_vec())
    }
}

/// Runs passes on the calling thread: for tiles that are shared out among threads as wholes.
#[derive(Clone, Copy, Debug, Default)]
pub struct Serial;

/// Runs passes on all of rayon's threads.
#[derive(Clone, Copy, Debug)]
pub struct Rayon {
    /// Elements that one thread takes at a time; 0 counts as 1. It changes no bit.
    pub grain: usize,
}

impl Default for Rayon {
    fn default() -> Self {
        Self { grain: 256 }
    }
}

/// The part of a pass that belongs to a range of elements.
fn part<P: Pass<Memory = Host>>(pass: P, range: &Range<u32>) -> Result<P, HostError> {
    let expected = range.len();
    let found = pass.elements();
    if found < expected {
        return Err(HostError::Short {
            entry: P::entry().name.clone().into_owned(),
            found,
            expected,
        });
    }
    Ok(if found == expected {
        pass
    } else {
        pass.split_at(expected).0
    })
}

impl Executor for Serial {
    type Memory = Host;
    type Error = HostError;

    fn run<P: Pass<Memory = Host>>(&mut self, pass: P, range: Range<u32>) -> Result<(), HostError> {
        part(pass, &range)?.compute(range.start);
        Ok(())
    }
}

impl Executor for Rayon {
    type Memory = Host;
    type Error = HostError;

    fn run<P: Pass<Memory = Host>>(&mut self, pass: P, range: Range<u32>) -> Result<(), HostError> {
        let mut rest = part(pass, &range)?;
        let grain = self.grain.clamp(1, u32::MAX as usize);
        let mut parts = Vec::with_capacity(range.len().div_ceil(grain));
        for first in range.clone().step_by(grain) {
            let (own, others) = rest.split_at(grain);
            parts.push((first, own));
            rest = others;
        }
        parts
            .into_par_iter()
            .for_each(|(first, own)| own.compute(first));
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use std::borrow::Cow::Borrowed;

    use super::*;
    use crate::entry::{Entry, ParamsSpace};
    use crate::memory::{Chunks, HostMemory, Memory};
    use crate::pass::Binder;

    static SQUARES: Entry = Entry {
        name: Borrowed("squares"),
        kernel: Borrowed(""),
        wgsl: Borrowed(""),
        workgroup_size: 64,
        params_size: 8,
        params_space: ParamsSpace::Uniform,
        params: Borrowed(&[]),
        buffers: Borrowed(&[]),
    };

    /// Adds to `out` the square of the element's index, and fills its chunk of `parts` with the index and the place in the chunk.
    struct Squares<'a, M: Memory> {
        parts: M::Chunks<'a, [u32; 2]>,
        out: M::Chunks<'a, u32>,
    }

    impl<M: Memory> Pass for Squares<'_, M> {
        type Memory = M;

        fn entry() -> &'static Entry {
            &SQUARES
        }

        fn bind(&self, binder: &mut impl Binder<M>) {
            binder.chunks(0, 2, &self.parts);
            binder.out(1, &self.out);
        }

        fn elements(&self) -> usize
        where
            M: HostMemory,
        {
            M::count(&self.parts).min(M::count(&self.out))
        }

        fn split_at(self, at: usize) -> (Self, Self)
        where
            M: HostMemory,
        {
            let (parts, rest_of_parts) = M::split_at(self.parts, at);
            let (out, rest_of_out) = M::split_at(self.out, at);
            let rest = Self {
                parts: rest_of_parts,
                out: rest_of_out,
            };
            (Self { parts, out }, rest)
        }

        fn compute(self, first: u32)
        where
            M: HostMemory,
        {
            let elements = M::each(self.parts).zip(M::each(self.out));
            for (id, (parts, out)) in (first..).zip(elements) {
                for (place, part) in parts.iter_mut().enumerate() {
                    *part = [id, place as u32];
                }
                out[0] += id * id;
            }
        }
    }

    const PER_ELEMENT: usize = 3;
    const UNTOUCHED: [u32; 2] = [u32::MAX; 2];

    /// The two outputs, and whether the pass ran.
    type Outcome<E> = (Vec<[u32; 2]>, Vec<u32>, Result<(), E>);

    /// Runs the pass with room for so many chunks and so many values.
    fn squares<E: Executor<Memory = Host>>(
        mut executor: E,
        (chunks, values): (usize, usize),
        range: Range<u32>,
    ) -> Outcome<E::Error> {
        let mut parts = vec![UNTOUCHED; chunks * PER_ELEMENT];
        let mut out = vec![0; values];
        let pass = Squares {
            parts: Chunks::new(&mut parts, PER_ELEMENT),
            out: Chunks::new(&mut out, 1),
        };
        let done = executor.run(pass, range);
        (parts, out, done)
    }

    #[test]
    fn an_element_fills_the_chunk_of_its_place_in_the_range() {
        let (parts, out, done) = squares(Serial, (5, 6), 10..14);
        assert_eq!(done, Ok(()));
        // Adding shows that each element is computed once; there is room beyond the range, which stays as it was.
        assert_eq!(out, [100, 121, 144, 169, 0, 0]);
        let ids = (10..14).flat_map(|id| (0..PER_ELEMENT as u32).map(move |place| [id, place]));
        let expected: Vec<_> = ids.chain([UNTOUCHED; PER_ELEMENT]).collect();
        assert_eq!(parts, expected);
    }

    #[test]
    fn neither_threads_nor_their_grain_change_results() {
        for range in [0..0, 7..7, 0..1, 3..100, 1000..1257] {
            let room = (range.len() + 1, range.len() + 2);
            let expected = squares(Serial, room, range.clone());
            assert_eq!(expected.2, Ok(()));
            for grain in [0, 1, 3, 32, 97, 256, usize::MAX] {
                let found = squares(Rayon { grain }, room, range.clone());
                assert_eq!(found, expected, "{range:?} by {grain}");
            }
        }
    }

    #[test]
    fn too_little_room_is_an_error_and_nothing_is_written() {
        let short = Err(HostError::Short {
            entry: "squares".into(),
            found: 3,
            expected: 4,
        });
        for room in [(3, 4), (4, 3)] {
            for (parts, out, done) in [
                squares(Serial, room, 5..9),
                squares(Rayon { grain: 2 }, room, 5..9),
            ] {
                assert_eq!(done, short);
                assert!(parts.iter().all(|part| *part == UNTOUCHED));
                assert!(out.iter().all(|value| *value == 0));
            }
        }
    }

    #[test]
    fn lists_hold_what_is_put_into_them_and_no_more() {
        let mut list = Cpu.holding("list", &[1, 2, 3]).unwrap();
        Cpu.put(&mut list, &[7, 8]).unwrap();
        assert_eq!(Cpu.get(&list, 3), Ok(vec![7, 8, 3]));
        assert_eq!(Cpu.get(&list, 2), Ok(vec![7, 8]));
        let length = HostError::Length {
            found: 3,
            expected: 4,
        };
        assert_eq!(Cpu.put(&mut list, &[0; 4]), Err(length.clone()));
        assert_eq!(Cpu.get(&list, 4), Err(length));
        assert_eq!(list, [7, 8, 3]);

        assert_eq!(Cpu.zeroed("list", 2), Ok(vec![0u64; 2]));
        // As on a GPU, which has no empty buffer.
        assert_eq!(Cpu.zeroed("list", 0), Ok(vec![0u64]));
        let refused = Cpu.zeroed::<u64>("list", usize::MAX).unwrap_err();
        let bytes = usize::MAX;
        let label = "list".into();
        assert_eq!(refused, HostError::Memory { label, bytes });
    }
}
