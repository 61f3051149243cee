//! Host file: GPU tests: an adapter or a visible skip.

use std::time::Duration;

use glimt_render_gpu::gpu::{AdapterPreference, GpuContext, GpuError, GpuOptions};

/// The machine's fastest adapter, or `None` after a line on standard error where there is none.
///
/// # Panics
///
/// Where there is none and the environment has `REQUIRE_GPU=1`; and where there is one that does not open.
#[must_use]
pub fn adapter_or_skip(test: &str) -> Option<GpuContext> {
    // A software adapter compiles a shader in its first launch, on processors that tests share.
    let options = GpuOptions {
        time_out: Duration::from_secs(240),
        ..GpuOptions::default()
    };
    adapter_or_skip_with(test, options)
}

/// As [`adapter_or_skip`], with options.
///
/// # Panics
///
/// As [`adapter_or_skip`].
#[must_use]
pub fn adapter_or_skip_with(test: &str, options: GpuOptions) -> Option<GpuContext> {
    match GpuContext::with_options(AdapterPreference::Fastest, options) {
        Ok(context) => Some(context),
        Err(GpuError::NoAdapter) => {
            let required = std::env::var("REQUIRE_GPU").is_ok_and(|value| value == "1");
            assert!(!required, "{test}: REQUIRE_GPU=1, but there is no adapter");
            crate::data::skipped(test, "no GPU adapter");
            None
        }
        Err(error) => panic!("{test}: {error}"),
    }
}
