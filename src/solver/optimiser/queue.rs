//! Bucket queue: items by a small whole number, the least first.
//!
//! Within a bucket the oldest item comes first or the newest one. Both are deterministic.

use std::collections::VecDeque;

/// Which item of a bucket comes first.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Ties {
    OldestFirst,
    NewestFirst,
}

/// Priorities from here on share the last bucket.
const MOST_BUCKETS: usize = 1 << 16;

#[derive(Debug)]
pub(super) struct BucketQueue {
    ties: Ties,
    buckets: Vec<VecDeque<u32>>,
    /// No bucket before this one holds anything.
    least: usize,
    len: usize,
}

impl BucketQueue {
    pub(super) fn new(ties: Ties) -> Self {
        Self { ties, buckets: Vec::new(), least: 0, len: 0 }
    }

    pub(super) fn push(&mut self, priority: u32, item: u32) {
        let bucket = (priority as usize).min(MOST_BUCKETS - 1);
        if self.buckets.len() <= bucket {
            self.buckets.resize_with(bucket + 1, VecDeque::new);
        }
        self.buckets[bucket].push_back(item);
        self.least = self.least.min(bucket);
        self.len += 1;
    }

    /// Takes the first item, with its priority.
    pub(super) fn pop(&mut self) -> Option<(u32, u32)> {
        while let Some(bucket) = self.buckets.get_mut(self.least) {
            let item = match self.ties {
                Ties::OldestFirst => bucket.pop_front(),
                Ties::NewestFirst => bucket.pop_back(),
            };
            if let Some(item) = item {
                self.len -= 1;
                return Some((self.least as u32, item));
            }
            self.least += 1;
        }
        None
    }

    /// Bytes in use, counted by contents.
    pub(super) fn bytes(&self) -> u64 {
        (4 * self.len + size_of::<VecDeque<u32>>() * self.buckets.len()) as u64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_least_priority_comes_first_and_ties_as_asked() {
        for (ties, expected) in [
            (Ties::OldestFirst, [(1, 3), (5, 1), (5, 2), (9, 4)]),
            (Ties::NewestFirst, [(1, 3), (5, 2), (5, 1), (9, 4)]),
        ] {
            let mut queue = BucketQueue::new(ties);
            for (priority, item) in [(5, 1), (5, 2), (1, 3), (9, 4)] {
                queue.push(priority, item);
            }
            let taken: Vec<_> = std::iter::from_fn(|| queue.pop()).collect();
            assert_eq!(taken, expected);
            queue.push(0, 7);
            assert_eq!((queue.pop(), queue.pop()), (Some((0, 7)), None));
        }
    }
}
