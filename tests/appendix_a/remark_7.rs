//! Remark 7: the end is the worst place, the bound without a cut holds, and the printed step fails with any constant.

use fractional_sobolev::{Constraint, Function, Mesh, Order, Tolerance, Zones, gamma};

/// ‖w‖₀ / |w|_(1/2) of w = 1 − min(|ln x|, L)/L: odd about 1/2 and scaled, both sides of the cut at ν = 1/2.
fn ramp(log: f64) -> f64 {
    let layers = (log / 0.35).ceil();
    let mut nodes = vec![0.0];
    nodes.extend((0..=layers as usize).map(|k| (-log * (1.0 - k as f64 / layers)).exp()));
    let value = |x: f64| if x <= 0.0 { 0.0 } else { 1.0 - (-x.ln()).clamp(0.0, log) / log };
    let w = Function::interpolate(&Mesh::from_nodes(&nodes).unwrap(), 2, value).unwrap();
    w.norm(0.0, 1e-12).unwrap().value / w.seminorm(Order::HALF, 1e-8).unwrap().value
}

#[test]
fn statement_is_confirmed_and_the_printed_step_is_not() {
    for nu in [0.1, 0.3, 0.5, 0.7, 0.9] {
        let nu = Order::new(nu).unwrap();
        for theta in [0.3, 1e-2, 1e-6] {
            let end = gamma(nu, Constraint::mean_zero_on(0.0..theta), 1e-8).unwrap().constant;
            for at in [1e-3, 0.1, 0.37, 0.5] {
                let zone = Zones::from_start_and_length(at * (1.0 - theta), theta).unwrap();
                let found = gamma(nu, Constraint::mean_zero_on(zone), 1e-8).unwrap();
                let label = format!("nu {nu}, theta {theta}, at {at}: {}", found.constant);
                assert!(found.constant.value < end.value, "{label} against {end}");
                let bounds = found.bounds().unwrap();
                assert!(found.constant.value <= bounds.whole.value.hypot(bounds.dual_norm.value), "{label}");
            }
        }
    }
    // Both sides of the cut for sgn(x − 1/2): 1 and 0, so that no constant serves.
    let sign = Function::piecewise(&Mesh::uniform(2, 1.0).unwrap(), 0, &[-1.0, 1.0]).unwrap();
    assert_eq!(sign.norm(0.0, Tolerance::reference()).unwrap().value, 1.0);
    for piece in [0..1, 1..2] {
        let order = Order::new(0.25).unwrap();
        assert_eq!(sign.restrict(piece).unwrap().seminorm(order, Tolerance::fast()).unwrap().value, 0.0);
    }
}

#[test]
fn odd_ramps_come_within_a_twentieth_of_the_constant_of_their_zone() {
    for radius in [1e-4f64, 1e-8, 1e-16] {
        let log = -(2.0 * radius).ln();
        let found = ramp(log);
        let zone = Constraint::vanishing_on(0.0..2.0 * radius);
        let best = gamma(Order::HALF, zone, Tolerance::balanced()).unwrap().constant.value;
        assert!(found < best && found > 0.95 * best, "radius {radius:e}: {found} against {best}");
    }
}
