//! Error ≤ C h ‖f‖ for loads that are not the example's, and |u|₂ = ‖f‖.

#[allow(dead_code, reason = "one function of the example is used alone")]
#[path = "../../examples/bound_from_the_data.rs"]
mod example;

use signorini::mesh::{SideParts, unit_square};
use std::f64::consts::PI;

#[test]
fn the_bound_holds_and_the_seminorm_tends_to_that_of_the_load() {
    let found = example::outcome(&example::Options { meshes: 6 }).unwrap();
    assert_eq!(found.exit_code(), 0, "{}", found.text(false));
}

/// |sin πx sin πy|₂ = ‖Δ(sin πx sin πy)‖ = π²: a seminorm without its mixed part would be off by the factor √2.
#[test]
fn differences_give_the_seminorm_of_a_smooth_function() {
    let n = 64;
    let mesh = unit_square(n, SideParts::HANGING).unwrap();
    let u: Vec<f64> = mesh.nodes().iter().map(|[x, y]| (PI * x).sin() * (PI * y).sin()).collect();
    let found = example::second_seminorm(&mesh, &u, n);
    assert!((found / (PI * PI) - 1.0).abs() < 2e-3, "{found}");
}
