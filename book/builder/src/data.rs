//! What the examples computed: headlines by example, figures by example and name.
//!
//! `book/generated/values.json` holds one object per example, as the examples' option `--values` writes them;
//! `book/generated/options.json` what may be asked of each (`--describe`),
//! `book/generated/figures/EXAMPLE/NAME.svg` the figures that pages show, `NAME.csv` the numbers behind a
//! chart. A key on a page is `example/key`, or `key` alone where only one example has it.

use crate::error::{Error, Result, read, write};
use serde_json::{Map, Value};
use std::collections::BTreeMap;
use std::path::Path;

/// Everything the examples computed.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Data {
    /// One object per example: label, claim, measured, verdict, confirmed, values, columns, rows.
    pub examples: Map<String, Value>,
    /// One object per example: about, cost, options.
    pub options: Map<String, Value>,
    /// SVG text by `example/name`.
    pub figures: BTreeMap<String, String>,
    /// Numbers behind charts, comma-separated, by `example/name`.
    pub series: BTreeMap<String, String>,
}

/// Why a key could not be resolved.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Unknown {
    /// No example has it.
    Missing,
    /// Several examples have it; the page must say which.
    Ambiguous(Vec<String>),
    /// The example has these.
    Others(Vec<String>),
}

impl Unknown {
    /// In words, for a fault; `what` is the kind of key.
    pub fn words(&self, what: &str) -> String {
        match self {
            Unknown::Missing => format!("unknown {what} (does `cargo book` need to be run?)"),
            Unknown::Ambiguous(examples) => {
                format!("{what} of several examples ({}), write `example/key`", examples.join(", "))
            }
            Unknown::Others(keys) => format!("unknown {what}, the example has {}", keys.join(", ")),
        }
    }
}

impl Data {
    /// Reads `values.json` and the figures below `directory`; an absent directory is empty data.
    ///
    /// # Errors
    /// [`Error::File`], [`Error::Damaged`].
    pub fn read(directory: &Path) -> Result<Self> {
        let mut data = Self::default();
        let path = directory.join("values.json");
        if path.exists() {
            data.examples = parse_object(&path, &read(&path)?)?;
        }
        let path = directory.join("options.json");
        if path.exists() {
            data.options = parse_object(&path, &read(&path)?)?;
        }
        let figures = directory.join("figures");
        for name in names(&figures)? {
            for file in names(&figures.join(&name))? {
                data.insert(&name, &figures.join(&name), &file)?;
            }
        }
        Ok(data)
    }

    /// Replaces everything of an example by what it computed now.
    pub fn renew(&mut self, example: &str, now: Self) {
        let is_of = |name: &String| name.split('/').next() == Some(example);
        self.figures.retain(|name, _| !is_of(name));
        self.series.retain(|name, _| !is_of(name));
        self.extend(now);
    }

    /// Takes up all of another collection.
    pub(crate) fn extend(&mut self, other: Self) {
        self.examples.extend(other.examples);
        self.options.extend(other.options);
        self.figures.extend(other.figures);
        self.series.extend(other.series);
    }

    /// Takes up a figure, or the numbers behind one, of an example.
    pub(crate) fn insert(&mut self, example: &str, directory: &Path, file: &str) -> Result<()> {
        let (map, stem) = match file.rsplit_once('.') {
            Some((stem, "svg")) => (&mut self.figures, stem),
            Some((stem, "csv")) => (&mut self.series, stem),
            _ => return Ok(()),
        };
        map.insert(format!("{example}/{stem}"), read(&directory.join(file))?);
        Ok(())
    }

    /// Writes `values.json` and the figures below `directory`; figures that are no longer there are removed.
    ///
    /// # Errors
    /// [`Error::File`].
    pub fn write(&self, directory: &Path) -> Result<()> {
        for (file, map) in [("values.json", &self.examples), ("options.json", &self.options)] {
            let mut text = String::new();
            push_json(&mut text, &Value::Object(map.clone()), 0);
            write(&directory.join(file), text + "\n")?;
        }
        let figures = directory.join("figures");
        if figures.exists() {
            std::fs::remove_dir_all(&figures)
                .map_err(|source| Error::File { path: figures.clone(), source })?;
        }
        for (name, svg) in &self.figures {
            write(&figures.join(format!("{name}.svg")), svg)?;
        }
        for (name, csv) in &self.series {
            write(&figures.join(format!("{name}.csv")), csv)?;
        }
        Ok(())
    }

    /// The number under `example/key`, or under `key` where that is one example's alone.
    ///
    /// # Errors
    /// [`Unknown`].
    pub fn value(&self, key: &str) -> std::result::Result<f64, Unknown> {
        let number = |example: &Value, key: &str| example["values"][key].as_f64();
        if let Some((example, key)) = key.split_once('/') {
            let example = self.examples.get(example).ok_or(Unknown::Missing)?;
            return number(example, key).ok_or(Unknown::Missing);
        }
        let found: Vec<(&String, f64)> = self
            .examples
            .iter()
            .filter_map(|(name, example)| Some((name, number(example, key)?)))
            .collect();
        match found.as_slice() {
            [] => Err(Unknown::Missing),
            [(_, value)] => Ok(*value),
            _ => Err(Unknown::Ambiguous(found.iter().map(|(name, _)| (*name).clone()).collect())),
        }
    }

    /// The figure under `example/name`, or under `name` where that is one example's alone.
    ///
    /// # Errors
    /// [`Unknown`].
    pub fn figure(&self, name: &str) -> std::result::Result<(&str, &str), Unknown> {
        let same =
            |full: &str| full == name || full.split_once('/').is_some_and(|(_, n)| n == name);
        let found: Vec<(&str, &str)> = self
            .figures
            .iter()
            .filter(|(full, _)| same(full))
            .map(|(full, svg)| (full.as_str(), svg.as_str()))
            .collect();
        match found.as_slice() {
            [] => Err(Unknown::Missing),
            [one] => Ok(*one),
            _ => {
                Err(Unknown::Ambiguous(found.iter().map(|(full, _)| (*full).to_owned()).collect()))
            }
        }
    }

    /// The finding under `example/key`: an object with `outcome`, `words`, `comparison`.
    ///
    /// # Errors
    /// [`Unknown`].
    pub fn finding(&self, key: &str) -> std::result::Result<&Value, Unknown> {
        let (example, key) = key.split_once('/').ok_or(Unknown::Missing)?;
        let findings = self
            .examples
            .get(example)
            .and_then(|e| e["findings"].as_array())
            .ok_or(Unknown::Missing)?;
        findings.iter().find(|finding| finding["finding"] == key).ok_or_else(|| {
            let keys = findings.iter().filter_map(|finding| finding["finding"].as_str());
            Unknown::Others(keys.map(|key| format!("`{key}`")).collect())
        })
    }

    /// A text of an example's headline: `label`, `claim`, `measured` or `verdict`.
    pub fn text(&self, example: &str, field: &str) -> Option<&str> {
        self.examples.get(example)?[field].as_str()
    }
}

/// Parses one JSON object; `path` is named when it is none.
pub(crate) fn parse_object(path: &Path, text: &str) -> Result<Map<String, Value>> {
    serde_json::from_str(text).map_err(|e| Error::Damaged {
        path: path.to_owned(),
        line: e.line().max(1),
        message: e.to_string(),
    })
}

/// JSON with one entry of an object per line, and arrays of plain values and innermost objects on one line:
/// changes show line by line.
fn push_json(text: &mut String, value: &Value, depth: usize) {
    let is_plain = |v: &Value| !v.is_array() && !v.is_object();
    let (open, close, entries): (char, char, Vec<(String, &Value)>) = match value {
        Value::Object(map) => (
            '{',
            '}',
            map.iter().map(|(k, v)| (format!("{}: ", Value::from(k.as_str())), v)).collect(),
        ),
        Value::Array(list) => ('[', ']', list.iter().map(|v| (String::new(), v)).collect()),
        plain => return text.push_str(&plain.to_string()),
    };
    let in_one_line = depth > 2 && entries.iter().all(|(_, v)| is_plain(v)) || entries.is_empty();
    let (indent, gap) =
        if in_one_line { (String::new(), " ") } else { ("  ".repeat(depth + 1), "\n") };
    text.push(open);
    for (k, (key, entry)) in entries.iter().enumerate() {
        let comma = if k > 0 { "," } else { "" };
        let gap = if in_one_line && k == 0 { "" } else { gap };
        text.push_str(&format!("{comma}{gap}{indent}{key}"));
        push_json(text, entry, depth + 1);
    }
    if !in_one_line {
        text.push_str(&format!("\n{}", "  ".repeat(depth)));
    }
    text.push(close);
}

/// The names in a directory, sorted; an absent directory has none.
pub(crate) fn names(directory: &Path) -> Result<Vec<String>> {
    if !directory.exists() {
        return Ok(Vec::new());
    }
    let failed = |source| Error::File { path: directory.to_owned(), source };
    let mut found = Vec::new();
    for entry in std::fs::read_dir(directory).map_err(failed)? {
        found.push(entry.map_err(failed)?.file_name().to_string_lossy().into_owned());
    }
    found.sort();
    Ok(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn data() -> Data {
        let text = r#"{"a": {"values": {"x": 1.5, "own": 2}, "findings": [{"finding": "small"}]},
            "b": {"values": {"x": 3}, "verdict": "holds"}}"#;
        Data {
            examples: parse_object(Path::new("test"), text).unwrap(),
            options: parse_object(Path::new("test"), r#"{"a": {"options": []}}"#).unwrap(),
            figures: [("a/f".to_owned(), "<svg/>".to_owned())].into(),
            series: [("a/f".to_owned(), "x,y\n".to_owned())].into(),
        }
    }

    #[test]
    fn one_example_is_renewed() {
        let mut data = data();
        let text = r#"{"a": {"values": {"x": 7}}}"#;
        let examples = parse_object(Path::new("test"), text).unwrap();
        let figures = [("a/g".to_owned(), "<svg/>".to_owned())].into();
        data.renew("a", Data { examples, figures, ..Data::default() });
        assert_eq!([data.value("a/x"), data.value("b/x")], [Ok(7.0), Ok(3.0)]);
        assert!(data.figure("a/g").is_ok() && data.figure("a/f").is_err());
        assert!(data.series.is_empty() && data.options.contains_key("a"));
    }

    #[test]
    fn keys_are_resolved_and_ambiguity_is_refused() {
        let data = data();
        assert_eq!(data.value("own"), Ok(2.0));
        assert_eq!(data.value("a/x"), Ok(1.5));
        assert_eq!(data.value("x"), Err(Unknown::Ambiguous(vec!["a".into(), "b".into()])));
        assert_eq!(data.value("c/x"), Err(Unknown::Missing));
        assert_eq!(data.value("nothing"), Err(Unknown::Missing));
        assert_eq!(data.figure("f"), Ok(("a/f", "<svg/>")));
        assert_eq!(data.figure("b/f"), Err(Unknown::Missing));
        assert_eq!(data.text("b", "verdict"), Some("holds"));
        let unknown = data.finding("a/smal").unwrap_err().words("finding");
        assert_eq!(unknown, "unknown finding, the example has `small`");
        assert!(data.finding("a/small").is_ok());
    }
}
