# SPDX-License-Identifier: BSD-3-Clause
"""Meshes as arrays: what they hold, how long they live, how they go to files and back."""

import gc
import json
import unittest

import numpy as np
import support

import surfmesh


class Arrays(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.mesh = surfmesh.mesh(support.KNOB, hmax="10%", normals=True)

    def test_have_shapes_and_types(self):
        mesh = self.mesh
        t, c = len(mesh.triangles), 3 * len(mesh.triangles)
        self.assertEqual(mesh.points.shape, (mesh.report["mesh"]["vertices"], 3))
        self.assertEqual(mesh.points.dtype, np.float64)
        self.assertEqual(mesh.triangles.dtype, np.int32)
        self.assertEqual(t, mesh.report["mesh"]["triangles"])
        self.assertEqual(mesh.quads.shape, (0, 4))
        self.assertEqual(mesh.patch.shape, (t,))
        self.assertEqual(mesh.group.shape, (t,))
        self.assertEqual(mesh.uv.shape, (c, 2))
        self.assertEqual(mesh.metric.shape, (c, 3))
        self.assertEqual(mesh.normals.shape, (c, 3))
        self.assertEqual(mesh.beyond.shape, (c,))
        self.assertEqual(mesh.beyond.dtype, np.bool_)
        self.assertEqual(mesh.contour_edges.shape[1], 3)

    def test_agree_with_each_other(self):
        mesh = self.mesh
        offsets, corners = mesh.faces
        np.testing.assert_array_equal(offsets, 3 * np.arange(len(mesh.triangles) + 1))
        np.testing.assert_array_equal(corners.reshape(-1, 3), mesh.triangles)
        np.testing.assert_array_equal(mesh.corner_faces, np.repeat(np.arange(len(offsets) - 1), 3))
        np.testing.assert_array_equal(mesh.triangle_faces, np.arange(len(offsets) - 1))
        self.assertEqual(len(mesh.quad_faces), 0)
        np.testing.assert_allclose(np.linalg.norm(mesh.normals, axis=1), 1)
        a, b, c = mesh.points[mesh.triangles].transpose(1, 0, 2)
        facing = np.einsum("ij,ij->i", np.cross(b - a, c - a), mesh.normals[::3])
        self.assertTrue((facing > 0).all())
        np.testing.assert_array_equal(mesh.original, np.arange(len(mesh.points)))

    def test_have_the_parameters_of_their_points(self):
        model = surfmesh.read(support.KNOB)
        mesh = self.mesh
        patches = mesh.patch[mesh.corner_faces]
        for patch in range(len(mesh.patch_names)):
            own = (patches == patch) & ~mesh.beyond
            points = model.evaluate(patch, *mesh.uv[own].T)
            np.testing.assert_allclose(points, mesh.points[mesh.faces[1][own]], atol=1e-9)

    def test_name_patches_and_groups(self):
        mesh = self.mesh
        self.assertIn("grip", mesh.groups)
        self.assertTrue(all(mesh.patch_names))
        names = list(mesh.groups)
        for face in (0, len(mesh.patch) - 1):
            patch = mesh.patch[face]
            first = next((i for i, n in enumerate(names) if patch in mesh.groups[n]), -1)
            self.assertEqual(mesh.group[face], first)

    def test_are_without_a_copy_where_they_can_be(self):
        first = self.mesh._held.points()
        second = self.mesh._held.points()
        self.assertEqual(first.__array_interface__["data"], second.__array_interface__["data"])
        self.assertFalse(first.flags.owndata)

    def test_are_kept_and_read_only(self):
        self.assertIs(self.mesh.triangles, self.mesh.triangles)
        for name in ("points", "triangles", "uv", "metric", "patch", "beyond"):
            with self.assertRaises(ValueError, msg=name):
                getattr(self.mesh, name)[0] = 0

    def test_outlive_the_mesh(self):
        mesh = surfmesh.mesh(support.KNOB, hmax="20%")
        points, triangles, uv = mesh.points, mesh.triangles, mesh.uv
        copies = [array.copy() for array in (points, triangles, uv)]
        del mesh
        gc.collect()
        junk = [np.full(100_000, 7.0) for _ in range(20)]
        for array, copy in zip((points, triangles, uv), copies):
            np.testing.assert_array_equal(array, copy)
        del junk

    def test_have_fields(self):
        mesh = self.mesh
        self.assertEqual(
            mesh.fields,
            ["patch", "group", "quality", "shape", "size", "stretch", "length", "valence"])
        for name in mesh.fields:
            count = len(mesh.points) if name == "valence" else len(mesh.triangles)
            self.assertEqual(mesh.field(name).shape, (count,), name)
        quality = mesh.field("quality")
        self.assertAlmostEqual(quality.mean(), mesh.report["quality"]["mean"], places=12)
        np.testing.assert_array_equal(mesh.field("patch"), mesh.patch)
        valence = mesh.field("valence")
        self.assertEqual(valence.sum(), 2 * (len(mesh.points) + len(mesh.triangles) - 2))
        with self.assertRaises(surfmesh.InvalidInput):
            mesh.field("colour")
        with self.assertRaises(surfmesh.MissingProperty):
            mesh.field("sag")

    def test_have_the_sag_if_it_was_asked_for(self):
        mesh = surfmesh.mesh(support.KNOB, sag="1%")
        self.assertIn("sag", mesh.fields)
        self.assertAlmostEqual(mesh.field("sag").max(), mesh.report["sag"]["reached"], places=12)

    def test_tell_what_is_missing(self):
        with self.assertRaisesRegex(surfmesh.MissingProperty, "normals=True"):
            surfmesh.mesh(support.KNOB, hmax="20%").normals

    def test_have_a_short_text(self):
        self.assertEqual(repr(self.mesh), f"<surfmesh.Mesh of {len(self.mesh.points)} vertices and "
                                          f"{len(self.mesh.triangles)} faces>")


class Quads(unittest.TestCase):
    def test_are_arrays_of_their_own(self):
        mesh = surfmesh.mesh(support.KNOB, hmax="10%", quads=True)
        self.assertEqual(len(mesh.quads), mesh.report["mesh"]["quads"])
        self.assertGreater(len(mesh.quads), 100)
        offsets, corners = mesh.faces
        self.assertEqual(len(corners), 4 * len(mesh.quads) + 3 * len(mesh.triangles))
        np.testing.assert_array_equal(corners[offsets[mesh.quad_faces[5]]:][:4], mesh.quads[5])


class Contours(unittest.TestCase):
    def test_are_edges_with_names(self):
        mesh = surfmesh.mesh(support.model("pipe_on_plate.json"))
        edges = mesh.contour_edges
        self.assertGreater(len(edges), 20)
        self.assertLess(edges[:, 2].max(), len(mesh.contour_names))
        sides = {tuple(sorted(side)) for triangle in mesh.triangles
                 for side in zip(triangle, np.roll(triangle, 1))}
        for a, b, _ in edges:
            self.assertIn(tuple(sorted((a, b))), sides)


class Files(support.FolderTest):
    def test_are_the_bytes_of_the_command_line(self):
        for name, source in (("a.om", support.KNOB), ("b.obj", support.model("wave.json")),
                             ("c.ply", support.model("torus.obj"))):
            support.run("mesh", source, "-o", self.path(name), "--hmax", "5%", "--quiet")
            with open(self.path(name), "rb") as file:
                expected = file.read()
            for threads in (1, 2):
                surfmesh.mesh(source, hmax="5%", threads=threads).write(self.path("own_" + name))
                with open(self.path("own_" + name), "rb") as file:
                    self.assertEqual(file.read(), expected, name)

    def test_are_read_back(self):
        mesh = surfmesh.mesh(support.KNOB, hmax="10%")
        self.assertEqual(mesh.write(self.path("mesh.om")), [])
        again = surfmesh.read_mesh(self.path("mesh.om"))
        for name in ("points", "triangles", "uv", "metric", "patch", "contour_edges"):
            np.testing.assert_array_equal(getattr(again, name), getattr(mesh, name), name)
        self.assertEqual(again.patch_names, mesh.patch_names)
        self.assertEqual(again.contour_names, mesh.contour_names)
        self.assertIsNone(again.report)
        self.assertEqual(again.notices, [])

    def test_hold_what_is_asked_for(self):
        mesh = surfmesh.mesh(support.KNOB, hmax="20%", normals=True)
        mesh.write(self.path("mesh.obj"), uv=True, normals=True)
        with open(self.path("mesh.obj")) as file:
            text = file.read()
        self.assertIn("\nvn ", text)
        self.assertIn("\nvt ", text)
        notices = mesh.write(self.path("mesh.stl"), uv=True)
        self.assertEqual([notice.kind for notice in notices], ["unused_option"])
        with self.assertRaises(surfmesh.MissingProperty):
            surfmesh.mesh(support.KNOB, hmax="20%").write(self.path("x.obj"), normals=True)

    def test_tell_what_is_wrong_with_them(self):
        mesh = surfmesh.mesh(support.KNOB, hmax="20%")
        with self.assertRaises(surfmesh.InvalidInput):
            mesh.write(self.path("mesh.docx"))
        with self.assertRaises(surfmesh.FileError):
            mesh.write(self.path("none/mesh.obj"))
        with self.assertRaises(surfmesh.FileError):
            surfmesh.read_mesh(self.path("none.om"))
        with open(self.path("bad.off"), "w") as file:
            file.write("OFF\n3 1 0\n0 0 0\n1 0 0\n0 x 0\n3 0 1 2\n")
        with self.assertRaisesRegex(surfmesh.InvalidInput, "bad.off:5"):
            surfmesh.read_mesh(self.path("bad.off"))
        with self.assertRaises(surfmesh.MissingProperty):
            with open(self.path("one.off"), "w") as file:
                file.write("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
            surfmesh.read_mesh(self.path("one.off")).metric


class PatchNumbers(support.FolderTest):
    def test_may_be_large(self):
        with open(self.path("mesh.ply"), "w") as file:
            file.write("ply\nformat ascii 1.0\ncomment patch 1 near\ncomment group 0 all\n"
                       "comment patches 0 1\nelement vertex 4\nproperty double x\n"
                       "property double y\nproperty double z\nelement face 2\n"
                       "property list uchar int vertex_indices\nproperty int patch\nend_header\n"
                       "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2 1\n3 0 2 3 10000000\n")
        mesh = surfmesh.read_mesh(self.path("mesh.ply"))
        self.assertEqual(mesh.patch.tolist(), [1, 10000000])
        self.assertEqual(mesh.group.tolist(), [0, -1])


def without_clocks(report):
    """A report without what differs from run to run, and without who asked for it."""
    report = json.loads(json.dumps(report))
    for entry in report["given"].values():
        entry["from"] = ""

    def cleaned(node):
        if isinstance(node, dict):
            return {key: cleaned(value) for key, value in node.items()
                    if "second" not in key and key not in ("output", "time")}
        return [cleaned(entry) for entry in node] if isinstance(node, list) else node

    return cleaned(report)


class Reports(support.FolderTest):
    def test_are_those_of_the_command_line(self):
        for source in (support.KNOB, support.model("sizes.json")):
            support.run("mesh", source, "-o", self.path("mesh.om"), "--hmax", "10%", "--grade",
                        "1.3", "--quiet", "--report", self.path("report.json"))
            with open(self.path("report.json")) as file:
                expected = json.load(file)
            report = surfmesh.mesh(source, hmax="10%", grade=1.3).report
            self.assertEqual(without_clocks(report), without_clocks(expected))

    def test_have_notices_as_objects(self):
        mesh = surfmesh.mesh(support.KNOB, hmax="20%", joining=None)
        self.assertEqual(mesh.notices, [])
        self.assertFalse(mesh.has_shortfall)
        model = surfmesh.read(support.KNOB)
        model.size_near([100, 0, 0], 0.1)
        notices = surfmesh.mesh(model, hmax="20%").notices
        self.assertEqual([(n.kind, n.severity, n.count) for n in notices],
                         [("unused_source", "warning", 1)])
        notice = notices[0]
        self.assertIn("near", notice.text)
        self.assertEqual(str(notice), notice.text)
        self.assertIn("unused_source", repr(notice))
        self.assertEqual(notice.contour, -1)
        self.assertIsInstance(notice.patch, int)
        self.assertTrue(notice.point is None or len(notice.point) == 3)

    def test_come_from_estimates(self):
        estimate = surfmesh.estimate(support.KNOB, hmax="5%")
        made = surfmesh.mesh(support.KNOB, hmax="5%").report
        self.assertAlmostEqual(estimate["estimated_elements"] / made["mesh"]["triangles"], 1,
                               delta=0.3)


class Checks(support.FolderTest):
    def test_tell_of_a_mesh(self):
        mesh = surfmesh.mesh(support.KNOB, hmax="10%")
        result = surfmesh.check(mesh)
        self.assertTrue(result["clean"])
        self.assertEqual(result["counts"]["triangles"], len(mesh.triangles))
        self.assertIsNone(result["fit"])

    def test_are_those_of_the_command_line(self):
        mesh = surfmesh.mesh(support.KNOB, hmax="10%")
        mesh.write(self.path("mesh.om"))
        text = support.run("check", self.path("mesh.om"), "--model", support.KNOB, "--json")
        expected = json.loads(text)
        self.assertEqual(surfmesh.check(self.path("mesh.om"), support.KNOB), expected)
        own = surfmesh.check(mesh, support.KNOB)
        self.assertEqual(own["mesh"], "")
        self.assertEqual(own["fit"], expected["fit"])
        self.assertEqual(own["counts"], expected["counts"])

    def test_take_a_model_built_in_python(self):
        model = surfmesh.Model()
        model.add_patch("wave", "0.1*sin(3*u)")
        result = surfmesh.check(surfmesh.mesh(model, hmax=0.1), model)
        self.assertTrue(result["clean"])
        self.assertLess(result["fit"]["distance"]["max"], 0.01)

    def test_need_a_model_for_options(self):
        with self.assertRaises(surfmesh.InvalidInput):
            surfmesh.check(surfmesh.mesh(support.KNOB, hmax="20%"), hmax=1)


if __name__ == "__main__":
    unittest.main()
