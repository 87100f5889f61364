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
///
/// Each check carries both sides with their error, so a violated inequality would refute the estimate and not the
/// arithmetic. The norms must be of order ν = τ − 3/2 with the exponent q of the constants.
///
/// ```
/// use signorini::edge::{ContactPair, Traces};
/// use signorini::proof::{ProofConstants, Section, SegmentSetting, segment_checks};
/// use signorini::{problems::StripData, strip::LateralCondition};
/// let (constants, theta) = (ProofConstants::new(1.75, 2.0, &[0.25])?, 0.25);
/// let gamma = constants.gamma(theta)?;
/// let setting = SegmentSetting { theta, gamma, own_gamma: gamma, law: constants.law(theta) };
/// let data = StripData::Transition { position: 0.3 }.data(1.75, 256, LateralCondition::Natural)?;
/// for norms in ContactPair::of_data(&data, Traces::Constants)?.norms(4, 0.25, constants.q())? {
///     assert!(segment_checks(Section::Three, &norms, &constants, &setting).iter().all(|check| check.holds()));
/// }
/// # Ok::<(), signorini::Error>(())
/// ```
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
///
/// The sequence increases: each entry bounds the one before. For Section 3 its first entry is the nodal term, for
/// Section 4 the midpoint term, both ≥ 0.
///
/// ```
/// use signorini::edge::{ContactPair, Traces};
/// use signorini::proof::{ProofConstants, Section, SegmentSetting, segment_chain};
/// use signorini::{problems::StripData, strip::LateralCondition};
/// let (constants, theta) = (ProofConstants::new(1.75, 2.0, &[0.25])?, 0.25);
/// let gamma = constants.gamma(theta)?;
/// let setting = SegmentSetting { theta, gamma, own_gamma: gamma, law: constants.law(theta) };
/// let data = StripData::Transition { position: 0.3 }.data(1.75, 256, LateralCondition::Natural)?;
/// let norms = ContactPair::of_data(&data, Traces::Constants)?.norms(4, 0.25, constants.q())?;
/// let chain = segment_chain(Section::Three, &norms[1], &constants, &setting);
/// assert!(chain.windows(2).all(|step| step[0].printed <= step[1].printed * (1.0 + 1e-9)));
/// # Ok::<(), signorini::Error>(())
/// ```
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
    ///
    /// Section 3: C(q) h θ^{1−1/q} and γ C_L2 h^{1+2ν}; Section 4: C(q) h θ^{1−1/q}/√3 and γ γ₁ h^{1+2ν}/π. Above τ = 2 only
    /// the second is used. The choice θ = h^{2τ−3} gives both the exponent 2τ² − 5τ + 4 of h.
    ///
    /// ```
    /// use signorini::proof::{ProofConstants, Section, ThetaRule, printed_exponent};
    /// let (constants, rule) = (ProofConstants::new(1.75, 2.0, &[0.25])?, ThetaRule::Printed { tau: 1.75 });
    /// let factor = |h: f64| Ok::<f64, signorini::Error>(constants.edge_factor(Section::Three, h, rule.theta(h)?).printed);
    /// let exponent = (factor(0.01)? / factor(0.005)?).log2();
    /// assert!((exponent - printed_exponent(1.75)).abs() < 1e-12);
    /// # Ok::<(), signorini::Error>(())
    /// ```
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
