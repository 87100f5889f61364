//! Finished levels in a file, so that a long study can be interrupted and taken up again.
//!
//! One line per level, appended and flushed as soon as it is done: a JSON object {"key", "level", "check"}.
//! The key names everything the level depends on; the check is a hash of key and level. A line that is torn,
//! was edited or belongs to another format is ignored, and the level is computed again. Of two lines with the
//! same key the later one counts.

use experiments::convergence::{Flag, LevelKey, LevelMemory, RateLevel};
use serde_json::{Value, json};
use signorini::{Error, Result};
use std::collections::HashMap;
use std::fs::{File, OpenOptions};
use std::io::Write;
use std::path::{Path, PathBuf};

/// Finished levels by key; in a file, or in memory only.
#[derive(Debug, Default)]
pub struct LevelStore {
    levels: HashMap<String, RateLevel>,
    file: Option<(PathBuf, File)>,
    ignored: usize,
}

impl LevelStore {
    /// Without a file: nothing outlives the run.
    pub fn in_memory() -> Self {
        Self::default()
    }

    /// In a file of this name in the directory, or in memory only without one.
    ///
    /// # Errors
    /// As [`LevelStore::open`].
    pub fn within(directory: Option<&Path>, name: &str) -> Result<Self> {
        let Some(directory) = directory else { return Ok(Self::in_memory()) };
        let store = Self::open(&directory.join(name))?;
        if store.ignored > 0 {
            eprintln!(
                "{} damaged lines of {name} are not used: their levels are computed again",
                store.ignored
            );
        }
        Ok(store)
    }

    /// The levels in `path`, which is created if need be; new ones are appended.
    ///
    /// # Errors
    /// [`Error::File`] when it cannot be read or written.
    pub fn open(path: &Path) -> Result<Self> {
        let failed = |e: std::io::Error| Error::file(path, e);
        let bytes = match std::fs::read(path) {
            Ok(bytes) => bytes,
            Err(e) if e.kind() == std::io::ErrorKind::NotFound => Vec::new(),
            Err(e) => return Err(failed(e)),
        };
        let mut file = OpenOptions::new().create(true).append(true).open(path).map_err(failed)?;
        if bytes.last().is_some_and(|&last| last != b'\n') {
            // The last line is torn: what follows must not be joined to it.
            file.write_all(b"\n").map_err(failed)?;
        }
        let mut store = Self { file: Some((path.to_owned(), file)), ..Self::default() };
        for line in bytes.split(|&byte| byte == b'\n').filter(|line| !line.is_empty()) {
            match std::str::from_utf8(line).ok().and_then(read_line) {
                Some((key, level)) => {
                    store.levels.insert(key, level);
                }
                None => store.ignored += 1,
            }
        }
        Ok(store)
    }

    /// The level with this key, if it is finished.
    fn get(&self, key: &str) -> Option<&RateLevel> {
        self.levels.get(key)
    }

    /// Keeps a finished level.
    ///
    /// # Errors
    /// [`Error::File`] when it cannot be written.
    fn insert(&mut self, key: String, level: RateLevel) -> Result<()> {
        if let Some((path, file)) = &mut self.file {
            let value = level_json(&level);
            let line = json!({"key": key, "level": value, "check": check(&key, &value)}).to_string() + "\n";
            file.write_all(line.as_bytes())
                .and_then(|()| file.flush())
                .map_err(|e| Error::file(&*path, e))?;
        }
        self.levels.insert(key, level);
        Ok(())
    }

    /// Number of finished levels.
    pub fn len(&self) -> usize {
        self.levels.len()
    }

    /// True without any.
    pub fn is_empty(&self) -> bool {
        self.levels.is_empty()
    }

    /// Lines of the file that could not be read.
    pub fn ignored(&self) -> usize {
        self.ignored
    }
}

impl LevelMemory for LevelStore {
    fn recall(&self, key: &LevelKey) -> Option<RateLevel> {
        self.get(&key.to_string()).cloned()
    }

    fn keep(&mut self, key: &LevelKey, level: &RateLevel) -> Result<()> {
        self.insert(key.to_string(), level.clone())
    }
}

/// As one JSON object, all digits.
pub fn level_json(level: &RateLevel) -> Value {
    json!({
        "cells": level.cells,
        "unknowns": level.unknowns,
        "error": level.error,
        "error_bound": level.error_bound,
        "consistency": level.consistency,
        "contact_runs": level.contact_runs,
        "kkt": level.kkt,
        "seconds": level.seconds,
        "flag": level.flag.map(|flag| flag.to_string()),
    })
}

/// Reads [`level_json`] back; `None` for anything else.
fn level_from_json(value: &Value) -> Option<RateLevel> {
    let number = |key: &str| value.get(key)?.as_f64().filter(|v| v.is_finite());
    let count = |key: &str| usize::try_from(value.get(key)?.as_u64()?).ok();
    let consistency = match value.get("consistency")? {
        Value::Null => None,
        term => Some(term.as_f64()?),
    };
    let flag = match value.get("flag")? {
        Value::Null => None,
        name => Some(Flag::ALL.into_iter().find(|flag| Some(flag.to_string().as_str()) == name.as_str())?),
    };
    Some(RateLevel {
        cells: count("cells").filter(|&cells| cells > 0)?,
        unknowns: number("unknowns")?,
        error: number("error")?,
        error_bound: number("error_bound")?,
        consistency,
        contact_runs: count("contact_runs")?,
        kkt: number("kkt")?,
        seconds: number("seconds")?,
        flag,
    })
}

fn read_line(line: &str) -> Option<(String, RateLevel)> {
    let value: Value = serde_json::from_str(line).ok()?;
    let key = value.get("key")?.as_str()?.to_owned();
    let level = value.get("level")?;
    let intact = value.get("check")?.as_str()? == check(&key, level);
    intact.then(|| level_from_json(level)).flatten().map(|level| (key, level))
}

/// FNV-1a, 64 bits, of key and level.
fn check(key: &str, level: &Value) -> String {
    let text = format!("{key} {level}");
    let hash = text.bytes().fold(0xcbf2_9ce4_8422_2325u64, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3)
    });
    format!("{hash:016x}")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn level(cells: usize) -> RateLevel {
        RateLevel {
            cells,
            unknowns: 72.0,
            error: 1.0 / 3.0,
            error_bound: 1e-16,
            consistency: Some(1e-3 / 7.0),
            contact_runs: 1,
            kkt: 2e-16,
            seconds: 1e-4,
            flag: None,
        }
    }

    #[test]
    fn levels_are_read_back_and_anything_else_is_not() {
        for flag in Flag::ALL.map(Some).into_iter().chain([None]) {
            let level = RateLevel { flag, ..level(64) };
            let text = level_json(&level).to_string();
            assert_eq!(level_from_json(&serde_json::from_str(&text).unwrap()), Some(level));
        }
        for bad in ["{}", "[1]", "{\"cells\": 0}"] {
            assert_eq!(level_from_json(&serde_json::from_str(bad).unwrap()), None);
        }
    }

    #[test]
    fn a_torn_file_loses_its_torn_line_only() {
        let path = std::env::temp_dir().join(format!("signorini-level-store-{}", std::process::id()));
        let _ = std::fs::remove_file(&path);
        let mut store = LevelStore::open(&path).unwrap();
        for cells in [8, 16, 32] {
            store.insert(format!("case {cells}"), level(cells)).unwrap();
        }
        drop(store);
        let whole = std::fs::read(&path).unwrap();
        let lines: Vec<usize> = (0..whole.len()).filter(|&i| whole[i] == b'\n').collect();
        // Cut anywhere: the levels whose lines are whole are read, and writing goes on.
        for cut in 0..=whole.len() {
            std::fs::write(&path, &whole[..cut]).unwrap();
            let mut store = LevelStore::open(&path).unwrap();
            // A line without its end of line is whole as well.
            let finished = lines.iter().filter(|&&end| end <= cut).count();
            assert_eq!(store.len(), finished, "cut at {cut}");
            assert_eq!(store.get("case 8").is_some(), finished > 0);
            if cut % 37 == 0 {
                store.insert("case 64".to_owned(), level(64)).unwrap();
                let again = LevelStore::open(&path).unwrap();
                assert_eq!((again.len(), again.get("case 64")), (finished + 1, Some(&level(64))));
            }
        }
        // A changed digit, bytes that are no text, another format.
        let mut changed = whole.clone();
        let at = whole.windows(8).position(|w| w == b"\"error\":").unwrap() + 10;
        changed[at] = if changed[at] == b'9' { b'8' } else { b'9' };
        changed.extend([0xff, 0xfe, b'\n']);
        changed.extend(b"[1, 2]\n{\"key\": \"x\"}\n");
        std::fs::write(&path, &changed).unwrap();
        let store = LevelStore::open(&path).unwrap();
        assert_eq!((store.len(), store.ignored()), (2, 4));
        std::fs::remove_file(&path).unwrap();
    }
}
