"""The lines of laplacian_numpy.py by PyNucleus (from its repository; the package of that name on the index is another program).

Its hierarchical matrix on equal and on graded elements, and its conjugate gradients with the diagonal as preconditioner.
"""

import math
import sys
import time

import numpy as np
from PyNucleus import dofmapFactory, functionFactory, kernelFactory, solverFactory
from PyNucleus_base.myTypes import INDEX
from PyNucleus_fem.mesh import mesh1d


def interval(n, power):
    half = (2.0 * np.arange(n // 2 + 1) / n) ** power
    nodes = np.concatenate([half - 1.0, 1.0 - half[-2::-1]])
    cells = np.stack([np.arange(n), np.arange(1, n + 1)], axis=1).astype(INDEX)
    return mesh1d(nodes[:, None].copy(), cells)


print("   s      N  mesh    data s  product s  solution s  energy            exact             rel. error")
for s in [0.25, 0.5, 0.75]:
    exact = math.pi / (4**s * math.gamma(0.5 + s) * math.gamma(1.5 + s))
    for n in map(int, sys.argv[1:] or [1024, 4096, 16384]):
        for name, power in [("equal", 1), ("graded", 4)]:
            start = time.process_time()
            space = dofmapFactory("P1", interval(n, power))
            kernel = kernelFactory("fractional", dim=1, s=s, horizon=math.inf)
            a = space.assembleNonlocal(kernel, matrixFormat="H2")
            load = space.assembleRHS(functionFactory("constant", 1.0))
            assembled = time.process_time()
            for _ in range(10):
                a * load
            multiplied = time.process_time()
            solver = solverFactory("cg-jacobi", A=a, setup=True)
            solver.tolerance, solver.maxIter = 1e-10, 20000
            u = space.zeros()
            solver(load, u)
            energy = load.inner(u)
            end = time.process_time()
            print(
                f"{s:4}  {n:5d}  {name:6}  {assembled - start:6.3f}  {(multiplied - assembled) / 10:9.5f}"
                f"  {end - multiplied:10.4f}  {energy:.14f}  {exact:.14f}  {1 - energy / exact:10.1e}",
                flush=True,
            )
