//! Lemma 5.1 for the spaces of Lemma 5.2: α = (1 + γ²)^(−1/2) is positive, attained and an infimum.

use fractional_sobolev::{Constraint, Function, Mesh, Order, Tolerance, gamma};

/// |u| / (‖u‖₀² + |u|²)^(1/2).
fn quotient(u: &Function<'_>, nu: Order) -> f64 {
    let norm = u.norm(0.0, Tolerance::reference()).unwrap().value;
    let seminorm = u.seminorm(nu, Tolerance::fast()).unwrap().value;
    seminorm / norm.hypot(seminorm)
}

#[test]
fn statement_is_confirmed() {
    for nu in [0.1, 0.25, 0.5, 0.75, 0.9] {
        let nu = Order::new(nu).unwrap();
        let mut alphas = Vec::new();
        for theta in [1.0, 1e-1, 1e-4, 1e-8] {
            let found = gamma(nu, Constraint::mean_zero_on(0.0..theta), 1e-8).unwrap();
            let alpha = 1.0 / found.constant.value.hypot(1.0);
            // the extremal function attains it, its matrices are those of another discretisation
            let u = found.extremal().unwrap().interpolate(2, 6, &[theta]).unwrap();
            assert!((quotient(&u, nu) / alpha - 1.0).abs() < 1e-3, "nu {nu}, theta {theta}");
            // α is bounded away from zero without the eigenvalue
            assert!(
                alpha >= (1.0 - 1e-9) / found.bounded().unwrap().upper.unwrap().value.hypot(1.0),
                "nu {nu}, theta {theta}"
            );
            alphas.push(alpha);
        }
        assert!(alphas.windows(2).all(|pair| pair[1] < pair[0]), "nu {nu}: {alphas:?}");
        // above one half α settles as the zone shrinks to a point, below it tends to zero
        let falls = alphas[3] / alphas[2];
        assert!(if nu.value() > 0.5 { falls > 0.99 } else { falls < 0.85 }, "nu {nu}: {alphas:?}");
    }
}

#[test]
fn no_piecewise_linear_function_goes_below_alpha() {
    // piecewise linear functions with mean zero on (0, θ): positive and negative slopes there, ramps beyond
    for nu in [0.25, 0.5, 0.75] {
        let nu = Order::new(nu).unwrap();
        for theta in [0.1, 0.5] {
            let zone = Constraint::mean_zero_on(0.0..theta);
            let alpha = 1.0 / gamma(nu, zone, 1e-8).unwrap().constant.value.hypot(1.0);
            let mesh =
                Mesh::from_nodes(&[0.0, 0.5 * theta, theta, 0.5 * (1.0 + theta), 1.0]).unwrap();
            for values in
                [[-1.0, 0.0, 1.0, 2.0, 2.0], [0.0, 0.0, 0.0, 1.0, 1.0], [-1.0, 0.0, 1.0, 1.0, 1.0]]
            {
                let u = Function::linears(&mesh, &values).unwrap();
                assert!(quotient(&u, nu) >= alpha, "nu {nu}, theta {theta}, {values:?}");
            }
        }
    }
}
