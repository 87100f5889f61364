//! Section 2: where tau comes from. Singular exponents of corners and transitions, regularity of the scenes.
//!
//! `cargo run --release --example section_2_singular_exponents -- --omega 90 --pair D-N --out out`

use example_frame::figures::{Axis, Chart, Series};
use example_frame::rates::RateRow;
use example_frame::{Column, Finding, Format, Headline, Result, Table, progress};
use experiments::convergence::{SceneOrder, scene_orders};
use experiments::wedge_grid::ExponentCheck;
use signorini::problems::TestProblem;
use signorini::singular::{Medium, SideCondition, SideConditions, SignCondition, Spectrum, Wedge};
use std::f64::consts::{PI, TAU};
use std::process::ExitCode;

example_frame::options! {
    /// All exponents of a wedge, by two roads, and how smooth the scenes are
    pub struct Options {
        /// Opening in degrees, up to 360
        #[arg(long, default_value_t = 270.0)]
        pub omega: f64,
        /// Poisson's ratio, between -1 and 1/2
        #[arg(long, default_value_t = 0.25, allow_negative_numbers = true)]
        pub poisson: f64,
        /// Sides as in D-N: clamped D, free N, contact closed C, contact open O; six pairs when not given
        #[arg(long)]
        pub pair: Option<SideConditions>,
    }
}

/// Exponents asked for, a grid of wedges by all roads, two known values, the scenes.
pub struct Computed {
    /// The wedges of the table.
    pub wedges: Vec<(Wedge, Spectrum)>,
    /// One entry per wedge of the grid.
    pub grid: Vec<ExponentCheck>,
    /// Im of the first exponent of clamped/free on one line.
    pub oscillation: f64,
    /// The supremum of tau at the transition of contact on one line.
    pub transition: f64,
    /// All scenes on meshes.
    pub scenes: Vec<SceneOrder>,
}

/// Openings of the grid in steps of 15 degrees, Poisson's ratios, the agreement asked for.
const OPENINGS: u32 = 24;
const RATIOS: [f64; 4] = [-0.9, 0.0, 0.3, 0.49];
const DIGITS: f64 = 1e-12;

/// The wedges asked for, the grid, the scenes.
pub fn compute(options: &Options) -> Result<Computed> {
    let medium = Medium::PlaneStrain(options.poisson);
    let solved = |&sides: &SideConditions| {
        let wedge = Wedge::new(options.omega.to_radians(), sides, medium)?;
        Ok((wedge, wedge.exponents()?))
    };
    let wedges = options.pair.as_ref().map_or(&SideConditions::ALL[..], std::slice::from_ref);
    let bar = progress(u64::from(OPENINGS) + TestProblem::all().len() as u64);
    let flat =
        Wedge::new(PI, SideConditions(SideCondition::Clamped, SideCondition::Free), medium)?.exponents()?;
    let computed = Computed {
        wedges: wedges.iter().map(solved).collect::<Result<_>>()?,
        grid: ExponentCheck::on_grid(OPENINGS, &RATIOS, || bar.inc(1))?,
        oscillation: flat.exponents.first().map_or(f64::NAN, |exponent| exponent.im.value),
        transition: Wedge::new(PI, SideConditions(SideCondition::Closed, SideCondition::Open), medium)?
            .regularity()?
            .tau,
        scenes: scene_orders(3, 6, || bar.inc(1))?,
    };
    bar.finish_and_clear();
    Ok(computed)
}

/// What decides: counts against lists, one road against the other, known values, orders against tau.
pub fn findings(options: &Options, computed: &Computed) -> Vec<Finding> {
    let Computed { grid, oscillation, transition, scenes, .. } = computed;
    let claim = |key, words: &str, value: Option<f64>, bound, source| {
        Finding::claim(key, words).number_or(value.map(|value| (value, 0.0)), "none").at_most(bound, source)
    };
    let (lost, apart) = (Some(ExponentCheck::lost(grid) as f64), Some(ExponentCheck::furthest(grid)));
    let read = SceneOrder::worst_reading(scenes).map(|read| read.deviation());
    let (sharp, orders) = (SceneOrder::widest_reading(scenes), SceneOrder::furthest(scenes));
    let words = format!("no exponent is lost on {} wedges", grid.len());
    vec![
        claim("lost", &words, lost, 0.0, "wedges whose list and count by the argument principle differ"),
        claim("roads", "eigenvalues on the arc agree with the list to {value}", apart, DIGITS, "relative"),
        claim("read", "the exponent read at a scene's corner is the wedge's", read, 1.0, "its error"),
        claim("sharp", "exponents are read to {value} or better", sharp, 0.05, "open, closed: 0.18 apart"),
        Finding::claim("oscillation", "clamped/free on one line oscillates, Im lambda = {value}")
            .number(*oscillation, DIGITS)
            .within(2.0 * DIGITS, (3.0 - 4.0 * options.poisson).ln() / TAU, "ln(kappa)/(2 pi)"),
        Finding::claim("transition", "the signs of contact leave u in H^tau, tau < {value}, at a transition")
            .number(*transition, DIGITS)
            .within(2.0 * DIGITS, 2.5, "r^(3/2): 5/2"),
        Finding::remark("unseen", "uniform squares miss a gap at a corner, and tau, in scenes: {value}")
            .number(SceneOrder::unseen(scenes) as f64, 0.0)
            .at_least(1.0, "a gap that only a graded mesh sees"),
        Finding::remark("orders", "every scene's order is min(1, tau - 1) within its uncertainty")
            .number_or(orders.map(|off| (off, 0.0)), "an order is missing")
            .at_most(1.0, "min(1, tau - 1); in units of +-"),
    ]
}

/// Computes and lists.
pub fn run(options: &Options) -> Result<Headline> {
    let computed = compute(options)?;
    let found = findings(options, &computed);
    let claim = "all exponents with 0 < Re lambda < 3 are found, and give tau of every scene";
    let mut headline = Headline::new("Section 2", claim, table(&computed.wedges), found);
    for row in &computed.scenes {
        let name = format!("scene.{}", row.scene);
        row.numbers().iter().for_each(|(of, value)| headline.quote(format!("{name}.{of}"), *value));
        RateRow::quote(&mut headline, &name, row.order);
    }
    headline.draw(&options.output, "section_2_singular_exponents", || draw(options, &computed.scenes))?;
    Ok(headline)
}

fn table(wedges: &[(Wedge, Spectrum)]) -> Table {
    let twelve = Format::Fixed(12);
    let mut table = Table::new(vec![
        Column::new("sides", "sides", Format::Plain, "D clamped, N free, C contact closed, O contact open"),
        Column::new("re", "Re lambda", twelve, ""),
        Column::new("im", "Im lambda", twelve, "of a pair the one above the axis"),
        Column::new("error", "+-", Format::Scientific(0), "rounding of the characteristic function"),
        Column::new("multiplicity", "zeros", Format::Plain, "multiplicity as a zero"),
        Column::new("modes", "modes", Format::Plain, "angular functions; fewer than zeros: r^lambda ln r"),
        Column::new("kind", "kind", Format::Plain, "polynomial: no limit to tau; excluded: not in contact"),
    ]);
    for (wedge, e) in wedges.iter().flat_map(|(wedge, all)| all.exponents.iter().map(move |e| (wedge, e))) {
        let kind = match (wedge.sign_condition(e), e.is_polynomial()) {
            (SignCondition::Excluded, _) => "excluded",
            (_, true) => "polynomial",
            _ => "",
        };
        let mut row = vec![wedge.sides().to_string().into(), e.re.value.into(), e.im.value.into()];
        row.extend([e.re.error.into(), e.multiplicity.into(), e.modes.len().into(), kind.into()]);
        table.push(row);
    }
    table
}

/// The first exponent that is no polynomial against the opening, and the corners responsible for the scenes.
fn draw(options: &Options, scenes: &[SceneOrder]) -> Result<Chart> {
    let x = Axis::linear("opening in degrees").range(0.0, 360.0);
    let y = Axis::linear("first Re lambda, polynomials left out").range(0.0, 3.0);
    let mut chart = Chart::new(format!("Singular exponents, Poisson's ratio {}", options.poisson), x, y);
    for sides in SideConditions::ALL {
        let mut points = Vec::new();
        for degrees in (1..=90).map(|k| 4.0 * f64::from(k) - 0.7) {
            let wedge = Wedge::new(f64::to_radians(degrees), sides, Medium::PlaneStrain(options.poisson))?;
            points.extend(wedge.first_singular()?.map(|exponent| (degrees, exponent.re.value)));
        }
        chart = chart.with(Series::line(sides.to_string(), points));
    }
    for (name, elastic) in [("scenes", true), ("scalar scenes", false)] {
        let chosen = scenes.iter().filter(|row| row.scene.is_elastic() == elastic);
        chart = chart.with(Series::points(name, chosen.filter_map(SceneOrder::point).collect()));
    }
    Ok(chart)
}

fn main() -> ExitCode {
    example_frame::main(run)
}
