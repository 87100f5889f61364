//! The best equilibrated stress: the dual problem on the same triangulation, in hybrid form.
//!
//! Among the stresses q = q_p + q_T (q_p exact for the load, q_T of module `element` on every
//! triangle) with continuous traction, given traction on Γ_N, q_T = 0 and q_N ≤ 0 on Γ_C, the one
//! of least ½∫ q : 𝒜⁻¹q − ∫_{Γ_D} q n·u_D − ∫_{Γ_C} q_N g. Continuity is required by multipliers on
//! the edges, which are weighted means of a displacement:
//!
//! ```text
//! per edge of length L:   (2/L) ∫ u_N (1 − s),  (2/L) ∫ u_N s,  (1/L) ∫ u_T
//! ```
//!
//! paired with the forces q_N(0) L/2, q_N(1) L/2, q_T L (linear q_T: (2/L) ∫ u_T (1 − s), (2/L) ∫
//! u_T s with q_T(0) L/2, q_T(1) L/2; a flux: those of u with q·n, or (1/L) ∫ u with q·n L if it is
//! constant). On a triangle with fields s_i, C_ij = ∫ s_i : 𝒜⁻¹s_j, forces N x of Σ x_i s_i and
//! known part (c, t₀), least energy for given multipliers λ is at x = C⁻¹(Nᵀλ − c), so that the
//! edges have the equations
//!
//! ```text
//! Σ_T (N C⁻¹Nᵀ λ − N C⁻¹c + t₀) = given forces,
//! λ ≤ (2/L) ∫ g (1 − s), (2/L) ∫ g s  beside  −q_N ≥ 0  on Γ_C
//! ```
//!
//! with a positive definite matrix: a contact problem with bounds as its only constraints, solved
//! as the primal one, by elimination to the contact unknowns and an active set. Its condition
//! number is that of the primal problem, where the equations of an Airy function would have the
//! square; holes and several clamped parts need no further fields. The stresses are those of an
//! Airy function in the reduced or full Hsieh-Clough-Tocher space (scalar: of a linear or quadratic
//! stream function), locally, and the minimum is the same.

use super::element::{Equilibrated, Linear, Side, Traction, add, combine, side, traction};
use super::setting::{Border, OF_EQUATIONS, Sample, Setting, SideOf};
use crate::cone::{Cone, ContactSet, Ends};
use crate::contact::edge::{EdgeProblem, solve_on_edge};
use crate::error::{Error, Result};
use crate::fem::{BlockMatrix, Condensation};
use crate::mesh::{Part, Point, Triangulation, distance, doubled_area};
use crate::numeric::parallel;
use crate::numeric::scale::careful_dot;

/// Values of a field at the corners of its pieces, and with the sums over each piece.
const NODAL: usize = 27;
const TERMS: usize = NODAL + 9;
/// Edges of one task of the assembly.
const CHUNK: usize = 4096;
/// Edges that are eliminated at once. An edge has four neighbours: of the sizes from 8 to 60, 12
/// takes the least time and memory.
const LEAF: usize = 12;

/// The equations of one triangle with F fields at most and R forces, for C = L Lᵀ.
struct Local<const F: usize, const R: usize> {
    /// Number of fields.
    count: usize,
    /// L, lower triangular.
    root: [[f64; F]; F],
    /// W = L⁻¹ Nᵀ, N the forces of every field, and w = L⁻¹ c: Lᵀ x = W λ − w.
    forces: [[f64; R]; F],
    offset: [f64; F],
    /// t₀, the forces of the known field.
    known_forces: [f64; R],
    left_over: f64,
}

impl<const F: usize, const R: usize> Local<F, R> {
    /// Entry of N C⁻¹ Nᵀ = Wᵀ W.
    fn stiffness(&self, row: usize, column: usize) -> f64 {
        (0..self.count).map(|i| self.forces[i][row] * self.forces[i][column]).sum()
    }

    /// N C⁻¹ c − t₀ = Wᵀ w − t₀.
    fn load(&self, row: usize) -> f64 {
        (0..self.count).map(|i| self.forces[i][row] * self.offset[i]).sum::<f64>()
            - self.known_forces[row]
    }
}

/// The stress of least complementary energy.
#[derive(Debug, Clone)]
pub(super) struct Dual {
    /// q − q_p on every triangle.
    pub(super) fields: Vec<Linear>,
    /// osc on every triangle.
    pub(super) oscillation: Vec<f64>,
    /// −q_N ≥ 0 at both ends of every contact segment (its linear part), by number of the border; 0
    /// elsewhere.
    pub(super) pressure: Vec<[f64; 2]>,
    /// Energy norm of the stress that would correct the residual left by rounding.
    pub(super) rounding: f64,
    /// Steps of the active set.
    pub(super) steps: usize,
}

impl Setting<'_, '_> {
    fn basis(&self, t: usize) -> Equilibrated {
        let is_inside = self.sides[t].iter().all(|side| self.border_of[side.edge].is_none());
        let is_plain = is_inside && self.own_of(t).is_none();
        let (reaction, corners) = (self.reaction() > 0.0, self.mesh.corners(t));
        Equilibrated::new(self.components, self.tractions, reaction, !is_plain, corners)
    }

    /// Forces of a field on the sides, in the order and orientation of the edges.
    fn forces<const R: usize>(
        &self,
        field: &Linear,
        sides: &[Side; 3],
        of: &[SideOf; 3],
    ) -> [f64; R] {
        let ends = [0, 1, 2]
            .map(|k| [0, 1].map(|end| traction(self.components, field[k][end], &sides[k])));
        self.forces_of(&ends, sides, of)
    }

    /// Forces of linear tractions, given at both ends of the sides.
    fn forces_of<const R: usize>(
        &self,
        ends: &[[[f64; 2]; 2]; 3],
        sides: &[Side; 3],
        of: &[SideOf; 3],
    ) -> [f64; R] {
        let c = R / 3;
        let mut forces = [0.0; R];
        for k in 0..3 {
            let ends = ends[k];
            let [start, end] = if of[k].flipped { [ends[1], ends[0]] } else { ends };
            // q_N and q_T have the same sign on both sides of an edge, the force has not; a flux
            // has opposite signs.
            let is_against = of[k].flipped && self.components == 2;
            let half = if is_against { -0.5 } else { 0.5 } * sides[k].length;
            let own = &mut forces[c * k..c * (k + 1)];
            match c {
                1 => own[0] = half * (start[0] + end[0]),
                _ => (own[0], own[1]) = (half * start[0], half * end[0]),
            }
            match c {
                3 => own[2] = half * (start[1] + end[1]),
                4 => (own[2], own[3]) = (half * start[1], half * end[1]),
                _ => {}
            }
        }
        forces
    }

    fn local<const F: usize, const R: usize>(&self, t: usize) -> Result<Local<F, R>> {
        let basis = self.basis(t);
        let known = self.known_field(t, &basis.slopes);
        let (corners, root) = (self.mesh.corners(t), self.compliance_root(t));
        let fields = basis.fields();
        let count = fields.len();
        let area = 0.5 * doubled_area(corners);
        // ∫ l m = |piece|/12 (Σ l_k m_k + Σ l_k Σ m_k) for linear l, m; a piece is a third of the
        // triangle.
        let mut rooted = [[0.0; TERMS]; F];
        for (terms, field) in rooted.iter_mut().zip(fields) {
            let (values, totals) = terms.split_at_mut(NODAL);
            for (k, piece) in field.iter().enumerate() {
                for (m, value) in piece.iter().enumerate() {
                    let value = root(value);
                    for c in 0..3 {
                        values[9 * k + 3 * m + c] = value[c];
                        totals[3 * k + c] += value[c];
                    }
                }
            }
        }
        let mut compliance = [[0.0; F]; F];
        for i in 0..count {
            for j in 0..=i {
                compliance[i][j] = area / 36.0 * dot(&rooted[i], &rooted[j]);
            }
        }
        // ∫ of the known stress against the barycentric coordinates of the pieces.
        let mut moments: Linear = [[[0.0; 3]; 3]; 3];
        let samples = self.samples(t, OF_EQUATIONS);
        for Sample { piece, shares, weight, exact, .. } in &samples {
            let own = combine(shares, &known[*piece]);
            for c in 0..3 {
                let value = weight * (own[c] + exact[c]);
                (0..3).for_each(|m| moments[*piece][m][c] += shares[m] * value);
            }
        }
        let mut against = [0.0; TERMS];
        let terms = against.as_chunks_mut::<3>().0;
        terms.iter_mut().zip(moments.as_flattened()).for_each(|(term, value)| *term = root(value));
        let mut shift: [f64; F] = std::array::from_fn(|i| dot(&rooted[i], &against));
        let reaction = self.reaction();
        if reaction > 0.0 {
            // ½‖f + div q‖²/c: div of the last field is 2, of the others 0.
            compliance[count - 1][count - 1] += 4.0 * area / reaction;
            for Sample { point, weight, .. } in &samples {
                let load = self.body.load_at(self.mesh.region(t), *point)?[0];
                shift[count - 1] += weight * 2.0 * load / reaction;
            }
        }
        let sides = [0, 1, 2].map(|k| side(corners, k));
        let mut forces = [[0.0; R]; F];
        for (row, field) in forces.iter_mut().zip(fields) {
            *row = self.forces(field, &sides, &self.sides[t]);
        }
        let mut known_forces = self.forces::<R>(&known, &sides, &self.sides[t]);
        let mut left_over = 0.0;
        if let Some(own) = self.own_of(t) {
            left_over = own.left_over;
            let more: [f64; R] =
                self.forces_of(&[0, 1, 2].map(|k| own.ends(k)), &sides, &self.sides[t]);
            known_forces.iter_mut().zip(more).for_each(|(sum, force)| *sum += force);
        }
        let what = "compliance of the stresses on one triangle";
        let root =
            factor(compliance, count).ok_or_else(|| Error::not_positive_definite(what, t))?;
        let mut offset = shift.map(|value| [value]);
        solve(&root, count, &mut forces);
        solve(&root, count, &mut offset);
        let offset = offset.map(|[value]| value);
        Ok(Local { count, root, forces, offset, known_forces, left_over })
    }

    /// The equations of all triangles.
    fn locals<const F: usize, const R: usize>(&self) -> Result<Vec<Local<F, R>>> {
        parallel::map_together(self.sides.len(), 256, &|t| self.local(t)).into_iter().collect()
    }

    /// The matrix of the edges' equations, and their right-hand side without given forces.
    fn assembled<const F: usize, const R: usize>(
        &self,
        locals: &[Local<F, R>],
    ) -> (BlockMatrix, Vec<f64>) {
        let c = self.per_edge();
        let chunk = |number: usize| {
            let first = number * CHUNK;
            let (mut lengths, mut columns, mut values) =
                (Vec::new(), Vec::<u32>::new(), Vec::<f64>::new());
            let last = self.edges().min(first + CHUNK);
            let mut load = vec![0.0; c * (last - first)];
            for edge in first..last {
                let start = columns.len();
                for (t, _) in self.around[edge].into_iter().flatten() {
                    for side in self.sides[t] {
                        if !columns[start..].contains(&(side.edge as u32)) {
                            columns.push(side.edge as u32);
                        }
                    }
                }
                columns[start..].sort_unstable();
                lengths.push(columns.len() - start);
                values.resize(columns.len() * c * c, 0.0);
                for (t, k) in self.around[edge].into_iter().flatten() {
                    let local = &locals[t];
                    for a in 0..c {
                        load[c * (edge - first) + a] += local.load(c * k + a);
                    }
                    for j in 0..3 {
                        let other = self.sides[t][j].edge as u32;
                        let at = start + columns[start..].partition_point(|&column| column < other);
                        for (a, b) in (0..c).flat_map(|a| (0..c).map(move |b| (a, b))) {
                            values[(at * c + a) * c + b] += local.stiffness(c * k + a, c * j + b);
                        }
                    }
                }
            }
            (lengths, columns, values, load)
        };
        let chunks = parallel::map(self.edges().div_ceil(CHUNK), &chunk);
        let (mut offsets, mut columns, mut values, mut load) =
            (vec![0], Vec::new(), Vec::new(), Vec::new());
        for (lengths, more_columns, more_values, more_load) in chunks {
            for length in lengths {
                offsets.push(offsets[offsets.len() - 1] + length);
            }
            columns.extend(more_columns);
            values.extend(more_values);
            load.extend(more_load);
        }
        (BlockMatrix::new(c, offsets, columns, values), load)
    }

    /// The multipliers of an edge that belong to a function of the place.
    fn means(&self, border: &Border, value: impl Fn(Point) -> Result<Point>) -> Result<[f64; 4]> {
        let corners = self.mesh.corners(border.triangle);
        let (a, b) = (corners[border.side], corners[(border.side + 1) % 3]);
        let side = self.side(border.triangle, border.side);
        let (mut normal, mut tangential) = ([0.0; 2], [0.0; 2]);
        for (s, weight) in self.edge_rule.iter() {
            let [x, y] = value([a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1])])?;
            let along = match self.components {
                1 => [x, 0.0],
                _ => [
                    x * side.normal[0] + y * side.normal[1],
                    x * side.tangent[0] + y * side.tangent[1],
                ],
            };
            for (end, hat) in [1.0 - s, s].into_iter().enumerate() {
                normal[end] += weight * 2.0 * hat * along[0];
                tangential[end] += weight * 2.0 * hat * along[1];
            }
        }
        let mean = |[first, last]: [f64; 2]| 0.5 * (first + last);
        Ok(match self.per_edge() {
            1 => [mean(normal), 0.0, 0.0, 0.0],
            3 => [normal[0], normal[1], mean(tangential), 0.0],
            _ => [normal[0], normal[1], tangential[0], tangential[1]],
        })
    }

    /// The forces on an edge of the linear part of its traction.
    fn given(&self, border: &Border) -> [f64; 4] {
        let half = 0.5 * self.side(border.triangle, border.side).length;
        let [first, last] = border.linear;
        match self.per_edge() {
            1 => [half * (first[0] + last[0]), 0.0, 0.0, 0.0],
            3 => [half * first[0], half * last[0], half * (first[1] + last[1]), 0.0],
            _ => [half * first[0], half * last[0], half * first[1], half * last[1]],
        }
    }

    /// The stress of least complementary energy; `touches` is a guess of the contact segments'
    /// ends, by border.
    pub(super) fn best_stress(&self, touches: &[[bool; 2]]) -> Result<Dual> {
        match (self.components, self.tractions) {
            (1, Traction::Reduced) => self.best::<3, 3>(touches),
            (1, Traction::Linear) => self.best::<6, 6>(touches),
            (_, Traction::Reduced) => self.best::<6, 9>(touches),
            (_, Traction::Linear) => self.best::<9, 12>(touches),
        }
    }

    fn best<const F: usize, const R: usize>(&self, touches: &[[bool; 2]]) -> Result<Dual> {
        let c = self.per_edge();
        let locals = self.locals::<F, R>()?;
        let (matrix, mut load) = self.assembled(&locals);
        let mut prescribed = vec![false; load.len()];
        let mut multipliers = vec![0.0; load.len()];
        let (mut kept, mut bound, mut guess) = (Vec::new(), Vec::new(), Vec::new());
        for (number, border) in self.borders.iter().enumerate() {
            let own = c * border.edge;
            let given = self.given(border);
            match border.part {
                Part::Dirichlet => {
                    let means = self.means(border, |point| {
                        self.body.displacement_at(self.mesh.group(border.number), point)
                    })?;
                    for a in 0..c {
                        prescribed[own + a] = true;
                        multipliers[own + a] = means[a];
                    }
                }
                Part::Neumann => (0..c).for_each(|a| load[own + a] += given[a]),
                Part::Contact => {
                    (0..c).for_each(|a| load[own + a] += given[a]);
                    let normal = |point| {
                        let gap = self.body.gap_at(self.mesh.group(border.number), point)?;
                        let n = self.side(border.triangle, border.side).normal;
                        Ok(if self.components == 1 { [gap, 0.0] } else { [gap * n[0], gap * n[1]] })
                    };
                    let means = self.means(border, normal)?;
                    for a in 0..c.min(2) {
                        kept.push(own + a);
                        bound.push(means[a]);
                        guess.push(touches[number][a]);
                    }
                }
            }
        }
        let places: Vec<Point> = (0..self.edges()).map(|edge| self.middle_of(edge)).collect();
        let condensation = Condensation::with_leaves(LEAF, &matrix, &places, &prescribed, &kept)?;
        let fixed = vec![false; kept.len()];
        let mut pressure = vec![0.0; kept.len()];
        let mut set = ContactSet::new(&guess);
        let mut steps = 0;
        let mut rounding = 0.0;
        // Solution, and one correction for its residual; the energy norm of that bounds what
        // rounding leaves.
        for pass in 0..2 {
            let product = matrix.multiply(&multipliers);
            let mut residual: Vec<f64> = load.iter().zip(&product).map(|(f, k)| f - k).collect();
            for (&unknown, force) in kept.iter().zip(&pressure) {
                residual[unknown] -= force;
            }
            let reduced = condensation.reduce(&residual);
            let left: Vec<f64> =
                bound.iter().zip(&kept).map(|(g, &k)| g - multipliers[k]).collect();
            let edge = EdgeProblem {
                stiffness: condensation.schur(),
                load: reduced.kept(),
                bound: &left,
                fixed: &fixed,
                cone: Cone::Nodal,
                ends: Ends::Open,
            };
            let state = if pass == 0 {
                let outcome = solve_on_edge(&edge, set)?;
                (set, steps) = (outcome.set, outcome.steps.len());
                if !outcome.status.is_converged() {
                    return Err(Error::Solver {
                        reason: format!("the equilibrated stress: {}", outcome.status),
                    });
                }
                outcome.state
            } else {
                edge.solve_with(&set)?
            };
            let correction = condensation.recover(&reduced, &state.displacement);
            if pass == 1 {
                // What a residual below its own rounding hides is added.
                let work = careful_dot(&correction, &residual).abs();
                let sizes = matrix.multiply_absolute(&multipliers);
                let hidden: f64 = sizes
                    .iter()
                    .enumerate()
                    .filter(|&(i, _)| !prescribed[i])
                    .map(|(i, size)| {
                        (f64::EPSILON * (size + load[i].abs())).powi(2) / matrix.diagonal(i)
                    })
                    .sum();
                rounding = work.sqrt() + hidden.sqrt();
            }
            for (i, value) in correction.iter().enumerate() {
                if !prescribed[i] {
                    multipliers[i] += value;
                }
            }
            pressure.iter_mut().zip(&state.multiplier).for_each(|(sum, more)| *sum += more);
        }
        let oscillation = locals
            .iter()
            .enumerate()
            .map(|(t, local)| self.oscillation_of(t, local.left_over))
            .collect();
        let fields = parallel::map_together(self.sides.len(), 256, &|t| {
            self.recovered(t, &locals[t], &multipliers)
        });
        let mut at_borders = vec![[0.0; 2]; self.borders.len()];
        let mut next = pressure.chunks_exact(c.min(2));
        for (number, border) in self.borders.iter().enumerate() {
            if border.part == Part::Contact {
                let no_forces = || Error::count("forces of a contact segment", 0, "[1, 2]");
                let forces = next.next().ok_or_else(no_forces)?;
                let length = self.side(border.triangle, border.side).length;
                // A rounded negative pressure is none: its correction is within `rounding`.
                at_borders[number] = match forces {
                    [first, last] => [2.0 * first.max(0.0) / length, 2.0 * last.max(0.0) / length],
                    _ => [forces[0].max(0.0) / length; 2],
                };
            }
        }
        Ok(Dual { fields, oscillation, pressure: at_borders, rounding, steps })
    }

    /// A stress of this mesh on a refinement.
    ///
    /// # Errors
    /// [`Error::Solver`] if a contact segment of the refinement is in none of this mesh.
    pub(super) fn transferred(&self, fine: &Setting<'_, '_>, dual: &Dual) -> Result<Dual> {
        let area = |mesh: &Triangulation, t: usize| doubled_area(mesh.corners(t));
        let count = fine.mesh.triangles().len();
        let oscillation = |t: usize| match dual.oscillation[fine.host(t)] {
            0.0 => 0.0,
            // The squares add up to that of the ancestor.
            whole => whole * (area(fine.mesh, t) / area(self.mesh, fine.host(t))).sqrt(),
        };
        let mut pressure = vec![[0.0; 2]; fine.borders.len()];
        for (own, border) in pressure.iter_mut().zip(&fine.borders) {
            if border.part != Part::Contact {
                continue;
            }
            let corners = fine.mesh.corners(border.triangle);
            let ends = [0, 1].map(|end| corners[(border.side + end) % 3]);
            let middle = [0, 1].map(|axis| 0.5 * (ends[0][axis] + ends[1][axis]));
            let (k, _) = fine.on_side(border.triangle, border.side, 0.5, middle);
            let host = fine.host(border.triangle);
            // A pressure of 0 for lack of a segment would be a smaller bound than the stress has.
            let number = self.border_of[self.sides[host][k].edge]
                .filter(|&number| self.borders[number].part == Part::Contact)
                .ok_or_else(|| Error::Solver {
                    reason: format!(
                        "the contact segment at ({}, {}) is in none of the mesh of the stress",
                        middle[0], middle[1]
                    ),
                })?;
            let [p, r] = dual.pressure[number];
            let whole = self.mesh.corners(host);
            let length = distance(whole[k], whole[(k + 1) % 3]);
            *own = ends.map(|end| p + (distance(whole[k], end) / length).min(1.0) * (r - p));
        }
        Ok(Dual {
            fields: (0..count).map(|t| dual.fields[fine.host(t)]).collect(),
            oscillation: (0..count).map(oscillation).collect(),
            pressure,
            rounding: dual.rounding,
            steps: 0,
        })
    }

    fn middle_of(&self, edge: usize) -> Point {
        self.around[edge][0].map_or([0.0; 2], |(t, k)| {
            let corners = self.mesh.corners(t);
            let (a, b) = (corners[k], corners[(k + 1) % 3]);
            [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])]
        })
    }

    /// q − q_p on one triangle, from the multipliers.
    fn recovered<const F: usize, const R: usize>(
        &self,
        t: usize,
        local: &Local<F, R>,
        multipliers: &[f64],
    ) -> Linear {
        let c = self.per_edge();
        let own = |row: usize| multipliers[c * self.sides[t][row / c].edge + row % c];
        let values: [f64; R] = std::array::from_fn(own);
        let mut x = local.offset.map(|value| -value);
        for (x, forces) in x.iter_mut().zip(&local.forces) {
            *x += forces.iter().zip(&values).map(|(force, value)| force * value).sum::<f64>();
        }
        for i in (0..local.count).rev() {
            let known: f64 = (i + 1..local.count).map(|k| local.root[k][i] * x[k]).sum();
            x[i] = (x[i] - known) / local.root[i][i];
        }
        let mut sum = Equilibrated::sum(
            self.components,
            self.tractions,
            self.mesh.corners(t),
            &x[..local.count],
            self.known_slopes(t),
        );
        if let Some(own) = self.own_of(t) {
            add(&mut sum, 1.0, &own.field);
        }
        sum
    }
}

/// The lower Cholesky factor of a matrix given by its lower triangle, or `None`.
fn factor<const F: usize>(mut a: [[f64; F]; F], count: usize) -> Option<[[f64; F]; F]> {
    for j in 0..count {
        for i in j..count {
            let sum = a[i][j] - (0..j).map(|k| a[i][k] * a[j][k]).sum::<f64>();
            if i > j {
                a[i][j] = sum / a[j][j];
            } else if sum > 0.0 {
                a[j][j] = sum.sqrt();
            } else {
                return None;
            }
        }
    }
    Some(a)
}

/// The solutions of L X = B, in the place of B.
fn solve<const F: usize, const N: usize>(
    root: &[[f64; F]; F],
    count: usize,
    columns: &mut [[f64; N]; F],
) {
    for i in 0..count {
        for k in 0..i {
            let (factor, other) = (root[i][k], columns[k]);
            (0..N).for_each(|c| columns[i][c] -= factor * other[c]);
        }
        columns[i].iter_mut().for_each(|value| *value /= root[i][i]);
    }
}

/// Σ a_k b_k, in four sums beside each other.
fn dot(a: &[f64; TERMS], b: &[f64; TERMS]) -> f64 {
    let mut sums = [0.0; 4];
    for (a, b) in a.as_chunks::<4>().0.iter().zip(b.as_chunks::<4>().0) {
        (0..4).for_each(|k| sums[k] += a[k] * b[k]);
    }
    sums.iter().sum()
}
