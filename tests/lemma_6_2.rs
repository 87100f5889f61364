//! Lemma 6.2: the global interpolation estimate.

#[allow(dead_code)]
#[path = "../examples/lemma_6_2_global_estimate.rs"]
mod example;

use experiments::interpolation::{
    ElementMesh, InterpolationError, RoughFamily, RoughSlopes, SampleSlope, longest_element,
};
use fractional_sobolev::{
    Domain, Error, ErrorNorm, Estimate, Mesh, Order, Tolerance, interpolation_constant,
};

/// Second order in the cells: 8 per element leave below (π/8)²/12 = 1.3 %.
const CELL_TOLERANCE: f64 = 0.015;

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

#[test]
fn no_rough_function_exceeds_the_constants_of_one_element() {
    for nu in [0.1, 0.5, 0.9] {
        let nu = order(nu);
        let (l2, derivative) = (best(ErrorNorm::L2, nu), best(ErrorNorm::Derivative, nu));
        for family in RoughFamily::admissible(nu) {
            let mut slopes = RoughSlopes::new(family, nu, 62);
            for index in 0..40 {
                let slope = slopes.draw().unwrap();
                let cells = slope.mesh().unwrap().len();
                // elements of 1, 2, 3, ... cells, the rest in one: lengths over many decades
                let mut groups = Vec::new();
                let mut left = cells;
                while left > 0 {
                    let next = (groups.len() + 1).min(left);
                    groups.push(next);
                    left -= next;
                }
                let mesh = ElementMesh::new(slope.mesh().unwrap().clone(), &groups).unwrap();
                let error =
                    InterpolationError::on_elements(&slope, &mesh, nu, Tolerance::balanced()).unwrap();
                let (a, b) = (error.l2_ratio().unwrap(), error.derivative_ratio().unwrap());
                assert!(a.value <= l2 + a.error, "{family:?} {index} nu {nu}: {a} above {l2}");
                assert!(
                    b.value <= derivative + b.error,
                    "{family:?} {index} nu {nu}: {b} above {derivative}"
                );
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
fn constants_on_a_mesh_lie_below_that_of_an_element_and_stay_bounded_below() {
    for nu in [0.2, 0.5, 0.8] {
        for norm in [ErrorNorm::L2, ErrorNorm::Derivative] {
            let element = best(norm, order(nu));
            let mut last = element;
            for elements in [2, 4, 8, 16] {
                let mesh = mesh_constant(norm, order(nu), (elements, 1.0), 0.01).unwrap().value;
                assert!(
                    mesh < last * (1.0 + CELL_TOLERANCE),
                    "{norm:?} nu {nu} N {elements}: {mesh} after {last}"
                );
                assert!(mesh > 0.6 * element, "{norm:?} nu {nu} N {elements}: {mesh} of {element}");
                last = mesh;
            }
        }
    }
}

#[test]
fn samples_and_cells_agree() {
    // x is both a power and a piecewise linear; cos(kπx) against its interpolant on fine cells.
    let mesh = ElementMesh::uniform(5, 4).unwrap();
    let elements = Mesh::uniform(5, 1.0).unwrap();
    let nodes = mesh.cells().nodes();
    let slope = fractional_sobolev::Function::linears(mesh.cells(), &nodes).unwrap();
    let cells = InterpolationError::on_elements(&slope, &mesh, order(0.3), Tolerance::balanced()).unwrap();
    let closed = InterpolationError::of_sample(SampleSlope::Power(1.0), &elements, order(0.3)).unwrap();
    for (a, b) in [
        (cells.l2(), closed.l2()),
        (cells.derivative(), closed.derivative()),
        (cells.seminorm(), closed.seminorm()),
    ] {
        let (a, b) = (a.unwrap(), b.unwrap());
        assert!((a.value / b.value - 1.0).abs() < 1e-12, "{a} {b}");
    }
    let cells = fractional_sobolev::Function::interpolate(mesh.cells(), 8, |x| {
        (3.0 * std::f64::consts::PI * x).cos()
    })
    .unwrap();
    let cells = InterpolationError::on_elements(&cells, &mesh, order(0.7), Tolerance::balanced()).unwrap();
    let closed = InterpolationError::of_sample(SampleSlope::Cosine(3), &elements, order(0.7)).unwrap();
    for (a, b) in [
        (cells.l2(), closed.l2()),
        (cells.derivative(), closed.derivative()),
        (cells.seminorm(), closed.seminorm()),
    ] {
        let (a, b) = (a.unwrap(), b.unwrap());
        assert!((a.value / b.value - 1.0).abs() < 1e-7, "{a} {b}");
    }
}

#[test]
fn a_million_elements_and_a_constant_slope_are_answered() {
    let mesh = Mesh::uniform(1_000_000, 1.0).unwrap();
    // Smooth: ‖u − I u‖ = h² ‖u''‖/√120, ‖(u − I u)'‖ = h ‖u''‖/√12, u'' = −π sin(πx).
    let error = InterpolationError::of_sample(SampleSlope::Cosine(1), &mesh, order(0.5)).unwrap();
    let second = std::f64::consts::PI / 2f64.sqrt();
    let (l2, derivative) = (error.l2().unwrap(), error.derivative().unwrap());
    assert!((l2.value / (1e-12 * second / 120f64.sqrt()) - 1.0).abs() < 1e-9, "{l2}");
    assert!((derivative.value / (1e-6 * second / 12f64.sqrt()) - 1.0).abs() < 1e-9, "{derivative}");
    let affine = InterpolationError::of_sample(SampleSlope::Constant, &mesh, order(0.5)).unwrap();
    assert_eq!(affine.l2().unwrap().value, 0.0);
    assert!(matches!(affine.l2_ratio(), Err(Error::OutOfRange { value: 0.0, .. })));
    let step = InterpolationError::of_sample(SampleSlope::Step(0.3), &mesh, order(0.5));
    assert!(matches!(step, Err(Error::InfiniteNorm { .. })));
    let longer = Mesh::uniform(10, 2.0).unwrap();
    assert!(InterpolationError::of_sample(SampleSlope::Cosine(1), &longer, order(0.5)).is_err());
}

#[test]
fn the_example_confirms_the_lemma() {
    let options = example::Options { elements: vec![1, 4, 64], ..example::Options::default() };
    let headline = example::run(&options).unwrap();
    let verdict = headline.verdict();
    assert!(verdict.is_confirmed(), "{verdict}");
    assert!(matches!(verdict, example_frame::Verdict::PrintedFormFails(_)), "{verdict}");
    let constant = example::Options { function: SampleSlope::Constant, ..options };
    assert!(example::run(&constant).is_err());
}

#[test]
fn the_second_line_fails_on_meshes_of_long_elements_and_holds_up_to_length_one() {
    for nu in [0.1, 0.5, 0.9] {
        let nu = order(nu);
        let longest = longest_element(nu, Tolerance::balanced()).unwrap().value;
        for elements in [1, 4, 16] {
            let full = |h: f64| mesh_constant(ErrorNorm::H1, nu, (elements, h), 0.02).unwrap();
            // A lower bound above the printed constant: a function breaks the line.
            assert!(full(2.0 * longest).value > 1.0, "{nu:?} {elements}: {}", full(2.0 * longest));
            let short = full(1.0);
            assert!(short.value + short.error <= 1.0, "{nu:?} {elements}: {short}");
        }
        assert!(best(ErrorNorm::H1, nu) <= 1.0);
    }
}

#[test]
fn spoiled_ratios_turn_the_verdict() {
    let options = example::Options { elements: vec![1, 4], ..example::Options::default() };
    let rows = || example::compute(&options).unwrap();
    let verdict = |rows: &[example::Row]| example_frame::Verdict::of(&example::findings(&options, rows));
    assert!(verdict(&rows()).is_confirmed());
    // The full norm of u above the constant of an element of length 1, and that constant above 1.
    let mut function = rows();
    function[0].function[2].value = 1.01 * function[0].element[2].value;
    assert!(!verdict(&function).is_confirmed());
    let mut element = rows();
    element[0].element[2].value = 1.01;
    assert!(!verdict(&element).is_confirmed());
    // Long elements on which nothing fails: the printed form would stand.
    let mut long = rows();
    long.iter_mut().for_each(|row| row.mesh.as_mut().unwrap()[2].value = 0.5);
    assert!(!matches!(verdict(&long), example_frame::Verdict::PrintedFormFails(_)));
}

#[test]
fn constants_on_a_mesh_meet_the_tolerance_or_say_what_was_reached() {
    for norm in [ErrorNorm::L2, ErrorNorm::Derivative] {
        let constant = |tolerance: f64| mesh_constant(norm, order(0.5), (2, 1.0), tolerance);
        let (rough, fine) = (constant(0.05).unwrap(), constant(1e-3).unwrap());
        assert!(rough.relative_error() <= 0.05 && fine.relative_error() <= 1e-3, "{rough} {fine}");
        assert!((rough.value..=rough.value + rough.error).contains(&fine.value), "{norm:?}: {rough} {fine}");
    }
    assert!(mesh_constant(ErrorNorm::L2, order(0.5), (0, 1.0), 0.1).is_err());
    assert!(mesh_constant(ErrorNorm::L2, order(0.5), (2000, 1.0), 0.1).is_err());
}
