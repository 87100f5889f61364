//! Real Fourier transforms, with plans that are compiled here, once for both libraries: once per set of instructions,
//! AVX and NEON, and a plain one for the rest.

pub use realfft::num_complex::Complex;
pub use realfft::num_traits::Num;
pub use realfft::{ComplexToReal, FftError, RealToComplex};
use std::sync::Arc;

/// Plans of transforms; one planner reuses parts of earlier plans.
///
/// ```
/// use fractional_sobolev_numeric::transforms::Planner;
/// let forward = Planner::default().forward(4);
/// let (mut signal, mut modes) = ([1.0, 2.0, 3.0, 4.0], forward.make_output_vec());
/// forward.process(&mut signal, &mut modes)?;
/// assert_eq!((modes[0].re, modes[2].re), (10.0, -2.0));
/// # Ok::<(), fractional_sobolev_numeric::transforms::FftError>(())
/// ```
pub struct Planner(realfft::RealFftPlanner<f64>);

// Never inlined, `default` neither: a caller would compile all of rustfft anew.
impl Default for Planner {
    #[inline(never)]
    fn default() -> Self {
        Self(realfft::RealFftPlanner::new())
    }
}

impl Planner {
    /// The transform of this many real numbers x: Σ_j x_j e^(−2πijk/n), k = 0 ... n/2.
    #[inline(never)]
    pub fn forward(&mut self, length: usize) -> Arc<dyn RealToComplex<f64>> {
        self.0.plan_fft_forward(length)
    }

    /// The inverse, times the length.
    #[inline(never)]
    pub fn inverse(&mut self, length: usize) -> Arc<dyn ComplexToReal<f64>> {
        self.0.plan_fft_inverse(length)
    }
}
