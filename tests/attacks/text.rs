//! A seeded attack on everything that is read from text: mesh files, samples, scenes, values of options.
//!
//! Texts that are right are cut, joined, repeated and given words that do not belong; a mutant whose answer
//! is of a new kind is mutated further. Each is read, or refused by an error that names the line of a file,
//! in a time and a memory in proportion to its length.
//!
//! `SIGNORINI_FUZZ=100000 cargo test --release --test attack_text -- --nocapture` tries as many per grammar,
//! `SIGNORINI_SEED=7` other ones.

use crate::common::SplitMix;
use example_report::Expression;
use fractional_sobolev::{Order, Tolerance};
use peak_alloc::PeakAlloc;
use signorini::Error;
use signorini::ToolkitError;
use signorini::mesh::parse_msh;
use signorini::problems::{NamedProblem, StripData, TestProblem};
use signorini::strip::{EdgeData, LateralCondition};
use std::collections::BTreeSet;
use std::fmt::{Debug, Display};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::str::FromStr;
use std::time::{Duration, Instant};

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

/// Mutants of each grammar unless `SIGNORINI_FUZZ` says otherwise.
const MUTANTS: usize = 20_000;
/// What reading may take per byte of the text: a triangle of ten bytes has three sides of 32 bytes each, in
/// vectors that double.
const BYTES_PER_BYTE: usize = 64;
/// What it may take beside that: names of all scenes and functions, problems on coarse grids.
const BYTES: usize = 1 << 20;
/// Longest wait for an answer.
const PATIENCE: Duration = Duration::from_secs(20);
/// Longest mutant.
const LONGEST: usize = 1 << 14;
/// Kinds of answers whose texts are mutated further.
const POOL: usize = 400;

const GMSH: [&str; 3] = [
    include_str!("../data/two_squares.msh"),
    include_str!("../data/two_squares_2.2.msh"),
    include_str!("../../examples/data/l_shape.msh"),
];
/// Further files of Gmsh: parts, parameters, an interface, points.
const MORE: [&str; 5] = [
    include_str!("../data/msh/partitioned_41.msh"),
    include_str!("../data/msh/parametric_22.msh"),
    include_str!("../data/msh/interface_curve.msh"),
    include_str!("../data/msh/physical_point_clamped.msh"),
    include_str!("../data/msh/mixed_orientation_22.msh"),
];
const EDGE: &str = include_str!("../data/edge.txt");

/// Words that belong nowhere, or not there, between bars.
const WORDS: &str = "18446744073709551615|18446744073709551616|-9223372036854775808|4294967296|1000000000000|9999999|-1|0|1|2|\
    1e308|-1e308|1e-320|1e400|NaN|inf|-inf|0x10|1e|.|| |\n|\r|\t|\0|\u{feff}|\u{fffd}|½|\
    $Nodes\n9999999999 9999999999 1 1\n|$EndElements\n|$X\n|#|:";

/// What reading a text came to: the kind of answer, or what is wrong with it.
type Answer = Result<String, String>;

/// Something that is read from text.
struct Grammar {
    name: &'static str,
    seeds: Vec<String>,
    read: fn(&str) -> Answer,
}

/// All of them; a further one is a further line.
fn grammars() -> Vec<Grammar> {
    let all = |texts: &[&str]| texts.iter().map(|&text| text.to_owned()).collect::<Vec<String>>();
    let crlf = GMSH[0].replace('\n', "\r\n");
    let scenes = TestProblem::all().iter().map(TestProblem::to_string).collect::<Vec<_>>();
    let strips = StripData::all().iter().map(StripData::to_string).collect::<Vec<_>>();
    let orders = ["0.25", "1/2", "1/2+1e-20", "1/2-0.25", "1e-300", "0.999"];
    let loads = ["0.15, 0.2 - 0.3*x", "-cos(pi*x)^2 - 0.5", "max(x, -1e-3*y) + atan2(y, x)^(1/3)"];
    vec![
        Grammar { name: "gmsh", seeds: [all(&GMSH), all(&MORE), vec![crlf]].concat(), read: mesh },
        Grammar { name: "samples", seeds: all(&[EDGE, "0 0\n-1 0\n"]), read: samples },
        Grammar { name: "scene", seeds: [scenes, strips].concat(), read: scene },
        Grammar { name: "order", seeds: all(&orders), read: order },
        Grammar {
            name: "tolerance",
            seeds: all(&["fast", "reference", "1e-9"]),
            read: word::<Tolerance>,
        },
        Grammar { name: "load", seeds: all(&loads), read: load },
    ]
}

/// What is read has a meaning; an error is one line.
fn plain<T: FromStr<Err: Display> + Debug>(text: &str) -> Answer {
    kind(text.parse::<T>().map(|found| format!("{found:?}")))
}

/// What is read is written so that the same is read again.
fn word<T: FromStr<Err: Display + Debug + PartialEq> + Display + PartialEq + Debug>(
    text: &str,
) -> Answer {
    if let Ok(found) = text.parse::<T>() {
        let written = found.to_string();
        if written.parse().as_ref() != Ok(&found) {
            return Err(format!("{found:?} is written {written}"));
        }
    }
    plain::<T>(text)
}

fn order(text: &str) -> Answer {
    let inside = |nu: &Order| nu.value() > 0.0 && nu.value() < 1.0;
    match text.parse::<Order>() {
        Ok(nu) if !inside(&nu) => Err(format!("{nu:?} is no order")),
        _ => word::<Order>(text),
    }
}

/// An expression that is read has a value or NaN everywhere; a refusal is one line.
fn load(text: &str) -> Answer {
    let read = Expression::parse_list(text);
    for function in read.iter().flatten() {
        for point in [[0.5, -0.25], [0.0, 0.0], [1e308, -1e-320]] {
            function.at(point);
        }
    }
    kind(read.map(|list| format!("{} functions", list.len())))
}

/// A scene that is read has data on a coarse edge or a mesh, or an error says why not.
fn scene(text: &str) -> Answer {
    let answer = word::<NamedProblem>(text)?;
    match text.parse() {
        Ok(NamedProblem::Strip(StripData::Samples { .. })) | Err(_) => Ok(answer),
        Ok(NamedProblem::Strip(scene)) => edge(scene.data(1.75, 32, LateralCondition::Periodic)),
        Ok(NamedProblem::Mesh(scene)) => {
            kind(scene.mesh(2).map(|mesh| format!("{} nodes", mesh.nodes().len())))
        }
    }
}

fn edge(data: Result<EdgeData, Error>) -> Answer {
    let is_finite =
        |data: &EdgeData| data.values().iter().chain(data.forces()).all(|value| value.is_finite());
    match data {
        Ok(data) if !is_finite(&data) => Err("data that are no numbers".to_owned()),
        data => kind(data.map(|data| format!("{} cells", data.cells()))),
    }
}

/// The kind of an answer: what it says, without numbers and without what it quotes.
fn kind<E: Display>(answer: Result<String, E>) -> Answer {
    let said = answer.unwrap_or_else(|error| error.to_string());
    let quotes = ['\'', '"'];
    let (before, rest) = said.split_once(quotes).unwrap_or((&said, ""));
    let behind = rest.rsplit_once(quotes).map_or(rest, |(_, behind)| behind);
    Ok([before, behind].concat().chars().filter(char::is_ascii_alphabetic).take(60).collect())
}

/// An error in a file names a line that there is.
fn with_line(text: &str, answer: Result<String, Error>) -> Answer {
    if let Err(error) = &answer {
        let line = match *error {
            Error::Syntax { line, .. } | Error::AtLine { line, .. } => line,
            // A binary file, or a text whose first line says that it is one.
            Error::AtByte { byte, .. } if byte <= text.len() => 1,
            _ => return Err(format!("no line: {error}")),
        };
        // Of a file without a line the error is about line 0.
        if line > text.lines().count()
            || line == 0 && !text.trim_start_matches('\u{feff}').trim().is_empty()
        {
            return Err(format!("{line} of {} lines: {error}", text.lines().count()));
        }
        let said = error.to_string();
        if said.lines().count() != 1 || said.len() > 300 {
            return Err(format!("not one short line: {said}"));
        }
    }
    kind(answer)
}

fn mesh(text: &str) -> Answer {
    let read = parse_msh(text);
    if let Ok(mesh) = &read
        && !mesh.nodes().iter().flatten().all(|x| x.is_finite())
    {
        return Err("a node that is nowhere".to_owned());
    }
    with_line(text, read.map(|mesh| format!("{} triangles", mesh.triangles().len())))
}

/// The number of rows is a fault of no line.
fn samples(text: &str) -> Answer {
    match EdgeData::from_samples(text, LateralCondition::Natural) {
        Err(
            error @ (Error::Toolkit(ToolkitError::CountOutOfRange { .. })
            | Error::EmptyContact { .. }),
        ) => kind(Err(error)),
        Err(error) => with_line(text, Err(error)),
        data => edge(data),
    }
}

/// One change of a text; `other` is a second text of the grammar.
fn change(bytes: &mut Vec<u8>, other: &str, random: &mut SplitMix) {
    let length = bytes.len();
    let at = random.below(length + 1);
    let to = if random.below(2) == 0 {
        at + random.below(length - at + 1)
    } else {
        (at + 8).min(length)
    };
    let chosen = WORDS.split('|').nth(random.below(WORDS.split('|').count())).unwrap().bytes();
    match random.below(11) {
        0 => bytes.truncate(at),
        1 => drop(bytes.drain(at..to)),
        2 => drop(bytes.splice(at..at, chosen)),
        3 => drop(bytes.splice(word_at(bytes, at), chosen)),
        4 => {
            let part = bytes[at..to].repeat(1 + random.below(8));
            drop(bytes.splice(at..at, part));
        }
        5 if length > 0 => bytes[at.min(length - 1)] ^= 1 << random.below(8),
        6 => bytes.insert(at, random.below(256) as u8),
        7 => drop(bytes.splice(at.., other.bytes().skip(random.below(other.len() + 1)))),
        8 => {
            drop(bytes.splice(
                word_at(bytes, at),
                other.bytes().skip(random.below(other.len() + 1)).take(8),
            ))
        }
        9 => {
            let mut lines: Vec<Vec<u8>> =
                bytes.split(|&b| b == b'\n').map(<[u8]>::to_vec).collect();
            let (one, two) = (random.below(lines.len()), random.below(lines.len()));
            lines.swap(one, two);
            *bytes = lines.join(&b'\n');
        }
        _ => {
            let taken = word_at(bytes, at);
            let sent = bytes[taken].to_vec();
            drop(bytes.splice(word_at(bytes, random.below(length + 1)), sent));
        }
    }
}

/// The word in which a byte stands.
fn word_at(bytes: &[u8], at: usize) -> std::ops::Range<usize> {
    let is_part = |b: &u8| !b.is_ascii_whitespace() && *b != b':' && *b != b'-' && *b != b'/';
    let before = bytes[..at].iter().rev().take_while(|b| is_part(b)).count();
    let behind = bytes[at..].iter().take_while(|b| is_part(b)).count();
    at - before..at + behind
}

/// Reads a text: what is wrong, or too long, or too large.
fn ask(grammar: &Grammar, text: &str) -> Answer {
    let (before, start) = (MEMORY.current_usage(), Instant::now());
    MEMORY.reset_peak_usage();
    let answer =
        catch_unwind(AssertUnwindSafe(|| (grammar.read)(text))).map_err(|_| "panics".to_owned())?;
    let taken = MEMORY.peak_usage().saturating_sub(before);
    if taken > BYTES + BYTES_PER_BYTE * text.len() {
        return Err(format!("takes {taken} bytes for {} bytes", text.len()));
    }
    if start.elapsed() > PATIENCE { Err(format!("takes {:?}", start.elapsed())) } else { answer }
}

#[test]
fn mutants_are_read_or_refused_by_their_line() {
    let asked = std::env::var("SIGNORINI_FUZZ").ok().and_then(|text| text.parse().ok());
    let count: usize = asked.unwrap_or(MUTANTS);
    let shift = std::env::var("SIGNORINI_SEED").map_or(0, |text| text.parse().unwrap());
    let mut faults = Vec::new();
    for (seed, grammar) in (0..).zip(grammars()) {
        let mut random = SplitMix::new(seed + 1000 * shift);
        let (mut pool, mut kinds) = (grammar.seeds.clone(), BTreeSet::new());
        for text in &grammar.seeds {
            kinds.extend(ask(&grammar, text).map_err(|wrong| panic!("{text}: {wrong}")));
        }
        for _ in 0..count {
            let mut bytes = pool[random.below(pool.len())].clone().into_bytes();
            let other = &pool[random.below(pool.len())];
            (0..=random.below(4)).for_each(|_| change(&mut bytes, other, &mut random));
            bytes.truncate(LONGEST);
            let text = String::from_utf8_lossy(&bytes).into_owned();
            match ask(&grammar, &text) {
                Ok(kind) if kinds.len() < POOL && kinds.insert(kind.clone()) => pool.push(text),
                Ok(_) => {}
                Err(wrong) => faults.push(format!("{}: {wrong}\n{text:?}", grammar.name)),
            }
        }
        println!("{}: {count} mutants, {} kinds of answers", grammar.name, kinds.len());
    }
    faults.truncate(20);
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}
