//! Random meshes: jittered, graded and slanted grids.

use super::scene::decades;
use crate::common::SplitMix;
use signorini::mesh::{BoundaryEdge, Part, Point};

/// Most constraints of a scene.
const MOST: usize = 12;

/// A triangle below this multiple of its squared diameter is drawn again: the library refuses below 2.3e-13.
const FLAT: f64 = 1e-12;

#[derive(Debug, Clone, Default)]
pub struct Mesh {
    pub nodes: Vec<Point>,
    pub triangles: Vec<[usize; 3]>,
    /// The domain on the left.
    pub boundary: Vec<BoundaryEdge>,
    pub regions: Vec<u32>,
    /// Nodes of the contact edge in order.
    pub chain: Vec<usize>,
    pub is_closed: bool,
}

impl Mesh {
    /// Labels a loop of boundary nodes: `contact` edges from number `first` on touch, the others are clamped
    /// or free; at least one of them is clamped.
    fn label(&mut self, random: &mut SplitMix, around: &[usize], first: usize, contact: usize) {
        let count = around.len();
        let others = count - contact;
        let clamped = if others == 0 { usize::MAX } else { random.below(others) };
        let share = random.below(4);
        for k in 0..count {
            let at = (first + k) % count;
            let part = match k {
                k if k < contact => Part::Contact,
                k if k - contact == clamped || random.below(4) < share => Part::Dirichlet,
                _ => Part::Neumann,
            };
            self.boundary
                .push(BoundaryEdge { nodes: [around[at], around[(at + 1) % count]], part });
        }
        self.is_closed = others == 0;
        let nodes = if self.is_closed { count } else { contact + 1 };
        self.chain = (0..nodes).map(|k| around[(first + k) % count]).collect();
    }

    /// Every triangle is a triangle, and has its corners in order.
    fn is_sound(&self) -> bool {
        self.triangles.iter().all(|&triangle| {
            let [a, b, c] = triangle.map(|node| self.nodes[node]);
            let (p, q) = ([b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]]);
            let size = [p, q, [c[0] - b[0], c[1] - b[1]]]
                .iter()
                .map(|d| d[0].hypot(d[1]))
                .fold(0.0, f64::max);
            p[0] * q[1] - p[1] * q[0] > FLAT * size * size
        })
    }

    /// Turned, sheared, stretched.
    fn slanted(&mut self, random: &mut SplitMix) {
        let (sin, cos) =
            if random.below(3) == 0 { (0.0, 1.0) } else { random.between(0.0, 6.3).sin_cos() };
        let shear = if random.below(3) == 0 { random.between(-3.0, 3.0) } else { 0.0 };
        let stretch = if random.below(4) == 0 { decades(random, -5.0, 5.0) } else { 1.0 };
        for node in &mut self.nodes {
            let [x, y] = [node[0] + shear * node[1], stretch * node[1]];
            *node = [cos * x - sin * y, sin * x + cos * y];
        }
    }
}

/// Steps of random lengths that add up to 1, of one size or over eight decades.
fn steps(random: &mut SplitMix, count: usize) -> Vec<f64> {
    let low = if random.below(4) == 0 { -8.0 } else { -0.3 };
    let lengths: Vec<f64> = (0..count).map(|_| decades(random, low, 0.0)).collect();
    let sum: f64 = lengths.iter().sum();
    let mut place = 0.0;
    std::iter::once(0.0)
        .chain(lengths.into_iter().map(|length| {
            place += length / sum;
            place
        }))
        .collect()
}

/// A grid with random lines, corners and diagonals, its inner nodes moved. An elastic body touches along a
/// part of its bottom, a scalar one along any part of the boundary.
pub fn grid(random: &mut SplitMix, is_elastic: bool) -> Mesh {
    loop {
        let most = if random.below(3) == 0 { 11 } else { 5 };
        let (nx, ny) = (1 + random.below(most), 1 + random.below(3));
        let (xs, ys) = (steps(random, nx), steps(random, ny));
        let jitter = if random.below(2) == 0 { random.between(0.0, 0.6) } else { 0.0 };
        let mut corner = || random.between(-0.3, 0.3);
        let top = [corner(), corner(), 1.0 + corner(), 1.0 + corner()];
        let mut mesh = Mesh::default();
        let width = nx + 1;
        for (j, &y) in ys.iter().enumerate() {
            for (i, &x) in xs.iter().enumerate() {
                let (mut x, mut y) = (x, y);
                if i > 0 && i < nx && j > 0 && j < ny {
                    x += jitter * random.between(-1.0, 1.0) * (xs[i + 1] - x).min(x - xs[i - 1]);
                    y += jitter * random.between(-1.0, 1.0) * (ys[j + 1] - y).min(y - ys[j - 1]);
                }
                // Bottom (0, 0) to (1, 0), the other corners anywhere.
                mesh.nodes
                    .push([x + y * (top[0] + x * top[1]), y * (top[2] * (1.0 - x) + top[3] * x)]);
            }
        }
        for j in 0..ny {
            for i in 0..nx {
                let [a, b] = [j * width + i, j * width + i + 1];
                let [d, c] = [a + width, b + width];
                mesh.triangles.extend(if random.below(2) == 0 {
                    [[a, b, c], [a, c, d]]
                } else {
                    [[a, b, d], [b, c, d]]
                });
            }
        }
        let around: Vec<usize> = (0..nx)
            .chain((0..ny).map(|j| j * width + nx))
            .chain((1..=nx).rev().map(|i| ny * width + i))
            .chain((1..=ny).rev().map(|j| j * width))
            .collect();
        let (first, contact) = if is_elastic {
            let first = random.below(nx);
            (first, 1 + random.below((nx - first).min(MOST - 1)))
        } else {
            let count = around.len();
            let all = count <= MOST && random.below(6) == 0;
            let most = if all { count } else { (count - 1).min(MOST - 1) };
            (random.below(count), if all { count } else { 1 + random.below(most) })
        };
        mesh.label(random, &around, first, contact);
        mesh.slanted(random);
        if mesh.is_sound() {
            return mesh;
        }
    }
}

/// A small grid with unit steps, stretched by up to 10⁴ either way, turned and moved; the bottom touches, or the right
/// end does.
pub fn slender(random: &mut SplitMix) -> Mesh {
    loop {
        let (nx, ny) = (1 + random.below(5), 1 + random.below(3));
        let (wide, high) = (1.0 / nx as f64, decades(random, -4.0, 4.0) / ny as f64);
        let (sin, cos) =
            if random.below(2) == 0 { (0.0, 1.0) } else { random.between(0.0, 6.3).sin_cos() };
        let [x0, y0] = [0, 1].map(|_| random.between(-10.0, 10.0));
        let width = nx + 1;
        let mut mesh = Mesh::default();
        for j in 0..=ny {
            for i in 0..=nx {
                let [x, y] = [wide * i as f64, high * j as f64];
                mesh.nodes.push([x0 + (cos * x - sin * y), y0 + (sin * x + cos * y)]);
            }
        }
        for (j, i) in (0..ny).flat_map(|j| (0..nx).map(move |i| (j, i))) {
            let [a, b] = [j * width + i, j * width + i + 1];
            let [d, c] = [a + width, b + width];
            mesh.triangles.extend(if random.below(2) == 0 {
                [[a, b, c], [a, c, d]]
            } else {
                [[a, b, d], [b, c, d]]
            });
        }
        let around: Vec<usize> = (0..nx)
            .chain((0..ny).map(|j| j * width + nx))
            .chain((1..=nx).rev().map(|i| ny * width + i))
            .chain((1..=ny).rev().map(|j| j * width))
            .collect();
        let (first, contact) = if random.below(3) > 0 { (0, nx) } else { (nx, ny) };
        mesh.label(random, &around, first, contact);
        if mesh.is_sound() {
            return mesh;
        }
    }
}
