//! Host file: counts of what came of the trials, and the files of faults.

use crate::child::{MEMORY_KIB, Outcome, PROCESSOR_S};
use crate::trial::Trial;
use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;
use std::time::Duration;

/// What came of the trials of one format.
#[derive(Default)]
struct Counts {
    read: u64,
    refused: u64,
    faults: u64,
    /// The longest that one took, and its number.
    slowest: (Duration, u64),
}

/// A fault, by its kind: how often, and the first trial that had it.
struct Fault {
    times: u64,
    first: u64,
    folder: PathBuf,
}

pub(crate) struct Tally {
    keep: PathBuf,
    formats: BTreeMap<&'static str, Counts>,
    faults: BTreeMap<String, Fault>,
}

impl Tally {
    /// Nothing yet. The files of each kind of fault are kept below a folder.
    pub(crate) fn new(keep: PathBuf) -> Self {
        Self {
            keep,
            formats: BTreeMap::new(),
            faults: BTreeMap::new(),
        }
    }

    pub(crate) fn add(
        &mut self,
        number: u64,
        trial: &Trial<'_>,
        outcome: &Outcome,
        time: Duration,
    ) -> Result<(), String> {
        let format = trial.seed.format;
        let counts = self.formats.entry(format).or_default();
        counts.slowest = counts.slowest.max((time, number));
        let Some(what) = outcome.fault() else {
            match outcome {
                Outcome::Read => counts.read += 1,
                _ => counts.refused += 1,
            }
            return Ok(());
        };
        counts.faults += 1;
        let kind = format!("{format}: {}", without_numbers(&what));
        if let Some(known) = self.faults.get_mut(&kind) {
            known.times += 1;
            return Ok(());
        }
        let folder = self.keep.join(format!("{format}-{number}"));
        println!("fault in trial {number}, {format}, {}: {what}", trial.name);
        copy(&trial.seed.folder, &folder).map_err(|e| format!("{}: {e}", folder.display()))?;
        let fault = Fault {
            times: 1,
            first: number,
            folder,
        };
        self.faults.insert(kind, fault);
        Ok(())
    }

    /// How many kinds of faults there are.
    pub(crate) fn faults(&self) -> usize {
        self.faults.len()
    }

    pub(crate) fn print(&self, seed: u64, time: Duration) {
        let mut all = 0;
        println!("format       read   refused    faults   slowest trial");
        for (format, counts) in &self.formats {
            let Counts {
                read,
                refused,
                faults,
                slowest,
            } = counts;
            all += read + refused + faults;
            let (seconds, trial) = (slowest.0.as_secs_f64(), slowest.1);
            println!("{format:8} {read:8}  {refused:8}  {faults:8}  {seconds:6.2} s {trial}");
        }
        let minutes = time.as_secs_f64() / 60.0;
        println!(
            "{all} trials in {minutes:.1} minutes with seed {seed}, each command within {PROCESSOR_S} s of the processor and {} MiB",
            MEMORY_KIB >> 10
        );
        for (kind, fault) in &self.faults {
            let (times, first, folder) = (fault.times, fault.first, fault.folder.display());
            println!("{times} times, first in trial {first}: {kind}; kept: {folder}");
        }
        match self.faults.len() {
            0 => println!("no fault"),
            kinds => println!("{kinds} kinds of faults"),
        }
    }
}

/// A message but for what differs from file to file; places in sources keep their lines.
fn without_numbers(text: &str) -> String {
    let place = text.find(": ").map_or(0, |end| end + 1);
    let (place, message) = match text.starts_with("panic at") {
        true => text.split_at(place),
        false => ("", text),
    };
    let message: String = message.chars().filter(|c| !c.is_ascii_digit()).collect();
    let short: String = message.chars().take(60).collect();
    format!("{place}{short}")
}

fn copy(from: &std::path::Path, to: &std::path::Path) -> std::io::Result<()> {
    fs::create_dir_all(to)?;
    for entry in fs::read_dir(from)? {
        let entry = entry?;
        if entry.file_type()?.is_file() {
            fs::copy(entry.path(), to.join(entry.file_name()))?;
        }
    }
    Ok(())
}
