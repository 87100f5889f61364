//! Increasing piecewise linear derivatives F' with reflection, addition and truncation at their zeros.
//!
//! The pieces are kept in a deque in coordinates that absorb reflection and addition, so that each is created
//! and removed once: n steps cost O(n).

use std::collections::VecDeque;

/// One piece, between breakpoints, in stored coordinates: F' = (slope + count)·t + (intercept + shift).
#[derive(Clone, Copy)]
struct Piece {
    left: f64,
    slope: f64,
    intercept: f64,
}

/// The zero function F' = 0.
const FLAT: Piece = Piece { left: f64::NEG_INFINITY, slope: 0.0, intercept: 0.0 };

/// F_i' with its reflections and additions so far: t is stored as σ t + offset, F' as σ F'.
pub(super) struct Derivative {
    pieces: VecDeque<Piece>,
    sigma: f64,
    offset: f64,
    /// Added to the slope of every piece; `shift` is added to every intercept.
    count: f64,
    shift: f64,
}

impl Derivative {
    pub(super) fn flat() -> Self {
        Self { pieces: VecDeque::from([FLAT]), sigma: 1.0, offset: 0.0, count: 0.0, shift: 0.0 }
    }

    /// F'(t) ← −F'(c − t).
    pub(super) fn reflect(&mut self, c: f64) {
        self.offset += self.sigma * c;
        self.sigma = -self.sigma;
    }

    /// F'(t) ← F'(t) + d (t − z).
    pub(super) fn add(&mut self, d: f64, z: f64) {
        self.count += d;
        self.shift -= d * (self.offset + self.sigma * z);
    }

    /// Replaces the positive part by zero; returns the zero of F'.
    ///
    /// F_i' ← min(F_i', 0): the derivative of t ↦ F_i(min(t, m_i)); the minimiser m_i is returned. Amortised O(1):
    /// each piece is removed once.
    pub(super) fn cut(&mut self) -> f64 {
        let zero = if self.sigma > 0.0 { self.cut_right() } else { self.cut_left() };
        self.sigma * (zero - self.offset)
    }

    /// F' may jump where a chain begins after a fixed node: if the zero of a linear piece lies beyond the piece, the
    /// zero of F' is the end of the piece.
    fn cut_right(&mut self) -> f64 {
        let (mut zero, mut end) = (f64::NEG_INFINITY, f64::INFINITY);
        while let Some(&piece) = self.pieces.back() {
            zero = (-(piece.intercept + self.shift) / (piece.slope + self.count)).min(end);
            if zero >= piece.left {
                break;
            }
            (zero, end) = (piece.left, piece.left);
            self.pieces.pop_back();
        }
        self.pieces.push_back(Piece { left: zero, slope: -self.count, intercept: -self.shift });
        zero
    }

    fn cut_left(&mut self) -> f64 {
        let (mut zero, mut end) = (f64::INFINITY, f64::NEG_INFINITY);
        while let Some(&piece) = self.pieces.front() {
            let right = self.pieces.get(1).map_or(f64::INFINITY, |next| next.left);
            zero = (-(piece.intercept + self.shift) / (piece.slope + self.count)).max(end);
            if zero <= right {
                if let Some(front) = self.pieces.front_mut() {
                    front.left = zero;
                }
                break;
            }
            (zero, end) = (right, right);
            self.pieces.pop_front();
        }
        self.pieces.push_front(Piece {
            left: f64::NEG_INFINITY,
            slope: -self.count,
            intercept: -self.shift,
        });
        zero
    }

    /// Truncates F' at the first node of a chain, with a jump to zero at `limit`, and returns its zero.
    pub(super) fn cut_first(&mut self, limit: f64) -> f64 {
        let zero = self.cut();
        if zero <= limit {
            return zero;
        }
        if let Some(last) = self.pieces.back_mut() {
            last.left = limit;
        }
        limit
    }
}
