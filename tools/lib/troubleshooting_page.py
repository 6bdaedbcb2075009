"""The rows of docs/troubleshooting.md: a message, whose it is, and what to do."""

import os
import re
from dataclasses import dataclass

import code_samples

PAGE = os.path.join("docs", "troubleshooting.md")
ROW = re.compile(r"^\| (`{1,2})(.+?)\1(?: \((\w+)\))? \| (.+) \|$", re.M)


@dataclass(frozen=True)
class Row:
    """A message, in which "..." stands for what differs. `source` is Godot or a system; empty for GA-Godot."""

    message: str
    source: str
    advice: str

    def pieces(self):
        """The parts of the message between what differs."""
        return [piece.strip() for piece in self.message.split("...") if len(piece.strip()) > 2]

    def fits(self, line):
        """Whether a line of output contains the message."""
        start = 0
        for piece in self.pieces():
            start = line.find(piece, start)
            if start < 0:
                return False
            start += len(piece)
        return True


def rows():
    """All rows with a message."""
    return [Row(message.strip(), source, advice) for _, message, source, advice in ROW.findall(code_samples.read(PAGE))]
