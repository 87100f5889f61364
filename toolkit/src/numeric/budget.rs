//! The number of evaluations that a work limit still admits, counted over all threads.

use crate::error::Error;
use std::sync::atomic::{AtomicU64, Ordering};

/// The number of evaluations of a function or a kernel that remain, and the accuracy they are for.
#[derive(Debug)]
pub(crate) struct Budget {
    left: AtomicU64,
    asked: f64,
}

impl Budget {
    pub(crate) fn new(evaluations: u64, asked: f64) -> Self {
        Self { left: AtomicU64::new(evaluations), asked }
    }

    pub(crate) fn left(&self) -> u64 {
        self.left.load(Ordering::Relaxed)
    }

    /// Deducts `count` evaluations; false if fewer were left. Each thread may exceed the limit by one block.
    pub(crate) fn spend(&self, count: u64) -> bool {
        let left = self.left();
        self.left.store(left.saturating_sub(count), Ordering::Relaxed);
        left > count
    }

    /// [`Error::ToleranceNotMet`] without a value.
    pub(crate) fn spent(&self, what: &'static str, why: &'static str) -> Error {
        Error::out_of_reach(what, self.asked, f64::INFINITY, why)
    }
}
