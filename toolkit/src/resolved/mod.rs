//! A function on an interval as polynomials on cells: resolved once, read by every verb.
//!
//! ```text
//! constructor    a formula with breakpoints -> cells that shrink towards them            build, fit, edges
//! cells          places known from the nearest breakpoint; a polynomial and an error     cells
//! verbs          value, derivative, restrict, sums, products: cell by cell               verbs
//! norms          the polynomials' norms, with the error of the polynomials               norms
//! ```
//!
//! # The constructor
//!
//! Every interval between two breakpoints is halved. From its breakpoint outwards each half is divided at the
//! distances R, R/2, R/4, ..., down to the distance below which one polynomial agrees with u at all scales: x^a
//! needs about 50/a halvings, a function that is smooth up to the breakpoint none. On every cell u is interpolated by
//! a polynomial of degree 18 and compared with it at other points, among them the 512 samples of the interval
//! (`functions::look`); coefficients below rounding are cut off, and where the two differ the cell is divided. It is
//! divided at a jump or a kink if there is one ([`edges`]), which is then located to an ulp and becomes a node, and
//! else in the middle. The result is stored in the function, so that a second norm takes no values of u.
//!
//! # The error
//!
//! A cell stores a bound ε of |u − p|: the largest difference at the points that were compared, doubled, and the
//! rounding of values. With e = u − p, of which the L^q norms follow,
//!
//! ```text
//! | ‖u‖ − ‖p‖ | ≤ ‖e‖,      | ‖u‖² − ‖p‖² | ≤ ∫ |e| (2 |p| + |e|),
//! ```
//!
//! and the smaller bound is taken: the second one is better where ε is large on a cell of the length of an ulp.

mod build;
mod cells;
mod edges;
mod fit;
mod noise;
mod norms;
mod verbs;

pub(crate) use cells::Resolved;
