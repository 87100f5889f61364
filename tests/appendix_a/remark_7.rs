//! Remark 7: the end is the worst place, the bound without a cut holds, and the printed step fails with any constant.

use example_report::prelude::{largest_eigenvalue, mass_matrix};
use fractional_sobolev::{
    Constraint, Function, Gram, Mesh, Order, Tolerance, Zones, gamma, mean_constant,
};
use nalgebra::{DMatrix, DVector};

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
        let whole = gamma(nu, Constraint::mean_zero(), 1e-8).unwrap().constant;
        for theta in [0.3, 1e-2, 1e-6] {
            let end = gamma(nu, Constraint::mean_zero_on(0.0..theta), 1e-8).unwrap().constant;
            for at in [1e-3, 0.1, 0.37, 0.5] {
                let zone = Zones::from_start_and_length(at * (1.0 - theta), theta).unwrap();
                let found = gamma(nu, Constraint::mean_zero_on(zone), 1e-8).unwrap();
                let label = format!("nu {nu}, theta {theta}, at {at}: {}", found.constant);
                assert!(found.constant.value < end.value, "{label} against {end}");
                let zone = Zones::from_start_and_length(at * (1.0 - theta), theta).unwrap();
                let mean = mean_constant(nu, Constraint::mean_zero_on(zone), 1e-8).unwrap();
                let bound = whole.value.hypot(mean.constant.value);
                assert!(found.constant.value <= bound, "{label}");
            }
        }
    }
    // Both sides of the cut for sgn(x − 1/2): 1 and 0, so that no constant serves.
    let sign = Function::piecewise(&Mesh::uniform(2, 1.0).unwrap(), 0, &[-1.0, 1.0]).unwrap();
    assert_eq!(sign.norm(0.0, Tolerance::reference()).unwrap().value, 1.0);
    for piece in [0..1, 1..2] {
        let order = Order::new(0.25).unwrap();
        assert_eq!(
            sign.restrict(piece).unwrap().seminorm(order, Tolerance::fast()).unwrap().value,
            0.0
        );
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

/// The best C in ‖u‖² ≤ C² Σ_k (|I_k|^ν |u|_(ν,I_k))² over continuous piecewise linear functions with
/// α₁ m₁ + α₂ m₂ = 0, where m_k is the mean over the part θ |I_k| of the zone next to the cut, `short` = |I₁|.
/// With both pieces scaled to (0, 1) and the cut at 0 every norm has the weight |I_k|.
fn step_constant(nu: Order, theta: f64, short: f64, weights: [f64; 2]) -> f64 {
    let mesh = Mesh::graded(&[0.0, theta, 1.0], 24, 0.5).unwrap();
    let [mass, form] =
        [mass_matrix(&mesh), Gram::new(&mesh, nu, 1e-10).unwrap().to_dense().unwrap()];
    let (nodes, n) = (mesh.nodes(), mesh.len());
    let mut mean = DVector::<f64>::zeros(n + 1);
    for (k, h) in
        mesh.lengths().iter().enumerate().filter(|&(k, _)| nodes[k + 1] <= theta * (1.0 + 1e-12))
    {
        mean[k] += 0.5 * h / theta;
        mean[k + 1] += 0.5 * h / theta;
    }
    // Node j of the second piece is the unknown n + j; the node of the cut, 0, is common.
    let place = |piece: usize, j: usize| if j == 0 { 0 } else { piece * n + j };
    let [mut m, mut a] = [0; 2].map(|_| DMatrix::<f64>::zeros(2 * n + 1, 2 * n + 1));
    let mut condition = DVector::<f64>::zeros(2 * n + 1);
    for (piece, length) in [short, 1.0 - short].into_iter().enumerate() {
        for i in 0..=n {
            condition[place(piece, i)] += weights[piece] * mean[i];
            for j in 0..=n {
                m[(place(piece, i), place(piece, j))] += length * mass[(i, j)];
                a[(place(piece, i), place(piece, j))] += length * form[(i, j)];
            }
        }
    }
    let pivot = condition.iamax();
    let mut basis = DMatrix::<f64>::identity(2 * n + 1, 2 * n + 1);
    basis.row_mut(pivot).copy_from(&(condition.transpose() / -condition[pivot]));
    let basis = basis.remove_column(pivot);
    let [m, a] = [m, a].map(|all| basis.transpose() * all * &basis);
    largest_eigenvalue(&m, &a).unwrap().sqrt()
}

/// ν > 1/2. The cut of the paper divides the zone in the proportion |I₁| : |I₂|, so |I₁| m₁ + |I₂| m₂ = 0. With this the
/// constant of the step is γ₀ for every cut. Without it, from m₁ = 0 ≤ m₂ alone, it grows like |I₁|^(−1/2).
#[test]
fn the_step_above_one_half_has_the_constant_of_a_point() {
    /// Share of γ₀ that piecewise linear functions miss on this mesh, largest at ν = 0.6; seen: 0.011.
    const MISSED: f64 = 0.015;
    for nu in [0.6, 0.75, 0.9] {
        let nu = Order::new(nu).unwrap();
        let point = gamma(nu, Constraint::vanishing_at(0.0), 1e-6).unwrap().constant.value;
        for theta in [0.5, 1e-2] {
            let [whole, signs]: [Vec<f64>; 2] = [true, false].map(|weighted| {
                let weights = |short: f64| if weighted { [short, 1.0 - short] } else { [1.0, 0.0] };
                [0.5, 0.1, 1e-2, 1e-4, 1e-6]
                    .map(|short| step_constant(nu, theta, short, weights(short)))
                    .into()
            });
            for found in &whole {
                let label = format!("nu {nu}, theta {theta}: {found} against {point}");
                assert!(*found < point && *found > (1.0 - MISSED) * point, "{label}");
                assert!((found / whole[0] - 1.0).abs() < 1e-6, "{label}");
            }
            let order = (signs[4] / signs[3]).ln() / 100f64.ln();
            assert!((order - 0.5).abs() < 2e-3, "nu {nu}, theta {theta}: order {order}");
        }
    }
}
