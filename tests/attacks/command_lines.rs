//! Every option of every example with values that are not what it asks for: one clear line on stderr, exit
//! code 2, nothing on stdout, before anything is computed. What an option asks for is what the example says
//! itself (`--describe`).
//!
//! Random lines of values that fit, extreme or small, may compute: then no panic, and no number that is none but in a
//! check that is undecided. `SIGNORINI_FUZZ=100000 cargo test --release --test attacks -- --nocapture random_lines`
//! takes as many, `SIGNORINI_SEED=7` other ones.

use crate::common::SplitMix;
use crate::program::{names, program};
use rayon::prelude::*;
use serde_json::Value;
use std::collections::BTreeMap;
use std::io::Read;
use std::path::Path;
use std::process::{Child, Stdio};
use std::time::{Duration, Instant};

/// Longest wait for an answer to a bad option, with everything else the machine does.
const PATIENCE: Duration = Duration::from_secs(10);
/// Longest wait for a refusal before anything is computed, where the defaults take seconds; asked twice.
const PROMPT: Duration = Duration::from_secs(1);
/// Longest time to refuse before the first computation; asked five times where the machine is busy.
const AT_ONCE: Duration = Duration::from_millis(200);
/// Longest run of a random line that is not bad.
const LONGEST: Duration = Duration::from_secs(5);

struct Answer {
    code: Option<i32>,
    stdout: String,
    stderr: String,
    /// It ran until it was stopped.
    is_stopped: bool,
}

/// Runs a line, for so long at most.
fn ask(name: &str, line: &[String], patience: Duration) -> Answer {
    let mut command = program(name);
    command.args(line).stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().unwrap();
    let reader = |pipe: Box<dyn Read + Send>| {
        std::thread::spawn(move || {
            let mut bytes = Vec::new();
            let _ = pipe.take(1 << 24).read_to_end(&mut bytes);
            String::from_utf8_lossy(&bytes).into_owned()
        })
    };
    let stdout = reader(Box::new(child.stdout.take().unwrap()));
    let stderr = reader(Box::new(child.stderr.take().unwrap()));
    let (code, is_stopped) = wait(&mut child, patience);
    Answer { code, stdout: stdout.join().unwrap(), stderr: stderr.join().unwrap(), is_stopped }
}

fn wait(child: &mut Child, patience: Duration) -> (Option<i32>, bool) {
    let start = Instant::now();
    loop {
        if let Some(status) = child.try_wait().unwrap() {
            return (status.code(), false);
        }
        if start.elapsed() > patience {
            let _ = child.kill();
            let _ = child.wait();
            return (None, true);
        }
        std::thread::sleep(Duration::from_millis(1));
    }
}

/// What an example says of one of its options.
struct Described {
    name: String,
    kind: String,
    choices: Vec<String>,
    is_list: bool,
    default: String,
    /// Ends of the interval of a number, where it has one.
    range: Option<[f64; 2]>,
}

fn described(name: &str) -> Vec<Described> {
    let answer = ask(name, &["--describe".to_owned()], PATIENCE);
    let said: Value = serde_json::from_str(&answer.stdout).unwrap();
    let text = |value: &Value| value.as_str().unwrap_or_default().to_owned();
    let of = |option: &Value| Described {
        name: text(&option["name"]),
        kind: text(&option["kind"]),
        choices: option["choices"].as_array().into_iter().flatten().map(text).collect(),
        is_list: option["list"] == true,
        default: text(&option["default"]),
        range: option["range"]
            .as_array()
            .map(|ends| [0, 1].map(|k| ends[k].as_f64().unwrap_or(f64::INFINITY))),
    };
    said["options"].as_array().unwrap().iter().map(of).collect()
}

/// Values that no option of this kind takes.
fn wrong(option: &Described) -> Vec<String> {
    let plain: &[&str] = match option.kind.as_str() {
        "number" => &[
            "NaN", "-NaN", "inf", "-inf", "1e400", "-1e400", "", " ", "x", "1e", "0x10", "1_0", "½",
        ],
        "integer" => &["-1", "1.5", "18446744073709551616", "1e3", "NaN", "inf", "", "x", "0x10"],
        "order" => &[
            "NaN", "inf", "-0.1", "0", "1", "2", "1e400", "1/3", "1/2+", "1/2+1", "1/2-1", "", "x",
        ],
        "tolerance" => &["0", "-1", "1", "NaN", "inf", "1e400", "1e-300", "tight", "", "Fast"],
        "flag" => &[],
        _ => &["", ":", "x", "nothing:1", "\u{0}1", "NaN"],
    };
    let mut values: Vec<String> = plain.iter().map(|&word| word.to_owned()).collect();
    for word in &option.choices {
        values.extend(
            [":", "::", ":NaN", ":inf", ":1e400", ":x", ":0.3:x", ":1:2:3:4"]
                .map(|tail| format!("{word}{tail}")),
        );
    }
    // Nothing at all is a value where that is the default.
    values.retain(|value| {
        !(value.contains('\u{0}') || value.trim().is_empty() && option.default.is_empty())
    });
    values
}

/// Refused in one line, at once.
fn fault(name: &str, line: &[String]) -> Option<String> {
    let answer = ask(name, line, PATIENCE);
    let is_clear = answer.stderr.starts_with("error:") && answer.stderr.lines().count() == 1;
    let is_refused = answer.code == Some(2) && is_clear && answer.stdout.is_empty();
    (!is_refused).then(|| {
        let said = answer.stderr.lines().next().unwrap_or("nothing on stderr").to_owned();
        let stopped = if answer.is_stopped { ", stopped" } else { "" };
        format!("{name} {line:?}: exit {:?}{stopped}, {said}", answer.code)
    })
}

/// Refused in one line, in so short a time once of so many.
fn late(name: &str, line: &[String], patience: Duration, times: usize) -> Option<String> {
    let once = |_| {
        let start = Instant::now();
        fault(name, line).or_else(|| {
            let taken = start.elapsed();
            (taken > patience).then(|| format!("{name} {line:?}: refused after {taken:?}"))
        })
    };
    let answers: Vec<String> = (0..times).map_while(once).collect();
    answers.into_iter().nth(times - 1)
}

/// No line has a fault.
fn assert_none(
    lines: &[(String, Vec<String>)],
    fault: impl Fn(&str, &[String]) -> Option<String> + Sync,
) {
    let faults: Vec<String> =
        lines.par_iter().filter_map(|(name, line)| fault(name, line)).collect();
    assert!(faults.is_empty(), "{} of {}:\n{}", faults.len(), lines.len(), faults.join("\n"));
}

#[test]
fn what_is_not_asked_for_is_refused_in_one_line() {
    let mut lines: Vec<(String, Vec<String>)> = Vec::new();
    for name in names() {
        let mut push = |line: Vec<String>| lines.push((name.clone(), line));
        for stray in ["--nothing", "stray", "--json=1", "--out", "--values", "-x"] {
            push(vec![stray.to_owned()]);
        }
        for option in described(&name) {
            push(vec![format!("--{}", option.name), "x".to_owned(), "stray".to_owned()]);
            if option.kind == "flag" {
                push(vec![format!("--{}=1", option.name)]);
            }
            wrong(&option)
                .into_iter()
                .for_each(|value| push(vec![format!("--{}={value}", option.name)]));
        }
    }
    assert!(lines.len() > 2000, "{}", lines.len());
    assert_none(&lines, fault);
}

/// Values that no list of this kind takes, though each is a number or a name.
fn outside(option: &Described) -> Vec<&'static str> {
    match option.kind.as_str() {
        _ if !option.is_list => Vec::new(),
        "number" => {
            let ends =
                option.range.map_or(vec![], |[low, high]| vec![("-1e301", low), ("1e301", high)]);
            ends.into_iter().filter(|(_, end)| end.is_finite()).map(|(value, _)| value).collect()
        }
        "integer" => vec!["18446744073709551615", "4294967296"],
        "order" => vec!["1.5"],
        _ => vec!["log:1e300", "power:1e300", "step:7"],
    }
}

#[test]
fn a_later_value_of_a_list_is_refused_before_the_first_is_computed() {
    let mut lines: Vec<(String, Vec<String>)> = Vec::new();
    for name in names() {
        for option in described(&name) {
            for bad in outside(&option) {
                let behind = format!("{},{bad}", option.default).trim_start_matches(',').to_owned();
                for values in [bad.to_owned(), behind] {
                    lines.push((name.clone(), vec![format!("--{}={values}", option.name)]));
                }
            }
        }
    }
    lines.extend([
        ("section_1_trace_constants".to_owned(), vec!["--s=0.8,0.5".to_owned()]),
        ("section_1_norms_in_the_plane".to_owned(), vec!["--gap=0.5,-1".to_owned()]),
        ("theorem_3_1_with_numbers".to_owned(), vec!["--tau=1.75,1.4".to_owned()]),
    ]);
    assert!(lines.len() > 100, "{}", lines.len());
    assert_none(&lines, |name, line| late(name, line, PROMPT, 2));
}

#[test]
fn options_are_checked_before_the_first_computation() {
    let profile = ["--tau=1.5", "--tau=2", "--tau=1e300", "--finest=4", "--finest=13"];
    let mut lines = profile.map(|line| ("theorem_3_1_proof_profile", line)).to_vec();
    lines.extend([
        ("remark_7_zone_location", "--theta=1e-300"),
        ("remark_7_zone_location", "--at=0,1e-300"),
        ("remark_6_point_condition", "--nu=0.55,0.6,1e-300"),
        ("remark_3_face", "--nu=0.25,0.4,0.9999999999"),
        ("lemma_6_2_global_estimate", "--power=-0.25"),
        ("lemma_6_2_global_estimate", "--elements=1,65536,0"),
        ("theorem_3_1_with_numbers", "--lambda=-1"),
        ("theorem_3_1_with_numbers", "--lambda=1e300"),
        ("theta_balance", "--finest=1"),
        ("figure_4_1_alternative", "--problem=membrane-reaction"),
        ("remark_1_whole_boundary", "--meshes=11"),
        ("remark_1_whole_boundary", "--tau=1.95"),
        ("section_1_clamped_end", "--poisson=0.25,0.5"),
        ("section_1_clamped_end", "--angles=6"),
        // More than there is memory for.
        ("lemma_6_2_global_estimate", "--elements=18446744073709551615"),
        ("lemma_6_2_global_estimate", "--elements=4294967296"),
        ("lemma_6_2_global_estimate", "--elements=1000000000000"),
        ("section_2_elastic_contact", "--n=16384"),
        ("section_2_elastic_contact", "--n=18446744073709551615"),
        ("equation_3_2_logarithm", "--finest=19"),
        ("worst_contact_set", "--depth=25"),
        ("section_2_speed_for_accuracy", "--n=65536"),
        ("figure_3_1", "--finest=64"),
        ("remark_1_whole_boundary", "--meshes=18446744073709551615"),
        ("section_1_clamped_end", "--angles=18446744073709551615"),
        ("figure_3_2_alternative", "--n=18446744073709551615"),
    ]);
    let lines: Vec<(String, Vec<String>)> =
        lines.into_iter().map(|(name, line)| (name.to_owned(), vec![line.to_owned()])).collect();
    assert_none(&lines, |name, line| late(name, line, AT_ONCE, 5));
}

fn pick<'a>(words: &[&'a str], random: &mut SplitMix) -> &'a str {
    words[random.below(words.len())]
}

/// `--name=value` with a value of the kind: at the ends of what may be asked, or a small one.
fn fitting(option: &Described, is_small: bool, random: &mut SplitMix) -> String {
    let words: &[&str] = match (option.kind.as_str(), is_small) {
        ("flag", _) => return format!("--{}", option.name),
        ("integer", true) => &["1", "2", "3", "4"],
        ("integer", false) => &[
            "0",
            "1",
            "2",
            "3",
            "4",
            "5",
            "7",
            "8",
            "16",
            "100",
            "4294967296",
            "18446744073709551615",
        ],
        ("order", true) => &["0.25", "1/2", "0.75"],
        ("order", false) => &[
            "1e-300",
            "1e-16",
            "0.25",
            "1/2-1e-16",
            "1/2",
            "1/2+1e-12",
            "0.999",
            "0.75",
            "1/2+1e-300",
        ],
        ("tolerance", true) => &["1e-2", "1e-3", "fast"],
        ("tolerance", false) => &["1e-15", "1e-3", "fast", "0.1", "balanced", "0.9"],
        ("number", true) => &["0.5", "1", "1.75", "0.25", "0.1"],
        ("number", false) => &[
            "0", "-1", "1", "2", "0.5", "1e-300", "-1e300", "1e300", "1.75", "1.5", "2.5", "1e-12",
            "5e-324",
        ],
        (_, true) => &[""],
        (_, false) => &["", ":0.25", ":3", ":0", ":1", ":0.2:4", ":1e-300", ":-1"],
    };
    let value = match option.choices.len() {
        0 => pick(words, random).to_owned(),
        count => format!("{}{}", option.choices[random.below(count)], pick(words, random)),
    };
    format!("--{}={value}", option.name)
}

/// Up to four options with values that fit, the sizes small in a small line; `--json` first.
fn random_line(known: &[Described], random: &mut SplitMix) -> Vec<String> {
    let is_small = random.below(2) == 0;
    let mut chosen: Vec<usize> = (0..=random.below(3)).map(|_| random.below(known.len())).collect();
    chosen.extend((0..known.len()).filter(|&k| is_small && known[k].kind == "integer"));
    chosen.sort_unstable();
    chosen.dedup();
    let options = chosen.into_iter().map(|k| fitting(&known[k], is_small, random));
    std::iter::once("--json".to_owned()).chain(options).collect()
}

/// No panic, no signal, not stopped in the middle of a number; an outcome has numbers and only numbers, and a reason
/// for each that is missing.
fn wrong_answer(name: &str, line: &[String]) -> Option<String> {
    let answer = ask(name, line, LONGEST);
    let said = |what: &str| Some(format!("{name} {line:?}: {what}, {}", answer.stderr));
    match answer.code {
        _ if answer.is_stopped => None,
        _ if answer.stderr.contains("panicked") => said("a panic"),
        Some(2) => {
            let is_clear =
                answer.stderr.starts_with("error:") && answer.stderr.lines().count() == 1;
            if is_clear && answer.stdout.is_empty() { None } else { said("not one clear line") }
        }
        Some(0 | 1) if !answer.stdout.contains(|c: char| c.is_ascii_digit()) => said("no number"),
        // That example plants what is no number, and names it.
        Some(0 | 1) if name == "extremes" => None,
        Some(0 | 1) => answer.stdout.lines().find_map(not_said).and_then(|wrong| said(&wrong)),
        _ => said("a signal"),
    }
}

/// What is wrong with a line of JSON.
fn not_said(line: &str) -> Option<String> {
    let Ok(Value::Object(row)) = serde_json::from_str::<Value>(line) else {
        return Some(format!("not an object: {line}"));
    };
    no_number(&Value::Object(row))
}

/// A text that prints what is no number: `NaN`, or `inf` but as the end of a range or as an infimum.
fn no_number(value: &Value) -> Option<String> {
    match value {
        Value::String(text) => {
            let is_end =
                |at: usize| text[..at].ends_with(", ") && text[at + 3..].starts_with([')', ']']);
            let is_word = |at: usize| {
                let inside = |c: char| c.is_alphanumeric() || c == '_';
                !text[..at].ends_with(inside) && !text[at + 3..].starts_with(inside)
            };
            let infimum = |at: usize| text[at + 3..].starts_with(" over ");
            let bad =
                |word: &str| text.match_indices(word).map(|(at, _)| at).find(|&at| is_word(at));
            let inf = text.match_indices("inf").map(|(at, _)| at);
            let inf = inf.filter(|&at| is_word(at)).find(|&at| !is_end(at) && !infimum(at));
            bad("NaN").or(inf).map(|_| format!("no number in {text:?}"))
        }
        Value::Array(values) => values.iter().find_map(no_number),
        // An undecided check may have no number; an entry that is missing is null.
        Value::Object(values)
            if values.get("outcome").is_some_and(|outcome| outcome == "undecided") =>
        {
            None
        }
        // What a column means, an infimum for instance, is no number of it.
        Value::Object(values) => values
            .iter()
            .filter(|(key, _)| !["title", "meaning", "unit"].contains(&key.as_str()))
            .find_map(|(_, value)| no_number(value)),
        _ => None,
    }
}

#[test]
fn random_lines_are_refused_or_computed_and_say_so() {
    let variable = |name: &str| std::env::var(name).ok().map(|text| text.parse::<u64>().unwrap());
    let count = variable("SIGNORINI_FUZZ").unwrap_or(100);
    let options: BTreeMap<String, Vec<Described>> =
        names().into_iter().map(|name| (name.clone(), described(&name))).collect();
    let options: Vec<_> = options.iter().filter(|(_, known)| !known.is_empty()).collect();
    let mut random = SplitMix::new(22 + 1000 * variable("SIGNORINI_SEED").unwrap_or(0));
    let line = |_| {
        let (name, known) = options[random.below(options.len())];
        (name.clone(), random_line(known, &mut random))
    };
    let lines: Vec<(String, Vec<String>)> = (0..count).map(line).collect();
    assert_none(&lines, wrong_answer);
}

/// All rows and findings of all examples at their default sizes, as the book keeps them.
#[test]
fn no_outcome_of_the_book_is_no_number() {
    let kept = Path::new(env!("CARGO_MANIFEST_DIR")).join("book/generated/values.json");
    let kept: Value = serde_json::from_str(&std::fs::read_to_string(kept).unwrap()).unwrap();
    let examples = kept.as_object().unwrap();
    assert!(examples.len() >= 40, "{}", examples.len());
    // Which plants what is no number, and names it.
    let others = examples.iter().filter(|(name, _)| *name != "extremes");
    let faults: Vec<String> = others
        .filter_map(|(name, outcome)| Some(format!("{name}: {}", no_number(outcome)?)))
        .collect();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}
