//! Both sides of every inequality over mesh sizes: the proofs of Theorems 3.1 and 4.1 line by line on
//! computed pairs (u_N, σ_N).
//!
//! Let T ∩ Γ_C = [a₁, a₂] have length h = h_e ≤ 1, ν = τ − 3/2, and let (u_N, σ_N) be a [`ContactPair`]:
//! functions with u_N ≤ 0, σ_N ≤ 0, σ_N u_N = 0 at every point, whose norms of order ν (of σ_N and of u_N')
//! are finite. For τ < 2 both are constant on fine cells, q = 1/(2 − τ) = 2/(1 − 2ν); for τ ≥ 2 continuous
//! and piecewise linear, q ≥ 2 free at τ = 2. The vanishing zones are unions of fine cells. Norms are (1.1)
//! on the segment, ‖v‖²_ν = ‖v‖₀² + |v|²_ν, ‖u_N‖²_{τ−1/2} = ‖u_N‖₀² + ‖u_N'‖²_ν. Every line is then a
//! statement about one segment with an explicit constant:
//!
//! | line | left | right |
//! | --- | --- | --- |
//! | (3.3) | ∫σ_N(I^h u)_N; ‖σ_N‖₀‖(I^h u)_N‖₀ | ‖σ_N‖₀‖(I^h u)_N‖₀; ‖σ_N‖₀ h^{1/2} max\|u_N(a_i)\| |
//! | (3.4) | \|u_N(a_i)\| | \|∫ u_N'\| from a_i to the nearest zero ξ_i (an equality) |
//! | (3.5) | \|∫ u_N'\| | (hθ)^{1−1/q} ‖u_N'‖_{L^q} |
//! | (3.6)-(3.8) | ‖u_N'‖_{L^q} | C(q) h^{1/q−1/2} ‖u_N'‖_ν, through (‖u_N'‖₀² + h^{2ν}\|u_N'\|²_ν)^{1/2} |
//! | (3.9), (3.10) | ∫σ_N(I^h u)_N | C(q) h θ^{1−1/q} ‖σ_N‖₀‖u_N'‖_ν; then Young |
//! | (3.11) | ∫σ_N(I^h u)_N = ∫σ_N((I^h u)_N − u_N) | ‖σ_N‖₀ ‖(I^h u)_N − u_N‖₀ |
//! | (3.12) | ‖σ_N‖₀ | γ_θ(ν) h^ν \|σ_N\|_ν |
//! | (3.13) | ‖(I^h u)_N − u_N‖₀ | C_L2(ν) h^{1+ν} \|u_N'\|_ν |
//! | (3.14), (3.15) | ∫σ_N(I^h u)_N | γ_θ C_L2 h^{2τ−2} \|σ_N\|_ν\|u_N'\|_ν; then Young |
//! | (4.9) | −∫(σ_N − π^hσ_N)u_N | ∫(σ_N − π^hσ_N)(π^hu_N − u_N) (an equality) |
//! | (4.10), (4.12) | the same term | ‖σ_N‖_{L¹} ‖u_N − π^hu_N‖_{L^∞} |
//! | | ‖u_N − π^hu_N‖_{L^∞} | h^{1/2}‖u_N'‖₀/√3 |
//! | | ‖σ_N‖_{L¹(S)} | (hθ)^{1−1/q} ‖σ_N‖_{L^q} |
//! | | ‖σ_N‖_{L^q} | C(q) h^{1/q−1/2} ‖σ_N‖_ν |
//! | (4.11), (4.13), (4.14) | the same term | ‖σ_N − π^hσ_N‖₀ ‖u_N − π^hu_N‖₀ |
//! | | ‖σ_N − π^hσ_N‖₀ | γ₁ h^ν \|σ_N\|_ν |
//! | | ‖u_N − π^hu_N‖₀ | (h/π) ‖u_N'‖₀ |
//! | | ‖u_N'‖₀ | γ_θ h^ν \|u_N'\|_ν |
//!
//! C(q), C_L2, γ₁, γ_θ and the 1/√3 of (6.2) are best constants or upper bounds of them ([`ProofConstants`]).
//! In (4.14), τ > 2, γ is the constant of functions that vanish at a point: u_N' does at an interior contact
//! point.
//!
//! The *ladder* of one mesh is the sum over its segments of successive bounds of the consistency term
//! ([`super::ladder::Rung`]), each segment in its own case (the first where both hold). Its steps: Hölder's
//! inequality; interpolation and the distance to a zero; embedding and Poincaré for the zone the segment
//! *has*; the same as if every zone were as short as h_e θ; the printed law of γ_θ; Young and norms of the
//! whole edge. Exponents are slopes of least squares over the meshes; each loss is the slope of a quotient of
//! two rungs, so the losses add up to what lies between the first and the last.

use super::case::ProofCase;
use super::inequality_profile::{InequalityProfile, tally};
use super::resolution::Resolution;
use signorini::Result;
use signorini::edge::{ContactPair, SegmentNorms, Traces};
use signorini::proof::ProofConstants;
use signorini::proof::Section;
use signorini::proof::{Alternative, SegmentSetting, segment_chain, segment_checks};
use signorini::proof::{Step, TwoLaws};

/// One mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct LevelProfile {
    /// Contact segments.
    pub n: usize,
    /// θ.
    pub theta: f64,
    /// Segments by case, summed over the positions.
    pub cases: CaseCounts,
    /// The inequalities of the cases that hold.
    pub inequalities: Vec<InequalityProfile>,
    /// In the order of [`Step::ALL`], mean over the positions.
    rungs: [TwoLaws; Step::ALL.len()],
}

/// Segments of a mesh by case; one that is in both counts in either.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct CaseCounts {
    /// In the first case.
    pub first: usize,
    /// In the second.
    pub second: usize,
    /// In neither: would contradict the paper.
    pub neither: usize,
}

impl LevelProfile {
    /// h = 1/n.
    pub fn h(&self) -> f64 {
        1.0 / self.n as f64
    }

    /// The bound of the consistency term after a step.
    pub fn rung(&self, step: Step) -> TwoLaws {
        self.rungs[step as usize]
    }
}

/// All meshes of a case.
#[derive(Debug, Clone, PartialEq)]
pub struct ProofProfile {
    /// The case.
    pub case: ProofCase,
    /// Its meshes, coarsest first.
    pub levels: Vec<LevelProfile>,
}

impl ProofCase {
    /// Both sides of every inequality and the rungs on every mesh. `constants` must be made for the case's τ
    /// and zones ([`ProofCase::zones`]).
    ///
    /// # Errors
    /// [`ToolkitError::OutOfRange`](signorini::ToolkitError::OutOfRange) for τ, θ or constants of another τ; [`ToolkitError::CountOutOfRange`](signorini::ToolkitError::CountOutOfRange) for
    /// positions or a resolution out of range; those of the scenes.
    pub fn profile(&self, constants: &ProofConstants) -> Result<ProofProfile> {
        self.check(constants)?;
        let traces = Traces::for_regularity(self.tau);
        let finest = self.levels.cells().last().unwrap_or(1);
        let pairs = self.pairs(self.resolution.cells(finest), traces)?;
        let square =
            |norms: &SegmentNorms| 0.5 * (norms.stress.norm_squared() + norms.displacement_norm_squared());
        let squares = ContactPair::norms_of(&pairs, 1, constants.order(), constants.q())?
            .map(|edge| Ok(edge?.iter().map(square).sum()))
            .collect::<Result<Vec<f64>>>()?;
        let mut levels = Vec::new();
        for n in self.levels.cells() {
            let own = match self.resolution {
                Resolution::Segment(_) if n != finest => Some(self.pairs(self.resolution.cells(n), traces)?),
                _ => None,
            };
            let pairs = own.as_ref().unwrap_or(&pairs);
            levels.push(self.level(n, pairs, &squares, constants)?);
        }
        Ok(ProofProfile { case: self.clone(), levels })
    }

    fn level(
        &self,
        n: usize,
        pairs: &[ContactPair],
        squares: &[f64],
        constants: &ProofConstants,
    ) -> Result<LevelProfile> {
        let h = 1.0 / n as f64;
        let theta = if self.tau > 2.0 { 0.5 } else { self.rule.theta(h)? };
        let gamma = constants.gamma(theta)?;
        let (mut inequalities, mut rungs, mut cases) =
            (Vec::new(), [TwoLaws::default(); Step::ALL.len()], CaseCounts::default());
        let share = 1.0 / pairs.len() as f64;
        let all = ContactPair::norms_of(pairs, n, constants.order(), constants.q())?;
        for (norms, square) in all.zip(squares) {
            for segment in &norms? {
                let setting = self.setting(segment, theta, gamma, constants)?;
                self.count(segment, theta, &mut cases);
                let checks = segment_checks(self.section, segment, constants, &setting);
                let chain = segment_chain(self.section, segment, constants, &setting);
                tally(&mut inequalities, &checks);
                rungs.iter_mut().zip(chain).for_each(|(total, part)| total.add(part, share));
            }
            let factors = constants.edge_factor(self.section, h, theta);
            rungs[Step::WholeEdge as usize].add(factors.map(|factor| factor * square), share);
        }
        Ok(LevelProfile { n, theta, cases, inequalities, rungs })
    }

    /// γ for the zone a segment has is found only where the second case needs it.
    fn setting(
        &self,
        norms: &SegmentNorms,
        theta: f64,
        gamma: f64,
        constants: &ProofConstants,
    ) -> Result<SegmentSetting> {
        let is_first = Alternative::of_norms(self.section, norms, theta).first();
        let zone = match self.section {
            Section::Three if !is_first => Some(norms.free_length),
            Section::Four if !is_first => norms.contact_diameter(),
            _ => None,
        };
        let own_gamma = match zone {
            // Without stress there is no Poincaré inequality to apply.
            Some(zone) if zone < norms.length || self.section == Section::Four => {
                // Rounded down the zone may be shorter than h_e θ, which is known to lie in it.
                constants.gamma_below(zone / norms.length)?.min(gamma)
            }
            _ => gamma,
        };
        Ok(SegmentSetting { theta, gamma, own_gamma, law: constants.law(theta) })
    }

    fn count(&self, norms: &SegmentNorms, theta: f64, cases: &mut CaseCounts) {
        let found = Alternative::of_norms(self.section, norms, theta);
        cases.first += usize::from(found.first());
        cases.second += usize::from(found.second());
        cases.neither += usize::from(found == Alternative::Neither);
    }
}
