extends "res://tests/framework/test_case.gd"
## The installed addon: its files, its classes and their icons.

const FOLDER := "res://addons/ga_godot"
const CLASSES: Dictionary[StringName, StringName] = {
	&"Multivector": &"Resource",
	&"MultivectorLerp": &"Node",
	&"MotorPool": &"RefCounted",
	&"MotorCodec": &"RefCounted",
	&"MotorSender": &"RefCounted",
	&"MotorReceiver": &"RefCounted",
	&"MotorSynchronizer": &"Node",
}


func test_classes_are_registered() -> void:
	for type: StringName in CLASSES:
		expect_true(ClassDB.class_exists(type), "registration of %s" % type)
		expect_equal(ClassDB.get_parent_class(type), CLASSES[type], "parent of %s" % type)
		expect_true(ClassDB.can_instantiate(type), "instantiation of %s" % type)


func test_the_script_of_the_plugin_file_exists() -> void:
	var plugin := ConfigFile.new()
	expect_equal(plugin.load(FOLDER.path_join("plugin.cfg")), OK, "loading plugin.cfg")
	expect_equal(plugin.get_value("plugin", "name"), "GA-Godot")
	var script: String = plugin.get_value("plugin", "script")
	expect_true(FileAccess.file_exists(FOLDER.path_join(script)), "existence of %s" % script)


func test_the_project_enables_the_plugin() -> void:
	var enabled: PackedStringArray = ProjectSettings.get_setting("editor_plugins/enabled")
	expect_true(enabled.has(FOLDER.path_join("plugin.cfg")), "the plugin is enabled")


func test_the_extension_file() -> void:
	var description := _load_description()
	expect_equal(description.get_value("configuration", "entry_symbol"), "ga_godot_init")
	expect_equal(description.get_value("configuration", "compatibility_minimum"), "4.4")
	expect_equal(description.get_value("configuration", "reloadable"), false)
	expect_true(
		description.get_section_keys("libraries").has("linux.debug.x86_64"), "an entry for Linux"
	)


func test_every_class_has_an_icon() -> void:
	var description := _load_description()
	for type: StringName in CLASSES:
		var path := _absolute(description, "icons", type)
		var image := Image.new()
		expect_equal(
			image.load_svg_from_string(FileAccess.get_file_as_string(path)), OK, "drawing %s" % path
		)
		expect_equal(image.get_size(), Vector2i(16, 16), "size of %s" % path)
		expect_true(not image.is_invisible(), "a visible pixel in %s" % path)


func test_the_loaded_library_is_the_listed_one() -> void:
	var path := _absolute(
		_load_description(), "libraries", "linux.debug.%s" % Engine.get_architecture_name()
	)
	expect_true(FileAccess.file_exists(path), "existence of %s" % path)
	expect_true(
		GDExtensionManager.is_extension_loaded(FOLDER.path_join("ga_godot.gdextension")),
		"the extension is loaded"
	)


## Each method is called in a test file; for setters and getters, the property is used.
func test_every_method_is_tested() -> void:
	var tests := ""
	for file in DirAccess.get_files_at("res://tests"):
		if file.ends_with(".gd"):
			tests += FileAccess.get_file_as_string("res://tests".path_join(file))
	for type: StringName in CLASSES:
		var methods := ClassDB.class_get_method_list(type, true)
		expect_true(methods.size() >= 6, "a list of methods of %s" % type)
		var calls := _calls_of_methods(type)
		for call_text in calls:
			expect_true(tests.contains(call_text), "use of %s%s in a test" % [type, call_text])


## How a script uses each method: `.name(`, or `.property` for a setter or getter.
func _calls_of_methods(type: StringName) -> PackedStringArray:
	var accessors: Dictionary[String, String] = {}
	for property in ClassDB.class_get_property_list(type, true):
		var property_name: String = property["name"]
		accessors[ClassDB.class_get_property_getter(type, property_name)] = ".%s" % property_name
		accessors[ClassDB.class_get_property_setter(type, property_name)] = ".%s" % property_name
	var calls := PackedStringArray()
	for method in ClassDB.class_get_method_list(type, true):
		var method_name: String = method["name"]
		if not method_name.begins_with("_"):
			var word: String = accessors.get(method_name, ".%s(" % method_name)
			calls.append(word)
	return calls


func _load_description() -> ConfigFile:
	var description := ConfigFile.new()
	expect_equal(
		description.load(FOLDER.path_join("ga_godot.gdextension")), OK, "loading the extension file"
	)
	return description


func _absolute(description: ConfigFile, section: String, key: String) -> String:
	var path: String = description.get_value(section, key, "")
	return path if path.begins_with("res://") else FOLDER.path_join(path)
