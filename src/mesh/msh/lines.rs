//! The lines of a `.msh` file with their numbers; blank ones are passed over.

use crate::error::{Error, Result};
use std::str::FromStr;

pub(super) struct Lines<'a> {
    numbered: std::iter::Enumerate<std::str::Lines<'a>>,
    line: usize,
}

impl<'a> Lines<'a> {
    pub(super) fn of(text: &'a str) -> Self {
        Self { numbered: text.lines().enumerate(), line: 0 }
    }

    pub(super) fn next_header(&mut self) -> Option<&'a str> {
        self.next_line().ok()
    }

    pub(super) fn next_line(&mut self) -> Result<&'a str> {
        for (index, line) in self.numbered.by_ref() {
            self.line = index + 1;
            if !line.trim().is_empty() {
                return Ok(line.trim());
            }
        }
        Err(self.fault("the file ends early"))
    }

    /// The numbers of the next line.
    pub(super) fn numbers<T: FromStr>(&mut self) -> Result<Vec<T>> {
        let line = self.next_line()?;
        line.split_whitespace()
            .map(|word| {
                word.parse().map_err(|_| self.fault(&format!("'{word}' is not a number of the right kind")))
            })
            .collect()
    }

    /// The first `N` numbers of the next line.
    pub(super) fn first<T: FromStr + Copy, const N: usize>(&mut self) -> Result<[T; N]> {
        let numbers = self.numbers()?;
        let first = numbers.first_chunk().copied();
        first.ok_or_else(|| self.fault(&format!("{} numbers, expected {N}", numbers.len())))
    }

    pub(super) fn skip_section(&mut self, header: &str) {
        let end = header.replacen('$', "$End", 1);
        while self.next_line().is_ok_and(|line| line != end) {}
    }

    pub(super) fn expect_end(&mut self, header: &str) -> Result<()> {
        let end = header.replacen('$', "$End", 1);
        let line = self.next_line()?;
        if line == end { Ok(()) } else { Err(self.fault(&format!("expected {end}, found '{line}'"))) }
    }

    pub(super) fn fault(&self, reason: &str) -> Error {
        Error::Syntax { format: "msh", line: self.line, reason: reason.to_owned() }
    }
}
