//! The discretisation error, estimated from the energies of nested levels.
//!
//! With u_k the minimiser of one functional J on level k of nested spaces, J_k = J(u_k), in the energy norm
//! |u_k − u_{k−1}|² = 2 (J_{k−1} − J_k) up to a nonnegative contact term;
//! with an order p estimated from the last two differences, clipped to [1/4, 1], |u − u_k|² = |u_k − u_{k−1}|²/(4^p −
//! 1). The load is that of the finest level; its quadrature error is not included.

/// The range of admissible orders.
const ORDERS: (f64, f64) = (0.25, 1.0);

/// The energies so far.
#[derive(Debug, Clone)]
pub(super) struct Discretisation {
    energies: Vec<f64>,
}

impl Discretisation {
    pub(super) fn new(coarsest: f64) -> Self {
        Self { energies: vec![coarsest] }
    }

    pub(super) fn add(&mut self, energy: f64) {
        self.energies.push(energy);
    }

    /// The estimate of |u − u_k|_a on the last level; `None` for fewer than three levels, and if J did not decrease.
    ///
    /// |u − u_k| ≈ (2 (J_{k−1} − J_k)/(4^p − 1))^{1/2}, p = ½ log₂ of the ratio of the last two energy differences.
    pub(super) fn here(&self) -> Option<f64> {
        let [.., first, second, third] = self.energies[..] else { return None };
        let (before, now) = ((first - second).max(0.0), (second - third).max(0.0));
        (now > 0.0).then(|| (2.0 * now / (4_f64.powf(order(before, now)) - 1.0)).sqrt())
    }

    /// The estimate of the discretisation error on the next level.
    pub(super) fn next(&self) -> Option<f64> {
        let [.., first, second, third] = self.energies[..] else { return None };
        let p = order((first - second).max(0.0), (second - third).max(0.0));
        self.here().map(|error| error * 0.5_f64.powf(p))
    }
}

/// ½ log₂((J_{k−2} − J_{k−1})/(J_{k−1} − J_k)), clipped to the admissible range.
fn order(before: f64, now: f64) -> f64 {
    (0.5 * (before / now).log2()).clamp(ORDERS.0, ORDERS.1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn geometric_energies_give_the_order() {
        let mut found = Discretisation::new(-1.0 + 1.0);
        assert_eq!(found.here(), None);
        // J_k − J = h²/2, h = 1, 1/2, 1/4: |u − u_k| = h.
        found = Discretisation::new(0.5);
        found.add(0.125);
        found.add(0.03125);
        assert!((found.here().unwrap() - 0.25).abs() < 1e-15);
        assert!((found.next().unwrap() - 0.125).abs() < 1e-15);
    }
}
