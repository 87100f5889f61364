//! The contact force in an interval.
//!
//! With d = σ(v) − q, the middle q̄ = ½ (σ(v) + q), A and b as in module `parts`: by the
//! parallelogram law
//! |||σ(u) − q̄|||*² ≤ ¼ A² + b (+ osc |||u − v|||), and for every w in V, w = 0 on Γ_D,
//!
//! ```text
//! −∫ σ_N(u) w_N = l(w) − a(u, w)
//!               = −∫ q_N w_N − ½ ∫ d : ε(w) ± |||w||| ( (¼ A² + b + osc E)^(1/2) + osc ),
//! |||u − v||| ≤ E.
//! ```
//!
//! w has the given values of w_N at the nodes of Γ_C and least energy. What the rules for loads and tractions may miss of
//! l(w) is added: it is all of the error where w is a rigid motion.

use super::enclosure::{Enclosure, Interval};
use super::setting::{QUADRATURE, Setting};
use crate::contact::Body;
use crate::error::{Error, Result};
use crate::fem::Element;
use crate::mesh::Part;

impl Body<'_> {
    /// The force −∫ σ_N(u) of one contact edge, numbered as in
    /// [`ContactEdge::pieces`](crate::mesh::ContactEdge::pieces), in an interval that contains the
    /// value of the exact solution; `None` for an edge that meets the Dirichlet boundary, where no
    /// bound of this kind exists.
    ///
    /// Cost: one factorization.
    ///
    /// ```
    /// use signorini::{cone::Cone, contact::Body, fem::{Form, Lame}};
    /// use signorini::mesh::{SideParts, unit_square};
    /// let form = Form::elastic(Lame::new(1.0, 1.0)?);
    /// let body = Body::new(unit_square(16, SideParts::HANGING)?, form)
    ///     .load(|_: [f64; 2]| [0.0, -1.0]);
    /// let force = body.contact_force(&body.enclose(Cone::Nodal)?, 0)?.unwrap();
    /// // part of the weight 1 hangs on the clamped top
    /// assert!(0.4 < force.lower && force.upper < 0.6);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) for an edge that
    /// does not exist.
    pub fn contact_force(&self, found: &Enclosure, edge: usize) -> Result<Option<Interval>> {
        let pieces = found.problem.edge().pieces();
        let Some(piece) = pieces.get(edge) else {
            return Err(Error::count(
                "number of a contact edge",
                edge,
                "[0, number of contact edges)",
            ));
        };
        let clamped = found.problem.mesh().nodes_on(Part::Dirichlet);
        let nodes = found.problem.edge().nodes();
        if nodes[piece.clone()].iter().any(|&node| clamped[node]) {
            return Ok(None);
        }
        let weights: Vec<f64> =
            (0..nodes.len()).map(|i| f64::from(u8::from(piece.contains(&i)))).collect();
        self.weighted_force(found, &weights).map(Some)
    }

    /// −∫ σ_N(u) w for the piecewise linear w with the given values at the nodes of the contact
    /// edges, in an interval that contains it; values at nodes on the Dirichlet boundary are taken
    /// as 0.
    ///
    /// The moment of the force, for example, with w linear along the edge. Cost: one factorization.
    ///
    /// # Errors
    /// [`ToolkitError::LengthMismatch`](crate::ToolkitError::LengthMismatch) unless there is one
    /// value per node.
    pub fn weighted_force(&self, found: &Enclosure, weights: &[f64]) -> Result<Interval> {
        let problem = &found.problem;
        crate::numeric::check::require_length(
            "weights",
            weights.len(),
            problem.edge().nodes().len(),
        )?;
        let setting = self.setting_of(found)?;
        let w = problem.extension(weights)?;
        let size = problem.energy_norm(&w)?;
        let mut middle = 0.0;
        for t in 0..problem.mesh().triangles().len() {
            middle -= 0.5 * setting.pairing(t, found, &w)?;
        }
        middle += setting.pressure_against(found, &w);
        let off = found.oscillation + found.rounding;
        // |||u − v|||, v in K.
        let distance = 0.5 * (found.reach + (found.reach * found.reach + 4.0 * found.work).sqrt());
        let square = 0.25 * found.reach * found.reach + found.work + off * distance;
        Ok(Interval::around(middle, size * (square.sqrt() + off) + setting.missed(&w)?))
    }
}

impl Enclosure {
    /// An upper bound of the force −∫ σ_N(u) on the part of Γ_C where u^h (after its correction
    /// into the cone) is more than `distance` off the floor: (A² + 2b)/(2 · distance).
    pub fn force_beyond(&self, distance: f64) -> f64 {
        0.5 * (self.reach * self.reach + 2.0 * self.work) / distance
    }
}

impl Setting<'_, '_> {
    /// ∫ d : ε(w) on a triangle, with the reaction term.
    fn pairing(&self, t: usize, found: &Enclosure, w: &[f64]) -> Result<f64> {
        let (inner, test) = (self.compliance(t), self.stress_of(t, w));
        let (field, stress) = (&found.dual.fields[t], self.stress_of(t, &found.admissible));
        let (corners, nodes, reaction) =
            (self.mesh.corners(t), self.mesh.triangles()[t], self.reaction());
        let element = Element::new(corners);
        let mut sum = 0.0;
        let samples = self.samples(t, QUADRATURE);
        let (distances, _) = self.distances(t, &samples, (&found.admissible, &stress), field)?;
        for (sample, (off, residual)) in samples.iter().zip(&distances) {
            sum += sample.weight * inner(off, &test);
            if reaction > 0.0 {
                let at = element.barycentric(corners, sample.point);
                let value: f64 = (0..3).map(|i| at[i] * w[nodes[i]]).sum();
                sum += sample.weight * residual * value;
            }
        }
        Ok(sum)
    }

    /// −∫ q_N w_N over Γ_C.
    fn pressure_against(&self, found: &Enclosure, w: &[f64]) -> f64 {
        let mut sum = 0.0;
        for (border, [p, r]) in self.borders.iter().zip(&found.dual.pressure) {
            if border.part == Part::Contact && (*p > 0.0 || *r > 0.0) {
                let side = self.side(border.triangle, border.side);
                let [a, b] = self.normal_at(border, w);
                // Linear times linear.
                sum += side.length / 6.0 * (p * (2.0 * a + b) + r * (a + 2.0 * b));
            }
        }
        sum
    }
}
