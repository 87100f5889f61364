//! The solution of A x = b by conjugate gradients, preconditioned by the spectral power.

use super::{GramOperator, Spectral};
use crate::error::{Error, Result};
use crate::estimate::{Estimate, Tolerance, Work};
use crate::numeric::conjugate_gradients::{ConjugateGradients, Step, System};
use crate::numeric::sum::{RunningSum, compensated};

/// Number of last steps whose total gain bounds the energy of the error, which is at least halved by every
/// step.
const SETTLED: usize = 4;

/// Largest number of steps; about 15 are typical, more for orders near 0.
const STEPS: usize = 500;

/// Relative rounding error of the entries, each the result of at most a few dozen operations.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

struct Preconditioned<'a> {
    operator: &'a GramOperator,
    spectral: &'a Spectral,
}

impl System for Preconditioned<'_> {
    type Error = Error;

    fn apply(&mut self, x: &[f64], out: &mut [f64]) -> Result<()> {
        out.copy_from_slice(&self.operator.apply(x)?);
        Ok(())
    }

    fn precondition(&mut self, r: &[f64], out: &mut [f64]) -> Result<()> {
        self.spectral.times(r, out);
        Ok(())
    }
}

/// The solution, to the relative tolerance in the norm of A, and its energy bᵀx = xᵀA x, whose error includes
/// the rounding of A.
pub(crate) fn solve(
    operator: &GramOperator,
    spectral: &Spectral,
    load: &[f64],
    tolerance: Tolerance,
) -> Result<(Vec<f64>, Estimate)> {
    let mut system = Preconditioned { operator, spectral };
    let mut iteration = ConjugateGradients::new(load.len());
    let mut x = vec![0.0; load.len()];
    let mut energy = RunningSum::default();
    let mut gains: Vec<f64> = Vec::new();
    iteration.start(&mut system, load)?;
    let target = tolerance.relative().powi(2);
    let mut rest = f64::INFINITY;
    while gains.len() < STEPS && iteration.rho() > 0.0 {
        let Step::Gain(gain) = iteration.step(&mut system, &mut x)? else { break };
        gains.push(gain);
        energy.add(gain);
        rest = gains.iter().rev().take(SETTLED).sum();
        if gains.len() >= SETTLED && rest <= target * energy.value() {
            break;
        }
    }
    spectral.without_constant(&mut x);
    let value = energy.value();
    let converged = gains.len() < STEPS || rest <= target * value;
    let rest = if converged { target * value } else { rest };
    let work = Work { iterations: gains.len() as u64, ..Work::default() };
    // The entries round independently of each other.
    let squares = operator.diagonal().iter().zip(&x).map(|(a, x)| (a * x * x).powi(2));
    let rounding = ROUNDING * compensated(squares).sqrt();
    let energy = Estimate::new(value, rest + tolerance.relative() * value + rounding, work)?;
    if converged {
        return Ok((x, energy));
    }
    Err(Error::not_met(
        "energy",
        tolerance.relative(),
        energy,
        "conjugate gradients did not converge within the maximum number of steps",
    ))
}
