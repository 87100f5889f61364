//! Pictures of the contact edge: the two alternatives, the two cones, worst sets, a fat Cantor set.

use super::pen::{BLUE, GREEN, INK, ORANGE, Pen};

/// Contact between these places of the segment of Figure 3.2.
const XI: (f64, f64) = (0.2, 0.7);

/// Figure 3.2 on one segment: zones of length θ at both vertices, and which case holds.
pub(super) fn nodal_alternative(theta: f64) -> String {
    let mut pen = Pen::new(330.0, 120.0, 90.0);
    let (near_left, near_right) = (XI.0 <= theta, 1.0 - XI.1 <= theta);
    for (zone, has_zero) in [((0.0, theta), near_left), ((1.0 - theta, 1.0), near_right)] {
        let colour = if has_zero { GREEN } else { ORANGE };
        pen.shade(zone, (-1.9, 0.55), colour, 0.18);
    }
    pen.words(theta / 2.0, 0.62, "hθ", INK);
    pen.words(1.0 - theta / 2.0, 0.62, "hθ", INK);
    pen.line((0.0, 0.0), (1.0, 0.0), INK, "opacity=\"0.4\"");
    pen.graph(0.0, XI.0, BLUE, |x| -0.7 * ((XI.0 - x) / XI.0).powf(1.5));
    pen.graph(XI.0, XI.1, BLUE, |_| 0.0);
    pen.graph(XI.1, 1.0, BLUE, |x| -0.9 * ((x - XI.1) / (1.0 - XI.1)).powf(1.5));
    pen.note(1.02, -0.9, "u_N", BLUE);
    for (x, name) in [(XI.0, "ξ₁"), (XI.1, "ξ₂")] {
        pen.dot(x, 0.0, BLUE);
        pen.words(x, 0.15, name, BLUE);
    }
    pen.at(230.0, 90.0);
    pen.line((0.0, 0.0), (1.0, 0.0), INK, "opacity=\"0.4\"");
    let bump = |x: f64| -2.4 * ((x - XI.0) * (XI.1 - x)).max(0.0).sqrt();
    pen.graph(0.0, 1.0, ORANGE, bump);
    pen.note(1.02, -0.05, "σ_N", ORANGE);
    for (x, name) in [(0.0, "a₁"), (1.0, "a₂")] {
        pen.dot(x, 0.0, INK);
        pen.words(x, -0.28, name, INK);
    }
    let words = match (near_left, near_right) {
        (true, true) => "first case: u_N has a zero in both zones",
        (true, false) => "second case: no zero near a₂, so σ_N = 0 on the zone there",
        _ => "second case: no zero near a₁, so σ_N = 0 on the zone there",
    };
    pen.words(0.5, -0.95, words, INK);
    pen.svg()
}

/// Figure 4.1 on one segment: the diameter of the contact set against θ.
pub(super) fn midpoint_alternative(theta: f64) -> String {
    let (c1, c2) = (0.35, 0.62);
    let mut pen = Pen::new(250.0, 90.0, 90.0);
    let is_long = c2 - c1 >= theta;
    let colour = if is_long { GREEN } else { ORANGE };
    pen.shade((c1, c2), (-1.1, 0.35), colour, 0.18);
    pen.line((0.0, 0.0), (1.0, 0.0), INK, "opacity=\"0.4\"");
    pen.graph(0.0, c1, BLUE, |x| -0.8 * ((c1 - x) / c1).powf(1.5));
    // Between the contact points the gap may open again.
    pen.graph(c1, c2, BLUE, |x| -60.0 * (x - c1) * (c2 - x) * (x - 0.47).abs());
    pen.graph(c2, 1.0, BLUE, |x| -0.9 * ((x - c2) / (1.0 - c2)).powf(1.5));
    for (x, name) in [(c1, "c₁"), (c2, "c₂")] {
        pen.dot(x, 0.0, BLUE);
        pen.words(x, 0.15, name, BLUE);
    }
    pen.note(1.02, -0.9, "u_N", BLUE);
    let middle = 0.5 * (c1 + c2);
    pen.line((middle - theta / 2.0, -1.25), (middle + theta / 2.0, -1.25), INK, "");
    pen.words(middle, -1.2, "hθ", INK);
    let words = if is_long {
        "second case: between c₁ and c₂ the slope of u_N has mean zero"
    } else {
        "first case: contact, and with it σ_N, lives on a piece shorter than hθ"
    };
    pen.words(0.5, -1.62, words, INK);
    pen.svg()
}

/// A trace in the nodal or in the midpoint cone on five segments; what sinks into the floor is shaded.
pub(super) fn cones(is_midpoint: bool) -> String {
    let values = if is_midpoint {
        [0.35, -0.35, 0.35, -0.4, -0.1, -0.9]
    } else {
        [0.0, 0.0, -0.05, -0.25, -0.5, -0.9]
    };
    let mut pen = Pen::new(230.0, 90.0, 100.0);
    let node = |k: usize| (k as f64 / 5.0, values[k]);
    pen.shade((0.0, 1.0), (0.0, 0.6), INK, 0.06);
    pen.note(0.78, 0.45, "the floor", INK);
    for k in 0..5 {
        let ((a, left), (b, right)) = (node(k), node(k + 1));
        let root = if left * right < 0.0 { Some(a + (b - a) * left / (left - right)) } else { None };
        if left > 0.0 {
            pen.fill(&[(a, 0.0), (a, left), (root.unwrap_or(b), 0.0)], ORANGE);
        }
        if right > 0.0 {
            pen.fill(&[(b, 0.0), (b, right), (root.unwrap_or(a), 0.0)], ORANGE);
        }
        let middle = (0.5 * (a + b), 0.5 * (left + right));
        if is_midpoint {
            pen.dot(middle.0, middle.1, GREEN);
        }
    }
    pen.line((0.0, 0.0), (1.0, 0.0), INK, "");
    pen.curve((0..6).map(node), BLUE, "");
    for (x, y) in (0..6).map(node) {
        pen.dot(x, y, BLUE);
    }
    let words = if is_midpoint {
        "midpoint cone: on each segment the mean, at the green dot, is not above the floor line"
    } else {
        "nodal cone: no node, so no point, is above the floor line"
    };
    pen.words(0.5, -1.25, words, INK);
    pen.svg()
}

/// Contact and gap on one segment, the two factors of the short proof and their product.
pub(super) fn worst_set(gap: f64) -> String {
    let contact = 1.0 - gap;
    let mut pen = Pen::new(300.0, 60.0, 30.0);
    pen.shade((0.0, gap), (-0.5, 0.5), BLUE, 0.25);
    pen.shade((gap, 1.0), (-0.5, 0.5), ORANGE, 0.25);
    pen.words(gap / 2.0, -0.15, "N", BLUE);
    pen.words(gap + contact / 2.0, -0.15, "E", ORANGE);
    pen.words(0.5, 0.9, "one segment: E contact, N gap", INK);
    let rows = [
        ("pressure, √(|E| / 2|N|)", (contact / (2.0 * gap)).sqrt(), ORANGE),
        ("slope, √(|N| / 2|E|)", (gap / (2.0 * contact)).sqrt(), BLUE),
        ("their product", 0.5, GREEN),
    ];
    for (k, (name, value, colour)) in rows.into_iter().enumerate() {
        pen.at(130.0 + 55.0 * k as f64, 30.0);
        // The factors run up to 2.2.
        pen.shade((0.0, value / 2.3), (-0.3, 0.3), colour, 0.7);
        pen.note(0.0, 0.5, name, INK);
        pen.note(value / 2.3 + 0.015, -0.18, &format!("{value:.2}"), colour);
    }
    pen.svg()
}

/// Generations of the fat Cantor set: the pieces left, with a gap function below.
pub(super) fn fat_cantor(generations: u32) -> String {
    let mut pen = Pen::new(185.0 + 34.0 * f64::from(generations), 40.0, 34.0);
    let mut pieces = vec![(0.0, 1.0)];
    let mut gaps = Vec::new();
    for generation in 0..=generations {
        for &piece in &pieces {
            pen.shade(piece, (-f64::from(generation) - 0.35, -f64::from(generation) + 0.35), ORANGE, 0.75);
        }
        if generation == generations {
            break;
        }
        // Gaps of generation k take 2^-(k+2) of the whole: one half is left.
        let open = 0.25 * 0.25f64.powi(generation as i32);
        let cut = |&(a, b): &(f64, f64)| {
            let middle = 0.5 * (a + b);
            [(a, middle - open / 2.0), (middle + open / 2.0, b)]
        };
        gaps.extend(pieces.iter().map(|&(a, b)| (0.5 * (a + b) - open / 2.0, 0.5 * (a + b) + open / 2.0)));
        pieces = pieces.iter().flat_map(cut).collect();
    }
    pen.at(60.0 + 34.0 * (f64::from(generations) + 1.0), 120.0);
    pen.line((0.0, 0.0), (1.0, 0.0), INK, "opacity=\"0.4\"");
    for (a, b) in gaps {
        pen.graph(a, b, BLUE, |x| -(x - a) * (b - x) / (b - a));
    }
    pen.note(1.02, 0.0, "u_N", BLUE);
    let left: f64 = pieces.iter().map(|(a, b)| b - a).sum();
    let words =
        format!("{} pieces, together {left:.3} long; in the end one half, and no interval", pieces.len());
    pen.words(0.5, -0.25, &words, INK);
    pen.svg()
}
