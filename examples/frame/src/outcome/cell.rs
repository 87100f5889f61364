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
    /// Several numbers; appears as a JSON array, in the text form with its first ones only where it is long.
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
                let all = if values.len() <= LONG { values.len() } else { SHOWN };
                let more = values.len() - all;
                let rest = (more > 0 && format != Format::Hidden).then(|| format!("and {more} more"));
                let shown = values[..all].iter().map(|&v| number_text(v, format));
                shown.chain(rest).collect::<Vec<_>>().join(" ")
            }
            Cell::Missing => NOTHING.to_owned(),
        }
    }

    /// Why there is no number: the column's reason for a missing entry; `None` where nothing is missing.
    pub(super) fn why_missing<'a>(&self, reason: &'a str) -> Option<&'a str> {
        match self {
            Cell::Missing => Some(reason),
            Cell::Number(value) if value.is_nan() => Some("no number: undefined for these values"),
            Cell::Number(value) if value.is_infinite() => Some("infinite, or beyond the range of binary64"),
            Cell::List(values) if values.iter().any(|value| !value.is_finite()) => {
                Some("some entries are infinite, undefined, or beyond the range of binary64")
            }
            _ => None,
        }
    }

    /// With all digits, for a file of comma-separated values; nothing where there is no number, a word where
    /// it is infinite.
    pub(super) fn csv(&self) -> String {
        let number = |value: f64| not_finite(value).map_or(value.to_string(), str::to_owned);
        match self {
            Cell::Number(value) if value.is_nan() => String::new(),
            Cell::Number(value) => number(*value),
            Cell::Integer(value) => value.to_string(),
            Cell::Text(words) => format!("\"{}\"", words.replace('"', "\"\"")),
            Cell::List(values) => values.iter().map(|&v| number(v)).collect::<Vec<_>>().join(" "),
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

/// What stands for no number.
const NOTHING: &str = "-";
/// A list with more numbers than these is cut in the text form, after so many: pairs stay together.
const LONG: usize = 16;
const SHOWN: usize = 8;

/// The word for what is not finite.
pub(super) fn not_finite(value: f64) -> Option<&'static str> {
    match value {
        _ if value.is_nan() => Some(NOTHING),
        f64::INFINITY => Some("infinite"),
        f64::NEG_INFINITY => Some("minus infinity"),
        _ => None,
    }
}

fn number_text(value: f64, format: Format) -> String {
    if let Some(word) = not_finite(value).filter(|_| format != Format::Hidden) {
        return word.to_owned();
    }
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
    if value == 0.0 {
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

    #[test]
    fn what_is_not_finite_has_a_word_in_every_form() {
        for format in [Format::Significant(3), Format::Plain, Format::Fixed(2), Format::Scientific(1)] {
            let text = |value: f64| Cell::Number(value).text(format);
            assert_eq!(
                [f64::INFINITY, f64::NEG_INFINITY, f64::NAN].map(text),
                ["infinite", "minus infinity", "-"]
            );
        }
        let list = Cell::List(vec![1.0, f64::INFINITY, f64::NAN]);
        assert_eq!([list.text(Format::Plain), list.csv()], ["1 infinite -"; 2]);
        assert_eq!([f64::INFINITY, f64::NAN].map(|v| Cell::Number(v).csv()), ["infinite", ""]);
        assert!(list.why_missing("").is_some() && Cell::Number(f64::NAN).why_missing("").is_some());
        assert!(Cell::Number(f64::MAX).why_missing("").is_none());
    }

    #[test]
    fn a_long_list_is_cut_in_the_text_and_whole_in_json() {
        let list = |count: u32| Cell::List((0..count).map(f64::from).collect());
        assert!(list(16).text(Format::Plain).ends_with("14 15"));
        assert_eq!(list(200).text(Format::Plain), "0 1 2 3 4 5 6 7 and 192 more");
        assert_eq!(list(200).json().as_array().map(Vec::len), Some(200));
        assert_eq!(list(200).csv().split(' ').count(), 200);
    }
}
