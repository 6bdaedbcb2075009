"""The troubleshooting page cites messages that the library, the plugin and the engine print."""

import os
import re
import unittest

import checkout

PAGE = os.path.join("docs", "troubleshooting.md")
PLACES = ("src", os.path.join("godot_project", "addons", "ga_godot"))
ROW = re.compile(r"^\| (`{1,2})(.+?)\1( \(Godot\))? \| (.+) \|$", re.M)
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


def rows():
    with open(os.path.join(checkout.ROOT, PAGE), encoding="utf-8") as file:
        return [(message.strip(), bool(engine), advice) for _, message, engine, advice in ROW.findall(file.read())]


class TroubleshootingTest(unittest.TestCase):
    def test_messages_are_those_of_the_sources(self):
        sources = messages()
        own = [message for message, engine, _ in rows() if not engine]
        self.assertGreater(len(own), 30)
        for message in own:
            pieces = [piece.strip() for piece in message.split("...") if len(piece.strip()) > 2]
            self.assertTrue(pieces, message)
            self.assertEqual([piece for piece in pieces if piece not in sources], [], message)

    def test_messages_of_godot_are_in_the_engine(self):
        with open(os.path.realpath(checkout.setup_path("engine")), "rb") as file:
            program = file.read()
        if not program.startswith(b"\x7fELF"):
            self.skipTest("the engine is started by a script")
        cited = [message for message, engine, _ in rows() if engine]
        self.assertGreater(len(cited), 3)
        for message in cited:
            pieces = [piece.strip() for piece in re.split(r"\.\.\.|(?<=\")\w+(?=\")", message) if len(piece.strip()) > 2]
            self.assertEqual([piece for piece in pieces if piece.encode() not in program], [], message)

    def test_every_row_says_what_to_do(self):
        for message, _, advice in rows():
            self.assertGreater(len(advice), 30, message)

    def test_every_warning_of_the_setup_is_listed(self):
        """What the Scene dock shows has the cause and the cure on the page."""
        with open(os.path.join(checkout.ROOT, "src", "godot", "net", "setup_warnings.cpp"), encoding="utf-8") as file:
            warnings = re.findall(r'faults\.push_back\((?:vformat\()?"((?:[^"\\]|\\.)*)"', file.read())
        self.assertGreater(len(warnings), 5)
        listed = [message.split("...") for message, _, _ in rows()]
        for warning in warnings:
            text = re.sub(r"%[ds]", "...", warning.replace('\\"', '"'))
            found = any(all(piece.strip() in text for piece in pieces) for pieces in listed)
            self.assertTrue(found or text.startswith("Other targets"), text)


if __name__ == "__main__":
    unittest.main()
