"""The guide's game, exported: two processes of the exported game, as in networking.py."""

import os
import shutil

import checkout
import export
import networking
from newcomer import ADDON


def exported_game(newcomer):
    networking.prepare(newcomer)
    game = os.path.join(newcomer.place, "game")
    libraries = os.path.join(ADDON, "bin")
    shutil.copytree(newcomer.path(libraries), os.path.join(game, libraries))
    pack = os.path.join(game, "game.pck")
    problems = export.export(newcomer.engine, newcomer.project, pack, "true")
    assert not problems, problems
    networking.check_motion(newcomer, [checkout.ENGINE, "--headless", "--main-pack", pack], game)


CASES = (exported_game,)
