extends "res://tests/framework/test_case.gd"
## The code samples of the guides compile, run, and their assertions hold.

const CodeSample := preload("res://tests/framework/code_sample.gd")

const GUIDES := "docs/guides"
const FENCE := "```gdscript\n"


func test_the_interpolation_guide() -> void:
	var samples := _samples("interpolation.md")
	expect_equal(samples.size(), 3, "number of samples")
	for sample in samples:
		expect_equal(CodeSample.find_faults(sample), PackedStringArray(), "faults")


func _samples(guide: String) -> PackedStringArray:
	var repository := ProjectSettings.globalize_path("res://").trim_suffix("/").get_base_dir()
	var text := FileAccess.get_file_as_string(repository.path_join(GUIDES).path_join(guide))
	expect_true(not text.is_empty(), "text in %s" % guide)
	var samples := PackedStringArray()
	for part in text.split(FENCE).slice(1):
		samples.append(part.get_slice("```", 0))
	return samples
