//! Every contact segment of a coarse mesh, its cases, and its contribution to the consistency term.

use super::alternatives::Alternative;
use super::section::Section;
use super::theta::checked_theta;
use crate::edge::{EdgeTrace, Interval, midpoint_term, nodal_term};
use crate::error::{Error, Result};

/// One contact segment.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ClassifiedSegment {
    /// T ∩ Γ_C.
    pub segment: Interval,
    /// The cases that hold.
    pub alternative: Alternative,
    /// Its contribution to the consistency term, ≥ 0.
    pub term: f64,
}

/// The contact segments of a mesh, classified for one θ.
///
/// The terms of all segments add up to the consistency term of the edge, and no segment is in neither case.
///
/// ```
/// use signorini::{edge::EdgeTrace, problems::StripData, strip::LateralCondition};
/// use signorini::proof::{Alternative, Classification, Section};
/// let data = StripData::Transition { position: 0.3 }.data(1.75, 256, LateralCondition::Natural)?;
/// let trace = EdgeTrace::of_data(&data)?;
/// let found = Classification::new(Section::Three, &trace, &[0.0, 0.25, 0.5, 0.75, 1.0], 0.25)?;
/// assert_eq!((found.segments().len(), found.count(Alternative::Neither)), (4, 0));
/// assert!(found.total() > 0.0 && found.carriers(0.01) == 1);
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Classification {
    segments: Vec<ClassifiedSegment>,
}

impl Classification {
    /// Classifies the segments between successive `vertices` of a coarse mesh on a fine trace.
    ///
    /// # Errors
    /// [`ToolkitError::OutOfRange`](crate::ToolkitError::OutOfRange) unless 0 < θ < 1 and the vertices increase.
    pub fn new(section: Section, trace: &EdgeTrace, vertices: &[f64], theta: f64) -> Result<Self> {
        checked_theta(theta)?;
        let segments = vertices.windows(2).map(|pair| {
            let segment = Interval { start: pair[0], end: pair[1] };
            Error::require("vertex", pair[1], "increasing vertices", pair[0] < pair[1])?;
            let alternative = Alternative::on_segment(section, trace, segment, theta)?;
            let term = match section {
                Section::Three => nodal_term(trace, segment),
                Section::Four => midpoint_term(trace, segment),
            };
            Ok(ClassifiedSegment { segment, alternative, term })
        });
        Ok(Self { segments: segments.collect::<Result<_>>()? })
    }

    /// The segments, in order along the edge.
    pub fn segments(&self) -> &[ClassifiedSegment] {
        &self.segments
    }

    /// Number of segments of this case.
    pub fn count(&self, case: Alternative) -> usize {
        self.in_case(case).count()
    }

    /// The consistency term summed over the segments of this case.
    pub fn term(&self, case: Alternative) -> f64 {
        sum(self.in_case(case).map(|s| s.term))
    }

    /// The whole consistency term.
    pub fn total(&self) -> f64 {
        sum(self.segments.iter().map(|s| s.term))
    }

    /// The number of segments that contribute more than the share `least` of the whole term.
    ///
    /// Terms that exceed `least` times [`Classification::total`]; 0 segments where the term vanishes everywhere.
    pub fn carriers(&self, least: f64) -> usize {
        let limit = least * self.total();
        self.segments.iter().filter(|s| s.term > limit).count()
    }

    /// The number of common segments that are in different cases.
    pub fn differences(&self, other: &Classification) -> usize {
        let pairs = self.segments.iter().zip(&other.segments);
        pairs.filter(|(a, b)| a.alternative != b.alternative).count()
    }

    /// The segments of this case, as intervals.
    pub fn intervals(&self, case: Alternative) -> Vec<(f64, f64)> {
        self.in_case(case).map(|s| (s.segment.start, s.segment.end)).collect()
    }

    fn in_case(&self, case: Alternative) -> impl Iterator<Item = &ClassifiedSegment> {
        self.segments.iter().filter(move |s| s.alternative == case)
    }
}

/// The sum starting at +0; the empty sum of the standard library is −0.
fn sum(terms: impl Iterator<Item = f64>) -> f64 {
    terms.fold(0.0, |sum, term| sum + term)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_edge_that_opens_in_the_middle_of_a_segment() {
        let nodes: Vec<f64> = (0..=8).map(|i| f64::from(i) / 8.0).collect();
        let displacement = nodes.iter().map(|&x| if x <= 0.625 { 0.0 } else { -1.0 }).collect();
        let force = nodes.iter().map(|&x| if x <= 0.625 { 1.0 } else { 0.0 }).collect();
        let trace = EdgeTrace::new(nodes, displacement, force, 1e-12).unwrap();
        let classified = Classification::new(Section::Three, &trace, &[0.0, 0.5, 1.0], 0.25).unwrap();
        assert_eq!((classified.count(Alternative::First), classified.count(Alternative::Second)), (1, 1));
        assert_eq!(classified.term(Alternative::First), 0.0);
        assert_eq!(classified.intervals(Alternative::Second), vec![(0.5, 1.0)]);
        // one force in the open segment at a quarter of its length, half a force at the shared vertex (u = 0
        // there)
        assert_eq!(classified.total(), 0.25);
        assert!(Classification::new(Section::Four, &trace, &[0.5, 0.5], 0.25).is_err());
    }
}
