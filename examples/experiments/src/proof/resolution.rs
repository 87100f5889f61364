//! How finely a pair is resolved.

use signorini::{Error, Result, ToolkitError};
use std::fmt;
use std::str::FromStr;

/// Fine cells of the pair.
///
/// A pair of regularity exactly τ has norms of order τ that grow like the root of a logarithm of the
/// resolution. With the same number of cells per segment on every mesh the norms of a segment scale without
/// that logarithm; with one grid for all meshes u is the same function for all of them and the logarithm
/// shows in the exponents.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Resolution {
    /// 2^k cells per segment on every mesh; the norms of the whole edge are those of the finest.
    Segment(u32),
    /// 2^k cells on the edge, for all meshes.
    Edge(u32),
}

impl Resolution {
    /// Cells of the edge for a mesh of n segments.
    pub(super) fn cells(self, n: usize) -> usize {
        match self {
            Resolution::Segment(k) => n << k,
            Resolution::Edge(k) => 1 << k,
        }
    }
}

impl fmt::Display for Resolution {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Resolution::Segment(k) => write!(f, "segment:{k}"),
            Resolution::Edge(k) => write!(f, "edge:{k}"),
        }
    }
}

impl FromStr for Resolution {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        let unknown = || {
            Error::Toolkit(ToolkitError::UnknownName {
                what: "resolution",
                given: text.to_owned(),
                expected: "segment:K (2^K cells per segment, K from 1 to 16) or edge:K (2^K cells in all, K up to 20)",
            })
        };
        let (name, power) = text.split_once(':').ok_or_else(unknown)?;
        match (name, power.parse()) {
            ("segment", Ok(k)) if (1..=16).contains(&k) => Ok(Resolution::Segment(k)),
            ("edge", Ok(k)) if (1..=20).contains(&k) => Ok(Resolution::Edge(k)),
            _ => Err(unknown()),
        }
    }
}
