//! Distances between a P1 function and a given function, by quadrature: L² norm, H¹ seminorm, energy norm.

use super::cubature::Cubature;
use super::field::Field;
use super::form::{Element, Form};
use crate::error::Result;
use crate::mesh::{Point, Triangulation};
use crate::numeric::check::{require_finite_at, require_length};

/// Norms of u − u_h.
///
/// For the Laplacian `energy` = `h1`. All three norms are absolute, over the whole domain, and exact up to the error
/// of the cubature rule.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ErrorNorms {
    /// The L² norm (∫ |u − u_h|²)^{1/2}.
    pub l2: f64,
    /// The H¹ seminorm (∫ |∇(u − u_h)|²)^{1/2}.
    pub h1: f64,
    /// The energy norm a(u − u_h, u − u_h)^{1/2}.
    pub energy: f64,
}

/// The norms of the difference between the function `exact`, given with its gradient, and the P1 function with
/// Cartesian nodal `values`.
///
/// Row c of the gradient is that of component c; for a scalar function the second row is 0. The gradient is evaluated
/// only at the points of the rule. For u = x² and its interpolant on the unit
/// square, cut into right isosceles triangles with legs h, the squared H¹ seminorm of the error is h²/3.
///
/// ```
/// use signorini::fem::{Cubature, Field, Form, error_norms};
/// use signorini::mesh::{SideParts, unit_square};
/// let mesh = unit_square(4, SideParts::HANGING)?;
/// let values: Vec<f64> = mesh.nodes().iter().map(|p| p[0] * p[0]).collect();
/// let (u, slope) = (|[x, _]: [f64; 2]| x * x, |[x, _]: [f64; 2]| [[2.0 * x, 0.0], [0.0, 0.0]]);
/// let errors = error_norms(&mesh, &Form::LAPLACE, &values, (&Field::Scalar(&u), &slope), &Cubature::new(3)?)?;
/// assert!((errors.h1.powi(2) - 1.0 / 48.0).abs() < 1e-14 && errors.energy == errors.h1);
/// # Ok::<(), signorini::Error>(())
/// ```
///
/// # Errors
/// [`ToolkitError::LengthMismatch`](crate::ToolkitError::LengthMismatch) for a wrong number of components or values,
/// [`ToolkitError::NotFiniteAt`](crate::ToolkitError::NotFiniteAt) if u,
/// [`ToolkitError::NotFinite`](crate::ToolkitError::NotFinite) if ∇u is not finite at a point of the rule.
pub fn error_norms(
    mesh: &Triangulation,
    form: &Form,
    values: &[f64],
    (exact, gradient): (&Field<'_>, &dyn Fn(Point) -> [Point; 2]),
    rule: &Cubature,
) -> Result<ErrorNorms> {
    let c = form.components();
    exact.require(c)?;
    require_length("nodal values", values.len(), mesh.nodes().len() * c)?;
    let [mut l2, mut h1, mut energy] = [0.0; 3];
    for (t, corners) in mesh.triangles().iter().enumerate() {
        let triangle = mesh.corners(t);
        let element = Element::new(triangle);
        let at = |axis: usize| corners.map(|node| values[node * c + axis]);
        let mut discrete = [[0.0; 2]; 2];
        (0..c).for_each(|axis| discrete[axis] = element.gradient(at(axis)));
        rule.on(triangle, &mut |point, weight| {
            let (value, slope) = (exact.at(point)?, gradient(point));
            let shares = element.barycentric(triangle, point);
            let mut difference = [[0.0; 2]; 2];
            let mut square = 0.0;
            for axis in 0..c {
                let nodal = at(axis);
                let u_h: f64 = (0..3).map(|k| shares[k] * nodal[k]).sum();
                square += (value[axis] - u_h).powi(2);
                for d in 0..2 {
                    difference[axis][d] = slope[axis][d] - discrete[axis][d];
                }
            }
            let slopes: f64 = difference.iter().flatten().map(|d| d * d).sum();
            require_finite_at("squared gradient of the error in a triangle", t, slopes)?;
            l2 += weight * square;
            h1 += weight * slopes;
            energy += weight * density(form, mesh.region(t), &difference, square);
            Ok(())
        })?;
    }
    Ok(ErrorNorms { l2: l2.sqrt(), h1: h1.sqrt(), energy: energy.sqrt() })
}

/// The integrand of a(v, v) from ∇v and |v|².
fn density(form: &Form, region: usize, gradient: &[Point; 2], square: f64) -> f64 {
    let [[xx, xy], [yx, yy]] = *gradient;
    match (form, form.material(region)) {
        (Form::Elastic { .. }, Some(material)) => {
            let shear = xy + yx;
            material.lambda() * (xx + yy).powi(2)
                + material.mu() * (2.0 * xx * xx + 2.0 * yy * yy + shear * shear)
        }
        (Form::Scalar { reaction }, _) => xx * xx + xy * xy + reaction * square,
        (Form::Elastic { .. }, None) => 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fem::Lame;
    use crate::mesh::{SideParts, unit_square};

    #[test]
    fn norms_of_a_known_function() {
        // u = (x², xy), u_h = 0 on the unit square: ∫|u|² = 1/5 + 1/9, ∫|∇u|² = 4/3 + 1/3 + 1/3; ε = ((2x,
        // y/2), ·, x).
        let mesh = unit_square(2, SideParts::HANGING).unwrap();
        let form = Form::elastic(Lame::new(1.0, 1.0).unwrap());
        let zero = vec![0.0; 18];
        let u = |[x, y]: Point| [x * x, x * y];
        let gradient = |[x, y]: Point| [[2.0 * x, 0.0], [y, x]];
        let rule = Cubature::new(3).unwrap();
        let norms =
            error_norms(&mesh, &form, &zero, (&Field::Vector(&u), &gradient), &rule).unwrap();
        for (value, square) in [
            (norms.l2, 14.0 / 45.0),
            (norms.h1, 2.0),
            (norms.energy, 3.0 + 2.0 * 5.0 / 3.0 + 1.0 / 3.0),
        ] {
            assert!((value * value / square - 1.0).abs() < 1e-14, "{value} {square}");
        }
        assert!(
            error_norms(&mesh, &Form::LAPLACE, &zero, (&Field::Vector(&u), &gradient), &rule)
                .is_err()
        );
    }
}
