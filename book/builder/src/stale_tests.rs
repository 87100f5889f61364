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
