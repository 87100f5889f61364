//! Preconditioned conjugate gradients for A x = b, A symmetric and positive definite, with buffers that are
//! kept between calls.
//!
//! With r = b − A x, z = B r (B ≈ A⁻¹) and the search direction p, a step adds (ρ/κ) p to x, ρ = rᵀz, κ = pᵀA
//! p, and reduces the energy eᵀA e of the error e by ρ²/κ. √ρ is the residual in the norm of the
//! preconditioner. Cost of a step: one product with A, one with B, and O(n) operations.

use super::sum::pairwise_dot;

/// A matrix and its preconditioner.
pub trait System {
    /// The error of a product.
    type Error;

    /// out ← A x.
    ///
    /// # Errors
    /// Those of the product.
    fn apply(&mut self, x: &[f64], out: &mut [f64]) -> Result<(), Self::Error>;

    /// out ← B r.
    ///
    /// # Errors
    /// Those of the preconditioner.
    fn precondition(&mut self, r: &[f64], out: &mut [f64]) -> Result<(), Self::Error>;
}

/// The result of a step.
///
/// Returned by [`ConjugateGradients::step`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Step {
    /// The decrease ρ²/κ of the energy of the error.
    Gain(f64),
    /// κ is not positive, or not a number: A is not positive definite in this direction, or the residual is
    /// zero.
    Flat,
}

/// The state of an iteration.
#[doc(alias("CG", "PCG"))]
#[derive(Debug, Clone)]
pub struct ConjugateGradients {
    /// b − A x.
    residual: Vec<f64>,
    direction: Vec<f64>,
    image: Vec<f64>,
    corrected: Vec<f64>,
    rho: f64,
}

impl ConjugateGradients {
    /// The buffers for n unknowns.
    pub fn new(n: usize) -> Self {
        let zeros = || vec![0.0; n];
        Self { residual: zeros(), direction: zeros(), image: zeros(), corrected: zeros(), rho: 0.0 }
    }

    /// Starts with the residual b − A x of a vector x (b itself for x = 0).
    ///
    /// # Errors
    /// Those of the preconditioner.
    pub fn start<S: System>(&mut self, system: &mut S, residual: &[f64]) -> Result<(), S::Error> {
        self.residual.copy_from_slice(residual);
        self.rho = self.precondition(system)?;
        self.direction.copy_from_slice(&self.corrected);
        Ok(())
    }

    /// ρ = rᵀB r ≥ 0.
    pub fn rho(&self) -> f64 {
        self.rho
    }

    /// The result of one step, which is added to x.
    ///
    /// # Errors
    /// Those of the system.
    pub fn step<S: System>(&mut self, system: &mut S, x: &mut [f64]) -> Result<Step, S::Error> {
        system.apply(&self.direction, &mut self.image)?;
        let curvature = pairwise_dot(&self.direction, &self.image);
        // The negation catches NaN.
        if !(curvature > 0.0 && curvature.is_finite()) {
            return Ok(Step::Flat);
        }
        let length = self.rho / curvature;
        for i in 0..x.len() {
            x[i] += length * self.direction[i];
            self.residual[i] -= length * self.image[i];
        }
        let gain = length * self.rho;
        let next = self.precondition(system)?;
        let turn = next / self.rho;
        for (d, c) in self.direction.iter_mut().zip(&self.corrected) {
            *d = c + turn * *d;
        }
        self.rho = next;
        Ok(Step::Gain(gain))
    }

    fn precondition<S: System>(&mut self, system: &mut S) -> Result<f64, S::Error> {
        system.precondition(&self.residual, &mut self.corrected)?;
        Ok(pairwise_dot(&self.residual, &self.corrected).max(0.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Diagonal(Vec<f64>);

    impl System for Diagonal {
        type Error = std::convert::Infallible;

        fn apply(&mut self, x: &[f64], out: &mut [f64]) -> Result<(), Self::Error> {
            out.iter_mut().zip(x).zip(&self.0).for_each(|((y, x), d)| *y = d * x);
            Ok(())
        }

        fn precondition(&mut self, r: &[f64], out: &mut [f64]) -> Result<(), Self::Error> {
            out.copy_from_slice(r);
            Ok(())
        }
    }

    #[test]
    fn as_many_steps_as_eigenvalues_do() {
        let mut system = Diagonal(vec![1.0, 2.0, 2.0, 5.0]);
        let b = [1.0, 2.0, -4.0, 10.0];
        let mut iteration = ConjugateGradients::new(4);
        let mut x = [0.0; 4];
        iteration.start(&mut system, &b).unwrap();
        let mut energy = 0.0;
        for _ in 0..3 {
            let Step::Gain(gain) = iteration.step(&mut system, &mut x).unwrap() else { panic!() };
            energy += gain;
        }
        assert!(x.iter().zip([1.0, 1.0, -2.0, 2.0]).all(|(x, e)| (x - e).abs() < 1e-13), "{x:?}");
        assert!((energy - (1.0 + 2.0 + 8.0 + 20.0)).abs() < 1e-12);
        let mut indefinite = Diagonal(vec![-1.0; 4]);
        iteration.start(&mut indefinite, &b).unwrap();
        assert_eq!(iteration.step(&mut indefinite, &mut x).unwrap(), Step::Flat);
    }
}
