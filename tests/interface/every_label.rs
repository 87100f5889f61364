//! The table of every label: no label of the paper without a row, no row whose finding is missing or
//! undecided, whose page or test does not exist.

use serde_json::Value;
use std::collections::BTreeSet;
use std::path::Path;

/// Numbered lines of each section: (1.1), (2.1) to (2.9), ...
const NUMBERED: [usize; 6] = [1, 9, 15, 14, 9, 2];
/// What else the paper labels.
const NAMED: &str = "(E1); (E2); (E3); (E4); (N1); (N2); Figure 2.1; Figure 3.1; Figure 3.2; Figure 4.1; Theorem 3.1; \
    Theorem 4.1; Remark 1; Remark 2; Remark 3; Remark 4; Remark 5; Remark 6; Remark 7; Lemma 5.1; Lemma 5.2; \
    Lemma 6.1, first line; Lemma 6.1, second line; Lemma 6.2, first line; Lemma 6.2, second line";

fn read(path: &str) -> String {
    std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(path)).unwrap_or_default()
}

/// The cells of each row above the cards.
fn rows(page: &str) -> Vec<Vec<String>> {
    let page = page.split("## Cards").next().unwrap_or(page);
    let lines = page.lines().filter(|line| line.starts_with("| ") && !line.starts_with("| label"));
    lines
        .filter(|line| !line.starts_with("| ---"))
        .map(|line| {
            line.trim_matches('|').split(" | ").map(|cell| cell.trim().to_owned()).collect()
        })
        .collect()
}

/// `(3.3) to (3.5)` as three labels, anything else as itself.
fn labels(cell: &str) -> Vec<String> {
    cell.split(", ")
        .flat_map(|part| match part.split_once(" to ") {
            Some((from, to)) => {
                let number = |text: &str| -> (usize, usize) {
                    let (s, n) = text.trim_matches(['(', ')']).split_once('.').unwrap();
                    (s.parse().unwrap(), n.parse().unwrap())
                };
                let ((section, first), (_, last)) = (number(from), number(to));
                (first..=last).map(|n| format!("({section}.{n})")).collect()
            }
            None => vec![part.to_owned()],
        })
        .chain([cell.to_owned()])
        .collect()
}

fn directives<'a>(cell: &'a str, name: &str) -> Vec<&'a str> {
    let start = format!("{{{{{name}: ");
    cell.split(&start).skip(1).filter_map(|rest| Some(rest.split_once("}}")?.0.trim())).collect()
}

/// What is wrong with a row.
fn faults(row: &[String], values: &Value) -> Vec<String> {
    let [label, _, page, decides, test] = row else {
        return vec![format!("{row:?}: not five cells")];
    };
    let mut faults = Vec::new();
    let file = page
        .split_once('(')
        .and_then(|(_, rest)| rest.split_once(')'))
        .map_or("", |(file, _)| file);
    if read(&format!("book/src/{}", file.split('#').next().unwrap_or(""))).is_empty() {
        faults.push(format!("{label}: no page {file}"));
    }
    let keys = directives(decides, "finding");
    if keys.is_empty() && !decides.contains("by proof") {
        faults.push(format!("{label}: nothing decides"));
    }
    for key in keys {
        let Some((example, finding)) = key.split_once('/') else {
            faults.push(format!("{label}: {key}"));
            continue;
        };
        let found = values[example]["findings"].as_array().and_then(|all| {
            all.iter()
                .find(|entry| entry["finding"].as_str() == Some(finding))
                .map(|entry| &entry["outcome"])
        });
        match found.and_then(Value::as_str) {
            Some("holds" | "fails" | "by proof") => {}
            other => faults.push(format!("{label}: {key} is {other:?}")),
        }
    }
    for name in directives(test, "test") {
        let (file, function) = name.split_once("::").unwrap_or((name, ""));
        let source =
            [read(&format!("tests/{file}.rs")), read(&format!("toolkit/tests/{file}.rs"))].concat();
        if !source.contains(&format!("fn {function}(")) {
            faults.push(format!("{label}: no test {name}"));
        }
    }
    if directives(test, "test").is_empty() {
        faults.push(format!("{label}: no test"));
    }
    faults
}

fn values() -> Value {
    serde_json::from_str(&read("book/generated/values.json")).unwrap()
}

#[test]
fn every_row_is_decided() {
    let (all, values) = (rows(&read("book/src/every_label.md")), values());
    assert!(all.len() >= 71, "{} rows", all.len());
    let found: Vec<String> = all.iter().flat_map(|row| faults(row, &values)).collect();
    assert!(found.is_empty(), "{found:#?}");
}

#[test]
fn every_label_of_the_paper_has_a_row() {
    let all = rows(&read("book/src/every_label.md"));
    let known: BTreeSet<String> = all.iter().flat_map(|row| labels(&row[0])).collect();
    let numbered = (0..6).flat_map(|s| (1..=NUMBERED[s]).map(move |n| format!("({}.{n})", s + 1)));
    let wanted = numbered.chain(NAMED.split("; ").map(str::to_owned));
    let missing: Vec<String> = wanted.filter(|label| !known.contains(label)).collect();
    assert!(missing.is_empty(), "{missing:?}");
    assert_eq!(all.iter().filter(|row| row[0] == "Globally").count(), 2);
}

#[test]
fn planted_faults_are_found() {
    let mut values = values();
    let page = read("book/src/every_label.md");
    let row = |text: &str| rows(text).pop().unwrap();
    let good = "| x | y | [lemma_5_2](lemma_5_2.md) | {{finding: remark_6_point_condition/all-nu-theta-1e-12-gamma-theta-gamma}} | {{test: appendix_a/remark_6::statement_is_confirmed}} |";
    assert!(faults(&row(good), &values).is_empty(), "{:?}", faults(&row(good), &values));
    for (from, to) in [
        ("lemma_5_2.md", "lemma_55_2.md"),
        (
            "{{finding: remark_6_point_condition/all-nu-theta-1e-12-gamma-theta-gamma}}",
            "see the page",
        ),
        ("gamma-theta-gamma}", "gamma-theta-gammas}"),
        ("::statement_is_confirmed", "::statement_is_denied"),
        ("{{test: appendix_a/remark_6::statement_is_confirmed}}", ""),
    ] {
        assert_eq!(faults(&row(&good.replace(from, to)), &values).len(), 1, "{from}");
    }
    let findings = values["remark_6_point_condition"]["findings"].as_array_mut().unwrap();
    findings.iter_mut().for_each(|finding| finding["outcome"] = "undecided".into());
    assert_eq!(faults(&row(good), &values).len(), 1);
    assert!(rows(&page).len() > 1 && labels("(3.3) to (3.9), (3.11) to (3.14)").len() == 12);
}
