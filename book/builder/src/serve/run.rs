//! One run of an example: its own process and directory, killed when it takes too much or nobody waits for
//! it.

use super::limits::Limits;
use crate::data::{names, parse_object};
use crate::error::read;
use serde_json::{Map, Value};
use std::collections::BTreeMap;
use std::path::Path;
use std::process::Stdio;
use std::time::{Duration, Instant};
use tokio::process::{Child, Command};

/// How often a run is looked at.
const LOOK: Duration = Duration::from_millis(25);
/// Bytes of a complaint that are passed on.
const COMPLAINT: usize = 600;

/// What a run computed.
pub(super) struct Outcome {
    /// The headline, as in `values.json`.
    pub(super) headline: Map<String, Value>,
    /// SVG text by name.
    pub(super) figures: BTreeMap<String, String>,
    /// How long it took.
    pub(super) seconds: f64,
}

/// Why there is no outcome, in words for the reader of a page.
pub(super) enum Refusal {
    /// The example refused its parameters.
    Parameters(String),
    /// It took too long, too much, or did not run.
    Run(String),
}

/// Runs a program with arguments that were checked. When the future is dropped the process is killed.
pub(super) async fn run(
    program: &Path,
    arguments: &[String],
    limits: &Limits,
) -> Result<Outcome, Refusal> {
    let failed = |what: &str| Refusal::Run(what.to_owned());
    let directory = tempfile::tempdir().map_err(|_| failed("no place to work in"))?;
    let place = directory.path();
    let complaint = std::fs::File::create(place.join("complaint"))
        .map_err(|_| failed("no place to work in"))?;
    let start = Instant::now();
    let mut child = Command::new(program)
        .args(arguments)
        .arg("--values")
        .arg(place.join("headline.json"))
        .arg("--out")
        .arg(place.join("figures"))
        .current_dir(place)
        .env_clear()
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(complaint)
        .kill_on_drop(true)
        .spawn()
        .map_err(|_| failed("the example does not start"))?;
    let code = watch(&mut child, place, start, limits).await.map_err(Refusal::Run)?;
    let seconds = start.elapsed().as_secs_f64();
    match code {
        // 1 says that a claim does not hold at these parameters.
        Some(0 | 1) => {}
        Some(2) => return Err(Refusal::Parameters(complaint_of(place))),
        _ => return Err(failed("the example ended without an answer")),
    }
    let path = place.join("headline.json");
    let headline = read(&path).and_then(|text| parse_object(&path, &text));
    let headline = headline.map_err(|_| failed("the example left no answer"))?;
    let mut figures = BTreeMap::new();
    for file in names(&place.join("figures")).unwrap_or_default() {
        if let (Some(stem), Ok(svg)) =
            (file.strip_suffix(".svg"), read(&place.join("figures").join(&file)))
        {
            figures.insert(stem.to_owned(), svg);
        }
    }
    Ok(Outcome { headline, figures, seconds })
}

/// Waits for the end; ends a run that takes too much.
async fn watch(
    child: &mut Child,
    place: &Path,
    start: Instant,
    limits: &Limits,
) -> Result<Option<i32>, String> {
    loop {
        if let Ok(ended) = tokio::time::timeout(LOOK, child.wait()).await {
            let too_much = size(place) > limits.output;
            return if too_much {
                Err("it wrote too much".to_owned())
            } else {
                ended.map(|status| status.code()).map_err(|e| e.to_string())
            };
        }
        let over = if start.elapsed() > limits.run {
            Some(format!("stopped: longer than {} s", limits.run.as_secs_f64()))
        } else if size(place) > limits.output {
            Some("stopped: it wrote too much".to_owned())
        } else if child.id().and_then(memory).is_some_and(|bytes| bytes > limits.memory) {
            Some("stopped: it took too much memory".to_owned())
        } else {
            None
        };
        if let Some(words) = over {
            let _ = child.kill().await;
            return Err(words);
        }
    }
}

/// The first line of what the example complained of.
fn complaint_of(place: &Path) -> String {
    let text = std::fs::read(place.join("complaint")).unwrap_or_default();
    let text = String::from_utf8_lossy(&text[..text.len().min(COMPLAINT)]).into_owned();
    text.lines().next().unwrap_or("").trim_start_matches("error: ").to_owned()
}

/// Bytes in the files of a directory and one level below.
fn size(place: &Path) -> u64 {
    let below = |path: &Path| -> Vec<std::fs::DirEntry> {
        std::fs::read_dir(path).into_iter().flatten().filter_map(Result::ok).collect()
    };
    let bytes = |entry: &std::fs::DirEntry| {
        entry.metadata().map_or(0, |m| if m.is_file() { m.len() } else { 0 })
    };
    let top = below(place);
    let inner =
        top.iter().flat_map(|entry| below(&entry.path())).map(|entry| bytes(&entry)).sum::<u64>();
    inner + top.iter().map(bytes).sum::<u64>()
}

/// Memory that a process holds, where the system tells it under /proc.
fn memory(process: u32) -> Option<u64> {
    let status = std::fs::read_to_string(format!("/proc/{process}/status")).ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmRSS:"))?;
    line.trim().strip_suffix(" kB")?.trim().parse::<u64>().ok().map(|kb| kb << 10)
}
