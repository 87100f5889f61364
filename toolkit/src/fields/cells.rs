//! All cells of u − u_h with their near pairs.
//!
//! Pairs within a patch are omitted: their sum is the seminorm of [`super::patch`]. A singular cell is paired
//! with others at a distance no shorter than itself, by [`super::samples`]; all other pairs are pairs of
//! polynomials.

use super::fit::{Difference, Fitted};
use super::layout::{Part, layout};
use super::samples::Sampled;
use crate::energy::{CellEnergies, PairSum, Samples};
use crate::error::Result;
use crate::estimate::Tolerance;
use crate::kernel::power::{GaussRules, PowerKernel};
use crate::mesh::Mesh;
use crate::numeric::parallel;
use crate::order::Order;
use crate::piecewise::{Cell, DegreeRules, Piece};

/// Number of parts fitted by one thread.
const TOGETHER: usize = 256;

/// The representation of u − u_h on a cell.
pub(super) enum Content {
    Smooth { piece: Piece, rest: f64, noise: f64 },
    Singular(Sampled),
}

/// The cells, from left to right.
pub(super) struct FieldCells {
    pub(super) parts: Vec<Part>,
    pub(super) contents: Vec<Content>,
    pub(super) partition: Mesh,
    /// jumps of u − u_h at the nodes between the cells
    pub(super) jumps: Vec<f64>,
}

impl FieldCells {
    pub(super) fn new(difference: &Difference, tolerance: f64) -> Result<Self> {
        let (function, field) = (difference.function, difference.field);
        let look = function.looked(Tolerance::new(tolerance.clamp(1e-14, 1e-3))?)?;
        let planned = layout(field.mesh(), function.breaks(), &look)?;
        let found: Vec<Vec<(Part, Content)>> =
            parallel::map_together(planned.len(), TOGETHER, &|k| {
                let part = &planned[k];
                if part.is_singular {
                    return Ok(vec![(
                        *part,
                        Content::Singular(singular(difference, part, tolerance)?),
                    )]);
                }
                let smooth = |Fitted { part, piece, rest, noise }| {
                    (part, Content::Smooth { piece, rest, noise })
                };
                Ok(difference.fit(*part, 0.02 * tolerance)?.into_iter().map(smooth).collect())
            })
            .into_iter()
            .collect::<Result<_>>()?;
        let (parts, contents): (Vec<Part>, Vec<Content>) = found.into_iter().flatten().unzip();
        let partition =
            Mesh::from_lengths(&parts.iter().map(|part| part.length).collect::<Vec<_>>())?;
        let jump = |part: &Part| {
            let at_node = part.from == 0.0 && part.element > 0;
            if at_node { -field.jump(part.element) } else { 0.0 }
        };
        let jumps = parts.iter().map(jump).collect();
        Ok(Self { parts, contents, partition, jumps })
    }

    /// True if u − u_h jumps at a node outside all patches.
    pub(super) fn jumps_apart(&self) -> bool {
        (1..self.parts.len()).any(|k| self.jumps[k] != 0.0 && !self.is_inside_patch(k))
    }

    fn is_inside_patch(&self, node: usize) -> bool {
        let [before, after] = [self.parts[node - 1].patch, self.parts[node].patch];
        before.is_some() && before == after
    }

    /// The degrees of the polynomials.
    fn degrees(&self) -> impl Iterator<Item = usize> {
        self.contents.iter().map(|content| match content {
            Content::Smooth { piece, .. } => piece.degree(),
            Content::Singular(_) => 0,
        })
    }

    fn degree(&self) -> usize {
        self.degrees().max().unwrap_or(0)
    }
}

fn singular(difference: &Difference, part: &Part, tolerance: f64) -> Result<Sampled> {
    let mirrored = part.right == 0.0;
    let k = part.gap + usize::from(mirrored);
    let closest = (64.0 * f64::EPSILON * difference.function.blur(k))
        .max(difference.function.closest())
        / part.length;
    Sampled::new(closest, mirrored, tolerance, |delta| difference.near_break(part, mirrored, delta))
}

/// The cells with the rules for their degrees.
pub(super) struct FieldEnergies<'a> {
    cells: &'a FieldCells,
    pub(super) rules: DegreeRules,
    gauss: GaussRules,
    kernel: PowerKernel,
}

impl<'a> FieldEnergies<'a> {
    pub(super) fn new(cells: &'a FieldCells, order: Order, target: f64) -> Result<Self> {
        Ok(Self {
            cells,
            rules: DegreeRules::new(order, cells.degrees(), target)?,
            gauss: GaussRules::to(cells.degree().max(1), 0.1 * target),
            kernel: PowerKernel::new(order),
        })
    }

    fn length(&self, e: usize) -> f64 {
        self.cells.partition.lengths()[e]
    }

    /// The sum over pairs of a singular cell and another one to the right or to the left of it.
    fn sampled(&self, e: usize, sampled: &Sampled, f: usize, gap: f64) -> PairSum {
        let (h, other, is_right) = (self.length(e), self.length(f), f > e);
        let mut sum = PairSum::default();
        for (&(t, w), &value) in sampled.points.iter().zip(&sampled.values) {
            let from_end = gap + h * if is_right { 1.0 - t } else { t };
            let mut add = |distance: f64, weight: f64, there: f64| {
                // w h · weight · t^{-1-2ν}, in an order that does not overflow
                let kernel = self.kernel.scaling(distance) * (h / distance) * (weight / distance);
                sum.value += 2.0 * w * kernel * (value - there).powi(2);
                sum.points += 1;
            };
            match &self.cells.contents[f] {
                Content::Smooth { piece, .. } => self.gauss.graded(from_end, other, |s, weight| {
                    let local = if is_right { s / other } else { 1.0 - s / other };
                    add(from_end + s, weight, piece.value(local));
                }),
                Content::Singular(there) => {
                    for (&(s, weight), &value) in there.points.iter().zip(&there.values) {
                        let s = other * if is_right { s } else { 1.0 - s };
                        add(from_end + s, weight * other, value);
                    }
                }
            }
        }
        sum
    }
}

impl Samples for FieldEnergies<'_> {
    fn level(&self, cell: usize) -> f64 {
        match &self.cells.contents[cell] {
            Content::Smooth { piece, .. } => piece.left,
            Content::Singular(sampled) => sampled.values[0],
        }
    }

    fn sample(&self, cell: usize, shift: f64, visit: &mut dyn FnMut(f64, f64, f64)) {
        match &self.cells.contents[cell] {
            Content::Smooth { piece, .. } => self.rules.sample(piece, shift, visit),
            Content::Singular(sampled) => {
                for (&(t, w), value) in sampled.points.iter().zip(&sampled.values) {
                    visit(t, w, value - shift);
                }
            }
        }
    }
}

impl CellEnergies for FieldEnergies<'_> {
    fn near(&self, e: usize, f: usize, gap: f64) -> PairSum {
        let patch = self.cells.parts[e].patch;
        if patch.is_some() && patch == self.cells.parts[f].patch {
            return PairSum::default();
        }
        match (&self.cells.contents[e], &self.cells.contents[f]) {
            (Content::Singular(sampled), _) => self.sampled(e, sampled, f, gap),
            (_, Content::Singular(sampled)) => self.sampled(f, sampled, e, gap),
            (Content::Smooth { piece: left, .. }, Content::Smooth { piece: right, .. }) => {
                let cells = [(e, left), (f, right)]
                    .map(|(k, piece)| Cell { length: self.length(k), piece });
                self.rules.near(cells, f - e, gap, || self.cells.jumps[f])
            }
        }
    }

    fn leaf(&self) -> usize {
        1
    }

    fn may_cut(&self, node: usize) -> bool {
        !self.cells.is_inside_patch(node)
    }
}
