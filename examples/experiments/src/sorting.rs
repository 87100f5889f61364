//! `remark_7_rearrangement`: the sorting lemma. Of all orders of n numbers the sorted one has the smallest
//! Σ (f_i − f_j)² over the
//! pairs at distance |i − j| ≤ k, for every k; with every weight that decreases in |i − j| in place of the
//! pairs.

use crate::SplitMix;

/// Σ (f_i − f_j)² over all pairs i < j with j − i ≤ `reach`.
///
/// ```
/// use experiments::sorting::near_differences;
/// let (sorted, mixed) = ([0.0, 1.0, 2.0, 3.0], [1.0, 0.0, 3.0, 2.0]);
/// assert!((1..4).all(|reach| near_differences(&sorted, reach) <= near_differences(&mixed, reach)));
/// ```
pub fn near_differences(values: &[f64], reach: usize) -> f64 {
    let row = |(i, a): (usize, &f64)| -> f64 {
        values[i + 1..].iter().take(reach).map(|b| (a - b) * (a - b)).sum()
    };
    values.iter().enumerate().map(row).sum()
}

/// The largest quotient over all reaches of [`near_differences`] in sorted and in given order: at most one,
/// by the lemma. Zero for equal numbers. Exact comparisons as long as the sums are, as for whole numbers.
///
/// ```
/// use experiments::sorting::{sorted_share, sorted_share_of_orders, sorted_share_of_random};
/// assert!(sorted_share(&[1.0, 0.0, 3.0, 2.0]) <= 1.0);
/// assert_eq!(sorted_share_of_orders(&[0.0, 1.0, 5.0]), 1.0); // the sorted order is among them
/// assert!(sorted_share_of_random(20, 1) <= 1.0);
/// ```
pub fn sorted_share(values: &[f64]) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let quotient = |reach| near_differences(&sorted, reach) / near_differences(values, reach);
    (1..values.len()).map(quotient).filter(|share| !share.is_nan()).fold(0.0, f64::max)
}

/// The largest [`sorted_share`] over all orders of the numbers; n! orders.
pub fn sorted_share_of_orders(values: &[f64]) -> f64 {
    fn from(values: &mut [f64], fixed: usize) -> f64 {
        if fixed + 1 >= values.len() {
            return sorted_share(values);
        }
        let mut worst: f64 = 0.0;
        for other in fixed..values.len() {
            values.swap(fixed, other);
            worst = worst.max(from(values, fixed + 1));
            values.swap(fixed, other);
        }
        worst
    }
    from(&mut values.to_vec(), 0)
}

/// The largest [`sorted_share`] of `count` random sequences of 2 to 40 whole numbers, some with ties.
pub fn sorted_share_of_random(count: u32, seed: u64) -> f64 {
    let mut random = SplitMix::new(seed);
    let mut draw = |_| {
        let (length, most) = (2 + random.below(39), 2 + random.below(1000));
        let values: Vec<f64> = (0..length).map(|_| random.below(most) as f64).collect();
        sorted_share(&values)
    };
    (0..count).map(&mut draw).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sorted_orders_and_full_reach_have_share_one_and_no_order_more() {
        assert_eq!(sorted_share(&[3.0, 2.0, 1.0]), 1.0);
        assert_eq!(sorted_share(&[2.0, 2.0]), 0.0);
        for n in 2..=7u32 {
            let powers: Vec<f64> = (0..n).map(|k| 3f64.powi(k as i32)).collect();
            let words: Vec<f64> = (0..n).map(|k| f64::from(k % 3)).collect();
            assert_eq!(sorted_share_of_orders(&powers), 1.0, "{n} numbers");
            assert_eq!(sorted_share_of_orders(&words), 1.0, "{n} letters");
        }
        assert!(sorted_share_of_random(2000, 1) <= 1.0);
    }
}
