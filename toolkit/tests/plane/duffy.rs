//! A second method for seminorms on triangulations: Duffy coordinates after Sauter & Schwab (Boundary Element
//! Methods, Springer 2011, Section 5.2) with Gauss-Jacobi rules for touching triangles, cutting both
//! triangles of other pairs into four until they are as far apart as they are large.

use fractional_sobolev::{Function, Order, Rule, Triangles, gauss_jacobi, gauss_legendre};

/// A function by its values: of degree 0 one per triangle, of degree 1 one per node.
#[derive(Debug, Clone)]
pub struct Values {
    pub mesh: Triangles,
    pub degree: usize,
    pub values: Vec<f64>,
}

impl Values {
    pub fn function(&self) -> Function<'static> {
        Function::on_triangles(&self.mesh, self.degree, &self.values).unwrap()
    }
}

type Point = [f64; 2];
type Triangle = [(Point, f64); 3];

/// |w|²_s from the first rule that the one before agrees with.
pub fn settled_seminorm_squared(w: &Values, order: Order, required: f64) -> f64 {
    let mut before = f64::INFINITY;
    for n in [9, 13, 18, 25, 36] {
        let value = seminorm_squared(w, order, n);
        if (value / before - 1.0).abs() <= required {
            return value;
        }
        before = value;
    }
    panic!("the second method does not settle: {before}, s {order}, {w:?}");
}

/// |w|²_s with n points in every direction, three times as many across edges, where the integrand is analytic
/// in a narrow strip, and few in the directions in which it is a power times a polynomial.
pub fn seminorm_squared(w: &Values, order: Order, n: usize) -> f64 {
    let triangles = w.mesh.triangles();
    let duffy = Duffy::new(order.value(), if w.degree == 0 { 0 } else { 2 }, n);
    let mut sum = 0.0;
    for i in 0..triangles.len() {
        for j in 0..=i {
            let twice = if i == j { 1.0 } else { 2.0 };
            let area = 4.0 * w.mesh.areas()[i] * w.mesh.areas()[j];
            sum += twice * area * duffy.pair(w, i, j);
        }
    }
    sum
}

/// Points in the direction of a power.
const POWERS: usize = 3;

struct Duffy {
    s: f64,
    /// of (w(x) − w(y))²
    degree: i32,
    plain: Rule,
    across: Rule,
    apart: Rule,
    /// t^{3+p}, t^{2+p}, t^{1+p}
    weighted: [Option<Rule>; 3],
}

impl Duffy {
    fn new(s: f64, degree: i32, n: usize) -> Self {
        let p = f64::from(degree) - 2.0 - 2.0 * s;
        let weighted = [3.0, 2.0, 1.0].map(|k| gauss_jacobi(POWERS, 0.0, k + p).ok());
        let [plain, across, apart] = [n, 3 * n, n.min(10)].map(|n| gauss_legendre(n).unwrap());
        Self { s, degree, plain, across, apart, weighted }
    }

    fn p(&self) -> f64 {
        f64::from(self.degree) - 2.0 - 2.0 * self.s
    }

    fn kernel(&self, a: (Point, f64), b: (Point, f64)) -> f64 {
        let r2 = (a.0[0] - b.0[0]).powi(2) + (a.0[1] - b.0[1]).powi(2);
        (a.1 - b.1).powi(2) * r2.powf(-1.0 - self.s)
    }

    /// The integral over the unit square of both parameters, a quarter of the product of the areas taken out.
    fn pair(&self, w: &Values, i: usize, j: usize) -> f64 {
        let (a, b) = (w.mesh.triangles()[i], w.mesh.triangles()[j]);
        if i == j && w.degree == 0 {
            return 0.0;
        }
        let shared: Vec<usize> = a.iter().copied().filter(|node| b.contains(node)).collect();
        let sorted = |t: [usize; 3]| {
            let mut nodes = shared.clone();
            nodes.extend(t.iter().copied().filter(|node| !shared.contains(node)));
            nodes
        };
        let corners = |t: usize, nodes: Vec<usize>| -> Triangle {
            std::array::from_fn(|k| {
                let value = if w.degree == 0 { w.values[t] } else { w.values[nodes[k]] };
                (w.mesh.nodes()[nodes[k]], value)
            })
        };
        let (x, y) = (corners(i, sorted(a)), corners(j, sorted(b)));
        match shared.len() {
            3 => self.same(&x),
            2 => self.edge(&x, &y),
            1 => self.vertex(&x, &y),
            _ => self.apart(&x, &y),
        }
    }

    fn same(&self, t: &Triangle) -> f64 {
        let [first, second, third] = self.weighted.each_ref().map(|rule| rule.as_ref().unwrap());
        let mut sum = 0.0;
        for (xi, u) in first.iter() {
            for (a, v) in second.iter() {
                for (b, w) in third.iter() {
                    let scale = (xi * a * b).powf(-self.p());
                    for (c, q) in self.across.iter() {
                        let pairs = [
                            ([1.0, 1.0 - a + a * b], [1.0 - a * b * c, 1.0 - a]),
                            ([1.0, a * (1.0 - b + b * c)], [1.0 - a * b, a * (1.0 - b)]),
                            ([1.0 - a * b * c, a * (1.0 - b * c)], [1.0, a * (1.0 - b)]),
                        ];
                        let values = pairs.map(|(x, y)| self.kernel(at(t, x, xi), at(t, y, xi)));
                        sum += 2.0 * u * v * w * q * scale * values.iter().sum::<f64>();
                    }
                }
            }
        }
        sum
    }

    fn edge(&self, t: &Triangle, o: &Triangle) -> f64 {
        let [first, second, _] = self.weighted.each_ref().map(|rule| rule.as_ref());
        let mut sum = 0.0;
        for (xi, u) in first.unwrap().iter() {
            for (a, v) in second.unwrap().iter() {
                let scale = (xi * a).powf(-self.p());
                for (b, w) in self.across.iter() {
                    for (c, q) in self.across.iter() {
                        let pairs = [
                            ([1.0, a * c], [1.0 - a * b, a * (1.0 - b)], 1.0),
                            ([1.0, a], [1.0 - a * b * c, a * b * (1.0 - c)], b),
                            ([1.0 - a * b, a * (1.0 - b)], [1.0, a * b * c], b),
                            ([1.0 - a * b * c, a * b * (1.0 - c)], [1.0, a], b),
                            ([1.0 - a * b * c, a * (1.0 - b * c)], [1.0, a * b], b),
                        ];
                        let values = pairs.map(|(x, y, j)| j * self.kernel(at(t, x, xi), at(o, y, xi)));
                        sum += u * v * w * q * scale * values.iter().sum::<f64>();
                    }
                }
            }
        }
        sum
    }

    fn vertex(&self, t: &Triangle, o: &Triangle) -> f64 {
        let mut sum = 0.0;
        for (xi, u) in self.weighted[0].as_ref().unwrap().iter() {
            let scale = xi.powf(-self.p());
            for (a, v) in self.plain.iter() {
                for (b, w) in self.plain.iter() {
                    for (c, q) in self.plain.iter() {
                        let (near, far) = ([1.0, a], [b, b * c]);
                        let values = self.kernel(at(t, near, xi), at(o, far, xi))
                            + self.kernel(at(t, far, xi), at(o, near, xi));
                        sum += u * v * w * q * scale * b * values;
                    }
                }
            }
        }
        sum
    }

    fn apart(&self, t: &Triangle, o: &Triangle) -> f64 {
        let size = diameter(t).max(diameter(o));
        if distance(t, o) < size {
            let pieces = quarters(t);
            let others = quarters(o);
            let pairs = pieces.iter().flat_map(|t| others.iter().map(move |o| self.apart(t, o)));
            return pairs.sum::<f64>() / 16.0;
        }
        let places = |t: &Triangle| -> Vec<((Point, f64), f64)> {
            let pairs = self.apart.iter().flat_map(|x| self.apart.iter().map(move |y| (x, y)));
            pairs.map(|((x, v), (y, w))| (at(t, [x, x * y], 1.0), v * w * x)).collect()
        };
        let (first, second) = (places(t), places(o));
        first.iter().flat_map(|a| second.iter().map(|b| a.1 * b.1 * self.kernel(a.0, b.0))).sum()
    }
}

/// P₀ + ξ (x₁ (P₁ − P₀) + x₂ (P₂ − P₁)).
fn at(t: &Triangle, x: Point, xi: f64) -> (Point, f64) {
    let mix = |p: f64, q: f64, r: f64| p + xi * (x[0] * (q - p) + x[1] * (r - q));
    let place = std::array::from_fn(|k| mix(t[0].0[k], t[1].0[k], t[2].0[k]));
    (place, mix(t[0].1, t[1].1, t[2].1))
}

fn diameter(t: &Triangle) -> f64 {
    let side = |i: usize, j: usize| (t[i].0[0] - t[j].0[0]).hypot(t[i].0[1] - t[j].0[1]);
    side(0, 1).max(side(1, 2)).max(side(2, 0))
}

/// Distance of the centres less both radii.
fn distance(t: &Triangle, o: &Triangle) -> f64 {
    let centre = |t: &Triangle| [0, 1].map(|k| (t[0].0[k] + t[1].0[k] + t[2].0[k]) / 3.0);
    let (c, d) = (centre(t), centre(o));
    let radius =
        |t: &Triangle, c: Point| t.iter().map(|p| (p.0[0] - c[0]).hypot(p.0[1] - c[1])).fold(0.0, f64::max);
    (c[0] - d[0]).hypot(c[1] - d[1]) - radius(t, c) - radius(o, d)
}

fn quarters(t: &Triangle) -> [Triangle; 4] {
    let middle = |i: usize, j: usize| {
        let half = |a: f64, b: f64| 0.5 * (a + b);
        ([0, 1].map(|k| half(t[i].0[k], t[j].0[k])), half(t[i].1, t[j].1))
    };
    let [a, b, c] = [middle(0, 1), middle(1, 2), middle(2, 0)];
    [[t[0], a, c], [a, t[1], b], [c, b, t[2]], [a, b, c]]
}
