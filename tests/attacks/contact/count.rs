//! What became of the scenes, solver by solver.

use super::compare::{Outcome, compare, is_hard};
use super::program::{Answer, Program};
use super::scene::Scene;
use signorini::Error;
use signorini::ToolkitError;
use signorini::cone::Cone;
use signorini::contact::ContactSolution;
use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Energies from here on, in powers of two, may leave the range of binary64 on the way.
const HUGE: f64 = 900.0;

/// Squares of such lengths, in powers of two, leave the range of binary64 for slivers.
const SQUARES: i32 = 400;

/// Units in which 52 bits are left of what the data are, in powers of two.
const TINY: i32 = -900;

/// Share of the solvable scenes in which an interior point may give up with a status.
const GIVEN_UP: f64 = 0.08;

#[derive(Debug, Default)]
struct Count {
    asked: usize,
    /// Forces compared, by the digits of the tolerance relative to the largest force.
    digits: [usize; 17],
    without_force: usize,
    ties: usize,
    /// Too badly conditioned to compare forces: the conditions of a solution hold.
    conditions: usize,
    /// Prescribed values that penetrate, and a status that says so.
    inadmissible: usize,
    /// Refused since the matrix, by rounding, is not positive definite, or J not a number of binary64.
    refused: usize,
    /// Statuses without such a reason.
    given_up: usize,
    /// Worst share of a tolerance that was needed.
    used: f64,
    wrong: Vec<String>,
}

#[derive(Debug, Default)]
pub struct Counts(BTreeMap<&'static str, Count>);

impl Counts {
    pub fn judge(
        &mut self,
        solver: &'static str,
        (seed, cone): (u64, Cone),
        scene: &Scene,
        (program, answer): (&Program, &Answer),
        solve: &dyn Fn() -> signorini::Result<ContactSolution>,
    ) {
        let count = self.0.entry(solver).or_default();
        count.asked += 1;
        let is_iterated = matches!(solver, "interior point" | "interior point, edge" | "barrier");
        let found = catch_unwind(AssertUnwindSafe(solve));
        let what = match found {
            Err(_) => Some("panic".to_owned()),
            Ok(Err(error)) => {
                let reason = reason(&error, scene, program, answer);
                count.refused += usize::from(reason);
                (!reason).then(|| format!("refused: {error}"))
            }
            Ok(Ok(solution)) => match compare(scene, program, answer, &solution) {
                Err(what) => Some(what),
                Ok(Outcome::Same { tolerance, ties, used }) => {
                    match tolerance {
                        Some(tolerance) => count.digits[(-tolerance.log10()).clamp(0.0, 16.0) as usize] += 1,
                        None => count.without_force += 1,
                    }
                    count.ties += ties;
                    count.used = count.used.max(used);
                    None
                }
                Ok(Outcome::Conditions) => {
                    count.conditions += 1;
                    None
                }
                Ok(Outcome::Status) if !program.is_admissible() => {
                    count.inadmissible += 1;
                    None
                }
                Ok(Outcome::Status) if is_hard(program) || is_iterated || scene.force_unit() < TINY => {
                    count.given_up += 1;
                    None
                }
                Ok(Outcome::Status) => Some(format!("{} {:?}", solution.status, solution.kkt)),
            },
        };
        if let Some(what) = what {
            let [a, b, c] = scene.units;
            let case = format!("seed {seed}, {cone}, units 2^({a}, {b}, {c})");
            let condition = program.condition();
            count.wrong.push(format!("{solver}, {case}, cond {condition:.1e}: {what}"));
        }
    }

    /// Prints the counts; fails on anything wrong, and `strictly` on too many statuses of an iterated solver.
    pub fn close(self, strictly: bool) {
        let mut wrong = Vec::new();
        for (solver, count) in self.0 {
            let compared: usize = count.digits.iter().sum();
            println!(
                "{solver}: {} asked, {compared} compared (digits of the tolerance {:?}), {} without force, {} \
                 by the conditions alone, {} ties, {} refused, {} inadmissible, {} given up, {} wrong; worst \
                 {:.3} of the tolerance",
                count.asked,
                count.digits,
                count.without_force,
                count.conditions,
                count.ties,
                count.refused,
                count.inadmissible,
                count.given_up,
                count.wrong.len(),
                count.used,
            );
            let most = GIVEN_UP * count.asked as f64;
            assert!(!strictly || count.given_up as f64 <= most, "{solver}: {} given up", count.given_up);
            wrong.extend(count.wrong);
        }
        assert!(wrong.is_empty(), "{} wrong: {:#?}", wrong.len(), &wrong[..wrong.len().min(200)]);
    }
}

/// True where there is a reason to refuse.
fn reason(error: &Error, scene: &Scene, program: &Program, answer: &Answer) -> bool {
    let size = answer.energy_size.max(answer.energy.abs()).log2();
    let is_beyond = size + f64::from(scene.displacement_unit() + scene.force_unit()) > HUGE;
    match error {
        Error::Toolkit(ToolkitError::NotPositiveDefinite { .. })
        | Error::Toolkit(ToolkitError::NotFinite { .. }) => is_hard(program) || is_beyond,
        Error::Toolkit(ToolkitError::Triangle { .. }) => scene.units[2].abs() > SQUARES,
        _ => false,
    }
}
