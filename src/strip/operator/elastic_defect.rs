//! The excess energy of a coarse elastic strip over a fine one, mode by mode.
//!
//! As in the scalar module, interpolation from n to 2n cells aliases mode θ into θ/2 and θ/2 + π, so that
//!
//! D(θ) = A_h(θ) − 2 [c⁴ A_{h/2}(θ/2) + s⁴ conj A_{h/2}(π − θ/2)],  s = sin(θ/4), c = cos(θ/4),
//!
//! and over several halvings G_h(θ) = D(θ) + 2 [c⁴ G_{h/2}(θ/2) + s⁴ conj G_{h/2}(π − θ/2)]. D is O(θ³) and A is
//! O(θ): the difference has a relative error of ε/θ². It has no closed form free of cancellation; for θ below [`LOW`]
//! (three modes in a hundred) the whole computation is done in double-double, with an error of 1e-30/θ²: more than 16
//! digits for n up to 2^26.

use super::elastic::{EdgeMatrix, LOW};
use super::slab::{Mode, edge_matrix};
use crate::fem::Lame;
use crate::numeric::parallel;
use qd::Quad;
use std::f64::consts::PI;

/// D at θ = 2πk/n, k = 0 ... n/2, between `layers` and 2 `layers` layers; `coarse` and `fine` are the edge
/// matrices.
pub(crate) fn halvings(
    cells: usize,
    layers: usize,
    lame: Lame,
    coarse: &[EdgeMatrix],
    fine: &[EdgeMatrix],
) -> Vec<EdgeMatrix> {
    parallel::map(cells / 2 + 1, &|k| {
        let theta = 2.0 * PI * k as f64 / cells as f64;
        if k > 0 && theta < LOW {
            return low_mode(k, cells, layers, lame);
        }
        coarse[k].combine(1.0, aliased(k, cells, fine), -1.0)
    })
}

/// 2 [c⁴ F(θ/2) + s⁴ conj F(π − θ/2)] for F given on 2n cells.
pub(crate) fn aliased(k: usize, cells: usize, fine: &[EdgeMatrix]) -> EdgeMatrix {
    let (s, c) = (0.5 * PI * k as f64 / cells as f64).sin_cos();
    fine[k].combine(2.0 * c.powi(4), fine[cells - k].conjugate(), 2.0 * s.powi(4))
}

fn low_mode(k: usize, cells: usize, layers: usize, lame: Lame) -> EdgeMatrix {
    let doublings = layers.ilog2();
    let same = Mode::long(k, 2 * cells);
    let alias = Mode::long(cells - k, 2 * cells);
    // s² = sin²(θ/4) and c² = cos²(θ/4) = sin²((π − θ/2)/2).
    let two = Quad::from(2.0);
    let (s2, c2) = (same.half_sine_squared, alias.half_sine_squared);
    let sum = edge_matrix(same, lame, doublings + 1)
        .scale(two * c2 * c2)
        .add(edge_matrix(alias, lame, doublings + 1).conjugate().scale(two * s2 * s2));
    EdgeMatrix::rounded(&edge_matrix(Mode::long(k, cells), lame, doublings).sub(sum))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::strip::operator::elastic::edge_matrices;

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

    #[test]
    fn differences_keep_ten_digits_at_every_mode() {
        // ε/θ² with A known to about 10 ε; LOW bounds θ from below.
        const DIGITS: f64 = 1e-10;
        let lame = Lame::new(1.0, 1.0).unwrap();
        let (n, m) = (1 << 12, 1 << 12);
        let (coarse, fine) = (edge_matrices(n, m, lame), edge_matrices(2 * n, 2 * m, lame));
        let differences = halvings(n, m, lame, &coarse, &fine);
        let mut worst = 0.0f64;
        for k in (1..=n / 2).step_by(7) {
            let (long, got) = (low_mode(k, n, m, lame), differences[k]);
            let error = (long.xx - got.xx)
                .abs()
                .max((long.yy - got.yy).abs())
                .max((long.xy - got.xy).norm());
            worst = worst.max(error / long.xx.min(long.yy));
        }
        println!("differences: worst {worst:.1e}");
        assert!(worst < DIGITS, "{worst:e}");
    }

    #[test]
    fn normal_symbol_keeps_thirteen_digits_at_every_mode() {
        for material in [(1.0, 1.0), (100.0, 1.0), (-0.5, 1.0)] {
            normal_symbol(material);
        }
    }

    fn normal_symbol((lambda, mu): (f64, f64)) {
        /// Required at every mode.
        const DIGITS: f64 = 1e-13;
        let n = 1 << 18;
        let lame = Lame::new(lambda, mu).unwrap();
        let matrices = edge_matrices(n, n, lame);
        let modes: Vec<usize> = (0..=n / 2).collect();
        let ratios = parallel::over(&modes, |&k| {
            let mode = Mode::long(k, n);
            let long = edge_matrix(mode, lame, n.ilog2()).0;
            let normal =
                long[3].re - (long[1].re * long[1].re + long[1].im * long[1].im) / long[0].re;
            (matrices[k].normal() / normal.0 - 1.0).abs()
        });
        let worst = ratios.into_iter().fold(0.0, f64::max);
        println!("lambda {lambda}, mu {mu}: worst of {} modes {worst:.1e}", modes.len());
        assert!(worst < DIGITS, "{lambda} {mu}: {worst:e}");
    }
}
