//! |u|²_ν of piecewise polynomials of any degree in O(N): near pairs as in [`super::pairs`], far ones by
//! moments.
//!
//! On an admissible pair of clusters A, B ([`ClusterTree`]) the kernel t^{-1-2ν} is interpolated at m
//! Chebyshev points x_a, y_b with the Lagrange polynomials ℓ_a, ℓ_b. With the moments 1_a = ∫_A ℓ_a, U_a = ∫_A
//! u ℓ_a, S_a = ∫_A u² ℓ_a, and likewise on B,
//!
//! ∫_A ∫_B (u(x)−u(y))² |x−y|^{-1-2ν} ≈ Σ_ab |x_a−y_b|^{-1-2ν} (S_a 1_b + 1_a S_b − 2 U_a U_b).
//!
//! Only the kernel is interpolated, with the relative error 27 ρ^{-m}, ρ = 3 + √8 (the kernel varies by less
//! than 27 on a block); the difference of moments loses digits against S_a 1_b where u is nearly constant on
//! both, which the error says. Cost O(N (degree³ + m²)).

use super::pairs::{Cell, PairSum, PolynomialPairs};
use super::polynomial::PiecewisePolynomial;
use crate::error::Result;
use crate::numeric::sum::RunningSum;
use crate::quadrature::Rule;
use crate::sobolev::gram::{Chebyshev, ClusterTree};
use crate::sobolev::kernel::power::PowerKernel;
use crate::sobolev::order::FractionalOrder;
use rayon::prelude::*;

/// Chebyshev points of a cluster: 27 ρ^{-18} is 5e-13, ...
const POINTS: usize = 20;
/// 27 ρ^{-20}.
const INTERPOLATION: f64 = 1.4e-14;
/// Roundings of a moment: sums of some ten to a hundred terms.
const MOMENT_ROUNDING: f64 = 32.0 * f64::EPSILON;

/// The moments of 1, u and u² of a cluster, divided by its length.
type Moments = [[f64; POINTS]; 3];

/// The integrals over all pairs of separate clusters that are far from each other, and over all other pairs of
/// elements.
pub(super) fn clustered_squared(
    u: &PiecewisePolynomial,
    order: FractionalOrder,
    pairs: &PolynomialPairs,
) -> Result<PairSum> {
    let tree = ClusterTree::new(u.partition());
    let blocks = tree.blocks(u.partition());
    let lengths = u.partition().lengths();
    let cell = |i: usize| Cell { length: lengths[i], piece: &u.pieces()[i] };
    let near = blocks.near.par_iter().map(|&(a, b)| {
        let (left, right) = (&tree.clusters[a], &tree.clusters[b]);
        let mut sum = PairSum::default();
        for i in left.first..left.end {
            let begin = right.first.max(i);
            let mut gap = RunningSum::default();
            (i + 1..begin).for_each(|k| gap.add(lengths[k]));
            for j in begin..right.end {
                sum = sum.plus(match j - i {
                    0 => pairs.own(cell(i)),
                    1 => pairs.touching(cell(i), cell(j), u.jump(j)),
                    _ => pairs.separate(cell(i), cell(j), gap.value()),
                });
                if j > i {
                    gap.add(lengths[j]);
                }
            }
        }
        sum
    });
    let near = near.reduce(PairSum::default, PairSum::plus);
    let far = Far::new(u, &tree, PowerKernel::new(order))?;
    let rows = blocks.far.par_iter().enumerate();
    let far = rows.map(|(a, partners)| {
        let right = partners.iter().filter(|partner| partner.0 > a);
        right.map(|&(b, gap)| far.block(a, b, gap)).fold(PairSum::default(), PairSum::plus)
    });
    Ok(near.plus(far.reduce(PairSum::default, PairSum::plus)))
}

/// The moments of all clusters.
struct Far<'a> {
    tree: &'a ClusterTree,
    moments: Vec<Moments>,
    chebyshev: Chebyshev,
    kernel: PowerKernel,
}

impl<'a> Far<'a> {
    fn new(u: &PiecewisePolynomial, tree: &'a ClusterTree, kernel: PowerKernel) -> Result<Self> {
        let chebyshev = Chebyshev::new(POINTS);
        let rule = Rule::gauss_legendre(u.degree() + POINTS / 2 + 1)?;
        let mean = mean(u, &rule);
        let clusters = &tree.clusters;
        let mut moments: Vec<Moments> = clusters
            .par_iter()
            .map(|cluster| match cluster.children {
                Some(_) => [[0.0; POINTS]; 3],
                None => leaf(u, cluster.first..cluster.end, cluster.length, mean, &chebyshev, &rule),
            })
            .collect();
        let mut lagrange = [0.0; POINTS];
        for c in (0..clusters.len()).rev() {
            let Some(children) = clusters[c].children else { continue };
            let mut start = 0.0;
            let mut sum = [[0.0; POINTS]; 3];
            for child in children {
                let share = clusters[child].length / clusters[c].length;
                for (b, &point) in chebyshev.points.iter().enumerate() {
                    chebyshev.lagrange(start + share * point, &mut lagrange);
                    for (own, below) in sum.iter_mut().zip(&moments[child]) {
                        let value = share * below[b];
                        own.iter_mut().zip(&lagrange).for_each(|(own, l)| *own += l * value);
                    }
                }
                start += share;
            }
            moments[c] = sum;
        }
        Ok(Self { tree, moments, chebyshev, kernel })
    }

    /// Over both orders of a block, its partner to the right at the distance `gap`.
    fn block(&self, a: usize, b: usize, gap: f64) -> PairSum {
        let (here, there) = (self.tree.clusters[a].length, self.tree.clusters[b].length);
        let points = &self.chebyshev.points;
        let ([ones, values, squares], [other_ones, other_values, other_squares]) =
            (&self.moments[a], &self.moments[b]);
        let mut value = 0.0;
        for i in 0..POINTS {
            let from_end = gap + here * points[POINTS - 1 - i];
            for j in 0..POINTS {
                let t = from_end + there * points[j];
                let kernel = self.kernel.scaling(t) * ((here / t) * (there / t));
                value += kernel
                    * (squares[i] * other_ones[j] + ones[i] * other_squares[j]
                        - 2.0 * values[i] * other_values[j]);
            }
        }
        // Moments against 1: Σ ℓ_a = 1.
        let whole = |moments: &[f64; POINTS]| moments.iter().sum::<f64>();
        let size = whole(squares) * whole(other_ones) + whole(ones) * whole(other_squares);
        let nearest = self.kernel.scaling(gap) * ((here / gap) * (there / gap));
        PairSum {
            value: 2.0 * value,
            rounding: 2.0 * (INTERPOLATION * value.abs() + 2.0 * MOMENT_ROUNDING * nearest * size),
            points: (POINTS * POINTS) as u64,
        }
    }
}

/// The mean of u, which seminorms do not feel and digits do.
fn mean(u: &PiecewisePolynomial, rule: &Rule) -> f64 {
    let mut sum = RunningSum::default();
    let total = u.partition().total();
    for (piece, &h) in u.pieces().iter().zip(u.partition().lengths()) {
        sum.add(h / total * rule.integrate(|t| piece.value(t)));
    }
    sum.value()
}

/// The moments of a leaf.
fn leaf(
    u: &PiecewisePolynomial,
    elements: std::ops::Range<usize>,
    total: f64,
    mean: f64,
    chebyshev: &Chebyshev,
    rule: &Rule,
) -> Moments {
    let mut moments = [[0.0; POINTS]; 3];
    let mut lagrange = [0.0; POINTS];
    let mut start = RunningSum::default();
    for e in elements {
        let h = u.partition().lengths()[e];
        for (t, w) in rule.iter() {
            chebyshev.lagrange((start.value() + h * t) / total, &mut lagrange);
            let value = u.pieces()[e].value(t) - mean;
            let weight = w * h / total;
            for (own, power) in moments.iter_mut().zip([1.0, value, value * value]) {
                own.iter_mut().zip(&lagrange).for_each(|(own, l)| *own += weight * power * l);
            }
        }
        start.add(h);
    }
    moments
}
