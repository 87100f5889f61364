//! Progress on a terminal: bars of steps, and after a few seconds a sign of life for whatever takes longer.
//! Nothing is drawn where stderr is no terminal.

use indicatif::{MultiProgress, ProgressBar, ProgressStyle};
use std::io::IsTerminal;
use std::sync::LazyLock;
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::thread::JoinHandle;
use std::time::Duration;

/// Runs that are shorter show nothing but their bars.
const SHORT: Duration = Duration::from_secs(3);

/// All that is drawn, line below line.
static LINES: LazyLock<MultiProgress> = LazyLock::new(MultiProgress::new);

/// A progress bar over `steps`, drawn only on a terminal.
pub fn progress(steps: u64) -> ProgressBar {
    if !std::io::stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let bar = LINES.add(ProgressBar::new(steps));
    if let Ok(style) = ProgressStyle::with_template("{bar:40} {pos}/{len} {msg}") {
        bar.set_style(style);
    }
    bar
}

/// How long a run has taken, counted on a terminal from its third second until this is dropped.
pub(crate) struct SignOfLife {
    end: Option<Sender<()>>,
    clock: Option<JoinHandle<()>>,
}

impl SignOfLife {
    pub(crate) fn new() -> Self {
        if !std::io::stderr().is_terminal() {
            return Self { end: None, clock: None };
        }
        let (end, ended) = channel();
        let clock = std::thread::spawn(move || {
            if ended.recv_timeout(SHORT) != Err(RecvTimeoutError::Timeout) {
                return;
            }
            let line = LINES.add(ProgressBar::new_spinner().with_elapsed(SHORT));
            if let Ok(style) = ProgressStyle::with_template("{spinner} {elapsed}") {
                line.set_style(style);
            }
            line.enable_steady_tick(Duration::from_secs(1));
            // Nothing is ever sent: what is waited for is the end of the sender.
            let _ = ended.recv();
            line.finish_and_clear();
        });
        Self { end: Some(end), clock: Some(clock) }
    }
}

impl Drop for SignOfLife {
    fn drop(&mut self) {
        drop(self.end.take());
        if let Some(clock) = self.clock.take() {
            // A clock that failed has nothing left to show.
            let _ = clock.join();
        }
    }
}
