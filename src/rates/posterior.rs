//! The posterior density of the order of a sequence of errors under several models.
//!
//! With x = h/h₁ on the levels h₁ > h₂ > ... a model is
//!
//! e² = A (x^{2p} + κ Σ_j c_j g_j(x; p)) + σ e² ω,
//!
//! where the g_j are the terms in addition to the leading one (below), c_j and ω are independent standard normal
//! variables (A: normal, its mean the value of the regression line at h₁, its standard deviation twice this
//! value), κ is the size of the additional terms on the coarsest level, σ the scatter of e² about the model.
//! All terms but the leading one vanish at x = 1, and each is written so that it remains linearly independent
//! when its exponent approaches that of the leading one, ψ_q = (x^{2p} − x^{2p+q})/q → x^{2p} ln(1/x) as q →
//! 0: powers close to a logarithm and the logarithm itself form one family.
//!
//! For given p, κ, σ the vector of 1 − A x^{2p}/e² is normal with a covariance of low rank plus σ² times
//! the identity; the likelihood is exact by a singular value decomposition. Summed over models, κ and a
//! geometric sequence of σ, it is a density of p, with a uniform prior over an interval about the
//! regression line. Cost: some thousand decompositions of a matrix of levels × terms, a few milliseconds.

use nalgebra::DMatrix;
use std::fmt;

/// The model of the terms beyond the leading one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ErrorModel {
    /// e² = A h^{2p} (1 + slowly vanishing terms).
    Power,
    /// e² = A h^{2p} + B h² + D h³.
    PowerAndSmooth,
    /// e² = A h^{2p} + B h² + C h² ln h + D h³.
    PowerAndLogarithm,
}

impl fmt::Display for ErrorModel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            ErrorModel::Power => "p",
            ErrorModel::PowerAndSmooth => "p, 1",
            ErrorModel::PowerAndLogarithm => "p, 1 ln",
        })
    }
}

/// The terms in addition to x^{2p}.
#[derive(Debug, Clone, Copy)]
enum Terms {
    /// No additional terms.
    None,
    /// ψ to h² and to h³: the remainder of the sum over the cells at distance r of a singularity, h² ∫_h
    /// r^{2p−3} dr, the smooth part and the term after it.
    Smooth,
    /// In addition h² ln h: a jump in the slope of the data, or corners of another order.
    Logarithm,
    /// ψ_q for q = 0, 1/4, ..., 3: no assumption on the exponents.
    Any,
}

/// A model: its terms, κ, and its prior probability.
type Model = (Terms, f64, f64);

/// Models of errors of linear elements in the energy norm: the smooth part has order one.
const MODELS: [Model; 8] = [
    (Terms::None, 0.0, 0.02),
    (Terms::Smooth, 0.3, 0.14),
    (Terms::Smooth, 0.7, 0.14),
    (Terms::Smooth, 1.5, 0.14),
    (Terms::Logarithm, 0.3, 0.14),
    (Terms::Logarithm, 0.7, 0.14),
    (Terms::Logarithm, 1.5, 0.14),
    (Terms::Any, 0.7, 0.14),
];

/// The exponents q of [`Terms::Any`]: densest where terms are hard to distinguish from the leading one.
const ANY_EXPONENTS: [f64; 8] = [0.0, 0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 3.0];
/// Half of the interval of p about the slope of the regression line; for no sequence of three levels is p farther
/// away.
const REACH: f64 = 0.8;
/// Number of values of p in one pass, and the number of them that the density must cover; otherwise the range is
/// narrowed.
const PLACES: usize = 41;
const FILLED: usize = 14;
/// Largest number of passes; each narrows the range to a third or less.
const PASSES: usize = 30;
/// Fraction of the largest density below which p is omitted.
const NEGLIGIBLE: f64 = 1e-4;
/// The values of the scatter, from the resolution of the decompositions to uninformative errors, with ratio 1.8.
const SCATTER: (f64, f64, usize) = (1e-7, 1.8, 28);
/// A model must be dominated by its leading term: at this distance below the finest level e² must be at least this
/// fraction of the value extrapolated with its order.
const FAR: f64 = 1e-6;
const CONTINUED: f64 = 0.1;
/// The largest order of linear elements in the energy norm.
const ONE: f64 = 1.0;
/// Largest power considered for the leading singularity: a transition inside a straight edge has 3/2.
const LARGEST: f64 = 1.5;
/// Standard deviation of A about the regression line.
const LEADING: f64 = 2.0;

/// The density of the order.
pub(super) struct Posterior {
    /// Values of p with their probabilities.
    places: Vec<(f64, f64)>,
    /// Half the largest distance of neighbouring values, weighted by the probability.
    resolution: f64,
    /// The most likely of the given models.
    pub(super) model: ErrorModel,
}

/// The density of the order in one model, not normalised: values of p, ln of the density, their distance.
struct Density {
    places: Vec<(f64, f64)>,
    step: f64,
}

impl Posterior {
    /// The density from at least three positive errors (h, e), coarsest first.
    ///
    /// For distances to a discrete solution of mesh size `reference` > 0 every term g(x) becomes g(x) − g(reference/h₁).
    pub(super) fn of(points: &[(f64, f64)], reference: f64) -> Self {
        let coarsest = points[0].0;
        let (slope, intercept) = regression_line(points);
        let size = (intercept + slope * coarsest.ln()).exp();
        // (x, e²) on the scale of the series.
        let levels: Vec<(f64, f64)> =
            points.iter().map(|(h, e)| (h / coarsest, (e / size).powi(2))).collect();
        let range = (slope - REACH, (slope + REACH).min(LARGEST));
        let all: Vec<Density> = MODELS
            .iter()
            .map(|model| Density::of(range, |p| likelihood(&levels, reference / coarsest, p, model)))
            .collect();
        let top = all.iter().flat_map(|density| &density.places).fold(f64::NEG_INFINITY, |m, v| m.max(v.1));
        let weighted: Vec<Vec<(f64, f64)>> = all
            .iter()
            .map(|d| d.places.iter().map(|&(p, v)| (p, d.step * (v - top).exp())).collect())
            .collect();
        let mut shares: Vec<f64> =
            weighted.iter().map(|places| places.iter().map(|place| place.1).sum()).collect();
        let total: f64 = shares.iter().sum();
        shares.iter_mut().for_each(|share| *share /= total);
        let places = weighted.into_iter().flatten().map(|(p, w)| (p, w / total)).collect();
        let resolution = all.iter().zip(&shares).map(|(density, share)| 0.5 * density.step * share).sum();
        Self { places, resolution, model: most_likely(&shares) }
    }

    /// The mean of min(p, 1), and the distance from it within which the given probability lies.
    pub(super) fn interval(&self, share: f64) -> (f64, f64) {
        let capped = || self.places.iter().map(|&(p, w)| (p.min(ONE), w));
        let mean: f64 = capped().map(|(p, w)| p * w).sum();
        let mut distances: Vec<(f64, f64)> = capped().map(|(p, w)| ((p - mean).abs(), w)).collect();
        distances.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut total = 0.0;
        let inside = distances.iter().find(|(_, w)| {
            total += w;
            total >= share
        });
        let widest = distances[distances.len() - 1].0;
        (mean, inside.map_or(widest, |place| place.0) + self.resolution)
    }
}

impl Density {
    /// The density on a range of p that is narrowed to its support.
    fn of((mut low, mut high): (f64, f64), logarithm: impl Fn(f64) -> f64) -> Self {
        let mut pass = 1;
        loop {
            let step = (high - low) / (PLACES - 1) as f64;
            let place = |k: usize| low + step * k as f64;
            let places: Vec<(f64, f64)> = (0..PLACES).map(|k| (place(k), logarithm(place(k)))).collect();
            let peak = places.iter().fold(f64::NEG_INFINITY, |m, place| m.max(place.1));
            let counts = |place: &(f64, f64)| place.1 > peak + NEGLIGIBLE.ln();
            let first = places.iter().position(counts).unwrap_or(0).saturating_sub(1);
            let last = (places.iter().rposition(counts).unwrap_or(PLACES - 1) + 1).min(PLACES - 1);
            if pass == PASSES || last - first > FILLED {
                return Self { places, step };
            }
            (low, high) = (place(first), place(last));
            pass += 1;
        }
    }
}

/// The kind of terms whose models together have the largest probability.
fn most_likely(shares: &[f64]) -> ErrorModel {
    let kind = |terms: Terms| match terms {
        Terms::None | Terms::Any => ErrorModel::Power,
        Terms::Smooth => ErrorModel::PowerAndSmooth,
        Terms::Logarithm => ErrorModel::PowerAndLogarithm,
    };
    let of = |model: ErrorModel| -> f64 {
        MODELS
            .iter()
            .zip(shares)
            .filter(|((terms, ..), _)| kind(*terms) == model)
            .map(|(_, share)| share)
            .sum()
    };
    let all = [ErrorModel::PowerAndSmooth, ErrorModel::PowerAndLogarithm, ErrorModel::Power];
    all.into_iter().max_by(|&a, &b| of(a).total_cmp(&of(b))).unwrap_or(ErrorModel::Power)
}

/// Slope s and intercept a of the line ln y = a + s ln x by least squares; all coordinates must be positive, and at
/// least two x different.
fn regression_line(points: &[(f64, f64)]) -> (f64, f64) {
    let count = points.len() as f64;
    let mean = |f: &dyn Fn(&(f64, f64)) -> f64| points.iter().map(f).sum::<f64>() / count;
    let (x, y) = (mean(&|p| p.0.ln()), mean(&|p| p.1.ln()));
    let spread: f64 = points.iter().map(|p| (p.0.ln() - x).powi(2)).sum();
    let slope = points.iter().map(|p| (p.0.ln() - x) * (p.1.ln() - y)).sum::<f64>() / spread;
    (slope, y - slope * x)
}

/// (x^a − x^b)/(b − a), x^a ln(1/x) for a = b; 0 at x = 0.
fn difference(x: f64, a: f64, b: f64) -> f64 {
    if x == 0.0 {
        return 0.0;
    }
    let logarithm = (b - a) * x.ln();
    let quotient = if logarithm.abs() < f64::EPSILON { -x.ln() } else { -logarithm.exp_m1() / (b - a) };
    x.powf(a) * quotient
}

/// The terms in addition to the leading one at x, for a power p; each is to be multiplied by κ.
fn beside(terms: Terms, x: f64, p: f64) -> Vec<f64> {
    let twice = 2.0 * p;
    let smooth = || {
        vec![
            difference(x, twice, 2.0),
            difference(x, twice, 3.0),
            difference(x, twice, twice + 1.0),
            difference(x, twice, twice + 2.0),
        ]
    };
    match terms {
        Terms::None => Vec::new(),
        Terms::Smooth => smooth(),
        Terms::Logarithm => {
            let mut all = smooth();
            all.push(difference(x, 2.0, 2.0));
            all
        }
        Terms::Any => {
            let share = (ANY_EXPONENTS.len() as f64).sqrt().recip();
            ANY_EXPONENTS.map(|q| share * difference(x, twice, twice + q)).to_vec()
        }
    }
}

/// ln of the likelihood of the levels (x, e²) for a power p, with the share of the model and summed over the scatter.
fn likelihood(levels: &[(f64, f64)], reference: f64, p: f64, &(terms, size, share): &Model) -> f64 {
    let (count, twice) = (levels.len(), 2.0 * p);
    // A positive power of a zero reference is 0; other powers do not occur.
    let leading = |x: f64| if x == 0.0 { 0.0 } else { x.powf(twice) };
    let column = |x: f64, square: f64| {
        let (at, from) = (beside(terms, x, p), beside(terms, reference, p));
        let first = (leading(x) - leading(reference)) / square;
        let others = at.into_iter().zip(from).map(move |(g, r)| size * (g - r) / square);
        std::iter::once(LEADING * first).chain(others).collect::<Vec<f64>>()
    };
    let columns: Vec<Vec<f64>> = levels.iter().map(|&(x, square)| column(x, square)).collect();
    let rest: Vec<f64> = columns.iter().map(|c| 1.0 - c[0] / LEADING).collect();
    let width = columns[0].len();
    if columns.iter().flatten().any(|v| !v.is_finite()) {
        return f64::NEG_INFINITY;
    }
    let matrix = DMatrix::from_fn(count, width, |i, j| columns[i][j]);
    let decomposition = matrix.svd(true, true);
    let (Some(directions), Some(rows)) = (decomposition.u, decomposition.v_t) else {
        return f64::NEG_INFINITY;
    };
    // Far below the finest level the model is the leading part plus the sum of the contributions of all directions.
    let (finest, square) = levels[count - 1];
    let far = FAR * finest;
    let ahead: Vec<f64> = std::iter::once(LEADING * leading(far))
        .chain(beside(terms, far, p).into_iter().map(|g| size * g))
        .collect();
    let needed = CONTINUED * square * FAR.powf(2.0 * p.min(ONE));
    // For each direction: its singular value, its component of the residual, its contribution far below.
    let parts: Vec<(f64, f64, f64)> = decomposition
        .singular_values
        .iter()
        .enumerate()
        .map(|(j, &s)| {
            let held = (0..count).map(|i| directions[(i, j)] * rest[i]).sum::<f64>();
            (s, held, s * held * (0..width).map(|k| rows[(j, k)] * ahead[k]).sum::<f64>())
        })
        .collect();
    let mut left = rest;
    for (j, (_, held, _)) in parts.iter().enumerate() {
        left.iter_mut().enumerate().for_each(|(i, r)| *r -= held * directions[(i, j)]);
    }
    let left: f64 = left.iter().map(|r| r * r).sum();
    let (smallest, factor, steps) = SCATTER;
    let unseen = (count - parts.len()) as f64;
    let of = |k: usize| {
        let variance = (smallest * factor.powi(k as i32)).powi(2);
        let continued: f64 = parts.iter().map(|(s, _, adds)| adds / (s * s + variance)).sum();
        if ahead[0] / LEADING + continued < needed {
            return f64::NEG_INFINITY;
        }
        let held: f64 =
            parts.iter().map(|(s, held, _)| held * held / (s * s + variance) + (s * s + variance).ln()).sum();
        -0.5 * (left / variance + unseen * variance.ln() + held)
    };
    let all: Vec<f64> = (0..steps).map(of).collect();
    let top = all.iter().fold(f64::NEG_INFINITY, |m, &v| m.max(v));
    if top == f64::NEG_INFINITY {
        return top;
    }
    top + all.iter().map(|v| (v - top).exp()).sum::<f64>().ln() + share.ln()
}
