//! Every kind of function by its norms: intervals, curves, triangulations, formulas and values.

use fractional_sobolev::{
    Curve, DualOf, Error, Function, Mesh, Order, Result, Tolerance, Triangles, closed_forms,
};

#[test]
fn lebesgue_norms_on_a_square() -> Result<()> {
    let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let curve = Curve::algebraic(&square, 4, 2.0)?;
    let values: Vec<f64> = curve.nodes().iter().map(|x| x[0]).collect();
    let x = Function::on_curve(&curve, 1, &values)?;
    // 1/4 on two sides, 1 and 0 on the others
    assert!((x.lp(3.0, 1e-10)?.value - 1.5f64.cbrt()).abs() < 1e-14);
    assert_eq!(x.lp(f64::INFINITY, 1e-10)?.value, 1.0);
    Ok(())
}

#[test]
fn constants_on_a_curve_have_their_dual_norms() -> Result<()> {
    let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let one = Function::on_curve(&Curve::algebraic(&square, 2, 1.0)?, 1, &[1.0; 8])?;
    for of in [DualOf::Slobodeckij, DualOf::Interpolation, DualOf::InterpolationZero] {
        // attained by 1 itself, of eigenvalue 0: the L² norm
        assert!((one.dual_norm(of, 0.5, 1e-8)?.value - 2.0).abs() < 1e-7);
    }
    Ok(())
}

#[test]
fn a_corner_counts_like_an_interval() -> Result<()> {
    // 0 on one leg of a right angle, the distance from its corner on the other: 1 + 1
    let corner = [[0.0, 1.0], [0.0, 0.0], [1.0, 0.0]];
    let mesh = Mesh::uniform(1, 1.0)?;
    let curve = Curve::open(&corner, &[mesh.clone(), mesh])?;
    let u = Function::on_curve(&curve, 1, &[0.0, 0.0, 1.0])?;
    let asked = Tolerance::reference();
    assert!((u.seminorm(Order::HALF, asked)?.value.powi(2) - 2.0).abs() < 1e-12);
    assert!((u.norm(0.0, asked)?.value.powi(2) - 1.0 / 3.0).abs() < 1e-14);
    assert!((u.norm(Order::HALF, asked)?.value.powi(2) - 7.0 / 3.0).abs() < 1e-12);
    Ok(())
}

#[test]
fn jumps_on_curves_are_finite_below_one_half() -> Result<()> {
    let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let curve = Curve::algebraic(&square, 2, 1.0)?;
    let side = Function::on_curve(&curve, 0, &[1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0])?;
    assert!(side.seminorm(Order::new(0.4)?, Tolerance::fast()).is_ok());
    assert!(side.seminorm(Order::HALF, Tolerance::fast()).is_err()); // a jump
    Ok(())
}

#[test]
fn dual_norms_of_a_logarithm_are_ordered() -> Result<()> {
    let log = Function::from_positions(&[0.0, 0.3, 1.0], |at| at.log_distance_to(1))?;
    let found = log.norm(-0.5, 1e-6)?;
    assert!(found.value < log.norm(0.0, 1e-4)?.value);
    assert!(log.dual_norm(DualOf::InterpolationZero, 0.5, 1e-6)?.value < found.value);
    Ok(())
}

#[test]
fn interpolants_of_a_parabola_have_their_rate() -> Result<()> {
    // x² and its interpolants: the rate of order 1/2
    let u = Function::from_fn(&[0.0, 1.0], |x| x * x)?;
    let error = |n: usize| {
        let mesh = Mesh::uniform(n, 1.0)?;
        let values: Vec<f64> = mesh.nodes().iter().map(|x| x * x).collect();
        u.minus(&Function::linears(&mesh, &values)?)?.seminorm(0.5, 1e-6)
    };
    let rate = (error(100)?.value / error(200)?.value).log2();
    assert!((rate - 1.5).abs() < 0.01);
    Ok(())
}

#[test]
fn lebesgue_norms_of_an_interpolation_error() -> Result<()> {
    // x² and its interpolant on 10 elements: at most h²/4, h² ∫ t(1-t) = h²/6 on average
    let u = Function::from_fn(&[0.0, 1.0], |x| x * x)?;
    let mesh = Mesh::uniform(10, 1.0)?;
    let values: Vec<f64> = mesh.nodes().iter().map(|x| x * x).collect();
    let field = Function::linears(&mesh, &values)?;
    assert!((u.minus(&field)?.lp(f64::INFINITY, 1e-6)?.value - 0.0025).abs() < 1e-8);
    assert!((u.minus(&field)?.lp(1.0, 1e-6)?.value - 0.01 / 6.0).abs() < 1e-8);
    Ok(())
}

#[test]
fn means_have_the_rate_of_the_dual_norm() -> Result<()> {
    // the means of a smooth function on n elements: of order h in L², h^{3/2} in the dual norm
    let u = Function::from_fn(&[0.0, 1.0], |x: f64| (3.0 * x).sin())?;
    let error = |n: usize| {
        let h = 1.0 / n as f64;
        let means: Vec<f64> = (0..n)
            .map(|k| {
                let middle = 3.0 * h * (k as f64 + 0.5);
                middle.sin() * (1.5 * h).sin() / (1.5 * h)
            })
            .collect();
        let field = Function::piecewise(&Mesh::uniform(n, 1.0)?, 0, &means)?;
        let sines = u.minus(&field)?.dual_norm(DualOf::InterpolationZero, 0.5, 1e-4)?;
        let found = u.minus(&field)?.norm(-0.5, 1e-4)?;
        assert!(sines.value < u.minus(&field)?.norm(0.0, 1e-4)?.value);
        Ok::<f64, Error>(found.value)
    };
    assert!(((error(64)? / error(128)?).log2() - 1.5).abs() < 0.1);
    Ok(())
}

#[test]
fn a_root_of_the_logarithm_has_its_closed_form() -> Result<()> {
    // |ln x|^(1/4): the distance from the break 0 is exact, the one from 1 enters by ln(1 - t)
    let u = Function::from_positions(&[0.0, 1.0], |at| match at.anchor() {
        0 => (-at.offset().ln()).powf(0.25),
        _ => (-at.offset().ln_1p()).powf(0.25),
    })?;
    let exact = closed_forms::log_power_seminorm_squared(0.25)?.value.sqrt();
    let found = u.seminorm(Order::HALF, Tolerance::fast())?;
    assert!((found.value / exact - 1.0).abs() < 1e-4);
    Ok(())
}

#[test]
fn lebesgue_norms_and_the_mean_of_a_formula() -> Result<()> {
    let u = Function::from_fn(&[0.0, 1.0], |x: f64| 1.0 - x)?;
    let asked = Tolerance::balanced();
    assert!((u.norm(0.0, asked)?.value - 1.0 / 3f64.sqrt()).abs() < 1e-8);
    assert!((u.lp(4.0, asked)?.value - 0.2f64.powf(0.25)).abs() < 1e-8);
    assert!((u.mean(asked)?.value - 0.5).abs() < 1e-8);
    Ok(())
}

#[test]
fn interpolation_parts_and_lebesgue_norms_of_a_parabola() -> Result<()> {
    let asked = Tolerance::balanced();
    // x² is of degree two: interpolated exactly; its derivative 2x is restricted to (1/2, 1)
    let u = Function::interpolate(&Mesh::uniform(2, 1.0)?, 2, |x| x * x)?;
    assert_eq!([u.degree()?, u.mesh()?.len()], [2, 2]);
    assert!((u.mean(asked)?.value - 1.0 / 3.0).abs() < 1e-14);
    assert!((u.lp(3.0, asked)?.value - (1.0f64 / 7.0).cbrt()).abs() < 1e-8);
    assert!((u.lp(f64::INFINITY, asked)?.value - 1.0).abs() < 1e-8);
    let slope = u.derivative()?.restrict(1..2)?;
    assert!((slope.value(0, 1.0)? - 2.0).abs() < 1e-14);
    Ok(())
}

#[test]
fn orders_above_one_of_a_parabola() -> Result<()> {
    let (order, asked) = (Order::HALF, Tolerance::reference());
    // x²/2 by three values, and its derivative
    let mesh = Mesh::uniform(1, 1.0)?;
    let u = Function::piecewise(&mesh, 2, &[0.0, 0.125, 0.5])?;
    let slope = Function::piecewise(&mesh, 1, [[0.0, 1.0]].as_flattened())?;
    assert!((slope.norm(0.0, asked)?.value.powi(2) - 1.0 / 3.0).abs() < 1e-14);
    assert!((slope.norm(order, asked)?.value.powi(2) - 4.0 / 3.0).abs() < 1e-12);
    assert!((u.norm(order.plus_one(), asked)?.value.powi(2) - 83.0 / 60.0).abs() < 1e-12);
    Ok(())
}

#[test]
fn a_declared_corner_is_finite_below_its_order() -> Result<()> {
    // r^{-1/4} cos φ on a triangle, in H^s for s < 3/4
    let triangle = Triangles::new(vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]], vec![[0, 1, 2]])?;
    let w = Function::from_plane_positions(&triangle, &[(0, -0.25)], |at| {
        at.radius(0).powf(-0.25) * at.angle(0).cos()
    })?;
    assert!(w.seminorm(Order::new(0.74)?, Tolerance::balanced()).is_ok());
    assert!(w.seminorm(Order::new(0.75)?, Tolerance::balanced()).is_err());
    Ok(())
}

#[test]
fn a_formula_on_a_square_has_its_closed_form() -> Result<()> {
    let square = Triangles::grid([1, 1], 1.0)?;
    let x = Function::from_plane_positions(&square, &[], |at| at.x()[0])?;
    let order = Order::new(0.7)?;
    let norm = x.seminorm(order, Tolerance::balanced())?;
    let exact = closed_forms::coordinate_on_square_seminorm_squared(order)?.sqrt()?;
    assert!((norm.value / exact.value - 1.0).abs() < 1e-8);
    Ok(())
}

#[test]
fn formulas_on_a_square_with_their_gradient() -> Result<()> {
    let (order, asked) = (Order::new(0.3)?, Tolerance::balanced());
    let on_square = |f: fn(f64) -> f64| {
        Function::from_plane_positions(&Triangles::grid([1, 1], 1.0)?, &[], move |at| f(at.x()[0]))
    };
    let (x, one, zero) = (on_square(|x| x)?, on_square(|_| 1.0)?, on_square(|_| 0.0)?);
    let (l2, full) = (x.norm(0.0, asked)?.value, x.norm(order, asked)?.value);
    assert!((l2 - 1.0 / 3f64.sqrt()).abs() < 1e-8 && full > l2);
    // of order 1 + s: the gradient (1, 0) adds its L² norm, one
    let both = x.with_gradient(vec![one, zero]).norm(order.plus_one(), asked)?.value;
    assert!((both.powi(2) - 4.0 / 3.0).abs() < 1e-7);
    Ok(())
}

#[test]
fn values_on_a_square_with_their_gradient() -> Result<()> {
    let x = Function::on_triangles(&Triangles::grid([1, 1], 1.0)?, 1, &[0.0, 1.0, 0.0, 1.0])?;
    let (order, asked) = (Order::new(0.3)?, Tolerance::balanced());
    assert!((x.norm(0.0, asked)?.value - 1.0 / 3f64.sqrt()).abs() < 1e-14);
    assert!(x.norm(order, asked)?.value > x.norm(0.0, asked)?.value);
    // the gradient (1, 0) on both triangles has no seminorm: ||x||²_{1+s} = 1/3 + 1
    assert!((x.norm(order.plus_one(), asked)?.value.powi(2) - 4.0 / 3.0).abs() < 1e-8);
    assert!((x.seminorm(1.0, asked)?.value - 1.0).abs() < 1e-14);
    Ok(())
}

#[test]
fn constants_have_no_seminorm() -> Result<()> {
    let triangle = Triangles::new(vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]], vec![[0, 1, 2]])?;
    assert!(Function::on_triangles(&triangle, 0, &[2.0])?.seminorm(0.25, 1e-6)?.value < 1e-12);
    Ok(())
}

#[test]
fn a_reference_value_on_a_triangle() -> Result<()> {
    let triangle = Triangles::new(vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]], vec![[0, 1, 2]])?;
    let x = Function::on_triangles(&triangle, 1, &[0.0, 1.0, 0.0])?;
    let norm = x.seminorm(Order::HALF, Tolerance::reference())?;
    assert!((norm.value.powi(2) - 0.501_532_942_386_591_2).abs() < 1e-14);
    Ok(())
}

#[test]
fn the_square_integral_on_a_triangle() -> Result<()> {
    // x on the triangle (0, 0), (2, 0), (0, 1): ∫ x² = 8/12
    let triangle = Triangles::new(vec![[0.0, 0.0], [2.0, 0.0], [0.0, 1.0]], vec![[0, 1, 2]])?;
    let x = Function::on_triangles(&triangle, 1, &[0.0, 2.0, 0.0])?;
    assert!((x.norm(0.0, 1e-12)?.value.powi(2) - 2.0 / 3.0).abs() < 1e-14);
    Ok(())
}
