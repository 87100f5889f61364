//! What large runs of `book/large.toml` kept is what the library computes: their small sizes, anew.

#[path = "../examples/section_2_speed_for_accuracy.rs"]
#[allow(dead_code, reason = "only `compute` is used here")]
mod roads;

use experiments::convergence::MeshRates;
use serde_json::Value;
use signorini::cone::Cone;
use signorini::problems::{Parameters, TestProblem};

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
/// What contact adds to the orthogonality of Galerkin.
const ORTHOGONAL: f64 = 1e-2;

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

/// By orthogonality an error against the finer reference is that against the coarser one and what this one is
/// off, as squares.
#[test]
fn errors_of_the_block_are_those_that_were_kept() {
    for (run, cone) in [("theorem_3_1_rates_block", Cone::Nodal), ("theorem_4_1_rates_block", Cone::Midpoint)]
    {
        let run = kept(run);
        let [cells, error] = ["cells", "error"].map(|key| column(&run, key));
        let setting = Parameters::default();
        let rates =
            MeshRates { scene: TestProblem::Block, setting, constant_load: false, coarsest: 4, levels: 5 };
        let study = rates.study(&[cone]).unwrap().remove(0);
        let kept = |n: usize| -> f64 {
            let row = cells.iter().position(|cells| *cells == n.to_string()).unwrap();
            error[row].parse().unwrap()
        };
        for level in &study.levels {
            let expected = level.error.hypot(kept(128));
            let off = expected / kept(level.cells) - 1.0;
            assert!(off.abs() < ORTHOGONAL, "{cone}, {}: {off:e}", level.cells);
        }
    }
}
