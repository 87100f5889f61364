//! A function on an interval as polynomials on cells. Derivatives of formulas, and sums and products with other kinds of
//! functions, are made of them. A norm of a formula reads them if few are enough, or if the rules of `crate::functions`
//! do not meet the tolerance (`Function::of_formula`).
//!
//! ```text
//! constructor    a formula with breakpoints -> cells that shrink towards them            build, fit, edges, noise
//! cells          places known from the nearest breakpoint; a polynomial and an error     cells
//! verbs          value, derivative, restrict, sums, products: cell by cell               verbs
//! norms          the polynomials' norms, with the error of the polynomials               norms
//! ```
//!
//! # The constructor
//!
//! Every interval between two breakpoints is halved; a half of length R belongs to its breakpoint, δ is the distance from
//! it. Next to the breakpoint lies the cell (0, R/2^k) with the first k = 0, 1, 2, 3, 4, 8, 12, ... for which one polynomial
//! agrees with u there, on all scales: with one value per unit of ln δ, too. The search ends at the smallest distance
//! at which u is evaluated: at a breakpoint c ≠ 0, 64 ulps of c for a function of x. The number of halvings k is
//!
//! ```text
//! 0               if u is a polynomial of degree 18 to rounding, such as e^x,
//! about 40/a      for c + δ^a, c ≠ 0: nearer to the breakpoint δ^a is nothing beside c,
//! 500 to 1000     for δ^a, 0 < a < 1, by positions: it has its digits at every distance.
//! ```
//!
//! From there outwards every (R/2^{j+1}, R/2^j) is bisected until polynomials agree with u.
//!
//! The polynomial on a cell is the line ℓ through the end values of u, if that is enough, else of degree 18 with the same end
//! values: (u − ℓ)/(t(1−t)) is projected on degree 16 by 18 Gauss points. It is compared with u at 24 other points, and
//! with those of the 512 samples of the interval (`functions::look`) that lie in the cell. Its last coefficients are cut
//! off if they are below rounding. The two agree if they differ by no more than 64 ulps of the largest value in the cell
//! and what the rounding of x moves u, or by noise of the values (`noise`); otherwise the cell is divided. From the third
//! division on this is done at a jump or a kink if there is one ([`edges`]), which is located to an ulp and becomes a node,
//! else in the middle.
//!
//! The result is stored in the function: another verb or norm that reads it takes no values of u.
//!
//! # The error
//!
//! A cell stores an estimate ε of max |u − p|: twice the largest difference at the points that were compared, and the
//! rounding of values. If |u − p| ≤ ε, then for 1 ≤ q < ∞, from the convexity of |·|^q and of the norm,
//!
//! ```text
//! | ‖u‖_q − ‖p‖_q | ≤ ‖ε‖_q,      | ‖u‖_q − ‖p‖_q | ≤ ∫ ε (|p| + ε)^{q−1} / ‖p‖_q^{q−1},
//! ```
//!
//! and the smaller bound is taken: the second one is better where ε is large on a cell of the length of an ulp. For
//! seminorms and dual norms see [`norms`].

mod build;
mod cells;
mod edges;
mod fit;
mod noise;
mod norms;
mod verbs;

pub(crate) use cells::Resolved;
