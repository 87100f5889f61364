//! Section 2, your own body: a mesh from Gmsh, a load in x and y, and the floor under every contact edge.
//!
//! `cargo run --release --example section_2_own_body -- --mesh FILE.msh --load "0, -0.1" --out DIR --csv DIR`

use example_frame::contact::{self, ContactSubject, Load, Own, OwnOptions, worst};
use example_frame::{Finding, Headline, Result};
use experiments::contact_levels::SceneRun;
use signorini::cone::{Cone, KKT_ROUNDING, KktResiduals};
use signorini::fem::{Form, Lame};
use signorini::rates::order_between;
use std::process::ExitCode;

/// The body that comes with the example: an L on a slanted floor.
const SAMPLE: &str = include_str!("data/l_shape.msh");
/// It lifts the arm and presses both ends of the foot on the floor.
const LOAD: &str = "0.015, 0.02 - 0.03*x";

example_frame::options! {
    /// Solve a contact problem on a mesh of Gmsh with a load given by expressions, and check what must hold
    pub struct Options {
        /// Number of meshes: the one given, and every triangle cut into four, and again
        #[arg(long, default_value_t = 4)]
        pub levels: usize,
        /// Discrete cone: nodal (2.9) or midpoint (4.1)
        #[arg(long, default_value_t = Cone::Nodal)]
        pub cone: Cone,
        /// The angle by which body and load are turned for a check, degrees
        #[arg(long, default_value_t = 50.0)]
        pub angle: f64,
        /// The body; without one an L on a slanted floor
        #[command(flatten)]
        pub own: OwnOptions,
    }
}

/// Everything on every mesh.
pub struct Computed {
    subject: ContactSubject,
    /// All solutions, coarsest mesh first, on each mesh one solver after the other.
    pub runs: Vec<SceneRun>,
    /// On every mesh the resultants of load, clamp and floors.
    pub resultants: Vec<[[f64; 2]; 3]>,
    /// Solutions of the same body turned, in the same order.
    pub turned: Vec<SceneRun>,
}

/// Solves the body as it is given, and turned.
pub fn compute(options: &Options) -> Result<Computed> {
    let Options { levels, cone, angle, own, .. } = options;
    let mut own = own.clone();
    if !own.is_own() {
        own.load = Some(LOAD.parse()?);
    }
    let is_scalar = own.load.as_ref().is_some_and(|load: &Load| load.components() == 1);
    let form = if is_scalar { Form::LAPLACE } else { Form::elastic(Lame::new(1.0, 1.0)?) };
    let body = own.body(|| Own::sample("l_shape", SAMPLE), form, 1.0)?;
    let turned = ContactSubject::own(body.turned(*angle)?, *cone, *levels, &own)?;
    let subject = ContactSubject::own(body.clone(), *cone, *levels, &own)?;
    let runs = subject.solve()?;
    let resultants = runs.iter().map(|run| body.resultants(run)).collect::<Result<_>>()?;
    Ok(Computed { subject, resultants, turned: turned.solve()?, runs })
}

/// What a sum over all nodes, a second solver or another frame must confirm.
const EIGHT_DIGITS: f64 = 1e-8;
/// Standard deviations of rounding that count, those of both bodies of a comparison together.
const ROUNDINGS: f64 = 8.0;
/// A scaled condition may be violated by a duality gap of 1e-13 over 1000 unknowns.
const KKT_LIMIT: f64 = 1e-10;

/// What decides: forces balance, every condition is met, solvers agree, J falls, and directions do not
/// matter.
pub fn findings(options: &Options, computed: &Computed) -> Vec<Finding> {
    let Computed { runs, resultants, turned, .. } = computed;
    let kkt: Option<Vec<KktResiduals>> = runs.iter().map(|run| run.kkt().ok()).collect();
    let imbalance = |forces: &[[f64; 2]; 3]| {
        let size = |[x, y]: [f64; 2]| x.hypot(y);
        let sum = forces.iter().fold([0.0; 2], |sum, f| [sum[0] + f[0], sum[1] + f[1]]);
        size(sum) / forces.iter().map(|&f| size(f)).sum::<f64>()
    };
    // Stiffnesses cancel in every sum of forces: what their rounding leaves, relative to the forces and to J.
    let rounding = |run: &SceneRun, forces: &[[f64; 2]; 3]| {
        let size = forces.iter().map(|[x, y]| x.hypot(*y)).sum::<f64>();
        ROUNDINGS * (run.solution.force_rounding / size)
    };
    let rounded = worst(runs.iter().zip(resultants).map(|(run, forces)| rounding(run, forces)));
    let force = runs.last().map(|run| (run.solution.contact_force, run.solution.balance));
    let mut found = vec![
        Finding::claim("forces", "the resultants of load, clamp and floor add up to zero")
            .number(worst(resultants.iter().map(imbalance)), rounded.max(KKT_ROUNDING))
            .at_most(EIGHT_DIGITS, "eight digits of a sum over all nodes")
            .otherwise("the resultants of load, clamp and floor add up to {value} of their sizes"),
        Finding::claim("push", "the floor pushes with {value}")
            .number_or(force, "no solution")
            .at_least(0.0, "sigma_N <= 0")
            .otherwise("the floor pulls, {value}")
            .told(),
    ];
    for (key, holds, fails, figure) in contact::CONDITIONS {
        let worst = kkt.as_ref().map(|all| (worst(all.iter().map(figure)), KKT_ROUNDING));
        let condition = Finding::claim(key, holds).number_or(worst, "a force or a gap is not a number");
        found
            .push(condition.at_most(KKT_LIMIT, "a duality gap of 1e-13 over 1000 unknowns").otherwise(fails));
    }
    found.extend(contact::solvers_agree(runs, EIGHT_DIGITS));
    let apart = |[a, b]: [f64; 2]| if a == b { 0.0 } else { (a - b).abs() / a.abs() };
    let figures = |run: &SceneRun| [run.solution.energy, run.solution.contact_force];
    let pairs = runs.iter().zip(turned).map(|(run, other)| (figures(run), figures(other)));
    let directions = pairs.flat_map(|([j, f], [k, g])| [apart([j, k]), apart([f, g])]);
    found.push(
        Finding::claim(
            "turned",
            "turned by the angle asked for it has the same J and the same force, apart by {value}",
        )
        .number_or(Some((worst(directions), rounded)).filter(|_| runs.len() == turned.len()), "other meshes")
        .at_most(EIGHT_DIGITS, "eight digits in another frame")
        .otherwise("turned it has another J or another force, apart by {value}")
        .told(),
    );
    found.extend(energies(options.cone, runs));
    found
}

/// J from mesh to mesh: it does not rise where cones are nested, and how fast it falls.
fn energies(cone: Cone, runs: &[SceneRun]) -> Vec<Finding> {
    let first = runs.first().map(|run| run.solution.solver);
    let j: Vec<f64> =
        runs.iter().filter(|run| Some(run.solution.solver) == first).map(|run| run.solution.energy).collect();
    let gained: Vec<f64> = j.windows(2).map(|pair| pair[0] - pair[1]).collect();
    let least = gained
        .iter()
        .map(|gain| (if *gain == 0.0 { 0.0 } else { gain / j[0].abs() }, 0.0))
        .reduce(|a, b| if a.0 < b.0 { a } else { b });
    let order = match gained[..] {
        [.., before, last] if before > 0.0 && last > 0.0 => {
            Some((order_between((1.0, before), (0.5, last)), 0.0))
        }
        _ => None,
    };
    let words = "J does not rise from mesh to mesh";
    let falls = if cone == Cone::Nodal { Finding::claim } else { Finding::remark };
    let falls = least.map(|least| {
        falls("falls", words)
            .number(least.0, least.1)
            .at_least(-EIGHT_DIGITS, "nested cones, up to eight digits for the load")
            .otherwise("J rises from one mesh to the next, by {value} of its size")
    });
    let order = (gained.len() > 1).then(|| {
        Finding::remark("order", "the last two halvings of h show J converge with order {value}")
            .number_or(order, "J does not fall")
            .at_least(1.0, "corners with exponents above 1/2, as those of the L")
            .otherwise("the last two halvings of h show J converge with order {value} only")
            .told()
    });
    falls.into_iter().chain(order).collect()
}

/// Solves the body and says how well it obeys the laws of contact.
pub fn run(options: &Options) -> Result<Headline> {
    let computed = compute(options)?;
    let Computed { subject, runs, .. } = &computed;
    let claim = "a body from Gmsh is solved: one minimum, every condition met, forces in balance";
    let found = findings(options, &computed);
    let mut headline = Headline::new("Section 2, your own body", claim, subject.table(runs), found);
    subject.finish(&mut headline, runs, &options.own, &options.output)?;
    Ok(headline)
}

fn main() -> ExitCode {
    example_frame::main(run)
}
