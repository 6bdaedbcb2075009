@tool
extends RefCounted
## Saves the document of the dock, including unsaved changes, in the project settings folder of the
## editor, and restores it when the editor starts.

const PlaygroundDocument := preload("../playground/document/playground_document.gd")

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
	file.save(_get_path())


static func restore(document: PlaygroundDocument) -> void:
	var file := ConfigFile.new()
	if file.load(_get_path()) != OK:
		return
	var path: String = file.get_value(SECTION, "path", "")
	var scene := GAScene.new()
	if path.get_extension() == "json" and FileAccess.file_exists(path):
		scene.load_json(FileAccess.get_file_as_string(path))
	elif ResourceLoader.exists(path):
		scene = ResourceLoader.load(path) as GAScene
	else:
		path = ""
	if scene == null:
		return
	document.show_scene(scene, path)
	if file.has_section_key(SECTION, "document"):
		scene.document = file.get_value(SECTION, "document")


static func _get_path() -> String:
	return EditorInterface.get_editor_paths().get_project_settings_dir().path_join(FILE)
