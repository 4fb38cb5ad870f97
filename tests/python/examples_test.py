# SPDX-License-Identifier: BSD-3-Clause
"""The examples, in small."""

import os
import sys
import unittest

import support

import surfmesh

sys.path.insert(0, support.EXAMPLES)


def has(module):
    try:
        __import__(module)
    except ImportError:
        return False
    return True


class Examples(support.FolderTest):
    @unittest.skipUnless(has("matplotlib"), "matplotlib is not installed")
    def test_plot_a_mesh(self):
        import plot_mesh
        from matplotlib import image

        mesh = surfmesh.mesh(support.KNOB, hmax="10%")
        for field in ("quality", "patch"):
            plot_mesh.plot(mesh, self.path("mesh.png"), field)
            picture = image.imread(self.path("mesh.png"))[..., :3]
            self.assertGreater(min(picture.shape[:2]), 300)
            self.assertGreater((picture.min(axis=2) < 0.9).mean(), 0.1)  # not blank

    @unittest.skipUnless(has("scipy"), "SciPy is not installed")
    def test_adapt_to_a_layer(self):
        import adapt_poisson

        even = [adapt_poisson.uniform(size) for size in (0.02, 0.01)]
        coarse, _ = adapt_poisson.adapted(1000)
        fine, mesh = adapt_poisson.adapted(2000)
        self.assertEqual(len(fine), adapt_poisson.CYCLES + 1)
        self.assertLess(fine[-1].triangles, even[0].triangles)
        self.assertLess(10 * fine[-1].l2, even[0].l2)
        self.assertLess(2 * fine[-1].h1, even[1].h1)
        self.assertLess(fine[-1].l2, 0.7 * coarse[-1].l2)
        if has("matplotlib"):
            path = self.path("plot.png")
            adapt_poisson.plot(path, [coarse[-1], fine[-1]], even, mesh)
            self.assertGreater(os.path.getsize(path), 10_000)


if __name__ == "__main__":
    unittest.main()
