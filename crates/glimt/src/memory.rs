//! Host file: how much memory there is, so that work which needs more is refused before a part of it is missing.
//!
//! A program that asks for more than there is may be ended without a word: by the system, by its group's limit, or by its own
//! allocator. What large work takes is known from headers and counts, and is compared first.

use crate::error::{Error, Result};
use std::fs;
use std::hint::black_box;
use std::sync::Once;

/// What to do about a scene that does not fit.
pub const FIX: &str = "free some, raise its limit, or take simpler meshes";

/// Bytes for all that is not counted.
const SPARE: u64 = 32 << 20;

/// Sees that there is memory for `what`, and some to spare.
///
/// # Errors
/// There is less; the error says how much is needed and how much there is. The caller adds what to do.
pub fn require(what: &str, bytes: u64) -> Result<()> {
    match available() {
        Some(there) if bytes.saturating_add(SPARE) > there => {
            let (need, there) = (in_words(bytes), in_words(there));
            let text = format!("{what} takes {need} of memory, and there is room for {there}");
            Err(Error::device(text))
        }
        _ => Ok(()),
    }
}

/// Bytes that can still be asked for: of the machine, of this program's group, and of its own address space. `None` where the system
/// does not say.
#[must_use]
pub fn available() -> Option<u64> {
    // Threads have heaps of their own, which begin with the first thing that each asks for.
    static HEAPS: Once = Once::new();
    HEAPS.call_once(|| {
        rayon::broadcast(|_| drop(black_box(Vec::<u8>::with_capacity(1))));
    });
    let limits = [of_machine(), of_group(), of_address_space()];
    limits.into_iter().flatten().min()
}

/// Bytes in words.
#[must_use]
pub fn in_words(bytes: u64) -> String {
    match bytes as f64 / (1u64 << 20) as f64 {
        small if small < 1024.0 => format!("{small:.1} MiB"),
        large => format!("{:.1} GiB", large / 1024.0),
    }
}

/// The number behind a key, in the lines of a file of the system.
fn number(text: &str, key: &str) -> Option<u64> {
    let line = text.lines().find_map(|line| line.strip_prefix(key))?;
    line.split_whitespace().next()?.parse().ok()
}

fn of_machine() -> Option<u64> {
    let text = fs::read_to_string("/proc/meminfo").ok()?;
    let kibibytes = number(&text, "MemAvailable:")? + number(&text, "SwapFree:").unwrap_or(0);
    Some(kibibytes << 10)
}

/// Of the control group, in either version of these; what it holds of files can be given up.
fn of_group() -> Option<u64> {
    let groups = fs::read_to_string("/proc/self/cgroup").ok()?;
    let free = |folder: &str, limit: &str, used: &str, files: &str| {
        let read = |name: &str| fs::read_to_string(format!("{folder}/{name}")).ok();
        let limit: u64 = read(limit)?.trim().parse().ok()?;
        let used: u64 = read(used)?.trim().parse().ok()?;
        let stat = read("memory.stat").unwrap_or_default();
        let files = number(&stat, files).unwrap_or(0);
        Some(limit.saturating_sub(used.saturating_sub(files)))
    };
    groups
        .lines()
        .filter_map(|line| {
            let mut parts = line.splitn(3, ':').skip(1);
            let (kinds, path) = (parts.next()?, parts.next()?.trim_end_matches('/'));
            match kinds {
                "" => {
                    let folder = format!("/sys/fs/cgroup{path}");
                    free(&folder, "memory.max", "memory.current", "inactive_file ")
                }
                _ if kinds.split(',').any(|kind| kind == "memory") => free(
                    &format!("/sys/fs/cgroup/memory{path}"),
                    "memory.limit_in_bytes",
                    "memory.usage_in_bytes",
                    "total_inactive_file ",
                ),
                _ => None,
            }
        })
        .min()
}

/// Of `ulimit -v`.
fn of_address_space() -> Option<u64> {
    let limits = fs::read_to_string("/proc/self/limits").ok()?;
    let limit = number(&limits, "Max address space")?;
    let status = fs::read_to_string("/proc/self/status").ok()?;
    Some(limit.saturating_sub(number(&status, "VmSize:")? << 10))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn more_than_any_machine_has_is_refused() {
        if available().is_none() {
            println!("skipped: this system does not say how much memory there is");
            return;
        }
        assert!(require("little", 1 << 10).is_ok());
        let error = require("the map", 1 << 60).unwrap_err().to_string();
        assert!(error.contains("the map takes 1073741824.0 GiB"), "{error}");
    }

    #[test]
    fn keys_are_found_in_lines() {
        let text =
            "MemTotal:  5 kB\nMax address space         unlimited   unlimited bytes\nMax a  7 x\n";
        assert_eq!(number(text, "MemTotal:"), Some(5));
        assert_eq!(number(text, "Max address space"), None);
        assert_eq!(number(text, "Max a  "), Some(7));
        assert_eq!(number(text, "Swap:"), None);
    }
}
