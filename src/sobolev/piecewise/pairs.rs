//! ∫∫ (u(x)−u(y))² |x−y|^{-1-2ν} over pairs of elements for polynomials of any degree, as sums of squares.
//!
//! - own element: x − y = hζ gives 2 h^{1-2ν} ∫₀¹ ζ^{1-2ν} ∫ q² dt dζ with the difference quotient q, a
//!   polynomial computed as the mean of u' over (t, t+ζ);
//! - touching elements, jump J: u(x)−u(y) = J + ξD in Duffy's coordinates, D from quotients that hold the
//!   common value exactly;
//! - separate elements: Gauss rules on pieces that grow away from the other element.

use super::polynomial::Piece;
use crate::error::Result;
use crate::numeric::scale::power_between;
use crate::quadrature::{PowerWeightRule, Rule};
use crate::sobolev::kernel::power::{PowerKernel, gauss_for_degree, graded_gauss_degree};
use crate::sobolev::order::FractionalOrder;

/// An element with its polynomial.
#[derive(Clone, Copy)]
pub(crate) struct Cell<'a> {
    pub(crate) length: f64,
    pub(crate) piece: &'a Piece,
}

/// A positive integral and the rounding error of the differences in it.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct PairSum {
    pub(crate) value: f64,
    pub(crate) rounding: f64,
    pub(crate) points: u64,
}

/// The rules for polynomials up to one degree.
pub(crate) struct PolynomialPairs {
    kernel: PowerKernel,
    degree: usize,
    /// weights t^{1-2ν} and t^{2-2ν}
    quotient_rule: PowerWeightRule,
    square_rule: PowerWeightRule,
    inner: Rule,
}

impl PolynomialPairs {
    pub(crate) fn new(order: FractionalOrder, degree: usize) -> Result<Self> {
        let kernel = PowerKernel::new(order);
        let points = 2 * degree + 1;
        Ok(Self {
            kernel,
            degree,
            quotient_rule: PowerWeightRule::new(points, kernel.two_minus)?,
            square_rule: PowerWeightRule::new(points, kernel.three_minus)?,
            inner: Rule::gauss_legendre(degree + 1)?,
        })
    }

    /// Over one element twice.
    pub(crate) fn own(&self, cell: Cell) -> PairSum {
        let mut sum = PairSum::default();
        for (zeta, w) in self.quotient_rule.iter() {
            let squares = self.inner.integrate(|tau| {
                let t = (1.0 - zeta) * tau;
                let quotient = self.inner.integrate(|r| cell.piece.slope(t + r * zeta));
                sum.points += 1;
                quotient * quotient
            });
            sum.value += w * (1.0 - zeta) * squares;
        }
        sum.value *= 2.0 * self.kernel.scaling(cell.length);
        sum
    }

    /// Over two neighbours, both orders; `jump` = value of the right one minus value of the left one at the
    /// common node.
    pub(crate) fn touching(&self, left: Cell, right: Cell, jump: f64) -> PairSum {
        let (p, q) = (left.length, right.length);
        let scale = power_between(p, q);
        let (a, b) = (p / scale, q / scale);
        let mut sum = PairSum::default();
        // Triangle s = ξ, t = ξη (in units of the elements) and its mirror image s = ξη, t = ξ.
        for mirrored in [false, true] {
            let (x, length) = if mirrored { (b, a) } else { (a, b) };
            // η from 0 to 1 runs over (0, length); the kernel's singularity lies at −x.
            graded_gauss_degree(x, length, self.degree, |eta_length, w| {
                let eta = eta_length / length;
                let kernel = w * (x / (x + eta_length)) * (x + eta_length).powf(-self.kernel.twice);
                let difference = |xi: f64| {
                    let (s, t) = if mirrored { (xi * eta, xi) } else { (xi, xi * eta) };
                    let (s_factor, t_factor) = if mirrored { (eta, 1.0) } else { (1.0, eta) };
                    t_factor * right.piece.quotient_left(t) - s_factor * left.piece.quotient_right(s)
                };
                let mut radial = self.square_rule.integrate(|xi| difference(xi).powi(2));
                if jump != 0.0 {
                    radial += 2.0 * jump * self.quotient_rule.integrate(difference)
                        + jump * jump / self.kernel.one_minus;
                }
                sum.value += kernel * radial;
                sum.points += 1;
            });
        }
        sum.value *= 2.0 * self.kernel.scaling(scale);
        sum
    }

    /// Over two elements at distance d > 0, both orders.
    pub(crate) fn separate(&self, left: Cell, right: Cell, d: f64) -> PairSum {
        let (p, q) = (left.length, right.length);
        let largest = p.max(q).max(d);
        let scale = power_between(d, largest);
        let [p, q, d] = [p, q, d].map(|x| x / scale);
        let size = left.piece.size().max(right.piece.size());
        let mut sum = PairSum::default();
        let mut add = |distance: f64, weight: f64, difference: f64| {
            let weight = weight * distance.powf(-self.kernel.twice);
            sum.value += weight * difference * difference;
            sum.rounding += weight * difference.abs();
            sum.points += 1;
        };
        if p <= d && q <= d {
            let (t_points, t_weights) = gauss_for_degree(q / d, self.degree);
            let values: Vec<f64> = t_points.iter().map(|&t| right.piece.value(t)).collect();
            let (s_points, s_weights) = gauss_for_degree(p / d, self.degree);
            for (&s, &v) in s_points.iter().zip(s_weights) {
                let value = left.piece.value(1.0 - s);
                for ((&t, &w), &other) in t_points.iter().zip(t_weights).zip(&values) {
                    let distance = d + p * s + q * t;
                    add(distance, v * p * (w * q / distance), other - value);
                }
            }
        } else {
            graded_gauss_degree(d, p, self.degree, |s, v| {
                let value = left.piece.value(1.0 - s / p);
                graded_gauss_degree(d + s, q, self.degree, |t, w| {
                    let distance = d + s + t;
                    add(distance, v * (w / distance), right.piece.value(t / q) - value);
                });
            });
        }
        let factor = 2.0 * self.kernel.scaling(scale);
        // Each value carries a few roundings of its size.
        sum.rounding *= factor * 8.0 * f64::EPSILON * size;
        sum.value *= factor;
        sum
    }
}
