//! Remark 6: one point fixes the constant above one half, its end is the worst place, and it blows up at one half.

use fractional_sobolev::closed_forms::power_seminorm_squared;
use fractional_sobolev::{Constraint, Function, Mesh, Order, Tolerance, gamma};
use std::f64::consts::PI;

fn point(nu: f64, a: f64) -> f64 {
    gamma(nu, Constraint::vanishing_at(a).unwrap(), 1e-9).unwrap().constant.value
}

#[test]
fn statement_is_confirmed() {
    for nu in [0.55, 0.6, 0.75, 0.9, 0.99] {
        let end = point(nu, 0.0);
        // zones that shrink to the point have smaller constants, up to θ^(2ν−1)
        for theta in [0.1, 1e-3, 1e-12, 1e-100] {
            let short =
                gamma(nu, Constraint::mean_zero_on(0.0..theta), 1e-9).unwrap().constant.value;
            let below = 1.0 - short / end;
            assert!(
                below > -4e-9 && below < theta.powf(2.0 * nu - 1.0) + 4e-9,
                "nu {nu}, {theta:e}: {below}"
            );
        }
        for a in [1e-3, 0.1, 0.3, 0.5] {
            assert!(point(nu, a) < end, "nu {nu}, point {a}");
        }
        // functions that vanish at the end stay below: powers, and their interpolants
        for power in [0.6, 1.0, 2.0] {
            let mesh = Mesh::geometric(40, 0.5, 1.0).unwrap();
            let u = Function::interpolate(&mesh, 2, |x| x.powf(power)).unwrap();
            let order = Order::new(nu).unwrap();
            let seminorm = u.seminorm(order, Tolerance::fast()).unwrap().value;
            assert!(
                u.norm(0.0, Tolerance::reference()).unwrap().value < end * seminorm,
                "nu {nu}, x^{power}"
            );
        }
    }
}

/// 3/(2π²).
const SLOPE: f64 = 1.5 / (PI * PI);

/// 2 ∫₀^∞ k(r) r² f(r) dr with k = (2 sinh r/2)^(−1−2ν), by the double exponential rule.
fn against_kernel(nu: f64, f: impl Fn(f64) -> f64) -> f64 {
    let step = 1.0 / 64.0;
    let term = |j: i32| {
        let x = f64::from(j) * step;
        let r = (0.5 * PI * x.sinh()).exp();
        // beyond r = 300 the integrand is below e^(−150)
        if r > 300.0 {
            return 0.0;
        }
        2.0 * r.powi(2)
            * f(r)
            * (2.0 * (0.5 * r).sinh()).powf(-1.0 - 2.0 * nu)
            * r
            * 0.5
            * PI
            * x.cosh()
            * step
    };
    (-290..=290).map(term).sum()
}

/// The bounds of the page: x^ε from below, chains of steps from above, ε = 2ν − 1. They close on 3/(2π²) like √ε, the
/// constant itself like ε.
#[test]
fn two_proved_bounds_enclose_the_constant_of_a_point() {
    let limit = against_kernel(0.5, |_| 1.0) * SLOPE;
    assert!((limit - 1.0).abs() < 1e-10, "2π²/3 by quadrature: {limit}");
    for nu in [0.52, 0.54, 0.58, 0.66] {
        let (epsilon, order) = (2.0 * nu - 1.0, Order::new(nu).unwrap());
        let found = point(nu, 0.0).powi(2);
        let energy = power_seminorm_squared(epsilon, order).unwrap().value;
        let below = 1.0 / ((1.0 + 2.0 * epsilon) * energy);
        let whole = gamma(order, Constraint::mean_zero(), 1e-9).unwrap().constant.value;
        let loss = |r: f64| {
            // (e^r − 1)/r² − 1 without cancellation where it is large; it is least, 0.54, at r = 1.6
            whole * (r.exp_m1() / r.powi(2) - 1.0).sqrt()
        };
        let [i, j] = [against_kernel(nu, |_| 1.0), against_kernel(nu, loss)];
        let root = (epsilon.sqrt() * j + (epsilon * j * j + i).sqrt()) / i;
        let above = whole * whole + root * root / epsilon;
        assert!(below < found && found < above, "nu {nu}: {below} {found} {above}");
        assert!((epsilon * below / SLOPE - 1.0).abs() < 3.0 * epsilon, "nu {nu}: {below}");
    }
    let scaled = |nu: f64| (2.0 * nu - 1.0) * point(nu, 0.0).powi(2) / SLOPE;
    // Three steps of Richardson's extrapolation in ε.
    let mut values = [0.66, 0.58, 0.54, 0.52].map(scaled).to_vec();
    for power in 1..=3 {
        let factor = 2f64.powi(power);
        values = values.windows(2).map(|v| (factor * v[1] - v[0]) / (factor - 1.0)).collect();
    }
    assert!((values[0] - 1.0).abs() < 5e-5, "{values:?}");
}
