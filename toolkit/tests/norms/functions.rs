//! Every kind of function by its norms: intervals, curves, triangulations, formulas and values.

use fractional_sobolev::{Curve, DualOf, Function, Mesh, Order, Result, Tolerance, Triangles};

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
fn jumps_on_curves_are_finite_below_one_half() -> Result<()> {
    let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let curve = Curve::algebraic(&square, 2, 1.0)?;
    let side = Function::on_curve(&curve, 0, &[1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0])?;
    assert!(side.seminorm(Order::new(0.4)?, Tolerance::fast()).is_ok());
    assert!(side.seminorm(Order::HALF, Tolerance::fast()).is_err()); // a jump
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
fn interpolation_parts_and_lebesgue_norms_of_a_parabola() -> Result<()> {
    let asked = Tolerance::balanced();
    // x² is of degree two: interpolated exactly; its derivative 2x is restricted to (1/2, 1)
    let u = Function::interpolate(&Mesh::uniform(2, 1.0)?, 2, |x| x * x)?;
    assert_eq!([u.degree()?, u.mesh()?.len()], [2, 2]);
    assert!((u.mean(asked)?.value - 1.0 / 3.0).abs() < 1e-14);
    assert!((u.lp(3.0, asked)?.value - (1.0f64 / 7.0).cbrt()).abs() < 1e-8);
    assert!((u.lp(f64::INFINITY, asked)?.value - 1.0).abs() < 1e-8);
    let slope = u.derivative()?.restrict(1..2)?;
    assert!((slope.value_on(0, 1.0)? - 2.0).abs() < 1e-14);
    Ok(())
}

#[test]
fn a_declared_corner_is_finite_below_its_order() -> Result<()> {
    // r^{-1/4} cos φ on a triangle, in H^s for s < 3/4
    let triangle = Triangles::new(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]], &[[0, 1, 2]])?;
    let w = Function::from_plane_positions(&triangle, &[(0, -0.25)], |at| {
        at.radius(0).powf(-0.25) * at.angle(0).cos()
    })?;
    assert!(w.seminorm(Order::new(0.74)?, Tolerance::balanced()).is_ok());
    assert!(w.seminorm(Order::new(0.75)?, Tolerance::balanced()).is_err());
    Ok(())
}
