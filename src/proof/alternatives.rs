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
//! contact, nothing to estimate) to the first.
//!
//! "Within" is strict and "on a piece" is up to single points, as measure zero does not matter for σ_N in L².

use super::section::Section;
use super::theta::checked_theta;
use crate::edge::{EdgeTrace, Interval, SegmentNorms};
use crate::error::Result;

/// Which cases hold on a segment; at least one does.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Alternative {
    /// The first case holds.
    pub first: bool,
    /// The second case holds.
    pub second: bool,
}

/// What is said of a segment: one case, the other, or both.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Case {
    /// The first only.
    First,
    /// The second only.
    Second,
    /// Both.
    Both,
    /// None: would contradict the paper.
    Neither,
}

impl Alternative {
    /// The cases that hold on a segment of length h with these norms. Section 3: zeros of u_N nearer than h θ to both
    /// vertices; σ_N = 0 on a length of at least h θ at a vertex. Section 4: diam C_T ≤ h θ, where an empty C_T
    /// counts as 0; diam C_T ≥ h θ for a set that is not empty.
    pub fn of_norms(section: Section, norms: &SegmentNorms, theta: f64) -> Self {
        let reach = norms.length * theta;
        match section {
            Section::Three => Self {
                first: norms.zero_distance.is_some_and(|d| d.iter().all(|&d| d < reach)),
                second: norms.free_length >= reach,
            },
            Section::Four => Self {
                first: norms.contact_diameter().is_none_or(|d| d <= reach),
                second: norms.contact_diameter().is_some_and(|d| d >= reach),
            },
        }
    }

    /// Which cases hold, as one value.
    pub fn case(&self) -> Case {
        match (self.first, self.second) {
            (true, true) => Case::Both,
            (true, false) => Case::First,
            (false, true) => Case::Second,
            (false, false) => Case::Neither,
        }
    }
}

/// The alternative of Section 3, by zeros near both vertices.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NearVertices {
    theta: f64,
}

impl NearVertices {
    /// # Errors
    /// [`ToolkitError::OutOfRange`](crate::ToolkitError::OutOfRange) unless 0 < θ < 1.
    pub fn new(theta: f64) -> Result<Self> {
        checked_theta(theta).map(|theta| Self { theta })
    }

    /// The cases that hold on `segment`.
    pub fn classify(&self, trace: &EdgeTrace, segment: Interval) -> Alternative {
        let reach = segment.length() * self.theta;
        let near_start = trace.contact_in(segment).next().is_some_and(|c| c.start - segment.start < reach);
        let near_end = trace.contact_in(segment).next_back().is_some_and(|c| segment.end - c.end < reach);
        let start_piece = Interval { start: segment.start, end: segment.start + reach };
        let end_piece = Interval { start: segment.end - reach, end: segment.end };
        Alternative {
            first: near_start && near_end,
            second: is_unpressed(trace, start_piece) || is_unpressed(trace, end_piece),
        }
    }
}

/// σ_N = 0 almost everywhere on the piece, and no single node inside it carries a force.
fn is_unpressed(trace: &EdgeTrace, piece: Interval) -> bool {
    trace
        .pressed_in(piece)
        .all(|common| common.length() == 0.0 && (common.start <= piece.start || common.end >= piece.end))
}

/// The alternative of Section 4, by the diameter of the contact set of the segment.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SetDiameter {
    theta: f64,
}

impl SetDiameter {
    /// # Errors
    /// [`ToolkitError::OutOfRange`](crate::ToolkitError::OutOfRange) unless 0 < θ < 1.
    pub fn new(theta: f64) -> Result<Self> {
        checked_theta(theta).map(|theta| Self { theta })
    }

    /// diam C_T; zero when C_T is empty or one point.
    pub fn diameter(trace: &EdgeTrace, segment: Interval) -> f64 {
        let mut zeros = trace.contact_in(segment);
        let Some(first) = zeros.next() else { return 0.0 };
        zeros.next_back().unwrap_or(first).end - first.start
    }

    /// The cases that hold on `segment`.
    pub fn classify(&self, trace: &EdgeTrace, segment: Interval) -> Alternative {
        let (diameter, limit) = (Self::diameter(trace, segment), segment.length() * self.theta);
        Alternative { first: diameter <= limit, second: diameter >= limit }
    }
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
        let quarter = NearVertices::new(0.25).unwrap();
        let cases = [
            (vec![(0.0, 1.0)], Case::First),
            (vec![], Case::Second),
            (vec![(0.0, 0.5)], Case::Second),
            (vec![(0.1, 0.9)], Case::First),
            (vec![(0.0, 0.0), (1.0, 1.0)], Case::Both),
            (vec![(0.5, 0.5)], Case::Second),
            (vec![(0.3, 1.0)], Case::Second),
            (vec![(0.2, 1.0)], Case::First),
            (vec![(0.0, 0.0)], Case::Second),
        ];
        for (contact, expected) in cases {
            assert_eq!(quarter.classify(&trace(&contact), SEGMENT).case(), expected, "{contact:?}");
        }
    }

    #[test]
    fn section_4_compares_the_diameter() {
        let half = SetDiameter::new(0.5).unwrap();
        let cases = [
            (vec![], Case::First),
            (vec![(0.5, 0.5)], Case::First),
            (vec![(0.2, 0.3), (0.5, 0.6)], Case::First),
            (vec![(0.0, 0.5)], Case::Both),
            (vec![(0.0, 0.0), (1.0, 1.0)], Case::Second),
            (vec![(0.0, 1.0)], Case::Second),
        ];
        for (contact, expected) in cases {
            assert_eq!(half.classify(&trace(&contact), SEGMENT).case(), expected, "{contact:?}");
        }
    }

    #[test]
    fn theta_outside_zero_and_one_is_refused() {
        assert!(NearVertices::new(1.0).is_err() && SetDiameter::new(f64::NAN).is_err());
    }
}
