"""tools/test --fuzz: runs the fuzz targets with the address and undefined-behavior sanitizers.

With clang they are programs of libFuzzer; without it, they try random edits of their corpus (tests/fuzz/standalone.cpp).
Inputs that reach new code are kept in build/fuzz/corpus/TARGET, where the next run continues; findings are written to
build/fuzz/findings.
"""

import glob
import os
import re
import shutil
import subprocess
import sys

import checkout
from build import build
from suite_process import Program

SANITIZERS = "address,undefined"
# Seconds for one input, and megabytes.
LIMITS = ("-timeout=20", "-rss_limit_mb=3000", "-max_len=4096", "-print_funcs=0")
ENV = {"ASAN_OPTIONS": "abort_on_error=1", "UBSAN_OPTIONS": "abort_on_error=1:print_stacktrace=1"}
# What libFuzzer prints about its progress and its dictionary.
PROGRESS = re.compile(r'^(#\d+\s|INFO: |#{6} |"\S*" # Uses: )')


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
    return Program(argv, seconds=seconds + 120, env=env, engine=False, hidden=PROGRESS)


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
