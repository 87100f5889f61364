"""Every kind of Gmsh file that the reader in Rust accepts: its J beside an unrelated reader and solver.

`tests/section_2/mesh_files` writes the files and J of the body that Rust reads; here meshio reads them, or Gmsh itself where
meshio does not (formats 2.0 and 4.0 with parametric nodes, the other order of bytes), and SciPy solves.
"""

from pathlib import Path

import numpy as np
import pytest

import fractional_sobolev as fs

meshio = pytest.importorskip("meshio")
pytest.importorskip("scipy")
from test_meshes import LOAD, ROOT, scipy_energy  # noqa: E402

KINDS = sorted((ROOT / "tests/data/msh/kinds").glob("*.msh"))
PARTS = {"contact": "contact", "clamped": "clamped", "fixed": "clamped"}


def part(name):
    return PARTS.get(name.lower().split(" ")[0].split("_")[0], "free")


def by_meshio(file):
    """Points, triangles, and edges in contact and clamped, by their corners."""
    mesh = meshio.gmsh.read(file)
    names = {int(tag): name for name, (tag, dimension) in mesh.field_data.items() if dimension == 1}
    triangles, edges = [], {"contact": [], "clamped": [], "free": []}
    for block, tags in zip(mesh.cells, mesh.cell_data["gmsh:physical"]):
        if block.type.startswith("triangle"):
            triangles += block.data[:, :3].tolist()
        elif block.type.startswith("line"):
            for nodes, tag in zip(block.data[:, :2].tolist(), tags):
                edges[part(names[int(tag)])].append(nodes)
    return mesh.points, triangles, edges


def by_gmsh(file):
    """The same by the library of Gmsh."""
    try:
        import gmsh
    except (ImportError, OSError):
        pytest.skip("meshio does not read this kind, and Gmsh is not there")
    gmsh.initialize(interruptible=False)
    try:
        gmsh.option.setNumber("General.Terminal", 0)
        gmsh.open(str(file))
        tags, points, _ = gmsh.model.mesh.getNodes()
        place = {int(tag): k for k, tag in enumerate(tags)}

        def elements(dimension, entity, corners):
            kinds, _, nodes = gmsh.model.mesh.getElements(dimension, entity)
            for kind, all_nodes in zip(kinds, nodes):
                count = gmsh.model.mesh.getElementProperties(kind)[3]
                yield from ([place[int(n)] for n in row[:corners]] for row in all_nodes.reshape(-1, count))

        triangles = [t for _, entity in gmsh.model.getEntities(2) for t in elements(2, entity, 3)]
        edges = {"contact": [], "clamped": [], "free": []}
        for _, entity in gmsh.model.getEntities(1):
            # The part of a curve in a partition without a group of its own is in that of the curve.
            groups = list(gmsh.model.getPhysicalGroupsForEntity(1, entity))
            if not groups and (parent := gmsh.model.getParent(1, entity))[0] == 1:
                groups = list(gmsh.model.getPhysicalGroupsForEntity(*parent))
            for tag in groups:
                name = gmsh.model.getPhysicalName(1, tag) or gmsh.model.getPhysicalName(-1, tag)
                edges[part(name)] += list(elements(1, entity, 2))
        return points.reshape(-1, 3), triangles, edges
    finally:
        gmsh.finalize()


@pytest.mark.parametrize("file", KINDS, ids=lambda file: file.stem)
def test_same_energy(file, record_property, tmp_path):
    copy = tmp_path / "body.msh"  # neither reader knows a byte-order mark
    copy.write_bytes(file.read_bytes().removeprefix(b"\xef\xbb\xbf"))
    try:
        points, triangles, edges = by_meshio(copy)
        reader = "meshio"
    except Exception:  # whatever a reader raises for a kind that it does not know
        points, triangles, edges = by_gmsh(copy)
        reader = "gmsh"
    record_property("reader", reader)
    assert len(triangles) == 8 and edges["contact"] and edges["clamped"], reader
    used, numbers = np.unique(triangles, return_inverse=True)
    place = {int(node): k for k, node in enumerate(used)}
    contact, clamped = (np.array([[place[a], place[b]] for a, b in edges[name]]) for name in ("contact", "clamped"))
    points, triangles = np.asarray(points)[used, :2], numbers.reshape(-1, 3)
    by_scipy = scipy_energy(points, triangles, contact, clamped)
    by_rust = float(file.with_suffix(".energy").read_text())
    print(f"{file.stem}: {reader}, J apart by {abs(by_rust / by_scipy - 1):.1e}")
    assert abs(by_rust / by_scipy - 1) < 1e-12
    found = fs.contact.solve((points, triangles), LOAD, groups={"contact": contact, "clamped": clamped})
    assert abs(found.energy / by_scipy - 1) < 1e-12


def test_the_kinds_of_the_page_are_there():
    page = (ROOT / "book/src/your_own_body.md").read_text(encoding="utf-8")
    rows = [row.split(" | ") for row in page.splitlines() if row.startswith("| ") and " | read" in row]
    names = {kind[2:].replace(",", "") for kind, *_ in rows}
    names = {"".join(c if c.isalnum() or c == "." else "_" for c in name) for name in names}
    assert len(names) >= 30 and {file.stem for file in KINDS} == names
