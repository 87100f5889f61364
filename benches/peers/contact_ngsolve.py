"""The block of contact_scikit_fem.py by NGSolve, its sparse Cholesky factors and the same primal-dual active set."""

import sys
import time

import netgen.meshing as ng
import numpy as np
from ngsolve import BilinearForm, BitArray, Grad, GridFunction, H1, InnerProduct, LinearForm, Mesh, Sym
from ngsolve import SetNumThreads, Trace, VectorH1, dx


def structured(n):
    mesh = ng.Mesh(dim=2)
    at = [mesh.Add(ng.MeshPoint(ng.Pnt(i / n, j / n, 0))) for j in range(n + 1) for i in range(n + 1)]
    mesh.Add(ng.FaceDescriptor(surfnr=1, domin=1, bc=1))
    node = lambda i, j: at[j * (n + 1) + i]
    for j in range(n):
        for i in range(n):
            a, b, c, d = node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)
            mesh.Add(ng.Element2D(1, [a, b, c]))
            mesh.Add(ng.Element2D(1, [a, c, d]))
    for i in range(n):
        mesh.Add(ng.Element1D([node(i, 0), node(i + 1, 0)], index=1))
        mesh.Add(ng.Element1D([node(i + 1, n), node(i, n)], index=2))
    mesh.SetBCName(0, "bottom")
    mesh.SetBCName(1, "top")
    return Mesh(mesh)


SetNumThreads(1)
print("   n  data s  solution s  steps  nodes in contact  J")
for n in map(int, sys.argv[1:] or [64, 128, 256, 512]):
    mesh = structured(n)
    start = time.process_time()
    space, nodes = VectorH1(mesh, order=1, dirichlet="top"), (n + 1) ** 2
    u, v = space.TnT()
    e, d = Sym(Grad(u)), Sym(Grad(v))
    a = BilinearForm((Trace(e) * Trace(d) + 2 * InnerProduct(e, d)) * dx).Assemble()
    f = GridFunction(H1(mesh, order=1))
    f.vec.FV().NumPy()[:] = [-np.cos(np.pi * p.point[0]) for p in mesh.vertices]
    load = LinearForm(f * v[1] * dx).Assemble()
    assembled = time.process_time()
    contact = nodes + np.arange(n + 1)  # u_y at the bottom
    w, rest = load.vec.CreateVector(), load.vec.CreateVector()
    active = np.ones(n + 1, bool)
    for steps in range(1, 100):
        free = BitArray(space.FreeDofs())
        for i in contact[active]:
            free[int(i)] = False
        w.data = a.mat.Inverse(free, inverse="sparsecholesky") * load.vec
        rest.data = a.mat * w - load.vec
        value, force = w.FV().NumPy()[contact], rest.FV().NumPy()[contact]
        new = np.where(active, force > 0, value < 0)
        if (new == active).all():
            break
        active = new
    end = time.process_time()
    energy = 0.5 * InnerProduct(rest, w) - 0.5 * InnerProduct(load.vec, w)
    print(f"{n:4d}  {assembled - start:10.3f}  {end - assembled:10.3f}  {steps:5d}  {active.sum():16d}  {energy:.15e}", flush=True)
