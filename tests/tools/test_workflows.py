"""The workflows: actionlint accepts them, and they call this repository's tools and scons only."""

import glob
import os
import re
import shlex
import shutil
import subprocess
import unittest

import checkout

FOLDER = os.path.join(checkout.ROOT, ".github", "workflows")
ACTIONLINT = "github.com/rhysd/actionlint/cmd/actionlint@v1.7.12"
RUN = re.compile(r"^\s*(?:- )?run: (.*)$", re.M)
USES = re.compile(r"^\s*(?:- )?uses: (.*)$", re.M)
# What installs scons and Godot on runners without apt, and publishes.
INSTALLATION = ("python -m pip install scons==", "gh release download ", "gh release create ")
TOOL = re.compile(r"^(?:python )?(tools/\w+)(?: |$)")


def read(name):
    with open(os.path.join(FOLDER, name), encoding="utf-8") as file:
        return file.read()


def actionlint():
    """Path of actionlint, built by go if it is not installed; None if neither is."""
    found = shutil.which("actionlint")
    if found or not shutil.which("go"):
        return found
    folder = os.path.join(checkout.BUILD, "actionlint", ACTIONLINT.rpartition("@")[2])
    if not os.path.isfile(os.path.join(folder, "actionlint")):
        built = subprocess.run(["go", "install", ACTIONLINT], env={**os.environ, "GOBIN": folder}, check=False)
        if built.returncode != 0:
            return None
    return os.path.join(folder, "actionlint")


class WorkflowsTest(unittest.TestCase):
    def test_the_workflows_exist(self):
        self.assertEqual(sorted(os.listdir(FOLDER)), ["release.yml", "tests.yml"])

    def test_actionlint_accepts_them(self):
        program = actionlint()
        if program is None:
            self.skipTest(f"no actionlint; install it, or go, which builds {ACTIONLINT}")
        done = subprocess.run([program, *glob.glob(os.path.join(FOLDER, "*.yml"))], cwd=checkout.ROOT, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
        self.assertEqual((done.returncode, done.stdout), (0, ""))

    def test_they_call_tools_and_scons_only(self):
        for name in os.listdir(FOLDER):
            commands = RUN.findall(read(name))
            self.assertTrue(commands, name)
            for command in commands:
                with self.subTest(workflow=name, command=command):
                    tool = TOOL.match(command)
                    if tool:
                        self.assertTrue(os.access(os.path.join(checkout.ROOT, tool[1]), os.X_OK), f"{tool[1]} is not a program")
                    else:
                        self.assertTrue(command.startswith(("scons ", *INSTALLATION)), command)

    def test_the_options_of_scons_exist(self):
        options = subprocess.run(["scons", "-Q", "-h"], cwd=checkout.ROOT, stdout=subprocess.PIPE, text=True, check=True).stdout
        for name in os.listdir(FOLDER):
            for command in RUN.findall(read(name)):
                for word in shlex.split(re.sub(r"\$\{\{.*?\}\}", "x", command))[1:] if command.startswith("scons ") else []:
                    self.assertRegex(options, rf"(?m)^(  )?{re.escape(word.partition('=')[0])}\b", f"{name}: {command}")

    def test_the_linux_tests_are_those_of_every_change(self):
        with open(os.path.join(checkout.ROOT, ".ci", "run"), encoding="utf-8") as file:
            command = re.search(r"^exec (tools/test .*)$", file.read(), re.M)[1]
        self.assertIn(command, RUN.findall(read("tests.yml")))

    def test_actions_have_versions(self):
        for name in os.listdir(FOLDER):
            for action in USES.findall(read(name)):
                self.assertRegex(action, r"^(\./\.github/workflows/\w+\.yml|[\w-]+/[\w-]+@v\d+)$", name)

    def test_what_was_not_run_is_marked(self):
        text = read("release.yml")
        native = text[text.index("\n  native:"):text.index("\n  draft:")]
        self.assertRegex(native, "runner: windows-")
        self.assertRegex(native, "runner: macos-")
        self.assertRegex(text[:text.index("\n  native:")].rstrip().splitlines()[-1], "# Not yet run")


if __name__ == "__main__":
    unittest.main()
