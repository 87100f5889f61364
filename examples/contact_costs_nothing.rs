//! Contact costs nothing in the limit: the error beside that of interpolation, whatever the contact set.
//!
//! `cargo run --release --example contact_costs_nothing -- --levels 4-14`

use example_frame::figures::{Axis, Chart, Series};
use example_frame::{Column, Finding, Format, Headline, Result, Table, progress};
use signorini::cone::Cone;
use signorini::proof::{CostRow, contact_cost, cost_limit, term_order};
use signorini::scenes::{ClosedForm, ClosedFormLevel, StripCase, StripScene};
use signorini::strip::{Levels, Reference, StripKind};
use std::process::ExitCode;

example_frame::options! {
    /// Compare the error with that of interpolation and of the best approximation without constraint
    pub struct Options {
        /// Mesh sizes h = 2^-COARSEST ... 2^-FINEST on strips
        #[arg(long, default_value = "4-12")]
        pub levels: Levels,
        /// Meshes of 4 x 4 ... n x n squares for the problem in closed form, n = 2 to this power
        #[arg(long, default_value_t = 7, value_parser = clap::value_parser!(u32).range(4..=11))]
        pub finest: u32,
    }
}

/// A scene with its regularity.
const SCENES: [(&str, f64); 7] = [
    ("transitions:3", 1.55),
    ("transitions:3", 1.75),
    ("transitions:3", 2.0),
    ("transitions:3", 2.5),
    ("cantor:0.3", 1.75),
    ("fat-cantor", 1.6),
    ("fat-cantor", 1.9),
];

/// One scene on a strip in one cone.
pub struct Case {
    /// Scene and regularity.
    pub scene: (&'static str, f64),
    /// The cone.
    pub cone: Cone,
    /// Coarsest mesh first.
    pub rows: Vec<CostRow>,
}

/// Strips; the scalar problem in closed form with one transition, nodal and midpoint cone.
pub type Computed = (Vec<Case>, [Vec<ClosedFormLevel>; 2]);

/// Solves every scene on every mesh.
pub fn compute(options: &Options) -> Result<Computed> {
    let (mut cases, cones) = (Vec::new(), [Cone::Nodal, Cone::Midpoint]);
    let bar = progress((SCENES.len() * 2) as u64);
    for (name, tau) in SCENES {
        for cone in cones {
            let source: StripScene = name.parse()?;
            let (kind, reference, levels) = (StripKind::Scalar, Reference::Nested, options.levels);
            let case = StripCase { kind, levels, source, tau, cone, reference, positions: 1 };
            cases.push(Case { scene: (name, tau), cone, rows: contact_cost(&case, || ())? });
            bar.inc(1);
        }
    }
    let mesh = |c| ClosedForm { two_transitions: false, lame: None }.levels(c, options.finest, || ());
    Ok((cases, [mesh(cones[0])?, mesh(cones[1])?]))
}

/// Sums of squares on strips, quadrature on meshes, relative.
const ROUNDING: f64 = 1e-6;

/// What decides: the quotients on the finest meshes, and Falk's lemma on all.
pub fn findings((cases, meshes): &Computed) -> Vec<Finding> {
    let natural = || cases.iter().filter(|case| case.scene.1 > 2.0);
    let larger = |a: (f64, f64), b: (f64, f64)| if b.0 + b.1 > a.0 + a.1 { b } else { a };
    let to_interpolation = |case: &Case| cost_limit(&case.rows, CostRow::over_interpolation);
    let nodal = cases.iter().filter(|case| case.cone == Cone::Nodal).flat_map(|case| &case.rows);
    let falk = nodal.map(|row| row.error / (row.interpolation + 2.0 * row.consistency)).reduce(f64::max);
    let least = cases.iter().flat_map(|case| &case.rows).map(CostRow::over_best).reduce(f64::min);
    let ratio = |level: &ClosedFormLevel| level.error / level.interpolation;
    let mesh = meshes.iter().filter_map(|levels| {
        let [.., before, last] = levels.as_slice() else { return None };
        Some((ratio(last), (ratio(last) - ratio(before)).abs() + ROUNDING))
    });
    let order = natural().filter_map(|case| term_order(&case.rows, 2.0)).map(|e| (e.value, e.uncertainty));
    let bar = |part: Option<f64>| part.map(|part| (part, ROUNDING));
    vec![
        Finding::claim("falk", "the squared error takes at most {percent} % of the bound by Falk's lemma")
            .number_or(bar(falk), "no mesh")
            .at_most(1.0 + 2.0 * ROUNDING, "|u - I^h u|^2 + 2 int sigma I^h u, nodal cone"),
        Finding::claim("best", "the error is at least {value} times that of the best approximation")
            .number_or(bar(least), "no mesh")
            .at_least(1.0 - 2.0 * ROUNDING, "the best approximation"),
        Finding::claim(
            "natural",
            "natural transitions: {value} times the error of interpolation in the limit",
        )
        .number_or(natural().filter_map(to_interpolation).reduce(larger), "no mesh")
        .at_most(1.01, "1, to a hundredth on these meshes")
        .told(),
        Finding::claim("mesh", "the same on meshes, a problem in closed form: {value} times")
            .number_or(mesh.reduce(larger), "no mesh")
            .at_most(1.01, "1, to a hundredth on these meshes"),
        Finding::remark("supremum", "where tau is not reached the limit may be larger: up to {value} times")
            .number_or(cases.iter().filter_map(to_interpolation).reduce(larger), "no mesh")
            .at_least(1.0, "the error of interpolation")
            .told(),
        Finding::remark("order", "natural transitions: the term over h^2 falls like h^{value}")
            .number_or(order.reduce(larger), "no order")
            .within(0.15, 1.0, "one segment at each transition, h^(3/2) h^(1/2) h over h^2"),
    ]
}

/// Solves, decides and shows.
pub fn run(options: &Options) -> Result<Headline> {
    let computed = compute(options)?;
    let claim = "|u - u_h|^2 <= |u - I^h u|^2 + o(h^(2 tau - 2)) for u in H^tau, whatever the contact set";
    let mut headline =
        Headline::new("Theorem 3.1, the limit", claim, table(&computed.0), findings(&computed));
    headline.draw(&options.output, "contact_costs_nothing", || Ok(draw(&computed.0)))?;
    Ok(headline)
}

fn table(cases: &[Case]) -> Table {
    let (three, two) = (Format::Fixed(4), Format::Significant(2));
    let columns = vec![
        Column::new("scene", "scene", Format::Plain, ""),
        Column::new("tau", "tau", Format::Plain, "its regularity, a supremum"),
        Column::new("cone", "cone", Format::Plain, ""),
        Column::new("interpolation", "/ interp", three, "|u - u_h| / |u - I^h u|, finest mesh"),
        Column::new("interpolation_half", "+-", two, "its change over the last two halvings of h"),
        Column::new("best", "/ best", three, "|u - u_h| over that of the best approximation, no constraint"),
        Column::new("best_half", "+-", two, ""),
        Column::new("order", "order", three, "order of the term over h^(2 tau - 2), tau at most 2"),
        Column::new("order_half", "+-", two, ""),
    ];
    let mut table = Table::new(columns);
    for Case { scene, cone, rows } in cases {
        let order = term_order(rows, scene.1.min(2.0)).map(|e| (e.value, e.uncertainty));
        let quotients = [CostRow::over_interpolation, CostRow::over_best].map(|q| cost_limit(rows, q));
        let mut row = vec![scene.0.into(), scene.1.into(), cone.to_string().into()];
        for found in quotients.into_iter().chain([order]) {
            row.extend([found.map(|f| f.0).into(), found.map(|f| f.1).into()]);
        }
        table.push(row);
    }
    table
}

/// |u − u_h| over |u − I^h u| against h, nodal cone.
fn draw(cases: &[Case]) -> Chart {
    let (x, y) = (Axis::logarithmic("h, mesh size"), Axis::linear("error / error of interpolation"));
    let mut chart = Chart::new("What contact costs, nodal cone", x, y);
    for Case { scene: (name, tau), rows, .. } in cases.iter().filter(|case| case.cone == Cone::Nodal) {
        let points = rows.iter().map(|row| (1.0 / row.n as f64, row.over_interpolation())).collect();
        chart = chart.with(Series::line_and_points(format!("{name}, τ = {tau}"), points));
    }
    chart
}

fn main() -> ExitCode {
    example_frame::main(run)
}
