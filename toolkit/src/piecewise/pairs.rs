//! ∫∫ (u(x)−u(y))² |x−y|^{-1-2ν} over pairs of elements for polynomials of any degree. In an element and across a common
//! node the differences are made of quotients, in which nothing cancels; the rounding of all others is returned.
//!
//! - one element with itself: x − y = hζ gives 2 h^{1-2ν} ∫₀¹ ζ^{1-2ν} ∫₀^{1−ζ} q² dt dζ with the difference
//!   quotient q, a polynomial computed as the mean of du/dt over (t, t+ζ). It is evaluated as a quadratic form of the
//!   coefficients, whose terms have both signs: its rounding is that of the sum of their sizes;
//! - touching elements with a jump J: u(x)−u(y) = J + ξD in Duffy's coordinates, D from quotients that contain
//!   the common value exactly;
//! - separate elements: Gauss rules on pieces that grow away from the other element.

use super::polynomial::Piece;
use crate::energy::PairSum;
use crate::error::Result;
use crate::kernel::power::{GaussRules, PowerKernel};
use crate::numeric::legendre;
use crate::numeric::scale::power_between;
use crate::order::Order;
use crate::quadrature::Rule;

/// An element with its polynomial.
#[derive(Clone, Copy)]
pub(crate) struct Cell<'a> {
    pub(crate) length: f64,
    pub(crate) piece: &'a Piece,
}

/// The rules for polynomials up to one degree.
pub(crate) struct PolynomialPairs {
    kernel: PowerKernel,
    rules: GaussRules,
    /// form of one element with itself, for the slope of the linear part and the bubbles
    own: Vec<Vec<f64>>,
    /// rule for the weights t^{1-2ν} and t^{2-2ν}
    quotient_rule: Rule,
    square_rule: Rule,
}

/// The rules for pairs of polynomials of the degrees that occur.
pub(crate) struct DegreeRules {
    /// the degrees that occur, in increasing order
    degrees: Vec<usize>,
    pairs: Vec<PolynomialPairs>,
    moments: Vec<Rule>,
}

/// Number of points of a rule in addition to the degree: half the number of points of a cluster, plus one.
const MOMENT_POINTS: usize = 15;

impl DegreeRules {
    /// The rules for the relative accuracy `target` of the sum over all pairs of polynomials of these degrees.
    pub(crate) fn new(
        order: Order,
        degrees: impl IntoIterator<Item = usize>,
        target: f64,
    ) -> Result<Self> {
        let mut degrees: Vec<usize> = degrees.into_iter().collect();
        degrees.push(0);
        degrees.sort_unstable();
        degrees.dedup();
        let pairs = |&d: &usize| PolynomialPairs::new(order, d.max(1), 0.1 * target);
        let moments = |&d: &usize| Rule::gauss_legendre(d + MOMENT_POINTS);
        Ok(Self {
            pairs: degrees.iter().map(pairs).collect::<Result<_>>()?,
            moments: degrees.iter().map(moments).collect::<Result<_>>()?,
            degrees,
        })
    }

    /// The place of the rules for a degree.
    fn place(&self, degree: usize) -> usize {
        self.degrees.partition_point(|&d| d < degree).min(self.degrees.len() - 1)
    }

    /// The rules for pairs of polynomials of a degree.
    pub(crate) fn pairs(&self, degree: usize) -> &PolynomialPairs {
        &self.pairs[self.place(degree)]
    }

    /// The integral over two elements; `apart` is the difference of their numbers, `jump` as in
    /// [`PolynomialPairs::touching`].
    pub(crate) fn near(
        &self,
        [left, right]: [Cell; 2],
        apart: usize,
        gap: f64,
        jump: impl FnOnce() -> f64,
    ) -> PairSum {
        let pairs = self.pairs(left.piece.degree().max(right.piece.degree()));
        match apart {
            0 => pairs.own(left),
            1 => pairs.touching(left, right, jump()),
            _ => pairs.separate(left, right, gap),
        }
    }

    /// Points, weights and values of a polynomial minus `shift`, for its moments.
    pub(crate) fn sample(&self, piece: &Piece, shift: f64, visit: &mut dyn FnMut(f64, f64, f64)) {
        for (t, w) in self.moments[self.place(piece.degree())].iter() {
            visit(t, w, piece.value_above(shift, t));
        }
    }
}

/// Rounding error of the form of one element, relative to its terms.
const OWN_ROUNDING: f64 = 4.0 * f64::EPSILON;

/// Fills `slopes` with the derivatives of t(1−t) P_k(2t−1), k = 0, 1, ...
fn fill_slopes(slopes: &mut [f64], t: f64) {
    let x = 2.0 * t - 1.0;
    let (mut previous, mut current) = (0.0, 1.0);
    let (mut previous_slope, mut slope) = (0.0, 0.0);
    for (k, out) in slopes.iter_mut().enumerate() {
        *out = (1.0 - 2.0 * t) * current + 2.0 * t * (1.0 - t) * slope;
        // P'_{k+1} = (2k+1) P_k + P'_{k−1}
        let next_slope = (2 * k + 1) as f64 * current + previous_slope;
        (previous_slope, slope) = (slope, next_slope);
        (previous, current) = (current, legendre::next(k, x, current, previous));
    }
}

impl PolynomialPairs {
    /// The rules for polynomials of degree up to `degree`, with integrals of the kernel to the relative
    /// accuracy `target`.
    pub(crate) fn new(order: Order, degree: usize, target: f64) -> Result<Self> {
        let kernel = PowerKernel::new(order);
        let points = 2 * degree + 1;
        let mut pairs = Self {
            kernel,
            rules: GaussRules::to(degree, target),
            own: Vec::new(),
            quotient_rule: Rule::power_weight(points, kernel.two_minus)?,
            square_rule: Rule::power_weight(points, kernel.three_minus)?,
        };
        pairs.own = pairs.own_form(degree, &Rule::gauss_legendre(degree + 1)?);
        Ok(pairs)
    }

    /// The form of one element of length one, for its slope and its bubbles.
    fn own_form(&self, degree: usize, inner: &Rule) -> Vec<Vec<f64>> {
        let mut form = vec![vec![0.0; degree]; degree];
        let mut slopes = vec![0.0; degree.saturating_sub(1)];
        for (zeta, w) in self.quotient_rule.iter() {
            for (tau, v) in inner.iter() {
                let t = (1.0 - zeta) * tau;
                // The mean slopes of the linear part and of all bubbles over (t, t + ζ).
                let mut quotients = vec![0.0; degree];
                quotients[0] = 1.0;
                for (r, weight) in inner.iter() {
                    fill_slopes(&mut slopes, t + r * zeta);
                    for (sum, slope) in quotients[1..].iter_mut().zip(&slopes) {
                        *sum += weight * slope;
                    }
                }
                let weight = 2.0 * w * v * (1.0 - zeta);
                for (row, a) in form.iter_mut().zip(&quotients) {
                    row.iter_mut().zip(&quotients).for_each(|(entry, b)| *entry += weight * a * b);
                }
            }
        }
        form
    }

    /// The integral over one element with itself.
    pub(crate) fn own(&self, cell: Cell) -> PairSum {
        let slope = cell.piece.right - cell.piece.left;
        let coefficients = || std::iter::once(&slope).chain(&cell.piece.bubbles);
        let (mut value, mut size) = (0.0, 0.0);
        for (a, row) in coefficients().zip(&self.own) {
            let along: f64 = coefficients().zip(row).map(|(b, entry)| b * entry).sum();
            let absolute: f64 = coefficients().zip(row).map(|(b, entry)| (b * entry).abs()).sum();
            value += a * along;
            size += a.abs() * absolute;
        }
        let factor = self.kernel.scaling(cell.length);
        PairSum { value: factor * value, rounding: factor * OWN_ROUNDING * size, points: 1 }
    }

    /// The integral over two neighbours, in both orders; `jump` is the value of the right one minus that of the
    /// left one at the common node.
    pub(crate) fn touching(&self, left: Cell, right: Cell, jump: f64) -> PairSum {
        let (p, q) = (left.length, right.length);
        let scale = power_between(p, q);
        let (a, b) = (p / scale, q / scale);
        let mut sum = PairSum::default();
        // Triangle s = ξ, t = ξη (in units of the elements) and its mirror image s = ξη, t = ξ.
        for mirrored in [false, true] {
            let (x, length) = if mirrored { (b, a) } else { (a, b) };
            // The element along which ξ runs alone has the same quotients for every η.
            let along: Vec<f64> = self
                .square_rule
                .iter()
                .map(|(xi, _)| {
                    if mirrored {
                        right.piece.quotient_left(xi)
                    } else {
                        left.piece.quotient_right(xi)
                    }
                })
                .collect();
            // η from 0 to 1 runs over (0, length); the kernel's singularity lies at −x.
            self.rules.graded(x, length, |eta_length, w| {
                let eta = eta_length / length;
                let kernel = w * (x / (x + eta_length)) * (x + eta_length).powf(-self.kernel.twice);
                // u(x) − u(y) over ξ, up to its sign
                let difference = |xi: f64, alone: f64| {
                    let t = xi * eta;
                    alone
                        - eta
                            * if mirrored {
                                left.piece.quotient_right(t)
                            } else {
                                right.piece.quotient_left(t)
                            }
                };
                let pairs = self.square_rule.iter().zip(&along);
                let mut radial: f64 =
                    pairs.map(|((xi, w), &alone)| w * difference(xi, alone).powi(2)).sum();
                if jump != 0.0 {
                    let sign = if mirrored { 2.0 } else { -2.0 };
                    // Both rules have the Gauss points.
                    let points = self.quotient_rule.iter().zip(&along);
                    let linear: f64 =
                        points.map(|((xi, w), &alone)| w * difference(xi, alone)).sum();
                    radial += sign * jump * linear + jump * jump / self.kernel.one_minus;
                }
                sum.value += kernel * radial;
                sum.points += 1;
            });
        }
        sum.value *= 2.0 * self.kernel.scaling(scale);
        sum
    }

    /// The integral over two elements at distance d > 0, in both orders.
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
            let [along_p, along_q] = [p / d, q / d].map(|ratio| self.rules.simple(ratio));
            let values: Vec<f64> = along_q.points().iter().map(|&t| right.piece.value(t)).collect();
            for (s, v) in along_p.iter() {
                let value = left.piece.value(1.0 - s);
                for ((t, w), &other) in along_q.iter().zip(&values) {
                    let distance = d + p * s + q * t;
                    add(distance, v * p * (w * q / distance), other - value);
                }
            }
        } else {
            self.rules.graded(d, p, |s, v| {
                let value = left.piece.value(1.0 - s / p);
                self.rules.graded(d + s, q, |t, w| {
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
