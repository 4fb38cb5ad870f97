# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the Python module share."""

import os
import subprocess
import tempfile
import unittest

SOURCE = os.environ.get("SURFMESH_SOURCE",
                        os.path.dirname(os.path.dirname(os.path.dirname(__file__))))
PROGRAM = os.environ.get("SURFMESH_PROGRAM",
                         os.path.join(SOURCE, "build", "release", "tools", "surfmesh"))
EXAMPLES = os.path.join(SOURCE, "tools", "python", "examples")
KNOB = os.path.join(SOURCE, "models", "knob.obj")


def model(name):
    return os.path.join(SOURCE, "models", name)


def run(*arguments):
    """The output of the command line."""
    return subprocess.run([PROGRAM, *arguments], check=True, capture_output=True, text=True).stdout


class FolderTest(unittest.TestCase):
    """A test with a folder for its files."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name):
        return os.path.join(self.folder, name)


CUBE = [[x, y, z] for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)]
CUBE_FACES = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
