//! Host file: a folder that frames appear in: which are there, which are whole, and which of them to take.

use crate::error::Error;
use crate::input::frames::FrameFiles;
use std::collections::{BTreeMap, BTreeSet};
use std::time::{Duration, Instant, SystemTime};

/// Time between two looks at the folder.
pub const POLL: Duration = Duration::from_millis(50);

/// The most frames that wait whole before the older ones are dropped.
pub const QUEUE: usize = 2;

/// A file that could not be read is tried again after this time even if it does not seem to have changed: clocks of file
/// systems are coarse, and some programs write into files that have their size already.
const RETRY: Duration = Duration::from_millis(500);

/// The largest gap in the numbers of which each frame is remembered as missing.
const LARGEST_GAP: u32 = 10_000;

/// A file as it was seen last.
#[derive(Debug)]
struct Seen {
    length: u64,
    modified: Option<SystemTime>,
    /// When it was found to be there, or changed.
    changed: Instant,
    /// Looks in which it was the same.
    looks: u32,
    /// The last attempt to read it, which failed.
    failed: Option<(Instant, Error)>,
}

impl Seen {
    /// Not changed between two looks, and nothing says that it cannot be read.
    fn is_whole(&self) -> bool {
        self.looks >= 2
            && self.length > 0
            && self
                .failed
                .as_ref()
                .is_none_or(|(at, _)| at.elapsed() >= RETRY)
    }
}

/// Watches the files of a sequence.
#[derive(Debug)]
pub struct Watcher {
    files: FrameFiles,
    began: SystemTime,
    /// The lowest number that is wanted; without one, the first look decides.
    next: Option<u32>,
    /// Whether numbers from `next` on that are not there are missing: not before the first frame of a run without a range.
    counted: bool,
    seen: BTreeMap<u32, Seen>,
    lowest: Option<u32>,
    highest: Option<u32>,
    looked: Option<Instant>,
    changed: Instant,
    missing: BTreeSet<u32>,
    late: Vec<u32>,
}

impl Watcher {
    /// Watches for frames from `first` on, or else from the newest on that is there at the first look.
    pub fn new(files: FrameFiles, first: Option<u32>) -> Self {
        Self {
            files,
            began: SystemTime::now(),
            next: first,
            counted: first.is_some(),
            seen: BTreeMap::new(),
            lowest: None,
            highest: None,
            looked: None,
            changed: Instant::now(),
            missing: BTreeSet::new(),
            late: Vec::new(),
        }
    }

    /// The files.
    pub fn files(&self) -> &FrameFiles {
        &self.files
    }

    /// Looks at the folder, if the last look is not too recent. A folder that is not there is an empty one.
    pub fn look(&mut self) {
        if self.looked.is_some_and(|at| at.elapsed() < POLL) {
            return;
        }
        let first_look = self.looked.is_none();
        self.looked = Some(Instant::now());
        let listed = self.files.listed().unwrap_or_default();
        self.highest = listed.last().copied();
        if self.lowest.is_none() {
            self.lowest = listed.first().copied();
        }
        if first_look && self.next.is_none() {
            self.next = Some(self.highest.unwrap_or(0));
        }
        let next = self.next.unwrap_or(0);
        self.seen.retain(|n, _| listed.binary_search(n).is_ok());
        for number in listed {
            if number >= next {
                self.look_at(number);
            } else if self.missing.remove(&number) {
                self.late.push(number);
            }
        }
    }

    fn look_at(&mut self, number: u32) {
        // What is whole is not looked at again, unless it turned out that it is not.
        let known = self.seen.get_mut(&number);
        if known
            .as_ref()
            .is_some_and(|seen| seen.looks >= 2 && seen.failed.is_none())
        {
            return;
        }
        let Ok(data) = std::fs::metadata(self.files.path(number)) else {
            return;
        };
        let (length, modified) = (data.len(), data.modified().ok());
        match known {
            Some(seen) if (seen.length, seen.modified) == (length, modified) => seen.looks += 1,
            _ => {
                let changed = Instant::now();
                self.changed = changed;
                let seen = Seen {
                    length,
                    modified,
                    changed,
                    looks: 1,
                    failed: None,
                };
                self.seen.insert(number, seen);
            }
        }
    }

    /// Whether a frame is there and seems to be whole.
    pub fn is_whole(&self, number: u32) -> bool {
        self.seen.get(&number).is_some_and(Seen::is_whole)
    }

    /// Whether a frame is there, whole or not.
    pub fn is_there(&self, number: u32) -> bool {
        self.seen.contains_key(&number)
    }

    /// The newest frame before this one that seems to be whole.
    pub fn whole_before(&self, number: u32) -> Option<u32> {
        let mut before = self.seen.range(..number).rev();
        before.find(|(_, seen)| seen.is_whole()).map(|(n, _)| *n)
    }

    /// The frames that wait, in order, up to `last`. One that has not been whole for `patience` is given up.
    pub fn waiting(&self, last: Option<u32>, patience: Duration) -> Vec<Waiting> {
        let wanted = self.seen.range(..=last.unwrap_or(u32::MAX));
        let waiting = |(&frame, seen): (&u32, &Seen)| {
            let given_up =
                seen.changed.elapsed() > patience && (seen.failed.is_some() || !seen.is_whole());
            let state = match (given_up, seen.is_whole()) {
                (true, _) => State::GivenUp,
                (false, true) => State::Whole,
                (false, false) => State::Growing,
            };
            Waiting { frame, state }
        };
        wanted.map(waiting).collect()
    }

    /// A frame that seemed to be whole could not be read.
    pub fn failed(&mut self, number: u32, error: Error) {
        if let Some(seen) = self.seen.get_mut(&number) {
            seen.failed = Some((Instant::now(), error));
        }
    }

    /// Why a frame could not be read, if that was tried.
    pub fn failure(&self, number: u32) -> Option<&Error> {
        let (_, error) = self.seen.get(&number)?.failed.as_ref()?;
        Some(error)
    }

    /// When a frame was written: by its file's time where that lies within this run, else when it was seen.
    pub fn arrival(&self, number: u32) -> SystemTime {
        let now = SystemTime::now();
        let Some(seen) = self.seen.get(&number) else {
            return now;
        };
        let in_run = |time: &SystemTime| (self.began..=now).contains(time);
        seen.modified
            .filter(in_run)
            .unwrap_or(now - seen.changed.elapsed())
    }

    /// A frame is taken or dropped: neither it nor any before it is wanted any more. Returns the numbers before it that were
    /// never there, from the first to the last.
    pub fn pass(&mut self, number: u32) -> Option<[u32; 2]> {
        let next = self.next.unwrap_or(0);
        let gap = (self.counted && number > next).then(|| [next, number - 1]);
        if let Some([a, b]) = gap
            && b - a < LARGEST_GAP
        {
            self.missing.extend(a..=b);
        }
        self.counted = true;
        self.forget_before(number.saturating_add(1));
        gap
    }

    /// No frame before this one is wanted any more.
    pub fn forget_before(&mut self, number: u32) {
        self.next = Some(number);
        self.seen = self.seen.split_off(&number);
    }

    /// Frames that were missing and came when a later one had been taken.
    pub fn take_late(&mut self) -> Vec<u32> {
        std::mem::take(&mut self.late)
    }

    /// The lowest number that was there when there first was one.
    pub fn lowest(&self) -> Option<u32> {
        self.lowest
    }

    /// The lowest number that is wanted.
    pub fn next_wanted(&self) -> u32 {
        self.next.unwrap_or(0)
    }

    /// The highest number that is there.
    pub fn highest(&self) -> Option<u32> {
        self.highest
    }

    /// Waiting begins now.
    pub fn begin(&mut self) {
        self.changed = Instant::now();
    }

    /// Time since waiting began, or a frame appeared or changed after that.
    pub fn idle(&self) -> Duration {
        self.changed.elapsed()
    }
}

/// A frame that is there and has not been taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Waiting {
    /// Its number.
    pub frame: u32,
    /// Whether it can be taken.
    pub state: State,
}

/// How far the writing of a frame is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum State {
    /// It seems to be done.
    Whole,
    /// It is not done.
    Growing,
    /// It is not done and has not changed for too long.
    GivenUp,
}

/// What to do with the frames that wait.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Choice {
    /// Those to drop, in order.
    pub drop: Vec<Waiting>,
    /// The one to take then.
    pub take: Option<u32>,
}

/// The oldest whole frame; the newest, and none of those before it, where more than [`QUEUE`] are whole. An older one that is
/// still growing holds up later ones until there are [`QUEUE`] of these, or it is given up.
pub fn choose(waiting: &[Waiting]) -> Choice {
    let whole: Vec<u32> = waiting
        .iter()
        .filter(|w| w.state == State::Whole)
        .map(|w| w.frame)
        .collect();
    let taken = match whole[..] {
        [.., newest] if whole.len() > QUEUE => Some(newest),
        [oldest, ..] => Some(oldest),
        [] => None,
    };
    let before = waiting
        .iter()
        .take_while(|w| taken.is_none_or(|taken| w.frame < taken));
    let mut choice = Choice::default();
    for &older in before {
        if older.state == State::Growing && whole.len() < QUEUE {
            return choice;
        }
        choice.drop.push(older);
    }
    choice.take = taken;
    choice
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `w`, `g` and `x` are whole, growing and given up, of frames 1, 2, …
    fn chosen(states: &str) -> (Vec<u32>, Option<u32>) {
        let state = |c| match c {
            'w' => State::Whole,
            'g' => State::Growing,
            _ => State::GivenUp,
        };
        let waiting: Vec<Waiting> = (1..)
            .zip(states.chars().map(state))
            .map(|(frame, state)| Waiting { frame, state })
            .collect();
        let Choice { drop, take } = choose(&waiting);
        (drop.iter().map(|w| w.frame).collect(), take)
    }

    #[test]
    fn frames_are_taken_in_order_and_the_newest_when_behind() {
        assert_eq!(chosen(""), (vec![], None));
        assert_eq!(chosen("w"), (vec![], Some(1)));
        assert_eq!(chosen("ww"), (vec![], Some(1)));
        assert_eq!(chosen("www"), (vec![1, 2], Some(3)));
        assert_eq!(chosen("wwwg"), (vec![1, 2], Some(3)));
    }

    #[test]
    fn a_frame_that_does_not_become_whole_holds_up_few() {
        assert_eq!(chosen("g"), (vec![], None));
        assert_eq!(chosen("gw"), (vec![], None));
        assert_eq!(chosen("gww"), (vec![1], Some(2)));
        assert_eq!(chosen("xw"), (vec![1], Some(2)));
        assert_eq!(chosen("x"), (vec![1], None));
        assert_eq!(chosen("xgw"), (vec![1], None));
        assert_eq!(chosen("gwgww"), (vec![1, 2, 3, 4], Some(5)));
    }
}
