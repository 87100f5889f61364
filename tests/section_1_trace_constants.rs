//! Section 1, traces: the constant of the half-plane by two roads, corners against a second computation, the
//! square below both, and planted faults.

#[allow(dead_code)]
#[path = "../examples/section_1_trace_constants.rs"]
mod example;

use example_frame::{Outcome, Verdict};
use experiments::square_trace::SquareTrace;
use fractional_sobolev::{Domain, trace_constant, trace_quotient};

/// C(s) with sixteen digits, by mpmath.
const CONSTANTS: [(f64, f64); 9] = [
    (0.55, 5.929_779_816_345_083),
    (0.6, 3.134_988_014_844_525),
    (0.65, 2.173_290_233_518_294),
    (0.7, 1.665_406_971_828_838),
    (0.75, 1.334_219_941_403_939),
    (0.8, 1.085_535_412_270_676),
    (0.85, 0.876_012_715_453_208_7),
    (0.9, 0.678_145_463_717_646_2),
    (0.95, 0.460_659_843_852_703_9),
];

/// (s, angle in degrees, tau, quotient over C(s)^2): polynomials on meshes graded to the edge, without the
/// singular function, the kernel summed at every pair.
const CORNERS: [(f64, f64, f64, f64); 15] = [
    (0.6, 90.0, 0.0, 0.62072679),
    (0.6, 90.0, 1.0, 0.59170668),
    (0.6, 90.0, 4.0, 0.66338549),
    (0.6, 30.0, 0.0, 2.22510315),
    (0.6, 30.0, 1.0, 1.02697041),
    (0.6, 30.0, 4.0, 0.69549932),
    (0.75, 90.0, 0.0, 0.66334557),
    (0.75, 90.0, 1.0, 0.67229499),
    (0.75, 90.0, 4.0, 0.80554516),
    (0.9, 90.0, 0.0, 0.66800090),
    (0.9, 90.0, 1.0, 0.72207927),
    (0.9, 90.0, 4.0, 0.88557650),
    (0.9, 30.0, 0.0, 2.31029156),
    (0.9, 30.0, 1.0, 1.48578329),
    (0.9, 30.0, 4.0, 0.92636003),
];

/// C(s)² of the half-plane.
fn half_plane(s: f64) -> f64 {
    trace_constant(Domain::HalfPlane, s, 1e-8).unwrap().constant.value.powi(2)
}

#[test]
fn nine_orders_have_five_digits_by_two_roads() {
    let options = example::Options::default();
    let computed = example::compute(&options).unwrap();
    assert!(Verdict::of(&example::findings(&computed)).is_confirmed());
    assert_eq!(computed.rows.len(), CONSTANTS.len());
    for (row, (s, exact)) in computed.rows.iter().zip(CONSTANTS) {
        assert_eq!(row.order.value(), s);
        let error = (row.constant.value - exact).abs();
        assert!(error <= row.constant.error.max(1e-14 * exact), "{s}: {} {exact}", row.constant);
        for quotient in &row.half_plane {
            // Honest, and five digits.
            let error = (quotient.value - 1.0).abs();
            assert!(error < quotient.error && error < 1e-5, "{s}: {quotient}");
        }
    }
}

#[test]
fn corners_agree_with_graded_meshes_and_acute_ones_do_harm() {
    for (s, degrees, tau, share) in CORNERS {
        let square = half_plane(s);
        let found = trace_quotient(Domain::Corner(f64::to_radians(degrees)), s, tau, 1e-4).unwrap();
        // The reference itself is good to 1e-5.
        assert!((found.value / square - share).abs() < 2e-5 * share, "{s} {degrees} {tau}: {found} {share}");
    }
    let worse = CORNERS.iter().filter(|(_, degrees, _, share)| *degrees == 30.0 && *share > 1.0);
    assert!(worse.count() > 0);
}

#[test]
fn more_functions_on_the_square_reach_more_and_never_the_half_plane() {
    let bound = half_plane(0.8);
    let found = [4, 8, 12].map(|degree| SquareTrace::new(0.8, degree).unwrap().largest().value / bound);
    assert!(found.windows(2).all(|pair| pair[0] < pair[1]) && found[2] < 1.0, "{found:?}");
}

#[test]
fn planted_faults_turn_the_findings() {
    let options = example::Options { s: vec!["0.8".parse().unwrap()], ..example::Options::default() };
    let outcome = |computed: &example::Computed, key: &str| {
        let found = example::findings(computed);
        found.iter().find(|finding| finding.key() == key).unwrap().outcome()
    };
    let sound = example::compute(&options).unwrap();
    let spoiled = |key: &str, spoil: &dyn Fn(&mut example::Computed)| {
        let mut computed = sound.clone();
        assert_eq!(outcome(&computed, key), Outcome::Holds, "{key}");
        spoil(&mut computed);
        assert_eq!(outcome(&computed, key), Outcome::Refuted, "{key}");
    };
    spoiled("roads", &|c| c.rows[0].half_plane[1].value *= 1.0 + 1e-3);
    spoiled("corner", &|c| c.rows[0].corner[2].value *= 1.5);
    spoiled("square", &|c| c.rows[0].square.as_mut().unwrap().value *= 2.0);
    spoiled("growth", &|c| c.growth.value *= 1.0 + 1e-4);
    // An acute corner is worse than the half-plane, and the example says so.
    let acute = example::Options { angle: 30.0, s: vec!["0.6".parse().unwrap()], ..options };
    let computed = example::compute(&acute).unwrap();
    assert_eq!(outcome(&computed, "corner"), Outcome::Refuted);
    let below = example::Options { s: vec!["0.5".parse().unwrap()], ..acute };
    assert!(example::compute(&below).is_err());
}
