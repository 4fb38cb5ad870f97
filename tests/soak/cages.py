# SPDX-License-Identifier: BSD-3-Clause
"""Random control cages as OBJ files, with what is known about meshes of their surfaces."""

import math

import numpy as np

from judge import Known
from surfaces import TURN, num


def grid_sheet(r):
    n, m = r.randint(1, 6), r.randint(1, 6)
    points = [[i, j, r.uniform(-0.6, 0.6)] for i in range(n + 1) for j in range(m + 1)]
    faces = [[i * (m + 1) + j, (i + 1) * (m + 1) + j, (i + 1) * (m + 1) + j + 1,
              i * (m + 1) + j + 1] for i in range(n) for j in range(m)]
    return points, faces, Known(euler=1, is_closed=False, components=1, borders=1)


def grid_torus(r):
    n, m, wide, thin = r.randint(3, 9), r.randint(3, 8), r.uniform(1.3, 4), r.uniform(0.3, 1)
    points = [[(wide + thin * math.cos(TURN * j / m)) * math.cos(TURN * i / n),
               (wide + thin * math.cos(TURN * j / m)) * math.sin(TURN * i / n),
               thin * math.sin(TURN * j / m)] for i in range(n) for j in range(m)]
    faces = [[i * m + j, (i + 1) % n * m + j, (i + 1) % n * m + (j + 1) % m, i * m + (j + 1) % m]
             for i in range(n) for j in range(m)]
    return points, faces, Known(euler=0, is_closed=True, components=1, borders=0)


def prism(r):
    """A prism of n sides and k storeys, with two ends, one or none."""
    n, k, ends = r.randint(3, 10), r.randint(1, 4), r.choice([2, 2, 1, 0])
    points = [[math.cos(TURN * i / n), math.sin(TURN * i / n), 0.7 * z]
              for z in range(k + 1) for i in range(n)]
    faces = [[z * n + i, z * n + (i + 1) % n, (z + 1) * n + (i + 1) % n, (z + 1) * n + i]
             for z in range(k) for i in range(n)]
    faces += [list(range(n))[::-1], [k * n + i for i in range(n)]][:ends]
    known = Known(euler=ends, is_closed=ends == 2, components=1, borders=2 - ends)
    return points, faces, known


def handles(r):
    """A slab of cubes with holes: a solid of as many handles, joined to a manifold."""
    count = r.randint(1, 2)
    cells = {(x, y) for x in range(2 * count + 1) for y in range(3)}
    cells -= {(2 * i + 1, 1) for i in range(count)}
    ids, faces = {}, []

    def corner(x, y, z):
        return ids.setdefault((x, y, z), len(ids))
    for x, y in sorted(cells):
        faces.append([corner(x, y, 0), corner(x, y + 1, 0), corner(x + 1, y + 1, 0),
                      corner(x + 1, y, 0)])
        faces.append([corner(x, y, 1), corner(x + 1, y, 1), corner(x + 1, y + 1, 1),
                      corner(x, y + 1, 1)])
        for (dx, dy), (a, b) in {(1, 0): ((1, 0), (1, 1)), (-1, 0): ((0, 1), (0, 0)),
                                 (0, 1): ((1, 1), (0, 1)), (0, -1): ((0, 0), (1, 0))}.items():
            if (x + dx, y + dy) not in cells:
                p, q = (x + a[0], y + a[1]), (x + b[0], y + b[1])
                faces.append([corner(*p, 0), corner(*q, 0), corner(*q, 1), corner(*p, 1)])
    known = Known(euler=2 - 2 * count, is_closed=True, components=1, borders=0)
    return [list(map(float, p)) for p in ids], faces, known


SOLIDS = {
    "tetrahedron": ([[1, 1, 1], [-1, -1, 1], [-1, 1, -1], [1, -1, -1]],
                    [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]),
    "octahedron": ([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]],
                   [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5],
                    [0, 3, 5]]),
    "cube": ([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0], [0, 0, 1], [1, 0, 1], [0, 1, 1],
              [1, 1, 1]],
             [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]),
}


def solid(r):
    points, faces = SOLIDS[r.choice(sorted(SOLIDS))]
    return points, faces, Known(euler=2, is_closed=True, components=1, borders=0)


def in_triangles(faces):
    return [[f[0], f[i], f[i + 1]] for f in faces for i in range(1, len(f) - 1)]


def shaken(r, points):
    a = r.choice([0, 0.02, 0.1, 0.2])
    scale = [10**r.uniform(-0.4, 0.4) for _ in range(3)] if r.random() < 0.3 else [1, 1, 1]
    unit = r.choice([1, 1, 1, 1e-6, 1e6])
    return [[num(unit * s * (x + r.uniform(-a, a))) for x, s in zip(p, scale)] for p in points]


def tags(r, points, faces, is_closed):
    """Lines of creases and corners in OpenSubdiv's notation."""
    lines = []
    edges = sorted({tuple(sorted((f[i], f[i - 1]))) for f in faces for i in range(len(f))})
    if r.random() < 0.4:
        for a, b in r.sample(edges, r.randint(1, max(1, len(edges) // r.choice([2, 5, 10])))):
            lines.append(f"t crease 2/1/0 {a} {b} {r.choice([10, 10, 4, num(r.uniform(0.2, 5))])}")
    if r.random() < 0.15:
        for v in r.sample(range(len(points)), r.randint(1, max(1, len(points) // 8))):
            lines.append(f"t corner 1/1/0 {v} {r.choice([10, num(r.uniform(0.2, 5))])}")
    if not is_closed and r.random() < 0.6:
        lines.append(f"t interpolateboundary 1/0/0 {r.choice([1, 2])}")
    return lines


def cage(r):
    """The text of an OBJ file, its scheme, what is known, and its diagonal."""
    points, faces, known = r.choice([grid_sheet, grid_torus, prism, handles, solid, solid])(r)
    scheme = r.choice(["auto", "auto", "catmark", "loop", "bilinear"])
    if scheme == "loop":
        faces = in_triangles(faces)
    points = shaken(r, points)
    has_groups = r.random() < 0.3
    lines = ["v " + " ".join(repr(x) for x in p) for p in points]
    for f in faces:
        if has_groups and r.random() < 0.2:
            lines.append(f"g part{r.randint(0, 3)}")
        lines.append("f " + " ".join(str(v + 1) for v in f))
    lines += tags(r, points, faces, known.is_closed)
    extent = np.ptp(np.array(points), axis=0)
    return "\n".join(lines) + "\n", scheme, known, float(np.linalg.norm(extent))
