//! What large runs of `book/large.toml` kept is what the library computes: their small sizes, anew.

#[path = "../examples/section_2_speed_for_accuracy.rs"]
#[allow(dead_code, reason = "only `compute` is used here")]
mod roads;

#[path = "../examples/theorem_3_1_rates.rs"]
#[allow(dead_code, reason = "only `outcome` is used here")]
mod rates;

use serde_json::Value;
use signorini::problems::{NamedProblem, TestProblem};

fn kept(run: &str) -> Value {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/book/generated/large/values.json");
    let all: Value = serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
    all[run].clone()
}

/// A column of a kept table, as printed.
fn column(run: &Value, key: &str) -> Vec<String> {
    let place = run["columns"].as_array().unwrap().iter().position(|column| column["key"] == key).unwrap();
    run["rows"].as_array().unwrap().iter().map(|row| row[place].as_str().unwrap().to_owned()).collect()
}

/// Half of the last of four printed digits.
const PRINTED: f64 = 6e-4;

#[test]
fn errors_by_every_road_are_those_that_were_kept() {
    let run = kept("section_2_speed_for_accuracy_fine");
    let [n, road, error] = ["n", "road", "error"].map(|key| column(&run, key));
    let computed = roads::compute(&roads::Options { levels: 4, ..Default::default() }).unwrap();
    assert!(computed.rows.len() > 15);
    for (k, row) in computed.rows.iter().enumerate() {
        assert_eq!((&n[k], &road[k]), (&row.n.to_string(), &row.road.to_string()));
        let kept: f64 = error[k].parse().unwrap();
        assert!((kept / row.error - 1.0).abs() < PRINTED, "{} {}: {kept:e} {:e}", row.n, row.road, row.error);
    }
}

/// An order from h ≥ 1/128 and the one that was kept are those of one corner.
#[test]
fn orders_of_corners_are_those_that_were_kept() {
    let kept = kept("theorem_3_1_rates_corners");
    let (tau, problem) = (vec![1.6, 1.75, 1.9], vec![NamedProblem::Mesh(TestProblem::Corner)]);
    let computed = rates::outcome(&rates::Options { tau, problem, finest: 13 }).unwrap();
    for tau in ["1.6", "1.75", "1.9"] {
        let key = format!("order.problemcorner.tau{tau}");
        let [kept, error] =
            [key.clone(), format!("{key}.error")].map(|key| kept["values"][key].as_f64().unwrap());
        let (found, wide) = (computed.value(&key).unwrap(), computed.value(&format!("{key}.error")).unwrap());
        assert!((found - kept).abs() < error + wide, "{tau}: {found} +- {wide}, kept {kept} +- {error}");
    }
}
