//! What may be asked of an example, as it describes itself (`--describe`), and the arguments that a request
//! becomes.
//!
//! Only declared options are known, each value is checked by its kind before it is handed on, always as one
//! argument `--name=value`. No kind holds a slash, a dot alone, a quote or a space, so that nothing names a
//! file.

use serde_json::{Map, Value};

/// Longest value of an option, in bytes.
const LONGEST: usize = 200;
/// Most entries of a list.
const ENTRIES: usize = 16;
/// Finest level that may be asked for: 2 to this power cells.
const FINEST: u32 = 20;

/// Options of an example: name, kind, default and the rest, in the order of its help text.
pub fn declared(description: &Value) -> &[Value] {
    description["options"].as_array().map_or(&[], Vec::as_slice)
}

/// The arguments for what was asked, in the order of the declaration; what equals its default is left out.
///
/// # Errors
/// In words, the first option that is not declared or whose value is not of its kind.
pub fn arguments(description: &Value, asked: &Map<String, Value>) -> Result<Vec<String>, String> {
    let options = declared(description);
    for name in asked.keys() {
        if !options.iter().any(|option| option["name"] == name.as_str()) {
            return Err("an option that the example does not declare".to_owned());
        }
    }
    let mut arguments = Vec::new();
    for option in options {
        let name = option["name"].as_str().unwrap_or("");
        let Some(value) = asked.get(name) else { continue };
        let value = value.as_str().ok_or_else(|| format!("{name}: not a text"))?.trim();
        if value.is_empty() || value == option["default"].as_str().unwrap_or("") {
            continue;
        }
        check(option, value).map_err(|what| format!("{name}: {what}"))?;
        match option["kind"].as_str() {
            Some("flag") if value == "true" => arguments.push(format!("--{name}")),
            Some("flag") => {}
            _ => arguments.push(format!("--{name}={value}")),
        }
    }
    Ok(arguments)
}

/// Whether a value is of the kind of its option.
fn check(option: &Value, value: &str) -> Result<(), String> {
    if value.len() > LONGEST {
        return Err("too long".to_owned());
    }
    if option["list"] == true {
        let entries: Vec<&str> = value.split(',').map(str::trim).collect();
        if entries.len() > ENTRIES {
            return Err(format!("more than {ENTRIES} entries"));
        }
        return entries.into_iter().try_for_each(|entry| one(option, entry));
    }
    one(option, value)
}

fn one(option: &Value, value: &str) -> Result<(), String> {
    let choices = || option["choices"].as_array().into_iter().flatten().filter_map(Value::as_str);
    let is_choice = |word: &str| choices().any(|choice| choice == word);
    let expected = || choices().collect::<Vec<_>>().join(", ");
    match option["kind"].as_str().unwrap_or("") {
        "flag" => matches!(value, "true" | "false").then_some(()).ok_or("true or false".to_owned()),
        "number" => number(value).and_then(|x| in_range(option, x)),
        "integer" => {
            let is_integer =
                !value.is_empty() && value.len() < 16 && value.bytes().all(|b| b.is_ascii_digit());
            if !is_integer {
                return Err("not a natural number".to_owned());
            }
            number(value).and_then(|x| in_range(option, x))
        }
        "order" => match value.strip_prefix("1/2") {
            Some("") => Ok(()),
            Some(offset) if offset.starts_with(['+', '-']) => number(offset).map(drop),
            _ => number(value).and_then(|x| in_range(option, x)),
        },
        "tolerance" => match value {
            "fast" | "balanced" | "reference" => Ok(()),
            _ => number(value).map(drop),
        },
        "levels" => levels(value),
        "choice" if is_choice(value) => Ok(()),
        "named" => {
            let mut words = value.split(':');
            if !words.next().is_some_and(is_choice) {
                return Err(format!("one of {}", expected()));
            }
            words.try_for_each(|word| number(word).map(drop))
        }
        "place" if is_choice(value) => Ok(()),
        "place" => number(value).and_then(|x| in_range(option, x)),
        _ => Err(format!("one of {}", expected())),
    }
}

/// A finite number, written with digits, signs, a point and an exponent.
fn number(text: &str) -> Result<f64, String> {
    let is_plain =
        text.bytes().all(|b| b.is_ascii_digit() || matches!(b, b'+' | b'-' | b'.' | b'e' | b'E'));
    let value = text.parse::<f64>().ok().filter(|value| is_plain && value.is_finite());
    value.ok_or_else(|| "not a number".to_owned())
}

fn in_range(option: &Value, value: f64) -> Result<(), String> {
    let [Some(low), Some(high)] = [0, 1].map(|k| option["range"][k].as_f64()) else {
        return Ok(());
    };
    if low <= value && value <= high { Ok(()) } else { Err(format!("not within {low} and {high}")) }
}

/// COARSEST-FINEST.
fn levels(text: &str) -> Result<(), String> {
    let level = |word: &str| word.parse::<u32>().ok().filter(|&k| word.len() < 3 && k <= FINEST);
    let ends = text.split_once('-').and_then(|(a, b)| Some((level(a)?, level(b)?)));
    match ends {
        Some((coarsest, finest)) if coarsest <= finest => Ok(()),
        _ => Err(format!("two levels such as 3-9, up to {FINEST}")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn description() -> Value {
        json!({"options": [
            {"name": "tau", "kind": "number", "list": false, "default": "1.75", "range": [1.5, 2.5]},
            {"name": "nu", "kind": "order", "list": true, "default": "0.5", "range": [0.0, 1.0]},
            {"name": "n", "kind": "integer", "list": false, "default": "32", "range": [1.0, 4096.0]},
            {"name": "tolerance", "kind": "tolerance", "list": false, "default": "balanced"},
            {"name": "levels", "kind": "levels", "list": false, "default": "3-9"},
            {"name": "cone", "kind": "choice", "list": false, "default": "nodal", "choices": ["nodal", "midpoint"]},
            {"name": "scene", "kind": "named", "list": false, "default": "", "choices": ["cantor", "transition"]},
            {"name": "zone", "kind": "place", "list": false, "default": "end", "choices": ["end", "centre"]},
            {"name": "lines", "kind": "flag", "list": false, "default": ""},
        ]})
    }

    fn asked(name: &str, value: &str) -> Result<Vec<String>, String> {
        let map = [(name.to_owned(), json!(value))].into_iter().collect();
        arguments(&description(), &map)
    }

    #[test]
    fn values_of_their_kind_become_single_arguments() {
        let good = [
            ("tau", "1.6"),
            ("nu", "0.25,1/2-1e-8,1/2"),
            ("n", "64"),
            ("tolerance", "1e-6|fast"),
            ("levels", "4-12"),
            ("cone", "midpoint"),
            ("scene", "cantor:0.3:12"),
            ("zone", "0.25|centre"),
        ];
        for (name, value) in
            good.into_iter().flat_map(|(name, all)| all.split('|').map(move |v| (name, v)))
        {
            assert_eq!(asked(name, value), Ok(vec![format!("--{name}={value}")]), "{name} {value}");
        }
        assert_eq!(asked("lines", "true"), Ok(vec!["--lines".to_owned()]));
        assert_eq!(asked("tau", "1.75"), Ok(vec![]));
        assert_eq!(asked("tau", ""), Ok(vec![]));
    }
}
