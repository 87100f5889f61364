//! Tables and figures that twins share.

pub mod alternatives;
pub mod ladder;
pub mod numbers;
