#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tests of against.py and tools/bench.sh: against_test.py SURFMESH. Programs of a line or two stand for
revisions."""

import os
import subprocess
import sys
import tempfile
import unittest

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
MODELS = os.path.join(SOURCE, "models")
PROGRAM = os.path.abspath(sys.argv.pop())

# `mesh MODEL -o OUTPUT ...`
WRITES_MODEL = 'echo "$2" > "$4"'
WRITES_OTHER = 'echo other > "$4"'
NEVER_THE_SAME = 'echo $$ > "$4"'
WORKS_HARD = 'for ((i = 0; i < 400000; ++i)); do :; done; ' + WRITES_MODEL
HAS_NO_QUADS = 'if [[ "$*" == *--quads* ]]; then echo "no option --quads" >&2; exit 1; fi; ' + WRITES_MODEL


def bench(*arguments):
    return subprocess.run([sys.executable, f"{SOURCE}/tests/bench/against.py", *arguments],
                          capture_output=True, text=True, check=False)


def row(text, case):
    """The cells of a case."""
    lines = [line for line in text.splitlines() if line.startswith(f"| {case} |")]
    return [cell.strip() for cell in lines[0].strip("|").split("|")]


class Against(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.made = 0

    def program(self, body):
        self.made += 1
        path = os.path.join(self.folder.name, f"program{self.made}")
        with open(path, "w", encoding="utf-8") as file:
            file.write(f"#!/bin/bash\n{body}\n")
        os.chmod(path, 0o755)
        return path

    def compared(self, old, new, *arguments):
        result = bench(self.program(old), self.program(new), MODELS, *arguments)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result.stdout

    def test_a_program_is_as_good_as_itself(self):
        result = bench(PROGRAM, PROGRAM, MODELS, "--runs", "3", "cage")
        self.assertEqual(result.returncode, 0, result.stderr)
        cells = row(result.stdout, "cage")
        self.assertGreater(float(cells[1]), 0)
        self.assertTrue(0.5 < float(cells[3]) < 2, cells)
        self.assertTrue(0.9 < float(cells[5]) < 1.1, cells)
        self.assertEqual(cells[6], "same")

    def test_every_case_is_understood_by_the_program(self):
        result = subprocess.run([sys.executable, "-c",
                                 "import against; print('\\n'.join(against.CASES.values()))"],
                                cwd=f"{SOURCE}/tests/bench", capture_output=True, text=True, check=True,
                                env=os.environ | {"PYTHONDONTWRITEBYTECODE": "1"})
        lines = result.stdout.splitlines()
        self.assertGreaterEqual(len(lines), 8)
        for line in lines:
            model, *options = line.split()
            run = subprocess.run([PROGRAM, "mesh", f"{MODELS}/{model}", "--dry-run", "--quiet", *options],
                                 capture_output=True, text=True, check=False)
            self.assertIn(run.returncode, (0, 3), f"{line}: {run.stderr}")

    def test_more_work_has_a_ratio_above_one(self):
        cells = row(self.compared(WRITES_MODEL, WORKS_HARD, "--runs", "2", "cage"), "cage")
        self.assertGreater(float(cells[3]), 2)
        self.assertGreater(float(cells[4].split()[0]), 2)

    def test_other_bytes_are_told(self):
        self.assertEqual(row(self.compared(WRITES_MODEL, WRITES_OTHER, "--runs", "1", "cage"), "cage")[6],
                         "differ")
        cells = row(self.compared(WRITES_MODEL, NEVER_THE_SAME, "--runs", "1", "cage"), "cage")
        self.assertEqual(cells[6], "new not twice the same")

    def test_a_case_that_one_rejects_is_told_and_the_others_are_measured(self):
        text = self.compared(HAS_NO_QUADS, WRITES_MODEL, "--runs", "1")
        self.assertEqual(row(text, "quads")[1], "old rejects it: no option --quads")
        self.assertEqual(row(text, "cage")[6], "same")

    def test_nothing_measured_is_a_failure(self):
        fails = self.program("exit 1")
        self.assertEqual(bench(fails, fails, MODELS, "--runs", "1", "cage").returncode, 1)

    def test_an_unknown_case_names_those_there_are(self):
        result = bench(PROGRAM, PROGRAM, MODELS, "nonsense")
        self.assertEqual(result.returncode, 2)
        self.assertIn("there is no case nonsense; there are cage, ", result.stderr)

    def test_an_unknown_revision_is_an_error(self):
        result = subprocess.run([f"{SOURCE}/tools/bench.sh", "--against", "no-such-revision"],
                                capture_output=True, text=True, check=False)
        self.assertEqual(result.returncode, 2)
        self.assertIn("there is no revision no-such-revision", result.stderr)


if __name__ == "__main__":
    unittest.main()
