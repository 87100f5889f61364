//! Lemma 5.2 at ν = 1/2: γ_θ² / ln(1/θ) tends to 3/(2π²), between two proved bounds.
//!
//! With L = ln(1/θ) the law is γ² = A L + c + d/γ² + e/γ⁴ + ..., A = 3/(2π²); c, d, e come from one dual
//! norm. What is left of γ² − A L − c is of order 1/L. The proof bounds γ² from below by a ramp and from
//! above along chains of equal steps in ln x, all constants explicit: its two bounds enclose γ² and close as
//! L grows, far beyond the shortest zone that has a number.
//!
//! `cargo run --release --example lemma_5_2_exact_law`

use example_frame::figures::{Axis, Chart, Series};
use example_frame::{Cell, Column, Finding, Format, Headline, Result, Table, within};
use experiments::EstimateExt;
use experiments::growth::{END_SLOPE, INTERIOR_SLOPE, growth, last_exponent};
use experiments::zones::Place;
use fractional_sobolev::{Constraint, Estimate, Law, Order, Tolerance, gamma, law};
use std::process::ExitCode;

example_frame::options! {
    /// The law of the Poincare constant at nu = 1/2, and the two bounds that prove it
    pub struct Options {
        /// Zones theta at the end of the interval, longest first
        #[arg(long, value_delimiter = ',', default_values = ["1e-2", "1e-5", "1e-10", "1e-30", "1e-100", "1e-200", "1e-300"], value_parser = within::<f64>("[1e-300, 0.36]"))]
        pub theta: Vec<f64>,
        /// L = ln(1/theta) at which the bounds alone are evaluated
        #[arg(long, value_delimiter = ',', default_values = ["1e4", "1e6", "1e9", "1e12"], value_parser = within::<f64>("[1, 1e15]"))]
        pub log: Vec<f64>,
        /// Relative tolerance: fast, balanced, reference or a number
        #[arg(long, default_value = "1e-10")]
        pub tolerance: Tolerance,
    }
}

/// Two proved bounds of γ² at one L = ln(1/θ).
pub struct Bracket {
    /// L.
    pub log: f64,
    /// The quotient of a ramp.
    pub lower: f64,
    /// The inequality along chains.
    pub upper: f64,
}

/// γ² beside the law.
pub struct LawRest {
    /// γ².
    pub square: Estimate,
    /// γ² − A L − c.
    pub rest: Estimate,
    /// The rest over d/γ² + e/γ⁴: one, up to the next term, of relative order 1/γ⁴.
    pub explained: Estimate,
}

/// What the leading part A L + c of the law leaves of γ².
fn rest(law: &Law, log: f64, gamma: Estimate) -> Result<LawRest> {
    let Some([a, c, d, e]) = law.expansion else { unreachable!("the law at one half has an expansion") };
    let (value, error) = (gamma.value * gamma.value, 2.0 * gamma.value * gamma.error);
    let leading = a.value * log + c.value;
    let known = a.error * log + c.error + f64::EPSILON * value;
    let rest = Estimate::new(value - leading, error + known, gamma.work)?;
    let next = (d.value + e.value / value) / value;
    let next = Estimate::new(next, (d.error + e.error / value) / value + next * error / value, d.work)?;
    Ok(LawRest { square: Estimate::new(value, error, gamma.work)?, rest, explained: rest.over(next)? })
}

/// What is computed.
pub struct Computed {
    /// Zones at the end: both bounds of γ², and what A L + c leaves of it.
    pub points: Vec<(Bracket, LawRest)>,
    /// The power of L in what is left, between the last two zones.
    pub power: Option<Estimate>,
    /// Bounds for zones too short for a number.
    pub beyond: Vec<Bracket>,
    /// The slope of γ² against L between the last two zones in the middle of the interval.
    pub inside: Option<Estimate>,
}

/// Constants by the eigenproblem, the law from dual norms, the bounds from the proof.
pub fn compute(options: &Options) -> Result<Computed> {
    let (half, tolerance) = (Order::HALF, options.tolerance);
    let law = law(half, 0.0, tolerance)?;
    let bracket = |log: f64| -> Result<Bracket> {
        let [lower, upper] = law.bracket(log)?;
        Ok(Bracket { log, lower, upper })
    };
    let constant = |place: Place, theta: f64| -> Result<Estimate> {
        Ok(gamma(half, Constraint::mean_zero_on(place.zone(theta)?), tolerance)?.constant)
    };
    let point = |&theta: &f64| -> Result<(Bracket, LawRest)> {
        let log = -theta.ln();
        Ok((bracket(log)?, rest(&law, log, constant(Place::End, theta)?)?))
    };
    let points: Vec<_> = options.theta.iter().map(point).collect::<Result<_>>()?;
    let rests: Vec<_> = points.iter().map(|(bracket, law)| (bracket.log, law.rest)).collect();
    let inside = |&theta: &f64| -> Result<(f64, Estimate)> { Ok((theta, constant(Place::Centre, theta)?)) };
    let inside = options.theta.iter().map(inside).collect::<Result<Vec<_>>>()?;
    Ok(Computed {
        points,
        power: last_exponent(&rests)?,
        beyond: options.log.iter().map(|&log| bracket(log)).collect::<Result<_>>()?,
        inside: growth(half, &inside)?,
    })
}

/// How near to -1 the power of L in the rest has to be, its change from zone to zone included.
const POWER: f64 = 0.05;
/// What the next term of the law may change, relative, at the shortest zone.
const NEXT_TERM: f64 = 1e-3;
/// How near the two bounds have to come at the largest L.
const CLOSED: f64 = 1e-4;
/// How near to 1/(2 pi^2) the slope inside has to be, its change included.
const INSIDE: f64 = 1e-3;

/// What decides: the bounds enclose the constant and close, and the rest is of the order and size predicted.
pub fn findings(computed: &Computed) -> Vec<Finding> {
    let Computed { points, power, beyond, inside } = computed;
    let few = "fewer than two zones";
    let over = |part: fn(&Bracket) -> f64| {
        points.iter().filter_map(move |(bracket, law)| law.square.times(1.0 / part(bracket)).ok())
    };
    let widest = beyond.last().map(|b| (b.upper / b.lower - 1.0, 0.0));
    vec![
        Finding::claim("lower", "the ramp is a lower bound: gamma^2 is {value} times it or more")
            .estimate_or(Estimate::smallest(over(|b| b.lower)), few)
            .at_least(1.0, "a quotient of one function"),
        Finding::claim("upper", "the chains give an upper bound: gamma^2 is {percent} % of it or less")
            .estimate_or(Estimate::largest(over(|b| b.upper)), few)
            .at_most(1.0, "the bound along chains"),
        Finding::claim("closing", "at the largest L the two bounds differ by a part {value}")
            .number_or(widest, "no L")
            .at_most(CLOSED, "a bracket that closes like L^(-1/2)")
            .otherwise("at the largest L the two bounds still differ by a part {value}")
            .told(),
        Finding::claim("rest", "what A L + c leaves of gamma^2 falls like L^{value}")
            .estimate_or(*power, few)
            .within(POWER, -1.0, "the next term d / gamma^2")
            .told(),
        Finding::claim("explained", "at the shortest zone it is {value} times d/gamma^2 + e/gamma^4")
            .estimate_or(points.last().map(|(_, law)| law.explained), few)
            .within(NEXT_TERM, 1.0, "the expansion of the resolvent, its constants from a dual norm"),
        Finding::claim("inside", "for zones in the middle gamma^2 grows by {value} per unit of L")
            .estimate_or(*inside, few)
            .within(INSIDE, INTERIOR_SLOPE, "1/(2 pi^2): two sides to climb"),
    ]
}

/// Follows the law from long zones to zones without a number.
pub fn run(options: &Options) -> Result<Headline> {
    let computed = compute(options)?;
    let claim = "gamma_theta(1/2)^2 / ln(1/theta) tends to 3/(2 pi^2) as theta falls to zero";
    let mut headline = Headline::new("(5.2), exact", claim, table(&computed), findings(&computed));
    headline.draw(&options.output, "lemma_5_2_exact_law", || Ok(draw(&computed)))?;
    Ok(headline)
}

fn table(computed: &Computed) -> Table {
    let columns = vec![
        Column::new("log", "L", Format::Significant(5), "ln(1/theta)"),
        Column::new("theta", "theta", Format::Scientific(0), "length of the zone"),
        Column::new("square", "gamma^2", Format::Significant(10), "square of the best constant"),
        Column::new("lower", "lower", Format::Significant(5), "the ramp's bound over A L, A = 3/(2 pi^2)"),
        Column::new("ratio", "ratio", Format::Significant(5), "gamma^2/(A L)"),
        Column::new("upper", "upper", Format::Significant(5), "the bound along chains over A L"),
        Column::new("rest", "rest", Format::Scientific(4), "gamma^2 - A L - c"),
        Column::new("explained", "explained", Format::Significant(7), "rest over d/gamma^2 + e/gamma^4"),
    ];
    let row = |b: &Bracket, law: Option<&LawRest>| {
        let scale = END_SLOPE * b.log;
        let of = |part: fn(&LawRest) -> f64| law.map(part);
        let square = of(|law| law.square.value);
        let bounds = [Some(b.lower / scale), square.map(|g| g / scale), Some(b.upper / scale)];
        let ends = [of(|law| law.rest.value), of(|law| law.explained.value)];
        let first = [Some(b.log), square.map(|_| (-b.log).exp()), square];
        first.into_iter().chain(bounds).chain(ends).map(Cell::from).collect::<Vec<_>>()
    };
    let rows = computed.points.iter().map(|(bracket, law)| row(bracket, Some(law)));
    Table::new(columns).with_rows(rows.chain(computed.beyond.iter().map(|b| row(b, None))))
}

fn draw(computed: &Computed) -> Chart {
    let (x, y) = ("L = ln(1/θ), logarithm of the zone", "|γ² / (A L) − 1|, distance from the law");
    let off = |log: f64, square: f64| (log, (square / (END_SLOPE * log) - 1.0).abs());
    let known = computed.points.iter().map(|(bracket, _)| bracket);
    let all: Vec<_> = known.chain(&computed.beyond).collect();
    let found = computed.points.iter().map(|(bracket, law)| off(bracket.log, law.square.value));
    let title = "The law at one half between its two bounds";
    Chart::new(title, Axis::logarithmic(x), Axis::logarithmic(y))
        .with(Series::line("upper bound, chains", all.iter().map(|b| off(b.log, b.upper)).collect()))
        .with(Series::points("γ², computed", found.collect()))
        .with(Series::line("lower bound, ramp", all.iter().map(|b| off(b.log, b.lower)).collect()))
}

fn main() -> ExitCode {
    example_frame::main(run)
}
