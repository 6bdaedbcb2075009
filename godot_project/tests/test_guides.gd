extends "res://tests/framework/test_case.gd"
## The code samples of the README and the guides compile, run, and what they say holds.

const CodeSample := preload("res://tests/framework/code_sample.gd")

const FENCE := "```gdscript\n"


func test_the_interpolation_guide() -> void:
	_expect_no_faults(_samples("docs/guides/interpolation.md"), 4)


func test_the_expressions_guide() -> void:
	_expect_no_faults(_samples("docs/guides/expressions.md"), 1)


func test_the_readme() -> void:
	# The first sample names what a project has.
	_expect_no_faults(_samples("README.md").slice(1), 1)


func _expect_no_faults(samples: PackedStringArray, count: int) -> void:
	expect_equal(samples.size(), count, "number of samples")
	for sample in samples:
		expect_equal(CodeSample.find_faults(sample), PackedStringArray(), "faults")


func _samples(page: String) -> PackedStringArray:
	var repository := ProjectSettings.globalize_path("res://").trim_suffix("/").get_base_dir()
	var text := FileAccess.get_file_as_string(repository.path_join(page))
	expect_true(not text.is_empty(), "text in %s" % page)
	var samples := PackedStringArray()
	for part in text.split(FENCE).slice(1):
		samples.append(part.get_slice("```", 0))
	return samples
