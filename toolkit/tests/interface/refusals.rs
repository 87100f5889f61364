//! Where a tolerance is refused the error carries the best estimate of the quantity that was asked for, not of
//! its square or of a part of it, and says why more is not to be had.

use fractional_sobolev::{
    Constraint, Domain, DualOf, Error, ErrorNorm, Estimate, Function, Mesh, Order, Result,
    Tolerance, Triangles, gamma, interpolation_constant, projection_constant,
};

const SHARPEST: f64 = 1e-15;

fn order(nu: f64) -> Order {
    Order::new(nu).unwrap()
}

/// Refused at `asked`, and the best estimate encloses what a tolerance that can be met gives.
fn assert_carries(what: &str, asked: f64, met: f64, of: impl Fn(Tolerance) -> Result<Estimate>) {
    let exact =
        of(Tolerance::new(met).unwrap()).unwrap_or_else(|e| panic!("{what} at {met:e}: {e}"));
    assert_encloses(what, of(Tolerance::new(asked).unwrap()), exact.value, exact.error);
}

fn assert_encloses(what: &str, found: Result<Estimate>, exact: f64, uncertain: f64) {
    let refused = found.expect_err(what);
    let Error::ToleranceNotMet { asked, reached, best: Some(best), why, .. } = refused else {
        panic!("{what}: {refused:?}");
    };
    let off = (best.value - exact).abs();
    assert!(
        off <= best.error + uncertain,
        "{what}: {best} is {off:e} off {exact:e} +- {uncertain:e}"
    );
    assert!(reached > asked && reached == best.relative_error(), "{what}: {reached:e}");
    assert!(!why.is_empty());
    assert_eq!(Estimate::or_best(Err(refused)), Ok(best));
}

#[test]
fn closures_carry_the_norm_and_not_its_square() {
    let root = Function::from_fn(&[0.0, 1.0], |x: f64| 3e100 * x.sqrt()).unwrap();
    assert_carries("seminorm", SHARPEST, 1e-10, |t| root.seminorm(order(0.75), t));
    assert_carries("norm", SHARPEST, 1e-10, |t| root.norm(order(0.75), t));
    assert_encloses(
        "L^3",
        root.lp(3.0, Tolerance::new(SHARPEST).unwrap()),
        3e100 * 0.4f64.cbrt(),
        1e86,
    );
    assert_encloses("mean", root.mean(Tolerance::new(SHARPEST).unwrap()), 2e100, 1e86);
    let slope = Function::from_positions(&[0.0, 1.0], |p| p.x().powf(-0.2)).unwrap();
    let whole = Function::from_fn(&[0.0, 1.0], |x: f64| x.powf(0.8) / 0.8).unwrap();
    let whole = whole.with_gradient(vec![slope]);
    assert_carries("norm of order 1 + nu", SHARPEST, 1e-9, |t| {
        whole.norm(order(0.2).plus_one(), t)
    });
}

#[test]
fn a_jump_that_is_not_declared_is_located_and_has_an_honest_value() {
    for at in [0.2, 0.3, 0.37, 0.62, 0.9] {
        let jumps = |x: f64| if x < at { 0.0 } else { 1.0 };
        let u = Function::from_fn(&[0.0, 1.0], jumps).unwrap();
        let declared = Function::from_fn(&[0.0, at, 1.0], jumps).unwrap();
        let exact = declared.seminorm(order(0.25), Tolerance::new(1e-6).unwrap()).unwrap();
        let found = u.seminorm(order(0.25), Tolerance::new(1e-6).unwrap()).unwrap();
        let off = (found.value - exact.value).abs();
        assert!(off <= found.error + exact.error, "jump at {at}: {found}, {exact}");
        assert!(found.relative_error() <= 1e-6, "jump at {at}: {found}");
    }
}

#[test]
fn piecewise_functions_and_dual_norms_carry_theirs() {
    // Values that differ by few ulps on elements that shrink fast.
    let partition = Mesh::geometric(40, 0.1, 2.0).unwrap();
    let values: Vec<f64> =
        (0..=partition.len()).map(|k| 1e-200 * (1.0 + 1e-9 * k as f64)).collect();
    let u = Function::linears(&partition, &values).unwrap();
    let found =
        Estimate::or_best(u.seminorm(order(0.9), Tolerance::new(SHARPEST).unwrap())).unwrap();
    assert!(found.relative_error() < 1e-13, "{found}");
    let signs = |n: usize| {
        let values: Vec<f64> = (0..n).map(|k| if k % 2 == 0 { 5.0 } else { -5.0 }).collect();
        Function::piecewise(&Mesh::uniform(n, 1.0).unwrap(), 0, &values).unwrap()
    };
    // The square of a functional's dual norm is what is computed inside.
    for (of, asked, met) in
        [(DualOf::Slobodeckij, 1e-13, 1e-3), (DualOf::Interpolation, SHARPEST, 1e-12)]
    {
        assert_carries("dual norm", asked, met, |t| signs(50).dual_norm(of, order(0.5), t));
    }
}

#[test]
fn constants_carry_theirs() {
    let zone = || 0.0..0.25;
    assert_carries("gamma", SHARPEST, 1e-11, |t| {
        gamma(order(0.4), Constraint::mean_zero_on(zone()), t).map(|found| found.constant)
    });
    let attained = |t| {
        gamma(order(0.4), Constraint::mean_zero_on(zone()), t)
            .map(|found| (found.constant, found.extremal().unwrap()))
            .map(|found| found.0)
    };
    assert_carries("gamma with its function", SHARPEST, 1e-11, attained);
    assert_carries("element", SHARPEST, 1e-12, |t| {
        interpolation_constant(Domain::Interval(1.0), ErrorNorm::L2, 0.3, t)
            .map(|found| found.constant)
    });
    assert_carries("projection", SHARPEST, 1e-10, |t| {
        projection_constant(Domain::Interval(1.0), ErrorNorm::Dual, 0.3, t)
            .map(|found| found.constant)
    });
    let near =
        gamma(Order::half_plus(1e-6).unwrap(), Constraint::vanishing_at(0.0), Tolerance::fast())
            .map(|found| found.constant);
    assert!(matches!(near, Err(Error::ToleranceNotMet { best: None, .. })), "{near:?}");
}

#[test]
fn overlapping_triangles_are_named() {
    let nodes = vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.1, 0.1], [1.0, 0.2], [0.2, 1.0]];
    let apart = Triangles::new(&nodes, &[[0, 1, 2], [3, 4, 5]]);
    assert_eq!(apart.unwrap_err().to_string(), "triangles 0 and 1 overlap");
    // folded over a common edge, and the same triangle twice
    assert!(matches!(
        Triangles::new(&nodes, &[[0, 1, 2], [0, 1, 3]]),
        Err(Error::Overlap { triangles: [0, 1] })
    ));
    assert!(Triangles::new(&nodes, &[[0, 1, 2], [0, 2, 1]]).is_err());
    let mut many = Triangles::grid([60, 60], 1.0).unwrap();
    many = many.mapped(|[x, y]| [x + 0.2 * (y / 7.0).sin(), y * y + y]).unwrap();
    let folded =
        |[x, y]: [f64; 2]| if (x - 30.0).abs() < 0.3 && y == 930.0 { [x - 1.5, y] } else { [x, y] };
    assert!(matches!(many.mapped(folded), Err(Error::Overlap { .. })));
    // thin triangles side by side do not
    let thin = vec![[0.0, 0.0], [1.0, 0.0], [0.5, 1e-9], [0.5, 1.0], [0.3, -1.0]];
    assert!(Triangles::new(&thin, &[[0, 1, 2], [0, 2, 3], [2, 1, 3], [0, 1, 4]]).is_ok());
}
