//! Interpolation, projection and embedding constants where arithmetic is hardest: digits or an error, never
//! NaN.

use fractional_sobolev::{
    Domain, ErrorNorm, Estimate, Mesh, Result, Tolerance, embedding_bound, embedding_constant,
    interpolation_constant, projection_constant,
};

const ORDERS: [f64; 5] = [1e-6, 1e-3, 0.5, 1.0 - 1e-3, 1.0 - 1e-6];

fn element_constant(norm: ErrorNorm, nu: f64, tolerance: Tolerance) -> Result<Estimate> {
    interpolation_constant(Domain::Interval(1.0), norm, nu, tolerance).map(|found| found.constant)
}

fn projected(norm: ErrorNorm, r: f64) -> f64 {
    projection_constant(Domain::Interval(1.0), norm, r, Tolerance::balanced())
        .unwrap()
        .constant
        .value
}

#[test]
fn constants_at_orders_near_zero_and_one_join_their_neighbours() {
    for nu in ORDERS {
        let element = element_constant(ErrorNorm::L2, nu, Tolerance::reference()).unwrap();
        assert!(element.relative_error() <= 1e-12, "{nu}: {element}");
        let dual = projected(ErrorNorm::Dual, nu);
        let chain = projected(ErrorNorm::L2, nu) * projected(ErrorNorm::L2, 0.5);
        assert!(dual <= chain * (1.0 + 1e-8) && dual >= 0.99 * chain, "{nu}: {dual} {chain}");
        for elements in [1, 3] {
            let mesh = Domain::Mesh(Mesh::uniform(elements, elements as f64).unwrap());
            let mesh =
                interpolation_constant(mesh, ErrorNorm::Derivative, nu, 0.1).unwrap().constant;
            let one = element_constant(ErrorNorm::Derivative, nu, Tolerance::balanced()).unwrap();
            assert!(
                mesh.value > 0.5 * one.value && mesh.value <= one.value * (1.0 + 1e-9),
                "{nu}: {mesh} {one}"
            );
        }
    }
}

#[test]
fn embeddings_hold_at_the_ends_of_their_orders() {
    for nu in [1e-6, 0.49999] {
        assert_eq!(embedding_bound(nu, 2.0).unwrap().constant.value, 1.0, "{nu}");
    }
    assert!(embedding_constant(1e-6, 2.5, 1e-8).is_err());
    assert!((embedding_constant(1e-6, 2.0, 1e-8).unwrap().lower.value - 1.0).abs() < 1e-10);
}
