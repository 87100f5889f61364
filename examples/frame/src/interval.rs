//! Values of options that are bounded: refused on the command line, each of a list, before anything is
//! computed.

use std::str::FromStr;

/// What has a place on the line.
pub trait OnTheLine: FromStr<Err: std::fmt::Display> + Clone + Send + Sync + 'static {
    /// The place.
    fn place(&self) -> f64;
}

impl OnTheLine for f64 {
    fn place(&self) -> f64 {
        *self
    }
}

impl OnTheLine for usize {
    fn place(&self) -> f64 {
        *self as f64
    }
}

impl OnTheLine for u32 {
    fn place(&self) -> f64 {
        f64::from(*self)
    }
}

impl OnTheLine for fractional_sobolev::Order {
    fn place(&self) -> f64 {
        self.value()
    }
}

/// Reads a value that lies in an interval: square brackets hold their end, round ones do not.
///
/// ```
/// let read = example_frame::within::<f64>("(1.5, 2]");
/// assert_eq!(read("2"), Ok(2.0));
/// assert_eq!(read("1.5"), Err("not in (1.5, 2]".to_owned()));
/// assert!(read("NaN").is_err() && read("x").is_err());
/// ```
pub fn within<T: OnTheLine>(
    interval: &'static str,
) -> impl Fn(&str) -> Result<T, String> + Clone + Send + Sync + 'static {
    move |text| {
        let value: T = text.parse().map_err(|error: T::Err| error.to_string())?;
        let place = value.place();
        let is_inside = ends(interval).is_some_and(|[low, high]| {
            (place > low || interval.starts_with('[') && place == low)
                && (place < high || interval.ends_with(']') && place == high)
        });
        if is_inside { Ok(value) } else { Err(format!("not in {interval}")) }
    }
}

/// Refuses a list of numbers that does not increase.
///
/// # Errors
/// [`crate::Error::Option`] with the name of the option.
pub fn increasing(option: &str, numbers: &[f64]) -> crate::Result<()> {
    if numbers.is_sorted_by(|one, next| one < next) {
        return Ok(());
    }
    Err(crate::Error::Option(format!("{option}: expected numbers that increase")))
}

/// The ends; `None` of what is no interval, and then nothing lies in it.
fn ends(interval: &str) -> Option<[f64; 2]> {
    let inner = interval.strip_prefix(['(', '['])?.strip_suffix([')', ']'])?;
    let (low, high) = inner.split_once(',')?;
    Some([low.trim().parse().ok()?, high.trim().parse().ok()?])
}

#[cfg(test)]
mod tests {
    use super::*;
    use fractional_sobolev::Order;

    #[test]
    fn brackets_decide_about_the_ends() {
        let is_in = |interval, value| within::<f64>(interval)(value).is_ok();
        assert!(is_in("[0, 1]", "0") && is_in("[0, 1]", "1") && is_in("(0, 1)", "1e-300"));
        assert!(!is_in("(0, 1)", "0") && !is_in("(0, 1)", "1") && !is_in("[0, 1)", "1"));
        assert!(!is_in("[0, inf)", "inf") && !is_in("[0, 1]", "NaN") && !is_in("0, 1", "0.5"));
        assert_eq!(within::<usize>("[1, 16]")("16"), Ok(16));
        assert!(within::<usize>("[1, 16]")("17").is_err() && within::<usize>("[1, 16]")("-1").is_err());
        let upper = within::<Order>("(0.5, 1)");
        assert!(upper("1/2").is_err() && upper("1/2+0.1").is_ok());
    }
}
