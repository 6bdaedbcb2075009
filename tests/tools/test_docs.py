"""Links in the documentation lead to files and headings that exist, and every page is linked."""

import glob
import os
import re
import unittest

import checkout
from code_samples import pages, read
from markdown_links import CODE, FENCE, anchors, dead_links, linked_paths, targets


def exists(path):
    return os.path.exists(os.path.join(checkout.ROOT, path))


class DocsTest(unittest.TestCase):
    def test_no_link_is_dead(self):
        listed = pages()
        self.assertIn("README.md", listed)
        self.assertIn(os.path.join("docs", "architecture.md"), listed)
        links = sum(len(targets(read(page))) for page in listed)
        self.assertGreater(links, 60)
        self.assertEqual([link for page in listed for link in dead_links(page, read, exists)], [])

    def test_every_page_is_linked(self):
        listed = pages()
        linked = {"README.md", os.path.join(".github", "pull_request_template.md"),
                  os.path.join("godot_project", "addons", "ga_godot", "README.md")}
        for page in listed:
            linked |= linked_paths(page, read(page))
        self.assertEqual([page for page in listed if page not in linked], [])

    def test_the_readme_is_one_screen(self):
        text = read("README.md")
        self.assertLessEqual(len(text.splitlines()), 60)
        self.assertEqual(text.count("!["), 2)
        for heading in ("## Installation", "## Quick start", "## Contributing", "## License"):
            self.assertIn(heading + "\n", text)

    def test_menus_and_buttons_that_the_guides_name_exist(self):
        """*Menu > Item* is a text of the engine or of the addon, or an engine's setting in the words of the editor."""
        with open(os.path.realpath(checkout.setup_path("engine")), "rb") as file:
            texts = file.read()
        if not texts.startswith(b"\x7fELF"):
            self.skipTest("the engine is started by a script")
        for path in glob.glob(os.path.join(checkout.PROJECT, "addons", "ga_godot", "**", "*.gd"), recursive=True):
            with open(path, "rb") as file:
                texts += file.read()
        count = 0
        for page in [page for page in pages() if page.startswith(os.path.join("docs", "guides")) or page.endswith("README.md")]:
            for name in re.findall(r"(?<!\*)\*([A-Z][^*]+)\*(?!\*)", CODE.sub("", FENCE.sub("", read(page)))):
                for part in re.sub(r"\s+", " ", name).split(" > "):
                    count += 1
                    known = part.encode() in texts or part.lower().replace(" ", "_").encode() in texts
                    self.assertTrue(known, f"{page}: neither Godot nor the addon has '{part}'")
        self.assertGreater(count, 50)

    def test_links_and_anchors_are_found(self):
        text = "[![a](b.png)](c.md) and [d `e`](f.md#g) `[no](h.md)`\n```\n[no](i.md)\n```\n"
        self.assertEqual(targets(text), {"b.png", "c.md", "f.md#g"})
        self.assertEqual(anchors("# A `b_c`, d?\n## E\n```sh\n# no\n```\n## E\n"), {"a-b_c-d", "e", "e-1"})


if __name__ == "__main__":
    unittest.main()
