//! Observed orders of convergence.

use signorini::{Error, Result, ToolkitError};

/// ln(e_{k−1}/e_k) / ln(h_{k−1}/h_k) between successive levels; `None` for the first, and where an error is
/// not positive.
///
/// # Errors
/// [`ToolkitError::LengthMismatch`](signorini::ToolkitError::LengthMismatch) unless there is one error per mesh size.
pub fn observed_orders(mesh_sizes: &[f64], errors: &[f64]) -> Result<Vec<Option<f64>>> {
    if mesh_sizes.len() != errors.len() {
        return Err(Error::Toolkit(ToolkitError::LengthMismatch {
            name: "errors",
            given: errors.len(),
            expected: mesh_sizes.len(),
        }));
    }
    let order = |k: usize| {
        let k0 = k.checked_sub(1)?;
        let order = (errors[k0] / errors[k]).ln() / (mesh_sizes[k0] / mesh_sizes[k]).ln();
        (errors[k0] > 0.0 && errors[k] > 0.0 && order.is_finite()).then_some(order)
    };
    Ok((0..errors.len()).map(order).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn orders_of_a_power_law() {
        let h = [0.5, 0.25, 0.125];
        let errors = h.map(|h: f64| 3.0 * h.powf(0.75));
        let orders = observed_orders(&h, &errors).unwrap();
        assert_eq!(orders[0], None);
        assert!(orders[1..].iter().all(|p| p.is_some_and(|p| (p - 0.75).abs() < 1e-14)));
    }
}
