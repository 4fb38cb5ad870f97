#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""How runs scale: with threads, with ranks, by simulation with many ranks, and in memory.

    tests/bench/scaling.py PROGRAMS MODEL [OPTION ...]

PROGRAMS is the folder of surfmesh and surfmesh-mpi. The options are those of `surfmesh mesh`, such as
`--hmax 0.07% --hmin 0.03%`. Prints tables in Markdown. Seconds are processor seconds, which other
work on the machine changes little; what a free machine would take by the clock is bounded from
below by the longest path: all that is serial, and the busiest rank or thread.
"""

import json
import os
import subprocess
import sys
import tempfile

THREADS = (1, 2, 4)
RANKS = (1, 2, 4)
SIMULATED_RANKS = (4, 16, 64)


def run(command, report):
    """Run a command that writes a report.

    Returns the report, and the peak of memory of the largest process in bytes.
    """
    process = subprocess.Popen(command + ["--quiet", "--report", report], env=environment())
    _, status, usage = os.wait4(process.pid, 0)
    if os.waitstatus_to_exitcode(status) not in (0, 3):
        sys.exit(f"failed: {' '.join(command)}")
    with open(report, encoding="utf-8") as file:
        return json.load(file), usage.ru_maxrss * 1024


def environment():
    return os.environ | {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}


def triangles_of(report):
    return report["mesh"]["triangles"] + report["mesh"]["quads"]


def print_row(*cells):
    print("| " + " | ".join(str(cell) for cell in cells) + " |")


def print_head(*cells):
    print_row(*cells)
    print_row(*("---" for _ in cells))


def strong_by_threads(programs, model, options, folder):
    print("\n## Threads\n")
    print_head("threads", "triangles", "processor s", "serial s a million", "clock s",
               "bytes a triangle")
    for threads in THREADS:
        report, memory = run(
            [f"{programs}/surfmesh", "mesh", model, "-o", f"{folder}/mesh.obj", "--threads",
             str(threads), *options], f"{folder}/report.json")
        count = triangles_of(report)
        seconds = report["seconds"]
        print_row(threads, count, f"{seconds['total']:.2f}",
                  f"{1e6 * seconds['serial'] / count:.3f}", f"{seconds['wall']:.2f}",
                  round(memory / count))


def strong_by_ranks(programs, model, options, folder):
    print("\n## Ranks\n")
    print_head("ranks", "triangles", "processor s of the busiest", "of all", "MB sent by all")
    for ranks in RANKS:
        report, _ = run(
            ["mpirun", "--oversubscribe", "-n", str(ranks), f"{programs}/surfmesh-mpi", "mesh", model,
             "--pieces", f"{folder}/pieces", "--threads", "1", *options], f"{folder}/report.json")
        pieces = report["pieces"]
        seconds = pieces["seconds_of_ranks"]
        print_row(ranks, triangles_of(report), f"{max(seconds):.2f}", f"{sum(seconds):.2f}",
                  f"{pieces['bytes_sent'] / 1e6:.2f}")


def weak_by_simulation(programs, model, options, folder):
    print("\n## Many ranks, from the tiling alone\n")
    print_head("ranks", "tiles", "greatest share of the mean", "vertices on several ranks",
               "MB sent by all")
    for ranks in SIMULATED_RANKS:
        report, _ = run(
            [f"{programs}/surfmesh", "mesh", model, "--dry-run", "--ranks", str(ranks), *options],
            f"{folder}/report.json")
        deal = report["pieces"]
        shares = deal["triangles_of_ranks"]
        print_row(ranks, deal["tiles"], f"{max(shares) * len(shares) / sum(shares):.2f}",
                  deal["shared_vertices"], f"{deal['bytes_sent'] / 1e6:.2f}")


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    programs, model, *options = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        strong_by_threads(programs, model, options, folder)
        strong_by_ranks(programs, model, options, folder)
        weak_by_simulation(programs, model, options, folder)


if __name__ == "__main__":
    main()
