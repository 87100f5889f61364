//! The recipe for a new statement, "A new statement" of `book/README.md`, followed as it stands: a lemma of one's own is
//! written into a copy of the repository, at the paths that the recipe names, and its commands are run there.
//!
//! The copy shares the target directory and the times of the files, so that of all programs only the new example and
//! the test target of its section are compiled. `cargo test --package book-builder --test recipe`

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::Command;

/// What stands for `NAME` and for `SECTION`.
const NAME: &str = "lemma_of_my_own";
const SECTION: &str = "section_4";

const EXAMPLE: &str = r#"//! A lemma of my own: the line from 0 to 1 lies above the parabola.
//!
//! ```text
//! x² ≤ x        for x in [0, 1]
//! ```
//!
//! Refuted if one place has x² − x > 0.
use example_report::prelude::*;

example! { quick "Lemma of my own", "x² ≤ x for x in [0, 1]";
    /// places x
    x: Vec<f64> = "0,0.25,0.5,1" in "[0, 1]" slider "0.1 to 0.9",
}

pub(crate) fn run(options: &Options, out: &mut Report) -> Result<()> {
    for &x in &options.x {
        out.row(cells! { x => excess: x * x - x });
        out.check("excess of the parabola").at_most(x * x - x, 0.0, "the line");
    }
    out.plot("my_parabola", "Excess", Axes::Linear("x", "x² − x")).curve("x", "excess");
    Ok(())
}
"#;
const TEST: &str = "//! The lemma of my own by its derivative.

#[test]
fn the_largest_distance_is_a_quarter_at_one_half() {
    let distance = |x: f64| x - x * x;
    assert_eq!(distance(0.5), 0.25);
    assert!((1..100).all(|k| distance(f64::from(k) / 100.0) <= 0.25));
}
";
const PAGE: &str = "# A lemma of my own

{{figure: NAME/my_parabola: The parabola less the line}}

> **Lemma.** $x^2 \\le x$ for $x \\in [0, 1]$.

```sh
cargo run --release --example NAME
```

At $x = \\frac12$ the distance is {{value: NAME/excess.x0.5: f2}}. So {{finding: NAME/excess-of-the-parabola}}.

{{table: NAME}}

Status: {{verdict: NAME}}.
";
const LABEL: &str = r"
[[label]]
label = 'A lemma of my own'
group = 'GROUP'
words = 'the line from 0 to 1 lies above the parabola'
statement = '$x^2 \le x$'
example = 'NAME'
test = 'SECTION/NAME::the_largest_distance_is_a_quarter_at_one_half'
page = 'NAME'
";

fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").canonicalize().unwrap()
}

/// Files of the repository but for what is built or computed, from its root.
fn files(root: &Path) -> BTreeSet<PathBuf> {
    let mut found = BTreeSet::new();
    let mut left = vec![PathBuf::new()];
    while let Some(directory) = left.pop() {
        for entry in std::fs::read_dir(root.join(&directory)).unwrap() {
            let entry = entry.unwrap();
            let path = directory.join(entry.file_name());
            let is_built = ["target", ".git", "book/html", "python/target", "out"];
            if is_built.iter().any(|built| path == Path::new(built)) {
                continue;
            }
            if entry.file_type().unwrap().is_dir() {
                left.push(path);
            } else {
                found.insert(path);
            }
        }
    }
    found
}

/// Copies a repository with the times of its files, by which Cargo sees that nothing is to be compiled again.
fn copy(from: &Path, to: &Path) {
    for file in files(from) {
        let (old, new) = (from.join(&file), to.join(&file));
        std::fs::create_dir_all(new.parent().unwrap()).unwrap();
        std::fs::copy(&old, &new).unwrap();
        let time = old.metadata().unwrap().modified().unwrap();
        std::fs::File::options().write(true).open(&new).unwrap().set_modified(time).unwrap();
    }
}

/// The section of the recipe: the paths that its steps begin with, and its commands.
fn recipe(readme: &str) -> (Vec<String>, Vec<String>) {
    let section = readme.split("## A new statement").nth(1).unwrap().split("\n## ").next().unwrap();
    let steps = section.lines().filter_map(|line| {
        let (number, rest) = line.split_once(". `")?;
        number.parse::<usize>().ok()?;
        rest.split('`').next().map(str::to_owned)
    });
    let commands = section.split("```sh\n").nth(1).unwrap().split("```").next().unwrap().lines();
    let commands = commands.filter_map(|line| line.split(" # ").next());
    (steps.collect(), commands.map(|command| command.trim().to_owned()).collect())
}

fn filled(text: &str) -> String {
    text.replace("NAME", NAME).replace("SECTION", SECTION)
}

/// Does what a step of the recipe says with the file that it names.
fn step(root: &Path, path: &str) {
    let file = root.join(filled(path));
    let known = || std::fs::read_to_string(&file).unwrap();
    let text = match path {
        "examples/NAME.rs" => EXAMPLE.to_owned(),
        "tests/SECTION/NAME.rs" => TEST.to_owned(),
        "tests/SECTION/main.rs" => known() + &filled("\nmod NAME;\n"),
        "book/src/NAME.md" => filled(PAGE),
        "book/src/SUMMARY.md" => known() + &filled("- [A lemma of my own](NAME.md)\n"),
        "labels.toml" => {
            let known = known();
            let group = known.rsplit("group = '").next().unwrap().split('\'').next().unwrap();
            let label = filled(LABEL).replace("GROUP", group);
            known + &label
        }
        other => panic!("a step of the recipe about {other}, which this test does not know"),
    };
    std::fs::write(&file, text).unwrap();
}

/// Runs a command of the recipe in the copy.
fn run(root: &Path, target: &Path, command: &str) -> String {
    let words: Vec<String> = command.split_whitespace().map(filled).collect();
    let mut command = Command::new(&words[0]);
    // What Cargo says to this test is about another package.
    let own = std::env::vars_os().map(|(name, _)| name);
    let of_cargo = own.filter(|name| {
        let name = name.to_string_lossy();
        name.starts_with("CARGO_PKG") || name.starts_with("CARGO_MANIFEST") || name == "CARGO"
    });
    of_cargo.for_each(|name| drop(command.env_remove(name)));
    let output = command
        .args(&words[1..])
        .current_dir(root)
        .env("CARGO_TARGET_DIR", target)
        .env("CARGO_NET_OFFLINE", "true")
        .output()
        .unwrap();
    let [out, error] = [&output.stdout, &output.stderr].map(|b| String::from_utf8_lossy(b));
    assert!(output.status.success(), "{words:?}: {}\n{out}\n{error}", output.status);
    let compiled: Vec<&str> = error.lines().filter(|line| line.contains("Compiling ")).collect();
    eprintln!("{}: {compiled:?}", words.join(" "));
    out.into_owned()
}

#[test]
fn a_statement_is_added_by_the_recipe() {
    let original = repository();
    let copied = tempfile::tempdir().unwrap();
    let root = copied.path().canonicalize().unwrap();
    copy(&original, &root);
    let readme = std::fs::read_to_string(root.join("book/README.md")).unwrap();
    let (steps, commands) = recipe(&readme);
    assert!(steps.len() == 6 && commands.len() == 5, "{steps:?} {commands:?}");
    let target = std::env::current_exe().unwrap();
    let target = target.ancestors().nth(3).unwrap().to_owned(); // TARGET/debug/deps/recipe

    steps.iter().for_each(|path| step(&root, path));
    let printed: Vec<String> =
        commands.iter().map(|command| run(&root, &target, command)).collect();
    let example = target.join("release/examples").join(NAME);
    std::fs::remove_file(example).unwrap();

    assert!(printed[1].contains("excess of the parabola") && printed[1].contains("status: true"));
    assert!(printed[3].contains("1 passed"), "{}", printed[3]);
    let read = |path: &str| std::fs::read_to_string(root.join(filled(path))).unwrap();
    let page = read("book/pages/NAME.md");
    assert!(page.contains("the distance is −0.25") && page.contains("Status: true"), "{page}");
    assert!(read("book/src/every_label.md").contains("| A lemma of my own |"));
    assert!(read("src/book.rs").contains(&filled("NAME: \"NAME.md\",")));
    // What else changed is what the recipe says is written.
    let is_written = |file: &&PathBuf| {
        let name = file.to_string_lossy();
        let written = ["book/generated/", "book/pages/", "book/src/every_label.md", "src/book.rs"];
        let is_step = steps.iter().any(|step| *name == filled(step));
        is_step || written.iter().any(|start| name.starts_with(start))
    };
    let same = |file: &&PathBuf| {
        std::fs::read(root.join(file)).ok() == std::fs::read(original.join(file)).ok()
    };
    let now = files(&root);
    let other: Vec<&PathBuf> = now.iter().filter(|f| !same(f)).filter(|f| !is_written(f)).collect();
    assert!(other.is_empty(), "{other:?}");
}
