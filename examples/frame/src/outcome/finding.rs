//! A sentence of an outcome, decided by a comparison of numbers.
//!
//! A [`Finding`] holds a measured number with its uncertainty u ≥ 0 (absolute), a relation to a bound b and
//! where the bound comes from. [`Finding::outcome`] decides:
//!
//! | relation | holds | refuted |
//! | --- | --- | --- |
//! | at most b | value + u ≤ b | value − u > b |
//! | at least b | value − u ≥ b | value + u < b |
//! | within t of b | abs(value − b) + u ≤ t | abs(value − b) − u > t |
//!
//! and everything else is undecided: the uncertainty reaches across the bound, or there is no number.
//! Verdicts and the line "measured" are made from findings only. What is true by proof is marked so and is no
//! evidence.

use super::cell::not_finite;
use experiments::EstimateExt;
use serde_json::{Value, json};
use std::fmt;

/// What a comparison says of a sentence.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Outcome {
    /// The number satisfies the relation, its uncertainty included.
    Holds,
    /// The number violates the relation, its uncertainty included.
    Refuted,
    /// The uncertainty reaches across the bound, or there is no number.
    Undecided,
    /// True by proof; no number could say otherwise.
    ByProof,
}

impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Outcome::Holds => "holds",
            Outcome::Refuted => "refuted",
            Outcome::Undecided => "undecided",
            Outcome::ByProof => "by proof",
        })
    }
}

/// What a finding does to the verdict.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Role {
    /// The statement under test in the form that is true: refuted or undecided, the statement is not
    /// confirmed.
    Claim,
    /// The form the paper prints where it differs: refuted, the printed form fails.
    Printed,
    /// How far the statement is from sharp: where it holds, the statement is loose.
    Sharpness,
    /// Seen on the way; decides nothing.
    Remark,
}

impl Role {
    fn name(self) -> &'static str {
        match self {
            Role::Claim => "claim",
            Role::Printed => "printed",
            Role::Sharpness => "sharpness",
            Role::Remark => "remark",
        }
    }
}

/// How the measured number is compared with the bound.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Relation {
    /// value ≤ bound.
    AtMost,
    /// value ≥ bound.
    AtLeast,
    /// |value − bound| ≤ tolerance.
    Within(f64),
}

/// One sentence of an outcome. Built by [`Finding::claim`] and its siblings, then a number, a relation and
/// the other words:
///
/// ```
/// use example_frame::{Finding, Outcome};
/// let order = Finding::claim("order", "the error falls at least as fast as the theorem says, order {value}")
///     .number(0.752, 0.006)
///     .at_least(0.6875, "(3.1)")
///     .otherwise("the error falls more slowly than the theorem says, order {value}");
/// assert_eq!(order.outcome(), Outcome::Holds);
/// assert_eq!(order.with_number(0.69, 0.006).outcome(), Outcome::Undecided);
/// assert!(order.with_number(0.6, 0.006).words().contains("more slowly"));
/// ```
///
/// Words may hold `{value}`, `{uncertainty}` and `{bound}`, filled in when they are shown, and
/// `{count:noun}`: "no noun", "1 noun", "2 nouns". What is not finite is filled in as a word; in percent,
/// `{percent} %`, it is "an infinite multiple".
#[derive(Debug, Clone, PartialEq)]
pub struct Finding {
    key: String,
    role: Role,
    holds: String,
    refuted: String,
    undecided: String,
    number: Option<(f64, f64)>,
    missing: String,
    relation: Relation,
    bound: f64,
    source: String,
    proof: Option<&'static str>,
    told: bool,
}

impl Finding {
    fn new(role: Role, key: impl Into<String>, holds: impl Into<String>) -> Self {
        let holds = holds.into();
        Self {
            key: key.into(),
            role,
            refuted: format!("it is not so that {holds}"),
            undecided: format!("undecided whether {holds}"),
            holds,
            number: None,
            missing: "no number was computed".to_owned(),
            relation: Relation::AtMost,
            bound: f64::NAN,
            source: String::new(),
            proof: None,
            told: false,
        }
    }

    /// A sentence of the statement under test; `holds` are its words where it holds.
    pub fn claim(key: impl Into<String>, holds: impl Into<String>) -> Self {
        Self::new(Role::Claim, key, holds)
    }

    /// A sentence that the paper prints and that may fail.
    pub fn printed(key: impl Into<String>, holds: impl Into<String>) -> Self {
        Self::new(Role::Printed, key, holds)
    }

    /// A sentence that says by how much the statement is loose.
    pub fn sharpness(key: impl Into<String>, holds: impl Into<String>) -> Self {
        Self::new(Role::Sharpness, key, holds)
    }

    /// A sentence beside the statement.
    pub fn remark(key: impl Into<String>, holds: impl Into<String>) -> Self {
        Self::new(Role::Remark, key, holds)
    }

    /// The measured number and its absolute uncertainty; either may be NaN, then nothing is decided.
    #[must_use]
    pub fn number(mut self, value: f64, uncertainty: f64) -> Self {
        self.number = Some((value, uncertainty.abs()));
        self
    }

    /// The number of an [`fractional_sobolev::Estimate`] with its error.
    #[must_use]
    pub fn estimate(self, estimate: fractional_sobolev::Estimate) -> Self {
        self.number(estimate.value, estimate.error)
    }

    /// The largest of several estimates; without any there is no number.
    #[must_use]
    pub fn largest(self, estimates: impl IntoIterator<Item = fractional_sobolev::Estimate>) -> Self {
        let largest = fractional_sobolev::Estimate::largest(estimates);
        self.number_or(largest.map(|e| (e.value, e.error)), "nothing was computed")
    }

    /// The smallest of several estimates; without any there is no number.
    #[must_use]
    pub fn smallest(self, estimates: impl IntoIterator<Item = fractional_sobolev::Estimate>) -> Self {
        let smallest = fractional_sobolev::Estimate::smallest(estimates);
        self.number_or(smallest.map(|e| (e.value, e.error)), "nothing was computed")
    }

    /// The largest of several numbers with their uncertainties, each counted at its upper end; without any there
    /// is no number, and `why` says why.
    #[must_use]
    pub fn largest_of(self, numbers: impl IntoIterator<Item = (f64, f64)>, why: impl Into<String>) -> Self {
        let larger = |a: (f64, f64), b: (f64, f64)| if b.0 + b.1 > a.0 + a.1 { b } else { a };
        self.number_or(numbers.into_iter().reduce(larger), why)
    }

    /// A number that may not exist; `why` says why it does not.
    #[must_use]
    pub fn number_or(mut self, number: Option<(f64, f64)>, why: impl Into<String>) -> Self {
        self.number = number.map(|(value, uncertainty)| (value, uncertainty.abs()));
        self.missing = why.into();
        self
    }

    /// The number of an estimate that may not exist; `why` says why it does not.
    #[must_use]
    pub fn estimate_or(self, estimate: Option<fractional_sobolev::Estimate>, why: impl Into<String>) -> Self {
        self.number_or(estimate.map(|e| (e.value, e.error)), why)
    }

    /// Holds when the number is at most `bound`; `source` says where the bound comes from.
    #[must_use]
    pub fn at_most(self, bound: f64, source: impl Into<String>) -> Self {
        self.compared(Relation::AtMost, bound, source)
    }

    /// Holds when the number is at least `bound`.
    #[must_use]
    pub fn at_least(self, bound: f64, source: impl Into<String>) -> Self {
        self.compared(Relation::AtLeast, bound, source)
    }

    /// Holds when the number differs from `bound` by at most `tolerance`.
    #[must_use]
    pub fn within(self, tolerance: f64, bound: f64, source: impl Into<String>) -> Self {
        self.compared(Relation::Within(tolerance), bound, source)
    }

    fn compared(mut self, relation: Relation, bound: f64, source: impl Into<String>) -> Self {
        (self.relation, self.bound, self.source) = (relation, bound, source.into());
        self
    }

    /// The words where it is refuted. Without them: "it is not so that ...".
    #[must_use]
    pub fn otherwise(mut self, refuted: impl Into<String>) -> Self {
        self.refuted = refuted.into();
        self
    }

    /// The words where it cannot be decided. Without them: "undecided whether ...".
    #[must_use]
    pub fn undecided(mut self, undecided: impl Into<String>) -> Self {
        self.undecided = undecided.into();
        self
    }

    /// True by a proof that stands on `page` of the book (its file name without ending): shown, and no
    /// evidence.
    #[must_use]
    pub fn by_proof(mut self, page: &'static str) -> Self {
        self.proof = Some(page);
        self
    }

    /// Its words stand in the line "measured" and in the row of the tour.
    #[must_use]
    pub fn told(mut self) -> Self {
        self.told = true;
        self
    }

    /// The same finding with another number: what tests plant.
    #[must_use]
    pub fn with_number(&self, value: f64, uncertainty: f64) -> Self {
        self.clone().number(value, uncertainty)
    }

    /// The same finding without a number.
    #[must_use]
    pub fn without_number(&self) -> Self {
        Self { number: None, ..self.clone() }
    }

    /// The same finding with its number moved to where the outcome should be `outcome`; `None` for what is
    /// true by proof.
    pub fn moved(&self, outcome: Outcome) -> Option<Self> {
        if self.proof.is_some() {
            return None;
        }
        let scale = self.bound.abs().max(f64::MIN_POSITIVE);
        let step = match self.relation {
            Relation::Within(tolerance) => 2.0 * tolerance + 4.0 * f64::EPSILON * scale,
            _ => 0.5 * scale,
        };
        let beyond = match self.relation {
            Relation::AtLeast => self.bound - step,
            _ => self.bound + step,
        };
        let inside = match self.relation {
            Relation::Within(_) => self.bound,
            Relation::AtMost => self.bound - step,
            Relation::AtLeast => self.bound + step,
        };
        match outcome {
            Outcome::Holds => Some(self.with_number(inside, 0.0)),
            Outcome::Refuted => Some(self.with_number(beyond, 0.0)),
            Outcome::Undecided => Some(self.with_number(self.bound, 2.0 * step)),
            Outcome::ByProof => None,
        }
    }

    /// The decision. The only place where one is taken.
    pub fn outcome(&self) -> Outcome {
        if self.proof.is_some() {
            return Outcome::ByProof;
        }
        let Some((value, u)) = self.number else {
            return Outcome::Undecided;
        };
        let (holds, refuted) = match self.relation {
            Relation::AtMost => (value + u <= self.bound, value - u > self.bound),
            Relation::AtLeast => (value - u >= self.bound, value + u < self.bound),
            Relation::Within(t) => {
                let distance = (value - self.bound).abs();
                (distance + u <= t, distance - u > t)
            }
        };
        // Comparisons with NaN are false.
        match (holds, refuted) {
            (true, _) => Outcome::Holds,
            (_, true) => Outcome::Refuted,
            _ => Outcome::Undecided,
        }
    }

    /// Its key, unique in its example.
    pub fn key(&self) -> &str {
        &self.key
    }

    /// What it does to the verdict.
    pub fn role(&self) -> Role {
        self.role
    }

    /// Whether its words stand in the line "measured".
    pub fn is_told(&self) -> bool {
        self.told
    }

    /// Where the bound comes from.
    pub fn source(&self) -> &str {
        &self.source
    }

    /// The measured number and its uncertainty.
    pub fn measured(&self) -> Option<(f64, f64)> {
        self.number
    }

    /// The words of the outcome.
    pub fn words(&self) -> String {
        let words = match self.outcome() {
            Outcome::Holds | Outcome::ByProof => &self.holds,
            Outcome::Refuted => &self.refuted,
            Outcome::Undecided => &self.undecided,
        };
        let (value, uncertainty) = self.number.unwrap_or((f64::NAN, f64::NAN));
        let digits = |number: f64| if number.is_nan() { "?".to_owned() } else { short(number) };
        let beyond = value.is_infinite();
        counted(words, value)
            .replace("{percent} %", if beyond { "an infinite multiple" } else { "{percent} %" })
            .replace("{value}", &self.number.map_or("?".to_owned(), |(v, u)| significant(v, u, IN_WORDS)))
            .replace(
                "{uncertainty}",
                &if uncertainty > 0.0 { plain(uncertainty, 1) } else { digits(uncertainty) },
            )
            .replace("{bound}", &short(self.bound))
            .replace("{percent}", &digits(100.0 * value))
    }

    /// The comparison that decided: "0.752 +- 0.006 >= 0.6875, (3.1)", or the page of the proof.
    pub fn comparison(&self) -> String {
        if let Some(page) = self.proof {
            return format!("proof on the page {page}");
        }
        let number = match self.number {
            Some((value, u)) if u > 0.0 => format!("{} +- {}", significant(value, u, IN_ALL), plain(u, 1)),
            Some((value, u)) => significant(value, u, IN_ALL),
            None => self.missing.clone(),
        };
        let source = if self.source.is_empty() { String::new() } else { format!(", {}", self.source) };
        let nothing = self.number == Some((0.0, 0.0)) && self.bound == 0.0;
        if nothing && self.relation == Relation::AtMost {
            return format!("none{source}");
        }
        let sign = match (self.relation, self.outcome()) {
            (Relation::AtMost, Outcome::Refuted) => ">",
            (Relation::AtLeast, Outcome::Refuted) => "<",
            (Relation::AtMost, Outcome::Holds) => "<=",
            (Relation::AtLeast, Outcome::Holds) => ">=",
            (Relation::Within(_), Outcome::Holds) => "=",
            (Relation::Within(_), Outcome::Refuted) => "is not",
            (_, _) => "against",
        };
        let tolerance = match self.relation {
            Relation::Within(t) => format!(" +- {}", short(t)),
            _ => String::new(),
        };
        format!("{number} {sign} {}{tolerance}{source}", short(self.bound))
    }

    /// Everything as JSON; what there is no number for is absent, with the reason under `missing`.
    pub fn json(&self) -> Value {
        let mut object = json!({
            "finding": self.key,
            "outcome": self.outcome().to_string(),
            "role": self.role.name(),
            "words": self.words(),
            "comparison": self.comparison(),
        });
        let mut put = |key: &str, value: Value| {
            object[key] = value;
        };
        match (self.proof, self.number) {
            (Some(page), _) => put("proof", page.into()),
            (None, Some((value, uncertainty))) if value.is_finite() && uncertainty.is_finite() => {
                put("value", value.into());
                put("uncertainty", uncertainty.into());
            }
            (None, Some((value, _))) if value.is_infinite() => {
                put("missing", "the number is infinite, or beyond the range of binary64".into());
            }
            (None, Some((value, _))) if value.is_nan() => put("missing", "the number is not finite".into()),
            (None, Some((value, _))) => {
                put("value", value.into());
                put("missing", "the uncertainty is beyond the range of binary64".into());
            }
            (None, None) => put("missing", self.missing.clone().into()),
        }
        if self.proof.is_none() {
            let (relation, tolerance) = match self.relation {
                Relation::AtMost => ("at most", None),
                Relation::AtLeast => ("at least", None),
                Relation::Within(t) => ("within", Some(t)),
            };
            put("relation", relation.into());
            put("bound", not_finite(self.bound).map_or(self.bound.into(), Value::from));
            if let Some(t) = tolerance {
                put("tolerance", t.into());
            }
            put("source", self.source.clone().into());
        }
        object
    }
}

/// Words with `{count:noun}` filled in.
fn counted(words: &str, count: f64) -> String {
    let Some((before, rest)) = words.split_once("{count:") else { return words.to_owned() };
    let Some((noun, after)) = rest.split_once('}') else { return words.to_owned() };
    let phrase = match count {
        0.0 => format!("no {noun}"),
        1.0 => format!("1 {noun}"),
        _ if count.is_nan() => format!("? {noun}s"),
        _ if count.is_infinite() => format!("infinitely many {noun}s"),
        _ => format!("{count} {noun}s"),
    };
    format!("{before}{phrase}{after}")
}

/// As few digits as identify a bound, at most six significant ones.
fn short(value: f64) -> String {
    if let Some(word) = not_finite(value) {
        return word.to_owned();
    }
    let rounded: f64 = format!("{value:.5e}").parse().unwrap_or(value);
    if rounded == 0.0 || (1e-3..1e6).contains(&rounded.abs()) {
        rounded.to_string()
    } else {
        format!("{rounded:e}")
    }
}

/// Digits of a number in a sentence, and in the comparison beside it.
const IN_WORDS: usize = 6;
const IN_ALL: usize = 10;

/// The value with the digits its uncertainty leaves it, two of them doubtful at most, and no more than
/// `most`.
fn significant(value: f64, uncertainty: f64, most: usize) -> String {
    if !value.is_finite() || value == 0.0 || uncertainty == 0.0 {
        return short(value);
    }
    let magnitude = value.abs().log10().floor();
    let doubtful = uncertainty.log10().floor();
    let digits = (magnitude - doubtful + 2.0).clamp(2.0, most as f64);
    plain(value, if digits.is_finite() { digits as usize } else { 6 })
}

/// `digits` significant digits, plain between 1e-3 and 1e6.
fn plain(value: f64, digits: usize) -> String {
    crate::outcome::Cell::from(value).text(crate::outcome::Format::Significant(digits))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn claim() -> Finding {
        Finding::claim("order", "it falls, order {value}").at_least(0.5, "theory").number(0.75, 0.01)
    }

    #[test]
    fn the_three_relations_decide() {
        let decide = |f: Finding, v: f64, u: f64| f.with_number(v, u).outcome();
        let most = claim().at_most(1.0, "");
        assert_eq!(decide(most.clone(), 0.9, 0.1), Outcome::Holds);
        assert_eq!(decide(most.clone(), 0.95, 0.1), Outcome::Undecided);
        assert_eq!(decide(most, 1.2, 0.1), Outcome::Refuted);
        assert_eq!(decide(claim(), 0.45, 0.01), Outcome::Refuted);
        let near = claim().within(0.1, 1.0, "");
        assert_eq!(decide(near.clone(), 1.05, 0.04), Outcome::Holds);
        assert_eq!(decide(near.clone(), 1.05, 0.1), Outcome::Undecided);
        assert_eq!(decide(near, 0.8, 0.05), Outcome::Refuted);
    }

    #[test]
    fn no_number_decides_nothing() {
        assert_eq!(claim().without_number().outcome(), Outcome::Undecided);
        for (value, u) in [(f64::NAN, 0.0), (1.0, f64::NAN), (f64::INFINITY, f64::INFINITY)] {
            assert_eq!(claim().with_number(value, u).outcome(), Outcome::Undecided, "{value} {u}");
        }
        let unbounded = Finding::claim("a", "b").number(1.0, 0.0);
        assert_eq!(unbounded.outcome(), Outcome::Undecided, "a finding without a bound");
    }

    #[test]
    fn a_proof_is_no_evidence_and_cannot_be_moved() {
        let proved = claim().by_proof("lemma_5_2");
        assert_eq!(proved.outcome(), Outcome::ByProof);
        assert!(proved.moved(Outcome::Refuted).is_none());
    }

    #[test]
    fn moving_the_number_turns_the_outcome_for_every_relation() {
        for bound in [0.0, 1e-300, -3.0, 1e150] {
            let findings = [
                claim().at_most(bound, ""),
                claim().at_least(bound, ""),
                claim().within(1e-12 * f64::abs(bound) + 1e-12, bound, ""),
            ];
            for finding in findings {
                for wanted in [Outcome::Holds, Outcome::Refuted, Outcome::Undecided] {
                    let moved = finding.moved(wanted).unwrap();
                    assert_eq!(moved.outcome(), wanted, "{bound}: {}", moved.comparison());
                }
            }
        }
    }

    #[test]
    fn words_follow_the_number() {
        assert_eq!(claim().words(), "it falls, order 0.750");
        assert_eq!(claim().comparison(), "0.750 +- 0.01 >= 0.5, theory");
        assert_eq!(claim().without_number().comparison(), "no number was computed against 0.5, theory");
        assert!(claim().with_number(0.2, 0.0).words().starts_with("it is not so that"));
        assert_eq!(claim().json()["relation"], "at least");
        assert_eq!(claim().without_number().json()["missing"], "no number was computed");
    }

    #[test]
    fn what_is_not_finite_is_said_in_words() {
        let moved = Finding::claim("moved", "it moves by {percent} % of r, {value}, at most {bound}");
        for (value, uncertainty) in
            [(f64::INFINITY, 0.0), (f64::NAN, 0.0), (1.0, f64::INFINITY), (2.0, f64::NAN)]
        {
            for bound in [0.25, f64::INFINITY, f64::NEG_INFINITY] {
                let found = moved.clone().number(value, uncertainty).at_most(bound, "");
                let said = format!("{} {} {}", found.words(), found.comparison(), found.json());
                let plain = said.replace("infinit", "");
                assert!(
                    !plain.contains("inf") && !plain.contains("NaN") && !plain.contains("null"),
                    "{said}"
                );
            }
        }
        let words = moved.number(f64::INFINITY, 0.0).at_most(0.25, "").words();
        assert_eq!(words, "it is not so that it moves by an infinite multiple of r, infinite, at most 0.25");
    }

    #[test]
    fn counts_take_the_number_of_their_noun() {
        let count = |n: f64| {
            let left = Finding::claim("left", "{count:level} left").otherwise("{count:level} left");
            left.number(n, 0.0).at_most(0.0, "not solved")
        };
        assert_eq!(
            [0.0, 1.0, 2.0].map(|n| count(n).words()),
            ["no level left", "1 level left", "2 levels left"]
        );
        assert_eq!(count(0.0).comparison(), "none, not solved");
        assert!(count(1.0).comparison().ends_with("> 0, not solved"));
    }
}
