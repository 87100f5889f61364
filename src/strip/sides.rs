//! The lateral conditions of the strip, and their numbers of nodes.

use crate::cone::Ends;
use crate::error::{Error, Result};

/// The lateral conditions at x = 0 and x = 1.
///
/// Modes at the nodes j/n of an edge of n cells: cos(θ_k j), θ_k = kπ/n, k = 0, ..., n with natural sides;
/// e^{iθ_k j}, θ_k = 2πk/n with periodic ones.
///
/// ```
/// use signorini::strip::LateralCondition::{Natural, Periodic};
/// assert_eq!((Natural.nodes(8), Periodic.nodes(8)), (9, 8));
/// // the even extension has twice the period
/// assert_eq!((Natural.period(8), Periodic.period(8)), (16, 8));
/// assert!(Periodic.check_cells(7).is_err() && Natural.check_cells(7).is_ok());
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum LateralCondition {
    /// No condition is imposed (homogeneous Neumann): n + 1 edge nodes.
    Natural,
    /// The sides are identified: n edge nodes.
    Periodic,
}

impl LateralCondition {
    /// Number of nodes on an edge of `cells` cells.
    pub fn nodes(self, cells: usize) -> usize {
        match self {
            LateralCondition::Natural => cells + 1,
            LateralCondition::Periodic => cells,
        }
    }

    /// Checks that there are at least two cells and at most 2^26, an even number with periodic sides.
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) otherwise.
    pub fn check_cells(self, cells: usize) -> Result<()> {
        let (admissible, range) = match self {
            LateralCondition::Natural => (cells >= 2, "[2, 2^26]"),
            LateralCondition::Periodic => {
                (cells >= 2 && cells.is_multiple_of(2), "{2, 4, 6, ..., 2^26}")
            }
        };
        Error::require_count("cells", cells, range, admissible && cells <= 1 << 26)
    }

    /// The ends of the edge for a contact cone: open or joined.
    pub(crate) fn ends(self) -> Ends {
        match self {
            LateralCondition::Natural => Ends::Open,
            LateralCondition::Periodic => Ends::Joined,
        }
    }

    /// The period of the (evenly extended) edge, in cells.
    ///
    /// P = 2n with natural sides, P = n with periodic ones: the length of the Fourier transforms.
    pub fn period(self, cells: usize) -> usize {
        match self {
            LateralCondition::Natural => 2 * cells,
            LateralCondition::Periodic => cells,
        }
    }
}
