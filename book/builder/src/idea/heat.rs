//! Pictures over the square: integrands of seminorms, pairs of points, a wave that enters the body. One scale
//! of colour each for all their frames.

use super::pen::{BLUE, INK, ORANGE, Pen, SQUARE};
use std::f64::consts::PI;

/// Cells of a side of the square, levels of colour.
const CELLS: usize = 48;
const LEVELS: usize = 14;
/// Height and side of the square on the paper.
const TOP: f64 = 20.0;
const SIDE: f64 = 340.0;

/// From dark over green to bright.
fn colours() -> Vec<String> {
    let colour = |k: usize| {
        let t = k as f64 / (LEVELS - 1) as f64;
        let mix = |a: f64, b: f64, c: f64| {
            (if t < 0.5 { a + (b - a) * 2.0 * t } else { b + (c - b) * (2.0 * t - 1.0) }).round() as u8
        };
        format!("#{:02x}{:02x}{:02x}", mix(20.0, 0.0, 255.0), mix(30.0, 130.0, 230.0), mix(70.0, 160.0, 60.0))
    };
    (0..LEVELS).map(colour).collect()
}

/// Cells of the square by their share of the scale of colour; cells without one stay empty.
fn square(pen: &mut Pen, share: impl Fn(usize, usize) -> Option<f64>) {
    let level = |i, j| {
        share(i, j).map_or(LEVELS, |s: f64| (s.clamp(0.0, 1.0) * (LEVELS - 1) as f64).round() as usize)
    };
    pen.cells(CELLS, TOP, SIDE, level, &colours());
}

/// The middle of a cell.
fn place(k: usize) -> f64 {
    (k as f64 + 0.5) / CELLS as f64
}

/// A scale of colour: the power of ten at its dark end, and the decades from there to its bright end.
type Decades = (f64, f64);

/// From 1/100 to 10⁴, for whole functions.
const WIDE: Decades = (-2.0, 6.0);
/// From 1/5 to 50, for a root.
const NARROW: Decades = (-0.7, 2.4);

/// Where the integrand of the seminorm of order ν lies on the scale, logarithmically.
fn integrand(nu: f64, v: &impl Fn(f64) -> f64, (i, j): (usize, usize), (low, decades): Decades) -> f64 {
    let (x, y) = (place(i), place(j));
    // On the diagonal the next cell stands for it.
    let (x, y) = if i == j { (x - 0.25 / CELLS as f64, y + 0.25 / CELLS as f64) } else { (x, y) };
    let value = (v(x) - v(y)).powi(2) / (x - y).abs().powf(1.0 + 2.0 * nu);
    (value.max(1e-99).log10() - low) / decades
}

/// The axes of pairs (x, y) and words below.
fn named(mut pen: Pen, words: &str) -> String {
    pen.words(0.5, 15.0, "x", INK);
    pen.words(0.13, 200.0, "y", INK);
    pen.words(0.5, -15.0, words, INK);
    pen.svg()
}

/// The integrand of a step at one half.
pub(super) fn step(nu: f64) -> String {
    let words = if nu < 0.5 {
        "a step: the two bright corners can be integrated"
    } else {
        "a step: the two bright corners cannot be integrated"
    };
    let mut pen = Pen::new(430.0, 400.0, 1.0);
    square(&mut pen, |i, j| Some(integrand(nu, &|x| f64::from(u8::from(x > 0.5)), (i, j), WIDE)));
    named(pen, words)
}

/// The integrand of a hat.
pub(super) fn hat(nu: f64) -> String {
    let mut pen = Pen::new(430.0, 400.0, 1.0);
    square(&mut pen, |i, j| Some(integrand(nu, &|x: f64| 1.0 - (2.0 * x - 1.0).abs(), (i, j), WIDE)));
    named(pen, "a hat: as the order nears one, all of the diagonal lights up")
}

/// Pairs of points of one cell among n, for a function with a root at two fifths; all other pairs are empty.
fn pairs(cells: usize, words: &str) -> String {
    let mut pen = Pen::new(430.0, 400.0, 1.0);
    let cell = |k: usize| k * cells / CELLS;
    let root = |x: f64| (x - 0.4).max(0.0).sqrt();
    square(&mut pen, |i, j| (cell(i) == cell(j)).then(|| integrand(0.5, &root, (i, j), NARROW)));
    named(pen, words)
}

/// What the sum of the squares of the elements holds.
pub(super) fn element_pairs(cells: usize) -> String {
    pairs(
        cells,
        "coloured: pairs in one element, which the sum over elements counts; all others are left out",
    )
}

/// What the segments hold as the mesh gets finer.
pub(super) fn segment_pairs(cells: usize) -> String {
    pairs(cells, "coloured: pairs of one segment, all that contact can cost; they shrink to the diagonal")
}

/// A wave of k half periods on the edge, continued into the body with least energy.
pub(super) fn trace(waves: u32) -> String {
    let mut pen = Pen::new(485.0, 400.0, 26.0);
    let k = f64::from(waves);
    let wave = |x: f64| (PI * k * x).cos();
    square(&mut pen, |i, j| Some(wave(place(i)).abs() * (-PI * k * place(j)).exp()));
    // The square stands in the middle of the paper, ten to the left of that of the axis.
    let under = |x: f64| 0.5 + ((x - 0.5) * SIDE - 10.0) / SQUARE;
    pen.curve((0..=400).map(|j| f64::from(j) / 400.0).map(|x| (under(x), wave(x))), BLUE, "");
    pen.note(0.86, 1.6, "the edge", INK);
    pen.note(0.86, -0.2, "its trace", BLUE);
    let words = format!("frequency {waves}: slope like {waves}, felt to a depth like one over {waves};");
    pen.words(0.5, -1.9, &words, INK);
    pen.words(0.5, -2.7, &format!("slope squared times depth, the energy, is like {waves}"), INK);
    pen.svg()
}

/// The same waves; the corner of the square that is one period by one period is the same for all of them.
pub(super) fn one_number(waves: u32) -> String {
    let mut pen = Pen::new(440.0, 400.0, 26.0);
    let k = f64::from(waves);
    square(&mut pen, |i, j| Some((PI * k * place(i)).cos().abs() * (-PI * k * place(j)).exp()));
    let under = |x: f64| 0.5 + ((x - 0.5) * SIDE - 10.0) / SQUARE;
    let top = (400.0 - TOP - SIDE) / 26.0;
    let share = |t: f64| top + t * SIDE / 26.0;
    let corner = [(0.0, 0.0), (1.0 / k, 0.0), (1.0 / k, 1.0 / k), (0.0, 1.0 / k), (0.0, 0.0)];
    pen.curve(corner.map(|(x, y)| (under(x), share(y))), ORANGE, "");
    pen.note(0.86, 1.6, "the edge", INK);
    pen.words(0.5, -0.6, "in the orange corner it is the same picture for every frequency:", ORANGE);
    pen.words(0.5, -1.4, "energy of the edge over energy of the body is one number", INK);
    pen.svg()
}
