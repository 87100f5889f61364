//! The rates of the introduction, (E1)-(E4), (N1), (N2), each beside what a scene of its regularity shows.
//!
//! | label | regularity | contact set | printed rate |
//! | --- | --- | --- | --- |
//! | (E1) | 1 < τ ≤ 3/2 | any | h^{τ−1} |
//! | (E2) | 3/2 < τ < 2 | any | h^{τ/2−1/4} |
//! | (E2) | 3/2 < τ < 2 | finitely many transitions | h^{τ−1} |
//! | (E3) | τ = 2 | any | h^{3/4} |
//! | (E3) | τ = 2 | finitely many transitions | h |ln h|^{1/2}, h |ln h|^{1/4}, h |
//! | (E4) | τ = 2 + ε, τ = 5/2 | any | h |
//! | (N1) | 3/2 < τ < 2 | any | h^{τ/2−1/4+(τ−3/2)²} |
//! | (N2) | τ = 2 | any | h |ln h|^{1/2} |
//!
//! "Any" contact set is shown by a fat Cantor set (τ < 2) and by many transitions; a natural transition inside an edge is r^{3/2}, τ = 5/2.

use signorini::cone::Cone;
use signorini::convergence::Fit;
use signorini::convergence::NoMemory;
use signorini::convergence::{Quantity, RateStudy};
use signorini::convergence::{RateStrip, SceneFamily};
use signorini::error::Result;
use signorini::figures::{Axis, Chart, Series};
use signorini::report::{Column, Format, Headline, Table, Verdict};
use signorini::scenes::StripScene;
use signorini::scenes::TransitionPowers;
use signorini::strip::{Levels, StripKind};

/// What a scene of a row is.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Shape {
    Transition(TransitionPowers),
    Many,
    FatCantor,
}

/// One printed rate.
#[derive(Debug, Clone, Copy)]
struct Printed {
    label: &'static str,
    tau: f64,
    assumption: &'static str,
    rate: &'static str,
    exponent: f64,
    shape: Shape,
}

fn printed() -> Vec<Printed> {
    let one = |tau: f64| Shape::Transition(TransitionPowers::of_regularity(tau));
    // In H² itself: slopes like |ln r|^{−1}.
    let in_h2 = Shape::Transition(TransitionPowers { opening: 1.0, pressure: 0.0, logarithm: 1.0 });
    let row = |label, tau, assumption, rate, exponent, shape| Printed {
        label,
        tau,
        assumption,
        rate,
        exponent,
        shape,
    };
    vec![
        row("(E1)", 1.4, "", "h^(tau-1)", 0.4, one(1.4)),
        row("(E1)", 1.5, "", "h^(tau-1)", 0.5, one(1.5)),
        row("(E2)", 1.75, "", "h^(tau/2-1/4)", 0.625, Shape::FatCantor),
        row("(E2)", 1.75, "finite", "h^(tau-1)", 0.75, one(1.75)),
        row("(N1)", 1.75, "", "h^(tau^2-5tau/2+2)", 0.6875, Shape::FatCantor),
        row("(N1)", 1.75, "", "h^(tau^2-5tau/2+2)", 0.6875, Shape::Many),
        row("(E3)", 2.0, "", "h^(3/4)", 0.75, Shape::Many),
        row("(E3)", 2.0, "finite", "h |ln h|^(1/2) ... h", 1.0, in_h2),
        row("(N2)", 2.0, "", "h |ln h|^(1/2)", 1.0, in_h2),
        row("(E4)", 2.25, "", "h", 1.0, one(2.25)),
        row("(E4)", 2.5, "", "h", 1.0, one(2.5)),
    ]
}

/// Number of rows.
pub fn introduction_rows() -> usize {
    printed().len()
}

/// The studies of all rows in both cones; scenes that belong to two rows are solved once.
///
/// # Errors
/// Those of [`RateStrip::study`].
pub fn introduction_studies(
    levels: Levels,
    reference: usize,
    report: &mut dyn FnMut(),
) -> Result<Vec<[RateStudy; 2]>> {
    let mut strip = RateStrip::new(StripKind::Scalar, levels, reference)?;
    let mut store = NoMemory;
    printed()
        .into_iter()
        .map(|row| {
            let family = family(&row, levels)?;
            let mut study = |cone| strip.study(&family, cone, &mut store, &mut || ());
            let pair = [study(Cone::Nodal)?, study(Cone::Midpoint)?];
            report();
            Ok(pair)
        })
        .collect()
}

fn family(row: &Printed, levels: Levels) -> Result<SceneFamily<'static>> {
    let (coarsest, tau) = (levels.coarsest_cells(), row.tau);
    let powers = match row.shape {
        Shape::Transition(powers) => powers,
        Shape::Many => {
            let source = StripScene::Transitions { gaps: 11 };
            return SceneFamily::named(&source, tau, StripKind::Scalar, coarsest, 1);
        }
        Shape::FatCantor => {
            let source = StripScene::FatCantor { depth: 30 };
            return SceneFamily::named(&source, tau, StripKind::Scalar, coarsest, 1);
        }
    };
    let cell = 1.0 / coarsest as f64;
    let start = (0.4 / cell).floor() * cell;
    // One and two thirds of a cell: doubling exchanges them.
    let member = move |i: usize, cells| powers.data(start + (i + 1) as f64 / 3.0 * cell, cells);
    let name = if powers.logarithm > 0.0 { "transition in H^2" } else { "transition" };
    Ok(SceneFamily { name: name.to_owned(), tau, count: 2, member: Box::new(member) })
}

/// Table, verdict and quoted numbers.
///
/// # Errors
/// None besides those of a table.
pub fn introduction_headline(studies: &[[RateStudy; 2]]) -> Result<Headline> {
    let three = Format::Fixed(3);
    let mut table = Table::new(vec![
        Column::new("label", "label", Format::Plain, ""),
        Column::new("tau", "tau", Format::Plain, "u in H^tau (supremum, but for \"transition in H^2\")"),
        Column::new("assumption", "set", Format::Plain, "finite: only for finitely many transitions"),
        Column::new("rate", "printed rate", Format::Plain, ""),
        Column::new("exponent", "exp", three, "exponent of h in it"),
        Column::new("scene", "scene", Format::Plain, ""),
        Column::new("nodal", "nodal", three, "measured order, nodal cone"),
        Column::new("nodal_half", "+-", three, ""),
        Column::new("midpoint", "midp.", three, "measured order, midpoint cone"),
        Column::new("midpoint_half", "+-", three, ""),
        Column::new("left_out", "out", Format::Plain, "levels left out"),
    ]);
    let (mut short, mut without) = (f64::INFINITY, 0);
    let mut quotes = Vec::new();
    for (k, (row, pair)) in printed().iter().zip(studies).enumerate() {
        let fits: Vec<Option<Fit>> = pair.iter().map(|study| study.fit(Quantity::Error)).collect();
        for (fit, cone) in fits.iter().zip(["nodal", "midpoint"]) {
            let Some(fit) = fit else { continue };
            // Where the printed rate has a logarithm, or the error has one, the power of h alone lies a little below.
            let allowance = if row.tau == 2.0 { LOGARITHM } else { 0.0 };
            short = short.min(fit.order + fit.half_width + allowance - row.exponent);
            quotes.push((format!("introduction.{}.{cone}.order", k + 1), fit.order));
            quotes.push((format!("introduction.{}.{cone}.half", k + 1), fit.half_width));
        }
        without += usize::from(fits.iter().any(Option::is_none));
        table.push(vec![
            row.label.into(),
            row.tau.into(),
            row.assumption.into(),
            row.rate.into(),
            row.exponent.into(),
            pair[0].scene.trim_start_matches("scalar ").split(':').next().unwrap_or("").into(),
            fits[0].map(|fit| fit.order).into(),
            fits[0].map(|fit| fit.half_width).into(),
            fits[1].map(|fit| fit.order).into(),
            fits[1].map(|fit| fit.half_width).into(),
            pair.iter().map(RateStudy::left_out).sum::<usize>().into(),
        ]);
    }
    let claim = "(E1)-(E4) known before, (N1), (N2) new: the printed rates are reached by every scene";
    let measured = if without > 0 {
        format!("in {without} rows too few levels count for an order")
    } else {
        "in every row the error falls like h^(min(tau-1, 1)), whatever the contact set; at tau = 2 up to a logarithm"
            .to_owned()
    };
    let verdict = if without > 0 {
        Verdict::NotConfirmed("an order needs more levels".to_owned())
    } else if short >= 0.0 {
        Verdict::HoldsLoose("up to h^(1/4): every row shows the optimal order".to_owned())
    } else {
        Verdict::NotConfirmed(format!("an order stays {:.3} below its printed rate", -short))
    };
    let mut headline = Headline::new("Introduction", claim, table, measured, verdict);
    quotes.into_iter().for_each(|(key, value)| headline.quote(key, value));
    Ok(headline)
}

/// |ln h|^{1/2} takes 1/(2 |ln h|) from the local order: 0.07 at h = 2^{−10}, the middle of the finer levels.
const LOGARITHM: f64 = 0.07;

/// Printed exponents over τ, and measured orders with bars.
pub fn introduction_chart(studies: &[[RateStudy; 2]]) -> Chart {
    let x = Axis::linear("regularity tau of the solution, u in H^tau").range(1.0, 2.6);
    let mut chart = Chart::new(
        "Rates of the introduction, printed and measured",
        x,
        Axis::linear("exponent of h").range(0.0, 1.1),
    );
    let curve = |from: f64, to: f64, f: fn(f64) -> f64| -> Vec<(f64, f64)> {
        (0..=50).map(|k| from + (to - from) * f64::from(k) / 50.0).map(|tau| (tau, f(tau))).collect()
    };
    chart = chart
        .with(Series::line("(E1)", curve(1.0, 1.5, |tau| tau - 1.0)))
        .with(Series::line("(E2)", curve(1.5, 2.0, |tau| 0.5 * tau - 0.25)))
        .with(Series::dashed("(E2) finite set", curve(1.5, 2.0, |tau| tau - 1.0)))
        .with(Series::line("(N1)", curve(1.5, 2.0, |tau| tau * tau - 2.5 * tau + 2.0)))
        .with(Series::line("(E4)", curve(2.0, 2.6, |_| 1.0)));
    for (k, name) in ["measured, nodal cone", "measured, midpoint cone"].into_iter().enumerate() {
        let shift = 0.012 * (k as f64 - 0.5);
        let fits: Vec<(f64, Fit)> =
            studies.iter().filter_map(|pair| Some((pair[k].tau, pair[k].fit(Quantity::Error)?))).collect();
        let points = fits.iter().map(|(tau, fit)| (tau + shift, fit.order)).collect();
        chart = chart
            .with(Series::points(name, points).bars(fits.iter().map(|(_, fit)| fit.half_width).collect()));
    }
    chart
}
