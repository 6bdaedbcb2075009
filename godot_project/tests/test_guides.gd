extends "res://tests/framework/test_case.gd"
## The code samples of the guides compile, run, and their assertions hold.

const GUIDES := "docs/guides"
const FENCE := "```gdscript\n"


func test_the_interpolation_guide() -> void:
	var samples := _samples("interpolation.md")
	expect_equal(samples.size(), 3, "number of samples")
	for sample in samples:
		_run(sample)


func _samples(guide: String) -> PackedStringArray:
	var repository := ProjectSettings.globalize_path("res://").trim_suffix("/").get_base_dir()
	var text := FileAccess.get_file_as_string(repository.path_join(GUIDES).path_join(guide))
	expect_true(not text.is_empty(), "text in %s" % guide)
	var samples := PackedStringArray()
	for part in text.split(FENCE).slice(1):
		samples.append(part.get_slice("```", 0))
	return samples


## As the body of a function that returns 1 at its end; an assertion that fails ends it earlier.
func _run(sample: String) -> void:
	var script := GDScript.new()
	script.source_code = "extends RefCounted\n\n\nfunc run() -> int:\n%s\treturn 1\n" % sample.indent("\t")
	expect_equal(script.reload(), OK, "compiling:\n%s" % sample)
	var instance: RefCounted = script.new()
	expect_equal(instance.call(&"run"), 1, "result of:\n%s" % sample)
