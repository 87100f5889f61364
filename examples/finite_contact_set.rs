//! When is the contact set finite? The square of a stress and a slope is analytic across the
//! contact edge.
//!
//! The paper assumes nothing of the contact set, and its introduction asks whether contact sets
//! that are not finite unions of intervals exist. This file is about a case in which they do not.
//! Let a homogeneous isotropic body with Lamé's constants λ, μ lie above a straight contact edge on
//! y = 0, without friction, with body force and gap analytic near it. Put
//!
//! ```text
//! elastic    u_N = −u_y,  σ_N = σ_yy,    c = 2μ(λ + μ)/(λ + 2μ);
//! −Δu = f    u_N = u,     σ_N = ∂u/∂n,   c = 1.
//! ```
//!
//! Then, on the edge,
//!
//! ```text
//! F = σ_N − i c u_N'   is the trace of a function that is holomorphic above the edge,
//! F² = σ_N² in contact,     F² = −(c u_N')² in gaps,     as σ_N u_N' = 0.
//! ```
//!
//! So F² is real on the edge, and by reflection analytic across it. It changes its sign at the ends
//! of contact: they are zeros of an analytic function, hence isolated inside the edge, unless F² is
//! zero everywhere. Where Γ_C meets Γ_D, the case of which the introduction speaks, this says
//! nothing.
//!
//! This file tests that F², computed with linear elements, is analytic. At an end of contact x₀ it
//! takes samples at distances from 4h to w = 0.15,
//!
//! ```text
//! in contact    F² = (nodal force/h)²                at the nodes,
//! in gaps       F² = −c² ((u_(i+1) − u_i)/h)²        at the middles of the segments,
//! ```
//!
//! and fits to them a rational function P/Q in t = (x − x₀)/w, P of degree 4 and Q of degree 2
//! (`Rational::fit`). The zero of P/Q predicts the end of contact. There the slope of F² is −K²,
//! where K is the stress intensity: σ_N ≈ −K √r at the distance r from the end. As a control |F²|
//! is fitted in the same way: it has a corner at the end, and no such P/Q fits it.
//!
//! The bodies, on the unit square with n × n squares cut from lower left to upper right, nodal
//! cone:
//!
//! ```text
//! block         f = (0, −cos πx), λ = μ = 1, fixed at y = 1, free sides, contact at y = 0
//! membrane      −Δu = cos 2πx + 3/10, the same conditions; the left end of its gap
//! closed form   2 u_x = −½ Im Z − y Re Z', 2 u_y = (3/2) Re Z + y Im Z', λ = μ = 1,
//!               Z = (x + iy − 3/10)^(3/2), prescribed on three sides: contact on x < 3/10,
//!               K = 3/2, F² = (9/4) (3/10 − x)
//! ```
//!
//! The load vector is that of the interpolant of f at the nodes.
//!
//! Refuted if on the coarsest mesh with at least ten samples (64, for the membrane 128) the zero of
//! P/Q is further than h/8 from the end of contact, which is 3/10 for the closed form, else the
//! zero on the finest mesh; if K there differs by more than 3 % from 3/2, or from that of the
//! finest mesh; if a pole of P/Q is nearer to the samples than w/4, for block and membrane (F² of
//! the closed form is linear, so that its fit has coefficients to spare, and poles made of rounding
//! errors); or if for n ≥ 256 the misfit of |F²| is less than ten times that of F². No number has
//! an error bar: the finest mesh stands for the exact end and K. A body with fewer than two such
//! meshes has no check of its end and of K. Shown, and decided by nothing: the end of the discrete
//! contact set is within h/2 of the end.
//!
//! Finer meshes:
//!
//! `cargo run --release --example finite_contact_set -- --n 64,128,256,512`

use example_report::prelude::*;
use nalgebra::{DMatrix, DVector};
use signorini::cone::Cone;
use signorini::contact::{ContactSolution, Solver};
use signorini::fem::Lame;
use signorini::problems::{KnownSolution, TestProblem};

example! { seconds "When the contact set is finite",
    "F² = (σ_N − i c u_N')² is analytic on the contact edge; ends of contact are its zeros";
    /// meshes of n × n squares, the coarsest first
    n: Vec<usize> = "64,128,256" in "[32, 2048]",
}

/// The largest distance of samples from the end of contact: the membrane has two ends, 0.148 apart.
const WIDTH: f64 = 0.15;

/// P/Q with P of degree 4 and Q of degree 2 in t = (x − x₀)/w; coefficients from low to high.
pub(crate) struct Rational {
    p: [f64; 5],
    q: [f64; 3],
}

impl Rational {
    /// The fit to samples (t, F²): P and Q minimise the sum of ((P − F² Q)/Q₀)² over all unit
    /// vectors of the eight coefficients, where Q₀ is the Q found before, 1 at first; eight times.
    /// The minimiser is the singular vector of the smallest singular value.
    pub(crate) fn fit(points: &[(f64, f64)]) -> Result<Self> {
        let mut q = vec![1.0; points.len()];
        let mut v = DVector::zeros(8);
        for _ in 0..8 {
            let row = |i: usize, j: usize| {
                let (t, f) = points[i];
                (if j < 5 { t.powi(j as i32) } else { -f * t.powi(j as i32 - 5) }) / q[i]
            };
            let right = DMatrix::from_fn(points.len(), 8, row).svd(false, true).v_t;
            v = right
                .ok_or_else(|| Error::Option("no singular vectors were computed".into()))?
                .row(7)
                .transpose();
            q = points.iter().map(|(t, _)| (v[5] + t * (v[6] + t * v[7])).abs()).collect();
        }
        Ok(Self { p: [v[0], v[1], v[2], v[3], v[4]], q: [v[5], v[6], v[7]] })
    }

    fn at(&self, t: f64) -> f64 {
        let horner = |c: &[f64]| c.iter().rev().fold(0.0, |sum, c| sum * t + c);
        horner(&self.p) / horner(&self.q)
    }

    /// The zero nearest to 0, by bisection in the nearest one of 100 intervals with a change of
    /// sign.
    pub(crate) fn zero(&self) -> f64 {
        let changes =
            |k: &i32| self.at(0.01 * f64::from(*k)) * self.at(0.01 * f64::from(*k + 1)) <= 0.0;
        let Some(k) = (-50..50).filter(changes).min_by_key(|k| (2 * k + 1).abs()) else {
            return f64::NAN;
        };
        let (mut a, mut b) = (0.01 * f64::from(k), 0.01 * f64::from(k + 1));
        for _ in 0..60 {
            let middle = 0.5 * (a + b);
            if self.at(a) * self.at(middle) <= 0.0 { b = middle } else { a = middle }
        }
        0.5 * (a + b)
    }

    /// Distance of the nearest zero of Q from [−1, 1], in the complex plane.
    pub(crate) fn pole(&self) -> f64 {
        let [c, b, a] = self.q;
        let (middle, root) = (-0.5 * b / a, 0.25 * (b / a).powi(2) - c / a);
        let outside = |x: f64| (x.abs() - 1.0).max(0.0);
        match root < 0.0 {
            true => outside(middle).hypot((-root).sqrt()),
            false => outside(middle - root.sqrt()).min(outside(middle + root.sqrt())),
        }
    }

    /// The root of the sum of (P/Q − F²)² over that of the sum of F⁴.
    pub(crate) fn misfit(&self, points: &[(f64, f64)]) -> f64 {
        let sum =
            |of: &dyn Fn(&(f64, f64)) -> f64| points.iter().map(|p| of(p).powi(2)).sum::<f64>();
        (sum(&|(t, f)| self.at(*t) - f) / sum(&|(_, f)| *f)).sqrt()
    }
}

/// (x, F²) along the edge, from left to right.
pub(crate) fn samples(u: &ContactSolution, c: f64) -> Vec<(f64, f64)> {
    let (h, active) = (1.0 / (u.pressure.len() - 1) as f64, |i: usize| u.pressure[i] > 0.0);
    let mut points = Vec::new();
    for i in 0..u.pressure.len() - 1 {
        let x = i as f64 * h;
        if active(i) {
            points.push((x, u.pressure[i].powi(2)));
        }
        if !(active(i) && active(i + 1)) {
            let slope = (u.normal_displacement[i + 1] - u.normal_displacement[i]) / h;
            points.push((x + 0.5 * h, -(c * slope).powi(2)));
        }
    }
    points
}

/// An end of the contact set on one mesh.
struct End {
    h: f64,
    /// Between the last node in contact and the next one.
    mesh: f64,
    /// Where F² vanishes.
    zero: f64,
    /// The stress intensity there.
    k: f64,
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    out.column("mesh", "mesh", "its end of contact, the middle of a segment");
    out.column("zero", "zero", "of F², the predicted end of contact");
    out.column("pole", "pole", "distance of the nearest pole of P/Q from the samples");
    out.column("misfit", "misfit", "of P/Q to F², relative");
    out.column("corner", "|F|²", "misfit of the control");
    let lame = Lame::new(1.0, 1.0)?;
    let elastic = 2.0 * lame.mu() * (lame.lambda() + lame.mu()) / (lame.lambda() + 2.0 * lame.mu());
    let closed = KnownSolution::one_transition(Some(lame));
    for (body, c, test) in [
        ("block", elastic, Some(TestProblem::Block)),
        ("membrane", 1.0, Some(TestProblem::Membrane)),
        ("closed form", elastic, None),
    ] {
        let mut found = Vec::new();
        for &n in &options.n {
            let h = 1.0 / n as f64;
            let problem = match test {
                Some(test) => test.problem(n)?,
                None => closed.problem(n)?,
            };
            // Active set: exact to rounding. Multigrid: twelve digits.
            let solver = if n <= 256 { Solver::ActiveSet } else { Solver::Multigrid };
            let u = problem.solve(Cone::Nodal, solver)?;
            let active = |i: usize| u.pressure[i] > 0.0;
            let ends =
                (1..n - 1).filter(|&i| active(i) != active(i + 1)).map(|i| (i as f64 + 0.5) * h);
            let ends: Vec<f64> = ends.collect();
            let Some(&end) = ends.first() else { continue };
            let used = |x: f64| {
                let far = ends.iter().all(|end| (x - end).abs() >= 4.0 * h);
                far && (x - end).abs() <= WIDTH && (2.0 * h..=1.0 - 2.0 * h).contains(&x)
            };
            let all = samples(&u, c);
            let points: Vec<(f64, f64)> = all
                .iter()
                .filter(|(x, _)| used(*x))
                .map(|(x, f)| ((x - end) / WIDTH, *f))
                .collect();
            if points.len() < 10 {
                continue; // hardly more samples than unknown coefficients: no row, no check
            }
            let fit = Rational::fit(&points)?;
            let (t, step) = (fit.zero(), 1e-4);
            let (zero, slope) =
                (end + WIDTH * t, (fit.at(t + step) - fit.at(t - step)) / (2.0 * step * WIDTH));
            let absolute: Vec<(f64, f64)> = points.iter().map(|(t, f)| (*t, f.abs())).collect();
            let (misfit, corner) =
                (fit.misfit(&points), Rational::fit(&absolute)?.misfit(&absolute));
            let (pole, k) = (WIDTH * fit.pole(), slope.abs().sqrt());
            out.row(cells! { body, n => mesh: end, zero, pole, K: k, misfit, corner });
            if test.is_some() {
                let claim = out.check("pole distance/window width");
                claim.at_least(pole / WIDTH, 0.25, "F² is analytic");
            }
            if n >= 256 {
                let claim = out.check("n ≥ 256: misfit of |F|²/misfit of F²");
                claim.at_least(corner / misfit, 10.0, "|F|² has a corner");
            }
            if out.draws() && test.is_some() {
                let curve = (0..=200).map(|i| f64::from(i) / 100.0 - 1.0);
                let curve = curve.map(|t| (end + WIDTH * t, fit.at(t))).collect();
                let (name, title) =
                    (format!("finite_contact_set_{body}_{n}"), format!("F² on the edge, {body}"));
                let plot = out.plot(&name, &title, Axes::Linear("x", "F²"));
                plot.line("from u^h", all).dashed_line("P/Q", curve);
            }
            found.push(End { h, mesh: end, zero, k });
        }
        let [coarsest, .., finest] = &found[..] else { continue };
        let (exact, k_exact) = if test.is_some() { (finest.zero, finest.k) } else { (0.3, 1.5) };
        let off = |x: f64| (x - exact).abs() / coarsest.h;
        let claim = out.check("coarsest mesh: |zero of F² − end|/h");
        claim.at_most(off(coarsest.zero), 0.125, "finest mesh or 3/10");
        let claim = out.observe("coarsest mesh: |discrete end − end|/h");
        claim.at_most(off(coarsest.mesh), 0.5, "half a segment");
        let claim = out.check("coarsest mesh: K/reference value of K");
        claim.differ_by_at_most(coarsest.k / k_exact, 1.0, 0.03, "finest mesh or 3/2");
    }
    Ok(())
}
