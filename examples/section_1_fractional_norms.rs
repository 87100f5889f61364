//! Section 1, (1.1): Slobodeckij norms of a gallery of functions against ν, and where each becomes infinite.
//!
//! `cargo run --release --example section_1_fractional_norms -- --function power:0.3,hat --nu 0.7,0.8,0.9`

use example_frame::figures::{Axis, Chart, Series};
use example_frame::{Cell, Column, Finding, Format, Headline, Result, Table, timed};
use experiments::EstimateExt;
use experiments::gallery::GalleryFunction;
use fractional_sobolev::{Estimate, Order, Tolerance};
use std::process::ExitCode;

example_frame::options! {
    /// Norms of fractional order of functions of one variable
    pub struct Options {
        /// Functions: power:A, step:X, hat, log:ALPHA, samples:FILE (rows of x, value: piecewise linear)
        #[arg(long, value_delimiter = ',', default_values = ["power:0.6", "power:-0.2", "step:0.4", "hat", "log:0.25"], allow_hyphen_values = true)]
        pub function: Vec<GalleryFunction>,
        /// Orders nu in (0, 1)
        #[arg(long, value_delimiter = ',', default_values = ["0.1", "0.25", "0.45", "0.5", "0.75", "0.95"])]
        pub nu: Vec<Order>,
        /// Relative tolerance: fast, balanced, reference or a number
        #[arg(long, default_value = "1e-9")]
        pub tolerance: Tolerance,
    }
}

/// A norm that is finite.
pub struct Norm {
    /// |u|_ν as asked, and at ten times the tolerance.
    pub seminorm: [Estimate; 2],
    /// ||u||_ν.
    pub norm: f64,
    /// |u|_ν in closed form, where one is known.
    pub closed_form: Option<Estimate>,
}

/// One function at one order, the norm where the library calls it finite, and the seconds for the seminorm.
pub struct Row(pub GalleryFunction, pub Order, pub Option<Norm>, pub f64);

/// Every norm, and what it can be compared with.
pub fn compute(options: &Options) -> Result<Vec<Row>> {
    let coarser = Tolerance::new((10.0 * options.tolerance.relative()).min(0.1))?;
    let mut rows = Vec::new();
    for (function, &order) in options.function.iter().flat_map(|f| options.nu.iter().map(move |nu| (f, nu))) {
        let (seconds, outcome) = timed(|| function.finite_seminorm(order, options.tolerance))?;
        let finite = |seminorm| -> Result<Norm> {
            let u = function.function()?;
            let norm = u.norm(order, options.tolerance)?.value;
            let closed_form = function.closed_form(order)?;
            Ok(Norm { seminorm: [seminorm, u.seminorm(order, coarser)?], norm, closed_form })
        };
        let norm = outcome.map(finite).transpose()?;
        rows.push(Row(function.clone(), order, norm, seconds));
    }
    Ok(rows)
}

/// Relative distance to the closed form, and what the closed form itself may be off by.
fn true_error(norm: &Norm) -> Option<(f64, f64)> {
    norm.closed_form.map(|exact| norm.seminorm[0].relative_distance(&exact))
}

/// The largest of some numbers with uncertainties.
fn largest(numbers: impl Iterator<Item = (f64, f64)>) -> Option<(f64, f64)> {
    numbers.max_by(|a, b| a.0.total_cmp(&b.0))
}

/// What decides: where norms are said to be infinite, distances to closed forms, ten times the tolerance.
pub fn findings(options: &Options, rows: &[Row]) -> Vec<Finding> {
    let asked = options.tolerance.relative();
    let norms: Vec<&Norm> = rows.iter().filter_map(|row| row.2.as_ref()).collect();
    let wrong = rows.iter().filter(|row| row.0.is_in(row.1) != row.2.is_some()).count();
    let recognised =
        format!("the {} infinite norms are recognised, and only these", rows.len() - norms.len());
    let mut findings = vec![
        Finding::claim("infinite", recognised)
            .number(wrong as f64, 0.0)
            .at_most(0.0, "finite: x^a for nu < a + 1/2, a step below 1/2, |ln x|^a up to 1/2 for a < 1/2")
            .otherwise("{value} norms are wrongly taken for infinite or for finite")
            .told(),
    ];
    if let Some((worst, u)) = largest(norms.iter().filter_map(|norm| true_error(norm))) {
        let count = norms.iter().filter(|norm| norm.closed_form.is_some()).count();
        let share = |norm: &&Norm| {
            let (u, exact) = (norm.seminorm[0], norm.closed_form?);
            Some(((u.value - exact.value).abs() / u.error, exact.error / u.error))
        };
        findings.push(
            Finding::claim("true.error", format!("{count} norms have their closed form, {{value}} at worst"))
                .number(worst, u)
                .at_most(asked, "the tolerance asked")
                .otherwise("a norm is {value} from its closed form, further than asked")
                .told(),
        );
        findings.push(
            Finding::remark("promise", "a true error is at most {percent} % of its estimate")
                .number_or(largest(norms.iter().filter_map(share)), "no closed form")
                .at_most(1.0, "the estimate"),
        );
    }
    let changes = norms.iter().map(|norm| norm.seminorm[1].relative_distance(&norm.seminorm[0]));
    let sentence = "at ten times the tolerance no norm changes by more than {value}";
    findings.extend(largest(changes).map(|(change, _)| {
        let coarser = Finding::claim("coarser", sentence).number(change, 0.0);
        coarser.at_most(11.0 * asked, "both tolerances together")
    }));
    findings
}

/// Computes every norm and compares with closed forms.
pub fn run(options: &Options) -> Result<Headline> {
    let rows = compute(options)?;
    let claim = "the norms (1.1) are computed to the tolerance asked, and an infinite one is recognised";
    let mut headline = Headline::new("Section 1, (1.1)", claim, table(&rows), findings(options, &rows));
    let errors = rows.iter().filter_map(|row| true_error(row.2.as_ref()?));
    headline.quote("section_1.true_error", largest(errors).map_or(0.0, |error| error.0));
    headline.draw(&options.output, "section_1_fractional_norms", || Ok(draw(options, &rows)))?;
    Ok(headline)
}

fn table(rows: &[Row]) -> Table {
    let digits = Format::Significant(13);
    let columns = vec![
        Column::new("function", "function", Format::Significant(6), ""),
        Column::new("nu", "nu", Format::Plain, ""),
        Column::new("seminorm", "|u|_nu", digits, "seminorm (1.1) of order nu on (0,1)"),
        Column::new("norm", "||u||_nu", digits, ""),
        Column::new("error", "error", Format::Scientific(1), "estimated absolute error of the seminorm"),
        Column::new("true_error", "true error", Format::Scientific(1), "relative, against the closed form"),
        Column::new("seconds", "seconds", Format::Scientific(1), "for the seminorm"),
    ];
    Table::new(columns).with_rows(rows.iter().map(|row| {
        let rest = row.2.as_ref().map_or(
            ["infinite".into(), "infinite".into(), Cell::Missing, Cell::Missing],
            |norm| {
                let [value, error] = [norm.seminorm[0].value, norm.seminorm[0].error].map(Cell::from);
                [value, norm.norm.into(), error, true_error(norm).map(|error| error.0).into()]
            },
        );
        [Cell::from(row.0.to_string()), row.1.value().into()].into_iter().chain(rest).chain([row.3.into()])
    }))
}

fn draw(options: &Options, rows: &[Row]) -> Chart {
    let y = Axis::logarithmic("|u|_nu, seminorm");
    options.function.iter().fold(
        Chart::new("Seminorms of order nu", Axis::linear("nu, order"), y),
        |chart, f| {
            let own = rows.iter().filter(|row| row.0 == *f);
            let curve = own.filter_map(|row| Some((row.1.value(), row.2.as_ref()?.seminorm[0].value)));
            chart.with(Series::line_and_points(f.to_string(), curve.collect())).with_asymptote(f.last_order())
        },
    )
}

fn main() -> ExitCode {
    example_frame::main(run)
}
