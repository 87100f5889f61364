//! A bound from the data alone: the error of Signorini's problem is below C h ‖f‖, and C is a
//! number.
//!
//! The C of the paper's theorems is unknown. Here it is computed for two problems on the unit
//! square, for every f in L² and whatever the contact set.
//!
//! ```text
//! membrane    −Δu = f,      u = 0 on three sides, contact on the bottom;   |v|²_a = ‖∇v‖²
//! Remark 1    −Δu + u = f,  contact on all four sides;                     |v|²_a = ‖∇v‖² + ‖v‖²
//! contact     u ≤ 0,   σ_N = ∂u/∂n ≤ 0,   u ∂u/∂n = 0
//! ```
//!
//! u^h is linear on n × n squares, h = 1/n, each cut from lower left to upper right, with u^h ≤ 0
//! at the nodes of the contact sides. The theorem:
//!
//! ```text
//! membrane    |u − u^h|_a ≤ C h ‖f‖,     C² = A² + (4π/27) coth π,              C = 0.843;
//! Remark 1    |u − u^h|_a ≤ C h ‖f‖,     C² = A² + (8π/27) coth π + (A₀ h)²;
//! A = 0.4929.. is the largest number with 1/A + tan(1/A) = 0.
//! ```
//!
//! Its proof has four steps (page `bound_from_the_data`). I is linear interpolation at the nodes.
//!
//! 1. |u|₂ ≤ ‖f‖, where |u|₂² is the sum of the ‖∂ᵢ∂ⱼu‖².
//! 2. Falk's lemma: |u − u^h|²_a ≤ |u − I u|²_a + 2 ∫ σ_N I u. On these triangles ‖∇(u − I u)‖ ≤
//!    A h |u|₂ and ‖u − I u‖ ≤ A₀ h² |u|₂.
//! 3. On a segment, taken as (0, 1), σ_N(x) ≠ 0 only where u(x) = 0, and there I u(x) is x times
//!    the integral of u' over (x, 1) less 1 − x times that over (0, x). As σ_N u' = 0, only pairs
//!    of points with σ_N(y) = u'(x) = 0 count, and these are half of the pairs in the seminorms, so
//!    that ∫ σ_N I u ≤ ½ max x² (1 − x) h² |σ_N|_½ |u'|_½ = (2/27) h² |σ_N|_½ |u'|_½.
//! 4. |w|²_½ ≤ 2π coth π ‖∇w‖² for w = u_x and w = u_y on the square of side h above the segment,
//!    and ‖∇u_x‖ ‖∇u_y‖ ≤ ½ |u|₂² there. At a corner of Remark 1 two squares overlap, which
//!    doubles the term.
//!
//! This file tests one load, f = 6 (1 − 2x) with ‖f‖ = √12. u is unknown, so the solution u_N on N
//! = 512 squares per side takes its place. The column `error` is |u_N − u^h|_a; since the error is
//! of the order h, that of u_N is about n/N of it, and this share of the column is the ± of
//! `error`. |u|₂ is the root of the sum of squared second differences of u^h over h², without the
//! nodes on the boundary, and is too small by a number of the order h. The rows have n = 8, 16, ..
//! N/4.
//!
//! Refuted if error − ± is above C h ‖f‖, and undecided if only error + ± is; if |u|₂ on N squares
//! exceeds ‖f‖; if for the membrane, where |u|₂ = ‖f‖ for continuous ∇u, it is 2 % below ‖f‖;
//! or if the order of the error in h differs by more than 0.1 from 1, which is the best possible
//! ((3.2) has h |ln h|^(1/2)). The order is that of the increments of error² on the last three
//! meshes,
//!
//! ```text
//! ½ log₂ ((e(4h)² − e(2h)²) / (e(2h)² − e(h)²)),
//! ```
//!
//! because all squares lack the same number, the square of the error of u_N (up to 2 a(u − u_N, u_N
//! − u^h), which is zero where u and u_N have the same contact set, and far below the increments
//! elsewhere). A pass is one instance of the theorem; as the error is below A h ‖f‖ already, it
//! says nothing of the third step.
//!
//! Finer meshes:
//!
//! `cargo run --release --example bound_from_the_data -- --meshes 7`

use example_report::prelude::*;
use fractional_sobolev::{Domain, ErrorNorm, interpolation_constant};
use signorini::cone::Cone;
use signorini::contact::{ContactProblem, Solver};
use signorini::fem::{Field, Form};
use signorini::mesh::{Hierarchy, Part, SideParts, Triangulation, unit_square};
use std::f64::consts::PI;

example! { seconds "A bound from the data",
    "|u − u^h|_a ≤ C h ‖f‖, C a number, for every f and every contact set";
    /// number of refinements; the reference mesh has N = 8 · 2^meshes squares per side
    meshes: usize = "6" in "[6, 8]",
}

/// f = 6 (1 − 2x): ∫ f φᵢ by the mass matrix and the nodal values of f, which is affine. Matrix: ∫
/// ∇φᵢ·∇φⱼ + reaction φᵢ φⱼ.
fn problem(mesh: Triangulation, reaction: f64) -> Result<ContactProblem> {
    let load = Field::Scalar(&|[x, _]| 6.0 * (1.0 - 2.0 * x)).sample(mesh.nodes())?;
    Ok(ContactProblem::new(mesh, Form::Scalar { reaction }, &load)?)
}

/// |u|₂ by differences: u_xx, u_yy at inner nodes from three values each, u_xy at middles of
/// squares from four.
pub(crate) fn second_seminorm(mesh: &Triangulation, u: &[f64], n: usize) -> f64 {
    let mut grid = vec![0.0; (n + 1) * (n + 1)]; // refinement has its own order of nodes
    let number = |t: f64| (t * n as f64).round() as usize;
    mesh.nodes().iter().zip(u).for_each(|([x, y], u)| grid[number(*y) * (n + 1) + number(*x)] = *u);
    let at = |i: usize, j: usize| grid[j * (n + 1) + i];
    let mut sum = 0.0;
    for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
        sum += 2.0 * (at(i + 1, j + 1) - at(i, j + 1) - at(i + 1, j) + at(i, j)).powi(2);
        if i > 0 && j > 0 {
            sum += (at(i + 1, j) - 2.0 * at(i, j) + at(i - 1, j)).powi(2);
            sum += (at(i, j + 1) - 2.0 * at(i, j) + at(i, j - 1)).powi(2);
        }
    }
    sum.sqrt() * n as f64 // squares of differences over h⁴, times h²
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    out.column("error", "error", "|u − u^h|_a, u on the reference mesh");
    out.column("seminorm", "|u|₂", "from differences of u^h");
    out.column("bound", "C h ‖f‖", "the theorem");
    out.column("interpolation", "A h ‖f‖/error", "what is lost without contact");
    out.column("over_error", "bound/error", "what all steps lose together");
    let mut t = 2.0_f64; // t = 1/A by Newton's method: t cos t + sin t = 0
    for _ in 0..20 {
        t -= (t * t.cos() + t.sin()) / (2.0 * t.cos() - t * t.sin());
    }
    let interpolation = 1.0 / t;
    let (trace, f) = (4.0 / 27.0 * PI / PI.tanh(), 12f64.sqrt());
    out.note("C", (interpolation.powi(2) + trace).sqrt());
    // A₀, an upper bound: v − I v has the values 0 at the corners of the triangle. With the
    // triangle cut into 20² similar ones let w be linear on each of them with the means of v over
    // its edges. Then ‖v − w‖ is bounded by Payne and Weinberger's inequality, and ‖w‖ by the
    // largest eigenvalue of its square against a sum of squared differences of ∇w that is at most
    // |v|₂². At h = 1/8 A₀ is a share of 0.001 of C at most, so that three digits of C do not need
    // it.
    let triangle = Domain::Triangle([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]);
    let found = interpolation_constant(triangle, ErrorNorm::L2, 1.0, 1e-3)?;
    let in_l2 = found.upper.map_or(f64::NAN, |upper| upper.value);
    for (name, others, reaction) in
        [("membrane", Part::Dirichlet, 0.0), ("Remark 1", Part::Contact, 1.0)]
    {
        let sides = SideParts { bottom: Part::Contact, right: others, top: others, left: others };
        let levels = options.meshes;
        let hierarchy = Hierarchy::refined(unit_square(8, sides)?, levels)?;
        let mut solved = Vec::new();
        for mesh in hierarchy.levels() {
            let problem = problem(mesh.clone(), reaction)?;
            // Active set: guess the nodes with u = 0, solve, correct the guess by the signs of u
            // and of the forces, until nothing changes. Exact to rounding.
            let u = problem.solve(Cone::Nodal, Solver::ActiveSet)?.displacement;
            solved.push((problem, u));
        }
        let Some((fine, exact)) = solved.last() else { return Ok(()) };
        for (k, (problem, u)) in solved[..levels - 1].iter().enumerate() {
            let n = 8usize << k;
            let h = 1.0 / n as f64;
            // C² of the theorem
            let square = interpolation.powi(2) + trace + reaction * ((in_l2 * h).powi(2) + trace);
            // |I u^h − u_N|_a by the matrix of the reference mesh, which contains every node of
            // this one.
            let distance = fine.nested_energy_error(&hierarchy, (k, u), (levels, exact))?;
            let error = Measured::new(distance, distance * n as f64 / (8usize << levels) as f64);
            let (bound, seminorm) = (square.sqrt() * h * f, second_seminorm(problem.mesh(), u, n));
            let [over_error, lost] =
                [bound, interpolation * h * f].map(|x| (error.recip() * x).value);
            out.row(cells! { problem: name, h =>
                seminorm, error, bound, interpolation: lost, over_error
            });
            out.check("error/(C h ‖f‖)").whole_error_bars_at_most(error / bound, 1.0, "proved");
        }
        let finest = second_seminorm(fine.mesh(), exact, 8 << levels) / f;
        out.check("|u|₂/‖f‖ on the reference mesh").at_most(finest, 1.0, "|u|₂ ≤ ‖f‖");
        if reaction == 0.0 {
            out.note("seminorm_over_f", finest);
            out.check("membrane: |u|₂/‖f‖").at_least(finest, 0.98, "equality for continuous ∇u");
        }
        // Squares on the last three meshes: by Pythagoras all lack the same, the square on the
        // reference mesh, and increments do not.
        let squares: Vec<f64> = out.series("h", "error").iter().map(|(_, e)| e * e).collect();
        let [.., a, b, c] = squares[..] else { continue };
        let order = 0.5 * order_of_increments([a, b, c]);
        let claim = out.check("order of |u − u^h|_a");
        claim.differ_by_at_most(order, 1.0, 0.1, "optimal for linear elements");
    }
    out.plot("bound_from_the_data", "Error and bound", Axes::LogLog("h", "|u − u^h|_a"))
        .curve_by("problem", "h", "error")
        .dashed_by("problem", "h", "bound");
    Ok(())
}
