#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Break lines of the library at random, and see whether the tests of their folder notice.

    tests/mutation/mutate.py --count 20                 so many more mutants
    tests/mutation/mutate.py --count 20 --folders metric quad
    tests/mutation/mutate.py --list                     what has been found so far

Works on a copy of the last commit in build/mutation, with a build of its own, and goes on where it
stopped: build/mutation/results.jsonl has a line for each mutant. A mutant is *killed* if the tests
of its folder fail or take far too long, *survived* if they pass, *same* if the compiler makes the
same code of it, and *unbuilt* if it does not compile.
"""

import argparse
import collections
import hashlib
import json
import os
import random
import re
import subprocess
import sys
import time

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
WORK = os.path.join(ROOT, "build", "mutation")
COPY = os.path.join(WORK, "source")
BUILD = os.path.join(COPY, "build", "release")
RESULTS = os.path.join(WORK, "results.jsonl")
FOLDERS = ["delaunay", "metric", "control", "refine", "boundary", "assemble", "quad"]

# Each replaces one match in a line. Operators have spaces around them: templates have none.
RULES = [
    (r" < ", " <= "), (r" <= ", " < "), (r" > ", " >= "), (r" >= ", " > "),
    (r" == ", " != "), (r" != ", " == "),
    (r" \+ ", " - "), (r" - ", " + "), (r" \* ", " / "), (r" / ", " * "),
    (r" \+= ", " -= "), (r" -= ", " += "),
    (r" && ", " || "), (r" \|\| ", " && "), (r"\bif \(!", "if ("),
    (r"\bstd::min\b", "std::max"), (r"\bstd::max\b", "std::min"),
    (r"\btrue\b", "false"), (r"\bfalse\b", "true"),
    (r"(?<![\w.'])0(?![\w.'])", "1"), (r"(?<![\w.'])1(?![\w.'])", "2"),
    (r"(?<![\w.'])2(?![\w.'])", "3"), (r"(?<![\w.'])0\.5(?![\w.'])", "0.6"),
]
# A whole statement that may be left out.
STATEMENT = re.compile(r"^\s*(return|continue|break|if \(.*\) (return|continue|break).*"
                       r"|[a-z_][\w.\->\[\]]*\([^;]*\)|[^=;]* [-+*|]?= [^;]*|\+\+\w+|--\w+);$")
# Lines of which nothing is broken: they declare, include, or make the text of an error.
LEFT_ALONE = re.compile(r'^\s*(//|#|using |template|static_assert|namespace|throw |friend )|"|fmt::'
                        r"|operator")

# Tests that take so many times as long as without a mutant have run into an endless loop.
LONGEST = 10
LEAST_TIMEOUT = 30


def mutants_of(line):
    """All lines into which a line may be broken.

    >>> mutants_of("  if (a < b) return;")
    ['  if (a <= b) return;', '']
    >>> mutants_of("  x = y + 1;")
    ['  x = y - 1;', '  x = y + 2;', '']
    >>> mutants_of("std::vector<int> list;"), mutants_of("  // a + b"), mutants_of('  say("a + b");')
    ([], [], [])
    """
    if LEFT_ALONE.search(line):
        return []
    broken = []
    for pattern, text in RULES:
        for match in re.finditer(pattern, line):
            broken.append(line[: match.start()] + text + line[match.end() :])
    if STATEMENT.match(line):
        broken.append("")
    return broken


def all_mutants(folders):
    """(file, number of the line from 0, the line, the broken line) of all folders."""
    found = []
    for folder in folders:
        path = os.path.join("libsurfmesh", "surfmesh", folder)
        for name in sorted(os.listdir(os.path.join(COPY, path))):
            if not name.endswith(".cc"):
                continue
            with open(os.path.join(COPY, path, name)) as file:
                for number, line in enumerate(file.read().split("\n")):
                    for broken in mutants_of(line):
                        found.append((os.path.join(path, name), number, line, broken))
    return found


def run(command, timeout=None):
    """Exit status and output of a command in the copy; None for a timeout."""
    process = subprocess.Popen(command, cwd=COPY, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                               start_new_session=True, text=True, errors="replace")
    try:
        output, _ = process.communicate(timeout=timeout)
        return process.returncode, output
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, 9)
        process.communicate()
        return None, ""


def must(command):
    status, output = run(command)
    if status != 0:
        sys.exit(f"mutate: {' '.join(command)} failed:\n{output[-3000:]}")


def folder_of(path):
    return path.split(os.sep)[2]


class Bench:
    """The copy with its build, unbroken between two mutants."""

    def __init__(self, folders):
        self.make_copy()
        must(["cmake", "--preset", "release", "-D", "SURFMESH_BUILD_BENCH=OFF",
              "-D", "SURFMESH_UNITY_BUILD=ON",
              "-D", "SURFMESH_COMPILED_APART=" + ";".join(FOLDERS)])
        must(["cmake", "--build", BUILD, "--target"] + [f"{f}_test" for f in folders])
        self.hashes = {}  # of objects without a mutant, by source
        self.seconds = {}
        for folder in folders:
            start = time.monotonic()
            must([self.test(folder), "--gtest_brief=1"])
            self.seconds[folder] = time.monotonic() - start

    def make_copy(self):
        if not os.path.isdir(COPY):
            subprocess.run(["git", "-C", ROOT, "worktree", "prune"], check=True)
            subprocess.run(["git", "-C", ROOT, "worktree", "add", "--detach", COPY], check=True,
                           stdout=subprocess.DEVNULL)
        head = subprocess.run(["git", "-C", ROOT, "rev-parse", "HEAD"], check=True, text=True,
                              stdout=subprocess.PIPE).stdout.strip()
        must(["git", "checkout", "--quiet", "--force", "--detach", head])
        shared = os.path.join(WORK, "shared")
        if not os.path.exists(shared) and os.path.isdir(os.path.join(ROOT, "..", "shared")):
            os.symlink(os.path.realpath(os.path.join(ROOT, "..", "shared")), shared)

    @staticmethod
    def test(folder):
        return os.path.join(BUILD, "tests", f"{folder}_test")

    @staticmethod
    def object_hash(path):
        inner = os.path.relpath(path, "libsurfmesh")
        name = os.path.join(BUILD, "libsurfmesh", "CMakeFiles", "surfmesh.dir", inner + ".o")
        with open(name, "rb") as file:
            return hashlib.sha256(file.read()).hexdigest()

    def outcome(self, path, number, broken):
        """What becomes of a mutant; the file is whole again afterwards."""
        name = os.path.join(COPY, path)
        with open(name) as file:
            whole = file.read()
        self.hashes.setdefault(path, self.object_hash(path))
        lines = whole.split("\n")
        lines[number] = broken
        try:
            with open(name, "w") as file:
                file.write("\n".join(lines))
            return self.judge(folder_of(path), path)
        finally:
            with open(name, "w") as file:
                file.write(whole)

    def judge(self, folder, path):
        status, _ = run(["cmake", "--build", BUILD, "--target", f"{folder}_test"])
        if status != 0:
            return "unbuilt"
        if self.object_hash(path) == self.hashes[path]:
            return "same"
        timeout = max(LEAST_TIMEOUT, LONGEST * self.seconds[folder])
        status, _ = run([self.test(folder), "--gtest_brief=1", "--gtest_fail_fast"], timeout)
        return "survived" if status == 0 else "killed"


def read_results():
    if not os.path.exists(RESULTS):
        return []
    with open(RESULTS) as file:
        return [json.loads(line) for line in file]


def print_results(results):
    for result in results:
        if result["outcome"] == "survived":
            print(f"{result['file']}:{result['line']}\n  - {result['before'].strip()}\n"
                  f"  + {result['after'].strip()}")
    counts = collections.Counter((folder_of(r["file"]), r["outcome"]) for r in results)
    print(f"{'folder':12}{'killed':>10}{'survived':>10}{'same':>10}{'unbuilt':>10}")
    for folder in sorted({folder for folder, _ in counts}):
        print(f"{folder:12}" + "".join(f"{counts[folder, outcome]:>10}"
                                       for outcome in ("killed", "survived", "same", "unbuilt")))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--count", type=int, default=0, help="mutants that are built and tested")
    parser.add_argument("--folders", nargs="+", default=FOLDERS, choices=FOLDERS)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--list", action="store_true", help="only print what has been found")
    arguments = parser.parse_args()
    results = read_results()
    if arguments.list:
        return print_results(results)
    os.makedirs(WORK, exist_ok=True)
    bench = Bench(arguments.folders)
    known = {(r["file"], r["before"], r["after"]) for r in results}
    # The same number of each folder, whatever their sizes.
    by_folder = collections.defaultdict(list)
    for mutant in all_mutants(arguments.folders):
        by_folder[folder_of(mutant[0])].append(mutant)
    for folder in arguments.folders:
        random.Random(f"{arguments.seed} {folder}").shuffle(by_folder[folder])
    tested = 0
    while tested < arguments.count and any(by_folder.values()):
        for folder in arguments.folders:
            if tested >= arguments.count or not by_folder[folder]:
                continue
            path, number, line, broken = by_folder[folder].pop()
            if (path, line, broken) in known:
                continue
            outcome = bench.outcome(path, number, broken)
            results.append({"file": path, "line": number + 1, "before": line, "after": broken,
                            "outcome": outcome})
            with open(RESULTS, "a") as file:
                file.write(json.dumps(results[-1]) + "\n")
            tested += outcome in ("killed", "survived")
            print(f"{outcome:9}{path}:{number + 1}", flush=True)
    print_results(results)


if __name__ == "__main__":
    main()
