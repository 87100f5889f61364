//! Test problems on meshes: domains, data, and known solutions.
//!
//! The body hangs from its top, u = 0, with free sides, except that it is fixed at its left side, which meets
//! the bottom at the angle ω, in `corner`, `leaning` and `raised`, and at the end of an arm in `bracket`;
//! `manufactured` has the data of its solution, `membrane-reaction` contact on the whole boundary. The domain
//! is the unit square except for `corner`, `leaning`, `raised`, `taper` and `bracket`; n = (0, −1) on the
//! bottom, so u_N = −u_y ≤ 0 for elastic test problems and u ≤ 0 for scalar ones. Volume loads f are replaced
//! by their P1 interpolants. The regularity of the solutions follows from the corners and the contact set:
//! module `regularity`.

use super::known::{KnownSolution, three_halves_problem};
use super::named::unknown;
use crate::contact::ContactProblem;
use crate::error::{Error, Result};
use crate::fem::{Field, Form, Lame};
use crate::mesh::{Part, Point, SideParts, Triangulation, mapped_grid, unit_square, unit_squares};
use std::f64::consts::PI;
use std::fmt;
use std::str::FromStr;
use std::sync::LazyLock;

/// A named test problem: domain, form and data.
///
/// λ = μ = 1 corresponds to Poisson's ratio 1/4; all lengths, moduli and loads are nondimensional.
///
/// ```
/// use signorini::{cone::Cone, contact::Solver, problems::TestProblem};
/// // clamped at the top and pressed down: full contact; the top and the plane carry the load ∫ f = −1
/// let found = TestProblem::Closed.problem(4)?.solve(Cone::Nodal, Solver::ActiveSet)?;
/// assert_eq!(found.contact_set.count(), 5);
/// assert!((found.contact_force + found.reaction[1] - 1.0).abs() < 1e-12);
/// // lifted: no contact, the top carries all of it
/// let found = TestProblem::Free.problem(4)?.solve(Cone::Nodal, Solver::ActiveSet)?;
/// assert!(found.contact_force == 0.0 && (found.reaction[1] + 1.0).abs() < 1e-12);
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[non_exhaustive]
pub enum TestProblem {
    /// An elastic square hanging from its top, pushed down on the left and up on the right: plane strain,
    /// λ = μ = 1, f = (0, −cos πx).
    #[default]
    Block,
    /// The scalar counterpart of `block`: ∫ ∇u·∇v, f = cos 2πx + 0.3.
    Membrane,
    /// Remark 1 as printed: ∫ ∇u·∇v + uv, contact on the whole boundary, f = 4 (cos πx + cos πy).
    MembraneReaction,
    /// A scalar corner of given opening ω between a Dirichlet side and the contact edge, f = −2 cos πx.
    Corner,
    /// A scalar problem with known solution −Re (z − a)^{3/2} and contact set [0, a]; f = 0.
    Manufactured,
    /// `block` with a nearly incompressible material, E = 5/2 and given Poisson's ratio, for which P1 elements
    /// lock.
    Incompressible,
    /// An elastic corner of given opening ω between a Dirichlet side and the contact edge, pressed onto the
    /// obstacle: f = (0, −cos πx − 1/2). At ω = 120° the corner itself is not in contact, up to r = 1e-4.
    Leaning,
    /// `leaning` with the load f = (0, cos πx), which lifts the body at that corner.
    Raised,
    /// An elastic body hanging from its top, with free sides that meet the contact edge at the opening ω; pressed
    /// down on the left: f = (0, −cos πx − 1/2).
    Taper,
    /// An elastic body of three unit squares around a free reentrant corner of 270°: a leg on the obstacle, and
    /// an arm with Dirichlet conditions at its end x = −1, f = (0, −cos πx − 1/2).
    Bracket,
    /// Elasticity without contact: `block` lifted, f = (0, 1).
    Free,
    /// Elasticity with full contact: `block` pressed down, f = (0, −1).
    Closed,
}

/// All test problems with their names, in the order of the variants.
const NAMES: [(TestProblem, &str); 12] = [
    (TestProblem::Block, "block"),
    (TestProblem::Membrane, "membrane"),
    (TestProblem::MembraneReaction, "membrane-reaction"),
    (TestProblem::Corner, "corner"),
    (TestProblem::Manufactured, "manufactured"),
    (TestProblem::Incompressible, "incompressible"),
    (TestProblem::Leaning, "leaning"),
    (TestProblem::Raised, "raised"),
    (TestProblem::Taper, "taper"),
    (TestProblem::Bracket, "bracket"),
    (TestProblem::Free, "free"),
    (TestProblem::Closed, "closed"),
];

/// The data that characterise a test problem.
struct Body {
    is_elastic: bool,
    form: fn(&Parameters) -> Result<Form>,
    /// The mesh with n × n cells.
    mesh: fn(usize, &Parameters) -> Result<Triangulation>,
    /// The load f, vertical for elastic test problems.
    load: fn(Point) -> f64,
}

/// λ = μ = 1, that is Poisson's ratio 1/4, on the square hanging from its top, without load.
const ELASTIC: Body = Body {
    is_elastic: true,
    form: |_| Ok(Form::elastic(Lame::new(1.0, 1.0)?)),
    mesh: |n, _| unit_square(n, SideParts::HANGING),
    load: |_| 0.0,
};

/// The Laplacian on the square hanging from its top, without load; a right angle between u = 0 and zero
/// flux causes no singularity.
const SCALAR: Body = Body {
    is_elastic: false,
    form: |_| Ok(Form::LAPLACE),
    mesh: |n, _| unit_square(n, SideParts::HANGING),
    load: |_| 0.0,
};

/// The square leaning at the angle ω, in degrees, at the left end of its bottom.
fn leaning_square(n: usize, angle: f64) -> Result<Triangulation> {
    Error::require("angle in degrees", angle, "[20, 160]", (20.0..=160.0).contains(&angle))?;
    // The left side is inclined by cot ω; so is the right one if the left one leans inwards.
    let lean = 1.0 / angle.to_radians().tan();
    mapped_grid(n, n, LEFT_HELD, |[x, y]| [x + y * ((1.0 - x) * lean + x * lean.max(0.0)), y])
}

/// The square with both sides leaning outwards at the angle ω, in degrees, at its bottom; inwards for acute ω.
fn taper(n: usize, angle: f64) -> Result<Triangulation> {
    Error::require("angle in degrees", angle, "[70, 160]", (70.0..=160.0).contains(&angle))?;
    let lean = -1.0 / angle.to_radians().tan();
    mapped_grid(n, n, SideParts::HANGING, |[x, y]| [x + y * lean * (2.0 * x - 1.0), y])
}

/// A leg, the square above it, and an arm to the left.
fn bracket(n: usize) -> Result<Triangulation> {
    unit_squares(n, &[[0, 0], [0, 1], [-1, 1]], |[x, y]| match (x, y) {
        (_, 0.0) => Part::Contact,
        (-1.0, _) => Part::Dirichlet,
        _ => Part::Neumann,
    })
}

/// The parameters of test problems.
///
/// ```
/// use signorini::{cone::Cone, contact::Solver, problems::{Parameters, TestProblem}};
/// let energy = |load_scale| -> signorini::Result<f64> {
///     let setting = Parameters { load_scale, ..Parameters::default() };
///     Ok(TestProblem::Block.problem_with(4, &setting)?.solve(Cone::Nodal, Solver::ActiveSet)?.energy)
/// };
/// // u is positively homogeneous of degree 1 in the data, J of degree 2
/// assert!((energy(3.0)? / energy(1.0)? - 9.0).abs() < 1e-12);
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameters {
    /// Opening ω in degrees: at the left end of the contact edge for `corner`, `leaning` and `raised`, in [20, 160];
    /// at both ends for `taper`, in [70, 160].
    pub angle: f64,
    /// Poisson's ratio of `incompressible`, in (−1, 1/2).
    pub poisson: f64,
    /// Factor by which all data are multiplied; finite.
    pub load_scale: f64,
}

impl Default for Parameters {
    fn default() -> Self {
        Self { angle: 120.0, poisson: 0.4999, load_scale: 1.0 }
    }
}

const ALL_CONTACT: SideParts = SideParts {
    bottom: Part::Contact,
    right: Part::Contact,
    top: Part::Contact,
    left: Part::Contact,
};

const LEFT_HELD: SideParts = SideParts {
    bottom: Part::Contact,
    right: Part::Neumann,
    top: Part::Neumann,
    left: Part::Dirichlet,
};

impl TestProblem {
    /// One test problem of each kind.
    pub fn all() -> Vec<Self> {
        NAMES.map(|(problem, _)| problem).to_vec()
    }

    /// The name of the test problem.
    pub fn name(self) -> &'static str {
        NAMES[self as usize].1
    }

    /// The names of all test problems, for help texts and error messages.
    pub fn names() -> &'static str {
        static TEXT: LazyLock<String> = LazyLock::new(|| NAMES.map(|(_, name)| name).join(", "));
        &TEXT
    }

    /// The data that characterise this test problem; those of `manufactured` follow from its solution.
    fn body(self) -> Body {
        match self {
            TestProblem::Block => Body { load: |[x, _]| -(PI * x).cos(), ..ELASTIC },
            TestProblem::Membrane => Body { load: |[x, _]| (2.0 * PI * x).cos() + 0.3, ..SCALAR },
            TestProblem::MembraneReaction => Body {
                form: |_| Ok(Form::Scalar { reaction: 1.0 }),
                mesh: |n, _| unit_square(n, ALL_CONTACT),
                load: |[x, y]| 4.0 * ((PI * x).cos() + (PI * y).cos()),
                ..SCALAR
            },
            TestProblem::Corner => Body {
                mesh: |n, setting| leaning_square(n, setting.angle),
                load: |[x, _]| -2.0 * (PI * x).cos(),
                ..SCALAR
            },
            TestProblem::Incompressible => Body {
                form: |setting| Ok(Form::elastic(Lame::plane_strain(2.5, setting.poisson)?)),
                ..TestProblem::Block.body()
            },
            TestProblem::Leaning => Body {
                mesh: |n, setting| leaning_square(n, setting.angle),
                load: |[x, _]| -(PI * x).cos() - 0.5,
                ..ELASTIC
            },
            TestProblem::Raised => {
                Body { load: |[x, _]| (PI * x).cos(), ..TestProblem::Leaning.body() }
            }
            TestProblem::Taper => Body {
                mesh: |n, setting| taper(n, setting.angle),
                load: |[x, _]| -(PI * x).cos() - 0.5,
                ..ELASTIC
            },
            TestProblem::Bracket => {
                Body { mesh: |n, _| bracket(n), load: |[x, _]| -(PI * x).cos() - 0.5, ..ELASTIC }
            }
            TestProblem::Free => Body { load: |_| 1.0, ..ELASTIC },
            TestProblem::Closed => Body { load: |_| -1.0, ..ELASTIC },
            TestProblem::Manufactured => SCALAR,
        }
    }

    /// True for test problems of elasticity.
    pub fn is_elastic(self) -> bool {
        self.body().is_elastic
    }

    /// The known solution with default parameters; `None` if there is no closed form.
    ///
    /// ```
    /// use signorini::problems::{KnownSolution, TestProblem};
    /// assert_eq!(TestProblem::Manufactured.solution(), Some(KnownSolution::three_halves()));
    /// assert_eq!(TestProblem::Block.solution(), None);
    /// ```
    pub fn solution(self) -> Option<KnownSolution> {
        (self == TestProblem::Manufactured).then(KnownSolution::three_halves)
    }

    /// The structured mesh of the test problem with n × n squares, with default parameters.
    ///
    /// (n + 1)² nodes and 2n² triangles on a square, with legs 1/n; squares are cut from bottom left to top
    /// right. `bracket` consists of three such squares.
    ///
    /// ```
    /// let mesh = signorini::problems::TestProblem::Block.mesh(4)?;
    /// assert_eq!((mesh.nodes().len(), mesh.triangles().len()), (25, 32));
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`TestProblem::mesh_with`], with the default angle.
    pub fn mesh(self, n: usize) -> Result<Triangulation> {
        self.mesh_with(n, &Parameters::default())
    }

    /// The problem on a given triangulation of the domain of the test problem (a level of a hierarchy, for example),
    /// with default parameters.
    ///
    /// ```
    /// use signorini::{cone::Cone, contact::Solver, mesh::Hierarchy, problems::TestProblem};
    /// let hierarchy = Hierarchy::refined(TestProblem::MembraneReaction.mesh(2)?, 1)?;
    /// let fine = TestProblem::MembraneReaction.on(hierarchy.levels()[1].clone())?;
    /// // uniform refinement of a structured mesh gives the structured mesh with 2n × 2n squares
    /// assert_eq!(fine.free_unknowns(), TestProblem::MembraneReaction.problem(4)?.free_unknowns());
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`ContactProblem::new`].
    pub fn on(self, mesh: Triangulation) -> Result<ContactProblem> {
        self.on_with(mesh, &Parameters::default())
    }

    /// The problem on the structured mesh with n × n squares, with default parameters.
    ///
    /// ```
    /// use signorini::{cone::Cone, contact::Solver, problems::TestProblem};
    /// let energy = |cone| -> signorini::Result<f64> {
    ///     Ok(TestProblem::Block.problem(8)?.solve(cone, Solver::ActiveSet)?.energy)
    /// };
    /// // K^h is contained in the midpoint cone, so that the minimum of J over K^h is not smaller
    /// assert!(energy(Cone::Midpoint)? <= energy(Cone::Nodal)?);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`TestProblem::mesh`] and [`TestProblem::on`].
    pub fn problem(self, n: usize) -> Result<ContactProblem> {
        self.problem_with(n, &Parameters::default())
    }

    /// The problem on the structured mesh with n × n squares, with the given parameters.
    ///
    /// # Errors
    /// As for [`TestProblem::mesh_with`] and [`TestProblem::on_with`].
    pub fn problem_with(self, n: usize, setting: &Parameters) -> Result<ContactProblem> {
        self.on_with(self.mesh_with(n, setting)?, setting)
    }

    /// The structured mesh of the test problem with n × n cells, with the given parameters.
    ///
    /// ```
    /// use signorini::problems::{Parameters, TestProblem};
    /// let setting = Parameters { angle: 60.0, ..Parameters::default() };
    /// let mesh = TestProblem::Corner.mesh_with(4, &setting)?;
    /// assert_eq!(mesh.nodes().len(), 25);
    /// assert!(TestProblem::Corner.mesh_with(4, &Parameters { angle: 10.0, ..setting }).is_err());
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) unless 1 ≤ n ≤ 16384 (4096
    /// for `bracket`), [`ToolkitError::TooLarge`](crate::ToolkitError::TooLarge) if there is not enough
    /// memory; [`ToolkitError::OutOfRange`](crate::ToolkitError::OutOfRange) for an angle outside [20, 160]
    /// (`corner`, `leaning`, `raised`) or [70, 160] (`taper`).
    pub fn mesh_with(self, n: usize, setting: &Parameters) -> Result<Triangulation> {
        (self.body().mesh)(n, setting)
    }

    /// The problem on a given triangulation of the domain of the test problem, with the given parameters.
    ///
    /// # Errors
    /// As for [`ContactProblem::new`]; [`ToolkitError::OutOfRange`](crate::ToolkitError::OutOfRange) for a parameter
    /// that is not admissible.
    pub fn on_with(self, mesh: Triangulation, setting: &Parameters) -> Result<ContactProblem> {
        let scale = setting.load_scale;
        Error::require("load scale", scale, "(-inf, inf)", scale.is_finite())?;
        if self == TestProblem::Manufactured {
            return three_halves_problem(mesh, scale);
        }
        let body = self.body();
        let density = body.load;
        let form = (body.form)(setting)?;
        let load = if body.is_elastic {
            Field::Vector(&|point| [0.0, scale * density(point)]).sample(mesh.nodes())?
        } else {
            Field::Scalar(&|point| scale * density(point)).sample(mesh.nodes())?
        };
        ContactProblem::new(mesh, form, &load)
    }
}

impl fmt::Display for TestProblem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for TestProblem {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        let known = NAMES.into_iter().find(|(_, name)| *name == text);
        known.map(|(problem, _)| problem).ok_or_else(|| unknown(text, Self::names()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cone::Cone;
    use crate::contact::Solver;

    #[test]
    fn every_problem_has_the_contact_it_is_named_for() {
        for test_problem in TestProblem::all() {
            let solution =
                test_problem.problem(16).unwrap().solve(Cone::Nodal, Solver::ActiveSet).unwrap();
            let (count, all) = (solution.contact_set.count(), solution.contact_set.constraints());
            match test_problem {
                TestProblem::Free => assert_eq!(count, 0, "{test_problem}"),
                TestProblem::Closed => assert_eq!(count, all, "{test_problem}"),
                _ => assert!(0 < count && count < all, "{test_problem}: {count} of {all}"),
            }
            assert!(
                solution.status.is_converged() && solution.kkt.worst() < 1e-13,
                "{test_problem}"
            );
        }
        let setting = Parameters { angle: 10.0, ..Parameters::default() };
        for test_problem in
            [TestProblem::Corner, TestProblem::Leaning, TestProblem::Raised, TestProblem::Taper]
        {
            assert!(test_problem.problem_with(4, &setting).is_err(), "{test_problem}");
        }
        let setting = Parameters { angle: 60.0, ..Parameters::default() };
        assert!(TestProblem::Taper.mesh_with(4, &setting).is_err());
        let setting = Parameters { poisson: 0.5, ..Parameters::default() };
        assert!(TestProblem::Incompressible.problem_with(4, &setting).is_err());
    }
}
