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
    /// The mark at the beginning of the printed line, and the name in the JSON output.
    pub(crate) fn mark_and_word(self) -> (char, &'static str) {
        match self {
            Decision::ByProof => ('∎', "by proof"),
            Decision::Holds => ('✓', "holds"),
            Decision::Undecided => ('?', "undecided"),
            Decision::Fails => ('✗', "fails"),
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
    /// None: the claim is proved on that page of the book.
    Proof(&'static str),
}

/// A claim with the comparison that decides it.
#[derive(Debug, Clone)]
pub struct Checked {
    /// The claim.
    pub claim: String,
    /// The effect of the check on the status of the statement.
    pub role: Role,
    /// The number that is compared, with its error.
    pub value: Measured,
    relation: Relation,
    bound: Measured,
    /// Another plausible outcome.
    alternative: Option<f64>,
    /// The source of the bound.
    pub source: String,
    /// The number of times it was reported.
    pub(crate) cases: usize,
}

impl Checked {
    /// The claim in letters, digits and hyphens: the key under which a page quotes the check.
    pub fn key(&self) -> String {
        slug(&self.claim)
    }

    /// The result of the comparison.
    pub fn decision(&self) -> Decision {
        if let Relation::Proof(_) = self.relation {
            return Decision::ByProof;
        }
        let slack = self.value.error + self.bound.error;
        let excess = self.excess();
        // Comparisons with NaN are false.
        if excess + slack <= 0.0 {
            if self.admits_alternative() { Decision::Undecided } else { Decision::Holds }
        } else if excess - slack > 0.0 {
            Decision::Fails
        } else {
            Decision::Undecided
        }
    }

    /// Whether the relation does not exclude the other plausible outcome, with the error of this
    /// value; an outcome at the end of the tolerance is not excluded.
    fn admits_alternative(&self) -> bool {
        const ROUNDED: f64 = 1e-9;
        let Some(other) = self.alternative else { return false };
        let relation = match self.relation {
            Relation::Near(tolerance) => Relation::Near(tolerance * (1.0 + ROUNDED)),
            relation => relation,
        };
        let value = Measured::new(other, self.value.error);
        let other = Self { value, relation, alternative: None, ..self.clone() };
        other.decision() != Decision::Fails
    }

    /// The amount by which the relation is violated.
    fn excess(&self) -> f64 {
        // Equal infinities are no difference.
        let is_equal = self.value.value == self.bound.value;
        let distance = if is_equal { 0.0 } else { self.value.value - self.bound.value };
        match self.relation {
            Relation::AtMost | Relation::Proof(_) => distance,
            Relation::AtLeast => -distance,
            Relation::Near(tolerance) => distance.abs() - tolerance,
        }
    }

    /// The same check with its value moved so that the decision is `wanted`, for fault injection.
    #[must_use]
    pub(crate) fn moved(&self, wanted: Decision) -> Self {
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
        Self { value, alternative: None, ..self.clone() }
    }

    /// Value, relation and bound: "0.9968 ≤ 1".
    pub(crate) fn comparison(&self) -> String {
        let [value, relation] = self.parts();
        format!("{value} {relation}")
    }

    /// The number, and relation with bound; or the page of a proof.
    pub(crate) fn parts(&self) -> [String; 2] {
        let signs = match self.relation {
            Relation::AtMost => ["≤", "≤?", ">"],
            Relation::AtLeast => ["≥", "≥?", "<"],
            Relation::Near(_) => ["=", "=?", "≠"],
            Relation::Proof(page) => return ["proof".to_owned(), format!("page {page}")],
        };
        let sign = match self.decision() {
            Decision::ByProof | Decision::Holds => signs[0],
            Decision::Undecided => signs[1],
            Decision::Fails => signs[2],
        };
        let tolerance = match self.relation {
            Relation::Near(tolerance) if tolerance > 0.0 => format!(" ± {}", bound_text(tolerance)),
            _ => String::new(),
        };
        [measured_text(self.value), format!("{sign} {}{tolerance}", bound_text(self.bound.value))]
    }

    /// The claim, followed by its comparison in parentheses unless it is true by proof.
    pub fn words(&self) -> String {
        match self.relation {
            Relation::Proof(_) => self.claim.clone(),
            _ => format!("{} ({})", self.claim, self.comparison()),
        }
    }

    /// The check as a JSON object, with all digits of its numbers.
    pub(crate) fn json(&self) -> Value {
        let mut comparison = self.comparison();
        if !self.source.is_empty() {
            comparison = format!("{comparison}, {}", self.source);
        }
        let mut object = json!({
            "finding": self.key(),
            "outcome": self.decision().mark_and_word().1,
            "role": self.role.word(),
            "words": self.words(),
            "comparison": comparison,
            "cases": self.cases,
        });
        let relation = match self.relation {
            Relation::AtMost => "at most",
            Relation::AtLeast => "at least",
            Relation::Near(_) => "within",
            Relation::Proof(page) => {
                object["proof"] = page.into();
                return object;
            }
        };
        object["relation"] = relation.into();
        let number =
            |value: f64| if value.is_finite() { value.into() } else { value.to_string().into() };
        object["value"] = number(self.value.value);
        object["uncertainty"] = number(self.value.error);
        object["bound"] = number(self.bound.value);
        if let Relation::Near(tolerance) = self.relation {
            object["tolerance"] = number(tolerance);
        }
        if let Some(alternative) = self.alternative {
            object["alternative"] = number(alternative);
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

/// A number that carries no error, so that a comparison of two of them is true or false.
pub trait WithoutError: Into<Measured> {}

impl WithoutError for f64 {}
impl WithoutError for usize {}

/// A claim without its comparison; each method records the claim with a comparison.
#[must_use = "a claim without a comparison has no effect"]
pub struct Claim<'a> {
    checks: &'a mut Vec<Checked>,
    claim: String,
    role: Role,
    alternative: Option<f64>,
}

impl<'a> Claim<'a> {
    pub(crate) fn new(checks: &'a mut Vec<Checked>, claim: String, role: Role) -> Self {
        Self { checks, claim, role, alternative: None }
    }

    /// The same claim, whose tolerance must rule out this other plausible outcome: unless the
    /// comparison fails for that one, with the same error, the check is undecided. For tolerances
    /// that depend on the data, as the next term of an expansion.
    pub fn undecided_if_also_true_of(self, alternative: f64) -> Self {
        Self { alternative: Some(alternative), ..self }
    }

    /// Records the claim value ≤ bound of two numbers without errors; `source` is the source of the
    /// bound.
    pub fn at_most(self, value: impl WithoutError, bound: impl WithoutError, source: &str) {
        self.whole_error_bars_at_most(value, bound, source);
    }

    /// Records the claim value ≥ bound of two numbers without errors.
    pub fn at_least(self, value: impl WithoutError, bound: impl WithoutError, source: &str) {
        self.whole_error_bars_at_least(value, bound, source);
    }

    /// Records the claim |value − expected| ≤ tolerance of two numbers without errors.
    pub fn differ_by_at_most(
        self,
        value: impl WithoutError,
        expected: impl WithoutError,
        tolerance: f64,
        source: &str,
    ) {
        self.whole_error_bars_differ_by_at_most(value, expected, tolerance, source);
    }

    /// Records the claim value ≤ bound, the value with an error u, the bound with an error w: holds
    /// if all of value ± u is at most all of bound ± w, that is value + u ≤ bound − w; fails if all
    /// of it is larger, value − u > bound + w; else undecided.
    pub fn whole_error_bars_at_most(
        self,
        value: impl Into<Measured>,
        bound: impl Into<Measured>,
        source: &str,
    ) {
        self.record(value.into(), Relation::AtMost, bound.into(), source);
    }

    /// Records the claim value ≥ bound: holds if value − u ≥ bound + w, fails if value + u < bound
    /// − w, else undecided.
    pub fn whole_error_bars_at_least(
        self,
        value: impl Into<Measured>,
        bound: impl Into<Measured>,
        source: &str,
    ) {
        self.record(value.into(), Relation::AtLeast, bound.into(), source);
    }

    /// Records the claim |value − expected| ≤ tolerance: holds if |value − expected| + u + w ≤
    /// tolerance, fails if |value − expected| − u − w > tolerance, else undecided.
    pub fn whole_error_bars_differ_by_at_most(
        self,
        value: impl Into<Measured>,
        expected: impl Into<Measured>,
        tolerance: f64,
        source: &str,
    ) {
        self.record(value.into(), Relation::Near(tolerance), expected.into(), source);
    }

    /// Records a condition without a number, as number of violations ≤ 0.
    pub fn holds(self, is_true: bool, source: &str) {
        self.at_most(if is_true { 0.0 } else { 1.0 }, 0.0, source);
    }

    /// True by the proof on that page of the book.
    pub(crate) fn by_proof(self, page: &'static str) {
        self.record(Measured::NONE, Relation::Proof(page), Measured::NONE, "");
    }

    fn record(self, value: Measured, relation: Relation, bound: Measured, source: &str) {
        let Self { checks, claim, role, alternative } = self;
        let source = source.to_owned();
        let mut check =
            Checked { claim, role, value, relation, bound, alternative, source, cases: 1 };
        match checks.iter_mut().find(|known| known.claim == check.claim) {
            Some(known) => {
                check.cases = known.cases + 1;
                known.cases = check.cases;
                if check.is_worse_than(known) {
                    *known = check;
                }
            }
            None => checks.push(check),
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
        let at_most =
            |value, bound| decided(|c| c.whole_error_bars_at_most(value, bound, "")).decision();
        assert_eq!(at_most((0.9, 0.05), (1.0, 0.04)), Decision::Holds);
        assert_eq!(at_most((0.95, 0.05), (1.0, 0.01)), Decision::Undecided);
        assert_eq!(at_most((1.1, 0.05), (1.0, 0.04)), Decision::Fails);
        assert_eq!(at_most((f64::NAN, 0.0), (1.0, 0.0)), Decision::Undecided);
        assert_eq!(at_most((f64::INFINITY, 0.0), (1.0, 0.0)), Decision::Fails);
        let near = |value| decided(|c| c.differ_by_at_most(value, 1.0, 0.1, "")).decision();
        assert_eq!([near(1.05), near(1.2)], [Decision::Holds, Decision::Fails]);
        assert_eq!(
            decided(|c| c.whole_error_bars_differ_by_at_most((1.05, 0.1), 1.0, 0.1, "")).decision(),
            Decision::Undecided
        );
        assert_eq!(decided(|c| c.holds(false, "")).decision(), Decision::Fails);
        // A tolerance that admits another outcome decides nothing; a violation stays one.
        let against = |value, tolerance| {
            decided(|c| {
                c.undecided_if_also_true_of(0.0).differ_by_at_most(value, 1.0, tolerance, "")
            })
            .decision()
        };
        assert_eq!([against(0.9, 0.2), against(0.9, 1.0)], [Decision::Holds, Decision::Undecided]);
        assert_eq!(against(3.0, 1.0), Decision::Fails);
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
}
