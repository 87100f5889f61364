//! Contact costs nothing in the limit: the error beside that of interpolation, whatever the contact set.
//!
//! `cargo run --release --example contact_costs_nothing -- --levels 4-14`

use example_frame::figures::{Axis, Chart, Series};
use example_frame::{Column, Finding, Format, Headline, Result, Table, progress};
use signorini::cone::Cone;
use signorini::proof::{CostRow, Exponent, contact_cost};
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
    ("transitions:4", 1.55),
    ("transitions:4", 1.75),
    ("transitions:4", 2.0),
    ("transitions:4", 2.5),
    ("cantor:0.3", 1.75),
    ("fat-cantor", 1.6),
    ("fat-cantor", 1.9),
];

/// One scene on a strip in one cone.
pub struct Case {
    /// Its words.
    pub scene: &'static str,
    /// Its regularity.
    pub tau: f64,
    /// The cone.
    pub cone: Cone,
    /// Coarsest mesh first.
    pub rows: Vec<CostRow>,
}

impl Case {
    /// A quotient on the finest mesh, and what it changed by over the last two halvings of h.
    pub fn limit(&self, quotient: fn(&CostRow) -> f64) -> Option<(f64, f64)> {
        let last = self.rows.len().checked_sub(3)?;
        let found: Vec<f64> = self.rows[last..].iter().map(quotient).collect();
        Some((found[2], (found[2] - found[1]).abs().max((found[2] - found[0]).abs())))
    }

    /// The order in h of the consistency term over h^{2 min(tau, 2) - 2}.
    pub fn order(&self) -> Option<(f64, f64)> {
        let tau = self.tau.min(2.0);
        let points = self.rows.iter().map(|row| (1.0 / row.n as f64, row.scaled_term(tau)));
        let points: Vec<(f64, f64)> = points.filter(|point| point.1 > 0.0).collect();
        Exponent::fit(&points).ok().map(|order| (order.value, order.uncertainty))
    }
}

/// What is computed.
pub struct Computed {
    /// Strips.
    pub cases: Vec<Case>,
    /// The scalar problem in closed form with one transition, nodal and midpoint cone.
    pub meshes: [Vec<ClosedFormLevel>; 2],
}

/// Solves every scene on every mesh.
pub fn compute(options: &Options) -> Result<Computed> {
    let (mut cases, cones) = (Vec::new(), [Cone::Nodal, Cone::Midpoint]);
    let bar = progress((SCENES.len() * 2) as u64);
    for (name, tau) in SCENES {
        for cone in cones {
            let source: StripScene = name.parse()?;
            let (kind, reference, levels) = (StripKind::Scalar, Reference::Nested, options.levels);
            let case = StripCase { kind, levels, source, tau, cone, reference, positions: 1 };
            cases.push(Case { scene: name, tau, cone, rows: contact_cost(&case, || ())? });
            bar.inc(1);
        }
    }
    let scene = ClosedForm { two_transitions: false, lame: None };
    let mesh = |cone| scene.levels(cone, options.finest, || ());
    Ok(Computed { cases, meshes: [mesh(cones[0])?, mesh(cones[1])?] })
}

/// Sums of squares on strips, quadrature on meshes, relative.
const ROUNDING: f64 = 1e-6;

/// What decides: the quotients on the finest meshes, and Falk's lemma on all.
pub fn findings(computed: &Computed) -> Vec<Finding> {
    let Computed { cases, meshes } = computed;
    let smooth = |case: &&Case| case.tau > 2.0;
    let worst = |found: &mut dyn Iterator<Item = Option<(f64, f64)>>| {
        found.flatten().reduce(|a, b| if b.0 + b.1 > a.0 + a.1 { b } else { a })
    };
    let nodal = cases.iter().filter(|case| case.cone == Cone::Nodal).flat_map(|case| &case.rows);
    let falk = nodal.map(|row| row.error / (row.interpolation + 2.0 * row.consistency)).reduce(f64::max);
    let least = cases.iter().flat_map(|case| &case.rows).map(CostRow::over_best).reduce(f64::min);
    let ratio = |level: &ClosedFormLevel| level.error / level.interpolation;
    let mesh = |levels: &Vec<ClosedFormLevel>| {
        let [.., before, last] = levels.as_slice() else { return None };
        Some((ratio(last), (ratio(last) - ratio(before)).abs() + ROUNDING))
    };
    let order = cases.iter().filter(smooth).filter_map(Case::order).map(|o| (o.0 - 1.0, o.1));
    let order = order.reduce(|a, b| if b.0.abs() > a.0.abs() { b } else { a });
    vec![
        Finding::claim(
            "falk",
            "the squared error takes at most {percent} % of |u - I^h u|^2 + 2 int sigma I^h u",
        )
        .number_or(falk.map(|part| (part, ROUNDING)), "no mesh")
        .at_most(1.0, "Falk's lemma, nodal cone"),
        Finding::claim("best", "no error is below that of the best approximation: at least {value} times it")
            .number_or(least.map(|part| (part, ROUNDING)), "no mesh")
            .at_least(1.0 - 2.0 * ROUNDING, "the best approximation"),
        Finding::claim(
            "smooth",
            "natural transitions: in the limit {value} times the error of interpolation",
        )
        .number_or(
            worst(&mut cases.iter().filter(smooth).map(|c| c.limit(CostRow::over_interpolation))),
            "none",
        )
        .at_most(1.01, "1, to a hundredth on these meshes")
        .told(),
        Finding::claim("mesh", "the same on meshes, a problem in closed form: {value} times")
            .number_or(worst(&mut meshes.iter().map(mesh)), "no mesh")
            .at_most(1.01, "1, to a hundredth on these meshes"),
        Finding::remark(
            "all",
            "every scene: at most {value} times the error of interpolation on the finest mesh",
        )
        .number_or(worst(&mut cases.iter().map(|c| c.limit(CostRow::over_interpolation))), "none")
        .at_most(1.01, "1, to a hundredth")
        .told(),
        Finding::remark("order", "natural transitions: the term over h^2 has the order 1 up to {value}")
            .number_or(order, "no order")
            .within(0.1, 0.0, "one segment at each transition, h^(3/2) h^(1/2) h"),
    ]
}

/// Solves, decides and shows.
pub fn run(options: &Options) -> Result<Headline> {
    let computed = compute(options)?;
    let claim = "|u - u_h|^2 <= |u - I^h u|^2 + o(h^(2 tau - 2)) for u in H^tau, whatever the contact set";
    let found = findings(&computed);
    let mut headline = Headline::new("Theorems 3.1, 4.1, limit", claim, table(&computed), found);
    headline.draw(&options.output, "contact_costs_nothing", || Ok(draw(&computed)))?;
    Ok(headline)
}

fn table(computed: &Computed) -> Table {
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
    for case in &computed.cases {
        let mut row = vec![case.scene.into(), case.tau.into(), case.cone.to_string().into()];
        let quotients =
            [case.limit(CostRow::over_interpolation), case.limit(CostRow::over_best), case.order()];
        row.extend(quotients.iter().flat_map(|q| [q.map(|q| q.0).into(), q.map(|q| q.1).into()]));
        table.push(row);
    }
    table
}

/// |u − u_h| over |u − I^h u| against h, nodal cone.
fn draw(computed: &Computed) -> Chart {
    let (x, y) = (Axis::logarithmic("h"), Axis::linear("error over that of interpolation"));
    let mut chart = Chart::new("Contact costs nothing in the limit, nodal cone", x, y);
    for case in computed.cases.iter().filter(|case| case.cone == Cone::Nodal) {
        let points = case.rows.iter().map(|row| (1.0 / row.n as f64, row.over_interpolation())).collect();
        chart = chart.with(Series::line_and_points(format!("{}, τ = {}", case.scene, case.tau), points));
    }
    chart
}

fn main() -> ExitCode {
    example_frame::main(run)
}
