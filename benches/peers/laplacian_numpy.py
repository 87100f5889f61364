"""(-Delta)^s u = 1 on (-1, 1), u = 0 outside, by NumPy's dense matrix of hat functions on N equal elements.

Prints processor seconds of assembly, product and solution, and the energy int u beside that of Getoor's solution
u = c (1 - x^2)^s.  `cargo bench --bench peers` has the same lines, and graded elements.
"""

import math
import sys
import time

import numpy as np
from scipy.linalg import cho_factor, cho_solve, toeplitz


def matrix(n, s):
    """Entries of the form C/2 int int (u(x)-u(y)) (v(x)-v(y)) / |x-y|^(1+2s): fourth differences of |k|^(3-2s)."""
    h, k = 2.0 / n, np.arange(n - 1, dtype=float)
    p = 3.0 - 2.0 * s
    if s == 0.5:
        power = lambda t: np.where(t == 0, 0.0, t**2 * np.log(np.abs(np.where(t == 0, 1.0, t)))) / (2 * math.pi)
    else:
        power = lambda t: np.abs(t) ** p / (2 * math.gamma(p + 1) * math.cos(math.pi * s))
    d = lambda t: power(t - 2) - 4 * power(t - 1) + 6 * power(t) - 4 * power(t + 1) + power(t + 2)
    return toeplitz(h ** (1 - 2 * s) * d(k))


print("   s      N  assembly s  product s  solution s  energy            exact             rel. error")
for s in [0.25, 0.5, 0.75]:
    c = math.gamma(0.5) / (4**s * math.gamma(1 + s) * math.gamma(0.5 + s))
    exact = c * math.sqrt(math.pi) * math.gamma(1 + s) / math.gamma(1.5 + s)
    for n in map(int, sys.argv[1:] or [1024, 2048, 4096]):
        start = time.process_time()
        a = matrix(n, s)
        assembled = time.process_time()
        load = np.full(n - 1, 2.0 / n)
        for _ in range(10):
            a @ load
        multiplied = time.process_time()
        energy = load @ cho_solve(cho_factor(a, overwrite_a=True), load)
        end = time.process_time()
        print(
            f"{s:4}  {n:5d}  {assembled - start:10.4f}  {(multiplied - assembled) / 10:9.5f}  {end - multiplied:10.4f}"
            f"  {energy:.14f}  {exact:.14f}  {1 - energy / exact:10.1e}"
        )
