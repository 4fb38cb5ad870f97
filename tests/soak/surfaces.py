# SPDX-License-Identifier: BSD-3-Clause
"""Random surfaces of formulas and NURBS, with what is known about their meshes.

Each family returns a Shape: patches and contours as in a model file, and a Known. The areas and
volumes are those of a fine grid of points.
"""

import dataclasses
import math
import re

import numpy as np

import splines
from judge import Known

TURN = 2 * math.pi
GRID = 201  # points along each parameter, for areas

FUNCTIONS = {name: getattr(np, name) for name in "sqrt exp sin cos tanh cosh abs".split()}
FUNCTIONS["pi"] = math.pi


@dataclasses.dataclass
class Shape:
    patches: list
    known: Known
    contours: list = dataclasses.field(default_factory=list)
    points: np.ndarray = None  # of all patches, for the diagonal
    has_poles: bool = False

    def diagonal(self):
        return float(np.linalg.norm(self.points.max(axis=0) - self.points.min(axis=0)))


def num(x):
    """Six digits, as a person would write them."""
    return float(f"{x:.6g}")


def value(formula, **names):
    """A formula of the model file at arrays."""
    text = str(formula).replace("^", "**")
    return np.asarray(eval(text, {"__builtins__": {}}, {**FUNCTIONS, **names}), float)


# ---------------------------------------------------------------------------- points of patches
def formula_grid(surface, u, v):
    u, v = np.meshgrid(u, v, indexing="ij")
    formulas = (surface.get("x", "u"), surface.get("y", "v"), surface.get("z", "0"))
    return np.stack([value(f, u=u, v=v) + 0 * u for f in formulas], axis=-1)


def patch_grid(patch):
    surface = patch["surface"]
    if "nurbs" not in surface:
        domain = [[float(value(x)) for x in patch["domain"][k]] for k in "uv"]
        return formula_grid(surface, *(np.linspace(a, b, GRID) for a, b in domain))
    nurbs = surface["nurbs"]
    ends = []
    for knots, degree, is_periodic in zip(nurbs["knots"], nurbs["degree"],
                                          nurbs.get("periodic", [False, False])):
        ends.append((knots[0], knots[-1]) if is_periodic else (knots[degree], knots[-degree - 1]))
    return splines.surface_points(nurbs, *(np.linspace(a, b, GRID) for a, b in ends))


def grid_area_and_volume(grid):
    a, b, c, d = grid[:-1, :-1], grid[1:, :-1], grid[1:, 1:], grid[:-1, 1:]
    area = volume = 0
    for p, q, r in ((a, b, c), (a, c, d)):
        normal = np.cross(q - p, r - p)
        area += np.linalg.norm(normal, axis=-1).sum() / 2
        volume += (p * normal).sum() / 6
    return float(area), float(volume)


def measured(shape, is_solid=False):
    """Complete a shape with its points, its area, and the volume of a solid."""
    grids = [patch_grid(p) for p in shape.patches]
    shape.points = np.concatenate([g.reshape(-1, 3) for g in grids])
    parts = [grid_area_and_volume(g) for g in grids]
    if shape.known.area is None and not any("loops" in p for p in shape.patches):
        shape.known.area = sum(area for area, _ in parts)
    if is_solid:
        shape.known.volume = abs(sum(volume for _, volume in parts))
    return shape


# ---------------------------------------------------------------------------- parts of formulas
def waves(r, most=3, height=0.3):
    """A smooth function of u and v with wave numbers up to about one per unit."""
    terms = []
    for _ in range(r.randint(1, most)):
        a, f, g, h = num(r.uniform(-height, height)), *(num(r.uniform(-6, 6)) for _ in range(3))
        terms.append(r.choice([
            f"{a}*sin({f}*u+{g}*v+{h})", f"{a}*cos({f}*u)*sin({g}*v)", f"{a}*u*v", f"{a}*u^2",
            f"{a}*exp(-((u-{num(r.random())})^2+(v-{num(r.random())})^2)*{num(r.uniform(1, 40))})",
            f"{a}*tanh({f}*(u-v))", f"{a}/(1+u^2+{num(r.uniform(0, 5))}*v^2)"]))
    return "+".join(terms)


class Motion:
    """A turn and a shift in space, or neither."""

    def __init__(self, r):
        self.turn, self.shift = np.eye(3), np.zeros(3)
        self.is_none = r.random() < 0.5
        if self.is_none:
            return
        q = np.linalg.qr(np.array([[r.gauss(0, 1) for _ in range(3)] for _ in range(3)]))[0]
        self.turn = q * (1 if np.linalg.det(q) > 0 else -1)
        self.shift = np.array([num(r.uniform(-9, 9)) for _ in range(3)])

    def formulas(self, surface):
        if self.is_none:
            return surface
        own = [f"({surface.get(k, other)})" for k, other in zip("xyz", "uv0")]
        return {k: "+".join(f"({float(self.turn[i][j])!r})*{own[j]}" for j in range(3))
                + f"+({float(self.shift[i])})" for i, k in enumerate("xyz")}

    def back(self, points):
        return (points - self.shift) @ self.turn


def sides(patch):
    return [f"{patch}:v0", f"{patch}:u1", f"-{patch}:v1", f"-{patch}:u0"]


def domain(u0, u1, v0, v1):
    return {"u": [u0, u1], "v": [v0, v1]}


# ---------------------------------------------------------------------------- families of formulas
def graph(r):
    """A graph over a rectangle; its vertices are compared with the formula."""
    u0, v0 = num(r.uniform(-2, 2)), num(r.uniform(-2, 2))
    u1, v1 = num(u0 + 10**r.uniform(-1, 1)), num(v0 + 10**r.uniform(-1, 1))
    z, motion = waves(r) if r.random() < 0.85 else "0", Motion(r)

    def distance(points):
        p = motion.back(points)
        return p[:, 2] - value(z, u=p[:, 0], v=p[:, 1])
    patch = {"name": "g", "surface": motion.formulas({"x": "u", "y": "v", "z": z}),
             "domain": domain(u0, u1, v0, v1)}
    known = Known(euler=1, is_closed=False, components=1, borders=1, distance=distance)
    return measured(Shape([patch], known))


def sheets(r):
    """A graph cut into m × n patches with parameters of their own."""
    m, n = r.choice([(1, 2), (2, 1), (2, 2), (3, 2), (4, 1)])
    z, patches = waves(r), []
    xs, ys = ([num(x) for x in np.cumsum([r.uniform(0.2, 1.5) for _ in range(k + 1)])]
              for k in (m, n))
    for i in range(m):
        for j in range(n):
            s, t = r.choice(["uv", "vu"])
            s, t = (r.choice([k, f"(1-{k})"]) for k in (s, t))
            x = f"({xs[i]!r}+{xs[i + 1] - xs[i]!r}*{s})"
            y = f"({ys[j]!r}+{ys[j + 1] - ys[j]!r}*{t})"
            own = re.sub(r"\b[uv]\b", lambda k: {"u": x, "v": y}[k.group()], z)
            patches.append({"name": f"q{i}{j}", "surface": {"x": x, "y": y, "z": own},
                            "domain": domain(0, 1, 0, 1)})
    # A side that is written in two ways is the same to rounding only, which is below `joining`.
    known = Known(euler=1, is_closed=False, components=1, borders=1,
                  distance=lambda p: p[:, 2] - value(z, u=p[:, 0], v=p[:, 1]))
    return measured(Shape(patches, known))


def tube(r):
    """A surface of revolution with a profile, of one to three patches around."""
    k, phase = r.choice([1, 1, 2, 3]), r.choice([0, num(r.uniform(-4, 4))])
    radius = f"(1+{num(r.uniform(0.1, 0.8))}*sin({num(r.uniform(1, 4))}*v+{num(r.uniform(0, 6))}))"
    height, motion = num(10**r.uniform(-0.7, 0.7)), Motion(r)
    is_part = r.random() < 0.25
    width = num(r.uniform(0.3, 6)) if is_part else TURN
    surface = motion.formulas({"x": f"{radius}*cos(u)", "y": f"{radius}*sin(u)",
                               "z": f"{height}*v"})

    def distance(points):
        p = motion.back(points)
        return np.hypot(p[:, 0], p[:, 1]) - value(radius, v=p[:, 2] / height)
    patches = [{"name": f"t{i}", "surface": surface,
                "domain": domain(phase + width * i / k, phase + width * (i + 1) / k, 0, 2)}
               for i in range(k)]
    known = Known(euler=1 if is_part else 0, is_closed=False, components=1,
                  borders=1 if is_part else 2, distance=distance)
    return measured(Shape(patches, known))


def ball(r):
    """A bumpy ellipsoid with poles, or a cap of it."""
    axes = [num(10**r.uniform(-0.4, 0.4)) for _ in range(3)]
    bump = f"(1+{num(r.uniform(0, 0.25))}*cos(v)^4*cos({r.randint(1, 4)}*u))"
    k, is_whole, motion = r.choice([1, 1, 2, 3]), r.random() < 0.6, Motion(r)
    surface = motion.formulas({"x": f"{axes[0]}*cos(u)*cos(v)*{bump}",
                               "y": f"{axes[1]}*sin(u)*cos(v)*{bump}",
                               "z": f"{axes[2]}*sin(v)*{bump}"})
    low = "-pi/2" if is_whole else num(r.uniform(-1.2, 0.3))
    patches = [{"name": f"s{i}", "surface": surface,
                "domain": domain(TURN * i / k, TURN * (i + 1) / k, low, "pi/2")}
               for i in range(k)]
    known = Known(euler=2 if is_whole else 1, is_closed=is_whole, components=1,
                  borders=0 if is_whole else 1)
    return measured(Shape(patches, known, has_poles=True), is_whole)


def ring(r):
    """A torus of one to six patches."""
    wide, thin, motion = num(r.uniform(1.3, 4)), num(r.uniform(0.2, 1)), Motion(r)
    surface = motion.formulas({"x": f"({wide}+{thin}*cos(v))*cos(u)",
                               "y": f"({wide}+{thin}*cos(v))*sin(u)", "z": f"{thin}*sin(v)"})
    ku, kv = r.choice([1, 1, 2, 3]), r.choice([1, 1, 2])
    patches = [{"name": f"p{i}{j}", "surface": surface,
                "domain": domain(TURN * i / ku, TURN * (i + 1) / ku, TURN * j / kv,
                                 TURN * (j + 1) / kv)}
               for i in range(ku) for j in range(kv)]

    def distance(points):
        p = motion.back(points)
        return np.hypot(np.hypot(p[:, 0], p[:, 1]) - wide, p[:, 2]) - thin
    known = Known(euler=0, is_closed=True, components=1, borders=0, distance=distance)
    return measured(Shape(patches, known), True)


def box(r):
    """A box with flat faces, or without one of them: areas and volumes are exact."""
    a, b, h = (num(10**r.uniform(-0.8, 0.8)) for _ in range(3))
    faces = {"bottom": ("u", "v", "0", a, b), "top": ("u", "v", str(h), a, b),
             "front": ("u", "0", "v", a, h), "back": ("u", str(b), "v", a, h),
             "left": ("0", "u", "v", b, h), "right": (str(a), "u", "v", b, h)}
    open_at = r.choice([None, None, "top", "left"])
    patches = [{"name": k, "surface": dict(zip("xyz", f[:3])), "domain": domain(0, f[3], 0, f[4])}
               for k, f in faces.items() if k != open_at]
    exact = (1 - 1e-9, 1 + 1e-9)
    known = Known(euler=1 if open_at else 2, is_closed=not open_at, components=1,
                  borders=1 if open_at else 0, area_slack=exact, volume_slack=exact)
    shape = measured(Shape(patches, known))
    if not open_at:
        known.volume = a * b * h
    return shape


# ---------------------------------------------------------------------------- trims
def discs(r, width, height, count):
    """Discs in a rectangle, apart from each other and from its border: (x, y, radius)."""
    found, least = [], min(width, height)
    for _ in range(count * 20):
        radius = r.uniform(0.03, 0.25) * least
        x, y = r.uniform(radius, width - radius), r.uniform(radius, height - radius)
        gap = 10**r.uniform(-2, -1) * least
        if (min(x, y, width - x, height - y) > radius + gap and
                all(math.hypot(x - a, y - b) > radius + q + gap for a, b, q in found)):
            found.append((num(x), num(y), num(radius)))
        if len(found) == count:
            break
    return found


CIRCLE = {"degree": 2, "knots": [0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4],
          "weights": [1, "sqrt(1/2)"] * 4 + [1]}
CORNERS = [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1), (1, 0)]


def hole(r, name, patch, disc, kinds):
    """The contours of a hole in a patch, the loop of them and its area in (u,v)."""
    x, y, q = disc
    kind = r.choice(kinds)
    if kind == "circle":
        on = {"patch": patch, "u": f"{x}+{q}*cos(t)", "v": f"{y}+{q}*sin(t)"}
        return [{"name": name, "range": [0, "2*pi"], "on": [on]}], [f"-{name}"], math.pi * q * q
    if kind == "nurbs":
        points = [[num(x + q * a), num(y + q * b)] for a, b in CORNERS]
        points[-1] = points[0]
        on = {"patch": patch, "nurbs": {**CIRCLE, "points": points}}
        return [{"name": name, "on": [on]}], [f"-{name}"], math.pi * q * q
    n, phase = r.randint(3, 7), r.uniform(0, 6)
    corners = [(num(x + q * math.cos(phase + TURN * i / n)),
                num(y + q * math.sin(phase + TURN * i / n))) for i in range(n)]
    contours = []
    for i, ((a, b), (c, d)) in enumerate(zip(corners, corners[1:] + corners[:1])):
        on = {"patch": patch, "u": f"{a}*(1-t)+{c}*t", "v": f"{b}*(1-t)+{d}*t"}
        contours.append({"name": f"{name}_{i}", "on": [on]})
    area = sum(a * d - b * c for (a, b), (c, d) in zip(corners, corners[1:] + corners[:1])) / 2
    return contours, [f"-{name}_{i}" for i in reversed(range(n))], area


def plate(r):
    """A plate with holes, flat, curved or rolled."""
    w, h = num(r.uniform(0.5, 4)), num(r.uniform(0.5, 4))
    holes = discs(r, w, h, r.choice([1, 2, 3, 5, 9]))
    z = r.choice(["0", "0", waves(r, 2)])
    patch = {"name": "s", "surface": {"z": z}, "domain": domain(0, w, 0, h),
             "loops": [sides("s")]}
    contours, left, round_area = [], w * h, 0
    for i, disc in enumerate(holes):
        own, loop, area = hole(r, f"h{i}", "s", disc, ["circle", "nurbs", "polygon"])
        contours += own
        patch["loops"].append(loop)
        left -= area
        round_area += area if len(own) == 1 else 0
    known = Known(euler=1 - len(holes), is_closed=False, components=1, borders=1 + len(holes),
                  distance=lambda p: p[:, 2] - value(z, u=p[:, 0], v=p[:, 1]))
    if z == "0":  # a triangle inside a circle has 0.41 of its area
        known.area = left
        known.area_slack = (1 - 1e-9, 1 + 1e-9 + 0.6 * round_area / left)
    return measured(Shape([patch], known, contours))


def pipes(r):
    """A plate with tubes on its holes, which are sides of the tubes."""
    w, height = num(r.uniform(1, 4)), num(r.uniform(0.1, 2))
    holes, two = discs(r, w, w, r.choice([1, 1, 2, 3])), r.random() < 0.5
    n = len(holes)
    patches = []
    for name, z, side in (("a", "0", "v0"), ("b", str(height), "v1"))[:1 + two]:
        loops = [sides(name)] + [[f"-t{i}:{side}"] for i in range(n)]
        patches.append({"name": name, "surface": {"z": z}, "domain": domain(0, w, 0, w),
                        "loops": loops})
    for i, (x, y, q) in enumerate(holes):
        surface = {"x": f"{x}+{q}*cos(u)", "y": f"{y}+{q}*sin(u)", "z": "v"}
        patches.append({"name": f"t{i}", "surface": surface,
                        "domain": domain(0, "2*pi", 0, height)})
    known = Known(euler=2 - 2 * n if two else 1 - n, is_closed=False, components=1,
                  borders=2 if two else 1 + n)
    return measured(Shape(patches, known))


# ---------------------------------------------------------------------------- families of NURBS
def clamped(r, n, degree, most=1):
    """Knots of n basis functions with clamped ends, inner ones up to `most` times."""
    inner = []
    at = 0.0
    while len(inner) < n - degree - 1:
        at = num(at + r.uniform(0.3, 1))
        inner += [at] * min(r.randint(1, most), n - degree - 1 - len(inner))
    end = num(at + r.uniform(0.3, 1))
    return [0.0] * (degree + 1) + inner + [end] * (degree + 1)


def weights_of(r, n, m):
    if r.random() < 0.5:
        return {}
    return {"weights": [[num(10**r.uniform(-0.3, 0.3)) for _ in range(n)] for _ in range(m)]}


def spline_sheet(r):
    """A B-spline or NURBS over a warped grid, with creases at knots of full multiplicity."""
    degree = [r.randint(1, 4), r.randint(1, 4)]
    n = [d + 1 + r.randint(0, 4) for d in degree]
    knots = [clamped(r, k, d, r.choice([1, d])) for k, d in zip(n, degree)]
    if r.random() < 0.2:  # ends that are not clamped
        knots[0] = [num(0.7 * i + r.uniform(0, 0.2)) for i in range(n[0] + degree[0] + 1)]
    points = [[[num(i + r.uniform(-0.2, 0.2)), num(j + r.uniform(-0.2, 0.2)),
                num(r.uniform(-0.5, 0.5))] for i in range(n[0])] for j in range(n[1])]
    nurbs = {"degree": degree, "knots": knots, "points": points, **weights_of(r, *n)}
    known = Known(euler=1, is_closed=False, components=1, borders=1)
    return measured(Shape([{"name": "n", "surface": {"nurbs": nurbs}}], known))


def spline_tube(r):
    """A periodic spline around an axis."""
    degree = [r.randint(2, 4), r.randint(1, 3)]
    n, m = r.randint(degree[0] + 2, 9), degree[1] + 1 + r.randint(0, 3)
    around = [0.0]
    for _ in range(n):
        around.append(num(around[-1] + r.uniform(0.5, 1)))
    rows = []
    for j in range(m):
        radius = r.uniform(0.6, 1.4)
        rows.append([[num(radius * math.cos(TURN * i / n)), num(radius * math.sin(TURN * i / n)),
                      num(0.7 * j + r.uniform(-0.1, 0.1))] for i in range(n)])
    nurbs = {"degree": degree, "knots": [around, clamped(r, m, degree[1])], "points": rows,
             "periodic": [True, False], **weights_of(r, n, m)}
    known = Known(euler=0, is_closed=False, components=1, borders=2)
    return measured(Shape([{"name": "n", "surface": {"nurbs": nurbs}}], known))


def spline_ball(r):
    """A rational circle turned about an axis with a profile between two poles."""
    degree = r.randint(2, 3)
    m = degree + 1 + r.randint(0, 3)
    radii = [0.0] + [num(r.uniform(0.5, 1.5)) for _ in range(m - 2)] + [0.0]
    if m > 3:
        heights = sorted(num(r.uniform(-1, 1)) for _ in range(m - 2))
    else:
        heights = [0.0]
    heights = [heights[0] - num(r.uniform(0, 0.5)), *heights, heights[-1] + num(r.uniform(0.3, 1))]
    half = math.sqrt(0.5)
    rows = [[[num(q * a), num(q * b), num(z)] for a, b in CORNERS] for q, z in zip(radii, heights)]
    nurbs = {"degree": [2, degree], "knots": [CIRCLE["knots"], clamped(r, m, degree)],
             "points": rows, "weights": [[1, half] * 4 + [1] for _ in range(m)]}
    known = Known(euler=2, is_closed=True, components=1, borders=0)
    shape = Shape([{"name": "n", "surface": {"nurbs": nurbs}}], known, has_poles=True)
    return measured(shape, True)


def spline_trims(r):
    """A smooth spline with holes."""
    degree = [r.randint(2, 3), r.randint(2, 3)]
    n = [d + 1 + r.randint(0, 3) for d in degree]
    knots = [clamped(r, k, d) for k, d in zip(n, degree)]
    points = [[[num(i + r.uniform(-0.1, 0.1)), num(j + r.uniform(-0.1, 0.1)),
                num(r.uniform(-0.3, 0.3))] for i in range(n[0])] for j in range(n[1])]
    nurbs = {"degree": degree, "knots": knots, "points": points, **weights_of(r, *n)}
    holes = discs(r, knots[0][-1], knots[1][-1], r.choice([1, 1, 2, 4]))
    patch = {"name": "n", "surface": {"nurbs": nurbs}, "loops": [sides("n")]}
    contours = []
    for i, disc in enumerate(holes):
        own, loop, _ = hole(r, f"h{i}", "n", disc, ["circle", "nurbs", "nurbs", "polygon"])
        contours += own
        patch["loops"].append(loop)
    known = Known(euler=1 - len(holes), is_closed=False, components=1, borders=1 + len(holes))
    return measured(Shape([patch], known, contours))


FAMILIES = {graph: 3, sheets: 3, tube: 3, ball: 3, ring: 2, box: 2, plate: 4, pipes: 2,
            spline_sheet: 5, spline_tube: 2, spline_ball: 2, spline_trims: 3}
