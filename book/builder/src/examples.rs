//! Runs every example of the library at its default size and collects what it computed.
//!
//! An outcome is kept in `target/book-cache` beside a stamp of the program that computed it, so that only
//! examples whose program changed run again.

use crate::data::{Data, names, parse_object};
use crate::error::{Error, Result, read, write};
use serde_json::Value;
use std::hash::{DefaultHasher, Hasher};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::atomic::{AtomicUsize, Ordering};

/// Examples that run side by side at most: each may use all processors and some hundred megabytes.
const MOST_BESIDE: usize = 4;

/// Builds the examples of the package at `repository` and runs those whose program changed: those of which
/// `committed` holds no seconds side by side, the others alone afterwards, so that nothing disturbs a clock.
///
/// # Errors
/// [`Error::Example`] when one does not build or run, [`Error::File`].
pub fn gather(repository: &Path, committed: &Data) -> Result<Data> {
    let programs = build(repository)?;
    let mut changed = Vec::new();
    for (k, program) in programs.iter().enumerate() {
        let (name, cache, stamp) = (name(program), cache(program), stamp(program)?);
        if !read(&cache.join("stamp")).is_ok_and(|known| known == stamp) {
            changed.push((k + 1, program, name, cache, stamp));
        }
    }
    let renew = |(k, program, name, cache, stamp): &(usize, &PathBuf, String, PathBuf, String)| {
        eprintln!("[{k}/{}] {name}", programs.len());
        run(name, program, &[], cache)?;
        write(&cache.join("stamp"), stamp)
    };
    let (beside, alone): (Vec<_>, Vec<_>) = changed
        .iter()
        .partition(|(_, _, name, ..)| committed.examples.get(name).is_some_and(has_no_clock));
    let next = AtomicUsize::new(0);
    let work = || -> Result<()> {
        while let Some(one) = beside.get(next.fetch_add(1, Ordering::Relaxed)) {
            renew(one).inspect_err(|_| next.store(beside.len(), Ordering::Relaxed))?;
        }
        Ok(())
    };
    let workers = std::thread::available_parallelism().map_or(1, usize::from).min(MOST_BESIDE);
    std::thread::scope(|scope| {
        let handles: Vec<_> = (0..workers).map(|_| scope.spawn(work)).collect();
        let failed =
            |_| Error::Example { name: "(a run)".to_owned(), message: "broke off".to_owned() };
        handles.into_iter().try_for_each(|handle| handle.join().map_err(failed)?)
    })?;
    alone.into_iter().try_for_each(renew)?;
    let mut data = Data::default();
    for program in &programs {
        let name = name(program);
        collect(&name, &cache(program), &mut data)?;
        data.options.insert(name.clone(), describe(&name, program)?);
    }
    Ok(data)
}

fn name(program: &Path) -> String {
    program.file_stem().unwrap_or_default().to_string_lossy().into_owned()
}

/// Where the outcome of a program is kept.
fn cache(program: &Path) -> PathBuf {
    cache_directory(program).join(name(program))
}

/// No key, column or sentence of an outcome speaks of time.
fn has_no_clock(outcome: &Value) -> bool {
    let silent = |sentence: &str| {
        let words: Vec<&str> = sentence.split_whitespace().collect();
        let counts = |pair: &[&str]| {
            pair[0].parse::<f64>().is_ok() && pair[1].trim_end_matches([',', '.']) == "s"
        };
        let mut parts = sentence.split(|c: char| !c.is_alphanumeric());
        !words.windows(2).any(counts)
            && !parts.any(|word| matches!(word, "seconds" | "ms" | "speedup"))
    };
    match outcome {
        Value::String(words) => silent(words),
        Value::Array(entries) => entries.iter().all(has_no_clock),
        Value::Object(entries) => {
            entries.iter().all(|(key, entry)| silent(key) && has_no_clock(entry))
        }
        _ => true,
    }
}

/// An example with arguments.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Run {
    /// Where an example's name would stand.
    pub name: String,
    /// The example.
    pub example: String,
    /// As on the command line.
    pub arguments: String,
    /// Memory and minutes.
    pub takes: String,
}

/// Builds the examples and makes one run with arguments of its own; what it computed, under the run's name.
///
/// # Errors
/// [`Error::Example`] when the example is not there, does not build or run, [`Error::File`].
pub fn with_arguments(repository: &Path, run: &Run) -> Result<Data> {
    let failed =
        |message: &str| Error::Example { name: run.example.clone(), message: message.to_owned() };
    let programs = build(repository)?;
    let program = programs
        .iter()
        .find(|program| program.file_stem().is_some_and(|stem| stem == &*run.example));
    let program = program.ok_or_else(|| failed("is not there"))?;
    let cache = cache_directory(program).join("large").join(&run.name);
    let arguments: Vec<&str> = run.arguments.split_whitespace().collect();
    self::run(&run.example, program, &arguments, &cache)?;
    let mut data = Data::default();
    collect(&run.name, &cache, &mut data)?;
    Ok(data)
}

/// Builds one example and runs it: what it computed, and its options.
///
/// # Errors
/// As for [`gather`].
pub fn one(repository: &Path, name: &str) -> Result<Data> {
    let programs = built(repository, &["--example", name])?;
    let failed = || Error::Example { name: name.to_owned(), message: "is not there".to_owned() };
    let program = programs.first().ok_or_else(failed)?;
    run(name, program, &[], &cache(program))?;
    write(&cache(program).join("stamp"), stamp(program)?)?;
    let mut data = Data::default();
    collect(name, &cache(program), &mut data)?;
    data.options.insert(name.to_owned(), describe(name, program)?);
    Ok(data)
}

/// Builds all examples in release and returns their programs, sorted by name.
///
/// # Errors
/// [`Error::Example`] when one does not build.
pub fn build(repository: &Path) -> Result<Vec<PathBuf>> {
    built(repository, &["--examples"])
}

/// Builds the examples that these arguments of Cargo name.
fn built(repository: &Path, which: &[&str]) -> Result<Vec<PathBuf>> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let failed = |message: String| Error::Example { name: "(cargo build)".to_owned(), message };
    let output = Command::new(cargo)
        .current_dir(repository)
        .args(["build", "--release", "--package", "signorini"])
        .args(which)
        .args(["--message-format", "json-render-diagnostics"])
        .stderr(Stdio::inherit())
        .output()
        .map_err(|e| failed(e.to_string()))?;
    if !output.status.success() {
        return Err(failed("failed, see above".to_owned()));
    }
    let mut programs: Vec<PathBuf> = String::from_utf8_lossy(&output.stdout)
        .lines()
        .filter_map(|line| serde_json::from_str::<Value>(line).ok())
        .filter(|message| message["target"]["kind"][0] == "example")
        .filter_map(|message| message["executable"].as_str().map(PathBuf::from))
        .collect();
    programs.sort();
    Ok(programs)
}

/// `target/book-cache` for `target/release/examples/name`.
fn cache_directory(program: &Path) -> PathBuf {
    let target = program.ancestors().nth(3).unwrap_or(Path::new("target"));
    target.join("book-cache")
}

/// Changes whenever the program does.
fn stamp(program: &Path) -> Result<String> {
    let bytes = std::fs::read(program)
        .map_err(|source| Error::File { path: program.to_owned(), source })?;
    let mut hasher = DefaultHasher::new();
    hasher.write(&bytes);
    Ok(format!("{:016x} {}", hasher.finish(), bytes.len()))
}

/// Runs one example; its headline and figures go to `cache`.
fn run(name: &str, program: &Path, arguments: &[&str], cache: &Path) -> Result<()> {
    let failed = |message: String| Error::Example { name: name.to_owned(), message };
    if cache.exists() {
        std::fs::remove_dir_all(cache)
            .map_err(|source| Error::File { path: cache.to_owned(), source })?;
    }
    write(&cache.join("headline.json"), "")?; // makes the directory too
    let output = Command::new(program)
        .args(arguments)
        .arg("--values")
        .arg(cache.join("headline.json"))
        .arg("--out")
        .arg(cache.join("figures"))
        .output()
        .map_err(|e| failed(e.to_string()))?;
    // 1 says that the statement was not confirmed: an outcome like any other, carried by the verdict.
    match output.status.code() {
        Some(0 | 1) => Ok(()),
        _ => Err(failed(String::from_utf8_lossy(&output.stderr).trim().to_owned())),
    }
}

/// What may be asked of an example, as it says itself.
fn describe(name: &str, program: &Path) -> Result<Value> {
    let failed = |message: String| Error::Example { name: name.to_owned(), message };
    let output =
        Command::new(program).arg("--describe").output().map_err(|e| failed(e.to_string()))?;
    serde_json::from_slice(&output.stdout).map_err(|e| failed(format!("--describe: {e}")))
}

fn collect(name: &str, cache: &Path, data: &mut Data) -> Result<()> {
    let path = cache.join("headline.json");
    let headline = parse_object(&path, &read(&path)?)?;
    if headline.get("confirmed") == Some(&Value::Bool(false)) {
        eprintln!("{name}: {}", headline["verdict"].as_str().unwrap_or("not confirmed"));
    }
    data.examples.insert(name.to_owned(), Value::Object(headline));
    let figures = cache.join("figures");
    for file in names(&figures)? {
        data.insert(name, &figures, &file)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn what_speaks_of_time_runs_alone() {
        for outcome in [
            json!({"table": {"columns": ["n", "seconds"], "rows": [[1, 2.0]]}}),
            json!({"multigrid.seconds": 3.0}),
            json!({"verdict": "1000 rows in 3.2 s, in the plane"}),
            json!({"findings": [{"finding": "speedup.fast"}]}),
        ] {
            assert!(!has_no_clock(&outcome), "{outcome}");
        }
        let outcome = json!({"order": 0.5, "meaning": "C (1-s)^2, below 1 s^2", "table": {"columns": ["n", "steps"], "rows": [[1, 2]]}});
        assert!(has_no_clock(&outcome));
    }
}
