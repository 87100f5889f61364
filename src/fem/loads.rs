//! Load vectors l(φ_i) = ∫_Ω f·φ_i + ∫_{Γ_N} F·φ_i, Cartesian and node-major.

use super::cubature::Cubature;
use super::field::Field;
use super::form::Element;
use crate::error::Result;
use crate::mesh::{Part, Point, Triangulation, distance};
use fractional_sobolev::Rule;

/// The load vector of the P1 function with the given nodal values: consistent mass matrix times values.
///
/// ∫ f_h φ_i, exact for P1 functions f_h; `values` and the result have `components` entries per node, node-major. The
/// element mass matrix is A (1 + δ_ij)/12, A the area.
pub(crate) fn consistent_load(mesh: &Triangulation, components: usize, values: &[f64]) -> Vec<f64> {
    let mut load = vec![0.0; mesh.nodes().len() * components];
    for (t, corners) in mesh.triangles().iter().enumerate() {
        let weight = Element::new(mesh.corners(t)).area / 12.0;
        for c in 0..components {
            let f = corners.map(|node| values[node * components + c]);
            let sum = f[0] + f[1] + f[2];
            for k in 0..3 {
                load[corners[k] * components + c] += weight * (sum + f[k]);
            }
        }
    }
    load
}

/// The load vector ∫_Ω f·φ_i, by the given rule.
///
/// It is node-major, with as many components as the field; the entries of a component sum to the integral of that
/// component over Ω.
///
/// # Errors
/// [`ToolkitError::NotFiniteAt`](crate::ToolkitError::NotFiniteAt) if f is not finite at a point of the rule.
pub(crate) fn volume_load(
    mesh: &Triangulation,
    density: &Field<'_>,
    rule: &Cubature,
) -> Result<Vec<f64>> {
    load_by_triangles(mesh, density.components(), rule, &|_, point| density.at(point))
}

/// The load vector ∫_Ω f·φ_i for f that depends on the number of the triangle as well.
pub(crate) fn load_by_triangles(
    mesh: &Triangulation,
    components: usize,
    rule: &Cubature,
    density: &dyn Fn(usize, Point) -> Result<Point>,
) -> Result<Vec<f64>> {
    let mut load = vec![0.0; mesh.nodes().len() * components];
    for (t, corners) in mesh.triangles().iter().enumerate() {
        let triangle = mesh.corners(t);
        let element = Element::new(triangle);
        rule.on(triangle, &mut |point, weight| {
            let value = density(t, point)?;
            let shares = element.barycentric(triangle, point);
            for k in 0..3 {
                for c in 0..components {
                    load[corners[k] * components + c] += weight * shares[k] * value[c];
                }
            }
            Ok(())
        })?;
    }
    Ok(load)
}

/// The load vector ∫_Γ F·φ_i over the boundary edges with the given label, by a Gauss rule on every edge. F receives
/// the number of the boundary edge, the point and the outward unit normal.
///
/// # Errors
/// The first error returned by F; its values are not checked.
pub(crate) fn load_by_edges(
    mesh: &Triangulation,
    part: Part,
    components: usize,
    density: &dyn Fn(usize, Point, Point) -> Result<Point>,
    rule: &Rule,
) -> Result<Vec<f64>> {
    let mut load = vec![0.0; mesh.nodes().len() * components];
    for (number, edge) in mesh.boundary().iter().enumerate().filter(|(_, edge)| edge.part == part) {
        let [a, b] = mesh.ends(edge);
        let length = distance(a, b);
        let normal = [(b[1] - a[1]) / length, (a[0] - b[0]) / length];
        for (t, weight) in rule.iter() {
            let point = [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])];
            let value = density(number, point, normal)?;
            for (node, share) in edge.nodes.into_iter().zip([1.0 - t, t]) {
                for c in 0..components {
                    load[node * components + c] += weight * length * share * value[c];
                }
            }
        }
    }
    Ok(load)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{SideParts, unit_square};

    #[test]
    fn quadrature_of_an_affine_load_is_the_consistent_one() {
        let mesh = unit_square(3, SideParts::HANGING).unwrap();
        let affine = |[x, y]: Point| [1.0 + x - 2.0 * y, 3.0 * y];
        let field = Field::Vector(&affine);
        let values = field.sample(mesh.nodes()).unwrap();
        let nodal = consistent_load(&mesh, 2, &values);
        let load = volume_load(&mesh, &field, &Cubature::new(2).unwrap()).unwrap();
        // Up to six triangles with four points each: rounding of 24 terms below 0.2/6 in size.
        let allowed = 24.0 * f64::EPSILON * 0.2 / 6.0;
        for (a, b) in load.iter().zip(nodal) {
            assert!((a - b).abs() < allowed, "{a} {b}");
        }
    }
}
