//! Files and processes: places that cannot be written, directories in place of files, a run that says it lives.

use crate::program::program;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};

/// An example that takes no time, and what it draws.
const QUICK: &str = "equation_6_2_mean";

fn command(name: &str, arguments: &[&str]) -> Command {
    let mut command = program(name);
    command.args(arguments).stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    command
}

fn run(arguments: &[&str]) -> Output {
    command(QUICK, arguments).output().expect("`cargo test` builds the examples first")
}

/// A directory of its own, removed when this is dropped.
struct Scratch(PathBuf);

impl Scratch {
    fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("signorini-{name}-{}", std::process::id()));
        let _ = std::fs::remove_dir_all(&path);
        std::fs::create_dir_all(&path).unwrap();
        Self(path)
    }

    fn at(&self, name: &str) -> String {
        self.0.join(name).to_str().unwrap().to_owned()
    }

    /// The names in it, those of parts left behind among them.
    fn names(&self) -> BTreeSet<String> {
        let entries = std::fs::read_dir(&self.0).unwrap();
        entries.map(|entry| entry.unwrap().file_name().to_str().unwrap().to_owned()).collect()
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

/// Exit 2, one line that names the place, nothing on stdout.
#[track_caller]
fn is_refused(output: &Output, place: &str) {
    let error = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{place}: {error}");
    assert!(error.starts_with("error:") && error.lines().count() == 1, "{place}: {error}");
    assert!(error.contains(place) && output.stdout.is_empty(), "{place}: {error}");
}

#[test]
fn places_that_cannot_be_written_are_refused() {
    let scratch = Scratch::new("places");
    std::fs::write(scratch.at("file"), "kept").unwrap();
    std::fs::create_dir(scratch.at("directory")).unwrap();
    for place in ["file", "file/below"] {
        is_refused(&run(&["--out", &scratch.at(place)]), &scratch.at(place));
    }
    for place in ["directory", "file/below", "nowhere/values.json"] {
        is_refused(&run(&["--values", &scratch.at(place)]), &scratch.at(place));
    }
    // Nobody writes there, root neither.
    if Path::new("/proc/self").exists() {
        is_refused(&run(&["--out", "/proc/signorini"]), "/proc/signorini");
        is_refused(&run(&["--values", "/proc/signorini"]), "/proc/signorini");
    }
    assert_eq!(scratch.names(), ["directory".to_owned(), "file".to_owned()].into());
    assert_eq!(std::fs::read_to_string(scratch.at("file")).unwrap(), "kept");
}

/// On a terminal, which `script` of util-linux is; nothing is asked of a machine without it.
#[cfg(target_os = "linux")]
#[test]
fn a_run_of_some_seconds_says_on_a_terminal_that_it_lives() {
    let orders = format!("--nu {}", ["0.5"; 200].join(","));
    shows_on_a_terminal("lemma_6_1_local_estimate", &orders, "4s");
    // A body also shows a bar, which mesh it is at, and the size of the mesh.
    shows_on_a_terminal("section_2_own_body", "--levels 7", "]  mesh ");
}

/// Runs an example on a terminal until these words are on it.
#[cfg(target_os = "linux")]
fn shows_on_a_terminal(example: &str, options: &str, words: &str) {
    let program = command(example, &[]);
    // With an end of its own, where the hangup of the terminal is not heard.
    let line =
        format!("timeout --foreground 30 {} {options}", program.get_program().to_str().unwrap());
    let mut terminal = Command::new("script");
    terminal.args(["-qec", &line, "/dev/null"]).stdin(Stdio::null()).stdout(Stdio::piped());
    let Ok(mut process) = terminal.spawn() else { return };
    let mut drawn = process.stdout.take().unwrap();
    let (mut said, mut bytes) = (String::new(), [0; 256]);
    let start = Instant::now();
    while !said.contains(words) && start.elapsed() < Duration::from_secs(20) {
        let count = std::io::Read::read(&mut drawn, &mut bytes).unwrap();
        assert!(count > 0, "ended: {said}");
        said += &String::from_utf8_lossy(&bytes[..count]);
    }
    process.kill().unwrap();
    process.wait().unwrap();
    assert!(said.contains(words), "{said:?}");
}
