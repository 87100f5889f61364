//! The bound without C on the scalar strip with natural transitions (τ = 5/2, u ∈ H²), from the data of its
//! edge.
//!
//! The edge carries a load beside the contact forces, so that σ_N is not ∂_n u: in step 4 of
//! [`signorini::proof::ExplicitBound`] the seminorms of every segment, which are known, take the place of the trace
//! inequality,
//!
//! |u − u_h|_a² ≤ A² h² |u|₂² + 2 c h² Σ_T |σ_N|_{1/2,T} |u_N'|_{1/2,T} + b²,
//!
//! b² = (θ/π) h Σ_T ‖σ_N − πσ_N‖²_T, θ = coth π, for the midpoint cone and 0 for the nodal one; A is that of
//! the right isosceles triangles the strip is cut into.
//!
//! *|u|₂ from the edge.* For u = Σ a_k cos(κx) sinh(κ(1−y))/sinh κ, κ = kπ, the norm is that of the edge:
//! |u|₂² = Σ κ³ coth(κ) a_k². For n gaps of half length l = 1/(4n) around (i + 1/2)/n with u_N = −δ^{3/2},
//! δ = (l² − s²)/(2l), only k = 2nm counts, ∫ δ^{3/2} cos κs ds = (2l)^{−3/2} 3π l² J₂(κl)/κ², and
//!
//! |u|₂² = (9π/16) Σ_m J₂(mπ/2)² coth(2πnm)/m.
//!
//! As z (J₂² + Y₂²) falls to 2/π, what is left after M ≥ 6 terms is below (9π/16) 4.1/(π² M). The solution of
//! reference has piecewise linear data and ends of gaps on its grid of size h_r: not in H², but nearer to u
//! than h_r^{3/2} in energy, 1e-4 of the error with 64 cells of reference in the finest segment; the rounding
//! of the ends changes |u|₂ by less than 1e-7. Cost: one contact iteration for each mesh, two seminorms for
//! each transition on it.

use super::bound_row::BoundRow;
use super::contact_cost::{CostRow, contact_cost};
use crate::convergence::{Levels, StripCase};
use fractional_sobolev::{Estimate, Function, Order, Tolerance, Work};
use signorini::cone::Cone;
use signorini::problems::StripData;
use signorini::proof::MeshShape;
use signorini::strip::{Reference, StripKind};
use signorini::{Error, Result, ToolkitError};
use std::f64::consts::{FRAC_PI_2, PI};

/// Terms of the series of |u|₂².
const TERMS: usize = 2000;

/// The bounds and the error on every mesh, for `gaps` equal gaps; `segment` has values of c of step 3 of
/// [`signorini::proof::ExplicitBound`], rounded up. Ends of gaps lie on nodes of the grid of reference.
///
/// # Errors
/// [`ToolkitError::CountOutOfRange`](signorini::ToolkitError::CountOutOfRange) where a segment of the coarsest mesh would be longer than half of a gap; those
/// of the scenes and of the contact iteration.
pub(super) fn strip_bounds(
    gaps: usize,
    cone: Cone,
    segment: &[f64],
    levels: Levels,
    report: impl FnMut(),
) -> Result<Vec<BoundRow>> {
    if gaps > levels.coarsest_cells() / 4 {
        let range = "[1, a quarter of the cells of the coarsest mesh]: one transition in a segment at most";
        return Err(Error::Toolkit(ToolkitError::CountOutOfRange { name: "gaps", value: gaps, range }));
    }
    let (kind, source, reference) = (StripKind::Scalar, StripData::Transitions { gaps }, Reference::Harmonic);
    let case = StripCase { kind, levels, source, tau: 2.5, cone, reference, positions: 1 };
    let whole = second_seminorm(gaps)?;
    let fine = levels.reference_cells() as f64;
    let ends: Vec<f64> =
        (0..2 * gaps).map(|i| ((i as f64 + 0.5) / (2 * gaps) as f64 * fine).round() / fine).collect();
    let shape = MeshShape::right_isosceles();
    let smooth = shape.interpolation * (whole.value + whole.error);
    let trace = 1.0 / (PI * shape.height).tanh() / PI;
    let row = |CostRow { n, error, interpolation, .. }: CostRow| {
        let h = 1.0 / n as f64;
        let projection = match cone {
            Cone::Nodal => 0.0,
            Cone::Midpoint => trace * oscillation(&ends, n) / h,
        };
        let product = products(&ends, n)?;
        let bound = |c: &f64| h * (smooth * smooth + 2.0 * c * product + projection).sqrt();
        let near = segment.iter().map(bound).collect();
        let [error, interpolation] = [error, interpolation].map(f64::sqrt);
        Ok(BoundRow { n, error, interpolation, share: None, near, whole: None })
    };
    contact_cost(&case, report)?.into_iter().map(row).collect()
}

/// |u|₂ on the strip of height 1.
fn second_seminorm(gaps: usize) -> Result<Estimate> {
    let term = |m: usize| {
        let m = m as f64;
        bessel_two(FRAC_PI_2 * m).powi(2) / (m * (2.0 * PI * gaps as f64 * m).tanh())
    };
    let rest = 4.1 / (PI * PI * TERMS as f64);
    let sum: f64 = (1..=TERMS).rev().map(term).sum();
    let work = Work { points: TERMS as u64, ..Work::default() };
    Ok(Estimate::new(9.0 * PI / 16.0 * (sum + 0.5 * rest), 9.0 * PI / 32.0 * rest, work)?.sqrt()?)
}

/// J₂(z) = (1/π) ∫_0^π cos(2t − z sin t) dt; the trapezoid rule with more than z + 40 cells is exact to
/// rounding.
fn bessel_two(z: f64) -> f64 {
    let cells = z.ceil() as usize + 40;
    let value = |i: usize| {
        let t = PI * i as f64 / cells as f64;
        (2.0 * t - z * t.sin()).cos()
    };
    (0.5 * (value(0) + value(cells)) + (1..cells).map(value).sum::<f64>()) / cells as f64
}

/// Σ_T |σ_N|_{1/2,T} |u_N'|_{1/2,T} on n segments: those with a transition inside.
fn products(ends: &[f64], n: usize) -> Result<f64> {
    let half = 0.5 / ends.len() as f64;
    let h = 1.0 / n as f64;
    let mut sum = 0.0;
    for (i, &end) in ends.iter().enumerate() {
        let place = (end * n as f64).fract();
        // The part of the segment that lies in contact: before a gap, or behind it.
        let contact = if i % 2 == 0 { place } else { 1.0 - place };
        if place > 0.0 {
            let unit = |value: &(dyn Fn(f64) -> f64 + Sync)| {
                let at = |x: f64| value(x - contact);
                Function::from_fn(&[0.0, contact, 1.0], at)?.seminorm(Order::HALF, Tolerance::fast())
            };
            let pressure = unit(&|t| if t < 0.0 { (-t * h).sqrt() } else { 0.0 })?;
            let slope = unit(&|t| {
                let t = (t * h).max(0.0);
                1.5 * (t * (1.0 - 0.5 * t / half)).sqrt() * (1.0 - t / half)
            })?;
            sum += (pressure.value + pressure.error) * (slope.value + slope.error);
        }
    }
    Ok(sum)
}

/// Σ_T ‖σ_N − πσ_N‖²_T on n segments, |σ_N| the square root of the distance to the nearest gap.
fn oscillation(ends: &[f64], n: usize) -> f64 {
    let h = 1.0 / n as f64;
    // Where the distance grows from 0, with a sign for the direction, and where it ends to do so.
    let mut pieces = vec![(ends[0], 0.0, -1.0), (ends[ends.len() - 1], 1.0, 1.0)];
    for pair in ends[1..ends.len() - 1].chunks_exact(2) {
        let middle = 0.5 * (pair[0] + pair[1]);
        pieces.extend([(pair[0], middle, 1.0), (pair[1], middle, -1.0)]);
    }
    let overlap = |j: usize, &(zero, other, sign): &(f64, f64, f64)| {
        let (a, b) = (zero.min(other).max(j as f64 * h), zero.max(other).min((j + 1) as f64 * h));
        let (p, q) = (((a - zero) * sign).min((b - zero) * sign), ((a - zero) * sign).max((b - zero) * sign));
        (a < b).then(|| ((q.powf(1.5) - p.powf(1.5)) / 1.5, 0.5 * (q * q - p * p)))
    };
    let segment = |j: usize| {
        let parts = pieces.iter().filter_map(|piece| overlap(j, piece));
        let (first, second) = parts.fold((0.0, 0.0), |sum, part| (sum.0 + part.0, sum.1 + part.1));
        (second - first * first / h).max(0.0)
    };
    (0..n).map(segment).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use signorini::strip::LateralCondition;

    #[test]
    fn the_seminorm_is_that_of_the_cosines_of_the_data() {
        let (gaps, cells) = (3, 1 << 12);
        let data = StripData::Transitions { gaps }.data(2.5, cells, LateralCondition::Natural).unwrap();
        let sum: f64 = (1..200)
            .map(|k| {
                let wave = PI * k as f64;
                let values = data.values().iter().enumerate();
                let a: f64 = values.map(|(i, v)| v * (wave * i as f64 / cells as f64).cos()).sum();
                (2.0 * a / cells as f64).powi(2) * wave.powi(3) / wave.tanh()
            })
            .sum();
        let known = second_seminorm(gaps).unwrap();
        // What is left beyond k = 200 is 0.41/(π² 33) of 9π/16.
        let whole = known.value * known.value;
        assert!(sum < whole && sum > whole - 9.0 * PI / 16.0 * 4.1 / (33.0 * PI * PI), "{sum} {known}");
        assert!((bessel_two(1.0) - 0.114_903_484_931_900_5).abs() < 1e-15);
        assert!((bessel_two(100.0) + 0.021_528_757_344_505_36).abs() < 1e-14);
    }

    #[test]
    fn oscillation_and_products_by_sums_over_points() {
        let ends = [0.13, 0.39, 0.6, 0.87];
        let (n, points) = (8, 20_000);
        let distance = |x: f64| {
            let inside = |a: f64, b: f64| x > a && x < b;
            let near = ends.iter().map(|e| (x - e).abs()).fold(f64::INFINITY, f64::min);
            if inside(ends[0], ends[1]) || inside(ends[2], ends[3]) { 0.0 } else { near.sqrt() }
        };
        let by_sum: f64 = (0..n)
            .map(|j| {
                let at = |i: usize| distance((j as f64 + (i as f64 + 0.5) / points as f64) / n as f64);
                let mean = (0..points).map(at).sum::<f64>() / points as f64;
                (0..points).map(|i| (at(i) - mean).powi(2)).sum::<f64>() / (points * n) as f64
            })
            .sum();
        assert!((oscillation(&ends, n) / by_sum - 1.0).abs() < 1e-4, "{by_sum}");
        // One transition in the middle of a segment, half ∫∫ over points off the diagonal.
        let half = 0.125;
        let (h, m) = (1.0 / 32.0, 1500);
        let (mut square, x) = ([0.0, 0.0], |i: usize| (i as f64 + 0.5) / m as f64 - 0.5);
        let value = |t: f64| {
            let s = (t * h).max(0.0);
            let slope = 1.5 * (s * (1.0 - 0.5 * s / half)).sqrt() * (1.0 - s / half);
            [(-t * h).max(0.0).sqrt(), slope]
        };
        for i in 0..m {
            for j in (0..m).filter(|&j| j != i) {
                let (a, b) = (value(x(i)), value(x(j)));
                for c in 0..2 {
                    square[c] += ((a[c] - b[c]) / (x(i) - x(j)) / m as f64).powi(2);
                }
            }
        }
        let by_sum = 2.0 * (square[0] * square[1]).sqrt();
        let place = 0.25 + 0.5 * h;
        let mirrored = [place, 1.0 - place, place, 1.0 - place];
        let found = products(&mirrored, 32).unwrap() / 2.0;
        assert!((found / by_sum - 1.0).abs() < 0.01, "{found} {by_sum}");
    }
}
