//! The page in a browser that is there: the address carries the parameters, the page computes and shows.

use super::http::{Book, short};
use std::process::Command;

/// Where a Chromium may be.
const BROWSERS: [&str; 4] = ["chromium", "chromium-browser", "google-chrome", "chrome"];

/// The page after its scripts have run, as HTML.
fn page(browser: &str, address: &str) -> Option<String> {
    let profile = tempfile::tempdir().unwrap();
    let output = Command::new(browser)
        .args([
            "--headless=new",
            "--no-sandbox",
            "--disable-gpu",
            "--no-first-run",
            "--virtual-time-budget=8000",
        ])
        .arg(format!("--user-data-dir={}", profile.path().display()))
        .args(["--dump-dom", address])
        .output()
        .ok()?;
    Some(String::from_utf8_lossy(&output.stdout).into_owned())
        .filter(|html| html.contains("</html>"))
}

/// A Chromium, if there is one.
fn browser() -> Option<&'static str> {
    let is_there = |name: &&str| {
        Command::new(name).arg("--version").output().is_ok_and(|o| o.status.success())
    };
    let found = BROWSERS.into_iter().find(is_there);
    if found.is_none() {
        println!("skipped: no Chromium here");
    }
    found
}

#[test]
fn a_browser_computes_with_the_parameters_of_the_address() {
    let Some(browser) = browser() else { return };
    let book = Book::serve(short());
    let at =
        |query: &str| page(browser, &format!("http://{}/first.html{query}", book.host())).unwrap();
    let plain = at("");
    assert!(plain.contains("x is 1/2") && plain.contains(">Compute</button>"), "{plain}");
    assert_eq!(book.runs().len(), 0, "a page computes only when asked");
    let tried = at("?try=planted&x=0.25");
    for part in [">now x is 0.25", ">Now x is 0.25", "x = 0.25", "class=\"computed\"", "holds ("] {
        assert!(tried.contains(part), "{part} not in {tried}");
    }
    assert_eq!(book.runs().len(), 1);
    let refused = at("?try=planted&x=nan");
    assert!(refused.contains("not a number") && refused.contains("x is 1/2"), "{refused}");
    assert_eq!(book.runs().len(), 1);
}
