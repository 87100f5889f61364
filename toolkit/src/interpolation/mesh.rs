//! Lemma 6.2: the best constants on a mesh.

use super::element::{refused, require_length, scale};
use super::elements::ElementMesh;
use super::extremal::{Largest, largest};
use super::forms::{lagrange_form, projection_form, seminorm_form};
use crate::Mesh;
use crate::constant::{BestConstant, ErrorNorm, UnitOrder};
use crate::error::Result;
use crate::estimate::Tolerance;
use nalgebra::DMatrix;

/// Number of cells per element of the first mesh.
const FIRST: usize = 8;

/// The supremum of ‖u − I^h u‖ / |u|\_{1+s} on a mesh.
///
/// # Errors
/// As [`crate::interpolation_constant`].
pub(super) fn on_mesh(
    mesh: Mesh,
    norm: ErrorNorm,
    s: UnitOrder,
    tolerance: Tolerance,
) -> Result<BestConstant> {
    let total = require_length(mesh.total())?;
    let factor = scale(norm, s.value(), total);
    let forms = |cells: &ElementMesh| {
        Ok((seminorm_form(cells.cells(), s), error_form(norm, cells, total)?))
    };
    let found = largest(&mesh, FIRST, tolerance, forms)
        .map_err(|error| error.carry("interpolation constant", |best| best.times(factor)))?;
    let constant = found.root.times(factor)?;
    let unit = total.powf(0.5 + s.value());
    Ok(BestConstant::new(constant, constant, None)
        .with_extremal(move |point| {
            point.first().and_then(|&x| error(&found, x / total)).map_or(f64::NAN, |e| unit * e)
        })
        .with_others(move |norm| on_mesh(mesh.clone(), norm, s, tolerance)))
}

/// The matrix B of the squared error norm as a form of the nodal values of the slope.
fn error_form(norm: ErrorNorm, mesh: &ElementMesh, total: f64) -> Result<DMatrix<f64>> {
    Ok(match norm {
        ErrorNorm::L2 => lagrange_form(mesh)?,
        ErrorNorm::Derivative => projection_form(mesh),
        ErrorNorm::H1 => projection_form(mesh) + lagrange_form(mesh)? * (total * total),
        ErrorNorm::Dual | ErrorNorm::At(_) => return Err(refused(norm)),
    })
}

/// The integral of v − π^h v from the left end of the element to a point of (0, 1).
fn error(found: &Largest, x: f64) -> Option<f64> {
    let Largest { mesh, values, .. } = found;
    let (nodes, lengths) = (mesh.cells().from_left(), mesh.cells().lengths());
    let cell = super::cell_of(mesh.cells(), x)?;
    let element = mesh.elements().iter().find(|range| range.contains(&cell))?;
    let over = |i: usize| 0.5 * lengths[i] * (values[i] + values[i + 1]);
    let all: f64 = element.clone().map(over).sum();
    let (start, end) = (nodes[element.start], nodes[element.end]);
    let rest = x - nodes[cell];
    let slope = (values[cell + 1] - values[cell]) / lengths[cell];
    let before: f64 = (element.start..cell).map(over).sum();
    Some(before + rest * (values[cell] + 0.5 * slope * rest) - all * (x - start) / (end - start))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::estimate::Estimate;
    use crate::numeric::dense::{Cholesky, product};
    use crate::{Function, Order};

    /// Share of the best constant that the power iteration must reach.
    const SHARE: f64 = 0.999;

    /// The nodal values of the function with the largest quotient found by a power iteration.
    fn ascend(norm: ErrorNorm, order: Order, mesh: &ElementMesh) -> Vec<f64> {
        let size = mesh.cells().len() + 1;
        let form = error_form(norm, mesh, mesh.elements().len() as f64).unwrap();
        let gram = super::super::forms::without_constants(
            &seminorm_form(mesh.cells(), UnitOrder::Inner(order)),
            mesh.cells(),
        );
        let factor = Cholesky::new(&gram).unwrap();
        let mut values = DMatrix::from_fn(size, 1, |i, _| (1.0 + (i * i) as f64).sin());
        let mut last = 0.0;
        for _ in 0..2000 {
            let image = product(&form, &values);
            let next = values.dot(&image) / values.dot(&product(&gram, &values));
            assert!(next > last * (1.0 - 1e-12), "the quotient rises");
            if next <= last * (1.0 + 1e-9) {
                break;
            }
            last = next;
            values = factor.solve(&image);
            values *= values.amax().recip();
        }
        (0..size).map(|i| values[(i, 0)]).collect()
    }

    /// Both error norms of a slope on (0, 1), by quadratic functions on the cells, divided by its seminorm.
    fn ratios(slope: &[f64], mesh: &ElementMesh, order: Order) -> [f64; 2] {
        let v = Function::linears(mesh.cells(), slope).unwrap();
        let seminorm = v.seminorm(order, 1e-8).unwrap().value;
        let mut squares = [0.0; 2];
        for range in mesh.elements() {
            let part = v.restrict(range.clone()).unwrap();
            let (norm, mean) =
                (part.norm(0.0, 1e-12).unwrap().value, part.mean(1e-12).unwrap().value);
            squares[1] += norm * norm - part.mesh().unwrap().total() * mean * mean;
            let root = Estimate::new(seminorm, 0.0, Default::default()).unwrap();
            let found = Largest { root, mesh: mesh.clone(), values: slope.to_vec() };
            let rule = crate::quadrature::Rule::gauss_legendre(3).unwrap();
            for i in range.clone() {
                let (x, h) = (mesh.cells().from_left()[i], mesh.cells().lengths()[i]);
                squares[0] += h * rule.integrate(|t| error(&found, x + h * t).unwrap().powi(2));
            }
        }
        squares.map(|square| square.sqrt() / seminorm)
    }

    #[test]
    fn power_iteration_reaches_the_constants_of_one_element_and_of_a_mesh() {
        for (nu, elements, cells) in [
            (0.01, 1, 48),
            (0.3, 1, 48),
            (0.5, 1, 48),
            (0.99, 1, 48),
            (0.1, 4, 8),
            (0.4, 16, 8),
            (0.5, 8, 8),
            (0.8, 4, 8),
        ] {
            let order = Order::new(nu).unwrap();
            let mesh = ElementMesh::refined(&Mesh::uniform(elements, 1.0).unwrap(), cells).unwrap();
            for (k, norm) in [ErrorNorm::L2, ErrorNorm::Derivative].into_iter().enumerate() {
                let found = ratios(&ascend(norm, order, &mesh), &mesh, order)[k];
                let best = if elements == 1 {
                    super::super::element::on_interval(
                        1.0,
                        norm,
                        UnitOrder::Inner(order),
                        Tolerance::balanced(),
                    )
                } else {
                    on_mesh(
                        Mesh::uniform(elements, 1.0).unwrap(),
                        norm,
                        UnitOrder::Inner(order),
                        Tolerance::new(0.05).unwrap(),
                    )
                };
                let share = found / best.unwrap().constant.value;
                assert!(
                    (SHARE..=1.0 + 1e-8).contains(&share),
                    "{norm:?} nu {nu} N {elements}: {share}"
                );
            }
        }
    }

    #[test]
    fn a_graded_mesh_has_its_constant_too() {
        let mesh = Mesh::graded(&[0.0, 3.0], 2, 0.5).unwrap();
        let s = UnitOrder::Inner(Order::HALF);
        let longest = mesh.lengths().iter().copied().fold(0.0, f64::max);
        for norm in [ErrorNorm::L2, ErrorNorm::Derivative, ErrorNorm::H1] {
            let found = on_mesh(mesh.clone(), norm, s, Tolerance::new(1e-2).unwrap()).unwrap();
            let element =
                super::super::element::on_interval(longest, norm, s, Tolerance::balanced())
                    .unwrap();
            // Never above that of the longest element, and not far below.
            let share = found.constant.value / element.constant.value;
            assert!(share < 1.0 && share > 0.6, "{norm:?}: {share}");
        }
    }
}
