# SPDX-License-Identifier: BSD-3-Clause
"""Faults of a mesh, found without surfmesh from what is known about its model."""

import dataclasses

import numpy as np

# Shares of the diagonal, and of squared sides: far above rounding, far below any element.
SAME_PLACE = 1e-12
NO_AREA = 1e-12
# Vertices lie on their surface, up to what rounding leaves of its formulas and of trims that are
# found by projection.
ON_SURFACE = 1e-8


@dataclasses.dataclass
class Known:
    """What must be true of any mesh of a model; None where it is not known."""

    euler: int = None
    is_closed: bool = None
    components: int = None
    borders: int = None
    area: float = None
    area_slack: tuple = (0.5, 1.2)  # least and greatest area of a mesh, of that of the surface
    volume: float = None
    volume_slack: tuple = (0.3, 1.3)
    distance: object = None  # of points from the surface, as a function of an array


def corners_of(mesh):
    """All sides of faces as pairs of vertices, in the order of the faces."""
    pairs = [np.stack([f, np.roll(f, -1, axis=1)], axis=2).reshape(-1, 2)
             for f in mesh.faces.values()]
    return np.concatenate(pairs) if pairs else np.zeros((0, 2), int)


def triangles_of(mesh):
    """Quads split at their shorter diagonals, as in .stl files, other faces as fans."""
    fans = [f[:, [0, i, i + 1]] for k, f in mesh.faces.items() if k != 4 for i in range(1, k - 1)]
    quads = mesh.faces.get(4, np.zeros((0, 4), int))
    p = mesh.points[quads]
    lengths = [np.linalg.norm(p[:, i] - p[:, i + 2], axis=1) for i in (0, 1)]
    turned = np.where((lengths[0] <= lengths[1])[:, None], quads, np.roll(quads, -1, axis=1))
    fans += [turned[:, :3], turned[:, [0, 2, 3]]]
    return np.concatenate(fans)


def area_and_volume(mesh):
    p, t = mesh.points, triangles_of(mesh)
    a, b, c = (p[t[:, i]] - p.mean(axis=0) for i in range(3))
    normals = np.cross(b - a, c - a)
    return (float(np.linalg.norm(normals, axis=1).sum()) / 2,
            float(np.einsum("ij,ij->i", a, normals).sum()) / 6)


def component_count(links, n):
    """Of n things that are linked in pairs."""
    label = np.arange(n)
    while True:
        least = label.copy()
        np.minimum.at(least, links[:, 0], label[links[:, 1]])
        np.minimum.at(least, links[:, 1], label[links[:, 0]])
        least = least[least]
        if (least == label).all():
            return len(np.unique(label))
        label = least


def index_faults(mesh):
    """What makes all other questions meaningless."""
    if not any(len(f) for f in mesh.faces.values()):
        return ["no faces"]
    if min(mesh.faces) < 3:
        return ["face of fewer than three corners"]
    if not np.isfinite(mesh.points).all():
        return ["coordinates not finite"]
    if any(f.min() < 0 or f.max() >= len(mesh.points) for f in mesh.faces.values()):
        return ["index out of range"]
    return []


def face_faults(mesh):
    bad = []
    for f in mesh.faces.values():
        f = np.sort(f, axis=1)
        if (np.diff(f, axis=1) == 0).any():
            bad.append("face with a vertex twice")
        if len(np.unique(f, axis=0)) != len(f):
            bad.append("duplicate faces")
    used = np.unique(np.concatenate([f.ravel() for f in mesh.faces.values()]))
    if len(used) != len(mesh.points):
        bad.append("unused vertices")
    return bad


def topology_faults(mesh, known):
    sides = corners_of(mesh)
    edges, uses = np.unique(np.sort(sides, axis=1), axis=0, return_counts=True)
    border = edges[uses == 1]
    bad = []
    if (uses > 2).any():
        bad.append("edge of three and more faces")
    if len(np.unique(sides, axis=0)) != len(sides):
        bad.append("neighbours turned against each other")
    ends = np.bincount(border.ravel(), minlength=len(mesh.points))
    if (ends > 2).any():
        bad.append("vertex with two fans")
    euler = len(mesh.points) - len(edges) + mesh.counts()[1]
    at_border, links = np.unique(border, return_inverse=True)
    found = {"closed": len(border) == 0, "Euler characteristic": euler,
             "components": component_count(edges, len(mesh.points)),
             "borders": component_count(links.reshape(-1, 2), len(at_border))}
    wanted = {"closed": known.is_closed, "Euler characteristic": known.euler,
              "components": known.components, "borders": known.borders}
    bad += [f"{name} {found[name]} not {wanted[name]}" for name in found
            if wanted[name] is not None and found[name] != wanted[name]]
    return bad + hanging_nodes(mesh.points, border)


def hanging_nodes(points, border):
    """Vertices of the border that lie inside a side of it: one face there has a side, another the
    two halves of it."""
    own = np.unique(border)
    if len(own) == 0 or len(own) > 3000:  # it takes the square of time
        return []
    a, b = points[border[:, 0]], points[border[:, 1]]
    for v in own:
        to_v, along = points[v] - a, b - a
        length2 = np.maximum((along**2).sum(axis=1), np.finfo(float).tiny)
        share = (to_v * along).sum(axis=1) / length2
        off2 = ((to_v - share[:, None] * along)**2).sum(axis=1)
        if ((share > 1e-6) & (share < 1 - 1e-6) & (off2 < 1e-24 * length2)).any():
            return ["hanging node"]
    return []


def shape_faults(mesh, known, is_complete):
    p = mesh.points
    diagonal = float(np.linalg.norm(p.max(axis=0) - p.min(axis=0)))
    bad = []
    if len(np.unique(np.round(p / (diagonal * SAME_PLACE)), axis=0)) != len(p):
        bad.append("vertices at one place")
    for k, f in mesh.faces.items():
        q = p[f]
        sides2 = ((q - np.roll(q, -1, axis=1))**2).sum(axis=2).max(axis=1)
        spans = (q[:, 1] - q[:, 0], q[:, 2] - q[:, 0]) if k == 3 else (q[:, 2] - q[:, 0],
                                                                       q[:, 3] - q[:, 1])
        area = np.linalg.norm(np.cross(*spans), axis=1) / 2
        if is_complete and (area < NO_AREA * sides2).any():
            bad.append("faces without area")
    if known.distance is not None:
        far = float(np.abs(known.distance(p)).max())
        if not far <= ON_SURFACE * diagonal:
            bad.append(f"vertex {far / diagonal:.3g} of the diagonal from the surface")
    return bad


def size_faults(mesh, known):
    area, volume = area_and_volume(mesh)
    bad = []
    for name, found, wanted, slack in (("area", area, known.area, known.area_slack),
                                       ("volume", abs(volume), known.volume, known.volume_slack)):
        if wanted and not slack[0] <= found / wanted <= slack[1]:
            bad.append(f"{name} {found / wanted:.3f} of the surface's")
    return bad


def judge(mesh, known, is_complete=True, quads=False):
    """What is wrong with a mesh, in words. A run that fell short of something may have made faces
    without area or triangles among quads, but nothing that is not a mesh of its model."""
    bad = index_faults(mesh)
    if bad:
        return bad
    bad = face_faults(mesh) + topology_faults(mesh, known)
    bad += shape_faults(mesh, known, is_complete) + size_faults(mesh, known)
    others = {k: len(f) for k, f in mesh.faces.items() if k != (4 if quads else 3)}
    if others and (is_complete or max(others) > 4):
        bad.append(f"faces of other numbers of corners: {others}")
    return bad
