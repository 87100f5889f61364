//! Bad input through the examples: one clear line on stderr, exit code 2, nothing on stdout.

use crate::program::program;

#[track_caller]
fn is_refused(name: &str, line: &str) {
    let output = program(name).arg(line).output().unwrap();
    let error = String::from_utf8_lossy(&output.stderr);
    let shown = format!("{name} {line}: {:?} {error}", output.status.code());
    assert_eq!(output.status.code(), Some(2), "{shown}");
    assert!(error.starts_with("error: ") && error.trim_end().lines().count() == 1, "{shown}");
    assert!(output.stdout.is_empty(), "{shown}");
}

#[test]
fn contact_examples_refuse_what_has_no_mesh_cone_or_solver() {
    let lines = "--n=0 --n=-3 --n=many --n=99999999 --cone=dual --out=Cargo.toml --colour=red --values=Cargo.toml/values";
    lines.split(' ').for_each(|line| is_refused("section_2_elastic_contact", line));
}

#[test]
fn examples_refuse_what_has_no_zone_order_regularity_or_mesh() {
    let zones = "--theta=0 --theta=2 --theta=-0.1 --theta=nan --nu=1 --nu=0 --nu=half --condition=positive --out=Cargo.toml/a";
    let cases = "--tau=1.5 --tau=2.5 --theta=0 --theta=1 --n=6,32 --problem=drum";
    let rates = "--finest=1 --tau=1.5 --tau=2.6 --problem=drum";
    for (name, lines) in [
        ("lemma_5_2_poincare_scaling", zones),
        ("figure_3_2_alternative", cases),
        ("figure_4_1_alternative", cases),
        ("theorem_3_1_rates", rates),
        ("theorem_4_1_rates", rates),
        ("theorem_3_1_bodies", rates),
        ("tour", "--out=Cargo.toml"),
        ("lemma_6_1_local_estimate", "--nu=1"),
    ] {
        lines.split(' ').for_each(|line| is_refused(name, line));
    }
}

#[test]
fn help_is_not_an_error() {
    let output = program("tour").arg("--help").output().unwrap();
    assert!(output.status.success() && String::from_utf8_lossy(&output.stdout).contains("--tau"));
}
