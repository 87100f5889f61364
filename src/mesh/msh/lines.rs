//! The lines of a Gmsh file with their numbers; blank lines are skipped.

use crate::error::{Error, Result};
use crate::text::quoted;
use std::str::FromStr;

const FORMAT: &str = "msh";

pub(super) struct Lines<'a> {
    numbered: std::iter::Enumerate<std::str::Lines<'a>>,
    line: usize,
}

impl<'a> Lines<'a> {
    pub(super) fn of(text: &'a str) -> Self {
        Self { numbered: text.lines().enumerate(), line: 0 }
    }

    /// The number of the line read last, from 1.
    pub(super) fn number(&self) -> usize {
        self.line
    }

    /// The header of the next section; `None` at the end of the file.
    pub(super) fn next_header(&mut self) -> Result<Option<&'a str>> {
        match self.next() {
            Some(line) if line.starts_with('$') && !line.starts_with("$End") => Ok(Some(line)),
            Some(line) => {
                Err(self.fault(&format!("expected the beginning of a section, found {}", quoted(line))))
            }
            None => Ok(None),
        }
    }

    fn next(&mut self) -> Option<&'a str> {
        for (index, line) in self.numbered.by_ref() {
            self.line = index + 1;
            if !line.trim().is_empty() {
                return Some(line.trim());
            }
        }
        None
    }

    pub(super) fn next_line(&mut self) -> Result<&'a str> {
        self.next().ok_or_else(|| self.fault("unexpected end of file"))
    }

    pub(super) fn numbers<T: FromStr>(&mut self) -> Result<Vec<T>> {
        self.next_line()?.split_whitespace().map(|word| self.number_of(word)).collect()
    }

    fn number_of<T: FromStr>(&self, word: &str) -> Result<T> {
        word.parse().map_err(|_| self.fault(&format!("{} is not an admissible number", quoted(word))))
    }

    pub(super) fn exactly<T: FromStr + Copy + Default, const N: usize>(&mut self) -> Result<[T; N]> {
        let numbers = self.numbers()?;
        numbers[..]
            .try_into()
            .map_err(|_| self.fault(&format!("found {} numbers, expected {N}", numbers.len())))
    }

    /// The tag and `N` further numbers that make up the next line.
    pub(super) fn tagged<const N: usize>(&mut self) -> Result<(u64, [u64; N])> {
        let numbers: Vec<u64> = self.numbers()?;
        let split = numbers.split_first().and_then(|(&tag, rest)| Some((tag, rest.try_into().ok()?)));
        split.ok_or_else(|| self.fault(&format!("found {} numbers, expected {}", numbers.len(), N + 1)))
    }

    /// A count in a block of mixed numbers.
    pub(super) fn count(&self, given: i64) -> Result<u64> {
        u64::try_from(given).map_err(|_| self.fault(&format!("{given} is not a count")))
    }

    pub(super) fn skip_section(&mut self, header: &str) -> Result<()> {
        let (line, end) = (self.line, header.replacen('$', "$End", 1));
        while let Some(next) = self.next() {
            if next == end {
                return Ok(());
            }
        }
        self.line = line;
        Err(self.fault(&format!("the end of section {} is missing", quoted(header))))
    }

    pub(super) fn expect_end(&mut self, header: &str) -> Result<()> {
        let end = header.replacen('$', "$End", 1);
        let line = self.next_line()?;
        if line == end {
            return Ok(());
        }
        Err(self.fault(&format!("expected {end}, found {}", quoted(line))))
    }

    /// The error for the line read last.
    pub(super) fn fault(&self, reason: &str) -> Error {
        fault(self.line, reason)
    }
}

/// The error for a line.
pub(super) fn fault(line: usize, reason: &str) -> Error {
    Error::Syntax { format: FORMAT, line, reason: reason.to_owned() }
}

/// The error for invalid data of a line.
pub(super) fn at(line: usize, cause: Error) -> Error {
    Error::AtLine { format: FORMAT, line, cause: Box::new(cause) }
}
