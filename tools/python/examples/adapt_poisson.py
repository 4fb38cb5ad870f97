#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Solve a Poisson problem with a sharp layer on adapted meshes: adapt_poisson.py [picture.png].

-Δu = f on the unit square, u given on its boundary. The exact solution is 1 on one side of a
circle, -1 on the other, and changes between over a width of 0.01: u = tanh((r - 0.5) / 0.01), r
from a corner of the square. Linear elements, solved by SciPy. Five cycles: solve, recover the
second derivatives, ask for the metric that spreads the error of interpolation evenly, mesh again.
"""

import sys
from typing import List, NamedTuple, Tuple

import numpy as np
import scipy.sparse as sparse
from scipy.sparse.linalg import spsolve

import surfmesh

WIDTH = 0.01
CYCLES = 5

# A rule of degree 5 on a triangle, in barycentric coordinates (Radon 1948).
_A, _B = (6 - np.sqrt(15)) / 21, (6 + np.sqrt(15)) / 21
_RULE = np.array([[1 / 3, 1 / 3, 1 / 3]]
                 + [np.roll([1 - 2 * x, x, x], k) for x in (_A, _B) for k in range(3)])
_WEIGHTS = np.array([9 / 40] + 3 * [(155 - np.sqrt(15)) / 1200] + 3 * [(155 + np.sqrt(15)) / 1200])


class Errors(NamedTuple):
    triangles: int
    l2: float
    h1: float


def exact(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    return np.tanh((np.hypot(x, y) - 0.5) / WIDTH)


def exact_gradient(x: np.ndarray, y: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
    r = np.maximum(np.hypot(x, y), 1e-12)
    slope = (1 - exact(x, y) ** 2) / WIDTH
    return slope * x / r, slope * y / r


def load(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """f = -Δu = -(u'' + u'/r)."""
    r = np.maximum(np.hypot(x, y), 1e-12)
    u = exact(x, y)
    slope = (1 - u**2) / WIDTH
    return 2 * u * slope / WIDTH - slope / r


class Elements:
    """Linear elements on the triangles of a mesh in the plane."""

    def __init__(self, mesh: surfmesh.Mesh) -> None:
        self.points = mesh.points[:, :2]
        self.triangles = mesh.triangles
        corners = self.points[self.triangles]
        a, b, c = corners.transpose(1, 0, 2)
        (abx, aby), (acx, acy) = (b - a).T, (c - a).T
        self.area = 0.5 * (abx * acy - aby * acx)
        sides = np.stack([c - b, a - c, b - a], axis=1)
        # The gradient of the hat function of each corner: the side across, turned.
        turned = np.stack([-sides[..., 1], sides[..., 0]], axis=2)
        self.gradients = turned / (2 * self.area[:, None, None])
        self.rule_points = np.einsum("qi,tik->tqk", _RULE, corners)

    def integral(self, values: np.ndarray) -> np.ndarray:
        """Of values at the points of the rule (t, q), by triangle."""
        return self.area * (values @ _WEIGHTS)

    def solve(self) -> np.ndarray:
        count = len(self.points)
        local = np.einsum("tik,tjk,t->tij", self.gradients, self.gradients, self.area)
        rows = np.repeat(self.triangles, 3, axis=1).ravel()
        columns = np.tile(self.triangles, (1, 3)).ravel()
        stiffness = sparse.csr_matrix((local.ravel(), (rows, columns)), shape=(count, count))
        x, y = self.rule_points[..., 0], self.rule_points[..., 1]
        loads = np.einsum("tq,qi,q,t->ti", load(x, y), _RULE, _WEIGHTS, self.area)
        right = np.bincount(self.triangles.ravel(), loads.ravel(), count)

        solution = exact(*self.points.T)
        inner = ~np.any(np.isin(self.points, (0.0, 1.0)), axis=1)
        right = right - stiffness @ np.where(inner, 0, solution)
        solution[inner] = spsolve(stiffness[inner][:, inner].tocsc(), right[inner])
        return solution

    def gradient(self, values: np.ndarray) -> np.ndarray:
        return np.einsum("tik,ti->tk", self.gradients, values[self.triangles])

    def errors(self, solution: np.ndarray) -> Errors:
        x, y = self.rule_points[..., 0], self.rule_points[..., 1]
        values = solution[self.triangles] @ _RULE.T
        gx, gy = exact_gradient(x, y)
        slope = self.gradient(solution)
        square = self.integral((values - exact(x, y)) ** 2).sum()
        slopes = (gx - slope[:, :1]) ** 2 + (gy - slope[:, 1:]) ** 2
        return Errors(len(self.triangles), np.sqrt(square), np.sqrt(self.integral(slopes).sum()))

    def at_vertices(self, by_triangle: np.ndarray) -> np.ndarray:
        """Averages around vertices, weighted by area."""
        weights = np.repeat(self.area, 3)
        total = np.bincount(self.triangles.ravel(), weights, len(self.points))
        values = np.repeat(by_triangle, 3) * weights
        return np.bincount(self.triangles.ravel(), values, len(self.points)) / total

    def hessian(self, solution: np.ndarray) -> np.ndarray:
        """Second derivatives at the vertices (n, 2, 2): the gradient, averaged, derived again."""
        slope = self.gradient(solution)
        smooth = [self.at_vertices(slope[:, k]) for k in (0, 1)]
        second = np.stack([self.gradient(values) for values in smooth], axis=1)
        second = 0.5 * (second + second.transpose(0, 2, 1))
        result = np.empty((len(self.points), 2, 2))
        for i in (0, 1):
            for k in (0, 1):
                result[:, i, k] = self.at_vertices(second[:, i, k])
        return result


def wanted_metric(elements: Elements, hessian: np.ndarray, triangles: int) -> np.ndarray:
    """The metric m11, m12, m22 at vertices that asks for so many triangles.

    The one of least error of linear interpolation in L4, between that in L2 and the greatest one:
    |H| det|H|^(-1/10), scaled (Loseille and Alauzet, Continuous mesh framework, 2011).
    """
    values, vectors = np.linalg.eigh(hessian)
    values = np.maximum(np.abs(values), 1e-5 * np.abs(values).max())
    values *= np.prod(values, axis=1, keepdims=True) ** (-1 / 10)
    metric = np.einsum("nik,nk,njk->nij", vectors, values, vectors)
    density = np.sqrt(np.linalg.det(metric))[elements.triangles].mean(axis=1)
    unit_triangle = np.sqrt(3) / 4
    scale = triangles * unit_triangle / np.sum(elements.area * density)
    metric *= scale
    return np.stack([metric[:, 0, 0], metric[:, 0, 1], metric[:, 1, 1]], axis=1)


def square() -> surfmesh.Model:
    model = surfmesh.Model()
    model.add_patch("square", "0")  # x = u, y = v, z = 0: metrics in (u,v) are those in space
    return model


# Sizes come from the metric alone.
_OPTIONS = dict(curvature="off", hmin=1e-5, hmax=0.5, grade=2, proximity="off", features=False)


def adapted(triangles: int, cycles: int = CYCLES) -> Tuple[List[Errors], surfmesh.Mesh]:
    """Errors of all cycles of meshes that grow to so many triangles, and the last mesh."""
    model = square()
    model.size_everywhere(0.05)
    mesh = surfmesh.mesh(model, **_OPTIONS)
    history = []
    for cycle in range(cycles + 1):
        elements = Elements(mesh)
        solution = elements.solve()
        history.append(elements.errors(solution))
        if cycle == cycles:
            break
        metric = wanted_metric(elements, elements.hessian(solution), triangles)
        model.clear_sizes()
        model.adapt_to(mesh, metric)
        mesh = surfmesh.mesh(model, **_OPTIONS)
    return history, mesh


def uniform(size: float) -> Errors:
    elements = Elements(surfmesh.mesh(square(), size=size))
    return elements.errors(elements.solve())


def order(results: List[Errors], norm: str) -> float:
    """The slope of the error against the mean size, which is triangles^(-1/2)."""
    sizes = [np.log(r.triangles) / -2 for r in results]
    return float(np.polyfit(sizes, [np.log(getattr(r, norm)) for r in results], 1)[0])


def plot(path: str, adaptive: List[Errors], even: List[Errors], mesh: surfmesh.Mesh) -> None:
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, (left, right) = plt.subplots(1, 2, figsize=(9, 4.2))
    x, y = mesh.points[:, :2].T
    left.triplot(x, y, mesh.triangles, linewidth=0.25, color="#1f3b63")
    left.set_aspect("equal")
    left.set_axis_off()
    left.set_title(f"adapted, {len(mesh.triangles)} triangles")
    for norm, mark in (("l2", "o"), ("h1", "s")):
        for results, style, name in ((even, "--", "uniform"), (adaptive, "-", "adapted")):
            label = f"{norm.upper()}, {name}: order {order(results[-4:], norm):.2f}"
            right.loglog([r.triangles for r in results], [getattr(r, norm) for r in results],
                         style + mark, markersize=4, label=label,
                         color="#c0392b" if name == "uniform" else "#1f6fb4")
    right.set_xlabel("triangles")
    right.set_ylabel("error")
    right.legend(fontsize=8)
    right.grid(True, which="major", linewidth=0.3)
    figure.tight_layout()
    figure.savefig(path, dpi=90)
    plt.close(figure)


def main() -> None:
    picture = sys.argv[1] if len(sys.argv) > 1 else None
    even = [uniform(size) for size in (0.05, 0.025, 0.0125, 0.00625, 0.003125)]
    adaptive, meshes = [], []
    for triangles in (500, 1000, 2000, 4000, 8000, 16000):
        history, mesh = adapted(triangles)
        adaptive.append(history[-1])
        meshes.append(mesh)
    print("             triangles   L2 error   H1 error")
    for name, results in (("uniform", even), ("adapted", adaptive)):
        for result in results:
            print(f"{name:10} {result.triangles:11} {result.l2:10.2e} {result.h1:10.2e}")
        print(f"{name:10} order of the last four: L2 {order(results[-4:], 'l2'):.2f}, "
              f"H1 {order(results[-4:], 'h1'):.2f} (optimal: 2 and 1)")
    if picture:
        plot(picture, adaptive, even, meshes[1])


if __name__ == "__main__":
    main()
