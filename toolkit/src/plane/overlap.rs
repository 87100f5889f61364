//! Triangles that have interior points in common.

use super::geometry::{Point, length, minus, twice_area};

/// Number of boxes up to which all pairs are compared.
const FEW: usize = 24;
/// Largest depth of subdivision of a set of boxes.
const DEEPEST: u32 = 40;
/// Largest overlap that is attributed to rounding, relative to the smaller height of two triangles.
const ROUNDING: f64 = 1e-6;

/// The lower and upper ends of the smallest axis-parallel rectangle that contains a triangle.
type Rectangle = [[f64; 2]; 2];

/// Two triangles that overlap, or `None`. Cost: O(n log n) if no triangles overlap.
pub(super) fn overlapping(triangles: &[[Point; 3]]) -> Option<[usize; 2]> {
    let rectangle = |t: &[Point; 3]| -> Rectangle {
        [0, 1].map(|k| {
            let low = t.iter().map(|p| p[k]).fold(f64::INFINITY, f64::min);
            [low, t.iter().map(|p| p[k]).fold(f64::NEG_INFINITY, f64::max)]
        })
    };
    let rectangles: Vec<Rectangle> = triangles.iter().map(rectangle).collect();
    among(triangles, &rectangles, (0..triangles.len()).collect(), 0)
}

/// Two overlapping triangles among the given ones, which are bisected recursively.
fn among(
    triangles: &[[Point; 3]],
    rectangles: &[Rectangle],
    mut of: Vec<usize>,
    depth: u32,
) -> Option<[usize; 2]> {
    let span = |k: usize| {
        let ends = of.iter().map(|&t| rectangles[t][k]);
        ends.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], [c, d]| [a.min(c), b.max(d)])
    };
    let axis = usize::from(span(1)[1] - span(1)[0] > span(0)[1] - span(0)[0]);
    let center = |t: usize| 0.5 * rectangles[t][axis][0] + 0.5 * rectangles[t][axis][1];
    if of.len() > FEW && depth < DEEPEST {
        let half = of.len() / 2;
        of.select_nth_unstable_by(half, |&a, &b| center(a).total_cmp(&center(b)));
        let cut = center(of[half]);
        let left: Vec<usize> =
            of.iter().copied().filter(|&t| rectangles[t][axis][0] < cut).collect();
        let right: Vec<usize> =
            of.iter().copied().filter(|&t| rectangles[t][axis][1] > cut).collect();
        if left.len() + right.len() <= of.len() + of.len() / 2 {
            let found = among(triangles, rectangles, left, depth + 1);
            return found.or_else(|| among(triangles, rectangles, right, depth + 1));
        }
    }
    of.sort_unstable_by(|&a, &b| rectangles[a][axis][0].total_cmp(&rectangles[b][axis][0]));
    for (k, &a) in of.iter().enumerate() {
        for &b in
            of[k + 1..].iter().take_while(|&&b| rectangles[b][axis][0] < rectangles[a][axis][1])
        {
            let [[low, high], [from, to]] = [rectangles[a][1 - axis], rectangles[b][1 - axis]];
            if from < high && low < to && share_points(&triangles[a], &triangles[b]) {
                return Some([a.min(b), a.max(b)]);
            }
        }
    }
    None
}

/// True if the two triangles have interior points in common: no line along an edge of one separates it from the
/// other.
fn share_points(a: &[Point; 3], b: &[Point; 3]) -> bool {
    let height = |t: &[Point; 3]| {
        let longest = (0..3).map(|k| length(minus(t[k], t[(k + 1) % 3]))).fold(0.0, f64::max);
        twice_area(t[0], t[1], t[2]).abs() / longest
    };
    let allowed = -ROUNDING * height(a).min(height(b));
    let parts = |a: &[Point; 3], b: &[Point; 3]| {
        (0..3).any(|k| {
            let (p, q) = (a[k], a[(k + 1) % 3]);
            let inner = twice_area(p, q, a[(k + 2) % 3]).signum();
            let outer = b.iter().map(|&r| -inner * twice_area(p, q, r) / length(minus(p, q)));
            outer.fold(f64::INFINITY, f64::min) >= allowed
        })
    };
    !parts(a, b) && !parts(b, a)
}
