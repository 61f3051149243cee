//! Host file: the numbers of a glTF accessor. Every index and length is checked.

use super::Reader;
use crate::error::Result;
use crate::memory;
use ::gltf::accessor::sparse::IndexType;
use ::gltf::accessor::{Accessor, DataType};
use ::gltf::buffer::View;

/// How whole numbers become floats.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Whole {
    /// As the fractions that they stand for where the accessor says so, else as they are.
    AsMarked,
    /// As fractions in any case: 255, or 127, is 1.
    Fractions,
}

/// Elements of some bytes each, `stride` bytes apart.
struct Elements<'a> {
    bytes: &'a [u8],
    stride: usize,
    size: usize,
    count: usize,
}

impl<'a> Elements<'a> {
    fn iter(&self) -> impl Iterator<Item = &'a [u8]> + use<'a> {
        let (bytes, stride, size) = (self.bytes, self.stride, self.size);
        (0..self.count).map(move |i| &bytes[i * stride..][..size])
    }
}

impl<'a> Reader<'a> {
    /// The elements of an accessor as `N` floats each, of the types that are allowed. `what` names them in errors.
    pub(super) fn floats<const N: usize>(
        &self,
        accessor: &Accessor<'_>,
        types: &[DataType],
        whole: Whole,
        what: &str,
    ) -> Result<Vec<[f32; N]>> {
        self.require_type(accessor, N, types, what)?;
        let is_fraction = whole == Whole::Fractions || accessor.normalized();
        let of = |range: f32| if is_fraction { range } else { 1.0 };
        let signed = |value: f32, range: f32| match is_fraction {
            true => (value / range).max(-1.0),
            false => value,
        };
        match accessor.data_type() {
            DataType::F32 => self.gather(accessor, what, |b| {
                f32::from_le_bytes([b[0], b[1], b[2], b[3]])
            }),
            DataType::U8 => self.gather(accessor, what, |b| f32::from(b[0]) / of(255.0)),
            DataType::I8 => self.gather(accessor, what, |b| {
                signed(f32::from(b[0].cast_signed()), 127.0)
            }),
            DataType::U16 => self.gather(accessor, what, |b| {
                f32::from(u16::from_le_bytes([b[0], b[1]])) / of(65535.0)
            }),
            DataType::I16 => self.gather(accessor, what, |b| {
                signed(f32::from(i16::from_le_bytes([b[0], b[1]])), 32767.0)
            }),
            DataType::U32 => Err(self.error(format!("{what} has the wrong type"))),
        }
    }

    /// The elements of an accessor as `N` whole numbers each, of the types that are allowed.
    pub(super) fn integers<const N: usize>(
        &self,
        accessor: &Accessor<'_>,
        types: &[DataType],
        what: &str,
    ) -> Result<Vec<[u32; N]>> {
        self.require_type(accessor, N, types, what)?;
        match accessor.data_type() {
            DataType::U8 => self.gather(accessor, what, |b| u32::from(b[0])),
            DataType::U16 => self.gather(accessor, what, |b| {
                u32::from(u16::from_le_bytes([b[0], b[1]]))
            }),
            DataType::U32 => self.gather(accessor, what, |b| {
                u32::from_le_bytes([b[0], b[1], b[2], b[3]])
            }),
            _ => Err(self.error(format!("{what} has the wrong type"))),
        }
    }

    fn require_type(
        &self,
        accessor: &Accessor<'_>,
        components: usize,
        types: &[DataType],
        what: &str,
    ) -> Result<()> {
        let fits = accessor.dimensions().multiplicity() == components;
        match fits && types.contains(&accessor.data_type()) {
            true => Ok(()),
            false => Err(self.error(format!("{what} has the wrong type"))),
        }
    }

    fn gather<T: Copy + Default, const N: usize>(
        &self,
        accessor: &Accessor<'_>,
        what: &str,
        number: impl Fn(&[u8]) -> T,
    ) -> Result<Vec<[T; N]>> {
        let bytes = accessor.data_type().size();
        let element = |b: &[u8]| std::array::from_fn(|i| number(&b[i * bytes..]));
        let count = accessor.count();
        let mut list: Vec<[T; N]> = match accessor.view() {
            Some(view) => {
                let elements = self.elements(&view, accessor.offset(), N * bytes, count, what)?;
                elements.iter().map(element).collect()
            }
            None => {
                // Nothing in the file bounds it.
                let size = (count as u64).saturating_mul(size_of::<[T; N]>() as u64);
                let room = memory::require("an accessor of this mesh", size);
                room.map_err(|e| e.file(self.file).fix(memory::FIX))?;
                vec![[T::default(); N]; count]
            }
        };
        if let Some(sparse) = accessor.sparse() {
            let (indices, values) = (sparse.indices(), sparse.values());
            let size = match indices.index_type() {
                IndexType::U8 => 1,
                IndexType::U16 => 2,
                IndexType::U32 => 4,
            };
            let (view, offset) = (indices.view(), indices.offset());
            let places = self.elements(&view, offset, size, sparse.count(), what)?;
            let (view, offset) = (values.view(), values.offset());
            let values = self.elements(&view, offset, N * bytes, sparse.count(), what)?;
            for (place, value) in places.iter().zip(values.iter()) {
                let index = place.iter().rev().fold(0, |n, b| n << 8 | usize::from(*b));
                match list.get_mut(index) {
                    Some(old) => *old = element(value),
                    None => {
                        let what = format!("{what} replaces value {index} of {count}");
                        return Err(self.error(what));
                    }
                }
            }
        }
        Ok(list)
    }

    /// `count` elements of `size` bytes in a view, from `offset` on.
    fn elements(
        &self,
        view: &View<'_>,
        offset: usize,
        size: usize,
        count: usize,
        what: &str,
    ) -> Result<Elements<'_>> {
        let stride = view.stride().unwrap_or(size);
        let bytes = self.view(view).and_then(|bytes| bytes.get(offset..));
        let length = match count {
            0 => Some(0),
            n => stride.checked_mul(n - 1).and_then(|l| l.checked_add(size)),
        };
        match (bytes, length) {
            (Some(bytes), Some(length)) if length <= bytes.len() => Ok(Elements {
                bytes,
                stride,
                size,
                count,
            }),
            _ => Err(self.error(format!("{what} reaches beyond its buffer"))),
        }
    }

    /// The bytes of a view; nothing where it reaches beyond its buffer.
    pub(super) fn view(&self, view: &View<'_>) -> Option<&[u8]> {
        let end = view.offset().checked_add(view.length())?;
        self.buffers
            .get(view.buffer().index())?
            .get(view.offset()..end)
    }
}
