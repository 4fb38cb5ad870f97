# SPDX-License-Identifier: BSD-3-Clause
"""A case of the soak: the files of a random model, options of a run, and what is written."""

import dataclasses
import json
import random


import cages
import surfaces
from judge import Known
from surfaces import num

# `mesh` is written by `-o`, `pieces` by --pieces, `formats` is an .om file that is converted.
OUTPUTS = ["mesh"] * 9 + ["pieces"] * 4 + ["formats"] * 5


@dataclasses.dataclass
class Case:
    name: str
    family: str
    known: Known
    files: dict
    main: str
    args: list
    model_args: list  # those that `check --model` takes, too
    output: str
    ending: str
    quads: bool
    has_sag: bool


# ------------------------------------------------------------------------------- sources of sizes
def background(r, box, length):
    """A grid of triangles in (u,v) with a size at each of its nodes, as .vtu in text."""
    (a, b), (c, d) = box
    n = r.randint(2, 8)
    points = [(num(a + (b - a) * i / n), num(c + (d - c) * j / n)) for i in range(n + 1)
              for j in range(n + 1)]
    cells = []
    for i in range(n):
        for j in range(n):
            k = i * (n + 1) + j
            cells += [(k, k + n + 1, k + n + 2), (k, k + n + 2, k + 1)]

    def array(kind, name, values, more=""):
        return (f'<DataArray type="{kind}" Name="{name}"{more} format="ascii">'
                + " ".join(map(str, values)) + "</DataArray>\n")
    return ('<?xml version="1.0"?>\n<VTKFile type="UnstructuredGrid" version="1.0">\n'
            f'<UnstructuredGrid><Piece NumberOfPoints="{len(points)}" '
            f'NumberOfCells="{len(cells)}">\n<PointData>\n'
            + array("Float64", "h", [length() for _ in points]) + "</PointData>\n<Points>\n"
            + array("Float64", "points", [x for p in points for x in (*p, 0)],
                    ' NumberOfComponents="3"')
            + "</Points>\n<Cells>\n" + array("Int32", "connectivity", [x for c in cells for x in c])
            + array("Int32", "offsets", range(3, 3 * len(cells) + 1, 3))
            + array("UInt8", "types", [5] * len(cells))
            + "</Cells>\n</Piece></UnstructuredGrid>\n</VTKFile>\n")


class Sizes:
    """Sources for the patches of a shape; tables and background meshes are files of their own."""

    def __init__(self, r, shape, length, files):
        self.r, self.shape, self.length, self.files = r, shape, length, files
        self.diagonal = shape.diagonal()

    def box(self, patch):
        if "domain" in patch:
            return [[float(surfaces.value(x)) for x in patch["domain"][k]] for k in "uv"]
        nurbs = patch["surface"]["nurbs"]
        ends = []
        for knots, degree, is_periodic in zip(nurbs["knots"], nurbs["degree"],
                                              nurbs.get("periodic", [False, False])):
            ends.append([knots[0], knots[-1]] if is_periodic
                        else [knots[degree], knots[-degree - 1]])
        return ends

    def point(self, patch):
        return [num(self.r.uniform(*ends)) for ends in self.box(patch)]

    def field(self, patch):
        """A formula of sizes between a third and six times the length asked for."""
        r, h = self.r, self.length
        (a, b), _ = self.box(patch)
        u0, v0 = self.point(patch)
        wave = f"{num(r.uniform(1, 6) / self.diagonal)}*x+{num(r.uniform(1, 6) / self.diagonal)}*y"
        return r.choice([f"{h()}*(1+abs(sin({num(r.uniform(1, 9) / (b - a))}*u)))",
                         f"{h()}+{h()}*((u-{u0})^2+(v-{v0})^2)", f"{h()}*(1.2+cos({wave}))",
                         f"{h()}*exp({num(r.uniform(-1, 1) / (b - a))}*(u-{num(a)}))",
                         f"if(u<{u0},{h()},{h()})", f"min({h()},max({h()},abs(x-{num(u0)})))"])

    def table(self, patch):
        r = self.r
        head = r.choice(["u,v,size", "u,v,ls,lt,angle"])
        rows = [head]
        for _ in range(r.choice([1, 2, 5, 40, 200])):
            row = [*self.point(patch), self.length()]
            rows.append(",".join(map(str, row if head.endswith("size")
                                     else [*row, self.length(), num(r.uniform(0, 360))])))
        return self.keep("csv", "\n".join(rows) + "\n")

    def keep(self, ending, text):
        name = f"sizes{len(self.files)}.{ending}"
        self.files[name] = text
        return name

    def add_to(self, patch):
        r = self.r
        kinds = "everywhere at along field field table table background".split()
        if "nurbs" in patch["surface"] and "loops" not in patch:
            kinds = "everywhere at field".split()  # it may be divided at creases
        for _ in range(r.randint(1, 2)):
            kind = r.choice(kinds)
            if kind == "field":
                source = {"field": {"size": self.field(patch)}}
            elif kind == "table":
                source = {"table": self.table(patch)}
            elif kind == "background":
                text = background(r, self.box(patch), self.length)
                source = {"background": self.keep("vtu", text), "in": "uv"}
            else:
                size = self.length() if r.random() < 0.6 else [self.length(), self.length()]
                place = {"everywhere": True, "at": self.point(patch),
                         "along": [self.point(patch) for _ in range(3)]}[kind]
                source = {kind: place, "size": size}
                if kind != "everywhere":
                    source["radius"] = num(self.diagonal * 10**r.uniform(-2, -0.5))
            patch.setdefault("sources", []).append(source)


def sizing(r, diagonal, h):
    chosen = {"hmax": num(h * r.uniform(1, 5)), "hmin": num(h * r.uniform(0.05, 0.4))}
    if r.random() < 0.6:
        chosen["curvature"] = r.choice([0, 0.1, 0.25, 0.5])
    for key, values in (("stretch", [1, 2, 5]), ("grade", [0, 1.1, 1.3, 2]),
                        ("proximity", [0, 1, 3]), ("features", [True, False]),
                        ("segments_per_circle", [8, 20])):
        if r.random() < 0.2:
            chosen[key] = r.choice(values)
    if "curvature" in chosen:
        chosen.pop("segments_per_circle", None)
    return chosen


# ------------------------------------------------------------------------------- cases
def formula_model(r, h_share):
    families = surfaces.FAMILIES
    family = r.choices(list(families), list(families.values()))[0]
    shape, files = family(r), {}
    h = shape.diagonal() * h_share
    sizes = Sizes(r, shape, lambda: num(h * 10**r.uniform(-0.4, 0.5)), files)
    for patch in shape.patches:
        if r.random() < 0.45:
            sizes.add_to(patch)
    model = {"patches": shape.patches, "sizing": sizing(r, shape.diagonal(), h)}
    if shape.contours:
        model["contours"] = shape.contours
    files["model.json"] = json.dumps(model, indent=1)
    return family.__name__, shape.known, files, "model.json", []


def cage_model(r, h_share):
    text, scheme, known, _ = cages.cage(r)
    args = ["--hmax", f"{num(100 * h_share * r.uniform(1, 4))}%", "--hmin",
            f"{num(100 * h_share * r.uniform(0.05, 0.4))}%"]
    if r.random() < 0.4:
        args += ["--curvature", r.choice(["0", "0.1", "0.25", "0.5"])]
    if scheme != "auto":
        args += ["--scheme", scheme]
    if r.random() < 0.2:
        args += ["--patches", "faces"]
    return "cage", known, {"cage.obj": text}, "cage.obj", args


def options(r, output):
    """Flags of a run: quads, tiles, a sag, and what is of them independent."""
    args, quads, has_sag = [], r.random() < 0.35, r.random() < 0.12
    if quads:
        args += ["--quads", "on"]
        if r.random() < 0.4:
            args += ["--quad-method", "frontal", "--quad-front",
                     r.choice(["lee-lo", "q-morph", "mixed"])]
    if r.random() < (0.9 if output == "pieces" else 0.35):
        args += ["--tile", str(r.randint(300, 3000))]
    if has_sag:
        args += ["--sag", r.choice(["1%", "0.3%", "0.1%"])]
    for flag, values, share in (("--across", ["off"], 0.15), ("--control", ["mesh", "grid"], 0.1),
                                ("--placement", ["circumcentre"], 0.1), ("--nodes", ["400"], 0.1),
                                ("--precision", ["0.05", "0.5"], 0.1)):
        if r.random() < share:
            args += [flag, r.choice(values)]
    if output == "pieces":
        args += ["--piece-count", str(r.randint(1, 6))]
    elif r.random() < 0.2:
        args += r.choice([["--normals"], ["--uv"], ["--normals", "--uv"]])
    return args, quads, has_sag


def make_case(seed, number):
    r = random.Random(f"surfmesh:{seed}:{number}")
    output = r.choice(OUTPUTS)
    # From some hundred to some ten thousand elements; tiles want more.
    h_share = 10**r.uniform(-2.1 if output == "pieces" else -1.9, -1.2 if output == "pieces"
                            else -0.7)
    make = cage_model if r.random() < 0.2 else formula_model
    family, known, files, main, model_args = make(r, h_share)
    args, quads, has_sag = options(r, output)
    ending = "om" if output == "formats" else r.choice(["obj", "obj", "ply", "off"])
    return Case(f"{seed}:{number}", family, known, files, main, args, model_args, output, ending,
                quads, has_sag)
