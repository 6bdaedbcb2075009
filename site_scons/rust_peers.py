"""Builds the Rust baselines of the kernel benchmark as a static library, if cargo and its registry are available."""

import os
import subprocess

MANIFEST = "tests/bench/rust_peers/Cargo.toml"


def build(env, folder):
    """The library below `folder`; prints the reason and returns None if it cannot be built."""
    cargo = env.WhereIs("cargo")
    if not cargo:
        print("scons: cargo not found: the kernel benchmark omits glam and ultraviolet")
        return None
    # Rust's wide types are wide only where the processor is known when compiling.
    flags = "-C target-cpu=" + ("x86-64-v3" if env["arch"] == "x86_64" and _has_avx2() else "generic")
    command = [cargo, "build", "--quiet", "--release", "--manifest-path", MANIFEST, "--target-dir", folder]
    done = subprocess.run(command, env=dict(os.environ, RUSTFLAGS=flags), stderr=subprocess.PIPE, universal_newlines=True)
    if done.returncode != 0:
        lines = done.stderr.strip().splitlines() or ["no reason given"]
        print("scons: the kernel benchmark omits glam and ultraviolet, because cargo failed: " + lines[0])
        return None
    return env.File(os.path.join(folder, "release", "librust_peers.a"))


def _has_avx2():
    try:
        with open("/proc/cpuinfo", encoding="utf-8") as cpuinfo:
            return " avx2 " in cpuinfo.read()
    except OSError:
        return False
