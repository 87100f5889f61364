//! Both sides of the inequalities on a segment, and the chain of estimates from its consistency term to the bound of
//! the theorems.

use super::check::Check;
use super::constants::ProofConstants;
use super::laws::TwoLaws;
use super::section::Section;
use super::setting::SegmentSetting;
use super::step::Step;
use super::{section_four, section_three};
use crate::edge::SegmentNorms;

/// Both sides of every inequality of the cases that hold on a segment (both cases, where both do): (3.3)-(3.15) or
/// (4.9)-(4.14).
pub fn segment_checks(
    section: Section,
    norms: &SegmentNorms,
    constants: &ProofConstants,
    setting: &SegmentSetting,
) -> Vec<Check> {
    match section {
        Section::Three => section_three::checks(norms, constants, setting),
        Section::Four => section_four::checks(norms, constants, setting),
    }
}

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

impl ProofConstants {
    /// The last step of the chain, [`Step::WholeEdge`]: the larger of the factors of both cases, with both laws, by
    /// which the squared norms of the whole edge are multiplied.
    pub fn edge_factor(&self, section: Section, h: f64, theta: f64) -> TwoLaws {
        let laws = self.law(theta);
        let (first, second) = match section {
            Section::Three => (
                section_three::first_factor(h, theta, self),
                laws.map(|law| section_three::second_factor(h, self, law)),
            ),
            Section::Four => (
                section_four::first_factor(h, theta, self),
                laws.map(|law| section_four::second_factor(h, self, law)),
            ),
        };
        if self.tau() > 2.0 { second } else { second.map(|s| s.max(first)) }
    }
}
