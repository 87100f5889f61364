//! Section 2: where τ comes from. Singular exponents of corners and transitions.
//!
//! Near a corner of opening ω the solution of a problem of plane strain is a sum of r^λ U(angle) and smoother functions;
//! such a term, unless it is a polynomial, lies in H^τ exactly for τ < 1 + Re λ. With κ = 3 − 4ν, ν Poisson's ratio, and
//! the sides D clamped, N free (or O, contact open), C contact closed (u_N = 0, σ_T = 0), either side first, λ is a zero
//! with Re λ > 0 of
//!
//! ```text
//! N-N:  sin²λω − λ² sin²ω               D-D:  κ² sin²λω − λ² sin²ω          C-N:  sin 2λω + λ sin 2ω
//! D-N:  4κ sin²λω − (κ+1)² + 4λ² sin²ω  C-C:  sin (λ−1)ω sin (λ+1)ω         C-D:  κ sin 2λω − λ sin 2ω
//! ```
//!
//! The list of the library has all zeros with 0 < Re λ < 3: their number in a rectangle is the number of turns of the argument
//! along its boundary, rectangles are cut until each holds one or two, and these are found in double-double. It is compared
//! with Newton's method in this file, and on a grid of openings, sides and ratios with a count along one rectangle and with the
//! eigenvalues of the equations of elasticity on the arc (Legendre polynomials), which know nothing of the formulas above.
//!
//! `excluded`: both signs of r^λ U break u_N ≤ 0 on an open or σ_N ≤ 0 on a closed side; `polynomial`: λ is an integer and r^λ U a
//! polynomial.
//!
//! Expected: the same zeros. Refuted if one is missing, if two computations differ by more than 1e-6 (Newton at double zeros)
//! or 1e-12 (arc), if D-N on one line has another imaginary part than ln κ/(2π), or if the signs of contact leave another
//! supremum than τ = 5/2 at a transition.
//!
//! `cargo run --release --example section_2_singular_exponents -- --omega 360 --sides N-N,C-O`

// `at_most(x, b)` holds if x + its ± ≤ b, `near(x, b, t)` if |x − b| + its ± ≤ t; otherwise it fails, or is
// undecided within ±. Of several calls the worst counts.
use example_report::figures::{Axis, Chart, Series};
use example_report::prelude::*;
use nalgebra::Complex;
use signorini::singular::{LARGEST, Medium, SideConditions, SignCondition, Wedge};
use std::f64::consts::PI;

example! { seconds "Section 2, exponents", "r^λ U lies in H^τ for τ < 1 + Re λ;  every λ with 0 < Re λ < 3 of a wedge is found, by three methods";
    /// opening angle ω in degrees
    omega: f64 = "270" in "(1, 360]" slider "30 to 360",
    /// Poisson's ratio
    poisson: f64 = "0.25" in "(-1, 0.5)" slider "-0.5 to 0.49",
    /// conditions on the two sides: clamped D, free N, contact closed C, contact open O
    sides: Vec<SideConditions> = "N-N,D-N,C-N",
}

/// Zeros of the equation of these sides with 0 < Re λ < 3 and Im λ ≥ 0: Newton's method from a grid of starts, with a
/// difference quotient; limits nearer than 1e-4 are one.
fn by_definition(sides: &str, omega: f64, kappa: f64) -> Vec<Complex<f64>> {
    let sine = |z: Complex<f64>| (z * omega).sin();
    let square = omega.sin().powi(2);
    let equation = |z: Complex<f64>| match sides {
        "D-D" => sine(z).powi(2) * kappa * kappa - z * z * square,
        "D-N" | "N-D" => sine(z).powi(2) * (4.0 * kappa) - (kappa + 1.0).powi(2) + z * z * (4.0 * square),
        "C-C" => sine(z - 1.0) * sine(z + 1.0),
        "C-N" | "C-O" => sine(z * 2.0) + z * (2.0 * omega).sin(),
        "C-D" => sine(z * 2.0) * kappa - z * (2.0 * omega).sin(),
        _ => sine(z).powi(2) - z * z * square, // N-N
    };
    let mut zeros: Vec<Complex<f64>> = Vec::new();
    for (a, b) in (1..=60).flat_map(|a| (0..=10).map(move |b| (0.05 * f64::from(a), 0.1 * f64::from(b)))) {
        let (mut z, mut step) = (Complex::new(a, b), Complex::new(1.0, 0.0));
        for _ in 0..60 {
            let slope = (equation(z + 1e-6) - equation(z - 1e-6)) / 2e-6;
            step = equation(z) / slope;
            z -= step;
        }
        let is_new = zeros.iter().all(|other| (other - z).norm() > 1e-4);
        if step.norm() < 1e-7 && z.re > 0.02 && z.re < LARGEST - 1e-9 && z.im > -1e-7 && is_new {
            zeros.push(z);
        }
    }
    zeros
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    out.column("number", "", "");
    out.column("re", "Re λ", "");
    out.column("im", "Im λ", "of a pair the one above the axis");
    out.column("definition", "Newton", "Re λ by Newton's method in this file");
    out.column("zeros", "zeros", "multiplicity; fewer functions than zeros: r^λ ln r");
    out.column("functions", "functions", "linearly independent U");
    out.column("kind", "kind", "polynomial: no limit to τ; excluded: by the signs of contact");
    let (medium, omega) = (Medium::PlaneStrain(options.poisson), options.omega.to_radians());
    for &sides in &options.sides {
        let wedge = Wedge::new(omega, sides, medium)?;
        let listed = wedge.exponents()?.exponents;
        let newton = by_definition(&sides.to_string(), omega, 3.0 - 4.0 * options.poisson);
        for (k, exponent) in listed.iter().enumerate() {
            let (re, im) = (exponent.re.value, exponent.im.value);
            let place = Complex::new(re, im);
            let near = newton.iter().min_by(|a, b| (*a - place).norm().total_cmp(&(*b - place).norm()));
            let kind = match (wedge.sign_condition(exponent), exponent.is_polynomial()) {
                (SignCondition::Excluded, _) => "excluded",
                (_, true) => "polynomial",
                _ => "",
            };
            out.row(cells! { sides: sides.to_string(), number: k + 1 => re: Measured::from(exponent.re), im,
                definition: near.map(|z| z.re), zeros: exponent.multiplicity, functions: exponent.modes.len(), kind });
            let apart = near.map_or(f64::INFINITY, |z| (z - place).norm());
            out.check("|λ (library) − λ (Newton)|").at_most(apart, 1e-6, "characteristic equations");
        }
        // Every λ of the list has one of Newton's beside it: if there are as many, none of those is missing.
        let missing = (newton.len() as f64 - listed.len() as f64).abs();
        out.check("|number of zeros (Newton) − number (library)|").at_most(missing, 0.0, "no zero missing");
    }
    for (turn, &sides) in (1..=8).flat_map(|turn| SideConditions::ALL.iter().map(move |sides| (turn, sides)))
    {
        for poisson in [-0.9, 0.3, 0.49] {
            let wedge = Wedge::new(f64::from(turn) * PI / 4.0, sides, Medium::PlaneStrain(poisson))?;
            let spectrum = wedge.exponents()?;
            let end = |exponent: Option<&signorini::singular::Exponent>| exponent.map_or(1.0, |e| e.re.value);
            let (first, last) = (end(spectrum.exponents.first()), end(spectrum.exponents.last()));
            // Turns of the argument of the equation along one rectangle from half the first to just above the last zero.
            let count = wedge.count(0.5 * first, LARGEST - 0.02 * (LARGEST - last))?;
            let lost = count as f64 - spectrum.zeros() as f64;
            out.check("zeros, 144 wedges: |counted − listed|").at_most(lost.abs(), 0.0, "argument principle");
            // u = r^λ U(φ) in the weak equations: (A₀ + λ A₁ + λ² A₂) U = 0, U by Legendre polynomials on the arc, up to degree
            // 24 + 4ω; eigenvalues of the linearised problem. Of zeros nearer than 0.05 the means are compared.
            let inside = |z: &(f64, f64)| z.0 > 1e-3 && z.0 < LARGEST - 1e-3;
            let listed: Vec<_> = spectrum.places().into_iter().filter(inside).collect();
            let height = 0.5 + listed.iter().map(|z| z.1).fold(0.0, f64::max);
            let arc = wedge.exponents_on_arc((24.0 + 4.0 * wedge.angle()) as usize, height)?;
            let arc: Vec<_> = arc.into_iter().map(|z| (z.re, z.im)).filter(inside).collect();
            let mean = |of: &[(f64, f64)], z: (f64, f64)| {
                let near = of.iter().filter(|other| (other.0 - z.0).hypot(other.1 - z.1) < 0.05);
                near.fold((0.0, 0.0, 0.0), |sum, other| (sum.0 + 1.0, sum.1 + other.0, sum.2 + other.1))
            };
            for &z in &listed {
                let (a, b) = (mean(&listed, z), mean(&arc, z));
                let apart =
                    if a.0 == b.0 { (a.1 - b.1).hypot(a.2 - b.2) / a.1.hypot(a.2) } else { f64::INFINITY };
                out.check("144 wedges: |λ (library) − λ (arc)|/|λ|").at_most(apart, 1e-12, "rounding error");
            }
        }
    }
    let flat = Wedge::new(PI, "D-N".parse()?, medium)?.exponents()?;
    let oscillation = flat.exponents.first().map(|exponent| Measured::from(exponent.im));
    out.check("D-N, ω = π: Im λ of the first exponent").near(
        oscillation,
        (3.0 - 4.0 * options.poisson).ln() / (2.0 * PI),
        1e-12,
        "ln κ/(2π)",
    );
    let transition = Wedge::new(PI, "C-O".parse()?, medium)?.regularity()?.tau;
    out.check("contact transition: supremum of τ").near(transition, 2.5, 1e-12, "r^(3/2)");
    if out.draws() {
        out.chart("section_2_singular_exponents", chart(medium)?);
    }
    Ok(())
}

/// The first exponent that is no polynomial against the opening.
fn chart(medium: Medium) -> Result<Chart> {
    let x = Axis::linear("opening in degrees").range(0.0, 360.0);
    let y = Axis::linear("first Re λ, polynomials left out").range(0.0, 3.0);
    let mut chart = Chart::new("Singular exponents", x, y);
    for sides in SideConditions::ALL {
        let mut points = Vec::new();
        // Off the round angles, at some of which the first exponent belongs to a polynomial by accident (D-N at 60°).
        for degrees in (0..170).map(|k| 20.5 + 2.0 * f64::from(k)) {
            let first = Wedge::new(degrees.to_radians(), sides, medium)?.first_singular()?;
            points.extend(first.map(|exponent| (degrees, exponent.re.value)));
        }
        chart = chart.with(Series::line(sides.to_string(), points));
    }
    Ok(chart)
}
