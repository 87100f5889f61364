from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._types import Estimate

Array = NDArray[np.float64]
Indices = NDArray[np.uintp]

class GramMatrix:
    def __init__(self, nodes: Array, s: float, tol: float, zero_outside: bool) -> None: ...
    def apply(self, x: Array) -> Array: ...
    def mass(self, x: Array) -> Array: ...
    def precondition(self, x: Array) -> Array: ...
    def solve(self, b: Array) -> tuple[Array, Estimate]: ...
    def extreme_eigenvalues(self) -> tuple[Estimate, Estimate]: ...
    def size(self) -> int: ...
    def dense(self) -> Array: ...

def norm(
    u: Any, s: float, on: Array, tol: float, distances: bool, derivative: Any, seminorm: bool
) -> Estimate: ...
def dual_norm(
    f: Any, s: float, on: Array, tol: float, distances: bool, functional: bool, dual_of: str
) -> Estimate: ...
def error_norm(
    u: Any, nodes: Array, s: float, values: Array, breaks: Array, tol: float, distances: bool, seminorm: bool
) -> Estimate: ...
def boundary_norm(
    vertices: Array, u: Any, s: float, tol: float, elements: int, exponent: float, seminorm: bool
) -> Estimate: ...
def plane_norm(
    nodes: Array, triangles: Indices, values: Array, s: float, tol: float, seminorm: bool
) -> Estimate: ...
def poincare(
    s: float,
    zones: list[tuple[float, float]],
    start_and_length: bool,
    condition: str,
    point: float | None,
    tol: float,
) -> Any: ...
def interpolation(
    s: float, length: float, mesh: Array | None, triangle: Array | None, norm: str, tol: float
) -> Any: ...
def states_a_part(name: str) -> bool: ...
def contact(
    nodes: Array,
    triangles: Indices,
    edges: list[list[int]],
    names: list[str],
    regions: list[str],
    given: list[tuple[str, str, Any, list[float]]],
    values: Array,
    lame: list[tuple[str, float, float]] | None,
    cone: str,
    tolerance: float | None,
) -> Any: ...
