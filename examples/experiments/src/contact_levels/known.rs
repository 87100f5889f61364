//! What others have found for the mesh scenes: minima of J by five finite element packages and six methods,
//! on the same meshes, agreeing to 12 to 14 digits (`tests/reference/README.md`).

use signorini::cone::Cone;
use signorini::problems::TestProblem;

/// The meshes n × n.
const MESHES: [usize; 4] = [8, 16, 32, 64];

/// J of the discrete solution on n × n squares by other packages, 12 digits, default setting; `None`
/// where nobody has computed it.
pub fn known_energy(scene: TestProblem, cone: Cone, n: usize) -> Option<f64> {
    let energies = match (scene, cone) {
        (TestProblem::Block, Cone::Nodal) => {
            [-0.015911044457700363, -0.01713918232931794, -0.01749585211899478, -0.01759475908085704]
        }
        (TestProblem::Block, Cone::Midpoint) => {
            [-0.015938251988405466, -0.017139912263237717, -0.01749589771768159, -0.017594760380681508]
        }
        (TestProblem::Membrane, Cone::Nodal) => {
            [-0.0072320116806217465, -0.007847811767268228, -0.008016735238745616, -0.00805997105473013]
        }
        (TestProblem::Membrane, Cone::Midpoint) => {
            [-0.007232455288442041, -0.00784783096603937, -0.008016735752207545, -0.008059971069245834]
        }
        _ => return None,
    };
    MESHES.iter().position(|&mesh| mesh == n).map(|at| energies[at])
}
