//! Dual norms of rough loads: enclosures by partial sums of the spectral series, and other partitions of the same
//! function.

use crate::common::SplitMix;
use crate::hard::cases;
use fractional_sobolev::{
    DualOf, Estimate, Function, Load, Mesh, Order, Tolerance, gauss_legendre,
};
use std::f64::consts::PI;

fn order(nu: f64) -> Order {
    Order::new(nu).unwrap()
}

fn tolerance(relative: f64) -> Tolerance {
    Tolerance::new(relative).unwrap()
}

/// Elements with values at both ends and two coefficients of bubbles, any of which may be zero.
struct Pieces {
    lengths: Vec<f64>,
    values: Vec<[f64; 4]>,
}

impl Pieces {
    fn random(random: &mut SplitMix) -> Self {
        let (count, kind) = (1 + random.below(6), random.below(3));
        let total = 10f64.powf(random.between(-1.5, 1.5));
        let mut lengths: Vec<f64> = (0..count).map(|_| random.between(0.1, 1.0)).collect();
        let sum: f64 = lengths.iter().sum();
        lengths.iter_mut().for_each(|h| *h *= total / sum);
        let mut value = || {
            if kind == 0 { (2 * random.below(2)) as f64 - 1.0 } else { random.between(-1.0, 1.0) }
        };
        let mut piece = || match kind {
            0 => {
                let v = value();
                [v, v, 0.0, 0.0]
            }
            1 => [value(), value(), 0.0, 0.0],
            _ => [value(), value(), value(), value()],
        };
        let values = (0..count).map(|_| piece()).collect();
        Self { lengths, values }
    }

    fn function(&self) -> Function<'static> {
        let partition = Mesh::from_lengths(&self.lengths).unwrap();
        let straight = self.values.iter().all(|v| v[2..] == [0.0, 0.0]);
        let degree = if straight { 1 } else { 3 };
        let at = |v: &[f64; 4], t: f64| {
            v[0] * (1.0 - t) + v[1] * t + t * (1.0 - t) * (v[2] + v[3] * (2.0 * t - 1.0))
        };
        let points = |v| (0..=degree).map(move |k| at(v, k as f64 / degree as f64));
        let values: Vec<f64> = self.values.iter().flat_map(points).collect();
        Function::piecewise(&partition, degree, &values).unwrap()
    }

    fn total(&self) -> f64 {
        self.lengths.iter().sum()
    }

    /// ∫ u² and ∫ u cos(kπx/L) or ∫ u sin(kπx/L).
    fn integrals(&self, wave: Option<(usize, bool)>) -> f64 {
        let rule = gauss_legendre(16).unwrap();
        let (mut start, mut sum) = (0.0, 0.0);
        for (&h, &[l, r, c, d]) in self.lengths.iter().zip(&self.values) {
            let value = |t: f64| l * (1.0 - t) + r * t + t * (1.0 - t) * (c + d * (2.0 * t - 1.0));
            let omega = wave.map_or(0.0, |(k, _)| k as f64 * PI / self.total());
            let sine = wave.is_some_and(|(_, sine)| sine);
            if omega * h < 4.0 {
                for (t, w) in rule.iter() {
                    let (s, co) = (omega * (start + h * t)).sin_cos();
                    let factor = if wave.is_none() {
                        value(t)
                    } else if sine {
                        s
                    } else {
                        co
                    };
                    sum += h * w * value(t) * factor;
                }
            } else {
                // by parts, three times
                let part = |t: f64| {
                    let x = 2.0 * t - 1.0;
                    let slope = (r - l - x * (c + d * x) + 2.0 * d * t * (1.0 - t)) / (h * omega);
                    let second = (-2.0 * c - 6.0 * d * x) / (h * omega).powi(2);
                    let third = -12.0 * d / (h * omega).powi(3);
                    let (s, co) = (omega * (start + h * t)).sin_cos();
                    let (even, odd) = (value(t) - second, slope - third);
                    (if sine { odd * s - even * co } else { even * s + odd * co }) / omega
                };
                sum += part(1.0) - part(0.0);
            }
            start += h;
        }
        sum
    }

    /// The squared dual norm lies between these: the first coefficients, and the rest by Parseval.
    fn enclosure(&self, zero: bool, nu: f64, coefficients: usize) -> [f64; 2] {
        let total = self.total();
        let (mut sum, mut rest, mut weight) = (0.0, self.integrals(None), 1.0);
        for k in usize::from(zero)..coefficients {
            let square =
                self.integrals(Some((k, zero))).powi(2) * if k == 0 { 1.0 } else { 2.0 } / total;
            weight = (k as f64 * PI / total).hypot(1.0).powf(-2.0 * nu);
            sum += weight * square;
            rest -= square;
        }
        let rounding = 1e-13 * self.integrals(None);
        [sum - rounding, sum + weight * rest.max(0.0) + rounding]
    }
}

fn encloses([low, high]: [f64; 2], found: Estimate) -> bool {
    (found.value + found.error).powi(2) >= low && (found.value - found.error).powi(2) <= high
}

#[test]
fn spectral_sums_are_enclosed_and_a_wrong_value_is_not() {
    let mut random = SplitMix::new(5);
    let (mut sharp, mut heard) = (0, 0);
    for case in 0..cases(300) {
        let pieces = Pieces::random(&mut random);
        let nu = [0.02, 0.1, 0.3, 0.5, 0.7, 0.9, 0.98][random.below(7)];
        for (of, zero) in [(DualOf::Interpolation, false), (DualOf::InterpolationZero, true)] {
            let bounds = pieces.enclosure(zero, nu, 6000);
            for asked in [1e-3, 1e-8, 1e-12] {
                let found = pieces.function().dual_norm(of, order(nu), tolerance(asked)).unwrap();
                assert!(encloses(bounds, found), "{case} {of:?} {nu}: {found} in {bounds:?}");
                if asked == 1e-12 {
                    sharp += 1;
                    let spoiled = Estimate { value: found.value * (1.0 - 1e-4), ..found };
                    heard += usize::from(!encloses(bounds, spoiled));
                }
            }
        }
    }
    assert!(6 * heard > 5 * sharp, "{heard} of {sharp} spoiled values are heard");
}

/// Over piecewise linears graded to every break of f: a lower bound always, and how much it rises with meshes
/// twice as fine. Short elements leave less than the eleven digits asked: then the best value, with its error.
fn from_graded_meshes(pieces: &Pieces, nu: f64) -> (Estimate, f64) {
    let breaks: Vec<f64> = std::iter::once(0.0)
        .chain(pieces.lengths.iter().scan(0.0, |x, h| {
            *x += h;
            Some(*x)
        }))
        .collect();
    let value = |layers: usize, ratio: f64| {
        let mesh = Mesh::graded(&breaks, layers, ratio).unwrap();
        let rule = gauss_legendre(4).unwrap();
        let (mut load, mut element) = (vec![0.0; mesh.len() + 1], 0);
        for (i, h) in mesh.lengths().iter().enumerate() {
            // an element of f carries 2 (layers + 1) elements
            if i > 0 && i % (2 * (layers + 1)) == 0 {
                element += 1;
            }
            let first = element * 2 * (layers + 1);
            let (start, total) =
                (mesh.from_left()[i] - mesh.from_left()[first], pieces.lengths[element]);
            let [l, r, c, d] = pieces.values[element];
            for (t, w) in rule.iter() {
                let s = (start + h * t) / total;
                let f = l * (1.0 - s) + r * s + s * (1.0 - s) * (c + d * (2.0 * s - 1.0));
                load[i] += w * h * f * (1.0 - t);
                load[i + 1] += w * h * f * t;
            }
        }
        let found = Load::new(&mesh, &load).unwrap().dual_norm(order(nu), tolerance(1e-11));
        Estimate::or_best(found).unwrap()
    };
    let (coarse, fine) = (value(16, 0.5), value(32, 0.5f64.sqrt()));
    (fine, 0.5 * (fine.value - coarse.value).abs())
}

#[test]
fn the_norm_of_1_1_agrees_with_graded_meshes() {
    let (mut random, mut sharp) = (SplitMix::new(11), 0);
    for case in 0..cases(100) {
        let mut pieces = Pieces::random(&mut random);
        pieces.lengths.truncate(3);
        pieces.values.truncate(3);
        let nu = [0.15, 0.35, 0.5, 0.65, 0.9][case % 5];
        let (below, missing) = from_graded_meshes(&pieces, nu);
        let found = pieces.function().norm(-order(nu), tolerance(1e-7)).unwrap();
        let above = found.value + found.error - (below.value - below.error);
        assert!(above >= -1e-11 * below.value, "{case} {nu}: {found} is below {below}");
        let over = found.value - found.error - (below.value + below.error);
        assert!(over <= missing, "{case} {nu}: {found}, {below} + {missing:e}");
        sharp += usize::from(below.relative_error() <= 1e-8); // a tenth of what is compared
    }
    assert!(10 * sharp >= 9 * cases(100), "{sharp} references");
}

/// ±1 on `count` elements of random lengths.
fn random_signs(count: usize, random: &mut SplitMix) -> (Vec<f64>, Vec<f64>) {
    let lengths = (0..count).map(|_| random.between(0.1, 1.0)).collect();
    let values = (0..count).map(|_| (2 * random.below(2)) as f64 - 1.0).collect();
    (lengths, values)
}

fn constants(lengths: &[f64], values: &[f64]) -> Function<'static> {
    Function::piecewise(&Mesh::from_lengths(lengths).unwrap(), 0, values).unwrap()
}

/// From a thousand elements on the comparison follows b(x) and the ends have windows. The same function on
/// fewer elements, compared with one β, is the other method.
#[test]
fn elements_cut_in_pieces_keep_the_norm_of_1_1() {
    let mut random = SplitMix::new(23);
    let (mut heard, mut sharpest) = (0, 1.0f64);
    for case in 0..cases(20) {
        let (lengths, values) = random_signs(350 + random.below(400), &mut random);
        let scale = [1e-3, 0.1][case % 2];
        let lengths: Vec<f64> = lengths.iter().map(|h| scale * h).collect();
        let nu = random.between(0.05, 0.8);
        let find =
            |u: &Function<'_>, t| Estimate::or_best(u.norm(-order(nu), tolerance(t))).unwrap();
        let whole = find(&constants(&lengths, &values), 1e-7);
        let cut =
            |h: &[f64]| h.iter().flat_map(|h| [0.25 * h, 0.45 * h, 0.3 * h]).collect::<Vec<f64>>();
        let thrice: Vec<f64> = values.iter().flat_map(|&v| [v; 3]).collect();
        for t in [1e-4, 1e-6, 1e-8] {
            let pieces = find(&constants(&cut(&lengths), &thrice), t);
            let apart = (pieces.value - whole.value).abs();
            assert!(apart <= pieces.error + whole.error, "{case} {nu} {t:e}: {pieces} and {whole}");
            let reach = (pieces.error + whole.error) / whole.value;
            sharpest = sharpest.min(reach);
            heard += usize::from(reach < 1e-5);
        }
    }
    assert!(
        2 * heard > 3 * cases(20) && sharpest < 1e-7,
        "{heard} of {}, {sharpest:e}",
        3 * cases(20)
    );
}

#[test]
fn functions_with_breaks_have_the_norms_of_piecewise_polynomials() {
    // A step is a piecewise polynomial; at singularities sharper tolerances stay within wider ones.
    let step = |x: f64| if x < 0.3 { 1.0 } else { -2.0 };
    let declared = Function::from_fn(&[0.0, 0.3, 1.0], step).unwrap();
    let cells = Mesh::from_lengths(&[0.3, 0.7]).unwrap();
    let exact = Function::piecewise(&cells, 0, &[1.0, -2.0]).unwrap();
    let log = Function::from_positions(&[0.0, 0.3, 1.0], |at| at.log_distance_to(1)).unwrap();
    let power = Function::from_positions(&[0.0, 1.0], |at| at.distance_to(0).powf(-0.4)).unwrap();
    for of in [DualOf::Slobodeckij, DualOf::Interpolation, DualOf::InterpolationZero] {
        for nu in [0.3, 0.5, 0.8] {
            let [a, b] = [
                declared.dual_norm(of, order(nu), tolerance(1e-6)).unwrap(),
                exact.dual_norm(of, order(nu), tolerance(1e-7)).unwrap(),
            ];
            assert!((a.value - b.value).abs() <= a.error + b.error, "{of:?} {nu}: {a} {b}");
            for u in [&log, &power] {
                let [wide, sharp] =
                    [1e-3, 1e-6].map(|t| u.dual_norm(of, order(nu), tolerance(t)).unwrap());
                let off = (wide.value - sharp.value).abs();
                assert!(off <= wide.error + sharp.error, "{of:?} {nu}: {wide} {sharp}");
                let l2 = u.norm(0.0, tolerance(1e-3)).unwrap();
                assert!(sharp.value < l2.value + l2.error, "{sharp} {l2}");
            }
        }
    }
}
