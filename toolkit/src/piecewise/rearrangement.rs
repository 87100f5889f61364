//! Monotone rearrangements of piecewise linear functions, exact up to rounding.

use super::polynomial::PiecewisePolynomial;
use crate::error::{Error, Result};
use crate::mesh::Mesh;

impl PiecewisePolynomial {
    /// The decreasing rearrangement v* of a function of degree at most one, on the same interval.
    ///
    /// # Method
    ///
    /// v* decreases and takes every range of values on a set of the same measure as v. Between two
    /// neighbouring values a > b among those at the ends of elements, an element of length h with ends c, d
    /// on both sides of them holds values in (b, a) on the length h (a − b)/|c − d|: the distribution
    /// function is piecewise linear, and so is v*. Cost: (number of elements)².
    ///
    /// # Errors
    /// [`Error::CountOutOfRange`] for a higher degree; [`Error::OutOfRange`] when v* has elements more than
    /// 1e303 times shorter than the interval.
    pub(crate) fn decreasing_rearrangement(&self) -> Result<Self> {
        if self.degree() > 1 {
            let (value, range) = (self.degree(), "[0, 1]");
            return Err(Error::CountOutOfRange { name: "degree of a function to rearrange", value, range });
        }
        let elements: Vec<(f64, f64, f64)> = (0..self.mesh().len())
            .map(|i| Ok((self.mesh().lengths()[i], self.value(i, 0.0)?, self.value(i, 1.0)?)))
            .collect::<Result<_>>()?;
        let mut values: Vec<f64> = elements.iter().flat_map(|&(_, left, right)| [left, right]).collect();
        values.sort_by(|a, b| b.total_cmp(a));
        values.dedup();
        let (mut lengths, mut ends) = (Vec::new(), Vec::new());
        let mut push = |length: f64, pair: [f64; 2]| {
            if length > 0.0 {
                lengths.push(length);
                ends.push(pair);
            }
        };
        for (k, &high) in values.iter().enumerate() {
            let constant = elements.iter().filter(|&&(_, left, right)| left == high && right == high);
            push(constant.map(|element| element.0).sum(), [high, high]);
            if let Some(&low) = values.get(k + 1) {
                let across = elements.iter().filter(|&&(_, c, d)| c.min(d) <= low && c.max(d) >= high);
                push(across.map(|&(h, c, d)| h * ((high - low) / (c - d).abs())).sum(), [high, low]);
            }
        }
        Self::discontinuous_linears(Mesh::from_lengths(lengths)?, &ends)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Order;
    use crate::estimate::Tolerance;

    #[test]
    fn steps_are_sorted_with_their_lengths() {
        let partition = Mesh::from_lengths(vec![0.1, 0.2, 0.3, 0.4]).unwrap();
        let steps = PiecewisePolynomial::constants(partition, &[2.0, -1.0, 2.0, 5.0]).unwrap();
        let sorted = steps.decreasing_rearrangement().unwrap();
        assert_eq!(sorted.mesh().lengths(), [0.4, 0.1 + 0.3, 0.2]);
        let value = |i: usize| sorted.value(i, 0.5).unwrap();
        assert_eq!([value(0), value(1), value(2)], [5.0, 2.0, -1.0]);
        assert!(sorted.is_continuous() == steps.is_continuous());
    }

    #[test]
    fn norms_stay_and_a_second_rearrangement_changes_nothing() {
        let lengths = vec![0.05, 0.3, 0.15, 0.1, 0.4];
        let partition = Mesh::from_lengths(lengths).unwrap();
        let u = PiecewisePolynomial::linears(partition, &[0.3, -1.0, 0.7, 0.7, 2.0, 0.1]).unwrap();
        let sorted = u.decreasing_rearrangement().unwrap();
        assert!(sorted.is_continuous() && (sorted.mesh().total() - 1.0).abs() < 1e-15);
        for q in [1.0, 2.0, 5.0] {
            let norm = |u: &PiecewisePolynomial| u.lq_norm(q, Tolerance::new(1e-10).unwrap()).unwrap().value;
            assert!((norm(&sorted) / norm(&u) - 1.0).abs() < 1e-9, "q = {q}");
        }
        let again = sorted.decreasing_rearrangement().unwrap();
        let order = Order::new(0.3).unwrap();
        let seminorm = |u: &PiecewisePolynomial| u.seminorm(order, Tolerance::balanced()).unwrap().value;
        assert!((seminorm(&again) / seminorm(&sorted) - 1.0).abs() < 1e-12);
        assert!(seminorm(&sorted) < seminorm(&u));
        let parabola = PiecewisePolynomial::interpolate(Mesh::uniform(2, 1.0).unwrap(), 2, |x| x * x);
        assert!(parabola.unwrap().decreasing_rearrangement().is_err());
    }
}
