//! |v|²_ν of a trace on a contact segment, by fast products with the Gram matrix of a uniform mesh; one
//! [`SeminormForm`] serves all segments of a mesh, because |v|²_{ν,T} = h_e^{1−2ν} |ṽ|²_ν on the reference
//! interval. Cost O(K log K) for K cells. The test below compares it with the seminorm of the function on the segment.

use super::pair::{Segment, Traces};
use crate::error::{Error, Result, ToolkitError};
use crate::numeric::check::require_length;
use fractional_sobolev::{Estimate, Gram, Mesh, Order, Tolerance, Work};

/// Relative rounding error of the fast product, with respect to Σ a_ii x_i².
const PRODUCT: f64 = 1e-13;

/// |·|²_ν on segments of K equal cells.
#[derive(Debug)]
pub(super) struct SeminormForm {
    order: Order,
    cells: usize,
    /// The operator on (0, 1); `None` for a single constant.
    operator: Option<Gram>,
}

impl SeminormForm {
    /// The form for segments of `cells` cells.
    ///
    /// # Errors
    /// [`ToolkitError::InfiniteNorm`](crate::ToolkitError::InfiniteNorm) for piecewise constants and ν ≥ 1/2;
    /// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) without cells.
    pub(super) fn new(traces: Traces, order: Order, cells: usize) -> Result<Self> {
        if traces == Traces::Constants && order.offset() >= 0.0 {
            return Err(Error::Toolkit(ToolkitError::InfiniteNorm {
                order: order.value(),
                why: "a function with a jump is not in H^nu for nu >= 1/2",
            }));
        }
        let partition = Mesh::uniform(cells, 1.0)?;
        let operator = match traces {
            Traces::Constants if cells == 1 => None,
            Traces::Constants => Some(Gram::constants(&partition, order, Tolerance::reference())?),
            Traces::Linears => Some(Gram::new(&partition, order, Tolerance::reference())?),
        };
        Ok(Self { order, cells, operator })
    }

    /// |v|²_{ν,T} of the trace with values `ends` at the ends of the cells of the segment.
    ///
    /// # Errors
    /// [`ToolkitError::LengthMismatch`](crate::ToolkitError::LengthMismatch) for a segment of another number of cells.
    pub(super) fn squared(&self, segment: &Segment<'_>, ends: &[[f64; 2]]) -> Result<Estimate> {
        require_length("cells of the segment", ends.len(), self.cells)?;
        let x = segment.coefficients(ends);
        let is_constant = x.iter().all(|&v| v == x[0]);
        let Some(operator) = self.operator.as_ref().filter(|_| !is_constant) else {
            return Ok(Estimate::new(0.0, 0.0, Work::default())?);
        };
        let mean = x.iter().sum::<f64>() / x.len() as f64;
        let product = operator.apply(&x)?;
        // The form vanishes on constants: subtracting the mean is exact and reduces rounding errors.
        let form: f64 = product.iter().zip(&x).map(|(y, v)| y * (v - mean)).sum();
        let size: f64 =
            operator.diagonal()?.iter().zip(&x).map(|(a, v)| a * (v - mean).powi(2)).sum();
        let scale = segment.length().powf(-2.0 * self.order.offset());
        Ok(Estimate::new(scale * form.max(0.0), scale * PRODUCT * size, Work::default())?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::edge::ContactPair;
    use crate::problems::StripData;
    use crate::strip::LateralCondition;
    use fractional_sobolev::Function;

    /// Largest relative difference; the rounding errors of nearly constant traces are larger than of others.
    const METHODS: f64 = 1e-8;

    /// |v|²_ν of the piecewise polynomial on the segment itself.
    fn of_function(ends: &[[f64; 2]], length: f64, order: Order) -> f64 {
        let mesh = Mesh::uniform(ends.len(), length).unwrap();
        let values: Vec<f64> = ends.iter().flatten().map(|v| v - ends[0][0]).collect();
        let function = Function::piecewise(&mesh, 1, &values).unwrap();
        let found = function.seminorm(order, 1e-10);
        found.unwrap_or_else(|error| error.best().unwrap()).value.powi(2)
    }

    #[test]
    fn seminorms_on_a_segment_are_those_of_functions() {
        let mut compared = 0;
        for (tau, nu) in [(1.6, 0.1), (1.75, 0.25), (1.75, 0.45), (2.0, 0.5), (2.0, 0.75)] {
            let order = Order::new(nu).unwrap();
            let traces = if nu < 0.5 { Traces::Constants } else { Traces::Linears };
            for source in ["transition", "transitions:9", "cantor:0.3"] {
                let source: StripData = source.parse().unwrap();
                let edge_data = source.data(tau, 256, LateralCondition::Natural).unwrap();
                let pair = ContactPair::of_data(&edge_data, traces).unwrap();
                let all = pair.norms(8, order, 2.0).unwrap();
                for (segment, norms) in pair.segments(8).unwrap().zip(all) {
                    for (ends, trace) in
                        [(segment.pressures, norms.stress), (segment.slopes, norms.slope)]
                    {
                        // Nearly constant traces: the seminorm is known absolutely.
                        let scale = trace.seminorm_squared.value.max(1e-6 * trace.l2.powi(2));
                        if scale > 0.0 {
                            let direct = of_function(ends, segment.length(), order);
                            let apart = (direct - trace.seminorm_squared.value).abs();
                            assert!(apart <= METHODS * scale, "{source} {nu}: {trace:?}, {direct}");
                            compared += 1;
                        }
                    }
                }
            }
        }
        assert!(compared > 100, "{compared}");
    }
}
