//! Rough slopes from a fixed seed, and the functions that have them, for the tests of Lemmas 6.1 and 6.2.

use fractional_sobolev::{Function, Mesh, Order};

/// The function with u(0) = 0 and this slope, given by nodal values: linear between nodes (`jumps` false), or constant
/// on each element.
#[allow(dead_code, reason = "sections 3 and 4 need the numbers alone")]
pub fn primitive(mesh: &Mesh, slope: &[f64], jumps: bool) -> Function<'static> {
    let (mut u, mut values) = (0.0, Vec::new());
    for (k, &h) in mesh.lengths().iter().enumerate() {
        let [a, b] = [slope[k], if jumps { slope[k] } else { slope[k + 1] }];
        values.extend([u, u + h * (3.0 * a + b) / 8.0, u + h * (a + b) / 2.0]);
        u += h * (a + b) / 2.0;
    }
    Function::piecewise(mesh, 2, &values).unwrap()
}

/// Numbers in (0, 1), the same on every machine.
pub struct Numbers(pub u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 * 2f64.powi(-53)
    }

    /// A mesh refined towards one end, both ends or an inner point, and values at its nodes: noise times a power of the
    /// distance to that point, with a trend or without.
    pub fn rough(&mut self, nu: Order) -> (Mesh, Vec<f64>) {
        let (layers, ratio) = (1 + (10.0 * self.next()) as usize, 0.1 + 0.7 * self.next());
        let inner = 0.1 + 0.8 * self.next();
        let (mesh, singular) = match (3.0 * self.next()) as usize {
            0 => (Mesh::graded(&[0.0, 1.0], layers, ratio).unwrap(), 0.0),
            1 => (Mesh::graded(&[0.0, inner, 1.0], layers, ratio).unwrap(), inner),
            _ => (Mesh::geometric(2 * layers, ratio, 1.0).unwrap(), 0.0),
        };
        let power = nu.offset() + (1.0 - nu.offset()) * self.next();
        let shortest = mesh.lengths().iter().copied().fold(1.0, f64::min);
        let (trend, size) = (4.0 * self.next(), 10f64.powf(-3.0 * self.next()));
        let value = |x: &f64| {
            let distance = (x - singular).abs().max(0.5 * shortest);
            trend * (x - 0.5) + size * (2.0 * self.next() - 1.0) * distance.powf(power)
        };
        let values = mesh.nodes().iter().map(value).collect();
        (mesh, values)
    }

    /// A sampled Weierstrass sum, barely in H^ν.
    pub fn waves(&mut self, nu: Order) -> (Mesh, Vec<f64>) {
        let (base, decay) = (1.3 + 2.0 * self.next(), nu.value() + 0.2 * self.next());
        let mesh = Mesh::uniform(48, 1.0).unwrap();
        let mut values = vec![0.0; 49];
        let mut frequency = 1.0f64;
        while frequency <= 16.0 {
            let phase = 2.0 * std::f64::consts::PI * self.next();
            for (value, x) in values.iter_mut().zip(mesh.nodes()) {
                *value +=
                    frequency.powf(-decay) * (std::f64::consts::PI * frequency * x + phase).cos();
            }
            frequency *= base;
        }
        (mesh, values)
    }
}
