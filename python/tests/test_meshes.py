"""Meshes of any format that meshio reads: the discrete solution beside an unrelated solver in SciPy."""

from pathlib import Path

import numpy as np
import pytest

import fractional_sobolev as fs

meshio = pytest.importorskip("meshio")
sparse = pytest.importorskip("scipy.sparse")
from scipy.sparse.linalg import splu  # noqa: E402

ROOT = Path(__file__).resolve().parents[2]
LOAD = lambda x, y: (0.1 * y, -0.1 - 0.05 * x)


def scipy_energy(points, triangles, contact, clamped, lame=(1.0, 1.0)):
    """min J over the nodal cone: linear elements assembled here, active sets on the saddle point system."""
    p, t = np.asarray(points, dtype=float)[:, :2], np.asarray(triangles)
    lame = np.broadcast_to(lame, (len(t), 2))
    corners = np.dstack([np.ones(t.shape), p[t]])
    area, gradients = np.abs(np.linalg.det(corners)) / 2, np.linalg.inv(corners)[:, 1:]
    strain = np.zeros((len(t), 3, 6))
    strain[:, 0, 0::2] = strain[:, 2, 1::2] = gradients[:, 0]
    strain[:, 1, 1::2] = strain[:, 2, 0::2] = gradients[:, 1]
    law = np.zeros((len(t), 3, 3))
    law[:, :2, :2] = lame[:, :1, None] + 2 * lame[:, 1:, None] * np.eye(2)
    law[:, 2, 2] = lame[:, 1]
    blocks = area[:, None, None] * np.einsum("tki,tkl,tlj->tij", strain, law, strain)
    unknowns = (2 * t[:, :, None] + [0, 1]).reshape(-1, 6)
    rows, columns = np.repeat(unknowns, 6, axis=1).ravel(), np.tile(unknowns, 6).ravel()
    stiffness = sparse.csc_matrix((blocks.ravel(), (rows, columns)), shape=2 * [2 * len(p)])
    # The load is linear: its products with hat functions are exact by the mass matrix.
    values, mass = np.array([LOAD(x, y) for x, y in p]), (np.ones((3, 3)) + np.eye(3)) / 12
    force = np.zeros_like(p)
    np.add.at(force, t, area[:, None, None] * (mass @ values[t]))
    along = np.diff(p[contact], axis=1)[0, 0]
    normal = np.array([along[1], -along[0]]) / np.hypot(*along)
    normal *= -np.sign(normal @ (p.mean(axis=0) - p[contact[0, 0]]))
    held = np.unique(clamped)
    nodes = np.setdiff1d(np.unique(contact), held)
    free = np.setdiff1d(np.arange(2 * len(p)), np.r_[2 * held, 2 * held + 1])
    constraint = sparse.lil_matrix((len(nodes), 2 * len(p)))
    for k, node in enumerate(nodes):
        constraint[k, [2 * node, 2 * node + 1]] = normal
    constraint = constraint.tocsc()[:, free]
    matrix, force, active = stiffness[free][:, free], force.ravel()[free], np.zeros(len(nodes), dtype=bool)
    for _ in range(100):
        b = constraint[active]
        saddle = sparse.bmat([[matrix, b.T], [b, None]], format="csc") if active.any() else matrix.tocsc()
        found = splu(saddle).solve(np.r_[force, np.zeros(active.sum())])
        u, multiplier = found[: len(free)], np.zeros(len(nodes))
        multiplier[active] = found[len(free) :]
        before, active = active, multiplier + constraint @ u > 0
        if np.array_equal(active, before):
            return 0.5 * u @ (matrix @ u) - force @ u
    raise AssertionError("the active sets did not settle")


@pytest.fixture
def body():
    """The L of the book: its mesh and what the reference solver finds."""
    mesh = meshio.gmsh.read(ROOT / "examples/data/l_shape.msh")
    lines = mesh.cells_dict["line"]
    floor, held = (lines[mesh.cell_sets_dict[name]["line"]] for name in ("contact", "clamped"))
    return mesh, scipy_energy(mesh.points, mesh.cells_dict["triangle"], floor, held)


def close(found, energy):
    return found.residual < 1e-12 and abs(found.energy / energy - 1) < 1e-12


def bare(mesh):
    """The mesh with names of its groups as sets of cells, in blocks by type, and nothing else."""
    lines, triangles = mesh.cells_dict["line"], mesh.cells_dict["triangle"]
    sets = {name: [np.asarray(parts.get(kind, []), dtype=int) for kind in ("line", "triangle")]
            for name, parts in mesh.cell_sets_dict.items() if not name.startswith("gmsh:")}
    return meshio.Mesh(mesh.points, [("line", lines), ("triangle", triangles)], cell_sets=sets)


def numbered(mesh, name):
    """The mesh with an integer for the group of every cell: 1 contact, 2 clamped, 3 free, 4 body."""
    sets = bare(mesh).cell_sets
    data = [np.zeros(len(block.data), dtype=int) for block in bare(mesh).cells]
    for number, group in enumerate(("contact", "clamped", "free", "body"), 1):
        for block, cells in zip(data, sets[group]):
            block[cells] = number
    return meshio.Mesh(mesh.points, bare(mesh).cells, cell_data={name: data})


NAMES = {"contact": 1, "clamped": 2, "free": 3}


@pytest.mark.parametrize("binary", [False, True])
@pytest.mark.parametrize("kind", ["gmsh", "gmsh22"])
def test_gmsh_by_meshio(body, tmp_path, kind, binary):
    mesh, energy = body
    mesh.write(tmp_path / "body.msh", file_format=kind, binary=binary)
    assert close(fs.contact.solve(meshio.gmsh.read(tmp_path / "body.msh"), LOAD), energy)


# Formats that meshio writes with all digits; its writers of .su2 and .bdf fail on this mesh.
@pytest.mark.parametrize(("ending", "data"), [("mesh", "medit:ref"), ("vtk", "group"), ("vtu", "group")])
def test_formats_with_numbers_of_groups(body, tmp_path, ending, data):
    mesh, energy = body
    file = tmp_path / f"body.{ending}"
    given = numbered(mesh, data)
    given.write(file)
    assert close(fs.contact.solve(meshio.read(file), LOAD, groups=NAMES), energy)


def test_abaqus_with_names(body, tmp_path):
    mesh, energy = body
    bare(mesh).write(tmp_path / "body.inp")
    read = meshio.read(tmp_path / "body.inp")
    assert close(fs.contact.solve(read, LOAD), energy)
    # Sets of nodes name the edges between them; a set of all is no group.
    floor, held = (np.unique(mesh.cells_dict["line"][mesh.cell_sets_dict[name]["line"]]) for name in ("contact", "clamped"))
    sets = {"CONTACT": floor, "FIXED-TOP": held, "Nall": np.arange(len(mesh.points))}
    only = meshio.Mesh(mesh.points, [("triangle", mesh.cells_dict["triangle"])], point_sets=sets)
    only.write(tmp_path / "nodes.inp")
    found = fs.contact.solve(meshio.read(tmp_path / "nodes.inp"), LOAD)
    assert close(found, energy) and sorted(found.groups) == ["CONTACT", "FIXED-TOP", "free"]


def test_plain_arrays(body):
    mesh, energy = body
    p, t, lines = mesh.points[:, :2], mesh.cells_dict["triangle"], mesh.cells_dict["line"]
    floor, held = (lines[mesh.cell_sets_dict[name]["line"]] for name in ("contact", "clamped"))
    given = {"contact": floor, "clamped": held}
    assert close(fs.contact.solve((p, t), LOAD, groups=given), energy)
    # Some triangles clockwise, a node in no triangle, the load by its values at the nodes.
    mixed, more = np.where(np.arange(len(t))[:, None] % 3 == 0, t[:, ::-1], t), np.r_[p, [[9.0, 9.0]]]
    found = fs.contact.solve((more, mixed), [LOAD(x, y) for x, y in more], groups=given)
    assert close(found, energy) and len(found.nodes) == len(p)
    assert found.remarks == [f"{-(-len(t) // 3)} of {len(t)} triangles are listed clockwise and were turned"]


def test_second_order_and_regions(body):
    mesh, _ = body
    p, t, lines = mesh.points[:, :2], mesh.cells_dict["triangle"], mesh.cells_dict["line"]
    floor, held = (lines[mesh.cell_sets_dict[name]["line"]] for name in ("contact", "clamped"))
    right = p[t].mean(axis=1)[:, 0] > 0.7
    lame = np.where(right[:, None], (2.0, 3.0), (1.0, 1.0))
    energy = scipy_energy(p, t, floor, held, lame)
    six = np.c_[t, np.arange(3 * len(t)).reshape(-1, 3) + len(p)]
    middles = (p[t] + np.roll(p[t], -1, axis=1)).reshape(-1, 2) / 2
    second = meshio.Mesh(np.r_[p, middles], [("triangle6", six), ("line", lines)],
        cell_sets={"clamped": [[], mesh.cell_sets_dict["clamped"]["line"]], "contact": [[], mesh.cell_sets_dict["contact"]["line"]],
            "arm": [np.flatnonzero(~right), []], "foot": [np.flatnonzero(right), []]})
    found = fs.contact.solve(second, LOAD, lame={"arm": (1.0, 1.0), "foot": (2.0, 3.0)})
    assert close(found, energy) and sorted(found.regions) == ["arm", "foot"]
    with pytest.raises(fs.SobolevError, match="no region 'foto': it has"):
        fs.contact.solve(second, LOAD, lame={"arm": (1.0, 1.0), "foto": (2.0, 3.0)})


def test_what_is_missing_is_refused_with_what_to_do(body):
    mesh, _ = body
    p, t, lines = mesh.points[:, :2], mesh.cells_dict["triangle"], mesh.cells_dict["line"]
    floor, held = (lines[mesh.cell_sets_dict[name]["line"]] for name in ("contact", "clamped"))
    with pytest.raises(ValueError, match=r"no boundary edge is clamped: groups={'clamped': .*displacement={.*the groups are contact, free"):
        fs.contact.solve((p, t), LOAD, groups={"contact": floor})
    with pytest.raises(ValueError, match=r"no boundary edge is in contact: .*gap={'NAME': 0}; the groups are clamped, free"):
        fs.contact.solve((p, t), LOAD, groups={"clamped": held})
    # A group on which something acts is clamped or in contact, whatever its name.
    given = {"wall": held, "floor": floor}
    found = fs.contact.solve((p, t), LOAD, displacement={"wall": (0, 0)}, gap={"floor": 0}, groups=given)
    assert found.energy == fs.contact.solve((p, t), LOAD, groups={"contact": floor, "clamped": held}).energy
    with pytest.raises(ValueError, match="no boundary group 'flor': it has"):
        fs.contact.solve((p, t), LOAD, displacement={"wall": (0, 0)}, gap={"flor": 0}, groups=given)
    with pytest.raises(ValueError, match="no triangles: Gmsh meshes a body by gmsh -2"):
        fs.contact.solve(meshio.Mesh(mesh.points, [("line", lines)]), LOAD)
    with pytest.raises(ValueError, match=f"load: 1 number, expected 2, or 2 at each of the {len(p)} nodes"):
        fs.contact.solve((p, t), -1, groups={"contact": floor, "clamped": held})
    with pytest.raises(ValueError, match="displacement: 1 component, expected 2"):
        fs.contact.solve((p, t), LOAD, displacement={"clamped": 0}, groups={"contact": floor, "clamped": held})


def test_what_is_not_a_plane_body_is_refused(body):
    mesh, _ = body
    p, t = mesh.points, mesh.cells_dict["triangle"]
    with pytest.raises(ValueError, match="type quad"):
        fs.contact.solve(meshio.Mesh(p, [("quad", [[0, 1, 2, 3]])]))
    with pytest.raises(ValueError, match="type tetra"):
        fs.contact.solve(meshio.Mesh(p, [("triangle", t), ("tetra", [[0, 1, 2, 3]])]))
    with pytest.raises(ValueError, match="plane z = const"):
        fs.contact.solve(meshio.Mesh(p + p[:, [2, 2, 0]], [("triangle", t)]))
    with pytest.raises(ValueError, match="no boundary group 'floor': it has clamped, contact, free"):
        fs.contact.solve(mesh, LOAD, groups={"contact": "floor"})


@pytest.mark.parametrize("how", ["a cell set", "an edge listed twice"])
def test_an_edge_in_two_groups_is_refused(how):
    points = [(0, 0), (1, 0), (1, 1), (0, 1)]
    lines, triangles = [(0, 1), (1, 2), (2, 3), (3, 0)], [(0, 1, 2), (0, 2, 3)]
    groups = {"contact": [0], "free": [0, 1, 3], "clamped": [2]}
    if how == "a cell set":
        sets = {name: [np.array(cells), None] for name, cells in groups.items()}
        mesh = meshio.Mesh(points, [("line", lines), ("triangle", triangles)], cell_sets=sets)
    else:
        tags = [1, 2, 2, 2, 3]
        names = {"contact": np.array([1, 1]), "free": np.array([2, 1]), "clamped": np.array([3, 1])}
        rows = [lines[k] for k in (0, 0, 1, 3, 2)]
        data = {"gmsh:physical": [np.array(tags), np.array([0, 0])]}
        mesh = meshio.Mesh(points, [("line", rows), ("triangle", triangles)], cell_data=data, field_data=names)
    with pytest.raises(ValueError, match="an edge is in the groups '.*' and '.*': it must be in one"):
        fs.contact.solve(mesh, (0, -0.1))


def test_a_triangle_that_is_listed_twice_is_refused():
    points = [(0, 0), (1, 0), (1, 1), (0, 1)]
    mesh = meshio.Mesh(points, [("triangle", [(0, 1, 2), (0, 2, 3), (2, 0, 1)])])
    with pytest.raises(ValueError, match="listed twice"):
        fs.contact.solve(mesh, (0, -0.1), groups={"contact": [(0, 1)], "clamped": [(2, 3)]})
