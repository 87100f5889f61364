//! Contact on one level: truncated Newton steps, whose linear systems are solved only as accurately as the contact
//! set requires.
//!
//! First the guess is corrected on patches around the ends of its contact intervals ([`super::patch`]), so that no
//! linear system of the level is solved for a set that is locally inconsistent. A step imposes the constraints of the
//! set as equations and reduces the error by conjugate gradients; when it is reduced by a factor of 50, the signs of
//! forces and gaps determine the violated constraints, and patches around them the next set. If the patches change
//! nothing, the next set follows from the signs, as in the condensed active set method. When the set does not change,
//! the conjugate gradients continue to the requested accuracy. If a set recurs, the error is reduced further, then
//! constraints are exchanged one at a time.

use super::super::active_set::changed;
use super::super::problem::ContactProblem;
use super::cycle::Cycle;
use super::edge::{Contact, Edge};
use super::face::FreePart;
use super::gradients::Gradients;
use super::level::Level;
use super::patch;
use super::vectors::{dot, subtract_from};
use crate::cone::{Cone, ContactSet, Status};
use crate::error::Result;
use std::collections::HashSet;

/// Factor by which the error of a step is reduced before the signs are used.
const DECIDED: f64 = 0.02;
/// Factor by which the error is reduced further when a set recurs.
const SHARPER: f64 = 1e-3;
/// Smallest factor to which the error is reduced before the signs are used.
const SHARPEST: f64 = 1e-10;
/// Largest number of steps.
pub(super) const STEPS: usize = 60;
/// Fraction of the solution below which the initial error counts as zero: a patch may cover a whole coarse body.
const SOLVED: f64 = 1e-8;
/// Largest number of restarts from the true residual before the requested accuracy counts as not reached.
const TRIES: usize = 3;
/// Fraction of the requested accuracy at which the conjugate gradients stop; if the accuracy is then missed, at most
/// a half and at least a tenth of it.
const SPARE: f64 = 0.4;
const LESS: (f64, f64) = (0.1, 0.5);
/// Largest number of conjugate gradient steps for one set: sufficient for 1e-12 at a convergence factor of 0.9.
const GRADIENT_STEPS: usize = 300;
/// Largest value of κ that is assumed, and the fraction of its estimate that is used.
const KAPPA: f64 = 0.15;
const RELIED: f64 = 0.7;

pub(super) struct Stage<'s, 'c, L> {
    problem: &'s ContactProblem,
    level: &'s L,
    cycle: &'s mut Cycle<'c, L>,
    edge: Edge,
    /// F in the layout of the level.
    load: Vec<f64>,
    /// The prescribed unknowns, in the layout of the level.
    prescribed: Vec<usize>,
    /// The value of κ on coarser levels.
    least: f64,
    /// The reliability of the guess; the signs are used by default.
    pub(super) guess: Guess,
    /// The dual norm of the rounding errors in a residual: no smaller residual is requested.
    pub(super) floor: f64,
}

/// The reliability of a guess of the set.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Guess {
    /// The signs of forces and gaps are used, for this many steps.
    Signs(usize),
    /// The set is known; inexact forces do not change it.
    Known,
}

/// The stopping criterion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Goal {
    /// Energy norm of the error, relative to that of the solution.
    Relative(f64),
    /// Energy norm of the error.
    Absolute(f64),
    /// Energy norm of the error, relative to the initial error.
    Share(f64),
}

/// The result of the iteration on a level.
pub(super) struct Outcome {
    pub(super) set: ContactSet,
    pub(super) multiplier: Vec<f64>,
    pub(super) status: Status,
    pub(super) history: Vec<ContactSet>,
    pub(super) gradient_steps: usize,
    /// The smallest eigenvalue of cycle times K found so far.
    pub(super) least: f64,
    /// |u|_a.
    pub(super) norm: f64,
    pub(super) error: f64,
    pub(super) energy: f64,
}

/// Norm and energy of an iterate.
#[derive(Debug, Clone, Copy, Default)]
struct Sizes {
    norm: f64,
    energy: f64,
}

impl<'s, 'c, L: Level> Stage<'s, 'c, L> {
    pub(super) fn new(
        problem: &'s ContactProblem,
        level: &'s L,
        cycle: &'s mut Cycle<'c, L>,
        cone: Cone,
        (least, condensed): (f64, f64),
    ) -> Self {
        let mut load = vec![0.0; problem.load.len()];
        problem.load.iter().enumerate().for_each(|(unknown, &f)| load[level.place(unknown)] = f);
        let held = (0..load.len()).filter(|&unknown| problem.prescribed[unknown]);
        let prescribed = held.map(|unknown| level.place(unknown)).collect();
        Self {
            problem,
            level,
            cycle,
            edge: Edge::new(problem, level, cone, condensed),
            load,
            prescribed,
            least,
            guess: Guess::Signs(STEPS),
            floor: 0.0,
        }
    }

    /// The solution, starting from an iterate and a guess of the set; `report` is called with the step and the
    /// estimated error.
    pub(super) fn solve(
        &mut self,
        x: &mut [f64],
        start: ContactSet,
        goal: Goal,
        report: &mut dyn FnMut(usize, f64) -> Result<()>,
    ) -> Result<Outcome> {
        let mut gradients = Gradients::new(x.len(), self.least);
        let (mut set, mut history, mut seen) = (start, Vec::new(), HashSet::new());
        if self.guess != Guess::Known {
            self.hold(x, &set);
            let ends: Vec<usize> =
                set.runs().into_iter().flat_map(|run| [run.start, run.end - 1]).collect();
            self.mend(x, &mut set, &ends)?;
        }
        let (mut decided, mut one_at_a_time, mut fewest) = (DECIDED, false, usize::MAX);
        let (mut gradient_steps, mut tries, mut first, mut spare) = (0, 0, None, SPARE);
        loop {
            if history.last() != Some(&set) {
                history.push(set.clone());
            }
            let sizes = self.begin(x, &set, &mut gradients)?;
            let first = *first.get_or_insert(error_of(&gradients));
            let goal = match goal {
                Goal::Absolute(error) => error,
                Goal::Share(share) => share * first.max(SOLVED * sizes.norm),
                Goal::Relative(relative) => relative * sizes.norm,
            }
            .max(self.floor / relied(self.least).sqrt()); // as `error_of` divides by it
            let (mut steps_here, mut before) = (0, error_of(&gradients));
            let (wrong, stuck) = loop {
                let wanted = (decided * before).max(spare * goal);
                let mut stuck = false;
                while error_of(&gradients) > wanted && !stuck {
                    stuck =
                        steps_here >= GRADIENT_STEPS || !gradients.step(self.level, self.cycle, x);
                    steps_here += 1;
                }
                before = error_of(&gradients);
                report(history.len(), before)?;
                let wrong = match self.guess {
                    Guess::Known => Vec::new(),
                    _ => self.edge.contact(x, &gradients.residual, &set).wrong,
                };
                if !wrong.is_empty() || stuck || before <= spare * goal {
                    break (wrong, stuck);
                }
            };
            gradient_steps += steps_here;
            let came_back = !wrong.is_empty() && !seen.insert(set.clone());
            let in_vain = matches!(self.guess, Guess::Signs(steps) if history.len() >= steps);
            let given_up = stuck || in_vain || history.len() >= STEPS;
            if wrong.is_empty() || given_up {
                tries += 1;
                let outcome = self.end(x, &set, &mut gradients, goal)?;
                if outcome.status.is_converged() || given_up || tries > TRIES {
                    let status = match outcome.status {
                        Status::Converged => Status::Converged,
                        _ if history.len() >= STEPS => Status::StepLimit { steps: history.len() },
                        status => status,
                    };
                    return Ok(Outcome { set, status, history, gradient_steps, ..outcome });
                }
                decided = (decided * SHARPER).max(SHARPEST);
                spare *= (LESS.1 * goal / outcome.error).clamp(LESS.0, LESS.1);
                continue;
            }
            if wrong.len() < fewest {
                fewest = wrong.len();
                one_at_a_time = false;
            } else if came_back {
                one_at_a_time = decided <= SHARPEST;
                decided = (decided * SHARPER).max(SHARPEST);
            }
            let contact = self.edge.contact(x, &gradients.residual, &set);
            let mut next = set.clone();
            if !came_back && !one_at_a_time {
                self.mend(x, &mut next, &wrong)?;
            }
            set = if one_at_a_time {
                changed(&set, &wrong[..1])
            } else if next == set {
                self.edge.next_set(x, &set, &contact)?
            } else {
                next
            };
        }
    }

    /// Changes the iterate so that the constraints of the set hold.
    fn hold(&self, x: &mut [f64], set: &ContactSet) -> FreePart {
        let slack = self.edge.slack(x);
        let part = FreePart::new(
            self.problem,
            self.level,
            (self.edge.cone, set),
            &slack,
            &self.edge.fixed,
        );
        self.edge.add(x, &part.change);
        part
    }

    /// Corrects the set near the given constraints, and the iterate accordingly.
    fn mend(&self, x: &mut [f64], set: &mut ContactSet, constraints: &[usize]) -> Result<()> {
        patch::mend((self.problem, self.level, &self.edge, &self.load), x, set, constraints)
    }

    /// Moves the iterate to the face of the set and starts the conjugate gradients there.
    fn begin(
        &mut self,
        x: &mut [f64],
        set: &ContactSet,
        gradients: &mut Gradients,
    ) -> Result<Sizes> {
        let part = self.hold(x, set);
        self.cycle.hold(&part.held, part.sawtooths)?;
        let sizes = self.residual(x, &mut gradients.residual);
        gradients.start(self.cycle);
        Ok(sizes)
    }

    /// Estimates the error of the iterate from its true residual.
    fn end(
        &mut self,
        x: &[f64],
        set: &ContactSet,
        gradients: &mut Gradients,
        goal: f64,
    ) -> Result<Outcome> {
        let least = gradients.least();
        let Sizes { norm, energy } = self.residual(x, &mut gradients.residual);
        let contact = self.edge.contact(x, &gradients.residual, set);
        let error = self.estimate(&contact, gradients, least)?;
        let relative = if norm > 0.0 { error / norm } else { 0.0 };
        let status =
            if error <= goal { Status::Converged } else { Status::Stalled { residual: relative } };
        Ok(Outcome {
            set: ContactSet::default(),
            multiplier: contact.multiplier,
            status,
            history: Vec::new(),
            gradient_steps: 0,
            least,
            norm,
            error,
            energy,
        })
    }

    /// out ← F − K x, zero at prescribed unknowns.
    fn residual(&self, x: &[f64], out: &mut [f64]) -> Sizes {
        self.level.multiply(x, out);
        let square = dot(x, out);
        subtract_from(out, &self.load);
        self.prescribed.iter().for_each(|&place| out[place] = 0.0);
        Sizes { norm: square.max(0.0).sqrt(), energy: 0.5 * square - dot(x, &self.load) }
    }

    /// The error estimate |u − x|_a ≤ R/2 + (R²/4 + C)^{1/2}, R the dual norm of F − K x − B'λ⁺ on the whole body and
    /// C = λ⁺·(g − B x), both for x without its penetration, which is added.
    fn estimate(
        &mut self,
        contact: &Contact,
        gradients: &mut Gradients,
        least: f64,
    ) -> Result<f64> {
        let positive: Vec<f64> = contact.multiplier.iter().map(|l| l.max(0.0)).collect();
        let gaping: f64 =
            positive.iter().zip(&contact.gap).map(|(l, gap)| l * (-gap).max(0.0)).sum();
        self.edge.subtract_force(&mut gradients.residual, &positive)?;
        self.prescribed.iter().for_each(|&place| gradients.residual[place] = 0.0);
        self.cycle.hold(&vec![false; self.edge.fixed.len()], Vec::new())?;
        let (z, factor) = self.cycle.apply(&gradients.residual);
        let rho = (factor * dot(&gradients.residual, z)).max(0.0);
        let dual = (rho / relied(least)).sqrt();
        Ok(0.5 * dual + (0.25 * dual * dual + gaping).sqrt() + self.edge.penetration(contact))
    }
}

/// The estimated error in the energy norm.
fn error_of(gradients: &Gradients) -> f64 {
    (gradients.rho() / relied(gradients.least())).sqrt()
}

/// The value of κ used for an estimate.
fn relied(least: f64) -> f64 {
    (RELIED * least).min(KAPPA)
}
