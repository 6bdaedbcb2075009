"""What a build needs from the machine; a missing dependency ends the build with one line that says how to install it."""

import os
import platform
import subprocess
import sys

try:
    import fcntl
except ImportError:  # Windows
    fcntl = None

HEADERS = {
    "glm": ("glm/glm.hpp", "GLM", "libglm-dev"),
    "doctest": ("doctest/doctest.h", "doctest", "doctest-dev"),
    "benchmark": ("benchmark/benchmark.h", "Google Benchmark", "libbenchmark-dev"),
}
OLDEST_GCC = 9
SANITIZERS = ("address", "undefined", "thread", "fuzzer")
_lock = None


def fail(message):
    """Ends the build with one line and exit code 2."""
    sys.stderr.write("scons: error: " + message + "\n")
    sys.stderr.flush()
    sys.exit(2)


def hold_build_lock(path):
    """Makes builds in one checkout wait for each other: they share SCons' database."""
    global _lock
    os.makedirs(os.path.dirname(path), exist_ok=True)
    if fcntl is None:
        return
    _lock = open(path, "w")
    try:
        fcntl.flock(_lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        print("scons: another build runs in this checkout, waiting for it ...", flush=True)
        fcntl.flock(_lock, fcntl.LOCK_EX)


def host():
    """Platform and architecture of this machine, by Godot's names."""
    system = platform.system().lower()
    machine = platform.machine().lower()
    return (
        {"darwin": "macos"}.get(system, system),
        {"amd64": "x86_64", "aarch64": "arm64"}.get(machine, machine),
    )


def check_options(env, options):
    """Rejects unknown options and sanitizers."""
    unknown = options.UnknownVariables()
    if unknown:
        fail("unknown option {}; `scons -h` lists the options".format(", ".join(sorted(unknown))))
    if env["sanitize"] in ("none", "no"):
        env["sanitize"] = ""
    unknown = [name for name in env["sanitize"].split(",") if name and name not in SANITIZERS]
    if unknown:
        fail("sanitize={} is unknown; use {} or several of them, separated by commas".format(",".join(unknown), ", ".join(SANITIZERS)))


def check_compiler(env, doctest, benchmark):
    """Checks the compiler, its version and the needed headers in one run of the preprocessor; sets env["is_clang"]."""
    needed = ["glm"] + ["doctest"] * doctest + ["benchmark"] * benchmark
    probe = "gcc_version __GNUC__\n#ifdef __clang__\nis_clang\n#endif\n"
    for key in needed:
        probe += "#if __has_include(<{}>)\nhas_{}\n#endif\n".format(HEADERS[key][0], key)
    command = env["CXX"].split() + ["-std=c++17", "-E", "-P", "-x", "c++", "-"]
    try:
        done = subprocess.run(command, input=probe, stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True)
    except OSError:
        fail("no C++ compiler ({}): install g++ (Debian: apt-get install g++) or set CXX".format(env["CXX"]))
    if done.returncode != 0:
        fail("{} does not work as a C++17 compiler; install g++ {} or newer".format(env["CXX"], OLDEST_GCC))
    words = done.stdout.split()
    env["is_clang"] = "is_clang" in words
    if not env["is_clang"] and int(words[words.index("gcc_version") + 1]) < OLDEST_GCC:
        fail("{} is too old; install g++ {} or newer".format(env["CXX"], OLDEST_GCC))
    if "fuzzer" in env["sanitize"].split(",") and not env["is_clang"]:
        fail("sanitize=fuzzer needs clang: set CXX=clang++, or leave fuzzer out to build the fuzz targets without libFuzzer")
    for key in needed:
        if "has_" + key not in words:
            header, name, package = HEADERS[key]
            fail("{} ({}) not found: install it (Debian: apt-get install {})".format(name, header, package))
