//! Extremes: the hardest admissible input gets digits, the inadmissible an error that names what was wrong.
//!
//! Two lists, in `cases/extremes.rs`. Each admissible case is computed and compared with a value found
//! another way: a closed form, a law of scaling, the other solver.
//!
//! `cargo run --release --example extremes`

use cases::{ADMISSIBLE, INADMISSIBLE};
use example_frame::figures::{Axis, Chart, Series};
use example_frame::{Cell, Column, Finding, Format, Headline, Result, Table};
use fractional_sobolev::{Constraint, Order, Tolerance, gamma, law};
use std::process::ExitCode;

#[path = "cases/extremes.rs"]
pub mod cases;

example_frame::options! {
    /// What is planted, what is answered
    pub struct Options {}
}

/// A relative error above this is no digits: sums of a million positive terms, condition numbers up to 1e5.
pub const DIGITS: f64 = 1e-9;

/// An admissible case and its answer.
#[derive(Debug, Clone)]
pub struct Hard {
    /// What was planted.
    pub planted: &'static str,
    /// What was computed, and against what.
    pub asked: &'static str,
    /// The value.
    pub found: f64,
    /// Relative, against the value found another way.
    pub error: f64,
}

/// An inadmissible case and its answer.
#[derive(Debug, Clone)]
pub struct Bad {
    /// What was planted.
    pub planted: &'static str,
    /// What was asked.
    pub asked: &'static str,
    /// The answer.
    pub answer: signorini::Result<f64>,
    /// Whether it is an error that names what is wrong.
    pub is_named: bool,
}

/// What was answered, and γ_θ(1/2) beside its law for θ down to 1e-290.
#[derive(Debug, Clone)]
pub struct Computed {
    /// Hard input.
    pub hard: Vec<Hard>,
    /// Input without an answer.
    pub bad: Vec<Bad>,
    /// (θ, computed, law as θ → 0).
    pub decades: Vec<(f64, f64, f64)>,
}

/// Plants every case.
pub fn compute() -> Result<Computed> {
    let mut hard = Vec::new();
    for (planted, asked, compute) in ADMISSIBLE {
        let (found, expected) = compute()?;
        hard.push(Hard { planted, asked, found, error: (found / expected - 1.0).abs() });
    }
    let bad = INADMISSIBLE.into_iter().map(|(planted, asked, compute, names)| {
        let answer = compute();
        Bad { planted, asked, is_named: answer.as_ref().is_err_and(names), answer }
    });
    let law = law(Order::HALF, 0.0, TOLERANCE)?;
    let decade = |k: i32| -> Result<(f64, f64, f64)> {
        let theta = 10f64.powi(-k);
        let found = gamma(Order::HALF, Constraint::mean_zero_on(0.0..theta), TOLERANCE)?.constant;
        Ok((theta, found.value, law.at(theta)?.value))
    };
    let decades = (20..=290).step_by(45).map(decade).collect::<Result<_>>()?;
    Ok(Computed { hard, bad: bad.collect(), decades })
}

/// Of the constants over 300 decades and of their law.
const TOLERANCE: Tolerance = Tolerance::fast();

/// What decides: errors against values found another way, what was refused and how, the constant's law.
pub fn findings(computed: &Computed) -> Vec<Finding> {
    let Computed { hard, bad, decades } = computed;
    let worst = hard.iter().max_by(|a, b| a.error.total_cmp(&b.error));
    let digits = format!(
        "{} hard inputs get their value, to {{value}} at worst ({})",
        hard.len(),
        worst.map_or("none", |worst| worst.planted)
    );
    let answered = bad.iter().filter(|case| case.answer.is_ok()).count();
    let unnamed = bad.iter().filter(|case| !case.is_named).count();
    let apart = decades.iter().map(|(_, found, law)| ((found / law - 1.0).abs(), 0.0));
    vec![
        Finding::claim("digits", digits)
            .number_or(worst.map(|worst| (worst.error, 0.0)), "nothing was planted")
            .at_most(DIGITS, "condition numbers up to 1e5, sums of a million terms")
            .otherwise("a hard input is {value} from its value found another way")
            .told(),
        Finding::claim("refused", format!("{} inputs without an answer are refused", bad.len()))
            .number(answered as f64, 0.0)
            .at_most(0.0, "nothing has an answer there")
            .otherwise("{value} inputs without an answer get one")
            .told(),
        Finding::claim("named", "every refusal names what is wrong")
            .number(unnamed as f64, 0.0)
            .at_most(0.0, "the kind of error each input calls for"),
        Finding::claim("law", "from 1e-20 to 1e-290 the constant of order 1/2 is within {value} of its law")
            .number_or(apart.max_by(|a, b| a.0.total_cmp(&b.0)), "no zone")
            .at_most(2.0 * TOLERANCE.relative(), "the tolerances of both"),
    ]
}

/// Plants every case and looks at the answers.
pub fn run(options: &Options) -> Result<Headline> {
    let computed = compute()?;
    let claim = "the hardest admissible input gets digits, the inadmissible an error that names it";
    let mut headline = Headline::new("Extremes", claim, table(&computed), findings(&computed));
    headline
        .quote("extremes.worst.error", computed.hard.iter().fold(0.0, |worst, case| case.error.max(worst)));
    headline.draw(&options.output, "extremes_zone", || Ok(draw(&computed.decades)))?;
    Ok(headline)
}

fn table(computed: &Computed) -> Table {
    let columns = vec![
        Column::words("planted", "planted", 32),
        Column::words("asked", "asked", 20),
        Column::words("answer", "answer", 30),
        Column::new("error", "error", Format::Scientific(0), "relative, against the value found another way"),
    ];
    let answer = |case: &Bad| match &case.answer {
        Err(error) => format!("refused: {error}"),
        Ok(value) => format!("{value}"),
    };
    let hard = computed.hard.iter().map(|case| {
        [Cell::from(case.planted), case.asked.into(), format!("{:.9e}", case.found).into(), case.error.into()]
    });
    let bad = computed.bad.iter();
    let bad = bad.map(|case| [case.planted.into(), case.asked.into(), answer(case).into(), Cell::Missing]);
    Table::new(columns).with_rows(hard.chain(bad))
}

fn draw(decades: &[(f64, f64, f64)]) -> Chart {
    let x = Axis::logarithmic("θ, length of the zone (interval = 1)");
    let title = "Poincaré constant of order 1/2 over 300 decades";
    Chart::new(title, x, Axis::linear("γ, Poincaré constant"))
        .with(Series::points("computed", decades.iter().map(|d| (d.0, d.1)).collect()))
        .with(Series::dashed("law as θ → 0", decades.iter().map(|d| (d.0, d.2)).collect()))
}

fn main() -> ExitCode {
    example_frame::main(run)
}
