//! A number with its error and its work, as plain data; the error type of the library carries it as the
//! best estimate.

use std::fmt;
use std::ops::{Add, AddAssign};

/// The work of an estimate, in counts that do not depend on the machine.
///
/// ```
/// use fractional_sobolev::Work;
/// let work = Work { points: 3, pairs: 4, ..Work::default() };
/// assert_eq!((work + work).total(), 14);
/// ```
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Work {
    /// Evaluations of a function or a kernel.
    pub points: u64,
    /// Pairs of elements or cells of a double integral.
    pub pairs: u64,
    /// Steps of an iteration.
    pub iterations: u64,
    /// Matrix factorizations or dense eigenproblems.
    pub factorizations: u64,
}

impl Work {
    /// The sum of all counts, for comparing runs of the same function.
    pub fn total(&self) -> u64 {
        self.points + self.pairs + self.iterations + self.factorizations
    }
}

impl Add for Work {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            points: self.points + other.points,
            pairs: self.pairs + other.pairs,
            iterations: self.iterations + other.iterations,
            factorizations: self.factorizations + other.factorizations,
        }
    }
}

impl AddAssign for Work {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

/// A value, an estimate of its absolute error, and the work spent on it.
#[doc(alias("error bound", "interval"))]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    /// The value; finite.
    pub value: f64,
    /// Estimated absolute error; at least the rounding of `value`.
    pub error: f64,
    /// The work spent on it.
    pub work: Work,
}

impl Estimate {
    /// The relative error, error / |value|; the absolute error if the value is zero.
    pub fn relative_error(&self) -> f64 {
        if self.value == 0.0 { self.error } else { self.error / self.value.abs() }
    }
}

impl fmt::Display for Estimate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:.12e} ± {:.1e}", self.value, self.error)
    }
}
