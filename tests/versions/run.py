"""Compares what GA-Godot uses of the engine with the engine's API in each version from compatibility_minimum on.

Reads the objects of the built library, and the scripts and scenes of the addon and the demos. Ends with
`[versions] N passed, N failed`. --table prints what each version lacks, and what takes its place.
"""

import glob
import os
import re
import subprocess
import sys
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(os.path.dirname(os.path.dirname(HERE)), "tools", "lib"))

import checkout  # noqa: E402
import native_calls  # noqa: E402
import older_engine  # noqa: E402
import scripts  # noqa: E402
from descriptions import Description, interface_functions, numbers, versions  # noqa: E402

EXTENSION = os.path.join(checkout.PROJECT, "addons", "ga_godot", "ga_godot.gdextension")
# The tests run in the engine that the project is developed with.
SCRIPT_FOLDERS = ("addons", "demos", "menu", "theme")


def read(path):
    """The text of a file."""
    with open(path, encoding="utf-8") as file:
        return file.read()


def minimum():
    """The oldest version that loads the library, as text."""
    return re.search(r'compatibility_minimum = "([\d.]+)"', read(EXTENSION))[1]


class Apis:
    """The downloaded descriptions."""

    def __init__(self):
        command = [os.path.join(checkout.TOOLS, "setup"), "--print", "apis"]
        done = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=False)
        if done.returncode != 0:
            sys.exit("[versions] 0 passed, 1 failed")
        folder = done.stdout.strip()
        self.interface = interface_functions(folder)
        self.versions = {version: Description.load(folder, version) for version in versions(folder)}
        self.supported = [version for version in self.versions if numbers(version) >= numbers(minimum())]


def files(*endings):
    """The addon's and the demos' files with these endings."""
    found = glob.glob(os.path.join(checkout.PROJECT, "*.gd"))
    for folder in SCRIPT_FOLDERS:
        for ending in endings:
            found += glob.glob(os.path.join(checkout.PROJECT, folder, "**", "*" + ending), recursive=True)
    return sorted(path for path in found if path.endswith(endings))


def base_of(path):
    """The engine class that a script extends, also through other scripts."""
    extended = re.search(r'^extends "(.+)"', read(path), re.M)
    if not extended:
        return scripts.base_of(read(path))
    if extended[1].startswith("res://"):
        return base_of(os.path.join(checkout.PROJECT, extended[1][len("res://"):]))
    return base_of(os.path.join(os.path.dirname(path), extended[1]))


def own_members():
    """The members of the project's scripts and of the library's classes."""
    found = set().union(*(scripts.declarations(read(path)) for path in files(".gd")))
    for path in glob.glob(os.path.join(checkout.ROOT, "src", "godot", "doc_classes", "*.xml")):
        found.update(re.findall(r'<(?:class|method|member|signal|constant) name="(\w+)"', read(path)))
        found.update(re.findall(r'\benum="(?:\w+\.)?(\w+)"', read(path)))
    return found


class NativeTest(unittest.TestCase):
    """The library."""

    @classmethod
    def setUpClass(cls):
        cls.calls = native_calls.LibraryCalls()

    def each(self):
        for version in APIS.supported:
            with self.subTest(version=version):
                yield version, APIS.versions[version]

    def test_the_supported_versions(self):
        self.assertEqual(APIS.supported, ["4.4", "4.5", "4.6", "4.7"])
        generator = read(os.path.join(checkout.ROOT, "bindings", "generate.py"))
        self.assertIn("OLDEST_ENGINE = ({}, {})".format(*numbers(minimum())), generator)

    def test_the_calls_are_found(self):
        self.assertTrue({"mem_alloc2", "classdb_get_method_bind"} <= self.calls.interface)
        self.assertTrue({("Node3D", "set_transform"), ("Object", "emit_signal")} <= {(m.owner, m.name) for m in self.calls.methods})
        self.assertIn("_get_configuration_warnings", [method.engine_name for method in self.calls.virtuals])
        self.assertIn("add_custom_monitor", self.calls.by_name)
        self.assertGreater(len(self.calls.builtin_methods), 30)

    def test_only_what_is_used_is_loaded(self):
        loaded = {name for name in native_calls.LOADED if not name.startswith("packed_")}
        self.assertEqual(loaded, {name for name in self.calls.interface if not name.startswith("packed_")})

    def test_interface_functions(self):
        for version, _ in self.each():
            for name in self.calls.missing_interface(APIS.interface, numbers(version)):
                fallback = native_calls.INTERFACE_FALLBACKS.get(name)
                self.assertIsNotNone(fallback, f"Godot {version} has no {name}")
                self.assertIn(fallback, self.calls.interface)
                self.assertLessEqual(APIS.interface[fallback], numbers(version))

    def test_methods(self):
        used = {(method.owner, method.engine_name) for method in self.calls.methods}
        for version, description in self.each():
            missing = self.calls.missing_methods(description)
            for method in missing:
                fallback = native_calls.METHOD_FALLBACKS.get(method)
                self.assertIsNotNone(fallback, f"Godot {version} has no {method[0]}.{method[1]} with the hash of the bindings")
                self.assertIn(fallback, used - set(missing))

    def test_classes_and_functions(self):
        for version, description in self.each():
            self.assertEqual(self.calls.missing_names(description), [], version)

    def test_constants(self):
        for version, description in self.each():
            self.assertEqual(self.calls.changed_values(description), [], version)

    def test_builtin_types(self):
        for version, description in self.each():
            self.assertEqual(self.calls.changed_types(description), [], version)

    def test_an_older_version_is_recognized(self):
        old = APIS.versions["4.3"]
        self.assertIn("classdb_construct_object2", self.calls.missing_interface(APIS.interface, (4, 3)))
        self.assertIn(("RenderingServer", "multimesh_allocate_data"), self.calls.missing_methods(old))
        self.assertIn(("Node", "_get_configuration_warnings"), self.calls.missing_methods(old))
        self.assertIn("Node.PHYSICS_INTERPOLATION_MODE_OFF", self.calls.changed_values(APIS.versions["4.2"]))


class ScriptTest(unittest.TestCase):
    """The scripts and scenes."""

    @classmethod
    def setUpClass(cls):
        newer = [APIS.versions[version] for version in APIS.supported[1:]]
        cls.checker = scripts.Checker(APIS.versions[APIS.supported[0]], newer, own_members())

    def finds(self, script, *expected):
        found = [what for _, what in self.checker.check_script(script)]
        self.assertEqual(sorted(set(found)), sorted(expected), script)

    def test_scripts(self):
        paths = files(".gd")
        self.assertGreater(len(paths), 100)
        for path in paths:
            with self.subTest(path=os.path.relpath(path, checkout.PROJECT)):
                self.assertEqual(self.checker.check_script(read(path), base_of(path)), [])

    def test_scenes(self):
        for path in files(".tscn", ".tres"):
            with self.subTest(path=os.path.relpath(path, checkout.PROJECT)):
                self.assertEqual(self.checker.check_scene(read(path)), [])

    def test_samples_of_the_guides(self):
        pages = glob.glob(os.path.join(checkout.ROOT, "docs", "**", "*.md"), recursive=True)
        for path in pages + [os.path.join(checkout.ROOT, "README.md")]:
            for sample in re.findall(r"```gdscript\n(.*?)```", read(path), re.S):
                with self.subTest(path=os.path.relpath(path, checkout.ROOT)):
                    self.assertEqual(self.checker.check_script(sample), [])

    def test_later_classes_are_found(self):
        self.finds("extends FoldableContainer\n", "FoldableContainer")
        self.finds("var dock: EditorDock\n", "EditorDock")
        self.finds('func f() -> void:\n\tClassDB.instantiate(&"EditorDock")\n', "EditorDock")
        self.finds('func f() -> void:\n\tif ClassDB.class_exists(&"EditorDock"):\n\t\tClassDB.instantiate(&"EditorDock")\n')

    def test_later_members_are_found(self):
        call = "extends EditorPlugin\nfunc f(x: Control) -> void:\n\tremove_dock(x)\n"
        self.finds(call, "EditorPlugin.remove_dock", "remove_dock")
        self.finds("func f() -> void:\n\tOS.add_logger(null)\n", "OS.add_logger", "add_logger")
        call = "func f(s: HSplitContainer) -> void:\n\ts.split_offsets = []\n"
        self.finds(call, "HSplitContainer.split_offsets", "split_offsets")
        # The name is in Godot 4.4, but not in this class.
        self.finds("var files: FileDialog\nfunc f() -> void:\n\tfiles.popup_file_dialog()\n", "FileDialog.popup_file_dialog")
        self.finds("func f() -> FileDialog:\n\treturn EditorFileDialog.new()\n", "EditorFileDialog as FileDialog")
        self.finds("extends EditorPlugin\nfunc _run_scene(scene: String) -> void:\n\tpass\n", "EditorPlugin._run_scene")

    def test_later_syntax_is_found(self):
        self.finds("@abstract\nclass_name A\n", "@abstract")
        self.finds("func f(...rest: Array) -> void:\n\tpass\n", "...")

    def test_later_arguments_are_found(self):
        self.finds("func f(p: Object) -> void:\n\tp.add_custom_monitor(1, 2, [3, 4])\n")
        self.finds("func f(p: Object) -> void:\n\tp.add_custom_monitor(1, 2, [3, 4], 5)\n", "add_custom_monitor with 4 arguments")

    def test_comments_and_own_names_are_not_reported(self):
        self.finds('# FoldableContainer\nvar a := "EditorDock # add_dock"\nvar folded := 1\nvar image := folded\n')

    def test_scenes_are_read(self):
        scene = '[node name="A" type="HSplitContainer"]\nsplit_offset = 1\nsplit_offsets = [1]\n'
        scene += '[node name="B" type="FoldableContainer"]\n'
        self.assertEqual(self.checker.check_scene(scene), [(3, "HSplitContainer.split_offsets"), (4, "FoldableContainer")])


class OlderEngineTest(unittest.TestCase):
    """Tests of the engine suite with a library that is refused what the older version lacks."""

    @classmethod
    def setUpClass(cls):
        cls.calls = native_calls.LibraryCalls()
        cls.folder = older_engine.make_project()

    def passes(self, version, tests, asked):
        """The tests pass, and the library asked for these in vain."""
        lacks = [name for name, since in APIS.interface.items() if since > numbers(version)]
        lacks += [".".join(method) for method in self.calls.missing_methods(APIS.versions[version])]
        passed, failed, in_vain, output = older_engine.run(self.folder, lacks, tests)
        self.assertTrue(passed > 0 and failed == 0, output)
        self.assertNotIn("does not have", output)
        self.assertLessEqual(set(asked), in_vain, output)

    def test_threads_in_4_4(self):
        asked = ["mem_alloc2", "mem_free2", "classdb_register_extension_class5", "WorkerThreadPool.get_caller_group_id"]
        self.passes("4.4", "threads", asked)

    def test_monitors_in_4_5(self):
        self.passes("4.5", "test_monitors", ["mem_alloc2", "mem_free2"])


class OlderEditorTest(unittest.TestCase):
    """The dock in an editor where the addon's scripts do not find the classes of later versions."""

    def test_the_dock(self):
        folder = older_engine.make_project()
        older_engine.hide_later_classes(folder)
        lacks = [name for name, since in APIS.interface.items() if since > numbers(minimum())]
        output = older_engine.run_editor(folder, lacks)
        self.assertNotRegex(output, "ERROR|WARNING: GA", output)
        probed = re.findall(r"^\[probe\] (.*)$", output, re.M)
        expected = ["dock visible", "Coefficients unfolded", "Interpolation unfolded", "dock removed"]
        self.assertEqual(probed, [f"{what}: true" for what in expected], output)


def print_table():
    """What the library calls that a version lacks, and what takes its place."""
    calls = native_calls.LibraryCalls()
    print(f"{len(calls.interface)} interface functions, {len(calls.methods)} methods of classes, "
          f"{len(calls.builtin_methods)} of built-in types, {len(calls.virtuals)} virtual")
    for version, description in APIS.versions.items():
        fallbacks = native_calls.INTERFACE_FALLBACKS
        lacks = [(name, fallbacks.get(name)) for name in calls.missing_interface(APIS.interface, numbers(version))]
        lacks += [(".".join(method), ".".join(native_calls.METHOD_FALLBACKS.get(method, ())))
                  for method in calls.missing_methods(description)]
        lacks += [(name, None) for name in [*calls.changed_values(description), *calls.changed_types(description)]]
        listed = ", ".join(f"{name} ({fallback or 'no fallback'})" for name, fallback in lacks)
        print(f"| {version} | {listed or 'nothing'} |")


def main():
    """Runs the tests; a failed subtest counts as one."""
    suite = unittest.defaultTestLoader.loadTestsFromModule(sys.modules["__main__"])
    result = unittest.TextTestRunner(stream=sys.stdout, verbosity=2).run(suite)
    failed = len(result.failures) + len(result.errors)
    print(f"[versions] {max(result.testsRun - failed, 0)} passed, {failed} failed", flush=True)
    sys.exit(1 if failed else 0)


APIS = Apis()

if __name__ == "__main__":
    if sys.argv[1:] == ["--table"]:
        print_table()
    else:
        main()
