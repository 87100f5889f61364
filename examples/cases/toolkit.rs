//! What `speed_for_accuracy` measures: the numerical functions of the toolkit, each beside a value found
//! another way.

use experiments::largest;
use fractional_sobolev::{
    Constraint, Domain, ErrorNorm, Estimate, Function, Gram, Mesh, Order, Result, Tolerance, Work,
    closed_forms, gamma, interpolation_constant, projection_constant,
};

/// A name, the value found another way, and what is asked.
pub type Case<'a> = (&'static str, f64, Box<dyn Fn(Tolerance) -> Result<Estimate> + 'a>);

/// Everything that is measured; a later function adds one entry.
pub fn cases<'a>() -> Result<Vec<Case<'a>>> {
    let half = Order::HALF;
    let power = |name, a: f64, nu| -> Result<Case<'a>> {
        let order = Order::new(nu)?;
        let u = Function::from_fn(&[0.0, 1.0], move |x: f64| x.powf(a))?;
        let exact = closed_forms::power_seminorm_squared(a, order)?.value.sqrt();
        Ok((name, exact, Box::new(move |tolerance| u.seminorm(order, tolerance))))
    };
    let best = |name, nu, norm, exact| -> Result<Case<'a>> {
        let order = Order::new(nu)?;
        Ok((
            name,
            exact,
            Box::new(move |tolerance| {
                let found = interpolation_constant(Domain::Interval(1.0), norm, order, tolerance)?;
                Ok(found.constant)
            }),
        ))
    };
    let zone = |name, nu, theta, exact| -> Result<Case<'a>> {
        let order = Order::new(nu)?;
        Ok((
            name,
            exact,
            Box::new(move |tolerance| {
                gamma(order, Constraint::mean_zero_on(0.0..theta), tolerance).map(|found| found.constant)
            }),
        ))
    };
    let slow = Function::from_positions(&[0.0, 1.0], |at| match at.anchor() {
        0 => (-at.offset().ln()).powf(0.25),
        _ => (-at.offset().ln_1p()).powf(0.25),
    })?;
    let slow_exact = closed_forms::log_power_seminorm_squared(0.25)?.value.sqrt();
    let values: Vec<f64> = (0..=1000).map(|i| f64::from(500 - (i - 500i32).abs()) / 500.0).collect();
    let hat = Function::linears(&Mesh::uniform(1000, 1.0)?, &values)?;
    let hat_exact = closed_forms::hat_seminorm_squared(0.0, 0.5, 0.5, 0.0, half)?.value.sqrt();
    let graded = Mesh::geometric(1999, 1e-30f64.powf(1.0 / 1999.0), 1.0)?;
    let x: Vec<f64> = (0..=2000).map(|i| ((i * 7919) % 1000) as f64 / 1000.0).collect();
    let matrix = Gram::new(&graded, half, 1e-8)?.to_dense()?;
    let dense: Vec<f64> = (0..=2000).map(|i| (0..=2000).map(|j| matrix[(i, j)] * x[j]).sum()).collect();
    let product = move |tolerance: Tolerance| {
        let fast = Gram::new(&graded, half, tolerance)?.apply(&x)?;
        let apart: Vec<f64> = fast.iter().zip(&dense).map(|(a, b)| a - b).collect();
        Estimate::new(1.0 + largest(&apart) / largest(&dense), tolerance.relative(), Work::default())
    };
    let one = Function::piecewise(&Mesh::uniform(8, 1.0)?, 0, &[1.0; 8])?;
    // γ₁(1/2)², the best constant of (4.7) at r = 1/2
    let whole: f64 = 0.291_564_029_207_657_16;
    Ok(vec![
        power("closure x^0.6, nu 0.25", 0.6, 0.25)?,
        power("closure x^0.001, nu 1/2", 0.001, 0.5)?,
        power("closure x^0.51, nu 0.99", 0.51, 0.99)?,
        (
            "closure |ln x|^0.25, nu 1/2",
            slow_exact,
            Box::new(move |tolerance| slow.seminorm(half, tolerance)),
        ),
        ("fast product and its setup, geometric 1e-30, N 2000", 1.0, Box::new(product)),
        ("hat on 1000 elements, nu 1/2", hat_exact, Box::new(move |tolerance| hat.seminorm(half, tolerance))),
        ("dual norm of a constant", 1.0, Box::new(move |t| one.norm(-half, t))),
        best("interpolation C_L2, nu 1/2", 0.5, ErrorNorm::L2, 0.092_742_524_652_174_63)?,
        best("interpolation C_H1, nu 0.99", 0.99, ErrorNorm::Derivative, 0.032_024_593_023_715_79)?,
        (
            "projection C*, r 1/2",
            whole * whole,
            Box::new(|tolerance| {
                let found = projection_constant(Domain::Interval(1.0), ErrorNorm::Dual, 0.5, tolerance)?;
                Ok(found.constant)
            }),
        ),
        zone("gamma, nu 0.25, theta 0.01", 0.25, 1e-2, 1.656_712_117_564_16)?,
        zone("gamma, nu 0.49, theta 1e-300", 0.49, 1e-300, 2_758.865_095_337_738_5)?,
        zone("gamma, nu 1/2, theta 1e-40", 0.5, 1e-40, 3.738_285_316_256_439)?,
        zone("gamma, nu 0.99, theta 1e-4", 0.99, 1e-4, 0.064_321_434_320_780_88)?,
    ])
}
