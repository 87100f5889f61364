//! Pictures of meshes: rectangles above the contact edge, a strip reduced to its edge, a V-cycle around a
//! contact set, the way of the argument.

use super::pen::{BLUE, GREEN, INK, ORANGE, Pen, SQUARE};

/// A grid of squares with one diagonal each, n along the edge, m above it, from y = 0 on.
pub(super) fn grid(pen: &mut Pen, n: u32, m: u32, opacity: f64) {
    let h = 1.0 / f64::from(n);
    let top = h * f64::from(m);
    (0..=m).for_each(|j| pen.thin(&[(0.0, h * f64::from(j)), (1.0, h * f64::from(j))], INK, opacity));
    for i in 0..=n {
        let x = h * f64::from(i);
        pen.thin(&[(x, 0.0), (x, top)], INK, opacity);
        for j in (0..m).filter(|_| i < n) {
            let y = h * f64::from(j);
            pen.thin(&[(x, y), (x + h, y + h)], INK, opacity);
        }
    }
}

/// The strip of rectangles above the contact edge, on which alone the body pays for contact.
pub(super) fn rectangles(n: u32) -> String {
    let mut pen = Pen::new(310.0, 265.0, SQUARE);
    let h = 1.0 / f64::from(n);
    pen.area(&[(0.0, 0.0), (1.0, 0.0), (1.0, 0.5), (0.0, 0.5)], INK, 0.05);
    pen.shade((0.0, 1.0), (0.0, h), ORANGE, 0.35);
    grid(&mut pen, n, n / 2, 0.35);
    for k in 0..n {
        let x = h * f64::from(k);
        pen.thin(&[(x, 0.0), (x + h, 0.0), (x + h, h), (x, h), (x, 0.0)], ORANGE, 1.0);
    }
    pen.line((0.0, 0.0), (1.0, 0.0), INK, "style=\"stroke-width:4\"");
    pen.words(0.5, -0.035, "contact edge", INK);
    pen.words(
        0.5,
        -0.07,
        "orange: one rectangle above each segment; only there contact enters the bound",
        ORANGE,
    );
    pen.svg()
}

/// A strip whose rows are eliminated down to its edge.
pub(super) fn elimination(rows: u32) -> String {
    let mut pen = Pen::new(270.0, 225.0, SQUARE);
    grid(&mut pen, 20, 8, 0.12);
    if rows > 0 {
        grid(&mut pen, 20, rows, 0.7);
    }
    for k in 0..=20 {
        (1..=rows).for_each(|j| pen.dot(f64::from(k) / 20.0, f64::from(j) / 20.0, BLUE));
        pen.dot(f64::from(k) / 20.0, 0.0, ORANGE);
    }
    pen.line((0.0, 0.0), (1.0, 0.0), ORANGE, "");
    let words = match rows {
        0 => "only the edge is left, with one number for each wave along it".to_owned(),
        1 => "one row of unknowns above the edge; each wave along it for itself".to_owned(),
        _ => format!("{rows} rows of unknowns above the edge; each wave along them for itself"),
    };
    pen.words(0.5, -0.06, &words, INK);
    pen.svg()
}

/// One V-cycle: hats of four grids, cut off where an active node holds them down.
pub(super) fn v_cycle() -> String {
    let mut pen = Pen::new(350.0, 50.0, 34.0);
    // Active nodes of the finest grid.
    let active = |x: f64| (0.49..0.71).contains(&x);
    pen.shade((0.5 - 0.01, 0.6875 + 0.01), (-7.6, 0.9), ORANGE, 0.15);
    pen.words(0.6, 1.0, "contact", ORANGE);
    for (k, n) in [32u32, 16, 8, 4].into_iter().enumerate() {
        let row = -2.2 * k as f64;
        pen.line((0.3, row), (1.0, row), INK, "opacity=\"0.4\"");
        let h = 1.0 / f64::from(n);
        let nodes = (0..=n).map(|j| h * f64::from(j)).filter(|&x| x >= 0.3 - 1e-9);
        for centre in nodes {
            // The hat at this node, at the nodes of the finest grid, zero at active ones.
            let fine = (0..=64).map(|j| 0.3125 + f64::from(j) * 0.6875 / 64.0);
            let hat = |x: f64| (1.0 - (x - centre).abs() / h).max(0.0);
            let held = |x: f64| {
                let (low, high) = ((x * 32.0 + 1e-9).floor() / 32.0, (x * 32.0 - 1e-9).ceil() / 32.0);
                let value = |x: f64| if active(x) { 0.0 } else { hat(x) };
                if high - low < 1e-9 {
                    value(x)
                } else {
                    value(low) + (value(high) - value(low)) * (x - low) * 32.0
                }
            };
            let points: Vec<(f64, f64)> = fine.map(|x| (x, row + held(x))).collect();
            if points.iter().any(|p| p.1 > row + 1e-9) {
                pen.curve(points, BLUE, "opacity=\"0.75\"");
            }
            if n == 32 && active(centre) {
                pen.dot(centre, row, ORANGE);
            }
        }
    }
    let down: Vec<(f64, f64)> = (0..4).map(|k| (0.035 * f64::from(k), 0.3 - 2.2 * f64::from(k))).collect();
    let up: Vec<(f64, f64)> = down.iter().rev().map(|&(x, y)| (0.21 - x, y)).collect();
    pen.curve(down.iter().chain(&up).copied(), GREEN, "");
    down.iter().chain(&up).for_each(|&(x, y)| pen.dot(x, y, GREEN));
    pen.words(0.5, -8.4, "down and up the grids; functions of all grids are zero at the active nodes", INK);
    pen.svg()
}

/// A box at a place across and above the lower end of the paper: its words and its colour.
pub(super) struct Box(pub(super) f64, pub(super) f64, pub(super) &'static str, pub(super) &'static str);

/// Boxes and the lines that lead from one to a lower one.
pub(super) fn boxes(height: f64, boxes: &[Box], lines: &[(usize, usize)]) -> String {
    let mut pen = Pen::new(height, height - 10.0, 1.0);
    for &(from, to) in lines {
        let (a, b) = (&boxes[from], &boxes[to]);
        pen.thin(&[(a.0, a.1 - 16.0), (b.0, b.1 + 22.0)], INK, 0.7);
    }
    for &Box(x, y, words, colour) in boxes {
        let half = 0.0098 * words.chars().count() as f64;
        pen.shade((x - half, x + half), (y - 14.0, y + 22.0), colour, 0.13);
        pen.words(x, y, words, INK);
    }
    pen.svg()
}

/// The way of the argument, from the problem to the theorem.
pub(super) fn argument() -> String {
    boxes(
        400.0,
        &[
            Box(0.5, 350.0, "the problem: u in K of least energy", INK),
            Box(0.5, 285.0, "Falk: error ≤ interpolation + consistency term", INK),
            Box(0.5, 220.0, "on each segment one of two cases", INK),
            Box(0.18, 150.0, "first case: u_N is small", BLUE),
            Box(0.8, 150.0, "second: σ_N = 0 on a zone", ORANGE),
            Box(0.18, 95.0, "embedding in L^q", BLUE),
            Box(0.8, 95.0, "Lemma 5.2: a small zone", ORANGE),
            Box(0.5, 30.0, "balance of θ: the rate of Theorem 3.1", GREEN),
        ],
        &[(0, 1), (1, 2), (2, 3), (2, 4), (3, 5), (4, 6), (5, 7), (6, 7)],
    )
}
