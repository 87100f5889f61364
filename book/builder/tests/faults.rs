//! A small book builds; every fault put into it fails, and the message names file, line and offending text.

use book_builder::data::Data;
use book_builder::error::Error;
use book_builder::{Layout, build, check_fresh, check_pages, shown};
use serde_json::json;
use std::path::Path;
use tempfile::TempDir;

const FIRST: &str = "# First {#first}

{{figure: ex/chart: gamma against theta}}

$$
\\begin{equation} \\gamma_\\theta \\le C \\tag{5.2} \\label{bound} \\end{equation}
$$

It is {{value: gamma: s4}}, see [the second page](second.md#two). {{table: ex}}
";
const SECOND: &str = "# Second {#two}

{{idea: wave: A wave}}

By $\\eqref{bound}$ and Lemma 5.2 the verdict is: {{verdict: ex}}.

```rust,ignore
{{#include ../../examples/ex.rs:run}}
```

{{code: ex: walk}}

{{slider: chart: one = ex/chart, two = ex/other: Two charts}}

Backed by {{example: ex}} and {{test: lemma::holds}}: `cargo run --example ex`.
";
const CHART: &str = r##"<svg width="640" height="480" xmlns="http://www.w3.org/2000/svg"><path d="M100 200" stroke="#000000"/></svg>"##;

/// A repository with a book of two pages.
struct Fixture(TempDir);

impl Fixture {
    fn new() -> Self {
        let fixture = Self(tempfile::tempdir().unwrap());
        let toml =
            std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../book.toml"))
                .unwrap();
        fixture.write("book/book.toml", &toml);
        fixture.write("book/style/slider.js", "");
        fixture.write("book/style/fit.js", "");
        fixture.write("book/style/live.js", "");
        fixture.write("book/style/book.css", "math { font-family: math; }");
        fixture.write("book/ideas/wave.svg", CHART);
        fixture.write(
            "book/src/SUMMARY.md",
            "# Summary\n\n- [First](first.md)\n- [Second](second.md)\n",
        );
        fixture.write("book/src/first.md", &FIRST.replace(" {{table: ex}}", "\n\n{{table: ex}}"));
        fixture.write("book/src/second.md", SECOND);
        let chapters = "    readme: \"../../README.md\",\n    first: \"first.md\",\n    second: \"second.md\",\n";
        fixture
            .write("src/book.rs", &format!("    // chapters\n{chapters}    // end of chapters\n"));
        fixture.write(
            "examples/ex.rs",
            "// ANCHOR: run\nfn main() {}\n// ANCHOR_END: run\n\nfn walk() {}\n",
        );
        fixture.write("tests/lemma.rs", "#[test]\nfn holds() {}\n");
        data(0.29156).write(&fixture.layout().generated()).unwrap();
        fixture
    }

    fn layout(&self) -> Layout {
        Layout::of(self.0.path())
    }

    fn write(&self, path: &str, text: &str) {
        let path = self.0.path().join(path);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, text).unwrap();
    }

    fn read(&self, path: &str) -> String {
        std::fs::read_to_string(self.0.path().join(path)).unwrap()
    }

    fn build(&self) -> Result<(), Error> {
        build(&self.layout(), &Data::read(&self.layout().generated())?).map(|_| ())
    }
}

/// File, text in it, what it is replaced by: a fault at this page and line with these words.
fn expect(rows: &[(&str, &str, &str, &str, &str)]) {
    let file = |name: &str| match name.contains('/') {
        true => name.to_owned(),
        false => format!("book/src/{name}.md"),
    };
    for (path, from, to, place, words) in rows {
        let fixture = Fixture::new();
        let text = fixture.read(&file(path));
        assert!(text.contains(from), "{from}");
        fixture.write(&file(path), &text.replace(from, to));
        let message = fixture.build().expect_err(to).to_string();
        let (page, line) = place.split_once(':').unwrap();
        let place = format!("{}:{}:", file(page), line.trim_end_matches(':'));
        let found = message.lines().any(|line| line.starts_with(&place) && line.contains(words));
        assert!(found, "expected {place} ... {words}, got\n{message}");
    }
}

fn data(gamma: f64) -> Data {
    let example = json!({
        "label": "Lemma 5.2", "claim": "c", "measured": "m", "verdict": "holds", "confirmed": true,
        "values": {"gamma": gamma},
        "columns": [{"key": "theta", "title": "theta", "meaning": "zone"}],
        "rows": [["1e-3"]],
    });
    let figures = [
        ("ex/chart".to_owned(), CHART.to_owned()),
        ("ex/other".to_owned(), CHART.to_owned()),
        ("ex/unused".to_owned(), CHART.to_owned()),
    ];
    Data {
        examples: [("ex".to_owned(), example)].into_iter().collect(),
        figures: figures.into(),
        ..Data::default()
    }
}

#[test]
fn numbers_behind_a_chart_stand_beside_it() {
    let fixture = Fixture::new();
    fixture.write("book/generated/figures/ex/chart.csv", "series,x,y\na,1,2\n");
    fixture.build().unwrap();
    assert_eq!(fixture.read("book/html/data/ex.chart.csv"), "series,x,y\na,1,2\n");
    assert!(fixture.read("book/html/first.html").contains("href=\"data/ex.chart.csv\" download"));
    let committed = Data::read(&fixture.layout().generated()).unwrap();
    let mut computed = committed.clone();
    computed.series.insert("ex/chart".to_owned(), "series,x,y\na,1,3\n".to_owned());
    let message = check_fresh(&fixture.layout(), &committed, &computed).unwrap_err().to_string();
    assert!(message.contains("figures/ex/chart.csv"), "{message}");
}

#[test]
fn a_sound_book_builds_and_is_complete() {
    let fixture = Fixture::new();
    fixture.build().unwrap();
    let first = fixture.read("book/html/first.html");
    for part in [
        "role=\"img\"",
        "aria-label=\"gamma against theta\"",
        "stroke=\"currentColor\"",
        "0.2916",
        "(5.2)",
    ] {
        assert!(first.contains(part), "{part}");
    }
    let second = fixture.read("book/html/second.html");
    assert!(second.contains("href=\"first.html#bound\""), "{second}");
    assert!(
        second.contains("fn main() {}")
            && second.contains("fn walk() {}")
            && second.contains("verdict is: holds.")
            && second.contains("<code>lemma::<wbr>holds</code>"),
        "{second}"
    );
    assert!(fixture.0.path().join("book/html/fonts/NewCMMath-Regular.otf").is_file());
    for name in ["first.html", "second.html", "index.html", "print.html", "toc.js"] {
        let text = fixture.read(&format!("book/html/{name}"));
        assert!(!text.contains(['\u{E000}', '\u{E001}']), "mark left in {name}");
        for reference in ["src=\"http", "href=\"http", "url(http", "=\"//"] {
            assert!(!text.contains(reference), "{reference} in {name}");
        }
    }
}

/// Words and numbers that directives stand for are found by the search, and the index holds no mark.
#[test]
fn search_and_print_page_are_there() {
    let fixture = Fixture::new();
    fixture.build().unwrap();
    let index = fixture.read("book/html/searchindex.js");
    for part in ["the verdict is: holds", "It is 0.2916", "first.html#first"] {
        assert!(index.contains(part), "{part}");
    }
    assert!(!index.contains(['\u{E000}', '\u{E001}']));
    assert!(fixture.read("book/html/first.html").contains("id=\"mdbook-search-toggle\""));
    let print = fixture.read("book/html/print.html");
    assert!(print.contains("id=\"first\"") && print.contains("id=\"two\""));
}

/// The pages to be read without a build: numbers, formulas, pictures, code and links in plain Markdown.
#[test]
fn plain_pages_are_written_and_compared() {
    let fixture = Fixture::new();
    fixture.build().unwrap();
    let first = fixture.read("book/pages/first.md");
    for part in [
        "![Picture](../generated/figures/ex/chart.svg)\n\n*gamma against theta*",
        "$$\\gamma_\\theta \\le C \\tag{5.2}$$",
        "It is 0.2916, see",
        "| θ |\n| --- |\n| 10<sup>−3</sup> |",
    ] {
        assert!(first.contains(part), "{part} is not in {first}");
    }
    let second = fixture.read("book/pages/second.md");
    for part in [
        "![Picture](../ideas/wave.svg)\n\n*A wave*",
        "By [(5.2)](first.md) and Lemma 5.2 the verdict is: holds.",
        "```rust\nfn main() {}\n```",
        "```rust\nfn walk() {}\n```",
        "(chart: one; also [two](../generated/figures/ex/other.svg))",
        "[`ex`](../../examples/ex.rs) and `lemma::holds`",
    ] {
        assert!(second.contains(part), "{part} is not in {second}");
    }
    let layout = fixture.layout();
    let check = || check_pages(&layout, &Data::read(&layout.generated()).unwrap()).map(|_| ());
    check().unwrap();
    fixture.write("book/pages/first.md", &first.replace("0.2916", "0.2917"));
    fixture.write("book/pages/third.md", "");
    let message = check().unwrap_err().to_string();
    let line = 1 + first.lines().position(|line| line.contains("0.2916")).unwrap();
    assert!(message.starts_with(&format!("book/pages/first.md:{line}: not what")), "{message}");
    assert!(message.contains("book/pages/third.md:1: no page of the book"), "{message}");
    fixture.build().unwrap();
    check().unwrap();
}

#[test]
fn faults_of_formulas_fail() {
    expect(&[
        ("first", "\\le C", "\\nosuch C", "first:5", "`\\nosuch`"),
        ("first", "\\le C", "\\frac{", "first:5", "does not parse"),
        ("second", "$\\eqref{bound}$", "$\\eqref{nowhere}$", "second:5", "`nowhere`"),
        ("first", "\\label{bound}", "", "second:5", "`bound`"),
        ("second", "the verdict", "$x + the verdict", "second:5", "closing dollar"),
    ]);
}

#[test]
fn faults_of_keys_fail() {
    expect(&[
        ("first", "value: gamma:", "value: delta:", "first:9", "`value: delta: s4`"),
        ("first", "s4}}", "z4}}", "first:9", "unknown format z4"),
        ("first", "ex/chart", "ex/none", "first:3", "unknown figure"),
        ("second", "{{idea: wave: A wave}}", "", "second:1", "open with a picture"),
        ("second", "ex/other", "ex/none", "second:13", "unknown figure"),
        ("second", ": Two charts", "", "second:13", "without a caption"),
        ("second", "verdict: ex", "verdict: no", "second:5", "unknown example"),
        ("second", "ex.rs:run", "ex.rs:walk", "second:8", "no such anchor"),
        ("second", "ex: walk", "ex: swim", "second:11", "no such function"),
        ("src/book.rs", "second.md", "", "src/book.rs:2:", "not what its list says"),
    ]);
}

#[test]
fn damaged_values_fail_with_their_line() {
    let fixture = Fixture::new();
    let (path, sound) = ("book/generated/values.json", fixture.read("book/generated/values.json"));
    let said = |text: &[u8]| {
        std::fs::write(fixture.0.path().join(path), text).unwrap();
        let message = fixture.build().expect_err("a damaged file").to_string();
        assert_eq!(message.lines().count(), 1, "{message}");
        assert!(message.contains(path), "{message}");
        message
    };
    // Torn at every line, and a word that is no JSON in every line.
    let lines: Vec<&str> = sound.lines().collect();
    for cut in 1..lines.len() {
        said(lines[..cut].join("\n").as_bytes());
        let mut spoilt = lines.clone();
        spoilt[cut] = "NaN";
        let message = said(spoilt.join("\n").as_bytes());
        assert!(message.contains(&format!("{path}:{}: damaged", cut + 1)), "{cut}: {message}");
    }
    for bad in [&b"[1]"[..], b"3", b"", b"\xff\xfe", b"{\"ex\": 1e999}"] {
        said(bad);
    }
}

#[test]
fn values_of_another_shape_fail_on_the_pages_that_show_them() {
    let values = |from: &str, to: &str, place: &str, words: &str| {
        let fixture = Fixture::new();
        let path = "book/generated/values.json";
        let object: serde_json::Value = serde_json::from_str(&fixture.read(path)).unwrap();
        let text = object.to_string();
        assert!(text.contains(from), "{from} is not in {text}");
        fixture.write(path, &text.replace(from, to));
        let message = fixture.build().expect_err(to).to_string();
        let found = message.lines().any(|line| line.starts_with(place) && line.contains(words));
        assert!(found, "expected {place} ... {words}, got\n{message}");
    };
    let (number, table) = ("book/src/first.md:9:", "book/src/first.md:11:");
    values("0.29156", "\"0.3\"", number, "unknown key");
    values("0.29156", "null", number, "unknown key");
    values("{\"gamma\":0.29156}", "[]", number, "unknown key");
    values("[[\"1e-3\"]]", "null", table, "damaged table");
    values("[[\"1e-3\"]]", "[[1e-3]]", table, "damaged table");
    values("[[\"1e-3\"]]", "[[\"1\", \"2\"]]", table, "damaged table");
    values("\"title\"", "\"name\"", table, "damaged table");
    values("\"holds\"", "0", "book/src/second.md:5:", "unknown example");
}

/// A remark that is undecided is shown as such; a claim that is undecided is none that a page may make.
#[test]
fn a_claim_that_is_undecided_fails_where_it_is_made() {
    let (picture, page) =
        ("{{idea: wave: A wave}}\n", "{{idea: wave: A wave}}\n\nSo {{finding: ex/sharp}}.\n");
    let built = |role: &str, outcome: &str, words: &str| {
        let fixture = Fixture::new();
        let text = fixture.read("book/src/second.md").replace(picture, page);
        fixture.write("book/src/second.md", &text);
        let mut data = data(0.29156);
        data.examples["ex"]["findings"] = json!([{"finding": "sharp", "role": role, "outcome": outcome, words: "it is", "comparison": "1"}]);
        data.write(&fixture.layout().generated()).unwrap();
        fixture.build().map(|()| fixture.read("book/html/second.html"))
    };
    for outcome in ["holds", "by proof"] {
        built("claim", outcome, "words").unwrap();
    }
    let shown = built("remark", "undecided", "words").unwrap();
    assert!(shown.contains("<strong class=\"outcome\">undecided:</strong>"), "{shown}");
    for (role, outcome, words, expected) in [
        ("claim", "undecided", "words", "the claim is undecided"),
        ("claim", "fails", "words", "the claim fails"),
        ("remark", "holds", "text", "damaged finding"),
    ] {
        let message = built(role, outcome, words).unwrap_err().to_string();
        let place = "book/src/second.md:5: ";
        assert!(message.starts_with(place) && message.contains(expected), "{message}");
        assert!(message.contains("finding: ex/sharp") && message.lines().count() == 1, "{message}");
    }
}

#[test]
fn unknown_directives_fail() {
    expect(&[
        ("first", "{{value: gamma: s4}}", "{{valve: gamma}}", "first:9", "unknown directive"),
        ("first", "{{value: gamma: s4}}", "{{}}", "first:9", "unknown directive"),
        ("first", "{{table: ex}}", "{{table: none}}", "first:11", "unknown example"),
        ("second", "{{verdict: ex}}", "{{verdict: ex: f2}}", "second:5", "unknown directive"),
    ]);
}

#[test]
fn a_figure_that_is_missing_or_torn_fails_where_it_is_shown() {
    for (spoil, words) in
        [("", "figure"), ("<svg width=\"1\"", "figure"), ("not a picture", "figure")]
    {
        let fixture = Fixture::new();
        fixture.write("book/generated/figures/ex/chart.svg", spoil);
        let message = fixture.build().expect_err(spoil).to_string();
        let at = |place: &str| {
            message.lines().any(|line| line.starts_with(place) && line.contains(words))
        };
        assert!(at("book/src/first.md:3:") && at("book/src/second.md:13:"), "{message}");
    }
    let fixture = Fixture::new();
    std::fs::remove_file(fixture.0.path().join("book/generated/figures/ex/chart.svg")).unwrap();
    let message = fixture.build().unwrap_err().to_string();
    assert!(message.starts_with("book/src/first.md:3: unknown figure"), "{message}");
}

#[test]
fn examples_tests_and_commands_that_do_not_exist_fail() {
    expect(&[
        ("second", "{{example: ex}}", "{{example: no}}", "second:15", "unknown example"),
        ("second", "lemma::holds", "theorem::holds", "second:15", "unknown test file"),
        ("second", "lemma::holds", "lemma::fails", "second:15", "no such test"),
        ("second", "--example ex", "--example no", "second:15", "unknown example: `no`"),
        (
            "second",
            "Backed by",
            "Backed by `src/no.rs`,",
            "second:15",
            "does not exist: `src/no.rs`",
        ),
    ]);
    let fixture = Fixture::new();
    fixture.write("examples/alone.rs", "fn main() {}\n");
    let message = fixture.build().unwrap_err().to_string();
    assert!(message.starts_with("examples/alone.rs:1: no page shows what"), "{message}");
}

#[test]
fn formulas_in_unmarked_places_fail() {
    expect(&[("first", "# First", "# First $x$", "first:1", "formula in a heading")]);
    expect(&[(
        "first",
        "# First",
        "# Other",
        "first:1",
        "not the title that SUMMARY.md gives the page",
    )]);
    let twice = "$\\begin{equation} x \\label{bound} \\end{equation}$ by $\\eqref{bound}$";
    expect(&[("second", "$\\eqref{bound}$", twice, "second:5", "label given twice")]);
}

#[test]
fn faults_of_links_fail() {
    expect(&[
        ("first", "second.md#two", "third.md", "first:9", "dead link: `third."),
        (
            "first",
            "second.md#two",
            "second.md#three",
            "first:9",
            "dead anchor: `second.html#three`",
        ),
        ("first", "second.md#two", "https://example.org", "first:9", "link out of the book"),
    ]);
}

#[test]
fn decimals_typed_by_hand_fail_unless_allowed() {
    expect(&[
        ("first", "It is", "It is 0.2916 or", "first:9", "`0.2916`"),
        ("first", "\\le C", "\\le 1.5", "first:6", "`1.5`"),
    ]);
    let fixture = Fixture::new();
    let first = "book/src/first.md";
    fixture.write(first, &fixture.read(first).replace("It is", "It is 0.2916 or"));
    fixture.write("book/allowed-decimals.txt", "0.2916 # for this test\n");
    fixture.build().unwrap();
}

#[test]
fn stale_values_and_figures_fail() {
    let fixture = Fixture::new();
    let layout = fixture.layout();
    let committed = shown(&layout, Data::read(&layout.generated()).unwrap()).unwrap();
    assert_eq!(committed.figures.keys().collect::<Vec<_>>(), ["ex/chart", "ex/other"]);
    check_fresh(&layout, &committed, &data(0.29156 * (1.0 + 1e-9))).unwrap();

    let message = check_fresh(&layout, &committed, &data(0.2917)).unwrap_err().to_string();
    assert!(
        message
            .starts_with("book/generated/values.json:9: stale: committed 0.29156, computed 0.2917"),
        "{message}"
    );

    let mut computed = data(0.29156);
    computed.figures.insert("ex/chart".to_owned(), CHART.replace("100", "150"));
    let message = check_fresh(&layout, &committed, &computed).unwrap_err().to_string();
    assert!(
        message.starts_with("book/generated/figures/ex/chart.svg:1: stale: drawn differently"),
        "{message}"
    );
}
