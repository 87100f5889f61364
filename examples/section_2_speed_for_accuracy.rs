//! Section 2: true error and true algebraic error against seconds and memory, for three solvers, on a scene
//! with known solution.
//!
//! `cargo run --release --example section_2_speed_for_accuracy -- --levels 6`

use example_frame::{Finding, Headline, Result, contact, progress};
use experiments::convergence::regression;
use experiments::solver_variants::{SolverVariant, VariantRow, manufactured_by_every_variant};
use peak_alloc::PeakAlloc;
use signorini::cone::{Cone, KKT_ROUNDING};
use signorini::rates::ConvergenceOrder;
use std::process::ExitCode;

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

example_frame::options! {
    /// Seconds and memory against true error on the scene `manufactured`, u = -Re (z - 2/5)^{3/2}
    pub struct Options {
        /// Squares along each side of the coarsest mesh
        #[arg(long, default_value_t = 8)]
        pub n: usize,
        /// Number of meshes n, 2n, 4n, ...
        #[arg(long, default_value_t = 6)]
        pub levels: usize,
        /// Discrete cone
        #[arg(long, default_value_t = Cone::Nodal)]
        pub cone: Cone,
    }
}

/// What is computed: every mesh by every road; on the coarsest there is nothing to start from.
pub struct Computed {
    /// Coarsest mesh first.
    pub rows: Vec<VariantRow>,
    /// The most bytes held for each solution, its problem and its KKT residuals.
    pub peaks: Vec<f64>,
}

/// Solves on every mesh by every road and measures the error against the known solution.
pub fn compute(options: &Options) -> Result<Computed> {
    let bar = progress((options.levels * SolverVariant::ALL.len()) as u64);
    // What is allocated once for the process (64 MiB by products of matrices) belongs to no road.
    manufactured_by_every_variant(32, 2, options.cone, |_, _| Ok(()))?;
    let (mut held, mut begun) = (Vec::new(), None);
    let mut begin = |next: Option<(usize, SolverVariant)>| {
        if let Some((place, before)) = begun.take() {
            held.push((place, MEMORY.peak_usage().saturating_sub(before)));
        }
        MEMORY.reset_peak_usage();
        begun = next.map(|place| (place, MEMORY.current_usage()));
    };
    let rows = manufactured_by_every_variant(options.n, options.levels, options.cone, |n, road| {
        bar.set_message(format!("n = {n}, {road}"));
        bar.inc(1);
        begin(Some((n, road)));
        Ok(())
    })?;
    begin(None);
    bar.finish_and_clear();
    let peak = |row: &VariantRow| held.iter().find(|(place, _)| *place == (row.n, row.road));
    let peaks = rows.iter().map(|row| peak(row).map_or(f64::NAN, |(_, bytes)| *bytes as f64)).collect();
    Ok(Computed { rows, peaks })
}

/// What a condition may be violated by: a duality gap of 1e-13 summed over the unknowns of a mesh of n = 32.
const KKT_LIMIT: f64 = 1e-10;
/// The order settles from mesh to mesh, as the transition moves in its cell: a tenth.
const SETTLING: f64 = 0.1;
/// Digits of the error that two ways to one discrete solution share: half of those of J.
const SHARED: f64 = 1e-6;
/// A hundredth of the error of discretisation beside it changes the error by 1e-4 / 2; tenfold for an
/// estimate that is off.
const WORTHLESS: f64 = 1e-3;
/// What two solutions in binary64 may differ by in the energy norm, relative.
const ROUNDING: f64 = 1e-13;

/// The order of the errors without a start from a coarser mesh.
fn order(rows: &[VariantRow]) -> Option<ConvergenceOrder> {
    let cold = rows.iter().filter(|row| row.road == SolverVariant::Cold);
    regression(&cold.map(|row| (1.0 / row.n as f64, row.error)).collect::<Vec<_>>())
}

/// What decides: the order of the error, the conditions, and whether the roads meet; what they cost.
pub fn findings(_: &Options, computed: &Computed) -> Vec<Finding> {
    let rows = &computed.rows;
    let order = order(rows).map(|found| (found.order, found.uncertainty));
    let apart = |is_share: bool| {
        let same = rows.iter().filter(move |row| (row.road == SolverVariant::Share) == is_share);
        let exact = |n| rows.iter().find(|row| row.road == SolverVariant::Cold && row.n == n);
        same.filter_map(move |row| Some((row.error / exact(row.n)?.error - 1.0).abs()))
    };
    let promised = rows.iter().filter_map(|row| Some(row.algebraic? / (row.estimate? + ROUNDING)));
    let mut found = vec![
        Finding::claim("order", "the error in the energy norm falls with order {value}")
            .number_or(order, "fewer than three meshes")
            .within(SETTLING, 1.0, "linear elements, u in H^{5/2-eps}")
            .otherwise("order {value} is not that of linear elements, 1")
            .told(),
        Finding::claim("conditions", "every exact solution meets the discrete conditions")
            .number(
                contact::worst(rows.iter().filter(|row| row.road != SolverVariant::Share).map(|row| row.kkt)),
                KKT_ROUNDING,
            )
            .at_most(KKT_LIMIT, "a duality gap of 1e-13 over 1000 unknowns")
            .otherwise("a discrete condition is violated by {value}"),
        Finding::claim("roads", "every exact road ends at the same error")
            .number(contact::worst(apart(false)), KKT_ROUNDING)
            .at_most(SHARED, "six digits of the error")
            .otherwise("two roads differ by {value} of the error"),
        Finding::claim("share", "a hundredth of the error of discretisation is worth nothing")
            .number(contact::worst(apart(true)), KKT_ROUNDING)
            .at_most(WORTHLESS, "a thousandth of the error")
            .otherwise("an inexact solution changes the error by {value}"),
        Finding::claim("promise", "every true algebraic error is at most {value} of its estimate")
            .number(contact::worst(promised), KKT_ROUNDING)
            .at_most(1.0, "the estimate")
            .otherwise("a true algebraic error is {value} of its estimate")
            .told(),
    ];
    found.extend(contact::road_costs(rows, &computed.peaks));
    found
}

/// Seconds for accuracy by every road.
pub fn run(options: &Options) -> Result<Headline> {
    let computed = compute(options)?;
    let claim = "order 1 in the energy norm for u in H^{5/2-eps}, whatever solves the discrete problem";
    let found = findings(options, &computed);
    let table = contact::road_table(&computed.rows, &computed.peaks);
    let mut headline = Headline::new("Section 2, speed for accuracy", claim, table, found);
    if let Some(found) = order(&computed.rows) {
        headline.quote(format!("section.2.speed.{}.order", options.cone), found.order);
    }
    let name = |what: &str| format!("section_2_{what}_{}", options.cone);
    headline.draw(&options.output, &name("seconds"), || Ok(contact::road_chart(&computed.rows)))?;
    headline.draw(&options.output, &name("peak"), || {
        Ok(contact::memory_chart(&computed.rows, &computed.peaks))
    })?;
    headline
        .draw(&options.output, &name("algebraic_seconds"), || Ok(contact::algebraic_chart(&computed.rows)))?;
    Ok(headline)
}

fn main() -> ExitCode {
    example_frame::main(run)
}
