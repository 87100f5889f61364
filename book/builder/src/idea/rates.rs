//! Pictures of exponents: slopes of errors, a transition of given regularity, shells about it, rungs of a
//! proof.

use super::pen::{BLUE, GREEN, INK, ORANGE, Pen};
use std::f64::consts::LN_2;

/// Halvings of h from right to left.
const HALVINGS: f64 = 10.0;

/// Errors over the mesh size with the exponents known before, of the theorem, and the optimal one; both axes
/// logarithmic, constants one.
pub(super) fn slopes(tau: f64) -> String {
    let mut pen = Pen::new(330.0, 30.0, 26.0);
    pen.line((0.0, -HALVINGS), (1.0, -HALVINGS), INK, "");
    pen.line((0.0, -HALVINGS), (0.0, 0.4), INK, "");
    let lines = [
        ("known before", tau / 2.0 - 0.25, ORANGE),
        ("the theorem", tau * tau - 2.5 * tau + 2.0, BLUE),
        ("best possible", tau - 1.0, GREEN),
    ];
    for (k, (name, order, colour)) in lines.into_iter().enumerate() {
        pen.line((0.0, -HALVINGS * order), (1.0, 0.0), colour, "");
        pen.note(0.62, -5.6 - 1.2 * k as f64, &format!("{name}: order {order:.3}"), colour);
    }
    pen.note(0.02, 0.1, "error", INK);
    for (x, label) in
        [(0.0, "1/1024"), (0.2, "1/256"), (0.4, "1/64"), (0.6, "1/16"), (0.8, "1/4"), (1.0, "1")]
    {
        pen.words(x, -HALVINGS - 0.8, label, INK);
    }
    pen.words(0.5, -HALVINGS - 0.8, "h", INK);
    pen.svg()
}

/// One transition of regularity τ: displacement and pressure.
pub(super) fn transition(tau: f64) -> String {
    let mut pen = Pen::new(310.0, 40.0, 90.0);
    pen.shade((0.0, 0.5), (-2.4, 0.2), ORANGE, 0.08);
    pen.words(0.25, 0.28, "contact", INK);
    pen.words(0.75, 0.28, "gap", INK);
    pen.line((0.0, 0.0), (1.0, 0.0), INK, "opacity=\"0.4\"");
    let from = |x: f64| (2.0 * (x - 0.5)).max(0.0);
    pen.graph_fine(|x| -from(x).powf(tau - 1.0), BLUE);
    pen.note(1.02, -0.95, "u_N", BLUE);
    pen.at(165.0, 55.0);
    pen.line((0.0, 0.0), (1.0, 0.0), INK, "opacity=\"0.4\"");
    let pressure = |x: f64| -from(1.0 - x).powf(tau - 2.0);
    // Below regularity two the pressure is infinite at the transition: a curve that leaves the paper, and its
    // asymptote.
    let last = if tau < 2.0 { 0.5 - 0.5 * 2f64.powf(1.0 / (tau - 2.0)) } else { 0.5 };
    pen.graph(0.0, last, ORANGE, pressure);
    if tau < 2.0 {
        pen.dashed((0.5, 0.0), (0.5, -2.0));
    } else {
        pen.line((0.5, pressure(0.5)), (0.5, 0.0), ORANGE, "");
    }
    pen.line((0.5, 0.0), (1.0, 0.0), ORANGE, "");
    pen.note(1.02, -0.05, "σ_N", ORANGE);
    let words = match tau {
        t if t <= 1.5 => "up to 3/2: the pressure is not in L²",
        t if t < 2.0 => "below two: the slope and the pressure are infinite at the transition",
        t if t < 2.25 => "at two: a kink and a jump, just outside H²",
        t if t < 2.5 => "above two: slope and pressure start at zero, steeply",
        _ => "five halves: the transition of nature, inside a straight edge",
    };
    pen.words(0.5, -2.35, words, INK);
    pen.svg()
}

/// What the shells about a transition add to the squared error at regularity two, logarithms to the power −α.
pub(super) fn shells(alpha: f64) -> String {
    let mut pen = Pen::new(280.0, 215.0, 180.0);
    let share = |k: u32| ((2.0 + f64::from(k) * LN_2) / 2.0).powf(-2.0 * alpha);
    for k in 0..=24 {
        let x = 1.0 - f64::from(k) / 25.0;
        pen.shade((x - 0.032, x), (0.0, share(k)), BLUE, 0.7);
    }
    pen.line((0.0, 0.0), (1.0, 0.0), INK, "");
    for (k, label) in [(0, "1"), (8, "2^-8"), (16, "2^-16"), (24, "2^-24")] {
        pen.words(1.0 - f64::from(k) / 25.0 - 0.016, -0.1, label, INK);
    }
    pen.words(0.5, -0.2, "distance from the transition; halving h adds one bar at the left", INK);
    let words = match alpha {
        0.0 => "equal bars: the sum grows like the logarithm of h, outside H²",
        a if a <= 0.5 => "the bars shrink too slowly: the sum still grows, outside H²",
        _ => "in H² the bars have a finite sum: no logarithm",
    };
    pen.words(0.5, 1.1, words, GREEN);
    pen.svg()
}

/// Orders of the bounds of the proof of Theorem 3.1 on one segment, squared; what is lost is orange.
pub(super) fn ladder(tau: f64) -> String {
    let mut pen = Pen::new(270.0, 48.0, 58.0);
    let (whole, lost) = (2.0 * tau - 2.0, (2.0 * tau - 3.0) * (2.0 - tau));
    let rungs = [
        ("the term itself", 0.0),
        ("second case, with the zone without pressure that is there", 0.0),
        ("second case, with a zone of length hθ", lost),
        ("first case: the same, since θ balances the two", lost),
    ];
    for (k, (name, loss)) in rungs.into_iter().enumerate() {
        let y = -(k as f64);
        pen.note(0.0, y + 0.28, name, INK);
        pen.shade((0.0, (whole - loss) / 2.1), (y - 0.18, y + 0.18), BLUE, 0.6);
        pen.shade(((whole - loss) / 2.1, whole / 2.1), (y - 0.18, y + 0.18), ORANGE, 0.8);
        pen.note(whole / 2.1 + 0.012, y - 0.09, &format!("{:.3}", whole - loss), INK);
    }
    pen.words(0.5, -3.65, "exponents of h in the squared error; orange: what a line gives away", INK);
    pen.svg()
}

/// Numbers as a computer writes them: no gaps in lengths down to 10⁻³⁰⁸, but gaps in places.
pub(super) fn magnitudes() -> String {
    let mut pen = Pen::new(220.0, 70.0, 50.0);
    // Powers of ten from -310 to 10.
    let place = |power: f64| (power + 310.0) / 320.0;
    let rows = [(-308.0, "lengths of cells: from 10^-308 on", GREEN), (-16.0, "places near one", ORANGE)];
    for (k, (least, name, colour)) in rows.into_iter().enumerate() {
        let y = -1.3 * k as f64;
        pen.shade((place(least), place(0.0)), (y - 0.2, y + 0.2), colour, 0.6);
        pen.note(0.0, y + 0.35, name, INK);
    }
    for power in [-300.0, -200.0, -100.0, 0.0] {
        let label = if power == 0.0 { "1".to_owned() } else { format!("10^{power}") };
        pen.dashed((place(power), 0.3), (place(power), -1.9));
        pen.words(place(power), -2.25, &label, INK);
    }
    pen.words(
        0.5,
        -2.75,
        "a mesh that keeps lengths sees what a mesh that keeps places cannot tell apart",
        INK,
    );
    pen.svg()
}
