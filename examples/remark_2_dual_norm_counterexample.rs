//! Remark 2: ‖u − I^h u‖ in the dual norm of H^{1/2} is no better than h^{3/2} for u ∈ H^{3/2}: Falk's route
//! ends at h^{3/4}.
//!
//! A wave per element is aliased to a constant. For comparison a smooth function: its dual norm is of order
//! h².

use example_frame::figures::{Axis, Chart, Series as Line};
use example_frame::{Column, Error, Finding, Format, Headline, Result, Table};
use experiments::EstimateExt;
use experiments::interpolation::{AliasedWave, all_waves_rate, smooth_dual_error};
use fractional_sobolev::{Domain, ErrorNorm, Estimate, Order, Tolerance, Work, interpolation_constant};
use signorini::rates::ConvergenceOrder;
use std::process::ExitCode;

/// Distance of a measured exponent from the theoretical one that counts as agreement.
const EXPONENT_TOLERANCE: f64 = 0.02;
/// Half the limit 1/(√8 π²) of the wave's error over h^{3/2}, over C_L2(1/2) = 0.0927.
const HALF_LIMIT: f64 = 0.193;
/// One function for all meshes is measured between 2^-170 and 2^-340, its waves falling like (1+j)^-0.6.
const ALL_WAVES: (usize, f64) = (170, 0.6);

example_frame::options! {
    /// The interpolation error in the dual norm of H^(1/2): a family at h^(3/2), a smooth function at h^2
    pub struct Options: Quick {
        /// Elements of the coarsest mesh
        #[arg(long, default_value_t = 16)]
        pub elements: usize,
        /// Meshes, each with twice the elements of the one before
        #[arg(long, default_value_t = 5)]
        pub meshes: usize,
    }
}

/// Errors on every mesh, coarsest first, and their exponents of h from each mesh to the next.
pub struct Series {
    /// ‖u − I^h u‖_{1/2,*}, of the wave over ‖u‖_{3/2}.
    pub errors: Vec<Estimate>,
    /// None on the first mesh.
    pub rates: Vec<Option<ConvergenceOrder>>,
}

/// What is computed.
pub struct Computed {
    /// Equal elements of (0, 1).
    pub elements: Vec<usize>,
    /// The wave of each mesh.
    pub wave: Series,
    /// One smooth function.
    pub smooth: Series,
    /// C_L2(1/2) h^{3/2}, which no function can exceed.
    pub bounds: Vec<Estimate>,
    /// Exponent of h of one function for all meshes, from a lower bound of its error.
    pub one: Estimate,
}

/// The errors of the wave of each mesh, of a smooth function, and of one function for all meshes.
pub fn compute(options: &Options) -> Result<Computed> {
    let (count, first) = (options.meshes, options.elements);
    if !(2..=20).contains(&count) || first == 0 || first > 1024 >> (count - 1) {
        return Err(Error::Option("2 to 20 meshes of 1 to 1024 elements".into()));
    }
    let elements: Vec<usize> = (0..count).map(|k| first << k).collect();
    let series = |error: fn(usize) -> fractional_sobolev::Result<Estimate>| {
        let meshes: Vec<_> =
            elements.iter().map(|&n| Ok((1.0 / n as f64, error(n)?))).collect::<Result<_>>()?;
        Result::Ok(Series {
            errors: meshes.iter().map(|mesh| mesh.1).collect(),
            rates: (1..=meshes.len()).map(|k| ConvergenceOrder::of_last(&meshes[..k])).collect(),
        })
    };
    let wave = series(|n| AliasedWave::new(n)?.quotient())?;
    let (smooth, one) = (series(smooth_dual_error)?, all_waves_rate(ALL_WAVES.0, ALL_WAVES.1)?);
    let best =
        interpolation_constant(Domain::Interval(1.0), ErrorNorm::L2, Order::HALF, Tolerance::balanced())?;
    let best = best.constant;
    let bounds = elements.iter().map(|&n| Ok(best.times((n as f64).powf(-1.5))?)).collect::<Result<_>>()?;
    Ok(Computed { elements, wave, smooth, bounds, one })
}

/// What decides: the exponents of the wave and of the one function, and the bound of all functions.
pub fn findings(_: &Options, computed: &Computed) -> Vec<Finding> {
    let Computed { wave, smooth, bounds, one, .. } = computed;
    let estimate = |o: ConvergenceOrder| Estimate::new(o.order, o.uncertainty, Work::default()).ok();
    let last = |series: &Series| series.rates.last().copied().flatten().and_then(estimate);
    let shares = || wave.errors.iter().zip(bounds).filter_map(|(error, bound)| error.over(*bound).ok());
    let within = |finding: Finding, rate: Option<Estimate>, theory: f64, source: &str| {
        finding.largest(rate).within(EXPONENT_TOLERANCE, theory, source).told()
    };
    let half = last(wave).and_then(|rate| rate.times(0.5).ok());
    let each = Finding::claim("wave", "h^{value} for the wave of each mesh");
    let falk = Finding::remark("falk", "h^{value} is left of it by the square root of Falk's lemma");
    let all = Finding::claim("one.function", "at best h^{value} for one function on all meshes");
    vec![
        within(each, last(wave), 1.5, "h^(3/2), Remark 2"),
        Finding::claim("bound", "no wave passes the bound of all functions, at most {percent} % of it")
            .largest(shares())
            .at_most(1.0, "C_L2(1/2) h^(3/2), Lemma 6.2"),
        Finding::claim("constant", "on every mesh the wave keeps at least {percent} % of that bound")
            .smallest(shares())
            .at_least(HALF_LIMIT, "half the limit 1/(sqrt 8 pi^2) of the wave, over C_L2(1/2)"),
        within(all, Some(*one), 1.5, "h^(3/2), Remark 2"),
        within(falk, half, 0.75, "half of 3/2"),
        within(Finding::remark("smooth", "h^{value} for a smooth function"), last(smooth), 2.0, "two orders"),
    ]
}

/// Measures both exponents.
pub fn run(options: &Options) -> Result<Headline> {
    let computed = compute(options)?;
    let claim = "|u_N - I^h u_N| in the dual norm of H^(1/2) is no better than h^(3/2) for u_N in H^(3/2)";
    let mut headline = Headline::new("Remark 2", claim, table(&computed), findings(options, &computed));
    for (key, name) in [("wave", "wave"), ("smooth", "smooth"), ("one.function", "one_function")] {
        headline.quote_found(key, format!("remark_2.{name}_rate"));
    }
    headline.draw(&options.output, "remark_2_dual_norm_counterexample", || Ok(draw(&computed)))?;
    Ok(headline)
}

fn table(computed: &Computed) -> Table {
    let (error, rate) = (Format::Scientific(4), Format::Fixed(4));
    let change = "3.5 times the change from the rate before, and the errors of the norms";
    Table::new(vec![
        Column::new("elements", "elements", Format::Plain, ""),
        Column::new("wave", "wave", error, "|u - Iu|_(1/2,*) / |u|_(3/2), u = cos(2 pi x/h) - 1"),
        Column::new("wave_rate", "wave rate", rate, "observed exponent of the wave, theory 3/2"),
        Column::new("wave_rate_error", "+-", Format::Scientific(0), change),
        Column::new("falk", "Falk", rate, "half of it: the rate left for |u - u^h|_1"),
        Column::new("bound", "bound", error, "C_L2(1/2) h^(3/2), which no u can exceed"),
        Column::new("smooth", "smooth", error, "|u - Iu|_(1/2,*), u = -exp(x)"),
        Column::new("smooth_rate", "smooth rate", rate, "observed exponent of the smooth u, theory 2"),
        Column::new("smooth_rate_error", "+-", Format::Scientific(0), change),
    ])
    .with_rows((0..computed.elements.len()).map(|k| {
        let columns = |series: &Series| {
            let rate = series.rates[k];
            [Some(series.errors[k].value), rate.map(|r| r.order), rate.map(|r| r.uncertainty)]
        };
        let (wave, elements) = (columns(&computed.wave), computed.elements[k] as f64);
        let middle = [wave[1].map(|rate| 0.5 * rate), Some(computed.bounds[k].value)];
        [[Some(elements)].as_slice(), &wave, &middle, &columns(&computed.smooth)].concat()
    }))
}

fn draw(computed: &Computed) -> Chart {
    let points = |errors: &[Estimate]| -> Vec<(f64, f64)> {
        computed.elements.iter().zip(errors).map(|(&n, error)| (1.0 / n as f64, error.value)).collect()
    };
    let x = Axis::logarithmic("h, length of an element (interval = 1)");
    Chart::new(
        "Remark 2: aliasing in a dual norm",
        x,
        Axis::logarithmic("|u - Iu| in the dual norm of H^(1/2)"),
    )
    .with(Line::dashed("bound C h^(3/2)", points(&computed.bounds)))
    .with(Line::line_and_points("one wave per element, over |u|_(3/2)", points(&computed.wave.errors)))
    .with(Line::line_and_points("u = -exp(x)", points(&computed.smooth.errors)))
}

fn main() -> ExitCode {
    example_frame::main(run)
}
