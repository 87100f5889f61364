//! One contact segment through the whole argument: that of the block in which the contact set ends,
//! and every bound of its term.
//!
//! The proof of Theorem 3.1 bounds, on each contact segment T of length h, the consistency term
//!
//! ```text
//! term = ∫ σ_N I u_N over T ≥ 0,     I u_N linear on T with the values of u_N at both ends.
//! ```
//!
//! This file computes the term of one segment and the numbers that the paper, and this project, put
//! above it. The block is the unit square in plane strain, λ = μ = 1, fixed at y = 1, under the
//! load (0, −cos πx), with u_N = −u₂ ≤ 0 at the nodes of y = 0. The edge has n segments, and u is
//! the P1 solution on n k × n k squares, each cut from bottom left to top right, so that T has k =
//! 32 cells. On a cell u_N is linear, and σ_N is constant: half of the force of each of its two
//! nodes, over the length of the cell. (At an end of the edge all of the force belongs to the one
//! cell.)
//!
//! With ν = τ − 3/2, q = 1/(2 − τ), the seminorm |v|²_ν = ∬ (v(x) − v(y))² / |x − y|^(1+2ν) dx dy
//! over T × T, ‖v‖²_ν = ‖v‖₀² + |v|²_ν, and r h the distance of the further end of T from the
//! contact set, the rows of the table are
//!
//! ```text
//! depth × force       max |I u_N| ∫ |σ_N|
//! error × pressure    ‖I u_N − u_N‖₀ ‖σ_N‖₀
//! (3.9), θ = r        C_q h θ^(1−1/q) ‖σ_N‖_ν ‖u_N'‖_ν,           the first case, true for θ ≥ r
//! (3.14), θ = r       C_I γ_θ h^(2τ−2) |σ_N|_ν |u_N'|_ν,          the second case, true for θ ≤ r
//! (3.14), θ printed   the same with θ = h^(2τ−3), or r where that is smaller
//! one half            ½ h^(2τ−2) |σ_N|_ν |u_N'|_ν
//! κ                   κ h^(2τ−2) |σ_N|_ν |u_N'|_ν
//! ```
//!
//! each divided by the term. C_q is a bound in ‖v‖_(L^q) ≤ C_q ‖v‖_ν on (0, 1), 1 for τ ≤ 7/4; C_I
//! is the best constant in ‖v − I v‖₀ ≤ C_I |v'|_ν on (0, 1) (Lemma 6.1); γ_θ is that in ‖v‖₀ ≤ γ_θ
//! |v|_ν on (0, 1) for mean zero on (0, θ) (Lemma 5.2); κ is the best constant in the last row for
//! contact sets with one gap, at an end of T (example `theta_balance`). The ± is the change when k
//! is halved.
//!
//! Refuted if a bound is below the term: if term/bound, less its ±, is above 1. Refuted too if more
//! segments carry a term, above 1e-12 of the largest one, than the contact set has ends inside the
//! edge, which is one.
//! Undecided while a bound lies inside of an error bar.
//!
//! Longer segments, another regularity:
//!
//! `cargo run --release --example one_segment -- --n 8 --tau 1.6`

use example_report::prelude::*;
use fractional_sobolev::{
    Constraint, Domain, ErrorNorm, Gram, Mesh, embedding_bound, gamma, interpolation_constant,
};
use signorini::cone::Cone;
use signorini::contact::Solver;
use signorini::problems::TestProblem;
use signorini::proof::consistency_constant;
use std::fmt::Write as _;

example! { seconds "Sections 3 and 4, one segment",
    "the term of the segment in which contact ends, below all its bounds";
    /// segments of the contact edge
    n: usize = "16" in "[4, 24]",
    /// regularity τ in the bounds
    tau: f64 = "1.75" in "(1.5, 2)" slider "1.55 to 1.95",
}

/// Cells of a segment.
const CELLS: usize = 32;

/// The segment with the largest term, cut into k cells.
struct Segment {
    h: f64,
    /// u_N at the k + 1 nodes.
    u: Vec<f64>,
    /// −σ_N on the k cells.
    pressure: Vec<f64>,
    /// Number of the segment, from the left; how many segments carry a term; this term over the sum
    /// of all.
    place: usize,
    carry: usize,
    term: f64,
}

/// The term of every segment, and the segment with the largest one.
fn find(n: usize, k: usize) -> Result<Segment> {
    let solution = TestProblem::Block.problem(n * k)?.solve(Cone::Nodal, Solver::ActiveSet)?;
    let (u, force) = (&solution.normal_displacement, &solution.multiplier);
    let mut terms = Vec::new();
    for a in (0..n).map(|s| s * k) {
        let chord = |i: usize| u[a] + (i - a) as f64 / k as f64 * (u[a + k] - u[a]); // I u_N
        terms.push((a + 1..a + k).map(|i| -force[i] * chord(i)).sum::<f64>()); // 0 at the ends of T
    }
    let largest = terms.iter().copied().fold(0.0, f64::max);
    let place = terms.iter().position(|&term| term == largest).unwrap_or(0);
    let carry = terms.iter().filter(|&&term| term > 1e-12 * largest).count();
    let (a, cell) = (place * k, 1.0 / (n * k) as f64);
    let share = |i: usize| force[i] / cell * if i == 0 || i == n * k { 1.0 } else { 0.5 };
    let pressure = (a..a + k).map(|i| share(i) + share(i + 1)).collect();
    Ok(Segment {
        h: 1.0 / n as f64,
        u: u[a..=a + k].to_vec(),
        pressure,
        place,
        carry,
        term: largest,
    })
}

impl Segment {
    fn cells(&self) -> usize {
        self.pressure.len()
    }

    /// I u_N at place t of T, 0 ≤ t ≤ 1.
    fn chord(&self, t: f64) -> f64 {
        (1.0 - t) * self.u[0] + t * self.u[self.cells()]
    }

    /// The distance of the further end of T from the contact set, over h.
    fn r(&self) -> f64 {
        let touching: Vec<usize> = (0..=self.cells()).filter(|&i| self.u[i] >= 0.0).collect();
        let [Some(first), Some(last)] = [touching.first(), touching.last()] else { return 1.0 };
        (*first).max(self.cells() - last) as f64 / self.cells() as f64
    }

    /// All bounds of the term, in the order of the pages.
    fn bounds(&self, tau: f64) -> Result<Vec<Bound>> {
        let (k, h, nu, q) = (self.cells(), self.h, Order::half_plus(tau - 2.0)?, 1.0 / (2.0 - tau));
        let cell = h / k as f64;
        let slope: Vec<f64> = self.u.windows(2).map(|pair| (pair[1] - pair[0]) / cell).collect();
        // The matrix of |·|²_ν for functions that are constant on each cell, in closed form.
        let gram = Gram::constants(&Mesh::uniform(k, h)?, nu, Tolerance::balanced())?;
        let seminorm = |v: &[f64]| -> Result<f64> {
            Ok(gram.apply(v)?.iter().zip(v).map(|(y, x)| x * y).sum::<f64>().max(0.0).sqrt())
        };
        let norm = |v: &[f64]| (v.iter().map(|v| v * v).sum::<f64>() * cell).sqrt();
        let both = seminorm(&self.pressure)? * seminorm(&slope)?;
        let full = norm(&self.pressure).hypot(seminorm(&self.pressure)?)
            * norm(&slope).hypot(seminorm(&slope)?);
        // ‖I u_N − u_N‖₀: linear on each cell, e and f at its ends.
        let error = |i: usize| self.chord(i as f64 / k as f64) - self.u[i];
        let square = |e: f64, f: f64| (e * e + e * f + f * f) / 3.0;
        let interpolation =
            ((0..k).map(|i| square(error(i), error(i + 1))).sum::<f64>() * cell).sqrt();
        let force: f64 = self.pressure.iter().sum::<f64>() * cell;
        let depth = self.u[0].abs().max(self.u[k].abs());
        let printed = h.powf(2.0 * tau - 3.0);
        // C_I and γ_θ are roots of largest eigenvalues, of Legendre series and of functions whose
        // slopes are polynomials in ln r, r the distance to 0, θ and 1; C_q by Beckner's
        // inequality; κ the maximum over one length of a product of two linear functionals (example
        // `theta_balance`).
        // Their errors are added.
        let above = |constant: Estimate| constant.value + constant.error;
        let c_i =
            above(interpolation_constant(Domain::Interval(1.0), ErrorNorm::L2, nu, 1e-8)?.constant);
        let first = |theta: f64| -> Result<f64> {
            let c_q = embedding_bound(nu, q)?.upper.map_or(f64::NAN, above);
            Ok(c_q * h * theta.powf(1.0 - 1.0 / q) * full)
        };
        let second = |theta: f64| -> Result<f64> {
            let gamma = above(gamma(nu, Constraint::mean_zero_on(0.0..theta), 1e-6)?.constant);
            Ok(c_i * gamma * h.powf(2.0 * tau - 2.0) * both)
        };
        let kappa = above(consistency_constant(nu, 1e-9)?.best.constant);
        let bound = |key, name, value| Bound { key, name, value };
        let seminorms = h.powf(2.0 * tau - 2.0) * both;
        Ok(vec![
            bound("rectangle", "depth × force", depth * force),
            bound("product", "error × pressure", interpolation * norm(&self.pressure)),
            bound("first", "(3.9), θ = r", first(self.r())?),
            bound("second", "(3.14), θ = r", second(self.r())?),
            bound("second.printed", "(3.14), θ printed", second(printed.min(self.r()))?),
            bound("half", "one half", 0.5 * seminorms),
            bound("kappa", "κ", kappa * seminorms),
        ])
    }
}

/// A bound of the term.
struct Bound {
    /// The key under which pages quote it.
    key: &'static str,
    /// Its name in the table.
    name: &'static str,
    value: f64,
}

/// A bar of the drawing: a number over the term.
#[derive(Clone, Copy)]
struct Bar {
    name: &'static str,
    times: f64,
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    let (n, tau) = (options.n, options.tau);
    let [fine, coarse] = [find(n, CELLS)?, find(n, CELLS / 2)?];
    out.column("bound", "bound", "h^(2τ−2) |σ_N|_ν |u_N'|_ν times ½ and κ; ν = τ − 3/2");
    out.column("times", "bound/term", "±: half as many cells");
    out.check("segments that carry the term").at_most(fine.carry, 1.0, "ends of the contact set");
    let mut bars = vec![Bar { name: "the term", times: 1.0 }];
    for (bound, half) in fine.bounds(tau)?.into_iter().zip(coarse.bounds(tau)?) {
        let (times, with_half) = (bound.value / fine.term, half.value / coarse.term);
        let times = Measured::new(times, (times - with_half).abs());
        out.row(cells! { bound: bound.name => times });
        let claim = out.check("term/bound");
        claim.whole_error_bars_at_most(times.recip(), 1.0, "the proofs of Sections 3 and 4");
        out.note(format!("times.{}", bound.key), times.value);
        bars.push(Bar { name: bound.name, times: times.value });
    }
    out.note("term", fine.term);
    out.note("r", fine.r());
    out.note("theta", fine.h.powf(2.0 * tau - 3.0));
    out.note("place", (fine.place + 1) as f64);
    for page in 1..=8 {
        out.picture(&format!("one_segment_{page}"), drawing(&fine, &bars, page));
    }
    Ok(())
}

const BLUE: &str = "#0072b2";
const RED: &str = "#d55e00";
const GREEN: &str = "#009e73";

/// The drawing of one page of the course: T from x = 60 to x = 440, above it u_N, below it σ_N and
/// the product σ_N I u_N, at the right the bounds over the term on a logarithmic scale. Each page
/// adds to the one before.
fn drawing(segment: &Segment, bars: &[Bar], page: usize) -> String {
    let k = segment.cells();
    let x = |t: f64| 60.0 + 380.0 * t;
    let depth = segment.u.iter().fold(0.0, |m: f64, u| m.max(-u));
    let most = segment.pressure.iter().fold(0.0, |m: f64, p| m.max(*p));
    let chord = |i: usize| segment.chord(i as f64 / k as f64);
    let middle = |i: usize| segment.chord((i as f64 + 0.5) / k as f64);
    let products: Vec<f64> = (0..k).map(|i| -segment.pressure[i] * middle(i)).collect();
    let peak = products.iter().fold(f64::MIN_POSITIVE, |m: f64, p| m.max(*p));
    let (top, low, area) = (70.0, 215.0, 355.0); // u = 0, σ_N = 0, and the base of the product
    let down = |value: f64, largest: f64| 80.0 * value.abs() / largest;
    let mut svg = String::from(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" viewBox=\"0 0 640 380\" \
         width=\"640\" height=\"380\" \
         font-family=\"sans-serif\" font-size=\"15\">\n\
         <style>svg:root{color:#222;background:#fff}\
         @media(prefers-color-scheme:dark){svg:root{color:#ddd;background:#1b1b1b}}</style>\n",
    );
    let line = |svg: &mut String, points: &[(f64, f64)], style: &str| {
        let points: Vec<String> = points.iter().map(|(x, y)| format!("{x:.1},{y:.1}")).collect();
        let _ = writeln!(svg, "<polyline points=\"{}\" fill=\"none\" {style}/>", points.join(" "));
    };
    let filled = |svg: &mut String, points: &[(f64, f64)], colour: &str, opacity: f64| {
        let points: Vec<String> = points.iter().map(|(x, y)| format!("{x:.1},{y:.1}")).collect();
        let _ = writeln!(
            svg,
            "<polygon points=\"{}\" fill=\"{colour}\" fill-opacity=\"{opacity}\"/>",
            points.join(" ")
        );
    };
    let text = |svg: &mut String, (x, y): (f64, f64), anchor: &str, colour: &str, words: &str| {
        let _ = writeln!(
            svg,
            "<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\" \
             fill=\"{colour}\">{words}</text>"
        );
    };
    let sub = "<tspan dy=\"4\" font-size=\"75%\">N</tspan>";
    let end = 1.0 - segment.r();
    let thin = "stroke=\"currentColor\" stroke-width=\"1.2\" opacity=\"0.6\"";

    // Zones of Lemma 5.2, and of Figure 3.2 with θ = r.
    if page >= 6 {
        filled(
            &mut svg,
            &[
                (x(end), top - 22.0),
                (x(1.0), top - 22.0),
                (x(1.0), low + 82.0),
                (x(end), low + 82.0),
            ],
            RED,
            0.10,
        );
        text(
            &mut svg,
            (0.5 * (x(end) + x(1.0)), low + 60.0),
            "middle",
            RED,
            "no pressure: the zone, length rh",
        );
    }
    let u: Vec<_> =
        (0..=k).map(|i| (x(i as f64 / k as f64), top + down(segment.u[i], depth))).collect();
    let i_u: Vec<_> =
        (0..=k).map(|i| (x(i as f64 / k as f64), top + down(chord(i), depth))).collect();
    if page >= 4 {
        let between: Vec<_> = u.iter().copied().chain(i_u.iter().rev().copied()).collect();
        filled(&mut svg, &between, GREEN, 0.25);
        text(&mut svg, (x(0.42), top + 66.0), "middle", GREEN, "error of Iu");
    }
    line(&mut svg, &[(x(0.0), top), (x(1.0), top)], thin);
    line(&mut svg, &u, &format!("stroke=\"{BLUE}\" stroke-width=\"2.5\""));
    text(&mut svg, (50.0, top + 5.0), "end", "currentColor", "0");
    text(&mut svg, (x(1.0) - 4.0, top + 100.0), "end", BLUE, &format!("u{sub}"));
    for t in [0.0, 1.0] {
        line(
            &mut svg,
            &[(x(t), top - 6.0), (x(t), top + 6.0)],
            "stroke=\"currentColor\" stroke-width=\"1.5\"",
        );
    }
    let _ =
        writeln!(svg, "<circle cx=\"{:.1}\" cy=\"{top}\" r=\"4\" fill=\"currentColor\"/>", x(end));
    text(&mut svg, (x(0.5 * end), top - 10.0), "middle", "currentColor", "contact");
    text(&mut svg, (x(0.5 + 0.5 * end), top - 10.0), "middle", "currentColor", "gap");
    text(
        &mut svg,
        (x(0.0), 30.0),
        "start",
        "currentColor",
        &format!("segment T, number {} from the left", segment.place + 1),
    );
    if page >= 2 {
        let stairs: Vec<_> = (0..k)
            .flat_map(|i| {
                [i, i + 1].map(|j| (x(j as f64 / k as f64), low + down(segment.pressure[i], most)))
            })
            .collect();
        line(&mut svg, &[(x(0.0), low), (x(1.0), low)], thin);
        line(&mut svg, &stairs, &format!("stroke=\"{RED}\" stroke-width=\"2.5\""));
        text(&mut svg, (50.0, low + 5.0), "end", "currentColor", "0");
        text(&mut svg, (x(0.0) + 8.0, low + 28.0), "start", RED, &format!("σ{sub}"));
    }
    if page >= 3 {
        line(
            &mut svg,
            &i_u,
            &format!("stroke=\"{BLUE}\" stroke-width=\"2\" stroke-dasharray=\"6 4\""),
        );
        text(&mut svg, (x(0.10), top + 34.0), "middle", BLUE, "Iu");
        let mut shape = vec![(x(0.0), area)];
        shape.extend(
            (0..k).map(|i| (x((i as f64 + 0.5) / k as f64), area - 45.0 * products[i] / peak)),
        );
        shape.push((x(1.0), area));
        filled(&mut svg, &shape, "currentColor", 0.45);
        line(&mut svg, &[(x(0.0), area), (x(1.0), area)], thin);
        text(
            &mut svg,
            (x(end) + 12.0, area - 14.0),
            "start",
            "currentColor",
            &format!("area of σ{sub}<tspan dy=\"-4\"> </tspan>Iu: the term"),
        );
    }
    if page >= 5 {
        for [from, to] in [[0.0, segment.r()], [1.0, end]] {
            let y = top + if from == 0.0 { 112.0 } else { 124.0 };
            line(
                &mut svg,
                &[(x(from), y), (x(to), y)],
                &format!("stroke=\"{GREEN}\" stroke-width=\"3\""),
            );
        }
        text(&mut svg, (x(0.0) - 6.0, top + 122.0), "end", GREEN, "rh");
    }
    // The bars that the page has reached.
    let shown: &[usize] = match page {
        0..=2 => &[],
        3 => &[0],
        4 => &[0, 2],
        5 => &[0, 2, 1, 3],
        6 => &[0, 2, 1, 3, 4],
        7 => &[0, 2, 1, 3, 4, 5],
        _ => &[0, 2, 1, 3, 4, 5, 6, 7],
    };
    let largest = bars.iter().fold(1.0, |m: f64, bar| m.max(bar.times)).ln();
    if !shown.is_empty() {
        text(&mut svg, (465.0, 30.0), "start", "currentColor", "in units of the term");
    }
    for (row, &which) in shown.iter().enumerate() {
        let Bar { name, times } = bars[which];
        let y = 50.0 + 40.0 * row as f64;
        let width = 8.0 + 140.0 * times.ln() / largest;
        let colour = if which == 0 {
            "currentColor"
        } else if which >= 6 {
            BLUE
        } else {
            GREEN
        };
        text(&mut svg, (465.0, y), "start", colour, name);
        filled(
            &mut svg,
            &[
                (465.0, y + 5.0),
                (465.0 + width, y + 5.0),
                (465.0 + width, y + 17.0),
                (465.0, y + 17.0),
            ],
            colour,
            0.6,
        );
        let written = if times < 10.0 { format!("{times:.1}") } else { format!("{times:.0}") };
        text(&mut svg, (630.0, y), "end", colour, &written);
    }
    svg + "</svg>\n"
}
