//! Random scenes of at most twelve contact constraints, and the problem of the library for one of them.

use super::meshes::{Mesh, grid, slender};
use crate::common::SplitMix;
use signorini::Result;
use signorini::contact::ContactProblem;
use signorini::fem::{Field, Form, Lame};
use signorini::mesh::{BoundaryEdge, Part, Point, Triangulation};

#[derive(Debug, Clone)]
pub enum Material {
    /// −Δu + c u.
    Scalar { reaction: f64 },
    /// Young's modulus and Poisson's ratio of every region, plane strain or plane stress.
    Elastic { moduli: Vec<[f64; 2]>, is_stress: bool },
}

/// Data of order one.
#[derive(Debug, Clone)]
pub struct Scene {
    pub mesh: Mesh,
    pub material: Material,
    /// Nodal values of the volume load, node-major.
    pub volume: Vec<f64>,
    /// Nodal forces.
    pub forces: Vec<f64>,
    /// u = a + b x + c y on the Dirichlet part, for every component.
    pub dirichlet: [[f64; 3]; 2],
    /// At the nodes of the contact edge, in order.
    pub gap: Vec<f64>,
}

/// 10^x, x evenly.
pub fn decades(random: &mut SplitMix, low: f64, high: f64) -> f64 {
    10f64.powf(random.between(low, high))
}

impl Scene {
    pub fn random(seed: u64) -> Self {
        let random = &mut SplitMix::new(seed.wrapping_mul(0x5851_F42D_4C95_7F2D).wrapping_add(17));
        let is_elastic = random.below(2) == 0;
        let mut mesh = grid(random, is_elastic);
        if random.below(4) == 0 {
            mesh.regions = (0..mesh.triangles.len()).map(|_| random.below(2) as u32).collect();
        }
        let is_held = mesh.boundary.iter().any(|edge| edge.part == Part::Dirichlet);
        let material = if is_elastic { elastic(random) } else { scalar(random, is_held) };
        let unknowns = mesh.nodes.len() * if is_elastic { 2 } else { 1 };
        let rough = random.below(3);
        let push = random.between(-1.0, 1.0);
        let direction = {
            let angle = random.between(0.0, 6.3);
            [angle.cos(), angle.sin()]
        };
        let volume = (0..unknowns)
            .map(|i| match (rough, is_elastic) {
                (0, _) => random.between(-1.0, 1.0),
                (1, true) => direction[i % 2],
                (1, false) => push,
                _ => push * direction[i % 2] + 0.3 * random.between(-1.0, 1.0),
            })
            .collect();
        let mut forces = vec![0.0; unknowns];
        if random.below(4) == 0 {
            forces[random.below(unknowns)] = random.between(-1.0, 1.0);
        }
        let mut dirichlet = [[0.0; 3]; 2];
        if random.below(4) == 0 {
            let size = decades(random, -3.0, 0.0);
            dirichlet = [0, 1].map(|_| [0, 1, 2].map(|_| size * random.between(-1.0, 1.0)));
        }
        let size = if random.below(2) == 0 { decades(random, -4.0, 0.0) } else { 0.0 };
        let lowest = if random.below(3) == 0 { -1.0 } else { 0.0 };
        let mut gap: Vec<f64> =
            mesh.chain.iter().map(|_| size * random.between(lowest, 1.0)).collect();
        if random.below(20) > 0 {
            admit(&mesh, is_elastic, &dirichlet, &mut gap);
        }
        if random.below(40) == 0 {
            // Nothing pushes: every constraint touches without force, or has room.
            let zero = vec![0.0; unknowns];
            return Self {
                mesh,
                material,
                volume: zero.clone(),
                forces: zero,
                dirichlet: [[0.0; 3]; 2],
                gap,
            };
        }
        Self { mesh, material, volume, forces, dirichlet, gap }
    }

    /// A body that is slender, or has λ/μ up to 10¹⁰, or both: grids of one element or a few across, stretched by up
    /// to 10⁴ either way and turned; forces at the nodes, gaps or none.
    pub fn ill_conditioned(seed: u64) -> Self {
        let random = &mut SplitMix::new(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15).wrapping_add(11));
        let is_elastic = random.below(5) > 0;
        let mesh = slender(random);
        let size = decades(random, -3.0, 4.0);
        let material = if is_elastic {
            let mu = decades(random, -1.0, 4.0);
            let ratio = if random.below(4) == 0 {
                random.between(-0.3, 2.0)
            } else {
                decades(random, 0.0, 10.0)
            };
            // ν = λ/(2 (λ + μ)), E = 2 μ (1 + ν).
            let poisson = 0.5 * ratio / (ratio + 1.0);
            Material::Elastic {
                moduli: vec![[2.0 * mu * (1.0 + poisson), poisson]],
                is_stress: false,
            }
        } else {
            Material::Scalar {
                reaction: if random.below(2) == 0 { 0.0 } else { decades(random, -6.0, 6.0) },
            }
        };
        let unknowns = mesh.nodes.len() * if is_elastic { 2 } else { 1 };
        let push = random.between(-1.0, 1.0);
        let forces = (0..unknowns).map(|_| size * (push + random.between(-1.0, 1.0))).collect();
        let width = if random.below(2) == 0 { decades(random, -6.0, 0.0) } else { 0.0 };
        let gap = mesh.chain.iter().map(|_| width * random.between(0.0, 1.0)).collect();
        Self { mesh, material, volume: vec![0.0; unknowns], forces, dirichlet: [[0.0; 3]; 2], gap }
    }

    pub fn components(&self) -> usize {
        match self.material {
            Material::Scalar { .. } => 1,
            Material::Elastic { .. } => 2,
        }
    }

    fn form(&self) -> Result<Form> {
        match &self.material {
            Material::Scalar { reaction } => Ok(Form::Scalar { reaction: *reaction }),
            Material::Elastic { moduli, is_stress } => {
                let lame = |&[young, poisson]: &[f64; 2]| {
                    if *is_stress {
                        Lame::plane_stress(young, poisson)
                    } else {
                        Lame::plane_strain(young, poisson)
                    }
                };
                Ok(Form::Elastic { materials: moduli.iter().map(lame).collect::<Result<_>>()? })
            }
        }
    }

    /// The problem of the library.
    pub fn problem(&self) -> Result<ContactProblem> {
        let Mesh { nodes, triangles, boundary, regions, .. } = self.mesh.clone();
        let made = Triangulation::new(&nodes, &triangles, &boundary)?;
        let made = if regions.is_empty() { made } else { made.with_regions(&regions)? };
        let mut problem = ContactProblem::new(made, self.form()?, &self.volume)?;
        assert_eq!(problem.edge().nodes(), self.mesh.chain);
        problem.add_load(&self.forces)?;
        let at = |k: usize, point: Point| self.prescribed(k, point);
        match self.components() {
            1 => problem.set_dirichlet(&Field::Scalar(&|point| at(0, point)))?,
            _ => problem.set_dirichlet(&Field::Vector(&|point| [at(0, point), at(1, point)]))?,
        }
        let mut gap = self.gap.iter().copied();
        problem.set_gap(|_| gap.next().unwrap_or(f64::NAN))?;
        Ok(problem)
    }

    /// Prescribed value of a component at a point of the mesh.
    pub fn prescribed(&self, component: usize, [x, y]: Point) -> f64 {
        let [a, b, c] = self.dirichlet[component];
        a + b * x + c * y
    }
}

/// Opens gaps that prescribed values close.
fn admit(mesh: &Mesh, is_elastic: bool, dirichlet: &[[f64; 3]; 2], gap: &mut [f64]) {
    let [a, b] = [mesh.chain[0], mesh.chain[mesh.chain.len() - 1]].map(|node| mesh.nodes[node]);
    let length = (b[0] - a[0]).hypot(b[1] - a[1]);
    let normal =
        if is_elastic { [(b[1] - a[1]) / length, (a[0] - b[0]) / length] } else { [1.0, 0.0] };
    for (node, gap) in mesh.chain.iter().zip(gap) {
        let [x, y] = mesh.nodes[*node];
        let u = dirichlet.map(|[a, b, c]| a + b * x + c * y);
        let least = u[0] * normal[0] + u[1] * normal[1];
        let holds = |edge: &BoundaryEdge| edge.part == Part::Dirichlet && edge.nodes.contains(node);
        if mesh.boundary.iter().any(holds) {
            *gap = gap.max(least + 0.5 * least.abs());
        }
    }
}

fn scalar(random: &mut SplitMix, is_held: bool) -> Material {
    let reaction = match random.below(3) {
        0 if is_held => 0.0,
        1 => 1.0,
        _ => decades(random, if is_held { -6.0 } else { -3.0 }, 4.0),
    };
    Material::Scalar { reaction }
}

fn elastic(random: &mut SplitMix) -> Material {
    let is_stress = random.below(3) == 0;
    let kind = random.below(6);
    let mut moduli = || {
        let poisson = match kind {
            0 => 0.0,
            1 => 0.5 - 1e-15,
            2 => 0.5 - decades(random, -15.0, -1.0),
            3 => -1.0 + decades(random, -15.0, -0.5),
            _ => random.between(-0.9, 0.45),
        };
        [decades(random, -2.0, 2.0), poisson]
    };
    Material::Elastic { moduli: vec![moduli(), moduli()], is_stress }
}
