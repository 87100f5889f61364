//! What Theorems 3.1 and 4.1 promise, for one cone: reduced studies with bounds on orders from both sides.

use example_frame::rates::RateRow;
use example_frame::{Finding, Headline, Outcome, Table, Verdict};
use experiments::convergence::{Levels, MeshRates, NoMemory, Quantity, RateStrip, RateStudy, SceneFamily};
use signorini::cone::Cone;
use signorini::edge::{EdgeTrace, Interval, consistency_terms, midpoint_term, nodal_term};
use signorini::problems::{Parameters, StripData, TestProblem};
use signorini::rates::Bound;
use signorini::strip::{LateralCondition, StripKind};

/// Options of either example for one transition on few levels.
macro_rules! one_transition {
    ($options:ty) => {{
        let mut options = <$options>::default();
        (options.scene, options.tau) = (Some("transition".parse().unwrap()), vec![1.75]);
        (options.levels, options.positions) = ("3-11".parse().unwrap(), 5);
        options
    }};
}
pub(crate) use one_transition;

/// The window of h is finite: orders of known scenes come out this close to τ − 1.
const ORDER: f64 = 0.02;
/// On meshes of up to 192 squares along a side, with three terms of a series for the error.
const CORNER: f64 = 0.05;
/// The term has one value per position of a transition; few of them are averaged.
const TERM: f64 = 0.03;

fn strip(
    kind: StripKind,
    source: &StripData,
    levels: (u32, u32),
    positions: usize,
    cone: Cone,
) -> Vec<RateStudy> {
    let levels = Levels::new(levels.0, levels.1).unwrap();
    let finest = levels.cells().max().unwrap();
    let mut strip = RateStrip::new(kind, levels, 16 * finest).unwrap();
    let mut store = NoMemory;
    [1.55, 1.65, 1.75, 1.85, 1.95]
        .into_iter()
        .map(|tau| {
            let family = SceneFamily::named(source, tau, kind, levels.coarsest_cells(), positions).unwrap();
            strip.study(&family, cone, &mut store, &mut || ()).unwrap()
        })
        .collect()
}

fn check(studies: &[RateStudy]) {
    for study in studies {
        let (fit, optimal) = (study.fit(Quantity::Error).unwrap(), study.tau - 1.0);
        let name = format!("{} {} tau {}: {fit}", study.subject, study.cone, study.tau);
        assert_eq!(study.left_out(), 0, "{name}");
        assert!((fit.order - optimal).abs() < ORDER, "{name}");
        for quantity in [Quantity::Error, Quantity::Consistency] {
            assert!(study.is_bounded(quantity, Bound::Paper).unwrap(), "{name} {quantity:?}");
        }
        let term = study.fit(Quantity::Consistency).unwrap();
        assert!((term.order - optimal).abs() < TERM, "{name} term {term}");
    }
}

pub fn single_transitions(cone: Cone) {
    for kind in [StripKind::Scalar, StripKind::Elastic] {
        check(&strip(kind, &StripData::transition(), (3, 12), 7, cone));
    }
}

pub fn many_transitions(cone: Cone) {
    check(&strip(StripKind::Scalar, &StripData::Transitions { gaps: 11 }, (6, 14), 1, cone));
}

pub fn corners(cone: Cone) {
    for angle in [100.0, 120.0, 135.0, 150.0] {
        let setting = Parameters { angle, ..Parameters::default() };
        let rates =
            MeshRates { scene: TestProblem::Corner, setting, constant_load: true, coarsest: 3, levels: 7 };
        let study = rates.study(&[cone]).unwrap().remove(0);
        let fit = study.fit(Quantity::Error).unwrap();
        assert!((fit.order - 90.0 / angle).abs() < CORNER, "{}: {fit}", study.subject);
        assert!(study.is_bounded(Quantity::Error, Bound::Paper).unwrap(), "{}: {fit}", study.subject);
    }
}

/// A corner of 120 degrees (τ = 7/4) with a contact zone at its other end, one less digit in the order: the
/// transition adds its own series.
pub fn corner_with_contact(cone: Cone) {
    let rates = MeshRates {
        scene: TestProblem::Corner,
        setting: Parameters::default(),
        constant_load: false,
        coarsest: 3,
        levels: 7,
    };
    let study = rates.study(&[cone]).unwrap().remove(0);
    let fit = study.fit(Quantity::Error).unwrap();
    assert!(study.levels.iter().all(|level| level.contact_runs == 1));
    assert!((fit.order - 0.75).abs() < CORNER, "{fit}");
}

/// The term summed over segments of the trace and the one by halving grids: sums of a thousand positive
/// numbers.
const SUM: f64 = 1e-12;

pub fn terms_by_two_roads(cone: Cone) {
    let cells = 1 << 10;
    let scene = StripData::Transitions { gaps: 3 }.data(1.75, cells, LateralCondition::Natural).unwrap();
    let nodes = (0..=cells).map(|i| i as f64 / cells as f64).collect();
    let trace = EdgeTrace::new(nodes, scene.values().to_vec(), scene.forces().to_vec(), 0.0).unwrap();
    for (segments, term) in consistency_terms(&scene, cone) {
        let h = 1.0 / segments as f64;
        let sum: f64 = (0..segments)
            .map(|k| Interval { start: k as f64 * h, end: (k + 1) as f64 * h })
            .map(|segment| match cone {
                Cone::Nodal => nodal_term(&trace, segment),
                Cone::Midpoint => midpoint_term(&trace, segment),
            })
            .sum();
        assert!((sum - term).abs() <= SUM * sum, "{cone}, {segments} segments: {sum} {term}");
    }
}

/// The studies of an example with every study spoilt; orders are fitted again.
fn spoilt(rows: &[RateRow], spoil: impl Fn(&mut RateStudy)) -> Vec<RateRow> {
    let studies = rows.iter().map(|row| row.study.clone());
    let spoilt = studies.map(|mut study| {
        spoil(&mut study);
        RateRow::new(study)
    });
    spoilt.collect()
}

/// What the findings say of spoilt studies: the finding with this key turns, and verdict and exit code with
/// it.
fn turns(findings: Vec<Finding>, key: &str, to: Outcome) {
    let headline = Headline::new("", "", Table::new(Vec::new()), findings);
    let finding = headline.finding(key).expect("a finding with this key");
    assert_eq!(finding.outcome(), to, "{key}: {}", finding.comparison());
    assert_eq!(headline.exit_code(), 1, "{headline}");
    let (Verdict::NotConfirmed(why) | Verdict::Undecided(why)) = headline.verdict() else {
        panic!("{key}: {}", headline.verdict());
    };
    assert!(why.contains(&finding.words()), "{key}: {why}");
}

/// Faults planted in the studies of an example: the right finding sees each of them.
pub fn planted_faults(rows: &[RateRow], mut findings: impl FnMut(Vec<RateRow>) -> Vec<Finding>) {
    let whole = Headline::new("", "", Table::new(Vec::new()), findings(rows.to_vec()));
    assert_eq!(whole.exit_code(), 0, "{whole}");
    let theorem = format!("{}.theorem", rows[0].key());
    assert!(["levels", "optimal", &theorem].iter().all(|key| whole.finding(key).is_some()), "{whole}");

    // Errors of the order that the theorem promises, τ² − 5τ/2 + 2, and no longer τ − 1.
    let slow = spoilt(rows, |study| {
        let loss = (study.tau - 1.5) * (2.0 - study.tau);
        study.levels.iter_mut().for_each(|level| level.error *= level.mesh_size().powf(-loss));
    });
    turns(findings(slow), "optimal", Outcome::Refuted);

    // Errors that stay below the theorem's order by as much again.
    let slower = spoilt(rows, |study| {
        let loss = 2.0 * (study.tau - 1.5) * (2.0 - study.tau);
        study.levels.iter_mut().for_each(|level| level.error *= level.mesh_size().powf(-loss));
    });
    turns(findings(slower), &theorem, Outcome::Refuted);

    let short = spoilt(rows, |study| {
        let _ = study.levels.remove(study.levels.len() / 2);
    });
    turns(findings(short), "levels", Outcome::Refuted);

    let nan = spoilt(rows, |study| {
        let middle = study.levels.len() / 2;
        study.levels[middle].error = f64::NAN;
    });
    turns(findings(nan.clone()), "levels", Outcome::Refuted);
    for key in ["optimal", &theorem] {
        let found = findings(nan.clone()).into_iter().filter(|finding| finding.key() == key).collect();
        turns(found, key, Outcome::Undecided);
    }
}
