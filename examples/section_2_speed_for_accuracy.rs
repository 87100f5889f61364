//! Section 2: true error and true algebraic error against seconds, for three solvers, on a scene with known
//! solution.
//!
//! `cargo run --release --example section_2_speed_for_accuracy -- --levels 6`

use example_frame::{Finding, Headline, Result, contact, progress};
use signorini::cone::{Cone, NOISE};
use signorini::scenes::{Road, RoadRow, manufactured_by_every_road};
use std::process::ExitCode;

example_frame::options! {
    /// Seconds against true error on the scene `manufactured`, u = -Re (z - 2/5)^{3/2}
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
    pub rows: Vec<RoadRow>,
}

/// Solves on every mesh by every road and measures the error against the known solution.
pub fn compute(options: &Options) -> Result<Computed> {
    let bar = progress((options.levels * Road::ALL.len()) as u64);
    let rows = manufactured_by_every_road(options.n, options.levels, options.cone, |n, road| {
        bar.set_message(format!("n = {n}, {road}"));
        bar.inc(1);
        Ok(())
    })?;
    bar.finish_and_clear();
    Ok(Computed { rows })
}

/// What a condition may be violated by: a duality gap of 1e-13 summed over the unknowns of a mesh of n = 32.
const JUDGED: f64 = 1e-10;
/// The order settles from mesh to mesh, as the transition moves in its cell: a tenth.
const SETTLING: f64 = 0.1;
/// Digits of the error that two ways to one discrete solution share: half of those of J.
const SHARED: f64 = 1e-6;
/// A hundredth of the error of discretisation beside it changes the error by 1e-4 / 2; tenfold for an
/// estimate that is off.
const WORTHLESS: f64 = 1e-3;
/// What two solutions in binary64 may differ by in the energy norm, relative.
const ROUNDING: f64 = 1e-13;

/// The orders between consecutive meshes on the cold road, and the mean one.
fn orders(rows: &[RoadRow]) -> Option<(Vec<f64>, f64)> {
    let errors: Vec<f64> = rows.iter().filter(|row| row.road == Road::Cold).map(|row| row.error).collect();
    let orders: Vec<f64> = errors.windows(2).map(|pair| (pair[0] / pair[1]).log2()).collect();
    let mean = orders.iter().sum::<f64>() / orders.len() as f64;
    (orders.len() >= 2).then_some((orders, mean))
}

/// What decides: the order of the error, the conditions, and whether the roads meet.
pub fn findings(_: &Options, computed: &Computed) -> Vec<Finding> {
    let rows = &computed.rows;
    let order = orders(rows).map(|(all, mean)| (mean, contact::worst(all.iter().map(|o| (o - mean).abs()))));
    let finest = rows.iter().map(|row| row.n).max();
    let on = |road: Road, n: Option<usize>| rows.iter().find(|row| row.road == road && Some(row.n) == n);
    let apart = |is_share: bool| {
        let same = rows.iter().filter(move |row| (row.road == Road::Share) == is_share);
        same.filter_map(|row| Some((row.error / on(Road::Cold, Some(row.n))?.error - 1.0).abs()))
    };
    let promised = rows.iter().filter_map(|row| Some(row.algebraic? / (row.estimate? + ROUNDING)));
    let [cold, nested, _, multigrid, share] = Road::ALL.map(|road| on(road, finest));
    let saved = cold.zip(nested).map(|(cold, nested)| (cold.steps as f64 - nested.steps as f64, 0.0));
    let largest = rows.iter().filter(|row| row.road == Road::Interior).map(|row| row.n).max();
    let pair = on(Road::Interior, largest).zip(on(Road::Nested, largest));
    let faster = pair.map(|(slow, fast)| slow.seconds / fast.seconds);
    let cheaper = nested.zip(share).map(|(slow, fast)| slow.seconds / fast.seconds);
    let exact = multigrid.zip(share).map(|(slow, fast)| (slow.steps as f64 - fast.steps as f64, 0.0));
    vec![
        Finding::claim("order", "the error in the energy norm falls with order {value}")
            .number_or(order, "fewer than three meshes")
            .within(SETTLING, 1.0, "linear elements, u in H^{5/2-eps}")
            .otherwise("order {value} is not that of linear elements, 1")
            .told(),
        Finding::claim("conditions", "every exact solution meets the discrete conditions")
            .number(
                contact::worst(rows.iter().filter(|row| row.road != Road::Share).map(|row| row.kkt)),
                NOISE,
            )
            .at_most(JUDGED, "a duality gap of 1e-13 over 1000 unknowns")
            .otherwise("a discrete condition is violated by {value}"),
        Finding::claim("roads", "every exact road ends at the same error")
            .number(contact::worst(apart(false)), NOISE)
            .at_most(SHARED, "six digits of the error")
            .otherwise("two roads differ by {value} of the error"),
        Finding::claim("share", "a hundredth of the error of discretisation is worth nothing")
            .number(contact::worst(apart(true)), NOISE)
            .at_most(WORTHLESS, "a thousandth of the error")
            .otherwise("an inexact solution changes the error by {value}"),
        Finding::claim("promise", "every true algebraic error is at most {value} of its estimate")
            .number(contact::worst(promised), NOISE)
            .at_most(1.0, "the estimate")
            .otherwise("a true algebraic error is {value} of its estimate")
            .told(),
        Finding::remark("nested", "a nested start saves {value} steps on the finest mesh")
            .number_or(saved, "a road is missing")
            .at_least(1.0, "one step")
            .otherwise("a nested start saves no step")
            .told(),
        Finding::remark("seconds", "the nested active set is {value} times as fast as the interior point")
            .number_or(faster.map(|factor| (factor, 0.5 * factor)), "a road is missing")
            .at_least(1.0, "equal seconds; a busy machine halves or doubles them"),
        Finding::remark(
            "seconds.multigrid",
            "multigrid on the finest mesh is {value} times as fast as the nested active set",
        )
        .number_or(cheaper.map(|factor| (factor, 0.5 * factor)), "a road is missing")
        .at_least(1.0, "equal seconds; a busy machine halves or doubles them"),
        Finding::remark("digits", "ten digits take {value} cycles more than those that are worth something")
            .number_or(exact, "a road is missing")
            .at_least(1.0, "one cycle")
            .otherwise("ten digits cost no cycle more"),
    ]
}

/// Seconds for accuracy by every road.
pub fn run(options: &Options) -> Result<Headline> {
    let computed = compute(options)?;
    let claim = "order 1 in the energy norm for u in H^{5/2-eps}, whatever solves the discrete problem";
    let found = findings(options, &computed);
    let table = contact::road_table(&computed.rows);
    let mut headline = Headline::new("Section 2, speed for accuracy", claim, table, found);
    if let Some((_, order)) = orders(&computed.rows) {
        headline.quote(format!("section.2.speed.{}.order", options.cone), order);
    }
    let name = |what: &str| format!("section_2_{what}_{}", options.cone);
    headline.draw(&options.output, &name("seconds"), || Ok(contact::road_chart(&computed.rows)))?;
    headline
        .draw(&options.output, &name("algebraic_seconds"), || Ok(contact::algebraic_chart(&computed.rows)))?;
    Ok(headline)
}

fn main() -> ExitCode {
    example_frame::main(run)
}
