//! Host file: `glimt-sh` linked alone, without std and alloc.

#![no_std]
#![no_main]

#[path = "../rt.rs"]
mod rt;

use glimt_sh as _;

/// The crate is linked; it exports nothing to call yet.
fn is_right() -> bool {
    true
}
