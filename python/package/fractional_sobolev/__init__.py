"""Fractional Sobolev norms with error bounds, best constants, and Signorini contact.

The seminorm of order 0 < s < 1 is |u|_s² = ∬ (u(x) − u(y))² / |x − y|^(d+2s) dx dy over the square of the domain, d its
dimension; ‖u‖_s² = ‖u‖² + |u|_s², ‖u‖_(1+s)² = ‖u‖² + ‖∇u‖_s², and the norm of order −s is sup ∫ u v / ‖v‖_s. A tolerance is
relative, and an `Estimate` is a float with its absolute error. All quantities are nondimensional.

Examples
--------
>>> import fractional_sobolev as fs
>>> fs.norm(lambda x: abs(x - 0.3), 0.45, on=(0, 0.3, 1))
0.84803827442139 ± 3e-14
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native, contact
from ._types import Estimate, InfiniteNorm, SobolevError, ToleranceNotMet

__all__ = [
    "Constant",
    "Estimate",
    "InfiniteNorm",
    "SobolevError",
    "ToleranceNotMet",
    "boundary_norm",
    "contact",
    "dual_norm",
    "error_norm",
    "gram",
    "interpolation_constant",
    "norm",
    "plane_norm",
    "poincare",
    "seminorm",
]

Function = Callable[..., float] | ArrayLike


def _floats(values: Any) -> NDArray[np.float64]:
    return np.ascontiguousarray(values, dtype=np.float64)


def _on(u: Function, on: ArrayLike | None) -> tuple[Any, NDArray[np.float64]]:
    """The function as the compiled half takes it, and breakpoints or nodes."""
    if callable(u):
        return u, _floats((0.0, 1.0) if on is None else on)
    values = _floats(u)
    return values, np.linspace(0.0, 1.0, len(values)) if on is None else _floats(on)


def _interval_norm(u, s, on, tol, distances, derivative, seminorm):
    values, places = _on(u, on)
    slope = derivative if derivative is None or callable(derivative) else _floats(derivative)
    return _native.norm(values, s, places, tol, distances, slope, seminorm)


def seminorm(
    u: Function,
    s: float,
    on: ArrayLike | None = None,
    tol: float = 1e-8,
    *,
    distances: bool = False,
    derivative: Callable[..., float] | None = None,
) -> Estimate:
    """The seminorm |u|_s of a function on an interval.

    Parameters
    ----------
    u : callable or array_like
        A function of x, smooth between the breakpoints; or an array with one value per node (piecewise linear) or one
        per element (piecewise constant).
    s : float
        Order, 0 < s < 2; |u|_1 = ‖u'‖ and |u|_s = |u'|_(s−1) for s > 1.
    on : array_like, optional
        Breakpoints of a callable with both ends of the interval, by default (0, 1); nodes of an array, by default
        equidistant in [0, 1].
    tol : float
        Relative tolerance.
    distances : bool
        If true, u is called as u(x, d) with the distances d to the breakpoints, which are exact where x − x₀ is rounded.
    derivative : callable, optional
        u', which orders s ≥ 1 of a callable need.

    Returns
    -------
    Estimate
        The seminorm with its absolute error.

    Raises
    ------
    InfiniteNorm
        The seminorm is infinite.
    ToleranceNotMet
        The tolerance is out of reach; the exception has the best value as `best`.

    Examples
    --------
    >>> seminorm(lambda x: x, 0.5)
    1.00000000000000 ± 4e-14
    """
    return _interval_norm(u, s, on, tol, distances, derivative, True)


def norm(
    u: Function,
    s: float,
    on: ArrayLike | None = None,
    tol: float = 1e-8,
    *,
    distances: bool = False,
    derivative: Callable[..., float] | None = None,
) -> Estimate:
    """The norm ‖u‖_s of a function on an interval, −1 < s < 2.

    For s < 0 it is the dual norm sup ∫ u v / ‖v‖_(−s), for s = 0 the L² norm. Parameters and exceptions are those of
    `seminorm`.

    Returns
    -------
    Estimate
        The norm with its absolute error.

    Examples
    --------
    >>> round(norm([0.0, 1.0, 0.0], 0.0) ** 2, 12)
    0.333333333333
    """
    return _interval_norm(u, s, on, tol, distances, derivative, False)


def dual_norm(
    f: Function,
    s: float,
    on: ArrayLike | None = None,
    tol: float = 1e-8,
    *,
    distances: bool = False,
    functional: bool = False,
    dual_of: str = "slobodeckij",
) -> Estimate:
    """The dual norm sup ∫ f v / ‖v‖_s, 0 < s < 1.

    Parameters
    ----------
    f : callable or array_like
        As u of `seminorm`; with `functional` the values of a functional on the hat functions of the mesh, the supremum
        then over the piecewise linear functions of the mesh.
    s : float
        Order, 0 < s < 1.
    on, tol, distances
        As for `seminorm`.
    functional : bool
        Whether f holds values on the hat functions.
    dual_of : {"slobodeckij", "cosines", "sines"}
        ‖v‖_s: the double integral, or the interpolation norm by cosines (H^s) or by sines (zero at both ends).

    Returns
    -------
    Estimate
        The dual norm with its absolute error.

    Examples
    --------
    >>> round(dual_norm(lambda x: 1.0, 0.5), 9)
    1.0
    """
    values, places = _on(f, on)
    return _native.dual_norm(values, s, places, tol, distances, functional, dual_of)


def error_norm(
    u: Callable[..., float],
    nodes: ArrayLike,
    s: float,
    values: ArrayLike | None = None,
    tol: float = 1e-6,
    *,
    breaks: ArrayLike | None = None,
    distances: bool = False,
    seminorm: bool = False,
) -> Estimate:
    """The norm ‖u − u_h‖_s of the error of a piecewise linear approximation.

    Parameters
    ----------
    u : callable
        The function, smooth between its breakpoints.
    nodes : array_like
        Nodes of the mesh.
    s : float
        Order, −1 < s < 1.
    values : array_like, optional
        Values of u_h at the nodes; by default those of u, the interpolant.
    breaks : array_like, optional
        Breakpoints of u with both ends, by default the ends only.
    tol, distances
        As for `seminorm`.
    seminorm : bool
        Whether the seminorm is returned.

    Returns
    -------
    Estimate
        The norm of the error of approximation, with the error of its computation.

    Examples
    --------
    >>> e = [error_norm(lambda x: x * x, np.linspace(0, 1, n + 1), 0.5) for n in (50, 100)]
    >>> round(float(np.log2(e[0] / e[1])), 1)
    1.5
    """
    nodes = _floats(nodes)
    breaks = _floats((nodes[0], nodes[-1]) if breaks is None else breaks)
    if values is None:
        values = [u(x, tuple(np.abs(x - breaks))) if distances else u(x) for x in nodes.tolist()]
    return _native.error_norm(u, nodes, s, _floats(values), breaks, tol, distances, seminorm)


def gram(nodes: ArrayLike, s: float, tol: float = 1e-10, *, zero_outside: bool = False):
    """The Gram matrix of |·|_s, 0 < s < 1, on the hat functions of a mesh, as a SciPy operator.

    A product costs O(N log N) operations on a mesh of N elements.

    Parameters
    ----------
    nodes : array_like
        Nodes of the mesh, increasing.
    s : float
        Order, 0 < s < 1.
    tol : float
        Relative tolerance of products, solutions and eigenvalues.
    zero_outside : bool
        If true, functions are zero outside the mesh and the double integral is over the whole line: times C(1, s)/2 the
        matrix of the integral fractional Laplacian, on the hat functions of the inner nodes. By default the integral is
        over the interval, for the hat functions of all nodes.

    Returns
    -------
    scipy.sparse.linalg.LinearOperator
        The operator A with (A x, x) = |u|_s² for the piecewise linear u with nodal values x, with

        * `A.mass`, the mass matrix,
        * `A.preconditioner`, an approximate inverse, as good for many elements as for few,
        * `A.solve(b)`, the solution of A x = b and its energy xᵀA x,
        * `A.extreme_eigenvalues()`, the smallest positive and the largest of A x = λ M x,
        * `A.to_dense()`, the matrix.

    Examples
    --------
    (−Δ)^(1/2) u = 1 on (−1, 1): u(0) = 1, and C(1, 1/2) = 1/π.

    >>> import numpy as np
    >>> A = gram(np.linspace(-1, 1, 2001), 0.5, zero_outside=True)
    >>> x, energy = A.solve(np.full(1999, 0.001) * 2 * np.pi)
    >>> round(float(x[999]), 3)
    1.0
    """
    from scipy.sparse.linalg import LinearOperator  # type: ignore[import-untyped]

    matrix = _native.GramMatrix(_floats(nodes), s, tol, zero_outside)
    size = matrix.size()

    def operator(product) -> LinearOperator:
        def flat(x):
            return product(np.ascontiguousarray(x, dtype=np.float64).ravel())

        return LinearOperator((size, size), matvec=flat, rmatvec=flat, dtype=np.float64)

    found = operator(matrix.apply)
    found.mass = operator(matrix.mass)
    found.preconditioner = operator(matrix.precondition)
    found.solve = lambda b: matrix.solve(_floats(b))
    found.extreme_eigenvalues = matrix.extreme_eigenvalues
    found.to_dense = matrix.dense
    return found


def boundary_norm(
    vertices: ArrayLike,
    u: Function,
    s: float,
    tol: float = 1e-8,
    *,
    elements: int = 32,
    exponent: float = 1.0,
    seminorm: bool = False,
) -> Estimate:
    """The norm ‖u‖_s, −1 < s < 1, of a function on the boundary of a polygon.

    Parameters
    ----------
    vertices : array_like, shape (n, 2)
        Corners of the polygon in order.
    u : callable or array_like
        A function of x and y, smooth on every side, which may be singular at corners (for s < 0 its piecewise linear
        interpolant is taken, and the error is that of the norm of the interpolant); or the values of a piecewise linear
        function at the nodes, from the first corner on.
    s, tol
        As for `norm`.
    elements : int
        Elements of a side for values and for s < 0, an even number.
    exponent : float
        Their grading towards the corners: nodes at (2 k/elements)^exponent of half a side.
    seminorm : bool
        Whether the seminorm is returned.

    Returns
    -------
    Estimate
        The norm with its absolute error.

    Examples
    --------
    >>> round(boundary_norm([(0, 0), (1, 0), (1, 1), (0, 1)], lambda x, y: 1.0, 0.5), 9)
    2.0
    """
    given = u if callable(u) else _floats(u)
    return _native.boundary_norm(_floats(vertices), given, s, tol, elements, exponent, seminorm)


def plane_norm(
    nodes: ArrayLike,
    triangles: ArrayLike,
    values: ArrayLike,
    s: float,
    tol: float = 1e-8,
    *,
    seminorm: bool = False,
) -> Estimate:
    """The norm ‖u‖_s, 0 ≤ s < 2, of a function on a triangulation.

    Parameters
    ----------
    nodes : array_like, shape (n, 2)
        Points.
    triangles : array_like of int, shape (m, 3)
        Counter-clockwise corners, as numbers of nodes.
    values : array_like
        One value per node (piecewise linear) or one per triangle (piecewise constant).
    s, tol
        As for `norm`.
    seminorm : bool
        Whether the seminorm is returned.

    Returns
    -------
    Estimate
        The norm with its absolute error.

    Examples
    --------
    >>> square = [[0, 0], [1, 0], [0, 1], [1, 1]], [[0, 1, 3], [0, 3, 2]]
    >>> round(plane_norm(*square, [0, 1, 0, 1], 0.0) ** 2, 12)
    0.333333333333
    """
    corners = np.asarray(triangles, dtype=np.uintp)
    return _native.plane_norm(_floats(nodes), corners, _floats(values), s, tol, seminorm)


class Constant(Estimate):
    """A best constant: an `Estimate` with bounds and a function that attains it.

    Attributes
    ----------
    lower, upper : Estimate or None
        Bounds, where they are known.
    """

    lower: Estimate | None
    upper: Estimate | None
    _extremal: Any

    def __new__(cls, found) -> Constant:
        constant, lower, upper, extremal = found
        made = super().__new__(cls, float(constant), constant.error, constant.work)
        made.lower, made.upper, made._extremal = lower, upper, extremal
        return made

    def extremal(self, *points: ArrayLike) -> NDArray[np.float64]:
        """Values of a function for which the constant is attained, at points x, or x and y in the plane."""
        if self._extremal is None:
            raise SobolevError("no function is known for which this constant is attained")
        places = np.broadcast_arrays(*map(_floats, points))
        values = self._extremal.values(np.stack([p.ravel() for p in places], axis=1))
        return np.asarray(values).reshape(places[0].shape)


def poincare(
    s: float,
    zone: Sequence | None = None,
    *,
    condition: str = "mean",
    point: float | None = None,
    start_and_length: tuple[float, float] | None = None,
    tol: float = 1e-8,
) -> Constant:
    """The best constant γ in ‖u‖ ≤ γ |u|_s on (0, 1), 0 < s < 1.

    Parameters
    ----------
    s : float
        Order.
    zone : (a, b) or sequence of such pairs, optional
        Where the condition holds, by the two ends; by default everywhere.
    condition : {"mean", "vanishing"}
        Whether the mean over the zone is zero, or u itself.
    point : float, optional
        Instead of a zone: u vanishes at this point, s > 1/2.
    start_and_length : (start, length), optional
        Instead of `zone`, where the length is tiny beside the start.
    tol : float
        Relative tolerance.

    Returns
    -------
    Constant
        γ with its error, bounds, and an extremal function.

    Examples
    --------
    >>> poincare(0.5, (0, 1e-6)) > poincare(0.5)
    True
    """
    zones: list[Any] = [] if zone is None else [zone] if np.ndim(zone[0]) == 0 else list(zone)
    by_length = start_and_length is not None
    if by_length:
        zones = [start_and_length]
    pairs = [(float(a), float(b)) for a, b in zones]
    if condition not in ("mean", "vanishing"):
        raise SobolevError(f"unknown condition '{condition}': expected mean or vanishing")
    condition = "point" if point is not None else condition
    return Constant(_native.poincare(s, pairs, by_length, condition, point, tol))


def interpolation_constant(
    s: float,
    domain: float | ArrayLike = 1.0,
    norm: str = "L2",
    tol: float = 1e-6,
) -> Constant:
    """The best constant C in ‖u − I u‖ ≤ C |∇u|_s, I linear interpolation at the nodes, 0 ≤ s ≤ 1.

    Parameters
    ----------
    s : float
        Order of the gradient.
    domain : float, array_like of nodes, or array_like of shape (3, 2)
        The length of an interval, a mesh, or the corners of a triangle.
    norm : {"L2", "derivative", "H1"}
        Norm of the error.
    tol : float
        Relative tolerance.

    Returns
    -------
    Constant
        C with its error, bounds, and an extremal function.

    Examples
    --------
    >>> interpolation_constant(0.5, norm="derivative", tol=1e-9)
    0.291564029204 ± 7e-12
    """
    length, mesh, triangle = 1.0, None, None
    if np.ndim(domain) == 0:
        length = float(np.asarray(domain))
    elif np.shape(domain) == (3, 2):
        triangle = _floats(domain)
    else:
        mesh = _floats(domain)
    return Constant(_native.interpolation(s, length, mesh, triangle, norm, tol))
