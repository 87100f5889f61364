//! A body: a mesh, a form, and what acts on it, each as a function of the place, so that the same body can be
//! discretised on every refinement of its mesh.
//!
//! ```text
//! J(v) = ½ a(v, v) − ∫_Ω f·v − ∫_{Γ_N} F·v      over { v = u_D on Γ_D,  v_N ≤ g on Γ_C }
//! ```
//!
//! [`ContactProblem`] is this problem on one mesh: the load by quadrature, u_D and g by their values at the nodes.

use super::problem::ContactProblem;
use crate::error::{Error, Result, ToolkitError};
use crate::fem::{Cubature, Field, Form, load_by_triangles};
use crate::mesh::{Part, Point, Triangulation};
use std::sync::Arc;

/// Points in each direction of the rule for ∫ f·v: exact for f of degree 6.
const POINTS: usize = 4;

/// What a load may be at a place: a number for a scalar problem, two components for an elastic body.
pub trait Value: Copy {
    /// Number of components.
    const COMPONENTS: usize;
    /// The components; the second one of a number is 0.
    fn pair(self) -> Point;
}

impl Value for f64 {
    const COMPONENTS: usize = 1;
    fn pair(self) -> Point {
        [self, 0.0]
    }
}

impl Value for Point {
    const COMPONENTS: usize = 2;
    fn pair(self) -> Point {
        self
    }
}

type Density<'a> = Arc<dyn Fn(Point) -> Point + Send + Sync + 'a>;

/// A density, and the region or group on which it acts; `None`: everywhere.
#[derive(Clone)]
struct Acting<'a> {
    place: Option<usize>,
    density: Density<'a>,
}

/// A mesh, a form, and what acts on it.
///
/// ```
/// use signorini::cone::Cone;
/// use signorini::contact::{Body, Solver};
/// use signorini::fem::{Form, Lame};
/// use signorini::mesh::{SideParts, unit_square};
/// let mesh = unit_square(8, SideParts::HANGING)?;
/// let body = Body::new(mesh, Form::elastic(Lame::new(1.0, 1.0)?))
///     .load(|[x, _]: [f64; 2]| [0.0, 1.0 - 3.0 * x])
///     .gap(|[x, _]| 0.01 * x);
/// let u = body.problem()?.solve(Cone::Nodal, Solver::ActiveSet)?;
/// assert!(u.contact_force > 0.0 && u.kkt.worst() < 1e-12);
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Clone)]
pub struct Body<'a> {
    mesh: Triangulation,
    form: Form,
    loads: Vec<Acting<'a>>,
    tractions: Vec<Density<'a>>,
    displacement: Option<Density<'a>>,
    gap: Option<Density<'a>>,
    /// A datum with the wrong number of components, reported when the body is used.
    wrong: Option<usize>,
}

impl std::fmt::Debug for Body<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Body of {} triangles with {} loads", self.mesh.triangles().len(), self.loads.len())
    }
}

impl<'a> Body<'a> {
    /// The body without any load, with u = 0 on Γ_D and u_N ≤ 0 on Γ_C.
    pub fn new(mesh: Triangulation, form: Form) -> Self {
        let (loads, tractions) = (Vec::new(), Vec::new());
        Self { mesh, form, loads, tractions, displacement: None, gap: None, wrong: None }
    }

    fn density<V: Value>(&mut self, density: impl Fn(Point) -> V + Send + Sync + 'a) -> Density<'a> {
        if V::COMPONENTS != self.form.components() {
            self.wrong = Some(V::COMPONENTS);
        }
        Arc::new(move |point| density(point).pair())
    }

    /// Adds the volume load f, a force per area (scalar: the right-hand side of −Δu = f).
    #[must_use]
    pub fn load<V: Value>(mut self, f: impl Fn(Point) -> V + Send + Sync + 'a) -> Self {
        let density = self.density(f);
        self.loads.push(Acting { place: None, density });
        self
    }

    /// Adds a volume load on the triangles of one region.
    #[must_use]
    pub fn load_on<V: Value>(mut self, region: usize, f: impl Fn(Point) -> V + Send + Sync + 'a) -> Self {
        let density = self.density(f);
        self.loads.push(Acting { place: Some(region), density });
        self
    }

    /// Adds the traction F on Γ_N, a force per length.
    #[must_use]
    pub fn traction<V: Value>(mut self, f: impl Fn(Point) -> V + Send + Sync + 'a) -> Self {
        let density = self.density(f);
        self.tractions.push(density);
        self
    }

    /// Prescribes u = u_D on Γ_D.
    #[must_use]
    pub fn displacement<V: Value>(mut self, data: impl Fn(Point) -> V + Send + Sync + 'a) -> Self {
        self.displacement = Some(self.density(data));
        self
    }

    /// Sets the initial gap g in u_N ≤ g.
    #[must_use]
    pub fn gap(mut self, gap: impl Fn(Point) -> f64 + Send + Sync + 'a) -> Self {
        self.gap = Some(Arc::new(move |point| [gap(point), 0.0]));
        self
    }

    /// The mesh of the body.
    pub fn mesh(&self) -> &Triangulation {
        &self.mesh
    }

    /// The bilinear form.
    pub fn form(&self) -> &Form {
        &self.form
    }

    /// The discrete problem on the mesh of the body.
    ///
    /// # Errors
    /// As for [`Body::problem_on`].
    pub fn problem(&self) -> Result<ContactProblem> {
        self.problem_on(&self.mesh)
    }

    /// The discrete problem on a refinement of the mesh of the body.
    ///
    /// # Errors
    /// As for [`ContactProblem::new`]; [`ToolkitError::LengthMismatch`] for a load with the wrong number of
    /// components, [`ToolkitError::NotFiniteAt`] for a value that is not finite.
    pub fn problem_on(&self, mesh: &Triangulation) -> Result<ContactProblem> {
        let components = self.form.components();
        if let Some(given) = self.wrong {
            let name = "components of a load";
            return Err(Error::Toolkit(ToolkitError::LengthMismatch { name, given, expected: components }));
        }
        let none = vec![0.0; mesh.nodes().len() * components];
        let mut problem = ContactProblem::new(mesh.clone(), self.form.clone(), &none)?;
        let rule = Cubature::new(POINTS)?;
        let load =
            load_by_triangles(mesh, components, &rule, &|t, point| self.load_at(mesh.region(t), point))?;
        problem.add_load(&load)?;
        if !self.tractions.is_empty() {
            problem.add_boundary_load(Part::Neumann, &|point, _| self.traction_at(point))?;
        }
        if let Some(data) = &self.displacement {
            let (scalar, vector) = (|point| data(point)[0], |point| data(point));
            let field = if components == 1 { Field::Scalar(&scalar) } else { Field::Vector(&vector) };
            problem.set_dirichlet(&field)?;
        }
        if let Some(gap) = &self.gap {
            problem.set_gap(|point| gap(point)[0])?;
        }
        Ok(problem)
    }

    /// f at a point of a triangle of the region.
    pub(crate) fn load_at(&self, region: usize, point: Point) -> Result<Point> {
        let acting = self.loads.iter().filter(|load| load.place.is_none_or(|place| place == region));
        sum(acting.map(|load| (load.density)(point)), point)
    }

    /// The part of f that acts everywhere, without regard to regions, also off the body.
    pub(crate) fn common_load_at(&self, point: Point) -> Point {
        let acting = self.loads.iter().filter(|load| load.place.is_none());
        acting.map(|load| (load.density)(point)).fold([0.0; 2], |[a, b], [x, y]| [a + x, b + y])
    }

    /// Whether a load acts, of those that act everywhere and of those on single regions.
    pub(crate) fn has_loads(&self) -> [bool; 2] {
        [true, false].map(|everywhere| self.loads.iter().any(|load| load.place.is_none() == everywhere))
    }

    /// F at a point of Γ_N.
    pub(crate) fn traction_at(&self, point: Point) -> Result<Point> {
        sum(self.tractions.iter().map(|traction| traction(point)), point)
    }

    /// u_D at a point of Γ_D.
    pub(crate) fn displacement_at(&self, point: Point) -> Result<Point> {
        sum(self.displacement.iter().map(|data| data(point)), point)
    }

    /// g at a point of Γ_C.
    pub(crate) fn gap_at(&self, point: Point) -> Result<f64> {
        sum(self.gap.iter().map(|gap| gap(point)), point).map(|[gap, _]| gap)
    }
}

fn sum(values: impl Iterator<Item = Point>, point: Point) -> Result<Point> {
    let total = values.fold([0.0; 2], |[a, b], [x, y]| [a + x, b + y]);
    match total.into_iter().find(|v| !v.is_finite()) {
        Some(value) => {
            let name = "value of a load or of a function";
            Err(Error::Toolkit(ToolkitError::NotFiniteAt { name, point, value }))
        }
        None => Ok(total),
    }
}
