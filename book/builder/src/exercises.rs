//! Exercises at the end of pages, from `exercises.toml`: what is asked, a hint, a solution, both folded.
//!
//! A table per exercise, under the name of its page: `kind` is `why`, `prove`, `number` or `try`; `ask` and
//! `answer` are Markdown as on a page, `hint` may be left out. The answer of a `number` is one that an
//! example computed, so it holds a `{{value: ...}}` or a `{{finding: ...}}`. `program` names a program of `book/course`. A page with exercises has two to
//! eight, and asks at least one "why".

use crate::chapter::Page;
use crate::error::{Error, Fault, Result, read};
use serde_json::Value;
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;

/// The file below the directory of the book.
pub const FILE: &str = "exercises.toml";

/// An exercise.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Exercise {
    kind: Kind,
    ask: String,
    hint: Option<String>,
    answer: String,
    /// `file::function` of the course's programs that the exercise asks for.
    program: Option<String>,
}

/// What an exercise asks for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Why,
    Prove,
    Number,
    Try,
}

impl Kind {
    fn parse(word: &str) -> Option<Self> {
        Some(match word {
            "why" => Kind::Why,
            "prove" => Kind::Prove,
            "number" => Kind::Number,
            "try" => Kind::Try,
            _ => return None,
        })
    }

    fn word(self) -> &'static str {
        match self {
            Kind::Why => "Why?",
            Kind::Prove => "Prove.",
            Kind::Number => "Compute.",
            Kind::Try => "Try.",
        }
    }
}

/// Exercises by the name of their page; none where there is no file.
///
/// # Errors
/// [`Error::Data`] with what is wrong in the file.
pub fn list(book: &Path) -> Result<BTreeMap<String, Vec<Exercise>>> {
    let path = book.join(FILE);
    if !path.exists() {
        return Ok(BTreeMap::new());
    }
    let wrong = |message: String| Error::Data { path: path.clone(), message };
    let parsed: Value = toml::from_str(&read(&path)?).map_err(|e| wrong(e.to_string()))?;
    let mut found = BTreeMap::new();
    for (page, entries) in parsed.as_object().into_iter().flatten() {
        let entries =
            entries.as_array().ok_or_else(|| wrong(format!("{page}: [[{page}]] expected")))?;
        let exercises: std::result::Result<Vec<_>, String> = entries.iter().map(exercise).collect();
        found.insert(page.clone(), exercises.map_err(|what| wrong(format!("{page}: {what}")))?);
    }
    Ok(found)
}

fn exercise(entry: &Value) -> std::result::Result<Exercise, String> {
    let text = |key: &str| entry[key].as_str().map(|text| text.trim().to_owned());
    let ask = text("ask").ok_or("an exercise without `ask`")?;
    let kind = text("kind").and_then(|word| Kind::parse(&word));
    let kind = kind.ok_or_else(|| format!("`kind` is why, prove, number or try: {ask}"))?;
    let answer = text("answer").ok_or_else(|| format!("no `answer`: {ask}"))?;
    let is_computed = answer.contains("{{value:") || answer.contains("{{finding:");
    if kind == Kind::Number && !is_computed {
        return Err(format!("the answer holds no computed number: {ask}"));
    }
    Ok(Exercise { kind, ask, hint: text("hint"), answer, program: text("program") })
}

/// What a sheet says of its programs, for those who have no book.
const PROGRAMS: &str = "
*Programs.* The commands are for the repository of signorini. The first of them is needed once for all holes of one file. \
The notebooks `book/course/before.ipynb` (sheets 1 and 2, plain Python) and `book/course/later.ipynb` (the others, numpy) \
have the same holes and the same tests.
";

impl Exercise {
    /// How to get the skeleton of its program, and how to test it.
    fn commands(&self) -> String {
        let program = self.program.as_deref().and_then(|program| program.split_once("::"));
        program.map_or(String::new(), |(file, function)| {
            format!(
                "\n```sh\ncargo course skeleton {file}\n\
                 cargo test --release -p course --test mine_{file} {function}\n```\n"
            )
        })
    }
}

/// The exercises of a page on a sheet of their own.
pub fn sheet(title: &str, list: &[Exercise], with_solutions: bool) -> String {
    let mut text =
        format!("# {title}: exercises{}\n", if with_solutions { " with solutions" } else { "" });
    for (k, exercise) in (1..).zip(list) {
        let _ = write!(
            text,
            "\n**{k}.** *{}* {}\n{}",
            exercise.kind.word(),
            exercise.ask,
            exercise.commands()
        );
        if let Some(hint) = &exercise.hint {
            let _ = write!(text, "\n*Hint.* {hint}\n");
        }
        if with_solutions {
            let _ = write!(text, "\n> *Solution.* {}\n", exercise.answer.replace('\n', "\n> "));
        }
    }
    if list.iter().any(|exercise| exercise.program.is_some()) {
        text.push_str(PROGRAMS);
    }
    text
}

/// Puts the exercises behind the text of their pages.
pub fn append(pages: &mut [Page], exercises: &BTreeMap<String, Vec<Exercise>>) {
    for page in pages {
        if let Some(list) = page.html.strip_suffix(".html").and_then(|name| exercises.get(name)) {
            page.text.push_str(&markdown(list));
        }
    }
}

fn markdown(list: &[Exercise]) -> String {
    let mut text = "\n\n## Exercises\n".to_owned();
    for (k, exercise) in list.iter().enumerate() {
        let _ = write!(text, "\n**{}.** *{}* {}\n", k + 1, exercise.kind.word(), exercise.ask);
        text.push_str(&exercise.commands());
        let folded =
            [("Hint", exercise.hint.as_deref()), ("Solution", Some(exercise.answer.as_str()))];
        for (title, body) in folded {
            if let Some(body) = body {
                let open = format!("<details class=\"answer\"><summary>{title}</summary>");
                let _ = write!(text, "\n{open}\n\n{body}\n\n</details>\n");
            }
        }
    }
    text
}

/// What is wrong with the program that an exercise asks for: it has a hole and one test.
fn wrong_program(program: &str, book: &Path) -> Option<&'static str> {
    let Some((file, function)) = program.split_once("::") else {
        return Some("`program` is file::function");
    };
    let file = book.join("course/tests").join(file).with_extension("rs");
    let text = std::fs::read_to_string(file).unwrap_or_default();
    let body =
        text.split(&format!("\nfn {function}(")).nth(1).and_then(|rest| rest.split("\n}\n").next());
    let tests =
        text.split("#[test]\nfn ").skip(1).filter(|test| test.starts_with(function)).count();
    match body {
        None => Some("no such program"),
        Some(body) if !body.contains("\n    // solution: ") => Some("a program without a hole"),
        _ if tests != 1 => {
            Some("a program needs one test, whose name begins with that of the program")
        }
        _ => None,
    }
}

/// Exercises of pages that are not there, too few or too many on a page, none that asks why; programs without a hole or a
/// test; words that a sheet without its page does not explain.
pub fn faults(
    exercises: &BTreeMap<String, Vec<Exercise>>,
    pages: &[Page],
    book: &Path,
) -> Vec<Fault> {
    let mut found = Vec::new();
    for (name, list) in exercises {
        let mut fault =
            |what: &str| found.push(Fault::new(&book.join(FILE), 1, what, name.as_str()));
        if !pages.iter().any(|page| page.html.strip_suffix(".html") == Some(name)) {
            fault("exercises of a page that is not there");
        }
        if !(2..=8).contains(&list.len()) {
            fault("a page has two to eight exercises");
        }
        for exercise in list {
            let program =
                exercise.program.as_deref().and_then(|program| wrong_program(program, book));
            program.iter().for_each(|what| fault(what));
            if ["of the page", "on this page", "of the table"]
                .iter()
                .any(|words| exercise.ask.contains(words))
            {
                fault("an exercise must be understood on a sheet, without its page");
            }
        }
        if !list.iter().any(|exercise| exercise.kind == Kind::Why) {
            fault("no exercise asks why");
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    fn with(text: &str) -> Result<BTreeMap<String, Vec<Exercise>>> {
        let directory = tempfile::tempdir().unwrap();
        std::fs::write(directory.path().join(FILE), text).unwrap();
        list(directory.path())
    }

    const GOOD: &str = "[[one]]\nkind = 'why'\nask = 'A?'\nhint = 'h'\nanswer = 'B.'\n\
        [[one]]\nkind = 'number'\nask = 'C?'\nanswer = '{{value: x}}'\n";

    #[test]
    fn what_is_missing_is_named() {
        for (from, to) in [
            ("'number'", "'sum'"),
            ("answer = 'B.'\n", ""),
            ("'{{value: x}}'", "'three'"),
            ("ask = 'A?'\n", ""),
        ] {
            assert!(GOOD.contains(from) && with(&GOOD.replace(from, to)).is_err(), "{to}");
        }
        let page = Page { file: "one.md".into(), html: "one.html".into(), text: String::new() };
        let what = |text: &str| {
            faults(&with(text).unwrap(), std::slice::from_ref(&page), Path::new("b")).len()
        };
        assert_eq!(what(GOOD), 0);
        assert_eq!(what(&GOOD.replace("'why'", "'try'")), 1);
        assert_eq!(what(&GOOD.replace("[[one]]", "[[two]]")), 1);
        assert_eq!(what(&GOOD.repeat(5)), 1);
        assert_eq!(what(&GOOD.replace("'A?'", "'Which number of the page?'")), 1);
        assert_eq!(what(&GOOD.replace("hint = 'h'", "program = 'before::none'")), 1);
        let book = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        assert_eq!(wrong_program("before::springs", &book), None);
        assert_eq!(wrong_program("before::rates", &book), Some("no such program"));
    }
}
