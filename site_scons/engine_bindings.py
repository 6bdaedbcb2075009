"""Provides the engine's classes to C++: godot-cpp where there is one, else bindings/ and the engine's API dump."""

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
# The API that a godot-cpp is built with. bindings/ does without what is not in older ones; godot-cpp does not declare it.
GODOT_CPP_API = "4.5"
# A file that every godot-cpp has.
HEADER = "include/godot_cpp/godot.hpp"


def find_godot_cpp(option, environment, checkout="."):
    """The folder of the godot-cpp to use and what selected it, or None and why bindings/ is used.

    The first of: godot_cpp=DIR (`option`), the variable GODOT_CPP of `environment`, and a folder godot-cpp inside or beside the
    checkout. godot_cpp=no selects bindings/.
    """
    if option in ("no", "none"):
        return None, "godot_cpp=" + option
    if option:
        return godot_cpp_folder(option, "godot_cpp=" + option), "godot_cpp=" + option
    if environment.get("GODOT_CPP"):
        source = "GODOT_CPP=" + environment["GODOT_CPP"]
        return godot_cpp_folder(environment["GODOT_CPP"], source), source
    for place in ("godot-cpp", os.path.join("..", "godot-cpp")):
        root = os.path.join(os.path.abspath(checkout), place)
        if is_godot_cpp(root):
            return os.path.normpath(root), "the folder " + place
        # git makes an empty folder of a submodule that is not checked out.
        if os.path.isdir(root) and not os.listdir(root):
            return None, "the folder {} is empty: run git submodule update --init".format(place)
    return None, "no godot-cpp found; see CONTRIBUTING.md"


def godot_cpp_folder(path, source):
    """The absolute path of a named godot-cpp; fails if it is none."""
    root = os.path.abspath(os.path.expanduser(path))
    if not is_godot_cpp(root):
        requirements.fail("{} is not a godot-cpp folder: it contains no {}".format(source, HEADER))
    return root


def is_godot_cpp(root):
    """True for a checkout of godot-cpp, built or not, and for an installed one."""
    return os.path.isfile(os.path.join(root, HEADER))


def describe(root, source):
    """The line that says which bindings a build uses."""
    return "Bindings: {} ({})".format("godot-cpp in " + root if root else "bindings/", source)


def use_godot_cpp(env, root, builds):
    """Configures env for the godot-cpp in the folder `root`, and returns its archive, which is built if it does not exist."""
    end = ".nothreads.a" if env["platform"] == "web" else ".a"
    name = "libgodot-cpp.{}.{}.{}{}".format(env["platform"], env["target"], env["arch"], end)
    found = [path for path in (os.path.join(root, place, name) for place in ("bin", "lib", "lib64")) if os.path.isfile(path)]
    if not found and env["toolchain"] == "zig":
        requirements.fail("{} contains no {}: build it there, or use bindings/ with godot_cpp=no".format(root, name))
    if not found:
        found = [os.path.join(root, "bin", name)]
        if builds:
            build_godot_cpp(env, root, found[0])
    for place in ("include", "gen/include"):
        path = os.path.join(root, place)
        if os.path.isdir(path):
            env.Append(CXXFLAGS=["-isystem", path])
    # Its casts are dynamic_cast, so what is built against it needs type information.
    env["CXXFLAGS"] = [flag for flag in env["CXXFLAGS"] if flag != "-fno-rtti"]
    system = [env["platform"].upper() + "_ENABLED"] + ([] if env["platform"] == "windows" else ["UNIX_ENABLED"])
    env.Append(CPPDEFINES=system + ["GDEXTENSION"] + ([] if env["platform"] == "web" else ["THREADS_ENABLED"]))
    if env["target"] == "template_debug":
        # godot-cpp's default for this target; it changes the layout of its classes.
        env.Append(CPPDEFINES=["HOT_RELOAD_ENABLED"])
    archive = env.File(found[0])
    env.Append(LIBS=[archive])
    return archive


def build_godot_cpp(env, root, archive):
    """Builds the classes of the build profile in a checkout of godot-cpp."""
    if not os.path.isfile(os.path.join(root, "SConstruct")):
        requirements.fail("{} contains no {} and no SConstruct to build it with".format(root, os.path.basename(archive)))
    print("Building godot-cpp in {}".format(root), flush=True)
    options = ["{}={}".format(name, env[name]) for name in ("platform", "target", "arch")]
    # Versions of godot-cpp before 10 have one API, and ignore api_version.
    options += ["build_profile=" + os.path.abspath(PROFILE), "api_version=" + GODOT_CPP_API]
    command = [sys.executable, "-m", "SCons", "-Q", "-C", root, "-j", str(os.cpu_count() or 1)]
    if subprocess.call(command + options) != 0 or not os.path.isfile(archive):
        requirements.fail("building godot-cpp in {} failed, see above".format(root))


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
