//! Functions of x and y from the command line: `"-cos(pi*x) - 0.5"`.
//!
//! Numbers, `x`, `y`, `pi`, `e`, `+ - * / ^`, parentheses, and functions with their arguments in
//! parentheses; angles in radians, `log` and `ln` natural. An exponent may have a sign: `10^-2`,
//! `e^-x`. Ambiguous expressions are rejected: `2*-x`, `2^3^2`, `e^-x^2`, `sin x`, `2x`, `x y`.

use crate::{Error, Result};
use std::sync::Arc;

type Checked<T> = std::result::Result<T, String>;
type Of1 = fn(f64) -> f64;
type Of2 = fn(f64, f64) -> f64;

/// Functions of one argument by their names.
macro_rules! by_name {
    [$($name:ident),*] => {
        [$((stringify!($name), f64::$name as Of1)),*, ("log", f64::ln), ("signum", sign)]
    };
}
const ONE: [(&str, Of1); 21] = by_name![
    abs, sin, cos, tan, asin, acos, atan, sinh, cosh, tanh, asinh, acosh, atanh, floor, exp, sqrt,
    cbrt, log10, ln
];
const TWO: [(&str, Of2); 3] = [("min", f64::min), ("max", f64::max), ("atan2", f64::atan2)];

/// 1, −1, and 0 at 0 of either sign, where `f64::signum` is ±1.
fn sign(x: f64) -> f64 {
    if x == 0.0 { 0.0 } else { x.signum() }
}

/// Largest length of a text and largest depth of parentheses.
const LONGEST: usize = 2000;
const DEEPEST: usize = 50;

/// A function of x and y.
#[derive(Clone)]
pub struct Expression(Arc<dyn Fn([f64; 2]) -> f64 + Send + Sync>);

impl Expression {
    /// The function given by an expression.
    ///
    /// # Errors [`Error::Option`] with the reason, for an expression that cannot be parsed or has
    /// more than 2000 bytes.
    pub fn parse(text: &str) -> Result<Self> {
        if text.len() > LONGEST {
            return Err(Error::Option(format!(
                "the expression has more than {LONGEST} characters"
            )));
        }
        let mut reader = Reader { rest: text.trim(), depth: 0 };
        let whole = reader.sum().and_then(|whole| match reader.peek() {
            None => Ok(whole),
            Some(')') => Err("unmatched closing parenthesis".to_owned()),
            Some(',') => Err("a comma outside the arguments of a function".to_owned()),
            Some(_) => Err(reader.two_in_a_row()),
        });
        whole.map_err(|why| Error::Option(format!("expression '{}': {why}", text.trim())))
    }

    /// The functions given by a comma-separated list of expressions; commas inside parentheses
    /// separate arguments.
    ///
    /// # Errors
    /// As for [`Expression::parse`].
    pub fn parse_list(text: &str) -> Result<Vec<Self>> {
        let mut depth = 0_i64;
        let split = |c: char| {
            depth += i64::from(c == '(') - i64::from(c == ')');
            c == ',' && depth == 0
        };
        text.split(split).map(Self::parse).collect()
    }

    /// The value at a point; NaN or infinite where the function is not defined.
    pub fn at(&self, point: [f64; 2]) -> f64 {
        (self.0)(point)
    }

    fn number(value: f64) -> Self {
        Self(Arc::new(move |_| value))
    }

    fn two(f: Of2, a: Self, b: Self) -> Self {
        Self(Arc::new(move |point| f(a.at(point), b.at(point))))
    }
}

struct Reader<'a> {
    rest: &'a str,
    depth: usize,
}

impl Reader<'_> {
    fn peek(&mut self) -> Option<char> {
        self.rest = self.rest.trim_start();
        self.rest.chars().next()
    }

    /// Whether the next character is this one, which is then read.
    fn takes(&mut self, c: char) -> bool {
        let is_next = self.peek() == Some(c);
        if is_next {
            self.rest = &self.rest[c.len_utf8()..];
        }
        is_next
    }

    fn two_in_a_row(&self) -> String {
        match self.rest.chars().next() {
            Some(c) if !c.is_alphanumeric() && !"(_.".contains(c) => unknown_character(c),
            _ => format!("operator missing before '{}': write a product as 2*x", self.rest),
        }
    }

    /// [+-] product {+- product}
    fn sum(&mut self) -> Checked<Expression> {
        self.depth += 1;
        if self.depth > DEEPEST {
            return Err(format!("parentheses are nested more than {DEEPEST} deep"));
        }
        let first = if self.takes('-') {
            Expression::two(|a, b| a - b, Expression::number(0.0), self.product()?)
        } else {
            self.takes('+');
            self.product()?
        };
        let sum = self.chain(first, [('+', |a, b| a + b), ('-', |a, b| a - b)], Self::product);
        self.depth -= 1;
        sum
    }

    /// power {*/ power}
    fn product(&mut self) -> Checked<Expression> {
        let first = self.power()?;
        self.chain(first, [('*', |a, b| a * b), ('/', |a, b| a / b)], Self::power)
    }

    /// Terms joined by either of two operators, from left to right.
    fn chain(
        &mut self,
        first: Expression,
        signs: [(char, Of2); 2],
        next: fn(&mut Self) -> Checked<Expression>,
    ) -> Checked<Expression> {
        let mut whole = first;
        while let Some((_, f)) = signs.iter().find(|(sign, _)| self.takes(*sign)) {
            whole = Expression::two(*f, whole, next(self)?);
        }
        Ok(whole)
    }

    /// atom [^ [+-] atom]
    fn power(&mut self) -> Checked<Expression> {
        let base = self.atom()?;
        if !self.takes('^') {
            return Ok(base);
        }
        // A sign behind ^ has one reading: 10^-2 = 10^(-2).
        let power = if self.takes('-') {
            Expression::two(|a, b| a.powf(-b), base, self.atom()?)
        } else {
            self.takes('+');
            Expression::two(f64::powf, base, self.atom()?)
        };
        match self.peek() {
            Some('^') => Err("two powers in a row need parentheses: a^(b^c) or (a^b)^c".to_owned()),
            _ => Ok(power),
        }
    }

    fn atom(&mut self) -> Checked<Expression> {
        match self.peek() {
            None => Err("is empty, or ends too early".to_owned()),
            Some('(') => self.arguments("a parenthesis").map(|[argument]| argument),
            Some('0'..='9' | '.') => self.number(),
            Some(c) if c.is_alphabetic() || c == '_' => self.named(),
            Some('+' | '-') => {
                Err("two signs in a row: a signed factor needs parentheses, as in 2*(-x)"
                    .to_owned())
            }
            Some('*') => Err("'*' has nothing before it; a power is x^2".to_owned()),
            Some(c @ ('/' | '^' | ')' | ',')) => Err(format!("'{c}' has nothing before it")),
            Some(c) => Err(unknown_character(c)),
        }
    }

    /// The next `length` bytes.
    fn word(&mut self, length: usize) -> &str {
        let (word, rest) = self.rest.split_at(length);
        self.rest = rest;
        word
    }

    fn number(&mut self) -> Checked<Expression> {
        let digits =
            |text: &str| text.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(text.len());
        let mut length = digits(self.rest);
        if let Some(power) = self.rest[length..].strip_prefix(['e', 'E']) {
            let sign = usize::from(power.starts_with(['+', '-']));
            let count = digits(&power[sign..]);
            length += if count > 0 { 1 + sign + count } else { 0 };
        }
        let word = self.word(length);
        word.parse().map(Expression::number).map_err(|_| format!("'{word}' is not a number"))
    }

    fn named(&mut self) -> Checked<Expression> {
        let end =
            self.rest.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(self.rest.len());
        let word = self.word(end).to_owned();
        match word.as_str() {
            "x" => return Ok(Expression(Arc::new(|[x, _]| x))),
            "y" => return Ok(Expression(Arc::new(|[_, y]| y))),
            "pi" => return Ok(Expression::number(std::f64::consts::PI)),
            "e" => return Ok(Expression::number(std::f64::consts::E)),
            _ => {}
        }
        if let Some(&(_, f)) = ONE.iter().find(|(name, _)| *name == word) {
            let [a] = self.arguments(&word)?;
            Ok(Expression(Arc::new(move |point| f(a.at(point)))))
        } else if let Some(&(_, f)) = TWO.iter().find(|(name, _)| *name == word) {
            let [a, b] = self.arguments(&word)?;
            Ok(Expression::two(f, a, b))
        } else {
            let known: Vec<&str> = ONE.iter().map(|f| f.0).chain(TWO.map(|f| f.0)).collect();
            Err(format!("unknown name '{word}': expected x, y, pi, e, {}", known.join(", ")))
        }
    }

    /// ( sum {, sum} ), with the given number of arguments.
    fn arguments<const N: usize>(&mut self, of: &str) -> Checked<[Expression; N]> {
        if !self.takes('(') {
            return Err(format!("'{of}' needs its argument in parentheses: {of}(..)"));
        }
        let mut arguments = vec![self.sum()?];
        while self.takes(',') {
            arguments.push(self.sum()?);
        }
        if !self.takes(')') {
            let is_open = self.rest.is_empty();
            return Err(if is_open {
                "a parenthesis is not closed".to_owned()
            } else {
                self.two_in_a_row()
            });
        }
        let wrong =
            |found: Vec<_>| format!("number of arguments of {of}: {}, expected {N}", found.len());
        arguments.try_into().map_err(wrong)
    }
}

fn unknown_character(c: char) -> String {
    format!("unknown character '{c}': expected + - * / ^ or parentheses")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn expressions_mean_what_they_mean_on_paper() {
        let (x, y) = (0.75_f64, -1.5_f64);
        let pi = std::f64::consts::PI;
        let cases: [(&str, f64); 23] = [
            ("-x^2", -x * x),
            ("2 - x^2*3", 2.0 - x * x * 3.0),
            ("(-x)^2", x * x),
            ("1e-3*x", 1e-3 * x),
            ("2.5E+2 + .5", 250.5),
            ("-cos(pi*x) - 0.5", -(pi * x).cos() - 0.5),
            ("max(x, y) + min(-x^2, y)", x + y),
            ("atan2(y, x)*2", 2.0 * y.atan2(x)),
            ("x/y*3", x / y * 3.0),
            ("x - y - 1 + 2", x - y + 1.0),
            ("exp(-x^2)", (-x * x).exp()),
            ("2^(-1)", 0.5),
            ("(2^3)^2 + 2^(3^2)", 576.0),
            ("x^2 + y^2", x * x + y * y),
            ("log(e)+ln(e^2)+log10(100)", 5.0),
            ("abs(y)*signum(y)", y),
            ("2*10^-2", 0.02),
            ("x^-1", 1.0 / x),
            ("e^-x", (-x).exp()),
            ("-x^-2", -1.0 / (x * x)),
            ("x^+2 - 1", x * x - 1.0),
            ("3*e^-(x^2)/2", 1.5 * (-x * x).exp()),
            ("2^-x*y", 2f64.powf(-x) * y),
        ];
        for (text, value) in cases {
            let found = Expression::parse(text).unwrap().at([x, y]);
            assert!(
                (found - value).abs() <= 4.0 * f64::EPSILON * value.abs().max(1.0),
                "{text}: {found}"
            );
        }
        for (text, value) in
            [("signum(max(x - 0.5, 0))", 0.0), ("signum(-0*x)", 0.0), ("signum(x - 1)", -1.0)]
        {
            assert_eq!(Expression::parse(text).unwrap().at([0.25, 0.0]), value, "{text}");
        }
        assert!(Expression::parse("sqrt(-1 - x^2)").unwrap().at([0.0, 0.0]).is_nan());
        let list = Expression::parse_list("max(x, 1), -y").unwrap();
        assert_eq!((list.len(), list[0].at([3.0, 0.0]), list[1].at([0.0, 2.0])), (2, 3.0, -2.0));
    }

    #[test]
    fn what_is_not_clear_is_refused_in_one_line() {
        let faults = [
            ("x + z", "unknown name 'z': expected x, y, pi, e, abs"),
            ("sin x", "'sin' needs its argument in parentheses"),
            ("2*-x", "two signs in a row"),
            ("2^--1", "two signs in a row"),
            ("2^-", "ends too early"),
            ("e^-x^2", "two powers in a row"),
            ("x**2", "a power is x^2"),
            ("2^3^2", "two powers in a row"),
            ("max(x)", "number of arguments of max: 1, expected 2"),
            ("sin(x, y)", "number of arguments of sin: 2"),
            ("(x, y)", "number of arguments of a parenthesis: 2"),
            ("(x", "is not closed"),
            ("x)", "unmatched closing"),
            ("", "is empty"),
            ("*x", "nothing before it"),
            ("x*", "ends too early"),
            ("2x", "operator missing"),
            ("x y", "operator missing"),
            ("2 (x)", "operator missing"),
            ("(x y)", "operator missing"),
            ("x & y", "unknown character '&'"),
            ("x<1", "unknown character '<': expected + - * / ^"),
            ("0.1 N", "operator missing before 'N'"),
            ("&", "unknown character '&'"),
            ("1.2.3", "is not a number"),
            ("{x}", "unknown character"),
            ("sin()", "nothing before it"),
            ("1e", "operator missing"),
        ];
        for (text, why) in faults {
            let error = Expression::parse(text).err().unwrap().to_string();
            assert!(error.contains(why) && !error.contains('\n'), "{text}: {error}");
        }
        for depth in [60, 900] {
            let deep = "(".repeat(depth) + "x" + &")".repeat(depth);
            assert!(Expression::parse(&deep).is_err());
        }
        assert!(Expression::parse(&"x+".repeat(2000)).is_err());
    }
}
