# SPDX-License-Identifier: BSD-3-Clause
"""Where the package is installed, as tools/python/module_folder.cmake decides."""

import os
import shutil
import subprocess
import unittest

import support

SCRIPT = """
include({folder}/module_folder.cmake)
set(CMAKE_INSTALL_LIBDIR lib/x86)
set(CMAKE_INSTALL_FULL_LIBDIR ${{CMAKE_INSTALL_PREFIX}}/lib/x86)
set(Python_VERSION_MAJOR 3)
set(Python_VERSION_MINOR 11)
surfmesh_module_folder(where)
surfmesh_module_rpath(rpath ${{where}})
message(STATUS "${{where}};${{rpath}}")
"""

DEBIAN = "/usr/lib/python3/dist-packages"


@unittest.skipUnless(shutil.which("cmake"), "there is no cmake on the PATH")
class Folders(support.FolderTest):
    def place(self, prefix, site=DEBIAN, chosen=""):
        with open(self.path("where.cmake"), "w") as file:
            file.write(SCRIPT.format(folder=os.path.join(support.SOURCE, "tools", "python")))
        output = subprocess.run(
            ["cmake", f"-DCMAKE_INSTALL_PREFIX={prefix}", f"-DPython_SITEARCH={site}",
             f"-DSURFMESH_PYTHON_FOLDER={chosen}", "-P", self.path("where.cmake")],
            check=True, capture_output=True, text=True).stdout
        return tuple(output.strip()[len("-- "):].split(";"))

    def test_are_those_of_python_in_its_prefix(self):
        self.assertEqual(self.place("/usr"),
                         ("lib/python3/dist-packages", "$ORIGIN/../../../x86"))
        self.assertEqual(self.place("/opt/py", "/opt/py/lib/python3.12/site-packages")[0],
                         "lib/python3.12/site-packages")

    def test_are_below_other_prefixes(self):
        for prefix in ("/usr/local", "/home/me/.local", "/us"):
            self.assertEqual(self.place(prefix),
                             ("lib/python3.11/dist-packages", "$ORIGIN/../../../x86"), prefix)

    def test_may_be_chosen(self):
        self.assertEqual(self.place("/usr", chosen="py"), ("py", "$ORIGIN/../../lib/x86"))
        self.assertEqual(self.place("/usr", chosen="/srv/py"), ("/srv/py", "/usr/lib/x86"))


if __name__ == "__main__":
    unittest.main()
