# SPDX-License-Identifier: BSD-3-Clause
"""Models built in Python, and sizes for those and for models that are read."""

from __future__ import annotations

import threading
import warnings
from contextlib import contextmanager
from typing import (Any, Callable, Dict, Iterator, List, Mapping, Optional, Sequence, Tuple,
                    Union)

import numpy as np

from . import _arrays, _surfmesh
from ._errors import InvalidInput, PrecisionWarning
from ._mesh import Mesh
from ._options import Settings
from ._places import patch_index, patch_indices, places, some_patches
from ._types import (CURVE_POINTS, Function, Interval, Length, Loops, Range, Sampling, Size,
                     Tabulation, Where)

_Wish = Callable[[_surfmesh.HeldSources, _surfmesh.HeldInput], None]


class Model:
    """Patches with their contours and groups, and the sizes that are asked for.

    A new one is empty: add cages and patches. `surfmesh.read` reads one, to which only sizes can
    be added. Lengths are numbers in model units, or text with %, shares of the model's diagonal.
    """

    def __init__(self) -> None:
        self._builder: Optional[_surfmesh.Builder] = _surfmesh.Builder()
        self._names: List[str] = []  # of patches
        self._settings: Settings = []
        self._input: Optional[_surfmesh.HeldInput] = None  # None once something was added
        self._key: Tuple[Settings, str] = ([], "auto")  # what _input was made with
        self._wishes: List[_Wish] = []
        self._sources: Optional[_surfmesh.HeldSources] = None  # None until all wishes are met
        self._lock = threading.RLock()  # of all that is above

    @classmethod
    def _of_file(cls, held: _surfmesh.HeldInput, settings: Settings) -> "Model":
        model = cls()
        model._builder = None
        model._input = held
        model._sources = _surfmesh.HeldSources()
        model._settings = settings
        return model

    def __repr__(self) -> str:
        origin = "built in Python" if self._builder else f"of {self._built().path()}"
        return f"<surfmesh.Model {origin}>"

    # Building.

    def add_patch(
        self,
        name: str,
        surface: Any,
        u: Range = (0.0, 1.0),
        v: Range = (0.0, 1.0),
        *,
        loops: Loops = (),
        where: Optional[Mapping[str, str]] = None,
        constants: Optional[Mapping[str, float]] = None,
        tolerance: Length = "1e-6%",
        max_samples: int = 4_000_000,
    ) -> Optional[Sampling]:
        """Add a patch over a rectangle of parameters.

        `surface` is one of
        - three formulas ("cos(u)", "sin(u)", "v"), or one for z over x = u, y = v; `where` has
          formulas that they may use by name, `constants` numbers. Derivatives are exact;
        - a function of two arrays u, v that returns points (n, 3), or a tuple of x, y, z. It is
          called in batches, and becomes a spline of degree 5 through samples: twice as many, until
          the spline is within `tolerance` of the function in the middle between all samples and
          at 4,096 other points. Returns the Sampling. A function that bends sharply inside takes
          a patch on either side; LimitError tells where, once max_samples do not do;
        - an array (rows along v, columns along u, 3): a spline of degree 5 through these points,
          at equal steps of u and v, six at least in each direction.

        `loops` trim the patch: lists of names of contours and of sides, "name:u0", end to end with
        the patch on the left, "-" before what is passed backwards; a name alone is a loop. Sides of
        patches that coincide are joined, within 1e-9 of the diagonal or four times the greatest
        error of the functions, whichever is more, unless the option `joining` says otherwise.
        """
        u_range, v_range = _arrays.interval("u", u), _arrays.interval("v", v)
        all_loops = [_arrays.names("loops", loop) for loop in loops]
        result = None
        with self._adding() as builder:
            if callable(surface):
                function = _arrays.batched(surface, 3, f"the surface of patch {name}")
                text = _arrays.length("tolerance", tolerance)
                found = builder.add_function(
                    name, function, u_range, v_range, all_loops, text, int(max_samples)
                )
                result = Sampling(*found)
            elif isinstance(surface, np.ndarray):
                points = _arrays.array("surface", surface, (None, None, 3), 6)
                builder.add_grid(name, points, u_range, v_range, all_loops)
            else:
                formulas = ("u", "v", surface) if isinstance(surface, str) else tuple(surface)
                if len(formulas) != 3 or not all(isinstance(text, str) for text in formulas):
                    raise InvalidInput(f"the surface of patch {name} is no function, no array, "
                                       "and not three formulas")
                builder.add_formulas(name, formulas, list((where or {}).items()),
                                     dict(constants or {}), u_range, v_range, all_loops)
            self._names.append(name)
        return result

    def add_nurbs(
        self,
        name: str,
        points: Any,
        knots: Tuple[Sequence[float], Sequence[float]],
        degree: Tuple[int, int] = (3, 3),
        *,
        weights: Any = None,
        periodic: Tuple[bool, bool] = (False, False),
        domain: Optional[Tuple[Interval, Interval]] = None,
        loops: Loops = (),
    ) -> None:
        """Add a B-spline or NURBS patch.

        points are (rows along v, columns along u, 3), weights (rows, columns); knots are those of u
        and v, as many as points + degree + 1, or if periodic those of one period. `domain` is a
        part of it. A crease belongs between two patches.
        """
        net = _arrays.array("points", points, (None, None, 3), 2)
        weight = None if weights is None else _arrays.array("weights", weights, net.shape[:2])
        lines = [_arrays.array("knots", row, (None,)).tolist() for row in knots]
        part = None
        if domain is not None:
            part = (_arrays.interval("domain[0]", domain[0]),
                    _arrays.interval("domain[1]", domain[1]))
        all_loops = [_arrays.names("loops", loop) for loop in loops]
        with self._adding() as builder:
            builder.add_nurbs(name, net, lines, list(degree), weight, list(periodic), part,
                              all_loops)
            self._names.append(name)

    def add_contour(
        self,
        name: str,
        on: Mapping[str, Any],
        *,
        smooth: bool = False,
        t: Range = (0.0, 1.0),
        constants: Optional[Mapping[str, float]] = None,
    ) -> None:
        """Add a contour that loops can name, as curves on patches: {"plate": curve}.

        A curve is one of
        - an array (n, 2) of (u, v): a polyline, whose kinks are corners of the mesh, or with
          `smooth` a spline of degree 5 through these points, which should lie evenly; repeat the
          first point at the end of a closed one;
        - two formulas of t, ("cos(t)", "sin(t)"), with t in the range;
        - a function of an array of t that returns (n, 2): it is taken at 257 points of the range;
        - None for another patch where the contour is found by projection.
        """
        if not on:
            raise InvalidInput(f"contour {name} is on no patch")
        with self._adding() as builder:
            trial = _surfmesh.Builder()  # so that nothing is left of a contour that fails
            trial.take_contours(builder)
            for patch, curve in on.items():
                self._add_curve(trial, name, patch, curve, smooth, t, dict(constants or {}))
            builder.take_contours(trial)

    @staticmethod
    def _add_curve(builder: _surfmesh.Builder, name: str, patch: str, curve: Any, smooth: bool,
                   t: Range, constants: Dict[str, float]) -> None:
        """Add the curve of a contour on one patch."""
        if curve is None:
            builder.add_contour_projection(name, patch)
        elif isinstance(curve, (tuple, list)) and all(isinstance(part, str) for part in curve):
            if len(curve) != 2:
                raise InvalidInput(f"contour {name} has formulas of u and v")
            builder.add_contour_formulas(name, patch, list(curve), _arrays.interval("t", t),
                                         constants)
        elif callable(curve):
            function = _arrays.batched(curve, 2, f"contour {name}")
            points = function(np.linspace(*_arrays.interval("t", t), CURVE_POINTS))
            _arrays.check_finite(f"contour {name}", points)
            builder.add_contour_points(name, patch, points, True)
        else:
            points = _arrays.array(f"contour {name}", curve, (None, 2), 6 if smooth else 2)
            builder.add_contour_points(name, patch, points, bool(smooth))

    def add_cage(
        self,
        vertices: Any,
        faces: Any,
        *,
        name: str = "",
        creases: Sequence[Tuple[Any, float]] = (),
        corners: Sequence[Tuple[int, float]] = (),
        holes: Sequence[int] = (),
        groups: Optional[Mapping[str, Any]] = None,
        group_creases: Optional[Mapping[str, float]] = None,
    ) -> None:
        """Add a control cage, which stands for its subdivision limit surface.

        vertices are (n, 3). faces are an array (f, 3) or (f, 4), a list of lists of vertices from
        0, or a pair (offsets, vertices) as Mesh.faces. creases are pairs of a chain of vertices and
        a sharpness (10 is sharp), corners pairs of a vertex and a sharpness, holes faces that are
        left out. groups name faces; group_creases makes the borders of groups sharp. A model of
        several cages, or of a cage and patches, needs names: patches are then "name:f0".
        """
        points = _arrays.array("vertices", vertices, (None, 3), 3)
        flat, offsets = _arrays.faces(faces, len(points))
        count = len(offsets) - 1
        chains = [(_arrays.integers("creases", chain).tolist(), float(sharpness))
                  for chain, sharpness in creases]
        sharp = [(int(vertex), float(sharpness)) for vertex, sharpness in corners]
        named = []
        for group, members in (groups or {}).items():
            rows = _arrays.integers(f"groups[{group!r}]", members)
            if len(rows) and (rows.min() < 0 or rows.max() >= count):
                raise InvalidInput(f"group {group} names a face beyond the {count} of the cage")
            named.append((group, rows.tolist()))
        left_out = _arrays.integers("holes", holes).tolist()
        sharp_groups = list((group_creases or {}).items())
        with self._adding() as builder:
            builder.add_cage(name, points, flat, offsets, chains, sharp, left_out, named,
                             sharp_groups)

    def add_group(self, name: str, patches: Sequence[str]) -> None:
        """Name a set of patches that were added by name."""
        wanted = _arrays.names("patches", patches)
        with self._adding() as builder:
            for patch in wanted:
                if patch not in self._names:
                    raise InvalidInput(f"group {name}: there is no patch {patch}")
            builder.add_group(name, [self._names.index(patch) for patch in wanted])

    # What the model is.

    @property
    def patch_names(self) -> List[str]:
        """Names of the patches."""
        return self._built().patch_names()

    @property
    def contour_names(self) -> List[str]:
        """Names of the contours; two patches share one where they are joined."""
        return self._built().contour_names()

    @property
    def groups(self) -> Dict[str, List[int]]:
        """Patches of each group."""
        return dict(self._built().groups())

    @property
    def diagonal(self) -> float:
        """Length of the diagonal of the model's box, of which shares of lengths are."""
        return self._built().diagonal()

    @property
    def box(self) -> np.ndarray:
        """Least and greatest coordinates (2, 3)."""
        return np.array(self._built().box())

    @property
    def notices(self) -> List[_surfmesh.Notice]:
        """What there is to tell of the model."""
        return self._built().notices()

    @property
    def options(self) -> Dict[str, Any]:
        """Options with their values, as the file of the model sets them."""
        return self._built().options()

    def domain(self, patch: Union[int, str]) -> Tuple[Interval, Interval]:
        """Ranges of u and v of a patch."""
        held = self._built()
        return held.domain(patch_index(held, patch))

    def evaluate(
        self, patch: Union[int, str], u: Any, v: Any, order: int = 0
    ) -> Union[np.ndarray, Tuple[np.ndarray, ...]]:
        """Points (..., 3) of a patch at arrays of u and v.

        With order 1 a tuple of points and derivatives by u and v, with order 2 also by uu, uv, vv.
        """
        held = self._built()
        if order not in (0, 1, 2):
            raise InvalidInput(f"order = {order!r} is not 0, 1 or 2")
        try:
            us, vs = np.broadcast_arrays(np.asarray(u, dtype=float), np.asarray(v, dtype=float))
        except (TypeError, ValueError) as error:
            raise InvalidInput(f"u and v do not go together: {error}") from None
        uv = np.stack([us.ravel(), vs.ravel()], axis=1)
        _arrays.check_finite("(u, v)", uv)
        rows = held.evaluate(patch_index(held, patch), uv, int(order))
        shaped = tuple(row.reshape(us.shape + (3,)) for row in rows)
        return shaped[0] if order == 0 else shaped

    # Sizes.

    def size_everywhere(self, size: Size, where: Where = None, *, angle: float = 0.0) -> None:
        """Ask for a size in patches, or in groups: names, indices, or None for all.

        A size is a length, or a pair of those along and across a direction: p_u turned by `angle`
        degrees. Where several sizes are asked for, the least counts.
        """
        wanted, here = _arrays.size(size, angle), places(where)
        self._ask(lambda to, held: to.add_everywhere(patch_indices(held, here), wanted))

    def size_at(
        self,
        patch: Union[int, str],
        uv: Sequence[float],
        size: Size,
        *,
        angle: float = 0.0,
        radius: Length = 0.0,
        outer: Optional[Size] = None,
        outer_radius: Optional[Length] = None,
    ) -> None:
        """Ask for a size at a point of a patch, and within `radius` around it.

        With outer and outer_radius, sizes change linearly to `outer` over that length beyond.
        """
        place = tuple(_arrays.array("uv", uv, (2,)).tolist())
        wish = _arrays.wish(size, angle, radius, outer, outer_radius)
        self._ask(lambda to, held: to.add_at(patch_index(held, patch), place, wish))

    def size_along(
        self,
        contour: str,
        size: Size,
        *,
        angle: float = 0.0,
        radius: Length = 0.0,
        outer: Optional[Size] = None,
        outer_radius: Optional[Length] = None,
    ) -> None:
        """Ask for a size along a contour, or along a side like "wing:u0"."""
        wish = _arrays.wish(size, angle, radius, outer, outer_radius)
        self._ask(lambda to, held: to.add_along(held, contour, wish))

    def size_inside(
        self,
        patch: Union[int, str],
        polygon: Any,
        size: Size,
        *,
        angle: float = 0.0,
        radius: Length = 0.0,
        outer: Optional[Size] = None,
        outer_radius: Optional[Length] = None,
    ) -> None:
        """Ask for a size inside a polygon (n, 2) in the parameters of a patch."""
        corners = _arrays.array("polygon", polygon, (None, 2), 3)
        wish = _arrays.wish(size, angle, radius, outer, outer_radius)
        self._ask(lambda to, held: to.add_inside(patch_index(held, patch), corners, wish))

    def size_near(
        self,
        points: Any,
        size: Size,
        *,
        radius: Length = 0.0,
        where: Where = None,
        angle: float = 0.0,
        outer: Optional[Size] = None,
        outer_radius: Optional[Length] = None,
    ) -> None:
        """Ask for a size near a point (3,) or along a polyline (n, 3) in space."""
        line = np.asarray(points)
        line = _arrays.array("points", line[None] if line.ndim == 1 else points, (None, 3), 1)
        wish, here = _arrays.wish(size, angle, radius, outer, outer_radius), places(where)
        self._ask(lambda to, held: to.add_near(some_patches(held, here), line, wish))

    def size_in_box(
        self,
        low: Sequence[float],
        high: Sequence[float],
        size: Size,
        *,
        radius: Length = 0.0,
        where: Where = None,
        angle: float = 0.0,
        outer: Optional[Size] = None,
        outer_radius: Optional[Length] = None,
    ) -> None:
        """Ask for a size inside a box in space."""
        corners = _arrays.array("box", [list(low), list(high)], (2, 3))
        if not (corners[0] <= corners[1]).all():
            raise InvalidInput(f"the box from {list(low)} to {list(high)} is empty")
        wish, here = _arrays.wish(size, angle, radius, outer, outer_radius), places(where)
        self._ask(lambda to, held: to.add_box(some_patches(held, here), corners, wish))

    def size_formula(
        self,
        formula: Union[str, Sequence[str]],
        where: Where = None,
        *,
        constants: Optional[Mapping[str, float]] = None,
        precision: Optional[float] = None,
    ) -> None:
        """Ask for a size by a formula of u, v, x, y, z, or for a metric by three: m11, m12, m22."""
        texts = _arrays.names("formula", formula)
        if len(texts) not in (1, 3):
            raise InvalidInput("a size takes one formula, a metric three")
        numbers, here = dict(constants or {}), places(where)
        self._ask(lambda to, held: to.add_formula(patch_indices(held, here), texts, numbers,
                                                  precision))

    def size_function(
        self,
        function: Function,
        where: Where = None,
        *,
        of: str = "xyz",
        precision: float = 0.02,
        max_samples: int = 1_000_000,
    ) -> None:
        """Ask for sizes by a Python function of arrays x, y, z, or with of="uv" of u, v.

        It returns sizes (n,) in model units. It is tabulated in each patch, on a grid of twice as
        many points until sizes between them are within `precision` of the function, and linear in
        between; a PrecisionWarning tells where max_samples do not do. `tabulations` has the errors.
        """
        self._ask_function(function, where, of, False, precision, max_samples)

    def metric_function(
        self,
        function: Function,
        where: Where = None,
        *,
        of: str = "uv",
        precision: float = 0.02,
        max_samples: int = 1_000_000,
    ) -> None:
        """Ask for a metric in (u,v) by a Python function that returns (n, 3): m11, m12, m22.

        Otherwise as size_function.
        """
        self._ask_function(function, where, of, True, precision, max_samples)

    def size_table(
        self,
        patch: Union[int, str],
        rows: Any,
        *,
        precision: Optional[float] = None,
    ) -> None:
        """Ask for sizes at points of a patch, between which they are interpolated.

        rows are (n, 3): u, v, size; or (n, 5): u, v, sizes along and across, angle in degrees.
        """
        table = np.asarray(rows)
        width = 5 if table.ndim == 2 and table.shape[1] == 5 else 3
        table = _arrays.array("rows", rows, (None, width), 1)
        if not (table[:, 2:4 if width == 5 else 3] > 0).all():
            raise InvalidInput("rows have a size that is not above 0")
        if width == 5:
            table[:, 4] = np.radians(table[:, 4])
        self._ask(lambda to, held: to.add_table(patch_index(held, patch), table, False, precision))

    def metric_table(
        self,
        patch: Union[int, str],
        rows: Any,
        *,
        precision: Optional[float] = None,
    ) -> None:
        """Ask for a metric at points of a patch: rows (n, 5) of u, v, m11, m12, m22 in (u,v)."""
        table = _arrays.array("rows", rows, (None, 5), 1)
        bad = _arrays.first_indefinite(table[:, 2:])
        if bad is not None:
            raise InvalidInput(f"rows[{bad}] has the metric {table[bad, 2:]}, which is not "
                               "positive definite")
        self._ask(lambda to, held: to.add_table(patch_index(held, patch), table, True, precision))

    def adapt_to(self, mesh: Mesh, metric: Any, *, precision: Optional[float] = None) -> None:
        """Ask for a metric at the corners of an earlier mesh of this model.

        metric is (c, 3) in the order of mesh.uv, or (n, 3) by vertex: m11, m12, m22 in (u,v) of the
        patch of each corner. Corners beyond their patch are left out.
        """
        values = np.asarray(metric)
        offsets, corners = mesh.faces
        by_vertex = values.ndim == 2 and len(values) == len(mesh.points) != len(corners)
        count = len(mesh.points) if by_vertex else len(corners)
        values = _arrays.array("metric", metric, (count, 3))
        bad = _arrays.first_indefinite(values)
        if bad is not None:
            raise InvalidInput(f"metric[{bad}] = {values[bad]} is not positive definite")
        values = values[corners] if by_vertex else values
        patches = np.repeat(mesh.patch, np.diff(offsets))
        rows = np.column_stack([mesh.uv, values])
        tables = []
        for patch in np.unique(patches):
            own = (patches == patch) & ~mesh.beyond
            # A vertex has one row for each (u,v) that it has in a patch.
            _, first = np.unique(rows[own, :2], axis=0, return_index=True)
            if len(first):
                tables.append((int(patch), rows[own][np.sort(first)]))

        def wish(to: _surfmesh.HeldSources, held: _surfmesh.HeldInput) -> None:
            for patch, table in tables:
                to.add_table(patch_index(held, patch), table, True, precision)

        self._ask(wish)

    def clear_sizes(self) -> None:
        """Forget all sizes that were asked for here; those of a model file stay."""
        with self._lock:
            self._wishes.clear()
            self._sources = None if self._input is None else _surfmesh.HeldSources()

    @property
    def tabulations(self) -> List[Tabulation]:
        """How functions of sizes became tables, one for each function and patch."""
        return [Tabulation(*entry) for entry in self._prepared()[1].tabulations()]

    # Inside.

    @contextmanager
    def _adding(self) -> Iterator[_surfmesh.Builder]:
        """The builder, for this thread alone; the model is made again afterwards."""
        if self._builder is None:
            raise InvalidInput("a model that was read cannot get more patches, only sizes")
        with self._lock:
            try:
                yield self._builder
            finally:  # a function of a surface may have asked for the model meanwhile
                self._input = self._sources = None

    def _ask(self, wish: _Wish) -> None:
        """Keep a wish; if the model is there already, tell what is wrong with it right away.

        Nothing of a wish that fails is left.
        """
        with self._lock:
            if self._input is not None and self._sources is not None:
                part = _surfmesh.HeldSources()
                wish(part, self._input)
                self._sources.append(part)
            self._wishes.append(wish)

    def _ask_function(self, function: Function, where: Where, of: str, is_metric: bool,
                      precision: float, max_samples: int) -> None:
        if of not in ("uv", "xyz"):
            raise InvalidInput(f"of = {of!r} is not \"uv\" or \"xyz\"")
        if not (np.isfinite(precision) and precision > 0):
            raise InvalidInput(f"precision = {precision} is not above 0")
        what = "the function of the metric" if is_metric else "the function of sizes"
        wrapped = _arrays.batched(function, 3 if is_metric else 1, what)
        checked = (_arrays.positive_definite if is_metric else _arrays.positive)(wrapped, what)
        here = places(where)

        def wish(to: _surfmesh.HeldSources, held: _surfmesh.HeldInput) -> None:
            for patch in patch_indices(held, here):
                result = Tabulation(*to.add_function(held, patch, checked, is_metric, of == "xyz",
                                                     float(precision), int(max_samples)))
                if result.error > precision:
                    warnings.warn(
                        f"{what} changes so fast in patch {held.patch_names()[patch]} that "
                        f"{result.entries} entries hold it to {result.error:.2g} only, not to "
                        f"{precision:g}",
                        PrecisionWarning,
                        stacklevel=2,
                    )

        self._ask(wish)

    def _built(
        self, settings: Optional[Settings] = None, scheme: Optional[str] = None
    ) -> _surfmesh.HeldInput:
        """The model as C++ holds it; as it was made last, if no settings are given."""
        with self._lock:
            if self._builder is None:
                assert self._input is not None
                if scheme not in (None, "auto"):
                    raise InvalidInput(f"scheme = {scheme!r} comes too late for a model that was "
                                       "read: give it to surfmesh.read")
                return self._input
            key = self._key if settings is None else (settings, scheme or "auto")
            if self._input is None or key != self._key:
                self._input, self._key = self._builder.build(*key), key
                self._sources = None if self._wishes else _surfmesh.HeldSources()
            return self._input

    def _prepared(
        self, settings: Optional[Settings] = None, scheme: Optional[str] = None
    ) -> Tuple[_surfmesh.HeldInput, _surfmesh.HeldSources]:
        """The model as C++ holds it, and all sizes that were asked for of just this model."""
        with self._lock:
            held = self._built(settings, scheme)
            if self._sources is None:
                sources = _surfmesh.HeldSources()
                for wish in self._wishes:
                    wish(sources, held)
                self._sources = sources
            return held, self._sources
