//! Rows of the stiffness matrix in double-double, from coordinates, moduli and normals as given.
//!
//! The entries of binary64 are rounded relative to the block of two nodes: on a triangle of aspect ratio 10⁴, or for
//! λ/μ = 10⁹, the entries of the soft direction are differences of the others, and lose as many digits.

use super::form::Form;
use super::frame::Frames;
use crate::mesh::Triangulation;
use qd::Quad;
use std::collections::BTreeMap;

/// A sparse row: the entries by column.
pub(crate) type PreciseRow = BTreeMap<usize, Quad>;

/// The rows of K in the unknowns of the frames, node-major, boundary rows included. Relative error about 1e-30 of
/// each term. Cost: about 10⁴ operations per triangle.
pub(crate) fn precise_stiffness(
    mesh: &Triangulation,
    form: &Form,
    frames: &Frames,
) -> Vec<PreciseRow> {
    let c = form.components();
    let mut rows = vec![PreciseRow::new(); mesh.nodes().len() * c];
    for (t, corners) in mesh.triangles().iter().enumerate() {
        let points = mesh.corners(t).map(|point| point.map(Quad::from));
        let side = |i: usize, j: usize| [points[j][0] - points[i][0], points[j][1] - points[i][1]];
        let (p, q) = (side(0, 1), side(0, 2));
        let doubled = p[0] * q[1] - q[0] * p[1];
        let area = Quad::from(0.5) * doubled;
        let gradients = [0, 1, 2].map(|i: usize| {
            let [x, y] = side((i + 1) % 3, (i + 2) % 3);
            [-y / doubled, x / doubled]
        });
        for i in 0..3 {
            for j in 0..3 {
                let (g, h) = (gradients[i], gradients[j]);
                let product = g[0] * h[0] + g[1] * h[1];
                let block = match (form, form.material(mesh.region(t))) {
                    (Form::Elastic { .. }, Some(material)) => {
                        let (lambda, mu) =
                            (Quad::from(material.lambda()), Quad::from(material.mu()));
                        let entry = |a: usize, b: usize| {
                            let shear = if a == b { mu * product } else { Quad::ZERO };
                            area * (lambda * g[a] * h[b] + mu * g[b] * h[a] + shear)
                        };
                        let block = [[entry(0, 0), entry(0, 1)], [entry(1, 0), entry(1, 1)]];
                        frames.turn_precisely(block, corners[i], corners[j])
                    }
                    (Form::Scalar { reaction }, _) => {
                        let share = Quad::from(if i == j { 6.0 } else { 12.0 });
                        let mass = Quad::from(*reaction) / share;
                        [[area * (product + mass), Quad::ZERO], [Quad::ZERO; 2]]
                    }
                    (Form::Elastic { .. }, None) => [[Quad::ZERO; 2]; 2],
                };
                for a in 0..c {
                    for b in 0..c {
                        *rows[corners[i] * c + a]
                            .entry(corners[j] * c + b)
                            .or_insert(Quad::ZERO) += block[a][b];
                    }
                }
            }
        }
    }
    rows
}
