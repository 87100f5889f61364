//! Norms, means and L^q norms of closures, norms of order 1 + nu, and piecewise linears on many elements,
//! each against a closed form.

use fractional_sobolev::{Function, Order, Tolerance, closed_forms};

/// Asked of every quadrature; the true error is at most this by the contract of an estimate.
const ASKED: f64 = 1e-10;

fn asked() -> Tolerance {
    Tolerance::new(ASKED).unwrap()
}

#[track_caller]
fn assert_close(what: &str, value: f64, expected: f64, tolerance: f64) {
    let error = (value / expected - 1.0).abs();
    assert!(error <= tolerance, "{what}: {value:.17e} against {expected:.17e}, off by {error:e}");
}

#[test]
fn means_and_lebesgue_norms_of_powers_are_beta_integrals() {
    for a in [-0.3, 0.001, 0.5, 3.0, 40.0] {
        let u = Function::from_fn(&[0.0, 1.0], |x: f64| x.powf(a)).unwrap();
        assert_close(
            &format!("mean of x^{a}"),
            u.mean(asked()).unwrap().value,
            1.0 / (a + 1.0),
            ASKED,
        );
        for q in [1.0_f64, 1.5, 2.0, 3.0, 7.25] {
            if a * q <= -1.0 {
                assert!(u.lp(q, asked()).is_err(), "x^{a} is not in L^{q}");
                continue;
            }
            let norm = u.lp(q, asked()).unwrap().value;
            assert_close(
                &format!("L^{q} norm of x^{a}"),
                norm,
                (a * q + 1.0).powf(-1.0 / q),
                ASKED,
            );
        }
    }
}

#[test]
fn order_above_one_adds_the_derivative() {
    // u = x^2, u' = 2 x: |u|_0^2 = 1/5, |u'|_0^2 = 4/3 and |u'|_nu^2 = 4 |x|_nu^2.
    let parabola =
        |slope| Function::from_fn(&[0.0, 1.0], |x: f64| x * x).unwrap().with_gradient(vec![slope]);
    let u = parabola(Function::from_fn(&[0.0, 1.0], |x: f64| 2.0 * x).unwrap());
    for nu in [1e-6, 0.01, 0.25, 0.5, 0.75, 0.99] {
        let order = Order::new(nu).unwrap();
        let squared = closed_forms::power_seminorm_squared(1.0, order).unwrap().value;
        let expected = (0.2 + 4.0 / 3.0 + 4.0 * squared).sqrt();
        let norm = u.norm(order.plus_one(), asked()).unwrap();
        assert_close(&format!("||x^2|| of order 1 + {nu}"), norm.value, expected, ASKED);
        assert!((norm.value - expected).abs() <= 10.0 * norm.error, "nu {nu}: {norm:?}");
    }
    let shorter = Function::from_fn(&[0.0, 0.5], |x: f64| 2.0 * x).unwrap();
    assert!(parabola(shorter).norm(1.5, asked()).is_err());
}
