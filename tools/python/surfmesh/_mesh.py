# SPDX-License-Identifier: BSD-3-Clause
"""The mesh as NumPy arrays."""

from __future__ import annotations

import json
import os
from functools import cached_property
from typing import Any, Dict, List, Optional, Tuple, Union

import numpy as np

from . import _surfmesh
from ._errors import MissingProperty

Path = Union[str, "os.PathLike[str]"]


def _frozen(values: np.ndarray) -> np.ndarray:
    values.flags.writeable = False
    return values


class Mesh:
    """A mesh of a run or of a file.

    Arrays are made when they are first asked for, are kept, and are read only; copy one to change
    it. They stay valid after the mesh is gone. Corners are those of all faces, in the order of the
    faces; arrays by corner go along with the second array of `faces`.
    """

    def __init__(self, held: _surfmesh.HeldMesh) -> None:
        """Made by surfmesh.mesh and surfmesh.read_mesh."""
        self._held = held

    def __repr__(self) -> str:
        vertices, _, faces = self._held.counts()
        return f"<surfmesh.Mesh of {vertices} vertices and {faces} faces>"

    @cached_property
    def points(self) -> np.ndarray:
        """Positions of the vertices (n, 3): those of the half-edge mesh itself, without a copy."""
        return self._held.points()

    @cached_property
    def triangles(self) -> np.ndarray:
        """Vertices of the triangles (t, 3), counter-clockwise seen from outside."""
        return _frozen(self._held.faces_of(3))

    @cached_property
    def quads(self) -> np.ndarray:
        """Vertices of the quads (q, 4), counter-clockwise seen from outside."""
        return _frozen(self._held.faces_of(4))

    @cached_property
    def faces(self) -> Tuple[np.ndarray, np.ndarray]:
        """Faces of any number of corners: offsets (f + 1) and vertices (c).

        Face i has the vertices `corners[offsets[i]:offsets[i + 1]]`.
        """
        return _frozen(self._held.offsets()), _frozen(self._held.corners())

    @cached_property
    def corner_faces(self) -> np.ndarray:
        """The face of each corner (c)."""
        sizes = np.diff(self.faces[0])
        return _frozen(np.repeat(np.arange(len(sizes)), sizes))

    @cached_property
    def triangle_faces(self) -> np.ndarray:
        """Which of all faces the triangles are (t): patch[triangle_faces] are their patches."""
        return _frozen(np.flatnonzero(np.diff(self.faces[0]) == 3))

    @cached_property
    def quad_faces(self) -> np.ndarray:
        """Which of all faces the quads are (q)."""
        return _frozen(np.flatnonzero(np.diff(self.faces[0]) == 4))

    @cached_property
    def original(self) -> np.ndarray:
        """The vertex of which each one is a copy, or itself (n).

        Where more than two patches meet, a half-edge mesh has several vertices for one point:
        `original[triangles]` are triangles that are joined there, too.
        """
        return _frozen(self._held.original())

    @cached_property
    def patch(self) -> np.ndarray:
        """Patch of each face (f)."""
        return _frozen(self._needed(self._held.patch(), "patches"))

    @cached_property
    def group(self) -> np.ndarray:
        """First group of the patch of each face (f), -1 for none: an index in list(groups)."""
        patches, place = np.unique(self.patch, return_inverse=True)
        first = np.full(len(patches), -1)
        for index, members in reversed(list(enumerate(self.groups.values()))):
            first[np.isin(patches, members)] = index
        return _frozen(first[place])

    @cached_property
    def uv(self) -> np.ndarray:
        """Parameters of the corners (c, 2) in the patch of their face.

        Those of corners that are `beyond` their patch must not be evaluated.
        """
        return _frozen(self._needed(self._held.uv(), "parameters of its corners"))

    @cached_property
    def metric(self) -> np.ndarray:
        """Metric of the corners (c, 3) as m11, m12, m22 in (u,v): 1 is the wanted length."""
        return _frozen(self._needed(self._held.metric(), "metric of its corners"))

    @cached_property
    def normals(self) -> np.ndarray:
        """Normals of the surface at the corners (c, 3); made with the option normals=True."""
        what = "normals: ask for them with normals=True"
        return _frozen(self._needed(self._held.normals(), what))

    @cached_property
    def beyond(self) -> np.ndarray:
        """True for corners (c) of elements across a contour that lie beyond their face's patch."""
        return _frozen(self._held.beyond())

    @cached_property
    def contour_edges(self) -> np.ndarray:
        """Edges on contours (k, 3): the vertices of both ends, and the contour."""
        return _frozen(self._held.contour_edges())

    @cached_property
    def patch_names(self) -> List[str]:
        """Names of the patches; "" for none."""
        return self._held.patch_names()

    @cached_property
    def contour_names(self) -> List[str]:
        """Names of the contours; "" for none."""
        return self._held.contour_names()

    @cached_property
    def groups(self) -> Dict[str, np.ndarray]:
        """Patches of each group."""
        return {
            name: _frozen(np.array(patches, dtype=np.intc)) for name, patches in self._held.groups()
        }

    @property
    def fields(self) -> List[str]:
        """Names of the fields that this mesh has: "quality", "size", "valence", ..."""
        return self._held.fields()

    def field(self, name: str) -> np.ndarray:
        """Values of a field, by face, "valence" by vertex; NaN where there is none.

        patch, group; quality (1 is best, in the metric), shape (in space), size (asked for by the
        metric), stretch, length (of the side farthest from 1 in the metric), valence, sag (where
        a run measured it).
        """
        return self._held.field(name)

    @cached_property
    def report(self) -> Optional[Dict[str, Any]]:
        """The report of the run as `surfmesh mesh --report` has it; None for a mesh of a file."""
        text = self._held.report()
        return None if text is None else json.loads(text)

    @cached_property
    def notices(self) -> List[_surfmesh.Notice]:
        """What there is to tell of the run, or of reading the file."""
        return self._held.notices()

    @property
    def has_shortfall(self) -> bool:
        """True if something that was asked for was not reached; a notice tells what."""
        return any(notice.severity == "shortfall" for notice in self.notices)

    def write(
        self, path: Path, *, uv: bool = False, normals: bool = False
    ) -> List[_surfmesh.Notice]:
        """Write the mesh; the ending selects the format. `.om` keeps everything.

        `uv` and `normals` add those of the corners where the format has a place for them. Returns
        notices of what the file has otherwise. Raises FileError, InvalidInput, MissingProperty.
        """
        if normals:
            self._needed(self._held.normals(), "normals: ask for them with normals=True")
        return self._held.write(os.fspath(path), uv, normals)

    @staticmethod
    def _needed(values: Optional[np.ndarray], what: str) -> np.ndarray:
        if values is None:
            raise MissingProperty(f"the mesh has no {what}")
        return values
