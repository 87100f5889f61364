//! Section 2 on a strip: the reduction to the contact edge against values computed by direct two-dimensional
//! solves.

use serde_json::Value;
use signorini::cone::Cone;
use signorini::fem::Lame;
use signorini::strip::{EdgeLoad, EdgeSolution, ElasticStrip, ScalarStrip, solve_contact};
use std::f64::consts::PI;

/// The reference holds 14 digits; both roads round at a few units of 1e-16 times the condition of small
/// problems.
const REFERENCE: f64 = 1e-12;
/// KKT figures are backward errors: rounding times the logarithm of the transform lengths.
const KKT: f64 = 1e-12;

fn cases(problem: &str) -> Vec<Value> {
    let text = include_str!("reference/strip_reference.json");
    let all: Value = serde_json::from_str(text).unwrap();
    let cases = all["cases"].as_array().unwrap();
    cases.iter().filter(|case| case["problem"].as_str().unwrap().starts_with(problem)).cloned().collect()
}

fn compare(case: &Value, solution: &EdgeSolution) {
    let name = format!("{} n={} {}", case["load"], case["n"], case["cone"]);
    let number = |key: &str| case[key].as_f64().unwrap();
    let close = |what: &str, got: f64, expected: f64, scale: f64| {
        let error = (got - expected).abs() / scale;
        assert!(error < REFERENCE, "{name} {what}: {got} against {expected}, {error:e}");
    };
    close("J", solution.energy, number("J"), number("J").abs());
    let active: Vec<usize> =
        case["active"].as_array().unwrap().iter().map(|v| v.as_u64().unwrap() as usize).collect();
    assert_eq!(solution.contact.indices(), active, "{name}");
    let total: f64 = solution.multiplier.iter().sum();
    close("force", total, number("sum_multipliers"), number("sum_multipliers"));
    let largest = solution.multiplier.iter().fold(0.0f64, |m, &v| m.max(v));
    close("largest force", largest, number("max_multiplier"), number("max_multiplier"));
    let edge: Vec<f64> = case["u_N_edge"].as_array().unwrap().iter().map(|v| v.as_f64().unwrap()).collect();
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
        let strip = ScalarStrip::new(n, n).unwrap();
        let load = strip.condense(|x, _| (2.0 * PI * x).cos() + 0.3).unwrap();
        let solution = solve_contact(strip.operator(), &load, cone(&case), None).unwrap();
        compare(&case, &solution);
    }
}

/// The three loads of the elastic reference.
fn elastic_load(strip: &ElasticStrip, name: &str) -> EdgeLoad {
    let n = strip.operator().cells();
    if name.starts_with("edge force") {
        let force = |i: usize| ((2.0 * PI * i as f64 / n as f64).cos() + 0.3) / n as f64;
        return EdgeLoad::on_edge((0..n).map(force).collect());
    }
    let swirl = if name.contains("0.3 sin") { 1.0 } else { 0.0 };
    let load = strip
        .condense(|x, _| {
            let sideways = swirl * 0.3 * (2.0 * PI * x).sin();
            [sideways, swirl * 0.1 * (4.0 * PI * x).sin() - (2.0 * PI * x).cos()]
        })
        .unwrap();
    load.normal
}

#[test]
fn elastic_strip_meets_the_reference() {
    let cases = cases("elastic strip");
    assert_eq!(cases.len(), 10);
    for case in cases {
        let n = case["n"].as_u64().unwrap() as usize;
        let strip = ElasticStrip::new(n, n, Lame::new(1.0, 1.0).unwrap()).unwrap();
        let load = elastic_load(&strip, case["load"].as_str().unwrap());
        let solution = solve_contact(strip.operator(), &load, cone(&case), None).unwrap();
        compare(&case, &solution);
    }
}
