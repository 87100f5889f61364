//! Is committed data still what the examples compute? Compared as written, up to the last digits: processors
//! and threads differ there. Times and counts of solver steps are not compared.

use crate::data::Data;
use serde_json::Value;
use std::collections::BTreeSet;

/// Relative difference that counts as equal: far above the accuracy the examples converge to (1e-8 at worst),
/// far below the digits a page quotes.
const RELATIVE: f64 = 1e-6;
/// Below this both numbers are rounding errors (residuals, balances) and carry no digits.
const ROUNDING: f64 = 1e-10;
/// Units of the last written digit by which texts and drawings may differ.
const LAST_DIGIT: f64 = 2.0;

/// Something committed that is no longer computed so.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Stale {
    /// File below `generated`.
    pub file: String,
    /// Which entry.
    pub entry: String,
    /// What was committed and what was computed.
    pub what: String,
}

/// What of `committed` differs from `computed`. Figures are compared where they are committed.
pub fn compare(committed: &Data, computed: &Data) -> Vec<Stale> {
    let mut found = Vec::new();
    let values =
        |entry: String, what: String| Stale { file: "values.json".to_owned(), entry, what };
    for (name, new) in &computed.examples {
        let Some(old) = committed.examples.get(name) else {
            found.push(values(name.clone(), "computed and not committed".to_owned()));
            continue;
        };
        let mut differences = Vec::new();
        difference(name, old, new, &mut differences);
        found.extend(differences.into_iter().map(|(entry, what)| values(entry, what)));
    }
    for name in committed.examples.keys().filter(|name| !computed.examples.contains_key(*name)) {
        found.push(values(name.clone(), "committed and no longer computed".to_owned()));
    }
    for name in committed.options.keys().chain(computed.options.keys()).collect::<BTreeSet<_>>() {
        if committed.options.get(name) != computed.options.get(name) {
            let (file, what) =
                ("options.json".to_owned(), "not what the example describes now".to_owned());
            found.push(Stale { file, entry: name.clone(), what });
        }
    }
    for (name, old) in committed.series.iter().filter(|(name, _)| !is_timed(name)) {
        if !computed.series.get(name).is_some_and(|new| same_text(old, new)) {
            let (file, what) = (format!("figures/{name}.csv"), "other numbers now".to_owned());
            found.push(Stale { file, entry: name.clone(), what });
        }
    }
    for (name, old) in &committed.figures {
        let what = match computed.figures.get(name) {
            None => "committed and no longer drawn",
            Some(new) if !is_timed(name) && !same_text(old, new) => "drawn differently now",
            Some(_) => continue,
        };
        found.push(Stale {
            file: format!("figures/{name}.svg"),
            entry: name.clone(),
            what: what.to_owned(),
        });
    }
    found
}

/// What was computed, with committed entries in place of those that say the same: other seconds and last
/// digits change no file.
pub fn kept(committed: &Data, mut computed: Data) -> Data {
    let stale = compare(committed, &computed);
    let is_same = |file: &str, name: &str| {
        let is_part = |entry: &str| {
            entry == name || entry.strip_prefix(name).is_some_and(|r| r.starts_with('/'))
        };
        !stale.iter().any(|stale| stale.file == file && is_part(&stale.entry))
    };
    for (name, old) in &committed.examples {
        if let Some(new) = computed.examples.get_mut(name).filter(|_| is_same("values.json", name))
        {
            new.clone_from(old);
        }
    }
    let pairs = [
        (&committed.figures, &mut computed.figures, "svg"),
        (&committed.series, &mut computed.series, "csv"),
    ];
    for (old, new, end) in pairs {
        for (name, old) in old {
            let file = format!("figures/{name}.{end}");
            if let Some(new) = new.get_mut(name).filter(|_| is_same(&file, name)) {
                new.clone_from(old);
            }
        }
    }
    computed
}

/// Keys, columns and figures that hold times, memory or solver steps have a word `seconds`, `ms`, `speedup`,
/// `iterations`, `steps`, `peak` (words joined by `.`, `_`, `-`).
pub fn is_timed(key: &str) -> bool {
    key.split(['.', '_', '-', '/', ' '])
        .any(|word| matches!(word, "seconds" | "ms" | "speedup" | "iterations" | "steps" | "peak"))
}

fn difference(path: &str, old: &Value, new: &Value, found: &mut Vec<(String, String)>) {
    let mut differs = || found.push((path.to_owned(), format!("committed {old}, computed {new}")));
    // The path begins with the name of the example, which may have such a word.
    let inside = path.split_once('/').map_or("", |(_, inside)| inside);
    match (old, new) {
        _ if is_timed(inside) => {}
        (Value::Number(a), Value::Number(b)) => {
            if !same_number(a.as_f64().unwrap_or(f64::NAN), b.as_f64().unwrap_or(f64::NAN)) {
                differs();
            }
        }
        (Value::String(a), Value::String(b)) if same_text(a, b) => {}
        (Value::Array(a), Value::Array(b)) if a.len() == b.len() => {
            for (k, (a, b)) in a.iter().zip(b).enumerate() {
                difference(&format!("{path}/{k}"), a, b, found);
            }
        }
        (Value::Object(a), Value::Object(b))
            if a.contains_key("finding") && b.contains_key("finding") =>
        {
            // Words and comparison repeat numbers with fewer digits; what else they say is compared.
            for key in ["finding", "outcome", "role", "relation", "bound", "value"] {
                let is_timed = matches!(key, "outcome" | "bound" | "value")
                    && a["finding"].as_str().is_some_and(is_timed);
                let entry = |map: &serde_json::Map<String, Value>| {
                    map.get(key).cloned().unwrap_or(Value::Null)
                };
                if !is_timed {
                    difference(&format!("{path}/{key}"), &entry(a), &entry(b), found);
                }
            }
            let (old, new) = (Named::of(a), Named::of(b));
            for (key, old, new) in
                [("words", old.claim, new.claim), ("comparison", old.source, new.source)]
            {
                if old != new {
                    let what = format!("committed \"{old}\", computed \"{new}\"");
                    found.push((format!("{path}/{key}"), what));
                }
            }
        }
        (Value::Object(a), Value::Object(b)) if a.keys().eq(b.keys()) => {
            let timed = timed_columns(a);
            for (key, a) in a {
                if key == "rows" {
                    difference(
                        &format!("{path}/rows"),
                        &without(a, &timed),
                        &without(&b["rows"], &timed),
                        found,
                    );
                } else {
                    difference(&format!("{path}/{key}"), a, &b[key], found);
                }
            }
        }
        (a, b) if a == b => {}
        _ => differs(),
    }
}

/// What a finding says without its numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Named<'a> {
    /// The name of the check: the words without the numbers in brackets behind them.
    pub claim: &'a str,
    /// Where the bound is from, or for what the corrected form is true: what the comparison says behind its numbers.
    pub source: &'a str,
}

impl<'a> Named<'a> {
    /// The words of a finding of `values.json`; empty where it has none.
    pub fn of(finding: &'a serde_json::Map<String, Value>) -> Self {
        let text = |key: &str| finding.get(key).and_then(Value::as_str).unwrap_or("");
        let (words, comparison) = (text("words"), text("comparison"));
        let source = comparison.split_once(", ").map_or("", |(_, source)| source);
        let numbers = words.strip_suffix(')').and_then(|words| words.rsplit_once(" ("));
        let claim = match numbers {
            Some((claim, numbers)) if comparison.starts_with(numbers) => claim,
            _ => words,
        };
        Self { claim, source }
    }
}

/// Places of the columns that hold times.
fn timed_columns(headline: &serde_json::Map<String, Value>) -> Vec<usize> {
    let columns = headline.get("columns").and_then(Value::as_array);
    let is_timed = |column: &Value| column["key"].as_str().is_some_and(is_timed);
    columns
        .into_iter()
        .flatten()
        .enumerate()
        .filter_map(|(k, column)| is_timed(column).then_some(k))
        .collect()
}

fn without(rows: &Value, columns: &[usize]) -> Value {
    let kept = |row: &Value| -> Value {
        let cells = row.as_array().into_iter().flatten().enumerate();
        cells.filter(|(k, _)| !columns.contains(k)).map(|(_, cell)| cell.clone()).collect()
    };
    rows.as_array().into_iter().flatten().map(kept).collect()
}

fn same_number(a: f64, b: f64) -> bool {
    let size = a.abs().max(b.abs());
    a == b || size <= ROUNDING || (a - b).abs() <= RELATIVE * size
}

/// The same words, and numbers that agree up to their last written digits.
fn same_text(a: &str, b: &str) -> bool {
    let (a, b) = (tokens(a), tokens(b));
    let is_time = |k: usize| a.get(k + 1).is_some_and(|after| is_seconds(after));
    a.len() == b.len()
        && a.iter().zip(&b).enumerate().all(|(k, (a, b))| {
            a == b
                || match (a.parse::<f64>(), b.parse::<f64>()) {
                    (Ok(x), Ok(y)) => {
                        let slack = LAST_DIGIT * last_digit(a).max(last_digit(b));
                        is_time(k) || same_number(x, y) || (x - y).abs() <= slack * (1.0 + 1e-9)
                    }
                    _ => false,
                }
        })
}

/// What follows a number says that it counted seconds, as in "10 rows in 3 s".
fn is_seconds(after: &str) -> bool {
    after.strip_prefix(" s").is_some_and(|rest| !rest.starts_with(char::is_alphanumeric))
}

/// Numbers and what stands between them.
fn tokens(text: &str) -> Vec<&str> {
    let bytes = text.as_bytes();
    let digit = |k: usize| bytes.get(k).is_some_and(u8::is_ascii_digit);
    let mut found = Vec::new();
    let (mut at, mut from) = (0, 0);
    while at < bytes.len() {
        let signed = bytes[at] == b'-' && digit(at + 1);
        if !digit(at) && !signed {
            at += 1;
            continue;
        }
        let start = at;
        at += 1;
        while digit(at) || (bytes.get(at) == Some(&b'.') && digit(at + 1)) {
            at += 1;
        }
        let sign = usize::from(matches!(bytes.get(at + 1), Some(b'-' | b'+')));
        if bytes.get(at) == Some(&b'e') && digit(at + 1 + sign) {
            at += 1 + sign;
            while digit(at) {
                at += 1;
            }
        }
        if from < start {
            found.push(&text[from..start]);
        }
        found.push(&text[start..at]);
        from = at;
    }
    if from < text.len() {
        found.push(&text[from..]);
    }
    found
}

/// The size of one unit of the last written digit. An integer of up to two digits is a count and must agree.
fn last_digit(number: &str) -> f64 {
    let (mantissa, exponent) = number.split_once('e').unwrap_or((number, "0"));
    let decimals = mantissa.split_once('.').map_or(0, |(_, fraction)| fraction.len());
    if decimals == 0 && exponent == "0" && mantissa.trim_start_matches('-').len() < 3 {
        return 0.0;
    }
    10f64.powi(exponent.parse::<i32>().unwrap_or(0) - decimals as i32)
}

#[cfg(test)]
#[path = "stale_tests.rs"]
mod tests;
