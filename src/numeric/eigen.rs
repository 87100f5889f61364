//! Eigenvalues and eigenvectors of small matrices, on one thread.

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::evd::{ComputeEigenvectors, self_adjoint_evd, self_adjoint_evd_scratch};
#[cfg(feature = "contact")]
use faer::linalg::evd::{evd_real, evd_scratch};
use faer::{Mat, Par};

/// (eigenvalues, increasing; unit eigenvectors as columns) of the symmetric matrix whose lower half is given.
///
/// One thread: on a few hundred rows threads would spend their time waiting for each other. `None` where the
/// iteration does not converge, as for entries that are not finite. Cost O(n³).
pub(crate) fn symmetric_eigen(a: &Mat<f64>) -> Option<(Vec<f64>, Mat<f64>)> {
    let size = a.nrows();
    let (mut values, mut vectors) = (Mat::<f64>::zeros(size, 1), Mat::<f64>::zeros(size, size));
    let wanted = ComputeEigenvectors::Yes;
    let mut memory =
        MemBuffer::new(self_adjoint_evd_scratch::<f64>(size, wanted, Par::Seq, Default::default()));
    let stack = MemStack::new(&mut memory);
    let diagonal = values.as_mut().col_mut(0).as_diagonal_mut();
    self_adjoint_evd(a.as_ref(), diagonal, Some(vectors.as_mut()), Par::Seq, stack, Default::default())
        .ok()?;
    Some(((0..size).map(|i| values[(i, 0)]).collect(), vectors))
}

/// The eigenvalues of a square matrix, conjugates both, in no order. `None` where the iteration does not
/// converge. Cost O(n³).
#[cfg(feature = "contact")]
pub(crate) fn general_eigenvalues(a: &Mat<f64>) -> Option<Vec<faer::c64>> {
    let size = a.nrows();
    let (mut real, mut imaginary) = (Mat::<f64>::zeros(size, 1), Mat::<f64>::zeros(size, 1));
    let none = ComputeEigenvectors::No;
    let mut memory = MemBuffer::new(evd_scratch::<f64>(size, none, none, Par::Seq, Default::default()));
    let stack = MemStack::new(&mut memory);
    let re = real.as_mut().col_mut(0).as_diagonal_mut();
    let im = imaginary.as_mut().col_mut(0).as_diagonal_mut();
    evd_real(a.as_ref(), re, im, None, None, Par::Seq, stack, Default::default()).ok()?;
    Some((0..size).map(|i| faer::c64::new(real[(i, 0)], imaginary[(i, 0)])).collect())
}
