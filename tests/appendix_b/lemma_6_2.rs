//! Lemma 6.2: the global interpolation estimate.

use crate::rough_slopes::{Numbers, primitive};
use fractional_sobolev::{
    Domain, ErrorNorm, Estimate, Function, Mesh, Order, Tolerance, interpolation_constant,
};

fn order(nu: f64) -> Order {
    Order::new(nu).unwrap()
}

fn best(norm: ErrorNorm, order: Order) -> f64 {
    let unit = Domain::Interval(1.0);
    interpolation_constant(unit, norm, order, Tolerance::balanced()).unwrap().constant.value
}

/// On equal elements of length h, in units of the power of h that belongs to the norm.
fn mesh_constant(
    norm: ErrorNorm,
    order: Order,
    (elements, h): (usize, f64),
    tolerance: f64,
) -> fractional_sobolev::Result<Estimate> {
    let mesh = Domain::Mesh(Mesh::uniform(elements, elements as f64 * h)?);
    let power = if norm == ErrorNorm::L2 { 1.0 + order.value() } else { order.value() };
    interpolation_constant(mesh, norm, order, tolerance)?.constant.times(h.powf(-power))
}

/// I^h u for elements made of so many cells each.
fn interpolant(cells: &Mesh, u: &Function<'_>, elements: &[usize]) -> Function<'static> {
    let (mut values, mut first) = (Vec::new(), 0);
    for &count in elements {
        let (x, last) = (cells.from_left(), first + count - 1);
        let ends = [u.value_on(first, 0.0).unwrap(), u.value_on(last, 1.0).unwrap()];
        let length = x[last] - x[first] + cells.lengths()[last];
        for k in first..=last {
            values.extend([0.0, 0.5, 1.0].map(|t| {
                let s = (x[k] - x[first] + t * cells.lengths()[k]) / length;
                ends[0] + s * (ends[1] - ends[0])
            }));
        }
        first += count;
    }
    Function::piecewise(cells, 2, &values).unwrap()
}

#[test]
fn no_rough_function_exceeds_the_constants_of_one_element() {
    let mut numbers = Numbers(62);
    for nu in [0.1, 0.5, 0.9] {
        let nu = order(nu);
        let best = [ErrorNorm::L2, ErrorNorm::Derivative].map(|norm| best(norm, nu));
        for kind in 0..if nu.offset() < 0.0 { 3 } else { 2 } {
            for index in 0..40 {
                let (cells, slope) = if kind == 1 { numbers.waves(nu) } else { numbers.rough(nu) };
                let u = primitive(&cells, &slope, kind == 2);
                // elements of 1, 2, 3, ... cells, the rest in one: lengths over many decades
                let (mut elements, mut left) = (Vec::new(), cells.len());
                while left > 0 {
                    elements.push((elements.len() + 1).min(left));
                    left -= elements[elements.len() - 1];
                }
                let (mut h, mut first) = (0.0f64, 0);
                for count in &elements {
                    h = h.max(cells.lengths()[first..first + count].iter().sum());
                    first += count;
                }
                let line = interpolant(&cells, &u, &elements);
                let error = u.minus(&line).unwrap();
                let slope = match kind {
                    2 => Function::piecewise(&cells, 0, &slope[..cells.len()]),
                    _ => Function::linears(&cells, &slope),
                };
                let seminorm = slope.unwrap().seminorm(nu, 1e-8).unwrap();
                let sizes = [error.norm(0.0, 1e-8), error.derivative().unwrap().norm(0.0, 1e-8)];
                for ((size, best), power) in
                    sizes.into_iter().zip(best).zip([1.0 + nu.value(), nu.value()])
                {
                    let found = size.unwrap().value / (seminorm.value * h.powf(power));
                    assert!(
                        found <= best * (1.0 + 1e-7),
                        "{kind} {index} nu {nu}: {found} above {best}"
                    );
                }
            }
        }
    }
}

#[test]
fn one_element_is_the_local_lemma() {
    for nu in [0.2, 0.5, 0.8] {
        for norm in [ErrorNorm::L2, ErrorNorm::Derivative, ErrorNorm::H1] {
            let (mesh, element) =
                (mesh_constant(norm, order(nu), (1, 1.0), 1e-3).unwrap(), best(norm, order(nu)));
            assert!(
                mesh.value <= element && element <= mesh.value + mesh.error,
                "{norm:?} {nu}: {mesh} {element}"
            );
        }
    }
}

#[test]
fn the_second_line_fails_on_meshes_of_long_elements_and_holds_up_to_length_one() {
    for nu in [0.1, 0.5, 0.9] {
        let nu = order(nu);
        let long = 2.0 / best(ErrorNorm::L2, nu);
        for elements in [1, 4, 16] {
            let full = |h: f64| mesh_constant(ErrorNorm::H1, nu, (elements, h), 0.02).unwrap();
            // A lower bound above the printed constant: a function breaks the line.
            assert!(full(long).value > 1.0, "{nu:?} {elements}: {}", full(long));
            let short = full(1.0);
            assert!(short.value + short.error <= 1.0, "{nu:?} {elements}: {short}");
        }
        assert!(best(ErrorNorm::H1, nu) <= 1.0);
    }
}
