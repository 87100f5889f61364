//! Complementary data on the fine edge of a strip: u_N ≤ 0 and λ = −σ_N ≥ 0 with λ u_N = 0.
//!
//! On a fine edge of N cells with operator A (of a strip, or of the continuous harmonic problem), every such pair
//! (u_N, λ) solves the contact problem with the edge load b = A u_N + λ. [`crate::problems`] constructs pairs of
//! given regularity.

use super::sides::LateralCondition;
use crate::error::{Error, Result};
use crate::numeric::check::require_values;
use crate::text::pairs;

/// Complementary data (u_N, λ) at the nodes of a fine grid on the contact edge.
///
/// Values and forces are ordered by x = i/n, n the number of cells; there are n + 1 of them with natural sides, n
/// with periodic sides. The forces are λ_i = −∫ σ_N φ_i, φ_i the hat functions, so that Σ_i λ_i is the total contact
/// force.
///
/// ```
/// use signorini::{cone::Cone, strip::{EdgeData, LateralCondition, Strip}};
/// let (values, forces) = (vec![0.0, 0.0, 0.0, -0.1, -0.2], vec![0.3, 0.2, 0.1, 0.0, 0.0]);
/// let data = EdgeData::new(4, LateralCondition::Natural, &values, &forces)?;
/// // the load A u_N + λ has the pair as its contact solution
/// let strip = Strip::scalar(4, 4)?;
/// let held = strip.operator().apply(data.values())?;
/// let load: Vec<f64> = held.iter().zip(data.forces()).map(|(a, b)| a + b).collect();
/// let found = strip.operator().solve_contact(&load, Cone::Nodal, None, 1e-13)?;
/// assert!(found.values.iter().zip(data.values()).all(|(a, b)| (a - b).abs() < 1e-12));
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct EdgeData {
    cells: usize,
    sides: LateralCondition,
    values: Vec<f64>,
    forces: Vec<f64>,
    regularity: Option<f64>,
}

impl EdgeData {
    /// The pair of u_N = `values` ≤ 0 and nodal forces λ = `forces` ≥ 0 at the nodes of an edge of `cells` cells.
    ///
    /// ```
    /// use signorini::strip::{EdgeData, LateralCondition};
    /// let pair = |forces: [f64; 3]| EdgeData::new(2, LateralCondition::Natural, &[0.0, -1.0, 0.0], &forces);
    /// // λ u_N = 0 at every node
    /// assert!(pair([1.0, 0.0, 2.0]).is_ok() && pair([1.0, 0.5, 2.0]).is_err());
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) as for
    /// [`LateralCondition::check_cells`];
    /// [`ToolkitError::LengthMismatch`](crate::ToolkitError::LengthMismatch),
    /// [`ToolkitError::NotFinite`](crate::ToolkitError::NotFinite);
    /// [`ToolkitError::OutOfRange`](crate::ToolkitError::OutOfRange) for a wrong sign;
    /// [`Error::NotComplementary`] if both are nonzero at a node; [`Error::EmptyContact`] if u_N < 0 at all
    /// nodes.
    pub fn new(
        cells: usize,
        sides: LateralCondition,
        values: &[f64],
        forces: &[f64],
    ) -> Result<Self> {
        sides.check_cells(cells)?;
        for (name, field) in [("u_N", values), ("lambda", forces)] {
            require_values(name, field, sides.nodes(cells))?;
        }
        for (node, (&value, &force)) in values.iter().zip(forces).enumerate() {
            require_complementary(node, value, force)?;
        }
        if values.iter().all(|&v| v != 0.0) {
            return Err(Error::EmptyContact { nodes: values.len() });
        }
        Ok(Self {
            cells,
            sides,
            values: values.to_vec(),
            forces: forces.to_vec(),
            regularity: None,
        })
    }

    /// The same data, declared to be of regularity `tau`.
    ///
    /// The value is stored for convergence rates; it is neither checked nor used in computations.
    pub fn with_regularity(self, tau: f64) -> Self {
        Self { regularity: Some(tau), ..self }
    }

    /// The pair of u_N and the density λ read from text: one line per node, two numbers per line, `#` starts a
    /// comment, empty lines are skipped. The number of nodes is 2^k + 1 with natural sides and 2^k with
    /// periodic sides, k ≥ 1.
    ///
    /// Numbers are separated by blanks or commas. The density is integrated by the trapezoidal rule: λ_i is
    /// the density at node i divided by n, half of it at an end with natural sides.
    ///
    /// ```
    /// use signorini::strip::{EdgeData, LateralCondition};
    /// let data = EdgeData::from_samples("# u_N, density\n0 2\n0 2\n-1 0\n", LateralCondition::Natural)?;
    /// assert_eq!((data.cells(), data.forces()), (2, &[0.5, 1.0, 0.0][..]));
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Syntax`] with the line that does not contain two numbers, [`Error::AtLine`] with the line that is not
    /// an admissible pair; [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) for the number of
    /// lines; and as for [`EdgeData::new`].
    pub fn from_samples(text: &str, sides: LateralCondition) -> Result<Self> {
        let rows = pairs(text, "samples")?;
        for (node, &(line, [value, density])) in rows.iter().enumerate() {
            require_complementary(node, value, density).map_err(|cause| Error::AtLine {
                format: "samples",
                line,
                cause: Box::new(cause),
            })?;
        }
        let (values, densities): (Vec<f64>, Vec<f64>) =
            rows.iter().map(|&(_, [u, force])| (u, force)).unzip();
        let (cells, range) = match sides {
            LateralCondition::Natural => (values.len().saturating_sub(1), "{2^k + 1: k >= 1}"),
            LateralCondition::Periodic => (values.len(), "{2^k: k >= 1}"),
        };
        let is_power = cells.is_power_of_two() && cells >= 2;
        Error::require_count("lines of samples", values.len(), range, is_power)?;
        let forces = (0..densities.len())
            .map(|i| {
                let at_side = sides == LateralCondition::Natural && (i == 0 || i == cells);
                densities[i] * if at_side { 0.5 } else { 1.0 } / cells as f64
            })
            .collect::<Vec<_>>();
        Self::new(cells, sides, &values, &forces)
    }

    /// Number of cells of the grid on the edge.
    pub fn cells(&self) -> usize {
        self.cells
    }

    /// The lateral conditions.
    pub fn sides(&self) -> LateralCondition {
        self.sides
    }

    /// The normal displacement u_N at the nodes.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// The contact forces λ at the nodes.
    pub fn forces(&self) -> &[f64] {
        &self.forces
    }

    /// The regularity τ declared by [`EdgeData::with_regularity`]; `None` if there is none.
    pub fn regularity(&self) -> Option<f64> {
        self.regularity
    }

    /// Number of non-contact intervals: maximal sets of consecutive nodes with u_N < 0.
    ///
    /// With periodic sides a non-contact interval through x = 0 is counted once.
    ///
    /// ```
    /// use signorini::strip::{EdgeData, LateralCondition};
    /// let gaps = |sides, values: &[f64]| EdgeData::new(4, sides, values, &vec![0.0; values.len()]);
    /// assert_eq!(gaps(LateralCondition::Natural, &[-1.0, 0.0, 0.0, 0.0, -1.0])?.gaps(), 2);
    /// assert_eq!(gaps(LateralCondition::Periodic, &[-1.0, 0.0, 0.0, -1.0])?.gaps(), 1);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    pub fn gaps(&self) -> usize {
        let open = |i: usize| self.values[i] < 0.0;
        let inner = (1..self.values.len()).filter(|&i| open(i) && !open(i - 1)).count();
        let first_is_new = self.sides == LateralCondition::Natural || !open(self.values.len() - 1);
        inner + usize::from(open(0) && first_is_new)
    }
}

/// Checks that u_N ≤ 0 and λ ≥ 0, and that one of them is 0.
fn require_complementary(node: usize, value: f64, force: f64) -> Result<()> {
    Error::require("u_N", value, "(-inf, 0]", value <= 0.0)?;
    Error::require("lambda", force, "[0, inf)", force >= 0.0)?;
    let is_pair = value == 0.0 || force == 0.0;
    if is_pair { Ok(()) } else { Err(Error::NotComplementary { node, value, force }) }
}
