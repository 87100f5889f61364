//! The load that a triangle carries by itself, and the tractions of its sides on the boundary that
//! are not linear.
//!
//! With z the place relative to the centroid and z^⊥ = (−z_y, z_x), a load on a triangle is split
//! into
//!
//! ```text
//! f = f̄ + ω z^⊥ + g,       ∫ g = 0,   ∫ z × g = 0        (scalar: f = f̄ + g)
//! ```
//!
//! f̄ belongs to −(f̄·z) I (scalar: −f̄ z/2). g belongs to stresses without traction,
//!
//! ```text
//! λ_a λ_b p t t^T,     a, b the ends of a side with tangent t, p linear     (scalar: λ_a λ_b p t)
//! ```
//!
//! which are nine, and their divergences all quadratic loads without resultant and moment (J. Hu
//! and S. Zhang, Sci. China Math. 58 (2015)). They are fitted to g by least squares; what is left
//! is oscillation, none for a quadratic f. A moment cannot be carried by a stress that is smooth on
//! the triangle and has linear tractions: ω z^⊥ belongs to a stress that is quadratic on the three
//! pieces, S(Bx + b) = B Ŝ(x) B^T with Ŝ on the unit triangle, div Ŝ = −B⁻¹ R B x, where R turns by
//! a right angle. Three such Ŝ are computed once.
//!
//! A traction on a side is a linear one and λ_a λ_b p(s), p linear, up to degree three. The second
//! part belongs to λ_a λ_b (p_N n n^T + p_T (n t^T + t n^T)), which has no traction on the other
//! sides; its divergence is a load.

use super::element::{Linear, Side, Value, combine, pieces, side, traction};
use super::rule::TriangleRule;
use crate::error::{Error, Result};
use crate::fem::Element;
use crate::mesh::{Point, doubled_area, middle};
use nalgebra::{DMatrix, DVector};
use std::sync::OnceLock;

/// A stress that is quadratic on each piece: its values at the corners of the piece and at the
/// middles of the sides from corner 0 to 1, 1 to 2, 2 to 0.
type Quadratic = [[Value; 6]; 3];

/// The quadratic functions that are 1 at one of the points of [`Quadratic`] and 0 at the others.
fn quadratic_basis([a, b, c]: [f64; 3]) -> [f64; 6] {
    [
        a * (2.0 * a - 1.0),
        b * (2.0 * b - 1.0),
        c * (2.0 * c - 1.0),
        4.0 * a * b,
        4.0 * b * c,
        4.0 * c * a,
    ]
}

/// Stresses without traction: three on each side (scalar: five are enough).
const BUBBLES: usize = 9;
/// A load whose values on a triangle agree to this multiple of the largest one is constant there.
const CONSTANT: f64 = 1e-14;
/// Singular values below this are 0: the equations of the unit stresses depend on each other.
const RANK: f64 = 1e-10;
/// Largest residual of the equations of the unit stresses, relative to the largest load.
const SOLVED: f64 = 1e-12;
/// c_0 and c_1 of the linear factor c_0 + c_1 r on a side, r = λ_b − λ_a from −1 to 1.
type Factor = [f64; 2];

/// The factor p of λ_a λ_b on one side, normal and tangential.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Curved {
    pub(super) normal: Factor,
    pub(super) tangential: Factor,
}

impl Curved {
    pub(super) fn is_none(&self) -> bool {
        self.normal.iter().chain(&self.tangential).all(|c| *c == 0.0)
    }
}

/// The stress of one triangle.
#[derive(Debug, Clone)]
pub(super) struct Own {
    /// That of f̄.
    pub(super) field: Linear,
    /// That of ω z^⊥.
    turn: Option<Box<Quadratic>>,
    bubbles: [f64; BUBBLES],
    /// By number of the side.
    curved: [Option<Curved>; 3],
    components: usize,
    corners: [Point; 3],
    /// The longest side.
    size: f64,
    /// ‖what is left of the load‖ in L².
    pub(super) left_over: f64,
}

impl Own {
    /// Whether the stress is linear on the pieces.
    pub(super) fn is_linear(&self) -> bool {
        self.turn.is_none()
            && self.bubbles.iter().all(|factor| *factor == 0.0)
            && self.curved.iter().all(Option::is_none)
    }

    /// The part that is not linear on the pieces, at a point of a piece.
    pub(super) fn at(&self, piece: usize, shares: [f64; 3]) -> Value {
        let mut sum = [0.0; 3];
        if let Some(turn) = &self.turn {
            for (weight, value) in quadratic_basis(shares).iter().zip(&turn[piece]) {
                (0..3).for_each(|i| sum[i] += weight * value[i]);
            }
        }
        let mut whole = [shares[2] / 3.0; 3];
        whole[piece] += shares[0];
        whole[(piece + 1) % 3] += shares[1];
        for (i, &factor) in self.bubbles.iter().enumerate() {
            if factor != 0.0 {
                let (product, _, step) = bubble(self.components, self.corners, self.size, i, whole);
                let factor = factor * product;
                let value = match self.components {
                    1 => [step[0], step[1], 0.0],
                    _ => [step[0] * step[0], step[1] * step[1], step[0] * step[1]],
                };
                (0..3).for_each(|c| sum[c] += factor * value[c]);
            }
        }
        for (k, curved) in self.curved.iter().enumerate() {
            let Some(curved) = curved else { continue };
            let Side { normal: n, tangent: t, .. } = side(self.corners, k);
            let (la, lb) = (whole[k], whole[(k + 1) % 3]);
            let of = |[c0, c1]: Factor| la * lb * (c0 + c1 * (lb - la));
            let (p, q) = (of(curved.normal), of(curved.tangential));
            let value = match self.components {
                1 => [p * n[0], p * n[1], 0.0],
                _ => [
                    p * n[0] * n[0] + 2.0 * q * n[0] * t[0],
                    p * n[1] * n[1] + 2.0 * q * n[1] * t[1],
                    p * n[0] * n[1] + q * (n[0] * t[1] + n[1] * t[0]),
                ],
            };
            (0..3).for_each(|c| sum[c] += value[c]);
        }
        sum
    }

    /// Tractions of the part for ω z^⊥ at both ends of a side, where they are linear.
    pub(super) fn ends(&self, k: usize) -> [[f64; 2]; 2] {
        let side = side(self.corners, k);
        self.turn.as_ref().map_or([[0.0; 2]; 2], |turn| {
            [0, 1].map(|end| traction(self.components, turn[k][end], &side))
        })
    }
}

/// λ_a λ_b p at a point, its derivative along b − a, and b − a in units of the longest side.
fn bubble(
    components: usize,
    corners: [Point; 3],
    size: f64,
    number: usize,
    whole: [f64; 3],
) -> (f64, f64, Point) {
    let k = number % 3;
    let j = (k + 1) % 3;
    let step = [0, 1].map(|axis| (corners[j][axis] - corners[k][axis]) / size);
    let (la, lb) = (whole[k], whole[j]);
    // Along b − a: λ_a' = −1, λ_b' = 1, and the third coordinate is constant.
    let (p, slope) = match number / 3 {
        0 => (1.0, 0.0),
        1 => (lb - la, 2.0),
        _ if components == 1 => return (0.0, 0.0, step),
        _ => (1.0 - la - lb, 0.0),
    };
    (la * lb * p, (la - lb) * p + la * lb * slope, step)
}

impl Own {
    /// The stress of a load on the triangle, if it is not left to a common stress, and of the parts
    /// of degree two and three of the tractions of its sides; `None` if there is neither.
    ///
    /// # Errors
    /// Those of the load;
    /// [`ToolkitError::NotPositiveDefinite`](crate::ToolkitError::NotPositiveDefinite) with the
    /// `number` of a triangle without area.
    pub(super) fn new(
        components: usize,
        (number, corners): (usize, [Point; 3]),
        curved: [Option<Curved>; 3],
        load: impl Fn(Point) -> Result<Point>,
        rule: &TriangleRule,
    ) -> Result<Option<Self>> {
        let (centre, element) = (middle(corners), Element::new(corners));
        let size = (0..3).map(|k| side(corners, k).length).fold(0.0, f64::max);
        let area = 0.5 * doubled_area(corners);
        // Places relative to the centroid in units of the size, weights in units of the area, so
        // that no square underflows.
        let mut values: Vec<(Point, [f64; 3], f64, Point)> = Vec::new();
        for (k, piece) in pieces(corners).into_iter().enumerate() {
            for (shares, weight) in &rule.points {
                let point = combine(shares, &piece);
                let mut whole = [shares[2] / 3.0; 3];
                whole[k] += shares[0];
                whole[(k + 1) % 3] += shares[1];
                let mut value = load(point)?;
                for (k, curved) in curved.iter().enumerate() {
                    if let Some(curved) = curved {
                        let more = divergence_of(
                            components,
                            &side(corners, k),
                            k,
                            curved,
                            &element,
                            whole,
                        );
                        value = [value[0] + more[0], value[1] + more[1]];
                    }
                }
                let z = [0, 1].map(|axis| (point[axis] - centre[axis]) / size);
                values.push((z, whole, weight / 3.0, value));
            }
        }
        let largest = values.iter().flat_map(|(.., f)| f).fold(0.0, |m: f64, v| m.max(v.abs()));
        let mut own = Own {
            field: [[[0.0; 3]; 3]; 3],
            turn: None,
            bubbles: [0.0; BUBBLES],
            curved,
            components,
            corners,
            size,
            left_over: 0.0,
        };
        if largest == 0.0 {
            return Ok(curved.iter().any(Option::is_some).then_some(own));
        }
        let mean = [0, 1].map(|c| values.iter().map(|(.., w, f)| w * f[c]).sum::<f64>());
        own.field = pieces(corners).map(|piece| {
            piece.map(|p| {
                let z = [p[0] - centre[0], p[1] - centre[1]];
                match components {
                    // div(−f̄ z/2) = −f̄, with constant normal component on every side.
                    1 => [-0.5 * mean[0] * z[0], -0.5 * mean[0] * z[1], 0.0],
                    // div(−(f̄·z) I) = −f̄, with linear normal and no tangential traction.
                    _ => {
                        let pressure = -(mean[0] * z[0] + mean[1] * z[1]);
                        [pressure, pressure, 0.0]
                    }
                }
            })
        });
        values.iter_mut().for_each(|(.., f)| *f = [f[0] - mean[0], f[1] - mean[1]]);
        let rest = |values: &[(Point, [f64; 3], f64, Point)]| {
            values.iter().flat_map(|(.., f)| f).fold(0.0, |m: f64, v| m.max(v.abs()))
        };
        if rest(&values) <= CONSTANT * largest {
            return Ok(Some(own));
        }
        if components == 2 {
            let square = |z: &Point| z[0] * z[0] + z[1] * z[1];
            let inertia: f64 = values.iter().map(|(z, _, w, _)| w * square(z)).sum();
            let moment: f64 =
                values.iter().map(|(z, _, w, f)| w * (z[0] * f[1] - z[1] * f[0])).sum();
            // ω in units of 1/size.
            let turn = moment / inertia;
            values
                .iter_mut()
                .for_each(|(z, _, _, f)| *f = [f[0] + turn * z[1], f[1] - turn * z[0]]);
            if turn.abs() > CONSTANT * largest {
                own.turn = Some(Box::new(turned(corners, size, turn * size)?));
            }
        }
        let count = if components == 1 { 5 } else { BUBBLES };
        // Scalar: two of the three with p = 1 and those with p = λ_b − λ_a.
        let numbers: Vec<usize> =
            if components == 1 { vec![0, 1, 3, 4, 5] } else { (0..BUBBLES).collect() };
        // Divergences in units of 1/size, at all points.
        let divergence = |number: usize, whole: [f64; 3]| -> Point {
            let (_, along, step) = bubble(components, corners, size, number, whole);
            // t·∇φ with t = (b − a)/size is `along`/size.
            if components == 1 { [along, 0.0] } else { [along * step[0], along * step[1]] }
        };
        let all: Vec<Vec<Point>> = numbers
            .iter()
            .map(|&number| values.iter().map(|(_, whole, ..)| divergence(number, *whole)).collect())
            .collect();
        let product = |a: &Point, b: &Point| a[0] * b[0] + a[1] * b[1];
        let mut normal = DMatrix::<f64>::zeros(count, count);
        let mut right = DVector::<f64>::zeros(count);
        for i in 0..count {
            for j in 0..count {
                normal[(i, j)] = values
                    .iter()
                    .enumerate()
                    .map(|(k, v)| v.2 * product(&all[i][k], &all[j][k]))
                    .sum();
            }
            right[i] = -values
                .iter()
                .enumerate()
                .map(|(k, v)| v.2 * product(&all[i][k], &v.3))
                .sum::<f64>();
        }
        let factor = normal.cholesky().ok_or_else(|| {
            Error::not_positive_definite("loads without resultant on one triangle", number)
        })?;
        let found = factor.solve(&right);
        for (i, &number) in numbers.iter().enumerate() {
            own.bubbles[number] = size * found[i];
            for (value, more) in values.iter_mut().zip(&all[i]) {
                (0..2).for_each(|c| value.3[c] += found[i] * more[c]);
            }
        }
        if rest(&values) > CONSTANT * largest {
            let sum: f64 = values
                .iter()
                .map(|(.., w, f)| w * ((f[0] / largest).powi(2) + (f[1] / largest).powi(2)))
                .sum();
            own.left_over = largest * area.sqrt() * sum.sqrt();
        }
        Ok(Some(own))
    }
}

/// The divergence of the stress of a curved traction on side k.
fn divergence_of(
    components: usize,
    &Side { normal: n, tangent, .. }: &Side,
    k: usize,
    curved: &Curved,
    element: &Element,
    whole: [f64; 3],
) -> Point {
    let j = (k + 1) % 3;
    let (la, lb) = (whole[k], whole[j]);
    let (ga, gb) = (element.gradients[k], element.gradients[j]);
    let gradient = |[c0, c1]: Factor| {
        let p = c0 + c1 * (lb - la);
        [0, 1]
            .map(|axis| p * (la * gb[axis] + lb * ga[axis]) + la * lb * c1 * (gb[axis] - ga[axis]))
    };
    let along = |g: Point, d: Point| g[0] * d[0] + g[1] * d[1];
    let (p, q) = (gradient(curved.normal), gradient(curved.tangential));
    if components == 1 {
        return [along(p, n), 0.0];
    }
    let (across, beside) = (along(p, n) + along(q, tangent), along(q, n));
    [0, 1].map(|axis| across * n[axis] + beside * tangent[axis])
}

/// The stress of the load `turn`/size² · z^⊥.
fn turned(corners: [Point; 3], size: f64, turn: f64) -> Result<Quadratic> {
    let units = unit_stresses()?;
    let b = [0, 1].map(|axis| [1, 2].map(|k| (corners[k][axis] - corners[0][axis]) / size));
    let determinant = b[0][0] * b[1][1] - b[0][1] * b[1][0];
    // R B, and its product with B⁻¹ from the left.
    let rb = [[-b[1][0], -b[1][1]], [b[0][0], b[0][1]]];
    let m = [0, 1].map(|j| {
        [
            (b[1][1] * rb[0][j] - b[0][1] * rb[1][j]) / determinant,
            (b[0][0] * rb[1][j] - b[1][0] * rb[0][j]) / determinant,
        ]
    });
    // m[j][i] is the entry in row i and column j; its trace vanishes.
    let factors = [m[0][0], m[1][0], m[0][1]];
    let mut found = [[[0.0; 3]; 6]; 3];
    for k in 0..3 {
        for node in 0..6 {
            let mut s = [0.0; 3];
            for (factor, unit) in factors.iter().zip(units) {
                (0..3).for_each(|c| s[c] += turn * factor * unit[k][node][c]);
            }
            // B Ŝ B^T.
            let full = [[s[0], s[2]], [s[2], s[1]]];
            let entry = |i: usize, j: usize| -> f64 {
                (0..2)
                    .flat_map(|p| (0..2).map(move |q| (p, q)))
                    .map(|(p, q)| b[i][p] * full[p][q] * b[j][q])
                    .sum()
            };
            found[k][node] = [entry(0, 0), entry(1, 1), entry(0, 1)];
        }
    }
    Ok(found)
}

/// Stresses on the triangle (0, 0), (1, 0), (0, 1) with linear tractions and the loads M x, x
/// relative to the centroid, M = diag(1, −1), the unit in row 0 and column 1, the unit in row 1 and
/// column 0; of least values.
fn unit_stresses() -> Result<&'static [Quadratic; 3]> {
    static STRESSES: OnceLock<Option<[Quadratic; 3]>> = OnceLock::new();
    let found = STRESSES.get_or_init(solve_unit_stresses);
    found.as_ref().ok_or_else(|| {
        Error::not_positive_definite("equations of a stress on the unit triangle", 0)
    })
}

fn solve_unit_stresses() -> Option<[Quadratic; 3]> {
    const CORNERS: [Point; 3] = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
    const ENDS: [[usize; 2]; 3] = [[0, 1], [1, 2], [2, 0]];
    let number = |k: usize, node: usize, c: usize| (6 * k + node) * 3 + c;
    let centre = middle(CORNERS);
    let mut rows: Vec<Vec<f64>> = Vec::new();
    let mut right: Vec<[f64; 3]> = Vec::new();
    let force = |[nx, ny]: Point| [[nx, 0.0, ny], [0.0, ny, nx]];
    for i in 0..3 {
        // Continuous traction across the segment from corner i, the first of piece i and the second
        // of the one before.
        let step = [centre[0] - CORNERS[i][0], centre[1] - CORNERS[i][1]];
        for (own, other) in [(0, 1), (2, 2), (5, 4)] {
            for weights in force([step[1], -step[0]]) {
                let mut row = vec![0.0; 54];
                for c in 0..3 {
                    row[number(i, own, c)] += weights[c];
                    row[number((i + 2) % 3, other, c)] -= weights[c];
                }
                rows.push(row);
                right.push([0.0; 3]);
            }
        }
        // Linear traction on side i: no second difference.
        for weights in force(side(CORNERS, i).normal) {
            let mut row = vec![0.0; 54];
            for (node, factor) in [(0, 1.0), (1, 1.0), (3, -2.0)] {
                (0..3).for_each(|c| row[number(i, node, c)] += factor * weights[c]);
            }
            rows.push(row);
            right.push([0.0; 3]);
        }
    }
    for (k, piece) in pieces(CORNERS).into_iter().enumerate() {
        let element = Element::new(piece);
        for corner in 0..3 {
            let mut gradients = [[0.0; 2]; 6];
            for axis in 0..2 {
                let of = |m: usize| element.gradients[m][axis];
                for m in 0..3 {
                    gradients[m][axis] = if m == corner { 3.0 } else { -1.0 } * of(m);
                    let [a, b] = ENDS[m];
                    let at = |m: usize| if m == corner { 1.0 } else { 0.0 };
                    gradients[3 + m][axis] = 4.0 * (at(a) * of(b) + at(b) * of(a));
                }
            }
            let z = [piece[corner][0] - centre[0], piece[corner][1] - centre[1]];
            for (axis, loads) in [[z[0], z[1], 0.0], [-z[1], 0.0, z[0]]].into_iter().enumerate() {
                let mut row = vec![0.0; 54];
                for (node, g) in gradients.iter().enumerate() {
                    row[number(k, node, axis)] += g[axis];
                    row[number(k, node, 2)] += g[1 - axis];
                }
                rows.push(row);
                right.push(loads.map(|load| -load));
            }
        }
    }
    let matrix = DMatrix::from_fn(rows.len(), 54, |i, j| rows[i][j]);
    let loads = DMatrix::from_fn(right.len(), 3, |i, which| right[i][which]);
    let solved = least_solutions(&matrix, &loads)?;
    let mut found = [[[[0.0; 3]; 6]; 3]; 3];
    for (which, stress) in found.iter_mut().enumerate() {
        for (k, node, c) in
            (0..3).flat_map(|k| (0..6).flat_map(move |n| (0..3).map(move |c| (k, n, c))))
        {
            stress[k][node][c] = solved[(number(k, node, c), which)];
        }
    }
    Some(found)
}

/// The solutions X of least norm of A X = B, or `None` if A X − B exceeds [`SOLVED`]: then the
/// equations contradict each other, or singular values were taken for 0.
fn least_solutions(matrix: &DMatrix<f64>, right: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    let found = matrix.clone().svd(true, true).solve(right, RANK).ok()?;
    let residual = (matrix * &found - right).amax();
    (residual <= SOLVED * right.amax()).then_some(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equations_that_are_not_solved_are_refused() {
        let matrix = DMatrix::from_row_slice(3, 2, &[1.0, 0.0, 0.0, 1.0, 1.0, 1.0]);
        let [right, wrong] = [3.0, 3.1].map(|sum| DMatrix::from_row_slice(3, 1, &[1.0, 2.0, sum]));
        let found = least_solutions(&matrix, &right).unwrap();
        assert!((found[0] - 1.0).abs() < 1e-14 && (found[1] - 2.0).abs() < 1e-14);
        assert!(least_solutions(&matrix, &wrong).is_none());
        // Singular values below `RANK` count as 0, and their equations do not hold.
        let flat = DMatrix::from_row_slice(2, 2, &[1.0, 0.0, 0.0, 0.1 * RANK]);
        assert!(least_solutions(&flat, &DMatrix::from_row_slice(2, 1, &[1.0, 1.0])).is_none());
    }

    /// Centred differences of a quadratic are its derivatives: div S + M x = 0 in every piece, and
    /// no traction jumps.
    #[test]
    fn unit_stresses_have_their_loads() {
        let corners: [Point; 3] = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
        let centre = middle(corners);
        let loads = [|z: Point| [z[0], -z[1]], |z: Point| [z[1], 0.0], |z: Point| [0.0, z[0]]];
        for (stress, load) in unit_stresses().unwrap().iter().zip(loads) {
            for (k, piece) in pieces(corners).into_iter().enumerate() {
                let element = Element::new(piece);
                let value = |point: Point| {
                    let weights = quadratic_basis(element.barycentric(piece, point));
                    let entry = |i: usize| -> f64 {
                        weights.iter().zip(&stress[k]).map(|(w, value)| w * value[i]).sum()
                    };
                    [entry(0), entry(1), entry(2)]
                };
                let step = 1e-3;
                for shares in [[0.6, 0.3, 0.1], [0.2, 0.2, 0.6]] {
                    let [x, y] = combine(&shares, &piece);
                    let along = |axis: usize| {
                        let by = [[step, 0.0], [0.0, step]][axis];
                        let (last, first) =
                            (value([x + by[0], y + by[1]]), value([x - by[0], y - by[1]]));
                        [0, 1, 2].map(|c| (last[c] - first[c]) / (2.0 * step))
                    };
                    let ([sx, _, tx], [_, sy, ty]) = (along(0), along(1));
                    let [fx, fy] = load([x - centre[0], y - centre[1]]);
                    assert!((sx + ty + fx).abs() < 1e-12, "{k}: {sx} {ty} {fx}");
                    assert!((tx + sy + fy).abs() < 1e-12, "{k}: {tx} {sy} {fy}");
                }
                let (next, other) = ((k + 1) % 3, &stress[(k + 1) % 3]);
                // Piece k and the next one meet on the segment from corner k + 1 to the centroid.
                let normal = [corners[next][1] - centre[1], centre[0] - corners[next][0]];
                for (own, beside) in [(1, 0), (2, 2), (4, 5)] {
                    let force = |[xx, yy, xy]: Value| {
                        [xx * normal[0] + xy * normal[1], xy * normal[0] + yy * normal[1]]
                    };
                    let (own, beside) = (force(stress[k][own]), force(other[beside]));
                    assert!((own[0] - beside[0]).abs().max((own[1] - beside[1]).abs()) < 1e-12);
                }
            }
        }
    }
}
