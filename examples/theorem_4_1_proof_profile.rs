//! Theorem 4.1, its proof line by line, with explicit constants; the loop is that of Theorem 3.1, its twin.
//!
//! Notation as there; π is the mean over the segment T. First case: the contact set {u_N = 0} of T has diameter at most θh;
//! second case: at least θh; above τ = 2: any contact.
//!
//! ```text
//! (4.9)  −∫ (σ_N − π σ_N) u_N = ∫ (σ_N − π σ_N)(π u_N − u_N)
//! (4.10) ≤ ‖σ_N‖_(L¹) ‖u_N − π u_N‖_(L^∞),   ‖u_N − π u_N‖_(L^∞) ≤ h^(1/2) ‖u'‖₀/√3  (6.2),   ‖σ_N‖_(L¹) ≤ (hθ)^(1−1/q) ‖σ_N‖_(L^q),
//!        ‖σ_N‖_(L^q) ≤ C_q h^(1/q−1/2) ‖σ_N‖_ν:   (4.9) ≤ C_q h θ^(1−1/q) ‖σ_N‖_ν ‖u'‖₀/√3;   at τ = 2 (4.12)
//! (4.11) ≤ ‖σ_N − π σ_N‖₀ ‖u_N − π u_N‖₀,   ‖σ_N − π σ_N‖₀ ≤ γ₁ h^ν |σ_N|_ν and ‖u_N − π u_N‖₀ ≤ (h/π) ‖u'‖₀  (4.6),
//!        ‖u'‖₀ ≤ γ_θ h^ν |u'|_ν:   (4.9) ≤ γ_θ γ₁ h^(1+2ν) |σ_N|_ν |u'|_ν/π;   at τ = 2 (4.13), above (4.14) with γ of one zero
//! ```
//!
//! Refuted if in one line on one segment left/right exceeds 1 by more than the error of the seminorms.
//!
//! `cargo run --release --example theorem_4_1_proof_profile -- --tau 1.6`

#[allow(dead_code, reason = "the options and the command line of the twin are its own")]
#[path = "theorem_3_1_proof_profile.rs"]
pub mod theorem_3_1_proof_profile;

use example_report::prelude::*;
use signorini::edge::SegmentNorms;
use signorini::proof::{ProofConstants, Section};
use theorem_3_1_proof_profile::{Lines, profile};

example! { seconds "(4.9)-(4.14)", "every line of the proof of Theorem 4.1, with explicit constants, on every segment";
    /// regularity τ of the pair
    tau: f64 = "1.75" in "(1.5, 2)" slider "1.55 to 1.95",
    /// meshes of 8, 16, .. 2^finest segments
    finest: u32 = "10" in "[5, 12]",
}

/// Section 4 on one segment.
pub fn lines(t: &SegmentNorms, c: &ProofConstants, theta: f64) -> Result<Lines> {
    let (h, nu, q, power) = (t.length, c.order().value(), c.q(), 1.0 - 1.0 / c.q());
    let (full, semi) = (t.stress.norm_squared().sqrt(), t.stress.seminorm() * t.slope.seminorm());
    let ([error, height], work) = (t.projection_error, t.force * t.depth);
    let (mut lines, mut chain) =
        (vec![("(4.9) mean zero", t.projection_term, t.midpoint_term, f64::INFINITY)], None);
    let diameter = t.contact_diameter();
    if let Some(diameter) = diameter.filter(|d| c.tau() > 2.0 || *d >= theta * h) {
        let gamma = c.gamma(theta)?;
        let factor = c.projection * c.wirtinger * h.powf(1.0 + 2.0 * nu); // γ₁, 1/π
        lines.push(("(4.11) Cauchy-Schwarz", t.midpoint_term, t.stress.deviation * error, work));
        lines.push((
            "(4.11) σ_N by (4.6)",
            t.stress.deviation,
            c.projection * h.powf(nu) * t.stress.seminorm(),
            0.0,
        ));
        lines.push(("(4.11) u_N by (4.6)", error, c.wirtinger * h * t.slope.l2, t.depth * h.sqrt()));
        lines.push(("(4.11) Poincaré", t.slope.l2, gamma * h.powf(nu) * t.slope.seminorm(), 0.0));
        let name = if c.tau() < 2.0 {
            "(4.11)"
        } else if c.tau() == 2.0 {
            "(4.13)"
        } else {
            "(4.14)"
        };
        lines.push((name, t.midpoint_term, gamma * factor * semi, work));
        // γ of the diameter of the contact set, rounded down to a power of 1/2.
        let own = if c.tau() > 2.0 { gamma } else { c.gamma_below(diameter / h)?.min(gamma) };
        chain =
            Some([t.midpoint_term, t.stress.deviation * error, own * factor * semi, gamma * factor * semi]);
    }
    if c.tau() <= 2.0 && diameter.is_none_or(|d| d <= theta * h) {
        lines.push(("(4.10) L¹ and L^∞", t.midpoint_term, t.force * height, work));
        lines.push(("(4.10) by (6.2)", height, c.pointwise * h.sqrt() * t.slope.l2, t.depth));
        lines.push(("(4.10) Hölder", t.force, (h * theta).powf(power) * t.stress.lq, 0.0));
        lines.push(("(4.10) embedding", t.stress.lq, c.embedding * h.powf(1.0 / q - 0.5) * full, 0.0));
        let bound = |length: f64| {
            c.pointwise * c.embedding * h.powf(1.0 - power) * length.powf(power) * full * t.slope.l2
        };
        lines.push((
            if c.tau() == 2.0 { "(4.12)" } else { "(4.10)" },
            t.midpoint_term,
            bound(theta * h),
            work,
        ));
        chain = Some([t.midpoint_term, t.force * height, bound(diameter.unwrap_or(0.0)), bound(theta * h)])
            .filter(|_| diameter.is_some());
    }
    Ok((lines, chain))
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    let factor = |c: &ProofConstants, h: f64, theta: f64| c.edge_factor(Section::Four, h, theta).printed;
    let limits = [2.0, 2.05, 2.25, 2.45];
    profile(lines, factor, "theorem_4_1_proof_profile", (options.tau, options.finest), &limits, out)
}
