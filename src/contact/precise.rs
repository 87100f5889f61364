//! Ill-conditioned problems: the discrete solution in double-double, from the contact set that a solver in binary64
//! found.
//!
//! Rounding of K by ε moves the minimum of J by about ½ u'δK u + ½ (δK u)'K⁻¹(δK u). The first term is estimated from
//! the terms of K u; the second grows with the condition number and is seen only by a correction whose residual has
//! twice the digits. With K, hence S = K⁻¹, in double-double, A = B S B' and c = B S F − g, the multipliers solve
//! λ ≥ 0, c − A λ ≤ 0, λ'(c − A λ) = 0: constraints with the wrong sign are exchanged, all of them at first, and the
//! one of lowest index once their number does not fall (J. J. Júdice and F. M. Pires 1994). The displacement is
//! corrected once: u ← u + δ, δ = S r, r = F − K u − B'λ; ½ r'δ is the error of J before the correction.
//!
//! Cost: a Cholesky factorization of the profile of K in double-double, limited by [`MOST_WORK`].

use super::problem::ContactProblem;
use super::solution::{
    ACCEPTED, Candidate, ContactSolution, Evaluated, conclude_with, displacement_scale,
};
use super::solver::Solver;
use crate::cone::{Cone, ContactSet, Status};
use crate::error::{Error, Result, ToolkitError};
use crate::fem::{Form, PreciseRow, precise_stiffness};
use crate::mesh::{distance, doubled_area};
use fractional_sobolev::Work;
use qd::Quad;

/// Relative rounding of J above which the solution is computed in double-double.
const NOTICED: f64 = 1e-11;

/// The same for (λ + 2μ)/μ times the squared aspect ratio of a triangle, and for the aspect ratio alone.
const STIFF: f64 = 1e8;
const SLENDER: f64 = 16.0;

/// Largest number of products of the factorization and of the solutions with it: about a second.
const MOST_WORK: f64 = 5e7;

/// Largest number of unknowns: on a square the work is above the limit for more than some 5000.
const MOST_UNKNOWNS: usize = 10_000;

/// Signs of multipliers and gaps below this multiple of their terms are attributed to rounding; the second is tried
/// if the iteration does not end with the first.
const SIGNS: [f64; 2] = [1e-20, 1e-13];

/// A pivot below this share of its diagonal entry: the constraint depends on those before it and is left out.
const DEPENDENT: f64 = 1e-20;

/// Displacements below this multiple of their scale are rounding of double-double.
const RESIDUE: f64 = 1e-26;

/// Exchanges of all wrong constraints without a new minimum of their number, before single exchanges.
const PATIENCE: usize = 10;

/// Largest number of exchanges, plus the same for every constraint.
const STEPS: usize = 20;

impl ContactProblem {
    /// The solution in double-double where rounding may be noticed, that of binary64 elsewhere; a solution whose J is
    /// rounded by more than the tolerance is not converged.
    pub(super) fn completed(
        &self,
        cone: Cone,
        found: Result<ContactSolution>,
    ) -> Result<ContactSolution> {
        if self.unknowns() > MOST_UNKNOWNS {
            return found;
        }
        let is_noticed = match &found {
            Ok(found) => {
                let [stiff, slender] = self.stiffest();
                let is_extreme = stiff > STIFF || slender > SLENDER;
                // Multigrid leaves the error that was asked for; it is no rounding.
                let is_exact = found.multigrid.is_none();
                is_extreme
                    || is_exact && found.energy_rounding > NOTICED * found.energy_scale
                    || !found.status.is_converged()
            }
            Err(error) => matches!(error, Error::Toolkit(ToolkitError::NotPositiveDefinite { .. })),
        };
        if !is_noticed || self.in_unit().is_some() {
            return found;
        }
        let guess = found.as_ref().ok().map(|found| &found.contact_set);
        let Some(system) = System::new(self, cone) else { return found };
        let Some(mut answer) = system.solve(guess) else { return found };
        // Where contact keeps u = 0 a residue has no scale but that of the load.
        let residue = RESIDUE * displacement_scale(self, &answer.unknowns);
        answer.unknowns.iter_mut().filter(|u| u.abs() <= residue).for_each(|u| *u = 0.0);
        let (solver, steps, work) = match &found {
            Ok(found) => (found.solver, found.steps.clone(), found.work),
            Err(_) => (Solver::ActiveSet, Vec::new(), Work::default()),
        };
        let candidate = Candidate {
            solver,
            unknowns: answer.unknowns,
            multiplier: answer.multiplier,
            contact_set: answer.set,
            status: Status::Converged,
            steps,
            work,
            accepted: ACCEPTED,
        };
        let precise = conclude_with(self, cone, candidate, Some(answer.evaluated))?;
        Ok(match found {
            // Where contact keeps u = 0 a residue of 1e-32 has no scale: the zeros of binary64 are better.
            Ok(found) if found.status.is_converged() && !precise.status.is_converged() => found,
            Ok(found) => {
                ContactSolution { seconds: found.seconds, multigrid: found.multigrid, ..precise }
            }
            Err(_) => precise,
        })
    }

    /// The largest (λ + 2μ)/μ times the squared aspect ratio, diameter over height, of a triangle, and the largest
    /// ratio; 1 in place of the moduli for a scalar form.
    fn stiffest(&self) -> [f64; 2] {
        let of = |t: usize| {
            let [a, b, c] = self.mesh.corners(t);
            let diameter = distance(a, b).max(distance(b, c)).max(distance(c, a));
            let aspect = diameter / (doubled_area([a, b, c]) / diameter);
            let moduli = match (&self.form, self.form.material(self.mesh.region(t))) {
                (Form::Elastic { .. }, Some(m)) => {
                    (m.lambda().abs() + 2.0 * m.mu()) / m.mu().min(m.lambda() + m.mu())
                }
                _ => 1.0,
            };
            [moduli * aspect * aspect, aspect]
        };
        (0..self.mesh.triangles().len())
            .map(of)
            .fold([0.0; 2], |[a, b], [c, d]: [f64; 2]| [a.max(c), b.max(d)])
    }
}

/// The problem on its free unknowns in double-double.
struct System<'a> {
    problem: &'a ContactProblem,
    rows: Vec<PreciseRow>,
    /// The free unknowns in the order of elimination.
    free: Vec<usize>,
    factor: Profile,
    /// Constraints with a free node, their rows by position in `free`, and their bounds.
    constraints: Vec<usize>,
    entries: Vec<Vec<(usize, Quad)>>,
    bound: Vec<Quad>,
    count: usize,
}

struct Answer {
    unknowns: Vec<f64>,
    multiplier: Vec<f64>,
    set: ContactSet,
    evaluated: Evaluated,
}

impl<'a> System<'a> {
    /// `None` if the factorization costs too much, or fails.
    fn new(problem: &'a ContactProblem, cone: Cone) -> Option<Self> {
        let cone = problem.edge_cone(cone);
        let rows = precise_stiffness(&problem.mesh, &problem.form, &problem.frames);
        let free = ordered(problem, &rows);
        let mut position = vec![usize::MAX; problem.unknowns()];
        free.iter().enumerate().for_each(|(k, &unknown)| position[unknown] = k);
        let normals = problem.normal_unknowns();
        let is_free = |node: usize| position[normals[node]] != usize::MAX;
        let constraints: Vec<usize> =
            (0..cone.constraints()).filter(|&i| cone.support(i).any(is_free)).collect();
        let first: Vec<usize> = (0..free.len())
            .map(|k| {
                let columns = rows[free[k]].keys().map(|&column| position[column]);
                columns.filter(|&column| column < k).min().unwrap_or(k)
            })
            .collect();
        let widths = first.iter().enumerate().map(|(k, first)| (k - first + 1) as f64);
        let (profile, products) =
            widths.fold((0.0, 0.0), |(sum, squares), w| (sum + w, squares + 0.5 * w * w));
        let m = constraints.len() as f64;
        if products + 2.0 * m * profile + m * m * m > MOST_WORK {
            return None;
        }
        let factor = Profile::new(&first, |i, j| {
            rows[free[i]].get(&free[j]).copied().unwrap_or(Quad::ZERO)
        })?;
        let weight = Quad::from(cone.weight());
        let mut entries = Vec::new();
        let mut bound = Vec::new();
        for &i in &constraints {
            let mut row = Vec::new();
            let mut g = Quad::ZERO;
            for node in cone.support(i) {
                g += weight * Quad::from(problem.gap[node]);
                match position[normals[node]] {
                    usize::MAX => g -= weight * Quad::from(problem.values[normals[node]]),
                    at => row.push((at, weight)),
                }
            }
            entries.push(row);
            bound.push(g);
        }
        Some(Self {
            problem,
            rows,
            free,
            factor,
            constraints,
            entries,
            bound,
            count: cone.constraints(),
        })
    }

    /// `None` if no contact set is found.
    fn solve(&self, guess: Option<&ContactSet>) -> Option<Answer> {
        let problem = self.problem;
        let m = self.constraints.len();
        let prescribed: Vec<Quad> = problem.values.iter().map(|&value| value.into()).collect();
        let load: Vec<Quad> = self
            .free
            .iter()
            .map(|&i| Quad::from(problem.load[i]) - product(&self.rows[i], &prescribed))
            .collect();
        let unloaded = self.factor.solve(&load);
        let images: Vec<Vec<Quad>> =
            self.entries.iter().map(|row| self.factor.solve(&self.spread(row))).collect();
        let matrix: Vec<Vec<Quad>> = self
            .entries
            .iter()
            .map(|row| images.iter().map(|image| dot_sparse(row, image)).collect())
            .collect();
        let open: Vec<Quad> =
            (0..m).map(|i| dot_sparse(&self.entries[i], &unloaded) - self.bound[i]).collect();
        let start: Vec<bool> =
            self.constraints.iter().map(|&i| guess.is_some_and(|set| set.contains(i))).collect();
        let (set, found) =
            SIGNS.iter().find_map(|&sign| complementarity(&matrix, &open, &start, sign))?;
        let mut free = unloaded;
        for (image, &l) in images.iter().zip(&found) {
            free.iter_mut().zip(image).for_each(|(u, &s)| *u -= s * l);
        }
        let mut unknowns = prescribed;
        self.free.iter().zip(&free).for_each(|(&i, &u)| unknowns[i] = u);
        let residual = self.residual(&unknowns, &found);
        let correction = self.factor.solve(&residual);
        let before =
            residual.iter().zip(&correction).fold(Quad::ZERO, |sum, (&r, &d)| sum + r * d).0.abs();
        self.free.iter().zip(&correction).for_each(|(&i, &d)| unknowns[i] += d);
        let stress: Vec<Quad> = self.rows.iter().map(|row| product(row, &unknowns)).collect();
        let half = Quad::from(0.5);
        let energy = unknowns
            .iter()
            .zip(&stress)
            .zip(&problem.load)
            .fold(Quad::ZERO, |sum, ((&u, &k), &f)| sum + u * (half * k - Quad::from(f)));
        let free: Vec<Quad> = self.free.iter().map(|&i| unknowns[i]).collect();
        let left: f64 = (0..m)
            .map(|i| ((dot_sparse(&self.entries[i], &free) - self.bound[i]) * found[i]).0.abs())
            .sum();
        let strain = dot(&unknowns, &stress).0;
        let data = self.work_of_data(&unknowns, &stress) + strain.abs() + energy.0.abs();
        let rounding = 2.0 * f64::EPSILON * data + before + left;
        let rounded: Vec<f64> = unknowns.iter().map(|u| u.0).collect();
        let wide: Vec<Quad> = rounded.iter().map(|&u| u.into()).collect();
        let stress_force = self.rows.iter().map(|row| product(row, &wide).0).collect();
        let mut multiplier = vec![0.0; self.count];
        let mut active = vec![false; self.count];
        for (k, &i) in self.constraints.iter().enumerate() {
            (multiplier[i], active[i]) = (found[k].0, set[k]);
        }
        // Constraints without a free node hold or not whatever the set; they stay as they were.
        if let Some(guess) = guess {
            (0..self.count)
                .filter(|i| !self.constraints.contains(i))
                .for_each(|i| active[i] = guess.contains(i));
        }
        Some(Answer {
            unknowns: rounded,
            multiplier,
            set: ContactSet::new(&active),
            evaluated: Evaluated { stress_force, energy: energy.0, rounding },
        })
    }

    /// F − K u − B'λ on the free unknowns.
    fn residual(&self, unknowns: &[Quad], multiplier: &[Quad]) -> Vec<Quad> {
        let row = |&i: &usize| Quad::from(self.problem.load[i]) - product(&self.rows[i], unknowns);
        let mut residual: Vec<Quad> = self.free.iter().map(row).collect();
        for (entries, &l) in self.entries.iter().zip(multiplier) {
            entries.iter().for_each(|&(at, weight)| residual[at] -= weight * l);
        }
        residual
    }

    /// The work of all forces whose rounding is that of the data: Σ |u| (|F| + d |K u − F|) over the nodes, the second
    /// the contact forces and reactions; d = 1, on an inclined edge 1 + |x|/h, h the shortest segment, as the normal is
    /// known to ε |x|/h from coordinates of size |x|.
    fn work_of_data(&self, unknowns: &[Quad], stress: &[Quad]) -> f64 {
        let size = |values: &[f64]| values.iter().copied().fold(0.0, f64::hypot);
        let is_known = self.problem.form.components() == 1 || self.problem.frames.are_along_axes();
        let reach =
            self.problem.edge.points().iter().flatten().fold(0.0, |most: f64, x| most.max(x.abs()));
        let shortest =
            self.problem.edge.segment_lengths().into_iter().fold(f64::INFINITY, f64::min);
        let direction = if is_known { 1.0 } else { 1.0 + reach / shortest };
        let at = |start: usize| {
            let range = start..start + self.problem.form.components();
            let u: Vec<f64> = unknowns[range.clone()].iter().map(|u| u.0).collect();
            let load = &self.problem.load[range.clone()];
            let other: Vec<f64> = range.map(|i| stress[i].0 - self.problem.load[i]).collect();
            size(&u) * (size(load) + direction * size(&other))
        };
        (0..unknowns.len()).step_by(self.problem.form.components()).map(at).sum()
    }

    fn spread(&self, row: &[(usize, Quad)]) -> Vec<Quad> {
        let mut dense = vec![Quad::ZERO; self.free.len()];
        row.iter().for_each(|&(at, weight)| dense[at] = weight);
        dense
    }
}

/// λ ≥ 0 with w = c − A λ ≤ 0, λ'w = 0, and its set; `None` if the exchanges do not end.
fn complementarity(
    matrix: &[Vec<Quad>],
    open: &[Quad],
    start: &[bool],
    sign: f64,
) -> Option<(Vec<bool>, Vec<Quad>)> {
    let m = open.len();
    let mut set = start.to_vec();
    let (mut fewest, mut in_vain) = (usize::MAX, 0);
    for _ in 0..STEPS * (m + 1) {
        let multiplier = equations(matrix, open, &mut set);
        let terms = |i: usize| {
            (0..m).fold(open[i].0.abs(), |sum, j| sum + (matrix[i][j] * multiplier[j]).0.abs())
        };
        let gap = |i: usize| (0..m).fold(open[i], |sum, j| sum - matrix[i][j] * multiplier[j]).0;
        let is_wrong = |&i: &usize| match set[i] {
            true => multiplier[i].0 < -sign * terms(i) / matrix[i][i].0,
            false => gap(i) > sign * terms(i),
        };
        let wrong: Vec<usize> = (0..m).filter(is_wrong).collect();
        if wrong.is_empty() {
            return Some((set, multiplier));
        }
        in_vain += 1;
        if wrong.len() < fewest {
            (fewest, in_vain) = (wrong.len(), 0);
        }
        let exchanged = if in_vain > PATIENCE { &wrong[..1] } else { &wrong[..] };
        exchanged.iter().for_each(|&i| set[i] = !set[i]);
    }
    None
}

/// λ with A_II λ_I = c_I, 0 elsewhere; a constraint that depends on those before it leaves the set.
fn equations(matrix: &[Vec<Quad>], open: &[Quad], set: &mut [bool]) -> Vec<Quad> {
    let mut kept: Vec<usize> = Vec::new();
    let mut factor: Vec<Vec<Quad>> = Vec::new();
    for i in 0..open.len() {
        if !set[i] {
            continue;
        }
        let mut row: Vec<Quad> = Vec::with_capacity(kept.len() + 1);
        for (k, &j) in kept.iter().enumerate() {
            let sum = matrix[i][j] - dot(&row, &factor[k][..k]);
            row.push(sum / factor[k][k]);
        }
        let pivot = matrix[i][i] - dot(&row, &row);
        if pivot.0 <= DEPENDENT * matrix[i][i].0 {
            set[i] = false;
            continue;
        }
        row.push(pivot.sqrt());
        factor.push(row);
        kept.push(i);
    }
    let right: Vec<Quad> = kept.iter().map(|&i| open[i]).collect();
    let first = vec![0; kept.len()];
    let solution = Profile { first, rows: factor }.solve(&right);
    let mut multiplier = vec![Quad::ZERO; open.len()];
    kept.iter().zip(solution).for_each(|(&i, l)| multiplier[i] = l);
    multiplier
}

/// The free unknowns node by node in the reverse Cuthill-McKee order, which keeps the profile small.
fn ordered(problem: &ContactProblem, rows: &[PreciseRow]) -> Vec<usize> {
    let c = problem.form.components();
    let nodes = problem.mesh.nodes().len();
    let neighbours = |node: usize| rows[node * c].keys().step_by(c).map(|column| column / c);
    let degree: Vec<usize> = (0..nodes).map(|node| neighbours(node).count()).collect();
    // Breadth first from `start`: the nodes in order of distance.
    let component = |start: usize, seen: &mut Vec<bool>| {
        let mut order = vec![start];
        seen[start] = true;
        let mut next = 0;
        while next < order.len() {
            let mut found: Vec<usize> =
                neighbours(order[next]).filter(|&node| !seen[node]).collect();
            found.sort_by_key(|&node| degree[node]);
            for node in found {
                seen[node] = true;
                order.push(node);
            }
            next += 1;
        }
        order
    };
    let mut seen = vec![false; nodes];
    let mut order = Vec::with_capacity(nodes);
    for node in 0..nodes {
        if !seen[node] {
            // The farthest node from any one lies at an end.
            let far = component(node, &mut seen.clone());
            order.extend(component(far[far.len() - 1], &mut seen));
        }
    }
    let unknowns = order.into_iter().rev().flat_map(|node| node * c..(node + 1) * c);
    unknowns.filter(|&unknown| !problem.prescribed[unknown]).collect()
}

/// L with L L' = K, row i from column `first[i]` on.
struct Profile {
    first: Vec<usize>,
    rows: Vec<Vec<Quad>>,
}

impl Profile {
    /// `None` if a pivot is not positive.
    fn new(first: &[usize], entry: impl Fn(usize, usize) -> Quad) -> Option<Self> {
        let mut rows: Vec<Vec<Quad>> = Vec::with_capacity(first.len());
        for (i, &start) in first.iter().enumerate() {
            let mut row: Vec<Quad> = Vec::with_capacity(i - start + 1);
            for j in start..i {
                let both = start.max(first[j]);
                let known = if both < j {
                    dot(&row[both - start..], &rows[j][both - first[j]..])
                } else {
                    Quad::ZERO
                };
                row.push((entry(i, j) - known) / rows[j][j - first[j]]);
            }
            let pivot = entry(i, i) - dot(&row, &row);
            if pivot.0.is_nan() || pivot.0 <= 0.0 {
                return None;
            }
            row.push(pivot.sqrt());
            rows.push(row);
        }
        Some(Self { first: first.to_vec(), rows })
    }

    fn solve(&self, right: &[Quad]) -> Vec<Quad> {
        let mut x: Vec<Quad> = Vec::with_capacity(right.len());
        for (i, row) in self.rows.iter().enumerate() {
            let width = row.len() - 1;
            let sum = right[i] - dot(&x[self.first[i]..], &row[..width]);
            x.push(sum / row[width]);
        }
        for i in (0..x.len()).rev() {
            let row = &self.rows[i];
            let (start, width) = (self.first[i], row.len() - 1);
            x[i] /= row[width];
            let value = x[i];
            x[start..i].iter_mut().zip(row).for_each(|(x, &l)| *x -= l * value);
        }
        x
    }
}

/// Σ a_i b_i over the shorter of the two.
fn dot(a: &[Quad], b: &[Quad]) -> Quad {
    a.iter().zip(b).fold(Quad::ZERO, |sum, (&a, &b)| sum + a * b)
}

fn dot_sparse(row: &[(usize, Quad)], x: &[Quad]) -> Quad {
    row.iter().fold(Quad::ZERO, |sum, &(at, weight)| sum + weight * x[at])
}

fn product(row: &PreciseRow, x: &[Quad]) -> Quad {
    row.iter().fold(Quad::ZERO, |sum, (&column, &entry)| sum + entry * x[column])
}
