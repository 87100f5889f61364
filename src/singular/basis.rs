//! Displacements r^λ U(θ) of an elastic wedge, and their tractions.
//!
//! Muskhelishvili: 2μ (u_x + i u_y) = κ φ − z conj φ′ − conj ψ, σ_θθ + i σ_rθ = φ′ + conj φ′ + e^{2iθ}(z̄ φ″ + ψ′).
//! With φ = (a₁ + i a₂) z^λ, ψ = (b₁ + i b₂) z^λ, c, s = cos, sin (λ−1)θ and C, S = cos, sin (λ+1)θ:
//!
//! | | a₁ | a₂ | b₁ | b₂ |
//! | --- | --- | --- | --- | --- |
//! | 2μ u_r / r^λ | (κ−λ) c | −(κ−λ) s | −C | S |
//! | 2μ u_θ / r^λ | (κ+λ) s | (κ+λ) c | S | C |
//! | σ_θθ / (λ r^{λ−1}) | (λ+1) c | −(λ+1) s | C | −S |
//! | σ_rθ / (λ r^{λ−1}) | (λ−1) s | (λ−1) c | S | C |
//!
//! The formulas hold for complex λ. Unlike Airy's function they contain the rigid rotation, a₂ at λ = 1. a₁ and b₁
//! are even about θ = 0, a₂ and b₂ odd. In the code μ = 1/2.

use super::wedge::SideCondition;
use faer::c64;

/// Rows u_r, u_θ, σ_θθ/λ, σ_rθ/λ; columns a₁, a₂, b₁, b₂.
pub(super) fn fields(lambda: c64, kappa: f64, theta: f64) -> [[c64; 4]; 4] {
    let one = c64::new(1.0, 0.0);
    let (inner, outer) = ((lambda - one) * theta, (lambda + one) * theta);
    let (c, s, cc, ss) = (inner.cos(), inner.sin(), outer.cos(), outer.sin());
    let (minus, plus) = (kappa - lambda, kappa + lambda);
    [
        [minus * c, -minus * s, -cc, ss],
        [plus * s, plus * c, ss, cc],
        [(lambda + one) * c, -(lambda + one) * s, cc, -ss],
        [(lambda - one) * s, (lambda - one) * c, ss, cc],
    ]
}

/// The two conditions of a side at θ.
pub(super) fn conditions(
    side: SideCondition,
    lambda: c64,
    kappa: f64,
    theta: f64,
) -> [[c64; 4]; 2] {
    let [radial, tangential, normal, shear] = fields(lambda, kappa, theta);
    match side {
        SideCondition::Clamped => [radial, tangential],
        SideCondition::Free | SideCondition::Open => [normal, shear],
        SideCondition::Closed => [tangential, shear],
    }
}

/// A vector in the kernel of a 2 × 2 matrix of rank one, computed from its larger row.
pub(super) fn kernel(rows: [[c64; 2]; 2]) -> [c64; 2] {
    let size = |row: &[c64; 2]| row[0].norm_sqr() + row[1].norm_sqr();
    let [a, b] = if size(&rows[0]) >= size(&rows[1]) { rows[0] } else { rows[1] };
    [-b, a]
}

#[cfg(test)]
mod tests {
    use super::super::wedge::{Medium, SideConditions, Wedge};
    use super::*;

    /// The determinant of the four conditions on the four functions: zero at the exponents.
    fn determinant(rows: [[c64; 4]; 4]) -> c64 {
        // Laplace: pairs of columns of the upper two rows times the complementary pairs of the lower two.
        let minor = |r: usize, i: usize, j: usize| {
            rows[r][i] * rows[r + 1][j] - rows[r][j] * rows[r + 1][i]
        };
        minor(0, 0, 1) * minor(2, 2, 3) - minor(0, 0, 2) * minor(2, 1, 3)
            + minor(0, 0, 3) * minor(2, 1, 2)
            + minor(0, 1, 2) * minor(2, 0, 3)
            - minor(0, 1, 3) * minor(2, 0, 2)
            + minor(0, 2, 3) * minor(2, 0, 1)
    }

    /// Some hundred roundings of the terms.
    const ROUNDING: f64 = 1e-12;

    /// Every equation of the table against the determinant of the boundary conditions, at complex λ: the
    /// quotient is a constant, or a constant times λ for nothing (the stresses are divided by λ).
    #[test]
    fn characteristic_functions_are_determinants() {
        for sides in SideConditions::ALL {
            for (angle, poisson) in [(0.7, 0.3), (2.2, -0.4), (4.9, 0.49), (6.1, 0.1)] {
                let wedge = Wedge::new(angle, sides, Medium::PlaneStrain(poisson)).unwrap();
                let kappa = wedge.kappa();
                let ([first, second], _) = wedge.ordered();
                let quotient = |lambda: c64| {
                    let ([a, b], [c, d]) = (
                        conditions(first, lambda, kappa, 0.0),
                        conditions(second, lambda, kappa, angle),
                    );
                    let product: c64 =
                        wedge.factors().iter().map(|f| f.values(lambda)[0]).product();
                    determinant([a, b, c, d]) / product
                };
                let expected = quotient(c64::new(0.37, 0.21));
                for (x, y) in [(0.9, -0.4), (1.7, 0.8), (2.6, 0.1), (-0.8, 0.3)] {
                    let found = quotient(c64::new(x, y));
                    assert!(
                        (found / expected - 1.0).norm() < ROUNDING,
                        "{sides} {angle} {poisson}: {found} {expected}"
                    );
                }
                assert!(expected.norm() > 0.1, "{sides}: {expected}");
            }
        }
    }

    /// The equilibrium of the basis by differences: the columns solve Lamé's equations.
    #[test]
    fn the_basis_solves_the_equations() {
        let (kappa, lambda) = (1.8, c64::new(0.6, 0.3));
        // σ_rr + σ_θθ = 4 Re φ′ in the basis: 4λ (a₁ c − a₂ s).
        let trace = |theta: f64| {
            let inner = (lambda - 1.0) * theta;
            [
                4.0 * lambda * inner.cos(),
                -4.0 * lambda * inner.sin(),
                c64::new(0.0, 0.0),
                c64::new(0.0, 0.0),
            ]
        };
        let (theta, h) = (0.9, 1e-5);
        let [at, before, after] = [theta, theta - h, theta + h].map(|t| fields(lambda, kappa, t));
        for k in 0..4 {
            let slope = |row: usize| (after[row][k] - before[row][k]) / (2.0 * h);
            let (normal, shear) = (lambda * at[2][k], lambda * at[3][k]);
            let radial = trace(theta)[k] - normal;
            // (λ−1) σ_rr + σ_rθ' + σ_rr − σ_θθ = 0 and (λ−1) σ_rθ + σ_θθ' + 2 σ_rθ = 0
            let first = lambda * radial + lambda * slope(3) - normal;
            let second = (lambda + 1.0) * shear + lambda * slope(2);
            assert!(first.norm() < 1e-8 && second.norm() < 1e-8, "{k}: {first} {second}");
            // σ_rθ = μ (u_r' + (λ−1) u_θ), μ = 1/2; σ_rr + σ_θθ = (u_r (λ+1) + u_θ')·2/(κ−1)
            let law = 0.5 * (slope(0) + (lambda - 1.0) * at[1][k]) - shear;
            let volume =
                ((lambda + 1.0) * at[0][k] + slope(1)) * (2.0 / (kappa - 1.0)) - trace(theta)[k];
            assert!(law.norm() < 1e-8 && volume.norm() < 1e-8, "{k}: {law} {volume}");
        }
    }
}
