//! Pictures of functions: waves, staircases, truncated logarithms, stretching, an odd function.

use super::means::mean;
use super::pen::{BLUE, GREEN, INK, ORANGE, Pen};
use std::f64::consts::PI;

/// The wave of Remark 2 and its nodes.
pub(super) fn wave(cells: u32) -> String {
    let mut pen = Pen::new(250.0, 60.0, 70.0);
    let n = f64::from(cells);
    pen.graph_fine(|x| (2.0 * PI * n * x).cos() - 1.0, BLUE);
    pen.line((0.0, 0.0), (1.0, 0.0), GREEN, "");
    for k in 0..=cells {
        pen.dot(f64::from(k) / n, 0.0, GREEN);
    }
    pen.dashed((0.0, -1.0), (1.0, -1.0));
    pen.note(1.01, -1.05, "mean", INK);
    pen.words(0.9, 0.2, "interpolant", GREEN);
    pen.words(
        0.5,
        -2.5,
        &format!(
            "{cells} cells: zero at every node, so the interpolant is zero; the mean of the error is minus one"
        ),
        INK,
    );
    pen.svg()
}

/// A function and its means on n cells.
pub(super) fn staircase(cells: u32) -> String {
    let v = |x: f64| 0.5 * (3.0 * x).sin() + 0.9 * x * x;
    let mut pen = Pen::new(280.0, 230.0, 150.0);
    let n = f64::from(cells);
    for k in 0..cells {
        let (a, b) = (f64::from(k) / n, f64::from(k + 1) / n);
        let mean = mean(v, a, b);
        pen.fill(&[(a, v(a)), (0.5 * (a + b), mean), (a, mean)], ORANGE);
        pen.fill(&[(b, v(b)), (0.5 * (a + b), mean), (b, mean)], ORANGE);
        pen.line((a, mean), (b, mean), ORANGE, "");
    }
    pen.graph(0.0, 1.0, BLUE, v);
    pen.words(
        0.5,
        -0.22,
        "the steps miss the slope: twice as many cells, half the error, however smooth the function",
        INK,
    );
    pen.svg()
}

/// The truncated logarithm of Remark 5 with α = 2/5, against the logarithm of x.
pub(super) fn truncated(length: f64) -> String {
    let mut pen = Pen::new(270.0, 210.0, 150.0);
    // The axis runs from e^-20 to 1.
    let place = |t: f64| 1.0 - t / 20.0;
    pen.shade((0.0, place(length)), (0.0, 1.1), ORANGE, 0.15);
    pen.line((0.0, 0.0), (1.0, 0.0), INK, "opacity=\"0.4\"");
    pen.graph(0.0, 1.0, BLUE, |x| 1.0 - ((20.0 * (1.0 - x)) / length).powf(0.4).min(1.0));
    pen.logarithms(-0.14);
    pen.note(0.02, 1.0, "zero here", ORANGE);
    pen.words(0.5, -0.34, "w, against x on a logarithmic axis", INK);
    pen.svg()
}

/// One step of the induction: a zone θ² of (0, 1) becomes a zone θ of the first unit interval.
pub(super) fn stretching(theta: f64) -> String {
    let mut pen = Pen::new(210.0, 50.0, 20.0);
    let bars = [
        ("(0, 1): zone θ², orange", theta * theta, theta, "length θ"),
        ("stretched by 1/θ: zone θ", theta, 1.0, "first unit interval"),
    ];
    for (k, (name, zone, unit, words)) in bars.into_iter().enumerate() {
        pen.at(55.0 + 85.0 * k as f64, 20.0);
        let whole = 1.0;
        // The second bar is (0, 1/θ) on the same paper: everything is drawn at its share of the whole.
        let scale = if k == 0 { 1.0 } else { theta };
        pen.shade((0.0, whole), (-0.5, 0.5), INK, 0.12);
        pen.shade((0.0, unit * scale), (-0.5, 0.5), BLUE, 0.25);
        pen.shade((0.0, zone * scale), (-0.5, 0.5), ORANGE, 0.8);
        pen.note(0.0, 0.8, name, INK);
        pen.note((unit * scale).min(0.75) + 0.01, -0.2, words, BLUE);
    }
    pen.words(0.5, -2.2, "the same picture, another unit: two steps with θ make one with θ²", INK);
    pen.svg()
}

/// The odd function of Remark 7: mean zero on the zone, and on neither half of it.
pub(super) fn odd(theta: f64) -> String {
    let mut pen = Pen::new(250.0, 120.0, 80.0);
    let (a, b) = (0.5 - theta / 2.0, 0.5 + theta / 2.0);
    pen.shade((a, b), (-1.3, 1.3), ORANGE, 0.2);
    pen.line((0.0, 0.0), (1.0, 0.0), INK, "opacity=\"0.4\"");
    pen.line((0.0, -1.0), (0.5, -1.0), BLUE, "");
    pen.line((0.5, 1.0), (1.0, 1.0), BLUE, "");
    pen.dashed((0.5, -1.4), (0.5, 1.4));
    pen.note(0.52, -1.15, "the cut", INK);
    pen.words(0.5, -1.58, "mean zero on the zone; on each piece a constant: seminorm zero, norm not", INK);
    pen.svg()
}
