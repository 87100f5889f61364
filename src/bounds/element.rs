//! Equilibrated stresses on one triangle, cut into three by its centroid.
//!
//! Elastic: q = (φ_yy, φ_xx, −φ_xy), φ a function of the reduced Hsieh-Clough-Tocher space: C¹,
//! cubic on the three pieces, with linear normal derivative on the sides. On a side with outward
//! normal n and tangent t (the triangle on the left)
//!
//! ```text
//! q_N = n·q n = φ_ss  (linear),      q_T = t·q n = −(∂_n φ)_s  (constant)
//! ```
//!
//! φ has nine degrees of freedom, three of which (φ affine) have no stress: six stresses without
//! load and, on three sides, nine tractions that satisfy the three equations of equilibrium. Three
//! further functions, one for each side, have ∂_n φ = s(1 − s)/2 · length there, no values and no
//! gradients at the vertices: their traction is q_T = s − ½, linear and without resultant.
//!
//! Scalar: q = (ψ_y, −ψ_x), ψ linear: constant, with constant q·n; q·n = s − ½ on one side comes
//! from ψ quadratic.
//!
//! With these three functions as unknowns, [`Traction::Linear`], φ is in the full
//! Hsieh-Clough-Tocher space, ψ is quadratic, and all tractions are linear.
//!
//! Bézier ordinates of φ: J. L. Hsieh's element as in R. W. Clough and J. L. Tocher (1965); P. G.
//! Ciarlet, *The Finite Element Method for Elliptic Problems*, Section 6.1.

use crate::mesh::{Point, doubled_area, middle};

/// A stress (q_xx, q_yy, q_xy), or a flux (q_x, q_y, 0).
pub(super) type Value = [f64; 3];

/// A field that is linear on each of the three pieces: its values at the corners of every piece.
///
/// Piece k has the corners k, k + 1 (modulo 3) of the triangle and its centroid.
pub(super) type Linear = [[Value; 3]; 3];

/// The corners of the three pieces.
pub(super) fn pieces(corners: [Point; 3]) -> [[Point; 3]; 3] {
    let centre = middle(corners);
    [0, 1, 2].map(|k| [corners[k], corners[(k + 1) % 3], centre])
}

/// Fields of one triangle at most.
pub(super) const FIELDS: usize = 9;

const ZERO: Linear = [[[0.0; 3]; 3]; 3];

/// a + factor · b.
pub(super) fn add(a: &mut Linear, factor: f64, b: &Linear) {
    for (a, b) in a.as_flattened_mut().iter_mut().zip(b.as_flattened()) {
        for (a, b) in a.iter_mut().zip(b) {
            *a += factor * b;
        }
    }
}

/// Σ share · corner.
#[inline]
pub(super) fn combine<const N: usize>(shares: &[f64; 3], corners: &[[f64; N]; 3]) -> [f64; N] {
    let mut sum = [0.0; N];
    for c in 0..N {
        sum[c] = shares[0] * corners[0][c] + shares[1] * corners[1][c] + shares[2] * corners[2][c];
    }
    sum
}

/// Length, outward normal and tangent of side k, from corner k to k + 1.
#[derive(Debug, Clone, Copy)]
pub(super) struct Side {
    pub(super) length: f64,
    pub(super) normal: Point,
    pub(super) tangent: Point,
}

pub(super) fn side(corners: [Point; 3], k: usize) -> Side {
    let (a, b) = (corners[k], corners[(k + 1) % 3]);
    let step = [b[0] - a[0], b[1] - a[1]];
    let length = step[0].hypot(step[1]);
    let tangent = [step[0] / length, step[1] / length];
    Side { length, tangent, normal: [tangent[1], -tangent[0]] }
}

/// (q_N, q_T) of a stress on a side, or (q·n, 0) of a flux.
pub(super) fn traction(components: usize, value: Value, side: &Side) -> [f64; 2] {
    let ([nx, ny], [tx, ty]) = (side.normal, side.tangent);
    let [xx, yy, xy] = value;
    if components == 1 {
        return [xx * nx + yy * ny, 0.0];
    }
    let force = [xx * nx + xy * ny, xy * nx + yy * ny];
    [force[0] * nx + force[1] * ny, force[0] * tx + force[1] * ty]
}

/// The tractions of an equilibrated stress on the edges of its mesh.
///
/// ```
/// use signorini::{bounds::Traction, cone::Cone, contact::Body, fem::Form};
/// use signorini::mesh::{SideParts, unit_square};
/// let body = Body::new(unit_square(8, SideParts::HANGING)?, Form::LAPLACE)
///     .load(|[x, _]: [f64; 2]| 1.0 - 3.0 * x);
/// let reduced = body.enclose_with(Cone::Nodal, Traction::Reduced)?;
/// let linear = body.enclose_with(Cone::Nodal, Traction::Linear)?;
/// assert!(linear.error < reduced.error);
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Traction {
    /// Of a stress: linear normally, constant tangentially (reduced Hsieh-Clough-Tocher space of
    /// Airy functions), three unknowns an edge. Of a flux: constant (linear stream function), one
    /// unknown an edge.
    Reduced,
    /// Linear: the full Hsieh-Clough-Tocher space, four unknowns an edge; a quadratic stream
    /// function, two unknowns an edge. Of second order where the exact stress is smooth.
    #[default]
    Linear,
}

/// The fields without load on one triangle.
pub(super) struct Equilibrated {
    /// Six stresses, or two fluxes; with linear tractions also the slopes; last, with a reaction
    /// term, the flux x − x_T, which has the divergence 2.
    fields: [Linear; FIELDS],
    count: usize,
    /// For every side the field with q_T = s − ½ (scalar: q·n = s − ½) there and no traction on the
    /// other sides.
    pub(super) slopes: [Linear; 3],
}

impl Equilibrated {
    /// The fields of a triangle; the slopes only if wanted, otherwise zero.
    pub(super) fn new(
        components: usize,
        tractions: Traction,
        reaction: bool,
        slopes: bool,
        corners: [Point; 3],
    ) -> Self {
        let is_linear = tractions == Traction::Linear;
        let mut found = match components {
            1 => scalar(corners),
            _ => elastic(slopes || is_linear, corners),
        };
        if is_linear {
            found.slopes.iter().for_each(|slope| {
                found.fields[found.count] = *slope;
                found.count += 1;
            });
        }
        if reaction {
            let centre = middle(corners);
            found.fields[found.count] = pieces(corners)
                .map(|piece| piece.map(|p| [p[0] - centre[0], p[1] - centre[1], 0.0]));
            found.count += 1;
        }
        found
    }

    pub(super) fn fields(&self) -> &[Linear] {
        &self.fields[..self.count]
    }

    /// Σ coefficient · field with Σ slope · field of the slope of a side: for a body from the sum
    /// of the Airy functions.
    pub(super) fn sum(
        components: usize,
        tractions: Traction,
        corners: [Point; 3],
        coefficients: &[f64],
        mut slopes: [f64; 3],
    ) -> Linear {
        if components == 2 {
            let (own, more) = coefficients.split_at(6);
            slopes.iter_mut().zip(more).for_each(|(slope, more)| *slope += more);
            let geometry = Geometry::scaled(corners);
            let mut airy = Airy::default();
            own.iter().enumerate().for_each(|(number, value)| *airy.freedom(number) = *value);
            airy.bulge = [0, 1, 2].map(|k| slopes[k] * geometry.bulge(k));
            return geometry.stress(&airy);
        }
        let of_kind = if tractions == Traction::Linear { 5 } else { 2 };
        let has_reaction = coefficients.len() > of_kind;
        let basis = Self::new(components, tractions, has_reaction, true, corners);
        let mut sum = ZERO;
        let fields = basis.fields().iter().zip(coefficients);
        fields.for_each(|(field, value)| add(&mut sum, *value, field));
        basis.slopes.iter().zip(slopes).for_each(|(field, value)| add(&mut sum, value, field));
        sum
    }
}

fn scalar(corners: [Point; 3]) -> Equilibrated {
    let constant = |value: Value| [[value; 3]; 3];
    let doubled = doubled_area(corners);
    // ψ = L λ_a λ_b/2 up to sign has ψ_s = (1 − 2s)/2 on the side from a to b of length L.
    let gradient = |i: usize| {
        let (a, b) = (corners[(i + 1) % 3], corners[(i + 2) % 3]);
        [(a[1] - b[1]) / doubled, (b[0] - a[0]) / doubled]
    };
    let slope = |k: usize| {
        let (next, length) = ((k + 1) % 3, side(corners, k).length);
        let (ga, gb) = (gradient(k), gradient(next));
        let at = |share: [f64; 2]| {
            // (ψ_y, −ψ_x)·n = ψ_s for n = (t_y, −t_x): q·n = s − ½ needs ψ = −L λ_a λ_b/2.
            let g = [0, 1].map(|axis| -0.5 * length * (share[0] * gb[axis] + share[1] * ga[axis]));
            [g[1], -g[0], 0.0]
        };
        let shares =
            |corner: usize| [f64::from(u8::from(corner == k)), f64::from(u8::from(corner == next))];
        [0, 1, 2].map(|piece| [at(shares(piece)), at(shares((piece + 1) % 3)), at([1.0 / 3.0; 2])])
    };
    let mut fields = [ZERO; FIELDS];
    (fields[0], fields[1]) = (constant([1.0, 0.0, 0.0]), constant([0.0, 1.0, 0.0]));
    Equilibrated { fields, count: 2, slopes: [0, 1, 2].map(slope) }
}

/// Values and gradients of φ at the three vertices, and per side the second difference of ∂_n φ.
#[derive(Default, Clone, Copy)]
struct Airy {
    value: [f64; 3],
    gradient: [Point; 3],
    bulge: [f64; 3],
}

impl Airy {
    /// The value or a component of the gradient at corner 1 or 2 that belongs to one of the six
    /// fields.
    fn freedom(&mut self, number: usize) -> &mut f64 {
        let corner = 1 + number / 3;
        match number % 3 {
            0 => &mut self.value[corner],
            axis => &mut self.gradient[corner][axis - 1],
        }
    }
}

fn elastic(with_slopes: bool, corners: [Point; 3]) -> Equilibrated {
    let geometry = Geometry::scaled(corners);
    let mut fields = [ZERO; FIELDS];
    for (number, field) in fields[..6].iter_mut().enumerate() {
        let mut airy = Airy::default();
        *airy.freedom(number) = 1.0;
        *field = geometry.stress(&airy);
    }
    let slopes = [0, 1, 2].map(|k| {
        if !with_slopes {
            return ZERO;
        }
        let mut airy = Airy::default();
        airy.bulge[k] = geometry.bulge(k);
        geometry.stress(&airy)
    });
    Equilibrated { fields, count: 6, slopes }
}

/// The affine geometry of the three pieces.
struct Geometry {
    corners: [Point; 3],
    centre: Point,
    lengths: [f64; 3],
    /// Barycentric coordinates, in piece k, of the unit normal of side k and of the two axes.
    normal: [[f64; 3]; 3],
    axes: [[[f64; 3]; 2]; 3],
}

impl Geometry {
    /// With lengths in units of the longest side; stresses are divided by its square at the end,
    /// which is a factor of the unknowns only. Corner 0 is the origin, where φ and its gradient
    /// vanish.
    fn scaled(corners: [Point; 3]) -> Self {
        let unit = (0..3).map(|k| side(corners, k).length).fold(0.0, f64::max);
        Self::new(corners.map(|p| [(p[0] - corners[0][0]) / unit, (p[1] - corners[0][1]) / unit]))
    }

    /// The bulge with q_T = −(∂_n φ)_s = s − ½ in coordinates without unit: ∂_n φ = l s(1 − s)/2, l
    /// the local length; the second Bézier ordinate of s(1 − s) is ½.
    fn bulge(&self, k: usize) -> f64 {
        0.25 * self.lengths[k]
    }

    fn new(corners: [Point; 3]) -> Self {
        let centre = middle(corners);
        let direction = |piece: [Point; 3], d: Point| {
            let doubled = doubled_area(piece);
            [0, 1, 2].map(|i| {
                let (a, b) = (piece[(i + 1) % 3], piece[(i + 2) % 3]);
                ((a[1] - b[1]) * d[0] + (b[0] - a[0]) * d[1]) / doubled
            })
        };
        let all = pieces(corners);
        Self {
            corners,
            centre,
            lengths: [0, 1, 2].map(|k| side(corners, k).length),
            normal: [0, 1, 2].map(|k| direction(all[k], side(corners, k).normal)),
            axes: [0, 1, 2].map(|k| [[1.0, 0.0], [0.0, 1.0]].map(|axis| direction(all[k], axis))),
        }
    }

    /// (φ_yy, φ_xx, −φ_xy) at the corners of the pieces.
    fn stress(&self, airy: &Airy) -> Linear {
        let along = |i: usize, to: Point| {
            let (from, g) = (self.corners[i], airy.gradient[i]);
            airy.value[i] + (g[0] * (to[0] - from[0]) + g[1] * (to[1] - from[1])) / 3.0
        };
        // Ordinates next to the vertices: towards the centroid, and along the sides from either
        // end.
        let inward = [0, 1, 2].map(|i| along(i, self.centre));
        let forward = [0, 1, 2].map(|i| along(i, self.corners[(i + 1) % 3]));
        let backward = [0, 1, 2].map(|i| along((i + 1) % 3, self.corners[i]));
        // The ordinate in the middle of piece k: ∂_n φ/3 has on side k the ordinates d_0, d_1, d_2.
        let inner = [0, 1, 2].map(|k| {
            let (j, [a, b, c]) = ((k + 1) % 3, self.normal[k]);
            let first = a * airy.value[k] + b * forward[k] + c * inward[k];
            let last = a * backward[k] + b * airy.value[j] + c * inward[j];
            let second = 0.5 * (first + last) + airy.bulge[k] / 3.0;
            (second - a * forward[k] - b * backward[k]) / c
        });
        // C¹ across the segments from the vertices to the centroid, and at the centroid.
        let near = [0, 1, 2].map(|i| (inner[i] + inner[(i + 2) % 3] + inward[i]) / 3.0);
        let centre = (near[0] + near[1] + near[2]) / 3.0;
        let mut stress = ZERO;
        for k in 0..3 {
            let j = (k + 1) % 3;
            let [x, y] = self.axes[k];
            // Second differences at the corners of the piece: symmetric 3 × 3 arrays of ordinates.
            let ordinates = [
                [airy.value[k], forward[k], inward[k], backward[k], inner[k], near[k]],
                [forward[k], backward[k], inner[k], airy.value[j], inward[j], near[j]],
                [inward[k], inner[k], near[k], inward[j], near[j], centre],
            ];
            for m in 0..3 {
                stress[k][m] = [
                    second(&ordinates[m], &y, &y),
                    second(&ordinates[m], &x, &x),
                    -second(&ordinates[m], &x, &y),
                ];
            }
        }
        stress
    }
}

/// The second derivative of a cubic in two directions, at a corner with the given ordinates around
/// it.
#[inline]
fn second([aa, ab, ac, bb, bc, cc]: &[f64; 6], [u, v, w]: &[f64; 3], [p, q, r]: &[f64; 3]) -> f64 {
    6.0 * (u * (aa * p + ab * q + ac * r)
        + v * (ab * p + bb * q + bc * r)
        + w * (ac * p + bc * q + cc * r))
}

#[cfg(test)]
mod tests {
    use super::*;

    const CORNERS: [Point; 3] = [[0.3, -0.2], [1.7, 0.4], [0.1, 1.1]];

    /// Tractions at both ends of a side, from the piece beside it.
    fn ends(components: usize, field: &Linear, k: usize) -> [[f64; 2]; 2] {
        [0, 1].map(|end| traction(components, field[k][end], &side(CORNERS, k)))
    }

    #[test]
    fn stresses_are_in_equilibrium_and_have_the_tractions_of_their_kind() {
        for (components, tractions) in
            [1, 2].into_iter().flat_map(|c| [(c, Traction::Reduced), (c, Traction::Linear)])
        {
            let found = Equilibrated::new(components, tractions, false, true, CORNERS);
            let first_slope = if components == 1 { 2 } else { 6 };
            for (number, field) in found.fields().iter().chain(&found.slopes).enumerate() {
                let mut resultant = [0.0; 3];
                for k in 0..3 {
                    let side = side(CORNERS, k);
                    let [first, last] = ends(components, field, k);
                    let slope = number.checked_sub(first_slope).is_some_and(|j| j % 3 == k);
                    let expected = if slope { 1.0 } else { 0.0 };
                    let of = if components == 1 { 0 } else { 1 };
                    assert!(
                        (last[of] - first[of] - expected).abs() < 1e-13,
                        "{components} {number} {k}"
                    );
                    let (a, b) = (CORNERS[k], CORNERS[(k + 1) % 3]);
                    // Simpson's rule is exact for the moment of a linear traction.
                    for (s, weight) in [(0.0, 1.0 / 6.0), (0.5, 4.0 / 6.0), (1.0, 1.0 / 6.0)] {
                        let [n, t] = [0, 1].map(|c| first[c] + s * (last[c] - first[c]));
                        let force = [0, 1].map(|c| n * side.normal[c] + t * side.tangent[c]);
                        let place = [0, 1].map(|c| a[c] + s * (b[c] - a[c]));
                        let weight = weight * side.length;
                        if components == 1 {
                            resultant[0] += weight * n;
                        } else {
                            resultant[0] += weight * force[0];
                            resultant[1] += weight * force[1];
                            resultant[2] += weight * (place[0] * force[1] - place[1] * force[0]);
                        }
                    }
                }
                assert!(
                    resultant.iter().all(|r| r.abs() < 1e-13),
                    "{components} {number}: {resultant:?}"
                );
            }
        }
    }

    #[test]
    fn tractions_are_continuous_across_the_pieces() {
        let found = Equilibrated::new(2, Traction::Linear, false, true, CORNERS);
        let centre = middle(CORNERS);
        for field in found.fields().iter().chain(&found.slopes) {
            for i in 0..3 {
                let step = [centre[0] - CORNERS[i][0], centre[1] - CORNERS[i][1]];
                let across = Side { length: 1.0, normal: [step[1], -step[0]], tangent: step };
                // Corner i is the first of piece i and the second of piece i − 1.
                for (a, b) in
                    [(field[i][0], field[(i + 2) % 3][1]), (field[i][2], field[(i + 2) % 3][2])]
                {
                    let (a, b) = (traction(2, a, &across), traction(2, b, &across));
                    assert!((a[0] - b[0]).abs() + (a[1] - b[1]).abs() < 1e-13, "{i}: {a:?} {b:?}");
                }
            }
        }
    }
}
