//! Numbers of twice the length: unevaluated sums of two, 106 bits (T. J. Dekker, Numer. Math. 18 (1971)).

use std::ops::{Add, Div, Mul, Neg, Sub};

/// `0` + `1`, the second at most half an ulp of the first.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Double(pub f64, pub f64);

fn exact_sum(a: f64, b: f64) -> Double {
    let sum = a + b;
    let part = sum - a;
    Double(sum, (a - (sum - part)) + (b - part))
}

impl Double {
    pub const ZERO: Self = Self(0.0, 0.0);

    pub fn sqrt(self) -> Self {
        if self.0 <= 0.0 {
            return Self::ZERO;
        }
        let root = Self::from(self.0.sqrt());
        root + (self - root * root) / Self::from(2.0 * root.0)
    }

    pub fn value(self) -> f64 {
        self.0 + self.1
    }

    pub fn abs(self) -> Self {
        if self.0 < 0.0 { -self } else { self }
    }
}

impl From<f64> for Double {
    fn from(value: f64) -> Self {
        Self(value, 0.0)
    }
}

impl Add for Double {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let (high, low) = (exact_sum(self.0, other.0), exact_sum(self.1, other.1));
        let middle = exact_sum(high.0, high.1 + low.0);
        exact_sum(middle.0, middle.1 + low.1)
    }
}

impl Neg for Double {
    type Output = Self;

    fn neg(self) -> Self {
        Self(-self.0, -self.1)
    }
}

impl Sub for Double {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Double {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let product = self.0 * other.0;
        let rest = self.0.mul_add(other.0, -product) + (self.0 * other.1 + self.1 * other.0);
        exact_sum(product, rest)
    }
}

impl Div for Double {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let first = Self::from(self.0 / other.0);
        let rest = self - first * other;
        let second = Self::from(rest.0 / other.0);
        let rest = rest - second * other;
        first + second + Self::from(rest.0 / other.0)
    }
}

pub fn dot(a: &[Double], b: &[Double]) -> Double {
    a.iter().zip(b).fold(Double::ZERO, |sum, (&a, &b)| sum + a * b)
}

/// A = L L', row by row; `None` where a pivot is below `least` of its diagonal entry.
#[derive(Debug, Clone)]
pub struct Cholesky(pub Vec<Vec<Double>>);

impl Cholesky {
    pub fn new(matrix: &[Vec<Double>], least: f64) -> Option<Self> {
        let mut rows: Vec<Vec<Double>> = Vec::with_capacity(matrix.len());
        for (i, row) in matrix.iter().enumerate() {
            let mut next: Vec<Double> = Vec::with_capacity(i + 1);
            for j in 0..i {
                let sum = row[j] - dot(&next, &rows[j][..j]);
                next.push(sum / rows[j][j]);
            }
            let pivot = row[i] - dot(&next, &next);
            if pivot.0.is_nan() || pivot.0 <= least * row[i].0 {
                return None;
            }
            next.push(pivot.sqrt());
            rows.push(next);
        }
        Some(Self(rows))
    }

    pub fn solve(&self, right: &[Double]) -> Vec<Double> {
        let rows = &self.0;
        let mut x: Vec<Double> = Vec::with_capacity(rows.len());
        for (i, row) in rows.iter().enumerate() {
            let sum = right[i] - dot(&x, &row[..i]);
            x.push(sum / row[i]);
        }
        for i in (0..rows.len()).rev() {
            x[i] = x[i] / rows[i][i];
            for j in 0..i {
                x[j] = x[j] - rows[i][j] * x[i];
            }
        }
        x
    }
}
