"""Finds the words in words.txt, which names, comments, messages and guides do not use."""

import re
from dataclasses import dataclass

import sources

LIST = "tests/style/words.txt"
LANGUAGES = ("c++", "gdscript", "python", "shell", "markdown", "xml")
# The list itself, its test, and the glossary, which quotes these words.
EXEMPT = ("tests/style/", "tests/tools/test_style.py", "docs/glossary.md")


@dataclass
class Word:
    """One line of the list."""

    pattern: re.Pattern
    replacement: str
    folders: tuple


def findings():
    """One line for each place with a listed word."""
    words = read_list(sources.read(LIST))
    found = []
    for path in sources.find(*LANGUAGES):
        if path.startswith(EXEMPT):
            continue
        applying = [word for word in words if path.startswith(word.folders)]
        for number, line in enumerate(sources.read(path).splitlines(), 1):
            for word in applying:
                match = word.pattern.search(line)
                if match:
                    found.append(f"{path}:{number}: '{match[0]}': write {word.replacement}")
    return found


def read_list(text):
    """The words in the text of words.txt."""
    words = []
    for line in text.splitlines():
        if line and not line.startswith("#"):
            pattern, replacement, folders = (field.strip() for field in line.rsplit("|", 2))
            # Escapes such as \\W are no capitals.
            flags = 0 if re.search(r"[A-Z]", re.sub(r"\\.", "", pattern)) else re.IGNORECASE
            words.append(Word(re.compile(pattern, flags), replacement, tuple(folders.split()) or ("",)))
    return words
