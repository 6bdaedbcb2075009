extends Node
## The main scene: shows the menu, opens a demo or runs a task, depending on the arguments after
## `--`.
##
## --test, --test=NAME     runs the engine tests, or those whose file or method name contains NAME,
##                         or the one test whose file and method are "FILE METHOD"; several NAMEs
##                         are separated by commas
## --demo=NAME             opens a demo, which parses its own arguments
## --dump-poses=FILE       writes interpolated pose pairs for the oracle (tests/oracle)
## --gallery-pictures=DIR  renders the gallery's documents for the documentation
## --screenshots=DIR       compares screenshots with references, or updates them (--update)
##
## References no class of the extension, so that it can report a missing library.

const Demos := preload("res://menu/demos.gd")

const MENU_SCENE := "res://menu/menu.tscn"
const MISSING_SCENE := "res://menu/library_missing.tscn"
const ENTRY_CLASS := &"MultivectorLerp"

const TASK_SCRIPTS: Dictionary[String, String] = {
	"--test": "res://tests/framework/test_runner.gd",
	"--dump-poses": "res://tests/oracle/pose_dump.gd",
	"--gallery-pictures": "res://tests/pictures/gallery_pictures.gd",
	"--screenshots": "res://tests/pictures/picture_runner.gd",
}

## The arguments to parse, by default those after `--`. Set it before the node enters the tree.
var arguments := OS.get_cmdline_user_args()

var _shown: Node


func _ready() -> void:
	if not ClassDB.class_exists(ENTRY_CLASS):
		_report_missing_library()
		return
	for argument in arguments:
		var key: String = argument.get_slice("=", 0)
		var value: String = argument.substr(key.length() + 1)
		if TASK_SCRIPTS.has(key):
			_run_task(TASK_SCRIPTS[key], value)
			return
		if key == "--demo":
			open_demo(value)
			return
	open_menu()


## Esc returns from a demo to the menu, and quits from the menu.
func _unhandled_key_input(event: InputEvent) -> void:
	if not event.is_action_pressed(&"ui_cancel") or _shown == null:
		return
	get_viewport().set_input_as_handled()
	if _shown.scene_file_path in [MENU_SCENE, MISSING_SCENE]:
		get_tree().quit()
	else:
		open_menu()


## Replaces the current scene with the menu.
func open_menu() -> void:
	_show(MENU_SCENE)
	_shown.connect(&"demo_chosen", open_demo)


## Replaces the current scene with a demo. Quits with exit code 1 if there is no demo of that name.
func open_demo(demo_name: String) -> void:
	var demo := Demos.find(demo_name)
	if demo == null or not ResourceLoader.exists(demo.get_scene_path()):
		var known := PackedStringArray()
		for other in Demos.list():
			known.append(other.name)
		printerr(
			'There is no demo named "%s". Available demos: %s.' % [demo_name, ", ".join(known)]
		)
		get_tree().quit(1)
		return
	_show(demo.get_scene_path())


func _show(path: String) -> void:
	if _shown != null:
		remove_child(_shown)
		_shown.queue_free()
	var scene: PackedScene = load(path)
	_shown = scene.instantiate()
	add_child(_shown)


func _run_task(script_path: String, value: String) -> void:
	var script: GDScript = load(script_path)
	if script == null or not script.can_instantiate():
		printerr("%s does not compile." % script_path)
		get_tree().quit(1)
		return
	var task: Node = script.new()
	task.set(&"argument", value)
	add_child(task)


func _report_missing_library() -> void:
	var text := (
		"The GA-Godot library is not loaded. "
		+ "Build it by running scons in the repository, then restart."
	)
	printerr(text)
	if DisplayServer.get_name() == "headless" or not arguments.is_empty():
		get_tree().quit(1)
		return
	_show(MISSING_SCENE)
