//! Products with the Gram matrix of |·|_s for continuous piecewise linear functions on a uniform grid of
//! squares, each cut from bottom left to top right.

use super::cell_pairs::{CORNERS, CellPair, CellPairs, HATS, Square};
use super::convolution::{Spectrum, Torus};
use crate::error::{Error, Result};
use crate::estimate::Tolerance;
use crate::numeric::check::require_values;
use crate::numeric::memory::require_memory;
use crate::numeric::parallel;
use crate::order::Order;
use rayon::prelude::*;
use rustfft::num_complex::Complex64;

/// Smallest relative tolerance of the entries that is used.
const FINEST: f64 = 1e-14;

/// The Gram matrix of |·|_s on a uniform grid, as a fast product.
///
/// # Method
///
/// Pairs of squares depend only on their offset. With the forms of `cell_pairs` and the four values w_c on the square
/// c, wᵀAw = Σ_c w_cᵀ 2D(c) w_c − 2 Σ_{c,c'} w_cᵀ C(c'−c) w_{c'} + squares that touch, D(c) = Σ S(c'−c) over the
/// squares c' that do not touch c: a rectangle of offsets, computed from sums over quadrants. The second sum consists
/// of ten convolutions. The rows of A sum to zero up to rounding. Units: the side of a square; A scales with
/// h^{2−2s}. Cost: O(N) kernel values once, then O(N log N) operations per product; memory about 200 N numbers.
pub(crate) struct GridOperator {
    squares: [usize; 2],
    scale: f64,
    torus: Torus,
    /// transforms of C_ab, a ≤ b
    spectra: Vec<((usize, usize), Spectrum)>,
    /// 2 D(c) for every square
    own: Vec<Square>,
    touching: Vec<Touching>,
}

/// The form of two squares that touch, counted twice unless they coincide, on the nodes of both; the second
/// square lies at `offset` from the first.
struct Touching {
    offset: [i64; 2],
    /// offsets from the bottom left node of the first square
    nodes: Vec<[i64; 2]>,
    form: Vec<f64>,
}

/// Bytes per square: about 200 numbers.
const BYTES_OF_SQUARE: usize = 1600;

/// Number of rows of squares that are treated in one pass over the forms of touching squares.
const BAND: usize = 32;

impl GridOperator {
    /// The operator on the grid of [`super::Triangles::grid`], with entries to the relative tolerance.
    ///
    /// # Errors
    /// [`Error::CountOutOfRange`] for a grid without squares, [`Error::TooLarge`] if the memory does not
    /// suffice, [`Error::OutOfRange`] unless h > 0.
    pub(crate) fn new(squares: [usize; 2], h: f64, order: Order, tolerance: Tolerance) -> Result<Self> {
        Error::require("h", h, "(0, inf)", h > 0.0 && h.is_finite())?;
        if squares.contains(&0) {
            return Err(Error::CountOutOfRange { name: "squares", value: 0, range: "[1, inf)" });
        }
        require_memory("squares", squares[0].saturating_mul(squares[1]), BYTES_OF_SQUARE)?;
        let pairs = CellPairs::new(order, tolerance.relative().max(FINEST))?;
        let torus = Torus::new(squares);
        let offsets = Offsets::new(squares, &pairs)?;
        let spectra = (0..HATS).flat_map(|a| (a..HATS).map(move |b| (a, b)));
        let spectra = spectra.map(|(a, b)| ((a, b), offsets.spectrum(&torus, a, b))).collect();
        let mut touching = Vec::new();
        for (origin, offset) in
            [([0, 0], [0, 0]), ([0, 0], [1, 0]), ([0, 0], [0, 1]), ([0, 0], [1, 1]), ([1, 0], [-1, 1])]
        {
            touching.push(Touching::new(origin, offset, &pairs.touching(origin, offset)?));
        }
        let scale = h.powf(2.0 * order.complement());
        Ok(Self { squares, scale, torus, spectra, own: offsets.own(), touching })
    }

    /// The number of nodes, which are numbered row by row from the bottom.
    pub(crate) fn size(&self) -> usize {
        (self.squares[0] + 1) * (self.squares[1] + 1)
    }

    /// The product A w.
    ///
    /// # Errors
    /// [`Error::LengthMismatch`], [`Error::NotFinite`].
    pub(crate) fn apply(&self, w: &[f64]) -> Result<Vec<f64>> {
        require_values("nodal values", w, self.size())?;
        let mut image = self.far(w);
        self.near(w, &mut image);
        Ok(image.into_iter().map(|value| self.scale * value).collect())
    }

    fn node(&self, i: usize, j: usize) -> usize {
        j * (self.squares[0] + 1) + i
    }

    /// The convolutions; pairs of real fields are combined as real and imaginary part.
    fn far(&self, w: &[f64]) -> Vec<f64> {
        let [columns, rows] = self.squares;
        let width = self.torus.size()[0];
        let field = |first: usize, second: usize| {
            let mut field = self.torus.zeros();
            parallel::pieces(&mut field[..rows * width], width, &|j, line| {
                for (i, value) in line[..columns].iter_mut().enumerate() {
                    let of = |a: usize| w[self.node(i + CORNERS[a][0], j + CORNERS[a][1])];
                    *value = Complex64::new(of(first), of(second));
                }
            });
            self.torus.transform(field, rows)
        };
        let packed = [field(0, 1), field(2, 3)];
        let images = self.multiplied(&packed).map(|spectrum| self.torus.back(spectrum, rows));
        let mut image = vec![0.0; self.size()];
        // Row j of nodes is the bottom of row j of squares and the top of row j − 1.
        parallel::pieces(&mut image, columns + 1, &|j, line| {
            for (a, &[x, y]) in CORNERS.iter().enumerate().filter(|(_, [_, y])| (*y..rows + *y).contains(&j))
            {
                let row = &images[a / 2][(j - y) * width..][..columns];
                let parts = row.iter().map(|value| if a % 2 == 0 { value.re } else { value.im });
                line[x..].iter_mut().zip(parts).for_each(|(entry, part)| *entry -= 2.0 * part);
            }
        });
        image
    }

    /// The transforms of the images of the hat functions 0 and 1, and 2 and 3, packed.
    fn multiplied(&self, packed: &[Spectrum; 2]) -> [Spectrum; 2] {
        let [n, m] = self.torus.size();
        let i = Complex64::i();
        let mut products = [0, 1].map(|_| self.torus.zeros());
        let [first, second] = &mut products;
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
        products
    }

    fn near(&self, w: &[f64], image: &mut [f64]) {
        let [columns, rows] = self.squares;
        let width = columns + 1;
        // A band of squares reaches two rows of nodes beyond its last row of squares.
        let band = |first: usize| -> (usize, Vec<f64>) {
            let end = (first + BAND).min(rows);
            let mut part = vec![0.0; width * ((end + 2).min(rows + 1) - first)];
            for j in first..end {
                for i in 0..columns {
                    let nodes = CORNERS.map(|[x, y]| self.node(i + x, j + y));
                    for (a, row) in nodes.iter().zip(&self.own[j * columns + i]) {
                        let value = row.iter().zip(nodes).map(|(entry, node)| entry * w[node]).sum::<f64>();
                        part[a - first * width] += value;
                    }
                    let fits = |other: &&Touching| {
                        let [x, y] = [i as i64 + other.offset[0], j as i64 + other.offset[1]];
                        (0..columns as i64).contains(&x) && y < rows as i64
                    };
                    self.touching
                        .iter()
                        .filter(fits)
                        .for_each(|other| other.add([i, j], width, first, w, &mut part));
                }
            }
            (first * width, part)
        };
        for (start, part) in parallel::map(rows.div_ceil(BAND), &|k| band(k * BAND)) {
            image[start..].iter_mut().zip(part).for_each(|(entry, value)| *entry += value);
        }
    }
}

impl Touching {
    /// The form obtained from that on a patch of 3 × 3 nodes, with the first square at `origin`.
    fn new(origin: [usize; 2], offset: [i64; 2], patch: &[[f64; 9]; 9]) -> Self {
        let twice = if offset == [0, 0] { 1.0 } else { 2.0 };
        let of = |at: [i64; 2]| CORNERS.map(|corner| [0, 1].map(|k| corner[k] as i64 + at[k]));
        let mut nodes: Vec<[i64; 2]> = [of([0, 0]), of(offset)].concat();
        nodes.sort_unstable();
        nodes.dedup();
        let place =
            |node: &[i64; 2]| (3 * (node[1] + origin[1] as i64) + node[0] + origin[0] as i64) as usize;
        let places: Vec<usize> = nodes.iter().map(place).collect();
        let row = |&a: &usize| places.iter().map(move |&b| (a, b));
        let form = places.iter().flat_map(row).map(|(a, b)| twice * patch[a][b]).collect();
        Self { offset, nodes, form }
    }

    /// Adds the product with the form for the first square at `at` to the rows of nodes from `first` on.
    fn add(&self, at: [usize; 2], width: usize, first: usize, w: &[f64], part: &mut [f64]) {
        let node = |[x, y]: [i64; 2]| ((at[1] as i64 + y) * width as i64 + at[0] as i64 + x) as usize;
        let mut values = [0.0; 9];
        values.iter_mut().zip(&self.nodes).for_each(|(value, &place)| *value = w[node(place)]);
        for (row, &place) in self.form.chunks_exact(self.nodes.len()).zip(&self.nodes) {
            let value: f64 = row.iter().zip(&values).map(|(entry, value)| entry * value).sum();
            part[node(place) - first * width] += value;
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
        let found = parallel::map((2 * rows - 1) as usize, &|k| row(k as i64 + 1 - rows));
        Ok(Self { squares, pairs: found.into_iter().collect::<Result<Vec<_>>>()?.concat() })
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

    /// The values 2 D(c): sums of 2 S over the rectangle of offsets that remain in the grid.
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
