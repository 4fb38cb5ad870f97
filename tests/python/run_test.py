# SPDX-License-Identifier: BSD-3-Clause
"""Runs: options, errors, progress, cancellation, signals, threads."""

import os
import signal
import subprocess
import sys
import threading
import time
import unittest

import numpy as np
import support

import surfmesh

LONG = dict(size="0.25%")  # a second or more


class Options(unittest.TestCase):
    def test_are_those_of_the_table(self):
        names = [option.name for option in surfmesh.options()]
        self.assertEqual(len(names), len(set(names)))
        for name in ("hmax", "sag", "quads", "threads", "weld", "nodes"):
            self.assertIn(name, names)
        for option in surfmesh.options():
            self.assertTrue(option.text and option.range and option.default, option.name)
            self.assertIn(option.group, ("sizes", "control space", "meshing", "model"))
            for function in (surfmesh.mesh, surfmesh.read, surfmesh.estimate):
                self.assertIn(f"\n  {option.name}: ", function.__doc__)

    def test_take_values_of_python(self):
        cases = [({"hmax": 0.5}, "0.5"), ({"hmax": "10%"}, "10%"),
                 ({"hmax": np.float64(0.5)}, "0.5"),
                 ({"hmax": 1}, "1"), ({"nodes": np.int32(100)}, 100), ({"features": False}, False),
                 ({"features": np.bool_(False)}, False), ({"grade": "off"}, "off"),
                 ({"grade": None}, 1.5)]
        for keywords, expected in cases:
            report = surfmesh.mesh(support.KNOB, **{"hmax": "20%", **keywords}).report
            name, value = next(iter(keywords.items()))
            self.assertEqual(str(report["options"][name]), str(expected), keywords)
            self.assertEqual(name in report["given"], value is not None)
            for given in report["given"].values():
                self.assertEqual(given["from"], "python")

    def test_refuse_what_is_none(self):
        with self.assertRaisesRegex(surfmesh.InvalidOption, "hmax"):
            surfmesh.mesh(support.KNOB, hmx=1)
        for keywords in ({"hmax": -1}, {"hmax": "big"}, {"hmax": [1]}, {"hmax": {}},
                         {"threads": 0.5}, {"quads": "maybe"}, {"grade": float("nan")}, {"scheme": "cubic"}):
            with self.assertRaises(surfmesh.InvalidOption, msg=keywords):
                surfmesh.mesh(support.KNOB, **keywords)
        with self.assertRaises(surfmesh.InvalidOption):
            surfmesh.mesh(support.KNOB, hmx=None)

    def test_of_a_model_act_where_it_is_read(self):
        model = surfmesh.read(support.model("cube.obj"), crease_angle=30, hmax="20%")
        self.assertEqual(model.options["crease_angle"], 30)
        mesh = surfmesh.mesh(model)
        self.assertAlmostEqual(np.ptp(mesh.points[:, 0]), np.ptp(model.box[:, 0]), places=9)
        late = surfmesh.mesh(surfmesh.read(support.model("cube.obj")), crease_angle=30, hmax="20%")
        self.assertEqual([notice.kind for notice in late.notices], ["unused_option"])

    def test_have_no_scheme_for_a_model_that_was_read(self):
        model = surfmesh.read(support.model("cube.obj"), scheme="bilinear")
        flat = surfmesh.mesh(model, hmax="20%")
        self.assertAlmostEqual(np.ptp(flat.points[:, 0]), np.ptp(model.box[:, 0]), places=9)
        for run in (surfmesh.mesh, surfmesh.estimate, lambda m, **k: surfmesh.check(flat, m, **k)):
            with self.assertRaisesRegex(surfmesh.InvalidInput, "surfmesh.read"):
                run(model, scheme="catmark")
        with self.assertRaisesRegex(surfmesh.InvalidInput, "scheme needs a model"):
            surfmesh.check(flat, scheme="loop")


class Errors(support.FolderTest):
    def test_have_codes_and_usual_bases(self):
        for error, code, base in ((surfmesh.InvalidInput, "invalid input", ValueError),
                                  (surfmesh.InvalidOption, "invalid option", ValueError),
                                  (surfmesh.MissingProperty, "missing property", LookupError),
                                  (surfmesh.FileError, "io", OSError),
                                  (surfmesh.GeometryError, "geometry", ArithmeticError),
                                  (surfmesh.LimitError, "limit", RuntimeError),
                                  (surfmesh.Cancelled, "cancelled", surfmesh.Error)):
            self.assertTrue(issubclass(error, surfmesh.Error))
            self.assertTrue(issubclass(error, base))
            self.assertEqual(error.code, code)

    def test_come_from_the_library(self):
        with self.assertRaises(surfmesh.FileError) as caught:
            surfmesh.read(self.path("none.obj"))
        self.assertEqual(caught.exception.code, "io")
        self.assertIn("none.obj", str(caught.exception))
        with self.assertRaises(surfmesh.InvalidInput):
            surfmesh.read(self.path("none.txt"))
        with self.assertRaises(surfmesh.LimitError):
            surfmesh.mesh(support.KNOB, size="1%", max_elements=1000)
        with open(self.path("bad.json"), "w") as file:
            file.write('{"patches": [{"name": "a", "surface": {"z": "1/(u-u)"}, "domain": '
                       '{"u": [0, 1], "v": [0, 1]}}]}')
        with self.assertRaises(surfmesh.GeometryError):
            surfmesh.mesh(self.path("bad.json"))

    def test_tell_of_wrong_types(self):
        for model in (3, None, [1]):
            with self.assertRaises(surfmesh.InvalidInput):
                surfmesh.mesh(model)
        with self.assertRaises(TypeError):
            surfmesh.mesh()


class Progress(unittest.TestCase):
    def test_tells_of_all_stages(self):
        news = []
        mesh = surfmesh.mesh(support.KNOB, hmax="3%", progress=lambda *told: news.append(told))
        stages = list(dict.fromkeys(stage for stage, *_ in news))
        for stage in ("control", "boundary", "assemble"):
            self.assertIn(stage, stages)
        for stage, done, total, elements in news:
            self.assertIsInstance(stage, str)
            self.assertLessEqual(done, total)
            self.assertLessEqual(elements, 2 * len(mesh.triangles))

    def test_is_told_to_the_calling_thread(self):
        threads = set()
        surfmesh.mesh(support.KNOB, hmax="3%", threads=2,
                      progress=lambda *told: threads.add(threading.get_ident()))
        self.assertEqual(threads, {threading.get_ident()})

    def test_ends_a_run_by_false(self):
        start = time.monotonic()
        with self.assertRaises(surfmesh.Cancelled):
            surfmesh.mesh(support.KNOB, progress=lambda *told: False, size="0.05%",
                          max_elements=2_000_000_000)
        self.assertLess(time.monotonic() - start, 30)

    def test_ends_a_run_by_false_of_numpy(self):
        with self.assertRaises(surfmesh.Cancelled):
            surfmesh.mesh(support.KNOB, progress=lambda *told: np.array(told[1:]).max() < 0,
                          size="0.05%", max_elements=2_000_000_000)

    def test_ends_a_run_even_at_its_end(self):
        def waits(*told):
            time.sleep(1)  # the run ends meanwhile
            return False

        for run in (surfmesh.mesh, surfmesh.estimate):
            with self.assertRaises(surfmesh.Cancelled):
                run(support.KNOB, progress=waits, hmax="30%")

    def test_is_told_nothing_after_false(self):
        news = []

        def ends(*told):
            news.append(told)
            return len(news) < 2

        with self.assertRaises(surfmesh.Cancelled):
            surfmesh.mesh(support.KNOB, progress=ends, hmax="30%")
        self.assertEqual(len(news), 2)

    def test_ends_a_run_by_what_it_raises(self):
        def fails(*told):
            raise ArithmeticError("enough")

        with self.assertRaisesRegex(ArithmeticError, "enough"):
            surfmesh.mesh(support.KNOB, progress=fails, **LONG)
        # Nothing is left of that run.
        self.assertGreater(len(surfmesh.mesh(support.KNOB, hmax="20%").triangles), 0)

    def test_goes_on_with_none_and_true(self):
        for answer in (None, True, 0, np.True_, np.int32(0), "", np.zeros(2)):
            surfmesh.mesh(support.KNOB, hmax="20%", progress=lambda *told: answer)

    def test_must_be_a_function(self):
        with self.assertRaises(TypeError):
            surfmesh.mesh(support.KNOB, hmax="20%", progress=3)


class Signals(unittest.TestCase):
    CHILD = """
import surfmesh, sys
print("begins", flush=True)
try:
    surfmesh.mesh(sys.argv[1], size="0.05%", max_elements=2000000000)
except KeyboardInterrupt:
    print("interrupted", flush=True)
"""

    def test_interrupt_a_run(self):
        child = subprocess.Popen([sys.executable, "-c", self.CHILD, support.KNOB],
                                 stdout=subprocess.PIPE, text=True)
        self.assertEqual(child.stdout.readline(), "begins\n")
        time.sleep(0.5)
        child.send_signal(signal.SIGINT)
        output, _ = child.communicate(timeout=60)
        self.assertEqual(output, "interrupted\n")

    def test_call_handlers_during_a_run(self):
        called = []
        before = signal.signal(signal.SIGALRM, lambda *_: called.append(time.monotonic()))
        try:
            signal.setitimer(signal.ITIMER_REAL, 0.1)
            surfmesh.mesh(support.KNOB, threads=1, **LONG)
            end = time.monotonic()
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)
            signal.signal(signal.SIGALRM, before)
        self.assertEqual(len(called), 1)
        self.assertLess(called[0], end)


class Threads(unittest.TestCase):
    def test_go_on_during_a_run(self):
        """Another thread counts in steps of 5 ms; the run leaves it nearly all of them."""
        ticks, stop = [], threading.Event()

        def tick():
            while not stop.wait(0.005):
                ticks.append(time.monotonic())

        other = threading.Thread(target=tick)
        other.start()
        begin = time.monotonic()
        surfmesh.mesh(support.KNOB, threads=1, **LONG)
        end = time.monotonic()
        stop.set()
        other.join()
        during = [t for t in ticks if begin < t < end]
        self.assertGreater(len(during), 20 * (end - begin))
        self.assertLess(max(np.diff([begin] + during + [end])), 0.5 * (end - begin))

    def test_may_mesh_one_model_at_once(self):
        model = surfmesh.read(support.KNOB)
        model.size_everywhere("3%")
        expected = surfmesh.mesh(model)
        results = [None] * 4

        def work(i):
            results[i] = surfmesh.mesh(model, threads=1)

        threads = [threading.Thread(target=work, args=(i,)) for i in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for mesh in results:
            np.testing.assert_array_equal(mesh.points, expected.points)

    def test_may_add_to_one_model_at_once(self):
        """Patches come from two threads, sizes from another, and two more ask for the model."""
        model = surfmesh.Model()
        model.add_patch("first", "0")
        failures, stop = [], threading.Event()
        self.addCleanup(sys.setswitchinterval, sys.getswitchinterval())
        sys.setswitchinterval(1e-6)  # threads take turns as often as they can

        def guarded(work):
            try:
                work()
            except Exception as error:
                failures.append(error)

        def add(side):
            for i in range(80):
                model.add_patch(f"{side}{i}", "0", (2 * i + 2, 2 * i + 3), (side, side + 1))
                model.add_nurbs(f"net{side}{i}", [[[x, y, 9 + i] for x in (0, 1)] for y in (0, 1)],
                                ([0, 0, 1, 1], [0, 0, 1, 1]), (1, 1))
                model.add_group(f"group{side}{i}", [f"{side}{i}", f"net{side}{i}"])

        def size():
            for i in range(40):
                model.size_everywhere(1 + i, "first")

        def ask():
            while not stop.is_set():
                names = model.patch_names
                self.assertEqual(len(names), len(set(names)))
                self.assertGreater(surfmesh.estimate(model, hmax=1)["estimated_elements"], 0)

        def watch():
            while not stop.is_set():
                model.evaluate("first", 0.5, 0.5)
                model.tabulations

        adding = [threading.Thread(target=guarded, args=(work,))
                  for work in (lambda: add(10), lambda: add(20), size)]
        asking = [threading.Thread(target=guarded, args=(work,)) for work in (ask, watch)]
        for thread in adding + asking:
            thread.start()
        for thread in adding:
            thread.join()
        stop.set()
        for thread in asking:
            thread.join()
        self.assertEqual(failures, [])
        self.assertEqual(len(model.patch_names), 321)
        self.assertEqual(len(model.groups), 160)
        for name, patches in model.groups.items():
            self.assertEqual([model.patch_names[p] for p in patches],
                             [name[5:], "net" + name[5:]])

    def test_do_not_change_the_mesh(self):
        one, two = (surfmesh.mesh(support.KNOB, hmax="3%", threads=n) for n in (1, 2))
        np.testing.assert_array_equal(one.points, two.points)
        np.testing.assert_array_equal(one.triangles, two.triangles)


@unittest.skipUnless(any(name.startswith("_surfmesh_cad")
                         for name in os.listdir(os.path.dirname(surfmesh.__file__))),
                     "surfmesh is built without OpenCASCADE")
class Cad(support.FolderTest):
    def test_files_are_read(self):
        mesh = surfmesh.mesh(support.model("part.step"), segments_per_circle=12, hmax="10%")
        self.assertIn("worm", mesh.groups)
        self.assertTrue(mesh.report["mesh"]["closed"])

    def test_give_the_mesh_of_the_command_line(self):
        support.run("mesh", support.model("part.step"), "-o", self.path("mesh.om"), "--hmax", "3%",
                    "--quiet")
        mesh = surfmesh.mesh(support.model("part.step"), hmax="3%")
        expected = surfmesh.read_mesh(self.path("mesh.om"))
        np.testing.assert_array_equal(mesh.points, expected.points)
        np.testing.assert_array_equal(mesh.triangles, expected.triangles)
        self.assertTrue(surfmesh.check(mesh, support.model("part.step"))["clean"])

    def test_that_are_broken_tell_so(self):
        with open(self.path("bad.step"), "w") as file:
            file.write("ISO-10303-21;\nHEADER;\n")
        with self.assertRaisesRegex(surfmesh.InvalidInput, "bad.step"):
            surfmesh.read(self.path("bad.step"))


if __name__ == "__main__":
    unittest.main()
