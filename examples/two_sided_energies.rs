//! Two-sided energies: the error of a body in contact, guaranteed.
//!
//! An elastic square Ω = (0, 1)², λ = μ = 1, is clamped on its top edge Γ_D and free on both sides.
//! It lies with its bottom edge Γ_C on a rigid floor, without friction, under the load f = (0, −cos
//! πx). With σ(v) = λ tr ε(v) I + 2μ ε(v), 𝒜⁻¹ the inverse of ε ↦ σ, and |||v|||² = ∫ σ(v) : ε(v),
//! the displacement u minimises
//!
//! ```text
//! J(v) = ½ |||v|||² − ∫ f·v                 over v = 0 on Γ_D, v_N ≤ 0 on Γ_C,
//! ```
//!
//! and the stress σ(u) maximises
//!
//! ```text
//! J*(q) = −½ ∫ q : 𝒜⁻¹q     over q symmetric, div q + f = 0, q n = 0 on the sides,
//!                           q_T = 0 and q_N ≤ 0 on Γ_C,
//! ```
//!
//! with the same value (Prager and Synge 1947, Hlaváček 1977). Every such v and q therefore enclose
//! it,
//!
//! ```text
//! J*(q) ≤ J(u) ≤ J(v),
//! |||u − v|||² ≤ ∫ (σ(v) − q) : 𝒜⁻¹(σ(v) − q) + 2∫ q_N v_N = 2 (J(v) − J*(q)).
//! ```
//!
//! Here v = u^h is the linear finite element solution on n × n squares, each cut from bottom left
//! to top right, and q the best stress of the form
//!
//! ```text
//! q = diag(0, y cos πx) + (φ_yy, φ_xx, −φ_xy),
//! ```
//!
//! φ in the reduced Hsieh-Clough-Tocher space on the same triangles: C¹, cubic on each third of a
//! triangle, ∂φ/∂n linear along edges, so that q_N = φ_ss is linear and q_T constant on an edge.
//! The first term carries the load: ∂_y (y cos πx) = −f_y; its traction is zero on the bottom and
//! on the sides. So the conditions on q are conditions on φ alone:
//!
//! ```text
//! sides x = 0, 1:   φ_yy = φ_xy = 0      φ is affine and φ_x constant along each side
//! bottom Γ_C:       φ_xy = 0             φ_y is constant along the edge
//!                   φ_xx ≤ 0             at both ends of every segment, which is enough
//! top Γ_D:          none
//! ```
//!
//! φ = 0 satisfies them and gives by hand J*(q) = −½ · 3/8 · ∫ y² cos² πx = −1/32; the best φ has a
//! larger J*. It is computed as six stresses on each triangle, with multipliers on the edges for
//! equal tractions of neighbours: the same minimum. J has the load ∫ f·v by 4 × 4 points a
//! triangle.
//!
//! The paper bounds ‖u − u^h‖ by C h^p with an unknown C (Theorem 3.1); here every mesh has a
//! number. The columns are J*(q) (`dual_energy`), J(v) (`energy.upper`), and
//!
//! ```text
//! A² = Σ_triangles ∫ (σ(v) − q) : 𝒜⁻¹(σ(v) − q),   b = Σ_segments ∫ q_N v_N,
//! bound = ½ (A + (A² + 4b)^(1/2)),   bound² ≤ A² + 2b = 2 (J(v) − J*(q))     (`shares`: A² + 2b)
//! ```
//!
//! by quadrature: sums of terms ≥ 0, not a difference of energies; what rounding may have changed
//! is added to J(v) and to the bound. In the nodal cone v = u^h. In the midpoint cone u^h_N > 0
//! occurs; then v is u^h less a correction that ends this, and the bound of |||u − u^h||| has its
//! norm beside.
//!
//! The error is measured as the distance |||u' − u^h||| to the solution u' on squares 8 times finer
//! than the finest row; it uses no stress q. As u^h is admissible on that mesh (nodal cone), |||u'
//! − u^h|||² ≤ 2 (J(u^h) − J(u')) ≤ 2 (J(u^h) − J*(q)): u' may stand for u without an error of its
//! own. In the midpoint cone this argument is missing, and the check neglects the error of u',
//! about 1/8 of that of the finest row. No compared number has an error bar: the effect of rounding
//! is in J(v) and in the bound, on the safe side. The claim is refuted if on a uniform mesh the
//! bound is below that distance, or J* above the J of the same mesh or below −1/32, if in the nodal
//! cone A² + 2b differs from 2 (J − J*) by 1e-6 of it (the rule for cos πx), or if on adaptive
//! meshes the bound does not fall like N^(−1/2) in the number N of unknowns: order −0.5 ± 0.03 from
//! the first mesh with 2 % of the largest N, which has left the coarse meshes behind, to the last.
//! The adaptive meshes are checked for this order only.
//!
//! `cargo run --release --example two_sided_energies -- --levels 6 --out out`

use example_report::prelude::*;
use signorini::bounds::{Enclosure, Traction};
use signorini::cone::Cone;
use signorini::contact::{Body, Solver};
use signorini::fem::{Form, Lame};
use signorini::mesh::{Hierarchy, SideParts, Triangulation, unit_square};
use std::f64::consts::PI;

example! { seconds "Two-sided energies",
    "J*(q) ≤ J(u) ≤ J(u^h), and |||u − u^h|||² ≤ 2 (J(u^h) − J*(q)): the error is guaranteed";
    /// number of meshes with n = 4, 8, 16, .. squares along each side
    levels: usize = "4" in "[2, 6]",
    /// discrete cone: nodal (2.9) or midpoint (4.1)
    cone: Cone = "nodal",
    /// largest number of unknowns of the adaptive meshes
    unknowns: usize = "20000" in "[1000, 1000000]",
}

/// J*(q) of q = diag(0, y cos πx): ∫ y² cos² πx = 1/6, and q : 𝒜⁻¹q = 3/8 q_yy² for λ = μ = 1.
const BY_HAND: f64 = -0.5 * 3.0 / 8.0 / 6.0;

fn block(mesh: Triangulation) -> signorini::Result<Body<'static>> {
    let body = Body::new(mesh, Form::elastic(Lame::new(1.0, 1.0)?));
    Ok(body.load(|[x, _]: [f64; 2]| [0.0, -(PI * x).cos()]))
}

/// An adaptive mesh: the number of unknowns N, and the bound of the error.
struct OnMesh {
    unknowns: f64,
    bound: f64,
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    out.column("unknowns", "unknowns", "of u^h; the stress has about four times as many");
    out.column("lower", "J*(q)", "energy from below");
    out.column("upper", "J(v)", "energy from above; v = u^h in the nodal cone");
    out.column("error", "error", "|||u' − u^h|||, u' on the finest mesh");
    out.column("ratio", "bound/error", "effectivity: 1 would be the error itself");
    // Squares cut into four similar triangles each: the spaces are nested.
    let mut meshes = Hierarchy::refined(unit_square(4, SideParts::HANGING)?, options.levels - 1)?;
    let uniform: Vec<Enclosure> = meshes
        .levels()
        .iter()
        // Both problems by elimination to the contact edge and an active set there; exact to
        // rounding. q: stresses on triangles, multipliers on edges for equal tractions.
        .map(|mesh| block(mesh.clone())?.enclose_with(options.cone, Traction::Reduced))
        .collect::<signorini::Result<_>>()?;
    (0..3).try_for_each(|_| meshes.refine())?;
    let finest = meshes.levels().len() - 1;
    let fine = block(meshes.finest().clone())?.problem()?;
    let exact = fine.solve(options.cone, Solver::ActiveSet)?.displacement;
    for (level, found) in uniform.iter().enumerate() {
        let error = fine.nested_energy_error(
            &meshes,
            (level, &found.solution.displacement),
            (finest, &exact),
        )?;
        let (lower, upper) = (found.dual_energy, found.energy.upper);
        let unknowns = found.problem.free_unknowns();
        out.row(cells! { unknowns => lower, upper, error, bound: found.error,
        ratio: found.error / error });
        out.check("error/bound").at_most(error / found.error, 1.0, "constant one");
        out.check("J*(q)/J(v)").at_least(lower / upper, 1.0, "both negative");
        out.check("J*(q) by hand/J*(q)").at_least(BY_HAND / lower, 1.0, "best stress");
        if options.cone == Cone::Nodal {
            // The sum over triangles and segments, each term ≥ 0, against the difference of the
            // energies.
            let sum: f64 = found.shares.iter().sum();
            let difference = 2.0 * (upper - lower);
            let claim = out.check("sum of the parts/2(J − J*)");
            claim.differ_by_at_most(sum / difference, 1.0, 1e-6, "identity");
        }
    }
    // Solve, estimate, mark, refine.
    let mut adaptive: Vec<OnMesh> = Vec::new();
    let mut meshes = Hierarchy::new(unit_square(4, SideParts::HANGING)?);
    loop {
        let body = block(meshes.finest().clone())?;
        let found = body.enclose_with(options.cone, Traction::Reduced)?;
        let unknowns = found.problem.free_unknowns() as f64;
        adaptive.push(OnMesh { unknowns, bound: found.error });
        if found.problem.free_unknowns() >= options.unknowns {
            break;
        }
        // The fewest triangles that have half of A² + 2b; they are bisected twice, at
        // their longest edges, and neighbours so that no node hangs.
        let shares = &found.shares;
        let mut order: Vec<usize> = (0..shares.len()).collect();
        order.sort_by(|&s, &t| shares[t].total_cmp(&shares[s]));
        let (mut marked, mut rest) = (vec![false; shares.len()], 0.5 * shares.iter().sum::<f64>());
        for t in order {
            marked[t] = rest > 0.0;
            rest -= shares[t];
        }
        meshes.refine_where(|_, t| marked[t])?;
    }
    let least = 0.02 * options.unknowns as f64;
    let first = adaptive.partition_point(|mesh| mesh.unknowns < least);
    if let [first, .., last] = &adaptive[first..] {
        let order = (last.bound / first.bound).ln() / (last.unknowns / first.unknowns).ln();
        out.note("adaptive-order", order);
        let claim = out.check("adaptive meshes: order of the bound in N");
        claim.differ_by_at_most(order, -0.5, 0.03, "N^(−1/2)");
    }
    let counts = |found: &Enclosure| found.problem.free_unknowns() as f64;
    let plot = out.plot(
        "two_sided_energies",
        "Two energies close on J(u)",
        Axes::LogLinear("unknowns", "energy"),
    );
    plot.line(
        "J(v), from above",
        uniform.iter().map(|found| (counts(found), found.energy.upper)).collect(),
    );
    plot.line(
        "J*(q), from below",
        uniform.iter().map(|found| (counts(found), found.dual_energy)).collect(),
    );
    let plot = out.plot(
        "two_sided_bound",
        "Guaranteed error",
        Axes::LogLog("unknowns", "bound of |||u − u^h|||"),
    );
    plot.line("uniform meshes", uniform.iter().map(|found| (counts(found), found.error)).collect());
    let points = adaptive.iter().map(|mesh| (mesh.unknowns, mesh.bound)).collect();
    plot.line("adaptive meshes", points);
    Ok(())
}
