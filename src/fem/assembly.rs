//! The stiffness matrix, assembled row by row.
//!
//! Every node collects the contributions of its own triangles, so that rows are independent and tasks write to
//! disjoint memory. The two unknowns of a node are Cartesian, or the tangential and the normal displacement (u_T,
//! u_N) at a straight contact edge: [`Frame`]. Cost: O(triangles), about 400 operations per triangle.

use super::form::{Element, Form};
#[cfg(test)]
use super::frame::Frame;
use super::frame::Frames;
use super::matrix::BlockMatrix;
use crate::mesh::Triangulation;
use crate::numeric::parallel;

struct Incidence {
    offsets: Vec<usize>,
    triangles: Vec<u32>,
}

impl Incidence {
    fn of(mesh: &Triangulation) -> Self {
        let count = mesh.nodes().len();
        let mut offsets = vec![0; count + 1];
        mesh.triangles().iter().flatten().for_each(|&node| offsets[node + 1] += 1);
        (0..count).for_each(|i| offsets[i + 1] += offsets[i]);
        let mut next = offsets.clone();
        let mut triangles = vec![0; offsets[count]];
        for (t, corners) in mesh.triangles().iter().enumerate() {
            for &node in corners {
                triangles[next[node]] = t as u32;
                next[node] += 1;
            }
        }
        Self { offsets, triangles }
    }

    fn around(&self, node: usize) -> impl Iterator<Item = usize> + '_ {
        self.triangles[self.offsets[node]..self.offsets[node + 1]].iter().map(|&t| t as usize)
    }
}

/// Rows assembled by one task: enough to amortise the overhead of a task, few enough for many tasks.
const CHUNK: usize = 8192;

/// Some consecutive rows: number of blocks per row, columns, values.
#[derive(Default)]
struct Rows {
    lengths: Vec<usize>,
    columns: Vec<u32>,
    values: Vec<f64>,
}

/// The stiffness matrix of `form` in the unknowns of `frame`, boundary rows included.
///
/// K_ij = a(φ_j, φ_i), symmetric, node-major, without boundary conditions: constants lie in the kernel of the Laplacian,
/// rigid motions in that of elasticity. The matrix does not change when the mesh is scaled (two dimensions, no reaction term).
#[cfg(test)]
pub(crate) fn stiffness(mesh: &Triangulation, form: &Form, frame: &Frame) -> BlockMatrix {
    stiffness_in(mesh, form, &Frames::all(*frame))
}

/// The same stiffness matrix with a frame for every node.
pub(crate) fn stiffness_in(mesh: &Triangulation, form: &Form, frames: &Frames) -> BlockMatrix {
    let incidence = Incidence::of(mesh);
    let count = mesh.nodes().len();
    let parts: Vec<Rows> = parallel::map(count.div_ceil(CHUNK), &|chunk| {
        let mut rows = Rows::default();
        for node in chunk * CHUNK..count.min((chunk + 1) * CHUNK) {
            push_row(&mut rows, node, &incidence, mesh, form, frames);
        }
        rows
    });
    let mut offsets = vec![0];
    let mut all = Rows::default();
    all.columns.reserve(parts.iter().map(|part| part.columns.len()).sum());
    all.values.reserve(parts.iter().map(|part| part.values.len()).sum());
    for part in parts {
        for length in part.lengths {
            offsets.push(offsets[offsets.len() - 1] + length);
        }
        all.columns.extend(part.columns);
        all.values.extend(part.values);
    }
    BlockMatrix::new(form.components(), offsets, all.columns, all.values)
}

fn push_row(
    rows: &mut Rows,
    node: usize,
    incidence: &Incidence,
    mesh: &Triangulation,
    form: &Form,
    frames: &Frames,
) {
    let c = form.components();
    let start = rows.columns.len();
    let corners = incidence.around(node).flat_map(|t| mesh.triangles()[t]);
    rows.columns.extend(corners.map(|corner| corner as u32));
    rows.columns[start..].sort_unstable();
    let mut kept = start;
    for k in start..rows.columns.len() {
        if kept == start || rows.columns[kept - 1] != rows.columns[k] {
            rows.columns[kept] = rows.columns[k];
            kept += 1;
        }
    }
    rows.columns.truncate(kept);
    rows.lengths.push(kept - start);
    let base = start * c * c;
    rows.values.resize(kept * c * c, 0.0);
    for t in incidence.around(node) {
        let corners = mesh.triangles()[t];
        let element = Element::new(mesh.corners(t));
        let i = (0..3).find(|&i| corners[i] == node).unwrap_or(0);
        for j in 0..3 {
            let block = element.block(form, mesh.region(t), i, j);
            let at =
                rows.columns[start..].partition_point(|&column| (column as usize) < corners[j]);
            let block = if c == 1 { block } else { frames.turn_block(block, node, corners[j]) };
            for a in 0..c {
                for b in 0..c {
                    rows.values[base + (at * c + a) * c + b] += block[a][b];
                }
            }
        }
    }
}
