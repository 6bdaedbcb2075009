extends "res://tests/framework/test_case.gd"
## The code samples of the README and the guides compile, run to their end, and print what their
## comments say.

const CodeSample := preload("res://tests/framework/code_sample.gd")
const Gallery := preload("res://addons/ga_godot/playground/document/gallery.gd")

const FENCE := "```gdscript\n"


func test_the_interpolation_guide() -> void:
	_expect_no_faults(_samples("docs/guides/interpolation.md"), 5)


func test_the_expressions_guide() -> void:
	_expect_no_faults(_samples("docs/guides/expressions.md"), 1)


func test_the_playground_guide() -> void:
	_expect_no_faults(_samples("docs/guides/playground.md"), 2)
	# The guide lists every example, with its picture and title.
	for example in Gallery.list():
		var path := _repository().path_join("docs/images/gallery/%s.png" % example)
		expect_true(
			FileAccess.file_exists(path),
			"%s exists (write it with tests/screenshots/run.py --docs)" % path
		)
		expect_true(
			_read("docs/guides/playground.md").contains("images/gallery/%s.png" % example),
			"the guide shows the picture of %s" % example
		)
		expect_true(
			_read("docs/guides/playground.md").contains("**%s**" % Gallery.EXAMPLES[example]),
			"the guide has the title of %s" % example
		)


func test_the_exporting_guide() -> void:
	_expect_no_faults(_samples("docs/guides/exporting.md"), 1)


func test_the_readme() -> void:
	_expect_no_faults(_samples("README.md"), 1)


func test_the_readme_of_the_addon() -> void:
	_expect_no_faults(_samples("godot_project/addons/ga_godot/README.md"), 1)


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
