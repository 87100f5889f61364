//! Runs of examples at sizes that no check can afford.
//!
//! `large.toml` names them, a table each: `example`, `arguments`, and in `takes` memory and minutes in words.
//! `cargo book large NAME` runs one, `generated/large` keeps what it computed beside the arguments. On a page
//! the name stands where an example's would, `{{table: NAME}}`. Neither `cargo book` nor `cargo book check`
//! runs them again: kept outcomes whose arguments are no longer those of the file are a fault, and tests of
//! the library compute their small sizes anew.

use crate::data::Data;
use crate::error::{Error, Fault, Result, read};
use crate::examples::{self, Run};
use crate::layout::Layout;
use crate::stale::Named;
use serde_json::Value;
use std::path::Path;

/// The file below the directory of the book.
pub const FILE: &str = "large.toml";

/// All runs; none where there is no file.
///
/// # Errors
/// [`Error::Data`] with what is wrong in the file.
pub fn list(book: &Path) -> Result<Vec<Run>> {
    let path = book.join(FILE);
    if !path.exists() {
        return Ok(Vec::new());
    }
    let wrong = |message: String| Error::Data { path: path.clone(), message };
    let parsed: Value = toml::from_str(&read(&path)?).map_err(|e| wrong(e.to_string()))?;
    let run = |(name, entry): (&String, &Value)| {
        let text = |key: &str| {
            let text = entry[key].as_str().map(str::to_owned);
            text.ok_or_else(|| wrong(format!("{name}: `{key}` is missing")))
        };
        Ok(Run {
            name: name.clone(),
            example: text("example")?,
            arguments: text("arguments")?,
            takes: text("takes")?,
        })
    };
    parsed.as_object().into_iter().flatten().map(run).collect()
}

/// Words of kept findings that the same example does not say now: names of checks, sources of bounds, roles. `now`
/// holds the default runs of the examples.
pub fn other_words(runs: &[Run], kept: &Data, now: &Data) -> Vec<Fault> {
    let mut found = Vec::new();
    let findings = |data: &Data, name: &str| -> Vec<Value> {
        let list = data.examples.get(name).and_then(|outcome| outcome["findings"].as_array());
        list.cloned().unwrap_or_default()
    };
    let said = |finding: &Value| {
        let named = finding.as_object().map(Named::of);
        named.map(|named| [named.claim, named.source].map(str::to_owned))
    };
    for run in runs.iter().filter(|run| now.examples.contains_key(&run.example)) {
        let now = findings(now, &run.example);
        for old in findings(kept, &run.name) {
            let same = |new: &&Value| said(new) == said(&old) && new["role"] == old["role"];
            if !now.iter().any(|new| same(&new)) {
                let what = format!("{} does not say so now: `cargo book large`", run.example);
                let file = Path::new("book/generated/large/values.json");
                found.push(Fault::new(file, 1, what, said(&old).unwrap_or_default().join(": ")));
            }
        }
    }
    found
}

/// Runs that were not made with the arguments of the file, and outcomes of none.
pub fn faults(runs: &[Run], kept: &Data) -> Vec<Fault> {
    let file = Path::new("book").join(FILE);
    let as_written = |run: &&Run| {
        kept.examples
            .get(&run.name)
            .is_some_and(|outcome| outcome["arguments"] == run.arguments.as_str())
    };
    let missing = runs.iter().filter(|run| !as_written(run)).map(|run| {
        let what = format!("not run with these arguments: `cargo book large {}`", run.name);
        Fault::new(&file, 1, what, &run.arguments)
    });
    let unknown = kept.examples.keys().filter(|name| !runs.iter().any(|run| run.name == **name));
    let unknown =
        unknown.map(|name| Fault::new(&file, 1, "an outcome of no run in this file", name));
    missing.chain(unknown).collect()
}

/// Makes a run; all runs that are kept, with what this one computed.
///
/// # Errors
/// [`Error::Data`] for a name that `large.toml` does not hold, those of examples.
pub fn renew(layout: &Layout, name: &str) -> Result<Data> {
    let runs = list(&layout.book)?;
    let names: Vec<&str> = runs.iter().map(|run| run.name.as_str()).collect();
    let wrong = |message: String| Error::Data { path: layout.book.join(FILE), message };
    let run = runs.iter().find(|run| run.name == name);
    let run = run.ok_or_else(|| wrong(format!("no run {name}: {}", names.join(", "))))?;
    eprintln!("{} {}: {}", run.example, run.arguments, run.takes);
    let outcome = examples::with_arguments(&layout.repository, run)?;
    let mut kept = Data::read(&layout.large())?;
    kept.examples.retain(|name, _| name != &run.name && names.contains(&name.as_str()));
    kept.figures.retain(|figure, _| !figure.starts_with(&format!("{name}/")));
    kept.series.retain(|figure, _| !figure.starts_with(&format!("{name}/")));
    kept.extend(outcome);
    if let Some(outcome) = kept.examples.get_mut(name) {
        outcome["arguments"] = run.arguments.as_str().into();
    }
    Ok(kept)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error::write;

    #[test]
    fn words_of_a_large_run_are_those_of_its_example() {
        let run = |name: &str, source: &str| {
            let comparison = format!("0.1 ≤ 1, {source}");
            let mut data = Data::default();
            data.examples.insert(
                name.into(),
                serde_json::json!({"findings": [{"words": "order (0.1 ≤ 1)", "comparison": comparison}]}),
            );
            data
        };
        let text = |name: &str| name.to_owned();
        let runs = [Run {
            name: text("fine"),
            example: text("ex"),
            arguments: text(""),
            takes: text("hours"),
        }];
        let kept = run("fine", "(3.1)");
        assert_eq!(other_words(&runs, &kept, &run("ex", "(3.1)")), []);
        let found = other_words(&runs, &kept, &run("ex", "Theorem 3.1"));
        assert!(found.len() == 1 && found[0].to_string().contains("order: (3.1)"), "{found:?}");
    }

    #[test]
    fn arguments_that_changed_and_outcomes_of_no_run_are_faults() {
        let book = tempfile::tempdir().unwrap();
        assert_eq!(list(book.path()).unwrap(), Vec::new());
        let text = "[fine]\nexample = 'ex'\narguments = '--levels 2-11'\ntakes = 'ten minutes'\n";
        write(&book.path().join(FILE), text).unwrap();
        let runs = list(book.path()).unwrap();
        let mut kept = Data::default();
        let messages =
            |kept: &Data| faults(&runs, kept).iter().map(ToString::to_string).collect::<Vec<_>>();
        assert_eq!(
            messages(&kept),
            [
                "book/large.toml:1: not run with these arguments: `cargo book large fine`: `--levels 2-11`"
            ]
        );
        kept.examples.insert("fine".into(), serde_json::json!({"arguments": "--levels 2-11"}));
        assert_eq!(messages(&kept), Vec::<String>::new());
        kept.examples.insert("gone".into(), serde_json::json!({"arguments": ""}));
        assert_eq!(
            messages(&kept),
            ["book/large.toml:1: an outcome of no run in this file: `gone`"]
        );
        kept.examples["fine"]["arguments"] = "--levels 2-9".into();
        assert_eq!(messages(&kept).len(), 2);
        write(&book.path().join(FILE), "[fine]\nexample = 'ex'\n").unwrap();
        assert!(
            list(book.path()).unwrap_err().to_string().contains("fine: `arguments` is missing")
        );
    }
}
