"""What the libraries of an archive need and offer: python inspect_libraries.py ARCHIVE

Prints a table, the problems, and "[libraries] N passed, N failed"; each library of ga_godot.gdextension is one test for each
processor in it. Needs LIEF.
"""

import hashlib
import os
import struct
import sys
import zipfile
from dataclasses import dataclass, field

import lief

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(ROOT, "site_scons"))

import addon_files  # noqa: E402

ADDON = "addons/ga_godot/"
ENTRY = "ga_godot_init"
MAX_BYTES = 3_000_000
MAX_GLIBC = (2, 28)
MAX_MACOS = (11, 0)
PROCESSORS = {
    ("linux", "x86_64"): lief.ELF.ARCH.X86_64, ("linux", "arm64"): lief.ELF.ARCH.AARCH64,
    ("windows", "x86_64"): lief.PE.Header.MACHINE_TYPES.AMD64, ("windows", "arm64"): lief.PE.Header.MACHINE_TYPES.ARM64,
    ("macos", "x86_64"): lief.MachO.Header.CPU_TYPE.X86_64, ("macos", "arm64"): lief.MachO.Header.CPU_TYPE.ARM64,
}
# Parts of the systems: the C library, and on Windows the Universal C Runtime, which Windows 10 and later contain.
SYSTEM_LIBRARIES = {
    "linux": ("libc.so.6", "libm.so.6", "libdl.so.2", "libpthread.so.0", "ld-linux-x86-64.so.2", "ld-linux-aarch64.so.1"),
    "windows": ("kernel32.dll", "ucrtbase.dll", "ntdll.dll"),
    "macos": ("/usr/lib/libSystem.B.dylib",),
}
UNIVERSAL_RUNTIME = "api-ms-win-crt-"
# Of the format of code signatures: magic numbers, and the flag of a signature without an identity.
SUPER_BLOB, CODE_DIRECTORY, AD_HOC, SHA256 = 0xFADE0CC0, 0xFADE0C02, 0x2, 2


@dataclass
class Part:
    """What one processor's part of a library contains."""

    size: int
    processor: object
    exports: list
    imports: list
    # The oldest system that loads it, in words.
    oldest: str
    problems: list = field(default_factory=list)


def read_linux(data):
    """The Part of an ELF file."""
    binary = lief.parse(data)
    exports = [symbol.name for symbol in binary.dynamic_symbols if symbol.exported]
    versions = {tuple(int(number) for number in version.name.split("_")[1].split("."))
                for needed in binary.symbols_version_requirement for version in needed.get_auxiliary_symbols()
                if version.name.startswith("GLIBC_")}
    part = Part(len(data), binary.header.machine_type, exports, list(binary.libraries), "glibc " + ".".join(map(str, max(versions))))
    if max(versions) > MAX_GLIBC:
        part.problems.append(f"needs {part.oldest}")
    if list(binary.symtab_symbols):
        part.problems.append("is not stripped")
    return [part]


def read_windows(data):
    """The Part of a PE file."""
    binary = lief.parse(data)
    header = binary.optional_header
    exports = [entry.name for entry in binary.get_export().entries]
    oldest = f"subsystem {header.major_subsystem_version}.{header.minor_subsystem_version}"
    part = Part(len(data), binary.header.machine, exports, [imported.name for imported in binary.imports], oldest)
    if binary.has_debug and any(entry.type == lief.PE.Debug.TYPES.CODEVIEW for entry in binary.debug):
        part.problems.append("names a file with debug information")
    return [part]


def read_macos(data):
    """The Parts of a universal Mach-O file."""
    parts = []
    universal = lief.MachO.parse(list(data))  # owns its parts
    for binary in universal:
        exports = [symbol.name.lstrip("_") for symbol in binary.exported_symbols]
        imports = [library.name for library in binary.libraries if library.command != lief.MachO.LoadCommand.TYPE.ID_DYLIB]
        oldest = tuple(binary.build_version.minos)[:2]
        part = Part(binary.original_size, binary.header.cpu_type, exports, imports, "macOS " + ".".join(map(str, oldest)))
        if oldest > MAX_MACOS:
            part.problems.append(f"needs {part.oldest}")
        if binary.build_version.platform != lief.MachO.BuildVersion.PLATFORMS.MACOS:
            part.problems.append(f"is for {binary.build_version.platform}")
        names = [library.name for library in binary.libraries if library.command == lief.MachO.LoadCommand.TYPE.ID_DYLIB]
        if names != ["@rpath/libga_godot.macos.universal.dylib"]:
            part.problems.append(f"has the install name {names}")
        start = binary.fat_offset
        part.problems += signature_problems(data[start:start + part.size], binary)
        parts.append(part)
    return parts


def signature_problems(data, binary):
    """What is wrong with the ad-hoc signature of one processor's part, whose bytes are `data`."""
    if not binary.has_code_signature:
        return ["is not signed"]
    signature = data[binary.code_signature.data_offset:][:binary.code_signature.data_size]
    magic, _, count = struct.unpack_from(">3I", signature)
    if magic != SUPER_BLOB:
        return ["has a signature of unknown form"]
    places = [struct.unpack_from(">2I", signature, 12 + 8 * index)[1] for index in range(count)]
    directories = [place for place in places if struct.unpack_from(">I", signature, place)[0] == CODE_DIRECTORY]
    if len(directories) != 1:
        return [f"has {len(directories)} code directories"]
    place = directories[0]
    flags, hashes, _, _, pages, limit = struct.unpack_from(">6I", signature, place + 12)
    hash_size, hash_type, _, page_bits = struct.unpack_from(">4B", signature, place + 36)
    if not flags & AD_HOC or hash_type != SHA256 or limit != binary.code_signature.data_offset:
        return [f"has an unexpected signature: flags {flags:#x}, hash type {hash_type}, signed bytes {limit}"]
    page = 1 << page_bits
    if pages != -(-limit // page):
        return [f"has {pages} signed pages, but {limit} bytes"]
    wrong = 0
    for index in range(pages):
        signed = signature[place + hashes + index * hash_size:][:hash_size]
        wrong += hashlib.sha256(data[index * page:min((index + 1) * page, limit)]).digest() != signed
    return [f"has {wrong} of {pages} pages that differ from their signature"] if wrong else []


READERS = {"linux": read_linux, "windows": read_windows, "macos": read_macos}


def is_of_system(platform, name):
    """Whether a library is a part of the system."""
    if platform == "windows":
        return name.lower() in SYSTEM_LIBRARIES[platform] or name.lower().startswith(UNIVERSAL_RUNTIME)
    return name in SYSTEM_LIBRARIES[platform]


def check(platform, arch, part):
    """Adds what is wrong with a part for a platform and processor to its problems."""
    if part.processor != PROCESSORS[platform, arch]:
        part.problems.append(f"is for {part.processor}")
    if part.exports != [ENTRY]:
        part.problems.append(f"exports {part.exports}")
    foreign = [name for name in part.imports if not is_of_system(platform, name)]
    if foreign or not part.imports:
        part.problems.append(f"imports {foreign}")
    if part.size > MAX_BYTES:
        part.problems.append(f"has {part.size} bytes, more than {MAX_BYTES}")


def libraries_in(archive):
    """(platform, processors, path) of each library that the archive's ga_godot.gdextension names."""
    found = {}
    for tags, path in addon_files.libraries(archive.read(ADDON + "ga_godot.gdextension")).items():
        platform, _, *arch = tags.split(".")
        found[path] = (platform, arch or ["arm64", "x86_64"])
    return [(platform, arches, path) for path, (platform, arches) in found.items()]


def main():
    """Inspects the archive in the first argument."""
    passed = failed = 0
    with zipfile.ZipFile(sys.argv[1]) as archive:
        size = sum(entry.compress_size for entry in archive.infolist())
        libraries = libraries_in(archive)
        names = {name for name in archive.namelist() if name.startswith(ADDON + "bin/")}
        problems = [f"the archive lacks {path}" for _, _, path in libraries if ADDON + path not in names]
        problems += [f"{name} is not in ga_godot.gdextension" for name in names - {ADDON + path for _, _, path in libraries}]
        problems += [f"no library for {key}" for key in PROCESSORS if not any(key[0] == found[0] and key[1] in found[1] for found in libraries)]
        for platform, arches, path in libraries:
            if ADDON + path not in names:
                continue
            data = archive.read(ADDON + path)
            parts = READERS[platform](data)
            if len(parts) != len(arches):
                problems.append(f"{path} is for {len(parts)} processors")
            for arch, part in zip(arches, sorted(parts, key=lambda part: [key for key, value in PROCESSORS.items() if value == part.processor])):
                check(platform, arch, part)
                print(f"{platform:<8} {arch:<7} {part.size:>9,} bytes, exports {', '.join(part.exports)}; oldest system: {part.oldest}; "
                      f"imports {len(part.imports)}: {', '.join(part.imports)}")
                problems += [f"{path} ({arch}) {problem}" for problem in part.problems]
                passed += not part.problems
                failed += bool(part.problems)
    print(f"archive  {size:,} bytes compressed, {len(libraries)} libraries")
    for problem in problems:
        print("libraries: " + problem)
    passed, failed = passed + (not problems), failed + bool(problems)
    print(f"[libraries] {passed} passed, {failed} failed")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
