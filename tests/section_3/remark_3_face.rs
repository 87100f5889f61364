//! Remark 3: quotients on one face with gaps at its corners.

use fractional_sobolev::{Function, Order, Triangles};

/// The face with gaps of legs r at its corners, strips of equal shape towards each corner.
fn face(halvings: i32) -> (Triangles, Vec<f64>, Vec<f64>) {
    let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
    let near = |k: usize, j: usize, r: f64| {
        let (a, b) = (corners[k], corners[j % 3]);
        [a[0] + r * (b[0] - a[0]), a[1] + r * (b[1] - a[1])]
    };
    let (mut nodes, mut triangles, mut sigma, mut u) =
        (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    for k in 0..3 {
        nodes.push(near(k, k + 1, 0.5));
        u.push(0.0);
    }
    triangles.push([0, 1, 2]);
    sigma.push(-1.0);
    for (k, corner) in corners.into_iter().enumerate() {
        let (mut p, mut q) = (k, (k + 2) % 3); // on the sides to the next corner and to the one before
        for level in 2..=halvings + 1 {
            let r = 0.5f64.powi(level);
            let a = nodes.len();
            nodes.extend([near(k, k + 1, r), near(k, k + 2, r)]);
            u.extend([0.0; 2]);
            triangles.extend([[p, q, a], [q, a + 1, a]]);
            sigma.extend([-1.0; 2]);
            (p, q) = (a, a + 1);
        }
        triangles.push([nodes.len(), p, q]);
        nodes.push(corner);
        sigma.push(0.0);
        u.push(-1.0);
    }
    (Triangles::new(&nodes, &triangles).unwrap(), sigma, u)
}

/// The nodal quotient and that of means, from areas in closed form: gaps have the area r²/2.
fn quotients(nu: Order, halvings: i32) -> [f64; 2] {
    let (mesh, sigma, u) = face(halvings);
    let sigma = Function::on_triangles(&mesh, 0, &sigma).unwrap().seminorm(nu, 1e-6).unwrap().value;
    let slope =
        Function::on_triangles(&mesh, 1, &u).unwrap().seminorm(nu.plus_one(), 1e-6).unwrap().value;
    let gaps = 1.5 * 0.25f64.powi(halvings + 1);
    [(0.5 - gaps) / (sigma * slope), (0.5 - gaps) * (gaps / 3.0) / 0.5 / (sigma * slope)]
}

#[test]
fn the_nodal_quotient_grows_and_the_mean_quotient_falls() {
    for nu in [0.25, 0.4] {
        let order = Order::new(nu).unwrap();
        let found: Vec<[f64; 2]> = (1..13).map(|halvings| quotients(order, halvings)).collect();
        for pair in found.windows(2) {
            assert!(pair[1][0] > pair[0][0] && pair[1][1] < pair[0][1], "{nu}: {found:?}");
        }
        let exponent = (found[10][0] / found[11][0]).log2();
        assert!((exponent - (2.0 * nu - 1.0)).abs() < 0.01, "{nu}: {exponent}");
    }
    // σ jumps: not in H^{1/2}
    let (mesh, sigma, _) = face(3);
    assert!(Function::on_triangles(&mesh, 0, &sigma).unwrap().seminorm(Order::HALF, 1e-6).is_err());
}
