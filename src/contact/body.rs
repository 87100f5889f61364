//! A body: a mesh, a form, and what acts on it, each as a function of the place and, where wanted, on one
//! group of the boundary or one region only, so that the same body can be
//! discretised on every refinement of its mesh.
//!
//! ```text
//! J(v) = ½ a(v, v) − ∫_Ω f·v − ∫_{Γ_N} F·v      over { v = u_D on Γ_D,  v_N ≤ g on Γ_C }
//! ```
//!
//! [`ContactProblem`] is this problem on one mesh: the load by quadrature, u_D and g by their values at the nodes.

use super::problem::ContactProblem;
use crate::error::{Error, Result, ToolkitError};
use crate::fem::{Cubature, Form, load_by_edges, load_by_triangles};
use crate::mesh::{Part, Point, Triangulation};
use fractional_sobolev::gauss_legendre;
use std::borrow::Borrow;
use std::sync::Arc;

/// Points in each direction of the rule for ∫ f·v: exact for f of degree 6.
const POINTS: usize = 4;
/// Points of the rule that shows what the other one misses.
const FINER: usize = 7;
/// The same on an edge: there the bounds take eight points, the discrete problem takes five.
const ON_EDGES: [usize; 2] = [5, 9];
/// Displacements of two groups at a common node that differ by less than this multiple of the largest agree.
const ROUNDED: f64 = 1e-12;

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

/// A function, and the number of the region or the name of the boundary group where it acts; `None`: everywhere.
#[derive(Clone)]
struct Acting<'a, Place> {
    place: Option<Place>,
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
///
/// What acts on a part of the body is added by the name of the boundary group or the region, as the mesh has it
/// ([`Triangulation::groups`], [`Triangulation::region_names`]). A name that the mesh does not have is an error of
/// [`Body::problem`]:
///
/// ```
/// # use signorini::{contact::Body, fem::Form, mesh::{SideParts, unit_square}};
/// let mesh = unit_square(8, SideParts::HANGING)?.with_groups(&[
///     "floor", "floor", "floor", "floor", "floor", "floor", "floor", "floor",
///     "right", "right", "right", "right", "right", "right", "right", "right",
///     "top", "top", "top", "top", "top", "top", "top", "top",
///     "left", "left", "left", "left", "left", "left", "left", "left",
/// ])?;
/// let body = Body::new(mesh, Form::LAPLACE).gap_on("floor", |_| 0.1);
/// let wrong = body.clone().traction_on("top", |_: [f64; 2]| 1.0).problem().unwrap_err();
/// assert_eq!(wrong.to_string(), "the mesh has no free boundary group 'top': it has right, left");
/// assert!(body.traction_on("left", |_: [f64; 2]| 1.0).problem().is_ok());
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Clone)]
pub struct Body<'a> {
    mesh: Triangulation,
    form: Form,
    loads: Vec<Acting<'a, usize>>,
    tractions: Vec<Acting<'a, String>>,
    displacements: Vec<Acting<'a, String>>,
    gaps: Vec<Acting<'a, String>>,
    /// The first datum with the wrong number of components or with an unknown name, reported when the body is used.
    wrong: Option<Error>,
}

impl std::fmt::Debug for Body<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(
            f,
            "Body of {} triangles with {} loads",
            self.mesh.triangles().len(),
            self.loads.len()
        )
    }
}

impl<'a> Body<'a> {
    /// The body without any load, with u = 0 on Γ_D and u_N ≤ 0 on Γ_C.
    pub fn new(mesh: Triangulation, form: Form) -> Self {
        let (loads, tractions, displacements, gaps) =
            (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        Self { mesh, form, loads, tractions, displacements, gaps, wrong: None }
    }

    /// What acts at a place.
    fn acting<V: Value, Place>(
        &mut self,
        name: &'static str,
        place: Option<Place>,
        density: impl Fn(Point) -> V + Send + Sync + 'a,
    ) -> Acting<'a, Place> {
        let (given, expected) = (V::COMPONENTS, self.form.components());
        if given != expected {
            self.wrong.get_or_insert(Error::Toolkit(ToolkitError::LengthMismatch {
                name,
                given,
                expected,
            }));
        }
        Acting { place, density: Arc::new(move |point| density(point).pair()) }
    }

    /// The name of a group of the given part.
    fn group(&mut self, what: &'static str, part: Part, name: &str) -> Option<String> {
        let edges = self.mesh.boundary().iter().enumerate().filter(|(_, edge)| edge.part == part);
        let mut known: Vec<&str> = Vec::new();
        for group in edges.map(|(number, _)| self.mesh.group(number)) {
            if !known.contains(&group) {
                known.push(group);
            }
        }
        if !known.contains(&name) {
            self.wrong.get_or_insert(no_group(what, name, &known));
        }
        Some(name.to_owned())
    }

    /// Adds the volume load f, a force per area (scalar: the right-hand side of −Δu = f).
    #[must_use]
    pub fn load<V: Value>(mut self, f: impl Fn(Point) -> V + Send + Sync + 'a) -> Self {
        let acting = self.acting("components of the load", None, f);
        self.loads.push(acting);
        self
    }

    /// Adds a volume load on the triangles of one region, by its name.
    #[must_use]
    pub fn load_on<V: Value>(
        mut self,
        region: &str,
        f: impl Fn(Point) -> V + Send + Sync + 'a,
    ) -> Self {
        let names = self.mesh.region_names();
        let number = names.iter().position(|name| name == region);
        if number.is_none() {
            let known: Vec<&str> = names.iter().map(String::as_str).collect();
            self.wrong.get_or_insert(no_group("region", region, &known));
        }
        let acting = self.acting("components of the load", number.filter(|_| names.len() > 1), f);
        self.loads.push(acting);
        self
    }

    /// Adds the traction F on Γ_N, a force per length.
    #[must_use]
    pub fn traction<V: Value>(mut self, f: impl Fn(Point) -> V + Send + Sync + 'a) -> Self {
        let acting = self.acting("components of the traction", None, f);
        self.tractions.push(acting);
        self
    }

    /// Adds a traction on one group of Γ_N.
    #[must_use]
    pub fn traction_on<V: Value>(
        mut self,
        group: &str,
        f: impl Fn(Point) -> V + Send + Sync + 'a,
    ) -> Self {
        let place = self.group("free boundary group", Part::Neumann, group);
        let acting = self.acting("components of the traction", place, f);
        self.tractions.push(acting);
        self
    }

    /// Prescribes u = u_D on Γ_D, on groups for which no other displacement is given.
    #[must_use]
    pub fn displacement<V: Value>(mut self, data: impl Fn(Point) -> V + Send + Sync + 'a) -> Self {
        let acting = self.acting("components of the displacement", None, data);
        self.displacements.push(acting);
        self
    }

    /// Prescribes u = u_D on one group of Γ_D; of several for the same group the last one counts.
    ///
    /// Where two groups meet their displacements have to agree.
    #[must_use]
    pub fn displacement_on<V: Value>(
        mut self,
        group: &str,
        data: impl Fn(Point) -> V + Send + Sync + 'a,
    ) -> Self {
        let place = self.group("clamped boundary group", Part::Dirichlet, group);
        let acting = self.acting("components of the displacement", place, data);
        self.displacements.push(acting);
        self
    }

    /// Sets the initial gap g in u_N ≤ g, on groups for which no other gap is given.
    #[must_use]
    pub fn gap(mut self, gap: impl Fn(Point) -> f64 + Send + Sync + 'a) -> Self {
        self.gaps.push(Acting { place: None, density: Arc::new(move |point| [gap(point), 0.0]) });
        self
    }

    /// Sets the initial gap on one group of Γ_C; of several for the same group the last one counts.
    ///
    /// At a common node of two groups the smaller gap holds.
    #[must_use]
    pub fn gap_on(mut self, group: &str, gap: impl Fn(Point) -> f64 + Send + Sync + 'a) -> Self {
        let place = self.group("contact boundary group", Part::Contact, group);
        self.gaps.push(Acting { place, density: Arc::new(move |point| [gap(point), 0.0]) });
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
    /// As for [`ContactProblem::new`]; [`Error::NoGroup`] for a name that the mesh does not have,
    /// [`ToolkitError::LengthMismatch`] for a load with the wrong number of components, [`ToolkitError::NotFiniteAt`] for
    /// a value that is not finite, [`ToolkitError::Node`] where the displacements of two groups differ at a common node.
    pub fn problem_on(&self, mesh: &Triangulation) -> Result<ContactProblem> {
        if let Some(wrong) = &self.wrong {
            return Err(wrong.clone());
        }
        let components = self.form.components();
        let none = vec![0.0; mesh.nodes().len() * components];
        let mut problem = ContactProblem::new(mesh.clone(), self.form.clone(), &none)?;
        let rule = Cubature::new(POINTS)?;
        let load = load_by_triangles(mesh, components, &rule, &|t, point| {
            self.load_at(mesh.region(t), point)
        })?;
        problem.add_load(&load)?;
        if !self.tractions.is_empty() {
            let traction = |edge, point, _| self.traction_at(mesh.group(edge), point);
            problem.add_load_of_edges(Part::Neumann, &traction)?;
        }
        if !self.displacements.is_empty() {
            problem.set_dirichlet_values(&self.displacements_of(mesh)?)?;
        }
        if !self.gaps.is_empty() {
            let mut gaps = vec![f64::INFINITY; mesh.nodes().len()];
            for (number, edge) in mesh.boundary().iter().enumerate() {
                for node in edge.nodes.into_iter().filter(|_| edge.part == Part::Contact) {
                    gaps[node] =
                        gaps[node].min(self.gap_at(mesh.group(number), mesh.nodes()[node])?);
                }
            }
            let at_nodes: Vec<f64> =
                problem.edge().nodes().iter().map(|&node| gaps[node]).collect();
            problem.set_gap_values(at_nodes)?;
        }
        Ok(problem)
    }

    /// u_D at the nodes of Γ_D, 0 elsewhere.
    fn displacements_of(&self, mesh: &Triangulation) -> Result<Vec<f64>> {
        let components = self.form.components();
        let mut found: Vec<Option<Point>> = vec![None; mesh.nodes().len()];
        let (mut largest, mut apart) = (0.0_f64, (0.0_f64, 0));
        for (number, edge) in mesh.boundary().iter().enumerate() {
            for node in edge.nodes.into_iter().filter(|_| edge.part == Part::Dirichlet) {
                let own = self.displacement_at(mesh.group(number), mesh.nodes()[node])?;
                let before = found[node].replace(own).unwrap_or(own);
                let off = (0..2).fold(0.0, |off: f64, c| off.max((own[c] - before[c]).abs()));
                largest = largest.max(own[0].abs()).max(own[1].abs());
                if off > apart.0 {
                    apart = (off, node);
                }
            }
        }
        if apart.0 > ROUNDED * largest {
            let reason = "is in two clamped groups whose prescribed displacements differ there";
            return Err(Error::Toolkit(ToolkitError::Node { node: mesh.number(apart.1), reason }));
        }
        let at_node = |value: &Option<Point>| value.unwrap_or_default();
        Ok(found.iter().flat_map(|value| at_node(value).into_iter().take(components)).collect())
    }

    /// What the rules for loads and tractions may miss of l(u), and of J(u): Σ |ΔF_i u_i|, ΔF the change of the load vector
    /// from 4 × 4 to 7 × 7 points a triangle and from 5 to 9 points an edge, as dJ = −dF·u. Large for a load that jumps, or
    /// varies within a triangle. An estimate.
    ///
    /// ```
    /// use signorini::{cone::Cone, contact::{Body, Solver}, fem::Form, mesh::{SideParts, unit_square}};
    /// let mesh = unit_square(4, SideParts::HANGING)?;
    /// let step = |[x, _]: [f64; 2]| if x > 0.4 { 1.0 } else { 0.0 };
    /// for (load, resolved) in [(Body::new(mesh.clone(), Form::LAPLACE).load(step), false),
    ///     (Body::new(mesh, Form::LAPLACE).load(|[x, y]: [f64; 2]| x * y), true)] {
    ///     let u = load.problem()?.solve(Cone::Nodal, Solver::ActiveSet)?;
    ///     let missed = load.missed_load(load.mesh(), &u.displacement)?;
    ///     assert_eq!(missed < 1e-12 * u.energy.abs(), resolved);
    /// }
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`Body::problem_on`]; [`ToolkitError::LengthMismatch`] for a displacement of another mesh.
    pub fn missed_load(&self, mesh: &Triangulation, displacement: &[f64]) -> Result<f64> {
        let components = self.form.components();
        crate::numeric::check::require_length(
            "displacement",
            displacement.len(),
            mesh.nodes().len() * components,
        )?;
        let vector = |points: usize| {
            let density = |t: usize, point: Point| self.load_at(mesh.region(t), point);
            load_by_triangles(mesh, components, &Cubature::new(points)?, &density)
        };
        let on_edges = |points: usize| {
            let density = |edge, point: Point, _| self.traction_at(mesh.group(edge), point);
            let rule = gauss_legendre(points)?;
            load_by_edges(mesh, Part::Neumann, components, &density, &rule)
        };
        let missed = |used: Vec<f64>, finer: Vec<f64>| -> f64 {
            let terms = used.iter().zip(&finer).zip(displacement);
            terms.map(|((f, finer), u)| ((f - finer) * u).abs()).sum()
        };
        let of_load = missed(vector(POINTS)?, vector(FINER)?);
        if !self.has_tractions() {
            return Ok(of_load);
        }
        let [used, finer] = ON_EDGES;
        Ok(of_load + missed(on_edges(used)?, on_edges(finer)?))
    }

    /// Whether a traction was given.
    pub(crate) fn has_tractions(&self) -> bool {
        !self.tractions.is_empty()
    }

    /// f at a point of a triangle of the region.
    pub(crate) fn load_at(&self, region: usize, point: Point) -> Result<Point> {
        sum("load", acting_on(&self.loads, &region), point)
    }

    /// The part of f that acts everywhere, without regard to regions, also off the body.
    pub(crate) fn common_load_at(&self, point: Point) -> Point {
        let acting = self.loads.iter().filter(|load| load.place.is_none());
        acting.map(|load| (load.density)(point)).fold([0.0; 2], |[a, b], [x, y]| [a + x, b + y])
    }

    /// Whether a load acts, of those that act everywhere and of those on single regions.
    pub(crate) fn has_loads(&self) -> [bool; 2] {
        [true, false]
            .map(|everywhere| self.loads.iter().any(|load| load.place.is_none() == everywhere))
    }

    /// Whether neither a gap nor a displacement was given, so that the admissible displacements are a cone.
    pub(crate) fn has_zero_data(&self) -> bool {
        self.gaps.is_empty() && self.displacements.is_empty()
    }

    /// F at a point of a group of Γ_N.
    pub(crate) fn traction_at(&self, group: &str, point: Point) -> Result<Point> {
        sum("traction", acting_on(&self.tractions, group), point)
    }

    /// u_D at a point of a group of Γ_D.
    pub(crate) fn displacement_at(&self, group: &str, point: Point) -> Result<Point> {
        sum("prescribed displacement", one_on(&self.displacements, group), point)
    }

    /// g at a point of a group of Γ_C.
    pub(crate) fn gap_at(&self, group: &str, point: Point) -> Result<f64> {
        sum("gap", one_on(&self.gaps, group), point).map(|[gap, _]| gap)
    }
}

fn no_group(what: &'static str, name: &str, known: &[&str]) -> Error {
    let known = if known.is_empty() { "none".to_owned() } else { known.join(", ") };
    Error::NoGroup { what, given: name.to_owned(), known }
}

/// All that acts on a region or a group.
fn acting_on<'s, 'a, Place: Borrow<Name>, Name: PartialEq + ?Sized>(
    all: &'s [Acting<'a, Place>],
    name: &'s Name,
) -> impl Iterator<Item = &'s Density<'a>> {
    all.iter()
        .filter(move |one| one.place.as_ref().is_none_or(|place| place.borrow() == name))
        .map(|one| &one.density)
}

/// The last one given for the group, or else the last one for all groups.
fn one_on<'s, 'a>(
    all: &'s [Acting<'a, String>],
    group: &str,
) -> impl Iterator<Item = &'s Density<'a>> {
    let own = all.iter().rfind(|one| one.place.as_deref() == Some(group));
    own.or_else(|| all.iter().rfind(|one| one.place.is_none())).map(|one| &one.density).into_iter()
}

fn sum<'s, 'a: 's>(
    name: &'static str,
    acting: impl Iterator<Item = &'s Density<'a>>,
    point: Point,
) -> Result<Point> {
    let total =
        acting.map(|density| density(point)).fold([0.0; 2], |[a, b], [x, y]| [a + x, b + y]);
    match total.into_iter().find(|v| !v.is_finite()) {
        Some(value) => Err(Error::Toolkit(ToolkitError::NotFiniteAt { name, point, value })),
        None => Ok(total),
    }
}
