//! Norms of order ν and 1 + ν of piecewise polynomials, (1.1) of the paper; names and arguments as for
//! functions.

use super::pairs::{Cell, PairSum, PolynomialPairs};
use super::polynomial::PiecewisePolynomial;
use crate::error::{Error, Result};
use crate::estimate::{Estimate, Tolerance, Work};
use crate::numeric::scale::power_of_two;
use crate::numeric::sum::RunningSum;
use crate::quadrature::Rule;
use crate::sobolev::gram::GramOperator;
use crate::sobolev::gram::dense::{FarRow, constants_on, neighbours_linear};
use crate::sobolev::kernel::cells::CellPairs;
use crate::sobolev::order::FractionalOrder;
use crate::sobolev::root::{ENTRY_ROUNDING, accept, root_of_squares, scaled};
use rayon::prelude::*;

/// Elements up to which all pairs are summed directly.
const DIRECT: usize = 3000;
/// Elements up to which they are when the fast product is not accurate enough.
const PATIENT: usize = 16_000;
/// Asked of the fast product.
const FAST_FORM: Tolerance = Tolerance::reference();
/// Error of the fast product, entry by entry, relative to |A| |x|; measured below 1e-14.
const FAST_ROUNDING: f64 = 1e-13;
/// What ends the accuracy of a quadratic form.
const LIMIT: &str = "rounding of the form; fewer elements or a smoother function have more digits";

impl PiecewisePolynomial {
    /// The seminorm |u|_ν.
    ///
    /// # Method
    ///
    /// ```text
    /// |u|²_ν = ∫∫ (u(x)−u(y))² / |x−y|^{1+2ν},  ||u||²_{m+ν} = Σ_{k≤m} ||u^{(k)}||² + |u^{(m)}|²_ν,  m < 2.
    /// ```
    ///
    /// Piecewise constants and continuous piecewise linears go through the Gram matrix in the form −Σ_{i<j}
    /// a_ij (u_i−u_j)², which uses that constants have seminorm zero and so keeps its digits when u is nearly
    /// constant; other degrees are integrated pair by pair (`pairs`). Everything is exact to rounding; the
    /// [`Tolerance`] is what the rounding is held against. Cost O(N²) kernel values, without a stored matrix;
    /// beyond 3000 elements constants and linears take the fast product xᵀAx, whose rounding is relative to Σ
    /// a_ii x_i², and return to the pairs (up to 16000 elements, some ten seconds) where that rounding
    /// exceeds the tolerance.
    ///
    /// # Errors
    /// [`Error::InfiniteNorm`] when u jumps and ν ≥ 1/2; [`Error::ToleranceNotMet`] when rounding exceeds the
    /// tolerance.
    #[doc(alias("Gagliardo", "Slobodeckij"))]
    pub fn seminorm(&self, order: FractionalOrder, tolerance: Tolerance) -> Result<Estimate> {
        accept("seminorm", self.seminorm_as_it_is(order, tolerance)?, tolerance, LIMIT)
    }

    /// The norm ||u||_ν: its square is the sum of the squares of the L² norm and of the seminorm.
    ///
    /// ```
    /// use signorini::{Tolerance, sobolev::{FractionalOrder, Partition, PiecewisePolynomial}};
    /// let (order, asked) = (FractionalOrder::HALF, Tolerance::reference());
    /// // x²/2 as end values and a bubble: x²/2 = x/2 − x(1−x)/2
    /// let mesh = Partition::uniform(1, 1.0)?;
    /// let u = PiecewisePolynomial::with_bubbles(mesh.clone(), &[[0.0, 0.5]], vec![vec![-0.5]])?;
    /// let slope = PiecewisePolynomial::discontinuous_linears(mesh, &[[0.0, 1.0]])?;
    /// assert!((slope.l2_norm(asked)?.value.powi(2) - 1.0 / 3.0).abs() < 1e-14);
    /// assert!((slope.norm(order, asked)?.value.powi(2) - 4.0 / 3.0).abs() < 1e-12);
    /// assert!((u.norm_with_derivative(&slope, order, asked)?.value.powi(2) - 83.0 / 60.0).abs() < 1e-12);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`PiecewisePolynomial::seminorm`].
    pub fn norm(&self, order: FractionalOrder, tolerance: Tolerance) -> Result<Estimate> {
        let parts = [self.seminorm_as_it_is(order, tolerance)?, self.l2_norm(tolerance)?];
        accept("norm", root_of_squares(&parts)?, tolerance, LIMIT)
    }

    /// The norm ||u||_{1+ν} of a function and its derivative, [`PiecewisePolynomial::derivative`].
    ///
    /// # Errors
    /// As [`PiecewisePolynomial::seminorm`] for the derivative; [`Error::InfiniteNorm`] when u jumps;
    /// [`Error::OutOfRange`] when the two live on intervals of different length.
    pub fn norm_with_derivative(
        &self,
        derivative: &Self,
        order: FractionalOrder,
        tolerance: Tolerance,
    ) -> Result<Estimate> {
        let total = derivative.partition().total();
        let same = self.partition().total() == total;
        Error::require("length of the derivative's interval", total, "that of the function", same)?;
        if !self.is_continuous() {
            return Err(Error::InfiniteNorm {
                order: 1.0 + order.value(),
                why: "a function that jumps has no derivative in L^2",
            });
        }
        let top = derivative.seminorm_as_it_is(order, tolerance)?;
        let parts = [top, self.l2_norm(tolerance)?, derivative.l2_norm(tolerance)?];
        accept("norm", root_of_squares(&parts)?, tolerance, LIMIT)
    }

    /// The L² norm, exact to rounding, which meets every tolerance.
    ///
    /// # Errors
    /// [`Error::NotFinite`] on overflow.
    pub fn l2_norm(&self, _tolerance: Tolerance) -> Result<Estimate> {
        let scale = self.scale();
        let rule = Rule::gauss_legendre(self.degree() + 1)?;
        let mut sum = RunningSum::default();
        // The length may overflow a product of its own; the root is taken of values in units of the interval.
        let total = self.partition().total();
        for (piece, &h) in self.pieces().iter().zip(self.partition().lengths()) {
            sum.add(h / total * rule.integrate(|t| (piece.value(t) / scale).powi(2)));
        }
        let value = scale * (total.sqrt() * sum.value().sqrt());
        Estimate::new(value, ENTRY_ROUNDING * value, Work::default())
    }

    /// A power of two near the largest value; 1 for the zero function.
    fn scale(&self) -> f64 {
        power_of_two(self.pieces().iter().map(|piece| piece.size()).fold(0.0, f64::max))
    }

    /// A power of two near the largest difference of two values: squares of differences of a few ulps must
    /// not underflow.
    fn spread(&self) -> f64 {
        let (mut low, mut high, mut bubbles) = (f64::INFINITY, f64::NEG_INFINITY, 0.0_f64);
        for piece in self.pieces() {
            low = low.min(piece.left).min(piece.right);
            high = high.max(piece.left).max(piece.right);
            bubbles = bubbles.max(piece.bubbles.iter().map(|c| c.abs()).fold(0.0, f64::max));
        }
        let spread = (0.5 * high - 0.5 * low).max(bubbles);
        if spread == 0.0 { self.scale() } else { power_of_two(spread) }
    }

    /// |u|_ν with whatever error it has; computed for u over a power of two, lengths in units of one, where
    /// |u|_ν ~ L^{1/2−ν}.
    fn seminorm_as_it_is(&self, order: FractionalOrder, tolerance: Tolerance) -> Result<Estimate> {
        self.require_finite_seminorm(order)?;
        let scale = self.spread();
        let (unit, partition) = self.partition().of_moderate_lengths()?;
        let moderate = self.scaled_by(1.0 / scale).on(partition);
        let root = moderate.seminorm_squared_of_moderate(order, tolerance)?.sqrt()?;
        // ν − 1/2 is rounded for small ν, and the logarithm of the unit may be 700.
        let length = if order.value() < 0.25 {
            unit.sqrt() * unit.powf(-order.value())
        } else {
            unit.powf(-order.offset())
        };
        // Exponents like 3 − 2ν are rounded, and they multiply logarithms of such lengths.
        let logarithm =
            self.partition().lengths().iter().fold(0.0, |most: f64, length| most.max(length.ln().abs()));
        let rounding = if unit == 1.0 { 0.0 } else { (4.0 + 0.15 * logarithm) * f64::EPSILON * root.value };
        scaled(scale, scaled(length, Estimate::new(root.value, root.error + rounding, root.work)?)?)
    }

    fn require_finite_seminorm(&self, order: FractionalOrder) -> Result<()> {
        if order.is_below_half() || self.is_continuous() {
            return Ok(());
        }
        Err(Error::InfiniteNorm { order: order.value(), why: "a jump is not in H^nu for nu >= 1/2" })
    }

    fn seminorm_squared_of_moderate(&self, order: FractionalOrder, tolerance: Tolerance) -> Result<Estimate> {
        if self.is_exactly(|piece| piece.left == piece.right) {
            self.constants_squared(order, tolerance)
        } else if self.is_exactly(|_| true) && self.is_continuous() {
            self.linears_squared(order, tolerance)
        } else {
            self.pairs_squared(order)
        }
    }

    fn is_exactly(&self, shape: impl Fn(&super::polynomial::Piece) -> bool) -> bool {
        self.pieces().iter().all(|piece| piece.bubbles.is_empty() && shape(piece))
    }

    fn constants_squared(&self, order: FractionalOrder, tolerance: Tolerance) -> Result<Estimate> {
        let (partition, pieces) = (self.partition(), self.pieces());
        if pieces.iter().all(|piece| piece.left == pieces[0].left) {
            return Estimate::new(0.0, 0.0, Work::default());
        }
        let n = pieces.len();
        if n > DIRECT {
            let values: Vec<f64> = pieces.iter().map(|piece| piece.left).collect();
            let fast = fast_form(&GramOperator::constants(partition, order, FAST_FORM)?, &values)?;
            if is_enough(&fast, n, tolerance) {
                return Ok(fast);
            }
        }
        let cells = CellPairs::new(order);
        let value: f64 = (0..n)
            .into_par_iter()
            .map(|i| {
                let (mut sum, mut gap) = (0.0, RunningSum::default());
                for j in i + 1..n {
                    let difference = pieces[i].left - pieces[j].left;
                    if difference != 0.0 {
                        sum += constants_on(partition, &cells, i, j, gap.value()) * difference * difference;
                    }
                    gap.add(partition.lengths()[j]);
                }
                2.0 * sum
            })
            .sum();
        Estimate::new(value, ENTRY_ROUNDING * value, pair_work(n))
    }

    fn linears_squared(&self, order: FractionalOrder, tolerance: Tolerance) -> Result<Estimate> {
        let partition = self.partition();
        let cells = CellPairs::new(order);
        let n = partition.len();
        let mut nodal: Vec<f64> = self.pieces().iter().map(|piece| piece.left).collect();
        nodal.push(self.pieces()[n - 1].right);
        if n > DIRECT {
            let fast = fast_form(&GramOperator::linears(partition, order, FAST_FORM)?, &nodal)?;
            if is_enough(&fast, n, tolerance) {
                return Ok(fast);
            }
        }
        let square = |i: usize, j: usize| (nodal[i] - nodal[j]) * (nodal[i] - nodal[j]);
        let (value, absolute) = (0..n)
            .into_par_iter()
            .map(|e| {
                let entry = neighbours_linear(partition, &cells, e) * square(e, e + 1);
                let (mut sum, mut absolute) = (-entry, entry.abs());
                for (k, [near, far]) in FarRow::new(partition, &cells, e).values.into_iter().enumerate() {
                    let term = -near * square(e + 1, e + 2 + k) - far * square(e, e + 2 + k);
                    sum += term;
                    absolute += term;
                }
                (sum, absolute)
            })
            .reduce(|| (0.0, 0.0), |a, b| (a.0 + b.0, a.1 + b.1));
        Estimate::new(value, ENTRY_ROUNDING * absolute, pair_work(n))
    }

    fn pairs_squared(&self, order: FractionalOrder) -> Result<Estimate> {
        let pairs = PolynomialPairs::new(order, self.degree().max(1))?;
        let lengths = self.partition().lengths();
        let n = lengths.len();
        let cell = |i: usize| Cell { length: lengths[i], piece: &self.pieces()[i] };
        let total = (0..n)
            .into_par_iter()
            .map(|i| {
                let mut sum = pairs.own(cell(i));
                if i + 1 < n {
                    sum = sum.plus(pairs.touching(cell(i), cell(i + 1), self.jump(i + 1)));
                }
                let mut gap = RunningSum::default();
                for j in i + 2..n {
                    gap.add(lengths[j - 1]);
                    sum = sum.plus(pairs.separate(cell(i), cell(j), gap.value()));
                }
                sum
            })
            .reduce(PairSum::default, PairSum::plus);
        let work = Work { points: total.points, ..pair_work(n) };
        Estimate::new(total.value, ENTRY_ROUNDING * total.value + total.rounding, work)
    }
}

/// xᵀ A x by the fast product.
fn fast_form(operator: &GramOperator, x: &[f64]) -> Result<Estimate> {
    let image = operator.apply(x)?;
    let mean = x.iter().map(|v| v / x.len() as f64).sum::<f64>();
    let (mut sum, mut absolute) = (RunningSum::default(), 0.0);
    for ((v, y), a) in x.iter().zip(&image).zip(operator.diagonal()) {
        let v = v - mean;
        sum.add(v * y);
        // |x|ᵀ |A| |x| ≤ 2 Σ a_ii x_i², since rows sum to zero
        absolute += 2.0 * a * v * v;
    }
    Estimate::new(sum.value(), FAST_ROUNDING * absolute, Work { points: x.len() as u64, ..Work::default() })
}

/// True when the square of the seminorm is known to twice the tolerance, or the pairs are too many to do
/// better.
fn is_enough(squared: &Estimate, n: usize, tolerance: Tolerance) -> bool {
    n > PATIENT || squared.relative_error() <= 2.0 * tolerance.relative()
}

impl PairSum {
    fn plus(self, other: Self) -> Self {
        Self {
            value: self.value + other.value,
            rounding: self.rounding + other.rounding,
            points: self.points + other.points,
        }
    }
}

fn pair_work(n: usize) -> Work {
    Work { pairs: (n * (n + 1) / 2) as u64, ..Work::default() }
}
