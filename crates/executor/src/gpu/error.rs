//! Host file: what can go wrong on a GPU, in words that name the adapter and the limit.

use std::time::Duration;

/// An error of the wgpu executor.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum GpuError {
    /// No adapter at all.
    #[error(
        "no GPU adapter found; install a Vulkan, Metal or Direct3D 12 driver (mesa's lavapipe is a software one), or \
         use the CPU"
    )]
    NoAdapter,
    /// None of the adapters has the name that was asked for.
    #[error("no GPU adapter is called '{wanted}'; there are: {}", seen.join(", "))]
    NoSuchAdapter {
        /// The text that was looked for.
        wanted: String,
        /// The names of all adapters.
        seen: Vec<String>,
    },
    /// The adapter would not give a device.
    #[error("{adapter} could not be opened: {reason}")]
    Open {
        /// The adapter's name.
        adapter: String,
        /// What the driver said.
        reason: String,
    },
    /// More was asked for than the adapter allows.
    #[error("{adapter} is too small: {what} needs {needed}, over its limit {limit} = {allowed}")]
    Limit {
        /// The adapter's name.
        adapter: String,
        /// What was too large.
        what: String,
        /// How much it needs, in the limit's unit.
        needed: u64,
        /// WebGPU's name of the limit.
        limit: &'static str,
        /// The adapter's value of it.
        allowed: u64,
    },
    /// An allocation failed.
    #[error("{adapter} is out of memory: {what}")]
    OutOfMemory {
        /// The adapter's name.
        adapter: String,
        /// What was being done.
        what: String,
    },
    /// The device is gone: unplugged, reset by its driver, or destroyed.
    #[error("{adapter} was lost: {reason}")]
    Lost {
        /// The adapter's name.
        adapter: String,
        /// What the driver said.
        reason: String,
    },
    /// A dispatch or a copy did not end in time.
    #[error("{adapter} did not finish {what} within {} s", after.as_secs_f32())]
    TimedOut {
        /// The adapter's name.
        adapter: String,
        /// What was being done.
        what: String,
        /// The time-out.
        after: Duration,
    },
    /// A kernel came to its end before its work did.
    #[error("{adapter} ends loops early, so {what} were not all gone through; use the CPU")]
    Unfinished {
        /// The adapter's name.
        adapter: String,
        /// What was being done.
        what: String,
    },
    /// wgpu refused a shader or a command.
    #[error("{adapter} refused {what}: {reason}")]
    Refused {
        /// The adapter's name.
        adapter: String,
        /// What was being done.
        what: String,
        /// wgpu's explanation.
        reason: String,
    },
    /// A launch whose arguments are not those of its entry.
    #[error("launch of {entry}: {problem}")]
    Argument {
        /// The entry's name.
        entry: String,
        /// Which argument, and what is wrong with it.
        problem: String,
    },
}
