"""The block on a rigid floor (TestProblem::Block) by scikit-fem and a primal-dual active set.

Unit square, n x n squares cut from bottom left to top right, plane strain with lambda = mu = 1, u = 0 at the top, the P1
interpolant of f = (0, -cos(pi x)), u_y >= 0 at the nodes of the bottom.  Prints processor seconds of assembly and of the
solution, the number of steps, and J = a(u,u)/2 - l(u), to be compared with `cargo bench --bench peers`.
"""

import sys
import time

import numpy as np
from scipy.sparse.linalg import splu
from skfem import Basis, BilinearForm, ElementTriP1, ElementVector, LinearForm, MeshTri, asm
from skfem.helpers import ddot, sym_grad, trace


@BilinearForm
def elastic(u, v, w):
    e, d = sym_grad(u), sym_grad(v)
    return trace(e) * trace(d) + 2.0 * ddot(e, d)


@LinearForm
def load(v, w):
    return w["f"] * v[1]


def mesh(n):
    x = np.linspace(0, 1, n + 1)
    i, j = (a.ravel() for a in np.meshgrid(np.arange(n), np.arange(n)))
    a, b, c, d = ((j + dj) * (n + 1) + i + di for di, dj in [(0, 0), (1, 0), (1, 1), (0, 1)])
    nodes = np.vstack([np.tile(x, n + 1), np.repeat(x, n + 1)])
    return MeshTri(nodes, np.hstack([np.vstack([a, b, c]), np.vstack([a, c, d])]))


def solve(k, f, fixed, contact):
    """u with K u = f at free unknowns, u >= 0 at `contact` and a force that presses: steps until the set repeats."""
    u, active = np.zeros_like(f), np.ones(len(contact), bool)
    for step in range(1, 100):
        held = np.concatenate([fixed, contact[active]])
        free = np.setdiff1d(np.arange(len(f)), held)
        u[:] = 0.0
        inner = k[free][:, free].tocsc()
        factors = splu(inner, permc_spec="MMD_AT_PLUS_A", options={"SymmetricMode": True})
        u[free] = factors.solve(f[free])
        force = (k @ u - f)[contact]  # upwards, of the floor
        new = np.where(active, force > 0, u[contact] < 0)
        if (new == active).all():
            return u, step
        active = new
    raise RuntimeError("no convergence")


print("   n  data s  solution s  steps  nodes in contact  J")
for n in map(int, sys.argv[1:] or [64, 128, 256, 512]):
    start = time.process_time()
    m = mesh(n)
    basis = Basis(m, ElementVector(ElementTriP1()))
    k = asm(elastic, basis)
    scalar = basis.with_element(ElementTriP1())
    f = asm(load, basis, f=scalar.interpolate(-np.cos(np.pi * m.p[0])))
    assembled = time.process_time()
    bottom, top = np.arange(n + 1), n * (n + 1) + np.arange(n + 1)
    u, steps = solve(k.tocsr(), f, basis.nodal_dofs[:, top].ravel(), basis.nodal_dofs[1, bottom])
    end = time.process_time()
    energy = 0.5 * u @ (k @ u) - f @ u
    touching = int((u[basis.nodal_dofs[1, bottom]] == 0.0).sum())
    print(f"{n:4d}  {assembled - start:10.3f}  {end - assembled:10.3f}  {steps:5d}  {touching:16d}  {energy:.15e}", flush=True)
