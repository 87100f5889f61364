//! What the tests of the exercises say about a wrong answer: which hole, in which case, what came out, what was expected.

use std::fmt::Debug;

/// Fails unless `found` is `expected` up to `tolerance`.
#[track_caller]
pub fn near(hole: &str, case: &str, found: f64, expected: f64, tolerance: f64) {
    let is_near = (found - expected).abs() <= tolerance;
    check(hole, case, found, &format!("{expected} ± {tolerance:e}"), is_near);
}

/// Fails unless the answer is right; `expected` says in words or numbers what it should be.
#[track_caller]
pub fn check(hole: &str, case: &str, found: impl Debug, expected: &str, is_right: bool) {
    assert!(
        is_right,
        "\n  look at   the hole `{hole}`\n  case      {case}\n  came out  {found:?}\n  expected  {expected}\n"
    );
}
