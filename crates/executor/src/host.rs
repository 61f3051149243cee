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
