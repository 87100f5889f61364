//! Real Fourier transforms of one length, with their buffers.
//!
//! The transforms fail only for buffers of a length other than planned. The buffers are allocated here according to
//! the plan, so this cannot happen; it would be reported as an error.

use crate::error::{Error, Result};
use fractional_sobolev_numeric::transforms::{
    Complex, ComplexToReal, FftError, Planner, RealToComplex,
};
use std::sync::Arc;

/// Plans of the transform of length P and of its inverse (unnormalised: P times the inverse).
#[derive(Clone)]
pub(crate) struct RealFourier {
    forward: Arc<dyn RealToComplex<f64>>,
    backward: Arc<dyn ComplexToReal<f64>>,
}

/// P real numbers, P/2 + 1 modes, and the workspace of the transforms; reused between transforms.
#[derive(Default)]
pub(crate) struct Workspace {
    pub(crate) real: Vec<f64>,
    pub(crate) spectrum: Vec<Complex<f64>>,
    scratch: Vec<Complex<f64>>,
}

impl RealFourier {
    pub(crate) fn new(planner: &mut Planner, period: usize) -> Self {
        Self { forward: planner.forward(period), backward: planner.inverse(period) }
    }

    pub(crate) fn workspace(&self) -> Workspace {
        let mut work = Workspace::default();
        self.fit(&mut work);
        work
    }

    /// Adapts the lengths of the buffers to this transform; cheap if they already fit.
    pub(crate) fn fit(&self, work: &mut Workspace) {
        let period = self.forward.len();
        work.real.resize(period, 0.0);
        work.spectrum.resize(period / 2 + 1, Complex::default());
        let scratch = self.forward.get_scratch_len().max(self.backward.get_scratch_len());
        if work.scratch.len() < scratch {
            work.scratch.resize(scratch, Complex::default());
        }
    }

    /// spectrum ← transform of real, which is overwritten.
    pub(crate) fn forward(&self, work: &mut Workspace) -> Result<()> {
        self.forward
            .process_with_scratch(&mut work.real, &mut work.spectrum, &mut work.scratch)
            .map_err(refused)
    }

    /// real ← P times the function with the modes in spectrum, which are overwritten.
    pub(crate) fn backward(&self, work: &mut Workspace) -> Result<()> {
        // A real function has real zeroth and highest modes; rounding must not cause an error of the transform.
        if let Some(last) = work.spectrum.len().checked_sub(1) {
            work.spectrum[0].im = 0.0;
            work.spectrum[last].im = 0.0;
        }
        self.backward
            .process_with_scratch(&mut work.spectrum, &mut work.real, &mut work.scratch)
            .map_err(refused)
    }
}

fn refused(reason: FftError) -> Error {
    Error::Solver { reason: reason.to_string() }
}
