//! The rate of the computed bound: of optimal order h^(τ − 1), whatever the contact set.
//!
//! −Δu = 0 on the unit square, u = 0 on top, no flux through the sides; on the bottom Γ_C the flux
//! ∂u/∂n = G + σ, with a given load G and u ≤ 0, σ ≤ 0, uσ = 0. With J(v) = ½ ‖∇v‖² − ∫ G v the
//! solution minimises J over v ≤ 0 on Γ_C. A field q, div q = 0, q·n = 0 on the sides, q·n = G − p
//! on Γ_C with p ≥ 0, has J*(q) = −½ ‖q‖² ≤ J(u), and (example `two_sided_energies`)
//!
//! ```text
//! ‖∇(u − v)‖² ≤ 2 (J(v) − J*(q)).
//! ```
//!
//! v = u^h is linear on n × n squares, h = 1/n, each cut in two. q = ∇w + (ψ_y, −ψ_x): w discrete
//! harmonic on N × N squares, N = 32·2^finest, with ∂w/∂n = G on Γ_C, ψ linear on the same
//! triangles, constant on each side and with −ψ_x = p ≥ 0 constant on each segment of Γ_C. As ∫
//! ∇w·(ψ_y, −ψ_x) = −∫ w p,
//!
//! ```text
//! J*(q) = −½ ∫ G w + ∫ w p − ½ F(p),     F(p) = least ‖∇ψ‖² for this p:  p ≥ 0 of best J*.
//! ```
//!
//! F by waves: P = ∫ p, ψ + P x − ψ(0) = Σ s_k sin kπx at the nodes, and
//!
//! ```text
//! F(p) = P² + (n/2) Σ sinh η tanh nη s_k²,    cosh η = 2 − cos(kπ/n)    (nothing given on top).
//! ```
//!
//! Midpoint cone (means of u^h over segments ≤ 0): with the values M at the nodes of the averages
//! of the means on both sides (at an end the mean itself), w' = u^h − M on Γ_C, discrete harmonic,
//!
//! ```text
//! ‖∇(u − u^h)‖² ≤ 2 (J(u^h) − J*(q)) + ‖∇w'‖² + 2 ∫ p w'.
//! ```
//!
//! u is chosen on the N segments, with its σ, and u inside is discrete harmonic; both give G, whose
//! forces on n segments are those on N tested with the hat functions of n. The ends of a gap move
//! to the nearest of the N + 1 nodes; a and b are the moved ends, u = 0 outside of all gaps, and δ
//! = (x − a)(b − x)/(b − a) inside. A segment is in contact if u = 0 at both of its nodes, also if
//! it is a gap of one segment; half of the integral of −σ over it acts at each of the two:
//!
//! ```text
//! transition   u = −(x − a)^(τ−1) for x > a, −σ = r^(τ−2) for x < a, r the distance to the last
//!              node before a (a not moved); root of the mean square over eight
//!              a = 0.381966 + 0.0171 k
//! cantor       20 times the middle 2/5 of each piece becomes a gap: u = −δ^(τ−1+d/2), −σ = 1,
//!              d = ln 2/ln(10/3)
//! fat-cantor   for k = 1, .. 15 a gap L s^k in the middle of each piece, s = 2^(−1/d), d = 4 − 2τ,
//!              all (k → ∞) 1/2 long: u = −δ, −σ = 1
//! ```
//!
//! All twelve data sets have the regularity τ. The theorem (page `rate_of_the_bound`): then the
//! bound is at most C h^(τ−1), nodal cone, as its parts are errors of interpolation of u and ψ, of
//! order h^(τ−1), and ∫ p u, which only pairs of points of one segment bound.
//!
//! Orders by the first and the last mesh, n = 8 and 2^finest; ±: the difference between the orders
//! of the coarser and of the finer half. The squared error is a(u, u) − 2 a(u, u^h) + a(u^h, u^h),
//! a finite sum. Refuted if a bound is below the error, or if the order of the bound plus its ± is
//! below both τ − 1 and the order of the error less its own ±: on these meshes the error itself,
//! and any bound, may not yet have the order of the limit. No other number has a ±.

use example_report::prelude::*;
use nalgebra::{DMatrix, DVector};
use signorini::cone::Cone;
use signorini::problems::StripData;
use signorini::strip::{LateralCondition, Reference, StripKind, StripProblem};
use std::f64::consts::PI;

example! { seconds "The rate of the bound",
    "2 (J(u^h) − J*(q)) ≤ C h^(2τ − 2): the bound has the order τ − 1, or that of the error";
    /// meshes of 8, 16, .. 2^finest segments
    finest: u32 = "9" in "[6, 10]",
}

/// F as a matrix, on n segments.
fn compliance(n: usize) -> DMatrix<f64> {
    let h = 1.0 / n as f64;
    let angle = |k: usize| k as f64 * PI * h;
    let waves = DMatrix::from_fn(n - 1, n - 1, |i, k| (angle(k + 1) * (i + 1) as f64).sin());
    let energies = DVector::from_fn(n - 1, |k, _| {
        let eta = (2.0 - angle(k + 1).cos()).acosh();
        2.0 * h * eta.sinh() * (n as f64 * eta).tanh()
    });
    // ψ + P x at the inner nodes from p: −h Σ_{j ≤ i} p_j + x_i h Σ p_j. s = (2/n) sines of it.
    let primitive = DMatrix::from_fn(n - 1, n, |i, j| {
        h * ((i + 1) as f64 * h - if j <= i { 1.0 } else { 0.0 })
    });
    let sines = waves.transpose() * primitive;
    let scaled = DMatrix::from_fn(n - 1, n, |k, j| energies[k] * sines[(k, j)]);
    sines.transpose() * scaled + DMatrix::from_element(n, n, h * h)
}

/// The p ≥ 0 of least ½ pᵀFp − wᵀp: guess where p > 0, solve, correct by the signs of p and of Fp −
/// w, until nothing changes.
fn pressure(compliance: &DMatrix<f64>, w: &DVector<f64>) -> Option<DVector<f64>> {
    let n = w.len();
    let mut is_pressed: Vec<bool> = w.iter().map(|w| *w > 0.0).collect();
    for _ in 0..100 {
        let pressed: Vec<usize> = (0..n).filter(|&j| is_pressed[j]).collect();
        let part = compliance.select_rows(&pressed).select_columns(&pressed);
        let found = part.cholesky()?.solve(&w.select_rows(&pressed));
        let mut p = DVector::zeros(n);
        pressed.iter().zip(found.iter()).for_each(|(&j, &value)| p[j] = value);
        let gap = compliance * &p - w;
        let next: Vec<bool> =
            (0..n).map(|j| if is_pressed[j] { p[j] > 0.0 } else { gap[j] < 0.0 }).collect();
        if next == is_pressed {
            return Some(p);
        }
        is_pressed = next;
    }
    None
}

/// Squares of bound and error, for one problem on all meshes.
fn squares(problem: &StripProblem, cone: Cone, finest: u32) -> Result<Vec<[f64; 2]>> {
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let fine = 32usize << finest;
    let load = problem.load(fine)?;
    let w = problem.operator(fine)?.solve(&load)?; // discrete harmonic, by fast cosine transforms
    let mut found = Vec::new();
    // Active set on the edge, linear problems by conjugate gradients to 1e-13.
    for u in problem.solutions(cone, 8, 1 << finest)? {
        let (n, g) = (u.cells, &u.values);
        let (h, operator) = (1.0 / n as f64, problem.operator(n)?);
        let energy = 0.5 * operator.energy(g)? - dot(&problem.load(n)?, g);
        // ∫ w over a segment by the trapezoidal rule, exact for w linear on the fine ones.
        let per = fine / n;
        let over = DVector::from_fn(n, |j, _| {
            let own = &w[j * per..=(j + 1) * per];
            (own.iter().sum::<f64>() - 0.5 * (own[0] + own[per])) / fine as f64
        });
        let compliance = compliance(n);
        let failed = || Error::option("finest", "the best pressure was not found");
        let p = pressure(&compliance, &over).ok_or_else(failed)?;
        let dual = -0.5 * dot(&load, &w) + over.dot(&p) - 0.5 * p.dot(&(&compliance * &p));
        let mut bound = 2.0 * (energy - dual);
        if cone == Cone::Midpoint {
            let mean: Vec<f64> = g.windows(2).map(|pair| 0.5 * (pair[0] + pair[1])).collect();
            let at = |i: usize| 0.5 * (mean[i.max(1) - 1] + mean[i.min(n - 1)]);
            let off: Vec<f64> = (0..=n).map(|i| g[i] - at(i)).collect();
            let work: f64 = (0..n).map(|j| p[j] * 0.5 * h * (off[j] + off[j + 1])).sum();
            bound += operator.energy(&off)? + 2.0 * work;
        }
        found.push([bound, problem.error(&u)?.value.powi(2)]);
    }
    Ok(found)
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    out.column("order", "order", "of the bound in h");
    out.column("theorem", "τ − 1", "the theorem");
    out.column("error_order", "of error", "of ‖∇(u − u^h)‖ in h");
    out.column("bound", "bound", "on the finest mesh");
    out.column("ratio", "bound/error", "largest of all meshes");
    let (cantor, fat) =
        (StripData::Cantor { ratio: 0.3, depth: 20 }, StripData::FatCantor { depth: 15 });
    let mut sets: Vec<(Vec<StripData>, f64)> = Vec::new();
    for tau in [1.55, 1.65, 1.75, 1.85, 1.95] {
        let place = |k: usize| StripData::Transition { position: 0.381966 + 0.0171 * k as f64 };
        sets.push(((0..8).map(place).collect(), tau));
    }
    sets.extend([1.6, 1.75, 1.9].map(|tau| (vec![cantor.clone()], tau)));
    sets.extend([1.55, 1.65, 1.8, 1.9].map(|tau| (vec![fat.clone()], tau)));
    for (positions, tau) in &sets {
        let name = positions[0].name();
        for cone in Cone::ALL {
            let mut sums = vec![[0.0_f64; 2]; options.finest as usize - 2];
            let mut ratio = 0.0_f64;
            for data in positions {
                let pair = data.data(*tau, 32 << options.finest, LateralCondition::Natural)?;
                let problem = StripProblem::new(StripKind::Scalar, &pair, Reference::Nested, 8)?;
                let all = squares(&problem, cone, options.finest)?;
                for (sum, [bound, error]) in sums.iter_mut().zip(&all) {
                    out.check("error/bound").at_most((error / bound).sqrt(), 1.0, "constant one");
                    ratio = ratio.max((bound / error).sqrt());
                    *sum = [sum[0] + bound, sum[1] + error];
                }
            }
            let points = |which: usize| -> Vec<(f64, f64)> {
                let roots = sums.iter().map(|sum| (sum[which] / positions.len() as f64).sqrt());
                roots.enumerate().map(|(k, root)| (0.125 / (1 << k) as f64, root)).collect()
            };
            let (order, error_order) = (exponent_of(&points(0)), exponent_of(&points(1)));
            let expected = (tau - 1.0).min(error_order.value - error_order.error);
            let claim = out.check("order of the bound + ±, less that of the error or τ − 1");
            claim.at_least(order.value + order.error - expected, 0.0, "the theorem");
            let (_, bound) = points(0)[sums.len() - 1];
            out.row(
                cells! { set: name, tau: *tau, cone: cone.to_string() => order, theorem: tau - 1.0,
                error_order, bound, ratio },
            );
            if cone == Cone::Nodal {
                let plot = out.plot(
                    "rate_of_the_bound",
                    "The bound on finer and finer meshes, nodal cone",
                    Axes::LogLog("h", "bound of ‖∇(u − u^h)‖"),
                );
                plot.line(&format!("{name}, τ = {tau}"), points(0));
            }
        }
    }
    Ok(())
}
