#!/usr/bin/env python3
"""Builds the sample extension against bindings/ and runs its checks in the engine.

With --godot-cpp, builds it against godot-cpp too; the same checks must pass. Prints "[bindings] N passed, N failed"
as the last line; the exit code is 0 only if all checks passed and the engine reported no error and no leak.
"""

import argparse
import concurrent.futures
import glob
import hashlib
import os
import re
import shlex
import shutil
import subprocess
import sys
import time

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
BINDINGS = os.path.join(ROOT, "bindings")
sys.path.insert(0, os.path.join(ROOT, "tools", "lib"))

from engine_log import problems_of  # noqa: E402

FLAGS = ["-std=c++17", "-O1", "-fPIC", "-fno-exceptions", "-fno-gnu-unique", "-Wall", "-Wextra", "-Werror"]
FLAGS += ["-fvisibility=hidden", "-fvisibility-inlines-hidden"]
LINK_FLAGS = ["-shared", "-static-libgcc", "-static-libstdc++", "-Wl,--exclude-libs,ALL", "-Wl,--no-undefined"]
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

    def __init__(self, name, folder, flags, libraries):
        self.name = name
        self.folder = os.path.join(folder, name)
        self.flags = FLAGS + flags
        self.libraries = libraries
        self.sources = sorted(glob.glob(os.path.join(HERE, "sample", "*.cpp")))
        self.headers = glob.glob(os.path.join(HERE, "sample", "*.hpp"))
        self.project = os.path.join(self.folder, "project")

    def build(self):
        """Compiles changed sources, and links."""
        started = time.monotonic()
        compiler = os.environ.get("CXX", "g++")
        headers = digest(self.headers, " ".join([compiler] + self.flags))
        objects = os.path.join(self.folder, "objects")
        os.makedirs(objects, exist_ok=True)
        jobs = []
        for source in self.sources:
            target = os.path.join(objects, f"{digest([source], headers)[:16]}.{os.path.basename(source)}.o")
            jobs.append((source, target))
        stale = [job for job in jobs if not os.path.exists(job[1])]
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count() or 1) as pool:
            results = pool.map(lambda job: run([compiler, *self.flags, "-c", job[0], "-o", job[1]]), stale)
            for (source, _), (code, output) in zip(stale, results):
                if code != 0:
                    fail(f"{self.name}: {os.path.relpath(source, ROOT)} does not compile:\n{output}")
        for old in set(glob.glob(os.path.join(objects, "*.o"))) - {target for _, target in jobs}:
            os.remove(old)
        shutil.rmtree(self.project, ignore_errors=True)
        shutil.copytree(os.path.join(HERE, "project"), self.project)
        exports = os.path.join(self.folder, "exports.map")
        with open(exports, "w", encoding="utf-8") as file:
            file.write("{ global: sample_init; local: *; };\n")
        library = os.path.join(self.project, "sample.so")
        inputs = [f"-Wl,--version-script={exports}", *(target for _, target in jobs), *self.libraries]
        code, output = run([compiler, *LINK_FLAGS, *inputs, "-o", library])
        if code != 0:
            fail(f"{self.name}: the sample does not link:\n{output}")
        seconds, size = time.monotonic() - started, os.path.getsize(library) // 1024
        print(f"{self.name}: {len(stale)} of {len(jobs)} files compiled in {seconds:.1f} s, {size} KiB", flush=True)

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


def digest(paths, start=""):
    """A hash of `start` and the contents of the files."""
    found = hashlib.sha256(start.encode())
    for path in sorted(paths):
        with open(path, "rb") as file:
            found.update(file.read())
    return found.hexdigest()


def generate(engine, folder):
    """Dumps the engine's API description, generates the bindings from it, and returns their folder."""
    dump = os.path.join(folder, "api")
    shutil.rmtree(dump, ignore_errors=True)
    os.makedirs(dump)
    code, output = run([*engine, "--headless", "--dump-extension-api", "--dump-gdextension-interface"], cwd=dump)
    if code != 0:
        fail(f"the engine did not dump its API (exit code {code}):\n{output}")
    generated = os.path.join(folder, "generated")
    code, output = run([
        sys.executable, os.path.join(BINDINGS, "generate.py"), "--output", generated,
        "--api", os.path.join(dump, "extension_api.json"),
        "--interface", os.path.join(dump, "gdextension_interface.h"),
        "--profile", os.path.join(BINDINGS, "build_profile.json"),
    ])
    if code != 0:
        fail(output)
    return generated


def against_bindings(engine, folder):
    generated = generate(engine, folder)
    includes = [os.path.join(BINDINGS, "include"), os.path.join(generated, "include")]
    sample = Sample("bindings", folder, ["-fno-rtti"] + [f"-I{include}" for include in includes], [])
    for place in (BINDINGS, generated):
        sample.sources += sorted(glob.glob(os.path.join(place, "src", "*.cpp")))
    for include in includes:
        sample.headers += glob.glob(os.path.join(include, "**", "*.h*"), recursive=True)
    return sample


def against_godot_cpp(folder, godot_cpp):
    libraries = glob.glob(os.path.join(godot_cpp, "bin", "libgodot-cpp.*template_debug*.a"))
    if not libraries:
        fail(f"{godot_cpp} contains no built godot-cpp: bin/libgodot-cpp.*template_debug*.a does not exist; build it there with scons")
    # godot-cpp's casts need RTTI. HOT_RELOAD_ENABLED, its default in debug builds, changes its classes.
    flags = [f"-D{name}_ENABLED" for name in ("DEBUG", "HOT_RELOAD", "THREADS", "LINUX", "UNIX")]
    flags += [f"-isystem{os.path.join(godot_cpp, include)}" for include in ("include", "gen/include")]
    return Sample("godot-cpp", folder, flags, libraries)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("engine", nargs="?", default=os.path.join(ROOT, "tools", "godot"),
                        help="command that starts the engine (default: tools/godot)")
    parser.add_argument("build_dir", nargs="?", default=os.path.join(ROOT, "build", "bindings_sample"),
                        help="build folder (default: build/bindings_sample)")
    parser.add_argument("--godot-cpp", metavar="DIR", help="a built godot-cpp, to build and check the sample against it too")
    options = parser.parse_args()
    engine = shlex.split(options.engine)
    folder = os.path.abspath(options.build_dir)

    samples = [against_bindings(engine, folder)]
    if options.godot_cpp:
        samples.append(against_godot_cpp(folder, os.path.abspath(options.godot_cpp)))
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
