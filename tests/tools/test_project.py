"""Preparing a project: the extension list, one import, and none when nothing changed."""

import contextlib
import io
import os
import tempfile
import unittest
from unittest import mock

import project


class ProjectTest(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.folder = os.path.join(place.name, "project")
        self.calls = os.path.join(place.name, "calls")
        self.engine = os.path.join(place.name, "engine")
        self.write("project.godot", "config_version=5\n")
        self.write("addons/b/b.gdextension", "")
        self.write("addons/a/a.gdextension", "")
        self.make_engine("")
        for name, value in (("ENGINE", self.engine), ("setup_path", lambda what: self.engine)):
            patch = mock.patch.object(project.checkout, name, value)
            patch.start()
            self.addCleanup(patch.stop)

    def write(self, name, text):
        path = os.path.join(self.folder, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)

    def make_engine(self, commands):
        with open(self.engine, "w", encoding="utf-8") as file:
            file.write(f'#!/bin/sh\necho "$*" >>{self.calls}\n{commands}\n')
        os.chmod(self.engine, 0o755)

    def prepare(self):
        with contextlib.redirect_stderr(io.StringIO()):
            project.prepare(self.folder)

    def imports(self):
        return project.read(self.calls).count("--import")

    def test_extensions_are_listed_before_the_import(self):
        self.make_engine(f"cp {self.folder}/.godot/extension_list.cfg {self.calls}.list")
        self.prepare()
        self.assertEqual(project.read(self.calls + ".list").split(),
                         ["res://addons/a/a.gdextension", "res://addons/b/b.gdextension"])

    def test_imports_once(self):
        self.prepare()
        self.prepare()
        self.assertEqual(self.imports(), 1)

    def test_a_changed_file_is_imported(self):
        self.prepare()
        self.write("icon.svg", "<svg/>")
        self.prepare()
        self.assertEqual(self.imports(), 2)

    def test_what_engine_and_build_write_changes_nothing(self):
        self.prepare()
        self.write("icon.svg.import", "x")
        self.write("addons/a/bin/a.so", "x")
        self.write(".godot/imported/x", "x")
        self.prepare()
        self.assertEqual(self.imports(), 1)

    def test_a_failed_import_is_told_and_repeated(self):
        for commands, words in (("exit 134", "exit code 134"), ("echo 'ERROR: no loader'", "no loader")):
            self.make_engine(commands)
            with self.assertRaises(SystemExit) as stopped:
                self.prepare()
            self.assertIn(words, str(stopped.exception))
        self.make_engine("")
        self.prepare()
        self.assertEqual(self.imports(), 3)
