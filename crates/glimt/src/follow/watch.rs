//! Host file: a folder that frames appear in: which are there, which are whole, and which of them to take.

use crate::error::Error;
use crate::input::frames::FrameFiles;
use std::collections::{BTreeMap, BTreeSet};
use std::time::{Duration, Instant, SystemTime};

/// Time between two looks while frames come.
const LOOK: Duration = Duration::from_millis(5);

/// Time to the second look at a file that has just appeared.
const SECOND_LOOK: Duration = Duration::from_millis(2);

/// Time between two looks where none has come for a while.
const IDLE_LOOK: Duration = Duration::from_millis(50);

/// How long frames count as coming after one has.
const FLOW: Duration = Duration::from_secs(2);

/// Files that are listed at every look; a folder of more is listed less often, and the next number is looked for by its name.
const FEW: usize = 500;

/// A file that appears and is older than the look before by this much was not written here: it was renamed when it was whole.
const CLOCK: Duration = Duration::from_millis(20);

/// A file that could not be read is tried again, first after [`LOOK`], then after twice the time before, up to this: clocks of file
/// systems are coarse, and some programs write into files that have their size already.
const RETRY: Duration = Duration::from_millis(500);

/// The largest gap in the numbers of which each frame is remembered as missing.
const LARGEST_GAP: i32 = 10_000;

/// A file as it was seen last.
#[derive(Debug)]
struct Seen {
    length: u64,
    modified: Option<SystemTime>,
    /// When it was found to be there, or changed.
    changed: Instant,
    /// Looks in which it was the same.
    looks: u32,
    /// Whether it appeared when it had been written.
    renamed: bool,
    /// The last attempt to read it, which failed.
    failed: Option<Failed>,
}

/// An attempt that failed.
#[derive(Debug)]
struct Failed {
    /// When it may be tried again.
    again: Instant,
    /// The time until then.
    pause: Duration,
    error: Error,
}

impl Seen {
    /// Not changed between two looks, or renamed, and nothing says that it cannot be read.
    fn is_whole(&self) -> bool {
        self.is_settled()
            && self.length > 0
            && self
                .failed
                .as_ref()
                .is_none_or(|failed| Instant::now() >= failed.again)
    }

    fn is_settled(&self) -> bool {
        self.looks >= 2 || self.renamed
    }
}

/// Watches the files of a sequence.
#[derive(Debug)]
pub struct Watcher {
    files: FrameFiles,
    began: SystemTime,
    /// The lowest number that is wanted; without one, the first look decides.
    next: Option<i32>,
    /// Whether numbers from `next` on that are not there are missing: not before the first frame of a run without a range.
    counted: bool,
    seen: BTreeMap<i32, Seen>,
    lowest: Option<i32>,
    highest: Option<i32>,
    looked: Option<Instant>,
    /// When the folder was listed, and how many of its files are frames.
    listed: Option<(Instant, usize)>,
    /// The last look at which all that was there was seen.
    seen_all: SystemTime,
    changed: Instant,
    missing: BTreeSet<i32>,
    late: Vec<i32>,
}

impl Watcher {
    /// Watches for frames from `first` on, or else from the newest on that is there at the first look.
    pub fn new(files: FrameFiles, first: Option<i32>) -> Self {
        Self {
            files,
            began: SystemTime::now(),
            next: first,
            counted: first.is_some(),
            seen: BTreeMap::new(),
            lowest: None,
            highest: None,
            looked: None,
            listed: None,
            seen_all: SystemTime::UNIX_EPOCH,
            changed: Instant::now(),
            missing: BTreeSet::new(),
            late: Vec::new(),
        }
    }

    /// The files.
    pub fn files(&self) -> &FrameFiles {
        &self.files
    }

    /// Time until the next look.
    pub fn pause(&self) -> Duration {
        match self.idle() < FLOW {
            _ if self.has_new() => SECOND_LOOK,
            true => LOOK,
            false => IDLE_LOOK,
        }
    }

    /// Whether a file waits for its second look.
    fn has_new(&self) -> bool {
        self.seen.values().any(|seen| !seen.is_settled())
    }

    /// Looks for frames, if the last look is not too recent. A folder that is not there is an empty one.
    pub fn look(&mut self) {
        let least = if self.has_new() { SECOND_LOOK } else { LOOK };
        if self.looked.is_some_and(|at| at.elapsed() < least) {
            return;
        }
        self.looked = Some(Instant::now());
        let now = SystemTime::now();
        let is_due = self
            .listed
            .is_none_or(|(at, count)| count <= FEW || at.elapsed() >= IDLE_LOOK);
        match is_due {
            true => self.list(),
            false => self.look_for_next(),
        }
        self.seen_all = now;
    }

    /// Looks at all files of the folder.
    fn list(&mut self) {
        let first_look = self.listed.is_none();
        let listed = self.files.listed().unwrap_or_default();
        self.listed = Some((Instant::now(), listed.len()));
        self.highest = listed.last().copied();
        if self.lowest.is_none() {
            self.lowest = listed.first().copied();
        }
        if first_look && self.next.is_none() {
            self.next = Some(self.highest.unwrap_or(i32::MIN));
        }
        let next = self.next.unwrap_or(i32::MIN);
        self.seen.retain(|n, _| listed.binary_search(n).is_ok());
        for number in listed {
            if number >= next {
                self.look_at(number);
            } else if self.missing.remove(&number) {
                self.late.push(number);
            }
        }
    }

    /// Looks at what is known, and for the frames behind the highest number.
    fn look_for_next(&mut self) {
        let known: Vec<i32> = self.seen.keys().copied().collect();
        for number in known {
            self.look_at(number);
        }
        while let Some(next) = self.highest.and_then(|highest| highest.checked_add(1)) {
            if !self.look_at(next) {
                break;
            }
            self.highest = Some(next);
        }
    }

    /// Looks at a frame; says whether it is there.
    fn look_at(&mut self, number: i32) -> bool {
        // What is whole is not looked at again, unless it turned out that it is not.
        let known = self.seen.get_mut(&number);
        if known
            .as_ref()
            .is_some_and(|seen| seen.is_settled() && seen.failed.is_none())
        {
            return true;
        }
        let Ok(data) = std::fs::metadata(self.files.path(number)) else {
            return false;
        };
        let (length, modified) = (data.len(), data.modified().ok());
        match known {
            Some(seen) if (seen.length, seen.modified) == (length, modified) => seen.looks += 1,
            known => {
                // At the first look of all it may be of any age.
                let appeared = known.is_none() && self.seen_all > SystemTime::UNIX_EPOCH;
                let changed = Instant::now();
                self.changed = changed;
                let seen = Seen {
                    length,
                    modified,
                    changed,
                    looks: 1,
                    renamed: appeared
                        && modified.is_some_and(|modified| modified + CLOCK < self.seen_all),
                    failed: None,
                };
                self.seen.insert(number, seen);
            }
        }
        true
    }

    /// Whether a frame is there and seems to be whole.
    pub fn is_whole(&self, number: i32) -> bool {
        self.seen.get(&number).is_some_and(Seen::is_whole)
    }

    /// Whether a frame is there, whole or not.
    pub fn is_there(&self, number: i32) -> bool {
        self.seen.contains_key(&number)
    }

    /// The newest frame before this one that seems to be whole.
    pub fn whole_before(&self, number: i32) -> Option<i32> {
        let mut before = self.seen.range(..number).rev();
        before.find(|(_, seen)| seen.is_whole()).map(|(n, _)| *n)
    }

    /// The frames that wait, in order, up to `last`. One that has not been whole for `patience` is given up; one that came longer ago
    /// than `max_lag` is late.
    pub fn waiting(
        &self,
        last: Option<i32>,
        patience: Duration,
        max_lag: Duration,
    ) -> Vec<Waiting> {
        let wanted = self.seen.range(..=last.unwrap_or(i32::MAX));
        let waiting = |(&frame, seen): (&i32, &Seen)| {
            let given_up =
                seen.changed.elapsed() > patience && (seen.failed.is_some() || !seen.is_whole());
            let lag = self.arrival(frame).elapsed().unwrap_or_default();
            let state = match (given_up, seen.is_whole()) {
                (true, _) => State::GivenUp,
                (false, true) if lag > max_lag => State::Late,
                (false, true) => State::Whole,
                (false, false) => State::Growing,
            };
            Waiting { frame, state }
        };
        wanted.map(waiting).collect()
    }

    /// A frame that seemed to be whole could not be read.
    pub fn failed(&mut self, number: i32, error: Error) {
        if let Some(seen) = self.seen.get_mut(&number) {
            let pause = seen.failed.as_ref().map_or(LOOK, |failed| failed.pause * 2);
            let pause = pause.min(RETRY);
            seen.failed = Some(Failed {
                again: Instant::now() + pause,
                pause,
                error,
            });
        }
    }

    /// Why a frame could not be read, if that was tried.
    pub fn failure(&self, number: i32) -> Option<&Error> {
        Some(&self.seen.get(&number)?.failed.as_ref()?.error)
    }

    /// When a frame was written: by its file's time where that lies within this run, else when it was seen.
    pub fn arrival(&self, number: i32) -> SystemTime {
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
    pub fn pass(&mut self, number: i32) -> Option<[i32; 2]> {
        let next = self.next.unwrap_or(i32::MIN);
        let gap = (self.counted && number > next).then(|| [next, number - 1]);
        if let Some([a, b]) = gap
            && b.saturating_sub(a) < LARGEST_GAP
        {
            self.missing.extend(a..=b);
        }
        self.counted = true;
        self.forget_before(number.saturating_add(1));
        gap
    }

    /// No frame before this one is wanted any more.
    pub fn forget_before(&mut self, number: i32) {
        self.next = Some(number);
        self.seen = self.seen.split_off(&number);
    }

    /// Frames that were missing and came when a later one had been taken.
    pub fn take_late(&mut self) -> Vec<i32> {
        std::mem::take(&mut self.late)
    }

    /// The lowest number that was there when there first was one.
    pub fn lowest(&self) -> Option<i32> {
        self.lowest
    }

    /// The lowest number that is wanted.
    pub fn next_wanted(&self) -> i32 {
        self.next.unwrap_or(i32::MIN)
    }

    /// The highest number that is there.
    pub fn highest(&self) -> Option<i32> {
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
    pub frame: i32,
    /// Whether it can be taken.
    pub state: State,
}

/// How far the writing of a frame is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum State {
    /// It seems to be done.
    Whole,
    /// It seems to be done, and has waited for too long.
    Late,
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
    pub take: Option<i32>,
}

/// The oldest whole frame; where that is late, the newest whole one, and none of those before it. An older one that is still growing
/// holds up later ones until these are late, or it is given up.
pub fn choose(waiting: &[Waiting]) -> Choice {
    let mut whole = waiting
        .iter()
        .filter(|w| matches!(w.state, State::Whole | State::Late));
    let oldest = whole.next();
    let is_late = oldest.is_some_and(|oldest| oldest.state == State::Late);
    let taken = match is_late {
        true => whole.next_back().or(oldest),
        false => oldest,
    };
    let taken = taken.map(|w| w.frame);
    let before = waiting
        .iter()
        .take_while(|w| taken.is_none_or(|taken| w.frame < taken));
    let mut choice = Choice::default();
    for &older in before {
        if older.state == State::Growing && !is_late {
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

    /// `w`, `l`, `g` and `x` are whole, late, growing and given up, of frames 1, 2, …
    fn chosen(states: &str) -> (Vec<i32>, Option<i32>) {
        let state = |c| match c {
            'w' => State::Whole,
            'l' => State::Late,
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
    fn frames_are_taken_in_order_and_the_newest_when_late() {
        assert_eq!(chosen(""), (vec![], None));
        assert_eq!(chosen("w"), (vec![], Some(1)));
        assert_eq!(chosen("wwwwww"), (vec![], Some(1)));
        assert_eq!(chosen("l"), (vec![], Some(1)));
        assert_eq!(chosen("lww"), (vec![1, 2], Some(3)));
        assert_eq!(chosen("llwg"), (vec![1, 2], Some(3)));
    }

    #[test]
    fn a_frame_that_does_not_become_whole_holds_up_others_until_they_are_late() {
        assert_eq!(chosen("g"), (vec![], None));
        assert_eq!(chosen("gwww"), (vec![], None));
        assert_eq!(chosen("glw"), (vec![1, 2], Some(3)));
        assert_eq!(chosen("xw"), (vec![1], Some(2)));
        assert_eq!(chosen("x"), (vec![1], None));
        assert_eq!(chosen("xgw"), (vec![1], None));
        assert_eq!(chosen("glgww"), (vec![1, 2, 3, 4], Some(5)));
    }

    #[test]
    fn a_file_is_whole_at_the_second_look_or_at_the_first_if_it_was_renamed() {
        let folder = std::env::temp_dir().join(format!("glimt-watch-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        let files = FrameFiles::new(&folder, "f.##.exr").unwrap();
        let mut watch = Watcher::new(files, Some(1));
        let mut look = || {
            watch.looked = None;
            watch.look();
            [1, 2].map(|frame| watch.is_whole(frame))
        };
        look();
        std::fs::write(folder.join("f.01.exr"), b"written").unwrap();
        let old = folder.join("old");
        std::fs::write(&old, b"renamed").unwrap();
        let file = std::fs::File::options().write(true).open(&old).unwrap();
        file.set_modified(SystemTime::now() - Duration::from_secs(1))
            .unwrap();
        std::fs::rename(&old, folder.join("f.02.exr")).unwrap();
        assert_eq!(look(), [false, true]);
        assert_eq!(look(), [true, true]);
        std::fs::remove_dir_all(&folder).unwrap();
    }
}
