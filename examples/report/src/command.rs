//! The command line of an example, and its exit codes: 0 every claim holds, 1 one fails or is
//! undecided or no number was compared, 2 an error.

use crate::files::{require_writable, write_whole};
use crate::options::{command, describe};
use crate::{Declarations, Error, Outcome, Report, Result};
use std::io::{IsTerminal, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::thread::JoinHandle;
use std::time::Duration;

/// Parses the command line, runs the example, prints its outcome and returns the exit code.
pub fn main<P: Declarations>(run: fn(&P, &mut Report) -> Result<()>) -> ExitCode {
    let matches = match command::<P>().try_get_matches() {
        Ok(matches) => matches,
        Err(error) => return usage(&error),
    };
    if matches.get_flag("describe") {
        let _ = writeln!(std::io::stdout(), "{}", describe::<P>());
        return ExitCode::SUCCESS;
    }
    let text = |name: &str| match matches.try_get_one::<bool>(name) {
        Ok(flag) => flag.map_or(String::new(), ToString::to_string),
        Err(_) => matches.get_one::<String>(name).cloned().unwrap_or_default(),
    };
    let asked = Asked {
        json: matches.get_flag("json"),
        out: matches.get_one::<String>("out").map(PathBuf::from),
        values: matches.get_one::<String>("values").map(PathBuf::from),
        fault: matches.get_one::<String>("fault").cloned(),
    };
    match asked.answer::<P>(&text, run) {
        Ok(outcome) => ExitCode::from(outcome.exit_code()),
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(2)
        }
    }
}

/// The destinations of the outcome.
struct Asked {
    json: bool,
    out: Option<PathBuf>,
    values: Option<PathBuf>,
    fault: Option<String>,
}

impl Asked {
    fn answer<P: Declarations>(
        &self,
        text: &dyn Fn(&str) -> String,
        run: fn(&P, &mut Report) -> Result<()>,
    ) -> Result<Outcome> {
        for option in P::declared() {
            option.check(&text(option.name))?;
        }
        let options = P::read(text)?;
        self.values.as_deref().map_or(Ok(()), require_writable)?;
        let directory = self.out.as_deref().map(writable_directory).transpose()?;
        let mut report = Report::of::<P>();
        report.draws = directory.is_some();
        let clock = Clock::start();
        let ended = run(&options, &mut report);
        drop(clock);
        ended?;
        let mut outcome = report.close();
        match self.fault.as_deref() {
            Some("every") => outcome.turns()?,
            Some(check) => outcome.plant(check)?,
            None => {}
        }
        if let Some(directory) = directory {
            outcome.save_pictures(directory)?;
        }
        if let Some(file) = &self.values {
            write_whole(file, &outcome.json())?;
        }
        let text = match self.json {
            true => outcome.json_lines(),
            false => outcome.text(std::io::stdout().is_terminal()),
        };
        // A closed pipe (`| head`) is the reader's choice, not a failure.
        let _ = std::io::stdout().write_all(text.as_bytes());
        Ok(outcome)
    }
}

/// Displays the elapsed seconds on a terminal, from the third second until it is dropped.
struct Clock(Option<Sender<()>>, Option<JoinHandle<()>>);

impl Clock {
    fn start() -> Self {
        if !std::io::stderr().is_terminal() {
            return Self(None, None);
        }
        let (end, ended) = channel();
        let count = move || {
            let mut seconds = 0;
            while ended.recv_timeout(Duration::from_secs(1)) == Err(RecvTimeoutError::Timeout) {
                seconds += 1;
                if seconds > 2 {
                    eprint!("\r{seconds}s");
                }
            }
            if seconds > 2 {
                eprint!("\r\u{1b}[K");
            }
        };
        Self(Some(end), Some(std::thread::spawn(count)))
    }
}

impl Drop for Clock {
    fn drop(&mut self) {
        drop(self.0.take());
        // A clock that failed has nothing left to show.
        self.1.take().map(JoinHandle::join).transpose().ok();
    }
}

/// Creates a directory if it does not exist and checks that it is writable, before the computation.
fn writable_directory(directory: &Path) -> Result<&Path> {
    std::fs::create_dir_all(directory).map_err(|error| Error::file(directory, error))?;
    require_writable(&directory.join(".write-probe")).map_err(|error| match error {
        Error::File { reason, .. } => Error::file(directory, reason),
        other => other,
    })?;
    Ok(directory)
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
