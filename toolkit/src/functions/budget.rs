//! The number of evaluations that the work limit still admits for a norm.

use crate::error::{Error, Result};
use crate::estimate::{SPENT, Tolerance};
use std::sync::atomic::{AtomicU64, Ordering};

/// The number of evaluations of a function and of the kernel that remain.
pub(super) struct Budget {
    left: AtomicU64,
    asked: f64,
}

impl Budget {
    pub(super) fn unlimited() -> Self {
        Self { left: AtomicU64::new(u64::MAX), asked: 0.0 }
    }

    pub(super) fn of(tolerance: Tolerance) -> Self {
        Self { left: AtomicU64::new(tolerance.work()), asked: tolerance.relative() }
    }

    pub(super) fn left(&self) -> u64 {
        self.left.load(Ordering::Relaxed)
    }

    /// Deducts `count` evaluations; each thread may exceed the limit by one block.
    ///
    /// # Errors
    /// [`Error::ToleranceNotMet`] if fewer are left.
    pub(super) fn spend(&self, count: u64) -> Result<()> {
        let left = self.left();
        self.left.store(left.saturating_sub(count), Ordering::Relaxed);
        if left > count { Ok(()) } else { Err(Error::out_of_reach("norm", self.asked, f64::INFINITY, SPENT)) }
    }
}
