//! Host file: running an entry over many elements in dispatches that fit the adapter and stay short.

use std::collections::VecDeque;
use std::ops::{AddAssign, Range};
use std::sync::{Arc, PoisonError};
use std::time::{Duration, Instant};

use super::arguments::{Arg, Arguments};
use super::device::GpuContext;
use super::error::GpuError;
use super::kernel::Kernel;
use super::memory::Gpu;
use super::timing::Stopwatch;
use crate::entry::{Entry, ParamsSpace};
use crate::pass::{Executor, Pass};

/// How a launch went.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LaunchReport {
    /// Dispatches that it was cut into.
    pub dispatches: u32,
    /// Time until the last was done, as the host saw it.
    pub wall: Duration,
    /// Time the GPU spent in them; `None` where the adapter offers no timestamps.
    pub gpu: Option<Duration>,
}

impl AddAssign for LaunchReport {
    /// Adds a launch that came after.
    fn add_assign(&mut self, later: Self) {
        self.dispatches += later.dispatches;
        self.wall += later.wall;
        self.gpu = match (self.gpu, later.gpu) {
            (Some(a), Some(b)) => Some(a + b),
            (a, b) => a.or(b),
        };
    }
}

/// Elements in the first dispatch of a kernel of unknown pace: short on the slowest adapter, cheap on the fastest.
const FIRST_DISPATCH: u32 = 4096;
/// How much larger a dispatch may be than the one before: a few pixels say little about the rest.
const GROWTH: f64 = 4.0;
/// Dispatches in flight: one runs while the next is encoded.
const IN_FLIGHT: usize = 2;

/// How fast a kernel ran last, from which the size of its next dispatch follows.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pace {
    seconds_per_element: f64,
    elements: u32,
}

/// A dispatch on its way.
struct Flight {
    submission: wgpu::SubmissionIndex,
    submitted: Instant,
    elements: u32,
    stopwatch: Option<Stopwatch>,
}

impl GpuContext {
    /// Computes elements `first .. first + count` of `entry`. Element `first + i` fills the i-th value of `out` and
    /// the i-th chunk of each chunked argument.
    ///
    /// It is cut into as many dispatches as bindings, grid and the dispatch time of the options require, and returns
    /// when all are done.
    ///
    /// # Errors
    ///
    /// [`GpuError::Argument`] when the arguments are not the entry's, [`GpuError::Limit`] when a slice that is read
    /// whole is larger than a binding may be, and those of [`Self::prepare`]; [`GpuError::TimedOut`],
    /// [`GpuError::OutOfMemory`], [`GpuError::Lost`].
    pub fn launch(
        &self,
        entry: &Entry,
        args: &[(&str, Arg<'_>)],
        first: u32,
        count: u32,
    ) -> Result<LaunchReport, GpuError> {
        let arguments = Arguments::by_path(entry, args, count)?;
        self.launch_bound(entry, arguments, first, count, &|_| ())
    }

    /// Launches entries whose arguments are checked. `progress` hears, after each dispatch, how many elements are done.
    fn launch_bound(
        &self,
        entry: &Entry,
        mut arguments: Arguments,
        first: u32,
        count: u32,
        progress: &dyn Fn(u32),
    ) -> Result<LaunchReport, GpuError> {
        if first.checked_add(count).is_none() {
            let problem = format!("elements {first} and {count} more are beyond u32");
            return Err(GpuError::Argument {
                entry: entry.name.clone().into_owned(),
                problem,
            });
        }
        let kernel = self.kernel(entry)?;
        let tiles = self.tiles(entry, &arguments)?;
        let params = self.params_buffer(entry)?;

        let started = Instant::now();
        let mut report = LaunchReport {
            gpu: self.has_timestamps().then_some(Duration::ZERO),
            ..Default::default()
        };
        let mut flights = VecDeque::new();
        let mut last_done = started;
        let mut stopwatches = Vec::new();
        let (mut done, mut landed) = (0, 0);
        while done < count {
            let pace = *kernel.pace.lock().unwrap_or_else(PoisonError::into_inner);
            let elements = tiles
                .next(pace, self.options.dispatch_target)
                .min(count - done);
            self.write_params(entry, &params, arguments.params_for(first + done, elements))?;
            let stopwatch = match stopwatches.pop() {
                None if self.has_timestamps() => Some(Stopwatch::new(self, 2)?),
                used => used,
            };
            let flight = self.dispatch(&kernel, &arguments, &params, done, elements, stopwatch)?;
            flights.push_back(flight);
            report.dispatches += 1;
            done += elements;
            while flights.len() >= IN_FLIGHT || (done == count && !flights.is_empty()) {
                let Some(flight) = flights.pop_front() else {
                    break;
                };
                landed += flight.elements;
                stopwatches.extend(self.land(&kernel, flight, &mut last_done, &mut report)?);
                progress(landed);
            }
        }
        report.wall = started.elapsed();
        Ok(report)
    }

    /// A buffer for an entry's plain arguments.
    pub(super) fn params_buffer(&self, entry: &Entry) -> Result<wgpu::Buffer, GpuError> {
        let space = match entry.params_space {
            ParamsSpace::Uniform => wgpu::BufferUsages::UNIFORM,
            ParamsSpace::Storage => wgpu::BufferUsages::STORAGE,
        };
        let descriptor = wgpu::BufferDescriptor {
            label: Some(&entry.name),
            size: u64::from(entry.params_size.max(4)).next_multiple_of(16),
            usage: space | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        };
        self.guarded(
            || format!("the params of {}", entry.name),
            || self.device().create_buffer(&descriptor),
        )
    }

    /// Puts an entry's plain arguments into their buffer, after the launches so far.
    pub(super) fn write_params(
        &self,
        entry: &Entry,
        buffer: &wgpu::Buffer,
        bytes: &[u8],
    ) -> Result<(), GpuError> {
        self.guarded(
            || format!("the params of {}", entry.name),
            || self.queue().write_buffer(buffer, 0, bytes),
        )
    }

    /// Forgets how fast `entry` ran, where its next elements may be far slower: its dispatches begin small again.
    ///
    /// # Errors
    ///
    /// As [`Self::prepare`].
    pub fn forget_pace(&self, entry: &Entry) -> Result<(), GpuError> {
        let kernel = self.kernel(entry)?;
        *kernel.pace.lock().unwrap_or_else(PoisonError::into_inner) = None;
        Ok(())
    }

    /// What bounds the dispatches of a launch.
    fn tiles(&self, entry: &Entry, arguments: &Arguments) -> Result<Tiles, GpuError> {
        let groups = u64::from(self.limits().max_compute_workgroups_per_dimension);
        // The linear index is computed in 32 bits.
        let grid = (groups * groups * u64::from(entry.workgroup_size)).min(1 << 31);
        let mut largest = grid.min(self.options.max_elements.max(1).into());
        let mut granule = 1;
        let binding = self.max_binding_bytes();
        let alignment = u64::from(self.limits().min_storage_buffer_offset_alignment);
        for bound in &arguments.bound {
            bound.check_alignment(entry, alignment)?;
            let path = &entry.buffers[bound.slot].path;
            let what = || format!("argument '{path}' of {}", entry.name);
            let limit = "max_storage_buffer_binding_size";
            match bound.bytes_per_element {
                None if bound.len > binding => {
                    return Err(self.limit_error(what(), bound.len, limit, binding));
                }
                None => {}
                Some(bytes) => {
                    largest = largest.min(binding / bytes.max(1));
                    // Each dispatch binds its own part, which must begin at a multiple of the alignment. Both are
                    // powers of two times something small, so the least common multiple is small, too.
                    granule = lcm(granule, alignment / gcd(alignment, bytes));
                }
            }
        }
        let whole = largest / granule * granule;
        if whole == 0 {
            let what = format!("a tile of {granule} elements of {}", entry.name);
            return Err(self.limit_error(what, granule, "elements per dispatch", largest));
        }
        let group = lcm(granule, entry.workgroup_size.into());
        Ok(Tiles {
            largest: whole,
            granule: if group <= whole { group } else { granule },
        })
    }

    /// Submits elements `done .. done + elements` of a launch.
    fn dispatch(
        &self,
        kernel: &Kernel,
        arguments: &Arguments,
        params: &wgpu::Buffer,
        done: u32,
        elements: u32,
        stopwatch: Option<Stopwatch>,
    ) -> Result<Flight, GpuError> {
        let entry = &kernel.entry;
        let [columns, rows] = self.grid(entry, elements);
        let submitted = Instant::now();
        let submission = self.guarded(
            || format!("{elements} elements of {}", entry.name),
            || {
                let bind_group =
                    self.bind_group(&kernel.layout, params, &arguments.bound, done, elements);
                let mut encoder = self
                    .device()
                    .create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
                {
                    let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor {
                        label: Some(&entry.name),
                        timestamp_writes: stopwatch.as_ref().map(Stopwatch::writes),
                    });
                    pass.set_pipeline(&kernel.pipeline);
                    pass.set_bind_group(0, &bind_group, &[]);
                    pass.dispatch_workgroups(columns, rows, 1);
                }
                if let Some(stopwatch) = &stopwatch {
                    stopwatch.resolve(&mut encoder);
                }
                self.queue().submit([encoder.finish()])
            },
        )?;
        Ok(Flight {
            submission,
            submitted,
            elements,
            stopwatch,
        })
    }

    /// Waits for a dispatch and learns the kernel's pace from it. Gives its stopwatch back.
    fn land(
        &self,
        kernel: &Arc<Kernel>,
        flight: Flight,
        last_done: &mut Instant,
        report: &mut LaunchReport,
    ) -> Result<Option<Stopwatch>, GpuError> {
        let Flight {
            submission,
            submitted,
            elements,
            stopwatch,
        } = flight;
        self.wait(submission.clone(), || {
            format!("{elements} elements of {}", kernel.entry.name)
        })?;
        let now = Instant::now();
        // It began when it was submitted or when the one before it ended, whichever was later.
        let wall = now - submitted.max(*last_done);
        *last_done = now;
        if let (Some(stopwatch), Some(total)) = (&stopwatch, &mut report.gpu) {
            *total += stopwatch.read(self, submission)?.iter().sum::<Duration>();
        }
        let pace = Pace {
            seconds_per_element: wall.as_secs_f64() / f64::from(elements),
            elements,
        };
        *kernel.pace.lock().unwrap_or_else(PoisonError::into_inner) = Some(pace);
        Ok(stopwatch)
    }
}

/// Runs passes at once: each is cut into dispatches that stay short, and is done when the call returns.
pub struct Direct<'a> {
    context: &'a GpuContext,
    progress: Option<&'a dyn Fn(u64)>,
    /// Elements of the passes so far.
    done: u64,
    report: LaunchReport,
}

impl<'a> Direct<'a> {
    /// On an open GPU.
    #[must_use]
    pub fn new(context: &'a GpuContext) -> Self {
        Self {
            context,
            progress: None,
            done: 0,
            report: LaunchReport::default(),
        }
    }

    /// `progress` hears, after each dispatch, how many elements are done, of all passes together.
    #[must_use]
    pub fn with_progress(context: &'a GpuContext, progress: &'a dyn Fn(u64)) -> Self {
        Self {
            progress: Some(progress),
            ..Self::new(context)
        }
    }

    /// How the passes went since this was asked last.
    pub fn take_report(&mut self) -> LaunchReport {
        std::mem::take(&mut self.report)
    }
}

impl Executor for Direct<'_> {
    type Memory = Gpu;
    type Error = GpuError;

    fn run<P: Pass<Memory = Gpu>>(&mut self, pass: P, range: Range<u32>) -> Result<(), GpuError> {
        let count = range.len() as u32;
        let arguments = Arguments::of_pass(&pass, count)?;
        let before = self.done;
        let progress = |done: u32| {
            if let Some(progress) = self.progress {
                progress(before + u64::from(done));
            }
        };
        self.report +=
            self.context
                .launch_bound(P::entry(), arguments, range.start, count, &progress)?;
        self.done = before + u64::from(count);
        Ok(())
    }
}

/// The sizes that dispatches may have.
struct Tiles {
    /// The most elements; a multiple of the parts' alignment.
    largest: u64,
    /// Sizes are multiples of this, so that the next part begins aligned.
    granule: u64,
}

impl Tiles {
    /// The next size, so that it takes about `target`.
    fn next(&self, pace: Option<Pace>, target: Duration) -> u32 {
        let first = f64::from(FIRST_DISPATCH);
        let wanted = pace.map_or(first, |pace| {
            let in_time = target.as_secs_f64() / pace.seconds_per_element.max(1e-15);
            in_time.min((f64::from(pace.elements) * GROWTH).max(first))
        });
        let wanted = wanted.min(self.largest as f64) as u64;
        (wanted / self.granule * self.granule).clamp(self.granule, self.largest) as u32
    }
}

fn gcd(a: u64, b: u64) -> u64 {
    if b == 0 { a } else { gcd(b, a % b) }
}

fn lcm(a: u64, b: u64) -> u64 {
    a / gcd(a, b) * b
}
