//! What every example shares: how an outcome is decided, said, drawn and handed on.
//!
//! # How an example is written
//!
//! An example is one argument of the paper, in the order in which a reader thinks:
//!
//! 1. [`options!`] declares its parameters, each with one line of help; `--describe` hands them to the book;
//! 2. `compute(&Options) -> Result<Computed>` calls the library; `Computed` is plain numbers;
//! 3. `findings(&Options, &Computed) -> Vec<Finding>` says which comparisons decide;
//! 4. `table` and `draw` show the rows and the figures;
//! 5. `run(&Options) -> Result<Headline>` puts them together, and `main` is one line.
//!
//! A [`Finding`] is a sentence with the number, the bound and the source of the bound that decide it; the
//! verdict and the line "measured" follow from the findings and are written nowhere. Tests spoil `Computed`
//! and see findings, verdict and exit code turn.
//!
//! Exit codes: 0 every claim holds, 1 one is refuted or undecided, 2 bad input (one clear line on stderr).

mod command;
pub mod contact;
mod describe;
mod error;
mod expression;
pub mod figures;
mod files;
mod interval;
mod memory;
mod outcome;
mod output;
pub mod poincare;
mod progress;
pub mod rates;
mod seconds;
pub mod shown;

pub use command::{announce_memory, main};
pub use error::{Error, Result};
pub use expression::Expression;
pub use interval::{OnTheLine, increasing, within};
pub use outcome::{Cell, Column, Finding, Format, Headline, Outcome, Relation, Role, Table, Verdict};
pub use output::{Cost, HasOutput, Output};
pub use progress::progress;
pub use seconds::timed;

/// The options of an example: the given fields, the block of [`Output`], and defaults as on an empty command
/// line. Behind a colon stands its [`Cost`] where it is not a matter of seconds. What a value must be, of a list
/// each value, [`within`] says. `without_effect` lists options that are refused where they would be ignored;
/// `check` is a block that fails where options do not go together, `memory` says how many bytes a run takes,
/// about: all of this is asked before the first computation.
///
/// ```
/// example_frame::options! {
///     /// What the example does, in one line
///     pub struct Options {
///         /// Regularity, in (3/2, 2]
///         #[arg(long, default_value_t = 1.75, value_parser = example_frame::within::<f64>("(1.5, 2]"))]
///         pub tau: f64,
///         /// A fixed step instead of one that follows from tau
///         #[arg(long)]
///         pub step: Option<f64>,
///     }
///     without_effect(options) {
///         "tau" if options.step.is_some() => "beside --step",
///     }
///     memory(_options) {
///         1e6
///     }
/// }
/// assert_eq!(Options::default().tau, 1.75);
/// ```
#[macro_export]
macro_rules! options {
    (
        $(#[$about:meta])*
        pub struct $name:ident $(: $cost:ident)? {
            $($(#[$attribute:meta])* pub $field:ident: $kind:ty),* $(,)?
        }
        $(without_effect($options:ident) {
            $($option:literal if $ignored:expr => $when:literal),* $(,)?
        })?
        $(check($checked:ident) $check:block)?
        $(memory($sized:ident) $memory:block)?
    ) => {
        $(#[$about])*
        #[derive(Debug, Clone, clap::Parser)]
        pub struct $name {
            $($(#[$attribute])* pub $field: $kind,)*
            /// Where the outcome goes
            #[command(flatten)]
            pub output: $crate::Output,
        }

        impl Default for $name {
            fn default() -> Self {
                <Self as clap::Parser>::parse_from(["example"])
            }
        }

        impl $crate::HasOutput for $name {
            fn output(&self) -> &$crate::Output {
                &self.output
            }

            $(fn cost() -> $crate::Cost {
                $crate::Cost::$cost
            })?

            $(fn without_effect(&self) -> Vec<(&'static str, &'static str)> {
                let $options = self;
                let all = [$(($option, $ignored, $when)),*];
                all.into_iter().filter(|(_, ignored, _)| *ignored).map(|(o, _, w)| (o, w)).collect()
            })?

            $(fn check(&self) -> $crate::Result<()> {
                let $checked = self;
                $check
            })?

            $(fn memory(&self) -> f64 {
                let $sized = self;
                $memory
            })?
        }
    };
}
