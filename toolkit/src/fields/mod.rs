//! Norms of u − u_h: a function with declared breakpoints minus a piecewise polynomial.

mod cells;
mod fit;
mod layout;
mod norms;
mod patch;
mod pieces;
mod samples;
