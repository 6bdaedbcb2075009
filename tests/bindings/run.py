#!/usr/bin/env python3
"""Builds the sample extension against bindings/ and runs its checks in the engine.

With --godot-cpp, builds it against godot-cpp too; the same checks must pass. Prints "[bindings] N passed, N failed"
as the last line; the exit code is 0 only if all checks passed and the engine reported no error and no leak.
"""

import argparse
import os
import re
import shlex
import shutil
import subprocess
import sys
import time

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
sys.path.insert(0, os.path.join(ROOT, "tools", "lib"))

from engine_log import problems_of  # noqa: E402

RELEVANT = re.compile(r"\[expect\]|FAIL|.*ERROR|.*[Ll]eaked|.*[Oo]rphan|\s+at: ")
RESULT = re.compile(r"^\[bindings\] (\d+) passed, (\d+) failed$", re.M)


def fail(message):
    """Exits, because nothing can be checked."""
    print(f"{message}\n[bindings] 0 passed, 1 failed")
    sys.exit(1)


def run(command, **options):
    """Runs a program; returns its exit code and its output."""
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.STDOUT, "text": True, "errors": "replace"}
    done = subprocess.run(command, **pipes, **options)
    return done.returncode, done.stdout


class Sample:
    """The sample extension, built against one implementation of the bindings."""

    def __init__(self, name, folder, options):
        self.name = name
        self.folder = os.path.join(folder, name)
        self.options = options
        self.project = os.path.join(self.folder, "project")

    def build(self):
        """Builds the library, and copies it and the checks into a new project."""
        started = time.monotonic()
        command = ["scons", "-Q", "-f", "tests/bindings/sample.scons", f"output={self.folder}", *self.options]
        code, output = run(command, cwd=ROOT)
        if code != 0:
            fail(f"{self.name}: the sample does not build:\n{output}")
        shutil.rmtree(self.project, ignore_errors=True)
        shutil.copytree(os.path.join(HERE, "project"), self.project)
        library = shutil.copy(os.path.join(self.folder, "sample.so"), self.project)
        seconds, size = time.monotonic() - started, os.path.getsize(library) // 1024
        print(f"{self.name}: built in {seconds:.1f} s, {size} KiB", flush=True)

    def check(self, engine):
        """Runs the checks; returns (passed, failed)."""
        # Without this file, the first import of a project with an extension aborts.
        os.makedirs(os.path.join(self.project, ".godot"))
        with open(os.path.join(self.project, ".godot", "extension_list.cfg"), "w", encoding="utf-8") as file:
            file.write("res://sample.gdextension\n")
        code, output = self.start(engine, "--editor", "--import")
        problems = [f"the import failed with exit code {code}"] if code != 0 else []
        problems += problems_of(output)
        if problems:
            print(output)
        passed = failed = 0
        for script in ("checks.gd", "reload.gd"):
            code, output = self.start(engine, "--verbose", "--script", f"res://{script}")
            # A verbose engine lists leaks. Print only these, errors, and the lines of the checks.
            print("\n".join(line for line in output.splitlines() if RELEVANT.match(line)))
            problems += problems_of(output)
            counts = RESULT.findall(output)
            if not counts:
                print(output)
                problems.append(f"{script} did not run to its end (exit code {code})")
            passed += sum(int(count[0]) for count in counts)
            failed += sum(int(count[1]) for count in counts)
        for problem in problems:
            print(f"FAIL {self.name}: {problem}")
        print(f"{self.name}: {passed} checks passed, {failed + len(problems)} failed", flush=True)
        return passed, failed + len(problems)

    def start(self, engine, *arguments):
        """Runs the engine in the sample's project, with separate folders for data and settings."""
        places = {"XDG_DATA_HOME": self.folder, "XDG_CONFIG_HOME": self.folder}
        command = [*engine, "--headless", "--path", self.project, *arguments]
        try:
            return run(command, timeout=120, env={**os.environ, **places})
        except subprocess.TimeoutExpired as expired:
            output = expired.stdout or ""
            return 124, output if isinstance(output, str) else output.decode(errors="replace")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("engine", nargs="?", default=os.path.join(ROOT, "tools", "godot"),
                        help="command that starts the engine (default: tools/godot)")
    parser.add_argument("build_dir", nargs="?", default=os.path.join(ROOT, "build", "bindings_sample"),
                        help="build folder (default: build/bindings_sample)")
    parser.add_argument("--godot-cpp", metavar="DIR", help="a godot-cpp, to build and check the sample with it too")
    options = parser.parse_args()
    engine = shlex.split(options.engine)
    folder = os.path.abspath(options.build_dir)

    samples = [Sample("bindings", folder, [f"godot={engine[0]}"])]
    if options.godot_cpp:
        samples.append(Sample("godot-cpp", folder, [f"godot_cpp={os.path.abspath(options.godot_cpp)}"]))
    passed = failed = 0
    for sample in samples:
        sample.build()
        counts = sample.check(engine)
        passed += counts[0]
        failed += counts[1]
    print(f"[bindings] {passed} passed, {failed} failed")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
