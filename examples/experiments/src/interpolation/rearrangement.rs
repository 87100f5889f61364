//! Monotone rearrangements of piecewise linear functions, exact up to rounding.

use fractional_sobolev::{Error, Function, Mesh, Result};

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
pub(super) fn decreasing_rearrangement(v: &Function<'_>) -> Result<Function<'static>> {
    let degree = v.degree()?;
    if degree > 1 {
        let (name, range) = ("degree of a function to rearrange", "[0, 1]");
        return Err(Error::CountOutOfRange { name, value: degree, range });
    }
    let mesh = v.mesh()?;
    let elements: Vec<(f64, f64, f64)> = (0..mesh.len())
        .map(|i| Ok((mesh.lengths()[i], v.value(i, 0.0)?, v.value(i, 1.0)?)))
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
    Function::piecewise(&Mesh::from_lengths(lengths)?, 1, ends.as_flattened())
}

#[cfg(test)]
mod tests {
    use super::*;
    use fractional_sobolev::{Order, Tolerance};

    #[test]
    fn steps_are_sorted_with_their_lengths() {
        let partition = Mesh::from_lengths(vec![0.1, 0.2, 0.3, 0.4]).unwrap();
        let steps = Function::piecewise(&partition, 0, &[2.0, -1.0, 2.0, 5.0]).unwrap();
        let sorted = decreasing_rearrangement(&steps).unwrap();
        assert_eq!(sorted.mesh().unwrap().lengths(), [0.4, 0.1 + 0.3, 0.2]);
        let value = |i: usize| sorted.value(i, 0.5).unwrap();
        assert_eq!([value(0), value(1), value(2)], [5.0, 2.0, -1.0]);
    }

    #[test]
    fn norms_stay_and_a_second_rearrangement_changes_nothing() {
        let lengths = vec![0.05, 0.3, 0.15, 0.1, 0.4];
        let partition = Mesh::from_lengths(lengths).unwrap();
        let u = Function::linears(&partition, &[0.3, -1.0, 0.7, 0.7, 2.0, 0.1]).unwrap();
        let sorted = decreasing_rearrangement(&u).unwrap();
        assert!((sorted.mesh().unwrap().total() - 1.0).abs() < 1e-15);
        let end = |i: usize, t: f64| sorted.value(i, t).unwrap();
        assert!((1..sorted.mesh().unwrap().len()).all(|i| end(i - 1, 1.0) == end(i, 0.0)), "continuous");
        for q in [1.0, 2.0, 5.0] {
            let norm = |u: &Function<'_>| u.lp(q, 1e-10).unwrap().value;
            assert!((norm(&sorted) / norm(&u) - 1.0).abs() < 1e-9, "q = {q}");
        }
        let again = decreasing_rearrangement(&sorted).unwrap();
        let order = Order::new(0.3).unwrap();
        let seminorm = |u: &Function<'_>| u.seminorm(order, Tolerance::balanced()).unwrap().value;
        assert!((seminorm(&again) / seminorm(&sorted) - 1.0).abs() < 1e-12);
        assert!(seminorm(&sorted) < seminorm(&u));
        let parabola = Function::interpolate(&Mesh::uniform(2, 1.0).unwrap(), 2, |x| x * x);
        assert!(decreasing_rearrangement(&parabola.unwrap()).is_err());
    }
}
