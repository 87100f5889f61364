//! Dense matrices: products, Cholesky factors, eigenvectors, by faer on nalgebra's column-major storage. Tests
//! compare with nalgebra's own algorithms.

mod blocked;
#[cfg(test)]
mod plain;

pub(crate) use blocked::{Cholesky, product, symmetric_eigen, times_transpose, transpose_times};
