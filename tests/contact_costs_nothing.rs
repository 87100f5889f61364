//! Contact costs nothing in the limit: errors beside those of interpolation and of the best approximation.

#[allow(dead_code)]
#[path = "../examples/contact_costs_nothing.rs"]
mod example;

use example_frame::Outcome;
use experiments::convergence::{Levels, StripCase};
use experiments::proof::{contact_cost, falk_terms};
use signorini::cone::Cone;
use signorini::strip::{Reference, StripKind};

fn options() -> example::Options {
    example::Options { levels: Levels::new(4, 10).unwrap(), finest: 5, ..example::Options::default() }
}

#[test]
fn the_limit_is_that_of_interpolation() {
    // Fewer levels leave bars too wide to decide.
    let headline =
        example::run(&example::Options { levels: Levels::new(4, 13).unwrap(), ..options() }).unwrap();
    assert!(headline.verdict().is_confirmed(), "{headline}");
}

#[test]
fn an_error_that_does_not_fall_is_seen() {
    let mut computed = example::compute(&options()).unwrap();
    for case in computed.0.iter_mut().filter(|case| case.tau > 2.0) {
        case.rows.iter_mut().for_each(|row| row.error += 0.1 * row.interpolation);
    }
    let found = example::findings(&computed);
    let outcome = |key: &str| found.iter().find(|finding| finding.key() == key).unwrap().outcome();
    assert_eq!(outcome("natural"), Outcome::Refuted);
    assert_eq!(outcome("mesh"), Outcome::Holds);
}

#[test]
fn a_term_that_falls_slower_is_seen() {
    let mut computed = example::compute(&options()).unwrap();
    for row in computed.0.iter_mut().flat_map(|case| &mut case.rows) {
        row.consistency *= (row.n as f64).powf(0.3);
    }
    let found = example::findings(&computed);
    assert_eq!(found.iter().find(|f| f.key() == "order").unwrap().outcome(), Outcome::Refuted);
}

#[test]
fn rows_are_the_terms_of_falks_lemma() {
    for kind in [StripKind::Scalar, StripKind::Elastic] {
        let case = StripCase {
            kind,
            levels: Levels::new(3, 6).unwrap(),
            source: "transitions:3".parse().unwrap(),
            tau: 1.8,
            cone: Cone::Nodal,
            reference: Reference::Nested,
            positions: 1,
        };
        let (cost, falk) = (contact_cost(&case, || ()).unwrap(), falk_terms(&case, |_| ()).unwrap());
        for (cost, falk) in cost.iter().zip(&falk) {
            for (own, other) in [
                (cost.error, falk.terms.error),
                (cost.interpolation, falk.terms.approximation),
                (cost.consistency, falk.terms.consistency),
            ] {
                assert!((own / other - 1.0).abs() < 1e-9, "{kind} {}: {own} {other}", cost.n);
            }
            assert!(cost.best <= cost.interpolation && cost.best <= cost.error, "{kind} {}", cost.n);
        }
    }
}
