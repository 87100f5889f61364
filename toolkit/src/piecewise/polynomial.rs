//! Piecewise polynomials on a [`Mesh`].

use crate::error::{Error, Result};
use crate::mesh::Mesh;
use crate::numeric::check::{require_finite_at, require_length, require_values};
use crate::numeric::legendre;
use crate::quadrature::Rule;
use std::ops::Range;
use std::sync::OnceLock;

/// Largest polynomial degree on an element.
const MAX_DEGREE: usize = 20;

/// Jumps below this multiple of the values on both sides are attributed to rounding.
const JUMP_ROUNDING: f64 = 64.0 * f64::EPSILON;

/// A polynomial on one element.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Piece {
    pub(crate) left: f64,
    pub(crate) right: f64,
    pub(crate) bubbles: Vec<f64>,
}

/// A polynomial on every element of a mesh.
///
/// On an element of length h, with t ∈ (0, 1) from left to right, u(t) = u_L (1−t) + u_R t + t(1−t) Σ_k c_k
/// P_k(2t−1): the values at the two ends and the bubbles. Continuity then concerns given numbers (u_R of one
/// element equals u_L of the next one), not rounded sums.
#[doc(alias(
    "Gagliardo",
    "Slobodeckij",
    "fractional Sobolev",
    "H1/2",
    "P1",
    "P0",
    "finite element"
))]
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct PiecewisePolynomial {
    partition: Mesh,
    pieces: Vec<Piece>,
}

impl PiecewisePolynomial {
    /// The piecewise constant function with one value per element.
    ///
    /// # Errors
    /// [`Error::LengthMismatch`], [`Error::NotFinite`].
    pub(crate) fn constants(partition: Mesh, values: &[f64]) -> Result<Self> {
        require_length("element values", values.len(), partition.len())?;
        let ends: Vec<[f64; 2]> = values.iter().map(|&v| [v, v]).collect();
        Self::discontinuous_linears(partition, &ends)
    }

    /// The continuous piecewise linear function with one value per node.
    ///
    /// # Errors
    /// [`Error::LengthMismatch`], [`Error::NotFinite`].
    pub(crate) fn linears(partition: Mesh, values: &[f64]) -> Result<Self> {
        require_values("nodal values", values, partition.len() + 1)?;
        let ends: Vec<[f64; 2]> = values.windows(2).map(|pair| [pair[0], pair[1]]).collect();
        Self::discontinuous_linears(partition, &ends)
    }

    /// The piecewise linear function with two values per element, at its left and right end.
    ///
    /// # Errors
    /// [`Error::LengthMismatch`], [`Error::NotFinite`].
    pub(crate) fn discontinuous_linears(partition: Mesh, ends: &[[f64; 2]]) -> Result<Self> {
        let none = vec![Vec::new(); ends.len()];
        Self::with_bubbles(partition, ends, none)
    }

    /// The function with these values at the ends of the elements and coefficients c_k of t(1−t) P_k(2t−1), any
    /// number per element.
    ///
    /// # Errors
    /// [`Error::LengthMismatch`], [`Error::NotFinite`], [`Error::EntryOutOfRange`] for degrees above 20.
    pub(crate) fn with_bubbles(
        partition: Mesh,
        ends: &[[f64; 2]],
        bubbles: Vec<Vec<f64>>,
    ) -> Result<Self> {
        require_length("end values", ends.len(), partition.len())?;
        require_length("bubble coefficients", bubbles.len(), partition.len())?;
        let mut pieces = Vec::with_capacity(ends.len());
        for (index, (&[left, right], bubbles)) in ends.iter().zip(bubbles).enumerate() {
            for &value in [left, right].iter().chain(&bubbles) {
                require_finite_at("value", index, value)?;
            }
            if bubbles.len() + 1 > MAX_DEGREE {
                let (name, value) = ("polynomial degree", (bubbles.len() + 1) as f64);
                return Err(Error::EntryOutOfRange { name, index, value, range: "[1, 20]" });
            }
            pieces.push(Piece { left, right, bubbles });
        }
        Ok(Self { partition, pieces })
    }

    /// The continuous piecewise polynomial of the given degree that agrees with f at the nodes and whose
    /// bubbles are t(1−t) times the L² projection of the remainder divided by t(1−t). f is called with the
    /// distance from the left end.
    ///
    /// # Errors
    /// [`Error::NotFinite`] if a value of f is not finite, [`Error::CountOutOfRange`] for degree 0 and for
    /// degrees above 20.
    pub(crate) fn interpolate(
        partition: Mesh,
        degree: usize,
        f: impl Fn(f64) -> f64,
    ) -> Result<Self> {
        if degree == 0 || degree > MAX_DEGREE {
            return Err(Error::CountOutOfRange {
                name: "polynomial degree",
                value: degree,
                range: "[1, 20]",
            });
        }
        let nodes: Vec<f64> = partition.from_left().iter().map(|&x| f(x)).collect();
        let mut ends = Vec::new();
        let mut bubbles = Vec::new();
        for (i, pair) in nodes.windows(2).enumerate() {
            let (start, h) = (partition.from_left()[i], partition.lengths()[i]);
            ends.push([pair[0], pair[1]]);
            bubbles.push(bubbles_of(degree, [pair[0], pair[1]], |t| f(start + h * t))?);
        }
        Self::with_bubbles(partition, &ends, bubbles)
    }

    /// The piecewise polynomial of degree p with p + 1 values on every element at equidistant points.
    ///
    /// # Errors
    /// [`Error::LengthMismatch`], [`Error::NotFinite`], [`Error::CountOutOfRange`] for degrees above 20.
    pub(crate) fn of_values(partition: Mesh, degree: usize, values: &[f64]) -> Result<Self> {
        if degree > MAX_DEGREE {
            return Err(Error::CountOutOfRange {
                name: "polynomial degree",
                value: degree,
                range: "[0, 20]",
            });
        }
        require_values("element values", values, partition.len().saturating_mul(degree + 1))?;
        if degree == 0 {
            return Self::constants(partition, values);
        }
        let (mut ends, mut bubbles) = (Vec::new(), Vec::new());
        for values in values.chunks(degree + 1) {
            let pair = [values[0], values[degree]];
            ends.push(pair);
            bubbles.push(bubbles_of(degree, pair, |t| lagrange(values, t))?);
        }
        Self::with_bubbles(partition, &ends, bubbles)
    }

    /// The difference u − v of two functions on one mesh.
    pub(crate) fn minus(&self, other: &Self) -> Result<Self> {
        let (mut ends, mut bubbles) = (Vec::new(), Vec::new());
        for (a, b) in self.pieces.iter().zip(&other.pieces) {
            ends.push([a.left - b.left, a.right - b.right]);
            let count = a.bubbles.len().max(b.bubbles.len());
            let of = |piece: &Piece, k: usize| piece.bubbles.get(k).copied().unwrap_or(0.0);
            bubbles.push((0..count).map(|k| of(a, k) - of(b, k)).collect());
        }
        Self::with_bubbles(self.partition.clone(), &ends, bubbles)
    }

    /// The mesh.
    pub(crate) fn mesh(&self) -> &Mesh {
        &self.partition
    }

    /// The highest degree of a piece (bubbles are counted whether they are zero or not).
    pub(crate) fn degree(&self) -> usize {
        self.pieces.iter().map(Piece::degree).max().unwrap_or(0)
    }

    /// The value at the local coordinate t ∈ [0, 1] of an element.
    ///
    /// # Errors
    /// [`Error::CountOutOfRange`] if there is no such element; [`Error::OutOfRange`] for t outside [0, 1].
    pub(crate) fn value(&self, element: usize, t: f64) -> Result<f64> {
        Error::require("local coordinate", t, "[0, 1]", (0.0..=1.0).contains(&t))?;
        let piece = self.pieces.get(element).ok_or(Error::CountOutOfRange {
            name: "element",
            value: element,
            range: "[0, number of elements)",
        })?;
        Ok(piece.value(t))
    }

    /// The value at a signed distance from a node, from the right at a jump.
    ///
    /// # Errors
    /// [`Error::CountOutOfRange`] if there is no such node; [`Error::OutOfRange`] outside the interval.
    pub(crate) fn value_near(&self, node: usize, distance: f64) -> Result<f64> {
        let lengths = self.partition.lengths();
        if node > lengths.len() {
            let (name, range) = ("node", "[0, number of nodes)");
            return Err(Error::CountOutOfRange { name, value: node, range });
        }
        let is_right = distance > 0.0 || distance == 0.0 && !distance.is_sign_negative();
        let (mut element, mut rest) = (node, distance.abs());
        // Elements away from the node, as many as it is far.
        while rest > 0.0 || element == node {
            let next = if is_right { Some(element) } else { element.checked_sub(1) };
            let Some((k, &h)) = next.and_then(|k| Some((k, lengths.get(k)?))) else { break };
            if rest < h || rest == h && !is_right {
                let t = rest / h;
                return Ok(self.pieces[k].value(if is_right { t } else { 1.0 - t }));
            }
            rest -= h;
            element = if is_right { k + 1 } else { k };
        }
        let slack = 16.0 * f64::EPSILON * (self.partition.left().abs() + self.partition.total());
        Error::require("x", distance, "{the interval of the function}", rest <= slack)?;
        let end =
            if element == 0 { self.pieces[0].left } else { self.pieces[lengths.len() - 1].right };
        Ok(end)
    }

    /// The value at a coordinate, from the right at a jump.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] outside the interval.
    pub(crate) fn value_at(&self, x: f64) -> Result<f64> {
        let distance = x - self.partition.left();
        let nodes = self.partition.from_left();
        let node = nodes.partition_point(|&d| d <= distance).clamp(1, self.pieces.len()) - 1;
        self.value_near(node, distance - nodes[node])
    }

    /// The restriction to the given elements.
    ///
    /// # Errors
    /// [`Error::CountOutOfRange`] for an empty range or one that is not contained in the mesh.
    pub(crate) fn restrict(&self, elements: Range<usize>) -> Result<Self> {
        if elements.is_empty() || elements.end > self.pieces.len() {
            return Err(Error::CountOutOfRange {
                name: "end of the element range",
                value: elements.end,
                range: "(start of the range, number of elements]",
            });
        }
        Ok(Self {
            partition: Mesh::from_lengths(&self.partition.lengths()[elements.clone()])?,
            pieces: self.pieces[elements].to_vec(),
        })
    }

    /// The elementwise derivative.
    ///
    /// # Errors
    /// [`Error::NotFinite`] if a slope overflows.
    pub(crate) fn derivative(&self) -> Result<Self> {
        let mut ends = Vec::with_capacity(self.pieces.len());
        let mut bubbles = Vec::with_capacity(self.pieces.len());
        for (piece, &h) in self.pieces.iter().zip(self.partition.lengths()) {
            let at = |t: f64| piece.slope(t) / h;
            let pair = [at(0.0), at(1.0)];
            ends.push(pair);
            bubbles.push(bubbles_of(piece.bubbles.len(), pair, at)?);
        }
        Self::with_bubbles(self.partition.clone(), &ends, bubbles)
    }

    /// True if neighbouring pieces agree at their common node to 64 ulps of the larger of their values.
    pub(crate) fn is_continuous(&self) -> bool {
        (1..self.pieces.len()).all(|node| self.jump(node) == 0.0)
    }

    /// The jump across the inner node 1 ≤ i < N; zero if it is within rounding.
    pub(crate) fn jump(&self, node: usize) -> f64 {
        let (a, b) = (&self.pieces[node - 1], &self.pieces[node]);
        let jump = b.left - a.right;
        let scale = a.size().max(b.size());
        if jump.abs() <= JUMP_ROUNDING * scale { 0.0 } else { jump }
    }

    /// The function c u.
    pub(crate) fn scaled_by(&self, factor: f64) -> Self {
        let pieces = self.pieces.iter().map(|piece| piece.scaled(factor)).collect();
        Self { partition: self.partition.clone(), pieces }
    }

    pub(crate) fn on(self, partition: Mesh) -> Self {
        Self { partition, ..self }
    }

    pub(crate) fn pieces(&self) -> &[Piece] {
        &self.pieces
    }
}

impl Piece {
    /// The polynomial c p.
    pub(crate) fn scaled(&self, factor: f64) -> Self {
        Self {
            left: factor * self.left,
            right: factor * self.right,
            bubbles: self.bubbles.iter().map(|c| factor * c).collect(),
        }
    }

    /// The part between two local coordinates, in its own one.
    pub(crate) fn part(&self, from: f64, to: f64) -> Result<Self> {
        if from == 0.0 && to == 1.0 {
            return Ok(self.clone());
        }
        let end = |t: f64| match t {
            0.0 => self.left,
            1.0 => self.right,
            _ => self.value(t),
        };
        let ends = [end(from), end(to)];
        let degree = self.bubbles.len() + usize::from(!self.bubbles.is_empty());
        let bubbles = bubbles_of(degree, ends, |t| self.value(from + (to - from) * t))?;
        Ok(Self { left: ends[0], right: ends[1], bubbles })
    }

    pub(crate) fn value(&self, t: f64) -> f64 {
        self.value_above(0.0, t)
    }

    /// The difference u(t) − c, formed before u(t) is rounded if u is nearly constant.
    pub(crate) fn value_above(&self, c: f64, t: f64) -> f64 {
        (self.left - c) * (1.0 - t) + (self.right - c) * t + t * (1.0 - t) * self.bubble_sum(t).0
    }

    /// The values at several points.
    pub(crate) fn values(&self, points: &[f64]) -> Vec<f64> {
        let x: Vec<f64> = points.iter().map(|t| 2.0 * t - 1.0).collect();
        let [mut sums, mut previous, mut current] =
            [0.0, 0.0, 1.0].map(|start| vec![start; points.len()]);
        for (k, c) in self.bubbles.iter().enumerate() {
            // (k + 1) P_{k+1} = (2k + 1) x P_k − k P_{k−1}
            let k = k as f64;
            let [up, down] = [(2.0 * k + 1.0) / (k + 1.0), k / (k + 1.0)];
            for (((sum, before), now), x) in
                sums.iter_mut().zip(&mut previous).zip(&mut current).zip(&x)
            {
                *sum += c * *now;
                (*before, *now) = (*now, up * x * *now - down * *before);
            }
        }
        let line = |t: f64| self.left * (1.0 - t) + self.right * t;
        points.iter().zip(sums).map(|(&t, sum)| line(t) + t * (1.0 - t) * sum).collect()
    }

    pub(crate) fn degree(&self) -> usize {
        if self.bubbles.is_empty() {
            usize::from(self.left != self.right)
        } else {
            self.bubbles.len() + 1
        }
    }

    /// The quotient (u(t) − u_L)/t.
    pub(crate) fn quotient_left(&self, t: f64) -> f64 {
        self.right - self.left + (1.0 - t) * self.bubble_sum(t).0
    }

    /// The quotient (u(1−s) − u_R)/s.
    pub(crate) fn quotient_right(&self, s: f64) -> f64 {
        self.left - self.right + (1.0 - s) * self.bubble_sum(1.0 - s).0
    }

    /// The derivative du/dt.
    pub(crate) fn slope(&self, t: f64) -> f64 {
        let (sum, derivative) = self.bubble_sum(t);
        self.right - self.left + (1.0 - 2.0 * t) * sum + t * (1.0 - t) * derivative
    }

    /// A bound of |u| and of the terms of which it is the sum.
    pub(crate) fn size(&self) -> f64 {
        let bubbles: f64 = self.bubbles.iter().map(|c| 0.25 * c.abs()).sum();
        self.left.abs().max(self.right.abs()) + bubbles
    }

    /// Σ c_k P_k(2t−1) and its derivative in t.
    fn bubble_sum(&self, t: f64) -> (f64, f64) {
        let (sum, slope) = legendre::series_with_slope(self.bubbles.iter().copied(), 2.0 * t - 1.0);
        (sum, 2.0 * slope)
    }
}

/// The value at t of the polynomial through values at equidistant points of [0, 1].
fn lagrange(values: &[f64], t: f64) -> f64 {
    let step = (values.len() - 1) as f64;
    let basis = |k: usize| -> f64 {
        let others = (0..values.len()).filter(|&j| j != k);
        others.map(|j| (step * t - j as f64) / (k as f64 - j as f64)).product()
    };
    values.iter().enumerate().map(|(k, value)| value * basis(k)).sum()
}

/// The coefficients of (f − linear part)/(t(1−t)) with respect to P_0 ... P_{degree−2}: exact if f is a
/// polynomial of that degree.
pub(crate) fn bubbles_of(
    degree: usize,
    [left, right]: [f64; 2],
    f: impl Fn(f64) -> f64,
) -> Result<Vec<f64>> {
    let count = degree.saturating_sub(1);
    let mut coefficients = vec![0.0; count];
    if count == 0 {
        return Ok(coefficients);
    }
    // The same for all functions.
    static OF: [OnceLock<(Rule, Vec<f64>)>; MAX_DEGREE] = [const { OnceLock::new() }; MAX_DEGREE];
    let new;
    let (rule, weights) = match OF.get(count).and_then(OnceLock::get) {
        Some(known) => known,
        None => {
            new = projection(count)?;
            OF.get(count).map_or(&new, |kept| kept.get_or_init(|| new.clone()))
        }
    };
    for (t, weights) in rule.points().iter().zip(weights.chunks_exact(count)) {
        let value = (f(*t) - left * (1.0 - t) - right * t) / (t * (1.0 - t));
        for (coefficient, weight) in coefficients.iter_mut().zip(weights) {
            *coefficient += weight * value;
        }
    }
    Ok(coefficients)
}

/// The Gauss rule of count + 1 points, and w (2k + 1) P_k(2t − 1), k < count, at each of them.
fn projection(count: usize) -> Result<(Rule, Vec<f64>)> {
    let rule = Rule::gauss_legendre(count + 1)?;
    let mut weights = vec![0.0; (count + 1) * count];
    for ((t, w), row) in rule.iter().zip(weights.chunks_exact_mut(count)) {
        legendre::fill(row, 2.0 * t - 1.0);
        row.iter_mut().enumerate().for_each(|(k, p)| *p *= (2.0 * k as f64 + 1.0) * w);
    }
    Ok((rule, weights))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polynomials_are_reproduced_with_their_derivative() {
        let partition = Mesh::from_lengths(&[0.3, 1e-9, 0.7]).unwrap();
        let cubic = |x: f64| 1.0 + x * (2.0 - x * (3.0 - 4.0 * x));
        let u = PiecewisePolynomial::interpolate(partition, 3, cubic).unwrap();
        let v = u.derivative().unwrap();
        assert!(u.is_continuous());
        for (element, start, h) in [(0, 0.0, 0.3), (2, 0.3 + 1e-9, 0.7)] {
            for t in [0.0, 0.2, 0.7, 1.0] {
                let x = start + h * t;
                assert!((u.value(element, t).unwrap() - cubic(x)).abs() < 1e-15 * 8.0);
                let slope = 2.0 - x * (6.0 - 12.0 * x);
                assert!((v.value(element, t).unwrap() - slope).abs() < 1e-13, "{element} {t}");
            }
        }
    }

    #[test]
    fn wrong_counts_and_values_are_errors() {
        let partition = || Mesh::uniform(2, 1.0).unwrap();
        assert!(PiecewisePolynomial::constants(partition(), &[1.0]).is_err());
        assert!(PiecewisePolynomial::linears(partition(), &[1.0, f64::NAN, 0.0]).is_err());
        let u = PiecewisePolynomial::constants(partition(), &[1.0, 2.0]).unwrap();
        assert!(!u.is_continuous());
        assert!(u.restrict(1..1).is_err() && u.restrict(0..3).is_err());
        assert!(u.value(2, 0.5).is_err() && u.value(0, 1.5).is_err());
        assert!(PiecewisePolynomial::interpolate(partition(), 21, |x| x).is_err());
        let long = vec![vec![], vec![0.0; 24]];
        let found = PiecewisePolynomial::with_bubbles(partition(), &[[0.0; 2]; 2], long);
        assert!(
            matches!(found, Err(Error::EntryOutOfRange { index: 1, value: 25.0, .. })),
            "{found:?}"
        );
    }
}
