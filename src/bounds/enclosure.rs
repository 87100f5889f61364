//! A solution with its guaranteed error: the displacement of one mesh, a stress of the same or of a
//! coarser mesh, and what follows from the two.

use super::dual::Dual;
use super::element::Traction;
use super::parts::Parts;
use super::setting::Setting;
use crate::cone::{Cone, ContactSet};
use crate::contact::{Body, ContactProblem, ContactSolution, Settings, Solver, Start};
use crate::error::{Error, Result};
use crate::mesh::{Part, Triangulation, distance};
use std::sync::Arc;

/// Overlaps below this multiple of the largest displacement are rounding.
const ROUNDED: f64 = 1e-14;

/// An interval that contains a number.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interval {
    /// Lower end.
    pub lower: f64,
    /// Upper end.
    pub upper: f64,
}

impl Interval {
    pub(super) fn around(middle: f64, radius: f64) -> Self {
        Self { lower: middle - radius, upper: middle + radius }
    }

    /// The distance of the ends.
    pub fn width(self) -> f64 {
        self.upper - self.lower
    }

    /// Whether a number lies between the ends.
    pub fn contains(self, value: f64) -> bool {
        (self.lower..=self.upper).contains(&value)
    }
}

/// A discrete solution, an equilibrated stress, and the bounds that the two give.
///
/// ```
/// use signorini::{cone::Cone, contact::Body, fem::{Form, Lame}, mesh::{SideParts, unit_square}};
/// let body = Body::new(unit_square(8, SideParts::HANGING)?, Form::elastic(Lame::new(1.0, 1.0)?))
///     .load(|[x, _]: [f64; 2]| [0.0, -(std::f64::consts::PI * x).cos()]);
/// let found = body.enclose(Cone::Nodal)?;
/// // J(u) = −0.017633 from a fine mesh lies between the two energies
/// assert!(found.energy.contains(-0.017633) && found.energy.width() < 1.6e-3);
/// assert!(found.error < 0.0554);
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Enclosure {
    /// The discrete problem.
    pub problem: ContactProblem,
    /// Its solution u^h.
    pub solution: ContactSolution,
    /// J(u), the energy of the exact solution; for a load that is no polynomial widened by
    /// [`Body::missed_load`](crate::contact::Body::missed_load), an estimate.
    pub energy: Interval,
    /// An upper bound of |||u − u^h|||, the energy norm of the error of `solution.displacement`. A
    /// load or a traction that is no polynomial enters it by rules whose own error is not counted.
    pub error: f64,
    /// The energy norm |||u||| of the exact solution: |||u^h||| ± `error`, and for a body without
    /// gap and prescribed displacement also the roots of −2J at the ends of `energy`.
    ///
    /// There u and 2u are in the cone of admissible displacements with 0, so that a(u, v − u) ≥ l(v
    /// − u) for v = 0 and v = 2u gives a(u, u) = l(u) and J(u) = −½ |||u|||². Hence |||u|||² ≥ −2
    /// J(v) for every admissible v. For a nodal u^h on a straight edge that is |||u^h|||² itself,
    /// without the error.
    pub norm: Interval,
    /// The share of every triangle in the square of the bound, with that of its contact segments.
    pub shares: Vec<f64>,
    /// The part of `error` that stems from loads and tractions which the stress does not carry.
    pub oscillation: f64,
    /// The part of `error` that stems from rounding.
    pub rounding: f64,
    /// The energy norm of the correction into the cone: 0 if u^h penetrates nowhere.
    pub correction: f64,
    /// Steps of the active set of the equilibrated stress.
    pub dual_steps: usize,
    /// Pressure −q_N ≥ 0 of the equilibrated stress at both ends of every contact segment, in the
    /// order of the edge.
    pub pressure: Vec<[f64; 2]>,
    /// The mean of the equilibrated stress on every triangle: (q_xx, q_yy, q_xy), or (q_x, q_y, 0)
    /// of a flux.
    pub stress: Vec<[f64; 3]>,
    /// J*(q), its energy; with oscillation it need not be a lower bound of J(u).
    pub dual_energy: f64,
    /// Tractions of the stress.
    pub tractions: Traction,
    pub(super) dual: Dual,
    /// The mesh of the stress with the ancestor of every triangle there, if it is a coarser one.
    pub(super) hosts: Option<Arc<(Triangulation, Vec<u32>)>>,
    pub(super) admissible: Vec<f64>,
    pub(super) reach: f64,
    pub(super) work: f64,
}

impl Enclosure {
    /// An upper bound of |||u − u^h|||/|||u|||; infinite if |||u||| may vanish.
    ///
    /// ```
    /// use signorini::{cone::Cone, contact::Body, fem::Form, mesh::{SideParts, unit_square}};
    /// let body = Body::new(unit_square(16, SideParts::HANGING)?, Form::LAPLACE)
    ///     .load(|_: [f64; 2]| -1.0);
    /// assert!(body.enclose(Cone::Nodal)?.relative_error() < 0.1);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    pub fn relative_error(&self) -> f64 {
        if self.error == 0.0 { 0.0 } else { self.error / self.norm.lower.max(0.0) }
    }

    /// The text of a `.vtu` file: that of [`ContactProblem::to_vtu`], on the triangles also
    /// - `equilibrated_stress` (q_xx, q_yy, q_xy), or `equilibrated_flux` (q_x, q_y, 0), the mean
    ///   of q;
    /// - `share_of_bound`, the share of the triangle in the square of the bound.
    ///
    /// ```
    /// use signorini::{cone::Cone, contact::Body, fem::Form, mesh::{SideParts, unit_square}};
    /// let body = Body::new(unit_square(2, SideParts::HANGING)?, Form::LAPLACE)
    ///     .load(|_: [f64; 2]| -1.0);
    /// let text = body.enclose(Cone::Nodal)?.to_vtu()?;
    /// assert!(text.contains("equilibrated_flux") && text.contains("share_of_bound"));
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`ContactProblem::to_vtu`].
    pub fn to_vtu(&self) -> Result<String> {
        let elastic = self.problem.form().components() == 2;
        let name = if elastic { "equilibrated_stress" } else { "equilibrated_flux" };
        let further =
            [(name, 3, self.stress.as_flattened()), ("share_of_bound", 1, &self.shares[..])];
        self.problem.to_vtu_with(&self.solution, &further)
    }
}

impl Body<'_> {
    /// The discrete solution on the mesh of the body, with a guaranteed error.
    ///
    /// Cost: about ten times the time and six times the memory of the discrete solution alone for
    /// n = 256 on the block, seven and four times with [`Traction::Reduced`].
    ///
    /// # Errors
    /// As for [`Body::problem`] and [`ContactProblem::solve`].
    pub fn enclose(&self, cone: Cone) -> Result<Enclosure> {
        self.enclose_with(cone, Traction::default())
    }

    /// The same with the given tractions of the stress: [`Traction::Reduced`] takes less time and
    /// memory and gives a larger bound.
    ///
    /// # Errors
    /// As for [`Body::enclose`].
    pub fn enclose_with(&self, cone: Cone, tractions: Traction) -> Result<Enclosure> {
        let solved = self.solved_on(self.mesh(), cone, None)?;
        self.enclosed(cone, tractions, solved)
    }

    /// The discrete problem on a refinement of the mesh with its solution, from a guess of the
    /// active constraints.
    pub(super) fn solved_on(
        &self,
        mesh: &Triangulation,
        cone: Cone,
        guess: Option<ContactSet>,
    ) -> Result<(ContactProblem, ContactSolution)> {
        let problem = self.problem_on(mesh)?;
        let start = guess.map_or(Start::Open, Start::Set);
        let settings = Settings { solver: Solver::ActiveSet, start, ..Settings::default() };
        let solution = problem.solve(cone, settings)?;
        Ok((problem, solution))
    }

    /// The bound by the best stress on the same mesh.
    pub(super) fn enclosed(
        &self,
        cone: Cone,
        tractions: Traction,
        (problem, solution): (ContactProblem, ContactSolution),
    ) -> Result<Enclosure> {
        let mesh = problem.mesh().clone();
        let setting = Setting::new(self, &mesh, tractions)?;
        let dual = setting.best_stress(&setting.touching(&problem, cone, &solution))?;
        setting.conclude(problem, cone, solution, dual)
    }

    /// The bound by the stress of another enclosure, on whose mesh every triangle has the given
    /// ancestor.
    pub(super) fn enclosed_by(
        &self,
        cone: Cone,
        coarse: &Enclosure,
        of: Vec<u32>,
        (problem, solution): (ContactProblem, ContactSolution),
    ) -> Result<Enclosure> {
        let (mesh, hosts) = (problem.mesh().clone(), coarse.problem.mesh().clone());
        let own = Setting::new(self, &hosts, coarse.tractions)?;
        let fine = own.refined(&mesh, of.clone())?;
        let dual = own.transferred(&fine, &coarse.dual)?;
        let mut found = fine.conclude(problem, cone, solution, dual)?;
        drop((fine, own));
        found.hosts = Some(Arc::new((hosts, of)));
        Ok(found)
    }

    /// The data on the mesh of an enclosure.
    pub(super) fn setting_of<'s>(&'s self, found: &'s Enclosure) -> Result<Setting<'s, 's>> {
        let mesh = found.problem.mesh();
        match found.hosts.as_deref() {
            Some((hosts, of)) => {
                Setting::new(self, hosts, found.tractions)?.refined(mesh, of.clone())
            }
            None => Setting::new(self, mesh, found.tractions),
        }
    }
}

/// The bound of u^h after a correction into the cone.
struct Bounded {
    /// v = u^h − w.
    admissible: Vec<f64>,
    /// w.
    corrected: Option<Vec<f64>>,
    /// |||w|||.
    correction: f64,
    parts: Parts,
    /// A and b of module `parts`, with rounding, and osc.
    reach: f64,
    work: f64,
    osc: f64,
    /// The bound of |||u − u^h|||.
    error: f64,
}

impl Setting<'_, '_> {
    /// What rules may miss of l(v): tractions, and a load that is no polynomial.
    pub(super) fn missed(&self, v: &[f64]) -> Result<f64> {
        if self.local || self.reaction() > 0.0 || self.body.has_tractions() {
            self.body.missed_load(self.mesh, v)
        } else {
            Ok(0.0)
        }
    }

    /// The ends of the contact segments at which the discrete solution touches, by border.
    fn touching(
        &self,
        problem: &ContactProblem,
        cone: Cone,
        solution: &ContactSolution,
    ) -> Vec<[bool; 2]> {
        // Without a Dirichlet edge too few constraints leave the stress undetermined.
        let mut active = vec![problem.floats; self.mesh.nodes().len()];
        if cone == Cone::Nodal && !problem.floats {
            for (i, &node) in problem.edge().nodes().iter().enumerate() {
                active[node] = solution.contact_set.contains(i);
            }
        }
        let ends = |triangle: usize, side: usize| {
            [0, 1].map(|end| active[self.mesh.triangles()[triangle][(side + end) % 3]])
        };
        self.borders.iter().map(|border| ends(border.triangle, border.side)).collect()
    }

    fn conclude(
        &self,
        problem: ContactProblem,
        cone: Cone,
        solution: ContactSolution,
        dual: Dual,
    ) -> Result<Enclosure> {
        let overlap = self.overlap(&problem, &solution.displacement)?;
        let largest = solution.displacement.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
        let penetrates = overlap.iter().any(|&off| off > ROUNDED * largest);
        let mut best = if penetrates {
            self.bounded(&problem, &solution, &dual, Some(&overlap))?
        } else {
            self.bounded(&problem, &solution, &dual, None)?
        };
        if penetrates && cone == Cone::Midpoint {
            for everywhere in [true, false] {
                let averages = self.averages(&problem, &solution.displacement, everywhere)?;
                let other = self.bounded(&problem, &solution, &dual, Some(&averages))?;
                if other.error < best.error {
                    best = other;
                }
            }
        }
        let Bounded { admissible, corrected, correction, parts, reach, work, osc, mut error } =
            best;
        let upper =
            if corrected.is_some() { problem.energy_of(&admissible) } else { solution.energy };
        let lifted = self.lift_energies(&admissible)?;
        let upper = upper + lifted.iter().map(|lift| lift.gained).sum::<f64>();
        // The bound is one of u^h + z, z the lift of u_D.
        error += lifted.iter().map(|lift| lift.square).sum::<f64>().sqrt();
        let room = 4.0 * solution.energy_rounding + self.missed(&admissible)?;
        let lower = upper - 0.5 * (reach * reach + 2.0 * work);
        let energy = Interval { lower: lower - room, upper: upper + room };
        let size = problem.energy_norm(&solution.displacement)?;
        let mut norm = Interval { lower: (size - error).max(0.0), upper: size + error };
        if self.body.has_zero_data() {
            // |||u|||² = −2 J(u).
            let root = |energy: f64| (-2.0 * energy).max(0.0).sqrt();
            norm.lower = norm.lower.max(root(energy.upper));
            norm.upper = norm.upper.min(root(energy.lower)).max(norm.lower);
        }
        let mut shares: Vec<f64> =
            parts.distance.iter().zip(&parts.oscillation).map(|(d, o)| d + o * o).collect();
        for (border, contact) in self.borders.iter().zip(&parts.contact) {
            shares[border.triangle] += 2.0 * contact;
        }
        if let Some(w) = &corrected {
            self.add_shares(&mut shares, w);
        }
        shares.iter_mut().zip(&lifted).for_each(|(share, lift)| *share += lift.square);
        Ok(Enclosure {
            energy,
            error,
            norm,
            shares,
            oscillation: osc,
            rounding: dual.rounding,
            correction,
            dual_steps: dual.steps,
            pressure: self.in_order(&problem, &dual.pressure),
            stress: parts.means,
            dual_energy: -parts.complementary,
            tractions: self.tractions,
            dual,
            hosts: None,
            admissible,
            reach,
            work,
            problem,
            solution,
        })
    }

    /// The bound after a correction w with the given values of w_N at the nodes of Γ_C, which has
    /// to lead into the cone.
    fn bounded(
        &self,
        problem: &ContactProblem,
        solution: &ContactSolution,
        dual: &Dual,
        normal: Option<&[f64]>,
    ) -> Result<Bounded> {
        let corrected = normal.map(|normal| problem.extension(normal)).transpose()?;
        let mut admissible = solution.displacement.clone();
        let mut correction = 0.0;
        if let Some(w) = &corrected {
            admissible.iter_mut().zip(w).for_each(|(v, w)| *v -= w);
            correction = problem.energy_norm(w)?;
        }
        let parts = self.parts(&admissible, dual)?;
        let (reach, work, osc) = (parts.reach() + dual.rounding, parts.work(), parts.osc());
        let of_admissible = 0.5 * (reach + (reach * reach + 4.0 * work).sqrt());
        let mut error = of_admissible + correction;
        if corrected.is_some() {
            // T11 for v that is not in K: |||d(v)|||² + |||w|||² + 2b + 2 osc |||u − v + w|||, osc
            // that of v.
            let plain = self.parts(&solution.displacement, dual)?;
            let (distance, off) = (
                plain.distance.iter().sum::<f64>().sqrt() + dual.rounding,
                plain.osc() + dual.rounding,
            );
            let square = distance * distance
                + correction * correction
                + 2.0 * work
                + 2.0 * off * of_admissible;
            error = error.min(square.sqrt());
        }
        Ok(Bounded { admissible, corrected, correction, parts, reach, work, osc, error })
    }

    /// w_N = v_N − M v at the nodes of Γ_C, everywhere or beside penetration only, 0 at clamped
    /// ones; M v − g is at every node the interpolant between the means of v_N − g over both
    /// segments beside it, which are not positive, or the mean over the only one. What remains
    /// above a curved gap is added.
    ///
    /// For the midpoint cone the bound has the order of the error with averages everywhere (page
    /// `rate_of_the_bound`), whereas positive parts at the nodes are of first order in the
    /// penetration. Averages beside penetration are often the best.
    fn averages(
        &self,
        problem: &ContactProblem,
        displacement: &[f64],
        everywhere: bool,
    ) -> Result<Vec<f64>> {
        let edge = problem.edge();
        let normal = problem.normal_displacement(displacement)?;
        let clamped = self.mesh.nodes_on(Part::Dirichlet);
        let off: Vec<f64> = (0..normal.len()).map(|i| normal[i] - problem.gap[i]).collect();
        let mut correction = vec![0.0; off.len()];
        for piece in edge.pieces() {
            let (start, count) = (piece.start, piece.len());
            let own = &off[piece.clone()];
            // Segment j from node j to the next one; on a closed edge the last one ends at the
            // first node.
            let is_closed = edge.is_closed();
            let segments = if is_closed { count } else { count - 1 };
            let length = |j: usize| {
                let [a, b] = [j, (j + 1) % count].map(|k| edge.points()[start + k]);
                distance(a, b)
            };
            let mean = |j: usize| 0.5 * (own[j] + own[(j + 1) % count]);
            for i in 0..count {
                let before =
                    if i > 0 || is_closed { Some((i + segments - 1) % segments) } else { None };
                let after = (i < segments).then_some(i);
                let beside = [before, after].into_iter().flatten();
                let penetrates = beside.clone().any(|j| own[j] > 0.0 || own[(j + 1) % count] > 0.0);
                if !(everywhere || penetrates) || clamped[edge.nodes()[start + i]] {
                    continue;
                }
                let average = match (before, after) {
                    (Some(j), Some(k)) => {
                        let (l, m) = (length(j), length(k));
                        (m * mean(j) + l * mean(k)) / (l + m)
                    }
                    _ => beside.map(mean).sum(),
                };
                correction[start + i] = own[i] - average.min(0.0);
            }
        }
        let w = problem.extension(&correction)?;
        let moved: Vec<f64> = displacement.iter().zip(&w).map(|(v, w)| v - w).collect();
        let left = self.overlap(problem, &moved)?;
        correction.iter_mut().zip(left).for_each(|(sum, more)| *sum += more);
        Ok(correction)
    }

    /// For every contact node a δ, 0 at clamped ones, with Σ δ_i φ_i ≥ (v_N − g)₊, g taken at the
    /// points of the edge rule and at the nodes.
    fn overlap(&self, problem: &ContactProblem, displacement: &[f64]) -> Result<Vec<f64>> {
        let mut at = vec![0.0_f64; self.mesh.nodes().len()];
        let clamped = self.mesh.nodes_on(Part::Dirichlet);
        let largest = displacement.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
        for border in self.borders.iter().filter(|border| border.part == Part::Contact) {
            let nodes =
                [0, 1].map(|end| self.mesh.triangles()[border.triangle][(border.side + end) % 3]);
            let values = self.normal_at(border, displacement);
            let [a, b] = nodes.map(|node| self.mesh.nodes()[node]);
            let off = |s: f64| -> Result<f64> {
                let gap = self.body.gap_at(
                    self.mesh.group(border.number),
                    [a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1])],
                )?;
                Ok((1.0 - s) * values[0] + s * values[1] - gap)
            };
            let is_free = nodes.map(|node| !clamped[node]);
            let end = |k: usize, s: f64| -> Result<f64> {
                let excess = off(s)?;
                match (is_free[k], excess > ROUNDED * largest) {
                    (true, _) => Ok(excess.max(0.0)),
                    (false, false) => Ok(0.0),
                    (false, true) => Err(Error::BeyondFloor {
                        place: self.mesh.nodes()[nodes[k]],
                        displacement: values[k],
                        gap: values[k] - excess,
                    }),
                }
            };
            let ends = [end(0, 0.0)?, end(1, 1.0)?];
            let mut inside = 0.0_f64;
            for (s, _) in self.edge_rule.iter() {
                let excess = off(s)? - (1.0 - s) * ends[0] - s * ends[1];
                let share =
                    if is_free[0] { 1.0 - s } else { 0.0 } + if is_free[1] { s } else { 0.0 };
                if share > 0.0 {
                    inside = inside.max(excess / share);
                } else if excess > ROUNDED * largest {
                    let reason = format!(
                        "the gap near ({}, {}) is smaller than the displacement between two clamped \
                         nodes: refine the contact edge there",
                        a[0], a[1]
                    );
                    return Err(Error::Solver { reason });
                }
            }
            // A curved gap between the points of the rule exceeds its values there by a few percent
            // at most.
            for k in (0..2).filter(|&k| is_free[k]) {
                at[nodes[k]] = at[nodes[k]].max(ends[k] + 1.1 * inside);
            }
        }
        Ok(problem.edge().nodes().iter().map(|&node| at[node]).collect())
    }

    /// Energies of w by triangle.
    fn add_shares(&self, shares: &mut [f64], w: &[f64]) {
        for (t, share) in shares.iter_mut().enumerate() {
            let (inner, stress) = (self.compliance(t), self.stress_of(t, w));
            let area = 0.5 * crate::mesh::doubled_area(self.mesh.corners(t));
            *share += area * inner(&stress, &stress);
        }
    }

    /// Values at the borders in the order of the contact edge.
    fn in_order(&self, problem: &ContactProblem, pressure: &[[f64; 2]]) -> Vec<[f64; 2]> {
        let mut place = vec![usize::MAX; self.mesh.nodes().len()];
        problem.edge().nodes().iter().enumerate().for_each(|(i, &node)| place[node] = i);
        let mut found: Vec<(usize, [f64; 2])> = self
            .borders
            .iter()
            .zip(pressure)
            .filter(|(border, _)| border.part == Part::Contact)
            .map(|(border, &pressure)| {
                (place[self.mesh.triangles()[border.triangle][border.side]], pressure)
            })
            .collect();
        found.sort_by_key(|(start, _)| *start);
        found.into_iter().map(|(_, pressure)| pressure).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fem::{Form, Lame};
    use crate::mesh::{Point, SideParts, unit_square};

    fn elastic() -> Form {
        Form::Elastic { materials: vec![Lame::new(1.0, 1.0).unwrap()] }
    }

    fn solved(body: &Body<'_>, cone: Cone) -> (ContactProblem, ContactSolution) {
        let problem = body.problem().unwrap();
        let solution = problem.solve(cone, Solver::ActiveSet).unwrap();
        (problem, solution)
    }

    #[test]
    fn corrections_lead_into_the_cone() {
        let clamped = SideParts { left: Part::Dirichlet, ..SideParts::HANGING };
        for (sides, cone) in [SideParts::HANGING, clamped]
            .into_iter()
            .flat_map(|sides| Cone::ALL.map(|cone| (sides, cone)))
        {
            // A convex gap is penetrated between the nodes.
            let body = Body::new(unit_square(8, sides).unwrap(), elastic())
                .load(|_: Point| [0.0, -1.0])
                .gap(|[x, _]| 0.3 * x * x);
            let (problem, solution) = solved(&body, cone);
            let setting = Setting::new(&body, body.mesh(), Traction::Reduced).unwrap();
            let off = |displacement: &[f64]| {
                let overlap = setting.overlap(&problem, displacement).unwrap();
                overlap.into_iter().fold(0.0, f64::max)
            };
            let u = &solution.displacement;
            assert!(off(u) > 1e-4, "{cone}: {}", off(u));
            let corrections = [
                setting.overlap(&problem, u).unwrap(),
                setting.averages(&problem, u, true).unwrap(),
                setting.averages(&problem, u, false).unwrap(),
            ];
            for normal in corrections {
                let w = problem.extension(&normal).unwrap();
                let moved: Vec<f64> = u.iter().zip(&w).map(|(u, w)| u - w).collect();
                assert!(off(&moved) < 1e-14, "{cone}: {:e}", off(&moved));
            }
        }
    }

    /// On segments of equal length the averages differ from u^h by a quarter of its second
    /// difference.
    #[test]
    fn averages_take_off_second_differences() {
        let body = Body::new(unit_square(32, SideParts::HANGING).unwrap(), elastic())
            .load(|[x, _]: Point| [0.0, -(std::f64::consts::PI * x).cos()]);
        let (problem, solution) = solved(&body, Cone::Midpoint);
        let setting = Setting::new(&body, body.mesh(), Traction::Reduced).unwrap();
        let u = &solution.displacement;
        let v = problem.normal_displacement(u).unwrap();
        let [w, beside] =
            [true, false].map(|everywhere| setting.averages(&problem, u, everywhere).unwrap());
        for i in 1..v.len() - 1 {
            let second = v[i - 1] - 2.0 * v[i] + v[i + 1];
            // The means of active segments are 0 to rounding.
            assert!((w[i] + 0.25 * second).abs() < 1e-15, "{i}: {} {second}", w[i]);
            let penetrates = v[i - 1..=i + 1].iter().any(|v| *v > 0.0);
            assert_eq!(beside[i], if penetrates { w[i] } else { 0.0 });
        }
        assert!(v.iter().filter(|v| **v > 0.0).count() > 5);
        let found = setting.best_stress(&setting.touching(&problem, Cone::Midpoint, &solution));
        let dual = found.unwrap();
        let bound = |normal: &[f64]| {
            setting.bounded(&problem, &solution, &dual, Some(normal)).unwrap().error
        };
        let parts = setting.overlap(&problem, u).unwrap();
        assert!(bound(&beside) < bound(&parts), "{} {}", bound(&beside), bound(&parts));
    }

    #[test]
    fn roots_of_the_compliance() {
        let mesh = || unit_square(1, SideParts::HANGING).unwrap();
        for form in
            [Form::LAPLACE, elastic(), Form::elastic(Lame::plane_strain(3.0, 0.4999).unwrap())]
        {
            let is_flux = form.components() == 1;
            let body = Body::new(mesh(), form);
            let setting = Setting::new(&body, body.mesh(), Traction::Reduced).unwrap();
            let (inner, root) = (setting.compliance(0), setting.compliance_root(0));
            let last = if is_flux { [0.0; 2] } else { [0.3, -0.7] };
            let (s, t) = ([1.0, 2.0, last[0]], [-0.4, 1.3, last[1]]);
            let product: f64 = root(&s).iter().zip(root(&t)).map(|(a, b)| a * b).sum();
            assert!((product - inner(&s, &t)).abs() < 1e-15 * inner(&s, &s).abs().max(1.0));
            assert!(inner(&s, &s) > 0.0);
            if let Some(material) = setting.material(0) {
                // 𝒜⁻¹ of σ(v) is ε(v), for the gradient [[0.2, −0.1], [0.5, 0.4]].
                let stress = setting.stress_from(0, [[0.2, -0.1], [0.5, 0.4]]);
                let (e, trace) = ([0.2, 0.4, 0.2], 0.6);
                let square = material.lambda() * trace * trace
                    + 2.0 * material.mu() * (e[0] * e[0] + e[1] * e[1] + 2.0 * e[2] * e[2]);
                assert!((inner(&stress, &stress) / square - 1.0).abs() < 1e-10);
            }
        }
    }
}
