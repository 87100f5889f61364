//! The printed edition: the page that holds all pages gets a title page and a table of contents, everything
//! folded is opened; where a Chromium is installed it becomes a PDF.

use crate::error::{Error, Result, read, write};
use crate::markup::escape;
use crate::page::Page;
use crate::search::sections;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The page that holds all pages.
pub const PAGE: &str = "print.html";
/// Programs that print a page.
const BROWSERS: [&str; 4] = ["chromium", "chromium-browser", "google-chrome", "chrome"];

/// Title, contents, and everything open.
///
/// # Errors
/// [`Error::File`].
pub fn finish(output: &Path, pages: &[Page]) -> Result<()> {
    let file = output.join(PAGE);
    if !file.exists() {
        return Ok(());
    }
    let mut front = "<section class=\"title-page\"><p class=\"title\">Signorini's problem, computed</p>\
        <p>A companion to P. Hild and Y. Renard, <em>An improved a priori error analysis for finite element \
        approximations of Signorini's problem</em>, SIAM J. Numer. Anal. 50 (2012) 2400\u{2013}2419</p>\
        <p>the signorini developers</p></section><nav class=\"print-contents\"><p class=\"title\">Contents</p><ol>"
        .to_owned();
    for page in pages {
        let built = sections(&read(&output.join(&page.html))?);
        if let Some(first) = built.first() {
            let _ = write!(front, "<li><a href=\"#{}\">{}</a></li>", first.anchor, escape(&first.title));
        }
    }
    front.push_str("</ol></nav>");
    let html = read(&file)?.replacen("<main>", &format!("<main>{front}"), 1);
    write(&file, html.replace("<details class=\"answer\">", "<details class=\"answer\" open>"))
}

/// Prints the built book: the PDF where a Chromium is there, else the page to print from any browser.
///
/// # Errors
/// [`Error::Example`] when the browser fails.
pub fn pdf(output: &Path) -> Result<PathBuf> {
    let is_there =
        |name: &&str| Command::new(name).arg("--version").output().is_ok_and(|o| o.status.success());
    let page = output.join(PAGE);
    let Some(browser) = BROWSERS.into_iter().find(is_there) else { return Ok(page) };
    let file = output.join("book.pdf");
    let failed = |message: String| Error::Example { name: browser.to_owned(), message };
    let printed = Command::new(browser)
        .args(["--headless=new", "--no-sandbox", "--disable-gpu", "--no-pdf-header-footer"])
        .arg(format!("--user-data-dir={}", output.join("browser").display()))
        .arg(format!("--print-to-pdf={}", file.display()))
        .arg(format!("file://{}", page.display()))
        .output()
        .map_err(|e| failed(e.to_string()))?;
    let _ = std::fs::remove_dir_all(output.join("browser"));
    if file.exists() { Ok(file) } else { Err(failed(String::from_utf8_lossy(&printed.stderr).into_owned())) }
}
