@tool
extends EditorPlugin
## Disables and enables GA-Godot's plugin in the real editor, opens a scene that uses the addon,
## saves a picture and quits. Each step prints one line that starts with [probe]. The user argument
## --picture=FILE is the file of the picture.
##
## _process() runs the steps, as the editor cancels coroutines when it reloads a script.

const ADDON := "ga_godot"
const SCENE := "res://demos/interpolation/interpolation.tscn"
const NODE := ^"Lerp"
const STEPS: Array[StringName] = [
	&"_report_state",
	&"_switch_off",
	&"_report_off",
	&"_switch_on",
	&"_report_on",
	&"_open_scene",
	&"_edit_node",
	&"_save_picture",
	&"_end",
]
## Frames before each step, for docks and previews to settle.
const SETTLING_FRAMES := 30

var _frames := 0
var _step := 0


func _process(_delta: float) -> void:
	# An import has no editor to drive.
	if (
		DisplayServer.get_name() == "headless"
		or EditorInterface.get_resource_filesystem().is_scanning()
	):
		return
	_frames += 1
	if _frames > SETTLING_FRAMES and _step < STEPS.size():
		_frames = 0
		_step += 1
		call(STEPS[_step - 1])


func _report_state() -> void:
	_report("library %s" % ("loaded" if _is_library_loaded() else "missing"))
	_report("enabled %s" % EditorInterface.is_plugin_enabled(ADDON))


func _switch_off() -> void:
	EditorInterface.set_plugin_enabled(ADDON, false)


func _report_off() -> void:
	_report("off %s" % EditorInterface.is_plugin_enabled(ADDON))


func _switch_on() -> void:
	EditorInterface.set_plugin_enabled(ADDON, true)


func _report_on() -> void:
	_report("on %s" % EditorInterface.is_plugin_enabled(ADDON))


func _open_scene() -> void:
	if _is_library_loaded():
		EditorInterface.open_scene_from_path(SCENE)


func _edit_node() -> void:
	if not _is_library_loaded():
		return
	var root := EditorInterface.get_edited_scene_root()
	var node := root.get_node_or_null(NODE) if root != null else null
	if node == null:
		_report("scene without %s" % NODE)
		return
	EditorInterface.edit_node(node)
	EditorInterface.set_main_screen_editor("3D")
	_report("scene %s" % node.get_class())


func _save_picture() -> void:
	for argument in OS.get_cmdline_user_args():
		if argument.begins_with("--picture="):
			var picture := (
				EditorInterface.get_base_control().get_viewport().get_texture().get_image()
			)
			_report(
				"picture %s" % error_string(picture.save_png(argument.trim_prefix("--picture=")))
			)


func _end() -> void:
	_report("done")
	get_tree().quit()


func _is_library_loaded() -> bool:
	return ClassDB.class_exists(&"Multivector")


func _report(message: String) -> void:
	print("[probe] %s" % message)
