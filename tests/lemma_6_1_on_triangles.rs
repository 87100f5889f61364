//! Lemma 6.1 on triangles: invariances, a second road to the seminorm, both bounds, and planted faults.

#[allow(dead_code)]
#[path = "../examples/lemma_6_1_on_triangles.rs"]
mod example;

use example_frame::Outcome;
use fractional_sobolev::{
    Function, Order, Tolerance, Triangles,
    interpolation::{TriangleConstants, TriangleShape, kobayashi},
};

fn order(s: f64) -> Order {
    Order::new(s).unwrap()
}

#[test]
fn twelve_orders_have_six_digits() {
    let headline = example::run(&example::Options::default()).unwrap();
    assert!(headline.verdict().is_confirmed(), "{headline}");
}

/// For each numbering other integrals belong to a corner: rules, powers and pairs of corners.
#[test]
fn neither_the_numbering_of_the_corners_nor_the_place_matters() {
    let corners = [[0.0, 0.0], [1.0, 0.1], [0.3, 0.7]];
    let (c, s) = (0.3f64.cos(), 0.3f64.sin());
    let moved = corners.map(|[x, y]| [5.0 + 3.0 * (c * x - s * y), -2.0 + 3.0 * (s * x + c * y)]);
    for nu in [0.3, 0.8] {
        let of =
            |corners| TriangleConstants::new(&TriangleShape::new(corners).unwrap(), order(nu), 10).unwrap();
        let first = of(corners);
        for other in [[1, 2, 0], [2, 1, 0]].map(|turn| of(turn.map(|k: usize| corners[k]))) {
            for (a, b) in [(&first.derivative, &other.derivative), (&first.l2, &other.l2)] {
                assert!((a.lower / b.lower - 1.0).abs() < 3e-8, "{nu}: {} {}", a.lower, b.lower);
            }
        }
        let larger = of(moved);
        assert!((larger.derivative.lower / first.derivative.lower / 3f64.powf(nu) - 1.0).abs() < 1e-9);
        assert!((larger.l2.lower / first.l2.lower / 3f64.powf(1.0 + nu) - 1.0).abs() < 1e-9);
    }
}

/// For u = x²/2, by the seminorm of x on one triangle: a quotient that the constants pass, by little.
#[test]
fn a_parabola_stays_below_both_constants() {
    let corners = vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
    let triangle = Triangles::new(corners, vec![[0, 1, 2]]).unwrap();
    let x = Function::on_triangles(&triangle, 1, &[0.0, 1.0, 0.0]).unwrap();
    let shape = TriangleShape::right_isosceles().unwrap();
    // u − Iu = x(x − 1)/2: ‖x − 1/2‖² = 1/24, ‖x(x−1)/2‖² = 1/4 ∫ x²(1−x)³ = 1/240.
    for s in [0.25, 0.6, 0.9] {
        let norm = x.seminorm(order(s), Tolerance::reference()).unwrap().value;
        let found = TriangleConstants::new(&shape, order(s), 10).unwrap();
        let quotients = [(1f64 / 24.0).sqrt() / norm, (1f64 / 240.0).sqrt() / norm];
        for (quotient, constant) in quotients.into_iter().zip([found.derivative, found.l2]) {
            assert!(quotient < constant.lower && constant.lower < 2.5 * quotient, "{s} {quotient}");
            assert!(constant.upper > Some(constant.value.value));
        }
    }
}

#[test]
fn the_limit_at_one_and_known_bounds() {
    let shape = TriangleShape::right_isosceles().unwrap();
    assert!((kobayashi(&shape) - 0.491_596_0).abs() < 1e-7);
    let one = TriangleConstants::at_one(&shape, 12).unwrap();
    let unit = |s: f64| (std::f64::consts::FRAC_PI_2 / (1.0 - s)).sqrt();
    let near = TriangleConstants::new(&shape, order(0.99), 10).unwrap();
    let ratio = unit(0.99) * near.derivative.value.value / one.derivative.value.value;
    assert!((ratio - 1.0).abs() < 0.02, "{ratio}");
    // Estimates of lower degrees hold the value of a higher one.
    for s in [0.2, 0.5, 0.7] {
        let fine = TriangleConstants::new(&shape, order(s), 16).unwrap();
        let coarse = TriangleConstants::new(&shape, order(s), 10).unwrap();
        for (a, b) in [(&coarse.derivative, &fine.derivative), (&coarse.l2, &fine.l2)] {
            assert!((a.value.value - b.value.value).abs() <= a.value.error + b.value.error, "{s}");
        }
    }
}

#[test]
fn bad_triangles_and_degrees_are_errors() {
    assert!(TriangleShape::new([[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]]).is_err());
    assert!(TriangleShape::new([[0.0, f64::NAN], [1.0, 0.0], [0.0, 1.0]]).is_err());
    let shape = TriangleShape::right_isosceles().unwrap();
    assert!(TriangleConstants::new(&shape, order(0.5), 2).is_err());
    assert!(TriangleConstants::new(&shape, order(0.001), 10).is_err());
    assert!(TriangleConstants::at_one(&shape, 200).is_err());
}

#[test]
fn a_wrong_constant_is_seen() {
    let options = example::Options { s: vec![order(0.5), order(0.7)], ..example::Options::default() };
    let outcome = |rows: &[example::Row], key: &str| {
        let found = example::findings(rows);
        found.iter().find(|finding| finding.key() == key).unwrap().outcome()
    };
    let sound = example::compute(&options).unwrap();
    for key in ["digits", "lower", "upper", "monotone", "kobayashi", "babuska.aziz"] {
        assert_eq!(outcome(&sound, key), Outcome::Holds, "{key}");
    }
    let spoiled = |key: &str, spoil: fn(&mut Vec<example::Row>)| {
        let mut rows = sound.clone();
        spoil(&mut rows);
        assert_eq!(outcome(&rows, key), Outcome::Refuted, "{key}");
    };
    spoiled("digits", |rows| rows[0].constants.l2.value.error = 1e-5);
    spoiled("lower", |rows| rows[0].constants.l2.lower *= 1.001);
    spoiled("upper", |rows| rows[0].constants.derivative.upper = Some(0.01));
    spoiled("monotone", |rows| rows.swap(0, 1));
    spoiled("kobayashi", |rows| rows[2].constants.derivative.value.value *= 1.007);
    spoiled("babuska.aziz", |rows| rows[2].constants.derivative.value.value *= 1.01);
}
