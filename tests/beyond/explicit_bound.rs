//! Theorems 3.1 and 4.1 at τ = 2 with numbers in the place of C.

use crate::explicit_constants::example::{constant, factors, interpolation};
use fractional_sobolev::gauss_legendre;
use signorini::cone::Cone;
use signorini::contact::Solver;
use signorini::fem::Lame;
use signorini::problems::KnownSolution;
use std::f64::consts::PI;

/// With the proved constant c of a segment and |u|₂ near the edge in its terms, h² (M A² |u|₂² + (b² + 2 c π ϑ S)
/// |u|²_{2,S_h}), S_h the squares on the contact edge, b = (ϑ/π) S B for the midpoint cone; errors by adaptive quadrature.
#[test]
fn the_bound_is_above_the_error_on_every_mesh() {
    for lame in [None, Some(Lame::new(1.0, 1.0).unwrap())] {
        for known in [KnownSolution::one_transition(lame), KnownSolution::two_transitions(lame)] {
            let whole = known.second_seminorm(1, 1e-2).unwrap();
            let whole = whole.value + whole.error;
            for (cone, n) in
                Cone::ALL.into_iter().flat_map(|cone| [4, 8, 16, 32].map(|n| (cone, n)))
            {
                let c = if cone == Cone::Nodal { 2.0 / 27.0 } else { 0.125 };
                let [m, s, b] = factors(lame);
                let (theta, b) = (1.0 / PI.tanh(), if cone == Cone::Nodal { 0.0 } else { b });
                let edge = (theta / PI * s * b).powi(2) + 2.0 * c * PI * theta * s;
                let near = known.second_seminorm(n, 1e-2).unwrap();
                let near = (near.value + near.error).min(whole);
                let h = 1.0 / n as f64;
                let body = m * interpolation().powi(2) * whole * whole;
                let [whole, near] =
                    [whole, near].map(|near| h * (body + edge * near * near).sqrt());
                let problem = known.problem(n).unwrap();
                let u = problem.solve(cone, Solver::ActiveSet).unwrap();
                let error = known.error(&problem, &u.displacement, 1e-2).unwrap();
                let name = format!("{known} {cone} {n}: {error:?}, {near}, {whole}");
                assert!(error.value + error.error < near && near <= whole, "{name}");
                assert!(near < 4.2 * error.value, "{name}");
            }
        }
    }
}

#[test]
fn constants_of_the_scalar_problem_are_those_computed_by_hand() {
    assert!(
        (interpolation() - 0.4929124517549).abs() < 1e-12,
        "Kikuchi and Liu: {}",
        interpolation()
    );
    let nodal = constant([1.0, 1.0, 0.0], 0.25);
    let by_hand = (0.4929124517549f64.powi(2) + 0.5 * PI / PI.tanh()).sqrt();
    assert!((nodal / by_hand - 1.0).abs() < 1e-12 && (nodal - 1.35).abs() < 1e-2);
    // μ = 1/2, λ = 0 has the energy of ε alone and σ_N = ∂_n u_n: no factor is left.
    let [m, s, _] = factors(Some(Lame::new(0.0, 0.5).unwrap()));
    assert!((m - 1.0).abs() < 1e-15 && (s - 1.0).abs() < 1e-15, "{m} {s}");
    let midpoint = constant([1.0, 1.0, 1.0], 0.125);
    let by_hand =
        (interpolation().powi(2) + (PI * PI.tanh()).powi(-2) + 0.25 * PI / PI.tanh()).sqrt();
    assert!((midpoint / by_hand - 1.0).abs() < 1e-12);
}

/// ‖∇v_y‖² and 2μ‖ε‖² + λ‖div v‖² on the half-plane y > 0 over one period, up to one factor, for
/// v = (i f, g)(y) e^{ix}, f = Σ a_j e^{−r_j y}, g = Σ b_j e^{−r_j y}, μ = 1.
fn half_plane(waves: &[[f64; 3]], lambda: f64) -> [f64; 2] {
    let mut sums = [0.0; 2];
    for &[a, b, r] in waves {
        for &[c, d, s] in waves {
            let weight = 1.0 / (r + s);
            let (shear, divergence) = ((b - r * a) * (d - s * c), (a + r * b) * (c + s * d));
            sums[0] += weight * (b * d * (1.0 + r * s));
            sums[1] += weight * (2.0 * a * c + 2.0 * r * s * b * d + shear + lambda * divergence);
        }
    }
    sums
}

#[test]
fn the_korn_constant_of_the_half_plane_is_sharp() {
    let square = factors(Some(Lame::new(0.0, 1.0).unwrap()))[2].powi(2);
    let golden = 0.5 * (1.0 + 5f64.sqrt());
    assert!((square - 0.5 * golden * golden).abs() < 1e-13);
    // f = e^{−y/φ} − φ e^{−y}, g = φ e^{−y} − φ² e^{−y/φ} attains it.
    let worst = [[1.0, -golden * golden, 1.0 / golden], [-golden, golden, 1.0]];
    let [gradient, energy] = half_plane(&worst, 0.0);
    assert!((gradient / energy - square).abs() < 1e-12, "{gradient} {energy}");
    let mut state = 2012u64;
    let mut random = || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 11) as f64 / (1u64 << 53) as f64
    };
    let mut largest = 0.0f64;
    for trial in 0..20_000 {
        let lambda = [0.0, 10.0 * random(), -0.9 * random()][trial % 3];
        let waves: Vec<[f64; 3]> =
            (0..3).map(|_| [random() - 0.5, random() - 0.5, 0.05 + 3.0 * random()]).collect();
        let [gradient, energy] = half_plane(&waves, lambda);
        largest = largest.max(gradient / energy * (1.0 + lambda.min(0.0)));
    }
    assert!(largest <= square && largest > 0.9 * square, "{largest} {square}");
}

/// The best constant of |w|²_{1/2,(0,1)} ≤ C ‖∇w‖² over traces Σ a_k cos kπx, k ≤ 24, least ‖∇w‖² = Σ ½ a_k²
/// kπ tanh kπ: largest eigenvalue by iteration, Gram matrix by a product rule for the smooth difference
/// quotients.
#[test]
fn the_trace_constant_of_the_square_is_nearly_attained() {
    let (modes, rule) = (24, gauss_legendre(100).unwrap());
    let points: Vec<(f64, f64)> = rule.iter().collect();
    let quotient = |k: usize, x: f64, y: f64| {
        let wave = k as f64 * PI;
        if x == y {
            -wave * (wave * x).sin()
        } else {
            ((wave * x).cos() - (wave * y).cos()) / (x - y)
        }
    };
    let energy = |k: usize| (0.5 * k as f64 * PI * (k as f64 * PI).tanh()).sqrt();
    let pairs = || points.iter().flat_map(|&p| points.iter().map(move |&q| (p, q)));
    let rows: Vec<Vec<f64>> = pairs()
        .map(|((x, v), (y, w))| {
            (1..=modes).map(|k| (v * w).sqrt() * quotient(k, x, y) / energy(k)).collect()
        })
        .collect();
    let (mut vector, mut value) = (vec![1.0; modes], 0.0);
    for _ in 0..100 {
        let mut next = vec![0.0; modes];
        for row in &rows {
            let product: f64 = row.iter().zip(&vector).map(|(a, b)| a * b).sum();
            next.iter_mut().zip(row).for_each(|(sum, a)| *sum += a * product);
        }
        value = next.iter().map(|v| v * v).sum::<f64>().sqrt();
        vector = next.iter().map(|v| v / value).collect();
    }
    let bound = 2.0 * PI / PI.tanh();
    assert!(value < bound && value > 6.1, "{value} {bound}");
}

/// On a fixed mesh the energy error of the elastic closed form grows like √λ, as the nodal bound does: no more than the
/// bound, and not bounded.
#[test]
fn the_error_grows_like_the_root_of_lambda() {
    let error = |lambda: f64| {
        let known = KnownSolution::one_transition(Some(Lame::new(lambda, 1.0).unwrap()));
        let problem = known.problem(32).unwrap();
        let u = problem.solve(Cone::Nodal, Solver::ActiveSet).unwrap();
        known.error_norms(&problem, &u.displacement).unwrap().energy
    };
    let decade = error(1e4) / error(1e3);
    assert!((decade / 10f64.sqrt() - 1.0).abs() < 0.02, "{decade}");
}
