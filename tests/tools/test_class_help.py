"""The class help is complete in itself: it contains the expression language, and cites no file of the repository."""

import glob
import os
import re
import unittest
from html import unescape

import checkout

GUIDE = os.path.join(checkout.ROOT, "docs", "guides", "expressions.md")
ROW = re.compile(r"^\| (`.*?) \| (.*?) \|$", re.M)
TITLES = "Constants|Operators|Objects|Motion|Interpolation|Products and grades|Numbers"
SECTION = re.compile(rf"^#{{2,3}} ({TITLES})\n(.*?)(?=^#{{2,3}} |\Z)", re.M | re.S)
FILE = re.compile(r"\b(?:docs|src|tests)/|\.md\b")


def help_of(name):
    with open(os.path.join(checkout.ROOT, "src", "godot", "doc_classes", name + ".xml"), encoding="utf-8") as file:
        return unescape(file.read())


def plain(text):
    """Text of a table without Markdown, and with single spaces."""
    return re.sub(r"\s+", " ", text.replace("\\|", "|").replace("`", "")).strip()


class ClassHelpTest(unittest.TestCase):
    def test_the_expression_language_is_in_the_help_of_evaluate(self):
        text = help_of("Multivector")
        evaluate = plain(text[text.index('<method name="evaluate"'):text.index('<method name="exp"')])
        rows = 0
        with open(GUIDE, encoding="utf-8") as file:
            sections = SECTION.findall(file.read())
        self.assertEqual(len({title for title, _ in sections}), 7)
        for title, body in sections:
            for subject, meaning in ROW.findall(body.replace("\\|", "\0")):
                subject, meaning = (cell.replace("\0", "|") for cell in (subject, meaning))
                if "ganja" in meaning or subject.count("|") > 3:
                    continue
                with self.subTest(section=title, subject=subject):
                    rows += 1
                    self.assertTrue(f"{plain(subject)} {plain(meaning)}" in evaluate, f"not in the help: {subject}: {meaning}")
        self.assertGreater(rows, 115)

    def test_no_file_of_the_repository_is_cited(self):
        paths = glob.glob(os.path.join(checkout.ROOT, "src", "godot", "doc_classes", "*.xml"))
        self.assertGreater(len(paths), 8)
        for path in paths:
            name = os.path.basename(path)[:-len(".xml")]
            self.assertEqual(FILE.findall(help_of(name)), [], name)


if __name__ == "__main__":
    unittest.main()
