"""Stand-ins for the export templates of systems other than this one: as much of their formats as Godot's exporter reads."""

import os
import struct
import zipfile

MACHINES_OF_PE = {"x86_64": 0x8664, "arm64": 0xAA64}
MACHINES_OF_ELF = {"x86_64": 62, "arm64": 183}
MACHO_MAGICS = (b"\xca\xfe\xba\xbe", b"\xcf\xfa\xed\xfe")
PLIST = """<?xml version="1.0" encoding="UTF-8"?>
<!DOCTYPE plist PUBLIC "-//Apple//DTD PLIST 1.0//EN" "http://www.apple.com/DTDs/PropertyList-1.0.dtd">
<plist version="1.0">
<dict>
<key>CFBundleExecutable</key>
<string>$binary</string>
<key>CFBundleIdentifier</key>
<string>$bundle_identifier</string>
</dict>
</plist>
"""


def write_linux(path, arch):
    """The header of an ELF executable."""
    ident = b"\x7fELF\x02\x01\x01".ljust(16, b"\0")
    write(path, ident + struct.pack("<HHI", 2, MACHINES_OF_ELF[arch], 1) + bytes(40))


def write_windows(path, arch):
    """The headers of a PE executable."""
    write(path, b"MZ".ljust(60, b"\0") + struct.pack("<I", 64) + b"PE\0\0" + struct.pack("<H", MACHINES_OF_PE[arch]) + bytes(18))


def write_macos(path, executable):
    """An archive with an application bundle. Godot signs `executable` if it is a Mach-O file."""
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("macos_template.app/Contents/Info.plist", PLIST)
        archive.writestr("macos_template.app/Contents/PkgInfo", "APPL????")
        for kind in ("debug", "release"):
            archive.writestr(f"macos_template.app/Contents/MacOS/godot_macos_{kind}.universal", executable)


def is_macho(data):
    """Whether this is a Mach-O file, of one or more architectures."""
    return data[:4] in MACHO_MAGICS


def write(path, data):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "wb") as file:
        file.write(data)
