# SPDX-License-Identifier: BSD-3-Clause
"""Runs of the program with limits."""

import dataclasses
import math
import resource
import signal
import subprocess


@dataclasses.dataclass
class Result:
    status: object  # exit status, minus the signal that ended it, or "timeout"
    out: str
    err: str
    seconds: float  # of the processor


class Runner:
    """Runs a program for `seconds` of the processor and in `memory` MiB of addresses at most."""

    def __init__(self, program, seconds, memory):
        self.program, self.seconds, self.memory = program, seconds, memory

    def limit(self):
        whole = math.ceil(self.seconds)
        resource.setrlimit(resource.RLIMIT_CPU, (whole, whole + 1))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        if self.memory:
            resource.setrlimit(resource.RLIMIT_AS, (self.memory << 20, self.memory << 20))

    def __call__(self, args, folder):
        def spent():
            usage = resource.getrusage(resource.RUSAGE_CHILDREN)
            return usage.ru_utime + usage.ru_stime
        before = spent()
        with subprocess.Popen([self.program, *args], cwd=folder, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              preexec_fn=self.limit) as run:
            try:
                # Waiting, as for a lock, takes no time of the processor.
                out, err = run.communicate(timeout=20 * self.seconds)
            except subprocess.TimeoutExpired:
                run.kill()
                out, err = run.communicate()
        status = run.returncode
        if status in (-signal.SIGXCPU, -signal.SIGKILL):
            status = "timeout"
        return Result(status, out.decode(errors="replace"), err.decode(errors="replace"),
                      spent() - before)
