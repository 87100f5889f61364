//! min ½ u'K u − F'u over B u ≤ g, from the definitions and in numbers of twice the length: dense, all
//! contact sets tried.
//!
//! With u = K⁻¹(F − B'λ) the conditions are λ ≥ 0, B u − g = c − A λ ≤ 0, λ'(c − A λ) = 0, A = B K⁻¹ B',
//! c = B K⁻¹F − g. The solution has a contact set on which A is regular, so that one of the at most 2^12 sets
//! meets them.
//!
//! What rounding of the data may do: K and F off by ε s_i in every row, s_i = Σ_j (k_i k_j)^{1/2} |u_j| +
//! |F|_i with k_i the sum of the sizes of what is added up in K_ii, moves u by no more than E = ε
//! (s'|K⁻¹|s)^{1/2} in the energy norm (the solution of a variational inequality is a nonexpansive function
//! of the load), hence u_i by (K⁻¹)_ii^{1/2} E, and a force by ε s_i + k_i^{1/2} E. No assumption on the
//! contact set enters.

use super::scene::Scene;
use super::stiffness::System;
use qd::Quad as Double;
use signorini::cone::Cone;
use signorini::mesh::Part;

/// Pivots below this share of their diagonal entry make a set of constraints dependent.
const DEPENDENT: f64 = 1e-20;

/// What is left of the conditions by numbers of 106 bits, relative to the largest force or displacement.
const EXACT: f64 = 1e-13;

pub struct Program {
    /// K, and F, on all unknowns.
    stiffness: Vec<Vec<Double>>,
    load: Vec<Double>,
    /// Free unknowns, ascending.
    pub free: Vec<usize>,
    /// Values at all unknowns, 0 where they are free.
    prescribed: Vec<f64>,
    /// k_i^{1/2} and |F|_i at all unknowns.
    roots: Vec<f64>,
    load_sizes: Vec<f64>,
    /// The nodes of every constraint, its row and its bound on the free unknowns.
    supports: Vec<Vec<usize>>,
    rows: Vec<Vec<Double>>,
    bound: Vec<Double>,
    components: usize,
    inverse: Cholesky,
    /// |K⁻¹|.
    absolute: Vec<Vec<f64>>,
}

/// A solution with what rounding may do to it.
pub struct Answer {
    /// At all unknowns.
    pub displacement: Vec<Double>,
    pub multiplier: Vec<Double>,
    pub gap: Vec<Double>,
    pub energy: f64,
    /// Σ |u_i| s_i.
    pub energy_size: f64,
    /// E / ε.
    pub spread: f64,
    /// s at the free unknowns.
    pub sizes: Vec<f64>,
}

impl Program {
    /// `None` where K is not positive definite in numbers of 106 bits.
    pub fn new(scene: &Scene, cone: Cone) -> Option<Self> {
        let c = scene.components();
        let System { stiffness, load, sizes, mut load_sizes } = System::of(scene);
        let (nodes, count) = (&scene.mesh.nodes, load.len());
        let mut held = vec![false; count];
        for edge in scene.mesh.boundary.iter().filter(|edge| edge.part == Part::Dirichlet) {
            edge.nodes.iter().for_each(|node| (0..c).for_each(|k| held[node * c + k] = true));
        }
        let prescribed: Vec<f64> = (0..count)
            .map(|i| if held[i] { scene.prescribed(i % c, nodes[i / c]) } else { 0.0 })
            .collect();
        let free: Vec<usize> = (0..count).filter(|&i| !held[i]).collect();
        (0..count).for_each(|i| load_sizes[i] += scene.forces[i].abs());
        let part: Vec<Vec<Double>> =
            free.iter().map(|&i| free.iter().map(|&j| stiffness[i][j]).collect()).collect();
        let inverse = Cholesky::new(&part, 0.0)?;
        let mut program = Self {
            absolute: absolute_inverse(&inverse),
            inverse,
            stiffness,
            load,
            free,
            prescribed,
            roots: sizes.into_iter().map(f64::sqrt).collect(),
            load_sizes,
            supports: Vec::new(),
            rows: Vec::new(),
            bound: Vec::new(),
            components: c,
        };
        program.constrain(scene, cone);
        Some(program)
    }

    fn constrain(&mut self, scene: &Scene, cone: Cone) {
        let chain = &scene.mesh.chain;
        let normal = normal(scene, chain);
        for nodes in supports(chain, cone, scene.mesh.is_closed) {
            let weight = Double::from(1.0 / nodes.len() as f64);
            let mut row = vec![Double::ZERO; self.free.len()];
            let mut bound = Double::ZERO;
            for &node in &nodes {
                bound += weight
                    * Double::from(
                        scene.gap[chain.iter().position(|&other| other == node).unwrap()],
                    );
                for k in 0..self.components {
                    let unknown = node * self.components + k;
                    let entry = weight * normal[k];
                    match self.free.binary_search(&unknown) {
                        Ok(at) => row[at] += entry,
                        Err(_) => bound -= entry * Double::from(self.prescribed[unknown]),
                    }
                }
            }
            self.supports.push(nodes);
            self.rows.push(row);
            self.bound.push(bound);
        }
    }

    /// True when no unknown of constraint i is free.
    pub fn is_settled(&self, i: usize) -> bool {
        self.rows[i].iter().all(|entry| entry.0 == 0.0)
    }

    /// True when prescribed values alone keep to their bounds.
    pub fn is_admissible(&self) -> bool {
        (0..self.rows.len()).all(|i| !self.is_settled(i) || value(self.bound[i]) >= 0.0)
    }

    /// All sets, until one meets all conditions, or the one that meets them best.
    pub fn solve(&self) -> Answer {
        let open: Vec<usize> = (0..self.rows.len()).filter(|&i| !self.is_settled(i)).collect();
        let images: Vec<Vec<Double>> =
            open.iter().map(|&i| self.inverse.solve(&self.rows[i])).collect();
        let imposed: Vec<Double> = self.prescribed.iter().map(|&v| v.into()).collect();
        let load: Vec<Double> =
            self.free.iter().map(|&i| self.load[i] - dot(&self.stiffness[i], &imposed)).collect();
        let unloaded = self.inverse.solve(&load);
        let matrix: Vec<Vec<Double>> = open
            .iter()
            .map(|&i| images.iter().map(|image| dot(&self.rows[i], image)).collect())
            .collect();
        let off: Vec<Double> =
            open.iter().map(|&i| dot(&self.rows[i], &unloaded) - self.bound[i]).collect();
        let stiff = |i: usize| 1.0 / matrix[i][i].0;
        let force = (0..open.len()).map(|i| off[i].0.abs() * stiff(i)).fold(0.0, f64::max);
        let length = unloaded.iter().chain(&off).map(|u| u.0.abs()).fold(0.0, f64::max);
        let mut best: Option<(f64, Vec<Double>)> = None;
        for pattern in 0..1_u32 << open.len() {
            let set: Vec<usize> = (0..open.len()).filter(|i| pattern >> i & 1 == 1).collect();
            let part: Vec<Vec<Double>> =
                set.iter().map(|&i| set.iter().map(|&j| matrix[i][j]).collect()).collect();
            let Some(factor) = Cholesky::new(&part, DEPENDENT) else { continue };
            let right: Vec<Double> = set.iter().map(|&i| off[i]).collect();
            let found = factor.solve(&right);
            let pull = found.iter().map(|l| -l.0).fold(0.0, f64::max);
            let mut multiplier = vec![Double::ZERO; open.len()];
            set.iter().zip(found).for_each(|(&i, l)| multiplier[i] = l);
            let beyond = (0..open.len())
                .filter(|i| !set.contains(i))
                .map(|i| (off[i] - dot(&matrix[i], &multiplier)).0)
                .fold(0.0, f64::max);
            let ratio = |part: f64, of: f64| if part == 0.0 { 0.0 } else { part / of };
            let wrong = ratio(pull, force).max(ratio(beyond, length));
            if best.as_ref().is_none_or(|(least, _)| wrong < *least) {
                best = Some((wrong, multiplier));
            }
            if wrong == 0.0 {
                break;
            }
        }
        let (wrong, found) = best.expect("the empty set is one of them");
        assert!(wrong <= EXACT, "the best of all sets is wrong by {wrong:e}");
        let mut free = unloaded;
        let mut multiplier = vec![Double::ZERO; self.rows.len()];
        for ((&i, l), image) in open.iter().zip(found).zip(&images) {
            multiplier[i] = l;
            free.iter_mut().zip(image).for_each(|(u, d)| *u -= *d * l);
        }
        self.answer(&free, multiplier)
    }

    fn answer(&self, free: &[Double], multiplier: Vec<Double>) -> Answer {
        let mut displacement: Vec<Double> = self.prescribed.iter().map(|&v| v.into()).collect();
        self.free.iter().zip(free).for_each(|(&i, &u)| displacement[i] = u);
        let half = Double::from(0.5);
        let terms = (0..displacement.len()).map(|i| {
            displacement[i] * (half * dot(&self.stiffness[i], &displacement) - self.load[i])
        });
        let energy = value(terms.fold(Double::ZERO, |sum, term| sum + term));
        let gap =
            self.rows.iter().zip(&self.bound).map(|(row, &bound)| dot(row, free) - bound).collect();
        let all = self.sizes(&displacement);
        let sizes: Vec<f64> = self.free.iter().map(|&i| all[i]).collect();
        let moved = |row: &Vec<f64>| row.iter().zip(&sizes).map(|(k, s)| k * s).sum::<f64>();
        let square: f64 = self.absolute.iter().zip(&sizes).map(|(row, s)| s * moved(row)).sum();
        let energy_size = displacement.iter().zip(&all).map(|(u, s)| u.0.abs() * s).sum();
        // n is rounded, too.
        let turned: f64 = self
            .supports
            .iter()
            .flatten()
            .flat_map(|&node| (0..self.components).map(move |k| node * self.components + k))
            .map(|i| self.roots[i] * displacement[i].0.abs())
            .sum();
        Answer {
            displacement,
            multiplier,
            gap,
            energy,
            energy_size,
            spread: square.sqrt() + turned,
            sizes,
        }
    }

    /// s_i at all unknowns.
    fn sizes(&self, u: &[Double]) -> Vec<f64> {
        let term = |i: usize, j: usize| {
            if self.stiffness[i][j].0 == 0.0 { 0.0 } else { self.roots[j] * u[j].0.abs() }
        };
        let row = |i: usize| {
            self.roots[i] * (0..u.len()).map(|j| term(i, j)).sum::<f64>() + self.load_sizes[i]
        };
        (0..u.len()).map(row).collect()
    }

    /// K u − F + B'λ and s at the free unknowns, for any displacement and multiplier.
    pub fn residual(&self, u: &[f64], multiplier: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let u: Vec<Double> = u.iter().map(|&u| u.into()).collect();
        let force = self.forces(&multiplier.iter().map(|&l| l.into()).collect::<Vec<Double>>());
        let row =
            |(k, &i): (usize, &usize)| value(dot(&self.stiffness[i], &u) - self.load[i] + force[k]);
        let sizes = self.sizes(&u);
        (
            self.free.iter().enumerate().map(row).collect(),
            self.free.iter().map(|&i| sizes[i]).collect(),
        )
    }

    /// B u − g of any displacement at all unknowns.
    pub fn gaps(&self, u: &[f64]) -> Vec<f64> {
        let free: Vec<Double> = self.free.iter().map(|&i| u[i].into()).collect();
        self.rows
            .iter()
            .zip(&self.bound)
            .map(|(row, &bound)| value(dot(row, &free) - bound))
            .collect()
    }

    /// max |F_i| / K_ii: what a load does alone.
    pub fn alone(&self) -> f64 {
        let at = |&i: &usize| (self.load[i].0 / self.stiffness[i][i].0).abs();
        self.free.iter().map(at).fold(0.0, f64::max)
    }

    /// g, less what prescribed values take of it.
    pub fn bounds(&self) -> Vec<f64> {
        self.bound.iter().map(|&bound| value(bound)).collect()
    }

    /// B'λ at the free unknowns.
    pub fn forces(&self, multiplier: &[Double]) -> Vec<Double> {
        let mut force = vec![Double::ZERO; self.free.len()];
        for (row, &l) in self.rows.iter().zip(multiplier) {
            force.iter_mut().zip(row).for_each(|(f, &entry)| *f += entry * l);
        }
        force
    }

    /// What E in the energy norm is at a free unknown, in the displacement and in the force.
    pub fn locally(&self, k: usize) -> [f64; 2] {
        [self.absolute[k][k].sqrt(), self.roots[self.free[k]]]
    }

    /// At most what forces off by so much at every free unknown are in the energy norm.
    pub fn energy_of_residual(&self, force: f64) -> f64 {
        force * self.absolute.iter().flatten().sum::<f64>().sqrt()
    }

    /// |D K⁻¹ D|, D² = (k_i): the condition number of the scaled matrix, within n.
    pub fn condition(&self) -> f64 {
        let at = |k: usize, l: usize| {
            self.roots[self.free[k]] * self.absolute[k][l] * self.roots[self.free[l]]
        };
        let count = self.free.len();
        (0..count)
            .flat_map(|k| (0..count).map(move |l| (k, l)))
            .map(|(k, l)| at(k, l))
            .fold(0.0, f64::hypot)
    }

    /// The nodes of all constraints.
    pub fn supports(&self) -> &[Vec<usize>] {
        &self.supports
    }

    /// The nodes of constraint i.
    pub fn support(&self, i: usize) -> &[usize] {
        &self.supports[i]
    }

    /// True when the rows of B of these constraints are independent on the free unknowns.
    pub fn are_independent(&self, constraints: &[usize]) -> bool {
        let gram: Vec<Vec<Double>> = constraints
            .iter()
            .map(|&i| constraints.iter().map(|&j| dot(&self.rows[i], &self.rows[j])).collect())
            .collect();
        Cholesky::new(&gram, DEPENDENT).is_some()
    }
}

fn absolute_inverse(factor: &Cholesky) -> Vec<Vec<f64>> {
    let count = factor.0.len();
    // L⁻¹, column by column.
    let mut columns = vec![vec![0.0; count]; count];
    for (j, column) in columns.iter_mut().enumerate() {
        for i in j..count {
            let sum: f64 = (j..i).map(|k| factor.0[i][k].0 * column[k]).sum();
            column[i] = (f64::from(u8::from(i == j)) - sum) / factor.0[i][i].0;
        }
    }
    let entry = |i: usize, j: usize| -> f64 {
        (i.max(j)..count).map(|k| columns[i][k] * columns[j][k]).sum::<f64>().abs()
    };
    (0..count).map(|i| (0..count).map(|j| entry(i, j)).collect()).collect()
}

/// The outward normal of a straight piece; (1, 0) for a scalar problem.
fn normal(scene: &Scene, piece: &[usize]) -> [Double; 2] {
    if scene.components() == 1 {
        return [Double::from(1.0), Double::ZERO];
    }
    let [a, b] =
        [piece[0], piece[piece.len() - 1]].map(|node| scene.mesh.nodes[node].map(Double::from));
    let [x, y] = [b[0] - a[0], b[1] - a[1]];
    let length = (x * x + y * y).sqrt();
    [y / length, -x / length]
}

fn supports(piece: &[usize], cone: Cone, is_closed: bool) -> Vec<Vec<usize>> {
    match cone {
        Cone::Nodal => piece.iter().map(|&node| vec![node]).collect(),
        Cone::Midpoint => {
            let segments = piece.len() - usize::from(!is_closed);
            (0..segments).map(|i| vec![piece[i], piece[(i + 1) % piece.len()]]).collect()
        }
    }
}

/// The nearest number of binary64.
pub fn value(number: Double) -> f64 {
    number.0 + number.1
}

fn dot(a: &[Double], b: &[Double]) -> Double {
    a.iter().zip(b).fold(Double::ZERO, |sum, (&a, &b)| sum + a * b)
}

/// A = L L', row by row; `None` where a pivot is below `least` of its diagonal entry.
struct Cholesky(Vec<Vec<Double>>);

impl Cholesky {
    fn new(matrix: &[Vec<Double>], least: f64) -> Option<Self> {
        let mut rows: Vec<Vec<Double>> = Vec::with_capacity(matrix.len());
        for (i, row) in matrix.iter().enumerate() {
            let mut next: Vec<Double> = Vec::with_capacity(i + 1);
            for j in 0..i {
                let sum = row[j] - dot(&next, &rows[j][..j]);
                next.push(sum / rows[j][j]);
            }
            let pivot = row[i] - dot(&next, &next);
            if pivot.0.is_nan() || pivot.0 <= least * row[i].0 {
                return None;
            }
            next.push(pivot.sqrt());
            rows.push(next);
        }
        Some(Self(rows))
    }

    fn solve(&self, right: &[Double]) -> Vec<Double> {
        let rows = &self.0;
        let mut x: Vec<Double> = Vec::with_capacity(rows.len());
        for (i, row) in rows.iter().enumerate() {
            let sum = right[i] - dot(&x, &row[..i]);
            x.push(sum / row[i]);
        }
        for i in (0..rows.len()).rev() {
            x[i] /= rows[i][i];
            for j in 0..i {
                let known = rows[i][j] * x[i];
                x[j] -= known;
            }
        }
        x
    }
}
