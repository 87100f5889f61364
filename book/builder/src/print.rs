//! The printed edition: the page that holds all pages gets a title page and a table of contents, everything
//! folded is opened; where a Chromium is installed it becomes a PDF. Numbers of pages in the contents are read
//! off a first print and put into a second one.

use crate::chapter::Page;
use crate::error::{Error, Result, read, write};
use crate::markup::escape;
use crate::pdf;
use crate::search::sections;
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The page that holds all pages.
pub const PAGE: &str = "print.html";
/// Where the contents begin.
const CONTENTS: &str = "<nav class=\"print-contents\">";
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
        <p>the signorini developers</p></section>"
        .to_owned();
    front.push_str(CONTENTS);
    front.push_str("<p class=\"title\">Contents</p><ol>");
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
/// [`Error::Example`] when the browser fails or the numbers of the contents do not settle.
pub fn pdf(output: &Path) -> Result<PathBuf> {
    let is_there =
        |name: &&str| Command::new(name).arg("--version").output().is_ok_and(|o| o.status.success());
    let page = output.join(PAGE);
    let Some(browser) = BROWSERS.into_iter().find(is_there) else { return Ok(page) };
    let file = output.join("book.pdf");
    let html = read(&page)?;
    print(browser, &page, &file)?;
    let numbered = output.join("print-numbered.html");
    let mut numbers = numbers(&file)?;
    for _ in 0..3 {
        write(&numbered, with_numbers(&html, &numbers))?;
        print(browser, &numbered, &file)?;
        let found = self::numbers(&file)?;
        if found == numbers {
            let _ = std::fs::remove_file(&numbered);
            return Ok(file);
        }
        numbers = found;
    }
    Err(failed(browser, "numbers of pages do not settle"))
}

/// Where the places of a PDF are.
fn numbers(file: &Path) -> Result<BTreeMap<String, usize>> {
    let bytes = std::fs::read(file).map_err(|source| Error::File { path: file.to_owned(), source })?;
    Ok(pdf::pages(&bytes).unwrap_or_default())
}

/// The contents with the number of the page behind each entry that is known.
fn with_numbers(html: &str, numbers: &BTreeMap<String, usize>) -> String {
    let Some((before, rest)) = html.split_once(CONTENTS) else { return html.to_owned() };
    let Some((contents, behind)) = rest.split_once("</nav>") else { return html.to_owned() };
    let mut numbered = String::new();
    for entry in contents.split_inclusive("</a>") {
        numbered.push_str(entry);
        let anchor = entry.rsplit_once("href=\"#").and_then(|(_, rest)| rest.split_once('"'));
        if let Some(number) = anchor.and_then(|(anchor, _)| numbers.get(anchor)) {
            let _ = write!(numbered, "<span class=\"page-number\">{number}</span>");
        }
    }
    format!("{before}{CONTENTS}{numbered}</nav>{behind}")
}

fn failed(browser: &str, message: impl Into<String>) -> Error {
    Error::Example { name: browser.to_owned(), message: message.into() }
}

fn print(browser: &str, page: &Path, file: &Path) -> Result<()> {
    let user = tempfile::tempdir().map_err(|e| failed(browser, e.to_string()))?;
    let _ = std::fs::remove_file(file);
    let printed = Command::new(browser)
        .args(["--headless=new", "--no-sandbox", "--disable-gpu", "--no-pdf-header-footer"])
        .arg("--generate-pdf-document-outline")
        .arg(format!("--user-data-dir={}", user.path().display()))
        .arg(format!("--print-to-pdf={}", file.display()))
        .arg(format!("file://{}", page.display()))
        .output()
        .map_err(|e| failed(browser, e.to_string()))?;
    if file.exists() { Ok(()) } else { Err(failed(browser, String::from_utf8_lossy(&printed.stderr))) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn entries_of_the_contents_get_the_numbers_that_are_known() {
        let html = format!(
            "<a href=\"#x\">x</a>{CONTENTS}<ol><li><a href=\"#x\">X</a></li><li><a href=\"#y\">Y</a></li></ol></nav>"
        );
        let numbers = [("x".to_owned(), 17)].into();
        let numbered = with_numbers(&html, &numbers);
        assert_eq!(numbered.matches("page-number").count(), 1, "{numbered}");
        assert!(numbered.contains(">X</a><span class=\"page-number\">17</span></li>"), "{numbered}");
        assert_eq!(with_numbers("nothing", &numbers), "nothing");
    }
}
