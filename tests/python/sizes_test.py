# SPDX-License-Identifier: BSD-3-Clause
"""Sizes that are asked for in Python, by arrays, functions, formulas and places."""

import math
import unittest
import warnings

import numpy as np
import support

import surfmesh

# What follows from the shape is off: sizes are those that are asked for.
PLAIN = dict(curvature="off", proximity="off", features=False, hmin=1e-3, hmax=0.2, grade="off")


def square():
    model = surfmesh.Model()
    model.add_patch("square", "0")
    return model


def ramp(x):
    return 0.02 + 0.1 * x


def count_of_ramp():
    """Triangles of equal sides of length ramp(x) that cover the unit square."""
    return (1 / ramp(0) - 1 / ramp(1)) / 0.1 / (math.sqrt(3) / 4)


class Sizes(unittest.TestCase):
    def mesh(self, model, **options):
        return surfmesh.mesh(model, **{**PLAIN, **options})

    def shortest_near(self, mesh, point):
        a, b = mesh.points[mesh.triangles[:, [0, 1]]].transpose(1, 0, 2)
        near = np.linalg.norm(0.5 * (a + b) - point, axis=1) < 0.05
        return np.linalg.norm(a - b, axis=1)[near].mean()

    def assert_is_ramp(self, mesh):
        self.assertAlmostEqual(len(mesh.triangles) / count_of_ramp(), 1, delta=0.08)

    def test_hold_everywhere(self):
        model = square()
        model.size_everywhere(0.05)
        mesh = self.mesh(model)
        self.assertAlmostEqual(len(mesh.triangles) * math.sqrt(3) / 4 * 0.05**2, 1, delta=0.08)
        model.clear_sizes()
        self.assertLess(len(self.mesh(model).triangles), 100)

    def test_have_directions(self):
        model = square()
        model.size_everywhere((0.1, 0.02), angle=30)
        mesh = self.mesh(model)
        m = np.median(mesh.metric, axis=0)
        wide, narrow = np.linalg.eigvalsh([[m[0], m[1]], [m[1], m[2]]]) ** -0.5
        self.assertAlmostEqual(wide, 0.1, places=6)
        self.assertAlmostEqual(narrow, 0.02, places=6)
        self.assertAlmostEqual(0.5 * math.degrees(math.atan2(-2 * m[1], m[2] - m[0])), 30, places=5)

    def test_hold_in_groups_and_patches(self):
        model = surfmesh.Model()
        model.add_patch("a", "0")
        model.add_patch("b", "0", (1, 2))
        model.add_group("both", ["a", "b"])
        for where, fine in ((None, [0, 1]), ("both", [0, 1]), ("b", [1]), (1, [1]), (["a"], [0]),
                            (["a", 1], [0, 1])):
            model.clear_sizes()
            model.size_everywhere(0.04, where)
            counts = np.bincount(self.mesh(model, hmax=0.5).patch, minlength=2)
            self.assertEqual([i for i in (0, 1) if counts[i] > 400], fine, where)

    def test_hold_at_places(self):
        self.assertLess(len(self.mesh(square()).triangles), 100)
        asks = [
            lambda m: m.size_at("square", (0.5, 0.5), 0.01, radius=0.1),
            lambda m: m.size_at(0, [0.5, 0.5], 0.01, radius="5%", outer=0.1, outer_radius=0.2),
            lambda m: m.size_inside("square", [[0.3, 0.3], [0.7, 0.3], [0.7, 0.7], [0.3, 0.7]],
                                    0.01),
            lambda m: m.size_near([0.5, 0.5, 0.01], 0.01, radius=0.1),
            lambda m: m.size_near([[0.4, 0.5, 0], [0.6, 0.5, 0]], 0.01, radius=0.1, where="square"),
            lambda m: m.size_in_box([0.3, 0.3, -1], (0.7, 0.7, 1), "0.7071067811865476%"),
        ]
        for ask in asks:
            model = square()
            ask(model)
            mesh = self.mesh(model, grade=1.5)
            self.assertAlmostEqual(self.shortest_near(mesh, [0.5, 0.5, 0]), 0.01, delta=0.002)

    def test_hold_along_contours(self):
        model = square()
        model.size_along("square:v0", 0.01)
        mesh = self.mesh(model, grade=1.5)
        self.assertAlmostEqual(np.sum(mesh.points[:, 1] == 0), 101, delta=3)
        part = surfmesh.read(support.model("pipe_on_plate.json"))
        name = part.contour_names[0]
        part.size_along(name, "0.5%")
        for other in (name + "x", "none"):
            with self.assertRaises(surfmesh.InvalidInput):
                part.size_along(other, 0.1)

    def test_are_formulas(self):
        model = square()
        model.size_formula("a + 0.1*x", constants={"a": 0.02}, precision=0.02)
        self.assert_is_ramp(self.mesh(model))
        model.clear_sizes()
        model.size_formula(["1/(0.02 + 0.1*u)^2", "0", "1/(0.02 + 0.1*u)^2"])
        self.assert_is_ramp(self.mesh(model))

    def test_are_functions_of_space_and_of_parameters(self):
        model = square()
        model.size_function(lambda x, y, z: ramp(x))
        self.assert_is_ramp(self.mesh(model))
        self.assertEqual(len(model.tabulations), 1)
        self.assertLess(model.tabulations[0].error, 0.02)
        model.clear_sizes()
        model.size_function(lambda u, v: ramp(u), "square", of="uv")
        self.assert_is_ramp(self.mesh(model))
        model.clear_sizes()

        def metric(u, v):
            m = ramp(u) ** -2.0
            return np.stack([m, 0 * m, m], axis=1)

        model.metric_function(metric)
        self.assert_is_ramp(self.mesh(model))

    def test_are_found_where_they_are_small(self):
        model = square()
        model.size_function(lambda x, y, z: 0.01 + 0.3 * np.hypot(x - 0.37, y - 0.61))
        self.assertAlmostEqual(self.shortest_near(self.mesh(model), [0.37, 0.61, 0]), 0.017,
                               delta=0.005)

    def test_are_tabulated_to_a_precision(self):
        model = square()
        model.size_function(lambda x, y, z: np.where(x < 0.3, 0.05, 0.1), max_samples=2000)
        with self.assertWarnsRegex(surfmesh.PrecisionWarning, "patch square"):
            self.mesh(model)
        self.assertGreater(model.tabulations[0].error, 0.02)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            self.mesh(model)  # is tabulated already

    def test_are_tables(self):
        u, v = (x.ravel() for x in np.meshgrid(np.linspace(0, 1, 30), np.linspace(0, 1, 5)))
        h = ramp(u)
        for rows, ask in ((np.stack([u, v, h], axis=1), surfmesh.Model.size_table),
                          (np.stack([u, v, h, h, 0 * h], axis=1), surfmesh.Model.size_table),
                          (np.stack([u, v, h**-2, 0 * h, h**-2], axis=1),
                           surfmesh.Model.metric_table)):
            model = square()
            ask(model, "square", rows)
            self.assert_is_ramp(self.mesh(model))

    def test_adapt_to_a_metric_on_a_mesh(self):
        model = square()
        mesh = self.mesh(model, hmax=0.03)
        for points in (mesh.points, mesh.points[mesh.faces[1]]):
            m = ramp(points[:, 0]) ** -2.0
            model.clear_sizes()
            model.adapt_to(mesh, np.stack([m, 0 * m, m], axis=1))
            self.assert_is_ramp(self.mesh(model))

    def test_leave_files_as_they_are(self):
        model = surfmesh.read(support.KNOB)
        before = surfmesh.mesh(model, hmax="10%")
        model.size_everywhere("0.7%", "grip")
        after = surfmesh.mesh(model, hmax="10%")
        self.assertGreater(len(after.triangles), 1.5 * len(before.triangles))
        model.clear_sizes()
        np.testing.assert_array_equal(surfmesh.mesh(model, hmax="10%").points, before.points)

    def test_refuse_what_is_none(self):
        model = surfmesh.read(support.model("wave.json"))
        patch = model.patch_names[0]
        table = [[0.5, 0.5, 0.1]]
        cases = [
            lambda: model.size_everywhere(0),
            lambda: model.size_everywhere(-1),
            lambda: model.size_everywhere(math.nan),
            lambda: model.size_everywhere("big"),
            lambda: model.size_everywhere("300%"),
            lambda: model.size_everywhere(True),
            lambda: model.size_everywhere((1, 2, 3)),
            lambda: model.size_everywhere(1, "grp"),
            lambda: model.size_everywhere(1, 99),
            lambda: model.size_everywhere(1, True),
            lambda: model.size_everywhere(1, angle="x"),
            lambda: model.size_at("none", (0, 0), 1),
            lambda: model.size_at(patch, (0, 0, 0), 1),
            lambda: model.size_at(patch, (0, math.nan), 1),
            lambda: model.size_at(patch, (0, 0), 1, outer=2),
            lambda: model.size_along("none", 1),
            lambda: model.size_inside(patch, [[0, 0], [1, 1]], 1),
            lambda: model.size_near([0, 0], 1),
            lambda: model.size_near(np.zeros((0, 3)), 1),
            lambda: model.size_in_box([1, 1, 1], [0, 0, 0], 1),
            lambda: model.size_in_box([1, 1], [2, 2], 1),
            lambda: model.size_formula("1 +"),
            lambda: model.size_formula(["1", "2"]),
            lambda: model.size_function(3),
            lambda: model.size_function(lambda x, y, z: x, of="xy"),
            lambda: model.size_function(lambda x, y, z: 0 * x),
            lambda: model.size_function(lambda x, y, z: x[:2]),
            lambda: model.size_function(lambda x, y, z: np.full(len(x), np.nan)),
            lambda: model.size_function(lambda x, y, z: 1, precision=0),
            lambda: model.metric_function(lambda u, v: (1 + 0 * u, 2 + 0 * u, 1 + 0 * u)),
            lambda: model.size_table(patch, []),
            lambda: model.size_table(patch, [[0, 0, 0]]),
            lambda: model.size_table(patch, [[0, 0, 1, 1]]),
            lambda: model.size_table("none", table),
            lambda: model.metric_table(patch, [[0, 0, 1, 1, 1]]),
            lambda: model.metric_table(patch, table),
        ]
        for i, case in enumerate(cases):
            with self.assertRaises(surfmesh.Error, msg=i):
                case()
        mesh = surfmesh.mesh(model)
        for metric in (np.ones((3, 3)), np.zeros((len(mesh.points), 3)), "x"):
            with self.assertRaises(surfmesh.InvalidInput):
                model.adapt_to(mesh, metric)

    def test_raise_what_their_functions_raise(self):
        def fails(x, y, z):
            raise KeyError("sizes")

        model = square()
        model.size_function(fails)
        with self.assertRaisesRegex(KeyError, "sizes"):
            self.mesh(model)


class Wishes(unittest.TestCase):
    """What is kept of a call: copies of what it was given, and nothing of one that fails."""

    def points(self, model):
        return surfmesh.mesh(model, **PLAIN).points

    def pair(self):
        model = surfmesh.Model()
        model.add_patch("a", "0")
        model.add_patch("b", "0", (1, 2))
        return model

    def test_are_copies_of_what_is_given(self):
        def ask(model, after):
            metric = np.array([[0.5, 0.5, 400.0, 0.0, 400.0]])
            sizes = np.array([[0.5, 0.5, 0.05]])
            line = np.array([[1.5, 0.5, 0.0], [1.6, 0.5, 0.0]])
            polygon = np.array([[1.2, 0.2], [1.4, 0.2], [1.4, 0.4]])
            where, constants = ["a"], {"h": 0.1}
            model.metric_table("a", metric)
            model.size_table("a", sizes)
            model.size_near(line, 0.03, radius=0.1)
            model.size_inside("b", polygon, 0.04)
            model.size_formula("h", where, constants=constants)
            model.size_everywhere(0.15, where)
            model.size_function(lambda x, y, z: 0.08 + 0 * x, where)
            if after:
                for array in (metric, sizes, line, polygon):
                    array[...] = 7e-3
                where[0] = "b"
                constants["h"] = 0.01

        results = []
        for after in (False, True):
            model = self.pair()
            ask(model, after)
            results.append(self.points(model))
        np.testing.assert_array_equal(results[0], results[1])

    def test_are_left_out_whole_if_they_fail(self):
        def fails_in_b(x, y, z):
            if x.max() > 1:
                raise KeyError("sizes")
            return 0.02 + 0 * x

        model = self.pair()
        model.size_everywhere(0.15)
        before = self.points(model)
        with self.assertRaisesRegex(KeyError, "sizes"):
            model.size_function(fails_in_b)
        with self.assertRaises(surfmesh.InvalidInput):
            model.size_everywhere(0.01, ["a", "none"])
        self.assertEqual(model.tabulations, [])
        np.testing.assert_array_equal(self.points(model), before)
        # Nor does one come back when the model is made again.
        model.add_group("all", ["a", "b"])
        np.testing.assert_array_equal(self.points(model), before)

    def test_are_met_once_after_a_failure(self):
        bad = [True]

        def sizes(x, y, z):
            if bad[0] and x.max() > 1:
                raise KeyError("sizes")
            return 0.1 + 0 * x

        model = self.pair()
        model.size_function(sizes)
        for _ in range(3):
            with self.assertRaisesRegex(KeyError, "sizes"):
                self.points(model)
        bad[0] = False
        points = self.points(model)
        self.assertEqual(len(model.tabulations), 2)
        once = self.pair()
        once.size_function(sizes)
        np.testing.assert_array_equal(points, self.points(once))

    def test_may_ask_for_the_model(self):
        def along(u, v):
            return 0.05 + 0.1 * model.evaluate("a", u, v)[:, 0]

        model = self.pair()
        model.size_function(along, "a", of="uv")
        self.assertGreater(len(self.points(model)), 0)
        self.assertEqual(len(model.tabulations), 1)

    def test_of_an_earlier_mesh_are_left_out_whole(self):
        model, other = square(), self.pair()
        mesh = surfmesh.mesh(other, **PLAIN)
        before = self.points(model)
        with self.assertRaisesRegex(surfmesh.InvalidInput, "no patch 1"):
            model.adapt_to(mesh, np.tile([1e4, 0, 1e4], (len(mesh.points), 1)))
        np.testing.assert_array_equal(self.points(model), before)


if __name__ == "__main__":
    unittest.main()
