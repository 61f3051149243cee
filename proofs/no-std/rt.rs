//! Host file: what a program needs to start without the standard library. The C library is linked for its start-up code
//! and for `memcpy` and its kin; there is no allocator.

use core::ffi::{c_char, c_int};
use core::panic::PanicInfo;

#[cfg(feature = "control-alloc")]
extern crate alloc;
// Linked even where the crate under proof makes no use of it yet, or `control-std` would not reach the program.
use glam as _;

#[link(name = "c")]
unsafe extern "C" {
    fn abort() -> !;
}

/// Exits with 0 if the crate under proof computes what it should.
#[unsafe(no_mangle)]
extern "C" fn main(_argc: c_int, _argv: *const *const c_char) -> c_int {
    // The negative control: without it in the code, an unused `alloc` would prove nothing.
    #[cfg(feature = "control-alloc")]
    core::hint::black_box(alloc::vec![1_u8; core::hint::black_box(3)]);
    c_int::from(!crate::is_right())
}

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    // SAFETY: `abort` has no preconditions.
    unsafe { abort() }
}

/// `core` comes compiled for unwinding and names this function; with `panic = "abort"` nothing calls it.
#[unsafe(no_mangle)]
extern "C" fn rust_eh_personality() {}
