//! A solution of the library beside the one of all contact sets.

use super::program::{Answer, Program, value};
use super::scene::Scene;
use qd::Quad as Double;
use signorini::contact::{ContactSolution, Solver};

/// Roundings of the library for one of the data: elimination, two solves, the active set.
const ROUNDINGS: f64 = 16.0;

/// Above this share ROUNDINGS · ε · cond(K) says nothing about the displacement any more: only the conditions
/// of a solution are looked at.
const LINEAR: f64 = 0.1;

/// A solution that calls itself converged meets the conditions so well (as documented).
const ACCEPTED: f64 = 1e-8;

/// The scales of forces here and there may differ by this.
const SCALES: f64 = 4.0;

/// Asked of the interior point and the cycles in the energy norm, relative, beside what balance they say they
/// left (complementarity as accepted would allow 1e-4).
const ITERATED: f64 = 1e-5;

fn largest(values: impl IntoIterator<Item = f64>) -> f64 {
    values.into_iter().fold(0.0, |m: f64, v| m.max(v.abs()))
}

/// True where it calls itself converged: then displacement, forces, energy and contact set are those of the exact
/// solution, or what is wrong is said; where no digit is left of them the conditions of a solution hold.
pub fn compare(
    scene: &Scene,
    program: &Program,
    answer: &Answer,
    solution: &ContactSolution,
) -> Result<bool, String> {
    let (s, m) = (solution, solution.margins());
    let numbers = [
        s.force_scale(),
        s.displacement_scale(),
        s.energy,
        s.energy_rounding,
        s.contact_force,
        s.balance,
    ];
    let margins = [s.kkt.worst(), m.pressure.unwrap_or(0.0), m.gap.unwrap_or(0.0)];
    let vectors =
        [&s.displacement, &s.normal_displacement, &s.multiplier, &s.gap, &s.positions, &s.pressure];
    let all = vectors.into_iter().flatten().chain(s.traction.as_flattened()).chain(&s.reaction);
    if !all.chain(&numbers).chain(&margins).all(|value| value.is_finite()) {
        return Err(format!("a number that is none: {solution:?}"));
    }
    if !solution.status.is_converged() {
        return Ok(false);
    }
    let (u, multiplier) = (&solution.displacement, &solution.multiplier);
    conditions(program, u, multiplier)?;
    if is_hard(program) {
        return Ok(true);
    }
    // The root of the work of the forces over the lengths of the scene.
    let most = largest(answer.multiplier.iter().map(|l| l.0));
    let energy_norm = (answer.energy_size + most * lengths(program, answer)).sqrt();
    let by = ROUNDINGS * f64::EPSILON;
    let iterated = match solution.solver() {
        Solver::ActiveSet => 0.0,
        // What balance it says it left, relative to its force scale.
        _ => {
            let left = solution.kkt.balance * solution.force_scale();
            ITERATED * energy_norm + program.energy_of_residual(left)
        }
    };
    let spread = by * answer.spread + iterated;
    let local = |k: usize| {
        let [u, f] = program.locally(k);
        [spread * u, by * answer.sizes[k] + spread * f]
    };
    let within = |what: &str, found: f64, exact: f64, tolerance: f64| {
        let off = (found - exact).abs();
        if off <= tolerance {
            return Ok(());
        }
        Err(format!(
            "{what} {found:e}, exact {exact:e}, tolerance {tolerance:e}, off by {:.1}",
            off / tolerance
        ))
    };
    for (k, &i) in program.free.iter().enumerate() {
        within(&format!("displacement {i}"), u[i], value(answer.displacement[i]), local(k)[0])?;
    }
    let whole: Vec<Double> = multiplier.iter().map(|&l| l.into()).collect();
    let (found, exact) = (program.forces(&whole), program.forces(&answer.multiplier));
    for k in 0..found.len() {
        if exact[k].0 != 0.0 || found[k].0 != 0.0 {
            let what = format!("force {}", program.free[k]);
            within(&what, value(found[k]), value(exact[k]), local(k)[1])?;
        }
    }
    // Where contact is not closed exactly, forces do work.
    let work: f64 = (0..found.len()).map(|k| exact[k].0.abs() * local(k)[0]).sum();
    within(
        "energy",
        solution.energy,
        answer.energy,
        by * answer.energy_size + spread * spread + work,
    )?;
    same_set(scene, program, answer, solution, &local)?;
    Ok(true)
}

/// The same constraints are active, except those that touch without force to the tolerance.
fn same_set(
    scene: &Scene,
    program: &Program,
    answer: &Answer,
    solution: &ContactSolution,
    local: &dyn Fn(usize) -> [f64; 2],
) -> Result<(), String> {
    let c = scene.components();
    let around = |i: usize, what: usize| {
        let nodes = program.support(i).iter().flat_map(|&node| (0..c).map(move |k| node * c + k));
        largest(
            nodes
                .filter_map(|unknown| program.free.binary_search(&unknown).ok())
                .map(|k| local(k)[what]),
        )
    };
    let open: Vec<usize> = (0..answer.gap.len()).filter(|&i| !program.is_settled(i)).collect();
    // Multipliers follow from forces along the edge: errors add up.
    let force_error: f64 = 2.0 * open.iter().map(|&i| around(i, 1)).sum::<f64>();
    let is_closed = |i: usize| answer.gap[i].0 >= -2.0 * around(i, 0);
    let closed: Vec<usize> = open.iter().copied().filter(|&i| is_closed(i)).collect();
    let is_unique = program.are_independent(&closed);
    for &i in &open {
        let has_force = answer.multiplier[i].0 > force_error;
        let says = solution.contact_set.contains(i);
        if says && !is_closed(i) {
            return Err(format!("constraint {i} is in the set, its gap is {:e}", answer.gap[i].0));
        }
        if !says && has_force && is_unique {
            return Err(format!(
                "constraint {i} is not in the set, its force is {:e}",
                answer.multiplier[i].0
            ));
        }
    }
    Ok(())
}

/// The largest displacement, bound, or displacement of a load alone.
fn lengths(program: &Program, answer: &Answer) -> f64 {
    largest(answer.displacement.iter().map(|u| u.0))
        .max(largest(program.bounds()))
        .max(program.alone())
}

/// True where the condition number leaves no digit.
pub fn is_hard(program: &Program) -> bool {
    ROUNDINGS * f64::EPSILON * program.condition() > LINEAR
}

/// Balance, sign, gap, complementarity by the matrix of the test.
fn conditions(program: &Program, u: &[f64], multiplier: &[f64]) -> Result<(), String> {
    let (residual, sizes) = program.residual(u, multiplier);
    let force = largest(sizes);
    let gaps = program.gaps(u);
    let length = largest(u.iter().copied()).max(largest(program.bounds())).max(program.alone());
    let most = largest(multiplier.iter().copied());
    let contact = if most > 1e-13 * force { most } else { force };
    let ratio = |part: f64, of: f64| if part == 0.0 { 0.0 } else { part / of };
    let products =
        (0..gaps.len()).map(|i| ratio(multiplier[i].abs(), contact) * ratio(gaps[i].abs(), length));
    for (name, figure) in [
        ("balance", ratio(largest(residual), force)),
        ("sign", ratio(multiplier.iter().map(|&l| -l).fold(0.0, f64::max), contact)),
        ("gap", ratio(gaps.iter().copied().fold(0.0, f64::max), length)),
        ("complementarity", largest(products)),
    ] {
        if figure > SCALES * ACCEPTED || figure.is_nan() {
            return Err(format!("converged, but {name} {figure:e}"));
        }
    }
    Ok(())
}
