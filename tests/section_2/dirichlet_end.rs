//! Section 1, clamped end: contact reaches the end of the edge, whatever the load, and no gap is near it.

use crate::contact_zone::ContactZone;
use signorini::Result;
use signorini::cone::{Cone, ContactSet};
use signorini::contact::{ContactSolution, Settings, Solver, Start};
use signorini::edge::{RadialInterval, radial_intervals};
use signorini::mesh::Outline;
use signorini::problems::DirichletEnd;

const SCENE: DirichletEnd = DirichletEnd {
    outline: Outline::HalfDisc,
    angles: 12,
    step: 0.25,
    smallest: 1e-40,
    poisson: Some(0.25),
    direction: 90.0,
};

/// The solution from no contact, contact and gaps beyond ten times the innermost ring, and the worst violated condition of
/// any decade.
fn solve(scene: &DirichletEnd) -> Result<(ContactSolution, Vec<RadialInterval>, f64)> {
    let problem = scene.problem()?;
    let solution = problem.solve(Cone::Nodal, Solver::ActiveSet)?;
    let radii = problem.edge().arc();
    let first = radii.partition_point(|&r| r < 10.0 * radii[1]);
    let read = (first..radii.len()).map(|i| solution.contact_set.contains(i)).collect::<Vec<_>>();
    let parts = radial_intervals(&radii[first..], &ContactSet::new(&read))?;
    let decades: Vec<f64> =
        (0..=-scene.smallest.log10().floor() as i32).rev().map(|k| 10f64.powi(-k)).collect();
    let residuals = problem.kkt_by_radius(&solution, [0.0; 2], &decades)?;
    let worst = residuals.iter().map(|decade| decade.worst()).fold(0.0, f64::max);
    Ok((solution, parts, worst))
}

/// Pulled, pressed and sheared: contact at the end, from no contact and from full contact.
#[test]
fn every_elastic_body_touches_at_the_end() {
    for (poisson, direction) in [(-0.5, 90.0), (0.0, -90.0), (0.0, 180.0), (0.25, 0.0)] {
        let scene =
            DirichletEnd { angles: 8, smallest: 1e-20, poisson: Some(poisson), direction, ..SCENE };
        let (solution, parts, worst) = solve(&scene).unwrap();
        assert!(
            parts[0].in_contact && parts.len() <= 3 && worst < 1e-10,
            "{scene:?}: {parts:?} {worst}"
        );
        let full = ContactSet::new(&vec![true; solution.positions.len()]);
        let settings = Settings { start: Start::Set(full), ..Settings::default() };
        let closed = scene.problem().unwrap().solve(Cone::Nodal, settings).unwrap();
        // Nothing is decided at the end itself.
        assert_eq!(
            solution.contact_set.as_slice()[1..],
            closed.contact_set.as_slice()[1..],
            "{scene:?}"
        );
    }
    let scalar = DirichletEnd { poisson: None, smallest: 1e-20, ..SCENE };
    assert!(
        [90.0, -90.0].iter().all(|&direction| {
            solve(&DirichletEnd { direction, ..scalar }).unwrap().1.len() == 1
        })
    );
}

/// The zone of the closed form: the pressure follows it over four decades, the gap beyond too.
#[test]
fn the_zone_of_a_pulled_body_is_the_closed_form() {
    let (solution, parts, _) = solve(&SCENE).unwrap();
    let radius = parts[0].to;
    let zone = ContactZone::new(0.25, radius);
    let radii = SCENE.problem().unwrap().edge().arc().to_vec();
    // The border is known to half a ring, 12 % of ℓ; the pressure at ℓ/4 changes by a third of that.
    let quotients: Vec<f64> = (0..radii.len())
        .filter(|&i| 1e-4 * radius <= 4.0 * radii[i] && 4.0 * radii[i] <= radius)
        .map(|i| (solution.pressure[i] / zone.pressure(radii[i])).ln())
        .collect();
    let mean = quotients.iter().sum::<f64>() / quotients.len() as f64;
    let off = quotients.iter().map(|q| (q - mean).abs().exp_m1()).fold(0.0, f64::max);
    assert!(quotients.len() > 10 && off < 0.05, "{off}");
    let ratio: Vec<f64> = (0..radii.len())
        .filter(|&i| 1e2 * radius < radii[i] && radii[i] < 1e4 * radius)
        .map(|i| -solution.normal_displacement[i] / zone.opening(radii[i]))
        .collect();
    let (low, high) = ratio.iter().fold((f64::INFINITY, 0.0f64), |(l, h), &r| (l.min(r), h.max(r)));
    assert!(ratio.len() > 10 && low > 0.0 && high / low < 1.2, "{low} {high}");
}

/// Near Poisson's ratio 1/2 ε is small, and coarse rings, which have an ε of their own, move the zone by many
/// decades: they keep it.
#[test]
fn coarse_rings_move_the_zone_and_keep_it() {
    let borders = |angles: usize| {
        let step = std::f64::consts::PI / angles as f64;
        let scene = DirichletEnd { angles, step, poisson: Some(0.45), smallest: 1e-60, ..SCENE };
        let (_, parts, worst) = solve(&scene).unwrap();
        assert!(parts[0].in_contact && worst < 1e-10, "{parts:?}");
        parts.iter().skip(1).map(|part| part.from.log10()).collect::<Vec<f64>>()
    };
    let (coarse, fine) = (borders(8), borders(32));
    assert!(coarse.len() == 1 && fine.len() == 1, "{coarse:?} {fine:?}");
    assert!(coarse[0] < fine[0] - 5.0 && fine[0] < -15.0, "{coarse:?} {fine:?}");
}

#[test]
fn what_collapses_is_refused() {
    for scene in [
        DirichletEnd { angles: 10, ..SCENE },
        DirichletEnd { step: 0.0, ..SCENE },
        DirichletEnd { smallest: 1e-200, ..SCENE },
        DirichletEnd { poisson: Some(0.5), ..SCENE },
        DirichletEnd { direction: f64::INFINITY, ..SCENE },
    ] {
        assert!(scene.problem().is_err(), "{scene:?}");
    }
}
