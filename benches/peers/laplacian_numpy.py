"""(-Delta)^s u = 1 on (-1, 1), u = 0 outside, by NumPy's dense matrix of hat functions, on N equal and on N graded elements.

Prints processor seconds of the matrix, a product and the solution, and the energy int u beside that of Getoor's solution
u = c (1 - x^2)^s.  `cargo bench --bench peers` has the same lines.  Graded: the nodes -1 + (2 k/N)^4 and their mirror images.
"""

import math
import sys
import time

import numpy as np
from scipy.linalg import cho_factor, cho_solve, lu_factor, lu_solve, toeplitz

FAR = 20


def kernel(s):
    """G with fourth derivative the kernel of the form C/2 int int (u(x)-u(y)) (v(x)-v(y)) / |x-y|^(1+2s)."""
    p = 3.0 - 2.0 * s
    if s == 0.5:
        return lambda t: np.where(t == 0, 0.0, t**2 * np.log(np.abs(np.where(t == 0, 1.0, t)))) / (2 * math.pi)
    return lambda t: np.abs(t) ** p / (2 * math.gamma(p + 1) * math.cos(math.pi * s))


def equal(n, s):
    """Fourth differences of G: one row is the whole matrix.  They cancel far from the diagonal, where the series
    D^4 + D^6/6 + D^8/80 + 17 D^10/30240 + 31 D^12/604800 in derivatives replaces them.  Load, matrix."""
    h, k, g, e = 2.0 / n, np.arange(n - 1, dtype=float), kernel(s), -1.0 - 2.0 * s
    row = g(k - 2) - 4 * g(k - 1) + 6 * g(k) - 4 * g(k + 1) + g(k + 2)
    far = k[FAR:]
    term = -(4**s) * s * math.gamma(s + 0.5) / (math.sqrt(math.pi) * math.gamma(1 - s)) * far**e  # D^4
    row[FAR:] = 0.0
    for j, c in enumerate([1.0, 1 / 6, 1 / 80, 17 / 30240, 31 / 604800]):
        row[FAR:] += c * term
        term = term * (e - 2 * j) * (e - 2 * j - 1) / far**2
    return np.full(n - 1, h), toeplitz(h ** (1 - 2 * s) * row)


def graded(n, s):
    """Second divided differences of G(x_i - x_j) in i and in j; they cancel where elements are short.  Load, matrix."""
    half = (2.0 * np.arange(n // 2 + 1) / n) ** 4
    x = np.concatenate([half - 1.0, 1.0 - half[-2::-1]])
    h = np.diff(x)
    a = kernel(s)(x[:, None] - x[None, :])
    for _ in range(2):
        a = np.diff(np.diff(a, axis=0) / h[:, None], axis=0).T
    return 0.5 * (h[1:] + h[:-1]), 0.5 * (a + a.T)


print("   s      N  mesh    data s  product s  solution s  energy            exact             rel. error")
for s in [0.25, 0.5, 0.75]:
    c = math.gamma(0.5) / (4**s * math.gamma(1 + s) * math.gamma(0.5 + s))
    exact = c * math.sqrt(math.pi) * math.gamma(1 + s) / math.gamma(1.5 + s)
    for n in map(int, sys.argv[1:] or [1024, 2048, 4096]):
        for name, assemble in [("equal", equal), ("graded", graded)]:
            start = time.process_time()
            load, a = assemble(n, s)
            assembled = time.process_time()
            for _ in range(10):
                a @ load
            multiplied = time.process_time()
            try:
                u = cho_solve(cho_factor(a), load)
            except np.linalg.LinAlgError:  # rounding has left the matrix indefinite
                u = lu_solve(lu_factor(a), load)
            energy = load @ u
            end = time.process_time()
            print(
                f"{s:4}  {n:5d}  {name:6}  {assembled - start:6.4f}  {(multiplied - assembled) / 10:9.5f}"
                f"  {end - multiplied:10.4f}  {energy:.14f}  {exact:.14f}  {1 - energy / exact:10.1e}",
                flush=True,
            )
