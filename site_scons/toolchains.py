"""The systems that the library is built for, and the compiler and linker of each.

The compiler of this machine builds for this machine. Zig, a package of PyPI with clang and the C and C++ libraries of all systems,
builds for the others, and everything that users download: on Linux, its library loads with older C libraries than that of
this machine.
"""

import collections
import functools
import os
import re
import shutil
import subprocess

import requirements
from SCons.Script import Action

# One library file. `triples` are zig's names of its systems; those of macOS are merged into one file.
System = collections.namedtuple("System", "platform arch suffix triples")

# The oldest C library of Linux and the oldest macOS that the libraries load with.
GLIBC = "2.28"
MACOS = "11.0"
SYSTEMS = (
    System("linux", "x86_64", ".so", ("x86_64-linux-gnu." + GLIBC,)),
    System("linux", "arm64", ".so", ("aarch64-linux-gnu." + GLIBC,)),
    System("windows", "x86_64", ".dll", ("x86_64-windows-gnu",)),
    System("windows", "arm64", ".dll", ("aarch64-windows-gnu",)),
    System("macos", "universal", ".dylib", ("aarch64-macos." + MACOS, "x86_64-macos." + MACOS)),
)
# Platforms that Godot has and zig has no libraries for: godot-cpp and a compiler of the platform build for them.
OTHERS = {"android": ".so", "web": ".wasm"}
SUFFIXES = {**{system.platform: system.suffix for system in SYSTEMS}, **OTHERS}
# Folders of header-only libraries; zig searches none of this machine's.
HEADER_FOLDERS = ("/usr/local/include", "/usr/include", "/opt/homebrew/include", "/opt/local/include")
HEADERS = os.path.join("build", "headers")


def choose(env, wanted):
    """Checks platform and arch for the targets `wanted`, and sets arch and toolchain where they are not given."""
    platform, known = env["platform"], arches(env["platform"])
    is_host = platform == requirements.host()[0]
    if platform in OTHERS:
        # For these, users bring the compiler and godot-cpp; nothing of it was tried (docs/systems.md).
        if not os.environ.get("CXX") or not env["arch"] or not (env["godot_cpp"] or os.environ.get("GODOT_CPP")):
            requirements.fail("platform {0} needs CXX=COMPILER in the environment, arch= and godot_cpp=DIR with a godot-cpp built for {0}; "
                              "see docs/building.md".format(platform))
    elif not known:
        requirements.fail("platform {} is unknown; use {}".format(platform, ", ".join(SUFFIXES)))
    if not env["arch"]:
        env["arch"] = requirements.host()[1] if is_host else known[0]
    if known and env["arch"] not in known:
        requirements.fail("arch {} is unknown for {}; use {}".format(env["arch"], platform, ", ".join(known)))
    if not env["toolchain"]:
        is_native = platform in OTHERS or (platform, env["arch"]) == requirements.host()
        env["toolchain"] = "native" if is_native else "zig"
    if env["arch"] == "universal" and wanted - {"install", "package"}:
        requirements.fail("arch universal is for the library alone; name one of {}".format(", ".join(parts(platform, "universal"))))


def arches(platform):
    """The values of arch= for a platform: those of its libraries, and the parts of a merged one."""
    found = [system for system in SYSTEMS if system.platform == platform]
    return [system.arch for system in found] + [arch_of(triple) for system in found if len(system.triples) > 1 for triple in system.triples]


def arch_of(triple):
    """Godot's name of the processor of a triple."""
    return {"aarch64": "arm64"}.get(triple.split("-")[0], triple.split("-")[0])


def parts(platform, arch):
    """The processors whose libraries are merged into that of the platform and arch; one, except for macOS."""
    found = [system for system in SYSTEMS if (system.platform, system.arch) == (platform, arch)]
    return [arch_of(triple) for triple in found[0].triples] if found else [arch]


def triple_of(platform, arch):
    """Zig's name of a platform and a processor."""
    return next(triple for system in SYSTEMS if system.platform == platform for triple in system.triples if arch_of(triple) == arch)


def library_name(platform, arch):
    """The file of the library, as ga_godot.gdextension names it."""
    return "libga_godot.{}.{}{}".format(platform, arch, SUFFIXES[platform])


def use_zig(env, builds):
    """Makes an environment compile for its platform and processor with zig."""
    zig = find_zig() if builds else "zig"
    triple = triple_of(env["platform"], env["arch"])
    env["is_clang"] = True
    env["CXX"] = "{} c++ -target {}".format(zig, triple)
    env["ZIG"], env["TRIPLE"] = zig, triple
    # It knows the kind of a file by its suffix.
    env["SHOBJSUFFIX"] = ".o"
    env.Append(CXXFLAGS=["-isystem", link_headers()])
    if env["platform"] == "linux":
        env.Append(CPPDEFINES=["WITHOUT_START_FILES"])
    if env["platform"] == "windows":
        env["SHCXXFLAGS"] = ["$CXXFLAGS"]
        env["SHCCFLAGS"] = ["$CCFLAGS"]
        env["PROGSUFFIX"] = ".exe"


@functools.lru_cache(maxsize=None)
def find_zig():
    """Path of zig: the variable ZIG, else what tools/setup keeps in its cache."""
    if os.environ.get("ZIG"):
        return os.environ["ZIG"]
    done = subprocess.run(["tools/setup", "--print", "zig"], stdout=subprocess.PIPE, universal_newlines=True)
    if done.returncode != 0:
        requirements.fail("there is no zig, see above; the variable ZIG names another")
    return done.stdout.strip()


def link_headers():
    """A folder with links to the header-only libraries of this machine; other headers beside them are for this machine alone."""
    os.makedirs(HEADERS, exist_ok=True)
    for name, (header, _, _) in requirements.HEADERS.items():
        folders = os.environ.get("CPATH", "").split(os.pathsep) + list(HEADER_FOLDERS)
        found = next((folder for folder in folders if folder and os.path.isfile(os.path.join(folder, header))), None)
        link = os.path.join(HEADERS, name)
        if found and not os.path.exists(link):
            os.symlink(os.path.join(found, name), link)
    if not os.path.exists(os.path.join(HEADERS, "glm")):
        requirements.fail("GLM not found in {}: run tools/setup cross (Debian: apt-get install libglm-dev)".format(" or ".join(HEADER_FOLDERS)))
    return HEADERS


def link_options(env, exports):
    """Options for a library that exports the symbols in the file `exports` alone: a version script, which GNU ld and lld read."""
    if env["platform"] == "windows":
        # What is declared dllexport is exported, and nothing else. The library for linking is of no use.
        options = ["-s", "-Wl,--out-implib," + os.path.join(os.path.dirname(HEADERS), "unused.lib")]
        return options + ([] if env["toolchain"] == "zig" else ["-static"])
    if env["platform"] == "web":
        return ["-sSIDE_MODULE=1"]
    if env["platform"] == "macos":
        return ["-Wl,-dead_strip"] + ["-Wl,-exported_symbol,_" + name for name in exported(exports)]
    options = ["-Wl,--gc-sections", "-Wl,--version-script=" + exports]
    if env["toolchain"] != "zig":
        options += ["-Wl,--exclude-libs,ALL", "-static-libgcc", "-static-libstdc++"]
    return options + ([] if env["sanitize"] else ["-s", "-Wl,--no-undefined"])


def exported(exports):
    """The symbols in a version script."""
    with open(exports, encoding="utf-8") as file:
        return re.findall(r"^\s+(\w+);", file.read(), re.M)


def link_macos(target, source, env):
    """SCons action: links a library for macOS with lld. Zig's own linker exports the symbols of the C++ library too."""
    output = str(target[0])
    empty = output + ".empty.cpp"
    with open(empty, "w", encoding="utf-8") as file:
        file.write("")
    # Zig builds its C++ library, and names the files that it links.
    command = [env["ZIG"], "c++", "-v", "-target", env["TRIPLE"], "-shared", empty, "-o", output]
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True)
    archives = re.findall(r"\S+\.a(?=\s)", next((line for line in done.stdout.splitlines() if line.startswith("zig ld ")), "") + " ")
    if done.returncode != 0 or not archives:
        print(done.stdout)
        return 1
    stub = output + ".tbd"
    with open(os.path.join(os.path.dirname(env["ZIG"]), "lib", "libc", "darwin", "libSystem.tbd"), encoding="utf-8") as file:
        text = file.read()
    with open(stub, "w", encoding="utf-8") as file:
        # lld does not know this processor yet.
        file.write(re.sub(r",?\s*arm64e\.x1-\w+", "", text))
    arch = env["arch"]
    # -adhoc_codesign: processors of Apple run signed code only; the signature names no one.
    command = [llvm_tool("ld64.lld"), "-dylib", "-arch", arch, "-platform_version", "macos", MACOS, MACOS, "-dead_strip", "-x", "-S"]
    command += ["-adhoc_codesign"] + [word for name in exported(env["EXPORTS"]) for word in ("-exported_symbol", "_" + name)]
    command += ["-install_name", "@rpath/" + library_name("macos", "universal"), "-o", output]
    result = subprocess.call(command + [str(node) for node in source] + archives + [stub])
    for path in (empty, stub):
        os.remove(path)
    return result


def merge(env, target, libraries):
    """The node of a library for several processors of macOS."""

    def join(target, source, env):
        return subprocess.call([llvm_tool("llvm-lipo"), "-create", "-output", str(target[0]), *map(str, source)])

    return env.Command(target, libraries, Action(join, "Merging $TARGET"))


def llvm_tool(name):
    """Path of a tool of LLVM, with its version in its name, as on Debian, or without; tools/setup installs it if it is missing."""
    for install in (False, True):
        if install and subprocess.call(["tools/setup", "cross"]) != 0:
            break
        found = shutil.which(name + "-19") or shutil.which(name)
        if found:
            return found
    return requirements.fail("{} not found, see above".format(name))
