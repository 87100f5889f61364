//! The command line of an example, and its exit codes: 0 every claim holds, 1 one fails or is
//! undecided or no number was compared, 2 an error.

use crate::files::{require_writable, write_whole};
use crate::options::{About, command, describe};
use crate::shown::line_width;
use crate::{Declarations, Error, Outcome, Report, Result};
use clap::ArgMatches;
use std::io::{IsTerminal, Write};
use std::path::Path;
use std::process::ExitCode;
use std::sync::Mutex;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::time::Duration;

/// The work of an example whose options are read.
type Work = Box<dyn FnOnce(&mut Report) -> Result<()>>;
/// The text that was given for an option, by its name and its default.
type Given<'a> = &'a dyn Fn(&str, &str) -> String;

/// Parses the command line, runs the example, prints its outcome and returns the exit code.
pub fn main<P: Declarations + 'static, T: 'static>(
    run: fn(&P, &mut Report) -> Result<T>,
) -> ExitCode {
    // Little is left to be compiled with every example.
    respond(&About::of::<P>(), &|given| {
        let options = P::read(given)?;
        Ok(Box::new(move |report| run(&options, report).map(|_| ())))
    })
}

fn respond(about: &About, read: &dyn Fn(Given<'_>) -> Result<Work>) -> ExitCode {
    let matches = match command(about).try_get_matches() {
        Ok(matches) => matches,
        Err(error) => return usage(&error),
    };
    let given = |name: &str| matches.get_one::<String>(name);
    let work = read(&|name, _| match matches.try_get_one::<bool>(name) {
        Ok(flag) => flag.map_or(String::new(), ToString::to_string),
        Err(_) => given(name).cloned().unwrap_or_default(),
    });
    // After the options are read, so that a command is checked without a computation.
    if work.is_ok() && matches.get_flag("describe") {
        let _ = writeln!(std::io::stdout(), "{}", describe(about));
        return ExitCode::SUCCESS;
    }
    match work.and_then(|work| answer(&matches, Report::new(about.label, about.statement), work)) {
        Ok(outcome) => ExitCode::from(outcome.exit_code()),
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(2)
        }
    }
}

fn answer(matches: &ArgMatches, mut report: Report, work: Work) -> Result<Outcome> {
    let given = |name: &str| matches.get_one::<String>(name);
    let values = given("values").map(Path::new);
    values.map_or(Ok(()), require_writable)?;
    let directory = given("out").map(Path::new);
    directory.map_or(Ok(()), require_writable_directory)?;
    report.draws = directory.is_some();
    with_clock(|| work(&mut report))?;
    let mut outcome = report.close();
    match given("fault").map(String::as_str) {
        Some("every") => outcome.turns()?,
        Some(check) => outcome.plant(check)?,
        None => {}
    }
    if let Some(directory) = directory {
        outcome.save_pictures(directory)?;
    }
    if let Some(file) = values {
        write_whole(file, &outcome.json())?;
    }
    let text = match matches.get_flag("json") {
        true => outcome.json_lines(),
        false => outcome.text(std::io::stdout().is_terminal()),
    };
    // A closed pipe (`| head`) is the reader's choice, not a failure.
    let _ = std::io::stdout().write_all(text.as_bytes());
    Ok(outcome)
}

/// What the example reports of its progress: the share of the work that is done, and words.
static PROGRESS: Mutex<(f64, String)> = Mutex::new((f64::NAN, String::new()));

/// Sets the bar and the words beside the clock.
pub(crate) fn show(share: f64, words: String) {
    if let Ok(mut progress) = PROGRESS.lock() {
        *progress = (share, words);
    }
}

/// Length of the bar of progress.
const BAR: usize = 20;

/// Largest length of the line of the clock: one that is wrapped is not overwritten by the next.
const CLOCK: usize = 79;

/// The line of the clock; no bar for a share that is not finite.
fn clock_line(seconds: u64, share: f64, words: &str) -> String {
    let done = (share.clamp(0.0, 1.0) * BAR as f64) as usize;
    let bar = match share.is_finite() {
        true => format!("[{}{}]  ", "#".repeat(done), ".".repeat(BAR - done)),
        false => String::new(),
    };
    let line = format!("{seconds}s  {bar}{words}");
    line.chars().take(CLOCK.min(line_width() - 1)).collect()
}

/// Displays the elapsed seconds and the progress on a terminal, from the third second of the work
/// to its end.
fn with_clock<T>(work: impl FnOnce() -> T) -> T {
    if !std::io::stderr().is_terminal() {
        return work();
    }
    let (end, ended) = channel::<()>();
    std::thread::scope(|scope| {
        scope.spawn(move || {
            let mut seconds = 0;
            while ended.recv_timeout(Duration::from_secs(1)) == Err(RecvTimeoutError::Timeout) {
                seconds += 1;
                if seconds > 2 {
                    let shown = PROGRESS.lock().map(|shown| shown.clone());
                    let (share, words) = shown.unwrap_or((f64::NAN, String::new()));
                    eprint!("\r\u{1b}[K{}", clock_line(seconds, share, &words));
                }
            }
            if seconds > 2 {
                eprint!("\r\u{1b}[K");
            }
        });
        let _end = end;
        work()
    })
}

/// Creates a directory if it does not exist and checks that it is writable, before the computation.
fn require_writable_directory(directory: &Path) -> Result<()> {
    std::fs::create_dir_all(directory).map_err(|error| Error::file(directory, error))?;
    require_writable(&directory.join(".write-probe")).map_err(|error| match error {
        Error::File { reason, .. } => Error::file(directory, reason),
        other => other,
    })
}

/// `--help` goes to stdout; anything else is one line on stderr.
fn usage(error: &clap::Error) -> ExitCode {
    if !error.use_stderr() {
        let _ = error.print();
        return ExitCode::SUCCESS;
    }
    eprintln!("{}", error.to_string().lines().next().unwrap_or("error: bad command line"));
    ExitCode::from(2)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_bar_fits_on_a_line_and_grows_with_the_share() {
        let line = |share: f64| clock_line(12, share, "mesh 3 of 5");
        assert_eq!(line(0.25), "12s  [#####...............]  mesh 3 of 5");
        assert_eq!(line(7.0), "12s  [####################]  mesh 3 of 5");
        assert_eq!(line(f64::NAN), "12s  mesh 3 of 5");
        assert!(clock_line(12, 0.5, &"ü".repeat(500)).chars().count() <= CLOCK);
    }
}
