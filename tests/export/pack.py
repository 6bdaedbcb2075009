"""Reads a Godot pack: the project's files in an exported game."""

import struct

# Magic number, format, version of the engine, flags and offset of the data.
HEADER = struct.Struct("<4s5IQ")
FORMATS = (2, 3)
# Offset of the directory in format 2, after the reserved words.
DIRECTORY = HEADER.size + 16 * 4
# Offset and size of a file's data; then a digest and flags.
ENTRY = struct.Struct("<QQ16sI")


def read(path):
    """The contents of a pack by path relative to res://."""
    with open(path, "rb") as file:
        data = file.read()
    magic, version, *_, base = HEADER.unpack_from(data)
    if magic != b"GDPC" or version not in FORMATS:
        raise ValueError(f"{path} is not a pack of a known format ({magic}, {version})")
    at = struct.unpack_from("<Q", data, HEADER.size)[0] if version == 3 else DIRECTORY
    count = read_number(data, at)
    at += 4
    files = {}
    for _ in range(count):
        length = read_number(data, at)
        name = data[at + 4:at + 4 + length].rstrip(b"\0").decode()
        at += 4 + length
        offset, size, _, _ = ENTRY.unpack_from(data, at)
        at += ENTRY.size
        files[name.removeprefix("res://")] = data[base + offset:base + offset + size]
    return files


def read_number(data, at):
    """A 32-bit number."""
    return struct.unpack_from("<I", data, at)[0]
