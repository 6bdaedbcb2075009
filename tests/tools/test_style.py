"""The parts of the style suite that no tool of others provides: the list of words, the count of private methods."""

import os
import sys
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(ROOT, "tests", "style"))

import clang_tools  # noqa: E402
import limits  # noqa: E402
import words  # noqa: E402

HEADER = """
class Outer : public Base {
    void first(); // private: it has no label
public:
    Outer() : Base({ 1 }) {}
    void shown() { if (a) { b(); } }
private:
    struct Inner { void open(); };
    using Callback = void (*)(int);
    friend void helper();
    void second(const char *text = "};") const;
    bool operator==(const Outer &other) const { return a() == b(); }
    int _member = count(3);
};
"""


class StyleTest(unittest.TestCase):
    def test_private_methods_are_counted(self):
        self.assertEqual(limits.private_methods(HEADER), {"Outer": 3, "Inner": 0})

    def test_words(self):
        text = "# a comment\n\ncolour|hue | color |\n\\bMOST_[A-Z] | MAX_ | src/ docs/\n"
        first, second = words.read_list(text)
        self.assertEqual((first.replacement, first.folders), ("color", ("",)))
        self.assertTrue(first.pattern.search("get_Colour"))
        self.assertEqual(second.folders, ("src/", "docs/"))
        self.assertTrue(second.pattern.search("MOST_BODIES"))
        self.assertFalse(second.pattern.search("most_bodies"))

    def test_integer_types(self):
        for text, found in (("std::size_t n;", True), ("std::uint8_t n;", True), ("size_t n;", False), ("std::sort(n)", False)):
            self.assertEqual(bool(limits.STD_INTEGER.search(text)), found, text)

    def test_versions_of_clang_tools(self):
        for text, major in (("Debian clang-format version 19.1.7 (3)", 19), ("LLVM version 20.1.0\n", 20), ("", 0)):
            self.assertEqual(clang_tools.major_version(text), major)
