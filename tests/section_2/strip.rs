//! Section 2 on a strip: the reduction to the contact edge against values computed by direct two-dimensional
//! solves.

use serde_json::Value;
use signorini::cone::Cone;
use signorini::fem::Lame;
use signorini::strip::{EdgeSolution, Strip};
use std::f64::consts::PI;

/// The reference holds 14 digits; both computations round at a few units of 1e-16 times the condition of small
/// problems.
const REFERENCE: f64 = 1e-12;
/// KKT figures are backward errors: rounding times the logarithm of the transform lengths.
const KKT: f64 = 1e-12;
/// Relative residual asked of the contact iteration.
const SOLVED: f64 = 1e-13;

fn cases(problem: &str) -> Vec<Value> {
    let text = include_str!("../reference/strip_reference.json");
    let all: Value = serde_json::from_str(text).unwrap();
    let cases = all["cases"].as_array().unwrap();
    cases
        .iter()
        .filter(|case| case["problem"].as_str().unwrap().starts_with(problem))
        .cloned()
        .collect()
}

/// `constant` is c of J.
fn compare(case: &Value, solution: &EdgeSolution, constant: f64) {
    let name = format!("{} n={} {}", case["load"], case["n"], case["cone"]);
    let number = |key: &str| case[key].as_f64().unwrap();
    let close = |what: &str, got: f64, expected: f64, scale: f64| {
        let error = (got - expected).abs() / scale;
        assert!(error < REFERENCE, "{name} {what}: {got} against {expected}, {error:e}");
    };
    close("J", solution.energy + constant, number("J"), number("J").abs());
    let active: Vec<usize> =
        case["active"].as_array().unwrap().iter().map(|v| v.as_u64().unwrap() as usize).collect();
    assert_eq!(solution.contact.indices(), active, "{name}");
    let total: f64 = solution.multiplier.iter().sum();
    close("force", total, number("sum_multipliers"), number("sum_multipliers"));
    let largest = solution.multiplier.iter().fold(0.0f64, |m, &v| m.max(v));
    close("largest force", largest, number("max_multiplier"), number("max_multiplier"));
    let edge: Vec<f64> =
        case["u_N_edge"].as_array().unwrap().iter().map(|v| v.as_f64().unwrap()).collect();
    let scale = edge.iter().fold(0.0f64, |m, v| m.max(v.abs()));
    for (got, expected) in solution.values.iter().zip(&edge) {
        close("u_N", *got, *expected, scale);
    }
    assert!(solution.status.is_converged(), "{name}: {}", solution.status);
    assert!(solution.kkt.worst() < KKT, "{name}: {:?}", solution.kkt);
}

fn cone(case: &Value) -> Cone {
    case["cone"].as_str().unwrap().parse().unwrap()
}

#[test]
fn scalar_strip_meets_the_reference() {
    let cases = cases("scalar strip");
    assert_eq!(cases.len(), 4);
    for case in cases {
        let n = case["n"].as_u64().unwrap() as usize;
        let strip = Strip::scalar(n, n).unwrap();
        let (force, constant) = strip.condense(|x, _| [(2.0 * PI * x).cos() + 0.3, 0.0]).unwrap();
        let solution = strip.operator().solve_contact(&force, cone(&case), None, SOLVED).unwrap();
        compare(&case, &solution, constant);
    }
}

/// The three loads of the elastic reference.
fn elastic_load(strip: &Strip, name: &str) -> (Vec<f64>, f64) {
    let n = strip.operator().cells();
    if name.starts_with("edge force") {
        let force = |i: usize| ((2.0 * PI * i as f64 / n as f64).cos() + 0.3) / n as f64;
        return ((0..n).map(force).collect(), 0.0);
    }
    let swirl = if name.contains("0.3 sin") { 1.0 } else { 0.0 };
    strip
        .condense(|x, _| {
            let sideways = swirl * 0.3 * (2.0 * PI * x).sin();
            [sideways, swirl * 0.1 * (4.0 * PI * x).sin() - (2.0 * PI * x).cos()]
        })
        .unwrap()
}

#[test]
fn elastic_strip_meets_the_reference() {
    let cases = cases("elastic strip");
    assert_eq!(cases.len(), 10);
    for case in cases {
        let n = case["n"].as_u64().unwrap() as usize;
        let strip = Strip::elastic(n, n, Lame::new(1.0, 1.0).unwrap()).unwrap();
        let (force, constant) = elastic_load(&strip, case["load"].as_str().unwrap());
        let solution = strip.operator().solve_contact(&force, cone(&case), None, SOLVED).unwrap();
        compare(&case, &solution, constant);
    }
}
