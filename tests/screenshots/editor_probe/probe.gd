@tool
extends EditorPlugin
## Turns GA-Godot's plugin off and on in the real editor, opens a scene that uses the addon, takes a
## picture and ends the editor. Each step prints one line that begins with [probe].
##
## The picture's file is the user argument --picture=FILE.

const ADDON := "ga_godot"
const SCENE := "res://demos/interpolation/interpolation.tscn"
const NODE := ^"Lerp"
## Frames for docks and previews to settle after each step.
const SETTLING_FRAMES := 30


func _enter_tree() -> void:
	# An import has no editor to drive.
	if DisplayServer.get_name() != "headless":
		_run.call_deferred()


func _run() -> void:
	await _wait_for_files()
	_say("library %s" % ("loaded" if ClassDB.class_exists(&"Multivector") else "missing"))
	_say("enabled %s" % EditorInterface.is_plugin_enabled(ADDON))
	for enabled: bool in [false, true]:
		EditorInterface.set_plugin_enabled(ADDON, enabled)
		await _settle()
		_say("%s %s" % ["on" if enabled else "off", EditorInterface.is_plugin_enabled(ADDON)])
	if ClassDB.class_exists(&"Multivector"):
		await _open_scene()
	_save_picture()
	_say("done")
	get_tree().quit()


func _wait_for_files() -> void:
	while EditorInterface.get_resource_filesystem().is_scanning():
		await get_tree().process_frame
	await _settle()


func _open_scene() -> void:
	EditorInterface.open_scene_from_path(SCENE)
	await _settle()
	var root := EditorInterface.get_edited_scene_root()
	var node := root.get_node_or_null(NODE) if root != null else null
	if node == null:
		_say("scene without %s" % NODE)
		return
	EditorInterface.edit_node(node)
	EditorInterface.set_main_screen_editor("3D")
	await _settle()
	_say("scene %s" % node.get_class())


func _save_picture() -> void:
	for argument in OS.get_cmdline_user_args():
		if argument.begins_with("--picture="):
			var picture := EditorInterface.get_base_control().get_viewport().get_texture().get_image()
			_say("picture %s" % error_string(picture.save_png(argument.trim_prefix("--picture="))))


func _settle() -> void:
	for i in SETTLING_FRAMES:
		await get_tree().process_frame


func _say(words: String) -> void:
	print("[probe] %s" % words)
