"""The troubleshooting page cites messages that the library, the plugin and the engine print."""

import glob
import os
import re
import unittest

import checkout
from troubleshooting_page import rows

PLACES = ("src", os.path.join("godot_project", "addons", "ga_godot"))
# "one " + "text" over two lines, and quotes within a text.
CONCATENATION = re.compile(r'"\s*\+?\s*\n\s*\+?\s*"')


def messages():
    """All texts in the sources, in which a message is one line."""
    texts = []
    for place in PLACES:
        for folder, _, names in os.walk(os.path.join(checkout.ROOT, place)):
            for name in names:
                if name.endswith((".cpp", ".hpp", ".gd")):
                    with open(os.path.join(folder, name), encoding="utf-8") as file:
                        texts.append(CONCATENATION.sub("", file.read()).replace('\\"', '"'))
    return "\n".join(texts)


def of(source):
    return [row for row in rows() if row.source == source]


class TroubleshootingTest(unittest.TestCase):
    def test_messages_are_those_of_the_sources(self):
        sources = messages()
        self.assertGreater(len(of("")), 30)
        for row in of(""):
            self.assertTrue(row.pieces(), row.message)
            self.assertEqual([piece for piece in row.pieces() if piece not in sources], [], row.message)

    def test_messages_of_godot_are_in_the_engine(self):
        with open(os.path.realpath(checkout.setup_path("engine")), "rb") as file:
            program = file.read()
        if not program.startswith(b"\x7fELF"):
            self.skipTest("the engine is started by a script")
        self.assertGreater(len(of("Godot")), 9)
        for row in of("Godot"):
            pieces = [part for piece in row.pieces() for part in re.split(r"(?<=\")\w+(?=\")", piece)]
            self.assertEqual([piece for piece in pieces if piece.encode() not in program], [], row.message)

    def test_messages_of_linux_are_in_its_loader(self):
        loaders = glob.glob("/lib*/ld-linux*.so*")
        if not loaders:
            self.skipTest("no loader of glibc")
        with open(loaders[0], "rb") as file:
            program = file.read()
        self.assertGreater(len(of("Linux")), 4)
        for row in of("Linux"):
            # "file: reason"
            pieces = [part for piece in row.pieces() for part in piece.split(": ") if part != "No such file or directory"]
            self.assertEqual([piece for piece in pieces if piece.encode() not in program], [], row.message)

    def test_sources_are_known(self):
        self.assertEqual({row.source for row in rows()}, {"", "Godot", "Linux", "Windows", "macOS"})

    def test_every_row_says_what_to_do(self):
        for row in rows():
            self.assertTrue(len(row.advice) > 30 or row.advice.startswith("As above"), row.message)

    def test_every_warning_of_the_setup_is_listed(self):
        """What the Scene dock shows has the cause and the cure on the page."""
        with open(os.path.join(checkout.ROOT, "src", "godot", "net", "setup_warnings.cpp"), encoding="utf-8") as file:
            warnings = re.findall(r'faults\.push_back\((?:vformat\()?"((?:[^"\\]|\\.)*)"', file.read())
        self.assertGreater(len(warnings), 5)
        listed = [row.message.split("...") for row in of("")]
        for warning in warnings:
            text = re.sub(r"%[ds]", "...", warning.replace('\\"', '"'))
            found = any(all(piece.strip() in text for piece in pieces) for pieces in listed)
            self.assertTrue(found or text.startswith("Other targets"), text)


if __name__ == "__main__":
    unittest.main()
