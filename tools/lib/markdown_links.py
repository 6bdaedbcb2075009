"""Links in Markdown pages, and those that lead nowhere."""

import posixpath
import re

LINK = re.compile(r"!?\[(?:[^\[\]]|\[[^\]]*\]\([^)]*\))*\]\(([^)\s]+)\)")
PICTURE = re.compile(r"!\[[^\]]*\]\(([^)\s]+)\)")
FENCE = re.compile(r"^```.*?^```", re.M | re.S)
CODE = re.compile(r"`[^`\n]*`")
HEADING = re.compile(r"^#{1,6} (.*?)\s*$", re.M)
EXTERNAL = re.compile(r"^[a-z]+:")


def anchors(text):
    """Fragments by which the headings of a page are reached, as GitHub derives them."""
    found = set()
    for title in HEADING.findall(FENCE.sub("", text)):
        slug = re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-")
        count = sum(1 for anchor in found if re.fullmatch(re.escape(slug) + r"(-\d+)?", anchor))
        found.add(f"{slug}-{count}" if count else slug)
    return found


def targets(text):
    """Targets of all links and pictures of a page, those within links included."""
    outer = LINK.findall(CODE.sub("", FENCE.sub("", text)))
    return set(outer + PICTURE.findall(text))


def linked_paths(page, text):
    """Paths of the files that a page links, relative to the folder that its own path is relative to."""
    return {_path_of(page, target) for target in targets(text) if not EXTERNAL.match(target)}


def dead_links(page, read, exists):
    """Links of a page to files or headings that do not exist. read(path) returns the text of a page, exists(path) whether a file
    exists."""
    dead = []
    for target in sorted(targets(read(page))):
        if EXTERNAL.match(target):
            continue
        linked, fragment = _path_of(page, target), target.partition("#")[2]
        if linked.startswith("..") or not exists(linked):
            dead.append(f"{page}: {target}: there is no {linked}")
        elif fragment and fragment not in anchors(read(linked)):
            dead.append(f"{page}: {target}: there is no such heading in {linked}")
    return dead


def _path_of(page, target):
    path = target.partition("#")[0]
    return posixpath.normpath(posixpath.join(posixpath.dirname(page), path)) if path else page
