//! The compiled half of the Python package `fractional_sobolev`: numbers in, numbers out. What a user calls, with its
//! documentation, is in `fractional_sobolev/__init__.py`.

mod callback;
mod constants;
mod contact;
mod norms;
mod operators;
mod source;
mod wait;

use pyo3::prelude::*;

/// Functions of the compiled half.
#[pymodule]
mod _native {
    #[pymodule_export]
    use crate::constants::{ExtremalFunction, interpolation, poincare};
    #[pymodule_export]
    use crate::contact::{Solved, contact, states_a_part};
    #[pymodule_export]
    use crate::norms::{boundary_norm, dual_norm, error_norm, norm, plane_norm};
    #[pymodule_export]
    use crate::operators::GramMatrix;
}
