//! Dense matrices: products, Cholesky factors, eigenvectors.
//!
//! Two libraries stand behind the same functions: faer, with blocked algorithms, where the feature `faer` is
//! on (a part of `contact`), and nalgebra, which is built in less, where it is not. The matrices are
//! nalgebra's either way: columns one after the other. Tests compare the two.

#[cfg(feature = "faer")]
mod blocked;
#[cfg(any(test, not(feature = "faer")))]
mod plain;

#[cfg(feature = "faer")]
pub(crate) use blocked::{Cholesky, product, symmetric_eigen, times_transpose, transpose_times};
#[cfg(not(feature = "faer"))]
pub(crate) use plain::{Cholesky, product, symmetric_eigen, times_transpose, transpose_times};
