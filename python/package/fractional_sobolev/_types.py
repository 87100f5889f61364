"""Numbers with an error, and the exceptions."""

from __future__ import annotations

from math import floor, isfinite, log10
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from typing_extensions import Self

__all__ = ["Estimate", "InfiniteNorm", "SobolevError", "ToleranceNotMet"]


class Estimate(float):
    """A float with its absolute error and its work.

    Attributes
    ----------
    value : float
        The value.
    error : float
        Estimated absolute error, at least the rounding of the value.
    work : int
        Evaluations, pairs of elements, iterations and factorizations together.

    Examples
    --------
    >>> print(Estimate(1.4683710872361, 7e-12, 100))
    1.468371087236 ± 7e-12
    """

    __slots__ = ("error", "work")
    error: float
    work: int

    def __new__(cls, value: float, error: float = 0.0, work: int = 0) -> Self:
        made = super().__new__(cls, value)
        made.error = error
        made.work = work
        return made

    def __getnewargs__(self):
        return (float(self), self.error, self.work)

    @property
    def value(self) -> float:
        return float(self)

    def __repr__(self) -> str:
        if not (isfinite(self.error) and 0.0 < self.error):
            return float.__repr__(float(self))
        exponent = floor(log10(abs(self))) if float(self) != 0.0 else 0
        last = floor(log10(self.error))  # place of the first digit of the error
        error = f"{self.error:.0e}".replace("e-0", "e-").replace("e+0", "e+")
        if -5 < exponent < 16 and last <= 0:
            return f"{float(self):.{min(-last, 20)}f} ± {error}"
        return f"{float(self):.{max(exponent - last, 0)}e} ± {error}"

    __str__ = __repr__


class SobolevError(ValueError):
    """A question without an answer, or without one that can be trusted.

    Attributes
    ----------
    best : Estimate or None
        The best value that was reached.
    """

    def __init__(self, message: str, best: Estimate | None = None) -> None:
        super().__init__(message)
        self.best = best


class ToleranceNotMet(SobolevError):
    """The tolerance could not be met; `best` holds what was reached."""


class InfiniteNorm(SobolevError):
    """The norm is infinite."""
