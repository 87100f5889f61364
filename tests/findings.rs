//! Every finding of every example at its default size: its number moved across its bound, and the outcome,
//! the words, the verdict and the exit code seen to turn. A sentence that no number could turn would be found
//! here. `cargo book labels` writes the list of examples.

#![allow(clippy::duplicate_mod, reason = "twins and the tour share files, and every example is loaded")]

use example_frame::{Finding, Headline, Outcome, Role, Verdict};
use std::collections::BTreeSet;

/// Fewer sentences than these are no outcome.
const LEAST: usize = 3;

/// The headline with one finding replaced.
fn with(headline: &Headline, at: usize, finding: Finding) -> Headline {
    let mut changed = headline.clone();
    changed.findings[at] = finding;
    changed
}

/// What a finding moved to `outcome` must do to the verdict, where all other claims hold.
fn follows(role: Role, outcome: Outcome, headline: &Headline, words: &str) -> bool {
    let verdict = headline.verdict();
    match (role, outcome) {
        (Role::Claim, Outcome::Refuted) => {
            headline.exit_code() == 1 && matches!(&verdict, Verdict::NotConfirmed(why) if why.contains(words))
        }
        (Role::Claim, Outcome::Undecided) => {
            headline.exit_code() == 1 && matches!(&verdict, Verdict::Undecided(why) if why.contains(words))
        }
        (Role::Printed, Outcome::Refuted) => {
            matches!(&verdict, Verdict::PrintedFormFails(how) if how.contains(words))
        }
        (Role::Sharpness, Outcome::Holds) => {
            matches!(&verdict, Verdict::PrintedFormFails(_))
                || matches!(&verdict, Verdict::HoldsLoose(how) if how.contains(words))
        }
        _ => headline.exit_code() == 0,
    }
}

fn every_finding_turns(headline: &Headline) {
    assert_eq!(headline.exit_code(), 0, "{headline}");
    assert!(headline.findings.len() >= LEAST, "{headline}");
    assert_eq!(headline.table.unexplained(), [""; 0], "missing entries without a reason: {headline}");
    let keys: BTreeSet<&str> = headline.findings.iter().map(Finding::key).collect();
    assert_eq!(keys.len(), headline.findings.len(), "two findings with one key: {headline}");
    let decided = headline.findings.iter().filter(|f| f.outcome() != Outcome::ByProof);
    assert!(decided.count() >= LEAST, "too few findings that a number decides: {headline}");
    for (at, finding) in headline.findings.iter().enumerate() {
        let label = format!("{} / {}: {}", headline.label, finding.key(), finding.comparison());
        if finding.outcome() == Outcome::ByProof {
            assert!(finding.moved(Outcome::Refuted).is_none(), "{label}");
            continue;
        }
        assert!(!finding.source().is_empty(), "a bound without a source: {label}");
        let mut said = BTreeSet::new();
        for wanted in [Outcome::Holds, Outcome::Refuted, Outcome::Undecided] {
            let moved = finding.moved(wanted).expect("a number decides");
            assert_eq!(moved.outcome(), wanted, "{label}: {}", moved.comparison());
            let words = moved.words();
            let changed = with(headline, at, moved);
            assert!(
                follows(finding.role(), wanted, &changed, &words),
                "{label}: {wanted}: {}",
                changed.verdict()
            );
            said.insert(words);
        }
        assert_eq!(said.len(), 3, "the same words for different outcomes: {label}: {said:?}");
        let missing = finding.without_number();
        assert_eq!(missing.outcome(), Outcome::Undecided, "{label}");
        assert_eq!(finding.with_number(f64::NAN, 0.0).outcome(), Outcome::Undecided, "{label}");
    }
}

macro_rules! examples {
    ($($name:ident: $file:literal),* $(,)?) => {
        $(#[path = $file] #[allow(dead_code, reason = "only `run` is used here")] mod $name;)*

        $(#[test]
        fn $name() {
            every_finding_turns(&$name::run(&$name::Options::default()).unwrap());
        })*
    };
}

examples! {
    // examples
    // end of examples
}
