#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A soak: random small models of formulas, NURBS, trims and cages, meshed in triangles, quads,
tiles and pieces, written in all formats, and judged by code that shares nothing with surfmesh.

    tests/soak/soak.py PROGRAM --runs 2000 --seed 1     so many models
    tests/soak/soak.py PROGRAM --minutes 20             as many as fit
    tests/soak/soak.py PROGRAM --case 1:17 --write DIR  one of them again, its files kept
    tests/soak/soak.py PROGRAM --runs 200 --threads 1,2,3,8   the bytes for each number of threads

The same seed makes the same models. Each run may take --seconds of the processor, of which other
work on the machine takes nothing away. There is one JSON line for each failure, a summary last, and
exit status 1 if something failed.

  meshed     exit status 0, and nothing found wrong
  shortfall  exit status 3 with a reason; what was made is a mesh of its model all the same
  failed     crash, timeout, no message, a file too many, a sound model refused, or a wrong mesh
"""

import argparse
import collections
import filecmp
import json
import os
import re
import shutil
import sys
import tempfile
import time

import cases
from rounds import ASK, Fault
from runner import Runner


def output_args(case, stem):
    if case.output == "pieces":
        return ["--pieces", stem]
    return ["-o", f"{stem}.{case.ending}"]


def mesh_args(case, stem, threads):
    return ["mesh", case.main, *output_args(case, stem), "--threads", str(threads), *case.args,
            *case.model_args]


def files_in(folder):
    found = set()
    for root, folders, names in os.walk(folder):
        found |= {os.path.relpath(os.path.join(root, n), folder) for n in names}
        found |= {os.path.relpath(os.path.join(root, n), folder) for n in folders}
    return found


def expect_only(case, folder, before):
    """Nothing is there but the inputs, the output and the report."""
    allowed = before | {"report.json"}
    allowed.add("out" if case.output == "pieces" else f"out.{case.ending}")
    left = sorted(n for n in files_in(folder) - allowed
                  if not re.fullmatch(r"out/out(\.pvtu|_\d{4}\.vtu)", n))
    if left:
        raise Fault(f"files left: {left}")


def expect_sound_ending(case, result, folder, before):
    """The exit status has its message, and its files."""
    if result.status == "timeout":
        raise Fault("timeout of mesh")
    if result.status not in (0, 1, 2, 3):
        raise Fault(f"crash: exit {result.status}: {result.err.strip()[-300:]}")
    expect_only(case, folder, before)
    if result.status in (1, 2):
        if files_in(folder) - before:
            raise Fault("refused, but files are there")
        if not re.search(r"surfmesh: error: .{8}", result.err):
            raise Fault("refused without a message")
        raise Fault("sound model refused: " + result.err.strip()[-300:])
    if result.status == 3 and not result.err.strip():
        raise Fault("exit 3 without a reason")


def same_bytes(a, b):
    if not os.path.isdir(a):
        return filecmp.cmp(a, b, shallow=False)
    # The names of pieces begin with that of their folder.
    names = [sorted(os.listdir(folder)) for folder in (a, b)]
    pairs = [(x, y) for x, y in zip(*names) if x.endswith(".vtu")]
    return len(names[0]) == len(names[1]) and all(
        filecmp.cmp(os.path.join(a, x), os.path.join(b, y), shallow=False) for x, y in pairs)


def expect_same_bytes(case, run, folder, threads):
    name = "out" if case.output == "pieces" else f"out.{case.ending}"
    for count in threads:
        result = run(mesh_args(case, f"of_{count}", count), folder)
        if result.status not in (0, 3):
            raise Fault(f"{count} threads: exit {result.status}: {result.err.strip()[-300:]}")
        other = name.replace("out", f"of_{count}", 1)
        if not same_bytes(os.path.join(folder, name), os.path.join(folder, other)):
            raise Fault(f"other bytes with {count} threads")


def attempt(case, run, folder, threads):
    """Returns what became of a case, the kind of its failure or shortfall, and details."""
    for name, text in case.files.items():
        with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
            file.write(text)
    before = files_in(folder)
    args = mesh_args(case, "out", 1)
    result = run([*args, "--report", "report.json"], folder)
    details = {"command": "surfmesh " + " ".join(args), "status": result.status,
               "seconds": round(result.seconds, 2)}
    try:
        expect_sound_ending(case, result, folder, before)
        mesh = ASK[case.output](case, run, folder, result.status == 0)
        details["faces"] = mesh.counts()[1]
        expect_same_bytes(case, run, folder, [n for n in threads if n != 1])
    except Fault as fault:
        return "failed", str(fault), details
    except Exception as error:  # a file that our readers cannot read is a failure of the program's
        return "failed", f"{type(error).__name__}: {error}", details
    if result.status == 3:
        return "shortfall", reason_of(result.err), details
    return "meshed", "", details


def reason_of(text):
    """What a run says it has not reached, or else its last line."""
    lines = text.strip().splitlines()
    return next((line for line in lines if "not reached" in line), lines[-1])[:300]


def kind_of(text):
    """A text without its names and figures, to count kinds."""
    line = text.strip().splitlines()[0] if text.strip() else ""
    line = re.sub(r"'[^']*'|\"[^\"]*\"|\S+\.(json|obj|csv)\S*", "*", line)
    return re.sub(r"[-+]?\d[\d.,]*(e[-+]?\d+)?", "#", line)[:160]


class Summary:
    def __init__(self):
        self.counts, self.families = collections.Counter(), collections.Counter()
        self.kinds, self.slowest = collections.defaultdict(list), (0.0, None)
        self.faces = 0

    def add(self, case, state, kind, details):
        self.counts[state] += 1
        shape = "quads" if case.quads else "triangles"
        self.families[f"{case.family}, {case.output} of {shape}: {state}"] += 1
        self.slowest = max(self.slowest, (details["seconds"], case.name))
        self.faces += details.get("faces", 0)
        if state != "meshed":
            self.kinds[f"{state}: {kind_of(kind)}"].append(case.name)

    def text(self, seconds):
        kinds = sorted(self.kinds.items(), key=lambda k: -len(k[1]))
        return json.dumps({
            "runs": sum(self.counts.values()),
            **{k: self.counts[k] for k in ("meshed", "shortfall", "failed")}, "faces": self.faces,
            "slowest": {"seconds": self.slowest[0], "case": self.slowest[1]},
            "by_the_clock": round(seconds),
            "kinds": {k: {"count": len(v), "first": v[:5]} for k, v in kinds},
            "families": dict(sorted(self.families.items()))}, indent=1, ensure_ascii=False)


def run_one(name, run, options):
    case = cases.make_case(*map(int, name.split(":")))
    folder = options.write or tempfile.mkdtemp(prefix="surfmesh-soak-")
    os.makedirs(folder, exist_ok=True)
    try:
        return case, *attempt(case, run, folder, options.threads)
    finally:
        if not options.write:
            shutil.rmtree(folder, ignore_errors=True)


def line_of(case, state, kind, details):
    return json.dumps({"case": case.name, "family": case.family, "output": case.output,
                       "state": state, "kind": kind, **details}, ensure_ascii=False)


def parse():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--runs", type=int, default=10**9, help="how many models")
    parser.add_argument("--minutes", type=float, default=20, help="by the clock, at most")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--start", type=int, default=0, help="number of the first model")
    parser.add_argument("--threads", default="1",
                        type=lambda text: [int(n) for n in text.split(",")],
                        help="numbers of threads whose bytes are compared, such as 1,2,3,8")
    parser.add_argument("--seconds", type=float, default=30, help="of the processor for a run")
    parser.add_argument("--memory", type=int, default=4000, help="MiB of addresses, 0 for any")
    parser.add_argument("--log", help="file for one JSON line a model")
    parser.add_argument("--case", help="SEED:NUMBER, only this one")
    parser.add_argument("--write", help="with --case: keep its files in this folder")
    return parser.parse_args()


def main():
    options = parse()
    run = Runner(os.path.abspath(options.program), options.seconds, options.memory)
    if options.case:
        found = run_one(options.case, run, options)
        print(line_of(*found))
        return int(found[1] == "failed")
    options.write = None
    start, summary = time.time(), Summary()
    for i in range(options.start, options.start + options.runs):
        if time.time() - start > 60 * options.minutes:
            break
        found = run_one(f"{options.seed}:{i}", run, options)
        summary.add(*found)
        if options.log:
            with open(options.log, "a", encoding="utf-8") as log:
                log.write(line_of(*found) + "\n")
        if found[1] == "failed":
            print(line_of(*found), flush=True)
    print(summary.text(time.time() - start))
    return int(summary.counts["failed"] > 0)


if __name__ == "__main__":
    sys.exit(main())
