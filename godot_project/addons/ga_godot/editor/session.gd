@tool
extends RefCounted
## Saves the document of the dock, with unsaved changes, in the editor's settings of the project, so
## that it survives a restart.

const PlaygroundDocument := preload("../playground/document/playground_document.gd")

const FILE := "ga_playground.cfg"
const SECTION := "session"


static func save(document: PlaygroundDocument) -> void:
	# Embedded scenes are opened with their .tscn; the session before them stays.
	if document.is_embedded():
		return
	var file := ConfigFile.new()
	file.set_value(SECTION, "path", document.path)
	if document.path.is_empty() or document.is_unsaved():
		file.set_value(SECTION, "document", document.scene.document)
	file.save(_place())


static func restore(document: PlaygroundDocument) -> void:
	var file := ConfigFile.new()
	if file.load(_place()) != OK:
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


static func _place() -> String:
	return EditorInterface.get_editor_paths().get_project_settings_dir().path_join(FILE)
