@tool
extends RefCounted
## Saves the document of the dock, including unsaved changes, in the project settings folder of the
## editor, and restores it when the editor starts.

const PlaygroundDocument := preload("../playground/document/playground_document.gd")
const SafeFile := preload("../playground/document/safe_file.gd")
const SceneFile := preload("../playground/document/scene_file.gd")

const FILE := "ga_playground.cfg"
const SECTION := "session"


static func save(document: PlaygroundDocument) -> void:
	# An embedded scene opens with its .tscn, so the previously saved session is kept.
	if document.is_embedded():
		return
	var file := ConfigFile.new()
	file.set_value(SECTION, "path", document.path)
	if document.path.is_empty() or document.is_unsaved():
		file.set_value(SECTION, "document", document.scene.document)
	var outcome := SafeFile.save_config(_get_path(), file)
	if outcome != OK:
		push_warning("GA-Godot: %s cannot be saved: %s." % [_get_path(), error_string(outcome)])


static func restore(document: PlaygroundDocument) -> void:
	var file := ConfigFile.new()
	if file.load(_get_path()) != OK:
		return
	var path: String = file.get_value(SECTION, "path", "")
	var scene := GAScene.new()
	if path.get_extension() == "json" and FileAccess.file_exists(path):
		var failure := SceneFile.load_json(path, scene)
		if not failure.is_empty():
			push_warning("GA-Godot: " + failure)
			path = ""
	elif ResourceLoader.exists(path):
		scene = ResourceLoader.load(path) as GAScene
	else:
		path = ""
	if scene == null:
		scene = GAScene.new()
		path = ""
	# Saving must not overwrite what could not be read.
	if not scene.get_load_errors().is_empty():
		path = ""
	document.show_scene(scene, path)
	if file.has_section_key(SECTION, "document"):
		scene.document = file.get_value(SECTION, "document")


static func _get_path() -> String:
	return EditorInterface.get_editor_paths().get_project_settings_dir().path_join(FILE)
