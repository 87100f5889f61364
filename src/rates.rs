//! A priori bounds of the error for comparison with measured errors: earlier results, the paper, its proof with the
//! sharp constant, and the optimal bound.

use crate::error::{Error, Result};

/// An a priori bound of the H¹ error.
///
/// Each bound is C times the given function of h, C independent of h. For small h and 3/2 < τ ≤ 2,
/// Optimal ≤ Sharpened ≤ Paper ≤ Earlier; at τ = 3/2 all are h^{1/2}.
///
/// ```
/// use signorini::rates::Bound;
/// let exponents = [Bound::Earlier, Bound::Paper, Bound::Optimal].map(|bound| bound.exponent(1.75));
/// assert_eq!(exponents, [Ok(0.625), Ok(0.6875), Ok(0.75)]);
/// assert_eq!(Bound::Paper.law(2.0)?, "h |ln h|^1/2");
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Bound {
    /// h^{τ/2 − 1/4} (E2), at τ = 2 h^{3/4} (E3).
    Earlier,
    /// h^{τ² − 5τ/2 + 2} (3.1), (4.2), at τ = 2 h |ln h|^{1/2} (3.2), (4.3).
    Paper,
    /// The same proof with the sharp constant of Lemma 5.2 at ν = 1/2: as [`Bound::Paper`] for τ < 2, h |ln h|^{1/4}
    /// at τ = 2.
    Sharpened,
    /// h^{τ − 1}, proved by Drouet and Hild, SIAM J. Numer. Anal. 53 (2015) 1488-1507.
    Optimal,
}

impl Bound {
    /// The value of the bound, without its constant, for 1 < τ ≤ 5/2 and 0 < h < 1.
    ///
    /// ```
    /// use signorini::rates::Bound;
    /// assert_eq!(Bound::Optimal.value(0.25, 1.5)?, 0.5);
    /// assert!((Bound::Paper.value(0.25, 2.0)? - 0.25 * 4f64.ln().sqrt()).abs() < 1e-16);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::OutOfRange`](crate::ToolkitError::OutOfRange) for arguments outside these ranges.
    pub fn value(self, h: f64, tau: f64) -> Result<f64> {
        Error::require("h", h, "(0, 1)", h > 0.0 && h < 1.0)?;
        Ok(h.powf(self.exponent(tau)?) * h.ln().abs().powf(self.logarithm(tau)))
    }

    /// The formula as text: `h^0.6875`, `h |ln h|^1/2`.
    ///
    /// # Errors
    /// As for [`Bound::exponent`].
    pub fn law(self, tau: f64) -> Result<String> {
        let exponent = self.exponent(tau)?;
        let power = if exponent == 1.0 { "h".to_owned() } else { format!("h^{exponent:.4}") };
        let logarithm = self.logarithm(tau);
        Ok(if logarithm > 0.0 { format!("{power} |ln h|^1/{}", 1.0 / logarithm) } else { power })
    }

    /// The points (h, C bound(h)) for the given h, with C such that the bound passes through the given point (h₀,
    /// e₀).
    ///
    /// ```
    /// use signorini::rates::Bound;
    /// let line = Bound::Optimal.through((0.25, 3.0), [0.25, 0.0625].into_iter(), 2.0)?;
    /// assert_eq!(line, [(0.25, 3.0), (0.0625, 0.75)]);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`Bound::value`].
    pub fn through(
        self,
        (start, error): (f64, f64),
        mesh_sizes: impl Iterator<Item = f64>,
        tau: f64,
    ) -> Result<Vec<(f64, f64)>> {
        let constant = error / self.value(start, tau)?;
        mesh_sizes.map(|h| Ok((h, constant * self.value(h, tau)?))).collect()
    }

    /// The exponent of h, for 1 < τ ≤ 5/2, the regularity at a transition inside a straight edge. For τ > 2 it is 1 for every bound: (E4), (4.4); for τ ≤ 3/2 it is τ − 1
    /// for every bound: (E1).
    ///
    /// # Errors
    /// [`ToolkitError::OutOfRange`](crate::ToolkitError::OutOfRange) for τ outside this range.
    pub fn exponent(self, tau: f64) -> Result<f64> {
        Error::require("tau", tau, "(1, 5/2]", tau > 1.0 && tau <= 2.5)?;
        if tau > 2.0 {
            return Ok(1.0);
        }
        if tau <= 1.5 {
            return Ok(tau - 1.0);
        }
        Ok(match self {
            Bound::Earlier => 0.5 * tau - 0.25,
            Bound::Paper | Bound::Sharpened => tau * tau - 2.5 * tau + 2.0,
            Bound::Optimal => tau - 1.0,
        })
    }

    /// The exponent of |ln h|: 1/2 for [`Bound::Paper`] and 1/4 for [`Bound::Sharpened`] at τ = 2,
    /// otherwise 0.
    pub fn logarithm(self, tau: f64) -> f64 {
        match self {
            Bound::Paper if tau == 2.0 => 0.5,
            Bound::Sharpened if tau == 2.0 => 0.25,
            _ => 0.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_paper_is_furthest_from_optimal_at_seven_quarters() {
        let gap =
            |tau: f64| Bound::Optimal.exponent(tau).unwrap() - Bound::Paper.exponent(tau).unwrap();
        assert_eq!(gap(1.75), 1.0 / 16.0);
        assert!(gap(1.74) < gap(1.75) && gap(1.76) < gap(1.75) && gap(2.0) == 0.0);
        assert!(Bound::Paper.value(0.5, 1.0).is_err() && Bound::Paper.value(0.5, 2.6).is_err());
        assert_eq!(Bound::Paper.value(0.125, 2.1), Ok(0.125));
        let logarithm = 0.125 * 8f64.ln().powf(0.25);
        assert!((Bound::Sharpened.value(0.125, 2.0).unwrap() / logarithm - 1.0).abs() < 1e-15);
    }
}
