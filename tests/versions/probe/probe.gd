@tool
extends EditorPlugin
## Uses the dock of GA-Godot where the editor has no EditorDock, and prints what happened after
## [probe].

const FRAMES := 20

var _frames := 0


func _process(_delta: float) -> void:
	_frames += 1
	if _frames == FRAMES:
		for plugin in get_parent().find_children("*", "EditorPlugin", false, false):
			var script := plugin.get_script() as Script
			if script != null and script.resource_path.ends_with("ga_godot/plugin.gd"):
				(plugin as EditorPlugin)._edit(ClassDB.instantiate(&"GAScene") as Object)
	elif _frames == 2 * FRAMES:
		print("[probe] dock visible: ", _dock().is_visible_in_tree())
		for panel in _foldable():
			panel.call(&"expand")
		var menu: Node = _dock().find_child("File", true, false)
		menu.call(&"_ask_for_file", FileDialog.FILE_MODE_OPEN_FILE)
	elif _frames == 3 * FRAMES:
		for panel in _foldable():
			print("[probe] %s unfolded: %s" % [panel.name, panel.size.y > 100.0])
		EditorInterface.set_plugin_enabled("ga_godot", false)
		print("[probe] dock removed: ", _dock() == null)
		get_tree().quit()


func _dock() -> Control:
	return EditorInterface.get_base_control().find_child("GA Playground", true, false)


func _foldable() -> Array[Control]:
	var found: Array[Control] = []
	for title: String in ["Coefficients", "Interpolation"]:
		found.append(_dock().find_child(title, true, false))
	return found
