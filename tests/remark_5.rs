//! The example `remark_5_log_counterexample` confirms its statement.

#[path = "../examples/remark_5_log_counterexample.rs"]
#[allow(dead_code)]
mod example;

#[test]
fn statement_is_confirmed() {
    let headline = example::run(&example::Options::default()).unwrap();
    assert!(headline.verdict.is_confirmed(), "{headline}");
}
