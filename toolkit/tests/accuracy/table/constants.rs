//! Poincaré constants, moments, and constants of interpolation.

use super::SplitMix;
use super::{Family, ask, draw, formula, number, order, order_of, printed, rows};
use fractional_sobolev::{
    Constraint, Domain, ErrorNorm, Estimate, Function, Mesh, Moment, Order, Result, Triangles, Work, Zones,
    gamma, interpolation_constant, law, moment, projection_constant,
};

const GAMMA: &str = include_str!("../../reference/gamma_reference.json");
const LIMITS: &str = include_str!("../../reference/limits_reference.json");
const ELEMENTS: &str = include_str!("../../reference/interpolation_reference.json");

/// All of them.
pub(super) fn families(each: usize, random: &mut SplitMix) -> Result<Vec<Family>> {
    let mut all = zones(each, random)?;
    all.extend(moments(each, random)?);
    all.extend(elements(each, random)?);
    Ok(all)
}

fn zones(each: usize, random: &mut SplitMix) -> Result<Vec<Family>> {
    let (reference, limits) = (rows(GAMMA)?, rows(LIMITS)?);
    let ends: Vec<_> = reference.as_array().into_iter().flatten().collect();
    let ends = draw(each.min(ends.len()), || {
        let row = ends[random.below(ends.len())];
        let (order, theta) = (order_of(row, "nu_decimal")?, number(row, "theta_decimal")?);
        Ok((
            printed(row, "gamma")?,
            ask(move |t| gamma(order, Constraint::mean_zero_on(0.0..theta), t).map(|found| found.constant)),
        ))
    })?;
    let inside: Vec<_> = limits["location"].as_array().into_iter().flatten().collect();
    let inside = draw(each.min(inside.len()), || {
        let row = inside[random.below(inside.len())];
        let theta = number(row, "theta")?;
        let zone = match row["a"].as_str() {
            Some("(1-theta)/2") => Zones::from_start_and_length(0.5 * (1.0 - theta), theta)?,
            _ => Zones::from_start_and_length(number(row, "a")?, theta)?,
        };
        let (order, digits) = (order_of(row, "nu")?, number(row, "digits")?);
        let value = number(row, "gamma")?;
        let exact = Estimate::new(value, value * 10f64.powf(1.0 - digits), Work::default())?;
        Ok((
            exact,
            ask(move |t| gamma(order, Constraint::mean_zero_on(&zone), t).map(|found| found.constant)),
        ))
    })?;
    let list = |key: &str| limits[key].as_array().cloned().unwrap_or_default();
    let small = list("B").into_iter().map(|row| {
        let order = order_of(&row, "nu")?;
        Ok((printed(&row, "B")?, ask(move |t| law(order, 0.0, t)?.factor())))
    });
    let small = small.collect::<Result<Vec<_>>>()?;
    let points = list("gamma0").into_iter().map(|row| {
        let order = order_of(&row, "nu")?;
        Ok((
            printed(&row, "gamma0")?,
            ask(move |t| gamma(order, Constraint::vanishing_at(0.0), t).map(|found| found.constant)),
        ))
    });
    let points = points.collect::<Result<Vec<_>>>()?;
    Ok(vec![
        Family { name: "zone at end", least: 0.0, cases: ends },
        Family { name: "zone inside", least: 0.0, cases: inside },
        Family { name: "end limit", least: 0.0, cases: small },
        Family { name: "point", least: 0.0, cases: points },
    ])
}

fn moments(each: usize, random: &mut SplitMix) -> Result<Vec<Family>> {
    let weight = |random: &mut SplitMix| [Moment::Mass, Moment::FromFreeEnd][random.below(2)];
    let half = draw(each, || {
        let (e, m) = (10f64.powf(random.between(-4.0, -0.2)), weight(random));
        let exact = moment(Order::HALF, e..1.0, m, 1e-3)?.closed_form()?;
        Ok((exact, ask(move |t| moment(Order::HALF, e..1.0, m, t).map(|found| found.constant))))
    })?;
    let strong = draw(each.min(3), || {
        let order = order(random, 0.1, 0.9)?;
        let (e, m) = (random.between(0.02, 0.98), weight(random));
        let [lower, upper] = moment(order, e..1.0, m, 1e-3)?.bounds()?;
        let exact = Estimate::new(0.5 * (lower + upper), 0.5 * (upper - lower), Work::default())?;
        Ok((exact, ask(move |t| moment(order, e..1.0, m, t).map(|found| found.constant))))
    })?;
    Ok(vec![
        Family { name: "moment 1/2", least: 0.0, cases: half },
        Family { name: "moments", least: 0.0, cases: strong },
    ])
}

fn elements(each: usize, random: &mut SplitMix) -> Result<Vec<Family>> {
    let reference = rows(ELEMENTS)?;
    let mut constants = Vec::new();
    for row in reference.as_array().into_iter().flatten() {
        let order = order_of(row, "nu")?;
        for (norm, key) in [(ErrorNorm::L2, "C_L2"), (ErrorNorm::Derivative, "C_H1")] {
            let on_unit = move |t| interpolation_constant(Domain::Interval(1.0), norm, order, t);
            constants.push((printed(row, key)?, ask(move |t| on_unit(t).map(|found| found.constant))));
        }
    }
    let waves = draw(each.min(4), || {
        let elements = 1 + random.below(8);
        let exact = formula(std::f64::consts::FRAC_1_PI / elements as f64)?;
        let mesh = Domain::Mesh(Mesh::uniform(elements, 1.0)?);
        let on_mesh = move |t| projection_constant(mesh.clone(), ErrorNorm::L2, 1.0, t);
        Ok((exact, ask(move |t| on_mesh(t).map(|found| found.constant))))
    })?;
    Ok(vec![
        Family { name: "element", least: 0.0, cases: constants },
        Family { name: "projection", least: 1e-4, cases: waves },
    ])
}

/// On (0, h) the H¹ constant squared is h^{2ν} sup (‖e′‖² + h² ‖e‖²)/|v|²_ν of the unit element: what the function
/// adds to its derivative is of the order h².
#[test]
fn the_function_adds_the_square_of_the_length_to_the_h1_constant() {
    let order = Order::new(0.3).unwrap();
    let squared = |h: f64, norm| {
        let found = interpolation_constant(Domain::Interval(h), norm, order, 1e-10).unwrap();
        (found.constant.value / h.powf(order.value())).powi(2)
    };
    let gain = |h: f64| squared(h, ErrorNorm::H1) - squared(h, ErrorNorm::Derivative);
    let quotient = gain(0.2) / gain(0.1);
    assert!((quotient - 4.0).abs() < 0.05, "{quotient}");
}

#[test]
fn the_dual_constant_of_the_projection_has_the_power_of_the_length() {
    let on = |h: f64| projection_constant(Domain::Interval(h), ErrorNorm::Dual, 0.3, 1e-8).unwrap().constant;
    let quotient = on(2.0).value / on(1.0).value;
    assert!((quotient / 2f64.powf(0.8) - 1.0).abs() < 1e-12, "{quotient}");
}

/// On the triangle (0, 0), (1, 0), (0, 1), for u = x²/2 and its interpolant: ‖x − 1/2‖² = 1/24; and the limit at
/// s = 1, where (1 − s) |v|²_s becomes π/2 ‖∇v‖².
#[test]
fn the_constant_of_a_triangle_is_above_a_parabola_and_has_its_limit() {
    let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
    let constant = |s: f64| {
        let found = interpolation_constant(Domain::Triangle(corners), ErrorNorm::Derivative, s, 1e-3);
        found.unwrap().constant.value
    };
    let x = Triangles::new(corners.to_vec(), vec![[0, 1, 2]]).unwrap();
    let x = Function::on_triangles(&x, 1, &[0.0, 1.0, 0.0]).unwrap();
    for s in [0.25, 0.6, 0.9] {
        let quotient = (1f64 / 24.0).sqrt() / x.seminorm(s, 1e-12).unwrap().value;
        assert!(quotient < constant(s) && constant(s) < 2.5 * quotient, "{s}: {quotient}, {}", constant(s));
    }
    let normalised = (std::f64::consts::FRAC_PI_2 / 0.01).sqrt() * constant(0.99);
    assert!((normalised / constant(1.0) - 1.0).abs() < 0.02, "{normalised}");
}
