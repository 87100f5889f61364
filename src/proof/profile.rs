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
//! | (4.10), (4.12) | the same term; ‖u_N − π^hu_N‖_{L^∞}; ‖σ_N‖_{L¹(S)}; ‖σ_N‖_{L^q} | ‖σ_N‖_{L¹}‖u_N − π^hu_N‖_{L^∞}; h^{1/2}‖u_N'‖₀/√3; (hθ)^{1−1/q}‖σ_N‖_{L^q}; C(q)h^{1/q−1/2}‖σ_N‖_ν |
//! | (4.11), (4.13), (4.14) | the same term; ‖σ_N − π^hσ_N‖₀; ‖u_N − π^hu_N‖₀; ‖u_N'‖₀ | the product; γ₁h^ν\|σ_N\|_ν; (h/π)‖u_N'‖₀; γ_θ h^ν\|u_N'\|_ν |
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

use super::constants::ProofConstants;
use super::inequality::{InequalityProfile, tally};
use super::resolution::Resolution;
use super::section::Section;
use super::setting::{
    SegmentSetting, first_case_four, first_case_three, second_case_four, second_case_three,
};
use super::step::{RUNGS, Step, TwoLaws};
use super::theta::ThetaRule;
use super::{section_four, section_three};
use crate::edge::{ContactPair, SegmentNorms, SeminormForm, Traces};
use crate::error::{Error, Result};
use crate::scenes::StripScene;
use crate::strip::{Levels, Sides};
use rayon::prelude::*;

/// Largest number of positions of a transition.
const POSITIONS: usize = 64;
/// Largest number of cells of the edge.
const LARGEST: usize = 1 << 20;

/// What is profiled.
#[derive(Debug, Clone, PartialEq)]
pub struct ProofCase {
    /// Theorem 3.1 or 4.1.
    pub section: Section,
    /// The manufactured pair; above τ = 2 a single transition.
    pub source: StripScene,
    /// The regularity the proof assumes, 3/2 < τ < 5/2 (at most 2 in Section 3).
    pub tau: f64,
    /// The regularity the pair is built with: its norms of order τ are the better resolved the larger the
    /// difference.
    pub scene_tau: f64,
    /// Mesh sizes.
    pub levels: Levels,
    /// How finely the pair is resolved.
    pub resolution: Resolution,
    /// θ as a function of h; not used above τ = 2.
    pub rule: ThetaRule,
    /// Over how many positions in the coarsest cell a single transition is moved; an odd number.
    pub positions: usize,
}

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
    rungs: [TwoLaws; RUNGS],
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
    /// τ = 7/4, one transition at nine positions, h = 1/8 ... 1/2048 with 128 cells per segment, θ =
    /// h^{2τ−3}.
    ///
    /// # Errors
    /// None: the levels are valid.
    pub fn standard(section: Section) -> Result<Self> {
        Ok(Self {
            section,
            source: StripScene::transition(),
            tau: 1.75,
            scene_tau: 1.75,
            levels: Levels::new(3, 11)?,
            resolution: Resolution::Segment(7),
            rule: ThetaRule::Printed { tau: 1.75 },
            positions: 9,
        })
    }

    /// Both sides of every inequality and the rungs on every mesh. `constants` must be made for the case's τ
    /// and zones ([`ProofCase::zones`]).
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for τ, θ or constants of another τ; [`Error::CountOutOfRange`] for positions or
    /// a resolution out of range; those of the scenes.
    pub fn profile(&self, constants: &ProofConstants) -> Result<ProofProfile> {
        self.check(constants)?;
        let traces = Traces::for_regularity(self.tau);
        let finest = self.levels.cells().last().unwrap_or(1);
        let pairs = self.pairs(self.resolution.cells(finest), traces)?;
        let whole = SeminormForm::new(traces, constants.order(), pairs[0].cells())?;
        let squares = pairs
            .iter()
            .map(|pair| {
                let edge = SegmentNorms::new(&pair.edge(), constants.q(), &whole)?;
                Ok(0.5 * (edge.stress.norm_squared() + edge.displacement_norm_squared()))
            })
            .collect::<Result<Vec<f64>>>()?;
        let mut form: Option<SeminormForm> = None;
        let mut levels = Vec::new();
        for n in self.levels.cells() {
            let own = match self.resolution {
                Resolution::Segment(_) if n != finest => Some(self.pairs(self.resolution.cells(n), traces)?),
                _ => None,
            };
            let pairs = own.as_ref().unwrap_or(&pairs);
            let cells = pairs[0].cells() / n;
            let form = match form.take().filter(|form| form.cells() == cells) {
                Some(known) => form.insert(known),
                None => form.insert(SeminormForm::new(traces, constants.order(), cells)?),
            };
            levels.push(self.level(n, pairs, &squares, form, constants)?);
        }
        Ok(ProofProfile { case: self.clone(), levels })
    }

    /// The zones whose Poincaré constants the profile needs: θ of every mesh, and the powers of 1/2 down to a
    /// fine cell.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for τ or θ outside their ranges.
    pub fn zones(&self) -> Result<Vec<f64>> {
        if self.tau > 2.0 {
            return Ok(Vec::new());
        }
        let coarsest = self.levels.coarsest_cells();
        let cells = self.resolution.cells(coarsest) / coarsest;
        let powers = (0..=cells.max(1).ilog2()).map(|k| Ok(0.5f64.powi(k as i32)));
        self.levels.cells().map(|n| self.rule.theta(1.0 / n as f64)).chain(powers).collect()
    }

    /// Constants for this case alone.
    ///
    /// # Errors
    /// As [`ProofCase::zones`] and [`ProofConstants::new`].
    pub fn constants(&self, q: f64) -> Result<ProofConstants> {
        ProofConstants::new(self.tau, q, &self.zones()?)
    }

    fn check(&self, constants: &ProofConstants) -> Result<()> {
        let largest = if self.section == Section::Three { 2.0 } else { 2.5 };
        let admissible = self.tau > 1.5 && self.tau <= largest && self.tau < 2.5;
        Error::require("tau", self.tau, "(3/2, 2], in Section 4 (3/2, 5/2)", admissible)?;
        let same = constants.tau() == self.tau;
        Error::require("tau of the constants", constants.tau(), "the regularity of the case", same)?;
        let finest = self.levels.cells().last().unwrap_or(1);
        let cells = self.resolution.cells(finest);
        if cells > LARGEST || cells < 2 * finest {
            let range = "[2 per segment, 2^20]";
            return Err(Error::CountOutOfRange { name: "cells of the finest edge", value: cells, range });
        }
        if !(1..=POSITIONS).contains(&self.positions) {
            return Err(Error::CountOutOfRange {
                name: "positions",
                value: self.positions,
                range: "[1, 64]",
            });
        }
        Ok(())
    }

    fn pairs(&self, cells: usize, traces: Traces) -> Result<Vec<ContactPair>> {
        let step = 1.0 / (self.levels.coarsest_cells() * self.positions) as f64;
        let StripScene::Transition { position } = self.source else {
            Error::require("tau", self.tau, "(3/2, 2] but for a single transition", self.tau <= 2.0)?;
            let scene = self.source.data(self.scene_tau, cells, Sides::Natural)?;
            return Ok(vec![ContactPair::of_scene(&scene, traces)?]);
        };
        (0..self.positions)
            .map(|i| {
                let position = position + i as f64 * step;
                if self.tau > 2.0 {
                    return ContactPair::smooth_transition(cells, position, self.scene_tau);
                }
                let source = StripScene::Transition { position };
                let scene = source.data(self.scene_tau, cells, Sides::Natural)?;
                ContactPair::of_scene(&scene, traces)
            })
            .collect()
    }

    fn level(
        &self,
        n: usize,
        pairs: &[ContactPair],
        squares: &[f64],
        form: &SeminormForm,
        constants: &ProofConstants,
    ) -> Result<LevelProfile> {
        let h = 1.0 / n as f64;
        let theta = if self.tau > 2.0 { 0.5 } else { self.rule.theta(h)? };
        let gamma = constants.gamma(theta)?;
        let (mut inequalities, mut rungs, mut cases) =
            (Vec::new(), [TwoLaws::default(); RUNGS], CaseCounts::default());
        let share = 1.0 / pairs.len() as f64;
        for (pair, square) in pairs.iter().zip(squares) {
            let segments: Vec<_> = pair.segments(n)?.collect();
            let q = constants.q();
            let norms: Vec<SegmentNorms> = segments
                .par_iter()
                .map(|segment| SegmentNorms::new(segment, q, form))
                .collect::<Result<_>>()?;
            for segment in &norms {
                let setting = self.setting(segment, theta, gamma, constants)?;
                self.count(segment, theta, &mut cases);
                let (checks, chain) = match self.section {
                    Section::Three => (
                        section_three::section_three_checks(segment, constants, &setting),
                        section_three::chain(segment, constants, &setting),
                    ),
                    Section::Four => (
                        section_four::section_four_checks(segment, constants, &setting),
                        section_four::chain(segment, constants, &setting),
                    ),
                };
                tally(&mut inequalities, &checks);
                rungs.iter_mut().zip(chain).for_each(|(total, part)| total.add(part, share));
            }
            let factors = self.factors(h, theta, constants);
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
        let zone = match self.section {
            Section::Three if !first_case_three(norms, theta) => Some(norms.free_length),
            Section::Four if !first_case_four(norms, theta) => norms.contact_diameter(),
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
        let (first, second) = match self.section {
            Section::Three => (first_case_three(norms, theta), second_case_three(norms, theta)),
            Section::Four => (first_case_four(norms, theta), second_case_four(norms, theta)),
        };
        cases.first += usize::from(first);
        cases.second += usize::from(second);
        cases.neither += usize::from(!first && !second);
    }

    /// The larger of the factors of both cases, with both laws.
    fn factors(&self, h: f64, theta: f64, constants: &ProofConstants) -> TwoLaws {
        let laws = constants.law(theta);
        let (first, second) = match self.section {
            Section::Three => (
                section_three::first_factor(h, theta, constants),
                laws.map(|law| section_three::second_factor(h, constants, law)),
            ),
            Section::Four => (
                section_four::first_factor(h, theta, constants),
                laws.map(|law| section_four::second_factor(h, constants, law)),
            ),
        };
        if self.tau > 2.0 { second } else { second.map(|s| s.max(first)) }
    }
}
