//! Section 1: are there infinitely many transitions where a clamped part meets the contact edge?
//!
//! `cargo run --release --example section_1_clamped_end -- --angles 16 --smallest 1e-100`

use example_frame::figures::{Axis, Chart, Series};
use example_frame::{Cell, Column, Finding, Format, Headline, Result, Table, progress};
use experiments::EstimateExt;
use experiments::convergence::{EndCase, EndRun};
use fractional_sobolev::Estimate;
use signorini::{mesh::Outline, problems::DirichletEnd};
use std::f64::consts::{LN_10, PI};
use std::process::ExitCode;

example_frame::options! {
    /// Resolve the clamped end of the contact edge over dozens of decades
    pub struct Options {
        /// Sectors of a ring, a multiple of 4; also solved with twice as many
        #[arg(long, default_value_t = 12)]
        pub angles: usize,
        /// The rings end below this radius
        #[arg(long, default_value_t = 1e-40)]
        pub smallest: f64,
    }
}

/// Poisson's ratios; the scalar problem comes last.
const POISSON: [f64; 4] = [-0.5, 0.0, 0.25, 0.35];
/// Loads and their directions in degrees; a scalar body knows the first two.
const LOADS: [(&str, f64); 4] = [("pull", 90.0), ("press", -90.0), ("back", 180.0), ("forth", 0.0)];
/// A scaled condition may be violated by this, as in Section 2.
const KKT_LIMIT: f64 = 1e-10;
/// What a second solver and a sum of forces must confirm.
const DIGITS: f64 = 1e-8;
/// Solves all bodies under all loads, each with the name of its load.
pub fn compute(options: &Options) -> Result<Vec<(&'static str, EndCase)>> {
    let Options { angles, smallest, .. } = *options;
    let elastic = POISSON.iter().flat_map(|&nu| LOADS.map(|load| (Some(nu), load)));
    let all: Vec<_> = elastic.chain(LOADS[..2].iter().map(|&load| (None, load))).collect();
    let mut cases = Vec::new();
    for (poisson, (load, direction)) in progress(all.len() as u64).wrap_iter(all.into_iter()) {
        let (outline, step) = (Outline::HalfDisc, PI / angles as f64);
        let scene = DirichletEnd { outline, angles, step, smallest, poisson, direction };
        cases.push((load, EndCase::of(scene)?));
    }
    Ok(cases)
}

/// What decides: signs of contact at the end, borders on all roads, powers, the conditions by decade.
pub fn findings(options: &Options, cases: &[(&str, EndCase)]) -> Vec<Finding> {
    let elastic = || cases.iter().map(|(_, case)| case).filter(|case| case.scene.poisson.is_some());
    let worst = |of: &dyn Fn(&EndCase) -> f64| cases.iter().map(|(_, case)| of(case)).fold(0.0, f64::max);
    let open = elastic().flat_map(EndCase::resolved).filter(|run| !run.touches()).count();
    let most = worst(&|case| case.transitions() as f64);
    let powers = elastic().filter_map(|case| case.limit(|run| run.power));
    let power = powers.max_by(|a, b| (a.value + 0.5).abs().total_cmp(&(b.value + 0.5).abs()));
    let shape = elastic().filter_map(|case| case.runs[1].shape).fold(0.0, f64::max);
    let kkt = worst(&|case| case.resolved().map(EndRun::worst_decade).fold(0.0, f64::max));
    let two_rings = 2.0 * PI / options.angles as f64 / LN_10;
    let (starts, moved) = (worst(&|case| case.starts_apart() as f64), worst(&EndCase::moved));
    let apart = |run: fn(&EndCase) -> &EndRun| worst(&|case| case.runs[0].apart(run(case)));
    let (deeper, cones) = (apart(|case| &case.again[1]), apart(|case| &case.others[0]));
    let (energy, sets) = (worst(&EndCase::energies_apart), worst(&|case| case.solvers_apart() as f64));
    let force = worst(&|case| case.runs[1].solution.balance);
    let odd = cases.iter().filter(|(_, case)| case.scene.poisson.is_none() && case.transitions() > 0).count();
    let decided = [
        ("end", "every elastic body touches at the end", open as f64, 0.0, "the theorem"),
        ("transitions", "no edge has more than {value} transitions", most, 2.0, "zone, gap, contact"),
        ("scalar", "a scalar body is open or closed to the end", odd as f64, 0.0, "real exponents"),
        ("shape", "the zone's pressure is the closed form to {percent} %", shape, 0.05, "width of the rings"),
        ("deeper", "half the decades give the same places", deeper, 0.5 * two_rings, "one ring"),
        ("angles", "twice the angles move a border by {percent} % of ln r", moved, 0.25, "h^2/epsilon^2"),
        ("kkt", "every condition is met in every decade", kkt, KKT_LIMIT, "as in Section 2"),
        ("starts", "no contact and full contact lead to one set", starts, 0.0, "one solution"),
        ("cones", "the midpoint cone's borders are {value} decades apart", cones, two_rings, "two rings"),
        ("sets", "two solvers find one set, node by node, in every decade", sets, 0.0, "one solution"),
        ("solvers", "the general solver agrees in J to {value}", energy, DIGITS, "eight digits"),
        ("forces", "loads, reactions and contact add up to zero", force, DIGITS, "eight digits"),
    ];
    let decided = decided.into_iter().enumerate().map(|(k, (key, words, value, bound, source))| {
        let finding = Finding::claim(key, words).number(value, 0.0).at_most(bound, source);
        if k < 4 { finding.told() } else { finding }
    });
    let mut found = vec![
        Finding::claim("theorem", "contact reaches the clamped end, and no gap is near it")
            .by_proof("section_1_clamped_end"),
        Finding::claim("power", "the pressure at the end is r to the power {value}")
            .estimate_or(power, "no contact at the end")
            .within(0.01, -0.5, "clamped and closed sides: u = r^(1/2)")
            .told(),
        Finding::remark("interior", "one barrier for all decades sees the contact set down to r = {value}")
            .number(worst(&EndCase::unseen_below), 0.0)
            .at_most(1e-6, "forces farther in are below its accuracy"),
        Finding::remark("reach", "a gap between contacts has {value} times the decades of one zone's field")
            .estimate_or(Estimate::smallest(elastic().filter_map(EndCase::reach)), "no body has such a gap")
            .at_least(1.0, "where the closed form closes again"),
    ];
    found.extend(decided);
    found
}

/// Solves, decides, draws contact and gaps over ln r.
pub fn run(options: &Options) -> Result<Headline> {
    let cases = compute(options)?;
    let claim = "a clamped body touches at the end of its contact edge, and has no transition near it";
    let found = findings(options, &cases);
    let mut headline = Headline::new("Section 1, clamped end", claim, table(&cases), found);
    headline.draw(&options.output, "section_1_clamped_end", || Ok(draw(&cases)))?;
    Ok(headline)
}

fn table(cases: &[(&str, EndCase)]) -> Table {
    let (two, error) = (Format::Fixed(2), Format::Scientific(0));
    let columns = vec![
        Column::new("poisson", "nu_P", Format::Plain, "Poisson's ratio; none: scalar"),
        Column::new("load", "load", Format::Plain, "traction on the outline"),
        Column::new("end", "end", Format::Plain, "what reaches the end"),
        Column::new("coarse", "to, n", two, "log10 of where it ends, n angles"),
        Column::new("fine", "to, 2n", two, "the same, 2n angles; none: everywhere"),
        Column::new("outer", "gap to", two, "log10 of where the gap ends"),
        Column::new("power", "power", Format::Fixed(3), "of the pressure at the end, limit of both meshes"),
        Column::new("energy", "J", Format::Significant(4), "limit of both meshes"),
        Column::new("energy_error", "+-", error, "its distance from the finer value"),
        Column::new("force", "force", Format::Significant(3), "contact force, limit of both meshes"),
        Column::new("force_error", "+-", error, ""),
        Column::new("kkt", "KKT", error, "worst condition in any decade, finer mesh"),
        Column::hidden("by_decade"),
    ];
    Table::new(columns).with_rows(cases.iter().map(|(load, case)| {
        let [coarse, fine] = &case.runs;
        let end = if fine.touches() { "contact" } else { "gap" };
        let border = |run: &EndRun, k: usize| Cell::from(run.borders().get(k).copied());
        let pair = |e: Option<Estimate>| [e.map(|e| e.value), e.map(|e| e.error)].map(Cell::from);
        let first = [case.scene.poisson.into(), (*load).into(), end.into(), border(coarse, 0)];
        let second = [border(fine, 0), border(fine, 1), case.limit(|run| run.power).map(|e| e.value).into()];
        let energy = pair(case.limit(|run| Some(run.solution.energy)));
        let force = pair(case.limit(|run| Some(run.solution.contact_force)));
        let decades: Vec<f64> =
            fine.by_decade().into_iter().map(|touches| f64::from(u8::from(touches))).collect();
        let last = [fine.worst_decade().into(), decades.into()];
        first.into_iter().chain(second).chain(energy).chain(force).chain(last)
    }))
}

/// One row per body and load: what every decade is.
fn draw(cases: &[(&str, EndCase)]) -> Chart {
    let dots = |wanted: bool| {
        let row = |(k, (_, case)): (usize, &(&str, EndCase))| {
            let decades = case.runs[1].by_decade().into_iter().enumerate().filter(move |d| d.1 == wanted);
            decades.map(|(j, _)| (-0.5 - j as f64, -(k as f64))).collect::<Vec<_>>()
        };
        cases.iter().enumerate().flat_map(row).collect()
    };
    let body = |case: &EndCase| case.scene.poisson.map_or("scalar".to_owned(), |nu| nu.to_string());
    let names = cases.iter().map(|(load, case)| format!("{} {load}", body(case))).collect();
    let (x, y) = (Axis::linear("log10 of the distance from the end"), Axis::rows(names));
    let chart = Chart::new("Contact and gap near a clamped end, by Poisson's ratio and load", x, y);
    chart.with(Series::points("contact", dots(true))).with(Series::points("gap", dots(false)))
}

fn main() -> ExitCode {
    example_frame::main(run)
}
