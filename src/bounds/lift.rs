//! A stress with a load that is constant on each of the three pieces of a triangle.
//!
//! Linear on the pieces, with continuous traction across them, normal traction linear and tangential traction constant
//! on the sides: 27 values, 12 + 6 + 3 equations of full rank. The solution of least values is taken (C. Johnson and
//! B. Mercier, Numer. Math. 30 (1978), for the element).

use super::element::{Linear, Side, pieces, side, traction};
use crate::error::{Error, Result};
use crate::mesh::{Point, doubled_area, middle};
use nalgebra::{DMatrix, DVector};

const EQUATIONS: usize = 21;
const VALUES: usize = 27;

/// The stress with div q = −f_k on piece k.
pub(super) fn lifted(corners: [Point; 3], loads: &[Point; 3]) -> Result<Linear> {
    let centre = middle(corners);
    let unit = (0..3).map(|k| side(corners, k).length).fold(0.0, f64::max);
    // Value c at corner m of piece k.
    let number = |k: usize, m: usize, c: usize| (3 * k + m) * 3 + c;
    let mut matrix = DMatrix::<f64>::zeros(EQUATIONS, VALUES);
    let mut right = DVector::<f64>::zeros(EQUATIONS);
    let mut row = 0;
    let mut units = [[0.0; 3]; 3];
    (0..3).for_each(|c| units[c][c] = 1.0);
    for i in 0..3 {
        let step = [centre[0] - corners[i][0], centre[1] - corners[i][1]];
        let length = step[0].hypot(step[1]);
        let tangent = [step[0] / length, step[1] / length];
        let across = Side { length, tangent, normal: [tangent[1], -tangent[0]] };
        let before = (i + 2) % 3;
        for (own, other) in [(0, 1), (2, 2)] {
            for (c, value) in units.iter().enumerate() {
                let force = traction(2, *value, &across);
                for axis in 0..2 {
                    matrix[(row + axis, number(i, own, c))] += force[axis];
                    matrix[(row + axis, number(before, other, c))] -= force[axis];
                }
            }
            row += 2;
        }
    }
    for (k, piece) in pieces(corners).into_iter().enumerate() {
        let doubled = doubled_area(piece);
        for m in 0..3 {
            let (a, b) = (piece[(m + 1) % 3], piece[(m + 2) % 3]);
            let gradient = [(a[1] - b[1]) / doubled * unit, (b[0] - a[0]) / doubled * unit];
            matrix[(row, number(k, m, 0))] += gradient[0];
            matrix[(row, number(k, m, 2))] += gradient[1];
            matrix[(row + 1, number(k, m, 2))] += gradient[0];
            matrix[(row + 1, number(k, m, 1))] += gradient[1];
        }
        right[row] = -loads[k][0] * unit;
        right[row + 1] = -loads[k][1] * unit;
        row += 2;
    }
    for k in 0..3 {
        let side = side(corners, k);
        for (c, value) in units.iter().enumerate() {
            let tangential = traction(2, *value, &side)[1];
            matrix[(row, number(k, 0, c))] += tangential;
            matrix[(row, number(k, 1, c))] -= tangential;
        }
        row += 1;
    }
    let normal = &matrix * matrix.transpose();
    let factor = normal.cholesky().ok_or_else(|| {
        Error::not_positive_definite("equations of a stress on one triangle", EQUATIONS)
    })?;
    let solution = matrix.transpose() * factor.solve(&right);
    let mut field = [[[0.0; 3]; 3]; 3];
    for (value, found) in
        field.as_flattened_mut().as_flattened_mut().iter_mut().zip(solution.iter())
    {
        *value = *found;
    }
    Ok(field)
}
