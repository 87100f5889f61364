//! (3.2), (4.3): at τ = 2, does the error need a power of |ln h|?
//!
//! Slopes like |ln r|^{−α}, outside H² (α = 0) and in it (α > 1/2): one transition, 22, a Cantor set.
//!
//! `cargo run --release --example equation_3_2_logarithm -- --levels 3-18`

use example_frame::figures::Chart;
use example_frame::rates::{LogarithmRow, complete, error_over_h, lowest};
use example_frame::{Cell, Column, Finding, Format, Headline, Result, Table};
use experiments::convergence::Levels;
use signorini::cone::Cone;
use signorini::rates::Bound;
use std::process::ExitCode;

example_frame::options! {
    /// Which of h, h |ln h|^1/4, h |ln h|^1/2 is the error at tau = 2?
    pub struct Options: Long {
        /// Levels COARSEST-FINEST: n = 2^level cells along the edge; the reference is 16 times finer
        #[arg(long, default_value = "3-16")]
        pub levels: Levels,
    }
}

/// What is computed: scene after scene, nodal cone first.
pub struct Computed {
    /// One transition before many.
    pub rows: Vec<LogarithmRow>,
}

/// Solves every scene in both cones.
pub fn compute(options: &Options) -> Result<Computed> {
    Ok(Computed { rows: LogarithmRow::all(options.levels)? })
}

/// What decides: the sign of q in H² (q < 0: no logarithm), that e/h does not fall either, (3.2) outside H².
pub fn findings(_: &Options, Computed { rows }: &Computed) -> Vec<Finding> {
    let mut found = vec![complete(rows.iter().map(|row| &row.study))];
    for row @ LogarithmRow { alpha, study, fit, .. } in rows {
        let (of, key) = (format!("{}, {} cone", row.name(), study.cone), |what: &str| row.key(what));
        let (few, last) = ("too few levels or no error", "finest level over the middle one");
        let q = fit.map(|fit| (fit.power, fit.half_width));
        if *alpha > 0.5 || row.is_single() {
            found.push(
                Finding::claim(key("bound"), format!("{of}: e/(h |ln h|^1/2) falls, factor {{value}}"))
                    .number_or(row.growth(Bound::Paper), few)
                    .at_most(1.0, format!("(3.2), (4.3); {last}")),
            );
        }
        if *alpha > 0.5 {
            found.extend([
                Finding::claim(key("none"), format!("{of}: e/h needs no logarithm, q = {{value}}"))
                    .number_or(q, few)
                    .at_most(0.0, "q < 0 in H^2, Drouet & Hild 2015")
                    .otherwise(format!("{of}: e/h needs |ln h|^(q/2), q = {{value}}")),
                Finding::remark(key("order"), format!("{of}: e/h does not fall, factor {{value}}"))
                    .number_or(row.growth(Bound::Optimal), few)
                    .at_least(1.0, format!("order h; {last}")),
            ]);
        }
        if !row.is_single() && *alpha == 0.0 {
            found.push(
                Finding::remark(key("needs"), format!("{of}: e/h needs |ln h|^(q/2), q = {{value}}"))
                    .number_or(q, few)
                    .at_least(0.0, "q > 0 outside H^2")
                    .otherwise(format!("{of}: e/h needs no logarithm, q = {{value}}")),
            );
        }
        if !row.is_single() {
            continue;
        }
        let like = if *alpha > 0.5 { "is bounded and nears its limit like" } else { "grows like" };
        let power = Finding::remark(key("power"), format!("{of}: (e/h)^2 {like} |ln h|^q, q = {{bound}}"))
            .number_or(q.map(|(power, _)| (power, 0.0)), few)
            .within(q.map_or(0.0, |(_, u)| u), 1.0 - 2.0 * alpha, "1 - 2 alpha, sum over cells")
            .otherwise(format!("{of}: q = {{value}} is not {{bound}} within its uncertainty"));
        found.push(if *alpha > 0.5 { power } else { power.told() });
    }
    let in_h2 = rows.iter().filter(|row| row.alpha > 0.5);
    found.push(
        Finding::sharpness(
            "whole",
            "in H^2 the whole logarithm: every q is below 0, the least sure one by {value} +- {uncertainty}",
        )
        .number_or(lowest(in_h2.map(|row| row.fit.map(|fit| (-fit.power, fit.half_width)))), "no fit")
        .at_least(0.0, "no logarithm")
        .told(),
    );
    found
}

/// Measures every scene in both cones.
pub fn run(options: &Options) -> Result<Headline> {
    let computed = compute(options)?;
    let claim = "u in H^2: the error is at most C h |ln h|^(1/2); with the sharp Lemma 5.2 C h |ln h|^(1/4); proved later: C h";
    let found = findings(options, &computed);
    let mut headline = Headline::new("(3.2), (4.3)", claim, table(&computed), found);
    for row in &computed.rows {
        if let Some(fit) = row.fit {
            let key = row.key("equation.3.2");
            headline.quote(format!("{key}.q"), fit.power);
            headline.quote(format!("{key}.half"), fit.half_width);
        }
    }
    headline.draw(&options.output, "equation_3_2_logarithm", || Ok(draw(&computed)))?;
    Ok(headline)
}

fn table(Computed { rows }: &Computed) -> Table {
    let three = Format::Fixed(3);
    let ratio = "finest level that counts over the middle one";
    let mut table = Table::new(vec![
        Column::new("scene", "slopes like", Format::Plain, "kink: a jump, not in H^2; the others are"),
        Column::new("cone", "cone", Format::Plain, ""),
        Column::new("expected", "1-2a", Format::Plain, "q expected for slopes like |ln r|^-a"),
        Column::new("power", "q", three, "(e/h)^2 = B + A(l^q - 1)/q, l = 2 + |ln h|"),
        Column::new("half_width", "+-", three, "what q may be off by: windows of levels, scatter"),
        Column::new("exponent", "needed", three, "power of |ln h| in the error: q/2, none for q <= 0"),
        Column::new("optimal", "e/h", three, ratio),
        Column::new("sharpened", "e/hL^1/4", three, ratio),
        Column::new("paper", "e/hL^1/2", three, ratio),
        Column::new("left_out", "out", Format::Plain, "levels left out"),
    ]);
    for row @ LogarithmRow { alpha, study, fit, .. } in rows {
        let mut cells: Vec<Cell> = vec![row.name().into(), study.cone.to_string().into()];
        cells.push((1.0 - 2.0 * alpha).into());
        let numbers = [fit.map(|f| f.power), fit.map(|f| f.half_width), fit.map(|f| f.exponent())];
        cells.extend(numbers.map(Cell::from));
        let bounds = [Bound::Optimal, Bound::Sharpened, Bound::Paper];
        cells.extend(bounds.map(|bound| row.growth(bound).map(|(growth, _)| growth).into()));
        cells.push(study.left_out().into());
        table.push(cells);
    }
    table
}

/// e/h against h for one transition in the nodal cone, relative to the coarsest level.
fn draw(Computed { rows }: &Computed) -> Chart {
    let nodal = rows.iter().filter(|row| row.study.cone == Cone::Nodal && row.is_single());
    let named = nodal.map(|row| (row.name(), &row.study));
    error_over_h("tau = 2: does error/h grow?", named, &[("|ln h|^1/4", 0.25), ("|ln h|^1/2", 0.5)])
}

fn main() -> ExitCode {
    example_frame::main(run)
}
