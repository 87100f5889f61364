//! Lemma 6.1 on triangles: best constants of linear interpolation, and what flat and sharp angles
//! cost.
//!
//! The paper's lemma is about intervals. In the plane let T be the triangle with two sides of
//! length 1 at an angle α, I u the linear function with the values of u at the three corners, and
//!
//! ```text
//! |∇u|²_s = ∬ |∇u(x) − ∇u(y)|² / |x − y|^(2+2s) dx dy over T × T,    0 < s < 1,    |∇u|₁ = ‖D²u‖₀.
//! ```
//!
//! Then the lemma reads, with best constants C and C' that depend on s and α,
//!
//! ```text
//! ‖∇(u − I u)‖₀ ≤ C |∇u|_s,        ‖u − I u‖₀ ≤ C' |∇u|_s.
//! ```
//!
//! This file computes C and C', and a lower bound of C from quadratic u. As s → 1, ((1−s)
//! 2/π)^(1/2) |∇u|_s → ‖D²u‖₀; hence, with h the longest side, constants of different s and α are
//! compared as
//!
//! ```text
//! C_h = C (π/2/(1−s))^(1/2) / h^s for s < 1,        C_h = C/h for s = 1.
//! ```
//!
//! Flat angles, α → 180°, raise C_h for every s. Sharp angles, α → 0, raise it for s < 1 only: for
//! a function of one variable along a triangle of width w = α, ‖∇(u − I u)‖₀² is of order w, and
//! |∇u|²_s of order w² for s < 1/2 (pairs of points farther apart than w) and w^(3−2s) for s > 1/2
//! (nearer pairs). So each halving of α multiplies C_h by a factor that tends to 2^min(1/2, 1−s), 1
//! at s = 1.
//!
//! Refuted if a quadratic function has a larger quotient than C; if C_h(α) < 2 C_h(60°) for an α ≥
//! 135°; if the factor from 20° to 10° is less than 2 to half of that exponent, 2^(min(1/2,
//! 1−s)/2), for s ≤ 3/4, or more than 1.05 at s = 1; or if C at s = 1 exceeds 0.49291 at 90°
//! (Babuška, Aziz 1976) or Kobayashi's bound (2011),
//!
//! ```text
//! C² ≤ a²b²c²/(16S²) − (a²+b²+c²)/30 − (S²/5)(1/a²+1/b²+1/c²),   sides a, b, c, area S.
//! ```
//!
//! C, C_h and the factors have a ±; the quotients of quadratics and both published bounds have
//! none. A comparison holds if it does on the whole error bar, is refuted if it fails on the whole
//! of it, and undecided otherwise; also where the bar is so wide that √2 for the factor at s = 1,
//! or 1 for the factor at s < 1 and for C_h(α)/C_h(60°), would pass as well.
//!
//! `cargo run --release --example lemma_6_1_on_triangles -- --s 0.9,0.3 --angle 15,90,150`

use example_report::prelude::*;
use fractional_sobolev::{
    Domain::Triangle, ErrorNorm, Function, Triangles, interpolation_constant,
};
use nalgebra::{DMatrix, Matrix2, Vector2};
use std::f64::consts::{FRAC_PI_2, SQRT_2};

example! { seconds "Lemma 6.1, triangles",
    "‖∇(u − I u)‖₀ ≤ C |∇u|_s on a triangle; flat angles raise C, for s < 1 sharp ones too";
    /// orders s of the seminorm of ∇u; s = 1 is always included
    s: Vec<f64> = "0.25,0.75" in "[0.02, 1]" slider "0.1 to 0.98",
    /// angles α in degrees; 10, 20 and 60 are always included
    angle: Vec<f64> = "20,90,135" in "(6, 174)" slider "10 to 160",
}

/// Babuška and Aziz' bound (1976) at s = 1, α = 90°: the largest root x of 1/x + tan(1/x) = 0.
const BABUSKA_AZIZ: f64 = 0.492_912_451_754_9;

/// Kobayashi's bound of C at s = 1.
fn kobayashi(corners: [[f64; 2]; 3]) -> f64 {
    let square = |p: [f64; 2], q: [f64; 2]| (p[0] - q[0]).powi(2) + (p[1] - q[1]).powi(2);
    let [p, q, r] = corners;
    let [a, b, c] = [square(p, q), square(q, r), square(r, p)]; // squares of the sides
    let area = 0.5 * ((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]));
    let (product, inverse) = (a * b * c, 1.0 / a + 1.0 / b + 1.0 / c);
    (product / (16.0 * area * area) - (a + b + c) / 30.0 - area * area / 5.0 * inverse).sqrt()
}

/// The largest ‖∇(u − I u)‖₀ / |∇u|_s of quadratic u, from the definition. With the Hessian H of u,
///
/// ```text
/// ∇u = H x,    |∇u|²_s = tr(H G Hᵀ),    G_kl = ∬ (x_k − y_k)(x_l − y_l) / |x − y|^(2+2s) dx dy,
/// ```
///
/// and ∇(u − I u) = H x − the slope of I u. The symmetric matrices H have a basis of three; the
/// best of them is a generalised eigenvector of two 3 × 3 forms.
fn of_quadratics(corners: [[f64; 2]; 3], s: f64) -> Result<f64> {
    let mesh = Triangles::new(&corners, &[[0, 1, 2]])?;
    let area = mesh.areas()[0];
    // w·G w for w = (a, b), the seminorm of the linear function a x₁ + b x₂: with x − y = r e,
    // e = (cos φ, sin φ), it is ∫ (w·e)² S N(e)^(2s−2) B(2−2s, 3) dφ over (0, 2π), S |w|² at s = 1,
    // S the area, N half the sum of |barycentric parts of e|; Gauss rules, to 1e-8.
    let square = |a: f64, b: f64| -> Result<f64> {
        let linear = Function::on_triangles(&mesh, 1, &corners.map(|[x, y]| a * x + b * y))?;
        Ok(linear.seminorm(s, 1e-8)?.value.powi(2))
    };
    let (g11, g22) = (square(1.0, 0.0)?, square(0.0, 1.0)?);
    let g12 = (square(1.0, 1.0)? - g11 - g22) / 2.0;
    let g = Matrix2::new(g11, g12, g12, g22);

    let corner = corners.map(|[x, y]| Vector2::new(x, y));
    let sides = Matrix2::from_columns(&[corner[1] - corner[0], corner[2] - corner[0]]);
    let hessians = [
        Matrix2::new(1.0, 0.0, 0.0, 0.0),
        Matrix2::new(0.0, 1.0, 1.0, 0.0),
        Matrix2::new(0.0, 0.0, 0.0, 1.0),
    ];
    let to_slope = sides.transpose().try_inverse().unwrap_or_default();
    // ∇(u − I u) at x, for u = x·H x/2
    let gradient = |h: &Matrix2<f64>, x: Vector2<f64>| {
        let u = corner.map(|corner| 0.5 * corner.dot(&(h * corner)));
        h * x - to_slope * Vector2::new(u[1] - u[0], u[2] - u[0])
    };
    // The rule of the midpoints of the sides is exact for products of linear functions.
    let error = DMatrix::from_fn(3, 3, |i, j| {
        let at_middle = |k: usize| {
            let middle = (corner[k] + corner[(k + 1) % 3]) / 2.0;
            gradient(&hessians[i], middle).dot(&gradient(&hessians[j], middle))
        };
        area / 3.0 * (at_middle(0) + at_middle(1) + at_middle(2))
    });
    let form = DMatrix::from_fn(3, 3, |i, j| (hessians[i] * g * hessians[j].transpose()).trace());
    Ok(largest_eigenvalue(&error, &form)?.sqrt())
}

/// The values, those always included, in increasing order.
fn sorted(values: &[f64], always: &[f64]) -> Vec<f64> {
    let mut values = [values, always].concat();
    values.sort_by(f64::total_cmp);
    values.dedup();
    values
}

/// Two sides of length 1 at the angle α, in degrees.
fn isosceles(angle: f64) -> [[f64; 2]; 3] {
    let (x, y) = (0.5 * angle).to_radians().sin_cos();
    [[0.0, y], [-x, 0.0], [x, 0.0]]
}

/// Best constants on one triangle.
struct Constants {
    angle: f64,
    c: Measured,
    c_l2: Measured,
    c_h: Measured,
}

/// C, C' and C_h. Trial functions: polynomials of degree p up to 30, and r^(2s) times trigonometric
/// functions of the angle about each corner. The largest quotients for p, p − 2, p − 4 settle like
/// p^(−k): C is their limit, ± the change of that limit with p. The double integrals are computed
/// by Gauss rules in polar coordinates about the corners, to 3e-8.
fn constants(s: f64, angle: f64) -> Result<Constants> {
    let triangle = Triangle(isosceles(angle));
    let found = interpolation_constant(triangle, ErrorNorm::Derivative, s, 1e-3)?;
    let c = Measured::from(found.constant);
    let c_l2 = found.in_norm(ErrorNorm::L2)?.constant.into();
    let longest = (2.0 * (0.5 * angle).to_radians().sin()).max(1.0);
    let unit = if s < 1.0 { (FRAC_PI_2 / (1.0 - s)).sqrt() } else { 1.0 };
    Ok(Constants { angle, c, c_l2, c_h: c * (unit / longest.powf(s)) })
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    let angles = sorted(&options.angle, &[10.0, 20.0, 60.0]);
    for s in sorted(&options.s, &[1.0]) {
        let found =
            angles.iter().map(|&angle| constants(s, angle)).collect::<Result<Vec<Constants>>>()?;
        let c_h_at = |angle: f64| -> Measured {
            found.iter().find(|found| found.angle == angle).map(|found| found.c_h).into()
        };
        for &Constants { angle, c, c_l2, c_h } in &found {
            let quadratics = of_quadratics(isosceles(angle), s)?;
            let upper = if s == 1.0 { Some(kobayashi(isosceles(angle))) } else { None };
            out.row(cells! { s, angle => c, quadratics, upper, c_h, c_l2 });

            let claim = out.check("max ‖∇(u − I u)‖₀/(C |∇u|_s), u quadratic");
            claim.whole_error_bars_at_most(c.recip() * quadratics, 1.0, "best constant");
            if let Some(upper) = upper {
                let claim = out.check("s = 1: C/Kobayashi's bound");
                claim.whole_error_bars_at_most(c / upper, 1.0, "Kobayashi 2011");
            }
            if s == 1.0 && angle == 90.0 {
                let claim = out.check("s = 1, α = 90°: C");
                claim.whole_error_bars_at_most(c, BABUSKA_AZIZ, "Babuška, Aziz 1976");
            }
            if angle >= 135.0 {
                let claim = out.check("α ≥ 135°: C_h(α)/C_h(60°)").undecided_if_also_true_of(1.0);
                claim.whole_error_bars_at_least(c_h / c_h_at(60.0), 2.0, "C grows as α → 180°");
            }
        }
        let factor = c_h_at(10.0) / c_h_at(20.0);
        if s == 1.0 {
            let claim = out.check("s = 1: C_h(10°)/C_h(20°)").undecided_if_also_true_of(SQRT_2);
            claim.whole_error_bars_at_most(factor, 1.05, "1 as α → 0");
        } else if s <= 0.75 {
            let half_way = 2f64.powf(0.5 * (1.0 - s).min(0.5));
            let claim =
                out.check(format!("s = {s}: C_h(10°)/C_h(20°)")).undecided_if_also_true_of(1.0);
            claim.whole_error_bars_at_least(
                factor,
                half_way,
                "half of the exponent of 2^min(1/2, 1−s), α → 0",
            );
        }
    }
    out.column("angle", "α", "angle between the equal sides, in degrees");
    out.column("c", "C", "best constant for the gradient");
    out.column("upper", "upper", "Kobayashi's bound");
    out.column("quadratics", "quadratics", "the largest quotient of quadratic u");
    out.column("c_h", "C_h", "C over h^s, normalised");
    out.column("c_l2", "C'", "best constant in L²");
    let axes = Axes::LinearLog("α, angle between the equal sides, in degrees", "C_h");
    out.plot("lemma_6_1_on_triangles", "Constant of interpolation on isosceles triangles", axes)
        .curve_by("s", "angle", "c_h");
    Ok(())
}
