//! u - I_h u on graded meshes against its orders and limits, and norms on polygons against closed forms.

#[allow(dead_code)]
#[path = "../../examples/section_1_field_errors.rs"]
mod errors;

#[allow(dead_code)]
#[path = "../../examples/section_1_polygon_norms.rs"]
mod polygons;

use example_report::Verdict;
use fractional_sobolev::{Order, closed_forms};
use std::f64::consts::PI;

#[test]
fn orders_and_limits_are_those_of_graded_meshes() {
    for (alpha, nu, beta) in
        [(0.75, 0.5, [1.0, 3.0, 4.0]), (0.4, 0.4, [1.5, 4.5, 6.0]), (1.6, 0.7, [1.0, 1.4, 3.0])]
    {
        let nu = Order::new(nu).unwrap();
        let options =
            errors::Options { alpha, nu, beta: beta.to_vec(), elements: vec![300, 10_000, 20_000] };
        let found = errors::outcome(&options).unwrap();
        assert_eq!(found.status(), Verdict::True, "{alpha} {nu}: {}", found.text(false));
    }
}

#[test]
fn the_limit_in_the_order_one_is_that_of_derivatives() {
    // (1−ν)|u − I_h u|²_ν tends to ‖(u − I_h u)'‖², which is h³ |u''|²/12 on an element, as ν tends to 1.
    let gap = 1e-7;
    let found = gap * errors::limit(0.8, 1.0 - gap, 20.0).powi(2);
    let exact = 0.16 * 0.16 / 12.0 * 20f64.powi(2) / (2.0 * 0.3 - 0.1);
    assert!((found / exact - 1.0).abs() < 1e-4, "{found} {exact}");
}

#[test]
fn cosines_on_the_circle_agree_with_quadrature() {
    // 2 pi int (1 - cos k t) (2 sin t/2)^(-1-2nu), with t = pi v^m, m large enough for a smooth integrand.
    for (k, nu) in [(1, 0.1), (1, 0.5), (2, 0.3), (5, 0.7), (3, 0.9)] {
        let (m, steps) = (20.0, 20_000);
        let value = |j: usize| {
            let v = (j as f64 + 0.5) / f64::from(steps as u32);
            let t = PI * v.powf(m);
            let kernel = (2.0 * (0.5 * t).sin()).powf(-1.0 - 2.0 * nu);
            let difference = 2.0 * (0.5 * f64::from(k) * t).sin().powi(2);
            difference * kernel * PI * m * v.powf(m - 1.0) / f64::from(steps as u32)
        };
        let exact = 4.0 * PI * (0..steps).map(value).sum::<f64>();
        let found = closed_forms::cosine_on_circle_seminorm_squared(k, nu).unwrap();
        assert!((found.value / exact - 1.0).abs() < 1e-4, "{k} {nu}: {found} {exact}");
    }
    assert_eq!(closed_forms::cosine_on_circle_seminorm_squared(0, 0.5).unwrap().value, 0.0);
}
