//! Exponents as eigenvalues of a matrix pencil on the arc 0 < θ < ω, by Legendre collocation.
//!
//! u = r^λ (U, V), σ = r^{λ−1} (..., S = σ_θθ, T = σ_rθ), shear modulus μ = 1, n = ν_P/(1 − ν_P):
//!
//! U' = T + (1 − λ) V,  V' = −U − nλU + (1 − n) S/2,  S' = −(1 + λ) T,  T' = S − λ n S − λ² 2U/(1 − ν_P).
//!
//! The first and second equations are the constitutive law (1/(Λ + 2μ) = (1 − n)/2, Λ Lamé's first constant), the
//! others equilibrium; all coefficients are bounded as ν_P → 1/2. λ is quadratic in the last, so W = λU is an
//! additional unknown. Scalar: U' = T, T' = −λ² U. U, V, S, T are polynomials of degree N, the equations hold at the
//! N Gauss points, and two conditions at each end (one in the scalar case) complete the system: (A − λB) y = 0. The
//! unknowns are the Legendre coefficients of the derivatives: A is the sum of the identity and an integral operator,
//! and no digits are lost by differentiation. With a shift s the finite λ are s + 1/m, m the eigenvalues of
//! (A − sB)⁻¹B. The characteristic functions are not used: the computation is independent of the list of zeros.
//! Simple eigenvalues converge exponentially in N; nearly double ones have half the digits, their mean has all. Cost:
//! O((5N)³).

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::evd::{ComputeEigenvectors, evd_real, evd_scratch};
use faer::linalg::solvers::Solve;
use faer::{Mat, Par, c64, mat};
use fractional_sobolev::gauss_legendre;
use signorini::singular::{LARGEST, Medium, SideCondition, Wedge};

/// Candidate shifts; the one with the smallest matrix (A − sB)⁻¹B is far from all exponents.
const SHIFTS: [f64; 5] = [1.137, 1.289, 1.437, 1.593, 1.741];

/// The eigenvalues with 0 < Re λ < 3 and |Im λ| ≤ `height`, by collocation of the given degree; ω |λ| should not
/// exceed half of the degree. They are ordered by increasing real part, as (Re λ, Im λ), and repeated according to multiplicity,
/// with both members of each conjugate pair.
pub fn exponents_on_arc(wedge: &Wedge, degree: usize, height: f64) -> Vec<(f64, f64)> {
    let (a, b) = pencil(wedge, degree);
    let inverses = SHIFTS.map(|shift| {
        let inverse = (&a - faer::Scale(shift) * &b).partial_piv_lu().solve(&b);
        (inverse.norm_l2(), inverse, shift)
    });
    let (_, inverse, shift) = inverses.into_iter().min_by(|x, y| x.0.total_cmp(&y.0)).unwrap();
    let values = general_eigenvalues(&inverse);
    let mut found: Vec<(f64, f64)> = values
        .into_iter()
        .filter(|m| m.norm() > 1.0 / (2.0 * (height + LARGEST)))
        .map(|m| c64::new(shift, 0.0) + m.inv())
        .filter(|z| z.re > 0.0 && z.re < LARGEST && z.im.abs() <= height)
        .map(|z| (z.re, z.im))
        .collect();
    found.sort_by(|x, y| x.0.total_cmp(&y.0).then(x.1.total_cmp(&y.1)));
    found
}

/// A and B: the functions one after another, each by its value at 0 and the Legendre coefficients of its
/// derivative, then √w λU at the Gauss points; equations are multiplied by √w, w the weights, so that the map to
/// derivatives is an orthogonal matrix.
fn pencil(wedge: &Wedge, degree: usize) -> (Mat<f64>, Mat<f64>) {
    let rule = gauss_legendre(degree).unwrap();
    let omega = wedge.angle();
    let law = Law::of(wedge.medium());
    let (count, functions) = (degree + 1, law.quadratic.len());
    let size = functions * count + degree;
    let (mut a, mut b) = (Mat::<f64>::zeros(size, size), Mat::<f64>::zeros(size, size));
    for (j, (x, weight)) in rule.iter().enumerate() {
        let (mut values, mut slopes) = basis(count, x);
        values.iter_mut().chain(&mut slopes).for_each(|value| *value *= weight.sqrt());
        for row in 0..functions {
            let place = row * degree + j;
            for k in 0..count {
                a[(place, row * count + k)] += slopes[k];
                for function in 0..functions {
                    a[(place, function * count + k)] -=
                        omega * law.first[(row, function)] * values[k];
                    b[(place, function * count + k)] +=
                        omega * law.linear[(row, function)] * values[k];
                }
            }
            b[(place, functions * count + j)] += omega * law.quadratic[row];
        }
        let place = functions * degree + j;
        a[(place, functions * count + j)] = 1.0;
        (0..count).for_each(|k| b[(place, k)] = values[k]);
    }
    let mut place = (functions + 1) * degree;
    for (side, x) in [(wedge.sides().0, 0.0), (wedge.sides().1, 1.0)] {
        let (values, _) = basis(count, x);
        for &function in law.vanishing(side) {
            (0..count).for_each(|k| a[(place, function * count + k)] = values[k]);
            place += 1;
        }
    }
    (a, b)
}

/// y' = (first + λ linear) y + λ quadratic W.
struct Law {
    first: Mat<f64>,
    linear: Mat<f64>,
    quadratic: Vec<f64>,
}

impl Law {
    fn of(medium: Medium) -> Self {
        match medium {
            Medium::Scalar => Self {
                first: mat![[0.0, 1.0], [0.0, 0.0]],
                linear: Mat::zeros(2, 2),
                quadratic: vec![0.0, -1.0],
            },
            Medium::PlaneStrain(poisson) => {
                let n = poisson / (1.0 - poisson);
                Self {
                    first: mat![
                        [0.0, 1.0, 0.0, 1.0],
                        [-1.0, 0.0, 0.5 * (1.0 - n), 0.0],
                        [0.0, 0.0, 0.0, -1.0],
                        [0.0, 0.0, 1.0, 0.0],
                    ],
                    linear: mat![
                        [0.0, -1.0, 0.0, 0.0],
                        [-n, 0.0, 0.0, 0.0],
                        [0.0, 0.0, 0.0, -1.0],
                        [0.0, 0.0, -n, 0.0],
                    ],
                    quadratic: vec![0.0, 0.0, 0.0, -2.0 / (1.0 - poisson)],
                }
            }
        }
    }

    /// The functions that vanish on a side.
    fn vanishing(&self, side: SideCondition) -> &'static [usize] {
        match (self.quadratic.len(), side) {
            (2, SideCondition::Clamped | SideCondition::Closed) => &[0],
            (2, _) => &[1],
            (_, SideCondition::Clamped) => &[0, 1],
            (_, SideCondition::Closed) => &[1, 3],
            (_, SideCondition::Free | SideCondition::Open) => &[2, 3],
        }
    }
}

/// Values and derivatives at x of 1 and of the integrals from 0 to x of the orthonormal Legendre polynomials on (0,
/// 1).
fn basis(count: usize, x: f64) -> (Vec<f64>, Vec<f64>) {
    let mut legendre = vec![0.0; count + 1];
    let y = 2.0 * x - 1.0;
    (legendre[0], legendre[1]) = (1.0, y);
    for k in 1..count {
        let n = k as f64;
        legendre[k + 1] = ((2.0 * n + 1.0) * y * legendre[k] - n * legendre[k - 1]) / (n + 1.0);
    }
    let (mut values, mut slopes) = (vec![1.0; count], vec![0.0; count]);
    for k in 0..count - 1 {
        let (norm, odd) = (((2 * k + 1) as f64).sqrt(), (2 * k + 1) as f64);
        slopes[k + 1] = norm * legendre[k];
        // (2k+1) P_k = P'_{k+1} − P'_{k−1}, and d/dx = 2 d/d(2x−1)
        values[k + 1] =
            if k == 0 { x } else { norm * (legendre[k + 1] - legendre[k - 1]) / (2.0 * odd) };
    }
    (values, slopes)
}

/// All eigenvalues of a square matrix, in no particular order. Cost: O(n³).
fn general_eigenvalues(a: &Mat<f64>) -> Vec<c64> {
    let size = a.nrows();
    let (mut real, mut imaginary) = (Mat::<f64>::zeros(size, 1), Mat::<f64>::zeros(size, 1));
    let none = ComputeEigenvectors::No;
    let mut memory =
        MemBuffer::new(evd_scratch::<f64>(size, none, none, Par::Seq, Default::default()));
    let stack = MemStack::new(&mut memory);
    let re = real.as_mut().col_mut(0).as_diagonal_mut();
    let im = imaginary.as_mut().col_mut(0).as_diagonal_mut();
    evd_real(a.as_ref(), re, im, None, None, Par::Seq, stack, Default::default()).unwrap();
    (0..size).map(|i| c64::new(real[(i, 0)], imaginary[(i, 0)])).collect()
}
