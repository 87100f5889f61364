//! Parameters and results of integrals along a side.

use crate::quadrature::Limit;
use std::ops::Add;

/// Order and cell width of the rules.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Level {
    pub(crate) points: usize,
    pub(crate) width: f64,
}

/// A value of ℓ and its rounding error; the errors of different terms are independent, so that their squares
/// add.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Density {
    pub(crate) value: f64,
    pub(crate) rounding: f64,
}

impl Add for Density {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { value: self.value + other.value, rounding: self.rounding + other.rounding }
    }
}

/// An integral along a side: its limit, and the rounding of the sum.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ArmValue {
    pub(crate) limit: Limit,
    pub(crate) rounding: f64,
    /// true if the integrand decayed below rounding on cells of the level's width
    pub(crate) is_settled: bool,
}

/// The result of a level for the squared seminorm.
#[derive(Debug, Clone)]
pub(crate) struct LevelValue {
    pub(crate) value: f64,
    /// its terms by sides, whose errors may have opposite signs
    pub(crate) sides: Vec<f64>,
    pub(crate) tail: f64,
    pub(crate) rounding: f64,
    /// the error that the rules cannot detect
    pub(crate) missed: f64,
    /// the error of the rules of this level, estimated by other rules on the same cells
    pub(crate) of_rules: Option<f64>,
    pub(crate) points: u64,
}
