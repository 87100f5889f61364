//! Section 1: are there infinitely many transitions where a clamped part meets the contact edge?
//!
//! Without contact the solution near such a point oscillates like r^(1/2) sin(ε ln r + c), where r
//! is the distance from the point: the body would pass through the plane infinitely often. The
//! paper concludes that the real contact set might be complex there, and leaves the question open.
//!
//! The body is the half disc of radius 1 above y = 0, in plane strain with Poisson's ratio −1 < ν <
//! 1/2. It is clamped for x < 0 and may touch the plane without friction for x > 0. A constant
//! traction (cos α, sin α) acts on the arc. Put
//!
//! ```text
//! κ = 3 − 4ν,     ε = ln κ/(2π).
//! ```
//!
//! Theorem (page `section_1_clamped_end`): there is contact on (0, ℓ) for some ℓ > 0, whatever the
//! load. If the body is closed on (0, ℓ) and open beyond, then on the half-plane, and up to a
//! factor 1 + O(r) on the half disc,
//!
//! ```text
//! −σ_N = C r^(−1/2) sinh(2ε arccos √(r/ℓ)),      r < ℓ.
//! ```
//!
//! This file computes the contact set on a mesh whose rings reach down to r = 1e-20, for elastic
//! bodies and for a scalar one (−Δu = 0, u in the place of u_N, ∂u/∂n = −sin α on the arc), which
//! does not oscillate. The mesh has rings of n sectors with the radii e^(−kπ/n).
//!
//! Expected is contact at the end, and at most two transitions (contact, gap, contact) in all
//! decades. Refuted if an elastic body is open at the end over two or more periods π/ε of ln r
//! (over fewer, the mesh decides nothing); if it has more than two transitions, or the scalar body
//! has one; if a condition of contact, scaled by the values in its own decade of r, is violated by
//! more than 1e-10; if the active set finds another contact set when it starts from full contact;
//! if ln(−σ_N/formula), for 1e-4 ℓ ≤ 4r ≤ ℓ, differs from its mean over these r by more than π/n,
//! the width of a ring in ln r; or if without contact the number of sign changes of u_N differs by
//! more than one from the phase ε ln(1/r) over π.
//! Undecided while a bound lies inside of an error bar.
//!
//! `cargo run --release --example section_1_clamped_end -- --angles 12 --poisson 0.1`

use example_report::prelude::*;
use signorini::cone::{Cone, ContactSet};
use signorini::contact::{ContactProblem, ContactSolution, Settings, Solver, Start};
use signorini::edge::{RadialInterval, radial_intervals};
use signorini::mesh::Outline;
use signorini::problems::DirichletEnd;
use std::f64::consts::{LN_10, PI};

example! { seconds "Section 1, clamped end",
    "contact on (0, ℓ) beside the clamped part, whatever the load";
    /// Poisson's ratios ν
    poisson: Vec<f64> = "-0.5,0.25" in "(-1, 0.5)" slider "-0.5 to 0.4",
    /// directions α of the traction in degrees: 90 pulls, -90 presses, 180 shears
    alpha: Vec<f64> = "90,-90,180" in "[-360, 360]" slider "-180 to 180",
    /// number of sectors per ring, a multiple of 4
    angles: usize = "24" in "[4, 64]",
    /// rings are added until their radius is below this value
    smallest: f64 = "1e-20" in "[1e-120, 1e-6]",
}

/// Contact and gaps from the end outwards; a border lies at the geometric mean of the two nodes
/// beside it. Radii below ten times the innermost ring are left out: there the fan of triangles
/// that closes the mesh has an effect.
fn intervals(problem: &ContactProblem, solution: &ContactSolution) -> Result<Vec<RadialInterval>> {
    let (set, place) = (&solution.contact_set, &solution.positions);
    let first = place.partition_point(|&r| r < 10.0 * problem.edge().arc()[1]);
    let read = (first..set.constraints()).map(|i| set.contains(i)).collect::<Vec<_>>();
    Ok(radial_intervals(&place[first..], &ContactSet::new(&read))?)
}

/// In every decade of r (u_N)₊, (σ_N)₊, |u_N σ_N| and the residual of the equations are divided by
/// the largest displacement, force, product and force of that decade; the largest quotient is
/// returned.
fn worst_decade(
    problem: &ContactProblem,
    solution: &ContactSolution,
    smallest: f64,
) -> Result<f64> {
    let decades: Vec<f64> =
        (0..=-smallest.log10().floor() as i32).rev().map(|k| 10f64.powi(-k)).collect();
    let residuals = problem.kkt_by_radius(solution, [0.0; 2], &decades)?;
    Ok(residuals.iter().map(|decade| decade.worst()).fold(0.0, f64::max))
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    out.column("oscillates", "linear", "sign changes of u_N without contact");
    out.column("end", "end", "what reaches the clamped part");
    out.column("zone", "log ℓ", "log10 of where it ends");
    out.column("outer", "gap to", "log10 of where a gap behind it ends");
    let bodies = options.poisson.iter().map(|&nu| Some(nu)).chain([None]);
    let all = bodies.flat_map(|body| options.alpha.iter().map(move |&alpha| (body, alpha)));
    let loaded = |(body, alpha): &(Option<f64>, f64)| {
        body.is_some() || alpha.to_radians().sin().abs() > 1e-9
    };
    let mut drawn = Vec::new();
    for (poisson, alpha) in all.filter(loaded) {
        let epsilon = poisson.map(|nu| (3.0 - 4.0 * nu).ln() / (2.0 * PI));
        // Rings of n sectors, radii e^(−kπ/n), cells cut by the diagonal from the outer node nearer
        // to the vertical axis: on all rings linear elements have the same stiffness matrix, so the
        // innermost is as exact as the outermost.
        let (angles, step) = (options.angles, PI / options.angles as f64);
        let (outline, smallest, direction) = (Outline::HalfDisc, options.smallest, alpha);
        let mut problem =
            DirichletEnd { outline, angles, step, smallest, poisson, direction }.problem()?;
        let arc = problem.edge().arc().to_vec();
        // The pressure is the force of a node over half of the two segments beside it; scalar body:
        // ∂u/∂n = −sin α on the arc. Active set: guess which constraints are active, solve with
        // these as equations, correct by the signs, node by node without a tolerance; from no
        // contact, and from full contact.
        let nodal = problem.solve(Cone::Nodal, Solver::ActiveSet)?;
        let full = Start::Set(ContactSet::new(&vec![true; arc.len()]));
        let closed = problem.solve(Cone::Nodal, Settings { start: full, ..Settings::default() })?;
        let differ = (1..arc.len())
            .filter(|&i| nodal.contact_set.contains(i) != closed.contact_set.contains(i));
        out.check("nodes where contact sets differ").at_most(differ.count(), 0.0, "uniqueness");
        for solution in [&nodal, &closed] {
            let worst = worst_decade(&problem, solution, options.smallest)?;
            let claim = out.check("largest KKT residual, scaled by decade");
            claim.at_most(worst, 1e-10, "rounding errors");
        }
        let parts = intervals(&problem, &nodal)?;
        // The same body with the plane far away.
        problem.set_gap(|_| 1e6)?;
        let free = problem.solve(Cone::Nodal, Solver::ActiveSet)?.normal_displacement;
        let oscillates = (2..free.len()).filter(|&i| free[i] * free[i - 1] < 0.0).count();
        let name = poisson.map_or("scalar".to_owned(), |nu| nu.to_string());
        let end = if parts[0].in_contact { "contact" } else { "gap" };
        let border = |k: usize| parts.get(k).map(|part| part.from.log10());
        out.row(cells! { nu: name.clone(), alpha =>
            oscillates, end, zone: border(1), outer: border(2)
        });
        drawn.push((format!("{name}, {alpha}°"), parts.clone()));
        let Some(epsilon) = epsilon else {
            out.check("scalar body: transitions").at_most(parts.len() - 1, 0.0, "real exponents");
            continue;
        };
        // Undecided where no sign change at all would pass as well.
        let phase = -options.smallest.ln() * epsilon / PI;
        let off = oscillates as f64 - phase;
        let claim =
            out.check("without contact: sign changes − phase/π").undecided_if_also_true_of(-phase);
        claim.differ_by_at_most(off, 0.0, 1.0, "r^(1/2) sin(ε ln r)");
        let claim = out.check("elastic body: transitions");
        claim.at_most(parts.len() - 1, 2.0, "contact, gap, contact");
        // A gap at the end is no answer where it is shorter than two periods.
        let periods = parts[0].decades() * LN_10 * epsilon / PI;
        let open = match (parts[0].in_contact, periods < 2.0) {
            (true, _) => Measured::from(0.0),
            (false, true) => Measured::NONE,
            (false, false) => Measured::from(periods),
        };
        let claim = out.check("gap at the end, in periods π/ε of ln r");
        claim.whole_error_bars_at_most(open, 0.0, "contact on (0, ℓ)");
        if let [zone, _, ..] = parts.as_slice()
            && zone.in_contact
        {
            // For 1e-4 ℓ ≤ 4r ≤ ℓ: the largest difference of ln(pressure/formula) from its mean. A
            // decade above the smallest radius read is left out.
            let near =
                |r: f64| 1e-4 * zone.to <= 4.0 * r && 4.0 * r <= zone.to && r >= 10.0 * zone.from;
            let formula = |r: f64| (2.0 * epsilon * (r / zone.to).sqrt().acos()).sinh() / r.sqrt();
            let near = arc.iter().zip(&nodal.pressure).filter(|(r, _)| near(**r));
            let quotients: Vec<f64> = near.map(|(&r, p)| (p / formula(r)).ln()).collect();
            let mean = quotients.iter().sum::<f64>() / quotients.len() as f64;
            if let Some(off) = largest(quotients.iter().map(|q| (q - mean).abs())) {
                let claim = out.check("|ln(pressure/formula)|/ring width in ln r");
                claim.whole_error_bars_at_most(off / step, 1.0, "mesh size at ℓ");
            }
        }
    }
    out.proof("contact on (0, ℓ), no transition near the end", "section_1_clamped_end");
    plot(out, &drawn);
    Ok(())
}

/// One row per body and load: what every half decade is.
fn plot(out: &mut Report, drawn: &[(String, Vec<RadialInterval>)]) {
    let dots = |wanted: bool| {
        let row = |(k, (_, parts)): (usize, &(String, Vec<RadialInterval>))| {
            let places = (0..240).map(|j| -0.25 - 0.5 * f64::from(j));
            let is_wanted = |x: &f64| {
                let r = 10f64.powf(*x);
                parts.iter().any(|part| part.in_contact == wanted && part.from <= r && r <= part.to)
            };
            places.filter(is_wanted).map(|x| (x, -(k as f64))).collect::<Vec<_>>()
        };
        drawn.iter().enumerate().flat_map(row).collect()
    };
    let title = "Contact and gap near a clamped end, by Poisson's ratio and direction of the load";
    let axes = Axes::Linear("log10 of the distance from the end", "");
    let plot = out.plot("section_1_clamped_end", title, axes);
    plot.named_rows(drawn.iter().map(|(name, _)| name.clone()).collect());
    plot.given_points("contact", dots(true)).given_points("gap", dots(false));
}
