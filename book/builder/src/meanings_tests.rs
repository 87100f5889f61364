use super::*;
use crate::several::SEVERAL;

const TABLES: &str = "| $h$, $l(v)$ | length of an element | x |\n\n## Understood\n\n";

fn found(table: &str, text: &str) -> Vec<String> {
    let page = |html: &str, text: &str| Page { file: html.into(), html: html.into(), text: text.into() };
    let notation = format!("{TABLES}{SEVERAL}\n\n{table}");
    let pages = [page(NOTATION, &notation), page("p.html", text), page("q.html", "$h$")];
    faults(&pages)
        .into_iter()
        .map(|fault| format!("{}:{} {}", fault.file.display(), fault.line, fault.text))
        .collect()
}

#[test]
fn two_definitions_that_differ_are_refused() {
    assert_eq!(found("", "Let $c$ be a mean.\nLet $c$ be a load."), ["p.html:2 c: a mean / a load"]);
    assert_eq!(
        found("", "With $N = k^2$ and\n, where $N$ is the mean of it"),
        ["p.html:2 N: =k^2 / the mean of it"]
    );
    assert_eq!(found("", "A number $t$,\nand $t$ the time."), ["p.html:2 t: number / the time"]);
    assert_eq!(found("", "Let $m$ be the mean, $m$ the load."), ["p.html:1 m: the mean / the load"]);
}

#[test]
fn values_repetitions_and_other_symbols_are_no_second_meaning() {
    assert!(found("", "Let $c$ be a mean, with $c = \\frac14$, with $c = \\pi/2$.").is_empty());
    assert!(found("", "A number $c$; any number $c$; let $c_1$ be a load, $c(t)$ the time.").is_empty());
    assert!(
        found("", "For $c$ the mean, and of $c$ the load is known. With $q = 2k$; with $q = 2k$.").is_empty()
    );
}

#[test]
fn an_integral_over_a_letter_with_a_meaning_is_refused() {
    assert_eq!(found("", "For $0 < s < 1$.\n$$\\int f(s) \\dd s$$").len(), 1);
    assert_eq!(found("", "A number $t$.\n$$\\int t\\, dt$$").len(), 1);
    assert!(found("", "With $t = \\ln x$: $\\int t \\dd t$, $0 < x < 1$, $\\int \\dd x$").is_empty());
}

#[test]
fn eulers_number_is_upright() {
    assert_eq!(found("", "$e^{-t}$, $e^{kx}$, $2 e^t$").len(), 3);
    assert!(found("", "$\\mathrm e^{-t}$, $e^2$, $e^*$, $e^{3/2}$, $h_e^\\nu$, $\\abs{e}^2$").is_empty());
}

#[test]
fn another_meaning_stands_in_the_last_table() {
    let text = "Let $h$ be the height of a triangle.";
    assert_eq!(found("", text), ["p.html:1 h: the height of a triangle"]);
    assert!(found("| $h$ | a size | a height: [p](p.md) |", text).is_empty());
    assert!(found("", "Let $h$ be the length of the finest element.").is_empty());
    let twice = found("| $h$ | a size: [p](p.md) | a height: [p](p.md); a time: [q](q.md) |", text);
    assert_eq!(twice, ["notation.html:7 h on p.html"]);
    assert_eq!(found("| $w$ | a | a height: [p](p.md) |", "$h$"), ["notation.html:7 w on p.html"]);
}
