//! Pictures of Lemma 5.2, one frame per value of a parameter: extremal functions as the zone shrinks, growth
//! of the constant as the order passes 1/2. All frames of one sequence share their axes.

use crate::figures::{Axis, Chart, PALETTE, Series};
use crate::{Cell, Column, Format, Headline, Output, Result, Table};
use experiments::growth::{ScalingPoint, printed_growth};
use fractional_sobolev::{Constraint, Order, Tolerance, gamma};

/// Points per cell of the graded mesh: the pictures resolve every scale between θ and 1.
const PER_CELL: usize = 6;
/// Where the horizontal axis begins; u is nearly constant there.
const NEAREST: f64 = 1e-8;

/// The functions with mean zero on (0, θ) for which ‖u‖₀/|u|_ν is largest, ‖u‖₀ = 1, one curve per order; the
/// zone is shaded, and the legend carries γ_θ(ν).
///
/// # Errors
/// As for [`fractional_sobolev::gamma`].
///
/// ```
/// use example_frame::poincare::extremal_chart;
/// use fractional_sobolev::{Order, Tolerance};
/// let chart = extremal_chart(&[Order::HALF], 1e-2, Tolerance::fast())?;
/// assert!(chart.svg()?.contains("γ = 0.8428"));
/// # Ok::<(), example_frame::Error>(())
/// ```
pub fn extremal_chart(orders: &[Order], theta: f64, tolerance: Tolerance) -> Result<Chart> {
    let x =
        Axis::logarithmic("x, distance from the end where the zone is (interval = 1)").range(NEAREST, 1.0);
    let y = Axis::linear("u, extremal function").range(-0.5, 1.5);
    let title = format!("Extremal functions of Lemma 5.2, zone of length θ = {theta:e}");
    let mut chart = Chart::new(title, x, y).with_bands("zone (0, θ)", vec![(NEAREST, theta)], PALETTE[6]);
    for &order in orders {
        let (gamma, u) = gamma(order, Constraint::mean_zero_on(0.0..theta), tolerance)
            .map(|found| (found.constant, found.extremal()))?;
        let name = format!("ν = {order}, γ = {:.4}", gamma.value);
        let mut points = vec![(NEAREST, u.value(&[NEAREST]))];
        points.extend(u.profile(PER_CELL).into_iter().filter(|&(x, _)| x > NEAREST));
        chart = chart.with(Series::line(name, points));
    }
    Ok(chart)
}

/// γ_θ(ν) for zones (0, θ) of the given lengths, beside the growth printed in (5.1)-(5.3) through the first
/// of them.
///
/// # Errors
/// As for [`gamma`].
pub fn growth_chart(order: Order, lengths: &[f64], tolerance: Tolerance) -> Result<Chart> {
    let mut computed = Vec::new();
    for &theta in lengths {
        computed.push((theta, gamma(order, Constraint::mean_zero_on(0.0..theta), tolerance)?.constant.value));
    }
    let growth = |theta: f64| printed_growth(order, theta);
    let printed = computed.first().map_or(Vec::new(), |&(first, constant)| {
        lengths.iter().map(|&theta| (theta, constant * growth(theta) / growth(first))).collect()
    });
    let law = match order.offset() {
        below if below < 0.0 => "(5.1), θ^(ν−1/2)",
        0.0 => "(5.2), ln(1/θ)",
        _ => "(5.3), a constant",
    };
    let x = Axis::logarithmic("θ, length of the zone (interval = 1)").range(1e-6, 1.0);
    let y = Axis::logarithmic("γ, Poincaré constant").range(0.1, 200.0);
    Ok(Chart::new(format!("Poincaré constant of order ν = {order}"), x, y)
        .with(Series::points("computed", computed))
        .with(Series::dashed(format!("{law}, through the first point"), printed)))
}

/// Orders of the frames of the growth: both regimes and the border between them.
const FRAMES: [f64; 9] = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9];

/// Saves extremal functions, one frame per θ < 1, and the growth of the constant, one frame per order.
///
/// # Errors
/// Those of the charts and of their files.
pub fn frames(headline: &mut Headline, output: &Output, orders: &[Order], lengths: &[f64]) -> Result<()> {
    for &theta in lengths.iter().filter(|&&theta| theta < 1.0) {
        let chart = || extremal_chart(orders, theta, Tolerance::fast());
        headline.draw(output, &format!("lemma_5_2_extremal_{theta:e}"), chart)?;
    }
    for nu in FRAMES {
        let chart = || growth_chart(Order::new(nu)?, lengths, Tolerance::fast());
        headline.draw(output, &format!("lemma_5_2_growth_{nu}"), chart)?;
    }
    Ok(())
}

/// γ_θ(ν) against θ, the points of one order together: computed, and dashed the law that holds as θ → 0.
pub fn curves_chart(points: &[(ScalingPoint, f64)]) -> Chart {
    let x = Axis::logarithmic("θ, length of the zone (interval = 1)");
    let mut chart =
        Chart::new("Poincaré constants of Lemma 5.2", x, Axis::logarithmic("γ, Poincaré constant"));
    for (k, same) in points.chunk_by(|(a, _), (b, _)| a.order == b.order).enumerate() {
        let (order, colour) = (same[0].0.order, PALETTE[k % PALETTE.len()]);
        let computed = same.iter().map(|(p, _)| (p.theta, p.found.gamma.value)).collect();
        let law: Vec<(f64, f64)> = same.iter().filter_map(|(p, _)| Some((p.theta, p.law?.value))).collect();
        chart = chart.with(Series::points(format!("ν = {order}, computed"), computed).colour(colour));
        if !law.is_empty() {
            chart = chart.with(Series::dashed(format!("ν = {order}, law as θ → 0"), law).colour(colour));
        }
    }
    chart
}

/// The file of [`curves_chart`]; with one order only its name carries the order.
pub fn figure_name(orders: &[Order]) -> String {
    match orders {
        [one] => format!("lemma_5_2_gamma_{one}").replace(['/', '.'], "_"),
        _ => "lemma_5_2_gamma".to_owned(),
    }
}

/// One row per zone: the constant, its bounds, and its quotients by both laws.
pub fn scaling_table(points: &[(ScalingPoint, f64)]) -> Table {
    Table::new(columns()).with_rows(points.iter().map(|(p, seconds)| {
        let mut row: Vec<Cell> = vec![p.order.value().into(), p.theta.into(), p.zone.to_string().into()];
        row.extend([p.found.gamma.value, p.found.gamma.error, p.found.lower, p.found.upper].map(Cell::from));
        row.extend([p.over_printed.into(), p.over_law.map(|e| e.value).into(), (*seconds).into()]);
        row
    }))
}

fn columns() -> Vec<Column> {
    let seven = Format::Significant(7);
    vec![
        Column::new("nu", "nu", Format::Plain, ""),
        Column::new("theta", "theta", Format::Plain, ""),
        Column::hidden("zone"),
        Column::new("gamma", "gamma", Format::Significant(11), "computed constant"),
        Column::new("error", "error", Format::Scientific(0), "its estimated error"),
        Column::new("lower", "lower", seven, "quotient of a function"),
        Column::new("upper", "upper", seven, "from gamma_1 and a dual norm, no eigenproblem"),
        Column::new(
            "printed",
            "/printed",
            Format::Significant(4),
            "gamma / (theta^(nu-1/2), ln(1/theta), 1)",
        ),
        Column::new("law", "/limit law", seven, "gamma / (law of the limit theta -> 0)"),
        Column::hidden("seconds"),
    ]
}
