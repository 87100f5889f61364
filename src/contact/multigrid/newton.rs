//! Contact on one level: truncated Newton steps, linear systems no more exactly than the set needs.
//!
//! First patches over the ends of the runs that are guessed ([`super::patch`]) mend the guess: no linear
//! system of the level is solved for a set that its neighbourhood contradicts. A step holds the constraints
//! of the set with equality and lowers the error by conjugate gradients; as soon as the error is a fiftieth of
//! what it was, signs of forces and gaps tell which constraints are wrong, and patches over them give the next
//! set. Where these change nothing the signs decide, as in the condensed active set. When the set stands, the
//! gradients go on to the accuracy asked for. A set that comes back is decided more exactly, then one
//! constraint at a time.

use super::super::problem::ContactProblem;
use super::cycle::Cycle;
use super::edge::{Contact, Edge, changed};
use super::face::FreePart;
use super::gradients::Gradients;
use super::level::Level;
use super::patch;
use super::vectors::{dot, dot_mixed, subtract_from};
use crate::cone::{Cone, ContactSet, Status};
use crate::error::Result;
use std::collections::HashSet;

/// The error of a step is lowered by this before signs decide.
const DECIDED: f64 = 0.02;
/// When a set comes back, decisions are made this much more exactly.
const SHARPER: f64 = 1e-3;
/// Decisions are never made more exactly than this.
const SHARPEST: f64 = 1e-10;
/// Steps allowed.
pub(super) const STEPS: usize = 60;
/// A first error below this share of the solution is as good as none: a patch may be all of a coarse body.
const SOLVED: f64 = 1e-8;
/// Starts from the true residual before the accuracy asked for is out of reach.
const TRIES: usize = 3;
/// What the gradients are to leave of the accuracy asked for; of an accuracy that was missed, at most half
/// and at least a tenth as much.
const SPARE: f64 = 0.4;
const LESS: (f64, f64) = (0.1, 0.5);
/// Conjugate gradient steps allowed for one set: at the factor 0.9 enough for 1e-12.
const GRADIENT_STEPS: usize = 300;
/// More than this is never relied on of κ, whatever few steps say, and of an estimate this share.
const KAPPA: f64 = 0.15;
const RELIED: f64 = 0.7;

/// Everything of one level.
pub(super) struct Stage<'s, 'c, L> {
    problem: &'s ContactProblem,
    level: &'s L,
    cycle: &'s mut Cycle<'c, L>,
    edge: Edge,
    /// F in the layout of the level.
    load: Vec<f64>,
    /// The prescribed places.
    prescribed: Vec<usize>,
    /// κ on coarser levels.
    least: f64,
    guess: Guess,
}

/// What a guess of the set is worth.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Guess {
    /// Signs of forces and gaps decide, for so many steps.
    Signs(usize),
    /// It is the set; inexact forces do not decide.
    Known,
}

/// When to stop.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Goal {
    /// An energy norm of the error over that of the solution.
    Relative(f64),
    /// An energy norm of the error.
    Absolute(f64),
    /// A share of the first error.
    Share(f64),
}

/// The end of the iteration on a level.
pub(super) struct Outcome {
    pub(super) set: ContactSet,
    pub(super) multiplier: Vec<f64>,
    pub(super) status: Status,
    pub(super) history: Vec<ContactSet>,
    /// Conjugate gradient steps.
    pub(super) gradient_steps: usize,
    /// The least eigenvalue of cycle times K that was seen.
    pub(super) least: f64,
    /// |u|_a.
    pub(super) norm: f64,
    /// The estimated error in the energy norm.
    pub(super) error: f64,
    /// J.
    pub(super) energy: f64,
}

/// What an iterate says of itself.
#[derive(Debug, Clone, Copy, Default)]
struct Sizes {
    /// |x|_a.
    norm: f64,
    /// J.
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
        }
    }

    /// With another view of the guess; at first signs decide.
    pub(super) fn with(mut self, guess: Guess) -> Self {
        self.guess = guess;
        self
    }

    /// From an iterate and a guess of the set; `report` hears of the step and the estimated error.
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
            let ends: Vec<usize> = set.runs().into_iter().flat_map(|run| [run.start, run.end - 1]).collect();
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
            };
            let (mut steps_here, mut before) = (0, error_of(&gradients));
            let (wrong, stuck) = loop {
                let wanted = (decided * before).max(spare * goal);
                let mut stuck = false;
                while error_of(&gradients) > wanted && !stuck {
                    stuck = steps_here >= GRADIENT_STEPS || !gradients.step(self.level, self.cycle, x);
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

    /// Moves the iterate onto the set.
    fn hold(&self, x: &mut [f64], set: &ContactSet) -> FreePart {
        let slack = self.edge.slack(x);
        let part = FreePart::new(self.problem, self.level, (self.edge.cone, set), &slack, &self.edge.fixed);
        self.edge.add(x, &part.change);
        part
    }

    /// Mends the set near the given constraints, and the iterate with it.
    fn mend(&self, x: &mut [f64], set: &mut ContactSet, constraints: &[usize]) -> Result<()> {
        patch::mend((self.problem, self.level, &self.edge, &self.load), x, set, constraints)
    }

    /// Moves the iterate onto the set and starts the gradients there.
    fn begin(&mut self, x: &mut [f64], set: &ContactSet, gradients: &mut Gradients) -> Result<Sizes> {
        let part = self.hold(x, set);
        self.cycle.hold(&part.held, part.sawtooths)?;
        let sizes = self.residual(x, &mut gradients.residual);
        gradients.start(self.cycle);
        Ok(sizes)
    }

    /// Judges the iterate by its residual as it is.
    fn end(&mut self, x: &[f64], set: &ContactSet, gradients: &mut Gradients, goal: f64) -> Result<Outcome> {
        let least = gradients.least();
        let Sizes { norm, energy } = self.residual(x, &mut gradients.residual);
        let contact = self.edge.contact(x, &gradients.residual, set);
        let error = self.estimate(&contact, gradients, least)?;
        let relative = if norm > 0.0 { error / norm } else { 0.0 };
        let status = if error <= goal { Status::Converged } else { Status::Stalled { residual: relative } };
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

    /// |u − x|_a ≤ R/2 + (R²/4 + C)^{1/2} with R the dual norm of F − K x − B'λ⁺ on all of the body and
    /// C = λ⁺·(g − B x), both for x without its penetration, which is added.
    fn estimate(&mut self, contact: &Contact, gradients: &mut Gradients, least: f64) -> Result<f64> {
        let positive: Vec<f64> = contact.multiplier.iter().map(|l| l.max(0.0)).collect();
        let gaping: f64 = positive.iter().zip(&contact.gap).map(|(l, gap)| l * (-gap).max(0.0)).sum();
        self.edge.subtract_force(&mut gradients.residual, &positive)?;
        self.prescribed.iter().for_each(|&place| gradients.residual[place] = 0.0);
        self.cycle.hold(&vec![false; self.edge.fixed.len()], Vec::new())?;
        let (z, factor) = self.cycle.apply(&gradients.residual);
        let rho = (factor * dot_mixed(&gradients.residual, z)).max(0.0);
        let dual = (rho / relied(least)).sqrt();
        Ok(0.5 * dual + (0.25 * dual * dual + gaping).sqrt() + self.edge.penetration(contact))
    }
}

/// The estimated error in the energy norm.
fn error_of(gradients: &Gradients) -> f64 {
    (gradients.rho() / relied(gradients.least())).sqrt()
}

/// What is relied on of an estimate of κ.
fn relied(least: f64) -> f64 {
    (RELIED * least).min(KAPPA)
}
