"""Follows the guides headless: guide_steps.gd takes the steps, and what it prints is checked here."""

import os
import shutil

import checkout
from newcomer import ADDON

HERE = os.path.dirname(os.path.abspath(__file__))
FRAMEWORK = os.path.join(checkout.PROJECT, "tests", "framework")
PARTS = ("networking", "interpolation", "playground", "expressions", "samples")
PAGES = ("README.md", "docs/guides/interpolation.md", "docs/guides/playground.md", "docs/guides/expressions.md", "docs/security.md")


def guides_headless(newcomer):
    for sample in newcomer.page("docs/guides/networking.md"):
        if sample.name == "main.tscn":
            newcomer.write("as_text.tscn", sample.text)
        elif sample.name == "main.gd":
            newcomer.write("main.gd", sample.text)
    shutil.copy(os.path.join(FRAMEWORK, "code_sample.gd"), newcomer.path("code_sample.gd"))
    shutil.copy(os.path.join(HERE, "guide_steps.gd"), newcomer.path("guide_steps.gd"))
    try:
        text = newcomer.run("--script", "res://guide_steps.gd", "--", *(f"res://{ADDON}/{page}" for page in PAGES))
    finally:
        for name in ("code_sample.gd", "guide_steps.gd", "as_text.tscn"):
            os.remove(newcomer.path(name))
    printed = [line for line in text.splitlines() if line.startswith("guide: ")]
    assert [line.split()[1].rstrip(":") for line in printed] == list(PARTS), text
    for line in printed:
        print(f"   {line}")
    assert os.path.exists(newcomer.path("main.tscn")), "the steps of the networking guide saved no scene"


CASES = (guides_headless,)
