//! The tour: every claim of it is confirmed, its report fits a terminal, and the README shows what it prints.

#[path = "../examples/tour.rs"]
#[allow(dead_code, reason = "only `outcome` is used here")]
mod tour;

use example_report::Verdict;

/// The words of a line without its spaces and without the distances of two solvers, such as `(1e-14)`, which are
/// rounding errors.
fn words(line: &str) -> Vec<&str> {
    let is_rounding = |word: &&str| word.starts_with('(') && word.contains("e-") && word.ends_with(')');
    line.split_whitespace().filter(|word| !is_rounding(word)).collect()
}

#[test]
fn the_tour_confirms_every_line() {
    let found = tour::outcome(&tour::Options::default()).unwrap();
    let printed = found.text(false);
    assert_eq!(found.status(), Verdict::True, "{printed}");
    assert!(printed.lines().count() <= 30, "{printed}");
    let readme = include_str!("../README.md");
    let shown =
        readme.split("<!-- tour -->").nth(1).and_then(|rest| rest.split("<!-- end of tour -->").next());
    let shown: Vec<&str> =
        shown.unwrap().lines().filter(|line| !line.starts_with("```") && !line.is_empty()).collect();
    let start = printed.lines().position(|line| words(line) == words(shown[0])).unwrap();
    let printed: Vec<&str> = printed.lines().skip(start).take_while(|line| !line.trim().is_empty()).collect();
    assert_eq!(shown.len(), printed.len());
    for (shown, printed) in shown.iter().zip(printed) {
        assert_eq!(words(shown), words(printed));
    }
}
