//! Points of the plane: differences, products without cancellation, distances.

/// A point or a vector.
pub(super) type Point = [f64; 2];

/// The difference a − b.
pub(super) fn minus(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1]]
}

pub(super) fn dot(a: Point, b: Point) -> f64 {
    a[0].mul_add(b[0], a[1] * b[1])
}

pub(super) fn length(a: Point) -> f64 {
    a[0].hypot(a[1])
}

/// ab − cd with an error of a few units of 1e-32 of the products (Kahan).
pub(super) fn product_difference(a: f64, b: f64, c: f64, d: f64) -> f64 {
    let second = c * d;
    a.mul_add(b, -second) - c.mul_add(d, -second)
}

/// The rounded difference a − b and its rounding error (Knuth's exact difference).
fn exact_difference(a: f64, b: f64) -> (f64, f64) {
    let difference = a - b;
    let back = difference - a;
    (difference, (a - (difference - back)) - (b + back))
}

/// (b − a) × (c − a), twice the signed area of a triangle: the error is a few units of 1e-32 of the product of
/// the two lengths, so that it is accurate for a triangle with aspect ratio 1e6.
pub(super) fn twice_area(a: Point, b: Point, c: Point) -> f64 {
    let ((bx, bx_low), (by, by_low)) = (exact_difference(b[0], a[0]), exact_difference(b[1], a[1]));
    let ((cx, cx_low), (cy, cy_low)) = (exact_difference(c[0], a[0]), exact_difference(c[1], a[1]));
    let (first, second) = (bx * cy, by * cx);
    let (first_low, second_low) = (bx.mul_add(cy, -first), by.mul_add(cx, -second));
    let (high, high_low) = exact_difference(first, second);
    let low = bx * cy_low + bx_low * cy - by * cx_low - by_low * cx;
    high + (high_low + (first_low - second_low) + low)
}

/// The distance of a point from the segment ab, computed from the nearer end, so that small distances have full
/// relative accuracy.
pub(super) fn distance_from_segment(p: Point, a: Point, b: Point) -> f64 {
    let (first, second) = (minus(p, a), minus(p, b));
    let is_nearer = dot(first, first) <= dot(second, second);
    let (along, from) = if is_nearer { (minus(b, a), first) } else { (minus(a, b), second) };
    let squared = dot(along, along);
    if squared == 0.0 {
        return length(from);
    }
    let t = (dot(from, along) / squared).clamp(0.0, 1.0);
    length([from[0] - t * along[0], from[1] - t * along[1]])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_area_of_a_sliver_has_all_its_digits() {
        // 2^−30 is the area of the rounded points in rational arithmetic; products of differences are off by
        // 6e-8.
        let (x, height) = (1.0 / 3.0, 2f64.powi(-30));
        let (a, b, c) = ([x, x], [x + 1.0, x + 1.0], [x + 0.5, x + 0.5 + height]);
        let exact = height;
        assert!((twice_area(a, b, c) / exact - 1.0).abs() < 1e-15);
        let turned = twice_area([0.1, 0.3], [1.1, 1.7], [0.7, 1.14]);
        // (1.0)(0.84) − (1.4)(0.6) = 0 in decimals: what is left is the rounding of the six numbers.
        assert!(turned.abs() < 1e-15);
    }

    #[test]
    fn distances_end_at_the_ends() {
        assert_eq!(distance_from_segment([0.5, 2.0], [0.0, 0.0], [1.0, 0.0]), 2.0);
        assert_eq!(distance_from_segment([4.0, 4.0], [0.0, 0.0], [1.0, 0.0]), 5.0);
        assert_eq!(distance_from_segment([3.0, 4.0], [0.0, 0.0], [0.0, 0.0]), 5.0);
    }
}
