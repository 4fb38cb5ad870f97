# SPDX-License-Identifier: BSD-3-Clause
"""Meshes of smooth surfaces, of triangles or quads, that follow the surface.

    import surfmesh

    mesh = surfmesh.mesh("knob.obj", hmax="3%")
    mesh.points, mesh.triangles, mesh.report["quality"]
    mesh.write("knob.ply")
"""

from . import _surfmesh
from ._errors import (
    Cancelled,
    Error,
    FileError,
    GeometryError,
    InvalidInput,
    InvalidOption,
    LimitError,
    MissingProperty,
    PrecisionWarning,
)
from ._mesh import Mesh
from ._model import Model
from ._options import Option, options
from ._run import check, estimate, mesh, read, read_mesh
from ._surfmesh import Notice, formula_functions
from ._types import Sampling, Tabulation

__version__: str = _surfmesh.version

__all__ = [
    "Cancelled",
    "Error",
    "FileError",
    "GeometryError",
    "InvalidInput",
    "InvalidOption",
    "LimitError",
    "MissingProperty",
    "Mesh",
    "Model",
    "Notice",
    "Option",
    "PrecisionWarning",
    "Sampling",
    "Tabulation",
    "check",
    "estimate",
    "formula_functions",
    "mesh",
    "options",
    "read",
    "read_mesh",
]
