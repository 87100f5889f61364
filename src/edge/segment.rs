//! The norms of a pair (u_N, σ_N) on one contact segment that occur in the proofs of Theorems 3.1 and 4.1.
//!
//! Traces are piecewise polynomial, so all integrals of products are exact (three Gauss points per cell); L^q norms
//! are evaluated in closed form; seminorms of order ν by a fast product with the Gram matrix of the cells of a
//! segment.

use super::pair::{ContactPair, Segment};
use super::seminorm::SeminormForm;
use crate::error::{Result, ToolkitError};
use crate::numeric::parallel;
use fractional_sobolev::{Estimate, Given, Order, gauss_legendre};

/// The norms of a pair (u_N, σ_N) on one segment.
///
/// On a segment T of length h_e with end points a₁ < a₂: I^h is the linear interpolant at the end points, π^h the
/// mean over T, ν the order of the seminorms (1.1). Because σ_N u_N = 0, `interpolation_term` = `nodal_term` (3.11)
/// and `projection_term` = `midpoint_term`, up to rounding.
///
/// ```
/// use signorini::edge::ContactPair;
/// let pair = ContactPair::smooth_transition(96, 0.4, 2.25)?;
/// for norms in pair.norms(3, 0.75, 2.0)? {
///     assert!((norms.interpolation_term - norms.nodal_term).abs() < 1e-14);
///     assert!((norms.projection_term - norms.midpoint_term).abs() < 1e-14);
/// }
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SegmentNorms {
    /// The length h_e.
    pub length: f64,
    /// The nodal consistency term ∫ σ_N (I^h u)_N ≥ 0.
    pub nodal_term: f64,
    /// ∫ σ_N ((I^h u)_N − u_N).
    pub interpolation_term: f64,
    /// −∫ (σ_N − π^h σ_N) u_N.
    pub projection_term: f64,
    /// The midpoint consistency term ∫ (σ_N − π^h σ_N)(π^h u_N − u_N).
    pub midpoint_term: f64,
    /// The contact force ‖σ_N‖_{L¹} = −∫ σ_N.
    pub force: f64,
    /// Norms of σ_N.
    pub stress: TraceNorms,
    /// Norms of u_N'.
    pub slope: TraceNorms,
    /// ‖u_N‖₀.
    pub displacement: f64,
    /// ‖(I^h u)_N‖₀.
    pub interpolant: f64,
    /// ‖(I^h u)_N − u_N‖₀.
    pub interpolation_error: f64,
    /// ‖u_N − π^h u_N‖₀ and ‖u_N − π^h u_N‖_{L^∞}.
    pub projection_error: [f64; 2],
    /// max |u_N| over the nodes of the grid; ‖u_N‖_{L^∞} for [`Traces::Constants`](super::Traces::Constants).
    pub depth: f64,
    /// u_N at both end points.
    pub vertices: [f64; 2],
    /// Distance from each end point to the nearest zero of u_N in the segment; `None` if there is no zero.
    pub zero_distance: Option<[f64; 2]>,
    /// |∫ u_N'| from each end point to the nearest zero of u_N; 0 if there is no zero.
    pub increments: [f64; 2],
    /// Length of the longer of the two subintervals adjacent to the end points on which σ_N = 0.
    pub free_length: f64,
}

/// Norms of a trace v on a segment of length h_e; π^h v is its mean, ν the order of the seminorm.
///
/// ‖v − π^h v‖₀ ≤ ‖v‖₀, and by (4.6) ‖v − π^h v‖₀ ≤ γ₁(ν) h_e^ν |v|_ν.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TraceNorms {
    /// ‖v‖₀.
    pub l2: f64,
    /// ‖v‖_{L^q}.
    pub lq: f64,
    /// ‖v − π^h v‖₀.
    pub deviation: f64,
    /// |v|²_ν.
    pub seminorm_squared: Estimate,
}

impl TraceNorms {
    fn new(segment: &Segment<'_>, ends: &[[f64; 2]], q: f64, form: &SeminormForm) -> Result<Self> {
        let cell = segment.cell;
        let mut sums = [0.0; 3];
        for &[a, b] in ends.iter().filter(|e| **e != [0.0; 2]) {
            sums[0] += (a * a + a * b + b * b) / 3.0;
            sums[1] += if q == 2.0 { (a * a + a * b + b * b) / 3.0 } else { linear_power(a, b, q) };
            sums[2] += 0.5 * (a + b);
        }
        let mean = sums[2] / ends.len() as f64;
        let deviation: f64 = ends
            .iter()
            .map(|&[a, b]| [a - mean, b - mean])
            .map(|[a, b]| (a * a + a * b + b * b) / 3.0)
            .sum();
        Ok(Self {
            l2: (cell * sums[0]).sqrt(),
            lq: (cell * sums[1]).powf(1.0 / q),
            deviation: (cell * deviation).sqrt(),
            seminorm_squared: form.squared(segment, ends)?,
        })
    }

    /// The seminorm |v|_ν.
    pub fn seminorm(&self) -> f64 {
        self.seminorm_squared.value.sqrt()
    }

    /// The squared norm ‖v‖²_ν = ‖v‖₀² + |v|²_ν.
    pub fn norm_squared(&self) -> f64 {
        self.l2 * self.l2 + self.seminorm_squared.value
    }

    /// The estimated relative error of |v|_ν; 0 if |v|_ν = 0.
    pub fn seminorm_error(&self) -> f64 {
        let squared = self.seminorm_squared;
        if squared.value > 0.0 { 0.5 * squared.error / squared.value } else { 0.0 }
    }
}

impl SegmentNorms {
    fn new(segment: &Segment<'_>, q: f64, form: &SeminormForm) -> Result<Self> {
        let stress = TraceNorms::new(segment, segment.pressures, q, form)?;
        let slope = TraceNorms::new(segment, segment.slopes, q, form)?;
        let integrals = Integrals::new(segment)?;
        let [left, right] = [segment.values[0], segment.values[segment.values.len() - 1]];
        let zeros = zero_distances(segment);
        Ok(Self {
            length: segment.length(),
            nodal_term: integrals.nodal,
            interpolation_term: integrals.interpolation,
            projection_term: integrals.projection,
            midpoint_term: integrals.midpoint,
            force: means(segment)[0] * segment.length(),
            stress,
            slope,
            displacement: integrals.displacement.sqrt(),
            interpolant: integrals.interpolant.sqrt(),
            interpolation_error: integrals.interpolation_error.sqrt(),
            projection_error: [integrals.projection_error.sqrt(), integrals.largest_deviation],
            depth: segment.values.iter().fold(0.0, |m: f64, u| m.max(u.abs())),
            vertices: [left, right],
            zero_distance: zeros.map(|cells| cells.map(|k| k as f64 * segment.cell)),
            increments: zeros.map_or([0.0; 2], |cells| increments(segment, cells)),
            free_length: free_cells(segment) as f64 * segment.cell,
        })
    }

    /// The squared norm ‖u_N‖²_{τ−1/2} = ‖u_N‖₀² + ‖u_N'‖₀² + |u_N'|²_ν.
    ///
    /// With ν = τ − 3/2 the seminorm of order τ − 1/2 of u_N is that of order ν of u_N'.
    pub fn displacement_norm_squared(&self) -> f64 {
        self.displacement.powi(2) + self.slope.norm_squared()
    }

    /// The diameter diam C_T of the contact set of the segment; `None` without contact.
    ///
    /// h_e minus the distances from both end points to the nearest zeros of u_N; 0 for a single contact point.
    ///
    /// ```
    /// use signorini::edge::ContactPair;
    /// let pair = ContactPair::smooth_transition(256, 0.5, 2.25)?;
    /// let diameters: Vec<_> = pair.norms(4, 0.75, 2.0)?.iter().map(|norms| norms.contact_diameter()).collect();
    /// assert_eq!((diameters[0], diameters[3]), (Some(0.25), None));
    /// # Ok::<(), signorini::Error>(())
    /// ```
    pub fn contact_diameter(&self) -> Option<f64> {
        self.zero_distance.map(|[left, right]| (self.length - left - right).max(0.0))
    }
}

impl ContactPair {
    /// The norms on each of n equal contact segments, in order; n = 1 is the whole edge. The seminorms have order ν,
    /// the L^q norms the given exponent q (1 ≤ q < ∞, not checked); the errors of the squared seminorms are
    /// estimates of rounding. Cost: O(N log(N/n)) for N cells.
    ///
    /// ```
    /// use signorini::edge::ContactPair;
    /// let pair = ContactPair::smooth_transition(256, 0.5, 2.25)?;
    /// let (whole, parts) = (pair.norms(1, 0.75, 2.0)?, pair.norms(4, 0.75, 2.0)?);
    /// // ∫ σ_N is additive; the squared seminorms on the segments sum to at most that on the edge.
    /// let force: f64 = parts.iter().map(|norms| norms.force).sum();
    /// let squares: f64 = parts.iter().map(|norms| norms.stress.seminorm().powi(2)).sum();
    /// assert!((force - whole[0].force).abs() < 1e-13 && squares <= whole[0].stress.seminorm().powi(2));
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) unless n divides N;
    /// [`ToolkitError::InfiniteNorm`](crate::ToolkitError::InfiniteNorm) for piecewise constants and ν ≥ 1/2.
    pub fn norms(
        &self,
        segments: usize,
        order: impl Given<Order>,
        q: f64,
    ) -> Result<Vec<SegmentNorms>> {
        let form =
            SeminormForm::new(self.traces(), order.given()?, self.cells() / segments.max(1))?;
        self.norms_by(&form, segments, q)
    }

    /// The norms of several pairs of the same kind on the same grid, as [`ContactPair::norms`], one pair after the
    /// other: the Gram matrix is assembled once, and only the norms of one pair are stored at a time.
    ///
    /// # Errors
    /// As for [`ContactPair::norms`]; [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange)
    /// for an empty list,
    /// [`ToolkitError::LengthMismatch`](crate::ToolkitError::LengthMismatch) for a pair on another grid or of
    /// another kind.
    pub fn norms_of(
        pairs: &[Self],
        segments: usize,
        order: impl Given<Order>,
        q: f64,
    ) -> Result<impl Iterator<Item = Result<Vec<SegmentNorms>>>> {
        let none = ToolkitError::CountOutOfRange { name: "pairs", value: 0, range: "[1, inf)" };
        let first = pairs.first().ok_or(none)?;
        let form =
            SeminormForm::new(first.traces(), order.given()?, first.cells() / segments.max(1))?;
        Ok(pairs.iter().map(move |pair| pair.norms_by(&form, segments, q)))
    }

    fn norms_by(&self, form: &SeminormForm, segments: usize, q: f64) -> Result<Vec<SegmentNorms>> {
        let parts: Vec<Segment<'_>> = self.segments(segments)?.collect();
        parallel::over(&parts, |segment| SegmentNorms::new(segment, q, form)).into_iter().collect()
    }
}

/// Integrals of products of σ_N, u_N, I^h u and means; exact.
#[derive(Default)]
struct Integrals {
    nodal: f64,
    interpolation: f64,
    projection: f64,
    midpoint: f64,
    displacement: f64,
    interpolant: f64,
    interpolation_error: f64,
    projection_error: f64,
    largest_deviation: f64,
}

impl Integrals {
    fn new(segment: &Segment<'_>) -> Result<Self> {
        let rule = gauss_legendre(3)?;
        let (cells, cell) = (segment.slopes.len(), segment.cell);
        let (left, right) = (segment.values[0], segment.values[cells]);
        let means = means(segment);
        let mut sums = Self::default();
        for i in 0..cells {
            let ([v, w], [p, r], u_left) =
                (segment.slopes[i], segment.pressures[i], segment.values[i]);
            let u_at = |t: f64| u_left + cell * t * (v + 0.5 * t * (w - v));
            for (t, weight) in rule.iter() {
                let (s, u) = (p + t * (r - p), u_at(t));
                let x = (i as f64 + t) / cells as f64;
                let line = left * (1.0 - x) + right * x;
                let weight = weight * cell;
                // σ_N = −s
                sums.nodal -= weight * s * line;
                sums.interpolation -= weight * s * (line - u);
                sums.projection += weight * (s - means[0]) * u;
                sums.midpoint -= weight * (s - means[0]) * (means[1] - u);
                sums.displacement += weight * u * u;
                sums.interpolant += weight * line * line;
                sums.interpolation_error += weight * (line - u) * (line - u);
                sums.projection_error += weight * (u - means[1]) * (u - means[1]);
            }
            let inside = if v * w < 0.0 { u_at(v / (v - w)) } else { u_left };
            let extremes = [u_left, inside, segment.values[i + 1]];
            let largest = extremes.iter().fold(0.0, |m: f64, u| m.max((u - means[1]).abs()));
            sums.largest_deviation = sums.largest_deviation.max(largest);
        }
        // On a segment without contact, or entirely in contact, this is −0 or rounding.
        sums.nodal = sums.nodal.max(0.0);
        Ok(sums)
    }
}

/// Means of −σ_N and of u_N.
fn means(segment: &Segment<'_>) -> [f64; 2] {
    let count = segment.slopes.len() as f64;
    let pressure: f64 = segment.pressures.iter().map(|p| 0.5 * (p[0] + p[1])).sum();
    let displacement: f64 = segment
        .slopes
        .iter()
        .zip(segment.values)
        .map(|(v, u)| u + segment.cell * (2.0 * v[0] + v[1]) / 6.0)
        .sum();
    [pressure / count, displacement / count]
}

/// Cells between each vertex and the nearest node with u_N = 0.
fn zero_distances(segment: &Segment<'_>) -> Option<[usize; 2]> {
    let left = segment.values.iter().position(|&u| u == 0.0)?;
    let right = segment.values.iter().rev().position(|&u| u == 0.0)?;
    Some([left, right])
}

/// |∫ u_N'| over that many cells at either vertex.
fn increments(segment: &Segment<'_>, [left, right]: [usize; 2]) -> [f64; 2] {
    let cells = segment.slopes.len();
    let integral = |slopes: &[[f64; 2]]| {
        (segment.cell * slopes.iter().map(|v| 0.5 * (v[0] + v[1])).sum::<f64>()).abs()
    };
    [integral(&segment.slopes[..left]), integral(&segment.slopes[cells - right..])]
}

/// Cells of the longer piece without pressure at a vertex.
fn free_cells(segment: &Segment<'_>) -> usize {
    let is_free = |p: &&[f64; 2]| **p == [0.0; 2];
    let left = segment.pressures.iter().take_while(is_free).count();
    let right = segment.pressures.iter().rev().take_while(is_free).count();
    left.max(right)
}

/// ∫₀¹ |a(1−t) + bt|^q dt for |a|, |b| ≤ 1.
///
/// Equals (b|b|^q − a|a|^q)/((q+1)(b − a)) for a ≠ b.
fn linear_power(a: f64, b: f64, q: f64) -> f64 {
    if a * b <= 0.0 {
        let (a, b) = (a.abs(), b.abs());
        if a + b == 0.0 {
            return 0.0;
        }
        return (a.powf(q) * a + b.powf(q) * b) / ((q + 1.0) * (a + b));
    }
    let (small, large) = (a.abs().min(b.abs()), a.abs().max(b.abs()));
    // large^q (1 − r^{q+1}) / ((q+1)(1−r)) with r = small/large, by expm1 and log1p in 1 − r
    let gap = (large - small) / large;
    if gap == 0.0 {
        return large.powf(q);
    }
    large.powf(q) * -((q + 1.0) * (-gap).ln_1p()).exp_m1() / ((q + 1.0) * gap)
}
