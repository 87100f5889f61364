//! Charts that several rate studies share: exponents over τ, errors over a power of h.

use super::row::RateRow;
use crate::Result;
use crate::figures::{Axis, Chart, Series};
use experiments::convergence::{Quantity, RateStudy};
use signorini::cone::Cone;
use signorini::rates::Bound;
use signorini::rates::ConvergenceOrder;

/// Orders over τ with their bars, moved aside by `shift` so that bars do not cover each other.
fn order_points(
    name: &str,
    shift: f64,
    orders: impl Iterator<Item = Option<(f64, ConvergenceOrder)>>,
) -> Series {
    let orders = orders.flatten().map(|(tau, fit)| ((tau + shift, fit.order), fit.uncertainty));
    let (points, bars) = orders.unzip();
    Series::points(name, points).bars(bars)
}

/// Exponent of a bound over (from, to).
///
/// # Errors
/// As [`Bound::exponent`].
fn exponent_curve(bound: Bound, (from, to): (f64, f64)) -> Result<Vec<(f64, f64)>> {
    const STEPS: u32 = 100;
    let taus = (1..=STEPS).map(|k| from + (to - from) * f64::from(k) / f64::from(STEPS));
    taus.map(|tau| Ok((tau, bound.exponent(tau)?))).collect()
}

/// Measured orders over τ for a chart: name, then τ and fit where there is one.
type OrderSeries = (String, Vec<Option<(f64, ConvergenceOrder)>>);

/// Exponents over τ: curves of bounds, each over its own τ, and measured orders with their bars, each series
/// `shift` beside the last.
///
/// # Errors
/// As [`Bound::exponent`].
fn exponents_chart(
    title: &str,
    (x, y): ((f64, f64), (f64, f64)),
    curves: &[(&str, Bound, (f64, f64))],
    orders: Vec<OrderSeries>,
    shift: f64,
) -> Result<Chart> {
    let x = Axis::linear("regularity tau of the solution, u in H^tau").range(x.0, x.1);
    let mut chart = Chart::new(title, x, Axis::linear("exponent of h").range(y.0, y.1));
    for (name, bound, taus) in curves {
        chart = chart.with(Series::line(*name, exponent_curve(*bound, *taus)?));
    }
    let middle = 0.5 * (orders.len() as f64 - 1.0);
    for (k, (name, fits)) in orders.into_iter().enumerate() {
        chart = chart.with(order_points(&name, shift * (k as f64 - middle), fits.into_iter()));
    }
    Ok(chart)
}

/// The paper's Figure 3.1 with measured orders: errors and roots of the terms of both cones, side by side at
/// each τ.
///
/// # Errors
/// As [`Bound::exponent`].
pub fn orders_on_curves(pairs: &[[RateRow; 2]]) -> Result<Chart> {
    let series = |(k, is_error): (usize, bool)| {
        let fit = |row: &RateRow| Some((row.study.tau, if is_error { row.error } else { row.term }?));
        let what = if is_error { "error" } else { "root of the term" };
        let name = format!("{what}, {} cone", [Cone::Nodal, Cone::Midpoint][k]);
        (name, pairs.iter().map(|pair| fit(&pair[k])).collect())
    };
    let curves = [
        ("existing: tau/2 - 1/4", Bound::Earlier, (1.5, 2.0)),
        ("the paper: tau^2 - 5tau/2 + 2", Bound::Paper, (1.5, 2.0)),
        ("optimal: tau - 1", Bound::Optimal, (1.5, 2.0)),
    ];
    let orders = [(0, true), (0, false), (1, true), (1, false)].map(series).to_vec();
    let title = "Figure 3.1: printed exponents and measured orders";
    exponents_chart(title, ((1.5, 2.0), (0.48, 1.02)), &curves, orders, 0.004)
}

/// The exponents that the introduction prints over τ, and measured orders of the error with bars, nodal cone
/// first in each pair.
///
/// # Errors
/// As [`Bound::exponent`].
pub fn printed_and_measured<'a>(pairs: impl Iterator<Item = &'a [RateRow; 2]>) -> Result<Chart> {
    let curves = [
        ("(E1)", Bound::Optimal, (1.0, 1.5)),
        ("(E2)", Bound::Earlier, (1.5, 2.0)),
        ("(E2) finite set", Bound::Optimal, (1.5, 2.0)),
        ("(N1)", Bound::Paper, (1.5, 2.0)),
        ("(E4)", Bound::Optimal, (2.0, 2.5)),
    ];
    let fit = |row: &RateRow| Some((row.study.tau, row.error?));
    let (nodal, midpoint) = pairs.map(|[nodal, midpoint]| (fit(nodal), fit(midpoint))).unzip();
    let names = ["measured, nodal cone", "measured, midpoint cone"].map(str::to_owned);
    let orders = names.into_iter().zip([nodal, midpoint]).collect();
    let title = "Rates of the introduction, printed and measured";
    exponents_chart(title, ((1.0, 2.6), (0.0, 1.1)), &curves, orders, 0.012)
}

/// error/h against h, relative to the coarsest level, beside powers of |ln h| relative to it as well.
pub fn error_over_h<'a>(
    title: &str,
    studies: impl Iterator<Item = (String, &'a RateStudy)>,
    logarithms: &[(&str, f64)],
) -> Chart {
    let x = Axis::logarithmic("mesh size h (edge of length 1)");
    let mut chart = Chart::new(title, x, Axis::linear("error over h, relative to the coarsest level"));
    let mut sizes = Vec::new();
    for (name, study) in studies {
        let points = study.points(Quantity::Error);
        let Some(&(h, e)) = points.first() else { continue };
        sizes = points.iter().map(|point| point.0).collect();
        let relative = points.iter().map(|&(k, f)| (k, f / k / (e / h))).collect();
        chart = chart.with(Series::line_and_points(name, relative));
    }
    for (name, power) in logarithms {
        let line = sizes.iter().map(|&h: &f64| (h, (h.ln() / sizes[0].ln()).powf(*power))).collect();
        chart = chart.with(Series::dashed(*name, line));
    }
    chart
}
