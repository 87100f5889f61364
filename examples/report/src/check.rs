//! Claims, each with the comparison that decides it.

use crate::Measured;
use crate::cell::{bound_text, measured_text};
use crate::words::slug;
use serde_json::{Value, json};

/// The result of a comparison.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Decision {
    /// True by proof; no number is compared.
    ByProof,
    /// The relation is satisfied, errors included.
    Holds,
    /// Undecided within the errors, or there is no number.
    Undecided,
    /// The relation is violated, errors included.
    Fails,
}

impl Decision {
    /// The mark at the beginning of the printed line.
    pub fn mark(self) -> char {
        match self {
            Decision::ByProof => '∎',
            Decision::Holds => '✓',
            Decision::Undecided => '?',
            Decision::Fails => '✗',
        }
    }

    /// The name of the decision in the JSON output.
    pub fn word(self) -> &'static str {
        match self {
            Decision::ByProof => "by proof",
            Decision::Holds => "holds",
            Decision::Undecided => "undecided",
            Decision::Fails => "fails",
        }
    }
}

/// The effect of a check on the status of the statement.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Role {
    /// Must hold.
    Claim,
    /// The paper's own form: if it fails, the statement is false as printed.
    AsPrinted,
    /// A different rate of growth: if it holds, the statement is not sharp.
    NotSharp,
    /// A stronger statement: if it holds, the paper's is loose.
    Stronger,
    /// No effect on the status.
    Observed,
}

impl Role {
    fn word(self) -> &'static str {
        match self {
            Role::Claim => "claim",
            Role::AsPrinted => "printed",
            Role::NotSharp | Role::Stronger => "sharpness",
            Role::Observed => "remark",
        }
    }
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Relation {
    AtMost,
    AtLeast,
    Near(f64),
}

/// A claim with the comparison that decides it.
#[derive(Debug, Clone, PartialEq)]
pub struct Checked {
    pub(crate) claim: String,
    pub(crate) role: Role,
    value: Measured,
    relation: Relation,
    bound: Measured,
    pub(crate) source: String,
    proof: Option<String>,
    /// The number of times it was reported.
    pub(crate) cases: usize,
}

impl Checked {
    /// The claim in letters, digits and hyphens: the key under which a page quotes the check.
    pub fn key(&self) -> String {
        slug(&self.claim)
    }

    /// The claim.
    pub fn claim(&self) -> &str {
        &self.claim
    }

    /// The effect of the check on the status of the statement.
    pub fn role(&self) -> Role {
        self.role
    }

    /// The source of the bound.
    pub fn source(&self) -> &str {
        &self.source
    }

    /// The number that is compared, with its error.
    pub fn value(&self) -> Measured {
        self.value
    }

    /// The result of the comparison.
    pub fn decision(&self) -> Decision {
        if self.proof.is_some() {
            return Decision::ByProof;
        }
        let slack = self.value.error + self.bound.error;
        let excess = self.excess();
        // Comparisons with NaN are false.
        if excess + slack <= 0.0 {
            Decision::Holds
        } else if excess - slack > 0.0 {
            Decision::Fails
        } else {
            Decision::Undecided
        }
    }

    /// The amount by which the relation is violated.
    fn excess(&self) -> f64 {
        let distance = self.value.value - self.bound.value;
        match self.relation {
            // Equal infinities are no difference.
            _ if self.value.value == self.bound.value => match self.relation {
                Relation::Near(tolerance) => -tolerance,
                _ => 0.0,
            },
            Relation::AtMost => distance,
            Relation::AtLeast => -distance,
            Relation::Near(tolerance) => distance.abs() - tolerance,
        }
    }

    /// The same check with its value moved so that the decision is `wanted`, for fault injection.
    #[must_use]
    pub fn moved(&self, wanted: Decision) -> Self {
        let scale = self.bound.value.abs().max(f64::MIN_POSITIVE);
        let (step, tolerance) = match self.relation {
            Relation::Near(tolerance) => {
                (2.0 * (tolerance + self.bound.error) + 4.0 * f64::EPSILON * scale, tolerance)
            }
            _ => (0.5 * scale + 2.0 * self.bound.error, 0.0),
        };
        let outward = if self.relation == Relation::AtLeast { -1.0 } else { 1.0 };
        let value = match wanted {
            Decision::Fails => Measured::new(self.bound.value + outward * step, 0.0),
            Decision::Undecided => Measured::new(self.bound.value, 2.0 * step + tolerance),
            _ if tolerance > 0.0 => Measured::new(self.bound.value, 0.0),
            _ => Measured::new(self.bound.value - outward * step, 0.0),
        };
        Self { value, ..self.clone() }
    }

    /// Value, relation and bound: "0.9968 ≤ 1".
    pub fn comparison(&self) -> String {
        let [value, relation] = self.parts();
        format!("{value} {relation}")
    }

    /// The number, and relation with bound; or the page of a proof.
    pub(crate) fn parts(&self) -> [String; 2] {
        if let Some(page) = &self.proof {
            return ["proof".to_owned(), format!("page {page}")];
        }
        let sign = match (self.relation, self.decision()) {
            (_, Decision::Undecided) => match self.relation {
                Relation::AtMost => "≤?",
                Relation::AtLeast => "≥?",
                Relation::Near(_) => "=?",
            },
            (Relation::AtMost, Decision::Fails) => ">",
            (Relation::AtMost, _) => "≤",
            (Relation::AtLeast, Decision::Fails) => "<",
            (Relation::AtLeast, _) => "≥",
            (Relation::Near(_), Decision::Fails) => "≠",
            (Relation::Near(_), _) => "=",
        };
        let tolerance = match self.relation {
            Relation::Near(tolerance) if tolerance > 0.0 => format!(" ± {}", bound_text(tolerance)),
            _ => String::new(),
        };
        [measured_text(self.value), format!("{sign} {}{tolerance}", bound_text(self.bound.value))]
    }

    /// The claim, followed by its comparison in parentheses unless it is true by proof.
    pub fn words(&self) -> String {
        if self.proof.is_some() {
            self.claim.clone()
        } else {
            format!("{} ({})", self.claim, self.comparison())
        }
    }

    /// The check as a JSON object, with all digits of its numbers.
    pub fn json(&self) -> Value {
        let mut object = json!({
            "finding": self.key(),
            "outcome": self.decision().word(),
            "role": self.role.word(),
            "words": self.words(),
            "comparison": if self.source.is_empty() { self.comparison() } else { format!("{}, {}", self.comparison(), self.source) },
            "cases": self.cases,
        });
        match &self.proof {
            Some(page) => object["proof"] = page.as_str().into(),
            None => {
                let (relation, tolerance) = match self.relation {
                    Relation::AtMost => ("at most", None),
                    Relation::AtLeast => ("at least", None),
                    Relation::Near(tolerance) => ("within", Some(tolerance)),
                };
                let numbers = [
                    ("value", Some(self.value.value)),
                    ("uncertainty", Some(self.value.error)),
                    ("bound", Some(self.bound.value)),
                    ("tolerance", tolerance),
                ];
                object["relation"] = relation.into();
                for (key, number) in numbers.into_iter().filter_map(|(key, n)| Some((key, n?))) {
                    object[key] = if number.is_finite() { number.into() } else { number.to_string().into() };
                }
            }
        }
        object
    }

    /// The order of two cases of one check, of which the worse one is shown.
    fn is_worse_than(&self, other: &Self) -> bool {
        let order = self.decision().cmp(&other.decision());
        let margin = |check: &Self| check.excess() + check.value.error + check.bound.error;
        order.is_gt() || order.is_eq() && margin(self) > margin(other)
    }
}

/// A claim without its comparison; each method records the claim with a comparison.
#[must_use = "a claim without a comparison has no effect"]
pub struct Claim<'a> {
    checks: &'a mut Vec<Checked>,
    claim: String,
    role: Role,
}

impl<'a> Claim<'a> {
    pub(crate) fn new(checks: &'a mut Vec<Checked>, claim: String, role: Role) -> Self {
        Self { checks, claim, role }
    }

    /// Records the claim value ≤ bound; `source` is the source of the bound.
    pub fn at_most(self, value: impl Into<Measured>, bound: impl Into<Measured>, source: &str) {
        self.compared(value.into(), Relation::AtMost, bound.into(), source);
    }

    /// Records the claim value ≥ bound.
    pub fn at_least(self, value: impl Into<Measured>, bound: impl Into<Measured>, source: &str) {
        self.compared(value.into(), Relation::AtLeast, bound.into(), source);
    }

    /// Records the claim |value − expected| ≤ tolerance.
    pub fn near(
        self,
        value: impl Into<Measured>,
        expected: impl Into<Measured>,
        tolerance: f64,
        source: &str,
    ) {
        self.compared(value.into(), Relation::Near(tolerance), expected.into(), source);
    }

    /// Records a condition without a number, as number of violations ≤ 0.
    pub fn holds(self, is_true: bool, source: &str) {
        self.compared(f64::from(u8::from(!is_true)).into(), Relation::AtMost, 0.0.into(), source);
    }

    /// True by the proof on that page of the book.
    pub(crate) fn by_proof(self, page: &str) {
        let check = Checked {
            claim: self.claim,
            role: self.role,
            value: Measured::NONE,
            relation: Relation::AtMost,
            bound: Measured::NONE,
            source: String::new(),
            proof: Some(page.to_owned()),
            cases: 1,
        };
        self.checks.push(check);
    }

    fn compared(self, value: Measured, relation: Relation, bound: Measured, source: &str) {
        let mut check = Checked {
            claim: self.claim,
            role: self.role,
            value,
            relation,
            bound,
            source: source.to_owned(),
            proof: None,
            cases: 1,
        };
        match self.checks.iter_mut().find(|known| known.claim == check.claim) {
            Some(known) => {
                let cases = known.cases + 1;
                if check.is_worse_than(known) {
                    std::mem::swap(known, &mut check);
                }
                known.cases = cases;
            }
            None => self.checks.push(check),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn decided(report: impl FnOnce(Claim<'_>)) -> Checked {
        let mut checks = Vec::new();
        report(Claim::new(&mut checks, "γ ≤ 1 at ν = 1/2".to_owned(), Role::Claim));
        checks.remove(0)
    }

    #[test]
    fn errors_of_both_sides_count() {
        let at_most = |value, bound| decided(|c| c.at_most(value, bound, "")).decision();
        assert_eq!(at_most((0.9, 0.05), (1.0, 0.04)), Decision::Holds);
        assert_eq!(at_most((0.95, 0.05), (1.0, 0.01)), Decision::Undecided);
        assert_eq!(at_most((1.1, 0.05), (1.0, 0.04)), Decision::Fails);
        assert_eq!(at_most((f64::NAN, 0.0), (1.0, 0.0)), Decision::Undecided);
        assert_eq!(at_most((f64::INFINITY, 0.0), (1.0, 0.0)), Decision::Fails);
        let near = |value| decided(|c| c.near(value, 1.0, 0.1, "")).decision();
        assert_eq!([near(1.05), near(1.2)], [Decision::Holds, Decision::Fails]);
        assert_eq!(decided(|c| c.near((1.05, 0.1), 1.0, 0.1, "")).decision(), Decision::Undecided);
        assert_eq!(decided(|c| c.holds(false, "")).decision(), Decision::Fails);
    }

    #[test]
    fn of_one_sentence_the_worst_case_is_kept() {
        let mut checks = Vec::new();
        for value in [0.2, 0.9, 0.5] {
            Claim::new(&mut checks, "small".to_owned(), Role::Claim).at_most(value, 1.0, "");
        }
        assert_eq!((checks.len(), checks[0].cases, checks[0].value.value), (1, 3, 0.9));
        Claim::new(&mut checks, "small".to_owned(), Role::Claim).at_most(1.5, 1.0, "");
        Claim::new(&mut checks, "small".to_owned(), Role::Claim).at_most(0.1, 1.0, "");
        assert_eq!(checks[0].decision(), Decision::Fails);
    }

    #[test]
    fn every_relation_can_be_turned() {
        let all = [
            decided(|c| c.at_most(0.5, (1.0, 0.1), "")),
            decided(|c| c.at_least(2.0, 1.0, "")),
            decided(|c| c.near(1.0, 1.0, 1e-3, "")),
            decided(|c| c.holds(true, "")),
        ];
        for check in all {
            for wanted in [Decision::Holds, Decision::Undecided, Decision::Fails] {
                assert_eq!(check.moved(wanted).decision(), wanted, "{check:?}");
            }
        }
    }

    #[test]
    fn keys_are_letters_digits_and_hyphens() {
        assert_eq!(decided(|c| c.at_most(0.0, 1.0, "")).key(), "gamma-1-at-nu-1-2");
        assert_eq!(slug("ν = 0.25: slope"), "nu-0.25-slope");
    }
}
