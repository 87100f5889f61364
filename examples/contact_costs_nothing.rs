//! Contact costs nothing in the limit: the error beside that of interpolation, whatever the contact
//! set.
//!
//! Let u in H^τ, 3/2 < τ ≤ 2, solve Signorini's problem, u^h the discrete one in the nodal cone
//! (2.9), I^h interpolation at the nodes. By Falk's lemma, and because the sums over segments hold
//! only pairs of points nearer than h,
//!
//! ```text
//! |u − u^h|_a²  ≤  |u − I^h u|_a² + 2 ∫ σ_N I^h u_N,
//! ∫ σ_N I^h u_N = o(h^(2τ−2))   as h → 0.
//! ```
//!
//! Strip (example `section_2_strip`): g = u_N ≤ 0 and the pressure λ ≥ 0, g λ = 0, are given at the
//! N + 1 nodes of the edge of the unit square; A_N multiplies the wave cos kπx by sinh η coth Nη,
//! cosh η = 2 − cos(kπ/N). With P the interpolation from n to N cells, |u − v|_a² = gᵀA_N g − 2
//! (A_N g)ᵀPv + vᵀA_n v; u^h minimises ½ vᵀA_n v − (A_N g + λ)ᵀPv over v ≤ 0. N is 64 times the
//! finest n. `transitions:3`: gaps ((i + 1/4)/3, (i + 3/4)/3), i = 0, 1, 2, ends rounded to nodes;
//! in a gap (a, b) g = −δ^(τ−1), δ = (x − a)(b − x)/(b − a); else λ = r^(τ−2), r the distance to
//! the nearest gap, ∫ λ over a cell half to each node. `cantor`, `fat-cantor`: contact on Cantor
//! sets. Where τ is a supremum that is not reached, term and squared error have one order and the
//! limit of the quotient may differ from 1.
//!
//! Squares: for u in H², not affine, even the best approximation G without constraint, G = I^h u on
//! Γ_D, is reached: |u − u^h|_a/|u − G|_a → 1 in both cones, on any quasi-uniform mesh. For natural
//! ends of contact the quotient less one is O(h^(2/3) |ln h|) by proof, nodal cone. u in closed
//! form, prescribed off the contact edge y = 0: 2 u_x = −½ Im F − y Re F', 2 u_y = (3/2) Re F + y
//! Im F', λ = μ = 1, z = x + iy, F = (z − 3/10)^(3/2), 1 end, or ((z − 3/10)(7/10 − z))^(3/2), 2
//! ends; −Re (z − 2/5)^(3/2), scalar, its ∂u/∂n on the sides.
//!
//! Refuted if a squared error is above Falk's bound, if the quotient by interpolation for τ = 5/2
//! is above 1.001 or that by the best one at n = 64 above 1.01, if the excess there falls slower
//! than h^(2/3), or if (|u − u^h|² − |G − u^h|²)/|u − G|² is off 1 by 0.2 %, the cubature.
//!
//! `cargo run --release --example contact_costs_nothing -- --finest 17`

use example_report::prelude::*;
use signorini::cone::Cone;
use signorini::contact::Solver;
use signorini::edge::consistency_terms;
use signorini::fem::Lame;
use signorini::mesh::{Part, Triangulation};
use signorini::problems::{KnownSolution, StripData, TestProblem};
use signorini::strip::{Reference, StripKind, StripProblem};

example! { seconds "Theorem 3.1, the limit",
    "|u − u^h|_a² ≤ |u − I^h u|_a² + o(h^(2τ−2)) for u in H^τ, whatever the contact set";
    /// meshes of 16, 32, .. 2^finest cells along the edge
    finest: u32 = "14" in "[11, 18]",
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    out.column(
        "over_interpolation",
        "/interp.",
        "|u − u^h|_a/|u − I^h u|_a on the finest mesh, ±: its change over two halvings",
    );
    out.column("over_best", "/best", "|u − u^h|_a/|u − G|_a");
    out.column("order", "order", "of /best less one, from n = 32 to 64");
    let mut lines = Vec::new();
    for (name, tau) in [
        ("transitions:3", 1.55),
        ("transitions:3", 2.0),
        ("transitions:3", 2.5),
        ("cantor:0.3", 1.75),
        ("fat-cantor", 1.6),
    ] {
        let data = name.parse::<StripData>()?.data(
            tau,
            64 << options.finest,
            StripKind::Scalar.sides(),
        )?;
        let problem = StripProblem::new(StripKind::Scalar, &data, Reference::Nested, 16)?;
        // ∫ σ_N I^h u_N = −Σⱼ λⱼ (I^h g)ⱼ ≥ 0 for every n, λⱼ the forces at the nodes.
        let terms = consistency_terms(&data, Cone::Nodal);
        let mut points = Vec::new();
        // v minimises ½ vᵀA_n v − (A_N g + λ)ᵀPv over v ≤ 0: active set, conjugate gradients.
        for u in &problem.solutions(Cone::Nodal, 16, 1 << options.finest)? {
            let n = u.cells;
            let interpolant: Vec<f64> =
                data.values().iter().step_by(data.cells() / n).copied().collect();
            let error = Measured::from(problem.error(u)?);
            let interpolation = Measured::from(problem.distance(n, &interpolant)?);
            let term = terms.iter().find(|term| term.0 == n).map_or(0.0, |term| term.1);
            let ratio = error.squared() / (interpolation.squared() + 2.0 * term);
            let claim = out.check("|u−u^h|²/(|u−I^h u|² + 2∫σ_N I^h u_N)");
            claim.at_most(ratio, 1.0 + 2e-6, "Falk's lemma");
            points.push((1.0 / n as f64, (error / interpolation).value));
        }
        let quotient = limit(points.iter().map(|&(_, quotient)| quotient));
        out.row(cells! { problem: name, tau =>
            over_interpolation: quotient, over_best: None::<f64>, order: None::<f64>
        });
        if tau == 2.5 {
            out.check("strip, τ = 5/2: error/interpolation error")
                .at_most(quotient, 1.001, "limit 1");
        }
        lines.push((format!("{name}, τ = {tau}"), points));
    }
    let axes = Axes::LogLinear("h", "error over that of interpolation");
    let plot = out.plot("contact_costs_nothing", "What contact costs, nodal cone", axes);
    for (name, points) in lines {
        plot.line(&name, points);
    }
    on_triangles(out)
}

/// The mesh with all nodes off the corners moved by up to h/5, along the boundary there: no two
/// triangles alike.
fn shaken(mesh: Triangulation, n: usize) -> signorini::Result<Triangulation> {
    let chance =
        |x: f64, y: f64| 0.2 / n as f64 * ((12.9898 * x + 78.233 * y).sin() * 43758.5453).fract();
    let inner = |x: f64| x > 0.0 && x < 1.0;
    let moved = |t: f64, by: f64| if inner(t) { t + by } else { t };
    mesh.mapped(|[x, y]| [moved(x, chance(x, y)), moved(y, chance(y + 0.3, x))])
}

/// Solutions of the kind r^(3/2) in closed form on the square, n × n squares cut by a diagonal. G,
/// the best approximation without constraint, solves K G = F + ∫ σ_N φ with the exact σ_N (five
/// Gauss points a segment). Norms of u − v by cubature refined toward the ends of contact.
fn on_triangles(out: &mut Report) -> Result<()> {
    let lame = Lame::new(1.0, 1.0)?;
    for (name, known, shake) in [
        ("square: elastic, 1 end", KnownSolution::one_transition(Some(lame)), false),
        ("square: elastic, 2 ends", KnownSolution::two_transitions(Some(lame)), false),
        ("square: scalar, free sides", KnownSolution::three_halves(), false),
        ("the same, shaken mesh", KnownSolution::three_halves(), true),
    ] {
        for cone in [Cone::Nodal, Cone::Midpoint] {
            let (mut interpolated, mut best, mut excess) = (Vec::new(), Vec::new(), Vec::new());
            for n in [8, 16, 32, 64] {
                let make = || match shake {
                    true => {
                        TestProblem::Manufactured.on(shaken(TestProblem::Manufactured.mesh(n)?, n)?)
                    }
                    false => known.problem(n),
                };
                let (problem, mut free) = (make()?, make()?);
                let u = problem.solve(cone, Solver::ActiveSet)?.displacement;
                free.set_gap(|_| f64::from(1 << 30))?; // out of reach: no contact
                free.add_boundary_load(Part::Contact, &|[x, _], [nx, ny]| {
                    let stress = known.normal_stress(x);
                    Ok(if known.lame().is_some() {
                        [stress * nx, stress * ny]
                    } else {
                        [stress, 0.0]
                    })
                })?;
                let g = free.solve(Cone::Nodal, Solver::ActiveSet)?.displacement;
                let norm = |v: &[f64]| known.error_norms(&problem, v).map(|norms| norms.energy);
                let [error, least, interpolant] =
                    [norm(&u)?, norm(&g)?, norm(&known.interpolant(&problem)?)?];
                let apart: Vec<f64> = u.iter().zip(&g).map(|(u, g)| u - g).collect();
                let superclose = problem.energy_norm(&apart)? / least;
                // u − G is orthogonal to the whole space, hence |u − u^h|² = |u − G|² + |G − u^h|².
                let pythagoras = (error / least).powi(2) - superclose.powi(2);
                let claim = out.check("squares: (|u − u^h|² − |G − u^h|²)/|u − G|²");
                claim.near(pythagoras, 1.0, 2e-3, "Pythagoras");
                interpolated.push(error / interpolant);
                best.push(error / least);
                excess.push(0.5 * superclose.powi(2)); // of error/best over one
            }
            let order = exponent_between((1.0 / 32.0, excess[2]), (1.0 / 64.0, excess[3]));
            let problem =
                if cone == Cone::Nodal { name.to_owned() } else { format!("{name}, midpoint") };
            let quotient = limit(best);
            let over_interpolation = limit(interpolated);
            out.row(cells! { problem, tau: 2.5 => over_interpolation, over_best: quotient, order });
            out.check("n = 64: error/best possible error").at_most(quotient, 1.01, "limit 1");
            let claim = out.check("order in h of (error/best possible error − 1)");
            claim.at_least(order, 2.0 / 3.0, "h^(2/3)");
        }
    }
    Ok(())
}

/// The last of the quotients, and its change over two halvings.
fn limit(quotients: impl IntoIterator<Item = f64>) -> Measured {
    match quotients.into_iter().collect::<Vec<_>>()[..] {
        [.., a, b, c] => Measured::new(c, (c - b).abs().max((c - a).abs())),
        _ => Measured::NONE,
    }
}
