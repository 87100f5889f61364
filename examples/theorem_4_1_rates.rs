//! Theorem 4.1: the rate of convergence of the midpoint cone.
//!
//! The discrete problem (4.1) asks for means ≤ 0 over the segments of the contact edge in place of values ≤ 0 at its
//! nodes, so that u^h may penetrate. In the energy norm
//!
//! ```text
//! ‖u − u^h‖ ≤ C h^(τ² − 5τ/2 + 2)   for 3/2 < τ < 2   (4.2),        C h   for τ > 2   (4.4).
//! ```
//!
//! Test problem, formula from the definition, loop and comparisons are those of Theorem 3.1, with the other cone: they
//! stand in `theorem_3_1_rates.rs`, which this file loads and calls. `below` holds the means of this cone.
//!
//! Refuted as Theorem 3.1: if the error over its printed bound keeps growing, or by `by_definition`.

use example_report::prelude::*;
use nalgebra::DMatrix;
use signorini::cone::Cone;

#[path = "theorem_3_1_rates.rs"]
#[allow(dead_code, reason = "only `rates` is used here")]
mod nodal;

example! { seconds "Theorem 4.1", "midpoint cone:  ‖u − u^h‖ ≤ C h^(τ² − 5τ/2 + 2), 3/2 < τ < 2,  C h, τ > 2";
    /// regularities τ of the solution
    tau: Vec<f64> = "1.55,1.65,1.75,1.85,1.95,2.25" in "(1.5, 2.5]" slider "1.55 to 1.95",
    /// meshes of 8, 16, .. 2^finest cells along the edge
    finest: u32 = "12" in "[9, 17]" slider "9 to 13",
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    // The means over 32 segments of what is linear on each.
    let means = DMatrix::from_fn(32, 33, |t, node| if node == t || node == t + 1 { 0.5 } else { 0.0 });
    let Options { tau, finest } = options.clone();
    nodal::rates("theorem_4_1", Cone::Midpoint, &means, &nodal::Options { tau, finest }, out)
}
