//! Host file: the arguments of a launch, checked against its entry.

use super::buffer::GpuBuffer;
use super::device::GpuContext;
use super::error::GpuError;
use super::memory::{Gpu, GpuChunks, GpuSlice};
use crate::entry::Entry;
use crate::memory::Element;
use crate::pass::{Binder, Pass};

/// An argument of a launch, bound by its path: for entries that are made at run time. Others have a [`Pass`].
#[derive(Clone, Copy, Debug)]
pub enum Arg<'a> {
    /// The bytes of a plain value, as `bytemuck::bytes_of` gives them.
    Value(&'a [u8]),
    /// A slice that is read whole, or `out`, which has one value for each element of the launch.
    Buffer(&'a GpuBuffer),
    /// The same of a part of a buffer: from the value of this index on, so many of them, beyond which nothing is read or written.
    Window(&'a GpuBuffer, u32, u32),
    /// A slice that is cut into chunks of so many values, one chunk for each element. Sets `<path>_len`, too.
    Chunk(&'a GpuBuffer, u32),
    /// The same, with the first element's chunk so many chunks from the buffer's start.
    ChunkFrom(&'a GpuBuffer, u32, u32),
}

/// A slice argument, bound: how many of its bytes belong to one element of the launch (none where all elements read
/// it whole).
#[derive(Clone, Debug)]
pub(super) struct Bound {
    /// Index in [`Entry::buffers`].
    pub(super) slot: usize,
    binding: u32,
    buffer: wgpu::Buffer,
    /// Where it begins in the buffer, in bytes.
    pub(super) offset: u64,
    /// How many bytes there are from there on.
    pub(super) len: u64,
    pub(super) bytes_per_element: Option<u64>,
}

impl Bound {
    /// What a dispatch of elements `done .. done + elements` binds: their part, or all of what every element reads.
    pub(super) fn binding(&self, done: u32, elements: u32) -> wgpu::BindGroupEntry<'_> {
        let (from, size) = match self.bytes_per_element {
            Some(bytes) => (u64::from(done) * bytes, u64::from(elements) * bytes),
            None => (0, self.len),
        };
        wgpu::BindGroupEntry {
            binding: self.binding,
            resource: wgpu::BindingResource::Buffer(wgpu::BufferBinding {
                buffer: &self.buffer,
                offset: self.offset + from,
                size: wgpu::BufferSize::new(size),
            }),
        }
    }

    /// Bytes that a dispatch of `count` elements binds.
    pub(super) fn bytes(&self, count: u32) -> u64 {
        self.bytes_per_element
            .map_or(self.len, |bytes| bytes * u64::from(count))
    }

    /// Sees that it begins where a binding may.
    pub(super) fn check_alignment(&self, entry: &Entry, alignment: u64) -> Result<(), GpuError> {
        if self.offset.is_multiple_of(alignment) {
            return Ok(());
        }
        let (path, offset) = (&entry.buffers[self.slot].path, self.offset);
        Err(refused(
            entry,
            format!("'{path}' begins at byte {offset}, which is not a multiple of {alignment}"),
        ))
    }
}

/// The arguments of a launch, checked to be all of the entry's and no others.
#[derive(Debug)]
pub(super) struct Arguments {
    params: Vec<u8>,
    first_at: Option<usize>,
    count_at: Option<usize>,
    pub(super) bound: Vec<Bound>,
}

/// What the launcher itself puts into the params buffer.
const FIRST: &str = "first";
const COUNT: &str = "count";
/// The slot of returned elements.
const OUT: &str = "out";

fn refused(entry: &Entry, problem: String) -> GpuError {
    GpuError::Argument {
        entry: entry.name.clone().into_owned(),
        problem,
    }
}

impl Arguments {
    fn empty(entry: &Entry) -> Self {
        let field = |path: &str| {
            let found = entry.params.iter().find(|field| field.path == path);
            found.map(|field| field.offset as usize)
        };
        Self {
            params: vec![0; entry.params_size as usize],
            first_at: field(FIRST),
            count_at: field(COUNT),
            bound: Vec::with_capacity(entry.buffers.len()),
        }
    }

    /// Those of a pass of `count` elements.
    pub(super) fn of_pass<P: Pass<Memory = Gpu>>(pass: &P, count: u32) -> Result<Self, GpuError> {
        let mut collected = Collected {
            entry: P::entry(),
            count,
            arguments: Self::empty(P::entry()),
            problem: None,
        };
        pass.bind(&mut collected);
        match collected.problem {
            Some(problem) => Err(refused(P::entry(), problem)),
            None => Ok(collected.arguments),
        }
    }

    /// Those given by their paths, for a launch of `count` elements.
    pub(super) fn by_path(
        entry: &Entry,
        args: &[(&str, Arg<'_>)],
        count: u32,
    ) -> Result<Self, GpuError> {
        let fail = |problem: String| refused(entry, problem);
        let find = |path: &str| {
            args.iter()
                .find(|(name, _)| *name == path)
                .map(|(_, arg)| *arg)
        };
        let mut made = Self::empty(entry);
        let own = |path: &str| path == FIRST || path == COUNT;
        for field in entry.params.iter().filter(|field| !own(&field.path)) {
            let path = &*field.path;
            match (find(path), path.strip_suffix("_len").and_then(find)) {
                (Some(Arg::Value(bytes)), _) => made.put(entry, field.offset, field.size, bytes),
                (Some(_), _) => Err(format!("argument '{path}' is a plain value, not a buffer")),
                (None, Some(Arg::Chunk(_, len) | Arg::ChunkFrom(_, len, _))) => {
                    made.put(entry, field.offset, field.size, &len.to_ne_bytes())
                }
                (None, _) => Err(format!("argument '{path}' is missing")),
            }
            .map_err(fail)?;
        }
        for (index, slot) in entry.buffers.iter().enumerate() {
            let (path, stride) = (&*slot.path, u64::from(slot.stride));
            let is_chunk = slot.writable && path != OUT;
            let (buffer, offset, window, bytes_per_element) = match find(path) {
                Some(Arg::Buffer(buffer)) if !is_chunk => {
                    (buffer, 0, None, slot.writable.then_some(stride))
                }
                Some(Arg::Window(buffer, first, len)) if !is_chunk => {
                    let (first, len) = (u64::from(first), u64::from(len));
                    let per_element = slot.writable.then_some(stride);
                    (buffer, first * stride, Some(len * stride), per_element)
                }
                Some(Arg::Chunk(buffer, len)) if is_chunk && len > 0 => {
                    (buffer, 0, None, Some(stride * u64::from(len)))
                }
                Some(Arg::ChunkFrom(buffer, len, first)) if is_chunk && len > 0 => {
                    let bytes = stride * u64::from(len);
                    (buffer, u64::from(first) * bytes, None, Some(bytes))
                }
                Some(_) if is_chunk => {
                    return Err(fail(format!(
                        "argument '{path}' must be a chunk of 1 or more"
                    )));
                }
                Some(_) => return Err(fail(format!("argument '{path}' must be a buffer"))),
                None => return Err(fail(format!("argument '{path}' is missing"))),
            };
            let part = Part {
                buffer,
                offset,
                window,
                bytes_per_element,
            };
            made.bind(entry, index, part, count).map_err(fail)?;
        }
        let known = |path: &str| {
            let is_field = |path: &str| entry.params.iter().any(|field| field.path == path);
            let is_slot = entry.buffers.iter().any(|slot| slot.path == path);
            is_slot || (is_field(path) && !own(path))
        };
        match args.iter().find(|(path, _)| !known(path)) {
            Some((path, _)) => Err(fail(format!("there is no argument '{path}'"))),
            None => Ok(made),
        }
    }

    /// Puts a value's bytes where its field lies.
    fn put(&mut self, entry: &Entry, offset: u32, size: u32, bytes: &[u8]) -> Result<(), String> {
        let field = entry.params.iter().find(|field| field.offset == offset);
        let path = field.map_or("?", |field| &field.path);
        if bytes.len() != size as usize {
            return Err(format!(
                "argument '{path}' is {} bytes, not {size}",
                bytes.len()
            ));
        }
        let place = self
            .params
            .get_mut(offset as usize..(offset + size) as usize);
        place
            .ok_or_else(|| format!("parameter '{path}' lies outside the params buffer"))?
            .copy_from_slice(bytes);
        Ok(())
    }

    /// Binds a part of a buffer to a slot.
    fn bind(
        &mut self,
        entry: &Entry,
        index: usize,
        part: Part<'_>,
        count: u32,
    ) -> Result<(), String> {
        let slot = &entry.buffers[index];
        let in_buffer = part.buffer.len().saturating_sub(part.offset);
        let len = part.window.unwrap_or(in_buffer);
        let there = match slot.writable {
            true => in_buffer.min(len),
            false => in_buffer,
        };
        let least = u64::from(slot.stride).max(len);
        let needed = part
            .bytes_per_element
            .map_or(least, |bytes| bytes * u64::from(count));
        if there < needed {
            let path = &slot.path;
            return Err(format!(
                "argument '{path}' has {there} bytes and needs {needed}"
            ));
        }
        self.bound.push(Bound {
            slot: index,
            binding: slot.binding,
            buffer: part.buffer.raw().clone(),
            offset: part.offset,
            len,
            bytes_per_element: part.bytes_per_element,
        });
        Ok(())
    }

    /// The params buffer of a dispatch that computes elements `first .. first + count`.
    pub(super) fn params_for(&mut self, first: u32, count: u32) -> &[u8] {
        for (at, value) in [(self.first_at, first), (self.count_at, count)] {
            if let Some(at) = at {
                self.params[at..at + 4].copy_from_slice(&value.to_ne_bytes());
            }
        }
        &self.params
    }
}

/// A part of a buffer, in bytes.
struct Part<'a> {
    buffer: &'a GpuBuffer,
    offset: u64,
    /// Its length, where it does not reach to the buffer's end.
    window: Option<u64>,
    bytes_per_element: Option<u64>,
}

/// Collects the arguments of a pass.
struct Collected {
    entry: &'static Entry,
    count: u32,
    arguments: Arguments,
    /// The first thing that was found wrong.
    problem: Option<String>,
}

impl Collected {
    fn keep(&mut self, done: Result<(), String>) {
        if let (Err(problem), None) = (done, &self.problem) {
            self.problem = Some(problem);
        }
    }

    fn part<T: Element>(&mut self, slot: usize, values: GpuSlice<'_, T>, per_element: Option<u32>) {
        let stride = size_of::<T>() as u64;
        let part = Part {
            buffer: values.buffer,
            offset: values.first * stride,
            window: Some(values.count * stride),
            bytes_per_element: per_element.map(|values| u64::from(values) * stride),
        };
        let done = self.arguments.bind(self.entry, slot, part, self.count);
        self.keep(done);
    }
}

impl Binder<Gpu> for Collected {
    fn value<T: bytemuck::NoUninit>(&mut self, field: usize, value: &T) {
        let entry = self.entry;
        let field = &entry.params[field];
        let bytes = bytemuck::bytes_of(value);
        let done = self.arguments.put(entry, field.offset, field.size, bytes);
        self.keep(done);
    }

    fn slice<T: Element>(&mut self, slot: usize, slice: GpuSlice<'_, T>) {
        self.part(slot, slice, None);
    }

    fn out<T: Element>(&mut self, slot: usize, chunks: &GpuChunks<'_, T>) {
        self.part(slot, chunks.values, Some(1));
    }

    fn chunks<T: Element>(&mut self, slot: usize, field: usize, chunks: &GpuChunks<'_, T>) {
        if chunks.per_element == 0 {
            let path = &self.entry.buffers[slot].path;
            self.keep(Err(format!(
                "argument '{path}' must be a chunk of 1 or more"
            )));
            return;
        }
        self.value(field, &chunks.per_element);
        self.part(slot, chunks.values, Some(chunks.per_element));
    }
}

impl GpuContext {
    /// The bind group of a dispatch of elements `done .. done + elements`. Errors go to the scope around it.
    pub(super) fn bind_group(
        &self,
        layout: &wgpu::BindGroupLayout,
        params: &wgpu::Buffer,
        bound: &[Bound],
        done: u32,
        elements: u32,
    ) -> wgpu::BindGroup {
        let mut entries = vec![wgpu::BindGroupEntry {
            binding: 0,
            resource: params.as_entire_binding(),
        }];
        entries.extend(bound.iter().map(|bound| bound.binding(done, elements)));
        self.device().create_bind_group(&wgpu::BindGroupDescriptor {
            label: None,
            layout,
            entries: &entries,
        })
    }
}
