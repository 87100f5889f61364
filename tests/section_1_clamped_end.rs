//! Section 1, clamped end: contact reaches the end of the edge, whatever the load, and no gap is near it.

#[allow(dead_code)]
#[path = "../examples/section_1_clamped_end.rs"]
mod example;

use example_frame::Outcome;
use experiments::convergence::{EndCase, EndMethod, EndRun};
use signorini::cone::Cone;
use signorini::mesh::Outline;
use signorini::problems::DirichletEnd;
use signorini::singular::ContactZone;

const SCENE: DirichletEnd = DirichletEnd {
    outline: Outline::HalfDisc,
    angles: 12,
    step: 0.25,
    smallest: 1e-40,
    poisson: Some(0.25),
    direction: 90.0,
};

#[test]
fn every_elastic_body_touches_at_the_end() {
    let options = example::Options { angles: 8, ..example::Options::default() };
    let mut cases = example::compute(&options).unwrap();
    let outcome = |cases: &[(&str, EndCase)], key: &str| {
        let found = example::findings(&options, cases);
        found.iter().find(|finding| finding.key() == key).unwrap().outcome()
    };
    for key in ["end", "transitions", "kkt", "starts", "sets", "solvers", "scalar", "forces"] {
        assert_eq!(outcome(&cases, key), Outcome::Holds, "{key}");
    }
    // Planted faults: an end that is open, a decade that is off balance, a third transition, other starts.
    let part = cases[0].1.runs[1].intervals[0];
    cases[0].1.runs[1].intervals[0].in_contact = false;
    assert_eq!(outcome(&cases, "end"), Outcome::Refuted);
    cases[0].1.runs[1].intervals[0] = part;
    cases[0].1.runs[1].decades[30].balance = 1e-3;
    assert_eq!(outcome(&cases, "kkt"), Outcome::Refuted);
    cases[0].1.runs[1].decades[30].balance = 0.0;
    cases[0].1.runs[1].intervals.extend([part; 3]);
    assert_eq!(outcome(&cases, "transitions"), Outcome::Refuted);
    cases[0].1.scaled[1].solution.contact_set = cases[1].1.runs[1].solution.contact_set.clone();
    assert_eq!(outcome(&cases, "sets"), Outcome::Refuted);
    cases[0].1.again[0].solution.contact_set = cases[1].1.again[0].solution.contact_set.clone();
    assert_eq!(outcome(&cases, "starts"), Outcome::Refuted);
}

/// The zone of the closed form: the pressure follows it over four decades, the gap beyond too.
#[test]
fn the_zone_of_a_pulled_body_is_the_closed_form() {
    let run = EndRun::of(&SCENE, Cone::Nodal, EndMethod::Open).unwrap();
    // The border is known to half a ring, 12 % of ℓ; the pressure at ℓ/4 changes by a third of that.
    assert!(run.shape.unwrap() < 0.05, "{:?}", run.shape);
    let radius = run.intervals[0].to;
    let zone = ContactZone::new(0.25, radius).unwrap();
    let radii = SCENE.problem().unwrap().edge().arc().to_vec();
    let ratio: Vec<f64> = (0..radii.len())
        .filter(|&i| 1e2 * radius < radii[i] && radii[i] < 1e4 * radius)
        .map(|i| -run.solution.normal_displacement[i] / zone.opening(radii[i]))
        .collect();
    let (low, high) = ratio.iter().fold((f64::INFINITY, 0.0f64), |(l, h), &r| (l.min(r), h.max(r)));
    assert!(ratio.len() > 10 && low > 0.0 && high / low < 1.2, "{low} {high}");
}

/// A hundred decades cost nothing but rings, and say the same.
#[test]
fn a_hundred_decades_say_the_same() {
    let deep = DirichletEnd { smallest: 1e-100, ..SCENE };
    let [short, long] = [SCENE, deep].map(|scene| EndRun::of(&scene, Cone::Nodal, EndMethod::Open).unwrap());
    assert_eq!(long.decades.len(), 100);
    assert!(long.worst_decade() < 1e-10, "{}", long.worst_decade());
    assert_eq!(short.borders().len(), 1);
    assert!((short.borders()[0] - long.borders()[0]).abs() < 1e-9);
}

/// Near Poisson's ratio 1/2 ε is small, and coarse rings, which have an ε of their own, move the zone by many
/// decades: they keep it.
#[test]
fn coarse_rings_move_the_zone_and_keep_it() {
    let borders = |angles: usize| {
        let step = std::f64::consts::PI / angles as f64;
        let scene = DirichletEnd { angles, step, poisson: Some(0.45), smallest: 1e-60, ..SCENE };
        let run = EndRun::of(&scene, Cone::Nodal, EndMethod::Open).unwrap();
        assert!(run.touches() && run.worst_decade() < 1e-10, "{:?}", run.intervals);
        run.borders()
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
        assert!(EndRun::of(&scene, Cone::Nodal, EndMethod::Open).is_err(), "{scene:?}");
    }
}
