#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Plot a mesh with matplotlib, coloured by a field: plot_mesh.py INPUT picture.png [FIELD]."""

import sys

import matplotlib
import numpy as np

matplotlib.use("Agg")  # writes files, needs no screen

import matplotlib.pyplot as plt  # noqa: E402
from mpl_toolkits.mplot3d.art3d import Poly3DCollection  # noqa: E402

import surfmesh  # noqa: E402

_LIGHT = np.array([0.3, -0.6, 0.74])


def plot(mesh: surfmesh.Mesh, path: str, field: str = "quality") -> None:
    """Draw the triangles of a mesh in space, shaded, and coloured by a field of its faces."""
    corners = mesh.points[mesh.triangles]
    values = mesh.field(field)[mesh.triangle_faces]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), np.finfo(float).tiny)
    shade = 0.65 + 0.35 * np.abs(normals @ _LIGHT)
    scale = plt.Normalize(np.nanmin(values), np.nanmax(values))
    colours = plt.get_cmap("viridis")(scale(values))
    colours[:, :3] *= shade[:, None]

    figure = plt.figure(figsize=(8, 6))
    axes = figure.add_subplot(projection="3d")
    axes.add_collection3d(Poly3DCollection(corners, facecolors=colours, edgecolors="#00000060",
                                           linewidths=0.2))
    low, high = mesh.points.min(axis=0), mesh.points.max(axis=0)
    axes.set_xlim(low[0], high[0])
    axes.set_ylim(low[1], high[1])
    axes.set_zlim(low[2], high[2])
    axes.set_box_aspect(np.maximum(high - low, 1e-3 * np.max(high - low)))
    axes.set_axis_off()
    bar = plt.cm.ScalarMappable(scale, "viridis")
    figure.colorbar(bar, ax=axes, shrink=0.6, label=field)
    figure.savefig(path, dpi=120, bbox_inches="tight")
    plt.close(figure)


if __name__ == "__main__":
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    made = surfmesh.mesh(sys.argv[1])
    print(made)
    plot(made, *sys.argv[2:])
