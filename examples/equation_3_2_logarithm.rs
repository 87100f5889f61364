//! (3.2), (4.3): at τ = 2, does the error need a power of |ln h|?
//!
//! Transitions with slopes like |ln r|^{−α}: a kink outside H² (α = 0), and three in H² (α > 1/2).
//!
//! `cargo run --release --example equation_3_2_logarithm -- --levels 3-18`

use example_frame::figures::Chart;
use example_frame::rates::{both_cones, complete, error_over_h, lowest};
use example_frame::{Cell, Column, Finding, Format, Headline, Result, Table};
use signorini::cone::Cone;
use signorini::convergence::{Bound, LogarithmFit, Quantity, RateStudy, SceneFamily, StripGroup};
use signorini::scenes::TransitionPowers;
use signorini::strip::{Levels, StripKind};
use std::process::ExitCode;

example_frame::options! {
    /// Which of h, h |ln h|^1/4, h |ln h|^1/2 is the error at tau = 2?
    pub struct Options {
        /// Levels COARSEST-FINEST: n = 2^level cells along the edge; the reference is 16 times finer
        #[arg(long, default_value = "3-16")]
        pub levels: Levels,
    }
}

/// Powers α of the scenes: a kink outside H², and three in it.
const ALPHAS: [f64; 4] = [0.0, 0.75, 1.0, 1.5];

/// What is computed: scene after scene, nodal cone first, with the power q = 1 − 2α of ln(1/h) in (e/h)².
pub struct Computed {
    /// α, the levels, the fit; `None` for too few levels or an error that is not a positive number.
    pub rows: Vec<(f64, RateStudy, Option<LogarithmFit>)>,
}

/// Solves every scene in both cones.
pub fn compute(options: &Options) -> Result<Computed> {
    let levels = options.levels;
    let mut group = StripGroup::new(StripKind::Scalar, levels, (16 * levels.finest_cells()).min(1 << 22));
    for logarithm in ALPHAS {
        let powers = TransitionPowers { opening: 1.0, pressure: 0.0, logarithm };
        group.families.push(SceneFamily::at_thirds(powers, 2.0, levels.coarsest_cells()));
    }
    let mut rows = Vec::new();
    for (alpha, pair) in ALPHAS.into_iter().zip(both_cones(&group)?) {
        let fit = |study: &RateStudy| LogarithmFit::of(&study.points(Quantity::Error));
        rows.extend(
            pair.map(|row| (alpha, fit(&row.study), row.study)).map(|(a, fit, study)| (a, study, fit)),
        );
    }
    Ok(Computed { rows })
}

/// For a table: a jump of the slopes, or what they behave like.
fn name(alpha: f64) -> String {
    if alpha == 0.0 { "kink".to_owned() } else { format!("|ln r|^-{alpha}") }
}

/// error/bound on the finest level over the one in the middle, and what rounding leaves of it.
fn growth(study: &RateStudy, bound: Bound) -> Option<(f64, f64)> {
    let ratios = study.ratios(Quantity::Error, bound).ok()?;
    let growth = ratios.last()? / ratios.get(ratios.len() / 2)?;
    Some((growth, 2.0 * study.precision() * growth))
}

/// What decides: the sign of q in H² (q < 0: no logarithm), that e/h does not fall either, (3.2) outside H².
pub fn findings(_: &Options, Computed { rows }: &Computed) -> Vec<Finding> {
    let mut found = vec![complete(rows.iter().map(|row| &row.1))];
    for (alpha, study, fit) in rows {
        let (of, cone) = (format!("{}, {} cone", name(*alpha), study.cone), study.cone);
        let key = |what: &str| format!("{what}.{cone}.{:.0}", 100.0 * alpha);
        let (few, last) = ("too few levels or no error", "finest level over the middle one");
        let q = fit.map(|fit| (fit.power, fit.half_width));
        found.push(
            Finding::claim(key("bound"), format!("{of}: e/(h |ln h|^1/2) falls, factor {{value}}"))
                .number_or(growth(study, Bound::Paper), few)
                .at_most(1.0, format!("(3.2), (4.3); {last}")),
        );
        if *alpha > 0.5 {
            found.extend([
                Finding::claim(key("none"), format!("{of}: e/h needs no logarithm, q = {{value}}"))
                    .number_or(q, few)
                    .at_most(0.0, "q < 0 in H^2, Drouet & Hild 2015")
                    .otherwise(format!("{of}: e/h needs |ln h|^(q/2), q = {{value}}")),
                Finding::remark(key("order"), format!("{of}: e/h does not fall, factor {{value}}"))
                    .number_or(growth(study, Bound::Optimal), few)
                    .at_least(1.0, format!("order h; {last}")),
            ]);
        }
        let like = if *alpha > 0.5 { "is bounded and nears its limit like" } else { "grows like" };
        let power = Finding::remark(key("power"), format!("{of}: (e/h)^2 {like} |ln h|^q, q = {{bound}}"))
            .number_or(q.map(|(power, _)| (power, 0.0)), few)
            .within(q.map_or(0.0, |(_, u)| u), 1.0 - 2.0 * alpha, "1 - 2 alpha, sum over cells")
            .otherwise(format!("{of}: q = {{value}} is not {{bound}} within its uncertainty"));
        found.push(if *alpha > 0.5 { power } else { power.told() });
    }
    let in_h2 = rows.iter().filter(|row| row.0 > 0.5);
    found.push(
        Finding::sharpness("whole", "in H^2 the whole logarithm: q stays {value} +- {uncertainty} below 0")
            .number_or(lowest(in_h2.map(|row| row.2.map(|fit| (-fit.power, fit.half_width)))), "no fit")
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
    for (alpha, study, fit) in &computed.rows {
        let key = format!("equation.3.2.{}.{:.0}", study.cone, 100.0 * alpha);
        if let Some(fit) = fit {
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
    for (alpha, study, fit) in rows {
        let mut cells: Vec<Cell> = vec![name(*alpha).into(), study.cone.to_string().into()];
        cells.push((1.0 - 2.0 * alpha).into());
        let numbers = [fit.map(|f| f.power), fit.map(|f| f.half_width), fit.map(|f| f.exponent())];
        cells.extend(numbers.map(Cell::from));
        let bounds = [Bound::Optimal, Bound::Sharpened, Bound::Paper];
        cells.extend(bounds.map(|bound| growth(study, bound).map(|(growth, _)| growth).into()));
        cells.push(study.left_out().into());
        table.push(cells);
    }
    table
}

/// e/h against h for all scenes in the nodal cone, relative to the coarsest level.
fn draw(Computed { rows }: &Computed) -> Chart {
    let nodal = rows.iter().filter(|row| row.1.cone == Cone::Nodal);
    let named = nodal.map(|(alpha, study, _)| (name(*alpha), study));
    error_over_h("tau = 2: does error/h grow?", named, &[("|ln h|^1/4", 0.25), ("|ln h|^1/2", 0.5)])
}

fn main() -> ExitCode {
    example_frame::main(run)
}
