"""Signorini's problem without friction on a body of one's own, with piecewise linear elements.

A mesh is what meshio reads, or a pair of arrays (nodes, triangles). Boundary edges have the names of their groups, and the
name says what happens there: `clamped`, `contact` or `free`, with anything behind a blank, `_` or `-`.

>>> from fractional_sobolev import contact
>>> x = np.linspace(0, 1, 9)
>>> nodes = [(a, b) for b in x for a in x]
>>> lower = [(k, k + 1, k + 10) for k in range(72) if k % 9 < 8]
>>> upper = [(k, k + 10, k + 9) for k in range(72) if k % 9 < 8]
>>> sides = {"contact": lambda x, y: y == 0, "clamped": lambda x, y: y == 1}
>>> found = contact.solve((nodes, lower + upper), lambda x, y: (0, 1 - 3 * x), groups=sides)
>>> int(found.active.sum()), len(found.contact_nodes)
(5, 9)
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native

__all__ = ["Solution", "solve"]

Group = Callable[[float, float], bool] | ArrayLike | str | int
Datum = Callable[[float, float], Any] | ArrayLike

# Integer data of cells that hold the groups of a file, and its entities, which do not.
_NOT_GROUPS = ("gmsh:geometrical", "gmsh:dim_tags", "gmsh:bounding_entities")
_PREFERRED = ("gmsh:physical", "cell_tags", "medit:ref", "su2:tag", "nastran:ref")


class Solution:
    """A discrete solution of Signorini's problem.

    Attributes
    ----------
    nodes, triangles : ndarray
        The triangulation; nodes in no triangle are omitted, triangles are counter-clockwise.
    groups, regions : list of str
        The names of the groups of its boundary edges and of its regions.
    remarks : list of str
        What was read in another way than it is listed.
    displacement : ndarray, shape (n, 2) or (n,)
        Displacement at the nodes.
    contact_nodes : ndarray of int
        Nodes of the contact edges in order.
    normal_displacement, pressure : ndarray
        u_N ≤ 0 and −σ_N ≥ 0 at the contact nodes.
    active : ndarray of bool
        Whether a constraint (a node, or a segment in the midpoint cone) is in contact.
    energy : float
        J(u) = ½ a(u, u) − F(u).
    contact_force : float
        −∫ σ_N over the contact edges.
    residual : float
        Largest scaled residual of the Karush-Kuhn-Tucker conditions.
    supports : dict
        For every clamped and contact group (force x, force y, moment about the origin) on the body.
    error : (float, float) or None
        With a tolerance: guaranteed error in the energy norm, absolute and relative to that of the exact solution.
    energy_bounds : (float, float) or None
        With a tolerance: J of the exact solution from below and from above.
    force_bounds : list or None
        With a tolerance: for every contact edge its force from below and from above, None where it meets a clamp.
    shares : ndarray or None
        With a tolerance: the share of every triangle in the square of the bound.
    """

    def __init__(self, solved, components) -> None:
        self.nodes = solved.nodes.reshape(-1, 2)
        self.triangles = np.asarray(solved.triangles, dtype=np.intp).reshape(-1, 3)
        self.groups = solved.groups
        self.regions = solved.regions
        self.remarks = solved.remarks
        self.displacement = solved.displacement.reshape(-1, 2) if components == 2 else solved.displacement
        self.contact_nodes = np.asarray(solved.contact_nodes)
        self.normal_displacement = solved.normal_displacement
        self.pressure = solved.pressure
        self.active = np.asarray(solved.active)
        self.energy = solved.energy
        self.contact_force = solved.contact_force
        self.residual = solved.residual
        self.supports = {name: (x, y, moment) for name, x, y, moment in solved.supports}
        self.error = solved.error
        self.energy_bounds = solved.energy_bounds
        self.force_bounds = solved.force_bounds
        self.shares = solved.shares
        self._solved = solved

    def __repr__(self) -> str:
        return (
            f"<contact.Solution: {len(self.nodes)} nodes, {int(self.active.sum())} of {len(self.active)} constraints active, "
            f"force {self.contact_force:.6g}, residual {self.residual:.1e}>"
        )

    def to_vtk(self, path: str | Path) -> None:
        """Writes displacement, stress and contact pressure as a `.vtu` file, which ParaView and meshio open."""
        Path(path).write_text(self._solved.to_vtu(), encoding="utf-8")


def _outer_edges(triangles: NDArray) -> NDArray[np.intp]:
    edges = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    found, count = np.unique(np.sort(edges, axis=1), axis=0, return_counts=True)
    return found[count == 1]


def _named(tags: NDArray, dimension: int, names: Mapping[str, Any]) -> list[str]:
    """Names of groups by their tags; the tag itself without a name, and nothing for 0."""
    known = {int(tag): name for name, (tag, of) in names.items() if int(of) == dimension}
    return ["" if tag == 0 else known.get(int(tag), str(int(tag))) for tag in tags]


def _tags(mesh) -> list[NDArray] | None:
    """The integer of every cell by blocks that states its group."""
    is_whole = lambda blocks: all(np.issubdtype(np.asarray(block).dtype, np.integer) for block in blocks)
    found = [name for name, blocks in mesh.cell_data.items() if name not in _NOT_GROUPS and is_whole(blocks)]
    found.sort(key=lambda name: _PREFERRED.index(name) if name in _PREFERRED else len(_PREFERRED))
    return [np.asarray(block).ravel() for block in mesh.cell_data[found[0]]] if found else None


def _require_one(one: str, two: str) -> None:
    """Refuses an edge in two groups that say what happens there; of others the smallest set names it."""
    if one != two and one and _native.states_a_part(one) and _native.states_a_part(two):
        raise ValueError(f"an edge is in the groups {one!r} and {two!r}: it must be in one")


def _names_of_blocks(mesh) -> list[list[str]]:
    """For every block of cells the names of the groups of its cells; empty for cells in none."""
    names = [[""] * len(block.data) for block in mesh.cells]
    sets = {name: parts for name, parts in mesh.cell_sets.items() if not name.startswith("gmsh:")}
    if sets:
        # Of several sets with a cell the smallest one names it: a set of all cells is no group.
        size = lambda parts: sum(0 if part is None else len(part) for part in parts)
        for name, parts in sorted(sets.items(), key=lambda item: -size(item[1])):
            for block, part in zip(names, parts):
                for cell in () if part is None else np.asarray(part, dtype=np.intp).tolist():
                    _require_one(block[cell], name)
                    block[cell] = name
        return names
    tags = _tags(mesh)
    if tags is None:
        return names
    families = getattr(mesh, "cell_tags", None) or {}  # of MED: names by the number of a family
    for k, (block, tag) in enumerate(zip(mesh.cells, tags)):
        names[k] = _named(tag, block.dim, mesh.field_data) if not families else [
            " ".join(families.get(int(number), [])) for number in tag
        ]
    return names


def _arrays(mesh) -> tuple[NDArray, NDArray, dict[tuple[int, int], str], list[str]]:
    """Nodes, triangles, named edges, and the region of every triangle of a mesh of meshio."""
    points = np.asarray(mesh.points, dtype=np.float64)
    triangles, regions, edges = [], [], {}
    for block, names in zip(mesh.cells, _names_of_blocks(mesh)):
        cells = np.asarray(block.data, dtype=np.intp)
        if block.type.startswith("triangle"):
            triangles.append(cells[:, :3])
            regions += [name or "body" for name in names]
        elif block.type.startswith("line"):
            for edge, name in zip(map(tuple, np.sort(cells[:, :2]).tolist()), names):
                if name:
                    _require_one(edges.get(edge, ""), name)
                    edges[edge] = name
        elif block.type != "vertex":
            raise ValueError(f"the mesh has cells of type {block.type}: only triangles, lines and points are read")
    if not triangles:
        raise ValueError("the mesh has no triangles: Gmsh meshes a body by gmsh -2 and saves only what is in a physical group; "
            "add Physical Surface(\"body\") = {1};")
    corners = np.concatenate(triangles)
    if len(np.unique(np.sort(corners), axis=0)) < len(corners):
        raise ValueError("a triangle is listed twice: a surface must be in one group")
    used = points[np.unique(corners)]
    if points.shape[1] > 2 and np.ptp(used[:, 2]) > 1e-12 * np.abs(used).max():
        raise ValueError("the body must lie in a plane z = const")
    # Sets of points name the edges between them; of these only the ones that say what happens there.
    outer = _outer_edges(corners)
    for name, members in mesh.point_sets.items():
        inside = np.zeros(len(points), dtype=bool)
        inside[np.asarray(members, dtype=np.intp)] = True
        if _native.states_a_part(name):
            for edge in outer[inside[outer].all(axis=1)].tolist():
                edges.setdefault(tuple(sorted(edge)), name)
    return np.ascontiguousarray(points[:, :2]), corners, edges, regions


def _chosen(given: Group, nodes: NDArray, outer: NDArray, edges: Mapping[tuple[int, int], str]) -> list[list[int]]:
    """Edges as pairs of nodes, from pairs, the group of a file, or a condition on the midpoints of boundary edges."""
    if isinstance(given, (str, int)):
        found = [list(edge) for edge, name in edges.items() if name == str(given)]
        if not found:
            raise ValueError(f"the mesh has no boundary group {given!r}: it has {', '.join(sorted(set(edges.values())))}")
        return found
    if callable(given):
        middle = nodes[outer].mean(axis=1)
        kept = [bool(given(x, y)) for x, y in middle.tolist()]
        return outer[np.asarray(kept, dtype=bool)].tolist()
    return np.asarray(given, dtype=np.intp).reshape(-1, 2).tolist()


def _require_part(part: str, stated: tuple[str, ...], names: list[str], datum: Any, how: str) -> None:
    """Refuses a mesh without an edge of this part; unknown names in the datum are left to the solver."""
    first = lambda name: name.lower().replace("_", " ").replace("-", " ").split(" ")[0]
    acting = isinstance(datum, Mapping) and len(datum) > 0
    if any(first(name) in stated for name in names) or acting:
        return
    raise ValueError(f"no boundary edge is {part}: groups={{{stated[0]!r}: ..}} with pairs of nodes or a condition on (x, y), or {how}; "
        f"the groups are {', '.join(sorted(set(names)))}")


def _given(kind: str, datum: Any, components: int) -> list[tuple[str, str, Callable | None, list[float]]]:
    """What acts, by place: (kind, name or "", function or None, constant)."""
    found = []
    for place, one in ({} if datum is None else datum if isinstance(datum, Mapping) else {"": datum}).items():
        if callable(one):
            found.append((kind, place, one, [0.0, 0.0]))
            continue
        constant = np.asarray(one, dtype=np.float64).ravel().tolist()
        if len(constant) != components:
            raise ValueError(f"{kind}: {len(constant)} component{'s' * (len(constant) != 1)}, expected {components}")
        found.append((kind, place, None, (constant + [0.0])[:2]))
    return found


def solve(
    mesh: Any,
    load: Datum | Mapping[str, Datum] | None = None,
    *,
    traction: Datum | Mapping[str, Datum] | None = None,
    displacement: Datum | Mapping[str, Datum] | None = None,
    gap: Datum | Mapping[str, Datum] | None = None,
    groups: Mapping[str, Group] | None = None,
    regions: ArrayLike | None = None,
    lame: tuple[float, float] | Mapping[str, tuple[float, float]] | None = (1.0, 1.0),
    cone: str = "nodal",
    tolerance: float | None = None,
) -> Solution:
    """Solves Signorini's problem without friction on a triangulation, with piecewise linear elements.

    Parameters
    ----------
    mesh : meshio.Mesh or (nodes, triangles)
        A mesh of any format of meshio, whose lines have groups: names of cell sets, or an integer per cell with the names in
        `field_data`; sets of points name the edges between them if they are called clamped, contact or free. Or the points,
        shape (n, 2), and the corners of the triangles, shape (m, 3), in either orientation.
    load : callable, array_like or dict, optional
        Volume load: a function of x and y, or values at the nodes, or one constant vector (a number if `lame` is None); or
        functions and constants by the names of regions.
    traction, displacement, gap : callable, array_like or dict, optional
        Force per length on the free boundary, displacement of the clamped one, distance to the floor along the normal: a
        function of x and y, or a constant, or a dict of these by the names of groups. A group in such a dict is free, clamped
        or in contact, whatever its name. Default 0.
    groups : dict, optional
        Names of boundary edges: each with pairs of nodes, shape (k, 2), a condition on the midpoint (x, y) of an edge, or
        the name or number of a group in the mesh, which is renamed. Boundary edges in no group are free.
    regions : array_like of str, optional
        The name of the region of every triangle; by default those of the mesh.
    lame : (lambda, mu), dict or None
        Lamé constants, plane strain, of the body or of its regions by name; None for the scalar problem −Δu = f.
    cone : {"nodal", "midpoint"}
        u_N ≤ g at the nodes, or in the mean over the segments of the contact edge.
    tolerance : float, optional
        Refines the mesh until the error in the energy norm relative to |||u||| is at most this number, guaranteed.

    Returns
    -------
    Solution
        The discrete solution.

    Raises
    ------
    SobolevError
        Invalid data, a name that the mesh does not have, or an iteration that did not converge.
    ToleranceNotMet
        More than a million unknowns are required, or rounding is reached.

    Examples
    --------
    >>> square = [(0, 0), (1, 0), (1, 1), (0, 1)], [(0, 1, 2), (0, 2, 3)]
    >>> found = solve(square, (0.0, -1.0), groups={"contact": [(0, 1)], "clamped": [(2, 3)]})
    >>> round(found.contact_force, 6)
    0.5
    >>> x, y = found.supports["contact"][:2]
    >>> abs(y - found.contact_force) < 1e-12
    True
    >>> sides = {"floor": [(0, 1)], "clamped": [(2, 3)]}
    >>> found = solve(square, (0.0, -1.0), gap={"floor": 0.1}, groups=sides, tolerance=0.2)
    >>> found.error[1] <= 0.2 and found.energy_bounds[0] <= found.energy
    True
    """
    if hasattr(mesh, "points"):
        nodes, corners, edges, names = _arrays(mesh)
    else:
        nodes, corners = (np.ascontiguousarray(mesh[0], dtype=np.float64), np.asarray(mesh[1], dtype=np.intp))
        edges, names = {}, []
    outer = _outer_edges(corners)
    listed = dict(edges)
    for name, given in (groups or {}).items():
        edges.update((tuple(sorted(edge)), name) for edge in _chosen(given, nodes, outer, listed))
    for edge in map(tuple, outer.tolist()):
        edges.setdefault(edge, "free")
    # A group that was given is named, also if its edges turn out to lie inside the body: the solver says so.
    groups_of = [edges[edge] for edge in map(tuple, outer.tolist())] + list(groups or {})
    _require_part("clamped", ("clamped", "fixed", "dirichlet"), groups_of, displacement, "displacement={'NAME': (0, 0)}")
    _require_part("in contact", ("contact",), groups_of, gap, "gap={'NAME': 0}")
    if regions is not None:
        names = [str(name) for name in np.asarray(regions).ravel().tolist()]
    components = 1 if lame is None else 2
    values = np.empty(0)
    if load is not None and not callable(load) and not isinstance(load, Mapping) and np.size(load) != components:
        if tolerance is not None:
            raise ValueError("with a tolerance the load is a function or a constant, not values at the nodes")
        if np.size(load) != components * len(nodes):
            raise ValueError(f"load: {np.size(load)} number{'s' * (np.size(load) != 1)}, expected {components}, or {components} at each "
                f"of the {len(nodes)} nodes")
        # Nodes in no triangle are omitted.
        values = np.asarray(load, dtype=np.float64).reshape(-1, components)[np.unique(corners)]
        load = None
    data = {"load": load, "traction": traction, "displacement": displacement, "gap": gap}
    given = [one for kind, datum in data.items() for one in _given(kind, datum, 1 if kind == "gap" else components)]
    material = lame if lame is None or isinstance(lame, Mapping) else {"": tuple(lame)}
    solved = _native.contact(
        nodes, corners, [list(edge) for edge in edges], list(edges.values()), names, given, values.ravel(),
        None if material is None else [(name, *constants) for name, constants in material.items()], cone, tolerance,
    )
    return Solution(solved, components)
