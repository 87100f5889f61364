//! The two alternatives on a contact segment (Figures 3.2 and 4.1).
//!
//! Let T ∩ Γ_C = [a, b], h_e = b − a, 0 < θ < 1.
//!
//! Section 3 (K^h): *first case* when u_N has a zero within h_e θ of **both** vertices; *second case* when
//! σ_N = 0 on a piece of length h_e θ at one vertex. Every segment is in at least one case: without a zero
//! near a vertex, u_N < 0 on that piece, hence σ_N = 0 there. A segment may be in both.
//!
//! Section 4 (midpoint cone): C_T = {u_N = 0} ∩ [a, b]; *first case* when diam C_T ≤ h_e θ, *second case*
//! when diam C_T ≥ h_e θ. The paper leaves equality open; here it belongs to both, and the empty C_T (no
//! contact) to the first.
//!
//! "Within" is strict and "on a piece" is up to single points, as measure zero does not matter for σ_N in L².

use super::section::Section;
use super::theta::checked_theta;
use crate::edge::{EdgeTrace, Interval, SegmentNorms};
use crate::error::Result;

/// The cases that hold on a segment; at least one does.
///
/// ```
/// use signorini::edge::{EdgeTrace, Interval};
/// use signorini::proof::{Alternative, Section};
/// let trace = EdgeTrace::new(vec![0.0, 0.5, 1.0], vec![0.0, 0.0, -1.0], vec![1.0, 1.0, 0.0], 0.0)?;
/// let segment = Interval { start: 0.0, end: 1.0 };
/// // diam C_T = 1/2 against h θ = 3/4 and 1/4.
/// assert_eq!(Alternative::on_segment(Section::Four, &trace, segment, 0.75)?, Alternative::First);
/// assert_eq!(Alternative::on_segment(Section::Four, &trace, segment, 0.25)?, Alternative::Second);
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Alternative {
    /// The first case only.
    First,
    /// The second case only.
    Second,
    /// Both cases.
    Both,
    /// No case, which would contradict the paper.
    Neither,
}

impl Alternative {
    fn new(first: bool, second: bool) -> Self {
        match (first, second) {
            (true, true) => Alternative::Both,
            (true, false) => Alternative::First,
            (false, true) => Alternative::Second,
            (false, false) => Alternative::Neither,
        }
    }

    /// The first case holds, alone or with the second.
    pub fn first(self) -> bool {
        matches!(self, Alternative::First | Alternative::Both)
    }

    /// The second case holds, alone or with the first.
    pub fn second(self) -> bool {
        matches!(self, Alternative::Second | Alternative::Both)
    }

    /// The cases that hold on a segment of length h with these norms. Section 3: zeros of u_N nearer than h θ to both
    /// vertices; σ_N = 0 on a length of at least h θ at a vertex. Section 4: diam C_T ≤ h θ, where an empty C_T
    /// counts as 0; diam C_T ≥ h θ for a set that is not empty.
    pub fn of_norms(section: Section, norms: &SegmentNorms, theta: f64) -> Self {
        let reach = norms.length * theta;
        match section {
            Section::Three => Self::new(
                norms.zero_distance.is_some_and(|d| d.iter().all(|&d| d < reach)),
                norms.free_length >= reach,
            ),
            Section::Four => Self::new(
                norms.contact_diameter().is_none_or(|d| d <= reach),
                norms.contact_diameter().is_some_and(|d| d >= reach),
            ),
        }
    }

    /// The cases that hold on a segment of the edge, by the zeros of u_N and the support of σ_N of the trace.
    /// Section 3: zeros of u_N nearer than h θ to both vertices; no force on a piece of length h θ at a vertex.
    /// Section 4: the diameter of the contact set of the segment, 0 for the empty set, against h θ.
    ///
    /// # Errors
    /// [`ToolkitError::OutOfRange`](crate::ToolkitError::OutOfRange) unless 0 < θ < 1.
    pub fn on_segment(section: Section, trace: &EdgeTrace, segment: Interval, theta: f64) -> Result<Self> {
        let reach = segment.length() * checked_theta(theta)?;
        Ok(match section {
            Section::Three => Self::near_vertices(trace, segment, reach),
            Section::Four => {
                let diameter = set_diameter(trace, segment);
                Self::new(diameter <= reach, diameter >= reach)
            }
        })
    }

    fn near_vertices(trace: &EdgeTrace, segment: Interval, reach: f64) -> Self {
        let near_start = trace.contact_in(segment).next().is_some_and(|c| c.start - segment.start < reach);
        let near_end = trace.contact_in(segment).next_back().is_some_and(|c| segment.end - c.end < reach);
        let start_piece = Interval { start: segment.start, end: segment.start + reach };
        let end_piece = Interval { start: segment.end - reach, end: segment.end };
        Self::new(near_start && near_end, is_unpressed(trace, start_piece) || is_unpressed(trace, end_piece))
    }
}

/// σ_N = 0 almost everywhere on the piece, and no single node inside it carries a force.
fn is_unpressed(trace: &EdgeTrace, piece: Interval) -> bool {
    trace
        .pressed_in(piece)
        .all(|common| common.length() == 0.0 && (common.start <= piece.start || common.end >= piece.end))
}

/// diam C_T; zero when C_T is empty or one point.
fn set_diameter(trace: &EdgeTrace, segment: Interval) -> f64 {
    let mut zeros = trace.contact_in(segment);
    let Some(first) = zeros.next() else { return 0.0 };
    zeros.next_back().unwrap_or(first).end - first.start
}

#[cfg(test)]
mod tests {
    use super::*;

    const SEGMENT: Interval = Interval { start: 0.0, end: 1.0 };

    /// A trace on 21 nodes of [0, 1] that is in contact, and pressed, exactly on the given intervals.
    fn trace(contact: &[(f64, f64)]) -> EdgeTrace {
        let nodes: Vec<f64> = (0..=20).map(|i| f64::from(i) / 20.0).collect();
        let inside = |x: f64| contact.iter().any(|&(a, b)| x >= a && x <= b);
        let displacement = nodes.iter().map(|&x| if inside(x) { 0.0 } else { -1.0 }).collect();
        let force = nodes.iter().map(|&x| if inside(x) { 1.0 } else { 0.0 }).collect();
        EdgeTrace::new(nodes, displacement, force, 1e-12).unwrap()
    }

    #[test]
    fn section_3_names_the_cases_of_figure_3_2() {
        let cases = [
            (vec![(0.0, 1.0)], Alternative::First),
            (vec![], Alternative::Second),
            (vec![(0.0, 0.5)], Alternative::Second),
            (vec![(0.1, 0.9)], Alternative::First),
            (vec![(0.0, 0.0), (1.0, 1.0)], Alternative::Both),
            (vec![(0.5, 0.5)], Alternative::Second),
            (vec![(0.3, 1.0)], Alternative::Second),
            (vec![(0.2, 1.0)], Alternative::First),
            (vec![(0.0, 0.0)], Alternative::Second),
        ];
        for (contact, expected) in cases {
            let found = Alternative::on_segment(Section::Three, &trace(&contact), SEGMENT, 0.25);
            assert_eq!(found.unwrap(), expected, "{contact:?}");
        }
    }

    #[test]
    fn section_4_compares_the_diameter() {
        let cases = [
            (vec![], Alternative::First),
            (vec![(0.5, 0.5)], Alternative::First),
            (vec![(0.2, 0.3), (0.5, 0.6)], Alternative::First),
            (vec![(0.0, 0.5)], Alternative::Both),
            (vec![(0.0, 0.0), (1.0, 1.0)], Alternative::Second),
            (vec![(0.0, 1.0)], Alternative::Second),
        ];
        for (contact, expected) in cases {
            let found = Alternative::on_segment(Section::Four, &trace(&contact), SEGMENT, 0.5);
            assert_eq!(found.unwrap(), expected, "{contact:?}");
        }
    }

    #[test]
    fn theta_outside_zero_and_one_is_refused() {
        for (section, theta) in [(Section::Three, 1.0), (Section::Four, f64::NAN)] {
            assert!(Alternative::on_segment(section, &trace(&[]), SEGMENT, theta).is_err());
        }
    }
}
