//! The last value of an expensive computation, for callers that ask for it again.

use crate::error::Error;
use std::sync::{Arc, Mutex, PoisonError};

/// A cache of one value.
pub(crate) struct Last<T>(Mutex<Option<Arc<T>>>);

impl<T> Last<T> {
    pub(crate) const fn none() -> Self {
        Self(Mutex::new(None))
    }

    /// The last value if it is the one asked for; otherwise a new one, which replaces it.
    ///
    /// # Errors
    /// Those of `make`.
    pub(crate) fn get(
        &self,
        is_asked_for: impl Fn(&T) -> bool,
        make: impl FnOnce() -> Result<T, Error>,
    ) -> Result<Arc<T>, Error> {
        let kept = || self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let last = kept().clone();
        if let Some(found) = last.filter(|found| is_asked_for(found)) {
            return Ok(found);
        }
        // Not under the lock: the parallel loops may steal a task that asks for the same value.
        let made = Arc::new(make()?);
        *kept() = Some(Arc::clone(&made));
        Ok(made)
    }
}
