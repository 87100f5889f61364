//! Remark 6: one point fixes the constant above one half, its end is the worst place, and it blows up at one half.

use fractional_sobolev::{Constraint, Function, Mesh, Order, Tolerance, gamma};

fn point(nu: f64, a: f64) -> f64 {
    gamma(nu, Constraint::vanishing_at(a).unwrap(), 1e-9).unwrap().constant.value
}

#[test]
fn statement_is_confirmed() {
    for nu in [0.55, 0.6, 0.75, 0.9, 0.99] {
        let end = point(nu, 0.0);
        // zones that shrink to the point have smaller constants, up to θ^(2ν−1)
        for theta in [0.1, 1e-3, 1e-12, 1e-100] {
            let short = gamma(nu, Constraint::mean_zero_on(0.0..theta), 1e-9).unwrap().constant.value;
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
    // (2ν − 1) γ₀² → 3/(2π²)
    let slope = 1.5 / std::f64::consts::PI.powi(2);
    let off = |nu: f64| ((2.0 * nu - 1.0) * point(nu, 0.0).powi(2) / slope - 1.0).abs();
    assert!(off(0.55) < 0.1 && off(0.52) < 0.5 * off(0.55), "{} {}", off(0.52), off(0.55));
}
