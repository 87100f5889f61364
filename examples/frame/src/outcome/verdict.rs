//! The verdict of an example, computed from its findings and from nothing else.

use super::finding::{Finding, Outcome, Role};
use std::fmt;

/// What the findings together say of the paper's statement.
#[derive(Debug, Clone, PartialEq)]
pub enum Verdict {
    /// Every claim holds.
    Holds,
    /// Every claim holds, and the statement is not sharp; says by how much.
    HoldsLoose(String),
    /// Every claim holds; the form that the paper prints fails, says where.
    PrintedFormFails(String),
    /// A claim could not be decided, or none was made; says which.
    Undecided(String),
    /// A claim is refuted; says which.
    NotConfirmed(String),
}

impl Verdict {
    /// The verdict of these findings: refuted claims weigh most, then undecided ones, printed forms that
    /// fail, sharpness.
    pub fn of(findings: &[Finding]) -> Self {
        let told = |role: Role, outcome: Outcome| {
            let found = findings.iter().filter(|f| f.role() == role && f.outcome() == outcome);
            let words: Vec<String> = found.map(Finding::words).collect();
            (!words.is_empty()).then(|| words.join("; "))
        };
        let claims = findings.iter().filter(|f| f.role() == Role::Claim && f.outcome() != Outcome::ByProof);
        if let Some(words) = told(Role::Claim, Outcome::Refuted) {
            Verdict::NotConfirmed(words)
        } else if let Some(words) = told(Role::Claim, Outcome::Undecided) {
            Verdict::Undecided(words)
        } else if claims.count() == 0 {
            Verdict::Undecided("no number was compared".to_owned())
        } else if let Some(words) = told(Role::Printed, Outcome::Refuted) {
            Verdict::PrintedFormFails(words)
        } else if let Some(words) = told(Role::Sharpness, Outcome::Holds) {
            Verdict::HoldsLoose(words)
        } else {
            Verdict::Holds
        }
    }

    /// True when every claim holds.
    pub fn is_confirmed(&self) -> bool {
        !matches!(self, Verdict::NotConfirmed(_) | Verdict::Undecided(_))
    }
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Verdict::Holds => write!(f, "holds"),
            Verdict::HoldsLoose(how) => write!(f, "holds, loose: {how}"),
            Verdict::PrintedFormFails(how) => write!(f, "printed form fails: {how}"),
            Verdict::Undecided(why) => write!(f, "undecided: {why}"),
            Verdict::NotConfirmed(why) => write!(f, "not confirmed: {why}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roles_weigh_in_their_order() {
        let holds = |f: Finding| f.number(1.0, 0.0).at_most(2.0, "");
        let fails = |f: Finding| f.number(3.0, 0.0).at_most(2.0, "");
        let claim = || holds(Finding::claim("a", "claim"));
        assert_eq!(Verdict::of(&[]), Verdict::Undecided("no number was compared".into()));
        assert_eq!(Verdict::of(&[claim()]), Verdict::Holds);
        assert_eq!(Verdict::of(&[claim(), fails(Finding::remark("b", "beside"))]), Verdict::Holds);
        let loose = holds(Finding::sharpness("c", "a factor {value}"));
        assert_eq!(Verdict::of(&[claim(), loose.clone()]), Verdict::HoldsLoose("a factor 1".into()));
        let printed = fails(Finding::printed("d", "printed").otherwise("fails at {value}"));
        let found = [claim(), loose, printed];
        assert_eq!(Verdict::of(&found), Verdict::PrintedFormFails("fails at 3".into()));
        assert!(!Verdict::of(&[claim().without_number()]).is_confirmed());
        assert!(!Verdict::of(&[claim().by_proof("page")]).is_confirmed(), "a proof is no evidence");
        assert!(!Verdict::of(&[found[0].clone(), fails(Finding::claim("e", "other"))]).is_confirmed());
    }
}
