"""Checks of the archive for users: its files, its pages, its versions, its checksum and its examples."""

import hashlib
import os
import re
import subprocess
import sys
import tempfile
import zipfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(ROOT, "site_scons"))
sys.path.insert(0, os.path.join(ROOT, "tools", "lib"))

import addon_files  # noqa: E402
import checkout  # noqa: E402
import markdown_links  # noqa: E402

# The system of an archive for this machine alone; empty for the archive of all systems.
HOST = ".".join(checkout.host())
system = HOST
MAX_BYTES = 12_000_000
TOP = "addons/ga_godot/"
REQUIRED = (
    "CHANGELOG.md", "LICENSE", "README.md", "docs/.gdignore", "docs/guides/expressions.md", "docs/guides/networking.md",
    "docs/troubleshooting.md", "docs/images/multiplayer.png", "docs/images/playground_editor.png", "examples/geometry.tscn",
    "examples/replication.tscn", "ga_godot.gdextension", "icon.svg", "plugin.cfg", "plugin.gd",
)
LIBRARY = re.compile(r"^bin/.*\.(so|dll|dylib)$")
# Files that belong to a build or to an editor, not to users.
UNWANTED = (".import", ".tmp", "~", ".lib", ".a", ".o", ".pdb", ".exp")
README_STARTS = ("## Installation", "## Quick start")


class Failed(RuntimeError):
    """What a check found."""


def expect(condition, message):
    if not condition:
        raise Failed(message)


def scons(*arguments):
    """Runs a target of SCons."""
    done = subprocess.run(["scons", "-Q", *arguments], cwd=ROOT, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, check=False)
    expect(done.returncode == 0, done.stdout)


def path():
    """The archive that `scons package` writes."""
    return os.path.join(ROOT, "dist", system, f"ga_godot-{addon_files.version()}.zip")


def pack():
    """Writes the archive."""
    scons("package", *(["toolchain=native"] if system else []))


def files():
    """The bytes of each file in the archive, by its path below addons/ga_godot."""
    with zipfile.ZipFile(path()) as archive:
        return {name[len(TOP):]: archive.read(name) for name in archive.namelist()}


def has_what_users_need():
    """The files that users need, in addons/ga_godot alone, within the size limit; equal input gives an equal archive."""
    pack()
    first = addon_files.read(path())
    pack()
    expect(first == addon_files.read(path()), "two runs of scons package wrote different archives")
    with zipfile.ZipFile(path()) as archive:
        names = archive.namelist()
    expect(all(name.startswith(TOP) for name in names), f"files outside {TOP}: {names}")
    found = files()
    expect(not set(REQUIRED) - set(found), f"missing: {sorted(set(REQUIRED) - set(found))}")
    unwanted = [name for name in found if name.endswith(UNWANTED)]
    expect(not unwanted, f"not for users: {unwanted}")
    libraries = sorted(filter(LIBRARY.match, found))
    listed = addon_files.listed_libraries()
    expect(set(libraries) <= set(listed), f"ga_godot.gdextension does not list {set(libraries) - set(listed)}")
    wanted = [name for name in listed if f".{system}." in name] if system else listed
    expect(libraries == wanted, f"the archive has {libraries} instead of {wanted}")
    print(f"archive: {len(first):,} bytes, {len(found)} files, of which {', '.join(libraries)}")
    expect(len(first) <= MAX_BYTES, f"the archive has {len(first):,} bytes, at most {MAX_BYTES:,} are allowed")


def checksum_fits():
    """The checksum file beside the archive has the form of sha256sum, and the archive's digest."""
    line = addon_files.read(path() + ".sha256").decode("ascii")
    expect(line == f"{hashlib.sha256(addon_files.read(path())).hexdigest()}  {os.path.basename(path())}\n", line)


def install_gives_the_same():
    """`scons install` writes the files of the archive, byte for byte, in place of an old version."""
    with tempfile.TemporaryDirectory() as folder:
        open(os.path.join(folder, "project.godot"), "w", encoding="utf-8").close()
        addon = os.path.join(folder, TOP)
        os.makedirs(addon)
        open(os.path.join(addon, "of_an_old_version"), "w", encoding="utf-8").close()
        scons("install", f"project={folder}")
        installed = {name: addon_files.read(os.path.join(addon, name)) for name in addon_files.paths_below(addon)}
    # Libraries of other systems are installed if they were built.
    installed = {name: data for name, data in installed.items() if not LIBRARY.match(name) or f".{HOST}." in name}
    packed = files()
    expect(set(installed) == set(packed), f"only in one of the two: {sorted(set(installed) ^ set(packed))}")
    expect(installed == packed, f"different: {[name for name in packed if packed[name] != installed[name]]}")


def versions_agree():
    """plugin.cfg, the changelog's first section and all libraries have one version."""
    found = files()
    wanted = re.search(r'^version="(.*)"$', found["plugin.cfg"].decode(), re.M)[1]
    expect(re.fullmatch(r"\d+\.\d+\.\d+(-[a-z0-9.]+)?", wanted), f"plugin.cfg: {wanted} is not a version such as 1.2.3")
    newest = re.search(r"^## (\S+)", found["CHANGELOG.md"].decode(), re.M)[1]
    expect(newest == wanted, f"plugin.cfg has version {wanted}, the newest section of CHANGELOG.md {newest}")
    libraries = {name: data for name, data in found.items() if LIBRARY.match(name)}
    expect(libraries, "the archive has no library")
    for name, data in libraries.items():
        versions = set(re.findall(rb'<class version="([^"]*)"', data))
        expect(versions == {wanted.encode()}, f"plugin.cfg has version {wanted}, {name} {sorted(versions)}")


def pages_lead_on():
    """The README starts with installation and quick start; from it, links lead to every page; no link or path is dead."""
    found = files()
    pages = {name: data.decode("utf-8") for name, data in found.items() if name.endswith(".md")}
    readme = pages["README.md"]
    expect(all(start in readme for start in README_STARTS) and "Playground" in readme, "README.md lacks its sections")
    expect(readme.count("![") >= 2, "README.md shows fewer than two pictures")
    dead = [line for name in pages for line in markdown_links.dead_links(name, pages.get, found.__contains__)]
    expect(not dead, "\n".join(dead))
    reached, pending = set(), ["README.md"]
    while pending:
        page = pending.pop()
        if page not in reached and page in pages:
            reached.add(page)
            pending += markdown_links.linked_paths(page, pages[page])
    expect(set(pages) == reached, f"no link leads to {sorted(set(pages) - reached)}")
    pictures = {name for name in found if name.endswith(".png")}
    shown = {linked for name, text in pages.items() for linked in markdown_links.linked_paths(name, text)}
    expect(pictures <= shown, f"shown by no page: {sorted(pictures - shown)}")


def examples_run():
    """In an empty project with the archive, the examples run without an error and show what they promise."""
    done = subprocess.run([sys.executable, os.path.join(checkout.TOOLS, "smoke"), path()], stdin=subprocess.DEVNULL,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    expect(done.returncode == 0, done.stdout)
    expect(done.stdout.count("example: ") == 2, done.stdout)
    print(done.stdout, end="")


# Of the archive of all systems too.
CHECKS = (
    ("the archive has what users need", has_what_users_need),
    ("the checksum beside the archive fits it", checksum_fits),
    ("plugin.cfg, changelog and libraries agree on the version", versions_agree),
    ("the pages of the archive are complete, and no link is dead", pages_lead_on),
    ("the examples run from the archive", examples_run),
)
INSTALL_CHECK = ("scons install gives the files of the archive", install_gives_the_same)
