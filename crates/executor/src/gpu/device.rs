//! Host file: adapters, the device, and the capture of their errors.

use std::collections::HashMap;
use std::fmt;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use super::error::GpuError;
use super::kernel::KernelCache;

/// Which adapter to open.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum AdapterPreference<'a> {
    /// The fastest by type: discrete, integrated, virtual, other, software.
    #[default]
    Fastest,
    /// The fastest whose name holds this text, in any case.
    Named(&'a str),
}

/// What the executor may take.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GpuOptions {
    /// The most elements in a dispatch, however fast the adapter. Small values force small tiles in tests.
    pub max_elements: u32,
    /// The most bytes that a binding may hold, below the adapter's own limit.
    pub max_binding_bytes: u64,
    /// How long a dispatch should take. Drivers kill one after 2 s (Windows) or a few times that (others).
    pub dispatch_target: Duration,
    /// After how long a dispatch or a copy is given up.
    pub time_out: Duration,
    /// Whether to measure each dispatch on the GPU, where the adapter offers timestamps.
    pub timestamps: bool,
}

impl Default for GpuOptions {
    fn default() -> Self {
        Self {
            max_elements: u32::MAX,
            max_binding_bytes: u64::MAX,
            dispatch_target: Duration::from_millis(150),
            time_out: Duration::from_secs(60),
            timestamps: true,
        }
    }
}

/// What is known of an adapter.
#[derive(Clone, Debug, PartialEq)]
pub struct AdapterSummary {
    /// Its name, as the driver gives it.
    pub name: String,
    /// `discrete GPU`, `integrated GPU`, `virtual GPU`, `software` or `other`.
    pub kind: &'static str,
    /// The API it is reached by: `vulkan`, `metal`, `dx12`.
    pub backend: String,
    /// The driver and its version.
    pub driver: String,
    /// The largest storage binding, in bytes.
    pub max_binding_bytes: u64,
    /// The largest buffer, in bytes.
    pub max_buffer_bytes: u64,
    /// Storage buffers that one kernel may use.
    pub max_storage_buffers: u32,
    /// Whether GPU time can be measured.
    pub timestamps: bool,
}

impl AdapterSummary {
    fn of(adapter: &wgpu::Adapter) -> Self {
        let info = adapter.get_info();
        let limits = adapter.limits();
        Self {
            kind: match info.device_type {
                wgpu::DeviceType::DiscreteGpu => "discrete GPU",
                wgpu::DeviceType::IntegratedGpu => "integrated GPU",
                wgpu::DeviceType::VirtualGpu => "virtual GPU",
                wgpu::DeviceType::Cpu => "software",
                wgpu::DeviceType::Other => "other",
            },
            backend: info.backend.to_string(),
            driver: format!("{} {}", info.driver, info.driver_info)
                .trim()
                .to_owned(),
            name: info.name,
            max_binding_bytes: limits.max_storage_buffer_binding_size,
            max_buffer_bytes: limits.max_buffer_size,
            max_storage_buffers: limits.max_storage_buffers_per_shader_stage,
            timestamps: adapter.features().contains(wgpu::Features::TIMESTAMP_QUERY),
        }
    }

    /// Whether the adapter runs on the CPU, where the CPU executor is the better choice.
    ///
    /// Mesa's llvmpipe ends all loops of an invocation after 2¹⁶ turns in total, without an error: a ray of some hundred samples,
    /// each with its way through the tree, is cut short there.
    #[must_use]
    pub fn is_software(&self) -> bool {
        self.kind == "software"
    }

    /// Smaller is faster.
    fn rank(&self) -> usize {
        [
            "discrete GPU",
            "integrated GPU",
            "virtual GPU",
            "other",
            "software",
        ]
        .iter()
        .position(|&kind| kind == self.kind)
        .unwrap_or(usize::MAX)
    }
}

impl fmt::Display for AdapterSummary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} ({}, {})", self.name, self.kind, self.backend)
    }
}

/// What finds adapters. Kernels show nothing, so it knows no display.
fn instance() -> wgpu::Instance {
    let descriptor = wgpu::InstanceDescriptor::new_without_display_handle_from_env();
    #[cfg(all(unix, not(target_vendor = "apple")))]
    if let Some(vulkan) = vulkan_without_display(&descriptor) {
        return vulkan;
    }
    wgpu::Instance::new(descriptor)
}

/// Vulkan without the extensions of window systems. wgpu enables all that there are, and where Wayland's is enabled, Mesa looks for a
/// display: libwayland then prints lines of its own on a machine that has none. `None` where Vulkan is absent or not wanted.
#[cfg(all(unix, not(target_vendor = "apple")))]
#[allow(
    unsafe_code,
    reason = "wgpu offers no safe way to leave extensions out"
)]
fn vulkan_without_display(descriptor: &wgpu::InstanceDescriptor) -> Option<wgpu::Instance> {
    use wgpu::hal;
    if !descriptor.backends.contains(wgpu::Backends::VULKAN) {
        return None;
    }
    let hal_descriptor = hal::InstanceDescriptor {
        name: "glimt",
        flags: descriptor.flags,
        memory_budget_thresholds: descriptor.memory_budget_thresholds,
        backend_options: descriptor.backend_options.clone(),
        telemetry: None,
        display: None,
    };
    let hide_displays = |arguments: hal::vulkan::CreateInstanceCallbackArgs<'_, '_, '_>| {
        // Swapchains, which wgpu-hal enables on each device, depend on the common extension.
        arguments
            .extensions
            .retain(|name| *name == c"VK_KHR_surface" || !name.to_bytes().ends_with(b"_surface"));
    };
    // SAFETY: wgpu-hal uses such an extension in one place, where it makes a surface of a window. There it first looks in this list
    // whether the extension is enabled. No surface is made of this instance, nor does anyone else hold it.
    unsafe {
        let callback = Box::new(hide_displays);
        let instance =
            hal::vulkan::Instance::init_with_callback(&hal_descriptor, Some(callback)).ok()?;
        Some(wgpu::Instance::from_hal::<hal::api::Vulkan>(instance))
    }
}

fn adapters() -> Vec<(AdapterSummary, wgpu::Adapter)> {
    let instance = instance();
    let mut found: Vec<_> = pollster::block_on(instance.enumerate_adapters(wgpu::Backends::all()))
        .into_iter()
        .filter(|adapter| {
            let flags = adapter.get_downlevel_capabilities().flags;
            flags.contains(wgpu::DownlevelFlags::COMPUTE_SHADERS)
        })
        .map(|adapter| (AdapterSummary::of(&adapter), adapter))
        .collect();
    found.sort_by_key(|(summary, _)| summary.rank());
    found
}

/// All adapters that can run the kernels, the fastest first.
#[must_use]
pub fn enumerate() -> Vec<AdapterSummary> {
    adapters().into_iter().map(|(summary, _)| summary).collect()
}

/// What the callbacks of the device have heard.
#[derive(Debug, Default)]
struct Heard {
    lost: Option<String>,
    uncaptured: Option<wgpu::Error>,
}

/// An open GPU: its device and queue, and the pipelines compiled so far. It can be shared between threads.
#[derive(Debug)]
pub struct GpuContext {
    device: wgpu::Device,
    queue: wgpu::Queue,
    limits: wgpu::Limits,
    pub(super) options: GpuOptions,
    pub(super) kernels: KernelCache,
    has_timestamps: bool,
    summary: AdapterSummary,
    heard: Arc<Mutex<Heard>>,
    waits: AtomicU64,
}

impl GpuContext {
    /// Opens an adapter with its own limits, and timestamps where it offers them.
    ///
    /// # Errors
    ///
    /// [`GpuError::NoAdapter`], [`GpuError::NoSuchAdapter`], or [`GpuError::Open`] when the driver refuses.
    pub fn new(preference: AdapterPreference<'_>) -> Result<Self, GpuError> {
        Self::with_options(preference, GpuOptions::default())
    }

    /// As [`Self::new`], with options.
    ///
    /// # Errors
    ///
    /// As [`Self::new`].
    pub fn with_options(
        preference: AdapterPreference<'_>,
        options: GpuOptions,
    ) -> Result<Self, GpuError> {
        let mut found = adapters();
        if found.is_empty() {
            return Err(GpuError::NoAdapter);
        }
        let chosen = match preference {
            AdapterPreference::Fastest => 0,
            AdapterPreference::Named(wanted) => {
                let holds = |name: &str| name.to_lowercase().contains(&wanted.to_lowercase());
                found
                    .iter()
                    .position(|(summary, _)| holds(&summary.name))
                    .ok_or_else(|| GpuError::NoSuchAdapter {
                        wanted: wanted.to_owned(),
                        seen: found
                            .iter()
                            .map(|(summary, _)| summary.name.clone())
                            .collect(),
                    })?
            }
        };
        let (summary, adapter) = found.swap_remove(chosen);
        Self::open(&adapter, summary, options)
    }

    fn open(
        adapter: &wgpu::Adapter,
        summary: AdapterSummary,
        options: GpuOptions,
    ) -> Result<Self, GpuError> {
        let has_timestamps = options.timestamps && summary.timestamps;
        // Not `Limits::default()`: it allows 8 storage buffers and 128 MiB, however large the adapter.
        let limits = adapter.limits();
        let request = adapter.request_device(&wgpu::DeviceDescriptor {
            label: Some("glimt"),
            required_features: if has_timestamps {
                wgpu::Features::TIMESTAMP_QUERY
            } else {
                wgpu::Features::empty()
            },
            required_limits: limits.clone(),
            ..Default::default()
        });
        let (device, queue) = pollster::block_on(request).map_err(|error| GpuError::Open {
            adapter: summary.to_string(),
            reason: error.to_string(),
        })?;

        // Without handlers wgpu panics.
        let heard = Arc::new(Mutex::new(Heard::default()));
        let listener = Arc::clone(&heard);
        device.on_uncaptured_error(Arc::new(move |error| {
            listener
                .lock()
                .unwrap_or_else(PoisonError::into_inner)
                .uncaptured
                .get_or_insert(error);
        }));
        let listener = Arc::clone(&heard);
        device.set_device_lost_callback(move |reason, message| {
            let text = format!("{reason:?} {message}").trim().to_owned();
            listener
                .lock()
                .unwrap_or_else(PoisonError::into_inner)
                .lost
                .get_or_insert(text);
        });
        Ok(Self {
            device,
            queue,
            limits,
            options,
            kernels: Mutex::new(HashMap::new()),
            has_timestamps,
            summary,
            heard,
            waits: AtomicU64::new(0),
        })
    }

    /// The adapter in use.
    #[must_use]
    pub fn adapter(&self) -> &AdapterSummary {
        &self.summary
    }

    /// The most bytes that one binding may hold here.
    #[must_use]
    pub fn max_binding_bytes(&self) -> u64 {
        self.limits
            .max_storage_buffer_binding_size
            .min(self.options.max_binding_bytes)
    }

    /// What wgpu knows the device by, for resources of one's own.
    #[must_use]
    pub fn device(&self) -> &wgpu::Device {
        &self.device
    }

    /// Its queue.
    #[must_use]
    pub fn queue(&self) -> &wgpu::Queue {
        &self.queue
    }

    /// What the adapter allows.
    #[must_use]
    pub fn limits(&self) -> &wgpu::Limits {
        &self.limits
    }

    /// Whether the GPU's own time can be measured here, and is to be.
    #[must_use]
    pub fn has_timestamps(&self) -> bool {
        self.has_timestamps
    }

    /// How often anyone has waited for this GPU, or asked how far it is, since it was opened: every way back from it counts.
    #[must_use]
    pub fn waits(&self) -> u64 {
        self.waits.load(Ordering::Relaxed)
    }

    /// Gives the device up, as if it were lost: all later calls fail with [`GpuError::Lost`].
    pub fn destroy(&self) {
        self.device.destroy();
        self.waits.fetch_add(1, Ordering::Relaxed);
        // wgpu tells of the loss at the next poll, when the queue is empty.
        let _ = self.device.poll(wgpu::PollType::wait_indefinitely());
    }

    /// The error of something that needs more than a limit allows. `limit` is WebGPU's name of it.
    #[must_use]
    pub fn limit_error(
        &self,
        what: String,
        needed: u64,
        limit: &'static str,
        allowed: u64,
    ) -> GpuError {
        GpuError::Limit {
            adapter: self.summary.to_string(),
            what,
            needed,
            limit,
            allowed,
        }
    }

    /// Runs `f`, and turns what wgpu finds wrong with it into an error. `what` names the work in that error.
    ///
    /// # Errors
    ///
    /// [`GpuError::Refused`], [`GpuError::OutOfMemory`], [`GpuError::Lost`].
    pub fn guarded<T>(
        &self,
        what: impl Fn() -> String,
        f: impl FnOnce() -> T,
    ) -> Result<T, GpuError> {
        let filters = [
            wgpu::ErrorFilter::OutOfMemory,
            wgpu::ErrorFilter::Internal,
            wgpu::ErrorFilter::Validation,
        ];
        let scopes = filters.map(|filter| self.device.push_error_scope(filter));
        let value = f();
        // Scopes end in the reverse order. All must be popped, even when the first has an error.
        let mut error = None;
        for scope in scopes.into_iter().rev() {
            error = pollster::block_on(scope.pop()).or(error);
        }
        self.check(&what)?;
        match error {
            Some(error) => Err(self.translate(&what, error)),
            None => Ok(value),
        }
    }

    /// The error, if any, that came by a callback since the last check. A lost device stays lost.
    pub(super) fn check(&self, what: &impl Fn() -> String) -> Result<(), GpuError> {
        let mut heard = self.heard.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(reason) = &heard.lost {
            return Err(GpuError::Lost {
                adapter: self.summary.to_string(),
                reason: reason.clone(),
            });
        }
        match heard.uncaptured.take() {
            Some(error) => Err(self.translate(what, error)),
            None => Ok(()),
        }
    }

    fn translate(&self, what: &impl Fn() -> String, error: wgpu::Error) -> GpuError {
        let (adapter, what) = (self.summary.to_string(), what());
        match error {
            wgpu::Error::OutOfMemory { .. } => GpuError::OutOfMemory { adapter, what },
            wgpu::Error::Validation { description, .. }
            | wgpu::Error::Internal { description, .. } => GpuError::Refused {
                adapter,
                what,
                reason: description,
            },
        }
    }

    /// Blocks until all that was handed over is done, or the time is out.
    ///
    /// # Errors
    ///
    /// [`GpuError::TimedOut`], [`GpuError::Lost`].
    pub fn finish(&self) -> Result<(), GpuError> {
        self.poll_as(
            wgpu::PollType::Wait {
                submission_index: None,
                timeout: Some(self.options.time_out),
            },
            &|| "what was handed over".to_owned(),
        )
    }

    /// Blocks until `submission` is done, or the time is out.
    pub(super) fn wait(
        &self,
        submission: wgpu::SubmissionIndex,
        what: impl Fn() -> String,
    ) -> Result<(), GpuError> {
        self.poll_as(
            wgpu::PollType::Wait {
                submission_index: Some(submission),
                timeout: Some(self.options.time_out),
            },
            &what,
        )
    }

    /// Hears of what is done, without waiting.
    pub(super) fn poll(&self, what: &impl Fn() -> String) -> Result<(), GpuError> {
        self.poll_as(wgpu::PollType::Poll, what)
    }

    fn poll_as(&self, poll: wgpu::PollType, what: &impl Fn() -> String) -> Result<(), GpuError> {
        self.waits.fetch_add(1, Ordering::Relaxed);
        // `Device::poll` panics when the driver reports a lost device.
        let polled = catch_unwind(AssertUnwindSafe(|| self.device.poll(poll)));
        self.check(what)?;
        match polled {
            Ok(Ok(_)) => Ok(()),
            Ok(Err(wgpu::PollError::Timeout)) => Err(self.timed_out(what)),
            Ok(Err(error)) => Err(GpuError::Refused {
                adapter: self.summary.to_string(),
                what: what(),
                reason: error.to_string(),
            }),
            Err(_) => Err(GpuError::Lost {
                adapter: self.summary.to_string(),
                reason: format!("the driver failed during {}", what()),
            }),
        }
    }

    pub(super) fn timed_out(&self, what: &impl Fn() -> String) -> GpuError {
        GpuError::TimedOut {
            adapter: self.summary.to_string(),
            what: what(),
            after: self.options.time_out,
        }
    }
}
