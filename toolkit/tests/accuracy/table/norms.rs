//! Norms on intervals: closures, functions on meshes, dual norms, fast products.

use super::SplitMix;
use super::largest;
use super::{Ask, Family, ask, draw, formula, number, order, order_of, printed, rows};
use fractional_sobolev::{
    DualOf, Estimate, Function, Gram, Mesh, Order, Result, Tolerance, Work, closed_forms,
};

const REFERENCE: &str = include_str!("../../reference/closed_forms.json");

/// All of them.
pub(super) fn families(each: usize, random: &mut SplitMix) -> Result<Vec<Family>> {
    let mut all = closed()?;
    all.extend(closures(each, random)?);
    all.extend(meshes(each, random)?);
    Ok(all)
}

fn closed() -> Result<Vec<Family>> {
    let reference = rows(REFERENCE)?;
    let of = |function: &str| -> Result<Vec<(Estimate, Ask)>> {
        let chosen = reference.as_array().into_iter().flatten().filter(|row| row["function"] == function);
        chosen
            .map(|row| {
                let asked: Ask = if function == "x^a" {
                    let (a, order) = (number(row, "a")?, order_of(row, "nu")?);
                    ask(move |_| closed_forms::power_seminorm_squared(a, order))
                } else {
                    let alpha = number(row, "alpha")?;
                    ask(move |_| closed_forms::log_power_seminorm_squared(alpha))
                };
                Ok((printed(row, "seminorm_sq")?, asked))
            })
            .collect()
    };
    Ok(vec![
        Family { name: "power", least: 0.0, cases: of("x^a")? },
        Family { name: "log power", least: 0.0, cases: of("|ln x|^alpha")? },
    ])
}

fn closures(each: usize, random: &mut SplitMix) -> Result<Vec<Family>> {
    let powers = draw(each, || {
        let order = order(random, 0.02, 0.98)?;
        let a = order.value() - 0.5 + random.between(0.05, 2.0);
        let u = Function::from_fn(&[0.0, 1.0], move |x: f64| x.powf(a))?;
        Ok((closed_forms::power_seminorm_squared(a, order)?.sqrt()?, ask(move |t| u.seminorm(order, t))))
    })?;
    let logarithms = draw(each, || {
        let alpha = random.between(0.02, 0.4);
        let u = Function::from_log_distances(&[0.0, 1.0], move |at| match at.anchor() {
            0 => (-at.log_distance()).powf(alpha),
            _ => (-at.offset().ln_1p()).powf(alpha),
        })?;
        let exact = closed_forms::log_power_seminorm_squared(alpha)?.sqrt()?;
        Ok((exact, ask(move |t| u.seminorm(Order::HALF, t))))
    })?;
    let kinks = draw(each, || {
        let (order, c) = (order(random, 0.02, 0.98)?, random.between(0.01, 0.99));
        let u = Function::from_fn(&[0.0, c, 1.0], move |x| (x / c).min((1.0 - x) / (1.0 - c)))?;
        Ok((
            closed_forms::hat_seminorm_squared(0.0, c, 1.0 - c, 0.0, order)?.sqrt()?,
            ask(move |t| u.seminorm(order, t)),
        ))
    })?;
    let lebesgue = draw(each, || {
        let (a, q) = (random.between(-0.1, 3.0), random.between(1.0, 8.0));
        let u = Function::from_fn(&[0.0, 1.0], move |x: f64| x.powf(a))?;
        Ok((formula((1.0 + q * a).powf(-1.0 / q))?, ask(move |t| u.lp(q, t))))
    })?;
    Ok(vec![
        Family { name: "u: power", least: 0.0, cases: powers },
        Family { name: "u: log", least: 0.0, cases: logarithms },
        Family { name: "u: kink", least: 0.0, cases: kinks },
        Family { name: "u: L^q", least: 0.0, cases: lebesgue },
    ])
}

fn meshes(each: usize, random: &mut SplitMix) -> Result<Vec<Family>> {
    let hats = draw(each, || {
        let (order, c) = (order(random, 0.02, 0.98)?, random.between(0.01, 0.99));
        let mesh = Mesh::graded(&[0.0, c, 1.0], 10 + random.below(60), 0.5)?;
        let values: Vec<f64> = (mesh.from_left().iter().zip(mesh.from_right()))
            .map(|(x, y)| (x / c).min(y / (1.0 - c)).clamp(0.0, 1.0))
            .collect();
        let u = Function::linears(&mesh, &values)?;
        Ok((
            closed_forms::hat_seminorm_squared(0.0, c, 1.0 - c, 0.0, order)?.sqrt()?,
            ask(move |t| u.seminorm(order, t)),
        ))
    })?;
    let jumps = draw(each, || {
        let (order, p) = (order(random, 0.02, 0.49)?, random.between(0.01, 0.99));
        let u = Function::piecewise(&Mesh::from_lengths(vec![p, 1.0 - p])?, 0, &[0.0, 1.0])?;
        Ok((
            closed_forms::jump_seminorm_squared(p, 1.0 - p, order)?.sqrt()?,
            ask(move |t| u.seminorm(order, t)),
        ))
    })?;
    let degrees = draw(each, || {
        let (order, k) = (order(random, 0.02, 0.98)?, 1 + random.below(8));
        let mesh = Mesh::uniform(1 + random.below(20), 1.0)?;
        let u = Function::interpolate(&mesh, k, move |x| x.powi(k as i32))?;
        Ok((
            closed_forms::power_seminorm_squared(k as f64, order)?.sqrt()?,
            ask(move |t| u.seminorm(order, t)),
        ))
    })?;
    let lebesgue = draw(each, || {
        let (q, k) = (random.between(1.0, 8.0), 1 + random.below(8));
        let mesh = Mesh::uniform(1 + random.below(20), 1.0)?;
        let u = Function::interpolate(&mesh, k, move |x| x.powi(k as i32))?;
        Ok((formula((1.0 + q * k as f64).powf(-1.0 / q))?, ask(move |t| u.lp(q, t))))
    })?;
    let duals = draw(each, || {
        let order = order(random, 0.02, 0.98)?;
        let mesh = Mesh::uniform(2, 1.0)?;
        // The same numbers 8/(kπ)², k odd: of a sign among cosines, of a constant among sines.
        let (of, values) = match random.below(2) {
            0 => (DualOf::Interpolation, [1.0, -1.0]),
            _ => (DualOf::InterpolationZero, [1.0, 1.0]),
        };
        let u = Function::piecewise(&mesh, 0, &values)?;
        Ok((modes(order)?, ask(move |t| u.dual_norm(of, order, t))))
    })?;
    let products = draw(each.min(6), || {
        let (order, count) = (order(random, 0.02, 0.98)?, 100 + random.below(300));
        let mesh = match random.below(2) {
            0 => Mesh::uniform(count, 1.0)?,
            _ => Mesh::geometric(count - 1, 0.9, 1.0)?,
        };
        let x: Vec<f64> = (0..=count).map(|_| random.between(-1.0, 1.0)).collect();
        let matrix = Gram::new(&mesh, order, 1e-8)?.to_dense()?;
        let dense = |i: usize| (0..=count).map(|j| matrix[(i, j)] * x[j]).sum::<f64>();
        let exact: Vec<f64> = (0..=count).map(dense).collect();
        let product = move |tolerance: Tolerance| {
            let found = Gram::new(&mesh, order, tolerance)?.apply(&x)?;
            let apart: Vec<f64> = found.iter().zip(&exact).map(|(a, b)| a - b).collect();
            let apart = largest(&apart) / largest(&exact);
            Estimate::new(1.0 + apart, tolerance.relative(), Work::default())
        };
        Ok((formula(1.0)?, ask(product)))
    })?;
    Ok(vec![
        Family { name: "P: hats", least: 0.0, cases: hats },
        Family { name: "P: jumps", least: 0.0, cases: jumps },
        Family { name: "P: degree", least: 0.0, cases: degrees },
        Family { name: "P: L^q", least: 0.0, cases: lebesgue },
        Family { name: "dual norm", least: 0.0, cases: duals },
        Family { name: "product", least: 0.0, cases: products },
    ])
}

/// (Σ 8/(kπ)² (1 + (kπ)²)^{−ν})^{1/2} over odd k, the tail by its integral.
fn modes(order: Order) -> Result<Estimate> {
    let (nu, pi, last) = (order.value(), std::f64::consts::PI, 20_000);
    let term = |k: usize| {
        let square = (k as f64 * pi).powi(2);
        8.0 / square * (1.0 + square).powf(-nu)
    };
    let sum: f64 = (0..last / 2).rev().map(|j| term(2 * j + 1)).sum();
    let tail = 4.0 / pi.powi(2) * pi.powf(-2.0 * nu) * f64::from(last as u32).powf(-1.0 - 2.0 * nu);
    Estimate::new(sum + tail / (1.0 + 2.0 * nu), 1e-13, Work::default())?.sqrt()
}
