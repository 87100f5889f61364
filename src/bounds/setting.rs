//! What is the same for all steps on one mesh: edges with their triangles, the load split into what an exact stress
//! carries and what is left to the triangles, and the tractions that remain on the boundary.

use super::boundary_values::Lift;
use super::element::{Linear, Side, Value, add, combine, pieces, side, traction};
use super::lift::lifted;
use super::polynomial::Particular;
use super::rule::TriangleRule;
use crate::contact::Body;
use crate::error::{Error, Result};
use crate::fem::{Form, Lame};
use crate::mesh::{Edges, Part, Point, Triangulation, distance, doubled_area, middle};
use fractional_sobolev::{Rule, gauss_legendre};

/// Gauss points on an edge of the boundary.
const EDGE_POINTS: usize = 8;
/// Largest number of points in each direction.
const MOST_POINTS: usize = 10;
/// Relative error of the rule at which its number of points is chosen.
const QUADRATURE: f64 = 1e-10;
/// A load whose values on a triangle agree to this multiple of the largest one is constant there.
const CONSTANT: f64 = 1e-14;

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
    /// The linear part of the traction that the unknown stress has to have (Neumann), or of minus the traction of the
    /// exact stress (contact, and for the tangential component): normal and tangential component at both ends.
    pub(super) linear: [[f64; 2]; 2],
    /// ‖what is left over‖ in L²: orthogonal to linear tractions.
    pub(super) left_over: f64,
}

/// The data of a body on one mesh.
pub(super) struct Setting<'s, 'b> {
    pub(super) body: &'s Body<'b>,
    pub(super) mesh: &'s Triangulation,
    pub(super) components: usize,
    pub(super) sides: Vec<[SideOf; 3]>,
    /// The triangles with their sides at every edge; the second is absent on the boundary.
    pub(super) around: Vec<[Option<(usize, usize)>; 2]>,
    pub(super) borders: Vec<Border>,
    /// For every edge the number of its border.
    pub(super) border_of: Vec<Option<usize>>,
    /// Rules of n × n points on the pieces of a triangle, n = 2, 3, .. ; small triangles need fewer points.
    rules: Vec<TriangleRule>,
    /// The fewest points in each direction.
    fewest: usize,
    pub(super) edge_rule: Rule,
    pub(super) particular: Option<Particular>,
    /// Whether some load is left to the triangles.
    pub(super) local: bool,
    /// Prescribed displacements that are not linear on an edge, by triangle.
    pub(super) lifts: Vec<Vec<Lift>>,
}

/// A point of the rule: its piece, barycentric coordinates there, weight, and the exact stress.
pub(super) struct Sample {
    pub(super) piece: usize,
    pub(super) shares: [f64; 3],
    pub(super) point: Point,
    pub(super) weight: f64,
    pub(super) exact: Value,
}

impl Sample {
    /// q at the point: the field of the triangle and the exact stress.
    pub(super) fn stress(&self, field: &Linear) -> Value {
        let mut value = combine(&self.shares, &field[self.piece]);
        (0..3).for_each(|c| value[c] += self.exact[c]);
        value
    }
}

/// The load that a triangle carries by itself.
pub(super) struct LocalLoad {
    /// A stress with this load and tractions of the reduced kind.
    pub(super) field: Linear,
    /// ‖f − f_T‖ in L²(T).
    pub(super) left_over: f64,
}

impl<'s, 'b> Setting<'s, 'b> {
    pub(super) fn new(body: &'s Body<'b>, mesh: &'s Triangulation) -> Result<Self> {
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
            sides,
            around,
            borders: Vec::new(),
            border_of: vec![None; count],
            rules: (2..=MOST_POINTS).map(TriangleRule::new).collect::<Result<_>>()?,
            fewest: if reaction { 5 } else { 2 },
            edge_rule: gauss_legendre(EDGE_POINTS)?,
            local: !reaction && (regional || common && particular.is_none()),
            particular,
            lifts: vec![Vec::new(); mesh.triangles().len()],
        };
        for (number, border) in mesh.boundary().iter().enumerate() {
            let edge = edges.find(border.nodes[0], border.nodes[1])?;
            let no_triangle = || Error::count("triangles at a boundary edge", 0, "{1}");
            let (triangle, side) = setting.around[edge][0].ok_or_else(no_triangle)?;
            setting.border_of[edge] = Some(setting.borders.len());
            let (linear, left_over) = setting.border_data(triangle, side, border.part, number)?;
            let border =
                Border { edge, part: border.part, number, triangle, side, linear, left_over };
            if border.part == Part::Dirichlet {
                let corners = mesh.corners(triangle);
                let (a, b) = (corners[side], corners[(side + 1) % 3]);
                let at = |s: f64| {
                    let point = [a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1])];
                    body.displacement_at(mesh.group(number), point)
                };
                setting.lifts[triangle].extend(Lift::through(side, at)?);
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

    /// Unknowns per edge: mean normal displacements weighted to either end and the tangential mean, or one mean.
    pub(super) fn per_edge(&self) -> usize {
        if self.components == 1 { 1 } else { 3 }
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

    /// The linear map after which s : 𝒜⁻¹ t is the dot product: deviator, shear and trace, each times the root of its
    /// compliance; a flux is kept.
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
    pub(super) fn exact_at(&self, points: &[Point]) -> Vec<Value> {
        let mut values = vec![[0.0; 3]; points.len()];
        if let Some(particular) = &self.particular {
            particular.at(points, &mut values);
        }
        values
    }

    /// The rule for a triangle.
    fn rule_for(&self, corners: [Point; 3]) -> &TriangleRule {
        let diameter =
            (0..3).fold(0.0, |m: f64, k| m.max(distance(corners[k], corners[(k + 1) % 3])));
        let points =
            self.particular.as_ref().map_or(2, |particular| points_for(particular, diameter));
        &self.rules[points.max(self.fewest) - 2]
    }

    /// The points of the rule on the pieces of a triangle.
    pub(super) fn samples(&self, t: usize) -> Vec<Sample> {
        let corners = self.mesh.corners(t);
        let share = doubled_area(corners) / 6.0;
        let all = pieces(corners);
        let rule = self.rule_for(corners);
        let points: Vec<Point> = all
            .iter()
            .flat_map(|piece| rule.points.iter().map(|(shares, _)| combine(shares, piece)))
            .collect();
        let exact = self.exact_at(&points);
        let count = rule.points.len();
        (0..points.len())
            .map(|i| {
                let (shares, weight) = rule.points[i % count];
                Sample {
                    piece: i / count,
                    shares,
                    point: points[i],
                    weight: weight * share,
                    exact: exact[i],
                }
            })
            .collect()
    }

    /// The load that is left to one triangle, if any.
    pub(super) fn local_load(&self, t: usize) -> Result<Option<LocalLoad>> {
        if !self.local {
            return Ok(None);
        }
        let (corners, region) = (self.mesh.corners(t), self.mesh.region(t));
        let centre = middle(corners);
        let fine = TriangleRule::new(5)?;
        let area = 0.5 * doubled_area(corners);
        // Means over the pieces and the moment, by the rule on every piece.
        let mut values = Vec::new();
        for piece in pieces(corners) {
            for (shares, weight) in &fine.points {
                let point = combine(shares, &piece);
                let mut value = self.body.load_at(region, point)?;
                if self.particular.is_some() {
                    let common = self.body.common_load_at(point);
                    value = [value[0] - common[0], value[1] - common[1]];
                }
                // Weights in units of the area, places in units of the size, so that no square underflows.
                values.push((point, weight / 3.0, value));
            }
        }
        let per_piece = fine.points.len();
        let mean = |part: &[(Point, f64, Point)]| {
            let weight: f64 = part.iter().map(|(_, w, _)| w).sum();
            [0, 1].map(|c| part.iter().map(|(_, w, f)| w * f[c]).sum::<f64>() / weight)
        };
        let overall = mean(&values);
        let largest = values.iter().flat_map(|(_, _, f)| f).fold(0.0, |m: f64, v| m.max(v.abs()));
        if largest == 0.0 {
            return Ok(None);
        }
        let square = |a: f64, b: f64| (a / largest).powi(2) + (b / largest).powi(2);
        let norm = |mean: f64| largest * area.sqrt() * mean.sqrt();
        let spread =
            values.iter().map(|(_, _, f)| (f[0] - overall[0]).abs().max((f[1] - overall[1]).abs()));
        let constant = spread.fold(0.0, f64::max) <= CONSTANT * largest;
        if constant || self.components == 1 {
            let field = pieces(corners).map(|piece| {
                piece.map(|p| {
                    let z = [p[0] - centre[0], p[1] - centre[1]];
                    match self.components {
                        // div(−f̄ z/2) = −f̄, with constant normal component on every side.
                        1 => [-0.5 * overall[0] * z[0], -0.5 * overall[0] * z[1], 0.0],
                        // div(−(f̄·z) I) = −f̄, with linear normal and no tangential traction.
                        _ => {
                            let pressure = -(overall[0] * z[0] + overall[1] * z[1]);
                            [pressure, pressure, 0.0]
                        }
                    }
                })
            });
            let off =
                |(_, w, f): &(Point, f64, Point)| w * square(f[0] - overall[0], f[1] - overall[1]);
            let left_over = if constant { 0.0 } else { norm(values.iter().map(off).sum()) };
            return Ok(Some(LocalLoad { field, left_over }));
        }
        // Constant on the three pieces, with the resultant and the moment of the load.
        let mut loads = [0, 1, 2].map(|k| mean(&values[k * per_piece..(k + 1) * per_piece]));
        let size = (0..3).map(|k| side(corners, k).length).fold(0.0, f64::max);
        let arms = pieces(corners).map(|piece| {
            let at = middle(piece);
            [(at[0] - centre[0]) / size, (at[1] - centre[1]) / size]
        });
        let moment = |z: Point, f: Point| z[0] * f[1] - z[1] * f[0];
        let wanted: f64 = values
            .iter()
            .map(|(p, w, f)| w * moment([0, 1].map(|c| (p[c] - centre[c]) / size), *f))
            .sum();
        let present: f64 = (0..3).map(|k| moment(arms[k], loads[k]) / 3.0).sum();
        let inertia: f64 = arms.iter().map(|z| (z[0] * z[0] + z[1] * z[1]) / 3.0).sum();
        let turn = (wanted - present) / inertia;
        for (load, arm) in loads.iter_mut().zip(arms) {
            *load = [load[0] - turn * arm[1], load[1] + turn * arm[0]];
        }
        let off = |(i, (_, w, f)): (usize, &(Point, f64, Point))| {
            let own = loads[i / per_piece];
            w * square(f[0] - own[0], f[1] - own[1])
        };
        let left_over = norm(values.iter().enumerate().map(off).sum());
        Ok(Some(LocalLoad { field: lifted(corners, &loads)?, left_over }))
    }

    /// For an edge of the boundary: the linear part of F − q_p n, or of −q_p n on Γ_C, and the norm of the rest.
    fn border_data(
        &self,
        triangle: usize,
        k: usize,
        part: Part,
        number: usize,
    ) -> Result<([[f64; 2]; 2], f64)> {
        if part == Part::Dirichlet {
            return Ok(([[0.0; 2]; 2], 0.0));
        }
        let corners = self.mesh.corners(triangle);
        let (a, b) = (corners[k], corners[(k + 1) % 3]);
        let side = side(corners, k);
        let mut samples = Vec::with_capacity(EDGE_POINTS);
        for (s, weight) in self.edge_rule.iter() {
            let point = [a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1])];
            let mut value =
                traction(self.components, self.exact_at(&[point])[0], &side).map(|v| -v);
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
        let moment = |c: usize, hat: fn(f64) -> f64| -> f64 {
            samples.iter().map(|(s, w, value)| w * hat(*s) * value[c]).sum()
        };
        // The projection on linear functions from the moments against 1 − s and s.
        let ends = [0, 1].map(|c| {
            let (first, last) = (moment(c, |s| 1.0 - s), moment(c, |s| s));
            [4.0 * first - 2.0 * last, 4.0 * last - 2.0 * first]
        });
        let linear = [[ends[0][0], ends[1][0]], [ends[0][1], ends[1][1]]];
        // In units of the largest value, so that no square underflows.
        let largest =
            samples.iter().flat_map(|(_, _, value)| value).fold(0.0, |m: f64, v| m.max(v.abs()));
        if largest == 0.0 {
            return Ok((linear, 0.0));
        }
        let off: f64 = samples
            .iter()
            .map(|(s, w, value)| {
                let rest = [0, 1]
                    .map(|c| (value[c] - (1.0 - s) * linear[0][c] - s * linear[1][c]) / largest);
                w * (rest[0] * rest[0] + rest[1] * rest[1])
            })
            .sum();
        Ok((linear, largest * (off * distance(a, b)).sqrt()))
    }

    /// The slope that the field of a side has to add: tangential for a body, normal for a flux.
    pub(super) fn slope(&self, border: &Border) -> f64 {
        let component = usize::from(self.components == 2);
        match (border.part, self.components) {
            (Part::Dirichlet, _) => 0.0,
            // The normal flux on Γ_C is linear as well: its mean is unknown, its slope that of −q_p·n.
            _ => border.linear[1][component] - border.linear[0][component],
        }
    }

    /// The field of one triangle that is known beforehand, apart from the exact stress: its local load and the slopes of
    /// its sides on the boundary. The second value is ‖f − f_T‖.
    pub(super) fn known_field(&self, t: usize, slopes: &[Linear; 3]) -> Result<(Linear, f64)> {
        let (mut field, left_over) = match self.local_load(t)? {
            Some(local) => (local.field, local.left_over),
            None => ([[[0.0; 3]; 3]; 3], 0.0),
        };
        for k in 0..3 {
            if let Some(border) = self.border_of[self.sides[t][k].edge] {
                let slope = self.slope(&self.borders[border]);
                if slope != 0.0 {
                    add(&mut field, slope, &slopes[k]);
                }
            }
        }
        Ok((field, left_over))
    }
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

/// Points in each direction for which the error of the rule is negligible: the remainder of degree d of a function that
/// oscillates `waves` times on the triangle is (waves/2)^d/d! 2^(1−d), and n points are exact for degree 2n − 1.
fn points_for(particular: &Particular, diameter: f64) -> usize {
    let waves = particular.waves(diameter);
    let (mut remainder, mut degree) = (2.0, 0);
    while remainder > QUADRATURE && degree < particular.degree() + 1 {
        degree += 1;
        remainder *= 0.25 * waves / degree as f64;
    }
    // A polynomial of low degree is integrated exactly, and its square.
    let exact = particular.degree() + 1;
    let needed = (degree + 2).div_ceil(2);
    (if exact <= 4 { exact } else { needed }).clamp(2, MOST_POINTS)
}
