//! Every command, every path and every name of a program in a text exists. Texts: each `.md` of the repository, the exercises and the
//! course of the book; of the comments in programs the commands.
//!
//! A command of an example is run with `--describe` behind its options: they are read and nothing is computed. Of
//! `cargo test` the target and the filter are looked up, of the project's own commands their names, of anything else
//! its files.

use crate::program::{names, program};
use rayon::prelude::*;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

const ROOT: &str = env!("CARGO_MANIFEST_DIR");
/// Directories that no one writes by hand, or that are not there before something has run.
const WRITTEN: [&str; 8] =
    ["target", ".git", "book/html", "out", "pictures", "python/target", "html", "node_modules"];
/// Programs of other projects that texts use.
const FOREIGN: [&str; 10] =
    ["git", "cd", "zip", "gmsh", "pip", "python", "python3", "maturin", "rustup", "xdg-open"];
/// Commands of Cargo without names of this project in them.
const CARGO: [&str; 8] = ["fetch", "clippy", "fmt", "doc", "build", "deny", "package", "publish"];
/// What ends the name of a file.
const ENDINGS: [&str; 14] = [
    "rs", "md", "toml", "py", "json", "txt", "svg", "msh", "yml", "ipynb", "csv", "css", "js",
    "cff",
];

/// A part of a text in code type, or the goal of a link.
#[derive(Debug, Clone, PartialEq, Eq)]
enum Part {
    /// A line of a shell.
    Command(String),
    /// Code within a sentence.
    Code(String),
    /// Where a link leads.
    Link(String),
}

/// Commands, code and links of a text, with their lines; blocks of code that are no commands are left out.
fn parts(text: &str) -> Vec<(usize, Part)> {
    let mut found = Vec::new();
    let mut block: Option<String> = None;
    let mut unfinished = String::new();
    let mut open: Option<(usize, String)> = None; // code that goes on in the next line
    for (k, line) in text.lines().enumerate() {
        let at = k + 1;
        if let Some(language) = line.trim_start_matches(['>', ' ']).strip_prefix("```") {
            block = if block.is_some() { None } else { Some(language.trim().to_owned()) };
            open = None;
            continue;
        }
        if let Some(language) = &block {
            if matches!(language.as_str(), "sh" | "shell" | "console" | "bash") {
                let line = unfinished.clone() + line;
                match line.strip_suffix('\\') {
                    Some(line) => unfinished = line.to_owned(),
                    None => {
                        unfinished.clear();
                        found.extend(commands(&line).into_iter().map(|c| (at, Part::Command(c))));
                    }
                }
            }
            continue;
        }
        if line.trim().is_empty() {
            open = None;
        }
        for (i, piece) in line.split('`').enumerate() {
            if i > 0 {
                open = match open.take() {
                    Some((at, code)) => {
                        found.push((at, Part::Code(code.trim().to_owned())));
                        None
                    }
                    None => Some((at, String::new())),
                };
            }
            match &mut open {
                Some((_, code)) => *code += piece,
                None => {
                    for link in piece.split("](").skip(1) {
                        let goal = link.split([')', ' ']).next().unwrap_or("");
                        found.push((at, Part::Link(goal.to_owned())));
                    }
                }
            }
        }
        if let Some((_, code)) = &mut open {
            code.push(' ');
        }
    }
    found
}

/// The commands of a line of a shell, without its comment.
fn commands(line: &str) -> Vec<String> {
    let line = line.split(" # ").next().unwrap_or("").trim();
    let line = line.strip_prefix("$ ").unwrap_or(line);
    if line.is_empty() || line.starts_with('#') {
        return Vec::new();
    }
    line.split("&&").map(|command| command.trim().to_owned()).collect()
}

/// The words of a command, as a shell cuts it.
fn words(command: &str) -> Vec<String> {
    let mut words = vec![String::new()];
    let mut quote = None;
    for letter in command.chars() {
        match (letter, quote) {
            ('"' | '\'', None) => quote = Some(letter),
            (_, Some(q)) if q == letter => quote = None,
            (' ' | '\t', None) => words.push(String::new()),
            _ => words.last_mut().unwrap().push(letter),
        }
    }
    words.retain(|word| !word.is_empty());
    words
}

/// A word that stands for another: `NAME`, `tests/SECTION/main.rs`, `mine_NAME`, `...`.
fn is_placeholder(word: &str) -> bool {
    let is_upper = |part: &str| part.chars().all(|c| c.is_ascii_uppercase());
    let is_whole = |part: &str| part.len() > 1 && is_upper(part);
    let is_letter = word.len() == 1 && is_upper(word);
    is_letter || word.contains("..") || word.split(['/', '.', '_']).any(is_whole)
}

/// What is wrong with a command; `beside` is the directory of the text.
fn fault(command: &str, beside: &Path) -> Option<String> {
    let words = words(&command.replace(['[', ']'], "")); // what may be left out
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    match words.as_slice() {
        ["cargo", "run", rest @ ..] => example(rest),
        ["cargo", "test" | "bench", rest @ ..] => test(rest),
        ["cargo", own @ ("book" | "course"), rest @ ..] => own_command(own, rest),
        ["cargo"] => None,
        ["cargo", "add", name, ..] => {
            (!crates().contains(*name)).then(|| format!("no crate {name}"))
        }
        ["cargo", known, ..] if CARGO.contains(known) => None,
        [file, ..] if file.starts_with(".ci/") => missing(file, beside),
        [program, rest @ ..] if FOREIGN.contains(program) => {
            rest.iter().filter(|word| is_path(word)).find_map(|word| missing(word, beside))
        }
        [] => None,
        _ => Some("unknown command".to_owned()),
    }
}

/// `cargo run --example NAME -- OPTIONS`: the example reads its options.
fn example(words: &[&str]) -> Option<String> {
    let end = words.iter().position(|word| *word == "--").unwrap_or(words.len());
    let (cargo, given) = (&words[..end], words.get(end + 1..).unwrap_or(&[]));
    let name = cargo.iter().position(|word| *word == "--example").and_then(|k| cargo.get(k + 1))?;
    if is_placeholder(name) {
        return None;
    }
    if !names().iter().any(|known| known == name) {
        return Some(format!("no example {name}"));
    }
    if given.contains(&"--help") {
        return None;
    }
    let output = program(name).args(given).arg("--describe").output().unwrap();
    (!output.status.success()).then(|| String::from_utf8_lossy(&output.stderr).trim().to_owned())
}

/// `cargo test [--package P] [--test T] [FILTER]`: the target, and a test or module whose name has the filter in it.
fn test(words: &[&str]) -> Option<String> {
    let after = |names: &[&str]| {
        let at = words.iter().position(|word| names.contains(word))?;
        words.get(at + 1).copied()
    };
    if let Some(package) = after(&["--package", "-p"])
        && !is_placeholder(package)
        && !crates().contains(package)
    {
        return Some(format!("no package {package}"));
    }
    let target = after(&["--test", "--bench"]).filter(|name| !is_placeholder(name));
    let sources: Vec<&(PathBuf, String)> = PROGRAMS
        .iter()
        .filter(|(file, _)| {
            target.is_none_or(|target| {
                file.ends_with(format!("{target}.rs"))
                    || file.parent().is_some_and(|directory| directory.ends_with(target))
            })
        })
        .collect();
    // Copies of exercises, `mine_NAME.rs`, are made by a reader.
    let made = target.and_then(|name| name.strip_prefix("mine_"));
    if let Some(name) = made {
        return missing(&format!("book/course/tests/{name}.rs"), Path::new(ROOT));
    }
    if sources.is_empty() {
        return Some(format!("no test {}", target.unwrap_or("")));
    }
    let takes_value = ["--package", "-p", "--test", "--bench"];
    let mut filters = words.iter().enumerate().filter(|(k, word)| {
        let is_value = *k > 0 && takes_value.contains(&words[k - 1]);
        !word.starts_with('-') && !is_value && !is_placeholder(word)
    });
    let is_found = |filter: &str| {
        let name = filter.rsplit("::").find(|part| !part.is_empty()).unwrap_or(filter);
        sources.iter().any(|(file, text)| {
            let names = text.split("fn ").skip(1).filter_map(|rest| rest.split('(').next());
            let mut names = names.chain(file.file_stem().and_then(|stem| stem.to_str()));
            names.any(|known| known.contains(name))
        })
    };
    filters.find_map(|(_, filter)| {
        (!is_found(filter)).then(|| format!("no test or module has {filter} in its name"))
    })
}

/// `cargo book build`: the program knows the word.
fn own_command(own: &str, words: &[&str]) -> Option<String> {
    let main = if own == "book" { "book/builder/src/main.rs" } else { "book/course/src/main.rs" };
    let source = read(main);
    let known = |word: &str| {
        let arm = format!("[\"{word}\"");
        let let_arm = format!("let [\"{word}\"");
        source.contains(&arm) || source.contains(&let_arm)
    };
    let (&word, rest) = words.split_first()?;
    if !known(word) {
        return Some(format!("no command {word}"));
    }
    let unknown_option =
        |word: &&&str| word.starts_with("--") && !source.contains(&format!("\"{word}\""));
    if let Some(option) = rest.iter().find(unknown_option) {
        return Some(format!("no option {option}"));
    }
    let name = rest.first().filter(|name| !is_placeholder(name) && !name.starts_with("--"))?;
    let list = if own == "book" {
        "book/large.toml".to_owned()
    } else {
        format!("book/course/tests/{name}.rs")
    };
    let is_known =
        if own == "book" { read(&list).contains(&format!("[{name}]")) } else { exists(&list) };
    (!is_known).then(|| format!("no {name} in {list}"))
}

fn read(path: &str) -> String {
    std::fs::read_to_string(Path::new(ROOT).join(path)).unwrap_or_default()
}

fn exists(path: &str) -> bool {
    Path::new(ROOT).join(path).exists()
}

/// Packages of the workspace and the one of Python, by their names.
fn crates() -> &'static BTreeSet<String> {
    static CRATES: LazyLock<BTreeSet<String>> = LazyLock::new(|| {
        let is_manifest = |file: &&PathBuf| file.ends_with("Cargo.toml");
        let name = |file: &PathBuf| {
            let text = read(file.to_str()?);
            let line = text.lines().find_map(|line| line.strip_prefix("name = \""))?;
            Some(line.trim_end_matches('"').to_owned())
        };
        FILES.iter().filter(is_manifest).filter_map(name).collect()
    });
    &CRATES
}

/// True if a word names a file or directory: it has a slash or an ending, and nothing that paths of this project have not.
fn is_path(word: &str) -> bool {
    let word = word.split('#').next().unwrap_or("");
    let letters = |c: char| c.is_ascii_alphanumeric() || "_-./".contains(c);
    let ending =
        word.rsplit_once('.').is_some_and(|(stem, end)| !stem.is_empty() && ENDINGS.contains(&end));
    let first = word.trim_start_matches("./").split('/').next().unwrap_or("");
    let directory = word.contains('/') && DIRECTORIES.contains(first);
    !word.is_empty() && word.chars().all(letters) && (ending || directory)
}

/// Files below the root, those of [`WRITTEN`] directories left out.
static FILES: LazyLock<Vec<PathBuf>> = LazyLock::new(|| {
    let mut files = Vec::new();
    let mut directories = vec![PathBuf::new()];
    while let Some(directory) = directories.pop() {
        for entry in std::fs::read_dir(Path::new(ROOT).join(&directory)).unwrap() {
            let entry = entry.unwrap();
            let path = directory.join(entry.file_name());
            let is_cache = entry.file_name().to_string_lossy().contains("cache");
            if is_cache || WRITTEN.iter().any(|written| path == Path::new(written)) {
                continue;
            }
            let kind = entry.file_type().unwrap();
            if kind.is_dir() { directories.push(path) } else { files.push(path) }
        }
    }
    files.sort();
    files
});

/// Names of all directories.
static DIRECTORIES: LazyLock<BTreeSet<String>> = LazyLock::new(|| {
    let names = FILES.iter().flat_map(|file| file.ancestors().skip(1).filter_map(Path::file_name));
    names.map(|name| name.to_string_lossy().into_owned()).collect()
});

/// Programs of the workspace.
static PROGRAMS: LazyLock<Vec<(PathBuf, String)>> = LazyLock::new(|| {
    let programs = FILES.iter().filter(|file| file.extension().is_some_and(|end| end == "rs"));
    programs.map(|file| (file.clone(), read(file.to_str().unwrap()))).collect()
});

/// `None` if there is a file or directory whose path ends so: from the root, beside the text, or anywhere by its last
/// names.
fn missing(path: &str, beside: &Path) -> Option<String> {
    let path = path.split('#').next().unwrap_or("").trim_end_matches('/');
    let is_written = |root: &str| path == root || path.starts_with(&format!("{root}/"));
    let tail = Path::new(path.trim_start_matches("./").trim_start_matches("../"));
    // A program writes it, or a test is named without its ending.
    let is_named = || {
        let name = path.rsplit('/').next().unwrap_or(path);
        PROGRAMS.iter().any(|(file, text)| {
            file.starts_with("examples") && text.contains(&format!("\"{name}\""))
                || file.ends_with(format!("{path}.rs"))
        })
    };
    let is_there = Path::new(ROOT).join(path).exists()
        || beside.join(path).exists()
        || is_named()
        || FILES.iter().any(|file| file.ancestors().any(|part| part.ends_with(tail)));
    (!is_there && !WRITTEN.into_iter().any(is_written)).then(|| format!("{path} does not exist"))
}

/// Every text: its path, what it says, whether its paths are looked at.
fn texts() -> Vec<(PathBuf, String, bool)> {
    let comments = |text: &str| {
        let lines = text.lines().map(|line| {
            let line = line.trim_start();
            let comment = line.strip_prefix("//!").or_else(|| line.strip_prefix("///"));
            comment.unwrap_or("").strip_prefix(' ').unwrap_or("").to_owned() + "\n"
        });
        lines.collect::<String>()
    };
    let mut texts = Vec::new();
    for file in FILES.iter() {
        let name = file.to_str().unwrap();
        match file.extension().and_then(|end| end.to_str()) {
            Some("md") => texts.push((file.clone(), read(name), true)),
            Some("toml") if name.starts_with("book/") => {
                texts.push((file.clone(), read(name), true))
            }
            Some("rs") => texts.push((file.clone(), comments(&read(name)), false)),
            _ => {}
        }
    }
    texts
}

/// The option that a piece of code begins with, `--tau 1.6`, is one of an example that the text names, or of the book.
fn unknown_option(code: &str, text: &str) -> Option<String> {
    static HELP: LazyLock<Vec<(String, String)>> = LazyLock::new(|| {
        let help = |name: &String| {
            let output = program(name).arg("--help").output().unwrap();
            (name.clone(), String::from_utf8_lossy(&output.stdout).into_owned())
        };
        // In turn: a thread that waits here for others would take a task that waits for this list.
        names().iter().map(help).collect()
    });
    let option = code.split([' ', '=']).next().unwrap_or("");
    let is_letter = |c: char| c.is_alphanumeric() || c == '_' || c == '-';
    let has = |text: &str, word: &str| {
        text.split(|c| !is_letter(c)).any(|part| part.trim_end_matches('-') == word)
    };
    let named: Vec<_> = HELP.iter().filter(|(name, _)| has(text, name)).collect();
    let is_of_examples = match named.is_empty() {
        true => HELP.iter().any(|(_, help)| has(help, option)),
        false => named.iter().any(|(_, help)| has(help, option)),
    };
    let builder = [read("book/builder/src/main.rs"), read("book/builder/src/examples.rs")].concat();
    let is_known = is_of_examples || builder.contains(&format!("\"{option}\""));
    (!is_known).then(|| format!("no example that the text names has {option}"))
}

/// `Function::from_fn`, `gamma(..)`.
fn is_name(code: &str) -> bool {
    let head = code.split('(').next().unwrap_or("");
    let is_whole = head.len() == code.len() || code.ends_with(')');
    is_whole && !head.is_empty() && head.chars().all(|c| c.is_alphanumeric() || "_:".contains(c))
}

/// A part of a name that no program, list or data of the repository has.
fn unknown_name(code: &str) -> Option<String> {
    static KNOWN: LazyLock<BTreeSet<String>> = LazyLock::new(|| {
        let ends = |file: &&PathBuf| {
            let end = file.extension().and_then(|end| end.to_str());
            matches!(end, Some("rs" | "py" | "toml" | "json")) && !file.ends_with("commands.rs")
        };
        let words = |file: &PathBuf| {
            let text = read(file.to_str().unwrap());
            let words = text.split(|c: char| !c.is_alphanumeric() && c != '_');
            words.map(str::to_owned).collect::<Vec<_>>()
        };
        FILES.iter().filter(ends).flat_map(words).collect()
    });
    let head = code.split('(').next().unwrap_or("");
    let unknown = head.split(':').find(|part| !part.is_empty() && !KNOWN.contains(*part))?;
    Some(format!("no program has the name {unknown}"))
}

/// What is wrong with the commands, names and paths of a text.
fn faults(file: &Path, text: &str, with_paths: bool) -> Vec<String> {
    // Exercises stand at the end of pages.
    let place = if file.ends_with("exercises.toml") {
        Path::new("book/src")
    } else {
        file.parent().unwrap()
    };
    let (beside, whole) = (Path::new(ROOT).join(place), text);
    let mut found = Vec::new();
    for (line, part) in parts(text) {
        let (text, what) = match &part {
            Part::Command(command) => (command, fault(command, &beside)),
            Part::Code(code) if is_command(code) => {
                let faults = commands(code).into_iter().filter_map(|one| fault(&one, &beside));
                (code, faults.reduce(|a, b| format!("{a}; {b}")))
            }
            Part::Code(code) if with_paths && code.starts_with("--") => {
                (code, unknown_option(code, whole))
            }
            Part::Code(code) if with_paths && is_name(code) => (code, unknown_name(code)),
            Part::Code(code) if with_paths && is_path(code) && !is_placeholder(code) => {
                (code, missing(code, &beside))
            }
            Part::Link(goal) if with_paths && !goal.contains("://") && !goal.starts_with('#') => {
                let goal_file = goal.split('#').next().unwrap_or("");
                let is_there = beside.join(goal_file).exists() || goal.starts_with("mailto:");
                (goal, (!is_there).then(|| "the link leads nowhere".to_owned()))
            }
            _ => continue,
        };
        found.extend(what.map(|what| format!("{}:{line}: `{text}`: {what}", file.display())));
    }
    found
}

/// Code in a sentence that one types into a shell: a program and at least one word.
fn is_command(code: &str) -> bool {
    let program = code.split(' ').next().unwrap_or("");
    let is_program =
        program == "cargo" || program.starts_with(".ci/") || FOREIGN.contains(&program);
    is_program && code.contains(' ')
}

#[test]
fn every_command_and_path_of_a_text_exists() {
    let texts = texts();
    let count = |end: &str| {
        texts.iter().filter(|(file, ..)| file.extension().is_some_and(|e| e == end)).count()
    };
    assert!(count("md") > 100 && count("rs") > 200, "{} {}", count("md"), count("rs"));
    let found: Vec<String> =
        texts.par_iter().flat_map_iter(|(file, text, paths)| faults(file, text, *paths)).collect();
    assert!(found.is_empty(), "{}", found.join("\n"));
}

/// Each kind of fault is found.
#[test]
fn commands_and_paths_that_do_not_exist_are_found() {
    for (text, what) in [
        ("see `cargo book print`", "no command print"),
        ("`cargo book serve --prot 80`", "no option --prot"),
        ("`cargo book large nothing`", "no nothing in book/large.toml"),
        ("```sh\ncargo run --release --example nothing\n```", "no example nothing"),
        ("```sh\ncargo run --example tour -- --load \"0, 1\"\n```", "'--load'"),
        ("`cargo run --example lemma_5_2_poincare_scaling -- --nu 2`", "outside (0, 1)"),
        ("`cargo test --release --test appendix_c`", "no test appendix_c"),
        ("`cargo test --test appendix_a nothing`", "no test or module has nothing"),
        ("`cargo test\n-p nothing`", "no package nothing"),
        ("`cargo course skeleton after`", "no after in book/course/tests/after.rs"),
        ("```sh\n$ frobnicate now\n```", "unknown command"),
        ("```sh\ncargo fetch && python3 nothing.py # so\n```", "nothing.py does not exist"),
        ("`cargo run --example one_segment`, and with `--load 1`", "has --load"),
        ("call `Function::from_nothing(f)`", "no program has the name from_nothing"),
        ("in `src/known.rs`", "src/known.rs does not exist"),
        ("in `src/lib.rs`, [here](no.md)", "the link leads nowhere"),
    ] {
        let found = faults(Path::new("TEXT.md"), text, true);
        assert!(found.len() == 1 && found[0].contains(what), "{text}: {found:?}");
    }
    let good = "`cargo test --release --test SECTION NAME`, `cargo book`, `h/2`, `src/lib.rs`, [a](README.md#b)\n\n\
        ```sh\n.ci/run # all\ncargo run --example tour -- --tau 1.6,\\\n1.9 && cd book\n```\n\n```text\ncargo nothing\n```";
    assert_eq!(faults(Path::new("TEXT.md"), good, true), Vec::<String>::new());
}
