//! The accuracy of the toolkit: every family of public functions beside values computed another way, over its range
//! of parameters. A true error d counts from what the other value may itself be off by; d over the stated error above
//! one is a proof that one of the two is wrong.

use crate::common::SplitMix;
use fractional_sobolev::{Estimate, Order, Result, Tolerance, Work};
use serde_json::Value;

mod constants;
mod norms;
mod plane;

/// What is asked of the library.
type Ask = Box<dyn Fn(Tolerance) -> Result<Estimate>>;

/// One function, or a few of one kind, over a range.
struct Family {
    /// The functions.
    name: &'static str,
    /// The least tolerance that is asked for: where digits cost a power of ten each.
    least: f64,
    /// The other value with what it may itself be off by, and the question.
    cases: Vec<(Estimate, Ask)>,
}

/// A function over a range.
#[derive(Debug, Clone)]
struct Row {
    /// Cases, and how many of them were refused.
    cases: [usize; 2],
    /// Largest true error, relative to the value.
    error: f64,
    /// That over the tolerance.
    met: f64,
    /// Largest true error beyond that of the other value, over the error promised.
    share: f64,
}

impl Family {
    /// Asks every case.
    fn row(&self, tolerance: Tolerance) -> Result<Row> {
        let tolerance = Tolerance::new(tolerance.relative().max(self.least))?;
        let mut row = Row { cases: [self.cases.len(), 0], error: 0.0, met: 0.0, share: 0.0 };
        for (exact, ask) in &self.cases {
            match ask(tolerance) {
                Ok(found) => {
                    let apart = ((found.value - exact.value).abs() - exact.error).max(0.0);
                    row.error = row.error.max(apart / exact.value.abs());
                    row.share = row.share.max(apart / found.error);
                }
                Err(_) => row.cases[1] += 1,
            }
        }
        row.met = row.error / tolerance.relative();
        Ok(row)
    }
}

/// All families, with `each` random cases where parameters are drawn.
fn families(each: usize, seed: u64) -> Result<Vec<Family>> {
    let mut random = SplitMix::new(seed);
    let mut all = norms::families(each, &mut random)?;
    all.extend(plane::families(each, &mut random)?);
    all.extend(constants::families(each, &mut random)?);
    Ok(all)
}

/// `count` cases, each drawn by `one`.
fn draw(count: usize, mut one: impl FnMut() -> Result<(Estimate, Ask)>) -> Result<Vec<(Estimate, Ask)>> {
    (0..count).map(|_| one()).collect()
}

/// A number by a formula of some ten operations.
fn formula(value: f64) -> Result<Estimate> {
    Estimate::new(value, 32.0 * f64::EPSILON * value.abs(), Work::default())
}

/// A question with an answer at hand.
fn ask(ask: impl Fn(Tolerance) -> Result<Estimate> + 'static) -> Ask {
    Box::new(ask)
}

/// An order between the two.
fn order(random: &mut SplitMix, low: f64, high: f64) -> Result<Order> {
    Order::new(random.between(low, high))
}

/// Rows of a reference file.
fn rows(text: &str) -> Result<Value> {
    Ok(serde_json::from_str(text).expect("a reference file"))
}

/// A number of such a row, written as a number or as its digits.
fn number(row: &Value, key: &str) -> Result<f64> {
    let text = row[key].as_str().map(|text| text.trim_start_matches("np.float64(").trim_end_matches(')'));
    let found = row[key].as_f64().or_else(|| text?.parse().ok());
    Ok(found.unwrap_or_else(|| panic!("no number {key} in a reference file")))
}

/// An order of such a row, by its decimal digits.
fn order_of(row: &Value, key: &str) -> Result<Order> {
    row[key].as_str().map_or_else(|| Order::new(number(row, key)?), str::parse)
}

/// A printed number of at least 16 digits.
fn printed(row: &Value, key: &str) -> Result<Estimate> {
    formula(number(row, key)?)
}

/// max |v|.
fn largest<'a>(values: impl IntoIterator<Item = &'a f64>) -> f64 {
    values.into_iter().fold(0.0, |m: f64, v| m.max(v.abs()))
}

#[test]
fn no_true_error_passes_what_is_stated() {
    for (tolerance, each, seed) in [(1e-3, 6, 2), (1e-5, 6, 3), (1e-7, 20, 1)] {
        let tolerance = Tolerance::new(tolerance).unwrap();
        let mut cases = 0;
        for family in families(each, seed).unwrap() {
            let row = family.row(tolerance).unwrap();
            assert!(
                row.share <= 1.0 && row.met <= 1.0 && row.cases[1] == 0,
                "{} to {tolerance:?}: {row:?}",
                family.name
            );
            cases += row.cases[0];
        }
        assert!(cases > 150, "{cases}");
    }
}

#[test]
fn a_function_that_is_wrong_by_twice_its_stated_error_is_seen() {
    let tolerance = Tolerance::new(1e-4).unwrap();
    for family in families(2, 1).unwrap().into_iter().filter(|family| family.least == 0.0) {
        let spoiled = family.cases.into_iter().map(|(exact, ask)| {
            let wrong = move |t: Tolerance| {
                let found = ask(t)?;
                Estimate::new(found.value + 2.0 * (found.error + exact.error), found.error, found.work)
            };
            (exact, Box::new(wrong) as Ask)
        });
        let row = Family { cases: spoiled.collect(), ..family }.row(tolerance).unwrap();
        assert!(row.share > 1.0, "{row:?}");
    }
}
