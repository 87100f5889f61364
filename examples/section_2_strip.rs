//! Section 2 on a strip reduced to its contact edge: levels up to 2^20 cells, 10^12 nodes, with exact errors.
//!
//! `cargo run --release --example section_2_strip -- --scene fat-cantor --tau 1.55 --levels 3-20`

use example_frame::figures::{Axis, Chart, Series};
use example_frame::{Cell, Column, Finding, Format, Headline, Result, Table, progress};
use experiments::convergence::{CaseStudy, Levels, Solved, StripCase, Trend};
use signorini::cone::Cone;
use signorini::problems::StripData;
use signorini::rates::{Bound, order_between};
use signorini::strip::{Reference, StripKind};
use std::process::ExitCode;

example_frame::options! {
    /// Solve a contact scene on nested strips and print exact energy errors and orders
    pub struct Options: Quick {
        /// scalar (Laplace, natural sides) or elastic (periodic sides)
        #[arg(long, default_value_t = StripKind::Scalar)]
        pub kind: StripKind,
        /// Levels COARSEST-FINEST: n = 2^level cells along the edge
        #[arg(long, default_value = "3-14")]
        pub levels: Levels,
        /// A scene of the strip
        #[arg(long, default_value_t = StripData::transition(), help = StripData::names())]
        pub scene: StripData,
        /// Regularity of the solution, 3/2 < tau <= 2 (not used by samples)
        #[arg(long, default_value_t = 1.75)]
        pub tau: f64,
        /// Discrete cone: nodal (2.9) or midpoint (4.1)
        #[arg(long, default_value_t = Cone::Nodal)]
        pub cone: Cone,
        /// Compare with the solution on the grid of the scene (nested) or with the continuous one (harmonic)
        #[arg(long, default_value_t = Reference::Nested)]
        pub reference: Reference,
        /// Average the squared error over this many places of the transition in the coarsest cell
        #[arg(long, default_value_t = 1)]
        pub positions: usize,
    }
    without_effect(options) {
        "positions" if !options.scene.moves() => "unless the scene is one transition",
        "tau" if matches!(options.scene, StripData::Samples { .. }) => "on samples",
    }
    memory(options) {
        190.0 * options.levels.reference_cells() as f64
    }
}

/// What is computed: all levels at all places of the transition, and how their errors run beside the bounds.
pub struct Computed {
    /// Levels, errors, gaps.
    pub study: CaseStudy,
    /// (h, error) on every level.
    pub errors: Vec<(f64, f64)>,
    /// Theorems 3.1, 4.1 and h^(tau - 1) through the coarsest error; none for samples, of unknown regularity.
    pub bounds: Vec<Vec<(f64, f64)>>,
}

/// Solves every level from the one before.
pub fn compute(options: &Options) -> Result<Computed> {
    let Options { kind, levels, scene: source, tau, cone, reference, positions, .. } = options.clone();
    levels.require_count(5, "[5, 22]: fewer levels show no rate")?;
    let case = StripCase { kind, levels, source, tau, cone, reference, positions };
    let bar = progress((levels.cells().count() * case.sources()?.len()) as u64);
    let study = CaseStudy::of(&case, |_| bar.inc(1))?;
    let errors: Vec<_> = levels.mesh_sizes().zip(study.errors.iter().map(|e| e.value)).collect();
    let line = |bound: Bound| study.regularity.map(|tau| bound.through(errors[0], levels.mesh_sizes(), tau));
    let bounds: signorini::Result<_> = [Bound::Paper, Bound::Optimal].into_iter().filter_map(line).collect();
    Ok(Computed { bounds: bounds?, study, errors })
}

/// Every scaled KKT figure must be below this.
const KKT_LIMIT: f64 = 1e-10;
/// Inner iterations allowed in a step, whatever n and the gaps: the preconditioned spectrum is bounded.
const INNER: f64 = 30.0;
const EXACT: &str = "error 0 on every level: the discrete solution is exact, nothing to compare";

/// What decides: levels are solved, steps take few iterations, error/bound does not grow; the order itself.
pub fn findings(_: &Options, Computed { study, errors, bounds }: &Computed) -> Vec<Finding> {
    let Solved { worst_kkt: kkt, unsolved, most_inner: inner } = study.solved();
    let ((h, error), bar) = (errors[errors.len() - 1], study.errors[errors.len() - 1].error);
    let exact = errors.iter().all(|e| e.1 == 0.0);
    let falls = if exact { EXACT.to_owned() } else { format!("error {error:.4e} at n = {:.0}", 1.0 / h) };
    let mut found = vec![
        Finding::remark("error", falls).number(error, bar).at_most(errors[0].1, "coarsest level").told(),
        Finding::claim("kkt", "KKT {value}").number(kkt, 0.0).at_most(KKT_LIMIT, "scaled violations").told(),
        Finding::claim("converged", "every level is solved").number(unsolved, 0.0).at_most(0.0, "levels not"),
        Finding::claim("inner", "at most {value} inner steps").number(inner, 0.0).at_most(INNER, "all n"),
    ];
    if let (Some(words), Some(planned)) = (study.missing_gaps(), study.planned_gaps) {
        let gaps = Finding::remark("gaps", "every gap is on the grid").number(planned as f64, 0.0);
        found.push(gaps.at_most(study.gaps as f64, "gaps on the grid").otherwise(words).told());
    }
    let (Some(tau), [theorem, ..]) = (study.regularity, &bounds[..]) else { return found };
    let order = Trend::of(errors).map(|trend| (trend.order.order, trend.order.uncertainty));
    // The mean slope of the bound: its exponent, and at tau = 2 what the logarithm leaves of it.
    let theorem = order_between(theorem[0], theorem[theorem.len() - 1]);
    let optimal = Bound::Optimal.exponent(tau).unwrap_or(f64::NAN);
    found.extend([
        // Only an order below that of the bound, whatever it may be off by, makes error/bound grow.
        Finding::claim("bounded", "error/bound stays bounded: the order is {value} or less")
            .number_or(order.map(|(p, bar)| (p + bar, 0.0)), "an error is 0")
            .at_least(theorem, "exponent of Theorems 3.1, 4.1")
            .otherwise("error/bound grows: the order is at most {value}; at one place, see --positions 5"),
        Finding::sharpness("loose", "h^{value}")
            .number_or(order.map(|(p, bar)| (p - theorem, bar)), "an error is 0")
            .at_least(0.0, "error/bound constant"),
        Finding::remark("order", "order {value}, where {bound} is optimal")
            .number_or(order.map(|(p, _)| (p, 0.0)), "an error is 0")
            .within(order.map_or(f64::NAN, |(_, bar)| bar), optimal, "min(tau - 1, 1), Drouet & Hild 2015")
            .told(),
    ]);
    found
}

/// Solves all levels and compares the errors with the bound of Theorems 3.1 and 4.1.
pub fn run(options: &Options) -> Result<Headline> {
    let computed = compute(options)?;
    let (Computed { study, errors, .. }, Options { kind, cone, scene, .. }) = (&computed, options);
    let statement = match study.regularity {
        Some(tau) => format!("u in H^{tau}: error <= C {}", Bound::Paper.law(tau)?),
        None => "all levels are solved; no rate is claimed".to_owned(),
    };
    let claim = format!("{kind} strip, {cone} cone, {scene} ({}), {statement}", study.gaps_text());
    let mut headline = Headline::new("Section 2, strip", claim, table(study), findings(options, &computed));
    if let (Some(finest), Some(order)) = (study.studies[0].last(), Trend::of(errors)) {
        headline.quote("section.2.strip.unknowns", finest.facts.unknowns);
        headline.quote_with("section.2.strip.order", order.order.order, order.order.uncertainty);
    }
    headline.draw(&options.output, "section_2_strip", || Ok(draw(options, &computed)))?;
    Ok(headline)
}

fn table(study: &CaseStudy) -> Table {
    let (count, tiny) = (Format::Fixed(0), Format::Scientific(0));
    let columns = vec![
        Column::new("cells", "n", count, ""),
        Column::new("unknowns", "unknowns", Format::Scientific(1), "of the two-dimensional problem"),
        Column::new("error", "error", Format::Scientific(6), "energy norm of u - u_h"),
        Column::hidden("error_bound"),
        Column::new("order", "order", Format::Fixed(3), "log2 of the ratio; alternates for one transition"),
        Column::new("contact_runs", "runs", count, "stretches of consecutive active constraints"),
        Column::new("steps", "steps", count, "linear problems; start from the coarser level"),
        Column::new("inner", "inner", count, "most inner iterations in a step"),
        Column::new("kkt", "KKT", tiny, "worst scaled violation of a condition; 0 is exact"),
        Column::new("seconds", "seconds", Format::Significant(2), "operator, load, contact"),
        Column::hidden("error_seconds"),
    ];
    Table::new(columns).with_rows(study.rows().into_iter().map(|row| row.map(Cell::finite)))
}

/// Errors against h with the two bounds, each passing through the coarsest error.
fn draw(Options { kind, cone, scene, .. }: &Options, Computed { errors, bounds, .. }: &Computed) -> Chart {
    let axes = ["h, length of a contact segment (period = 1)", "error in the energy norm"];
    let [x, y] = axes.map(Axis::logarithmic);
    let chart = Chart::new(format!("{kind} strip, {cone} cone, {scene}"), x, y)
        .with(Series::line_and_points("error", errors.clone()));
    let lines = bounds.iter().zip(["Theorems 3.1, 4.1", "h^(tau - 1)"]);
    lines.fold(chart, |chart, (line, name)| chart.with(Series::dashed(name, line.clone())))
}

fn main() -> ExitCode {
    example_frame::main(run)
}
