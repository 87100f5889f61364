//! K and F of a scene from the definitions, in numbers of twice the length, and the sizes of what is added up
//! in them.

use super::scene::{Material, Scene};
use qd::Quad as Double;
use signorini::mesh::Point;

/// On all unknowns, node-major.
pub struct System {
    pub stiffness: Vec<Vec<Double>>,
    pub load: Vec<Double>,
    /// What is added up in K_ii, and of the volume load in F_i, in absolute values.
    pub sizes: Vec<f64>,
    pub load_sizes: Vec<f64>,
}

impl System {
    pub fn of(scene: &Scene) -> Self {
        let c = scene.components();
        let (nodes, count) = (&scene.mesh.nodes, scene.mesh.nodes.len() * c);
        let mut stiffness = vec![vec![Double::ZERO; count]; count];
        let (mut sizes, mut load_sizes) = (vec![0.0; count], vec![0.0; count]);
        let mut load: Vec<Double> = scene.forces.iter().map(|&f| f.into()).collect();
        for (t, corners) in scene.mesh.triangles.iter().enumerate() {
            let region = scene.mesh.regions.get(t).map_or(0, |&r| r as usize);
            let triangle = Triangle::new(corners.map(|node| nodes[node]));
            let [lambda, mu] = lame(&scene.material, region);
            for (i, &a) in corners.iter().enumerate() {
                let (g, twelfth) = (triangle.gradients[i], triangle.area / Double::from(12.0));
                for k in 0..c {
                    for &b in corners {
                        let times = if a == b { 2.0 } else { 1.0 };
                        let f = Double::from(times * scene.volume[b * c + k]) * twelfth;
                        load[a * c + k] += f;
                        load_sizes[a * c + k] += f.abs().0 * triangle.shape;
                    }
                }
                for (j, &b) in corners.iter().enumerate() {
                    let h = triangle.gradients[j];
                    let product = g[0] * h[0] + g[1] * h[1];
                    match scene.material {
                        Material::Scalar { reaction } => {
                            let mass =
                                Double::from(if i == j { 2.0 } else { 1.0 } * reaction) * twelfth;
                            stiffness[a][b] += triangle.area * product + mass;
                        }
                        Material::Elastic { .. } => {
                            for (k, l) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
                                let shear = if k == l { mu * product } else { Double::ZERO };
                                let entry = lambda * g[k] * h[l] + mu * g[l] * h[k] + shear;
                                stiffness[2 * a + k][2 * b + l] += triangle.area * entry;
                            }
                        }
                    }
                }
                let squares = (g[0] * g[0] + g[1] * g[1]).0;
                let modulus = match scene.material {
                    Material::Scalar { reaction } => squares + reaction / 6.0,
                    Material::Elastic { .. } => (lambda.0.abs() + 2.0 * mu.0) * squares,
                };
                (0..c).for_each(|k| sizes[a * c + k] += triangle.area.0 * modulus * triangle.shape);
            }
        }
        Self { stiffness, load, sizes, load_sizes }
    }
}

/// The coefficients λ, μ of a region.
fn lame(material: &Material, region: usize) -> [Double; 2] {
    let Material::Elastic { moduli, is_stress } = material else { return [Double::ZERO; 2] };
    let [young, poisson] = moduli[region.min(moduli.len() - 1)].map(Double::from);
    let (one, two) = (Double::from(1.0), Double::from(2.0));
    let mu = young / (two * (one + poisson));
    let rest = if *is_stress { one - poisson } else { one - two * poisson };
    [young * poisson / ((one + poisson) * rest), mu]
}

/// Area and gradients of the barycentric coordinates; `shape` is the size of what is subtracted in the area
/// over the area.
struct Triangle {
    area: Double,
    gradients: [[Double; 2]; 3],
    shape: f64,
}

impl Triangle {
    fn new(corners: [Point; 3]) -> Self {
        let corners = corners.map(|point| point.map(Double::from));
        let side =
            |i: usize, j: usize| [corners[j][0] - corners[i][0], corners[j][1] - corners[i][1]];
        let (p, q) = (side(0, 1), side(0, 2));
        let (plus, minus) = (p[0] * q[1], q[0] * p[1]);
        let doubled = plus - minus;
        let gradients = [0, 1, 2].map(|i| {
            let [x, y] = side((i + 1) % 3, (i + 2) % 3);
            [-y / doubled, x / doubled]
        });
        let shape = (plus.0.abs() + minus.0.abs()) / doubled.0;
        Self { area: Double::from(0.5) * doubled, gradients, shape }
    }
}
