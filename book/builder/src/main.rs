//! `cargo book`: runs the examples, writes `book/generated`, builds the pages. `cargo book build`: builds the pages
//! from the committed data. `cargo book labels`: writes the tables made from `labels.toml` and the list of chapters in
//! `src/book.rs`, and nothing else. `cargo book only NAME`: as `cargo book`, but of the examples runs this one. `cargo book large NAME`: makes a run of `large.toml` and keeps what it computed.
//! `cargo book course`: writes slides and sheets of the course next to the pages.
//! `cargo book serve [--port P]`: builds the pages and the examples, and serves the book on a loopback address.
//! `cargo book check`: runs the examples and fails where the committed data or a page is not right.

use book_builder::data::Data;
use book_builder::error::{Error, Result};
use book_builder::serve::{Laboratory, Limits, Server};
use book_builder::{
    Layout, build, check_fresh, check_pages, committed, examples, labels, large, shown, slides,
    stale, tables,
};
use std::path::PathBuf;
use std::process::{Command, ExitCode};

/// Where the book is served unless said otherwise.
const PORT: u16 = 8012;
const USAGE: &str = "usage: cargo book [build | check | course | labels | large NAME | only NAME | serve [--port P]]";

fn main() -> ExitCode {
    // Of the repository in which Cargo runs it, which may be a copy of the one that it was built in.
    let here = std::env::var_os("CARGO_MANIFEST_DIR").map(|here| PathBuf::from(here).join("../.."));
    let repository = here.unwrap_or_default();
    let layout = Layout::of(&repository.canonicalize().unwrap_or(repository));
    let words: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    let done = match words.as_slice() {
        [] => renew(&layout, None),
        ["only", name] => renew(&layout, Some(name)),
        ["build"] => committed(&layout).and_then(|data| build(&layout, &data)),
        ["check"] => check(&layout),
        ["serve"] => serve(&layout, PORT),
        ["serve", "--port", port] => match port.parse() {
            Ok(port) => serve(&layout, port),
            Err(_) => {
                eprintln!("{USAGE}");
                return ExitCode::from(2);
            }
        },
        ["course"] => {
            return match committed(&layout).and_then(|data| slides::write_all(&layout, data)) {
                Ok(files) => {
                    files.iter().for_each(|file| println!("file://{}", file.display()));
                    ExitCode::SUCCESS
                }
                Err(error) => said(Err(error)),
            };
        }
        ["labels"] => labels::list(&layout.repository)
            .and_then(|list| tables::renew(&list, &layout.repository))
            .map(|()| layout.repository.clone()),
        ["large", name] => {
            return said(
                large::renew(&layout, name)
                    .and_then(|kept| shown(&layout, kept)?.write(&layout.large()))
                    .map(|()| layout.large().join("values.json")),
            );
        }
        ["-h" | "--help" | "help"] => {
            println!("{USAGE}");
            return ExitCode::SUCCESS;
        }
        _ => {
            eprintln!("{USAGE}");
            return ExitCode::from(2);
        }
    };
    said(done.map(|output| output.join("index.html")))
}

/// Where the outcome is, or what is wrong.
fn said(done: Result<PathBuf>) -> ExitCode {
    match done {
        Ok(file) => {
            println!("file://{}", file.display());
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

/// Of all examples, or with what is known of all others but one.
fn renew(layout: &Layout, only: Option<&str>) -> Result<PathBuf> {
    let known = Data::read(&layout.generated()).unwrap_or_default();
    let computed = match only {
        None => examples::gather(&layout.repository, &known)?,
        Some(name) => {
            let mut all = known.clone();
            all.renew(name, examples::one(&layout.repository, name)?);
            all
        }
    };
    let data = shown(layout, computed)?;
    stale::kept(&known, data).write(&layout.generated())?;
    tables::renew(&labels::list(&layout.repository)?, &layout.repository)?;
    build(layout, &committed(layout)?)
}

/// The book as a laboratory; ends when it is interrupted.
fn serve(layout: &Layout, port: u16) -> Result<PathBuf> {
    let data = committed(layout)?;
    let output = build(layout, &data)?;
    let programs = examples::build(&layout.repository)?;
    let server =
        Server::bind(Laboratory::new(layout, data, &output, &programs, Limits::default())?, port)?;
    println!("http://{}/ (Ctrl-C ends it)", server.address());
    server.run().map(|()| output)
}

/// Pages first: their faults show at once, without the examples.
fn check(layout: &Layout) -> Result<PathBuf> {
    let known = Data::read(&layout.generated())?;
    let output = check_pages(layout, &committed(layout)?)?;
    check_sessions(layout)?;
    check_fresh(layout, &known, &examples::gather(&layout.repository, &known)?)?;
    Ok(output)
}

/// Python's sessions of a page are run and compared where the package is installed.
fn check_sessions(layout: &Layout) -> Result<()> {
    const PAGE: &str = "book/src/from_python.md";
    let python = |arguments: &[&str]| {
        Command::new("python3").args(arguments).current_dir(&layout.repository).output().ok()
    };
    let modules = "import fractional_sobolev, meshio, numpy, scipy";
    if !python(&["-c", modules]).is_some_and(|found| found.status.success()) {
        println!("{PAGE}: sessions skipped, no python3 with fractional_sobolev, meshio and scipy");
        return Ok(());
    }
    match python(&["-m", "doctest", PAGE]) {
        Some(done) if done.status.success() => Ok(()),
        done => {
            let message = done
                .map_or(String::new(), |done| String::from_utf8_lossy(&done.stdout).into_owned());
            Err(Error::Example { name: PAGE.to_owned(), message })
        }
    }
}
