//! Integration over triangles: conical products of Gauss rules, graded toward declared singular points.
//!
//! The map (s, t) ↦ a + s ((b − a) + t (c − b)) takes the unit square to the triangle with Jacobian 2A s, so n points
//! of the Gauss-Jacobi rule with weight s and n Gauss-Legendre points in t are exact for degree 2n − 1 (A. H. Stroud,
//! Approximate Calculation of Multiple Integrals, 1971). A triangle that touches a singular point is cut into four,
//! as is the piece at the point, and so on; after [`DEPTH`] cuts its area is 4^{-DEPTH} of that of the triangle.
//! Cost: n² points per triangle, 3 · DEPTH · n² per triangle at a singular point.

use crate::error::Result;
use crate::mesh::{Point, doubled_area};
use fractional_sobolev::{gauss_jacobi, gauss_legendre};

/// Cuts toward a singular point: what is left has 4^{−40} of the area, below rounding for every r^p with p >
/// −0.7.
const DEPTH: usize = 40;

/// Distance outside a triangle, in barycentric coordinates, within which a singular point counts as inside:
/// above their rounding.
const MARGIN: f64 = 1e-12;

/// A cubature rule for triangles.
///
/// All weights are positive; on a triangle of area A, and on every cell of area A of the graded rule, they
/// sum to A.
#[derive(Debug, Clone)]
pub struct Cubature {
    /// (s, t, weight), weights summing to 1/2 for the unit square with Jacobian s.
    points: Vec<[f64; 3]>,
    singular: Vec<Point>,
}

impl Cubature {
    /// The rule with n × n points on each triangle, exact for polynomials of degree 2n − 1.
    ///
    /// ```
    /// use signorini::fem::Cubature;
    /// let mut integral = 0.0;
    /// let triangle = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
    /// Cubature::new(2)?.on(triangle, &mut |[x, y], weight| Ok(integral += weight * x * x * y))?;
    /// assert!((integral - 1.0 / 60.0).abs() < 1e-16);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) for n = 0 and for n > 65536.
    pub fn new(n: usize) -> Result<Self> {
        let (radial, across) = (gauss_jacobi(n, 0.0, 1.0)?, gauss_legendre(n)?);
        let points = radial
            .iter()
            .flat_map(|(s, v)| across.iter().map(move |(t, w)| [s, t, v * w]).collect::<Vec<_>>())
            .collect();
        Ok(Self { points, singular: Vec::new() })
    }

    /// The same rule for integrands that are singular (integrable, or not smooth) at the given points.
    ///
    /// Triangles that contain one of the points are refined toward it in 40 steps; all others have the plain rule.
    ///
    /// ```
    /// use signorini::fem::Cubature;
    /// let (rule, mut integral) = (Cubature::new(8)?.singular_at(&[[0.0, 0.0]]), 0.0);
    /// let triangle = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]];
    /// rule.on(triangle, &mut |[x, y], weight| Ok(integral += weight / x.hypot(y)))?;
    /// // ∫ 1/r = ∫ dθ/cos θ over (0, π/4) = ln(1 + √2).
    /// assert!((integral - 1f64.asinh()).abs() < 1e-9);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    pub fn singular_at(mut self, points: &[Point]) -> Self {
        self.singular.extend_from_slice(points);
        self
    }

    /// Calls `visit(point, weight)` for every point of the rule on a triangle; returns the first error of `visit`.
    ///
    /// # Errors
    /// The error returned by `visit`.
    pub fn on(
        &self,
        triangle: [Point; 3],
        visit: &mut dyn FnMut(Point, f64) -> Result<()>,
    ) -> Result<()> {
        self.graded(triangle, DEPTH, visit)
    }

    fn graded(
        &self,
        triangle: [Point; 3],
        depth: usize,
        visit: &mut dyn FnMut(Point, f64) -> Result<()>,
    ) -> Result<()> {
        if depth == 0 || !self.singular.iter().any(|&point| contains(triangle, point)) {
            return self.plain(triangle, visit);
        }
        let [a, b, c] = triangle;
        let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
        for part in [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]] {
            self.graded(part, depth - 1, visit)?;
        }
        Ok(())
    }

    /// Σ 2A w_k f(a + s_k ((b − a) + t_k (c − b))), w_k with the factor s_k of the Jacobian.
    fn plain(
        &self,
        triangle: [Point; 3],
        visit: &mut dyn FnMut(Point, f64) -> Result<()>,
    ) -> Result<()> {
        let [a, b, c] = triangle;
        let doubled = doubled_area(triangle);
        for &[s, t, weight] in &self.points {
            let along = |k: usize| a[k] + s * ((b[k] - a[k]) + t * (c[k] - b[k]));
            visit([along(0), along(1)], weight * doubled)?;
        }
        Ok(())
    }
}

fn middle(a: Point, b: Point) -> Point {
    [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])]
}

/// Closed triangle, with a margin of rounding.
fn contains(triangle: [Point; 3], point: Point) -> bool {
    let [a, b, c] = triangle;
    let margin = -MARGIN * doubled_area(triangle);
    [[a, b, point], [b, c, point], [c, a, point]]
        .into_iter()
        .all(|part| doubled_area(part) >= margin)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn integral(rule: &Cubature, triangle: [Point; 3], f: impl Fn(Point) -> f64) -> f64 {
        let mut sum = 0.0;
        rule.on(triangle, &mut |point, weight| {
            sum += weight * f(point);
            Ok(())
        })
        .unwrap();
        sum
    }

    const UNIT: [Point; 3] = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];

    #[test]
    fn monomials_are_exact() {
        // ∫ x^i y^j = i! j! / (i + j + 2)!.
        let factorial = |n: u32| (1..=n).map(f64::from).product::<f64>();
        let rule = Cubature::new(4).unwrap();
        for i in 0..=7 {
            for j in 0..=7 - i {
                let exact = factorial(i) * factorial(j) / factorial(i + j + 2);
                let value = integral(&rule, UNIT, |[x, y]| x.powi(i as i32) * y.powi(j as i32));
                assert!((value / exact - 1.0).abs() < 1e-13, "{i} {j}");
            }
        }
    }
}
