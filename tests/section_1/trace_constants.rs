//! Section 1, traces: the constant of the half-plane by two computations, corners against a third one.

use fractional_sobolev::{Domain, trace_constant, trace_constant_of_mode};

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
fn nine_orders_have_five_digits_by_two_computations() {
    for (s, exact) in CONSTANTS {
        let constant = trace_constant(Domain::HalfPlane, s, 1e-8).unwrap().constant;
        let error = (constant.value - exact).abs();
        assert!(error <= constant.error.max(1e-14 * exact), "{s}: {constant} {exact}");
        for frequency in [0.0, 1.0, 4.0] {
            let found = trace_constant_of_mode(Domain::HalfPlane, s, frequency, 1e-5).unwrap();
            // The error bound holds, and five digits are reached.
            let error = (found.constant.value / exact - 1.0).abs();
            assert!(
                error <= found.constant.error / exact + 1e-12 && error < 5e-6,
                "{s} {frequency}: {found:?}"
            );
        }
    }
    assert!(trace_constant(Domain::HalfPlane, 0.5, 1e-8).is_err());
}

#[test]
fn corners_agree_with_graded_meshes_and_acute_ones_do_harm() {
    for (s, degrees, tau, share) in CORNERS {
        let square = half_plane(s);
        let corner = Domain::Corner(f64::to_radians(degrees));
        let found = trace_constant_of_mode(corner, s, tau, 1e-4).unwrap().constant;
        // The reference itself is good to 1e-5.
        assert!(
            (found.value.powi(2) / square - share).abs() < 2e-5 * share,
            "{s} {degrees} {tau}: {found} {share}"
        );
    }
    let worse = CORNERS.iter().filter(|(_, degrees, _, share)| *degrees == 30.0 && *share > 1.0);
    assert!(worse.count() > 0);
}
