"""Every function against closed forms and SciPy."""

import signal
import threading
import time

import mpmath
import numpy as np
import pytest
import scipy.integrate
import scipy.linalg
import scipy.sparse.linalg

import fractional_sobolev as fs


def within(found, exact, tol):
    """The value is right to the tolerance, and its own error covers the difference."""
    assert abs(found - exact) <= tol * abs(exact), (found, exact)
    assert abs(found - exact) <= found.error + 4e-16 * abs(exact), (found, exact, found.error)


@pytest.mark.parametrize("s", [0.1, 0.25, 0.5, 0.75, 0.9])
def test_seminorm_of_x_and_of_a_step(s):
    # |x|_s² = ∬ |x − y|^(1 − 2s) = 2 / ((2 − 2s)(3 − 2s))
    exact = (2.0 / ((2.0 - 2.0 * s) * (3.0 - 2.0 * s))) ** 0.5
    within(fs.seminorm(lambda x: x, s), exact, 1e-8)
    within(fs.seminorm([0.0, 1.0], s), exact, 1e-8)
    if s < 0.5:
        # a step at 1/2: 2 ∫∫ |x − y|^(−1 − 2s) over (0, 1/2) × (1/2, 1)
        step = 2.0 * (2.0 * 0.5 ** (1.0 - 2.0 * s) - 1.0) / (2.0 * s * (1.0 - 2.0 * s))
        within(fs.seminorm([0.0, 1.0], s, on=[0.0, 0.5, 1.0]), step**0.5, 1e-8)
    else:
        with pytest.raises(fs.InfiniteNorm):
            fs.seminorm(lambda x: float(x > 0.5), s, on=(0, 0.5, 1))


@pytest.mark.parametrize("s", [0.2, 0.5, 0.8])
def test_seminorm_of_the_sine_by_mpmath(s):
    # |u|_s² = 2 ∫_0^1 r^(−1−2s) G(r) dr, G(r) = ∫_0^(1−r) (sin(x + r) − sin x)² dx
    def inner(r):
        return (2 * mpmath.sin(r / 2)) ** 2 * ((1 - r) / 2 + (mpmath.sin(2 - r) - mpmath.sin(r)) / 4)

    # r = t^8 leaves no singularity that quadrature would notice
    mpmath.mp.dps = 30
    exact = mpmath.sqrt(2 * mpmath.quad(lambda t: 8 * t ** (-1 - 16 * s) * inner(t**8), [0, 0.2, 0.5, 1]))
    within(fs.seminorm(np.sin, s, tol=1e-9), float(exact), 1e-8)


def test_distances_keep_a_singularity_inside():
    one = fs.seminorm(lambda x, d: d[1] ** 0.4, 0.6, on=(0, 0.3, 1), distances=True)
    other = fs.seminorm(lambda x, d: d[1] ** 0.4, 0.6, on=(0, 0.7, 1), distances=True)
    assert abs(one - other) <= one.error + other.error


def test_orders_above_one_have_the_derivative_or_find_it():
    found = fs.norm(lambda x: x * x / 2, 1.5, derivative=lambda x: x)
    within(found, (1 / 20 + 1 / 3 + 1) ** 0.5, 1e-8)
    within(fs.norm(lambda x: x * x / 2, 1.5), (1 / 20 + 1 / 3 + 1) ** 0.5, 1e-8)


def test_dual_norms():
    within(fs.dual_norm(lambda x: 1.0, 0.5), 1.0, 1e-8)
    within(fs.dual_norm([0.25, 0.5, 0.25], 0.5, functional=True), 1.0, 1e-8)
    assert fs.norm([1.0, -1.0], -0.5, on=[0, 0.5, 1]) == fs.dual_norm([1.0, -1.0], 0.5, on=[0, 0.5, 1])
    # cosines: Σ (1 + k²π²)^(−s) f_k², f_k = √2 ∫ x cos kπx = √2 ((−1)^k − 1)/(kπ)²
    k = np.arange(1, 200001, 2)
    series = 0.25 + np.sum((1 + (k * np.pi) ** 2) ** -0.5 * 8.0 / (k * np.pi) ** 4)
    within(fs.dual_norm([0.0, 1.0], 0.5, dual_of="cosines"), series**0.5, 1e-8)
    with pytest.raises(fs.SobolevError, match="slobodeckij"):
        fs.dual_norm([0.0, 1.0], 0.5, dual_of="other")


def test_error_norms():
    nodes = np.linspace(0.0, 1.0, 11)
    # x² less its interpolant is −(x − a)(b − x): ‖e‖² = h⁴/30
    within(fs.error_norm(lambda x: x * x, nodes, 0.0), (0.1**4 / 30) ** 0.5, 1e-6)
    # less its mean value 1/3: |u|_s² = ∬ (x + y)² |x − y|^(1 − 2s), and at s = 1/2 that is ∬ (x + y)² = 7/6
    within(fs.error_norm(lambda x: x * x, [0.0, 1.0], 0.5, [1 / 3, 1 / 3], seminorm=True), (7 / 6) ** 0.5, 1e-6)
    assert fs.error_norm(abs, [-1.0, 1.0], -0.5, [0.0, 0.0], breaks=(-1, 0, 1)) < 1.0


def test_gram_against_its_entries_and_eigsh():
    nodes = np.array([0.0, 0.1, 0.35, 0.6, 1.0])
    matrix = fs.gram(nodes, 0.3)
    dense = matrix.to_dense()
    for k, x in enumerate(np.eye(5)):
        assert np.allclose(matrix @ x, dense[:, k], rtol=1e-11, atol=1e-13)
        assert abs((x @ dense @ x) ** 0.5 / fs.seminorm(x, 0.3, on=nodes) - 1) < 1e-9


@pytest.mark.parametrize("zero_outside", [False, True])
def test_gram_solves_and_has_the_eigenvalues_of_scipy(zero_outside):
    nodes = np.linspace(0.0, 1.0, 201) ** 1.5
    matrix = fs.gram(nodes, 0.5, zero_outside=zero_outside)
    size = matrix.shape[0]
    dense, mass = matrix.to_dense(), np.column_stack([matrix.mass @ x for x in np.eye(size)])
    exact = scipy.linalg.eigh(dense, mass, eigvals_only=True)
    low, high = matrix.extreme_eigenvalues()
    within(low, exact[0 if zero_outside else 1], 1e-8)
    within(high, exact[-1], 1e-8)
    load = np.sin(9.0 * np.arange(size))
    load -= 0.0 if zero_outside else load.mean()
    x, energy = matrix.solve(load)
    assert np.allclose(matrix @ x, load, atol=1e-8 * np.abs(load).max() * size)
    within(energy, load @ x, 1e-8)
    steps = 0

    def count(_):
        nonlocal steps
        steps += 1

    found, info = scipy.sparse.linalg.cg(matrix, load, rtol=1e-10, M=matrix.preconditioner, callback=count)
    assert info == 0 and steps < 40
    assert abs((found - x) @ dense @ (found - x)) < 1e-16 * energy


def test_eigsh_finds_the_largest_eigenvalue():
    nodes = np.linspace(0.0, 1.0, 201)
    matrix = fs.gram(nodes, 0.5)
    found = scipy.sparse.linalg.eigsh(matrix, k=1, M=matrix.mass, Minv=_inverse(matrix.mass), which="LA")[0]
    mass = np.column_stack([matrix.mass @ x for x in np.eye(201)])
    assert abs(found[0] / scipy.linalg.eigh(matrix.to_dense(), mass, eigvals_only=True)[-1] - 1) < 1e-8


def _inverse(mass):
    dense = np.column_stack([mass @ x for x in np.eye(mass.shape[0])])
    factor = scipy.linalg.cho_factor(dense)
    return scipy.sparse.linalg.LinearOperator(mass.shape, matvec=lambda x: scipy.linalg.cho_solve(factor, x))


def test_plane_and_boundary_norms():
    square = [[0, 0], [1, 0], [0, 1], [1, 1]], [[0, 1, 3], [0, 3, 2]]
    within(fs.plane_norm(*square, [0, 1, 0, 1], 0.0), (1 / 3) ** 0.5, 1e-8)
    within(fs.plane_norm(*square, [0, 1, 0, 1], 1.0), (4 / 3) ** 0.5, 1e-8)
    corners = [(0, 0), (1, 0), (1, 1), (0, 1)]
    within(fs.boundary_norm(corners, lambda x, y: 1.0, 0.5), 2.0, 1e-8)
    within(fs.boundary_norm(corners, np.ones(8), -0.5, elements=2), 2.0, 1e-8)
    ell = [(0, 0), (1, 0), (1, 1), (-1, 1), (-1, -1), (0, -1)]

    def corner(x, y):
        return np.hypot(x, y) ** (2 / 3) * np.sin(2 / 3 * (np.arctan2(y, x) % (2 * np.pi)))

    within(fs.boundary_norm(ell, corner, 0.5, 1e-9, seminorm=True), 3.5771379292306, 1e-9)


def test_poincare_against_scipy():
    # γ² is the largest eigenvalue of the mass on functions of mean zero on (0, 1/4)
    nodes = np.linspace(0.0, 1.0, 401)
    matrix = fs.gram(nodes, 0.75)
    energy, mass = matrix.to_dense(), np.column_stack([matrix.mass @ x for x in np.eye(401)])
    zone = np.interp(nodes, [0.0, 0.25], [1.0, 1.0], right=0.0) / 400
    zone[0] /= 2
    zone[100] /= 2
    free = scipy.linalg.null_space(zone[None, :])
    largest = scipy.linalg.eigh(free.T @ mass @ free, free.T @ energy @ free, eigvals_only=True)[-1]
    found = fs.poincare(0.75, (0.0, 0.25))
    assert largest**0.5 <= found.value and abs(largest**0.5 / found - 1) < 1e-3
    assert found.lower <= found + found.error and found - found.error <= found.upper
    u = found.extremal(np.linspace(0.0, 0.25, 2001))
    assert abs(scipy.integrate.simpson(u, dx=0.25 / 2000)) < 1e-5 * np.abs(u).max()
    one = fs.poincare(0.75, (0.25, 0.5)), fs.poincare(0.75, start_and_length=(0.25, 0.25))
    assert one[0] == one[1]
    assert fs.poincare(0.75, point=0.0) > fs.poincare(0.75, point=0.5)
    assert fs.poincare(0.5, (0, 0.1), condition="vanishing") > fs.poincare(0.5, [(0, 0.1), (0.8, 0.9)], condition="vanishing")


def test_interpolation_constants():
    # s = 1: 1/π and 1/π²
    within(fs.interpolation_constant(1.0, norm="derivative"), 1 / np.pi, 1e-6)
    within(fs.interpolation_constant(1.0, 2.0), 4 / np.pi**2, 1e-6)
    triangle = [(0, 0), (1, 0), (0, 1)]
    found = fs.interpolation_constant(1.0, triangle, "derivative", tol=1e-5)
    assert abs(found - 0.4887224) < 1e-6 and found < found.upper
    assert abs(found.extremal(1.0, 0.0)) < 1e-9


def test_contact_is_in_equilibrium_and_written(tmp_path):
    x = np.linspace(0.0, 1.0, 9)
    nodes = np.array([(a, b) for b in x for a in x])
    k = np.array([k for k in range(72) if k % 9 < 8])
    triangles = np.concatenate([np.c_[k, k + 1, k + 10], np.c_[k, k + 10, k + 9]])
    mesh, sides = (nodes, triangles), {"contact": lambda x, y: y == 0.0, "clamped": lambda x, y: y == 1.0}
    for cone in ["nodal", "midpoint"]:
        found = fs.contact.solve(mesh, lambda x, y: (0.0, 1.0 - 3.0 * x), groups=sides, cone=cone)
        assert found.residual < 1e-12
        assert found.displacement.shape == (81, 2)
    found = fs.contact.solve(mesh, lambda x, y: (0.0, 1.0 - 3.0 * x), groups=sides)
    assert np.all(found.normal_displacement <= 1e-15) and np.all(found.pressure >= -1e-12)
    assert np.allclose(found.normal_displacement, -found.displacement[found.contact_nodes, 1])
    same = fs.contact.solve(mesh, np.c_[np.zeros(81), 1.0 - 3.0 * nodes[:, 0]], groups=sides)
    assert abs(same.energy / found.energy - 1.0) < 1e-12
    scalar = fs.contact.solve(mesh, 1.0, groups=sides, lame=None)
    assert scalar.displacement.shape == (81,)
    with pytest.raises(fs.SobolevError, match="is inside the body"):
        fs.contact.solve(mesh, groups={**sides, "contact": [(40, 41)]})
    meshio = pytest.importorskip("meshio")
    found.to_vtk(tmp_path / "block.vtu")
    read = meshio.read(tmp_path / "block.vtu")
    assert np.array_equal(read.points[:, :2], nodes)
    assert np.array_equal(read.point_data["displacement"][:, :2], found.displacement)


def test_errors_carry_the_best_value():
    with pytest.raises(fs.ToleranceNotMet) as refused:
        fs.poincare(0.25, (0.0, 0.5), tol=1e-15)
    assert refused.value.best.error / refused.value.best < 1e-11
    with pytest.raises(fs.SobolevError, match="outside"):
        fs.norm([0.0, 1.0], 2.5)
    with pytest.raises(ZeroDivisionError):
        fs.norm(lambda x: 1 / 0, 0.5)
    with pytest.raises(TypeError):
        fs.norm(lambda x: "text", 0.5)


def test_a_result_behaves_as_a_float():
    found = fs.norm([0.0, 1.0], 0.5)
    assert isinstance(found, float) and found.value == float(found) == found
    assert found + 1.0 == found.value + 1.0 and np.float64(found) == found.value
    assert repr(fs.Estimate(1.4683710872361, 7e-12)) == "1.468371087236 ± 7e-12"
    assert repr(fs.Estimate(-2.5e-20, 1e-23)) == "-2.500e-20 ± 1e-23"
    assert repr(fs.Estimate(0.0, 0.0)) == "0.0"


def test_ctrl_c_ends_a_computation():
    def slow(x):
        time.sleep(0.01)
        return abs(x - 0.3) ** 0.1

    # a process started in the background of a shell ignores the signal
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    threading.Timer(0.3, signal.raise_signal, [signal.SIGINT]).start()
    start = time.monotonic()
    try:
        with pytest.raises(KeyboardInterrupt):
            fs.seminorm(slow, 0.5, tol=1e-12)
    finally:
        signal.signal(signal.SIGINT, before)
    assert time.monotonic() - start < 60.0


def test_other_threads_run_meanwhile():
    count = 0
    done = threading.Event()

    def counting():
        nonlocal count
        while not done.is_set():
            count += 1
            time.sleep(0.001)

    beside = threading.Thread(target=counting)
    beside.start()
    fs.gram(np.linspace(0.0, 1.0, 20001) ** 1.5, 0.3)
    fs.norm(np.ones(200000) * np.arange(200000) % 7, 0.3)
    done.set()
    beside.join()
    assert count > 5
