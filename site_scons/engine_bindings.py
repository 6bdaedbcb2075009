"""Provides the engine's classes to C++: bindings/ and the engine's API dump, or a built godot-cpp."""

import glob
import hashlib
import os
import shutil
import subprocess
import sys

import engine_dump
import requirements

PROFILE = "bindings/build_profile.json"
GENERATOR = "bindings/generate.py"
DESCRIPTION = "bindings/engine_api.py"


def use_godot_cpp(env):
    """Configures env for the godot-cpp in godot_cpp=DIR and returns its archive."""
    root = os.path.abspath(os.path.expanduser(env["godot_cpp"]))
    if not os.path.isfile(os.path.join(root, "include/godot_cpp/godot.hpp")):
        requirements.fail("godot_cpp={} is not a godot-cpp folder: it contains no include/godot_cpp/godot.hpp".format(env["godot_cpp"]))
    name = "libgodot-cpp.{}.{}.{}.a".format(env["platform"], env["target"], env["arch"])
    found = [path for path in (os.path.join(root, place, name) for place in ("bin", "lib", "lib64")) if os.path.isfile(path)]
    if not found:
        requirements.fail("godot_cpp={} contains no {}: build it there with scons target={}".format(root, name, env["target"]))
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
    """Generates the bindings into `output` if their inputs changed; returns all sources to compile."""
    dump = engine_dump.dump(env["godot"], os.path.join(output, "api"))
    inputs = [os.path.join(dump, name) for name in ("extension_api.json", "gdextension_interface.h")]
    digest = hashlib.sha256(os.path.basename(dump).encode())
    for path in (GENERATOR, DESCRIPTION, PROFILE):
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


def read(path):
    """The text of a file; empty if it does not exist."""
    try:
        with open(path, encoding="utf-8") as file:
            return file.read()
    except OSError:
        return ""


def write(path, text):
    """Writes a small text file."""
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
