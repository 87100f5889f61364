//! What is served: files of the built book, pages that can be computed anew, programs.

use super::limits::Limits;
use super::run::Outcome;
use crate::data::{Data, names};
use crate::decimal;
use crate::directive::Sources;
use crate::error::{Error, Result, read};
use crate::html::chapters;
use crate::layout::Layout;
use std::cell::RefCell;
use std::collections::{BTreeMap, VecDeque};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use tokio::sync::Semaphore;

/// Outcomes that are kept.
const KEPT: usize = 64;

/// A file as it is sent.
pub(super) struct File {
    pub(super) kind: &'static str,
    pub(super) content: Vec<u8>,
}

/// What was asked: example and arguments.
type Question = (String, Vec<String>);

/// Everything a server needs; nothing of it is looked up on disk by what a request says.
pub struct Laboratory {
    files: BTreeMap<String, File>,
    pages: BTreeMap<String, String>,
    programs: BTreeMap<String, PathBuf>,
    data: Data,
    layout: Layout,
    allowed: Vec<String>,
    limits: Limits,
    known: RefCell<VecDeque<(Question, Arc<Outcome>)>>,
    /// One run at a time.
    pub(super) turn: Semaphore,
}

impl Laboratory {
    /// The book built in `output`, and the programs of its examples by their file names.
    ///
    /// # Errors
    /// When a file cannot be read.
    pub fn new(
        layout: &Layout,
        data: Data,
        output: &Path,
        programs: &[PathBuf],
        limits: Limits,
    ) -> Result<Self> {
        let mut files = BTreeMap::new();
        collect(output, "", &mut files)?;
        let chapters = chapters(&layout.book, &layout.repository)?;
        // The first page stands there twice.
        let index = chapters.first().map(|page| ("index.html".to_owned(), page.text.clone()));
        let allowed = read(&layout.book.join("allowed-decimals.txt")).unwrap_or_default();
        let stem = |program: &PathBuf| {
            (
                program.file_stem().unwrap_or_default().to_string_lossy().into_owned(),
                program.clone(),
            )
        };
        Ok(Self {
            files,
            pages: chapters.into_iter().map(|page| (page.html, page.text)).chain(index).collect(),
            programs: programs.iter().map(stem).collect(),
            data,
            layout: layout.clone(),
            allowed: decimal::allow_list(&allowed),
            limits,
            known: RefCell::default(),
            turn: Semaphore::new(1),
        })
    }

    pub(super) fn limits(&self) -> &Limits {
        &self.limits
    }

    pub(super) fn data(&self) -> &Data {
        &self.data
    }

    /// A file of the book by its whole name, `/` for the first page.
    pub(super) fn file(&self, name: &str) -> Option<&File> {
        self.files.get(if name == "/" { "/index.html" } else { name })
    }

    /// The source of a page by the name of its built file.
    pub(super) fn page(&self, html: &str) -> Option<&str> {
        self.pages.get(html).map(String::as_str)
    }

    pub(super) fn program(&self, example: &str) -> Option<&Path> {
        self.programs.get(example).map(PathBuf::as_path)
    }

    /// What directives draw on when `data` takes the place of the committed data.
    pub(super) fn with_sources<T>(&self, data: &Data, then: impl FnOnce(&Sources<'_>) -> T) -> T {
        let repository = &self.layout.repository;
        let (examples, tests) = (repository.join("examples"), repository.join("tests"));
        let ideas = self.layout.book.join("ideas");
        then(&Sources {
            data,
            examples: &examples,
            tests: &tests,
            ideas: &ideas,
            allowed: &self.allowed,
        })
    }

    /// An outcome that is kept.
    pub(super) fn recall(&self, question: &Question) -> Option<Arc<Outcome>> {
        let known = self.known.borrow();
        known.iter().find(|(kept, _)| kept == question).map(|(_, outcome)| Arc::clone(outcome))
    }

    pub(super) fn keep(&self, question: Question, outcome: &Arc<Outcome>) {
        let mut known = self.known.borrow_mut();
        if known.len() == KEPT {
            known.pop_front();
        }
        known.push_back((question, Arc::clone(outcome)));
    }
}

/// All files below a directory, named from `/`.
fn collect(directory: &Path, prefix: &str, files: &mut BTreeMap<String, File>) -> Result<()> {
    for name in names(directory)? {
        let path = directory.join(&name);
        let full = format!("{prefix}/{name}");
        if path.is_dir() {
            collect(&path, &full, files)?;
        } else {
            let content = std::fs::read(&path).map_err(|source| Error::File { path, source })?;
            files.insert(full, File { kind: kind(&name), content });
        }
    }
    Ok(())
}

fn kind(name: &str) -> &'static str {
    match name.rsplit_once('.').map_or("", |(_, end)| end) {
        "html" => "text/html; charset=utf-8",
        "css" => "text/css; charset=utf-8",
        "js" => "text/javascript; charset=utf-8",
        "svg" => "image/svg+xml",
        "png" => "image/png",
        "otf" => "font/otf",
        "woff2" => "font/woff2",
        "csv" => "text/csv; charset=utf-8",
        _ => "application/octet-stream",
    }
}
