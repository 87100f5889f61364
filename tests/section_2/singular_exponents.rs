//! Where τ comes from: singular exponents by two computations, none lost.

#[allow(dead_code)]
#[path = "../../examples/section_2_singular_exponents.rs"]
mod example;

use crate::exponents_on_arc::exponents_on_arc;
use signorini::problems::{Parameters, TestProblem};
use signorini::singular::{
    Exponent, LARGEST, Medium, SideCondition, SideConditions, SignCondition, Spectrum, Wedge,
};
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::sync::LazyLock;

/// Twelve digits.
const DIGITS: f64 = 1e-12;
/// What thin wedges leave of binary64 on the arc, times ω⁻⁴: in a film between clamped sides pressure drives
/// a flow ω⁴ times as large.
const THIN: f64 = 1e-15;
/// Below this opening that is all of it. Only λ = 1 is left there, and for nearly incompressible films the
/// zeros near it.
const THINNEST: f64 = 0.03;
/// Zeros nearer than this are compared by their mean: the nearer they are, the fewer digits their own
/// eigenvalues keep.
const NEAR: f64 = 0.05;
/// Near 0 and 3 one computation may see what the other counts as outside.
const MARGIN: f64 = 1e-3;

/// Openings: thin, straight, with the sign of the sine changed, cracks, and tan ω = ω, where λ = 1 is double
/// for N-N.
const OPENINGS: [f64; 20] = [
    1e-5,
    1e-3,
    0.03,
    0.3,
    1.0,
    FRAC_PI_2,
    2.0,
    2.2,
    0.75 * PI,
    PI - 1e-6,
    PI,
    PI + 1e-6,
    3.7,
    4.493_409_457_909_064,
    1.5 * PI,
    5.3,
    5.9,
    TAU - 1e-6,
    TAU - 1e-12,
    TAU,
];
const RATIOS: [f64; 7] = [-0.999, -0.4, 0.0, 0.25, 0.3, 0.4999, 0.499_999_999];

fn elastic(angle: f64, poisson: f64, sides: SideConditions) -> Wedge {
    Wedge::new(angle, sides, Medium::PlaneStrain(poisson)).unwrap()
}

/// The nodes of the grid, and openings to the last bit on both sides of where two real exponents become
/// complex.
fn grid() -> Vec<(Wedge, Spectrum)> {
    let mut wedges = Vec::new();
    for sides in SideConditions::ALL {
        for &angle in &OPENINGS {
            wedges.extend(RATIOS.map(|poisson| elastic(angle, poisson, sides)));
            wedges.push(Wedge::new(angle, sides, Medium::Scalar).unwrap());
        }
        for poisson in [0.3, 0.4999] {
            let pairs = |angle: f64| {
                let exponents = elastic(angle, poisson, sides).exponents().unwrap().exponents;
                exponents.iter().filter(|e| e.is_complex() && e.re.value < 2.5).count()
            };
            let steps: Vec<f64> = (0..30).map(|k| 0.35 + 0.2 * f64::from(k)).collect();
            for pair in steps.windows(2).filter(|pair| pairs(pair[0]) != pairs(pair[1])).take(4) {
                let (mut low, mut high, start) = (pair[0], pair[1], pairs(pair[0]));
                while high > low.next_up() {
                    let middle = 0.5 * (low + high);
                    if pairs(middle) == start { low = middle } else { high = middle }
                }
                wedges.extend([low, high].map(|angle| elastic(angle, poisson, sides)));
            }
        }
    }
    let with_exponents = |wedge: Wedge| {
        let spectrum = wedge.exponents().unwrap();
        (wedge, spectrum)
    };
    wedges.into_iter().map(with_exponents).collect()
}

/// Both computations look at the same ones.
static GRID: LazyLock<Vec<(Wedge, Spectrum)>> = LazyLock::new(grid);

#[test]
fn none_is_lost() {
    assert!(GRID.len() >= 500, "{}", GRID.len());
    for (wedge, spectrum) in &*GRID {
        let [first, last] = [spectrum.exponents.first(), spectrum.exponents.last()]
            .map(|exponent| exponent.map_or(1.0, |exponent| exponent.re.value));
        let right = LARGEST - 0.02 * (LARGEST - last);
        let count = wedge.count(0.5 * first, right).unwrap();
        assert_eq!(count, spectrum.zeros(), "{wedge:?}: {:?}", spectrum.places());
        for exponent in &spectrum.exponents {
            let error = exponent.re.error;
            assert!(
                error <= DIGITS * exponent.re.value.hypot(exponent.im.value),
                "{wedge:?}: {error:e}"
            );
            assert!(
                !exponent.modes.is_empty() && exponent.modes.len() <= exponent.multiplicity,
                "{wedge:?}"
            );
        }
    }
}

#[test]
fn the_arc_agrees() {
    let (mut compared, mut together, mut largest) = (0, 0, 0.0f64);
    for (wedge, spectrum) in GRID.iter().filter(|(wedge, _)| wedge.angle() >= THINNEST) {
        let found = spectrum.places();
        let height = 0.5 + found.iter().map(|z| z.1).fold(0.0, f64::max);
        let degree = 24 + (4.0 * wedge.angle()) as usize;
        let arc = exponents_on_arc(wedge, degree, height);
        let near = |a: (f64, f64), b: (f64, f64)| (a.0 - b.0).hypot(a.1 - b.1) < NEAR;
        let inside = |z: (f64, f64)| z.0 > MARGIN && z.0 < LARGEST - MARGIN;
        let eigenvalues: Vec<(f64, f64)> = arc.into_iter().filter(|&z| inside(z)).collect();
        let listed: Vec<(f64, f64)> = found.iter().copied().filter(|&z| inside(z)).collect();
        assert_eq!(eigenvalues.len(), listed.len(), "{wedge:?}: {eigenvalues:?} {listed:?}");
        for &z in &listed {
            let mean = |of: &[(f64, f64)]| {
                let all: Vec<_> = of.iter().filter(|&&other| near(z, other)).collect();
                let count = all.len() as f64;
                let sum = all.iter().fold((0.0, 0.0), |s, z| (s.0 + z.0, s.1 + z.1));
                (all.len(), (sum.0 / count, sum.1 / count))
            };
            let ((ours, a), (theirs, b)) = (mean(&listed), mean(&eigenvalues));
            assert_eq!(ours, theirs, "{wedge:?} at {z:?}");
            let tolerance = DIGITS + THIN / wedge.angle().powi(4);
            let off = (a.0 - b.0).hypot(a.1 - b.1) / a.0.hypot(a.1);
            assert!(off < tolerance, "{wedge:?} at {z:?}: {off:e}");
            largest = largest.max(if wedge.angle() >= 0.1 { off } else { 0.0 });
            compared += 1;
            together += usize::from(ours > 1);
        }
    }
    assert!(compared > 3000 && together > 100, "{compared} {together}");
    println!("{compared} exponents, {together} by their mean, off by {largest:e} at most");
}

#[test]
fn known_values() {
    let list = |wedge: Wedge| wedge.exponents().unwrap().exponents;
    let close = |exponent: &Exponent, re: f64, im: f64| {
        let off = (exponent.re.value - re).hypot(exponent.im.value - im);
        assert!(off <= DIGITS * re.hypot(im), "{exponent:?}: {re} {im}");
    };
    // A crack: 1/2, 1, 3/2, ... each twice, opening and sliding.
    let crack = list(elastic(TAU, 0.3, SideConditions(SideCondition::Free, SideCondition::Free)));
    assert_eq!(crack.len(), 5);
    for (k, exponent) in crack.iter().enumerate() {
        close(exponent, 0.5 * (k + 1) as f64, 0.0);
        assert!(exponent.multiplicity == 2 && exponent.modes.len() == 2, "{exponent:?}");
    }
    // Clamped/free on one line: 1/2 + i ln κ/(2π), and again after one.
    for poisson in [-0.5, 0.0, 0.25, 0.4999] {
        let flat =
            list(elastic(PI, poisson, SideConditions(SideCondition::Clamped, SideCondition::Free)));
        let oscillation = (3.0f64 - 4.0 * poisson).ln() / TAU;
        assert_eq!(flat.len(), 3);
        (0..3).for_each(|k| close(&flat[k], k as f64 + 0.5, oscillation));
    }
    // The reentrant right angle, free: printed with seven digits in many places.
    let corner =
        list(elastic(1.5 * PI, 0.1, SideConditions(SideCondition::Free, SideCondition::Free)));
    for (exponent, printed) in [(&corner[0], 0.544_483_7), (&corner[1], 0.908_529_2)] {
        assert!(
            (exponent.re.value - printed).abs() < 1e-7 && !exponent.is_complex(),
            "{exponent:?}"
        );
    }
    // Of 40 digits by Newton's method in another language: near double, thin and hard to compress, complex.
    let references = [
        (5.9, 0.4999, "D-N", 9, 2.631_784_916_192_898, 0.0),
        (5.9, 0.4999, "D-N", 10, 2.671_408_220_672_460_6, 0.0),
        (0.001, 0.499_999_9, "D-D", 0, 1.843_908_665_869_665_3, 0.0),
        (5.9, 0.3, "D-N", 0, 0.266_800_789_082_832_2, 0.048_335_301_603_958_47),
        (2.0, 0.4999, "D-D", 1, 2.184_217_307_917_477, 0.688_812_880_370_628_5),
    ];
    for (angle, poisson, sides, k, re, im) in references {
        close(&list(elastic(angle, poisson, sides.parse().unwrap()))[k], re, im);
    }
    // tan ω = ω: the rotation with r ln r.
    let double =
        list(elastic(OPENINGS[13], 0.3, SideConditions(SideCondition::Free, SideCondition::Free)));
    let one = double.iter().find(|e| (e.re.value - 1.0).abs() < DIGITS).unwrap();
    assert!(one.multiplicity == 2 && one.has_logarithm() && !one.is_polynomial(), "{one:?}");
}

#[test]
fn closed_forms() {
    for &angle in &OPENINGS {
        for (sides, shift) in [("D-D", 0.0), ("N-N", 0.0), ("C-D", 0.0), ("D-N", 0.5), ("O-C", 0.5)]
        {
            let wedge = Wedge::new(angle, sides.parse().unwrap(), Medium::Scalar).unwrap();
            let expected = (1..).map(|k| (f64::from(k) - shift) * PI / angle);
            let expected: Vec<f64> = expected.take_while(|&x| x < LARGEST - DIGITS).collect();
            let found = wedge.exponents().unwrap().exponents;
            assert_eq!(found.len(), expected.len(), "{wedge:?}");
            for (exponent, x) in found.iter().zip(expected) {
                assert!(
                    (exponent.re.value / x - 1.0).abs() < DIGITS,
                    "{wedge:?}: {exponent:?} {x}"
                );
            }
        }
        // Contact on both sides: |1 + kπ/ω|, whatever the material.
        let wedge =
            elastic(angle, 0.3, SideConditions(SideCondition::Closed, SideCondition::Closed));
        let expected = (-9..=9).map(|k| 1.0 + f64::from(k) * PI / angle);
        let mut expected: Vec<f64> = expected
            .flat_map(|x| [x, x - 2.0])
            .filter(|&x| x > DIGITS && x < LARGEST - DIGITS)
            .collect();
        expected.sort_by(f64::total_cmp);
        // x = 1 + kπ/ω and −1 + kπ/ω, the second written as the first less two.
        let found: Vec<f64> = wedge.exponents().unwrap().places().iter().map(|z| z.0).collect();
        assert_eq!(found.len(), expected.len(), "{angle}: {found:?} {expected:?}");
        for (a, b) in found.iter().zip(expected) {
            assert!((a - b).abs() < DIGITS, "{angle}: {a} {b}");
        }
    }
}

#[test]
fn signs_of_contact_leave_three_halves() {
    let of = |sides: &str, medium| {
        let wedge = Wedge::new(PI, sides.parse().unwrap(), medium).unwrap();
        let exponents = wedge.exponents().unwrap().exponents;
        let said: Vec<(f64, SignCondition)> =
            exponents.iter().map(|e| (e.re.value, wedge.sign_condition(e))).collect();
        (said, wedge.regularity().unwrap().tau)
    };
    for poisson in [-0.5, 0.0, 0.3, 0.499] {
        for sides in ["C-O", "O-C"] {
            let (said, tau) = of(sides, Medium::PlaneStrain(poisson));
            let expected = [
                (0.5, SignCondition::Excluded),
                (1.0, SignCondition::Neutral),
                (1.5, SignCondition::Signed),
                (2.0, SignCondition::Neutral),
                (2.5, SignCondition::Excluded),
            ];
            assert_eq!(said.len(), expected.len());
            for (a, b) in said.iter().zip(expected) {
                assert!((a.0 - b.0).abs() < DIGITS && a.1 == b.1, "{sides} {poisson}: {a:?} {b:?}");
            }
            assert!((tau - 2.5).abs() < DIGITS, "{tau}");
        }
        // Clamped/closed presses with r^{1/2}; clamped/open would penetrate again and again.
        let (said, tau) = of("D-C", Medium::PlaneStrain(poisson));
        assert!(said[0].1 == SignCondition::Signed && (tau - 1.5).abs() < DIGITS, "{said:?} {tau}");
        let (said, _) = of("D-O", Medium::PlaneStrain(poisson));
        assert!(said.iter().all(|s| s.1 == SignCondition::Excluded), "{said:?}");
    }
    // Scalar: contact is u = 0 there, and r^{1/2} pulls or penetrates as well.
    let (said, tau) = of("C-O", Medium::Scalar);
    assert_eq!(
        said.iter().map(|s| s.1).collect::<Vec<_>>()[..2],
        [SignCondition::Excluded, SignCondition::Signed]
    );
    assert!((tau - 2.5).abs() < DIGITS, "{tau}");
    let (said, tau) = of("D-O", Medium::Scalar);
    assert!(said[0].1 == SignCondition::Signed && (tau - 1.5).abs() < DIGITS, "{said:?} {tau}");
}

/// Contact decides: the same polygon, open or closed at its clamped corner, has two exponents, and squares do
/// not see which one it is where the gap is small.
/// Sides at the corner responsible, distance of what is read from its exponent over the uncertainty, the latter, border.
fn reading(problem: TestProblem, setting: &Parameters) -> (String, f64, f64, Option<f64>) {
    let found = problem.regularity(setting).unwrap();
    let corner = found.responsible().unwrap();
    let [(coarse, ..), (fine, drift, border)] =
        [4, 8].map(|elements| example::read(problem, setting, corner.place, elements).unwrap());
    let (value, error) = (fine + (fine - coarse) / 3.0, 2.0 * (fine - coarse).abs() + drift);
    (corner.wedge.sides().to_string(), (value - (found.tau - 1.0)).abs() / error, error, border)
}

#[test]
fn exponents_are_read_at_the_corners_of_bodies() {
    let setting = Parameters::default();
    for (problem, expected) in [
        (TestProblem::Block, "N-D"),
        (TestProblem::Leaning, "O-D"),
        (TestProblem::Raised, "O-D"),
        (TestProblem::Taper, "C-N"),
        (TestProblem::Corner, "O-D"),
        (TestProblem::Incompressible, "N-D"),
    ] {
        let (sides, off, error, _) = reading(problem, &setting);
        assert!(
            sides == expected && off <= 1.0 && error < 0.05,
            "{problem}: {sides} {off} {error}"
        );
    }
    // Three angles: open to a ten thousandth of the edge, and closed.
    let border = |angle| {
        let (sides, off, _, border) =
            reading(TestProblem::Leaning, &Parameters { angle, ..setting });
        assert!(off <= 1.0, "{angle}: {off}");
        (sides, border.unwrap())
    };
    let (sides, gap) = border(120.0);
    assert!(sides == "O-D" && 0.9e-4 < gap && gap < 1.15e-4, "{gap}");
    for angle in [135.0, 150.0] {
        let (sides, zone) = border(angle);
        assert!(sides == "C-D" && zone > 0.1, "{angle}: {sides} {zone:e}");
    }
    assert!(reading(TestProblem::Corner, &Parameters { angle: 150.0, ..setting }).1 <= 1.0);
    // A blunt corner away from the origin, whose coordinates are rounded.
    let (_, off, error, _) = reading(TestProblem::Raised, &Parameters { angle: 50.0, ..setting });
    assert!(off <= 1.0 && error < 0.05, "{off} {error}");
}

#[test]
fn bad_wedges_are_refused() {
    let free = SideConditions(SideCondition::Free, SideCondition::Free);
    for angle in [0.0, -1.0, 1e-6, 6.3, f64::NAN, f64::INFINITY] {
        let message = Wedge::new(angle, free, Medium::Scalar).unwrap_err().to_string();
        assert!(message.contains("opening angle") && message.contains("2 pi"), "{message}");
    }
    for poisson in [-1.0, 0.5, 0.7, f64::NAN] {
        let message = Wedge::new(1.0, free, Medium::PlaneStrain(poisson)).unwrap_err().to_string();
        assert!(message.contains("Poisson"), "{message}");
    }
    for text in ["", "D", "D-X", "D-N-C", "DN"] {
        assert!(text.parse::<SideConditions>().is_err(), "{text}");
    }
    let wedge = elastic(PI, 0.3, free);
    assert!(
        wedge.count(0.5, 1.0).is_err()
            && wedge.count(2.0, 1.0).is_err()
            && wedge.count(0.1, 9.0).is_err()
    );
}
