extends "res://tests/framework/test_case.gd"
## The examples of the gallery load without errors and stay free of errors at every slider position
## and drag. test_gallery_facts.gd checks what they teach.

const Gallery := preload("res://addons/ga_godot/playground/document/gallery.gd")
const ExamplesMenu := preload("res://addons/ga_godot/playground/panel/examples_menu.gd")
const ViewPoint := preload("res://addons/ga_godot/playground/picture/view_point.gd")

const DRAGGED_KEYS: Array[String] = ["position", "center"]
const DRAGS: Array[Vector3] = [
	Vector3(0.4, 0.0, 0.0),
	Vector3(-1.3, 0.0, 0.0),
	Vector3(3.0, 0.0, -2.0),
	Vector3(0.0, -2.0, 0.0),
	Vector3(0.0, 1.5, 2.5),
	Vector3(-0.5, 0.3, 2.5),
	Vector3(-4.0, 0.0, 0.0),
	Vector3(40.0, 30.0, -20.0),
]
const SLIDER_STEPS := 16
## In the error of an entry that depends on another entry with an error.
const DEPENDS := "has an error"
## Errors that are expected after a drag, by example: constructions that may have no solution.
const EXPECTED_ERRORS: Dictionary[String, String] = {
	"apollonius": "sqrt: expected a number of at least 0, not -"
}


func test_the_list_matches_the_folder() -> void:
	var files := PackedStringArray()
	for file in DirAccess.get_files_at(Gallery.FOLDER):
		if file.get_extension() == "json":
			files.append(file.get_basename())
	var listed := Gallery.list()
	expect_true(listed.size() >= 12, "at least 12 examples, not %d" % listed.size())
	listed.sort()
	files.sort()
	expect_equal(listed, files, "examples")


func test_each_example_loads_without_errors() -> void:
	for example in Gallery.list():
		var scene := Gallery.load_example(example)
		expect_true(scene != null, "%s: %s" % [example, Gallery.error_of(example)])
		expect_equal(scene.get_load_errors(), PackedStringArray(), "load errors of %s" % example)
		for entry in scene.get_names():
			expect_equal(scene.get_error(entry), "", "error of %s in %s" % [entry, example])


func test_saving_an_example_gives_the_same_file() -> void:
	for example in Gallery.list():
		var text := FileAccess.get_file_as_string(Gallery.path_of(example))
		expect_equal(Gallery.load_example(example).to_json(), text, "text of %s" % example)


func test_each_example_has_title_text_camera_and_ranges() -> void:
	for example in Gallery.list():
		var scene := Gallery.load_example(example)
		expect_equal(
			scene.get_scene_attribute("title"), Gallery.EXAMPLES[example], "title of %s" % example
		)
		var description: String = scene.get_scene_attribute("description")
		var sentences := description.count(". ") + 1
		expect_true(sentences >= 2 and sentences <= 6, "%d sentences in %s" % [sentences, example])
		expect_true(
			description.ends_with("."), "the description of %s ends with a period" % example
		)
		expect_true(ViewPoint.is_stored_in(scene), "%s has a camera position" % example)
		for entry in scene.get_names():
			_expect_a_range(scene, entry, example)


func test_sliders_and_drags_cause_no_errors() -> void:
	for example in Gallery.list():
		var text := FileAccess.get_file_as_string(Gallery.path_of(example))
		var scene := Gallery.load_example(example)
		for entry in scene.get_names():
			if scene.get_entry_attribute(entry, "slider/min") != null:
				_sweep(scene, entry, example)
				scene.load_json(text)
			for key in DRAGGED_KEYS:
				_drag(scene, entry, key, example)
				scene.load_json(text)


func test_an_unsolvable_construction_shows_its_error() -> void:
	var scene := Gallery.load_example("apollonius")
	scene.set_parameter("b", "position", Vector3(-1.5, 0.0, 0.7))
	scene.set_parameter("radius_b", "value", 0.3)
	expect_true(
		scene.get_error("root_same").contains(EXPECTED_ERRORS["apollonius"]),
		"one circle inside another: %s" % scene.get_error("root_same")
	)
	expect_equal(scene.get_error("circle_a"), "", "the given circles keep their values")


func test_an_unknown_example() -> void:
	expect_null(Gallery.load_example("nothing"))
	expect_true(
		Gallery.error_of("nothing").contains('no example named "nothing"'),
		Gallery.error_of("nothing")
	)


func test_the_menu_opens_independent_copies() -> void:
	var menu := ExamplesMenu.new()
	add_node(menu)
	expect_equal(
		menu.item_count, Gallery.list().size() + Gallery.SECTIONS.size(), "items and sections"
	)
	for example in Gallery.SECTIONS:
		expect_true(Gallery.EXAMPLES.has(example), "%s, the first of a section, exists" % example)
	var chosen: Array[GAScene] = []
	menu.chosen.connect(
		func(scene: GAScene, title: String) -> void:
			chosen.append(scene)
			expect_equal(title, "Sphere through four points", "title")
	)
	for i in 2:
		menu.id_pressed.emit(1)
	expect_equal(chosen.size(), 2, "chosen")
	chosen[0].remove_entry("a")
	expect_true(chosen[1].has_entry("a"), "the second copy is unchanged")


func _expect_a_range(scene: GAScene, entry: String, example: String) -> void:
	var parameters := scene.get_parameters(entry)
	var minimum: Variant = scene.get_entry_attribute(entry, "slider/min")
	if not parameters.has("value"):
		expect_true(
			minimum == null, "%s in %s is not a number and has no slider range" % [entry, example]
		)
		return
	expect_true(minimum is float, "%s in %s has a slider range" % [entry, example])
	var value: float = parameters["value"]
	var maximum: float = scene.get_entry_attribute(entry, "slider/max")
	expect_true(
		minimum as float <= value and value <= maximum,
		"%s of %s is within its slider range" % [entry, example]
	)
	expect_true(
		scene.get_entry_attribute(entry, "slider/step") as float > 0.0,
		"slider step of %s in %s" % [entry, example]
	)


func _sweep(scene: GAScene, entry: String, example: String) -> void:
	var minimum: float = scene.get_entry_attribute(entry, "slider/min")
	var maximum: float = scene.get_entry_attribute(entry, "slider/max")
	for i in SLIDER_STEPS + 1:
		var value := lerpf(minimum, maximum, float(i) / SLIDER_STEPS)
		expect_equal(
			scene.set_parameter(entry, "value", value), OK, "setting %s of %s" % [entry, example]
		)
		_expect_no_errors(scene, example, "%s = %s" % [entry, value])


func _drag(scene: GAScene, entry: String, key: String, example: String) -> void:
	var parameters := scene.get_parameters(entry)
	if not parameters.has(key):
		return
	var start: Vector3 = parameters[key]
	for drag in DRAGS:
		expect_equal(
			scene.set_parameter(entry, key, start + drag),
			OK,
			"dragging %s of %s" % [entry, example]
		)
		_expect_no_errors(scene, example, "%s at %s" % [entry, start + drag])


func _expect_no_errors(scene: GAScene, example: String, change: String) -> void:
	for entry in scene.get_names():
		var error := scene.get_error(entry)
		if (
			error.is_empty()
			or error.contains(DEPENDS)
			or EXPECTED_ERRORS.has(example) and error.contains(EXPECTED_ERRORS[example])
		):
			continue
		fail("%s, %s: %s: %s" % [example, change, entry, error])
