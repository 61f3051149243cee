//! Host file: a sequence's inputs, prepared ahead while its frames render.

use std::sync::mpsc::{self, Receiver};
use std::thread::JoinHandle;

/// An iterator over items that a thread of its own prepares, in order, some ahead of the consumer.
///
/// A renderer takes the light of frame t from it while that of frame t + 1 is read and its table built. Dropping it
/// ends the thread after the item that it is at.
#[derive(Debug)]
pub struct Prefetch<T> {
    items: Receiver<T>,
    thread: Option<JoinHandle<()>>,
}

impl<T: Send + 'static> Prefetch<T> {
    /// Prepares `prepare(key)` for each key, at most `ahead` finished items (at least one) before they are asked for.
    ///
    /// An error is an item like any other, as in `Prefetch<Result<Env, ReadError>>`; the consumer decides whether to
    /// continue.
    ///
    /// # Errors
    /// The operating system's, when it starts no more threads.
    ///
    /// ```
    /// use glimt_render_gpu::sequence::Prefetch;
    /// let squares = Prefetch::new(1..=3, 1, |n: u32| n * n)?;
    /// assert_eq!(squares.collect::<Vec<_>>(), [1, 4, 9]);
    /// # Ok::<(), std::io::Error>(())
    /// ```
    pub fn new<K, I, F>(keys: I, ahead: usize, mut prepare: F) -> std::io::Result<Self>
    where
        I: IntoIterator<Item = K>,
        I::IntoIter: Send + 'static,
        F: FnMut(K) -> T + Send + 'static,
    {
        // The thread itself holds one more item, the one that it is preparing or waits to hand over.
        let (sender, items) = mpsc::sync_channel(ahead.max(1) - 1);
        let keys = keys.into_iter();
        let thread = std::thread::Builder::new()
            .name("prefetch".into())
            .spawn(move || {
                for key in keys {
                    if sender.send(prepare(key)).is_err() {
                        return;
                    }
                }
            })?;
        Ok(Self {
            items,
            thread: Some(thread),
        })
    }
}

impl<T> Iterator for Prefetch<T> {
    type Item = T;

    /// The next item, waiting for it where it is not ready. A panic of the preparing closure continues here.
    fn next(&mut self) -> Option<T> {
        if let Ok(item) = self.items.recv() {
            return Some(item);
        }
        if let Some(Err(panic)) = self.thread.take().map(JoinHandle::join) {
            std::panic::resume_unwind(panic);
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::Arc;
    use std::sync::atomic::{AtomicUsize, Ordering};

    #[test]
    fn errors_pass_through_in_their_place() {
        let items = Prefetch::new(
            0..4,
            1,
            |n| if n == 2 { Err("missing frame") } else { Ok(n) },
        )
        .unwrap();
        assert_eq!(
            items.collect::<Vec<_>>(),
            [Ok(0), Ok(1), Err("missing frame"), Ok(3)]
        );
    }

    #[test]
    fn it_runs_no_further_ahead_than_asked() {
        let begun = Arc::new(AtomicUsize::new(0));
        let counter = begun.clone();
        let mut items = Prefetch::new(0..100, 2, move |n| {
            counter.fetch_add(1, Ordering::SeqCst);
            n
        })
        .unwrap();
        assert_eq!(items.next(), Some(0));
        std::thread::sleep(std::time::Duration::from_millis(50));
        assert!(begun.load(Ordering::SeqCst) <= 3);
    }

    #[test]
    #[should_panic(expected = "unreadable")]
    fn a_panic_goes_on_at_the_consumer() {
        let items =
            Prefetch::new(0..2, 1, |n| if n == 1 { panic!("unreadable") } else { n }).unwrap();
        items.for_each(drop);
    }
}
