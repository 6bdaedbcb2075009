"""The code samples of the pages and of the class help: blocks, and commands in the text.

`python3 tools/lib/code_samples.py` prints each block with the test that runs it.
"""

import glob
import os
import re
from collections import Counter
from dataclasses import dataclass
from html import unescape
from textwrap import dedent

import checkout

# Folders that are built, or that belong to others.
LEFT_OUT = ("build", "dist", "godot-cpp")
# In a list, it is indented.
FENCE = re.compile(r"^( *)```([\w-]*)(?: (\S+))?\n(.*?)^\1```$", re.M | re.S)
CODEBLOCK = re.compile(r"\[codeblock(?: lang=(\w+))?\](.*?)\[/codeblock\]", re.S)
SPAN = re.compile(r"`([^`\n]+)`")
HELP = os.path.join("src", "godot", "doc_classes")
ENGINE = "godot_project/tests/test_code_samples.gd"
# The test that runs the samples of a language. It finds them on all pages by itself.
RUNNERS = {
    "gdscript": ENGINE,
    "expressions": "tests/playground/expression/test_guide.cpp",
    "cpp": "tests/tools/test_code_samples.py",
    "cmake": "tests/package/run.py",
    "sh": "tests/tools/test_code_samples.py",
    "json": "tests/tools/test_code_samples.py",
    # Output, diagrams and tables: nothing to run.
    "text": "",
}
# The tests that run the scripts and scenes with a file name, by page: each in the situation that the page describes.
SITUATIONS = {
    "docs/guides/networking.md": ("godot_project/tests/test_networking_guide.gd", "tests/newcomer/networking.py"),
    "docs/security.md": ("godot_project/tests/test_security_guide.gd",),
}


@dataclass(frozen=True)
class Sample:
    """A block of code."""

    page: str
    line: int
    language: str
    name: str
    text: str

    def runners(self):
        """The tests that may run it; None if its language is unknown, or if it has a file name and its page no situations."""
        if self.name:
            return SITUATIONS.get(self.page)
        return (RUNNERS[self.language],) if self.language in RUNNERS else None


def pages():
    """Paths of all Markdown files of the checkout, relative to it."""
    found = []
    for folder, folders, names in os.walk(checkout.ROOT):
        folders[:] = [name for name in folders if name == ".github" or name not in LEFT_OUT and not name.startswith(".")]
        found += [os.path.relpath(os.path.join(folder, name), checkout.ROOT) for name in names if name.endswith(".md")]
    return sorted(found)


def read(page):
    """The text of a page of the checkout."""
    with open(os.path.join(checkout.ROOT, page), encoding="utf-8") as file:
        return file.read()


def samples_of(page, text=None):
    """The blocks of one page, or of a text in its place."""
    text = read(page) if text is None else text
    return [Sample(page, text[:match.start()].count("\n") + 2, match[2], match[3] or "", dedent(match[4]))
            for match in FENCE.finditer(text)]


def help_samples():
    """The blocks of the class help."""
    found = []
    for path in sorted(glob.glob(os.path.join(checkout.ROOT, HELP, "*.xml"))):
        page = os.path.relpath(path, checkout.ROOT)
        text = read(page)
        found += [Sample(page, text[:match.start()].count("\n") + 2, match[1] or "gdscript", "", unescape(match[2]))
                  for match in CODEBLOCK.finditer(text)]
    return found


def all_samples():
    """The blocks of all pages and of the class help."""
    return [sample for page in pages() for sample in samples_of(page)] + help_samples()


def spans():
    """The code in the text of all pages: (page, line, code)."""
    found = []
    for page in pages():
        text = FENCE.sub(lambda match: "\n" * match[0].count("\n"), read(page))
        found += [(page, text[:match.start()].count("\n") + 1, match[1]) for match in SPAN.finditer(text)]
    return found


def main():
    """Prints the number of blocks of each page and language, and their tests."""
    counts = Counter((sample.page, f"{sample.language} with a file name" if sample.name else sample.language,
                      " or ".join(sample.runners() or ("NONE",)) or "nothing to run") for sample in all_samples())
    for (page, language, runner), count in sorted(counts.items()):
        print(f"{page}: {count} {language}: {runner}")


if __name__ == "__main__":
    main()
