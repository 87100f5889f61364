//! The bilinear forms of Section 2 on P1 triangles: elasticity in the plane and the scalar form of Remark 1.
//!
//! | form | a(u, v) | coercive, on functions that vanish on a Dirichlet part, for |
//! | --- | --- | --- |
//! | scalar | ∫ ∇u·∇v + c u v | c ≥ 0 |
//! | elastic | ∫ λ div u div v + 2 μ ε(u) : ε(v) | μ > 0, λ + μ > 0 |
//!
//! On a triangle of area A with barycentric gradients g_i the elastic block of nodes i, j is
//! A (λ g_i g_j' + μ g_j g_i' + μ (g_i·g_j) I); the scalar one A g_i·g_j + c A (1 + δ_ij)/12. Both are
//! invariant under scaling of lengths, except for the reaction term.

use crate::error::{Error, Result};
use crate::mesh::{Point, doubled_area};

/// The Lamé constants λ and μ of the plane problem.
///
/// Both have the dimension of a stress; σ = λ (div u) I + 2 μ ε(u).
///
/// ```
/// use signorini::fem::Lame;
/// // Coercive in the plane if μ > 0 and λ + μ > 0; λ may be negative.
/// assert!(Lame::new(-0.9, 1.0).is_ok() && Lame::new(-1.0, 1.0).is_err());
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lame {
    lambda: f64,
    mu: f64,
}

impl Lame {
    /// The Lamé constants λ and μ, as in plane strain.
    ///
    /// # Errors
    /// [`ToolkitError::OutOfRange`](crate::ToolkitError::OutOfRange) unless μ > 0 and λ + μ > 0, both finite.
    pub fn new(lambda: f64, mu: f64) -> Result<Self> {
        let in_plane = lambda + mu;
        Error::require("mu", mu, "(0, inf)", mu > 0.0 && mu.is_finite())?;
        Error::require(
            "lambda + mu",
            in_plane,
            "(0, inf)",
            in_plane > 0.0 && in_plane.is_finite(),
        )?;
        Ok(Self { lambda, mu })
    }

    /// The constants of plane strain for Young's modulus E and Poisson's ratio ν: λ = E ν / ((1+ν)(1−2ν)),
    /// μ = E / (2(1+ν)).
    ///
    /// λ tends to infinity as ν → 1/2.
    ///
    /// ```
    /// use signorini::fem::Lame;
    /// let material = Lame::plane_strain(2.5, 0.25)?;
    /// assert_eq!((material.lambda(), material.mu()), (1.0, 1.0));
    /// assert!(Lame::plane_strain(1.0, 0.5).is_err());
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::OutOfRange`](crate::ToolkitError::OutOfRange) unless E > 0 and −1 < ν < 1/2.
    pub fn plane_strain(young: f64, poisson: f64) -> Result<Self> {
        Error::require("Young's modulus", young, "(0, inf)", young > 0.0 && young.is_finite())?;
        let admissible = poisson > -1.0 && poisson < 0.5;
        Error::require("Poisson's ratio", poisson, "(-1, 1/2)", admissible)?;
        let mu = young / (2.0 * (1.0 + poisson));
        Self::new(2.0 * mu * poisson / (1.0 - 2.0 * poisson), mu)
    }

    /// The constants of plane stress for Young's modulus E and Poisson's ratio ν: λ = E ν / (1−ν²), μ = E / (2(1+ν)).
    ///
    /// The shear modulus is that of plane strain; the first constant is 2λμ/(λ + 2μ), λ and μ those of plane strain.
    ///
    /// ```
    /// use signorini::fem::Lame;
    /// let (strain, stress) = (Lame::plane_strain(1.0, 0.3)?, Lame::plane_stress(1.0, 0.3)?);
    /// let reduced = 2.0 * strain.lambda() * strain.mu() / (strain.lambda() + 2.0 * strain.mu());
    /// assert!((stress.lambda() - reduced).abs() < 1e-15 && stress.mu() == strain.mu());
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::OutOfRange`](crate::ToolkitError::OutOfRange) unless E > 0 and −1 < ν < 1/2.
    pub fn plane_stress(young: f64, poisson: f64) -> Result<Self> {
        let Self { mu, .. } = Self::plane_strain(young, poisson)?;
        Self::new(young * poisson / ((1.0 - poisson) * (1.0 + poisson)), mu)
    }

    /// The first Lamé constant λ.
    pub fn lambda(self) -> f64 {
        self.lambda
    }

    /// The shear modulus μ.
    pub fn mu(self) -> f64 {
        self.mu
    }
}

/// A bilinear form on P1 functions.
///
/// ```
/// use signorini::fem::{Form, Lame};
/// let form = Form::elastic(Lame::new(1.0, 2.0)?);
/// assert_eq!((Form::LAPLACE.components(), form.components()), (1, 2));
/// // Regions beyond the end of the list have the last material.
/// assert_eq!(form.material(7).map(|material| material.mu()), Some(2.0));
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub enum Form {
    /// ∫ ∇u·∇v + c u v for scalar u.
    Scalar {
        /// c ≥ 0; 1 in Remark 1, 0 for the Laplacian.
        reaction: f64,
    },
    /// Linear elasticity; region k of the mesh has material k, regions beyond the end of the list have the last one.
    Elastic {
        /// The materials, at least one.
        materials: Vec<Lame>,
    },
}

impl Form {
    /// The form of the Laplacian: ∫ ∇u·∇v.
    pub const LAPLACE: Form = Form::Scalar { reaction: 0.0 };

    /// The bilinear form of linear elasticity for a homogeneous material.
    pub fn elastic(material: Lame) -> Self {
        Form::Elastic { materials: vec![material] }
    }

    /// Number of unknowns per node.
    ///
    /// 1 for the scalar form, 2 for elasticity; nodal vectors have this many entries per node, node-major.
    pub fn components(&self) -> usize {
        match self {
            Form::Scalar { .. } => 1,
            Form::Elastic { .. } => 2,
        }
    }

    /// Checks the reaction and the materials.
    ///
    /// # Errors
    /// [`ToolkitError::OutOfRange`](crate::ToolkitError::OutOfRange) for a negative reaction,
    /// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) without materials.
    pub(crate) fn check(&self) -> Result<()> {
        match self {
            Form::Scalar { reaction } => {
                let admissible = *reaction >= 0.0 && reaction.is_finite();
                Error::require("reaction", *reaction, "[0, inf)", admissible).map(|_| ())
            }
            Form::Elastic { materials } if materials.is_empty() => {
                Err(Error::count("materials", 0, "[1, inf)"))
            }
            Form::Elastic { .. } => Ok(()),
        }
    }

    /// The material of a region; `None` for a scalar form.
    pub fn material(&self, region: usize) -> Option<Lame> {
        match self {
            Form::Scalar { .. } => None,
            Form::Elastic { materials } => materials.get(region).or(materials.last()).copied(),
        }
    }
}

/// Geometry of a P1 triangle: area and the gradients of the barycentric coordinates.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Element {
    pub(crate) area: f64,
    pub(crate) gradients: [Point; 3],
}

impl Element {
    pub(crate) fn new(corners: [Point; 3]) -> Self {
        let doubled = doubled_area(corners);
        let gradients = [0, 1, 2].map(|i| {
            let (a, b) = (corners[(i + 1) % 3], corners[(i + 2) % 3]);
            [(a[1] - b[1]) / doubled, (b[0] - a[0]) / doubled]
        });
        Self { area: 0.5 * doubled, gradients }
    }

    /// ∇v from the values at the corners; a constant has gradient exactly zero.
    ///
    /// (v₁ − v₀) g₁ + (v₂ − v₀) g₂, with g_i the gradients of the barycentric coordinates and g₀ = −g₁ − g₂.
    pub(crate) fn gradient(&self, values: [f64; 3]) -> Point {
        let (a, b) = (values[1] - values[0], values[2] - values[0]);
        let [_, g, h] = self.gradients;
        [a * g[0] + b * h[0], a * g[1] + b * h[1]]
    }

    pub(crate) fn barycentric(&self, corners: [Point; 3], point: Point) -> [f64; 3] {
        let [_, g, h] = self.gradients;
        let d = [point[0] - corners[0][0], point[1] - corners[0][1]];
        let (second, third) = (g[0] * d[0] + g[1] * d[1], h[0] * d[0] + h[1] * d[1]);
        [1.0 - second - third, second, third]
    }

    /// The block of local nodes `i`, `j`; a scalar form fills the first entry only.
    pub(crate) fn block(&self, form: &Form, region: usize, i: usize, j: usize) -> [[f64; 2]; 2] {
        let (g, h) = (self.gradients[i], self.gradients[j]);
        let product = g[0] * h[0] + g[1] * h[1];
        match (form, form.material(region)) {
            (Form::Scalar { reaction }, _) => {
                let mass = if i == j { 1.0 / 6.0 } else { 1.0 / 12.0 };
                [[self.area * (product + reaction * mass), 0.0], [0.0; 2]]
            }
            (Form::Elastic { .. }, material) => {
                let Lame { lambda, mu } = material.unwrap_or(Lame { lambda: 0.0, mu: 0.0 });
                let entry = |a: usize, b: usize| {
                    let diagonal = if a == b { mu * product } else { 0.0 };
                    self.area * (lambda * g[a] * h[b] + mu * g[b] * h[a] + diagonal)
                };
                [[entry(0, 0), entry(0, 1)], [entry(1, 0), entry(1, 1)]]
            }
        }
    }
}
