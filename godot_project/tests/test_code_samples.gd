extends "res://tests/framework/test_case.gd"
## Every GDScript sample of every page and of the class help compiles, runs to its end, and prints
## what its comments say. Samples with a file name are run by the tests of their pages; the test
## tests/tools/test_code_samples.py finds samples that no test runs.

const ClassReference := preload("res://tests/framework/class_reference.gd")
const CodeSample := preload("res://tests/framework/code_sample.gd")
const Gallery := preload("res://addons/ga_godot/playground/document/gallery.gd")

const PLAYGROUND := "docs/guides/playground.md"


func test_pages() -> void:
	var files := DirAccess.get_files_at("user://")
	var pages := CodeSample.find_pages()
	expect_true(pages.has("docs/guides/interpolation.md"), "the interpolation guide is found")
	expect_true(pages.has("godot_project/addons/ga_godot/README.md"), "the addon's README is found")
	var count := 0
	for page in pages:
		for sample in CodeSample.samples_of_page(CodeSample.read_page(page)):
			count += 1
			_expect_no_faults(sample, page)
	expect_true(count >= 11, "%d samples on pages" % count)
	for file in DirAccess.get_files_at("user://"):
		if not files.has(file):
			DirAccess.remove_absolute("user://".path_join(file))


func test_class_help() -> void:
	var count := 0
	for file in DirAccess.get_files_at(ClassReference.folder()):
		var type := file.get_basename()
		var reference := ClassReference.new(type)
		expect_equal(reference.error, OK, "reading the help of %s" % type)
		var found := 0
		for title in reference.descriptions:
			for sample in reference.samples_of(title):
				count += 1
				found += 1
				expect_true(
					CodeSample.count_prints(sample) > 0,
					"a checked print() in the sample of %s.%s" % [type, title]
				)
				_expect_no_faults(sample, "%s.%s" % [type, title])
		expect_equal(
			found, reference.sample_count, "samples of %s that belong to a description" % type
		)
	expect_true(count > 110, "%d samples in the class help" % count)


func test_the_playground_guide_shows_every_example() -> void:
	var text := CodeSample.read_page(PLAYGROUND)
	for example in Gallery.list():
		var path := CodeSample.repository().path_join("docs/images/gallery/%s.png" % example)
		expect_true(
			FileAccess.file_exists(path),
			"%s exists (write it with tests/screenshots/run.py --docs)" % path
		)
		expect_true(
			text.contains("images/gallery/%s.png" % example),
			"the guide shows the picture of %s" % example
		)
		expect_true(
			text.contains("**%s**" % Gallery.EXAMPLES[example]),
			"the guide has the title of %s" % example
		)


func _expect_no_faults(sample: String, place: String) -> void:
	var parent := Node3D.new()
	parent.name = "Samples"
	add_node(parent)
	expect_equal(
		CodeSample.find_faults(sample, parent), PackedStringArray(), "faults in %s" % place
	)
	parent.free()
