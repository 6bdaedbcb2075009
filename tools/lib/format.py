"""tools/format [--check] [FILE]...

Formats C++ with clang-format and GDScript with gdformat: the named files, or
all files of the checkout. With --check it changes nothing, lists the files that
are not formatted, and exits with 1 if there are any.
"""

import argparse
import concurrent.futures
import os
import re
import subprocess
import sys

import checkout
import clang_tools
import sources

# Files for each process: few enough to keep all processors busy.
CHUNK = 20
CLANG_FORMAT_ERROR = re.compile(r"^(.+?):\d+:\d+: error: code should be clang-formatted")
GDFORMAT_ERROR = re.compile(r"^would reformat (.+)$")


class FormatFailed(Exception):
    """A formatter could not process a file; the message is its output."""


def clang_format(paths, check):
    """Formats C++ files; with `check` changes nothing. Returns the files that are (were) not formatted."""
    command = [clang_tools.find("clang-format"), "--style=file", *(["--dry-run", "--Werror"] if check else ["-i"])]
    return _run(command, paths, CLANG_FORMAT_ERROR)


def gdformat(paths, check):
    """Formats GDScript files; with `check` changes nothing. Returns the files that are not formatted."""
    command = [checkout.setup_path("style"), "-m", "gdtoolkit.formatter", *(["--check"] if check else [])]
    return _run(command, paths, GDFORMAT_ERROR)


def _run(command, paths, error):
    chunks = [paths[start:start + CHUNK] for start in range(0, len(paths), CHUNK)]
    found = set()
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count() or 1) as executor:
        for done in executor.map(lambda chunk: _run_once(command, chunk), chunks):
            matches = {match[1] for match in map(error.match, done.stdout.splitlines()) if match}
            if done.returncode != 0 and not matches:
                raise FormatFailed(done.stdout.strip())
            found |= matches
    return sorted(found)


def _run_once(command, paths):
    return subprocess.run([*command, *paths], cwd=checkout.ROOT, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, check=False)


def parse_arguments(argv):
    """The options of tools/format."""
    parser = argparse.ArgumentParser(prog="tools/format", usage=argparse.SUPPRESS, description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="list the files that are not formatted and change nothing")
    parser.add_argument("files", nargs="*", metavar="FILE", help="format these files only")
    return parser.parse_args(argv)


def main():
    """Formats or checks the chosen files."""
    arguments = parse_arguments(sys.argv[1:])
    paths = [os.path.relpath(path, checkout.ROOT) for path in arguments.files] or sources.find("c++", "gdscript")
    found = []
    try:
        for language, formatter in (("c++", clang_format), ("gdscript", gdformat)):
            chosen = [path for path in paths if sources.language_of(path) == language]
            found += formatter(chosen, arguments.check) if chosen else []
    except FormatFailed as error:
        sys.exit(f"format: {error}")
    if arguments.check and found:
        sys.exit("\n".join(["format: not formatted, run tools/format:", *found]))


if __name__ == "__main__":
    main()
