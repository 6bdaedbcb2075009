"""Remembers which files passed a check, so that the next run checks only what changed."""

import hashlib
import json
import os

import checkout

FOLDER = os.path.join(checkout.BUILD, "style")


class PassedFiles:
    """The files that passed one check, in build/style/CHECK.

    A file stays there until its content, that of a file it includes, or `settings` (the tool's version and
    configuration) changes.
    """

    def __init__(self, check, settings):
        self._folder = os.path.join(FOLDER, check)
        self._settings = settings
        os.makedirs(self._folder, exist_ok=True)

    def has(self, path):
        """Whether the file passed and nothing changed since."""
        try:
            with open(self._record(path), encoding="utf-8") as file:
                record = json.load(file)
            return record["digest"] == self._digest(record["inputs"])
        except (OSError, ValueError, KeyError):
            return False

    def add(self, path, inputs=()):
        """The file passed; the result also depends on the files `inputs`."""
        inputs = sorted({path, *inputs})
        record = {"digest": self._digest(inputs), "inputs": inputs}
        with open(self._record(path), "w", encoding="utf-8") as file:
            json.dump(record, file)

    def _record(self, path):
        return os.path.join(self._folder, path.replace("/", "+") + ".json")

    def _digest(self, paths):
        digest = hashlib.sha256(self._settings.encode())
        for path in paths:
            with open(os.path.join(checkout.ROOT, path), "rb") as file:
                digest.update(hashlib.sha256(file.read()).digest())
        return digest.hexdigest()
