# SPDX-License-Identifier: BSD-3-Clause
"""What surfmesh does: read, mesh, estimate, check."""

from __future__ import annotations

import json
import os
from typing import Any, Callable, Dict, Optional, Tuple, Union

from . import _surfmesh
from ._errors import InvalidInput
from ._mesh import Mesh, Path
from ._model import Model
from ._options import Settings, documented, options, settings_of

Progress = Callable[[str, int, int, int], Any]

_ALL = ("sizes", "control space", "meshing", "model")


@documented(*_ALL)
def read(path: Path, *, scheme: str = "auto", progress: Optional[Progress] = None,
         **keywords: Any) -> Model:
    """Read a control cage (.obj, .off, .ply, .stl, .om), a model file (.json) or a CAD file (.step, .igs, .brep).

    `scheme` is the subdivision of cages: "auto", "catmark", "loop" or "bilinear". Options of the
    model act here; others become those of its meshes. CAD files need surfmesh built with
    OpenCASCADE. Raises FileError, InvalidInput, InvalidOption, GeometryError.
    """
    settings = settings_of(keywords)
    held = _surfmesh.read(os.fspath(path), settings, scheme, progress)
    return Model._of_file(held, settings)


@documented(*_ALL)
def mesh(model: Union[Model, Path], *, scheme: str = "auto", progress: Optional[Progress] = None,
         **keywords: Any) -> Mesh:
    """Mesh a model, or a file that surfmesh.read reads.

    Options are those of the command line, with _ in their names: hmax=0.1, hmax="2%", quads=True.
    `progress(stage, done, total, elements)` is called by this thread; the run ends with Cancelled
    if it returns False, and with what it raises. Ctrl-C ends a run as well. Other threads of Python
    go on meanwhile. The mesh is the same for any number of threads. `scheme` is the subdivision of
    cages; a Model that was read has that of surfmesh.read.

    Raises InvalidInput, InvalidOption, GeometryError, LimitError, Cancelled.
    """
    held, sources, settings = _asked(model, scheme, progress, keywords)
    return Mesh(_surfmesh.mesh(held, sources, settings, progress))


@documented(*_ALL)
def estimate(model: Union[Model, Path], *, scheme: str = "auto",
             progress: Optional[Progress] = None, **keywords: Any) -> Dict[str, Any]:
    """Estimate a mesh without making it: its report has `estimated_elements`.

    Otherwise as surfmesh.mesh.
    """
    held, sources, settings = _asked(model, scheme, progress, keywords)
    return json.loads(_surfmesh.estimate(held, sources, settings, progress))


def read_mesh(path: Path) -> Mesh:
    """Read a mesh, of any format that surfmesh writes."""
    return Mesh(_surfmesh.read_mesh(os.fspath(path)))


@documented("sizes", "model")
def check(mesh: Union[Mesh, Path], model: Union[None, Model, Path] = None, *,
          scheme: str = "auto", progress: Optional[Progress] = None,
          **keywords: Any) -> Dict[str, Any]:
    """Tell what a mesh is like, what is wrong with it, and how it fits its model.

    mesh is a Mesh or a file, which is checked exactly as it stands there. The result is that of
    `surfmesh check --json`: `clean`, `faults`, `counts`, `angles`, ..., with a model `fit`.
    """
    held: Optional[_surfmesh.HeldInput] = None
    sources, settings = _surfmesh.HeldSources(), []
    if model is not None:
        held, sources, settings = _asked(model, scheme, progress, keywords)
    elif keywords or scheme != "auto":
        raise InvalidInput(f"{next(iter(keywords), 'scheme')} needs a model")
    if isinstance(mesh, Mesh):
        return json.loads(_surfmesh.check_held(mesh._held, held, sources, settings, progress))
    return json.loads(_surfmesh.check_file(os.fspath(mesh), held, sources, settings, progress))


def _asked(
    model: Union[Model, Path], scheme: str, progress: Optional[Progress], keywords: Dict[str, Any]
) -> Tuple[_surfmesh.HeldInput, _surfmesh.HeldSources, Settings]:
    """The model, read or built, the sizes that it asks for, and all settings for it."""
    if isinstance(model, Model):
        settings = model._settings + settings_of(keywords)
        of_model = {option.name for option in options() if option.group == "model"}
        known = [setting for setting in settings if setting[0] in of_model]
        return (*model._prepared(known, scheme), settings)
    if not isinstance(model, (str, os.PathLike)):
        raise InvalidInput(f"{model!r} is no model and no path")
    source = read(model, scheme=scheme, progress=progress, **keywords)
    return (*source._prepared(), source._settings)
