//! Meshes of an interval, given by the *lengths* of their elements.

use super::grading::{algebraic_lengths, geometric_lengths, require_length_of_interval};
use crate::error::{Error, Result};
use crate::numeric::check::require_memory;
use crate::numeric::check::{require_entry, require_finite};
use crate::numeric::scale::power_between;
use crate::numeric::sum::RunningSum;

/// Largest admissible ratio of the interval's length to an element's length.
///
/// Scaled by its own size, every integral over two elements then remains in the range of binary64.
const LARGEST_RATIO: f64 = 1e303;

/// Bytes per element: its length, its distances, and the workspace of their sums.
const BYTES: usize = 48;

/// A mesh of an interval, given by the lengths of its elements from left to right.
///
/// # Method
///
/// Distances between elements are sums of lengths, never differences of coordinates: an element of length
/// 1e-300 may be adjacent to one of length 1 anywhere in the interval, and every distance keeps full relative
/// accuracy. Coordinates serve for evaluation and plotting only. Sums are compensated (Neumaier 1974), with a
/// relative error of about 1 ulp for any number of elements.
///
/// ```
/// use fractional_sobolev::Mesh;
/// let mesh = Mesh::from_nodes(&[0.0, 0.25, 1.0])?;
/// assert_eq!(mesh.lengths(), Mesh::from_lengths(&[0.25, 0.75])?.lengths());
/// assert!(mesh.len() == 2 && mesh.total() == 1.0);
/// assert_eq!((mesh.from_left(), mesh.from_right()), (&[0.0, 0.25, 1.0][..], &[1.0, 0.75, 0.0][..]));
/// // graded towards both ends, and towards an interior point
/// assert_eq!(Mesh::graded(&[0.0, 1.0], 1, 0.5)?.nodes(), [0.0, 0.25, 0.5, 0.75, 1.0]);
/// let graded = Mesh::graded(&[0.0, 0.3, 1.0], 20, 0.5)?;
/// assert!(graded.lengths().iter().any(|&h| h < 1e-6));
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
#[doc(alias("mesh", "grid", "graded mesh", "interval"))]
#[derive(Debug, Clone, PartialEq)]
pub struct Mesh {
    left: f64,
    lengths: Vec<f64>,
    /// distance of node i from the left end
    from_left: Vec<f64>,
    /// distance of node i from the right end
    from_right: Vec<f64>,
}

impl Mesh {
    /// The mesh with the given element lengths and its left end at 0.
    ///
    /// # Errors
    /// [`Error::CountOutOfRange`] without elements, [`Error::EntryOutOfRange`] for a length that is not positive
    /// and finite, [`Error::OutOfRange`] if the total length overflows or exceeds 1e303 times the shortest
    /// element, or if that is shorter than 2.3e-308.
    pub fn from_lengths(lengths: &[f64]) -> Result<Self> {
        Self::at(0.0, lengths.to_vec())
    }

    /// The mesh with the given nodes; the lengths are their differences.
    ///
    /// # Errors
    /// As [`Mesh::from_lengths`]; [`Error::EntryOutOfRange`] unless the nodes increase; [`Error::NotFinite`].
    pub fn from_nodes(nodes: &[f64]) -> Result<Self> {
        require_finite("node", nodes)?;
        for (k, pair) in nodes.windows(2).enumerate() {
            require_entry("node", k + 1, pair[1], "(previous node, inf)", pair[0] < pair[1])?;
        }
        let left = nodes.first().copied().unwrap_or(0.0);
        Self::at(left, nodes.windows(2).map(|pair| pair[1] - pair[0]).collect())
    }

    /// The uniform mesh with `count` elements on (0, length).
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless 0 < length < ∞; [`Error::TooLarge`] if the memory does not suffice; as
    /// [`Mesh::from_lengths`].
    pub fn uniform(count: usize, length: f64) -> Result<Self> {
        require_memory("elements", count, BYTES)?;
        require_length_of_interval(length)?;
        Self::from_lengths(&vec![length / count.max(1) as f64; count])
    }

    /// The mesh with nodes 0, L σ^m, ..., L σ, L, m = `layers`, σ = `ratio`, L = `length`: the lengths
    /// decrease by the factor σ towards the left end, where the first element has length L σ^m.
    ///
    /// ```
    /// use fractional_sobolev::Mesh;
    /// let mesh = Mesh::geometric(3, 0.5, 1.0)?;
    /// assert_eq!(mesh.nodes(), [0.0, 0.125, 0.25, 0.5, 1.0]);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`Mesh::uniform`]; [`Error::OutOfRange`] unless 0 < σ < 1.
    pub fn geometric(layers: usize, ratio: f64, length: f64) -> Result<Self> {
        require_memory("layers", layers, BYTES)?;
        Self::from_lengths(&geometric_lengths(layers, ratio, length)?)
    }

    /// The mesh with nodes L (i/n)^β, i = 0, ..., n, n = `count`, β = `exponent` > 0, L = `length`: graded
    /// towards the left end for β > 1, as for powers x^a. The lengths x_{i+1} (1 − (i/(i+1))^β) are computed
    /// without cancellation.
    ///
    /// ```
    /// use fractional_sobolev::Mesh;
    /// assert_eq!(Mesh::algebraic(4, 2.0, 16.0)?.nodes(), [0.0, 1.0, 4.0, 9.0, 16.0]);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`Mesh::uniform`]; [`Error::OutOfRange`] unless 0 < β < ∞.
    pub fn algebraic(count: usize, exponent: f64, length: f64) -> Result<Self> {
        require_memory("elements", count, BYTES)?;
        Self::from_lengths(&algebraic_lengths(count, exponent, length)?)
    }

    /// As [`Mesh::algebraic`] from both ends: `count` elements on either half.
    pub(crate) fn two_sided_algebraic(count: usize, exponent: f64, length: f64) -> Result<Self> {
        require_memory("elements", count, 2 * BYTES)?;
        Self::from_lengths(&with_mirror_image(algebraic_lengths(count, exponent, 0.5 * length)?))
    }

    /// The mesh that is geometric towards every given point, the first and the last of which are the ends of
    /// the interval: each part between neighbouring points, of length ℓ, has m + 1 elements on either half,
    /// the shortest ones, of length (ℓ/2) σ^m, at its ends, m = `layers`, σ = `ratio`. To grade a given
    /// number of elements towards one end, use [`Mesh::algebraic`].
    ///
    /// # Errors
    /// As [`Mesh::from_nodes`] for the points; [`Error::OutOfRange`] unless 0 < σ < 1; [`Error::TooLarge`] if
    /// the memory does not suffice.
    pub fn graded(points: &[f64], layers: usize, ratio: f64) -> Result<Self> {
        let coarse = Self::from_nodes(points)?;
        require_memory("layers", layers, 2 * BYTES * coarse.len())?;
        let mut lengths = Vec::with_capacity(2 * (layers + 1) * coarse.len());
        for &length in &coarse.lengths {
            lengths.extend(with_mirror_image(geometric_lengths(layers, ratio, 0.5 * length)?));
        }
        Self::at(coarse.left, lengths)
    }

    /// (λ, the mesh in units of λ), λ a power of two: between the shortest and the longest length if some
    /// lengths lie outside [1e-100, 1e100], so that their squares and powers neither overflow nor underflow;
    /// else 1.
    pub(crate) fn of_moderate_lengths(&self) -> Result<(f64, Self)> {
        let shortest = self.lengths.iter().copied().fold(f64::INFINITY, f64::min);
        if shortest >= 1e-100 && self.total() <= 1e100 {
            return Ok((1.0, self.clone()));
        }
        let unit = power_between(shortest, self.total());
        Ok((unit, Self { left: 0.0, ..self.over(unit)? }))
    }

    /// The mesh in the given unit, a power of two.
    pub(crate) fn over(&self, unit: f64) -> Result<Self> {
        Self::at(self.left / unit, self.lengths.iter().map(|length| length / unit).collect())
    }

    fn at(left: f64, lengths: Vec<f64>) -> Result<Self> {
        if lengths.is_empty() {
            return Err(Error::CountOutOfRange { name: "elements", value: 0, range: "[1, inf)" });
        }
        for (index, &length) in lengths.iter().enumerate() {
            require_entry(
                "element length",
                index,
                length,
                "(0, inf)",
                length > 0.0 && length.is_finite(),
            )?;
        }
        let from_left = running_sums(lengths.iter().copied());
        let mut from_right = running_sums(lengths.iter().rev().copied());
        from_right.reverse();
        let total = from_left[lengths.len()];
        Error::require("total length", total, "(0, inf)", total.is_finite())?;
        let shortest = lengths.iter().copied().fold(f64::INFINITY, f64::min);
        let admissible = shortest >= f64::MIN_POSITIVE && total / shortest <= LARGEST_RATIO;
        let range = "[max(2.3e-308, 1e-303 L), inf), L the length of the interval";
        Error::require("shortest element length", shortest, range, admissible)?;
        Ok(Self { left, lengths, from_left, from_right })
    }

    /// The number of elements.
    #[expect(clippy::len_without_is_empty, reason = "never empty")]
    pub fn len(&self) -> usize {
        self.lengths.len()
    }

    /// The element lengths, from left to right.
    pub fn lengths(&self) -> &[f64] {
        &self.lengths
    }

    /// The length of the interval.
    pub fn total(&self) -> f64 {
        self.from_left[self.lengths.len()]
    }

    /// The coordinate of the left end.
    pub(crate) fn left(&self) -> f64 {
        self.left
    }

    /// The distances of the nodes 0..=len from the left end.
    pub fn from_left(&self) -> &[f64] {
        &self.from_left
    }

    /// The distances of the nodes 0..=len from the right end.
    pub fn from_right(&self) -> &[f64] {
        &self.from_right
    }

    /// The coordinates of the nodes, rounded: for evaluation and plotting, not for distances.
    pub fn nodes(&self) -> Vec<f64> {
        self.from_left.iter().map(|d| self.left + d).collect()
    }

    /// The distance between the nodes i and j, as a sum of lengths. Cost O(|i − j|).
    pub(crate) fn distance(&self, i: usize, j: usize) -> f64 {
        let (low, high) = (i.min(j), i.max(j));
        let mut sum = RunningSum::default();
        self.lengths[low..high].iter().for_each(|&h| sum.add(h));
        sum.value()
    }

    /// The common length if all lengths are equal, else `None`.
    pub(crate) fn uniform_length(&self) -> Option<f64> {
        let first = self.lengths[0];
        self.lengths.iter().all(|&h| h == first).then_some(first)
    }
}

/// The lengths, followed by the same lengths in reverse.
fn with_mirror_image(mut lengths: Vec<f64>) -> Vec<f64> {
    lengths.extend_from_within(..);
    let half = lengths.len() / 2;
    lengths[half..].reverse();
    lengths
}

fn running_sums(lengths: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut sum = RunningSum::default();
    let mut sums = vec![0.0];
    for length in lengths {
        sum.add(length);
        sums.push(sum.value());
    }
    sums
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances_are_sums_of_lengths() {
        let partition = Mesh::from_lengths(&[1.0, 1e-300, 2e-300, 1.0]).unwrap();
        assert_eq!(partition.distance(1, 3), 3e-300);
        assert_eq!(partition.total(), 2.0);
        assert_eq!(partition.from_right()[3], 1.0);
        let many = Mesh::uniform(1_000_000, 1.0).unwrap();
        assert!((many.total() - 1.0).abs() < 1e-15);
    }

    #[test]
    fn constructors_have_the_nodes_they_promise() {
        let geometric = Mesh::geometric(3, 0.5, 8.0).unwrap();
        assert_eq!(geometric.nodes(), [0.0, 1.0, 2.0, 4.0, 8.0]);
        let two = Mesh::graded(&[0.0, 8.0], 2, 0.5).unwrap();
        assert_eq!(two.nodes(), [0.0, 1.0, 2.0, 4.0, 6.0, 7.0, 8.0]);
        let graded = Mesh::graded(&[0.0, 0.25, 1.0], 1, 0.5).unwrap();
        assert_eq!(graded.len(), 8);
        assert_eq!(graded.total(), 1.0);
        for exponent in [0.5, 1.0, 3.0, 20.0] {
            let mesh = Mesh::algebraic(1000, exponent, 2.0).unwrap();
            for (i, x) in mesh.nodes().into_iter().enumerate() {
                let exact = 2.0 * (i as f64 / 1000.0).powf(exponent);
                assert!((x - exact).abs() <= 1e-14 * exact, "{exponent} {i}: {x:e} {exact:e}");
            }
        }
    }

    #[test]
    fn bad_partitions_are_errors() {
        assert!(Mesh::from_nodes(&[0.0, 1.0, 1.0]).is_err());
        assert!(Mesh::from_nodes(&[0.0, f64::NAN, 1.0]).is_err());
        assert!(Mesh::from_nodes(&[0.0, f64::INFINITY]).is_err());
        assert!(Mesh::from_nodes(&[]).is_err());
        assert!(Mesh::uniform(0, 1.0).is_err());
        assert!(Mesh::from_lengths(&[1e-300, 1e300]).is_err());
        assert!(Mesh::geometric(3, 1.0, 1.0).is_err());
        for exponent in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e5] {
            assert!(Mesh::algebraic(3, exponent, 1.0).is_err(), "{exponent}");
        }
        assert!(Mesh::algebraic(0, 2.0, 1.0).is_err());
    }
}
