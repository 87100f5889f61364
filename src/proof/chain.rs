//! The chain of estimates from the consistency term of a segment to the bound of the theorems.

use super::constants::ProofConstants;
use super::laws::TwoLaws;
use super::section::Section;
use super::setting::SegmentSetting;
use super::step::Step;
use super::{section_four, section_three};
use crate::edge::SegmentNorms;

/// Successive bounds of the consistency term of one segment, in the order of [`Step::ALL`] without the last step, the
/// segment in its own case (the first where both hold).
pub fn segment_chain(
    section: Section,
    norms: &SegmentNorms,
    constants: &ProofConstants,
    setting: &SegmentSetting,
) -> [TwoLaws; Step::ALL.len() - 1] {
    match section {
        Section::Three => section_three::chain(norms, constants, setting),
        Section::Four => section_four::chain(norms, constants, setting),
    }
}

/// The last step: the larger of the factors of both cases, with both laws, by which the squared norms of the whole
/// edge are multiplied.
pub fn edge_factor(section: Section, h: f64, theta: f64, constants: &ProofConstants) -> TwoLaws {
    let laws = constants.law(theta);
    let (first, second) = match section {
        Section::Three => (
            section_three::first_factor(h, theta, constants),
            laws.map(|law| section_three::second_factor(h, constants, law)),
        ),
        Section::Four => (
            section_four::first_factor(h, theta, constants),
            laws.map(|law| section_four::second_factor(h, constants, law)),
        ),
    };
    if constants.tau() > 2.0 { second } else { second.map(|s| s.max(first)) }
}
