//! Maxima of functions whose maximum is known: at breakpoints, next to them, between them, of few and of many waves.

use crate::common::SplitMix;
use crate::hard::{Case, Family, decades, judge};
use fractional_sobolev::{Function, Mesh, Result, Tolerance};

/// Relative rounding of the values of the functions below.
const ROUNDING: f64 = 1e-14;

fn largest<'a>(
    what: String,
    random: &mut SplitMix,
    exact: f64,
    make: impl FnOnce() -> Result<Function<'a>>,
) -> Case {
    let asked = Tolerance::new(decades(random, -10.0, -2.0)).unwrap();
    let u = make().unwrap();
    Case::new(what, asked, (exact, ROUNDING), |asked| u.lp(f64::INFINITY, asked))
}

/// a − b |x − c|^p, c an end, a declared point, or not declared; of x or of positions.
fn of_power(random: &mut SplitMix) -> Case {
    let (left, length) = (random.between(-1.0, 1.0), decades(random, -3.0, 3.0));
    let right = left + length;
    let place = random.below(4);
    let c = match place {
        0 => left,
        1 => right,
        _ => left + length * random.between(0.05, 0.95),
    };
    let p = if place == 3 { random.between(1.0, 3.0) } else { random.between(0.05, 3.0) };
    let (a, b) = (random.between(0.5, 2.0), random.between(0.1, 2.0));
    let far = (c - left).max(right - c);
    let exact = a.max(b - a);
    let what = format!("{a} - {b} |x - {c}|^{p} on ({left}, {right}), place {place}");
    let of = move |distance: f64| a - b * (distance / far).powf(p);
    let breaks = if place == 2 { vec![left, c, right] } else { vec![left, right] };
    let by_positions = place < 3 && random.below(2) == 0;
    largest(what, random, exact, move || {
        if by_positions {
            let k = [0, 1, 1][place];
            Function::from_positions(&breaks, move |at| of(at.distance_to(k)))
        } else {
            Function::from_fn(&breaks, move |x| of((x - c).abs()))
        }
    })
}

/// x^p e^{−x/w}, with its maximum (pw)^p e^{−p} at pw, from the left or the right end.
fn of_layer(random: &mut SplitMix) -> Case {
    let (p, w) = (random.between(0.1, 2.0), decades(random, -12.0, -1.0));
    let exact = ((p * w).ln() * p - p).exp();
    let what = format!("x^{p} exp(-x/{w:e})");
    let k = random.below(2);
    largest(what, random, exact, move || {
        Function::from_positions(&[0.0, 1.0], move |at| {
            let x = at.distance_to(k);
            (p * x.ln() - x / w).exp()
        })
    })
}

/// 1 + h e^{−x/w}, whose maximum 1 + h is at the breakpoint.
fn of_layer_at_a_breakpoint(random: &mut SplitMix) -> Case {
    let (h, w) = (random.between(0.01, 3.0), decades(random, -40.0, 1.0));
    largest(format!("1 + {h} exp(-x/{w:e})"), random, 1.0 + h, move || {
        Function::from_positions(&[-1.0, 0.5, 1.0], move |at| {
            1.0 + h * (-at.distance_to(1) / w).exp()
        })
    })
}

/// x^p (1 − x)^q, with its maximum at p/(p + q).
fn of_two_powers(random: &mut SplitMix) -> Case {
    let [p, q] = [(); 2].map(|()| decades(random, -2.0, 1.3));
    let exact = (p * (p / (p + q)).ln() + q * (q / (p + q)).ln()).exp();
    largest(format!("x^{p} (1 - x)^{q}"), random, exact, move || {
        Function::from_positions(&[0.0, 1.0], move |at| {
            (p * at.log_distance_to(0) + q * at.log_distance_to(1)).exp()
        })
    })
}

/// cos(ωx + φ) of one to thousands of waves.
fn of_cosine(random: &mut SplitMix) -> Case {
    let (omega, phase) = (decades(random, 0.9, 4.0), random.between(0.0, 6.0));
    largest(format!("cos({omega} x + {phase})"), random, 1.0, move || {
        Function::from_fn(&[0.0, 1.0], move |x| (omega * x + phase).cos())
    })
}

/// √x or x^{−0.2} beside a bell that is higher and not declared: the bell's top, moved along the slope, by Newton's method.
fn of_bell_beside_a_singular_end(random: &mut SplitMix) -> Case {
    let p = if random.below(2) == 0 { random.between(0.2, 1.0) } else { 0.0 };
    let (c, w) = (random.between(0.1, 0.9), decades(random, -2.9, -1.5));
    let h = random.between(1.0, 5.0);
    let f = move |x: f64| x.powf(p) + h * (-0.5 * ((x - c) / w).powi(2)).exp();
    let mut x = c;
    for _ in 0..60 {
        let bell = h * (-0.5 * ((x - c) / w).powi(2)).exp();
        let y = (x - c) / w;
        let slope = p * x.powf(p - 1.0) - bell * y / w;
        let bend = p * (p - 1.0) * x.powf(p - 2.0) + bell * (y * y - 1.0) / (w * w);
        x -= slope / bend;
    }
    let exact = f(x).max(1.0 + h * (-0.5 * ((1.0 - c) / w).powi(2)).exp());
    let what = format!("x^{p} + {h} bell({c}, {w})");
    largest(what, random, exact, move || Function::from_fn(&[0.0, 1.0], f))
}

/// 1 − (x² − 1)² + ε x, with two maxima of which one is higher by 10⁻² to 10⁻¹², its place by Newton's method.
fn of_two_hills(random: &mut SplitMix) -> Case {
    let epsilon = decades(random, -12.0, -2.0);
    let shift = random.between(-0.05, 0.05);
    let f = move |x: f64| {
        let x = x - shift;
        1.0 - (x * x - 1.0).powi(2) + epsilon * x
    };
    let mut s = 1.0;
    for _ in 0..30 {
        s -= (-4.0 * s * (s * s - 1.0) + epsilon) / (-12.0 * s * s + 4.0);
    }
    largest(format!("two hills, {epsilon:e} and {shift}"), random, f(s + shift), move || {
        Function::from_fn(&[-1.3, 1.3], f)
    })
}

/// x^p, 0 < p < 1, minus its interpolant on n equal elements: the maximum lies in the first one at x = h p^{1/(1−p)}.
fn of_interpolation_error(random: &mut SplitMix) -> Case {
    let (p, count) = (random.between(0.05, 0.95), 1 + random.below(200));
    let h = 1.0 / count as f64;
    let at = p.powf(1.0 / (1.0 - p));
    let exact = h.powf(p) * (at.powf(p) - at);
    largest(format!("x^{p} minus its interpolant on {count} elements"), random, exact, move || {
        let mesh = Mesh::uniform(count, 1.0)?;
        let u = Function::from_fn(&[0.0, 1.0], move |x| x.powf(p))?;
        u.minus(&Function::interpolate(&mesh, 1, |x| x.powf(p))?)
    })
}

#[test]
fn maxima_that_are_known() {
    let families: [Family; 8] = [
        ("maxima of powers", 2000, 0.1, of_power),
        ("maxima of layers", 2000, 0.05, of_layer),
        ("maxima of layers at a breakpoint", 2000, 0.05, of_layer_at_a_breakpoint),
        ("maxima of two powers", 2000, 0.05, of_two_powers),
        ("maxima of cosines", 300, 0.05, of_cosine),
        ("maxima of bells beside a singular end", 500, 0.05, of_bell_beside_a_singular_end),
        ("maxima of two hills", 2000, 0.0, of_two_hills),
        ("maxima of interpolation errors", 300, 0.05, of_interpolation_error),
    ];
    judge(700, &families);
}
