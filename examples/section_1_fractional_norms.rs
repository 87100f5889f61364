//! Section 1, (1.1): norms of fractional order, and where they become infinite.
//!
//! For 0 < ν < 1 the norm of H^ν(0, 1) is ‖u‖²_ν = ‖u‖₀² + |u|²_ν with the seminorm of Slobodeckij,
//!
//! ```text
//! |u|²_ν = ∫₀¹∫₀¹ (u(x) − u(y))² / |x − y|^(1+2ν) dx dy
//!        = 2 ∫₀¹ t^(−1−2ν) ∫₀^(1−t) (u(x+t) − u(x))² dx dt.
//! ```
//!
//! It is finite for x^a if ν < a + 1/2, for a step if ν < 1/2, for |ln x|^(1/4) if ν ≤ 1/2, for a
//! hat always. Closed forms:
//!
//! ```text
//! x^a:  2/(2a+1−2ν) ∫₀¹ (1 − s^a)² (1 − s)^(−1−2ν) ds, by y = s x: Beta functions
//! |ln x|^a, ν = 1/2:  2 ζ(1 + 2a) (Γ(1 + a)²/cos(πa) − Γ(1 + 2a))
//! step between intervals of lengths p and q:  (p^(1−2ν) + q^(1−2ν) − (p+q)^(1−2ν)) / (ν (1 − 2ν))
//! hat, 1 at 1/2:  8 (4^ν (1 − ν) − 1) / (ν (1 − 2ν)(2 − 2ν)(3 − 2ν)),  8 (1 − ln 2) for ν = 1/2
//! ```
//!
//! What is compared is the seminorm |u|_ν; the norm ‖u‖_ν in the table is shown. Refuted if the
//! library takes a finite seminorm for infinite or an infinite one for finite, if a finite one is
//! further from its closed form than asked, or than the larger one of the error that it states and
//! twice that of the closed form, or, for ν at least 0.1 below the last finite order, if the second
//! formula above, by a composite Gauss rule, is off by 0.5 %: what it leaves out decays slowly near
//! that order. Undecided while a bound lies inside of an error bar.
//!
//! `cargo run --release --example section_1_fractional_norms -- --power 0.3 --nu 0.7,0.79,0.8`

use example_report::prelude::*;
use fractional_sobolev::{Error::InfiniteNorm, Function, closed_forms, gauss_legendre};

example! { seconds "Section 1, (1.1)",
    "‖u‖²_ν = ‖u‖₀² + |u|²_ν: finite or infinite as it should be, and to the tolerance asked";
    /// exponents a of the powers x^a
    power: Vec<f64> = "0.6,-0.2" in "(-0.5, 100]" slider "-0.45 to 1",
    /// orders ν
    nu: Vec<Order> = "0.25,0.45,1/2,0.75" in "(0, 1)" slider "0.02 to 0.98",
    /// relative tolerance
    tolerance: Tolerance = "1e-9",
}

/// A function: its name, its values, its breakpoints, the order up to which (`true`: included) its
/// norm is finite, and the square of its seminorm in closed form where one is known.
struct Example {
    name: String,
    u: Box<dyn Fn(f64) -> f64 + Sync>,
    breaks: Vec<f64>,
    limit: (f64, bool),
    exact: Box<dyn Fn(Order) -> Option<Estimate>>,
}

fn functions(powers: &[f64]) -> Vec<Example> {
    let power = |&a: &f64| Example {
        name: format!("x^{a}"),
        u: Box::new(move |x| x.powf(a)),
        breaks: vec![0.0, 1.0],
        limit: (if a == 0.0 { 1.0 } else { a + 0.5 }, false),
        exact: Box::new(move |nu| closed_forms::power_seminorm_squared(a, nu).ok()),
    };
    let mut all: Vec<Example> = powers.iter().map(power).collect();
    all.push(Example {
        name: "step at 0.4".to_owned(),
        u: Box::new(|x| if x < 0.4 { 0.0 } else { 1.0 }),
        breaks: vec![0.0, 0.4, 1.0],
        limit: (0.5, false),
        exact: Box::new(|nu| closed_forms::jump_seminorm_squared(0.4, 0.6, nu).ok()),
    });
    all.push(Example {
        name: "hat".to_owned(),
        u: Box::new(|x| 1.0 - (2.0 * x - 1.0).abs()),
        breaks: vec![0.0, 0.5, 1.0],
        limit: (1.0, false),
        exact: Box::new(|nu| closed_forms::hat_seminorm_squared(0.0, 0.5, 0.5, 0.0, nu).ok()),
    });
    all.push(Example {
        name: "|ln x|^(1/4)".to_owned(),
        u: Box::new(|x| (-x.ln()).powf(0.25)),
        breaks: vec![0.0, 1.0],
        limit: (0.5, true),
        exact: Box::new(|nu| {
            if nu == Order::HALF {
                closed_forms::log_power_seminorm_squared(0.25).ok()
            } else {
                None
            }
        }),
    });
    all
}

/// The root of 2 ∫₀¹ t^(−1−2ν) ∫₀^(1−t) (u(x + t) − u(x))² dx dt, both integrals by four Gauss
/// points on pieces that halve towards every place where u(x) or u(x + t) is not smooth; what is
/// below the last piece, t < 2^-60, is left out.
fn by_definition(example: &Example, nu: Order) -> Result<f64> {
    let gauss = gauss_legendre(4)?;
    let on =
        |a: f64, b: f64, f: &dyn Fn(f64) -> f64| gauss.integrate(|s| f(a + s * (b - a))) * (b - a);
    let mut total = 0.0;
    for halving in 0..60 {
        let t_end = 0.5f64.powi(halving);
        total += on(0.5 * t_end, t_end, &|t| {
            let mut cuts: Vec<f64> = example.breaks.iter().flat_map(|&b| [b, b - t]).collect();
            cuts.retain(|&x| (0.0..=1.0 - t).contains(&x));
            cuts.sort_by(f64::total_cmp);
            let square = |x: f64| ((example.u)(x + t) - (example.u)(x)).powi(2);
            let mut inner = 0.0;
            for pair in cuts.windows(2) {
                let half = 0.5 * (pair[1] - pair[0]);
                for k in 0..20 + halving {
                    let (near, far) = (half * 0.5f64.powi(k + 1), half * 0.5f64.powi(k));
                    inner += on(pair[0] + near, pair[0] + far, &square)
                        + on(pair[1] - far, pair[1] - near, &square);
                }
            }
            2.0 * inner * t.powf(-1.0 - 2.0 * nu.value())
        });
    }
    Ok(total.sqrt())
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    let are_powers = options.power.iter().all(|a| a.abs() >= 1e-100);
    Error::unless(are_powers, "power", "nearer to 0 than 1e-100, where x^a is a constant")?;
    for example in functions(&options.power) {
        for &nu in &options.nu {
            // Near a breakpoint b: ∫ ℓ(t) dt, t = −ln|x − b|, ℓ the integral over the quotient of
            // both distances from b. Gauss rules on cells in t until the rest, bounded by the decay
            // of ℓ, is below the tolerance; where the power of e^(−t), fitted to the last half of
            // the cells, grows, or where it is zero and that of t is above −1, the norm is
            // infinite. The error is the change with the order of the rules, and the rest.
            let u = Function::from_fn(&example.breaks, &example.u)?;
            let found = u.seminorm(nu, options.tolerance);
            let (last, is_included) = example.limit;
            let is_finite = nu.value() < last || (nu.value() == last && is_included);
            let said = "finite norms called infinite or vice versa";
            let seminorm = match found {
                Err(InfiniteNorm { .. }) => {
                    out.row(cells! { function: example.name.clone(), nu => seminorm: "infinite" });
                    out.check(said).holds(!is_finite, "known limits of ν");
                    continue;
                }
                found => found?,
            };
            out.check(said).holds(is_finite, "known limits of ν");
            let exact = (example.exact)(nu).map(|squared| Measured::from(squared).sqrt());
            let true_error =
                exact.map(|exact| (Measured::from(seminorm.value) / exact - 1.0).abs());
            let definition = by_definition(&example, nu)?;
            let norm = u.norm(nu, options.tolerance)?;
            out.row(cells! { function: example.name.clone(), nu => seminorm, definition,
            norm: norm.value, true_error: true_error.map(|error| error.value) });
            if let (Some(error), Some(exact)) = (true_error, exact) {
                let asked = options.tolerance.relative();
                let claim = out.check("relative difference from the closed form");
                claim.whole_error_bars_at_most(error, asked, "the tolerance");
                // The closed form has an error too: a smaller stated one cannot be tested by it.
                let stated = seminorm.error.max(2.0 * exact.error);
                let share = (Measured::from(seminorm.value) - exact).abs() / stated;
                let claim = out.check("true error/stated error");
                claim.whole_error_bars_at_most(share, 1.0, "error estimate");
            }
            // Nearer to the last finite order what the definition leaves out decays too slowly.
            if nu.value() <= last - 0.1 {
                let ratio = definition / seminorm.value;
                let claim = out.check("|u|_ν: by_definition/library");
                claim.differ_by_at_most(ratio, 1.0, 5e-3, "composite Gauss rule");
            }
        }
    }
    out.column("definition", "by definition", "");
    out.column("norm", "‖u‖_ν", "");
    out.column("seminorm", "|u|_ν", "");
    out.plot("section_1_fractional_norms", "Seminorms of order ν", Axes::LinearLog("ν", "|u|_ν"))
        .curve_by("function", "nu", "seminorm");
    Ok(())
}
