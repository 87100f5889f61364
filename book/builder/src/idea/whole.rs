//! Pictures of whole pages: the problem and its condition, where the letters live, a later proof, repairs, a
//! card, meetings, the toolkit, years.

use super::grids::{Box, boxes};
use super::pen::{BLUE, GREEN, INK, ORANGE, Pen, SQUARE};

/// A block on a floor and a place of its contact edge; beside it all pairs that the contact condition allows.
pub(super) fn condition(place: f64) -> String {
    let mut pen = Pen::new(300.0, 215.0, SQUARE);
    let width = 0.5;
    let gap = |s: f64| 0.13 * ((s - 0.5).max(0.0) / 0.5).powf(1.5);
    let push = |s: f64| 0.09 * ((0.5 - s).max(0.0) / 0.5).sqrt();
    let floor = |s: f64| (width * s, gap(s));
    let mut body: Vec<(f64, f64)> = (0..=60).map(|k| floor(f64::from(k) / 60.0)).collect();
    body.extend([(width, 0.33), (0.0, 0.33)]);
    pen.area(&body, BLUE, 0.18);
    pen.curve((0..=60).map(|k| floor(f64::from(k) / 60.0)), BLUE, "");
    pen.line((0.0, 0.33), (width, 0.33), INK, "style=\"stroke-width:6\"");
    pen.words(0.25, 0.35, "clamped", INK);
    pen.shade((-0.05, 0.55), (-0.012, 0.0), INK, 0.5);
    for k in 0..10 {
        let s = (f64::from(k) + 0.5) / 20.0;
        let tip = width * s;
        pen.line((tip, -0.02 - push(s)), (tip, -0.012), ORANGE, "");
        pen.area(&[(tip - 0.008, -0.03), (tip + 0.008, -0.03), (tip, -0.008)], ORANGE, 1.0);
    }
    let (x, y) = floor(place);
    pen.dot(x, y, GREEN);
    // The two half lines of allowed pairs.
    let (origin, long) = ((0.95, 0.2), 0.26);
    pen.thin(&[(origin.0 - long, origin.1), (origin.0 + 0.03, origin.1)], INK, 0.4);
    pen.thin(&[(origin.0, origin.1 - long), (origin.0, origin.1 + 0.06)], INK, 0.4);
    pen.line((origin.0 - long, origin.1), origin, BLUE, "");
    pen.line(origin, (origin.0, origin.1 - long), ORANGE, "");
    pen.dot(origin.0 - 1.9 * gap(place), origin.1 - 2.6 * push(place), GREEN);
    pen.note(origin.0 - long, origin.1 + 0.02, "u_N", BLUE);
    pen.note(origin.0 - 0.065, origin.1 - long, "σ_N", ORANGE);
    let words = match place {
        s if s < 0.5 => "in contact: u_N = 0, and the floor pushes, σ_N < 0",
        s if s > 0.5 => "lifted: u_N < 0, and nothing pushes, σ_N = 0",
        _ => "where contact ends: both are zero",
    };
    pen.words(0.5, -0.145, words, GREEN);
    pen.svg()
}

/// Body, edges and one contact segment with its letters.
pub(super) fn letters() -> String {
    let mut pen = Pen::new(340.0, 230.0, SQUARE);
    let side = 0.32;
    pen.area(&[(0.0, 0.0), (side, 0.0), (side, side), (0.0, side)], INK, 0.06);
    for k in 0..=4 {
        let t = side * f64::from(k) / 4.0;
        pen.thin(&[(t, 0.0), (t, side)], INK, 0.35);
        pen.thin(&[(0.0, t), (side, t)], INK, 0.35);
        pen.thin(&[(t, 0.0), (side, side - t)], INK, 0.35);
        pen.thin(&[(0.0, t), (side - t, side)], INK, 0.35);
    }
    pen.line((0.0, side), (side, side), INK, "style=\"stroke-width:6\"");
    pen.line((0.0, 0.0), (side, 0.0), BLUE, "");
    pen.words(0.16, side + 0.025, "Γ_D", INK);
    pen.words(0.06, 0.215, "Ω", INK);
    pen.words(0.05, -0.05, "Γ_C", BLUE);
    pen.line((0.28, 0.0), (0.28, -0.07), INK, "");
    pen.area(&[(0.27, -0.06), (0.29, -0.06), (0.28, -0.085)], INK, 1.0);
    pen.note(0.295, -0.07, "n", INK);
    let (from, to) = (side / 2.0, 0.75 * side);
    pen.line((from, 0.0), (to, 0.0), ORANGE, "style=\"stroke-width:7\"");
    pen.words(0.5 * (from + to), 0.02, "T", ORANGE);
    // The segment again, larger.
    let (left, right) = (0.5, 1.0);
    let x = |s: f64| left + (right - left) * s;
    pen.dashed((from, -0.01), (left, 0.15));
    pen.dashed((to, 0.01), (left, 0.27));
    let zone = 0.26;
    for (a, b) in [(0.0, zone), (1.0 - zone, 1.0)] {
        pen.shade((x(a), x(b)), (-0.03, 0.24), GREEN, 0.15);
        pen.words(x(0.5 * (a + b)), 0.255, "hθ", GREEN);
    }
    let (xi_1, xi_2) = (0.2, 0.62);
    let points = || (0..=200).map(|k| f64::from(k) / 200.0);
    let opened =
        |s: f64| 0.1 * ((xi_1 - s).max(0.0) / xi_1).powf(1.5) + 0.12 * ((s - xi_2).max(0.0) / 0.38).powf(1.5);
    pen.line((left, 0.2), (right, 0.2), INK, "opacity=\"0.4\"");
    pen.curve(points().map(|s| (x(s), 0.2 - opened(s))), BLUE, "");
    for (s, name) in [(xi_1, "ξ₁"), (xi_2, "ξ₂")] {
        pen.dot(x(s), 0.2, BLUE);
        pen.words(x(s), 0.215, name, BLUE);
    }
    pen.note(1.015, 0.1, "u_N", BLUE);
    pen.line((left, 0.04), (right, 0.04), INK, "opacity=\"0.4\"");
    let pressure = |s: f64| 0.3 * ((s - xi_1) * (xi_2 - s)).max(0.0).sqrt();
    pen.curve(points().map(|s| (x(s), 0.04 - pressure(s))), ORANGE, "");
    pen.note(1.015, 0.03, "σ_N", ORANGE);
    for (s, name) in [(0.0, "a₁"), (1.0, "a₂")] {
        pen.dot(x(s), 0.2, INK);
        pen.words(x(s), -0.07, name, INK);
    }
    pen.thin(&[(left, -0.09), (right, -0.09)], INK, 0.8);
    pen.words(x(0.5), -0.125, "h", INK);
    pen.words(0.16, -0.125, "the body and its mesh", INK);
    pen.words(0.75, -0.175, "the contact segment T", ORANGE);
    pen.svg()
}

/// One segment by the lengths of its contact and of its gap; the longer is at least one half.
pub(super) fn longer_half(contact: f64) -> String {
    let mut pen = Pen::new(270.0, 60.0, 30.0);
    // Contact in three pieces, gaps before, between and behind them, by their shares.
    pen.shade((0.0, 1.0), (-0.5, 0.5), BLUE, 0.15);
    let mut x = 0.0;
    for (gap, piece) in [(0.15, 0.5), (0.35, 0.3), (0.3, 0.2)] {
        x += (1.0 - contact) * gap;
        pen.shade((x, x + contact * piece), (-0.5, 0.5), ORANGE, 0.75);
        x += contact * piece;
    }
    pen.note(0.0, 0.8, "one segment: contact orange, gap blue, as it may be", INK);
    pen.at(145.0, 30.0);
    pen.shade((0.0, contact), (-0.5, 0.5), ORANGE, 0.75);
    pen.shade((contact, 1.0), (-0.5, 0.5), BLUE, 0.15);
    pen.dashed((0.5, -1.0), (0.5, 1.0));
    pen.words(0.5, -1.6, "1/2", INK);
    pen.note(0.0, 0.8, "the same, put together", INK);
    let (ends, words) = if contact >= 0.5 {
        ((0.0, contact), "contact is longer: there u_N and u_N' vanish, on at least one half")
    } else {
        ((contact, 1.0), "the gap is longer: there σ_N vanishes, on more than one half")
    };
    pen.line((ends.0, -0.75), (ends.1, -0.75), GREEN, "style=\"stroke-width:5\"");
    pen.words(0.5, -2.6, words, GREEN);
    pen.words(0.5, -3.4, "so the Poincaré constant is that of a long zone, and no θ is chosen", INK);
    pen.svg()
}

/// The way of the argument, and beside it what was found at each step.
pub(super) fn repairs() -> String {
    let steps = [
        ("Lemmas 6.1, 6.2", "for h ≤ 1; one is no sharp constant", BLUE),
        ("first case, (3.7)", "gives away a power of h", ORANGE),
        ("Lemma 5.2 at 1/2", "not sharp, and false as θ tends to 1", ORANGE),
        ("its proof", "one gap, closed", GREEN),
        ("Remark 7", "one step fails, the claim holds", GREEN),
        ("Remark 5", "a norm for a seminorm, mended", GREEN),
        ("the two cases", "not needed", ORANGE),
        ("Theorems 3.1, 4.1", "hold, for h ≤ 1/2", GREEN),
    ];
    let mut pen = Pen::new(370.0, 350.0, 1.0);
    for (k, (step, found, colour)) in steps.into_iter().enumerate() {
        let y = 320.0 - 44.0 * k as f64;
        pen.shade((0.0, 0.35), (y - 12.0, y + 20.0), INK, 0.08);
        pen.shade((0.38, 1.04), (y - 12.0, y + 20.0), colour, 0.15);
        pen.thin(&[(0.35, y + 4.0), (0.38, y + 4.0)], colour, 0.9);
        if k > 0 {
            pen.thin(&[(0.17, y + 20.0), (0.17, y + 32.0)], INK, 0.6);
        }
        pen.note(0.012, y, step, INK);
        pen.note(0.392, y, found, colour);
    }
    pen.svg()
}

/// A card of the page of cards.
pub(super) fn card() -> String {
    let mut pen = Pen::new(240.0, 215.0, 1.0);
    pen.shade((0.06, 0.94), (0.0, 200.0), BLUE, 0.08);
    pen.thin(&[(0.06, 0.0), (0.94, 0.0), (0.94, 200.0), (0.06, 200.0), (0.06, 0.0)], INK, 0.8);
    let rows = [
        ("label", "which line of the paper", INK),
        ("statement", "what it says", INK),
        ("assumptions", "for which functions and meshes", INK),
        ("example", "the program that computes it", BLUE),
        ("test", "fails where it is not true", ORANGE),
        ("verdict", "printed by the program", GREEN),
    ];
    for (k, (name, words, colour)) in rows.into_iter().enumerate() {
        let y = 172.0 - 31.0 * k as f64;
        pen.note(0.09, y, name, colour);
        pen.note(0.34, y, words, INK);
        if k > 0 {
            pen.thin(&[(0.06, y + 21.0), (0.94, y + 21.0)], INK, 0.25);
        }
    }
    pen.svg()
}

/// The four meetings and what each hands to the next.
pub(super) fn meetings() -> String {
    boxes(
        330.0,
        &[
            Box(0.5, 285.0, "1: a block on a floor, and half a derivative", BLUE),
            Box(0.5, 205.0, "2: one error estimate, and its hard term", BLUE),
            Box(0.5, 125.0, "3: the hard term on a segment, a small zone", ORANGE),
            Box(0.5, 45.0, "4: the theorem, and what it gives away", GREEN),
        ],
        &[(0, 1), (1, 2), (2, 3)],
    )
}

/// What goes into the toolkit and what comes out.
pub(super) fn toolkit() -> String {
    boxes(
        300.0,
        &[
            Box(0.13, 250.0, "your function", BLUE),
            Box(0.5, 250.0, "your zone", BLUE),
            Box(0.87, 250.0, "your mesh, load", BLUE),
            Box(0.13, 155.0, "norms", INK),
            Box(0.5, 155.0, "best constants", INK),
            Box(0.87, 155.0, "contact", INK),
            Box(0.3, 55.0, "a number and its error", GREEN),
            Box(0.84, 55.0, "a status, KKT residuals", GREEN),
        ],
        &[(0, 3), (1, 4), (2, 5), (2, 3), (3, 6), (4, 6), (5, 7)],
    )
}

/// Years of what the bibliography has on Signorini's problem, the paper in the middle.
pub(super) fn years() -> String {
    let mut pen = Pen::new(310.0, 30.0, 36.0);
    let entries = [
        ("1959", "Signorini asks", BLUE),
        ("1964", "Fichera: there is one solution", BLUE),
        ("1974", "Falk's lemma", BLUE),
        ("1977", "Brezzi, Hager and Raviart", BLUE),
        ("2000", "Ben Belgacem", BLUE),
        ("2012", "Hild and Renard: the paper", ORANGE),
        ("2015", "Drouet and Hild: the optimal rate", GREEN),
        ("2023", "the book of Chouly, Hild and Renard", GREEN),
    ];
    pen.line((0.25, 0.3), (0.25, -7.3), INK, "opacity=\"0.4\"");
    for (k, (year, words, colour)) in entries.into_iter().enumerate() {
        let y = -(k as f64);
        pen.dot(0.25, y, colour);
        pen.ending(0.22, y - 0.14, year, colour);
        pen.note(0.28, y - 0.14, words, colour);
    }
    pen.svg()
}
