extends "res://tests/framework/test_case.gd"
## The code samples of the README and the guides compile, run, and what they say holds.

const CodeSample := preload("res://tests/framework/code_sample.gd")
const Gallery := preload("res://addons/ga_godot/playground/document/gallery.gd")

const FENCE := "```gdscript\n"


func test_the_interpolation_guide() -> void:
	_expect_no_faults(_samples("docs/guides/interpolation.md"), 4)


func test_the_expressions_guide() -> void:
	_expect_no_faults(_samples("docs/guides/expressions.md"), 1)


func test_the_playground_guide() -> void:
	_expect_no_faults(_samples("docs/guides/playground.md"), 1)
	# Every example is in it, with its picture.
	for example in Gallery.list():
		var path := _repository().path_join("docs/images/gallery/%s.png" % example)
		expect_true(
			FileAccess.file_exists(path),
			"existence of %s; tests/screenshots/run.py --docs writes it" % path
		)
		expect_true(
			_read("docs/guides/playground.md").contains("images/gallery/%s.png" % example),
			"%s in the guide" % example
		)
		expect_true(
			_read("docs/guides/playground.md").contains("**%s**" % Gallery.EXAMPLES[example]),
			"the title of %s in the guide" % example
		)


func test_the_readme() -> void:
	# The first sample names what a project has.
	_expect_no_faults(_samples("README.md").slice(1), 1)


func _expect_no_faults(samples: PackedStringArray, count: int) -> void:
	expect_equal(samples.size(), count, "number of samples")
	for sample in samples:
		expect_equal(CodeSample.find_faults(sample), PackedStringArray(), "faults")


func _samples(page: String) -> PackedStringArray:
	var text := _read(page)
	expect_true(not text.is_empty(), "text in %s" % page)
	var samples := PackedStringArray()
	for part in text.split(FENCE).slice(1):
		samples.append(part.get_slice("```", 0))
	return samples


func _read(page: String) -> String:
	return FileAccess.get_file_as_string(_repository().path_join(page))


func _repository() -> String:
	return ProjectSettings.globalize_path("res://").trim_suffix("/").get_base_dir()
