//! One entry of a table: a number, a count, words, several numbers, or nothing; and how it is printed.

use serde_json::{Number, Value};

/// How a number is printed in the text form. JSON always carries all digits.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// Significant digits, plain where that is short, else with an exponent.
    Significant(usize),
    /// As few digits as identify the number: parameters that somebody chose.
    Plain,
    /// Digits after the point.
    Fixed(usize),
    /// Digits after the point, always with an exponent.
    Scientific(usize),
    /// Not in the text form, only in JSON.
    Hidden,
}

/// One entry of a table.
#[derive(Debug, Clone, PartialEq)]
pub enum Cell {
    /// A real number.
    Number(f64),
    /// A count.
    Integer(i64),
    /// Words.
    Text(String),
    /// Several numbers; appears as a JSON array.
    List(Vec<f64>),
    /// Nothing to report.
    Missing,
}

impl From<f64> for Cell {
    fn from(value: f64) -> Self {
        Cell::Number(value)
    }
}

impl Cell {
    /// A number, or nothing where it is NaN.
    pub fn finite(value: f64) -> Self {
        if value.is_nan() { Cell::Missing } else { value.into() }
    }
}

impl From<usize> for Cell {
    fn from(value: usize) -> Self {
        i64::try_from(value).map_or(Cell::Number(value as f64), Cell::Integer)
    }
}

impl From<&str> for Cell {
    fn from(value: &str) -> Self {
        Cell::Text(value.to_owned())
    }
}

impl From<String> for Cell {
    fn from(value: String) -> Self {
        Cell::Text(value)
    }
}

impl From<Vec<f64>> for Cell {
    fn from(value: Vec<f64>) -> Self {
        Cell::List(value)
    }
}

impl<T: Into<Cell>> From<Option<T>> for Cell {
    fn from(value: Option<T>) -> Self {
        value.map_or(Cell::Missing, Into::into)
    }
}

impl Cell {
    pub(crate) fn text(&self, format: Format) -> String {
        match self {
            Cell::Number(value) => number_text(*value, format),
            Cell::Integer(value) => value.to_string(),
            Cell::Text(words) => words.clone(),
            Cell::List(values) => {
                values.iter().map(|&v| number_text(v, format)).collect::<Vec<_>>().join(" ")
            }
            Cell::Missing => "-".to_owned(),
        }
    }

    /// Why there is no number: the column's reason for a missing entry; `None` where nothing is missing.
    pub(super) fn why_missing<'a>(&self, reason: &'a str) -> Option<&'a str> {
        match self {
            Cell::Missing => Some(reason),
            Cell::Number(value) if !value.is_finite() => Some("beyond the range of binary64"),
            Cell::List(values) if values.iter().any(|value| !value.is_finite()) => {
                Some("some entries are beyond the range of binary64")
            }
            _ => None,
        }
    }

    /// With all digits, for a file of comma-separated values.
    pub(super) fn csv(&self) -> String {
        match self {
            Cell::Number(value) => value.to_string(),
            Cell::Integer(value) => value.to_string(),
            Cell::Text(words) => format!("\"{}\"", words.replace('"', "\"\"")),
            Cell::List(values) => values.iter().map(f64::to_string).collect::<Vec<_>>().join(" "),
            Cell::Missing => String::new(),
        }
    }

    pub(super) fn json(&self) -> Value {
        let number = |v: f64| Number::from_f64(v).map_or(Value::Null, Value::Number);
        match self {
            Cell::Number(value) => number(*value),
            Cell::Integer(value) => Value::from(*value),
            Cell::Text(words) => Value::from(words.as_str()),
            Cell::List(values) => values.iter().map(|&v| number(v)).collect(),
            Cell::Missing => Value::Null,
        }
    }
}

fn number_text(value: f64, format: Format) -> String {
    match format {
        Format::Plain if value != 0.0 && !(1e-3..1e6).contains(&value.abs()) => format!("{value:e}"),
        Format::Plain => value.to_string(),
        Format::Fixed(digits) => format!("{value:.digits$}"),
        Format::Scientific(digits) => format!("{value:.digits$e}"),
        Format::Significant(digits) => significant(value, digits.max(1)),
        Format::Hidden => String::new(),
    }
}

/// `digits` significant digits; plain notation for magnitudes between 1e-3 and 1e6.
fn significant(value: f64, digits: usize) -> String {
    if value == 0.0 || !value.is_finite() {
        return value.to_string();
    }
    let scientific = format!("{value:.*e}", digits - 1);
    let exponent = scientific.split_once('e').and_then(|(_, e)| e.parse::<i32>().ok()).unwrap_or(0);
    if (-3..6).contains(&exponent) {
        let decimals = usize::try_from(digits as i32 - 1 - exponent).unwrap_or(0);
        format!("{value:.decimals$}")
    } else {
        scientific
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn significant_digits_switch_notation() {
        assert_eq!(significant(123.456, 4), "123.5");
        assert_eq!(significant(1.5e-7, 3), "1.50e-7");
        assert_eq!(significant(0.0, 3), "0");
    }
}
