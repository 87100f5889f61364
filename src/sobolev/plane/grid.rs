//! Products with the Gram matrix of |·|_s for continuous piecewise linears on a uniform grid of squares, each
//! cut from bottom left to top right.
//!
//! Pairs of squares depend on their offset only. With the forms of [`super::cell_pairs`], w_c the four values
//! on the square c,
//! wᵀAw = Σ_c w_cᵀ 2D(c) w_c − 2 Σ_{c,c'} w_cᵀ C(c'−c) w_{c'} + squares that touch, D(c) = Σ S(c'−c) over the
//! squares c' that do not touch c: a rectangle of offsets, known from sums over quadrants. The second sum is
//! ten convolutions. Rows of A sum to zero up to rounding. Units: the side of a square; A scales with
//! h^{2−2s}. Cost: O(N) kernel values once, then O(N log N) per product; memory about 200 N numbers.

use super::cell_pairs::{CORNERS, CellPair, CellPairs, HATS, Square};
use super::convolution::{Spectrum, Torus};
use crate::error::{Error, Result};
use crate::estimate::Tolerance;
use crate::numeric::check::require_values;
use crate::sobolev::order::FractionalOrder;
use rayon::prelude::*;
use rustfft::num_complex::Complex64;

/// Accuracy of entries beyond which they are not asked.
const FINEST: f64 = 1e-14;
/// Rows of squares in a band, which one thread works through.
const BAND: usize = 16;

/// The Gram matrix of |·|_s on a uniform grid, as a fast product.
pub struct GridOperator {
    squares: [usize; 2],
    scale: f64,
    torus: Torus,
    /// transforms of C_ab, a ≤ b
    spectra: Vec<((usize, usize), Spectrum)>,
    /// 2 D(c) for every square
    own: Vec<Square>,
    touching: Vec<Touching>,
}

/// The form of two squares that touch, on a patch of 3 × 3 nodes: the first at `origin`, the second at
/// `offset` from it.
struct Touching {
    origin: [usize; 2],
    offset: [i64; 2],
    form: [[f64; 9]; 9],
}

impl GridOperator {
    /// For the grid of [`super::Triangles::grid`]; entries to the relative tolerance.
    ///
    /// # Errors
    /// [`Error::CountOutOfRange`] for no square, [`Error::OutOfRange`] unless h > 0.
    pub fn new(squares: [usize; 2], h: f64, order: FractionalOrder, tolerance: Tolerance) -> Result<Self> {
        Error::require("h", h, "(0, inf)", h > 0.0 && h.is_finite())?;
        if squares.contains(&0) {
            return Err(Error::CountOutOfRange { name: "squares", value: 0, range: "n >= 1" });
        }
        let pairs = CellPairs::new(order, tolerance.relative().max(FINEST))?;
        let torus = Torus::new(squares);
        let offsets = Offsets::new(squares, &pairs)?;
        let spectra = (0..HATS).flat_map(|a| (a..HATS).map(move |b| (a, b)));
        let spectra = spectra.map(|(a, b)| ((a, b), offsets.spectrum(&torus, a, b))).collect();
        let mut touching = Vec::new();
        for (origin, offset) in
            [([0, 0], [0, 0]), ([0, 0], [1, 0]), ([0, 0], [0, 1]), ([0, 0], [1, 1]), ([1, 0], [-1, 1])]
        {
            touching.push(Touching { origin, offset, form: pairs.touching(origin, offset)? });
        }
        let scale = h.powf(2.0 * order.complement());
        Ok(Self { squares, scale, torus, spectra, own: offsets.own(), touching })
    }

    /// Number of nodes, row by row from the bottom.
    pub fn size(&self) -> usize {
        (self.squares[0] + 1) * (self.squares[1] + 1)
    }

    /// A w.
    ///
    /// # Errors
    /// [`Error::LengthMismatch`], [`Error::NotFinite`].
    pub fn apply(&self, w: &[f64]) -> Result<Vec<f64>> {
        require_values("values at nodes", w, self.size())?;
        let mut image = self.far(w);
        self.near(w, &mut image);
        image.iter_mut().for_each(|value| *value *= self.scale);
        Ok(image)
    }

    fn node(&self, i: usize, j: usize) -> usize {
        j * (self.squares[0] + 1) + i
    }

    /// The convolutions; real fields travel in pairs as real and imaginary part.
    fn far(&self, w: &[f64]) -> Vec<f64> {
        let [columns, rows] = self.squares;
        let width = self.torus.size()[0];
        let field = |first: usize, second: usize| {
            let mut field = self.torus.zeros();
            field.par_chunks_mut(width).take(rows).enumerate().for_each(|(j, row)| {
                let value = |i: usize, a: usize| w[self.node(i + CORNERS[a][0], j + CORNERS[a][1])];
                (0..columns).for_each(|i| row[i] = Complex64::new(value(i, first), value(i, second)));
            });
            self.torus.transform(field, rows)
        };
        let packed = [field(0, 1), field(2, 3)];
        let images = self.multiplied(&packed).map(|image| self.torus.back(image, rows));
        let mut image = vec![0.0; self.size()];
        image.par_chunks_mut(columns + 1).enumerate().for_each(|(y, line)| {
            for (a, corner) in CORNERS.iter().enumerate() {
                let Some(j) = y.checked_sub(corner[1]).filter(|j| *j < rows) else { continue };
                let values = &images[a / 2][j * width..j * width + columns];
                for (place, value) in line[corner[0]..].iter_mut().zip(values) {
                    *place -= 2.0 * if a % 2 == 0 { value.re } else { value.im };
                }
            }
        });
        image
    }

    /// The transforms of the images, 0 packed with 1 and 2 with 3.
    fn multiplied(&self, packed: &[Spectrum; 2]) -> [Spectrum; 2] {
        let [n, m] = self.torus.size();
        let i = Complex64::i();
        let mut images = [self.torus.zeros(), self.torus.zeros()];
        let [first, second] = &mut images;
        let lines = first.par_chunks_mut(m).zip(second.par_chunks_mut(m)).enumerate();
        lines.for_each(|(k, (first, second))| {
            let opposite = (n - k) % n;
            for l in 0..m {
                let (at, other) = (k * m + l, opposite * m + (m - l) % m);
                // Both real fields of a packed one: (z + z̄(−·))/2 and (z − z̄(−·))/2i.
                let parts = packed.each_ref().map(|z| {
                    let (z, conjugate) = (z[at], z[other].conj());
                    [0.5 * (z + conjugate), -0.5 * i * (z - conjugate)]
                });
                let fields = [parts[0][0], parts[0][1], parts[1][0], parts[1][1]];
                let mut images = [Complex64::default(); HATS];
                for ((a, b), spectrum) in &self.spectra {
                    // The image of field b on hat a is a correlation: conj; C_ba(Δ) = C_ab(−Δ).
                    images[*a] += spectrum[at].conj() * fields[*b];
                    if a != b {
                        images[*b] += spectrum[at] * fields[*a];
                    }
                }
                (first[l], second[l]) = (images[0] + i * images[1], images[2] + i * images[3]);
            }
        });
        images
    }

    /// The squares themselves and those that touch, band by band of rows of squares.
    fn near(&self, w: &[f64], image: &mut [f64]) {
        let [columns, rows] = self.squares;
        let bands: Vec<usize> = (0..rows).step_by(BAND).collect();
        let found: Vec<Vec<f64>> = bands
            .par_iter()
            .map(|&from| {
                let to = (from + BAND).min(rows);
                let mut part = vec![0.0; (to.min(rows - 1) + 2 - from) * (columns + 1)];
                (from..to).for_each(|j| self.near_row(w, j, from, &mut part));
                part
            })
            .collect();
        for (from, part) in bands.into_iter().zip(found) {
            let places = image[from * (columns + 1)..].iter_mut();
            places.zip(part).for_each(|(place, value)| *place += value);
        }
    }

    /// The squares of row j with those that touch, onto rows of nodes that begin with `from`.
    fn near_row(&self, w: &[f64], j: usize, from: usize, image: &mut [f64]) {
        let [columns, rows] = self.squares;
        let first = from * (columns + 1);
        for i in 0..columns {
            let nodes = CORNERS.map(|[x, y]| self.node(i + x, j + y));
            let own = &self.own[j * columns + i];
            for (a, row) in nodes.iter().zip(own) {
                image[*a - first] += row.iter().zip(nodes).map(|(entry, node)| entry * w[node]).sum::<f64>();
            }
            for Touching { origin, offset, form } in &self.touching {
                let other = [i as i64 + offset[0], j as i64 + offset[1]];
                if other[0] < 0 || other[0] >= columns as i64 || other[1] >= rows as i64 {
                    continue;
                }
                let twice = if *offset == [0, 0] { 1.0 } else { 2.0 };
                let squares = [[i, j], other.map(|x| x as usize)];
                // Places on the patch and nodes, each once.
                let mut patch = [(0, 0); 8];
                let mut count = 0;
                for [x, y] in CORNERS.iter().flat_map(|c| squares.map(|s| [s[0] + c[0], s[1] + c[1]])) {
                    let entry = (3 * (y + origin[1] - j) + x + origin[0] - i, self.node(x, y));
                    if !patch[..count].contains(&entry) {
                        patch[count] = entry;
                        count += 1;
                    }
                }
                let values = patch.map(|(_, node)| twice * w[node]);
                for &(row, node) in &patch[..count] {
                    let entries = patch[..count].iter().zip(values).map(|((at, _), w)| form[row][*at] * w);
                    image[node - first] += entries.sum::<f64>();
                }
            }
        }
    }
}

/// The forms of all offsets of squares that do not touch.
struct Offsets {
    squares: [usize; 2],
    pairs: Vec<CellPair>,
}

impl Offsets {
    fn new(squares: [usize; 2], pairs: &CellPairs) -> Result<Self> {
        let [columns, rows] = squares.map(|n| n as i64);
        let row = |j: i64| -> Result<Vec<CellPair>> {
            let one = |i: i64| {
                let touches = i.abs() <= 1 && j.abs() <= 1;
                if touches { Ok(CellPair::default()) } else { pairs.apart([i, j]) }
            };
            (1 - columns..columns).map(one).collect()
        };
        let found = (1 - rows..rows).into_par_iter().map(row).collect::<Result<Vec<_>>>()?;
        Ok(Self { squares, pairs: found.concat() })
    }

    /// Offsets and forms.
    fn all(&self) -> impl Iterator<Item = ([i64; 2], &CellPair)> {
        let [columns, rows] = self.squares.map(|n| n as i64);
        let width = 2 * columns - 1;
        self.pairs
            .iter()
            .enumerate()
            .map(move |(k, pair)| ([k as i64 % width + 1 - columns, k as i64 / width + 1 - rows], pair))
    }

    fn spectrum(&self, torus: &Torus, a: usize, b: usize) -> Spectrum {
        let mut field = torus.zeros();
        self.all().for_each(|(offset, pair)| field[torus.at(offset)].re = pair.cross[a][b]);
        torus.transform(field, usize::MAX)
    }

    /// 2 D(c): sums of 2 S over the rectangle of offsets that stay in the grid.
    fn own(&self) -> Vec<Square> {
        let [columns, rows] = self.squares;
        let (width, height) = (2 * columns, 2 * rows);
        let mut own = vec![[[0.0; HATS]; HATS]; columns * rows];
        for a in 0..HATS {
            for b in 0..HATS {
                // before[j][i]: the sum over the first j rows and i columns of offsets
                let mut before = vec![0.0; width * height];
                for j in 1..height {
                    let mut line = 0.0;
                    for i in 1..width {
                        line += self.pairs[(j - 1) * (width - 1) + i - 1].same[a][b];
                        before[j * width + i] = before[(j - 1) * width + i] + line;
                    }
                }
                let at = |i: usize, j: usize| before[j * width + i];
                for j in 0..rows {
                    for i in 0..columns {
                        // Offsets −i ... columns − 1 − i stand at columns − 1 − i ... 2 columns − 2 − i.
                        let (left, low) = (columns - 1 - i, rows - 1 - j);
                        let (right, top) = (left + columns, low + rows);
                        let sum = at(right, top) - at(left, top) - at(right, low) + at(left, low);
                        own[j * columns + i][a][b] = 2.0 * sum;
                    }
                }
            }
        }
        own
    }
}
