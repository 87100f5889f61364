//! Interpolation, projection and embedding constants where arithmetic is hardest: digits or an error, never
//! NaN.

use experiments::interpolation::{
    ElementMesh, InterpolationError, SampleSlope, longest_element, power_slope, sample_projection_error,
};
use fractional_sobolev::{
    Domain, Error, ErrorNorm, Estimate, Function, Mesh, Order, Result, Tolerance, embedding_bound,
    embedding_constant, interpolation_constant, projection_constant,
};

const ORDERS: [f64; 5] = [1e-6, 1e-3, 0.5, 1.0 - 1e-3, 1.0 - 1e-6];

fn order(nu: f64) -> Order {
    Order::new(nu).unwrap()
}

fn element_constant(norm: ErrorNorm, nu: f64, tolerance: Tolerance) -> Result<Estimate> {
    interpolation_constant(Domain::Interval(1.0), norm, nu, tolerance).map(|found| found.constant)
}

fn projected(norm: ErrorNorm, r: f64) -> f64 {
    projection_constant(Domain::Interval(1.0), norm, r, Tolerance::balanced()).unwrap().constant.value
}

#[test]
fn constants_at_orders_near_zero_and_one_join_their_neighbours() {
    for nu in ORDERS {
        let element = element_constant(ErrorNorm::L2, nu, Tolerance::reference()).unwrap();
        assert!(element.relative_error() <= 1e-12, "{nu}: {element}");
        let dual = projected(ErrorNorm::Dual, nu);
        let chain = projected(ErrorNorm::L2, nu) * projected(ErrorNorm::L2, 0.5);
        assert!(dual <= chain * (1.0 + 1e-8) && dual >= 0.99 * chain, "{nu}: {dual} {chain}");
        let longest = longest_element(order(nu), Tolerance::fast()).unwrap();
        assert!(longest.value > 5.0, "{nu}: {longest}");
        for elements in [1, 3] {
            let mesh = Domain::Mesh(Mesh::uniform(elements, elements as f64).unwrap());
            let mesh = interpolation_constant(mesh, ErrorNorm::Derivative, nu, 0.1).unwrap().constant;
            let one = element_constant(ErrorNorm::Derivative, nu, Tolerance::balanced()).unwrap();
            assert!(
                mesh.value > 0.5 * one.value && mesh.value <= one.value * (1.0 + 1e-9),
                "{nu}: {mesh} {one}"
            );
        }
    }
}

/// Lengths of the interval and sizes of the values, up to the ends of binary64.
const SIZES: [(f64, f64); 15] = [
    (1e-100, 1.0),
    (1e100, 1.0),
    (1.0, 1e-100),
    (1.0, 1e100),
    (1e-60, 1e60),
    (1e-150, 1.0),
    (1e150, 1.0),
    (1e-300, 1.0),
    (1e300, 1.0),
    (1.0, 1e-160),
    (1.0, 1e160),
    (1.0, 1e-300),
    (1.0, 1e300),
    (1e-300, 1e-300),
    (1e300, 1e300),
];

#[test]
fn tiny_and_huge_elements_and_values_keep_their_ratios() {
    for nu in [1e-6, 0.3, 0.5, 1.0 - 1e-6] {
        let ratios = |length: f64, height: f64| {
            let lengths = [0.25, 0.5, 0.25].map(|l| l * length).to_vec();
            let values = [0.0, 1.0, -1.0, 0.5].map(|v| v * height);
            let slope = Function::linears(&Mesh::from_lengths(lengths).unwrap(), &values).unwrap();
            let element = InterpolationError::of_slope(&slope, order(nu), Tolerance::balanced()).unwrap();
            let mesh = ElementMesh::new(slope.mesh().unwrap().clone(), &[2, 1]).unwrap();
            let elements =
                InterpolationError::on_elements(&slope, &mesh, order(nu), Tolerance::balanced()).unwrap();
            let projected = mesh.projection(&slope).unwrap();
            let mean = projected.value(0, 0.5).unwrap() / height;
            [element, elements]
                .iter()
                .flat_map(|error| [error.l2_ratio().unwrap().value, error.derivative_ratio().unwrap().value])
                .chain([mean])
                .collect::<Vec<f64>>()
        };
        let unit = ratios(1.0, 1.0);
        for (length, height) in SIZES {
            for (found, unit) in ratios(length, height).iter().zip(&unit) {
                assert!(
                    (found / unit - 1.0).abs() < 1e-11,
                    "nu {nu} h {length} height {height}: {found} {unit}"
                );
            }
        }
    }
}

#[test]
fn norms_beyond_binary64_are_errors_or_zero_within_their_error() {
    let slope = |length: f64, height: f64| {
        let cells = Mesh::uniform(2, length).unwrap();
        Function::linears(&cells, &[0.0, height, 0.0]).unwrap()
    };
    let error = |length, height| {
        InterpolationError::of_slope(&slope(length, height), order(1e-6), Tolerance::fast()).unwrap()
    };
    for (length, height) in [(1e-300, 1e-300), (1.0, 1e-160), (1e-150, 1.0)] {
        let found = error(length, height);
        assert!((found.l2_ratio().unwrap().value - error(1.0, 1.0).l2_ratio().unwrap().value).abs() < 1e-12);
        for norm in [found.l2(), found.derivative(), found.seminorm()].map(Result::unwrap) {
            assert!(norm.value > 0.0 || norm.error > 0.0, "{norm}");
        }
    }
    assert!(matches!(error(1e300, 1e300).l2(), Err(Error::NotFinite { .. })));
}

#[test]
fn cells_of_extreme_length_in_one_element_are_answered() {
    // cells of length 1e-300 in an element of length 1
    let cells = Mesh::geometric(600, 0.316, 1.0).unwrap();
    let values: Vec<f64> = cells.nodes().iter().map(|x| x.powf(0.1)).collect();
    let slope = Function::linears(&cells, &values).unwrap();
    let error = InterpolationError::of_slope(&slope, order(0.3), Tolerance::balanced()).unwrap();
    let closed = power_slope(0.1, order(0.3)).unwrap();
    assert!((error.derivative().unwrap().value / closed.derivative().unwrap().value - 1.0).abs() < 0.05);
    assert!((error.seminorm().unwrap().value / closed.seminorm().unwrap().value - 1.0).abs() < 0.05);
}

#[test]
fn a_million_elements_are_projected() {
    let mesh = Mesh::uniform(1_000_000, 1.0).unwrap();
    for phi in [
        SampleSlope::Power(-0.499),
        SampleSlope::Power(1e3),
        SampleSlope::Cosine(64),
        SampleSlope::Step(1e-9),
    ] {
        let error = sample_projection_error(phi, &mesh).unwrap();
        assert!(error.value > 0.0 && error.relative_error() < 1e-12, "{phi}: {error}");
    }
    assert_eq!(sample_projection_error(SampleSlope::Constant, &mesh).unwrap().value, 0.0);
}

#[test]
fn zero_over_zero_is_an_error() {
    for nu in ORDERS {
        let constant = Function::linears(&Mesh::uniform(4, 1.0).unwrap(), &[3.0; 5]).unwrap();
        let error = InterpolationError::of_slope(&constant, order(nu), Tolerance::fast()).unwrap();
        for ratio in [error.l2_ratio(), error.derivative_ratio(), error.h1_ratio()] {
            assert!(matches!(ratio, Err(Error::OutOfRange { value: 0.0, .. })), "{nu}: {ratio:?}");
        }
    }
}

#[test]
fn embeddings_hold_at_the_ends_of_their_orders() {
    for nu in [1e-6, 0.49999] {
        assert_eq!(embedding_bound(nu, 2.0).unwrap(), 1.0, "{nu}");
    }
    assert!(embedding_constant(1e-6, 2.5, 1e-8).is_err());
    assert!((embedding_constant(1e-6, 2.0, 1e-8).unwrap().lower.value - 1.0).abs() < 1e-10);
}
