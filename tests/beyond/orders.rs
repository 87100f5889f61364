//! Orders of convergence of discrete solutions whose order is known: the uncertainty of [`ConvergenceOrder`] contains it in
//! at least 95 of 100 runs as a reader may choose them, 5 to 10 levels of strips up to 2^13 cells and of corners.
//!
//! `ORDER_RUNS=500 cargo test --release --test attacks orders -- --nocapture` for more than the few runs of every day, and for a
//! list of those that are not contained.

use signorini::cone::Cone;
use signorini::contact::{ContactProblem, Solver};
use signorini::fem::Form;
use signorini::mesh::Hierarchy;
use signorini::problems::{Parameters, StripData, TestProblem, solution_regularity};
use signorini::rates::{ConvergenceOrder, order_between};
use signorini::strip::{EdgeSolution, Reference, StripKind, StripProblem};

/// Runs unless `ORDER_RUNS` asks for more.
const RUNS: usize = if crate::MANY { 100 } else { 20 };
/// One run in so many is a corner.
const CORNERS: usize = 10;
/// Share of the runs that contain the true order.
const CONTAINED: f64 = 0.95;

/// A generator with a fixed seed, uniform on (low, high).
struct Random(u64);

impl Random {
    fn within(&mut self, low: f64, high: f64) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        low + (high - low) * (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    fn below(&mut self, count: usize) -> usize {
        self.within(0.0, count as f64) as usize
    }
}

/// Errors on the levels of one problem, coarsest first, and the order as h → 0.
struct Run {
    what: String,
    order: f64,
    levels: Vec<(f64, f64)>,
    /// Mesh size of the discrete solution that stands for the exact one.
    reference: Option<f64>,
}

impl Run {
    fn read(&self) -> ConvergenceOrder {
        ConvergenceOrder::against(&self.levels, self.reference).unwrap()
    }

    fn contains(&self) -> bool {
        let found = self.read();
        (found.order - self.order).abs() <= found.uncertainty
    }

    fn words(&self) -> String {
        let slopes = self.levels.windows(2).map(|pair| format!("{:.3}", order_between(pair[0], pair[1])));
        let slopes: Vec<String> = slopes.collect();
        format!("{}: {}, true {:.4}; between levels {}", self.what, self.read(), self.order, slopes.join(" "))
    }

    /// Levels 2^coarsest ... 2^finest of a strip.
    fn strip(
        kind: StripKind,
        scene: &StripData,
        tau: f64,
        cone: Cone,
        (coarsest, finest): (u32, u32),
    ) -> Self {
        // The grid of the data as `section_2_strip` takes it.
        let cells = 1 << (finest + 6).min(20).max(finest + 2);
        let data = scene.data(tau, cells, kind.sides()).unwrap();
        let problem = StripProblem::new(kind, &data, Reference::Nested, 1 << coarsest).unwrap();
        let solutions = problem.solutions(cone, 1 << coarsest, 1 << finest).unwrap();
        let level = |u: &EdgeSolution| (1.0 / u.cells as f64, problem.error(u).unwrap().value);
        Self {
            levels: solutions.iter().map(level).collect(),
            what: format!("{kind} strip, {scene}, tau {tau}, {cone}, levels {coarsest}-{finest}"),
            order: (tau - 1.0).min(1.0),
            reference: None,
        }
    }

    /// A strip at random: half of them scalar, τ as far as there are data, one transition in four of five.
    fn random_strip(random: &mut Random) -> Self {
        let kind = [StripKind::Scalar, StripKind::Elastic][random.below(2)];
        let largest = if kind == StripKind::Scalar { 2.0 } else { 2.5 };
        let tau = match random.below(10) {
            0 => 2.0,
            1 | 2 => random.within(1.9, 2.0),
            3 if largest > 2.0 => random.within(2.0, 2.1),
            _ => random.within(1.501, largest),
        };
        let tau = (1e3 * tau).round() / 1e3;
        let cone = [Cone::Nodal, Cone::Midpoint][random.below(2)];
        let count = 5 + random.below(6) as u32;
        let finest = if random.below(4) == 0 { 13 } else { 11 };
        let coarsest = 2 + random.below((finest - count) as usize) as u32;
        let scene = match random.below(20) {
            0 => StripData::Transitions { gaps: 1 + random.below(2) },
            1 if tau < 2.0 => StripData::FatCantor { depth: 15 },
            2 if tau <= 2.0 => StripData::Cantor { ratio: random.within(0.2, 0.4), depth: 12 },
            3..=6 => StripData::Transition { position: (1 + random.below(7)) as f64 / 8.0 },
            7..=9 => StripData::Transition { position: (1 + random.below(6)) as f64 / 7.0 },
            _ => StripData::Transition { position: random.within(0.1, 0.9) },
        };
        Self::strip(kind, &scene, tau, cone, (coarsest, coarsest + count - 1))
    }

    /// A corner of the given opening in degrees between u = 0 and the contact edge, without contact: f = −1. The order is
    /// that of the singular exponent, the solution on the next refinement stands for the exact one.
    fn corner(angle: f64, coarsest: usize, count: usize) -> Self {
        let setting = Parameters { angle, ..Parameters::default() };
        let mesh = TestProblem::Corner.mesh_with(coarsest, &setting).unwrap();
        let hierarchy = Hierarchy::refined(mesh, count).unwrap();
        let solved = |level: usize| {
            let mesh = hierarchy.levels()[level].clone();
            let load = vec![-1.0; mesh.nodes().len()];
            let problem = ContactProblem::new(mesh, Form::LAPLACE, &load).unwrap();
            let solution = problem.solve(Cone::Nodal, Solver::ActiveSet).unwrap();
            (problem, solution)
        };
        let (problem, finest) = solved(count);
        let order = solution_regularity(&problem, &finest).unwrap().tau - 1.0;
        let levels = (0..count).map(|level| {
            let coarse = solved(level).1.displacement;
            let (coarse, fine) = ((level, &coarse[..]), (count, &finest.displacement[..]));
            let error = problem.nested_energy_error(&hierarchy, coarse, fine).unwrap();
            (1.0 / (coarsest << level) as f64, error)
        });
        Self {
            levels: levels.collect(),
            what: format!("corner of {angle:.1} degrees, n = {coarsest} and {count} levels"),
            order: order.min(1.0),
            reference: Some(1.0 / (coarsest << count) as f64),
        }
    }
}

#[test]
fn the_uncertainty_contains_the_order_of_random_runs() {
    let runs = std::env::var("ORDER_RUNS").ok().map_or(RUNS, |text| text.parse().expect("ORDER_RUNS"));
    let mut random = Random(20_261_125);
    let (mut contained, mut widths) = (0, Vec::new());
    for k in 0..runs {
        let run = if k % CORNERS == 0 {
            Run::corner(random.within(20.0, 160.0), 2 + random.below(2), 5)
        } else {
            Run::random_strip(&mut random)
        };
        widths.push(run.read().uncertainty);
        contained += usize::from(run.contains());
        if !run.contains() {
            println!("not contained: {}", run.words());
        }
    }
    widths.sort_by(f64::total_cmp);
    let quantile = |share: f64| widths[(share * (runs - 1) as f64) as usize];
    let [tenth, median, ninth] = [0.1, 0.5, 0.9].map(quantile);
    println!("{contained} of {runs} contained; uncertainty {median:.3} (median), {tenth:.3} to {ninth:.3}");
    assert!(contained as f64 >= CONTAINED * runs as f64, "{contained} of {runs}");
    // An uncertainty that says nothing would contain everything.
    assert!(median < 0.15, "{median}");
}

#[test]
fn many_levels_without_scatter_are_read_sharply() {
    // A place that is a node of every level. At tau = 1.6 the grid of the data, 64 times finer than the finest level,
    // leaves 0.7 % of the square there, which a slow term explains as well.
    let scene = StripData::Transition { position: 0.5 };
    for (tau, width) in [(2.5, 0.06), (1.6, 0.1)] {
        let run = Run::strip(StripKind::Elastic, &scene, tau, Cone::Nodal, (4, 12));
        assert!(run.contains() && run.read().uncertainty < width, "{}", run.words());
    }
}
