//! What a request and a run may take.

use std::time::Duration;

/// What a request and a run may take.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Limits {
    /// Time of one run.
    pub run: Duration,
    /// Time within which a request must have arrived, head and body each.
    pub request: Duration,
    /// How long a request waits for the run before it.
    pub patience: Duration,
    /// Bytes of a request's body.
    pub body: usize,
    /// Bytes that a run may write.
    pub output: u64,
    /// Bytes of memory that a run may hold (where the system tells).
    pub memory: u64,
    /// Open connections.
    pub connections: usize,
}

impl Default for Limits {
    fn default() -> Self {
        Self {
            run: Duration::from_secs(60),
            request: Duration::from_secs(5),
            patience: Duration::from_secs(2),
            body: 8 << 10,
            output: 16 << 20,
            memory: 4 << 30,
            connections: 64,
        }
    }
}
