//! Contact problems on the unit square whose load every mesh integrates exactly and whose solution is not
//! known.
//!
//! Volume loads that are linear on both halves x < 1/2 and x > 1/2: their P1 interpolants on structured
//! meshes with an even number of squares are the loads themselves, so all discrete solutions belong to one
//! problem.
//! Displacements given are zero. Elastic: plane strain, λ = μ = 1, f vertical.

use crate::cone::Cone;
use crate::contact::ContactProblem;
use crate::error::{Error, Result, ToolkitError};
use crate::fem::{Field, Form, Lame};
use crate::mesh::{Part, SideParts, Triangulation, unit_square};
use std::fmt;

/// One of them.
///
/// ```
/// use signorini::{cone::Cone, contact::Solver, problems::PiecewiseLinearLoad::Membrane};
/// let solve = |n| -> signorini::Result<f64> {
///     Ok(Membrane.on(Membrane.mesh(n)?)?.solve(Cone::Nodal, Solver::ActiveSet)?.energy)
/// };
/// // nested spaces, one functional: J decreases under refinement
/// assert!(solve(8)? < solve(4)? && solve(4)? < solve(2)?);
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PiecewiseLinearLoad {
    /// Scalar, u = 0 on top, free sides, f = 4 |x − 1/2| − 9/10: contact at both sides, a gap between.
    Membrane,
    /// Elastic, held on top and at both sides, f_y = 1 − 6 |x − 1/2|: pressed down beside both sides, where
    /// it touches, lifted in the middle.
    Held,
    /// Elastic, held on top, free sides, f_y = 2x − 1: pressed down on the left.
    Hanging,
}

impl PiecewiseLinearLoad {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Membrane, Self::Held, Self::Hanging];

    /// Lamé's constants; none for the scalar body.
    ///
    /// λ = μ = 1 for the elastic bodies, Poisson's ratio 1/4.
    ///
    /// # Errors
    /// None for these constants.
    pub fn lame(self) -> Result<Option<Lame>> {
        match self {
            Self::Membrane => Ok(None),
            Self::Held | Self::Hanging => Lame::new(1.0, 1.0).map(Some),
        }
    }

    /// True where displacements are given on all of the boundary but the contact edge.
    ///
    /// ```
    /// use signorini::problems::PiecewiseLinearLoad;
    /// let held = PiecewiseLinearLoad::ALL.map(PiecewiseLinearLoad::is_held_all_around);
    /// assert_eq!(held, [false, true, false]);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    pub fn is_held_all_around(self) -> bool {
        self == Self::Held
    }

    /// The cones for which all constants are known: the midpoint cone needs Korn's constant of a body that is
    /// held all around, unless it is scalar.
    ///
    /// ```
    /// use signorini::{cone::Cone, problems::PiecewiseLinearLoad};
    /// assert_eq!(PiecewiseLinearLoad::Hanging.cones(), [Cone::Nodal]);
    /// assert_eq!(PiecewiseLinearLoad::Membrane.cones(), Cone::ALL);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    pub fn cones(self) -> &'static [Cone] {
        if self == Self::Hanging { &[Cone::Nodal] } else { &[Cone::Nodal, Cone::Midpoint] }
    }

    /// The structured mesh with n × n squares.
    ///
    /// x = 1/2 is a mesh line, so that f is affine on every element.
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) unless n is even and 2 ≤ n ≤ 16384.
    pub fn mesh(self, n: usize) -> Result<Triangulation> {
        if n < 2 || !n.is_multiple_of(2) {
            return Err(Error::Toolkit(ToolkitError::CountOutOfRange {
                name: "squares",
                value: n,
                range: "even, at least 2",
            }));
        }
        let side = if self.is_held_all_around() { Part::Dirichlet } else { Part::Neumann };
        unit_square(n, SideParts { bottom: Part::Contact, right: side, top: Part::Dirichlet, left: side })
    }

    /// The problem on [`PiecewiseLinearLoad::mesh`] or a refinement of it.
    ///
    /// ```
    /// use signorini::{cone::Cone, contact::Solver, problems::PiecewiseLinearLoad::Held};
    /// let problem = Held.on(Held.mesh(8)?)?;
    /// let u = problem.solve(Cone::Nodal, Solver::ActiveSet)?;
    /// // homogeneous data: a(u, u) = F'u, hence J = −a(u, u)/2
    /// assert!((u.energy + 0.5 * problem.energy_norm(&u.displacement)?.powi(2)).abs() < 1e-14);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`ContactProblem::new`].
    pub fn on(self, mesh: Triangulation) -> Result<ContactProblem> {
        let density = |x: f64| match self {
            Self::Membrane => 4.0 * (x - 0.5).abs() - 0.9,
            Self::Held => 1.0 - 6.0 * (x - 0.5).abs(),
            Self::Hanging => 2.0 * x - 1.0,
        };
        let (form, load) = match self.lame()? {
            None => (Form::LAPLACE, Field::Scalar(&|[x, _]| density(x)).sample(mesh.nodes())?),
            Some(lame) => {
                (Form::elastic(lame), Field::Vector(&|[x, _]| [0.0, density(x)]).sample(mesh.nodes())?)
            }
        };
        ContactProblem::new(mesh, form, &load)
    }
}

impl fmt::Display for PiecewiseLinearLoad {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Membrane => "membrane",
            Self::Held => "held",
            Self::Hanging => "hanging",
        })
    }
}
