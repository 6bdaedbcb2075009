"""Pages of the repository, as they are in the addon."""

import os
import sys
import unittest

import checkout

sys.path.insert(0, os.path.join(checkout.ROOT, "site_scons"))

import addon_files  # noqa: E402

MOVED = {
    addon_files.FOLDER + "/README.md": "README.md",
    "CHANGELOG.md": "CHANGELOG.md",
    "docs/guides/networking.md": "docs/guides/networking.md",
    "docs/security.md": "docs/security.md",
}


class OfflinePageTest(unittest.TestCase):
    def offline(self, text, source="docs/guides/networking.md"):
        return addon_files.offline_page(text, source, MOVED)

    def test_links_within_the_addon_lead_to_the_new_place(self):
        self.assertEqual(self.offline("see [a](../security.md#dtls)")[0], "see [a](../security.md#dtls)")
        self.assertEqual(self.offline("[b](../../../docs/security.md)", addon_files.FOLDER + "/README.md")[0], "[b](docs/security.md)")
        self.assertEqual(self.offline("[c](docs/security.md) [d](#here)", "CHANGELOG.md")[0], "[c](docs/security.md) [d](#here)")

    def test_other_links_become_their_text(self):
        self.assertEqual(self.offline("a [test `x`](../../tests/net/x.cpp), [site](https://a.b/c)")[0],
                         "a test `x`, [site](https://a.b/c)")

    def test_pictures_are_collected(self):
        text = "![plot](../images/latency.png)"
        self.assertEqual(self.offline(text), (text, {"docs/images/latency.png"}))

    def test_pictures_that_are_left_out_leave_nothing(self):
        self.assertEqual(self.offline("| [![a](../images/gallery/a.png)](../images/gallery/a.png) | b |"), ("|  | b |", set()))


if __name__ == "__main__":
    unittest.main()
