//! Multigrid for contact: nested iteration, truncated Newton steps, conjugate gradients with a V-cycle.
//!
//! On every level the constraints of a contact set hold with equality and the others are ignored; the resulting
//! linear problem is solved by conjugate gradients, preconditioned by a symmetric V-cycle on the coarse functions
//! compatible with the set (C. Gräser and R. Kornhuber, J. Comput. Math. 27 (2009); R. Kornhuber and R. Krause,
//! Comput. Vis. Sci. 4 (2001)). Each level starts from the solution and the set of the coarser one. The cost is
//! O(unknowns) for a fixed accuracy.
//!
//! No initial guess is needed: the iteration starts on the coarsest mesh, where the set is guessed from coarser
//! functions on the edge. The motion of the ends of the contact intervals from one mesh to the next is
//! computed on patches: a level requires one or two linear systems in the nodal cone, at most three in the
//! midpoint cone, for up to n = 2048 segments on the contact edge.
//!
//! In the midpoint cone the multipliers of a contact interval that is too short by one segment oscillate, and their
//! projection is far from the solution: if all violated constraints are adjacent to ends of contact intervals, these
//! ends are moved. A contact interval adjacent to the Dirichlet boundary may have to be divided at points that no
//! step finds; on levels with n ≤ 256 the set is then computed by elimination.
//!
//! Measured for `block` with n segments on the contact edge and tolerance 1e-10: conjugate gradient steps on the
//! finest level, and the factor by which one cycle reduces the error (for the last two rows the limit on λ/μ is
//! lifted).
//!
//! | λ/μ | n = 128 | n = 512 | factor |
//! | --- | --- | --- | --- |
//! | 0 | 16 | | 0.81 |
//! | 1 | 16 | 17 | 0.82 |
//! | 20 | 39 | 43 | 0.97 |
//! | 50 | 64 | 66 | 0.985 |
//! | 100 | 89 | 91 | 0.992 |
//! | 200 | 131 | 136 | 0.996 |
//! | 500 | 309 | 322, not reached | 0.997 |
//!
//! Multigrid is used for λ/μ up to 100; for Poisson's ratio close to 1/2 point smoothers fail, and the direct solver
//! is used.

mod accuracy;
mod chain;
mod coarsest;
mod cycle;
mod discretisation;
mod edge;
mod entry;
mod face;
mod gradients;
mod grid_level;
mod grid_rows;
mod level;
mod link;
mod nested;
mod newton;
mod patch;
mod real;
mod sparse_level;
mod vectors;

pub use accuracy::{Accuracy, Fallback, MultigridLevel, MultigridReport, Progress};
