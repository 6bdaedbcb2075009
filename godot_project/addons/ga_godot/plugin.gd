@tool
extends EditorPlugin
## Adds the dock "GA Playground", and reports a missing library. The classes of GA-Godot
## come from the extension, which the engine loads with or without this plugin.
##
## This script must not name a class of the extension, as the library may be missing when a project
## is opened for the first time.

const EXTENSION_PATH := "res://addons/ga_godot/ga_godot.gdextension"
const ENTRY_CLASS := &"Multivector"
const SCENE_CLASS := "GAScene"
const DOCK_CLASS := &"EditorDock"
## Loaded once the classes of the extension exist.
const DOCK_SCRIPT := "res://addons/ga_godot/editor/playground_dock.gd"
const EXPORT_SCRIPT := "res://addons/ga_godot/editor/playground_export.gd"
const TOOL_SCRIPT := "res://addons/ga_godot/editor/viewport_tool.gd"

## An EditorDock if the engine has that class, from Godot 4.6.
var _dock: MarginContainer
var _export: EditorExportPlugin
## Shows the document of the dock in the 3D viewports.
var _tool: Node3D


func _enter_tree() -> void:
	if ClassDB.class_exists(ENTRY_CLASS):
		_open_dock()
		return
	# The files of a newly copied addon are imported after plugins are first enabled.
	var file_system := EditorInterface.get_resource_filesystem()
	if file_system.is_scanning():
		file_system.filesystem_changed.connect(_report_missing_library, CONNECT_ONE_SHOT)
	else:
		_report_missing_library()


func _exit_tree() -> void:
	if _export != null:
		remove_export_plugin(_export)
		_export = null
	if _tool != null:
		remove_child(_tool)
		_tool.free()
		_tool = null
	if _dock != null:
		_dock.call(&"save_session")
		if _dock.is_class(DOCK_CLASS):
			call(&"remove_dock", _dock)
		else:
			remove_control_from_docks(_dock)
		_dock.queue_free()
		_dock = null


func _handles(object: Object) -> bool:
	return _dock != null and object.is_class(SCENE_CLASS)


func _edit(object: Object) -> void:
	if object != null and _dock != null:
		_dock.call(&"show_scene", object)
		_show_dock()


func _forward_3d_gui_input(viewport_camera: Camera3D, event: InputEvent) -> int:
	return (
		_tool.call(&"forward_input", viewport_camera, event)
		if _tool != null
		else AFTER_GUI_INPUT_PASS
	)


func _forward_3d_force_draw_over_viewport(viewport_control: Control) -> void:
	if _tool != null:
		_tool.call(&"draw_over", viewport_control)


func _save_external_data() -> void:
	if _tool != null:
		_tool.call(&"save_document")


func _open_dock() -> void:
	var script: GDScript = load(DOCK_SCRIPT)
	var has_docks := ClassDB.class_exists(DOCK_CLASS)
	_dock = ClassDB.instantiate(DOCK_CLASS) if has_docks else MarginContainer.new()
	_dock.set_script(script)
	_dock.call(&"set_up", get_undo_redo())
	if has_docks:
		call(&"add_dock", _dock)
	else:
		add_control_to_dock(DOCK_SLOT_RIGHT_UL, _dock)
	scene_saved.connect(Callable(_dock, &"on_scene_saved"))
	scene_closed.connect(Callable(_dock, &"on_scene_closed"))
	var export_script: GDScript = load(EXPORT_SCRIPT)
	_export = export_script.new()
	add_export_plugin(_export)
	var tool_script: GDScript = load(TOOL_SCRIPT)
	_tool = tool_script.new()
	add_child(_tool)
	_tool.call(&"set_up", self, _dock)


func _show_dock() -> void:
	if _dock.is_class(DOCK_CLASS):
		_dock.call(&"make_visible")
		return
	var tab: Control = _dock
	while tab != null and not tab.get_parent() is TabContainer:
		tab = tab.get_parent_control()
	if tab != null:
		var tabs: TabContainer = tab.get_parent()
		tabs.current_tab = tabs.get_tab_idx_from_control(tab)


func _report_missing_library() -> void:
	if ClassDB.class_exists(ENTRY_CLASS):
		if _dock == null:
			_open_dock()
		return
	var message := "GA-Godot: %s" % _describe_error()
	push_warning(message)
	EditorInterface.get_editor_toaster().push_toast(message, EditorToaster.SEVERITY_WARNING)


## Returns why the library is not loaded, and what to do.
func _describe_error() -> String:
	var description := ConfigFile.new()
	if description.load(EXTENSION_PATH) != OK:
		return (
			"%s is missing. Copy the complete folder addons/ga_godot into the project."
			% EXTENSION_PATH
		)
	var system := "%s %s" % [OS.get_name(), Engine.get_architecture_name()]
	var library := _find_library(description)
	if library.is_empty():
		return (
			"this version has no library for %s. See the addon's README for supported systems."
			% system
		)
	if not FileAccess.file_exists(library):
		return (
			(
				"%s is missing. Build it with scons in GA-Godot's repository, or copy the addon from a"
				+ " release; then restart the editor."
			)
			% library
		)
	return (
		(
			"%s exists but was not loaded. Restart the editor; if that does not help, rebuild the"
			+ " library for %s."
		)
		% [library, system]
	)


## The path of the library for this system; empty if there is none.
func _find_library(description: ConfigFile) -> String:
	if not description.has_section("libraries"):
		return ""
	for key in description.get_section_keys("libraries"):
		var matches := true
		for feature in key.split("."):
			matches = matches and OS.has_feature(feature)
		if matches:
			var path: String = description.get_value("libraries", key)
			return (
				path
				if path.begins_with("res://")
				else EXTENSION_PATH.get_base_dir().path_join(path)
			)
	return ""
