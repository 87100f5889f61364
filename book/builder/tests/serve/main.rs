//! `cargo book serve` over HTTP: what it answers, what it refuses, how a run ends, and a browser before it.

mod browser;
mod hostile;
mod http;
mod lists;

use http::{Book, short};
use serde_json::json;
use std::io::Write;
use std::net::TcpStream;
use std::time::{Duration, Instant};

#[test]
fn pages_are_served_and_offer_their_parameters() {
    let book = Book::serve(short());
    assert!(book.address.ip().is_loopback());
    for path in ["/", "/index.html", "/first.html", "/first.html?try=planted&x=0.2"] {
        let (status, page) = book.get(path);
        assert_eq!(status, 200, "{path}");
        assert!(page.contains("class=\"try-it\" data-example=\"planted\""), "{path}");
        assert!(page.contains("data-live=\"finding: planted/k\""), "{path}");
    }
    assert!(!book.get("/print.html").1.contains("class=\"try-it\""), "a panel cannot be printed");
    let (status, page) = book.raw(
        format!("HEAD /first.html HTTP/1.1\r\nHost: {}\r\nConnection: close\r\n\r\n", book.host())
            .as_bytes(),
    );
    assert_eq!((status, page.as_str()), (200, ""));
}

#[test]
fn a_run_answers_in_the_words_of_the_page_and_is_kept() {
    let book = Book::serve(short());
    let (status, found) = book.ask(&json!({"x": "0.25", "nu": "0.25,1/2", "lines": "true"}));
    assert_eq!(status, 200, "{found}");
    let block = |text: &str| found["blocks"][text].as_str().unwrap_or("").to_owned();
    assert!(block("figure: planted/chart: A chart").contains("x = 0.25"), "{found}");
    assert!(block("table: planted").contains("0.25"), "{found}");
    assert!(block("finding: planted/k").contains(">now x is 0.25"), "{found}");
    let begins = found["begins"]["finding: planted/k"].as_str().unwrap_or("");
    assert!(begins.contains(">Now x is 0.25"), "{found}");
    assert_eq!(block("value: planted/x: s3"), "0.250");
    assert_eq!(found["verdict"], "holds");
    let runs = book.runs();
    assert!(runs[0].starts_with("--x=0.25 --nu=0.25,1/2 --lines --values "), "{runs:?}");
    assert_eq!(book.ask(&json!({"nu": "0.25,1/2", "lines": "true", "x": "0.25"})).0, 200);
    assert_eq!(book.ask(&json!({"x": "0.25", "nu": "0.25,1/2", "lines": "true", "n": "8"})).0, 200);
    assert_eq!(book.runs().len(), 1, "the same question is computed once");
}

#[test]
fn what_an_example_refuses_is_said() {
    let book = Book::serve(short());
    let (status, found) = book.ask(&json!({"mode": "refuse"}));
    assert_eq!((status, &found["error"]), (422, &json!("x = 3 is outside [0, 1]")));
    for mode in ["crash", "silent"] {
        let (status, found) = book.ask(&json!({"mode": mode}));
        assert_eq!(status, 503, "{mode}: {found}");
    }
}

#[test]
fn runs_that_take_too_much_are_stopped() {
    for (mode, words, limits) in [
        ("wait", "longer than", short()),
        ("write", "wrote too much", patient()),
        ("grow", "memory", patient()),
    ] {
        if mode == "grow" && !std::path::Path::new("/proc/self/status").exists() {
            continue;
        }
        // On a busy machine a short limit would be met before the one that is asked about.
        let book = Book::serve(limits);
        let start = Instant::now();
        let (status, found) = book.ask(&json!({"mode": mode}));
        assert_eq!(status, 503, "{mode}: {found}");
        assert!(found["error"].as_str().unwrap_or("").contains(words), "{mode}: {found}");
        assert!(start.elapsed() < Duration::from_secs(100), "{mode}: {:?}", start.elapsed());
    }
}

/// Long enough for a run that is not ended to be noticed.
fn patient() -> book_builder::serve::Limits {
    book_builder::serve::Limits { run: Duration::from_secs(300), ..short() }
}

fn wait_for(what: &str, mut done: impl FnMut() -> bool) {
    let start = Instant::now();
    while !done() {
        assert!(start.elapsed() < Duration::from_secs(10), "{what}");
        std::thread::sleep(Duration::from_millis(10));
    }
}

#[test]
fn one_run_at_a_time_and_a_page_that_is_left_ends_its_run() {
    let book = Book::serve(patient());
    let body = json!({"example": "planted", "page": "first.html", "options": {"mode": "wait"}})
        .to_string();
    let mut page = TcpStream::connect(book.address).unwrap();
    page.write_all(&book.post(&body)).unwrap();
    wait_for("the run does not start", || book.runs().len() == 1);
    let (status, found) = book.ask(&json!({"x": "0.1"}));
    assert_eq!(status, 409, "{found}");
    // Files are served meanwhile.
    assert_eq!(book.get("/first.html").0, 200);
    drop(page);
    wait_for("the run goes on", || book.ask(&json!({"x": "0.1"})).0 == 200);
    wait_for("its process is there", || !is_running(&book));
}

/// Whether a waiting program of this book is still there.
fn is_running(book: &Book) -> bool {
    let program = book.program();
    let processes = std::fs::read_dir("/proc").into_iter().flatten().filter_map(Result::ok);
    let mut lines = processes.filter_map(|entry| std::fs::read(entry.path().join("cmdline")).ok());
    lines.any(|line| line.starts_with(program.as_bytes()))
}
