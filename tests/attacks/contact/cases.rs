//! Bodies with λ/μ = 5·10⁹ and 10⁶ whose triangles have aspect ratio 10⁴, with J by a computation in 60 digits.

use serde_json::Value;
use signorini::cone::Cone;
use signorini::contact::{ContactProblem, Solver};
use signorini::fem::{Form, Lame};
use signorini::mesh::{BoundaryEdge, Part, Triangulation};

/// The energies are given to twelve digits.
const GIVEN: f64 = 1e-11;

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect()
}

fn problem(case: &Value) -> ContactProblem {
    let nodes: Vec<[f64; 2]> =
        case["nodes"].as_array().unwrap().iter().map(|p| numbers(p).try_into().unwrap()).collect();
    let counts = |value: &Value| numbers(value).into_iter().map(|x| x as usize).collect::<Vec<_>>();
    let triangles: Vec<[usize; 3]> =
        case["tri"].as_array().unwrap().iter().map(|t| counts(t).try_into().unwrap()).collect();
    let (order, held) = (counts(&case["order"]), counts(&case["dir"]));
    let sides = |t: &[usize; 3]| [[t[0], t[1]], [t[1], t[2]], [t[2], t[0]]];
    let all: Vec<[usize; 2]> = triangles.iter().flat_map(sides).collect();
    let part = |[a, b]: [usize; 2]| match () {
        () if order.windows(2).any(|pair| pair == [a, b]) => Part::Contact,
        () if held[a] == 1 && held[b] == 1 => Part::Dirichlet,
        () => Part::Neumann,
    };
    let outer = all.iter().filter(|[a, b]| !all.contains(&[*b, *a]));
    let boundary: Vec<BoundaryEdge> =
        outer.map(|&nodes| BoundaryEdge { nodes, part: part(nodes) }).collect();
    let mesh = Triangulation::new(&nodes, &triangles, &boundary).unwrap();
    let [lambda, mu] = ["lambda", "mu"].map(|name| case[name].as_f64().unwrap());
    let form = Form::elastic(Lame::new(lambda, mu).unwrap());
    let mut problem = ContactProblem::new(mesh, form, &vec![0.0; 2 * nodes.len()]).unwrap();
    assert_eq!(problem.edge().nodes(), order);
    problem.add_load(&numbers(&case["load"])).unwrap();
    let mut gap = numbers(&case["gap"]).into_iter();
    problem.set_gap(|_| gap.next().unwrap()).unwrap();
    problem
}

#[test]
fn ill_conditioned_energies_of_60_digits() {
    let cases: Vec<Value> =
        serde_json::from_str(include_str!("../../data/ill_conditioned_contact.json")).unwrap();
    for case in &cases {
        let (problem, exact) = (problem(case), case["energy_60_digits"].as_f64().unwrap());
        let cone: Cone = case["cone"].as_str().unwrap().parse().unwrap();
        for solver in [Solver::ActiveSet, Solver::InteriorPoint, Solver::Multigrid, Solver::Auto] {
            let found = problem.solve(cone, solver).unwrap();
            let off = (found.energy - exact).abs();
            println!(
                "{solver}, {cone}: {:e} ± {:.1e}, off by {off:.1e}",
                found.energy, found.energy_rounding
            );
            assert!(
                off <= found.energy_rounding + GIVEN * exact.abs(),
                "{solver}, {cone}: {}",
                found.energy
            );
            assert!(
                found.energy_rounding <= GIVEN * exact.abs(),
                "{solver}: {:e}",
                found.energy_rounding
            );
        }
    }
}
