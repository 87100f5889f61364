//! `--describe`: an example says what may be asked of it, so that a page can offer fields and sliders.
//!
//! What an option is follows from its type, as declared once in [`options!`](crate::options). How far a
//! slider moves follows from the name: a name means the same in all examples. Options of a type that is not
//! listed here, files and free text among them, are not offered.

use crate::HasOutput;
use clap::{Arg, ArgAction, Args, Command, Parser};
use experiments::gallery::GalleryFunction;
use experiments::interpolation::SampleSlope;
use experiments::zones::{Condition, Place};
use fractional_sobolev::{Order, Tolerance};
use serde_json::{Value, json};
use std::any::TypeId;

/// What a value of an option is.
#[derive(Debug, Clone, PartialEq)]
enum Kind {
    /// Given or not.
    Flag,
    /// A finite number.
    Number,
    /// A natural number.
    Integer,
    /// An order in (0, 1), `1/2` and `1/2+offset` included.
    Order,
    /// fast, balanced, reference or a number.
    Tolerance,
    /// COARSEST-FINEST.
    Levels,
    /// One of these words.
    Choice(Vec<String>),
    /// One of these words, numbers behind colons: `cantor:0.3:20`.
    Named(Vec<String>),
    /// One of these words, or a number.
    Place(Vec<String>),
}

impl Kind {
    fn word(&self) -> &'static str {
        match self {
            Kind::Flag => "flag",
            Kind::Number => "number",
            Kind::Integer => "integer",
            Kind::Order => "order",
            Kind::Tolerance => "tolerance",
            Kind::Levels => "levels",
            Kind::Choice(_) => "choice",
            Kind::Named(_) => "named",
            Kind::Place(_) => "place",
        }
    }

    fn choices(&self) -> &[String] {
        match self {
            Kind::Choice(words) | Kind::Named(words) | Kind::Place(words) => words,
            _ => &[],
        }
    }
}

/// Ends of a slider, and whether it moves by factors.
struct Slider {
    ends: [f64; 2],
    by_factors: bool,
}

/// The vocabulary of numbers: name, admissible range, ends of the slider, `true` where it moves by factors.
/// The example itself may refuse more.
const NUMBERS: [(&str, [f64; 2], [f64; 2], bool); 34] = [
    ("alpha", [0.0, 10.0], [0.05, 2.0], false),
    ("angle", [20.0, 360.0], [70.0, 160.0], false),
    ("angles", [1.0, 1e3], [2.0, 24.0], false),
    ("at", [0.0, 1.0], [0.0, 1.0], false),
    ("depth", [1.0, 24.0], [13.0, 20.0], false),
    ("elements", [1.0, 1048576.0], [1.0, 1024.0], true),
    ("finest", [4.0, 11.0], [4.0, 8.0], false),
    ("functions", [1.0, 1e5], [10.0, 1e3], true),
    ("halvings", [4.0, 40.0], [4.0, 20.0], false),
    ("lambda", [0.0, 1e6], [0.1, 1e3], true),
    ("levels", [1.0, 12.0], [1.0, 7.0], false),
    ("load_scale", [-1e9, 1e9], [0.1, 10.0], true),
    ("log", [0.0, 1e300], [4.0, 1e4], true),
    ("meshes", [1.0, 12.0], [1.0, 6.0], false),
    ("mu", [0.0, 1e6], [0.1, 1e3], true),
    ("n", [1.0, 4096.0], [4.0, 128.0], true),
    ("nu", [0.0, 1.0], [0.02, 0.98], false),
    ("omega", [0.0, 360.0], [30.0, 360.0], false),
    ("pair", [0.0, 1.0], [0.02, 0.98], false),
    ("point", [0.0, 1.0], [0.0, 1.0], false),
    ("poisson", [-1.0, 0.5], [-0.5, 0.49], false),
    ("positions", [1.0, 99.0], [1.0, 9.0], false),
    ("q", [1.0, 1e4], [2.0, 200.0], true),
    ("r", [0.0, 10.0], [0.1, 4.0], false),
    ("repeat", [1.0, 100.0], [1.0, 9.0], false),
    ("s", [0.0, 1.0], [0.02, 0.98], false),
    ("scene_tau", [1.5, 2.5], [1.52, 2.0], false),
    ("seed", [0.0, 1e9], [1.0, 100.0], false),
    ("smallest", [0.0, 1.0], [1e-80, 1e-2], true),
    ("squares", [1.0, 40.0], [1.0, 10.0], false),
    ("steps", [1.0, 20.0], [1.0, 9.0], false),
    ("tau", [1.5, 2.5], [1.52, 2.0], false),
    ("theta", [0.0, 1.0], [1e-6, 0.9], true),
    ("zones", [1.0, 1e4], [10.0, 1e3], true),
];

/// The description of an example with these options, as JSON: `about`, `cost`, `options`.
pub(crate) fn describe<O: Parser + HasOutput>() -> Value {
    let command = O::command();
    let output = crate::Output::augment_args(Command::new("output"));
    let is_output = |argument: &Arg| output.get_arguments().any(|known| known.get_id() == argument.get_id());
    let options: Vec<Value> =
        command.get_arguments().filter(|argument| !is_output(argument)).filter_map(option).collect();
    let about = command.get_about().map(ToString::to_string).unwrap_or_default();
    json!({"about": about, "cost": O::cost().word(), "options": options})
}

/// One option; `None` where it is not offered.
fn option(argument: &Arg) -> Option<Value> {
    let kind = kind(argument)?;
    let name = argument.get_long()?;
    let default: Vec<_> = argument.get_default_values().iter().map(|v| v.to_string_lossy()).collect();
    let is_list = argument.get_value_delimiter().is_some();
    let mut option = json!({
        "name": name,
        "help": argument.get_help().map(ToString::to_string).unwrap_or_default(),
        "kind": kind.word(),
        "list": is_list,
        "default": default.join(","),
    });
    if !kind.choices().is_empty() {
        option["choices"] = json!(kind.choices());
    }
    let numbers = NUMBERS.iter().find(|(known, ..)| *known == argument.get_id().as_str());
    if let Some(&(_, range, ends, by_factors)) = numbers
        && matches!(kind, Kind::Number | Kind::Integer | Kind::Order)
    {
        option["range"] = json!(range);
        let slider = Slider { ends, by_factors };
        option["slider"] = json!(slider.ends);
        option["scale"] = json!(if slider.by_factors { "factors" } else { "steps" });
    }
    Some(option)
}

/// What the type of an option says; `None` for types that are not offered.
fn kind(argument: &Arg) -> Option<Kind> {
    if matches!(argument.get_action(), ArgAction::SetTrue) {
        return Some(Kind::Flag);
    }
    let id = argument.get_value_parser().type_id();
    let words = |words: &[&str]| words.iter().map(|word| (*word).to_owned()).collect();
    let known = [
        (TypeId::of::<f64>(), Kind::Number),
        (TypeId::of::<u32>(), Kind::Integer),
        (TypeId::of::<u64>(), Kind::Integer),
        (TypeId::of::<usize>(), Kind::Integer),
        (TypeId::of::<Order>(), Kind::Order),
        (TypeId::of::<Tolerance>(), Kind::Tolerance),
        (TypeId::of::<Condition>(), Kind::Choice(words(&["mean-zero", "vanishing"]))),
        (TypeId::of::<Place>(), Kind::Place(words(&["end", "centre"]))),
        (TypeId::of::<GalleryFunction>(), Kind::Named(words(&["power", "step", "hat", "log"]))),
        (TypeId::of::<SampleSlope>(), Kind::Named(words(&["power", "step", "cosine", "constant"]))),
    ];
    let found = known.into_iter().find(|(known, _)| id == *known).map(|(_, kind)| kind);
    found.or_else(|| contact(|known| id == known))
}

/// Types of the contact rooms.
fn contact(is: impl Fn(TypeId) -> bool) -> Option<Kind> {
    use experiments::convergence::Levels;
    use experiments::proof::{Against, Resolution};
    use signorini::cone::Cone;
    use signorini::contact::Solver;
    use signorini::problems::{NamedProblem, StripData, TestProblem};
    use signorini::singular::SideConditions;
    use signorini::strip::{Reference, StripKind};
    let words = |words: &[&str]| words.iter().map(|word| (*word).to_owned()).collect();
    // A scene that needs the name of a file has no default and is not read from its bare name.
    let is_whole = |name: &&str| name.parse::<StripData>().is_ok();
    let strip: Vec<&str> = StripData::all().iter().map(StripData::name).filter(is_whole).collect();
    let mesh: Vec<&str> = TestProblem::all().iter().map(TestProblem::name).collect();
    let known = [
        (TypeId::of::<Cone>(), Kind::Choice(Cone::ALL.map(|cone| cone.to_string()).into())),
        (TypeId::of::<StripKind>(), Kind::Choice(words(&["scalar", "elastic"]))),
        (TypeId::of::<Reference>(), Kind::Choice(words(&["nested", "harmonic"]))),
        (TypeId::of::<Against>(), Kind::Choice(words(&["reference", "itself"]))),
        (
            TypeId::of::<Solver>(),
            Kind::Choice(words(&[
                "active-set",
                "interior-point",
                "edge-interior-point",
                "multigrid",
                "auto",
            ])),
        ),
        (
            TypeId::of::<SideConditions>(),
            Kind::Choice(SideConditions::ALL.map(|sides| sides.to_string()).into()),
        ),
        (TypeId::of::<Levels>(), Kind::Levels),
        (TypeId::of::<Resolution>(), Kind::Named(words(&["segment", "edge"]))),
        (TypeId::of::<TestProblem>(), Kind::Named(words(&mesh))),
        (TypeId::of::<StripData>(), Kind::Named(words(&strip))),
        (TypeId::of::<NamedProblem>(), Kind::Named(words(&[mesh, strip].concat()))),
    ];
    known.into_iter().find(|(known, _)| is(*known)).map(|(_, kind)| kind)
}

#[cfg(test)]
mod tests {
    use super::*;
    use experiments::convergence::Levels;
    use signorini::cone::Cone;
    use signorini::problems::NamedProblem;

    crate::options! {
        /// What it does
        pub struct Options: Quick {
            /// Regularity
            #[arg(long, default_value_t = 1.75)]
            pub tau: f64,
            /// Orders
            #[arg(long, value_delimiter = ',', default_values = ["0.25", "1/2"])]
            pub nu: Vec<Order>,
            /// Cone
            #[arg(long, default_value_t = Cone::Nodal)]
            pub cone: Cone,
            /// Scene
            #[arg(long)]
            pub scene: Option<NamedProblem>,
            /// Levels
            #[arg(long, default_value = "3-9")]
            pub levels: Levels,
            /// More
            #[arg(long)]
            pub lines: bool,
            /// Free text
            #[arg(long, default_value = "")]
            pub text: String,
        }
    }

    #[test]
    fn options_are_described_by_type_and_files_and_free_text_are_not_offered() {
        let said = describe::<Options>();
        assert_eq!((&said["about"], &said["cost"]), (&json!("What it does"), &json!("quick")));
        let options = said["options"].as_array().unwrap();
        let names: Vec<&str> = options.iter().filter_map(|o| o["name"].as_str()).collect();
        assert_eq!(names, ["tau", "nu", "cone", "scene", "levels", "lines"]);
        let kinds: Vec<&str> = options.iter().filter_map(|o| o["kind"].as_str()).collect();
        assert_eq!(kinds, ["number", "order", "choice", "named", "levels", "flag"]);
        assert_eq!(options[0]["default"], "1.75");
        assert_eq!(options[0]["range"], json!([1.5, 2.5]));
        assert_eq!((&options[1]["default"], &options[1]["list"]), (&json!("0.25,1/2"), &json!(true)));
        let scenes = options[3]["choices"].as_array().unwrap();
        assert!(scenes.contains(&json!("fat-cantor")) && !scenes.contains(&json!("samples")), "{scenes:?}");
    }

    /// Words of types that have no list of their own.
    #[test]
    fn every_choice_is_read() {
        fn are_read<T: std::str::FromStr + Clone + Send + Sync + 'static>(behind: &[&str])
        where
            T::Err: std::error::Error + Send + Sync,
        {
            let argument = Arg::new("x").value_parser(|text: &str| text.parse::<T>());
            let kind = kind(&argument).unwrap();
            assert!(!kind.choices().is_empty());
            for word in kind.choices() {
                let mut tails = behind.iter().map(|tail| format!("{word}:{tail}"));
                let is_read = word.parse::<T>().is_ok() || tails.any(|whole| whole.parse::<T>().is_ok());
                assert!(is_read, "{word}");
            }
        }
        are_read::<Condition>(&[]);
        are_read::<Place>(&[]);
        are_read::<GalleryFunction>(&["0.4"]);
        are_read::<SampleSlope>(&["0.4", "1"]);
        are_read::<Cone>(&[]);
        are_read::<NamedProblem>(&[]);
        are_read::<signorini::strip::StripKind>(&[]);
        are_read::<signorini::strip::Reference>(&[]);
        are_read::<experiments::proof::Against>(&[]);
        are_read::<experiments::proof::Resolution>(&["3"]);
        are_read::<signorini::contact::Solver>(&[]);
        are_read::<signorini::singular::SideConditions>(&[]);
    }
}
