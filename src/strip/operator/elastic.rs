//! The elastic strip of height H with periodic sides, u = 0 on top, contact at the bottom; plane strain.
//!
//! ∫ 2μ ε(u):ε(v) + λ div u div v = ℓ(v). Per mode the edge keeps a Hermitian 2 × 2 matrix A (module `slab`)
//! for (u_x, u_y); contact is frictionless, so the tangential component is condensed: S_N = A_yy −
//! |A_xy|²/A_xx, acting on u_N = −u_y.
//!
//! Volume loads are eliminated row by row from the top, with P the edge matrix of the part above and y the load
//! accumulated so far: P ← T + P − (R+P)(C+P)⁻¹(R*+P),  y ← F_j + y − (R+P)(C+P)⁻¹ y,  c ← c − ½ y*(C+P)⁻¹ y. Cost:
//! O(n log m) for the symbol, O(n m log n) for a volume load.

use super::edge::EdgeOperator;
use super::load::load_rows;
use super::slab::{Matrix, Mode, Slab, edge_matrix};
use crate::error::Result;
use crate::fem::Lame;
use crate::numeric::check::require_finite;
use crate::numeric::parallel;
use crate::strip::sides::LateralCondition;
use fractional_sobolev_numeric::transforms::Complex;
use qd::Quad;
use std::f64::consts::PI;

/// The entries of a Hermitian 2 × 2 matrix over (u_x, u_y).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct EdgeMatrix {
    pub(crate) xx: f64,
    pub(crate) yy: f64,
    pub(crate) xy: Complex<f64>,
}

impl EdgeMatrix {
    pub(crate) fn of(matrix: &Matrix<f64>) -> Self {
        Self { xx: matrix.0[0].re, yy: matrix.0[3].re, xy: matrix.0[1] }
    }

    pub(crate) fn rounded(matrix: &Matrix<Quad>) -> Self {
        Self::of(&Matrix(matrix.0.map(|z| Complex::new(z.re.0, z.im.0))))
    }

    pub(crate) fn conjugate(self) -> Self {
        Self { xy: self.xy.conj(), ..self }
    }

    /// self·a + other·b
    pub(crate) fn combine(self, a: f64, other: Self, b: f64) -> Self {
        Self {
            xx: self.xx * a + other.xx * b,
            yy: self.yy * a + other.yy * b,
            xy: self.xy * a + other.xy * b,
        }
    }

    /// A_yy − |A_xy|²/A_xx.
    pub(crate) fn normal(self) -> f64 {
        self.yy - self.xy.norm_sqr() / self.xx
    }

    /// v*A v.
    pub(crate) fn form(self, x: Complex<f64>, y: Complex<f64>) -> f64 {
        self.xx * x.norm_sqr() + self.yy * y.norm_sqr() + 2.0 * (x.conj() * self.xy * y).re
    }
}

/// The load of u_N on the edge and the constant of the load ∫ f_h·v, f_h the nodal interpolant of f = (f_x, f_y), by
/// the consistent P1 mass matrix; `matrices` are the edge matrices of all modes.
pub(crate) fn condense(
    operator: &EdgeOperator,
    layers: usize,
    (lame, matrices): (Lame, &[EdgeMatrix]),
    f: impl Fn(f64, f64) -> [f64; 2],
) -> Result<(Vec<f64>, f64)> {
    let n = operator.cells();
    let mut columns: Vec<Column> = (0..=n / 2).map(|k| Column::new(k, n, lame)).collect();
    let mut constant = 0.0;
    for (j, row) in load_rows(n, layers, LateralCondition::Periodic, f) {
        require_finite("volume load", &row[0])?;
        require_finite("volume load", &row[1])?;
        let [x, y] = [operator.modes(&row[0])?, operator.modes(&row[1])?];
        for (k, column) in columns.iter_mut().enumerate() {
            column.load[0] += x[k];
            column.load[1] += y[k];
        }
        if j > 0 {
            columns.iter_mut().for_each(Column::eliminate);
            let columns = &columns;
            constant -= 0.5 * operator.mode_sum_of(|k| columns[k].released);
        }
    }
    let columns = &columns;
    constant -= 0.5 * operator.mode_sum_of(|k| columns[k].load[0].norm_sqr() / matrices[k].xx);
    let normal: Vec<Complex<f64>> = (0..=n / 2)
        .map(|k| {
            let a = matrices[k];
            -(columns[k].load[1] - a.xy.conj() * columns[k].load[0] / a.xx)
        })
        .collect();
    Ok((operator.with_modes(&normal)?, constant))
}

/// Below this angle (three modes in a hundred) edge matrices are computed in double-double: these modes require the
/// most doublings, and differences of their matrices are used.
pub(crate) const LOW: f64 = 0.1;

/// A at θ = 2πk/n, k = 0 ... n/2; `layers` a power of two.
pub(crate) fn edge_matrices(cells: usize, layers: usize, lame: Lame) -> Vec<EdgeMatrix> {
    parallel::map(cells / 2 + 1, &|k| {
        let theta = 2.0 * PI * k as f64 / cells as f64;
        if theta < LOW {
            return EdgeMatrix::rounded(&edge_matrix(Mode::long(k, cells), lame, layers.ilog2()));
        }
        EdgeMatrix::of(&edge_matrix(Mode::new(theta), lame, layers.ilog2()))
    })
}

/// One mode of the row by row elimination.
struct Column {
    slab: Slab<f64>,
    above: Matrix<f64>,
    load: [Complex<f64>; 2],
    released: f64,
}

impl Column {
    fn new(k: usize, cells: usize, lame: Lame) -> Self {
        let slab = Slab::layer(Mode::new(2.0 * PI * k as f64 / cells as f64), lame);
        Self { above: slab.clamped(), slab, load: [Complex::default(); 2], released: 0.0 }
    }

    fn eliminate(&mut self) {
        let Slab { t, r, c } = self.slab;
        let p = self.above;
        let inverse = c.add(p).inverse();
        let coupling = r.add(p);
        let carried = coupling.mul(inverse);
        let apply = |m: &Matrix<f64>, v: [Complex<f64>; 2]| {
            [m.0[0] * v[0] + m.0[1] * v[1], m.0[2] * v[0] + m.0[3] * v[1]]
        };
        let y = self.load;
        let z = apply(&inverse, y);
        self.released = (y[0].conj() * z[0] + y[1].conj() * z[1]).re;
        let pulled = apply(&carried, y);
        self.load = [y[0] - pulled[0], y[1] - pulled[1]];
        // Only the Hermitian part is kept: the rest is rounding, which the recursion would amplify.
        self.above = t.add(p).sub(carried.mul(coupling.adjoint())).hermitian();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn doubling_and_elimination_layer_by_layer_agree() {
        let lame = Lame::new(1.0, 1.0).unwrap();
        for (n, m) in [(8usize, 8usize), (16, 4), (32, 128)] {
            let matrices = edge_matrices(n, m, lame);
            for k in 0..=n / 2 {
                let mut column = Column::new(k, n, lame);
                (1..m).for_each(|_| column.eliminate());
                let other = EdgeMatrix::of(&column.above);
                // Layer by layer rounding adds up over m steps.
                let bound = 1e-15 * (10 * m) as f64;
                let scale = matrices[k].xx.max(matrices[k].yy);
                let defect = (matrices[k].xx - other.xx).abs() / scale;
                assert!(defect < bound, "{n} {m} {k}: {defect:e}");
                assert!((matrices[k].yy - other.yy).abs() < bound * scale);
                assert!((matrices[k].xy - other.xy).norm() < bound * scale);
            }
        }
    }
}
