//! The hardest admissible input gives digits; the inadmissible gives an error. Never a panic, never NaN.

use fractional_sobolev::{
    DualOf, Error, Estimate, Function, Gram, Mesh, Order, Tolerance, closed_forms,
};

#[test]
fn one_element_and_a_million() {
    let order = Order::new(0.25).unwrap();
    let one = Gram::new(&Mesh::uniform(1, 1.0).unwrap(), order, 1e-8).unwrap().to_dense().unwrap();
    assert!(
        (one[(0, 0)] * (1.0 - 0.25) * (1.0 + 2.0 * (1.0 - 0.25)) - 1.0).abs() < 1e-11,
        "{}",
        one[(0, 0)]
    );
    let n = 1_000_000;
    let partition = Mesh::uniform(n, 1.0).unwrap();
    let operator = Gram::constants(&partition, order, Tolerance::reference()).unwrap();
    let step: Vec<f64> = (0..n).map(|i| if i < n / 2 { 0.0 } else { 1.0 }).collect();
    let image = operator.apply(&step).unwrap();
    let form: f64 = step.iter().zip(&image).map(|(x, y)| x * y).sum();
    let exact = closed_forms::jump_seminorm_squared(0.5, 0.5, order).unwrap().value;
    assert!((form / exact - 1.0).abs() < 1e-9, "{form} against {exact}");
    let zero = operator.apply(&vec![3.0; n]).unwrap();
    let diagonal = operator.diagonal().unwrap();
    assert!(zero.iter().all(|y| y.abs() < 1e-13 * diagonal[0]));
}

#[test]
fn nan_infinite_and_repeated_input_are_errors() {
    assert!(Order::new(f64::NAN).is_err() && Order::new(f64::INFINITY).is_err());
    for nodes in
        [&[0.0, 0.5, 0.5, 1.0][..], &[0.0, f64::NAN], &[f64::NEG_INFINITY, 0.0], &[1.0, 0.0]]
    {
        assert!(Mesh::from_nodes(nodes).is_err(), "{nodes:?}");
    }
    let partition = || Mesh::uniform(1, 1.0).unwrap();
    for bad in [f64::NAN, f64::INFINITY] {
        assert!(Function::linears(&partition(), &[0.0, bad]).is_err());
        let u =
            Function::from_fn(&[0.0, 1.0], move |x: f64| if x > 0.5 { bad } else { x }).unwrap();
        assert!(matches!(u.seminorm(Order::HALF, Tolerance::fast()), Err(Error::NotFinite { .. })));
        assert!(Function::from_fn(&[0.0, bad], |x: f64| x).is_err());
    }
    assert!(Function::from_fn(&[0.0, 0.0, 1.0], |x: f64| x).is_err());
}

#[test]
fn infinite_norms_of_closures_are_recognised() {
    let jump =
        Function::from_fn(&[0.0, 0.5, 1.0], |x: f64| if x < 0.5 { 0.0 } else { 1.0 }).unwrap();
    let power = Function::from_fn(&[0.0, 1.0], |x: f64| x.powf(-0.3)).unwrap();
    let logarithm = Function::from_positions(&[0.0, 1.0], |at| match at.anchor() {
        0 => (-at.offset().ln()).powf(0.6),
        _ => (-at.offset().ln_1p()).powf(0.6),
    })
    .unwrap();
    for (u, nu) in [(&jump, 0.5), (&jump, 0.8), (&power, 0.3), (&power, 0.95), (&logarithm, 0.5)] {
        let outcome = u.seminorm(Order::new(nu).unwrap(), Tolerance::fast());
        assert!(matches!(outcome, Err(Error::InfiniteNorm { .. })), "nu {nu}: {outcome:?}");
    }
}

#[test]
fn closures_of_any_size_scale_out() {
    let tolerance = Tolerance::balanced();
    for order in [0.25, 0.5, 0.9].map(|nu| Order::new(nu).unwrap()) {
        let seminorm = closed_forms::power_seminorm_squared(1.0, order).unwrap().value.sqrt();
        let norm = (1.0 / 3.0_f64).sqrt().hypot(seminorm);
        for size in [1e-300, 1e-160, 1e-150, 1e150, 1e160, 1e300] {
            let u = Function::from_fn(&[0.0, 1.0], |x: f64| size * x).unwrap();
            for (what, found, exact) in [
                ("seminorm", u.seminorm(order, tolerance), seminorm),
                ("norm", u.norm(order, tolerance), norm),
                ("mean", u.mean(tolerance), 0.5),
                ("L^7 norm", u.lp(7.0, tolerance), 8.0_f64.powf(-1.0 / 7.0)),
                ("L^200 norm", u.lp(200.0, tolerance), 201.0_f64.powf(-1.0 / 200.0)),
            ] {
                let found = found.unwrap();
                let error = (found.value / size / exact - 1.0).abs();
                assert!(error <= tolerance.relative(), "{what} of {size:e} x at {order}: {found}");
            }
        }
    }
    for size in [1e-150, 1e150] {
        let u =
            Function::linears(&Mesh::uniform(2, 1.0).unwrap(), &[0.0, 0.5 * size, size]).unwrap();
        let dual = u.norm(-0.7, Tolerance::fast()).unwrap().value;
        assert!(dual > 0.1 * size && dual < size, "{dual}");
    }
    let longest = Mesh::from_lengths(&[1e-300, 1e300]);
    assert!(matches!(longest, Err(Error::OutOfRange { .. })));
    let u = Function::from_fn(&[0.0, 1.0], |x: f64| 1e-2 * x).unwrap();
    let found = u.lp(200.0, tolerance).unwrap().value;
    assert!((found / 9.738_319_515_772_5e-3 - 1.0).abs() <= tolerance.relative(), "{found}");
}

#[test]
fn a_jump_barely_below_one_half_has_its_seminorm() {
    let jumps = |x: f64| if x > 0.5 { 1.0 } else { 0.0 };
    let plain = Function::from_fn(&[0.0, 0.5, 1.0], jumps).unwrap();
    let positions = Function::from_positions(&[0.0, 0.5, 1.0], |at| {
        let is_right = at.anchor() == 2 || at.anchor() == 1 && at.offset() > 0.0;
        if is_right { 3.0 + at.x() } else { at.x() }
    })
    .unwrap();
    for offset in [-1e-300, -1e-16, -1e-14, -1e-12, -1e-10, -1e-9] {
        let order = Order::half_plus(offset).unwrap();
        // 4/(2ν (1 − 2ν)) (1 − (1 + O(1)) (1 − 2ν) ...) on (0, 1), cut in the middle
        let exact = closed_forms::jump_seminorm_squared(0.5, 0.5, order).unwrap().value.sqrt();
        let found = plain.seminorm(order, 1e-6).unwrap();
        assert!(
            (found.value - exact).abs() <= found.error + 1e-5 * exact,
            "{offset:e}: {found}, {exact}"
        );
        // beside it the smooth part is below the tolerance
        let found = positions.seminorm(order, 1e-3).unwrap();
        assert!(
            (found.value - 3.0 * exact).abs() <= found.error + 1e-3 * exact,
            "{offset:e}: {found}"
        );
    }
    let half = plain.seminorm(Order::HALF, 1e-6);
    assert!(matches!(half, Err(Error::InfiniteNorm { .. })), "{half:?}");
}

#[test]
fn a_line_has_its_dual_norm_at_orders_next_to_minus_one() {
    let line = Function::from_fn(&[0.0, 1.0], |x| x - 0.5).unwrap();
    let values = Function::linears(&Mesh::uniform(1, 1.0).unwrap(), &[-0.5, 0.5]).unwrap();
    for from_one in [1e-14, 1e-12, 1e-10, 1e-6] {
        let order = Order::new(1.0 - from_one).unwrap();
        let [found, exact] =
            [&line, &values].map(|u| u.dual_norm(DualOf::Slobodeckij, order, 1e-6).unwrap());
        let apart = (found.value - exact.value).abs();
        assert!(apart <= found.error + exact.error, "{from_one:e}: {found}, {exact}");
    }
}

/// Steps and kinks that are not declared, of values and on lengths whose squares are no numbers: below 1e-165 the seminorm
/// was 0.63 and 1.08 times the right one with errors of 1e-14.
#[test]
fn polynomials_of_small_values_on_short_intervals_keep_their_norms() {
    for (is_step, order, place, values) in [
        (true, 0.085, 0.1409, [-0.0531, 0.5425, -0.4624]),
        (false, 0.094, 0.1022, [0.8683, 0.6442, 0.0593]),
    ] {
        let on = |length: f64, size: f64| {
            let slopes = [(values[1] - values[0]) / place, (values[2] - values[1]) / (1.0 - place)];
            Function::from_fn(&[0.0, length], move |x| {
                let (x, k) = (x / length, usize::from(x / length >= place));
                size * if is_step { values[k + 1] } else { values[1] + slopes[k] * (x - place) }
            })
            .unwrap()
        };
        let unit = on(1.0, 1.0);
        let agree = |what: &str, found: Estimate, exact: Estimate, factor: f64| {
            if factor < 1e-280 {
                return;
            }
            let off = (found.value / factor - exact.value).abs();
            // The factor is a power of a length of 300 decades.
            let rounding = 1e-12 * exact.value.abs();
            assert!(
                off <= found.error / factor + exact.error + rounding,
                "{what}: {found} {exact}"
            );
        };
        for length in [1e-276, 1e-207, 1e-100, 1.0, 1e150] {
            for size in [1e-120, 1e-60, 1.0, 1e100] {
                let (u, what) = (on(length, size), format!("step {is_step}, {length:e} {size:e}"));
                let factor = size * (length.sqrt() * length.powf(-order));
                let of = |u: &Function| u.seminorm(order, 1e-3).unwrap();
                agree(&what, of(&u), of(&unit), factor);
                for q in [1.0, 2.0, 3.0] {
                    let of = |u: &Function| u.lp(q, 1e-3).unwrap();
                    agree(&what, of(&u), of(&unit), size * length.powf(1.0 / q));
                }
                let of = |u: &Function| u.lp(f64::INFINITY, 1e-3).unwrap();
                agree(&what, of(&u), of(&unit), size);
                let of = |u: &Function| u.mean(1e-3).unwrap();
                agree(&what, of(&u), of(&unit), size);
                // On short intervals the dual norm of a function is that of its mean: ‖1‖² = length.
                if length < 1e-50 {
                    let found = u.dual_norm(DualOf::Slobodeckij, 0.5, 1e-3).unwrap();
                    let mean = unit.mean(1e-8).unwrap();
                    let positive = Estimate { value: mean.value.abs(), ..mean };
                    agree(&what, found, positive, size * length.sqrt());
                }
            }
        }
    }
}

/// x^{−0.98} ln⁶ x exceeds 1e308 at 1e-298: it was no number, though its integral is 720/0.02⁷.
#[test]
fn values_that_overflow_next_to_a_breakpoint_end_the_range_of_distances() {
    let of = |a: f64, m: i32| {
        Function::from_positions(&[0.0, 1.0], move |at| {
            let log = if at.anchor() == 0 { at.log_distance() } else { at.offset().ln_1p() };
            (a * log).exp() * (-log).powi(m)
        })
        .unwrap()
    };
    let exact = 720.0 / 0.02f64.powi(7);
    for asked in [1e-2, 1e-6] {
        let found = Estimate::or_best(of(-0.98, 6).lp(1.0, asked)).unwrap();
        assert!((found.value - exact).abs() <= found.error && found.error < 0.1 * exact, "{found}");
        let found = Estimate::or_best(of(-0.98, 6).mean(asked)).unwrap();
        assert!((found.value - exact).abs() <= found.error, "{found}");
        for (a, m) in [(-0.99, 6), (-1.0, 40), (-1.5, 0), (-3.0, 0)] {
            let u = of(a, m);
            for found in [u.lp(1.0, asked), u.lp(2.0, asked), u.norm(0.3, asked), u.mean(asked)] {
                let refused = found.expect_err("a norm that is infinite or beyond the distances");
                let is_refusal =
                    matches!(refused, Error::InfiniteNorm { .. } | Error::ToleranceNotMet { .. });
                assert!(is_refusal, "x^{a} ln^{m}: {refused:?}");
            }
        }
    }
    // A value that is no number all at once is an error.
    let broken = Function::from_fn(&[0.0, 1.0], |x| if x < 1e-3 { f64::INFINITY } else { x });
    let broken = broken.unwrap();
    for found in [broken.lp(1.0, 1e-6), broken.seminorm(0.3, 1e-6), broken.mean(1e-6)] {
        assert!(matches!(found, Err(Error::NotFinite { .. })), "{found:?}");
    }
}
