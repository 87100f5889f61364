//! A strip with n × m cells, scalar or elastic: its edge operator, and volume loads condensed to the edge.

use super::operator::edge::EdgeOperator;
use super::operator::elastic::ElasticStrip;
use super::operator::scalar::ScalarStrip;
use crate::error::Result;
use crate::fem::Lame;

/// A strip of height m/n with n × m cells, n along the contact edge, held at the top.
///
/// ```
/// use signorini::{cone::Cone, strip::Strip};
/// let strip = Strip::scalar(64, 64)?;
/// let (force, constant) = strip.condense(|x, _| [(6.0 * x).cos() + 0.3, 0.0])?;
/// let solution = strip.operator().solve_contact(&force, Cone::Nodal, None, 1e-13)?;
/// // min J, and λ u_N = 0
/// assert!(solution.energy + constant < constant && solution.kkt.worst() < 1e-12);
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Strip(Kind);

#[derive(Debug, Clone)]
enum Kind {
    Scalar(ScalarStrip),
    Elastic(ElasticStrip),
}

impl Strip {
    /// Laplace's equation, natural sides.
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) for n < 2 or m = 0.
    pub fn scalar(cells: usize, layers: usize) -> Result<Self> {
        Ok(Self(Kind::Scalar(ScalarStrip::new(cells, layers)?)))
    }

    /// Elasticity of one material, periodic sides.
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) for an odd n or an m that is not a power of two.
    pub fn elastic(cells: usize, layers: usize, lame: Lame) -> Result<Self> {
        Ok(Self(Kind::Elastic(ElasticStrip::new(cells, layers, lame)?)))
    }

    /// The edge operator A; elastic: that of the normal displacement, the tangential one condensed.
    pub fn operator(&self) -> &EdgeOperator {
        match &self.0 {
            Kind::Scalar(strip) => strip.operator(),
            Kind::Elastic(strip) => strip.operator(),
        }
    }

    /// Unknowns of the two-dimensional problem this stands for: (n + 1) m scalar, 2 n m elastic.
    pub fn unknowns(&self) -> f64 {
        match &self.0 {
            Kind::Scalar(strip) => strip.virtual_unknowns(),
            Kind::Elastic(strip) => strip.virtual_unknowns(),
        }
    }

    /// b and c of J(g) = ½ g'A g − b'g + c under the load ∫ f_h·v, f_h the nodal interpolant of f (scalar: of its
    /// first entry), consistent P1 mass matrix: nodal forces on the edge, and the energy of the interior with the edge
    /// held. Cost: O(n m log n).
    ///
    /// # Errors
    /// [`ToolkitError::NotFinite`](crate::ToolkitError::NotFinite) when f is not finite at a node.
    pub fn condense(&self, f: impl Fn(f64, f64) -> [f64; 2]) -> Result<(Vec<f64>, f64)> {
        match &self.0 {
            Kind::Scalar(strip) => strip.condense(|x, y| f(x, y)[0]),
            Kind::Elastic(strip) => strip.condense(f),
        }
    }
}
