#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Print what gcovr has counted: coverage.py SUMMARY.json LEAST

Exit status 1 if less than LEAST percent of the lines are covered.
"""

import collections
import json
import sys

FILES_SHOWN = 25


def percent(covered, total):
    return 100 * covered / total if total else 100


def main():
    summary = json.load(open(sys.argv[1]))
    least = float(sys.argv[2])
    folders = collections.defaultdict(lambda: [0, 0, 0, 0])
    for file in summary["files"]:
        folder = file["filename"].split("/")[2]
        for i, key in enumerate(("line_covered", "line_total", "branch_covered", "branch_total")):
            folders[folder][i] += file[key]
    print(f"{'folder':16}{'lines':>8}{'covered':>9}{'branches':>10}{'covered':>9}")
    for folder, (lines, all_lines, branches, all_branches) in sorted(folders.items()):
        print(f"{folder:16}{all_lines:>8}{percent(lines, all_lines):>8.1f}%"
              f"{all_branches:>10}{percent(branches, all_branches):>8.1f}%")
    print("\nlines that no test runs:")
    files = sorted(summary["files"], key=lambda f: f["line_covered"] - f["line_total"])
    for file in files[:FILES_SHOWN]:
        missed = file["line_total"] - file["line_covered"]
        if missed:
            print(f"{missed:>6} of {file['line_total']:<5} {file['filename']}")
    lines = percent(summary["line_covered"], summary["line_total"])
    branches = percent(summary["branch_covered"], summary["branch_total"])
    print(f"\ncoverage: {lines:.1f} % of {summary['line_total']} lines, "
          f"{branches:.1f} % of {summary['branch_total']} branches")
    if lines < least:
        sys.exit(f"coverage: less than {least:g} % of the lines")


if __name__ == "__main__":
    main()
