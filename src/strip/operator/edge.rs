//! The edge operator: a translation-invariant symmetric operator on the contact edge, diagonal in Fourier
//! modes.
//!
//! Periodic sides: n nodes, (A g)^(k) = S(θ_k) ĝ(k), θ_k = 2πk/n. Natural sides: n + 1 nodes; the even extension of g
//! has period 2n, so that the same formula holds with θ_k = πk/n (type-I cosine modes) and A = W · (restriction),
//! W = diag(½, 1, ..., 1, ½). In both cases the stored symbol S(θ) covers θ = 2πk/P, k = 0 ... P/2, P the period, and
//!
//! g'A g = (γ/P) Σ_{k mod P} S(θ_k) |ĝ(k)|²,  γ = 1 (periodic), ½ (natural).
//!
//! S > 0, so A is positive definite. A product or a solve costs one real FFT of length P and one back: O(n
//! log n).

use super::fourier::{RealFourier, Workspace};
use crate::cone::{Cone, EdgeCone};
use crate::error::{Error, Result};
use crate::numeric::check::{require_length, require_values};
use crate::numeric::sum::pairwise_sum;
use crate::strip::sides::LateralCondition;
use fractional_sobolev_numeric::transforms::{Complex, Planner};
use std::fmt;

/// A symmetric positive definite translation-invariant operator A on the contact edge, given by its symbol S(θ).
///
/// It is the Schur complement of the stiffness matrix of the body on the contact edge: ½ g'A g is the minimal energy
/// of the body with edge displacement g. For a strip of m layers and height H, S grows like θ for 1/m ≪ θ ≪ 1, so
/// that g'A g is equivalent to |g|²_{1/2} + ‖g‖²/H.
///
/// ```
/// use signorini::strip::{EdgeOperator, LateralCondition};
/// // any positive values S(2πk/P), P = 8 the period; S = 1: with natural sides A is W = diag(1/2, 1, ..., 1, 1/2)
/// let identity = EdgeOperator::new(4, LateralCondition::Natural, &[1.0; 5])?;
/// let image = identity.apply(&[2.0; 5])?;
/// assert!(image.iter().zip([1.0, 2.0, 2.0, 2.0, 1.0]).all(|(a, b)| (a - b).abs() < 1e-14));
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Clone)]
pub struct EdgeOperator {
    cells: usize,
    sides: LateralCondition,
    symbol: Vec<f64>,
    norm: f64,
    fourier: RealFourier,
}

impl fmt::Debug for EdgeOperator {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "EdgeOperator({} cells, {:?} sides)", self.cells, self.sides)
    }
}

impl EdgeOperator {
    /// The operator with the given values of the symbol at θ = 2πk/P, k = 0, ..., P/2, where P is the period in
    /// cells: 2n with natural sides, n with periodic sides.
    ///
    /// Cost: O(n), and the planning of two transforms of length P.
    ///
    /// ```
    /// use signorini::strip::{EdgeOperator, LateralCondition::Periodic};
    /// // S(θ) = 1 + 4 sin²(θ/2), closed edge of 4 nodes: identity plus second differences, row (−1, 3, −1)
    /// let a = EdgeOperator::new(4, Periodic, &[1.0, 3.0, 5.0])?;
    /// let column = a.apply(&[1.0, 0.0, 0.0, 0.0])?;
    /// assert!(column.iter().zip([3.0, -1.0, 0.0, -1.0]).all(|(a, b)| (a - b).abs() < 1e-14));
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) as for
    /// [`LateralCondition::check_cells`],
    /// [`ToolkitError::LengthMismatch`](crate::ToolkitError::LengthMismatch) or
    /// [`ToolkitError::OutOfRange`](crate::ToolkitError::OutOfRange) unless there are P/2 + 1 positive finite
    /// values.
    pub fn new(cells: usize, sides: LateralCondition, symbol: &[f64]) -> Result<Self> {
        sides.check_cells(cells)?;
        let period = sides.period(cells);
        require_length("symbol", symbol.len(), period / 2 + 1)?;
        for &value in symbol {
            Error::require("symbol", value, "(0, inf)", value > 0.0 && value.is_finite())?;
        }
        Ok(Self {
            cells,
            sides,
            norm: symbol.iter().fold(0.0, |m: f64, &s| m.max(s)),
            symbol: symbol.to_vec(),
            fourier: RealFourier::new(&mut Planner::default(), period),
        })
    }

    /// Number n of cells of the edge; h = 1/n.
    pub fn cells(&self) -> usize {
        self.cells
    }

    /// Number of nodes: n + 1 with natural sides, n with periodic sides.
    pub fn nodes(&self) -> usize {
        self.sides.nodes(self.cells)
    }

    /// The lateral conditions.
    pub fn sides(&self) -> LateralCondition {
        self.sides
    }

    /// The given contact cone on this edge.
    ///
    /// The edge is open with n + 1 nodes for natural lateral conditions, closed with n nodes for periodic ones; the
    /// midpoint cone has n constraints in both cases.
    pub fn cone(&self, cone: Cone) -> EdgeCone {
        cone.on(self.nodes(), self.sides.ends())
    }

    /// The values S(2πk/P), k = 0, ..., P/2, of the symbol, P the period in cells.
    ///
    /// These are the eigenvalues of A with periodic sides, and of W⁻¹A with natural sides. They are nondimensional
    /// and O(1); for a scalar strip of m layers the smallest one is 1/m, at k = 0.
    pub fn symbol(&self) -> &[f64] {
        &self.symbol
    }

    /// The largest value of the symbol: the spectral norm of A with periodic sides, of W^{−1/2} A W^{−1/2}
    /// with natural sides, W the diagonal matrix of the weights.
    ///
    /// It is max_k S(θ_k); the step length of the projected gradient method is its reciprocal.
    ///
    /// ```
    /// use signorini::strip::Strip;
    /// // S(π) = 2 √2 coth(m φ), φ = 2 asinh 1
    /// let norm = Strip::scalar(8, 8)?.operator().norm();
    /// assert!((norm - 2.0 * 2f64.sqrt()).abs() < 1e-10);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    pub fn norm(&self) -> f64 {
        self.norm
    }

    /// The position i/n of node i.
    ///
    /// ```
    /// let strip = signorini::strip::Strip::scalar(8, 8)?;
    /// let a = strip.operator();
    /// assert_eq!((a.position(0), a.position(2), a.position(8)), (0.0, 0.25, 1.0));
    /// // nodal lengths h W_i sum to 1
    /// assert_eq!((0..a.nodes()).map(|i| a.weight(i)).sum::<f64>(), a.cells() as f64);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    pub fn position(&self, node: usize) -> f64 {
        node as f64 / self.cells as f64
    }

    /// The weight W_i: ½ at the two ends of an edge with natural sides, 1 otherwise.
    ///
    /// h W_i is the length associated with node i, ∫ φ_i.
    pub fn weight(&self, node: usize) -> f64 {
        if self.sides == LateralCondition::Natural && (node == 0 || node == self.cells) {
            0.5
        } else {
            1.0
        }
    }

    /// The product A g: the nodal forces that hold the edge at the displacement g.
    ///
    /// Cost: two real transforms of length P, the period in cells: O(n log n). The relative rounding error is about
    /// ε log₂ P in the Euclidean norm.
    ///
    /// ```
    /// use signorini::strip::Strip;
    /// let strip = Strip::scalar(8, 8)?;
    /// let a = strip.operator();
    /// let [v, w] = [0.3, 0.7].map(|t: f64| (0..9).map(|i| (t * i as f64).sin()).collect::<Vec<_>>());
    /// let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    /// // symmetry
    /// assert!((product(&a.apply(&v)?, &w) - product(&v, &a.apply(&w)?)).abs() < 1e-13);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::LengthMismatch`](crate::ToolkitError::LengthMismatch) unless g has one value per node;
    /// [`ToolkitError::NotFinite`](crate::ToolkitError::NotFinite) unless all values are finite.
    pub fn apply(&self, g: &[f64]) -> Result<Vec<f64>> {
        require_values("edge values", g, self.nodes())?;
        let mut out = vec![0.0; self.nodes()];
        self.apply_into(g, &mut out, &mut self.workspace())?;
        Ok(out)
    }

    /// The solution A⁻¹ b: the edge displacement under nodal forces b.
    ///
    /// It minimises ½ g'A g − b'g over all g, that is, without the contact condition. Rounding errors are amplified
    /// by the condition number max S/min S, about 3m for a scalar strip of m layers. Cost: O(n log n).
    ///
    /// ```
    /// use signorini::strip::Strip;
    /// let strip = Strip::scalar(8, 8)?;
    /// let g: Vec<f64> = (0..9).map(|i| (i as f64).cos()).collect();
    /// let back = strip.operator().solve(&strip.operator().apply(&g)?)?;
    /// assert!(back.iter().zip(&g).all(|(a, b)| (a - b).abs() < 1e-12));
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`EdgeOperator::apply`].
    pub fn solve(&self, b: &[f64]) -> Result<Vec<f64>> {
        require_values("edge forces", b, self.nodes())?;
        let mut out = vec![0.0; self.nodes()];
        self.solve_into(b, &mut out, &mut self.workspace())?;
        Ok(out)
    }

    /// The quadratic form g'A g, as a sum of nonnegative terms over the modes.
    ///
    /// It equals (γ/P) Σ_k S(θ_k) |ĝ(k)|², k modulo the period P, γ = 1/2 with natural and 1 with periodic sides:
    /// twice the minimal energy J of the unloaded body with edge displacement g.
    ///
    /// ```
    /// use signorini::strip::Strip;
    /// // the mode cos(πx) of a scalar strip: g'A g = n S(π/n)/2
    /// let n = 8;
    /// let strip = Strip::scalar(n, n)?;
    /// let g: Vec<f64> = (0..=n).map(|i| (std::f64::consts::PI * i as f64 / n as f64).cos()).collect();
    /// let exact = 0.5 * n as f64 * strip.operator().symbol()[1];
    /// assert!((strip.operator().energy(&g)? - exact).abs() < 1e-13);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`EdgeOperator::apply`].
    pub fn energy(&self, g: &[f64]) -> Result<f64> {
        require_values("edge values", g, self.nodes())?;
        let mut work = self.workspace();
        self.transform(g, |_| 1.0, &mut work)?;
        Ok(self.mode_sum(&work.spectrum, |k| self.symbol[k]))
    }

    pub(crate) fn workspace(&self) -> Workspace {
        self.fourier.workspace()
    }

    pub(crate) fn apply_into(
        &self,
        g: &[f64],
        out: &mut [f64],
        work: &mut Workspace,
    ) -> Result<()> {
        self.transform(g, |_| 1.0, work)?;
        self.multiply(work, |s| s);
        self.fourier.backward(work)?;
        for i in 0..self.nodes() {
            out[i] = self.weight(i) * work.real[i];
        }
        Ok(())
    }

    pub(crate) fn solve_into(
        &self,
        b: &[f64],
        out: &mut [f64],
        work: &mut Workspace,
    ) -> Result<()> {
        self.transform(b, |i| 1.0 / self.weight(i), work)?;
        self.multiply(work, |s| 1.0 / s);
        self.fourier.backward(work)?;
        out.copy_from_slice(&work.real[..self.nodes()]);
        Ok(())
    }

    /// The modes ĝ(k), k = 0 ... P/2, of the (evenly extended) edge function g.
    pub(crate) fn modes(&self, g: &[f64]) -> Result<Vec<Complex<f64>>> {
        let mut work = self.workspace();
        self.transform(g, |_| 1.0, &mut work)?;
        Ok(work.spectrum)
    }

    /// The modes of dual nodal values b, that is of W⁻¹ b.
    ///
    /// W⁻¹ turns the end values of a dual vector into those of an even function: (A⁻¹ b)^(k) = (W⁻¹ b)^(k)/S(θ_k).
    pub(crate) fn dual_modes(&self, b: &[f64]) -> Result<Vec<Complex<f64>>> {
        let mut work = self.workspace();
        self.transform(b, |i| 1.0 / self.weight(i), &mut work)?;
        Ok(work.spectrum)
    }

    /// The edge function with the given modes.
    pub(crate) fn with_modes(&self, modes: &[Complex<f64>]) -> Result<Vec<f64>> {
        let mut work = self.workspace();
        work.spectrum.copy_from_slice(modes);
        self.fourier.backward(&mut work)?;
        let scale = 1.0 / self.sides.period(self.cells) as f64;
        work.real.truncate(self.nodes());
        work.real.iter_mut().for_each(|v| *v *= scale);
        Ok(work.real)
    }

    /// (γ/P) Σ_{k mod P} f(k) |ĝ(k)|², summed in pairs.
    pub(crate) fn mode_sum(
        &self,
        modes: &[Complex<f64>],
        factor: impl Fn(usize) -> f64 + Copy,
    ) -> f64 {
        self.mode_sum_of(|k| factor(k) * modes[k].norm_sqr())
    }

    /// (γ/P) Σ_{k mod P} f(k), summed in pairs.
    pub(crate) fn mode_sum_of(&self, term: impl Fn(usize) -> f64 + Copy) -> f64 {
        let period = self.sides.period(self.cells);
        let last = period / 2;
        let inner = pairwise_sum(1, last, term);
        let gamma = match self.sides {
            LateralCondition::Natural => 0.5,
            LateralCondition::Periodic => 1.0,
        };
        gamma * (term(0) + 2.0 * inner + term(last)) / period as f64
    }

    fn transform(
        &self,
        g: &[f64],
        scale: impl Fn(usize) -> f64,
        work: &mut Workspace,
    ) -> Result<()> {
        let nodes = self.nodes();
        for i in 0..nodes {
            work.real[i] = g[i] * scale(i);
        }
        if self.sides == LateralCondition::Natural {
            for i in nodes..2 * self.cells {
                work.real[i] = work.real[2 * self.cells - i];
            }
        }
        self.fourier.forward(work)?;
        if self.sides == LateralCondition::Natural {
            work.spectrum.iter_mut().for_each(|v| v.im = 0.0);
        }
        Ok(())
    }

    fn multiply(&self, work: &mut Workspace, factor: impl Fn(f64) -> f64) {
        let scale = 1.0 / self.sides.period(self.cells) as f64;
        for (value, &s) in work.spectrum.iter_mut().zip(&self.symbol) {
            *value *= scale * factor(s);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rounding of two transforms of length ≤ 64.
    const ROUNDING: f64 = 1e-13;

    fn operator(sides: LateralCondition) -> EdgeOperator {
        let cells = 12;
        let symbol = (0..=sides.period(cells) / 2).map(|k| 0.3 + k as f64).collect::<Vec<_>>();
        EdgeOperator::new(cells, sides, &symbol).unwrap()
    }

    #[test]
    fn product_and_solve_are_inverse_symmetric_and_give_the_energy() {
        for sides in [LateralCondition::Natural, LateralCondition::Periodic] {
            let a = operator(sides);
            let g: Vec<f64> = (0..a.nodes()).map(|i| (1.0 + i as f64).sin()).collect();
            let v: Vec<f64> = (0..a.nodes()).map(|i| (3.0 * i as f64).cos()).collect();
            let back = a.solve(&a.apply(&g).unwrap()).unwrap();
            let worst = g.iter().zip(&back).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
            assert!(worst < ROUNDING, "{sides:?}: {worst}");
            let dot = |x: &[f64], y: &[f64]| x.iter().zip(y).map(|(p, q)| p * q).sum::<f64>();
            let (left, right) = (dot(&a.apply(&g).unwrap(), &v), dot(&a.apply(&v).unwrap(), &g));
            assert!((left - right).abs() < ROUNDING * left.abs().max(1.0));
            let (energy, product) = (a.energy(&g).unwrap(), dot(&a.apply(&g).unwrap(), &g));
            assert!((energy - product).abs() < ROUNDING * energy);
            let again = a.with_modes(&a.modes(&g).unwrap()).unwrap();
            assert!(g.iter().zip(&again).all(|(x, y)| (x - y).abs() < ROUNDING));
        }
    }

    #[test]
    fn misuse_is_an_error() {
        assert!(EdgeOperator::new(1, LateralCondition::Natural, &[1.0, 1.0]).is_err());
        assert!(EdgeOperator::new(5, LateralCondition::Periodic, &[1.0; 3]).is_err());
        assert!(EdgeOperator::new(4, LateralCondition::Natural, &[1.0; 4]).is_err());
        assert!(EdgeOperator::new(2, LateralCondition::Natural, &[1.0, 0.0, f64::NAN]).is_err());
        assert!(operator(LateralCondition::Natural).apply(&[f64::NAN; 13]).is_err());
        assert!(operator(LateralCondition::Periodic).solve(&[1.0; 3]).is_err());
    }
}
