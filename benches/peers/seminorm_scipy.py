"""|x^a| of order s on (0, 1) by scipy.integrate, with the error that it states and the true one.

|u|^2 = 2 int_0^1 int_0^{1-r} (u(y+r) - u(y))^2 dy dr / r^(1+2s): r is the distance of the two points, which takes the
singularity to one side.  The same line of the toolkit: `cargo bench --bench peers`.
"""

import time
import warnings

from scipy.integrate import IntegrationWarning, dblquad

# a, s, and the square by Beta functions with 40 digits (mpmath)
CASES = [(0.5, 0.3, 0.426414239061621), (1.3, 0.9, 8.8561782580759167), (0.3, 0.7, 2.4995742088351783), (0.1, 0.58, 1.4793853925017649)]

print("   a     s  processor s  square              stated error  true error")
for a, s, exact in CASES:
    start = time.process_time()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", IntegrationWarning)
        value, stated = dblquad(
            lambda y, r: 2.0 * ((y + r) ** a - y**a) ** 2 / r ** (1 + 2 * s), 0, 1, 0, lambda r: 1 - r
        )
    seconds = time.process_time() - start
    print(f"{a:4}  {s:4}  {seconds:11.4f}  {value:.16f}  {stated / exact:12.1e}  {abs(value - exact) / exact:10.1e}")
