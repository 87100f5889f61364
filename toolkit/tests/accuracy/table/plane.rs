//! Norms in the plane.

use super::SplitMix;
use super::{Family, ask, draw, number, order, order_of, rows};
use fractional_sobolev::{Estimate, Function, Gram, Result, Triangles, Work, closed_forms};
use serde_json::Value;

const REFERENCE: &str = include_str!("../../reference/plane_reference.json");

/// All of them.
pub(super) fn families(each: usize, random: &mut SplitMix) -> Result<Vec<Family>> {
    let reference = rows(REFERENCE)?;
    let cases = reference["cases"].as_array().into_iter().flatten();
    let meshes = cases.filter(|row| row["case"] == "P1 on mesh" || row["case"] == "P0 on mesh");
    let meshes = meshes.map(|row| {
        let order = order_of(row, "s")?;
        let mesh = Triangles::new(points(row)?, triangles(row)?)?;
        let values: Vec<f64> = numbers(&row["values"])?;
        let is_linear = row["case"] == "P1 on mesh";
        let w = Function::on_triangles(&mesh, usize::from(is_linear), &values)?;
        // Twelve digits of the square.
        let square = number(row, "seminorm_sq")?;
        let exact = Estimate::new(square, 1e-12 * square, Work::default())?.sqrt()?;
        Ok((exact, ask(move |t| w.seminorm(order, t))))
    });
    let meshes = meshes.collect::<Result<Vec<_>>>()?;
    let grids = draw(each.min(8), || {
        let (order, n) = (order(random, 0.05, 0.95)?, 1 + random.below(4));
        let mesh = Triangles::grid([n, n], 1.0 / n as f64)?;
        let values: Vec<f64> = mesh.nodes().iter().map(|p| p[0]).collect();
        let w = Function::on_triangles(&mesh, 1, &values)?;
        Ok((
            closed_forms::coordinate_on_square_seminorm_squared(order)?.sqrt()?,
            ask(move |t| w.seminorm(order, t)),
        ))
    })?;
    let closures = draw(each.min(4), || {
        let order = order(random, 0.05, 0.95)?;
        let w = Function::from_plane_positions(&Triangles::grid([1, 1], 1.0)?, &[], |at| at.x()[0])?;
        Ok((
            closed_forms::coordinate_on_square_seminorm_squared(order)?.sqrt()?,
            ask(move |t| w.seminorm(order, t)),
        ))
    })?;
    let products = draw(each.min(8), || {
        let (order, n) = (order(random, 0.05, 0.95)?, 1 + random.below(16));
        let x: Vec<f64> = (0..(n + 1) * (n + 1)).map(|k| (k % (n + 1)) as f64 / n as f64).collect();
        let product = move |t: fractional_sobolev::Tolerance| {
            let form = Gram::on_grid([n, n], 1.0 / n as f64, order, t)?;
            let squared: f64 = form.apply(&x)?.iter().zip(&x).map(|(a, b)| a * b).sum();
            Estimate::new(squared, t.relative() * squared, Work::default())
        };
        Ok((closed_forms::coordinate_on_square_seminorm_squared(order)?, ask(product)))
    })?;
    Ok(vec![
        Family { name: "plane mesh", least: 0.0, cases: meshes },
        Family { name: "plane grid", least: 0.0, cases: grids },
        Family { name: "plane u", least: 0.0, cases: closures },
        Family { name: "grid product", least: 0.0, cases: products },
    ])
}

fn numbers(row: &Value) -> Result<Vec<f64>> {
    let list = row.as_array().into_iter().flatten().map(Value::as_f64);
    Ok(list.collect::<Option<Vec<f64>>>().expect("a list of numbers in a reference file"))
}

fn points(row: &Value) -> Result<Vec<[f64; 2]>> {
    let list = row["points"].as_array().into_iter().flatten();
    list.map(|point| numbers(point).map(|p| [p[0], p[1]])).collect()
}

fn triangles(row: &Value) -> Result<Vec<[usize; 3]>> {
    let list = row["triangles"].as_array().into_iter().flatten();
    list.map(|nodes| numbers(nodes).map(|n| [n[0] as usize, n[1] as usize, n[2] as usize])).collect()
}
