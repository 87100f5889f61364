//! The unit square, trace on the edge y = 0: lower bounds of the best constant from trial functions.

mod increments;
#[allow(dead_code, reason = "one function of the toolkit's file is used")]
#[path = "../../../../toolkit/src/numeric/legendre.rs"]
mod legendre;

use crate::ErrorExt;
use fractional_sobolev::{Error, Estimate, Given, Order, Result, Work, gauss_legendre};
use increments::{EdgeFamily, Family, Increments, Parity};
use nalgebra::{Cholesky, DMatrix};
use std::f64::consts::PI;

/// Ratio of the cells of the displacements, and points in a cell: value and judge.
const RATIO: f64 = 0.2;
const POINTS: [usize; 2] = [8, 7];
/// What the innermost cell may miss: ε^{2−2s} of pairs inside the square, ε^{2s−1} of those at its edge.
const INNERMOST: f64 = 1e-7;
/// Rounding of a quotient of two quadratic forms whose trial functions are nearly dependent.
const ROUNDING: f64 = 1e-10;
/// Degree of the polynomials beside y^{2s−1}.
const SINGULAR: usize = 2;

/// Largest quotients of trial functions on the square.
///
/// # Method
///
/// For s < 1 the trial functions are X(x) Y(y), X a Legendre polynomial, Y one of those or y^{2s−1} times it.
/// Functions X of one parity about x = 1/2 do not see the others, and for one parity the
/// displacements (a, b) and (a, −b) count the same:
///
/// |w|²_s = 4 ∫₀¹∫₀¹ (a²+b²)^{-1-s} G(a, b) da db,
/// G = ⟨ΔXΔX⟩⟨YY⟩ + ⟨ΔX X⁺⟩⟨Y ΔY⟩ + ⟨X⁺ΔX⟩⟨ΔY Y⟩ + ⟨X⁺X⁺⟩⟨ΔYΔY⟩,
///
/// by products of rules graded to a = 0 and b = 0. For s = 1 the trial functions are cos(kπx) with the
/// harmonic extension cosh(kπ(1−y)), whose energy is (kπ/2) tanh(kπ).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SquareTrace {
    /// Largest |w|²_{s−1/2, edge}/|w|²_s among functions odd about x = 1/2, and among even ones.
    pub quotients: [Estimate; 2],
}

impl SquareTrace {
    /// Trial functions with polynomials in x and in y up to the degree, and y^{2s−1} times those up to 2.
    ///
    /// ```
    /// use experiments::square_trace::SquareTrace;
    /// use fractional_sobolev::{Domain, trace_constant};
    /// let found = SquareTrace::new(0.9, 6)?.largest();
    /// assert!(found.value < trace_constant(Domain::Square, 0.9, 1e-8)?.constant.value.powi(2));
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless 0.55 ≤ s ≤ 0.95, [`Error::CountOutOfRange`] for degrees outside 2..=20;
    /// [`Error::NotPositiveDefinite`] where the trial functions are dependent to rounding.
    pub fn new(order: impl Given<Order>, degree: usize) -> Result<Self> {
        let order = order.given()?;
        Error::require("s", order.value(), "[0.55, 0.95]", (0.55..=0.95).contains(&order.value()))?;
        require_degree("degree", degree)?;
        let [values, judges] = POINTS.map(|points| quotients(order, degree, points));
        let (values, judges) = (values?, judges?);
        let found = |k: usize| {
            let work = Work { factorizations: 2, ..Work::default() };
            let error = (values[k] - judges[k]).abs() + (ROUNDING + INNERMOST) * values[k];
            Estimate::new(values[k], error, work)
        };
        Ok(Self { quotients: [found(0)?, found(1)?] })
    }

    /// s = 1 with ‖∇w‖²: the first modes cos(kπx), k = 1, ..., and their harmonic extensions.
    ///
    /// ```
    /// use experiments::square_trace::SquareTrace;
    /// let found = SquareTrace::at_one(20)?.largest();
    /// assert!(found.value <= std::f64::consts::TAU + found.error);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::CountOutOfRange`] for fewer than 2 or more than 200 modes.
    pub fn at_one(modes: usize) -> Result<Self> {
        if !(2..=200).contains(&modes) {
            return Err(Error::CountOutOfRange { name: "modes", value: modes, range: "[2, 200]" });
        }
        let mut found = Vec::new();
        for first in [1, 2] {
            let kept: Vec<f64> = (first..=modes).step_by(2).map(|k| k as f64).collect();
            let n = kept.len();
            let energy = |k: f64| 0.5 * k * PI * (k * PI).tanh();
            let energy = DMatrix::from_fn(n, n, |i, j| if i == j { energy(kept[i]) } else { 0.0 });
            let edge = cosine_edge(&kept)?;
            let value = largest_quotient(&energy, &edge)?;
            found.push(Estimate::new(value, ROUNDING * value, Work::default())?);
        }
        Ok(Self { quotients: [found[0], found[1]] })
    }

    /// The larger one: a lower bound of the square of the best constant.
    pub fn largest(&self) -> Estimate {
        let [odd, even] = self.quotients;
        if odd.value >= even.value { odd } else { even }
    }
}

fn require_degree(name: &'static str, value: usize) -> Result<()> {
    let good = (2..=20).contains(&value);
    if good { Ok(()) } else { Err(Error::CountOutOfRange { name, value, range: "[2, 20]" }) }
}

/// ∫∫ (c_j(x)−c_j(y)) (c_k(x)−c_k(y)) (x−y)^{-2}, c_k = cos(kπx), for modes of one parity.
fn cosine_edge(modes: &[f64]) -> Result<DMatrix<f64>> {
    let most = modes.last().copied().unwrap_or(1.0);
    let (cells, rule) = (2 * most as usize, gauss_legendre(10)?);
    let mut edge = DMatrix::<f64>::zeros(modes.len(), modes.len());
    // ∫ sin(jπz) sin(kπz) over (a/2, 1 − a/2), j ± k even
    let overlap =
        |m: f64, a: f64| if m == 0.0 { 1.0 - a } else { -(0.5 * m * PI * a).sin() * 2.0 / (m * PI) };
    for cell in 0..cells {
        for (t, w) in rule.iter() {
            let a = (cell as f64 + t) / cells as f64;
            let weight = 4.0 * w / cells as f64 / (a * a);
            for (i, j) in modes.iter().enumerate() {
                for (l, k) in modes.iter().enumerate() {
                    let sines = (0.5 * j * PI * a).sin() * (0.5 * k * PI * a).sin();
                    edge[(i, l)] += weight * sines * (overlap(j - k, a) - overlap(j + k, a));
                }
            }
        }
    }
    Ok(edge)
}

/// The largest quotients of edge and square for odd and for even functions.
fn quotients(order: Order, degree: usize, points: usize) -> Result<[f64; 2]> {
    let steps = graded(order, points)?;
    let family = EdgeFamily { power: 2.0 * order.offset(), smooth: degree, singular: SINGULAR };
    let of_y: Vec<Increments> =
        steps.iter().map(|&(b, _)| Increments::new(&family, b)).collect::<Result<_>>()?;
    let quotient = |first: usize| quotient(order, &Parity { first, degree }, &family, &steps, &of_y);
    Ok([quotient(1)?, quotient(0)?])
}

/// The larger quotient for one parity.
fn quotient(
    order: Order,
    x: &Parity,
    y: &EdgeFamily,
    steps: &[(f64, f64)],
    of_y: &[Increments],
) -> Result<f64> {
    let (s, n, m) = (order.value(), x.count(), y.count());
    let of_x: Vec<Increments> = steps.iter().map(|&(a, _)| Increments::new(x, a)).collect::<Result<_>>()?;
    let count = steps.len();
    let kernel = DMatrix::from_fn(count, count, |i, j| {
        let ((a, v), (b, w)) = (steps[i], steps[j]);
        4.0 * v * w * a.hypot(b).powf(-2.0 - 2.0 * s)
    });
    // Both factors as matrices: displacement by pair of functions.
    let term = |left: fn(&Increments) -> &Vec<f64>, right: fn(&Increments) -> &Vec<f64>| {
        let right = DMatrix::from_fn(count, m * m, |b, jl| right(&of_y[b])[jl]);
        let left = DMatrix::from_fn(n * n, count, |ik, a| left(&of_x[a])[ik]);
        left * (&kernel * right)
    };
    let squares = [term(|x| &x.both, |y| &y.plain), term(|x| &x.moved, |y| &y.both)];
    let mixed = term(|x| &x.mixed_moved, |y| &y.mixed);
    // The constant has no energy: it is left out.
    let dropped = usize::from(x.first == 0);
    let size = n * m - dropped;
    let place = |k: usize| ((k + dropped) / m, (k + dropped) % m);
    let energy = DMatrix::from_fn(size, size, |p, q| {
        let ((i, j), (k, l)) = (place(p), place(q));
        let (here, there) = ((i * n + k, j * m + l), (k * n + i, l * m + j));
        squares[0][here] + squares[1][here] + mixed[here] + mixed[there]
    });
    let row =
        |ik: usize| steps.iter().zip(&of_x).map(|(&(a, v), x)| 2.0 * v * a.powf(-2.0 * s) * x.both[ik]).sum();
    let rows: Vec<f64> = (0..n * n).map(row).collect();
    let at_edge = y.at_edge();
    let edge = DMatrix::from_fn(size, size, |p, q| {
        let ((i, j), (k, l)) = (place(p), place(q));
        rows[i * n + k] * at_edge[j] * at_edge[l]
    });
    largest_quotient(&energy, &edge)
}

/// The largest λ with B x = λ A x.
fn largest_quotient(a: &DMatrix<f64>, b: &DMatrix<f64>) -> Result<f64> {
    let size = a.nrows();
    let scale: Vec<f64> = (0..size).map(|i| a[(i, i)].sqrt()).collect();
    let scaled =
        |form: &DMatrix<f64>| DMatrix::from_fn(size, size, |i, j| form[(i, j)] / scale[i] / scale[j]);
    let broken = || Error::NotPositiveDefinite { what: "energy of the trial functions", pivot: size };
    let lower = Cholesky::new(scaled(a)).ok_or_else(broken)?.unpack();
    let half = lower.solve_lower_triangular(&scaled(b)).ok_or_else(broken)?;
    let reduced = lower.solve_lower_triangular(&half.transpose()).ok_or_else(broken)?;
    Ok(((&reduced + reduced.transpose()) * 0.5).symmetric_eigenvalues().max())
}

/// Points and weights on (0, 1), graded to 0.
fn graded(order: Order, points: usize) -> Result<Vec<(f64, f64)>> {
    let missed = 2.0 * order.offset().min(1.0 - order.value());
    let cells = (INNERMOST.ln() / RATIO.ln() / missed).ceil() as i32;
    let rule = gauss_legendre(points)?;
    let mut all = Vec::new();
    for k in 0..=cells {
        let (high, low) = (RATIO.powi(k), if k == cells { 0.0 } else { RATIO.powi(k + 1) });
        all.extend(rule.iter().map(|(t, w)| (low + (high - low) * t, (high - low) * w)));
    }
    Ok(all)
}

#[cfg(test)]
mod tests {
    use super::*;
    use fractional_sobolev::{Domain, Function, Triangles, trace_constant};

    #[test]
    fn linear_functions_have_the_closed_form() {
        // w = x: the edge has ∫∫ |x−y|^{2−2s} = 2/((3−2s)(4−2s)).
        let order = Order::new(0.75).unwrap();
        let steps = graded(order, 8).unwrap();
        let (x, y) = (Parity { first: 1, degree: 1 }, EdgeFamily { power: 0.5, smooth: 0, singular: 0 });
        let of = |(a, v): (f64, f64)| 2.0 * v * a.powf(-1.5) * Increments::new(&x, a).unwrap().both[0];
        let edge: f64 = steps.iter().map(|&step| of(step)).sum();
        assert!((edge / 4.0 - 2.0 / (1.5 * 2.5)).abs() < 1e-8, "{edge}");
        // On the square: the seminorm of a coordinate.
        let plain: f64 = steps
            .iter()
            .flat_map(|&(a, v)| steps.iter().map(move |&(b, w)| ((a, v), (b, w))))
            .map(|((a, v), (b, w))| {
                let (of_x, of_y) = (Increments::new(&x, a).unwrap(), Increments::new(&y, b).unwrap());
                4.0 * v * w * a.hypot(b).powf(-3.5) * of_x.both[0] * of_y.plain[0]
            })
            .sum();
        let square = Triangles::grid([1, 1], 1.0).unwrap();
        let coordinate = Function::on_triangles(&square, 1, &[0.0, 1.0, 0.0, 1.0]).unwrap();
        let exact = coordinate.seminorm(order, 1e-8).unwrap().value.powi(2);
        assert!((plain / 4.0 / exact - 1.0).abs() < 1e-6, "{plain} {exact}");
    }

    #[test]
    fn trial_functions_grow_and_stay_below_the_half_plane() {
        for s in [0.6, 0.95] {
            let order = Order::new(s).unwrap();
            let bound = trace_constant(Domain::HalfPlane, order, 1e-8).unwrap().constant.value.powi(2);
            let [few, more] = [3, 6].map(|degree| SquareTrace::new(order, degree).unwrap());
            for k in 0..2 {
                assert!(few.quotients[k].value < more.quotients[k].value && more.quotients[k].value < bound);
            }
        }
        let [few, more] = [8, 32].map(|modes| SquareTrace::at_one(modes).unwrap().largest().value);
        assert!(few < more && more < 2.0 * PI && more > 0.9 * 2.0 * PI, "{few} {more}");
    }

    #[test]
    fn degrees_and_orders_outside_are_errors() {
        assert!(SquareTrace::new(Order::HALF, 4).is_err());
        assert!(SquareTrace::new(Order::new(0.8).unwrap(), 1).is_err());
        assert!(SquareTrace::at_one(0).is_err());
    }
}
