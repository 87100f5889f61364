//! Lemma 6.1 on triangles: digits of the reference, angles, and bad input.

use fractional_sobolev::{
    BestConstant, Domain, Error, ErrorNorm, Function, Triangles, interpolation_constant,
};

const RIGHT: [[f64; 2]; 3] = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];

/// The constants of the gradient and in L².
fn both(corners: [[f64; 2]; 3], s: f64, tolerance: f64) -> [BestConstant; 2] {
    let gradient =
        interpolation_constant(Domain::Triangle(corners), ErrorNorm::Derivative, s, tolerance)
            .unwrap();
    let l2 = gradient.in_norm(ErrorNorm::L2).unwrap();
    [gradient, l2]
}

#[test]
fn twelve_orders_have_six_digits() {
    let mut before = [f64::INFINITY; 2];
    for s in [0.25, 0.3, 0.35, 0.4, 0.5, 0.6, 0.7, 0.75, 0.8, 0.9, 0.95, 1.0] {
        let unit = if s < 1.0 { (std::f64::consts::FRAC_PI_2 / (1.0 - s)).sqrt() } else { 1.0 };
        for (k, found) in both(RIGHT, s, 1e-6).iter().enumerate() {
            let constant = found.constant;
            assert!(constant.relative_error() <= 1e-6, "{s}: {constant}");
            assert!(found.lower.value <= constant.value + constant.error, "{s}: {constant}");
            assert!(constant.value + constant.error < found.upper.unwrap().value, "{s}");
            let normalised = unit * constant.value;
            assert!(normalised < 0.97 * before[k], "{s}: both fall with the order");
            before[k] = normalised;
        }
    }
    assert!(before[0] < 0.492_912_451_754_9, "Babuska and Aziz");
}

/// Longest edge 1.
fn isosceles(angle: f64) -> [[f64; 2]; 3] {
    let (x, y) = (0.5 * angle).to_radians().sin_cos();
    [[0.0, y], [-x, 0.0], [x, 0.0]].map(|p| p.map(|c| c / (2.0 * x).max(1.0)))
}

/// An angle at the top, against the equilateral triangle.
#[test]
fn large_angles_do_harm_and_below_one_small_ones_too() {
    for s in [0.5, 0.75, 1.0] {
        let constant = |angle: f64| {
            let triangle = Domain::Triangle(isosceles(angle));
            interpolation_constant(triangle, ErrorNorm::Derivative, s, 1e-3).unwrap()
        };
        let [sharp, equal, flat] = [20.0, 60.0, 135.0].map(constant);
        let ratio = |found: &BestConstant| found.constant.value / equal.constant.value;
        assert!(ratio(&flat) > 2.0, "{s}");
        let bounds = if s < 1.0 { 1.1..1.3 } else { 1.0..1.01 };
        assert!(bounds.contains(&ratio(&sharp)), "{s}: {}", ratio(&sharp));
    }
}

/// Isosceles triangles, and one without symmetry; the bound is above the constant and at most twice as large.
#[test]
fn upper_bounds_are_at_most_twice_the_constants() {
    let unequal = [[0.0, 0.0], [3.0, 0.5], [1.0, 2.0]];
    for corners in [isosceles(20.0), isosceles(60.0), RIGHT, isosceles(135.0), unequal] {
        for s in [0.25, 0.4, 0.5, 0.6, 0.75, 0.76, 0.9, 0.98, 1.0] {
            for (k, found) in both(corners, s, 1e-3).iter().enumerate() {
                let (constant, upper) = (found.constant, found.upper.unwrap().value);
                let ratio = upper / constant.value;
                assert!(
                    constant.value + constant.error < upper && ratio < 2.0,
                    "{corners:?} {s} {k}: {ratio}"
                );
            }
        }
    }
}

#[test]
fn bad_triangles_orders_and_tolerances_are_errors() {
    let of = |corners, s: f64, tolerance: f64| {
        interpolation_constant(Domain::Triangle(corners), ErrorNorm::L2, s, tolerance)
    };
    assert!(of([[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]], 0.5, 1e-3).is_err());
    assert!(of([[0.0, f64::NAN], [1.0, 0.0], [0.0, 1.0]], 0.5, 1e-3).is_err());
    for s in [0.001, 0.0, -0.5, 1.5] {
        assert!(matches!(of(RIGHT, s, 1e-3), Err(Error::OutOfRange { .. })), "{s}");
    }
    // Quadrature leaves 3e-8: the best estimate comes with the refusal.
    let best = of(RIGHT, 1.0, 1e-9).unwrap_err().best().unwrap();
    assert!((best.value - of(RIGHT, 1.0, 1e-5).unwrap().constant.value).abs() < 1e-6, "{best}");
    assert!(interpolation_constant(Domain::Triangle(RIGHT), ErrorNorm::Dual, 0.5, 1e-3).is_err());
}

/// u = x₁²/2 on the triangle (0, 0), (1, ±δ/2): ‖∇(u − I u)‖² = ∫ (x₁ − 1/2)² = δ/24, and |∇u|_s = |x₁|_s. The quotient, a
/// lower bound of the constant, grows like δ^(−min(1/2, 1 − s)).
#[test]
fn thin_triangles_raise_the_constant_by_a_power_below_one() {
    let quotient = |s: f64, delta: f64| {
        let corners = vec![[0.0, 0.0], [1.0, -0.5 * delta], [1.0, 0.5 * delta]];
        let mesh = Triangles::new(&corners, &[[0, 1, 2]]).unwrap();
        let x = Function::on_triangles(&mesh, 1, &[0.0, 1.0, 1.0]).unwrap();
        (delta / 24.0).sqrt() / x.seminorm(s, 1e-7).unwrap().value
    };
    for s in [0.1, 0.25, 0.75, 0.9] {
        let exponent = |delta: f64| (quotient(s, 0.1 * delta) / quotient(s, delta)).log10();
        let (near, far, expected) = (exponent(1e-4), exponent(1e-2), 0.5f64.min(1.0 - s));
        assert!((near - expected).abs() < 0.01, "{s}: {near} {expected}");
        assert!(
            (near - expected).abs() <= (far - expected).abs() + 1e-6,
            "{s}: {far} {near} {expected}"
        );
    }
}
