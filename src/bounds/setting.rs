//! What is the same for all steps on one mesh: edges with their triangles, the load split into what
//! an exact stress carries and what is left to the triangles, and the tractions that remain on the
//! boundary.

use super::boundary_values::Lift;
use super::element::{Linear, Side, Traction, Value, add, combine, pieces, side, traction};
use super::own::{Curved, Own};
use super::polynomial::{LANES, MOST, Particular};
use super::rule::TriangleRule;
use crate::contact::Body;
use crate::error::{Error, Result};
use crate::fem::{Element, Form, Lame};
use crate::mesh::{Edges, Part, Point, Triangulation, distance, doubled_area};
use crate::numeric::parallel;
use fractional_sobolev::{Rule, gauss_legendre};

/// Gauss points on an edge of the boundary.
const EDGE_POINTS: usize = 8;
/// Points in each direction for a load that is left to a triangle.
const OWN_POINTS: usize = 5;
/// Points in each direction for squares of cubic polynomials.
const CUBIC_POINTS: usize = 4;
/// A traction whose deviation from a linear one is below this multiple of it is linear.
const LINEAR: f64 = 1e-13;

/// Relative error of the rules by which the bound is computed.
pub(super) const QUADRATURE: f64 = 1e-10;
/// Relative error of the rules for the right-hand side of the equations of the stress. Any stress
/// of the space gives a bound, and near the best one the energy depends on the square of this.
pub(super) const OF_EQUATIONS: f64 = 1e-5;

/// A side of a triangle: its edge, and whether it runs against the edge's orientation.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct SideOf {
    pub(super) edge: usize,
    pub(super) flipped: bool,
}

/// An edge of the boundary, from the first to the second node with the body on the left.
#[derive(Debug, Clone)]
pub(super) struct Border {
    pub(super) edge: usize,
    pub(super) part: Part,
    /// Number of the edge among the boundary edges of the mesh, which gives the name of its group.
    pub(super) number: usize,
    pub(super) triangle: usize,
    /// Number of the side in the triangle.
    pub(super) side: usize,
    /// F − q_p n (Neumann) or −q_p n (contact), q_p the exact stress, is projected on tractions of
    /// degree three; these are the values of the projection, normal and tangential, at both ends,
    /// and with them the linear traction that the unknown stress has to have. With a reaction term
    /// the projection is that on linear tractions. 0 on Γ_D.
    pub(super) linear: [[f64; 2]; 2],
    /// The projection less that linear traction, which the triangle carries by itself.
    pub(super) curved: Curved,
    /// ‖what is left over‖ in L²: orthogonal to the tractions of the projection.
    pub(super) left_over: f64,
}

/// The triangles on which the stress was computed, if they are not those of the mesh but their
/// ancestors.
#[derive(Debug, Clone)]
pub(super) struct Hosts {
    pub(super) corners: Vec<[Point; 3]>,
    /// The ancestor of every triangle.
    pub(super) of: Vec<u32>,
}

/// The data of a body on one mesh.
pub(super) struct Setting<'s, 'b> {
    pub(super) body: &'s Body<'b>,
    pub(super) mesh: &'s Triangulation,
    pub(super) components: usize,
    pub(super) tractions: Traction,
    pub(super) sides: Vec<[SideOf; 3]>,
    /// The triangles with their sides at every edge; the second is absent on the boundary.
    pub(super) around: Vec<[Option<(usize, usize)>; 2]>,
    pub(super) borders: Vec<Border>,
    /// For every edge the number of its border.
    pub(super) border_of: Vec<Option<usize>>,
    /// Rules of n × n points on the pieces of a triangle, n = 2, 3, .. ; small triangles need fewer
    /// points.
    rules: Vec<TriangleRule>,
    /// The fewest points in each direction.
    fewest: usize,
    pub(super) edge_rule: Rule,
    pub(super) particular: Option<Particular>,
    /// Whether some load is left to the triangles.
    pub(super) local: bool,
    /// The ancestors of the triangles, which have the stress.
    pub(super) hosts: Option<Hosts>,
    /// The stress that a triangle (or the ancestor) has by itself; empty if none has.
    own: Vec<Option<Box<Own>>>,
    /// Prescribed displacements that are not linear on an edge, by triangle.
    pub(super) lifts: Vec<Vec<Lift>>,
}

/// A point of the rule: its piece, barycentric coordinates there, weight, and the part of the
/// stress that is known and not linear on the pieces.
pub(super) struct Sample {
    pub(super) piece: usize,
    pub(super) shares: [f64; 3],
    pub(super) point: Point,
    pub(super) weight: f64,
    pub(super) exact: Value,
}

impl Sample {
    /// q at the point: the field of the triangle and the rest.
    pub(super) fn stress(&self, field: &Linear) -> Value {
        let mut value = combine(&self.shares, &field[self.piece]);
        (0..3).for_each(|c| value[c] += self.exact[c]);
        value
    }
}

impl<'s, 'b> Setting<'s, 'b> {
    pub(super) fn new(
        body: &'s Body<'b>,
        mesh: &'s Triangulation,
        tractions: Traction,
    ) -> Result<Self> {
        let mut setting = Self::without_own(body, mesh, tractions)?;
        let rule = TriangleRule::new(OWN_POINTS)?;
        if setting.local || setting.borders.iter().any(|border| !border.curved.is_none()) {
            setting.own = parallel::map_together(mesh.triangles().len(), 256, &|t| {
                setting.own_stress(t, &rule)
            })
            .into_iter()
            .collect::<Result<_>>()?;
        }
        Ok(setting)
    }

    /// The stress that one triangle has by itself, if it has a load or tractions of its own.
    fn own_stress(&self, t: usize, rule: &TriangleRule) -> Result<Option<Box<Own>>> {
        let curved = [0, 1, 2].map(|k| {
            let border = &self.borders[self.border_of[self.sides[t][k].edge]?];
            (!border.curved.is_none()).then_some(border.curved)
        });
        if !self.local && curved.iter().all(Option::is_none) {
            return Ok(None);
        }
        let region = self.mesh.region(t);
        // What the common stress does not carry.
        let load = |point| {
            if !self.local {
                return Ok([0.0; 2]);
            }
            let mut value = self.body.load_at(region, point)?;
            if self.particular.is_some() {
                let common = self.body.common_load_at(point);
                value = [value[0] - common[0], value[1] - common[1]];
            }
            Ok(value)
        };
        let own = Own::new(self.components, (t, self.mesh.corners(t)), curved, load, rule)?;
        Ok(own.map(Box::new))
    }

    /// The same on a refinement, for a stress of this mesh.
    pub(super) fn refined<'m>(
        &self,
        mesh: &'m Triangulation,
        of: Vec<u32>,
    ) -> Result<Setting<'m, 'b>>
    where
        's: 'm,
    {
        let mut setting = Setting::without_own(self.body, mesh, self.tractions)?;
        let corners = (0..self.mesh.triangles().len()).map(|t| self.mesh.corners(t)).collect();
        setting.hosts = Some(Hosts { corners, of });
        setting.own = self.own.clone();
        Ok(setting)
    }

    fn without_own(
        body: &'s Body<'b>,
        mesh: &'s Triangulation,
        tractions: Traction,
    ) -> Result<Self> {
        let components = body.form().components();
        let edges = Edges::new(mesh.nodes().len(), mesh.triangles());
        let count = edges.pairs().len();
        let mut around = vec![[None; 2]; count];
        let mut sides = Vec::with_capacity(mesh.triangles().len());
        for (t, corners) in mesh.triangles().iter().enumerate() {
            let mut of = [SideOf::default(); 3];
            for k in 0..3 {
                let edge = edges.find(corners[k], corners[(k + 1) % 3])?;
                let flipped = around[edge][0].is_some();
                around[edge][usize::from(flipped)] = Some((t, k));
                of[k] = SideOf { edge, flipped };
            }
            sides.push(of);
        }
        let reaction = reaction(body.form()) > 0.0;
        let [common, regional] = body.has_loads();
        let bounds = bounding_box(mesh);
        let particular = if common && !reaction {
            Particular::new(components, bounds, |point| body.common_load_at(point))
        } else {
            None
        };
        let mut setting = Self {
            body,
            mesh,
            components,
            tractions,
            sides,
            around,
            borders: Vec::new(),
            border_of: vec![None; count],
            rules: (2..=MOST).map(TriangleRule::new).collect::<Result<_>>()?,
            fewest: if reaction { 5 } else { 2 },
            edge_rule: gauss_legendre(EDGE_POINTS)?,
            local: !reaction && (regional || common && particular.is_none()),
            particular,
            hosts: None,
            own: Vec::new(),
            lifts: vec![Vec::new(); mesh.triangles().len()],
        };
        for (number, border) in mesh.boundary().iter().enumerate() {
            let edge = edges.find(border.nodes[0], border.nodes[1])?;
            let no_triangle = || Error::count("triangles at a boundary edge", 0, "{1}");
            let (triangle, side) = setting.around[edge][0].ok_or_else(no_triangle)?;
            setting.border_of[edge] = Some(setting.borders.len());
            let (linear, curved, left_over) =
                setting.border_data(triangle, side, border.part, number)?;
            let border = Border {
                edge,
                part: border.part,
                number,
                triangle,
                side,
                linear,
                curved,
                left_over,
            };
            if border.part == Part::Dirichlet {
                let corners = mesh.corners(triangle);
                let (a, b) = (corners[side], corners[(side + 1) % 3]);
                let at = |s: f64| {
                    let point = [a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1])];
                    body.displacement_at(mesh.group(number), point)
                };
                setting.lifts[triangle].extend(Lift::through(side, &setting.edge_rule, at)?);
            }
            setting.borders.push(border);
        }
        if setting.lifts.iter().any(|lifts| !lifts.is_empty()) {
            setting.fewest = 5; // squares of polynomials of degree four
        }
        Ok(setting)
    }

    pub(super) fn reaction(&self) -> f64 {
        reaction(self.body.form())
    }

    pub(super) fn edges(&self) -> usize {
        self.around.len()
    }

    /// Unknowns per edge.
    pub(super) fn per_edge(&self) -> usize {
        match (self.components, self.tractions) {
            (1, Traction::Reduced) => 1,
            (1, Traction::Linear) => 2,
            (_, Traction::Reduced) => 3,
            (_, Traction::Linear) => 4,
        }
    }

    /// Lengths of the sides are those of the triangle.
    pub(super) fn side(&self, triangle: usize, k: usize) -> Side {
        side(self.mesh.corners(triangle), k)
    }

    pub(super) fn material(&self, triangle: usize) -> Option<Lame> {
        self.body.form().material(self.mesh.region(triangle))
    }

    /// s : 𝒜⁻¹ t, or s·t for fluxes; without cancellation near Poisson's ratio ½.
    pub(super) fn compliance(&self, triangle: usize) -> impl Fn(&Value, &Value) -> f64 + use<> {
        let material = self.material(triangle);
        let inverse = material.map(|m| [0.5 / m.mu(), 0.25 / (m.lambda() + m.mu())]);
        move |s: &Value, t: &Value| match inverse {
            None => s[0] * t[0] + s[1] * t[1],
            Some([shear, bulk]) => {
                // Deviator and trace: s : t/(2μ) − λ/(4μ(λ + μ)) tr s tr t.
                let (ds, dt) = (0.5 * (s[0] - s[1]), 0.5 * (t[0] - t[1]));
                let traces = (s[0] + s[1]) * (t[0] + t[1]);
                shear * 2.0 * (ds * dt + s[2] * t[2]) + bulk * traces
            }
        }
    }

    /// The linear map after which s : 𝒜⁻¹ t is the dot product: deviator, shear and trace, each
    /// times the root of its compliance; a flux is kept.
    pub(super) fn compliance_root(&self, triangle: usize) -> impl Fn(&Value) -> Value + use<> {
        let roots = self
            .material(triangle)
            .map(|m| [m.mu().powf(-0.5), 0.5 * (m.lambda() + m.mu()).powf(-0.5)]);
        move |s: &Value| match roots {
            None => [s[0], s[1], 0.0],
            Some([shear, bulk]) => {
                [0.5 * shear * (s[0] - s[1]), shear * s[2], bulk * (s[0] + s[1])]
            }
        }
    }

    /// The exact stress of the part of the load that is a polynomial.
    pub(super) fn exact_at(&self, point: Point) -> Value {
        self.particular.as_ref().map_or([0.0; 3], |particular| particular.at(&[point; LANES])[0])
    }

    /// The triangle, or its ancestor, on which the stress was computed.
    pub(super) fn host(&self, t: usize) -> usize {
        self.hosts.as_ref().map_or(t, |hosts| hosts.of[t] as usize)
    }

    /// Its corners.
    pub(super) fn host_corners(&self, t: usize) -> [Point; 3] {
        match &self.hosts {
            Some(hosts) => hosts.corners[hosts.of[t] as usize],
            None => self.mesh.corners(t),
        }
    }

    /// The stress that the triangle, or its ancestor, has by itself.
    pub(super) fn own_of(&self, t: usize) -> Option<&Own> {
        self.own.get(self.host(t))?.as_deref()
    }

    /// The piece and the barycentric coordinates there of a point on a side.
    pub(super) fn on_side(&self, t: usize, k: usize, s: f64, point: Point) -> (usize, [f64; 3]) {
        if self.hosts.is_none() {
            return (k, [1.0 - s, s, 0.0]);
        }
        let whole = self.host_corners(t);
        let at = Element::new(whole).barycentric(whole, point);
        let low = (0..3).fold(0, |low, m| if at[m] < at[low] { m } else { low });
        ((low + 1) % 3, in_piece(at, (low + 1) % 3))
    }

    /// The rule of the given relative error for a triangle.
    fn rule_for(&self, t: usize, tolerance: f64) -> &TriangleRule {
        let corners = self.mesh.corners(t);
        let is_cubic = self.own_of(t).is_some_and(|own| !own.is_linear());
        let fewest = if is_cubic { CUBIC_POINTS } else { 2 };
        let diameter =
            (0..3).fold(0.0, |m: f64, k| m.max(distance(corners[k], corners[(k + 1) % 3])));
        let points =
            self.particular.as_ref().map_or(2, |particular| particular.points(diameter, tolerance));
        &self.rules[points.max(self.fewest).max(fewest) - 2]
    }

    /// The points of a rule of the given relative error on the pieces of a triangle, or on its
    /// parts in the pieces of the ancestor.
    pub(super) fn samples(&self, t: usize, tolerance: f64) -> Vec<Sample> {
        let corners = self.mesh.corners(t);
        let rule = self.rule_for(t, tolerance);
        let mut samples = Vec::with_capacity(3 * rule.points.len());
        let mut add = |piece: usize, shares: [f64; 3], point: Point, weight: f64| {
            samples.push(Sample { piece, shares, point, weight, exact: [0.0; 3] });
        };
        if self.hosts.is_some() {
            let whole = self.host_corners(t);
            let element = Element::new(whole);
            let at = corners.map(|point| element.barycentric(whole, point));
            let area = 0.5 * doubled_area(whole);
            for piece in 0..3 {
                let (part, count) = clipped(at, piece);
                for i in 2..count {
                    let triangle = [part[0], part[i - 1], part[i]];
                    let weight = area * determinant(&triangle);
                    for (shares, share) in &rule.points {
                        let at = combine(shares, &triangle);
                        add(piece, in_piece(at, piece), combine(&at, &whole), share * weight);
                    }
                }
            }
        } else {
            let share = doubled_area(corners) / 6.0;
            for (piece, own) in pieces(corners).iter().enumerate() {
                for (shares, weight) in &rule.points {
                    add(piece, *shares, combine(shares, own), weight * share);
                }
            }
        }
        if let Some(particular) = &self.particular {
            for samples in samples.chunks_mut(LANES) {
                let last = samples.len() - 1;
                let points = std::array::from_fn(|j| samples[j.min(last)].point);
                let values = particular.at(&points);
                samples.iter_mut().zip(values).for_each(|(sample, exact)| sample.exact = exact);
            }
        }
        if let Some(own) = self.own_of(t).filter(|own| !own.is_linear()) {
            for sample in &mut samples {
                let more = own.at(sample.piece, sample.shares);
                (0..3).for_each(|c| sample.exact[c] += more[c]);
            }
        }
        samples
    }

    /// For an edge of the boundary: the linear part of F − q_p n, or of −q_p n on Γ_C, the rest up
    /// to degree three, and the norm of what is left. With a reaction term the rest is left over as
    /// well.
    fn border_data(
        &self,
        triangle: usize,
        k: usize,
        part: Part,
        number: usize,
    ) -> Result<([[f64; 2]; 2], Curved, f64)> {
        let none = Curved::default();
        if part == Part::Dirichlet {
            return Ok(([[0.0; 2]; 2], none, 0.0));
        }
        let corners = self.mesh.corners(triangle);
        let (a, b) = (corners[k], corners[(k + 1) % 3]);
        let side = side(corners, k);
        let mut samples = Vec::with_capacity(EDGE_POINTS);
        for (s, weight) in self.edge_rule.iter() {
            let point = [a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1])];
            let mut value = traction(self.components, self.exact_at(point), &side).map(|v| -v);
            if part == Part::Neumann {
                let [x, y] = self.body.traction_at(self.mesh.group(number), point)?;
                let ([nx, ny], [tx, ty]) = (side.normal, side.tangent);
                let given = if self.components == 1 {
                    [x, 0.0]
                } else {
                    [x * nx + y * ny, x * tx + y * ty]
                };
                value = [value[0] + given[0], value[1] + given[1]];
            }
            samples.push((s, weight, value));
        }
        let largest =
            samples.iter().flat_map(|(_, _, value)| value).fold(0.0, |m: f64, v| m.max(v.abs()));
        if largest == 0.0 {
            return Ok(([[0.0; 2]; 2], none, 0.0));
        }
        // Legendre's polynomials P_0, .., P_3 of r = 2s − 1, and the coefficients of the
        // projection.
        let legendre = |s: f64| {
            let r = 2.0 * s - 1.0;
            [1.0, r, 1.5 * r * r - 0.5, r * (2.5 * r * r - 1.5)]
        };
        let mut coefficients = [[0.0; 4]; 2];
        for (s, w, value) in &samples {
            let p = legendre(*s);
            for (c, row) in coefficients.iter_mut().enumerate() {
                for (degree, sum) in row.iter_mut().enumerate() {
                    *sum += (2 * degree + 1) as f64 * w * p[degree] * value[c];
                }
            }
        }
        // In units of the largest value, so that no square underflows.
        let rest = |known: &[[f64; 4]; 2]| -> f64 {
            let off = samples.iter().map(|(s, w, value)| {
                let p = legendre(*s);
                let of = |c: usize| (0..4).map(|k| known[c][k] * p[k]).sum::<f64>();
                let rest = [0, 1].map(|c| (value[c] - of(c)) / largest);
                w * (rest[0] * rest[0] + rest[1] * rest[1])
            });
            largest * (off.sum::<f64>() * distance(a, b)).sqrt()
        };
        let flat = coefficients.map(|[c0, c1, ..]| [c0, c1, 0.0, 0.0]);
        let is_linear =
            coefficients.iter().all(|[.., c2, c3]| c2.abs().max(c3.abs()) <= LINEAR * largest);
        let ends = |[c0, c1, c2, c3]: [f64; 4]| [c0 - c1 + c2 - c3, c0 + c1 + c2 + c3];
        if is_linear || self.reaction() > 0.0 {
            let [normal, tangential] = flat.map(ends);
            let linear = [[normal[0], tangential[0]], [normal[1], tangential[1]]];
            return Ok((linear, none, rest(&flat)));
        }
        // P_2 = 1 − 6 s(1 − s), P_3 = r (1 − 10 s(1 − s)).
        let [normal, tangential] = coefficients.map(|[_, _, c2, c3]| [-6.0 * c2, -10.0 * c3]);
        let [n, t] = coefficients.map(ends);
        let linear = [[n[0], t[0]], [n[1], t[1]]];
        Ok((linear, Curved { normal, tangential }, rest(&coefficients)))
    }

    /// The slope that the field of a side has to add: tangential for a body, normal for a flux.
    pub(super) fn slope(&self, border: &Border) -> f64 {
        let component = usize::from(self.components == 2);
        match border.part {
            // There, or everywhere, the slopes are unknowns.
            Part::Dirichlet => 0.0,
            _ if self.tractions == Traction::Linear => 0.0,
            // The normal flux on Γ_C is linear as well: its mean is unknown, its slope that of
            // −q_p·n.
            _ => border.linear[1][component] - border.linear[0][component],
        }
    }

    /// The linear part of what is known beforehand of the field of one triangle, apart from the
    /// exact stress: that of its own load, and the slopes of its sides.
    pub(super) fn known_field(&self, t: usize, slopes: &[Linear; 3]) -> Linear {
        let mut field = self.own_of(t).map_or([[[0.0; 3]; 3]; 3], |own| own.field);
        for (slope, of_side) in self.known_slopes(t).into_iter().zip(slopes) {
            if slope != 0.0 {
                add(&mut field, slope, of_side);
            }
        }
        field
    }

    /// The slopes of the sides of a triangle that are known beforehand.
    pub(super) fn known_slopes(&self, t: usize) -> [f64; 3] {
        let own = self.own_of(t).filter(|_| self.tractions == Traction::Reduced);
        [0, 1, 2].map(|k| {
            let slope = self.border_of[self.sides[t][k].edge]
                .map_or(0.0, |border| self.slope(&self.borders[border]));
            own.map_or(slope, |own| {
                let [first, last] = own.ends(k);
                slope - (last[1] - first[1])
            })
        })
    }
}

/// Barycentric coordinates in a piece, whose corners are `piece`, the next one and the centroid.
fn in_piece(at: [f64; 3], piece: usize) -> [f64; 3] {
    let low = at[(piece + 2) % 3];
    [at[piece] - low, at[(piece + 1) % 3] - low, 3.0 * low]
}

/// The part of a triangle in a piece of another one, a convex polygon, in barycentric coordinates
/// of the latter: there the coordinate of the corner opposite to the piece is the smallest.
fn clipped(triangle: [[f64; 3]; 3], piece: usize) -> ([[f64; 3]; 5], usize) {
    let low = (piece + 2) % 3;
    let mut part = [[0.0; 3]; 5];
    part[..3].copy_from_slice(&triangle);
    let mut count = 3;
    for other in [piece, (piece + 1) % 3] {
        let above = |at: &[f64; 3]| at[other] - at[low];
        let (old, before) = (part, count);
        count = 0;
        for i in 0..before {
            let (a, b) = (old[i], old[(i + 1) % before]);
            let (fa, fb) = (above(&a), above(&b));
            if fa >= 0.0 {
                part[count] = a;
                count += 1;
            }
            if (fa < 0.0) != (fb < 0.0) && fa != 0.0 && fb != 0.0 {
                let s = fa / (fa - fb);
                part[count] = [0, 1, 2].map(|m| a[m] + s * (b[m] - a[m]));
                count += 1;
            }
        }
    }
    (part, count)
}

/// The area of a triangle in units of that in whose barycentric coordinates it is given.
fn determinant([a, b, c]: &[[f64; 3]; 3]) -> f64 {
    let (p, q) = ([b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]]);
    p[0] * q[1] - p[1] * q[0]
}

pub(super) fn reaction(form: &Form) -> f64 {
    match form {
        Form::Scalar { reaction } => *reaction,
        Form::Elastic { .. } => 0.0,
    }
}

fn bounding_box(mesh: &Triangulation) -> [Point; 2] {
    let corner = |better: fn(f64, f64) -> f64| {
        mesh.nodes()[1..]
            .iter()
            .fold(mesh.nodes()[0], |[x, y], node| [better(x, node[0]), better(y, node[1])])
    };
    [corner(f64::min), corner(f64::max)]
}
