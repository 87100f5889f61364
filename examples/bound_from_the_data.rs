//! A bound from the data alone: the error of Signorini's problem below C h ‖f‖, C a number.
//!
//! The paper's C is unknown. Here it is computed, for two problems. `membrane`: −Δu = f on the unit
//! square, u = 0 on three sides, contact on the bottom, that is u ≤ 0, ∂u/∂n ≤ 0, u ∂u/∂n = 0.
//! Remark 1: −Δu + u = f, contact on all sides. u^h is linear on n × n squares cut from lower left
//! to upper right, h = 1/n, with u^h ≤ 0 at the nodes of the contact sides. For every f in L² and
//! every contact set
//!
//! ```text
//! |u − u^h|_a ≤ C h ‖f‖,        C² = A² + (4π/27) coth π,        C = 0.843,
//! A = 0.4929..: 1/A + tan(1/A) = 0,
//! ```
//!
//! with |v|_a = ‖∇v‖ for the membrane; in Remark 1 |v|²_a = ‖∇v‖² + ‖v‖² and C² = A² + A₀²
//! h² + (8π/27) coth π, ‖v − I v‖ ≤ A₀ h² |v|₂ for linear interpolation I.
//!
//! (i) |u|₂² = Σ ‖∂ᵢ∂ⱼ u‖² ≤ ‖f‖². (ii) Falk: |u − u^h|²_a ≤ |u − I u|²_a + 2 ∫ σ_N I u; ‖∇(u − I
//! u)‖² ≤ A² h² |u|₂². (iii) On a segment (0, 1), where σ_N(x) ≠ 0 and so u(x) = 0, I u(x) = x ∫ u'
//! over (x, 1) − (1 − x) ∫ u' over (0, x). As σ_N u' = 0, only pairs with σ_N(y) = u'(x) = 0 count,
//! half of those in the seminorms: ∫ σ_N I u ≤ ½ max x² (1 − x) h² |σ_N|_½ |u'|_½, which is (2/27)
//! h² |σ_N|_½ |u'|_½. (iv) |w|²_½ ≤ 2π coth π ‖∇w‖² for w = u_x, u_y on the square of side h above
//! the segment, and ‖∇u_x‖ ‖∇u_y‖ ≤ ½ |u|₂²; at a corner of Remark 1 two squares overlap. Proofs:
//! page `bound_from_the_data`.
//!
//! Here f = 6 (1 − 2x), ‖f‖ = √12: one load, one contact set. A failure refutes the theorem, a pass
//! is one instance, and as error < A h ‖f‖ already it says nothing of (iii). u is replaced by the
//! solution on N = 512 squares, and its error, of order h, by the share n/N of the distance: the ±
//! of an error. |u|₂ is taken from second differences of u^h over h², without the nodes on the
//! boundary: too small by O(h). Rows: n = 8, 16, .. N/4. Refuted if an error with its ± is above C
//! h ‖f‖, if |u|₂ at n = N exceeds ‖f‖ or, membrane, is 2 % below it (equal for continuous ∇u), or
//! if the order between the last two rows is off the optimal one, 1, by 0.1; (3.2) has h |ln
//! h|^(1/2).
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
    // A₀: an upper bound by eigenvalues, for the triangle cut into 20² similar ones; proved but for
    // rounding.
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
            // Guess the nodes with u = 0, solve, correct by the signs of u and of the force, until
            // nothing changes.
            // exact to rounding
            let u = problem.solve(Cone::Nodal, Solver::ActiveSet)?.displacement;
            solved.push((problem, u));
        }
        let Some((fine, exact)) = solved.last() else { return Ok(()) };
        for (k, (problem, u)) in solved[..levels - 1].iter().enumerate() {
            let n = 8usize << k;
            let h = 1.0 / n as f64;
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
            out.check("error/(C h ‖f‖)").at_most(error / bound, 1.0, "proved");
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
        out.check("order of |u − u^h|_a").near(order, 1.0, 0.1, "optimal for linear elements");
    }
    out.plot("bound_from_the_data", "Error and bound", Axes::LogLog("h", "|u − u^h|_a"))
        .curve_by("problem", "h", "error")
        .dashed_by("problem", "h", "bound");
    Ok(())
}
