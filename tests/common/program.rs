//! Examples as programs, which `cargo test` builds before the tests.

use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::atomic::{AtomicUsize, Ordering};

/// The program: tests are target/PROFILE/deps/TEST, programs target/PROFILE/examples/NAME.
pub fn program(name: &str) -> Command {
    let test = std::env::current_exe().unwrap();
    let file = format!("{name}{}", std::env::consts::EXE_SUFFIX);
    let found = test.parent().and_then(Path::parent).unwrap().join("examples").join(file);
    assert!(found.exists(), "{} is not built: cargo build --release --examples", found.display());
    Command::new(found)
}

/// Names of all examples.
#[allow(dead_code, reason = "each target uses a part")]
pub fn names() -> Vec<String> {
    let directory = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let files = std::fs::read_dir(directory)
        .unwrap()
        .map(|entry| PathBuf::from(entry.unwrap().file_name()));
    let sources = files.filter(|file| file.extension().is_some_and(|ending| ending == "rs"));
    let mut names: Vec<String> =
        sources.map(|file| file.file_stem().unwrap().to_str().unwrap().to_owned()).collect();
    names.sort();
    names
}

/// What a run prints and its outcome (`--values`): `verdict`, `values` by key, `findings`.
#[allow(dead_code, reason = "each target uses a part")]
pub fn outcome(name: &str, arguments: &[&str]) -> (Output, Value) {
    static RUNS: AtomicUsize = AtomicUsize::new(0);
    let run = RUNS.fetch_add(1, Ordering::Relaxed);
    let file =
        std::env::temp_dir().join(format!("signorini-{name}-{}-{run}.json", std::process::id()));
    let output = program(name).args(arguments).arg("--values").arg(&file).output().unwrap();
    let text = std::fs::read_to_string(&file).unwrap_or_else(|_| {
        panic!("{name} {arguments:?}: {}", String::from_utf8_lossy(&output.stderr))
    });
    std::fs::remove_file(&file).unwrap();
    (output, serde_json::from_str(&text).unwrap())
}
