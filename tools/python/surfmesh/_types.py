# SPDX-License-Identifier: BSD-3-Clause
"""Types of arguments and results of models."""

from __future__ import annotations

from typing import Any, Callable, NamedTuple, Sequence, Tuple, Union

Length = Union[float, str]
Size = Union[Length, Tuple[Length, Length]]
Where = Union[None, int, str, Sequence[Union[int, str]]]
Function = Callable[..., Any]
Interval = Tuple[float, float]
Loops = Sequence[Union[str, Sequence[str]]]
Range = Sequence[float]

#: Points at which a curve given as a function is taken.
CURVE_POINTS = 257


class Sampling(NamedTuple):
    """How a function became a surface.

    error is the greatest distance measured between the two, model units, and `at` its (u, v);
    samples are those along u and v that the spline passes through.
    """

    error: float
    at: Tuple[float, float]
    samples: Tuple[int, int]
    evaluations: int


class Tabulation(NamedTuple):
    """How a function of sizes became a table: greatest relative error of sizes, and entries."""

    error: float
    entries: int
