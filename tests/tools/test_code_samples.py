"""Every code sample of the pages and of the class help is run by a test; those that need no engine are run here."""

import glob
import json
import os
import re
import subprocess
import tempfile
import unittest

import checkout
import code_samples
import documented_commands
from code_samples import RUNNERS, all_samples

# C++ that a sample stands in, by page.
SURROUNDINGS = {os.path.join("docs", "architecture.md"): """\
#include "cga/motor/motor_multivector.hpp"
#include "cga/typed/motion.hpp"
#include "cga/typed/objects.hpp"

int main() {{
	const glm::dvec3 x(1.0, 0.0, 0.0), y(2.0, 1.0, 0.0);
	const cga::Motor<double> motor = cga::Motor<double>::from_pose({{ y, glm::dquat(1.0, 0.0, 0.0, 0.0), 2.0 }});
	{{
{sample}
		// The line is the one through both points, and was moved; the circle is a circle.
		if (!(any.is_equal_approx(cga::to_multivector(motor).sandwich(line.to_multivector()).value(), 1e-12)) ||
				shared.to_multivector().max_abs() == 0.0) {{
			return 1;
		}}
	}}
	return 0;
}}
"""}
COMMAND = re.compile(r"^(?:tools/[a-z]+|scons|python3?|tests/\w+/run\.py|build/[\w.]+/(?:tests|bench|fuzz)/\w+)(?: |$)")
# Paths of this checkout in the text, with * and {a,b}.
PATH = re.compile(r"^(?:src|tests|tools|docs|site_scons|bindings|godot_project|examples)/[\w./*{},-]*$")
WRONG_COMMANDS = (
    "tools/test --only nothing", "tools/tset", "tools/bench load --case no_such_case", "tools/bench laod", "scons testz",
    "scons taget=template_debug", "scons target=template_fast", "scons platform=beos", "scons toolchain=clang",
    "tools/setup engines", "tools/setup --print engines",
    "tools/godot --path godot_project -- --demo=nothing", "tools/godot --path godot_project -- --dump=FILE",
    "build/VARIANT/tests/nothing_tests", "build/VARIANT/tests/net_tests -tc=nothing:*", "python3 tools/lib/nothing.py",
    "python3 tests/versions/run.py --tables", "tests/network/run.py --case nothing_like_it", "g++ -Isrc src/none.cpp",
    "rm -rf build", "mkdir -p a && tools/test --only nothing", "echo 'unclosed",
)
BUILT_FILES = ("docs/.gdignore", "godot_project/addons/ga_godot/bin")


def of_language(language):
    return [sample for sample in all_samples() if sample.language == language and not sample.name]


def place(sample):
    return f"{sample.page}:{sample.line}"


class CodeSamplesTest(unittest.TestCase):
    def test_every_block_is_found(self):
        for page in code_samples.pages():
            marks = len(re.findall(r"^[ \t]*(?:```|~~~)", code_samples.read(page), re.M))
            self.assertEqual(marks, 2 * len(code_samples.samples_of(page)), f"{page}: a block is not ```LANGUAGE at the line's start")
        for path in glob.glob(os.path.join(checkout.ROOT, code_samples.HELP, "*.xml")):
            page = os.path.relpath(path, checkout.ROOT)
            blocks = len(re.findall(r"\[/(?:codeblocks?|gdscript|csharp)\]", code_samples.read(page)))
            self.assertEqual(blocks, sum(sample.page == page for sample in code_samples.help_samples()), page)
        self.assertGreater(len(all_samples()), 170)

    def test_every_block_is_run_by_a_test(self):
        for sample in all_samples():
            with self.subTest(place(sample)):
                runners = sample.runners()
                what = f"{sample.language} {sample.name}".strip()
                self.assertTrue(runners, f"no test runs the language '{what}'; a test runs {list(RUNNERS)}")
                texts = [code_samples.read(runner) for runner in runners if runner]
                if sample.name:
                    self.assertTrue(any(f'"{sample.name}"' in text for text in texts), f"none of {runners} runs {sample.name}")
                if sample.language == "expressions":
                    self.assertIn(f'"{sample.page}"', texts[0])

    def test_shell_samples(self):
        samples = of_language("sh")
        self.assertGreater(len(samples), 15)
        for sample in samples:
            with self.subTest(place(sample)):
                parsed = subprocess.run(["bash", "-n"], input=sample.text, stderr=subprocess.PIPE, text=True, check=False)
                self.assertEqual((parsed.returncode, parsed.stderr), (0, ""))
                for line in sample.text.replace("\\\n", " ").splitlines():
                    self.assertIsNone(documented_commands.fault(line), line)

    def test_commands_in_the_text(self):
        commands = [(page, line, code) for page, line, code in code_samples.spans() if COMMAND.match(code) and "..." not in code]
        self.assertGreater(len(commands), 100)
        for page, line, code in commands:
            with self.subTest(f"{page}:{line}"):
                # A word alone is the name of a program, not a call without arguments.
                check = documented_commands.fault if " " in code else documented_commands.missing_program
                self.assertIsNone(check(code), code)

    def test_files_in_the_text(self):
        paths = [(page, line, code) for page, line, code in code_samples.spans() if PATH.match(code) and code not in BUILT_FILES]
        self.assertGreater(len(paths), 100)
        for page, line, code in paths:
            with self.subTest(f"{page}:{line}"):
                self.assertIsNone(documented_commands.missing_file(code), code)

    def test_wrong_commands_are_found(self):
        for command in WRONG_COMMANDS:
            self.assertIsNotNone(documented_commands.fault(command), command)

    def test_json_samples(self):
        samples = of_language("json")
        self.assertEqual(len(samples), 1)
        case = json.loads(samples[0].text)["cases"][0]
        self.assertEqual([len(case[key]) for key in ("from", "to", "result")], [12, 12, 12])
        # x of the origin is the fourth number.
        self.assertEqual(case["from"][3] + case["weight"] * (case["to"][3] - case["from"][3]), case["result"][3])

    def test_cpp_samples(self):
        objects = glob.glob(os.path.join(checkout.variant(), "src", "cga", "**", "*.os"), recursive=True)
        self.assertTrue(objects, "the library is not built")
        samples = of_language("cpp")
        self.assertEqual(len(samples), 1)
        for sample in samples:
            with self.subTest(place(sample)), tempfile.TemporaryDirectory() as folder:
                source, program = os.path.join(folder, "sample.cpp"), os.path.join(folder, "sample")
                with open(source, "w", encoding="utf-8") as file:
                    file.write(SURROUNDINGS[sample.page].format(sample=sample.text))
                command = [os.environ.get("CXX", "g++"), "-std=c++17", "-I" + os.path.join(checkout.ROOT, "src"), source, *objects]
                compiled = subprocess.run([*command, "-o", program], stderr=subprocess.PIPE, text=True, check=False)
                self.assertEqual(compiled.returncode, 0, compiled.stderr)
                self.assertEqual(subprocess.run([program], check=False).returncode, 0)


if __name__ == "__main__":
    unittest.main()
