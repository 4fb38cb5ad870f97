#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Measure the module: measure.py PROGRAM MODEL [PAIRS].

First surfmesh.mesh with its arrays beside the command line, each in a new process of its own, in
turn, as ratios of medians: of the time by the clock, and of processor time, which other programs
disturb less. Then the time to sample a Python function into a surface, beside the
time of NumPy's own computation.
"""

import os
import resource
import statistics
import subprocess
import sys
import tempfile
import time

import numpy as np

import surfmesh

_CHILD = """
import sys, surfmesh
mesh = surfmesh.mesh(sys.argv[1])
arrays = (mesh.points, mesh.triangles, mesh.patch, mesh.uv, mesh.metric, mesh.contour_edges)
print(sum(array.nbytes for array in arrays), len(mesh.triangles))
"""


def timed(command: list) -> tuple:
    """Seconds by the clock and of processor time of a new process."""
    start = time.perf_counter()
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    used = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return time.perf_counter() - start, used


def compare(program: str, model: str, pairs: int) -> None:
    times = {"program": [], "python": []}
    with tempfile.TemporaryDirectory() as folder:
        output = os.path.join(folder, "mesh.om")
        for _ in range(pairs):
            times["program"].append(timed([program, "mesh", model, "-o", output, "--quiet"]))
            times["python"].append(timed([sys.executable, "-c", _CHILD, model]))
    for i, clock in enumerate(("by the clock", "of processor")):
        medians = {}
        for name, values in times.items():
            medians[name] = statistics.median(value[i] for value in values)
            each = ", ".join(f"{value[i]:.3f}" for value in values)
            print(f"{name:8} {medians[name]:.3f} s {clock}   ({each})")
        print(f"python / program {clock}: {medians['python'] / medians['program']:.3f}")


def waves(u: np.ndarray, v: np.ndarray) -> np.ndarray:
    """Of so many waves that it takes half a million samples."""
    z = 0.01 * np.sin(60 * u) * np.cos(47 * v) + 0.1 * np.exp(-(u * u + v * v))
    return np.stack([u, v, z], axis=1)


def sample() -> None:
    in_function = [0.0, 0]

    def timed_waves(u: np.ndarray, v: np.ndarray) -> np.ndarray:
        start = time.perf_counter()
        result = waves(u, v)
        in_function[0] += time.perf_counter() - start
        in_function[1] += len(u)
        return result

    start, used = time.perf_counter(), time.process_time()
    sampling = surfmesh.Model().add_patch("waves", timed_waves, (-1, 1), (-1, 1))
    total, used = time.perf_counter() - start, time.process_time() - used
    million = 1e6 / in_function[1]
    print(f"{sampling.evaluations} points, {sampling.samples[0]} x {sampling.samples[1]} samples, "
          f"error {sampling.error:.1e}: {total:.3f} s, of them NumPy's {in_function[0]:.3f} s")
    print(f"per million points: {million * (total - in_function[0]):.3f} s beside NumPy's "
          f"{million * in_function[0]:.3f} s; {million * used:.3f} s of processor in all")


if __name__ == "__main__":
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    compare(sys.argv[1], sys.argv[2], int(sys.argv[3]) if len(sys.argv) == 4 else 7)
    sample()
