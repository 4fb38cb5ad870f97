# SPDX-License-Identifier: BSD-3-Clause
"""Exceptions: one class for each kind of failure, all of them surfmesh.Error."""

from __future__ import annotations

from typing import Dict, Type


class Error(Exception):
    """Base of all errors of surfmesh. `code` tells the kind as reports name it."""

    code: str = ""


class InvalidInput(Error, ValueError):
    """A file, array, formula, cage or model that cannot be read or makes no sense."""

    code = "invalid input"


class InvalidOption(Error, ValueError):
    """An unknown option, or a value outside its range."""

    code = "invalid option"


class MissingProperty(Error, LookupError):
    """A mesh lacks what is asked for, such as the metric of its corners."""

    code = "missing property"


class FileError(Error, OSError):
    """A file that cannot be opened, read or written."""

    code = "io"


class GeometryError(Error, ArithmeticError):
    """A surface or boundary that cannot be meshed."""

    code = "geometry"


class LimitError(Error, RuntimeError):
    """A limit is exceeded: of elements, or of samples of a function."""

    code = "limit"


class Cancelled(Error):
    """The run was ended by its progress function."""

    code = "cancelled"


class PrecisionWarning(UserWarning):
    """A function of sizes was tabulated less precisely than asked for."""


_TYPES: Dict[str, Type[Error]] = {
    kind.code: kind
    for kind in (
        InvalidInput,
        InvalidOption,
        MissingProperty,
        FileError,
        GeometryError,
        LimitError,
        Cancelled,
    )
}


def error_type(code: str) -> Type[Error]:
    """The class for a code of the library."""
    return _TYPES.get(code, Error)
