//! Lemma 6.1 on triangles: best constants of linear interpolation, and what flat and sharp angles
//! cost.
//!
//! T is the triangle with two sides of length 1 at an angle α, and I u the linear function with the
//! values of u at the three corners. For 0 < s < 1 let |∇u|²_s = ∬ |∇u(x) − ∇u(y)|² / |x −
//! y|^(2+2s) dx dy over T × T, and |∇u|₁ = ‖D²u‖₀. The paper's lemma is about intervals; in the
//! plane it reads, with the best constants C and C' for this s and α,
//!
//! ```text
//! ‖∇(u − I u)‖₀ ≤ C |∇u|_s,        ‖u − I u‖₀ ≤ C' |∇u|_s.
//! ```
//!
//! As s → 1, ((1−s) 2/π)^(1/2) |∇u|_s → ‖D²u‖₀. So constants of different s and size h, the longest
//! side, compare by
//!
//! ```text
//! C_h = C (π/2/(1−s))^(1/2) / h^s,   at s = 1:  C_h = C/h.
//! ```
//!
//! Refuted if C at s = 1 is above Kobayashi's bound (2011), with the sides a, b, c and the area S
//! C² ≤ a²b²c²/(16S²) − (a²+b²+c²)/30 − (S²/5)(1/a²+1/b²+1/c²). If a quadratic function has a
//! larger quotient than C. If C_h is not twice that at 60° for α ≥ 135°, or not above it for α ≤
//! 20° and s ≤ 3/4: at s = 1 sharp angles cost nothing.
//!
//! `cargo run --release --example lemma_6_1_on_triangles -- --s 0.9,0.3 --angle 15,90,150`

use example_report::prelude::*;
use fractional_sobolev::{
    Domain::Triangle, ErrorNorm, Function, Triangles, interpolation_constant,
};
use nalgebra::{DMatrix, Matrix2, Vector2};
use std::f64::consts::FRAC_PI_2;

example! { seconds "Lemma 6.1, triangles",
    "‖∇(u − I u)‖₀ ≤ C |∇u|_s on a triangle; flat angles raise C, for s < 1 sharp ones too";
    /// orders s of the seminorm of ∇u; s = 1 is always included
    s: Vec<f64> = "0.25,0.75" in "[0.02, 1]" slider "0.1 to 0.98",
    /// angles α in degrees; 60 is always included
    angle: Vec<f64> = "20,90,135" in "(6, 174)" slider "10 to 160",
}

/// Babuška and Aziz' bound (1976) at s = 1, α = 90°: the root of 1/x + tan(1/x) = 0.
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

/// The largest ‖∇(u − I u)‖₀ / |∇u|_s of quadratic u, from the definition: ∇u = H x with the
/// Hessian H, so |∇u|²_s = tr(H G Hᵀ), G the form of the seminorm for the functions x₁, x₂ on T; u
/// − I u has the gradient H x − g.
fn of_quadratics(corners: [[f64; 2]; 3], s: f64) -> Result<f64> {
    let mesh = Triangles::new(&corners, &[[0, 1, 2]])?;
    // |a x₁ + b x₂|²_s: a smooth integral in the ratio of distances from a corner, by Gauss rules
    // to 1e-8. With w = (a, b) it is ∫ (w·e)² S N(e)^(2s−2) B(2−2s, 3) dφ, e = (cos φ, sin φ), S
    // the area, N half the sum of |barycentric parts of e|.
    let square = |a: f64, b: f64| -> Result<f64> {
        let linear = Function::on_triangles(&mesh, 1, &corners.map(|[x, y]| a * x + b * y))?;
        Ok(linear.seminorm(s, 1e-8)?.value.powi(2))
    };
    let (xx, yy, sum) = (square(1.0, 0.0)?, square(0.0, 1.0)?, square(1.0, 1.0)?);
    let g = Matrix2::new(xx, (sum - xx - yy) / 2.0, (sum - xx - yy) / 2.0, yy);
    let corner = corners.map(|[x, y]| Vector2::new(x, y));
    let edges = Matrix2::from_columns(&[corner[1] - corner[0], corner[2] - corner[0]]);
    let hessians = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]]
        .map(|h| Matrix2::from_row_slice(&h));
    let gradient = |h: &Matrix2<f64>, x: Vector2<f64>| {
        let u = corner.map(|corner| 0.5 * corner.dot(&(h * corner)));
        let slope = edges.transpose().try_inverse().unwrap_or_default()
            * Vector2::new(u[1] - u[0], u[2] - u[0]);
        h * x - slope
    };
    // the rule of the midpoints of the sides is exact for the square of a linear function
    let error = |i: usize, j: usize| -> f64 {
        let middle = |k: usize| (corner[k] + corner[(k + 1) % 3]) / 2.0;
        let product = |k| gradient(&hessians[i], middle(k)).dot(&gradient(&hessians[j], middle(k)));
        (0..3).map(product).sum::<f64>() * mesh.areas()[0] / 3.0
    };
    let form = DMatrix::from_fn(3, 3, |i, j| (hessians[i] * g * hessians[j].transpose()).trace());
    Ok(largest_eigenvalue(&DMatrix::from_fn(3, 3, error), &form)?.sqrt())
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    let sorted = |values: &[f64], with: f64| {
        let mut values = [values, &[with]].concat();
        values.sort_by(f64::total_cmp);
        values.dedup();
        values
    };
    let (orders, angles) = (sorted(&options.s, 1.0), sorted(&options.angle, 60.0));
    let corners = |angle: f64| {
        let (x, y) = (0.5 * angle).to_radians().sin_cos();
        [[0.0, y], [-x, 0.0], [x, 0.0]]
    };
    for &s in &orders {
        // Trial functions: polynomials of degree p up to 30, and r^(2s) times trigonometric
        // functions of the angle about each corner. Largest quotients for p, p − 2, p − 4 settle
        // like p^−k: C is their limit, its error the change of that limit with p. The double
        // integrals by Gauss rules in polar coordinates about the corners, to 3e-8.
        let best = |&angle: &f64| {
            interpolation_constant(Triangle(corners(angle)), ErrorNorm::Derivative, s, 1e-3)
        };
        let best = angles.iter().map(best).collect::<std::result::Result<Vec<_>, _>>()?;
        let unit = if s < 1.0 { (FRAC_PI_2 / (1.0 - s)).sqrt() } else { 1.0 };
        let c_h = |k: usize| {
            let longest = (2.0 * (0.5 * angles[k]).to_radians().sin()).max(1.0);
            Measured::from(best[k].constant) * (unit / longest.powf(s))
        };
        let equilateral = angles.iter().position(|angle| *angle == 60.0).map(c_h);
        for (k, &angle) in angles.iter().enumerate() {
            let (c, c_l2) =
                (Measured::from(best[k].constant), best[k].in_norm(ErrorNorm::L2)?.constant);
            let quadratics = of_quadratics(corners(angle), s)?;
            let upper = (s == 1.0).then(|| kobayashi(corners(angle)));
            if let Some(upper) = upper {
                out.check("s = 1: C/Kobayashi's bound").at_most(c / upper, 1.0, "Kobayashi 2011");
            }
            let quotient = c.recip() * quadratics;
            let claim = out.check("max ‖∇(u − I u)‖₀/(C |∇u|_s), u quadratic");
            claim.at_most(quotient, 1.0, "best constant");
            if s == 1.0 && angle == 90.0 {
                out.check("s = 1, α = 90°: C").at_most(c, BABUSKA_AZIZ, "Babuška, Aziz 1976");
            }
            let ratio = c_h(k) / equilateral;
            if angle >= 135.0 {
                out.check("α ≥ 135°: C_h(α)/C_h(60°)").at_least(ratio, 2.0, "C grows as α → 180°");
            }
            if angle <= 20.0 && s <= 0.75 {
                let claim = out.check("α ≤ 20°, s ≤ 3/4: C_h(α)/C_h(60°)");
                claim.at_least(ratio, 1.0, "C grows as α → 0");
            }
            out.row(cells! { s, angle => c, quadratics, upper, c_h: c_h(k), c_l2 });
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
