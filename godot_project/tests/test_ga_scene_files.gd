extends "res://tests/framework/test_case.gd"
## GAScene: saving and loading as JSON, as a resource and inside a scene; undo by loading.

const PATH := "user://test_ga_scene.tres"
const SCENE_PATH := "user://test_ga_scene.tscn"

var _scene := GAScene.new()
var _changes: Array[PackedStringArray] = []


func _init() -> void:
	_scene.add_entry("größe", "2.5")
	_scene.add_entry("ball", "sphere(e1, größe)")
	_scene.add_entry("broken", '1 + "\n\t')
	_scene.set_entry_attribute("ball", "color", "#ff8000")
	_scene.set_entry_attribute("ball", "visible", false)
	_scene.set_entry_attribute("ball", "interpolation/weight", 0.25)
	_scene.set_scene_attribute("title", 'A "ball"')
	_scene.entries_changed.connect(_on_entries_changed)


func test_json_round_trip() -> void:
	var other := GAScene.new()
	expect_equal(other.load_json(_scene.to_json()), OK, "loading")
	_expect_same(other)
	expect_equal(other.get_load_errors(), PackedStringArray(), "errors")


func test_a_resource_file() -> void:
	expect_equal(ResourceSaver.save(_scene, PATH), OK, "saving")
	var loaded: GAScene = ResourceLoader.load(PATH, "", ResourceLoader.CACHE_MODE_IGNORE)
	_expect_same(loaded)
	DirAccess.remove_absolute(PATH)


func test_inside_a_scene_file() -> void:
	var node := Node.new()
	node.set_meta("scene", _scene)
	var packed := PackedScene.new()
	packed.pack(node)
	node.free()
	expect_equal(ResourceSaver.save(packed, SCENE_PATH), OK, "saving")
	var loaded: PackedScene = ResourceLoader.load(SCENE_PATH, "", ResourceLoader.CACHE_MODE_IGNORE)
	var copy := loaded.instantiate()
	_expect_same(copy.get_meta("scene") as GAScene)
	copy.free()
	DirAccess.remove_absolute(SCENE_PATH)


func test_a_duplicate_is_independent() -> void:
	var copy: GAScene = _scene.duplicate()
	_expect_same(copy)
	copy.set_expression("größe", "3")
	expect_equal(_scene.get_expression("größe"), "2.5", "expression of the first")
	expect_equal(_changes.size(), 0, "number of signals of the first")


func test_an_empty_scene_stores_nothing() -> void:
	expect_equal(GAScene.new().document, "", "document")
	_scene.document = ""
	expect_equal(_scene.get_entry_count(), 0, "number of entries")
	expect_equal(
		_changes,
		[PackedStringArray(["ball", "broken", "größe"])] as Array[PackedStringArray],
		"changes"
	)


func test_loading_an_older_text_undoes() -> void:
	var before := _scene.to_json()
	_scene.rename_entry("größe", "size")
	_scene.remove_entry("broken")
	_changes.clear()
	expect_equal(_scene.load_json(before), OK, "loading")
	expect_equal(_scene.to_json(), before, "text")
	var changed := Array(_changes[0])
	changed.sort()
	expect_equal(changed, ["broken", "größe", "size"], "changes")


func test_a_broken_text_loads_what_it_can() -> void:
	var text := (
		'{"version": 1, "entries": [\n{"name": "a", "expression": "1"},\n'
		+ '{"name": "b", "expression": },\n{"name": "c", "expression": "a + 1"}\n]}'
	)
	var place := "line 3, column 29: entry 'b' skipped: expected a string in double quotes, found '}'"
	expect_error(
		"GAScene.load_json: parts of the text could not be read; the rest was loaded:\n%s." % place
	)
	expect_equal(_scene.load_json(text), ERR_FILE_CORRUPT, "loading")
	expect_equal(_scene.get_names(), PackedStringArray(["a", "c"]), "names")
	expect_equal(_scene.get_value("c").coefficients[0], 2.0, "c")
	expect_equal(_scene.get_load_errors(), PackedStringArray([place]), "errors")


func test_a_text_that_is_not_a_scene_changes_nothing() -> void:
	var before := _scene.to_json()
	expect_error(
		(
			"GAScene.load_json: the text was not loaded; the scene is unchanged:\n"
			+ "column 1: expected '{' before a document or '[' before 32 coefficients, found 'h'."
		)
	)
	expect_equal(_scene.load_json("hello"), ERR_PARSE_ERROR, "loading")
	expect_equal(_scene.to_json(), before, "text")


func test_the_bytes_of_a_file() -> void:
	var text := '{"entries": [{"name": "a", "expression": "1"}, {"name": "b", "expression": "2'
	var bytes := (text + '"}]}').to_utf8_buffer()
	expect_equal(_scene.load_json_utf8(bytes), OK, "loading")
	expect_equal(_scene.get_names(), PackedStringArray(["a", "b"]), "names")
	var marked := PackedByteArray([0xef, 0xbb, 0xbf]) + bytes
	expect_equal(GAScene.new().load_json_utf8(marked), OK, "loading with a byte order mark")
	# The engine's own conversion would print one error for each invalid byte.
	var invalid := PackedByteArray()
	invalid.resize(1000000)
	invalid.fill(0xff)
	var damaged := text.to_utf8_buffer() + invalid
	var place := "column 78: entry 'b' skipped: expected a character or '\"', found the byte 0xff"
	expect_error(
		(
			"GAScene.load_json_utf8: parts of the text could not be read; the rest was loaded:\n%s."
			% place
		)
	)
	expect_equal(_scene.load_json_utf8(damaged), ERR_FILE_CORRUPT, "loading with invalid UTF-8")
	expect_equal(_scene.get_names(), PackedStringArray(["a"]), "names")
	expect_equal(_scene.get_load_errors(), PackedStringArray([place]), "errors")


func test_a_document_beyond_the_limits_changes_nothing() -> void:
	var before := _scene.to_json()
	var note := '{"attributes": {"note": "%s"}, "entries": []}' % "x".repeat(16777216)
	var reasons: Dictionary[String, String] = {
		note:
		(
			"the document is too long: it has %d characters, and at most 16777216 bytes are accepted"
			% note.length()
		),
		# As UTF-8 it is longer than in characters.
		'{"attributes": {"note": "%s"}, "entries": []}' % "ä".repeat(9000000):
		(
			"column 1: the document is too long: it has 18000043 bytes, and at most 16777216 are"
			+ " accepted"
		),
		'{"entries": [%s]}' % ",".join(_products(525)):
		(
			(
				"the expressions of the document would take at least %d operations (a product is one,"
				+ " a call 12 or more), and at most 4194304 are accepted"
			)
			% (525 * 8000)
		),
	}
	for text in reasons:
		expect_error(
			(
				"GAScene.load_json: the text was not loaded; the scene is unchanged:\n%s."
				% reasons[text]
			)
		)
		expect_equal(_scene.load_json(text), ERR_PARSE_ERROR, "loading")
		expect_equal(_scene.get_load_errors(), PackedStringArray([reasons[text]]), "errors")
		expect_equal(_scene.to_json(), before, "text")
		expect_equal(_changes, [], "changes")


func test_multivectors_of_ganja_are_pasted() -> void:
	var array := Multivector.sphere(Vector3.RIGHT, 2.0).to_json()
	expect_equal(_scene.load_json(array), OK, "loading an array")
	expect_equal(_scene.get_description("x1"), "sphere, radius 2, center (1, 0, 0)", "description")
	expect_equal(_scene.add_entry("pasted", array), OK, "pasting an array")
	expect_equal(
		_scene.get_value("pasted").coefficients, _scene.get_value("x1").coefficients, "coefficients"
	)


func test_attributes() -> void:
	expect_equal(_scene.get_entry_attribute("ball", "visible"), false, "visible")
	expect_equal(_scene.get_entry_attribute("ball", "ipns"), false, "ipns")
	expect_equal(
		_scene.get_entry_attributes("ball"),
		{"color": "#ff8000", "interpolation/weight": 0.25, "visible": false},
		"attributes"
	)
	expect_equal(_scene.set_entry_attribute("ball", "color", null), OK, "resetting the color")
	expect_equal(_scene.get_entry_attribute("ball", "color"), "", "color")
	expect_error(
		"GAScene.set_entry_attribute: the attribute 'color' must have the form #rrggbb or #rrggbbaa."
	)
	expect_equal(
		_scene.set_entry_attribute("ball", "color", "red"), ERR_INVALID_PARAMETER, "a color by name"
	)
	expect_error(
		(
			'GAScene.set_entry_attribute: the attribute "color" must be a bool, a number, a string, '
			+ "a Color, or null to reset it, not Vector3."
		)
	)
	expect_equal(
		_scene.set_entry_attribute("ball", "color", Vector3.ONE), ERR_INVALID_PARAMETER, "a vector"
	)
	expect_equal(_scene.set_entry_attribute("ball", "color", Color.RED), OK, "a Color")
	expect_equal(_scene.get_entry_attribute("ball", "color"), "#ff0000", "color")
	_scene.set_entry_attribute("ball", "color", Color(2.0, -1.0, NAN, 0.5))
	expect_equal(_scene.get_entry_attribute("ball", "color"), "#ff000080", "color")
	expect_error("GAScene.set_entry_attribute: there is no entry 'x'.")
	expect_equal(
		_scene.set_entry_attribute("x", "visible", true), ERR_INVALID_PARAMETER, "an unknown entry"
	)


func test_the_inspector_shows_no_text() -> void:
	for property in _scene.get_property_list():
		if property["name"] == "document":
			expect_equal(property["usage"], PROPERTY_USAGE_STORAGE, "usage")


func _expect_same(other: GAScene) -> void:
	expect_equal(other.to_json(), _scene.to_json(), "text")
	expect_equal(other.get_names(), _scene.get_names(), "names")
	expect_equal(
		other.get_value("ball").coefficients, _scene.get_value("ball").coefficients, "coefficients"
	)
	expect_equal(other.get_error("broken"), _scene.get_error("broken"), "error")
	expect_equal(
		other.get_entry_attributes("ball"), _scene.get_entry_attributes("ball"), "attributes"
	)
	expect_equal(other.get_scene_attribute("title"), 'A "ball"', "title")


func _on_entries_changed(names: PackedStringArray) -> void:
	_changes.append(names)


# Entries of 8000 products each.
func _products(count: int) -> PackedStringArray:
	var entries := PackedStringArray()
	for index in count:
		entries.append('{"name": "p%d", "expression": "%s1"}' % [index, "2*".repeat(8000)])
	return entries
