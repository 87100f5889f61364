//! u - I_h u on graded meshes against its orders and limits, and norms on polygons against closed forms.

#[allow(dead_code)]
#[path = "../examples/section_1_field_errors.rs"]
mod errors;

#[allow(dead_code)]
#[path = "../examples/section_1_polygon_norms.rs"]
mod polygons;

use example_frame::{Finding, Outcome};
use fractional_sobolev::{Estimate, Order, Tolerance, closed_forms};
use std::f64::consts::PI;

fn outcome(findings: &[Finding], key: &str) -> Outcome {
    findings.iter().find(|finding| finding.key() == key).unwrap().outcome()
}

fn smaller(alpha: f64, nu: f64, grading: &[f64]) -> errors::Options {
    let nu = Order::new(nu).unwrap();
    let (grading, elements) = (grading.to_vec(), vec![300, 10_000, 20_000]);
    let tolerance = Tolerance::new(1e-5).unwrap();
    errors::Options { alpha, nu, grading, elements, tolerance, ..errors::Options::default() }
}

#[test]
fn orders_and_limits_are_those_of_graded_meshes() {
    for (alpha, nu, grading) in
        [(0.75, 0.5, [1.0, 3.0, 4.0]), (0.4, 0.4, [1.5, 4.5, 6.0]), (1.6, 0.7, [1.0, 1.4, 3.0])]
    {
        let options = smaller(alpha, nu, &grading);
        let findings = errors::findings(&options, &errors::compute(&options).unwrap());
        for key in ["orders", "constant", "best", "estimates"] {
            assert_eq!(outcome(&findings, key), Outcome::Holds, "{alpha} {nu}: {findings:?}");
        }
    }
}

#[test]
fn the_limit_in_the_order_one_is_that_of_derivatives() {
    // (1-nu)|u - I_h u|_nu^2 tends to ||(u - I_h u)'||^2, which is h^3 |u''|^2/12 on an element, as nu tends to 1.
    let gap = 1e-7;
    let options = smaller(0.8, 1.0 - gap, &[20.0]);
    let found = gap * errors::limit(&options, 20.0).unwrap().powi(2);
    let exact = 0.16 * 0.16 / 12.0 * 20f64.powi(2) / (2.0 * 0.3 - 0.1);
    assert!((found / exact - 1.0).abs() < 1e-4, "{found} {exact}");
}

#[test]
fn wrong_errors_are_seen() {
    let options = smaller(0.75, 0.5, &[1.0, 2.6, 4.0]);
    let right = errors::compute(&options).unwrap();
    // The errors of one grading with a factor for every mesh; an estimate that is too large.
    let planted = |series: usize, factor: f64, error: f64| {
        let mut rows = right.clone();
        for (k, row) in rows[3 * series..3 * series + 3].iter_mut().enumerate() {
            let value = factor.powi(k as i32) * row.2.value;
            row.2 = Estimate::new(value, error * value, row.2.work).unwrap();
        }
        errors::findings(&options, &rows)
    };
    assert_eq!(outcome(&planted(0, 1.1, 1e-8), "orders"), Outcome::Refuted);
    assert_ne!(outcome(&planted(2, 1.03, 1e-8), "constant"), Outcome::Holds);
    assert_eq!(outcome(&planted(1, 1.5, 1e-8), "best"), Outcome::Refuted);
    assert_eq!(outcome(&planted(0, 1.0, 1e-3), "estimates"), Outcome::Refuted);
}

#[test]
fn squares_corners_and_circles_have_their_closed_forms() {
    let options = polygons::Options::default();
    let right = polygons::compute(&options).unwrap();
    let keys = ["coordinate", "corner", "duality", "circle"];
    for key in keys {
        assert_eq!(outcome(&polygons::findings(&options, &right), key), Outcome::Holds, "{key}");
    }
    let mut wrong = right.clone();
    let last = options.n.len() - 1;
    wrong.0[0].2[0].value *= 1.001;
    wrong.0[last].2[1].value *= 1.01;
    wrong.0[0].2[3].value = 1.01;
    wrong.1[0].last_mut().unwrap().1.value *= 1.01;
    for key in keys {
        assert_eq!(outcome(&polygons::findings(&options, &wrong), key), Outcome::Refuted, "{key}");
    }
}

#[test]
fn other_orders_have_the_circle_and_duality_alone() {
    for nu in [0.2, 0.8] {
        let nu = Order::new(nu).unwrap();
        let options = polygons::Options { nu, n: vec![4, 8], ..polygons::Options::default() };
        let findings = polygons::findings(&options, &polygons::compute(&options).unwrap());
        let outcomes = ["coordinate", "corner", "duality", "circle"].map(|key| outcome(&findings, key));
        use Outcome::{Holds, Undecided};
        assert_eq!(outcomes, [Undecided, Undecided, Holds, Holds]);
    }
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
