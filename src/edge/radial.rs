//! A contact set as intervals in ln r, r the distance from the end of the edge.
//!
//! Between an active constraint and an inactive one, the end point is placed at the geometric mean of their radii: on
//! rings of ratio e^s it is resolved to s/2 in ln r.

use crate::cone::ContactSet;
use crate::error::Result;
use crate::numeric::check::{require_entry, require_finite, require_length};

/// A contact or non-contact interval of the edge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RadialInterval {
    /// Inner radius, in the unit of the given radii.
    pub from: f64,
    /// Outer radius.
    pub to: f64,
    /// True for contact.
    pub in_contact: bool,
}

impl RadialInterval {
    /// The number of decades: log₁₀ of the ratio of the outer to the inner radius.
    ///
    /// ```
    /// use signorini::edge::RadialInterval;
    /// let interval = RadialInterval { from: 1e-5, to: 1e-2, in_contact: true };
    /// assert!((interval.decades() - 3.0).abs() < 1e-14);
    /// ```
    pub fn decades(&self) -> f64 {
        self.to.log10() - self.from.log10()
    }
}

/// The contact and non-contact intervals, from the inside outwards; constraints at radius 0 (the end of the edge) are
/// omitted.
///
/// ```
/// use signorini::cone::ContactSet;
/// use signorini::edge::radial_intervals;
/// let set = ContactSet::new(&[false, true, true, false]);
/// let found = radial_intervals(&[0.0, 1e-4, 1e-2, 1.0], &set)?;
/// assert_eq!(found.len(), 2);
/// assert!(found[0].in_contact && (found[0].to - 0.1).abs() < 1e-15);
/// # Ok::<(), signorini::Error>(())
/// ```
///
/// # Errors
/// [`ToolkitError::LengthMismatch`](crate::ToolkitError::LengthMismatch) unless there is one radius per constraint,
/// [`ToolkitError::NotFinite`](crate::ToolkitError::NotFinite) for a radius that is not finite,
/// [`ToolkitError::EntryOutOfRange`](crate::ToolkitError::EntryOutOfRange) for radii that are negative or do not
/// increase.
pub fn radial_intervals(radii: &[f64], set: &ContactSet) -> Result<Vec<RadialInterval>> {
    require_length("radii", radii.len(), set.constraints())?;
    require_finite("radius", radii)?;
    for (k, &radius) in radii.iter().enumerate() {
        let above = if k == 0 { radius >= 0.0 } else { radius > radii[k - 1] };
        require_entry("radius", k, radius, "(previous radius, inf); [0, inf) at index 0", above)?;
    }
    let mut found: Vec<RadialInterval> = Vec::new();
    for (i, &radius) in radii.iter().enumerate().filter(|(_, radius)| **radius > 0.0) {
        let in_contact = set.contains(i);
        match found.last_mut() {
            Some(last) if last.in_contact == in_contact => last.to = radius,
            Some(last) => {
                // Square roots first: products of tiny radii underflow.
                let border = last.to.sqrt() * radius.sqrt();
                last.to = border;
                found.push(RadialInterval { from: border, to: radius, in_contact });
            }
            None => found.push(RadialInterval { from: radius, to: radius, in_contact }),
        }
    }
    Ok(found)
}
