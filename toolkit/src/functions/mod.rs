//! Norms of functions given by code with declared breakpoints.
//!
//! Each interval between breakpoints is divided at its midpoint into two *sides*. A side of length R consists
//! of the points c ± δ, 0 < δ < R, c its breakpoint; t = ln(R/δ) is the *depth* of a point, and the depth of
//! a side is the largest t at which the function is evaluated. Norms are sums of integrals ∫₀^∞ ℓ(t) dt along
//! the sides ([`log_energy`]). `Function::of_formula` decides whether a norm is computed here or from polynomials
//! (`crate::resolved`).
//!
//! The modules, in the order in which a norm passes through them:
//!
//! ```text
//! function       a formula with its breakpoints; its values, divided by units of length and size
//! combined       sums, products, multiples and restrictions of formulas, again as formulas
//! arm            a side: its breakpoint, length and depth
//! look           512 samples of every interval between breakpoints, taken once
//! norms          |u|_ν, ‖u‖_ν, ‖u‖_q, mean: which of the following methods computes them
//! waves          many oscillations: polynomials on short cells, whose norm is returned
//! scales         one value per unit of t: functions for which the rules in t are too coarse are recognised
//! refine         levels of increasing accuracy until two agree; the error of the result
//! level          a level: order and cell width of its rules; the result of a level
//! log_energy     |u|²_ν on a level: ℓ(t), the integral over all points that are less deep
//! octaves        values of u for the rules, from polynomials in ln δ, one for every factor 2 of δ
//! arm_integral   ∫ ℓ dt along a side, by Gauss rules on cells of t
//! rest           what lies beyond the last cell, where ℓ decays fast
//! partials       the same from partial integrals, where ℓ decays slowly or x is rounded; infinite norms
//! two_rates      the same, where ℓ is a sum of two exponentials whose rates differ by 2ν
//! deep_tail      the same below the range of binary64, for functions of ln δ
//! interpolant    polynomials in ln t, of which deep_tail makes differences that keep their digits
//! resolution     oscillations between the points of a rule: their share of the error
//! by_scales      ∫ f(u) of functions with structure on many scales, instead of the rules
//! supremum       max |u|, next to the largest of the values that all norms see
//! ```

mod arm;
mod arm_integral;
mod by_scales;
mod combined;
mod deep_tail;
mod function;
mod interpolant;
mod level;
mod log_energy;
mod look;
mod norms;
mod octaves;
mod partials;
mod refine;
mod resolution;
mod rest;
mod scales;
mod supremum;
mod two_rates;
mod waves;

pub(crate) use arm::Arm;
pub(crate) use combined::break_of;
pub use function::Position;
pub(crate) use function::{Normalized, SingularFunction, Units};
pub(crate) use look::Look;
pub(crate) use resolution::of_residual;
