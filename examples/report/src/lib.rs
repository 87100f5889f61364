//! Reports of the examples (rows, checks, pictures) and their options.
//!
//! An example is one file. [`example!`] declares label, statement and options; `run(&Options, &mut
//! Report)` is the loop. Table, checks, status, JSON, charts and the numbers that the book quotes
//! follow from what the loop reports, so that example, test, tour and book cannot disagree.
//!
//! The verbs of the loop:
//!
//! - `out.row(cells! { nu, theta => gamma, over_law: gamma / law })`: one row, parameters `=>`
//!   results.
//! - `out.check("no gamma exceeds its bound").at_most(value, bound, "where the bound comes from")`:
//!   a claim that must hold.
//! - `out.as_printed("(5.2) as theta -> 1")`: the paper's own form, which may fail; then the
//!   statement is false as printed.
//! - `out.stronger("order tau - 1")`: a stronger statement; if it holds, the paper's is loose.
//! - `out.not_sharp("growth is a square root less")`: a different rate of growth; if it holds, the
//!   paper's is not sharp.
//! - `out.observe("pre-asymptotic order")`: compared and shown; no effect on the status.
//! - `out.proof("every segment is in a case", "figure_3_2")`: true by proof, on that page of the
//!   book.
//! - `out.note("sharpness", value)`: a number to be quoted.
//! - `out.exponent("h", "error")`: the slope of logarithms between the last two rows that differ
//!   only in `h`.
//! - `out.plot(..)`, `out.bodies(..)`: SVG files in the directory given by `--out`.
//!
//! The comparisons say in their names what is asked. Between numbers without errors a check is true
//! or false:
//!
//! ```text
//! at_most(v, b)                    v ≤ b
//! at_least(v, b)                   v ≥ b
//! differ_by_at_most(v, b, t)       |v − b| ≤ t
//! holds(condition)                 the condition
//! ```
//!
//! Where v has an error u ([`Measured`], [`Estimate`](fractional_sobolev::Estimate)) or b an error
//! w, only the following verbs compile. They hold if all of the bar v ± u is on the right side of
//! all of the bar b ± w, fail if all of it is on the wrong side, and are undecided in between:
//!
//! ```text
//!                                               holds                     fails
//! whole_error_bars_at_most(v, b)                v + u ≤ b − w             v − u > b + w
//! whole_error_bars_at_least(v, b)               v − u ≥ b + w             v + u < b − w
//! whole_error_bars_differ_by_at_most(v, b, t)   |v − b| + u + w ≤ t       |v − b| − u − w > t
//! ```
//!
//! With `undecided_if_also_true_of(x)` before the comparison it is also undecided unless it fails
//! for x in place of v: a tolerance that does not rule out another plausible outcome decides
//! nothing. An x at the end of the tolerance is not ruled out.
//!
//! A check that is reported several times keeps its worst case: failed before undecided before
//! satisfied, and among equals the one that violates its bound most or satisfies it with the
//! smallest margin, errors included.
//!
//! `--help` of every example ends with this legend; the files of the examples do not repeat it.
//!
//! **Verdict** of a statement, from its checks alone: *fails* or *undecided* if a check that must
//! hold is, *open* if there is none with a number (exit code 1); else *false as printed*, *not
//! sharp*, *loose*, *true*.

/// Implements `From` for a type, by a function of each of these types.
macro_rules! conversions {
    ($target:ty: $($kind:ty => $make:expr),* $(,)?) => {
        $(impl From<$kind> for $target {
            fn from(value: $kind) -> Self {
                $make(value)
            }
        })*
    };
}

mod cell;
mod check;
mod command;
mod error;
mod expression;
mod figures;
mod files;
mod hats;
mod measured;
mod options;
mod outcome;
mod report;
mod shown;
mod words;

pub use cell::{Cell, Cells};
pub use check::{Checked, Claim, Decision, Role, WithoutError};
pub use command::main;
pub use error::{Error, Result};
pub use expression::Expression;
pub use figures::{Axes, Plot, floor_names};
pub use hats::{
    constrained_minimiser, harmonic_energy, largest_eigenvalue, mass_matrix, mean_zero_basis,
};
pub use measured::{
    Measured, exponent_between, exponent_of, largest, order_of_increments, order_of_squares,
    smallest,
};
pub use options::{Declarations, Declared, OptionValue, read_option};
pub use outcome::{Outcome, Verdict};
pub use report::Report;

/// The items that examples use.
pub mod prelude {
    pub use crate::{
        Axes, Error, Measured, Report, Result, cells, constrained_minimiser, example,
        exponent_between, exponent_of, harmonic_energy, largest, largest_eigenvalue, mass_matrix,
        mean_zero_basis, order_of_increments, order_of_squares, smallest,
    };
    pub use fractional_sobolev::{Estimate, Order, Tolerance};
}

/// Declares an example: how long it takes (`quick`: below a second, `seconds`, `long`), label,
/// statement, options. Each option has one line of help, a type, a default, and where a number is
/// bounded its interval and the ends of the slider of the book's page. Makes `Options`,
/// `outcome(&Options)` and `main`, which call `run(&Options, &mut Report) -> Result<T>` of the
/// file; T is `()`, or the few numbers for which another program runs the example.
///
/// ```
/// use example_report::prelude::*;
/// example! { quick "Lemma 0", "x² ≤ 1 for x in [0, 1]";
///     /// places x
///     x: Vec<f64> = "0,0.5,1" in "[0, 1]" slider "0.1 to 1",
/// }
/// fn run(options: &Options, out: &mut Report) -> Result<()> {
///     for &x in &options.x {
///         out.row(cells! { x => square: x * x });
///         out.check("no square exceeds 1").at_most(x * x, 1.0, "x ≤ 1");
///     }
///     Ok(())
/// }
/// assert_eq!(outcome(&Options::default()).unwrap().status().to_string(), "true");
/// ```
#[macro_export]
macro_rules! example {
    ($cost:ident $label:literal, $statement:literal;
        $($(#[doc = $help:literal])+ $field:ident: $kind:ty = $default:literal
            $(in $range:literal)? $(slider $slider:literal)?),* $(,)?
    ) => {
        /// The options of this example.
        #[derive(Debug, Clone)]
        pub struct Options {
            $($(#[doc = $help])+ pub $field: $kind,)*
        }

        impl $crate::Declarations for Options {
            const LABEL: &'static str = $label;
            const STATEMENT: &'static str = $statement;
            const COST: &'static str = stringify!($cost);

            fn declared() -> Vec<$crate::Declared> {
                vec![$($crate::Declared::of::<$kind>([
                    stringify!($field),
                    concat!($($help),+),
                    $default,
                    concat!($($range)?),
                    concat!($($slider)?)
                ])),*]
            }

            fn read(given: &dyn Fn(&str, &str) -> String) -> $crate::Result<Self> {
                let _ = given;
                Ok(Self { $($field: {
                    let name = stringify!($field);
                    let value = given(name, $default);
                    $crate::read_option(name, &value, $default, concat!($($range)?))?
                },)* })
            }
        }

        impl Default for Options {
            fn default() -> Self {
                $crate::Declarations::read(&|_, default| default.to_owned())
                    .expect("a default is admissible")
            }
        }

        /// Runs the example and returns its outcome.
        pub fn outcome(options: &Options) -> $crate::Result<$crate::Outcome> {
            let mut out = $crate::Report::of::<Options>();
            run(options, &mut out)?;
            Ok(out.close())
        }

        fn main() -> std::process::ExitCode {
            $crate::main::<Options, _>(run)
        }
    };
    ($cost:ident $label:literal, $statement:literal) => {
        $crate::example! { $cost $label, $statement; }
    };
}

/// Cells of a row: parameters, `=>`, results. `name` alone stands for `name: name`.
///
/// ```
/// use example_report::{Cells, cells};
/// let (nu, gamma) = (0.25, 0.9);
/// let row: Cells = cells! { nu => gamma, over_bound: gamma / 2.0 };
/// assert_eq!(row.key(), "nu0.25");
/// ```
#[macro_export]
macro_rules! cells {
    ($($key:ident $(: $about:expr)?),* => $($name:ident $(: $value:expr)?),* $(,)?) => {
        $crate::Cells::new(
            vec![$((stringify!($key), $crate::Cell::from($crate::cells!(@ $key $($about)?)))),*],
            vec![$((stringify!($name), $crate::Cell::from($crate::cells!(@ $name $($value)?)))),*],
        )
    };
    (@ $name:ident) => { $name };
    (@ $name:ident $value:expr) => { $value };
}
