# SPDX-License-Identifier: BSD-3-Clause
"""Checks of what users hand in: every fault is told by its name and place."""

from __future__ import annotations

import numbers
from typing import Any, Callable, List, Optional, Sequence, Tuple

import numpy as np

from ._errors import InvalidInput


def array(name: str, value: Any, shape: Sequence[Optional[int]], least: int = 0) -> np.ndarray:
    """A contiguous array of finite doubles of a shape; None stands for any number from `least`.

    It is a copy: what its owner does to the array afterwards changes nothing here.
    """
    result = doubles(f"{name} is", value).copy()
    fits = result.ndim == len(shape) and all(
        n == given if n is not None else given >= least
        for n, given in zip(shape, result.shape)
    )
    if not fits:
        wanted = ", ".join("n" if n is None else str(n) for n in shape)
        at_least = f" with n at least {least}" if least else ""
        raise InvalidInput(f"{name} has the shape {result.shape}, not ({wanted}){at_least}")
    check_finite(name, result)
    return result


def doubles(subject: str, value: Any) -> np.ndarray:
    """A contiguous array of doubles; `subject` begins the message, "points is" no array."""
    try:
        raw = np.asarray(value)
        if raw.dtype.kind in "cSUmM":
            raise TypeError(f"its entries are of type {raw.dtype}")
        return np.asarray(raw, dtype=np.float64, order="C")
    except (TypeError, ValueError) as error:
        raise InvalidInput(f"{subject} no array of real numbers: {error}") from None


def check_finite(name: str, values: np.ndarray) -> None:
    """Raise InvalidInput for the first entry that is not finite."""
    bad = ~np.isfinite(values)
    if bad.any():
        place = [int(i) for i in np.argwhere(bad)[0]]
        raise InvalidInput(f"{name}{place} is {values[tuple(place)]}, which is not finite")


def integers(name: str, value: Any) -> np.ndarray:
    """A flat array of ints that are whole numbers."""
    result = np.asarray(value)
    if result.size == 0:
        return np.zeros(0, dtype=np.intc)
    if result.dtype.kind not in "iu":
        raise InvalidInput(f"{name} has entries of type {result.dtype}, not whole numbers")
    if result.min() < np.iinfo(np.intc).min or result.max() > np.iinfo(np.intc).max:
        raise InvalidInput(f"{name} has an entry beyond the range of 32 bits")
    return np.ascontiguousarray(result.ravel(), dtype=np.intc)


def faces(value: Any, vertices: int) -> Tuple[np.ndarray, np.ndarray]:
    """Vertices of faces, one after the other, and where each begins."""
    if isinstance(value, np.ndarray) and value.ndim == 2:
        flat = integers("faces", value)
        offsets = np.arange(len(value) + 1, dtype=np.intc) * value.shape[1]
    elif isinstance(value, tuple) and len(value) == 2 and all(
        isinstance(part, np.ndarray) for part in value
    ):
        offsets, flat = (integers("faces", part) for part in value)
    else:
        try:
            rows = [integers(f"faces[{i}]", face) for i, face in enumerate(value)]
        except TypeError:
            raise InvalidInput("faces is no list of faces") from None
        flat = np.concatenate(rows) if rows else np.zeros(0, dtype=np.intc)
        offsets = np.concatenate([[0], np.cumsum([len(row) for row in rows])])
    offsets = offsets.astype(np.intc)
    if len(offsets) < 2:
        raise InvalidInput("there are no faces")
    if offsets[0] != 0 or offsets[-1] != len(flat) or (np.diff(offsets) < 3).any():
        raise InvalidInput("faces have at least three corners, and offsets ascend from 0 to "
                           "the number of corners")
    if flat.min() < 0 or flat.max() >= vertices:
        raise InvalidInput(f"faces name vertex {flat.min() if flat.min() < 0 else flat.max()}, "
                           f"but there are {vertices}, from 0")
    return flat, offsets


def interval(name: str, value: Any) -> Tuple[float, float]:
    """Two numbers that ascend."""
    low, high = (float(x) for x in array(name, value, (2,)))
    if not low < high:
        raise InvalidInput(f"{name} = ({low}, {high}) does not ascend")
    return low, high


def length(name: str, value: Any) -> str:
    """A length as the library reads it: a number in model units, or text with %."""
    if isinstance(value, str):
        return value
    if isinstance(value, numbers.Real) and not isinstance(value, (bool, np.bool_)):
        if not np.isfinite(value) or value < 0:
            raise InvalidInput(f"{name} = {value} is no length")
        return repr(float(value))
    raise InvalidInput(f"{name} = {value!r} is no length: those are numbers, or text like \"2%\"")


Size = Tuple[str, str, float]


def size(value: Any, angle: float = 0.0) -> Size:
    """A size, or sizes along and across with the angle between the first and p_u in degrees."""
    if isinstance(value, (tuple, list)):
        if len(value) != 2:
            raise InvalidInput(f"size = {value!r} is no length and no pair of lengths")
        along, across = value
    else:
        along = across = value
    if isinstance(angle, bool) or not isinstance(angle, numbers.Real) or not np.isfinite(angle):
        raise InvalidInput(f"angle = {angle!r} is no number of degrees")
    return length("size", along), length("size", across), float(np.radians(angle))


def wish(value: Any, angle: float, radius: Any, outer: Any, outer_radius: Any) -> Tuple:
    """A size with its radius, and the size farther away with its own."""
    if (outer is None) != (outer_radius is None):
        raise InvalidInput("outer and outer_radius belong together")
    far = None if outer is None else (size(outer, angle), length("outer_radius", outer_radius))
    return size(value, angle), length("radius", radius), far


def names(name: str, value: Any) -> List[str]:
    """A name, or a list of names."""
    if isinstance(value, str):
        return [value]
    result = list(value)
    if not all(isinstance(entry, str) for entry in result):
        raise InvalidInput(f"{name} is no list of names")
    return result


def batched(function: Callable[..., Any], width: int, what: str) -> Callable[..., np.ndarray]:
    """Wrap a function of arrays so that its results are checked: (n, width) doubles.

    A function of points may return a tuple of its coordinates, and constants for some of them.
    """
    if not callable(function):
        raise InvalidInput(f"{what} is no function")

    def call(*coordinates: np.ndarray) -> np.ndarray:
        count = len(coordinates[0])
        result = function(*coordinates)
        if width > 1 and isinstance(result, (tuple, list)) and len(result) == width:
            parts = [doubles(f"{what} returned", part) for part in result]
            try:
                result = np.stack([np.broadcast_to(part, count) for part in parts], axis=1)
            except ValueError as error:
                raise InvalidInput(
                    f"{what} returned no {width} arrays of {count}: {error}"
                ) from None
        values = doubles(f"{what} returned", result)
        wanted = (count, width) if width > 1 else (count,)
        if values.shape == () and width == 1:
            values = np.full(count, float(values))
        if values.shape != wanted:
            raise InvalidInput(f"{what} returned an array of the shape {values.shape} for "
                               f"{count} points, not {wanted}")
        return values

    return call


def positive(function: Callable[..., np.ndarray], what: str) -> Callable[..., np.ndarray]:
    """A wrapped function of sizes, which are above 0."""

    def call(*coordinates: np.ndarray) -> np.ndarray:
        values = function(*coordinates)
        bad = ~(np.isfinite(values) & (values > 0))
        if bad.any():
            i = int(np.argmax(bad))
            place = ", ".join(f"{float(part[i]):g}" for part in coordinates)
            raise InvalidInput(f"{what} returned {values[i]:g} at ({place}); sizes are above 0")
        return values

    return call


def positive_definite(function: Callable[..., np.ndarray], what: str) -> Callable[..., np.ndarray]:
    """A wrapped function of metrics m11, m12, m22."""

    def call(*coordinates: np.ndarray) -> np.ndarray:
        values = function(*coordinates)
        i = first_indefinite(values)
        if i is not None:
            place = ", ".join(f"{float(part[i]):g}" for part in coordinates)
            raise InvalidInput(f"{what} returned {values[i]} at ({place}), which is not "
                               "positive definite")
        return values

    return call


def first_indefinite(metrics: np.ndarray) -> Optional[int]:
    """The index of the first metric m11, m12, m22 that is not positive definite."""
    m11, m12, m22 = metrics.T
    with np.errstate(invalid="ignore", over="ignore"):
        good = np.isfinite(metrics).all(axis=1) & (m11 > 0) & (m11 * m22 - m12 * m12 > 0)
    return None if good.all() else int(np.argmin(good))
