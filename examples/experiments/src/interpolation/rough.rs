//! Families of rough slopes with a fixed seed, to try an inequality on functions nobody has chosen to please
//! it.

use crate::SplitMix;
use fractional_sobolev::Result;
use fractional_sobolev::{Function, Mesh, Order};
use std::f64::consts::PI;

/// Nodes of a sampled Weierstrass sum: three for the shortest wave kept.
const WEIERSTRASS_CELLS: usize = 48;

/// A family of rough slopes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RoughFamily {
    /// Random piecewise linears on geometric meshes.
    Linears,
    /// Random steps on geometric meshes, for ν < 1/2.
    Steps,
    /// Sampled Weierstrass sums barely in H^ν.
    Weierstrass,
}

impl RoughFamily {
    /// The families with members in H^ν.
    pub fn admissible(order: Order) -> Vec<Self> {
        let mut families = vec![Self::Linears, Self::Weierstrass];
        if order.offset() < 0.0 {
            families.push(Self::Steps);
        }
        families
    }
}

/// Where the mesh of a random slope is refined; each with one chance in three.
enum Grading {
    BothEnds,
    InnerPoint,
    LeftEnd,
}

impl Grading {
    /// By a number uniform in [0, 1).
    fn of(chance: f64) -> Self {
        if chance < 1.0 / 3.0 {
            Self::BothEnds
        } else if chance < 2.0 / 3.0 {
            Self::InnerPoint
        } else {
            Self::LeftEnd
        }
    }
}

/// An endless sequence of slopes on (0, 1).
///
/// # Method
///
/// | family | slope v | domain |
/// | --- | --- | --- |
/// | [`RoughFamily::Linears`] | random piecewise linear on a graded mesh | 0 < ν < 1 |
/// | [`RoughFamily::Steps`] | piecewise constant on such a mesh | ν < 1/2 |
/// | [`RoughFamily::Weierstrass`] | Σ b^{-sk} cos(b^k π x + φ_k), s just above ν, at 49 nodes | 0 < ν < 1 |
///
/// Graded meshes are geometric to one end, to both, or to an inner point as well.
/// The numbers are those of SplitMix64: the same on every machine.
///
/// ```
/// use experiments::interpolation::{InterpolationError, RoughFamily, RoughSlopes};
/// use fractional_sobolev::{Order, Tolerance};
/// let order = Order::HALF;
/// assert!(!RoughFamily::admissible(order).contains(&RoughFamily::Steps)); // steps are not in H^{1/2}
/// let slope = RoughSlopes::new(RoughFamily::Linears, order, 7).draw()?;
/// let found = InterpolationError::of_slope(&slope, order, Tolerance::fast())?;
/// assert!(found.derivative_ratio()?.value < 0.2916);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct RoughSlopes {
    family: RoughFamily,
    order: Order,
    numbers: SplitMix,
}

impl RoughSlopes {
    /// The sequence of a family with a seed.
    pub fn new(family: RoughFamily, order: Order, seed: u64) -> Self {
        Self { family, order, numbers: SplitMix::new(seed) }
    }

    /// The next slope.
    ///
    /// # Errors
    /// None for the parameters drawn here; those of [`Mesh`] and [`Function`] are passed on.
    pub fn draw(&mut self) -> Result<Function<'static>> {
        match self.family {
            RoughFamily::Linears => {
                let (partition, singular) = self.mesh()?;
                let values = self.values(&partition.nodes(), singular);
                Function::linears(&partition, &values)
            }
            RoughFamily::Steps => {
                let (partition, singular) = self.mesh()?;
                let nodes = partition.nodes();
                let centres: Vec<f64> = nodes.windows(2).map(|pair| 0.5 * (pair[0] + pair[1])).collect();
                let values = self.values(&centres, singular);
                Function::piecewise(&partition, 0, &values)
            }
            RoughFamily::Weierstrass => self.weierstrass(),
        }
    }

    /// A mesh with 1 to 10 layers towards both ends, or towards an inner point as well.
    fn mesh(&mut self) -> Result<(Mesh, f64)> {
        let layers = 1 + (self.numbers.uniform() * 10.0) as usize;
        let ratio = 0.1 + 0.7 * self.numbers.uniform();
        let inner = 0.1 + 0.8 * self.numbers.uniform();
        Ok(match Grading::of(self.numbers.uniform()) {
            Grading::BothEnds => (Mesh::graded(&[0.0, 1.0], layers, ratio)?, 0.0),
            Grading::InnerPoint => (Mesh::graded(&[0.0, inner, 1.0], layers, ratio)?, inner),
            Grading::LeftEnd => (Mesh::geometric(2 * layers, ratio, 1.0)?, 0.0),
        })
    }

    /// Random numbers times |x − x₀|^a, a between ν − 1/2 and 1: from noise to a smooth trend, some with a
    /// trend added.
    fn values(&mut self, points: &[f64], singular: f64) -> Vec<f64> {
        let exponent = self.order.offset() + (1.0 - self.order.offset()) * self.numbers.uniform();
        let shortest = points.windows(2).map(|pair| pair[1] - pair[0]).fold(1.0, f64::min);
        let trend = 4.0 * self.numbers.uniform();
        points
            .iter()
            .map(|&x| {
                let distance = (x - singular).abs().max(0.5 * shortest);
                trend * (x - 0.5) + (2.0 * self.numbers.uniform() - 1.0) * distance.powf(exponent)
            })
            .collect()
    }

    fn weierstrass(&mut self) -> Result<Function<'static>> {
        let base = 1.3 + 2.0 * self.numbers.uniform();
        let decay = self.order.value() + 0.2 * self.numbers.uniform();
        let highest = WEIERSTRASS_CELLS as f64 / 3.0;
        let mut waves = Vec::new();
        let mut frequency = 1.0;
        while frequency <= highest {
            waves.push((frequency * PI, frequency.powf(-decay), 2.0 * PI * self.numbers.uniform()));
            frequency *= base;
        }
        let partition = Mesh::uniform(WEIERSTRASS_CELLS, 1.0)?;
        Function::interpolate(&partition, 1, |x| {
            waves.iter().map(|&(omega, amplitude, phase)| amplitude * (omega * x + phase).cos()).sum()
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_same_seed_gives_the_same_functions() {
        let order = Order::new(0.3).unwrap();
        for family in RoughFamily::admissible(order) {
            let draw = |seed: u64| format!("{:?}", RoughSlopes::new(family, order, seed).draw().unwrap());
            assert_eq!(draw(7), draw(7));
            assert_ne!(draw(7), draw(8));
            let mut slopes = RoughSlopes::new(family, order, 1);
            for _ in 0..200 {
                let slope = slopes.draw().unwrap();
                assert!((slope.mesh().unwrap().total() - 1.0).abs() < 1e-14);
            }
        }
    }
}
