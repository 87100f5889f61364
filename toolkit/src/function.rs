//! Functions on intervals, polygons and triangulations, and their norms of order −1 < s < 2.

use super::boundary::{BoundaryFunction, Curve, CurveFormula};
use super::dual::DualOf;
use super::functions::{Position, SingularFunction};
use super::mesh::Mesh;
use super::nearly_one::NearlyOne;
use super::order::{Order, SobolevOrder};
use super::piecewise::PiecewisePolynomial;
use super::plane::{PlaneFunction, PlanePosition, SingularPlaneFunction, Triangles};
use crate::error::{Error, Given, Result};
use crate::estimate::{Estimate, Tolerance};
use crate::resolved::Resolved;
use crate::root::{self, root_of_squares};
use std::sync::OnceLock;

mod verbs;

/// Message: both parts of a norm meet the tolerance, but not their sum.
const OF_PARTS: &str =
    "the errors of the function and of its derivative add up to more than the tolerance";

/// A real function on an interval, a polygonal curve or a triangulation, given by a formula or by values.
///
/// | given by | constructor |
/// | --- | --- |
/// | a formula with breakpoints | [`from_fn`](Self::from_fn), [`from_positions`](Self::from_positions), [`power`](Self::power) |
/// | values on a mesh of an interval | [`linears`](Self::linears), [`piecewise`](Self::piecewise), [`interpolate`](Self::interpolate) |
/// | values on a triangulation | [`on_triangles`](Self::on_triangles) |
/// | a formula on a triangulation, with singular corners | [`from_plane_positions`](Self::from_plane_positions) |
/// | values on a polygonal curve | [`on_curve`](Self::on_curve) |
/// | a formula on the boundary of a polygon | [`on_polygon`](Self::on_polygon) |
///
/// # Method
///
/// The seminorm is |u|²_s = ∫∫ (u(x)−u(y))² / |x−y|^{d+2s} dx dy, d the dimension of the domain, 0 < s < 1;
/// ‖u‖²_s = ‖u‖² + |u|²_s, ‖u‖²\_{1+s} = ‖u‖² + ‖∇u‖²_s, and ‖u‖\_{−s} = sup ∫ u v / ‖v‖_s. Each is computed to the
/// relative tolerance by the method for its kind of function; for a combination without a method
/// [`Error::Incompatible`] names what is possible.
///
/// | kind | orders s | method | cost |
/// | --- | --- | --- | --- |
/// | formula | (−1, 2) | polynomials on cells if few are enough and meet the tolerance; else rules in the logarithm of the distance to the breakpoints; where these fail polynomials on as many cells as needed | 10³ to some 10⁴ values for all norms; by rules 10⁵ of the kernel per pair of one-sided neighbourhoods at 1e-8 |
/// | values on a mesh | (−1, 2) | pairs of elements, exact to rounding; moments of clusters | O(N log² 1/τ), 10⁵ elements in a second |
/// | formula minus values | (−1, 2) | polynomials on common cells if few resolve the formula and it has structure between its breakpoints; else polynomials away from the breakpoints, graded rules next to them | O(N log² 1/τ) |
/// | values on a triangulation | \[0, 2) | Duffy coordinates for touching triangles, clusters for distant ones | O(N log N) |
/// | formula on a triangulation | \[0, 1), below 2 with its gradient | the same, without clusters | O(N²) pairs |
/// | formula on a polygon's boundary | (−1, 2) | pairs of elements graded towards the vertices, Gauss rules; above 1 the derivative of polynomials along the sides; below 0 piecewise linear functions | 10⁷ to 10⁸ values of the kernel, a second |
/// | other sums and products, derivatives of formulas | (−1, 2) | polynomials on common cells | as values on a mesh |
/// | values on a curve | (−1, 2) | pairs of elements, corners of any angle; at most 20 000 elements, 1500 for dual norms | O(N²) |
///
/// The error of an estimate is that of the method: of rules the difference between two levels of accuracy, of polynomials
/// their distance from the function, as far as it is seen at points between theirs; plus rounding. Infinite norms are
/// detected at breakpoints, jumps and declared corners. L^q norms and the mean cost O(N). Dual norms of
/// functions on an interval take seconds for 10⁵ elements and s ≤ −0.3, and a fraction of a second for the
/// interpolation spaces of [`DualOf`].
///
/// ```
/// use fractional_sobolev::{Function, Mesh};
/// let kink = Function::from_fn(&[0.0, 0.5, 1.0], |x| (x - 0.5).abs())?;
/// let mesh = Mesh::uniform(2, 1.0)?;
/// let same = Function::linears(&mesh, &[0.5, 0.0, 0.5])?;
/// for s in [-0.5, 0.0, 0.5] {
///     assert!((kink.norm(s, 1e-7)?.value - same.norm(s, 1e-7)?.value).abs() < 1e-6);
/// }
/// assert!((same.norm(1.0, 1e-8)?.value.powi(2) - 13.0 / 12.0).abs() < 1e-12); // ‖u‖² + ‖u′‖²
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
#[doc(alias(
    "Gagliardo",
    "Slobodeckij",
    "Gagliardo seminorm",
    "fractional Sobolev",
    "H1/2",
    "H-1/2",
    "H^s"
))]
#[derive(Debug)]
pub struct Function<'a> {
    kind: Kind<'a>,
    /// the partial derivatives, if they were given
    gradient: Vec<Function<'a>>,
    /// the polynomials of a function on an interval, or why there are none, once they were needed
    resolved: OnceLock<Result<Resolved>>,
    /// whether few of them resolve it, so that its norms read them first; empty until one is asked for
    is_short: OnceLock<bool>,
}

#[derive(Debug)]
enum Kind<'a> {
    /// A formula with breakpoints on an interval, of which no value is taken until a verb needs one; `Function::of_formula`
    /// decides how a norm of it is computed.
    Formula(SingularFunction<'a>),
    /// x^a for small |a|: its seminorms are computed by another integral.
    NearlyOne(NearlyOne, SingularFunction<'a>),
    /// Values on a mesh of an interval, exact.
    Piecewise(PiecewisePolynomial),
    /// A formula minus a piecewise polynomial.
    Difference(Box<SingularFunction<'a>>, Box<PiecewisePolynomial>),
    /// Polynomials with their errors, of other sums and products and of derivatives of formulas.
    Resolved(Resolved),
    /// Values on a triangulation.
    Plane(PlaneFunction),
    /// A formula on a triangulation.
    PlaneFormula(SingularPlaneFunction<'a>),
    /// Values on a polygonal curve.
    Curve(BoundaryFunction),
    /// A formula on the boundary of a polygon.
    CurveFormula(CurveFormula<'a>),
}

impl<'a> Function<'a> {
    fn of(kind: Kind<'a>) -> Self {
        Self { kind, gradient: Vec::new(), resolved: OnceLock::new(), is_short: OnceLock::new() }
    }

    /// The function f(x) on (breaks\[0\], breaks\[last\]), smooth between the breakpoints.
    ///
    /// If the function is singular at a breakpoint x₀ other than 0, the distance x − x₀ is rounded: use
    /// [`Function::from_positions`], where it is stated how narrow a feature between the breakpoints may be.
    ///
    /// # Errors
    /// [`Error::CountOutOfRange`] for fewer than two breakpoints; [`Error::NotFinite`];
    /// [`Error::EntryOutOfRange`] unless the breakpoints increase by at least 1e-290 and by at least 1e-290
    /// times the length of the interval.
    pub fn from_fn(breaks: &[f64], f: impl Fn(f64) -> f64 + Send + Sync + 'a) -> Result<Self> {
        SingularFunction::new(breaks, f).map(Kind::Formula).map(Self::of)
    }

    /// The function f of a [`Position`], whose distance to the breakpoints is exact down to 1e-290;
    /// otherwise as [`Function::from_fn`].
    ///
    /// ```
    /// use fractional_sobolev::Function;
    /// let u = Function::from_positions(&[0.0, 0.3, 1.0], |at| at.log_distance_to(1))?;
    /// assert!(u.seminorm(0.4, 1e-6)?.relative_error() <= 1e-6);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// Layers at a breakpoint are resolved for any width down to 1e-290. Between two breakpoints every norm
    /// samples f at the same 512 points of equal distance: a bell, a step or a kink that stands out over 1/500 of the
    /// interval between the breakpoints, such as a bell whose standard deviation is 1/1000 of it, is always
    /// seen, at additional cost. A narrower one may lie between the samples and is then missed in both the value
    /// and the error. Declare its position as a breakpoint and express f by the distance to it:
    ///
    /// ```
    /// use fractional_sobolev::Function;
    /// // e^{−|x − 3/10|/w}, w = 1e-12: ‖u‖² = w
    /// let u = Function::from_positions(&[0.0, 0.3, 1.0], |at| (-at.distance_to(1) / 1e-12).exp())?;
    /// assert!((u.lp(2.0, 1e-8)?.value / 1e-6 - 1.0).abs() < 1e-8);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`Function::from_fn`].
    pub fn from_positions(
        breaks: &[f64],
        f: impl Fn(Position) -> f64 + Send + Sync + 'a,
    ) -> Result<Self> {
        SingularFunction::from_positions(breaks, f).map(Kind::Formula).map(Self::of)
    }

    /// The function f of a [`Position`] that is evaluated, by [`Position::log_distance`], even where the
    /// distance underflows: for |ln x|^α at order 1/2, where distances below 1e-300 contribute.
    ///
    /// ```
    /// use fractional_sobolev::{Function, closed_forms};
    /// let u = Function::from_log_distances(&[0.0, 1.0], |at| match at.anchor() {
    ///     0 => (-at.log_distance()).powf(0.45),
    ///     _ => (-at.offset().ln_1p()).powf(0.45),
    /// })?;
    /// let exact = closed_forms::log_power_seminorm_squared(0.45)?.value.sqrt();
    /// assert!((u.seminorm(0.5, 1e-4)?.value / exact - 1.0).abs() < 1e-4);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`Function::from_fn`].
    pub fn from_log_distances(
        breaks: &[f64],
        f: impl Fn(Position) -> f64 + Send + Sync + 'a,
    ) -> Result<Self> {
        SingularFunction::from_log_distances(breaks, f).map(Kind::Formula).map(Self::of)
    }

    /// The power x^a on (0, 1); |x^a|_s keeps full relative accuracy for a near 0, where x^a is nearly
    /// constant.
    ///
    /// ```
    /// use fractional_sobolev::{Function, closed_forms};
    /// for a in [0.3, 1e-12] {
    ///     let exact = closed_forms::power_seminorm_squared(a, 0.25)?.value.sqrt();
    ///     assert!((Function::power(a)?.seminorm(0.25, 1e-8)?.value / exact - 1.0).abs() < 1e-7);
    /// }
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless a is finite and at most 1000.
    pub fn power(a: f64) -> Result<Self> {
        Error::require("exponent", a, "(-inf, 1000]", a > f64::NEG_INFINITY && a <= 1e3)?;
        let u = SingularFunction::from_positions(&[0.0, 1.0], move |at| match at.anchor() {
            0 => at.offset().powf(a),
            _ => (a * at.offset().ln_1p()).exp(),
        })?;
        Ok(Self::of(match NearlyOne::new(a) {
            Some(power) => Kind::NearlyOne(power, u),
            None => Kind::Formula(u),
        }))
    }

    /// The continuous piecewise linear function with one value per node.
    ///
    /// # Errors
    /// [`Error::LengthMismatch`], [`Error::NotFinite`].
    pub fn linears(mesh: &Mesh, values: &[f64]) -> Result<Self> {
        PiecewisePolynomial::linears(mesh.clone(), values).map(Self::from)
    }

    /// The piecewise polynomial of degree p with p + 1 values on every element, at equidistant points from its
    /// left to its right end; one value per element if p = 0. It may jump between elements.
    ///
    /// ```
    /// use fractional_sobolev::{Function, Mesh};
    /// // x² on (0, 2), two elements
    /// let values = [0.0, 0.25, 1.0, 1.0, 2.25, 4.0];
    /// let square = Function::piecewise(&Mesh::uniform(2, 2.0)?, 2, &values)?;
    /// assert!((square.lp(2.0, 1e-12)?.value.powi(2) - 6.4).abs() < 1e-12);
    /// assert!((square.mean(1e-12)?.value - 4.0 / 3.0).abs() < 1e-12);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::LengthMismatch`], [`Error::NotFinite`], [`Error::CountOutOfRange`] for degrees above 20.
    pub fn piecewise(mesh: &Mesh, degree: usize, values: &[f64]) -> Result<Self> {
        PiecewisePolynomial::of_values(mesh.clone(), degree, values).map(Self::from)
    }

    /// The continuous piecewise polynomial of degree p that agrees with f at the nodes. On every element,
    /// with t ∈ (0, 1) from left to right, the difference between f and its linear interpolant, divided by
    /// t(1−t), is projected in L² onto the polynomials of degree p − 2 (by a Gauss rule of p points), so that
    /// polynomials of degree p are reproduced. f is called with the distance from the left end of the mesh.
    ///
    /// Norms of the result are norms of the interpolant: their error does not include its distance from f. For the norm
    /// of f itself use [`Function::from_fn`].
    ///
    /// ```
    /// use fractional_sobolev::{Function, Mesh};
    /// let square = Function::interpolate(&Mesh::uniform(2, 1.0)?, 2, |x| x * x)?;
    /// assert!((square.value_on(1, 0.5)? - 0.75f64.powi(2)).abs() < 1e-15);
    /// assert!((square.lp(3.0, 1e-8)?.value - (1.0f64 / 7.0).cbrt()).abs() < 1e-8);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::NotFinite`] if a value of f is not finite, [`Error::CountOutOfRange`] for degree 0 and for
    /// degrees above 20.
    pub fn interpolate(mesh: &Mesh, degree: usize, f: impl Fn(f64) -> f64) -> Result<Self> {
        PiecewisePolynomial::interpolate(mesh.clone(), degree, f).map(Self::from)
    }

    /// The function on a triangulation with the given values: continuous and linear with one value per node (degree
    /// 1), or constant on every triangle (degree 0).
    ///
    /// ```
    /// use fractional_sobolev::{Function, Triangles};
    /// let x = Function::on_triangles(&Triangles::grid([1, 1], 1.0)?, 1, &[0.0, 1.0, 0.0, 1.0])?;
    /// assert!((x.norm(0.0, 1e-8)?.value - 1.0 / 3f64.sqrt()).abs() < 1e-12);
    /// assert!((x.norm(1.3, 1e-8)?.value.powi(2) - 4.0 / 3.0).abs() < 1e-8); // its gradient is constant
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::LengthMismatch`], [`Error::NotFinite`], [`Error::CountOutOfRange`] for degrees above 1.
    pub fn on_triangles(mesh: &Triangles, degree: usize, values: &[f64]) -> Result<Self> {
        let (mesh, values) = (mesh.clone(), values.to_vec());
        let u = match low_degree(degree)? {
            true => PlaneFunction::linears(mesh, values)?,
            false => PlaneFunction::constants(mesh, values)?,
        };
        Ok(Self::of(Kind::Plane(u)))
    }

    /// The function f of a [`PlanePosition`] on a triangulation, smooth on every triangle except at the
    /// given corners (node, a), where it behaves like r^a.
    /// A feature narrower than a fifth of a triangle may lie between the points of the rules, and is then missed in both
    /// the value and the error: it needs smaller triangles there.
    ///
    /// ```
    /// use fractional_sobolev::{Function, Triangles};
    /// // r^{-1/4} cos φ on a triangle, in H^s for s < 3/4
    /// let triangle = Triangles::new(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]], &[[0, 1, 2]])?;
    /// let w = Function::from_plane_positions(&triangle, &[(0, -0.25)], |at| {
    ///     at.radius(0).powf(-0.25) * at.angle(0).cos()
    /// })?;
    /// assert!(w.seminorm(0.74, 1e-8).is_ok() && w.seminorm(0.75, 1e-8).is_err());
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Node`] for a corner that is not a node of a triangle or is declared twice; [`Error::Triangle`] for a
    /// triangle with more than one declared corner; [`Error::OutOfRange`] unless −1 < a ≤ 20;
    /// [`Error::NotFinite`] if a sampled value of f is not finite.
    pub fn from_plane_positions(
        mesh: &Triangles,
        corners: &[(usize, f64)],
        f: impl Fn(&PlanePosition<'_>) -> f64 + Sync + 'a,
    ) -> Result<Self> {
        SingularPlaneFunction::new(mesh.clone(), corners, f).map(Kind::PlaneFormula).map(Self::of)
    }

    /// The function on a polygonal curve with the given values: continuous and linear with one value per node (degree
    /// 1), or constant on every element (degree 0).
    ///
    /// Norms are those of this piecewise polynomial: if its values approximate another function, the error of
    /// the norm does not include the approximation error. To estimate it, compare with a mesh of half as many
    /// elements.
    ///
    /// ```
    /// use fractional_sobolev::{Function, Curve};
    /// let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    /// let curve = Curve::algebraic(&square, 2, 1.0)?;
    /// let one = Function::on_curve(&curve, 1, &[1.0; 8])?;
    /// assert!((one.norm(0.5, 1e-8)?.value - 2.0).abs() < 1e-8);
    /// assert!((one.norm(-0.5, 1e-8)?.value - 2.0).abs() < 1e-8);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::LengthMismatch`], [`Error::NotFinite`], [`Error::CountOutOfRange`] for degrees above 1.
    pub fn on_curve(curve: &Curve, degree: usize, values: &[f64]) -> Result<Self> {
        let u = match low_degree(degree)? {
            true => BoundaryFunction::linears(curve.clone(), values)?,
            false => BoundaryFunction::constants(curve.clone(), values)?,
        };
        Ok(Self::of(Kind::Curve(u)))
    }

    /// The function f of a point on the boundary of the polygon with these vertices, smooth on every side; at a
    /// vertex it may be singular or have a jump.
    ///
    /// ```text
    /// |f|²_s = ∫_Γ ∫_Γ (f(x) − f(y))² / |x − y|^{1+2s} dx dy,   0 < s < 1,   |x − y| the distance in R².
    /// ```
    ///
    /// Its norms are those of f; those of [`Function::on_curve`] are norms of the interpolant of f, and their
    /// error does not include the interpolation error. The error is the change from a coarser mesh, plus
    /// rounding. At a vertex other than the origin x is rounded; the effect on a singularity there is part of
    /// the error. Place the vertex of a strong singularity at the origin. Cost: a third of a second for a
    /// smooth function on six sides, ten seconds for singularities close to the order at which the norm becomes
    /// infinite.
    ///
    /// Between two vertices f is evaluated at the points of the rules only, eight or more on each of the elements, the
    /// longest of which is a third of the side: a feature narrower than 1/15 of a side may be missed in both the value
    /// and the error. Declare its position as a vertex.
    ///
    /// ```
    /// use fractional_sobolev::Function;
    /// // r^{2/3} sin(2θ/3) on the boundary of an L
    /// let corner = |[x, y]: [f64; 2]| {
    ///     let angle = y.atan2(x).rem_euclid(std::f64::consts::TAU);
    ///     x.hypot(y).powf(2.0 / 3.0) * (2.0 * angle / 3.0).sin()
    /// };
    /// let l = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [0.0, -1.0]];
    /// let found = Function::on_polygon(&l, corner)?.seminorm(0.5, 1e-6)?;
    /// assert!(found.relative_error() <= 1e-6);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`Curve::closed`].
    #[doc(alias("trace", "polygon", "corner singularity"))]
    pub fn on_polygon(
        vertices: &[[f64; 2]],
        f: impl Fn([f64; 2]) -> f64 + Sync + 'a,
    ) -> Result<Self> {
        CurveFormula::new(vertices, f).map(Kind::CurveFormula).map(Self::of)
    }

    /// The function together with its partial derivatives (one on an interval, two in the plane), which are
    /// required for norms of order 1 ≤ s < 2 of a formula on a triangulation. On an interval a formula without them is
    /// differentiated by its polynomials, with ten digits where it is smooth and fewer next to a singularity.
    ///
    /// ```
    /// use fractional_sobolev::Function;
    /// let slope = Function::from_fn(&[0.0, 1.0], |x| x)?;
    /// let u = Function::from_fn(&[0.0, 1.0], |x| x * x / 2.0)?.with_gradient(vec![slope]);
    /// assert!((u.norm(1.5, 1e-8)?.value.powi(2) - 83.0 / 60.0).abs() < 1e-7); // 1/20 + 1/3 + 1
    /// assert!((u.norm(1.0, 1e-8)?.value.powi(2) - 23.0 / 60.0).abs() < 1e-7);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    pub fn with_gradient(self, gradient: Vec<Function<'a>>) -> Self {
        Self { gradient, ..self }
    }

    /// The norm ‖u‖_s for −1 < s < 2: for s < 0 the dual norm sup ∫ u v / ‖v‖\_{−s}, for s = 0 the L² norm.
    ///
    /// s is a plain number or an [`Order`]; near ±1/2 and 3/2, `-order` and [`Order::plus_one`] give the
    /// distance of s from these values to full relative accuracy.
    ///
    /// ```
    /// use fractional_sobolev::{Function, Order};
    /// let u = Function::from_fn(&[0.0, 1.0], |x| x)?;
    /// assert_eq!(u.norm(Order::HALF, 1e-8)?, u.norm(0.5, 1e-8)?);
    /// assert_eq!(u.norm(-Order::HALF, 1e-6)?, u.norm(-0.5, 1e-6)?);
    /// assert!(u.norm(2.0, 1e-8).is_err() && u.norm(-1.0, 1e-8).is_err());
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::InfiniteNorm`]; [`Error::ToleranceNotMet`] with the best value; [`Error::OutOfRange`] for s
    /// outside (−1, 2); [`Error::NotFinite`] for a value of a formula that is not finite;
    /// [`Error::CountOutOfRange`] for too many elements of a curve; [`Error::Incompatible`] if there is no
    /// method for this kind of function and order.
    #[doc(alias("dual norm", "negative norm", "l2_norm"))]
    pub fn norm(
        &self,
        s: impl Given<SobolevOrder>,
        tolerance: impl Given<Tolerance>,
    ) -> Result<Estimate> {
        let tolerance = tolerance.given()?;
        match s.given()? {
            SobolevOrder::Dual(order) => self.dual_norm(DualOf::Slobodeckij, order, tolerance),
            SobolevOrder::Zero => self.lp(2.0, tolerance),
            SobolevOrder::Fractional(order) => match &self.kind {
                Kind::Formula(u) => self.of_formula(
                    tolerance,
                    |tolerance| u.norm(order, tolerance),
                    |u| u.norm(order, tolerance),
                ),
                Kind::NearlyOne(u, _) => u.norm(order, tolerance),
                Kind::Piecewise(u) => u.norm(order, tolerance),
                Kind::Difference(u, v) => {
                    let rules = |tolerance| u.minus(v).norm(order, tolerance);
                    self.of_formula(tolerance, rules, |u| u.norm(order, tolerance))
                }
                Kind::Resolved(u) => u.norm(order, tolerance),
                Kind::Plane(u) => u.norm(order, tolerance),
                Kind::PlaneFormula(u) => u.norm(order, tolerance),
                Kind::Curve(u) => u.norm(order, tolerance),
                Kind::CurveFormula(u) => u.norm(order, tolerance),
            },
            SobolevOrder::One => {
                let mut parts = vec![self.lp(2.0, tolerance)?];
                parts.extend(self.gradient_norms(tolerance)?);
                root_of_squares(&parts)
            }
            SobolevOrder::OnePlus(order) => self.norm_above_one(order, tolerance),
        }
    }

    /// The seminorm |u|_s for 0 < s < 2: |u|_1 = ‖∇u‖, and |u|_s = |∇u|\_{s−1} for s > 1. s as for
    /// [`Function::norm`], but [`Error::OutOfRange`] unless 0 < s < 2.
    ///
    /// It is finite for s < 1/2 if u jumps, and for s < a + d/2 if u behaves like r^a at a corner or
    /// breakpoint. In the plane (1−s)|u|²_s → (π/2)‖∇u‖² as s → 1, and |u(·/l)|_s = l^{d/2−s}|u|_s. On a curve
    /// |x − y| is the Euclidean distance in the plane; on a Lipschitz curve |u|_s is equivalent to the seminorm of the trace space.
    /// There is no special rule for a singularity along an edge of a triangulation: [`Error::ToleranceNotMet`]
    /// reports the accuracy that was reached.
    ///
    /// ```
    /// use fractional_sobolev::{Function, Order};
    /// let slope = Function::from_fn(&[0.0, 1.0], |x| x)?;
    /// let u = Function::from_fn(&[0.0, 1.0], |x| x * x / 2.0)?.with_gradient(vec![slope]);
    /// for s in [Order::HALF.plus_one(), Order::new(0.5)?.plus_one()] {
    ///     assert!((u.seminorm(s, 1e-8)?.value - 1.0).abs() < 1e-8); // |x|_{1/2} = 1
    /// }
    /// assert!((u.seminorm(1.0, 1e-8)?.value.powi(2) - 1.0 / 3.0).abs() < 1e-8);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`Function::norm`].
    #[doc(alias("Gagliardo", "Slobodeckij"))]
    pub fn seminorm(
        &self,
        s: impl Given<SobolevOrder>,
        tolerance: impl Given<Tolerance>,
    ) -> Result<Estimate> {
        let tolerance = tolerance.given()?;
        let order = match s.given()? {
            SobolevOrder::Fractional(order) => order,
            SobolevOrder::One => return root_of_squares(&self.gradient_norms(tolerance)?),
            SobolevOrder::OnePlus(order) => return self.seminorm_above_one(order, tolerance),
            SobolevOrder::Zero => return Err(order_outside(0.0)),
            SobolevOrder::Dual(order) => return Err(order_outside(-order.value())),
        };
        match &self.kind {
            Kind::Formula(u) => self.of_formula(
                tolerance,
                |tolerance| u.seminorm(order, tolerance),
                |u| u.seminorm(order, tolerance),
            ),
            Kind::NearlyOne(u, _) => u.seminorm(order, tolerance),
            Kind::Piecewise(u) => u.seminorm(order, tolerance),
            Kind::Difference(u, v) => {
                let rules = |tolerance| u.minus(v).seminorm(order, tolerance);
                self.of_formula(tolerance, rules, |u| u.seminorm(order, tolerance))
            }
            Kind::Resolved(u) => u.seminorm(order, tolerance),
            Kind::Plane(u) => u.seminorm(order, tolerance),
            Kind::PlaneFormula(u) => u.seminorm(order, tolerance),
            Kind::Curve(u) => u.seminorm(order, tolerance),
            Kind::CurveFormula(u) => u.seminorm(order, tolerance),
        }
    }

    /// The norm of u in L^q: (∫ |u|^q)^{1/q} for 1 ≤ q < ∞, max |u| for q = ∞; in the plane, and for a
    /// formula on the boundary of a polygon, only q = 2.
    ///
    /// For values on a mesh or a curve it is exact to rounding where u is linear; elements of higher degree
    /// are bisected until a Gauss rule and its two halves agree. For a formula, declare the zeros (for q =
    /// ∞ the jumps) as breakpoints, because |u|^q is not smooth there.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for q < 1 or NaN, else as [`Function::norm`].
    #[doc(alias("lq_norm", "L2"))]
    pub fn lp(&self, q: f64, tolerance: impl Given<Tolerance>) -> Result<Estimate> {
        let tolerance = tolerance.given()?;
        let square = q == 2.0;
        match &self.kind {
            // A maximum takes fewer values than polynomials.
            Kind::Formula(u) | Kind::NearlyOne(_, u) if q == f64::INFINITY => {
                self.or_resolved(u.lq_norm(q, tolerance), |u| u.lq_norm(q, tolerance))
            }
            Kind::Formula(u) | Kind::NearlyOne(_, u) => self.of_formula(
                tolerance,
                |tolerance| if square { u.l2_norm(tolerance) } else { u.lq_norm(q, tolerance) },
                |u| u.lq_norm(q, tolerance),
            ),
            Kind::Piecewise(u) if square => u.l2_norm(),
            Kind::Piecewise(u) => u.lq_norm(q, tolerance),
            Kind::Difference(u, v) => {
                let u = u.minus(v);
                let rules =
                    |tolerance| if square { u.l2_norm(tolerance) } else { u.lq_norm(q, tolerance) };
                self.of_formula(tolerance, rules, |u| u.lq_norm(q, tolerance))
            }
            Kind::Resolved(u) => u.lq_norm(q, tolerance),
            Kind::Curve(u) if square => u.l2_norm(),
            Kind::Curve(u) => u.lq_norm(q, tolerance),
            Kind::CurveFormula(u) if square => u.l2_norm(tolerance),
            Kind::Plane(u) if square => u.l2_norm(),
            Kind::PlaneFormula(u) if square => u.l2_norm(tolerance),
            _ => Err(self.refused("norm in L^q")),
        }
    }

    /// The mean (1/|I|) ∫ u of u over its interval; the tolerance is relative to the mean of |u|. It is
    /// exact to rounding for a piecewise polynomial.
    ///
    /// # Errors
    /// [`Error::Incompatible`] unless the function is a formula or a piecewise polynomial on an interval;
    /// else as [`Function::norm`].
    pub fn mean(&self, tolerance: impl Given<Tolerance>) -> Result<Estimate> {
        let tolerance = tolerance.given()?;
        match &self.kind {
            Kind::Formula(u) | Kind::NearlyOne(_, u) => {
                self.of_formula(tolerance, |tolerance| u.mean(tolerance), |u| u.mean(tolerance))
            }
            Kind::Piecewise(u) => u.mean(),
            Kind::Difference(..) => self.resolved()?.mean(tolerance),
            Kind::Resolved(u) => u.mean(tolerance),
            _ => Err(self.refused("mean")),
        }
    }

    /// The dual norm sup ∫ u v / ‖v‖ with respect to the norm of order 0 < s < 1 selected by [`DualOf`];
    /// [`Function::norm`] of order −s is the dual norm for [`DualOf::Slobodeckij`].
    ///
    /// In the interpolation spaces the dual norm of a piecewise polynomial is Balakrishnan's integral of
    /// resolvents, each in closed form on every element: exact to rounding on every mesh, at the cost of about
    /// a hundred passes over the elements. For [`DualOf::Slobodeckij`] the supremum is taken over the piecewise
    /// linear functions on M equal elements, with a correction of the discretisation error; M is doubled up to
    /// 2^20, and the error estimate is the change at the last doubling. A formula is replaced by a piecewise
    /// polynomial on a mesh graded towards its breakpoints; the L² norm of the difference bounds the dual norm
    /// of the difference and is part of the error. On a closed curve the interpolation spaces are periodic in
    /// the arc length.
    ///
    /// ```
    /// use fractional_sobolev::{DualOf, Function, Mesh};
    /// let one = Function::piecewise(&Mesh::uniform(4, 1.0)?, 0, &[1.0; 4])?;
    /// assert!((one.dual_norm(DualOf::Interpolation, 0.5, 1e-8)?.value - 1.0).abs() < 1e-8);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`Function::norm`].
    #[doc(alias("H-1/2", "negative norm"))]
    pub fn dual_norm(
        &self,
        of: DualOf,
        s: impl Given<Order>,
        tolerance: impl Given<Tolerance>,
    ) -> Result<Estimate> {
        let (order, tolerance) = (s.given()?, tolerance.given()?);
        match &self.kind {
            Kind::Formula(u) | Kind::NearlyOne(_, u) => self.of_formula(
                tolerance,
                |tolerance| u.dual_norm(of, order, tolerance),
                |u| u.dual_norm(of, order, tolerance),
            ),
            Kind::Piecewise(u) => u.dual_norm(of, order, tolerance),
            Kind::Difference(u, v) => {
                let rules = |tolerance| u.minus(v).dual_norm(of, order, tolerance);
                self.of_formula(tolerance, rules, |u| u.dual_norm(of, order, tolerance))
            }
            Kind::Resolved(u) => u.dual_norm(of, order, tolerance),
            Kind::Curve(u) => u.dual_norm(of, order, tolerance),
            Kind::CurveFormula(u) if of == DualOf::Slobodeckij => {
                u.dual_of_slobodeckij(order, tolerance)
            }
            Kind::CurveFormula(_) => Err(self.refused("dual norm of an interpolation space")),
            _ => Err(self.refused("dual norm")),
        }
    }

    /// The largest declared degree of a piecewise polynomial on an element.
    ///
    /// ```
    /// use fractional_sobolev::{Function, Mesh};
    /// let u = Function::interpolate(&Mesh::uniform(3, 1.0)?, 4, |x| x.sin())?;
    /// assert_eq!([u.degree()?, u.derivative()?.degree()?], [4, 3]);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Incompatible`] if the function is not a piecewise polynomial.
    pub fn degree(&self) -> Result<usize> {
        self.polynomials("degree").map(PiecewisePolynomial::degree)
    }

    /// The value at the local coordinate t ∈ \[0, 1\] of an element, from left to right.
    ///
    /// # Errors
    /// [`Error::Incompatible`] if the function is not a piecewise polynomial; [`Error::CountOutOfRange`] for an
    /// element outside the mesh; [`Error::OutOfRange`] for t outside \[0, 1\].
    pub fn value_on(&self, element: usize, t: f64) -> Result<f64> {
        self.polynomials("value on an element")?.value(element, t)
    }

    /// The mesh of a piecewise polynomial on an interval.
    ///
    /// ```
    /// use fractional_sobolev::{Function, Mesh};
    /// let u = Function::linears(&Mesh::uniform(4, 1.0)?, &[0.0, 1.0, 2.0, 0.0, 0.0])?;
    /// let part = u.restrict(1..3)?;
    /// assert!(part.mesh()?.total() == 0.5 && part.value_on(0, 0.5)? == 1.5);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Incompatible`] if the function is not a piecewise polynomial.
    pub fn mesh(&self) -> Result<&Mesh> {
        self.polynomials("mesh").map(PiecewisePolynomial::mesh)
    }

    /// The underlying piecewise polynomial.
    pub(crate) fn polynomials(&self, quantity: &str) -> Result<&PiecewisePolynomial> {
        match &self.kind {
            Kind::Piecewise(u) => Ok(u),
            _ => Err(self.refused(quantity)),
        }
    }

    /// The L² norms of the partial derivatives.
    fn gradient_norms(&self, tolerance: Tolerance) -> Result<Vec<Estimate>> {
        match &self.kind {
            Kind::Piecewise(u) if u.is_continuous() => Ok(vec![u.derivative()?.l2_norm()?]),
            Kind::Piecewise(_) => {
                let why = "a function that jumps has no derivative in L^2";
                Err(Error::InfiniteNorm { order: 1.0, why })
            }
            Kind::Plane(u) if !u.is_piecewise_constant() => {
                u.gradient()?.iter().map(PlaneFunction::l2_norm).collect()
            }
            _ if !self.gradient.is_empty() => {
                self.gradient.iter().map(|part| part.lp(2.0, tolerance)).collect()
            }
            Kind::Curve(u) => Ok(vec![u.derivative()?.l2_norm()?]),
            Kind::CurveFormula(u) => Ok(vec![u.derivative().l2_norm(tolerance).map_err(one_more)?]),
            _ if self.is_on_interval() => {
                Ok(vec![self.slope(1.0, tolerance)?.lp(2.0, tolerance).map_err(one_more)?])
            }
            _ => Err(self.refused("norm of order 1")),
        }
    }

    /// The norm ‖u‖_{1+ν}.
    fn norm_above_one(&self, order: Order, tolerance: Tolerance) -> Result<Estimate> {
        match (&self.kind, &self.gradient[..]) {
            (Kind::Piecewise(u), _) => u.norm_with_derivative(&u.derivative()?, order, tolerance),
            (Kind::Plane(u), _) => u.norm_with_gradient(order, tolerance),
            (Kind::Curve(u), _) => {
                let slope = u.derivative()?.norm(order, tolerance).map_err(one_more);
                root::whole([u.l2_norm(), slope], tolerance, OF_PARTS)
            }
            (Kind::CurveFormula(u), _) => {
                let slope = u.derivative().norm(order, tolerance).map_err(one_more);
                root::whole([u.l2_norm(tolerance), slope], tolerance, OF_PARTS)
            }
            (
                Kind::Formula(u) | Kind::NearlyOne(_, u),
                [Function { kind: Kind::Formula(slope), .. }],
            ) => u.norm_with_derivative(slope, order, tolerance),
            (
                Kind::PlaneFormula(u),
                [
                    Function { kind: Kind::PlaneFormula(x), .. },
                    Function { kind: Kind::PlaneFormula(y), .. },
                ],
            ) => u.norm_with_gradient([x, y], order, tolerance),
            _ if self.is_on_interval() => {
                let slope = self.slope(1.0 + order.value(), tolerance)?;
                let parts =
                    [self.lp(2.0, tolerance), slope.norm(order, tolerance).map_err(one_more)];
                root::whole(parts, tolerance, OF_PARTS)
            }
            _ => Err(self.refused("norm of order above 1")),
        }
    }

    /// The seminorm |∇u|_ν.
    fn seminorm_above_one(&self, order: Order, tolerance: Tolerance) -> Result<Estimate> {
        let why = "a function that jumps has no derivative in L^2";
        let infinite = || Err(Error::InfiniteNorm { order: 1.0 + order.value(), why });
        match &self.kind {
            Kind::Piecewise(u) if u.is_continuous() => u.derivative()?.seminorm(order, tolerance),
            Kind::Piecewise(_) => infinite(),
            Kind::Plane(u) if u.is_piecewise_constant() => infinite(),
            Kind::Plane(u) => {
                let [x, y] = u.gradient()?.map(|part| part.seminorm(order, tolerance));
                root_of_squares(&[x?, y?])
            }
            Kind::Curve(u) => u.derivative()?.seminorm(order, tolerance).map_err(one_more),
            Kind::CurveFormula(u) => u.derivative().seminorm(order, tolerance).map_err(one_more),
            _ if !self.gradient.is_empty() => {
                let parts = self.gradient.iter().map(|part| part.seminorm(order, tolerance));
                root_of_squares(&parts.collect::<Result<Vec<_>>>()?)
            }
            _ if self.is_on_interval() => self
                .slope(1.0 + order.value(), tolerance)?
                .seminorm(order, tolerance)
                .map_err(one_more),
            _ => Err(self.refused("seminorm of order above 1")),
        }
    }

    fn is_on_interval(&self) -> bool {
        let is_formula = matches!(self.kind, Kind::Formula(_) | Kind::NearlyOne(..));
        is_formula || matches!(self.kind, Kind::Difference(..) | Kind::Resolved(_))
    }

    /// The derivative of a function on an interval, for a norm of the given order.
    ///
    /// # Errors
    /// [`Error::InfiniteNorm`] if the function jumps.
    fn slope(&self, order: f64, tolerance: Tolerance) -> Result<Self> {
        if self.gradient.is_empty() {
            self.resolved()?.require_derivative(order, tolerance)?;
        }
        self.derivative()
    }

    fn describe(&self) -> &'static str {
        match self.kind {
            Kind::Formula(_) | Kind::NearlyOne(..) => "a formula on an interval",
            Kind::Piecewise(_) => "a piecewise polynomial",
            Kind::Difference(..) => "a formula minus a piecewise polynomial",
            Kind::Resolved(_) => "a sum, a product or a derivative on an interval",
            Kind::Plane(_) => "values on a triangulation",
            Kind::PlaneFormula(_) => "a formula on a triangulation",
            Kind::Curve(_) => "values on a polygonal curve",
            Kind::CurveFormula(_) => "a formula on the boundary of a polygon",
        }
    }

    /// [`Error::Incompatible`] for a quantity that is not defined for this kind of function.
    fn refused(&self, quantity: &str) -> Error {
        let expected = match self.kind {
            Kind::Formula(_) | Kind::NearlyOne(..) => {
                "norms of order in (-1, 2), L^q norms, the mean, values, restrictions"
            }
            Kind::Piecewise(_) => {
                "norms of order in (-1, 2), L^q norms, the mean, values, restrictions"
            }
            Kind::Difference(..) | Kind::Resolved(_) => {
                "norms of order in (-1, 2), L^q norms, the mean, values, restrictions"
            }
            Kind::Plane(_) => "norms of order in [0, 2), the L^2 norm",
            Kind::PlaneFormula(_) => {
                "norms of order in [0, 1), the L^2 norm; of order below 2 with Function::with_gradient"
            }
            Kind::Curve(_) => "norms of order in (-1, 2), L^q norms",
            Kind::CurveFormula(_) => {
                "norms of order in (-1, 2), the L^2 norm, dual norms of DualOf::Slobodeckij"
            }
        };
        Error::Incompatible {
            what: "the",
            given: quantity.to_owned(),
            with: self.describe(),
            expected,
        }
    }
}

impl From<PiecewisePolynomial> for Function<'_> {
    fn from(u: PiecewisePolynomial) -> Self {
        Self::of(Kind::Piecewise(u))
    }
}

/// The error of a norm of the derivative as that of a norm of the function.
fn one_more(error: Error) -> Error {
    match error {
        Error::InfiniteNorm { order, why } => Error::InfiniteNorm { order: 1.0 + order, why },
        other => other,
    }
}

fn order_outside(value: f64) -> Error {
    Error::OutOfRange { name: "order of the seminorm", value, range: "(0, 2)" }
}

/// True for degree 1, false for degree 0.
fn low_degree(degree: usize) -> Result<bool> {
    match degree {
        0 => Ok(false),
        1 => Ok(true),
        value => Err(Error::CountOutOfRange { name: "polynomial degree", value, range: "{0, 1}" }),
    }
}
