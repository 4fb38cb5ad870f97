# SPDX-License-Identifier: BSD-3-Clause
"""What is run while faults come from outside: commands, their outputs, and what these hold."""

import json
import os
import shutil
import subprocess

MODELS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "models")
ROOT_RANKS = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
              "OMPI_MCA_rmaps_base_oversubscribe": "1"}


def content(path):
    """What an output holds. Of a report, what does not depend on the clock."""
    if os.path.isdir(path):
        return {name: content(os.path.join(path, name)) for name in sorted(os.listdir(path))}
    with open(path, "rb") as file:
        found = file.read()
    if not path.endswith(".json"):
        return found
    report = json.loads(found)
    return json.dumps([report["mesh"], report["quality"], report["given"]]).encode()


def size_of(found):
    return sum(map(size_of, found.values())) if isinstance(found, dict) else len(found)


class Scenario:
    """A command with its outputs, as an older run left them and as a new one makes them."""

    def __init__(self, name, command, outputs, sizes, root):
        """`sizes` are the options of the older and of the newer run."""
        self.name, self.outputs = name, outputs
        self.old, self.new = os.path.join(root, name + ".old"), os.path.join(root, name + ".new")
        self.contents = {}
        for folder, size in ((self.old, sizes[0]), (self.new, sizes[1])):
            os.makedirs(folder)
            shutil.copy(os.path.join(MODELS, "wave.json"), folder)
            subprocess.run(command + size, cwd=folder, check=True, env=os.environ | ROOT_RANKS,
                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            self.contents[folder] = {n: content(os.path.join(folder, n)) for n in outputs}
        self.command = command + sizes[1]
        os.environ.update(ROOT_RANKS)

    def prepare(self, folder, had_old):
        if had_old:
            shutil.copytree(self.old, folder, dirs_exist_ok=True)
        else:
            shutil.copy(os.path.join(MODELS, "wave.json"), folder)

    def left_in(self, folder):
        """The state of each output, and files that do not belong there."""
        states = {name: self.state(folder, name) for name in self.outputs}
        extra = sorted(set(os.listdir(folder)) - set(self.outputs) - {"wave.json"})
        return states, extra

    def state(self, folder, name):
        path = os.path.join(folder, name)
        if not os.path.exists(path):
            return "none"
        try:
            found = content(path)
        except ValueError:
            return "broken"
        for state, known in (("new", self.new), ("old", self.old)):
            if found == self.contents[known][name]:
                return state
        return "broken"

    def old_size(self):
        return size_of(self.contents[self.old])

    def new_size(self):
        return size_of(self.contents[self.new])


def plain_scenarios(programs, root):
    mesh = [os.path.join(programs, "surfmesh"), "mesh", "wave.json", "--quiet", "--threads", "2"]
    sizes = (["--hmax", "4%"], ["--hmax", "0.6%", "--hmin", "0.3%"])
    return [
        Scenario("mesh", mesh + ["-o", "out.obj", "--report", "r.json"], ["out.obj", "r.json"],
                 sizes, root),
        Scenario("companion", mesh + ["-o", "out.mesh", "--report", "r.json"],
                 ["out.mesh", "out.sol", "r.json"], sizes, root),
        Scenario("pieces", mesh + ["--pieces", "out", "--report", "r.json", "--tile", "2000",
                                   "--piece-count", "4"], ["out", "r.json"], sizes, root)]


def rank_scenarios(programs, root):
    program = os.path.join(programs, "surfmesh-mpi")
    if not os.path.exists(program) or not shutil.which("mpirun"):
        print("skipped: killed ranks: there is no surfmesh-mpi")
        return []
    mesh = ["mpirun", "-n", "3", program, "mesh", "wave.json", "--quiet", "--threads", "1",
            "--tile", "2000"]
    sizes = (["--hmax", "4%"], ["--hmax", "0.6%", "--hmin", "0.3%"])
    return [
        Scenario("ranks", mesh + ["-o", "out.obj", "--report", "r.json"], ["out.obj", "r.json"],
                 sizes, root),
        Scenario("ranks of pieces", mesh + ["--pieces", "out", "--report", "r.json"],
                 ["out", "r.json"], sizes, root)]
