//! A companion to one paper, and a fractional-Sobolev toolkit that stands on its own.
//!
//! The paper is P. Hild and Y. Renard, *An improved a priori error analysis for finite element approximations of
//! Signorini's problem*, SIAM J. Numer. Anal. 50 (2012) 2400-2419. It holds no computation; every number here is new.
//! The modules follow its table of contents.
//!
//! | paper | room |
//! | --- | --- |
//! | every number | [`estimate`] (the speed-accuracy knob), [`error`], [`quadrature`] |
//! | Section 1, (1.1): norms of fractional order on intervals | [`sobolev`] |
//! | Section 2: domains and forms | [`mesh`], [`fem`] |
//! | Section 2, (4.1): the discrete problem, its cones and solvers | [`contact`] |
//! | Section 2: examples of problems | [`scenes`] |
//! | Appendix A, Lemma 5.2: Poincaré constants | [`poincare`] |
//! | Appendix B, (4.6), (4.7), Remarks 2 and 4: interpolation, projection, embeddings | [`interpolation`] |
//! | Section 2 on a strip, reduced to its contact edge | [`strip`] |
//! | Sections 3 and 4: alternatives, consistency terms | [`analysis`] |
//! | Introduction, Theorems 3.1 and 4.1, Figure 3.1: rates old, new and measured | [`analysis::RateStudy`], [`analysis::TheoremPlan`] |
//! | why no contact set is bad | [`analysis::worst_ratio`] |
//! | what is printed and drawn | [`report`], [`figures`] |
//!
//! All quantities are nondimensional unless said otherwise. Arrows between rooms point downwards only.
#![warn(unreachable_pub)]
#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::panic))]

pub mod analysis;
#[cfg(doctest)]
mod book;
pub mod contact;
pub mod error;
pub mod estimate;
pub mod fem;
pub mod figures;
pub mod interpolation;
pub mod mesh;
pub mod poincare;
pub mod quadrature;
pub mod report;
pub mod scenes;
pub mod sobolev;
pub mod strip;

pub use error::{Error, Result};
pub use estimate::{Estimate, Tolerance, Work};
