//! What examples say they take, before they begin, beside what they take: the largest resident memory of the
//! process, as Linux counts it. Elsewhere nothing is measured, and that is said.

use clap::Parser;
use example_frame::HasOutput;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Duration;

#[allow(dead_code)]
#[path = "../examples/section_2_multigrid.rs"]
mod section_2_multigrid;

/// What every example takes whatever its size: code, threads, tables.
const PROGRAM: f64 = 20e6;
/// No announcement may be larger than this multiple of what is taken.
const GENEROUS: f64 = 4.0;

fn binary(name: &str) -> PathBuf {
    let tests = std::env::current_exe().unwrap();
    let found = tests.parent().and_then(Path::parent).unwrap().join("examples").join(name);
    assert!(found.exists(), "{} is not built: cargo build --examples in this profile", found.display());
    found
}

/// Bytes in the line `VmHWM:  123456 kB`, the largest resident set so far.
fn peak(status: &str) -> Option<f64> {
    let line = status.lines().find(|line| line.starts_with("VmHWM:"))?;
    Some(1024.0 * line.split_whitespace().nth(1)?.parse::<f64>().ok()?)
}

/// The largest memory of a run; none where the system does not count it.
fn taken(name: &str, line: &str) -> Option<f64> {
    let mut child = Command::new(binary(name))
        .args(line.split(' '))
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let status = format!("/proc/{}/status", child.id());
    let mut largest = None;
    let ended = loop {
        // What is counted only grows, and is gone when the process is.
        largest = std::fs::read_to_string(&status).ok().and_then(|text| peak(&text)).or(largest);
        match child.try_wait().unwrap() {
            Some(ended) => break ended,
            None => std::thread::sleep(Duration::from_millis(1)),
        }
    };
    assert!(matches!(ended.code(), Some(0 | 1)), "{name} {line}: {ended}");
    largest
}

fn announced<O: Parser + HasOutput>(line: &str) -> f64 {
    O::parse_from(["example"].into_iter().chain(line.split(' '))).memory()
}

#[test]
fn what_is_announced_is_taken() {
    let meshes = ["--n 32 --levels 1", "--n 16 --levels 3"];
    let mut runs: Vec<(&str, &str, f64)> = Vec::new();
    runs.extend(
        meshes.map(|line| ("section_2_multigrid", line, announced::<section_2_multigrid::Options>(line))),
    );
    for (name, line, said) in runs {
        let Some(found) = taken(name, line) else {
            println!("{name} {line}: this system does not count the memory of a process");
            continue;
        };
        println!("{name} {line}: {:.1} MB said, {:.1} MB taken", said / 1e6, found / 1e6);
        assert!(said + PROGRAM >= found, "{name} {line}: {said:.2e} said, {found:.2e} taken");
        assert!(said <= GENEROUS * found, "{name} {line}: {said:.2e} said, {found:.2e} taken");
    }
}

#[test]
fn the_line_of_the_system_is_read() {
    assert_eq!(peak("VmPeak: 9 kB\nVmHWM:\t   2048 kB\nVmRSS: 1 kB\n"), Some(2048.0 * 1024.0));
    assert_eq!(peak("VmRSS: 1 kB\n"), None);
}
