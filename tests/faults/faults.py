#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Faults from outside while surfmesh runs: full disks, no permission, limits of files, sizes and
memory, signals, killed ranks, calls of the system that fail.

    tests/faults/faults.py PROGRAMS            about two minutes
    tests/faults/faults.py PROGRAMS --full     200 signals to each kind of output, more of the rest
    tests/faults/faults.py PROGRAMS --only signals --seed 7

PROGRAMS is the folder of surfmesh, and of surfmesh-mpi if it was built. Whatever happens, the
outputs of a run are all new or all as they were, the exit status says which, status 1 has a
message, and no temporary file is left. Only SIGKILL may leave temporary files, and come between
two outputs; each of them is whole all the same. One line for each failure, a summary last, exit
status 1 if something failed.
"""

import argparse
import collections
import contextlib
import ctypes
import json
import os
import random
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time

from scenarios import Scenario, plain_scenarios, rank_scenarios

NOBODY = 65534
# mpirun's status if a rank was killed, even after its work was done.
KILLED = 128 + signal.SIGKILL
MIB = 1 << 20


class Failures:
    def __init__(self):
        self.runs, self.states = collections.Counter(), collections.Counter()
        self.texts, self.is_quiet = [], False

    def add(self, kind, text):
        self.texts.append(f"{kind}: {text}")
        print("FAILED " + self.texts[-1], flush=True)


class Outcome:
    """How a run ended, and what it left in its folder."""

    def __init__(self, status, err, left):
        self.status, self.err, self.left = status, err, left


def start(command, folder, before=None, env=None):
    return subprocess.Popen(command, cwd=folder, stdin=subprocess.DEVNULL, env=env,
                            stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, preexec_fn=before,
                            start_new_session=True)


def finish(run, scenario, folder):
    try:
        _, err = run.communicate(timeout=120)
    except subprocess.TimeoutExpired:
        os.killpg(run.pid, signal.SIGKILL)
        run.communicate()
        return Outcome("hangs", "", scenario.left_in(folder))
    return Outcome(run.returncode, err.decode(errors="replace"), scenario.left_in(folder))


def faults_of(outcome, had_old, may_be_killed=False, is_rank_killed=False):
    """What is wrong with the end of a run, in words."""
    states, extra = outcome.left
    before, bad = "old" if had_old else "none", []
    if not set(states.values()) <= {before, "new"}:
        bad.append(f"outputs are {states}")
    if may_be_killed:
        return bad
    if len(set(states.values())) > 1:
        bad.append(f"some outputs are new: {states}")
    if extra:
        bad.append(f"files left: {extra}")
    status = outcome.status
    is_new = set(states.values()) == {"new"}
    if status == "hangs":
        bad.append("hangs")
    elif status not in (0, 1, 3) and not 128 < status < 160:
        bad.append(f"exit status {status}: {outcome.err[-200:]}")
    elif (status in (0, 3)) != is_new and not (is_new and is_rank_killed and status == KILLED):
        bad.append(f"exit status {status}, but outputs are {states}")
    elif status == 1 and "surfmesh: error: " not in outcome.err:
        bad.append(f"status 1 without a message: {outcome.err[-200:]!r}")
    return bad


class Bench:
    """Runs scenarios in folders of their own, and keeps count."""

    def __init__(self, options):
        self.options, self.r = options, random.Random(options.seed)
        self.failures = Failures()
        self.root = tempfile.mkdtemp(prefix="surfmesh-faults-")
        os.chmod(self.root, 0o755)

    def folder(self, scenario, had_old, owner=None):
        folder = tempfile.mkdtemp(dir=self.root)
        scenario.prepare(folder, had_old)
        if owner is not None:
            for root, folders, names in os.walk(folder):
                for name in [root] + [os.path.join(root, n) for n in folders + names]:
                    os.chown(name, owner, owner)
        return folder

    def judge(self, kind, scenario, outcome, had_old, what, **more):
        self.failures.runs[kind] += 1
        is_new = set(outcome.left[0].values()) == {"new"}
        after = "new" if is_new else "as before"
        self.failures.states[f"{kind}: exit {outcome.status}, {after}"] += 1
        for bad in faults_of(outcome, had_old, **more):
            self.failures.add(kind, f"{scenario.name}, {what}: {bad}")

    def run(self, kind, scenario, what, had_old=True, before=None, **more):
        folder = self.folder(scenario, had_old)
        outcome = finish(start(scenario.command, folder, before), scenario, folder)
        self.judge(kind, scenario, outcome, had_old, what, **more)
        shutil.rmtree(folder, ignore_errors=True)
        return outcome

    def close(self):
        shutil.rmtree(self.root, ignore_errors=True)


def spread(least, most, count):
    """Numbers from the least to the most, each greater than the last by the same factor."""
    return [round(least * (most / least)**(i / (count - 1))) for i in range(count)]


# ------------------------------------------------------------------------------ room on the disk
@contextlib.contextmanager
def small_disk(folder, size):
    """A file system of so many bytes on the folder. Takes the right to mount."""
    libc = ctypes.CDLL(None, use_errno=True)
    if libc.mount(b"none", folder.encode(), b"tmpfs", 0, f"size={size},mode=755".encode()) != 0:
        raise OSError(ctypes.get_errno(), "no file system may be mounted")
    try:
        yield
    finally:
        libc.umount2(folder.encode(), 2)


def full_disks(bench, scenarios):
    """A disk of any size from that of the old outputs to more than all needs."""
    count = 30 if bench.options.full else 6
    for scenario in scenarios:
        for size in spread(scenario.old_size() + 16384, 3 * scenario.new_size(), count):
            folder = tempfile.mkdtemp(dir=bench.root)
            try:
                with small_disk(folder, size):
                    scenario.prepare(folder, True)
                    outcome = finish(start(scenario.command, folder), scenario, folder)
            except OSError as error:
                if "mounted" not in str(error):
                    continue  # there is no room for the old outputs
                return print(f"skipped: full disks: {error}")
            bench.judge("full disk", scenario, outcome, True, f"{size} bytes")
            os.rmdir(folder)
    return None


def file_sizes(bench, scenarios):
    for scenario in scenarios:
        for size in spread(64, 2 * scenario.new_size(), 20 if bench.options.full else 5):
            bench.run("file size", scenario, f"at most {size} bytes", before=lambda s=size:
                      resource.setrlimit(resource.RLIMIT_FSIZE, (s, s)))


# ------------------------------------------------------------------------------ permission
def become_nobody():
    os.setgroups([])
    os.setgid(NOBODY)
    os.setuid(NOBODY)


def permissions(bench, scenarios):
    """Folders and files that may not be written, for one who is not root."""
    if os.geteuid() != 0:
        return print("skipped: permissions: only root can become somebody else")
    try:
        program = os.path.join(os.path.abspath(bench.options.programs), "surfmesh")
        subprocess.run([program, "--version"], preexec_fn=become_nobody, check=True,
                       stdout=subprocess.DEVNULL)
    except (OSError, subprocess.SubprocessError):
        return print("skipped: permissions: nobody else can run the program where it is")
    for scenario in scenarios:
        for what in ("the folder", "an old output", "both"):
            folder = bench.folder(scenario, True, NOBODY)
            if what != "an old output":
                os.chmod(folder, 0o555)
            if what != "the folder":
                for name in scenario.outputs:
                    os.chmod(os.path.join(folder, name), 0o555)
            outcome = finish(start(scenario.command, folder, become_nobody), scenario, folder)
            os.chmod(folder, 0o755)
            bench.judge("permission", scenario, outcome, True, f"without that for {what}")
        folder = bench.folder(scenario, True)  # that of root, and nobody runs
        outcome = finish(start(scenario.command, folder, become_nobody), scenario, folder)
        bench.judge("permission", scenario, outcome, True, "in the folder of another user")
    return None


# ------------------------------------------------------------------------------ limits
def open_files(bench, scenarios):
    for scenario in scenarios:
        for most in range(4, 24, 1 if bench.options.full else 4):
            bench.run("open files", scenario, f"at most {most}", before=lambda m=most:
                      resource.setrlimit(resource.RLIMIT_NOFILE, (m, m)))


def limit_memory(size):
    def before():
        resource.setrlimit(resource.RLIMIT_AS, (size, size))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    return before


def enough_memory(command, folder, least, most):
    """The least size of addresses, to 64 KiB, with which a command has exit status 0."""
    while most - least > 65536:
        middle = (least + most) // 2
        run = start(command, folder, limit_memory(middle))
        run.communicate()
        least, most = (least, middle) if run.returncode == 0 else (middle, most)
    return most


def memory(bench, scenarios):
    """From what the program takes to start, to what a run takes."""
    count = 40 if bench.options.full else 8
    for scenario in scenarios:
        folder = bench.folder(scenario, True)
        begin = enough_memory([scenario.command[0], "--version"], folder, MIB, 1024 * MIB)
        end = enough_memory(scenario.command, folder, begin, 4096 * MIB)
        for size in spread(begin, end + 8 * MIB, count):
            bench.run("memory", scenario, f"{size / MIB:.1f} MiB of {end / MIB:.1f}",
                      before=limit_memory(size))


# ------------------------------------------------------------------------------ signals
def duration(bench, scenario):
    folder = bench.folder(scenario, True)
    begin = time.monotonic()
    start(scenario.command, folder).communicate()
    return time.monotonic() - begin


def signals(bench, scenarios):
    """At any moment of a run, and a little beyond."""
    count = bench.options.signals or (200 if bench.options.full else 12)
    numbers = [signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGKILL]
    for scenario in scenarios:
        whole = duration(bench, scenario)
        for i in range(count):
            number, had_old = numbers[i % 4], bench.r.random() < 0.7
            moment = bench.r.uniform(0.005, 1.1 * whole)
            folder = bench.folder(scenario, had_old)
            run = start(scenario.command, folder)
            time.sleep(moment)
            run.send_signal(number)
            outcome = finish(run, scenario, folder)
            if outcome.status == -number and number != signal.SIGKILL and moment < 0.05:
                outcome.status = 128 + number  # before the program could catch it
            bench.judge(signal.Signals(number).name, scenario, outcome, had_old,
                        f"after {moment:.3f} of {whole:.3f} s",
                        may_be_killed=number == signal.SIGKILL)
            shutil.rmtree(folder, ignore_errors=True)


# ------------------------------------------------------------------------------ calls that fail
# brk is not among them: its errors are another value than strace makes it return.
CALLS = {"openat": "EMFILE", "write,writev,pwrite64": "ENOSPC", "read,pread64": "EIO",
         "close": "EIO", "rename,renameat,renameat2": "EACCES", "link,linkat": "EPERM",
         "mkdir,mkdirat": "EDQUOT", "mmap": "ENOMEM", "clone,clone3": "EAGAIN",
         "unlink,unlinkat": "EACCES", "chmod,fchmodat": "EPERM", "getdents64": "EIO",
         "ftruncate": "ENOSPC"}


def count_calls(bench, scenario, calls):
    """Of a whole run, and of the start of the program, in which the loader works."""
    counts = []
    for command in (scenario.command, [scenario.command[0], "--version"]):
        folder = bench.folder(scenario, True)
        log = os.path.join(bench.root, "calls")
        start(["strace", "-f", "-qq", "-o", log, "-e", f"trace={calls}", *command],
              folder).communicate()
        with open(log, encoding="utf-8", errors="replace") as file:
            counts.append(sum("(" in line and "resumed>" not in line for line in file))
    return counts


def injected(bench, scenario, calls, what, number):
    folder = bench.folder(scenario, True)
    command = ["strace", "-f", "-qq", "-o", "/dev/null", "-e", f"trace={calls}", "-e",
               f"inject={calls}:{what}:when={number}", *scenario.command]
    return finish(start(command, folder), scenario, folder)


def failing_calls(bench, scenarios):
    """Calls of the system that fail one at a time, and SIGKILL beside each that renames."""
    if not shutil.which("strace"):
        return print("skipped: failing calls: strace is not installed")
    most = 60 if bench.options.full else 3
    for scenario in scenarios:
        for calls, error in CALLS.items():
            count, first = count_calls(bench, scenario, calls)
            numbers = range(first + 1, count + 1)
            if len(numbers) > most:
                numbers = sorted(bench.r.sample(numbers, most))
            for number in numbers:
                outcome = injected(bench, scenario, calls, f"error={error}", number)
                # What cannot be removed, or of which nobody can tell what is in it, stays.
                extra = ("unlink" in calls or "getdents" in calls) and outcome.left[1]
                if extra:
                    outcome.left = (outcome.left[0], [])
                bench.judge("failing call", scenario, outcome, True, f"{error} of {calls} {number}")
        renames = "rename,renameat,renameat2,link,linkat,unlink,unlinkat"
        for number in range(1, count_calls(bench, scenario, renames)[0] + 1):
            outcome = injected(bench, scenario, renames, "signal=KILL", number)
            bench.judge("killed at a rename", scenario, outcome, True, f"at call {number}",
                        may_be_killed=True)
    return None


# ------------------------------------------------------------------------------ ranks
def children(pid):
    found = []
    with contextlib.suppress(OSError):
        for task in os.listdir(f"/proc/{pid}/task"):
            with open(f"/proc/{pid}/task/{task}/children", encoding="utf-8") as file:
                found += [int(x) for x in file.read().split()]
    return found


def killed_ranks(bench, scenarios):
    """A signal to one rank of three, at any moment."""
    count = 40 if bench.options.full else 4
    for scenario in scenarios:
        whole = duration(bench, scenario)
        for i in range(count):
            number = [signal.SIGKILL, signal.SIGKILL, signal.SIGTERM, signal.SIGINT][i % 4]
            moment, folder = bench.r.uniform(0.05, whole), bench.folder(scenario, True)
            run = start(scenario.command, folder)
            time.sleep(moment)
            ranks = children(run.pid)
            if ranks:
                with contextlib.suppress(ProcessLookupError):
                    os.kill(bench.r.choice(ranks), number)
            outcome = finish(run, scenario, folder)
            bench.judge("killed rank", scenario, outcome, True,
                        f"{signal.Signals(number).name} after {moment:.3f} of {whole:.3f} s",
                        is_rank_killed=number == signal.SIGKILL)
            shutil.rmtree(folder, ignore_errors=True)


KINDS = {"disks": full_disks, "sizes": file_sizes, "permissions": permissions, "files": open_files,
         "memory": memory, "signals": signals, "calls": failing_calls}


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", help="the folder of surfmesh and surfmesh-mpi")
    parser.add_argument("--full", action="store_true", help="all that is run at night")
    parser.add_argument("--signals", type=int, help="so many to each kind of output")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", help="one of " + ", ".join([*KINDS, "ranks"]))
    options = parser.parse_args()
    bench, begin = Bench(options), time.time()
    try:
        plain = plain_scenarios(os.path.abspath(options.programs), bench.root)
        for name, run in KINDS.items():
            if options.only in (None, name):
                run(bench, plain)
        if options.only in (None, "ranks"):
            killed_ranks(bench, rank_scenarios(os.path.abspath(options.programs), bench.root))
    finally:
        bench.close()
    print(json.dumps({"runs": dict(bench.failures.runs), "failed": len(bench.failures.texts),
                      "seconds": round(time.time() - begin),
                      "states": dict(sorted(bench.failures.states.items()))}, indent=1))
    return int(bool(bench.failures.texts))


if __name__ == "__main__":
    sys.exit(main())
