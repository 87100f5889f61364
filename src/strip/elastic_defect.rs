//! How much more energy the coarse elastic strip stores than the fine one, mode by mode.
//!
//! As in the scalar module, interpolation from n to 2n cells aliases mode θ into θ/2 and θ/2 + π, so that
//!
//! D(θ) = A_h(θ) − 2 [c⁴ A_{h/2}(θ/2) + s⁴ conj A_{h/2}(π − θ/2)],  s = sin(θ/4), c = cos(θ/4),
//!
//! and over several halvings G_h(θ) = D(θ) + 2 [c⁴ G_{h/2}(θ/2) + s⁴ conj G_{h/2}(π − θ/2)]. D is O(θ³) and A is O(θ): the
//! difference loses ε/θ². There is no closed form to rewrite; for θ below [`LOW`] (about one mode in a hundred) the whole computation
//! is done in double-double, which keeps 1e-30/θ², more than 16 digits for n up to 2^26.

use super::elastic::EdgeMatrix;
use super::slab::{DEPTH_LONG, Matrix, Mode, edge_matrix};
use crate::fem::Lame;
use qd::Quad;
use rayon::prelude::*;
use std::f64::consts::PI;

/// Below this angle differences are taken in double-double; above it binary64 keeps ε/θ² < 1e-12.
const LOW: f64 = 0.025;

/// D at θ = 2πk/n, k = 0 ... n/2, between `layers` and 2 `layers` layers; `coarse` and `fine` are the edge matrices.
pub(crate) fn halvings(
    cells: usize,
    layers: usize,
    lame: Lame,
    coarse: &[EdgeMatrix],
    fine: &[EdgeMatrix],
) -> Vec<EdgeMatrix> {
    (0..=cells / 2)
        .into_par_iter()
        .map(|k| {
            let theta = 2.0 * PI * k as f64 / cells as f64;
            if k > 0 && theta < LOW {
                return low_mode(k, cells, layers, lame);
            }
            coarse[k].combine(1.0, aliased(k, cells, fine), -1.0)
        })
        .collect()
}

/// 2 [c⁴ F(θ/2) + s⁴ conj F(π − θ/2)] for F given on 2n cells.
pub(crate) fn aliased(k: usize, cells: usize, fine: &[EdgeMatrix]) -> EdgeMatrix {
    let (s, c) = (0.5 * PI * k as f64 / cells as f64).sin_cos();
    fine[k].combine(2.0 * c.powi(4), fine[cells - k].conjugate(), 2.0 * s.powi(4))
}

fn low_mode(k: usize, cells: usize, layers: usize, lame: Lame) -> EdgeMatrix {
    let quarter = Quad::PI * Quad::from(k as f64) / Quad::from((2 * cells) as f64);
    let (s, c) = sine_cosine(quarter);
    let two = Quad::from(2.0);
    let (half_sine, half_cosine) = (two * s * c, c * c - s * s);
    let decay = |m: Mode<Quad>| 2.0 * m.half_sine_squared.0.sqrt().asinh();
    let doublings = layers.ilog2();
    let matrix = |mode: Mode<Quad>, times| edge_matrix(mode, lame, times, decay(mode), DEPTH_LONG);
    let coarse = Mode { half_sine_squared: half_sine * half_sine, sine: two * half_sine * half_cosine };
    let same = Mode { half_sine_squared: s * s, sine: half_sine };
    let alias = Mode { half_sine_squared: c * c, sine: half_sine };
    let sum = matrix(same, doublings + 1)
        .scale(two * c * c * c * c)
        .add(matrix(alias, doublings + 1).conjugate().scale(two * s * s * s * s));
    rounded(&matrix(coarse, doublings).sub(sum))
}

fn rounded(matrix: &Matrix<Quad>) -> EdgeMatrix {
    EdgeMatrix::of(&Matrix(matrix.0.map(|z| realfft::num_complex::Complex::new(z.re.0, z.im.0))))
}

/// sin x and cos x in double-double for 0 ≤ x ≤ 0.01 (Taylor).
fn sine_cosine(x: Quad) -> (Quad, Quad) {
    let square = x * x;
    let one = Quad::from(1.0);
    let (mut sine, mut cosine) = (one, one);
    for k in (1..=8).rev() {
        let k = f64::from(k);
        sine = one - square * sine / Quad::from((2.0 * k) * (2.0 * k + 1.0));
        cosine = one - square * cosine / Quad::from((2.0 * k - 1.0) * (2.0 * k));
    }
    (x * sine, cosine)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::strip::elastic::edge_matrices;

    #[test]
    fn double_double_and_plain_differences_meet() {
        let lame = Lame::new(1.0, 1.0).unwrap();
        let (n, m) = (512, 512);
        let (coarse, fine) = (edge_matrices(n, m, lame), edge_matrices(2 * n, 2 * m, lame));
        for k in 1..3 {
            let theta = 2.0 * PI * k as f64 / n as f64;
            assert!(theta < LOW);
            let low = low_mode(k, n, m, lame);
            let plain = coarse[k].combine(1.0, aliased(k, n, &fine), -1.0);
            // The plain difference keeps about 10 ε A/D, D ≈ A θ²/8.
            let bound = 1e-13 / (theta * theta) * low.yy;
            for (a, b) in [(low.xx, plain.xx), (low.yy, plain.yy), (low.xy.im, plain.xy.im)] {
                assert!((a - b).abs() < bound, "{k}: {a:e} {b:e}");
            }
        }
        // One layer of the scale: D/θ³ tends to a constant, so neighbouring low modes of a deep strip agree.
        let ratio = |k: usize| low_mode(k, 1 << 18, 1 << 18, lame).yy / (k as f64).powi(3);
        assert!((ratio(400) / ratio(401) - 1.0).abs() < 1e-4);
    }
}
