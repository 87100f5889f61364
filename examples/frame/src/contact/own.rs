//! A body of the user's own: mesh, load and material from the command line.

use crate::{Error, Expression, Result};
use clap::Args;
use experiments::contact_levels::{OwnBody, SceneRun};
use signorini::fem::{Field, Form, Lame};
use signorini::mesh::{Triangulation, parse_msh, read_msh};
use std::path::PathBuf;
use std::str::FromStr;

/// What may be one's own in a contact example.
#[derive(Debug, Clone, Default, Args)]
pub struct OwnOptions {
    /// A mesh of Gmsh (ASCII, format 4.1 or 2.2) with its curves in groups `clamped`, `contact`, `free`
    #[arg(long, value_name = "FILE.msh")]
    pub mesh: Option<PathBuf>,
    /// Volume load in x, y, pi and the usual functions: "fx, fy", of a scalar problem "f"
    #[arg(long, value_name = "EXPRESSIONS", allow_hyphen_values = true)]
    pub load: Option<Load>,
    /// "lambda=1, mu=1", or "E=2.5, nu=0.25" (plane strain; with "plane=stress" plane stress); once, or once
    /// for each physical surface
    #[arg(long, value_name = "CONSTANTS")]
    pub material: Vec<Material>,
    /// Write the rows and the contact edge (CSV, units in the header) into this directory
    #[arg(long, value_name = "DIR")]
    pub csv: Option<PathBuf>,
}

/// A volume load by its components.
#[derive(Debug, Clone)]
pub struct Load(Vec<Expression>);

impl Load {
    /// Two of an elastic body, one of a scalar problem.
    pub fn components(&self) -> usize {
        self.0.len()
    }
}

impl FromStr for Load {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        Expression::parse_list(text).map(Self).map_err(Error::Option)
    }
}

/// Lamé's constants of a material.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Material(pub Lame);

impl FromStr for Material {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        let expected =
            "expected \"lambda=.., mu=..\" or \"E=.., nu=..\", the latter with \"plane=stress\" if it is";
        let fault = |why: &str| Error::Option(format!("{why}: {expected}"));
        let (mut constants, mut is_stress) = ([None; 4], None);
        for part in text.split(',') {
            let (name, value) = part.split_once('=').ok_or_else(|| fault(&format!("'{}'", part.trim())))?;
            let (name, value) = (name.trim(), value.trim());
            if name == "plane" {
                let plane = match value {
                    "stress" => true,
                    "strain" => false,
                    _ => return Err(fault(&format!("plane '{value}' is neither strain nor stress"))),
                };
                if is_stress.replace(plane).is_some() {
                    return Err(fault("'plane' is given twice"));
                }
                continue;
            }
            let known = ["lambda", "mu", "E", "nu"];
            let place = known.iter().position(|known| *known == name);
            let place = place.ok_or_else(|| fault(&format!("unknown constant '{name}'")))?;
            let number: f64 = value.parse().map_err(|_| fault(&format!("'{value}' is not a number")))?;
            if constants[place].replace(number).is_some() {
                return Err(fault(&format!("'{name}' is given twice")));
            }
        }
        let lame = match (constants, is_stress) {
            ([Some(lambda), Some(mu), None, None], None) => Lame::new(lambda, mu)?,
            ([None, None, Some(young), Some(nu)], Some(true)) => Lame::plane_stress(young, nu)?,
            ([None, None, Some(young), Some(nu)], _) => Lame::plane_strain(young, nu)?,
            _ => return Err(fault("not a pair of constants")),
        };
        Ok(Self(lame))
    }
}

/// A body with all that is known of it.
#[derive(Debug, Clone)]
pub struct Own {
    /// What figures and titles call it.
    pub name: String,
    /// The coarsest mesh.
    pub mesh: Triangulation,
    /// Elasticity, or the scalar form.
    pub form: Form,
    load: Load,
    load_scale: f64,
    /// The angle by which mesh and load are turned, in degrees.
    turned: f64,
}

impl OwnOptions {
    /// True where mesh or load are the user's own.
    pub fn is_own(&self) -> bool {
        self.mesh.is_some() || self.load.is_some()
    }

    /// The body: on the mesh of the options or, without one, on this one with this form.
    ///
    /// # Errors
    /// Those of the mesh file; [`Error::Option`] for a load with the wrong number of components, no load, or
    /// materials that do not match the physical surfaces.
    pub fn body(
        &self,
        elsewhere: impl FnOnce() -> Result<(String, Triangulation)>,
        form: Form,
        load_scale: f64,
    ) -> Result<Own> {
        let (name, mesh) = match &self.mesh {
            Some(path) => {
                let stem = path.file_stem().unwrap_or_default().to_string_lossy();
                let is_plain = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
                (stem.chars().map(|c| if is_plain(c) { c } else { '_' }).collect(), read_msh(path)?)
            }
            None => elsewhere()?,
        };
        let components = form.components();
        let words =
            if components == 2 { "\"fx, fy\" of an elastic body" } else { "\"f\" of a scalar problem" };
        let Some(load) = self.load.clone() else {
            return Err(Error::Option(format!("--mesh needs --load, {words}")));
        };
        if load.0.len() != components {
            let given = load.0.len();
            return Err(Error::Option(format!("--load has {given} components, expected {words}")));
        }
        let form = self.own_form(form, &mesh)?;
        Ok(Own { name, mesh, form, load, load_scale, turned: 0.0 })
    }

    fn own_form(&self, form: Form, mesh: &Triangulation) -> Result<Form> {
        let given = self.material.len();
        if given == 0 {
            return Ok(form);
        }
        if form.components() == 1 {
            return Err(Error::Option("--material has no effect on a scalar problem".to_owned()));
        }
        let surfaces = mesh.regions().iter().max().map_or(1, |&last| last as usize + 1);
        if given != 1 && given != surfaces {
            let what =
                format!("{given} materials for {surfaces} physical surfaces: give one, or one for each");
            return Err(Error::Option(what));
        }
        Ok(Form::Elastic { materials: self.material.iter().map(|material| material.0).collect() })
    }
}

impl Own {
    /// The mesh in a text of Gmsh, for a body that comes with an example.
    ///
    /// # Errors
    /// Those of [`parse_msh`].
    pub fn sample(name: &str, text: &str) -> Result<(String, Triangulation)> {
        Ok((name.to_owned(), parse_msh(text)?))
    }

    /// The same body, mesh and load turned by an angle in degrees about the origin.
    ///
    /// # Errors
    /// Those of [`Triangulation::mapped`].
    pub fn turned(&self, degrees: f64) -> Result<Self> {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let mesh = self.mesh.clone().mapped(|[x, y]| [cos * x - sin * y, sin * x + cos * y])?;
        Ok(Self { mesh, turned: self.turned + degrees, ..self.clone() })
    }

    /// f at a point; a scalar load has second entry 0.
    pub fn load_at(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        if self.turned == 0.0 {
            return self.load_before([x, y]);
        }
        let (sin, cos) = self.turned.to_radians().sin_cos();
        let [f, g] = self.load_before([cos * x + sin * y, cos * y - sin * x]);
        if self.load.0.len() == 1 { [f, 0.0] } else { [cos * f - sin * g, sin * f + cos * g] }
    }

    fn load_before(&self, point: [f64; 2]) -> [f64; 2] {
        let value = |k: usize| self.load.0.get(k).map_or(0.0, |part| self.load_scale * part.at(point));
        [value(0), value(1)]
    }

    /// The resultants of load (by the rule of the solver, f itself), clamp and floors on the body of a
    /// solution; of a scalar problem in the first entry.
    ///
    /// # Errors
    /// [`fractional_sobolev::Error::NotFiniteAt`], and those of the normals.
    pub fn resultants(&self, run: &SceneRun) -> Result<[[f64; 2]; 3]> {
        let SceneRun { problem, solution, .. } = run;
        let (mesh, edge) = (problem.mesh(), problem.edge());
        let (rule, mut load) = (OwnBody::load_rule()?, [0.0; 2]);
        for t in 0..mesh.triangles().len() {
            rule.on(mesh.corners(t), &mut |point, weight| {
                let f = self.load_at(point);
                load = [load[0] + weight * f[0], load[1] + weight * f[1]];
                Ok(())
            })?;
        }
        let is_elastic = self.form.components() == 2;
        let normals = if is_elastic { edge.normals()? } else { vec![[1.0, 0.0]; edge.pieces().len()] };
        let (lengths, mut floors) = (edge.nodal_lengths(), [0.0; 2]);
        for (piece, n) in edge.pieces().into_iter().zip(normals) {
            for i in piece {
                let force = solution.pressure[i] * lengths[i];
                floors = [floors[0] - force * n[0], floors[1] - force * n[1]];
            }
        }
        Ok([load, solution.reaction, floors])
    }

    /// Calls `with` with the load as a field.
    pub fn with_load<T>(&self, with: impl FnOnce(Field<'_>) -> T) -> T {
        if self.load.0.len() == 1 {
            with(Field::Scalar(&|point| self.load_at(point)[0]))
        } else {
            with(Field::Vector(&|point| self.load_at(point)))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn materials_are_read_by_name() {
        let lame = |text: &str| text.parse::<Material>().map(|m| (m.0.lambda(), m.0.mu()));
        assert_eq!(lame("lambda=2, mu=0.5"), Ok((2.0, 0.5)));
        assert_eq!(lame("nu=0.25,E=2.5"), lame("E=2.5, nu=0.25, plane=strain"));
        assert!((lame("E=2.5, nu=0.25, plane=stress").unwrap().0 - 2.0 / 3.0).abs() < 1e-15);
        for bad in
            ["", "1, 1", "lambda=1", "E=1, mu=1", "E=1, nu=0.5", "E=-1, nu=0", "lambda=1, mu=1, plane=stress"]
        {
            let error = bad.parse::<Material>().unwrap_err().to_string();
            assert!(!error.contains('\n'), "{error}");
        }
        assert!("E=1, E=2, nu=0".parse::<Material>().is_err());
        assert!("E=1, nu=0, plane=curved".parse::<Material>().is_err());
    }
}
