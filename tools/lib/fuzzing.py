"""tools/test --fuzz: runs the fuzz targets with the address and undefined-behavior sanitizers.

With clang they are programs of libFuzzer; without it, they try random edits of their corpus (tests/fuzz/standalone.cpp).
Inputs that reach new code are kept in build/fuzz/corpus/TARGET, where the next run continues; findings are written to
build/fuzz/findings. Each run is recorded in build/fuzz/runs.tsv: its end, target, executions, seconds, and "done" or "finding".
Without --fuzz, `python3 tools/lib/fuzzing.py` prints the sums of all recorded runs.
"""

import glob
import os
import re
import shutil
import subprocess
import sys
import time

import checkout
from build import build
from suite_process import Program

SANITIZERS = "address,undefined"
# Seconds for one input, and megabytes.
LIMITS = ("-timeout=20", "-rss_limit_mb=3000", "-max_len=4096", "-print_funcs=0")
ENV = {"ASAN_OPTIONS": "abort_on_error=1", "UBSAN_OPTIONS": "abort_on_error=1:print_stacktrace=1"}
# What libFuzzer prints about its progress and its dictionary.
PROGRESS = re.compile(r'^(#\d+\s|INFO: |#{6} |"\S*" # Uses: )')
EXECUTIONS = re.compile(r"^(?:#|Done )(\d+)\b")
DONE = re.compile(r"^Done \d+ runs in ")
RUNS = os.path.join(checkout.BUILD, "fuzz", "runs.tsv")


class RunRecord:
    """Counts the executions of one run of a target, and records the run when it ends."""

    def __init__(self, target):
        self._target = target
        self._executions = 0
        self._end = "finding"
        self._start = None

    def feed(self, line):
        """Reads a line of the target's output."""
        self._start = self._start or time.monotonic()
        found = EXECUTIONS.match(line)
        if found:
            self._executions = int(found.group(1))
        if DONE.match(line):
            self._end = "done"

    def end(self):
        """Records the run, if the target has started."""
        if self._start is not None:
            seconds = round(time.monotonic() - self._start)
            fields = (time.strftime("%Y-%m-%dT%H:%M:%SZ", time.gmtime()), self._target, self._executions, seconds, self._end)
            with open(RUNS, "a", encoding="utf-8") as file:
                file.write("\t".join(map(str, fields)) + "\n")


def recorded():
    """The sums of the recorded runs: {target: [executions, seconds, runs with a finding]}."""
    sums = {}
    if os.path.exists(RUNS):
        with open(RUNS, encoding="utf-8") as file:
            for line in file:
                _, target, executions, seconds, end = line.rstrip("\n").split("\t")
                total = sums.setdefault(target, [0, 0, 0])
                for index, value in enumerate((int(executions), int(seconds), int(end != "done"))):
                    total[index] += value
    return sums


def print_recorded():
    """Prints the sums of all recorded runs, one line for each target."""
    print(f"\n{'target':<16} {'executions':>12} {'hours':>7} {'findings':>9}   (all recorded runs)")
    for target, (executions, seconds, findings) in sorted(recorded().items()):
        print(f"{target:<16} {executions:>12,} {seconds / 3600:>7.2f} {findings:>9}")


def targets():
    """The names of the fuzz targets, tests/fuzz/FOLDER/TARGET.cpp."""
    paths = glob.glob(os.path.join(checkout.ROOT, "tests", "fuzz", "*", "*.cpp"))
    return sorted(os.path.splitext(os.path.basename(path))[0] for path in paths)


def corpus(target):
    """Folder of the committed corpus of a target."""
    return os.path.join(checkout.ROOT, "tests", "fuzz", "corpus", target)


def programs(seconds):
    """Builds the targets; returns a program for each that runs it for so many seconds."""
    sanitizers = make_ready()
    place = os.path.join(checkout.variant(sanitizers), "fuzz")
    return [program(os.path.join(place, target), seconds) for target in targets()]


def program(path, seconds):
    """The run of one target."""
    target = os.path.basename(path)
    grown = os.path.join(checkout.BUILD, "fuzz", "corpus", target)
    findings = os.path.join(checkout.BUILD, "fuzz", "findings", target)
    os.makedirs(grown, exist_ok=True)
    os.makedirs(findings, exist_ok=True)
    argv = [path, f"-max_total_time={seconds}", *LIMITS, f"-artifact_prefix={findings}/", grown, corpus(target)]
    symbolizer = shutil.which("llvm-symbolizer-19") or shutil.which("llvm-symbolizer")
    env = {**ENV, **({"ASAN_SYMBOLIZER_PATH": symbolizer} if symbolizer else {})}
    return Program(argv, seconds=seconds + 120, env=env, engine=False, hidden=PROGRESS, listener=RunRecord(target))


def make_ready():
    """Installs ccache and clang if possible, builds the targets, and returns the sanitizers that they are built with."""
    checkout.setup("build")
    subprocess.run([os.path.join(checkout.TOOLS, "setup"), "ccache"], check=False)
    installed = subprocess.run([os.path.join(checkout.TOOLS, "setup"), "fuzz"], check=False).returncode == 0
    compiler = find_clang() if installed else None
    sanitizers = f"fuzzer,{SANITIZERS}" if compiler else SANITIZERS
    if not compiler:
        print("fuzz: there is no clang with libFuzzer, so the targets try random edits of their corpora", file=sys.stderr)
    build("fuzz", sanitizer=sanitizers, compiler=compiler)
    return sanitizers


def find_clang():
    """The command of clang for C++, as tools/lib/system.sh finds it; None if there is none."""
    return next((name for name in ("clang++-19", "clang++") if shutil.which(name)), None)


if __name__ == "__main__":
    print_recorded()
