"""Links in the documentation lead to files and headings that exist, and every page is linked."""

import os
import re
import unittest

import checkout

LINK = re.compile(r"!?\[(?:[^\[\]]|\[[^\]]*\]\([^)]*\))*\]\(([^)\s]+)\)")
FENCE = re.compile(r"^```.*?^```", re.M | re.S)
CODE = re.compile(r"`[^`\n]*`")
HEADING = re.compile(r"^#{1,6} (.*?)\s*$", re.M)
EXTERNAL = re.compile(r"^[a-z]+:")
BUILT = ("build", "dist")


def pages():
    """Paths of all Markdown files of the checkout, relative to it."""
    found = []
    for folder, folders, names in os.walk(checkout.ROOT):
        folders[:] = [name for name in folders if name == ".github" or name not in BUILT and not name.startswith(".")]
        found += [os.path.relpath(os.path.join(folder, name), checkout.ROOT) for name in names if name.endswith(".md")]
    return sorted(found)


def read(page):
    with open(os.path.join(checkout.ROOT, page), encoding="utf-8") as file:
        return file.read()


def anchors(text):
    """Fragments by which the headings of a page are reached, as GitHub derives them."""
    found = set()
    for title in HEADING.findall(FENCE.sub("", text)):
        slug = re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-")
        count = sum(1 for anchor in found if re.fullmatch(re.escape(slug) + r"(-\d+)?", anchor))
        found.add(f"{slug}-{count}" if count else slug)
    return found


def targets(text):
    """Targets of all links and images of a page, those within links included."""
    text = CODE.sub("", FENCE.sub("", text))
    outer = LINK.findall(text)
    inner = re.findall(r"!\[[^\]]*\]\(([^)\s]+)\)", text)
    return set(outer + inner)


def dead_links(page):
    """Links of a page to files or headings that do not exist."""
    dead = []
    for target in targets(read(page)):
        if EXTERNAL.match(target):
            continue
        path, _, fragment = target.partition("#")
        linked = os.path.normpath(os.path.join(os.path.dirname(page), path)) if path else page
        if linked.startswith("..") or not os.path.exists(os.path.join(checkout.ROOT, linked)):
            dead.append(f"{page}: {target}: there is no {linked}")
        elif fragment and fragment not in anchors(read(linked)):
            dead.append(f"{page}: {target}: there is no such heading in {linked}")
    return dead


class DocsTest(unittest.TestCase):
    def test_no_link_is_dead(self):
        listed = pages()
        self.assertIn("README.md", listed)
        self.assertIn(os.path.join("docs", "architecture.md"), listed)
        links = sum(len(targets(read(page))) for page in listed)
        self.assertGreater(links, 60)
        self.assertEqual([link for page in listed for link in dead_links(page)], [])

    def test_every_page_is_linked(self):
        listed = pages()
        linked = {"README.md", os.path.join(".github", "pull_request_template.md"),
                  os.path.join("godot_project", "addons", "ga_godot", "README.md")}
        for page in listed:
            for target in targets(read(page)):
                linked.add(os.path.normpath(os.path.join(os.path.dirname(page), target.partition("#")[0])))
        self.assertEqual([page for page in listed if page not in linked], [])

    def test_links_and_anchors_are_found(self):
        text = "[![a](b.png)](c.md) and [d `e`](f.md#g) `[no](h.md)`\n```\n[no](i.md)\n```\n"
        self.assertEqual(targets(text), {"b.png", "c.md", "f.md#g"})
        self.assertEqual(anchors("# A `b_c`, d?\n## E\n```sh\n# no\n```\n## E\n"), {"a-b_c-d", "e", "e-1"})


if __name__ == "__main__":
    unittest.main()
