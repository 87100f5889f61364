//! Section 1, errors: the interpolation error of x^α in the norm (1.1), on equal and graded
//! elements.
//!
//! The proofs of the paper use ‖u − I^h u‖₁ ≤ C h^(τ−1) ‖u‖_τ for 1 < τ ≤ 2, and Lemma 6.2 on the
//! edge: interpolation of functions whose smoothness is a fraction. This file computes such an
//! error in the seminorm (1.1), for a function whose exponent is its smoothness. Let u = x^α on (0,
//! 1), α > ν − 1/2, α ≠ 1, and I_h u its linear interpolant at the nodes (i/N)^β, β ≥ 1. Then
//!
//! ```text
//! |u − I_h u|_ν ≈ C N^(−p),      p = min(β (α − ν + 1/2), 2 − ν),
//! ```
//!
//! where the first number comes from the first element and the second from all others. Where the
//! others decide, u − I_h u is near every point a chain of parabolas h² u''/2 · t(1 − t), and the
//! Fourier series of t(1 − t) gives C in closed form (`limit`). Where both numbers agree, a
//! logarithm comes in, and nothing is checked.
//!
//! Refuted if an order between the last two N is off p by more than 0.02, or C by more than 0.5 %
//! where `limit` gives it.
//! Undecided while a bound lies inside of an error bar.
//!
//! ```text
//! cargo run --release --example section_1_field_errors -- \
//!     --alpha 0.6 --elements 1000,10000,100000
//! ```

use example_report::prelude::*;
use fractional_sobolev::{Function, Mesh};
use std::f64::consts::PI;

example! { seconds "Section 1, errors",
    "|u − I_h u|_ν ≈ C N^(−p), p = min(β (α − ν + 1/2), 2 − ν), for u = x^α and nodes (i/N)^β";
    /// exponent α of u = x^α, above ν − 1/2 and not 1
    alpha: f64 = "0.75" in "(0, 10]" slider "0.3 to 2.5",
    /// order ν of the norm
    nu: Order = "1/2" in "(0, 1)" slider "0.1 to 0.9",
    /// gradings β of the nodes (i/N)^β
    beta: Vec<f64> = "1,1.5,2,2.67,4" in "[1, 20]" slider "1 to 6",
    /// numbers N of elements, increasing
    elements: Vec<usize> = "100,1000,10000" in "[1, 1000000]",
}

/// A grading nearer than this share to β (α − ν + 1/2) = 2 − ν shows a logarithm.
const NEAR: f64 = 0.2;

/// lim N^(2−ν) |u − I_h u|_ν where the first element does not decide. A chain of parabolas t(1 − t)
/// has, per element of length 1,
///
/// ```text
/// |·|²_ν = π (2π)^(2ν) ζ(4 − 2ν) / (Γ(1 + 2ν) sin πν π⁴);
/// ```
///
/// an element of length h = β x^(1−1/β)/N has (h² u''/2)² h^(1−2ν) times that, and the sum over the
/// elements is an integral, ∫ (u''/2)² h^(4−2ν) dx.
pub fn limit(alpha: f64, nu: f64, beta: f64) -> f64 {
    let zeta: f64 = (1..100_000).rev().map(|k| f64::from(k).powf(2.0 * nu - 4.0)).sum();
    let chain = PI * (2.0 * PI).powf(2.0 * nu) * zeta
        / (libm::tgamma(1.0 + 2.0 * nu) * (PI * nu).sin() * PI.powi(4));
    let weight = beta.powf(4.0 - 2.0 * nu) / (2.0 * (alpha - nu + 0.5) - 2.0 * (2.0 - nu) / beta);
    (chain * weight).sqrt() * (0.5 * alpha * (alpha - 1.0)).abs()
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    let (alpha, nu) = (options.alpha, options.nu.value());
    let (first, smooth) = (alpha - nu + 0.5, 2.0 - nu);
    if first <= 0.0 || alpha == 1.0 {
        return Err(Error::option("alpha", "must be greater than nu − 1/2 and different from 1"));
    }
    let u = Function::from_positions(&[0.0, 1.0], |at| at.distance_to(0).powf(alpha))?;
    for &beta in &options.beta {
        let p = smooth.min(beta * first);
        let others_decide = beta * first > smooth * (1.0 + NEAR);
        let first_decides = beta * first < smooth * (1.0 - NEAR);
        let mut over_limit = None;
        for &elements in &options.elements {
            let mesh = Mesh::algebraic(elements, beta, 1.0)?;
            let at_nodes: Vec<f64> = mesh.from_left().iter().map(|x| x.powf(alpha)).collect();
            let interpolant = Function::linears(&mesh, &at_nodes)?;
            // The double integral over all pairs of elements: touching pairs by Duffy's
            // coordinates, the first element graded towards 0, far pairs by clusters, Gauss rules
            // throughout; ±: the change of rules, relatively 1e-6 at most.
            let error = u.minus(&interpolant)?.seminorm(options.nu, 1e-6)?;
            if others_decide {
                let scaled = Measured::from(error) * (elements as f64).powf(smooth);
                over_limit = Some(scaled / limit(alpha, nu, beta));
            }
            out.row(cells! { beta, n: elements => error, p, over_limit });
        }
        if others_decide || first_decides {
            let order = -out.exponent("n", "error"); // of the last two N
            let claim = out.check("observed order − p, last two N");
            claim.whole_error_bars_differ_by_at_most(order - p, 0.0, 0.02, "formula for p");
        }
        if let Some(last) = over_limit {
            let claim = out.check("N^(2−ν) |u − I_h u|_ν/limit");
            claim.whole_error_bars_differ_by_at_most(last, 1.0, 5e-3, "closed form, N → ∞");
        }
    }
    out.column("n", "N", "");
    out.column("error", "|u − I_h u|_ν", "");
    out.column("p", "p", "expected order");
    out.column("over_limit", "C/limit", "N^(2−ν) times the error over its closed limit");
    let axes = Axes::LogLog("elements N", "|u − I_h u|_ν");
    out.plot("section_1_field_errors", "Interpolation of x^α", axes).curve_by("beta", "n", "error");
    Ok(())
}
