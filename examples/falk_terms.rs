//! Falk's lemma, (4.5) and (4.8): every term on computed solutions of the strip, and the measured constant.
//!
//! `cargo run --release --example falk_terms -- --cone nodal --scene fat-cantor`

use example_frame::figures::{Axis, Chart, Series};
use example_frame::{Column, Finding, Format, Headline, Result, Table};
use experiments::convergence::regression;
use experiments::convergence::{Levels, StripCase};
use experiments::proof::{FalkRow, falk_terms};
use signorini::cone::Cone;
use signorini::problems::StripData;
use signorini::proof::printed_exponent;
use signorini::strip::{Reference, StripKind};
use std::process::ExitCode;

example_frame::options! {
    /// Terms of Falk's lemma for the nodal or the midpoint cone on a scene with known solution
    pub struct Options: Quick {
        /// scalar or elastic
        #[arg(long, default_value_t = StripKind::Scalar)]
        pub kind: StripKind,
        /// A scene of the strip
        #[arg(long, default_value_t = StripData::transition(), help = StripData::names())]
        pub scene: StripData,
        /// Regularity of the scene, in (3/2, 2]
        #[arg(long, default_value_t = 1.75)]
        pub tau: f64,
        /// nodal or midpoint
        #[arg(long, default_value_t = Cone::Midpoint)]
        pub cone: Cone,
        /// Mesh sizes h = 2^-COARSEST ... 2^-FINEST
        #[arg(long, default_value = "3-10")]
        pub levels: Levels,
        /// Over how many positions in its cell a single transition is moved (odd)
        #[arg(long, default_value_t = 5)]
        pub positions: usize,
    }
    without_effect(options) {
        "positions" if !options.scene.moves() => "unless the scene is one transition",
    }
}

/// Solves the scene on all meshes and integrates the terms, coarsest mesh first.
pub fn compute(options: &Options) -> Result<Vec<FalkRow>> {
    let Options { kind, levels, scene: source, tau, cone, positions, .. } = options.clone();
    let case = StripCase { kind, levels, source, tau, cone, reference: Reference::Nested, positions };
    Ok(falk_terms(&case, |_| ())?)
}

/// Part of the largest term that rounding may change: squared errors carry 1e-12 of the energy.
const ROUNDING: f64 = 1e-9;

/// A term: key, name, name in the figure.
type Term = (&'static str, &'static str, fn(&FalkRow) -> f64);

const TERMS: [Term; 6] = [
    ("error", "|u − u_h|²", |r| r.terms.error),
    ("approximation", "|u − I^h u|²", |r| r.terms.approximation),
    ("consistency", "∫σ(I^h u)", |r| r.terms.consistency),
    ("second", "|∫σ u_h|", |r| r.terms.second_infimum),
    ("part.one", "(4.8), first part", |r| r.terms.first_part),
    ("part.two", "(4.8), second part", |r| r.terms.second_part),
];

/// Exponent of h of a term; none with fewer than three meshes on which it does not vanish.
fn exponent(rows: &[FalkRow], term: fn(&FalkRow) -> f64) -> Option<(f64, f64)> {
    let points = rows.iter().map(|r| (1.0 / r.n as f64, term(r).abs())).filter(|point| point.1 > 0.0);
    regression(&points.collect::<Vec<_>>()).map(|found| (found.order, found.uncertainty))
}

/// What decides: both sides of the lemma and of (4.8) on every mesh, a sign, an order.
pub fn findings(options: &Options, rows: &[FalkRow]) -> Vec<Finding> {
    let largest = |number: &dyn Fn(&FalkRow) -> f64| {
        rows.iter().map(number).reduce(f64::max).map(|number| (number, ROUNDING * number.abs()))
    };
    let (none, zero) = ("no mesh", "0 up to the rounding of squared errors");
    // On K^h, inside K, the sign is a claim; the midpoint cone leaves it open.
    let of_cone = if options.cone == Cone::Nodal { Finding::claim } else { Finding::remark };
    vec![
        Finding::claim("lemma", "the first infimum takes at most {percent} % of its bound by v_h = I^h u")
            .number_or(largest(&|r| r.terms.interpolant_share()), none)
            .at_most(1.0, "|u - v_h|^2 + 2 int sigma (v_h - u), which u_h minimises")
            .otherwise("I^h u is better than u_h: the first infimum takes {percent} % of its bound"),
        Finding::claim("constant", "measured constant of the lemma at most {value}")
            .number_or(largest(&|r| r.terms.constant(options.cone)), none)
            .at_most(2.0, "2 by Young's inequality in the energy norm")
            .told(),
        Finding::claim("split", "the second infimum is at most the two parts of (4.8) on every mesh")
            .number_or(largest(&|r| r.terms.split_excess()), none)
            .at_most(ROUNDING, zero),
        of_cone("second", "the second infimum is negative on every mesh: under stress u_h stays open")
            .number_or(largest(&|r| r.terms.second_share()), none)
            .at_most(ROUNDING, zero)
            .otherwise("the second infimum is positive on some mesh"),
        Finding::remark("consistency", "the consistency term falls like h^{value}, faster than the bound")
            .number_or(
                exponent(rows, |r| r.terms.consistency),
                "fewer than three meshes with a positive term",
            )
            .at_least(printed_exponent(options.tau), "2 tau^2 - 5 tau + 4, 2 at tau = 2")
            .told(),
    ]
}

/// Solves, decides and shows.
pub fn run(options: &Options) -> Result<Headline> {
    let rows = compute(options)?;
    let claim = "the squared error is at most C times approximation, consistency and nonconformity";
    let (cone, found) = (options.cone, findings(options, &rows));
    let mut headline = Headline::new("Falk's lemma, (4.5), (4.8)", claim, table(cone, &rows), found);
    headline.quote(
        format!("falk.{cone}.constant"),
        rows.iter().map(|r| r.terms.constant(cone)).fold(0.0, f64::max),
    );
    for (key, _, term) in TERMS {
        if let Some((value, uncertainty)) = exponent(&rows, term) {
            headline.quote_with(&format!("falk.{cone}.{key}.exponent"), value, uncertainty);
        }
    }
    if let Some(finest) = rows.last() {
        headline
            .quote(format!("falk.{cone}.consistency.share"), finest.terms.consistency / finest.terms.error);
    }
    headline.draw(&options.output, "falk_terms", || Ok(draw(options, &rows)))?;
    Ok(headline)
}

fn table(cone: Cone, rows: &[FalkRow]) -> Table {
    let (number, four) = (Format::Scientific(2), Format::Fixed(4));
    let columns = vec![
        Column::new("n", "1/h", Format::Plain, "contact segments"),
        Column::new("error", "error^2", number, "|u - u_h|^2, energy norm"),
        Column::new("approximation", "approx", number, "|u - v_h|^2, v_h = I^h u on the edge"),
        Column::new("consistency", "consist", number, "int sigma_N (I^h u)_N"),
        Column::new("second_infimum", "2nd inf", number, "inf over K of int sigma_N (v - u_h)_N"),
        Column::new("first_part", "(4.8) 1", number, "-int (sigma_N - pi sigma_N)(u_h - u)_N"),
        Column::new("second_part", "(4.8) 2", number, "-int (sigma_N - pi sigma_N) u_N"),
        Column::new("bracket", "bracket", number, "approx + consist, midpoint cone: + 2nd inf"),
        Column::new("constant", "C", four, "error^2 / bracket"),
        Column::new("split_constant", "C split", four, "the same with (4.8) for the 2nd inf"),
        Column::new("first_infimum", "inf/err^2", four, "first infimum, attained at u_h, over error^2"),
    ];
    Table::new(columns).with_rows(rows.iter().map(|r| {
        let terms = TERMS.map(|(_, _, term)| term(r));
        let constants = [
            r.terms.constant(cone),
            r.terms.error / r.terms.split_bracket(cone),
            r.terms.first_infimum() / r.terms.error,
        ];
        [&[r.n as f64], terms.as_slice(), &[r.terms.bracket(cone)], &constants].concat()
    }))
}

/// All terms over h, absolute values.
fn draw(options: &Options, rows: &[FalkRow]) -> Chart {
    let Options { cone, scene, tau, .. } = options;
    let title = format!("Terms of Falk's lemma, {cone} cone, scene {scene}, τ = {tau}");
    let y = Axis::logarithmic("size of the term (squared energy norm)");
    let points = |term: fn(&FalkRow) -> f64| rows.iter().map(|r| (1.0 / r.n as f64, term(r).abs())).collect();
    let mut chart = Chart::new(title, Axis::logarithmic("h (edge = 1)"), y);
    for (_, name, term) in TERMS {
        chart = chart.with(Series::line_and_points(name, points(term)));
    }
    chart
}

fn main() -> ExitCode {
    example_frame::main(run)
}
