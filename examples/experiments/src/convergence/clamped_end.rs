//! What happens at a clamped end: contact and gaps in ln r, the power of the pressure, the conditions by
//! decade.
//!
//! The fan that closes the innermost ring spoils what is near it, by the order of the ratio of radii: the
//! innermost decade is not read. In the midpoint cone the multipliers of a singular pressure ring, so that
//! every other segment may be off the set: a single segment between two that touch is read as contact. The
//! power is the slope of ln(−σ_N) against ln r over the contact that reaches the end, without its first two
//! and last eight decades. The shape compares the pressure with the closed form [`ContactZone`] of the same
//! length over the last four decades before ℓ/4: largest relative deviation, one common factor.

use super::regression::regression;
use signorini::Result;
use signorini::cone::{Cone, ContactSet, KktResiduals};
use signorini::contact::{self, ContactSolution, Settings, Solver};
use signorini::edge::{RadialInterval, radial_intervals};
use signorini::problems::DirichletEnd;
use signorini::singular::ContactZone;

/// How a scene is solved.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EndMethod {
    /// The active set, from no contact.
    Open,
    /// The active set, from full contact.
    Closed,
    /// The interior point method on the whole body: one barrier for all decades.
    Interior,
    /// The interior point method on the edge whose barrier expects displacements of size r^{1/2}; nodal cone
    /// only.
    Scaled,
}

/// A solved scene, read at the end of its contact edge.
#[derive(Debug, Clone)]
pub struct EndRun {
    /// Contact and gaps, from the end outwards.
    pub intervals: Vec<RadialInterval>,
    /// The conditions of every decade [10^−k, 10^{−k+1}), outermost first, by the scales of the decade.
    pub decades: Vec<KktResiduals>,
    /// The power of the pressure at the end; `None` without fourteen decades of contact there.
    pub power: Option<f64>,
    /// How far the pressure is from the closed form; `None` without a zone that ends inside, or for scalar
    /// scenes.
    pub shape: Option<f64>,
    /// The solution.
    pub solution: ContactSolution,
}

impl EndRun {
    /// Solves the scene.
    ///
    /// # Errors
    /// As for [`DirichletEnd::problem`] and [`signorini::contact::ContactProblem::solve`].
    pub fn of(scene: &DirichletEnd, cone: Cone, start: EndMethod) -> Result<Self> {
        let problem = scene.problem()?;
        let radii = problem.edge().arc();
        let full = ContactSet::new(vec![true; cone.constraints(radii.len())]);
        let solution = match start {
            EndMethod::Open => problem.solve(cone, Solver::ActiveSet)?,
            EndMethod::Closed => {
                problem.solve(cone, Settings { start: contact::Start::Set(full), ..Settings::default() })?
            }
            EndMethod::Interior => problem.solve(cone, Solver::InteriorPoint)?,
            EndMethod::Scaled => {
                let (solver, sizes) = (Solver::EdgeInteriorPoint, sizes(radii));
                problem.solve(cone, Settings { solver, sizes: Some(&sizes), ..Settings::default() })?
            }
        };
        let fan = solution.positions.partition_point(|&r| r < FAN * radii[1]);
        let read = read_set(cone, &solution.contact_set, fan);
        let intervals = radial_intervals(&solution.positions[fan..], &read)?;
        let count = (-scene.smallest.log10()).ceil() as i32;
        let bounds: Vec<f64> = (0..=count).rev().map(|k| 10f64.powi(-k)).collect();
        let mut decades = problem.kkt_by_radius(&solution, [0.0; 2], &bounds)?;
        decades.reverse();
        let pressure: Vec<(f64, f64)> =
            radii.iter().copied().zip(solution.pressure.iter().copied()).skip(1).collect();
        let zone = intervals.first().filter(|first| first.in_contact).copied();
        let is_inside = intervals.len() > 1;
        let power = zone.and_then(|zone| power(&pressure, &zone));
        let shape = match (scene.poisson, zone) {
            (Some(poisson), Some(zone)) if is_inside => {
                shape(&pressure, &ContactZone::new(poisson, zone.to)?, zone.to)
            }
            _ => None,
        };
        Ok(Self { intervals, decades, power, shape, solution })
    }

    /// The worst figure of any decade.
    pub fn worst_decade(&self) -> f64 {
        self.decades.iter().map(KktResiduals::worst).fold(0.0, f64::max)
    }

    /// True when the body touches at the end.
    pub fn touches(&self) -> bool {
        self.intervals.first().is_some_and(|part| part.in_contact)
    }

    /// The largest distance of the borders of two runs, in decades; infinite when one has more of them.
    pub fn apart(&self, other: &Self) -> f64 {
        let (a, b) = (self.borders(), other.borders());
        let pairs = a.iter().zip(&b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        if a.len() == b.len() { pairs } else { f64::INFINITY }
    }

    /// Contact (true) or gap at the geometric middle of every decade below 1 that is read, outermost first.
    pub fn by_decade(&self) -> Vec<bool> {
        let innermost = self.intervals.first().map_or(1.0, |part| part.from);
        let middles = (0..self.decades.len()).map(|k| 10f64.powf(-0.5 - k as f64));
        let touches = |r: f64| self.intervals.iter().any(|p| p.in_contact && p.from <= r && r <= p.to);
        middles.take_while(|&r| r >= innermost).map(touches).collect()
    }

    /// log₁₀ of the radii at which contact and gap meet, from the end outwards.
    pub fn borders(&self) -> Vec<f64> {
        self.intervals.iter().skip(1).map(|part| part.from.log10()).collect()
    }
}

/// What is nearer than this many times the innermost ring is not read.
const FAN: f64 = 10.0;

/// The contact set from the constraint `first` on, single open segments of the midpoint cone closed.
fn read_set(cone: Cone, set: &ContactSet, first: usize) -> ContactSet {
    let is_in = |i: usize| set.as_slice().get(i).copied().unwrap_or(true);
    let alone = |i: usize| cone == Cone::Midpoint && i > 0 && is_in(i - 1) && is_in(i + 1);
    ContactSet::new((first..set.constraints()).map(|i| is_in(i) || alone(i)).collect())
}

/// r^{1/2} at every node; at the end itself, where nothing is decided, that of its neighbour.
fn sizes(radii: &[f64]) -> Vec<f64> {
    radii.iter().map(|r| r.max(radii[1]).sqrt()).collect()
}

fn power(pressure: &[(f64, f64)], zone: &RadialInterval) -> Option<f64> {
    if zone.decades() < 14.0 {
        return None;
    }
    let inner = |r: f64| 100.0 * zone.from <= r && r <= 1e-8 * zone.to;
    // Nearest to the end last: there the power is read.
    let points: Vec<(f64, f64)> =
        pressure.iter().rev().copied().filter(|&(r, p)| inner(r) && p > 0.0).collect();
    regression(&points).map(|found| found.order)
}

fn shape(pressure: &[(f64, f64)], zone: &ContactZone, length: f64) -> Option<f64> {
    let near = |r: f64| 1e-4 * length <= 4.0 * r && 4.0 * r <= length;
    let quotients: Vec<f64> =
        pressure.iter().filter(|(r, _)| near(*r)).map(|&(r, p)| (p / zone.pressure(r)).ln()).collect();
    let mean = quotients.iter().sum::<f64>() / quotients.len() as f64;
    (quotients.len() > 2).then(|| quotients.iter().map(|q| (q - mean).abs().exp_m1()).fold(0.0, f64::max))
}
