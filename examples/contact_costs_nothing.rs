//! Contact costs nothing in the limit: the error beside that of interpolation, whatever the contact set.
//!
//! `cargo run --release --example contact_costs_nothing -- --levels 4-20`

use example_frame::figures::{Axis, Chart, Series};
use example_frame::rates::STEADY;
use example_frame::{Column, Finding, Format, Headline, Result, Table, progress};
use experiments::convergence::{Levels, StripCase};
use experiments::proof::{CostRow, CostStudy};
use experiments::{KnownLevel, known_levels};
use signorini::cone::Cone;
use signorini::problems::KnownSolution;
use signorini::strip::{Reference, StripKind};
use std::process::ExitCode;

example_frame::options! {
    /// Compare the error with that of interpolation and of the best approximation without constraint
    pub struct Options {
        /// Mesh sizes h = 2^-COARSEST ... 2^-FINEST on strips
        #[arg(long, default_value = "4-16")]
        pub levels: Levels,
        /// Meshes of 4 x 4 ... n x n squares for the problem in closed form, n = 2 to this power
        #[arg(long, default_value_t = 7, value_parser = clap::value_parser!(u32).range(4..=11))]
        pub finest: u32,
    }
    memory(options) {
        let strips = 190.0 * options.levels.reference_cells() as f64;
        strips.max(1300.0 * f64::from(2 * options.finest).exp2())
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

/// Strips; the scalar problem in closed form with one transition, nodal and midpoint cone.
pub type Computed = (Vec<CostStudy>, [Vec<KnownLevel>; 2]);

/// Solves every scene on every mesh.
pub fn compute(options: &Options) -> Result<Computed> {
    let (mut cases, cones) = (Vec::new(), [Cone::Nodal, Cone::Midpoint]);
    let bar = progress((SCENES.len() * 2) as u64);
    for (name, tau) in SCENES {
        for cone in cones {
            let (kind, reference, levels) = (StripKind::Scalar, Reference::Nested, options.levels);
            let source = name.parse()?;
            let case = StripCase { kind, levels, source, tau, cone, reference, positions: 1 };
            cases.push(CostStudy::of(&case, || ())?);
            bar.inc(1);
        }
    }
    let mesh = |c| known_levels(&KnownSolution::one_transition(None), c, options.finest, || ());
    Ok((cases, [mesh(cones[0])?, mesh(cones[1])?]))
}

/// Sums of squares on strips, quadrature on meshes, relative.
const ROUNDING: f64 = 1e-6;

/// What decides: the quotients on the finest meshes, and Falk's lemma on all.
pub fn findings((cases, meshes): &Computed) -> Vec<Finding> {
    let to_interpolation = |case: &CostStudy| case.limit(CostRow::over_interpolation);
    let nodal = cases.iter().filter(|case| case.cone == Cone::Nodal).flat_map(|case| &case.rows);
    let falk = nodal.map(|row| row.error / (row.interpolation + 2.0 * row.consistency)).reduce(f64::max);
    let least = cases.iter().flat_map(|case| &case.rows).map(CostRow::over_best).reduce(f64::min);
    let natural = cases.iter().filter(|case| case.tau > 2.0).filter_map(to_interpolation);
    let mesh = meshes.iter().filter_map(|levels| KnownLevel::limit(levels));
    let mesh = mesh.map(|(quotient, change)| (quotient, change + ROUNDING));
    let kept = |case: &&CostStudy| case.cone == Cone::Nodal && case.scene == cases[0].scene;
    let limits: Vec<(f64, f64)> = cases.iter().filter(kept).filter_map(to_interpolation).collect();
    let falls = limits.windows(2).map(|pair| (pair[0].0 - pair[1].0, pair[0].1 + pair[1].1));
    let fall = falls.min_by(|a, b| (a.0 - a.1).total_cmp(&(b.0 - b.1)));
    let orders = cases.iter().filter_map(CostStudy::off).filter(|off| off.1 < STEADY);
    let bar = |part: Option<f64>| part.map(|part| (part, ROUNDING));
    vec![
        Finding::claim("falk", "the squared error takes at most {percent} % of the bound by Falk's lemma")
            .number_or(bar(falk), "no mesh")
            .at_most(1.0 + 2.0 * ROUNDING, "|u - I^h u|^2 + 2 int sigma I^h u, nodal cone"),
        Finding::claim("best", "the error is at least {value} times that of the best approximation")
            .number_or(bar(least), "no mesh")
            .at_least(1.0 - 2.0 * ROUNDING, "the best approximation"),
        Finding::claim("natural", "natural transitions: {value} times the error of interpolation")
            .largest_of(natural, "no mesh")
            .at_most(1.001, "1, to a thousandth on these meshes")
            .told(),
        Finding::claim("mesh", "the same on meshes, a problem in closed form: {value} times")
            .largest_of(mesh, "no mesh")
            .at_most(1.01, "1, to a hundredth on these meshes"),
        Finding::remark("supremum", "where tau is not reached the limit may be larger: up to {value} times")
            .largest_of(cases.iter().filter_map(to_interpolation), "no mesh")
            .at_least(1.0, "the error of interpolation")
            .told(),
        Finding::claim("falls", "the larger tau the smaller the limit for transitions, by {value} or more")
            .number_or(fall, "fewer than two limits")
            .at_least(0.0, "no change"),
        Finding::claim("order", "steady orders of the term over h^(2 tau - 2) are {value} off at most")
            .largest_of(orders, "no steady order")
            .at_most(0.15, "the sum over the gaps longer than h"),
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

fn table(cases: &[CostStudy]) -> Table {
    let (three, two) = (Format::Fixed(4), Format::Significant(2));
    let columns = vec![
        Column::new("scene", "scene", Format::Plain, ""),
        Column::new("tau", "tau", Format::Plain, "its regularity, a supremum"),
        Column::new("cone", "cone", Format::Plain, ""),
        Column::new("interpolation", "/ interp", three, "|u - u_h| / |u - I^h u|, 64 reference cells in h"),
        Column::new("interpolation_half", "+-", two, "its change over the last two halvings of h"),
        Column::new("best", "/ best", three, "|u - u_h| over that of the best approximation, no constraint"),
        Column::new("best_half", "+-", two, ""),
        Column::new("order", "order", three, "order of the term over h^(2 tau - 2), tau at most 2"),
        Column::new("order_half", "+-", two, ""),
        Column::new("theory", "theory", three, "the same by counting gaps"),
    ];
    let mut table = Table::new(columns);
    for case in cases {
        let quotients = [CostRow::over_interpolation, CostRow::over_best].map(|q| case.limit(q));
        let mut row = vec![case.scene.to_string().into(), case.tau.into(), case.cone.to_string().into()];
        for found in quotients.into_iter().chain([case.order()]) {
            row.extend([found.map(|f| f.0).into(), found.map(|f| f.1).into()]);
        }
        row.push(case.theory().into());
        table.push(row);
    }
    table
}

/// |u − u_h| over |u − I^h u| against h, nodal cone.
fn draw(cases: &[CostStudy]) -> Chart {
    let (x, y) = (Axis::logarithmic("h, mesh size"), Axis::linear("error / error of interpolation"));
    let mut chart = Chart::new("What contact costs, nodal cone", x, y);
    for CostStudy { scene, tau, rows, .. } in cases.iter().filter(|case| case.cone == Cone::Nodal) {
        let points = rows.iter().map(|row| (1.0 / row.n as f64, row.over_interpolation())).collect();
        chart = chart.with(Series::line_and_points(format!("{scene}, τ = {tau}"), points));
    }
    chart
}

fn main() -> ExitCode {
    example_frame::main(run)
}
