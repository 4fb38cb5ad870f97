#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""How two builds of surfmesh compare, in processor time, memory and bytes written.

    tests/bench/against.py OLD NEW MODELS [--runs N] [CASE ...]

OLD and NEW are programs; MODELS is the folder of models that both mesh. tools/bench.sh builds them.
Each case runs once with either program unmeasured, then in N pairs (5), old and new first in turn.
Seconds are medians of processor seconds of the whole process, on one thread. The ratio is new to old,
below 1 where new needs less: the median of those of the pairs, with their middle half. Other work on
the machine changes both runs of a pair alike, so that ratios stay where seconds move; on a machine with
much of it, that of the medians of either was outside the middle half.

Exit status 0 if any case was measured, 1 if none was, 2 for wrong arguments.
"""

import argparse
import hashlib
import os
import statistics
import subprocess
import sys
import tempfile

# By name: the command line of `surfmesh mesh`, with a model as its first word. Half a second each, or
# half a million triangles.
CASES = {
    "cage": "knob.obj --size 0.25%",
    "formula": "wave.json --hmin 0.05% --hmax 0.22%",
    "nurbs": "teapot.json --hmax 0.2%",
    "curvature": "torus.obj --curvature 0.015",
    "sag": "knob.obj --sag 0.003%",
    "quads": "knob.obj --size 0.45% --quads on",
    "tiles": "torus.json --hmax 0.22% --tile 10000",
    "sizes": "sizes.json --hmin 0.01% --hmax 0.08%",
    "trimmed": "pipes.json --hmax 0.2%",
    "interpolate": "vault.obj --surface interpolate --size 0.2%",
}

# Done, and done with a shortfall.
GOOD_STATUSES = (0, 3)


class Rejected(Exception):
    """A program does not know what a case asks for."""


def run(program, case, models, output):
    """Run a case. Returns processor seconds, peak of memory in bytes, and a digest of the mesh."""
    model, *options = CASES[case].split()
    command = [program, "mesh", os.path.join(models, model), "-o", output, "--quiet", "--threads", "1",
               *options]
    with tempfile.TemporaryFile() as messages:
        process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=messages, stderr=messages)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode not in GOOD_STATUSES:
            messages.seek(0)
            lines = messages.read().decode(errors="replace").splitlines()
            raise Rejected(lines[0] if lines else f"status {process.returncode}")
    with open(output, "rb") as file:
        digest = hashlib.sha256(file.read()).hexdigest()
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss * 1024, digest


class Measured:
    """The runs of one program in a case."""

    def __init__(self, program, case, models, output):
        self.arguments = (program, case, models, output)
        self.seconds = []
        self.bytes = []
        _, _, self.digest = run(*self.arguments)
        self.is_steady = True

    def run(self):
        seconds, memory, digest = run(*self.arguments)
        # A clock of processor time has ticks: nothing takes none.
        self.seconds.append(max(seconds, 1e-3))
        self.bytes.append(memory)
        self.is_steady = self.is_steady and digest == self.digest


def measured_pairs(case, programs, models, pairs, folder):
    """Run a case in pairs. Returns what was measured of the old program and of the new one."""
    both = []
    for name, program in zip(("old", "new"), programs):
        try:
            both.append(Measured(program, case, models, os.path.join(folder, f"{name}.obj")))
        except Rejected as reason:
            raise Rejected(f"{name} rejects it: {reason}") from None
    for pair in range(pairs):
        for one in (both if pair % 2 == 0 else reversed(both)):
            one.run()
    return both


def middle_half(values):
    """The first and the third quartile."""
    if len(values) == 1:
        return values[0], values[0]
    first, _, third = statistics.quantiles(values, n=4, method="inclusive")
    return first, third


def bytes_text(old, new):
    unsteady = [name for name, one in (("old", old), ("new", new)) if not one.is_steady]
    if unsteady:
        return f"{' and '.join(unsteady)} not twice the same"
    return "same" if old.digest == new.digest else "differ"


def print_row(*cells):
    print("| " + " | ".join(cells) + " |", flush=True)


def print_case(case, old, new):
    median = statistics.median
    ratios = [b / a for a, b in zip(old.seconds, new.seconds)]
    first, third = middle_half(ratios)
    print_row(case, f"{median(old.seconds):.2f}", f"{median(new.seconds):.2f}",
              f"{median(ratios):.3f}", f"{first:.3f} to {third:.3f}",
              f"{median(new.bytes) / median(old.bytes):.3f}", bytes_text(old, new))


def count(text):
    value = int(text)
    if value < 1:
        raise argparse.ArgumentTypeError("at least 1 is needed")
    return value


def arguments():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in ("old", "new", "models"):
        parser.add_argument(name)
    parser.add_argument("--runs", type=count, default=5)
    parser.add_argument("cases", nargs="*", metavar="CASE")
    chosen = parser.parse_intermixed_args()
    unknown = [case for case in chosen.cases if case not in CASES]
    if unknown:
        parser.exit(2, f"bench: there is no case {unknown[0]}; there are {', '.join(CASES)}\n")
    return chosen


def main():
    chosen = arguments()
    print_row("case", "old s", "new s", "ratio", "middle half", "memory", "bytes")
    print_row(*["---"] * 7)
    measured = 0
    with tempfile.TemporaryDirectory() as folder:
        for case in chosen.cases or CASES:
            try:
                old, new = measured_pairs(case, (chosen.old, chosen.new), chosen.models, chosen.runs,
                                          folder)
            except (Rejected, OSError) as reason:
                print_row(case, str(reason), *[""] * 5)
                continue
            print_case(case, old, new)
            measured += 1
    return 0 if measured else 1


if __name__ == "__main__":
    sys.exit(main())
