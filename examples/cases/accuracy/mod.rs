//! What `accuracy_table` asks: every family of public functions of the toolkit beside values computed another
//! way, over its range of parameters.

use experiments::SplitMix;
use fractional_sobolev::{Error, Estimate, Order, Result, Tolerance, Work};
use serde_json::Value;
use std::time::Instant;

mod constants;
mod norms;
mod plane;

/// What is asked of the library.
pub type Ask = Box<dyn Fn(Tolerance) -> Result<Estimate>>;

/// One function, or a few of one kind, over a range.
pub struct Family {
    /// The name in the picture.
    pub name: &'static str,
    /// The public functions.
    pub functions: &'static str,
    /// The range of the parameters.
    pub range: &'static str,
    /// How the other value is computed.
    pub by: &'static str,
    /// The least tolerance that is asked for: where digits cost a power of ten each.
    pub least: f64,
    /// The other value with what it may itself be off by, and the question.
    pub cases: Vec<(Estimate, Ask)>,
}

/// A function over a range.
#[derive(Debug, Clone)]
pub struct Row {
    /// The name in the picture, the functions, the range, and the road to the other values.
    pub words: [&'static str; 4],
    /// Cases, and how many of them were refused.
    pub cases: [usize; 2],
    /// Largest true error, relative to the value.
    pub error: f64,
    /// That over the tolerance.
    pub met: f64,
    /// Largest true error beyond that of the other value, over the error promised.
    pub share: f64,
    /// Seconds of all cases, and of the slowest.
    pub seconds: [f64; 2],
}

impl Family {
    /// Asks every case.
    pub fn row(&self, tolerance: Tolerance) -> Result<Row> {
        let tolerance = Tolerance::new(tolerance.relative().max(self.least))?;
        let words = [self.name, self.functions, self.range, self.by];
        let mut row =
            Row { words, cases: [self.cases.len(), 0], error: 0.0, met: 0.0, share: 0.0, seconds: [0.0; 2] };
        for (exact, ask) in &self.cases {
            let start = Instant::now();
            let found = ask(tolerance);
            let passed = start.elapsed().as_secs_f64();
            row.seconds = [row.seconds[0] + passed, row.seconds[1].max(passed)];
            match found {
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
pub fn families(each: usize, seed: u64) -> Result<Vec<Family>> {
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

/// The refusal of a reference file.
fn unreadable(given: String) -> Error {
    Error::UnknownName { what: "content of a file in tests/reference", given, expected: "numbers by name" }
}

/// Rows of a reference file.
fn rows(text: &str) -> Result<Value> {
    serde_json::from_str(text).map_err(|error| unreadable(error.to_string()))
}

/// A number of such a row, written as a number or as its digits.
fn number(row: &Value, key: &str) -> Result<f64> {
    let text = row[key].as_str().map(|text| text.trim_start_matches("np.float64(").trim_end_matches(')'));
    let found = row[key].as_f64().or_else(|| text?.parse().ok());
    found.ok_or_else(|| unreadable(format!("no number {key}")))
}

/// An order of such a row, by its decimal digits.
fn order_of(row: &Value, key: &str) -> Result<Order> {
    row[key].as_str().map_or_else(|| Order::new(number(row, key)?), str::parse)
}

/// A printed number of at least 16 digits.
fn printed(row: &Value, key: &str) -> Result<Estimate> {
    formula(number(row, key)?)
}
