use super::*;
use crate::data::parse_object;
use std::path::Path;

fn data(text: &str, svg: &str) -> Data {
    Data {
        examples: parse_object(Path::new("test"), text).unwrap(),
        figures: [("ex/f".to_owned(), svg.to_owned())].into(),
        ..Data::default()
    }
}

const OLD: &str = r#"{"ex": {"measured": "slope 0.151967 in 3 s", "values": {"gamma": 0.29155661, "kkt": 3e-16, "run.seconds": 1.5},
    "columns": [{"key": "n"}, {"key": "seconds"}], "rows": [["8", "0.1"]]}}"#;

#[test]
fn last_digits_rounding_errors_and_times_do_not_count() {
    let new = r#"{"ex": {"measured": "slope 0.151968 in 17 s", "values": {"gamma": 0.29155662, "kkt": 5e-15, "run.seconds": 9.5},
        "columns": [{"key": "n"}, {"key": "seconds"}], "rows": [["8", "0.4"]]}}"#;
    let old = data(OLD, r#"<path d="M1234 -5678"/>"#);
    assert_eq!(compare(&old, &data(new, r#"<path d="M1235 -5679"/>"#)), []);
}

#[test]
fn what_differs_is_named() {
    let cases = [
        ("0.29155661", "0.2916", "ex/values/gamma"),
        ("slope 0.151967", "slope 0.152967", "ex/measured"),
        ("in 3 s", "in 3 steps", "ex/measured"),
        ("slope 0", "order 0", "ex/measured"),
        (r#"["8", "0.1"]"#, r#"["9", "0.1"]"#, "ex/rows/0/0"),
        (r#"[["8", "0.1"]]"#, "[]", "ex/rows"),
        (r#""kkt": 3e-16"#, r#""other": 3e-16"#, "ex/values"),
        (r#""ex":"#, r#""other":"#, "other"),
    ];
    let old = data(OLD, "<svg/>");
    for (from, to, entry) in cases {
        let new = data(&OLD.replace(from, to), "<svg/>");
        let found = compare(&old, &new);
        assert!(found.iter().any(|s| s.entry == entry), "{from} -> {to}: {found:?}");
    }
}

#[test]
fn a_finding_about_seconds_may_turn_on_a_busy_machine_and_no_other() {
    let finding = |name: &str, outcome: &str, value: f64| {
        let text = format!(
            r#"{{"ex": {{"findings": [{{"finding": "{name}", "outcome": "{outcome}", "role": "remark", "bound": 1, "value": {value}}}]}}}}"#
        );
        data(&text, "<svg/>")
    };
    let pair = |name: &str| compare(&finding(name, "holds", 4.6), &finding(name, "undecided", 1.2));
    assert_eq!(pair("seconds.multigrid"), []);
    let found = pair("multigrid");
    assert_eq!(found.len(), 2, "{found:?}");
    assert!(found.iter().any(|s| s.entry == "ex/findings/0/outcome"), "{found:?}");
}

/// An example whose name speaks of seconds is compared like any other.
#[test]
fn the_name_of_an_example_hides_nothing() {
    let old = OLD.replace(r#""ex":"#, r#""error_against_seconds":"#);
    let new = old.replace("0.29155661", "0.2916");
    let found = compare(&data(&old, "<svg/>"), &data(&new, "<svg/>"));
    let entries: Vec<&str> = found.iter().map(|stale| stale.entry.as_str()).collect();
    assert_eq!(entries, ["error_against_seconds/values/gamma"]);
}

/// What the check leaves out of the committed numbers: a column or finding whose name has one of these words by chance is
/// not compared either, and would be seen here.
#[test]
fn what_is_not_compared_is_a_time_or_a_count_of_steps() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../generated/values.json");
    let examples = parse_object(&file, &std::fs::read_to_string(&file).unwrap()).unwrap();
    let names = |list: &str, key: &str| -> BTreeSet<String> {
        let entries =
            examples.values().flat_map(|example| example[list].as_array().into_iter().flatten());
        entries
            .filter_map(|entry| entry[key].as_str())
            .filter(|name| is_timed(name))
            .map(str::to_owned)
            .collect()
    };
    let columns = ["ms", "ms_11", "ms_3", "ms_7", "seconds", "steps"].map(str::to_owned);
    assert_eq!(names("columns", "key"), columns.into());
    let findings =
        ["cg-iterations-increase-from-n-4-to-n-largest-n", "max-inner-cg-iterations-per-step"]
            .map(str::to_owned);
    assert_eq!(names("findings", "finding"), findings.into());
}

/// Another name of a check, source of a bound, range of a corrected form or status is stale; digits are not.
#[test]
fn words_of_findings_are_compared() {
    const FINDING: &str = r#"{"ex": {"verdict": "false as printed", "findings": [
        {"finding": "limit", "outcome": "fails", "role": "printed", "relation": "at most", "value": 0.29156402,
         "bound": 0, "words": "(5.2): limit γ₁ (as θ → 1) (0.29156 > 0)", "comparison": "0.29156 > 0, for θ ≤ 1/2"}]}}"#;
    let old = data(FINDING, "<svg/>");
    let differences = |from: &str, to: &str| {
        assert!(FINDING.contains(from), "{from}");
        compare(&old, &data(&FINDING.replace(from, to), "<svg/>"))
    };
    for (from, to, entry) in [
        ("for θ ≤ 1/2", "for θ ≤ 1/3", "ex/findings/0/comparison"),
        ("for θ ≤ 1/2", "limit of C ln(1/θ)", "ex/findings/0/comparison"),
        (", for θ ≤ 1/2", "", "ex/findings/0/comparison"),
        ("(as θ → 1)", "(as θ → 0)", "ex/findings/0/words"),
        ("limit γ₁", "limit γ", "ex/findings/0/words"),
        ("at most", "at least", "ex/findings/0/relation"),
        ("false as printed", "not sharp", "ex/verdict"),
    ] {
        let found = differences(from, to);
        assert!(found.len() == 1 && found[0].entry == entry, "{from} -> {to}: {found:?}");
        let renewed = data(&FINDING.replace(from, to), "<svg/>");
        assert_eq!(kept(&old, renewed.clone()), renewed, "{from} -> {to}");
    }
    assert_eq!(differences("0.29156 > 0", "0.29157 > 0"), []);
    let entry = old.examples["ex"]["findings"][0].as_object().unwrap();
    let named = Named { claim: "(5.2): limit γ₁ (as θ → 1)", source: "for θ ≤ 1/2" };
    assert_eq!(Named::of(entry), named);
    // Brackets that are no numbers belong to the name.
    let text = r#"{"words": "gamma (of ν)", "comparison": "0.5 ≤ 1, Lemma 5.2, (5.1)"}"#;
    let entry = crate::data::parse_object(Path::new("test"), text).unwrap();
    assert_eq!(Named::of(&entry), Named { claim: "gamma (of ν)", source: "Lemma 5.2, (5.1)" });
}
