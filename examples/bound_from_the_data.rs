//! A bound from the data alone: the error of Signorini's problem below C h ‖f‖, C a number.
//!
//! −Δu = f on the unit square, u = 0 on three sides, u ≤ 0, ∂u/∂n ≤ 0, u ∂u/∂n = 0 on the bottom; u^h by linear elements on
//! n × n squares cut from lower left to upper right, h = 1/n, u^h ≤ 0 at the nodes of the bottom. For every f in L² and
//! every contact set
//!
//! ```text
//! ‖∇(u − u^h)‖ ≤ C h ‖f‖,     C² = A² + (4π/27) coth π,   A = 0.4929..: 1/A + tan(1/A) = 0,   C = 0.843
//! ```
//!
//! (i) |u|₂² = Σ ‖∂ᵢ∂ⱼ u‖² ≤ ‖f‖². (ii) Falk: ‖∇(u − u^h)‖² ≤ ‖∇(u − I u)‖² + 2 ∫ σ_N I u; the first is at most A² h²
//! |u|₂². (iii) On a segment (0, 1), where σ_N(x) ≠ 0 and so u(x) = 0, I u(x) = x ∫ u' over (x, 1) − (1 − x) ∫ u' over (0,
//! x). As σ_N u' = 0, only pairs with σ_N(y) = u'(x) = 0 count, half of those in the seminorms: ∫ σ_N I u ≤ ½ max x² (1 −
//! x) h² |σ_N|_½ |u'|_½, which is (2/27) h² |σ_N|_½ |u'|_½. (iv) |w|²_½ ≤ 2π coth π ‖∇w‖² for w = u_x, u_y on the square of
//! side h above the segment, and ‖∇u_x‖ ‖∇u_y‖ ≤ ½ |u|₂². Proofs: page `bound_from_the_data`.
//!
//! Here f = 6 (1 − 2x), ‖f‖ = √12: one load, one contact set. A failure refutes the theorem, a pass is one instance, and as
//! error < A h ‖f‖ already it says nothing of (iii). u is replaced by the solution on N = 512 squares, and its error, of order
//! h, by the share n/N of the distance: the ± of an error. |u|₂ is taken from second differences of u^h over h², without the
//! nodes on the boundary: too small by O(h). Rows: n = 8, 16, .. N/4. Refuted if an error with its ± is above C h ‖f‖, if
//! |u|₂ at n = N exceeds ‖f‖ or is 2 % below it (equal for continuous ∇u), or if the order between the last two rows is off
//! the optimal one, 1, by 0.1; (3.2) has h |ln h|^(1/2).
// `at_most(x, b)` holds if x + its ± ≤ b, `at_least(x, b)` if x − its ± ≥ b, `near(x, b, t)` if |x − b| + its ± ≤ t;
// otherwise it fails, or is undecided within ±. Of several calls the worst counts.
use example_report::prelude::*;
use signorini::cone::Cone;
use signorini::contact::{ContactProblem, Solver};
use signorini::fem::{Field, Form};
use signorini::mesh::{Hierarchy, Part, SideParts, Triangulation, unit_square};
use std::f64::consts::PI;

example! { seconds "A bound from the data", "‖∇(u − u^h)‖ ≤ C h ‖f‖, C = 0.843, for every f and every contact set";
    /// number of refinements; the reference mesh has N = 8 · 2^meshes squares per side
    meshes: usize = "6" in "[6, 8]",
}

/// −Δu = 6 (1 − 2x): ∫ f φᵢ by the mass matrix and the nodal values of f, which is affine. Stiffness: ∫ ∇φᵢ·∇φⱼ.
fn problem(mesh: Triangulation) -> Result<ContactProblem> {
    let load = Field::Scalar(&|[x, _]| 6.0 * (1.0 - 2.0 * x)).sample(mesh.nodes())?;
    Ok(ContactProblem::new(mesh, Form::LAPLACE, &load)?)
}

/// |u|₂ by differences: u_xx, u_yy at inner nodes from three values each, u_xy at middles of squares from four.
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
    out.column("error", "error", "‖∇(u − u^h)‖, u on the reference mesh");
    out.column("seminorm", "|u|₂", "from differences of u^h");
    out.column("bound", "C h ‖f‖", "the theorem");
    out.column("interpolation", "A h ‖f‖/error", "what is lost without contact");
    out.column("over_error", "bound/error", "what all steps lose together");
    let mut t = 2.0_f64; // t = 1/A by Newton's method: t cos t + sin t = 0
    for _ in 0..20 {
        t -= (t * t.cos() + t.sin()) / (2.0 * t.cos() - t * t.sin());
    }
    let interpolation = 1.0 / t;
    let (constant, f) = ((interpolation.powi(2) + 4.0 / 27.0 * PI / PI.tanh()).sqrt(), 12f64.sqrt());
    out.note("C", constant);
    let bottom_is_contact = SideParts {
        bottom: Part::Contact,
        right: Part::Dirichlet,
        top: Part::Dirichlet,
        left: Part::Dirichlet,
    };
    let levels = options.meshes;
    let hierarchy = Hierarchy::refined(unit_square(8, bottom_is_contact)?, levels)?;
    let mut solved = Vec::new();
    for mesh in hierarchy.levels() {
        let problem = problem(mesh.clone())?;
        // Guess the nodes with u = 0 on the bottom, solve, correct by the signs of u and of the force, until nothing changes.
        let u = problem.solve(Cone::Nodal, Solver::ActiveSet)?.displacement; // exact to rounding
        solved.push((problem, u));
    }
    let Some((fine, exact)) = solved.last() else { return Ok(()) };
    for (k, (problem, u)) in solved[..levels - 1].iter().enumerate() {
        let n = 8usize << k;
        let h = 1.0 / n as f64;
        // ‖∇(I u^h − u_N)‖ by the stiffness matrix of the reference mesh, which contains every node of this one.
        let distance = fine.nested_energy_error(&hierarchy, (k, u), (levels, exact))?;
        let error = Measured::new(distance, distance * n as f64 / (8usize << levels) as f64);
        let (bound, seminorm) = (constant * h * f, second_seminorm(problem.mesh(), u, n));
        let over_error = (error.recip() * bound).value;
        out.row(cells! { h => seminorm, error, bound, interpolation: (error.recip() * (interpolation * h * f)).value, over_error });
        out.check("error/(C h ‖f‖)").at_most(error / bound, 1.0, "proved");
    }
    let finest = second_seminorm(fine.mesh(), exact, 8 << levels) / f;
    out.note("seminorm_over_f", finest);
    out.check("|u|₂/‖f‖ on the reference mesh").at_most(finest, 1.0, "|u|₂ ≤ ‖f‖");
    out.check("lower bound of |u|₂/‖f‖").at_least(finest, 0.98, "equality for continuous ∇u");
    let order = out.exponent("h", "error"); // between the last two rows, without a ±: both errors lack the same part
    out.check("order of ‖∇(u − u^h)‖").near(order, 1.0, 0.1, "h^(τ−1), τ = 2");
    out.plot("bound_from_the_data", "Error and bound", Axes::LogLog("h", "‖∇(u − u^h)‖"))
        .curve("h", "error")
        .dashed("h", "bound");
    Ok(())
}
