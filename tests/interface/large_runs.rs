//! What large runs of `book/large.toml` kept is what the library computes: their small sizes, anew.

use crate::program::outcome;
use serde_json::Value;

fn kept(run: &str) -> Value {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/book/generated/large/values.json");
    let all: Value = serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
    all[run].clone()
}

/// An order from h ≥ 1/128 and the one that was kept are those of one corner.
#[test]
fn orders_of_corners_are_those_that_were_kept() {
    let kept = kept("theorem_3_1_rates_corners");
    let (_, computed) = outcome("theorem_3_1_bodies", &["--problem=corner", "--tau=1.6,1.75,1.9"]);
    for tau in ["1.6", "1.75", "1.9"] {
        let key = format!("order.problemcorner.tau{tau}");
        let [[kept, error], [found, wide]] = [&kept, &computed].map(|run| {
            [key.clone(), format!("{key}.error")].map(|key| run["values"][key].as_f64().unwrap())
        });
        assert!(
            (found - kept).abs() < error + wide,
            "{tau}: {found} ± {wide}, kept {kept} ± {error}"
        );
    }
}
