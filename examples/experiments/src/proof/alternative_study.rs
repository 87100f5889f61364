//! The cases of Figure 3.2 or 4.1, over mesh sizes or over θ, on the contact set of a fine reference or of
//! u_h itself.

use signorini::cone::Cone;
use signorini::edge::EdgeTrace;
use signorini::problems::NamedProblem;
use signorini::proof::Classification;
use signorini::proof::Section;
use signorini::proof::ThetaRule;
use signorini::{Error, Result, ToolkitError};
use std::fmt;
use std::str::FromStr;

/// Most meshes of a study.
const MESHES: usize = 16;
/// θ of a sweep: 2^{−1}, ..., 2^{−12}.
const SWEEP: i32 = 12;

/// On whose contact set the cases are decided.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Against {
    /// The fine reference: the paper's u.
    Reference,
    /// The discrete solution of each mesh.
    Itself,
}

/// What is classified.
#[derive(Debug, Clone, PartialEq)]
pub struct AlternativeCase {
    /// Which alternative.
    pub section: Section,
    /// The scene.
    pub source: NamedProblem,
    /// Contact segments of the finest mesh.
    pub n: usize,
    /// How many meshes, each with half the segments of the next.
    pub meshes: usize,
    /// θ.
    pub rule: ThetaRule,
    /// Regularity of a strip scene; mesh scenes bring their own.
    pub tau: f64,
    /// On whose contact set.
    pub against: Against,
}

impl Against {
    /// The other contact set.
    pub fn other(self) -> Self {
        match self {
            Against::Reference => Against::Itself,
            Against::Itself => Against::Reference,
        }
    }
}

impl AlternativeCase {
    /// Three meshes of a scene at τ = 7/4 on its fine reference.
    pub fn new(section: Section, source: impl Into<NamedProblem>, n: usize, rule: ThetaRule) -> Self {
        Self { section, source: source.into(), n, meshes: 3, rule, tau: 1.75, against: Against::Reference }
    }

    /// Classifies every contact segment of the meshes ..., n/4, n/2, n.
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](signorini::ToolkitError::CountOutOfRange) unless n is a power of two times the coarsest mesh, which has at least two
    /// segments, and within the largest of the source; [`ToolkitError::OutOfRange`](signorini::ToolkitError::OutOfRange) for τ or θ.
    pub fn over_size(&self) -> Result<AlternativeStudy> {
        self.check()?;
        let meshes: Vec<usize> = (0..self.meshes).rev().map(|level| self.n >> level).collect();
        // A bad θ or τ is found before the work.
        let thetas = meshes.iter().map(|&m| self.rule.theta(1.0 / m as f64)).collect::<Result<Vec<f64>>>()?;
        self.classify(meshes.into_iter().zip(thetas).collect())
    }

    /// Classifies the n segments of the finest mesh for θ = 1/2, 1/4, ..., 2⁻¹².
    ///
    /// # Errors
    /// As [`AlternativeCase::over_size`].
    pub fn over_theta(&self) -> Result<AlternativeStudy> {
        self.check()?;
        self.classify((1..=SWEEP).map(|k| (self.n, 0.5f64.powi(k))).collect())
    }

    fn check(&self) -> Result<()> {
        let count = |name, value, range| Error::Toolkit(ToolkitError::CountOutOfRange { name, value, range });
        if !(1..=MESHES).contains(&self.meshes) {
            return Err(count("meshes", self.meshes, "[1, 16]"));
        }
        let parts = 1 << (self.meshes - 1);
        let powers = matches!(self.source, NamedProblem::Mesh(_)) || self.n.is_power_of_two();
        if self.n < 2 * parts
            || !self.n.is_multiple_of(parts)
            || self.n > EdgeTrace::largest_segments(&self.source)
            || !powers
        {
            let range = "the multiples of 2^(meshes - 1), at least 2^meshes, at most 256 on a mesh; powers of two up to 16384 on a strip";
            return Err(count("n", self.n, range));
        }
        Ok(())
    }

    fn classify(&self, cases: Vec<(usize, f64)>) -> Result<AlternativeStudy> {
        let cone = if self.section == Section::Three { Cone::Nodal } else { Cone::Midpoint };
        let trace_of = |n| match self.against {
            Against::Reference => EdgeTrace::reference(&self.source, self.n, self.tau),
            Against::Itself => EdgeTrace::discrete(&self.source, n, self.tau, cone),
        };
        let mut trace = trace_of(cases[0].0)?;
        let mut traced = cases[0].0;
        let mut rows = Vec::new();
        for (n, theta) in cases {
            if self.against == Against::Itself && n != traced {
                (trace, traced) = (trace_of(n)?, n);
            }
            let vertices: Vec<f64> = (0..=n).map(|i| i as f64 / n as f64).collect();
            let classification = Classification::new(self.section, &trace, &vertices, theta)?;
            rows.push(AlternativeRow { n, theta, classification });
        }
        Ok(AlternativeStudy { case: self.clone(), trace, rows })
    }
}

/// One mesh and θ of a study.
#[derive(Debug, Clone, PartialEq)]
pub struct AlternativeRow {
    /// Contact segments per unit length.
    pub n: usize,
    /// θ.
    pub theta: f64,
    /// The contact segments.
    pub classification: Classification,
}

/// Classified segments for several mesh sizes or several θ.
#[derive(Debug, Clone, PartialEq)]
pub struct AlternativeStudy {
    /// What was asked.
    pub case: AlternativeCase,
    /// The trace of the last row.
    pub trace: EdgeTrace,
    /// Coarsest mesh first, or largest θ first.
    pub rows: Vec<AlternativeRow>,
}

impl fmt::Display for Against {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Against::Reference => "reference",
            Against::Itself => "itself",
        })
    }
}

impl FromStr for Against {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        match text {
            "reference" => Ok(Against::Reference),
            "itself" => Ok(Against::Itself),
            _ => Err(Error::Toolkit(ToolkitError::UnknownName {
                what: "solution to classify on",
                given: text.to_owned(),
                expected: "reference or itself",
            })),
        }
    }
}
