//! Bad input through the examples: one clear line on stderr, exit code 2, nothing on stdout.

use crate::program::program;

#[track_caller]
fn is_refused(name: &str, arguments: &[&str]) {
    let output = program(name).args(arguments).output().unwrap();
    let error = String::from_utf8_lossy(&output.stderr);
    let shown = format!("{name} {arguments:?}: {:?} {error}", output.status.code());
    assert_eq!(output.status.code(), Some(2), "{shown}");
    assert!(error.starts_with("error: ") && error.trim_end().lines().count() == 1, "{shown}");
    assert!(output.stdout.is_empty(), "{shown}");
}

#[test]
fn contact_examples_refuse_what_has_no_mesh_cone_or_solver() {
    for name in ["section_2_elastic_contact"] {
        for arguments in [
            ["--n", "0"],
            ["--n", "-3"],
            ["--n", "many"],
            ["--n", "99999999"],
            ["--cone", "dual"],
            ["--out", "Cargo.toml"],
            ["--colour", "red"],
            ["--values", "Cargo.toml/values"],
        ] {
            is_refused(name, &arguments);
        }
    }
}

#[test]
fn poincare_example_refuses_what_has_no_zone_or_order() {
    for arguments in [
        ["--theta", "0"],
        ["--theta", "2"],
        ["--theta", "-0.1"],
        ["--theta", "nan"],
        ["--nu", "1"],
        ["--nu", "0"],
        ["--nu", "half"],
        ["--condition", "positive"],
        ["--out", "Cargo.toml/figures"],
    ] {
        is_refused("lemma_5_2_poincare_scaling", &arguments);
    }
}

#[test]
fn studies_refuse_what_cannot_be_classified_or_refined() {
    for arguments in [
        ["--tau", "1.5"],
        ["--tau", "2.5"],
        ["--theta", "0"],
        ["--theta", "1"],
        ["--n", "6,32"],
        ["--problem", "drum"],
    ] {
        is_refused("figure_3_2_alternative", &arguments);
        is_refused("figure_4_1_alternative", &arguments);
    }
    for arguments in [["--finest", "1"], ["--tau", "1.5"], ["--tau", "2.6"], ["--problem", "drum"]] {
        is_refused("theorem_3_1_rates", &arguments);
        is_refused("theorem_4_1_rates", &arguments);
        is_refused("theorem_3_1_bodies", &arguments);
    }
    is_refused("tour", &["--out", "Cargo.toml"]);
    is_refused("lemma_6_1_local_estimate", &["--nu", "1"]);
}

#[test]
fn help_is_not_an_error() {
    let output = program("tour").arg("--help").output().unwrap();
    assert!(output.status.success() && String::from_utf8_lossy(&output.stdout).contains("--tau"));
}
