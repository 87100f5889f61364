//! Lemma 5.2: the Poincaré constants against values computed independently, and the three laws.

use signorini::Tolerance;
use signorini::poincare::{Condition, Zone, gamma};
use signorini::sobolev::FractionalOrder;

struct Row {
    nu: FractionalOrder,
    zone: Zone,
    gamma: f64,
}

fn reference() -> Vec<Row> {
    let text = include_str!("reference/gamma_reference.json");
    let rows: serde_json::Value = serde_json::from_str(text).unwrap();
    let number = |row: &serde_json::Value, key: &str| -> f64 { row[key].as_str().unwrap().parse().unwrap() };
    rows.as_array()
        .unwrap()
        .iter()
        .map(|row| Row {
            nu: FractionalOrder::new(number(row, "nu_decimal")).unwrap(),
            zone: Zone::end(number(row, "theta_decimal")).unwrap(),
            gamma: number(row, "gamma"),
        })
        .collect()
}

#[test]
fn constants_agree_with_the_reference_and_keep_their_promise() {
    for tolerance in [1e-4, 1e-10].map(|t| Tolerance::new(t).unwrap()) {
        for row in reference() {
            let estimate = gamma(row.nu, row.zone, Condition::MeanZero, tolerance).unwrap();
            let error = (estimate.value - row.gamma).abs();
            assert!(
                error <= estimate.error && error <= tolerance.relative() * row.gamma,
                "nu {} zone {} tolerance {tolerance}: {estimate} against {}, off by {error:e}",
                row.nu,
                row.zone,
                row.gamma
            );
        }
    }
}
