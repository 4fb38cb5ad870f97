# SPDX-License-Identifier: BSD-3-Clause
"""Models built in Python: cages, functions, formulas, arrays, contours, groups."""

import math
import unittest

import numpy as np
import support

import surfmesh

TURN = 2 * math.pi


def tube(u, v):
    return np.stack([np.cos(u), np.sin(u), v], axis=1)


def lid(u, v):
    return np.stack([v * np.cos(u), v * np.sin(u), 0 * u], axis=1)


class Cages(support.FolderTest):
    def test_are_those_of_files(self):
        with open(self.path("cube.off"), "w") as file:
            file.write("OFF\n8 6 0\n")
            file.writelines("%g %g %g\n" % tuple(point) for point in support.CUBE)
            file.writelines("4 %d %d %d %d\n" % tuple(face) for face in support.CUBE_FACES)
        expected = surfmesh.mesh(self.path("cube.off"), hmax="10%")
        offsets = np.arange(0, 25, 4)
        for faces in (support.CUBE_FACES, np.array(support.CUBE_FACES, dtype=np.uint8),
                      (offsets, np.ravel(support.CUBE_FACES))):
            model = surfmesh.Model()
            model.add_cage(support.CUBE, faces)
            mesh = surfmesh.mesh(model, hmax="10%")
            np.testing.assert_array_equal(mesh.points, expected.points)
            np.testing.assert_array_equal(mesh.triangles, expected.triangles)

    def test_have_creases_corners_holes_and_groups(self):
        model = surfmesh.Model()
        model.add_cage(support.CUBE, support.CUBE_FACES, name="box",
                       creases=[([4, 5, 7, 6, 4], 10)], corners=[(0, 10)], holes=[0], groups={"top": [1]})
        mesh = surfmesh.mesh(model, hmax="10%")
        self.assertEqual(set(mesh.groups), {"top", "box"})
        self.assertFalse(mesh.report["mesh"]["closed"])
        top = np.isin(mesh.patch, mesh.groups["top"])
        np.testing.assert_allclose(mesh.points[mesh.triangles[top]][..., 2], 1, atol=1e-12)

    def test_have_creases_around_groups(self):
        meshes = []
        for keywords in ({"group_creases": {"top": 10}}, {"creases": [([4, 5, 7, 6, 4], 10)]}):
            model = surfmesh.Model()
            model.add_cage(support.CUBE, support.CUBE_FACES, groups={"top": [1]}, **keywords)
            meshes.append(surfmesh.mesh(model, hmax="20%"))
        np.testing.assert_allclose(meshes[0].points, meshes[1].points)

    def test_have_options(self):
        model = surfmesh.Model()
        model.add_cage(support.CUBE, support.CUBE_FACES)
        smooth = surfmesh.mesh(model, hmax="20%")
        sharp = surfmesh.mesh(model, hmax="20%", crease_angle=30)
        again = surfmesh.mesh(model, hmax="20%")
        self.assertAlmostEqual(sharp.points[:, 0].max(), 1, places=12)
        self.assertLess(smooth.points[:, 0].max(), 0.9)
        np.testing.assert_array_equal(smooth.points, again.points)
        self.assertEqual(sharp.notices, [])
        triangles = [face[:3] for face in support.CUBE_FACES] + [
            [face[0], face[2], face[3]] for face in support.CUBE_FACES]
        model = surfmesh.Model()
        model.add_cage(support.CUBE, triangles)
        loop = surfmesh.mesh(model, hmax="20%", scheme="loop")
        flat = surfmesh.mesh(model, hmax="20%", scheme="bilinear")
        self.assertLess(loop.points.max(), 0.9)
        self.assertAlmostEqual(flat.points.max(), 1)

    def test_refuse_what_is_none(self):
        cases = [
            (support.CUBE[:2], [[0, 1, 1]], "shape"),
            ([[0, 0]], [[0, 1, 2]], "shape"),
            ([[0, 0, math.nan]] * 4, [[0, 1, 2]], r"vertices\[0, 2\] is nan"),
            ("cube", support.CUBE_FACES, "numbers"),
            (support.CUBE, [], "no faces"),
            (support.CUBE, np.zeros((0, 3), dtype=int), "no faces"),
            (support.CUBE, [[0, 1]], "three corners"),
            (support.CUBE, [[0, 1, 8]], "vertex 8"),
            (support.CUBE, [[0, 1, -1]], "vertex -1"),
            (support.CUBE, [[0.5, 1, 2]], "whole numbers"),
            (support.CUBE, 3, "list of faces"),
            (np.array(support.CUBE) * 1j, support.CUBE_FACES, "numbers"),
        ]
        for vertices, faces, text in cases:
            with self.assertRaisesRegex(surfmesh.InvalidInput, text):
                surfmesh.Model().add_cage(vertices, faces)
        with self.assertRaises(surfmesh.InvalidInput):
            surfmesh.Model().add_cage(support.CUBE, support.CUBE_FACES, creases=[([0, 7], 10)])
        with self.assertRaises(surfmesh.InvalidInput):
            surfmesh.Model().add_cage(support.CUBE, support.CUBE_FACES, groups={"a": [6]})


class Functions(unittest.TestCase):
    def test_become_splines_with_a_measured_error(self):
        calls = []

        def wave(u, v):
            calls.append(len(u))
            return np.stack([u, v, 0.1 * np.sin(6 * u) * np.cos(4 * v)], axis=1)

        model = surfmesh.Model()
        sampling = model.add_patch("wave", wave, (0, 2), (-1, 1), tolerance=1e-7)
        self.assertLessEqual(sampling.error, 1e-7)
        self.assertEqual(sampling.evaluations, sum(calls))
        self.assertLessEqual(max(calls), 65536)
        self.assertLess(len(calls), 40)
        self.assertTrue(all(0 <= x <= 2 or -1 <= x <= 1 for x in sampling.at))
        u, v = np.random.default_rng(1).uniform((0, -1), (2, 1), (10000, 2)).T
        distance = np.linalg.norm(model.evaluate("wave", u, v) - wave(u, v), axis=1)
        self.assertLessEqual(distance.max(), 1e-7)

    def test_may_ask_for_patches_that_are_there(self):
        model = surfmesh.Model()
        model.add_patch("low", "0.1*u*v")
        model.add_patch("high", lambda u, v: model.evaluate("low", u, v) + [0, 0, 1])
        np.testing.assert_allclose(model.evaluate("high", 1, 1), [1, 1, 1.1], atol=1e-9)
        self.assertEqual(model.patch_names, ["low", "high"])

    def test_give_the_mesh_of_formulas(self):
        function, formula = surfmesh.Model(), surfmesh.Model()
        function.add_patch("a", lambda u, v: (u, v, 0.3 * np.sin(3 * u)), (0, 2), (0, 1))
        formula.add_patch("a", "0.3*sin(3*u)", (0, 2), (0, 1))
        ours, exact = (surfmesh.mesh(m, hmax=0.1).report["mesh"] for m in (function, formula))
        self.assertAlmostEqual(ours["triangles"] / exact["triangles"], 1, delta=0.02)

    def test_are_joined_with_each_other(self):
        model = surfmesh.Model()
        model.add_patch("tube", tube, (0, TURN), (0, 2))
        model.add_patch("lid", lid, (0, TURN), (0, 1))
        mesh = surfmesh.mesh(model, hmax=0.2)
        self.assertEqual(mesh.report["mesh"]["euler"], 1)
        self.assertEqual(mesh.notices, [])
        radius = np.hypot(*mesh.points[mesh.triangles[mesh.patch == 0]].reshape(-1, 3)[:, :2].T)
        np.testing.assert_allclose(radius, 1, atol=1e-7)

    def test_are_called_by_the_thread_that_asks(self):
        import threading

        threads = set()

        def flat(u, v):
            threads.add(threading.get_ident())
            return u, v, 0

        model = surfmesh.Model()
        model.add_patch("flat", flat)
        surfmesh.mesh(model, hmax=0.1, threads=2)
        self.assertEqual(threads, {threading.get_ident()})

    def test_raise_what_they_raise(self):
        def fails(u, v):
            raise ZeroDivisionError("in the function")

        with self.assertRaisesRegex(ZeroDivisionError, "in the function"):
            surfmesh.Model().add_patch("a", fails)

    def test_must_return_points(self):
        cases = [
            (lambda u, v: u, "shape"),
            (lambda u, v: np.stack([u, v], axis=1), "shape"),
            (lambda u, v: np.stack([u, v, u])[:, :3], "shape"),
            (lambda u, v: None, "shape"),
            (lambda u, v: "abc", "numbers"),
            (lambda u, v: (u, v), "shape|numbers"),
            (lambda u, v: (u, v, u[:3]), "arrays"),
            (lambda u, v: np.stack([u, v, 1j * u], axis=1), "complex"),
        ]
        for function, text in cases:
            with self.assertRaisesRegex(surfmesh.InvalidInput, text):
                surfmesh.Model().add_patch("a", function)
        with self.assertRaisesRegex(surfmesh.GeometryError, "not finite"):
            surfmesh.Model().add_patch("a", lambda u, v: (u, v, np.where(u > 0.6, np.nan, 0)))

    def test_must_not_bend_sharply(self):
        with self.assertRaisesRegex(surfmesh.LimitError, "bends sharply"):
            surfmesh.Model().add_patch("a", lambda u, v: (u, v, abs(u - 0.3)), max_samples=20_000)
        model = surfmesh.Model()
        model.add_patch("a", lambda u, v: (u, v, abs(u - 0.3)), tolerance="1%")

    def test_have_tolerances(self):
        for tolerance in (0, -1, "200%", "x", math.nan, True, [1]):
            with self.assertRaises(surfmesh.Error, msg=tolerance):
                surfmesh.Model().add_patch("a", lambda u, v: (u, v, 0), tolerance=tolerance)


class Grids(unittest.TestCase):
    def test_are_splines_through_points(self):
        u, v = np.meshgrid(np.linspace(0, TURN, 41), np.linspace(0, 1, 7))
        points = np.stack([np.cos(u), np.sin(u), v], axis=2)
        model = surfmesh.Model()
        self.assertIsNone(model.add_patch("roll", points, (0, TURN), (0, 1)))
        np.testing.assert_allclose(model.evaluate("roll", u, v), points, atol=1e-14)
        self.assertEqual(surfmesh.mesh(model, hmax=0.2).report["mesh"]["euler"], 0)

    def test_refuse_what_is_none(self):
        for points in (np.zeros((5, 9, 3)), np.zeros((9, 9)), np.zeros((9, 9, 2)),
                       np.full((9, 9, 3), np.inf), np.array("x"), np.zeros((0, 0, 3))):
            with self.assertRaises(surfmesh.InvalidInput):
                surfmesh.Model().add_patch("a", points)


class Formulas(unittest.TestCase):
    def test_are_surfaces(self):
        model = surfmesh.Model()
        model.add_patch("roll", ("r*cos(w)", "r*sin(w)", "v"), (0, 1), (0, 2),
                        where={"w": "2*pi*u"}, constants={"r": 2})
        point, du, dv = model.evaluate("roll", 0.25, 1, order=1)
        np.testing.assert_allclose(point, [0, 2, 1], atol=1e-12)
        np.testing.assert_allclose(du, [-4 * math.pi, 0, 0], atol=1e-12)
        np.testing.assert_allclose(dv, [0, 0, 1], atol=1e-12)
        self.assertEqual(len(model.evaluate("roll", [0.1, 0.2], 1, order=2)), 6)
        self.assertEqual(model.evaluate("roll", np.zeros((2, 3)), 1).shape, (2, 3, 3))
        self.assertEqual(model.domain("roll"), ((0, 1), (0, 2)))

    def test_tell_what_is_wrong(self):
        with self.assertRaisesRegex(surfmesh.InvalidInput, "cos"):
            surfmesh.Model().add_patch("a", ("cosx(u)", "v", "0"))
        for surface in (("u", "v"), 3, ("u", "v", 1), None):
            with self.assertRaises((surfmesh.InvalidInput, TypeError)):
                surfmesh.Model().add_patch("a", surface)
        for domain in ((1, 0), (0, 0), (0, math.inf), 3, "ab", (0, 1, 2)):
            with self.assertRaises(surfmesh.InvalidInput):
                surfmesh.Model().add_patch("a", "0", domain)


class Nurbs(unittest.TestCase):
    def test_are_patches(self):
        model = surfmesh.Model()
        rows = [[[x, y, x * y] for x in (0, 1, 2)] for y in (0, 1)]
        model.add_nurbs("net", rows, ([0, 0, 0, 1, 1, 1], [0, 0, 1, 1]), (2, 1),
                        weights=[[1, 1, 1], [1, 1, 1]])
        np.testing.assert_allclose(model.evaluate("net", 0.5, 0.5), [1, 0.5, 0.5])
        self.assertGreater(len(surfmesh.mesh(model, hmax=0.3).triangles), 20)
        part = surfmesh.Model()
        part.add_nurbs("net", rows, ([0, 0, 0, 1, 1, 1], [0, 0, 1, 1]), (2, 1),
                       domain=((0, 0.5), (0, 1)))
        self.assertEqual(part.domain("net"), ((0, 0.5), (0, 1)))
        with self.assertRaises(surfmesh.InvalidInput):
            surfmesh.Model().add_nurbs("net", rows, ([0, 0, 1, 1], [0, 0, 1, 1]), (2, 1))
        with self.assertRaises(surfmesh.InvalidInput):
            surfmesh.Model().add_nurbs("net", rows, ([0, 0, 0, 1, 1, 1], [0, 0, 1, 1]), (2, 1),
                                       weights=[[1, 1]])


class Trims(unittest.TestCase):
    def area(self, model):
        mesh = surfmesh.mesh(model, size=0.05)
        a, b, c = mesh.points[mesh.triangles].transpose(1, 0, 2)
        return 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1).sum()

    def test_are_polygons(self):
        model = surfmesh.Model()
        model.add_patch("plate", "0", (0, 2), (0, 1), loops=["edge"])
        model.add_contour("edge", {"plate": [[0, 0], [2, 0], [1, 1], [0, 0]]})
        self.assertAlmostEqual(self.area(model), 1, places=9)

    def test_are_holes_of_every_kind(self):
        t = np.linspace(0, -TURN, 41)
        circle = np.stack([1 + 0.5 * np.cos(t), 1 + 0.5 * np.sin(t)], axis=1)
        curves = [
            ({"hole": circle}, {"smooth": True}),
            ({"hole": ("1 + cos(t)/2", "1 - sin(t)/2")}, {"t": (0, TURN)}),
            ({"hole": lambda t: (1 + np.cos(t) / 2, 1 - np.sin(t) / 2)}, {"t": (0, TURN)}),
        ]
        for on, keywords in curves:
            model = surfmesh.Model()
            sides = ["plate:v0", "plate:u1", "-plate:v1", "-plate:u0"]
            model.add_patch("plate", "0", (0, 2), (0, 2), loops=[sides, "hole"])
            model.add_contour("hole", {"plate": on["hole"]}, **keywords)
            self.assertAlmostEqual(self.area(model), 4 - math.pi / 4, delta=5e-3)

    def test_join_patches(self):
        model = surfmesh.Model()
        pipe = ["ring", "pipe:u1", "-pipe:v1", "-pipe:u0"]
        model.add_patch("plate", "0", (-2, 2), (-2, 2),
                        loops=[["plate:v0", "plate:u1", "-plate:v1", "-plate:u0"], ["-ring"]])
        model.add_patch("pipe", ("cos(u)", "sin(u)", "v"), (0, TURN), (0, 1), loops=[pipe])
        model.add_contour("ring", {"pipe": ("t", "0"), "plate": None}, t=(0, TURN))
        mesh = surfmesh.mesh(model, hmax=0.3)
        self.assertEqual(mesh.report["mesh"]["euler"], 0)
        self.assertIn("ring", model.contour_names)

    def test_are_left_out_whole_if_they_fail(self):
        model = surfmesh.Model()
        model.add_patch("plate", "0", (0, 2), (0, 1), loops=["edge"])
        model.add_patch("far", "5", (0, 2), (0, 1))
        triangle = [[0, 0], [2, 0], [1, 1], [0, 0]]
        for bad in (("t", "cosx(t)"), [[0, 0]], lambda t: t):
            with self.assertRaises(surfmesh.InvalidInput):
                model.add_contour("edge", {"far": triangle, "plate": bad})
        model.add_contour("edge", {"plate": triangle})
        self.assertAlmostEqual(self.area(model), 3, places=9)

    def test_refuse_what_is_none(self):
        def model(curve, **keywords):
            made = surfmesh.Model()
            made.add_patch("plate", "0", (0, 2), (0, 1), loops=["edge"])
            made.add_contour("edge", {"plate": curve}, **keywords)
            return made

        for curve, keywords in (([[0, 0]], {}), ([[0, 0], [1, math.nan]], {}), ("x", {}), (3, {}),
                                (("t", "0", "0"), {}), ([[0, 0]] * 3, {"smooth": True}),
                                (lambda t: t, {}), (("t", "0"), {"t": (1, 0)})):
            with self.assertRaises(surfmesh.InvalidInput, msg=curve):
                model(curve, **keywords)
        with self.assertRaises(surfmesh.Error):
            surfmesh.mesh(model([[0, 0], [2, 0], [1, 0.5]]))  # does not close
        with self.assertRaises(surfmesh.InvalidInput):
            surfmesh.Model().add_contour("edge", {})


class Parts(unittest.TestCase):
    def test_are_put_together(self):
        model = surfmesh.Model()
        model.add_patch("floor", "0", (3, 4))
        model.add_patch("wall", ("3", "u", "v"))
        model.add_group("room", ["floor", "wall"])
        model.add_cage(support.CUBE, support.CUBE_FACES, name="box")
        self.assertEqual(model.groups["room"], [0, 1])
        self.assertEqual(model.patch_names[:2], ["floor", "wall"])
        self.assertTrue(all(name.startswith("box:") for name in model.patch_names[2:]))
        self.assertEqual(len(model.groups["box"]), len(model.patch_names) - 2)
        np.testing.assert_allclose(model.box[1], [4, 1, 1])
        self.assertAlmostEqual(model.diagonal, np.linalg.norm(model.box[1] - model.box[0]))
        mesh = surfmesh.mesh(model, hmax=0.5)
        self.assertEqual(set(mesh.groups), {"room", "box"})
        self.assertEqual(repr(model), "<surfmesh.Model built in Python>")

    def test_must_be_there(self):
        with self.assertRaisesRegex(surfmesh.InvalidInput, "no patches"):
            surfmesh.mesh(surfmesh.Model())
        model = surfmesh.Model()
        model.add_patch("floor", "0")
        with self.assertRaises(surfmesh.InvalidInput):
            model.add_group("room", ["flor"])
        with self.assertRaises(surfmesh.InvalidInput):
            model.evaluate("flor", 0, 0)
        with self.assertRaises(surfmesh.InvalidInput):
            model.evaluate(1, 0, 0)
        with self.assertRaises(surfmesh.InvalidInput):
            model.evaluate(0, math.nan, 0)
        with self.assertRaises(surfmesh.InvalidInput):
            model.evaluate(0, 0, 0, order=3)
        with self.assertRaises(surfmesh.InvalidInput):
            model.evaluate(0, [0, 1], [0, 1, 2])

    def test_belong_to_models_of_python(self):
        model = surfmesh.read(support.KNOB)
        self.assertIn("knob.obj", repr(model))
        with self.assertRaisesRegex(surfmesh.InvalidInput, "only sizes"):
            model.add_patch("a", "0")
        with self.assertRaises(surfmesh.InvalidInput):
            model.add_cage(support.CUBE, support.CUBE_FACES)


if __name__ == "__main__":
    unittest.main()
