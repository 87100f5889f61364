//! Upper bounds of both constants, by eigenvalues of finite matrices: at most twice the constants for s ≥ 1/4.
//!
//! T has longest edge 1, g = ∇u. T is cut into cells K similar to T, of size a: n² equal ones, those at the corners
//! of T cut again [`DEPTH`] times into four. D_K is the part K × K of |g|²_s, p_K the mean of g on K.
//!
//! - *Pairs of cells.* By Cauchy-Schwarz ∫_K∫_K' |g(x) − g(y)|² k(|x − y|) ≥ w |p_K − p_K'|², w = |K|²|K'|² / ∫_K∫_K' 1/k. For
//!   k = r^(−2−2s) the mean of 1/k is at most m₂^(1−s) m₄^s, with the means m₂ and m₄ of r² and r⁴. So |g|²_s ≥ Σ D_K + b(p), b(p)
//!   = Σ w |p_K − p_K'|².
//! - *Near pairs, s > 3/4.* T is convex: F(h) = ∫ |g(x + h) − g(x)|² dx has F(2h) ≤ 4 F(h), so that f(r) = F(rω)/r² has f(2r)
//!   ≤ f(r), and b may be taken with r^(−2−2s) κ(r) where Σ_{j≥0} q^j κ(2^(−j) r) ≤ 1/(1 − q) for all r, q = 2^(2s−2):
//!   κ = 1 for r ≥ 2ρ, 1 + q/(1−q) (1 − (r/2ρ)^γ) for ρ ≤ r ≤ 2ρ, κ(ρ) (r/ρ)^γ for r ≤ ρ, γ = 2s − 2s'. Then the near pairs are
//!   used twice, and |g|²_s ≥ t Σ D_K + (1 − t) b(p). For s ≤ 3/4 both t and 1 − t are replaced by 1 below.
//!   At s = 1, where D_K is ‖∇g‖² on K, f(r) ≤ f(0), and κ is the limit of 2(1−s)/π times this κ.
//! - *Means.* P² = sup ‖g − mean‖²/|g|²_s on T is the same on K but for a^(2s): with μ = min b(p)/Σ|K||p_K − mean|², |g|²_s ≥
//!   Σ ‖g − p_K‖²_K/(P² n^(−2s)) t + (1 − t) μ Σ |K| |p_K − mean|²; hence P² ≤ 1/((1 − t) μ) if t > n^(−2s).
//! - *Values at corners.* p_K is the gradient of the Crouzeix-Raviart interpolant, which is given by the means z on the edges.
//!   φ_A(z) is its value at the corner A of T in the cell there. E_A = sup |u(A) − φ⁰_A|/|g|_s, φ⁰_A the
//!   value for the single cell K = T, is E_A a^s on the cell at A, and E_A² ≤ M²/(1 − t) + E_A² a^(2s)/t,
//!   M² = sup (φ_A(z) − φ⁰_A)²/b.
//! - *The constants.* Let u = 0 at the corners (subtract Iu): then u(A) − φ_A(z) = −φ_A(z), and
//!   ‖∇(u − Iu)‖² = Σ ‖g − p_K‖²_K + |K||p_K|² is at most |g|²_s times the larger one of P² max(n^(−2s), 2a^(2s))/t and the
//!   largest eigenvalue of Σ |K||p_K|² against (1 − t) b + Σ_A t φ_A²/(2 E_A² a^(2s)): at the corners half of D_K is used for φ_A,
//!   half for g − p_K. In L² likewise with the interpolant's norm, the two bounds of squares are added by Cauchy-Schwarz, and
//!   ‖u − interpolant‖_K ≤ (1/π² + 1/48)^(1/2) a ‖g − p_K‖_K: Payne & Weinberger (1960), and the mean m over K of a
//!   function with mean 0 on each edge, 2|K| m = −∫ (x − c)·∇, c the centre of K.
//!
//! Both bounds are proved up to rounding. That they come nearer to the constants as n grows is seen, not proved.

use super::shape::TriangleShape;
use crate::error::{Error, Result};
use crate::numeric::dense::{Cholesky, product, transpose_times};
use nalgebra::{DMatrix, DVector};
use std::collections::BTreeMap;
use std::f64::consts::{LN_2, PI};

/// Bisections at the corners.
const DEPTH: u32 = 6;
/// Cells along an edge up to an order; the share of near pairs grows with it.
const CELLS: [(f64, i64); 2] = [(0.5, 8), (NEAR, 12)];
const FINEST: i64 = 20;
/// Order above which the weights of near pairs are increased, with s', ρ in cells, and the share t of the cells.
const NEAR: f64 = 0.75;
const OTHER_ORDER: f64 = 0.55;
const REACH: f64 = 3.0;
const SHARE: f64 = 0.04;
/// Eigenvalues are proved to this relative distance from their approximations.
const MARGIN: f64 = 1e-3;
/// Share of D_K that the values at the corners use, on the cells there; the rest is left for g − p_K.
const AT_CORNER: f64 = 0.5;
const ITERATIONS: usize = 40;

/// A vertex: i (B − A) + j (C − A) over the number of subdivisions.
type Vertex = (i64, i64);

/// Upper bounds of sup ‖∇(u − Iu)‖/|∇u|_s and sup ‖u − Iu‖/|∇u|_s for a triangle with longest edge 1, 0 < s ≤ 1.
///
/// # Errors
/// [`Error::NotPositiveDefinite`] where rounding exceeds a form.
pub(super) fn bounds(shape: &TriangleShape, s: f64) -> Result<[f64; 2]> {
    bounds_on(shape, s, CELLS.into_iter().find(|(order, _)| s <= *order).map_or(FINEST, |(_, n)| n))
}

fn bounds_on(shape: &TriangleShape, s: f64, n: i64) -> Result<[f64; 2]> {
    let cells = Cells::new(shape, n);
    let h = 1.0 / n as f64;
    let is_split = s > NEAR;
    let (inside, between) = if is_split { (SHARE, 1.0 - SHARE) } else { (1.0, 1.0) };
    let factor = Factor::new(s, is_split.then_some(REACH * h));
    let weights = cells.weights(s, &factor) * between;

    let areas = DVector::from_vec(cells.areas());
    let all = areas.sum();
    let to_constants = &areas * areas.transpose() * (weights.trace() / (all * all));
    let mean = largest(&DMatrix::from_diagonal(&areas), &(&weights + to_constants))?;

    let gradients = cells.gradients(shape);
    let form = |of: &DMatrix<f64>| {
        gradients.iter().fold(DMatrix::zeros(cells.edges, cells.edges), |sum, gradient| {
            sum + transpose_times(gradient, &product(of, gradient))
        })
    };
    let pairs = form(&weights);
    let sides = cells.sides();
    let scale = pairs.trace() / cells.edges as f64;
    let to_linear =
        sides.iter().fold(pairs.clone(), |sum, side| sum + side * side.transpose() * scale);
    let to_linear = Cholesky::new(&to_linear).ok_or_else(indefinite)?;
    let mut energy = pairs;
    for corner in 0..3 {
        let (value, size) = cells.at_corner(corner);
        let whole = |k: usize| if k == corner { -1.0 } else { 1.0 };
        let rest = (0..3).fold(value.clone(), |sum, k| sum - &sides[k] * whole(k));
        let column = DMatrix::from_column_slice(cells.edges, 1, rest.as_slice());
        let square = (column.transpose() * to_linear.solve(&column))[(0, 0)];
        let shrunk = size.powf(2.0 * s) / inside;
        let error = square / (1.0 - shrunk);
        energy += &value * value.transpose() * (AT_CORNER / (error * shrunk));
    }
    let within = mean / inside * cells.most(2.0 * s);
    let slope = largest(&form(&DMatrix::from_diagonal(&areas)), &energy)?.max(within);
    let rest = (PI.powi(-2) + 1.0 / 48.0) * mean / inside * cells.most(2.0 + 2.0 * s);
    let l2 = largest(&cells.l2(), &energy)? + rest;
    Ok([slope, l2].map(f64::sqrt))
}

fn indefinite() -> Error {
    Error::NotPositiveDefinite { what: "matrix of the energy of pairs of cells", pivot: 0 }
}

/// An upper bound of the largest λ with B x = λ A x: a Rayleigh quotient, increased until λ A − B has a Cholesky factor.
fn largest(b: &DMatrix<f64>, a: &DMatrix<f64>) -> Result<f64> {
    let factor = Cholesky::new(a).ok_or_else(indefinite)?;
    let mut x = DMatrix::from_fn(a.nrows(), 1, |i, _| 1.0 + (i as f64).sin());
    let mut value = 0.0;
    for _ in 0..ITERATIONS {
        let image = b * &x;
        value = x.dot(&image) / x.dot(&(a * &x));
        x = factor.solve(&image);
        x /= x.amax();
    }
    let mut margin = MARGIN;
    while Cholesky::new(&(a * (value * (1.0 + margin)) - b)).is_none() {
        margin *= 2.0;
        Error::require("margin of an eigenvalue", margin, "[0, 1)", margin < 1.0)?;
    }
    Ok(value * (1.0 + margin))
}

/// κ(r), the factor of r^(−2−2s).
struct Factor {
    /// ρ; 0 where κ = 1.
    radius: f64,
    /// γ = 2s − 2s'.
    power: f64,
    /// q/(1 − q), and κ beyond 2ρ.
    near: f64,
    far: f64,
}

impl Factor {
    fn new(s: f64, radius: Option<f64>) -> Self {
        let q = (-LN_2 * (2.0 - 2.0 * s)).exp();
        let (near, far) = if s == 1.0 { (1.0 / (PI * LN_2), 0.0) } else { (q / (1.0 - q), 1.0) };
        Self { radius: radius.unwrap_or(0.0), power: 2.0 * (s - OTHER_ORDER), near, far }
    }

    /// κ(ρ).
    fn top(&self) -> f64 {
        self.far + self.near * (1.0 - (-LN_2 * self.power).exp())
    }

    fn at(&self, r: f64) -> f64 {
        if r <= self.radius {
            self.top() * (r / self.radius).powf(self.power)
        } else if r < 2.0 * self.radius {
            self.far + self.near * (1.0 - (0.5 * r / self.radius).powf(self.power))
        } else {
            self.far
        }
    }
}

/// The cells of T and the means on their edges.
struct Cells {
    shape: TriangleShape,
    /// Subdivisions of the edges of T.
    parts: i64,
    /// Vertices in the order of the corners of T, a point reflection for half of the cells.
    vertices: Vec<[Vertex; 3]>,
    /// Means opposite the vertices: two of half the edge where the neighbours are smaller, otherwise one twice.
    means: Vec<[[usize; 2]; 3]>,
    /// Edges that are not cut.
    lines: BTreeMap<[Vertex; 2], usize>,
    edges: usize,
}

impl Cells {
    fn new(shape: &TriangleShape, n: i64) -> Self {
        let step = 2 << DEPTH; // the middle of every edge has integer coordinates
        let parts = n * step;
        let mut vertices = Vec::new();
        for i in 0..n {
            for j in 0..n - i {
                let (x, y) = (i * step, j * step);
                vertices.push([(x, y), (x + step, y), (x, y + step)]);
                if i + j + 1 < n {
                    vertices.push([(x + step, y + step), (x, y + step), (x + step, y)]);
                }
            }
        }
        let corners = [(0, 0), (parts, 0), (0, parts)];
        for _ in 0..DEPTH {
            vertices = vertices.iter().flat_map(|cell| cut(cell, &corners)).collect();
        }
        let opposite = |cell: &[Vertex; 3], k: usize| edge(cell[(k + 1) % 3], cell[(k + 2) % 3]);
        let mut lines: BTreeMap<[Vertex; 2], usize> =
            vertices.iter().flat_map(|cell| (0..3).map(|k| (opposite(cell, k), 0))).collect();
        let halves = |[a, b]: [Vertex; 2]| [edge(a, middle(a, b)), edge(middle(a, b), b)];
        let whole: Vec<_> = lines
            .keys()
            .copied()
            .filter(|line| halves(*line).iter().any(|h| !lines.contains_key(h)))
            .collect();
        lines = whole.into_iter().enumerate().map(|(number, line)| (line, number)).collect();
        let mean = |line: [Vertex; 2]| match lines.get(&line) {
            Some(&number) => [number; 2],
            None => halves(line).map(|half| lines[&half]),
        };
        let means =
            vertices.iter().map(|cell| [0, 1, 2].map(|k| mean(opposite(cell, k)))).collect();
        Self { shape: *shape, parts, edges: lines.len(), vertices, means, lines }
    }

    /// Size of a cell over that of T, negative if it is reflected.
    fn size(&self, [a, b, _]: &[Vertex; 3]) -> f64 {
        (b.0 - a.0) as f64 / self.parts as f64
    }

    /// Largest a^power over the share of D_K that the values at the corners leave, over the cells of size a.
    fn most(&self, power: f64) -> f64 {
        let corners = [(0, 0), (self.parts, 0), (0, self.parts)];
        self.vertices.iter().fold(0.0, |most: f64, cell| {
            let is_at_corner = cell.iter().any(|vertex| corners.contains(vertex));
            let left = if is_at_corner { 1.0 - AT_CORNER } else { 1.0 };
            most.max(self.size(cell).abs().powf(power) / left)
        })
    }

    fn areas(&self) -> Vec<f64> {
        self.vertices
            .iter()
            .map(|cell| 0.5 * self.shape.twice() * self.size(cell).powi(2))
            .collect()
    }

    fn corners(&self, cell: &[Vertex; 3]) -> [[f64; 2]; 3] {
        let [f, t] = self.shape.frame(0);
        let at = |(i, j): Vertex, c: usize| {
            ((i + j) as f64 * f[c] + j as f64 * t[c]) / self.parts as f64
        };
        cell.map(|vertex| [at(vertex, 0), at(vertex, 1)])
    }

    /// The matrix of b: twice the graph Laplacian of the weights w of pairs of cells.
    fn weights(&self, s: f64, factor: &Factor) -> DMatrix<f64> {
        let (cells, areas) = (self.vertices.len(), self.areas());
        let corners: Vec<_> = self.vertices.iter().map(|cell| self.corners(cell)).collect();
        let mut form = DMatrix::zeros(cells, cells);
        for k in 0..cells {
            for l in 0..k {
                let [second, fourth] = moments(&corners[k], &corners[l]);
                let power = |s: f64| second.powf(1.0 - s) * fourth.powf(s);
                let (least, most) = distances(&corners[k], &corners[l]);
                let mut weight = factor.at(least).min(factor.at(most)) / power(s);
                if most <= factor.radius {
                    let near =
                        factor.top() * factor.radius.powf(-factor.power) / power(OTHER_ORDER);
                    weight = weight.max(near);
                }
                weight *= 2.0 * areas[k] * areas[l];
                form[(k, l)] -= weight;
                form[(l, k)] -= weight;
                form[(k, k)] += weight;
                form[(l, l)] += weight;
            }
        }
        form
    }

    /// p from the means on edges, by components: Σ z_k (−2 ∇λ_k).
    fn gradients(&self, shape: &TriangleShape) -> [DMatrix<f64>; 2] {
        [0, 1].map(|c| {
            let mut matrix = DMatrix::zeros(self.vertices.len(), self.edges);
            for (row, (cell, means)) in self.vertices.iter().zip(&self.means).enumerate() {
                for (mean, gradient) in means.iter().zip(shape.gradients()) {
                    mean.iter()
                        .for_each(|&half| matrix[(row, half)] -= gradient[c] / self.size(cell));
                }
            }
            matrix
        })
    }

    /// The square of the interpolant's norm: |K|/3 Σ z_k² over the cells.
    fn l2(&self) -> DMatrix<f64> {
        let mut matrix = DMatrix::zeros(self.edges, self.edges);
        for (area, means) in self.areas().iter().zip(&self.means) {
            for [a, b] in means {
                for (i, j) in [(a, a), (a, b), (b, a), (b, b)] {
                    matrix[(*i, *j)] += area / 12.0;
                }
            }
        }
        matrix
    }

    /// The value of the interpolant at a corner of T, and the size of the cell there.
    fn at_corner(&self, corner: usize) -> (DVector<f64>, f64) {
        let at = [(0, 0), (self.parts, 0), (0, self.parts)][corner];
        let mut value = DVector::zeros(self.edges);
        let mut size = 1.0;
        for (cell, means) in
            self.vertices.iter().zip(&self.means).filter(|(cell, _)| cell[corner] == at)
        {
            size = self.size(cell);
            for (k, mean) in means.iter().enumerate() {
                mean.iter().for_each(|&half| value[half] += if k == corner { -0.5 } else { 0.5 });
            }
        }
        (value, size)
    }

    /// The means over the sides of T, from those of the edges on them.
    fn sides(&self) -> [DVector<f64>; 3] {
        let opposite = |(i, j): Vertex, k: usize| [self.parts - i - j, i, j][k] == 0;
        [0, 1, 2].map(|k| {
            let mut side = DVector::zeros(self.edges);
            for ([a, b], &number) in
                self.lines.iter().filter(|([a, b], _)| opposite(*a, k) && opposite(*b, k))
            {
                side[number] = (a.0 - b.0).abs().max((a.1 - b.1).abs()) as f64 / self.parts as f64;
            }
            side
        })
    }
}

fn edge(a: Vertex, b: Vertex) -> [Vertex; 2] {
    [a.min(b), a.max(b)]
}

fn middle(a: Vertex, b: Vertex) -> Vertex {
    (i64::midpoint(a.0, b.0), i64::midpoint(a.1, b.1))
}

/// The four halves of a cell at a corner of T; the cell itself elsewhere.
fn cut(cell: &[Vertex; 3], corners: &[Vertex; 3]) -> Vec<[Vertex; 3]> {
    if !cell.iter().any(|vertex| corners.contains(vertex)) {
        return vec![*cell];
    }
    let [a, b, c] = *cell;
    let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
    vec![[a, ab, ca], [ab, b, bc], [ca, bc, c], [bc, ca, ab]]
}

/// Means of |x − y|² and |x − y|⁴ over x and y in two triangles, by a rule of degree four (Dunavant 1985).
fn moments(first: &[[f64; 2]; 3], second: &[[f64; 2]; 3]) -> [f64; 2] {
    const RULE: [(f64, f64); 2] = [
        (0.445_948_490_915_965, 0.223_381_589_678_011),
        (0.091_576_213_509_771, 0.109_951_743_655_322),
    ];
    let points = |corners: &[[f64; 2]; 3]| {
        let corners = *corners;
        RULE.into_iter().flat_map(move |(a, weight)| {
            (0..3).map(move |k| {
                let at = |c: usize| {
                    (0..3)
                        .map(|i| if i == k { 1.0 - 2.0 * a } else { a } * corners[i][c])
                        .sum::<f64>()
                };
                ([at(0), at(1)], weight)
            })
        })
    };
    let others: Vec<_> = points(second).collect();
    let mut means = [0.0; 2];
    for (x, v) in points(first) {
        for (y, w) in &others {
            let square = (x[0] - y[0]).powi(2) + (x[1] - y[1]).powi(2);
            means = [means[0] + v * w * square, means[1] + v * w * square * square];
        }
    }
    means
}

/// Least and largest distance of two triangles that do not overlap.
fn distances(first: &[[f64; 2]; 3], second: &[[f64; 2]; 3]) -> (f64, f64) {
    let (mut least, mut most) = (f64::INFINITY, 0f64);
    for (of, to) in [(first, second), (second, first)] {
        for x in of {
            for k in 0..3 {
                let (a, b) = (to[k], to[(k + 1) % 3]);
                let (along, from) = ([b[0] - a[0], b[1] - a[1]], [x[0] - a[0], x[1] - a[1]]);
                let t = (along[0] * from[0] + along[1] * from[1])
                    / (along[0] * along[0] + along[1] * along[1]);
                let t = t.clamp(0.0, 1.0);
                least = least.min((from[0] - t * along[0]).hypot(from[1] - t * along[1]));
                most = most.max(from[0].hypot(from[1]));
            }
        }
    }
    (least, most)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Halves of the cells change the bounds towards the constants, which the trial functions give.
    #[test]
    fn finer_cells_have_smaller_bounds() {
        let shape =
            TriangleShape::new([[0.0, 0.0], [0.5f64.sqrt(), 0.0], [0.0, 0.5f64.sqrt()]]).unwrap();
        for (s, constants) in [
            (0.5, [0.476_509 / 2f64.powf(0.25), 0.171_332 / 2f64.powf(0.75)]),
            (0.98, [0.056_636_1 / 2f64.powf(0.49), 0.019_407_5 / 2f64.powf(0.99)]),
        ] {
            let bounds = [4, 8, 16].map(|n| bounds_on(&shape, s, n).unwrap());
            for norm in 0..2 {
                let [coarse, middle, fine] = bounds.map(|bound| bound[norm] / constants[norm]);
                assert!(
                    1.0 < fine && fine < middle && middle < coarse,
                    "{s}: {coarse}, {middle}, {fine}"
                );
            }
        }
    }

    /// On a corner cell D_K bounds φ_A and g − p_K: the shares of the two add up to one at most. For s < 1/12 the corner
    /// cells decide, 2 (64n)^(−2s) > n^(−2s).
    #[test]
    fn no_part_of_a_corner_cell_is_used_twice() {
        let shape =
            TriangleShape::new([[0.0, 0.0], [0.5f64.sqrt(), 0.0], [0.0, 0.5f64.sqrt()]]).unwrap();
        let n = 4;
        let cells = Cells::new(&shape, n);
        for (s, at_corner) in
            [(0.01, true), (0.05, true), (0.08, true), (0.09, false), (0.5, false)]
        {
            let [equal, corner] =
                [1.0 / n as f64, 1.0 / (64 * n) as f64].map(|a: f64| a.powf(2.0 * s));
            let by_hand = if at_corner { 2.0 * corner } else { equal };
            assert!((cells.most(2.0 * s) / by_hand - 1.0).abs() < 1e-12, "{s}");
        }
        // P² is the same in both: the bound of the gradient is at least the share of the corner cells.
        let s = 0.01;
        let areas = DVector::from_vec(cells.areas());
        let weights = cells.weights(s, &Factor::new(s, None));
        let to_constants = &areas * areas.transpose() * (weights.trace() / areas.sum().powi(2));
        let mean = largest(&DMatrix::from_diagonal(&areas), &(weights + to_constants)).unwrap();
        let [slope, _] = bounds_on(&shape, s, n).unwrap();
        assert!(slope * slope >= mean * 2.0 * (256f64).powf(-2.0 * s), "{slope} {mean}");
    }

    #[test]
    fn near_pairs_count_as_often_as_the_series_allows() {
        for s in [0.8, 0.98] {
            let (factor, q) = (Factor::new(s, Some(0.25)), (2.0 * s - 2.0).exp2());
            for r in [0.01, 0.1, 0.24, 0.26, 0.4, 0.49, 0.6, 0.99] {
                let sum: f64 = (0..2000).map(|j| q.powi(j) * factor.at(r * 0.5f64.powi(j))).sum();
                assert!(sum <= (1.0 + 1e-12) / (1.0 - q), "{s}, {r}: {sum}");
            }
        }
    }
}
