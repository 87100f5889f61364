//! Pairs of panels on which the kernel is singular: a panel with itself or with its neighbour.
//!
//! There the kernel K of [`super::kernel`] is, with p = 1 − 2ν,
//! ν K = h^p [ ((x/h)^p − 1)/p + (1 − (d/h)^p)/p ] − ((y+e)^p − y^p)/p, d = |s−t|, x the distance of the
//! farther point from the near end of the interval, e and y the distances of the nearer point from the near and
//! the far end, h the size of the pair. Only d is singular; in suitable coordinates d/h = ρ g with g analytic,
//! and (1 − (ρg)^p)/p = (1 − ρ^p)/p − ρ^p (g^p − 1)/p is integrated with the two Gauss rules of
//! [`super::rules`], which remain valid through ν = 1/2.
//!
//! All panels use the Legendre polynomials of their own coordinate, so that the values of the basis and the
//! integrals that do not depend on the shape are computed once; the caller transforms to the basis of the cell.

use super::cell::Panel;
use super::kernel::exp_quotient;
use super::rules::{Pairs, Rules};
use super::space::{MOST_FUNCTIONS, Values, legendre};
use crate::error::Result;

/// The integrals over one pair of panels of products of two basis functions with the kernel.
pub(crate) type Block = [[f64; MOST_FUNCTIONS]; MOST_FUNCTIONS];

/// A block of zeros.
pub(crate) const EMPTY: Block = [[0.0; MOST_FUNCTIONS]; MOST_FUNCTIONS];

/// A quadrature point of a pair: the factor ρ of its distance, two coordinates, its weight, and the basis at s
/// and at t.
struct Sample {
    rho: f64,
    place: (f64, f64),
    weight: f64,
    s: Values,
    t: Values,
}

/// A quadrature point ξ for a term that depends on only one of s and t, with the basis at s and t, integrated
/// over the other.
struct Term {
    xi: f64,
    weight: f64,
    s: Values,
    t: Values,
}

/// Quadrature on one kind of pair.
struct Singular {
    /// The points for the analytic factor (g^p − 1)/p.
    power: Vec<Sample>,
    /// The integrals with (1 − ρ^p)/p.
    logarithm: Block,
    /// The points for functions of s alone, and of t alone.
    of_nearer: Vec<Term>,
    of_further: Vec<Term>,
}

/// Rules for adjacent panels with up to `functions` slope functions.
pub(crate) struct Adjacent {
    functions: usize,
    p: f64,
    same: Singular,
    touching: Singular,
    /// Integrals with (1 − z^p)/p, z the distance of the farther point from the left end of the panel, or of
    /// the nearer one from the right end: the terms of one point on a panel at the end of the interval.
    at_left_end: Block,
    at_right_end: Block,
}

impl Adjacent {
    /// The data for n-point rules on a panel and `close`-point rules on two panels.
    pub(crate) fn new(functions: usize, p: f64, n: usize, close: usize) -> Result<Self> {
        let rules = Rules::new(n, p)?;
        let end = &rules.logarithm[1];
        let integrated = |terms: Vec<Term>| {
            let mut block = EMPTY;
            terms
                .iter()
                .for_each(|term| add_product(&mut block, functions, term.weight, &term.s, &term.t));
            block
        };
        Ok(Self {
            functions,
            p,
            same: Singular::same(functions, &rules),
            touching: Singular::touching(functions, &Rules::new(close, p)?),
            at_left_end: integrated(further_terms(functions, end, 0, &rules.plain)),
            at_right_end: integrated(nearer_terms(functions, end, 0, &rules.plain)),
        })
    }

    /// The number of kernel values on one panel and on two.
    pub(crate) fn points(&self) -> (u64, u64) {
        (self.same.power.len() as u64, self.touching.power.len() as u64)
    }

    /// The integrals over the triangle s < t of a panel, given the terms of s alone and of t alone. The term of
    /// t is `None` on a panel at the left end of the interval, where it is h^p ((z)^p − 1)/p with the
    /// singularity inside; likewise that of s at the right end.
    pub(crate) fn same(
        &self,
        panel: &Panel,
        nearer: Option<&dyn Fn(f64) -> f64>,
        further: Option<&dyn Fn(f64) -> f64>,
    ) -> Block {
        let distance = |sample: &Sample| panel.between(sample.place.0, sample.rho);
        let mut block = self.singular(&self.same, panel.length, distance);
        let unit = panel.length.powf(self.p);
        match nearer {
            Some(term) => self.add_terms(&mut block, &self.same.of_nearer, term),
            None => self.add(&mut block, &self.at_right_end, -unit),
        }
        match further {
            Some(term) => self.add_terms(&mut block, &self.same.of_further, term),
            None => self.add(&mut block, &self.at_left_end, -unit),
        }
        block
    }

    /// The integrals over neighbouring panels, s < t.
    pub(crate) fn touching(
        &self,
        (s, t): (&Panel, &Panel),
        nearer: impl Fn(f64) -> f64,
        further: impl Fn(f64) -> f64,
    ) -> Block {
        let distance =
            |sample: &Sample| s.right_distance(sample.place.0) + t.left_distance(sample.place.1);
        let mut block = self.singular(&self.touching, s.length + t.length, distance);
        self.add_terms(&mut block, &self.touching.of_nearer, nearer);
        self.add_terms(&mut block, &self.touching.of_further, further);
        block
    }

    /// The integrals with h^p (1 − (d/h)^p)/p.
    fn singular(&self, pair: &Singular, size: f64, distance: impl Fn(&Sample) -> f64) -> Block {
        let unit = size.powf(self.p);
        let mut block = EMPTY;
        for sample in &pair.power {
            let value = -unit * exp_quotient(self.p, (distance(sample) / (sample.rho * size)).ln());
            add_product(&mut block, self.functions, sample.weight * value, &sample.s, &sample.t);
        }
        self.add(&mut block, &pair.logarithm, unit);
        block
    }

    fn add_terms(&self, block: &mut Block, terms: &[Term], value: impl Fn(f64) -> f64) {
        for term in terms {
            add_product(block, self.functions, term.weight * value(term.xi), &term.s, &term.t);
        }
    }

    fn add(&self, block: &mut Block, other: &Block, factor: f64) {
        for (row, of_other) in block.iter_mut().zip(other).take(self.functions) {
            for (value, more) in row.iter_mut().zip(of_other).take(self.functions) {
                *value += factor * more;
            }
        }
    }
}

impl Singular {
    /// A panel with itself: ρ is the step from s to t, place.0 the point s.
    fn same(functions: usize, rules: &Rules) -> Self {
        let samples = |outer: &Pairs| -> Vec<Sample> {
            let at = |(step, w): (f64, f64), (zeta, v): (f64, f64)| {
                let xi = (1.0 - step) * zeta;
                let (s, t) = (legendre(functions, xi), legendre(functions, xi + step));
                Sample { rho: step, place: (xi, xi + step), weight: w * v * (1.0 - step), s, t }
            };
            outer.iter().flat_map(|&o| rules.plain.iter().map(move |&i| at(o, i))).collect()
        };
        Self {
            power: samples(&rules.power[0]),
            logarithm: integrals(functions, &samples(&rules.logarithm[0])),
            of_nearer: nearer_terms(functions, &rules.plain, 1, &rules.plain),
            of_further: further_terms(functions, &rules.plain, 1, &rules.plain),
        }
    }

    /// Two panels. Corner coordinates: distances ρ, ρσ (in ξ) from the common point, in both orders; `place`
    /// stores both.
    fn touching(functions: usize, rules: &Rules) -> Self {
        let samples = |outer: &Pairs| -> Vec<Sample> {
            let at = |(rho, w): (f64, f64), (a, b): (f64, f64), v: f64| {
                let (s, t) = (legendre(functions, 1.0 - a), legendre(functions, b));
                Sample { rho, place: (a, b), weight: w * v, s, t }
            };
            let both = |o: (f64, f64), (sigma, v): (f64, f64)| {
                [at(o, (o.0, o.0 * sigma), v), at(o, (o.0 * sigma, o.0), v)]
            };
            outer.iter().flat_map(|&o| rules.plain.iter().flat_map(move |&i| both(o, i))).collect()
        };
        // The polynomials are orthonormal: the integral of one is that of the first, 1, or nothing.
        let mut mean = [0.0; MOST_FUNCTIONS + 1];
        mean[0] = 1.0;
        let terms = |of_s: bool| -> Vec<Term> {
            let at = |&(xi, weight): &(f64, f64)| {
                let values = legendre(functions, xi);
                let (s, t) = if of_s { (values, mean) } else { (mean, values) };
                Term { xi, weight, s, t }
            };
            rules.plain.iter().map(at).collect()
        };
        Self {
            power: samples(&rules.power[1]),
            logarithm: integrals(functions, &samples(&rules.logarithm[1])),
            of_nearer: terms(true),
            of_further: terms(false),
        }
    }
}

/// The terms of t at z on the triangle s < t of a panel, s = zζ; `power` = 1 if the outer rule does not contain
/// the weight z of dζ.
fn further_terms(functions: usize, outer: &Pairs, power: i32, inner: &Pairs) -> Vec<Term> {
    let term = |&(z, w): &(f64, f64)| {
        let s = averaged(functions, inner, |zeta| z * zeta);
        Term { xi: z, weight: w * z.powi(power), s, t: legendre(functions, z) }
    };
    outer.iter().map(term).collect()
}

/// The terms of s at 1 − c, t = 1 − cζ.
fn nearer_terms(functions: usize, outer: &Pairs, power: i32, inner: &Pairs) -> Vec<Term> {
    let term = |&(c, w): &(f64, f64)| {
        let t = averaged(functions, inner, |zeta| 1.0 - c * zeta);
        Term { xi: 1.0 - c, weight: w * c.powi(power), s: legendre(functions, 1.0 - c), t }
    };
    outer.iter().map(term).collect()
}

/// Averages of the basis over the points to which `place` maps those of a rule.
fn averaged(functions: usize, rule: &Pairs, place: impl Fn(f64) -> f64) -> Values {
    let mut sums = [0.0; MOST_FUNCTIONS + 1];
    for &(zeta, v) in rule {
        for (sum, value) in sums.iter_mut().zip(legendre(functions, place(zeta))) {
            *sum += v * value;
        }
    }
    sums
}

fn integrals(functions: usize, samples: &[Sample]) -> Block {
    let mut block = EMPTY;
    samples
        .iter()
        .for_each(|sample| add_product(&mut block, functions, sample.weight, &sample.s, &sample.t));
    block
}

/// Adds the product value · s tᵀ.
fn add_product(block: &mut Block, functions: usize, value: f64, s: &Values, t: &Values) {
    for (row, of_s) in block.iter_mut().zip(s).take(functions) {
        let factor = value * of_s;
        for (entry, of_t) in row.iter_mut().zip(t).take(functions) {
            *entry += factor * of_t;
        }
    }
}
