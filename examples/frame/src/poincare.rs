//! Pictures of Lemma 5.2, one frame per value of a parameter: extremal functions as the zone shrinks, growth
//! of the constant as the order passes 1/2. All frames of one sequence share their axes.

use signorini::figures::{Axis, Chart, PALETTE, Series};
use signorini::poincare::{Condition, Zone, extremal, gamma, printed_growth};
use signorini::sobolev::FractionalOrder;
use signorini::{Result, Tolerance};

/// Points per cell of the graded mesh: the pictures resolve every scale between θ and 1.
const PER_CELL: usize = 6;
/// Where the horizontal axis begins; u is nearly constant there.
const NEAREST: f64 = 1e-8;

/// The functions with mean zero on (0, θ) for which ‖u‖₀/|u|_ν is largest, ‖u‖₀ = 1, one curve per order; the
/// zone is shaded, and the legend carries γ_θ(ν).
///
/// # Errors
/// As for [`extremal`].
///
/// ```
/// use example_frame::poincare::extremal_chart;
/// use signorini::{Tolerance, sobolev::FractionalOrder};
/// let chart = extremal_chart(&[FractionalOrder::HALF], 1e-2, Tolerance::fast())?;
/// assert!(chart.svg()?.contains("γ = 0.8428"));
/// # Ok::<(), signorini::Error>(())
/// ```
pub fn extremal_chart(orders: &[FractionalOrder], theta: f64, tolerance: Tolerance) -> Result<Chart> {
    let x = Axis::logarithmic("x, distance from the end of the zone (interval = 1)").range(NEAREST, 1.0);
    let y = Axis::linear("u, extremal function").range(-0.5, 1.5);
    let title = format!("Extremal functions of Lemma 5.2, zone of length θ = {theta:e}");
    let mut chart = Chart::new(title, x, y).with_bands("zone (0, θ)", vec![(NEAREST, theta)], PALETTE[6]);
    for &order in orders {
        let (gamma, u) = extremal(order, Zone::end(theta)?, Condition::MeanZero, tolerance)?;
        let name = format!("ν = {order}, γ = {:.4}", gamma.value);
        let mut points = vec![(NEAREST, u.value(NEAREST))];
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
pub fn growth_chart(order: FractionalOrder, lengths: &[f64], tolerance: Tolerance) -> Result<Chart> {
    let mut computed = Vec::new();
    for &theta in lengths {
        computed.push((theta, gamma(order, Zone::end(theta)?, Condition::MeanZero, tolerance)?.value));
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
