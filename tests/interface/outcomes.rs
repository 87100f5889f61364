//! Every example at its default size: every claim holds, the outcome fits a terminal, and each check, its number
//! moved across its bound, turns its mark, the status and the exit code (`--fault every`).

use crate::program::{names, program};
use rayon::prelude::*;

/// Lines and columns of a terminal.
const SCREEN: (usize, usize) = (40, 100);

/// What is wrong with an outcome.
fn fault(name: &str) -> Option<String> {
    let output = program(name).args(["--fault", "every"]).output().unwrap();
    let [text, error] = [output.stdout, output.stderr].map(|bytes| String::from_utf8(bytes).unwrap());
    let (lines, columns) =
        (text.lines().count(), text.lines().map(|line| line.chars().count()).max().unwrap_or(0));
    let is_good = output.status.code() == Some(0) && error.is_empty();
    let fits = (1..=SCREEN.0).contains(&lines) && columns <= SCREEN.1;
    (!is_good || !fits)
        .then(|| format!("{name}: {:?} {error}{lines} x {columns}\n{text}", output.status.code()))
}

#[test]
fn every_example_holds_fits_a_terminal_and_turns_with_its_checks() {
    let names = names();
    assert!(names.len() > 40, "{}", names.len());
    let faults: Vec<String> = names.par_iter().filter_map(|name| fault(name)).collect();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}
