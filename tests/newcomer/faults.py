"""Incomplete and unsuitable copies of the addon: every error and warning that the engine prints about them is on the page about
troubleshooting."""

import os
import re
import shutil

import engine_run
import networking
from newcomer import ADDON
from troubleshooting_page import rows

EXTENSION = os.path.join(ADDON, "ga_godot.gdextension")
SECONDS = 60
REPORTED = re.compile(r"^(?:SCRIPT )?(?:ERROR|WARNING): .*$", re.M)
# What a fault must at least cause.
REFUSED = "Can't open dynamic library:"
NOT_LOADED = "Cannot get class 'MotorSynchronizer'."


def remove(path):
    os.remove(path)


def empty(path):
    with open(path, "wb"):
        pass


def damage(path):
    with open(path, "wb") as file:
        file.write(b"version https://git-lfs.github.com/spec/v1\n" * 40)


def change_processor(path):
    """Sets the processor of an ELF file to one that no system of Godot has."""
    with open(path, "r+b") as file:
        file.seek(18)
        file.write(b"\x02\x00")


def need_newer_c_library(path):
    with open(path, "rb") as file:
        data = file.read()
    changed = re.sub(rb"\0GLIBC_2\.\d\d\0", b"\0GLIBC_2.99\0", data)
    assert changed != data, f"{path} needs no version of the C library"
    with open(path, "wb") as file:
        file.write(changed)


LIBRARY_FAULTS = {remove: "GDExtension dynamic library not found", empty: "file too short", damage: "invalid ELF header",
                  change_processor: "cannot open shared object file", need_newer_c_library: "not found (required by"}
# Changes of ga_godot.gdextension.
EXTENSION_FAULTS = {
    "a newer Godot": (r'(compatibility_minimum = ).*', r'\1"4.99"', "GDExtension only compatible with Godot version"),
    "other systems": (r"^linux\.", "web.", "No GDExtension library found for current OS and architecture"),
}


def messages_about_faults_are_on_the_page(newcomer):
    networking.prepare(newcomer)
    copy = os.path.join(newcomer.place, "faulty")
    shutil.copytree(newcomer.path(""), copy)
    listed = rows()
    library = os.path.join(copy, ADDON, "bin")
    extension = os.path.join(copy, EXTENSION)
    with open(extension, encoding="utf-8") as file:
        whole = file.read()
    for fault, wanted in LIBRARY_FAULTS.items():
        for name in os.listdir(library):
            fault(os.path.join(library, name))
        check(newcomer, copy, listed, fault.__name__, wanted)
        shutil.copytree(newcomer.path(os.path.join(ADDON, "bin")), library, dirs_exist_ok=True)
    for title, (pattern, replacement, wanted) in EXTENSION_FAULTS.items():
        with open(extension, "w", encoding="utf-8") as file:
            file.write(re.sub(pattern, replacement, whole, flags=re.M))
        check(newcomer, copy, listed, title, wanted)
    shutil.rmtree(copy)


def check(newcomer, copy, listed, title, wanted):
    """Starts the game in the copy."""
    run: engine_run.Run = newcomer.engine.run(["--path", copy, "--quit-after", "3"], SECONDS, drawing=False)
    lines = REPORTED.findall(run.text)
    assert any(wanted in line for line in lines), f"{title}: no message about it: {lines}\n{run.text}"
    assert any(NOT_LOADED in line for line in lines), f"{title}: the extension was loaded: {lines}"
    # The row of Godot's message says that the system's reason is at its end: the page has that, too.
    missing = [line for line in lines
               if not any(row.fits(line) and (REFUSED not in line or row.source == "Linux") for row in listed)]
    assert not missing, f"{title}: not on the page about troubleshooting: {missing}"
    print(f"   {title}: {len(lines)} messages, all on the page", flush=True)


CASES = (messages_about_faults_are_on_the_page,)
