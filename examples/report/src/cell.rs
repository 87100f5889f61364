//! Entries of a row, and the formatting of numbers.

use crate::Measured;
use fractional_sobolev::{Estimate, Order, Tolerance};
use serde_json::{Value, json};

/// Significant digits of a number with an error, of one without, and of columns of errors, all
/// below 1e-3.
const TEN: usize = 10;
const FIVE: usize = 5;
const TWO: usize = 2;
/// Largest number of characters of a number printed in full: a column of chosen parameters is not
/// rounded if all its numbers are at most this long.
const SHORT: usize = 7;

/// An entry of a row.
#[derive(Debug, Clone, PartialEq)]
pub enum Cell {
    /// A number without an error: a parameter, or one whose error is negligible at the digits
    /// shown.
    Number(f64),
    /// A number with its error; takes two columns.
    Measured(Measured),
    /// A count.
    Integer(i64),
    /// Text.
    Text(String),
    /// A number printed by its name, such as 1/2 + 1e-12.
    Named(String, f64),
    /// Nothing to report.
    Missing,
}

impl Cell {
    /// The number with its error; [`Measured::NONE`] for text or a missing entry.
    pub fn number(&self) -> Measured {
        match self {
            Cell::Number(value) | Cell::Named(_, value) => (*value).into(),
            Cell::Measured(measured) => *measured,
            Cell::Integer(count) => (*count as f64).into(),
            Cell::Text(_) | Cell::Missing => Measured::NONE,
        }
    }

    pub(crate) fn json(&self) -> Value {
        match self {
            Cell::Integer(count) => json!(count),
            Cell::Text(words) => json!(words),
            Cell::Missing => Value::Null,
            _ => {
                let value = self.number().value;
                if value.is_finite() { json!(value) } else { json!(value.to_string()) }
            }
        }
    }

    /// The shortest text that identifies the number, for keys.
    pub(crate) fn short(&self) -> String {
        match self {
            // A hyphen stands for every sign: the minus of an exponent is spelled out.
            Cell::Text(words) | Cell::Named(words, _) => {
                crate::words::slug(&words.replace("^-", "^minus"))
            }
            other => shortest(other.number().value),
        }
    }
}

conversions! { Cell:
    f64 => Cell::Number,
    Measured => Cell::Measured,
    Estimate => |estimate: Estimate| Cell::Measured(estimate.into()),
    usize => |count: usize| i64::try_from(count).map_or(Cell::Number(count as f64), Cell::Integer),
    u32 => |count: u32| Cell::Integer(count.into()),
    i32 => |count: i32| Cell::Integer(count.into()),
    &str => |words: &str| Cell::Text(words.to_owned()),
    String => Cell::Text,
    bool => |is: bool| Cell::Text(if is { "yes" } else { "no" }.to_owned()),
    Tolerance => |tolerance: Tolerance| Cell::Number(tolerance.relative()),
    Order => |order: Order| Cell::Named(order.to_string(), order.value()),
}

impl<T: Into<Cell>> From<Option<T>> for Cell {
    fn from(value: Option<T>) -> Self {
        value.map_or(Cell::Missing, Into::into)
    }
}

/// The cells of a row: parameters and results.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Cells {
    pub(crate) about: Vec<(&'static str, Cell)>,
    pub(crate) found: Vec<(&'static str, Cell)>,
}

impl Cells {
    /// The cells with the parameters `about` and the results `found`, as built by
    /// [`crate::cells!`].
    pub fn new(about: Vec<(&'static str, Cell)>, found: Vec<(&'static str, Cell)>) -> Self {
        Self { about, found }
    }

    /// The key of the row, from its parameters: `nu0.25.theta1e-3`.
    pub fn key(&self) -> String {
        let parts: Vec<String> =
            self.about.iter().map(|(name, cell)| format!("{name}{}", cell.short())).collect();
        parts.join(".")
    }

    /// All cells with their names.
    pub(crate) fn all(&self) -> impl Iterator<Item = &(&'static str, Cell)> {
        self.about.iter().chain(&self.found)
    }

    /// The number under that name; NaN where there is none.
    pub(crate) fn number(&self, name: &str) -> f64 {
        self.get(name).map_or(f64::NAN, |cell| cell.number().value)
    }

    /// The cell of that name.
    pub(crate) fn get(&self, name: &str) -> Option<&Cell> {
        self.all().find(|(known, _)| *known == name).map(|(_, cell)| cell)
    }
}

/// The shortest text that identifies a number.
pub(crate) fn shortest(value: f64) -> String {
    let [plain, scientific] = [value.to_string(), format!("{value:e}")];
    if value.is_infinite() {
        return if value > 0.0 { "∞" } else { "−∞" }.to_owned();
    }
    if plain.len() <= SHORT.max(scientific.len()) && (value == 0.0 || value.abs() >= 1e-3) {
        plain
    } else {
        scientific
    }
}

/// The given number of significant digits, in plain notation where that is short.
pub(crate) fn significant(value: f64, digits: usize) -> String {
    if value.is_nan() {
        return "–".to_owned();
    }
    if value.is_infinite() {
        return shortest(value);
    }
    if value == 0.0 {
        return "0".to_owned();
    }
    let rounded: f64 = format!("{value:.*e}", digits - 1).parse().unwrap_or(value);
    let exponent = rounded.abs().log10().floor() as i32;
    if (-4..6).contains(&exponent) {
        let decimals = (digits as i32 - 1 - exponent).max(0) as usize;
        format!("{rounded:.decimals$}")
    } else {
        format!("{rounded:.*e}", digits - 1)
    }
}

/// The number of significant digits of a value justified by its error, two of them uncertain; at
/// most `most`.
fn digits(measured: Measured, most: usize) -> usize {
    let left = (measured.value.abs() / measured.error).log10();
    if left.is_finite() { (left.floor() as i64 + 2).clamp(1, most as i64) as usize } else { most }
}

/// A number in a check: "0.549 ± 0.007", without ± where the error is beyond the digits shown.
pub(crate) fn measured_text(measured: Measured) -> String {
    let Measured { value, error } = measured;
    if value.is_nan() {
        return "no number".to_owned();
    }
    if value.is_infinite() || error == 0.0 || error < 1e-7 * value.abs() {
        return bound_text(value);
    }
    format!("{} ± {}", significant(value, digits(measured, FIVE)), significant(error, 2))
}

/// A bound: in full if that is short, else to five digits, without trailing zeros.
pub(crate) fn bound_text(value: f64) -> String {
    let short = shortest(value);
    if value.is_nan() || short.chars().count() > SHORT {
        let text = significant(value, FIVE);
        let (mantissa, exponent) = text.split_at(text.find('e').unwrap_or(text.len()));
        let trimmed =
            if mantissa.contains('.') { mantissa.trim_end_matches('0') } else { mantissa };
        return trimmed.trim_end_matches('.').to_owned() + exponent;
    }
    short
}

/// The texts of one column; of numbers with errors two columns.
pub(crate) fn column(cells: &[&Cell]) -> Vec<Vec<String>> {
    let is_measured = cells.iter().any(|cell| matches!(cell, Cell::Measured(m) if m.error != 0.0));
    let numbers =
        || cells.iter().filter_map(|cell| if let Cell::Number(v) = cell { Some(*v) } else { None });
    let digits_of_numbers = if numbers().all(|value| value.abs() < 1e-3) { TWO } else { FIVE };
    let is_short = numbers().all(|value| shortest(value).chars().count() <= SHORT);
    let text = |cell: &&Cell| match cell {
        Cell::Number(value) if is_short && !value.is_nan() => shortest(*value),
        Cell::Number(value) => significant(*value, digits_of_numbers),
        Cell::Measured(measured) => significant(measured.value, digits(*measured, TEN)),
        Cell::Integer(count) => count.to_string(),
        Cell::Text(words) | Cell::Named(words, _) => words.clone(),
        Cell::Missing => "–".to_owned(),
    };
    let error = |cell: &&Cell| match cell {
        Cell::Measured(measured) if measured.error > 0.0 => format!("{:.0e}", measured.error),
        Cell::Measured(measured) if measured.error == 0.0 => "0".to_owned(),
        _ => String::new(),
    };
    let mut texts = vec![cells.iter().map(text).collect()];
    if is_measured {
        texts.push(cells.iter().map(error).collect());
    }
    texts
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_the_digits_their_error_leaves() {
        assert_eq!(measured_text(Measured::new(0.549_312, 0.0071)), "0.549 ± 0.0071");
        assert_eq!(measured_text(Measured::new(0.549_312, 1e-12)), "0.54931");
        assert_eq!(measured_text(3usize.into()), "3");
        let bounds = [0.01, 0.151_981_775, 1e-12, 1.0 + 1e-9].map(bound_text);
        assert_eq!(bounds, ["0.01", "0.15198", "1e-12", "1"]);
        assert_eq!(
            [significant(1.0, 5), significant(2.5e-9, 3), significant(f64::NAN, 3)],
            ["1.0000", "2.50e-9", "–"]
        );
    }

    #[test]
    fn a_column_of_parameters_is_written_as_it_stands() {
        let cells = [Cell::from(0.1), Cell::from(1e-300)];
        assert_eq!(column(&cells.iter().collect::<Vec<_>>()), [["0.1", "1e-300"]]);
        let cells = [Cell::from(1.0 / 3.0), Cell::from(0.5)];
        assert_eq!(column(&cells.iter().collect::<Vec<_>>()), [["0.33333", "0.50000"]]);
        let cells = [Cell::from(Measured::new(0.718_293_741_123_4, 2e-13))];
        assert_eq!(column(&cells.iter().collect::<Vec<_>>()), [["0.7182937411"], ["2e-13"]]);
    }
}
