//! The two discrete cones.

use crate::error::{Error, Result, ToolkitError};
use std::fmt;
use std::str::FromStr;

/// The discrete noninterpenetration condition: the cone K^h (nodal) or K̄^h (midpoint) that approximates K.
///
/// K^h ⊂ K for g affine on every segment, because u_N is piecewise affine there; K̄^h ⊃ K^h is not contained in K:
/// u_N may exceed g on at most half of a segment.
///
/// ```
/// use signorini::cone::{Cone, Ends};
/// // K^h is contained in the midpoint cone: means of values ≤ 0 are ≤ 0, but not conversely
/// let w = [-1.0, 0.5, -1.0];
/// let [nodal, midpoint] = Cone::ALL.map(|cone| cone.on(3, Ends::Open).apply(&w));
/// assert!(nodal.iter().any(|w| *w > 0.0) && midpoint.iter().all(|w| *w <= 0.0));
/// assert_eq!("midpoint".parse::<Cone>()?, Cone::Midpoint);
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Cone {
    /// K^h of (2.9): u_N ≤ g at every node of the contact edge, end nodes included.
    #[default]
    Nodal,
    /// The cone of (4.1): the mean of u_N − g over every contact segment is ≤ 0.
    Midpoint,
}

impl Cone {
    /// Both cones, in the order of the paper.
    pub const ALL: [Cone; 2] = [Cone::Nodal, Cone::Midpoint];
}

impl fmt::Display for Cone {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Cone::Nodal => "nodal",
            Cone::Midpoint => "midpoint",
        })
    }
}

impl FromStr for Cone {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        match text {
            "nodal" => Ok(Cone::Nodal),
            "midpoint" => Ok(Cone::Midpoint),
            _ => Err(Error::Toolkit(ToolkitError::UnknownName {
                what: "cone",
                given: text.to_owned(),
                expected: "nodal or midpoint",
            })),
        }
    }
}
