//! A mesh that is fine where the bound requires it: solve, bound, mark a share of the bound,
//! bisect.

use super::element::Traction;
use super::enclosure::Enclosure;
use crate::cone::{Cone, ContactSet};
use crate::contact::Body;
use crate::error::{Error, Result};
use crate::mesh::{ContactEdge, Hierarchy, Triangulation, doubled_area};
use fractional_sobolev::{Estimate, Work};

/// Share of the tolerance that the expected bound of the last mesh is to meet.
const AIMED: f64 = 0.98;

/// Share of the stress in the square of the bound where it is not known yet.
const USUAL: f64 = 0.3;
/// Share of what is wanted that the stress of the mesh before the last is to have.
const STRESS: f64 = 0.45;
/// The largest factor from the mesh of the last stress to the last mesh.
const FARTHEST: f64 = 10.0;

/// How a mesh is refined to a tolerance, and where it ends.
///
/// On the same mesh the stress requires several times the work of the displacement. Where its error
/// is the smaller part of the bound, as it mostly is, the last displacement is bounded by the
/// stress of a mesh before, which is a stress of the refinement as well, and no stress is computed
/// on the last mesh; not so for `growth` 1, for uniform refinement, and where the stress turns out
/// to be too coarse. [`Body::contact_force`](crate::contact::Body::contact_force) and the other
/// results of an [`Enclosure`] hold as they stand.
///
/// ```
/// use signorini::{bounds::Refinement, contact::Body, fem::{Form, Lame}};
/// use signorini::mesh::{SideParts, unit_square};
/// let body = Body::new(unit_square(4, SideParts::HANGING)?, Form::elastic(Lame::new(1.0, 1.0)?))
///     .load(|[x, _]: [f64; 2]| [0.0, -(std::f64::consts::PI * x).cos()]);
/// let found = Refinement { tolerance: 0.2, ..Refinement::default() }.solve(&body)?;
/// assert!(found.relative_error() <= 0.2);
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Refinement {
    /// The discrete cone.
    pub cone: Cone,
    /// Tractions of the stress.
    pub tractions: Traction,
    /// The guaranteed error in the energy norm relative to |||u||| at which the refinement ends.
    pub tolerance: f64,
    /// Largest number of unknowns of the discrete problem; the mesh that exceeds it is not solved
    /// on.
    pub unknowns: usize,
    /// Share of the square of the bound whose triangles are bisected; 1: all triangles (uniform
    /// refinement).
    pub share: f64,
    /// Least factor by which the number of triangles grows from one solution to the next: triangles
    /// are bisected again by the shares that are to be expected of the pieces. 1: the share is
    /// bisected once.
    pub growth: f64,
}

impl Default for Refinement {
    fn default() -> Self {
        Self {
            cone: Cone::Nodal,
            tractions: Traction::default(),
            tolerance: 0.01,
            unknowns: 1_000_000,
            share: 0.5,
            growth: 4.0,
        }
    }
}

/// Why the refinement ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ended {
    /// The tolerance is met.
    Tolerance,
    /// The next mesh would have more unknowns than allowed.
    Unknowns,
    /// Rounding exceeds a tenth of the tolerance.
    Rounding,
}

impl std::fmt::Display for Ended {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Ended::Tolerance => "the tolerance is met",
            Ended::Unknowns => "the limit of unknowns is reached",
            Ended::Rounding => "rounding is reached",
        })
    }
}

impl Refinement {
    /// The solution on the first mesh whose guaranteed error is within the tolerance.
    ///
    /// # Errors
    /// [`ToolkitError::ToleranceNotMet`](crate::ToolkitError::ToleranceNotMet) with the best J(u)
    /// if the refinement ended otherwise; as for [`Refinement::run`].
    pub fn solve(&self, body: &Body<'_>) -> Result<Enclosure> {
        let (found, ended) = self.run(body, |_| {})?;
        let why = match ended {
            Ended::Tolerance => return Ok(found),
            Ended::Unknowns => "more unknowns are required than allowed",
            Ended::Rounding => "rounding is reached",
        };
        let best = Estimate {
            value: 0.5 * (found.energy.lower + found.energy.upper),
            error: 0.5 * found.energy.width(),
            work: Work::default(),
        };
        Err(Error::not_met("energy J of the body", self.tolerance, best, why))
    }

    /// The solution with the smallest bound, and why the refinement ended.
    ///
    /// `each` receives the result on every mesh on which a stress was computed, and at the end the
    /// one that is returned, if it is bounded by the stress of the mesh before. A mesh that was too
    /// coarse for that stress to end the refinement is not reported before it has a stress of its
    /// own.
    ///
    /// # Errors
    /// As for [`Body::enclose`]; [`ToolkitError::OutOfRange`](crate::ToolkitError::OutOfRange) for
    /// a tolerance that is not positive or a share outside of (0, 1].
    pub fn run(
        &self,
        body: &Body<'_>,
        mut each: impl FnMut(&Enclosure),
    ) -> Result<(Enclosure, Ended)> {
        Error::require("tolerance", self.tolerance, "(0, inf)", self.tolerance > 0.0)?;
        Error::require("share", self.share, "(0, 1]", self.share > 0.0 && self.share <= 1.0)?;
        let mut meshes = Hierarchy::new(body.mesh().clone());
        let per_node = body.form().components();
        let fits = |meshes: &Hierarchy| meshes.finest().nodes().len() * per_node <= self.unknowns;
        let mut solved = body.solved_on(meshes.finest(), self.cone, None)?;
        // The square of the bound that was expected on this mesh.
        let (mut expected, mut bias) = (None, 1.0);
        let mut before = None;
        loop {
            let found = body.enclosed(self.cone, self.tractions, solved)?;
            each(&found);
            if found.relative_error() <= self.tolerance {
                return Ok((found, Ended::Tolerance));
            }
            // On a coarse mesh the lower bound of |||u||| may be 0.
            if found.rounding > 0.1 * self.tolerance * found.norm.upper {
                return Ok((found, Ended::Rounding));
            }
            meshes.forget();
            if self.share >= 1.0 {
                meshes.refine()?;
                if !fits(&meshes) {
                    return Ok((found, Ended::Unknowns));
                }
                let guess = self.guess(&meshes, &found)?;
                solved = body.solved_on(meshes.finest(), self.cone, guess)?;
                continue;
            }
            let total = found.shares.iter().sum::<f64>();
            if let Some(expected) = expected {
                bias = total / expected;
            }
            let wanted = (AIMED * self.tolerance * found.norm.lower).powi(2);
            let now = Now::of(&found);
            let of_stress = now.share_of_stress(before.as_ref());
            before = Some(now);
            // On the last mesh |||u − v|||² and, on this one, |||σ(u) − q|||² have to add up to what is
            // wanted.
            let stress = of_stress * total;
            let is_last = |displacement: f64| {
                self.growth > 1.0 && displacement <= FARTHEST * (wanted - stress)
            };
            if !is_last(total - stress) {
                let target =
                    (STRESS * wanted / of_stress).clamp(wanted, 0.5 * total.max(2.0 * wanted));
                let grown = self.grow(&mut meshes, &found.shares, target / bias, self.growth)?;
                if !fits(&meshes) {
                    return Ok((found, Ended::Unknowns));
                }
                expected = Some(grown.expected);
                let guess = self.guess(&meshes, &found)?;
                solved = body.solved_on(meshes.finest(), self.cone, guess)?;
                continue;
            }
            let mut origins: Vec<u32> = (0..found.shares.len() as u32).collect();
            let (mut shares, mut displacement) = (found.shares.clone(), total - stress);
            // The result by the stress of `found` on the finest mesh so far.
            let mut last: Option<Enclosure> = None;
            loop {
                let sum: f64 = shares.iter().sum();
                let target = sum * ((wanted - stress) / displacement).min(0.9);
                let grown = self.grow(&mut meshes, &shares, target, f64::INFINITY)?;
                if !fits(&meshes) {
                    let better = last.filter(|last| last.error < found.error);
                    better.iter().for_each(&mut each);
                    return Ok((better.unwrap_or(found), Ended::Unknowns));
                }
                origins = grown.origins.iter().map(|&origin| origins[origin as usize]).collect();
                let guess = self.guess(&meshes, &found)?;
                solved = body.solved_on(meshes.finest(), self.cone, guess)?;
                let next = body.enclosed_by(self.cone, &found, origins.clone(), solved)?;
                if next.relative_error() <= self.tolerance {
                    each(&next);
                    return Ok((next, Ended::Tolerance));
                }
                displacement = next.shares.iter().sum::<f64>() - stress;
                // The estimate of the stress was wrong: another one, on this mesh.
                if !is_last(displacement) || displacement <= wanted - stress {
                    expected = None;
                    solved = (next.problem, next.solution);
                    break;
                }
                shares.clone_from(&next.shares);
                last = Some(next);
            }
        }
    }

    /// The active nodes to start from on the finest mesh.
    fn guess(&self, meshes: &Hierarchy, found: &Enclosure) -> Result<Option<ContactSet>> {
        (self.cone == Cone::Nodal).then(|| refined_set(meshes, found)).transpose()
    }

    /// Bisects the triangles that carry the share of the bound, and again with the shares that are
    /// to be expected, until the mesh has `growth` times as many triangles or the square of the
    /// bound is expected to be as wanted.
    ///
    /// A share is of the order of the square of the area, so that of a piece is that of its origin
    /// times the square of its part of the area.
    fn grow(
        &self,
        meshes: &mut Hierarchy,
        shares: &[f64],
        wanted: f64,
        growth: f64,
    ) -> Result<Grown> {
        let enough = growth * shares.len() as f64;
        let mut shares = shares.to_vec();
        let mut origins: Vec<u32> = (0..shares.len() as u32).collect();
        loop {
            let marked = bulk(&shares, self.share, wanted);
            meshes.refine_where(|_, t| marked[t])?;
            let [.., coarse, fine] = meshes.levels() else {
                return Ok(Grown { expected: wanted, origins });
            };
            let area = |mesh: &Triangulation, t: usize| doubled_area(mesh.corners(t));
            shares = meshes
                .origins()
                .iter()
                .enumerate()
                .map(|(t, &origin)| {
                    let part = area(fine, t) / area(coarse, origin as usize);
                    part * part * shares[origin as usize]
                })
                .collect();
            origins = meshes.origins().iter().map(|&origin| origins[origin as usize]).collect();
            let expected = shares.iter().sum();
            if shares.len() as f64 >= enough || expected <= wanted {
                return Ok(Grown { expected, origins });
            }
        }
    }
}

/// A grown mesh: the square of the bound to be expected, and the triangle of the mesh before in
/// which each lies.
struct Grown {
    expected: f64,
    origins: Vec<u32>,
}

/// Unknowns and energies of one mesh.
struct Now {
    unknowns: f64,
    upper: f64,
    lower: f64,
}

impl Now {
    fn of(found: &Enclosure) -> Self {
        let unknowns = found.problem.free_unknowns() as f64;
        Self { unknowns, upper: found.energy.upper, lower: found.energy.lower }
    }

    /// The share of |||σ(u) − q|||² + 2∫ q_N (u_N − g) = 2 (J(u) − J*(q)) in 2 (J(v) − J*(q)), with
    /// J(u) extrapolated from two meshes: J(v) − J(u) is taken to be of the order 1/N. An estimate
    /// by which only the size of the next mesh is chosen.
    fn share_of_stress(&self, before: Option<&Self>) -> f64 {
        let Some(before) = before else { return USUAL };
        let ratio = self.unknowns / before.unknowns;
        let energy = (ratio * self.upper - before.upper) / (ratio - 1.0);
        let share = (energy - self.lower) / (self.upper - self.lower);
        if ratio > 1.5 && share.is_finite() { share.clamp(0.03, 0.7) } else { USUAL }
    }
}

/// The fewest triangles that carry the given share of the sum, or fewer if that is enough for the
/// sum to fall to what is wanted: four quarters of a triangle have together a quarter of its share.
fn bulk(shares: &[f64], share: f64, wanted: f64) -> Vec<bool> {
    let mut order: Vec<usize> = (0..shares.len()).collect();
    order.sort_unstable_by(|&a, &b| shares[b].total_cmp(&shares[a]));
    let total: f64 = shares.iter().sum();
    let mut marked = vec![false; shares.len()];
    let mut sum = 0.0;
    for t in order {
        marked[t] = true;
        sum += shares[t];
        if sum >= share * total || total - 0.75 * sum <= wanted {
            break;
        }
    }
    marked
}

/// The active nodes on the refined mesh: those of the coarse one, and new ones between two of them.
fn refined_set(meshes: &Hierarchy, found: &Enclosure) -> Result<ContactSet> {
    let mut active = vec![false; meshes.levels()[0].nodes().len()];
    for (i, &node) in found.problem.edge().nodes().iter().enumerate() {
        active[node] = found.solution.contact_set.contains(i);
    }
    for level in 1..meshes.levels().len() {
        let parents = meshes.parents(level);
        let between =
            parents[active.len()..].iter().map(|&[a, b]| active[a as usize] && active[b as usize]);
        let new: Vec<bool> = between.collect();
        active.extend(new);
    }
    let edge = ContactEdge::in_pieces(meshes.finest())?;
    Ok(ContactSet::new(&edge.nodes().iter().map(|&node| active[node]).collect::<Vec<_>>()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fem::{Form, Lame};
    use crate::mesh::{Point, SideParts, unit_square};

    fn block() -> Body<'static> {
        let form = Form::elastic(Lame::new(1.0, 1.0).unwrap());
        Body::new(unit_square(4, SideParts::HANGING).unwrap(), form)
            .load(|[x, _]: Point| [0.0, -(std::f64::consts::PI * x).cos()])
    }

    /// Where the limit of unknowns is reached after a mesh that was bounded by the stress of the
    /// one before, that mesh is returned, since its bound is smaller; and it is the last one
    /// reported.
    #[test]
    fn the_limit_of_unknowns_returns_the_smallest_bound() {
        let (mut before, mut by_older_stress) = (f64::INFINITY, 0);
        for unknowns in (520..700).step_by(4) {
            let refinement = Refinement { tolerance: 0.12, unknowns, ..Refinement::default() };
            let mut reported = Vec::new();
            let (found, ended) = refinement.run(&block(), |one| reported.push(one.error)).unwrap();
            assert_eq!(found.error, reported.iter().copied().fold(f64::INFINITY, f64::min));
            assert_eq!(reported.last(), Some(&found.error));
            assert!(found.error <= before, "{unknowns}: {} {before}", found.error);
            assert!(found.problem.mesh().nodes().len() * 2 <= unknowns);
            before = found.error;
            by_older_stress += usize::from(ended == Ended::Unknowns && found.dual_steps == 0);
        }
        assert!(by_older_stress > 2, "{by_older_stress}");
    }
}
