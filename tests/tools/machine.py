"""A made-up machine for the tests of setup: its own PATH, cache, system and package source.

Only the programs that are put there exist. apt-get, apt-cache and dpkg are
small stand-ins that take their behavior from environment variables:

  FAKE_NETWORK=down      every update fails; gone: updates only warn, as apt does, and installing fails
  FAKE_SIGNATURE=bad     every update fails for its signature; expired: for its age
  FAKE_VERSION=4.6.3     what the suites carry
  FAKE_SLOW=SECONDS      a download takes this long
  FAKE_DISK=full         unpacking runs out of space
"""

import os
import shutil
import subprocess
import tarfile
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
# What every system has.
BASICS = """awk basename cat chmod cp cut date df dirname du env flock grep gzip head id ln ls mkdir mv readlink rm
sed sh sha256sum sleep sort tail tar touch tr true uname wc""".split()

DEBIAN = 'ID=debian\nPRETTY_NAME="Debian GNU/Linux 12 (bookworm)"\n'
UBUNTU = 'ID=ubuntu\nID_LIKE=debian\nPRETTY_NAME="Ubuntu 26.04 LTS"\n'
FEDORA = 'ID=fedora\nPRETTY_NAME="Fedora Linux 43"\n'

APT_GET = """#!/bin/sh
echo "apt-get $*" >>"$FAKE_LOG"
folder=
if [ "$1" = -c ]; then folder=$(dirname "$2"); fi
case " $* " in
    *" indextargets "*) echo "http://packages.invalid/$FAKE_SITE" ;;
    *" update "*)
        if [ "${FAKE_NETWORK:-}" = down ]; then echo "E: Failed to fetch" >&2; exit 100; fi
        if [ "${FAKE_SIGNATURE:-}" = bad ]; then
            echo "E: The following signatures couldn't be verified: NO_PUBKEY 0123" >&2; exit 100
        fi
        if [ "${FAKE_SIGNATURE:-}" = expired ]; then echo "E: Release file is expired (since 16d)" >&2; exit 100; fi
        touch "$FAKE_LOG.updated"
        ;;
    *" --print-uris "*)
        [ -n "$folder" ] && cp "$folder/apt.conf" "$folder/sources.list" "$FAKE_SETTINGS"
        echo "'http://packages.invalid/godot.deb' godot.deb 5000000 SHA256:0" ;;
    *" download "*) sleep "${FAKE_SLOW:-0}"; cp "$FAKE_DEB" . ;;
    *" --download-only "*)
        sleep "${FAKE_SLOW:-0}"
        cp "$FAKE_DEB" "$folder/apt/cache/archives/godot.deb"
        ;;
    *" install "*)
        if [ "${FAKE_LISTS:-}" = old ] && [ ! -e "$FAKE_LOG.updated" ]; then exit 100; fi
        if [ "${FAKE_PACKAGE:-}" = absent ]; then echo "E: Unable to locate package" >&2; exit 100; fi
        case " $* " in *" --simulate "*) exit ;; esac
        if [ "${FAKE_NETWORK:-}" = gone ]; then
            echo "E: Failed to fetch a.deb  Temporary failure resolving 'packages.invalid'" >&2; exit 100
        fi
        for package in "$@"; do
            case $package in ca-certificates) touch "$GA_GODOT_CERTIFICATES" ;; esac
            case $package in scons | python3 | g++) ln -sf "$FAKE_PROGRAM" "$FAKE_BIN/$package" ;; esac
        done
        ;;
esac
"""
APT_CACHE = """#!/bin/sh
printf 'godot:\\n  Installed: (none)\\n  Candidate: %s+ds-2\\n' "${FAKE_VERSION:-4.6.3}"
"""
DPKG = """#!/bin/sh
case $1 in
    --print-architecture) echo amd64 ;;
    -x)
        mkdir -p "$3" && tar -xf "$2" -C "$3"
        if [ "${FAKE_DISK:-}" = full ]; then echo "tar: write error: No space left on device" >&2; exit 2; fi
        ;;
esac
"""
SUCCEEDS = "#!/bin/sh\nexit 0\n"


def engine_script(version):
    """An engine that tells its version, else its arguments and where it looks for drivers."""
    return (f'#!/bin/sh\nif [ "$1" = --version ]; then echo {version}; exit; fi\n'
            'echo "$* drivers=${LIBGL_DRIVERS_PATH:-none}"\nexit 7\n')


class Machine:
    """One made-up machine in a folder of its own."""

    def __init__(self, system=DEBIAN):
        self.folder = tempfile.mkdtemp(prefix="ga_godot_tools.")
        self.bin = os.path.join(self.folder, "bin")
        self.cache = os.path.join(self.folder, "cache")
        self.tools = os.path.join(self.folder, "checkout", "tools")
        self.log = os.path.join(self.folder, "apt.log")
        os.mkdir(self.bin)
        shutil.copytree(os.path.join(ROOT, "tools"), self.tools, ignore=shutil.ignore_patterns("__pycache__"))
        for name in BASICS:
            os.symlink(shutil.which(name), os.path.join(self.bin, name))
        self.write("os-release", system)
        if system in (DEBIAN, UBUNTU):
            for name, text in (("apt-get", APT_GET), ("apt-cache", APT_CACHE), ("dpkg", DPKG)):
                self.program(name, text)
            self.program("apt-config", "#!/bin/sh\necho \"folder='/etc/apt'\"\n")
        self.as_user(0)
        self.environment = {
            "PATH": self.bin, "HOME": self.folder, "GA_GODOT_CACHE": self.cache,
            "GA_GODOT_CERTIFICATES": self.write("certificates", ""),
            "GA_GODOT_OS_RELEASE": os.path.join(self.folder, "os-release"),
            "FAKE_LOG": self.log, "FAKE_SETTINGS": self.folder, "FAKE_BIN": self.bin, "FAKE_SITE": "debian", "FAKE_DEB": self.make_package(),
            "FAKE_PROGRAM": self.write("program", SUCCEEDS, executable=True),
        }

    def close(self):
        """Removes the machine."""
        shutil.rmtree(self.folder)

    def write(self, name, text, executable=False):
        """Writes a file below the machine's folder; returns its path."""
        path = os.path.join(self.folder, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        if executable:
            os.chmod(path, 0o755)
        return path

    def program(self, name, text=SUCCEEDS):
        """Puts a program on the machine's PATH, in place of one that is there."""
        path = os.path.join(self.bin, name)
        if os.path.lexists(path):
            os.unlink(path)
        return self.write(os.path.join("bin", name), text, executable=True)

    def as_user(self, number):
        """Makes commands run as this user, as far as setup can see."""
        self.program("id", f'#!/bin/sh\n[ "$1" = -un ] && echo somebody || echo {number}\n')

    def make_package(self, version="4.6.3"):
        """The packages of the engine and its libraries in one: a loader, patchelf, a driver, an engine that starts, and the
        export templates."""
        place = os.path.join(self.folder, "package")
        files = {
            **{"usr/bin/" + name: engine_script(f"{version}.stable.debian")
               for name in ("godot", "godot-template-debug", "godot-template-release")},
            "usr/bin/patchelf": SUCCEEDS,
            "usr/lib/some-linux-gnu/ld-linux-some.so.2": SUCCEEDS,
            "usr/lib/some-linux-gnu/dri/a_dri.so": "",
            "usr/share/vulkan/icd.d/soft.json": '{"ICD": {"library_path": "/usr/lib/some-linux-gnu/libsoft.so"}}\n',
        }
        for name, text in files.items():
            self.write(os.path.join("package", name), text, executable=True)
        path = os.path.join(self.folder, "godot.deb")
        with tarfile.open(path, "w") as archive:
            archive.add(place, arcname=".")
        return path

    def run(self, tool, *arguments, **environment):
        """Runs a tool to its end; returns it with stdout and stderr."""
        return subprocess.run(self.command(tool, arguments), env={**self.environment, **environment}, cwd="/",
                              stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=60, check=False)

    def execute(self, program, *arguments):
        """Runs a program that a tool has made to its end."""
        return subprocess.run([program, *arguments], env=self.environment, capture_output=True, text=True, timeout=60, check=False)

    def start(self, tool, *arguments, **environment):
        """Starts a tool; the caller waits for it."""
        return subprocess.Popen(self.command(tool, arguments), env={**self.environment, **environment}, cwd="/",
                                stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)

    def command(self, tool, arguments):
        """The command line of a tool of the machine's checkout."""
        return [os.path.join(self.tools, tool), *arguments]

    def apt_calls(self, word):
        """How often apt-get was called with this argument."""
        if not os.path.exists(self.log):
            return 0
        with open(self.log, encoding="utf-8") as log:
            return sum(word in line.split() for line in log)

    def cached(self):
        """What the cache holds, without the lock and the log of a failure."""
        if not os.path.isdir(self.cache):
            return []
        return sorted(set(os.listdir(self.cache)) - {"lock", "setup.log"})
