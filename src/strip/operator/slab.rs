//! The elastic slab of one Fourier mode, and the merging of two equal slabs.
//!
//! Rows have two displacement components, u(x) = û e^{iθ i}. A slab of L layers is described by its bottom
//! displacement û and d = û_top − û_bottom:
//!
//! E = ½ { û*T û + 2 Re û*R d + d*C d }.
//!
//! One layer of squares cut from bottom left to top right, with C_xx = diag(λ+2μ, μ), C_yy = diag(μ, λ+2μ),
//! C_xy = [0 λ; μ 0], e = exp(iθ) − 1, |e|² = 4 sin²(θ/2):
//!
//! T = |e|² C_xx,  R = |e|² C_xx/2 − i sin θ C_xy,  C = C_yy + |e|² C_xx/2 + (ē C_xy + e C_xy')/2.
//!
//! Two equal slabs, the middle row eliminated with M = 2C + T − R − R*, W = R − C:
//!
//! T ← 2T − T M⁻¹ T,  R ← R − T M⁻¹ W,  C ← C − W* M⁻¹ W.
//!
//! Since T = O(θ²) and R = O(θ) are stored separately from C = O(1), low modes keep their relative accuracy: 1e-13
//! after 18 doublings for λ = μ, 1e-12 for λ = 100 μ, where doubling the plain 4 × 4 stiffness matrix loses ε n²
//! (4e-7). With the top clamped (d = −û) the edge matrix is T − R − R* + C. Doubling stops when the condition at the
//! top no longer affects the bottom. Cost: O(log L) per mode.
//!
//! Generic in the real field: binary64, or double-double where differences of these matrices are needed
//! (`elastic_defect`).

use crate::fem::Lame;
use crate::numeric::real::Real;
use fractional_sobolev_numeric::transforms::Complex;
use qd::Quad;

/// sin²(θ/2) and sin θ: the parameters of a layer.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Mode<T> {
    pub(crate) half_sine_squared: T,
    pub(crate) sine: T,
}

impl<T: Real> Mode<T> {
    pub(crate) fn new(theta: T) -> Self {
        let (half, _) = (theta * T::from(0.5)).circular();
        Self { half_sine_squared: half * half, sine: theta.circular().0 }
    }
}

impl Mode<Quad> {
    /// θ = 2πk/cells.
    pub(crate) fn long(k: usize, cells: usize) -> Self {
        Self::new(Quad::PI * Quad::from(2.0 * k as f64) / Quad::from(cells as f64))
    }
}

/// A 2 × 2 complex matrix by rows.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Matrix<T>(pub(crate) [Complex<T>; 4]);

impl<T: Real> Matrix<T> {
    fn real(entries: [T; 4]) -> Self {
        Self(entries.map(|v| Complex::new(v, T::zero())))
    }

    fn zip(self, other: Self, f: impl Fn(Complex<T>, Complex<T>) -> Complex<T>) -> Self {
        let (a, b) = (self.0, other.0);
        Self([f(a[0], b[0]), f(a[1], b[1]), f(a[2], b[2]), f(a[3], b[3])])
    }

    pub(crate) fn add(self, other: Self) -> Self {
        self.zip(other, |a, b| a + b)
    }

    pub(crate) fn sub(self, other: Self) -> Self {
        self.zip(other, |a, b| a - b)
    }

    pub(crate) fn scale(self, factor: T) -> Self {
        Self(self.0.map(|v| v * factor))
    }

    fn times(self, factor: Complex<T>) -> Self {
        Self(self.0.map(|v| v * factor))
    }

    pub(crate) fn mul(self, other: Self) -> Self {
        let (a, b) = (self.0, other.0);
        Self([
            a[0] * b[0] + a[1] * b[2],
            a[0] * b[1] + a[1] * b[3],
            a[2] * b[0] + a[3] * b[2],
            a[2] * b[1] + a[3] * b[3],
        ])
    }

    pub(crate) fn adjoint(self) -> Self {
        let a = self.0;
        Self([conj(a[0]), conj(a[2]), conj(a[1]), conj(a[3])])
    }

    pub(crate) fn conjugate(self) -> Self {
        Self(self.0.map(conj))
    }

    /// The largest entry.
    fn size(self) -> f64 {
        self.0
            .iter()
            .map(|z| z.re.approximate().abs().max(z.im.approximate().abs()))
            .fold(0.0, f64::max)
    }

    pub(crate) fn hermitian(self) -> Self {
        self.add(self.adjoint()).scale(T::from(0.5))
    }

    /// Inverse of a Hermitian positive definite matrix.
    pub(crate) fn inverse(self) -> Self {
        let [a, b, c, d] = self.0;
        let determinant = a.re * d.re - (b.re * c.re - b.im * c.im);
        let factor = T::one() / determinant;
        Self([d, -b, -c, a]).scale(factor)
    }
}

fn conj<T: Real>(z: Complex<T>) -> Complex<T> {
    Complex::new(z.re, -z.im)
}

/// T, R and C of a slab.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Slab<T> {
    pub(crate) t: Matrix<T>,
    pub(crate) r: Matrix<T>,
    pub(crate) c: Matrix<T>,
}

impl<T: Real> Slab<T> {
    /// The slab of one layer.
    pub(crate) fn layer(mode: Mode<T>, lame: Lame) -> Self {
        let (lambda, mu) = (T::from(lame.lambda()), T::from(lame.mu()));
        let (zero, half) = (T::zero(), T::from(0.5));
        let stiff = lambda + mu + mu;
        let xx = Matrix::real([stiff, zero, zero, mu]);
        let yy = Matrix::real([mu, zero, zero, stiff]);
        let xy = Matrix::real([zero, lambda, mu, zero]);
        let square = mode.half_sine_squared * T::from(4.0);
        let e = Complex::new(-(mode.half_sine_squared + mode.half_sine_squared), mode.sine);
        let mixed = xy.times(conj(e)).add(xy.adjoint().times(e)).scale(half);
        Self {
            t: xx.scale(square),
            r: xx.scale(square * half).add(xy.times(Complex::new(zero, -mode.sine))),
            c: yy.add(xx.scale(square * half)).add(mixed),
        }
    }

    /// The slab of two of these, one on top of the other.
    pub(crate) fn doubled(self) -> Self {
        let Self { t, r, c } = self;
        let two = T::from(2.0);
        let middle = c.scale(two).add(t).sub(r).sub(r.adjoint()).inverse();
        let w = r.sub(c);
        let carried = t.mul(middle);
        Self {
            t: t.scale(two).sub(carried.mul(t)),
            r: r.sub(carried.mul(w)),
            c: c.sub(w.adjoint().mul(middle).mul(w)),
        }
    }

    /// The edge matrix with the top clamped.
    pub(crate) fn clamped(self) -> Matrix<T> {
        self.t.sub(self.r).sub(self.r.adjoint()).add(self.c)
    }
}

/// The edge matrix of 2^doublings layers with the top clamped.
///
/// The effect of the clamped top at depth L decays like exp(−2κL), so that a doubling squares the remaining error:
/// once a doubling changes the matrix by less than the square root of the rounding error, the slab is effectively
/// infinite. (κ is not that of the continuous problem: for λ ≫ μ the discrete modes near θ = π decay far more
/// slowly.)
pub(crate) fn edge_matrix<T: Real>(mode: Mode<T>, lame: Lame, doublings: u32) -> Matrix<T> {
    let mut slab = Slab::layer(mode, lame);
    let mut matrix = slab.clamped();
    for _ in 0..doublings {
        slab = slab.doubled();
        let next = slab.clamped();
        let change = next.sub(matrix).size();
        matrix = next;
        if change <= T::SETTLED * matrix.size() {
            break;
        }
    }
    matrix
}
