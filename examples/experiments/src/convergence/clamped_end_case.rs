//! One body at its clamped end, solved in every way: the roads that must agree, and what they agree in.
//!
//! Errors of linear elements are of order h² in powers, energies and forces: with n and 2n angles the limit
//! is put at fine + (fine − coarse)/3, and its distance from the finer value is the estimate of its error.

use super::clamped_end::{EndMethod, EndRun};
use fractional_sobolev::{Estimate, Work};
use signorini::Result;
use signorini::cone::Cone;
use signorini::mesh::Outline;
use signorini::problems::DirichletEnd;
use signorini::singular::ContactZone;
use std::f64::consts::LN_10;

/// A scene with all its solutions.
#[derive(Debug, Clone)]
pub struct EndCase {
    /// The scene.
    pub scene: DirichletEnd,
    /// Nodal cone, active set from no contact: on the given rings, and with twice the angles and half the
    /// step.
    pub runs: [EndRun; 2],
    /// From full contact; with half the decades; on a rectangle with rings 4/5 as far apart.
    pub again: [EndRun; 3],
    /// The midpoint cone; the interior point method on the whole body, with half the decades: more it does
    /// not see.
    pub others: [EndRun; 2],
    /// The interior point method that expects r^{1/2}, on the meshes of `runs`.
    pub scaled: [EndRun; 2],
}

impl EndCase {
    /// Solves the scene, nine times.
    ///
    /// # Errors
    /// As for [`EndRun::of`].
    pub fn of(scene: DirichletEnd) -> Result<Self> {
        let finer = DirichletEnd { angles: 2 * scene.angles, step: 0.5 * scene.step, ..scene };
        let shallow = DirichletEnd { smallest: scene.smallest.sqrt(), ..scene };
        let square = DirichletEnd { outline: Outline::Rectangle, step: 0.8 * scene.step, ..scene };
        let nodal = |scene: &DirichletEnd, start| EndRun::of(scene, Cone::Nodal, start);
        Ok(Self {
            runs: [nodal(&scene, EndMethod::Open)?, nodal(&finer, EndMethod::Open)?],
            again: [
                nodal(&scene, EndMethod::Closed)?,
                nodal(&shallow, EndMethod::Open)?,
                nodal(&square, EndMethod::Open)?,
            ],
            others: [
                EndRun::of(&scene, Cone::Midpoint, EndMethod::Open)?,
                nodal(&shallow, EndMethod::Interior)?,
            ],
            scaled: [nodal(&scene, EndMethod::Scaled)?, nodal(&finer, EndMethod::Scaled)?],
            scene,
        })
    }

    /// All solutions that see every decade.
    pub fn resolved(&self) -> impl Iterator<Item = &EndRun> {
        self.runs.iter().chain(&self.again).chain(&self.others[..1]).chain(&self.scaled)
    }

    /// The most transitions of any of them.
    pub fn transitions(&self) -> usize {
        self.resolved().map(|run| run.borders().len()).max().unwrap_or(0)
    }

    /// The limit of both meshes, and how far it is from the finer one; `None` where one has no value.
    pub fn limit(&self, value: impl Fn(&EndRun) -> Option<f64>) -> Option<Estimate> {
        let [coarse, fine] = [value(&self.runs[0])?, value(&self.runs[1])?];
        let change = (fine - coarse) / 3.0;
        Estimate::new(fine + change, change.abs(), Work::default()).ok()
    }

    /// Constraints in which the sets from no contact and from full contact differ; the clamped end itself
    /// does not count, since nothing is decided there.
    pub fn starts_apart(&self) -> usize {
        let [a, b] = [&self.runs[0], &self.again[0]].map(|run| run.solution.contact_set.as_slice());
        a.iter().zip(b).skip(1).filter(|(a, b)| a != b).count()
    }

    /// Constraints on both meshes in which the interior point method that expects r^{1/2} has another set.
    pub fn solvers_apart(&self) -> usize {
        let sets = |runs: &[EndRun; 2], k: usize| runs[k].solution.contact_set.as_slice()[1..].to_vec();
        let apart =
            |k| sets(&self.runs, k).iter().zip(sets(&self.scaled, k)).filter(|(a, b)| **a != *b).count();
        apart(0) + apart(1)
    }

    /// |J' − J|/|J| of the interior point method.
    pub fn energies_apart(&self) -> f64 {
        let [a, b] = [&self.again[1], &self.others[1]].map(|run| run.solution.energy);
        (b / a - 1.0).abs()
    }

    /// The largest radius at which the interior point method has another contact set; 0 if none.
    pub fn unseen_below(&self) -> f64 {
        let [a, b] = [&self.again[1].solution, &self.others[1].solution];
        let differ = |&i: &usize| a.contact_set.contains(i) != b.contact_set.contains(i);
        (0..a.positions.len()).filter(differ).map(|i| a.positions[i]).fold(0.0, f64::max)
    }

    /// How far twice the angles move a border, relative to its decades; infinite when one is lost.
    pub fn moved(&self) -> f64 {
        let [coarse, fine] = &self.runs;
        let pairs = coarse.borders().into_iter().zip(fine.borders());
        let moved = pairs.map(|(a, b)| ((a - b) / b).abs()).fold(0.0, f64::max);
        if coarse.borders().len() == fine.borders().len() { moved } else { f64::INFINITY }
    }

    /// The logarithmic length of the gap between two stretches of contact over that at which the field of one
    /// zone closes again.
    pub fn reach(&self) -> Option<Estimate> {
        let zone = ContactZone::new(self.scene.poisson?, 1.0).ok()?;
        let gap =
            |run: &EndRun| run.intervals.get(2).map(|_| run.intervals[1].decades() * LN_10 / zone.reach());
        self.limit(gap)
    }
}
