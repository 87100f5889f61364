//! Lemma 6.1 in the plane: best constants of linear interpolation on one triangle.

mod basis;
mod constants;
mod extremal;
mod gram;
mod mixed;
mod ring;
mod shape;
mod space;
mod upper;

pub(super) use constants::on_triangle;
