//! Reused buffers: the updates of a multifrontal elimination have similar sizes, and allocating zeroed
//! pages each time costs more than the arithmetic.

use std::sync::{Mutex, PoisonError};

/// Buffers shorter than this are left to the allocator, which caches them itself.
const WORTH_KEEPING: usize = 1 << 13;

/// Buffers available for reuse, shared by all threads.
#[derive(Debug, Default)]
pub(super) struct Pool {
    waiting: Mutex<Vec<Vec<f64>>>,
}

impl Pool {
    /// A buffer of `length` zeros: the shortest available one that is long enough and at most four times as long.
    pub(super) fn zeros(&self, length: usize) -> Vec<f64> {
        match self.fitting(length) {
            Some(mut buffer) => {
                buffer.clear();
                buffer.resize(length, 0.0);
                buffer
            }
            // Written immediately: zero pages that are first read and then written cost two page faults each.
            None => std::iter::repeat_n(0.0, length).collect(),
        }
    }

    fn fitting(&self, length: usize) -> Option<Vec<f64>> {
        if length < WORTH_KEEPING {
            return None;
        }
        // The list is valid even if another thread panicked while holding the lock.
        let mut waiting = self.waiting.lock().unwrap_or_else(PoisonError::into_inner);
        let best = waiting
            .iter()
            .enumerate()
            .filter(|(_, buffer)| (length..=4 * length).contains(&buffer.capacity()))
            .min_by_key(|(_, buffer)| buffer.capacity())
            .map(|(k, _)| k)?;
        Some(waiting.swap_remove(best))
    }

    pub(super) fn keep(&self, buffer: Vec<f64>) {
        if buffer.capacity() >= WORTH_KEEPING {
            self.waiting.lock().unwrap_or_else(PoisonError::into_inner).push(buffer);
        }
    }
}
