//! Section 1 in the plane: corner singularities on sectors, by two methods.

use fractional_sobolev::{CornerFunction, Error, Order, Tolerance, gauss_legendre};
use std::f64::consts::PI;

/// Two methods.
const TWO_METHODS: f64 = 1e-8;

/// 2/(2a+2−2s) ∫∫ dφ dφ' ∫₀¹ (g(φ) − ρ^a g(φ'))² |e_φ − ρ e_φ'|^{-2-2s} ρ dρ: cells that shrink towards ρ = 1
/// and φ = φ', no Duffy coordinates, the angle integrated numerically.
fn by_cells(a: f64, b: f64, angle: f64, s: f64) -> f64 {
    let rule = gauss_legendre(10).unwrap();
    let cuts = |end: f64, most: f64| -> Vec<f64> {
        let mut cuts = vec![0.0];
        let first = 1e-12f64.powf(0.6 / (1.0 - s)).max(1e-200) * angle.min(1.0);
        cuts.extend((0..).map(|k| first * 2.5f64.powi(k)).take_while(|&x| x < most.min(end)));
        while cuts[cuts.len() - 1] + most < end {
            cuts.push(cuts[cuts.len() - 1] + most);
        }
        cuts.push(end);
        cuts
    };
    // For ψ = φ − φ' > 0 both orders of x and y.
    let inner = |psi: f64, tau: f64| {
        let rest = angle - psi;
        let pieces = (b * rest).ceil().max(1.0);
        let width = rest / pieces;
        let f = |phi: f64| {
            let (g, h) = ((b * phi).sin(), (b * (phi + psi)).sin());
            (g - tau * h).powi(2) + (h - tau * g).powi(2)
        };
        (0..pieces as usize)
            .map(|k| width * rule.integrate(|t| f((k as f64 + t) * width)))
            .sum::<f64>()
    };
    let mut sum = 0.0;
    for psi in cuts(angle, 0.4).windows(2) {
        for u in cuts(24.0 / (1.0 + a.min(0.0)), 0.4).windows(2) {
            for (x, v) in rule.iter() {
                let psi_at = psi[0] + (psi[1] - psi[0]) * x;
                for (y, w) in rule.iter() {
                    let at = u[0] + (u[1] - u[0]) * y;
                    let rho = (-at).exp();
                    let distance =
                        (-(-at).exp_m1()).powi(2) + 4.0 * rho * (0.5 * psi_at).sin().powi(2);
                    let weight = v * w * (psi[1] - psi[0]) * (u[1] - u[0]) * rho * rho;
                    sum += weight * inner(psi_at, (-a * at).exp()) * distance.powf(-1.0 - s);
                }
            }
        }
    }
    sum / (a + 1.0 - s)
}

#[test]
fn two_methods_agree_up_to_the_limit_of_finiteness() {
    let mut worst = 0.0f64;
    for angle in [0.5 * PI, 0.8, 1.5 * PI] {
        for (a, b, s) in [
            (0.5, PI / angle, 0.3),
            (-0.4, 1.0, 0.55),
            (-0.299, 0.7, 0.7),
            (2.0 / 3.0, 2.0 / 3.0, 0.6),
        ] {
            let w = CornerFunction::power(a, b, angle, 1.0).unwrap();
            let found = w.seminorm(Order::new(s).unwrap(), Tolerance::new(1e-10).unwrap()).unwrap();
            let other = by_cells(a, b, angle, s);
            let difference = (found.value.powi(2) / other - 1.0).abs();
            assert!(
                difference < TWO_METHODS,
                "{angle} {a} {b} {s}: {found} {} {difference:e}",
                other.sqrt()
            );
            worst = worst.max(difference);
        }
    }
    println!("two methods: {worst:.1e}");
}

#[test]
fn scaling_and_infinite_norms() {
    let order = Order::new(0.7).unwrap();
    let norm = |a: f64, radius: f64| {
        CornerFunction::power(a, 1.0, 2.0, radius).unwrap().seminorm(order, Tolerance::balanced())
    };
    let quotient = norm(0.4, 1e-100).unwrap().value / norm(0.4, 1.0).unwrap().value;
    assert!((quotient / 1e-100f64.powf(0.7) - 1.0).abs() < 1e-12);
    // a + 1 − s → 0: the square grows like its inverse.
    let near = |gap: f64| gap * norm(gap - 0.3, 1.0).unwrap().value.powi(2);
    assert!((near(1e-7) / near(1e-6) - 1.0).abs() < 1e-5);
    for a in [-0.3 - 1e-12, -0.5] {
        let error = norm(a, 1.0).unwrap_err();
        assert!(
            matches!(error, Error::InfiniteNorm { .. }) && error.to_string().contains("a > s - 1"),
            "{error}"
        );
    }
    for bad in
        [CornerFunction::power(-1.0, 1.0, 1.0, 1.0), CornerFunction::power(0.5, 1.0, 6.0, 1.0)]
    {
        assert!(matches!(bad, Err(Error::OutOfRange { .. })));
    }
    assert!(CornerFunction::power(0.5, f64::NAN, 1.0, 1.0).is_err());
}
