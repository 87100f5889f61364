//! The true worst case of one element of length h, and the bounds of both cases as functions of θ (Section 3,
//! "Globally").
//!
//! For a contact set E ⊂ [0, 1] of the element (in units of h) let
//!
//! W(E) = sup ∫ σ_N (I^h u)_N / (‖σ_N‖_ν ‖u_N'‖_ν)  over u_N ≤ 0, u_N = 0 on E, σ_N ≤ 0, σ_N = 0 off E,
//!
//! norms (1.1) of the element of length h, ν = τ − 3/2. *The worst set is an interval*: the term sees u_N
//! only through its values at the two vertices; filling the gaps between the first and the last contact
//! point, E = [a, 1 − b], leaves these free and allows more σ_N. *On an interval the problem is a matrix of
//! two rows*: with α = −u_N(0), β = −u_N(1),
//!
//! ∫ σ_N (I^h u)_N = h ∫_E |σ_N| (α(1−x) + βx),  W² = max over (α, β) ≥ 0 of cᵀSc / cᵀU⁻¹c, c = (α, β),
//!
//! S the dual products of 1−x and x over functions supported in E, U those of u_N ↦ −u_N(0), −u_N(1) over
//! slopes supported off E. Gram matrices of indicators have no positive entry off the diagonal, so that their
//! inverses have no negative one: the best σ_N has one sign by itself. Slopes of the left piece likewise when
//! b = 0; with both ends open, dropping the sign of u_N between vertex and contact can only raise W.
//!
//! Trial functions: constants (τ < 2) or continuous linears (τ = 2) on meshes graded to all ends of E. They
//! are conforming, so W is a lower bound up to rounding. Cost O(K³) for K ≈ 40 cells in E, per set and h.
//!
//! | bound | first case, zeros within θ of both vertices | second case, σ_N = 0 on θ |
//! | --- | --- | --- |
//! | printed (3.9), (3.14), (3.10), (3.15) | C(q) h θ^{1−1/q} | C_P θ^{τ−2} C_L2 h^{2τ−2}, ln(1/θ) at τ = 2 |
//! | sharpened | C' h^{1+ν} θ^{1−1/q}, θ ≤ 1/4 | the same, √ln(1/θ) at τ = 2 |
//!
//! *Sharpened first case.* u_N' has mean zero between the two zeros, a zone of at least h/2, so ‖ũ'‖₀ ≤
//! γ_{1/2}(ν) |ũ'|_ν on the reference interval and (3.7) may keep the seminorm alone: ‖u_N'‖_{L^q} ≤ C'
//! h^{1/q−1/2+ν} |u_N'|_ν, C' = C(q)(1 + γ_{1/2}²)^{1/2}, a factor h^ν better than (3.8). At τ < 2 the
//! balance moves to θ = h^{τ−3/2} and the bound to h^{2τ−2−(τ−3/2)(2−τ)}: half of what the printed proof
//! loses is a matter of (3.7).

use crate::ErrorExt;
use crate::search::sign_change;
use fractional_sobolev::{Gram, Mesh, Order};
use nalgebra::{Cholesky, DMatrix};
use signorini::edge::Traces;
use signorini::proof::ProofConstants;
use signorini::{Error, Result, ToolkitError};

/// Layers of the mesh at every end, and their ratio.
const LAYERS: usize = 8;
const RATIO: f64 = 0.35;
/// Distances from a vertex: 0, and these powers of 1/2, and 3/4.
const DEPTH: i32 = 10;
/// At least this much of the element is in contact.
const CORE: f64 = 1.0 / 16.0;

/// Forms of one support: |·|²_ν and L² on the reference interval, and the two functionals.
struct Forms {
    seminorm: DMatrix<f64>,
    mass: DMatrix<f64>,
    functionals: DMatrix<f64>,
}

impl Forms {
    /// From the forms of all basis functions, kept where they vanish off the support.
    fn restrict(&self, kept: &[usize]) -> Self {
        let square =
            |m: &DMatrix<f64>| DMatrix::from_fn(kept.len(), kept.len(), |i, j| m[(kept[i], kept[j])]);
        let functionals = DMatrix::from_fn(kept.len(), 2, |i, j| self.functionals[(kept[i], j)]);
        Self { seminorm: square(&self.seminorm), mass: square(&self.mass), functionals }
    }

    /// h² Fᵀ (h M + h^{1−2ν} K)⁻¹ F: dual products of the functionals on the element of length h.
    fn dual(&self, h: f64, order: Order) -> Result<[[f64; 2]; 2]> {
        let size = self.mass.nrows();
        if size == 0 {
            return Ok([[0.0; 2]; 2]);
        }
        let scale = h.powf(-2.0 * order.offset());
        let norm = DMatrix::from_fn(size, size, |i, j| h * self.mass[(i, j)] + scale * self.seminorm[(i, j)]);
        let broken = || {
            Error::Toolkit(ToolkitError::NotPositiveDefinite { what: "Gram matrix of a trace", pivot: size })
        };
        let solved = Cholesky::new(norm).ok_or_else(broken)?.solve(&self.functionals);
        let product = |i: usize, j: usize| {
            h * h * (0..size).map(|k| self.functionals[(k, i)] * solved[(k, j)]).sum::<f64>()
        };
        Ok([[product(0, 0), product(0, 1)], [product(1, 0), product(1, 1)]])
    }
}

/// An interval of contact [a, 1 − b] with everything that does not depend on h.
struct ContactInterval {
    ends: [f64; 2],
    stress: Forms,
    slope: Forms,
}

impl ContactInterval {
    fn new(a: f64, b: f64, traces: Traces, order: Order) -> Result<Self> {
        let mut points = vec![0.0, a, 1.0 - b, 1.0];
        points.dedup();
        let partition = Mesh::graded(&points, LAYERS, RATIO)?;
        let part = partition.len() / (points.len() - 1);
        let before = if a > 0.0 { part } else { 0 };
        let contact = before..before + part;
        let x = partition.from_left();
        let weight: [&dyn Fn(f64) -> f64; 2] = [&|x| 1.0 - x, &|x| x];
        let left = |x: f64| if x < a { 1.0 } else { 0.0 };
        let right = |x: f64| if x > 1.0 - b { 1.0 } else { 0.0 };
        // |u(0)| = h∫v on the left piece, |u(1)| = −h∫v on the right one.
        let middle = |cell: usize| 0.5 * (x[cell] + x[cell + 1]);
        let ends =
            move |cell: usize, j: usize| if j == 0 { left(middle(cell)) } else { -right(middle(cell)) };
        let stress_of = |cell: usize, j: usize| [weight[j](x[cell]), weight[j](x[cell + 1])];
        let (all_stress, all_slope) = match traces {
            Traces::Constants => (
                constants(&partition, order, &stress_of)?,
                constants(&partition, order, &|cell, j| [ends(cell, j); 2])?,
            ),
            Traces::Linears => (
                linears(&partition, order, &stress_of)?,
                linears(&partition, order, &|cell, j| [ends(cell, j); 2])?,
            ),
        };
        let cells = partition.len();
        let (inside, outside): (Vec<usize>, Vec<usize>) = match traces {
            Traces::Constants => (0..cells).partition(|i| contact.contains(i)),
            Traces::Linears => {
                // A hat lies in a support when both its cells do.
                let touches = |i: usize, closed: bool| {
                    (i.saturating_sub(1)..(i + 1).min(cells)).all(|cell| contact.contains(&cell) == closed)
                };
                let keep = |closed| (0..=cells).filter(move |&i| touches(i, closed)).collect();
                (keep(true), keep(false))
            }
        };
        Ok(Self { ends: [a, b], stress: all_stress.restrict(&inside), slope: all_slope.restrict(&outside) })
    }

    /// W and the direction (α, β) that attains it.
    fn worst(&self, h: f64, order: Order) -> Result<WorstPair> {
        let (s, u) = (self.stress.dual(h, order)?, self.slope.dual(h, order)?);
        // max cᵀSc / cᵀU⁻¹c over c ≥ 0. One open end: U is singular, c is fixed.
        let [a, b] = self.ends;
        let single = |i: usize| (s[i][i] * u[i][i]).sqrt();
        let mut best = match (a > 0.0, b > 0.0) {
            (true, false) => (single(0), [1.0, 0.0]),
            (false, true) => (single(1), [0.0, 1.0]),
            _ => (0.0, [0.0, 0.0]),
        };
        let determinant = u[0][0] * u[1][1] - u[0][1] * u[1][0];
        if a > 0.0 && b > 0.0 && determinant > 0.0 {
            let inverse = [
                [u[1][1] / determinant, -u[0][1] / determinant],
                [-u[1][0] / determinant, u[0][0] / determinant],
            ];
            let form = |m: &[[f64; 2]; 2], c: [f64; 2]| {
                c[0] * c[0] * m[0][0] + 2.0 * c[0] * c[1] * m[0][1] + c[1] * c[1] * m[1][1]
            };
            // A quotient of quadratic forms on a quarter circle has at most one inner maximum.
            let quotient = |angle: f64| {
                let c = [angle.cos(), angle.sin()].map(|v| v.max(0.0));
                ((form(&s, c) / form(&inverse, c)).sqrt(), c)
            };
            const STEPS: i32 = 256;
            for k in 0..=STEPS {
                let found = quotient(std::f64::consts::FRAC_PI_2 * f64::from(k) / f64::from(STEPS));
                if found.0 > best.0 {
                    best = found;
                }
            }
        }
        Ok(WorstPair { ends: self.ends, value: best.0, direction: best.1 })
    }
}

fn constants(partition: &Mesh, order: Order, density: &dyn Fn(usize, usize) -> [f64; 2]) -> Result<Forms> {
    let lengths = partition.lengths();
    let size = lengths.len();
    Ok(Forms {
        seminorm: Gram::constants(partition, order, 1e-8)?.to_dense()?,
        mass: DMatrix::from_fn(size, size, |i, j| if i == j { lengths[i] } else { 0.0 }),
        functionals: DMatrix::from_fn(size, 2, |i, j| {
            let [l, r] = density(i, j);
            0.5 * lengths[i] * (l + r)
        }),
    })
}

fn linears(partition: &Mesh, order: Order, density: &dyn Fn(usize, usize) -> [f64; 2]) -> Result<Forms> {
    let lengths = partition.lengths();
    let size = lengths.len() + 1;
    let mut mass = DMatrix::zeros(size, size);
    let mut functionals = DMatrix::zeros(size, 2);
    for (i, &p) in lengths.iter().enumerate() {
        mass[(i, i)] += p / 3.0;
        mass[(i + 1, i + 1)] += p / 3.0;
        mass[(i, i + 1)] += p / 6.0;
        mass[(i + 1, i)] += p / 6.0;
        for j in 0..2 {
            let [l, r] = density(i, j);
            functionals[(i, j)] += p * (2.0 * l + r) / 6.0;
            functionals[(i + 1, j)] += p * (l + 2.0 * r) / 6.0;
        }
    }
    Ok(Forms { seminorm: Gram::new(partition, order, 1e-8)?.to_dense()?, mass, functionals })
}

/// The worst pair of one contact interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WorstPair {
    /// a and b: the contact set is [a, 1 − b], in units of h.
    pub ends: [f64; 2],
    /// W.
    pub value: f64,
    /// (−u_N(0), −u_N(1)) up to a factor.
    pub direction: [f64; 2],
}

/// All contact intervals of a grid, for one τ.
pub struct ElementBalance {
    constants: ProofConstants,
    /// γ_{1/2}(ν).
    half: f64,
    intervals: Vec<ContactInterval>,
}

impl ElementBalance {
    /// Distances a ≥ b from {0, 2^{−10}, ..., 1/2, 3/4}; the mirror images have the same W.
    ///
    /// # Errors
    /// [`ToolkitError::OutOfRange`](signorini::ToolkitError::OutOfRange) for τ outside (3/2, 2] or q below 2.
    pub fn new(tau: f64, q: f64) -> Result<Self> {
        ToolkitError::require("tau", tau, "(3/2, 2]", tau > 1.5 && tau <= 2.0)?;
        let constants = ProofConstants::new(tau, q, &[])?;
        let half = constants.gamma(0.5)?;
        let mut grid = vec![0.0];
        grid.extend((1..=DEPTH).rev().map(|k| 0.5f64.powi(k)));
        grid.push(0.75);
        let mut intervals = Vec::new();
        for (i, &a) in grid.iter().enumerate().skip(1) {
            for &b in grid[..=i].iter().filter(|&&b| a + b <= 1.0 - CORE) {
                intervals.push(ContactInterval::new(a, b, Traces::for_regularity(tau), constants.order())?);
            }
        }
        Ok(Self { constants, half, intervals })
    }

    /// The constants.
    pub fn constants(&self) -> &ProofConstants {
        &self.constants
    }

    /// W of every contact interval on an element of length h.
    ///
    /// # Errors
    /// [`ToolkitError::OutOfRange`](signorini::ToolkitError::OutOfRange) unless 0 < h ≤ 1.
    pub fn worst_pairs(&self, h: f64) -> Result<Vec<WorstPair>> {
        ToolkitError::require("h", h, "(0, 1]", h > 0.0 && h <= 1.0)?;
        self.intervals.iter().map(|interval| interval.worst(h, self.constants.order())).collect()
    }

    /// C(q) h θ^{1−1/q}.
    pub fn first_bound(&self, h: f64, theta: f64) -> f64 {
        self.constants.embedding * h * theta.powf(self.constants.hoelder())
    }

    /// C' h^{1+ν} θ^{1−1/q}, for θ ≤ 1/4; beyond, the printed one.
    pub fn sharpened_first_bound(&self, h: f64, theta: f64) -> f64 {
        let printed = self.first_bound(h, theta);
        let factor = (1.0 + self.half * self.half).sqrt() * h.powf(self.constants.order().value());
        if theta <= 0.25 { printed * factor.min(1.0) } else { printed }
    }

    /// The second case with the printed law of the Poincaré constant, and with the one that holds.
    pub fn second_bound(&self, h: f64, theta: f64) -> [f64; 2] {
        let scale = self.constants.interpolation * h.powf(1.0 + 2.0 * self.constants.order().value());
        let law = self.constants.law(theta);
        [law.printed * scale, law.corrected * scale]
    }

    /// The θ at which the bounds of both cases agree, printed or sharpened: the first rises, the second falls
    /// with θ.
    pub fn crossing(&self, h: f64, sharpened: bool) -> f64 {
        let excess = |t: f64| {
            let theta = t.exp();
            if sharpened {
                self.sharpened_first_bound(h, theta) - self.second_bound(h, theta)[1]
            } else {
                self.first_bound(h, theta) - self.second_bound(h, theta)[0]
            }
        };
        // θ in (1e-30, 1/2]; where the first bound stays below, 1/2.
        let (low, high) = (1e-30f64.ln(), 0.5f64.ln());
        if excess(high) <= 0.0 {
            return 0.5;
        }
        sign_change(low, high, 0.0, |theta| excess(theta) > 0.0).1.exp()
    }
}
