//! Host file: the parent's side of a child that reads files within limits of memory and time.

use crate::corpus::Seed;
use crate::serve::ANSWER;
use std::fs::{self, File};
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{self, ChildStdin, Command, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::{Duration, Instant};

/// The address space of a child, in KiB: 2 GiB.
pub(crate) const MEMORY_KIB: u64 = 2 << 20;

/// Seconds of the processor's time that a command may take. Other work on the machine does not count.
pub(crate) const PROCESSOR_S: f64 = 10.0;

/// How long a command may take, with other work beside it: one that waits for ever takes no time of the processor.
const WAIT: Duration = Duration::from_secs(60);

/// Trials that one child serves, so that what allocators keep does not add up.
const TRIALS: u32 = 4000;

/// What came of a trial.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Outcome {
    /// All was read.
    Read,
    /// Something was refused with an error, which is this.
    Refused(String),
    /// A fault: a panic, where it was, and what it said.
    Panicked(String),
    /// A fault: the process died of something else.
    Died(String),
    /// A fault: more memory was asked for than there is.
    OutOfMemory(String),
    /// A fault: the time was over.
    TimedOut,
}

impl Outcome {
    /// The kind of fault, in words; `None` where there is none.
    pub(crate) fn fault(&self) -> Option<String> {
        match self {
            Self::Read | Self::Refused(_) => None,
            Self::Panicked(what) => Some(format!("panic at {what}")),
            Self::Died(how) => Some(format!("died: {how}")),
            Self::OutOfMemory(what) => Some(format!("memory: {what}")),
            Self::TimedOut => Some(format!("took more than {PROCESSOR_S} s")),
        }
    }
}

struct Process {
    process: process::Child,
    stdin: ChildStdin,
    answers: Receiver<String>,
    served: u32,
}

/// A child, which is replaced when it dies.
pub(crate) struct Child {
    errors: PathBuf,
    now: Process,
}

impl Child {
    pub(crate) fn start(work: &Path) -> Result<Self, String> {
        let errors = work.join("stderr.txt");
        let now = spawn(&errors)?;
        Ok(Self { errors, now })
    }

    /// Has the files of a seed's folder read as they are now, by all its commands until one has a fault. An error of one counts.
    pub(crate) fn ask(&mut self, seed: &Seed) -> Result<Outcome, String> {
        if self.now.served >= TRIALS {
            self.replace()?;
        }
        self.now.served += 1;
        let mut outcome = Outcome::Read;
        for line in seed.lines() {
            let one = self.command(&line);
            if one.fault().is_some() {
                self.replace()?;
                return Ok(one);
            }
            if outcome == Outcome::Read {
                outcome = one;
            }
        }
        Ok(outcome)
    }

    fn command(&mut self, line: &str) -> Outcome {
        let sent = writeln!(self.now.stdin, "{line}");
        // Where the child is gone, the channel says so.
        drop(sent.and_then(|()| self.now.stdin.flush()));
        let (began, used) = (Instant::now(), self.processor_s());
        loop {
            let answer = self.now.answers.recv_timeout(Duration::from_secs(1));
            return match answer.as_deref().map(|line| line.split_once(' ')) {
                Ok(Some(("panic", what))) => Outcome::Panicked(what.to_owned()),
                Ok(Some(("refused", why))) => Outcome::Refused(why.to_owned()),
                Ok(_) => Outcome::Read,
                Err(RecvTimeoutError::Disconnected) => self.epitaph(),
                Err(RecvTimeoutError::Timeout) => {
                    if began.elapsed() < WAIT && self.processor_s() - used < PROCESSOR_S {
                        continue;
                    }
                    Outcome::TimedOut
                }
            };
        }
    }

    /// The processor's time that the child has taken, on all threads; 0 where the system does not say.
    fn processor_s(&self) -> f64 {
        let file = format!("/proc/{}/stat", self.now.process.id());
        let text = fs::read_to_string(file).unwrap_or_default();
        // The program's name, in brackets, may hold spaces. Linux counts in hundredths of a second.
        let rest = text.rsplit_once(')').map_or("", |(_, rest)| rest);
        let times = rest.split_whitespace().skip(11).take(2);
        times.filter_map(|t| t.parse::<f64>().ok()).sum::<f64>() / 100.0
    }

    /// What a child that is gone died of.
    fn epitaph(&mut self) -> Outcome {
        let status = match self.now.process.wait() {
            Ok(status) => status.to_string(),
            Err(error) => error.to_string(),
        };
        let said = fs::read(&self.errors).unwrap_or_default();
        let said = String::from_utf8_lossy(&said);
        match said.lines().find(|l| l.contains("memory allocation of")) {
            Some(line) => Outcome::OutOfMemory(line.to_owned()),
            None => {
                let last = said.lines().last().unwrap_or_default();
                Outcome::Died(format!("{status} {last}").trim().to_owned())
            }
        }
    }

    fn replace(&mut self) -> Result<(), String> {
        end(&mut self.now.process);
        self.now = spawn(&self.errors)?;
        Ok(())
    }
}

impl Drop for Child {
    fn drop(&mut self) {
        end(&mut self.now.process);
    }
}

fn end(process: &mut process::Child) {
    let _ = process.kill();
    let _ = process.wait();
}

fn spawn(errors: &Path) -> Result<Process, String> {
    let failed = |e: std::io::Error| format!("a child does not start: {e}");
    let own = std::env::current_exe().map_err(failed)?;
    let limited = format!("ulimit -v {MEMORY_KIB} && exec \"$0\" --serve");
    let mut process = Command::new("sh")
        .args(["-c", &limited])
        .arg(own)
        // Threads take address space for their stacks and heaps.
        .env("RAYON_NUM_THREADS", "2")
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(File::create(errors).map_err(failed)?)
        .spawn()
        .map_err(failed)?;
    let (Some(stdin), Some(stdout)) = (process.stdin.take(), process.stdout.take()) else {
        return Err("a child has no pipes".to_owned());
    };
    let (send, answers) = channel();
    std::thread::spawn(move || {
        for line in BufReader::new(stdout).split(b'\n') {
            let Ok(line) = line else { break };
            let line = String::from_utf8_lossy(&line);
            if let Some(answer) = line.strip_prefix(ANSWER)
                && send.send(answer.to_owned()).is_err()
            {
                break;
            }
        }
    });
    Ok(Process {
        process,
        stdin,
        answers,
        served: 0,
    })
}
