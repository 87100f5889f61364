//! Sums whose rounding error does not grow with the number of terms, or only like its logarithm.

/// A running sum with Neumaier's compensation (ZAMM 54, 1974): error about 1 ulp plus n ε² Σ|terms|.
#[derive(Debug, Clone, Copy, Default)]
pub struct RunningSum {
    sum: f64,
    carry: f64,
}

impl RunningSum {
    /// Adds one term.
    #[inline]
    pub fn add(&mut self, term: f64) {
        let next = self.sum + term;
        self.carry += if self.sum.abs() >= term.abs() {
            (self.sum - next) + term
        } else {
            (term - next) + self.sum
        };
        self.sum = next;
    }

    /// The current sum.
    #[inline]
    pub fn value(&self) -> f64 {
        self.sum + self.carry
    }
}

/// The compensated sum of all terms.
#[doc(alias("Kahan", "Neumaier"))]
pub fn compensated(terms: impl IntoIterator<Item = f64>) -> f64 {
    let mut sum = RunningSum::default();
    terms.into_iter().for_each(|term| sum.add(term));
    sum.value()
}

/// Σ_{start ≤ k < end} term(k) by pairwise summation: the rounding error grows like the logarithm of the number
/// of terms.
pub fn pairwise_sum(start: usize, end: usize, term: impl Fn(usize) -> f64 + Copy) -> f64 {
    const LEAF: usize = 64;
    if end.saturating_sub(start) <= LEAF {
        return (start..end).map(term).sum();
    }
    let middle = start + (end - start) / 2;
    pairwise_sum(start, middle, term) + pairwise_sum(middle, end, term)
}

/// Σ a_i b_i over the length of a by pairwise summation, fast enough for iterations. b must not be shorter.
pub fn pairwise_dot(a: &[f64], b: &[f64]) -> f64 {
    pairwise_sum(0, a.len(), |i| a[i] * b[i])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_cancels_is_not_lost() {
        assert_eq!(compensated([1.0, 1e100, 1.0, -1e100]), 2.0);
        assert_eq!(compensated([]), 0.0);
        let tenths = vec![0.1; 1_000_000];
        assert!((compensated(tenths.iter().copied()) - 1e5).abs() < 1e-10);
        assert!((pairwise_dot(&tenths, &tenths) - 1e4).abs() < 1e-9);
    }
}
