//! The rates of (4.6) and (4.7) on two roads: of one function barely in H^r, and of the supremum over H^r.

use super::dual_norm::DualNorm;
use super::projection_sample::{projection_dual_error, sample_projection_error};
use super::rate::last_order;
use super::sample::SampleSlope;
use super::supremum::{SupremumRate, rate_of, supremum_rate, wave_constant};
use fractional_sobolev::Mesh;
use fractional_sobolev::Result;
use fractional_sobolev::{Domain, ErrorNorm, projection_constant};
use fractional_sobolev::{Estimate, Tolerance};
use signorini::rates::order_between;

/// Elements of the meshes for one function: the rate is that between the last two. In L² a mesh costs O(N).
pub(super) const MESHES: [usize; 3] = [1 << 8, 1 << 12, 1 << 16];

/// Elements of the coarsest of three meshes in the dual norm, where matrices are dense.
const DUAL_COARSEST: usize = 96;

/// Elements of the finest mesh for the supremum.
const SUPREMUM: usize = 64;
/// Accuracy asked of each: that of four cells per element.
const ACCURACY: f64 = 0.1;

/// Cells per element in dense matrices: with 2 the sawtooth of a smooth function is not seen.
const CELLS: usize = 4;

/// Rates and constants in one norm at one order.
///
/// Returned by [`ProjectionStudy::rates`].
///
/// ```
/// use experiments::interpolation::{ProjectionRates, ProjectionStudy};
/// // half an order more in the dual norm, for one function and for the worst on each mesh
/// for ProjectionRates { theory, function, supremum, .. } in ProjectionStudy::new()?.rates(0.5)? {
///     assert!((function.value - theory).abs() < 0.1 && (supremum.rate.value - theory).abs() < 0.1);
/// }
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ProjectionRates {
    /// The exponent of h in (4.6) or (4.7): r or r + 1/2.
    pub theory: f64,
    /// Best constant element by element: C(r) or C*(r).
    pub constant: Estimate,
    /// Rate of one function.
    pub function: Estimate,
    /// Rate of the supremum, to 64 elements.
    pub supremum: SupremumRate,
    /// What the supremum is at least, times the power of h, by a wave.
    pub wave: Estimate,
}

/// Rates in the dual norm of functions in closed form, from three meshes, each with twice the elements of the
/// one before.
///
/// ```
/// use experiments::interpolation::{DualRates, SampleSlope, sample_projection_rate};
/// // cos πx is smooth: the rates are 1 in L² and 3/2 in the dual norm of order 1/2
/// let phi = SampleSlope::Cosine(1);
/// assert!((sample_projection_rate(phi)?.value - 1.0).abs() < 1e-3);
/// assert!((DualRates::new(16)?.rate(phi)?.value - 1.5).abs() < 0.1);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct DualRates {
    elements: [usize; 3],
    norms: [DualNorm; 3],
}

impl DualRates {
    /// Factorizes the dual norms.
    ///
    /// # Errors
    /// [`Error::CountOutOfRange`](fractional_sobolev::Error::CountOutOfRange) without elements or for more than 256 of
    /// them.
    pub fn new(coarsest: usize) -> Result<Self> {
        let elements = [1, 2, 4].map(|factor: usize| coarsest.saturating_mul(factor));
        let norm = |n: usize| DualNorm::new(&Mesh::uniform(n.saturating_mul(CELLS), 1.0)?);
        Ok(Self { elements, norms: [norm(elements[0])?, norm(elements[1])?, norm(elements[2])?] })
    }

    /// The exponent of h between the two finer meshes.
    ///
    /// Its error: 3.5 times the change from the coarser pair, and twice what eight cells per element in
    /// place of four change of the coarser pair (halving the cells at least halves what they miss).
    ///
    /// # Errors
    /// As [`sample_projection_dual_error`](super::sample_projection_dual_error).
    pub fn rate(&self, phi: SampleSlope) -> Result<Estimate> {
        // How far the norms are off cancels in the rates, but for what the cells are seen to change.
        let error = |k: usize, cells: usize| {
            let norm = projection_dual_error(phi, &self.norms[k], cells)?;
            Estimate::new(norm.value, 0.0, norm.work)
        };
        let meshes = [0, 1, 2].map(|k| self.elements[k]);
        let [coarse, middle, fine] = [error(0, CELLS)?, error(1, CELLS)?, error(2, CELLS)?];
        let rate = last_order([(meshes[0], coarse), (meshes[1], middle), (meshes[2], fine)])?;
        let halved = |coarse: Estimate, fine: Estimate| order_between((1.0, coarse.value), (0.5, fine.value));
        let before = halved(coarse, middle);
        let more_cells = halved(error(1, 2 * CELLS)?, error(2, 2 * CELLS)?);
        Estimate::new(rate.value, rate.error + 2.0 * (more_cells - before).abs(), rate.work)
    }
}

/// Everything that is needed for the rates of any order.
///
/// # Method
///
/// The function is x^{r−1/2+0.005}, whose own rate is r + 0.005; for r = 1 it is cos(πx), since x^{0.505}
/// nears the rate 1 slowly. Beside the rates stand the constants that bound the supremum on every mesh, from
/// above and by a wave from below.
///
/// ```
/// use experiments::interpolation::ProjectionStudy;
/// let [l2, dual] = ProjectionStudy::new()?.rates(0.5)?;
/// assert!(l2.theory == 0.5 && dual.theory == 1.0);
/// assert!((l2.supremum.rate.value - 0.5).abs() < 0.01 && (dual.supremum.rate.value - 1.0).abs() < 0.05);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct ProjectionStudy {
    dual: DualRates,
}

impl ProjectionStudy {
    /// Factorizes the dual norms for one function.
    ///
    /// # Errors
    /// None for the meshes used here; those of [`DualRates::new`] are passed on.
    pub fn new() -> Result<Self> {
        Ok(Self { dual: DualRates::new(DUAL_COARSEST)? })
    }

    /// The rates in L² and in the dual norm for H^r, 0 ≤ r ≤ 1.
    ///
    /// # Errors
    /// [`Error::OutOfRange`](fractional_sobolev::Error::OutOfRange) for r outside [0, 1]; those of the constants.
    pub fn rates(&self, r: f64) -> Result<[ProjectionRates; 2]> {
        let in_norm = |norm: ErrorNorm, constant: Estimate, function: Estimate| -> Result<ProjectionRates> {
            let (supremum, wave) =
                (supremum_rate(norm, r, SUPREMUM, ACCURACY)?, wave_constant(norm, r, SUPREMUM)?);
            Ok(ProjectionRates { theory: rate_of(norm, r)?, constant, function, supremum, wave })
        };
        let on_element = |norm| {
            let found = projection_constant(Domain::Interval(1.0), norm, r, Tolerance::balanced())?;
            Ok::<_, fractional_sobolev::Error>(found.constant)
        };
        let (constant, dual_constant) = (on_element(ErrorNorm::L2)?, on_element(ErrorNorm::Dual)?);
        let phi = if r == 1.0 { SampleSlope::Cosine(1) } else { SampleSlope::barely_in(r)? };
        Ok([
            in_norm(ErrorNorm::L2, constant, sample_projection_rate(phi)?)?,
            in_norm(ErrorNorm::Dual, dual_constant, self.dual.rate(phi)?)?,
        ])
    }
}

/// The exponent of h in ‖φ − π^h φ‖₀ between 4096 and 65 536 elements.
///
/// # Errors
/// As [`sample_projection_error`].
pub fn sample_projection_rate(phi: SampleSlope) -> Result<Estimate> {
    let on = |n: usize| -> Result<_> { Ok((n, sample_projection_error(phi, &Mesh::uniform(n, 1.0)?)?)) };
    last_order([on(MESHES[0])?, on(MESHES[1])?, on(MESHES[2])?])
}
