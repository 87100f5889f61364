//! Remark 7: the constants of Lemma 5.2 are valid wherever the zone lies.
//!
//! Let γ be the best constant in ‖u‖₀ ≤ γ |u|_ν for u in H^ν(0, 1), 0 < ν < 1, with mean zero on the zone (a, a + θ),
//! |u|²_ν = ∬ (u(x) − u(y))² / |x − y|^(1+2ν) dx dy. The remark: whatever a is, γ is at most a constant times that of
//! a = 0, which Lemma 5.2 bounds by θ^(ν−1/2), ln(1/θ), 1. Compared: γ is at most that of a = 0 itself.
//!
//! The paper cuts (0, 1) inside the zone into I₁ and I₂ and uses Lemma 5.2 on both, with a constant C(θ):
//!
//! ```text
//! ‖u‖₀² = ‖u‖₀² on I₁ + ‖u‖₀² on I₂ ≤ (C(θ) |I₁|^ν |u|_ν on I₁)² + (C(θ) |I₂|^ν |u|_ν on I₂)²,
//! ```
//!
//! as if the mean over each part of the zone were zero. A function that is odd about the middle of the zone has mean zero
//! there, whatever it is on one half. For u = sgn(x − 1/2), ν < 1/2, the left side is 1 and the right side 0; for odd ramps
//! in ln |x − 1/2|, ν = 1/2, the quotient grows without bound as their inner radius ε shrinks. So that step is false.
//!
//! It can be repaired without a cut: with m the mean of u over (0, 1), ‖u‖₀² = ‖u − m‖₀² + m² ≤ (γ₁² + N²) |u|²_ν, γ₁ the
//! constant for mean zero on (0, 1) and N the dual norm of u ↦ m − mean on the zone, of the order of Lemma 5.2 or less
//! for any zone. Refuted if γ exceeds that of a = 0, or √(γ₁² + N²), by more than the tolerance 1e-7.
//!
//! `cargo run --release --example remark_7_zone_location -- --nu 0.5 --theta 1e-2`

use example_report::prelude::*;
use fractional_sobolev::{Constraint, Function, Gram, Mesh, Zones, gamma};
use nalgebra::{DMatrix, DVector};

example! { quick "Remark 7", "mean zero on (a, a + θ):  ‖u‖₀ ≤ γ |u|_ν,  γ at most that of a = 0, for every a";
    /// orders ν of the seminorm
    nu: Vec<Order> = "0.25,1/2,0.75" in "(0, 1)" slider "0.02 to 0.98",
    /// length θ of the zone
    theta: f64 = "1e-3" in "[1e-12, 0.9]" slider "1e-6 to 0.5 by factors",
    /// places a/(1 − θ)
    at: Vec<f64> = "0,1e-4,1e-2,0.1,0.25,0.5" in "[0, 1]",
}

/// γ from its definition: √λ for the largest λ of M u = λ A u, u in the span of the hat functions φᵢ with mean zero on
/// (a, b), M = ∫ φᵢ φⱼ and A the form of |·|²_ν, in closed form. Elements are halved towards 0, both sides of a and b, 1.
fn by_definition(nu: Order, a: f64, b: f64) -> Result<f64> {
    let mut points = vec![0.0, a, b, 1.0];
    points.dedup();
    let mesh = Mesh::graded(&points, 10 + (a - b).abs().log2().abs() as usize, 0.5)?;
    let (h, x, n) = (mesh.lengths(), mesh.nodes(), mesh.len());
    let mut mass = DMatrix::<f64>::zeros(n + 1, n + 1);
    let mut mean = DVector::<f64>::zeros(n + 1); // ∫ φᵢ over (a, b)
    for k in 0..n {
        let element = DMatrix::from_row_slice(2, 2, &[2.0, 1.0, 1.0, 2.0]) * (h[k] / 6.0);
        let mut block = mass.view_mut((k, k), (2, 2));
        block += element;
        if (a..b).contains(&(0.5 * (x[k] + x[k + 1]))) {
            mean[k] += h[k] / 2.0;
            mean[k + 1] += h[k] / 2.0;
        }
    }
    let pivot = mean.imax();
    let mut free = DMatrix::identity(n + 1, n + 1); // columns φᵢ − (meanᵢ / mean_pivot) φ_pivot: a basis of mean zero
    free.set_row(pivot, &(-mean.transpose() / mean[pivot]));
    let free = free.remove_column(pivot);
    let form = free.transpose() * Gram::new(&mesh, nu, 1e-10)?.to_dense()? * &free;
    Ok(largest_eigenvalue(&(free.transpose() * mass * &free), &form)?.sqrt())
}

/// ‖w‖₀ / |w|_(1/2) of w = 1 − min(|ln x|, L)/L, quadratic on elements of equal length in ln x: odd about 1/2 and scaled,
/// the quotient of both sides of the cut at ν = 1/2.
pub fn ramp(log: f64) -> Result<Measured> {
    let layers = (log / 0.35).ceil();
    let mut nodes = vec![0.0];
    nodes.extend((0..=layers as usize).map(|k| (-log * (1.0 - k as f64 / layers)).exp()));
    let value = |x: f64| if x <= 0.0 { 0.0 } else { 1.0 - (-x.ln()).clamp(0.0, log) / log };
    let w = Function::interpolate(&Mesh::from_nodes(&nodes)?, 2, value)?;
    Ok(Measured::from(w.norm(0.0, 1e-12)?) / w.seminorm(Order::HALF, 1e-8)?)
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    let theta = options.theta;
    out.column("at", "a/(1−θ)", "");
    out.column("definition", "hats", "γ by `by_definition`");
    out.column("over_end", "γ/end", "over γ of (0, θ)");
    out.column("repair", "repair", "√(γ₁² + N²)");
    let place = |&at: &f64| Zones::from_start_and_length(at * (1.0 - theta), theta).map(|zone| (at, zone));
    let places = options.at.iter().map(place).collect::<fractional_sobolev::Result<Vec<_>>>()?;
    for &nu in &options.nu {
        // γ² is the largest eigenvalue of (‖·‖₀², |·|²_ν) on polynomials with mean zero on the zone, on elements that
        // shrink geometrically to the ends of zone and interval; its error is the change to a space of another shape.
        let end = Measured::from(gamma(nu, Constraint::mean_zero_on(0.0..theta), 1e-8)?.constant);
        for (at, zone) in &places {
            let (at, a) = (*at, at * (1.0 - theta));
            let found = gamma(nu, Constraint::mean_zero_on(zone), 1e-8)?;
            let bounds = found.bounds()?; // γ₁ by the same eigenproblem, N by one linear solve
            let repair = Measured::from(bounds.whole).squared() + Measured::from(bounds.dual_norm).squared();
            let (gamma, repair) = (Measured::from(found.constant), repair.sqrt());
            let (over_end, definition) =
                (gamma / end, by_definition(nu, a, if at < 1.0 { a + theta } else { 1.0 })?);
            out.row(cells! { nu, at => gamma, definition, over_end: over_end.value, repair: repair.value });
            if at > 0.0 {
                out.check("γ inside over γ of (0, θ)").at_most(over_end, 1.0 + 1e-7, "the end is worst");
            }
            out.check("γ over √(γ₁² + N²)").at_most(gamma / repair, 1.0 + 1e-7, "no cut");
            out.check("γ by its definition, over γ").near(
                gamma.recip() * definition,
                1.0,
                5e-3,
                "hat functions",
            );
        }
        // u odd about 1/2, zero within θ/1000 of it and extremal for that: both sides of the cut on one half.
        let needed =
            Measured::from(gamma(nu, Constraint::vanishing_on(0.0..2e-3 * theta), 1e-8)?.constant) / end;
        out.observe("cut with C(θ) = γ of (0, θ): left/right").at_least(needed, 1.0, "an odd function");
    }
    if options.nu.iter().any(|nu| nu.offset() < 0.0) {
        let sign = Function::piecewise(&Mesh::uniform(2, 1.0)?, 0, &[-1.0, 1.0])?;
        let mut right = 0.0;
        for piece in [sign.restrict(0..1)?, sign.restrict(1..2)?] {
            right += piece.seminorm(Order::new(0.25)?, 1e-8)?.value; // of a constant
        }
        let left = sign.norm(0.0, 1e-8)?.value;
        out.as_printed("cut, sgn(x − 1/2): right/left").at_least(right / left, 1e-12, "without the cut");
    }
    if options.nu.contains(&Order::HALF) {
        let (long, short) = (17.728, 36.148); // ln(1/ε): inner radius ε = 2e-8 and 2e-16 of the half interval
        let power = (ramp(short)? / ramp(long)?).ln() / (short / long).ln();
        out.as_printed("cut, odd ramps: power of ln 1/ε").at_most(power, 0.0, "without the cut");
    }
    out.plot(
        "remark_7_zone_location",
        "Where the zone lies",
        Axes::Linear("a/(1 − θ), place of the zone (a, a + θ)", "constant over that at the end"),
    )
    .curve_by("nu", "at", "over_end");
    Ok(())
}
