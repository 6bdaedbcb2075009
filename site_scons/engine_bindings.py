"""Where the engine's classes come from: bindings/ and the engine's own dump, or a built godot-cpp."""

import glob
import hashlib
import json
import os
import shutil
import subprocess
import sys

import requirements

OLDEST_ENGINE = (4, 6)
PROFILE = "bindings/build_profile.json"
GENERATOR = "bindings/generate.py"


def use_godot_cpp(env):
    """Sets env up for the godot-cpp in godot_cpp=DIR and returns its archive."""
    root = os.path.abspath(os.path.expanduser(env["godot_cpp"]))
    if not os.path.isfile(os.path.join(root, "include/godot_cpp/godot.hpp")):
        requirements.fail("godot_cpp={} holds no include/godot_cpp/godot.hpp".format(env["godot_cpp"]))
    name = "libgodot-cpp.{}.{}.{}.a".format(env["platform"], env["target"], env["arch"])
    found = [path for path in (os.path.join(root, place, name) for place in ("bin", "lib", "lib64")) if os.path.isfile(path)]
    if not found:
        requirements.fail("godot_cpp={} holds no {}; build it there: scons target={}".format(root, name, env["target"]))
    for place in ("include", "gen/include"):
        path = os.path.join(root, place)
        if os.path.isdir(path):
            env.Append(CXXFLAGS=["-isystem", path])
    # Its casts are dynamic_cast, so what is built against it needs type information.
    env["CXXFLAGS"] = [flag for flag in env["CXXFLAGS"] if flag != "-fno-rtti"]
    env.Append(CPPDEFINES=["LINUX_ENABLED", "UNIX_ENABLED", "THREADS_ENABLED", "GDEXTENSION"])
    if env["target"] == "template_debug":
        # godot-cpp's default for this target; it changes the layout of its classes.
        env.Append(CPPDEFINES=["HOT_RELOAD_ENABLED"])
    archive = env.File(found[0])
    env.Append(LIBS=[archive])
    return archive


def generate(env, output):
    """Generates the bindings into output if anything they depend on changed; returns all sources to compile."""
    dump = dump_engine(env, os.path.join(output, "api"))
    inputs = [os.path.join(dump, name) for name in ("extension_api.json", "gdextension_interface.h")]
    digest = hashlib.sha256(os.path.basename(dump).encode())
    for path in (GENERATOR, PROFILE):
        with open(path, "rb") as file:
            digest.update(file.read())
    generated = os.path.join(output, "generated")
    stamp = os.path.join(generated, ".inputs")
    if read(stamp) != digest.hexdigest():
        print("Generating bindings for engine {}".format(os.path.basename(dump)), flush=True)
        fresh = generated + ".new"
        shutil.rmtree(fresh, ignore_errors=True)
        command = [sys.executable, GENERATOR, "--api", inputs[0], "--interface", inputs[1]]
        if subprocess.call(command + ["--profile", PROFILE, "--output", fresh]) != 0:
            requirements.fail("{} failed, see above".format(GENERATOR))
        write(os.path.join(fresh, ".inputs"), digest.hexdigest())
        shutil.rmtree(generated, ignore_errors=True)
        os.rename(fresh, generated)
    env.Append(CPPPATH=["bindings/include", os.path.join(generated, "include")])
    return sorted(glob.glob("bindings/src/*.cpp") + glob.glob(os.path.join(generated, "src/**/*.cpp"), recursive=True))


def dump_engine(env, output):
    """Folder with the dump of the engine's API, made once for each engine version."""
    engine = find_engine(env["godot"])
    status = os.stat(engine)
    identity = "{} {} {}".format(engine, status.st_size, status.st_mtime_ns)
    cache = os.path.join(output, "engines.json")
    known = json.loads(read(cache) or "{}")
    version = known.get(identity) or engine_version(engine)
    if version_numbers(version) < OLDEST_ENGINE:
        requirements.fail("{} is Godot {}; 4.6 or newer is needed".format(engine, version or "of an unknown version"))
    dump = os.path.join(output, version)
    if not os.path.isfile(os.path.join(dump, "extension_api.json")):
        print("Dumping the API of Godot {}".format(version), flush=True)
        fresh = os.path.abspath(dump + ".new")
        shutil.rmtree(fresh, ignore_errors=True)
        os.makedirs(fresh)
        arguments = ["--headless", "--dump-extension-api", "--dump-gdextension-interface"]
        done = subprocess.run([engine] + arguments, cwd=fresh, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        if done.returncode != 0 or len(os.listdir(fresh)) < 2:
            sys.stderr.buffer.write(done.stdout)
            requirements.fail("{} did not dump its API".format(engine))
        shutil.rmtree(dump, ignore_errors=True)
        os.rename(fresh, dump)
    if identity not in known:
        known[identity] = version
        write(cache, json.dumps(known, indent=2))
    return dump


def find_engine(option):
    """The engine: godot=, then GODOT, then PATH, then what tools/setup keeps in its cache."""
    for origin, value in (("godot=", option), ("GODOT=", os.environ.get("GODOT"))):
        if value:
            path = shutil.which(os.path.expanduser(value))
            if not path:
                requirements.fail("{}{} is no program".format(origin, value))
            return os.path.abspath(path)
    for name in ("godot", "godot4"):
        path = shutil.which(name)
        if path and version_numbers(engine_version(path)) >= OLDEST_ENGINE:
            return path
    if os.path.isfile("tools/setup"):
        done = subprocess.run(["tools/setup", "--print", "engine"], stdout=subprocess.PIPE, universal_newlines=True)
        path = done.stdout.strip().splitlines()[-1] if done.stdout.strip() else ""
        if done.returncode == 0 and os.path.isfile(path):
            return path
    requirements.fail("no Godot 4.6 or newer: run tools/setup, put godot on PATH, or give godot=PATH")


def engine_version(engine):
    """What the engine calls itself, like 4.6.3.stable.debian; empty if it does not start."""
    try:
        done = subprocess.run([engine, "--headless", "--version"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, timeout=60)
    except (OSError, subprocess.TimeoutExpired):
        return ""
    lines = done.stdout.decode(errors="replace").split()
    return lines[-1] if done.returncode == 0 and lines else ""


def version_numbers(version):
    """(major, minor) of a version text; (0, 0) if it is none."""
    parts = version.split(".")
    return (int(parts[0]), int(parts[1])) if len(parts) > 1 and parts[0].isdigit() and parts[1].isdigit() else (0, 0)


def read(path):
    """A file's text; empty if there is none."""
    try:
        with open(path, encoding="utf-8") as file:
            return file.read()
    except OSError:
        return ""


def write(path, text):
    """Writes a small text file."""
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
