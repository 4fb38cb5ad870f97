# SPDX-License-Identifier: BSD-3-Clause
"""B-splines by Cox's and de Boor's recursion, by which areas of random NURBS are known."""

import numpy as np


def basis(knots, degree, t):
    """The basis functions at parameters t: an array of len(t) rows, a column for each function."""
    knots, t = np.asarray(knots, float), np.asarray(t, float)
    # The end belongs to the span before it.
    last = np.searchsorted(knots, knots[-degree - 1], side="left") - 1
    span = np.clip(np.searchsorted(knots, t, side="right") - 1, degree, last)
    values = np.zeros((len(t), len(knots) - 1))
    values[np.arange(len(t)), span] = 1
    for k in range(1, degree + 1):
        raised = np.zeros((len(t), len(knots) - 1 - k))
        for i in range(raised.shape[1]):
            left, right = knots[i + k] - knots[i], knots[i + k + 1] - knots[i + 1]
            if left > 0:
                raised[:, i] += (t - knots[i]) / left * values[:, i]
            if right > 0:
                raised[:, i] += (knots[i + k + 1] - t) / right * values[:, i + 1]
        values = raised
    return values


def unrolled(knots, degree, points):
    """Knots and points (the first axis) of a periodic spline, as those of an open one."""
    period, n = knots[-1] - knots[0], len(points)
    before = [knots[n - degree + i] - period for i in range(degree)]
    after = [knots[1 + i] + period for i in range(degree)]
    return before + list(knots) + after, np.concatenate([points, points[:degree]])


def surface_points(nurbs, u, v):
    """Points of a surface, written as in model files with numbers only, on the grid of u and v."""
    points = np.asarray(nurbs["points"], float).transpose(1, 0, 2)  # rows are along u
    weights = nurbs.get("weights")
    weights = np.ones(points.shape[:2]) if weights is None else np.asarray(weights, float).T
    lifted = np.concatenate([points * weights[..., None], weights[..., None]], axis=2)
    knots = [list(k) for k in nurbs["knots"]]
    for axis, is_periodic in enumerate(nurbs.get("periodic", [False, False])):
        if is_periodic:
            knots[axis], turned = unrolled(knots[axis], nurbs["degree"][axis],
                                           np.moveaxis(lifted, axis, 0))
            lifted = np.moveaxis(turned, 0, axis)
    a = basis(knots[0], nurbs["degree"][0], u)
    b = basis(knots[1], nurbs["degree"][1], v)
    values = np.einsum("ui,ijk,vj->uvk", a, lifted, b)
    return values[..., :3] / values[..., 3:]
