//! The V-cycle: one Gauss-Seidel sweep, correction on the coarser level, one sweep backwards. It is
//! symmetric, as conjugate gradients require, and is computed in f32 for residuals scaled to one.

use super::super::problem::ContactProblem;
use super::coarsest::Coarsest;
use super::face::Sawtooth;
use super::level::{Level, Sweep};
use super::link::Link;
use super::vectors::{largest, rounded};
use crate::error::Result;

/// The workspace of a cycle on one level.
struct Work {
    x: Vec<f32>,
    b: Vec<f32>,
    residual: Vec<f32>,
    /// Unknowns prescribed, and unknowns fixed by contact.
    fixed: Vec<bool>,
    /// Places of u_N along the contact edge, and whether they are prescribed.
    normals: Vec<(usize, bool)>,
}

/// The levels up to a given one, with the unknowns fixed by a contact set.
///
/// One V-cycle C with a forward sweep M before and M' after the correction: I − C K = (I − M⁻ᵀK)(I − P C_c
/// P'K)(I − M⁻¹K), C_c the cycle of the coarser level and the exact inverse on the coarsest; C is symmetric positive
/// definite.
pub(super) struct Cycle<'a, L> {
    levels: &'a [L],
    links: &'a [Link],
    coarsest: &'a mut Coarsest,
    coarse_places: &'a [usize],
    work: Vec<Work>,
    sawtooths: Vec<Sawtooth>,
}

impl<'a, L: Level> Cycle<'a, L> {
    /// The cycle for levels 0 to k, with their `problems`.
    pub(super) fn new(
        levels: &'a [L],
        problems: &[&ContactProblem],
        links: &'a [Link],
        coarsest: &'a mut Coarsest,
        coarse_places: &'a [usize],
    ) -> Self {
        let work =
            levels.iter().zip(problems).map(|(level, problem)| Work::new(level, problem)).collect();
        Self { levels, links, coarsest, coarse_places, work, sawtooths: Vec::new() }
    }

    /// Fixes the unknowns of the contact set.
    pub(super) fn hold(&mut self, part: &[bool], sawtooths: Vec<Sawtooth>) -> Result<()> {
        self.sawtooths = sawtooths;
        let mut held = part.to_vec();
        for (k, work) in self.work.iter_mut().enumerate().rev() {
            for (&(place, prescribed), &held) in work.normals.iter().zip(&held) {
                work.fixed[place] = prescribed || held;
            }
            if k == 0 {
                held.iter_mut()
                    .zip(&work.normals)
                    .for_each(|(held, &(_, prescribed))| *held |= prescribed);
            } else {
                held = self.links[k - 1].touched(&held);
            }
        }
        self.coarsest.hold(&held)
    }

    /// An approximation z ≈ K⁻¹ r on the free unknowns: the returned vector times the returned factor. Zero for
    /// r = 0.
    pub(super) fn apply(&mut self, r: &[f64]) -> (&[f32], f64) {
        let top = self.work.len() - 1;
        let size = largest(r);
        if size > 0.0 && size.is_finite() {
            rounded(&mut self.work[top].b, 1.0 / size, r);
            // On a contact interval r is the contact force, and its component along the amplitude may be below
            // rounding in f32.
            for saw in &self.sawtooths {
                saw.force(r, 1.0 / size, &mut self.work[top].b);
            }
            self.descend(top);
        } else {
            self.work[top].x.fill(0.0);
        }
        (&self.work[top].x, size / self.levels[top].unit())
    }

    fn descend(&mut self, k: usize) {
        if k == 0 {
            return self.solve_coarsest();
        }
        let level = &self.levels[k];
        let is_top = k + 1 == self.work.len();
        let saws: &[Sawtooth] = if is_top { &self.sawtooths } else { &[] };
        let (coarse, fine) = self.work.split_at_mut(k);
        let (Some(coarse), Some(work)) = (coarse.last_mut(), fine.first_mut()) else { return };
        work.x.fill(0.0);
        saws.iter().for_each(|saw| saw.relax(&mut work.x, &work.b));
        level.sweep(&mut work.x, &work.b, &work.fixed, Sweep::Forward);
        level.residual(&work.x, &work.b, &mut work.residual);
        level.restrict(&work.residual, &mut coarse.b);
        let ratio = (level.unit() / self.levels[k - 1].unit()) as f32;
        if ratio != 1.0 {
            coarse.b.iter_mut().for_each(|b| *b *= ratio);
        }
        self.descend(k - 1);
        let (coarse, fine) = self.work.split_at_mut(k);
        let (Some(coarse), Some(work)) = (coarse.last(), fine.first_mut()) else { return };
        level.prolong(&coarse.x, &mut work.x);
        level.sweep(&mut work.x, &work.b, &work.fixed, Sweep::Backward);
        let saws: &[Sawtooth] = if is_top { &self.sawtooths } else { &[] };
        saws.iter().rev().for_each(|saw| saw.relax(&mut work.x, &work.b));
    }

    fn solve_coarsest(&mut self) {
        let (level, work) = (&self.levels[0], &mut self.work[0]);
        let b: Vec<f64> =
            self.coarse_places.iter().map(|&place| f64::from(work.b[place])).collect();
        for (&place, x) in self.coarse_places.iter().zip(self.coarsest.solve(&b)) {
            work.x[place] = (x * level.unit()) as f32;
        }
    }
}

impl Work {
    fn new<L: Level>(level: &L, problem: &ContactProblem) -> Self {
        let zeros = || vec![0.0; level.unknowns()];
        let mut fixed = vec![false; level.unknowns()];
        for (unknown, _) in problem.prescribed.iter().enumerate().filter(|&(_, &held)| held) {
            fixed[level.place(unknown)] = true;
        }
        let normals = problem.normal_unknowns().into_iter();
        let normals =
            normals.map(|unknown| (level.place(unknown), problem.prescribed[unknown])).collect();
        Self { x: zeros(), b: zeros(), residual: zeros(), fixed, normals }
    }
}
